"""The papers that the workbench brings: data and theorems."""

from pathlib import Path

from proofs.theorems.adjugate import adjugate_is_unique
from proofs.theorems.fields import (
    acceleration_field_is_affine,
    rigid_motions_are_a_group,
    unrolled_recurrence,
)
from workbench.papers import InstalledPaper

_CHAPTER = Path(__file__).parent / "chapter"

#: Higher-Order Kinematics in Dual Lie Algebra (D. Condurache, 2020), section by section.
chapter = InstalledPaper(
    files=(
        _CHAPTER / "02_rigid_motion.toml",
        _CHAPTER / "03_nth_order_fields.toml",
        _CHAPTER / "04_1_centres_and_adjugates.toml",
    ),
    theorems={
        "acceleration_field_is_affine": acceleration_field_is_affine,
        "unrolled_recurrence": unrolled_recurrence,
        "rigid_motions_are_a_group": rigid_motions_are_a_group,
        "adjugate_is_unique": adjugate_is_unique,
    },
)

"""The papers that the workbench brings: data and theorems."""

from pathlib import Path

from proofs.theorems.adjugate import adjugate_is_unique
from workbench.papers import InstalledPaper

_CHAPTER = Path(__file__).parent / "chapter"

#: Higher-Order Kinematics in Dual Lie Algebra (D. Condurache, 2020), section by section.
chapter = InstalledPaper(
    files=(
        _CHAPTER / "02_rigid_motion.toml",
        _CHAPTER / "04_1_centres_and_adjugates.toml",
    ),
    theorems={"adjugate_is_unique": adjugate_is_unique},
)

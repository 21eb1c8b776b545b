"""The papers that the workbench brings: data and theorems."""

from pathlib import Path

from proofs.theorems import (
    adjugate,
    aronhold_kennedy,
    chains,
    coefficients,
    determined,
    dual,
    dual_functions,
    fields,
    invariants,
    kinds_of_displacement,
    least_accelerations,
    lie_algebra,
    manipulators,
    polynomials,
    reduced,
    triangular,
    twist,
)
from workbench.papers import InstalledPaper

_CHAPTER = Path(__file__).parent / "chapter"
_TEXTS = Path(__file__).parent / "texts"

#: Higher-Order Kinematics in Dual Lie Algebra (D. Condurache, 2020), section by section.
chapter = InstalledPaper(
    files=(
        _CHAPTER / "02_rigid_motion.toml",
        _CHAPTER / "03_nth_order_fields.toml",
        _CHAPTER / "04_operator_polynomials.toml",
        _CHAPTER / "04_1_centres_and_adjugates.toml",
        _CHAPTER / "05_1_dual_numbers.toml",
        _CHAPTER / "05_2_dual_vectors_and_tensors.toml",
        _CHAPTER / "05_3_screws.toml",
        _CHAPTER / "05_4_isomorphism.toml",
        _CHAPTER / "06_1_dual_twist.toml",
        _CHAPTER / "06_2_reduced_accelerations.toml",
        _CHAPTER / "06_2_where_they_are_least.toml",
        _CHAPTER / "06_3_orders_by_107.toml",
        _CHAPTER / "06_4_orders_by_13.toml",
        _CHAPTER / "07_1_chains_and_lemma.toml",
        _CHAPTER / "07_2_derivatives_of_the_twist.toml",
        _CHAPTER / "08_2C_manipulator.toml",
    ),
    theorems={
        **fields.THEOREMS,
        **polynomials.THEOREMS,
        **coefficients.THEOREMS,
        **adjugate.THEOREMS,
        **dual.THEOREMS,
        **dual_functions.THEOREMS,
        **invariants.THEOREMS,
        **lie_algebra.THEOREMS,
        **kinds_of_displacement.THEOREMS,
        **twist.THEOREMS,
        **least_accelerations.THEOREMS,
        **reduced.THEOREMS,
        **triangular.THEOREMS,
        **determined.THEOREMS,
        **chains.THEOREMS,
        **aronhold_kennedy.THEOREMS,
        **manipulators.THEOREMS,
    },
)

#: Learn Multibody Dynamics (J. K. Moore): vectors, orientation, angular and translational kinematics.
vectors = InstalledPaper((_TEXTS / "learn-multibody-dynamics" / "vectors.toml",))
orientation = InstalledPaper((_TEXTS / "learn-multibody-dynamics" / "orientation.toml",))
angular = InstalledPaper((_TEXTS / "learn-multibody-dynamics" / "angular.toml",))
translational = InstalledPaper((_TEXTS / "learn-multibody-dynamics" / "translational.toml",))

#: Principia (R. Leroy and others): two notes on frames.
rotational_motion = InstalledPaper((_TEXTS / "principia" / "rotational_motion.toml",))
rotating_pulsating = InstalledPaper((_TEXTS / "principia" / "rotating_pulsating.toml",))

#: kindr: cheat sheet of rotations and their rates.
kindr = InstalledPaper((_TEXTS / "kindr" / "cheatsheet.toml",))

#: Notes on quaternions (R. Jia).
quaternions = InstalledPaper((_TEXTS / "quaternions" / "quaternion.toml",))

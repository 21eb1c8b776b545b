"""Section 5.3: Theorem 8, the freedom of the natural invariants, and the kinds of displacement."""

from __future__ import annotations

from proofs.theorems.dual import structure
from workbench.language.goals.proofs import (
    ByLength,
    Contradicts,
    Each,
    False_,
    Follows,
    Kernel,
    Part,
    Proven,
    Unique,
    Use,
)

_SCREW = r"\underline{\mathbf{R}}(\underline{\alpha}, \underline{\mathbf{u}})"
_SINE, _COSINE = Use(0), Use(0, part=1)
_FULL_TURN = Each(
    Follows(r"(\sin \underline{\alpha}) Z + (\cos \underline{\alpha}) Y", Y=_SINE, Z=_COSINE),
    Follows(r"(\cos \underline{\alpha}) Z - (\sin \underline{\alpha}) Y", Y=_SINE, Z=_COSINE),
)
_BY_LENGTH = ByLength(Follows("Y^2", Y=Use(0)))
_NOT_BOTH_PARTS_ARE_0 = Contradicts(1, Follows(r"Y + \varepsilon Z", Y=Use(0), Z=Use(-1)))
_BY_TRACE = Contradicts(0, Follows(r"1 - \frac{1}{2} (3 - Y)", Y=Use(-1)))

THEOREMS = {
    "freedom_of_the_natural_invariants": Proven(Each(Kernel(), _FULL_TURN, Kernel(), Kernel())),
    "pure_translations": Proven(
        Each(_BY_LENGTH, _BY_LENGTH, _NOT_BOTH_PARTS_ARE_0), against=Part(2, False_())
    ),
    "pure_rotations": Proven(Each(Kernel(), Kernel(), _NOT_BOTH_PARTS_ARE_0), against=Part(2, False_())),
    "screws_tell_displacements_apart": Proven(
        Each(Kernel(), Follows(r"w \cdot (Y - x)", Y=Use(0)), Kernel(), _BY_TRACE),
        against=Part(3, False_()),
    ),
    "structural_from_natural_invariants": Proven(
        Each(Unique({"Q": r"\mathbf{R}", "r": r"\boldsymbol{\rho}"}, only=structure(_SCREW).only), Kernel())
    ),
}

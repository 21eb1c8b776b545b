"""Section 5.3: Theorem 8, the freedom of the natural invariants, and the kinds of displacement."""

from __future__ import annotations

from proofs.theorems.dual import structure
from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    False_,
    Instance,
    Kernel,
    NegationIntroduction,
    Part,
    Proven,
    UniqueExists,
    ZeroFromSquare,
)

_SCREW = r"\underline{\mathbf{R}}(\underline{\alpha}, \underline{\mathbf{u}})"
_SINE, _COSINE = Instance(0), Instance(0, part=1)
_FULL_TURN = AndIntroduction(
    Congruence(r"(\sin \underline{\alpha}) Z + (\cos \underline{\alpha}) Y", Y=_SINE, Z=_COSINE),
    Congruence(r"(\cos \underline{\alpha}) Z - (\sin \underline{\alpha}) Y", Y=_SINE, Z=_COSINE),
)
_BY_LENGTH = ZeroFromSquare(Congruence("Y^2", Y=Instance(0)))
_NOT_BOTH_PARTS_ARE_0 = NegationIntroduction(
    1, Congruence(r"Y + \varepsilon Z", Y=Instance(0), Z=Instance(-1))
)
_BY_TRACE = NegationIntroduction(0, Congruence(r"1 - \frac{1}{2} (3 - Y)", Y=Instance(-1)))

THEOREMS = {
    "freedom_of_the_natural_invariants": Proven(AndIntroduction(Kernel(), _FULL_TURN, Kernel(), Kernel())),
    "pure_translations": Proven(
        AndIntroduction(_BY_LENGTH, _BY_LENGTH, _NOT_BOTH_PARTS_ARE_0), against=Part(2, False_())
    ),
    "pure_rotations": Proven(
        AndIntroduction(Kernel(), Kernel(), _NOT_BOTH_PARTS_ARE_0), against=Part(2, False_())
    ),
    "screws_tell_displacements_apart": Proven(
        AndIntroduction(Kernel(), Congruence(r"w \cdot (Y - x)", Y=Instance(0)), Kernel(), _BY_TRACE),
        against=Part(3, False_()),
    ),
    "structural_from_natural_invariants": Proven(
        AndIntroduction(
            UniqueExists({"Q": r"\mathbf{R}", "r": r"\boldsymbol{\rho}"}, only=structure(_SCREW).only),
            Kernel(),
        )
    ),
}

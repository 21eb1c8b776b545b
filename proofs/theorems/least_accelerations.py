"""Section 6: where the reduced accelerations are least (102), for every order at once, and plane motion.

w + ε m stands for ω̲⁽ⁿ⁾ at an instant, a(x) = m + w × x for the reduced acceleration of order n at x.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    At,
    Cases,
    Congruence,
    Cut,
    ExistsIntroduction,
    False_,
    IffIntroduction,
    Instance,
    Introductions,
    Kernel,
    Part,
    Proven,
    SumOfSquares,
    TwoWitnesses,
    UniqueExists,
    ZeroFromSquare,
)

# ‖m + w × x‖² = (w·m)²/w² + (w × (m + w × x))²/w², and the second square is 0 at x = w × m/w²
_A = r"(m + w \times x)"
_BOUND = SumOfSquares(rf"\frac{{w \times {_A}}}{{\|w\|}}")
_ON_THE_LINE = r"\operatorname{Du}(\frac{w + \varepsilon m}{|w + \varepsilon m|})"
_LOCUS = IffIntroduction(
    Cut(
        rf"w \times {_A} = \mathbf{{0}}",
        ZeroFromSquare(Congruence(r"w^2 Y - (w \cdot m)^2", Y=Instance(-1))),
        Congruence(rf"{_ON_THE_LINE} + \frac{{1}}{{w^2 \|w\|}} w \times Y", Y=Instance(-1)),
    ),
    Congruence(r"(m - \|w\| Y)^2", Y=Instance(-1)),
)
_ONE_LINE = UniqueExists(
    {"f": r"\frac{w \times m}{w^2}"},
    only=Congruence(r"\frac{1}{w^2} (w \times m + X w - Y)", X=Instance(-1), Y=Instance(-1, part=1)),
)
_EVERYWHERE = At(
    {"w": r"\mathbf{0}", "m": r"\mathbf{0}"},
    TwoWitnesses({"f": r"\mathbf{0}"}, {"f": r"\begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}"}),
)

#: Name in the claim files → proof.
THEOREMS = {
    "locus_of_the_least_reduced_acceleration": Proven(
        AndIntroduction(Kernel(), _BOUND, _LOCUS, _ONE_LINE), against=Part(3, _EVERYWHERE)
    ),
    "least_reduced_acceleration": Proven(
        AndIntroduction(
            Kernel(),
            _BOUND,
            ExistsIntroduction({"x": r"\frac{w \times m}{w^2}"}),
            Congruence(r"m + Y \times x", Y=Instance(0)),
        )
    ),
    "plane_motion": Proven(
        AndIntroduction(
            Introductions(
                Cases(
                    "s = 0", equal=Cut(r"n \times b = \mathbf{0}", Congruence("Y", Y=Instance(0)), Kernel())
                )
            ),
            Kernel(),
            Congruence(r"Y - Z n \times x", Y=Instance(0), Z=Instance(1)),
        ),
        against=Part(0, At({"s": "0"}, False_())),
    ),
}

"""Section 6: where the reduced accelerations are least (102), for every order at once, and plane motion.

w + ε m stands for ω̲⁽ⁿ⁾ at an instant, a(x) = m + w × x for the reduced acceleration of order n at x.
"""

from __future__ import annotations

from workbench.judge.theorems.arguments import Step, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.theorems.proofs import (
    At,
    Cases,
    Each,
    Follows,
    Given,
    Impossible,
    Kernel,
    Part,
    Proven,
    Squares,
    Use,
    Witness,
)
from workbench.judge.verdict import Counterexample, Verdict

_LETTERS = Letters(
    {name: {"kind": "vector"} for name in ("w", "m", "x", r"\rho", "y")}
    | {"k": {"kind": "scalar"}, r"\phi": {"kind": "scalar"}}
    | {"n": {"kind": "vector", "unit": True, "constant": True}, "c": {"kind": "vector", "constant": True}},
    {
        "a": r"m + w \times x",
        "W": r"w + \varepsilon m",
        "s": r"\frac{w \cdot m}{w^2}",
        "f": r"\frac{w \times m}{w^2}",
    },
)


def locus_of_the_least_reduced_acceleration() -> Verdict:
    """‖a(x)‖ is least exactly on the line of w + ε m, if w ≠ 0; else a(x) = m everywhere."""
    return argue(
        [
            *_decomposition(),
            _LETTERS.step(
                "a = s w with s = w·m/w² at the points f + k w of a line, f = w × m/w²",
                r"m + w \times (f + k w) = s w",
                but_not=r"m + w \times (k w) = s w",
            ),
            _LETTERS.step(
                "x = f + (w·x/w²) w − w × a/w²: where w × a = 0, x is on that line",
                r"x = f + \frac{w \cdot x}{w^2} w - \frac{w \times a}{w^2}",
                but_not=r"x = f + \frac{w \cdot x}{w^2} w",
            ),
            _LETTERS.step(
                "it is the line of w + ε m: the unit dual vector (w + ε m)/|w + ε m| has its direction and"
                " moment",
                r"\|w\| \operatorname{Re}(\frac{W}{|W|}) = w",
                r"\|w\| \operatorname{Du}(\frac{W}{|W|}) = f \times w",
                but_not=r"\|w\| \operatorname{Du}(\frac{W}{|W|}) = m",
            ),
            _uniform(),
        ],
        hypothesis=r"\omega^{(n)} \neq \mathbf{0}",
        counterexample=Counterexample(
            values={
                r"\omega^{(n)}": ("0", "0", "0"),
                r"\mathbf{v}^{(n)}": ("0", "0", "1"),
                r"\rho": ("1", "2", "3"),
            },
            left=("0", "0", "1"),
            right=("0", "0", "1"),
        ),
        reason="without rotation of that order every point of space is one of least reduced acceleration",
    )


def _decomposition() -> list[Step]:
    return [
        _LETTERS.step(
            "w² a² = (w·m)² + (w × a)²: the first part is the same at all points, the second a square",
            r"w^2 a^2 = (w \cdot m)^2 + (w \times a)^2",
            r"w \cdot a = w \cdot m",
            but_not=r"w^2 a^2 = (w \times a)^2",
        )
    ]


def _uniform() -> Step:
    return _LETTERS.step(
        "where w = 0, a = m everywhere, and |ε m| = ε ‖m‖ by the second case of (74)",
        r"m + (w - w) \times x = m",
        but_not=r"m + w \times x = m",
    )


#: Name in the claim files → proof.
THEOREMS = {
    "locus_of_the_least_reduced_acceleration": locus_of_the_least_reduced_acceleration,
    # ‖m + w × x‖² = (w·m)²/w² + (w × (m + w × x))²/w², and the second square is 0 at x = w × m/w²
    "least_reduced_acceleration": Proven(
        Each(
            Kernel(),
            Squares(r"\frac{w \times (m + w \times x)}{\|w\|}"),
            Witness({"x": r"\frac{w \times m}{w^2}"}),
            Follows(r"m + Y \times x", Y=Use(0)),
        )
    ),
    "plane_motion": Proven(
        Each(
            Given(
                Cases(
                    "s = 0",
                    equal=Witness({"x": r"\mathbf{0}"}, Follows("Y", Y=Use(0))),
                    unequal=Witness({"x": r"-\frac{1}{s} b"}),
                )
            ),
            Kernel(),
            Follows(r"Y - Z n \times x", Y=Use(0), Z=Use(1)),
        ),
        against=Part(0, At({"s": "0"}, Impossible(Follows("Y", Y=Use(-1)), so=r"n \times b = \mathbf{0}"))),
    ),
}

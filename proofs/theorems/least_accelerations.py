"""Section 6: where the reduced accelerations are least (102), for every order at once, and plane motion.

w + ε m stands for ω̲⁽ⁿ⁾ at an instant, a(x) = m + w × x for the reduced acceleration of order n at x.
"""

from __future__ import annotations

from workbench.judge.arguments import Step, argue
from workbench.judge.formula_steps import Letters
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


def least_reduced_acceleration() -> Verdict:
    """(102): min ‖a(x)‖ = |w·m|/‖w‖ = |Du |w + ε m||, and ‖m‖ where w = 0."""
    return argue(_least())


def least_reduced_jounce_as_printed() -> Verdict:
    """The last line of (102) with ω̲̈ where the least value is that of ω̲⃛."""
    return argue(
        [
            *_least(),
            _LETTERS.step(
                "with ω̲⃛ = n + ε n, n a unit vector, ‖H_ρ‖² is 1 and a square, whatever the lower"
                " derivatives are",
                r"(n + n \times x)^2 = 1 + (n \times x)^2",
                but_not=r"(n + n \times x)^2 = (n \times x)^2",
            ),
            _LETTERS.refutation(
                "so it is not 0, the printed value where ω̲̈ = 0",
                r"(n + n \times x)^2 - (n \times x)^2 = 0",
                but_not=r"(n + n \times x) \cdot (n \times x) = (n \times x)^2",
            ),
        ],
        refutes=True,
        counterexample=Counterexample(
            values={
                r"\omega": ("0", "0", "0"),
                r"\dot{\omega}": ("0", "0", "0"),
                r"\ddot{\omega}": ("0", "0", "0"),
                r"\dddot{\omega}": ("0", "0", "1"),
                r"\mathbf{v}": ("0", "0", "0"),
                r"\dot{\mathbf{v}}": ("0", "0", "0"),
                r"\ddot{\mathbf{v}}": ("0", "0", "0"),
                r"\dddot{\mathbf{v}}": ("0", "0", "1"),
            },
            left=("1",),
            right=("0",),
        ),
        reason="ω̲̈ may be 0 where ω̲⃛ = e₃ + ε e₃, and then ‖H_ρ‖ is at least 1 everywhere",
    )


def plane_motion() -> Verdict:
    """ω = φ n with a constant n and v across n: ω⁽ᵏ⁾·v⁽ᵏ⁾ = 0; a rolling wheel where ω⁽ᵏ⁾ = 0."""
    return argue(
        [
            *_least(),
            _LETTERS.step(
                "in a plane motion v = n × y stays across n and ω = φ n along n, and so do their derivatives",
                r"\frac{d}{dt}(n \times y) = n \times \dot{y}",
                r"\frac{d}{dt}(\phi n) = \dot{\phi} n",
                but_not=r"\frac{d}{dt}(n \times y) = n \times y",
            ),
            _LETTERS.step(
                "so w·m = (φ⁽ᵏ⁾ n)·(n × y⁽ᵏ⁾) = 0: where φ⁽ᵏ⁾ ≠ 0, the least value |w·m|/‖w‖ is 0",
                r"(k n) \cdot (n \times y) = 0",
                but_not=r"(k n) \cdot y = 0",
            ),
            _LETTERS.step(
                "a rolling wheel, ω = n and ρ̇ = c constant with c across n: v̇ = −n × c, as long as c, at"
                " all points",
                r"\frac{d}{dt}(\dot{\rho} - n \times \rho) = \ddot{\rho} - n \times \dot{\rho}",
                r"(n \times c)^2 = c^2 - (n \cdot c)^2",
                but_not=r"\frac{d}{dt}(\dot{\rho} - n \times \rho) = \ddot{\rho} + n \times \dot{\rho}",
            ),
        ],
        hypothesis=r"\omega^{(n)} \neq \mathbf{0}",
        counterexample=Counterexample(
            values={
                r"\omega": ("0", "0", "1"),
                r"\dot{\omega}": ("0", "0", "0"),
                r"\dot{\rho}": ("1", "0", "0"),
                r"\ddot{\rho}": ("0", "0", "0"),
            },
            left=("1",),
            right=("0",),
        ),
        reason="a wheel that rolls at constant speed has the reduced acceleration −ω × ρ̇ ≠ 0 at all points",
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


def _least() -> list[Step]:
    return [
        *_decomposition(),
        _LETTERS.step(
            "the square vanishes at f = w × m/w², so that a² is (w·m)²/w² there, which is the square of Du"
            " |w + ε m|",
            r"w \times (m + w \times f) = 0",
            r"(\operatorname{Du} |W|)^2 = \frac{(w \cdot m)^2}{w^2}",
            but_not=r"(\operatorname{Du} |W|)^2 = (w \cdot m)^2",
        ),
        _uniform(),
    ]


def _uniform() -> Step:
    return _LETTERS.step(
        "where w = 0, a = m everywhere, and |ε m| = ε ‖m‖ by the second case of (74)",
        r"m + (w - w) \times x = m",
        but_not=r"m + w \times x = m",
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        locus_of_the_least_reduced_acceleration,
        least_reduced_acceleration,
        least_reduced_jounce_as_printed,
        plane_motion,
    )
}

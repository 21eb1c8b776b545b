"""Remark 7, the Aronhold–Kennedy theorem in space: where it holds, and what replaces it where not.

The twists are a + ε u and b + ε v. The axis of a twist w + ε m with w ≠ 0 holds the points x whose velocity
m + w × x is along w, and so does the line of any dual vector; a line is a point and a direction. Either
a × b ≠ 0, or both are not 0 and parallel, with a sum that is not 0 or is, or one is 0, or both are.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    At,
    Broken,
    Congruence,
    Cut,
    ExistsIntroduction,
    False_,
    IffIntroduction,
    Instance,
    Introductions,
    Kernel,
    NegationIntroduction,
    Part,
    Proof,
    Proven,
)

_N, _N0 = r"(a \times b)", r"(a \times v + u \times b)"


def _meets(w: str, m: str) -> str:
    """The point of the axis of w + ε m on the line of a × b + ε n₀."""
    return (
        rf"\frac{{{_N} \times {_N0}}}{{{_N}^2}} + \frac{{({w} \times {m}) \cdot {_N}}}{{{w}^2 {_N}^2}} {_N}"
    )


def _not_0(w: str, product: str, then: Proof) -> Proof:
    return Cut(rf"{w} \neq \mathbf{{0}}", NegationIntroduction(0, Congruence(product, Y=Instance(-1))), then)


_POINTS = ExistsIntroduction(
    {"c": _meets("a", "u"), "d": _meets("b", "v"), "e": _meets("(a + b)", "(u + v)")}
)
_COMMON = Introductions(
    _not_0("a", r"Y \times b", _not_0("b", r"a \times Y", _not_0("a + b", r"a \times Y", _POINTS)))
)

# a line through z along w that meets the two axes at z + κ w and z + λ w, at right angles
_PERPENDICULAR = (
    r"\forall w, z \in V_3, \kappa, \lambda \in \mathbb{R} : w \cdot a = 0 \wedge w \cdot b = 0"
    r" \wedge a \times (u + a \times (z + \kappa w)) = \mathbf{0}"
    r" \wedge b \times (v + b \times (z + \lambda w)) = \mathbf{0}"
    rf" \Rightarrow w \times {_N} = \mathbf{{0}} \wedge {_N} \times ({_N0} + {_N} \times z) = \mathbf{{0}}"
)
_A, _B, _ON_1, _ON_2 = (Instance(-1, part=i) for i in range(4))
_IS_THE_LINE = Introductions(
    AndIntroduction(
        Congruence("Q a - P b", P=_A, Q=_B),
        Congruence(
            rf"(X \cdot a) a + (Y \cdot b) b - \lambda P ({_N} \times b) + \kappa Q ({_N} \times a)"
            r" - (a \cdot b) (\lambda - \kappa) (Q a - P b)",
            X=_ON_2,
            Y=_ON_1,
            P=_A,
            Q=_B,
        ),
    )
)
_FIRST = {"w": "d", "z": "f", r"\kappa": "s", r"\lambda": "r"}
_SECOND = {"w": "e", "z": "g", r"\kappa": "q", r"\lambda": "h"}
_ONLY_ONE = Introductions(
    Cut(
        _PERPENDICULAR,
        _IS_THE_LINE,
        Introductions(
            AndIntroduction(
                Congruence(
                    rf"\frac{{1}}{{{_N}^2}} (-(X \cdot e) {_N} + ({_N} \cdot e) X - ({_N} \cdot d) Z)",
                    X=Instance(-1, _FIRST),
                    Z=Instance(-1, _SECOND),
                ),
                Congruence(
                    rf"\frac{{1}}{{{_N}^2}} (({_N} \cdot (f - g)) X - d \times (Y - Z))",
                    X=Instance(-1, _FIRST),
                    Y=Instance(-1, _FIRST, part=1),
                    Z=Instance(-1, _SECOND, part=1),
                ),
            )
        ),
    )
)


def _axis(of: int) -> str:
    entries = r" \\ ".join("1" if i == of else "0" for i in range(3))
    return rf"\begin{{bmatrix}} {entries} \end{{bmatrix}}"


_ZEROS = dict.fromkeys(("u", "v", "f", "g"), r"\mathbf{0}") | dict.fromkeys(("s", "r", "q", "h"), "0")
_ONE_AXIS_FOR_BOTH = At(
    {"a": _axis(0), "b": _axis(0), "d": _axis(1), "e": _axis(2), **_ZEROS},
    Broken(Broken(Part(0, False_()))),
)

# parallel axes, through c and e, along a: the other angular velocity is μ a

_THIRD_AXIS = IffIntroduction(
    Congruence(r"-\frac{1}{(1 + \mu)^2 a^2} a \times Y", Y=Instance(-1)),
    Congruence(r"(1 + \mu)^2 a \times Y", Y=Instance(-1)),
)
_ALONG_THE_DUAL_PART = Congruence(
    r"-\mu (d \times (a \times (X - Z))) + \mu (s - r) Y (d \times a)",
    X=Instance(-1, part=1),
    Y=Instance(-1, part=0),
    Z=Instance(-1, part=2),
)
_NORMAL_TO_THE_TRANSLATION = Congruence(
    r"(f - h) Y + d \cdot (X - Z)", X=Instance(-1, part=1), Y=Instance(-1, part=0), Z=Instance(-1, part=2)
)
_NORMAL_TO_THE_FIRST = Congruence(
    r"\frac{b \cdot u}{b^2} Y - d \cdot (X - Z)",
    X=Instance(-1, part=1),
    Y=Instance(-1, part=0),
    Z=Instance(-1, part=2),
)
_MOVED_AXIS = IffIntroduction(
    Congruence(r"-\frac{1}{b^2} b \times Y", Y=Instance(-1)),
    Congruence(r"b \times Y", Y=Instance(-1)),
)

THEOREMS = {
    "remark_7": Proven(AndIntroduction(_COMMON, _ONLY_ONE), against=Part(1, _ONE_AXIS_FOR_BOTH)),
    "remark_7_parallel": Proven(
        AndIntroduction(_THIRD_AXIS, Kernel(), Introductions(_ALONG_THE_DUAL_PART), Kernel())
    ),
    "remark_7_coincident": Proven(AndIntroduction(_THIRD_AXIS, Kernel(), Kernel())),
    "remark_7_relative_translation": Proven(
        AndIntroduction(Kernel(), Introductions(_NORMAL_TO_THE_TRANSLATION))
    ),
    "remark_7_one_translation": Proven(
        AndIntroduction(_MOVED_AXIS, Kernel(), Introductions(_NORMAL_TO_THE_FIRST))
    ),
    "remark_7_translations": Proven(AndIntroduction(Kernel(), Kernel())),
}

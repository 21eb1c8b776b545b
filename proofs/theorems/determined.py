"""Remark 5 and Theorem 10: two bodies whose twists have the same derivatives below order n, at an instant,
have the same accelerations of order n there; those of order n + 1 differ by what the n-th derivatives do.

ρ and r are body points at one place, with ρ̇ = v + ω × ρ and ṙ = u + w × r at all times. By Leibniz' rule
ρ⁽ⁿ⁺¹⁾ = v⁽ⁿ⁾ + Σ C(n, l) ω⁽ⁿ⁻ˡ⁾ × ρ⁽ˡ⁾, so the accelerations are equal one order after the other.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    Induction,
    Instance,
    Introductions,
    Proof,
    Proven,
    SumCongruence,
)

# premises of the goals: how the points move, that they are at one place, the twists below order n
_MOVE, _AT_ONE_PLACE, _BELOW_N = 0, 1, 2

_SAME_TWISTS = r"\Big( \forall k < m : \omega^{(k)} = w^{(k)} \wedge \mathbf{v}^{(k)} = u^{(k)} \Big)"
_EVERY_ORDER = rf"\forall m \geq 0 : {_SAME_TWISTS} \Rightarrow \boldsymbol{{\rho}}^{{(m)}} = r^{{(m)}}"


def _sums(n: str, first: int) -> tuple[str, str]:
    """Of ω and ρ, and of w and r."""
    one, other = (
        rf"\sum_{{l={first}}}^{{{n}}} C_{n}^l ({w}^{{({n}-l)}} \times {r}^{{(l)}})"
        for w, r in ((r"\omega", r"\boldsymbol{\rho}"), ("w", "r"))
    )
    return one, other


def _same_sums(n: str, first: int, twists: int, points: Instance) -> tuple[str, Proof]:
    """They are equal, by premises: twists below order n, and points of the orders up to n."""
    addend = Congruence(r"C_{l+j}^l (Y \times Z)", Y=Instance(twists, {"k": "j"}), Z=points)
    return " = ".join(_sums(n, first)), SumCongruence("l", Introductions(addend))


def _by_leibniz(n: str, then: Proof) -> Proof:
    """ρ⁽ⁿ⁺¹⁾ and r⁽ⁿ⁺¹⁾."""
    one, other = _sums(n, 0)
    first, second = (
        Congruence(rf"\frac{{d^{n}}}{{dt^{n}}} Y", Y=Instance(_MOVE, part=part)) for part in (0, 1)
    )
    written = rf"\boldsymbol{{\rho}}^{{({n}+1)}} = \mathbf{{v}}^{{({n})}} + {one}"
    return Cut(written, first, Cut(rf"r^{{({n}+1)}} = u^{{({n})}} + {other}", second, then))


_ONE, _OTHER = _sums("m", 0)
_STEP = _by_leibniz(
    "m",
    Cut(
        *_same_sums("m", 0, twists=4, points=Instance(3, {"i": "l"})),
        Congruence(
            rf"Y + Z + U + V - (\mathbf{{v}}^{{(m)}} + {_ONE}) - (u^{{(m)}} + {_OTHER})",
            Y=Instance(5),
            Z=Instance(6, back=True),
            U=Instance(7),
            V=Instance(4, {"k": "m"}, part=1),
        ),
    ),
)
_DIFFERENCE = _by_leibniz(
    "n",
    Cut(
        *_same_sums("n", 1, twists=_BELOW_N, points=Instance(3, {"m": "l"})),
        Congruence(
            r"Y - Z + U - (\sum_{l=1}^{n} C_n^l (\omega^{(n-l)} \times \boldsymbol{\rho}^{(l)}))"
            r" + w^{(n)} \times (V - \boldsymbol{\rho})",
            Y=Instance(4),
            Z=Instance(5),
            U=Instance(6),
            V=Instance(_AT_ONE_PLACE),
        ),
    ),
)


def _with_every_order(then: Proof) -> Proof:
    begin = Congruence("Y", Y=Instance(_AT_ONE_PLACE))
    return Introductions(Cut(_EVERY_ORDER, Induction(begin, Introductions(_STEP), letter="i"), then))


THEOREMS = {
    "twist_derivatives_determine_the_fields": Proven(
        AndIntroduction(
            _with_every_order(Congruence("Y", Y=Instance(3, {"m": "n"}))),
            _with_every_order(_DIFFERENCE),
        )
    )
}

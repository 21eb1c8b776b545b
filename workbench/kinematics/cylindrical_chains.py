"""Chains of cylindrical joints: the dual twist of the last body and its derivatives, closed forms.

Joint i turns and slides along the line u̲ᵢ (a unit dual vector, where it is *now*, in the base
frame) at the dual rate ω̲ᵢ = α̇ᵢ + ε ḋᵢ. Joint i carries all lines after it, Eqs. (136)–(142):

    u̲̇₁ = 0,   u̲̇₂ = ω̲₁ u̲₁ × u̲₂,   u̲̇₃ = (ω̲₁ u̲₁ + ω̲₂ u̲₂) × u̲₃,   ω̲ = Σ ω̲ᵢ u̲ᵢ.

`twist_derivatives_2c` is Section 8 of the chapter, `twist_derivatives_3c` the six-degree-of-freedom
chain that it leaves to the reader; `latex_2c` and `latex_3c` print them. `twist_derivatives` is for
any number of joints and any order. All take any scalar ring, and floats in batches.

Lines have shape (..., 3), rates (...). A rate is given with its time derivatives: rates[i][k] is
dᵏω̲ᵢ/dtᵏ, a dual number (a real one is a joint that only turns). Units: radians and metres per
second to the power k + 1. Results are a tuple: entry k is dᵏω̲/dtᵏ, of shape (..., 3).
"""

from __future__ import annotations

from collections.abc import Sequence
from math import comb
from typing import Any

from workbench.algebra.dual import Dual
from workbench.algebra.dual_tensors import apply, cross, scale
from workbench.kinematics.printed_chains import latex_2c, latex_3c
from workbench.kinematics.screws import from_natural_invariants

__all__ = [
    "current_lines",
    "latex_2c",
    "latex_3c",
    "twist_derivatives",
    "twist_derivatives_2c",
    "twist_derivatives_3c",
]

Rates = Sequence[Sequence[Any]]


def current_lines(lines: Sequence[Dual], angles: Sequence[Dual]) -> tuple[Dual, ...]:
    """Returns the positions of the joints' lines at the dual angles α̲ᵢ + ε dᵢ, Eqs. (139)–(140).

    ``lines[i]``: line i in the base frame when all angles are zero; angles in rad, their dual parts in m.

    >>> x, z = Dual([1.0, 0, 0]), Dual([0, 0, 1.0])
    >>> current_lines([z, x], [Dual(0.0, 1.0), Dual(0.0)])[1].du.tolist()  # x, lifted by 1 m
    [0.0, 1.0, 0.0]
    """
    carried = list(lines)
    for i in reversed(range(len(lines))):
        displacement = from_natural_invariants(angles[i], lines[i])
        carried[i + 1 :] = [apply(displacement, line) for line in carried[i + 1 :]]
    return tuple(carried)


def twist_derivatives_2c(lines: Sequence[Dual], rates: Rates) -> tuple[Dual, ...]:
    """Returns ω̲, ω̲̇, ω̲̈, ω̲⃛ of a 2C chain, Eqs. (143)–(146); ``rates[i]`` holds four entries.

    Raises `ValueError` for another number of lines or rates.

    >>> x, z = Dual([1, 0, 0]), Dual([0, 0, 1])
    >>> twist_derivatives_2c([z, x], [[1, 0, 0, 0], [2, 0, 0, 0]])[1].re.tolist()
    [0, 2, 0]
    """
    _require(lines, rates, joints=2)
    u1, u2 = lines
    (w1, dw1, ddw1, dddw1), (w2, dw2, ddw2, dddw2) = rates
    u12 = cross(u1, u2)
    u112 = cross(u1, u12)
    twist = scale(w1, u1) + scale(w2, u2)
    rate = scale(dw1, u1) + scale(dw2, u2) + scale(w1 * w2, u12)
    second = (
        scale(ddw1, u1) + scale(ddw2, u2) + scale(2 * w1 * dw2 + dw1 * w2, u12) + scale(w1 * w1 * w2, u112)
    )
    third = (
        scale(dddw1, u1)
        + scale(dddw2, u2)
        + scale(_third_rate_across(rates[0], rates[1]), u12)
        + scale(3 * (w1 * w1 * dw2 + w1 * dw1 * w2), u112)
    )
    return twist, rate, second, third


def twist_derivatives_3c(lines: Sequence[Dual], rates: Rates) -> tuple[Dual, ...]:
    """Returns ω̲, ω̲̇, ω̲̈, ω̲⃛ of a 3C chain, as `latex_3c` prints them; ``rates[i]`` holds four entries.

    Raises `ValueError` for another number of lines or rates.

    >>> x, z = Dual([1, 0, 0]), Dual([0, 0, 1])
    >>> twist_derivatives_3c([z, x, z], [[1, 0, 0, 0], [2, 0, 0, 0], [1, 0, 0, 0]])[0].re.tolist()
    [2, 0, 2]
    """
    _require(lines, rates, joints=3)
    u1, u2, u3 = lines
    (w1, dw1, ddw1, dddw1), (w2, dw2, ddw2, dddw2), (w3, dw3, ddw3, dddw3) = rates
    u12, u13, u23 = cross(u1, u2), cross(u1, u3), cross(u2, u3)
    u112, u113, u123, u223 = cross(u1, u12), cross(u1, u13), cross(u1, u23), cross(u2, u23)
    twist = scale(w1, u1) + scale(w2, u2) + scale(w3, u3)
    rate = (
        scale(dw1, u1)
        + scale(dw2, u2)
        + scale(dw3, u3)
        + scale(w1 * w2, u12)
        + scale(w1 * w3, u13)
        + scale(w2 * w3, u23)
    )
    second = (
        scale(ddw1, u1)
        + scale(ddw2, u2)
        + scale(ddw3, u3)
        + scale(2 * w1 * dw2 + dw1 * w2, u12)
        + scale(2 * w1 * dw3 + dw1 * w3, u13)
        + scale(2 * w2 * dw3 + dw2 * w3, u23)
        + scale(w1 * w1 * w2, u112)
        + scale(w1 * w1 * w3, u113)
        + scale(w2 * w2 * w3, u223)
        + scale(2 * w1 * w2 * w3, u123)
    )
    third = (
        scale(dddw1, u1)
        + scale(dddw2, u2)
        + scale(dddw3, u3)
        + scale(_third_rate_across(rates[0], rates[1]), u12)
        + scale(_third_rate_across(rates[0], rates[2]), u13)
        + scale(_third_rate_across(rates[1], rates[2]), u23)
        + scale(3 * (w1 * w1 * dw2 + w1 * dw1 * w2), u112)
        + scale(3 * (w1 * w1 * dw3 + w1 * dw1 * w3), u113)
        + scale(3 * (w2 * w2 * dw3 + w2 * dw2 * w3), u223)
        + scale(3 * (2 * w1 * w2 * dw3 + w1 * dw2 * w3 + dw1 * w2 * w3), u123)
        + scale(3 * w1 * w1 * w2 * w3, cross(u1, u123))
        + scale(3 * w1 * w2 * w2 * w3, cross(u1, u223))
    )
    return twist, rate, second, third


def _third_rate_across(inner: Sequence[Any], outer: Sequence[Any]) -> Any:
    """Returns the coefficient of u̲ᵢ × u̲ⱼ in ω̲⃛; its last term is ω̲ᵢ³ ω̲ⱼ ũ̲ᵢ³ u̲ⱼ, and ũ̲³ = −ũ̲."""
    (w, dw, ddw, _), (v, dv, ddv, _) = inner, outer
    return ddw * v + 3 * dw * dv + 3 * w * ddv - w * w * w * v


def twist_derivatives(lines: Sequence[Dual], rates: Rates) -> tuple[Dual, ...]:
    """Returns ω̲ and its derivatives to order n of any number of cylindrical joints.

    ``rates[i]`` holds n + 1 entries. Eq. (133) with the joints nested: the bodies from joint i on have
    twists with the derivatives `ω̲ᵢ⁽ᵏ⁾ u̲ᵢ + Σⱼ C(k, j) Φ̲ⱼ(ω̲ᵢ u̲ᵢ) V̲⁽ᵏ⁻ʲ⁾`. There V̲ is the twist of the
    bodies after joint i, as seen from its body. Raises `ValueError` for counts that do not fit.

    >>> x, z = Dual([1, 0, 0]), Dual([0, 0, 1])
    >>> [each.re.tolist() for each in twist_derivatives([z, x], [[1, 0], [2, 0]])]
    [[2, 0, 1], [0, 2, 0]]
    """
    _require(lines, rates, joints=len(lines), entries=len(rates[0]) if rates else 1)
    order = len(rates[0]) - 1
    beyond: list[Dual] | None = None
    for u, w in zip(reversed(lines), reversed(rates), strict=True):
        own = [scale(w[k], u) for k in range(order + 1)]
        if beyond is not None:
            carried = _carried(u, w, beyond)
            own = [own[k] + carried[k] for k in range(order + 1)]
        beyond = own
    return tuple(beyond or ())


def _carried(u: Dual, w: Sequence[Any], V: Sequence[Dual]) -> list[Dual]:
    """Returns Σⱼ C(k, j) Φ̲ⱼ(ω̲ u̲) V̲⁽ᵏ⁻ʲ⁾ for every k; about a fixed line Φ̲ⱼ = aⱼ ũ̲ + bⱼ ũ̲², j ≥ 1."""
    a, b = _fixed_axis_coefficients(w)
    first = [cross(u, v) for v in V]
    second = [cross(u, v) for v in first]
    carried = list(V)
    for k in range(1, len(V)):
        for j in range(1, k + 1):
            carried[k] = (
                carried[k]
                + scale(comb(k, j) * a[j - 1], first[k - j])
                + scale(comb(k, j) * b[j - 1], second[k - j])
            )
    return carried


def _fixed_axis_coefficients(w: Sequence[Any]) -> tuple[list[Any], list[Any]]:
    """Returns a₁ … aₙ and b₁ … bₙ with Φ̲ⱼ(ω̲ u̲) = aⱼ ũ̲ + bⱼ ũ̲², by Φⱼ₊₁ = Σᵢ C(j, i) ω̲⁽ⁱ⁾ ũ̲ Φⱼ₋ᵢ."""
    a, b = [w[0]], [0 * w[0]]
    for j in range(1, len(w) - 1):
        before = [(comb(j, i) * w[i], j - i - 1) for i in range(j)]
        turned = sum((-c * b[place] for c, place in before), w[j])
        a, b = [*a, turned], [*b, sum((c * a[place] for c, place in before), 0 * w[0])]
    return a, b


def _require(lines: Sequence[Dual], rates: Rates, joints: int, entries: int = 4) -> None:
    if joints == 0 or len(lines) != joints:
        raise ValueError(f"expected {joints or 'at least 1'} lines, got {len(lines)}")
    if len(rates) != joints:
        raise ValueError(f"expected the rates of {joints} joints, got those of {len(rates)}")
    for index, entry in enumerate(rates):
        if len(entry) != entries or entries == 0:
            raise ValueError(
                f"joint {index + 1}: expected its rate and {entries - 1} derivatives of it, "
                f"got {len(entry)} entries"
            )

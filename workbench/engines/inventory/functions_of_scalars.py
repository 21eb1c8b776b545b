"""The elementary functions of scalars: their derivatives, their domain, and the sines of their values."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from workbench.core.construct import apply, block, number, power
from workbench.core.terms import Head, Term


class Elementary(NamedTuple):
    """A function of scalars. u: its arguments, own: its value.

    slopes: ∂f/∂u.   domain: terms that are > 0 where the function is defined and smooth.
    circle: the cosine and the sine of the value, times a length: (cos, sin, length).
    """

    slopes: Callable[[Sequence[Term], Term], list[Term]]
    domain: Callable[[Sequence[Term]], list[Term]] = lambda u: []
    circle: Callable[[Sequence[Term]], tuple[Term, Term, Term]] | None = None


def less(one: Term, other: Term) -> Term:
    return apply("add", one, apply("neg", other))


def over(one: Term, other: Term) -> Term:
    return apply("div", one, other)


def _squared(term: Term) -> Term:
    return power(term, 2)


ONE = number(1)


def _cofunction(u: Sequence[Term]) -> Term:
    return apply("root", less(ONE, _squared(u[0])))


def _length(u: Sequence[Term]) -> Term:
    return apply("norm", block([[u[1]], [u[0]]]))


def _one_more(u: Sequence[Term]) -> Term:
    return apply("add", ONE, _squared(u[0]))


def _of_two(u: Sequence[Term], own: Term) -> list[Term]:
    y, x = u
    below = apply("add", _squared(x), _squared(y))
    return [over(x, below), apply("neg", over(y, below))]


#: The functions by their heads.
FUNCTIONS: Mapping[Head, Elementary] = {
    "exp": Elementary(lambda u, own: [own]),
    "log": Elementary(lambda u, own: [over(ONE, u[0])], list),
    "arcsin": Elementary(
        lambda u, own: [over(ONE, _cofunction(u))],
        lambda u: [less(ONE, _squared(u[0]))],
        lambda u: (_cofunction(u), u[0], ONE),
    ),
    "arccos": Elementary(
        lambda u, own: [apply("neg", over(ONE, _cofunction(u)))],
        lambda u: [less(ONE, _squared(u[0]))],
        lambda u: (u[0], _cofunction(u), ONE),
    ),
    "arctan": Elementary(
        lambda u, own: [over(ONE, _one_more(u))],
        circle=lambda u: (ONE, u[0], apply("root", _one_more(u))),
    ),
    "atan2": Elementary(
        _of_two,
        lambda u: [apply("add", _squared(u[0]), _squared(u[1]))],
        lambda u: (u[1], u[0], _length(u)),
    ),
}  # fmt: skip

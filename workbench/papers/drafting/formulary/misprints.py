"""The usual misprints of one monomial: an order, a power, a rate, an index, sine for cosine, a transpose."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from fractions import Fraction

from workbench.papers.drafting.formulary.normal_sums import Leaf, Monomial, Node, Part, Sum

_CIRCULAR = {"sin": "cos", "cos": "sin"}
#: Operations whose parts a misprint may exchange. The sign of a cross product tells the order.
_ORDERED = frozenset({"mul", "outer"})


def misprints_of(own: Monomial, leaves: Sequence[Leaf]) -> Iterator[Monomial]:
    """Yields the monomial after each usual misprint that is no factor of a number.

    leaves: the symbols of the formula, one of which may stand in place of another.
    """
    powers = own.powers
    for at, (part, exponent) in enumerate(powers):
        rest = (*powers[:at], *powers[at + 1 :])
        for other in dict.fromkeys((exponent + 1, exponent - 1, -exponent)):
            if other:
                yield replace(own, powers=(*rest, (part, other)))
            elif _may_be_lost(part):
                yield replace(own, powers=rest)
        for changed in _misprints(part, leaves):
            if changed not in (each for each, _ in rest):
                yield replace(own, powers=(*rest, (changed, exponent)))
            if exponent > 1:  # the square of a sine is printed as sine times cosine
                yield replace(own, powers=(*rest, (part, exponent - 1), (changed, 1)))
    present = {part for part, _ in powers}
    for leaf in leaves:
        if leaf.base.type.kind == "scalar" and leaf not in present:
            yield replace(own, powers=(*powers, (leaf, 1)))
    if own.word is not None:
        yield from (replace(own, word=changed) for changed in _misprints(own.word, leaves))


def _may_be_lost(part: Part) -> bool:
    """True for a symbol, and a sine or cosine."""
    return isinstance(part, Leaf) or (isinstance(part, Node) and part.head in _CIRCULAR)


def _misprints(part: Part, leaves: Sequence[Leaf]) -> Iterator[Part]:
    match part:
        case Leaf():
            yield from _misprints_of_leaf(part, leaves)
        case Node(head="transpose" | "inverse", parts=(inner,)):
            yield inner
        case Node(head=head, parts=parts):
            if head in _CIRCULAR:
                yield Node(_CIRCULAR[head], parts)
            if head in _ORDERED:
                for at in range(len(parts) - 1):
                    yield replace(part, parts=(*parts[:at], parts[at + 1], parts[at], *parts[at + 2 :]))
            if head == "mul":
                yield from _with_fewer(parts)
            for at, inner in enumerate(parts):
                for changed in _misprints(inner, leaves):
                    yield replace(part, parts=(*parts[:at], changed, *parts[at + 1 :]))
        case Sum(monomials=monomials):
            for at, one in enumerate(monomials):
                rest = (*monomials[:at], *monomials[at + 1 :])
                if rest:
                    yield Sum(rest)
                    yield Sum((*rest, one.times(Fraction(-1))))
                yield from (Sum((*rest, other)) for other in misprints_of(one, leaves))


def _misprints_of_leaf(own: Leaf, leaves: Sequence[Leaf]) -> Iterator[Part]:
    yield Leaf(own.base, own.order + 1)
    if own.order:
        yield Leaf(own.base, own.order - 1)
    yield from (each for each in leaves if each.base.type == own.base.type and each != own)
    if own.base.type.is_square and own.base.type.kind != "scalar":
        yield Node("transpose", (own,))


def _with_fewer(parts: tuple[Part, ...]) -> Iterator[Part]:
    """Yields a product with one of two equal neighbours: K for K²."""
    for at in range(len(parts) - 1):
        if parts[at] == parts[at + 1]:
            rest = (*parts[:at], *parts[at + 1 :])
            yield rest[0] if len(rest) == 1 else Node("mul", rest)

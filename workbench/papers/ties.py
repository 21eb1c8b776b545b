"""What the bindings of [motion] say of each other: ω bound to w_WB is the angular velocity of R, R_WB.

A bound symbol that follows from another one is defined by it, so that the exact judge knows what Drake's
motions know. What is bound and stays free is told by the motions: a claim that holds on them is not refuted.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from workbench.language.construct import apply, derivative
from workbench.language.definitions import Definitions
from workbench.language.terms import Definition, Symbol, Term


def _rate(x: Term) -> Term:
    return derivative(x, 1)


def _spin(rotation: Term) -> Term:
    """vect(Ṙ Rᵀ), of which the skew tensor is Ṙ Rᵀ; Eq. (5), and (90) for dual ones."""
    return apply("vect", apply("mul", _rate(rotation), apply("transpose", rotation)))


#: A quantity of a motion → the one that it follows from, and how.
_FOLLOWS: dict[str, tuple[str, Callable[[Term], Term]]] = {
    "w_WB": ("R_WB", _spin),
    "w_WA": ("R_WA", _spin),
    "w_AB_A": ("R_AB", _spin),
    "dual_w_WB": ("dual_R_WB", _spin),
    "dual_w_WA": ("dual_R_WA", _spin),
    "dual_w_AB_A": ("dual_R_AB", _spin),
    "alpha_WB": ("w_WB", _rate),
    "v_WBo": ("p_WBo", _rate),
    "v_WP": ("p_WP", _rate),
    "v_WQ": ("p_WQ", _rate),
    "v_WAo": ("p_WAo", _rate),
    "a_WBo": ("v_WBo", _rate),
    "a_WP": ("v_WP", _rate),
    "a_WQ": ("v_WQ", _rate),
}


def ties(motion: Mapping[Symbol, str], definitions: Definitions) -> Iterator[Definition]:
    """Definitions of bound symbols, which the paper leaves free, by other bound symbols."""
    bound: dict[str, Symbol] = {}
    for symbol, name in motion.items():
        bound.setdefault(name, symbol)
    for symbol, name in motion.items():
        source, make = _FOLLOWS.get(name, ("", _rate))
        first = bound[name]
        if definitions.lookup(symbol) is not None:
            continue
        if first != symbol:
            yield Definition(symbol.declaration, symbol.index, (), first)
        elif source in bound:
            yield Definition(symbol.declaration, symbol.index, (), make(bound[source]))

"""The jet engine of a screen: it shares the values of subterms between candidates."""

from __future__ import annotations

from typing import Any

from workbench.core.terms import Symbol, Term
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.logarithm_values import LogarithmValues, is_logarithm
from workbench.engines.jet.components import OperatorValue, Value
from workbench.engines.jet.jets import JetEngine
from workbench.language.definitions import expand


class SharingEngine(JetEngine):
    """Caches values by the identity of terms, because hashing a large term would cost more than its value.

    Attributes:
        given: Symbols with prescribed values, as if they were constant.
    """

    def __init__(self, source: Any, definitions: Lookup) -> None:
        super().__init__(source, definitions)
        self.given: dict[Symbol, Value] = {}
        self._kept: dict[int, tuple[Term, Value]] = {}
        self._symbols: dict[Symbol, Value] = {}
        self._passing: dict[int, tuple[Term, Value]] = {}
        self._operators: dict[tuple[Symbol, int], OperatorValue] = {}
        self.keeps = True

    def value(self, term: Term, depth: int) -> Value:
        if isinstance(term, Symbol):
            if term in self.given:
                return self._given(term, depth)
            known = self._symbols.get(term)
            if known is None or known.depth < depth:
                known = self._symbols[term] = self._evaluate(term, depth)
            return known.cut(0, depth)
        entry = self._kept.get(id(term)) or self._passing.get(id(term))
        if entry is None or entry[1].depth < depth:
            kept = self._kept if self.keeps else self._passing
            entry = kept[id(term)] = (term, self._evaluate(term, depth))
        return entry[1].cut(0, depth)

    def _evaluate(self, term: Term, depth: int) -> Value:
        if not is_logarithm(term):
            return super()._evaluate(term, depth)
        exponents = LogarithmValues(self._definitions)
        exponent = exponents.without(expand(term, self._definitions))
        if exponents.unknown or exponents.free:
            raise NotExact("a logarithm whose exponent is not written")
        return self.value(exponent, depth)

    def operator(self, term: Term, depth: int) -> OperatorValue:
        if not isinstance(term, Symbol) or term.type.kind != "operator":
            return super().operator(term, depth)
        if (term, depth) not in self._operators:
            self._operators[term, depth] = super().operator(term, depth)
        return self._operators[term, depth]

    def forget_candidate(self) -> None:
        """Drops the values that were computed while `keeps` was False."""
        self._passing.clear()

    def _given(self, symbol: Symbol, depth: int) -> Value:
        value = self.given[symbol]
        du = None if value.du is None else value.du + [0 * value.du[0]] * depth
        return Value(value.re + [0 * value.re[0]] * depth, du)

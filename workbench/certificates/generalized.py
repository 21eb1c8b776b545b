"""Steps that hold whatever some of their terms are: each term of which no theorem can speak, such as a sum
over k < n or Dⁿ of a product, is a symbol of its own, and the theorem is about every value of that.

The step is an instance of it. That it holds so is tried on random motions first: Coq is asked only then.
"""

from __future__ import annotations

from collections.abc import Iterable
from random import Random

from workbench.certificates.emitter import Emitter
from workbench.certificates.nodes import KINDS, NotCertified, flag
from workbench.certificates.theorem import Theorem
from workbench.certificates.trigonometric import Pair, Values, Wave, flat, order, parsed, value
from workbench.language.construct import derivative, rebuild, relation, symbol
from workbench.language.definitions import Definitions
from workbench.language.integers import Linear
from workbench.language.names import Name
from workbench.language.printer import to_latex
from workbench.language.terms import (
    BigSum,
    Counting,
    Derivative,
    IllFormed,
    Integer,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.language.types import Declaration


class Generalizer:
    """Terms with symbols of their own for what cannot be said; `meant`: what each stands for."""

    def __init__(self, definitions: Definitions, integers: Iterable[str]) -> None:
        self.meant: dict[Symbol, Term] = {}
        self._speaker = Emitter(definitions)
        self._speaker.several = True
        self._speaker.integers = {name: name for name in integers}
        self._least: dict[tuple[Term, Linear], int] = {}

    @property
    def said(self) -> list[str]:
        """Such as: any_1 is \\sum_k …"""
        return [f"{to_latex(made)} is {to_latex(meant)}" for made, meant in self.meant.items()]

    def equation(self, said: Statement) -> Relation:
        if not isinstance(said, Relation) or said.operator != "=":
            raise NotCertified("no equation")
        for part in (p for side in (said.left, said.right) for p in side.walk()):
            if isinstance(part, Derivative) and not part.order.is_number:
                key = part.body, part.order - part.order.constant
                self._least[key] = min(self._least.get(key, part.order.constant), part.order.constant)
        return relation(said.operator, self.term(said.left), self.term(said.right))

    def term(self, term: Term) -> Term:
        match term:
            case BigSum():
                return self._anything(term)
            case Integer(value=Linear(is_number=False)) | Counting():
                return self._anything(term, constant=True)
            case Power(exponent=Linear(is_number=False)):
                return self._anything(term)
            case Derivative(body=body, order=Linear(is_number=False) as many):
                least = self._least[body, many - many.constant]
                lowest = Derivative(term.type, None, body, many - many.constant + least)
                made, more = self._anything(lowest), many.constant - least
                return derivative(made, more) if more else made
        whole = isinstance(term, Symbol) or getattr(term, "head", "") in ("divergence", "curl")
        made = term if whole or not term.children else rebuild(term, [self.term(c) for c in term.children])
        if term.type.kind not in KINDS or self._can_be_said(made):
            return made
        return self._anything(term)

    def _can_be_said(self, term: Term) -> bool:
        try:
            self._speaker.term(term)
        except (NotCertified, IllFormed):
            return False
        return True

    def _anything(self, term: Term, constant: bool = False) -> Symbol:
        for known, meant in self.meant.items():
            if meant == term:
                return known
        if term.type.kind not in KINDS:
            raise NotCertified(f"a quantity that is no scalar, vector or tensor: {term.type.kind}")
        made = symbol(Declaration(Name(f"any_{len(self.meant) + 1}"), term.type, constant=constant))
        self.meant[made] = term
        return made


def holds_whatever_they_are(made: Theorem) -> bool:
    """Whether the theorem's equations hold on a random motion, whatever is supposed of the symbols."""
    chance, values, emitter = Random(0), {}, made.emitter
    if emitter.steps:  # reciprocals are what is supposed of them
        return False
    known = {origin.node.deep: origin.value for origin in emitter.origins if origin.how == "is"}
    pairs = [pair for goals in made.goals for pair in goals]
    degree = 1 + max(order(parsed(side), {}) for pair in pairs for side in pair)
    for place, (dual, kind, _) in enumerate(emitter.slots):
        deep = f"(Var {flag(dual)} {kind} {place})"
        values[flag(dual), kind, str(place)] = (
            value(known[deep].deep, values) if deep in known else _any(dual, kind, degree, chance)
        )
    return all(_agree(left, right, values) for left, right in pairs)


def _agree(left: str, right: str, values: Values) -> bool:
    return flat(value(left, values)) == flat(value(right, values))


def _any(dual: bool, kind: str, degree: int, chance: Random) -> object:
    def scalar() -> Wave:
        return Wave({(0, 0, power): chance.randint(1, 10**9) for power in range(degree + 1)})

    def entry() -> Wave | Pair:
        return Pair(scalar(), scalar()) if dual else scalar()

    match kind:
        case "Scalar":
            return entry()
        case "Vector":
            return [entry() for _ in range(3)]
    return [[entry() for _ in range(3)] for _ in range(3)]

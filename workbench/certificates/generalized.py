"""Steps that hold whatever some of their terms are: each term of which no theorem can speak, such as a sum
over k < n or Dⁿ of a product, is a symbol of its own, and the theorem is about every value of that.

The step is an instance of it. That it holds so is tried on random motions first: Coq is asked only then.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from random import Random

from workbench.certificates.emitter import Emitter
from workbench.certificates.instances import place
from workbench.certificates.nodes import KINDS, NotCertified, flag
from workbench.certificates.theorem import Theorem
from workbench.certificates.trigonometric import Pair, Values, Wave, flat, order, parsed, value
from workbench.language.construct import apply, derivative, rebuild, relation, symbol
from workbench.language.definitions import Definitions
from workbench.language.integers import Linear
from workbench.language.names import Name
from workbench.language.printer import to_latex
from workbench.language.terms import (
    Apply,
    BigSum,
    Counting,
    Derivative,
    Identity,
    IllFormed,
    Integer,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
)
from workbench.language.types import Declaration


class Generalizer:
    """Terms with symbols of their own for what cannot be said. `meant`: what each stands for; `premises`:
    what it is by definition, if it is a member of a recurrence, such as Fₙ₊₁(ω) in terms of Fₙ(ω), or what
    such an operator makes of a value."""

    def __init__(self, definitions: Definitions, integers: Iterable[str]) -> None:
        self.meant: dict[Symbol, Term] = {}
        self.premises: list[Relation] = []
        self._definitions = definitions
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
                lowest = self._least.setdefault((body, many - many.constant), many.constant)
                least = min(lowest, many.constant)
                lowest = Derivative(term.type, None, body, many - many.constant + least)
                made, more = self._anything(lowest), many.constant - least
                return derivative(made, more) if more else made
        whole = isinstance(term, Symbol) or getattr(term, "head", "") in ("divergence", "curl")
        made = term if whole or not term.children else rebuild(term, [self.term(c) for c in term.children])
        if term.type.kind not in KINDS or self._can_be_said(made):
            return made
        known = len(self.meant)
        named = self._anything(term)
        if len(self.meant) > known and (body := self._meaning(term)) is not None:
            self.premises.append(relation("=", named, self.term(body)))
        return named

    def _meaning(self, term: Term) -> Term | None:
        """What it is by definition, if that says anything."""
        match term:
            case Symbol():
                return self._definitions.lookup(term)
            case Apply(head="mul", arguments=(operator, value)) if operator.type.kind == "operator":
                return self._made_of(operator, value)
        return None

    def _made_of(self, operator: Term, value: Term) -> Term | None:
        """What the operator makes of the value, one step of a recurrence or power further."""
        match operator:
            case Symbol():
                body = self._definitions.lookup(operator)
                return None if body is None else self._acted(body, value)
            case Power(base=base, exponent=many) if many.constant > 0:
                return self._acted(base, self._acted(replace(operator, exponent=many - 1), value))
            case Symbol() | Power():
                return None
        return self._acted(operator, value)

    def _acted(self, operator: Term, value: Term) -> Term:
        match operator:
            case TimeOperator():
                return derivative(value, 1)
            case Apply(head="add" | "neg" as head, arguments=parts):
                return apply(head, *(self._acted(part, value) for part in parts))
            case Apply(head="mul" | "compose", arguments=(outer, inner)) if operator.type.kind == "operator":
                return self._acted(outer, self._acted(inner, value))
            case Identity() if operator.type.kind == "operator":
                return value
        return apply("mul", operator, value)

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
    pairs = [pair for goals in made.goals for pair in goals]
    known = {place(origin.node): origin.value for origin in emitter.origins if origin.how == "is"}
    sides = [side for pair in pairs for side in pair] + [node.deep for node in known.values()]
    degree = 1 + len(known) + max(order(parsed(side), {}) for side in sides)
    for number, (dual, kind, _) in enumerate(emitter.slots):
        if (where := (flag(dual), kind, str(number))) not in known:
            values[where] = _any(dual, kind, degree, chance)
    for where, node in known.items():
        values[where] = value(node.deep, values)
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

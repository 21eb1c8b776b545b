"""Generalized steps: each term that no theorem can express becomes a symbol with an arbitrary value.

Such terms are, for example, a sum over k < n, or Dⁿ of a product. The step is an instance of the theorem. It
is tested on random motions before Coq is asked.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace

from workbench.certificates.emission.emitted_nodes import KINDS, NotCertified
from workbench.certificates.emission.emitter import Emitter
from workbench.core.construct import apply, big_sum, derivative, power, relation, symbol, with_children
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import free_integers, instantiate
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    BigSum,
    Counting,
    Derivative,
    Identity,
    IllFormed,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
)
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions
from workbench.language.printing.printer import to_latex


class Generalizer:
    """Replaces inexpressible terms by symbols.

    Attributes:
        meant: Symbol → the term that it stands for.
        premises: The definitions of these terms, if they are members of a recurrence (Fₙ₊₁(ω) in terms of
            Fₙ(ω)) or the value of such an operator.
    """

    def __init__(self, definitions: Definitions, integers: Mapping[str, int]) -> None:
        self.meant: dict[Symbol, Term] = {}
        self.premises: list[Relation] = []
        self._definitions = definitions
        self._speaker = Emitter(definitions)
        self._speaker.several = True
        self._speaker.integers = {name: name for name in integers}
        self._speaker.bounds = {n: (Linear(least), Linear.variable(n)) for n, least in integers.items()}
        self._bound: tuple[str, ...] = ()  # the variables of enclosing sums

    @property
    def said(self) -> list[str]:
        r"""Descriptions such as: any_1 is \sum_k …"""
        return [f"{to_latex(made)} is {to_latex(meant)}" for made, meant in self.meant.items()]

    def equation(self, said: Statement) -> Relation:
        if not isinstance(said, Relation) or said.operator != "=":
            raise NotCertified("no equation")
        sides = said.left, said.right
        for part in (p for side in sides for p in side.walk()):  # before its addends
            if isinstance(part, BigSum):
                self.term(part)
        return relation(said.operator, *map(self.term, sides))

    def term(self, term: Term) -> Term:
        match term:
            case BigSum(variables=(variable,), lower=Linear() as lower, upper=upper, body=body):
                with self._inside(variable, lower, upper):
                    addend = self.term(body)
                return big_sum((variable,), lower, upper, addend)
            case Power(exponent=Linear(is_number=False)) if term.type.kind in KINDS:
                return self._anything(term)
        whole = isinstance(term, Symbol) or getattr(term, "head", "") in ("divergence", "curl")
        made = term if whole else with_children(term, self.term)
        if term.type.kind not in KINDS or self._can_be_said(made):
            return made
        known = len(self.meant)
        named = self._anything(term)
        if len(self.meant) > known and not named.index and (meaning := self._meaning(term)) is not None:
            self.premises.append(relation("=", named, self.term(meaning)))
        return named

    def _meaning(self, term: Term) -> Term | None:
        """Returns the definition of the term, if it is useful."""
        match term:
            case Symbol():
                return self._definitions.lookup(term)
            case Apply(head="mul", arguments=(operator, value)) if operator.type.kind == "operator":
                return self._made_of(operator, value)
        return None

    def _made_of(self, operator: Term, value: Term) -> Term | None:
        """Returns the value of the operator, expanded by one step of a recurrence or power."""
        match operator:
            case Symbol():
                body = self._definitions.lookup(operator)
                return None if body is None else self._acted(body, value)
            case Power(base=base, exponent=many) if many.constant > 0:
                return self._acted(base, self._acted(power(base, many - 1), value))
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
            case BigSum(variables=variables, lower=lower, upper=upper, body=body):
                return big_sum(variables, lower, upper, self._acted(body, value))
        return apply("mul", operator, value)

    @contextmanager
    def _inside(self, variable: str, lower: Linear, upper: Linear) -> Iterator[None]:
        speaker, kept = self._speaker, (self._bound, self._speaker.integers, self._speaker.bounds)
        self._bound = (*self._bound, variable)
        speaker.integers = {**speaker.integers, variable: variable}
        speaker.bounds = {**speaker.bounds, variable: (lower, upper)}
        try:
            yield
        finally:
            self._bound, speaker.integers, speaker.bounds = kept

    def _can_be_said(self, term: Term) -> bool:
        try:
            self._speaker.term(term)
        except (NotCertified, IllFormed):
            return False
        return True

    def _anything(self, term: Term) -> Symbol:
        """Returns a symbol for the term, with an index for each summation variable in it."""
        for known, meant in self.meant.items():
            index = _by_index(meant, [*known.index, None][0], term)
            if index is not None:
                return replace(known, index=index)
        if term.type.kind not in KINDS:
            raise NotCertified(f"a quantity that is no scalar, vector or tensor: {term.type.kind}")
        free = free_integers(term)
        index = tuple(Linear.variable(v) for v in self._bound if v in free)
        if len(index) > 1:
            raise NotCertified("a sum of sums")
        name = Name(f"any_{len(self.meant) + 1}", sub=("",) * (len(index) + 1) if index else ())
        made = symbol(Declaration(name, term.type, indices=len(index)), index)
        self.meant[made] = term
        return made


def _by_index(meant: Term, index: Linear | None, term: Term) -> tuple[Linear, ...] | None:
    """Returns the index for which the first term is equal to the second."""
    if index is None:
        return () if meant == term else None
    (variable,) = index.variables
    places = {place for part in term.walk() for place in _integers(part)}
    places |= set(map(Linear.variable, free_integers(term)))
    for place in (p + more for p in places for more in (0, -1, 1)):
        try:
            if instantiate(meant, {variable: place}) == term:
                return (place,)
        except IllFormed:
            continue
    return None


def _integers(part: Term) -> tuple[Linear, ...]:
    match part:
        case Symbol(index=index) | Counting(arguments=index):
            return index
        case Derivative(order=one) | Power(exponent=one):
            return (one,)
    return ()

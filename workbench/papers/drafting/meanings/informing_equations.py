"""False equations that say what a symbol is, although their sides are two expressions."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress

from workbench.context.claims import Claim
from workbench.context.free_symbols import free_in, terms_of
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.construct import apply, derivative, power, relation, zero
from workbench.core.reasons import Reason
from workbench.core.terms import Apply, Derivative, Head, IllFormed, Power, Relation, Symbol, Term
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions, expand, replaced
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.decide_under_facts import Decider, JudgeOf, OutOfDecisions

#: Functions of which only one branch may be meant.
_OF_BRANCHES = frozenset(("root", "norm", "arccos", "arcsin", "arctan", "log"))
#: The most other symbols on which the value of a symbol may depend, so that it is sought.
_MOST_SYMBOLS = 12


def says_what_is(
    claim: Claim, known: Definitions, judge_of: JudgeOf, is_new: Callable[[Symbol], bool]
) -> Iterator[Reason]:
    """Yields a symbol that a false equation gives.

    It does if the symbol is new in it and its value depends on two other symbols: D/E + B = C + B says what
    C is. It does, too, if the equation holds for a rate: p = m v and ṗ = m a say that a is the rate of v.
    X = F X + B U gives the next X.

    is_new: whether no earlier formula has a symbol.
    """
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return
    with suppress(IllFormed, OutOfDecisions):
        left, right = expand(statement.left, known), expand(statement.right, known)
        for own in dict.fromkeys(part for part in terms_of(statement) if isinstance(part, Symbol)):
            if own.arguments or own.index or own.declaration.free:
                continue
            if own.declaration not in free_in([own], known):
                continue
            equation = _Equation(left, right, Decider(claim, judge_of, True))
            is_update = own == statement.left and own in statement.right.symbols()
            if is_update or equation.holds_for_rate(own) or (is_new(own) and equation.gives(own)):
                yield DoubtCode.SAYS_WHAT_IS(symbol=to_latex(own))
                return


def is_of_positive_numbers(claim: Claim, known: Definitions, judge_of: JudgeOf) -> bool:
    """True if a false equation of roots and inverse functions is not refuted for positive numbers.

    A cos θ = x holds on one branch only, if A² = x² + y² and tan θ = y/x.
    """
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    with suppress(IllFormed, OutOfDecisions):
        sides = [expand(side, known) for side in (statement.left, statement.right)]
        parts = [part for side in sides for part in side.walk()]
        has_branches = any(map(_has_branches, sides))
        if not has_branches or any(part.type != SCALAR for part in parts):
            return False
        positive = relation("=", *(replaced(side, _squared) for side in sides))
        return Decider(claim, judge_of, True).decide((), positive).outcome is not Outcome.REFUTED
    return False


def _has_branches(term: Term) -> bool:
    """True if the term holds a function of which one branch is meant; the square of a root has one value."""
    match term:
        case Power(base=Apply(head="root" | "norm", arguments=inside), exponent=exponent):
            is_square = exponent.is_number and int(exponent) % 2 == 0
            return not is_square or any(map(_has_branches, inside))
        case Apply(head=head) if head in _OF_BRANCHES:
            return True
    return any(map(_has_branches, term.children))


def doubled(term: Term, own: Declaration) -> Term:
    """Returns the term with 2 x for the symbol x of a declaration."""
    return replaced(term, lambda each: apply("add", each, each) if each.declaration == own else None)


def _squared(own: Symbol) -> Term | None:
    is_number = own.type == SCALAR and not (own.arguments or own.index or own.declaration.clock)
    return power(own, 2) if is_number and not own.declaration.positive else None


class _Equation:
    """A false equation of two terms without defined symbols."""

    def __init__(self, left: Term, right: Term, decider: Decider) -> None:
        self._left, self._right, self._decider = left, right, decider
        self._rest = apply("add", left, apply("neg", right))
        found = (part for part in self._rest.walk() if isinstance(part, Derivative))
        moving = ((each, part.order) for part in found for each in part.symbols())
        self._rates = {derivative(each, order) for each, order in moving if not each.declaration.constant}

    def holds_for_rate(self, own: Symbol) -> bool:
        """True if the equation holds for the symbol as a rate in it."""
        if any(own in rate.symbols() for rate in self._rates):
            return False
        rates = (each for each in self._rates if each.type == own.type)
        return any(
            self._is_true(*(replaced(side, {own: rate}.get) for side in (self._left, self._right)))
            for rate in rates
        )

    def gives(self, own: Symbol) -> bool:
        """True if the equation is k s = e for the symbol s, k ≠ 0, and e / k depends on two other symbols."""
        if any(own in rate.symbols() for rate in self._rates):
            return False
        if self._rest.type != own.type or own.type not in (SCALAR, VECTOR):
            return False
        others = {part.declaration for part in self._rest.symbols()} - {own.declaration}
        if len(others) > _MOST_SYMBOLS:
            return False
        constant = replaced(self._rest, {own: zero(own.type)}.get)
        own_part = apply("add", self._rest, apply("neg", constant))
        twice = replaced(own_part, {own: apply("add", own, own)}.get)
        if not self._is_true(twice, apply("add", own_part, own_part)) or self._is_zero(own_part):
            return False
        if own.type == VECTOR and not self._is_zero(apply("cross", own_part, own)):
            return False
        return sum(self._depends(constant, own_part, own, each) for each in others) > 1

    def _depends(self, constant: Term, own_part: Term, own: Symbol, other: Declaration) -> bool:
        """True if the value e / k of a symbol changes with another symbol."""
        head: Head = "dot" if own.type == VECTOR else "mul"
        here, there = (apply(head, part, own) for part in (own_part, doubled(own_part, other)))
        changed = doubled(constant, other)
        return not self._is_true(apply("mul", here, changed), apply("mul", there, constant))

    def _is_zero(self, term: Term) -> bool:
        return self._is_true(term, zero(term.type))

    def _is_true(self, left: Term, right: Term) -> bool:
        with suppress(IllFormed):
            return self._decider.holds((), relation("=", left, right))
        return False

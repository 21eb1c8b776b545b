"""Refuted equations that may say what their symbols are, in a text without a model."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from workbench.context.claims import Claim, Notation
from workbench.context.facts import Provider
from workbench.context.formula_acts import subject_of
from workbench.context.formula_subject import derived
from workbench.context.free_symbols import names_in, terms_of
from workbench.context.repeated_laws import definitions_in, laws_in, rate_in
from workbench.core.terms import Derivative, Number, Relation, Symbol, Term
from workbench.core.types import PI, Declaration
from workbench.papers.drafting.drafted_definitions import gives_dimension
from workbench.prover.decide.decide import Judge
from workbench.prover.explain.decide_under_facts import Decider

#: Numbers from here on, and decimal fractions, are values of examples.
_FIGURE = 10


def may_say_what_symbols_are(claim: Claim) -> bool:
    """True if an equation gives a sequence, or has no free symbol on both sides and is true for some values.

    An identity relates what stands on both sides; F + G = 0 and AᵀP + PA = -1 rather state a law or a
    condition of the text, and x_n = x_{n-1} + v_n Δt says how x proceeds. F/m = 200/1500 is an example. If no
    value of a single symbol without properties suits, as in i² = -1, the symbol is of another kind than the
    drafted one. [x] = L/T gives the dimension of a number x.
    """
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    if _is_recurrence(statement) or (
        statement.left.type.kind == "scalar" and gives_dimension(claim.printed.latex)
    ):
        return True
    said = definitions_in(claim.context.facts, claim.notation.definitions)
    subject = replace(subject_of(claim, said), laws=laws_in(claim.context.facts))
    left, right = (subject.free_in(side) - {PI} for side in (statement.left, statement.right))
    if not (left or right) or not left.isdisjoint(right):
        return False
    if (_is_figure(statement.left) or _is_figure(statement.right)) and not _is_impossible(claim):
        return True
    if _is_ruled(claim, statement):
        return False
    written = {term.declaration for term in terms_of(statement) if isinstance(term, Symbol)}
    return _is_about_one((left | right) & written) or not _is_impossible(claim)


def _is_impossible(claim: Claim) -> bool:
    return Decider(claim, _judge, True).is_impossible(())


def _is_figure(term: Term) -> bool:
    """True if the term consists of numbers, and one of them is none that an identity has."""
    parts = list(term.walk())
    numbers = [part.value for part in parts if isinstance(part, Number)]
    has_symbol = any(isinstance(part, Symbol) for part in parts)
    return not has_symbol and any(abs(n) >= _FIGURE or n.denominator >= _FIGURE for n in numbers)


def _is_ruled(claim: Claim, statement: Relation) -> bool:
    """True if the text says what the symbols are: a condition of the claim, or a lower rate of a side."""
    facts = claim.context.facts
    laws = [(each.origin.provider, each.content) for each in facts if isinstance(each.content, Relation)]
    names = set(names_in(statement))
    if any(provider is Provider.CONDITION and names & set(names_in(law)) for provider, law in laws):
        return True
    for own, order in map(derived, (statement.left, statement.right)):
        rates = (rate_in(law, own) for _, law in laws if own is not None)
        if any(rate is not None and 0 < rate[0] < order for rate in rates):
            return True
    return False


def _is_about_one(symbols: Collection[Declaration]) -> bool:
    """True for one symbol that may have any value of its kind."""
    return len(symbols) == 1 and not any(
        each.rotation or each.transform or each.unit or each.symmetric for each in symbols
    )


def _is_recurrence(statement: Relation) -> bool:
    """True if the left side is a member of a family, or its rate, and the right side has another member."""
    left = statement.left.body if isinstance(statement.left, Derivative) else statement.left
    if not isinstance(left, Symbol) or not left.index:
        return False
    members = {part for part in statement.right.symbols() if part.index}
    return any(each.declaration == left.declaration and each.index != left.index for each in members)


def _judge(notation: Notation) -> Judge:
    return Judge(notation.definitions, bound=frozenset(each.declaration.name for each in notation.motion))

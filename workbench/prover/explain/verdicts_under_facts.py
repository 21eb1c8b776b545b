"""Verdicts that rest on facts: under them, or that a formula only says what a symbol is."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Notation
from workbench.context.facts import Act, Context, Fact, Provider, Strength, Supposition
from workbench.context.free_symbols import names_in, terms_of
from workbench.context.read_formulas import read_statement
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.hypotheses import Hypothesis
from workbench.core.reasons import Reason
from workbench.core.terms import Definition, Derivative, Relation, Statement, Symbol, Term, sides_of
from workbench.core.verdict import Outcome, Verdict
from workbench.language.printing.printer import to_latex
from workbench.prover.explain.decide_under_facts import Decider

#: No point was found at which the sides of an equation differ.
_NONE_FOUND = frozenset({VerdictCode.NO_COUNTEREXAMPLE, VerdictCode.NOT_FROM_FUNCTIONS})


def under(found: Verdict, core: Sequence[Fact], base: Verdict) -> Verdict:
    """Returns the verdict on a claim that is proved under facts and refuted without them."""
    said = "; ".join(dict.fromkeys(map(str, core)))
    return replace(
        found,
        outcome=Outcome.CONDITIONAL,
        hypothesis=Hypothesis.together((), *(fact.origin.phrase for fact in core)),
        reason=ContextCode.HOLDS_BY(facts=said),
        counterexample=base.counterexample,
        basis=min(fact.strength for fact in core),
    )


def only_said(base: Verdict, act: Act, own: Symbol | None) -> Verdict:
    """Returns the verdict on a formula that claims nothing: its act."""
    name = to_latex(own) if own is not None else "its symbols"
    reason = {
        Act.ASSIGN: ContextCode.ASSIGNS(),
        Act.DEFINE: ContextCode.DEFINES(symbol=name),
        Act.POSTULATE: ContextCode.POSTULATES(symbol=name),
        Act.CONSTRAIN: ContextCode.CONSTRAINS(symbol=name),
    }[act]
    return Verdict(Outcome.DEFINITION, reason=reason, read_back=base.read_back, basis=Strength.STATED)


def unmet_bounds(
    known: Sequence[Fact], pending: Sequence[Fact], decide: Callable[[Sequence[Fact]], Verdict]
) -> Reason | None:
    """Returns the reason that no counterexample was found to meet the stated inequalities among the pending
    facts; None if there are none, or if one was found."""
    bounds = [fact for fact in pending if isinstance(fact.content, Relation) and fact.content.operator == "≥"]
    found = decide([*known, *bounds]) if bounds else None
    if found is None or found.code not in _NONE_FOUND:
        return None
    return ContextCode.NONE_WITHIN_BOUNDS(facts=", ".join(dict.fromkeys(map(str, bounds))))


def undecided_guesses(context: Context, known: Sequence[Fact], decider: Decider) -> list[Fact]:
    """Returns the guesses from other formulas under which no refutation meets the bounds of the text."""
    bounds = [fact.bound for fact in context.facts if fact.bound is not None]
    found: list[Fact] = []
    for group in context.alternatives:
        if all(fact.origin.provider is Provider.FORMULA for fact in group):
            example = decider.decide([*known, *group]).counterexample
            values = example.values if example is not None else None
            if values is None or not all(bound.allows(values) for bound in bounds):
                found += group if decider.is_consistent([*known, *group]) else ()
    return found


def says_what_is(own: Symbol, content: object) -> bool:
    """True if an equation has the symbol alone on a side, or contains no other symbol."""
    if not isinstance(content, Relation) or content.operator != "=":
        return False
    is_alone = (content.left == own) != (content.right == own)
    return is_alone or names_in(content) == {own.declaration.name}


def holds_rate(statement: Statement) -> bool:
    return any(isinstance(part, Derivative) for part in terms_of(statement))


def is_small(facts: Sequence[Fact]) -> bool:
    """True if the facts make a symbol small, so that the claim is meant to first order."""
    suppositions = (fact.content for fact in facts if isinstance(fact.content, Supposition))
    terms = (term for each in suppositions for _, term in each.terms)
    return any(isinstance(term, Symbol) and term.declaration.small for term in terms)


def _words_of(fact: Fact) -> tuple[str, str]:
    """Returns the words of a fact without blanks, and its place."""
    return "".join(fact.origin.text.split()), fact.origin.place


def unmet_statements(
    opaque: Sequence[Fact],
    known: Sequence[Fact],
    notation: Notation,
    decide: Callable[[Sequence[Fact]], Verdict],
) -> list[Fact]:
    """Returns the statements of the text that a refutation does not meet: an equation in another place is met
    if the claim is refuted with it, too."""
    met = {_words_of(fact) for fact in known}
    found = []
    for fact in opaque:
        if fact.origin.provider is Provider.UNREAD:
            if _words_of(fact) in met:
                continue
            with suppress(ReadError, IllFormedAt, ValueError):
                said, ranges = read_statement(fact.origin.text, notation, None)
                if not ranges and decide([*known, replace(fact, content=said)]).outcome is Outcome.REFUTED:
                    continue
        found.append(fact)
    return found


def terms_said(fact: Fact) -> Sequence[Term]:
    """Returns the sides of an equation, or the body of a definition."""
    match fact.content:
        case Definition(body=body):
            return [body]
        case Relation() as said:
            return [*sides_of(said)]
    return ()

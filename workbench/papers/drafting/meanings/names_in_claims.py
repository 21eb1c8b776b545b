"""Names of the symbols in a claim, as a draft spells them."""

from __future__ import annotations

from dataclasses import replace

from workbench.context.claims import Claim
from workbench.context.free_symbols import terms_of
from workbench.core.codes.context_codes import ContextCode
from workbench.core.names import Name
from workbench.core.reasons import Reason
from workbench.core.terms import Block, Relation, Symbol, sides_of
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.meanings.usual_misprints import definitions_of

#: The most definitions that a message names.
_MOST_SYMBOLS = 3


def written(name: Name) -> str:
    """Returns the name as the draft spells it: a function without its arguments."""
    return str(replace(name, parameters=0))


def symbols_of(claim: Claim) -> list[Name]:
    """Returns the names of the symbols that a claim writes, each as often as it is written."""
    statement = claim.printed.statement
    terms = terms_of(statement) if statement is not None else ()
    return [term.declaration.name for term in terms if isinstance(term, Symbol)]


def names_of(claim: Claim) -> list[str]:
    """Returns the symbols that a claim writes, each once."""
    return list(dict.fromkeys(map(written, symbols_of(claim))))


def reached_names(claim: Claim) -> set[str]:
    """Returns the names of a claim's symbols, and of those in their definitions, also those of the text."""
    sides = () if claim.printed.statement is None else sides_of(claim.printed.statement)
    behind = definitions_of(claim).symbols_in(*sides)
    return {*names_of(claim), *(written(each.declaration.name) for each in behind)}


def by_definitions(draft: Draft, claim: Claim) -> Reason | None:
    """Returns the definitions of the symbols of a false claim: one of them may be the misprint."""
    own = {*names_of(claim)}
    given = [each for each in draft.ingested.definitions if each.sure and each.symbol in own]
    told = [f"${each.symbol}$ (line {each.line})" for each in given if each.line != claim.line]
    return ContextCode.BY_DEFINITIONS(symbols=", ".join(told[:_MOST_SYMBOLS])) if told else None


def with_printed_size(claim: Claim) -> str | None:
    """Returns the symbol that a claim equates to a printed matrix, which shows its kind."""
    match claim.printed.statement:
        case Relation(left=Symbol(declaration=own), right=Block()):
            return written(own.name)
    return None

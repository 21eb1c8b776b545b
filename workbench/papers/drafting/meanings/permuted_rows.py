"""Three rows of a display that are one formula with cyclically exchanged labels: 1, 2, 3 or x, y, z."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

from workbench.context.claims import Claim
from workbench.core.codes.context_codes import ContextCode
from workbench.core.construct import symbol
from workbench.core.integer_expressions import Linear
from workbench.core.terms import IllFormed, Relation, Symbol, Term, sides_of
from workbench.core.types import Declaration
from workbench.language.definitions import Definitions, replaced
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.meanings.contradictions import Contradiction, display_of
from workbench.papers.texts.text_paper import TextPaper
from workbench.repair.propose.usual_changes import Nearness, nearness

#: A label in a subscript, and the next one.
_LABEL = re.compile(r"(?<=[_{ ,])(?:[123]|[xyz])(?=[} ,]|$)")
_NEXT = {a: b for labels in ("123", "xyz") for a, b in zip(labels, labels[1:] + labels[0], strict=True)}
_SECONDS_OF_ONE = 0.5


class _Unknown(Exception):
    """The text has no symbol with the next label."""


def contradicted_rows(ingested: Ingested, paper: TextPaper) -> Iterator[Contradiction]:
    """Yields the row of three that differs by one change from what the two others make of it."""
    symbols = {
        str(part.declaration.name): part.declaration
        for claim in paper.claims
        if claim.printed.statement is not None
        for side in sides_of(claim.printed.statement)
        for part in side.symbols()
    }
    for _, own in groupby(paper.claims, key=lambda claim: id(display_of(claim, ingested))):
        rows = [(claim, claim.printed.statement) for claim in own]
        said = [(claim, each) for claim, each in rows if isinstance(each, Relation) and not claim.chain]
        if len(rows) == len(said) == 3:
            yield from _wrong_row(said, symbols)


def _wrong_row(
    rows: Sequence[tuple[Claim, Relation]], symbols: Mapping[str, Declaration]
) -> Iterator[Contradiction]:
    try:
        turned = [Relation("=", *(_turned(side, symbols) for side in sides_of(row))) for _, row in rows]
    except (_Unknown, IllFormed):
        return
    following = [rows[(at + 1) % 3][1] for at in range(3)]
    if any(one.left != other.left for one, other in zip(turned, following, strict=True)):
        return
    found = [_nearness(one, other) for one, other in zip(turned, following, strict=True)]
    for at in range(3):
        if found[at] is Nearness.HOLDS and {found[at - 1], found[at - 2]} == {Nearness.NEAR}:
            (claim, wrong), before = rows[(at + 2) % 3], turned[(at + 1) % 3]
            both = Relation("=", before.right, wrong.right)
            said = f"${to_latex(rows[(at + 1) % 3][1])}$ with other letters"
            reason = ContextCode.GIVEN_OTHERWISE(symbol=f"${to_latex(wrong.left)}$", facts=said)
            yield Contradiction(claim.id, both, (), Definitions(), reason)


def _nearness(made: Relation, printed: Relation) -> Nearness:
    return nearness(Relation("=", made.right, printed.right), Definitions(), seconds=_SECONDS_OF_ONE)


def _turned(term: Term, symbols: Mapping[str, Declaration]) -> Term:
    """Returns a term with the next labels. Raises _Unknown, IllFormed."""

    def change(part: Term) -> Term | None:
        if not isinstance(part, Symbol):
            return None
        name = str(part.declaration.name)
        new = _LABEL.sub(lambda match: _NEXT[match[0]], name)
        index = tuple(_next(each) for each in part.index)
        if new not in symbols:
            raise _Unknown(new)
        return symbol(symbols[new], index, part.arguments) if (new, index) != (name, part.index) else None

    return replaced(term, change)


def _next(index: Linear) -> Linear:
    return Linear(int(index) % 3 + 1) if index.is_number and 1 <= int(index) <= 3 else index

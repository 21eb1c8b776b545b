"""Lines of a formula that is typeset in rows: parts of it that can each be read separately."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from pathlib import Path
from typing import NoReturn

from workbench.core.formula_errors import ReadError, place
from workbench.language.grammar.formula_tokens import MOST_CHARACTERS
from workbench.language.grammar.vocabulary import WORDS
from workbench.source.documents import Display, Row, Source, Token, joined
from workbench.source.documents.tex.tex_tokens import lex
from workbench.source.rewriting.formulas_in_models import with_environments
from workbench.source.rows.chains import bare
from workbench.source.rows.cutter import cut_display, system_in
from workbench.source.rows.display_statements import Cut, Leftover, Role, Statement
from workbench.source.rows.display_tree import Cell, Node, parse, relation_places, rows_of, trim, trimmed
from workbench.source.rows.display_vocabulary import ARROWS, SIDE_RELATIONS, Kind
from workbench.source.rows.side_words import WordRole, lead_of, maths_of, role_of, words_of

_CLOSING = " \t\r\n.,;"
_NARROW = (Kind.GAP, Kind.NOTHING)
_SIGNS = (Kind.RELATION, Kind.INFIX, Kind.SIGN, Kind.IMPLICATION)
_MAPS = ARROWS | {"\\mapsto"}
_CONDITION_OR_EQUATION = (
    "an equation in a further cell: another equation, or the condition of the one before it"
)
_GOES_ON = "the formula goes on behind its condition; write the condition last"
_CONDITION_AND_MORE = (
    "a row and what stands behind all rows are conditions: of which row? write each behind its row"
)
_COLUMNS_WITH_CONDITIONS = "columns of equations with conditions: write one equation a row"


@dataclass(frozen=True)
class Line:
    """One line of a formula, without alignment marks.

    slices: its parts in the whole formula.   premises: the conditions and reasons that words introduce.
    definitions: the equations by which words define its symbols, as in "where f = g^2"."""

    latex: str
    whole: str
    slices: tuple[slice, ...]
    premises: tuple[Line, ...] = ()
    definitions: tuple[Line, ...] = ()

    def place(self, line: int, column: int) -> tuple[int, int]:
        """Returns the line and column in the whole formula of this line's character at (line, column)."""
        left = sum(len(text) + 1 for text in self.latex.split("\n")[: line - 1]) + column - 1
        for piece in self.slices:
            if left < piece.stop - piece.start:
                return place(self.whole, piece.start + left)
            left -= piece.stop - piece.start
        return place(self.whole, self.slices[-1].stop)


def whole_line(latex: str) -> Line:
    return Line(latex, latex, (slice(0, len(latex)),))


def split_lines(latex: str, with_premises: bool = False) -> list[Line]:
    """Returns the lines of a formula: one for each group of rows that the cutter of displays joins.

    The text after an environment of lines (such as ", n \\geq 1") belongs to each of its lines. A map f : A
    \\to B and its value f(x) are one line. Raises ReadError for a layout with two readings.

    with_premises: conditions and reasons in words that the grammar of formulas lacks, such as "since", are
    premises of the lines, as in a display of a text.
    """
    if len(latex) > MOST_CHARACTERS:
        return [whole_line(latex)]
    source = Source(Path(), latex)
    tokens = tuple(with_environments(lex(source.view())))
    nodes = parse(tokens)
    display = Display(source, 0, len(latex), "", "", "", (Row(None, (), tokens),))
    cut = cut_display(display)
    if with_premises and _has_premises_in_words(cut):
        return list(_lines_with_premises(latex, cut))
    rows, behind = _rows(nodes)
    return _Lines(latex, cut, rows, behind).lines() if rows else [whole_line(latex)]


def conditions_without_words(latex: str) -> tuple[Line, tuple[Line, ...]] | None:
    """Returns the formula of A, \\quad C and the equations beside it, which may be its conditions.

    Returns None for a formula of another layout."""
    if len(latex) > MOST_CHARACTERS:
        return None
    source = Source(Path(), latex)
    tokens = tuple(with_environments(lex(source.view())))
    cut = cut_display(Display(source, 0, len(latex), "", "", "", (Row(None, (), tokens),)))
    if not cut.statements or any(each.doubts or each.whole or each.denied for each in cut.statements):
        return None
    first, *others = cut.statements
    sides = [side for each in cut.statements for side in each.beside]
    is_plain = all(side.role is Role.PERHAPS for side in sides) and not cut.remarks
    if not others or not is_plain or not all(first in each.serves for each in others):
        return None
    formula, *conditions = (_line_of(latex, bare(each.nodes)) for each in cut.statements)
    return formula, tuple(conditions)


def _has_premises_in_words(cut: Cut) -> bool:
    """True if words of the cut introduce premises that the grammar of formulas cannot read in their place."""
    sides = [side for each in cut.statements for side in each.beside]
    starts = [each.nodes[0].tokens[0].start for each in cut.statements]
    is_before = any(
        side.role is Role.CONDITION and side.nodes[0].tokens[0].start < min(starts) for side in sides
    )
    words = [node for node in cut.remarks if node.kind is Kind.WORDS]
    defines = any(side.role is Role.DEFINITION for side in sides)
    if any(words_of(node) == "then" for node in words):
        return False  # if C then A
    roles = (WordRole.CONDITION, WordRole.REASON)
    is_unknown = any(
        words_of(node) not in WORDS or "(" in joined(node.tokens) or maths_of(node)
        for node in words
        if role_of(words_of(node)) in roles or lead_of(words_of(node)) is not None
    )
    is_plain = all(side.role in (Role.CONDITION, Role.REASON, Role.DEFINITION) for side in sides)
    is_sure = not any(each.doubts or each.whole or each.is_condition_of for each in cut.statements)
    return bool(sides) and bool(words) and (is_unknown or is_before or defines) and is_plain and is_sure


def _lines_with_premises(latex: str, cut: Cut) -> Iterator[Line]:
    """Yields a line for each step of the statements, with the premises of the step."""
    for statement in (each for each in cut.statements if not each.explains):
        beside = [(side, _line_of(latex, bare(side.nodes))) for side in statement.beside]
        definitions = tuple(line for side, line in beside if side.role is Role.DEFINITION)
        premises = [(side.first, line) for side, line in beside if side.role is not Role.DEFINITION]
        places = relation_places(statement.nodes) if any(first for first, _ in premises) else []
        starts = [0, *(place + 1 for place in places[:-1])]
        ends = [*places[1:], len(statement.nodes)]
        for at, (start, end) in enumerate(zip(starts, ends, strict=True)):
            line = _line_of(latex, statement.nodes[start:end])
            of_step = tuple(premise for first, premise in premises if first <= at)
            yield replace(line, premises=of_step, definitions=definitions)


def _line_of(latex: str, nodes: Sequence[Node]) -> Line:
    marks = (Kind.MARK, Kind.BREAK)
    pieces: list[slice] = []
    for run in _runs([token for node in nodes if node.kind not in marks for token in node.tokens]):
        if pieces and not latex[pieces[-1].stop : run.start].strip():
            run = slice(pieces.pop().start, run.stop)
        pieces.append(run)
    return Line("".join(latex[piece] for piece in pieces), latex, tuple(pieces))


def _rows(nodes: list[Node]) -> tuple[list[list[Cell]], list[Node] | None]:
    """Returns the rows of the formula, and the nodes after their environment; no rows if nothing separates
    them."""
    if any(node.name in _MAPS for node in _flat(nodes)):
        return [], None
    kept = [] if any(node.kind is Kind.BREAK for node in nodes) else trimmed(nodes)
    if not kept or (system := system_in(kept[:1])) is None:
        return rows_of(nodes), None
    behind = nodes[nodes.index(kept[0]) + 1 :]
    first = next((node.kind for node in behind if node.kind not in _NARROW), Kind.STOP)
    is_closed = system.tokens[-1].text == f"\\end{{{system.name}}}"
    is_apart = first in (Kind.COMMA, Kind.WIDE, Kind.STOP, Kind.WORDS)
    return (system.rows, behind) if is_closed and is_apart else ([], None)


def _flat(nodes: Iterable[Node]) -> Iterator[Node]:
    for node in nodes:
        yield node
        if node.kind is Kind.ENVIRONMENT or node.name.startswith("left"):
            yield from _flat(node.inside)


class _Lines:
    """The lines of a formula, from its rows and its cut."""

    def __init__(
        self, latex: str, cut: Cut, rows: Sequence[Sequence[Cell]], behind: Sequence[Node] | None
    ) -> None:
        self._latex, self._cut, self._behind = latex, cut, behind
        self._rows = [[node for cell in row for node in cell] for row in rows]
        self._row_of = {
            id(token): at for at, row in enumerate(self._rows) for node in row for token in node.tokens
        }
        self._stated = {id(each): self._own(each.nodes) for each in cut.statements}
        self._beside = {
            id(each): [
                own
                for side in each.beside
                if side.role not in (Role.PERHAPS, Role.DEFINITION) and (own := self._own(side.nodes))
            ]
            for each in cut.statements
        }
        self._owner = {id(token): number for number, tokens in enumerate(self._parts()) for token in tokens}
        self._shown = list(latex)

    def _own(self, nodes: Iterable[Node]) -> list[Token]:
        """Returns the tokens of the nodes that are in the rows."""
        return [token for node in nodes for token in node.tokens if id(token) in self._row_of]

    def _parts(self) -> Iterator[list[Token]]:
        for each in self._cut.statements:
            yield self._stated[id(each)]
            yield from self._beside[id(each)]

    def lines(self) -> list[Line]:
        self._refuse_doubts()
        groups = list(self._groups())
        self._show(groups)
        is_one = len(groups) == 1 and self._behind is None and "".join(self._shown) == self._latex
        if is_one or not groups:
            return [whole_line(self._latex)]
        return [line for group in groups for line in self._lines_of(group)]

    def _refuse(self, why: str, token: Token) -> NoReturn:
        raise ReadError(why, *place(self._latex, token.start))

    def _refuse_doubts(self) -> None:
        for each in self._cut.statements:
            for doubt in each.doubts:
                self._refuse(doubt.question, each.nodes[min(doubt.at, len(each.nodes) - 1)].tokens[0])
            if each.is_condition_of is not None:
                self._refuse(_CONDITION_OR_EQUATION, each.nodes[0].tokens[0])

    def _groups(self) -> Iterator[range]:
        """Yields the rows of each line, in order; rows without content are in none."""
        ends = list(range(len(self._rows)))
        for each in self._cut.statements:
            held = [
                self._row_of[id(t)]
                for part in (self._stated[id(each)], *self._beside[id(each)])
                for t in part
            ]
            if held:
                ends[min(held)] = max(ends[min(held)], *held)
        at = 0
        while at < len(self._rows):
            start, end = at, ends[at]
            while at <= end:
                end = max(end, ends[at])
                at += 1
            if not all(_says_nothing(row) for row in self._rows[start : end + 1]):
                yield range(start, end + 1)

    def _show(self, groups: Sequence[range]) -> None:
        """Replaces breaks, marks, repeated signs and the punctuation before a break by blanks.

        Commas replace marks and wide spaces between parts.
        """
        for why, nodes in self._cut.leftovers:
            if why is Leftover.REPEATED_SIGN:
                self._hide(nodes)
        for row in self._rows:
            for at, node in enumerate(row):
                if node.kind in (Kind.MARK, Kind.BREAK):
                    self._hide([node])
                if node.kind in (Kind.MARK, Kind.WIDE) and self._parts_two(row, at):
                    self._put_comma(node)
        for above, at in ((at - 1, at) for group in groups for at in group[1:]):
            self._hide(trim(self._rows[above])[1])
            if self._parts_two(
                [*trimmed(self._rows[above]), *self._rows[at]], len(trimmed(self._rows[above]))
            ):
                self._put_comma(self._rows[at][0])
        match [node for node in self._behind or () if node.kind not in _NARROW]:
            case [first, second, *_] if first.kind is Kind.WIDE and second.kind is not Kind.WORDS:
                self._put_comma(first)

    def _hide(self, nodes: Iterable[Node]) -> None:
        for token in (token for node in nodes for token in node.tokens):
            self._shown[token.start : token.end] = " " * (token.end - token.start)

    def _put_comma(self, node: Node) -> None:
        start, end = node.tokens[0].start, node.tokens[-1].end
        if start and self._shown[start - 1].isspace():
            self._shown[start - 1] = ","
        else:
            self._shown[start:end] = f",{' ' * (end - start - 1)}"

    def _parts_two(self, row: Sequence[Node], at: int) -> bool:
        """True if the node at `at` separates two parts of a row, and is not a comma, word or sign."""
        before = next((node for node in reversed(row[:at]) if node.kind not in _NARROW), None)
        behind = next((node for node in row[at + 1 :] if not _is_space(node)), None)
        if before is None or behind is None or _is_space(before):
            return False
        one, other = (self._owner.get(id(node.tokens[0])) for node in (before, behind))
        if one is None or (other is None and behind.kind is not Kind.FORALL):
            return False
        return one != other or not (before.kind in _SIGNS or behind.kind in _SIGNS)

    def _lines_of(self, rows: range) -> list[Line]:
        held = [
            each
            for each in self._cut.statements
            if any(self._row_of[id(t)] in rows for t in self._stated[id(each)])
        ]
        if self._behind is not None and any(
            token.text.strip() for node in self._behind for token in node.tokens
        ):
            self._refuse_rows_that_are_conditions(held)
        spans = [(tokens[0].start, tokens[-1].end) for each in held if (tokens := self._stated[id(each)])]
        if any(end > start for (_, end), (start, _) in pairwise(spans)):
            if any(self._beside[id(each)] for each in held):
                self._refuse(_COLUMNS_WITH_CONDITIONS, self._stated[id(held[0])][0])
            return [self._line(_runs(self._stated[id(each)])) for each in held]
        for each, (start, end) in zip(held, spans, strict=True):
            if any(start < side[0].start < end for side in self._beside[id(each)]):
                self._refuse(_GOES_ON, self._stated[id(each)][-1])
        nodes = [node for at in rows for node in self._rows[at] if node.kind is not Kind.BREAK]
        tokens = [token for node in nodes for token in node.tokens]
        return [self._line([slice(tokens[0].start, tokens[-1].end)])]

    def _refuse_rows_that_are_conditions(self, held: Sequence[Statement]) -> None:
        """Raises ReadError if one of several rows is μ ≠ 0 or the like, and a condition follows all of
        them."""
        for each in held:
            names = {each.nodes[at].name for at in relation_places(each.nodes)}
            if names and names <= SIDE_RELATIONS and len(self._rows) > 1:
                self._refuse(_CONDITION_AND_MORE, self._stated[id(each)][0])

    def _line(self, slices: Sequence[slice]) -> Line:
        text = "".join(self._shown)
        *firsts, last = slices
        said = [token for node in self._behind or () for token in node.tokens]
        behind = [slice(said[0].start, len(self._latex))] if said else []
        pieces = (*firsts, _trimmed(text, last), *behind)
        first = text[pieces[0]]
        pieces = (slice(pieces[0].start + len(first) - len(first.lstrip()), pieces[0].stop), *pieces[1:])
        return Line("".join(text[piece] for piece in pieces), self._latex, pieces)


def _is_space(node: Node) -> bool:
    return node.is_blank or node.kind is Kind.WIDE


def _says_nothing(row: Sequence[Node]) -> bool:
    """True if a row contains only blanks, punctuation and words that join formulas, as \\text{and}."""
    return all(node.kind is Kind.WORDS and role_of(words_of(node)) is WordRole.JOIN for node in trimmed(row))


def _runs(tokens: Sequence[Token]) -> list[slice]:
    """Returns the slices of the tokens: one for adjacent tokens, including a blank after it."""
    runs: list[slice] = []
    for token in tokens:
        if runs and runs[-1].stop >= token.start:
            runs[-1] = slice(runs[-1].start, token.end)
        else:
            runs.append(slice(token.start, token.end))
    return runs


def _trimmed(text: str, piece: slice) -> slice:
    """Returns the slice without punctuation and blanks at its end."""
    start, end = piece.start, piece.stop
    while end > start and text[end - 1] in _CLOSING and text[end - 2] != "\\":
        end -= 1
    return slice(start, end)

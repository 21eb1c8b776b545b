"""A display as its author argues: lines, the formulas of a line, and the steps of a chain a = b = c."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass, replace

from workbench.papers.respell import argument
from workbench.papers.respell.places import FACES, GAPS, MARKS, is_one_symbol
from workbench.papers.text_claims.alignment import (
    EXPLICIT,
    IMPLICATIONS,
    RELATIONS,
    WIDE,
    WORD_COMMANDS,
    Line,
    lines_of,
    top,
    trimmed,
    with_depth,
)
from workbench.papers.text_claims.listed import is_range, with_listed
from workbench.papers.texts import Display, Token, joined, spelled

_CONDITIONS = frozenset(["<", ">", "\\le", "\\leq", "\\ge", "\\geq", "\\lt", "\\gt", "\\in", "\\neq", "\\ne"])
_UNEQUAL = frozenset({"\\neq", "\\ne"})
_BETWEEN = WIDE | {",", ";", "\\&"}
_SEPARATING = frozenset((
    "", "and", "where", "with", "for", "for all", "so", "so that", "thus", "hence", "therefore",
    "and therefore", "\\&",
))  # fmt: skip
#: Words that some write as if they were a symbol.
_UPRIGHT = frozenset({"and", "or", "if", "where"})
_UPRIGHT_FACES = frozenset({"\\mathrm", "\\operatorname", "\\mathit"})
_JOINING = frozenset({"or", "if", "if and only if", "iff", "when", "unless", "implies", "provided", "either"})


@dataclass(frozen=True)
class Step:
    """One relation, with the conditions of its line. `own`: what it adds to the step before, all for the
    first. `assumed`: conditions a ≠ b beside it. `ranges`: those that say where its symbols are, as i ≥ 1 and
    x ∈ [0, 1] do, with which the tokens end. `number` and `labels`: of the row that it ends in."""

    tokens: tuple[Token, ...]
    own: tuple[Token, ...]
    assumed: tuple[tuple[Token, ...], ...]
    ranges: tuple[tuple[Token, ...], ...]
    number: str | None
    labels: tuple[str, ...]

    def spelled(self) -> tuple[str, list[Token]]:
        return spelled(self.tokens)

    def without_ranges(self) -> Step:
        count = sum(1 + len(piece) for piece in self.ranges)  # and a comma before each
        return replace(self, tokens=self.tokens[: len(self.tokens) - count], ranges=())


def steps_of(display: Display, words: Collection[str] = ()) -> list[list[Step]]:
    """The lines of the display that say something, each as its steps. words: functions that it writes without
    their backslash."""
    return [steps for line in lines_of(display, words) if (steps := list(_steps(line)))]


def _steps(line: Line) -> Iterator[Step]:
    tokens = _without_braces(line.tokens)
    while tokens and tokens[0].text in IMPLICATIONS | {"="}:  # what goes on from before is judged by itself
        tokens = trimmed(tokens[1:])
    rows = list(line.rows)
    for clause in _clauses(tokens) if tokens else ():
        ranges = [token for piece in clause.ranges for token in (piece[0].standing_for(","), *piece)]
        for step, own in _chain(clause.tokens, ranges):
            ends = {id(token) for token in step}
            while len(rows) > 1 and (
                rows[0][1] is None or any(id(token) in ends for token, _, _ in rows[1:])
            ):
                rows.pop(0)
            beside = [tuple(map(tuple, pieces)) for pieces in (clause.assumed, clause.ranges)]
            yield Step(tuple(step), tuple(own), *beside, rows[0][1], rows[0][2])


def _without_braces(tokens: list[Token]) -> list[Token]:
    """{a = b} prints a = b."""
    if not tokens or tokens[0].text != "{":
        return tokens
    inside, end = argument(tokens, 0)
    is_formula = end == len(tokens) and any(token.text in RELATIONS for token in top(inside))
    return _without_braces(trimmed(inside)) if is_formula else tokens


@dataclass
class _Clause:
    """A formula with the ranges of its integers, and the equations and ≠ under which it is said."""

    tokens: list[Token]
    ranges: list[list[Token]]
    assumed: list[list[Token]]


def _clauses(tokens: list[Token]) -> list[_Clause]:
    """Each formula of a line with the conditions beside it. A line with a piece that relates nothing stays as
    it is: the reader knows more of lists than this does."""
    whole = [_Clause(tokens, [], [])]
    pieces = list(with_listed(list(_pieces(tokens)), tokens))
    relations = [{token.text for token in top(piece) if token.text in RELATIONS} for piece in pieces]
    if _joins(tokens) or not all(relations):
        return whole
    clauses: list[_Clause] = []
    waiting = _Clause([], [], [])
    conditions = _behind_for(tokens)
    for piece, signs in zip(pieces, relations, strict=True):
        target = clauses[-1] if clauses else waiting
        if clauses and id(piece[0]) in conditions and not is_range(piece):
            target.assumed.append(piece)
        elif signs - _CONDITIONS and not is_range(piece):
            clauses.append(_Clause(piece, waiting.ranges, waiting.assumed))
            waiting = _Clause([], [], [])
        elif signs <= _UNEQUAL:
            target.assumed.append(piece)
        else:
            target.ranges.append(piece)
    return clauses or whole


def _behind_for(tokens: list[Token]) -> set[int]:
    """The first tokens of what stands behind a "for": a = b for c = d says a = b under that condition."""
    found: set[int] = set()
    for place, (_, depth) in enumerate(with_depth(tokens)):
        if depth == 0 and _words(tokens, place) in ("for", "for all"):
            behind = trimmed(tokens[argument(tokens, place + 1)[1] :])
            found |= {id(token) for token in behind[:1]}
    return found


def _joins(tokens: Sequence[Token]) -> bool:
    """Whether the line says more than one formula after the other: an implication, "if", "or"."""
    for place, (token, depth) in enumerate(with_depth(tokens)):
        if depth == 0 and token.text in IMPLICATIONS:
            return True
        if depth == 0 and _words(tokens, place) in _JOINING:
            return True
    return False


def _words(tokens: Sequence[Token], place: int) -> str | None:
    """What the \\text at `place` says; None if it is part of a name, as in x_\\text{max}."""
    command = tokens[place].text
    if command not in WORD_COMMANDS | {"\\mathrm"} or (place and tokens[place - 1].text in ("_", "^")):
        return None
    words = joined(argument(tokens, place + 1)[0])
    if command == "\\mathrm" and words not in _UPRIGHT:
        return None
    return " ".join(words.replace(",", " ").replace(".", " ").replace(";", " ").lower().split())


def _pieces(tokens: list[Token]) -> Iterator[list[Token]]:
    """What stands between commas, wide spaces and words that join."""
    piece: list[Token] = []
    skip_to = -1
    for place, (token, depth) in enumerate(with_depth(tokens)):
        if place < skip_to:
            continue
        if token.text in WIDE and not depth and (before := trimmed(piece)) and before[-1].text in RELATIONS:
            continue  # a gap behind a sign
        behind_column = depth == 0 and token.text in EXPLICIT and _ends_a_column(tokens[:place])
        is_word = depth == 0 and _words(tokens, place) in _SEPARATING
        if is_word or (depth == 0 and token.text in _BETWEEN) or behind_column:
            if is_word:
                _, skip_to = argument(tokens, place + 1)
            if piece := trimmed(piece):
                yield piece
            piece = []
        else:
            piece.append(token)
    if piece := trimmed(piece):
        yield piece


def _ends_a_column(tokens: Sequence[Token]) -> bool:
    """Whether a literal column stands last, which is a factor of nothing behind it."""
    tokens = trimmed(tokens)
    if not tokens or not tokens[-1].text.startswith("\\end{") or "matrix" not in tokens[-1].text:
        return False
    opening = tokens[-1].text.replace("\\end", "\\begin")
    start = max(place for place, token in enumerate(tokens) if token.text == opening)
    return all(token.text != "&" for token in tokens[start:])


def _chain(tokens: list[Token], conditions: list[Token]) -> Iterator[tuple[list[Token], list[Token]]]:
    """a = b = c as a = b and b = c, each with what it adds to the one before."""
    sides: list[list[Token]] = [[]]
    signs: list[list[Token]] = []
    if _joins(tokens):
        yield [*tokens, *conditions], tokens
        return
    skip_to = -1
    for place, (token, depth) in enumerate(with_depth(tokens)):
        if place < skip_to:
            continue
        if depth == 0 and token.text in RELATIONS:
            sign, skip_to = _sign(tokens, place)
            signs.append(sign)
            sides.append([])
        else:
            sides[-1].append(token)
    sides = [trimmed(side) for side in sides]
    while signs and not sides[-1]:  # with nothing behind it, as it ends a row that nothing follows
        sides.pop()
        tokens = tokens[: next(at for at, token in enumerate(tokens) if token is signs[-1][0])]
        signs.pop()
    for place in range(len(signs) - 1, 0, -1):  # an = at the end of a row, and again before the next
        if not sides[place] and signs[place][0].text == signs[place - 1][0].text:
            del sides[place], signs[place]
            tokens = [*sides[0], *signs[0], *sides[1]] if len(signs) == 1 else tokens
    if len(signs) == 1 and _names(sides[0], sides[1], signs[0]):
        tokens = [*sides[0], signs[0][0].standing_for(":="), *sides[1]]
    if len(signs) == 1 and sides[0] and _is_constant(sides[1], signs[0]):
        tokens = _at_rest(sides[0], signs[0])
    if len(signs) < 2:
        yield [*tokens, *conditions], tokens
        return
    for place, (sign, left, right) in enumerate(zip(signs, sides, sides[1:], strict=False)):
        added = [*sign, *right]
        if left and _is_constant(right, sign):
            yield [*_at_rest(left, sign), *conditions], added
            continue
        yield [*left, *added, *conditions], added if place else [*left, *added]


def _sign(tokens: list[Token], place: int) -> tuple[list[Token], int]:
    """The relation at `place`, and the place behind it: := and \\stackrel{def}{=} are one sign."""
    token = tokens[place]
    if token.text in ("\\stackrel", "\\overset"):
        _, end = argument(tokens, place + 1)
        _, end = argument(tokens, end)
        return tokens[place:end], end
    return [token], place + 1


def _is_constant(right: Sequence[Token], sign: Sequence[Token]) -> bool:
    """Whether a side is the word: a = const."""
    if (
        sign[0].text not in ("=", "\\equiv")
        or not right
        or right[0].text not in WORD_COMMANDS | _UPRIGHT_FACES
    ):
        return False
    words, end = argument(right, 1)
    return end == len(right) and joined(words).strip(" .,").lower() in ("const", "constant")


def _at_rest(left: Sequence[Token], sign: Sequence[Token]) -> list[Token]:
    """That the left side is constant: its rate is 0."""
    rate = [left[0].standing_for(text) for text in ("\\frac", "{", "d", "}", "{", "d", "t", "}", "(")]
    return [*rate, *left, *(sign[0].standing_for(text) for text in (")", "=", "0"))]


def _names(left: Sequence[Token], right: Sequence[Token], sign: Sequence[Token]) -> bool:
    """Whether x \\equiv … says what x is, and not that two things count as one, as in q \\equiv -q."""
    if sign[0].text != "\\equiv" or not is_one_symbol(left):
        return False
    letters = {token.text for token in left} - FACES - MARKS - GAPS - {"_", "^", "{", "}"}
    return letters.isdisjoint(token.text for token in right)

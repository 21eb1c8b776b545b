"""A display as its author argues: lines, the formulas of a line, and the steps of a chain a = b = c."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

from workbench.papers.respelling import argument, respelled
from workbench.papers.texts import Display, Token, joined, spelled

_LINES = frozenset(
    [
        "aligned",
        "alignedat",
        "split",
        "gathered",
        "cases",
        "dcases",
        "rcases",
        "align",
        "align*",
        "gather",
        "gather*",
        "array",
        "equation",
        "equation*",
        "multlined",
    ]
)
_EQUALITIES = frozenset({"=", ":=", "\\equiv", "\\stackrel", "\\overset"})
_OTHERS = frozenset(
    [
        "\\neq",
        "\\ne",
        "\\approx",
        "\\simeq",
        "\\sim",
        "\\propto",
        "<",
        ">",
        "\\le",
        "\\leq",
        "\\ge",
        "\\geq",
        "\\lt",
        "\\gt",
        "\\in",
        "\\to",
        "\\mapsto",
        "\\ll",
        "\\gg",
        "\\cong",
        "\\doteq",
        "\\subset",
        "\\rightarrow",
    ]
)
_RELATIONS = _EQUALITIES | _OTHERS
_CONDITIONS = frozenset(["<", ">", "\\le", "\\leq", "\\ge", "\\geq", "\\lt", "\\gt", "\\in", "\\neq", "\\ne"])
_IMPLICATIONS = frozenset(
    [
        "\\Rightarrow",
        "\\Leftrightarrow",
        "\\implies",
        "\\iff",
        "\\Longrightarrow",
        "\\Longleftrightarrow",
        "\\Leftarrow",
        "\\impliedby",
        "\\Longleftarrow",
    ]
)
_INFIX = frozenset({"\\cdot", "\\times", "\\wedge", "\\otimes", "\\circ"})
_WORD_COMMANDS = frozenset({"\\text", "\\mbox", "\\textrm", "\\textit", "\\textnormal", "\\hbox"})
_SPACES = frozenset({" ", "\\,", "\\;", "\\:", "\\!", "\\ ", "~", "\\>", "\\par", "\\enspace", "\\thinspace"})
_UNEQUAL = frozenset({"\\neq", "\\ne"})
_SEPARATING = frozenset(
    {
        "",
        "and",
        "where",
        "with",
        "for",
        "for all",
        "so",
        "so that",
        "thus",
        "hence",
        "therefore",
        "and therefore",
    }
)
_JOINING = frozenset({"or", "if", "if and only if", "iff", "when", "unless", "implies", "provided", "either"})
_WIDE = frozenset({"\\quad", "\\qquad", "\\hspace"})
_OPEN, _CLOSE = frozenset("([{"), frozenset(")]}")
_ENDS = frozenset({".", ",", ";"})


@dataclass(frozen=True)
class Step:
    """One relation, with the conditions of its line. `own`: what it adds to the step before, all for the
    first. `assumed`: conditions a ≠ b beside it. `number` and `labels`: of the row that it ends in."""

    tokens: tuple[Token, ...]
    own: tuple[Token, ...]
    assumed: tuple[tuple[Token, ...], ...]
    number: str | None
    labels: tuple[str, ...]

    def spelled(self) -> tuple[str, list[Token]]:
        return spelled(self.tokens)


@dataclass
class _Line:
    """`rows`: of each of its rows the last token, the number and labels. `opens`: whether it begins behind an
    alignment mark, as what goes on with the line before does."""

    tokens: list[Token]
    rows: list[tuple[Token, str | None, tuple[str, ...]]]
    opens: bool = False


def steps_of(display: Display, words: Collection[str] = ()) -> list[list[Step]]:
    """The lines of the display that say something, each as its steps. words: functions that it writes without
    their backslash."""
    return [steps for line in _lines(display, words) if (steps := list(_steps(line)))]


def _lines(display: Display, words: Collection[str]) -> list[_Line]:
    made: list[_Line] = []
    in_column: dict[int, _Line] = {}
    several = len(display.rows) > 1
    for row in display.rows:
        tokens = respelled(row.tokens, words)
        inner = None if several else _inside(tokens)
        for piece in [tokens] if inner is None else _split(inner, "\\\\"):
            for column, (cell, opens) in enumerate(_columns(piece)):
                cell = _trimmed(cell)
                if not cell:
                    continue
                line = _Line(cell, [(cell[-1], row.number, row.labels)], opens)
                before = in_column.get(column)
                if before is not None and _goes_on(before, line):
                    before.tokens += [line.tokens[0].standing_for(" "), *line.tokens]
                    before.rows += line.rows
                else:
                    made.append(line)
                    in_column[column] = line
    return made


def _inside(tokens: list[Token]) -> list[Token] | None:
    """The rows inside of the one environment of lines that the tokens are; None if they are not one."""
    tokens = _stripped(tokens)
    if len(tokens) > 2 and tokens[0].text == "\\left" and tokens[-2].text == "\\right":
        tokens = _stripped(tokens[2:-2]) if tokens[1].text == "\\{" else tokens
    name = _environment(tokens[0]) if tokens else None
    if name is None or name not in _LINES:
        return tokens if any(token.text == "\\\\" for token in _top(tokens)) else None
    depth = 0
    for place, token in enumerate(tokens):
        depth += token.text.startswith("\\begin{") - token.text.startswith("\\end{")
        if depth == 0:
            if place < len(tokens) - 1 and any(each.text not in _ENDS for each in tokens[place + 1 :]):
                return None
            inner = tokens[1:place]
            if name in ("array", "alignedat"):
                inner = inner[argument(inner, 0)[1] :]
            return _inside(inner) or inner
    return None


def _goes_on(before: _Line, line: _Line) -> bool:
    begins = line.tokens[0].text
    if begins in _IMPLICATIONS:
        return False
    if begins in _RELATIONS | _INFIX or _stripped(before.tokens)[-1].text in _RELATIONS | _INFIX | {"+", "-"}:
        return True
    if _left_open(before.tokens):
        return True
    has_relation = any(token.text in _RELATIONS for token in _top(line.tokens))
    return begins in ("+", "-") and (line.opens or not has_relation)


def _columns(tokens: list[Token]) -> list[tuple[list[Token], bool]]:
    """The formulas of a row, parted by every second alignment mark, and whether each begins behind one."""
    cells: list[tuple[list[Token], bool]] = [([], False)]
    marks = 0
    for token, depth in _with_depth(tokens):
        cell, _ = cells[-1]
        if token.text != "&" or depth:
            cell.append(token)
            continue
        marks += 1
        if marks % 2 == 0:
            cells.append(([], False))
        elif not _stripped(cell):
            cells[-1] = (cell, True)
    return cells


def _steps(line: _Line) -> Iterator[Step]:
    tokens = line.tokens
    while tokens and tokens[0].text in _IMPLICATIONS:  # what follows from the line before is judged by itself
        tokens = _trimmed(tokens[1:])
    rows = list(line.rows)
    for clause in _clauses(tokens) if tokens else ():
        for step, own in _chain(clause.tokens, clause.ranges):
            ends = {id(token) for token in step}
            while len(rows) > 1 and (
                rows[0][1] is None or any(id(token) in ends for token, _, _ in rows[1:])
            ):
                rows.pop(0)
            assumed = tuple(tuple(piece) for piece in clause.assumed)
            yield Step(tuple(step), tuple(own), assumed, rows[0][1], rows[0][2])


@dataclass
class _Clause:
    """A formula with the ranges of its integers, and what it says to be different from something."""

    tokens: list[Token]
    ranges: list[Token]
    assumed: list[list[Token]]


def _clauses(tokens: list[Token]) -> list[_Clause]:
    """Each formula of a line with the conditions beside it. A line with a piece that relates nothing stays as
    it is: the reader knows more of lists than this does."""
    whole = [_Clause(tokens, [], [])]
    pieces = list(_pieces(tokens))
    relations = [{token.text for token in _top(piece) if token.text in _RELATIONS} for piece in pieces]
    if _joins(tokens) or not all(relations):
        return whole
    clauses: list[_Clause] = []
    waiting = _Clause([], [], [])
    for piece, signs in zip(pieces, relations, strict=True):
        target = clauses[-1] if clauses else waiting
        if signs - _CONDITIONS:
            clauses.append(_Clause(piece, waiting.ranges, waiting.assumed))
            waiting = _Clause([], [], [])
        elif signs <= _UNEQUAL:
            target.assumed.append(piece)
        else:
            target.ranges += [piece[0].standing_for(","), *piece]
    return clauses or whole


def _joins(tokens: Sequence[Token]) -> bool:
    """Whether the line says more than one formula after the other: an implication, "if", "or"."""
    for place, (token, depth) in enumerate(_with_depth(tokens)):
        if depth == 0 and token.text in _IMPLICATIONS:
            return True
        if depth == 0 and token.text in _WORD_COMMANDS and _words(tokens, place) in _JOINING:
            return True
    return False


def _words(tokens: Sequence[Token], place: int) -> str | None:
    """What the \\text at `place` says; None if it is part of a name, as in x_\\text{max}."""
    if place and tokens[place - 1].text in ("_", "^"):
        return None
    words = joined(argument(tokens, place + 1)[0])
    return " ".join(words.replace(",", " ").replace(".", " ").replace(";", " ").lower().split())


def _pieces(tokens: list[Token]) -> Iterator[list[Token]]:
    """What stands between commas, wide spaces and words that join."""
    piece: list[Token] = []
    skip_to = -1
    for place, (token, depth) in enumerate(_with_depth(tokens)):
        if place < skip_to:
            continue
        is_word = depth == 0 and token.text in _WORD_COMMANDS and _words(tokens, place) in _SEPARATING
        if is_word or (depth == 0 and (token.text in (",", ";") or token.text in _WIDE)):
            if is_word:
                _, skip_to = argument(tokens, place + 1)
            if piece := _trimmed(piece):
                yield piece
            piece = []
        else:
            piece.append(token)
    if piece := _trimmed(piece):
        yield piece


def _chain(tokens: list[Token], conditions: list[Token]) -> Iterator[tuple[list[Token], list[Token]]]:
    """a = b = c as a = b and b = c, each with what it adds to the one before."""
    sides: list[list[Token]] = [[]]
    signs: list[list[Token]] = []
    if _joins(tokens):
        yield [*tokens, *conditions], tokens
        return
    skip_to = -1
    for place, (token, depth) in enumerate(_with_depth(tokens)):
        if place < skip_to:
            continue
        if depth == 0 and token.text in _RELATIONS:
            sign, skip_to = _sign(tokens, place)
            signs.append(sign)
            sides.append([])
        else:
            sides[-1].append(token)
    sides = [_trimmed(side) for side in sides]
    if len(signs) < 2:
        yield [*tokens, *conditions], tokens
        return
    for place, (sign, left, right) in enumerate(zip(signs, sides, sides[1:], strict=False)):
        added = [*sign, *right]
        yield [*left, *added, *conditions], added if place else [*left, *added]


def _sign(tokens: list[Token], place: int) -> tuple[list[Token], int]:
    """The relation at `place`, and the place behind it: := and \\stackrel{def}{=} are one sign."""
    token = tokens[place]
    if token.text in ("\\stackrel", "\\overset"):
        _, end = argument(tokens, place + 1)
        _, end = argument(tokens, end)
        return tokens[place:end], end
    return [token], place + 1


def _environment(token: Token) -> str | None:
    return token.text[7:-1] if token.text.startswith("\\begin{") else None


def _with_depth(tokens: Sequence[Token]) -> Iterator[tuple[Token, int]]:
    """Each token with the number of brackets and environments around it."""
    depth = 0
    for token in tokens:
        text = token.text
        if text.startswith("\\end{") or text in _CLOSE or text in ("\\}", "\\rangle"):
            depth = max(0, depth - 1)
        yield token, depth
        if text.startswith("\\begin{") or text in _OPEN or text in ("\\{", "\\langle"):
            depth += 1


def _top(tokens: Sequence[Token]) -> Iterator[Token]:
    return (token for token, depth in _with_depth(tokens) if depth == 0)


def _left_open(tokens: Sequence[Token]) -> bool:
    texts = [token.text for token in tokens]
    return texts.count("\\left") > texts.count("\\right")


def _split(tokens: Sequence[Token], mark: str) -> list[list[Token]]:
    rows: list[list[Token]] = [[]]
    for token, depth in _with_depth(tokens):
        if depth == 0 and token.text == mark:
            rows.append([])
        else:
            rows[-1].append(token)
    return [_without_length(row) for row in rows]


def _without_length(row: list[Token]) -> list[Token]:
    """Without the [2pt] of \\\\[2pt]."""
    if row and row[0].text == "[":
        texts = joined(row[:12])
        length, bracket, _ = texts[1:].partition("]")
        if bracket and length.strip()[-2:] in ("pt", "ex", "em", "mm", "cm"):
            end = next(place for place, token in enumerate(row) if token.text == "]")
            return row[end + 1 :]
    return row


def _stripped(tokens: Sequence[Token]) -> list[Token]:
    first, last = 0, len(tokens)
    while first < last and tokens[first].text in _SPACES:
        first += 1
    while first < last and tokens[last - 1].text in _SPACES:
        last -= 1
    return list(tokens[first:last])


def _trimmed(tokens: Sequence[Token]) -> list[Token]:
    """Without spaces around, and without the punctuation at the end, which may stand in a \\text."""
    tokens = _stripped(tokens)
    while tokens:
        is_ellipsis = [token.text for token in tokens[-2:]] == [".", "."]
        if tokens[-1].text in _ENDS | _WIDE and not is_ellipsis:
            tokens = _stripped(tokens[:-1])
        elif tokens[0].text in _WIDE | {",", ";"}:
            tokens = _stripped(tokens[1:])
        elif len(tokens) > 3 and tokens[-1].text == "}" and (start := _closing_words(tokens)) is not None:
            tokens = _stripped(tokens[:start])
        else:
            return tokens
    return tokens


def _closing_words(tokens: list[Token]) -> int | None:
    """Where a last \\text{.} begins."""
    for start in range(len(tokens) - 2, max(-1, len(tokens) - 8), -1):
        if tokens[start].text in _WORD_COMMANDS:
            inside = joined(tokens[start + 2 : -1]).strip()
            return start if all(character in " .,;:" for character in inside) else None
    return None

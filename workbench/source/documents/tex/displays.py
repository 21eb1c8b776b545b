"""One display: its tokens with macros expanded, row by row, with the number of each row."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from workbench.source.documents.source_view import Source
from workbench.source.documents.surrounding_words import sentence_before
from workbench.source.documents.tex.expander import Expander
from workbench.source.documents.tex.expander_state import Names
from workbench.source.documents.tex.groups import CELL, FORMULA, end_mark, has_cells
from workbench.source.documents.tex.groups import environment as group_of
from workbench.source.documents.tex.numbering import Counters
from workbench.source.documents.tex.tex_tokens import PARAGRAPH, Call, Token, joined, spelled
from workbench.source.documents.tex.unprinted import is_unprinted, skip_environment

#: Environments whose rows are numbered separately, and those with one number.
ROWS = frozenset(
    {"align", "gather", "eqnarray", "subeqnarray", "IEEEeqnarray", "flalign", "alignat", "xalignat", "dgroup"}
)
NUMBERED = ROWS | {"equation", "multline", "dmath"}
DISPLAYS = NUMBERED | {f"{name}*" for name in NUMBERED} | {"displaymath", "empheq"}
CLOSING = {"$$": "$$", "\\[": "\\]", "$": "$", "\\(": "\\)"}
INLINE = frozenset({"$", "\\("})
_UNNUMBERED = frozenset({"\\notag", "\\nonumber", "\\IEEEnonumber"})
_ON, _ON_LETTER = "\\IEEEyesnumber", "\\IEEEyessubnumber"
_MARKS = _UNNUMBERED | {_ON, _ON_LETTER, "\\IEEEnosubnumber", "\\displaybreak", "\\allowdisplaybreaks"}
_WORDS = frozenset({"text", "mbox", "hbox", "textrm", "textit", "textbf", "textnormal", "intertext"})
_NUMBER = re.compile(r"\s*(-?\d{1,6})\s*")

#: Limit on the tokens of one display; a longer one was never closed.
MOST_TOKENS = 100_000


@dataclass(frozen=True)
class Row:
    number: str | None
    labels: tuple[str, ...]
    tokens: tuple[Token, ...]

    @cached_property
    def latex(self) -> str:
        return joined(self.tokens)


@dataclass(frozen=True)
class Display:
    """One display.

    start, end: offsets in the author's file.   opaque: macros in it that could not be expanded.
    warnings: each with the token that it is about.
    """

    source: Source
    start: int
    end: int
    environment: str
    section: str
    heading: str
    rows: tuple[Row, ...]
    opaque: frozenset[str] = frozenset()
    warnings: tuple[tuple[Token, str], ...] = ()

    @property
    def line(self) -> int:
        return self.source.place(self.start)[0]

    @property
    def before(self) -> str:
        """The sentence before the display."""
        return sentence_before(self.source.prose, self.start)

    @property
    def labels(self) -> tuple[str, ...]:
        return tuple(label for row in self.rows for label in row.labels)

    @property
    def numbers(self) -> tuple[str, ...]:
        return tuple(row.number for row in self.rows if row.number is not None)

    @property
    def latex(self) -> str:
        """The LaTeX without labels and numbering marks; rows are joined by \\\\."""
        return spelled(self.tokens)[0]

    @cached_property
    def tokens(self) -> tuple[Token, ...]:
        made: list[Token] = []
        for row in self.rows:
            if made and row.tokens:
                made.append(row.tokens[0].standing_for("\\\\"))
            made += row.tokens
        return tuple(made)


@dataclass
class _Row:
    tokens: list[Token] = field(default_factory=list)
    labels: list[tuple[str, bool]] = field(
        default_factory=list
    )  # labels, with True if the number includes the letter
    tag: str | None = None
    marks: set[str] = field(default_factory=set)


class DisplayReader(Expander):
    """An expander that counts equations."""

    def __init__(self, overrides: Names | None = None) -> None:
        super().__init__(overrides)
        self.formulas_are_groups = True
        self.counters = Counters()
        self.labels: dict[str, str | None] = {}
        self.heading = ""
        self.letter = 0

    def lettered(self, number: str) -> str:
        self.letter += 1
        return f"{number}{chr(96 + min(self.letter, 26))}"

    def count(self, token: Token) -> None:
        """Executes \\setcounter and similar commands."""
        name = self.word()
        if token.word in ("stepcounter", "refstepcounter"):
            self.counters.step(name)
        elif match := _NUMBER.fullmatch(self.counters.text(self.word().replace("\\value", "\\arabic"))):
            self.counters.set(name, int(match[1]), add=token.word == "addtocounter")


def read_display(reader: DisplayReader, opening: Token, environment: str) -> Display:
    """Returns the display from `opening` to its end, and moves past the end."""
    if environment.startswith(("IEEEeqnarray", "alignat", "xalignat")):
        reader.optional()
        reader.argument()
    numbering = environment
    if environment == "empheq":
        reader.optional()
        numbering = joined(reader.argument()).strip()
    reader.in_formula, reader.left_opaque = True, set()
    told, around = len(reader.warnings), len(reader.groups)
    body = _Body(reader, opening, environment, numbering)
    if reader.formulas_are_groups:
        reader.groups.begin(FORMULA)
        reader.groups.begin(CELL) if has_cells(numbering) else None
    body.read()
    reader.end_groups_to(around)
    reader.in_formula = False
    rows = _numbered(reader, body.rows, numbering)
    end = body.last.end if body.last.source is opening.source else opening.end
    return Display(
        source=opening.source,
        start=opening.start,
        end=max(end, opening.end),
        environment=environment,
        section=reader.counters.section(),
        heading=reader.heading,
        rows=tuple(row for row in rows if row.tokens) or rows[:1],
        opaque=frozenset(reader.left_opaque),
        warnings=tuple(reader.warnings[told:]),
    )


class _Body:
    """The tokens up to the display's end."""

    def __init__(self, reader: DisplayReader, opening: Token, environment: str, numbering: str) -> None:
        self.reader, self.environment, self.last = reader, environment, opening
        self.opening = opening
        self.closing = CLOSING.get(environment)
        self.splits = numbering.rstrip("*") in ROWS
        self.rows = [_Row()]
        self.depth = 0
        self.count = 0

    def read(self) -> None:
        reader, opening = self.reader, self.opening
        while (token := reader.pop()) is not None:
            if token.source is opening.source and token.call is None:
                self.last = token
            if token.text == self.closing or (
                self.closing == "$$" and token.text == "$" and reader.take("$")
            ):
                return self._closed(token)
            if token.text in ("\\begin", "\\end"):
                if self._environment(token):
                    return
            elif self._is_end_of_file(token):
                break
            elif not self._command(token) and not reader.step(token):
                self._keep(token)
            if self.count > MOST_TOKENS:
                reader.warn(opening, f"a display of more than {MOST_TOKENS} tokens; its rest is skipped")
                self._skip()
                return
        reader.warn(opening, f"the display that opens with {opening.text} is never closed")

    def _closed(self, token: Token) -> None:
        if self.depth != 0:
            self.reader.warn(token, "braces or environments of a display that do not close one another")

    def _is_end_of_file(self, token: Token) -> bool:
        """True if the token shows that the display was never closed: sections cannot occur in a display."""
        if token.word in ("section", "chapter", "subsection", "documentclass", "bibliography"):
            self.reader.push([token])
            return True
        return False

    def _skip(self) -> None:
        mark = self.closing or f"\\end{{{self.environment}}}"
        while self.reader.waiting and (lexer := self.reader.lexer()) is None:
            self.reader.waiting.pop()
        if lexer is not None:
            lexer.skip_past(mark)

    def _environment(self, token: Token) -> bool:
        """Handles \\begin and \\end; True if it is the end of the display."""
        reader, is_begin = self.reader, token.text == "\\begin"
        name = reader.word()
        if not is_begin and name == self.environment:
            self.last = self._closing_brace(token)
            self._closed(token)
            return True
        if is_begin and name in DISPLAYS and self.environment in DISPLAYS:
            reader.warn(self.opening, f"\\begin{{{self.environment}}} is never closed")
            reader.push([token.standing_for(part) for part in ("\\begin", "{", name, "}")])
            return True
        if is_begin and is_unprinted(reader, name):
            skip_environment(reader, name)
            return False
        declared = reader.names.environments.get(name)
        if declared is not None:
            if is_begin:
                reader.begin_environment(name)
                reader.expand(token.standing_for(f"\\{name}"), declared.begin)
            else:
                call = Call(name, token.call, 1)
                parts = declared.end.body
                made = [Token(p.text, token.source, token.start, token.end, call) for p in parts]
                reader.push([*made, end_mark(token, group_of(name))])
            return False
        if not is_begin and self.depth <= 0:
            reader.warn(token, f"\\end{{{name}}} closes nothing here")
            if name == "document":
                reader.push([token.standing_for(part) for part in ("\\end", "{", name, "}")])
                return True
            return False
        self.depth += 1 if is_begin else -1
        self._keep(token.standing_for(f"{token.text}{{{name}}}"))
        reader.begin_environment(name) if is_begin else reader.end_group(group_of(name))
        return False

    def _closing_brace(self, token: Token) -> Token:
        end = token.source.text.find("}", token.end)
        return replace(token, end=end + 1) if token.call is None and end > 0 else token

    def _command(self, token: Token) -> bool:
        """Handles a label, a tag or a numbering mark; True if the token was one."""
        reader, row = self.reader, self.rows[-1]
        match token.text:
            case "\\label":
                row.labels.append((reader.word(), _ON_LETTER in row.marks))
            case "\\tag":
                self._tag(token)
            case "\\eqno" | "\\leqno":
                reader.skip_spaces()
                row.tag = _eqno(reader, self.closing or "$$")
            case "\\intertext" | "\\shortintertext" | "\\noalign":
                if self.splits and self.depth <= 0 and any(not kept.text.isspace() for kept in row.tokens):
                    self.rows.append(_Row())
                if token.word == "noalign":
                    reader.argument()
                else:
                    self._keep(token)
                    self._words()
            case "\\addtocounter" | "\\setcounter" | "\\stepcounter" | "\\refstepcounter":
                reader.count(token)
            case "\\ref" | "\\eqref" | "\\cref" | "\\Cref" | "\\autoref":
                reader.star()
                self._keep(token.standing_for(f"\\text{{{reader.word()}}}"))
            case "\\hline" | "\\hfil" | "\\noindent":
                return True
            case text if text in _MARKS:
                row.marks.add(text)
                reader.optional() if text == "\\displaybreak" else None
            case text if text[1:] in _WORDS and token.text[0] == "\\":
                self._keep(token)
                self._words()
            case text if text == PARAGRAPH:
                self._paragraph(token)
            case _:
                return False
        return True

    def _tag(self, token: Token) -> None:
        """Sets the number of the row; words in it, such as a reason, stay in the row."""
        self.reader.star()
        row = self.rows[-1]
        before = len(row.tokens)
        self._keep(token)
        self._words()
        inside = row.tokens[before + 2 : -1]
        row.tag = self.reader.counters.text(joined(inside))
        if "$" not in (each.text for each in inside):
            del row.tokens[before:]

    def _paragraph(self, token: Token) -> None:
        """Ends a row at a blank line, as Sphinx does: a formula behind it is no factor of the row."""
        self.reader.warn(token, "a blank line in a display: the end of a row here, where TeX stops")
        written = [kept.text for kept in self.rows[-1].tokens if not kept.text.isspace()]
        if self.depth <= 0 and written and written[-1] != "\\\\":
            self._keep(token.standing_for("\\\\"))

    def _words(self) -> None:
        """Keeps the argument of \\text as one group with its macros expanded, including its $."""
        near = self.rows[-1].tokens[-1]
        argument = self.reader.argument()
        words = [near.standing_for("{"), *argument, near.standing_for("}")]
        outer, self.reader.waiting = self.reader.waiting, [*reversed(words)]
        while (token := self.reader.pop()) is not None:
            if not self.reader.step(token):
                self.reader.follow_groups(token.text)
                self._keep(token, splits=False)
        self.reader.waiting = outer

    def _keep(self, token: Token, splits: bool = True) -> None:
        self.count += 1
        if splits:
            self.depth += {"{": 1, "}": -1}.get(token.text, 0)
            self.reader.follow_groups(token.text)
        if self.splits and splits and self.depth <= 0 and token.text == "\\\\":
            self.reader.take("*")
            self.reader.optional() if (near := self.reader.peek()) and near.text == "[" else None
            self.rows.append(_Row())
        else:
            self.rows[-1].tokens.append(token)


def _eqno(reader: DisplayReader, closing: str) -> str:
    taken: list[Token] = []
    while (token := reader.peek()) is not None and token.text not in ("$", closing, "\\\\"):
        reader.pop()
        taken.append(token)
    return reader.counters.text(joined(taken)).strip("() ")


def _numbered(reader: DisplayReader, rows: Sequence[_Row], environment: str) -> tuple[Row, ...]:
    base = environment.rstrip("*")
    counts = environment in NUMBERED
    rows = list(rows)
    for row in rows:
        row.tokens = _trimmed(row.tokens)
    if base == "IEEEeqnarray" and len(rows) > 1 and not rows[-1].tokens:
        rows.pop()
    made: list[Row] = []
    pending: list[str] = []  # amsmath: the label of a row without a number belongs to the next number
    for row in rows:
        number = None
        plain = _number_of_letters(reader, row, base, row is rows[0])
        if row.tag is not None:
            number = row.tag
        elif plain is not None:
            number = reader.lettered(plain)
        elif (counts or _ON in row.marks) and not row.marks & _UNNUMBERED:
            reader.counters.step("equation")
            reader.letter = 0
            number = reader.counters.number("equation")
        labels = [*pending, *(name for name, _ in row.labels)]
        pending = labels if number is None and row is not rows[-1] else []
        if pending:
            labels = []
        made.append(Row(number, tuple(labels), tuple(row.tokens)))
        for name in labels:
            in_letter = base == "subeqnarray" or dict(row.labels).get(name, True)
            shown = number if in_letter or plain is None else plain
            reader.labels.setdefault(name, reader.counters.current if shown is None else shown)
    return tuple(made)


def _number_of_letters(reader: DisplayReader, row: _Row, base: str, is_first: bool) -> str | None:
    """Returns the number with a letter, for \\IEEEyessubnumber and each row of subeqnarray; None without a
    letter."""
    with_letters = base == "subeqnarray"
    if not with_letters and (base != "IEEEeqnarray" or _ON_LETTER not in row.marks):
        return None
    if (with_letters and is_first) or _ON in row.marks:
        reader.counters.step("equation")
        reader.letter = 0
    return reader.counters.number("equation")


def _trimmed(tokens: Sequence[Token]) -> list[Token]:
    first, last = 0, len(tokens)
    while first < last and tokens[first].text.isspace():
        first += 1
    while first < last and tokens[last - 1].text.isspace():
        last -= 1
    return list(tokens[first:last])

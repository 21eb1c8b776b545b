"""The layouts of displays: the same statements in equation, align, eqnarray, cases, columns and others."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from random import Random

from formula_trees import Spelling

Terms = list[tuple[str, Spelling]]


@dataclass(frozen=True)
class Line:
    """One statement as it is written: the terms of each side, and its condition, perhaps of the form a ⊥ b."""

    sides: list[Terms]
    condition: Spelling | None = None
    right_angle: bool = False

    def side(self, place: int) -> str:
        return joined(self.sides[place])

    @property
    def left(self) -> str:
        return self.side(0)

    @property
    def right(self) -> str:
        return " = ".join(joined(each) for each in self.sides[1:])


@dataclass
class Sheet:
    """Where a display is written. name: of its labels. beside: how the condition of a statement is written,
    by the identity of its line. tags: whether a row may have a tag in place of a label."""

    name: str
    random: Random
    tags: bool = True
    beside: dict[int, str] = field(default_factory=dict)
    _rows: int = field(default=0)

    def label(self) -> str:
        """The label, or the tag, of the next row."""
        self._rows += 1
        command = "tag" if self.tags and self.random.random() < 0.15 else "label"
        return rf" \{command}{{{self.name}{chr(96 + self._rows)}}}"

    def tail(self, line: Line, cell: str = r" \quad ") -> str:
        """The condition of a statement as it stands behind it."""
        if line.condition is None:
            return ""
        kinds = [*BESIDE, *(RIGHT_ANGLES if line.right_angle else ())]
        written = self.random.choice(kinds)
        self.beside[id(line)] = written
        return written.replace("C", line.condition.source, 1).replace("@", cell)

    def head(self, line: Line) -> str:
        """The statement with its condition, in one row."""
        if line.condition is not None and self.random.random() < 0.12:
            self.beside[id(line)] = r"\text{for } C:"
            return rf"\text{{for }} {line.condition.source}: \quad {line.left} = {line.right}"
        if line.condition is not None and self.random.random() < 0.08:
            self.beside[id(line)] = r"\stackrel{C}{=}"
            most = " = ".join(line.side(place) for place in range(len(line.sides) - 1))
            return rf"{most} \stackrel{{{line.condition.source}}}{{=}} {line.side(len(line.sides) - 1)}"
        return f"{line.left} = {line.right}{self.tail(line)}"


#: How a condition C is written behind a formula; @ is a wide space or the next cell.
BESIDE = (
    r"@\text{for } C",
    r"@\text{where } C",
    r"@\text{with } C",
    r"@\text{given that } C",
    r"@\text{provided that } C",
    r"@\text{if } C",
    r"@\text{when } C",
    r"@\text{whenever } C",
    r"@\text{since } C",
    r"@\text{because } C",
    r"@\text{as } C",
    r"@\text{using } C",
    r"@\text{while } C",
    r"@\text{such that } C",
    r"@\text{subject to } C",
    r"@\text{since $C$}",
    r"@\text{(since } C\text{)}",
    r",@C",
    r"@(C)",
)
RIGHT_ANGLES = (r"@\forall\, C", r",@C")


def joined(terms: Terms, start: int = 0) -> str:
    first, *rest = terms[start:]
    text = ("- " if first[0] == "-" else "+ " if start else "") + first[1].source
    return text + "".join(f" {sign} {each.source}" for sign, each in rest)


def environment(name: str, body: str, argument: str = "") -> str:
    return f"\\begin{{{name}}}{argument}\n{body}\n\\end{{{name}}}"


def split_terms(terms: Terms, random: Random) -> tuple[str, str]:
    """The terms of a side in two pieces; the second begins with its sign, or is empty."""
    if len(terms) < 2:
        return joined(terms), ""
    at = random.randrange(1, len(terms))
    return joined(terms[:at]), joined(terms, at)


def equation(sheet: Sheet, lines: list[Line]) -> str:
    return environment("equation", f"  {sheet.head(lines[0])}{sheet.label()}")


def chain(sheet: Sheet, lines: list[Line]) -> str:
    (line,) = lines
    rows, last = [], len(line.sides) - 1
    for place in range(1, last + 1):
        head = f"{line.left} &=" if place == 1 else "  &="
        cell = sheet.random.choice((r" \quad ", r" && "))
        tail = ""
        if place == last and line.condition is not None:
            if place > 1 and sheet.random.random() < 0.25:
                sheet.beside[id(line)] = r"\intertext{and, as $C$,}"
                head = rf"\intertext{{and, as ${line.condition.source}$,}}" + head
            else:
                tail = sheet.tail(line, cell)
        rows.append(f"{head} {line.side(place)}{tail}{sheet.label()}")
    return environment("align", " \\\\\n".join(rows))


def _rows(sheet: Sheet, lines: list[Line], pattern: str, separator: str = " \\\\\n") -> str:
    """Each statement in a row; pattern has a place for each side."""
    found = []
    for line in lines:
        found.append(pattern.format(line.left, line.right) + sheet.tail(line) + sheet.label())
    return separator.join(found)


def align(sheet: Sheet, lines: list[Line]) -> str:
    return environment("align", _rows(sheet, lines, "{} &= {}"))


def align_leading(sheet: Sheet, lines: list[Line]) -> str:
    name = sheet.random.choice(("align", "flalign", *(["eqnarray"] if not sheet.tags else [])))
    return environment(name, _rows(sheet, lines, "&& {} = {}" if name == "eqnarray" else "& {} = {}"))


def alignat(sheet: Sheet, lines: list[Line]) -> str:
    return environment("alignat", _rows(sheet, lines, "{} &= {}"), "{2}")


def flalign(sheet: Sheet, lines: list[Line]) -> str:
    return environment("flalign", _rows(sheet, lines, "{} &= {}"))


def gather(sheet: Sheet, lines: list[Line]) -> str:
    return environment("gather", _rows(sheet, lines, "{} = {}"))


def eqnarray(sheet: Sheet, lines: list[Line]) -> str:
    rows = []
    for line in lines:
        first, rest = split_terms(line.sides[-1], sheet.random)
        before = " = ".join(line.side(place) for place in range(len(line.sides) - 1))
        if rest and line.condition is None and sheet.random.random() < 0.5:
            rows.append(f"{before} &=& {first} \\nonumber \\\\\n && {rest}{sheet.label()}")
        else:
            rows.append(f"{before} &=& {line.side(len(line.sides) - 1)}{sheet.tail(line)}{sheet.label()}")
    return environment("eqnarray", " \\\\\n".join(rows))


def split(sheet: Sheet, lines: list[Line]) -> str:
    (line,) = lines
    first, rest = split_terms(line.sides[1], sheet.random)
    rows = [f"{line.left} &= {first}"]
    if rest:
        indent = sheet.random.choice(("", r" \quad", r" \qquad"))
        rows.append(f"&{indent} {rest}")
    rows += [f"&= {line.side(place)}" for place in range(2, len(line.sides))]
    rows[-1] += sheet.tail(line)
    inner = environment("split", " \\\\\n".join(rows))
    return environment("equation", inner + sheet.label())


def aligned(sheet: Sheet, lines: list[Line]) -> str:
    pattern = sheet.random.choice(("{} &= {}", "& {} = {}", "&{} = {}"))
    rows = [pattern.format(line.left, line.right) + sheet.tail(line) for line in lines]
    name = sheet.random.choice(("aligned", "aligned", "split"))
    return environment("equation", environment(name, " \\\\\n".join(rows)) + sheet.label())


def gathered(sheet: Sheet, lines: list[Line]) -> str:
    rows = [f"{line.left} = {line.right}{sheet.tail(line)}" for line in lines]
    return environment("equation", environment("gathered", " \\\\\n".join(rows)) + sheet.label())


def multline(sheet: Sheet, lines: list[Line]) -> str:
    (line,) = lines
    first, rest = split_terms(line.sides[-1], sheet.random)
    before = " = ".join(line.side(place) for place in range(len(line.sides) - 1))
    broken = f" \\\\\n {rest}" if rest else ""
    if not rest:
        before, first = f"{before} \\\\\n", first
    return environment("multline", f"{before} = {first}{broken}{sheet.tail(line)}{sheet.label()}")


def cases(sheet: Sheet, lines: list[Line]) -> str:
    cell = sheet.random.choice((" & ", r" \quad "))
    rows = [f"{line.left} = {line.right}{sheet.tail(line, cell)}" for line in lines]
    if sheet.random.random() < 0.3:
        rows = [f"& {row}" for row in rows] if not any(line.condition for line in lines) else rows
    return environment("equation", environment("cases", " \\\\\n".join(rows)) + sheet.label())


def braced(sheet: Sheet, lines: list[Line]) -> str:
    rows = [f"{line.left} &= {line.right}{sheet.tail(line)}" for line in lines]
    inner = environment("aligned", " \\\\\n".join(rows))
    return environment("equation", "\\left\\{ " + inner + " \\right." + sheet.label())


def array_rcl(sheet: Sheet, lines: list[Line]) -> str:
    rows = [f"{line.left} & = & {line.right}{sheet.tail(line)}" for line in lines]
    return environment("equation", environment("array", " \\\\\n".join(rows), "{rcl}") + sheet.label())


def array_rcrcl(sheet: Sheet, lines: list[Line]) -> str:
    """The sides with two terms have a column for each, and one for the sign between."""
    rows = []
    for line in lines:
        first, *rest = line.sides[0]
        begins = ("- " if first[0] == "-" else "") + first[1].source
        columns = (
            f"{begins} & {rest[0][0]} & {joined([('+', rest[0][1]), *rest[1:]])}" if rest else f"& & {begins}"
        )
        rows.append(f"{columns} & = & {line.right}{sheet.tail(line)}")
    return environment("equation", environment("array", " \\\\\n".join(rows), "{rcrcl}") + sheet.label())


def columns(sheet: Sheet, lines: list[Line]) -> str:
    """The last side goes on in a further column."""
    rows = []
    for line in lines:
        first, rest = split_terms(line.sides[-1], sheet.random)
        before = " = ".join(line.side(place) for place in range(len(line.sides) - 1))
        rows.append(f"{before} &= {first}{' && ' + rest if rest else ''}{sheet.tail(line)}{sheet.label()}")
    return environment("alignat", " \\\\\n".join(rows), "{2}")


def pairs(sheet: Sheet, lines: list[Line]) -> str:
    cells = [f"{line.left} &= {line.right}" for line in lines]
    rows = []
    for at in range(0, len(cells), 2):
        rows.append(sheet.random.choice((" & ", ", & ")).join(cells[at : at + 2]) + sheet.label())
    return environment("align", " \\\\\n".join(rows))


def side_by_side(sheet: Sheet, lines: list[Line]) -> str:
    signed = any(line.left.startswith("-") for line in lines[1:])
    between = sheet.random.choice(
        (r", \qquad ", r", \quad ", r" \qquad \text{and} \qquad ", *[r" \qquad "] * (not signed))
    )
    return environment("equation", between.join(f"{x.left} = {x.right}" for x in lines) + sheet.label())


def trailing(sheet: Sheet, lines: list[Line]) -> str:
    """The first row ends with the operator."""
    (line,) = lines
    last = line.sides[-1]
    before = " = ".join(line.side(place) for place in range(len(line.sides) - 1))
    if len(last) < 2:
        body = (
            f"{before} = {{}} & \\\\\n & {joined(last)}"
            if sheet.random.random() < 0.3
            else f"{before} = \\\\\n {joined(last)}"
        )
    else:
        at = sheet.random.randrange(1, len(last))
        rest = joined([("+", last[at][1]), *last[at + 1 :]])
        body = f"{before} &= {joined(last[:at])} {last[at][0]} \\\\\n & \\quad {rest}"
    name = sheet.random.choice(("aligned", "split"))
    return environment("equation", environment(name, body) + sheet.tail(line) + sheet.label())


def interrupted(sheet: Sheet, lines: list[Line]) -> str:
    """Words between the rows of an align."""
    words = sheet.random.choice(
        (r"\intertext{and}", r"\intertext{In the same way,}", r"\intertext{We note that also}")
    )
    rows = [f"{line.left} &= {line.right}{sheet.tail(line)}{sheet.label()}" for line in lines]
    return environment("align", f" \\\\\n{words}\n".join(rows))


@dataclass(frozen=True)
class Layout:
    """least, most: numbers of statements. conditions: whether it has a place for them."""

    write: Callable[[Sheet, list[Line]], str]
    least: int = 1
    most: int = 1
    conditions: bool = True


LAYOUTS = {
    "equation": Layout(equation),
    "align chain": Layout(chain),
    "align": Layout(align, 2, 3),
    "align leading &": Layout(align_leading, 2, 3),
    "alignat": Layout(alignat, 2, 3),
    "flalign": Layout(flalign, 2, 3),
    "gather": Layout(gather, 2, 3),
    "eqnarray": Layout(eqnarray, 1, 2),
    "split": Layout(split),
    "aligned": Layout(aligned, 2, 3),
    "gathered": Layout(gathered, 2, 2),
    "multline": Layout(multline),
    "cases": Layout(cases, 2, 3),
    "braced aligned": Layout(braced, 2, 2),
    "array rcl": Layout(array_rcl, 1, 2),
    "array rcrcl": Layout(array_rcrcl, 1, 2),
    "columns": Layout(columns, 1, 2),
    "pairs": Layout(pairs, 2, 4, conditions=False),
    "side by side": Layout(side_by_side, 2, 2, conditions=False),
    "trailing": Layout(trailing),
    "intertext": Layout(interrupted, 2, 2),
}

"""Documents of displays with known truth, in TeX, Markdown, reStructuredText, HTML and notebooks."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from random import Random

from display_layouts import LAYOUTS, Layout, Line, Sheet
from file_formats import FORMATS, Format
from formula_trees import Spelling, Writer, spelled
from identity_pool import FAMILIES, FRAME_FAMILY
from one_fault import FALSE, UNDER, Stated, Stating
from scoped_macros import FRAMED, LETTERS, Macros

NEUTRAL = (
    "The relations below are well known.",
    "We collect a few facts for later use.",
    "This goes back to the nineteenth century.",
    "The reader may skip this part at first.",
    "Similar relations stand in many textbooks.",
    "A direct computation gives the next line.",
    "The following is used throughout the paper.",
)

FRAMES_MODEL = r"""[frames]
base = "N"
names = ["A", "B"]
dot = "N"
'{}^F\omega^G' = "angular velocity of G in F"
"""

#: Words of a reason, which holds from the row on in which it stands.
REASONS = re.compile(r"since|because|using|\\text\{as|intertext")

#: How often each family is drawn.
WEIGHTS = {each: 2 for each in FAMILIES if each not in FRAME_FAMILY} | {"condition": 5, "no condition": 1}


@dataclass(frozen=True)
class Step:
    """One printed formula: its two sides with macros expanded, and what is true of it. statement: which one of
    the display it belongs to. beside: how the condition of its statement is written; None without one."""

    left: str
    right: str
    truth: str
    family: str
    statement: int = 0
    beside: str | None = None


@dataclass
class Shown:
    """One display. asides: conditions that are printed in it, as formulas; lines: from and to, in the file.
    printed: whether TeX prints it."""

    name: str
    layout: str
    source: str
    steps: list[Step]
    asides: list[str]
    printed: bool = True
    lines: tuple[int, int] = (0, 0)


@dataclass
class Document:
    """A text, its model, and its displays."""

    format: str
    free: bool
    text: str
    model: str
    shown: list[Shown]

    @property
    def count(self) -> int:
        return sum(len(each.steps) for each in self.shown if each.printed)


@dataclass
class Author:
    """Writes documents. stating: where the statements come from."""

    random: Random
    stating: Stating
    macros: Macros = field(init=False)

    def document(self, format_name: str, formulas: int, frames: bool, free: bool) -> Document:
        """A document of at least so many printed formulas."""
        self.macros = Macros(self.random, FRAMED if frames else LETTERS)
        self.with_macros = format_name != "rst" and self.random.random() < 0.7
        form: Format = FORMATS[format_name](self.random)
        if self.with_macros:
            form.begin(self.macros.preamble(format_name == "tex"))
        else:
            form.begin([])
        shown: list[Shown] = []
        self.families = {"frames": 1} if frames else WEIGHTS
        self.frames = frames
        while sum(len(each.steps) for each in shown if each.printed) < formulas:
            if len(shown) % 9 == 4:
                form.section(f"Part {len(shown)}")
            if self.random.random() < 0.5:
                form.words(self.random.choice(NEUTRAL))
            if format_name == "tex" and self.with_macros and self.random.random() < 0.45:
                self._scoped(form, shown)
            elif self.random.random() < 0.05:
                self._hidden(form, shown)
            else:
                self._display(form, shown)
        return Document(format_name, free, form.end(), self._model(form.file, frames, free), shown)

    def _display(self, form: Format, shown: list[Shown], declared: str = "") -> None:
        one = self._shown(f"d{len(shown)}x", only_equation=bool(declared))
        if declared:
            one.source = one.source.replace("\\begin{equation}", "\\begin{equation}" + declared, 1)
        one.lines = form.display(one.source)
        shown.append(one)

    def _hidden(self, form: Format, shown: list[Shown]) -> None:
        """A display that is not printed; its formulas are false."""
        one = self._shown(f"d{len(shown)}x", only_equation=True)
        one.printed = False
        one.lines = form.hidden(one.source)
        shown.append(one)

    def _scoped(self, form: Format, shown: list[Shown]) -> None:
        """A display among declarations within groups."""
        macros, move = self.macros, self.random.randrange(8)
        if move == 0:  # in braces, with words
            macros.open()
            form.words("{" + macros.redefined() + " Here another letter is meant.}")
            macros.close()
            self._display(form, shown)
        elif move == 1:  # in an environment
            name = self.random.choice(("quote", "center", "itemize"))
            macros.open()
            item = r"\item " if name == "itemize" else ""
            form.words(f"\\begin{{{name}}}{macros.redefined()}{item} Words.\\end{{{name}}}")
            macros.close()
            self._display(form, shown)
        elif move == 2:  # the display stands in the group
            begin, end = self.random.choice(
                ((r"\begingroup", r"\endgroup"), ("{", "}"), (r"\begin{quote}", r"\end{quote}"))
            )
            macros.open()
            form.words(begin + macros.redefined())
            self._display(form, shown)
            macros.close()
            form.words(end)
            self._display(form, shown)
        elif move == 3:  # within the display
            macros.open()
            declared = macros.redefined()
            self._display(form, shown, declared)
            macros.close()
            self._display(form, shown)
        elif move == 4:  # to the end of the text
            form.words(macros.redefined())
            self._display(form, shown)
        elif move == 5:  # out of a group
            macros.open()
            form.words("{" + macros.redefined(everywhere=True) + " Words.}")
            macros.close()
            self._display(form, shown)
        elif move == 6:
            self._of_two(form, shown)
        else:
            self._hidden(form, shown)

    def _of_two(self, form: Format, shown: list[Shown]) -> None:
        """Two displays of which a switch prints one."""
        first = self.random.random() < 0.5
        form.words(r"\draft" + ("true" if first else "false"))
        if self.random.random() < 0.5:
            form.words("{" + r"\draft" + ("false" if first else "true") + " Words.}")
        form.words(r"\ifdraft")
        self._display(form, shown)
        shown[-1].printed = first
        form.words(r"\else")
        self._display(form, shown)
        shown[-1].printed = not first
        form.words(r"\fi")

    def _shown(self, name: str, only_equation: bool = False) -> Shown:
        layout_name = "equation" if only_equation else self.random.choice(list(LAYOUTS))
        layout = LAYOUTS[layout_name]
        stated = [self._stated(layout) for _ in range(self.random.randint(layout.least, layout.most))]
        writer = Writer(self.macros.custom) if self.with_macros else Writer()
        tags = layout_name != "eqnarray" and self.random.random() < 0.5
        sheet = Sheet(name, self.random, tags)
        sides_of = [[writer.terms(side) for side in each.sides] for each in stated]
        lines = [self._line(writer, *both) for both in zip(stated, sides_of, strict=True)]
        source = layout.write(sheet, lines)
        steps, asides = [], []
        for place, (each, sides, line) in enumerate(zip(stated, sides_of, lines, strict=True)):
            plain = [_plain(terms) for terms in sides]
            beside = sheet.beside.get(id(line))
            for left, right, truth in zip(plain, plain[1:], each.truths, strict=False):
                is_before = layout_name == "align chain" and right is not plain[-1]
                known = FALSE if truth == UNDER and is_before and REASONS.search(beside or "") else truth
                steps.append(Step(left, right, known, each.family, place, beside))
            if line.condition is not None:
                asides.append(line.condition.plain)
        return Shown(name, layout_name, source, steps, asides)

    def _stated(self, layout: Layout) -> Stated:
        names, weights = zip(*self.families.items(), strict=True)
        family = self.random.choices(names, weights)[0]
        if family == "condition" and not layout.conditions:
            family = "vectors"
        made = self.stating
        found = made.without_its_condition() if family == "no condition" else made.stated(family)
        return made.negated(found) if self.random.random() < 0.2 else found

    def _line(self, writer: Writer, stated: Stated, sides: list[list[tuple[str, Spelling]]]) -> Line:
        condition = stated.condition
        if condition is None:
            return Line(sides)
        text = writer.write(condition.left) + f" {condition.sign} " + writer.write(condition.right)
        return Line(sides, text, condition.sign == r"\perp")

    def _model(self, file: str, frames: bool, free: bool) -> str:
        kinds = {"scalar": "fghk", "vector": "abcd", "tensor": "AST"} if not frames else {"vector": "xy"}
        said = ", free = true" if free else ""
        lines = [f'source = "{file}"']
        if frames:
            lines.append(FRAMES_MODEL)
        lines.append("[symbols]")
        lines += [
            f"'{each}' = {{ kind = \"{kind}\"{said} }}" for kind, letters in kinds.items() for each in letters
        ]
        if not frames:
            lines += [f"'{each}' = {{ kind = \"scalar\"{said} }}" for each in (r"\theta", r"\phi")]
            lines += ["'u' = { kind = \"vector\", unit = true }", "'R' = \"rotation\""]
            lines += ["[definitions]", r"'n' = 'a \times b'"]
        return "\n".join(lines) + "\n"


def _plain(terms: list[tuple[str, Spelling]]) -> str:
    return Line([[(sign, spelled(each.plain)) for sign, each in terms]]).left


def documents(seed: int, formulas: int, each: int = 40) -> list[Document]:
    """Documents with at least so many printed formulas altogether."""
    random = Random(seed)
    author = Author(random, Stating(random))
    found: list[Document] = []
    while sum(one.count for one in found) < formulas:
        place = len(found)
        name = ("tex", "md", "tex", "rst", "tex", "ipynb", "tex", "html")[place % 8]
        size = min(each, formulas)
        found.append(author.document(name, size, frames=place % 7 == 6, free=place % 3 != 2))
    return found

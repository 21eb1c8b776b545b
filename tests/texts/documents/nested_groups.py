"""Random TeX documents of nested groups and declarations, with the value of each macro at each probe.

The values come from a model of TeX's groups that shares nothing with the reader: each group has a table of
its own, and a name is looked up from the innermost table outwards.
"""

from __future__ import annotations

import random
import re

#: The body of a macro names only macros further to the right, so that none calls itself.
NAMES = ("x", "y", "z")
FLAG = "iflong"
PROBE = re.compile(r"<(\d+):(.*?)>", re.DOTALL)
PREAMBLE = (
    r"\documentclass{article}\usepackage{amsmath}"
    r"\newcommand{\x}{a}\newcommand{\y}{b}\newcommand{\z}{c}\newif\iflong"
    r"\newenvironment{own}{\def\z{o}}{}\begin{document}"
)
VALUES = r"\x|\y|\z|\iflong T\else F\fi"

#: How each kind of declaration is written, of a name and a body.
WRITTEN = {
    "def": "\\def\\{name}{{{body}}}",
    "long def": "\\long\\def\\{name}{{{body}}}",
    "gdef": "\\gdef\\{name}{{{body}}}",
    "global def": "\\global\\long\\def\\{name}{{{body}}}",
    "edef": "\\edef\\{name}{{{body}}}",
    "xdef": "\\xdef\\{name}{{{body}}}",
    "renewcommand": "\\renewcommand{{\\{name}}}{{{body}}}",
    "robust": "\\DeclareRobustCommand{{\\{name}}}{{{body}}}",
    "noexpand": "\\edef\\{name}{{{body}}}",
    "let": "\\let\\{name}={body} ",
    "let macro": "\\let\\{name}={body} ",
    "global let": "\\global\\let\\{name}={body} ",
    "flag": "\\long{body} ",
    "global flag": "\\global\\long{body} ",
    "let flag": "\\let\\iflong\\if{body} ",
}
GLOBAL = ("gdef", "xdef", "global def", "global let", "global flag")

#: What begins and ends each group of a kind.
MARKS: dict[str, tuple[tuple[str, str], ...]] = {
    "braces": (("{", "}"),),
    "begingroup": (("\\begingroup ", "\\endgroup "),),
    "bgroup": (("\\bgroup ", "\\egroup "),),
    "quote": (("\\begin{quote}", "\\end{quote}"),),
    "own": (("\\begin{own}", "\\end{own}"),),
    "brackets": (("\\[", "\\]"),),
    "dollar": (("$", "$"),),
    "equation": (("\\begin{equation}", "\\end{equation}"),),
    "frac": (("\\frac{", "}"), ("{", "}")),
    "script": (("t_{", "}"),),
    "left": (("\\left(", "\\right)"),),
    "middle": (("\\left(", ""), ("\\middle|", "\\right)")),
    "align": (("\\begin{align}", "&"), ("", "\\\\"), ("", "&"), ("", "\\end{align}")),
    "gather": (("\\begin{gather}", "\\\\"), ("", "\\end{gather}")),
    "tabular": (("\\begin{tabular}{p{1cm}p{1cm}}", "&"), ("", "\\\\"), ("", "&"), ("", "\\end{tabular}")),
    "array": (("\\begin{array}{cc}", "&"), ("", "\\\\"), ("", "&"), ("", "\\end{array}")),
    "matrix": (("\\begin{matrix}", "&"), ("", "\\end{matrix}")),
    "aligned": (("\\begin{aligned}", "&"), ("", "\\\\"), ("", "\\end{aligned}")),
    "cases": (("\\begin{cases}", "&"), ("", "\\end{cases}")),
}
_FORMULAS = frozenset({"brackets", "dollar", "equation", "align", "gather"})
#: What amsmath typesets twice or more: a global declaration in it changes its beginning.
_TWICE = frozenset({"align", "gather", "aligned", "cases", "matrix"})

#: Letters; \name for a macro that is looked up when the body is used; =a for a letter that a macro is let to.
Body = tuple[str, ...]


class Document:
    """One random document: its LaTeX, and the values wanted, by the number of the probe."""

    def __init__(
        self, seed: int, declarations: tuple[str, ...], prose: tuple[str, ...], formulas: tuple[str, ...]
    ) -> None:
        self.draw = random.Random(seed)
        self.declarations, self.prose, self.formulas = declarations, prose, formulas
        self.latex, self.wanted = PREAMBLE, dict[int, str]()
        self.tables: list[dict[str, Body]] = [{"x": ("a",), "y": ("b",), "z": ("c",), FLAG: ("F",)}]
        self.around: list[str] = []
        self._fill(4)
        self.latex += "\\end{document}"

    def body(self, name: str) -> Body:
        return next(table[name] for table in reversed(self.tables) if name in table)

    def value(self, name: str) -> str:
        """The letters that a macro comes to."""
        return "".join(self.value(part[1:]) if part[0] == "\\" else part[-1] for part in self.body(name))

    def expanded(self, body: Body) -> Body:
        """What \\edef makes of a body: TeX does not expand a macro that is let to a letter."""
        made: Body = ()
        for part in body:
            meaning = self.body(part[1:]) if part[0] == "\\" else ("=",)
            made += (part,) if meaning[0][0] == "=" else self.expanded(meaning)
        return made

    def _in_formula(self) -> bool:
        return not _FORMULAS.isdisjoint(self.around)

    def _fill(self, depth: int) -> None:
        for _ in range(self.draw.randrange(1, 5)):
            chance = self.draw.random()
            if chance < 0.5 or depth == 0:
                self._declare()
            elif chance < 0.9:
                self._group(self.draw.choice(self.formulas if self._in_formula() else self.prose), depth - 1)
            self._probe()

    def _probe(self) -> None:
        number = len(self.wanted) + 1
        dollar = "" if self._in_formula() else "$"
        self.latex += f"{dollar}<{number}:{VALUES}>{dollar} "
        self.wanted[number] = "|".join(map(self.value, (*NAMES, FLAG)))

    def _group(self, kind: str, depth: int) -> None:
        self.around.append(kind)
        for opening, closing in MARKS[kind]:
            self.latex += opening
            self.tables.append({"z": ("o",)} if kind == "own" else {})
            self._fill(depth)
            self.tables.pop()
            self.latex += closing
        self.around.pop()

    def _declare(self) -> None:
        kind = self.draw.choice(self.declarations)
        everywhere = kind in GLOBAL
        if everywhere and not _TWICE.isdisjoint(self.around):
            return
        name, body, written = self._flag() if kind.endswith("flag") else self._body(kind)
        self.latex += WRITTEN[kind].format(name=name, body=written)
        for table in self.tables[1:] if everywhere else ():
            table.pop(name, None)
        self.tables[0 if everywhere else -1][name] = body

    def _flag(self) -> tuple[str, Body, str]:
        holds = self.draw.choice((True, False))
        return FLAG, ("T" if holds else "F",), str(holds).lower()

    def _body(self, kind: str) -> tuple[str, Body, str]:
        """A name, the body that it gets, and how that is written."""
        place = self.draw.randrange(len(NAMES) - (kind == "let macro"))
        others = NAMES[place + 1 :] if kind == "let macro" else (None, *NAMES[place + 1 :])
        letter, other = self.draw.choice("defghk"), self.draw.choice(others)
        if kind in ("let", "let macro", "global let"):
            if other is None:
                return NAMES[place], (f"={letter}",), letter
            return NAMES[place], self.body(other), f"\\{other}"
        body = (letter,) if other is None else (f"\\{other}", letter)
        written = " ".join(body)
        if kind == "noexpand":
            written = written.replace("\\", "\\noexpand\\")
        return NAMES[place], self.expanded(body) if kind in ("edef", "xdef") else body, written

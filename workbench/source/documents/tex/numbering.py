"""LaTeX's counters: the numbers of equations and sections."""

from __future__ import annotations

import re

SECTIONS = ("part", "chapter", "section", "subsection", "subsubsection", "paragraph", "subparagraph")
_BOOKS = frozenset(
    {"book", "report", "memoir", "scrbook", "scrreprt", "amsbook", "extbook", "extreport", "tufte-book"}
)
_FLOATS = ("equation", "figure", "table")
_KOMA = frozenset({"scrbook", "scrreprt", "scrartcl"})
#: Depth of numbered sections by class, where it is not 3.
_DEPTHS = {"memoir": 1, "llncs": 2, **dict.fromkeys(_BOOKS - {"memoir", "amsbook"}, 2)}
#: Format of numbers by class, where it differs; and in its appendix, where equations restart.
_PRINTED = {
    "revtex4": {
        "section": "\\Roman{section}",
        "subsection": "\\thesection{} \\Alph{subsection}",
        "subsubsection": "\\thesubsection{} \\arabic{subsubsection}",
    },
    "IEEEtran": {
        "section": "\\Roman{section}",
        "subsection": "\\thesection-\\Alph{subsection}",
        "subsubsection": "\\thesubsection\\arabic{subsubsection}",
    },
    "beamer": {name: f"\\arabic{{{name}}}" for name in SECTIONS[3:5]},
}
_IN_APPENDIX = {
    "revtex4": {
        "subsection": "\\thesection{} \\arabic{subsection}",
        "equation": "\\thesection\\arabic{equation}",
    },
    "elsarticle": {"equation": "\\Alph{section}.\\arabic{equation}"},
}
_PIECE = re.compile(
    r"\\the([A-Za-z]+)\s*|\\(arabic|[aA]lph|[rR]oman)\s*\{\s*([A-Za-z@]+)\s*\}|\\[A-Za-z]+\s*|[{}$]|\\(.)"
)
_ROMAN = ((1000, "m"), (900, "cm"), (500, "d"), (400, "cd"), (100, "c"), (90, "xc"), (50, "l"), (40, "xl"),
          (10, "x"), (9, "ix"), (5, "v"), (4, "iv"), (1, "i"))  # fmt: skip


_STYLES = re.compile(
    "text(normal|rm|up|it|bf)?|math(rm|bf)|normalfont|rmfamily|upshape|[mh]box|relax|protect|ensuremath|bf|rm|it|sf|tt"
)


class Counters:
    """Values of the counters, the counters that reset them, and their formats (LaTeX with counter names)."""

    def __init__(self) -> None:
        self.values = dict.fromkeys((*SECTIONS, "equation", "figure", "table"), 0) | {"secnumdepth": 3}
        self.within: dict[str, str] = dict(zip(SECTIONS[3:], SECTIONS[2:], strict=False))
        self.printed = {
            "section": "\\arabic{section}",
            **{name: f"\\the{outer}.\\arabic{{{name}}}" for name, outer in self.within.items()},
        }
        self.current = ""  # the number that a label refers to
        self._outer: list[str] = []  # that of the enclosing environments
        self.top, self.document_class = "section", ""
        self.is_book, self._unnumbered = False, frozenset[str]()
        self._saved: tuple[int, str | None] | None = None  # of the equations around subequations

    def use_class(self, name: str) -> None:
        self.document_class = "revtex4" if name.startswith("revtex4") else name
        self.values["secnumdepth"] = -1 if name.startswith("tufte-") else _DEPTHS.get(name, 3)
        self.printed |= _PRINTED.get(self.document_class, {})
        if name in _BOOKS:
            self.is_book, self.top = True, "chapter"
            self.within["section"] = "chapter"
            if name != "amsbook":
                self.within |= dict.fromkeys(_FLOATS, "chapter")
                self.printed["section"] = "\\thechapter.\\arabic{section}"
                if name in _KOMA:  # a 0 before the first chapter, too
                    self.printed |= {each: f"\\thechapter.\\arabic{{{each}}}" for each in _FLOATS}

    def step(self, name: str) -> None:
        self.values[name] = self.values.get(name, 0) + 1
        self._reset_below(name)
        self.current = self.number(name)

    def step_section(self, name: str, starred: bool = False) -> None:
        """Steps the counter of a section, unless it is deeper than secnumdepth or a chapter outside the main
        matter."""
        is_deep = SECTIONS.index(name) - 1 > self.values["secnumdepth"]
        is_outside = name in self._unnumbered
        if self.document_class == "beamer" or not (starred or is_deep or is_outside):
            self.step(name)
        elif self.document_class in _KOMA and not (starred and name == "chapter"):
            self._reset_below(name)

    def number_to(self, name: str) -> None:
        """Executes Memoir's \\setsecnumdepth: sections deeper than `name` have no number."""
        depths = {"none": -10, "all": 5} | {each: depth for depth, each in enumerate(SECTIONS, start=-1)}
        self.values["secnumdepth"] = depths.get(name, self.values["secnumdepth"])

    def matter(self, main: bool) -> None:
        if self.document_class != "amsbook":
            others = SECTIONS if self.document_class == "memoir" else ("chapter",)
            self._unnumbered = frozenset(() if main else others)
        if self.document_class in _KOMA:
            for name in ("section", *_FLOATS):
                plain = f"\\arabic{{{name}}}"
                forms = (plain, f"\\thechapter.{plain}")
                if self.printed.get(name) in forms:
                    self.printed[name] = forms[main]

    def set(self, name: str, value: int, add: bool = False) -> None:
        self.values[name] = value + (self.values.get(name, 0) if add else 0)

    def new(self, name: str, outer: str | None = None) -> None:
        self.values.setdefault(name, 0)
        if outer:
            self.number_within(name, outer)

    def number_within(self, name: str, outer: str) -> None:
        self.within[name] = outer
        self.printed[name] = f"\\the{outer}.\\arabic{{{name}}}"

    def without(self, name: str) -> None:
        self.within.pop(name, None)
        self.printed[name] = f"\\arabic{{{name}}}"

    def begin(self) -> None:
        """Begins an environment; labels after it do not refer to its number."""
        self._outer.append(self.current)

    def end(self) -> None:
        self.current = self._outer.pop() if self._outer else self.current

    def appendix(self, only: bool) -> None:
        """Begins the appendix. Its \\setcounter resets only the named counters.

        only: it has one part, whose sections have no numbers in IEEEtran.
        """
        if self.document_class == "beamer":
            return
        self.values[self.top] = self.values["section"] = 0
        if not self.is_book:
            self.values["subsection"] = 0
        self.printed[self.top] = f"\\Alph{{{self.top}}}"
        if anew := _IN_APPENDIX.get(self.document_class):
            self.printed |= anew
            self.within["equation"] = "section"
        if self.document_class == "elsarticle":
            self.values["equation"] = 0
        if self.document_class == "IEEEtran" and only:
            self.step("section")
            self._unnumbered = frozenset({"section"})
            self.printed["subsection"] = "\\Alph{subsection}"

    def number(self, name: str) -> str:
        """Returns \\thename."""
        return self._number(name, 0)

    def text(self, latex: str) -> str:
        """Returns a tag or a \\thename as printed, without styles."""
        return self._text(latex, 0).strip()

    def section(self) -> str:
        """Returns the number of the innermost numbered section; "" before the first."""
        numbered = [name for name in SECTIONS[SECTIONS.index(self.top) :] if self.values[name]]
        return self.number(numbered[-1]) if numbered else ""

    def begin_subequations(self) -> None:
        self.step("equation")
        self._saved = (self.values["equation"], self.printed.get("equation"))
        self.printed["equation"] = f"{self.number('equation')}\\alph{{equation}}"
        self.values["equation"] = 0

    def end_subequations(self) -> None:
        if self._saved is None:
            return
        self.values["equation"], printed = self._saved
        self._saved = None
        if printed is None:
            del self.printed["equation"]
        else:
            self.printed["equation"] = printed

    def _reset_below(self, name: str) -> None:
        for inner, outer in self.within.items():
            if outer == name:
                self.values[inner] = 0
                if inner != name:
                    self._reset_below(inner)

    def _number(self, name: str, depth: int) -> str:
        printed = self.printed.get(name)
        if printed is None:
            plain = str(self.values.get(name, 0))
            in_chapter = self.is_book and self.within.get(name) == "chapter" and self.values["chapter"]
            return f"{self._number('chapter', depth + 1)}.{plain}" if in_chapter else plain
        return self._text(printed, depth + 1)

    def _text(self, latex: str, depth: int) -> str:
        if depth > 9:
            return "?"
        return _PIECE.sub(lambda match: self._piece(match, depth), latex)

    def _piece(self, match: re.Match[str], depth: int) -> str:
        if match[1]:
            return self._number(match[1], depth)
        if match[2]:
            return _written(match[2], self.values.get(match[3], 0))
        if match[4]:
            return match[4]
        name = match[0].strip("\\ \n\t")
        return "" if _STYLES.fullmatch(name) or not name.isalpha() else match[0]


def _written(how: str, value: int) -> str:
    if how == "arabic" or value <= 0:
        return str(value) if how == "arabic" else ""
    if how.lower() == "alph":
        letter = chr(96 + value) if value <= 26 else "?"
        return letter.upper() if how == "Alph" else letter
    text, left = "", min(value, 4000)
    for worth, letters in _ROMAN:
        text += letters * (left // worth)
        left %= worth
    return text.upper() if how == "Roman" else text

"""A TeX document as it is read: files, sections, counters, and every display on the way."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from workbench.papers.model import PaperError
from workbench.papers.texts.prose import plain
from workbench.papers.texts.tex.displays import CLOSING, DISPLAYS, Display, DisplayReader, read_display
from workbench.papers.texts.tex.numbering import SECTIONS
from workbench.papers.texts.tex.state import Macro, Names
from workbench.papers.texts.tex.tokens import PARAGRAPH, Lexer, Token, joined
from workbench.papers.texts.view import Source, View

_VERBATIM = frozenset((
    "verbatim", "verbatim*", "Verbatim", "lstlisting", "minted", "comment", "alltt", "filecontents",
    "filecontents*", "listing", "tcblisting", "pyconsole", "sagesilent", "luacode", "tikzpicture",
))  # fmt: skip
_CLASS = ("documentclass", "LoadClass", "LoadClassWithOptions")
_STYLES = (".sty", ".cls", ".def", ".clo")
_MOST_FILES = 500


@dataclass(frozen=True)
class Directive:
    """A comment for the workbench: %! workbench: …"""

    text: str
    source: Source
    start: int


@dataclass
class Text:
    """What was read. `labels`: label → number. `warnings`: with the file, line and column of each. `fences`:
    macros that could not be expanded and seem to be brackets, each with its body. `inline`: the formulas
    inside of sentences."""

    path: Path
    sources: list[Source] = field(default_factory=list)
    displays: list[Display] = field(default_factory=list)
    labels: dict[str, str | None] = field(default_factory=dict)
    directives: list[Directive] = field(default_factory=list)
    warnings: list[PaperError] = field(default_factory=list)
    macros: Names = field(default_factory=Names)
    fences: dict[str, str] = field(default_factory=dict)
    inline: list[Display] = field(default_factory=list)


class TexReader(DisplayReader):
    """Reads what is opened, to its end. `root`: the folder of the main file."""

    def __init__(self, root: Path, overrides: Names | None = None) -> None:
        super().__init__(overrides)
        self.root = root
        self.displays: list[Display] = []
        self.inline: list[Display] = []
        self.directives: list[Directive] = []
        self.sources: list[Source] = []
        self.open_paths: list[Path] = []
        self.theorems: dict[str, str | None] = {}
        self.missing: list[str] = []
        self.options: dict[str, Sequence[Token]] = {}  # of the style or class that is being read
        self.given: list[str] = []
        self.global_options: list[str] = []

    def read_file(self, path: Path) -> None:
        """Raises PaperError for the file itself; what it includes and cannot be read is a warning."""
        self.open_file(Source.open(path))
        self.run()

    def read_display(self, view: View, opening: Token, environment: str) -> Display:
        self.open(Lexer(view))
        return read_display(self, opening, environment)

    def open_file(self, source: Source) -> None:
        self.sources.append(source)
        self.open_paths.append(source.path)
        is_style = source.path.suffix in _STYLES
        self.open(Lexer(source.view(), self._directive, at_letter=is_style))

    def close(self, lexer: Lexer) -> None:
        if self.open_paths and lexer.view.source.path == self.open_paths[-1]:
            self.open_paths.pop()

    def run(self) -> None:
        while True:
            if (lexer := self.lexer()) is not None:
                lexer.skip_prose()
            token = self.pop()
            if token is None:
                return
            if token.text == "$":
                self._dollar(token)
            elif token.word is not None and self._is_end(token):
                return

    def _dollar(self, token: Token) -> None:
        if self.take("$"):
            self._display(token, "$$")
        else:
            self._inline(token, "$")

    def _inline(self, opening: Token, environment: str) -> None:
        """What stands before the closing mark in this paragraph, read by itself: a $ that closes nothing
        takes no display away."""
        taken: list[Token] = []
        while (token := self.pop()) is not None and token.text not in (CLOSING[environment], PARAGRAPH):
            taken.append(token)
            if token.text in ("\\text", "\\mbox", "\\textrm", "\\hbox"):
                taken += [token.standing_for("{"), *self.argument(), token.standing_for("}")]
        if token is None or token.text == PARAGRAPH:
            return
        outer, self.waiting = self.waiting, [token, *reversed(taken)]
        told = len(self.warnings)
        self.inline.append(read_display(self, opening, environment))
        del self.warnings[told:]
        self.waiting = outer

    def _display(self, token: Token, environment: str) -> None:
        self.counters.begin()
        self.displays.append(read_display(self, token, environment))
        self.counters.end()

    def _is_end(self, token: Token) -> bool:
        """Obeys a command; whether the document ends with it."""
        word = token.word
        if word == "[":
            self._display(token, "\\[")
        elif word == "(":
            self._inline(token, "\\(")
        elif word == "begin":
            self._begin(token, self.word())
        elif word == "end":
            name = self.word()
            if name == "document":
                return True
            self._end(token, name)
            self.counters.end()
        elif word in SECTIONS:
            self._section(word)
        elif (command := _COMMANDS.get(word)) is not None:  # also where a class redefines it
            command(self, token)
        else:
            self.step(token)
        return False

    def _begin(self, token: Token, name: str) -> None:
        if name in _VERBATIM:
            self._skip_verbatim(name)
            return
        if name in DISPLAYS and name not in self.names.environments:
            self._display(token, name)
            return
        if name == "math":
            self.inline.append(read_display(self, token, name))
            return
        self.counters.begin()
        if name == "subequations":
            self.counters.begin_subequations()
        elif name == "appendices":
            self.counters.appendix(only=False)
        elif name in self.theorems:
            self.counters.step(self.theorems[name] or name)
        elif name in ("figure", "table", "figure*", "table*"):
            self.counters.step(name.rstrip("*"))
        elif (declared := self.names.environments.get(name)) is not None:
            self.expand(token.standing_for(f"\\{name}"), declared.begin)

    def _end(self, token: Token, name: str) -> None:
        if name == "subequations":
            self.counters.end_subequations()
        elif (declared := self.names.environments.get(name)) is not None:
            self.expand(token.standing_for(f"\\end{name}"), declared.end)

    def _skip_verbatim(self, name: str) -> None:
        lexer = self.lexer()
        if lexer is not None:
            lexer.skip_past(f"\\end{{{name}}}")
            return
        while (token := self.pop()) is not None:
            if token.text == "\\end" and self.word() == name:
                return

    def _section(self, name: str) -> None:
        starred = self.star()
        self.optional()
        self.heading = plain(joined(self.argument()))
        self.counters.step_section(name, starred)

    def unnumbered(self, token: Token) -> None:
        """\\addchap and \\addsec."""
        outer = self.counters.values["secnumdepth"]
        self.counters.values["secnumdepth"] = -9
        self._section({"addchap": "chapter", "addsec": "section"}[token.word])
        self.counters.values["secnumdepth"] = outer

    def verb(self, token: Token) -> None:
        lexer = self.lexer()
        if lexer is None:
            return
        if lexer.text.startswith("*", lexer.position):
            lexer.position += 1
        mark = lexer.text[lexer.position : lexer.position + 1]
        lexer.position += 1
        end_of_line = lexer.text.find("\n", lexer.position)
        end = lexer.text.find(mark, lexer.position)
        if mark and end >= 0 and (end < end_of_line or end_of_line < 0):
            lexer.position = end + 1

    def include(self, token: Token) -> None:
        folder = self.word() if token.word in ("import", "subimport") else ""
        name = (folder + self._file_name()).strip().strip('"')
        path = self._find(name, ("", ".tex"))
        if path is None:
            self.missing.append(name)
            self.warn(token, f"no file {name!r} beside this one")
        else:
            self._open(token, path)

    def use(self, token: Token) -> None:
        """\\usepackage and \\documentclass: a style or class file that lies beside the text is read."""
        given = [part.strip() for part in joined(self.optional() or ()).split(",")]
        if token.word == "documentclass":
            self.global_options += given
        for name in (part.strip() for part in self.word().split(",")):
            if token.word in _CLASS:
                self.counters.use_class(name)
            if (path := self._find(name, (".sty", ".cls"))) is not None:
                outer, self.waiting = self.waiting, []  # what it leaves open ends with it
                known, self.options, self.given = (self.options, self.given), {}, given
                self._open(token, path)
                self.run()
                self.waiting, (self.options, self.given) = outer, known

    def option(self, token: Token) -> None:
        """\\DeclareOption: its code is obeyed where the option is given."""
        other = self.star()
        name = "*" if other else self.word()
        self.options[name] = self.argument()

    def process_options(self, token: Token) -> None:
        self.star()
        asked = {*self.given, *self.global_options}
        for name, code in reversed(self.options.items()):
            if name in asked:
                self.push(code)

    def execute_options(self, token: Token) -> None:
        for name in reversed(self.word().split(",")):
            self.push(self.options.get(name.strip(), ()))

    def number_within(self, token: Token) -> None:
        star = self.star()
        name, outer = self.word(), self.word()
        self.counters.number_within(name, outer)
        if star:
            self.counters.printed.pop(name)

    def without(self, token: Token) -> None:
        self.star()
        name = self.word()
        self.word()
        self.counters.without(name)

    def new_theorem(self, token: Token) -> None:
        star = self.star()
        name, shared = self.word(), self.optional()
        self.argument()
        outer = self.optional()
        if star:
            return
        self.theorems[name] = joined(shared).strip() if shared else None
        if not shared:
            self.counters.new(name, joined(outer).strip() if outer else None)

    def new_counter(self, token: Token) -> None:
        name, outer = self.word(), self.optional()
        self.counters.new(name, joined(outer).strip() if outer else None)

    def label(self, token: Token) -> None:
        self.labels.setdefault(self.word(), self.counters.current)

    def letters(self, token: Token) -> None:
        """\\makeatletter, \\makeatother."""
        for waiting in reversed(self.waiting):
            if isinstance(waiting, Lexer):
                waiting.at_letter = token.word == "makeatletter"
                return

    def expl3(self, token: Token) -> None:
        if (lexer := self.lexer()) is not None:
            lexer.skip_past("\\ExplSyntaxOff")
            self.warn(token, "\\ExplSyntaxOn: what is programmed in expl3 is skipped")

    def end_file(self, token: Token) -> None:
        if (lexer := self.lexer()) is not None:
            lexer.position = len(lexer.text)

    def declare(self, name: str, macro: Macro) -> None:
        super().declare(name, macro)
        if name.startswith("the") and name[3:] in self.counters.values and not macro.parameters:
            self.counters.printed[name[3:]] = joined(macro.body)

    def _file_name(self) -> str:
        self.skip_spaces()
        lexer = self.lexer()
        near = self.peek()
        if near is None or near.text == "{" or lexer is None:
            return joined(self.argument())
        taken = []
        while (near := self.peek()) is not None and near.text not in (" ", "\\par", "}") and not near.word:
            taken.append(self.pop())
        return joined(taken)

    def _find(self, name: str, endings: Iterable[str]) -> Path | None:
        if not name or "\0" in name or len(name) > 300:
            return None
        folders = [self.root, *(path.parent for path in self.open_paths[-1:])]
        for path in (folder / (name + ending) for folder in folders for ending in endings):
            try:
                if path.is_file():
                    return path
            except OSError:
                continue
        return None

    def _open(self, token: Token, path: Path) -> None:
        if path in self.open_paths:
            self.warn(token, f"{path.name} includes itself; it is not read again")
        elif len(self.sources) >= _MOST_FILES:
            self.warn(token, f"more than {_MOST_FILES} files are included; {path.name} is not read")
        else:
            try:
                self.open_file(Source.open(path))
            except PaperError as error:
                self.warn(token, str(error))

    def _directive(self, text: str, source: Source, start: int) -> None:
        name, colon, rest = text.strip().partition(":")
        if colon and name.strip() == "workbench":
            self.directives.append(Directive(rest.strip(), source, start))


_COMMANDS = {
    **dict.fromkeys(("input", "include", "subfile", "import", "subimport"), TexReader.include),
    **dict.fromkeys(
        ("usepackage", "RequirePackage", "documentclass", "LoadClass", "LoadClassWithOptions"), TexReader.use
    ),
    **dict.fromkeys(("numberwithin", "counterwithin"), TexReader.number_within),
    "@addtoreset": lambda reader, token: reader.counters.within.update({reader.word(): reader.word()}),
    **dict.fromkeys(("counterwithout", "@removefromreset"), TexReader.without),
    **dict.fromkeys(("setcounter", "addtocounter", "stepcounter", "refstepcounter"), TexReader.count),
    **dict.fromkeys(("verb", "lstinline"), TexReader.verb),
    **dict.fromkeys(("makeatletter", "makeatother"), TexReader.letters),
    "DeclareOption": TexReader.option,
    "ProcessOptions": TexReader.process_options,
    "ExecuteOptions": TexReader.execute_options,
    "newtheorem": TexReader.new_theorem,
    "newcounter": TexReader.new_counter,
    "label": TexReader.label,
    **dict.fromkeys(
        ("appendix", "appendices"), lambda reader, token: reader.counters.appendix(token.word == "appendix")
    ),
    "setsecnumdepth": lambda reader, token: reader.counters.number_to(reader.word()),
    **dict.fromkeys(("addchap", "addsec"), TexReader.unnumbered),
    "mainmatter": lambda reader, token: reader.counters.matter(main=True),
    **dict.fromkeys(("frontmatter", "backmatter"), lambda reader, token: reader.counters.matter(main=False)),
    "ExplSyntaxOn": TexReader.expl3,
    "endinput": TexReader.end_file,
}

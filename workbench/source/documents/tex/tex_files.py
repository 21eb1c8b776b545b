"""Files that a document opens: its includes, and styles and classes in its folder."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from workbench.core.paper_errors import PaperError
from workbench.source.documents.source_view import Source
from workbench.source.documents.tex.displays import DisplayReader
from workbench.source.documents.tex.expander_state import Names
from workbench.source.documents.tex.macros import declared_by
from workbench.source.documents.tex.package_macros import PACKAGES
from workbench.source.documents.tex.tex_tokens import Lexer, Token, joined
from workbench.source.toml.file_bytes import may_be_read

_CLASS = ("documentclass", "LoadClass", "LoadClassWithOptions")
_STYLES = (".sty", ".cls", ".def", ".clo")
_MOST_FILES = 500
#: Commands whose folder is a separate argument.
FROM_FOLDER = ("import", "subimport", "includefrom", "inputfrom", "subincludefrom", "subinputfrom")
#: Commands that read a file in place.
INCLUDING = (*FROM_FOLDER, "input", "include", "subfile", "subfileinclude", "@input", "InputIfFileExists")


@dataclass(frozen=True)
class Directive:
    """A comment for the workbench: %! workbench: …"""

    text: str
    source: Source
    start: int


class FileReader(DisplayReader):
    """A reader of files. `root`: the folder of the main file."""

    def __init__(self, root: Path, overrides: Names | None = None) -> None:
        super().__init__(overrides)
        self.root = root
        self.directives: list[Directive] = []
        self.sources: list[Source] = []
        self.open_paths: list[Path] = []
        self.options: dict[str, Sequence[Token]] = {}  # of the style or class that is being read
        self.given: list[str] = []
        self.at_end: list[Token] = []
        self.global_options: list[str] = []

    def run(self) -> None:
        """Reads the opened files to their end."""
        raise NotImplementedError

    def read_file(self, path: Path) -> None:
        """Reads a file. Raises PaperError for the file itself; an unreadable include gives a warning."""
        self.open_file(Source.open(path))
        self.run()

    def open_file(self, source: Source) -> None:
        self.sources.append(source)
        self.open_paths.append(source.path)
        is_style = source.path.suffix in _STYLES
        self.open(Lexer(source.view(), self._directive, at_letter=is_style))

    def close(self, lexer: Lexer) -> None:
        if self.open_paths and lexer.view.source.path == self.open_paths[-1]:
            self.open_paths.pop()

    def include(self, token: Token) -> None:
        """Executes \\input and similar commands, and the branch of \\InputIfFileExists."""
        folder = joined(self.fully_expanded(self.argument())).strip() if token.word in FROM_FOLDER else ""
        name = (folder + self._file_name()).strip().strip('"')
        path = self._find(name, ("", ".tex"))
        if token.word == "InputIfFileExists":
            there, missing = self.argument(), self.argument()
            self.push(missing if path is None else there)
        elif path is None:
            self.warn(token, f"no file {name!r} beside this one; what it holds is not judged")
        if path is not None:
            self._tell_outside(token, name, path)
            self._open(token, path)

    def _tell_outside(self, token: Token, name: str, path: Path) -> None:
        """Warns about a file outside the folder of the text, which a copy of the folder would miss."""
        is_outside = not path.resolve().is_relative_to(self.root.resolve())
        if may_be_read(path) and (is_outside or Path(name).is_absolute()):
            why = "an absolute path" if Path(name).is_absolute() else "outside of the folder of the text"
            self.warn(token, f"{name!r} is {why}; it is read, but copy it beside the text and name it there")

    def use(self, token: Token) -> None:
        """Executes \\usepackage and \\documentclass: reads a style or class file in the folder of the
        text."""
        given = [part.strip() for part in joined(self.optional() or ()).split(",")]
        if token.word == "documentclass":
            self.global_options += given
        for name in (part.strip() for part in self.word().split(",")):
            if token.word in _CLASS:
                self.counters.use_class(name)
            path = self._find(name, (".sty", ".cls"))
            if path is None and "/" in name:
                self.warn(token, f"no style or class {name!r} beside this one")
            if path is None and name in PACKAGES:
                outer, self.waiting = self.waiting, []
                self.push(declared_by(PACKAGES[name], token))
                self.run()
                self.waiting = outer
            if path is not None:
                self._tell_outside(token, name, path)
                outer, self.waiting = self.waiting, []  # its open groups end with it
                known = self.options, self.given, self.at_end
                self.options, self.given, self.at_end = {}, given, []
                self._open(token, path)
                self.run()
                self.push(self.at_end)
                self.run()
                self.waiting, (self.options, self.given, self.at_end) = outer, known

    def at_end_of_style(self, token: Token) -> None:
        """Stores the code of \\AtEndOfPackage for the end of the file; it is not a group."""
        self.at_end += self.argument()

    def option(self, token: Token) -> None:
        """Stores the code of \\DeclareOption, which is executed for a given option."""
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

    def letters(self, token: Token) -> None:
        """Executes \\makeatletter and \\makeatother."""
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

    def _file_name(self) -> str:
        self.skip_spaces()
        near = self.peek()
        if near is None or near.text == "{":
            return joined(self.fully_expanded(self.argument()))
        taken = []
        while (near := self.peek()) is not None and near.text not in (" ", "\\par", "}") and not near.word:
            self.pop()
            taken.append(near)
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

"""Reader of TeX documents: files, sections, counters, and all displays."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from workbench.core.paper_errors import PaperError
from workbench.source.documents.source_view import Source
from workbench.source.documents.surrounding_words import plain
from workbench.source.documents.tex.display_list import add
from workbench.source.documents.tex.displays import CLOSING, DISPLAYS, Display, read_display
from workbench.source.documents.tex.expander_state import Macro, Names
from workbench.source.documents.tex.groups import CELL, end_mark
from workbench.source.documents.tex.groups import environment as group_of
from workbench.source.documents.tex.macros import DECLARATIONS
from workbench.source.documents.tex.numbering import SECTIONS
from workbench.source.documents.tex.tex_files import INCLUDING, Directive, FileReader
from workbench.source.documents.tex.tex_tokens import PARAGRAPH, Token, joined
from workbench.source.documents.tex.unprinted import (
    exclude,
    include,
    is_unprinted,
    listing,
    skip_environment,
    skip_verb,
    special,
)


@dataclass
class Text:
    """A document.

    labels: label → number.   warnings: each with file, line and column.
    fences: unexpandable macros that seem to be brackets, each with its body.   inline: formulas inside
    sentences.
    starts: heading, or label outside displays → index of the next display.
    """

    path: Path
    sources: list[Source] = field(default_factory=list)
    displays: list[Display] = field(default_factory=list)
    labels: dict[str, str | None] = field(default_factory=dict)
    directives: list[Directive] = field(default_factory=list)
    warnings: list[PaperError] = field(default_factory=list)
    macros: Names = field(default_factory=Names)
    fences: dict[str, str] = field(default_factory=dict)
    inline: list[Display] = field(default_factory=list)
    starts: dict[str, int] = field(default_factory=dict)


class TexReader(FileReader):
    """Reads the opened files to their end."""

    def __init__(self, root: Path, overrides: Names | None = None) -> None:
        super().__init__(root, overrides)
        self.displays: list[Display] = []
        self.inline: list[Display] = []
        self.starts: dict[str, int] = {}
        self.theorems: dict[str, str | None] = {}
        self.in_document = False
        self.hooks: dict[str, list[Token]] = {"begindocument": [], "enddocument": []}

    def has_more_than_declarations(self, closing: str | None) -> bool:
        """True if a formula that begins with declarations, which are executed, contains anything else."""
        while (token := self.pop()) is not None and token.text != closing:
            if token.word in _PREAMBLE:
                self._is_end(token)
            elif token.text != PARAGRAPH and not token.text.isspace():
                self.push([token])
                return True
        return False

    def run(self) -> None:
        while True:
            if (lexer := self.lexer()) is not None:
                lexer.skip_prose(self.groups.innermost == CELL)
            token = self.pop()
            if token is None:
                return
            if token.text == "$":
                self._dollar(token)
            elif token.text in _GROUP_TOKENS:
                self.follow_groups(token.text)
            elif token.word is not None and self._is_end(token):
                return

    def _dollar(self, token: Token) -> None:
        if self.take("$"):
            self._display(token, "$$")
        else:
            self._inline(token, "$")

    def _inline(self, opening: Token, environment: str) -> None:
        """Reads an inline formula up to the closing mark in this paragraph; an unmatched $ hides no
        display."""
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
        add(self.displays, read_display(self, token, environment))
        self.counters.end()

    def _is_end(self, token: Token) -> bool:
        """Executes a command; True if the document ends with it."""
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
                return not self._has_more(token)
            self._end(token, name)
            self.counters.end()
        elif word in SECTIONS:
            self._section(word)
        elif word and (command := _COMMANDS.get(word)):  # also if a class redefines it
            command(self, token)
        else:
            self.step(token)
        return False

    def _begin(self, token: Token, name: str) -> None:
        if is_unprinted(self, name):
            skip_environment(self, name)
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
        if name == "document":
            self.in_document = True
            self._run_hook("begindocument")
            return
        self.begin_environment(name)
        if (declared := self.names.environments.get(name)) is not None:
            self.expand(token.standing_for(f"\\{name}"), declared.begin)

    def _end(self, token: Token, name: str) -> None:
        declared = self.names.environments.get(name)
        if declared is None or name == "subequations":
            self.end_group(group_of(name))
        else:
            self.push([end_mark(token, group_of(name))])
            self.expand(token.standing_for(f"\\end{name}"), declared.end)
        if name == "subequations":
            self.counters.end_subequations()

    def read_file(self, path: Path) -> None:
        super().read_file(path)
        if not self.in_document:  # a file of macros
            self._run_hook("begindocument")
            self.run()

    def hook(self, token: Token) -> None:
        """Stores the code of \\AtBeginDocument and similar hooks for later; it is not a group."""
        name = _HOOKS[token.word] if token.word in _HOOKS else self.word()
        self.optional() if token.word == "AddToHook" else None
        code = self.argument()
        if name not in self.hooks:
            self.push([token.standing_for("{"), *code, token.standing_for("}")])
        elif name == "begindocument" and self.in_document:
            self.push(code)
        else:
            self.hooks[name] += code

    def _run_hook(self, name: str) -> None:
        code, self.hooks[name] = self.hooks[name], []
        self.push(code)

    def _has_more(self, token: Token) -> bool:
        """True if \\AtEndDocument has code, which is read before the document ends."""
        if not self.hooks["enddocument"]:
            return False
        self.push([token.standing_for(part) for part in ("\\end", "{", "document", "}")])
        self._run_hook("enddocument")
        return True

    def _section(self, name: str) -> None:
        starred = self.star()
        self.optional()
        self.heading = plain(joined(self.argument()))
        self.starts.setdefault(self.heading, len(self.displays))
        self.counters.step_section(name, starred)

    def unnumbered(self, token: Token) -> None:
        """Executes \\addchap and \\addsec."""
        outer = self.counters.values["secnumdepth"]
        self.counters.values["secnumdepth"] = -9
        self._section("chapter" if token.word == "addchap" else "section")
        self.counters.values["secnumdepth"] = outer

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
        name = self.word()
        self.labels.setdefault(name, self.counters.current)
        self.starts.setdefault(name, len(self.displays))

    def declare(self, name: str, macro: Macro, everywhere: bool = False) -> None:
        super().declare(name, macro, everywhere)
        if name.startswith("the") and name[3:] in self.counters.values and not macro.parameters:
            self.assign(self.counters.printed, name[3:], joined(macro.body), everywhere)


#: Commands of a formula that only declares macros, as for MathJax.
_PREAMBLE = frozenset(DECLARATIONS) | {
    "global",
    "long",
    "protected",
    "makeatletter",
    "makeatother",
    "usepackage",
    "require",
}
#: Tokens that stop prose and begin or end a group; & does so only in a cell.
_GROUP_TOKENS = frozenset({"{", "}", "&", "\\\\"})
_HOOKS = {
    **dict.fromkeys(("AtBeginDocument", "AtEndPreamble"), "begindocument"),
    "AtEndDocument": "enddocument",
}

_COMMANDS = {
    **dict.fromkeys(INCLUDING, TexReader.include),
    **dict.fromkeys(
        ("usepackage", "RequirePackage", "documentclass", "LoadClass", "LoadClassWithOptions"), TexReader.use
    ),
    **dict.fromkeys(("numberwithin", "counterwithin"), TexReader.number_within),
    "@addtoreset": lambda reader, token: reader.counters.within.update({reader.word(): reader.word()}),
    **dict.fromkeys(("counterwithout", "@removefromreset"), TexReader.without),
    **dict.fromkeys(("setcounter", "addtocounter", "stepcounter", "refstepcounter"), TexReader.count),
    **dict.fromkeys(("verb", "Verb", "lstinline", "mintinline", "path", "url", "nolinkurl"), skip_verb),
    **dict.fromkeys(("excludecomment", "excludeversion"), exclude),
    **dict.fromkeys(("includecomment", "includeversion"), include),
    "specialcomment": special,
    **dict.fromkeys(
        ("DefineVerbatimEnvironment", "lstnewenvironment", "newminted", "newtcblisting"), listing
    ),
    **dict.fromkeys(("makeatletter", "makeatother"), TexReader.letters),
    "DeclareOption": TexReader.option,
    "ProcessOptions": TexReader.process_options,
    "ExecuteOptions": TexReader.execute_options,
    **dict.fromkeys((*_HOOKS, "AddToHook"), TexReader.hook),
    **dict.fromkeys(("AtEndOfPackage", "AtEndOfClass"), TexReader.at_end_of_style),
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
    "require": lambda reader, token: reader.argument(),
}

"""Text that LaTeX omits or prints verbatim: excluded environments, listings and \\verb."""

from __future__ import annotations

import re
from collections.abc import Sequence

from workbench.source.documents.tex.expander_state import Environment, Macro, State
from workbench.source.documents.tex.tex_tokens import Lexer, Token, joined

_VERBATIM = frozenset((
    "verbatim", "verbatim*", "Verbatim", "Verbatim*", "BVerbatim", "LVerbatim", "SaveVerbatim", "VerbatimOut",
    "lstlisting", "minted", "minted*", "comment", "alltt", "filecontents", "filecontents*", "listing",
    "tcblisting", "pyconsole", "pycode", "pyblock", "sagesilent", "luacode", "luacode*", "tikzpicture", "asy",
    "Sinput", "Soutput", "rawhtml", "htmlonly",
))  # fmt: skip
_BRACE = re.compile(r"[{}]|\n[ \t]*\n")


def is_unprinted(reader: State, name: str) -> bool:
    """True if the environment contains no formulas: it is excluded or verbatim."""
    return not reader.names.printed.get(name, name not in _VERBATIM)


def is_verbatim(reader: State, begin: Sequence[Token]) -> bool:
    """True if the code at the beginning of an environment starts a verbatim one, as \\comment does."""
    return any(token.word in _VERBATIM and token.word not in reader.names.macros for token in begin)


def skip_environment(reader: State, name: str) -> None:
    """Skips the environment that has just been opened."""
    lexer = reader.lexer()
    if lexer is not None:
        lexer.skip_past(f"\\end{{{name}}}")
        return
    while (token := reader.pop()) is not None:
        if token.text == "\\end" and reader.word() == name:
            return


def exclude(reader: State, token: Token) -> None:
    """Executes \\excludecomment{name}."""
    reader.assign(reader.names.printed, reader.word(), False)


def include(reader: State, token: Token) -> None:
    """Executes \\includecomment{name}."""
    reader.assign(reader.names.printed, reader.word(), True)


def special(reader: State, token: Token) -> None:
    """Executes \\specialcomment{name}{before}{after}, which declares a printed environment."""
    name, before, after = reader.word(), reader.argument(), reader.argument()
    declared = Environment(Macro((), tuple(before)), Macro((), tuple(after)))
    reader.assign(reader.names.environments, name, declared)
    reader.assign(reader.names.printed, name, True)


def listing(reader: State, token: Token) -> None:
    """Executes \\lstnewenvironment{name} and similar commands, which declare a verbatim environment."""
    given = joined(reader.optional() or ()).strip()
    name = reader.word()
    if token.word == "newminted":
        name = given or f"{name}code"
    reader.assign(reader.names.printed, name, False)


def skip_verb(reader: State, token: Token) -> None:
    """Skips \\verb|…|, \\lstinline[…]{…}, \\mintinline[…]{language}|…|, \\url{…}."""
    lexer = reader.lexer()
    if lexer is None:
        return
    if lexer.text.startswith("*", lexer.position):
        lexer.position += 1
    if token.word in ("lstinline", "mintinline", "Verb"):
        _skip_pair(lexer, "[", "]")
    if token.word == "mintinline":
        _skip_pair(lexer, "{", "}")
    mark = lexer.text[lexer.position : lexer.position + 1]
    if mark == "{" and token.word != "verb":
        _skip_group(lexer)
    elif token.word not in ("url", "nolinkurl"):
        _skip_pair(lexer, mark, mark)


def _skip_pair(lexer: Lexer, opening: str, closing: str) -> None:
    """Skips the text between the marks on this line."""
    start = lexer.position + len(opening)
    if not opening or not lexer.text.startswith(opening, lexer.position):
        return
    lexer.position = start
    end_of_line = lexer.text.find("\n", start)
    end = lexer.text.find(closing, start)
    if end >= 0 and (end < end_of_line or end_of_line < 0):
        lexer.position = end + 1


def _skip_group(lexer: Lexer) -> None:
    """Skips the text between the braces, in this paragraph."""
    depth = 0
    for brace in _BRACE.finditer(lexer.text, lexer.position):
        depth += {"{": 1, "}": -1}.get(brace[0], -depth)
        if depth <= 0:
            lexer.position = brace.end() if brace[0] == "}" else lexer.position + 1
            return

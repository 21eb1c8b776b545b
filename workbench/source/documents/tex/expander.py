"""Expansion of the author's macros: an argument keeps its positions, a body has the position of the call."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.source.documents.tex.conditionals import (
    CHOICES,
    EXPANDABLE,
    conditional,
    decide,
    is_conditional,
    skip_branch,
    undecidable,
)
from workbench.source.documents.tex.expander_state import FALSE, TRUE, Macro, Parameter, State
from workbench.source.documents.tex.fences import fence_of
from workbench.source.documents.tex.groups import BEGINGROUP, ended_by
from workbench.source.documents.tex.macros import DECLARATIONS
from workbench.source.documents.tex.stream import MOST_PUSHED
from workbench.source.documents.tex.tex_tokens import Call, Token, first_group

#: Limit on the nesting of macros, which only recursive macros exceed.
DEEPEST = 60
_PREFIXES = frozenset({"global", "long", "outer", "protected"})
#: Names of braces.
_IMPLICIT = {"bgroup": "{", "egroup": "}"}


class Expander(State):
    """Executes declarations and expands conditionals and macros while reading."""

    def step(self, token: Token) -> bool:
        """True if the token was a declaration, a conditional or a macro; its expansion is read next."""
        word = token.word
        if word is None:
            return False
        if (kind := ended_by(token)) is not None:
            self.end_group(kind)
            return True
        if word in self.names.macros and not token.final:
            return self.expand(token, self.names.macros[word])
        if word in DECLARATIONS:
            DECLARATIONS[word](self, token)
        elif word in _PREFIXES:
            self._prefixed(word)
        elif word == "begingroup":
            self.groups.begin(BEGINGROUP)
        elif word == "endgroup":
            self.end_group(BEGINGROUP)
        elif word in _IMPLICIT:
            self.push([token.standing_for(_IMPLICIT[word])])
        elif word in CHOICES:
            self.push(CHOICES[word](self, token))
        elif word == "else":
            skip_branch(self, to_else=False)
        elif word == "fi":
            return True
        elif is_conditional(self, word):
            self._conditional(token)
        else:
            return self._sets_flag(word)
        return True

    def _prefixed(self, word: str) -> None:
        """Executes the declaration after \\global and similar prefixes."""
        prefixes = {word}
        self.skip_spaces()
        while (token := self.pop()) is not None:
            if token.word in _PREFIXES:
                prefixes.add(token.word)
            elif not (token.word in self.names.macros and self.step(token)):
                break
            self.skip_spaces()
        if token is None:
            return
        self.prefixes = frozenset(prefixes)
        obeyed = self.step(token)
        self.prefixes = frozenset()
        if not obeyed:
            self.push([token])

    def _sets_flag(self, word: str) -> bool:
        """True if the word is \\nametrue or \\namefalse; it is then executed."""
        for ending, value in (("true", True), ("false", False)):
            name = word.removesuffix(ending)
            if name != word and name in self.names.flags:
                self.assign(self.names.flags, name, value, "global" in self.prefixes)
                return True
        return False

    def _conditional(self, token: Token) -> None:
        holds = decide(self, token)
        if holds is None:
            self.undecided(token)
        if holds is False:
            skip_branch(self, to_else=True)

    def fully_expanded(self, body: Sequence[Token]) -> list[Token]:
        outer, self.waiting = self.waiting, [*reversed(body)]
        made: list[Token] = []
        while (token := self.pop()) is not None:
            made += self._unexpandable(token)
        self.waiting = outer
        return made

    def _unexpandable(self, token: Token) -> Sequence[Token]:
        """Returns the unexpandable part of the token in \\edef; its expansion is read next."""
        word = token.word
        if word is None or token.final:
            return [token]
        if word == "noexpand":
            following = self.pop()
            return [] if following is None else [following]
        if word in ("unexpanded", "detokenize"):
            return self.argument()
        macro = self.names.macros.get(word)
        if macro is not None:
            return [token] if _stays(macro) or not self.expand(token, macro) else []
        if word in EXPANDABLE:
            self.push(CHOICES[word](self, token))
            return []
        if is_conditional(self, word):
            return self._undecided_conditional(token)
        return [] if word in ("else", "fi") and self.step(token) else [token]

    def _undecided_conditional(self, token: Token) -> Sequence[Token]:
        """Returns a conditional that the text does not decide; [] if it does."""
        before = [*self.waiting]
        holds = decide(self, token)
        if holds is None:
            self.waiting = before
            return [token, *conditional(self)]
        if holds is False:
            skip_branch(self, to_else=True)
        return []

    def expand(self, token: Token, macro: Macro) -> bool:
        """Expands a macro; False for a macro that is left unexpanded."""
        name = _named(token)
        if macro.keeps:
            (kept,) = macro.body
            call = _call(token, macro)
            self.push([Token(kept.text, token.source, token.start, token.end, call, final=True)])
            return True
        if name in self.opaque or not self._can_expand(token, macro):
            self.left_opaque.add(name)
            return False
        arguments = self._arguments(macro)
        self.push(_body(macro.body, arguments, token, _call(token, macro)))
        return True

    def _can_expand(self, token: Token, macro: Macro) -> bool:
        if (token.call is not None and token.call.depth >= DEEPEST) or self.pushed > MOST_PUSHED:
            self.warn(token, f"{token.text} calls itself without end; it is left as it stands")
            self.opaque.add(_named(token))
            return False
        if (cause := undecidable(self, macro)) is not None:
            if not self.in_formula:  # discard its settings, keep its declarations
                return any(part.word in DECLARATIONS for part in macro.body)
            if (fence := fence_of(macro)) is not None:
                self.fences[_named(token)] = fence
            self.warn(
                token, f"{token.text} needs {cause}, which only TeX can follow; it is left as it stands"
            )
            return False
        return True

    def _arguments(self, macro: Macro) -> list[Sequence[Token]]:
        for text in macro.prefix:
            if text != " ":
                self.skip_spaces()
            self.take(text)
        return [taken for p in macro.parameters if (taken := self._argument(p)) is not None and p.counted]

    def _argument(self, parameter: Parameter) -> Sequence[Token]:
        match parameter.kind:
            case "braces":
                return self.argument()
            case "until":
                return _unbraced(self.until(parameter.marks))
            case "star":
                return self._marker(self.star())
            case "token":
                self.skip_spaces()
                return self._marker(self.take(parameter.marks[0]))
            case _:
                given = self.optional(*parameter.marks)
                return parameter.default or () if given is None else given

    def _marker(self, holds: bool) -> Sequence[Token]:
        near = self.peek()
        return [] if near is None else [near.standing_for(TRUE if holds else FALSE)]


def _stays(macro: Macro) -> bool:
    """True if \\edef leaves the macro unexpanded, as it does with one that looks for a star or a bracket."""
    return macro.keeps or macro.protected or any(p.kind not in ("braces", "until") for p in macro.parameters)


def _named(token: Token) -> str:
    """The name of a macro's token."""
    assert token.word is not None, f"{token.text} is no command"
    return token.word


def _call(token: Token, macro: Macro) -> Call:
    return Call(token.text[1:], token.call, token.call.depth + 1 if token.call else 1)


def _unbraced(tokens: Sequence[Token]) -> Sequence[Token]:
    """Returns x for {x}, if the braces match."""
    if len(tokens) < 2 or tokens[0].text != "{" or tokens[-1].text != "}":
        return tokens
    first, _ = first_group(tokens)
    return tokens[1:-1] if len(first) == len(tokens) else tokens


def _body(
    body: Sequence[Token], arguments: Sequence[Sequence[Token]], token: Token, call: Call
) -> list[Token]:
    made: list[Token] = []
    for part in body:
        if part.text[0] != "#" or len(part.text) == 1:
            made.append(Token(part.text, token.source, token.start, token.end, call, part.final))
        elif part.text[1] == "#":  # a parameter of a macro that the body declares
            made.append(Token(part.text[1:], token.source, token.start, token.end, call))
        elif (place := int(part.text[1]) - 1) < len(arguments):
            made += arguments[place]
    return made

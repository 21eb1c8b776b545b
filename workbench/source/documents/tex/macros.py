"""Macros and their declarations: \\newcommand, \\def, \\let, \\NewDocumentCommand and similar commands."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from workbench.source.documents.source_view import Source, View
from workbench.source.documents.tex.expander_state import NO_VALUE, Environment, Macro, Parameter, State
from workbench.source.documents.tex.tex_tokens import Token, first_group, joined, lex
from workbench.source.documents.tex.unprinted import is_verbatim


def _braces(count: int) -> tuple[Parameter, ...]:
    return (Parameter("braces"),) * count


def _number(tokens: Sequence[Token] | None) -> int:
    text = joined(tokens or ()).strip()
    return min(int(text), 9) if text.isdecimal() else 0


def _name(expander: State) -> str | None:
    """Returns the control sequence to be declared, with or without braces around it."""
    tokens = [token for token in expander.argument() if token.text != " "]
    return tokens[0].word or tokens[0].text if tokens else None


def _newcommand(expander: State, token: Token) -> None:
    expander.star()
    name, count, default, body = (
        _name(expander),
        _number(expander.optional()),
        expander.optional(),
        expander.argument(),
    )
    parameters = _braces(count)
    if default is not None and count:
        parameters = (Parameter("optional", ("[", "]"), tuple(default)), *_braces(count - 1))
    known = name in expander.names.macros
    if name is not None and not (token.word == "providecommand" and known):
        expander.declare(name, Macro(parameters, tuple(body)))


def _def(expander: State, token: Token) -> None:
    expander.skip_spaces()
    everywhere = token.word in ("gdef", "xdef") or "global" in expander.prefixes
    protected = "protected" in expander.prefixes
    name = expander.pop()
    pattern: list[Token] = []
    while (following := expander.pop_within()) is not None:
        if following.text in ("{", "}"):
            expander.push([following])
            break
        pattern.append(following)
    body = expander.argument()
    if name is None or name.word is None:
        return
    if token.word in ("edef", "xdef"):
        body = expander.fully_expanded(body)
    prefix: list[str] = []
    parameters: list[tuple[Parameter, list[str]]] = []
    for each in pattern:
        if each.text.startswith("#") and len(each.text) > 1:
            parameters.append((Parameter("braces"), []))
        elif each.text == "#":
            continue
        elif parameters:
            parameters[-1][1].append(each.text)
        else:
            prefix.append(each.text)
    made = tuple(Parameter("until", tuple(marks)) if marks else bare for bare, marks in parameters)
    macro = Macro(made, tuple(body), tuple(prefix), protected=protected)
    expander.declare(name.word, macro, everywhere)


def _let(expander: State, token: Token) -> None:
    everywhere = "global" in expander.prefixes
    name = _name(expander)
    expander.skip_spaces()
    if expander.take("="):
        expander.skip_spaces()
    target = expander.pop()
    if name is None or target is None:
        return
    if name.startswith("if") and (flag := _flag_of(expander, target)) is not None:
        expander.assign(expander.names.flags, name[2:], flag, everywhere)
        return
    macro = expander.names.macros.get(target.word or "")
    expander.declare(name, macro or Macro((), (target,), keeps=True), everywhere)


def _flag_of(expander: State, target: Token) -> bool | None:
    """Returns the value of \\iftrue, \\iffalse or a flag of the author; None for other tokens."""
    if target.word in ("iftrue", "iffalse"):
        return target.word == "iftrue"
    return (
        expander.names.flags.get((target.word or "").removeprefix("if"))
        if target.text[:3] == "\\if"
        else None
    )


def _operator(expander: State, token: Token) -> None:
    star = "*" if expander.star() else ""
    name, body = _name(expander), expander.argument()
    if name is not None:
        made = [*_made(f"\\operatorname{star}{{", token), *body, *_made("}", token)]
        expander.declare(name, Macro((), tuple(made)))


#: \name*{…} and \name[\big]{…} differ from \name{…} in size only.
_SIZE = (Parameter("star", counted=False), Parameter("optional", ("[", "]"), (), counted=False))


def _delimiter(expander: State, token: Token) -> None:
    name, left, right = _name(expander), expander.argument(), expander.argument()
    _declare_delimiter(expander, token, name, 1, left, right, _made("#1", token))


def _delimiter_of_several(expander: State, token: Token) -> None:
    name, count = _name(expander), _number(expander.optional())
    left, right, body = expander.argument(), expander.argument(), expander.argument()
    _declare_delimiter(expander, token, name, count, left, right, body)


def _declare_delimiter(
    expander: State,
    token: Token,
    name: str | None,
    count: int,
    left: Sequence[Token],
    right: Sequence[Token],
    inside: Sequence[Token],
) -> None:
    body = [*_made("\\left", token), *left, *inside, *_made("\\right", token), *right]
    if name is not None:
        expander.declare(name, Macro((*_SIZE, *_braces(count)), tuple(body)))


def _document_command(expander: State, token: Token) -> None:
    name, spec, body = _name(expander), expander.argument(), expander.argument()
    if name is None:
        return
    parameters = parameters_of(spec)
    if parameters is None:
        message = f"the arguments {joined(spec).strip()!r} of \\{name} are not understood"
        expander.warn(token, f"{message}; \\{name} is left as it stands")
        expander.opaque.add(name)
    elif not (token.word == "ProvideDocumentCommand" and name in expander.names.macros):
        expander.declare(name, Macro(parameters, tuple(body), protected=True))


def parameters_of(spec: Sequence[Token]) -> tuple[Parameter, ...] | None:
    """Returns the parameters of an xparse specification; None if it uses more than tokens and brackets."""
    waiting = [token for token in spec if token.text != " "]
    made: list[Parameter] = []

    def group() -> tuple[Token, ...]:
        taken, waiting[:] = first_group(waiting)
        return tuple(taken[1:-1] if taken and taken[0].text == "{" else taken)

    while waiting:
        kind = waiting.pop(0)
        missing = (kind.standing_for(NO_VALUE),)
        match kind.text:
            case "+" | "!":
                continue
            case "m":
                made.append(Parameter("braces"))
            case "s":
                made.append(Parameter("star"))
            case "t":
                made.append(Parameter("token", tuple(token.text for token in group())))
            case "o":
                made.append(Parameter("optional", ("[", "]"), missing))
            case "O":
                made.append(Parameter("optional", ("[", "]"), group()))
            case "g":
                made.append(Parameter("optional", ("{", "}"), missing))
            case "d" | "D" | "r" | "R":
                marks = tuple(joined(group()) for _ in range(2))
                default = group() if kind.text in "DR" else missing
                made.append(Parameter("optional", marks, default))
            case _:
                return None
    return tuple(made)


def _environment(expander: State, token: Token) -> None:
    expander.star()
    name, count, default = expander.word(), _number(expander.optional()), expander.optional()
    begin, end = expander.argument(), expander.argument()
    parameters = _braces(count)
    if default is not None and count:
        parameters = (Parameter("optional", ("[", "]"), tuple(default)), *_braces(count - 1))
    _declare_environment(expander, token, name, parameters, begin, end)


def _document_environment(expander: State, token: Token) -> None:
    name, parameters = expander.word(), parameters_of(expander.argument())
    begin, end = expander.argument(), expander.argument()
    _declare_environment(expander, token, name, parameters or (), begin, end)


def _declare_environment(
    expander: State,
    token: Token,
    name: str,
    parameters: tuple[Parameter, ...],
    begin: Sequence[Token],
    end: Sequence[Token],
) -> None:
    declared = Environment(Macro(parameters, tuple(begin)), Macro((), tuple(end)))
    expander.assign(expander.names.environments, name, declared)
    expander.assign(expander.names.printed, name, not is_verbatim(expander, begin))


def _flag(expander: State, token: Token) -> None:
    name = _name(expander) or ""
    if name.startswith("if"):
        expander.assign(expander.names.flags, name[2:], False)


def declared_by(latex: str, token: Token) -> list[Token]:
    """Returns the tokens of a package's declarations, with the position of the command that loads it."""
    return _made(latex, token)


def _made(latex: str, token: Token) -> list[Token]:
    """Returns tokens for the LaTeX with the position of `token`."""
    return lex(View(latex, token.source, [token.start] * (len(latex) + 1)))


def named(bodies: Mapping[str, str], path: Path) -> dict[str, Macro]:
    """Returns macros by their bodies, which determine the number of arguments; starred forms are treated
    alike."""
    made = {}
    for name, body in bodies.items():
        source = Source(path, body)
        tokens = tuple(lex(source.view()))
        count = max((int(t.text[1:]) for t in tokens if re.fullmatch(r"#\d", t.text)), default=0)
        star = Parameter("star", counted=False)
        made[name.removeprefix("\\")] = Macro((star, *_braces(count)) if count else (), tokens)
    return made


Declaration = Callable[[State, Token], None]

DECLARATIONS: dict[str, Declaration] = {
    **dict.fromkeys(("newcommand", "renewcommand", "providecommand", "DeclareRobustCommand"), _newcommand),
    **dict.fromkeys(("def", "gdef", "edef", "xdef"), _def),
    **dict.fromkeys(("newenvironment", "renewenvironment"), _environment),
    **dict.fromkeys(
        (f"{verb}DocumentCommand" for verb in ("New", "Renew", "Provide", "Declare")), _document_command
    ),
    **dict.fromkeys(
        (f"{verb}DocumentEnvironment" for verb in ("New", "Renew", "Provide", "Declare")),
        _document_environment,
    ),
    "let": _let,
    "DeclareMathOperator": _operator,
    "DeclarePairedDelimiter": _delimiter,
    "DeclarePairedDelimiterX": _delimiter_of_several,
    "newif": _flag,
}

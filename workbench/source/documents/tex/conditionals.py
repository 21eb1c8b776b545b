"""Conditionals that the text alone decides. Others stay as they are; they are never guessed."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial

from workbench.source.documents.tex.expander_state import FALSE, NO_VALUE, TRUE, Macro, State
from workbench.source.documents.tex.tex_tokens import Token, first_group, joined

_ENGINE = {"ifpdf": True, "iftrue": True, "iffalse": False}
_ENGINE |= dict.fromkeys(("ifxetex", "ifluatex", "ifXeTeX", "ifLuaTeX", "ifxetexorluatex"), False)
_OF_TEX = frozenset(
    [
        "if",
        "ifx",
        "ifnum",
        "ifdim",
        "ifodd",
        "ifcat",
        "ifcase",
        "ifmmode",
        "ifhmode",
        "ifvmode",
        "ifinner",
        "ifvoid",
        "ifhbox",
        "ifvbox",
        "ifeof",
        "ifdefined",
        "ifcsname",
        "iftwoside",
        "unless",
    ]
) | set(_ENGINE)
_UNDEFINED = ("\\undefined", "\\@undefined")


def is_conditional(expander: State, word: str) -> bool:
    """True if the word begins a conditional that ends with \\fi."""
    return word in _OF_TEX or (word.startswith("if") and word[2:] in expander.names.flags)


def decide(expander: State, token: Token) -> bool | None:
    """Returns whether the branch that follows is taken; None if the text does not decide it."""
    word = token.word or ""
    if word[2:] in expander.names.flags:
        return expander.names.flags[word[2:]]
    match word:
        case "ifmmode":
            return expander.in_formula
        case "ifx":
            return _same(expander)
        case "ifnum":
            return _numbers(expander)
        case "ifdefined":
            name = expander.pop()
            return True if name is not None and name.word in expander.names.macros else None
        case _:
            return _ENGINE.get(word)


def skip_branch(expander: State, to_else: bool) -> None:
    """Skips past \\fi, or past the \\else that belongs to the conditional."""
    depth = 0
    while (token := expander.pop_within()) is not None:
        word = token.word
        if word == "fi":
            if depth == 0:
                return
            depth -= 1
        elif word == "else" and depth == 0 and to_else:
            return
        elif word is not None and is_conditional(expander, word):
            depth += 1


def conditional(expander: State) -> list[Token]:
    r"""Returns the tokens after the conditional up to and including its \fi."""
    taken: list[Token] = []
    depth = 1
    while depth and (token := expander.pop_within()) is not None:
        taken.append(token)
        depth += is_conditional(expander, token.word or "") - (token.word == "fi")
    return taken


def _same(expander: State) -> bool | None:
    left, right = expander.pop(), expander.pop()
    if left is None or right is None:
        return None
    if left.text == right.text:
        return True
    if left.text in _UNDEFINED or right.text in _UNDEFINED:
        other = right if left.text in _UNDEFINED else left
        return False if other.word in expander.names.macros else None
    meanings = [_meaning(expander, token) for token in (left, right)]
    return None if None in meanings else meanings[0] == meanings[1]


def _meaning(expander: State, token: Token) -> tuple[object, ...] | None:
    if token.word is None or token.text in ("\\\\", "\\relax"):
        return ("token", token.text)
    if token.word == "@empty":
        return ("macro", (), "")
    macro = expander.names.macros.get(token.word)
    if macro is None:
        return None
    if macro.keeps:
        return ("token", macro.body[0].text)
    return ("macro", macro.parameters, joined(macro.body))


def _numbers(expander: State) -> bool | None:
    taken: list[Token] = []
    text = ""
    while (token := expander.pop()) is not None:
        taken.append(token)
        if token.text not in "0123456789<=>- ":
            expander.push(taken[-1:])
            taken.pop()
            break
        text += token.text
        if token.text == " " and text.rstrip()[-1:].isdigit() and any(sign in text for sign in "<=>"):
            break
    for sign, holds in (("<", int.__lt__), ("=", int.__eq__), (">", int.__gt__)):
        left, found, right = text.partition(sign)
        if found and _is_integer(left) and _is_integer(right):
            return holds(int(left), int(right))
    expander.push(taken)
    return None


def _is_integer(text: str) -> bool:
    digits = text.strip().removeprefix("-")
    return digits.isdecimal() and len(digits) < 10


def _chosen(expander: State, holds: bool | None, token: Token) -> Sequence[Token]:
    """Returns the applicable one of two arguments."""
    yes, no = expander.argument(), expander.argument()
    if holds is None:
        expander.undecided(token)
    return no if holds is False else yes


def _one_of(expander: State, holds: bool) -> Sequence[Token]:
    body = expander.argument()
    return body if holds else ()


def _is(expander: State, marker: str) -> bool:
    tokens = [token for token in expander.argument() if token.text != " "]
    return len(tokens) == 1 and tokens[0].text == marker


def _empty(expander: State) -> bool:
    return not joined(expander.argument()).strip()


def _branches(expander: State, token: Token, tests: int) -> Sequence[Token]:
    """Returns the applicable of two arguments after an undecided test: in a formula the first, elsewhere
    both."""
    for _ in range(tests):
        expander.argument()
    yes, no = expander.argument(), expander.argument()
    if expander.in_formula:
        expander.undecided(token)
        return yes
    return [*yes, *no]


def _equal_strings(expander: State) -> bool:
    return joined(expander.argument()).strip() == joined(expander.argument()).strip()


def _ifthenelse(expander: State, token: Token) -> Sequence[Token]:
    test = [each for each in expander.argument() if each.text != " "]
    holds = None
    if test and test[0].text == "\\equal":
        after = list(test[1:])
        texts = []
        for _ in range(2):
            piece, after = first_group(after)
            texts.append(joined(piece).strip("{} "))
        holds = texts[0] == texts[1]
    return _chosen(expander, holds, token)


def _next_character(expander: State, token: Token) -> Sequence[Token]:
    wanted = expander.argument()
    yes, no = expander.argument(), expander.argument()
    expander.skip_spaces()
    following = expander.peek()
    is_next = following is not None and [each.text for each in wanted] == [following.text]
    return yes if is_next else no


def _display_style(expander: State, token: Token) -> Sequence[Token]:
    styles = [expander.argument() for _ in range(4)]
    return styles[0]


Choice = Callable[[State, Token], Sequence[Token]]

#: Commands that expand to one of their arguments.
CHOICES: dict[str, Choice] = {
    "IfNoValueTF": lambda e, t: _chosen(e, _is(e, NO_VALUE), t),
    "IfNoValueT": lambda e, t: _one_of(e, _is(e, NO_VALUE)),
    "IfNoValueF": lambda e, t: _one_of(e, not _is(e, NO_VALUE)),
    "IfValueTF": lambda e, t: _chosen(e, not _is(e, NO_VALUE), t),
    "IfValueT": lambda e, t: _one_of(e, not _is(e, NO_VALUE)),
    "IfValueF": lambda e, t: _one_of(e, _is(e, NO_VALUE)),
    "IfBooleanTF": lambda e, t: _chosen(e, _is(e, TRUE), t),
    "IfBooleanT": lambda e, t: _one_of(e, _is(e, TRUE)),
    "IfBooleanF": lambda e, t: _one_of(e, _is(e, FALSE)),
    "ifstrempty": lambda e, t: _chosen(e, _empty(e), t),
    "ifblank": lambda e, t: _chosen(e, _empty(e), t),
    "notblank": lambda e, t: _chosen(e, not _empty(e), t),
    "ifstrequal": lambda e, t: _chosen(e, _equal_strings(e), t),
    "ifthenelse": _ifthenelse,
    "@ifnextchar": _next_character,
    "@ifstar": lambda e, t: _chosen(e, e.star(), t),
    "@firstofone": lambda e, t: e.argument(),
    "@firstoftwo": lambda e, t: _chosen(e, True, t),
    "@secondoftwo": lambda e, t: _chosen(e, False, t),
    **dict.fromkeys(
        (
            "@ifundefined",
            "@ifpackageloaded",
            "@ifclassloaded",
            "ifundef",
            "ifdef",
            "ifcsundef",
            "ifcsdef",
            "ifbool",
            "iftoggle",
            "IfFileExists",
            "IfPackageLoadedTF",
            "IfClassLoadedTF",
        ),
        partial(_branches, tests=1),
    ),
    **dict.fromkeys(("@ifpackagelater", "@ifclasslater", "ifdefstring"), partial(_branches, tests=2)),
    "texorpdfstring": lambda e, t: _chosen(e, True, t),
    "ensuremath": lambda e, t: e.argument(),
    "mathchoice": _display_style,
    "protect": lambda e, t: (),
    "xspace": lambda e, t: (),
    "relax": lambda e, t: (),
}


#: The choices that \edef expands.
EXPANDABLE = frozenset(
    name
    for name in CHOICES
    if name.startswith(("IfNoValue", "IfValue", "IfBoolean", "@firstof", "@secondof"))
) | {"ifstrempty", "ifblank", "notblank"}


def undecidable(expander: State, macro: Macro) -> str | None:
    """Returns a command in the macro's body that only a complete TeX could execute; None if there is none."""
    for token in macro.body:
        word = token.word
        if word is None or word in expander.names.macros or word in CHOICES:
            continue
        if word in _LOW or ("@" in word and not _is_flag_command(expander, word)):
            return token.text
        if word in ("if", "ifcat", "ifdim", "ifcase", "ifodd", "ifcsname", "unless"):
            return token.text
    return None


def _is_flag_command(expander: State, word: str) -> bool:
    flags = expander.names.flags
    return word[2:] in flags or word.removesuffix("true") in flags or word.removesuffix("false") in flags


_LOW = frozenset((
    "csname", "expandafter", "futurelet", "aftergroup", "hbox", "vbox",
    "setbox", "settowidth", "setlength", "Udelimiter", "catcode", "mathcode", "noexpand",
    "afterassignment", "halign",
))  # fmt: skip

"""Rewriting of a text's presentational TeX to the claim language. Every token keeps its position."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Sequence
from itertools import pairwise
from typing import TypeAlias

from workbench.core.brackets import nesting
from workbench.language.grammar.formula_tokens import MOST_CHARACTERS
from workbench.language.grammar.vocabulary import WORDS
from workbench.source.documents import Token
from workbench.source.rewriting.author_habits import as_read, everywhere
from workbench.source.rewriting.column_separators import bar_of_a_set
from workbench.source.rewriting.plain_tex import with_nuclei, with_typefaces, without_kerns
from workbench.source.rewriting.token_groups import braced, closing
from workbench.source.rewriting.wrappers import MATH_SHIFTS, OF_WORDS, WRAPPERS

_DROPPED = frozenset((
    "displaystyle", "textstyle", "scriptstyle", "nolimits", "limits", "mathstrut", "strut", "nobreak",
    "allowbreak", "noindent", "centering", "smallskip", "medskip", "bigskip", "par", "space", "left.",
    "right.", "null", "middle", "kern-", "protect", "relax", "linebreak", "nonumber", "notag", "normalsize",
    "small", "footnotesize", "scriptsize", "tiny", "large", "boldmath", "unboldmath", "qedhere",
    "IEEEeqnarraynumspace", "IEEEyesnumber", "IEEEnonumber", "IEEEyessubnumber", "IEEEnosubnumber",
    "medspace", "thickspace", "negthinspace", "negmedspace", "negthickspace",
))  # fmt: skip
_DROPPED_WITH_ARGUMENT = frozenset(
    ["hspace", "vspace", "vphantom", "color", "label", "hskip", "mspace", "require"]
)
#: Commands that separate formulas like a wide space.
_WIDE = frozenset({"hfill", "hfil", "therefore", "because"})
_WIDE_WITH_ARGUMENT = frozenset({"phantom", "hphantom"})
_UNWRAPPED = frozenset((
    "mathclap", "mathrlap", "mathllap", "mathop", "mathopen", "mathclose", "mathinner", "underbrace",
    "overbrace", "underbracket", "overbracket", "cancel", "substack", "displaylines", *WRAPPERS,
))  # fmt: skip
#: Commands of packages (physics, mathtools' usual names) that put their argument between two signs.
_DELIMITED = {"norm": "\\|", "abs": "|"}
#: Bold letters, arrows and hats of the package physics; with a star they are slanted.
_STARRED = frozenset({"vb", "va", "vu"})
#: Functions with a command in the package physics.
_FUNCTIONS = frozenset({"tr", "Tr"})
_BIG = frozenset({"big", "Big", "bigg", "Bigg"})
_ROUND = (("\\left", "("), ("\\right", ")"))
_LIMITS_ARE_NOTES = frozenset({"underbrace", "overbrace", "underbracket", "overbracket"})
_OPERATORS = frozenset({"operatorname", "symup"})
_TEXTS = frozenset({"mbox", "text", "hbox", "textrm"})
_GROUPS = frozenset({"SO", "SE", "so", "se"})
_OVER = frozenset({"overset", "stackrel", "underset"})
_NO_NOTES = frozenset({"\\sim", "\\approx", "\\cdot", "\\circ", "\\wedge", "\\triangle", "\\Delta"})
_BOLD = frozenset({"\\boldmath", "\\bf", "\\bfseries"})
#: Letters of sets with commands in KaTeX.
_BLACKBOARD = frozenset("RNZC")
_TYPED = {(":", "="): ":=", ("=", ":"): "=", ("=", ">"): "\\Rightarrow", ("\\not", "="): "\\neq"}
_RENAMED = {
    **dict.fromkeys(("mathbfit", "symbf", "symbfit", "bm", "pmb", "mathbold"), "\\boldsymbol"),
    "vb": "\\mathbf",
    "va": "\\vec",
    "vu": "\\hat",
    "cross": "\\times",
    "vdot": "\\cdot",
    "mathbfup": "\\mathbf",
    "lbrace": "\\{",
    "rbrace": "\\}",
    "lparen": "(",
    "rparen": ")",
    "lbrack": "[",
    "rbrack": "]",
    "Vert": "\\|",
    "vert": "|",
    "mid": "|",
    "defeq": ":=",
    "coloneq": ":=",
    "coloneqq": ":=",
    "eqqcolon": "=",
    "vcentcolon": ":",
    "colon": ":",
    "triangleq": ":=",
    "leqslant": "\\leq",
    "geqslant": "\\geq",
    "dfrac": "\\frac",
    "tfrac": "\\frac",
    "cfrac": "\\frac",
    "cr": "\\\\",
}


def respelled(tokens: Sequence[Token], words: Collection[str] = ()) -> list[Token]:
    """Returns the tokens without spacing, colours and numbers, with bold italics and brackets by known names.

    words: adjacent letters that spell one of these become the command of that name. Formulas over the length
    limit stay unchanged.
    """
    if len(tokens) > MOST_CHARACTERS:
        return list(tokens)
    made = list(_respelled(list(with_nuclei(as_read(list(with_typefaces(list(without_kerns(tokens)))))))))
    made = everywhere(made, bar_of_a_set)
    if any(token.word in _OPERATORS for token in tokens):
        made = _tidied(made)
    return list(_with_words(made, words))


def _tidied(tokens: list[Token]) -> list[Token]:
    """Returns the tokens without braces and scripts that print nothing: \\frac{d^{} {f}}{{d{t}}^{}}, as
    macros write."""
    made: list[Token] = []
    place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        if token.text in ("^", "_"):
            inside, end = argument(tokens, place)
            if not any(each.text != " " for each in inside):
                place = end
                continue
        if token.text == "{":
            inside, end = argument(tokens, place - 1)
            inside = _tidied(inside)
            first = next((each.text for each in inside if each.text != " "), None)
            before = next((each.text for each in reversed(made) if each.text != " "), None)
            is_single = sum(each.text != " " for each in inside) < 2
            is_differential = first == "d" or (before == "d" and is_single)
            if is_differential and not _opens_argument(made):
                made += inside
            elif first != "{" or _group_end(inside) < len(inside):
                made += [token, *inside, tokens[end - 1]]
            else:
                made += inside
            place = end
            continue
        made.append(token)
    return made


def _opens_argument(before: list[Token]) -> bool:
    """True if the braces that follow contain an argument of \\frac."""
    texts = [token.text for token in before if token.text != " "]
    depth = 0
    for back, text in enumerate(reversed(texts)):
        depth += nesting(text, "}", "{")
        if depth == 0 and text not in ("}",):
            follows = text == "\\frac" or (text == "{" and texts[-back - 2 : -back - 1] == ["\\frac"])
            return follows
    return False


def _group_end(tokens: list[Token]) -> int:
    return argument(tokens, 0)[1]


def _with_words(tokens: list[Token], words: Collection[str]) -> Iterator[Token]:
    place = 0
    while place < len(tokens):
        word = next((word for word in words if _spells(tokens[place : place + len(word)], word)), None)
        is_inverse = any(_spells(tokens[max(0, place - len(arc)) : place], arc) for arc in ("arc", "a"))
        if word is None or is_inverse or _is_upright(tokens, place):
            yield tokens[place]
            place += 1
            continue
        first, last = tokens[place], tokens[place + len(word) - 1]
        yield Token(f"\\{word}", first.source, first.start, last.end, first.call)
        place += len(word)


def _is_upright(tokens: Sequence[Token], place: int) -> bool:
    """True if the word is the contents of \\text{cos} or the like, which is read as that function."""
    before = [token for token in tokens[:place][-2:] if token.text != " "]
    return len(before) == 2 and before[1].text == "{" and before[0].word in (*_TEXTS, "operatorname")


def _spells(tokens: Sequence[Token], word: str) -> bool:
    """True if the author wrote the word without anything between its letters."""
    if "".join(token.text for token in tokens) != word or len(tokens) != len(word):
        return False
    return all(one.end == other.start for one, other in pairwise(tokens))


def _respelled(tokens: list[Token]) -> Iterator[Token]:
    place = 0
    while place < len(tokens):
        token = tokens[place]
        place += 1
        if token.text in ("^", "_") and _is_empty(tokens, place) and not _is_empty(tokens, place - 3):
            place += 2
        elif place < len(tokens) and (sign := _TYPED.get((token.text, tokens[place].text))):
            following = tokens[place]
            yield Token(sign, token.source, token.start, max(token.end, following.end), token.call)
            place += 1
        elif token.word is None:
            yield token
        else:
            made = _text_box(tokens, place) or _unwrapped(tokens, place) or _renamed(tokens, place)
            yield from made[0]
            place = made[1]


#: What a command gives, and the place behind it and its arguments.
_Made: TypeAlias = "tuple[Sequence[Token], int]"


def _text_box(tokens: Sequence[Token], place: int) -> _Made | None:
    """What \\text and the like give before `place`, if that is no words; None for another command."""
    token = tokens[place - 1]
    if token.word == "textbf" and _is_name(tokens, place):
        return [token.standing_for("\\mathbf")], place
    if token.word not in _TEXTS:
        return None
    if (behind := _blank(tokens, place)) is not None:
        return [], behind
    if (formula := _formula_in(tokens, place)) is not None:
        is_bold, inner, behind = formula
        bold = [token.standing_for("\\boldsymbol")] if is_bold else []
        opening, closing = token.standing_for("{"), token.standing_for("}")
        return [*bold, opening, *_respelled(inner), closing], behind
    if _is_name(tokens, place):
        return [token.standing_for("\\mathrm")], place
    return ([token.standing_for("\\operatorname")], place) if _is_function(tokens, place) else None


def _unwrapped(tokens: Sequence[Token], place: int) -> _Made | None:
    """What a command before `place` shows of its arguments, or leaves of them; None for another command."""
    token = tokens[place - 1]
    word = token.word or ""
    if word in _OVER and (noted := _noted_sign(tokens, place)) is not None:
        at, behind = noted
        return [tokens[at]], behind
    if word in _DROPPED_WITH_ARGUMENT:
        return [], argument(tokens, _past(tokens, place, "*"))[1]
    if word in _WIDE_WITH_ARGUMENT:
        return [token.standing_for("\\quad")], argument(tokens, place)[1]
    if word in _OPERATORS and (differential := _differential(tokens, place)) is not None:
        return [token.standing_for("d")], differential
    if word in _DELIMITED:
        return _delimited(tokens, place)
    if word == "qty" and (bracketed := _in_brackets(tokens, place)) is not None:
        return bracketed
    if word not in _UNWRAPPED:
        return None
    for _ in range(WRAPPERS.get(word, 0)):
        _, place = argument(tokens, _past_option(tokens, place))
    if word in WRAPPERS:
        place = _past_option(tokens, place)
    inner, place = argument(tokens, place)
    if word in OF_WORDS and not any(each.text in MATH_SHIFTS for each in inner):
        return [token.standing_for("\\text"), *braced(token, inner)], place
    inner = [each for each in inner if each.text not in MATH_SHIFTS]
    return list(_respelled(inner)), _past_script(tokens, place) if word in _LIMITS_ARE_NOTES else place


def _delimited(tokens: Sequence[Token], place: int) -> _Made | None:
    """What \\norm{x}, \\norm*{x} or \\norm[\\big]{x} gives; None without an argument."""
    token, place = tokens[place - 1], _past(tokens, _past(tokens, place, "*"), " ")
    if place < len(tokens) and tokens[place].text == "[":
        place = next((i + 1 for i in range(place, len(tokens)) if tokens[i].text == "]"), len(tokens))
    if not any(each.text == "{" or each.text.isalpha() or each.word for each in tokens[place : place + 1]):
        return None
    inner, behind = argument(tokens, place)
    sign = _DELIMITED[token.word or ""]
    first, last = ([token.standing_for(text) for text in (side, sign)] for side in ("\\left", "\\right"))
    return [*first, *_respelled(inner), *last], behind


def _in_brackets(tokens: Sequence[Token], place: int) -> _Made | None:
    """What \\qty{x} and \\qty\\big(x) of the package physics print; None for a quantity with its unit."""
    while place < len(tokens) and (tokens[place].text == " " or tokens[place].word in _BIG):
        place += 1
    if _opens(tokens, place):
        return [], place
    if [token.text for token in tokens[place : place + 1]] != ["{"]:
        return None
    inner, behind = argument(tokens, place)
    is_of_unit = [token.text for token in tokens[behind : behind + 1]] == ["{"]
    token = tokens[place]
    first, last = ([token.standing_for(text) for text in (side, sign)] for side, sign in _ROUND)
    return None if is_of_unit else ([*first, *_respelled(inner), *last], behind)


def _renamed(tokens: Sequence[Token], place: int) -> _Made:
    """Returns the spelling used here for any other command before `place`; empty if it prints nothing."""
    token = tokens[place - 1]
    word = token.word or ""
    if word in _STARRED:
        place = _past(tokens, place, "*")
    if word in _DROPPED:
        return [], place
    if word in _WIDE:
        return [token.standing_for("\\quad")], place
    if word in _BLACKBOARD:
        return [token.standing_for(text) for text in ("\\mathbb", "{", word, "}")], place
    if word in _FUNCTIONS:
        return [token.standing_for(text) for text in ("\\operatorname", "{", *word, "}")], place
    return [token.standing_for(_RENAMED.get(word, token.text))], place


def _opens(tokens: Sequence[Token], place: int) -> bool:
    """True if there is a bracket that prints."""
    return any(token.text in ("(", "[", "|") for token in tokens[place : place + 1])


def _blank(tokens: Sequence[Token], place: int) -> int | None:
    """Returns the index after the words if they are an empty box, else None."""
    inside, end = argument(tokens, place)
    printing = "".join(token.text for token in inside)
    return end if re.fullmatch(r"\\makebox(?:\[[^]]*\])*\{\}", printing) else None


def _is_name(tokens: Sequence[Token], place: int) -> bool:
    """True if \\text contains one letter, or the name of a group: v in \\text{v}, SO in \\textrm{SO}(3)."""
    inside = "".join(token.text for token in argument(tokens, place)[0])
    return (len(inside) == 1 and inside.isalpha()) or inside in _GROUPS


def _is_function(tokens: Sequence[Token], place: int) -> bool:
    """True if \\text contains a word before a bracket: Adj in \\textrm{Adj}(A)."""
    inside, end = argument(tokens, place)
    word = "".join(token.text for token in inside)
    behind = [token.text for token in tokens[end:] if token.text not in (" ", "\\left")][:1]
    is_label = any(token.text in ("_", "^") for token in tokens[:place][-2:-1])
    is_word = word.isascii() and word.isalpha() and word.lower() not in WORDS
    return behind == ["("] and is_word and not is_label


def _noted_sign(tokens: Sequence[Token], place: int) -> tuple[int, int] | None:
    """Returns the index of the = of \\overset{(a)}{=}, and the index after it; None for a sign with another
    meaning."""
    note, end = argument(tokens, place)
    sign, behind = argument(tokens, end)
    words = "".join(token.text for token in note)
    is_note = not any(token.text in _NO_NOTES for token in note) and "def" not in words and "?" not in words
    if not is_note or [token.text for token in sign if token.text != " "] != ["="]:
        return None
    return tokens.index(next(token for token in sign if token.text == "="), end), behind


def _is_empty(tokens: Sequence[Token], place: int) -> bool:
    """True if there is {}, as macros write an absent script."""
    return place >= 0 and [token.text for token in tokens[place : place + 2]] == ["{", "}"]


def _formula_in(tokens: Sequence[Token], place: int) -> tuple[bool, list[Token], int] | None:
    """Returns whether the formula of \\mbox{\\boldmath $x$} is bold, the formula, and the index after it;
    None for words."""
    inner, end = argument(tokens, place)
    plain = [token for token in inner if token.text != " " and token.text not in _BOLD]
    if len(plain) > 4 and plain[0].text == "{" and _group_end(plain) == len(plain):
        plain = plain[1:-1]  # \\boldmath{$x$}
    if len(plain) < 3 or plain[0].text != "$" or plain[-1].text != "$" or len(plain) != _dollars(plain):
        return None
    return any(token.text in _BOLD for token in inner), plain[1:-1], end


def _differential(tokens: Sequence[Token], place: int) -> int | None:
    """Returns the index after the d of \\operatorname{d}; None for another operator."""
    inner, end = argument(tokens, place)
    return end if [token.text for token in inner if token.text != " "] == ["d"] else None


def _dollars(tokens: Sequence[Token]) -> int:
    """Returns the number of tokens of the first formula between dollars, including these."""
    return next((place + 1 for place, token in enumerate(tokens) if place and token.text == "$"), 0)


def argument(tokens: Sequence[Token], place: int) -> tuple[list[Token], int]:
    """Returns the argument at `place` without braces, and the index after it."""
    place = _past(tokens, place, " ")
    if place >= len(tokens):
        return [], place
    if tokens[place].text != "{":
        return [tokens[place]], place + 1
    end = closing(tokens, place)
    return (
        (list(tokens[place + 1 :]), len(tokens)) if end is None else (list(tokens[place + 1 : end - 1]), end)
    )


def _past(tokens: Sequence[Token], place: int, text: str) -> int:
    while place < len(tokens) and tokens[place].text == text:
        place += 1
    return place


def _past_option(tokens: Sequence[Token], place: int) -> int:
    """Returns the index after the star and the option of a command: \\resizebox*, \\bbox[red]."""
    place = _past(tokens, place, "*")
    if [token.text for token in tokens[place : place + 1]] != ["["]:
        return place
    return next((i + 1 for i in range(place, len(tokens)) if tokens[i].text == "]"), place)


def _past_script(tokens: Sequence[Token], place: int) -> int:
    after = _past(tokens, place, " ")
    if after < len(tokens) and tokens[after].text in "_^":
        return argument(tokens, after + 1)[1]
    return place

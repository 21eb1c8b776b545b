"""Habits of authors and their tools: tables of MathType, labels within typefaces, R(t)^T."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import dropwhile, pairwise

from workbench.core.brackets import nesting, outside
from workbench.source.documents import Token
from workbench.source.rewriting.column_separators import (
    name_of_a_formula,
    net_sum,
    power_at_the_end,
    row_of_a_matrix,
    row_of_two,
    transposed_row,
    wide_space,
)
from workbench.source.rewriting.derivative_macros import at_a_label, derivative_by_name, seen_from
from workbench.source.rewriting.token_groups import (
    FACES,
    GAPS,
    TEXTS,
    ahead,
    behind,
    braced,
    group,
    past,
    printed,
)
from workbench.source.rewriting.typeface_marks import (
    angle,
    degrees,
    dotted_bracket,
    empty_bars,
    signed,
    summed,
)

_LETTERS = r"""
    alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi
    chi psi omega
"""
_GREEK = frozenset(_LETTERS.split())
_CAPITALS = "Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega"
_VARIANTS = frozenset(_CAPITALS.split())
_LETTERED = re.compile(r"[a-z](?:,[a-z])*(?:=(?:\d+|n|,|\\[lc]?dots|\.)+)?")
_WHY = re.compile(r"\\\w+\{\s*\(\s*(?:using|by|from|since|because|see|cf|as|eqs?)\b", re.IGNORECASE)


def as_read(tokens: Sequence[Token]) -> list[Token]:
    """Returns the tokens rewritten to the claim language; every token keeps its position."""
    made = list(tokens)
    for pattern in (*_PATTERNS, derivative_by_name, seen_from, at_a_label, *_BETWEEN):
        made = everywhere(made, pattern)
    return made


def everywhere(
    tokens: list[Token], pattern: Callable[[list[Token], int], tuple[list[Token], int] | None]
) -> list[Token]:
    """Returns the tokens rewritten from left to right; the same list if the pattern is found nowhere."""
    made: list[Token] = []
    start = place = 0
    while place < len(tokens):
        found = pattern(tokens, place)
        if found is None:
            place += 1
            continue
        made += [*tokens[start:place], *found[0]]
        start = place = found[1]
    return [*made, *tokens[start:]] if start else tokens


def _variant(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\varOmega to \\mathit{\\Omega}."""
    token = tokens[place]
    if not token.text.startswith("\\var") or token.text[4:] not in _VARIANTS:
        return None
    return [token.standing_for(text) for text in ("\\mathit", "{", f"\\{token.text[4:]}", "}")], place + 1


def _starred(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\begin{matrix*}[l] to \\begin{matrix}."""
    text = tokens[place].text
    if not text.endswith("matrix*}"):
        return None
    end = past(tokens, place + 1)
    is_aligned = text.startswith("\\begin") and printed(tokens[end : end + 3])[::2] == ["[", "]"]
    return [tokens[place].standing_for(text.replace("*", ""))], end + 3 if is_aligned else place + 1


def _table(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Removes the columns {*{20}{c}} of an array; the reader counts them itself."""
    if tokens[place].text != "\\begin{array}":
        return None
    start = past(tokens, place + 1)
    if start >= len(tokens) or tokens[start].text != "{":
        return None
    end = behind(tokens, start)
    if not any(token.text in "*@!>" for token in tokens[start:end]):
        return None
    return [tokens[place], tokens[start], tokens[start].standing_for("c"), tokens[end - 1]], end


def _grouped_table(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Removes the braces of {\\begin{array}…\\end{array}}, which print nothing."""
    first = past(tokens, place + 1)
    if tokens[place].text != "{" or first >= len(tokens) or not tokens[first].text.startswith("\\begin{"):
        return None
    end = behind(tokens, place)
    last = ahead(tokens, end - 1)
    if last is None or tokens[last].text != tokens[first].text.replace("\\begin", "\\end"):
        return None
    before = ahead(tokens, place)
    opens = before is not None and (
        tokens[before].text in ("[", "(", "|", "\\|") or tokens[before].text == "="
    )
    return (tokens[place + 1 : end - 1], end) if opens else None


def _label(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites _\\mathcal{B/N} to _{\\mathcal{B}/\\mathcal{N}}."""
    if tokens[place].text not in FACES or place + 1 >= len(tokens) or tokens[place + 1].text != "{":
        return None
    end = behind(tokens, place + 1)
    dropped = ("{", "}", " ", tokens[place].text, "\\cal")
    inside = [token for token in tokens[place + 2 : end - 1] if token.text not in dropped]
    if [token.text for token in inside[1::2]] != ["/"] or len(inside) != 3:
        return None
    face = tokens[place]
    one, slash, other = inside
    made = [face.standing_for("{")]
    for token in (one, slash, other):
        is_slash = token is slash
        made += [token] if is_slash else [face, face.standing_for("{"), token, face.standing_for("}")]
    return [*made, face.standing_for("}")], end


def _holds_one(tokens: list[Token], place: int) -> bool:
    return [token.text for token in tokens[place : place + 3 : 2]] == ["{", "}"]


def _nested_text(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\text{\\text{sc}} and \\textit{sc} to \\text{sc}, and \\textit{i} to i."""
    if tokens[place].text in ("\\textit", "\\textsf", "\\textup", "\\textnormal", "\\textsl", "\\texttt"):
        letter = tokens[place + 2 : place + 3] if _holds_one(tokens, place + 1) else []
        is_italic = letter and tokens[place].text == "\\textit" and letter[0].text.isalpha()
        return (letter, place + 4) if is_italic else ([tokens[place].standing_for("\\text")], place + 1)
    if tokens[place].text not in TEXTS or place + 2 >= len(tokens) or tokens[place + 1].text != "{":
        return None
    inner = tokens[place + 2].text in TEXTS and behind(tokens, place + 3) == behind(tokens, place + 1) - 1
    return (tokens[place + 2 : behind(tokens, place + 1) - 1], behind(tokens, place + 1)) if inner else None


def _formulas_in_text(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\text{for $x$ alone} to \\text{for }x\\text{ alone}, and a heading \\text{axis $x$:} to
    \\text{axis :}."""
    if tokens[place].text not in TEXTS or place + 1 >= len(tokens) or tokens[place + 1].text != "{":
        return None
    end = behind(tokens, place + 1)
    signs = [at for at in range(place + 2, end - 1) if tokens[at].text == "$"]
    parts = [tokens[start + 1 : stop] for start, stop in pairwise([place + 1, *signs, end - 1])]
    words = [token for part in parts[::2] for token in part]
    if len(signs) % 2 or not signs or not any(token.text.isalpha() for token in words):
        return None
    if printed(words)[-1] == ":":
        return [tokens[place], *braced(tokens[place], words)], end
    made: list[Token] = []
    for at, inside in enumerate(parts):
        is_formula = at % 2 == 1
        made += inside if is_formula or not inside else [tokens[place], *braced(tokens[place], inside)]
    return made, end


def _note(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Removes \\text{(using } a = b\\text{)}, the reason for a step."""
    if tokens[place].text not in TEXTS or not _WHY.match("".join(t.text for t in tokens[place : place + 20])):
        return None
    depth, end = 0, place
    for at, token in enumerate(tokens[place:], place):
        end = behind(tokens, at + 1) if token.text in TEXTS else end
        depth += nesting(token.text, "(", ")")
        if depth == 0 and token.text == ")":
            return ([], end) if at < end else None
    return None


def _prime(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites ^{\\prime\\prime} to '', and ^{'T} to '^{T}."""
    if tokens[place].text != "^":
        return None
    start = past(tokens, place + 1)
    end = behind(tokens, start)
    inside = [token for token in tokens[start:end] if token.text not in ("{", "}", " ")]
    rest = list(dropwhile(lambda token: token.text in ("\\prime", "'"), inside))
    primes = inside[: len(inside) - len(rest)]
    if not primes or (rest and [token.text for token in rest] not in (["T"], ["\\top"])):
        return None
    made = [token.standing_for("'") for token in primes]
    return [*made, *([tokens[place], *braced(rest[0], rest)] if rest else [])], end


def _prime_of_a_list(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites (a, b, c)' to (a, b, c)^T: a list has no rate. f(a, b)' is the value of a function."""
    if tokens[place].text != "'" or place == 0 or tokens[place - 1].text not in _CLOSING:
        return None
    depth, at, is_list = 1, place - 2, False
    while at >= 0 and depth:
        depth += (tokens[at].text in _CLOSING) - (tokens[at].text in _OPENING)
        is_list = is_list or (depth == 1 and tokens[at].text == ",")
        at -= 1
    before = at if at >= 0 and tokens[at].text not in GAPS else ahead(tokens, at + 1)
    is_function = before is not None and (_is_letter(tokens[before]) or tokens[before].text in ("}", "'"))
    if not is_list or is_function:
        return None
    return [tokens[place].standing_for(text) for text in ("^", "T")], place + 1


_OPENING, _CLOSING = frozenset("(["), frozenset(")]")


def _of_time(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites R(t)^T to R^T: the argument t only states a dependence."""
    if tokens[place].text not in ("(", "\\left", "{"):
        return None
    texts = [token.text for token in tokens[place : place + 14] if token.text not in GAPS]
    opening = next((each for each in _TIMES if texts[: len(each)] == list(each)), None)
    before = ahead(tokens, place)
    is_after = before is not None and (tokens[before].text == "}" or _is_letter(tokens[before]))
    if opening is None or not is_after:
        return None
    count, end = len(opening), place
    while count:
        count -= tokens[end].text not in GAPS
        end += 1
    after = past(tokens, end)
    if after >= len(tokens) or tokens[after].text not in ("^", "'"):
        return None
    if tokens[place].text != "{":
        return [], after
    close = behind(tokens, place)
    return tokens[after : close - 1], close


_TIMES = (("(", "t", ")"), ("\\left", "(", "t", "\\right", ")"), ("{", "(", "t", ")"))


def _is_letter(token: Token) -> bool:
    word = token.word
    is_greek = word is not None and word.removeprefix("var").lower() in _GREEK
    return (len(token.text) == 1 and token.text.isalpha()) or is_greek


def _inverse_function(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\tan^{-1} to \\arctan."""
    head = tokens[place]
    mark = past(tokens, place + 1)
    if head.text not in ("\\sin", "\\cos", "\\tan") or [t.text for t in tokens[mark : mark + 1]] != ["^"]:
        return None
    power, end = group(tokens, past(tokens, mark + 1))
    return ([head.standing_for(f"\\arc{head.text[1:]}")], end) if printed(power) == ["-", "1"] else None


def _for_all(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\forall before i = 1, 2, 3 at the end of a row to a wide space, and removes \\forall i
    alone."""
    if tokens[place].text != "\\forall":
        return None
    rest = printed(tokens[place + 1 :])
    end = next((at for at, text in enumerate(rest) if text in ("\\\\", "&")), len(rest))
    said = "".join(text for text in rest[:end] if text not in ("\\quad", "\\qquad")).rstrip(".,;")
    if not _LETTERED.fullmatch(said):
        return None
    last = next((at for at in range(place, len(tokens)) if tokens[at].text in ("\\\\", "&")), len(tokens))
    return ([tokens[place].standing_for("\\quad")], place + 1) if "=" in said else ([], last)


def _over(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites {a \\over b} to \\frac{a}{b}."""
    if tokens[place].text != "{":
        return None
    end = behind(tokens, place)
    inside = tokens[place + 1 : end - 1]
    free = outside(token.text for token in inside)
    middle = next((at for at in free if inside[at].text == "\\over"), None)
    if middle is None:
        return None
    head, above, below = inside[middle], as_read(inside[:middle]), as_read(inside[middle + 1 :])
    return [head.standing_for("\\frac"), *braced(head, above), *braced(head, below)], end


def _line(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Removes \\hline and \\rule between the rows of a matrix."""
    if tokens[place].text == "\\hline":
        return [], place + 1
    if tokens[place].text != "\\rule":
        return None
    position = past(tokens, place + 1)
    if tokens[position : position + 1] and tokens[position].text == "[":
        position = next((i for i in range(position, len(tokens)) if tokens[i].text == "]"), position) + 1
    for _ in range(2):
        _, position = group(tokens, past(tokens, position))
    position = past(tokens, position)
    is_row = [token.text for token in tokens[position : position + 1]] == ["\\\\"]
    return [], position + is_row


def _script_on_the_left(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\leftidx{^A}{x}{_b} to {}^A x_b, and \\leftexp{A}{x} to {}^A x."""
    if tokens[place].text == "\\leftexp":
        label, end = group(tokens, past(tokens, place + 1))
        head = tokens[place]
        left = [*braced(head, []), head.standing_for("^"), *braced(head, label)]
        return [*left, head.standing_for(" ")], end
    if tokens[place].text != "\\leftidx":
        return None
    left, end = group(tokens, past(tokens, place + 1))
    body, end = group(tokens, past(tokens, end))
    right: list[Token] = []
    if printed(tokens[past(tokens, end) :][:1]) == ["{"]:  # without braces it is printed there anyway
        right, end = group(tokens, past(tokens, end))
    return [*braced(tokens[place], []), *left, tokens[place].standing_for(" "), *body, *right], end


_BETWEEN = (transposed_row, wide_space, row_of_a_matrix, row_of_two, net_sum, power_at_the_end)
_PATTERNS = (
    name_of_a_formula,
    _script_on_the_left,
    _over,
    _inverse_function,
    _for_all,
    signed,
    summed,
    angle,
    dotted_bracket,
    empty_bars,
    degrees,
    _line,
    _variant,
    _starred,
    _table,
    _grouped_table,
    _label,
    _nested_text,
    _note,
    _formulas_in_text,
    _prime,
    _prime_of_a_list,
    _of_time,
)

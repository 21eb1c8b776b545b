"""Separators between formulas and columns of a line, rows in brackets, and sums without bounds."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.source.documents import Token
from workbench.source.rewriting.token_groups import (
    FACES,
    GAPS,
    ahead,
    braced,
    group,
    is_one_symbol,
    past,
    printed,
)

_SPACES_OF_A_WORD = frozenset({"\\ ", "\\\n", "~", "\\;", "\\enspace"})
_WIDE = frozenset({"\\quad", "\\qquad"})
#: Spaces that separate the entries of a transposed row; elsewhere they separate factors.
_THICK = frozenset({"\\;", "~", "\\ ", "\\:", "\\,"})
_OPEN, _CLOSE = frozenset(["(", "[", "{", "\\{"]), frozenset([")", "]", "}", "\\}"])
_SIGNS = frozenset(
    ["=", ":=", "\\equiv", "+", "-", "&", ",", "\\\\", "\\times", "\\cdot", "\\otimes", "\\circ"]
)
#: Tokens that relate or separate the parts of a bracket in another way, or end it as a large one.
_NO_ROW = _SIGNS | frozenset([";", "|", "\\text", "\\mathrm", "\\in", "\\right", "\\left"])
_ARROWS = frozenset(["\\to", "\\rightarrow", "\\longrightarrow", "\\mapsto", "\\longmapsto"])
_MATRICES = frozenset(f"\\begin{{{kind}matrix}}" for kind in ("", "b", "p"))
_TURNS = frozenset(["\\sin", "\\cos", "\\tan"])
_ENDS_A_ROW = ("&", "\\\\", "=", ",")
_ENDS_A_SUM = frozenset(["=", "&", "+", "-", ",", ".", "\\\\"])


def net_sum(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites \\sum \\mathbf{F}, the sum of all F, to a symbol \\mathbf{F}_{\\Sigma}."""
    head = tokens[place]
    start = past(tokens, place + 1)
    if head.text != "\\sum" or start >= len(tokens):
        return None
    if tokens[start].text in FACES | {"\\vec", "\\bar"}:
        _, end = group(tokens, past(tokens, start + 1))
    elif tokens[start].text.isalpha():
        end = start + 1
    else:
        return None
    after = past(tokens, end)
    if printed(tokens[after : after + 1]) == ["^"]:
        after = past(tokens, group(tokens, past(tokens, after + 1))[1])
    if after < len(tokens) and tokens[after].text not in _ENDS_A_SUM:
        return None
    label = [head.standing_for("_"), *braced(head, [head.standing_for("\\Sigma")])]
    return [*tokens[start:end], *label], end


def power_at_the_end(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites x_1{}^2 without a following base to x_1^2."""
    before = ahead(tokens, place)
    script = past(tokens, place + 2)
    if before is None or printed(tokens[place : script + 1]) != ["{", "}", "^"]:
        return None
    inside, end = group(tokens, past(tokens, script + 1))
    after = past(tokens, end)
    is_last = after >= len(tokens) or tokens[after].text in _ENDS_A_SUM
    is_power = tokens[before].text not in _ENDS_A_SUM | _OPEN and "".join(printed(inside)).isdigit()
    return (tokens[script:end], end) if is_last and is_power else None


def bar_of_a_set(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites the single bar in \\{x | a = b\\} to a separator."""
    if tokens[place].text != "\\{":
        return None
    end = next((at for at in range(place, len(tokens)) if tokens[at].text == "\\}"), None)
    bars = [at for at in range(place, end or place) if tokens[at].text == "|"]
    if len(bars) != 1 or tokens[bars[0] - 1].text in ("\\left", "\\right"):
        return None
    return [*tokens[place : bars[0]], tokens[bars[0]].standing_for("\\mid")], bars[0] + 1


def wide_space(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites two or more spaces to the wide space that they print."""
    if tokens[place].text not in _SPACES_OF_A_WORD:
        return None
    end = past(tokens, place)
    count = sum(token.text in _SPACES_OF_A_WORD for token in tokens[place:end])
    return ([tokens[place].standing_for("\\quad")], end) if count > 1 else None


def name_of_a_formula(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Removes the name in L:\\ a = b, with a space; a map would have an arrow."""
    colon = past(tokens, place + 1)
    before = ahead(tokens, place)
    is_first = before is None or tokens[before].text == "\\\\"
    if not (is_first and printed(tokens[colon : colon + 1]) == [":"] and is_one_symbol(tokens[place:colon])):
        return None
    texts = [token.text for token in tokens[colon + 1 :] if token.text != " "]
    row = texts[: texts.index("\\\\")] if "\\\\" in texts else texts
    is_spaced = bool((_SPACES_OF_A_WORD | _WIDE) & {*row[:1]})
    return ([], colon + 1) if is_spaced and _ARROWS.isdisjoint(row) else None


def row_of_a_matrix(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites [a \\quad -b] without other separators to a row of a matrix. A sign directly before a symbol
    belongs to the entry."""
    is_large = tokens[place].text == "\\left"
    start, closing = (place + 1, "\\right") if is_large else (place, "]")
    if printed(tokens[start : start + 1]) != ["["] or (start == place and _is_large(tokens, place)):
        return None
    parts: list[list[Token]] = [[]]
    depth, end = 0, start + 1
    while end < len(tokens) and (depth or tokens[end].text != closing):
        text = tokens[end].text
        is_first = not printed(parts[-1][len(parts) > 1 :])
        if not depth and text in _NO_ROW and not (is_first and _touches(tokens, end)):
            return None
        if not depth and text in _WIDE:
            parts.append([tokens[end].standing_for("&")])
        else:
            parts[-1].append(tokens[end])
        depth += (text in _OPEN) - (text in _CLOSE)
        end += 1
    if end == len(tokens) or len(parts) < 2 or any(past(part, 1) >= len(part) for part in parts[1:]):
        return None
    end += is_large
    if printed(tokens[end : end + 1]) != ["]"]:
        return None
    first, last = tokens[place], tokens[end]
    above = past(tokens, end + 1)
    is_transposed = [token.text for token in tokens[above : above + 1]] == ["^"]
    inside = [token for part in parts for token in part]
    if is_transposed:  # [a, b]^T, which a reader may understand as a column
        apart = (token.standing_for(",") if token.text == "&" else token for token in inside)
        return [*tokens[place : start + 1], *apart, *tokens[end - is_large : end + 1]], end + 1
    return [first.standing_for("\\begin{bmatrix}"), *inside, last.standing_for("\\end{bmatrix}")], end + 1


def _touches(tokens: Sequence[Token], place: int) -> bool:
    """True if there is a sign without a space after it."""
    is_sign = tokens[place].text in ("+", "-")
    return is_sign and [token.text in GAPS for token in tokens[place + 1 : place + 2]] == [False]


def row_of_two(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites [a \\; -b], and the one cell of \\begin{pmatrix} a \\; -b \\end{pmatrix}, to a row of a
    matrix."""
    first, is_cell = tokens[place], tokens[place].text in _MATRICES
    is_large = [token.text for token in tokens[place : place + 2]] == ["\\left", "["]
    if not (is_cell or is_large or (first.text == "[" and not _is_large(tokens, place))):
        return None
    closing = first.text.replace("\\begin", "\\end") if is_cell else "\\right" if is_large else "]"
    start = place + 1 + is_large
    end = next((at for at in range(start, len(tokens)) if tokens[at].text in (closing, *_ENDS_A_ROW)), None)
    if end is None or tokens[end].text != closing:
        return None
    parts = _entries(tokens[start:end])
    end += is_large
    above = past(tokens, end + 1)
    is_raised = [token.text for token in tokens[above : above + 1]] == ["^"]
    if parts is None or (is_raised and not is_cell) or (len(parts) != 2 and not is_cell):
        return None
    if [token.text for token in tokens[end : end + 1]] != (["]"] if not is_cell else [closing]):
        return None
    apart = [[first.standing_for("&")] * (at > 0) + part for at, part in enumerate(parts)]
    inside = [token for part in apart for token in part]
    if is_cell:
        return [first, *inside, tokens[end]], end + 1
    brackets = first.standing_for("\\begin{bmatrix}"), tokens[end].standing_for("\\end{bmatrix}")
    return [brackets[0], *inside, brackets[1]], end + 1


def _entries(tokens: Sequence[Token]) -> list[list[Token]] | None:
    """Returns the symbols, numbers and sines between spaces, with their signs; None for other entries."""
    parts: list[list[Token]] = [[]]
    for at, token in enumerate(tokens):
        is_gap = token.text in _WIDE | (_THICK - {"\\,", "\\:"})
        if is_gap and printed(parts[-1]):
            parts.append([])
        elif not is_gap:
            parts[-1].append(token)
            if token.text in ("+", "-") and (printed(parts[-1]) != [token.text] or not _touches(tokens, at)):
                return None
    parts = [part for part in parts if printed(part)]
    return parts if len(parts) > 1 and all(_is_entry(_bare(part)) for part in parts) else None


def _bare(entry: list[Token]) -> list[Token]:
    """Returns the entry without spaces around it and without its sign."""
    kept = entry[past(entry, 0) :]
    kept = kept[1:] if kept and kept[0].text in ("+", "-") else kept
    while kept and kept[-1].text in GAPS:
        kept = kept[:-1]
    return kept


def _is_entry(bare: list[Token]) -> bool:
    is_turn = bool(bare) and bare[0].text in _TURNS and is_one_symbol(bare[past(bare, 1) :])
    return is_turn or is_one_symbol(bare) or "".join(printed(bare)).isdigit()


def _is_large(tokens: list[Token], place: int) -> bool:
    return place > 0 and tokens[place - 1].text == "\\left"


def transposed_row(tokens: list[Token], place: int) -> tuple[list[Token], int] | None:
    """Rewrites [x \\; y \\; z]^T or (x \\quad y \\quad z)^T to [x, y, z]^T.

    The entries are symbols; if there are three or more, or one is a number or the sine of a symbol, they may
    have signs. [x \\; y \\; z] is not a product.
    """
    closing = {"[": "]", "(": ")"}.get(tokens[place].text)
    if closing is None:
        return None
    spaces, least = (_THICK, 2) if closing == "]" else (_WIDE, 3)
    end = next((i for i in range(place, len(tokens)) if tokens[i].text in (closing, "&", "\\\\", "=")), None)
    if end is None or tokens[end].text != closing:
        return None
    above = past(tokens, end + 1)
    is_raised = [token.text for token in tokens[above : above + 1]] == ["^"]
    power = "".join(printed(group(tokens, past(tokens, above + 1))[0])) if is_raised else ""
    if power not in ("T", "\\top", "\\mathrm{T}", "\\intercal"):
        if is_raised or closing == ")":
            return None
        spaces, least = _THICK - {"\\,"}, 3
    inside = tokens[place + 1 : end - (tokens[end - 1].text == "\\right")]
    parts: list[list[Token]] = [[]]
    gaps: list[Token] = []
    for token in inside:
        if token.text in spaces and printed(parts[-1]):
            gaps.append(token)
            parts.append([])
        elif token.text not in spaces:
            parts[-1].append(token)
    if not printed(parts[-1]):
        parts.pop()
    bare = _unsigned(parts) if len(parts) > 2 else parts
    if len(parts) < least or not (all(map(is_one_symbol, bare)) or _are_scalars(parts)):
        return None
    made = [tokens[place], *parts[0]]
    for gap, part in zip(gaps, parts[1:], strict=False):
        made += [gap.standing_for(","), *part]
    return [*made, *tokens[place + 1 + len(inside) : end]], end


def _are_scalars(parts: list[list[Token]]) -> bool:
    """True if each part is a symbol, a number or the sine or the like of a symbol, with a sign, but not all
    are symbols."""
    bare = _unsigned(parts)
    numbers = ["".join(printed(part)).isdigit() for part in bare]
    turns = [{part.text for part in each[:1]} <= _TURNS and is_one_symbol(each[1:]) for each in bare]
    known = [number or turn for number, turn in zip(numbers, turns, strict=True)]
    return any(known) and all(k or is_one_symbol(part) for k, part in zip(known, bare, strict=True))


def _unsigned(parts: list[list[Token]]) -> list[list[Token]]:
    trimmed = [part[past(part, 0) :] for part in parts]
    return [part[past(part, 1) :] if part[0].text in ("-", "+") else part for part in trimmed]


#: The patterns of rows in brackets.
ROWS = (transposed_row, row_of_a_matrix, row_of_two)

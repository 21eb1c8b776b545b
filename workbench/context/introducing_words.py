"""Words of a sentence that tell whether a formula in it is a condition or a definition, and its reach."""

from __future__ import annotations

import re

from workbench.source.documents import Display
from workbench.source.documents.condition_words import (
    CASES,
    CONTRASTS,
    DEFINES,
    DENY_WHAT_FOLLOWS,
    DENY_WHAT_PRECEDES,
    ENDS_CASE,
    ENDS_CASE_OF_ANOTHER,
    EXCEPTIONS,
    EXPLAINS,
    IN_SECTION,
    REASONS,
    SUPPOSES,
)
from workbench.source.documents.list_items import item_around
from workbench.source.documents.surrounding_words import holds_display, paragraph_around, sentence_around

#: The last of these words before a formula tells a definition from a condition.
_SAYS = re.compile(
    rf"\b(?:(?P<excepts>{EXCEPTIONS})|(?P<defines>{DEFINES})|(?P<explains>{EXPLAINS}|here)|(?P<case>{CASES})"
    rf"|(?P<supposes>{SUPPOSES})|(?P<gives_reason>{REASONS}))\b",
    re.IGNORECASE,
)
_DENY_NEXT = re.compile(DENY_WHAT_FOLLOWS, re.IGNORECASE)
_DENY_LAST = re.compile(DENY_WHAT_PRECEDES, re.IGNORECASE)
_ENDS_CASE = re.compile(rf"\b(?:{ENDS_CASE})\b", re.IGNORECASE)
_ENDS_OTHER = re.compile(rf"\b(?:{ENDS_CASE_OF_ANOTHER})\b", re.IGNORECASE)
_IN_SECTION = re.compile(rf"\b(?:{IN_SECTION})\b", re.IGNORECASE)
#: A clause behind a display, for another case.
_CONTRASTS = re.compile(rf"(?:\$\$|\\\]|\\end\s*\{{[^}}]*\}}|```)\s*(?:{CONTRASTS})\b[^.]*$", re.IGNORECASE)
#: The end of a display that ends its sentence.
_FULL_STOP = re.compile(r"[.!?]\s*(?:\\end\s*\{[^}]*\}|\\\]|\$\$|\n[ \t]*\n)")
#: The marks around a formula in a sentence.
_OPENING = re.compile(r"(?:\$|\\\(|:math:`|`)\s*$")
_CLOSING = re.compile(r"\s*(?:\$|\\\)|`)")
#: What ends the words that introduce a supposition: "for a rigid body, the momentum is".
_BREAKS = re.compile(
    r",|\b(?:is|are|be|reads|becomes|equals|have|has|get|obtain|find|defin\w+|denot\w+|writ\w+|call)\b"
)

#: The words for what follows from the formula before them: "with the law f, which gives g".
_FOLLOWS = re.compile(
    r"\b(?:gives?|yields?|implies|means|leads? to|results? in|follows|(?:we|one) (?:get|obtain|find)s?)\b"
)


def _words_before(formula: Display) -> re.Match[str] | None:
    """Returns the word of the sentence that introduces the formula, as "let" or "if"."""
    text = formula.source.prose
    first, _ = sentence_around(text, formula.start, formula.end)
    return next(reversed(list(_SAYS.finditer(text[first : formula.start]))), None)


def is_exception(formula: Display) -> bool:
    """True if the sentence excludes what the formula says, as in "unless f = 0"."""
    words = _words_before(formula)
    return words is not None and words["excepts"] is not None


def is_let(formula: Display) -> bool:
    """True if the sentence introduces the formula, as in "let f = g^2" or "where f = g^2"."""
    words = _words_before(formula)
    if words is None or (words["defines"] or words["explains"]) is None:
        return False
    return words["defines"] is not None or _FOLLOWS.search(_words_between(words, formula)) is None


def is_presented(formula: Display) -> bool:
    """True if the sentence may present a new symbol: "for V = x^T P x", "suppose that V = x^T P x"."""
    words = _words_before(formula)
    is_case = words is not None and words[0].lower() in ("for", "given")
    return words is not None and (is_case or words["supposes"] is not None)


def place_of_case(formula: Display) -> range | None:
    """Returns the offsets of the paragraph of a formula that is a case, as in "if f = 0"; None if it is none.

    A supposition is a case if the display of its claim stands in its paragraph, and a formula that explains a
    display, as in "where f = 0" or "since f = 0", if the display does. In an item of a list with its display,
    all are cases.
    """
    words, text = _words_before(formula), formula.source.prose
    start, end = paragraph_around(text, formula.start)
    is_before, is_behind = (
        holds_display(text, *span) for span in ((start, formula.start), (formula.end, end))
    )
    if words is not None and (words["explains"] or words["gives_reason"]):
        is_case = is_before or (is_behind and words[0].lower() != "here")
    else:
        is_case = words is not None and (words["case"] or words["excepts"]) is not None
    item = None if is_case else item_around(text, formula.start)
    if item is not None and holds_display(text, formula.end, item[1]):
        return range(*item)
    is_supposed = words is not None and words["supposes"] is not None
    return range(start, end) if is_case or (is_supposed and is_behind) else None


def is_denied(formula: Display) -> bool:
    """True if the sentence does not suppose the formula, as in "it is not assumed that f = 0"."""
    text = formula.source.prose
    first, last = sentence_around(text, formula.start, formula.end)
    before = _OPENING.sub("", text[first : formula.start])
    behind = _CLOSING.sub("", text[formula.end : last], count=1)
    return bool(_DENY_NEXT.search(before) or _DENY_LAST.match(behind))


def is_supposed(formula: Display) -> bool:
    """True if the words before the formula make it a condition: "for f = g", "suppose that f = g".

    So do those of the clause that a formula in brackets explains: "if the ring is held (f = g)".
    """
    words = _words_before(formula)
    if words is None or not (words["case"] or words["excepts"] or words["supposes"]):
        return False
    between = _words_between(words, formula)
    return _is_in_brackets(between) or _BREAKS.search(between) is None


def is_case_of_sentence(formula: Display) -> bool:
    """True if a formula makes its sentence one about a case: also "with the ring held (f = g)"."""
    words = _words_before(formula)
    if words is None or words["explains"] is None:
        return is_supposed(formula)
    return _is_in_brackets(_words_between(words, formula))


def _is_in_brackets(between: str) -> bool:
    """True if the words before a formula end with a bracket that explains their clause."""
    return _OPENING.sub("", between).rstrip().endswith("(") and "," not in between


def _words_between(words: re.Match[str], formula: Display) -> str:
    """Returns the words between those that introduce a formula and the formula, without other formulas."""
    first, _ = sentence_around(formula.source.prose, formula.start, formula.end)
    return re.sub(r"\$[^$]*\$", "", formula.source.prose[first + words.end() : formula.start])


def is_over(formula: Display, start: int) -> bool:
    """True if words between a condition and the display at `start` end its case, as "otherwise"."""
    text = formula.source.prose
    if _ENDS_CASE.search(text, formula.end, start):
        return True
    ends = list(_ENDS_OTHER.finditer(text, formula.end, start))
    return bool(ends) and holds_display(text, formula.end, ends[-1].start())


def is_of_next(formula: Display, start: int) -> bool:
    """True if a contrast, as "whereas if f = 0", stands between the display at `start` and the formula, and
    another display behind it."""
    text = formula.source.prose
    is_next = holds_display(text, formula.end, paragraph_around(text, formula.start)[1])
    return is_next and _CONTRASTS.search(text[start : formula.start]) is not None


def reaches(formula: Display, start: int) -> bool:
    """True if a value that a sentence supposes may count for the display at `start`.

    That of an item of a list with its display counts in the item only, and a case for no earlier sentence.
    """
    if is_over(formula, start):
        return False
    case, text = place_of_case(formula), formula.source.prose
    if is_of_next(formula, start):
        return False
    if case is None or start in case:
        return True
    item = item_around(text, formula.start)
    is_of_item = item is not None and holds_display(text, formula.end, item[1])
    return not is_of_item and _FULL_STOP.search(text, start, formula.start) is None


def counts_in_section_only(formula: Display) -> bool:
    """True if the sentence of the formula limits what it says to its section: "in this section, y = 2 x"."""
    text = formula.source.prose
    return _IN_SECTION.search(text[slice(*sentence_around(text, formula.start, formula.end))]) is not None

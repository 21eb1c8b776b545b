r"""Short names of sines and cosines in texts: c_\theta, s_1, c_{12} for \cos(\theta_1 + \theta_2)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from workbench.papers.drafting.drafted_definitions import Proposed
from workbench.papers.drafting.typefaces import Guess, flat

_FACE = r"(?:\\(?:mathrm|mathsf|text|operatorname)\{)?"
_NAME = re.compile(rf"(?P<letter>{_FACE}[A-Za-z]\}}?)_\{{(?P<sub>.+)\}}")
#: s_x = \sin x and c_i = \cos\theta_i, for any x and i; without blanks and braces.
_RULE = re.compile(
    r"(?P<letter>(?:\\mathrm|\\mathsf)?[A-Za-z])_(?P<sub>\\?[A-Za-z]+)(?::=|=)"
    r"\\(?P<head>sin|cos)\(?(?:(?P<stem>\\?[A-Za-z]+)_)?(?P=sub)\)?"
)
#: A letter of the sine or cosine right before an angle, without blanks and braces.
_BEFORE_ANGLE = re.compile(
    r"(?P<font>\\math(?:rm|sf)|(?<![A-Za-z\\]))(?P<letter>[cs])"
    r"(?=\\(?:theta|phi|psi|alpha|beta|gamma|var(?:theta|phi))(?![A-Za-z]))"
)
#: The letters alone, but for c\,\cdot = \cos\cdot.
_ALONE = re.compile(r"(?:\\math(?:rm|sf)|(?<![A-Za-z\\_{]))[cs](?![A-Za-z]|(?:\\,)?\\cdot=)")
#: Letters of an index.
_INDICES = frozenset("ijk")
#: What letters abbreviate before an angle, and with one as a subscript.
_FUNCTIONS = {"c": "cos", "s": "sin"}
USUAL = {**_FUNCTIONS, **{letter.upper(): head for letter, head in _FUNCTIONS.items()}}
#: Letters of joint angles, the usual ones first.
_ANGLES = ("\\theta", "q", "\\vartheta", "\\varphi", "\\phi", "\\alpha", "\\beta")


@dataclass(frozen=True)
class _Rule:
    """What a letter with an angle as its subscript abbreviates.

    Attributes:
        stem: The letter of the angles whose numbers are the subscripts; "" if it is not said.
    """

    head: str
    stem: str
    in_sentence: bool = False

    @property
    def why(self) -> str:
        return "a sentence says so" if self.in_sentence else "the usual abbreviation"


def abbreviations(
    guesses: Mapping[str, Guess], lines: Mapping[str, int], sentences: Iterable[str]
) -> Iterator[Proposed]:
    """Yields the definitions of abbreviated sines and cosines among the symbols with these first lines.

    They are said by a sentence, or the text has the cosine and the sine of one angle by the usual letters.
    """
    scalars = {flat(name): name for name, guess in guesses.items() if guess.kind == "scalar"}
    parts = {
        name: (flat(match["letter"]), match["sub"])
        for name in scalars.values()
        if (match := _NAME.fullmatch(name))
    }
    families = {letter: name for name, (letter, sub) in parts.items() if sub in _INDICES and name in lines}
    found = {name: each for name, each in parts.items() if name in lines or each[0] in families}
    rules = {**_usual({*found.values()}), **dict(_said(sentences))}
    for name, (letter, sub) in found.items():
        rule, is_member = rules.get(letter), len(sub) == 1 and name != families.get(letter, name)
        if rule is None or is_member or (angle := _angle(sub, rule.stem, scalars)) is None:
            continue
        line = lines.get(name) or lines[families[letter]]
        yield Proposed(name, rf"\{rule.head}({angle})", line, rule.why, True, in_sentence=rule.in_sentence)


def letters_before_angles(latex: str) -> set[str]:
    r"""Returns c and s of c\theta\,s\psi."""
    return {match["letter"] for match in _BEFORE_ANGLE.finditer(flat(latex))}


def letters_of_functions(formulas: Sequence[str]) -> dict[str, str]:
    """Returns c and s by their spelling if one formula has both right before angles, and none has them
    elsewhere."""
    texts = [flat(latex) for latex in formulas]
    if not any(letters_before_angles(latex) >= {*_FUNCTIONS} for latex in texts):
        return {}
    if any(_ALONE.search(_BEFORE_ANGLE.sub("", latex)) for latex in texts):
        return {}
    found = (match for latex in texts for match in _BEFORE_ANGLE.finditer(latex))
    spelled = ((match["font"], match["letter"]) for match in found)
    return {f"{font}{{{letter}}}" if font else letter: letter for font, letter in spelled}


def _said(sentences: Iterable[str]) -> Iterator[tuple[str, _Rule]]:
    for latex in sentences:
        if match := _RULE.fullmatch(flat(latex)):
            yield match["letter"], _Rule(match["head"], match["stem"] or "", in_sentence=True)


def _usual(found: set[tuple[str, str]]) -> dict[str, _Rule]:
    """Returns the rules for pairs of letters c and s with a common angle."""
    rules = {}
    for one, other in (("c", "s"), ("C", "S")):
        letters = {letter[-1]: letter for letter, _ in found}
        pair = (letters.get(one), letters.get(other))
        subs = [{sub for letter, sub in found if letter == each} for each in pair]
        if subs[0] & subs[1]:
            for letter in filter(None, pair):
                rules[letter] = _Rule(USUAL[letter[-1]], "")
    return rules


def _angle(sub: str, stem: str, scalars: Mapping[str, str]) -> str | None:
    """Returns the angle of a subscript: a symbol, or the sum of the angles with these numbers."""
    if (own := scalars.get(flat(sub))) is not None:
        return own
    if not (sub.isdecimal() or sub in _INDICES):
        return None
    for letter in (stem,) if stem else _ANGLES:
        whole = scalars.get(f"{letter}_{sub}")
        parts = [whole] if whole else [scalars.get(f"{letter}_{digit}") for digit in sub]
        if None not in parts:
            return " + ".join(filter(None, parts))
    return None

"""Kinds of symbols from the words of a text."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from workbench.papers.drafting.typefaces import Guess, GuessOrigin, flat
from workbench.source.documents import Display

_WORDS = (
    (
        re.compile(
            r"rotation(?:al)? matri|orthogonal (?:matri|tensor)|rotation tensor|direction cosine|\bdcm\b"
        ),
        "rotation",
    ),
    (re.compile(r"quaternion"), "quaternion"),
    (re.compile(r"homogeneous|transformation matri|rigid[- ](?:body )?transform"), "transform"),
    (re.compile(r"unit(?:[- ]length|-norm)? (?:vector|axis|direction)|normali[sz]ed vector"), "unit vector"),
    (re.compile(r"\bvectors?\b|velocit|position\b|displacement|angular momentum|torque"), "vector"),
    (re.compile(r"\btensors?\b|\bmatri(?:x|ces)\b"), "tensor"),
    (
        re.compile(
            r"\bscalars?\b|\bangles?\b|\bmass\b|\bcoordinates?\b|\blength\b|\bdistance\b|\btimes?\b|\binstant\b"
            r"|\bmoments of inertia|\bprincipal inertia"
        ),
        "scalar",
    ),
    (re.compile(r"\binertias?\b"), "inertia"),
)
#: The kinds of the members of a set, by its name without fonts and blanks.
_SETS = {
    r"SO(?:\(3\)|_?3)": "rotation",
    r"SE(?:\(3\)|_?3)": "transform",
    r"\\?R+\^3\\times3": "tensor",
    r"\\?R+\^3(?![\d\\n])": "vector",
    r"\\?R+\^(\d+)\\times(\d+)": r"matrix \1×\2",
    r"\\?R+\^(\d+)(?![\d\\n])": r"matrix \1×1",
    r"\\?R+(?![\^A-Za-z(_])": "scalar",
}
_FONTS = re.compile(r"\\(?:math(?:bb|bf|cal|rm|sf|frak|ds)|boldsymbol|operatorname|text)")
_NEAR = 40
#: How many characters farther words may be after a symbol than before it, for the same weight.
_BEHIND = 4
#: The length of a noun phrase, in which the first match of the table wins: a unit vector is a vector.
_PHRASE = 16
#: The beginning of words after a symbol that describe other symbols.
_OF_OTHERS = re.compile(r"[.;,$]|\b(?:and|with|where|about|by|from|to)\b")
#: The words between two symbols of a list, "the forces a, b and c", which the words before it describe.
_LISTED = re.compile(r"\s*(?:,|and|or|,\s*and|,\s*or)\s*")
#: A q in any font; its parts have names of their own.
_QUATERNION = re.compile(
    r"(?:\\(?:mathbf|boldsymbol|mathsf|bar|vec|hat|underline)\{)?q\}?(?:_\{(?P<part>[^{}]*)\})?(?:\^\{(?![+\\])[^{}]*\})?"
)
_PARTS = {"v": "vector", **dict.fromkeys("swxyz", "scalar")}


def _nearest(before: str, after: str) -> tuple[int, int, str] | None:
    """Returns the nearest words that give a symbol's kind: (distance, index in the table, words)."""
    found = []
    for index, (pattern, _) in enumerate(_WORDS):
        near = [(len(before) - match.end(), match[0]) for match in pattern.finditer(before)]
        near += [(match.start() + _BEHIND, match[0]) for match in pattern.finditer(after)]
        found += [(distance // _PHRASE, index, words) for distance, words in near]
    return min(found, default=None)


def speaks_of_quaternions(text: str) -> bool:
    """True if a text mentions quaternions."""
    return len(re.findall(r"quaternion", text, re.IGNORECASE)) > 2


class Prose:
    """The words of a text about its symbols. given: kinds that are stated elsewhere, which come first."""

    def __init__(
        self,
        text: str,
        inline: Sequence[Display] = (),
        displays: Sequence[Display] = (),
        given: Sequence[Guess] = (),
    ) -> None:
        self.text = text
        self.given = {flat(each.name): each for each in given}
        self.has_quaternions = speaks_of_quaternions(" ".join([text, *(each.kind for each in given)]))
        self._numbers_parts = any(
            all(re.search(rf"q_\{{?{part}", text) for part in parts) for parts in ("0123", "1234")
        )
        self._inline, self._displays = inline, displays
        self._flat = flat(text)
        self._alone: dict[str, list[tuple[str, str]]] | None = None
        self._guesses: dict[str, Guess | None] = {}

    def given_for(self, name: str) -> Guess | None:
        """Returns the kind of a symbol that is given; None if none is."""
        known = self.given.get(flat(name))
        return None if known is None else replace(known, name=name)

    def guess(self, name: str) -> Guess | None:
        """Returns the kind of a symbol: the given one, or the one that words or a set of the text state; None
        if there is none."""
        if name not in self._guesses:
            self._guesses[name] = self._guess(name)
        return self._guesses[name]

    def _guess(self, name: str) -> Guess | None:
        if (known := self.given_for(name)) is not None:
            return known
        if (kind := self._in_a_set(flat(name))) is not None:
            return Guess(name, kind, "the text says what set it is in", origin=GuessOrigin.WORDS)
        said = [each for near in self._near(flat(name)) if (each := _nearest(*near)) is not None]
        if said:
            _, place, words = min(said, key=lambda each: each[:2])
            kind = _WORDS[place][1]
            if kind == "quaternion" and self.has_quaternions:
                return self._of_quaternions(name)
            plain = "scalar" if kind == "inertia" else kind.removeprefix("unit ")
            words = " ".join(words.split())
            why = f'the text says "{words}" near it'
            is_unit, is_inertia = kind == "unit vector", kind == "inertia"
            return Guess(
                name, plain, why, is_unit, is_inertia=is_inertia, words=words, origin=GuessOrigin.WORDS
            )
        return self._of_quaternions(name)

    def is_inertia(self, name: str) -> bool:
        """True if words next to a symbol say that it is an inertia."""
        return any(re.search(r"\binertia", " ".join(near)) for near in self._near(flat(name)))

    def _of_quaternions(self, name: str) -> Guess | None:
        """Returns the guess for q in any font in a text on quaternions, and for its parts."""
        if not self.has_quaternions or (quaternion := _QUATERNION.fullmatch(name)) is None:
            return None
        part = quaternion["part"] or ""
        is_number = bool(part) and part in "01234" and self._numbers_parts
        kind = "scalar" if is_number else _PARTS.get(part, "hamilton quaternion")
        return Guess(name, kind, "the text speaks of quaternions", origin=GuessOrigin.QUATERNIONS)

    def _in_a_set(self, name: str) -> str | None:
        """Returns the kind of a symbol that the text states to be in a set."""
        said = re.search(
            rf"(?<![A-Za-z\\_^]){re.escape(name)}(?:,[^=$]{{1,12}}?|=[^=$]{{1,300}}?)?\\in(?![tf])([^$=,.;&]{{1,40}})",
            self._flat,
        )
        plain = _FONTS.sub("", said[1]) if said else ""
        found = ((re.match(pattern, plain), kind) for pattern, kind in _SETS.items())
        return next((match.expand(kind) for match, kind in found if match), None)

    def _near(self, name: str) -> list[tuple[str, str]]:
        """Returns the words before and after each inline formula that is the symbol alone, or an equation for
        it."""
        if self._alone is None:
            self._alone = {}
            listed = ""
            for formula in self._inline:
                key, text = flat(formula.latex.partition("=")[0]), formula.source.text
                before = re.sub(
                    r"(?:\$|\\\(|:math:`)\s*$", "", text[max(0, formula.start - _NEAR) : formula.start]
                )
                after = re.sub(r"^\s*(?:\$|\\\)|`)", "", text[formula.end : formula.end + _NEAR])
                before, after = re.split(r"[.;$]", before)[-1], _OF_OTHERS.split(after)[0]
                if not _LISTED.fullmatch(before):
                    listed = "" if _OF_OTHERS.search(before) else before
                elif listed:
                    before = listed
                self._alone.setdefault(key, []).append((before.lower(), after.lower()))
            for display in self._displays:
                left, _, right = display.latex.partition("=")
                if right and not display.before.endswith((".", ";")):
                    self._alone.setdefault(flat(left), []).append((display.before[-_NEAR:].lower(), ""))
        return self._alone.get(name, [])

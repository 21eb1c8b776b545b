"""What a text says of its symbols in words."""

from __future__ import annotations

import re
from collections.abc import Sequence

from workbench.ingest.proposals import speaks_of_quaternions
from workbench.ingest.typefaces import Guess, flat
from workbench.papers.texts import Display

_WORDS = (
    (
        re.compile(r"rotation(?:al)? matri|orthogonal (?:matri|tensor)|rotation tensor|direction cosine"),
        "rotation",
    ),
    (re.compile(r"homogeneous|transformation matri|rigid[- ](?:body )?transform"), "transform"),
    (re.compile(r"unit(?:[- ]length|-norm)? (?:vector|axis|direction)|normali[sz]ed vector"), "unit vector"),
    (re.compile(r"\bvectors?\b|velocit|position\b|displacement|angular momentum|torque"), "vector"),
    (re.compile(r"\btensors?\b|\bmatri(?:x|ces)\b"), "tensor"),
    (re.compile(r"\bscalars?\b|\bangles?\b|\bmass\b|\bcoordinates?\b|\blength\b|\bdistance\b"), "scalar"),
)
#: What the members of a set are, by its name without fonts and blanks.
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
#: A q in any font; the parts of one have names of their own.
_QUATERNION = re.compile(
    r"(?:\\(?:mathbf|boldsymbol|mathsf|bar|vec|hat|underline)\{)?q\}?(?:_\{(?P<part>[^{}]*)\})?(?:\^\{[^{}]*\})?"
)
_PARTS = {"v": "vector", **dict.fromkeys("swxyz", "scalar")}


class Prose:
    """What a text says of its symbols in words."""

    def __init__(self, text: str, inline: Sequence[Display] = ()) -> None:
        self.text = text
        self.has_quaternions = speaks_of_quaternions(text)
        self._numbers_parts = all(re.search(rf"q_\{{?{part}", text) for part in "0123")
        self._inline = inline
        self._flat = flat(text)
        self._alone: dict[str, list[str]] | None = None

    def guess(self, name: str) -> Guess | None:
        if (kind := self._in_a_set(flat(name))) is not None:
            return Guess(name, kind, "the text says what set it is in")
        beside = self._near(flat(name))
        for pattern, kind in _WORDS:
            for near in beside:
                if found := pattern.search(near):
                    plain = kind.removeprefix("unit ")
                    why = f'the text says "{" ".join(found[0].split())}" near it'
                    return Guess(name, plain, why, unit=plain != kind)
        if self.has_quaternions and (quaternion := _QUATERNION.fullmatch(name)):
            part = quaternion["part"] or ""
            is_number = bool(part) and part in "0123" and self._numbers_parts
            kind = "scalar" if is_number else _PARTS.get(part, "hamilton quaternion")
            return Guess(name, kind, "the text speaks of quaternions")
        return None

    def _in_a_set(self, name: str) -> str | None:
        """The kind of what the text says to be in a set."""
        said = re.search(
            rf"(?<![A-Za-z\\_^]){re.escape(name)}(?:,[^=$]{{1,12}}?|=[^=$]{{1,300}}?)?\\in(?![tf])([^$=,.;&]{{1,40}})",
            self._flat,
        )
        plain = _FONTS.sub("", said[1]) if said else ""
        found = ((re.match(pattern, plain), kind) for pattern, kind in _SETS.items())
        return next((match.expand(kind) for match, kind in found if match), None)

    def _near(self, name: str) -> list[str]:
        """The words beside each formula in the text that is the symbol alone, or says what it is."""
        if self._alone is None:
            self._alone = {}
            for formula in self._inline:
                key, text = flat(formula.latex.partition("=")[0]), formula.source.text
                before = re.sub(
                    r"(?:\$|\\\(|:math:`)\s*$", "", text[max(0, formula.start - _NEAR) : formula.start]
                )
                after = re.sub(r"^\s*(?:\$|\\\)|`)", "", text[formula.end : formula.end + _NEAR])
                before, after = re.split(r"[.;$]", before)[-1], re.split(r"[.;,$]", after)[0]
                self._alone.setdefault(key, []).append(f"{before} {after}".lower())
        return self._alone.get(name, [])

"""Model entries of symbols: the inferred kind, the properties that the text states, and letters of labels."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import chain

from workbench.language.naming.spelling import INDEX_LETTERS
from workbench.papers.drafting.inference.infer import Inference, Inferred, kind_name
from workbench.papers.drafting.inference.kind_signatures import SCALAR, TENSOR, VECTOR, Kind
from workbench.papers.drafting.inference.priors import face, is_open
from workbench.papers.drafting.typefaces import Guess, GuessOrigin, by_typeface
from workbench.papers.drafting.words_on_symbols import Prose

#: The number used for an undetermined size.
OPEN = "2"
_TURN = re.compile(r"(?:\{\}.*\})?(?:\\[a-z]+\{)*[RC]\}?(?![a-z])")
_LENGTHS = re.compile(r"(?:[lLmabdcg]|\\ell)(?:_\{.*\})?")
#: The acceleration of gravity as a vector.
_GRAVITY = re.compile(r"(?:\\[a-z]+\{)?g\}?")

_IN_WORDS = re.compile(r"\\(?:text|textrm|mathrm|operatorname|label|ref|eqref|begin|end)\s*\*?\{[^{}]*\}")
#: A letter with marks, and its subscript.
_BELOW = re.compile(
    r"(?P<base>(?:\\[A-Za-z]+\s*\{?\s*)*[A-Za-z]?|\\[A-Za-z]+)\s*\}*(?:'|\^\s*\{?[\d*+-]*\}?)?"
    r"\s*_\s*(?:\{(?P<long>[^{}]*)\}|(?P<short>[A-Za-z0-9]))"
)
#: A letter with marks and perhaps a subscript, and its superscript: one letter.
_ABOVE = re.compile(
    r"(?P<base>(?:\\[A-Za-z]+\s*\{?\s*)*[A-Za-z]?|\\[A-Za-z]+)\s*\}*(?:\s*_\s*(?:\{[^{}]*\}|\w))?"
    r"\s*\^\s*(?:\{\s*(?P<long>[A-Za-z])\s*\}|(?P<short>[A-Za-z]))"
)
_SUM = re.compile(r"\\(?:sum|prod)(?![A-Za-z])")
_FLAT = re.compile(r"[\s{}]")
_MACRO = re.compile(r"\\[A-Za-z]+")


def guesses_of(inference: Inference, prose: Prose) -> dict[str, Guess]:
    """Returns the guess for each symbol of a text."""
    return {name: _guess(name, found, inference, prose) for name, found in inference.kinds.items()}


def _guess(name: str, found: Inferred, inference: Inference, prose: Prose) -> Guess:
    said = prose.guess(name)
    kind, size = kind_name(found.kind), found.kind
    is_said = said is not None and said.kind in (kind, "rotation" if size == TENSOR else kind)
    kind = kind_of_model(size)
    why, words = (said.why, said.words) if said is not None and is_said else (_why(name, found), "")
    if size == TENSOR and _is_rotation(name, inference, said):
        kind = "rotation"
    elif size == (4, 4) and ((said is not None and said.kind == "transform") or name in inference.orthogonal):
        kind = "transform"
    unit = size == VECTOR and said is not None and said.unit
    usual = _LENGTHS if size == SCALAR else _GRAVITY if size == VECTOR else None
    constant = usual is not None and name not in inference.moving and bool(usual.fullmatch(name))
    origin = said.origin if said is not None and is_said else GuessOrigin.FORMULAS
    return Guess(name, kind, why, unit, constant, words=words, origin=origin)


def kind_of_model(kind: Kind, size: str = OPEN) -> str:
    """Returns the name of a kind in a model, with a number for an undetermined size."""
    return re.sub(r"n(?=×|$)", size, kind_name(kind)) if is_open(kind) else kind_name(kind)


def open_kinds(inference: Inference, guesses: Mapping[str, Guess]) -> dict[str, Kind]:
    """Returns the guessed symbols with an undetermined size, and their kinds."""
    kinds = {name: inference.kinds[name].kind for name in guesses if name in inference.kinds}
    return {
        name: kind
        for name, kind in kinds.items()
        if is_open(kind) and guesses[name].kind == kind_of_model(kind)
    }


def _is_rotation(name: str, inference: Inference, said: Guess | None) -> bool:
    is_said = said is not None and said.kind == "rotation"
    return is_said or name in inference.orthogonal or bool(_TURN.match(name))


def _why(name: str, found: Inferred) -> str:
    """Returns the reason of a kind: the formulas that would cost more with another, or the typeface."""
    if found.because:
        lines = ", ".join(map(str, found.because[:3]))
        more = ", …" if len(found.because) > 3 else ""
        return f"fits the formulas of line {lines}{more}"
    return by_typeface(name).why or face(name)


def labels_in(formulas: Iterable[str]) -> Iterator[Guess]:
    """Yields the letters that stand only as scripts of symbols, and are neither indices nor powers.

    One is the superscript of a symbol that has other letters there, too: n of v^n beside v^b. Another is the
    whole subscript of symbols without other members: m of F_m and v_m, unless the text writes F_1, F_{m+1},
    F_j or m = 1, 2, …, or sums such symbols.
    """
    texts = [_IN_WORDS.sub(" ", latex) for latex in formulas]
    below: dict[str, set[str]] = {}
    for match in chain.from_iterable(map(_BELOW.finditer, texts)):
        said = "".join((match["long"] or match["short"] or "").split())
        below.setdefault("".join(match["base"].split()).replace("{", ""), set()).add(said)
    frames = _letters_above(texts)
    alone = [_MACRO.sub(" ", _ABOVE.sub(" ", _BELOW.sub(" ", text))) for text in texts]
    for letter in sorted(INDEX_LETTERS):
        bases = {base for base, own in below.items() if letter in own}
        members = {said for base in bases for said in below[base] if said != letter}
        composite = {said for own in below.values() for said in own if letter in _letters_of(said)}
        is_index = any(re.search(r"\d|^[i-np]$", said) for said in members) or composite - {letter}
        is_summed = any(_SUM.search(text) and f"_{letter}" in _FLAT.sub("", text) for text in texts)
        is_above = letter in frames
        is_named = any(text.strip() == letter for text in alone) and not is_above
        is_written = is_named or any(_alone(letter, text) for text in alone if text.strip() != letter)
        is_other = is_written or is_summed or (is_index and not is_above)
        if (bases or is_above) and not is_other:
            yield Guess(letter, "scalar", "a label of symbols, and no index")


def _alone(letter: str, text: str) -> bool:
    """True if a letter stands in a formula without its scripts."""
    return re.search(rf"(?<![A-Za-z]){letter}(?![A-Za-z])|{letter}\s*=", text) is not None


def _letters_above(texts: Iterable[str]) -> set[str]:
    """Returns the superscripts beside others that cannot be powers: the n of x^n beside x^b."""
    above: dict[str, set[str]] = {}
    for match in chain.from_iterable(map(_ABOVE.finditer, texts)):
        base = "".join(match["base"].split()).replace("{", "")
        above.setdefault(base, set()).add(match["long"] or match["short"])
    labelled = (own for own in above.values() if own - INDEX_LETTERS - {"T", "t"})
    return set(chain.from_iterable(labelled))


def _letters_of(subscript: str) -> str:
    """Returns the letters of a subscript that may be indices: none of a word such as "max"."""
    plain = _MACRO.sub(" ", subscript)
    return "" if re.search(r"[A-Za-hoq-z]", plain) else plain

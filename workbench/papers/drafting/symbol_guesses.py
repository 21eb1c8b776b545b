"""Model entries of symbols: the inferred kind, and the properties that the text states."""

from __future__ import annotations

import re
from collections.abc import Mapping

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


def guesses_of(inference: Inference, prose: Prose) -> dict[str, Guess]:
    """Returns the guess for each symbol of a text."""
    return {name: _guess(name, found, inference, prose) for name, found in inference.kinds.items()}


def _guess(name: str, found: Inferred, inference: Inference, prose: Prose) -> Guess:
    said = prose.guess(name)
    kind, size = kind_name(found.kind), found.kind
    is_said = said is not None and said.kind in (kind, "rotation" if size == TENSOR else kind)
    kind = kind_of_model(size)
    why = said.why if said is not None and is_said else _why(name, found)
    if size == TENSOR and _is_rotation(name, inference, said):
        kind = "rotation"
    elif size == (4, 4) and ((said is not None and said.kind == "transform") or name in inference.orthogonal):
        kind = "transform"
    unit = size == VECTOR and said is not None and said.unit
    usual = _LENGTHS if size == SCALAR else _GRAVITY if size == VECTOR else None
    constant = usual is not None and name not in inference.moving and bool(usual.fullmatch(name))
    origin = said.origin if said is not None and is_said else GuessOrigin.FORMULAS
    return Guess(name, kind, why, unit, constant, origin=origin)


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

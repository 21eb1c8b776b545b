"""Statement of a text that the matrix of a display is a rotation: the words right before the display."""

from __future__ import annotations

import re

from workbench.core.terms import Relation, Statement, Symbol
from workbench.source.documents import Display

_NOUN = (
    r"rotation(?:al)?[- ](?:matri(?:x|ces)|tensors?)|direction[- ]cosines?(?: matri(?:x|ces))?"
    r"|attitude matri(?:x|ces)|(?:the|a|an|each|basic|elementary|principal|simple|plane|planar) rotations?"
    r"(?=\W*$| (?:in|around|about|by|through|of|is|are|from|to)\b)"
)
_ROTATION = re.compile(rf"\b(?P<words>{_NOUN})\b(?P<behind>[^.;]*)$", re.IGNORECASE)
#: Words that make another matrix of a rotation, or one that is a rotation in the limit only.
_OTHER = re.compile(
    r"\b(?:not|nor|small|infinitesimal|approximat\w*|linear\w*|first[- ]order|error|rates?|velocit\w*"
    r"|derivatives?|differen\w*|jacobian|gradient|generator|log(?:arithm)?|skew\w*|scal\w+|translat\w+"
    r"|shear\w*|twist|reflection|entr\w+|elements?|components? of)\b",
    re.IGNORECASE,
)
#: How many characters may stand between the noun and the display.
_NEAR = 80


def stated_rotation(display: Display, statement: Statement) -> str | None:
    """Returns the words by which the text says that the symbol alone on the left is a rotation.

    Returns None if the formula is no such equation, or if the sentence before the display says more.
    """
    match statement:
        case Relation(operator="=", left=Symbol(), right=right) if right.type.is_square:
            pass
        case _:
            return None
    said = _ROTATION.search(display.before)
    if said is None or len(said["behind"]) > _NEAR or _OTHER.search(said[0]):
        return None
    start = display.before[: said.start()]
    return None if _OTHER.search(start[-_NEAR:]) else said["words"]


def is_plural(words: str) -> bool:
    """True if the words tell of several matrices."""
    return words.endswith(("s", "ices")) and not words.endswith("cosines")

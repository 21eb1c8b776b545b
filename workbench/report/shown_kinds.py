"""Presentation of verdicts and faults: name, sign, words, style."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """One verdict or state.

    Attributes:
        sign: For readers who do not see the colour.
        style: On a terminal.
        counted: The words after a number of equations.
        look: The class of its marks on a page.
    """

    name: str
    sign: str
    label: str
    meaning: str
    style: str
    counted: str = ""
    look: str = ""


def _by_name(*kinds: Kind) -> dict[str, Kind]:
    return {kind.name: kind for kind in kinds}


VERDICTS = _by_name(
    Kind("proved", "✓", "proved", "proved exactly, and again by a second engine", "green"),
    Kind("definition", "≔", "definition", "it agrees with what stands before it", "green"),
    Kind("conditional", "H", "conditional", "proved under a condition that the text leaves out", "yellow"),
    Kind("refuted", "✗", "refuted", "a counterexample shows that it is false", "red"),
    Kind("ill-formed", "G", "ill-formed", "types or time weights do not fit", "magenta"),
    Kind("argued", "A", "argued", "what joins its goal to the sentence is prose", "yellow"),
    Kind("probable", "≈", "probable", "random points only: not proved", "yellow"),
    Kind("unchecked", "?", "not checked", "never counted as passed", "dim"),
)

#: The states of an equation, the worst first. "holds" is used only for what is printed and proved.
STATES = _by_name(
    Kind("error", "✗", "error", "false as meant: an argument or a result changes", "red", "errors", "err"),
    Kind("warning", "!", "warning", "false, unless what is named is meant", "yellow", "warnings", "warn"),
    Kind("misprint", "!", "misprint", "the right form is plain", "magenta", "misprints", "warn"),
    Kind("wording", "·", "wording", "a sentence or a label", "magenta", "wording", "note"),
    Kind(
        "hypothesis", "!", "condition missing", "true under a condition that the text leaves out",
        "yellow", "conditions missing", "warn",
    ),
    Kind(
        "transcription", "", "lost in our copy", "the transcription that was read probably lost a mark",
        "cyan", "lost in our copy", "lost",
    ),
    Kind(
        "open", "?", "not settled", "argued or only probable; never counted as proved",
        "dim", "not settled", "open",
    ),
    Kind("unjudged", "?", "not judged", "no verdict, with the reason", "dim", "not judged", "open"),
    Kind(
        "inherits", "↳", "holds after a correction", "right once what it rests on is corrected",
        "green", "hold after a correction", "ok",
    ),
    Kind("holds", "✓", "holds as printed", "proved, or a definition that agrees with its uses",
         "green", "hold as printed", "ok"),
    Kind("defines", "·", "definition", "each says what a symbol is", "green", "definitions", "note"),
)  # fmt: skip

#: The states in the order of a page: errors first, faults that are not the author's last.
SHOWN = tuple(
    STATES[name]
    for name in (
        *("error", "warning", "misprint", "hypothesis", "wording", "unjudged", "open"),
        *("inherits", "holds", "defines", "transcription"),
    )
)

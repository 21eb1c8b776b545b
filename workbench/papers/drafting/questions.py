"""Questions that a text leaves open and only its author can answer."""

from __future__ import annotations

import re

from workbench.source.documents import Text

_SIGNS = (
    (
        r"(?<!\\)'",
        "Is a prime d/dt? The reader takes it for part of no name: x' is refused until it is declared.",
    ),
    (
        r"\\(?:wide)?hat(?![A-Za-z])",
        "Is the hat part of a name (a unit vector), or the skew tensor of a vector?",
    ),
    (
        r"\\(?:wide)?tilde(?![A-Za-z])",
        "The reader takes \\tilde{x} of a vector for its skew tensor. Is it that here?",
    ),
    (r"\\bar(?![A-Za-z])|\\overline", "Is the bar part of a name? The reader takes it so."),
    (r"\^\{?(?:\\ast|\*)", "The reader takes ^* of a tensor for the adjugate. Is it a conjugate here?"),
    (
        r"\\dot(?![A-Za-z])",
        "Is \\dot{x} the derivative in one frame for all vectors? The reader takes it so.",
    ),
    (
        r"(?<![A-Za-z\\])(?:\\mathbf\{?\s*)?I(?![A-Za-z])",
        "What is I: the unit tensor, an inertia, or a frame?",
    ),
    (r"\\mathbb\{?\s*1|\\mathds|\\mathbf\{?\s*1", "Is the bold 1 the unit tensor?"),
    (r"\^\{?[01]\}?(?![0-9])", "Is 0 or 1 in a superscript a frame, or a power?"),
    (r"\{\}\s*[_^]", "Do scripts on the left name frames (the vector resolved in, or seen from)?"),
    (
        r"\\wedge(?![A-Za-z])",
        "Is \\wedge the vector product, the exterior product, or (as a script) the skew tensor?",
    ),
    (
        r"(?<![A-Za-z\\])q(?![A-Za-z])",
        "Is q a quaternion (Hamilton or JPL, scalar first or last), or a coordinate?",
    ),
)


def questions_of(text: Text) -> list[str]:
    """Returns each question once, with the line of the first formula that raises it."""
    asked = []
    for pattern, question in _SIGNS:
        for display in text.displays:
            if re.search(pattern, display.latex):
                asked.append(f"{question} (line {display.line})")
                break
    opaque = {name: display.line for display in reversed(text.displays) for name in display.opaque}
    for name, line in sorted(opaque.items(), key=lambda pair: pair[1]):
        asked.append(
            f"What does \\{name} stand for? Only TeX can follow it; --macros FILE may say. (line {line})"
        )
    return asked

"""How verdicts and faults are shown, everywhere: name, sign, colour, sentence."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Kind:
    """One verdict or fault. sign: for readers who do not see the colour.   style: on a terminal.
    ink, fill: on a light page and on a dark one."""

    name: str
    sign: str
    label: str
    meaning: str
    style: str
    ink: tuple[str, str]
    fill: tuple[str, str]


_GREEN, _GREY = (
    (("#1a6b33", "#8fdca3"), ("#dff1e2", "#183524")),
    (("#4d565f", "#c0c7ce"), ("#e9ebed", "#2c3137")),
)
_RED, _AMBER = (
    (("#a3170c", "#ffaaa0"), ("#fce0dc", "#4a1a16")),
    (("#7a4a00", "#f5c76b"), ("#fdeccb", "#42310c")),
)
_VIOLET, _BLUE = (
    (("#5b2a93", "#d4b5ff"), ("#ece1f9", "#35234d")),
    (("#0f5e70", "#8fdcec"), ("#d8eff4", "#103640")),
)
_OLIVE, _WHITE = (
    (("#6b5200", "#e8cf7a"), ("#f5ecd0", "#3a3010")),
    (("#3a3d41", "#e0e2e5"), ("#ffffff", "#15171a")),
)

VERDICTS = {
    kind.name: kind
    for kind in (
        Kind("proved", "✓", "proved", "proved exactly, and again by a second engine", "green", *_GREEN),
        Kind("definition", "≔", "definition", "it agrees with what stands before it", "green", *_GREY),
        Kind(
            "conditional",
            "H",
            "conditional",
            "proved under a condition that the text leaves out",
            "yellow",
            *_VIOLET,
        ),
        Kind("refuted", "✗", "refuted", "a counterexample shows that it is false", "red", *_RED),
        Kind("ill-formed", "G", "ill-formed", "types or time weights do not fit", "magenta", *_AMBER),
        Kind("argued", "A", "argued", "what joins its goal to the sentence is prose", "yellow", *_OLIVE),
        Kind("probable", "≈", "probable", "random points only: not proved", "yellow", *_BLUE),
        Kind("unchecked", "?", "not checked", "never counted as passed", "dim", *_WHITE),
    )
}

#: Worst first. `holds` is said only of what is printed and was proved.
STATES = {
    kind.name: kind
    for kind in (
        Kind("error", "✗", "error", "false as meant: an argument or a result changes", "red", *_RED),
        Kind("misprint", "M", "misprint", "an author would mend it without thinking", "magenta", *_AMBER),
        Kind("wording", "W", "wording", "a sentence or a label", "magenta", *_BLUE),
        Kind(
            "hypothesis",
            "H",
            "hypothesis",
            "true under a condition that the text leaves out",
            "yellow",
            *_VIOLET,
        ),
        Kind(
            "transcription",
            "T",
            "transcription",
            "probably lost by the transcription that was read",
            "cyan",
            *_GREY,
        ),
        Kind(
            "open",
            "?",
            "not settled",
            "argued, only probable or not checked; never counted as proved",
            "dim",
            *_WHITE,
        ),
        Kind("inherits", "↳", "holds with a mend", "right once what it rests on is mended", "green", *_OLIVE),
        Kind("holds", "✓", "holds as printed", "proved twice, or a definition that agrees", "green", *_GREEN),
    )
}

"""The parts of the manual and the order of their pages. The topic of a page is its file name without
suffix."""

from __future__ import annotations

#: (part, folder, pages in order). Other pages of the folder follow in alphabetical order.
PARTS: tuple[tuple[str, str, tuple[str, ...]], ...] = (
    ("Tutorial", "tutorial", ("first-paper", "first-robot")),
    (
        "How-to",
        "howto",
        (
            "why-not-judged",
            "model",
            "accents",
            "frames",
            "quaternions",
            "matrices",
            "derivatives",
            "angles",
            "extrema",
            "laws",
            "macros",
            "many-papers",
            "page",
            "notebook",
            "book",
            "ci",
            "editor",
            "assistant",
            "erratum-note",
            "motions",
            "certificates",
            "python",
        ),
    ),
    (
        "Robots",
        "robot",
        (
            "robot-conventions",
            "robot-files",
            "trajectories",
            "fast-evaluation",
            "partials",
            "relative-motion",
            "torques",
            "closed-loops",
            "recordings",
            "time-scaling",
        ),
    ),
    (
        "Reference",
        "reference",
        (
            "verdicts",
            "command-line",
            "model-keys",
            "notation",
            "spellings",
            "conditions",
            "messages",
            "api",
            "conventions",
        ),
    ),
    ("Explanation", "explanation", ("engines", "context", "trust", "certified", "mistakes", "speed")),
    ("Contributing", "contributing", ("contributing", "chapter-claims", "mutants")),
    ("About", "about", ("glossary", "changelog", "citing")),
)

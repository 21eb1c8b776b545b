"""Formulas as people paste them: between dollar signs, in an environment, with Unicode signs, or from a
Python string that was not raw."""

from __future__ import annotations

import re

_WRAPPED = re.compile(
    r"\s*(?:\$\$(?P<dollars>.*)\$\$|\$(?P<dollar>[^$]*)\$|\\\[(?P<square>.*)\\\]|\\\((?P<round>.*)\\\)"
    r"|\\begin\{(?P<name>equation|displaymath|math)(?P<star>\*?)\}(?P<body>.*)\\end\{(?P=name)(?P=star)\})\s*",
    re.DOTALL,
)
_LABEL = re.compile(r"\\label\{[^{}]*\}|\\nonumber(?![A-Za-z])|\\notag(?![A-Za-z])")
_SIGNS = {
    "×": r"\times ", "·": r"\cdot ", "⋅": r"\cdot ", "−": "-", "⊗": r"\otimes ", "≠": r"\neq ",
    "≤": r"\leq ", "≥": r"\geq ", "²": "^2", "³": "^3", "ᵀ": "^T", "⊤": "^T", "‖": r"\|",
}  # fmt: skip
#: Control characters in a string that is not raw → the letter after the lost backslash.
_LOST = {"\t": "t", "\r": "r", "\b": "b", "\f": "f", "\a": "a", "\v": "v"}
_ESCAPED = re.compile(r"[\t\r\b\f\a\v](?=[a-z]{2})|\n(?=(?:abla|eq|u|ot|eg|leq|geq)(?![a-z]))")


def as_typed(text: str) -> tuple[str, tuple[str, ...]]:
    """Returns the formula in a text that a person typed or pasted, and remarks on what was changed."""
    remarks: list[str] = []
    latex = text
    if _ESCAPED.search(latex):
        latex = _ESCAPED.sub(lambda match: "\\" + _LOST.get(match[0], "n"), latex)
        remarks.append(r"read a control character as a lost backslash; write a raw string, r'\times'")
    if match := _WRAPPED.fullmatch(latex):
        groups = ("dollars", "dollar", "square", "round", "body")
        latex = next(match[key] for key in groups if match[key] is not None)
    latex = _LABEL.sub("", latex)
    for sign, command in _SIGNS.items():
        latex = latex.replace(sign, command)
    return latex.strip().rstrip(".,;").rstrip(), tuple(remarks)

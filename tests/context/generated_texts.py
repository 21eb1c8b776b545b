"""Generated texts with models: facts about symbols, and claims that hold or fail with and without them.

A symbol is written as <a>, so that each text can be written with other letters. All facts hold together where
a, b, n are the axes, f, g, h, m are numbers with p = m f and x = 2 f, and R rests: no text contradicts itself."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType

from hypothesis import strategies as st

from tests.context.judged_texts import judged
from workbench.core.verdict import Verdict

KINDS = {
    **dict.fromkeys("abn", "vector"),
    **dict.fromkeys("fghmpx", "scalar"),
    "R": "rotation",
    "T": "tensor",
}
#: Letters of which no convention speaks, and others of which conventions may speak.
_MARKS = "abnfghmpxRT"
PLAIN = dict(zip(_MARKS, _MARKS, strict=True))
GREEK = dict(
    zip(
        _MARKS,
        [
            r"\xi",
            r"\eta",
            r"\zeta",
            r"\alpha",
            r"\beta",
            r"\gamma",
            r"\mu",
            r"\rho",
            r"\kappa",
            r"\Lambda",
            r"\Sigma",
        ],
        strict=True,
    )
)
SPOKEN = dict(
    zip(_MARKS, [r"i", r"j", r"\hat{k}", r"c", r"s", r"w", r"y", r"z", r"k", r"Q", r"I"], strict=True)
)
NO_FLAGS: Mapping[str, str] = MappingProxyType({})
#: What the model defines, in every text.
DEFINED = "'<p>' = '<m> <f>'"


@dataclass(frozen=True)
class Piece:
    """Words, and the display behind them if there is one."""

    words: str
    display: str | None = None


#: What a text may say of its symbols, by the symbols.
SENTENCES = (
    "The vector $<n>$ is a unit vector.",
    "Here $<m>$ is constant.",
    "Suppose that $<T>$ is symmetric.",
    "The number $<m>$ is positive.",
    "It is assumed that $<R>$ is constant.",
)
FORMULAS = (
    Piece("We define", "<x> := 2 <f>"),
    Piece("We write", "<x> = 2 <f>"),
    Piece("The law of motion is", r"<m> \ddot{<f>} = -<g> <f>"),
    Piece("By assumption", r"<a> \cdot <b> = 0"),
)
CONDITIONS = (
    r"As $<a>$ and $<b>$ are orthogonal, we have",
    r"For $<a> \cdot <b> = 0$ we have",
    r"For $<h> \neq 0$ we have",
    r"For $<m> > 0$ we have",
    r"For $<g> = 1$ we have",
    r"For constant $<m>$ we have",
    r"For a unit vector $<n>$ we have",
)
#: The sides of formulas: most hold of all symbols, the others by one of the facts.
SIDES = (
    (r"<a> \times <b>", r"-<b> \times <a>"),
    (r"<f> (<g> <a>)", r"<g> <f> <a>"),
    (r"<R> (<a> \times <b>)", r"(<R> <a>) \times (<R> <b>)"),
    (r"\frac{d}{dt} (<f> <a>)", r"\dot{<f>} <a> + <f> \dot{<a>}"),
    (r"(<a> + <b>) \cdot (<a> + <b>)", r"<a> \cdot <a> + <b> \cdot <b>"),
    (r"(<n> \cdot <n>) <f>", r"<f>"),
    (r"\frac{d}{dt} (<m> <f>)", r"<m> \dot{<f>}"),
    (r"\dot{<p>}", r"<m> \dot{<f>}"),
    (r"\dot{<p>}", r"\dot{<m>} <f> + <m> \dot{<f>}"),
    (r"\frac{d}{dt} (<R> <a>)", r"<R> \dot{<a>}"),
    (r"<a> \cdot (<T> <b>)", r"<b> \cdot (<T> <a>)"),
    (r"<x> <a> + <x> <a>", r"4 <f> <a>"),
    (r"<x>", r"2 <f>"),
    (r"<m> <m> \ddot{<f>} + <f>", r"<f> - <m> <g> <f>"),
    (r"<g> <g> <b>", r"<g> <b>"),
    (r"\sqrt{<m>^2} <a>", r"<m> <a>"),
    (r"\frac{<h> <a>}{<h>}", r"<a>"),
)


def _claim(sides: tuple[str, str], factor: int, words: str) -> Piece:
    left, right = sides
    return Piece(words, f"{left} = {right}" if factor == 1 else f"{left} = {factor} ({right})")


#: A formula that holds by nothing, by itself, or by facts; sometimes with a wrong factor.
claims = st.builds(
    _claim,
    st.sampled_from(SIDES),
    st.sampled_from((1, 1, 2)),
    st.sampled_from(("We have", "We have", *CONDITIONS)),
)
#: Each formula once, without facts, and each beneath other words.
WHOLE = [_claim(sides, 1, "We have") for sides in SIDES]
SUPPOSING = [Piece(CONDITIONS[at % len(CONDITIONS)], piece.display) for at, piece in enumerate(WHOLE)]
facts = st.one_of(st.builds(Piece, st.sampled_from(SENTENCES)), st.sampled_from(FORMULAS))
texts = st.lists(st.one_of(facts, claims, claims), min_size=2, max_size=5).filter(
    lambda pieces: any(piece.display for piece in pieces)
)


def lettered(latex: str, letters: Mapping[str, str]) -> str:
    """Returns the words or the formula with these letters."""
    return re.sub(r"<(\w)>(?=([A-Za-z])?)", lambda m: letters[m[1]] + " " * bool(m[2]), latex)


def text_of(pieces: Sequence[Piece]) -> str:
    """Returns the text, a paragraph for each piece."""
    parts = [f"{each.words}\n\n$$\n{each.display}\n$$" if each.display else each.words for each in pieces]
    return "\n\n".join(parts) + "\n"


def model_of(
    letters: Mapping[str, str] = PLAIN,
    flags: Mapping[str, str] = NO_FLAGS,
    conventions: bool = True,
    extra: str = "",
    more: str = "",
) -> str:
    """Returns the model. flags: more that is declared of a symbol, as in {"n": "unit = true"}.   extra: rows
    for other symbols.   more: definitions, claims and scopes."""
    rows = [
        f"'{letters[mark]}' = {{ kind = \"{kind}\"{', ' * (mark in flags)}{flags.get(mark, '')} }}"
        for mark, kind in KINDS.items()
    ]
    off = "" if conventions else '[conventions]\nletters = "none"\n'
    defined = f"[definitions]\n{lettered(DEFINED, letters)}\n"
    return f'source = "p.md"\n{off}[symbols]\n' + "\n".join([*rows, extra]) + f"\n{defined}{more}"


def verdicts_on(
    folder: Path, pieces: Sequence[Piece], of: str, letters: Mapping[str, str] = PLAIN
) -> list[Verdict]:
    """Returns the verdicts on the displays of the pieces, in their order."""
    return judged(folder, lettered(text_of(pieces), letters), of)

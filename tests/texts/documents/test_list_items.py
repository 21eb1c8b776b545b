"""An item of a list is a sentence of its own; the words before the list belong to each of its items."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.texts.written import model_of, text_of, verdicts
from workbench.core.verdict import Outcome
from workbench.source.documents.list_items import MARK, with_item_marks

LETTERS = {"a": "a", "b": "b", "f": "f", "g": "g", "h": "h", "x": "x", "m": "m"}
HELD = "f g h + f^2 h = f (g + h)"
VALUE = "f = 0"


def tex(items: Sequence[str], name: str) -> str:
    return rf"\begin{{{name}}}" + "\n".join(rf"\item {item}" for item in items) + rf"\end{{{name}}}"


def marked(items: Sequence[str], mark: str, between: str = "\n") -> str:
    indent = " " * (len(mark) + 1)
    return between.join(f"{mark} " + item.replace("\n", f"\n{indent}") for item in items)


#: Format, how it writes a list, and how it writes a display in an item.
LISTS = {
    "itemize": ("tex", lambda items: tex(items, "itemize"), rf"\[ {HELD} \]"),
    "enumerate": ("tex", lambda items: tex(items, "enumerate"), rf"\[ {HELD} \]"),
    **{
        f"Markdown {mark}": ("md", lambda items, mark=mark: marked(items, mark), f"\n$$\n{HELD}\n$$\n")
        for mark in ("-", "*", "+", "1.", "2)")
    },
    "in one line": ("md", lambda items: marked(items, "-"), f"$${HELD}$$"),
    "loose": ("md", lambda items: marked(items, "-", "\n\n"), f"\n\n$$\n{HELD}\n$$\n\n"),
    "notebook": ("ipynb", lambda items: marked(items, "*"), f"\n$$\n{HELD}\n$$\n"),
    "rst": ("rst", lambda items: marked(items, "#.", "\n\n"), f"\n\n.. math:: {HELD}\n\n"),
    "HTML": (
        "html",
        lambda items: "<ul>" + "".join(f"<li>{each}" for each in items) + "</ul>",
        f"$${HELD}$$",
    ),
}


def outcomes(folder: Path, text: str, form: str) -> list[Outcome]:
    if form == "rst":
        text = text.replace(f"${VALUE}$", f":math:`{VALUE}`")
    if form == "html":
        text = text.replace(f"${VALUE}$", rf"\({VALUE}\)")
    if form == "ipynb":
        cell = {"cell_type": "markdown", "metadata": {}, "source": text.splitlines(keepends=True)}
        text = json.dumps({"cells": [cell]}, indent=1)
    text = text_of([text], form)
    return [each.outcome for each in verdicts(folder, text, model_of(LETTERS, form), form)]


@pytest.mark.parametrize("name", LISTS)
def test_condition_of_an_item_reaches_no_other(tmp_path: Path, name: str) -> None:
    form, list_of, display = LISTS[name]
    items = [
        f"in general we get {display}",
        f"for ${VALUE}$ we get {display}",
        f"and {display}",
        f"{display} where ${VALUE}$",
        display,
    ]
    expected = [Outcome.REFUTED, Outcome.CONDITIONAL] * 2 + [Outcome.REFUTED]
    assert outcomes(tmp_path, list_of(items), form) == expected


@pytest.mark.parametrize("name", LISTS)
def test_words_before_a_list_belong_to_each_item(tmp_path: Path, name: str) -> None:
    form, list_of, display = LISTS[name]
    items = list_of([f"we get {display}", f"and {display}"])
    text = f"If ${VALUE}$, then\n\n{items}\n\nIn general: {display}"
    expected = [Outcome.CONDITIONAL, Outcome.CONDITIONAL, Outcome.REFUTED]
    assert outcomes(tmp_path, text, form) == expected


def test_words_before_a_list_end_with_a_full_stop(tmp_path: Path) -> None:
    display = f"$${HELD}$$"
    text = f"This is easy if ${VALUE}$.\n\n- One {display}\n- Another {display}"
    assert outcomes(tmp_path, text, "md") == [Outcome.REFUTED, Outcome.REFUTED]


def test_words_before_a_nested_list_belong_to_it_alone(tmp_path: Path) -> None:
    display = f"$${HELD}$$"
    text = f"- for ${VALUE}$:\n  - one {display}\n  - another {display}\n- in general {display}"
    assert outcomes(tmp_path, text, "md") == [Outcome.CONDITIONAL, Outcome.CONDITIONAL, Outcome.REFUTED]


@pytest.mark.parametrize("words", ["Let us assume {}.", "Here {}.", "Let {}."])
def test_supposition_of_an_item_reaches_its_own_list_only(tmp_path: Path, words: str) -> None:
    display, said = f"$${HELD}$$", words.format(f"${VALUE}$")
    text = f"- {said}\n  - Then {display}\n  - and {display}\n- In general {display}"
    assert outcomes(tmp_path, text, "md") == [Outcome.CONDITIONAL, Outcome.CONDITIONAL, Outcome.REFUTED]
    items = rf"\begin{{enumerate}}\item One {display}\item and {display}\end{{enumerate}}"
    text = rf"\begin{{itemize}}\item {said} {items}\item In general {display}\end{{itemize}}"
    assert outcomes(tmp_path, text, "tex") == [Outcome.CONDITIONAL, Outcome.CONDITIONAL, Outcome.REFUTED]


@pytest.mark.parametrize(
    "formula",
    [
        "$$\na\n- b\n$$",
        "\\[\na\n+ b\n\\]",
        "\\begin{align*}\na\n- b\n\\end{align*}",
        "```math\na\n- b\n```",
        ".. math::\n\n   a\n   - b\n\nwords",
        "so $a\n- b$ is",
    ],
)
def test_sign_that_begins_a_row_is_no_item(formula: str) -> None:
    text = f"- one\n\n{formula}\n\n2. another\n"
    found = with_item_marks(text)
    assert found == text.replace("- one", f"{MARK} one").replace("2. another", f"{MARK}  another")

"""A product of vectors that does not match is not refuted if a sentence writes its first factor as a function."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.texts.written import shown, symbols_of, verdicts
from workbench.core.verdict import Outcome, Verdict

KINDS = {"a": "vector", "b": "vector", "f": "scalar"}

#: Displays, and the question that names a line of a model only if the line can be written.
ASKED = {
    r"a(b \times b) = b": r"a symbol of its own says a at b\timesb",
    r"a(b \times (b + a)) = b": r"a symbol of its own says a at b\times(b+a)",
    r"a(f (b + (a))) + b = b": "a symbol of its own says a at f(b+(a))",
}


def verdict_of(folder: Path, inline: str, display: str) -> Verdict:
    (found,) = verdicts(folder, f"Note ${inline}$ here.\n\n{shown(display)}\n", symbols_of(KINDS))
    return found


@pytest.mark.parametrize("display", ASKED)
def test_product_of_a_function_in_a_sentence_is_unread(tmp_path: Path, display: str) -> None:
    verdict = verdict_of(tmp_path, "a(f)", display)
    assert verdict.outcome is Outcome.UNCHECKED
    assert verdict.reason is not None
    assert ASKED[display] in verdict.reason


@pytest.mark.parametrize("display", ASKED)
def test_product_without_a_function_in_a_sentence_is_ill_formed(tmp_path: Path, display: str) -> None:
    assert verdict_of(tmp_path, "b(f)", display).outcome is Outcome.ILL_FORMED


def test_question_on_a_bracket_with_a_name_states_the_line(tmp_path: Path) -> None:
    verdict = verdict_of(tmp_path, "a(f)", r"a(b) + f = b")
    assert verdict.reason is not None
    assert "[conventions] arguments = ['b'] says a at b" in verdict.reason

"""A sentence that states no condition on the symbols of a formula changes no verdict on it."""

from pathlib import Path

import pytest

from tests.context.judged_texts import FALSE, TRUE, judged, seen, text_of
from tests.context.neutral_sentences import NEUTRAL, TRAPS

PLAIN = "We have"


@pytest.fixture(scope="module")
def plain(tmp_path_factory: pytest.TempPathFactory):
    folder = tmp_path_factory.mktemp("plain")
    return [seen(verdict) for verdict in judged(folder, text_of([*FALSE, *TRUE], PLAIN))]


def test_false_displays_are_errors_and_warnings(plain) -> None:
    false, true = plain[: len(FALSE)], plain[len(FALSE) :]
    assert {verdict[0] for verdict in false} == {"refuted"} and {verdict[0] for verdict in true} == {"proved"}
    assert {verdict[1] for verdict in false} <= {"error", "warning"}
    assert sum(verdict[1] == "error" for verdict in false) >= 4


@pytest.mark.parametrize("words", TRAPS)
def test_words_of_no_condition_silence_nothing(tmp_path: Path, words: str, plain) -> None:
    text = text_of([FALSE[0], FALSE[-1], TRUE[0]], words)
    chosen = [plain[0], plain[len(FALSE) - 1], plain[len(FALSE)]]
    assert [seen(verdict) for verdict in judged(tmp_path, text)] == chosen


@pytest.mark.slow
@pytest.mark.parametrize("words", NEUTRAL)
def test_neutral_sentence_changes_nothing(tmp_path: Path, words: str, plain) -> None:
    assert [seen(verdict) for verdict in judged(tmp_path, text_of([*FALSE, *TRUE], words))] == plain

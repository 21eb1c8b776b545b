"""A formula that holds by a hint holds so for both engines, or the hint is a doubt."""

from pathlib import Path

import pytest

from tests.context.judged_texts import judged, model, text_of
from workbench.core.verdict import Outcome
from workbench.engines.jet import consequences

TEXT = text_of([r"\hat{n} \cdot \hat{n} = 1"])
HAT = "a unit vector, as its hat says"


def test_hint_that_the_second_engine_does_not_confirm_is_a_doubt(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (held,) = judged(tmp_path, TEXT, model({r"\hat{n}": "vector"}))
    assert held.outcome is Outcome.CONDITIONAL and HAT in str(held.reason)
    monkeypatch.setattr(consequences, "recheck", lambda *_: False)
    (open_,) = judged(tmp_path, TEXT, model({r"\hat{n}": "vector"}))
    assert open_.outcome is Outcome.REFUTED and any(HAT in doubt for doubt in open_.unless)

"""Drafts of earlier runs: found again exactly where nothing that they depend on changed."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.drafts import draft_of
from tests.ingest.test_draft import WRONG
from workbench.app.pipeline.verdict_keys import Keys
from workbench.papers.drafting import drafted_texts
from workbench.papers.drafting.draft_model import Ingested
from workbench.papers.drafting.drafted_texts import Draft, newest_draft
from workbench.papers.drafting.model_file import model_text
from workbench.papers.drafting.questions_to_author import questions_about
from workbench.runtime import fingerprint
from workbench.runtime.store import Store
from workbench.source.documents import Text, read_text

PAPERS = sorted(
    path
    for path in Path(__file__).parent.rglob("*")
    if path.suffix in (".tex", ".md") and path.stem != "README"
)

whole = drafted_texts.ingested


def told(draft: Draft) -> Any:
    """All that is made of a draft later."""
    keys = Keys({}, {})
    claims = [(c.id, c.source, c.context.span, keys.of(c, "printed")) for c in draft.paper.claims]
    asked = [(str(question), question.answers) for question in questions_about(draft, [])]
    found = draft.ingested
    model = model_text(found, Path("model.toml"))
    return claims, asked, model, found.to_dict(), found.missing(), found.inference, draft.summary


def drafted_anew(path: Path, store: Store, monkeypatch: pytest.MonkeyPatch) -> bool:
    made: list[Text] = []

    def ingested(text: Text) -> Ingested:
        made.append(text)
        return whole(text)

    monkeypatch.setattr(drafted_texts, "ingested", ingested)
    newest_draft(read_text(path), store)
    monkeypatch.undo()
    return bool(made)


@pytest.mark.parametrize("path", PAPERS, ids=lambda path: path.stem)
def test_a_kept_draft_equals_a_fresh_one(tmp_path: Path, path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store, fresh = Store(tmp_path / "kept.sqlite"), told(draft_of(path))
    assert told(newest_draft(read_text(path), store)) == fresh
    monkeypatch.setattr(drafted_texts, "ingested", lambda text: pytest.fail("drafted again"))
    assert told(newest_draft(read_text(path), store)) == fresh


def test_any_file_of_a_text_makes_a_new_draft(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    store, path, part = Store(tmp_path / "kept.sqlite"), tmp_path / "p.tex", tmp_path / "part.tex"
    path.write_text(WRONG + "\\input{part}")
    assert drafted_anew(path, store, monkeypatch)
    assert not drafted_anew(path, store, monkeypatch)
    part.write_text("$$ a = b $$")
    assert drafted_anew(path, store, monkeypatch)
    part.write_text("$$ a = c $$")
    assert drafted_anew(path, store, monkeypatch)
    path.write_text(WRONG.replace("vectors", "numbers") + "\\input{part}")
    assert drafted_anew(path, store, monkeypatch)
    assert not drafted_anew(path, store, monkeypatch)
    monkeypatch.setattr(fingerprint, "_code_of", lambda package: "other")
    newest_draft(read_text(path), store)
    monkeypatch.undo()
    assert drafted_anew(path, store, monkeypatch)


def test_one_draft_is_kept_of_a_file(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    for number in range(3):
        path.write_text(WRONG + "word " * number)
        store = Store(tmp_path / "kept.sqlite")
        newest_draft(read_text(path), store)
        assert store._database is not None
        assert store._database.execute("SELECT count(*) FROM kept").fetchone() == (1,)
        store.close()

"""Many files are read in processes of their own: what comes of it is what comes of reading them here."""

from __future__ import annotations

from pathlib import Path

import pytest
from bad_papers import GOOD_CLAIM, HEAD

from workbench.app.pipeline.verdict_keys import Keys
from workbench.papers import PaperError, find_paper, load, merge
from workbench.papers.installed_papers import installed
from workbench.runtime.store import Store


def keys_of(paper) -> list[tuple[str, str, int | None]]:
    keys = Keys(paper.theorems, {})
    return [(claim.id, keys.of(claim, "printed"), claim.line) for claim in paper.claims]


@pytest.fixture(params=[1, 3])
def cores(request, monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: request.param)
    return request.param


@pytest.fixture
def read_here(monkeypatch) -> list[Path]:
    """The files whose notations are read in this process."""
    read = []
    here = load._notation_of
    monkeypatch.setattr(load, "_notation_of", lambda files: (read.append(files[-1].path), here(files))[1])
    return read


def test_the_chapter_is_the_same_however_it_is_read(cores, read_here):
    paper = installed("chapter")
    told = merge(paper.files, paper.theorems)
    assert keys_of(told) == keys_of(find_paper("chapter"))
    assert (set(paper.files) <= set(read_here)) == (cores == 1)


def test_meanwhile_is_called_once_and_only_where_others_read(cores):
    paper, called = installed("chapter"), []
    merge(paper.files, paper.theorems, meanwhile=lambda: called.append(1))
    assert len(called) == (cores > 1)


def write(folder: Path, **claims: str) -> list[Path]:
    paths = [folder / f"{name}.toml" for name in claims]
    for path, text in zip(paths, claims.values(), strict=True):
        path.write_text(HEAD + text, encoding="utf-8")
    return paths


def of_id(name: str) -> str:
    return GOOD_CLAIM.replace('"1"', f'"{name}"')


@pytest.mark.parametrize(
    "third", [of_id("1"), of_id("3") + 'titel = "x"\n', of_id("3").replace("printed = ", "printed = 7 #")]
)
def test_faults_are_those_of_reading_one_after_the_other(third, tmp_path, monkeypatch):
    paths = write(tmp_path, a=of_id("1"), b=of_id("2"), c=third, d=of_id("4"), e=of_id("5"))
    told = []
    for count in (1, 2):
        monkeypatch.setattr("os.cpu_count", lambda count=count: count)
        with pytest.raises(PaperError) as caught:
            merge(paths)
        told.append([(fault.file, fault.line, fault.column, fault.message) for fault in caught.value.faults])
    assert told[0] == told[1] and told[0]


def test_results_of_parallel_readers_are_cached(tmp_path, monkeypatch, read_here):
    monkeypatch.setattr("os.cpu_count", lambda: 2)
    paths = write(tmp_path, **{name: of_id(name) for name in "abcde"})
    papers = []
    for _ in range(2):
        store = Store(tmp_path / "kept.sqlite")
        papers.append(merge(paths, store=store))
        store.close()
    assert keys_of(papers[0]) == keys_of(papers[1]) and len(papers[0].claims) == 5
    assert read_here == []

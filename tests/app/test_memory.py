"""Verdicts of earlier runs: found again exactly where nothing that they depend on changed."""

from __future__ import annotations

import os
import pickle
import sqlite3
import subprocess
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner

from tests.planted import planted
from workbench.app.commands.commands import main
from workbench.app.pipeline import result_proposals
from workbench.app.pipeline.judge_claims import PaperJudge, judge_paper
from workbench.app.pipeline.verdict_keys import Keys, Memory
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.hypotheses import Hypothesis
from workbench.core.verdict import Counterexample, Evidence, Outcome, Verdict
from workbench.papers import find_paper, installed_notation, load_installed, load_paper
from workbench.repair.propose import parallel_repairs
from workbench.repair.propose.proposal import Repair
from workbench.repair.propose.search_limits import STANDARD
from workbench.runtime import fingerprint, stored_objects
from workbench.runtime.store import Store

PAPER = r"""
title = "t"
[symbols]
a = { kind = "vector" }
b = { kind = "vector" }
c = { kind = "vector" }
[definitions]
s = 'a \cdot b'
q = 's s'
w = 'c \cdot c'
[[claim]]
id = "1"
printed = 'q = (a \cdot b)^2'
[[claim]]
id = "2"
printed = 'w = c^2'
[[claim]]
id = "3"
printed = 'a \times b = b \times a'
corrected = 'a \times b = -b \times a'
"""


def keys_of(tmp_path: Path, text: str, options: dict | None = None) -> dict[str, str]:
    path = tmp_path / "paper.toml"
    path.write_text(text)
    paper = load_paper(path)
    keys = Keys(paper.theorems, options or {})
    return {claim.id: keys.of(claim, "printed") for claim in paper.claims}


def changed(tmp_path: Path, old: str, new: str) -> set[str]:
    assert old in PAPER
    before, after = keys_of(tmp_path, PAPER), keys_of(tmp_path, PAPER.replace(old, new, 1))
    return {name for name in before if before[name] != after[name]}


@pytest.mark.parametrize(
    ("old", "new", "judged_again"),
    [
        ("w = c^2", "c^2 = w", {"2"}),
        (r"s = 'a \cdot b'", r"s = 'b \cdot a'", {"1"}),
        (r"w = 'c \cdot c'", r"w = '2 c \cdot c'", {"2"}),
        ('c = { kind = "vector" }', 'c = { kind = "vector", constant = true }', {"2"}),
        ('b = { kind = "vector" }', 'b = { kind = "vector", unit = true }', {"1", "3"}),
        ("w = c^2'", "w = c^2'\nassume = ['a = 0']", {"2"}),
        ("w = c^2'", "w = c^2'\nnote = 'of no account'", set()),
        ('title = "t"', 'title = "another"', set()),
    ],
)
def test_claims_affected_by_a_change_are_judged_again(tmp_path, old, new, judged_again):
    assert changed(tmp_path, old, new) == judged_again


def test_options_code_and_versions_are_part_of_the_key(tmp_path, monkeypatch):
    plain = keys_of(tmp_path, PAPER)
    assert not set(plain.values()) & set(keys_of(tmp_path, PAPER, {"motions": False}).values())
    monkeypatch.setattr(fingerprint, "version", lambda name: "0")
    assert not set(plain.values()) & set(keys_of(tmp_path, PAPER).values())
    monkeypatch.undo()
    monkeypatch.setattr(fingerprint, "_code_of", lambda package: "other")
    assert not set(plain.values()) & set(keys_of(tmp_path, PAPER).values())


def judged(tmp_path: Path, file: Path) -> tuple[list, list[str]]:
    """The results, and the claims whose printed form was judged and not remembered."""
    (tmp_path / "paper.toml").write_text(PAPER)
    paper, memory, new = load_paper(tmp_path / "paper.toml"), Memory(file), []
    judge = PaperJudge(paper, memory=memory)
    keep, memory.remember = (
        memory.remember,
        lambda key, verdict: (new.append(verdict.read_back), keep(key, verdict)),
    )
    results = list(judge.results(paper.claims))
    judge.close()
    memory.close()
    return results, new


def test_a_second_run_judges_nothing_and_says_the_same(tmp_path):
    first, new = judged(tmp_path, tmp_path / "v.sqlite")
    assert len(new) == 4
    again, none = judged(tmp_path, tmp_path / "v.sqlite")
    assert none == []
    assert [(r.verdict, r.corrected) for r in again] == [(r.verdict, r.corrected) for r in first]


@pytest.mark.parametrize("damage", ["truncated", "other bytes", "other table", "edited verdict", "directory"])
def test_a_damaged_file_is_not_believed(tmp_path, damage):
    file = tmp_path / "v.sqlite"
    first, _ = judged(tmp_path, file)
    if damage == "truncated":
        file.write_bytes(file.read_bytes()[:700])
    elif damage == "other bytes":
        file.write_bytes(os.urandom(5000))
    elif damage == "directory":
        file.unlink()
        file.mkdir()
    else:
        with sqlite3.connect(file) as database:
            if damage == "other table":
                database.execute("DROP TABLE kept")
                database.execute("CREATE TABLE kept (name TEXT)")
            else:
                database.execute("UPDATE kept SET value = CAST(replace(value, 'refuted', 'proved') AS BLOB)")
    again, new = judged(tmp_path, file)
    assert [r.verdict for r in again] == [r.verdict for r in first]
    assert any("times" in read_back for read_back in new)


@pytest.mark.parametrize("outcome", list(Outcome))
def test_a_verdict_comes_back_as_it_was(outcome):
    evidence = (Evidence("m", "o", {"samples": 3, "bound": ["w_WB"], "scale": 0.1}),)
    against = Counterexample({"a": ("1", "1/2", "0")}, ("1",), ("2",))
    reason = VerdictCode.FOR(values="n = 1")
    fields = {"read_back": "a", "reason": reason, "hypothesis": Hypothesis.of("h"), "counterexample": against}
    whole = planted(outcome, scope="all n", evidence=evidence, **fields)
    for verdict in (whole, planted(outcome)):
        assert Verdict.from_dict(verdict.to_dict(), verdict.proof) == verdict


def test_keys_are_the_same_in_every_process() -> None:
    """Sets have another order where Python hashes texts otherwise."""
    program = """
from workbench.papers import find_paper
from workbench.app.pipeline import result_proposals as proposals
from workbench.app.pipeline.verdict_keys import Keys
for paper in map(find_paper, (None, "vectors")):
    keys = Keys(paper.theorems, {})
    print([(claim.id, keys.of(claim, "printed")) for claim in paper.claims])
"""
    seen = {
        subprocess.run(
            [sys.executable, "-c", program],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(seen) == 1


class Counted(Store):
    """What is read from it, and what was not there."""

    def __init__(self, file: Path) -> None:
        super().__init__(file)
        self.found, self.missed = 0, 0

    def get(self, key: str) -> bytes | None:
        value = super().get(key)
        self.found, self.missed = self.found + (value is not None), self.missed + (value is None)
        return value


def read(tmp_path: Path, text: str) -> tuple[Counted, list]:
    """The store when a paper is read, and its claims with their keys."""
    (tmp_path / "paper.toml").write_text(text)
    store = Counted(tmp_path / "kept.sqlite")
    paper = load_paper(tmp_path / "paper.toml", [], store)
    store.close()
    keys = Keys(paper.theorems, {})
    return store, [(claim.id, claim.printed, claim.line, keys.of(claim, "printed")) for claim in paper.claims]


def test_a_cached_file_equals_a_fresh_reading(tmp_path):
    first, fresh = read(tmp_path, PAPER)
    second, again = read(tmp_path, PAPER)
    assert (first.found, second.found, second.missed) == (0, 1, 0)
    assert again == fresh


@pytest.mark.parametrize(
    "second",
    [
        PAPER.replace("w = c^2", "c^2 = w"),
        PAPER.replace(r"c \cdot c", r"2 c \cdot c"),
        PAPER.replace('title = "t"', 'title = "t"\n'),
    ],
)
def test_a_file_that_changed_is_read_again(tmp_path, second):
    read(tmp_path, PAPER)
    assert read(tmp_path, second)[0].found == 0


def test_faulty_files_are_not_cached(tmp_path):
    for _ in range(2):
        store, claims = read(tmp_path, PAPER + '\n[[claim]]\nid = "4"\nprinted = "a +"\n')
        assert len(claims) == 3 and store.found == 0


def test_installed_papers_are_read_once_per_process(tmp_path):
    papers = [load_installed("chapter", Store(tmp_path / f"{n}.sqlite")) for n in range(2)]
    assert papers[0] is papers[1] is find_paper(None) is find_paper("chapter")
    assert installed_notation() is installed_notation(store=Store(tmp_path / "3.sqlite"))
    assert load_installed("vectors") is not papers[0]


def test_terms_from_another_process_are_found_among_ours() -> None:
    """Texts have another hash there, and terms remember theirs."""
    program = """
import sys
from workbench.runtime.stored_objects import packed
from workbench.papers import find_paper
definitions = list(find_paper(None).definitions)
assert hash(definitions[0].body)
sys.stdout.buffer.write(packed(definitions))
"""
    environment = os.environ | {"PYTHONHASHSEED": "1"}
    told = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, check=True)
    ours = {definition.body for definition in find_paper(None).definitions}
    assert all(definition.body in ours for definition in stored_objects.unpacked(told.stdout))


def test_only_our_terms_come_back_from_bytes():
    for foreign in (os.system, subprocess.Popen, Store, pickle.loads):
        with pytest.raises(pickle.UnpicklingError, match="is not kept"):
            stored_objects.unpacked(pickle.dumps(foreign))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("c = {", 'd = { kind = "vector" }\nc = {'),  # any symbol may stand in what is proposed
        (r"s = 'a \cdot b'", r"s = 'b \cdot a'"),
        (r"'a \times b = b \times a'", r"'a \times b = 2 b \times a'"),
    ],
)
def test_proposals_are_searched_again_after_any_change(tmp_path, old, new):
    def key(text: str) -> str:
        (tmp_path / "paper.toml").write_text(text)
        return Keys({}, {}).of_proposals(load_paper(tmp_path / "paper.toml").claims[2])

    assert key(PAPER) == key(PAPER.replace('"t"', '"u"')) != key(PAPER.replace(old, new, 1))


def test_proposals_are_cached(tmp_path, monkeypatch):
    monkeypatch.setenv("WORKBENCH_CACHE", str(tmp_path))
    (tmp_path / "paper.toml").write_text(PAPER.replace("corrected", "note"))
    command = ["check", str(tmp_path / "paper.toml")]
    first = CliRunner().invoke(main, command)
    assert "edit" in first.stdout
    monkeypatch.setattr(parallel_repairs, "repair", lambda *_: pytest.fail("searched again"))
    assert CliRunner().invoke(main, command).stdout == first.stdout
    (tmp_path / "paper.toml").write_text(PAPER)  # its correction is proved: nothing is looked for
    assert CliRunner().invoke(main, command).exit_code == 0


def test_a_search_that_is_interrupted_is_not_kept(tmp_path, monkeypatch):
    (tmp_path / "paper.toml").write_text(PAPER)
    results, memory = judge_paper(load_paper(tmp_path / "paper.toml")), Memory(tmp_path / "v.sqlite")
    for interrupted, known in ((True, None), (False, ())):
        monkeypatch.setattr(
            parallel_repairs,
            "repair",
            lambda claim, _, beside=(), i=interrupted: Repair(claim, interrupted=i),
        )
        result_proposals.with_proposals(results, memory=memory)
        assert (
            memory.proposals(
                Keys({}, {"proposals": STANDARD}).of_proposals(results[2].claim, result_proposals.ALONE.key)
            )
            == known
        )

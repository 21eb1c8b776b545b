"""`proved` is made by the rules of inference only: all other ways raise."""

from __future__ import annotations

import ast
import copy
import json
import pickle
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

import workbench
from tests.planted import PLANTED, planted
from workbench.app.pipeline.dask_workers import Cluster
from workbench.app.pipeline.verdict_keys import Memory
from workbench.core import proof
from workbench.core.proof import Proof, Unproved, take_maker
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.prover.decide import inference
from workbench.prover.decide.inference import Seal, agreement, conclusion, generalization
from workbench.runtime.limits import Budget
from workbench.runtime.workers import Workers

ROOT = Path(workbench.__file__).parent
OPEN, REFUTED = Verdict(Outcome.UNCHECKED), Verdict(Outcome.REFUTED)


def proved(scope: str | None = None) -> Verdict:
    return planted(Outcome.PROVED, scope=scope, evidence=(PLANTED,))


def from_state() -> Verdict:
    """As pickle restores an object that has no constructor."""
    verdict = Verdict.__new__(Verdict)
    verdict.__setstate__({**vars(OPEN), "outcome": Outcome.PROVED})
    return verdict


def from_tampered_bytes() -> Verdict:
    data = pickle.dumps(proved("n = 1..8"))
    assert b"n = 1..8" in data
    return pickle.loads(data.replace(b"n = 1..8", b"all n >0"))


def with_a_bare_token() -> Verdict:
    return Verdict(Outcome.PROVED, proof=object.__new__(Proof))


def with_a_copied_token() -> Verdict:
    """The fields of a genuine token, in one that no rule has made."""
    token = object.__new__(Proof)
    object.__setattr__(token, "rule", "planted")
    object.__setattr__(token, "scope", None)
    return Verdict(Outcome.PROVED, proof=token)


#: The ways past the rules that only the constructor of a verdict stops.
BY_CONSTRUCTOR: list[Callable[[], Verdict]] = [
    lambda: Verdict(Outcome.PROVED),
    lambda: Verdict("proved"),  # type: ignore[arg-type]
    lambda: Verdict(Outcome.PROVED, proof=object()),  # type: ignore[arg-type]
    lambda: replace(OPEN, outcome=Outcome.PROVED),
    lambda: replace(replace(proved(), outcome=Outcome.CONDITIONAL), outcome=Outcome.PROVED),
    lambda: replace(proved("n = 1..8"), scope="all n"),
    lambda: replace(proved("n = 1..8"), scope=None),
    lambda: Verdict.from_dict(proved().to_dict()),
    lambda: Verdict.from_dict(OPEN.to_dict() | {"outcome": "proved"}),
    with_a_bare_token,
    with_a_copied_token,
]

#: The other ways past them.
OTHERS: list[Callable[[], object]] = [
    Proof,
    lambda: Proof("a rule", None),
    lambda: setattr(proved().proof, "scope", "all n"),
    lambda: type("Own", (Proof,), {}),
    lambda: type("Own", (Verdict,), {"__post_init__": lambda self: None}),
    lambda: pickle.dumps(proved().proof),
    lambda: copy.copy(proved().proof),
    lambda: take_maker("tests"),
    from_state,
    from_tampered_bytes,
    lambda: agreement(PLANTED, PLANTED, [PLANTED]),
    lambda: agreement(PLANTED, Evidence("another", "residual is 0"), [PLANTED]),
    lambda: conclusion("conjunction", [proved(), OPEN], [PLANTED]),
    lambda: conclusion("conjunction", [REFUTED], [PLANTED]),
    lambda: conclusion("conjunction", [], []),
]


@pytest.mark.parametrize("way", [*BY_CONSTRUCTOR, *OTHERS])
def test_proved_is_not_forged(way: Callable[[], object]) -> None:
    with pytest.raises(Unproved):
        way()


@pytest.mark.parametrize("way", BY_CONSTRUCTOR)
def test_each_way_forges_without_the_check(way: Callable[[], Verdict], monkeypatch) -> None:
    monkeypatch.setattr(Verdict, "__post_init__", lambda self: None)
    assert way().outcome == Outcome.PROVED


def test_generalization_leaves_what_is_not_proved() -> None:
    for verdict in (OPEN, REFUTED):
        seen = generalization(verdict, "all n", [PLANTED])
        assert (seen.outcome, seen.scope, seen.proof) == (verdict.outcome, "all n", None)


def test_proof_is_lost_with_the_outcome() -> None:
    assert proved().proof is not None and replace(proved(), outcome=Outcome.ARGUED).proof is None


# past the process


def test_copies_and_pickles_of_a_proved_verdict_are_proved() -> None:
    for verdict in (proved("all n"), OPEN):
        for again in (copy.copy(verdict), copy.deepcopy(verdict), pickle.loads(pickle.dumps(verdict))):
            assert again == verdict and (again.proof is None) is (verdict.proof is None)


def test_proved_comes_back_from_a_worker() -> None:
    with Workers(lambda scope: proved(scope), Budget()) as workers:
        assert workers.call("all n") == proved("all n")


def forged(key: str) -> dict[str, dict[str, Any]]:
    """JSON values of proved verdicts that no rule has made, for a store with another secret."""
    genuine = Seal(b"secret").closed(key, proved())
    return {
        "without a seal": OPEN.to_dict() | {"outcome": "proved"},
        "with a rule": OPEN.to_dict() | {"outcome": "proved", "rule": "planted", "seal": ""},
        "of another secret": genuine,
        "of nothing": {"outcome": "proved"},
    }


@pytest.mark.parametrize("way", forged(""))
def test_forged_verdict_is_not_recalled(way: str, tmp_path: Path) -> None:
    memory = Memory(tmp_path / "kept.sqlite")
    memory.put("key", json.dumps(forged("key")[way]).encode())
    assert memory.recall("key") is None


@pytest.mark.parametrize("change", [{"scope": "all n"}, {"read_back": "b"}, {"rule": "another"}])
def test_seal_covers_the_verdict_its_rule_and_its_key(change: dict[str, str], tmp_path: Path) -> None:
    memory = Memory(tmp_path / "kept.sqlite")
    memory.remember("key", proved())
    text = memory.get("key")
    assert text is not None and memory.recall("key") == proved()
    for key, data in (("key", json.loads(text) | change), ("another", json.loads(text))):
        memory.put(key, json.dumps(data).encode())
        assert memory.recall(key) is None


def test_values_of_another_secret_are_not_believed(tmp_path: Path) -> None:
    memory = Memory(tmp_path / "kept.sqlite")
    memory.remember("key", proved())
    memory.close()
    again = Memory(tmp_path / "kept.sqlite")
    assert again.recall("key") == proved()
    again.close()
    (secret,) = tmp_path.glob("*.secret")
    assert secret.stat().st_mode & 0o077 == 0
    secret.unlink()
    assert Memory(tmp_path / "kept.sqlite").recall("key") is None


def test_answer_of_a_cluster_needs_the_seal() -> None:
    cluster = Cluster.__new__(Cluster)
    cluster._secret = b"ours"
    assert cluster._answer(Seal(b"ours").closed("key", proved()), "key") == proved()
    for told in (proved().to_dict(), Seal(b"theirs").closed("key", proved())):
        with pytest.raises(Unproved):
            cluster._answer(told, "key")


# the source


#: Module → what only it may name.
OWNERS = {
    "take_maker": {"core/proof.py", "prover/decide/inference.py"},
    "PROCESS_SECRET": {"core/proof.py", "prover/decide/inference.py"},
    "_genuine": {"core/proof.py"},
    "_make": {"prover/decide/inference.py"},
    "is_genuine": {"core/proof.py", "core/verdict.py"},
    "agreement": {
        *("prover/decide/inference.py", "prover/decide/equation.py"),
        *("prover/decide/closed_formulas.py", "prover/decide/disequation.py"),
    },
    "equal_terms": {"prover/decide/inference.py", "prover/goals/prove_goal.py"},
    "conclusion": {
        *("prover/decide/inference.py", "prover/decide/decide.py", "prover/decide/extrema.py"),
        *("prover/goals/prove_goal.py", "prover/decide/linear_integrals.py"),
    },
    "generalization": {
        *("prover/decide/inference.py", "prover/decide/decide.py", "prover/decide/families/families.py"),
        *("prover/decide/families/unbounded_indices.py", "prover/goals/prove_goal.py"),
    },
}


def imported_names(source: str) -> set[str]:
    """The names that a module imports, and those of the private attributes that it reads."""
    tree = ast.parse(source)
    taken = {a.name for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) for a in n.names}
    return taken | {n.attr for n in ast.walk(tree) if isinstance(n, ast.Attribute) and n.attr.startswith("_")}


def around(source: str) -> list[str]:
    """The calls of a module that make a proved verdict, or change one, past its constructor."""
    calls = [ast.unparse(node) for node in ast.walk(ast.parse(source)) if isinstance(node, ast.Call)]
    return [
        call
        for call in calls
        if call.startswith(("object.__new__(", "Verdict.__new__(", "Verdict(Outcome.PROVED"))
        or (call.startswith("object.__setattr__(") and not call.startswith("object.__setattr__(self,"))
    ]


def test_only_their_owners_use_the_rules() -> None:
    for path in sorted(ROOT.rglob("*.py")):
        file = path.relative_to(ROOT).as_posix()
        source = path.read_text("utf-8")
        names = imported_names(source)
        assert [name for name in OWNERS if name in names and file not in OWNERS[name]] == [], file
        assert file in OWNERS["take_maker"] or around(source) == [], file


@pytest.mark.parametrize(
    "source",
    [
        "Verdict(Outcome.PROVED, scope='all')",
        "object.__new__(Verdict)",
        "object.__setattr__(verdict, 'outcome', Outcome.PROVED)",
    ],
)
def test_ways_around_the_constructor_are_seen(source: str) -> None:
    assert around(f"def f():\n    return {source}\n")
    assert "take_maker" in imported_names("from workbench.core.proof import take_maker as t")
    assert "_make" in imported_names("inference._make('a', None)")


def test_public_names_are_the_rules_and_the_seal() -> None:
    assert set(inference.__all__) == {"Seal", "agreement", "conclusion", "equal_terms", "generalization"}
    assert proof._takers == [inference.__name__]

"""Texts at their first attempt: what is said of each display by a model that is not yet finished.

S1 is the finished model without its `[[claim]]` tables, S2 is S1 without the properties of symbols. Truth is the
verdict with the finished model, so that nothing is labelled by hand. Mutants are displays with one edit."""

from __future__ import annotations

import io
import pickle
import re
import shutil
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

from evaluator.mutations import mutated_once

from workbench.app.pipeline.judge_claims import ClaimJudge
from workbench.context.claims import Claim, Formula
from workbench.context.formula_acts import act_of
from workbench.core.formula_errors import IllFormedAt
from workbench.core.names import Name
from workbench.core.terms import IllFormed, Relation
from workbench.core.verdict import Outcome, Verdict
from workbench.language.printing.printer import to_latex
from workbench.papers.installed_papers import installed, installed_names
from workbench.papers.load import load_paper
from workbench.prover.results.claim_results import ClaimResult

#: Its laws of celestial mechanics take minutes at the first attempt.
SLOW = ("rotating_pulsating",)
#: Time for the formulas of a text under one model.
SECONDS = 600.0
_TABLE = re.compile(r"^\[\[claim\]\].*?(?=^\[(?!claim)|^\[\[(?!claim)|\Z)", re.MULTILINE | re.DOTALL)
_FLAG = re.compile(
    r",?\s*\b(?:unit|constant|rotation|positive|symmetric|skew|diagonal|small|independent)\s*=\s*true"
)
_TRUE = frozenset({Outcome.PROVED, Outcome.CONDITIONAL})
_FALSE = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})
#: Letters that are no symbols of an author, and stay.
_KEPT = frozenset({"t", "d", "e", "\\pi", "\\varepsilon", "\\nabla"})


@dataclass(frozen=True)
class Row:
    """One display: whether it is true, and the verdict at the first attempt."""

    source: str
    claim: str
    is_true: bool
    verdict: Verdict

    def __str__(self) -> str:
        said = f"{self.verdict.outcome} ({self.verdict.grade}) {'; '.join(self.verdict.unless)}"
        return f"{'true ' if self.is_true else 'false'} {self.source} {self.claim}: {said}"


def models() -> Iterator[Path]:
    """Yields the models of the installed texts."""
    for name in installed_names():
        for file in installed(name).files:
            if "source" in file.read_text(encoding="utf-8") and file.stem not in SLOW and name != "chapter":
                yield file


def without_claims(model: str) -> str:
    """Returns S1."""
    return _TABLE.sub("", model)


def without_properties(model: str) -> str:
    """Returns S2."""
    return _FLAG.sub("", without_claims(model)).replace('"rotation"', '"tensor"').replace("{ ,", "{ ")


def claims_of(file: Path, change: Callable[[str], str]) -> tuple[Claim, ...]:
    """Returns the claims of a text under a changed model."""
    with tempfile.TemporaryDirectory() as folder:
        shutil.copytree(file.parent, folder, dirs_exist_ok=True)
        changed = Path(folder) / file.name
        changed.write_text(change(file.read_text(encoding="utf-8")), encoding="utf-8")
        return load_paper(changed, faults=[]).claims


def judged(claims: Sequence[Claim], seconds: float = SECONDS) -> dict[str, ClaimResult]:
    """Returns the results by identifier, of one process, until that much time is spent."""
    end, judge, found = time.monotonic() + seconds, ClaimJudge(claims, motions=False), {}
    for result in judge.results(claims, jobs=1):
        found[result.claim.id] = result
        if time.monotonic() > end:
            print(f"  out of time: {len(claims) - len(found)} of {len(claims)} formulas are not judged")
            break
    judge.close()
    return {result.claim.id: result for result in judge.on_shared_guesses([*found.values()])}


def rows_of(file: Path, change: Callable[[str], str]) -> list[Row]:
    """Returns a row for each display whose truth the finished model says."""
    finished = judged(load_paper(file).claims)
    rows = []
    for result in judged(claims_of(file, change)).values():
        known = finished.get(result.claim.id)
        outcome = known.verdict.outcome if known is not None else Outcome.UNCHECKED
        if outcome in _TRUE or outcome in _FALSE:
            rows.append(Row(file.stem, result.claim.id, outcome in _TRUE, result.verdict))
    return rows


def mutants_of(file: Path, change: Callable[[str], str], seed: int) -> list[Row]:
    """Returns a row for one edit in each display that the finished model proves and that is not proved then."""
    random = Random(seed)
    finished = judged(load_paper(file).claims)
    edited = []
    for claim in claims_of(file, change):
        known, said = finished.get(claim.id), claim.printed.statement
        if known is None or known.verdict.outcome is not Outcome.PROVED or not isinstance(said, Relation):
            continue
        try:
            other = mutated_once(random, said, claim.notation.symbols)
        except (IllFormed, IllFormedAt, IndexError, ValueError):
            continue
        printed = Formula(to_latex(other), other)
        act = act_of(printed, claim.notation)
        edited.append(replace(claim, printed=printed).with_context(act=act))
    bare = [c.with_context(alone=True, facts=(), given=(), guessed=()) for c in edited]
    alone = {name: result.verdict for name, result in judged(bare).items()}
    found = judged([c for c in edited if c.id in alone and alone[c.id].outcome in _FALSE])
    return [Row(file.stem, name, False, result.verdict) for name, result in found.items()]


class _Renamer(pickle.Pickler):
    def reducer_override(self, value: Any) -> Any:
        if isinstance(value, Name) and value.letter not in _KEPT:
            own = replace(value, letter=_other(value.letter))
            return Name, tuple(getattr(own, name) for name in own.__dataclass_fields__)
        return NotImplemented


def _other(letter: str) -> str:
    return "\\q" + "".join(f"{ord(each):x}" for each in letter).translate(
        str.maketrans("0123456789", "ghijklmnop")
    )


def renamed(claims: Sequence[Claim]) -> list[Claim]:
    """Returns the claims with another letter for each letter."""
    buffer = io.BytesIO()
    _Renamer(buffer).dump(list(claims))
    return pickle.loads(buffer.getvalue())


def changed_by_renaming(file: Path, change: Callable[[str], str]) -> list[tuple[str, Verdict, Verdict]]:
    """Returns the claims of which renaming changes the outcome or the grade, with both verdicts."""
    claims = claims_of(file, change)
    before, after = judged(claims), judged(renamed(claims))
    pairs = [(name, before[name].verdict, after[name].verdict) for name in before.keys() & after.keys()]
    return [each for each in pairs if (each[1].outcome, each[1].grade) != (each[2].outcome, each[2].grade)]


def tally(rows: Iterable[Row]) -> dict[bool, Counter[str]]:
    """Returns by truth how often each grade is given."""
    counts: dict[bool, Counter[str]] = {True: Counter(), False: Counter()}
    for row in rows:
        counts[row.is_true][str(row.verdict.grade)] += 1
    return counts

"""The verdict ledger: every verdict on the texts at hand, frozen as sorted JSON lines.

`python tests/ledger/verdict_ledger.py` writes the ledger anew; `git diff tests/ledger` then shows which verdicts
changed. A commit that changes a line says why the new verdict is right.
"""

from __future__ import annotations

import json
import sys
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from functools import cache
from pathlib import Path
from random import Random
from typing import Any

HERE = Path(__file__).parent
TESTS = HERE.parent
sys.path[:0] = [str(TESTS.parent), str(TESTS)]

from evaluator.identities import IDENTITIES, TABLE  # noqa: E402
from evaluator.mutations import mutated_once  # noqa: E402

from workbench.app.pipeline.judge_claims import judge_claims, judge_paper  # noqa: E402
from workbench.context.claims import Claim, Formula, Notation, Paper  # noqa: E402
from workbench.context.read_formulas import read_statement  # noqa: E402
from workbench.core.formula_errors import IllFormed, IllFormedAt, ReadError  # noqa: E402
from workbench.core.terms import Relation, Statement  # noqa: E402
from workbench.language.definitions import Definitions  # noqa: E402
from workbench.language.printing.printer import to_latex  # noqa: E402
from workbench.papers.installed_papers import installed_names  # noqa: E402
from workbench.papers.load import load_installed, load_paper  # noqa: E402
from workbench.prover.results.claim_results import ClaimResult  # noqa: E402
from workbench.runtime.limits import STANDARD, Budget  # noqa: E402

#: How many formulas are generated.
GENERATED = 300

#: The budget of the errata: a multiple of the standard one, so that a slow machine gives the same ledger.
PATIENT = Budget(seconds=3 * STANDARD.seconds)

NOTATION = Notation(TABLE, Definitions([]), {})

Entry = dict[str, Any]


def entries_of(source: str, results: Iterable[ClaimResult]) -> list[Entry]:
    """One entry for each form of each claim. Methods are named without their figures, which are rounded."""
    return [
        {
            "source": source,
            "claim": result.claim.id,
            "form": form,
            "outcome": str(verdict.outcome),
            "scope": verdict.scope,
            "hypothesis": verdict.hypothesis and str(verdict.hypothesis),
            "reason": verdict.reason,
            "methods": [evidence.method for evidence in verdict.evidence],
            "counterexample": verdict.counterexample and dict(verdict.counterexample.values),
        }
        for result in results
        for form, verdict in result.verdicts.items()
    ]


def judged(source: str, paper: Paper, jobs: int | None = None, budget: Budget = STANDARD) -> list[Entry]:
    return entries_of(source, judge_paper(paper, jobs=jobs, budget=budget))


@cache
def chapter_results() -> tuple[Paper, list[ClaimResult]]:
    paper = load_installed("chapter")
    return paper, judge_paper(paper)


def chapter() -> list[Entry]:
    return entries_of("chapter", chapter_results()[1])


def installed_texts() -> list[Entry]:
    names = sorted(name for name in installed_names() if name != "chapter")
    return [entry for name in names for entry in judged(name, load_installed(name))]


def paper_files() -> list[Entry]:
    paths = sorted((TESTS / "papers").glob("*.toml"))
    return [entry for path in paths for entry in judged(path.stem, load_paper(path))]


def errata() -> list[Entry]:
    paths = sorted((TESTS / "errata").glob("*/*.toml"))
    texts = [path for path in paths if path.stem in ("before", "after")]
    return [
        entry
        for path in texts
        for entry in judged(f"{path.parent.name}/{path.stem}", load_paper(path), jobs=1, budget=PATIENT)
    ]


def read(latex: str) -> Statement:
    return read_statement(latex, NOTATION, None)[0]


def generated_formulas() -> list[str]:
    """Identities and formulas that differ from one by a single edit, as LaTeX that is read as it was printed."""
    random, made = Random(300), dict[str, None]()
    while len(made) < GENERATED:
        statement = read(random.choice(IDENTITIES))
        with suppress(IllFormed, IllFormedAt, ReadError):
            if isinstance(statement, Relation) and random.random() < 0.7:
                statement = mutated_once(random, statement, TABLE)
            latex = f"{to_latex(statement.left)} {statement.operator} {to_latex(statement.right)}"
            if read(latex) == statement:
                made[latex] = None
    return list(made)


def generated() -> list[Entry]:
    """The verdicts on `generated.txt`, whose formulas `generated_formulas` has written once."""
    formulas = (HERE / "generated.txt").read_text().splitlines()
    claims = [Claim(f"{at:03}", Formula(latex, read(latex)), NOTATION) for at, latex in enumerate(formulas)]
    return entries_of("generated", judge_claims(claims, motions=False))


SECTIONS: dict[str, Callable[[], list[Entry]]] = {
    "chapter": chapter,
    "texts": installed_texts,
    "papers": paper_files,
    "errata": errata,
    "generated": generated,
}


def lines_of(entries: Sequence[Entry]) -> list[str]:
    return sorted(json.dumps(entry, ensure_ascii=False, sort_keys=True) for entry in entries)


def frozen(section: str) -> list[str]:
    return (HERE / f"{section}.jsonl").read_text(encoding="utf-8").splitlines()


def main(sections: Sequence[str]) -> None:
    if not (HERE / "generated.txt").exists():
        (HERE / "generated.txt").write_text("".join(f"{latex}\n" for latex in generated_formulas()))
    for section in sections or SECTIONS:
        text = "".join(f"{line}\n" for line in lines_of(SECTIONS[section]()))
        (HERE / f"{section}.jsonl").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])

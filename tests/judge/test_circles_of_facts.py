"""Definitions of a text that close a circle end no judgement: v = (r + l)/2 beside l = v - w, say."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.context.facts import Fact, Origin, Provider, Strength
from workbench.core.terms import Definition, Relation, Symbol
from workbench.core.verdict import Counterexample, Outcome
from workbench.language.definitions import Definitions
from workbench.prover.explain.other_readings import without_free_pi


def test_circle_of_stated_definitions_beside_pi(tmp_path: Path) -> None:
    path = tmp_path / "p.md"
    path.write_text(
        r"$$ \theta = \frac{2\pi}{n} $$ $$ a = b $$ $$ b = a $$ $$ c + a \theta = c + 2 b \theta + a b $$"
    )
    *_, same, again, last = judge_paper(draft_of(path).paper, motions=False)
    facts = [
        Fact(
            Definition(left.declaration, (), (), right),
            frozenset({left.declaration.name}),
            Origin(Provider.FORMULA, "a = b"),
            Strength.STATED,
        )
        for claim in (same.claim, again.claim)
        if isinstance(claim.printed.statement, Relation)
        for left, right in [(claim.printed.statement.left, claim.printed.statement.right)]
        if isinstance(left, Symbol)
    ]
    assert len(facts) == 2
    claim = replace(last.claim, context=replace(last.claim.context, facts=tuple(facts)))
    claim = replace(
        claim, notation=replace(claim.notation, definitions=_only(claim.notation.definitions, "theta"))
    )
    refuted = replace(
        last.verdict, outcome=Outcome.REFUTED, counterexample=Counterexample({}, ("0",), ("1",))
    )
    assert without_free_pi(claim, refuted).outcome is Outcome.REFUTED  # at the number π, too


def _only(definitions: Definitions, name: str) -> Definitions:
    return Definitions(each for each in definitions if name in str(each.declaration.name))

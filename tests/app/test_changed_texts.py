"""A text that is edited while it is judged: first verdicts on what changed, then those of a fresh check."""

from __future__ import annotations

import asyncio
import random
from collections.abc import Sequence
from pathlib import Path

import pytest

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.app.pipeline.judged_files import Judged, loaded_file
from workbench.app.servers.desk import Desk, Turn
from workbench.core.verdict import Outcome
from workbench.papers.drafting.questions_to_author import Answer
from workbench.papers.texts.changed_text import without_definitions

TRUE = (
    r"\mathbf{a} \times \mathbf{b} = -\mathbf{b} \times \mathbf{a}",
    r"\mathbf{a} \cdot (\mathbf{a} \times \mathbf{b}) = 0",
    r"\mathbf{c} = \mathbf{a} \times \mathbf{b}",
    r"\mathbf{c} \cdot \mathbf{a} = 0",
    r"\frac{d}{dt} (\mathbf{a} \cdot \mathbf{b}) = \dot{\mathbf{a}} \cdot \mathbf{b} + \mathbf{a} \cdot \dot{\mathbf{b}}",
    r"k = \frac{1}{2} m \mathbf{v} \cdot \mathbf{v}",
    r"\dot{k} = m \mathbf{v} \cdot \dot{\mathbf{v}}",
)
FALSE = (
    r"\mathbf{a} \times \mathbf{b} = \mathbf{b} \times \mathbf{a}",
    r"\mathbf{a} \cdot (\mathbf{a} \times \mathbf{b}) = \mathbf{a} \cdot \mathbf{b}",
    r"\mathbf{c} = \mathbf{b} \times \mathbf{a}",
    r"\mathbf{c} \cdot \mathbf{a} = 1",
    r"\frac{d}{dt} (\mathbf{a} \cdot \mathbf{b}) = \dot{\mathbf{a}} \cdot \mathbf{b} - \mathbf{a} \cdot \dot{\mathbf{b}}",
    r"k = m \mathbf{v} \cdot \mathbf{v}",
    r"\dot{k} = 3 m \mathbf{v} \cdot \dot{\mathbf{v}}",
)
OPPOSITE = {Outcome.PROVED: Outcome.REFUTED, Outcome.REFUTED: Outcome.PROVED}


def written(parts: Sequence[str]) -> str:
    return "The vectors $\\mathbf{a}$ and $\\mathbf{b}$ and the mass $m$.\n\n" + "\n".join(parts)


def display(latex: str) -> str:
    return f"Then\n$$ {latex} $$\n"


def edited(parts: list[str], chance: random.Random) -> list[str]:
    """The parts of a text after one edit: a formula changed, put in, taken out or moved, or a sentence."""
    made, at = list(parts), chance.randrange(len(parts))
    match chance.randrange(5):
        case 0 | 1:
            made[at] = display(chance.choice(TRUE + FALSE))
        case 2:
            made.insert(at, display(chance.choice(TRUE + FALSE)))
        case 3 if len(made) > 3:
            del made[at]
        case _:
            made.insert(at, "Some words.\n\nAnd more of them: ")
    return made


def marks(judged: Judged) -> dict[tuple[str, int], tuple[str, ...]]:
    """What a user sees of each claim."""
    return {
        (each.claim.id, each.claim.line): (
            each.claim.printed.latex,
            str(each.verdict.outcome),
            str(each.shown),
            str(each.verdict.reason),
            "; ".join(each.verdict.unless),
        )
        for each in judged.results
    }


def fresh(path: Path, answers: Sequence[Answer] = ()) -> Judged:
    """The verdicts of a check without a cache."""
    loaded = loaded_file(path, None, answers)
    return loaded.judged(judge_paper(loaded.paper, jobs=1, motions=False))


async def turn_of(
    desk: Desk, path: Path, before: Judged | None, answers: Sequence[Answer] = ()
) -> tuple[Turn, Judged]:
    turn = desk.turn(path)
    return turn, await turn.verdicts(path, {path: path.read_text()}, answers, before)


@pytest.fixture(autouse=True)
def own_cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("WORKBENCH_CACHE", str(tmp_path / "cache"))


def check_first(first: Judged, last: Judged, text: str) -> None:
    """First verdicts stand under their formulas, in order, and contradict no later one without a cause."""
    lines = text.split("\n")
    ids = [each.claim.id for each in first.results]
    assert len({*ids}) == len(ids)
    places = []
    for each in first.results:
        span = each.claim.context.span
        assert span is not None and span.line == span.end_line
        own = lines[span.line - 1][span.column - 1 : span.end_column - 1]
        assert "".join(own.split()) == "".join(each.claim.printed.latex.split())
        places.append((span.line, span.column))
    assert places == sorted(places)
    final = {each.claim.context.span: each.verdict.outcome for each in last.results}
    for each in first.results:
        latex = each.claim.printed.latex
        if r"\mathbf{c}" not in latex and "k" not in latex:  # whose definitions the edit may change
            assert final[each.claim.context.span] is not OPPOSITE.get(each.verdict.outcome)


@pytest.mark.parametrize("seed", range(6))
def test_marks_after_any_edits_are_those_of_a_fresh_check(seed: int, tmp_path: Path) -> None:
    chance, path = random.Random(seed), tmp_path / "paper.md"
    parts = [display(chance.choice(pair)) for pair in zip(TRUE, FALSE, strict=True)]
    desk, before, firsts = Desk(), None, 0

    async def edits() -> None:
        nonlocal parts, before, firsts
        for _ in range(5):
            path.write_text(written(parts))
            turn, judged = await turn_of(desk, path, before)
            if turn.has_standing and (first := turn.at_once()) is not None:
                firsts += 1
                check_first(first, judged, path.read_text())
            assert marks(judged) == marks(fresh(path))
            before, parts = judged, edited(parts, chance)

    asyncio.run(edits())
    desk.close()
    assert firsts


def test_first_verdicts_judge_only_what_changed(tmp_path: Path) -> None:
    path, desk = tmp_path / "paper.md", Desk()
    path.write_text(written([display(latex) for latex in TRUE]))

    async def change() -> tuple[list[Judged], Judged]:
        _, before = await turn_of(desk, path, None)
        path.write_text(written([display(FALSE[0]), *(display(latex) for latex in TRUE[1:])]))
        turn, last = await turn_of(desk, path, before)
        return turn._changed, last

    first, last = asyncio.run(change())
    desk.close()
    assert [len(each.results) for each in first] == [len(TRUE) - 1, len(TRUE)]
    assert marks(first[-1]) == marks(last)


def test_an_answer_is_judged_first_where_it_touches(tmp_path: Path) -> None:
    path, desk = tmp_path / "paper.md", Desk()
    path.write_text(written([display(latex) for latex in TRUE]))
    answer = Answer("symbols", r"'\mathbf{v}'", '"scalar"')

    async def answered() -> tuple[list[Judged], Judged]:
        _, before = await turn_of(desk, path, None)
        turn, last = await turn_of(desk, path, before, [answer])
        return turn._changed, last

    first, last = asyncio.run(answered())
    desk.close()
    assert first and len(first[0].results) >= 5, "v stands in two of seven formulas"
    assert marks(first[-1]) == marks(last) == marks(fresh(path, [answer]))


def test_definitions_of_functions_are_left_out(tmp_path: Path) -> None:
    path = tmp_path / "text.md"
    path.write_text("$$R(\\theta) = \\theta I$$\n\n$$R(\\alpha + \\beta) = R(\\alpha) + R(\\beta)$$\n")
    draft = draft_of(path)
    notation = draft.paper.claims[0].notation
    assert list(notation.definitions)
    names = {each.symbol for each in draft.ingested.definitions}
    assert not list(without_definitions(notation, names).definitions)

"""Small texts that once had a wrong verdict, each with its model and the verdicts that are right."""

from __future__ import annotations

import tomllib
from itertools import product
from pathlib import Path
from typing import Any

import pytest

from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers import load_paper

CASES = tomllib.loads((Path(__file__).parent / "known_texts.toml").read_text(encoding="utf-8"))["case"]


def outcomes(folder: Path, form: str, text: str, model: str) -> dict[str, Outcome]:
    """Returns the outcome of each claim, by its name."""
    (folder / f"x.{form}").write_text(text, encoding="utf-8")
    (folder / "x.toml").write_text(f"source = 'x.{form}'\n{model}", encoding="utf-8")
    paper = load_paper(folder / "x.toml")
    assert not paper.faults
    return {each.claim.id: each.verdict.outcome for each in judge_paper(paper, motions=False, jobs=1)}


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["name"])
def test_text_has_the_verdicts_that_are_right(case: dict[str, Any], tmp_path: Path) -> None:
    found = outcomes(tmp_path, case["form"], case["text"], case["model"])
    wanted = dict(case["want"])
    count = wanted.pop("#", [])
    assert not count or [str(len(found))] == count
    for name, allowed in wanted.items():
        steps = {
            each: outcome for each, outcome in found.items() if each == name or each.startswith(f"{name}.")
        }
        assert steps and all(outcome in allowed for outcome in steps.values()), (name, steps)


#: Letters of a symbol t that one display defines and a sentence says in other symbols.
LETTERS = [(r"\tau", "r", "F", "a", "V"), ("M", "l", "N", "k", r"\phi"), ("T", "d", r"\lambda", "c", "u")]
#: What the sentence says of it, with what follows from both.
SAID = {
    "<t> = <r> <F>": [
        "(<r> <F>) = {0}",
        "<r> <F> = {0}",
        "<F> <r> = {0}",
        "2 <r> <F> = 2 ({0})",
        "{0} = <r> <F>",
    ],
    "<t> = <r> + <F>": ["<r> + <F> = {0}", "(<r> + <F>) = {0}"],
}
BODIES = ["<a> <V> - <V>", "<a>^2 + <V>"]


def written(text: str, letters: tuple[str, ...]) -> str:
    """Returns the text with the letters in the places of its marks."""
    for mark, letter in zip("trFaV", letters, strict=True):
        text = text.replace(f"<{mark}>", f"{{{letter}}}")
    return text


@pytest.mark.parametrize(("letters", "said"), list(product(LETTERS, SAID)))
@pytest.mark.parametrize("is_true", [True, False])
def test_definition_and_sentence_give_no_wrong_verdict(
    letters: tuple[str, ...], said: str, is_true: bool, tmp_path: Path
) -> None:
    for body, follows in product(BODIES, SAID[said]):
        formula = follows.format(body if is_true else f"{body} - <V>")
        text = f"$$ <t> = {body} $$\n\nSince ${said}$,\n\n$$ {formula} $$\n"
        model = "[symbols]\n" + "\n".join(f"'{each}' = 'scalar'" for each in letters)
        found = outcomes(tmp_path, "md", written(text, letters), model)["L5"]
        wrong = (Outcome.REFUTED, Outcome.ILL_FORMED) if is_true else (Outcome.PROVED, Outcome.CONDITIONAL)
        assert found not in wrong, formula

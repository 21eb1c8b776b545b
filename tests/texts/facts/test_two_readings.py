"""A display with two readings: rows that may be joined, and equations that may be conditions."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest

from workbench.app.pipeline import judge_claims as claims_module
from workbench.app.pipeline.judge_claims import ClaimJudge
from workbench.app.pipeline.verdict_keys import Keys
from workbench.context.claims import Ambiguity, Claim, Correction, Formula
from workbench.context.read_formulas import read_statement
from workbench.core.verdict import Outcome, Verdict
from workbench.papers import load_paper

QUESTION = "A = B; -C = D or A = B - C = D?"
SYMBOLS = "\n".join(
    f"{name} = {{ kind = '{kind}', free = true }}"
    for name, kind in {**dict.fromkeys("abc", "vector"), **dict.fromkeys("fgh", "scalar")}.items()
)
#: Formulas of each verdict by itself.
BY_VERDICT = {
    "true": [r"a \times b = -b \times a", r"f g = g f"],
    "false": [r"a \times b = b \times a", r"f (g + h) = f g + h"],
    "ill-formed": ["a + f = b"],
    "unread": [r"\int f = g"],
}


@pytest.fixture(scope="module")
def template(tmp_path_factory: pytest.TempPathFactory) -> Claim:
    folder = tmp_path_factory.mktemp("readings")
    (folder / "p.md").write_text("$$ f = f + g $$\n")
    model = "[definitions]\nk = 'f + 1'\n"
    (folder / "p.toml").write_text(f"source = 'p.md'\n[symbols]\n{SYMBOLS}\n{model}")
    return load_paper(folder / "p.toml").claims[0]


def formula(latex: str, claim: Claim) -> Formula:
    if latex in BY_VERDICT["ill-formed"]:
        return Formula(latex, ill_formed="a scalar and a vector")
    if latex in BY_VERDICT["unread"]:
        return Formula(latex, unread="cannot be read")
    return Formula(latex, read_statement(latex, claim.notation, None)[0])


def judged(
    claim: Claim,
    printed: str,
    otherwise: tuple[str, ...] = (),
    perhaps: tuple[str, ...] = (),
    question: str | None = None,
) -> Verdict:
    made = replace(
        claim,
        printed=formula(printed, claim),
        ambiguity=Ambiguity(
            otherwise=tuple(formula(each, claim) for each in otherwise),
            perhaps=tuple(formula(each, claim) for each in perhaps),
            question=question,
        ),
    )
    judge = ClaimJudge([made], motions=False)
    try:
        return judge.result(made).verdict
    finally:
        judge.close()


CASES = [(kind, latex) for kind, several in BY_VERDICT.items() for latex in several]
PAIRS = list(product(CASES, CASES))


@pytest.mark.parametrize(("printed", "other"), PAIRS, ids=lambda each: each[1])
def test_a_verdict_holds_in_both_readings(
    template: Claim, printed: tuple[str, str], other: tuple[str, str]
) -> None:
    verdict = judged(template, printed[1], (other[1],), question=QUESTION)
    kinds = {printed[0], other[0]}
    if kinds == {"true"}:
        assert verdict.outcome is Outcome.PROVED
        assert any(each.method == "two readings" for each in verdict.evidence)
    elif kinds <= {"false", "ill-formed"}:
        alone = judged(template, printed[1])
        assert (verdict.outcome, verdict.counterexample) == (alone.outcome, alone.counterexample)
    else:
        assert verdict.outcome is Outcome.UNCHECKED and verdict.reason == QUESTION


@pytest.mark.parametrize(
    ("printed", "otherwise", "expected"),
    [
        ("true", ("true", "true"), Outcome.PROVED),
        ("true", ("true", "false"), Outcome.UNCHECKED),
        ("true", ("true", "unread"), Outcome.UNCHECKED),
        ("false", ("true", "false"), Outcome.REFUTED),
        ("false", ("unread", "ill-formed"), Outcome.REFUTED),
        ("false", ("true", "true"), Outcome.UNCHECKED),
        ("false", (), Outcome.UNCHECKED),
        ("true", (), Outcome.UNCHECKED),
    ],
)
def test_several_other_formulas_are_one_reading(
    template: Claim, printed: str, otherwise: tuple[str, ...], expected: Outcome
) -> None:
    others = tuple(BY_VERDICT[kind][0] for kind in otherwise)
    assert judged(template, BY_VERDICT[printed][0], others, question=QUESTION).outcome is expected


def test_a_definition_of_either_reading_counts_as_true(template: Claim) -> None:
    assert judged(template, "k = f + 1", ("f g = g f",), question=QUESTION).outcome is Outcome.DEFINITION
    assert judged(template, "f g = g f", ("k = f + 1",), question=QUESTION).outcome is Outcome.PROVED


#: A false formula, an equation beside it, and the verdict on both together.
CONDITIONS = [
    (r"(a + b)^2 = a^2 + b^2", (r"a \cdot b = 0",), "conditional"),
    (r"a \times b = 0", ("a = f b",), "conditional"),
    (r"a \times b = 0", ("g = h", "a = f b"), "conditional"),
    (r"f (g + h) = f g", ("h = 0",), "conditional"),
    (r"\dot{f} = 0", ("f = 1",), "conditional"),
    (r"f = g", ("f = h", "g = h"), "conditional"),
    (r"(a + b)^2 = a^2 + b^2", (r"a \cdot a = 0",), "unchecked"),
    (r"(a + b)^2 = a^2 - b^2", (r"a \cdot b = 0",), "refuted"),
    (r"a \times b = b \times a", ("g = h",), "refuted"),
    (r"a \times b = b \times a", ("f = g + h", "c = f a"), "refuted"),
    (r"a \times b = b \times a", ("g = g + 1",), "unchecked"),
    (r"f g = f + g", ("k = f + 2",), "unchecked"),
    (r"f (g + h) = f g + h", (r"\int f = g",), "unchecked"),
    (r"f g = g f", (r"g = g + 1",), "proved"),
    (r"f g = g f", (r"\int f = g",), "proved"),
]


@pytest.mark.parametrize(("printed", "beside", "expected"), CONDITIONS)
def test_equations_beside_matter_where_it_is_false(
    template: Claim, printed: str, beside: tuple[str, ...], expected: str
) -> None:
    for order in (beside, beside[::-1]):
        verdict = judged(template, printed, perhaps=order)
        assert verdict.outcome == expected
        if expected == "conditional":
            assert str(verdict.hypothesis) in (*beside, ", ".join(order))
            assert f"holds if {verdict.hypothesis}, which stands beside it" in verdict.reason
            assert verdict.counterexample is not None
            assert any("witness against" in each.method for each in verdict.evidence)
        if expected == "unchecked":
            assert ", ".join(order) in verdict.reason


def test_the_least_condition_beside_is_named(template: Claim) -> None:
    found = judged(template, r"a \times b = 0", perhaps=("g = h", "a = f b"))
    assert str(found.hypothesis) == "a = f b"


@pytest.mark.parametrize(("printed", "beside", "expected"), [c for c in CONDITIONS if c[2] == "refuted"])
def test_a_counterexample_meets_what_stands_beside(
    template: Claim, printed: str, beside: tuple[str, ...], expected: str
) -> None:
    against = judged(template, printed, perhaps=beside).counterexample
    point = [
        Formula("", read_statement(f"{n} = {value(v)}", template.notation, None, True)[0])
        for n, v in against.values.items()
    ]
    for condition in beside:
        known = replace(template, printed=formula(condition, template), assume=tuple(point))
        judge = ClaimJudge([known], motions=False)
        assert judge.result(known).verdict.outcome is Outcome.PROVED
        judge.close()


def value(entries: tuple[str, ...]) -> str:
    return entries[0] if len(entries) == 1 else r"\begin{bmatrix}" + r"\\".join(entries) + r"\end{bmatrix}"


@pytest.mark.parametrize(("printed", "beside", "expected"), [c for c in CONDITIONS if c[2] == "conditional"])
def test_a_conditional_is_proved_under_its_hypothesis(
    template: Claim, printed: str, beside: tuple[str, ...], expected: str
) -> None:
    hypothesis = judged(template, printed, perhaps=beside).hypothesis
    needed = tuple(formula(each, template) for each in beside if each in str(hypothesis))
    assumed = replace(template, printed=formula(printed, template)).with_context(given=needed)
    judge = ClaimJudge([assumed], motions=False)
    assert judge.result(assumed).verdict.outcome is Outcome.PROVED
    judge.close()


@pytest.mark.parametrize(
    ("printed", "beside", "meets"),
    [
        (r"f g = f + g", r"g (f - f) = 0", True),
        (r"f = f + g", r"f g = f + g", False),
        (r"a \times b = b \times a", r"a \cdot (b \times b) = 0", True),
        (r"a \times b = b \times a", r"a = b", False),
        (r"\dot{f} = 1", r"f - f = 0", True),
    ],
)
def test_a_witness_that_meets_an_undecided_condition_stands(
    template: Claim, monkeypatch: pytest.MonkeyPatch, printed: str, beside: str, meets: bool
) -> None:
    decided = claims_module.judged_alone

    def undecided(claim: Claim, *how: object) -> Verdict:
        is_asked = claim.printed.latex == printed
        return Verdict(Outcome.UNCHECKED) if is_asked else decided(claim, *how)

    monkeypatch.setattr(claims_module, "judged_alone", undecided)
    expected = Outcome.REFUTED if meets else Outcome.UNCHECKED
    assert judged(template, printed, perhaps=(beside,)).outcome is expected


def test_a_correction_leaves_no_condition_beside(template: Claim) -> None:
    claim = replace(template, correction=Correction(corrected=formula(r"f g = g f", template)))
    assert judged(claim, r"f (g + h) = f g", perhaps=("h = 0",)).outcome is Outcome.REFUTED
    alone = template.with_context(alone=True)
    assert judged(alone, r"f (g + h) = f g", perhaps=("h = 0",)).outcome is Outcome.REFUTED


@pytest.mark.parametrize(
    "change",
    [
        {"perhaps": (Formula("g = h"),)},
        {"otherwise": (Formula("g = h"),)},
        {"question": QUESTION},
    ],
)
def test_the_memory_tells_readings_apart(template: Claim, change: dict) -> None:
    keys = Keys({}, {})
    changed = replace(template, ambiguity=Ambiguity(**change))
    assert keys.of(template, "printed") != keys.of(changed, "printed")

"""Laws of contexts on generated texts: renaming, irrelevance, monotonicity, scope, export."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from pathlib import Path

import pytest
from hypothesis import HealthCheck, Phase, example, given, settings
from hypothesis import strategies as st

from tests.context import generated_texts as texts
from tests.context.generated_texts import GREEK, PLAIN, SPOKEN, Piece, model_of, verdicts_on
from tests.context.judged_texts import seen
from workbench.core.verdict import Outcome, Verdict

FEW, MANY = 1, 300
CAMPAIGN = [FEW, pytest.param(MANY, marks=pytest.mark.slow)]
#: Of the words for a convention that letters, accents or typefaces tell.
BY_LETTERS = re.compile(r"letter says|hat says|the length of|a component of|cosine and sine|axes of a frame")
FALSE = (Outcome.REFUTED, Outcome.ILL_FORMED)


def for_all(
    number: int, *strategies: st.SearchStrategy, first: Sequence[Sequence[object]] = ()
) -> Callable[[Callable], None]:
    """Runs a law on so many generated cases. first: cases that are run always, before them."""

    def run(law: Callable) -> None:
        phases = (Phase.explicit, Phase.generate)  # a case has a few short pieces
        tried = given(*strategies)(law)
        for case in first:
            tried = example(*case)(tried)
        settings(max_examples=number, phases=phases, suppress_health_check=list(HealthCheck))(tried)()

    return run


def placeless(verdict: Verdict) -> tuple[str, ...]:
    """Returns what a verdict says, without the lines that it names."""
    said = (*map(str, seen(verdict)), str(verdict.counterexample))
    return tuple(re.sub(r"\bline \d+|\bL\d+'*", "…", each) for each in said)


def judgement(verdict: Verdict) -> tuple[object, ...]:
    """Returns what a verdict says, without the names of symbols."""
    return verdict.outcome, verdict.grade, verdict.basis, verdict.code, bool(verdict.unless)


def names_letters(verdict: Verdict) -> bool:
    """Returns whether a verdict names a convention about letters."""
    return bool(BY_LETTERS.search(" ".join(map(str, (verdict.reason, *verdict.unless)))))


@pytest.mark.parametrize("number", CAMPAIGN)
def test_renaming_changes_nothing_without_conventions(tmp_path: Path, number: int) -> None:
    @for_all(number, texts.texts, st.sampled_from([GREEK, SPOKEN]), first=[(texts.WHOLE, SPOKEN)])
    def law(pieces: Sequence[Piece], letters: dict[str, str]) -> None:
        plain = verdicts_on(tmp_path, pieces, model_of(conventions=False))
        other = verdicts_on(tmp_path, pieces, model_of(letters, conventions=False), letters)
        assert list(map(judgement, plain)) == list(map(judgement, other))


@pytest.mark.parametrize("number", CAMPAIGN)
def test_verdict_that_renaming_changes_names_convention(tmp_path: Path, number: int) -> None:
    @for_all(number, texts.texts, st.sampled_from([GREEK, SPOKEN]), first=[(texts.WHOLE, SPOKEN)])
    def law(pieces: Sequence[Piece], letters: dict[str, str]) -> None:
        plain = verdicts_on(tmp_path, pieces, model_of())
        other = verdicts_on(tmp_path, pieces, model_of(letters), letters)
        for one, two in zip(plain, other, strict=True):
            is_named = names_letters(one) or names_letters(two)
            assert is_named or judgement(one) == judgement(two)


#: They speak of symbols that no generated text has.
UNRELATED = (
    Piece("The vector $u$ is a unit vector, and $k$ is small."),
    Piece("Suppose that $u \\cdot v = 0$ and $k > 0$."),
    Piece("We define", "v := 3 k u"),
    Piece("The law of motion is", r"\ddot{k} = -4 k"),
    Piece("It is required that", r"u \cdot u = 1"),
    Piece("Hence", r"k + k = 3 k"),
    Piece("In general the number $k$ is constant and no term vanishes."),
)
OTHERS = """'u' = "vector"
'v' = "vector"
'k' = { kind = "scalar", positive = true }
'S' = "tensor"
"""
#: A definition, a condition on another claim, a scope behind the text.
MORE = ("", "'S' = 'k u u^T'\n", "[[scope]]\nfrom = 'Last'\nsymbols = { 'k' = 'vector' }\n")
LAST = Piece("# Last\n\nWe have", "h = h")


@pytest.mark.parametrize("number", CAMPAIGN)
def test_what_speaks_of_no_symbol_changes_nothing(tmp_path: Path, number: int) -> None:
    every = [(piece, at % 4) for at, piece in enumerate(UNRELATED)]
    more = st.lists(st.tuples(st.sampled_from(UNRELATED), st.integers(0, 5)), min_size=1, max_size=2)

    @for_all(number, texts.texts, more, st.sampled_from(MORE), first=[(texts.WHOLE, every, MORE[1])])
    def law(pieces: list[Piece], unrelated: list[tuple[Piece, int]], declared: str) -> None:
        plain = verdicts_on(tmp_path, [*pieces, LAST], model_of())
        both = [*pieces]
        for piece, at in unrelated:
            both.insert(at, piece)
        found = verdicts_on(tmp_path, [*both, LAST], model_of(extra=OTHERS, more=declared))
        displays = [piece for piece in [*both, LAST] if piece.display]
        own = [v for piece, v in zip(displays, found, strict=True) if piece not in UNRELATED]
        assert list(map(placeless, own)) == list(map(placeless, plain))


#: What may be known more of the symbols, in the model or in a sentence; all of it holds together.
FLAGS = {"n": "unit = true", "m": "constant = true", "R": "constant = true", "T": "symmetric = true"}
ASSUMED = ("<a> \\cdot <b> = 0", "<g> = 1", "<h> \\neq 0", "<n> \\cdot <n> = 1")


@pytest.mark.parametrize("number", CAMPAIGN)
def test_one_more_fact_unproves_and_refutes_nothing(tmp_path: Path, number: int) -> None:
    flag = st.sampled_from(sorted(FLAGS))
    facts = st.one_of(flag, st.sampled_from(texts.SENTENCES), st.sampled_from(ASSUMED), st.just(""))

    @for_all(number, texts.texts, facts, st.integers(0, 4), first=[(texts.WHOLE, "", 0)])
    def law(pieces: list[Piece], fact: str, at: int) -> None:
        before = verdicts_on(tmp_path, pieces, model_of())
        with_it, flags, more = [*pieces], {}, ""
        displays = [place for place, piece in enumerate(pieces) if piece.display]
        at = displays[at % len(displays)]
        if fact in FLAGS:
            flags = {fact: FLAGS[fact]}
        elif fact in texts.SENTENCES:
            with_it.insert(0, Piece(fact))
        elif fact in ASSUMED:
            line = texts.text_of(pieces[:at]).count("\n") + 4 + (at > 0)
            more = f"[[claim]]\nat = 'line {line}'\nassume = ['{texts.lettered(fact, PLAIN)}']\n"
        else:  # a condition before each claim that has none
            words = iter(texts.CONDITIONS * len(pieces))
            with_it = [Piece(next(words), p.display) if p.words == "We have" else p for p in pieces]
        after = verdicts_on(tmp_path, with_it, model_of(flags=flags, more=more))
        for one, two in zip(before, after, strict=True):
            assert one.outcome is not Outcome.PROVED or two.outcome is Outcome.PROVED
            if one.outcome in (Outcome.CONDITIONAL, Outcome.UNCHECKED):
                assert two.outcome not in FALSE


def _scopes(count: int) -> str:
    symbols = ", ".join(f"'{mark}' = '{kind}'" for mark, kind in texts.KINDS.items())
    own = f"symbols = {{ {symbols} }}\ndefinitions = {{ {texts.lettered(texts.DEFINED, PLAIN)} }}\n"
    return "".join(f"[[scope]]\nfrom = 'S{n}'\n{own}" for n in range(1, count))


@pytest.mark.parametrize("number", CAMPAIGN)
def test_one_scope_says_nothing_of_another(tmp_path: Path, number: int) -> None:
    parts = st.lists(texts.texts, min_size=2, max_size=3)

    @for_all(
        number, parts, first=[([texts.WHOLE, texts.WHOLE[7:8]],), ([texts.SUPPOSING, texts.WHOLE[4:8]],)]
    )
    def law(parts: list[list[Piece]]) -> None:
        def judged(chosen: list[list[Piece]]) -> list[list[Verdict]]:
            whole = [piece for n, part in enumerate(chosen) for piece in (Piece(f"# S{n}\n\nWords."), *part)]
            found = iter(verdicts_on(tmp_path, whole, model_of(more=_scopes(len(parts)))))
            return [[next(found) for piece in part if piece.display] for part in chosen]

        together = judged(parts)
        for at, part in enumerate(parts):
            alone = judged([part if n == at else [Piece("We have", "h = h")] for n in range(len(parts))])
            assert list(map(placeless, alone[at])) == list(map(placeless, together[at]))


#: By words in a hypothesis: the symbol that it is about, and what the model says instead.
DECLARED = {"unit": "n", "constant": "m", "symmetric": "T", "positive": "m"}
#: Claims that hold by one fact, and the fact: a display, a sentence, the words before the claim, or a hint.
BY_FACTS = (
    ((texts.FORMULAS[0],), r"<x> <a> + <x> <a> = 3 <f> <a> + <f> <a>"),
    ((texts.FORMULAS[3],), r"<f> (<a> \cdot <b>) + <f> <g> = <f> <g>"),
    ((texts.FORMULAS[2],), r"<m> <m> \ddot{<f>} + <f> = <f> - <m> <g> <f>"),
    ((Piece(texts.SENTENCES[0]),), r"(<n> \cdot <n>) <f> = <f>"),
    ((Piece(texts.SENTENCES[1]),), r"\frac{d}{dt} (<m> <f>) = <m> \dot{<f>}"),
    ((Piece(texts.SENTENCES[2]),), r"<a> \cdot (<T> <b>) = <b> \cdot (<T> <a>)"),
    ((), r"\sqrt{<m>^2} <a> = <m> <a>"),
    ((), r"\dot{<p>} = <m> \dot{<f>}"),
)


@pytest.mark.parametrize("number", CAMPAIGN)
def test_conditional_claim_is_proved_with_its_hypothesis(tmp_path: Path, number: int) -> None:
    more = st.lists(texts.facts, max_size=2)
    every = [(by, [], 2) for by in BY_FACTS]

    @for_all(number, st.sampled_from(BY_FACTS), more, st.sampled_from([2, 3]), first=every)
    def law(by: tuple[tuple[Piece, ...], str], more: list[Piece], factor: int) -> None:
        facts, formula = by
        left, right = formula.split(" = ")
        claim = Piece("We have", f"{factor} ({left}) = {factor} ({right})")
        *_, held = verdicts_on(tmp_path, [*more, *facts, claim], model_of())
        assert held.outcome is Outcome.CONDITIONAL and held.counterexample is not None
        flags, assumed = {}, []
        for said in str(held.hypothesis or "").split(", "):
            word = next((each for each in DECLARED if each in said), None)
            if said.startswith(("as ", "beside ")):
                continue  # why a convention is
            if word is None:
                assumed.append(said)
            else:
                flags[DECLARED[word]] = f"{word} = true"
        key = "given" if any("ddot" in each for each in assumed) else "assume"
        if key == "given":
            with_law = [texts.FORMULAS[2], claim]
            more_of = "[[claim]]\nat = 'line 9'\ngiven = ['line 4']\n"
        else:
            with_law = [claim]
            listed = ", ".join(f"'{each}'" for each in assumed)
            more_of = f"[[claim]]\nat = 'line 4'\nassume = [{listed}]\n" if assumed else ""
        *_, proved = verdicts_on(tmp_path, with_law, model_of(flags=flags, more=more_of))
        assert proved.outcome is Outcome.PROVED, (held.hypothesis, proved)
        *_, bare = verdicts_on(tmp_path, [claim], model_of(more="[[claim]]\nat = 'line 4'\ngiven = []\n"))
        assert bare.outcome is Outcome.REFUTED and bare.counterexample is not None

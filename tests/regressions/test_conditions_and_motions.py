"""Wrong verdicts that were once given, and the classes that they are members of."""

from contextlib import suppress
from itertools import permutations
from pathlib import Path

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.formula_errors import ReadError
from workbench.core.verdict import EngineDisagreement, Outcome
from workbench.papers import load_paper
from workbench.prover.decide.decide import Judge

PAPERS = Path(__file__).parent / "papers"
SYMBOLS = {
    **dict.fromkeys(("a", "b", "x", "a_n", "v_n"), "vector"),
    **dict.fromkeys(("f", "g", "d", r"\alpha", "s_n", "k_{m,n}"), "scalar"),
    **dict.fromkeys(("T", "T_n"), "tensor"),
    **dict.fromkeys(("R", "R_1", "R_2"), "rotation"),
    r"\rho": {"kind": "vector", "coordinate": True},
    "c": {"kind": "vector", "uniform": True},
    r"\underline{a}": "dual vector",
}


def verdict(latex, definitions=(), orders=None, assume=()):
    return check(latex, SYMBOLS, definitions=definitions, orders=orders, assume=assume).verdict


class TestDefinitions:
    """They define the members that they say, and no others."""

    PATTERNS = tuple(permutations(("a_n", "a_{n+1}", "a_{n+2}", "a_{n+4}"), 2))
    ROWS = ("m,n", "m+1,n", "m,n+2", "m+1,n+1", "0,n", "2,n", "m,0", "m,3", "m+3,3")

    @pytest.mark.parametrize(("one", "other"), PATTERNS)
    def test_a_member_that_two_patterns_define_is_refused(self, one, other):
        with pytest.raises(ValueError, match=r"defines a_\{?\d\}?, and so does"):
            verdict("f g = g f", [f"{one} = x", f"{other} = b"])

    @pytest.mark.parametrize(("one", "other"), list(permutations(ROWS, 2)))
    def test_rows_are_refused_where_they_meet_and_only_there(self, one, other):
        definitions = [f"k_{{{one}}} = f", f"k_{{{other}}} = g"]
        apart = any(
            (_least(p) > _least(q) and q.isdigit()) or (_least(q) > _least(p) and p.isdigit())
            for p, q in zip(one.split(","), other.split(","), strict=True)
        )
        if apart:
            assert verdict("f g + f = f + g f", definitions).outcome == Outcome.PROVED
            return
        with pytest.raises(ValueError, match="so does"):
            verdict("f g = g f", definitions)

    def test_a_recurrence_that_never_ends_is_refused(self):
        with pytest.raises(ValueError, match="uses the symbol itself"):
            verdict("s_0 = s_0 + 0", ["s_{n+1} = s_3 + s_n"])

    def test_a_disagreement_stops_no_other_claim(self, monkeypatch):
        judge = Judge.judge

        def disagree(self, statement, *arguments, **options):
            if options.get("orders") is not None:
                raise EngineDisagreement("on purpose")
            return judge(self, statement, *arguments, **options)

        monkeypatch.setattr(Judge, "judge", disagree)
        first, second = judge_paper(load_paper(PAPERS / "crash.toml"))
        assert first.passed and not second.passed
        assert second.verdict.outcome == Outcome.UNCHECKED and "on purpose" in second.verdict.reason


def _least(place):
    return int(place) if place.isdigit() else int(place.partition("+")[2] or 0)


class TestWorstMember:
    @pytest.mark.parametrize("bad", range(5))
    def test_one_bad_member_at_any_place(self, bad):
        definitions = [f"s_{n} = {'f' if n != bad else 'f + g'}" for n in range(5)]
        assert verdict("s_n g = g f", definitions, "n = 0..4").outcome == Outcome.REFUTED
        inverse = [f"s_{n} = {'2' if n != bad else 'f'}" for n in range(5)]
        assert verdict(r"\frac{s_n}{s_n} g = g", inverse, "n = 0..4").outcome == Outcome.CONDITIONAL

    def test_hypotheses(self):
        outcomes = [str(r.verdict.outcome) for r in judge_paper(load_paper(PAPERS / "hyp.toml"))]
        assert outcomes == [*["conditional"] * 5, "refuted", "conditional"]
        (only,) = judge_paper(load_paper(PAPERS / "hyp2.toml"))
        assert only.verdict.outcome == Outcome.CONDITIONAL


class TestConditions:
    WORDS = ("for", "where", "with", "if", "when", "provided", "provided that", "assuming", "such that")

    @pytest.mark.parametrize("word", [*WORDS, "for all"])
    def test_words(self, word):
        for comma in ("", ","):
            held = rf"\frac{{f}}{{f}} = 1{comma} \text{{ {word} }} f \neq 0"
            assert verdict(held).outcome == Outcome.PROVED
            false = rf"f g = g{comma} \text{{ {word} }} f \neq 0"
            assert verdict(false).outcome == Outcome.REFUTED

    PREMISES = (
        (r"f = 0", r"f g = 0", r"f g = g"),
        (r"f \neq 0", r"\frac{f}{f} = 1", r"f g = 1"),
        (r"a = \mathbf{0}", r"a \times b = \mathbf{0}", r"a \times b = x"),
        (r"f = 0 \text{ and } g = 0", r"f + g = 0", r"f + g = 1"),
        (r"f = g", r"f^2 = g^2", r"f^2 = g"),
    )

    WORDS = ("if", "If", "when", "When", "given", "Given that", "provided", "Where")
    THEN = (r"\text{ then }", r", \text{ then } ", r", \text{then }\,")

    @pytest.mark.parametrize("word", WORDS)
    @pytest.mark.parametrize(("premise", "follows", "not_so"), PREMISES)
    def test_a_condition_in_front_is_a_premise(self, word, premise, follows, not_so):
        then = self.THEN[(self.WORDS.index(word) + len(premise)) % 3]
        front = rf"\text{{{word} }} {premise} {then}"
        proved = verdict(front + follows)
        assert proved.outcome == Outcome.PROVED
        assert verdict(front + not_so).outcome == Outcome.REFUTED
        assert verdict(proved.read_back).outcome == Outcome.PROVED
        both = rf"\text{{{word} }} {premise} \text{{ then }} {follows} \text{{ and }} {not_so}"
        assert verdict(both).outcome == Outcome.REFUTED

    @pytest.mark.parametrize(("premise", "follows", "not_so"), PREMISES)
    def test_a_condition_without_then_is_a_premise(self, premise, follows, not_so):
        for conclusion, outcome in ((follows, Outcome.PROVED), (not_so, Outcome.REFUTED)):
            assert verdict(rf"\text{{if }} {premise}, {conclusion}").outcome == outcome
        below = rf" \\ \text{{where }} {premise}"  # the condition of the row before it, or asked about
        for latex, outcome in ((follows + below, Outcome.PROVED), (not_so + below, Outcome.REFUTED)):
            with suppress(ReadError):
                assert verdict(latex).outcome == outcome
        with pytest.raises(ReadError, match="how far does the condition in front reach"):
            check(rf"\text{{if }} {premise} \text{{ then }} {follows}, {not_so}", SYMBOLS)
        for latex in (rf"\text{{then }} {follows}", rf"{premise} \text{{ then }} {follows}"):
            with pytest.raises(ReadError, match="unexpected then"):
                check(latex, SYMBOLS)


class TestReadings:
    @pytest.mark.parametrize(
        "latex", [r"(\dot{T})^{-1} = -T", r"(R_1)^2 = R_2", r"\frac{d}{dt} T^{-1} = T", r"T^2 = R^2"]
    )
    def test_bracketed_formulas_read_back(self, latex):
        found = verdict(latex)
        assert found.outcome == Outcome.REFUTED
        assert verdict(found.read_back).read_back == found.read_back


class TestMotion:
    def outcomes(self, name):
        return {r.claim.id: r.verdict.outcome for r in judge_paper(load_paper(PAPERS / f"{name}.toml"))}

    def test_a_bound_rotation_has_the_bound_angular_velocity(self):
        assert self.outcomes("motion2")["2"] == Outcome.PROVED
        assert self.outcomes("motion")["2"] == Outcome.REFUTED  # there R is any rotation

    @pytest.mark.parametrize(
        "printed",
        [
            r"{0} \Rightarrow {1}",
            r"{0} \text{{ and }} v = \mathbf{{0}} \Rightarrow {1}",
            r"{1} \text{{ for }} {0}",
            r"\text{{if }} {0} \text{{ then }} {1}",
            r"{0} \Leftrightarrow 2 {0}",
        ],
    )
    def test_a_premise_that_the_motions_never_meet_is_no_test(self, tmp_path, printed):
        """ω is never 0 on the motions: they neither veto nor support what is said of that."""
        text = """title = "x"
[symbols]
'\\omega' = { kind = "vector", weight = 1 }
'v' = { kind = "vector", weight = 1 }
[motion]
'\\omega' = "w_WB"
'v' = "v_WB0"
"""
        formula = printed.format(r"\omega = \mathbf{0}", r"\omega \times v = \mathbf{0}")
        (tmp_path / "p.toml").write_text(f"{text}[[claim]]\nid = '1'\nprinted = '{formula}'\n")
        (result,) = judge_paper(load_paper(tmp_path / "p.toml"))
        assert result.verdict.outcome == Outcome.PROVED
        assert not any(e.method == "Drake reference motions" for e in result.verdict.evidence)
        assert "met what it supposes" in result.verdict.no_motion

    def test_claims_that_hold_on_motions_are_not_refuted(self, tmp_path):
        text = """title = "x"
[symbols]
'\\omega' = { kind = "vector", weight = 1 }
'v' = { kind = "vector", weight = 1 }
'\\rho' = { kind = "vector", weight = 0 }
[motion]
'\\omega' = "w_WB"
'v' = "v_WB0"
'\\rho' = "p_WP"
[[claim]]
id = "1"
printed = '\\dot{\\rho} = v + \\omega \\times \\rho'
[[claim]]
id = "2"
printed = '\\dot{\\rho} = v - \\omega \\times \\rho'
"""
        (tmp_path / "p.toml").write_text(text)
        true, false = judge_paper(load_paper(tmp_path / "p.toml"))
        assert true.verdict.outcome == Outcome.UNCHECKED and "tied" in true.verdict.reason
        assert false.verdict.outcome == Outcome.REFUTED

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

    @pytest.mark.parametrize(
        ("definitions", "latex"),
        [
            ([r"a_{n+1} = b \times x"], r"a_0 \cdot b = 0"),
            (["a_{n+1} = x"], "a_0 = x"),
            (["s_{n+2} = n f"], "s_0 + f = -2 f + f"),
            (["s_{n+2} = n f"], "s_1 = -f"),
            (["s_{n+1} = f s_n"], "s_0 = 1"),
            (["s_1 = 2", "s_{n+2} = f s_{n+1}"], "s_0 = 2"),
            (["k_{m+1,n} = f"], "k_{0,3} = f"),
            (["k_{m,n+1} = f k_{m,n}"], "k_{2,0} = f"),
            (["k_{m+1,n+1} = f k_{m,n}"], "k_{0,0} = k_{1,0}"),
        ],
    )
    def test_a_declared_member_that_none_reaches_stays_free(self, definitions, latex):
        assert verdict(latex, definitions).outcome == Outcome.REFUTED

    @pytest.mark.parametrize(
        ("definitions", "latex", "orders"),
        [
            (["s_0 = 2", "s_{n+1} = 1"], "s_n f = f", "n = 1..3"),
            (["a_0 = b", "a_{n+1} = x^{(n)}"], r"\dot{a}_n = a_{n+1}", "n = 1..3"),
            (["a_{n+1} = x"], "a_n + b = b + x", "n = 1..3"),
            (["s_0 = 2", "s_1 = 1", "s_{n+1} = s_n"], "f s_{n+1} = s_n f", "n = 1..3"),
        ],
    )
    def test_all_n_never_holds_by_a_member_apart_or_not_defined(self, definitions, latex, orders):
        """Behind it, it may hold for all n."""
        within = verdict(latex, definitions, orders)
        assert within.outcome == Outcome.PROVED and within.scope in (orders, "all n ≥ 1")
        assert verdict(latex, definitions, "n = 0..3").outcome == Outcome.REFUTED

    def test_claims_of_every_member_hold_for_all_n(self):
        found = verdict(r"\dot{s}_{n+1} = f \dot{s}_n + \dot{f} s_n", ["s_{n+1} = f s_n"], "n = 0..3")
        assert (found.outcome, found.scope) == (Outcome.PROVED, "all n")

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

    def test_a_single_member_may_be_defined_apart(self):
        for definitions in (["a_0 = b", "a_n = x"], ["a_n = x", "a_0 = b"], ["a_1 = b", "a_{n+1} = x"]):
            first = "a_1" if "a_1 = b" in definitions else "a_0"
            assert verdict(f"{first} + x = x + b", definitions).outcome == Outcome.PROVED
            assert verdict("a_3 + b = x + b", definitions).outcome == Outcome.PROVED

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
    @pytest.mark.parametrize(
        ("definitions", "latex", "orders"),
        [
            (["s_0 = 1", "s_{n+1} = f s_n"], r"\frac{s_n}{s_n} = 1", "n = 0..2"),
            (["s_0 = 1", r"s_{n+1} = \frac{s_n}{f}"], "s_n f^n = 1", "n = 0..3"),
            ([], r"\sum_{k=1}^{n-1} T T^{-1} + \mathbf{I} = n \mathbf{I}", "n = 1..3"),
            ([r"T_0 = \mathbf{I}", "T_{n+1} = T T_n"], r"T_n^{-1} T_n = \mathbf{I}", "n = 0..2"),
        ],
    )
    def test_a_denominator_of_a_later_member(self, definitions, latex, orders):
        assert verdict(latex, definitions, orders).outcome == Outcome.CONDITIONAL

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

    @pytest.mark.parametrize(
        "latex",
        [
            r"\frac{f}{f} = 1, f \neq 0",
            r"f \neq 0, \frac{f}{f} = 1",
            r"a \times b = 0 \text{ for } b = 0",
            r"f = 0 \text{ and } g = 0 \Rightarrow f + g = 0",
            r"f + g = 0 \text{ if } f = 0 \text{ and } g = 0",
            r"f + g = 0 \text{ if } f = 0, g = 0",
            r"\frac{f g}{f} = g, \frac{f f}{f} = f, f \neq 0",
            r"\frac{f g}{f g} = 1, f \neq 0, g \neq 0",
            r"\begin{aligned} \frac{f}{f} &= 1 \\ \frac{g}{f} f &= g \end{aligned}, f \neq 0",
        ],
    )
    def test_premises(self, latex):
        found = check(latex, SYMBOLS)
        assert all(one.outcome == Outcome.PROVED for one in (found if isinstance(found, tuple) else [found]))

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

    @pytest.mark.parametrize(
        ("latex", "message"),
        [
            (r"f g = g f, f \neq 0, g = g + 0", "a condition of what is before it, or of what follows"),
            (r"f = 0, g = 0 \Rightarrow f + g = 0", "how far does the implication reach"),
            (
                r"f g = g f \text{ for } f = 0 \Rightarrow g = 0",
                "a condition is an equation or an inequation",
            ),
            (r"T^T T = \mathbf{I}, T \in \mathbf{SO}_3", "a rotation; here it is a tensor"),
            (r"f \in \mathbf{SO}_3, f g = g f", "a rotation; here it is a scalar"),
            (r"f \in \mathbb{R}^3, f g = g f", "a vector; here it is a scalar"),
            (
                r"\underline{a} \times \underline{a} = 0, \underline{a} \in \mathbf{V}_3",
                "it is a dual vector",
            ),
            (r"f \in \mathbb{Q}, f g = g f", "is not known here"),
        ],
    )
    def test_refused(self, latex, message):
        with pytest.raises(ReadError, match=message):
            check(latex, SYMBOLS)

    @pytest.mark.parametrize(
        "latex", [r"R^T R = \mathbf{I}, R \in SO(3)", r"f g = g f, \forall f, g \in \mathbb{R}"]
    )
    def test_members_as_declared(self, latex):
        assert verdict(latex).outcome == Outcome.PROVED

    def test_a_condition_that_lasts_has_to_be_said(self):
        open_ = verdict(r"\dot{f} = 0 \text{ where } f = 1")
        assert open_.outcome == Outcome.UNCHECKED and "at one instant only" in open_.reason
        said = r"\text{ where } f = 1 \text{ and } \dot{f} = 0"
        assert verdict(rf"\dot{{f}} g = f - 1 {said}").outcome == Outcome.PROVED
        assert verdict(rf"\dot{{f}} = 0 {said}").outcome == Outcome.UNCHECKED
        assert verdict(r"\dot{f} = g \text{ where } f = 1").outcome == Outcome.REFUTED


class TestReadings:
    @pytest.mark.parametrize(
        ("latex", "message"),
        [
            (r"\frac{d f}{d g} = \frac{f}{g}", "derivative by anything but the time"),
            (r"\frac{d^2 f}{d g^2} = f", "derivative by anything but the time"),
            (r"\dot{T}^{-1} T = \mathbf{I}", "the derivative of the inverse"),
            (r"\dot{T}^{*} = T", "the derivative of the adjugate"),
            (r"R_1^0 = R_2^0", "the label of a frame"),
            (r"R_1^2 = R_2^2", "the label of a frame"),
            (r"[a, b, x] = 0", "3 expressions between brackets"),
        ],
    )
    def test_refused(self, latex, message):
        with pytest.raises(ReadError, match=message):
            check(latex, SYMBOLS)

    @pytest.mark.parametrize(
        "latex", [r"(\dot{T})^{-1} = -T", r"(R_1)^2 = R_2", r"\frac{d}{dt} T^{-1} = T", r"T^2 = R^2"]
    )
    def test_bracketed_formulas_read_back(self, latex):
        found = verdict(latex)
        assert found.outcome == Outcome.REFUTED
        assert verdict(found.read_back).read_back == found.read_back

    def test_nothing_is_constant_in_space_unless_it_is_said(self):
        asked = verdict(r"\operatorname{div} (f \rho) = 3 f")
        assert asked.outcome == Outcome.UNCHECKED and "uniform = true" in asked.reason
        assert verdict(r"\operatorname{curl} (c \times \rho) = 2 c").outcome == Outcome.PROVED


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

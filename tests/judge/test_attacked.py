r"""Classes of statements of which the judge once said what is not so, with members of each."""

import pytest

from workbench import check
from workbench.judge.verdict import Outcome
from workbench.papers import PaperError, load_paper
from workbench.verify.claims import judge_paper

F = {"f": "scalar", "s_n": "scalar"}


def paper(tmp_path, symbols, *printed, head=""):
    claims = (f"[[claim]]\nid = 'c{n}'\nprinted = '''{text}'''\n" for n, text in enumerate(printed))
    (tmp_path / "p.toml").write_text(f"title = 'x'\n{head}\n[symbols]\n{symbols}\n" + "".join(claims))
    return [result.verdict.outcome for result in judge_paper(load_paper(tmp_path / "p.toml"), motions=False)]


class TestEndlessRanges:
    """n ≥ 0 is more than the first few n: behind its numbers a formula may change."""

    @pytest.mark.parametrize("last", [4, 6, 9])
    @pytest.mark.parametrize(
        "false",
        [
            lambda last: (rf"\binom{{n}}{{{last + 1}}} f + s_0 = s_0", []),
            lambda last: ("n" + "".join(f"(n-{k})" for k in range(1, last + 1)) + " f = 0", []),
            lambda last: (
                "(1+f)^n = 1" + "".join(rf" + \binom{{n}}{{{k}}} f^{{{k}}}" for k in range(1, last + 1)),
                [],
            ),
            lambda last: (
                "s_n = f^n",
                [f"s_{{{k}}} = f^{{{k}}}" for k in range(2, last + 1)]
                + ["s_0 = 1", "s_1 = f", f"s_{{n+{last + 1}}} = 2 f"],
            ),
        ],
        ids=["binomial", "product", "expansion", "definition"],
    )
    def test_what_fails_behind_its_numbers_is_refuted(self, false, last):
        latex, definitions = false(last)
        found = check(latex + r", n \geq 0", F, definitions=definitions)
        assert found.outcome == Outcome.REFUTED
        assert f"for n = {last + 1}" in found.verdict.reason

    def test_chosen_orders_are_kept_to(self):
        found = check(r"\binom{n}{5} f + s_0 = s_0, n \geq 0", F, orders="n = 0..4")
        assert (found.outcome, found.verdict.scope) == (Outcome.PROVED, "n = 0..4")

    @pytest.mark.parametrize(
        ("latex", "definitions"),
        [
            (r"\sum_{k=0}^{n} \binom{n}{k} f^k = (1+f)^n", []),
            (r"\binom{n}{13} f = 0", []),
            ("n" + "".join(f"(n-{k})" for k in range(1, 20)) + " f = 0", []),
            (
                "s_n = f^n",
                [f"s_{{{k}}} = f^{{{k}}}" for k in range(2, 14)] + ["s_0 = 1", "s_1 = f", "s_{n+14} = 2 f"],
            ),
        ],
    )
    def test_what_is_seen_of_the_first_few_is_not_proved_of_all(self, latex, definitions):
        """Whether it goes on or changes behind all numbers that are looked at: no range without an end is proved
        by some of its members."""
        found = check(latex + r", n \geq 0", F, definitions=definitions)
        assert (found.outcome, found.verdict.scope) == (Outcome.UNCHECKED, None)
        assert "holds for n = 0..4; no proof for all" in found.verdict.reason
        chosen = check(latex + r", n \geq 0", F, definitions=definitions, orders="n = 0..4")
        assert chosen.holds and chosen.verdict.scope == "n = 0..4"

    def test_what_the_recurrence_shows_is_proved_of_all(self):
        own = ["s_0 = f", r"s_{n+1} = \dot{s}_n"]
        found = check(r"s_{n+2} = \ddot{s}_n, n \geq 0", F, definitions=own)
        assert (found.outcome, found.verdict.scope) == (Outcome.PROVED, "all n")
        assert check(r"f g = g f, n \geq 0", {**F, "g": "scalar"}).outcome == Outcome.PROVED


@pytest.mark.parametrize(
    "field", [r"\dot{\rho}", r"(a \times \dot{\rho})", r"((a \times \rho)^{(1)})", r"\ddot{\rho}"]
)
@pytest.mark.parametrize(("slope", "zero"), [(r"\operatorname{div}", "0"), (r"\operatorname{curl}", "0")])
def test_the_velocity_of_what_is_at_a_place_is_not_the_same_everywhere(slope, zero, field):
    r"""curl \dot{\rho} of a rigid body is 2ω."""
    symbols = {
        "a": {"kind": "vector", "uniform": True},
        r"\rho": {"kind": "vector", "coordinate": True},
    }
    found = check(f"{slope} {field} = {zero}", symbols)
    assert found.outcome == Outcome.UNCHECKED
    assert "as the motion says" in found.verdict.reason


class TestMembersDeclaredByThemselves:
    """b_1 beside b_n is that family's member, and nothing else that is printed alike."""

    @pytest.mark.parametrize("index", [0, 1, 2])
    def test_it_is_the_same_symbol(self, tmp_path, index):
        symbols = f"'b_n' = {{ kind = 'scalar' }}\n'b_{index}' = {{ kind = 'scalar' }}"
        assert paper(
            tmp_path,
            symbols,
            r"\sum_{k=0}^{2} b_k = b_1 + b_0 + b_2",
            rf"\dot{{b}}_k = \dot{{b}}_{index} + b_0 - b_0, k = \overline{{{index},{index}}}",
            "b_1 = b_2 + b_0",
        ) == [Outcome.PROVED, Outcome.PROVED, Outcome.REFUTED]

    @pytest.mark.parametrize("more", ["constant = true", "weight = 2", "uniform = true"])
    def test_declared_otherwise_it_is_no_member(self, tmp_path, more):
        symbols = f"'b_n' = {{ kind = 'scalar' }}\n'b_1' = {{ kind = 'scalar', {more} }}"
        printed = (
            r"\sum_{k=1}^{2} \dot{b}_k = \dot{b}_2",
            r"b_k + b_2 = b_1 + b_2, k = \overline{1,1}",
            "b_2 - b_3 = 0",
        )
        unchecked = [Outcome.UNCHECKED, Outcome.UNCHECKED, Outcome.REFUTED]
        assert paper(tmp_path, symbols, *printed) == unchecked

    def test_a_fault_of_a_numbered_symbol_is_told_where_it_stands(self, tmp_path):
        with pytest.raises(PaperError, match=r"p.toml:4:1: V_1: of: z"):
            paper(tmp_path, "'V_1' = { kind = 'scalar', of = ['z'] }", "V_1 = 0")


FRAMES = r"""[frames]
base = "N"
names = ["A"]
'{}^F\omega^G' = "angular velocity of G in F"
'{}^F R^G' = "rotation to F from G"
"""


@pytest.mark.parametrize(
    ("printed", "message"),
    [
        (r"\frac{{}^A d (T x)}{dt} = \frac{{}^A d T}{dt} x + T \frac{{}^A d x}{dt}", "tensor in a frame"),
        (r"{}^A\frac{d}{dt} {}^A R^N = 0", "tensor in a frame"),
    ],
)
def test_a_tensor_seen_from_a_frame_is_asked_about(tmp_path, printed, message):
    symbols = "'x' = { kind = 'vector' }\n'T' = { kind = 'tensor' }"
    with pytest.raises(PaperError, match=message):
        paper(tmp_path, symbols, printed, head=FRAMES)


class TestMapsAreDefinedEverywhere:
    @pytest.mark.parametrize(
        "latex",
        [
            r"\varphi : V_3 \to V_3, \varphi(x) = \frac{x}{\|x\|}",
            r"\varphi : V_3 \to V_3, \varphi(x) = T^{-1} x",
            r"\varphi : V_3 \to \mathbb{R}, x \mapsto \frac{1}{x \cdot a}",
            r"\varphi : \mathbb{R} \to \mathbb{R}, \varphi(s) = \sqrt{s}",
            r"\varphi : \mathbb{R} \to \mathbb{R}, \varphi(s) = s^{-1}",
        ],
    )
    def test_or_are_no_maps(self, latex):
        assert check(latex, {"T": "tensor", "a": "vector"}).outcome == Outcome.UNCHECKED

    @pytest.mark.parametrize(
        "latex",
        [
            r"\varphi : S^2 \to V_3, \varphi(x) = \frac{a}{\|x\|}",
            r"\varphi : \mathbb{R} \to \mathbb{R}, \varphi(s) = \sqrt{s^2}",
            r"\varphi : \mathbf{SO}_3 \to \mathbf{SO}_3, \varphi(Q) = Q^{-1}",
        ],
    )
    def test_with_all_that_is_in_their_domain(self, latex):
        assert check(latex, {"T": "tensor", "a": "vector"}).outcome == Outcome.DEFINITION

r"""Classes of statements of which the judge once said what is not so, with members of each."""

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.papers import PaperError, load_paper
from workbench.prover.explain.decide_under_facts import judged_or_unchecked

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
    def test_claims_that_fail_past_their_literals_are_refuted(self, false, last):
        latex, definitions = false(last)
        found = check(latex + r", n \geq 0", F, definitions=definitions)
        assert found.outcome == Outcome.REFUTED
        assert f"for n = {last + 1}" in found.verdict.reason


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

    def test_a_fault_of_a_numbered_symbol_has_its_position(self, tmp_path):
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
def test_a_tensor_resolved_in_a_frame_raises_a_question(tmp_path, printed, message):
    symbols = "'x' = { kind = 'vector' }\n'T' = { kind = 'tensor' }"
    with pytest.raises(PaperError, match=message):
        paper(tmp_path, symbols, printed, head=FRAMES)


FIELDS = {
    "q": {"kind": "scalar", "independent": True},
    "p": {"kind": "scalar", "independent": True},
    "f": {"kind": "scalar", "of": ["q", "p"]},
    r"\rho": {"kind": "vector", "coordinate": True},
    "F": {"kind": "scalar", "of": [r"\rho"]},
    "W": {"kind": "vector", "of": [r"\rho"]},
}


@pytest.mark.parametrize(
    ("premise", "true", "false"),
    [
        ("f = q p", r"\frac{\partial f}{\partial q} = p", r"\frac{\partial f}{\partial q} = q"),
        ("f = q^2 p", r"\frac{\partial^2 f}{\partial q \partial p} = 2 q", r"\frac{\partial^2 f}{\partial q \partial p} = q"),
        ("f = q p", r"\frac{\partial \dot{f}}{\partial \dot{q}} = p", r"\frac{\partial \dot{f}}{\partial \dot{q}} = q"),
        ("f = q^2", r"\frac{d}{dt} \frac{\partial f}{\partial q} = 2 \dot{q}", r"\frac{d}{dt} \frac{\partial f}{\partial q} = \dot{q}"),
        ("f = q p", r"\dot{f} + \frac{\partial f}{\partial q} = \dot{q} p + q \dot{p} + p", r"\dot{f} + \frac{\partial f}{\partial q} = p"),
        (r"F = \rho^2", r"\nabla F = 2 \rho", r"\nabla F = \rho"),
        (r"W = \rho", r"\nabla \cdot W = 3", r"\nabla \cdot W = 2"),
        ("F = 0", r"\nabla F = 0", r"\nabla F = \rho"),
    ],
)  # fmt: skip
def test_a_premise_that_must_hold_everywhere_asks_its_author(tmp_path, premise, true, false):
    r"""\partial f/\partial q = p if f = q p: f may have that value at one place only. Where f = q p, f is that
    function."""
    (tmp_path / "n.toml").write_text('[conventions]\ngradient = "column"\n[symbols]\n')
    for word in ("if", "where"):
        found, refuted = (
            check(rf"{said} \text{{ {word} }} {premise}", FIELDS, notation=tmp_path / "n.toml")
            for said in (true, false)
        )
        if word == "if" or premise == "F = 0":
            assert found.outcome == Outcome.UNCHECKED and "at one place only" in found.verdict.reason
        else:
            assert found.outcome == Outcome.PROVED
        assert refuted.outcome == Outcome.REFUTED


def test_too_deep_nesting_is_unchecked():
    def judge():
        raise RecursionError

    assert judged_or_unchecked(judge).outcome == Outcome.UNCHECKED

r"""Classes of statements of which the judge once said what is not so, with members of each."""

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.formula_errors import ReadError
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
    def test_members_alone_prove_no_endless_range(self, latex, definitions):
        """Whether it goes on or changes behind all numbers that are looked at: no range without an end is proved
        by some of its members."""
        found = check(latex + r", n \geq 0", F, definitions=definitions)
        assert (found.outcome, found.verdict.scope) == (Outcome.UNCHECKED, None)
        assert "holds for n = 0..4; no proof for all" in found.verdict.reason
        chosen = check(latex + r", n \geq 0", F, definitions=definitions, orders="n = 0..4")
        assert chosen.holds and chosen.verdict.scope == "n = 0..4"

    def test_consequences_of_a_recurrence_hold_for_all_n(self):
        own = ["s_0 = f", r"s_{n+1} = \dot{s}_n"]
        found = check(r"s_{n+2} = \ddot{s}_n, n \geq 0", F, definitions=own)
        assert (found.outcome, found.verdict.scope) == (Outcome.PROVED, "all n")
        assert check(r"f g = g f, n \geq 0", {**F, "g": "scalar"}).outcome == Outcome.PROVED


@pytest.mark.parametrize(
    "field", [r"\dot{\rho}", r"(a \times \dot{\rho})", r"((a \times \rho)^{(1)})", r"\ddot{\rho}"]
)
@pytest.mark.parametrize(("slope", "zero"), [(r"\operatorname{div}", "0"), (r"\operatorname{curl}", "0")])
def test_the_rate_of_a_coordinate_is_not_uniform(slope, zero, field):
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


QUATERNIONS = {
    "q": "hamilton quaternion",
    "a": "vector",
    "u": {"kind": "vector", "unit": True},
    r"\theta": "scalar",
}


class TestVectorsOfAPaperWithQuaternions:
    """A vector may be a quaternion without a scalar part there: its square is −x·x then, its exponential one."""

    @pytest.mark.parametrize(
        "latex",
        [
            "u^2 = -1",
            r"a^2 = -\|a\|^2",
            r"(u \sin\theta)^2 = -\sin^2 \theta",
            r"a^2 = -1 \text{ for } \|a\| = 1",
            "u^4 - u^2 = 2",
        ],
    )
    def test_claims_that_hold_for_quaternions_are_not_refuted(self, latex):
        found = check(latex, QUATERNIONS)
        assert found.outcome == Outcome.UNCHECKED and "quaternions without" in found.verdict.reason
        others = {name: kind for name, kind in QUATERNIONS.items() if name != "q"}
        assert check(latex, others).outcome == Outcome.REFUTED

    @pytest.mark.parametrize(
        "latex", ["u^2 = -2", r"a^2 = \|a\|", r"a^2 = -1 \text{ for } \|a\| = 2", "a^4 = -1"]
    )
    def test_claims_false_for_vectors_and_quaternions_are_refuted(self, latex):
        assert check(latex, QUATERNIONS).outcome == Outcome.REFUTED

    @pytest.mark.parametrize("latex", [r"\exp(\theta u)", r"e^{\theta u}", r"\exp u"])
    def test_any_exponential_of_a_vector_raises_a_question(self, latex):
        with pytest.raises(ReadError, match="of its skew tensor, or of a quaternion"):
            check(rf"{latex} = \cos\theta + u \sin\theta", QUATERNIONS)


class TestConditionsOnIndices:
    """i = j beside a formula is its condition, and of members that do not meet it nothing is said."""

    SYMBOLS = F | {"a_n": "vector", "b_n": "vector"}
    AXES = (
        r"b_1 = \begin{bmatrix} 1 \\ 0 \\ 0 \end{bmatrix}",
        r"b_2 = \begin{bmatrix} 0 \\ 1 \\ 0 \end{bmatrix}",
    )
    BOTH = r", m = \overline{1,2}, n = \overline{1,2}"

    @pytest.mark.parametrize(
        "sign", ["= 0, m = n", r"= 0 \text{ if } m = n", "= 0, n = m = 1", "= 0, 1 = m = n"]
    )
    def test_claims_that_hold_under_conditions_are_not_refuted(self, sign):
        assert "holds for" in check(rf"a_m \times a_n {sign}", self.SYMBOLS).verdict.reason

    @pytest.mark.parametrize(
        ("latex", "holds"),
        [
            (r"b_m \cdot b_n = 0, m \neq n", True),
            (r"b_m \cdot b_n = 1, m = n", True),
            (r"b_m \cdot b_n = 1 \text{ if } m = n", True),
            (r"b_m \cdot b_n = 0, m = n", False),
            (r"b_m \cdot b_n = 1, m \neq n", False),
            (r"b_m \cdot b_n = 0", False),
        ],
    )
    def test_within_a_range(self, latex, holds):
        found = check(latex + self.BOTH, self.SYMBOLS, definitions=self.AXES)
        assert found.outcome == (Outcome.PROVED if holds else Outcome.REFUTED)

    def test_unsatisfiable_conditions_on_indices_are_an_error(self):
        with pytest.raises(PaperError, match="no values"):
            check(r"s_n = 0, m \neq n, m = \overline{1,1}, n = \overline{1,1}", self.SYMBOLS)

    def test_numbers_and_declared_symbols_are_claims(self):
        assert check("f = f + 0, 1 = 2", F).outcome == Outcome.REFUTED
        assert check("s_1 = s_1 + 0, f = m", F | {"m": "scalar"}).outcome == Outcome.REFUTED


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
        assert refuted.outcome in (Outcome.REFUTED, Outcome.UNCHECKED)


class TestMembersOfTwoDigits:
    """R_{13} of a family R_n is its thirteenth member, or the one of 1 and 3, as relative rotations are written."""

    ROTATIONS = F | {"R_n": "rotation"}

    @pytest.mark.parametrize("latex", ["R_{13} = R_{12} R_{23}", "R_{12} = R_1 R_2", "s_{10} = s_1"])
    def test_a_claim_on_two_indices_false_later_is_unchecked(self, latex):
        found = check(latex, self.ROTATIONS)
        assert found.outcome == Outcome.UNCHECKED and "by two indices" in found.verdict.reason

    def test_unless_it_is_said_which_one_it_is(self):
        one = {f"R_{{{k}}}": {"kind": "rotation", "free": True} for k in (12, 13, 23)}
        assert check("R_{13} = R_{12} R_{23}", self.ROTATIONS | one).outcome == Outcome.REFUTED
        powers = ["s_0 = f", "s_{n+1} = f s_n"]
        assert check("s_{12} = f^{12}", F, definitions=powers).outcome == Outcome.REFUTED
        assert check("s_{12} = f^{13}", F, definitions=powers).outcome == Outcome.PROVED

    def test_others_are_refuted(self):
        assert check("R_3 = R_1 R_2", self.ROTATIONS).outcome == Outcome.REFUTED


class TestLinesThatDefine:
    SYMBOLS = F | {"g": "scalar", "h": "scalar", "a": "vector", "b": "vector", "R": "rotation"}

    @pytest.mark.parametrize(
        "lines",
        [
            [r"f &:= g, \quad h := g", "f &= h"],
            [r"f &:= g := h", "f &= h"],
            [r"f g &:= h", "f g &= h"],
            [r"s_n &:= f^n", "s_2 &= f^2"],
            [r"a &:= R b", r"R &:= \mathbf{I}", "a &= b"],
        ],
    )
    def test_a_definition_in_a_line_applies_to_later_lines(self, lines):
        found = check(r"\begin{aligned} " + r" \\ ".join(lines) + r" \end{aligned}", self.SYMBOLS)
        assert Outcome.REFUTED not in [each.outcome for each in found]
        last = found[-1].verdict
        assert last.outcome is Outcome.DEFINITION or "holds by" in last.reason

    @pytest.mark.parametrize(
        "lines",
        [
            [r"f &:= g", r"g &:= f", "f &= h"],
            [r"f &:= g", r"g &:= h + f", "f &= h"],
            [r"f &:= g", r"g &:= 2 h", r"h &:= f", "f &= s_1"],
        ],
    )
    def test_lines_that_define_in_a_circle_prove_nothing(self, lines):
        found = check(r"\begin{aligned} " + r" \\ ".join(lines) + r" \end{aligned}", self.SYMBOLS)
        assert found[-1].outcome is Outcome.REFUTED

    def test_of_other_symbols_it_says_nothing(self):
        found = check(r"\begin{aligned} f g &:= h \\ a &= b \end{aligned}", self.SYMBOLS)
        assert found[1].outcome == Outcome.REFUTED


class TestSinesWithinSines:
    """The engines know no circle of what holds another one; each evaluated the other without an end."""

    ANGLES = F | {r"\theta": "scalar", "a": "vector", "u": {"kind": "vector", "unit": True}}

    @pytest.mark.parametrize(
        "latex",
        [
            r"\cos^2(\cos\theta) + \sin^2(\cos\theta) = 1",
            r"\cos(f \sin\theta) = f",
            r"\sin\frac{\theta \sin\theta}{2} = f",
            r"\sin(\|a\| \sin\|a\|) = f",
            r"\exp(\sin\theta \tilde{u}) u = u",
            r"\exp(\operatorname{skew}(\cos\theta a)) a = a",
            r"\theta = \arccos(\cos(\cos\theta))",
        ],
    )
    def test_are_unchecked(self, latex):
        found = check(latex, self.ANGLES)
        assert found.outcome == Outcome.UNCHECKED and "another one" in found.verdict.reason

    def test_by_a_definition_too(self):
        found = check(r"\cos h = f", self.ANGLES, definitions=[r"h = f \sin\theta"])
        assert found.outcome == Outcome.UNCHECKED and "another one" in found.verdict.reason

    def test_a_sine_in_a_dual_part_is_none(self):
        latex = r"\cos(\theta + \varepsilon \sin\theta) = \cos\theta - \varepsilon \sin^2 \theta"
        assert check(latex, self.ANGLES).outcome == Outcome.PROVED


def test_too_deep_nesting_is_unchecked():
    def judge():
        raise RecursionError

    assert judged_or_unchecked(judge).outcome == Outcome.UNCHECKED


class TestReachOfARate:
    """d/dt A P is the rate of the product; where that is false and it holds with that of A alone, it is asked."""

    @pytest.mark.parametrize(
        ("latex", "expected"),
        [
            (r"\frac{d}{dt} A P = \dot{A} P + A \dot{P}", "proved"),
            (r"\frac{d}{dt} A P = \dot{A} P - A \dot{P}", "refuted"),
            (r"\frac{d}{dt} A P = \dot{A} P", "unchecked"),
            (r"\frac{d}{dt} s P = \dot{s} P", "unchecked"),
            (r"\frac{d}{dt} s c = \dot{s} c", "proved"),
            (r"\frac{d}{dt} s c = 2 \dot{s} c", "refuted"),
            (r"A \frac{d}{dt} A P = A \dot{A} P + A^2 \dot{P}", "proved"),
        ],
    )
    def test_the_scope_of_a_derivative_is_judged(self, latex, expected):
        kinds = {"A": "tensor", "P": "vector", "s": "scalar", "c": {"kind": "vector", "constant": True}}
        found = check(latex, kinds)
        assert found.outcome == expected
        assert expected != "unchecked" or "how far does d/dt reach" in found.verdict.reason

"""Statements of which the judge once said what is not so, or that made it stop; each with its truth."""

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.core.verdict import Outcome
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.papers import PaperError, load_paper

SYMBOLS = {
    "a": {"kind": "vector", "uniform": True},
    "b": {"kind": "vector"},
    "f": {"kind": "scalar", "uniform": True},
    "g": {"kind": "scalar"},
    "T": {"kind": "tensor"},
    "u": {"kind": "vector", "unit": True},
    "x": {"kind": "vector"},
    r"\alpha": {"kind": "scalar"},
    r"\beta": {"kind": "scalar"},
    r"\rho": {"kind": "vector", "coordinate": True},
    r"\underline{a}": {"kind": "dual vector"},
    r"\underline{f}": {"kind": "dual scalar"},
}


def outcome(latex, *assume, orders=None):
    return check(latex, SYMBOLS, assume=assume, orders=orders).outcome


class TestAngles:
    """α, sin α and cos α are no independent numbers: a counterexample must be one for some real α."""

    def test_an_angle_without_a_value_is_shown_by_cosine_and_sine(self):
        values = check(r"\sin(2 \alpha) = 2 \sin \alpha", SYMBOLS).verdict.counterexample.values
        assert r"\sin \alpha" in values and r"\alpha" not in values
        values = check(r"\sin \underline{f} = \cos \underline{f}", SYMBOLS).verdict.counterexample.values
        assert {r"\sin \underline{f}", r"\operatorname{Du} \underline{f}"} <= set(values)
        assert r"\underline{f}" not in values
        values = check(r"\cos(\varepsilon f) = 1 - \varepsilon f", SYMBOLS).verdict.counterexample.values
        assert set(values) == {"f"}


class TestZeroSets:
    def test_an_inequation_has_denominators_and_two_engines(self):
        assert outcome(r"\frac{1}{f} \neq 0") == Outcome.UNCHECKED
        assert outcome(r"\frac{1}{f} \neq 0", r"f \neq 0") == Outcome.PROVED
        found = check(r"u \cdot u \neq 2", SYMBOLS)
        assert found.outcome == Outcome.PROVED
        assert any(e.method.startswith("SymPy") for e in found.verdict.evidence)


def verdicts(path, text):
    path.write_text(f'title = "Definitions"\n{text}', encoding="utf-8")
    return [result.verdict for result in judge_paper(load_paper(path), motions=False)]


def claim(printed, orders=None):
    ranges = f"orders = '{orders}'\n" if orders else ""
    name = f"c{len(printed)}.{orders}".replace(" ", "").replace("=", "").replace(",", "-")
    return f"[[claim]]\nid = '{name}'\nprinted = '{printed}'\n{ranges}"


@pytest.mark.parametrize("flag", ["unit = true", "constant = true", "coordinate = true"])
def test_a_definition_cannot_keep_what_is_declared_of_a_vector(tmp_path, flag):
    text = (
        f"[symbols]\na = {{ kind = 'vector' }}\nu = {{ kind = 'vector', {flag} }}\n[definitions]\nu = 'a'\n"
    )
    with pytest.raises(PaperError, match="declared as"):
        verdicts(tmp_path / "paper.toml", text + claim(r"u \cdot u = 1"))


def test_a_definition_cannot_keep_a_rotation(tmp_path):
    text = "[symbols]\nT = { kind = 'tensor' }\nR = { kind = 'rotation' }\n[definitions]\nR = 'T'\n"
    with pytest.raises(PaperError, match="declared as rotation"):
        verdicts(tmp_path / "paper.toml", text + claim(r"R R^T = \mathbf{I}"))


DUAL_ARGUMENT = r"""[symbols]
x = { kind = "vector" }
'\underline{a}' = { kind = "dual vector" }
[definitions]
'F(x)' = 'x \cdot x'
'G(x)' = 'x'
"""


@pytest.mark.parametrize(
    ("printed", "expected"),
    [
        (r"\operatorname{Du} F(\underline{a}) = 0", Outcome.REFUTED),
        (r"\|G(\underline{a})\| = \|\operatorname{Re} \underline{a}\|", Outcome.REFUTED),
        (r"F(\underline{a}) = \underline{a} \cdot \underline{a} + 0", Outcome.PROVED),
    ],
)
def test_a_function_of_a_dual_argument_is_dual(tmp_path, printed, expected):
    (verdict,) = verdicts(tmp_path / "paper.toml", DUAL_ARGUMENT + claim(printed))
    assert verdict.outcome == expected


IRREGULAR = {
    "a member of a family": ("'a_2' = '2 x'\n'a_n' = 'x^{(n)}'\n", r"a_{n+1} = \dot{a}_n"),
    "a member above the base": ("'a_0' = 'x'\n'a_{n+1}' = 'T a_n'\n'a_3' = 'x'\n", "f a_{n+1} = f T a_n"),
}


@pytest.mark.parametrize("name", IRREGULAR)
def test_a_member_defined_by_itself_is_no_part_of_all_n(tmp_path, name):
    definitions, printed = IRREGULAR[name]
    symbols = "[symbols]\nx = { kind = 'vector' }\nT = { kind = 'tensor' }\nf = { kind = 'scalar' }\n"
    symbols += "'a_n' = { kind = 'vector' }\n"
    text = symbols + "[definitions]\n" + definitions + claim(printed, "n = 4..5") + claim(printed, "n = 0..4")
    beyond, across = verdicts(tmp_path / "paper.toml", text)
    assert beyond.outcome == Outcome.PROVED and beyond.scope in ("n = 4..5", "all n ≥ 4")
    assert across.outcome == Outcome.REFUTED


def test_a_row_of_a_family_defined_by_itself_is_no_part_of_all_n(tmp_path):
    text = r"""[symbols]
x = { kind = "vector" }
'K_{m,n}' = { kind = "vector" }
[definitions]
'K_{0,n}' = '2 x'
'K_{m+1,n}' = 'x^{(m+1)} + x^{(n)}'
"""
    (verdict,) = verdicts(
        tmp_path / "paper.toml", text + claim(r"\dot{K}_{m,n} = K_{m+1,n+1}", "m = 1..2, n = 1..2")
    )
    assert (verdict.outcome, verdict.scope) == (Outcome.PROVED, "m = 1..2, n = 1..2")


def test_members_that_fit_the_recurrence_keep_it_for_all_n(tmp_path):
    text = r"""[symbols]
'\omega' = { kind = "vector", weight = 1 }
'\Phi_n' = { kind = "tensor", weight = "n" }
[definitions]
'\Phi_1' = '\tilde{\omega}'
'\Phi_{n+1}' = '\dot{\Phi}_n + \Phi_n \Phi_1'
'\Phi_0' = '\mathbf{I}'
"""
    step = r"\operatorname{trace} \Phi_{n+1} = \operatorname{trace}(\dot{\Phi}_n + \Phi_n \Phi_1)"
    (verdict,) = verdicts(tmp_path / "paper.toml", text + claim(step, "n = 0..3"))
    assert (verdict.outcome, verdict.scope) == (Outcome.PROVED, "all n")


@pytest.mark.parametrize("alias", ["L_{n,m}", "L_{m+1,n}"])
def test_an_alias_with_other_indices_is_refused(tmp_path, alias):
    text = f"[symbols]\n'K_{{m,n}}' = {{ kind = 'scalar', aliases = ['{alias}'] }}\n"
    with pytest.raises(PaperError, match="indices of"):
        verdicts(tmp_path / "paper.toml", text + claim("K_{1,2} = 1 L_{1,2}"))


FIELDS = r"""[symbols]
'\omega' = { kind = "vector", uniform = true }
'\rho' = { kind = "vector", coordinate = true }
'T' = { kind = "tensor", uniform = true }
'A_n' = { kind = "vector", uniform = true }
[definitions]
'v' = '\omega \times \rho'
'A_1' = '\omega \times \rho'
'A_{n+1}' = '\dot{A}_n + T A_n'
"""


@pytest.mark.parametrize(
    ("printed", "orders", "expected"),
    [
        (r"\operatorname{curl} v + \rho \times \rho = 0", None, (Outcome.REFUTED, None)),
        (r"\operatorname{curl} v + \rho \times \rho = 2 \omega", None, (Outcome.PROVED, None)),
        (r"\operatorname{curl} A_n + \rho \times \rho = 0", "n = 1..2", (Outcome.REFUTED, None)),
        (r"\operatorname{curl} ((\omega \times \rho)^{(n)}) + \rho \times \rho = 0", "n = 0..2",
         (Outcome.REFUTED, None)),
        (r"\operatorname{div} ((T \rho)^{(n)}) = \operatorname{trace} T^{(n)}", "n = 0..2",
         (Outcome.UNCHECKED, None)),
    ],
)  # fmt: skip
def test_a_name_that_stands_for_a_field_hides_no_coordinate(tmp_path, printed, orders, expected):
    (verdict,) = verdicts(tmp_path / "paper.toml", FIELDS + claim(printed, orders))
    assert (verdict.outcome, verdict.scope) == expected


def test_the_first_engine_must_see_a_counterexample(monkeypatch):
    monkeypatch.setattr(ExactEngine, "at", lambda engine, p, point: 0)
    found = check(r"a \times b = b \times a", SYMBOLS)
    assert found.outcome == Outcome.UNCHECKED and "one engine only" in found.verdict.reason


def test_families_side_by_side_are_each_for_all_n(tmp_path):
    text = r"""[symbols]
T = { kind = "tensor" }
v = { kind = "vector" }
[definitions]
'\Phi_1' = 'T'
'\Phi_{n+1}' = '\dot{\Phi}_n + \Phi_n T'
'a_1' = 'v'
'a_{n+1}' = '\dot{a}_n + \Phi_n v'
"""
    printed = r"v \cdot a_{n+1} = v \cdot \dot{a}_n + v \cdot (\Phi_n v)"
    (verdict,) = verdicts(tmp_path / "paper.toml", text + claim(printed, "n = 1..3"))
    assert (verdict.outcome, verdict.scope) == (Outcome.PROVED, "all n ≥ 1")


@pytest.mark.parametrize(
    ("orders", "scope"), [("n = 1..3", "all n ≥ 1"), ("n = 2..3", "all n ≥ 1"), ("n = 0..2", None)]
)
def test_all_n_begins_behind_a_member_that_is_defined_apart(tmp_path, orders, scope):
    text = r"""[symbols]
x = { kind = "vector" }
f = { kind = "scalar" }
'a_n' = { kind = "vector" }
[definitions]
'a_1' = 'x'
'a_{n+1}' = '\dot{a}_n + f a_n'
"""
    (verdict,) = verdicts(tmp_path / "paper.toml", text + claim(r"f a_{n+1} = f (\dot{a}_n + f a_n)", orders))
    assert verdict.scope == scope
    assert verdict.outcome == (Outcome.PROVED if scope else Outcome.REFUTED)


@pytest.mark.parametrize("latex", [r"a \times b = b \times a", r"T a = T b", r"(a \cdot b) T = 0"])
def test_a_counterexample_has_no_entry_too_many(latex):
    """With any entry put to 0 the two sides would be equal, or there is but one entry left."""
    values = check(latex, SYMBOLS).verdict.counterexample.values
    entries = [x for components in values.values() for x in components if x != "0"]
    assert len(entries) <= 3 and set(entries) == {"1"}

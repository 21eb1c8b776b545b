"""Derivatives of symbolic order: what is proved for all n holds for each n, and no more is proved."""

import pytest

from workbench import check
from workbench.app.pipeline.judge_claims import judge_paper
from workbench.context.index_values import Orders
from workbench.core.construct import apply, derivative, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import instantiate
from workbench.core.names import Name
from workbench.core.terms import Derivative
from workbench.core.types import VECTOR, Declaration
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read, read_term
from workbench.papers import load_paper
from workbench.prover.decide.decide import Judge
from workbench.prover.decide.families.symbolic_orders import (
    symbolic_orders,
    with_free_derivatives,
    with_free_orders,
)

SYMBOLS = {
    "x": {"kind": "vector", "weight": 0},
    "y": {"kind": "vector", "weight": 0},
    "T": {"kind": "tensor", "weight": 0},
    "S": {"kind": "tensor", "weight": 0},
    "f": {"kind": "scalar", "weight": 0},
    "g": {"kind": "scalar", "weight": 0},
    "c": {"kind": "vector", "weight": 0, "constant": True},
    "C": {"kind": "tensor", "weight": 0, "constant": True},
    r"\mathbf{R}": {"kind": "rotation", "weight": 0},
}

ALL_N = [
    r"(x + 2 y)^{(n)} = x^{(n)} + 2 y^{(n)}",
    r"(x - C y)^{(n)} = x^{(n)} - C y^{(n)}",
    r"(T c)^{(n)} = T^{(n)} c",
    r"(c \times x)^{(n)} = c \times x^{(n)}",
    r"(c \cdot x)^{(n)} = x^{(n)} \cdot c",
    r"\tilde{x}^{(n)} = \widetilde{x^{(n)}}",
    r"(T^T)^{(n)} = (T^{(n)})^T",
    r"\operatorname{trace} T^{(n)} = (\operatorname{trace} T)^{(n)}",
    r"\dot{x}^{(n)} = x^{(n+1)}",
    r"\frac{d}{dt}(T^{(n)} \mathbf{R}^T) = T^{(n+1)} \mathbf{R}^T + T^{(n)} \dot{\mathbf{R}}^T",
    r"(x + c)^{(n+1)} = \dot{x}^{(n)}",
    r"\frac{d}{dt} ((f c)^{(n)}) = f^{(n+1)} c",
    r"\frac{d}{dt} ((f g)^{(n)}) = (f g)^{(n+1)}",
    r"\frac{d}{dt} ((T S)^{(n)}) = (T S)^{(n+1)}",
    r"\frac{d^{n-1}}{dt^{n-1}} \dot{x} = x^{(n)}",
]


def test_a_hypothesis_and_a_denominator_are_of_all_n():
    """The member that is not n alone is told by the term that it is made of."""
    equal, same = (
        read(text, SymbolTable.build(SYMBOLS), {"n"})[0] for text in ("T^{(n)} x = T^{(n)} y", "x = y")
    )
    found = Judge(Definitions()).judge(equal, hypothesis=same, orders=Orders.parse("n = 1..2"))
    assert (found.outcome, found.scope) == (Outcome.CONDITIONAL, "all n")
    found = check(r"\frac{f^{(n)}}{f^{(n)}} = 1", symbols=SYMBOLS, orders="n = 1..2")
    assert (found.outcome, found.verdict.scope) == (Outcome.CONDITIONAL, "all n")
    assert found.verdict.counterexample.values == {r"\left(f\right)^{(n)}": ("0",)}


def _read(latex):
    return read_term(latex, SymbolTable.build(SYMBOLS), frozenset({"n", "k"}))


@pytest.mark.parametrize("latex", [side for law in ALL_N[:-1] for side in law.split(" = ")])
def test_type_and_weight_stay_and_no_symbolic_order_is_left(latex):
    term = _read(latex)
    free = with_free_derivatives(term)
    assert (free.type, free.weight) == (term.type, term.weight)
    assert not [t for t in free.walk() if isinstance(t, Derivative) and not t.order.is_number]
    assert symbolic_orders([term]) and not symbolic_orders([free])


@pytest.mark.parametrize("uniform", ["", "f", "x", "fx"])
def test_a_free_derivative_is_as_uniform_as_what_it_is_of(uniform):
    kinds = {"f": "scalar", "x": "vector"}
    symbols = {name: {"kind": kind, "uniform": name in uniform} for name, kind in kinds.items()}
    table = SymbolTable.build(symbols | {r"\rho": {"kind": "vector", "coordinate": True}})
    free = with_free_derivatives(read_term("(f x)^{(n)}", table, {"n"}))
    assert free.declaration.uniform == (uniform == "fx")
    found = check(
        r"\operatorname{curl} ((f x)^{(n)} \times \rho) = 2 (f x)^{(n)}",
        symbols=symbols | {r"\rho": {"kind": "vector", "coordinate": True}},
        orders="n = 0..1",
    )
    proved = (Outcome.PROVED, "all n"), (Outcome.UNCHECKED, None)
    assert (found.outcome, found.verdict.scope) == proved[uniform != "fx"]


def test_a_constant_vanishes_from_the_first_derivative_on_only():
    with pytest.raises(NotExact, match="of a constant"):
        with_free_derivatives(_read("c^{(n)}"))
    assert with_free_derivatives(_read("c^{(n+1)}")).type == instantiate(_read("c^{(n+1)}"), {"n": 0}).type


def test_functions_are_equal_if_their_terms_and_orders_are():
    """Also of terms that are printed alike; c more derivatives are taken of the same function."""
    one, other = (
        symbol(Declaration(Name("x"), VECTOR).with_flags(uniform=uniform), ()) for uniform in (False, True)
    )
    n, k = Linear.variable("n"), Linear.variable("k")
    orders = [(one, n), (other, n), (one, k), (one, n + n)]
    free = [with_free_derivatives(derivative(term, order)) for term, order in orders]
    assert len({f.declaration.name for f in free}) == len(orders)
    assert [f.declaration.name.of for f in free] == orders
    assert str(free[0].declaration.name) == r"\left(x\right)^{(n)}"
    assert with_free_derivatives(derivative(one, n + 2)) == derivative(free[0], 2)


@pytest.mark.parametrize("kind", ["hamilton quaternion", "matrix 2x3", "transform"])
def test_of_other_kinds_it_is_any_of_that_type(kind):
    """The derivatives of a transform are none, and have other last rows."""
    term = read_term("X^{(n)}", SymbolTable.build({"X": {"kind": kind}}), {"n"})
    free = with_free_derivatives(term)
    assert (free.type, free.declaration.transform, free.declaration.unit) == (term.type, False, False)


def test_linear_derivatives_are_compared_as_a_difference():
    """Where both sides are one term as printed, they stay so: that is no claim."""

    def said(latex):
        return with_free_orders(read(latex, SymbolTable.build(SYMBOLS), {"n"})[0])

    one = said("(x + y)^{(n)} = x^{(n)} + y^{(n)}")
    left = with_free_derivatives(_read("x^{(n)} + y^{(n)}"))
    assert (one.left, one.right) == (apply("add", left, apply("neg", left)), zero(left.type))
    same = said(r"x^{(n)} \neq x^{(n)}")
    assert same.left == same.right == with_free_derivatives(_read("x^{(n)}")) and same.operator == "≠"
    assert said(r"(x + y)^{(n)} \neq x^{(n)} + y^{(n)}").operator == "≠"


def test_orders_may_be_sums():
    """The n + k-th derivative is a function of its own, and the one before it not known."""
    assert [str(order) for order in symbolic_orders([_read("x^{(n+k+1)}")])] == ["k+n+1"]
    with pytest.raises(NotExact, match="of order"):
        symbolic_orders([_read("x^{(n+k-1)}")])


@pytest.mark.parametrize("order", ["2n", "n-k"])
def test_other_orders_are_left_to_the_range(order):
    with pytest.raises(NotExact, match="of order"):
        symbolic_orders([_read(f"x^{{({order})}}")])


def test_a_definition_by_a_symbolic_order_is_one_for_all_n(tmp_path):
    paper = tmp_path / "paper.toml"
    paper.write_text(
        """title = "Derivatives"
[symbols]
'x' = { kind = "vector", weight = 0 }
[definitions]
'a_n' = 'x^{(n)}'
[[claim]]
id = "definition"
printed = 'a_n = x^{(n)}'
orders = "n = 1..3"
[[claim]]
id = "step"
printed = 'a_{n+1} = \\dot{a}_n'
orders = "n = 1..3"
""",
        encoding="utf-8",
    )
    verdicts = [result.verdict for result in judge_paper(load_paper(paper))]
    assert [(v.outcome, v.scope) for v in verdicts] == [
        (Outcome.DEFINITION, "all n"),
        (Outcome.PROVED, "all n"),
    ]


def test_the_variable_of_a_sum_is_none_of_the_scope(tmp_path):
    paper = tmp_path / "paper.toml"
    paper.write_text(
        "title = 'x'\n[symbols]\n'x' = { kind = 'vector' }\n"
        r"[definitions]" + "\n" + r"'S_n' = '\sum_{k=0}^{n} C_n^k x^{(k)}'" + "\n"
        "[[claim]]\nid = 'sum'\norders = 'n = 0..3'\n"
        r"printed = 'S_n = \sum_{k=0}^{n} C_n^k x^{(k)}'" + "\n"
    )
    (result,) = judge_paper(load_paper(paper))
    assert (result.verdict.outcome, result.verdict.scope) == (Outcome.DEFINITION, "all n")

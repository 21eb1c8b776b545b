"""A rich symbol table, and random terms over it in the form that the reader gives them."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import strategies as st

from workbench.core import construct
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Apply, IllFormed, Integer, Number, Symbol, Term, Zero
from workbench.core.types import SCALAR, TENSOR, VECTOR, Declaration
from workbench.language.naming.symbols import SymbolTable

SPECS = {
    r"\omega": {"kind": "vector", "aliases": [r"\boldsymbol{\omega}"]},
    r"\mathbf{v}": {"kind": "vector"},
    r"\mathbf{v}'": {"kind": "vector"},
    r"\boldsymbol{\rho}_Q": {"kind": "vector"},
    r"\mathbf{a}^*": {"kind": "vector"},
    r"\mathbf{a}_\rho^{[n]}": {"kind": "vector"},
    r"\boldsymbol{\rho}_{G_n}": {"kind": "vector"},
    r"{}_0\underline{\omega}_m": {"kind": "dual vector"},
    r"\alpha": {"kind": "scalar"},
    r"\lambda_{i,j}": {"kind": "scalar"},
    r"\underline{\alpha}": {"kind": "dual scalar"},
    r"x": {"kind": "scalar", "constant": True},
    r"\mathbf{S}": {"kind": "tensor"},
    r"\Phi_n": {"kind": "tensor"},
    r"\mathbf{R}": {"kind": "rotation"},
    r"{}^{k-1}\underline{\mathbf{R}}_k": {"kind": "dual rotation"},
    r"\mathbf{P}_n": {"kind": "operator"},
}
VARIABLES = ("n", "m", "k_1")


def _table() -> SymbolTable:
    table = SymbolTable.build(SPECS)
    for name, kind, formals in (
        (Name(r"\Phi", sub=("", ""), parameters=1), TENSOR, (Declaration(Name("x"), VECTOR),)),
        (Name("f", parameters=2), SCALAR, (Declaration(Name("x"), SCALAR), Declaration(Name("y"), SCALAR))),
    ):
        function = Declaration(name, kind, indices=name.indices, parameters=len(formals))
        table = table.with_symbol(function, formals)
    return table


TABLE = _table()
DECLARATIONS = sorted({d.name: d for d in TABLE.symbols.values()}.values(), key=lambda d: str(d.name))
FUNCTIONS = tuple(TABLE.functions.values())

linears = st.builds(
    lambda constant, name, factor: Linear(constant) + Linear.variable(name) * factor,
    st.integers(0, 3),
    st.sampled_from(VARIABLES),
    st.sampled_from((0, 0, 1, 1, 2, -1)),
).filter(lambda value: not value.is_number or value.constant >= 0)
numbers = st.builds(Fraction, st.integers(-12, 12).filter(bool), st.sampled_from((1, 1, 1, 2, 3)))

_BINARY = ("mul", "mul", "mul", "div", "dot", "cross", "outer", "compose")
_UNARY = """
    neg skew vect symmetric antisymmetric transpose inverse adjugate det trace re du norm sin cos exp
    divergence curl
"""


@st.composite
def symbols(draw) -> Term:
    declaration = draw(st.sampled_from(DECLARATIONS))
    return construct.symbol(declaration, [draw(linears) for _ in range(declaration.indices)])


@st.composite
def leaves(draw) -> Term:
    kind = draw(st.integers(0, 9))
    if kind <= 5:
        return draw(symbols())
    if kind == 6:
        return construct.number(draw(numbers))
    if kind == 7:
        value = draw(linears)
        return construct.number(2) if value.is_number else construct.integer(value)
    if kind == 8:
        top, bottom = draw(linears), draw(linears)
        return draw(
            st.sampled_from(
                (
                    construct.counting("factorial", top),
                    construct.counting("binomial", top, bottom),
                    construct.counting("multinomial", top, bottom, Linear(1)),
                )
            )
        )
    return draw(
        st.sampled_from(
            (
                construct.identity(),
                construct.dual_unit(),
                construct.time_operator(),
                construct.zero(VECTOR),
                construct.zero(TENSOR),
                construct.zero(),
            )
        )
    )


def _is_linear(term: Term) -> bool:
    if isinstance(term, Apply) and term.head in ("neg", "add"):
        return all(_is_linear(a) for a in term.arguments)
    return isinstance(term, Integer | Zero) or (isinstance(term, Number) and term.value.denominator == 1)


def _reads_otherwise(term: Term) -> bool:
    """Sums of integers are one integer to the reader, a quotient of numbers is a number, −n is an integer."""
    if not isinstance(term, Apply):
        return False
    if term.head == "add":
        return _is_linear(term) and any(isinstance(t, Integer) for t in term.walk())
    if term.head == "neg":
        return isinstance(term.arguments[0], Integer)
    if term.head == "div":
        return isinstance(term.arguments[1], Zero) or all(
            isinstance(a, Number | Zero) for a in term.arguments
        )
    return False


@st.composite
def _combined(draw, children) -> Term:
    shape = draw(st.integers(0, 11))
    try:
        match shape:
            case 0 | 1 | 2:
                term = construct.apply(draw(st.sampled_from(_UNARY.split())), draw(children))
            case 3 | 4 | 5:
                term = construct.apply(draw(st.sampled_from(_BINARY)), draw(children), draw(children))
            case 6 | 7:
                first, second = draw(children), draw(children)
                second = draw(st.sampled_from((second, construct.apply("neg", second), first)))
                if _reads_otherwise(second):
                    second = first
                term = construct.apply("add", first, second)
            case 8:
                term = construct.derivative(draw(children), draw(linears))
            case 9:
                base, exponent = draw(children), draw(linears)
                if base.type.is_column and exponent == Linear(0):
                    exponent = Linear(2)  # the reader asks whether v^0 is a label
                term = construct.power(base, exponent)
            case 10:
                name = draw(st.sampled_from(("k", "j")))
                term = construct.big_sum([name], draw(linears), draw(linears), draw(children))
            case _:
                term = draw(st.sampled_from((_block, _function, _multi_sum)))(draw, children)
    except IllFormed:
        return draw(children)
    return draw(children) if _reads_otherwise(term) else term


def _block(draw, children) -> Term:
    width = draw(st.integers(1, 2))
    return construct.block([[draw(children) for _ in range(width)] for _ in range(draw(st.integers(1, 2)))])


def _function(draw, children) -> Term:
    declaration = draw(st.sampled_from(FUNCTIONS))
    kinds = [formal.type.kind for formal in TABLE.formals[declaration.name]]
    arguments = [draw(children) for _ in kinds]
    if [a.type.kind for a in arguments] != kinds:
        raise IllFormed("other arguments")
    return construct.symbol(declaration, [draw(linears) for _ in range(declaration.indices)], arguments)


def _multi_sum(draw, children) -> Term:
    return construct.big_sum(["p_1", "p_2"], None, draw(linears), draw(children))


def _binds_once(term: Term) -> bool:
    """No summation variable is used twice on one path; the reader refuses it."""

    def check(node: Term, bound: frozenset[str]) -> bool:
        names = frozenset(getattr(node, "variables", ())) if not isinstance(node, Symbol) else frozenset()
        if names & bound:
            return False
        return all(check(child, bound | names) for child in node.children)

    return check(term, frozenset(VARIABLES))


terms = st.recursive(leaves(), _combined, max_leaves=12).filter(
    lambda term: not _reads_otherwise(term) and _binds_once(term)
)

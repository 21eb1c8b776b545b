"""Laws of reading and printing: read ∘ print is the identity, and printing does not change with spelling."""

from __future__ import annotations

import subprocess
import sys

import pytest
from hypothesis import HealthCheck, given, settings

from tests.language.generated import TABLE, VARIABLES, terms
from workbench.core.terms import Term
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_formula, read_term

_NO_CHECKS = list(HealthCheck)


@settings(max_examples=600, suppress_health_check=_NO_CHECKS)
@given(terms)
def test_printed_terms_read_back(term: Term) -> None:
    assert read_term(to_latex(term), TABLE, VARIABLES) == term


@pytest.mark.slow
@settings(max_examples=30_000, suppress_health_check=_NO_CHECKS)
@given(terms)
def test_printed_terms_read_back_many_times(term: Term) -> None:
    assert read_term(to_latex(term), TABLE, VARIABLES) == term


# spellings of one term
SAME = [
    (
        r"\dot{\omega}",
        r"\dot\omega",
        r"\boldsymbol{\dot\omega}",
        r"\frac{d}{dt} \omega",
        r"\frac{d\omega}{dt}",
    ),
    (r"\tilde\omega", r"\widetilde{\omega}", r"{\tilde\omega}", r"\tilde{\boldsymbol{\omega}}"),
    (r"\frac{1}{2} \omega", r"\tfrac12 \omega", r"\frac12\omega", r"\dfrac{1}{2}\,\omega", r"0.5 \omega"),
    (r"\omega \cdot \mathbf{v}", r"(\omega) \cdot (\mathbf{v})", r"\left[\omega\right] \cdot \{\mathbf{v}\}"),
    (r"\Phi_2^T", r"\Phi_2^\top", r"\Phi^T_{2}", r"{\Phi_2}^{T}", r"(\Phi_2)^\intercal"),
    (r"\det \Phi_2", r"\det\left(\Phi_2\right)", r"\operatorname{det} \Phi_2", r"\mathrm{det}[\Phi_2]"),
    (r"\operatorname{trace} \Phi_2", r"\text{tr} \Phi_2", r"\operatorname{tr}(\Phi_2)", r"\mathrm{Tr}\Phi_2"),
    (
        r"\operatorname{vect} \Phi_1 \Phi_2",
        r"\text{vect}(\Phi_1 \Phi_2)",
        r"\mathrm{vect}\{\Phi_1 \cdot \Phi_2\}",
    ),
    (r"(\omega, \mathbf{v}, \omega)", r"\langle \omega, \mathbf{v}, \omega \rangle"),
    (r"\|\omega\|", r"|\omega|", r"\left\|\omega\right\|", r"\lVert\omega\rVert", r"\bigl|\omega\bigr|"),
    (r"||\omega| \omega|", r"\left|\,|\omega| \omega\right|"),
    (r"C_n^m", r"\mathbf{C}_n^m", r"\binom{n}{m}", r"C^{m}_{n}"),
    (r"\exp(\alpha \mathbf{S})", r"e^{\alpha \mathbf{S}}", r"\mathrm{e}^{\alpha \mathbf{S}}"),
    (
        r"\omega^{(n+1)}",
        r"\frac{d^{n+1}}{dt^{n+1}} \omega",
        r"\frac{\mathrm{d}^{1+n} \omega}{\mathrm{d}t^{n+1}}",
    ),
    (
        r"\sin^2 \alpha",
        r"(\sin \alpha)^2",
        r"\sin(\alpha)\sin\alpha".replace(r"\sin(\alpha)\sin\alpha", r"{\sin \alpha}^2"),
    ),
    (r"2 n \omega", r"(2n) \omega", r"\left(n+n\right) \omega"),
    (
        r"\dot{\mathbf{a}}_\rho^{[n]}",
        r"\frac{d}{dt} \mathbf{a}^{[n]}_{\rho}",
        r"{\dot{\mathbf{a}}_\rho}^{[n]}",
    ),
    (r"\omega(t)", r"\omega"),
    (r"\mathbf{P}_n(\mathbf{D}) \omega", r"\mathbf{P}_n \omega"),
    (r"\mathbf{D}", r"\frac{d}{dt}"),
    (r"-\frac{1}{2}", r"\frac{-1}{2}", r"-0.5"),
]


@pytest.mark.parametrize("spellings", SAME, ids=[s[0] for s in SAME])
def test_spellings_of_one_term(spellings: tuple[str, ...]) -> None:
    terms_read = [read_term(latex, TABLE, VARIABLES) for latex in spellings]
    assert terms_read == [terms_read[0]] * len(spellings)


# pairs that look alike and differ
DIFFERENT = [
    (r"\dot{\tilde\omega}", r"\tilde{\dot\omega}"),
    (r"\tilde\omega^2 \mathbf{v}", r"\widetilde{\omega \times \mathbf{v}}"),
    (r"\ddot\omega", r"\dot{\dot\omega}"),
    (r"\mathbf{v}'", r"\mathbf{v}"),
    (r"\alpha", r"\underline{\alpha}"),
    (r"\mathbf{a}^*", r"\mathbf{S}^*"),
    (r"\Phi_n", r"\Phi_n(\omega)"),
    (r"\mathbf{S} \Phi_1 \omega", r"\mathbf{S} (\Phi_1 \omega)"),
    (r"\alpha - \lambda_{1,2}", r"\alpha + \lambda_{1,2}"),
    (r"\det \mathbf{S} \Phi_1", r"(\det \mathbf{S}) \Phi_1"),
    (r"\alpha^2 x", r"\alpha^{2 }[x]^{2}"),
]


@pytest.mark.parametrize(("one", "other"), DIFFERENT)
def test_similar_formulas_may_be_different_terms(one: str, other: str) -> None:
    assert read_term(one, TABLE, VARIABLES) != read_term(other, TABLE, VARIABLES)


def test_the_dot_over_a_family_member_is_on_the_member() -> None:
    term = read_term(r"\dot{\Phi}_{n+1}", TABLE, VARIABLES)
    assert to_latex(term) == r"\dot{\Phi}_{n+1}"
    assert to_latex(term.body) == r"\Phi_{n+1}"


PLACES = SymbolTable.build(
    {
        **{name: {"kind": "vector"} for name in "vw"},
        **{name: {"kind": "scalar"} for name in "fg"},
        "A": {"kind": "tensor"},
        "u^{[1]}": {"kind": "vector"},
        r"\rho": {"kind": "vector", "coordinate": True},
    }
)


@pytest.mark.parametrize("sign", [r"\cdot", r"\times", r"\otimes"])
@pytest.mark.parametrize("factor", ["", "f ", "f g "])
@pytest.mark.parametrize(
    ("function", "takes_more"), [(r"\operatorname{curl} v", True), (r"\operatorname{vect} A", False)]
)
def test_a_function_by_place_is_bracketed_before_a_sign(
    sign: str, factor: str, function: str, takes_more: bool
) -> None:
    """curl v × w may be curl (v × w); vect A × w has one meaning."""
    before, behind = f"({factor}{function}) {sign} w", f"w {sign} ({factor}{function})"
    for latex, may_bracket in ((before, takes_more), (behind, False)):
        term = read_term(latex, PLACES)
        printed = to_latex(term)
        assert read_term(printed, PLACES) == term
        assert (r"\left(" in printed) == may_bracket


#: A power of what has an accent needs no bracket, but where the name has a superscript.
AS_PRINTED = [
    rf"{mark}{{{base}}}{sup}"
    for mark, bases in ((r"\dot", "vfA"), (r"\tilde", "v"), (r"\ddot", "wg"))
    for base in bases
    for sup in ("", "^{2}", "^{4}")
]


@pytest.mark.parametrize("latex", [*AS_PRINTED, r"\dot{u}^{[1]}", r"\left(\dot{u}^{[1]}\right)^{2}"])
def test_a_bracket_is_printed_only_where_it_says_something(latex: str) -> None:
    assert to_latex(read_term(latex, PLACES)) == latex


@pytest.mark.parametrize(
    "latex",
    [
        r"f = 0 \Rightarrow g = 0",
        r"f = 0 \Leftrightarrow g = 0",
        r"f \neq 0 \text{ and } g = 0 \text{ for } f = g",
        r"f \cdot g \times f \otimes g \circ f \approx \dot{f} + \tilde{g}",
        r"\forall n \geq 0",
        r"v \perp w",
        r"v \parallel w",
    ],
)
def test_a_tree_is_written_in_commands_that_read_as_the_tree(latex: str) -> None:
    written = latex_of(parse(latex))
    assert written.isascii() and parse(written) == parse(latex)


def test_the_reader_loads_on_use() -> None:
    code = "import sys, workbench.language; print(sorted(m for m in ('lark', 'sympy', 'pydrake') if m in sys.modules))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_square_bracket_after_a_family_member_is_a_product() -> None:
    product = read_term(r"\Phi_n [\omega + \mathbf{v}]", TABLE, VARIABLES)
    assert (product.type.kind, to_latex(product)) == ("vector", r"\Phi_{n} \left[\omega + \mathbf{v}\right]")
    applied = read_term(r"\Phi_n (\omega + \mathbf{v})", TABLE, VARIABLES)
    assert applied.type.kind == "tensor"


def test_words_between_statements() -> None:
    (implied,) = read(r"\omega = \mathbf{v} \text{ if } \alpha \neq 0", TABLE)
    assert to_latex(implied) == r"\alpha \neq 0 \Rightarrow \omega = \mathbf{v}"
    (both,) = read(r"\omega = \mathbf{v} \text{ if and only if } \alpha \neq 0", TABLE)
    assert to_latex(both) == r"\omega = \mathbf{v} \Leftrightarrow \alpha \neq 0"
    assert len(read(r"\omega = \mathbf{v} \text{ and } \alpha \neq 0", TABLE)) == 2


@pytest.mark.parametrize(
    ("stated", "lower", "upper"),
    [
        (r"n \geq 2", 2, None),
        ("n > 2", 3, None),
        (r"n \in \mathbb{N}", 0, None),
        (r"\forall n \in \mathbb{N}^*", 1, None),
        (r"n = \overline{1, 5}", 1, 5),
        (r"\mathbf{n} = \overline{1, 5}", 1, 5),
        (r"\boldsymbol{n} \in \mathbb{N}^*", 1, None),
    ],
)
def test_ranges(stated: str, lower: int, upper: int | None) -> None:
    (only,) = read_formula(rf"\Phi_n \omega = \mathbf{{v}}, {stated}", TABLE).ranges
    assert (only.variable, int(only.lower)) == ("n", lower)
    assert (None if only.upper is None else int(only.upper)) == upper

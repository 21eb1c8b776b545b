"""[symbols]: which name a spelling means, families and their weights, and what a bad entry gets."""

from __future__ import annotations

import pytest

from tests.language.chapter import PARTS
from tests.language.generated import TABLE
from workbench.core.formula_errors import ReadError, SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Apply, Symbol
from workbench.core.types import VECTOR, Declaration
from workbench.language.definition_entries import read_definitions
from workbench.language.naming.declarations import read_key
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term


def test_an_exact_name_goes_before_a_member_of_a_family() -> None:
    table = SymbolTable.build({r"a_n": {"kind": "vector"}, r"a_0": {"kind": "scalar"}})
    assert read_term("a_0", table).declaration.name == Name("a", sub=("0",))
    member = read_term("a_1", table)
    assert (member.declaration.name, str(member.index[0])) == (Name("a", sub=("", "")), "1")


@pytest.fixture(scope="module")
def paper_names() -> set[Name]:
    tables = [SymbolTable.build(part.symbols) for part in PARTS.values()]
    tables = [read_definitions(p.definitions, t)[1] for p, t in zip(PARTS.values(), tables, strict=True)]
    return {name for table in (*tables, TABLE) for name in (*table.symbols, *table.functions, *table.formals)}


@pytest.mark.parametrize(
    ("key", "use", "index"),
    [
        (r"\Phi_n", r"\Phi_{n+1}", ["n+1"]),
        (r"\mathbf{K}_{m,n}", r"\mathbf{K}_{2,n}", ["2", "n"]),
        (r"\mathbf{a}_\rho^{[n]}", r"\mathbf{a}^{[3]}_{\rho}", ["3"]),
        (r"\rho_{G_n}", r"\rho_{G_4}", ["4"]),
        (r"{}_0\underline{\omega}_m", r"{}_0\underline{\omega}_2", ["2"]),
        (r"{}^{k-1}\underline{\mathbf{R}}_k", r"{}^0\underline{\mathbf{R}}_1", ["0", "1"]),
        (r"\underline{\mathbf{R}}_k", r"\mathbf{\underline{R}}_{n-1}", ["n-1"]),
    ],
)
def test_families(key: str, use: str, index: list[str]) -> None:
    term = read_term(use, SymbolTable.build({key: {"kind": "vector"}}), {"n"})
    assert [str(i) for i in term.index] == index


@pytest.mark.parametrize(
    ("key", "weight", "use", "expected"),
    [
        (r"\Phi_n", "n", r"\Phi_3", "3"),
        (r"\Phi_n", "2n+1", r"\Phi_{n+1}", "2n+3"),
        (r"\mathbf{K}_{m,n}", "m", r"\mathbf{K}_{5,n}", "5"),
        (r"{}^{k-1}R_k", "k", r"{}^{2}R_{3}", "3"),
        (r"x_{n+1}", "n", r"x_4", "3"),
        (r"x", 2, "x", "2"),
        (r"x_n", -1, "x_7", "-1"),
    ],
)
def test_weights_of_members(key: str, weight: int | str, use: str, expected: str) -> None:
    table = SymbolTable.build({key: {"kind": "vector", "weight": weight}})
    assert str(read_term(use, table, {"n"}).weight) == expected


def test_a_name_is_read_back_as_it_is_shown(paper_names) -> None:
    for name in paper_names:
        assert read_key(str(name.without_arguments())) == (
            name.without_arguments(),
            tuple(Linear.variable("n") for _ in range(name.indices)),
        )
        member = name.at([Linear(k) for k in range(name.indices)])
        assert member.indices == 0 and (name.index_of(member) is not None) == (name.indices > 0)
        assert str(member) == name.shown(range(name.indices))


def test_symbols_made_of_different_terms_have_different_names() -> None:
    x, y = (Symbol(VECTOR, weight, Declaration(Name("x"), VECTOR)) for weight in (None, Linear(1)))
    names = {Name(r"\left(x\right)", of=(term,)) for term in (x, y)}
    assert len(names) == 2 and len({str(name) for name in names}) == 1


def test_fonts_are_symbols_of_their_own_unless_aliased() -> None:
    table = SymbolTable.build({r"\omega": {"kind": "vector", "aliases": [r"\boldsymbol{\omega}"]}})
    assert read_term(r"\boldsymbol{\omega}", table) == read_term(r"\omega", table)
    with pytest.raises(ReadError, match="unknown symbol"):
        read_term(r"\underline{\omega}", table)


def test_a_star_is_the_adjugate_unless_the_name_has_it() -> None:
    table = SymbolTable.build({r"\mathbf{a}^*": {"kind": "vector"}, r"\mathbf{S}": {"kind": "tensor"}})
    assert isinstance(read_term(r"\mathbf{a}^*", table), Symbol)
    adjugate = read_term(r"\mathbf{S}^*", table)
    assert isinstance(adjugate, Apply) and adjugate.head == "adjugate"


def test_a_table_is_never_changed() -> None:
    table = SymbolTable.build({"x": {"kind": "scalar"}})
    wider = table.with_specs({"y": {"kind": "vector"}})
    assert set(table.symbols) == {Name("x")}
    assert set(wider.symbols) == {Name("x"), Name("y")}


def test_a_mark_over_scripts_is_one_over_their_letter() -> None:
    for over, under in (
        (r"\vec{a_{cm}}", r"\vec{a}_{cm}"),
        (r"\hat{\mathbf{e_1}}", r"\hat{\mathbf{e}}_1"),
        (r"\vec{a_1}_2", r"\vec{a}_{1,2}"),
        (r"{C_D}_x", "C_{D,x}"),
    ):
        assert read_key(over) == read_key(under)
    with pytest.raises(SpecError):
        read_key(r"\vec{a_1}^b")


def test_the_letter_of_a_symbol_is_a_label_unless_an_index() -> None:
    kinds = {"m": "scalar", "T_m": "vector", "a_{cm_x}": "scalar", "I_{nm}": "scalar"}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    assert str(read_term("T_m", table).declaration.name) == "T_{m}"
    assert read_term("T_m", table).index == () and read_term("T_1", table).index == (Linear(1),)
    assert read_term("a_{cm_x}", table).index == ()
    assert read_term("I_{2m}", table).index == (Linear(2),)
    assert to_latex(read_term("m T_m + T_n", table, ["n"])) == "m T_{m} + T_{n}"


TILDES = {
    "x": "vector",
    r"\tilde{x}": "vector",
    r"\hat{x}": "vector",
    "y": "vector",
    "a_i": "scalar",
    r"\tilde{a}_i": "scalar",
    "R": "rotation",
    r"\tilde{R}": "rotation",
    r"\tilde{T}": "tensor",
}


@pytest.mark.parametrize(
    ("formula", "printed"),
    [
        (r"\tilde{x} = x - \hat{x}", r"\tilde{x} = x - \hat{x}"),
        (r"\operatorname{skew}(x) y = x \times y", r"\left(\operatorname{skew} x\right) y = x \times y"),
        (r"\operatorname{skew}(\dot{x}) y = \dot{x} \times y", r"\left(\operatorname{skew} \dot{x}\right) y = \dot{x} \times y"),
        (r"\tilde{\tilde{x}} y = \tilde{x} \times y", r"\tilde{\tilde{x}} y = \tilde{x} \times y"),
        (r"\tilde{y} \tilde{x} = y \times \tilde{x}", r"\tilde{y} \tilde{x} = y \times \tilde{x}"),
        (r"\tilde{a}_1 = a_1", r"\tilde{a}_{1} = a_{1}"),
        (r"\tilde{R} x = R^T \tilde{T} \tilde{y} x", r"\tilde{R} x = R^{T} \tilde{T} \tilde{y} x"),
        (r"\dot{\tilde{R}} = R^T \tilde{y}", r"\dot{\tilde{R}} = R^{T} \tilde{y}"),
    ],
)  # fmt: skip
def test_a_letter_with_a_tilde_may_be_a_symbol_of_its_own(formula, printed):
    table = SymbolTable.build({key: {"kind": kind} for key, kind in TILDES.items()})
    (statement,) = read(formula, table)
    assert to_latex(statement) == printed
    assert read(printed, table) == (statement,)


def test_a_tilde_over_a_known_vector_stays_its_skew_tensor():
    table = SymbolTable.build({"x": {"kind": "vector"}})
    with pytest.raises(SpecError, match="read as a skew tensor"):
        table.with_specs({r"\tilde{x}": {"kind": "vector"}})


def test_a_symbol_depends_on_symbols_only() -> None:
    specs = {"q": {"kind": "scalar"}, "f": {"kind": "scalar", "of": ["q", r"\dot{q}"]}}
    with pytest.raises(SpecError, match="expected one symbol") as error:
        SymbolTable.build(specs)
    assert error.value.key == "f"


def test_words_may_be_names_and_labels_keep_their_commas() -> None:
    specs = {r"\operatorname{Ad}_T": {"kind": "matrix 6×6"}, r"v_{\text{trans, max}}": {"kind": "matrix 6×1"}}
    table = SymbolTable.build(specs)
    assert read(r"Ad_T^T v_{\mathrm{trans,max}} = \text{Ad}_T^T(v_\text{trans, max})", table)
    for other in (r"v_{\text{transmax}}", r"\mathrm{Ad}_R v_{\text{trans,max}}"):
        with pytest.raises(ReadError, match="unknown symbol"):
            read(f"{other} = 0", table)


@pytest.mark.parametrize(
    "name", [r"\omega_{\mathcal{B}^{\ast}/\mathcal{N}}", r"\omega_{{\mathcal{B}}^*/\mathcal{N}}"]
)
def test_a_star_within_a_script_is_part_of_the_name(name: str) -> None:
    table = SymbolTable.build({r"\omega_{\mathcal{B}^*/\mathcal{N}}": {"kind": "vector"}})
    assert read(f"{name} = 2 {name}", table)
    with pytest.raises(ReadError, match="unknown symbol"):
        read(r"\omega_{\mathcal{B}/\mathcal{N}} = 0", table)


FLAGS = {"unit": "vector", "coordinate": "vector", "symmetric": "tensor", "diagonal": "tensor"}


@pytest.mark.parametrize(
    "flag", [*FLAGS, "constant", "uniform", "independent", "small", "positive", "free", "rotation", "dual"]
)
def test_a_function_of_others_is_free_and_nothing_else(flag):
    kind = {"rotation": "rotation", "dual": "dual scalar"}.get(flag, FLAGS.get(flag, "scalar"))
    spec = {"kind": kind, "of": ["q"]} | ({} if flag in kind else {flag: True})
    specs = {"q": {"kind": "scalar"}, "y": spec}
    if flag == "free":
        assert SymbolTable.build(specs).symbols[Name("y")].free
    else:
        with pytest.raises(SpecError, match=f"whose values are free, not for (a )?{flag}"):
            SymbolTable.build(specs)


@pytest.mark.parametrize("letter", ["I", "E"])
def test_an_undeclared_letter_of_unit_matrices_gets_a_hint(letter: str) -> None:
    with pytest.raises(ReadError, match=r"if it is the unit tensor, \[notation\] says so"):
        read(f"{letter} = {letter}", SymbolTable.build({"a": {"kind": "vector"}}))

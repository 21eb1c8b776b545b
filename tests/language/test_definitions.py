"""[definitions]: inferred types and weights, recurrences, function symbols, and what a circle gets."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from tests.language.reading_tables import tables
from workbench import check
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.integer_instances import instantiate
from workbench.core.terms import IllFormed, Symbol, Term
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition, read_definitions
from workbench.language.definitions import Definitions, expand
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term
from workbench.papers import load_paper

TABLE = tables()["defined"]
TENSORS = {
    r"\Phi_1": r"\tilde{\omega}",
    r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1",
    r"\mathbf{S}_1": r"\mathbf{0}",
    r"\mathbf{S}_{n+1}": r"\dot{\mathbf{S}}_n + \operatorname{sym}(\Phi_n \tilde{\omega})",
    r"\mathbf{t}_1": r"\omega",
    r"\mathbf{t}_{n+1}": r"\dot{\mathbf{t}}_n + \frac12 [(\operatorname{trace} \Phi_n) \mathbf{I} - \Phi_n^T] \omega",
    r"\mathbf{P}_1": r"\mathbf{I}",
    r"\mathbf{P}_{n+1}": r"\mathbf{D} \mathbf{P}_n + \mathbf{P}_n(\tilde{\omega})",
    r"\Psi_n": r"\mathbf{R}^{(n)} \mathbf{R}^T",
    r"\Theta_1(x)": r"\tilde{x}",
    r"\Theta_{n+1}(x)": r"\dot{\Theta}_n(x) + \Theta_n(x) \Theta_1(x)",
    r"\alpha": r"\omega^4 - 2 \dot{\omega}^2",
    r"\beta": r"\alpha^2 + \dot{\omega}^4",
}


def looked_up(latex: str, definitions: Definitions, table: SymbolTable) -> str:
    term = read_term(latex, table, {"n"})
    assert isinstance(term, Symbol)
    body = definitions.lookup(term)
    return "primitive" if body is None else to_latex(body)


@pytest.mark.parametrize(
    ("latex", "kind", "weight"),
    [
        (r"\Phi_3", "tensor", "3"),
        (r"\mathbf{S}_n", "tensor", "n"),
        (r"\mathbf{t}_{n+1}", "vector", "n+1"),
        (r"\mathbf{P}_3", "operator", "2"),
        (r"\Psi_n", "tensor", "n"),
        (r"\Theta_2(\mathbf{v})", "tensor", "2"),
        (r"\alpha", "scalar", "4"),
        (r"\beta", "scalar", "8"),
    ],
)
def test_types_and_weights_are_inferred(latex: str, kind: str, weight: str) -> None:
    table = read_definitions(TENSORS, TABLE)[1] if latex != r"\beta" else None
    if table is None:
        entries = {**TENSORS, r"\beta": r"\alpha^2 + \dot{\omega}^2 \omega^4"}
        table = read_definitions(entries, TABLE)[1]
    term = read_term(latex, table, {"n"})
    assert (term.type.kind, str(term.weight)) == (kind, weight)


def test_a_body_of_another_weight_is_rejected_with_its_position() -> None:
    with pytest.raises(IllFormedAt, match="8 and 4"):
        read_definitions({**TENSORS, r"\gamma": r"\alpha^2 + \dot{\omega}^2"}, TABLE)


ENTRIES = {key: body for key, body in TENSORS.items() if key != r"\beta"}


@pytest.mark.parametrize(
    ("latex", "body"),
    [
        (r"\omega", "primitive"),
        (r"\Phi_1", r"\tilde{\omega}"),
        (r"\Phi_3", r"\dot{\Phi}_{2} + \Phi_{2} \Phi_{1}"),
        (r"\Phi_n", "primitive"),
        (r"\Phi_{n+1}", r"\dot{\Phi}_{n} + \Phi_{n} \Phi_{1}"),
        (r"\Phi_{n+2}", r"\dot{\Phi}_{n+1} + \Phi_{n+1} \Phi_{1}"),
        (r"\mathbf{S}_1", r"\mathbf{0}_{3 \times 3}"),
        (r"\mathbf{P}_2", r"\mathbf{D} \mathbf{P}_{1} + \mathbf{P}_{1} \left[\tilde{\omega}\right]"),
        (r"\Psi_2", r"\ddot{\mathbf{R}} \mathbf{R}^{T}"),
        (r"\Psi_{n+3}", r"\mathbf{R}^{(n+3)} \mathbf{R}^{T}"),
        (r"\Theta_1(\mathbf{v})", r"\tilde{\mathbf{v}}"),
        (r"\Theta_1(\omega + \mathbf{v})", r"\widetilde{\omega + \mathbf{v}}"),
    ],
)
def test_lookup_takes_one_step(latex: str, body: str) -> None:
    definitions, table = read_definitions(ENTRIES, TABLE)
    assert looked_up(latex, definitions, table) == body


def test_lookup_gives_the_same_object_again() -> None:
    definitions, table = read_definitions(ENTRIES, TABLE)
    symbol = read_term(r"\Phi_5", table)
    assert definitions.lookup(symbol) is definitions.lookup(read_term(r"\Phi_5", table))


def test_lookup_below_the_base_is_an_error() -> None:
    definitions, table = read_definitions(ENTRIES, TABLE)
    member = instantiate(read_term(r"\Phi_n", table, {"n"}), {"n": 0})
    with pytest.raises(IllFormed, match=r"Phi_\{0\} is not defined; defined: .*Phi_\{1\}, .*Phi_\{n\+1\}"):
        definitions.lookup(member)
    with pytest.raises(ReadError, match=r"\\Phi_\{0\} is not defined; defined before it: \\Phi_\{1\}"):
        read_term(r"\Phi_0", table)


@pytest.mark.parametrize("order", [1, 2, 4])
def test_expand_agrees_with_steps_by_hand(order: int) -> None:
    """Φ_{n+1} expanded is (Φ_n expanded)' + (Φ_n expanded) ω̃."""
    definitions, table = read_definitions(ENTRIES, TABLE)
    lower, upper = (expand(read_term(rf"\Phi_{n}", table), definitions) for n in (order, order + 1))
    assert upper == read_term(
        f"({to_latex(lower)})^{{(1)}} + ({to_latex(lower)}) \\tilde{{\\omega}}", table
    ) or (order == 1 and to_latex(upper) == r"\dot{\tilde{\omega}} + \tilde{\omega} \tilde{\omega}")


def test_expansion_of_a_deep_recurrence_shares_its_parts() -> None:
    definitions, table = read_definitions(ENTRIES, TABLE)
    seen: set[int] = set()

    def visit(term: Term) -> None:
        if id(term) not in seen:
            seen.add(id(term))
            for child in term.children:
                visit(child)

    visit(expand(read_term(r"\Phi_{40}", table), definitions))
    assert len(seen) < 200


@pytest.mark.parametrize(("key", "error"), [("", "expected one symbol"), (r"\gamma", "nothing")])
def test_definitions_without_a_key_or_a_body_are_refused(key: str, error: str) -> None:
    with pytest.raises((ReadError, SpecError), match=error):
        read_definitions({key: "" if key else "1"}, TABLE)


def test_a_family_that_may_be_of_two_kinds_must_be_declared() -> None:
    entries = {r"Q_1": r"\mathbf{I}", r"Q_{n+1}": r"\mathbf{D} Q_n + Q_n(\tilde{\omega})"}
    with pytest.raises(SpecError, match="may be tensor or operator; declare it"):
        read_definitions(entries, TABLE)


def test_a_recurrence_with_a_factor_of_no_weight_has_no_weight() -> None:
    entries = {r"A_1": r"\tilde{\omega}", r"A_{n+1}": r"\mathbf{T} A_n"}
    table = read_definitions(entries, TABLE)[1]
    assert read_term("A_3", table).weight is None


def test_numbered_symbols_without_a_recurrence_keep_their_types() -> None:
    table = read_definitions({r"a_1": r"\omega", r"a_2": r"\tilde{\omega}"}, TABLE)[1]
    assert [read_term(f"a_{n}", table).type.kind for n in (1, 2)] == ["vector", "tensor"]


def test_one_definition_at_a_time_gives_what_all_together_give() -> None:
    table, alone = TABLE, []
    for key, body in ENTRIES.items():
        definition, table = read_definition(key, body, table)
        alone.append(definition)
    together, final = read_definitions(ENTRIES, TABLE)
    assert tuple(together) == tuple(alone)
    assert final == table


@pytest.mark.parametrize(
    ("entries", "latex", "indices"),
    [
        ({"J_l": r"\mathbf{I}"}, "J_l", 0),  # the left Jacobian: nothing in it depends on an l
        ({r"\boldsymbol{v}_p": "a + b"}, r"\boldsymbol{v}_p", 0),
        ({"x^i_j": "a"}, "x^i_j", 0),
        ({"F_n": "a^{(n)}"}, "F_3", 1),
        ({"F_1": "a", "F_{n+1}": r"\dot{F}_n"}, "F_2", 1),
        ({"F_n": "n a"}, "F_2", 1),
    ],
)
def test_a_letter_that_the_body_does_not_use_is_a_label(entries, latex, indices) -> None:
    table = SymbolTable.build({name: {"kind": "vector"} for name in "ab"})
    term = read_term(latex, read_definitions(entries, table)[1])
    assert isinstance(term, Symbol) and len(term.index) == indices


@pytest.mark.parametrize(("body", "indices"), [("Q f", 0), ("Q f_{in}", 0), ("f_i", 2), ("n f", 2)], ids=str)
def test_letters_unused_by_a_definition_are_a_label(tmp_path: Path, body: str, indices: int) -> None:
    """f_{in}, the f of the inertial frame."""
    (tmp_path / "p.md").write_text("$$ v_{in} = f $$")
    symbols = {"Q": "rotation", "f": "vector", "f_i": "vector", "f_{in}": "vector", "v_{in}": "vector"}
    lines = [f"'{name}' = '{kind}'" for name, kind in symbols.items()]
    model = ["source = 'p.md'", "[symbols]", *lines, "[definitions]", f"'v_{{in}}' = '{body}'"]
    (tmp_path / "p.toml").write_text("\n".join(model))
    table = load_paper(tmp_path / "p.toml").claims[0].notation.symbols
    assert len(read_term("v_{in}", table, "in").index) == indices


def test_a_member_defined_for_each_index_needs_no_range() -> None:
    kinds = {"a_n": "vector", "b_n": "vector", "R": "rotation"}
    found = check(r"a_k = R b_k", kinds, definitions=["b_n = R^T a_n"])
    assert found.holds and found.verdict.scope.startswith("all")
    assert check(r"a_k = R^T b_k", kinds, definitions=["b_n = R^T a_n"]).verdict.outcome is Outcome.REFUTED


def test_a_member_of_a_declared_family_stays_one() -> None:
    table = SymbolTable.build({"F_n": {"kind": "vector"}, "a": {"kind": "vector"}})
    definitions, table = read_definitions({"F_n": "a"}, table)
    assert definitions.lookup(read_term("F_3", table)) == read_term("a", table)


@pytest.mark.parametrize("scripts", ["_1", "_1^2", "_{12}^{2}", "_1^T", "'", "'^2", "_1'", "!", "_1!"])
def test_arguments_of_functions_have_superscripts_only(scripts: str) -> None:
    kinds = {"x": {"kind": "scalar"}, "a": {"kind": "vector"}, "T": {"kind": "tensor"}}
    _, table = read_definitions({"F(x)": "x^2", "G(a)": r"T \tilde{a}"}, SymbolTable.build(kinds))
    for value, power in (("F(x)", "2"), ("G(a)", "T")):
        assert read_term(f"{value}^{power}", table) == read_term(f"({value})^{power}", table)
        with pytest.raises(ReadError, match="scripts on the argument of a function"):
            read_term(f"{value}{scripts}", table)


@pytest.mark.parametrize(
    "spec", [{}, {"weight": 2}, {"constant": True}, {"uniform": True, "weight": 0}, {"free": True}]
)
def test_a_positive_symbol_is_the_square_of_a_similar_root(spec: dict) -> None:
    table = SymbolTable.build({"m_n": {"kind": "scalar", "positive": True} | spec})
    member = read_term("m_3", table)
    squared = Definitions().lookup(member)
    root = squared.base.declaration
    assert to_latex(squared) == r"{}_{\surd}m_{3}^{2}"
    assert (squared.weight, squared.base.weight, squared.base.index) == (None, None, member.index)
    assert root == replace(member.declaration, name=root.name, weight=None).with_flags(positive=False)
    assert Definitions().lookup(squared.base) is None


def test_the_letter_of_a_defining_symbol_is_a_label() -> None:
    kinds = {"f": "vector", "l": "vector", "f_l": "vector"}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    definition, after = read_definition("f_l", r"f + f \times l", table)
    assert (definition.declaration, definition.index) == (read_term("f_l", table).declaration, ())
    assert to_latex(Definitions([definition]).lookup(read_term("f_l", after))) == r"f + f \times l"


PI = r"\pi \neq 0"
QUARTER = (r"\cos\left(\frac{\pi}{2}\right) = 0", r"\sin\left(\frac{\pi}{2}\right) = 1")


@pytest.mark.parametrize(
    ("latex", "known"),
    [
        (r"\sin(s + \pi/2) = m", {r"m \neq 0", *QUARTER}),
        (r"\cos(s - 2 \pi) = \pi", {PI}),
        (r"\cos(s \pi) = s", {PI}),
        (r"\cos(-\pi/3 + s) = \cos s", {*QUARTER}),
        ("s = m s", {r"m \neq 0"}),
        ("s = s", set()),
    ],
)
def test_of_pi_and_of_what_is_positive_something_is_known(latex, known):
    table = SymbolTable.build({"s": {"kind": "scalar"}, "m": {"kind": "scalar", "positive": True}})
    (statement,) = read(latex, table)
    assert set(map(to_latex, Definitions().known_of(statement))) == known

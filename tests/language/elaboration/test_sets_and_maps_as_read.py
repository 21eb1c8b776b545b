"""Sets and maps with a name: what is said of them, what must be true for it, what is given, and what is not decided."""

from __future__ import annotations

import pytest

from workbench.core.construct import apply, relation, symbol, zero
from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.core.types import Declaration
from workbench.language.elaboration.sets import members_of
from workbench.language.grammar.parser import parse

TENSORS = r"L(\mathbf{V}_3, \mathbf{V}_3)"
OF_DUALS = r"\mathbf{L}(\underline{\mathbf{V}}_3, \underline{\mathbf{V}}_3)"
MATRICES = r"\mathcal{M}_{2 \times 5}(\mathbb{R})"


@pytest.mark.parametrize(
    ("spelt", "name", "kind", "trait"),
    [
        (r"\mathbb{R}", r"\mathbb{R}", "scalar", ""),
        (r"\underline{\mathbb{R}}", r"\underline{\mathbb{R}}", "dual scalar", ""),
        (r"\mathbf{V}_3", r"\mathbf{V}_{3}", "vector", ""),
        (r"\mathbf{V}", r"\mathbf{V}", "vector", ""),
        (r"\mathbf{V}_3^{\mathbb{R}}", r"\mathbf{V}_{3}^{\mathbb{R}}", "vector", ""),
        (r"\underline{\mathbf{V}}_3", r"\underline{\mathbf{V}}_{3}", "dual vector", ""),
        (r"E_3", "E_{3}", "vector", ""),
        (r"\mathbb{R}^3", r"\mathbb{R}^{3}", "vector", ""),
        (r"\mathbb{R}^1", r"\mathbb{R}^{1}", "scalar", ""),
        (r"\mathbb{R}^{12}", r"\mathbb{R}^{12}", "matrix 12×1", ""),
        (r"\mathbb{R}^{6 \times 7}", r"\mathbb{R}^{6 \times 7}", "matrix 6×7", ""),
        (r"SO(3)", "SO(3)", "tensor", "rotation"),
        (r"\mathbf{SO}_3", r"\mathbf{SO}_{3}", "tensor", "rotation"),
        (r"\underline{SO}_3", r"\underline{SO}_{3}", "dual tensor", "rotation"),
        (r"\mathfrak{so}_3", r"\mathfrak{so}_{3}", "tensor", "skew"),
        (r"\mathbb{S}^2", r"\mathbb{S}^{2}", "vector", "unit"),
        (r"SE(3)", "SE(3)", "matrix 4×4", "displacement"),
        (TENSORS, r"L(\mathbf{V}_{3}, \mathbf{V}_{3})", "tensor", ""),
        (OF_DUALS, r"L(\underline{\mathbf{V}}_{3}, \underline{\mathbf{V}}_{3})", "dual tensor", ""),
        (MATRICES, MATRICES, "matrix 2×5", ""),
        (
            r"\mathcal{M}_{3 \times 3}(\underline{\mathbb{R}})",
            r"\mathcal{M}_{3 \times 3}(\underline{\mathbb{R}})",
            "dual tensor",
            "",
        ),
    ],
)
def test_the_members_of_each_set(spelt: str, name: str, kind: str, trait: str) -> None:
    ((node,),) = parse(spelt).lines
    members = members_of(node)
    assert (members.name, str(members.type), members.trait) == (name, kind, trait)
    letter = members.letter(Name("a"))
    flags = {"unit": letter.unit, "rotation": letter.rotation, "displacement": letter.transform}
    assert letter.constant and letter.type == members.type
    assert {flag for flag, has in flags.items() if has} == {trait} - {"", "skew"}


@pytest.mark.parametrize(
    "spelt",
    [
        "Q",
        r"\mathbb{R}^0",
        r"\mathbb{R}^{n}",
        r"\mathbf{V}_4",
        "SO(2)",
        r"\mathbb{S}^3",
        r"\mathcal{M}_{0 \times 3}(\mathbb{R})",
        r"\mathcal{M}_{11 \times 10}(\mathbb{R})",
        r"\mathcal{M}_{2 \times 3}(\mathbf{V}_3)",
        r"\mathcal{M}_{2}(\mathbb{R})",
        r"L(\mathbf{V}_3, \mathbb{R})",
        r"L(\mathbf{V}_3)",
        r"K(\mathbf{V}_3, \mathbf{V}_3)",
    ],
)
def test_unknown_sets_are_rejected(spelt: str) -> None:
    ((node,),) = parse(spelt).lines
    try:
        assert members_of(node) is None
    except Fault as refused:
        assert "expected a set" in str(refused)


@pytest.mark.parametrize("dual", [False, True])
@pytest.mark.parametrize("spelt", [r"\mathbf{V}_3", r"\mathbb{R}", TENSORS])
def test_a_dual_member_of_a_real_set_has_no_dual_part(spelt: str, dual: bool) -> None:
    ((node,),) = parse(spelt).lines
    members = members_of(node)
    term = symbol(Declaration(Name("a"), members.type.with_dual(dual)))
    conditions = members.conditions(term)
    assert conditions == ([relation("=", apply("du", term), zero(members.type))] if dual else [])

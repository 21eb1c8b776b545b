"""Sets and maps with a name: what is said of them, what must be true for it, what is given, and what is not decided."""

from __future__ import annotations

import pytest

from tests.language.as_read import TABLE, reads
from workbench import check
from workbench.core.construct import apply, relation, symbol, zero
from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.core.types import Declaration
from workbench.core.verdict import Outcome
from workbench.language.elaboration.sets import members_of
from workbench.language.grammar.parser import parse
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_formula


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (
            r"S = \{ a \in \mathbf{V}_3 \mid a \cdot y = 0 \}",
            r"S = \{ a \mid a \in \mathbf{V}_{3}, a \cdot y = 0 \} | parts  | given a \cdot y = 0 | ",
        ),
        (
            r"S = \{ a \mid a \in \mathbf{V}_3, a \cdot y = 0 \}",
            r"S = \{ a \mid a \in \mathbf{V}_{3}, a \cdot y = 0 \} | parts  | given a \cdot y = 0 | ",
        ),
        (r"S = \{ a \mid a \cdot y = 0 \}", r"refused 8: unknown symbol a"),
        (
            r"S = \{ a = y \mid a \in \mathbf{V}_3 \}",
            r"refused 8: expected a member first, as in \{ x \in V_3 \mid x",
        ),
        (
            r"S = \{ a + b \mid a, b \in \mathbf{V}_3 \}",
            r"S = \{ a + b \mid a \in \mathbf{V}_{3}, b \in \mathbf{V}_{3} \} | parts  | given  | ",
        ),
        (
            r"S = \{ a + b \mid a \in \mathbf{V}_3, b \in \mathbb{S}^2 \}",
            r"S = \{ a + b \mid a \in \mathbf{V}_{3}, b \in \mathbb{S}^{2} \} | parts  | given  | ",
        ),
        (r"S = \{ a \in Q \mid a = y \}", r"refused 14: the set Q is not known here"),
        (
            r"S = \{ x \in \mathbf{V}_3 \mid x \cdot y = 0 \}",
            r"S = \{ x \mid x \in \mathbf{V}_{3}, x \cdot y = 0 \} | parts  | given x \cdot y = 0 | ",
        ),
        (
            r"S = \{ x \mid y \in \mathbf{V}_3, x \cdot y = 0 \}",
            r"S = \{ x \mid y \in \mathbf{V}_{3}, x \cdot y = 0 \} | parts  | given x \cdot y = 0 | ",
        ),
        (
            r"S = \{ a \in \mathbf{V}_3 \mid \lambda = 0 \}",
            r"S = \{ a \mid a \in \mathbf{V}_{3}, \lambda = 0 \} | parts \lambda = 0 | given  | ",
        ),
        (
            r"S = \{ a \in \mathbf{V}_3 \mid \lambda = 0, a \cdot y = 0 \}",
            r"S = \{ a \mid a \in \mathbf{V}_{3}, \lambda = 0, a \cdot y = 0 \} | parts \lambda = 0 | given a \cdot y = 0 | ",
        ),
        (
            r"S = \{ a \in \mathbf{V}_3 \mid x \cdot y = 0 \Rightarrow a \cdot y = 0 \}",
            r"refused 46: unexpected ⇒",
        ),
        (
            r"\mathbb{S}^2 = \{ a \in \mathbf{V}_3 \mid a \cdot a = 1 \}",
            r"\mathbb{S}^{2} = \{ a \mid a \in \mathbf{V}_{3}, a \cdot a = 1 \} | parts  | given a \cdot a = 1 | ",
        ),
        (
            r"\mathbb{S}^2 = \{ a \in \mathbf{V}_3 \mid a \cdot a = 2 \}",
            r"\mathbb{S}^{2} = \{ a \mid a \in \mathbf{V}_{3}, a \cdot a = 2 \} | parts a \cdot a = 2 \Rightarrow a \cdot a = 1; a \cdot a = 1 \Rightarrow a \cdot a = 2 | given a \cdot a = 2 | ",
        ),
        (
            r"\mathbf{V}_3 = \{ a \mid a \in \mathbb{S}^2 \}",
            r"\mathbf{V}_{3} = \{ a \mid a \in \mathbb{S}^{2} \} | parts  | given  | whether all members of \mathbf{V}_{3} are so is not decided",
        ),
        (
            r"SO(3) = \{ M \in \mathbf{L}(\mathbf{V}_3, \mathbf{V}_3) \mid M M^T = \mathbf{I}, \det M = 1 \}",
            r"SO(3) = \{ M \mid M \in L(\mathbf{V}_{3}, \mathbf{V}_{3}), M M^{T} = \mathbf{I}, \det M = 1 \} | parts  | given M M^{T} = \mathbf{I}; \det M = 1 | ",
        ),
        (
            r"SO(3) = \{ M \in \mathbf{L}(\mathbf{V}_3, \mathbf{V}_3) \mid M M^T = \mathbf{I} \}",
            r"SO(3) = \{ M \mid M \in L(\mathbf{V}_{3}, \mathbf{V}_{3}), M M^{T} = \mathbf{I} \} | parts M M^{T} = \mathbf{I} \Rightarrow \det M = 1 | given M M^{T} = \mathbf{I} | ",
        ),
        (
            r"\underline{\mathbf{V}}_3 = \{ a + \varepsilon b \mid a, b \in \mathbf{V}_3 \}",
            r"\underline{\mathbf{V}}_{3} = \{ a + \varepsilon b \mid a \in \mathbf{V}_{3}, b \in \mathbf{V}_{3} \} | parts  | given  | ",
        ),
        (
            r"\underline{\mathbf{V}}_3 = \{ a + \varepsilon a \mid a \in \mathbf{V}_3 \}",
            r"\underline{\mathbf{V}}_{3} = \{ a + \varepsilon a \mid a \in \mathbf{V}_{3} \} | parts  | given  | whether all members of \underline{\mathbf{V}}_{3} are so is not decided",
        ),
        (
            r"\underline{\mathbf{V}}_3 = \{ a + \varepsilon x \mid a \in \mathbf{V}_3 \}",
            r"\underline{\mathbf{V}}_{3} = \{ a + \varepsilon x \mid a \in \mathbf{V}_{3} \} | parts  | given  | whether all members of \underline{\mathbf{V}}_{3} are so is not decided",
        ),
        (
            r"\underline{\mathbf{V}}_3 = \{ a + \varepsilon b \mid a, b \in \mathbf{V}_3, a \cdot b = 0 \}",
            r"\underline{\mathbf{V}}_{3} = \{ a + \varepsilon b \mid a \in \mathbf{V}_{3}, b \in \mathbf{V}_{3}, a \cdot b = 0 \} | parts  | given a \cdot b = 0 | whether all members of \underline{\mathbf{V}}_{3} are so is not decided",
        ),
        (
            r"\underline{\mathbf{V}}_3 = \{ 2 a \mid a \in \mathbf{V}_3 \}",
            r"\underline{\mathbf{V}}_{3} = \{ 2 a \mid a \in \mathbf{V}_{3} \} | parts  | given  | whether all members of \underline{\mathbf{V}}_{3} are so is not decided",
        ),
        (
            r"\mathbb{S}^2 = \{ \lambda \mid a \in \mathbf{V}_3 \}",
            r"misfit 19: a member of \mathbb{S}^{2} is a vector; here it is",
        ),
        (
            r"SE(3) = \{ \begin{bmatrix} M & a \\ 0 & 1 \end{bmatrix} \mid M \in SO(3), a \in \mathbf{V}_3 \}",
            r"SE(3) = \{ \begin{bmatrix} M & a \\ \mathbf{0} & 1 \end{bmatrix} \mid M \in SO(3), a \in \mathbf{V}_{3} \} | parts  | given  | whether all members of SE(3) are so is not decided",
        ),
        (
            r"SE(3) = \{ \begin{bmatrix} M & a \\ 0 & 2 \end{bmatrix} \mid M \in SO(3), a \in \mathbf{V}_3 \}",
            r"refused 12: a displacement that is not written as [R p; 0 1]",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, f(a) = a \times y",
            r"f : \mathbf{V}_{3} \to \mathbf{V}_{3}, f(a) = a \times y | parts  | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, a \mapsto a \times y",
            r"f : \mathbf{V}_{3} \to \mathbf{V}_{3}, a \mapsto a \times y | parts  | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbb{S}^2, a \mapsto a \times y",
            r"f : \mathbf{V}_{3} \to \mathbb{S}^{2}, a \mapsto a \times y | parts \left(a \times y\right) \cdot \left(a \times y\right) = 1 | given  | ",
        ),
        (
            r"f : \mathbb{S}^2 \to \mathbb{S}^2, a \mapsto -a",
            r"f : \mathbb{S}^{2} \to \mathbb{S}^{2}, a \mapsto -a | parts \left(-a\right) \cdot \left(-a\right) = 1 | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbb{R}, a \mapsto a \times y",
            r"misfit 44: a member of \mathbb{R} is a scalar; here it is a v",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, g(a) = a \times y",
            r"refused 36: a map is said by f : A \to B and f(x) = …, or by x",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3",
            r"refused 1: a map is said by f : A \to B and f(x) = …, or by x",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, a = y",
            r"refused 36: a map is said by f : A \to B and f(x) = …, or by x",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3 \to \mathbf{V}_3, a \mapsto a",
            r"refused 1: a map is said by f : A \to B and f(x) = …, or by x",
        ),
        (
            r"f^{-1} : \mathbf{V}_3 \to \mathbf{V}_3, f^{-1}(a) = a",
            r"f^{-1} : \mathbf{V}_{3} \to \mathbf{V}_{3}, f^{-1}(a) = a | parts  | given  | ",
        ),
        (
            r"f^{-1} : \mathbf{V}_3 \to \mathbf{V}_3, f(a) = a",
            r"refused 41: a map is said by f : A \to B and f(x) = …, or by x",
        ),
        (
            r"f^{2} : \mathbf{V}_3 \to \mathbf{V}_3, f^2(a) = a",
            r"refused 1: expected the name of a map, such as f",
        ),
        (
            r"2 : \mathbf{V}_3 \to \mathbf{V}_3, a \mapsto a",
            r"refused 1: expected the name of a map, such as f",
        ),
        (
            r"\mathbf{V}_3 \to \mathbf{V}_3, a \mapsto a",
            r"\mathbf{V}_{3} \to \mathbf{V}_{3}, a \mapsto a | parts  | given  | ",
        ),
        (r"x \mapsto x \times y", r"x \mapsto x \times y | parts  | given  | "),
        (r"a \mapsto a \times y", r"refused 1: of which set? write f : A \to B, x \mapsto …"),
        (r"f : x \mapsto x \times y", r"f : x \mapsto x \times y | parts  | given  | "),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, x \mapsto x \times y",
            r"f : \mathbf{V}_{3} \to \mathbf{V}_{3}, x \mapsto x \times y | parts  | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, A \mapsto x",
            r"misfit 36: a member of \mathbf{V}_{3} is a vector; here it is",
        ),
        (
            r"f : SO(3) \to SO(3), M \mapsto M^T",
            r"f : SO(3) \to SO(3), M \mapsto M^{T} | parts M^{T} \left[M^{T}\right]^{T} = \mathbf{I}; \det\left(M^{T}\right) = 1 | given  | ",
        ),
        (
            r"f : SO(3) \to \mathfrak{so}_3, M \mapsto M",
            r"f : SO(3) \to \mathfrak{so}_{3}, M \mapsto M | parts M^{T} = -M | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathfrak{so}_3, a \mapsto \tilde{a}",
            r"f : \mathbf{V}_{3} \to \mathfrak{so}_{3}, a \mapsto \tilde{a} | parts  | given  | ",
        ),
        (
            r"f : \mathfrak{so}_3 \to \mathbf{V}_3, M \mapsto \operatorname{vect} M",
            r"f : \mathfrak{so}_{3} \to \mathbf{V}_{3}, M \mapsto \operatorname{vect} M | parts  | given M^{T} = -M | ",
        ),
        (r"f : \mathbf{V}_3 \to Q, a \mapsto a", r"refused 22: the set Q is not known here"),
        (
            r"f : \mathbf{V}_3 \to \underline{\mathbf{V}}_3, a \mapsto a",
            r"f : \mathbf{V}_{3} \to \underline{\mathbf{V}}_{3}, a \mapsto a | parts  | given  | ",
        ),
        (
            r"f : \underline{\mathbf{V}}_3 \to \mathbf{V}_3, \underline{a} \mapsto \underline{a}",
            r"f : \underline{\mathbf{V}}_{3} \to \mathbf{V}_{3}, \underline{a} \mapsto \underline{a} | parts \operatorname{Du} \underline{a} = \mathbf{0} | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathcal{M}_{2 \times 3}(\mathbb{R}), a \mapsto J",
            r"misfit 70: a member of \mathcal{M}_{2 \times 3}(\mathbb{R}) i",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathcal{M}_{6 \times 7}(\mathbb{R}), a \mapsto J",
            r"f : \mathbf{V}_{3} \to \mathcal{M}_{6 \times 7}(\mathbb{R}), a \mapsto J | parts  | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{L}(\mathbf{V}_3, \mathbf{V}_3), a \mapsto \tilde{a}",
            r"f : \mathbf{V}_{3} \to L(\mathbf{V}_{3}, \mathbf{V}_{3}), a \mapsto \tilde{a} | parts  | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{L}(\mathbf{V}_3, \mathbb{R}), a \mapsto \tilde{a}",
            r"refused 22: expected a set, such as \mathbb{N} or \mathbf{V}_3",
        ),
        (r"f : SE(3) \to SE(3), M \mapsto M", r"f : SE(3) \to SE(3), M \mapsto M | parts  | given  | "),
        (
            r"f : SO(3) \to SE(3), M \mapsto \begin{bmatrix} M & x \\ 0 & 1 \end{bmatrix}",
            r"f : SO(3) \to SE(3), M \mapsto \begin{bmatrix} M & x \\ \mathbf{0} & 1 \end{bmatrix} | parts  | given  | ",
        ),
        (
            r"f : SO(3) \to SE(3), M \mapsto \begin{bmatrix} M^T & x \\ 0 & 1 \end{bmatrix}",
            r"f : SO(3) \to SE(3), M \mapsto \begin{bmatrix} M^{T} & x \\ \mathbf{0} & 1 \end{bmatrix} | parts M^{T} \left[M^{T}\right]^{T} = \mathbf{I}; \det\left(M^{T}\right) = 1 | given  | ",
        ),
        (
            r"f : \mathbf{V}_3 \to \mathbf{V}_3, a \mapsto \{ b \in \mathbf{V}_3 \mid b = a \}",
            r"misfit 46: the values of the map are sets, and its codomain i",
        ),
    ],
)
def test_sets_and_maps(latex: str, expected: str) -> None:
    if expected.startswith(("refused", "misfit")):
        reads(latex, expected)
        return
    (naming,) = read_formula(latex, TABLE).statements
    parts, given = ("; ".join(map(to_latex, each)) for each in (naming.parts, naming.given))
    assert f"{naming.said} | parts {parts} | given {given} | {naming.undecided or ''}" == expected


@pytest.mark.parametrize(
    ("known", "domain", "outcome"),
    [
        (r"\mathbf{V}_3", r"\mathbf{V}_3", Outcome.DEFINITION),
        (r"\mathbf{V}_3", r"\mathbb{S}^2", Outcome.UNCHECKED),
        (r"\mathbf{V}_3", r"\underline{\mathbf{V}}_3", Outcome.REFUTED),
        (r"\underline{\mathbf{V}}_3", r"\mathbf{V}_3", Outcome.UNCHECKED),
        (r"\mathbb{S}^2", r"\mathbb{S}^2", Outcome.DEFINITION),
        (r"\mathbb{S}^2", r"\mathbf{V}_3", Outcome.REFUTED),
        (r"SO(3)", r"SO(3)", Outcome.DEFINITION),
        (r"SO(3)", r"\mathfrak{so}_3", Outcome.REFUTED),
        (r"L(\mathbf{V}_3, \mathbf{V}_3)", r"SO(3)", Outcome.UNCHECKED),
        (r"L(\mathbf{V}_3, \mathbf{V}_3)", r"\mathfrak{so}_3", Outcome.REFUTED),
        (r"\mathfrak{so}_3", r"\mathfrak{so}_3", Outcome.DEFINITION),
        (r"\mathfrak{so}_3", r"SO(3)", Outcome.REFUTED),
        (r"\mathfrak{so}_3", r"L(\mathbf{V}_3, \mathbf{V}_3)", Outcome.REFUTED),
        (r"SE(3)", r"SE(3)", Outcome.DEFINITION),
    ],
)
def test_a_set_has_all_members_of_another_only_if_equal(known: str, domain: str, outcome: Outcome) -> None:
    assert check(rf"{known} = \{{ M \mid M \in {domain} \}}", {"x": "vector"}).verdict.outcome == outcome


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

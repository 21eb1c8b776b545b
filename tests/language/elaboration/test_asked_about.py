"""Products, brackets and powers that field readers take in two ways: read where one of them fits, else asked about."""

from __future__ import annotations

from pathlib import Path

import pytest
from language.field_kinds import KINDS, TABLE

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term
from workbench.papers import load_notation


def test_a_star_on_a_column_is_not_the_adjugate() -> None:
    with pytest.raises(ReadError, match="declare the symbol with it"):
        read(r"a^* = b", TABLE)


@pytest.mark.parametrize("row", [r"a \: b \: c", "a b c", r"a ~ b"])
def test_vectors_side_by_side_in_a_bracket_raise_a_question(row: str) -> None:
    with pytest.raises(ReadError, match="columns or a triple product"):
        read(f"T = [{row}]", TABLE)


def test_stacked_vectors_that_form_a_matrix_raise_a_question() -> None:
    with pytest.raises(ReadError, match="the rows of a matrix"):
        read(r"T = \begin{bmatrix} a \\ b \\ c \end{bmatrix}", TABLE)
    assert read(r"T = \begin{bmatrix} a^T \\ b^T \\ c^T \end{bmatrix}", TABLE)


@pytest.mark.parametrize(
    "formula", [r"e a^2 = -(a \cdot a) e", r"a^2 e = e", "a b = 0", "a b e = e", "a^3 = 0", "2 a^2 e = e"]
)
def test_vectors_that_may_be_quaternions_raise_a_question(formula: str) -> None:
    """The square of a quaternion (0, a) is −a·a, that of a vector a·a."""
    table = TABLE.with_specs({"e": {"kind": "hamilton quaternion"}})
    with pytest.raises(ReadError, match="write"):
        read(formula, table)
    assert read(r"e a a = -(a \cdot a) e", table) and read(r"a^2 = a \cdot a", table)


def test_the_inverse_of_a_column_of_four_needs_quaternions() -> None:
    column = r"\begin{bmatrix} s \\ a \end{bmatrix}^{-1}"
    table = TABLE.with_specs({"e": {"kind": "hamilton quaternion"}})
    assert read_term(column, table) == read_term(r"(\operatorname{quat}(s, a))^{-1}", table)
    with pytest.raises(IllFormedAt, match="the inverse of a matrix 4×1"):
        read_term(column, TABLE)
    three = read_term(r"\begin{bmatrix} s \\ s \\ s \end{bmatrix}^{-2}", table)
    assert three.type.kind == "scalar"


@pytest.mark.parametrize("name", ["atan2", "arctan2"])
def test_arcs_of_two(name: str) -> None:
    assert read_term(rf"\mathrm{{{name}}}(s, \alpha)", TABLE).head == "atan2"


def test_the_frobenius_norm() -> None:
    assert read_term(r"\|S T\|_F", TABLE) == read_term(r"\sqrt{\operatorname{tr}((S T)^T (S T))}", TABLE)
    for other in (r"\|T\|_2", r"\|a\|_1", r"\|T\|_G"):
        with pytest.raises(ReadError, match="a subscript on an expression"):
            read_term(other, TABLE)


def test_a_bracket_that_may_be_an_argument_raises_a_question() -> None:
    for formula in (r"T(a) b = c", r"T(a, b) c = c"):
        with pytest.raises(ReadError, match="bracket"):
            read(formula, TABLE)
    with pytest.raises(IllFormedAt):
        read("T(a + b) b = c", TABLE)


def test_the_exponential_of_a_vector_raises_a_question() -> None:
    with pytest.raises(ReadError, match="of its skew tensor, or of a quaternion"):
        read(r"T = e^{a}", TABLE)


@pytest.mark.parametrize(
    ("dyad", "meant"),
    [
        (r"a b \cdot c", r"a (b \cdot c)"),
        (r"a \cdot b c", r"(a \cdot b) c"),
        (r"2 s a b \cdot c", r"(2 s a) (b \cdot c)"),
        (r"a \cdot b c s", r"(a \cdot b) (c s)"),
        (r"a a \cdot \dot{a} \|a\|", r"a (a \cdot (\dot{a} \|a\|))"),
    ],
)
def test_a_dyad_of_vectors_before_or_behind_a_dot(dyad: str, meant: str) -> None:
    term = read_term(dyad, TABLE)
    assert read_term(to_latex(term), TABLE) == term == read_term(meant, TABLE)


@pytest.mark.parametrize(
    "formula", [r"a b \times c", r"a b \cdot T", r"a b c \cdot u", r"a s b \cdot c", r"a b"]
)
def test_no_other_product_of_vectors_is_one(formula: str) -> None:
    with pytest.raises((IllFormedAt, ReadError)):
        read(f"{formula} = a", TABLE)


@pytest.mark.parametrize(
    "formula",
    [r"\operatorname{tr} s T = 0", r"\det 2 T = 8 \det T", r"\operatorname{skew} s a = s \tilde{a}"],
)
def test_a_tensor_function_after_a_number_raises_a_question(formula: str) -> None:
    with pytest.raises(ReadError, match="how far does"):
        read(formula, TABLE)


@pytest.mark.parametrize("formula", [r"2 s \times 3 s = 6 s^2", r"s \times \alpha = \alpha s"])
def test_a_cross_between_numbers_raises_a_question(formula: str) -> None:
    with pytest.raises(ReadError, match="product, write"):
        read(formula, TABLE)
    with pytest.raises(IllFormedAt):
        read(r"s \times a = s a", TABLE)


@pytest.mark.parametrize(
    ("bare", "bold"),
    [
        (r"0 \times a = 0", r"\mathbf{0} \times a = 0"),
        (r"a \otimes 0 = 0", r"a \otimes \mathbf{0} = 0"),
        (r"(a, 0, b) = 0", r"(a, \mathbf{0}, b) = 0"),
        (r"\tilde{0} = 0", r"\widetilde{\mathbf{0}} = 0"),
    ],
)
def test_a_bare_zero_among_vectors_is_one(bare: str, bold: str) -> None:
    assert read(bare, TABLE) == read(bold, TABLE)
    with pytest.raises(IllFormedAt):
        read(r"s \otimes a = 0", TABLE)


@pytest.mark.parametrize("formula", ["H 0 = a", "H (H 0) = 0", "s = s + a \\cdot (H 0)"])
def test_a_transform_of_a_bare_zero_raises_a_question(tmp_path: Path, formula: str) -> None:
    """The origin goes to the translation, and no point to the zero."""
    symbols = "".join(f"{name} = {{ kind = '{KINDS.get(name, 'transform')}' }}\n" for name in "Has")
    (tmp_path / "n.toml").write_text(f"[conventions]\npoints = 'vectors'\n[symbols]\n{symbols}")
    table = load_notation(tmp_path / "n.toml").symbols
    with pytest.raises(ReadError, match="a point or a direction"):
        read(formula, table)
    assert read("H a = a", table) and read("H^{-1} H = \\mathbf{I}_{4 \\times 4}", table)


@pytest.mark.parametrize(
    ("function", "alone"),
    [
        (r"s(\alpha) = 0", "s = 0"),
        (r"s^2(\alpha) = s(\alpha)^2", "s^2 = s^2"),
        (r"a(\alpha) s(\alpha) = a", "a s = a"),
        (r"\dot{s}(\alpha) = \sin(\alpha) s(\alpha)", r"\dot{s} = (\sin\alpha) s"),
        (r"s[\alpha] = \beta", r"s \alpha = \beta"),
    ],
)
def test_a_scalar_of_what_is_declared_an_argument_is_no_product(
    tmp_path: Path, function: str, alone: str
) -> None:
    (tmp_path / "n.toml").write_text("[conventions]\narguments = ['\\alpha']\n")
    table = load_notation(tmp_path / "n.toml").symbols.with_specs(
        {name: {"kind": kind} for name, kind in KINDS.items()}
    )
    assert read(function, table) == read(alone, table)
    with pytest.raises(ReadError, match="or a product"):
        read(function.replace(r"(\alpha)", r"(\beta)").replace(r"[\alpha]", r"(\beta)"), table)


@pytest.mark.parametrize(
    "formula", [r"s^2 = s s \qquad (2)", r"(2.1) \quad s^2 = s s", r"s^2 = (s + 0) \quad [A.3b]."]
)
def test_the_number_of_a_formula_is_no_factor(formula: str) -> None:
    with pytest.raises(ReadError, match="the number of the formula"):
        read(formula, TABLE)
    assert read(r"s^2 = s (2 s - s) \quad", TABLE) and read(r"s = 2 \quad [s]", TABLE)


@pytest.mark.parametrize("above", ["d", r"\mathrm{d}"])
@pytest.mark.parametrize("below", ["d", r"\mathrm{d}"])
@pytest.mark.parametrize("time", ["t", r"\mathrm{t}"])
def test_a_slanted_d_that_is_a_symbol_may_be_a_factor(above: str, below: str, time: str) -> None:
    """Of df/dg either d is enough; df/dt is a derivative all the same, unless t is a letter of the paper."""
    plain, table = (
        SymbolTable.build({name: {"kind": "scalar"} for name in names}) for names in ("fg", "fgd")
    )
    by_g, by_time = rf"\frac{{{above} f}}{{{below} g}}", rf"\frac{{{above} f}}{{{below} {time}}}"
    assert read_term(by_g, plain).head == "total"
    assert read_term(by_time, plain) == read_term(by_time, table) == read_term(r"\dot{f}", plain)
    if "d" in (above, below):
        with pytest.raises(ReadError, match="or a quotient of products with d"):
            read_term(by_g, table)
    else:
        assert read_term(by_g, table) == read_term(by_g, plain)
    if (above, below, time) == ("d", "d", "t"):
        with pytest.raises(ReadError, match="a derivative, or a quotient of the symbols d and t"):
            read_term(by_time, table, {"t"})
    else:
        assert read_term(by_time, table, {"t"}) == read_term(r"\dot{f}", plain)


BRACKETS = [
    ("(", ")"),
    ("[", "]"),
    (r"\{", r"\}"),
    (r"\langle", r"\rangle"),
    ("{", "}"),
    (r"\|", r"\|"),
    ("|", "|"),
]


@pytest.mark.parametrize("sides", BRACKETS)
@pytest.mark.parametrize("below", ["2", "F", "1", r"\infty", "{22}", r"{\mathrm{F}}"])
@pytest.mark.parametrize("inside", ["a + b", "T", "s"])
def test_of_the_norms_the_euclidean_ones_are_read(sides: tuple[str, str], below: str, inside: str) -> None:
    left, right = sides
    norm = rf"{left} {inside} {right}_{below}"
    if "|" in left and (inside, below) in (("a + b", "2"), ("T", "F")):
        meant = r"\|a + b\|" if below == "2" else r"\sqrt{\operatorname{tr} T^T T}"
        assert read_term(norm, TABLE) == read_term(meant, TABLE)
    else:
        with pytest.raises(ReadError):
            read_term(norm, TABLE)


@pytest.mark.parametrize("kind", ["rotation", "tensor", "dual rotation", "dual tensor", "vector"])
def test_a_non_member_is_named_by_its_declared_kind(kind: str) -> None:
    table = SymbolTable.build({"x": {"kind": kind}})
    with pytest.raises(ReadError, match=f"a member of .* is a scalar; here it is a {kind}, as declared"):
        read(r"x \in \mathbb{R}", table)


@pytest.mark.parametrize("kind", ["rotation", "tensor", "vector", "scalar"])
@pytest.mark.parametrize("name", ["x", "x_1", "x_{12}"])
@pytest.mark.parametrize("power", range(5))
def test_a_power_that_may_be_a_frame_label_raises_a_question(kind: str, name: str, power: int) -> None:
    """R_1^0 and any other figure on a numbered rotation; on others those that nobody prints as powers."""
    table = SymbolTable.build({name: {"kind": kind}})
    may_be = {"rotation": power < 2 or name != "x", "scalar": False}.get(kind, power < 2 and name != "x")
    if may_be:
        with pytest.raises(ReadError, match=f"the power {power}, or the label of a frame"):
            read_term(f"{name}^{power}", table)
    elif kind == "vector" and power < 2:
        with pytest.raises(ReadError, match="a power, or a label"):
            read_term(f"{name}^{power}", table)
    elif kind != "vector" or power % 2 == 0:
        assert read_term(f"{name}^{power}", table) == read_term(f"({name})^{power}", table)


@pytest.mark.parametrize("braced", ["s S", "S T", "S + T", "-s"])
@pytest.mark.parametrize("power", ["2", "T", r"\top", "-1"])
def test_a_power_of_invisible_braces_is_rejected(braced: str, power: str) -> None:
    """{S T}^2 prints S T²."""
    with pytest.raises(ReadError, match="braces print nothing"):
        read_term(f"{{{braced}}}^{{{power}}}", TABLE)
    assert read_term(f"({braced})^{{{power}}}", TABLE) is not None
    assert read_term(f"{{({braced})}}^{{{power}}}", TABLE) is not None


ADJOINT = TABLE.with_specs({r"\operatorname{Ad}_g": {"kind": "matrix 6×6"}, "y": {"kind": "matrix 6×1"}})


def test_a_bracket_behind_an_adjoint_matrix_is_a_factor() -> None:
    one, other = (read(rf"\operatorname{{Ad}}_g {each} = y", ADJOINT) for each in ("(y)", "y"))
    assert one == other

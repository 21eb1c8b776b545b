"""Formulas with two readings: read as a paper means them, or refused with one error that says what to write."""

from __future__ import annotations

from pathlib import Path

import pytest

from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_formula, read_term
from workbench.language.typed.errors import IllFormedAt, ReadError, SpecError
from workbench.language.typed.names import Name
from workbench.language.typed.terms import Symbol
from workbench.papers import load_notation

KINDS = {
    "a": "vector",
    "b": "vector",
    "c": "vector",
    "u": "vector",
    "S": "tensor",
    "T": "tensor",
    "s": "scalar",
    r"\alpha": "scalar",
    r"\beta": "scalar",
    r"\omega": "vector",
    "a_n": "vector",
    r"\mathbf{a}^{[n]}": "vector",
    r"\omega_{01}": "vector",
    r"\omega_n": "vector",
    r"v_{rel}": "vector",
    r"v_{\mathrm{n}}": "vector",
    r"v_{\text{rot}}": "vector",
}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()})

SAME = [
    (r"\|a\|_2^2", r"\|a\|^2"),
    (r"\left|a + b\right|_2", r"\|a + b\|"),
    (r"-a^2", r"-(a^2)"),
    (r"(a^T T b)^T", r"a^T T b"),
    (r"\operatorname{tr}(a^T b)", r"a^T b"),
    (r"-\alpha^2", r"-(\alpha^2)"),
    (r"\alpha a \times b", r"(\alpha a) \times b"),
    (r"T a \cdot b", r"(T a) \cdot b"),
    (r"a \cdot T b", r"a \cdot (T b)"),
    (r"a \times T b", r"a \times (T b)"),
    (r"a \otimes T b", r"a \otimes (T b)"),
    (r"\dot{\alpha} b", r"(\dot{\alpha}) b"),
    (r"\dot{a} \times b", r"(\dot{a}) \times b"),
    (r"\tilde{\omega}^2 a", r"(\tilde{\omega} )^2 a"),
    (r"\sin 2\alpha", r"\sin(2 \alpha)"),
    (r"\sin \alpha u", r"(\sin \alpha) u"),
    (r"\sin \alpha^2", r"\sin(\alpha^2)"),
    (r"\sin^2 \alpha", r"(\sin \alpha)^2"),
    (r"\det T S", r"\det (T S)"),
    (r"\det T \alpha", r"(\det T) \alpha"),
    (r"a_n^{(2)}", r"\ddot{a}_n"),
    (r"\dot{a}_n", r"\dot{a_n}"),
    (r"\frac{d^2}{dt^2} a", r"\ddot{a}"),
    (r"\frac{d(\alpha a)}{dt}", r"\frac{d}{dt} (\alpha a)"),
    (r"T^{\mathrm{T}} + T^{\mathsf{T}}", r"T^T + T^\top"),
    (r"\sum_{k=1}^{n} a_k \times b + c", r"(\sum_{k=1}^{n} (a_k \times b)) + c"),
    (r"|a||b|", r"\|a\| \|b\|"),
    (r"\alpha/2 + \beta", r"\frac{\alpha}{2} + \beta"),
    (r"\alpha T a/\beta", r"\frac{\alpha T a}{\beta}"),
    (r"a \times b/(\alpha - 1)", r"\frac{a \times b}{\alpha - 1}"),
    (r"-(a + b)/|a|", r"-\frac{a + b}{\|a\|}"),
    (r"s/\sin \alpha", r"\frac{s}{\sin \alpha}"),
    (r"1/2", r"\frac{1}{2}"),
    (r"\sum_{k=1}^{n} a_k/k", r"\sum_{k=1}^{n} \frac{a_k}{k}"),
    (r"d\alpha/dt + \mathrm{d}s/\mathrm{d}t", r"\dot{\alpha} + \dot{s}"),
    (r"\frac{d}{dt} \|a\|^2", r"\frac{d}{dt} (\|a\|^2)"),
    (r"\partial(s^2)/\partial s", r"\frac{\partial (s^2)}{\partial s}"),
    (r"\begin{Bmatrix} s \\ \alpha \end{Bmatrix}", r"\begin{bmatrix} s \\ \alpha \end{bmatrix}"),
    (r"a_ns", "a_n s"),
    (r"a \times b \cdot c", r"(a \times b) \cdot c"),
    (r"s a \times b \cdot 2 c", r"(s a \times b) \cdot (2 c)"),
    (r"\sum_{i=1}^3 -s a_i", r"\sum_{i=1}^3 (-s a_i)"),
    (r"b - 2 \sum_{i=1}^3 -a_i - c", r"b - 2 \sum_{i=1}^3 (-a_i) - c"),
]


@pytest.mark.parametrize(("printed", "meant"), SAME)
def test_one_reading(printed: str, meant: str) -> None:
    assert read_term(printed, TABLE, {"n"}) == read_term(meant, TABLE, {"n"})


REFUSED = [
    (r"a \times b \times c", 12, "several products"),
    (r"a \times b \cdot c \cdot a", 20, "several products"),
    (r"a \times b \cdot T", 12, "several products"),
    (r"\sum_{i=1}^3 + s", 1, "the sum has no body"),
    (r"a \cdot b \cdot c", 11, "several products"),
    (r"a \otimes b \cdot c", 13, "several products"),
    (r"a \times -b", 3, "nothing after ×"),
    (r"a - -b", 5, "unexpected -"),
    (r"\alpha/\beta s", 7, "how far does / reach"),
    (r"\alpha/2 \cdot s", 9, "what is divided by what"),
    (r"\alpha/\beta/s", 13, "what is divided by what"),
    (r"\sin \alpha/2", 12, "how far does / reach"),
    (r"s/\sin 2\alpha", 2, "how far does / reach"),
    (r"s/\det T S", 2, "how far does / reach"),
    (r"\frac{d}{dt} s/2", 15, "how far does / reach"),
    (r"1/2 s", 2, "how far does / reach"),
    (r"s/", 2, "nothing after /"),
    (r"/s", 1, "nothing before /"),
    (r"\sin 2\alpha \beta", 1, "how far does sin reach"),
    (r"\sin \alpha \beta", 1, "how far does sin reach"),
    (r"\sin(\alpha)^2", 5, "a power of the function or of its argument"),
    (r"\frac{d}{dt} a \times b", 1, "how far does d/dt reach"),
    (r"\frac{d}{dt} T a", 1, "how far does d/dt reach"),
    (r"\frac{d}{dt} (s)^2", 14, "a power of the derivative or of its argument"),
    (r"\frac{d}{dt} \|a\|^2 s", 1, "how far does d/dt reach"),
    (r"\frac{d a \times b}{dt}", 1, "how far does d/dt reach"),
    (r"\frac{d T a}{dt}", 1, "how far does d/dt reach"),
    (r"\frac{d(T) a}{dt}", 1, "how far does d/dt reach"),
    (r"2\frac{1}{2} a", 2, "a mixed number or a product"),
    (r"2\frac12 a", 2, "a mixed number or a product"),
    (r"1 2 a", 3, "two numbers side by side"),
    (r"a_n^{[k]}", 5, "an order in round brackets"),
    (r"\mathbf{a}^{(2)}", 9, r"unknown symbol \\mathbf\{a\}\^\{\(2\)\}"),
    (r"\left. a \right|", 6, "one-sided bracket"),
    (r"\left. a \right|_{t=0}", 6, "a bar that says where something is evaluated"),
    (r"a |_{t=0}", 3, "a bar that says where something is evaluated"),
    (r"s^{1/3}", 2, "expected an integer"),
    (r"|a|b|", 5, "never closed"),
    (r"a'", 1, "unknown symbol a'"),
    (r"a^\prime", 2, "a prime is written '"),
    (r"a \wedge b", 3, r"the vector product is written \\times"),
    (r"\hat{a b}", 7, r"\\hat of more than one symbol"),
    (r"\overline{a S}", 11, r"\\overline of more than one symbol"),
]


@pytest.mark.parametrize(("latex", "column", "message"), REFUSED)
def test_two_readings_are_refused(latex: str, column: int, message: str) -> None:
    with pytest.raises(ReadError, match=message) as caught:
        read_term(latex, TABLE, {"n", "k"})
    assert abs(caught.value.column - column) <= 1


def test_an_order_of_a_number_and_a_fraction_can_be_written() -> None:
    assert read_term(r"2 \cdot \frac{1}{2}", TABLE) == read_term(r"2 (\frac{1}{2})", TABLE)
    assert read_term(r"2 \frac{n}{2} a", TABLE, {"n"})


# ellipses


@pytest.mark.parametrize(
    "dots",
    [
        r"\dots",
        r"\ldots",
        r"\cdots",
        r"\vdots",
        r"\ddots",
        r"\dotsb",
        r"\dotsc",
        r"\dotsm",
        r"\dotsi",
        r"\dotso",
        "...",
        "…",
    ],
)
@pytest.mark.parametrize("formula", ["a = b + {} + c", "a_1 + {} + a_n = b", "a_n = b, n = 0, 1, {}"])
def test_an_ellipsis_gets_an_error_that_says_what_to_write(dots: str, formula: str) -> None:
    with pytest.raises(
        ReadError, match=r"leaves something to be guessed; write the sum with \\sum, the range as n \\geq 1$"
    ) as caught:
        read(formula.format(dots), TABLE, {"n"})
    assert (caught.value.line, caught.value.column) == (1, formula.index("{}") + 1)


# names


def test_numbers_with_a_leading_zero_are_labels() -> None:
    assert read_term(r"\omega_{01}", TABLE).declaration.name == Name(r"\omega", sub=("01",))
    assert read_term(r"\omega_1", TABLE).declaration.name == Name(r"\omega", sub=("", ""))
    with pytest.raises(ReadError, match=r"unknown symbol \\omega_\{02\}"):
        read_term(r"\omega_{02}", TABLE)
    with pytest.raises(ReadError, match="as superscript"):
        read_term(r"\alpha^{02}", TABLE)


@pytest.mark.parametrize(
    "latex",
    [
        "v_{rel}",
        r"v_{\mathrm{n}}",
        r"v_\mathrm{n}",
        r"v_{\text{rot}}",
        r"v_\text{rot}",
        r"v_{\mathrm{rot}}",
        r"v_{\operatorname{rot}}",
    ],
)
def test_words_and_upright_letters_are_labels(latex: str) -> None:
    for variables in (set(), {"n", "l", "t"}):
        term = read_term(latex, TABLE, variables)
        assert term.index == () and "curl" not in str(term.declaration.name)


def test_a_derivative_is_no_part_of_a_name() -> None:
    for name in ("a^{(n)}", "a^{(2)}", r"R^{\mathrm{T}}"):
        with pytest.raises(SpecError, match="would be read as"):
            SymbolTable.build({name: {"kind": "tensor"}})


def test_an_index_in_brackets_is_another_name() -> None:
    with pytest.raises(ReadError, match=r"unknown symbol a_\{\(1\)\}"):
        read_term("a_{(1)}", TABLE)


# conditions


def test_the_value_of_an_index_is_a_range() -> None:
    reading = read_formula("a_n = b, n = 1", TABLE)
    assert len(reading.statements) == 1
    ((variable, lower, upper),) = [(r.variable, str(r.lower), str(r.upper)) for r in reading.ranges]
    assert (variable, lower, upper) == ("n", "1", "1")


def test_the_value_of_a_symbol_is_a_statement() -> None:
    assert len(read(r"a = b, s = 1", TABLE)) == 2
    assert (
        len(
            read(
                r"a = b, n = 1",
                SymbolTable.build(
                    {n: {"kind": k} for n, k in (("a", "vector"), ("b", "vector"), ("n", "scalar"))}
                ),
            )
        )
        == 2
    )
    with pytest.raises(ReadError, match="unknown symbol q"):
        read(r"a = b, q = 1", TABLE)


@pytest.mark.parametrize("condition", [r"s \geq 0", "s > 0", r"s \in \mathbb{N}"])
def test_a_condition_on_a_symbol_is_not_dropped(condition: str) -> None:
    with pytest.raises(ReadError, match="s is a symbol; what is assumed of symbols"):
        read(f"a = b, {condition}", TABLE)


def test_a_bold_letter_that_is_a_symbol_is_no_index() -> None:
    table = SymbolTable.build({"a": {"kind": "vector"}, r"\mathbf{n}": {"kind": "vector"}})
    with pytest.raises(ReadError, match="expected an integer variable"):
        read(r"a = a, \mathbf{n} = \overline{1, 3}", table)
    with pytest.raises(ReadError, match="expected integer variables"):
        read(r"a = a, \mathbf{n} \in \mathbb{N}", table)


def test_a_circle_over_a_letter_is_a_part_of_its_name() -> None:
    table = SymbolTable.build({r"\mathring{a}": {"kind": "vector"}})
    for spelt in (r"\overset{\circ}{a}", r"\overset {\circ} {a}", r"\mathring{a}"):
        assert to_latex(read_term(spelt, table)) == r"\mathring{a}"


LABELS = [
    r"v_\perp",
    r"v_{\parallel}",
    r"v_{\|}",
    r"x_{\max}",
    r"T^\dagger",
    r"x_{t|t-1}",
    r"x^\flat",
    r"v^\perp",
]


@pytest.mark.parametrize("name", LABELS)
def test_a_sign_alone_in_a_script_is_part_of_the_name(name: str) -> None:
    table = SymbolTable.build({name: {"kind": "vector"}, "a": {"kind": "vector"}})
    symbol = read_term(name, table)
    assert isinstance(symbol, Symbol)
    assert read_term(to_latex(symbol), table) == symbol
    assert read(rf"{name} \perp a", table) == read(rf"{name} \cdot a = 0", table)


@pytest.mark.parametrize(
    ("printed", "meant"),
    [
        (r"a \perp b", r"a \cdot b = 0"),
        (r"a \parallel b", r"a \times b = \mathbf{0}"),
        (r"a \perp b \perp u", r"a \cdot b = 0, \quad b \cdot u = 0"),
        (r"a = b, \quad a \perp b", r"a = b, \quad a \cdot b = 0"),
        (
            r"a \parallel b \Rightarrow T a \parallel T b",
            r"a \times b = \mathbf{0} \Rightarrow T a \times T b = \mathbf{0}",
        ),
    ],
)
def test_relations_of_directions(printed: str, meant: str) -> None:
    spelt = [to_latex(said) for said in read(printed, TABLE)]
    assert ", ".join(spelt).replace(r"\quad ", "") == ", ".join(
        to_latex(said) for said in read(meant, TABLE)
    ).replace(r"\quad ", "")


@pytest.mark.parametrize(
    ("formula", "message"),
    [
        (r"a \perp T", "expected a vector"),
        (r"\perp a", "unexpected"),
        (r"\parallel a \parallel = s", "unexpected"),
        (r"a \perp", "ends too early"),
    ],
)
def test_directions_of_nothing(formula: str, message: str) -> None:
    with pytest.raises((ReadError, IllFormedAt), match=message):
        read(formula, TABLE)


@pytest.mark.parametrize(
    ("formula", "feature"),
    [
        (r"\inf_a s = 0", "a bound that need not be reached"),
        (r"a \mapsto b = 0", "a map is said by"),
        (r"S \subset T", "a part of a set is not read"),
    ],
)
def test_what_is_not_read_is_named(formula: str, feature: str) -> None:
    with pytest.raises(ReadError, match=feature):
        read(formula, TABLE)


def test_a_bracket_that_is_never_closed_is_told_before_what_is_not_read() -> None:
    with pytest.raises(ReadError, match="never closed"):
        read(r"\min_a |s = 0", TABLE)


@pytest.mark.parametrize("bound", [r"n \leq 5", r"1 \leq n \leq 5", r"n \le 5", r"n \lt 5"])
def test_an_upper_bound_alone_says_what_to_write(bound: str) -> None:
    with pytest.raises(ReadError, match=r"a range is written n \\geq 1 or n = \\overline\{1,5\}"):
        read(f"a_n = b, {bound}", TABLE)


def test_the_article_fits() -> None:
    with pytest.raises(IllFormedAt, match="expected an operator or tensor"):
        read_term(r"T \circ a", TABLE)


def test_a_backslash_at_the_end_of_a_line_is_a_space_as_in_tex():
    assert read_term("a \\\n + a", TABLE) == read_term("a + a", TABLE)


@pytest.mark.parametrize("formula", [r"s = 1 - t", r"s = \cos t", r"s = 3 + t^2 \alpha"])
def test_the_time_may_stand_for_a_number(formula: str) -> None:
    assert read(formula, TABLE)


def test_a_star_on_a_column_is_not_the_adjugate() -> None:
    with pytest.raises(ReadError, match="declare the symbol with it"):
        read(r"a^* = b", TABLE)


@pytest.mark.parametrize("row", [r"a \: b \: c", "a b c", r"a ~ b"])
def test_vectors_side_by_side_in_a_bracket_are_asked_about(row: str) -> None:
    with pytest.raises(ReadError, match="columns or a triple product"):
        read(f"T = [{row}]", TABLE)


def test_vectors_below_each_other_that_are_a_matrix_are_asked_about() -> None:
    with pytest.raises(ReadError, match="the rows of a matrix"):
        read(r"T = \begin{bmatrix} a \\ b \\ c \end{bmatrix}", TABLE)
    assert read(r"T = \begin{bmatrix} a^T \\ b^T \\ c^T \end{bmatrix}", TABLE)


@pytest.mark.parametrize(
    "formula", [r"e a^2 = -(a \cdot a) e", r"a^2 e = e", "a b = 0", "a b e = e", "a^3 = 0", "2 a^2 e = e"]
)
def test_vectors_that_may_be_quaternions_are_asked_about(formula: str) -> None:
    """The square of a quaternion (0, a) is −a·a, that of a vector a·a."""
    table = TABLE.with_specs({"e": {"kind": "hamilton quaternion"}})
    with pytest.raises(ReadError, match="write"):
        read(formula, table)
    assert read(r"e a a = -(a \cdot a) e", table) and read(r"a^2 = a \cdot a", table)


@pytest.mark.parametrize("name", ["atan2", "arctan2"])
def test_arcs_of_two(name: str) -> None:
    assert read_term(rf"\mathrm{{{name}}}(s, \alpha)", TABLE).head == "atan2"


def test_the_frobenius_norm() -> None:
    assert read_term(r"\|S T\|_F", TABLE) == read_term(r"\sqrt{\operatorname{tr}((S T)^T (S T))}", TABLE)
    for other in (r"\|T\|_2", r"\|a\|_1", r"\|T\|_G"):
        with pytest.raises(ReadError, match="a subscript on an expression"):
            read_term(other, TABLE)


def test_a_bracket_that_may_say_an_argument_is_asked_about() -> None:
    for formula in (r"T(a) b = c", r"T(a, b) c = c"):
        with pytest.raises(ReadError, match="bracket"):
            read(formula, TABLE)
    with pytest.raises(IllFormedAt):
        read("T(a + b) b = c", TABLE)


def test_the_exponential_of_a_vector_is_asked_about() -> None:
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
def test_how_far_a_function_of_tensors_reaches_behind_a_number_is_asked(formula: str) -> None:
    with pytest.raises(ReadError, match="how far does"):
        read(formula, TABLE)


@pytest.mark.parametrize("formula", [r"2 \times 3 s = 6 s", r"s \times \alpha = \alpha s"])
def test_a_cross_between_numbers_is_asked_about(formula: str) -> None:
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
def test_what_a_transform_makes_of_a_bare_zero_is_asked(tmp_path: Path, formula: str) -> None:
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
def test_what_is_declared_to_be_no_member_is_called_what_it_is(kind: str) -> None:
    table = SymbolTable.build({"x": {"kind": kind}})
    with pytest.raises(ReadError, match=f"a member of .* is a scalar; here it is a {kind}, as declared"):
        read(r"x \in \mathbb{R}", table)


@pytest.mark.parametrize("kind", ["rotation", "tensor", "vector", "scalar"])
@pytest.mark.parametrize("name", ["x", "x_1", "x_{12}"])
@pytest.mark.parametrize("power", range(5))
def test_a_power_that_may_be_the_label_of_a_frame_is_asked_about(kind: str, name: str, power: int) -> None:
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

"""A paper's own notation is read as what it means, by the kinds of its arguments."""

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read

TABLE = SymbolTable.build(
    {
        "a": {"kind": "vector"},
        "v": {"kind": "vector"},
        "T": {"kind": "tensor"},
        r"\beta": {"kind": "scalar"},
        r"\beta_1": {"kind": "scalar"},
        r"\hat{n}": {"kind": "vector"},
        r"\bar{r}^{P/O}": {"kind": "vector"},
        r"{}_B\omega_{IB}": {"kind": "vector"},
        "C_{I'I''}": {"kind": "rotation"},
    }
).with_notations(
    {
        r"x^\wedge": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        r"y^\wedge": {"where": {"y": "tensor"}, "means": r"\operatorname{vect}(y)"},
        r"[x]_\times": {"where": {"x": "vector"}, "means": r"\tilde{x}"},
        r"\hat{x}": {"where": {"x": "vector"}, "means": r"\tilde{x}"},
        r"x'": {"where": {"x": "vector"}, "means": r"\dot{x}"},
        r"x \wedge y": {"where": {"x": "vector", "y": "vector"}, "means": r"x \times y"},
        r"\mathds{1}_{3\times 3}": {"means": r"\mathbf{I}"},
        "[x]": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        "[NB]": {"means": "T"},
        "[NB]_{0a}": {"means": "2 T"},
        "[NB]^*": {"means": "3 T"},
        r"\mathrm{c} x": {"where": {"x": "scalar"}, "means": r"\cos x"},
        "S(x)": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        r"x \times": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        r"s_\alpha": {"where": {r"\alpha": "scalar"}, "means": r"\sin \alpha"},
        r"\mathrm{S}_x": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        r"\mathrm{S}_\alpha": {"where": {r"\alpha": "scalar"}, "means": r"\tan \alpha"},
    }
)
SAME = [
    (r"s_\beta v", r"\sin(\beta) v"),
    (r"s_{\beta_1}^2 v", r"(\sin \beta_1)^2 v"),
    (r"s^2_\beta s_{\beta + \beta_1}", r"(\sin \beta)^2 \sin(\beta + \beta_1)"),
    (r"\dot{s_\beta} v", r"\frac{d}{dt}(\sin \beta) v"),
    (r"\mathrm{S}_{2 a}^T v", r"(\operatorname{skew}(2 a))^T v"),
    (r"\mathrm{S}_\beta v", r"\tan(\beta) v"),
    (r"\mathrm{c}\beta_1 \mathrm{c}(2 \beta) v", r"\cos\beta_1 \cos(2 \beta) v"),
    (r"\mathrm{c}(\beta)^2", r"(\cos\beta)^2"),
    (r"{{\bar{r}}}^{P/O}", r"\bar{r}^{P/O}"),
    (r"{{}_B\omega \,}_{IB}", r"{}_B\omega_{IB}"),
    (r"S(a + v) a", r"\operatorname{skew}(a + v) a"),
    (r"S(a)^T", r"\tilde{a}^T"),
    (r"S^T(a) v", r"\tilde{a}^T v"),
    (r"S^{-T}(a + v)", r"(\operatorname{skew}(a + v))^{-T}"),
    (r"\mathrm{c}^2 \beta v", r"(\cos \beta)^2 v"),
    (r"[a]_\times^2 v", r"(\tilde{a})^2 v"),
    (r"{[a]}_{ \times}^{T}", r"\tilde{a}^T"),
    (r"[a]_\times^{-T}", r"\tilde{a}^{-T}"),
    (r"\frac{d}{dt}([a]_\times)", r"\dot{[a]_\times}"),
    (r"[NB]_{0a}^T v", r"(2 T)^T v"),
    (r"[NB]^* [NB]", r"3 T T"),
    (r"\begin{bmatrix} T a & v \end{bmatrix}_{3 \times 2}", r"\begin{bmatrix} T a & v \end{bmatrix}"),
    (r"S(2 a)^2 v", r"(\operatorname{skew}(2 a))^2 v"),
    (r"(a \times) v", r"\tilde{a} v"),
    (r"(a \times v \times)^T", r"(a \times \tilde{v})^T"),
    (r"\begin{bmatrix} 2 a \times & T \end{bmatrix}", r"\begin{bmatrix} 2 \tilde{a} & T \end{bmatrix}"),
    (r"v^\wedge", r"\tilde{v}"),
    (r"v^{\land}", r"\tilde{v}"),
    (r"T^\wedge", r"\operatorname{vect} T"),
    (r"(v^\wedge)^2", r"\tilde{v}^2"),
    (r"[v \times a]_\times", r"\widetilde{v \times a}"),
    (r"\hat{v} a", r"\tilde{v} a"),
    (r"v \wedge a", r"v \times a"),
    (r"{}_B\hat{\omega}_{IB}", r"\operatorname{skew}({}_B\omega_{IB})"),
    (r"v' + a'", r"\dot{v} + \dot{a}"),
    (r"\mathds{1}_{3\times3}", r"\mathbf{I}"),
    (r"[NB]^T [a] [N B]", r"T^T \operatorname{skew}(a) T"),
    (r"[[NB] v]", r"\operatorname{skew}(T v)"),
    ("[" * 24 + "a" + "]" * 24 + " v", r"\tilde{a} v"),  # each bracket read once, else 2²⁴ times
]


@pytest.mark.parametrize(("spelt", "meant"), SAME)
def test_a_notation_is_what_it_means(spelt: str, meant: str) -> None:
    (relation,) = read(f"{spelt} = {meant}", TABLE)
    assert relation.left == relation.right


QUATERNIONS = SymbolTable.build(
    {"p": {"kind": "hamilton quaternion"}, "q": {"kind": "hamilton quaternion"}, "a": {"kind": "vector"}}
    | {"s": {"kind": "scalar"}, "T": {"kind": "tensor"}}
).with_notations(
    {
        r"x \cdot y": {"where": dict.fromkeys("xy", "quaternion"), "means": "x y"},
        "x / y": {"where": dict.fromkeys("xy", "quaternion"), "means": "x y^{-1}"},
        r"\operatorname{vect}(x)": {"where": {"x": "quaternion"}, "means": r"\operatorname{Vec} x"},
    }
)


@pytest.mark.parametrize(
    ("spelt", "meant"),
    [
        (r"p \cdot q \cdot p", "p q p"),
        ("p / q", "p q^{-1}"),
        (r"\text{vect}(p \cdot q) \cdot a", r"(\operatorname{Vec} (p q)) \cdot a"),
        (r"p / s", r"\frac{p}{s}"),
        (r"\operatorname{vect}(T)", r"\operatorname{vect} T"),
    ],
)
def test_a_paper_may_redefine_signs_and_words_for_some_kinds(spelt: str, meant: str) -> None:
    one, other = (read(f"{each} = {each}", QUATERNIONS)[0].left for each in (spelt, meant))
    assert one == other


@pytest.mark.parametrize("formula", [r"p \cdot a = p", "a / q = q", r"s \backslash q = q"])
def test_of_other_kinds_it_says_nothing(formula: str) -> None:
    with pytest.raises((ReadError, IllFormedAt)):
        read(formula, QUATERNIONS)


def test_the_backslash_is_a_sign_of_the_paper() -> None:
    entry = {r"x \backslash y": {"where": {"x": "tensor", "y": "vector"}, "means": r"x^{-1} y"}}
    (relation,) = read(r"T\ \backslash\ v = T^{-1} v", TABLE.with_notations(entry))
    assert relation.left == relation.right


@pytest.mark.parametrize("written", ["{v = a}", r"{{v = a}}", r"v = a \& a = v", r"v = a \text{ \& } a = v"])
def test_braces_are_ignored_and_an_ampersand_means_and(written: str) -> None:
    assert [str(each) for each in read(written, TABLE)][:1] == [str(read("v = a", TABLE)[0])]


@pytest.mark.parametrize("formula", ["s_1 = s_1", "s_{12} = s_{12}", r"s_{a} = s_{a}", "{}^B s_\\beta = 1"])
def test_subscripts_that_are_no_arguments_are_labels(formula: str) -> None:
    """s_1 is often the sine of θ₁, and never that of 1."""
    with pytest.raises(ReadError, match=r"unknown symbol|of a vector"):
        read(formula, TABLE)


def test_a_name_with_a_letter_below_comes_first() -> None:
    table = TABLE.with_symbol(SymbolTable.build({r"s_\beta": {"kind": "vector"}}).symbols.popitem()[1])
    (relation,) = read(r"s_\beta = v", table)
    assert relation.left.type.kind == "vector"


def test_a_declared_name_comes_first() -> None:
    (relation,) = read(r"\hat{n} \times a = v", TABLE)
    assert relation.left.type.kind == "vector"


@pytest.mark.parametrize("formula", [r"\bar r^{P/O} = v", r"C_{I\!'I''} v = a"])
def test_labels_are_read(formula: str) -> None:
    assert read(formula, TABLE)


@pytest.mark.parametrize(
    "formula",
    [
        r"v \oplus a = v",
        r"S(T) = T",
        r"(T \times) a = v",
        r"(a \otimes) = T",
        r"S(a)_1 = T",
        r"[a]_\times_\times = T",
        r"[NB]_{0b} = T",
        r"[a + v]_3 = a",
        r"(T a)_{3 \times 2} = a",
        r"a \backslash v = a",
        r"v^\vee = a",
        r"v / a = 1",
        r"(a \cdot v)^\wedge = T",
    ],
)
def test_unexplained_notation_is_rejected(formula: str) -> None:
    with pytest.raises((ReadError, IllFormedAt)):
        read(formula, TABLE)


@pytest.mark.parametrize(
    "specs",
    [
        {"x^\\wedge": {"where": {"x": "vector"}}},
        {"x^\\wedge": {"where": {"y": "vector"}, "means": "y"}},
        {"x^\\wedge": {"where": {"x": "vector"}, "means": "v"}},
        {"[NB]^T": {"means": "1"}},
        {"[NB]_0^{-1}": {"means": "1"}},
        {"v^2": {"means": "1"}},
        {"x + y": {"where": {"x": "vector", "y": "vector"}, "means": "x"}},
        {r"\dot{x}": {"where": {"x": "vector"}, "means": "x"}},
        {"x_s^B": {"where": {"x": "vector"}, "means": "x"}},
        {"e_x^B": {"where": {"x": "vector"}, "means": "x"}},
        {"x T": {"where": {"x": "vector"}, "means": "x"}},
        {"x^\\wedge = y": {"where": {"x": "vector"}, "means": "x"}},
        {
            "x^\\wedge": {"where": {"x": "vector"}, "means": r"\tilde{x}"},
            "y^\\wedge": {"where": {"y": "vector"}, "means": "2 y"},
        },
    ],
    ids=[
        *(
            "no meaning",
            "no such letter",
            "a letter that means nothing",
            "a transpose",
            "an inverse",
            "a power",
            "a sum",
            "a dot",
            "two scripts",
        ),
        *("an argument below and a label", "nothing before it", "no expression", "two for one"),
    ],
)
def test_a_notation_that_cannot_be_used(specs) -> None:
    with pytest.raises(SpecError):
        SymbolTable().with_notations(specs)


PRIMED = SymbolTable.build(
    {"x": {"kind": "vector"}, "y": {"kind": "vector"}, "y'": {"kind": "vector"}, "T": {"kind": "tensor"}}
)
PRIMED = PRIMED.with_notations({"x'": {"where": {"x": "vector"}, "means": "T x"}})


@pytest.mark.parametrize("accent", [r"\dot", r"\ddot", r"\tilde"])
def test_an_accent_under_a_prime_raises_a_question(accent: str) -> None:
    with pytest.raises(ReadError, match="which first"):
        read(rf"{accent}{{x}}' = {accent}{{x}}", PRIMED)


@pytest.mark.parametrize(
    ("spelt", "meant"),
    [
        (r"(\dot{x})'", r"T \dot{x}"),
        (r"\dot{x'}", r"\frac{d}{dt} (T x)"),
        ("(x + y)'", "T (x + y)"),
        (r"\dot{y}'", r"\frac{d}{dt} y'"),
    ],
)
def test_a_prime_is_on_what_stands_before_it(spelt: str, meant: str) -> None:
    (relation,) = read(f"{spelt} = {meant}", PRIMED)
    assert relation.left == relation.right


@pytest.mark.parametrize(
    ("key", "means"),
    [(r"\check{x}", r"\check{\check{x}}"), ("[x]", "2 [x]"), (r"x^\wedge", r"(x^\wedge)^\wedge")],
)
def test_a_circular_notation_is_rejected_at_its_use(key: str, means: str) -> None:
    table = SymbolTable.build({"a": {"kind": "vector"}})
    table = table.with_notations({key: {"where": {"x": "vector"}, "means": means}})
    with pytest.raises(ReadError, match="deep"):
        read(f"{key.replace('x', 'a')} = a", table)


@pytest.mark.parametrize("specs", [{"J_4": "J_{4}"}, {"J_4": r"2 \mathbb{J}", r"\mathbb{J}": "J_4 + J_4"}])
def test_a_circular_constant_is_rejected_at_its_use(specs: dict[str, str]) -> None:
    table = SymbolTable.build({}).with_notations({key: {"means": means} for key, means in specs.items()})
    with pytest.raises(ReadError, match="deep"):
        read("J_4 = 0", table)


BELOW = SymbolTable.build(
    {name: {"kind": "vector"} for name in ("a", r"\vec{a}", "a_0", r"\vec{b}", "b")}
    | {"T": {"kind": "tensor"}}
).with_notations(
    {
        r"x_\times": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"},
        "y_s": {"where": {"y": "tensor"}, "means": r"\operatorname{sym} y"},
        "x_0": {"where": {"x": "vector"}, "means": "T x"},
        r"\vec a^0": {"means": r"T \vec{a}"},
        r"b^{\circ}": {"means": "T b"},
    }
)


@pytest.mark.parametrize(
    ("spelt", "meant"),
    [
        (r"a_{\times} b", r"\tilde{a} b"),
        (r"\vec a_\times^2", r"(\operatorname{skew}(\vec{a}))^2"),
        (r"(a + b)_\times T", r"\operatorname{skew}(a + b) T"),
        (r"(a + b)_\times^T", r"(\operatorname{skew}(a + b))^T"),
        (r"T_s", r"\operatorname{sym} T"),
        (r"(T T^T)_s", r"\operatorname{sym}(T T^T)"),
        (r"\dot{b}_0", r"T \dot{b}"),
        (r"\dot{b_0}", r"\frac{d}{dt}(T b)"),
        (r"\vec a^0 + \vec{a}", r"T \vec{a} + \vec{a}"),
        (r"b^\circ + b^2 b", r"T b + b^2 b"),
    ],
)
def test_marks_below_and_above_have_their_declared_meaning(spelt: str, meant: str) -> None:
    (relation,) = read(f"{spelt} = {meant}", BELOW)
    assert relation.left == relation.right


@pytest.mark.parametrize(
    ("formula", "why"), [("T_0 a = a", "the subscript of a tensor"), ("a_1 = b", "unknown")]
)
def test_a_mark_below_another_kind_is_refused(formula: str, why: str) -> None:
    with pytest.raises(ReadError, match=why):
        read(formula, BELOW)
    (relation,) = read("a_0 = b", BELOW)  # a declared name comes first
    assert str(relation.left.declaration.name) == "a_{0}"

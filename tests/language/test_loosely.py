"""What some papers write loosely: dyads, x · T, and 1 for the unit tensor. It is read where the paper says so; where
it does not, and nothing else fits, it is asked about."""

from __future__ import annotations

from dataclasses import replace

import pytest

from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.language.naming.reading_conventions import Conventions, Relaxation
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read

KINDS = dict.fromkeys("abcd", "vector") | dict.fromkeys("STR", "tensor") | {"s": "scalar"}
TABLE = SymbolTable.build({name: {"kind": kind} for name, kind in KINDS.items()})

#: As papers of dyads write it, and the same in matrices.
DYADS = [
    (r"S = a b", r"S = a \otimes b"),
    (r"S = a b + s c d - T", r"S = a \otimes b + s c \otimes d - T"),
    (r"a \cdot T = b", r"T^T a = b"),
    (r"a \cdot T \cdot b = s", r"(T^T a) \cdot b = s"),
    (r"T \times a = S", r"T \tilde{a} = S"),
    (r"a \times T = b c \times d", r"\tilde{a} T = (b \otimes c) \tilde{d}"),
    (r"a b \cdot c d = S", r"(a \otimes b) (c \otimes d) = S"),
]
ONES = [
    ("T = 1", r"T = \mathbf{I}"),
    ("R R^T = 1", r"R R^T = \mathbf{I}"),
    ("T = 1 + S", r"T = \mathbf{I} + S"),
    ("T - 2 = S", r"T - 2 \mathbf{I} = S"),
    (
        r"\begin{bmatrix} s & s T \\ R & S - T \end{bmatrix} = \begin{bmatrix} T & R \\ S & 2 s \end{bmatrix}",
        r"\begin{bmatrix} s \mathbf{I} & s T \\ R & S - T \end{bmatrix}"
        r" = \begin{bmatrix} T & R \\ S & 2 s \mathbf{I} \end{bmatrix}",
    ),
]
BOTH = [(r"1 - a b = T", r"\mathbf{I} - a \otimes b = T")]
#: Of three vectors there is one meaning only, with dyads and without.
EVERYWHERE = [(r"a \cdot b c = d", r"(a \cdot b) c = d"), (r"d = s a b \cdot c", r"d = s a (b \cdot c)")]
NEITHER = [
    "s = a b",
    "T = s",
    "a + s = b",
    "a = 1",
    "T = a + 1",
    r"\det a = 0",
    "T + s = S",
    "T a = S",
    r"\begin{bmatrix} s & a \\ b & T \end{bmatrix} = 0",
    r"\begin{bmatrix} T & s \end{bmatrix} = 0",
]
LOOSE = [
    *((written, means, {Relaxation.DYADS}) for written, means in DYADS),
    *((written, means, {Relaxation.UNIT_TENSOR}) for written, means in ONES),
    *((written, means, {Relaxation.DYADS, Relaxation.UNIT_TENSOR}) for written, means in BOTH),
]


STRICT = replace(TABLE, conventions=Conventions.build({"products": "matrices", "one": "scalar"}))


def loosely(several: set[Relaxation]) -> SymbolTable:
    return replace(TABLE, conventions=Conventions().relaxed(*several))


@pytest.mark.parametrize(("written", "means", "several"), LOOSE)
def test_it_is_read_where_the_paper_says_so(written: str, means: str, several: set[Relaxation]) -> None:
    assert to_latex(read(written, loosely(several))[0]) == to_latex(read(means, TABLE)[0])


@pytest.mark.parametrize("several", [set(), {Relaxation.DYADS}])
@pytest.mark.parametrize(("written", "means"), EVERYWHERE)
def test_three_vectors_are_read_everywhere(written: str, means: str, several: set[Relaxation]) -> None:
    assert read(written, loosely(several)) == read(means, TABLE)


@pytest.mark.parametrize(("written", "means", "several"), LOOSE)
def test_the_rest_is_read_as_everywhere(written: str, means: str, several: set[Relaxation]) -> None:
    (said,) = read(means, loosely(several))
    assert (said,) == read(means, TABLE) == read(to_latex(said), loosely(several))


@pytest.mark.parametrize(("written", "means", "several"), LOOSE)
def test_undeclared_relaxed_readings_raise_a_question(
    written: str, means: str, several: set[Relaxation]
) -> None:
    for missing in several:
        with pytest.raises(ReadError, match=missing) as caught:
            read(written, loosely(several - {missing}))
        assert not isinstance(caught.value, IllFormedAt)


@pytest.mark.parametrize(("written", "means", "several"), LOOSE)
def test_a_relaxed_reading_that_the_paper_excludes_is_ill_formed(
    written: str, means: str, several: set[Relaxation]
) -> None:
    with pytest.raises(IllFormedAt):
        read(written, STRICT)
    assert read(means, STRICT) == read(means, TABLE)


@pytest.mark.parametrize("formula", NEITHER)
@pytest.mark.parametrize(
    "several",
    [set(), {Relaxation.DYADS}, {Relaxation.UNIT_TENSOR}, {Relaxation.DYADS, Relaxation.UNIT_TENSOR}],
)
def test_formulas_that_fit_no_reading_are_ill_formed(formula: str, several: set[Relaxation]) -> None:
    with pytest.raises(IllFormedAt):
        read(formula, loosely(several))


@pytest.mark.parametrize(
    "formula", [r"a \cdot b \cdot c = d", r"T \cdot a \cdot b = s", r"a \cdot b \times c = s"]
)
def test_ambiguous_dyads_are_rejected(formula: str) -> None:
    with pytest.raises(ReadError, match="ambiguous"):
        read(formula, loosely({Relaxation.DYADS}))


SKEWED = TABLE.with_notations({"[x]": {"where": {"x": "vector"}, "means": r"\operatorname{skew}(x)"}})
#: A formula that fits in another reading only, what is asked of it, and the same where nothing else is meant.
OTHERWISE = [
    ("s [a + b] = c", "mere brackets", "s (a + b) = c"),
    ("a = R [b + c] - d", "mere brackets", "a = R (b + c) - d"),
    (r"s = a^T b \times c", "how far does × reach", r"s = a^T (b \times c)"),
    (r"s = 2 s a^T R b \times c - s", "how far does × reach", r"s = 2 s a^T (R b \times c) - s"),
    (
        r"a = \begin{bmatrix} s & 2 & s \end{bmatrix}",
        "or the column",
        r"a = \begin{bmatrix} s & 2 & s \end{bmatrix}^T",
    ),
    (
        r"a = R \begin{bmatrix} s & 0 & 1 \end{bmatrix} + b",
        "or the column",
        r"a = R \begin{bmatrix} s & 0 & 1 \end{bmatrix}^T + b",
    ),
    (r"a = b \otimes c", "can say what it is", r"a = b \times c"),
    (r"a + b \otimes c = d", "can say what it is", r"a + b \times c = d"),
]


@pytest.mark.parametrize(("written", "asked", "clear"), OTHERWISE)
def test_formulas_that_fit_another_reading_raise_a_question(written: str, asked: str, clear: str) -> None:
    with pytest.raises(ReadError, match=asked) as caught:
        read(written, SKEWED)
    assert not isinstance(caught.value, IllFormedAt)
    assert read(clear, SKEWED)


@pytest.mark.parametrize(
    "formula",
    [
        "s [a + b] = S",
        "s [a] = T [b + c]",
        r"a^T = \begin{bmatrix} s & 2 & s \end{bmatrix}",
        r"T = b \otimes c",
        r"a = s b \times c",
        "[a + b] + s = R",
    ],
)
def test_formulas_without_another_reading_raise_no_question(formula: str) -> None:
    if "+ s" in formula:
        with pytest.raises(IllFormedAt):
            read(formula, SKEWED)
    else:
        assert read(formula, SKEWED)


@pytest.mark.parametrize("member", ["[2]", "[0]", "[k] - a[k - 1]", "[k + 1] + a[k]", "[i - j] + a[j - i]"])
def test_a_number_in_square_brackets_may_name_a_member(member: str) -> None:
    table = SymbolTable.build(
        {name: {"kind": kind} for name, kind in {**KINDS, **dict.fromkeys("ijk", "scalar")}.items()}
    )
    for side in ("b", "s", "s b"):
        with pytest.raises(ReadError, match="a component or a member, or a factor"):
            read(f"a{member} = {side}", table)
    assert read("a[k] = b[k]", table) and read("a[s] + a[k] = b", table) and read(r"a[2 k] = a[\|b\|]", table)


PURE = SymbolTable.build(
    {**{k: {"kind": "vector"} for k in "ab"}, "s": {"kind": "scalar"}, "q": {"kind": "hamilton quaternion"}}
)
COLUMNS = r"\begin{bmatrix} s \\ a \end{bmatrix} \otimes \begin{bmatrix} s \\ b \end{bmatrix}"


def test_vectors_beside_quaternions_may_be_some() -> None:
    """u ⊗ u = −u·u of quaternions without a scalar part, which would be a dyad; of columns of four there is none."""
    for written in (r"a \otimes a = -\|a\|^2", r"a \otimes b = q"):
        with pytest.raises(ReadError, match="dyad") as caught:
            read(written, PURE)
        assert not isinstance(caught.value, IllFormedAt)
    product = r"\begin{bmatrix} s s - a \cdot b \\ s b + s a + a \times b \end{bmatrix}"
    (said,) = read(f"{COLUMNS} = {product}", PURE)
    assert said.left.type.kind == "quaternion"
    with pytest.raises(IllFormedAt):
        read(f"{COLUMNS} = {product}", TABLE)

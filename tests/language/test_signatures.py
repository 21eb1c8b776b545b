"""What each operation takes and gives: every kind at every place, its weight, and what is dual of it."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest

from workbench.core.construct import apply, number, symbol
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import OPERATORS
from workbench.core.signatures import function, of_square, times
from workbench.core.terms import IllFormed, Symbol, Unsupported
from workbench.core.types import OPERATOR, QUATERNION, Declaration, Type, Weight

SIZES = {
    "s": (1, 1),
    "v": (3, 1),
    "c": (1, 3),
    "t": (3, 3),
    "f": (4, 1),
    "r": (1, 4),
    "h": (4, 4),
    "w": (2, 3),
}
KINDS = {letter: Type(*size) for letter, size in SIZES.items()} | {"o": OPERATOR, "q": QUATERNION}
TWICE = Linear(2)
SAME = {letter: letter for letter in KINDS}
MATRICES = "tfrhw"


def of(letter: str, weight: Weight = TWICE, dual: bool = False) -> Symbol:
    return symbol(Declaration(Name(letter), KINDS[letter].with_dual(dual), weight))


#: For each operation on one argument: what it takes → what it gives, and by what it multiplies the weight.
ONE = {
    "neg": (SAME, 1),
    "det": ({"t": "s", "h": "s"}, None),
    "trace": ({"t": "s", "h": "s"}, 1),
    "symmetric": ({"t": "t", "h": "h"}, 1),
    "antisymmetric": ({"t": "t", "h": "h"}, 1),
    "skew": ({"v": "t"}, 1),
    "vect": ({"t": "v"}, 1),
    "transpose": ({"v": "c", "c": "v", "t": "t", "f": "r", "r": "f", "h": "h", "w": (3, 2), "q": "r"}, 1),
    "inverse": ({letter: letter for letter in "sthq"}, -1),
    "vec": ({"t": (9, 1), "f": "f", "r": "f", "h": (16, 1), "w": (6, 1)}, 1),
    "adjugate": ({"t": "t"}, 2),
    "conjugate": ({"q": "q"}, 1),
    "re": (SAME, 1),
    "du": (SAME, 1),
    "norm": (dict.fromkeys("svqf", "s"), 1),
    "root": ({"s": "s"}, 0.5),
    "exp": ({letter: letter for letter in "sthq"}, 0),
    "log": ({letter: letter for letter in "sthq"}, 0),
    **dict.fromkeys(("sin", "cos", "arcsin", "arccos", "arctan"), ({"s": "s"}, 0)),
    "divergence": ({"v": "s"}, 1),
    "curl": ({"v": "v"}, 1),
    "scalar part": ({"q": "s"}, 1),
    "vector part": ({"q": "v"}, 1),
}
OF_NUMBERS = ("exp", "sin", "cos", "arcsin", "arccos", "arctan")
WEIGHTLESS = (*OF_NUMBERS, "log")


def type_of(kind: str | tuple[int, int]) -> Type:
    return KINDS[kind] if isinstance(kind, str) else Type(*kind)


@pytest.mark.parametrize("head", ONE)
@pytest.mark.parametrize("letter", KINDS)
@pytest.mark.parametrize("dual", [False, True])
def test_an_operation_on_one_argument(head: str, letter: str, dual: bool) -> None:
    takes, factor = ONE[head]
    weight = 0 if head in WEIGHTLESS else 2
    argument = of(letter, Linear(weight), dual)
    if (head, letter) == ("adjugate", "q"):
        assert apply(head, argument) == apply("conjugate", argument)
    elif letter not in takes or (head == "log" and dual):
        with pytest.raises((IllFormed, Unsupported)):
            apply(head, argument)
    else:
        made = apply(head, argument)
        assert made.type == type_of(takes[letter]).with_dual(dual and head not in ("re", "du"))
        degree = argument.type.rows if factor is None else factor
        assert made.weight == Linear(int(weight * degree))
        assert apply(head, of(letter, None)).weight == (Linear(0) if head in WEIGHTLESS else None)


@pytest.mark.parametrize("head", OF_NUMBERS)
@pytest.mark.parametrize("weight", [Linear(1), Linear(-2), Linear.variable("n")])
def test_a_transcendental_function_takes_what_has_no_weight(head: str, weight: Linear) -> None:
    with pytest.raises(IllFormed, match=f"has weight {weight}, expected 0"):
        apply(head, of("s", weight))


@pytest.mark.parametrize(("weight", "half"), [(0, 0), (2, 1), (-2, -1), (6, 3)])
def test_a_root_has_half_the_weight(weight: int, half: int) -> None:
    assert apply("root", of("s", Linear(weight))).weight == Linear(half)


@pytest.mark.parametrize("weight", [Linear(1), Linear(-3), Linear.variable("n"), Linear.variable("n") * 2])
def test_a_root_of_no_square_is_not_read(weight: Linear) -> None:
    with pytest.raises(Unsupported, match="the root of a quantity of weight"):
        apply("root", of("s", weight))


@pytest.mark.parametrize("letter", KINDS)
def test_the_root_of_a_square_matrix_has_a_meaning_elsewhere(letter: str) -> None:
    if letter != "s":
        with pytest.raises(IllFormed) as refused:
            apply("root", of(letter, Linear(0)))
        assert isinstance(refused.value, Unsupported) == (letter in "th")


def product_of(left: str, right: str) -> Type | None:
    """What stands beside each other, by the rules of matrices but for operators and quaternions."""
    if "o" in (left, right):
        acts = {
            "so": "o",
            "oo": "o",
            "to": "o",
            "ot": "t",
            "ov": "v",
            "of": "f",
            "or": "r",
            "oh": "h",
            "ow": "w",
        }
        return KINDS.get(acts.get(left + right))
    if "s" in (left, right):
        return KINDS[right if left == "s" else left]
    if "q" in (left, right):
        hamilton = dict.fromkeys(("qq", "qv", "vq", "qf", "fq", "hq"), "q")
        with_columns = {"rq": "s", "qr": "h", "qc": (4, 3)}
        made = (hamilton | with_columns).get(left + right)
        return None if made is None else type_of(made)
    (rows, inner), (other, columns) = SIZES[left], SIZES[right]
    return Type(rows, columns) if inner == other else None


def two(head: str, left: str, right: str) -> Type | None:
    match head:
        case "mul":
            return product_of(left, right)
        case "div":
            return KINDS[left] if right == "s" else None
        case "compose":
            return OPERATOR if {left, right} <= {"o", "t"} else None
        case "dot":
            return KINDS["s"] if left == right and left in "vf" else None
        case "cross" | "outer":
            return KINDS["v" if head == "cross" else "t"] if left == right == "v" else None
        case "quaternion":
            return QUATERNION if left + right == "sv" else None
        case "atan2" | "pow":
            return KINDS["s"] if left == right == "s" else None
        case "kronecker":
            rows, columns = (SIZES.get(left, (0, 0))[i] * SIZES.get(right, (0, 0))[i] for i in (0, 1))
            return Type(rows, columns) if {left, right} <= {*MATRICES, "c"} else None
    if left == "s" and right in "tcrhw":
        return KINDS[right]
    is_by_column = right in "vf" and left in "svf"
    slope = Type(SIZES[left][0], SIZES[right][0]) if is_by_column else None
    return KINDS[left] if right == "s" and left != "o" else slope


TWO = (
    "mul",
    "div",
    "compose",
    "dot",
    "cross",
    "outer",
    "kronecker",
    "quaternion",
    "atan2",
    "pow",
    "partial",
    "total",
)


@pytest.mark.parametrize("head", TWO)
@pytest.mark.parametrize("left", KINDS)
def test_an_operation_on_two_arguments(head: str, left: str) -> None:
    for right, duals in product(KINDS, ((False, False), (True, False), (False, True))):
        expected = two(head, left, right)
        weights = {"quaternion": (2, 2), "atan2": (2, 2), "pow": (0, 0)}.get(head, (2, 3))
        arguments = [of(k, Linear(w), d) for k, w, d in zip((left, right), weights, duals, strict=True)]
        is_refused = (head in ("atan2", "pow") and any(duals)) or (head in ("partial", "total") and duals[1])
        if expected is None or is_refused:
            with pytest.raises(IllFormed):
                apply(head, *arguments)
            continue
        made = apply(head, *arguments)
        assert made.type == expected.with_dual(any(duals)), (head, left, right, duals)
        differs = {"div": -1, "partial": -1, "total": -1, "quaternion": 2, "atan2": 0, "pow": 0}
        assert made.weight == Linear(differs.get(head, 5)), (head, left, right)
        if head not in ("quaternion", "atan2", "pow"):
            assert apply(head, of(left, None), of(right)).weight is None
            assert apply(head, of(left), of(right, None)).weight is None


@pytest.mark.parametrize(("exponent", "weight"), [("1/3", 2), ("-1/2", -3), ("2/3", 4)])
def test_a_power_has_its_share_of_the_weight(exponent: str, weight: int) -> None:
    raised = number(Fraction(exponent))
    assert apply("pow", of("s", Linear(6)), raised).weight == Linear(weight)
    assert apply("pow", of("s", None), raised).weight is None
    for refused in (of("s", Linear(6)), of("s", Linear(0))):
        with pytest.raises(IllFormed):
            apply("pow", of("s", Linear(5)), refused)


def test_each_operation_is_in_one_of_the_tables() -> None:
    assert {*ONE, *TWO, "add", "triple"} == set(OPERATORS)


@pytest.mark.parametrize("head", ["quaternion", "atan2"])
def test_the_parts_of_quaternions_and_angles_have_one_weight(head: str) -> None:
    other = "v" if head == "quaternion" else "s"
    with pytest.raises(IllFormed, match="weight"):
        apply(head, of("s", Linear(1)), of(other, Linear(2)))
    for weights in ((None, Linear(2)), (Linear(2), None), (Linear(2), Linear(2))):
        made = apply(head, of("s", weights[0]), of(other, weights[1]))
        assert made.weight == (Linear(2) if head == "quaternion" else Linear(0))


@pytest.mark.parametrize("place", range(3))
@pytest.mark.parametrize("letter", KINDS)
def test_a_triple_product_is_of_three_vectors(place: int, letter: str) -> None:
    vectors = [of("v", Linear(1)), of("v", Linear(2)), of("v", Linear(4))]
    vectors[place] = of(letter, Linear(8))
    if letter == "v":
        assert apply("triple", *vectors).weight == Linear(15 - (1, 2, 4)[place])
        vectors[place] = of(letter, Linear(8), dual=True)
        assert apply("triple", *vectors).type == KINDS["s"].with_dual(True)
    else:
        with pytest.raises(IllFormed, match=f"argument {place + 1} is a"):
            apply("triple", *vectors)


@pytest.mark.parametrize("left", KINDS)
@pytest.mark.parametrize("right", KINDS)
def test_addends_are_of_one_kind(left: str, right: str) -> None:
    together = {"ot": OPERATOR, "to": OPERATOR} | {a + b: QUATERNION for b in "svf" for a in "q"}
    together |= {b + a: QUATERNION for b in "svf" for a in "q"}
    expected = KINDS[left] if left == right else together.get(left + right)
    if expected is None:
        with pytest.raises(IllFormed, match="the addends differ in type") as refused:
            apply("add", of(left), of(right))
        assert isinstance(refused.value, Unsupported) == ({left, right} == {"v", "f"})
        return
    for duals in product((False, True), repeat=2):
        made = apply("add", of(left, Linear(2), duals[0]), of(right, Linear(2), duals[1]))
        assert (made.type, made.weight) == (expected.with_dual(any(duals)), Linear(2))
    assert apply("add", of(left, None), of(right)).weight == Linear(2)
    assert apply("add", of(left), of(right, None)).weight == Linear(2)
    with pytest.raises(IllFormed, match="differ in weight"):
        apply("add", of(left, Linear(1)), of(right, Linear(2)))


@pytest.mark.parametrize("letter", KINDS)
def test_a_quotient_by_a_quaternion_raises_a_question(letter: str) -> None:
    if letter != "s":
        with pytest.raises(IllFormed) as refused:
            apply("div", of("s"), of(letter))
        assert isinstance(refused.value, Unsupported) == (letter == "q")


@pytest.mark.parametrize(
    ("left", "right", "intent"), [("v", "v", "\\cdot"), ("v", "t", "T y"), ("t", "c", None), ("c", "t", None)]
)
def test_a_meaningless_product_names_its_likely_meaning(left: str, right: str, intent: str | None) -> None:
    if product_of(left, right) is None:
        with pytest.raises(IllFormed, match="juxtaposition of a") as refused:
            apply("mul", of(left), of(right))
        assert (intent or "") in (refused.value.intent or "") and bool(intent) == bool(refused.value.intent)


@pytest.mark.parametrize(
    ("head", "letter", "words"),
    [
        ("vect", "o", "expected a tensor, got a operator"),
        ("skew", "s", "expected a vector, got a scalar"),
        ("exp", "v", "expected a quaternion or scalar or tensor, got a vector"),
        ("norm", "c", "expected a quaternion or scalar or vector, got a covector"),
    ],
)
def test_it_says_what_it_takes(head: str, letter: str, words: str) -> None:
    with pytest.raises(IllFormed, match=words):
        apply(head, of(letter))


@pytest.mark.parametrize("gives", [None, KINDS["s"]])
@pytest.mark.parametrize("degree", [None, 1, 2])
@pytest.mark.parametrize("letter", KINDS)
def test_the_signature_of_a_function_of_square_matrices(
    gives: Type | None, degree: int | None, letter: str
) -> None:
    signature = of_square(gives, degree)
    if letter in "th":
        for dual in (False, True):
            argument = of(letter, TWICE, dual)
            rows = SIZES[letter][0]
            expected = (gives or KINDS[letter]).with_dual(dual), TWICE * (degree or rows)
            assert signature((argument,)) == expected
    else:
        with pytest.raises(IllFormed, match="expected a tensor, got a"):
            signature((of(letter),))


@pytest.mark.parametrize("factor", [-1, 1, 2])
@pytest.mark.parametrize("takes", [("vector",), ("vector", "scalar"), ("scalar", "tensor", "vector")])
def test_the_signature_of_a_function(factor: int, takes: tuple[str, ...]) -> None:
    signature = function(takes, KINDS["t"], times(factor))
    letters = [kind[0] for kind in takes]
    assert signature(tuple(map(of, letters))) == (KINDS["t"], TWICE * factor)
    assert signature((of(letters[0], None), *map(of, letters[1:]))) == (KINDS["t"], None)
    for place in range(len(takes)):
        mixed = [of(letter, TWICE, i == place) for i, letter in enumerate(letters)]
        assert signature(tuple(mixed))[0] == KINDS["t"].with_dual(True)
        mixed[place] = of("o")
        with pytest.raises(IllFormed, match=r"an? (scalar|vector|tensor)"):
            signature(tuple(mixed))

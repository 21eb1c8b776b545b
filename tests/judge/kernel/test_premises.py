"""What premises say a symbol is: they decide what the ideal of the equations does not, and nothing wrongly."""

import pytest

from workbench import check
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definition
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.premise_consequences import equal_sines_and_cosines, with_premise_as_definition

SYMBOLS = (
    dict.fromkeys("xyz", "scalar")
    | dict.fromkeys("abc", "vector")
    | {"T": "tensor", "S": "tensor", "R": "rotation", "n": {"kind": "vector", "unit": True}}
)

#: A symbol, what it is, and claims of both kinds with ? for it.
CASES = [
    ("x", "2 y", r"\cos ? = 2 \cos^2 y - 1", r"\cos ? = 2 \cos^2 y + 1"),
    ("x", "y + z", r"\sin ? = \sin y \cos z + \cos y \sin z", r"\sin ? = \sin y \cos z - \cos y \sin z"),
    ("x", "y", r"?^2 - y^2 + \cos ? = \cos y", r"? + \cos ? = y - \cos y"),
    ("x", "y", r"\dot{y} \cos ? + z \dot{y} = \dot{y} (z + \cos y)", r"\dot{y} \cos ? = \dot{y} \sin y"),
    ("x", r"\|a\|", r"\cos ? = \cos \|R a\|", r"\cos ? = \cos (2 \|R a\|)"),
    ("a", "-b", r"\exp(\tilde{?}) \exp(\tilde{b}) = \mathbf{I}", r"\exp(\tilde{?}) = \exp(\tilde{b})"),
    ("a", "x n", r"\exp(\tilde{?}) n = n", r"\exp(\tilde{?}) b = b + (\sin x) n \times b"),
    ("a", "R b", r"\cos \|?\| = \cos \|b\|", r"\cos \|?\| = \cos \|b\| + \|b\|"),
    ("T", r"\exp(\tilde{a})", r"?^T ? = \mathbf{I}", "? = ?^T"),
    ("T", r"\exp(\tilde{a}) R", r"\det ? = 1", "? a = R a + b"),
]


def outcome(latex):
    return check(latex, symbols=SYMBOLS).outcome


@pytest.mark.parametrize(("symbol", "value", "true", "false"), CASES)
def test_a_claim_under_it_is_the_claim_of_it(symbol, value, true, false):
    for claim, expected in ((true, Outcome.PROVED), (false, Outcome.REFUTED)):
        premise = rf"{symbol} = {value} \Rightarrow "
        assert outcome(premise + claim.replace("?", symbol)) == expected
        direct = claim.replace(r"\tilde{?}", rf"\widetilde{{{value}}}").replace("?", f"({value})")
        assert outcome(direct) == expected


@pytest.mark.parametrize("premise", [r"\|a\| = 1", r"1 = \|a\|^2", "a^2 = 1", r"a \cdot a = 1", r"1 = a^T a"])
def test_a_premise_on_the_length_gives_a_unit_vector(premise):
    true = r"\exp(x \tilde{a}) = \mathbf{I} + \tilde{a} \sin x + \tilde{a}^2 (1 - \cos x)"
    assert check(true, symbols=SYMBOLS, assume=[premise]).outcome is Outcome.PROVED
    assert check(true.replace("1 -", "1 +"), symbols=SYMBOLS, assume=[premise]).outcome is Outcome.REFUTED
    moving = r"\frac{d}{dt} \exp(x \tilde{a}) = \dot{x} \tilde{a} \exp(x \tilde{a})"  # ȧ is said nothing of
    assert check(moving, symbols=SYMBOLS, assume=[premise]).outcome is Outcome.UNCHECKED
    for other in (premise.replace("1", "2"), premise.replace("a", "b"), premise.replace("=", r"\neq")):
        assert check(true, symbols=SYMBOLS, assume=[other]).outcome is not Outcome.PROVED


@pytest.mark.parametrize("premise", [r"\cos x = 0", "y = 1", r"x \neq 0", "x + \\cos x = 1", "a = b"])
def test_only_equations_of_angles_give_equal_sines(premise):
    table = SymbolTable().with_specs(
        SYMBOLS | {name: {"kind": spec} for name, spec in SYMBOLS.items() if isinstance(spec, str)}
    )
    (given,), (said,) = read(premise, table), read(r"\dot{x} \sin x = 0", table)
    assert equal_sines_and_cosines(said, [given], Definitions()) == []


FREE = {"kind": "scalar"}


@pytest.mark.parametrize(
    ("premise", "claim", "more"),
    [
        ("x = y", r"\dot{x} = \dot{y}", {}),
        ("x = y", r"\mathbf{D} (x a) = \mathbf{D} (y a)", {}),
        ("x = x y", "x = y", {}),
        ("x = v", "x = y", {}),
        ("x = w", "x = y", {}),
        ("x = 1/y", "x = y", {}),
        (r"x = \sqrt{y}", "x = y", {}),
        ("T = S^{-1}", "T = S", {}),
        (r"x = \frac{d}{dt} \|a\|", "x = y", {}),
        ("x = y", "z = 1", {}),
        (r"x \neq y", "x = z", {}),
        ("n = R n", "n = a", {}),
        ("x = y", "x = z", {name: {**FREE, "uniform": True} for name in "xy"}),
        ("x_1 = x_2", "x_1 = z", {"x_k": FREE, "x": {"kind": "vector"}}),
        (r"\underline{x} = y", r"\underline{x} = z", {r"\underline{x}": {"kind": "dual scalar"}, "y": {**FREE, "constant": True}}),
    ],
)  # fmt: skip
def test_unsolvable_premises_define_no_symbol(premise, claim, more):
    symbols = {key: {"kind": spec} if isinstance(spec, str) else spec for key, spec in SYMBOLS.items()}
    table = SymbolTable().with_specs({**symbols, **more})
    found = []
    for name, body in (("v", "x^2"), ("w", "1/y")):
        definition, table = read_definition(name, body, table)
        found.append(definition)
    definitions = Definitions(found)
    (given,), (said,) = read(premise, table), read(claim, table)
    assert with_premise_as_definition(said, [given], definitions, ()) is None


def test_a_symbol_that_is_bound_to_a_motion_is_not_free():
    table = SymbolTable().with_specs({"x": FREE, "y": FREE})
    (given,), (said,) = read("x = y", table), read(r"\cos x = \cos y", table)
    x, y = given.left.declaration.name, given.right.declaration.name
    assert with_premise_as_definition(said, [given], Definitions(), ()) is not None
    assert with_premise_as_definition(said, [given], Definitions(), (x,))[2].lookup(given.right) == given.left
    assert with_premise_as_definition(said, [given], Definitions(), (x, y)) is None

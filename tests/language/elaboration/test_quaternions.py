"""Quaternions, matrices of any size, transforms: what they are read as, printed as, and refused as."""

from __future__ import annotations

import pytest
from judge.test_values import IDENTITIES, TABLE

from workbench import check
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.verdict import Outcome
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read, read_term

KINDS = {
    **{name: "hamilton quaternion" for name in ("p", "q", "q_a", "q_b")},
    **{name: "vector" for name in ("v", "w", r"\omega")},
    **{name: "scalar" for name in ("s", "x", "y", "z", r"\omega_x", r"\omega_y", r"\omega_z", r"\theta")},
    r"\underline{q}": "dual hamilton quaternion",
    "e": {"kind": "hamilton quaternion", "unit": True},
    "R": "rotation",
    "H": "transform",
    "M": "matrix 6×6",
    "A": "matrix 2x3",
    "J": {"kind": "tensor", "symmetric": True},
    "V": "matrix 6×1",
}


def type_of(latex: str) -> str:
    specs = {name: spec if isinstance(spec, dict) else {"kind": spec} for name, spec in KINDS.items()}
    return str(read_term(latex, SymbolTable.build(specs)).type)


@pytest.mark.parametrize("identity", IDENTITIES)
def test_the_laws_of_every_kind_print_back(identity: str) -> None:
    (statement,) = read(identity, TABLE)
    assert read(to_latex(statement), TABLE) == (statement,)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\begin{bmatrix} x \\ y \\ z \end{bmatrix}", "vector"),
        (r"\begin{bmatrix} x & y & z \end{bmatrix}", "covector"),
        (r"\begin{bmatrix} x & 0 & 0 \\ 0 & y & 0 \\ 0 & 0 & z \end{bmatrix}", "tensor"),
        (r"\begin{bmatrix} x \end{bmatrix}", "scalar"),
        (r"\begin{bmatrix} \mathbf{I} & v \\ \mathbf{0} & 1 \end{bmatrix}", "matrix 4×4"),
        ("A v", "matrix 2×1"),
        ("A^T A", "tensor"),
        ("H^{-1}", "matrix 4×4"),
        ("p q", "quaternion"),
        (r"p \otimes q", "quaternion"),
        (r"q v q^*", "quaternion"),
        ("[s, v]", "quaternion"),
        ("s + v", "quaternion"),
        ("[s, 0]", "quaternion"),
        ("[s, x, y, z]", "quaternion"),
        (r"\|q\|", "scalar"),
        (r"V \cdot V", "scalar"),
        (r"\dot{J}", "tensor"),
    ],
)
def test_formulas_of_quaternions_have_their_type(latex: str, expected: str) -> None:
    assert type_of(latex) == expected


@pytest.mark.parametrize(
    ("latex", "message"),
    [
        (r"p \cdot q", "the product of quaternions, or the scalar product"),
        ("q R", "juxtaposition of a quaternion and a tensor"),
        ("R q", "juxtaposition of a tensor and a quaternion"),
        ("p^T q p", "a matrix before a product of quaternions"),
        (r"p \times q", "× of quaternions: their product, or"),
        (r"\operatorname{Re} \underline{q}", "its real part, or its scalar part"),
        (r"\frac{p}{q}", "division by a quaternion"),
        (r"M v", "matrix product of matrix 6×6 and vector"),
        ("A^{-1}", "the inverse of a matrix 2×3"),
        (r"\det A", "expected a tensor, got a matrix 2×3"),
        ("A^2", "a power of a matrix 2×3"),
        (r"\operatorname{quat}(v, s)", "expected a scalar, argument 1 is a vector"),
        (r"\operatorname{quat} q", "expected a scalar and a vector"),
        (r"\operatorname{Vec} v", "expected a quaternion, got a vector"),
        (r"q + R", "differ in type"),
    ],
)
def test_meaningless_formulas_of_quaternions_are_rejected(latex: str, message: str) -> None:
    with pytest.raises((IllFormedAt, ReadError), match=message):
        type_of(latex)


@pytest.mark.parametrize(
    ("spec", "message"),
    [
        ({"kind": "quaternion"}, "a convention: 'hamilton quaternion'"),
        ({"kind": "matrix 0×3"}, "kind is 'matrix 0×3'"),
        ({"kind": "dual transform"}, "a transform is real"),
        ({"kind": "vector", "symmetric": True}, "symmetric is for a tensor, not for a vector"),
        ({"kind": "tensor", "unit": True}, "unit is for a vector or a hamilton quaternion"),
    ],
)
def test_kinds_that_are_refused(spec: dict, message: str) -> None:
    with pytest.raises(SpecError, match=message):
        SymbolTable.build({"X": spec})


AD = {
    r"G": r"\begin{bmatrix} R & v \\ \mathbf{0} & 1 \end{bmatrix}",
    r"\mathcal{A}": r"\begin{bmatrix} R & \tilde{v} R \\ \mathbf{0} & R \end{bmatrix}",
    r"\mathcal{B}": r"\begin{bmatrix} S & \tilde{w} S \\ \mathbf{0} & S \end{bmatrix}",
    r"\mathcal{C}": r"\begin{bmatrix} R S & \operatorname{skew}(R w + v) R S \\ \mathbf{0} & R S \end{bmatrix}",
}
MOTIONS = {
    **{k: "vector" for k in ("v", "w", "a", "b", "c", "x", "y", "z")},
    "R": "rotation",
    "S": "rotation",
}


def test_the_adjoint_of_a_product_is_the_product_of_the_adjoints() -> None:
    said = check(r"\mathcal{A} \mathcal{B} = \mathcal{C}", MOTIONS, definitions=AD)
    assert said.outcome == Outcome.PROVED
    assert check(r"\mathcal{B} \mathcal{A} = \mathcal{C}", MOTIONS, definitions=AD).outcome == Outcome.REFUTED


def ad(v: str, w: str) -> str:
    hat_v, hat_w = rf"\operatorname{{skew}}({v})", rf"\operatorname{{skew}}({w})"
    return rf"\begin{{bmatrix}} {hat_w} & {hat_v} \\ \mathbf{{0}} & {hat_w} \end{{bmatrix}}"


def test_jacobi_for_twists() -> None:
    """ad of the bracket is the commutator of the ads."""
    one, other = ad("v", "w"), ad("x", "y")
    bracket = ad(r"w \times x + v \times y", r"w \times y")
    assert check(f"{one} {other} - {other} {one} = {bracket}", MOTIONS).outcome == Outcome.PROVED
    turned = ad(r"w \times x - v \times y", r"w \times y")
    assert check(f"{one} {other} - {other} {one} = {turned}", MOTIONS).outcome == Outcome.REFUTED


@pytest.mark.parametrize(
    ("formula", "outcome"),
    [
        (r"\|q\| = \sqrt{q \otimes q^*}", Outcome.PROVED),
        (r"\sqrt{(p q)^* (p q)} = \|p\| \|q\|", Outcome.PROVED),
        (r"\sqrt{q^* q} = \|q\|^2", Outcome.REFUTED),
        (r"q q^* = \|q\|^2 = \begin{bmatrix} \|q\|^2 \\ \mathbf{0} \end{bmatrix}", Outcome.PROVED),
        (r"\|q\|^2 = \begin{bmatrix} \|q\|^2 \\ v \end{bmatrix}", Outcome.REFUTED),
    ],
)
def test_q_times_its_conjugate_is_a_number(formula: str, outcome: Outcome) -> None:
    kinds = {name: KINDS[name] for name in ("p", "q", "v")}
    assert check(formula, symbols=kinds).outcome is outcome


@pytest.mark.parametrize("formula", [r"\sqrt{q p^*} = \|q\|", r"\sqrt{q} = q"])
def test_the_root_of_a_quaternion_is_refused(formula: str) -> None:
    with pytest.raises(ReadError, match="no number"):
        read(formula, SymbolTable.build({name: {"kind": KINDS[name]} for name in ("p", "q")}))


@pytest.mark.parametrize("formula", ["R(q p) = R(q) R(p)", "R(q^*) = R(q)^T"])
def test_a_matrix_of_a_quaternion_is_no_product(formula: str) -> None:
    """R(q p) = R(q) R(p) was ill-formed: a tensor beside a quaternion."""
    kinds = {"q": "hamilton quaternion", "p": "hamilton quaternion", "R": "rotation"}
    table = SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()})
    with pytest.raises(ReadError, match="a function of what is in the bracket") as caught:
        read(formula, table)
    assert not isinstance(caught.value, IllFormedAt)

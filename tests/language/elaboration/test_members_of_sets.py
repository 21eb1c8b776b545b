"""What is said to be in a set: nothing of what is declared so, equations of other terms, and refused of all else."""

from __future__ import annotations

import pytest

from tests.language.as_read import reads, said

#: A set, what a member of it is called, which of the terms are declared to be in it, and for which it is a claim.
TRIVIAL, CLAIMS = (
    {
        r"\mathbb{R}": r"\lambda",
        r"\mathbb{R}^3": "x e xe",
        r"\mathbf{V}_3": "x e xe",
        r"SO(3)": "R",
        r"\mathbf{SO}_3": "R",
        r"SE(3)": "g",
        r"\mathfrak{so}_3": "~x",
        r"\mathfrak{se}(3)": "",
        r"\mathbb{S}^2": "e",
        r"\mathbb{R}^6": "u",
        r"\mathbb{R}^{6 \times 7}": "J",
        r"\mathbb{R}^{n}": r"\lambda x e u xe",
        r"\mathbb{R}^{m \times n}": r"\lambda x e A R g H u J ~x AA xe Rx",
        r"\underline{\mathbf{V}}_3": r"x e \underline{x} xe",
        r"\underline{\mathbf{SO}}_3": r"R \underline{R}",
    },
    {
        r"SO(3)": "~x AA",
        r"\mathbf{SO}_3": "~x AA",
        r"SE(3)": "Rx",
        r"\mathfrak{so}_3": "AA",
        r"\mathfrak{se}(3)": "Rx",
        r"\mathbb{S}^2": "xe",
        r"\underline{\mathbf{SO}}_3": "~x AA",
    },
)
TERMS = {
    each: each
    for each in (r"\lambda", "x", "e", r"\underline{x}", "A", "R", r"\underline{R}", "g", "H", "u", "J", "q")
}
TERMS |= {
    "~x": r"\tilde{x}",
    "AA": r"A^{T} A",
    "xe": r"x \times e",
    "Rx": r"\begin{bmatrix} R & x \\ \mathbf{0} & 1 \end{bmatrix}",
}


@pytest.mark.parametrize("where", TRIVIAL)
@pytest.mark.parametrize("term", TERMS)
def test_members_of_sets(where: str, term: str) -> None:
    formula = rf"{TERMS[term]} \in {where}"
    if term in TRIVIAL[where].split():
        reads(formula, "refused 1: the formula says nothing")
        assert said(rf"{formula}, \quad \lambda = 0") == r"\lambda = 0"
        return
    if term in CLAIMS.get(where, "").split():
        assert all(TERMS[term] in part or r"\mathbf{I}" in part for part in said(formula).split(" ;; "))
    else:
        reads(formula, "refused 1: a member of ")
    reads(rf"{formula}, \quad \lambda = 0", "refused 1: a member of ")


X = r"\tilde{x}"


@pytest.mark.parametrize(
    ("formula", "claims"),
    [
        (
            r"A^T A \in SO(3)",
            [r"\left(A^{T} A\right)^{T} \left(A^{T} A\right) = \mathbf{I}", r"\det\left(A^{T} A\right) = 1"],
        ),
        (r"\tilde{x} \in SO(3)", [rf"{X}^{{T}} {X} = \mathbf{{I}}", rf"\det {X} = 1"]),
        (r"A^T A \in \mathfrak{so}_3", [r"\left(A^{T} A\right)^{T} = -A^{T} A"]),
        (r"x \times e \in \mathbb{S}^2", [r"\left(x \times e\right) \cdot \left(x \times e\right) = 1"]),
    ],
)
def test_memberships_read_as_their_defining_equations(formula: str, claims: list[str]) -> None:
    assert said(formula).split(" ;; ") == claims

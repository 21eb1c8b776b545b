"""Sections 5.3 and Theorem 9: the group of orthogonal dual tensors, its structure, and SE₃ (78)–(79), (84).

Tensors without a hypothesis stand for any tensors, so that what follows from R Rᵀ = I is seen as a multiple
of R Rᵀ − I; Q and P are rotations, A is any orthogonal dual tensor by its structural invariants.
"""

from __future__ import annotations

from workbench.judge.arguments import Step, argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Verdict

_LETTERS = Letters(
    {name: {"kind": "tensor"} for name in ("R", "R_0", "X")}
    | {name: {"kind": "dual tensor"} for name in "BC"}
    | {name: {"kind": "rotation"} for name in "QP"}
    | {name: {"kind": "vector"} for name in "rspu"}
    | {"A": {"kind": "dual rotation"}},
    {r"G": r"(\mathbf{I} + \varepsilon \tilde{r}) Q", r"H": r"(\mathbf{I} + \varepsilon \tilde{s}) P"},
)


def orthogonal_dual_tensors_are_a_group() -> Verdict:
    """(78): closed under products and transposes, with the unit tensor; the transpose is the inverse."""
    return argue(
        [
            _LETTERS.step(
                "B C (B C)ᵀ = B (C Cᵀ) Bᵀ, and det(B C) = det B det C: a product of two such tensors is one",
                r"(B C) (B C)^T = B (C C^T) B^T",
                r"\det(B C) = (\det B)(\det C)",
                but_not=r"(B C) (B C)^T = C (B B^T) C^T",
            ),
            _one_sided_inverse("B"),
            _LETTERS.step(
                "(Bᵀ)ᵀ = B and det Bᵀ = det B: the transpose of such a tensor is one",
                r"(B^T)^T = B",
                r"\det(B^T) = \det B",
                but_not=r"\det(B^T) = -\det B",
            ),
            _LETTERS.step(
                "the unit tensor is one", r"\det \mathbf{I} = 1", r"B \mathbf{I} = B", but_not=r"B B = B"
            ),
        ]
    )


def structure_theorem() -> Verdict:
    """Theorem 5: R̲ = (I + ε ρ̃) R with ρ = vect(Du R̲ · Rᵀ), R = Re R̲, and with no others."""
    return argue(_structure())


def structure_theorem_with_underlines() -> Verdict:
    """With a dual factor, A = (I + ε r̃)((I − ε r̃) A) for every vector r."""
    factor = r"((\mathbf{I} - \varepsilon \tilde{r}) A)"
    return argue(
        [
            _LETTERS.step(
                "A = (I + ε r̃) B with B = (I − ε r̃) A, for every r",
                rf"(\mathbf{{I}} + \varepsilon \tilde{{r}}) {factor} = A",
                but_not=rf"{factor} = A",
            ),
            _LETTERS.step(
                "and B is an orthogonal dual tensor",
                rf"{factor} {factor}^T = \mathbf{{I}}",
                rf"\det {factor} = 1",
                but_not=rf"{factor} {factor} = \mathbf{{I}}",
            ),
            _LETTERS.refutation(
                "B is not A for every r, so that these are several decompositions",
                rf"{factor} = A",
                but_not=rf"\operatorname{{Re}} {factor} = \operatorname{{Re}}(A)",
            ),
        ],
        refutes=True,
        counterexample=_LETTERS.counterexample(rf"{factor} = A"),
        reason="R̲ = (I + ε 0̃) R̲ is one such decomposition, and every other vector ρ gives one more",
    )


def dual_tensors_move_lines() -> Verdict:
    """(I + ε ρ̃) R maps the line of p and u to that of R p + ρ and R u, and each such tensor is one map."""
    return argue(
        [
            _LETTERS.step(
                "the line through p along u goes to the line through Q p + r along Q u",
                r"G (u + \varepsilon p \times u) = Q u + \varepsilon (Q p + r) \times (Q u)",
                but_not=r"G (u + \varepsilon p \times u) = Q u + \varepsilon (Q p) \times (Q u)",
            ),
            *_structure(),
        ]
    )


def isomorphism_theorem() -> Verdict:
    """Theorem 9: Φ(g) = (I + ε ρ̃) R is a homomorphism of SE₃, one to one and onto the dual group."""
    product = r"(\mathbf{I} + \varepsilon \widetilde{(r + Q s)}) (Q P)"
    return argue(
        [
            _LETTERS.step(
                "Φ(g h) = Φ(g) Φ(h), where g h is the rotation Q P and the translation r + Q s",
                rf"G H = {product}",
                but_not=rf"H G = {product}",
            ),
            _LETTERS.step(
                "Φ(g⁻¹) = Φ(g)ᵀ, where g⁻¹ is the rotation Qᵀ and the translation −Qᵀ r",
                r"(\mathbf{I} + \varepsilon \widetilde{(-Q^T r)}) Q^T = G^T",
                but_not=r"(\mathbf{I} + \varepsilon \widetilde{(-r)}) Q^T = G^T",
            ),
            *_structure(),
        ]
    )


def codomain_of_the_isomorphism() -> Verdict:
    """(84) as printed, into SO₃ without an underline, where (86) has the real rotations."""
    return argue(
        [
            _LETTERS.step(
                "the dual part of Φ(g) is r̃ Q, from which r comes back: it is 0 for r = 0 only",
                r"\operatorname{Du}(G) = \tilde{r} Q",
                r"\operatorname{vect}(\operatorname{Du}(G) Q^T) = r",
                but_not=r"\operatorname{vect}(\operatorname{Du}(G) Q^T) = 0",
            ),
            _LETTERS.refutation(
                "Φ(g) is not its real part, a rotation", "G = Q", but_not=r"\operatorname{Re}(G) = Q"
            ),
        ],
        refutes=True,
        counterexample=_LETTERS.counterexample(r"G = Q"),
        reason="a displacement with a translation has no image among the real rotations",
    )


def _one_sided_inverse(name: str) -> Step:
    t = name
    return _LETTERS.step(
        f"(det {t})({t}ᵀ {t} − I) = adj({t}) ({t} {t}ᵀ − I) {t}: where {t} {t}ᵀ = I and det {t} = 1, {t}ᵀ"
        f" {t} = I too",
        rf"(\det {t})({t}^T {t} - \mathbf{{I}}) = {t}^* ({t} {t}^T - \mathbf{{I}}) {t}",
        but_not=rf"{t}^T {t} - \mathbf{{I}} = {t}^* ({t} {t}^T - \mathbf{{I}}) {t}",
    )


def _structure() -> list[Step]:
    dual = r"(R + \varepsilon R_0)"
    return [
        _LETTERS.step(
            "R̲ R̲ᵀ has the real part R Rᵀ and the dual part R₀ Rᵀ + (R₀ Rᵀ)ᵀ; det R̲ has the real part det R",
            rf"{dual} {dual}^T = R R^T + \varepsilon (R_0 R^T + (R_0 R^T)^T)",
            rf"\operatorname{{Re}}(\det {dual}) = \det R",
            but_not=rf"{dual} {dual}^T = R R^T + \varepsilon R_0 R^T",
        ),
        _LETTERS.step(
            "a tensor X is the tilde of vect X and ½ (X + Xᵀ): where that is 0, X is the tilde of one vector",
            r"X = \widetilde{\operatorname{vect} X} + \frac{1}{2} (X + X^T)",
            r"\operatorname{vect} \tilde{r} = r",
            but_not=r"X = \widetilde{\operatorname{vect} X} + (X + X^T)",
        ),
        _one_sided_inverse("R"),
        _LETTERS.step(
            "(R₀ Rᵀ) R − R₀ = R₀ (Rᵀ R − I): so ρ̃ = R₀ Rᵀ gives back ρ̃ R = R₀",
            r"(R_0 R^T) R - R_0 = R_0 (R^T R - \mathbf{I})",
            but_not=r"(R_0 R^T) R - R_0 = R_0 (R R^T - \mathbf{I})",
        ),
        _LETTERS.step(
            "(I + ε r̃) Q is orthogonal with determinant 1 for every rotation Q and vector r",
            r"G G^T = \mathbf{I}",
            r"\det G = 1",
            but_not=r"G G = \mathbf{I}",
        ),
        _LETTERS.step(
            "and from (I + ε r̃) Q both Q and r come back: no other pair gives the same tensor",
            r"\operatorname{Re}(G) = Q",
            r"\operatorname{vect}(\operatorname{Du}(G) Q^T) = r",
            but_not=r"\operatorname{vect} \operatorname{Du}(G) = r",
        ),
    ]


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        orthogonal_dual_tensors_are_a_group,
        structure_theorem,
        structure_theorem_with_underlines,
        dual_tensors_move_lines,
        isomorphism_theorem,
        codomain_of_the_isomorphism,
    )
}

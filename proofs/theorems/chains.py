"""Section 7: chains of any number m of bodies, derivatives of any order n.

R̲ₖ = ⁰R̲₁ ¹R̲₂ … ᵏ⁻¹R̲ₖ is the motion of body k, ω̲ₖ = R̲ₖ₋₁ Ω̲ₖ its twist relative to body k−1 as seen from C₀,
₀ω̲ₖ = ω̲₁ + … + ω̲ₖ the twist of body k, and x̲^[k] = R̲ dᵏ/dtᵏ (R̲ᵀ x̲) = (D − ω̲̃)ᵏ x̲, where ω̲ is the twist of R̲.

Induction from k bodies to k + 1, and from n to n + 1, is an identity each, in which what stands for the
first k bodies or for the n-th members is a free tensor; FLINT and SymPy prove it. Besides, (132) and (133)
are expanded in noncommuting letters, on 4×4 poses in whole numbers, and on Drake's chain of two bodies.
"""

from __future__ import annotations

from functools import cache

from proofs.theorems.chain_expansions import expanded_tensors, expanded_twists, twists_of_chains
from workbench.judge.theorems.arguments import Step, argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Verdict

_TENSOR = {"kind": "dual tensor"}
_VECTOR = {"kind": "dual vector"}
_SCALAR = {"kind": "scalar"}
_LETTERS = Letters(
    {
        "Q": {"kind": "dual rotation"},
        "X": _TENSOR,
        "Y": _TENSOR,
        "Z": _TENSOR,
        "a": _VECTOR,
        "b": _VECTOR,
        "x": {"kind": "dual vector", "weight": 1},
        r"\mathbf{P}_n": {"kind": "dual operator", "weight": "n-1"},
        "f": _SCALAR,
        "g": _SCALAR,
        "h": _SCALAR,
        "q": _SCALAR,
        "r": _SCALAR,
        "s": _SCALAR,
        "A": {"kind": "rotation"},
        "B": {"kind": "rotation"},
        r"\mathbf{c}": {"kind": "vector"},
        r"\mathbf{d}": {"kind": "vector"},
    },
    {
        "W": r"\dot{Q} Q^T",
        r"\Phi_0(x)": r"\mathbf{I}",
        r"\Phi_{n+1}(x)": r"\dot{\Phi}_n(x) + \Phi_n(x) \tilde{x}",
        r"\mathbf{P}_1": r"\mathbf{I}",
        r"\mathbf{P}_{n+1}": r"\mathbf{D} \circ \mathbf{P}_n + \mathbf{P}_n(\tilde{x})",
        r"\mathbf{p}_n(x)": r"\sum_{k=0}^n C_n^k \Phi_{n-k}(x) (\mathbf{D} - \tilde{x})^k",
    },
)


_TWISTS = Letters(
    {
        r"\underline{\omega}_p": {"kind": "dual vector", "weight": 1},
        r"\underline{\Omega}_p": {"kind": "dual vector", "weight": 1},
        r"{}^0\underline{\mathbf{R}}_1": {"kind": "dual rotation", "weight": 0},
    }
)


def motion_of_last_body() -> Verdict:
    """(117): the product of the relative motions is a dual rotation, and composes the displacements."""
    step = _LETTERS.step
    return argue(
        [
            step(
                "a relative motion is orthogonal, with determinant 1",
                r"Q Q^T = \mathbf{I}",
                r"\det Q = 1",
                but_not=r"Q Q = \mathbf{I}",
            ),
            step(
                "if R̲ₖ is, then so is R̲ₖ₊₁ = R̲ₖ ᵏR̲ₖ₊₁",
                r"(X Q)(X Q)^T = X X^T",
                r"\det (X Q) = \det X",
                but_not=r"\det (X Y) = \det X",
            ),
            step(
                "(I + ε c̃) A (I + ε d̃) B is the displacement by B, d and then by A, c",
                r"(\mathbf{I} + \varepsilon \tilde{\mathbf{c}}) A (\mathbf{I} + \varepsilon"
                r" \tilde{\mathbf{d}}) B = (\mathbf{I} + \varepsilon"
                r" \widetilde{\mathbf{c} + A \mathbf{d}}) A B",
                but_not=r"(\mathbf{I} + \varepsilon \tilde{\mathbf{c}}) A (\mathbf{I} + \varepsilon"
                r" \tilde{\mathbf{d}}) B = (\mathbf{I} + \varepsilon"
                r" \widetilde{\mathbf{c} + \mathbf{d}}) A B",
            ),
        ],
        scope="all m",
    )


@cache
def twists_add() -> Verdict:
    """(119) and (122): ₀ω̲ₘ = Σ R̲ₖ₋₁ Ω̲ₖ; so ω̲ₖ is what body k's twist has more than body k−1's."""
    return argue([*_adding_twists(), twists_of_chains()], scope="all m")


def lemma() -> Verdict:
    """(123) for every n: (R̲ Ω̲)⁽ⁿ⁾ = Σ C(n, k) Φ̲ₙ₋ₖ R̲ Ω̲⁽ᵏ⁾."""
    return argue(_lemma(), scope="all n")


def tensors_by_recurrence() -> Verdict:
    """(130) gives R̲⁽ᵖ⁾ R̲ᵀ from ω̲ alone, for every p."""
    return argue(_recurrence(), scope="all p")


def tensors_by_polynomials() -> Verdict:
    """(135): Φ̲ₙ = 𝐏ₙ ω̲̃ for every n ≥ 1, 𝐏₁ = I and 𝐏ₙ₊₁ = D ∘ 𝐏ₙ + (𝐏ₙ ω̲̃); X is 𝐏ₙ ω̲̃, whatever 𝐏ₙ is."""
    step = _LETTERS.step
    return argue(
        [
            step(
                "n = 1: Φ̲₁ is ω̲̃",
                r"\Phi_1(x) = \tilde{x}",
                but_not=r"\Phi_1(x) = \tilde{a}",
            ),
            step(
                "n = 2, …, 5, the polynomials written out by the recurrence",
                r"\mathbf{P}_n \tilde{x} = \Phi_n(x)",
                but_not=r"\mathbf{P}_n \tilde{x} = \tilde{x} \Phi_{n-1}(x)",
                orders={"n": range(2, 6)},
            ),
            step(
                "if X = 𝐏ₙ ω̲̃ = Φ̲ₙ, then 𝐏ₙ₊₁ ω̲̃ = Ẋ + X ω̲̃ = Φ̲ₙ₊₁",
                r"(\mathbf{D} \circ \mathbf{I}) X + X \tilde{x} = \dot{X} + X \tilde{x}",
                but_not=r"(\mathbf{D} \circ \mathbf{I}) X + X \tilde{x} = \dot{X} + \tilde{x} X",
            ),
        ],
        scope="all n",
    )


@cache
def theorem_11() -> Verdict:
    """(127): the n-th derivative of (122), each ω̲ₖ by the lemma with R̲ₖ₋₁, whose twist is ω̲₁ + … + ω̲ₖ₋₁."""
    return argue(
        [*_adding_twists(), twists_of_chains(), *_recurrence(), *_lemma()],
        scope="all m, n",
    )


def multinomial_identity() -> Verdict:
    """(132) with k!/(k₁! … ) and with Φ̲(ω̲ᵢ) formed in the frame of body i−1: for every k and p."""
    return argue([_pascal(), *_multinomial(), expanded_tensors()], scope="all k, p")


def closed_form_133() -> Verdict:
    """(133) with the coefficients C(n, k) k!/(k₁! …): for every n and m."""
    return argue(
        [
            *_adding_twists(),
            *_lemma(),
            *_multinomial(),
            expanded_twists(),
        ],
        scope="all m, n",
    )


def _adding_twists() -> list[Step]:
    step = _LETTERS.step
    return [
        step(
            "Ṙ̲ R̲ᵀ of R̲ₖ₊₁ = R̲ₖ ᵏR̲ₖ₊₁ is that of R̲ₖ, and that of ᵏR̲ₖ₊₁ turned by R̲ₖ",
            r"\frac{d}{dt}(X Q) = (\dot{X} + X W) Q",
            r"Q Q^T = \mathbf{I}",
            "(X Q)^T = Q^T X^T",
            but_not=r"\frac{d}{dt}(X Q) = (\dot{X} + W X) Q",
        ),
        step(
            "Ṙ̲ R̲ᵀ is skew, and turning a skew tensor turns its vector",
            r"W^T = -W",
            r"Q \tilde{a} Q^T = \widetilde{Q a}",
            r"\text{vect}(\tilde{a} + \tilde{b}) = a + b",
            but_not=r"Q \tilde{a} Q^T = \tilde{a}",
        ),
    ]


def _lemma() -> list[Step]:
    step = _LETTERS.step
    return [
        step(
            "n = 0, …, 4, for a frame with any twist x",
            r"\mathbf{p}_n(x) a = a^{(n)}",
            but_not=r"\mathbf{p}_n(x) a = a^{(n)} + n a",
            orders={"n": range(5)},
        ),
        step(
            "from n to n + 1: d/dt (Φ̲ₙ₋ₖ R̲ Ω̲⁽ᵏ⁾) = Φ̲ₙ₋ₖ₊₁ R̲ Ω̲⁽ᵏ⁾ + Φ̲ₙ₋ₖ R̲ Ω̲⁽ᵏ⁺¹⁾",
            r"\frac{d}{dt}(X Q a)"
            r" = (\dot{X} + X W) Q a + X Q \dot{a}",
            but_not=r"\frac{d}{dt}(X Q a)"
            r" = \dot{X} Q a + X Q \dot{a}",
        ),
        _pascal(),
        step(
            "R̲ Ω̲⁽ᵏ⁾ = (D − ω̲̃)ᵏ R̲ Ω̲",
            r"\frac{d}{dt}(Q a) - W Q a = Q \dot{a}",
            but_not=r"\frac{d}{dt}(Q a) = Q \dot{a}",
        ),
    ]


def _recurrence() -> list[Step]:
    return [
        _LETTERS.step(
            "Φ̲₀ R̲ = R̲, and if Φ̲ₚ R̲ = R̲⁽ᵖ⁾, then Φ̲ₚ₊₁ R̲ = R̲⁽ᵖ⁺¹⁾",
            r"\Phi_0(x) Q = Q",
            r"(\dot{X} + X W) Q = \frac{d}{dt}(X Q)",
            but_not=r"(\dot{X} + W X) Q"
            r" = \frac{d}{dt}(X Q)",
        )
    ]


def _multinomial() -> list[Step]:
    step = _LETTERS.step
    return [
        step(
            "(R̲ₚ ᵖR̲ₚ₊₁)⁽ᵏ⁾ = Σ C(k, j) R̲ₚ⁽ʲ⁾ ᵖR̲ₚ₊₁⁽ᵏ⁻ʲ⁾: from k to k + 1 term by term",
            r"\frac{d}{dt}(X Y) = \dot{X} Y + X \dot{Y}",
            but_not=r"\frac{d}{dt}(X Y) = Y \dot{X} + X \dot{Y}",
        ),
        step(
            "R̲ₚ⁽ʲ⁾ ᵖR̲ₚ₊₁⁽ˡ⁾ (R̲ₚ ᵖR̲ₚ₊₁)ᵀ is Φ̲ⱼ = R̲ₚ⁽ʲ⁾ R̲ₚᵀ times Φ̲ₗ of ᵖR̲ₚ₊₁ turned by R̲ₚ",
            r"Q^T Q = \mathbf{I}",
            "(Q Z)^T = Z^T Q^T",
            but_not="(Q Z)^T = Q^T Z^T",
        ),
        step(
            "Φ̲ₗ turned by R̲ₚ follows (130) with R̲ₚ Ω̲ₚ₊₁, and with Ẋ − ω̲̃ X + X ω̲̃ (ω̲ that of R̲ₚ) for Ẋ",
            r"\frac{d}{dt}(Q X) - W Q X = Q \dot{X}",
            r"\frac{d}{dt}(X Q^T) + X Q^T W = \dot{X} Q^T",
            r"X \tilde{a} Q^T = X Q^T \widetilde{Q a}",
            but_not=r"\frac{d}{dt}(X Q^T) = \dot{X} Q^T",
        ),
        step(
            "binomials make multinomials: k!/(j! l!) · j!/(k₁! k₂!) = k!/(k₁! k₂! l!)",
            r"\frac{f}{g h} \frac{g}{q r} = \frac{f}{q r h}",
            but_not=r"\frac{f}{g h} \frac{f}{q r} = \frac{f}{q r h}",
        ),
    ]


def _pascal() -> Step:
    """With f = n!, g = (k−1)!, h = (n−k)!, q = k, r = n − k + 1, and so q + r = n + 1."""
    return _LETTERS.step(
        "C(n, k−1) + C(n, k) = C(n+1, k)",
        r"\frac{f}{g r h} + \frac{f}{q g h} = \frac{(q + r) f}{q g r h}",
        but_not=r"\frac{f}{g r h} + \frac{f}{q g h} = \frac{f}{q g r h}",
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        motion_of_last_body,
        twists_add,
        lemma,
        tensors_by_recurrence,
        tensors_by_polynomials,
        theorem_11,
        multinomial_identity,
        closed_form_133,
    )
}

"""Section 3: the field of n-th order accelerations is affine; (21), (22), (31) for all n; the group SE(3)."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from functools import lru_cache

from workbench.algebra.matrices import add, matrix, product, scale, skew, vect
from workbench.judge.arguments import Engine, Step, Way, argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Verdict

_TENSOR, _VECTOR, _ROTATION = {"kind": "tensor"}, {"kind": "vector"}, {"kind": "rotation"}

# X and y stand for R⁽ⁿ⁾ and ρ_Q⁽ⁿ⁾: whatever they are, the argument holds. So it does for every n.
_MOTION = Letters(
    {
        r"\mathbf{R}": _ROTATION,
        "X": _TENSOR,
        r"\rho_Q": _VECTOR,
        "y": _VECTOR,
        "r": {"kind": "vector", "constant": True},
        "s": _VECTOR,
        "b": _VECTOR,
        "B": _TENSOR,
        "M": _TENSOR,
        "m": _VECTOR,
    },
    {
        r"\Phi": r"X \mathbf{R}^T",
        "a": r"y - \Phi \rho_Q",
        r"\Phi_1": r"\dot{\mathbf{R}} \mathbf{R}^T",
        "a_1": r"\dot{\rho}_Q - \Phi_1 \rho_Q",
        "h(s)": r"m + M (\rho_Q + \mathbf{R} s)",
    },
)


def acceleration_field_is_affine() -> Verdict:
    """Theorem 1, by induction on n, with the uniqueness of Φₙ and aₙ."""
    return argue(
        [
            _MOTION.step(
                "begin: ρ⁽ⁿ⁾ = ρ_Q⁽ⁿ⁾ + R⁽ⁿ⁾ r for n = 1",
                r"\frac{d}{dt} (\rho_Q + \mathbf{R} r) = \dot{\rho}_Q + \dot{\mathbf{R}} r",
                but_not=r"\frac{d}{dt} (\rho_Q + \mathbf{R} s) = \dot{\rho}_Q + \dot{\mathbf{R}} s",
            ),
            _MOTION.step(
                "step: it goes from n to n + 1, as r is constant",
                r"\frac{d}{dt} (y + X r) = \dot{y} + \dot{X} r",
                but_not=r"\frac{d}{dt} (y + X s) = \dot{y} + \dot{X} s",
            ),
            _MOTION.step(
                "then ρ⁽ⁿ⁾ = aₙ + Φₙ ρ at every point r",
                r"y + X r = a + \Phi (\rho_Q + \mathbf{R} r)",
                but_not=r"y + X r = a + \Phi (\rho_Q + r)",
            ),
            _MOTION.step(
                "if m + M ρ = 0 at the points r = Rᵀx and r = 0, then M x = 0 for every x, so M = B − Φₙ = 0",
                r"M b = h(\mathbf{R}^T b) - h(r - r)",
                but_not=r"M b = h(b) - h(r - r)",
            ),
            _MOTION.step(
                "if m + M ρ = 0 at the point at the origin, then m = b − aₙ = 0",
                r"m = h(-\mathbf{R}^T \rho_Q)",
                but_not=r"m = h(-\rho_Q)",
            ),
        ],
        scope="all n",
    )


# A, B, C stand for the k-th derivatives of Φₘ₊₁, Φₘ Φ₁, Φ̇ₘ, and a, b, c for those of aₘ₊₁, Φₘ a₁, ȧₘ;
# F, f for Φₙ, aₙ; P, p for the addends that a sum has so far.
_SUMS = Letters(
    {
        r"\omega": _VECTOR,
        "v": _VECTOR,
        **{letter: _TENSOR for letter in ("F", "A", "B", "C", "P")},
        **{letter: _VECTOR for letter in ("f", "a", "b", "c", "p")},
    },
    {
        r"\Phi_1": r"\tilde{\omega}",
        r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1",
        r"\mathbf{a}_1": "v",
        r"\mathbf{a}_{n+1}": r"\dot{\mathbf{a}}_n + \Phi_n \mathbf{a}_1",
    },
)
_UNROLLED = (
    r"\Phi_n = \Phi_{n-1} \Phi_1 + \frac{d^{n-1}}{dt^{n-1}} [\Phi_1]"
    r" + \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^k} (\Phi_{n-k-1} \Phi_1) \right]",
    r"\mathbf{a}_n = \Phi_{n-1} \mathbf{a}_1 + \frac{d^{n-1}}{dt^{n-1}} [\mathbf{a}_1]"
    r" + \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^k} (\Phi_{n-k-1} \mathbf{a}_1) \right]",
)


@lru_cache(maxsize=1)
def unrolled_recurrence() -> Verdict:
    """Eqs. (21), (22), (31) for all n ≥ 2, by adding one addend after the other.

    T(j): Φₙ = Φₙ₋₁Φ₁ + Σ (Φₙ₋ₖ₋₁Φ₁)⁽ᵏ⁾ + (Φₙ₋ⱼ₋₁)⁽ʲ⁺¹⁾ with k = 1..j. T(0) is the recurrence (20), and
    T(n−2) is (21).
    """
    return argue(
        [
            _MOTION.step(
                "T(0): Φₙ₊₁ = Φ̇ₙ + ΦₙΦ₁ and aₙ₊₁ = ȧₙ + Φₙa₁, from Φₙ = R⁽ⁿ⁾Rᵀ and aₙ = ρ_Q⁽ⁿ⁾ − Φₙρ_Q",
                r"\dot{X} \mathbf{R}^T = \dot{\Phi} + \Phi \Phi_1",
                r"\dot{y} - \dot{X} \mathbf{R}^T \rho_Q = \dot{a} + \Phi a_1",
                but_not=r"\dot{X} \mathbf{R}^T = \dot{\Phi} + \Phi_1 \Phi",
            ),
            _SUMS.step(
                "step in k: with A = (Φₘ₊₁)⁽ᵏ⁾, B = (ΦₘΦ₁)⁽ᵏ⁾ and C = (Φₘ)⁽ᵏ⁺¹⁾, A = B + C gives Ȧ = Ḃ + Ċ",
                r"\frac{d}{dt}(A - B - C) = \dot{A} - \dot{B} - \dot{C}",
                r"\frac{d}{dt}(a - b - c) = \dot{a} - \dot{b} - \dot{c}",
                but_not=r"\frac{d}{dt}(A - B - C) = \dot{A} - \dot{B} + \dot{C}",
            ),
            _SUMS.step(
                "step in j: T(j) and A = B + C give T(j+1), its sum P having B as a new addend",
                "(F - P - A) + (A - B - C) = F - (P + B) - C",
                "(f - p - a) + (a - b - c) = f - (p + b) - c",
                but_not="(F - P - A) + (A - B - C) = F - (P + B) + C",
            ),
            _SUMS.step(
                "both lines of (21) as a whole, n = 2..5",
                *_UNROLLED,
                but_not=_UNROLLED[0].replace(r"\Phi_{n-k-1} \Phi_1", r"\Phi_1 \Phi_{n-k-1}"),
                orders={"n": range(2, 6)},
            ),
            _SUMS.step(
                "(22): a skew tensor x̃ has vect x̃ = x, so that vect of (ω̃)⁽ⁿ⁻¹⁾ is ω⁽ⁿ⁻¹⁾",
                r"\operatorname{vect} \tilde{f} = f",
                r"\frac{d}{dt} [\tilde{f}] = \tilde{\dot{f}}",
                but_not=r"\operatorname{vect} \tilde{f} = 2 f",
            ),
            _SUMS.step(
                "(31): in [Φ a; 0 0] products, sums and derivatives are those of the two lines of (21)",
                r"\begin{bmatrix} A & a \\ \mathbf{0} & 0 \end{bmatrix}"
                r"\begin{bmatrix} B & b \\ \mathbf{0} & 0 \end{bmatrix}"
                r" = \begin{bmatrix} A B & A b \\ \mathbf{0} & 0 \end{bmatrix}",
                r"\frac{d}{dt} \begin{bmatrix} A & a \\ \mathbf{0} & 0 \end{bmatrix}"
                r" + \begin{bmatrix} B & b \\ \mathbf{0} & 0 \end{bmatrix}"
                r" = \begin{bmatrix} \dot{A} + B & \dot{a} + b \\ \mathbf{0} & 0 \end{bmatrix}",
                but_not=r"\begin{bmatrix} A & a \\ \mathbf{0} & 0 \end{bmatrix}"
                r"\begin{bmatrix} B & b \\ \mathbf{0} & 0 \end{bmatrix}"
                r" = \begin{bmatrix} A B & B a \\ \mathbf{0} & 0 \end{bmatrix}",
            ),
            _fails_for_one(),
        ],
        scope="all n ≥ 2",
    )


def _fails_for_one() -> Step:
    """With an empty sum, (21) for n = 1 reads Φ₁ = Φ₀Φ₁ + Φ₁ with Φ₀ = I, and (22) ω = vect(Φ₁ − Φ₀Φ₁)."""

    def fails(phi_0: int) -> Iterator[bool]:
        omega = (Fraction(1), Fraction(0), Fraction(0))
        phi_1 = skew(omega)
        unit = matrix((phi_0 * int(i == j) for i in range(3) for j in range(3)), 3)
        yield phi_1 != add(product(unit, phi_1), phi_1)
        yield vect(add(phi_1, scale(-1, product(unit, phi_1)))) != tuple((x,) for x in omega)

    def fails_in_sympy(phi_0: int) -> Iterator[bool]:
        from sympy import Matrix, eye

        omega = Matrix([1, 0, 0])
        phi_1 = Matrix.hstack(*(omega.cross(eye(3)[:, j]) for j in range(3)))
        yield phi_1 != phi_0 * phi_1 + phi_1
        yield Matrix([phi_1[2, 1] - phi_0 * phi_1[2, 1], 0, 0]) != omega

    return Step(
        "for n = 1 they fail: Φ₁ is not Φ₀Φ₁ + Φ₁ for ω = (1, 0, 0)",
        Way(Engine.FRACTIONS, lambda: fails(1), but_not=lambda: fails(0)),
        Way(Engine.SYMPY, lambda: fails_in_sympy(1), but_not=lambda: fails_in_sympy(0)),
        by_example=True,
    )


_MAPS = Letters(
    {
        **{rf"\mathbf{{R}}_{i}": _ROTATION for i in (1, 2, 3)},
        **{rf"\mathbf{{w}}_{i}": _VECTOR for i in (1, 2, 3)},
        "u": _VECTOR,
        "r": {"kind": "vector", "constant": True},
    },
    {
        "f(u)": r"\mathbf{R}_1 u + \mathbf{w}_1",
        "g(u)": r"\mathbf{R}_2 u + \mathbf{w}_2",
        "h(u)": r"\mathbf{R}_3 u + \mathbf{w}_3",
        "k(u)": r"\mathbf{R}_1^T u - \mathbf{R}_1^T \mathbf{w}_1",
        "Q": r"\mathbf{R}_1 \mathbf{R}_2",
    },
)


def rigid_motions_are_a_group() -> Verdict:
    """The sentence before (23)."""
    return argue(
        [
            _MAPS.step(
                "closed: f∘g is u ↦ Q u + w with Q = R₁R₂ and w = R₁w₂ + w₁",
                r"f(g(u)) = Q u + \mathbf{R}_1 \mathbf{w}_2 + \mathbf{w}_1",
                but_not=r"f(g(u)) = Q u + \mathbf{w}_2 + \mathbf{w}_1",
            ),
            _MAPS.step(
                "and Q is a proper orthogonal tensor, as R₁ᵀ is",
                r"Q Q^T = \mathbf{I}",
                r"\det Q = 1",
                r"\mathbf{R}_1^T (\mathbf{R}_1^T)^T = \mathbf{I}",
                r"\det (\mathbf{R}_1^T) = 1",
                but_not=r"\det Q = -1",
            ),
            _MAPS.step(
                "associative: (f∘g)∘h = f∘(g∘h)",
                r"Q h(u) + \mathbf{R}_1 \mathbf{w}_2 + \mathbf{w}_1 = f(g(h(u)))",
                but_not=r"Q h(u) + \mathbf{R}_1 \mathbf{w}_2 + \mathbf{w}_1 = f(h(g(u)))",
            ),
            _MAPS.step(
                "the inverse of f is k: u ↦ R₁ᵀu − R₁ᵀw₁, on both sides; the unit is R = I, w = 0",
                "f(k(u)) = u",
                "k(f(u)) = u",
                but_not="k(k(u)) = u",
            ),
            _MAPS.step(
                "the displacement from the pose R₁, w₁ to the pose R₂, w₂ is g∘k: it takes every point r",
                "g(k(f(r))) = g(r)",
                but_not="f(k(f(r))) = g(r)",
            ),
        ],
    )


THEOREMS = {
    theorem.__name__: theorem
    for theorem in (acceleration_field_is_affine, unrolled_recurrence, rigid_motions_are_a_group)
}

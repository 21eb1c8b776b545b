"""Sections 5.1–5.3: what (71)–(77) say beyond their formulas, each as identities for all values.

A function f of a real number is written as one of the time t, so that f' is its time derivative.
"""

from __future__ import annotations

from workbench.judge.arguments import argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Verdict

_SCALARS = {name: {"kind": "scalar"} for name in ("a", "a_0", "b", "b_0", "x")}
_DUAL_SCALARS = {name: {"kind": "dual scalar"} for name in "pqr"}
_DUAL_VECTORS = {name: {"kind": "dual vector"} for name in "abcd"}


def dual_numbers_are_a_ring() -> Verdict:
    """(71): ring axioms; zero divisors are exactly the ε b₀ ≠ 0, all other numbers but 0 have an inverse."""
    letters = Letters(_SCALARS | _DUAL_SCALARS)
    return argue(
        [
            letters.step(
                "sums and products are associative and commutative, and products distribute over sums",
                r"p (q r) = (p q) r",
                r"p q = q p",
                r"p (q + r) = p q + p r",
                r"(p + q) + r = q + (r + p)",
                but_not=r"p (q + r) = p q + r",
            ),
            letters.step(
                "1 and 0 are neutral, and −p is opposite to p",
                r"1 p = p",
                r"p + (-p) = 0",
                but_not=r"\varepsilon p = p",
            ),
            letters.step(
                "two numbers ε a₀ and ε b₀ have the product 0, so that those which are not 0 are zero"
                " divisors",
                r"(\varepsilon a_0) (\varepsilon b_0) = 0",
                but_not=r"(a + \varepsilon a_0) (\varepsilon b_0) = 0",
            ),
            letters.step(
                "(a + ε a₀)(a − ε a₀)/a² = 1: a number with a ≠ 0 has an inverse and divides no zero",
                r"(a + \varepsilon a_0) \frac{a - \varepsilon a_0}{a^2} = 1",
                but_not=r"(a + \varepsilon a_0) \frac{a + \varepsilon a_0}{a^2} = 1",
            ),
        ]
    )


def functions_of_dual_numbers() -> Verdict:
    """(72): f(a + ε a₀) = f + ε a₀ f' respects sums, products, composition and polynomials."""
    names = {name: {"kind": "scalar"} for name in ("f", "g", "u", "a", "x")}
    constants = {
        name: {"kind": "scalar", "constant": True} for name in ("a_0", "k", "c_0", "c_1", "c_2", "c_3")
    }
    letters = Letters(
        names | constants,
        {r"F(x)": r"c_0 + c_1 x + c_2 x^2 + c_3 x^3", r"h": r"F(u)"},
    )
    return argue(
        [
            letters.step(
                "the extension of f + g is the sum of the extensions, that of f g their product",
                r"(f + \varepsilon a_0 \dot{f}) + (g + \varepsilon a_0 \dot{g}) = (f + g) + \varepsilon"
                r" a_0 \frac{d}{dt}(f + g)",
                r"(f + \varepsilon a_0 \dot{f})(g + \varepsilon a_0 \dot{g}) = f g + \varepsilon a_0"
                r" \frac{d}{dt}(f g)",
                but_not=r"(f + \varepsilon a_0 \dot{f})(g + \varepsilon a_0 \dot{g}) = f g + \varepsilon"
                r" a_0 \dot{f} \dot{g}",
            ),
            letters.step(
                "from aᵏ⁺¹ = a x with aᵏ = x: a power has the value that the ring gives it, by induction"
                " on k",
                r"(a + \varepsilon a_0)(a x + \varepsilon k a_0 x) = a^2 x + \varepsilon (k + 1) a_0 a x",
                but_not=r"(a + \varepsilon a_0)(a x + \varepsilon k a_0 x) = a^2 x + \varepsilon k a_0 a x",
            ),
            letters.step(
                "a cubic with any coefficients at the extension of u is the extension of the composite",
                r"F(u + \varepsilon a_0 \dot{u}) = h + \varepsilon a_0 \dot{h}",
                but_not=r"F(u + \varepsilon a_0) = h + \varepsilon a_0 \dot{h}",
            ),
            letters.step(
                "of any f and u: f(u) + ε (a₀ u') f'(u) is the extension of the composite by the chain rule",
                r"f + \varepsilon (a_0 \dot{u}) \frac{\dot{f}}{\dot{u}} = f + \varepsilon a_0 \dot{f}",
                but_not=r"f + \varepsilon a_0 \frac{\dot{f}}{\dot{u}} = f + \varepsilon a_0 \dot{f}",
            ),
        ]
    )


def dual_vectors_are_a_free_module() -> Verdict:
    """(73): d̲ = Σ (⟨d̲, b̲, c̲⟩/⟨a̲, b̲, c̲⟩) a̲ + …, and the coefficients are the only ones."""
    letters = Letters(_DUAL_VECTORS | _DUAL_SCALARS)
    d = r"p a + q b + r c"
    basis = r"\langle a, b, c \rangle"
    return argue(
        [
            letters.step(
                "the laws of a module",
                r"p (a + b) = p a + p b",
                r"(p + q) a = p a + q a",
                r"(p q) a = p (q a)",
                r"1 a = a",
                but_not=r"(p + q) a = p a + q^2 a",
            ),
            letters.step(
                "⟨a, b, c⟩ d = ⟨d, b, c⟩ a + ⟨a, d, c⟩ b + ⟨a, b, d⟩ c: every d is a combination where ⟨a,"
                " b, c⟩ has an inverse",
                rf"{basis} d = \langle d, b, c \rangle a"
                r" + \langle a, d, c \rangle b"
                r" + \langle a, b, d \rangle c",
                but_not=rf"{basis} d = \langle d, b, c \rangle a",
            ),
            letters.step(
                "⟨p a + q b + r c, b, c⟩ = p ⟨a, b, c⟩, and so on: the combination fixes its coefficients",
                rf"\langle {d}, b, c \rangle = p {basis}",
                rf"\langle a, {d}, c \rangle = q {basis}",
                rf"\langle a, b, {d} \rangle = r {basis}",
                but_not=rf"\langle a, {d}, c \rangle = p {basis}",
            ),
        ]
    )


def magnitude_of_a_dual_vector() -> Verdict:
    """(74): the square of the magnitude in both cases; it is the only root with a positive real part."""
    vectors = {name: {"kind": "vector"} for name in (r"\mathbf{a}", r"\mathbf{a}_0")}
    scalars = {name: {"kind": "scalar"} for name in ("n", "n_0", "m_0", "k")}
    magnitude = (
        r"\left( \|\mathbf{a}\| + \varepsilon \frac{\mathbf{a}_0 \cdot \mathbf{a}}{\|\mathbf{a}\|} \right)"
    )
    letters = Letters(
        vectors | scalars, {r"\underline{\mathbf{a}}": r"\mathbf{a} + \varepsilon \mathbf{a}_0"}
    )
    return argue(
        [
            letters.step(
                "where Re a ≠ 0, the square of (74) is a·a",
                rf"{magnitude}^2 = \underline{{\mathbf{{a}}}} \cdot \underline{{\mathbf{{a}}}}",
                but_not=r"\left( \|\mathbf{a}\| + \varepsilon \frac{2 \mathbf{a}_0 \cdot"
                r" \mathbf{a}}{\|\mathbf{a}\|} \right)^2"
                r" = \underline{\mathbf{a}} \cdot \underline{\mathbf{a}}",
            ),
            letters.step(
                "where Re a = 0, both the square of (74) and a·a are 0",
                r"(\varepsilon \|\mathbf{a}_0\|)^2 = (\varepsilon \mathbf{a}_0) \cdot (\varepsilon"
                r" \mathbf{a}_0) = 0",
                but_not=r"(\varepsilon \|\mathbf{a}_0\|)^2 = \varepsilon \mathbf{a}_0 \cdot \mathbf{a}_0",
            ),
            letters.step(
                "(n + ε n₀)² − (n + ε m₀)² = 2 ε n (n₀ − m₀): where n > 0 the dual part of the root is"
                " unique",
                r"(n + \varepsilon n_0)^2 - (n + \varepsilon m_0)^2 = 2 \varepsilon n (n_0 - m_0)",
                but_not=r"(n + \varepsilon n_0)^2 - (n + \varepsilon m_0)^2 = \varepsilon n (n_0 - m_0)",
            ),
            letters.step(
                "λ² a·a is the square of λ |a|",
                rf"(k {magnitude})^2 = (k \underline{{\mathbf{{a}}}}) \cdot (k \underline{{\mathbf{{a}}}})",
                but_not=rf"(k {magnitude})^2 = k \underline{{\mathbf{{a}}}} \cdot \underline{{\mathbf{{a}}}}",
            ),
        ]
    )


def real_factors_do_not_make_a_dual_tensor() -> Verdict:
    """(75) as printed holds for a + ε a₀ ↦ a − ε a₀, which is not linear over the dual numbers."""
    vectors = {rf"\mathbf{{v}}_{i}": {"kind": "dual vector"} for i in (1, 2)}
    scalars = {r"\lambda": {"kind": "scalar"}, r"\underline{\lambda}": {"kind": "dual scalar"}}
    v = r"\mathbf{v}_1 + \lambda \mathbf{v}_2"
    letters = Letters(
        vectors | scalars | {r"\underline{x}": {"kind": "dual vector"}},
        {
            r"F(\underline{x})": r"\operatorname{Re}(\underline{x}) - \varepsilon"
            r" \operatorname{Du}(\underline{x})"
        },
    )
    dual = r"F(\underline{\lambda} \mathbf{v}_1) = \underline{\lambda} F(\mathbf{v}_1)"
    return argue(
        [
            letters.step(
                "F(a + ε a₀) = a − ε a₀ has (75) for real factors",
                rf"F({v}) = F(\mathbf{{v}}_1) + \lambda F(\mathbf{{v}}_2)",
                but_not=dual,
            ),
            letters.step(
                "F(ε v) = −ε F(v), where a map that is linear over the dual numbers has ε F(v)",
                r"F(\varepsilon \mathbf{v}_1) = -\varepsilon F(\mathbf{v}_1)",
                but_not=r"F(\varepsilon \mathbf{v}_1) = \varepsilon F(\mathbf{v}_1)",
            ),
            letters.refutation(
                "so it is not linear over the dual numbers",
                dual,
                but_not=r"F(\lambda \mathbf{v}_1) = \lambda F(\mathbf{v}_1)",
            ),
        ],
        refutes=True,
        counterexample=letters.counterexample(dual),
        reason="a + ε a₀ ↦ a − ε a₀ satisfies (75) for real factors, and is no dual tensor",
    )


def a_dual_tensor_is_two_tensors() -> Verdict:
    """T̲(v + ε v₀) = T̲ v + ε T̲ v₀, and T̲ v = T v + ε T₀ v with linear T, T₀."""
    tensors = {name: {"kind": "tensor"} for name in ("T", "T_0", "S", "S_0")}
    vectors = {name: {"kind": "vector"} for name in ("a", "a_0")}
    letters = Letters(
        tensors | vectors | {r"\lambda": {"kind": "dual scalar"}},
        {
            r"u": r"a + \varepsilon a_0",
            r"A": r"T + \varepsilon T_0",
            r"B": r"S + \varepsilon S_0",
        },
    )
    return argue(
        [
            letters.step(
                "a + ε a₀ has the image of a plus ε times that of a₀, so the images of real vectors are"
                " enough",
                r"A u = A a + \varepsilon (A a_0)",
                but_not=r"A u = A a + A a_0",
            ),
            letters.step(
                "on real vectors the parts of the image are the images by two real tensors",
                r"\operatorname{Re}(A a) = T a",
                r"\operatorname{Du}(A a) = T_0 a",
                but_not=r"\operatorname{Du}(A a) = T a",
            ),
            letters.step(
                "T + ε T₀ commutes with dual factors, so every pair of real tensors makes a dual one",
                r"A (\lambda u) = \lambda (A u)",
                but_not=r"A (\lambda u) = A u",
            ),
            letters.step(
                "a difference T̲ − S̲ has the parts T − S and T₀ − S₀: equal dual tensors have equal parts",
                r"\operatorname{Re}(A - B) = T - S",
                r"\operatorname{Du}(A - B) = T_0 - S_0",
                but_not=r"\operatorname{Du}(A - B) = T_0",
            ),
        ]
    )


def the_transpose_is_unique() -> Verdict:
    """A tensor X with v₁·(T v₂) = v₂·(X v₁) for all v₁, v₂ is Tᵀ: their difference annuls every product."""
    letters = Letters(
        {
            r"T": {"kind": "dual tensor"},
            r"X": {"kind": "dual tensor"},
            r"v": {"kind": "dual vector"},
            r"w": {"kind": "dual vector"},
        }
    )
    defect = r"(X - T^T) v"
    return argue(
        [
            letters.step(
                "the tensor with exchanged indices solves (76)",
                r"v \cdot (T w) = w \cdot (T^T v)",
                but_not=r"v \cdot (T w) = w \cdot (T v)",
            ),
            letters.step(
                "what another solution X misses (76) by is w·((X − Tᵀ) v), which is 0 for all v, w only if"
                " X = Tᵀ",
                r"w \cdot (X v) - v \cdot (T w)"
                rf" = w \cdot ({defect})",
                but_not=r"w \cdot (X v) - v \cdot (T w)"
                r" = w \cdot (X v)",
            ),
        ]
    )


def the_determinant_is_unique() -> Verdict:
    """δ ⟨v₁, v₂, v₃⟩ fixes δ where the triple product has an inverse; where it is ε r, δ + ε s serves too."""
    vectors = {rf"v_{i}": {"kind": "dual vector"} for i in (1, 2, 3)}
    letters = Letters(
        vectors
        | {
            r"T": {"kind": "dual tensor"},
            r"\delta": {"kind": "dual scalar"},
            "s": {"kind": "scalar"},
            "r": {"kind": "scalar"},
        }
    )
    triple = r"\langle v_1, v_2, v_3 \rangle"
    images = ", ".join(rf"T v_{i}" for i in (1, 2, 3))
    return argue(
        [
            letters.step(
                "det T solves (77) for all v₁, v₂, v₃",
                rf"\langle {images} \rangle = (\det T) {triple}",
                but_not=rf"\langle {images} \rangle = -(\det T) {triple}",
            ),
            letters.step(
                "⟨T v₁, T v₂, T v₃⟩/⟨v₁, v₂, v₃⟩ = det T where the denominator has an inverse",
                rf"\frac{{\langle {images} \rangle}}{{{triple}}} = \det T",
                but_not=rf"\frac{{\langle {images} \rangle}}{{{triple}}} = 2 \det T",
            ),
            letters.step(
                "(δ + ε s) ε r = δ ε r: where the real part of the triple product is 0, the dual part of δ"
                " is free",
                r"(\delta + \varepsilon s) (\varepsilon r) = \delta (\varepsilon r)",
                but_not=r"(\delta + s) (\varepsilon r) = \delta (\varepsilon r)",
            ),
        ]
    )


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        dual_numbers_are_a_ring,
        functions_of_dual_numbers,
        dual_vectors_are_a_free_module,
        magnitude_of_a_dual_vector,
        real_factors_do_not_make_a_dual_tensor,
        a_dual_tensor_is_two_tensors,
        the_transpose_is_unique,
        the_determinant_is_unique,
    )
}

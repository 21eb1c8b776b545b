"""Section 5.1: (72). The language of goals has no letters for functions of a number."""

from __future__ import annotations

from workbench.judge.theorems.arguments import argue
from workbench.judge.theorems.formula_steps import Letters
from workbench.judge.verdict import Verdict


def functions_of_dual_numbers() -> Verdict:
    """(72): f(a + ε a₀) = f + ε a₀ f' respects sums, products, composition and polynomials."""
    names = {name: {"kind": "scalar"} for name in ("f", "g", "u", "a", "x")}
    constants = {name: {"kind": "scalar", "constant": True} for name in ("a_0", "k")}
    letters = Letters(names | constants)
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
                "of any f and u: f(u) + ε (a₀ u') f'(u) is the extension of the composite by the chain rule",
                r"f + \varepsilon (a_0 \dot{u}) \frac{\dot{f}}{\dot{u}} = f + \varepsilon a_0 \dot{f}",
                but_not=r"f + \varepsilon a_0 \frac{\dot{f}}{\dot{u}} = f + \varepsilon a_0 \dot{f}",
            ),
        ]
    )


THEOREMS = {theorem.__name__: theorem for theorem in (functions_of_dual_numbers,)}

"""Section 6, (103)–(113): reduced accelerations of every order, and the two counts of orders.

V and W are v⁽ⁿ⁾ and ω⁽ⁿ⁾ for some n, as free functions: what holds for them holds for every n.
"""

from __future__ import annotations

from proofs.theorems.leibniz import leibniz_rule
from workbench.judge.arguments import Step, argue
from workbench.judge.formula_steps import Letters
from workbench.judge.verdict import Counterexample, Verdict

_LETTERS = Letters(
    {name: {"kind": "vector"} for name in (r"\omega", r"\rho", "V", "W", "x", "y")},
    {
        "v": r"\dot{\rho} - \omega \times \rho",
        r"A_n": r"\rho^{(n+1)} - \sum_{k=0}^{n-1} C_n^{k+1} \omega^{(n-1-k)} \times \rho^{(k+1)}",
    },
)

#: Pₙ and Qₙ by the same recurrence from P₀ = I and Q₁ = I; aₙ, Φₙ as in (20).
_ORDERS = Letters(
    {
        r"\omega": {"kind": "vector"},
        "v": {"kind": "vector"},
        "P_n": {"kind": "operator"},
        "Q_n": {"kind": "operator"},
    },
    {
        "P_0": r"\mathbf{I}",
        "P_{n+1}": r"\mathbf{D} P_n + P_n (\tilde{\omega})",
        "Q_1": r"\mathbf{I}",
        "Q_{n+1}": r"\mathbf{D} Q_n + Q_n (\tilde{\omega})",
        r"\Phi_1": r"\tilde{\omega}",
        r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1",
        "a_1": "v",
        "a_{n+1}": r"\dot{a}_n + \Phi_n a_1",
    },
)


def derivatives_of_the_twist() -> Verdict:
    """(106) for every n: Leibniz' rule for v = ρ̇ − ω × ρ."""
    return argue(_twist_derivatives(), scope="all n")


def reduced_accelerations_of_every_order() -> Verdict:
    """(103) and (109) for every n, with A^[n] = ρ⁽ⁿ⁺¹⁾ − Σ C(n, k+1) ω⁽ⁿ⁻¹⁻ᵏ⁾ × ρ⁽ᵏ⁺¹⁾."""
    return argue(_every_order(), scope="all n")


def reduced_accelerations_at_the_origin() -> Verdict:
    """After (104): A^[n] = v⁽ⁿ⁾ for the body point at ρ = 0."""
    return argue(
        [
            *_every_order(),
            _LETTERS.step(
                "V + W × ρ at ρ = 0 is V",
                r"V + W \times (\rho - \rho) = V",
                but_not=r"V + W \times \rho = V",
            ),
        ],
        scope="all n",
    )


def reduced_accelerations_are_helicoidal() -> Verdict:
    """After (109): V + W × x is a field of equal components along each line that joins two points."""
    difference = r"(V + W \times x) - (V + W \times y)"
    return argue(
        [
            *_every_order(),
            _LETTERS.step(
                "the values at x and y differ by W × (x − y), which is normal to x − y",
                rf"{difference} = W \times (x - y)",
                rf"({difference}) \cdot (x - y) = 0",
                but_not=rf"({difference}) \cdot x = 0",
            ),
        ],
        scope="all n",
    )


def one_count_of_orders() -> Verdict:
    """(107) against (13) and (39); and that all hold by the count of (13) with P₁ = I."""
    orders = {"n": range(1, 6)}
    return argue(
        [
            _LETTERS.refutation(
                "ρ̇ and ρ̈, what (13) and (107) name a^[1], are not the same",
                r"\dot{\rho} = \ddot{\rho}",
                but_not=r"\frac{d}{dt} \dot{\rho} = \ddot{\rho}",
            ),
            _ORDERS.step(
                "the operators from P₀ = I are those from P₁ = I, each of an order less",
                "P_n = Q_{n+1}",
                but_not="P_n = Q_n",
                orders=orders,
            ),
            _ORDERS.step(
                "from P₁ = ω̃ the recurrence gives D ω̃ + ω̃², neither of the printed P₁ and P₂",
                r"\mathbf{D} \circ \tilde{\omega} + \tilde{\omega} \tilde{\omega}"
                r" = \tilde{\omega} \mathbf{D} + \dot{\tilde{\omega}} + \tilde{\omega}^2",
                but_not=r"\mathbf{D} \circ \tilde{\omega} + \tilde{\omega} \tilde{\omega}"
                r" = \tilde{\omega} \mathbf{D} + \tilde{\omega}^2",
            ),
            _ORDERS.step(
                "by the count of (13), with Q for P: (111), (116) and the repaired (110), each for n = 1 … 5",
                r"a_n = Q_n v",
                r"\Phi_n = Q_n \tilde{\omega}",
                r"v^{(n-1)} = a_n - \sum_{k=1}^{n-1} C_{n-1}^k \omega^{(n-1-k)} \times a_k",
                r"v^{(n)} = a_{n+1} - \sum_{k=1}^{n} C_n^k \omega^{(n-k)} \times a_k",
                but_not=r"a_{n+1} = Q_n \dot{v}",
                orders=orders,
            ),
            _LETTERS.step(
                "and the repaired (108), with ρ⁽ᵏ⁾ for a^[k]: A^[n] is a^[n+1] less the sum over k = 1 … n",
                r"A_n = \rho^{(n+1)} - \sum_{k=1}^{n} C_n^k \omega^{(n-k)} \times \rho^{(k)}",
                but_not=r"A_n = \rho^{(n+1)} - \sum_{k=0}^{n-1} C_n^k \omega^{(n-k)} \times \rho^{(k)}",
                orders=orders,
            ),
        ],
        refutes=True,
        counterexample=Counterexample(
            values={r"\dot{\rho}": ("1", "0", "0"), r"\ddot{\rho}": ("0", "0", "0"), "n": ("1",)},
            left=("1", "0", "0"),
            right=("0", "0", "0"),
        ),
        reason="the acceleration of order 1 is ρ̇ by (13) and ρ̈ by (107)",
    )


def _twist_derivatives() -> list[Step]:
    return [
        *leibniz_rule(),
        _LETTERS.step(
            "the sum for n = 0 is v, and for n = 1 … 8 it is what the differentiation gives",
            r"v^{(n)} = \rho^{(n+1)} - \sum_{k=0}^{n} C_n^k \omega^{(k)} \times \rho^{(n-k)}",
            but_not=r"v^{(n)} = \rho^{(n+1)} - \sum_{k=0}^{n} \omega^{(k)} \times \rho^{(n-k)}",
            orders={"n": range(9)},
        ),
    ]


def _every_order() -> list[Step]:
    return [
        *_twist_derivatives(),
        _LETTERS.step(
            "the sums of (106) without its last term and of (108) are one, by C(n, m) = n!/(m! (n−m)!) ="
            " C(n, n−m)",
            r"\sum_{k=0}^{n-1} C_n^{k+1} \omega^{(n-1-k)} \times \rho^{(k+1)}"
            r" = \sum_{k=0}^{n-1} C_n^k \omega^{(k)} \times \rho^{(n-k)}",
            but_not=r"\sum_{k=0}^{n-1} C_n^k \omega^{(n-1-k)} \times \rho^{(k+1)}"
            r" = \sum_{k=0}^{n-1} C_n^k \omega^{(k)} \times \rho^{(n-k)}",
            orders={"n": range(1, 9)},
        ),
        _LETTERS.step(
            "so A^[n] is v⁽ⁿ⁾ plus that last term, ω⁽ⁿ⁾ × ρ",
            r"A_n = v^{(n)} + \omega^{(n)} \times \rho",
            but_not=r"A_n = v^{(n)}",
            orders={"n": range(9)},
        ),
        _LETTERS.step(
            "from A^[n] = V + W × ρ follows Ȧ^[n] − W × ρ̇ = V̇ + Ẇ × ρ = A^[n+1], the step from n to n + 1",
            r"\frac{d}{dt}(V + W \times \rho) - W \times \dot{\rho} = \dot{V} + \dot{W} \times \rho",
            but_not=r"\frac{d}{dt}(V + W \times \rho) = \dot{V} + \dot{W} \times \rho",
        ),
        _LETTERS.step(
            "e^{ε ρ̃} (W + ε (V + W × ρ)) = W + ε V",
            r"e^{\varepsilon \tilde{\rho}} (W + \varepsilon (V + W \times \rho)) = W + \varepsilon V",
            but_not=r"e^{\varepsilon \tilde{\rho}} (W + \varepsilon V) = W + \varepsilon V",
        ),
    ]


#: Name in the claim files → proof.
THEOREMS = {
    proof.__name__: proof
    for proof in (
        derivatives_of_the_twist,
        reduced_accelerations_of_every_order,
        reduced_accelerations_at_the_origin,
        reduced_accelerations_are_helicoidal,
        one_count_of_orders,
    )
}

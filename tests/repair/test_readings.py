"""What no reader can read is put right: right formulas garbled as print and transcription garble them."""

from __future__ import annotations

from dataclasses import replace
from itertools import product

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from workbench import check
from workbench.context.claims import Correction
from workbench.context.read_formulas import read_statement
from workbench.engines.jet.rings import PRIME
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.papers import Claim, Formula
from workbench.repair.propose.known_errata import compared
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits
from workbench.repair.screening.addend_sums import zero_sums
from workbench.repair.trees.misspellings import spellings

SYMBOLS = {
    r"\omega": {"kind": "vector", "weight": 1},
    r"\underline{\alpha}": {"kind": "dual scalar", "weight": 0},
    r"\mathbf{a}": {"kind": "vector", "weight": 2},
    r"\rho": {"kind": "vector", "weight": 0},
    r"\rho_P": {"kind": "vector", "weight": 0},
    r"\rho_Q": {"kind": "vector", "weight": 0},
    r"\sigma": {"kind": "vector", "weight": 0},
    r"\sigma_s": {"kind": "vector", "weight": 0},
    r"\underline{\mathbf{u}}": {"kind": "dual vector", "weight": 0, "unit": True, "constant": True},
    r"{}_0\mathbf{x}": {"kind": "vector", "weight": 0},
    "x": {"kind": "vector"},
    "y": {"kind": "vector"},
    r"\Phi_n": {"kind": "tensor", "weight": "n"},
}
DEFINITIONS = {
    r"\Phi_1": r"\tilde{\omega}",
    r"\Phi_{n+1}": r"\dot{\Phi}_n + \Phi_n \Phi_1",
    r"\mathbf{f}(\sigma)": r"\omega \times \sigma",
    r"\mathbf{g}(x, y)": r"x \times y",
}

ROTATED = r"e^{\varepsilon \tilde{\rho}} = \mathbf{I} + \varepsilon \tilde{\rho}"
BETWEEN = r"e^{\varepsilon (\tilde{\rho}_Q - \tilde{\rho}_P)} = \mathbf{I} + \varepsilon (\tilde{\rho}_Q - \tilde{\rho}_P)"
AXIS = (
    r"e^{\underline{\alpha} \tilde{\underline{\mathbf{u}}}} \underline{\mathbf{u}} = \underline{\mathbf{u}}"
)

#: (right, what is printed of it, what is printed instead, what the edit says)
GARBLED = [
    (r"\tilde{\omega} \rho = \omega \times \rho", r"\tilde", r"\hat", r"by $\tilde{\omega}$"),
    (r"\ddot{\omega} \times \rho = -\rho \times \ddot{\omega}", r"\ddot{", r"\overset{\circ}{", r"by $\ddot{\omega}$"),
    (r"\omega \times (\rho \times \omega) = \omega^2 \rho - (\omega \cdot \rho) \omega", r"omega) =", r"omega =", "insert a bracket )"),
    (r"\omega \cdot \rho = \rho \cdot \omega", r"\rho = ", r"\rho) = ", "remove the bracket"),
    (ROTATED, r"e^{\varepsilon \tilde{\rho}}", r"e^{\varepsilon^{\tilde{\rho}}}", "as a factor"),
    (ROTATED, r"e^{\varepsilon \tilde{\rho}}", r"e^{\varepsilon \tilde{P}}", r"replace $P$ by $\rho$"),
    (BETWEEN, r"(\tilde{\rho}_Q - \tilde{\rho}_P)} =", r"\widetilde{PQ}} =", "replace $PQ$ by"),
    (AXIS, r"e^{\underline{\alpha} \tilde{\underline{\mathbf{u}}}}", r"e^{\underline{\alpha}} \tilde{\mathbf{u}}", "exponent"),
    (
        r"\frac{d^2}{dt^2} (\omega \times \rho) = \ddot{\omega} \times \rho + 2 \dot{\omega} \times \dot{\rho} + \omega \times \ddot{\rho}",
        r"dt^2", r"dt^3", "one order above and below",
    ),
    (r"\Phi_3 = \dot{\Phi}_2 + \Phi_2 \Phi_1", r"\Phi_2 \Phi_1", r"\Phi_3 \Phi_1", r"replace $3$ in $\Phi_{3}$ by $2$"),
    (r"\tilde{\sigma}_s \omega = \sigma_s \times \omega", r"\tilde{\sigma}_s", r"\tilde{\sigma}", r"by $\sigma_{s}$"),
    (r"\tilde{\omega} \rho = \omega \times \rho", r"\tilde{\omega} \rho", r"\tilde{\omega} \times \rho", "remove"),
    (r"\rho \times \omega = \mathbf{f}(-\rho)", r"= ", r"= \cdot ", "remove a sign"),
    (r"\omega \times {}_0\mathbf{x} = -{}_0\mathbf{x} \times \omega", r"\times {}_0", r"\times {}^0", r"replace ${}^{0}$ by ${}_{0}$"),
    (r"\mathbf{f}(\rho) = \omega \times \rho", r"\mathbf{f}", "f", r"replace $f$ by $\mathbf{f}$"),
    (r"\mathbf{g}(\omega, \rho) = \omega \times \rho", r"(\omega, \rho)", r"(\rho)", "argument"),
    (r"\tilde{\omega}^2 = \omega \otimes \omega - \omega^2 \mathbf{I}", r" \mathbf{I}", "", r"insert the factor $\mathbf{I}$ after"),
    (r"\tilde{\omega} \tilde{\rho} = \rho \otimes \omega - (\omega \cdot \rho) \mathbf{I}", r"(\omega \cdot \rho) \mathbf{I}",
     r"\omega \cdot \rho", r"insert the factor $\mathbf{I}$ after"),
    (r"\tilde{\omega} {}_0\mathbf{x} = \omega \times {}_0\mathbf{x}", r"\tilde{\omega} {}_0\mathbf{x}", r"(\tilde{\omega})_0 \mathbf{x}", "move the index"),
]  # fmt: skip


def notation():
    return check(r"\omega = \omega", symbols=SYMBOLS, definitions=DEFINITIONS).result.claim.notation


def garbled_claim(latex):
    return Claim("garbled", Formula(latex, ill_formed="cannot be read"), notation())


@pytest.mark.parametrize(("right", "old", "new", "said"), GARBLED)
def test_a_garbled_formula_is_put_right(right, old, new, said):
    assert check(right, symbols=SYMBOLS, definitions=DEFINITIONS).holds
    assert old in right
    claim = garbled_claim(right.replace(old, new, 1))
    found = repair(claim, Limits(seconds=20.0))
    assert any(said in proposal.edit for proposal in found.proposals), found
    for proposal in found.proposals:
        assert check(proposal.latex, symbols=SYMBOLS, definitions=DEFINITIONS).holds
    by_hand = Formula(right, read_statement(right, claim.notation, None)[0])
    assert compared(replace(found, claim=replace(claim, correction=Correction(by_hand)))).is_same, found


@pytest.mark.parametrize("right", sorted({entry[0] for entry in GARBLED}))
def test_a_readable_formula_has_one_spelling(right):
    (spelling,) = spellings(right, notation().symbols, frozenset())
    assert spelling.changes == () and spelling.lines == parse(right)


def test_a_condition_in_bold_is_one_on_the_integer():
    table = notation().symbols
    text = r"\Phi_p = \Phi_p, \mathbf{p} \in \mathbb{N}"
    found = [latex_of(s.lines) for s in spellings(text, table, frozenset("p"))]
    assert found == [r"\Phi_{p} = \Phi_{p}, \quad \mathbf{p} \in \mathbb{N}"]


def test_lines_of_one_equation_are_put_together():
    text = r"\begin{aligned} \omega = & \rho \\ & + \rho_P \end{aligned}"
    (spelling,) = spellings(text, notation().symbols, frozenset())
    assert latex_of(spelling.lines) == r"\omega = \rho + \rho_{P}"


@given(st.lists(st.lists(st.integers(0, 40), min_size=1, max_size=4), min_size=2, max_size=5))
@settings(max_examples=100)
def test_sums_that_are_zero_are_all_found(lists):
    values = [[v % PRIME for v in (x - 15 for x in alternatives)] for alternatives in lists]
    found = sorted(zero_sums(values))
    assert found == sorted(
        places
        for places in product(*(range(len(v)) for v in values))
        if sum(v[p] for v, p in zip(values, places, strict=True)) % PRIME == 0
    )


def test_too_many_sums_are_not_looked_at():
    assert zero_sums([[0] * 200] * 8) is None


@pytest.mark.parametrize("factor", ["", r"\frac{1}{2} "])
@pytest.mark.parametrize(("a", "b", "c"), [(r"\omega", r"\omega", r"\rho"), ("x", "y", r"\sigma")])
def test_two_lost_crosses_are_two_crosses_and_no_tilde(factor, a, b, c):
    right = f"{factor}{b} ({a} \\cdot {c}) - {factor}{c} ({a} \\cdot {b})"
    (found, *_) = (
        check(f"{factor}{a} {b} {c} = {right}", symbols=SYMBOLS, definitions=DEFINITIONS).repair().proposals
    )
    assert found.latex.replace(" ", "").startswith(f"{factor}{a}\\times({b}\\times{c})=".replace(" ", ""))

r"""What holds at one instant is not differentiated, and a letter means what binds it: proofs of false goals,
each beside the proof of a true one that differs from it in the one word that makes it true."""

import pytest

from tests.judge.goals.test_goals import outcome
from workbench.core.verdict import Outcome
from workbench.language.definition_entries import read_definitions
from workbench.language.definitions import expand
from workbench.language.goals.proofs import (
    AndIntroduction,
    Broken,
    Congruence,
    Cut,
    False_,
    Instance,
    Introductions,
    Kernel,
    TwoWitnesses,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term

_THEREFORE = Introductions(Congruence("Y", Y=Instance(0, {"z": "c"})))
_VANISHES = Cut(
    r"\forall z \in V_3^\mathbb{R} : z = \mathbf{0} \Longrightarrow \dot{z} = \mathbf{0}",
    Introductions(Congruence(r"\dot{Y}", Y=Instance(-1))),
    _THEREFORE,
)
_PRODUCT = Cut(
    r"\forall z \in V_3^\mathbb{R} : z = \mathbf{0} \Rightarrow z \times s = \mathbf{0}",
    Introductions(Congruence(r"Y \times s", Y=Instance(-1))),
    Introductions(Congruence(r"\dot{Y}", Y=Instance(0, {"z": "c"}))),
)
_ORTHOGONAL = Cut(
    r"\forall z \in V_3 : z \cdot a = 0 \Longrightarrow z \cdot \dot{a} = 0",
    Introductions(Congruence(r"\dot{Y}", Y=Instance(-1))),
    _THEREFORE,
)
_IS_A_ROTATION = AndIntroduction(Congruence("Y", Y=Instance(1)), Congruence("Y", Y=Instance(1, part=1)))
_SPIN = Cut(
    r"\forall Q \in SO_3^\mathbb{R} : \dot{Q} Q^T = -(\dot{Q} Q^T)^T",
    Kernel(),
    Introductions(Congruence("Y", Y=Instance(0, {"Q": "T"}, members=_IS_A_ROTATION))),
)
_EACH_OTHER = Cut(
    r"\forall z \in L(V_3, V_3) : \Big( \forall n \geq 1 : z = F_n \Big) \Rightarrow \forall n \geq 1 :"
    r" F_n = F_{n+1}",
    Introductions(Congruence("Y + Z - z", Y=Instance(0, {"n": "n"}, back=True), Z=Instance(0, {"n": "n+1"}))),
    Introductions(Congruence("Y", Y=Instance(0, {"z": "F_n", "n": "n"}))),
)
_N_TIMES = r"\forall z \in V_3^\mathbb{R} : \forall n \geq 1 : \sum_{k=1}^n z = \sum_{j=1}^n z"


@pytest.mark.parametrize(
    ("true", "false", "proof"),
    [
        (
            r"\forall c \in V_3^\mathbb{R} : c = \mathbf{0} \Longrightarrow \dot{c} = \mathbf{0}",
            r"\forall c \in V_3^\mathbb{R} : c = \mathbf{0} \Rightarrow \dot{c} = \mathbf{0}",
            _VANISHES,
        ),
        (
            r"\forall c \in V_3^\mathbb{R} : c = \mathbf{0} \Longrightarrow \dot{c} \times s = \mathbf{0}",
            r"\forall c \in V_3^\mathbb{R} : c = \mathbf{0} \Rightarrow \dot{c} \times s = \mathbf{0}",
            _PRODUCT,
        ),
        (
            r"\forall c \in V_3 : c \cdot a = 0 \Longrightarrow c \cdot \dot{a} = 0",
            r"\forall c \in V_3^\mathbb{R} : c \cdot a = 0 \Longrightarrow c \cdot \dot{a} = 0",
            _ORTHOGONAL,
        ),
        (
            r"T T^T = \mathbf{I} \wedge \det T = 1 \Longrightarrow \dot{T} T^T = -(\dot{T} T^T)^T",
            r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \dot{T} T^T = -(\dot{T} T^T)^T",
            _SPIN,
        ),
    ],
)
def test_equations_at_an_instant_are_not_differentiated(true, false, proof):
    assert outcome(true, proof).outcome == Outcome.PROVED
    assert outcome(false, proof).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("goal", "proof"),
    [
        (
            r"\forall n \geq 1 : \Big( F_n = T \Rightarrow \forall n \geq 1 : F_n = T \Big)",
            Introductions(Congruence("Y", Y=Instance(0))),
        ),
        (r"\forall n \geq 1 : F_n = F_{n+1}", _EACH_OTHER),
        (
            r"\forall k \geq 1 : \forall m \geq 1 : \sum_{j=1}^m F_j a = \sum_{l=1}^m F_k a",
            Cut(_N_TIMES, Kernel(), Introductions(Congruence("Y", Y=Instance(0, {"z": "F_k a", "n": "m"})))),
        ),
    ],
)
def test_no_letter_is_bound_by_what_it_was_not_meant_for(goal, proof):
    assert outcome(goal, proof).outcome == Outcome.UNCHECKED


def test_of_a_sum_no_letter_is_bound_either():
    definitions, table = read_definitions(
        {"q_n(x)": r"\sum_{k=0}^{n} x^{(k)}"},
        SymbolTable.build({name: {"kind": "vector"} for name in ("q_n", "b_n", "x")}),
    )
    of_k = expand(read_term("q_n(b_k)", table, {"n": 0, "k": 0}), definitions)
    assert to_latex(of_k) == r"\sum_{l=0}^{n} b_{k}^{(l)}"


def test_claims_for_all_times_are_not_refuted_at_one_instant():
    lasting = r"\forall c \in V_3^\mathbb{R} : c = \mathbf{0} \Longrightarrow \dot{c} = \mathbf{0}"
    for against in (False_(), Broken(False_()), Broken(False_(), Kernel())):
        assert outcome(lasting, against=against).outcome == Outcome.UNCHECKED
    at_once = lasting.replace("Longrightarrow", "Rightarrow")
    assert outcome(at_once, against=False_()).outcome == Outcome.UNCHECKED
    assert (
        outcome(at_once.replace(r"\dot{c} =", r"\dot{c} = a +"), against=False_()).outcome == Outcome.REFUTED
    )
    supposed = r"a = b \Rightarrow \Big( a = b \Longrightarrow \dot{a} = \dot{b} \Big)"
    for against in (False_(), Broken(Broken(False_(), Congruence("Y", Y=Instance(0))))):
        assert outcome(supposed, against=against).outcome == Outcome.UNCHECKED


@pytest.mark.parametrize(
    ("goal", "first", "second", "found"),
    [
        (r"\exists! Q \in SO_3 : Q Q^T = Q^T Q", "R", "R^T", Outcome.REFUTED),
        (r"\exists! Q \in SO_3 : Q Q^T = Q^T Q", "R", r"2 R", Outcome.UNCHECKED),
        (
            r"\exists! Q \in SO_3 : R^T Q + (R^T Q)^T = 2 \mathbf{I}",
            "R",
            r"R + R \tilde{a}",
            Outcome.UNCHECKED,
        ),
    ],
)
def test_two_witnesses_are_members_of_the_set(goal, first, second, found):
    two = TwoWitnesses({"Q": first}, {"Q": second})
    assert outcome(goal, against=two).outcome == found

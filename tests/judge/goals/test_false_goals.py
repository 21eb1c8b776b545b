"""Goals of known falsity, by the way in which each would be shown, and true ones of the same shape beside them."""

from __future__ import annotations

import pytest

from workbench.core.verdict import Outcome, Verdict
from workbench.language.definition_entries import read_definitions
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import GoalError, Scope
from workbench.language.goals.proofs import (
    AndIntroduction,
    Cases,
    Congruence,
    Cut,
    ExistsElimination,
    ExistsIntroduction,
    Extensionality,
    IffIntroduction,
    Induction,
    Instance,
    Introductions,
    Kernel,
    NegationIntroduction,
    Proof,
    Proven,
    SumCongruence,
    SumOfSquares,
    UniqueExists,
    ZeroFromSquare,
)
from workbench.language.naming.symbols import SymbolTable
from workbench.prover.decide.decide import Judge
from workbench.prover.goals.prove_goal import Lemmas, prove

VECTOR, SCALAR, TENSOR = {"kind": "vector"}, {"kind": "scalar"}, {"kind": "tensor"}
SYMBOLS = {
    **dict.fromkeys(["a", "b", "w", "p", r"\omega", "y_k"], VECTOR),
    "h": SCALAR,
    **dict.fromkeys(["T", "U"], TENSOR),
    **{name: {"kind": "operator"} for name in ("P", "O")},
    "s": VECTOR | {"constant": True},
    "c_k": SCALAR | {"constant": True},
    "r": VECTOR | {"coordinate": True},
    "q": SCALAR | {"independent": True},
    **dict.fromkeys(["f", "g"], SCALAR | {"of": ["q"]}),
}
DEFINITIONS = {
    "F_1": r"\tilde{\omega}",
    "F_{n+1}": r"\dot{F}_n + F_n F_1",
    "e_0": "h",
    "e_{n+1}": "2 e_n",
    "d_0": "a",
    "d_1": "b",
    "d_{n+2}": "d_{n+1} + d_n",
    "z_0": "0 h",
    "z_1": "0 h",
    "z_2": "0 h",
    "z_{n+3}": "h + z_n",
    "N_0": "h",
    "N_7": "0 h",
    "N_{n+1}": r"\dot{N}_n",
    "M_0": "a",
    "M_2": "b",
    "M_{n+1}": r"\dot{M}_n",
    "V_0(w)": "w",
    "V_5(w)": "2 w",
    "V_{n+1}(w)": r"\dot{V}_n(w)",
    "G(w)": r"\operatorname{div} w",
    "S_0": "y_0",
    "S_{n+1}": "S_n + y_{n+1}",
    "H_0": r"\frac{1}{h} a",
    "H_{n+1}": r"\dot{H}_n",
    "u": "2 s",
    "L_0": "a",
    "L_{n+1}": "L_n + u",
    "X_n": r"\sum_{l=0}^{n} P M_{l+1}",
    "A_n": r"\sum_{k=0}^{n} c_k P^k",
    "E_n": r"\sum_{k=0}^{n} c_k (P^k y_k)",
    "B_0": "a",
    "B_{n+1}": "a + B_n - y_n",
}


@pytest.fixture(scope="module")
def judged():
    definitions, table = read_definitions(DEFINITIONS, SymbolTable.build(SYMBOLS))
    scope, judge = Scope(table, definitions, {}), Judge(definitions)
    lemmas: Lemmas = {}

    def verdict(goal: str, proof: Proof) -> Verdict:
        return prove(read_goal(goal, scope), scope, judge, Proven(proof), lemmas=lemmas)

    return verdict


def _is_shown(judged, goal: str, proof: Proof) -> bool:
    try:
        return judged(goal, proof).outcome not in (Outcome.UNCHECKED, Outcome.REFUTED)
    except GoalError:
        return False


OF_0 = Instance(0)
LATER = Induction(step=Congruence(r"\dot{Y}", Y=Instance(-1)))
SAME = Cut(
    r"2 a \cdot b = a \cdot b + a \cdot b",
    Kernel(),
    Congruence(r"\frac{1}{h} - \frac{1}{h} + Y", Y=Instance(-1)),
)
DOT = r"\dot{X}"
RATES = AndIntroduction(Congruence("Y", Y=OF_0), Congruence(r"\dot{Y}", Y=OF_0))
DIVIDED = Congruence(
    r"\dot{Y} - H \dot{c} - K c + c - (h - H) \dot{a} - (\dot{h} - K) a",
    Y=Instance(-1),
    H=Instance(0),
    K=Instance(0, part=1),
)
TURNING = Introductions(
    Cut(
        r"\forall Q \in SO_3^\mathbb{R} : \dot{Q} Q^T = - Q \dot{Q}^T",
        Kernel(),
        Congruence("Y", Y=Instance(-1, {"Q": "T"})),
    )
)

FALSE: dict[str, list[tuple[str, Proof]]] = {
    "what is so at one place says nothing of derivatives there": [
        (r"f = g \Rightarrow \frac{\partial f}{\partial q} = \frac{\partial g}{\partial q}", Congruence(r"\frac{\partial Y}{\partial q}", Y=OF_0)),
        (r"f = g \Longrightarrow \frac{\partial f}{\partial q} = \frac{\partial g}{\partial q}", Congruence(r"\frac{\partial Y}{\partial q}", Y=OF_0)),
        (r"f = g \Rightarrow \frac{df}{dq} = \frac{dg}{dq}", Congruence(r"\frac{dY}{dq}", Y=OF_0)),
        (r"w = p \Rightarrow \operatorname{div} w = \operatorname{div} p", Congruence(r"\operatorname{div} Y", Y=OF_0)),
        (r"w = p \Rightarrow G(w) = G(p)", Congruence("G(Y)", Y=OF_0)),
        (r"w = p \Longrightarrow G(w) = G(p)", Congruence("G(Y)", Y=OF_0)),
        (r"s = r \Rightarrow \operatorname{div} s = 3", Congruence(r"\operatorname{div} Y", Y=OF_0)),
        (r"\exists c \in V_3 : \operatorname{div} c = 3", ExistsIntroduction({"c": "r"})),
        (r"\exists k \in \mathbb{R} : \frac{\partial k}{\partial q} = 1", ExistsIntroduction({"k": "q"})),
        (r"\Big( \forall c \in V_3 : \operatorname{div} (T c) = 0 \Big) \Rightarrow \operatorname{div} (T r) = 0", Congruence("Y", Y=Instance(0, {"c": "r"}))),
    ],
    "what is so at one instant says nothing of derivatives there": [
        (r"a = b \Rightarrow \forall n \geq 0 : a^{(n)} = b^{(n)}", Induction(Congruence("Y", Y=OF_0), Congruence(r"\dot{Y}", Y=Instance(-1)))),
        (r"\forall n \geq 0 : a = b \Rightarrow a^{(n)} = b^{(n)}", Congruence("Y^{(n)}", Y=OF_0)),
        (r"a = b \Leftrightarrow a = b \wedge \dot{a} = \dot{b}", IffIntroduction(RATES, Congruence("Y", Y=OF_0))),
        (r"a = b \wedge \dot{a} = \dot{b} \Leftrightarrow a = b", IffIntroduction(Congruence("Y", Y=OF_0), RATES)),
        (r"\dot{a} \neq \dot{b} \Rightarrow a \neq b", Introductions(NegationIntroduction(0, Congruence(r"\dot{Y}", Y=Instance(-1))))),
        (r"h = 0 \wedge \dot{h} = 1 \Rightarrow \exists! c \in V_3^\mathbb{R} : h c = h a", Introductions(UniqueExists({"c": "a"}, only=DIVIDED))),
        (r"\forall n \geq 0 : a = b \Rightarrow V_n(a) = V_n(b)", Congruence("V_n(Y)", Y=OF_0)),
        (r"\forall c \in V_3 : c = a \Rightarrow \dot{a} = \mathbf{0}", Congruence(r"\dot{Y}", Y=Instance(0, back=True))),
        (r"\dot{a} = \mathbf{0}", Cut(r"\exists c \in V_3 : c = a", ExistsIntroduction({"c": "a"}), ExistsElimination(-1, Congruence(r"\dot{Y}", Y=Instance(-1, back=True))))),
        (r"\exists c \in V_3 : c = a \wedge \dot{c} = \dot{a}", ExistsIntroduction({"c": "a"})),
        (r"\forall c \in V_3 : \exists d \in V_3^\mathbb{R} : d = c \wedge \dot{d} = d", ExistsIntroduction({"d": "c"})),
        (r"\Big( a = b \Longrightarrow w = p \Big) \Rightarrow a = b \Rightarrow w = p", Congruence("Y", Y=OF_0)),
        (r"\Big( \forall Q \in SO_3^\mathbb{R} : Q a = Q b \Big) \Rightarrow \dot{a} = \dot{b}", Congruence(r"\dot{Y}", Y=Instance(0, {"Q": r"\mathbf{I}"}))),
        (r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \dot{T} T^T = - T \dot{T}^T", TURNING),
        (r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \exists Q \in SO_3^\mathbb{R} : Q = T \wedge \dot{Q} = \dot{T}", Introductions(ExistsIntroduction({"Q": "T"}))),
        (r"s^2 = 1 \wedge a^2 = 1 \Rightarrow \exists c \in {S^2}^\mathbb{R} : c = a \wedge \dot{c} = \dot{a}", Introductions(ExistsIntroduction({"c": "a"}))),
        (r"h \dot{h} = 0 \Rightarrow \dot{h} = 0", Introductions(Cases("h = 0", Congruence(r"\dot{Y}", Y=Instance(-1))))),
        (r"\Big( h \neq 0 \Longrightarrow a = b \Big) \Longrightarrow h \dot{a} = h \dot{b}", Introductions(Cases("h = 0", Kernel((1,)), Congruence(r"h \dot{Y}", Y=OF_0)))),
    ],
    "a map makes something of a value alone": [
        (r"\exists v \in V_3 \to V_3 : \Big( \forall c \in V_3 : v(c) = \mathbf{0} \Big) \wedge v(a) = \dot{a}", ExistsIntroduction({"v": DOT})),
        (r"\exists v \in V_3 \to V_3 : \Big( \forall c \in V_3 : v(c) = \mathbf{0} \Big) \wedge v(a) = \dot{a}", ExistsIntroduction({"v": r"\mathbf{D} X"})),
        (r"\Big( \forall v \in V_3 \to V_3 : v(a) = v(b) \Big) \Rightarrow \dot{a} = \dot{b}", Congruence("Y", Y=Instance(0, {"v": DOT}))),
    ],
    "nothing is said where it divides by 0": [
        (r"h \frac{1}{h} = 1", Cases(r"\frac{1}{h} = 1")),
        (r"\forall k \in \mathbb{R} : k \frac{1}{k} = 1", Introductions(Cases(r"\frac{1}{k} = 2"))),
        (r"\frac{1}{h} = \frac{1}{h} \Leftrightarrow 2 h = h + h", Kernel()),
        (r"\frac{1}{h} - \frac{1}{h} + 2 a \cdot b = a \cdot b + a \cdot b", SAME),
        (r"\frac{1}{h} P a - \frac{1}{h} P a + a = a", Kernel()),
        (r"\forall v \in V_3 \to V_3 : v(\frac{1}{h} a) - v(\frac{1}{h} a) + a = a", Kernel()),
        (r"\forall n \geq 0 : P H_n - P H_n + a = a", Kernel()),
        (r"\forall k \in \mathbb{R} : k \neq 0 \Rightarrow \frac{k}{h} \neq 0", Introductions(NegationIntroduction(0, Kernel((1,))))),
        (r"\forall n \geq 0 : \sum_{k=3}^n \frac{1}{h} y_k = \sum_{k=4}^{n+1} y_{k-1} \frac{1}{h}", Kernel()),
        (r"\forall n \geq 0 : \frac{n-5}{n-5} a^{(n)} = a^{(n)}", Kernel()),
        (r"\exists! k \in \mathbb{R} : k h = 1", UniqueExists({"k": r"\frac{1}{h}"}, only=Congruence(r"\frac{Y}{h}", Y=Instance(-1)))),
        (r"\exists X \in L(V_3, V_3) : X T = \mathbf{I}", ExistsIntroduction({"X": "T^{-1}"})),
    ],
    "a letter in use is no other's": [
        (r"\forall m, n \geq 1 : y_{n-1} + a - y_{m-1} = a", Kernel()),
        (r"\forall m \geq 0 : y_m = a \Rightarrow \forall n \geq 0 : B_n = y_m", Introductions(Cut(r"\forall k \geq 0 : B_k = y_m", Induction(Congruence("Y", Y=Instance(0, back=True)), Congruence("Z + Y - y_k", Y=Instance(-1, {"m": "k"}), Z=Instance(0, back=True)), letter="m"), Congruence("Y", Y=Instance(-1, {"k": "n"}))))),
    ],
    "a letter in the base of a recurrence is bound with it": [
        (r"\Big( \forall a \in V_3^\mathbb{R} : \forall n \geq 0 : d_n \times a = \mathbf{0} \Big) \Rightarrow \forall c \in V_3^\mathbb{R} : d_0 \times c = \mathbf{0}", Introductions(Congruence("Y", Y=Instance(0, {"a": "c", "n": "0"})))),
        (r"\Big( \forall s \in V_3 : \forall n \geq 0 : L_n \times s = \mathbf{0} \Big) \Rightarrow \forall c \in V_3 : \forall n \geq 0 : L_n \times c = \mathbf{0}", Introductions(Congruence("Y", Y=Instance(0, {"s": "c", "n": "n"})))),
        (r"\forall c \in V_3^\mathbb{R} : c = d_0 \Rightarrow \forall a \in V_3^\mathbb{R} : a = c", Introductions(Congruence("Y", Y=Instance(0, back=True)))),
        (r"\forall n \geq 0 : y_n = d_n \Rightarrow \forall a \in V_3^\mathbb{R} : y_n = d_n", Introductions(Congruence("Y", Y=OF_0))),
        (r"\forall n \geq 0 : \exists c \in V_3^\mathbb{R} : \forall a \in V_3^\mathbb{R} : c = d_n + \mathbf{0}", ExistsIntroduction({"c": "d_n"})),
    ],
    "the first members are not all": [
        *((r"\forall n \geq 0 : z_n = 0", by) for by in (Kernel(), Induction(), Induction(letter="m"), Induction(step=Congruence("Y", Y=Instance(-1))))),
        *((r"\forall n \geq 0 : N_n = h^{(n)}", by) for by in (Kernel(), Induction(), LATER)),
        (r"\forall n \geq 0 : N_{n+1} = \dot{N}_n", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} N_{k+1} = \sum_{k=0}^{n} \dot{N}_k", SumCongruence()),
        (r"\forall n \geq 0 : \sum_{k=1}^{n+1} N_k = \sum_{k=0}^{n} \dot{N}_k", Kernel()),
        (r"\forall n \geq 0 : 2 P M_{n+1} = P \dot{M}_n + P \dot{M}_n", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} y_k + n (n-1) (n-2) a^{(n)} = \sum_{k=0}^{n} y_k", Kernel()),
        (r"\forall m, n \geq 0 : m (m-1) (m-2) (M_{n+1} - \dot{M}_n) = \mathbf{0}", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=n}^{2n} P M_{k+1} = \sum_{k=n}^{2n} P \dot{M}_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} P M_{k+1} + \sum_{k=5}^{n} P M_{k+1} = \sum_{k=0}^{n} P \dot{M}_k + \sum_{k=5}^{n} P \dot{M}_k", Kernel()),
        (r"\forall n \geq 0 : X_n = \sum_{l=0}^{n} P \dot{M}_l", Kernel()),
        (r"\forall n \geq 0 : V_n(a) = a^{(n)}", LATER),
        *((r"\forall n \geq 0 : n (n-1) (n-2) a^{(n)} = \mathbf{0}", by) for by in (Kernel(), Induction())),
        (r"\forall n \geq 0 : C_n^3 a^{(n)} = \mathbf{0}", Kernel()),
        *((r"\forall n \geq 0 : \sum_{k=0}^{n} C_k^3 y_k = \mathbf{0}", by) for by in (Kernel(), Induction())),
        (r"\forall m, n \geq 0 : m n (m-1) (n-1) (m-2) (n-2) h = 0", Kernel()),
    ],
    "an operator is no other": [
        (r"\forall n \geq 0 : \sum_{k=0}^{n} (-P) y_k = \sum_{k=0}^{n} P y_k", Kernel()),
        (r"\forall n \geq 0 : n P a + \sum_{k=0}^{n} y_k = n O a + \sum_{k=0}^{n} y_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} P^n y_k = \sum_{k=0}^{n} y_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} (P O) y_k = \sum_{k=0}^{n} (O P) y_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} (P + \mathbf{D}) y_k = \sum_{k=0}^{n} (P y_k + y_k)", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} A_n y_k = \sum_{k=0}^{n} E_n", Kernel()),
        (r"\forall n \geq 0 : n P a = C_n^2 P a", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} P y_k \neq \sum_{k=1}^{n+1} P y_{k-1}", Kernel()),
    ],
    "off by one": [
        (r"\forall n \geq 0 : \sum_{k=0}^{n} y_k = y_0 + y_1 + \sum_{k=2}^{n} y_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=0}^{n} P y_k = P y_0 + P y_1 + \sum_{k=2}^{n} P y_k", Kernel()),
        (r"\forall n \geq 0 : \sum_{m=0}^{n} \sum_{k=0}^{m} P y_k = \sum_{m=0}^{n} \left( P y_0 + P y_1 + \sum_{k=2}^{m} P y_k \right)", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=1}^{n-1} C_n^k P (a^{(k)} \times b^{(n-k)}) = P (a \times b)^{(n)} - P (a \times b^{(n)}) - P (a^{(n)} \times b)", Kernel()),
        (r"\forall n \geq 1 : \sum_{k=0}^{n} C_{n-1}^{k-1} P (a^{(k-1)} \times b^{(n-k)}) = P (a \times b)^{(n-1)}", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=n}^{5} P y_k = \sum_{k=n}^{6} P y_k - P y_6", Kernel()),
        (r"\forall n \geq 0 : \sum_{k=1}^{n-1} P y_k = \sum_{k=0}^{n} P y_k - P y_0 - P y_n", Kernel()),
        (r"\forall n \geq 0 : S_n = \sum_{k=1}^{n} y_k", Induction(step=Congruence("Y + y_{n+1}", Y=Instance(-1)))),
        (r"\forall n \geq 0 : S_n = \sum_{k=0}^{n+1} y_k", Induction(step=Congruence("Y + y_{n+1}", Y=Instance(-1)))),
        (r"\forall n \geq 0 : \sum_{k=1}^{n-1} C_n^k a^{(k)} \times b^{(n-k)} = (a \times b)^{(n)} - a \times b^{(n)} - a^{(n)} \times b", Kernel()),
        (r"\forall n \geq 1 : \sum_{k=0}^{n} C_n^{k+1} a^{(k)} \times b^{(n-k)} = (a \times b)^{(n)}", Kernel()),
        (r"\forall n \geq 2 : \frac{d}{dt} \left(\sum_{k=0}^{n-3} C_{n-3}^k a^{(k)} \times b^{(n-3-k)}\right) = \sum_{k=0}^{n-2} C_{n-2}^k a^{(k)} \times b^{(n-2-k)}", Kernel()),
        (r"\Big( \forall n \geq 0 : a = \sum_{k=0}^{n} c_n y_k \Big) \Rightarrow \forall k \geq 0 : a = \sum_{l=0}^{k} c_l y_l", Introductions(Congruence("Y", Y=Instance(0, {"n": "k"})))),
        (r"\forall n \geq 0 : y_n = y_0", Induction(step=Congruence("Y", Y=Instance(-1, {"m": "n+1"})), letter="m")),
    ],
    "a wrong base": [
        (r"\forall n \geq 0 : e_n = 3 \cdot 2^n h", Induction(step=Congruence("2 Y", Y=Instance(-1)))),
        (r"\forall n \geq 1 : F_n = \mathbf{0}", Induction(step=Congruence(r"\dot{Y} + Y F_1", Y=Instance(-1)))),
        (r"\forall n \geq 1 : F_n = F_n^T", Induction(step=Congruence(r"\dot{Y} + Y F_1", Y=Instance(-1)))),
        (r"\forall n \geq 0 : d_n = a", Induction(step=Congruence("Z - Y", Y=Instance(-1, {"m": "n-1"}), Z=Instance(-1, {"m": "n"})), letter="m")),
    ],
    "one way, one part, one member": [
        (r"a \cdot b = 0 \Leftrightarrow a = \mathbf{0}", IffIntroduction(Kernel(), Congruence(r"Y \cdot b", Y=OF_0))),
        (r"\forall c \in \underline{V}_3 : c^2 = 0 \Rightarrow c = \mathbf{0}", ZeroFromSquare()),
        (r"\Big( \exists c \in V_3 : c \cdot a = c \cdot b \Big) \Rightarrow a = b", Introductions(ExistsElimination(0, Extensionality("d", Congruence("Y", Y=Instance(-1)))))),
        (r"\Big( \forall c \in V_3 : c \cdot a = 0 \Rightarrow c \cdot b = 0 \Big) \Rightarrow a = b", Extensionality("d", Congruence("Y", Y=Instance(0, {"c": "d"})))),
        (r"\exists k \in \mathbb{R} : h = k \wedge k \neq 0", ExistsIntroduction({"k": "h"})),
        (r"\forall Q \in SO_3 : \exists c \in V_3 : Q = \exp \tilde{c}", ExistsIntroduction({"c": r"\operatorname{vect} Q"})),
        (r"\exists! X \in L(V_3, V_3) : X s = s", UniqueExists({"X": r"\mathbf{I}"}, only=Extensionality("d", Congruence("Y", Y=Instance(-1))))),
        (r"a = a + \varepsilon b", Extensionality("d")),
        (r"a = b \Rightarrow a \neq b", Introductions(Congruence("Y", Y=OF_0))),
        (r"a = b \Rightarrow a \neq b", Introductions(Extensionality("d", Congruence(r"d \cdot Y", Y=OF_0)))),
        (r"h \frac{1}{h} = 1", Cases(r"h \neq 0")),
        (r"h^2 \geqslant 0 ; -h^2 \geqslant 0", AndIntroduction(SumOfSquares("h"), SumOfSquares("h"))),
        (r"h^2 \geqslant 1", SumOfSquares("h")),
    ],
}  # fmt: skip

TRUE: list[tuple[str, Proof]] = [
    (r"a = b \Longrightarrow \forall n \geq 0 : a^{(n)} = b^{(n)}", Induction(Congruence("Y", Y=OF_0), Congruence(r"\dot{Y}", Y=Instance(-1)))),
    (r"a = b \Rightarrow \forall v \in V_3 \to V_3 : v(a) = v(b)", Introductions(Congruence("v(Y)", Y=OF_0))),
    (r"\exists v \in V_3 \to V_3 : \forall c \in V_3 : v(2 c) = 2 v(c)", ExistsIntroduction({"v": "T X"})),
    (r"h \neq 0 \Rightarrow h \frac{1}{h} = 1", Introductions(Cases(r"\frac{1}{h} = 1"))),
    (r"h \neq 0 \Rightarrow \Big( \frac{1}{h} = \frac{1}{h} \Leftrightarrow 2 h = h + h \Big)", Kernel()),
    (r"h \neq 0 \Rightarrow \forall k \in \mathbb{R} : k \neq 0 \Rightarrow \frac{k}{h} \neq 0", Introductions(NegationIntroduction(1, Congruence("Y h", Y=Instance(-1))))),
    (r"\forall n \geq 0 : S_n = \sum_{k=0}^{n} y_k", Induction(step=Congruence("Y + y_{n+1}", Y=Instance(-1)))),
    (r"\forall n \geq 1 : \sum_{k=0}^{n} y_k = y_0 + y_1 + \sum_{k=2}^{n} y_k", Kernel()),
    (r"\forall n \geq 1 : \sum_{k=1}^{n-1} C_n^k a^{(k)} \times b^{(n-k)} = (a \times b)^{(n)} - a \times b^{(n)} - a^{(n)} \times b", Kernel()),
    (r"\forall n \geq 1 : \sum_{k=1}^{n-1} C_n^k P (a^{(k)} \times b^{(n-k)}) = P (a \times b)^{(n)} - P (a \times b^{(n)}) - P (a^{(n)} \times b)", Kernel()),
    (r"\forall n \geq 1 : \sum_{k=0}^{n-2} C_n^k h^{(k)} a^{(n-k)} = (h a)^{(n)} - n h^{(n-1)} \dot{a} - h^{(n)} a", Kernel()),
    (r"\forall n \geq 0 : \sum_{k=0}^{n} (P + \mathbf{D}) y_k = \sum_{k=0}^{n} (P y_k + \dot{y}_k)", Kernel()),
    (r"\forall n \geq 0 : \sum_{k=0}^{n} (P O) y_k = \sum_{k=0}^{n} P (O y_k)", Kernel()),
    (r"\forall n \geq 7 : N_{n+1} = \dot{N}_n", Kernel()),
    (r"\forall n \geq 0 : \sum_{k=n+2}^{2n+2} P y_{k+1} = \sum_{k=n+3}^{2n+3} P y_k", Kernel()),
    (r"\forall n \geq 0 : \sum_{k=2}^{n} P M_{k+1} = \sum_{k=2}^{n} P \dot{M}_k", Kernel()),
    (r"\forall n \geq 2 : 2 P M_{n+1} = P \dot{M}_n + P \dot{M}_n", Kernel()),
    (r"\forall n \geq 5 : V_{n+1}(a) = \dot{V}_n(a)", Kernel()),
    (r"\forall n \geq 0 : e_{n+2} = 4 e_n", Kernel()),
    (r"\Big( \forall c \in V_3 : c \cdot a = c \cdot b \Big) \Rightarrow a = b", Extensionality("d", Congruence("Y", Y=Instance(0, {"c": "d"})))),
    (r"\exists c \in V_3 : c = a", ExistsIntroduction({"c": "a + 0 b"})),
    (r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \exists Q \in SO_3 : Q = T", Introductions(ExistsIntroduction({"Q": "T"}))),
    (r"T T^T = \mathbf{I} \wedge \det T = 1 \Longrightarrow \exists Q \in SO_3^\mathbb{R} : Q = T \wedge \dot{Q} = \dot{T}", Introductions(ExistsIntroduction({"Q": "T"}))),
    (r"V_0(a) = b \Rightarrow \forall w \in V_3^\mathbb{R} : w \times V_0(a) = w \times b", Introductions(Congruence(r"w \times Y", Y=OF_0))),
    (r"\forall n \geq 1 : \sum_{k=1}^{n-1} P y_k = \sum_{k=0}^{n} P y_k - P y_0 - P y_n", Kernel()),
    (r"\forall c, d \in V_3 : c^2 + d^2 \geqslant 2 c \cdot d", SumOfSquares("c - d")),
    (r"\Big( \forall Q \in SO_3^\mathbb{R} : Q a = Q b \Big) \Longrightarrow \dot{a} = \dot{b}", Congruence(r"\dot{Y}", Y=Instance(0, {"Q": r"\mathbf{I}"}))),
    (r"T T^T = \mathbf{I} \wedge \det T = 1 \Longrightarrow \dot{T} T^T = - T \dot{T}^T", TURNING),
    (r"\Big( \forall c \in V_3 : \frac{d}{dt} (T c) = \frac{d}{dt} (U c) \Big) \Rightarrow \dot{T} = \dot{U}", Extensionality("d", Congruence("Y", Y=Instance(0, {"c": "d"})))),
    (r"\Big( \forall k < 2 : a^{(k)} = b^{(k)} \Big) \Rightarrow \Big( a = b \Rightarrow 2 a = w \Big) \Rightarrow a = b \Rightarrow 2 b = w", Congruence("Y + 2 Z - 2 a", Y=Instance(1), Z=Instance(2, back=True))),
    (r"a = b = w \wedge 2 p = w \Rightarrow w = 2 p", Congruence("Y", Y=Instance(0, part=2, back=True))),
]  # fmt: skip


@pytest.mark.parametrize("why", FALSE)
def test_no_false_goal_is_shown(judged, why):
    assert [goal for goal, proof in FALSE[why] if _is_shown(judged, goal, proof)] == []


@pytest.mark.parametrize(("goal", "proof"), TRUE)
def test_true_ones_of_the_same_shape_are(judged, goal, proof):
    found = judged(goal, proof)
    assert found.outcome == Outcome.PROVED, found.reason

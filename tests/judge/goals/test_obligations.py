"""What each rule asks the judge of formulas for: every equation, what it may suppose, and for which integers."""

import pytest

from tests.judge.goals.test_goals import scope
from workbench.language.goals.goal_reader import read_goal
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
    SumOfSquares,
    UniqueExists,
    UnitCircleAxiom,
    ZeroFromSquare,
)
from workbench.language.printing.printer import to_latex
from workbench.prover.goals.proof_rules import obligations
from workbench.prover.goals.sequents import Sequent

#: A goal and its proof; rule: statement | what is supposed | the least integers.
ASKED = [
    (
        r"\forall c \in V_3 : c \times c = \mathbf{0}",
        Kernel(),
        [
            r"formula: c \times c = \mathbf{0}",
        ],
    ),
    (
        r"\exists X \in L(V_3, V_3) : X R = \mathbf{I}",
        ExistsIntroduction({"X": "R^T"}),
        [
            r"formula: R^{T} R = \mathbf{I}",
        ],
    ),
    (
        r"\exists Q \in SO_3 : Q R = \mathbf{I}",
        ExistsIntroduction({"Q": "R^{-1}"}),
        [
            r"witness: a member of its set: R^{-1} \left[R^{-1}\right]^{T} = \mathbf{I}",
            r"witness: a member of its set: \det\left(R^{-1}\right) = 1",
            r"formula: R^{-1} R = \mathbf{I}",
        ],
    ),
    (
        r"a = b \Rightarrow \exists Q \in SO_3 : Q a = b",
        ExistsIntroduction({"Q": r"\mathbf{I}"}, using=()),
        [
            r"witness: a member of its set: \mathbf{I} \mathbf{I}^{T} = \mathbf{I}",
            r"witness: a member of its set: \det\left(\mathbf{I}\right) = 1",
            r"formula: \mathbf{I} a = b | a = b",
        ],
    ),
    (
        r"\exists c \in S^2 : c \cdot a = 0",
        ExistsIntroduction({"c": "b"}),
        [
            r"witness: a member of its set: b \cdot b = 1",
            r"formula: b \cdot a = 0",
        ],
    ),
    (
        r"\exists! Q \in SO_3 : Q R = \mathbf{I}",
        UniqueExists({"Q": "R^T R R^T"}, only=Congruence("Y R^T", Y=Instance(-1))),
        [
            r"∃!: a member of its set: R^{T} R R^{T} \left[R^{T} R R^{T}\right]^{T} = \mathbf{I}",
            r"∃!: a member of its set: \det\left(R^{T} R R^{T}\right) = 1",
            r"formula: R^{T} R R^{T} R = \mathbf{I}",
            "left side: Q = Q R R^{T}",
            r"right side: \mathbf{I} R^{T} = R^{T} R R^{T}",
        ],
    ),
    (
        r"\exists! c, d \in V_3 : c = a \wedge d = b",
        UniqueExists({"c": "a", "d": "b"}),
        [
            "formula: a = a",
            "formula: b = b",
            "formula: c = a | c = a, d = b",
            "formula: d = b | c = a, d = b",
        ],
    ),
    (
        r"\forall c \in V_3 : c^2 = 0 \Rightarrow c = \mathbf{0}",
        ZeroFromSquare(Kernel()),
        [
            "formula: c^{2} = 0 | c^{2} = 0",
        ],
    ),
    (
        r"\forall c \in \mathbb{R} : c^2 = 0 \Rightarrow c = 0",
        Introductions(ZeroFromSquare(Kernel(()))),
        [
            "formula: c^{2} = 0",
        ],
    ),
    (
        r"\forall c, d \in V_3 : c^2 d^2 \geqslant (c \cdot d)^2",
        SumOfSquares(r"c \times d", "0 c"),
        [
            r"≥: a sum of squares more: c^{2} d^{2} = \left(c \cdot d\right)^{2} + \left(\left(c \times d\right)^{2} + \left(0 c\right)^{2}\right)",
        ],
    ),
    (
        r"a = b \Leftrightarrow b = a",
        IffIntroduction(
            Congruence("Y", Y=Instance(0, back=True)), Congruence("2 Y - a", Y=Instance(0, back=True))
        ),
        [
            "left side: b = b",
            "right side: a = a",
            "left side: a = 2 a - a",
            "right side: 2 b - a = b",
        ],
    ),
    (
        r"a \neq b \Rightarrow \frac{a}{b^2} \neq \mathbf{0}",
        NegationIntroduction(0, Congruence("Y + b", Y=Instance(-1))),
        [
            r"defined: \left(\frac{a}{b^{2}} + \mathbf{0}\right) - \left(\frac{a}{b^{2}} + \mathbf{0}\right) = \mathbf{0} | a \neq b",
            r"left side: a = \frac{a}{b^{2}} + b | a \neq b",
            r"right side: \mathbf{0} + b = b | a \neq b",
        ],
    ),
    (
        r"\forall X \in L(V_3, V_3) : \Big( \forall c \in V_3 : X c = T c \Big) \Rightarrow X = T",
        Extensionality("d", Congruence("Y", Y=Instance(0, {"c": "d"}))),
        [
            "left side: X d = X d",
            "right side: T d = T d",
        ],
    ),
    (
        r"a = b",
        Extensionality("d", Kernel()),
        [
            r"formula: d \cdot a = d \cdot b",
        ],
    ),
    (
        r"\varepsilon a = \varepsilon b",
        Extensionality("d", Kernel()),
        [
            r"formula: d \cdot \varepsilon a = d \cdot \varepsilon b",
        ],
    ),
    (
        r"\forall f \in V_3 \to V_3 : \Big( \forall c \in V_3 : f(2 c) = f(c) \Big) \Rightarrow f(2 (2 a)) = f(a)",
        Introductions(Congruence("Y + Z - f(2 a)", Y=Instance(0, {"c": "2 a"}), Z=Instance(0, {"c": "a"}))),
        [
            r"left side: f\left(2 \left(2 a\right)\right) = f\left(2 \left(2 a\right)\right) + f\left(2 a\right) - f\left(2 a\right)",
            r"right side: f\left(2 a\right) + f\left(a\right) - f\left(2 a\right) = f\left(a\right)",
        ],
    ),
    (
        r"a \times b = \mathbf{0}",
        Cases(r"\frac{a}{b^2} = \mathbf{0}", Congruence(r"Y \times b", Y=Instance(-1)), Kernel()),
        [
            r"defined: \left(\frac{a}{b^{2}} + \mathbf{0}\right) - \left(\frac{a}{b^{2}} + \mathbf{0}\right) = \mathbf{0}",
            r"left side: a \times b = \frac{a}{b^{2}} \times b",
            r"right side: \mathbf{0} = \mathbf{0}",
            r"formula: a \times b = \mathbf{0} | \frac{a}{b^{2}} \neq \mathbf{0}",
        ],
    ),
    (
        r"2 (a \times b) = -2 b \times a",
        Cut(r"a \times b = -b \times a", Kernel(), Congruence("2 Y", Y=Instance(-1))),
        [
            r"formula: a \times b = -b \times a",
            r"left side: 2 \left(a \times b\right) = 2 \left(a \times b\right)",
            r"right side: 2 \left(-b \times a\right) = -2 b \times a",
        ],
    ),
    (
        r"a = b \Rightarrow 2 a = 2 b",
        Introductions(Kernel((0,))),
        [
            "formula: 2 a = 2 b | a = b",
        ],
    ),
    (
        r"a = b \Rightarrow 2 a = 2 b",
        Introductions(Kernel(())),
        [
            "formula: 2 a = 2 b",
        ],
    ),
    (
        r"2 a = a + a \wedge T - T = 0",
        AndIntroduction(Kernel(), Kernel()),
        [
            "formula: 2 a = a + a",
            r"formula: T - T = \mathbf{0}",
        ],
    ),
    (
        r"2 a = a + a \wedge T - T = 0",
        Kernel(),
        [
            "formula: 2 a = a + a",
            r"formula: T - T = \mathbf{0}",
        ],
    ),
    (
        r"2 a = a + a = 2 a",
        AndIntroduction(Kernel(), Kernel()),
        [
            "formula: 2 a = a + a",
            "formula: a + a = 2 a",
        ],
    ),
    (
        r"\forall n \geq 2 : F_n = F_n^T",
        Induction(begin=Kernel(), step=Congruence(r"Y^T", Y=Instance(-1))),
        [
            "formula: F_{2} = F_{2}^{T}",
            "left side: F_{n+1} = F_{n}^{T} | n ≥ 2",
            r"right side: \left(F_{n}^{T}\right)^{T} = F_{n+1}^{T} | n ≥ 2",
        ],
    ),
    (
        r"\forall n \geq 2 : F_n = F_n^T",
        Induction(step=Congruence(r"Y^T", Y=Instance(-1, {"k": "n"})), letter="k"),
        [
            "formula: F_{2} = F_{2}^{T}",
            "left side: F_{n+1} = F_{n}^{T} | n ≥ 2",
            r"right side: \left(F_{n}^{T}\right)^{T} = F_{n+1}^{T} | n ≥ 2",
        ],
    ),
    (
        r"\Big( \exists c \in V_3 : T c = a \Big) \Rightarrow \exists d \in V_3 : T d = 2 a",
        Introductions(
            ExistsElimination(0, ExistsIntroduction({"d": "2 c"}, Congruence("2 Y", Y=Instance(-1))))
        ),
        [
            r"left side: T \left[2 c\right] = 2 \left(T c\right)",
            "right side: 2 a = 2 a",
        ],
    ),
    (
        r"\forall c, d \in \mathbb{R} : c^2 + d^2 = 1 \Rightarrow \exists p \in \mathbb{R} : \cos p = c \wedge \sin p = d",
        UnitCircleAxiom(),
        [
            "∃: the angle of a point of the unit circle: c^{2} + d^{2} = 1 | c^{2} + d^{2} = 1",
        ],
    ),
    (
        r"T T^T = \mathbf{I} \wedge \det T = 1 \Rightarrow \det (R T) = 1",
        Cut(
            r"\forall P, Q \in SO_3 : \det (P Q) = 1",
            Kernel(),
            Introductions(
                Congruence(
                    "Y",
                    Y=Instance(
                        0,
                        {"P": "R", "Q": "T"},
                        members={
                            "Q": AndIntroduction(
                                Congruence("Y", Y=Instance(1)), Congruence("Y", Y=Instance(1, part=1))
                            )
                        },
                    ),
                )
            ),
        ),
        [
            r"formula: \det\left(P Q\right) = 1",
            "left side: T T^{T} = T T^{T}",
            r"right side: \mathbf{I} = \mathbf{I}",
            r"left side: \det T = \det T",
            "right side: 1 = 1",
            r"left side: \det\left(R T\right) = \det\left(R T\right)",
            "right side: 1 = 1",
        ],
    ),
    (
        r"a = b \Longrightarrow \dot{a} = \dot{b}",
        Congruence(r"\dot{Y}", Y=Instance(0)),
        [
            r"left side: \dot{a} = \dot{a}",
            r"right side: \dot{b} = \dot{b}",
        ],
    ),
    (
        r"a = b \wedge T a = b \Rightarrow T a = a",
        Congruence(r"Y - Z + a", Y=Instance(0, part=1), Z=Instance(0, back=False)),
        [
            "left side: T a = T a - a + a",
            "right side: b - b + a = a",
        ],
    ),
    (
        r"\Big( a = b \Rightarrow T a = b \Big) \Rightarrow a = b \Rightarrow T b = a",
        Congruence("Y", Y=Instance(0)),
        [
            "left side: T b = T a",
            "right side: b = a",
        ],
    ),
    (
        r"\Big( a = b \Rightarrow T a = b \Big) \Rightarrow T b = a",
        Congruence("Y", Y=Instance(0)),
        [
            "formula: a = b",
            "left side: T b = T a",
            "right side: b = a",
        ],
    ),
    (
        r"a \neq b \Rightarrow a = 2 b \Rightarrow T a = b",
        Congruence("Y", Y=Instance(1)),
        [
            r"left side: T a = a | a \neq b",
            r"right side: 2 b = b | a \neq b",
        ],
    ),
    (
        r"\Big( \forall n \geq 2 : F_n = T \Big) \Rightarrow \forall m \geq 1 : F_{m+3} = T",
        Congruence("Y", Y=Instance(0, {"n": "m+3"})),
        [
            "left side: F_{m+3} = F_{m+3} | m ≥ 1",
            "right side: T = T | m ≥ 1",
        ],
    ),
]


def told(obligation):
    parts = [
        f"{obligation.rule}: {to_latex(obligation.statement)}",
        ", ".join(map(to_latex, obligation.assume)),
    ]
    parts.append(", ".join(f"{name} ≥ {least}" for name, least in obligation.scope.integers.items()))
    return " | ".join(part for part in parts if part)


@pytest.mark.parametrize(("goal", "proof", "asked"), ASKED)
def test_a_proof_leaves_the_expected_obligations(goal, proof, asked):
    where = scope()
    assert list(map(told, obligations(Sequent(read_goal(goal, where), where), proof))) == asked

"""What anyone knows to hold is proved by both engines, with its derivatives; with anything added it is refuted."""

from dataclasses import replace

import pytest
from evaluator.identities import IDENTITIES, TABLE

from workbench.core.construct import apply, derivative, number, relation, symbol
from workbench.core.names import Name
from workbench.core.types import TENSOR, Declaration
from workbench.core.verdict import Outcome
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read
from workbench.prover.decide.decide import Judge

MORE = r"""
\underline{T} \underline{T}^* = (\det \underline{T}) \mathbf{I}
(\underline{T} \underline{S})^* = \underline{S}^* \underline{T}^*
(\underline{T} \underline{S})^T = \underline{S}^T \underline{T}^T
\det (\underline{T} \underline{S}) = \det \underline{T} \det \underline{S}
\det \underline{T}^T = \det \underline{T}
\operatorname{trace} (\underline{T} \underline{S}) = \operatorname{trace} (\underline{S} \underline{T})
\operatorname{sym} \underline{T} + \operatorname{skew} \underline{T} = \underline{T}
\operatorname{vect} \underline{T} \times \underline{a} = \operatorname{skew} \underline{T} \underline{a}
(\underline{a}, \underline{b}, \underline{x}) = (\underline{x}, \underline{a}, \underline{b})
(\underline{T} \underline{a}) \times (\underline{T} \underline{b}) = (\underline{T}^*)^T (\underline{a} \times \underline{b})
\underline{a} \times (\underline{b} \times \underline{x}) = (\underline{a} \cdot \underline{x}) \underline{b} - (\underline{a} \cdot \underline{b}) \underline{x}
(\underline{a} \otimes \underline{b}) \underline{x} = (\underline{b} \cdot \underline{x}) \underline{a}
\underline{R}^T \underline{R} = \mathbf{I}
\det \underline{R} = 1
\underline{R} (\underline{a} \times \underline{b}) = (\underline{R} \underline{a}) \times (\underline{R} \underline{b})
\dot{\underline{R}} \underline{R}^T = -\underline{R} \dot{\underline{R}}^T
\underline{u} \cdot \underline{u} = 1
\underline{u} \cdot \dot{\underline{u}} = 0 \underline{f}
\operatorname{Re} (\underline{T} \underline{a}) = \operatorname{Re} \underline{T} \operatorname{Re} \underline{a}
\operatorname{Du} (\underline{T} \underline{a}) = \operatorname{Re} \underline{T} \operatorname{Du} \underline{a} + \operatorname{Du} \underline{T} \operatorname{Re} \underline{a}
\underline{a} = \operatorname{Re} \underline{a} + \varepsilon \operatorname{Du} \underline{a}
\varepsilon \underline{a} = \varepsilon \operatorname{Re} \underline{a}
\sin^2 \underline{\alpha} + \cos^2 \underline{\alpha} = 1
\frac{d}{dt} \sin \underline{\alpha} = \dot{\underline{\alpha}} \cos \underline{\alpha}
\operatorname{Du} \sin \underline{\alpha} = \operatorname{Du} \underline{\alpha} \cos \operatorname{Re} \underline{\alpha}
\frac{d}{dt} (\underline{T} \underline{a}) = \dot{\underline{T}} \underline{a} + \underline{T} \dot{\underline{a}}
\exp(\underline{\alpha} \tilde{\underline{u}}) = \mathbf{I} + \sin \underline{\alpha} \tilde{\underline{u}} + (1 - \cos \underline{\alpha}) \tilde{\underline{u}}^2
\underline{q} \underline{q}^* \underline{p} = \underline{p} \underline{q} \underline{q}^*
\underline{e}^* \underline{e} = 1
(\dot{\underline{e}})^* \underline{e} = -\underline{e}^* \dot{\underline{e}}
\operatorname{Vec} (\underline{e} \underline{a} \underline{e}^*) \times \operatorname{Vec} (\underline{e} \underline{b} \underline{e}^*) = \operatorname{Vec} (\underline{e} (\underline{a} \times \underline{b}) \underline{e}^*)
\frac{d^3}{dt^3} (a \times b) = \dddot{a} \times b + 3 \ddot{a} \times \dot{b} + 3 \dot{a} \times \ddot{b} + a \times \dddot{b}
\sum_{k=0}^{2} \binom{2}{k} f^k g^{2-k} = (f + g)^2
(\mathbf{D}^2 + f \mathbf{D}) a = \ddot{a} + f \dot{a}
\frac{\mathbf{D}}{f} a = \frac{1}{f} \dot{a}
(-\mathbf{D}) a = -\dot{a}
(\mathbf{D} - \mathbf{D}) a = 0 a
(\mathbf{D} + f \mathbf{I})(\mathbf{D} - f \mathbf{I}) a = \ddot{a} - \dot{f} a - f^2 a
(\mathbf{D} + \tilde{a})^2 b = \ddot{b} + \dot{a} \times b + 2 a \times \dot{b} + a \times (a \times b)
(\mathbf{D} + \tilde{a})(\mathbf{D}^2 + T) b = \dddot{b} + \dot{T} b + T \dot{b} + a \times \ddot{b} + a \times (T b)
(\mathbf{D} + \tilde{\underline{a}})^2 \underline{b} = \ddot{\underline{b}} + \dot{\underline{a}} \times \underline{b} + 2 \underline{a} \times \dot{\underline{b}} + \underline{a} \times (\underline{a} \times \underline{b})
(\mathbf{D} + \tilde{x})^2 = \mathbf{D}^2 + 2 \tilde{x} \mathbf{D} + \widetilde{\dot{x}} + \tilde{x}^2
f (\mathbf{D} + T) = f \mathbf{D} + f T
\operatorname{div} (T \rho) = \operatorname{trace} T
\operatorname{curl} (a \times \rho) = 2 a
\operatorname{curl} (T \rho) = 2 \operatorname{vect} T
\operatorname{div} (\rho^2 a) = 2 a \cdot \rho
\operatorname{trace} T^* = \frac{1}{2} ((\operatorname{trace} T)^2 - \operatorname{trace} T^2)
T^3 = (\operatorname{trace} T) T^2 - (\operatorname{trace} T^*) T + (\det T) \mathbf{I}
(\|a\| b)^2 = a^2 b^2
\|a\|^3 = a^2 \|a\|
(\frac{f}{g})^2 g^2 = f^2
\frac{1}{f} - \frac{1}{g} = \frac{g - f}{f g}
\underline{a} \cdot \underline{J} \underline{b} = \underline{b} \cdot \underline{J} \underline{a}
\underline{E} \underline{G} = \underline{G} \underline{E}
\underline{q}^2 = \underline{q} \underline{q}
\underline{p}^3 = \underline{p} \underline{p} \underline{p}
\underline{q} \underline{q}^{-1} \underline{p} = \underline{p}
\underline{e}^{-1} = \underline{e}^*
\underline{T}^3 = \underline{T} \underline{T} \underline{T}
a^4 = (a \cdot a)(a \cdot a)
\underline{f}^3 = \underline{f} \underline{f} \underline{f}
\mathbf{D}^3 a = \dddot{a}
(\mathbf{D} + T)^0 a = a
\exp(\varepsilon \tilde{a}) = \mathbf{I} + \varepsilon \tilde{a}
\sin (\varepsilon f) = \varepsilon f
\cos (2 \varepsilon f) = 1
\sin (-\underline{\alpha}) = -\sin \underline{\alpha}
\sin (3 \underline{\alpha}) = 3 \sin \underline{\alpha} - 4 \sin^3 \underline{\alpha}
\det \begin{bmatrix} f & g \\ \dot{f} & \dot{g} \end{bmatrix} = f \dot{g} - g \dot{f}
\det \begin{bmatrix} T & a \\ b^T & f \end{bmatrix} = f \det T - b \cdot T^* a
\|\underline{a}\| \|\underline{a}\| = \underline{a} \cdot \underline{a}
\frac{1}{\underline{f}^2} = \frac{1}{\underline{f}} \frac{1}{\underline{f}}
\operatorname{Du} (\underline{T}^{-1} \underline{a}) = \operatorname{Du} \underline{T}^{-1} \operatorname{Re} \underline{a} + \operatorname{Re} \underline{T}^{-1} \operatorname{Du} \underline{a}
\frac{d^2}{dt^2} \frac{1}{f} = 2 \frac{\dot{f}^2}{f^3} - \frac{\ddot{f}}{f^2}
\|a\|^3 \frac{d^2}{dt^2} \|a\| = a^2 (\dot{a}^2 + a \cdot \ddot{a}) - (a \cdot \dot{a})^2
""".strip().splitlines()

BOTH = replace(
    TABLE,
    symbols=TABLE.symbols
    | SymbolTable.build(
        {
            **{rf"\underline{{{x}}}": {"kind": "dual tensor"} for x in "TS"},
            **{rf"\underline{{{x}}}": {"kind": "dual scalar"} for x in ("f", r"\alpha")},
            r"\underline{x}": {"kind": "dual vector"},
            r"\underline{p}": {"kind": "dual hamilton quaternion"},
            r"\underline{R}": {"kind": "dual rotation"},
            r"\underline{u}": {"kind": "dual vector", "unit": True},
            r"\rho": {"kind": "vector", "coordinate": True},
            **{x: {"kind": "vector", "uniform": True} for x in "ab"},
            "T": {"kind": "tensor", "uniform": True},
            r"\underline{J}": {"kind": "dual tensor", "symmetric": True},
            **{rf"\underline{{{x}}}": {"kind": "dual tensor", "diagonal": True} for x in "EG"},
        }
    ).symbols,
)
#: Neither proved nor refuted so far.
LEFT = {r"\|\exp(\operatorname{quat}(0, a))\| = 1"}
HOLDS = (Outcome.PROVED, Outcome.CONDITIONAL)  # where a denominator can vanish


def judged(left, right, **setting):
    return Judge(Definitions(), **setting).judge(relation("=", left, right))


@pytest.mark.parametrize("latex", [x for x in (*IDENTITIES, *MORE) if x not in LEFT])
def test_it_holds_and_nothing_may_be_added(latex):
    (claim,) = read(latex, BOTH)
    left, right = claim.left, claim.right
    kind = left.type.with_dual(left.type.dual or right.type.dual)
    is_operator = kind.algebra == "operator"
    kind = TENSOR if is_operator else kind
    added = apply("add", right, symbol(Declaration(Name(r"\mathsf{z}"), kind)))
    found = judged(left, right)
    assert found.outcome in HOLDS
    assert {e.outcome for e in found.evidence} & {"residual is 0"}, found.evidence
    if "^{-1}" not in latex and not is_operator:
        assert judged(derivative(left, 1), derivative(right, 1)).outcome in HOLDS
    wrong = judged(left, added)
    assert wrong.outcome == Outcome.REFUTED
    assert wrong.counterexample.left != wrong.counterexample.right
    assert judged(left, right, second_engine=False).outcome not in HOLDS
    double = judged(left, apply("mul", number(2), right)).outcome
    assert (double in HOLDS) == (judged(left, apply("neg", right)).outcome in HOLDS)  # both sides are 0


@pytest.mark.parametrize(
    "latex", [r"\operatorname{Du} \underline{J} = 0", r"\operatorname{Du} \underline{E} = 0"]
)
def test_the_dual_part_of_what_is_symmetric_is_free(latex):
    (claim,) = read(latex, BOTH)
    assert judged(claim.left, claim.right).outcome == Outcome.REFUTED

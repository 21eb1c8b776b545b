"""Formulas for the report's tests: typical ones by hand, and any number more from a grammar."""

from __future__ import annotations

from hypothesis import strategies as st
from sample_report import CLAIMS

PRINTED = [r.claim.shown for r in CLAIMS if r.claim.shown and r.claim.id != "L"]
TYPICAL = [
    *PRINTED,
    r"\begin{cases} \mathbf{v} - \mathbf{v}_Q = \dot{\mathbf{R}}\mathbf{R}^T \\ a = b, & n \geq 1 \end{cases}",
    r"\begin{bmatrix} \mathbf{R} & \mathbf{w} \\ \mathbf{0} & 1 \end{bmatrix}^{-1}",
    r"\left\{ \begin{array}{l} a \\ b \end{array} \right.",
    r"\underline{\overset{\circ}{\omega}} = \overset{\circ}{\omega}_1 \mathbf{u}_1",
    r"\mathbf{a}_\rho^{[n]} \stackrel{\text{def}}{=} \frac{d^n}{dt^n} \boldsymbol{\rho}, n \geq 1",
    r"\operatorname{curl} \mathbf{a}^{[1]} = 2\boldsymbol{\omega}, \quad \binom{n}{k} \bigl( x \bigr)^{12}",
    r"k = \overline{0, n-1}, \underline{S}\mathbb{O}_3 \subset \mathfrak{so}_3, x^12, \sqrt 2, \langle a, b \rangle",
]

_letters = st.sampled_from(["a", "t", r"\omega", r"\Phi", r"\rho", "2", "13", r"\varepsilon"])
_marks = st.sampled_from([r"\dot", r"\ddot", r"\dddot", r"\ddddot", r"\tilde", r"\widetilde", r"\underline"])
_styles = st.sampled_from([r"\mathbf", r"\boldsymbol"])
_operators = st.sampled_from([" + ", " - ", r" \cdot ", r" \times ", r" \otimes ", " = ", " ", r" \, "])


def _composed(inner: st.SearchStrategy[str]) -> st.SearchStrategy[str]:
    return st.one_of(
        st.builds("{1}{{{0}}}".format, inner, _marks),
        st.builds("{0}{2}{1}".format, inner, inner, _operators),
        st.builds("{{{0}}}_{{{1}}}^{{2}}".format, inner, inner),
        st.builds(r"\frac{{{0}}}{{{1}}}".format, inner, inner),
        st.builds(r"\left( {0} \right)^T".format, inner),
        st.builds("({0})".format, inner),
    )


formulas = st.recursive(
    st.one_of(_letters, st.builds("{1}{{{0}}}".format, _letters, _styles)), _composed, max_leaves=9
)

"""What is damaged in quaternions, matrices and half angles is found; what is no misprint gets no other form."""

from __future__ import annotations

import pytest

from workbench import check
from workbench.repair.propose.search_limits import Limits

SYMBOLS = {
    "e": {"kind": "hamilton quaternion", "unit": True},
    "h": {"kind": "hamilton quaternion", "unit": True},
    "p": "hamilton quaternion",
    "q": "hamilton quaternion",
    "m": {"kind": "scalar", "constant": True},
    "g": {"kind": "vector", "constant": True},
    "r": "vector",
    r"\theta": "scalar",
    "u": {"kind": "vector", "unit": True},
    "H": "transform",
    "G": "transform",
}
HALF = r"\cos\frac{\theta}{2}, \sin\frac{\theta}{2} u"
TURNED = r"\operatorname{quat}(0, \exp(\theta \tilde{u}) r)"
#: However busy the machine is.
PATIENT = Limits(seconds=250)
TURN = r"\begin{bmatrix} \cos\theta & -\sin\theta \\ \sin\theta & \cos\theta \end{bmatrix}"


@pytest.mark.parametrize(
    ("damaged", "right"),
    [
        (r"(e h)^{-1} = e^{-1} h^{-1}", r"\left(e h\right)^{-1} = h^{-1} e^{-1}"),
        (r"(p q)^* = q^* p", r"\left(p q\right)^{*} = q^{*} p^{*}"),
        (r"\sin\theta = \sin\frac{\theta}{2} \cos\frac{\theta}{2}", "2"),
        (r"\frac{d}{dt} \sin\theta = \dot{\theta} \sin\theta", r"\dot{\theta} \cos \theta"),
        pytest.param(rf"[{HALF}] r [{HALF}] = {TURNED}", "^{*}", marks=pytest.mark.slow),
        (rf"\exp([0, \theta u]) r \exp([0, -\frac{{\theta}}{{2}} u]) = {TURNED}", r"\frac{1}{2} \left(\theta u\right)"),
        (r"\sin\theta = 2 \sin\frac{\theta}{2} \cos\theta", r"\cos\left(\frac{1}{2} \theta\right)"),
        (r"(H G)^{-1} = H^{-1} G^{-1}", "G^{-1} H^{-1}"),
        (r"\exp(\theta \tilde{u}) = \mathbf{I} + \cos\theta \, \tilde{u} + (1 - \cos\theta) \tilde{u}^2", r"\sin \theta"),
        (
            rf"{TURN} \begin{{bmatrix}} \cos\theta & \sin\theta \\ \sin\theta & \cos\theta \end{{bmatrix}} = \mathbf{{I}}",
            r"\cos \theta & \sin \theta \\ -\sin \theta & \cos \theta",
        ),
        (r"\exp(\tilde{r})^T = \exp(\tilde{r})", r"= \exp\left(-\tilde{r}\right)"),
        (r"\exp(m + \theta) = \exp m + \exp\theta", r"\left(\exp m\right) \exp \theta"),
        (r"(\tilde{r} \tilde{g})^T = \tilde{g} \tilde{r} \tilde{g}", r"= \tilde{g} \tilde{r}"),
        (r"2 \sin^2\theta = \cos(2 \theta)", r"= 1 - \cos"),
        (r"\frac{d}{dt} (-m \cos\theta) = m \dot{\theta} \theta", r"\dot{\theta} \sin \theta"),
        (r"\|r \times g\| = \|r\| \|g\| \langle r, g \rangle", r"\sin \langle r, g \rangle"),
    ],
)  # fmt: skip
def test_damage_is_found(damaged: str, right: str) -> None:
    proposed = [proposal.latex for proposal in check(damaged, SYMBOLS).repair(PATIENT).proposals]
    assert any(right in latex for latex in proposed), proposed


@pytest.mark.parametrize("formula", ["1 = 2", r"m \ddot{r} = m g"])
def test_formulas_without_a_misprint_get_no_proposal(formula: str) -> None:
    assert check(formula, SYMBOLS).repair().proposals == []

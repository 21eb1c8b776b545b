"""The formulas of the chapter in their intended form, by equation number, with the symbols of each part.

Left out, because they are no identities of the language: (34), (71), (73), (78 but for its two conditions),
(82), (84), (85) speak of sets and maps, (81) is an infinite series, (102) a minimum over all points.
Chains with dots are given for a fixed number of bodies.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class Part:
    """Symbols and definitions, and (equation, formula) in reading order."""

    symbols: Mapping[str, Mapping[str, Any]]
    definitions: Mapping[str, str]
    formulas: tuple[tuple[str, str], ...]
    integers: tuple[str, ...] = ("n", "m", "p")


def _vector(weight: int | str | None = None, **more: Any) -> dict[str, Any]:
    return {"kind": "vector", **({} if weight is None else {"weight": weight}), **more}


def _tensor(weight: int | str | None = None, **more: Any) -> dict[str, Any]:
    return {**_vector(weight, **more), "kind": "tensor"}


def _dual(spec: dict[str, Any]) -> dict[str, Any]:
    return {**spec, "kind": f"dual {spec['kind']}"}


_R = {"kind": "rotation", "weight": 0}

REAL = Part(
    symbols={
        r"\boldsymbol{\rho}": _vector(0, coordinate=True, aliases=[r"\rho"]),
        r"\boldsymbol{\rho}_Q": _vector(0, aliases=[r"\rho_Q"]),
        r"\mathbf{r}": _vector(0, constant=True),
        r"\mathbf{R}": _R,
        r"\mathbf{R}_n": _R,
        r"\mathbf{w}_n": _vector(0),
        r"\mathbf{w}": _vector(),
        r"\mathbf{v}": _vector(1),
        r"\mathbf{v}_Q": _vector(1),
        r"\mathbf{a}": _vector(2),
        r"\mathbf{a}_Q": _vector(2),
        r"\omega": _vector(1, aliases=[r"\boldsymbol{\omega}"]),
        r"\boldsymbol{\varepsilon}": _vector(2),
        r"\boldsymbol{\varepsilon}^{[n]}": _vector("n"),
        r"\Phi_n": _tensor("n", aliases=[r"\boldsymbol{\Phi}_n", r"\phi_n"]),
        r"\mathbf{a}_n": _vector("n"),
        r"\mathbf{a}_\rho^{[n]}": _vector("n"),
        r"\mathbf{a}_Q^{[n]}": _vector("n"),
        r"\mathbf{a}_q^{[n]}": _vector("n"),
        r"\boldsymbol{\rho}_G": _vector(0),
        r"\boldsymbol{\rho}_{G_n}": _vector(0, aliases=[r"\rho_{G_n}"]),
        r"\boldsymbol{\rho}^*": _vector(0),
        r"\mathbf{a}^*": _vector(),
        r"\mathbf{P}_n": {"kind": "operator", "weight": "n-1"},
        r"\mathbf{I}_n": _vector("n"),
        r"\mathbf{J}_n": _vector("3n"),
        r"\mathbf{K}_{m,n}": _vector("m"),
        r"\Phi": _tensor(),
        r"\mathbf{S}": _tensor(),
        r"\mathbf{t}": _vector(),
        r"\mathbf{S}_n": _tensor("n"),
        r"\mathbf{t}_n": _vector("n"),
        r"\alpha": {"kind": "scalar", "weight": 4},
    },
    definitions={
        r"g": r"\begin{bmatrix} \mathbf{R} & \mathbf{w} \\ \mathbf{0} & 1 \end{bmatrix}",
        r"\Psi_n": r"\begin{bmatrix} \Phi_n & \mathbf{a}_n \\ \mathbf{0} & 0 \end{bmatrix}",
    },
    formulas=(
        ("1", r"\boldsymbol{\rho} = \rho_Q + \mathbf{R}\mathbf{r}"),
        (
            "2",
            r"\begin{cases} \mathbf{v} - \mathbf{v}_Q = \dot{\mathbf{R}}\mathbf{R}^T(\boldsymbol{\rho} - \rho_Q)"
            r" \\ \mathbf{a} - \mathbf{a}_Q = \ddot{\mathbf{R}}\mathbf{R}^T(\boldsymbol{\rho} - \rho_Q) \end{cases}",
        ),
        (
            "3",
            r"\left\{ \begin{array}{l} \boldsymbol{\Phi}_1 = \dot{\mathbf{R}}\mathbf{R}^T \\"
            r" \boldsymbol{\Phi}_2 = \ddot{\mathbf{R}}\mathbf{R}^T \end{array} \right.",
        ),
        ("4", r"\mathbf{a}_1 = \mathbf{v} - \Phi_1\boldsymbol{\rho} = \mathbf{v}_Q - \Phi_1\rho_Q"),
        ("5", r"\mathbf{v} - \mathbf{v}_Q = \Phi_1(\boldsymbol{\rho} - \boldsymbol{\rho}_Q)"),
        ("5.vect", r"\boldsymbol{\omega} = \text{vect}\Phi_1"),
        ("6", r"\mathbf{v} = \mathbf{a}_1 + \Phi_1\boldsymbol{\rho}"),
        ("7", r"\mathbf{a} - \mathbf{a}_Q = \Phi_2(\boldsymbol{\rho} - \boldsymbol{\rho}_Q)"),
        ("8", r"\mathbf{a} = \mathbf{a}_2 + \Phi_2\boldsymbol{\rho}"),
        ("9", r"\boldsymbol{\varepsilon} = \text{vect}\Phi_2"),
        ("9.det", r"\det\Phi_2 = -(\boldsymbol{\omega} \times \boldsymbol{\varepsilon})^2"),
        (
            "10",
            r"\Phi_2^{-1} = -\frac{1}{(\omega \times \boldsymbol{\varepsilon})^2} \left[ \boldsymbol{\varepsilon}"
            r" \otimes \boldsymbol{\varepsilon} + (\omega \otimes \omega)^2 -"
            r" \widetilde{\tilde{\omega}^2 \boldsymbol{\varepsilon}} \right]",
        ),
        ("11", r"\boldsymbol{\rho} = \Phi_2^{-1}(\mathbf{a} - \mathbf{a}_2)"),
        ("12", r"\boldsymbol{\rho}_G = -\Phi_2^{-1}\mathbf{a}_2"),
        (
            "13",
            r"\mathbf{a}_\rho^{[n]} \stackrel{\text{def}}{=} \frac{d^n}{dt^n} \boldsymbol{\rho}, n \geq 1",
        ),
        (
            "14",
            r"\mathbf{a}_\rho^{[n]} - \mathbf{a}_Q^{[n]} = \mathbf{R}^{(n)} \mathbf{R}^T (\boldsymbol{\rho} -"
            r" \boldsymbol{\rho}_Q), \text{ where } \mathbf{R}^{(n)} \stackrel{\text{def}}{=} \frac{d^n}{dt^n}"
            r" \mathbf{R}",
        ),
        ("15", r"\boldsymbol{\Phi}_n \stackrel{\text{def}}{=} \mathbf{R}^{(n)} \mathbf{R}^T"),
        (
            "16",
            r"\mathbf{a}_n = \mathbf{a}_\rho^{[n]} - \boldsymbol{\Phi}_n \boldsymbol{\rho} = \mathbf{a}_Q^{[n]} -"
            r" \boldsymbol{\Phi}_n \boldsymbol{\rho}_Q",
        ),
        (
            "17",
            r"\mathbf{a}_\rho^{[n]} - \mathbf{a}_Q^{[n]} = \Phi_n (\boldsymbol{\rho} - \boldsymbol{\rho}_Q)",
        ),
        (
            "18",
            r"\begin{aligned} \mathbf{a}_\rho^{[n]} - \mathbf{a}_Q^{[n]} &= \Phi_n (\rho - \rho_Q) \\ \mathbf{a}_n &="
            r" \mathbf{a}_\rho^{[n]} - \Phi_n \rho = \mathbf{a}_Q^{[n]} - \Phi_n \rho_Q \end{aligned}",
        ),
        ("19", r"\mathbf{a}_\rho^{[n]} = \mathbf{a}_n + \boldsymbol{\Phi}_n \boldsymbol{\rho}"),
        (
            "20",
            r"\begin{cases} \boldsymbol{\Phi}_{n+1} = \dot{\boldsymbol{\Phi}}_n + \boldsymbol{\Phi}_n"
            r" \boldsymbol{\Phi}_1 \\ \mathbf{a}_{n+1} = \dot{\mathbf{a}}_n + \boldsymbol{\Phi}_n \mathbf{a}_1"
            r" \end{cases}, n \geq 1, \text{ where } \boldsymbol{\Phi}_1 = \tilde{\boldsymbol{\omega}}, \mathbf{a}_1"
            r" = \mathbf{v}_Q - \boldsymbol{\Phi}_1 \boldsymbol{\rho}_Q",
        ),
        (
            "21",
            r"\begin{cases} \Phi_n = \Phi_{n-1} \Phi_1 + \left( \frac{d^{n-1}}{dt^{n-1}} \Phi_1 \right) +"
            r" \sum_{k=1}^{n-2} \left[ \frac{d^k}{dt^k} (\Phi_{n-k-1} \Phi_1) \right] \\ \mathbf{a}_n = \Phi_{n-1}"
            r" \mathbf{a}_1 + \left( \frac{d^{n-1}}{dt^{n-1}} \mathbf{a}_1 \right) + \sum_{k=1}^{n-2} \left["
            r" \frac{d^k}{dt^k} (\Phi_{n-k-1} \mathbf{a}_1) \right] \end{cases}, n \geq 3",
        ),
        (
            "22",
            r"\boldsymbol{\varepsilon}^{[n]} = \text{vect} \left\{ \Phi_n - \Phi_{n-1} \Phi_1 - \sum_{k=1}^{n-2}"
            r" \left[ \frac{d^k}{dt^k} (\Phi_{n-k-1} \Phi_1) \right] \right\}, n \geq 3",
        ),
        (
            "22.def",
            r"\boldsymbol{\varepsilon}^{[n]} \stackrel{\text{def}}{=} \frac{d^{n-1}}{dt^{n-1}} \omega",
        ),
        ("22.skew", r"\tilde{\boldsymbol{\varepsilon}}^{[n]} = \frac{d^{n-1}}{dt^{n-1}} \boldsymbol{\Phi}_1"),
        ("23", r"g = \begin{bmatrix} \mathbf{R} & \mathbf{w} \\ \mathbf{0} & 1 \end{bmatrix}"),
        (
            "24",
            r"\left\{ \begin{array}{l} \begin{bmatrix} \mathbf{R}_1 & \mathbf{w}_1 \\ \mathbf{0} & 1 \end{bmatrix}"
            r" \begin{bmatrix} \mathbf{R}_2 & \mathbf{w}_2 \\ \mathbf{0} & 1 \end{bmatrix} = \begin{bmatrix}"
            r" \mathbf{R}_1 \mathbf{R}_2 & \mathbf{R}_1 \mathbf{w}_2 + \mathbf{w}_1 \\ \mathbf{0} & 1 \end{bmatrix} \\"
            r" \begin{bmatrix} \mathbf{R} & \mathbf{w} \\ \mathbf{0} & 1 \end{bmatrix}^{-1} = \begin{bmatrix}"
            r" \mathbf{R}^T & -\mathbf{R}^T \mathbf{w} \\ \mathbf{0} & 1 \end{bmatrix} \end{array} \right.",
        ),
        (
            "25",
            r"\begin{bmatrix} \boldsymbol{\rho} \\ 1 \end{bmatrix} = \begin{bmatrix} \mathbf{R} & \boldsymbol{\rho}_Q"
            r" \\ \mathbf{0} & 1 \end{bmatrix} \begin{bmatrix} \mathbf{r} \\ 1 \end{bmatrix}",
        ),
        (
            "26",
            r"\begin{bmatrix} \dot{\boldsymbol{\rho}} \\ 0 \end{bmatrix} = \begin{bmatrix} \dot{\mathbf{R}} &"
            r" \dot{\boldsymbol{\rho}}_Q \\ \mathbf{0} & 0 \end{bmatrix} \begin{bmatrix} \mathbf{r} \\ 1"
            r" \end{bmatrix} = \begin{bmatrix} \dot{\mathbf{R}} & \dot{\boldsymbol{\rho}}_Q \\ \mathbf{0} & 0"
            r" \end{bmatrix} \begin{bmatrix} \mathbf{R}^T & -\mathbf{R}^T \boldsymbol{\rho}_Q \\ \mathbf{0} & 1"
            r" \end{bmatrix} \begin{bmatrix} \boldsymbol{\rho} \\ 1 \end{bmatrix}",
        ),
        (
            "28",
            r"\begin{bmatrix} \mathbf{a}_\rho^{[n]} \\ 0 \end{bmatrix} = \Psi_n \begin{bmatrix} \rho \\ 1"
            r" \end{bmatrix}",
        ),
        ("30", r"\Psi_{n+1} = \dot{\Psi}_n + \Psi_n \Psi_1, n \geq 1"),
        (
            "31",
            r"\Psi_n = \Psi_{n-1} \Psi_1 + \left( \frac{d^{n-1}}{dt^{n-1}} \Psi_1 \right) + \sum_{k=1}^{n-2} \left["
            r" \frac{d^k}{dt^k} (\Psi_{n-k-1} \Psi_1) \right], n \geq 3",
        ),
        (
            "33",
            r"\begin{aligned} \Psi_{n+1} &= \dot{\Psi}_n + \Psi_n \Psi_1, n \in \mathbb{N} \\ \Psi_1 &= \begin{bmatrix}"
            r" \tilde{\boldsymbol{\omega}} & \mathbf{v} \\ \mathbf{0} & 0 \end{bmatrix} \end{aligned}",
        ),
        ("36", r"\Psi_n = \mathbf{P}_n(\mathbf{D}) \Psi_1, n \in \mathbb{N}"),
        (
            "37",
            r"\begin{cases} \mathbf{P}_{n+1} = \mathbf{D}\mathbf{P}_n + \mathbf{P}_n(\tilde\omega) \\ \mathbf{P}_1 ="
            r" \mathbf{I} \end{cases}",
        ),
        (
            "38",
            r"\begin{cases} \mathbf{a}_n = \mathbf{P}_n \mathbf{v} \\ \Phi_n = \mathbf{P}_n \tilde{\omega} \end{cases},"
            r" n \in \mathbb{N}^*",
        ),
        (
            "40",
            r"\begin{aligned} \mathbf{P}_2 &= \mathbf{D} + \tilde{\omega} \\ \mathbf{P}_3 &= \mathbf{D}^2 +"
            r" \tilde{\omega}\mathbf{D} + 2\dot{\tilde{\omega}} + \tilde{\omega}^2 \\ \mathbf{P}_4 &= \mathbf{D}^3 +"
            r" \tilde{\omega}\mathbf{D}^2 + (3\dot{\tilde{\omega}} + \tilde{\omega}^2)\mathbf{D} +"
            r" 3\ddot{\tilde{\omega}} + 3\dot{\tilde{\omega}}\tilde{\omega} + 2\tilde{\omega}\dot{\tilde{\omega}} +"
            r" \tilde{\omega}^3 \end{aligned}",
        ),
        (
            "44",
            r"\begin{cases} \mathbf{a}_4 = \dddot{\mathbf{v}} + \tilde{\omega}\ddot{\mathbf{v}} +"
            r" (3\dot{\tilde{\omega}} + \tilde{\omega}^2)\dot{\mathbf{v}} + 3\ddot{\tilde{\omega}}\mathbf{v} +"
            r" 3\dot{\tilde{\omega}}\tilde{\omega}\mathbf{v} + 2\tilde{\omega}\dot{\tilde{\omega}}\mathbf{v} +"
            r" \tilde{\omega}^3\mathbf{v} \\ \Phi_4 = \dddot{\tilde{\omega}} + \tilde{\omega}\ddot{\tilde{\omega}} +"
            r" (3\dot{\tilde{\omega}} + \tilde{\omega}^2)\dot{\tilde{\omega}} +"
            r" 3\ddot{\tilde{\omega}}\tilde{\omega} + 3\dot{\tilde{\omega}}\tilde{\omega}^2 +"
            r" 2\tilde{\omega}\dot{\tilde{\omega}}\tilde{\omega} + \tilde{\omega}^4 \end{cases}",
        ),
        (
            "45",
            r"\mathbf{a}_\rho^{[n]} - \phi_n \boldsymbol{\rho} = \mathbf{a}_Q^{[n]} - \Phi_n \boldsymbol{\rho}_Q, n \in"
            r" \mathbb{N}^*.",
        ),
        ("46", r"\mathbf{I}_n = \mathbf{a}_\rho^{[n]} - \Phi_n \boldsymbol{\rho}, n \in \mathbb{N}^*"),
        (
            "48",
            r"\mathbf{J}_n = \Phi_n^* \mathbf{a}_\rho^{[n]} - (\det \Phi_n) \boldsymbol{\rho}, n \in \mathbb{N}^*.",
        ),
        ("48.adj", r"\Phi_n \Phi_n^* = (\det \Phi_n) \mathbf{I}"),
        ("49", r"\boldsymbol{\rho}^* = \Phi_n^{-1} (\mathbf{a}^* - \mathbf{a}_n), n \in \mathbb{N}^*."),
        ("50", r"\boldsymbol{\rho}_{G_n} = -\Phi_n^{-1} \mathbf{a}_n"),
        (
            "51",
            r"\mathbf{K}_{m,n} = \mathbf{a}_\rho^{[m]} - \Phi_m \Phi_n^{-1} \mathbf{a}_\rho^{[n]}, m, n \in \mathbb{N}^*.",
        ),
        (
            "52",
            r"\begin{aligned} \operatorname{div} \mathbf{a}_q^{[n]} &= \operatorname{trace} \Phi_n \\"
            r" \operatorname{curl} \mathbf{a}_q^{[n]} &= 2 \operatorname{vect} \Phi_n \end{aligned}",
        ),
        (
            "53",
            r"\begin{aligned} \Phi^* &= \mathbf{S}^* - \widetilde{\mathbf{S} \mathbf{t}} + \mathbf{t} \otimes \mathbf{t}"
            r" \\ \det \Phi &= \det \mathbf{S} + \mathbf{t} \cdot \mathbf{S}\mathbf{t} \end{aligned}",
        ),
        (
            "54",
            r"\begin{cases} \mathbf{t}_{n+1} = \dot{\mathbf{t}}_n + \frac{1}{2} [(\operatorname{trace} \Phi_n)"
            r" \mathbf{I} - \Phi_n^T] \boldsymbol{\omega} \\ \mathbf{t}_1 = \boldsymbol{\omega} \end{cases}",
        ),
        (
            "55",
            r"\begin{cases} \mathbf{S}_{n+1} = \dot{\mathbf{S}}_n + \operatorname{sym}(\Phi_n"
            r" \tilde{\boldsymbol{\omega}}) \\ \mathbf{S}_1 = \mathbf{0} \end{cases}",
        ),
        (
            "58",
            r"\begin{aligned} \Phi_2^* &= (\omega \otimes \omega)^2 - \widetilde{\tilde{\omega}^2 \dot{\omega}} +"
            r" \dot{\omega} \otimes \dot{\omega} \\ \det \Phi_2 &= -(\omega \times \dot{\omega})^2 \end{aligned}",
        ),
        ("58.iff", r"\det \Phi_2 \neq 0 \Leftrightarrow \omega \times \dot{\omega} \neq \mathbf{0}"),
        (
            "59",
            r"\Phi_2^{-1} = \frac{\widetilde{\tilde{\omega}^2 \dot{\omega}} - (\omega \otimes \omega)^2 -"
            r" \dot{\omega} \otimes \dot{\omega}}{(\omega \times \dot{\omega})^2}",
        ),
        (
            "61",
            r"\begin{aligned}\Phi_3^* &= \frac{9}{4} \left[ (\boldsymbol{\omega} \otimes \dot{\boldsymbol{\omega}})^2 +"
            r" (\dot{\boldsymbol{\omega}} \otimes \boldsymbol{\omega})^2 + (\boldsymbol{\omega} \times"
            r" \dot{\boldsymbol{\omega}}) \otimes (\dot{\boldsymbol{\omega}} \times \boldsymbol{\omega}) \right] -"
            r" \widetilde{\mathbf{S}_3 \mathbf{t}_3} + \mathbf{t}_3 \otimes \mathbf{t}_3 \\ \det \Phi_3 &="
            r" \frac{12(\mathbf{t}_3 \times \dot{\boldsymbol{\omega}}) \cdot (\boldsymbol{\omega} \times \mathbf{t}_3)"
            r" + 27\boldsymbol{\omega} \cdot \dot{\boldsymbol{\omega}}(\boldsymbol{\omega} \times"
            r" \dot{\boldsymbol{\omega}})^2}{4}.\end{aligned}",
        ),
        (
            "63",
            r"\begin{aligned} \mathbf{t}_4 &= \dddot{\omega} + \ddot{\omega} \times \omega - 2\omega^2\dot{\omega} -"
            r" 4(\omega \cdot \dot{\omega})\omega \\ \mathbf{S}_4 &= 2\operatorname{sym}(2\ddot{\tilde{\omega}}"
            r"\tilde{\omega} + \dot{\tilde{\omega}}\tilde{\omega}^2) + 3\dot{\tilde{\omega}}^2 + \tilde{\omega}^4"
            r" \end{aligned}",
        ),
        (
            "64",
            r"\mathbf{S}_4^* = 2\operatorname{sym} \left[ 3\dot{\tilde\omega}(\omega \otimes"
            r" \mathbf{w})\dot{\tilde\omega} - \alpha\omega \otimes \mathbf{w} \right] + 9 \dot\omega^2 \dot\omega"
            r" \otimes \dot\omega - 3\alpha\dot{\omega} \otimes \dot{\omega} + \alpha^2\mathbf{I}",
        ),
        (
            "66",
            r"\det \Phi_4 = \alpha \left[ 6(\boldsymbol{\omega} \times \dot{\boldsymbol{\omega}}) \cdot (\mathbf{w}"
            r" \times \dot{\boldsymbol{\omega}}) - (\boldsymbol{\omega} \times \mathbf{w})^2 + 2\alpha\boldsymbol{\omega}"
            r" \cdot \mathbf{w} + 3\alpha\dot{\boldsymbol{\omega}}^2 + \alpha^2 \right] -"
            r" 3(\dot{\boldsymbol{\omega}}, \boldsymbol{\omega}, \mathbf{w})^2",
        ),
        ("69", r"\Phi_4^{-1} = \frac{\Phi_4^*}{\det \Phi_4}"),
        ("70.implies", r"\det \Phi_4 \neq 0 \Rightarrow \rho_{G_4} = -\Phi_4^{-1} \mathbf{a}_4"),
        (
            "70",
            r"\begin{aligned} \operatorname{div} \mathbf{a}_q^{[4]} &= -2(4\omega \cdot \ddot{\omega} +"
            r" 3\dot{\omega}^2 - \omega^4) \\ \operatorname{curl} \mathbf{a}_q^{[4]} &= 2\dddot{\omega} +"
            r" 2\ddot{\omega} \times \omega - 4\omega^2 \dot{\omega} - 8(\omega \cdot \dot{\omega})\omega"
            r" \end{aligned}",
        ),
    ),
)

_POINT = ("A", "J", "H")
DUAL = Part(
    symbols={
        r"\mathbf{a}": _vector(),
        r"\mathbf{a}_0": _vector(),
        r"x": {"kind": "scalar", "weight": 0},
        r"x_0": {"kind": "scalar", "weight": 0},
        r"\underline{x}": {"kind": "dual scalar", "weight": 0},
        r"\underline{\mathbf{a}}": _dual(_vector()),
        r"\underline{\mathbf{b}}": _dual(_vector()),
        r"\underline{\mathbf{c}}": _dual(_vector()),
        r"\underline{\mathbf{T}}": _dual(_tensor()),
        r"\mathbf{T}": _tensor(),
        r"\mathbf{T}_0": _tensor(),
        r"\underline{\mathbf{v}}_n": _dual(_vector()),
        r"\lambda_n": {"kind": "scalar", "constant": True},
        r"\underline{\mathbf{R}}": _dual(_R),
        r"\mathbf{R}": _R,
        r"\rho": _vector(0, aliases=[r"\boldsymbol{\rho}"]),
        r"\underline{\alpha}": {"kind": "dual scalar", "weight": 0},
        r"\alpha": {"kind": "scalar", "weight": 0},
        r"d": {"kind": "scalar", "weight": 0},
        r"\mathbf{u}": _vector(0, unit=True),
        r"\mathbf{u}_0": _vector(0),
        r"\underline{\mathbf{u}}": _dual(_vector(0, unit=True)),
        r"\omega": _vector(1, aliases=[r"\boldsymbol{\omega}"]),
        r"\mathbf{v}": _vector(1),
        r"\underline{\omega}": _dual(_vector(1, aliases=[r"\underline{\boldsymbol{\omega}}"])),
        r"\underline{\mathbf{V}}_\rho": _dual(_vector(1)),
        r"\underline{\mathbf{V}}_P": _dual(_vector(1)),
        r"\underline{\mathbf{V}}_Q": _dual(_vector(1)),
        r"\mathbf{v}_\rho": _vector(1),
        r"\rho_P": _vector(0),
        r"\rho_Q": _vector(0),
        **{rf"\underline{{\mathbf{{{x}}}}}_\rho": _dual(_vector()) for x in _POINT},
        **{rf"\mathbf{{{x}}}_\rho": _vector() for x in (*_POINT, "a", "j", "h")},
        r"\underline{\mathbf{A}}_\rho^{[n]}": _dual(_vector("n+1")),
        r"\mathbf{A}_\rho^{[n]}": _vector("n+1"),
        r"\mathbf{A}_0^{[n]}": _vector("n+1"),
        r"\mathbf{a}_\rho^{[n]}": _vector("n+1"),
        r"\mathbf{a}_n": _vector("n"),
        r"\mathbf{P}_n": {"kind": "operator", "weight": "n-1"},
        r"\Psi_n": _vector("n"),
        r"\mathbf{y}": _vector(1),
    },
    definitions={},
    integers=("n",),
    formulas=(
        (
            "72",
            r"\cos \underline{x} = \cos x - \varepsilon x_0 \sin x, \sin \underline{x} = \sin x + \varepsilon x_0"
            r" \cos x",
        ),
        (
            "74",
            r"|\underline{\mathbf{a}}| = \begin{cases} \|\mathbf{a}\| + \varepsilon \frac{\mathbf{a}_0 \cdot"
            r" \mathbf{a}}{\|\mathbf{a}\|}, & \operatorname{Re}(\underline{\mathbf{a}}) \neq \mathbf{0} \\"
            r" \varepsilon \|\mathbf{a}_0\|, & \operatorname{Re}(\underline{\mathbf{a}}) = \mathbf{0} \end{cases}",
        ),
        (
            "74.triple",
            r"\langle \underline{\mathbf{a}}, \underline{\mathbf{b}}, \underline{\mathbf{c}} \rangle ="
            r" \underline{\mathbf{a}} \cdot (\underline{\mathbf{b}} \times \underline{\mathbf{c}})",
        ),
        (
            "75",
            r"\underline{\mathbf{T}}(\lambda_1 \underline{\mathbf{v}}_1 + \lambda_2 \underline{\mathbf{v}}_2) ="
            r" \lambda_1 \underline{\mathbf{T}}(\underline{\mathbf{v}}_1) + \lambda_2"
            r" \underline{\mathbf{T}}(\underline{\mathbf{v}}_2), \forall \lambda_1, \lambda_2 \in \mathbb{R},"
            r" \forall \underline{\mathbf{v}}_1, \underline{\mathbf{v}}_2 \in \underline{\mathbf{V}}_3",
        ),
        ("75.parts", r"\underline{\mathbf{T}} = \mathbf{T} + \varepsilon \mathbf{T}_0"),
        (
            "76",
            r"\underline{\mathbf{v}}_1 \cdot (\underline{\mathbf{T}} \underline{\mathbf{v}}_2) ="
            r" \underline{\mathbf{v}}_2 \cdot (\underline{\mathbf{T}}^T \underline{\mathbf{v}}_1), \forall"
            r" \underline{\mathbf{v}}_1, \underline{\mathbf{v}}_2 \in \underline{\mathbf{V}}_3",
        ),
        (
            "77",
            r"\langle \underline{\mathbf{T}} \underline{\mathbf{v}}_1, \underline{\mathbf{T}} \underline{\mathbf{v}}_2,"
            r" \underline{\mathbf{T}} \underline{\mathbf{v}}_3 \rangle = \det \underline{\mathbf{T}} \langle"
            r" \underline{\mathbf{v}}_1, \underline{\mathbf{v}}_2, \underline{\mathbf{v}}_3 \rangle.",
        ),
        (
            "77.cond",
            r"\text{Re} \langle \underline{\mathbf{a}}, \underline{\mathbf{b}}, \underline{\mathbf{c}} \rangle \neq 0",
        ),
        (
            "78",
            r"\underline{\mathbf{R}} \underline{\mathbf{R}}^T = \underline{\mathbf{I}}, \det \underline{\mathbf{R}} = 1",
        ),
        ("79", r"\underline{\mathbf{R}} = (\mathbf{I} + \varepsilon \tilde{\rho}) \mathbf{R}"),
        (
            "80",
            r"\underline{\mathbf{R}} = \mathbf{I} + \sin \underline{\alpha} \underline{\tilde{\mathbf{u}}} + (1 - \cos"
            r" \underline{\alpha}) \underline{\tilde{\mathbf{u}}}^2 = \exp(\underline{\alpha}"
            r" \underline{\tilde{\mathbf{u}}})",
        ),
        (
            "83",
            r"\begin{aligned} \mathbf{R} &= \mathbf{I} + \sin \alpha \tilde{\mathbf{u}} + (1 - \cos \alpha)"
            r" \tilde{\mathbf{u}}^2 \\ \boldsymbol{\rho} &= d \mathbf{u} + \sin \alpha \mathbf{u}_0 + (1 - \cos \alpha)"
            r" \mathbf{u} \times \mathbf{u}_0 \end{aligned}",
        ),
        ("85", r"\boldsymbol{\rho} = \text{vect}(\text{Du}(\underline{\mathbf{R}}) \cdot \mathbf{R}^T)"),
        (
            "88",
            r"\begin{aligned}\underline{\mathbf{R}}\underline{\mathbf{R}}^T &= \underline{\mathbf{I}} \\"
            r" \det\underline{\mathbf{R}} &= 1 \\ \underline{\mathbf{a}} \cdot \underline{\mathbf{b}} &="
            r" (\underline{\mathbf{R}}\underline{\mathbf{a}}) \cdot (\underline{\mathbf{R}}\underline{\mathbf{b}}), \forall"
            r" \underline{\mathbf{a}}, \underline{\mathbf{b}} \in \underline{\mathbf{V}}_3 \\"
            r" \underline{\mathbf{R}}(\underline{\mathbf{a}} \times \underline{\mathbf{b}}) &="
            r" \underline{\mathbf{R}}(\underline{\mathbf{a}}) \times \underline{\mathbf{R}}(\underline{\mathbf{b}}), \forall"
            r" \underline{\mathbf{a}}, \underline{\mathbf{b}} \in \underline{\mathbf{V}}_3\end{aligned}",
        ),
        (
            "89",
            r"\underline{\boldsymbol{\omega}} = \text{vect}\dot{\underline{\mathbf{R}}}\underline{\mathbf{R}}^T",
        ),
        ("90", r"\underline{\boldsymbol{\omega}} = \boldsymbol{\omega} + \varepsilon \mathbf{v}"),
        ("92", r"\mathbf{v} = \dot{\boldsymbol{\rho}} - \boldsymbol{\omega} \times \boldsymbol{\rho}"),
        ("93", r"\underline{\mathbf{V}}_\rho = \boldsymbol{\omega} + \varepsilon \mathbf{v}_\rho"),
        (
            "94",
            r"e^{\varepsilon \tilde{\boldsymbol{\rho}}} = \mathbf{I} + \varepsilon \tilde{\boldsymbol{\rho}}",
        ),
        (
            "95",
            r"e^{\varepsilon \tilde{\boldsymbol{\rho}}}\underline{\mathbf{V}}_\rho = \underline{\boldsymbol{\omega}}",
        ),
        (
            "97",
            r"\underline{\mathbf{V}}_P = e^{\varepsilon (\tilde{\rho}_Q - \tilde{\rho}_P)} \underline{\mathbf{V}}_Q",
        ),
        (
            "98",
            r"\begin{aligned} e^{\varepsilon \tilde{\rho}} \underline{\mathbf{A}}_\rho &= \underline{\dot{\omega}},"
            r" \forall \rho \in V_3 \\ e^{\varepsilon \tilde{\rho}} \underline{\mathbf{H}}_\rho &="
            r" \underline{\dddot{\omega}}, \forall \rho \in V_3 \end{aligned}",
        ),
        (
            "100",
            r"\begin{aligned} \mathbf{A}_\rho &= \mathbf{a}_\rho - \omega \times \mathbf{v}_\rho \\ \mathbf{H}_\rho &="
            r" \mathbf{h}_\rho - \omega \times \mathbf{j}_\rho - 3\dot{\omega} \times \mathbf{a}_\rho -"
            r" 3\ddot{\omega} \times \mathbf{v}_\rho \end{aligned}",
        ),
        ("102.part", r"Du|\underline{\dot{\omega}}| = \operatorname{Du} |\dot{\underline{\omega}}|"),
        (
            "103",
            r"e^{\varepsilon \tilde{\rho}} \underline{\mathbf{A}}_{\rho}^{[n]} = \underline{\omega}^{(n)} ="
            r" \frac{d^n \underline{\omega}}{dt^n}",
        ),
        ("104", r"\underline{\omega}^{(n)} = \omega^{(n)} + \varepsilon \mathbf{v}^{(n)}"),
        (
            "106",
            r"\mathbf{v}^{(n)} = \rho^{(n+1)} - \sum_{k=0}^n C_n^k \omega^{(k)} \times \rho^{(n-k)}, n \in \mathbb{N}",
        ),
        ("107", r"\mathbf{a}_{\rho}^{[n]} \triangleq \rho^{(n+1)}, n \in \mathbb{N}"),
        (
            "108",
            r"\mathbf{A}_{\rho}^{[n]} \triangleq \mathbf{a}_{\rho}^{[n]} - \sum_{k=0}^{n-1} C_n^k \omega^{(n-1-k)}"
            r" \times \mathbf{a}_{\rho}^{[k]}",
        ),
        ("109", r"\mathbf{A}_{\rho}^{[n]} = \mathbf{v}^{(n)} + \omega^{(n)} \times \rho"),
        (
            "110",
            r"\mathbf{A}_0^{[n]} = \mathbf{v}^{(n)} = \mathbf{a}_{n+1} - \sum_{k=1}^{n} C_n^k \omega^{(n-k)} \times"
            r" \mathbf{a}_k, n \in \mathbb{N}",
        ),
        ("111", r"\mathbf{a}_n = \mathbf{P}_n(\mathbf{v}), n \in \mathbb{N}"),
        (
            "112",
            r"\begin{cases} \mathbf{P}_{n+1} = \mathbf{D}\mathbf{P}_n + \mathbf{P}_n(\tilde{\omega}) \\ \mathbf{P}_1 ="
            r" \mathbf{I} \end{cases}",
        ),
        (
            "115",
            r"\begin{bmatrix} \Psi_1 \\ \Psi_2 \\ \Psi_3 \end{bmatrix} = \begin{bmatrix} \mathbf{I} & \mathbf{0} &"
            r" \mathbf{0} \\ \tilde{\omega} & \mathbf{I} & \mathbf{0} \\ 2\dot{\tilde{\omega}} + \tilde{\omega}^2 &"
            r" \tilde{\omega} & \mathbf{I} \end{bmatrix} \begin{bmatrix} \mathbf{y} \\ \dot{\mathbf{y}} \\"
            r" \ddot{\mathbf{y}} \end{bmatrix}",
        ),
        (
            "116",
            r"\begin{aligned} \mathbf{y}^{(n-1)} &= \Psi_n - \sum_{k=1}^{n-1} \mathbf{C}_{n-1}^k"
            r" \tilde{\omega}^{(n-1-k)} \Psi_k \\ \Psi_n &= \mathbf{P}_n \mathbf{y}, n \in \mathbb{N}^* \end{aligned}",
        ),
    ),
)

_TWIST = _dual(_vector(1))
CHAIN = Part(
    symbols={
        r"x": _TWIST,
        r"\underline{\mathbf{R}}": _dual(_R),
        r"{}^{k-1}\underline{\mathbf{R}}_k": _dual(_R),
        r"{}_0\underline{\omega}_m": {**_TWIST, "aliases": [r"{}_0\underline{\boldsymbol{\omega}}_m"]},
        r"\underline{\omega}_p": {**_TWIST, "aliases": [r"\underline{\boldsymbol{\omega}}_p"]},
        r"\underline{\Omega}_p": _TWIST,
        r"\underline{\omega}": _TWIST,
        r"\underline{\omega}_p^{[n]}": _dual(_vector("n+1")),
        r"\mathbf{D}^{[k]}": {"kind": "dual operator", "weight": "k"},
    },
    definitions={
        r"\underline{\Phi}_p": r"\underline{\mathbf{R}}^{(p)} \underline{\mathbf{R}}^T",
        r"\underline{\Phi}_0(x)": r"\mathbf{I}",
        r"\underline{\Phi}_{n+1}(x)": r"\dot{\underline{\Phi}}_n(x) + \underline{\Phi}_n(x) \tilde{x}",
        r"\mathbf{p}_n(x)": r"\sum_{k=0}^n C_n^k \underline{\Phi}_{n-k}(x) \mathbf{D}^{[k]}",
    },
    formulas=(
        (
            "117",
            r"\underline{\mathbf{R}} = {}^0\underline{\mathbf{R}}_1 \cdot {}^1\underline{\mathbf{R}}_2 \cdot"
            r" {}^{2}\underline{\mathbf{R}}_3",
        ),
        (
            "118",
            r"{}_0\underline{\boldsymbol{\omega}}_m = \text{vect} \underline{\dot{\mathbf{R}}}\underline{\mathbf{R}}^T",
        ),
        (
            "119",
            r"{}_0\underline{\omega}_3 = \underline{\Omega}_1 + {}^0\underline{\mathbf{R}}_1 \underline{\Omega}_2 +"
            r" {}^0\underline{\mathbf{R}}_1 \cdot {}^1\underline{\mathbf{R}}_2 \underline{\Omega}_3",
        ),
        (
            "120",
            r"\underline{\Omega}_p = \text{vect}\left( {}^{p-1}\underline{\dot{\mathbf{R}}}_p \cdot"
            r" {}^{p-1}\underline{\mathbf{R}}_p^T \right)",
        ),
        ("122", r"{}_0\underline{\boldsymbol{\omega}}_m = \sum_{k=1}^{m} \underline{\boldsymbol{\omega}}_k"),
        (
            "123",
            r"\underline{\omega}_p^{(n)} = \mathbf{p}_n(\underline{\omega}) \underline{\omega}_p, p = \overline{1, n}",
        ),
        ("124.D", r"\mathbf{D}^{[n]} \underline{\omega}_p = \underline{\omega}_p^{[n]}"),
        (
            "124",
            r"\mathbf{p}_n(\underline{\omega}) = \sum_{k=0}^n C_n^k \underline{\Phi}_{n-k}(\underline{\omega})"
            r" \mathbf{D}^{[k]},",
        ),
        (
            "125",
            r"\underline{\Phi}_p = \underline{\mathbf{R}}^{(p)} \cdot \underline{\mathbf{R}}^T, p = \overline{0, n}",
        ),
        (
            "126",
            r"\begin{cases} \underline{\Phi}_{p+1} = \dot{\underline{\Phi}}_p + \underline{\Phi}_p"
            r" \tilde{\underline{\omega}} \\ \underline{\Phi}_0 = \mathbf{I} \end{cases}, p \in \mathbb{N}.",
        ),
        (
            "127",
            r"\begin{aligned} {}_0\underline{\omega}_3^{(n)} = & \underline{\omega}_1^{(n)} +"
            r" \mathbf{p}_n(\underline{\omega}_1) \underline{\omega}_2 \\ & + \mathbf{p}_n(\underline{\omega}_1 +"
            r" \underline{\omega}_2) \underline{\omega}_3; \forall n \in \mathbb{N} \end{aligned}",
        ),
        (
            "131",
            r"{}_0\underline{\omega}_m^{(n)} = \underline{\omega}_1^{(n)} + \sum_{k=1}^{m-1}"
            r" \mathbf{p}_n({}_0\underline{\omega}_k) \underline{\omega}_{k+1}, \forall n \in \mathbb{N}",
        ),
        (
            "132",
            r"\underline{\Phi}_n(\underline{\omega}_1 + \underline{\omega}_2) = \sum_{k_1+k_2=n} C_n^{k_1, k_2}"
            r" \underline{\Phi}_{k_1}(\underline{\omega}_1) \underline{\Phi}_{k_2}(\underline{\omega}_2)",
        ),
        ("132.multinomial", r"C_n^{k, n-k} = \frac{n!}{k! (n-k)!}, k = \overline{0, n}"),
        (
            "133",
            r"\begin{aligned} {}_0\underline{\omega}_3^{(n)} &= \underline{\omega}_1^{[n]} + \underline{\omega}_2^{[n]} +"
            r" \underline{\omega}_3^{[n]} + \\ &+ \sum_{k=1}^n C_n^k \sum_{k_1+k_2=k} C_k^{k_1, k_2}"
            r" \underline{\Phi}_{k_1}(\underline{\omega}_1) \underline{\Phi}_{k_2}(\underline{\omega}_2)"
            r" \underline{\omega}_3^{[n-k]}, \end{aligned}",
        ),
        (
            "134",
            r"\begin{aligned} \underline{\Phi}_0(\underline{\omega}) &= \underline{\mathbf{I}} \\"
            r" \underline{\Phi}_1(\underline{\omega}) &= \tilde{\underline{\omega}} \end{aligned}",
        ),
        (
            "135",
            r"\underline{\Phi}_3(\underline{\omega}_1) = \tilde{\underline{\omega}}_1^{[2]} + \tilde{\underline{\omega}}_1"
            r" \tilde{\underline{\omega}}_1^{[1]} + 2\tilde{\underline{\omega}}_1^{[1]} \tilde{\underline{\omega}}_1 +"
            r" \tilde{\underline{\omega}}_1^3",
        ),
    ),
)

MANIPULATOR = Part(
    symbols={
        r"{}^i\underline{\mathbf{R}}_j": _dual(_R),
        r"\underline{\alpha}_i": {"kind": "dual scalar", "weight": 0},
        r"\alpha_i": {"kind": "scalar", "weight": 0},
        r"d_i": {"kind": "scalar", "weight": 0},
        r"{}_i\underline{\mathbf{u}}_j": _dual(_vector(0, unit=True, constant=True)),
        r"\underline{\mathbf{u}}_i": _dual(_vector(0, unit=True)),
        r"\underline{\omega}_i": {"kind": "dual scalar", "weight": 1},
        r"\underline{\omega}": _TWIST,
    },
    definitions={},
    formulas=(
        ("136", r"{}^0\underline{\mathbf{R}}_2 = {}^0\underline{\mathbf{R}}_1 {}^1\underline{\mathbf{R}}_2"),
        (
            "137",
            r"{}^0\underline{\mathbf{R}}_1 = e^{\underline{\alpha}_1(t) {}_0\tilde{\underline{\mathbf{u}}}_1}",
        ),
        (
            "140",
            r"\underline{\mathbf{u}}_2 = \left(\mathbf{I} + \sin \underline{\alpha}_1 {}_0\tilde{\underline{\mathbf{u}}}_1 +"
            r" (1 - \cos \underline{\alpha}_1) {}_0\tilde{\underline{\mathbf{u}}}_1^2\right)"
            r" {}_1\underline{\mathbf{u}}_2",
        ),
        ("141", r"\underline{\omega}_1 = \dot{\alpha}_1(t) + \varepsilon \dot{d}_1(t)"),
        (
            "143",
            r"\underline{\omega} = \underline{\omega}_1 \underline{\mathbf{u}}_1 + \underline{\omega}_2 \underline{\mathbf{u}}_2",
        ),
        (
            "145",
            r"\underline{\ddot{\omega}} = \ddot{\underline{\omega}}_1 \underline{\mathbf{u}}_1 + \ddot{\underline{\omega}}_2"
            r" \underline{\mathbf{u}}_2 + (2\underline{\omega}_1 \dot{\underline{\omega}}_2 + \dot{\underline{\omega}}_1"
            r" \underline{\omega}_2) \underline{\mathbf{u}}_1 \times \underline{\mathbf{u}}_2 + \underline{\omega}_1^2"
            r" \underline{\omega}_2 \underline{\mathbf{u}}_1 \times (\underline{\mathbf{u}}_1 \times"
            r" \underline{\mathbf{u}}_2)",
        ),
        (
            "147",
            r"\begin{aligned} \underline{\dddot{\omega}} = & [\dddot{\underline{\omega}}_1 + 3(\underline{\omega}_1^2"
            r" \dot{\underline{\omega}}_2 + \dot{\underline{\omega}}_1 \underline{\omega}_1 \underline{\omega}_2)"
            r" \underline{\mathbf{u}}_1 \cdot \underline{\mathbf{u}}_2] \underline{\mathbf{u}}_1 +"
            r" [\dddot{\underline{\omega}}_2 - 3(\underline{\omega}_1^2 \dot{\underline{\omega}}_2 +"
            r" \dot{\underline{\omega}}_1 \underline{\omega}_1 \underline{\omega}_2)] \underline{\mathbf{u}}_2 \\ & +"
            r" (\ddot{\underline{\omega}}_1 \underline{\omega}_2 + 3\dot{\underline{\omega}}_1 \dot{\underline{\omega}}_2"
            r" + 3\underline{\omega}_1 \ddot{\underline{\omega}}_2 - \underline{\omega}_1^3 \underline{\omega}_2)"
            r" \underline{\mathbf{u}}_1 \times \underline{\mathbf{u}}_2 \end{aligned}",
        ),
    ),
)

PARTS = {"real": REAL, "dual": DUAL, "chain": CHAIN, "manipulator": MANIPULATOR}

"""Sections 2 to 4."""

from tests.language.chapter.parts import ROTATION, Part, tensor, vector

REAL = Part(
    symbols={
        r"\boldsymbol{\rho}": vector(0, coordinate=True, aliases=[r"\rho"]),
        r"\boldsymbol{\rho}_Q": vector(0, aliases=[r"\rho_Q"]),
        r"\mathbf{r}": vector(0, constant=True),
        r"\mathbf{R}": ROTATION,
        r"\mathbf{R}_n": ROTATION,
        r"\mathbf{w}_n": vector(0),
        r"\mathbf{w}": vector(),
        r"\mathbf{v}": vector(1),
        r"\mathbf{v}_Q": vector(1),
        r"\mathbf{a}": vector(2),
        r"\mathbf{a}_Q": vector(2),
        r"\omega": vector(1, aliases=[r"\boldsymbol{\omega}"]),
        r"\boldsymbol{\varepsilon}": vector(2),
        r"\boldsymbol{\varepsilon}^{[n]}": vector("n"),
        r"\Phi_n": tensor("n", aliases=[r"\boldsymbol{\Phi}_n", r"\phi_n"]),
        r"\mathbf{a}_n": vector("n"),
        r"\mathbf{a}_\rho^{[n]}": vector("n"),
        r"\mathbf{a}_Q^{[n]}": vector("n"),
        r"\mathbf{a}_q^{[n]}": vector("n"),
        r"\boldsymbol{\rho}_G": vector(0),
        r"\boldsymbol{\rho}_{G_n}": vector(0, aliases=[r"\rho_{G_n}"]),
        r"\boldsymbol{\rho}^*": vector(0),
        r"\mathbf{a}^*": vector(),
        r"\mathbf{P}_n": {"kind": "operator", "weight": "n-1"},
        r"\mathbf{I}_n": vector("n"),
        r"\mathbf{J}_n": vector("3n"),
        r"\mathbf{K}_{m,n}": vector("m"),
        r"\Phi": tensor(),
        r"\mathbf{S}": tensor(),
        r"\mathbf{t}": vector(),
        r"\mathbf{S}_n": tensor("n"),
        r"\mathbf{t}_n": vector("n"),
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

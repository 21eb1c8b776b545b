"""Sections 5 and 6."""

from tests.language.chapter.parts import ROTATION, Part, dual, tensor, vector

_POINT = ("A", "J", "H")
DUAL = Part(
    symbols={
        r"\mathbf{a}": vector(),
        r"\mathbf{a}_0": vector(),
        r"x": {"kind": "scalar", "weight": 0},
        r"x_0": {"kind": "scalar", "weight": 0},
        r"\underline{x}": {"kind": "dual scalar", "weight": 0},
        r"\underline{\mathbf{a}}": dual(vector()),
        r"\underline{\mathbf{b}}": dual(vector()),
        r"\underline{\mathbf{c}}": dual(vector()),
        r"\underline{\mathbf{T}}": dual(tensor()),
        r"\mathbf{T}": tensor(),
        r"\mathbf{T}_0": tensor(),
        r"\underline{\mathbf{v}}_n": dual(vector()),
        r"\lambda_n": {"kind": "scalar", "constant": True},
        r"\underline{\mathbf{R}}": dual(ROTATION),
        r"\mathbf{R}": ROTATION,
        r"\rho": vector(0, aliases=[r"\boldsymbol{\rho}"]),
        r"\underline{\alpha}": {"kind": "dual scalar", "weight": 0},
        r"\alpha": {"kind": "scalar", "weight": 0},
        r"d": {"kind": "scalar", "weight": 0},
        r"\mathbf{u}": vector(0, unit=True),
        r"\mathbf{u}_0": vector(0),
        r"\underline{\mathbf{u}}": dual(vector(0, unit=True)),
        r"\omega": vector(1, aliases=[r"\boldsymbol{\omega}"]),
        r"\mathbf{v}": vector(1),
        r"\underline{\omega}": dual(vector(1, aliases=[r"\underline{\boldsymbol{\omega}}"])),
        r"\underline{\mathbf{V}}_\rho": dual(vector(1)),
        r"\underline{\mathbf{V}}_P": dual(vector(1)),
        r"\underline{\mathbf{V}}_Q": dual(vector(1)),
        r"\mathbf{v}_\rho": vector(1),
        r"\rho_P": vector(0),
        r"\rho_Q": vector(0),
        **{rf"\underline{{\mathbf{{{x}}}}}_\rho": dual(vector()) for x in _POINT},
        **{rf"\mathbf{{{x}}}_\rho": vector() for x in (*_POINT, "a", "j", "h")},
        r"\underline{\mathbf{A}}_\rho^{[n]}": dual(vector("n+1")),
        r"\mathbf{A}_\rho^{[n]}": vector("n+1"),
        r"\mathbf{A}_0^{[n]}": vector("n+1"),
        r"\mathbf{a}_\rho^{[n]}": vector("n+1"),
        r"\mathbf{a}_n": vector("n"),
        r"\mathbf{P}_n": {"kind": "operator", "weight": "n-1"},
        r"\Psi_n": vector("n"),
        r"\mathbf{y}": vector(1),
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

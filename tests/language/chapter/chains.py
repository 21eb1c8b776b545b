"""Sections 7 and 8."""

from tests.language.chapter.parts import ROTATION, TWIST, Part, dual, vector

CHAIN = Part(
    symbols={
        r"x": TWIST,
        r"\underline{\mathbf{R}}": dual(ROTATION),
        r"{}^{k-1}\underline{\mathbf{R}}_k": dual(ROTATION),
        r"{}_0\underline{\omega}_m": {**TWIST, "aliases": [r"{}_0\underline{\boldsymbol{\omega}}_m"]},
        r"\underline{\omega}_p": {**TWIST, "aliases": [r"\underline{\boldsymbol{\omega}}_p"]},
        r"\underline{\Omega}_p": TWIST,
        r"\underline{\omega}": TWIST,
        r"\underline{\omega}_p^{[n]}": dual(vector("n+1")),
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
        r"{}^i\underline{\mathbf{R}}_j": dual(ROTATION),
        r"\underline{\alpha}_i": {"kind": "dual scalar", "weight": 0},
        r"\alpha_i": {"kind": "scalar", "weight": 0},
        r"d_i": {"kind": "scalar", "weight": 0},
        r"{}_i\underline{\mathbf{u}}_j": dual(vector(0, unit=True, constant=True)),
        r"\underline{\mathbf{u}}_i": dual(vector(0, unit=True)),
        r"\underline{\omega}_i": {"kind": "dual scalar", "weight": 1},
        r"\underline{\omega}": TWIST,
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

"""Section 7: chains of any number m of bodies, derivatives of any order n.

Q̲ₘ = ⁰R̲₁ ¹R̲₂ … ᵐ⁻¹R̲ₘ is the motion of body m, ₀w̲ₘ its twist, w̲ₖ = Q̲ₖ₋₁ ω̲ₖ the twist of body k relative to
body k−1 as seen from C₀. Products and sums over bodies are recursions, and the proofs inductions over m;
over n they go by Pascal's rule.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    BinomialInduction,
    Congruence,
    Cut,
    Induction,
    Instance,
    Introductions,
    Kernel,
    Proof,
    Proven,
    SumCongruence,
)

# (117)–(122)

_Q = r"\underline{\mathbf{Q}}_m"
_AT_M = {"m": "m"}
_ORTHOGONAL = rf"\forall m \geq 0 : {_Q} {_Q}^T = \mathbf{{I}} \wedge \det {_Q} = 1"
_R = r"{}^{m}\underline{\mathbf{R}}_{m+1}"
_BY_FACTORS = Induction(
    step=Cut(
        rf"{_R} {_R}^T = \mathbf{{I}}",
        Kernel(),
        Cut(
            rf"\det {_R} = 1",
            Kernel(),
            AndIntroduction(
                Congruence(rf"{_Q} X {_Q}^T + Y - {_Q} {_Q}^T", X=Instance(-2), Y=Instance(-3)),
                Congruence("Y X", X=Instance(-1), Y=Instance(-3, part=1)),
            ),
        ),
    )
)
_IS_A_ROTATION = AndIntroduction(
    Congruence("Y", Y=Instance(0, _AT_M)), Congruence("Y", Y=Instance(0, _AT_M, part=1))
)
OF_A_PRODUCT = (
    r"\forall P, S \in \underline{SO}_3^\mathbb{R} : \operatorname{vect} (\frac{d}{dt}(P S) (P S)^T)"
    r" = \operatorname{vect}(\dot{P} P^T) + P \operatorname{vect}(\dot{S} S^T)"
)
_ONE_MORE = (
    r"\forall m \geq 0 : {}_0\underline{\mathbf{w}}_{m+1} ="
    r" {}_0\underline{\mathbf{w}}_m + \underline{\mathbf{w}}_{m+1}"
)


def _with_one_more(then: Proof) -> Proof:
    """₀w̲ₘ₊₁ = ₀w̲ₘ + w̲ₘ₊₁ is premise 2."""
    product = Instance(1, {"P": _Q, "S": _R}, members=_IS_A_ROTATION)
    by_product = Introductions(Congruence("Y", Y=product))
    return Cut(_ORTHOGONAL, _BY_FACTORS, Cut(OF_A_PRODUCT, Kernel(), Cut(_ONE_MORE, by_product, then)))


_NEXT = Instance(2, _AT_M)
_SUM = Induction(
    Congruence("Y", Y=Instance(2, {"m": "0"})),
    Congruence(r"Y + Z - {}_0\underline{\mathbf{w}}_m", Y=_NEXT, Z=Instance(-1)),
)
_FIRST = r"{}_0\underline{\mathbf{w}}_1"
_FOR_TWO = Cut(
    rf"{_FIRST} = \underline{{\mathbf{{w}}}}_1",
    Kernel(),
    Congruence(rf"Y + Z - {_FIRST}", Y=Instance(2, {"m": "1"}), Z=Instance(-1)),
)

# (123)–(131): y⁽ⁿ⁾ = Σ C(n, k) Φ̲ₙ₋ₖ(x) (D − x̃)ᵏ y, whatever twist x and vector y are

_XYN = {"x": "x", "y": "y", "n": "n"}
_LEMMA = Congruence(
    r"\sum_{k=0}^n C_n^k \underline{\mathbf{R}}^{(n-k)} (X (\frac{d^k}{dt^k} (X \underline{\Omega}_p)))",
    X=Instance(0, back=True),
)


def _expanded(Phi: str) -> str:
    return (
        r"\forall x, y \in \underline{V}_3^\mathbb{R} : \forall n \geq 0 : y^{(n)} ="
        rf" \sum_{{k=0}}^n C_n^k {Phi}_{{n-k}}(x) ((\mathbf{{D}} - \tilde{{x}})^k y)"
    )


def _with_p_n(Phi: str, p: str, then: Proof) -> Proof:
    """y⁽ⁿ⁾ = 𝐩ₙ(x) y is the last premise."""
    by_pascal = BinomialInduction(rf"{Phi}_j(x) ((\mathbf{{D}} - \tilde{{x}})^k y)")
    said = rf"\forall x, y \in \underline{{V}}_3^\mathbb{{R}} : \forall n \geq 0 : y^{{(n)}} = {p}_n(x) y"
    return Cut(
        _expanded(Phi), by_pascal, Cut(said, Introductions(Congruence("Z", Z=Instance(-1, _XYN))), then)
    )


_W, _NEW = r"{}_0\underline{\mathbf{w}}_{m+1}", r"\underline{\mathbf{w}}_{m+2}"
_DERIVATIVES = Induction(
    Cut(
        rf"{_FIRST} = \underline{{\mathbf{{w}}}}_1",
        Kernel(),
        Introductions(Congruence(r"\frac{d^n}{dt^n} Y", Y=Instance(-1))),
    ),
    Introductions(
        Congruence(
            rf"\frac{{d^n}}{{dt^n}} Y + (X - \frac{{d^n}}{{dt^n}} {_W}) + (Z - \frac{{d^n}}{{dt^n}} {_NEW})",
            X=Instance(5, {"n": "n"}),
            Y=Instance(2, {"m": "m+1"}),
            Z=Instance(4, {"x": _W, "y": _NEW, "n": "n"}),
        )
    ),
)
_SUMMED = Induction(
    step=Introductions(
        Congruence(
            "X + Z",
            X=Instance(-1, {"n": "n"}),
            Z=Instance(1, {"x": r"{}_0\underline{\omega}_m", "y": r"\underline{\omega}_{m+1}", "n": "n"}),
        )
    )
)

# (132), (133): 𝚽̲ₙ(x, y) is formed with the derivative in the frame whose twist is x

_PHI, _X = r"\underline{\Phi}", r"\underline{\mathbf{X}}"
_TWIST, _LAST = r"{}_0\underline{\omega}_{p+1}", r"\underline{\omega}_{p+2}"
_OWN = r"\underline{\boldsymbol{\Phi}}"
_OF_A_SUM = (
    r"\forall x, y \in \underline{V}_3^\mathbb{R} : \forall n \geq 0 : \underline{\Phi}_n(x + y) ="
    r" \sum_{j=0}^n C_n^j \underline{\Phi}_{n-j}(x) \underline{\boldsymbol{\Phi}}_j(x, y)"
)
_BY_PASCAL = BinomialInduction(rf"{_PHI}_j(x) {_OWN}_k(x, y)", step=r"\dot{Y} + Y \widetilde{x + y}")
_MULTINOMIAL = rf"\forall p \geq 0 : \forall k \geq 0 : {_PHI}_k({_TWIST}) = {_X}_{{p,k}}"


def _binomial_sum(of: str) -> str:
    return rf"\sum_{{j=0}}^k C_k^j {of} {_OWN}_j({_TWIST}, {_LAST})"


def _multinomial(sum_at: int, supposed_at: int) -> Proof:
    """By induction over the number of twists. sum_at, supposed_at: where Φ̲(x + y), and the sum for p, are
    premises."""
    whole = _binomial_sum(rf"{_PHI}_{{k-j}}({_TWIST})")
    inserted = _binomial_sum(rf"{_X}_{{p,k-j}}")
    one = Cut(
        r"{}_0\underline{\omega}_1 = \underline{\omega}_1",
        Kernel(),
        Congruence(rf"{_PHI}_k(Y)", Y=Instance(-1)),
    )
    addend = Congruence(rf"C_{{j+l}}^j Y {_OWN}_j({_TWIST}, {_LAST})", Y=Instance(supposed_at, {"k": "l"}))
    both = Congruence(
        rf"Y + Z - {whole}", Y=Instance(sum_at, {"x": _TWIST, "y": _LAST, "n": "k"}), Z=Instance(-1)
    )
    step = Introductions(Cut(f"{whole} = {inserted}", SumCongruence("j", addend), both))
    return Cut(_OF_A_SUM, _BY_PASCAL, Induction(Introductions(one), step))


_CLOSED = rf"\sum_{{k=0}}^n C_n^k {_X}_{{p,n-k}} {_LAST}^{{[k]}}"
_OPEN = (
    rf"\sum_{{k=0}}^n C_n^k {_PHI}_{{n-k}}({_TWIST})"
    rf" ((\mathbf{{D}} - {{}}_0\tilde{{\underline{{\omega}}}}_{{p+1}})^k {_LAST})"
)
_ONE_TWIST = Introductions(
    Cut(
        f"{_OPEN} = {_CLOSED}",
        SumCongruence(
            "k", Congruence(rf"C_{{k+j}}^k Y {_LAST}^{{[k]}}", Y=Instance(0, {"p": "p", "k": "j"}))
        ),
        Congruence(rf"Y + Z - {_OPEN}", Y=Instance(1, {"x": _TWIST, "y": _LAST, "n": "n"}), Z=Instance(-1)),
    )
)
_CLOSED_FORM = Cut(
    rf"\forall p \geq 0 : \forall n \geq 0 : \frac{{d^n}}{{dt^n}} {_LAST} = {_CLOSED}",
    _ONE_TWIST,
    Induction(
        step=Introductions(
            Congruence("X + Z", X=Instance(3, {"n": "n"}), Z=Instance(2, {"p": "m", "n": "n"}))
        )
    ),
)

THEOREMS = {
    "motion_of_last_body": Proven(Cut(_ORTHOGONAL, _BY_FACTORS, AndIntroduction(_IS_A_ROTATION, Kernel()))),
    "twists_add": Proven(_with_one_more(_SUM)),
    "relative_twist_is_the_difference": Proven(
        _with_one_more(
            Introductions(Congruence(r"Y - {}_0\underline{\mathbf{w}}_m", Y=Instance(2, _AT_M, back=True)))
        )
    ),
    "twists_of_two_add": Proven(_with_one_more(_FOR_TWO)),
    "lemma": Proven(
        Introductions(Cut(r"\underline{\mathbf{R}}^T \underline{\mathbf{R}} = \mathbf{I}", Kernel(), _LEMMA))
    ),
    "tensors_by_recurrence": Proven(
        Induction(step=Congruence(r"\dot{Y} + Y \tilde{\underline{\omega}}", Y=Instance(-1)))
    ),
    "theorem_11": Proven(_with_one_more(_with_p_n(r"\underline{\mathsf{F}}", r"\mathsf{p}", _DERIVATIVES))),
    "sums_of_derivatives": Proven(_with_p_n(_PHI, r"\mathbf{p}", _SUMMED)),
    "multinomial_identity": Proven(_multinomial(0, 1)),
    "closed_form_133": Proven(
        Cut(
            _MULTINOMIAL,
            _multinomial(0, 1),
            Cut(
                _expanded(_PHI),
                BinomialInduction(rf"{_PHI}_j(x) ((\mathbf{{D}} - \tilde{{x}})^k y)"),
                _CLOSED_FORM,
            ),
        )
    ),
}

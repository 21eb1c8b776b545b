"""Section 5.3, Theorems 6, 7 and (82): every orthogonal dual tensor has a dual angle and a dual axis.

A rotation Q by the angle a about w has the cosine c = (tr Q − 1)/2, and sym Q − c I = (1 − c) w ⊗ w: what of
its columns is not 0 is along the axis. Where all are 0, Q is I.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Cases,
    Congruence,
    Cut,
    ExistsElimination,
    ExistsIntroduction,
    Impossible,
    Instance,
    Introductions,
    Kernel,
    Proof,
    Proven,
    UnitCircleAxiom,
    ZeroFromSquare,
)

_BASIS = [rf"\begin{{bmatrix}} {a} \\ {b} \\ {c} \end{{bmatrix}}" for a, b, c in ("100", "010", "001")]


def _turn(angle: str, axis: str) -> str:
    return (
        rf"\mathbf{{I}} + \sin({angle}) \widetilde{{{axis}}} + (1 - \cos({angle})) (\widetilde{{{axis}}})^2"
    )


def _has_axis_and_angle(Q: str) -> Proof:
    """∃ a ∈ ℝ, w ∈ S² : Q = I + sin a w̃ + (1 − cos a) w̃²."""
    trace, vector = rf"\operatorname{{tr}}({Q})", rf"\operatorname{{vect}}({Q})"
    cosine = rf"\frac{{{trace} - 1}}{{2}}"
    columns = [rf"(\operatorname{{sym}}({Q}) - {cosine} \mathbf{{I}}) {e}" for e in _BASIS]
    none = [f"{column} = \\mathbf{{0}}" for column in columns]

    def along(column: str) -> Proof:
        axis = rf"\frac{{1}}{{\|{column}\|}} ({column})"
        sine = rf"\frac{{1}}{{\|{column}\|}} (({column}) \cdot {vector})"
        made = Congruence(
            rf"\mathbf{{I}} + Z \widetilde{{{axis}}} + (1 - Y) (\widetilde{{{axis}}})^2",
            Y=Instance(-1, back=True),
            Z=Instance(-1, part=1, back=True),
        )
        angle = rf"\exists b \in \mathbb{{R}} : \cos b = {cosine} \wedge \sin b = {sine}"
        return Cut(
            angle, UnitCircleAxiom(), ExistsElimination(-1, ExistsIntroduction({"a": "b", "w": axis}, made))
        )

    uses = {letter: Instance(place) for letter, place in zip("XYZ", (-3, -2, -1), strict=True)}
    of_columns = " + ".join(rf"{letter} \cdot {e}" for letter, e in zip("XYZ", _BASIS, strict=True))
    uses_before = {letter: Instance(use.premise - 2) for letter, use in uses.items()}
    products = " + ".join(rf"{letter} \otimes {e}" for letter, e in zip("XYZ", _BASIS, strict=True))
    at_rest = Cut(
        f"{trace} = 3",
        Congruence(f"3 - 2 ({of_columns})", **uses),
        Cut(
            rf"{vector} = \mathbf{{0}}",
            ZeroFromSquare(Congruence(r"1 - (\frac{Y - 1}{2})^2", Y=Instance(-1))),
            Cut(
                rf"{Q} = \mathbf{{I}}",
                Congruence(
                    rf"{products} + \frac{{T - 1}}{{2}} \mathbf{{I}} + \widetilde{{V}}",
                    **uses_before,
                    T=Instance(-2),
                    V=Instance(-1),
                ),
                ExistsIntroduction({"a": "0", "w": _BASIS[0]}, Congruence("Y", Y=Instance(-1))),
            ),
        ),
    )
    for column, equation in reversed(list(zip(columns, none, strict=True))):
        at_rest = Cases(equation, at_rest, along(column))
    return at_rest


#: R̲ = (I + ε r̃) Q, with Q by Euler's theorem.
_REAL = r"\operatorname{Re}(R)"
_SHIFTED = r"(\mathbf{I} + \varepsilon \tilde{r})"
#: u₀, the moment of the axis.
_MOMENT = r"\frac{1}{2} (\frac{\sin a}{1 - \cos a} (r - (w \cdot r) w) - w \times r)"


def _has_invariants() -> Proof:
    """∃ p ∈ ℝ̲, q ∈ S̲² : R = I + sin p q̃ + (1 − cos p) q̃²."""
    shift = r"\operatorname{vect}(\operatorname{Du}(R) (\operatorname{Re}(R))^T)"
    real, dual = Instance(1), Instance(3)  # Re R = I + sin a w̃ + (1 − cos a) w̃², Du R = r̃ Re R
    shifted = rf"{_SHIFTED} Y + \varepsilon (Z - \tilde{{r}} {_REAL})"
    still = rf"{_SHIFTED} ((S - \sin a) \tilde{{w}} + (\cos a - C) \tilde{{w}}^2)"
    translation = dict(Y=real, Z=dual, C=Instance(4), S=Instance(5))
    no_turn = Cut(
        r"\sin a = 0",
        ZeroFromSquare(Congruence("1 - Y^2", Y=Instance(-1))),
        Cases(
            r"r = \mathbf{0}",
            ExistsIntroduction(
                {"p": "0", "q": "w"},
                Congruence(
                    rf"{shifted} + {still} + \varepsilon (\tilde{{X}} - \tilde{{r}})",
                    **translation,
                    X=Instance(-1),
                ),
            ),
            ExistsIntroduction(
                {"p": r"\varepsilon \|r\|", "q": r"\frac{1}{\|r\|} r"},
                Congruence(f"{shifted} + {still}", **translation),
                using=(6,),
            ),
        ),
    )
    turn = ExistsIntroduction(
        {"p": r"a + \varepsilon (w \cdot r)", "q": rf"w + \varepsilon ({_MOMENT})"},
        Congruence(shifted, Y=real, Z=dual),
        using=(4,),
    )
    return Cut(
        rf"\exists a \in \mathbb{{R}}, w \in S^2 : {_REAL} = {_turn('a', 'w')}",
        _has_axis_and_angle(_REAL),
        ExistsElimination(
            -1,
            Cut(
                rf"\exists r \in V_3 : \operatorname{{Du}}(R) = \tilde{{r}} {_REAL}",
                ExistsIntroduction({"r": shift}, Kernel(using=())),
                ExistsElimination(-1, Cases(r"\cos a = 1", no_turn, turn)),
            ),
        ),
    )


_REPRESENTED = r"\exists p \in \underline{\mathbb{R}}, q \in \underline{S}^2 : R = " + _turn(
    "p", "q"
)  # Theorem 6
_EXPONENTIAL = rf"\exp(\widetilde{{p q}}) + Y - ({_turn('p', 'q')})"


def _screw() -> Proof:
    """∃ p ∈ ℝ̲, q ∈ S̲² : x = p q."""
    real, shift = r"\operatorname{Re}(x)", r"\operatorname{Du}(x)"
    size = rf"\|{real}\|"
    magnitude = rf"{size} + \varepsilon (\frac{{1}}{{{size}}} ({real} \cdot {shift}))"
    pure = Congruence(r"Y + \varepsilon \operatorname{Du}(x)", Y=Instance(0))
    return Cases(
        rf"{real} = \mathbf{{0}}",
        Cases(
            rf"{shift} = \mathbf{{0}}",
            ExistsIntroduction(
                {"p": "0", "q": _BASIS[0]}, Congruence(r"Y + \varepsilon Z", Y=Instance(0), Z=Instance(1))
            ),
            ExistsIntroduction(
                {"p": rf"\varepsilon \|{shift}\|", "q": rf"\frac{{1}}{{\|{shift}\|}} {shift}"}, pure
            ),
        ),
        ExistsIntroduction({"p": magnitude, "q": rf"\frac{{x}}{{{magnitude}}}"}),
    )


_IN_THE_GROUP = Cut(
    r"\exists p \in \underline{\mathbb{R}}, q \in \underline{S}^2 : x = p q",
    _screw(),
    ExistsElimination(
        -1,
        AndIntroduction(
            Congruence(r"\exp(\tilde{Y}) (\exp(\tilde{Y}))^T", Y=Instance(-1)),
            Congruence(r"\det(\exp(\tilde{Y}))", Y=Instance(-1)),
        ),
    ),
)
_ONTO = Cut(
    _REPRESENTED,
    _has_invariants(),
    ExistsElimination(
        -1, ExistsIntroduction({"x": "p q"}, Congruence(_EXPONENTIAL, Y=Instance(-1, back=True)))
    ),
)
_TO_AND_FRO = r"\exp(\widetilde{a w})", r"\exp(\widetilde{-a w})"

#: After half a turn, exp takes one value at a w and −a w; a map back would make a w = −a w, so a = 0.
_NO_INVERSE = Cut(
    r"\exists a \in \mathbb{R} : \cos a = -1 \wedge \sin a = 0",
    UnitCircleAxiom(),
    ExistsElimination(
        -1,
        Cut(
            r"\exists w \in S^2 : w \cdot w = 1",
            ExistsIntroduction({"w": _BASIS[0]}),
            ExistsElimination(
                -1,
                Cut(
                    " = ".join(_TO_AND_FRO),
                    Congruence(rf"{_TO_AND_FRO[1]} + 2 Y \tilde{{w}}", Y=Instance(2, part=1)),
                    Cut(
                        "a w = -a w",
                        Congruence(
                            f"X + L(Y) + Z - L({_TO_AND_FRO[0]}) - L({_TO_AND_FRO[1]})",
                            X=Instance(0, {"x": "a w"}, back=True),
                            Y=Instance(-1),
                            Z=Instance(0, {"x": "-a w"}),
                        ),
                        Cut(
                            "a = 0",
                            Congruence(r"\frac{1}{2} (a + w \cdot Y)", Y=Instance(-1)),
                            Congruence(r"\frac{1}{2} (\cos Y - Z)", Y=Instance(-1), Z=Instance(2)),
                        ),
                    ),
                ),
            ),
        ),
    ),
)

THEOREMS = {
    "representation_theorem": Proven(
        Introductions(
            Cut(
                _REPRESENTED,
                _has_invariants(),
                ExistsElimination(
                    -1,
                    ExistsIntroduction(
                        {"b": "p", "e": "q"},
                        AndIntroduction(Congruence("Y", Y=Instance(-1)), Congruence("Y", Y=Instance(-1))),
                    ),
                ),
            )
        )
    ),
    "exponential_is_onto": Proven(
        AndIntroduction(Introductions(_screw()), Kernel(), Introductions(_IN_THE_GROUP), Introductions(_ONTO))
    ),
    "logarithm_is_a_set": Proven(
        AndIntroduction(Introductions(_ONTO), Congruence(_EXPONENTIAL, Y=Instance(0, back=True)))
    ),
    "logarithm_is_no_inverse": Proven(against=Impossible(Introductions(_NO_INVERSE))),
}

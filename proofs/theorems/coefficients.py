"""Theorem 3, uniqueness: polynomials in D that make the same of every vector have the same coefficients.

At an instant there is a v of which v⁽ⁿ⁾ = c alone is not 0, of the derivatives to the order n: Σ Aₖ v⁽ᵏ⁾ is
Aₙ c then. So the last coefficients are equal, and so are the polynomials without them.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    At,
    Congruence,
    Cut,
    DerivativeAxiom,
    ExistsElimination,
    Extensionality,
    False_,
    Induction,
    Instance,
    Introductions,
    Proven,
    SumCongruence,
)


def _value(letter: str, degree: str, of: str = "u") -> str:
    return rf"\sum_{{k=0}}^{{{degree}}} \mathsf{{{letter}}}_k {of}^{{(k)}}"


def _same(degree: str) -> str:
    return rf"\forall u \in V_3^\mathbb{{R}} : {_value('A', degree)} = {_value('B', degree)}"


_BELOW = [_value(letter, "q-1", "v") for letter in "AB"]
_SOME = r"\exists v \in V_3^\mathbb{R} : \Big( \forall k < q : v^{(k)} = \mathbf{0} \Big) \wedge v^{(q)} = c"
_LAST = Introductions(
    Extensionality(
        "c",
        Introductions(
            Cut(
                _SOME,
                DerivativeAxiom(),
                ExistsElimination(
                    -1,
                    Cut(
                        " = ".join(_BELOW),
                        SumCongruence(
                            "l",
                            Introductions(
                                Congruence(
                                    r"\mathsf{A}_l Y + \mathsf{B}_l (v^{(l)} - Y)",
                                    Y=Instance(-1, {"k": "l"}),
                                )
                            ),
                        ),
                        Congruence(
                            r"Y - Z + \mathsf{A}_q (U - v^{(q)}) + \mathsf{B}_q (V - v^{(q)})",
                            Y=Instance(0, {"u": "v"}),
                            Z=Instance(-1),
                            U=Instance(-2, part=1, back=True),
                            V=Instance(-2, part=1),
                        ),
                    ),
                ),
            )
        ),
    )
)
_OF_LAST = rf"\forall q \geq 0 : \Big( {_same('q')} \Big) \Rightarrow \mathsf{{A}}_q = \mathsf{{B}}_q"


_OF_ANY = rf"\forall p, q \geq 0 : \Big( {_same('q+p')} \Big) \Rightarrow \mathsf{{A}}_q = \mathsf{{B}}_q"
_OF_V = [rf"\sum_{{k=0}}^{{j+i}} \mathsf{{{letter}}}_k \frac{{d^k}}{{dt^k}} \mathbf{{v}}" for letter in "AB"]
_BEFORE_THE_LAST = Cut(
    r"\mathsf{A}_{q+p+1} = \mathsf{B}_{q+p+1}",
    Congruence("Y", Y=Instance(0, {"q": "q+p+1"})),
    Cut(
        _same("q+p"),
        Introductions(Congruence("Y - Z u^{(q+p+1)}", Y=Instance(2, {"u": "u"}), Z=Instance(3))),
        Congruence("Y", Y=Instance(1, {"q": "q"})),
    ),
)

THEOREMS = {
    "operator_polynomial_is_unique": Proven(
        Cut(
            _OF_LAST,
            _LAST,
            Cut(
                _OF_ANY,
                Induction(
                    Introductions(Congruence("Y", Y=Instance(0, {"q": "q"}))), Introductions(_BEFORE_THE_LAST)
                ),
                Introductions(
                    Cut(
                        " = ".join(_OF_V),
                        Congruence(r"Y + Z - \mathbf{a}_n", Y=Instance(2, back=True), Z=Instance(2, part=2)),
                        Cut(
                            _same("j+i"),
                            Introductions(Congruence("Y", Y=Instance(3, {"u": "u"}))),
                            Congruence("Y", Y=Instance(1, {"p": "i", "q": "j"})),
                        ),
                    )
                ),
            ),
        ),
        against=At({"n": "1", "j": "0", "i": "1"}, False_()),
    )
}

"""Theorem 3, uniqueness: polynomials in D that make the same of every vector have the same coefficients.

At an instant there is a v of which v⁽ⁿ⁾ = c alone is not 0, of the derivatives to the order n: Σ Aₖ v⁽ᵏ⁾ is
Aₙ c then. So the last coefficients are equal, and so are the polynomials without them.
"""

from __future__ import annotations

from workbench.language.goals.proofs import (
    At,
    False_,
    Follows,
    Given,
    Have,
    Induction,
    Jet,
    Obtain,
    Pointwise,
    Proven,
    Termwise,
    Use,
)


def _value(letter: str, degree: str, of: str = "u") -> str:
    return rf"\sum_{{k=0}}^{{{degree}}} \mathsf{{{letter}}}_k {of}^{{(k)}}"


def _same(degree: str) -> str:
    return rf"\forall u \in V_3^\mathbb{{R}} : {_value('A', degree)} = {_value('B', degree)}"


_BELOW = [_value(letter, "q-1", "v") for letter in "AB"]
_SOME = r"\exists v \in V_3^\mathbb{R} : \Big( \forall k < q : v^{(k)} = \mathbf{0} \Big) \wedge v^{(q)} = c"
_LAST = Given(
    Pointwise(
        "c",
        Given(
            Have(
                _SOME,
                Jet(),
                Obtain(
                    -1,
                    Have(
                        " = ".join(_BELOW),
                        Termwise(
                            "l",
                            Given(
                                Follows(
                                    r"\mathsf{A}_l Y + \mathsf{B}_l (v^{(l)} - Y)",
                                    Y=Use(-1, {"k": "l"}),
                                )
                            ),
                        ),
                        Follows(
                            r"Y - Z + \mathsf{A}_q (U - v^{(q)}) + \mathsf{B}_q (V - v^{(q)})",
                            Y=Use(0, {"u": "v"}),
                            Z=Use(-1),
                            U=Use(-2, part=1, back=True),
                            V=Use(-2, part=1),
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
_BEFORE_THE_LAST = Have(
    r"\mathsf{A}_{q+p+1} = \mathsf{B}_{q+p+1}",
    Follows("Y", Y=Use(0, {"q": "q+p+1"})),
    Have(
        _same("q+p"),
        Given(Follows("Y - Z u^{(q+p+1)}", Y=Use(2, {"u": "u"}), Z=Use(3))),
        Follows("Y", Y=Use(1, {"q": "q"})),
    ),
)

THEOREMS = {
    "operator_polynomial_is_unique": Proven(
        Have(
            _OF_LAST,
            _LAST,
            Have(
                _OF_ANY,
                Induction(Given(Follows("Y", Y=Use(0, {"q": "q"}))), Given(_BEFORE_THE_LAST)),
                Given(
                    Have(
                        " = ".join(_OF_V),
                        Follows(r"Y + Z - \mathbf{a}_n", Y=Use(2, back=True), Z=Use(2, part=2)),
                        Have(
                            _same("j+i"),
                            Given(Follows("Y", Y=Use(3, {"u": "u"}))),
                            Follows("Y", Y=Use(1, {"p": "i", "q": "j"})),
                        ),
                    )
                ),
            ),
        ),
        against=At({"n": "1", "j": "0", "i": "1"}, False_()),
    )
}

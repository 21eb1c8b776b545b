"""Section 5.1, (72): a function f of a number, with the derivative g, extended to dual numbers."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    Congruence,
    Cut,
    ExistsIntroduction,
    Instance,
    Introductions,
    Kernel,
    Proven,
)

_REAL, _DUAL = r"\operatorname{Re}(a + \varepsilon c) = a", r"\operatorname{Du}(a + \varepsilon c) = c"
_REAL_X = r"\operatorname{Re}(X)"
_PARTS_OF_P = r"\operatorname{Re}(p) + \varepsilon \operatorname{Du}(p)"
_F, _U = Instance(0, {"a": "a", "c": "c"}), Instance(1, {"a": "a", "c": "c"})

THEOREMS = {
    "functions_of_dual_numbers": Proven(
        AndIntroduction(
            ExistsIntroduction(
                {"F": rf"f({_REAL_X}) + \varepsilon (\operatorname{{Du}}(X) g({_REAL_X}))"},
                Introductions(
                    Cut(
                        _REAL,
                        Kernel(),
                        Cut(
                            _DUAL,
                            Kernel(using=()),
                            Congruence(r"f(Y) + \varepsilon (Z g(Y))", Y=Instance(0), Z=Instance(1)),
                        ),
                    )
                ),
            ),
            Introductions(
                Cut(
                    f"p = {_PARTS_OF_P}",
                    Kernel(using=()),
                    Congruence(
                        f"F(Z) + Y - F({_PARTS_OF_P})",
                        Z=Instance(1),
                        Y=Instance(0, {"a": r"\operatorname{Re}(p)", "c": r"\operatorname{Du}(p)"}),
                    ),
                )
            ),
            Introductions(
                AndIntroduction(
                    Congruence("Y + Z", Y=_F, Z=_U),
                    Congruence("Y Z", Y=_F, Z=_U),
                    Congruence(
                        r"F(Y) + Z - F(u(a) + \varepsilon (c v(a)))",
                        Y=_U,
                        Z=Instance(0, {"a": "u(a)", "c": "c v(a)"}),
                    ),
                )
            ),
        )
    ),
}

"""Section 5.1, (72): a function f of a number, with the derivative g, extended to dual numbers."""

from __future__ import annotations

from workbench.language.goals.proofs import Each, Follows, Given, Have, Kernel, Proven, Use, Witness

_REAL, _DUAL = r"\operatorname{Re}(a + \varepsilon c) = a", r"\operatorname{Du}(a + \varepsilon c) = c"
_REAL_X = r"\operatorname{Re}(X)"
_PARTS_OF_P = r"\operatorname{Re}(p) + \varepsilon \operatorname{Du}(p)"
_F, _U = Use(0, {"a": "a", "c": "c"}), Use(1, {"a": "a", "c": "c"})

THEOREMS = {
    "functions_of_dual_numbers": Proven(
        Each(
            Witness(
                {"F": rf"f({_REAL_X}) + \varepsilon (\operatorname{{Du}}(X) g({_REAL_X}))"},
                Given(
                    Have(
                        _REAL,
                        Kernel(),
                        Have(
                            _DUAL,
                            Kernel(using=()),
                            Follows(r"f(Y) + \varepsilon (Z g(Y))", Y=Use(0), Z=Use(1)),
                        ),
                    )
                ),
            ),
            Given(
                Have(
                    f"p = {_PARTS_OF_P}",
                    Kernel(using=()),
                    Follows(
                        f"F(Z) + Y - F({_PARTS_OF_P})",
                        Z=Use(1),
                        Y=Use(0, {"a": r"\operatorname{Re}(p)", "c": r"\operatorname{Du}(p)"}),
                    ),
                )
            ),
            Given(
                Each(
                    Follows("Y + Z", Y=_F, Z=_U),
                    Follows("Y Z", Y=_F, Z=_U),
                    Follows(
                        r"F(Y) + Z - F(u(a) + \varepsilon (c v(a)))",
                        Y=_U,
                        Z=Use(0, {"a": "u(a)", "c": "c v(a)"}),
                    ),
                )
            ),
        )
    ),
}

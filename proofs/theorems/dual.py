"""Sections 5.1–5.3 and Theorem 9: the ring, module and group of (71)–(79), and the isomorphism (84)."""

from __future__ import annotations

from workbench.language.goals.proofs import (
    AndIntroduction,
    At,
    Broken,
    Congruence,
    Cut,
    ExistsIntroduction,
    Extensionality,
    False_,
    Instance,
    Introductions,
    Kernel,
    Proof,
    Proven,
    TwoWitnesses,
    UniqueExists,
)

# A map f that is linear over the dual numbers, by its values at a basis a, b, c of real vectors.
_COORDINATES = [
    rf"\frac{{\langle {triple} \rangle}}{{\langle a, b, c \rangle}}"
    for triple in ("x, b, c", "a, x, c", "a, b, x")
]
_OF_B_AND_C = f"{_COORDINATES[1]} b + {_COORDINATES[2]} c"
_OF_THEM = f"{_COORDINATES[0]} a + 1 ({_OF_B_AND_C})"
_PARTS = {
    letter: r" + ".join(
        rf"\frac{{1}}{{\langle a, b, c \rangle}} \operatorname{{{part}}}(f({image})) \otimes ({other})"
        for image, other in (("a", r"b \times c"), ("b", r"c \times a"), ("c", r"a \times b"))
    )
    for letter, part in (("T", "Re"), ("S", "Du"))
}
_LINEAR = {"p": _COORDINATES[0], "x": "a", "q": "1", "y": _OF_B_AND_C}
_LINEAR_AGAIN = {"p": _COORDINATES[1], "x": "b", "q": _COORDINATES[2], "y": "c"}
_BY_TENSORS = rf"({_PARTS['T']} + \varepsilon ({_PARTS['S']})) x"


def _part_of(name: str) -> Proof:
    both = dict(Y=Instance(-1, {"x": "e"}, back=True), Z=Instance(-2, {"x": "e"}))
    return Extensionality("e", Congruence(rf"\operatorname{{{name}}}(Y + Z - f(e))", **both))


_DECOMPOSED = Introductions(
    Cut(
        rf"\forall x \in \underline{{V}}_3 : f(x) = {_BY_TENSORS}",
        Introductions(
            Cut(
                f"x = {_OF_THEM}",
                Kernel(using=(0,)),
                Congruence(
                    f"f(X) + Y + Z - f({_OF_THEM}) - f({_OF_B_AND_C})",
                    X=Instance(-1),
                    Y=Instance(1, _LINEAR),
                    Z=Instance(1, _LINEAR_AGAIN),
                ),
            )
        ),
        UniqueExists(
            _PARTS,
            exists=Congruence("Y", Y=Instance(-1, {"x": "x"})),
            only=AndIntroduction(_part_of("Re"), _part_of("Du")),
        ),
    )
)

_INVERSE = r"\frac{\operatorname{Re}(p) - \varepsilon \operatorname{Du}(p)}{(\operatorname{Re}(p))^2}"
_A, _B, _C = r"\langle a, b, c \rangle", r"\langle d, b, c \rangle", r"\langle a, b, d \rangle"
_BODY = Instance(-1)


def structure(tensor: str) -> UniqueExists:
    """R̲ = (I + ε r̃) Q has Q = Re R̲ and r = vect(Du R̲ Qᵀ): the inverse of the map by both compositions."""
    real, dual = rf"\operatorname{{Re}}({tensor})", rf"\operatorname{{Du}}({tensor})"
    return UniqueExists(
        {"Q": real, "r": rf"\operatorname{{vect}}({dual} ({real})^T)"},
        only=AndIntroduction(
            Congruence(r"\operatorname{Re}(Y)", Y=Instance(-1, back=True)),
            Congruence(
                r"\operatorname{vect}(\operatorname{Du}(Y) (\operatorname{Re}(Y))^T)",
                Y=Instance(-1, back=True),
            ),
        ),
    )


def is_in_the_group() -> Proof:
    return ExistsIntroduction({"S": r"(\mathbf{I} + \varepsilon \tilde{r}) Q"})


THEOREMS = {
    "dual_numbers_are_a_ring": Proven(
        AndIntroduction(
            Kernel(),
            Kernel(),
            UniqueExists({"q": _INVERSE}, only=Congruence(rf"{_INVERSE} Y", Y=_BODY)),
            Congruence(rf"{_INVERSE} Y", Y=Instance(-1, part=1)),
        )
    ),
    "dual_vectors_are_a_free_module": Proven(
        AndIntroduction(
            Kernel(),
            UniqueExists(
                {
                    "p": rf"\frac{{\langle d, b, c \rangle}}{{{_A}}}",
                    "q": rf"\frac{{\langle a, d, c \rangle}}{{{_A}}}",
                    "r": rf"\frac{{\langle a, b, d \rangle}}{{{_A}}}",
                },
                only=AndIntroduction(
                    Congruence(rf"\frac{{\langle Y, b, c \rangle}}{{{_A}}}", Y=Instance(-1, back=True)),
                    Congruence(rf"\frac{{\langle a, Y, c \rangle}}{{{_A}}}", Y=Instance(-1, back=True)),
                    Congruence(rf"\frac{{\langle a, b, Y \rangle}}{{{_A}}}", Y=Instance(-1, back=True)),
                ),
            ),
        )
    ),
    "magnitude_of_a_dual_vector": Proven(
        AndIntroduction(
            UniqueExists(
                {"n": r"\frac{\mathbf{a}_0 \cdot \mathbf{a}}{\|\mathbf{a}\|}"},
                only=Congruence(r"\frac{\operatorname{Du}(Y)}{2 \|\mathbf{a}\|}", Y=_BODY),
            ),
            Kernel(),
            Kernel(),
            Kernel(),
        )
    ),
    "real_factors_do_not_make_a_dual_tensor": Proven(
        against=At({"f": r"\operatorname{Re}(X) - \varepsilon \operatorname{Du}(X)"}, Broken(False_()))
    ),
    "a_dual_tensor_is_two_tensors": Proven(_DECOMPOSED),
    "the_transpose_is_unique": Proven(
        UniqueExists(
            {"S": r"\underline{\mathbf{T}}^T"},
            only=Extensionality(
                "d", Extensionality("e", Congruence("Y", Y=Instance(-1, {"a": "d", "b": "e"}, back=True)))
            ),
        )
    ),
    "the_determinant_is_unique": Proven(
        AndIntroduction(
            UniqueExists(
                {"p": r"\det T"}, only=Congruence(rf"\frac{{Y}}{{{_A}}}", Y=Instance(-1, back=True))
            ),
            ExistsIntroduction({"p": r"\det T"}),
        )
    ),
    "orthogonal_dual_tensors_are_a_group": Proven(
        AndIntroduction(
            AndIntroduction(
                Congruence(r"B Y B^T + Z - B B^T", Y=Instance(2), Z=Instance(0)),
                Congruence("Y Z", Y=Instance(1), Z=Instance(3)),
            ),
            Kernel(),
            AndIntroduction(
                Congruence(
                    r"B^* Y B + (1 - Z) B^T B + (Z - \det B) \mathbf{I}", Y=Instance(0), Z=Instance(1)
                ),
                Congruence("Y", Y=Instance(1)),
                Congruence("Y", Y=Instance(0)),
            ),
            Kernel(),
        )
    ),
    "structure_theorem": Proven(structure(r"\underline{\mathbf{R}}")),
    "structure_theorem_with_underlines": Proven(
        against=TwoWitnesses(
            {"Q": r"\underline{\mathbf{R}}", "r": r"\mathbf{0}"},
            {"Q": r"(\mathbf{I} - \varepsilon \tilde{\rho}) \underline{\mathbf{R}}", "r": r"\rho"},
        )
    ),
    "isomorphism_theorem": Proven(AndIntroduction(Kernel(), Kernel(), is_in_the_group(), structure("S"))),
    "dual_tensors_move_lines": Proven(
        AndIntroduction(Kernel(), structure(r"\underline{\mathbf{R}}"), is_in_the_group())
    ),
}

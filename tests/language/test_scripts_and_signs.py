"""What stands above a term, in fractions, behind functions and beside signs: what it is read as, or where and why not."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from workbench.language.naming.symbols import SymbolTable
from workbench.language.printing.printer import to_latex
from workbench.language.reader import read_term
from workbench.language.typed.errors import IllFormedAt, ReadError

PLAIN = {
    r"\lambda": "scalar",
    r"\mu": "scalar",
    "x": "vector",
    "y": "vector",
    "A": "tensor",
    "B": "tensor",
    "H": "matrix 4×4",
    "u": "matrix 6×1",
}
WITH_QUATERNIONS = PLAIN | {
    "q": "hamilton quaternion",
    "p": "hamilton quaternion",
    r"\underline{q}": "dual hamilton quaternion",
}


def reads(
    latex: str, expected: str, kinds: dict[str, str], *variables: str, loose: frozenset[str] = frozenset()
) -> None:
    """expected: the term as it is printed; "refused" or "misfit" with the column and the beginning of the message."""
    table = replace(SymbolTable.build({name: {"kind": kind} for name, kind in kinds.items()}), loose=loose)
    verdict, _, told = expected.partition(" ")
    if verdict in ("refused", "misfit"):
        with pytest.raises(
            ReadError if verdict == "refused" else IllFormedAt, match=re.escape(f"column {told}")
        ):
            read_term(latex, table, variables)
    else:
        assert to_latex(read_term(latex, table, variables)) == expected


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"A^T", r"A^{T}"),
        (r"A^{\mathrm{T}}", r"A^{T}"),
        (r"A^{\mathsf{T}}", r"A^{T}"),
        (r"A^{-T}", r"\left(A^{-1}\right)^{T}"),
        (r"A^{-1}", r"A^{-1}"),
        (r"A^{-2}", r"\left(A^{2}\right)^{-1}"),
        (r"A^{-n}", r"A^{-n}"),
        (r"A^0", r"A^{0}"),
        (r"A^1", r"A^{1}"),
        (r"A^2", r"A^{2}"),
        (r"A^n", r"A^{n}"),
        (r"A^*", r"A^{*}"),
        (r"x^*", r"refused 3: * on a vector; declare the symbol with it, o"),
        (r"\lambda^*", r"refused 9: * on a scalar; declare the symbol with it, o"),
        (r"\lambda^{-1}", r"\lambda^{-1}"),
        (r"\lambda^{-2}", r"\left(\lambda^{2}\right)^{-1}"),
        (r"\lambda^{1/2}", r"\sqrt{\lambda}"),
        (r"\lambda^{3/2}", r"\left(\sqrt{\lambda}\right)^{3}"),
        (r"\lambda^{-1/2}", r"\left(\sqrt{\lambda}\right)^{-1}"),
        (r"\lambda^{-3/2}", r"\left(\left(\sqrt{\lambda}\right)^{3}\right)^{-1}"),
        (r"\lambda^{5/2}", r"\left(\sqrt{\lambda}\right)^{5}"),
        (r"\lambda^{7/2}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"\lambda^{2/2}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"\lambda^{\frac{1}{2}}", r"\sqrt{\lambda}"),
        (r"\lambda^{-\frac{1}{2}}", r"\left(\sqrt{\lambda}\right)^{-1}"),
        (r"\lambda^{\frac{1}{3}}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"\lambda^{(2)}", r"\ddot{\lambda}"),
        (r"\lambda^{(n)}", r"\lambda^{(n)}"),
        (r"\lambda^{[2]}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"\lambda^{\mu}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"\left(\frac{\lambda}{\mu}\right)^{1/2}", r"\frac{\sqrt{\lambda}}{\sqrt{\mu}}"),
        (r"\left(\frac{\lambda}{\mu}\right)^{-1/2}", r"\left(\frac{\sqrt{\lambda}}{\sqrt{\mu}}\right)^{-1}"),
        (r"\left(\frac{\lambda}{\mu}\right)^{3/2}", r"\left(\frac{\sqrt{\lambda}}{\sqrt{\mu}}\right)^{3}"),
        (r"x^2", r"x^{2}"),
        (r"x^3", r"misfit 3: an odd power (3) of a vector; x² means x·x"),
        (r"x^0", r"refused 3: a power, or a label? a symbol with ^0 can be"),
        (r"x^1", r"refused 3: a power, or a label? a symbol with ^1 can be"),
        (r"x^n", r"x^{n}"),
        (r"x^{-1}", r"misfit 3: the inverse of a vector"),
        (r"u^0", r"refused 3: a power, or a label? a symbol with ^0 can be"),
        (r"u^1", r"refused 3: a power, or a label? a symbol with ^1 can be"),
        (r"u^2", r"u^{2}"),
        (r"\dot{A}^{-1}", r"refused 9: the inverse of the derivative, or the deriva"),
        (r"\dot{A}^*", r"refused 9: the adjugate of the derivative, or the deriv"),
        (r"\dot{A}^T", r"\dot{A}^{T}"),
        (r"\dot{A}^2", r"\dot{A}^{2}"),
        (r"\dot{A}^{-T}", r"refused 9: the inverse of the derivative, or the deriva"),
        (r"\tilde{x}^{-1}", r"\tilde{x}^{-1}"),
        (r"\tilde{\dot{x}}^{-1}", r"refused 17: the inverse of the derivative, or the deriva"),
        (r"\dot{\tilde{x}}^{-1}", r"refused 17: the inverse of the derivative, or the deriva"),
        (r"\widetilde{\dot{x}}^*", r"refused 21: the adjugate of the derivative, or the deriv"),
        (r"{\dot{A}}^{-1}", r"refused 11: the inverse of the derivative, or the deriva"),
        (r"(\dot{A})^{-1}", r"\left(\dot{A}\right)^{-1}"),
        (r"\dot{A}^{\lambda}", r"refused 9: expected an integer, -1, T, -T, *, or an ord"),
        (r"H^{-1}", r"H^{-1}"),
        (r"H^*", r"refused 3: * on a matrix 4×4; declare the symbol with i"),
        (r"H^T", r"H^{T}"),
    ],
)
def test_superscripts(latex: str, expected: str) -> None:
    reads(latex, expected, PLAIN, "n")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"q^*", r"q^{*}"),
        (r"q^{-1}", r"q^{-1}"),
        (r"\dot{q}^*", r"\left(\dot{q}\right)^{*}"),
        (r"\dot{q}^{-1}", r"refused 9: the inverse of the derivative, or the deriva"),
        (r"q^2", r"q^{2}"),
        (r"x^3", r"refused 3: an odd power of a vector: is it a quaternion"),
        (r"x^2", r"x^{2}"),
        (r"q^0", r"q^{0}"),
        (r"q^1", r"q^{1}"),
        (r"q^T", r"\begin{bmatrix} \operatorname{Sc} q \\ \operatorname{Vec} q \end{bmatrix}^{T}"),
        (r"q^{1/2}", r"misfit 3: expected a scalar, got a quaternion"),
    ],
)
def test_superscripts_where_there_are_quaternions(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS, "n")


def test_a_transpose_is_no_power() -> None:
    reads("A^T", "refused 3: the transpose, or a power", PLAIN, "T")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac{d\lambda}{dt}", r"\dot{\lambda}"),
        (r"\frac{d}{dt} \lambda", r"\dot{\lambda}"),
        (r"\frac{d^2 x}{dt^2}", r"\ddot{x}"),
        (r"\frac{d^2}{dt^2} x", r"\ddot{x}"),
        (r"\frac{d^2 x}{dt^3}", r"misfit 1: d/dt of order 2 above and 3 below"),
        (r"\frac{d^2 x}{dt}", r"misfit 1: d/dt of order 2 above and 1 below"),
        (r"\frac{d x}{dt^2}", r"misfit 1: d/dt of order 1 above and 2 below"),
        (r"\frac{d^n x}{dt^n}", r"x^{(n)}"),
        (r"\frac{d}{dt}", r"\mathbf{D}"),
        (r"\frac{d^2}{dt^2}", r"\mathbf{D}^{2}"),
        (r"\frac{d \lambda x}{dt}", r"refused 1: how far does d/dt reach? bracket what it dif"),
        (r"\frac{\mathrm{d} \lambda x}{\mathrm{d} t}", r"\left(\lambda x\right)^{(1)}"),
        (r"\frac{d (\lambda x)}{dt}", r"\left(\lambda x\right)^{(1)}"),
        (r"\frac{d}{dt} \lambda x", r"refused 1: how far does d/dt reach? bracket what it dif"),
        (r"\frac{d}{dt} (\lambda x)", r"\left(\lambda x\right)^{(1)}"),
        (r"\frac{d}{dt} (\lambda) x", r"\dot{\lambda} x"),
        (r"\frac{d}{dt} \lambda^2", r"\left(\lambda^{2}\right)^{(1)}"),
        (r"\frac{d}{dt} (\lambda)^2", r"refused 14: a power of the derivative or of its argument"),
        (r"\frac{d}{dt} |x|^2", r"\left(\left\|x\right\|^{2}\right)^{(1)}"),
        (r"\frac{\partial \lambda}{\partial \mu}", r"\frac{\partial \lambda}{\partial \mu}"),
        (r"\frac{\partial}{\partial \mu} \lambda", r"\frac{\partial \lambda}{\partial \mu}"),
        (r"\frac{\partial}{\partial \mu}", r"refused 1: the partial derivative of what?"),
        (
            r"\frac{\partial^2 \lambda}{\partial \mu^2}",
            r"\frac{\partial \frac{\partial \lambda}{\partial \mu}}{\partial \mu}",
        ),
        (
            r"\frac{\partial^2 \lambda}{\partial \mu \partial \lambda}",
            r"\frac{\partial \frac{\partial \lambda}{\partial \lambda}}{\partial \mu}",
        ),
        (
            r"\frac{\partial^3 \lambda}{\partial \mu^2 \partial \lambda}",
            r"\frac{\partial \frac{\partial \frac{\partial \lambda}{\partial \lambda}}{\partial \mu}}{\partial \mu}",
        ),
        (
            r"\frac{\partial^2 \lambda}{\partial \mu^3}",
            r"misfit 1: a derivative of order 2 above and 3 below",
        ),
        (r"\frac{\partial \lambda}{\partial}", r"refused 24: a partial derivative by nothing"),
        (r"\frac{\partial \lambda}{d \mu}", r"refused 1: expected a partial derivative, \frac{\partia"),
        (r"\frac{d \lambda}{\partial \mu}", r"refused 1: expected a partial derivative, \frac{\partia"),
        (r"\frac{\partial \lambda}{\mu}", r"refused 1: expected a partial derivative, \frac{\partia"),
        (r"\frac{d\lambda}{d\mu}", r"\frac{\mathrm{d} \lambda}{\mathrm{d} \mu}"),
        (
            r"\frac{d^2\lambda}{d\mu^2}",
            r"\frac{\mathrm{d} \frac{\mathrm{d} \lambda}{\mathrm{d} \mu}}{\mathrm{d} \mu}",
        ),
        (r"\frac{d^2\lambda}{d\mu}", r"misfit 1: a derivative of order 2 above and 1 below"),
        (r"\frac{\mathrm{d}\lambda}{\mathrm{d}\mu}", r"\frac{\mathrm{d} \lambda}{\mathrm{d} \mu}"),
        (r"\frac{\partial A}{\partial x}", r"refused 1: rows or columns? [conventions] gradient ="),
        (r"\frac{\partial x}{\partial y}", r"refused 1: rows or columns? [conventions] gradient ="),
        (r"\frac{\partial \lambda}{\partial A}", r"refused 1: the partial derivative by a tensor is not re"),
        (r"\frac{0}{2}", r"0"),
        (r"\frac{2}{4}", r"\frac{1}{2}"),
        (r"\frac{-2}{4}", r"-\frac{1}{2}"),
        (r"\frac{2}{0}", r"refused 9: division by zero"),
        (r"\frac{\lambda}{0}", r"refused 15: division by zero"),
        (r"\frac{0}{\lambda}", r"\frac{0}{\lambda}"),
        (r"\frac{0}{0}", r"refused 9: division by zero"),
        (r"\frac{x}{\lambda}", r"\frac{x}{\lambda}"),
        (r"\frac{x}{y}", r"misfit 1: division by a vector; expected a scalar"),
        (r"\lambda / \mu", r"\frac{\lambda}{\mu}"),
        (r"\lambda / 0", r"refused 11: division by zero"),
        (r"2 / 4", r"\frac{1}{2}"),
    ],
)
def test_fractions(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\sin \lambda", r"\sin \lambda"),
        (r"\sin(\lambda)", r"\sin \lambda"),
        (r"\sin \lambda \mu", r"refused 1: how far does sin reach? bracket its argument"),
        (r"\sin 2 \lambda", r"\sin\left(2 \lambda\right)"),
        (r"\sin 2 \lambda \mu", r"refused 1: how far does sin reach? bracket its argument"),
        (r"\sin n \lambda", r"\sin\left(n \lambda\right)"),
        (r"\sin \lambda \cos \mu", r"\left(\sin \lambda\right) \cos \mu"),
        (r"\sin \lambda x", r"\left(\sin \lambda\right) x"),
        (r"\sin(\lambda) \mu", r"\left(\sin \lambda\right) \mu"),
        (r"\sin^2 \lambda", r"\left(\sin \lambda\right)^{2}"),
        (r"\sin^n \lambda", r"\left(\sin \lambda\right)^{n}"),
        (r"\sin^{-1} \lambda", r"refused 1: an inverse function or an inverse value? bra"),
        (r"\sin_2 \lambda", r"refused 1: only a power may stand on sin"),
        (r"\sin' \lambda", r"refused 1: only a power may stand on sin"),
        (r"\sin(\lambda)^2", r"refused 5: a power of the function or of its argument?"),
        (r"\sin", r"refused 1: sin of nothing"),
        (r"\sin + \lambda", r"refused 1: sin of nothing"),
        (r"\tan \lambda", r"\frac{\sin \lambda}{\cos \lambda}"),
        (r"\cot \lambda", r"\frac{\cos \lambda}{\sin \lambda}"),
        (r"\sec \lambda", r"\frac{1}{\cos \lambda}"),
        (r"\csc \lambda", r"\frac{1}{\sin \lambda}"),
        (r"\sinh \lambda", r"\frac{1}{2} \left(\exp \lambda - \exp\left(-\lambda\right)\right)"),
        (r"\cosh \lambda", r"\frac{1}{2} \left(\exp \lambda + \exp\left(-\lambda\right)\right)"),
        (
            r"\tanh \lambda",
            r"\frac{\frac{1}{2} \left(\exp \lambda - \exp\left(-\lambda\right)\right)}{\frac{1}{2} \left(\exp \lambda + \exp\left(-\lambda\right)\right)}",
        ),
        (r"\exp \lambda", r"\exp \lambda"),
        (r"\exp 2 \lambda", r"\exp\left(2 \lambda\right)"),
        (r"\exp \lambda \mu", r"refused 1: how far does exp reach? bracket its argument"),
        (r"\exp x", r"refused 1: the exponential of a vector: of its skew ten"),
        (r"\exp A", r"\exp A"),
        (r"\exp H", r"\exp H"),
        (r"\exp u", r"refused 1: the exponential of a matrix 6×1 is not read"),
        (r"e^{\lambda/2}", r"\exp\left(\frac{\lambda}{2}\right)"),
        (r"e^{-\lambda/2}", r"\exp\left(-\frac{\lambda}{2}\right)"),
        (r"e^{(\lambda/2)}", r"\exp\left(\frac{\lambda}{2}\right)"),
        (r"e^{\lambda + \mu/2}", r"\exp\left(\lambda + \frac{\mu}{2}\right)"),
        (r"\det A", r"\det A"),
        (r"\det A B", r"\det\left(A B\right)"),
        (r"\det A x", r"\left(\det A\right) x"),
        (r"\det A \lambda", r"\left(\det A\right) \lambda"),
        (r"\det \lambda A", r"refused 1: how far does det reach? bracket its argument"),
        (r"\det A^2", r"\det\left(A^{2}\right)"),
        (r"\det(A)^2", r"refused 5: a power of the function or of its argument?"),
        (r"\det^2 A", r"\left(\det A\right)^{2}"),
        (r"\det{A} B", r"\det\left(A B\right)"),
        (r"\operatorname{tr} A B x", r"\operatorname{trace}\left(A B\right) x"),
        (r"\operatorname{vect} A B", r"\operatorname{vect}\left(A B\right)"),
        (r"\operatorname{vect} A^T B", r"\operatorname{vect}\left(A^{T} B\right)"),
        (r"\operatorname{skew} x", r"\tilde{x}"),
        (r"\operatorname{skew} A", r"\operatorname{skew} A"),
        (r"\operatorname{sym} A + B", r"\operatorname{sym} A + B"),
        (r"\sqrt{\lambda}", r"\sqrt{\lambda}"),
        (r"\sqrt{\lambda \mu}", r"\sqrt{\lambda \mu}"),
        (r"\sqrt{\frac{\lambda}{\mu}}", r"\frac{\sqrt{\lambda}}{\sqrt{\mu}}"),
        (r"\sqrt{x}", r"misfit 1: expected a scalar, got a vector"),
        (r"\sqrt{A}", r"refused 1: the root of a tensor is not read"),
        (r"\sqrt{q}", r"refused 1: the root of a quaternion, which is no number"),
        (r"\sqrt{q q^*}", r"\sqrt{\operatorname{Sc}\left(q q^{*}\right)}"),
        (r"\sqrt{q^* q}", r"\sqrt{\operatorname{Sc}\left(q^{*} q\right)}"),
        (r"\sqrt{q p^*}", r"refused 1: the root of a quaternion, which is no number"),
        (r"\sqrt{q^* p}", r"refused 1: the root of a quaternion, which is no number"),
        (r"\sqrt[3]{\lambda}", r"refused 1: expected a square root, \sqrt{x}"),
        (r"\operatorname{quat}(\lambda, x)", r"\operatorname{quat}\left(\lambda, x\right)"),
        (r"\operatorname{quat}(x, \lambda)", r"misfit 1: expected a scalar, argument 1 is a vector"),
        (r"\operatorname{quat}(\lambda)", r"refused 1: expected a scalar and a vector, \operatornam"),
        (r"\operatorname{quat} \lambda", r"refused 1: expected a scalar and a vector, \operatornam"),
        (r"\operatorname{quat}^2(\lambda, x)", r"refused 1: expected a scalar and a vector, \operatornam"),
        (r"\operatorname{atan2}(\lambda, \mu)", r"\operatorname{atan2}\left(\lambda, \mu\right)"),
        (r"\operatorname{atan2}(\lambda)", r"refused 1: expected two scalars, \operatorname{atan2}(y"),
        (
            r"\operatorname{atan2}(\lambda, \mu, \lambda)",
            r"refused 1: expected two scalars, \operatorname{atan2}(y",
        ),
        (r"\operatorname{atan2}(x, \mu)", r"misfit 1: expected a scalar, argument 1 is a vector"),
        (r"\operatorname{Re} q", r"\operatorname{Sc} q"),
        (r"\operatorname{Re} \underline{q}", r"refused 1: Re of a dual quaternion: its real part, or i"),
        (r"\operatorname{Re} \lambda", r"\operatorname{Re} \lambda"),
    ],
)
def test_functions(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"x \times y", r"x \times y"),
        (r"x \times y \times x", r"refused 12: several products without brackets are ambigu"),
        (r"x \times x \times y", r"x \times \left(x \times y\right)"),
        (r"\lambda x \times x \times y", r"\lambda x \times \left(x \times y\right)"),
        (r"x \times \lambda x \times y", r"x \times \left(\lambda x \times y\right)"),
        (r"x \times x \times A", r"refused 12: several products without brackets are ambigu"),
        (r"x \cdot y", r"x \cdot y"),
        (r"x \cdot y \times x", r"refused 11: several products without brackets are ambigu"),
        (r"x \times y \cdot x", r"refused 12: several products without brackets are ambigu"),
        (r"x \otimes y", r"x \otimes y"),
        (r"x \otimes y \otimes x", r"refused 13: several products without brackets are ambigu"),
        (r"\lambda \cdot \mu", r"\lambda \mu"),
        (r"\lambda \cdot \mu \cdot x", r"\lambda \mu x"),
        (r"\lambda \cdot x \times y", r"\lambda x \times y"),
        (r"\lambda \times \mu", r"refused 9: × of two numbers: if it is their product, wr"),
        (r"\lambda \times x", r"misfit 9: expected a vector, argument 1 is a scalar"),
        (r"A \cdot B", r"A B"),
        (r"A \cdot B \cdot x", r"A B x"),
        (r"A \cdot x", r"A x"),
        (r"x \cdot A", r"refused 3: vectors beside each other, x · T: \cdot, or"),
        (r"x \times A", r"\tilde{x} A"),
        (r"A \times x", r"refused 3: vectors beside each other, x · T: \cdot, or"),
        (r"A \times B", r"refused 3: × of a tensor and a tensor: × is read betwee"),
        (r"A \otimes B", r"refused 3: ⊗ of a tensor and a tensor: of vectors it is"),
        (r"A \otimes x", r"refused 3: ⊗ of a tensor and a vector: of vectors it is"),
        (r"\lambda \otimes x", r"misfit 9: expected a vector, argument 1 is a scalar"),
        (r"A \circ B", r"A \circ B"),
        (r"x \circ y", r"refused 3: ∘ of a vector and a vector: is one a functio"),
        (r"\lambda \circ \mu", r"refused 9: ∘ of a scalar and a scalar: is one a functio"),
        (r"q \otimes p", r"q p"),
        (r"q \circ p", r"q p"),
        (r"q \cdot p", r"refused 3: the product of quaternions, or the scalar pr"),
        (r"q \times p", r"refused 3: × of quaternions: their product, or that of"),
        (r"q \cdot \lambda", r"q \lambda"),
        (r"q \otimes x", r"q \operatorname{quat}\left(0, x\right)"),
        (r"\lambda \circ q", r"refused 9: ∘ of a scalar and a quaternion: is one a fun"),
        (r"u \cdot u", r"u \cdot u"),
        (r"u \times u", r"refused 3: × of a matrix 6×1 and a matrix 6×1: × is rea"),
    ],
)
def test_signs(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\|x\|_2", r"\left\|x\right\|"),
        (r"\|A\|_F", r"\sqrt{\operatorname{trace}\left(A^{T} A\right)}"),
        (r"\|A\|_2", r"refused 1: a subscript on an expression; indices belong"),
        (r"\|x\|_F", r"refused 1: a subscript on an expression; indices belong"),
        (r"\|u\|_2", r"\left\|u\right\|"),
        (r"\|H\|_F", r"\sqrt{\operatorname{trace}\left(H^{T} H\right)}"),
        (r"\|\lambda\|_2", r"refused 1: a subscript on an expression; indices belong"),
        (r"\|x\|_3", r"refused 1: a subscript on an expression; indices belong"),
        (r"\|x\|_\infty", r"refused 1: a subscript on an expression; indices belong"),
        (r"|x|_2", r"\left\|x\right\|"),
        (r"(x)_2", r"refused 1: a subscript on an expression; indices belong"),
        (r"[x \, y]", r"refused 2: columns or a triple product? write \begin{bm"),
        (r"[x \, y \, x]", r"refused 2: columns or a triple product? write \begin{bm"),
        (r"[A \, x]", r"A x"),
        (r"[\lambda \, \mu]", r"\lambda \mu"),
        (r"[x \, \lambda]", r"x \lambda"),
    ],
)
def test_brackets_and_bars(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (
            r"\det \begin{bmatrix} x & y & x \\ \lambda & \mu & 2 \\ 1 & 2 & 3 \end{bmatrix}",
            r"\left(\mu \left[{3}\right] - 2 \left(2\right)\right) x + \left(2 \left(1\right) - \lambda \left[{3}\right]\right) y + \left(\lambda \left[{2}\right] - \mu \left[{1}\right]\right) x",
        ),
        (
            r"\det \begin{bmatrix} \lambda & \mu & 2 \\ x & y & x  \\ 1 & 2 & 3 \end{bmatrix}",
            r"\left(2 \left(2\right) - 3 \mu\right) x + \left(3 \lambda - 1 \left(2\right)\right) y + \left(1 \mu - 2 \lambda\right) x",
        ),
        (
            r"\det \begin{bmatrix} \lambda & \mu & 2 \\ 1 & 2 & 3  \\ x & y & x  \end{bmatrix}",
            r"\left(\mu \left[{3}\right] - 2 \left(2\right)\right) x + \left(2 \left(1\right) - \lambda \left[{3}\right]\right) y + \left(\lambda \left[{2}\right] - \mu \left[{1}\right]\right) x",
        ),
        (
            r"\det \begin{bmatrix} \lambda & \mu & x \\ 1 & 2 & y  \\ 3 & 4 & x  \end{bmatrix}",
            r"\left(1 \left(4\right) - 3 \left(2\right)\right) x + \left(3 \mu - \lambda \left[{4}\right]\right) y + \left(\lambda \left[{2}\right] - 1 \mu\right) x",
        ),
        (
            r"\det \begin{bmatrix} \lambda & x & \mu \\ 1 & y & 2  \\ 3 & x & 4  \end{bmatrix}",
            r"\left(2 \left(3\right) - 4 \left(1\right)\right) x + \left(4 \lambda - \mu \left[{3}\right]\right) y + \left(\mu \left[{1}\right] - 2 \lambda\right) x",
        ),
        (
            r"\det \begin{bmatrix} \lambda & x & \mu \\ 1 & y & 2  \\ 3 & 4 & 4  \end{bmatrix}",
            r"misfit 6: row 1 of the matrix holds blocks of size 1 a",
        ),
        (
            r"\det^2 \begin{bmatrix} \lambda & \mu & 2 \\ x & y & x  \\ 1 & 2 & 3 \end{bmatrix}",
            r"misfit 1: expected a tensor, got a matrix 5×3",
        ),
        (
            r"\det \begin{bmatrix} \lambda & \mu \\ 1 & 2  \end{bmatrix}",
            r"\det\left(\begin{bmatrix} \lambda & \mu \\ 1 & 2 \end{bmatrix}\right)",
        ),
    ],
)
def test_determinants_with_vectors(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS)


@pytest.mark.parametrize(
    "operator",
    [r"\frac{d}{dt}", r"\frac{\partial}{\partial \mu}", r"\frac{\mathrm{d}}{\mathrm{d}\mu}", r"\nabla"],
)
@pytest.mark.parametrize("bracket", [r"(\lambda)", r"[\lambda]", r"\{\lambda\}"])
def test_a_power_behind_the_bracket_that_is_differentiated(operator: str, bracket: str) -> None:
    reads(
        f"{operator} {bracket}^2",
        f"refused {len(operator) + 2}: a power of the derivative or of its argument?",
        PLAIN,
    )


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\sin(\lambda)^2", r"\left(\sin \lambda\right)^{2}"),
        (r"\cos \lambda \sin(\mu)^2", r"\left(\cos \lambda\right) \left(\sin \mu\right)^{2}"),
        (r"\sin(\lambda)^2 \cos \mu", r"\left(\sin \lambda\right)^{2} \cos \mu"),
        (r"\det(A)^2", r"refused 5: a power of the function or of its argument? bracket it"),
        (r"\exp(\lambda)^2", r"refused 5: a power of the function or of its argument? bracket it"),
        (r"\sin(\lambda)_2", r"refused 5: a power of the function or of its argument? bracket it"),
        (r"\sin^2(\lambda)^2", r"refused 7: a power of the function or of its argument? bracket it"),
        (r"\sin(\lambda)^{-1}", r"refused 5: an inverse function or an inverse value? bracket the value"),
        (r"\sin{\lambda}^2", r"\sin\left(\lambda^{2}\right)"),
        (r"\sin \lambda^2", r"\sin\left(\lambda^{2}\right)"),
        (r"\tan(\lambda)^2", r"\left(\frac{\sin \lambda}{\cos \lambda}\right)^{2}"),
    ],
)
def test_powers_where_the_paper_says_that_they_are_of_values(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS, "n", loose=frozenset({"values"}))


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"2 3", r"refused 3: two numbers side by side are printed as one; write \cdot"),
        (r"2 \cdot 3", r"2 \left(3\right)"),
        (r"2 \frac{1}{2}", r"refused 3: a mixed number or a product? write \cdot for the product"),
        (r"\frac{1}{2} 2", r"\frac{1}{2} \left(2\right)"),
        (r"2 (3)", r"2 \left(3\right)"),
        (r"n 3", r"n \left(3\right)"),
        (r"2 n", r"2n"),
        (r"2 n \lambda", r"\left(2n\right) \lambda"),
        (r"\lambda 2 n", r"\lambda \left[{2}\right] n"),
        (r"x y", r"refused 3: of vectors, or of quaternions? write \cdot, \times or (0, x)"),
        (r"x x^T", r"x x^{T}"),
        (r"x^T y", r"x^{T} y"),
        (r"x^T A y", r"x^{T} A y"),
        (r"x y^T x", r"x y^{T} x"),
        (r"A x y", r"refused 5: of vectors, or of quaternions? write \cdot, \times or (0, x)"),
        (r"\lambda \mu x", r"\lambda \mu x"),
        (r"(x \times y) x", r"refused 14: of vectors, or of quaternions? write \cdot, \times or (0, x)"),
        (r"\cdot x", r"refused 1: nothing before ·"),
        (r"x \cdot", r"refused 3: nothing after ·"),
        (r"\times", r"refused 1: a sign without its operands"),
        (r"x \cdot \cdot y", r"refused 9: nothing before ·"),
        (r"\lambda / \mu \cdot x", r"refused 15: what is divided by what? write \frac{…}{…}"),
        (r"\lambda \cdot \mu / \mu", r"\frac{\lambda \mu}{\mu}"),
        (r"\lambda \mu / \mu", r"\frac{\lambda \mu}{\mu}"),
        (r"x / \lambda", r"\frac{x}{\lambda}"),
        (r"x / y", r"misfit 3: division by a vector; expected a scalar"),
        (r"\lambda / \mu / \mu", r"refused 15: what is divided by what? write \frac{…}{…}"),
        (r"\lambda / \mu \lambda", r"refused 9: how far does / reach? write \frac{…}{…}"),
        (r"\lambda / 2 \mu", r"refused 9: how far does / reach? write \frac{…}{…}"),
        (r"\lambda / (2 \mu)", r"\frac{\lambda}{2 \mu}"),
        (r"\lambda / \sin \mu", r"\frac{\lambda}{\sin \mu}"),
        (r"\sin \lambda / \cos \mu", r"\frac{\sin \lambda}{\cos \mu}"),
        (r"\sin \lambda / \mu", r"refused 14: how far does / reach? write \frac{…}{…}"),
        (r"\sin \lambda / 2", r"refused 14: how far does / reach? write \frac{…}{…}"),
        (r"\det A / 2", r"refused 8: how far does / reach? write \frac{…}{…}"),
        (r"d \lambda / dt", r"\dot{\lambda}"),
        (r"d x / dt", r"\dot{x}"),
        (r"1/2 \lambda", r"refused 2: how far does / reach? write \frac{…}{…}"),
        (r"1 / \lambda", r"\frac{1}{\lambda}"),
        (r"\sum_{k=1}^{n} k", r"\sum_{k=1}^{n} k"),
        (r"\sum_{k=1}^{n} k x", r"\sum_{k=1}^{n} k x"),
        (r"\sum_{k=1}^{n} k x + y", r"\sum_{k=1}^{n} k x + y"),
        (r"\sum_{k=1}^{n}", r"refused 1: the sum has no body"),
        (r"\lambda \sum_{k=1}^{n} k x", r"\lambda \sum_{k=1}^{n} k x"),
        (r"x \cdot \sum_{k=1}^{n} y", r"x \cdot \sum_{k=1}^{n} y"),
        (r"x \times \sum_{k=1}^{n} k y \cdot x", r"misfit 3: expected a vector, argument 2 is a scalar"),
        (r"\sum_{k=1}^{n} \sum_{j=1}^{k} j x", r"\sum_{k=1}^{n} \sum_{j=1}^{k} j x"),
        (r"\frac{d}{dt} x \times y", r"refused 1: how far does d/dt reach? bracket its argument"),
        (r"\frac{d}{dt} (x) \times y", r"\dot{x} \times y"),
        (r"\frac{d}{dt} (x \times y)", r"\left(x \times y\right)^{(1)}"),
        (r"\frac{d x}{dt} \times y", r"\dot{x} \times y"),
        (r"x \times \frac{d}{dt} y", r"x \times \dot{y}"),
        (r"\det A \cdot B", r"refused 1: how far does det reach? bracket its argument"),
        (r"\det A \cdot x", r"\left(\det A\right) x"),
        (r"\det(A) \cdot B", r"\left(\det A\right) B"),
        (r"\operatorname{tr} A \cdot B", r"refused 1: how far does trace reach? bracket its argument"),
        (r"\operatorname{vect} A \cdot B", r"\operatorname{vect}\left(A B\right)"),
        (r"\operatorname{vect} A \cdot B \cdot A", r"\operatorname{vect}\left(A B A\right)"),
        (r"\operatorname{vect} A \cdot x", r"\operatorname{vect} A \cdot x"),
        (
            r"\operatorname{vect}(A) \cdot B",
            r"refused 24: vectors beside each other, x · T: \cdot, or dyads? [conventi",
        ),
        (r"\operatorname{sym} A \cdot B", r"refused 1: how far does sym reach? bracket its argument"),
        (r"\operatorname{sym} A \cdot x", r"\left(\operatorname{sym} A\right) x"),
        (
            r"\operatorname{Re} \underline{q} \cdot \lambda",
            r"refused 1: Re of a dual quaternion: its real part, or its scalar part?",
        ),
        (r"\mathbf{D} x", r"\mathbf{D} \left(x\right)"),
        (r"\mathbf{D} A", r"\mathbf{D} \left(A\right)"),
        (r"\mathbf{D} A x", r"misfit 12: how far does the operator reach? bracket what it acts on"),
        (r"\mathbf{D} (A x)", r"\mathbf{D} \left(A x\right)"),
        (r"\mathbf{D} \lambda", r"misfit 12: an operator with tensor coefficients acts on a vector or a t"),
        (r"\mathbf{D} x \times y", r"refused 1: how far does the operator reach? bracket its argument"),
        (r"\mathbf{D} (x) \times y", r"\mathbf{D} \left(x\right) \times y"),
        (r"\mathbf{D} \circ A", r"\mathbf{D} \circ A"),
        (r"\mathbf{D}^2 x", r"\mathbf{D}^{2} \left(x\right)"),
        (r"q p", r"q p"),
        (r"q x", r"q \operatorname{quat}\left(0, x\right)"),
        (r"x q", r"\operatorname{quat}\left(0, x\right) q"),
        (r"q A", r"misfit 3: juxtaposition of a quaternion and a tensor has no meaning"),
        (r"A q", r"misfit 3: juxtaposition of a tensor and a quaternion has no meaning"),
        (r"H q", r"H q"),
        (r"H q p", r"refused 5: a matrix before a product of quaternions: bracket one of the"),
        (r"H (q p)", r"H \left[q p\right]"),
        (r"q \lambda", r"q \lambda"),
        (r"\nabla \lambda", r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,"),
        (
            r"\nabla \lambda \cdot x",
            r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,",
        ),
        (
            r"\nabla \lambda \times x",
            r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,",
        ),
        (r"\nabla \cdot x", r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,"),
        (r"\nabla \times x", r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,"),
        (r"\nabla", r"refused 1: ∇ of what?"),
        (r"\nabla^2 \lambda", r"refused 1: ∇ by which place? one symbol is to be declared `coordinate`,"),
        (r"{}^A x", r"refused 6: unknown symbol {}^{A}x; known and close: x"),
        (r"{}_A x", r"refused 6: unknown symbol {}_{A}x; known and close: x"),
        (
            r"{}^{A} \begin{bmatrix} 1 \\ 2 \\ 3 \end{bmatrix}",
            r"refused 4: the components in that frame, or the vector that has them?",
        ),
        (r"{}^A (x)", r"refused 1: left scripts must stand before a symbol"),
        (r"{}^A", r"refused 1: left scripts must stand before a symbol"),
        (r"x(t)", r"x"),
        (r"A(t) x", r"A x"),
        (r"\lambda(t) x", r"\lambda x"),
        (r"\lambda(\mu)", r"refused 8: a function of what is in the bracket, or a product? [convent"),
        (r"\lambda(x)", r"refused 8: a function of what is in the bracket, or a product? [convent"),
        (r"x(\lambda)", r"refused 2: a function of what is in the bracket, or a product? [convent"),
        (r"A(\lambda)", r"refused 2: a function of what is in the bracket, or a product? [convent"),
        (r"A(x)", r"A x"),
        (r"A(x + y)", r"A \left[{x + y}\right]"),
        (r"\lambda(\mu + \lambda)", r"\lambda \left[\mu + \lambda\right]"),
        (r"\lambda (2)", r"refused 9: a function of what is in the bracket, or a product? [convent"),
        (r"x[2]", r"refused 2: a component or a member, or a factor? write a factor in fron"),
        (r"x[\lambda]", r"x \lambda"),
        (r"A[x]", r"A x"),
        (r"x(t_0)", r"refused 3: unknown symbol t_{0}"),
        (r"x(2 t)", r"refused 2: a function of what is in the bracket, or a product? [convent"),
        (r"\lambda(x, y)", r"refused 8: a function of what is in the bracket, or a product? [convent"),
        (r"x(\lambda, \mu)", r"refused 2: a function of what is in the bracket, or a product? [convent"),
        (r"(x, y, x)", r"\left\langle x, y, x\right\rangle"),
        (r"(\lambda, x)", r"\operatorname{quat}\left(\lambda, x\right)"),
        (r"(\lambda, \mu)", r"refused 1: 2 expressions between brackets; a triple product has three,"),
        (r"(x, y)", r"refused 1: 2 expressions between brackets; a triple product has three,"),
        (r"(\lambda, \mu, 1)", r"\begin{bmatrix} \lambda \\ \mu \\ 1 \end{bmatrix}"),
        (r"(\lambda, \mu, 1)^T", r"\begin{bmatrix} \lambda \\ \mu \\ 1 \end{bmatrix}"),
        (r"[\lambda, \mu, 1]", r"refused 1: 3 expressions between brackets; a triple product has three,"),
        (r"\langle x, y \rangle", r"refused 1: 2 expressions between brackets; a triple product has three,"),
        (r"\langle x, y, x \rangle", r"\left\langle x, y, x\right\rangle"),
        (r"|x|", r"\left\|x\right\|"),
        (r"|\lambda|", r"\left\|\lambda\right\|"),
        (r"|A|", r"\det A"),
        (r"\|A\|", r"refused 1: which norm of a tensor? \|T\|_F is read"),
        (r"|x| y", r"\left\|x\right\| y"),
        (r"|x|^2", r"\left\|x\right\|^{2}"),
        (r"||x||", r"\left\|x\right\|"),
    ],
)
def test_rows_of_factors(latex: str, expected: str) -> None:
    reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize("by", ["s_1", "s_{1}", "s'", "s'_1", r"\mathbf{s}", r"\mathbf{s}_1"])
@pytest.mark.parametrize("d", [r"\partial", r"\mathrm{d}", "d"])
def test_what_is_differentiated_by_keeps_its_scripts_where_an_order_stands_on_it(d: str, by: str) -> None:
    kinds = dict.fromkeys([by, "f", "s"], "scalar")
    once, printed = rf"\frac{{{d} f}}{{{d} {by}}}", by.replace("_1", "_{1}")
    sign = r"\partial" if d == r"\partial" else r"\mathrm{d}"
    first = rf"\frac{{{sign} f}}{{{sign} {printed}}}"
    reads(once, first, kinds)
    reads(rf"\frac{{{d}^2 f}}{{{d} {by}^2}}", rf"\frac{{{sign} {first}}}{{{sign} {printed}}}", kinds)

"""What stands above a term, in fractions and behind functions: what it is read as, or where and why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import PLAIN, WITH_QUATERNIONS, term_reads
from workbench.language.naming.reading_conventions import Relaxation


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
    term_reads(latex, expected, PLAIN, "n")


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
    term_reads(latex, expected, WITH_QUATERNIONS, "n")


def test_a_transpose_is_no_power() -> None:
    term_reads("A^T", "refused 3: the transpose, or a power", PLAIN, "T")


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
        (r"\frac{d}{dt} \lambda x", r"\left(\lambda x\right)^{(1)}"),
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
        (r"\frac{\partial \lambda}{\partial A}", r"refused 1: rows or columns?"),
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
    term_reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\sin \lambda", r"\sin \lambda"),
        (r"\sin(\lambda)", r"\sin \lambda"),
        (r"\sin \lambda \mu", r"refused 1: how far does sin reach? bracket its argument"),
        (r"\sin \lambda \dot{\mu}", r"\left(\sin \lambda\right) \dot{\mu}"),
        (r"\sin^2 \lambda \dot{\mu}^2 \mu", r"\left(\sin \lambda\right)^{2} \dot{\mu}^{2} \mu"),
        (r"\sin 2 \lambda \ddot{\lambda}", r"\sin\left(2 \lambda\right) \ddot{\lambda}"),
        (r"\sin \dot{\lambda} \dot{\mu}", r"refused 1: how far does sin reach? bracket its argument"),
        (r"\exp \lambda \dot{\mu}", r"refused 1: how far does exp reach? bracket its argument"),
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
    term_reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize(
    "operator",
    [r"\frac{d}{dt}", r"\frac{\partial}{\partial \mu}", r"\frac{\mathrm{d}}{\mathrm{d}\mu}", r"\nabla"],
)
@pytest.mark.parametrize("bracket", [r"(\lambda)", r"[\lambda]", r"\{\lambda\}"])
def test_a_power_behind_the_bracket_that_is_differentiated(operator: str, bracket: str) -> None:
    term_reads(
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
    term_reads(latex, expected, WITH_QUATERNIONS, "n", loose=frozenset({Relaxation.POWERS_OF_VALUES}))


@pytest.mark.parametrize("by", ["s_1", "s_{1}", "s'", "s'_1", r"\mathbf{s}", r"\mathbf{s}_1"])
@pytest.mark.parametrize("d", [r"\partial", r"\mathrm{d}", "d"])
def test_a_variable_of_differentiation_keeps_its_scripts(d: str, by: str) -> None:
    kinds = dict.fromkeys([by, "f", "s"], "scalar")
    once, printed = rf"\frac{{{d} f}}{{{d} {by}}}", by.replace("_1", "_{1}")
    sign = r"\partial" if d == r"\partial" else r"\mathrm{d}"
    first = rf"\frac{{{sign} f}}{{{sign} {printed}}}"
    term_reads(once, first, kinds)
    term_reads(rf"\frac{{{d}^2 f}}{{{d} {by}^2}}", rf"\frac{{{sign} {first}}}{{{sign} {printed}}}", kinds)


@pytest.mark.parametrize(
    "name", [r"\atan2", r"\arctan2", "atan2", r"\operatorname{atan2}", r"\mathrm{atan2}"]
)
@pytest.mark.parametrize("inside", [r"(\lambda, \mu)", r"\left(\lambda, \mu\right)", r" (\lambda, \mu)"])
def test_spellings_of_the_angle_of_two(name: str, inside: str) -> None:
    term_reads(name + inside, r"\operatorname{atan2}\left(\lambda, \mu\right)", PLAIN)


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\frac{d}{d}", r"refused 7: unknown symbol d"),
        (r"\frac{d \lambda}{d}", r"refused 18: unknown symbol d"),
        (
            r"\frac{d \lambda}{d \mu dt}",
            r"refused 1: a derivative by anything but a symbol or its time derivative",
        ),
        (r"\frac{\lambda}{d t}", r"refused 16: unknown symbol d"),
        (r"\frac{d \lambda}{2 dt}", r"refused 7: unknown symbol d"),
        (r"\frac{d \lambda}{t}", r"refused 7: unknown symbol d"),
        (r"\frac{{}^A d x}{dt}", r"refused 10: a derivative in the frame A? frames declared in [frames]: no"),
        (
            r"\frac{{}^A d x}{d \mu}",
            r"refused 1: a derivative by anything but the time t, or a quotient of pr",
        ),
        (
            r"\frac{{}^A \partial x}{\partial \mu}",
            r"refused 1: expected a partial derivative, \frac{\partial f}{\partial x}",
        ),
        (r"\frac{d x}{dt_A}", r"refused 13: unknown symbol t_{A}"),
        (r"\frac{x}{dt}", r"refused 10: unknown symbol d"),
        (r"\frac{d}{\mu}", r"refused 7: unknown symbol d"),
        (r"\frac{\partial}{\partial \mu \partial}", r"refused 16: a partial derivative by nothing"),
        (r"\frac{\partial^n \lambda}{\partial \mu^n}", r"refused 16: a partial derivative of the order n"),
        (r"\frac{\partial \lambda}{\partial \mu^1}", r"\frac{\partial \lambda}{\partial \mu}"),
        (
            r"\frac{\partial \lambda}{\partial \lambda \mu}",
            r"refused 1: a derivative by anything but a symbol or its time derivative",
        ),
    ],
)
def test_fractions_similar_to_derivatives_read_as_expected(latex: str, expected: str) -> None:
    term_reads(latex, expected, WITH_QUATERNIONS, "n")

"""Rows of factors, signs between them, brackets, and determinants: what they are read as, or where and why not."""

from __future__ import annotations

import pytest

from tests.language.as_read import WITH_QUATERNIONS, term_reads


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
        (r"x \times y \cdot x", r"\left(x \times y\right) \cdot x"),
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
    term_reads(latex, expected, WITH_QUATERNIONS)


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
    term_reads(latex, expected, WITH_QUATERNIONS)


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
    term_reads(latex, expected, WITH_QUATERNIONS)


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
        (r"\lambda (2)", r"refused 9: a function of what is in the bracket, or a product? a symbol"),
        (r"x[2]", r"refused 2: a component or a member, or a factor? write a factor in fron"),
        (r"x[\lambda]", r"x \lambda"),
        (r"A[x]", r"A x"),
        (r"x(t_0)", r"refused 3: unknown symbol t_{0}"),
        (r"x(2 t)", r"refused 2: a function of what is in the bracket, or a product? a symbol"),
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
    term_reads(latex, expected, WITH_QUATERNIONS, "n")


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"(x^T A, y^T)^T", r"\begin{bmatrix} \left(x^{T} A\right)^{T} \\ y \end{bmatrix}"),
        (r"(x^T, y^T)^T", r"\begin{bmatrix} x \\ y \end{bmatrix}"),
        (r"(x^T, y^T, \lambda)^T", r"\begin{bmatrix} x \\ y \\ \lambda \end{bmatrix}"),
        (r"(\lambda, \mu)^T", r"\begin{bmatrix} \lambda \\ \mu \end{bmatrix}"),
        (r"(x, y)^T", r"refused 1: columns beside each other transposed, or one above the other"),
        (r"(x^T A, \lambda)^T", r"\begin{bmatrix} \left(x^{T} A\right)^{T} \\ \lambda \end{bmatrix}"),
        (r"[x^T A, \lambda]^T", r"\begin{bmatrix} \left(x^{T} A\right)^{T} \\ \lambda \end{bmatrix}"),
        (r"(x^T A, A)^T", r"refused 1: columns beside each other transposed, or one above the other"),
        (r"^+ x", r"refused 1: unexpected ^"),
        (r"_\times x", r"refused 1: unexpected _"),
        (r"^* x", r"refused 1: unexpected ^"),
        (r"^{+} x", r"refused 1: unexpected ^"),
        (r"x^+", r"refused 3: expected an integer, -1, T, -T, *, or an order in round brac"),
        (r"x^{+}", r"refused 3: expected an integer, -1, T, -T, *, or an order in round brac"),
    ],
)
def test_rows_transposed_and_scripts_of_one_sign(latex: str, expected: str) -> None:
    term_reads(latex, expected, WITH_QUATERNIONS, "n")


PLACE = WITH_QUATERNIONS | {"r": {"kind": "vector", "coordinate": True}}


@pytest.mark.parametrize(
    ("latex", "expected"),
    [
        (r"\nabla \otimes x", r"refused 1: ∇ of what?"),
        (r"\nabla \circ x", r"refused 1: ∇ of what?"),
        (r"\nabla \cdot x", r"\operatorname{trace}\left(\frac{\partial x}{\partial r}\right)"),
        (r"\nabla \times x", r"2 \operatorname{vect}\left(\frac{\partial x}{\partial r}\right)"),
        (r"\nabla \cdot \times x", r"refused 1: ∇ of what?"),
        (r"\nabla \times \cdot x", r"refused 1: ∇ of what?"),
        (r"\nabla \cdot \cdot x", r"refused 1: ∇ of what?"),
        (r"x \cdot \nabla \lambda", r"x \cdot \left(\frac{\partial \lambda}{\partial r}\right)^{T}"),
        (r"\nabla \lambda", r"\left(\frac{\partial \lambda}{\partial r}\right)^{T}"),
        (
            r"\nabla^2 \lambda",
            r"\operatorname{trace}\left(\frac{\partial \left(\frac{\partial \lambda}{\partial r}\right)^{T}}{\partial r}\right)",
        ),
        (
            r"\nabla \cdot (\lambda x)",
            r"\operatorname{trace}\left(\frac{\partial \left(\lambda x\right)}{\partial r}\right)",
        ),
        (r"\nabla \times x \times y", r"refused 1: how far does ∇ reach? bracket its argument"),
        (r"\nabla \lambda \cdot x", r"\left(\frac{\partial \lambda}{\partial r}\right)^{T} \cdot x"),
    ],
)
def test_signs_behind_a_nabla(latex: str, expected: str) -> None:
    term_reads(latex, expected, PLACE)

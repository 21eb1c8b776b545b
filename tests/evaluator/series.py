"""Taylor series over the dual numbers, to 30 digits, and matrices of them: the arithmetic of `values.py`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass

from mpmath import mp, mpf

DIGITS = 30
#: What counts as zero, beside the size of the sides.
TOLERANCE = mpf(10) ** -15
#: Taylor coefficients of a free symbol: more than any formula here differentiates.
LENGTH = 12


class Undefined(ArithmeticError):
    """A denominator, or a norm that is divided by, vanishes at the point."""


class NotRead(ValueError):
    """The evaluator knows no value for this; it says nothing of the formula."""


@dataclass(frozen=True)
class Series:
    """Σ (re_k + ε du_k) tᵏ, as many terms as are known; `du` is () where nothing is dual."""

    re: tuple[mpf, ...]
    du: tuple[mpf, ...] = ()

    def __add__(self, other: Series) -> Series:
        return Series(_sums(self.re, other.re), _dual_sums(self.du, other.du))

    def __neg__(self) -> Series:
        return Series(tuple(-a for a in self.re), tuple(-a for a in self.du))

    def __sub__(self, other: Series) -> Series:
        return self + -other

    def __mul__(self, other: Series) -> Series:
        cross = _dual_sums(times(self.re, other.du), times(self.du, other.re))
        return Series(times(self.re, other.re), cross)

    def inverse(self) -> Series:
        if abs(self.re[0]) < TOLERANCE:
            raise Undefined("division by zero")
        found: list[mpf] = []
        for k in range(len(self.re)):
            rest = sum((self.re[j] * found[k - j] for j in range(1, k + 1)), mpf(0))
            found.append(((1 if k == 0 else 0) - rest) / self.re[0])
        re = tuple(found)
        return Series(re, tuple(-x for x in times(self.du, times(re, re))))

    def root(self) -> Series:
        if self.re[0] < TOLERANCE:
            raise Undefined("the length of zero")
        found = [mp.sqrt(self.re[0])]
        for k in range(1, len(self.re)):
            rest = sum((found[j] * found[k - j] for j in range(1, k)), mpf(0))
            found.append((self.re[k] - rest) / (2 * found[0]))
        re = tuple(found)
        return Series(re, tuple(x / 2 for x in times(self.du, Series(re).inverse().re)))

    def circle(self) -> tuple[Series, Series]:
        """cos and sin: ċ = −s α̇, ṡ = c α̇; and for the dual part the same by ε."""
        c, s = [mp.cos(self.re[0])], [mp.sin(self.re[0])]
        for k in range(1, len(self.re)):
            rates = [(k - j) * self.re[k - j] for j in range(k)]
            c.append(-sum((s[j] * rates[j] for j in range(k)), mpf(0)) / k)
            s.append(sum((c[j] * rates[j] for j in range(k)), mpf(0)) / k)
        cosine, sine = tuple(c), tuple(s)
        falling = tuple(-x for x in times(sine, self.du))
        return Series(cosine, falling), Series(sine, times(cosine, self.du))

    def rate(self, order: int = 1) -> Series:
        """The derivative of the order; each costs one known term."""
        re, du = self.re, self.du
        for _ in range(order):
            re, du = (tuple(k * part[k] for k in range(1, len(part))) for part in (re, du))
        if not re:
            raise NotRead("a derivative of too high an order")
        return Series(re, du)


def times(a: tuple[mpf, ...], b: tuple[mpf, ...]) -> tuple[mpf, ...]:
    return tuple(mp.fdot(zip(a[: k + 1], b[k::-1], strict=True)) for k in range(min(len(a), len(b))))


def _sums(a: tuple[mpf, ...], b: tuple[mpf, ...]) -> tuple[mpf, ...]:
    return tuple(x + y for x, y in zip(a, b, strict=False))


def _dual_sums(a: tuple[mpf, ...], b: tuple[mpf, ...]) -> tuple[mpf, ...]:
    return _sums(a, b) if a and b else a or b


#: Rows of entries: a scalar is 1 by 1, a vector 3 by 1.
Matrix = list[list[Series]]
#: What a polynomial in D = d/dt does to what stands behind it.
Operator = Callable[[Matrix], Matrix]


def constant(value: object, dual: object = 0) -> Series:
    rest = (mpf(0),) * (LENGTH - 1)
    return Series((mpf(value), *rest), (mpf(dual), *rest) if dual else ())


def product(a: Matrix, b: Matrix) -> Matrix:
    if len(a) == len(a[0]) == 1:
        return [[a[0][0] * x for x in row] for row in b]
    if len(b) == len(b[0]) == 1:
        return [[x * b[0][0] for x in row] for row in a]
    if len(a[0]) != len(b):
        raise NotRead(f"a product of {len(a[0])} columns by {len(b)} rows")
    return [[added_up(x * y[j] for x, y in zip(row, b, strict=True)) for j in range(len(b[0]))] for row in a]


#: eᵢ eⱼ = sign · e_k with k = i xor j, of the units 1, i, j, k: i j = k, j k = i, k i = j.
_SIGNS = ((1, 1, 1, 1), (1, -1, 1, -1), (1, -1, -1, 1), (1, 1, -1, -1))


def hamilton(p: Matrix, q: Matrix) -> Matrix:
    """The product of two quaternions by the table of their units."""
    places = [[(i, i ^ k) for i in range(4)] for k in range(4)]
    signed = [[(p[i][0] * q[j][0], _SIGNS[i][j]) for i, j in row] for row in places]
    return [[added_up(x if sign > 0 else -x for x, sign in row)] for row in signed]


def combined(a: Matrix, column: Matrix) -> Matrix:
    """Sums of the blocks of a column, one block to each column of a."""
    rows = len(column) // len(a[0])
    blocks = [column[k * rows : (k + 1) * rows] for k in range(len(a[0]))]
    return [
        [
            added_up(x * block[i][j] for x, block in zip(row, blocks, strict=True))
            for j in range(len(column[0]))
        ]
        for row in a
        for i in range(rows)
    ]


def added_up(addends: Iterable[Series]) -> Series:
    first, *rest = addends
    for addend in rest:
        first = first + addend
    return first


def added(a: Matrix, b: Matrix) -> Matrix:
    return [[x + y for x, y in zip(*rows, strict=True)] for rows in zip(a, b, strict=True)]


def each(a: Matrix, of: Callable[[Series], Series]) -> Matrix:
    return [[of(x) for x in row] for row in a]


def turned(a: Matrix) -> Matrix:
    return [list(column) for column in zip(*a, strict=True)]


def scaled(a: Matrix, factor: object) -> Matrix:
    return product([[constant(factor)]], a)


def unit(size: int) -> Matrix:
    return [[constant(int(i == j)) for j in range(size)] for i in range(size)]


def nothing(rows: int, columns: int) -> Matrix:
    return [[constant(0)] * columns for _ in range(rows)]


def skew(x: Matrix) -> Matrix:
    (a,), (b,), (c,) = x
    zero = a - a
    return [[zero, -c, b], [c, zero, -a], [-b, a, zero]]


def axial(t: Matrix) -> Matrix:
    return scaled([[t[2][1] - t[1][2]], [t[0][2] - t[2][0]], [t[1][0] - t[0][1]]], mpf(1) / 2)


def dot(a: Matrix, b: Matrix) -> Matrix:
    return product(turned(a), b)


def determinant(a: Matrix) -> Series:
    if len(a) == 1:
        return a[0][0]
    minors = ([[row[j] for j in range(len(a)) if j != k] for row in a[1:]] for k in range(len(a)))
    signed = (a[0][k] * determinant(minor) for k, minor in enumerate(minors))
    return added_up(-x if k % 2 else x for k, x in enumerate(signed))


def adjugate(a: Matrix) -> Matrix:
    size = range(len(a))
    if len(a) == 1:
        return [[constant(1)]]
    cofactors = [
        [
            (-x if (i + j) % 2 else x)
            for j in size
            for x in [determinant([[a[p][q] for q in size if q != j] for p in size if p != i])]
        ]
        for i in size
    ]
    return turned(cofactors)


def inverse(a: Matrix) -> Matrix:
    if len(a) > 3:
        return _solved(a, unit(len(a)))
    return product([[determinant(a).inverse()]], adjugate(a))


def _solved(a: Matrix, on: Matrix) -> Matrix:
    """The x with a x = on, by Gauss and Jordan."""
    rows = [[*left, *right] for left, right in zip(a, on, strict=True)]
    for k in range(len(rows)):
        pivot = max(range(k, len(rows)), key=lambda i: abs(rows[i][k].re[0]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        scale = rows[k][k].inverse()
        rows[k] = [x * scale for x in rows[k]]
        for i, row in enumerate(rows):
            if i != k:
                rows[i] = [x - row[k] * y for x, y in zip(row, rows[k], strict=True)]
    return [row[len(rows) :] for row in rows]


def acted(parts: list[Matrix], like: Matrix) -> Matrix:
    if not parts:
        return each(like, lambda entry: entry - entry)
    total = parts[0]
    for part in parts[1:]:
        total = added(total, part)
    return total


def exponential(x: Matrix, on: Matrix | None = None) -> Matrix:
    """By halving the argument until its own series is short, and squaring; `on`: what it is applied to."""
    halvings = 12
    small = scaled(x, mpf(1) / 2**halvings)
    total = term = unit(len(x))
    for k in range(1, 14):
        term = scaled(product(term, small), mpf(1) / k)
        total = added(total, term)
    for _ in range(halvings):
        total = product(total, total)
    return total if on is None else product(total, on)

"""Exponentials of square matrices that no formula of Rodrigues gives, replaced by polynomials of the matrix.

By Cayley and Hamilton, exp(s M) = a₀ I + a₁ M + … with n scalars a. What holds for any such a, with the rates
that follow from d/dt exp(s M) = ṡ M exp(s M) for a constant M, holds for the exponential; the rest is decided
at real points. Before, the laws of the exponential are applied:

    exp(s M) exp(t M) = exp((s + t) M)      (exp A)⁻¹ = exp(−A)         exp(Aᵀ) = (exp A)ᵀ
    exp(P A P⁻¹) = P exp(A) P⁻¹             det exp A = e^{tr A}        exp(λ I) = e^λ I
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import reduce
from math import lcm

from workbench.core.construct import (
    apply,
    block,
    derivative,
    identity,
    number,
    power,
    relation,
    symbol,
    with_children,
    zero,
)
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.shapes import multiple
from workbench.core.terms import Apply, Block, Identity, Relation, Statement, Symbol, Term, Zero, heads_in
from workbench.core.types import SCALAR, Declaration
from workbench.engines.inventory import Lookup, NotExact, reached
from workbench.engines.inventory.angle_combinations import sum_of_products
from workbench.engines.inventory.elementary_functions import Value, derivative_order
from workbench.engines.inventory.rodrigues import angle_and_axis, rotation_vector, twist_parts
from workbench.language.definitions import expand
from workbench.language.printing.printer import to_latex

#: Largest number of rows, and largest power of an exponential.
_ROWS, _LARGEST = 4, 6


@dataclass(frozen=True)
class MatrixExponentials:
    """The equation without exponentials of matrices.

    relation: with polynomials for them, under what is supposed.   free: with a free matrix for each.
    values: the exponentials that the free matrices stand for."""

    relation: Relation
    supposed: tuple[Statement, ...]
    free: Relation
    values: dict[Symbol, Value]


def holds_matrix_exponentials(said: Relation, definitions: Lookup) -> bool:
    parts = list(reached(definitions, said.left, said.right))
    if not any(isinstance(part, Apply) and part.head == "exp" and part.type != SCALAR for part in parts):
        return False
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    return any(_is_open(part, definitions) for side in sides for part in side.walk())


def _is_open(term: Term, definitions: Lookup) -> bool:
    """True for the exponential of a matrix of which no formula of Rodrigues gives the value."""
    if not (isinstance(term, Apply) and term.head == "exp") or not term.type.is_square or term.type.dual:
        return False
    (turning,) = term.arguments
    if term.type.kind == "matrix":
        parts = twist_parts(turning, definitions)
        if parts is None:
            return True
        turning = parts[0]
    elif term.type.kind != "tensor":
        return False
    return angle_and_axis(turning, definitions) is None and rotation_vector(turning, definitions) is None


def without_matrix_exponentials(said: Relation, definitions: Lookup) -> MatrixExponentials:
    """Returns the equation without exponentials of matrices. Raises NotExact for large ones, and under
    partial derivatives."""
    sides = [expand(side, definitions) for side in (said.left, said.right)]
    if any(not (GRADIENTS | PARTIALS).isdisjoint(heads_in(side)) for side in sides):
        raise NotExact("a partial derivative of the exponential of a matrix")
    highest = max(map(derivative_order, sides))
    found = []
    for as_matrices in (False, True):
        sizes: dict[object, int] = {}
        _Pass(definitions, sizes, as_matrices).all(sides)
        made = _Pass(definitions, sizes, as_matrices)
        found.append((relation("=", *made.all(sides)), made))
    (judged, made), (free, other) = found
    return MatrixExponentials(judged, tuple(made.rates(highest)), free, other.values)


@dataclass(frozen=True)
class _Exponent:
    """s M.   scalar: s as a sum of products."""

    core: Term
    scalar: Term


class _Pass:
    """One pass. sizes: the common denominator of the coefficients of each product with a matrix.
    as_matrices: True for free matrices instead of polynomials."""

    def __init__(self, definitions: Lookup, sizes: dict[object, int], as_matrices: bool) -> None:
        self.definitions, self.sizes, self.as_matrices = definitions, sizes, as_matrices
        self.coefficients: dict[object, tuple[_Exponent, list[Symbol]]] = {}
        self.values: dict[Symbol, Value] = {}
        self.known: dict[object, Symbol] = {}

    def all(self, sides: Sequence[Term]) -> list[Term]:
        return [self.term(side) for side in sides]

    def term(self, term: Term) -> Term:
        match term:
            case Apply(head="det", arguments=(Apply(head="exp", arguments=(exponent,)),)):
                return apply("exp", self.term(apply("trace", exponent)))
            case Apply(head="inverse", arguments=(Apply(head="exp", arguments=(exponent,)) as inner,)):
                if _is_open(inner, self.definitions):
                    return self.exponential(apply("neg", exponent))
            case Apply(head="mul", arguments=factors) if not any(f.type.kind == "scalar" for f in factors):
                return self._product(term)
            case Apply(head="exp", arguments=(exponent,)) if _is_open(term, self.definitions):
                return self.exponential(exponent)
        return with_children(term, self.term)

    def _product(self, term: Term) -> Term:
        """Returns the product, with the exponents of neighbours that commute added."""
        done: list[Term] = []
        for factor in _factors_of(term):
            before = self._exponent_of(done[-1]) if done else None
            own = self._exponent_of(factor)
            if before is not None and own is not None and before.core == own.core:
                total = apply("mul", apply("add", before.scalar, own.scalar), own.core)
                done[-1] = apply("exp", total)
            else:
                done.append(factor)
        if len(done) == 1:
            return self.term(done[0])
        parts = [self.term(each) for each in done]
        return reduce(lambda one, other: apply("mul", one, other), parts)

    def _exponent_of(self, factor: Term) -> _Exponent | None:
        match factor:
            case Apply(head="exp", arguments=(exponent,)) if _is_open(factor, self.definitions):
                return self.split(exponent)
            case Apply(head="inverse", arguments=(Apply(head="exp", arguments=(exponent,)) as inner,)):
                return self.split(apply("neg", exponent)) if _is_open(inner, self.definitions) else None
        return None

    def split(self, exponent: Term) -> _Exponent:
        """Returns the scalar factor of the exponent and the rest."""
        match exponent:
            case Apply(head="neg", arguments=(inner,)):
                own = self.split(inner)
                return _Exponent(own.core, apply("neg", own.scalar))
            case Apply(head="div", arguments=(inner, scalar)):
                own = self.split(inner)
                return _Exponent(own.core, apply("div", own.scalar, scalar))
            case Apply(head="mul", arguments=(left, right)) if "scalar" in (left.type.kind, right.type.kind):
                scalar, inner = (left, right) if left.type.kind == "scalar" else (right, left)
                own = self.split(inner)
                return _Exponent(own.core, apply("mul", scalar, own.scalar))
            case Apply(head="add", arguments=addends):
                parts = [self.split(each) for each in addends]
                if len({each.core for each in parts}) == 1:
                    return _Exponent(parts[0].core, apply("add", *(each.scalar for each in parts)))
                return _Exponent(apply("add", *sorted(addends, key=to_latex)), number(1))
        return _Exponent(exponent, number(1))

    def exponential(self, exponent: Term) -> Term:
        own = self.split(exponent)
        match own.core:
            case Zero():
                return identity(exponent.type)
            case Identity():
                return apply("mul", apply("exp", self.term(own.scalar)), identity(exponent.type))
            case Apply(head="transpose", arguments=(inner,)):
                return apply("transpose", self.exponential(apply("mul", own.scalar, inner)))
            case Block() if (entries := _diagonal(own.core)) is not None:
                return self._diagonal(own.scalar, entries)
            case Block() if (angle := _planar_angle(own.core.entries)) is not None:
                return block(_turn(self._scaled(own.scalar, angle)))
            case Block(entries=(first, second, lowest)) if all(multiple(e) == "zero" for e in lowest):
                angle = _planar_angle((first[:2], second[:2]))
                if angle is not None:
                    moving = [self._scaled(own.scalar, row[2]) for row in (first, second)]
                    return _planar_motion(self._scaled(own.scalar, angle), moving)
        if (turned := _conjugated(own.core)) is not None:
            turning, inner, back = turned
            middle = self.exponential(apply("mul", own.scalar, inner))
            return apply("mul", apply("mul", self.term(turning), middle), self.term(back))
        result: Term = identity(exponent.type)
        for factors, coefficient in sum_of_products(own.scalar, self.definitions).items():
            key = (own.core, factors)
            size = self.sizes[key] = lcm(self.sizes.get(key, 1), coefficient.denominator)
            count = coefficient * size
            if abs(count) > _LARGEST:
                raise NotExact(f"the power {count} of an exponential")
            if count:
                one = self._one(_Exponent(own.core, _scalar(factors, size, count < 0)))
                raised = power(one, abs(int(count))) if abs(count) > 1 else one
                result = raised if isinstance(result, Identity) else apply("mul", result, raised)
        return result

    def _diagonal(self, scalar: Term, entries: Sequence[Term]) -> Term:
        values = [
            apply("exp", self._scaled(scalar, each))
            if each.type == SCALAR
            else self.term(apply("exp", apply("mul", scalar, each)))
            for each in entries
        ]
        rows = [[v if i == j else zero() for j in range(len(values))] for i, v in enumerate(values)]
        return block(rows)

    def _scaled(self, scalar: Term, entry: Term) -> Term:
        return self.term(entry if scalar == number(1) else apply("mul", scalar, entry))

    def _one(self, exponent: _Exponent) -> Term:
        if exponent.core.type.rows > _ROWS:
            raise NotExact("the exponential of a matrix of more than 4 rows")
        return self._matrix(exponent) if self.as_matrices else self._polynomial(exponent)

    def _matrix(self, exponent: _Exponent) -> Symbol:
        if exponent not in self.known:
            whole = apply("mul", exponent.scalar, exponent.core)
            name = Name(rf"e^{{{to_latex(whole)}}}", of=(whole,))
            own = self.known[exponent] = symbol(Declaration(name, exponent.core.type, Linear(0)))
            self.values[own] = Value("exp", (whole,), ())
        return self.known[exponent]

    def _polynomial(self, exponent: _Exponent) -> Term:
        core = exponent.core
        if exponent not in self.coefficients:
            whole = to_latex(apply("mul", exponent.scalar, core))
            names = [Name(f"a_{k}", of=(whole, k)) for k in range(core.type.rows)]
            made = [symbol(Declaration(name, SCALAR, Linear(0))) for name in names]
            self.coefficients[exponent] = exponent, made
        powers = [identity(core.type), core, *(power(core, k) for k in range(2, core.type.rows))]
        terms = [apply("mul", a, p) for a, p in zip(self.coefficients[exponent][1], powers, strict=True)]
        return apply("add", *terms)

    def rates(self, highest: int) -> Iterator[Statement]:
        """Yields the rates of the coefficients of constant matrices: those of ṡ M Σ aₖ Mᵏ, where Mⁿ = Σ cₖ
        Mᵏ by the characteristic polynomial."""
        for exponent, a in self.coefficients.values():
            inside = [part for part in reached(self.definitions, exponent.core) if isinstance(part, Symbol)]
            if not highest or not all(part.declaration.constant for part in inside):
                continue
            c = _characteristic(exponent.core)
            for k, own in enumerate(a):
                shifted = apply("mul", a[-1], c[k])
                shifted = apply("add", a[k - 1], shifted) if k else shifted
                rate = apply("mul", derivative(exponent.scalar, 1), shifted)
                for order in range(highest):
                    known = derivative(rate, order) if order else rate
                    yield relation("=", derivative(own, order + 1), known)


def _characteristic(core: Term) -> list[Term]:
    """Returns the cₖ of Mⁿ = Σ cₖ Mᵏ, by the traces of powers (Faddeev and LeVerrier)."""
    n = core.type.rows
    found: list[Term] = []  # c_{n−1}, c_{n−2}, …
    for k in range(1, n + 1):
        total = apply("trace", power(core, k) if k > 1 else core)
        for i, c in enumerate(found):
            lower = k - 1 - i
            trace = apply("trace", power(core, lower) if lower > 1 else core)
            total = apply("add", total, apply("neg", apply("mul", c, trace)))
        found.append(apply("mul", number(Fraction(1, k)), total))
    return found[::-1]


def _scalar(factors: tuple[Term, ...], size: int, is_negative: bool) -> Term:
    share: Term = number(Fraction(-1 if is_negative else 1, size))
    return reduce(lambda one, other: apply("mul", one, other), factors, share)


def _factors_of(term: Term) -> Iterator[Term]:
    if (
        isinstance(term, Apply)
        and term.head == "mul"
        and "scalar" not in {a.type.kind for a in term.arguments}
    ):
        for factor in term.arguments:
            yield from _factors_of(factor)
    else:
        yield term


def _conjugated(core: Term) -> tuple[Term, Term, Term] | None:
    """Returns (P, A, P⁻¹) of P A P⁻¹, and of R A Rᵀ with a rotation R; else None."""
    factors = list(_factors_of(core))
    if len(factors) < 3:
        return None
    first, *middle, last = factors
    inverses = [apply("inverse", first)]
    if isinstance(first, Symbol) and first.declaration.rotation:
        inverses.append(apply("transpose", first))
    back = isinstance(first, Apply) and first.head in ("inverse", "transpose") and first.arguments[0] == last
    is_turned = back and (first.head == "inverse" or _is_rotation(last))  # type: ignore[attr-defined]
    if last not in inverses and not is_turned:
        return None
    return first, reduce(lambda one, other: apply("mul", one, other), middle), last


def _is_rotation(term: Term) -> bool:
    return isinstance(term, Symbol) and term.declaration.rotation


def _planar_angle(entries: Sequence[Sequence[Term]]) -> Term | None:
    """Returns θ of [0 −θ; θ 0]; None for other matrices."""
    if len(entries) != 2 or any(len(row) != 2 or row[0].type != SCALAR != row[1].type for row in entries):
        return None
    (a, b), (c, d) = entries
    is_skew = b == apply("neg", c) or c == apply("neg", b)
    return c if multiple(a) == multiple(d) == "zero" and is_skew else None


def _turn(angle: Term) -> list[list[Term]]:
    cosine, sine = apply("cos", angle), apply("sin", angle)
    return [[cosine, apply("neg", sine)], [sine, cosine]]


def _planar_motion(angle: Term, moving: Sequence[Term]) -> Term:
    """Returns exp [0 −θ x; θ 0 y; 0 0 0], which has the last column (sin θ I + (1 − cos θ) J)/θ (x, y)."""
    (cosine, _), (sine, _) = rows = _turn(angle)
    along = apply("div", sine, angle)
    across = apply("div", apply("add", number(1), apply("neg", cosine)), angle)
    x, y = moving
    last = [
        apply("add", apply("mul", along, x), apply("neg", apply("mul", across, y))),
        apply("add", apply("mul", across, x), apply("mul", along, y)),
    ]
    return block(
        [[*row, entry] for row, entry in zip(rows, last, strict=True)] + [[zero(), zero(), number(1)]]
    )


def _diagonal(core: Block) -> list[Term] | None:
    """Returns the square entries on the diagonal if all others are 0; else None."""
    size = len(core.entries)
    if any(len(row) != size for row in core.entries):
        return None
    for i, row in enumerate(core.entries):
        if (
            any(i != j and multiple(each) != "zero" for j, each in enumerate(row))
            or not row[i].type.is_square
        ):
            return None
    return [core.entries[i][i] for i in range(size)]

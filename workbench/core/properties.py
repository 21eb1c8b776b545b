"""Properties of symbols: the kinds that can have them, the flag of a declaration, and the meaning."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

from workbench.core.construct import apply, derivative, identity, number, relation, zero
from workbench.core.terms import Conjunction, Relation, Statement, Symbol, Term
from workbench.core.types import Declaration

_SQUARE = frozenset({"tensor", "matrix"})
_ANY = frozenset({"scalar", "vector", "tensor", "matrix", "quaternion"})
EVERY = ("every",)


@dataclass(frozen=True)
class Property:
    """One property.

    kinds: the kinds of symbols that can have it.   flag: the flag in a declaration.   keyed: the kinds of
    [symbols] whose entries may have the flag as a key, all by `EVERY`.   term: the general form of a symbol
    with the property.
    equations: the equations that hold for the symbols; None for a condition that no equation expresses.
    count: the number of symbols that the property relates.   chart: the coordinates by which the engines
    parametrize a symbol of one of the kinds.   free: the number of free entries of a matrix of n rows.
    coq: the predicate of the certificates' library; {dual} is put before a predicate that has a form for
    real and one for dual symbols, {d} and {k} are the implicit arguments that others need.

    The two engines share the parameters, not what they make of them.
    """

    name: str
    kinds: frozenset[str]
    flag: str | None = None
    keyed: tuple[str, ...] = ()
    term: Callable[[Term], Term] | None = None
    equations: Callable[..., Sequence[Relation]] | None = None
    count: int = 1
    chart: Mapping[str, str] = field(default_factory=dict)
    free: Callable[[int], int] | None = None
    coq: str | None = None

    def fits(self, symbol: Symbol) -> bool:
        """True if the symbol can have the property."""
        is_square = self.kinds != _SQUARE or symbol.type.is_square
        return symbol.type.kind in self.kinds and is_square and not symbol.type.dual

    def statement_of(self, term: Term) -> Statement:
        """Returns the statement that the term has the property. Raises ValueError if no equation expresses
        it."""
        if self.equations is None:
            raise ValueError(f"no equation says what {self.name} means")
        said = tuple(self.equations(term))
        return said[0] if len(said) == 1 else Conjunction(said)


def _same(left: Term, right: Term) -> Relation:
    return relation("=", left, right)


def _transposed(x: Term) -> Term:
    return apply("transpose", x)


def _orthogonal(x: Term) -> list[Relation]:
    return [_same(apply("mul", x, _transposed(x)), identity(x.type))]


def _rotation(x: Term) -> list[Relation]:
    return [*_orthogonal(x), _same(apply("det", x), number(1))]


def _unit(x: Term) -> list[Relation]:
    square = apply("norm", x) if x.type.kind == "quaternion" else apply("dot", x, x)
    return [_same(square, number(1))]


PROPERTIES: Mapping[str, Property] = {
    each.name: each
    for each in (
        Property(
            "rotation",
            _SQUARE,
            flag="rotation",
            equations=_rotation,
            chart={"tensor": "quaternion"},
            coq="{dual}rotation",
        ),
        Property(
            "unit",
            frozenset({"vector", "quaternion"}),
            flag="unit",
            keyed=("vector", "hamilton quaternion"),
            equations=_unit,
            chart={"vector": "unit", "quaternion": "quaternion"},
            coq="unit_vector (K := K) (d := {d})",
        ),
        Property("orthogonal", _SQUARE, equations=_orthogonal),
        Property(
            "symmetric",
            _SQUARE,
            flag="symmetric",
            keyed=("tensor",),
            equations=lambda x: [_same(_transposed(x), x)],
            free=lambda size: size * (size + 1) // 2,
        ),
        Property("diagonal", _SQUARE, flag="diagonal", keyed=("tensor",), free=lambda size: size),
        Property("skew", _SQUARE, equations=lambda x: [_same(_transposed(x), apply("neg", x))]),
        Property(
            "constant",
            _ANY,
            flag="constant",
            keyed=EVERY,
            equations=lambda x: [_same(derivative(x, 1), zero(x.type))],
            coq="constant (K := K) (d := {d}) (k := {k})",
        ),
        Property("positive", frozenset({"scalar"}), flag="positive", keyed=("scalar",)),
        Property("small", frozenset({"scalar", "vector"}), flag="small", keyed=EVERY),
        Property("transform", frozenset({"matrix"}), flag="transform"),
        Property("coordinate", frozenset({"vector"}), flag="coordinate", keyed=("vector",)),
        Property("uniform", _ANY, flag="uniform", keyed=EVERY),
        Property("independent", _ANY, flag="independent", keyed=EVERY),
        Property("free", _ANY, flag="free", keyed=EVERY),
        Property("zero", _ANY, term=lambda x: zero(x.type), equations=lambda x: [_same(x, zero(x.type))]),
        Property(
            "identity",
            _SQUARE,
            term=lambda x: identity(x.type),
            equations=lambda x: [_same(x, identity(x.type))],
        ),
        Property(
            "perpendicular",
            frozenset({"vector"}),
            equations=lambda a, b: [_same(apply("dot", a, b), zero())],
            count=2,
        ),
        Property(
            "parallel",
            frozenset({"vector"}),
            equations=lambda a, b: [_same(apply("cross", a, b), zero(a.type))],
            count=2,
        ),
    )
}

#: The rows that have a flag, by the flag.
FLAGGED = {each.flag: each for each in PROPERTIES.values() if each.flag}
#: Flags of a declaration that an equation expresses, and that a definition of the symbol must satisfy.
FLAGS = tuple(flag for flag, each in FLAGGED.items() if each.equations)


def properties_of(declaration: Declaration) -> list[Property]:
    """Returns the properties that the flags of a declaration state, in the order of the table."""
    return [each for flag, each in FLAGGED.items() if flag in declaration.flags]


def members_of(declaration: Declaration, term: Term) -> list[Relation]:
    """Returns the equations by which the term is a value of the declared set, such as that of rotations."""
    rows = (each for each in properties_of(declaration) if each.chart and each.equations)
    return [equation for row in rows if row.equations for equation in row.equations(term)]

"""Values of logarithms of rotations, unit quaternions and transforms: the exponents of their exponentials.

    log exp X = X                  for an angle of X below π
    log Yᵀ = log Y⁻¹ = −log Y
    log(Q Y Qᵀ) = (Q x)~           for log Y = x̃
    log(Y Q Qᵀ) = log Y

A free rotation R is exp φ̃ of a free vector φ, and a free unit quaternion exp (0, φ): every one is.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field

from workbench.core.construct import apply, relation, symbol, with_children, zero
from workbench.core.names import Name
from workbench.core.terms import Apply, Relation, Symbol, Term
from workbench.core.types import SCALAR, VECTOR, Declaration
from workbench.engines.inventory import Lookup, NoDefinitions
from workbench.engines.inventory.rodrigues import angle_and_axis, rotation_vector, twist_parts
from workbench.language.printing.printer import to_latex


def is_logarithm(term: Term) -> bool:
    """True for the logarithm of a matrix or a quaternion."""
    return isinstance(term, Apply) and term.head == "log" and term.type != SCALAR


@dataclass
class LogarithmValues:
    """The values of logarithms.

    free: exp φ̃ by the free rotation that it is.   shown: exp X = Y for the values X that are not such by
    definition.   angles: the angles, or vectors of them, that must be below π.   unknown: logarithms without
    a value."""

    definitions: Lookup
    free: dict[Symbol, Term] = field(default_factory=dict)
    shown: list[Relation] = field(default_factory=list)
    angles: dict[Term, None] = field(default_factory=dict)
    unknown: list[Term] = field(default_factory=list)

    def without(self, term: Term) -> Term:
        """Returns the term with values for its logarithms."""
        term = with_children(term, self.without)
        if not (isinstance(term, Apply) and is_logarithm(term)):
            return term
        (turn,) = term.arguments
        value = self._of_transform(turn) if turn.type.kind == "matrix" else self._of_rotation(turn)
        if value is None:
            self.unknown.append(term)
            return term
        return value

    def _of_transform(self, turn: Term) -> Term | None:
        if not (isinstance(turn, Apply) and turn.head == "exp"):
            return None
        parts = twist_parts(turn.arguments[0], self.definitions)
        if parts is None or self.vector_of(parts[0]) is None:
            return None
        return turn.arguments[0]

    def _of_rotation(self, turn: Term) -> Term | None:
        vector = self.vector(turn)
        if vector is None:
            return None
        value = _exponent(vector, turn)
        is_plain = isinstance(turn, Symbol) or (isinstance(turn, Apply) and turn.head == "exp")
        if not is_plain:
            self.shown.append(relation("=", apply("exp", value), turn))
        return value

    def vector(self, turn: Term) -> Term | None:
        """Returns the rotation vector, of a unit quaternion half of it; None if it is not known."""
        match turn:
            case Apply(head="exp", arguments=(exponent,)):
                return self.vector_of(exponent)
            case Symbol(declaration=of) if of.rotation or (of.unit and turn.type.kind == "quaternion"):
                return None if turn.type.dual else self._free_vector(turn)
            case Apply(head="transpose" | "inverse" | "conjugate", arguments=(inner,)):
                return _negative(self.vector(inner))
            case Apply(head="quaternion", arguments=(Apply(head="cos", arguments=(angle,)), above)):
                return self._of_half_angle(angle, above)
        factors = _without_inverses(list(_factors(turn)))
        if len(factors) == 1 and factors[0] != turn:
            return self.vector(factors[0])
        if len(factors) == 3 and turn.type.kind == "tensor":
            first, middle, last = factors
            own = self.vector(middle) if _are_inverse(first, last) and is_rotation(first) else None
            return None if own is None else apply("mul", first, own)
        return None

    def _of_half_angle(self, angle: Term, above: Term) -> Term | None:
        """Returns θ u for the vector part u sin θ with a unit vector u; the engines show that it is one."""
        factors = list(_factors(above))
        axes = [each for each in factors if each != apply("sin", angle)]
        if len(factors) != 2 or len(axes) != 1 or axes[0].type != VECTOR:
            return None
        self.angles[angle] = None
        return apply("mul", angle, axes[0])

    def vector_of(self, exponent: Term) -> Term | None:
        if (turn := angle_and_axis(exponent, self.definitions)) is not None:
            self.angles[turn[0]] = None
            return apply("mul", *turn)
        vector = rotation_vector(exponent, self.definitions)
        if vector is not None and not _is_own(vector):
            self.angles[vector] = None
        return vector

    def _free_vector(self, turn: Symbol) -> Term:
        own = turn.declaration
        name = Name(f"\\log {to_latex(turn)}", of=(turn,))
        vector = symbol(Declaration(name, VECTOR, own.weight, of=own.of).with_flags(constant=own.constant))
        self.free[turn] = apply("exp", _exponent(vector, turn))
        return vector

    def branch(self) -> str:
        """Returns the condition on the angles, as LaTeX."""
        said = (
            rf"-\pi < {to_latex(angle)} < \pi"
            if angle.type.kind == "scalar"
            else f"{to_latex(apply('norm', angle))} < \\pi"
            for angle in self.angles
        )
        return r" \text{ and } ".join(said)


def is_rotation(term: Term) -> bool:
    """True if the term is a rotation or a unit quaternion by its form."""
    match term:
        case Symbol(declaration=own):
            return own.rotation or (own.unit and term.type.kind == "quaternion")
        case Apply(head="exp", arguments=(exponent,)):
            return exponent.type.kind in ("tensor", "quaternion") and _is_skew(exponent)
        case Apply(head="transpose" | "inverse" | "conjugate" | "mul", arguments=arguments):
            return all(map(is_rotation, arguments))
    return False


def _is_skew(exponent: Term) -> bool:
    turned = angle_and_axis(exponent, NoDefinitions()), rotation_vector(exponent, NoDefinitions())
    return any(each is not None for each in turned)


def _exponent(vector: Term, turn: Term) -> Term:
    return apply("quaternion", zero(), vector) if turn.type.kind == "quaternion" else apply("skew", vector)


def _negative(vector: Term | None) -> Term | None:
    return None if vector is None else apply("neg", vector)


def _is_own(vector: Term) -> bool:
    """True for the vector of a free rotation, whose angle is below π."""
    return isinstance(vector, Symbol) and vector.declaration.name.base.startswith("\\log ")


def _factors(term: Term) -> Iterator[Term]:
    if isinstance(term, Apply) and term.head == "mul":
        for factor in term.arguments:
            yield from _factors(factor)
    else:
        yield term


def _without_inverses(factors: list[Term]) -> list[Term]:
    """Returns the factors without neighbours that are rotations inverse to each other."""
    found: list[Term] = []
    for each in factors:
        if found and _are_inverse(found[-1], each) and is_rotation(each):
            found.pop()
        else:
            found.append(each)
    return found


def _are_inverse(one: Term, other: Term) -> bool:
    pairs = ((one, other), (other, one))
    return any(
        isinstance(turned, Apply)
        and turned.head in ("transpose", "inverse", "conjugate")
        and turned.arguments == (plain,)
        for plain, turned in pairs
    )

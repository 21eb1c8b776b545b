"""Definitions of {}^A ω^B, {}^A R_B and r^{P/O} over auxiliary symbols.

Each frame has an orientation Q (I for the base), an angular velocity w = vect(Q̇ Qᵀ) and an origin o; each
point has a position p. These families contain all motions of frames and points and no others, so that proofs
and refutations with them are valid. In components of the base:

    rotation to F from G    Q_Fᵀ Q_G           angular velocity of G in F    w_G − w_F
    to P from O             p_P − p_O          derivative in F               ẋ − w_F × x
    axes of F               Q_F e₁, Q_F e₂, Q_F e₃
    transform to F from G   [Q_Fᵀ Q_G, Q_Fᵀ (o_G − o_F); 0 1]
    x, resolved in F        Q_Fᵀ x             origin of G in F              o_G − o_F, resolved in F
    P fixed in F            p_P = o_F + Q_F c, c constant
    P at x from O           p_P = p_O + x
    x constant in F         Q_F c, of a tensor Q_F c Q_Fᵀ, c constant
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

from workbench.core.construct import apply, block, derivative, number, symbol, zero
from workbench.core.formula_errors import SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Definition, Symbol, Term, Zero
from workbench.core.types import KINDS, TENSOR, VECTOR, Declaration, Type

TRANSFORM = KINDS["transform"]


@dataclass
class Frames:
    """The definitions that the tables declare, and the angular velocity of each frame."""

    base: str
    labels: tuple[str, ...]
    points: tuple[str, ...] = ()
    definitions: list[Definition] = field(default_factory=list)
    declarations: dict[Name, Declaration] = field(default_factory=dict)
    origins: dict[str, Term] = field(default_factory=dict)
    places: dict[str, Term] = field(default_factory=dict)
    given: dict[str, Term] = field(default_factory=dict)
    directions: set[Name] = field(default_factory=set)
    axes: list[Declaration] = field(default_factory=list)

    # the auxiliary symbols

    def orientation(self, frame: str) -> Term | None:
        """Returns Q_F; None for the base, whose orientation is I."""
        name = _own("Q", frame)
        if frame in self.given:
            return self.defined(name, TENSOR, self.given[frame], hidden=True)
        return None if frame == self.base else self.free(name, TENSOR, rotation=True)

    def spin(self, frame: str) -> Term:
        """Returns w_F as given by the orientation."""
        turn = self.orientation(frame)
        if turn is None:
            return zero(VECTOR)
        name = _own("w", frame)
        body = apply("vect", apply("mul", derivative(turn, 1), apply("transpose", turn)))
        return self.defined(name, VECTOR, body, hidden=True)

    def origin(self, frame: str) -> Term:
        if frame == self.base:
            return zero(VECTOR)
        if frame not in self.origins:
            self.origins[frame] = self.free(_own("o", frame), VECTOR)
        return self.origins[frame]

    def place(self, point: str) -> Term:
        if point not in self.places:
            self.places[point] = self.free(_own("p", point), VECTOR)
        return self.places[point]

    def fix(self, point: str, frame: str) -> None:
        """Sets p = o_F + Q_F c. The first point that is fixed in a frame may be its origin."""
        if point in self.places and frame in self.origins:
            raise SpecError(
                f"{point} closes a loop of frames; that is no family that can be written down", "fixed"
            )
        if point in self.places:
            self.origins[frame] = self.places[point]
        elif frame not in self.origins and frame != self.base:
            self.places[point] = self.origin(frame)
        else:
            offset = self.free(_own("c", point), VECTOR, constant=True)
            self.places[point] = plus(self.origin(frame), turned(self.orientation(frame), offset))

    def put(self, point: str) -> None:
        """Marks the position of a point, and the origin of a frame there, as given; `define` sets it
        later."""
        if point in self.places and self.places[point] not in self.origins.values():
            raise SpecError(f"{point} is fixed, too", "place")
        self.place(point)

    def define(self, point: str, body: Term) -> None:
        """Defines the place of a point, which is free until then."""
        place = self.place(point)
        assert isinstance(place, Symbol), f"{point} is fixed, too"
        self.definitions.append(Definition(place.declaration, (), (), body))

    def free(self, name: Name, type_: Type, rotation: bool = False, constant: bool = False) -> Term:
        if name not in self.declarations:
            flags = {"hidden": True, "rotation": rotation, "constant": constant}
            self.declarations[name] = Declaration(name, type_).with_flags(**flags)
        return symbol(self.declarations[name], ())

    def defined(self, name: Name, type_: Type, body: Term, hidden: bool = False) -> Term:
        if name not in self.declarations:
            self.declarations[name] = Declaration(name, type_).with_flags(hidden=hidden)
            self.definitions.append(Definition(self.declarations[name], (), (), body))
        return symbol(self.declarations[name], ())

    def kept(self, declaration: Declaration, frame: str) -> Declaration:
        """Returns the symbol that is constant in a frame, and perhaps in no other."""
        turn = self.orientation(frame)
        name, moving = declaration.name, declaration.with_flags(constant=False)
        own = replace(declaration, name=replace(name, left_sub=("\\mathsf{c}", *name.left_sub)))
        index = tuple(Linear.variable(f"@{place}") for place in range(declaration.indices))
        self.declarations[own.name] = own
        body = turned(turn, symbol(own, index))
        if declaration.type.is_square and turn is not None:
            body = apply("mul", body, apply("transpose", turn))
        self.definitions.append(Definition(moving, index, (), body))
        return moving

    # the author's symbols

    def angular_velocity(self, of: str, seen_from: str) -> Term:
        return minus(self.spin(of), self.spin(seen_from))

    def rate(self, frame: str, body: Term) -> Term:
        spin = self.spin(frame)
        rate = derivative(body, 1)
        return rate if isinstance(spin, Zero) else minus(rate, apply("cross", spin, body))

    def velocity(self, point: str, frame: str) -> Term:
        return self.rate(frame, minus(self.place(point), self.origin(frame)))

    def transform(self, to: str, origin: str) -> Term:
        shift = self.resolved(to, minus(self.origin(origin), self.origin(to)))
        return block([[_rotation(self, to, origin), shift], [zero(Type(1, 3)), number(1)]])

    def resolved(self, frame: str, body: Term) -> Term:
        turn = self.orientation(frame)
        return body if turn is None else apply("mul", apply("transpose", turn), body)


def minus(one: Term, other: Term) -> Term:
    if isinstance(other, Zero):
        return one
    negative = apply("neg", other)
    return negative if isinstance(one, Zero) else apply("add", one, negative)


def plus(one: Term, other: Term) -> Term:
    return other if isinstance(one, Zero) else apply("add", one, other)


def turned(turn: Term | None, body: Term) -> Term:
    return body if turn is None else apply("mul", turn, body)


def _rotation(frames: Frames, to: str, origin: str) -> Term:
    one, other = frames.orientation(to), frames.orientation(origin)
    if one is None:
        assert other is not None, f"{to} and {origin} are the base"
        return other
    return apply("transpose", one) if other is None else apply("mul", apply("transpose", one), other)


#: Phrases of components, which are in the frame F if no other is named.
RESOLVED_IN_F = ("origin of", "place of")
#: (phrase, kind, letters that are frames, term) for each meaning of a spelling.
PHRASES: Sequence[tuple[str, Type, str, Callable[..., Term]]] = (
    (r"rotation to (?P<F>\w) from (?P<G>\w)", TENSOR, "FG", lambda f, F, G: _rotation(f, F, G)),
    (r"angular velocity of (?P<G>\w) in (?P<F>\w)", VECTOR, "FG", lambda f, F, G: f.angular_velocity(G, F)),
    (
        r"angular acceleration of (?P<G>\w) in (?P<F>\w)",
        VECTOR,
        "FG",
        lambda f, F, G: f.rate(F, f.angular_velocity(G, F)),
    ),
    (r"to (?P<P>\w) from (?P<Q>\w)", VECTOR, "", lambda f, P, Q: minus(f.place(P), f.place(Q))),
    (r"velocity of (?P<P>\w) in (?P<F>\w)", VECTOR, "F", lambda f, P, F: f.velocity(P, F)),
    (r"transform to (?P<F>\w) from (?P<G>\w)", TRANSFORM, "FG", lambda f, F, G: f.transform(F, G)),
    (r"origin of (?P<G>\w) in (?P<F>\w)", VECTOR, "FG", lambda f, F, G: minus(f.origin(G), f.origin(F))),
    (r"place of (?P<P>\w) in (?P<F>\w)", VECTOR, "F", lambda f, P, F: minus(f.place(P), f.origin(F))),
    (
        r"velocity of the origin of (?P<G>\w) in (?P<F>\w)",
        VECTOR,
        "FG",
        lambda f, F, G: f.rate(F, minus(f.origin(G), f.origin(F))),
    ),
    (
        r"acceleration of the origin of (?P<G>\w) in (?P<F>\w)",
        VECTOR,
        "FG",
        lambda f, F, G: f.rate(F, f.rate(F, minus(f.origin(G), f.origin(F)))),
    ),
    (r"acceleration of (?P<P>\w) in (?P<F>\w)", VECTOR, "F", lambda f, P, F: f.rate(F, f.velocity(P, F))),
)


def _own(letter: str, label: str) -> Name:
    """Returns the name of an auxiliary symbol."""
    return Name(letter, ("\\mathsf",), sub=(label,))

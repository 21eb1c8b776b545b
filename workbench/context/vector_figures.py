"""Guesses about vectors in a figure: the axes of a frame, perpendicular vectors, rotating vectors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations

from workbench.context.facts import Supposition
from workbench.context.formula_subject import Subject
from workbench.context.free_symbols import terms_of
from workbench.context.property_statements import having, joined
from workbench.core.construct import apply, block, derivative, number, relation, symbol, zero
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Apply, Relation, Statement, Symbol, Term, sides_of
from workbench.core.types import SCALAR, TENSOR, Declaration
from workbench.language.printing.printer import to_latex

#: (description, the symbols concerned, the supposition about them).
Made = tuple[str, list[Symbol], Supposition]

#: The letters of axes in textbooks. Vectors with a hat count too, and three vectors of one letter with the
#: scripts 1, 2, 3 or x, y, z.
_AXES = ("ijk", "IJK", "e", "E", "tnb", "TNB", "u")
#: The greatest number of scalars among which one is tried as an angle.
_MOST_ANGLES = 3
#: The greatest number of vectors that are tried as the angular velocity.
_MOST_SPINS = 4


def named(symbols: Sequence[Symbol]) -> str:
    return ", ".join(f"${to_latex(each)}$" for each in symbols)


def has_hat(own: Symbol) -> bool:
    return "\\hat" in own.declaration.name.styles


def unstyled(own: Symbol) -> tuple[Name, tuple[Linear, ...]]:
    """Returns the key that symbols share if they differ by accents and typefaces only."""
    return replace(own.declaration.name, styles=()), own.index


def axes(subject: Subject) -> Iterator[Made]:
    """Yields sets of vectors as the axes of one frame, which may rotate by an angle about its last axis.

    Both orientations are tried if the letters do not tell the order.
    """
    yield from _families(subject)
    vectors = [each for each in subject.free if each.type.kind == "vector" and not each.index]
    angles = [each for each in subject.free if each.type == SCALAR and not each.index]
    for group in _groups(vectors):
        own = sorted(group, key=lambda each: _position(each.declaration.name))
        words = f"{named(own)}: axes of a frame"
        rests = all(each.declaration.constant for each in own)
        orders = [(0, 1, 2), (1, 0, 2)]
        if all(_position(each.declaration.name) for each in own):
            orders = orders[:1]
        for order in orders:
            yield words, own, _along(own, _units(constant=rests), order)
            for angle in angles if len(angles) <= _MOST_ANGLES else []:
                turned = _turned(_units(constant=True), angle)
                yield f"{words} that turns by ${to_latex(angle)}$", own, _along(own, turned, order)


def _families(subject: Subject) -> Iterator[Made]:
    """Yields the first three members of a family of vectors as the axes of a frame."""
    vectors = (each for each in subject.free if each.type.kind == "vector" and len(each.index) == 1)
    for own in dict.fromkeys(each.declaration for each in vectors):
        members = [symbol(own, (Linear(place),)) for place in (1, 2, 3)]
        terms = tuple(zip(members, _units(constant=False), strict=True))
        yield f"{named(members)}: axes of a frame", members, Supposition(terms)


def _groups(vectors: Sequence[Symbol]) -> Iterator[list[Symbol]]:
    groups: dict[str | Name, list[Symbol]] = {}
    for each in vectors:
        name = each.declaration.name
        letters = [letters for letters in _AXES if name.letter in letters]
        for letter in ["\\hat"] * has_hat(each) + letters:
            groups.setdefault(letter, []).append(each)
        if name.sub and _position(name) and not (letters or has_hat(each)):
            groups.setdefault(replace(name, sub=()), []).append(each)
    for key, group in groups.items():
        if len(group) == 3 or (isinstance(key, str) and len(group) == 2):
            yield group


def _position(name: Name) -> int:
    """Returns 1, 2 or 3 for the first, second or third axis, by the letters i j k, x y z or 1 2 3; else 0."""
    last = "".join(name.sub) or name.letter
    return next((at % 3 + 1 for at, letter in enumerate("ijkxyzIJKXYZ123") if letter == last), 0)


def _along(own: Sequence[Symbol], units: Sequence[Term], order: Sequence[int]) -> Supposition:
    chosen = [units[at] for at in order[: len(own)]]
    return Supposition(tuple((each.declaration.name, unit) for each, unit in zip(own, chosen, strict=True)))


def _units(constant: bool) -> list[Term]:
    """Returns the axes of a frame in any orientation."""
    turn = symbol(Declaration(Name("Q", ("\\mathsf",)), TENSOR).with_flags(rotation=True, constant=constant))
    return [apply("mul", turn, block([[number(int(i == k))] for i in range(3)])) for k in range(3)]


def _turned(units: Sequence[Term], angle: Symbol) -> list[Term]:
    """Returns the axes rotated by an angle about the third."""
    one, other, axis = units
    sine, cosine = apply("sin", angle), apply("cos", angle)
    along = apply("add", apply("mul", cosine, one), apply("mul", sine, other))
    across = apply("add", apply("mul", apply("neg", sine), one), apply("mul", cosine, other))
    return [along, across, axis]


def right_angles(subject: Subject) -> Iterator[Made]:
    """Yields the supposition a · r = 0 for a × (a × r), if no a · r is written."""
    vectors = [each for each in subject.free if each.type.kind == "vector"]
    for axis, arm in permutations(vectors, 2):
        if _turns_across(subject.statement, axis, arm):
            words = f"${to_latex(axis)}$: at right angles to ${to_latex(arm)}$"
            across = Supposition((), (relation("=", apply("dot", axis, arm), zero()),))
            yield words, [axis, arm], across
            yield f"{words}, and unit", [axis, arm], joined([having("unit", [axis]), across])


def _turns_across(statement: Statement, axis: Symbol, arm: Symbol) -> bool:
    products = [term for term in terms_of(statement) if isinstance(term, Apply)]
    if any(term.head == "dot" and {axis, arm} == {*term.arguments} for term in products):
        return False
    crosses = [term.arguments for term in products if term.head == "cross"]
    return any(
        axis in left.walk()
        and arm in right.walk()
        and any(isinstance(part, Apply) and part.head == "cross" for part in right.walk())
        for left, right in crosses
    )


def coincident(subject: Subject) -> Iterator[Made]:
    """Yields the supposition that a moving point is where a point of a frame is, as in the one-point theorem.

    A formula with the vector between the two does not mean that.
    """
    frames = subject.symbols.frames
    reached = set(subject.definitions.reached(*sides_of(subject.statement)))
    written = [term for term in terms_of(subject.statement) if isinstance(term, Symbol)]
    shown = [each.body for own in dict.fromkeys(written) for each in subject.definitions.about(own)]
    own = [each for each in dict.fromkeys(written) if each.type.kind == "vector"]
    for (point, place), (carried, spot) in permutations(frames.places.items(), 2):
        is_carried = carried in frames.fixed and point not in frames.fixed
        between = {apply("add", one, apply("neg", other)) for one, other in permutations((place, spot))}
        parts = {part for term in (place, spot) for part in term.symbols()}
        if is_carried and parts <= reached and between.isdisjoint(shown):
            words = f"{point} and {carried}: at one place"
            yield words, own, Supposition((), (relation("=", place, spot),))


def turning(subject: Subject) -> Iterator[Made]:
    """Yields vectors and tensors without a written rate as rotating with a vector, or by a rotation."""
    rated = {body.declaration for body in subject.rates if isinstance(body, Symbol)}
    rests = [
        each
        for each in subject.free
        if each.declaration in subject.written - rated and not (each.declaration.constant or each.index)
    ]
    if not (subject.rates and rests):
        return
    vectors = [each for each in subject.free if each.type.kind == "vector" and not each.index]
    for spin in vectors[:_MOST_SPINS]:
        yield from _turning([each for each in rests if each != spin], spin)


def _turning(rests: Sequence[Symbol], spin: Symbol) -> Iterator[Made]:
    own = [s for s in rests if s.type.kind in ("vector", "tensor") and not s.declaration.rotation]
    still = having("constant", [s for s in rests if s.type.kind not in ("vector", "tensor")])
    if own:
        rates = Supposition((), tuple(said for each in own for said in _turns(each, spin)))
        words = f"{named(own)}: turning with ${to_latex(spin)}$"
        yield words, [*own, spin], joined([still, rates])
    for turn in (each for each in rests if each.declaration.rotation):
        rate, back = derivative(turn, 1), apply("transpose", turn)
        for factors in ((rate, back), (back, rate)):
            velocity = Supposition(((spin.declaration.name, apply("vect", apply("mul", *factors))),))
            words = f"${to_latex(turn)}$: turning with ${to_latex(spin)}$"
            yield words, [turn, spin], joined([still, velocity])


def _turns(own: Symbol, spin: Symbol) -> list[Relation]:
    """Returns equations for the first two rates of a rotating vector or tensor."""
    if own.type.kind == "vector":
        rate: Term = apply("cross", spin, own)
    else:
        turn = apply("skew", spin)
        rate = apply("add", apply("mul", turn, own), apply("neg", apply("mul", own, turn)))
    return [
        relation("=", derivative(own, 1), rate),
        relation("=", derivative(own, 2), derivative(rate, 1)),
    ]

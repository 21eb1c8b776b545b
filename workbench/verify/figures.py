"""What vectors and numbers are in a figure: axes of a frame, lengths, what stands at right angles."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import permutations

from workbench.language.printing.printer import to_latex
from workbench.language.typed.construct import apply, block, number, relation, symbol, zero
from workbench.language.typed.integers import Linear
from workbench.language.typed.names import Name
from workbench.language.typed.terms import Apply, Statement, Symbol, Term
from workbench.language.typed.types import SCALAR, TENSOR, Declaration
from workbench.papers.said import terms_of
from workbench.verify.resting import Supposing

#: Letters of unit vectors that stand at right angles, as textbooks choose them; any with a hat is one, too,
#: and three of any letter with the scripts 1, 2, 3 or x, y, z.
_AXES = ("ijk", "IJK", "e", "E", "tnb", "TNB", "u")
#: More numbers than these in a formula are not tried as the angle.
_MOST_ANGLES = 3


def figures(statement: Statement, free: Sequence[Symbol], behind: Sequence[Symbol]) -> Iterator[Supposing]:
    """What they may be: in words, as what symbols are, and as premises. `behind`: the free symbols of which
    the statement speaks or what defines its symbols does."""
    yield from lengths(free)
    yield from _first_of_families(free)
    own = [each for each in behind if each.type.kind == "vector"]
    yield from _axes(own, [each for each in free if each.type == SCALAR and not each.index])
    vectors = [each for each in free if each.type.kind == "vector"]
    for axis, arm in permutations(vectors, 2):
        if _turns_across(statement, axis, arm):
            unit = symbol(replace(axis.declaration, unit=True), axis.index)
            for what, own in (("", axis), ("a unit ", unit)):
                across = relation("=", apply("dot", own, arm), zero())
                words = f"{what}{to_latex(axis)} at right angles to {to_latex(arm)}"
                yield words, {axis.declaration.name: own}, [across]


def _turns_across(statement: Statement, axis: Symbol, arm: Symbol) -> bool:
    """Whether the arm is turned about the axis twice, a × (a × r), and no a · r is written."""
    products = [term for term in terms_of(statement) if isinstance(term, Apply)]
    if any(term.head == "dot" and {axis, arm} == {*term.arguments} for term in products):
        return False
    crosses = [term.arguments for term in products if term.head == "cross"]
    return any(axis in left.walk() and arm in right.walk() and _is_cross(right) for left, right in crosses)


def _is_cross(term: Term) -> bool:
    return any(isinstance(part, Apply) and part.head == "cross" for part in term.walk())


def lengths(free: Sequence[Symbol]) -> Iterator[Supposing]:
    """The number r beside the vector \\mathbf{r}."""
    vectors = {_unstyled(each): each for each in free if each.type.kind == "vector" and not _has_hat(each)}
    numbers = [each for each in free if each.type == SCALAR and _unstyled(each) in vectors]
    pairs = [(each, vectors[_unstyled(each)]) for each in numbers]
    if pairs:
        what = ", ".join(f"{to_latex(number)} the length of {to_latex(vector)}" for number, vector in pairs)
        yield what, {number.declaration.name: apply("norm", vector) for number, vector in pairs}, []


def _has_hat(own: Symbol) -> bool:
    return "\\hat" in own.declaration.name.styles


def _unstyled(own: Symbol) -> tuple[Name, tuple[Linear, ...]]:
    return replace(own.declaration.name, styles=()), own.index


def _first_of_families(free: Sequence[Symbol]) -> Iterator[Supposing]:
    """The axes of a frame that are the first three members of a family."""
    vectors = (each for each in free if each.type.kind == "vector" and len(each.index) == 1)
    for own in dict.fromkeys(each.declaration for each in vectors):
        members = [symbol(own, (Linear(place),)) for place in (1, 2, 3)]
        shown = ", ".join(map(to_latex, members))
        yield f"{shown} axes of a frame", dict(zip(members, _units(constant=False), strict=True)), []


def _axes(vectors: Sequence[Symbol], angles: Sequence[Symbol]) -> Iterator[Supposing]:
    """Two or three vectors that are the axes of one frame, of either handedness where no letter tells; it may
    turn by one of the angles about the last of them."""
    groups: dict[str | Name, list[Symbol]] = {}
    for each in vectors:
        name = each.declaration.name
        if not each.index:
            letters = [letters for letters in _AXES if name.letter in letters]
            for key in ["\\hat"] * _has_hat(each) + letters:
                groups.setdefault(key, []).append(each)
            if name.sub and _place(name) and not (letters or _has_hat(each)):
                groups.setdefault(replace(name, sub=()), []).append(each)
    groups = {key: group for key, group in groups.items() if isinstance(key, str) or len(group) == 3}
    for group in groups.values():
        names = sorted((each.declaration.name for each in group), key=_place)
        is_known = all(_place(name) for name in names)
        shown = f"{', '.join(map(to_latex, group))} axes of a frame"
        rests = all(each.declaration.constant for each in group)
        for order in [(0, 1, 2), (1, 0, 2)][: 1 if is_known else 2] if 1 < len(group) < 4 else []:
            yield shown, _along(names, _units(constant=rests), order), []
            for angle in angles if len(angles) <= _MOST_ANGLES else []:
                turned = _turned(_units(constant=True), angle)
                yield f"{shown} that turns by {to_latex(angle)}", _along(names, turned, order), []


def _place(name: Name) -> int:
    """Of the first, second or third axis, as i j k, x y z or 1 2 3 say; 0 where nothing does."""
    last = "".join(name.sub) or name.letter
    return next((at % 3 + 1 for at, letter in enumerate("ijkxyzIJKXYZ123") if letter == last), 0)


def _along(names: Sequence[Name], units: Sequence[Term], order: Sequence[int]) -> dict[Name, Term]:
    return {name: units[place] for name, place in zip(names, order, strict=False)}


def _units(constant: bool) -> list[Term]:
    turn = symbol(Declaration(Name("Q", ("\\mathsf",)), TENSOR, rotation=True, constant=constant))
    return [apply("mul", turn, block([[number(int(i == k))] for i in range(3)])) for k in range(3)]


def _turned(units: Sequence[Term], angle: Symbol) -> list[Term]:
    one, other, axis = units
    sine, cosine = apply("sin", angle), apply("cos", angle)
    along = apply("add", apply("mul", cosine, one), apply("mul", sine, other))
    across = apply("add", apply("mul", apply("neg", sine), one), apply("mul", cosine, other))
    return [along, across, axis]

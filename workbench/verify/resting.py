"""What the symbols do of which a formula with derivatives takes none: they rest, or turn with a vector. A
text says so in words (a mass, a point of the body), and its model may leave it out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from workbench.language.definitions import Definitions
from workbench.language.printing.printer import to_latex
from workbench.language.typed.construct import apply, derivative, relation, symbol
from workbench.language.typed.integers import Linear
from workbench.language.typed.names import Name
from workbench.language.typed.terms import Definition, Derivative, Relation, Symbol, Term
from workbench.language.typed.types import Declaration
from workbench.papers.model import Claim
from workbench.papers.said import free_in, terms_of

#: More vectors than these in a formula are not tried as the one that others turn with.
_MOST_TRIED = 4

#: In words; what symbols are, by their names, or members of families by themselves; premises.
Supposing = tuple[str, dict[Name | Symbol, Term], list[Relation]]


def at_rest(claim: Claim, said: Sequence[Definition]) -> Iterator[Supposing]:
    """What a formula may suppose: in words, as what symbols are, and as premises."""
    known = Definitions([*claim.notation.definitions, *said])
    written = [*terms_of(claim.printed.statement), *(each.body for each in known)]
    rates = [part.body for term in written for part in term.walk() if isinstance(part, Derivative)]
    moving = {each.declaration for each in rates if isinstance(each, Symbol)}
    shown = {part.declaration for part in terms_of(claim.printed.statement) if isinstance(part, Symbol)}
    free = sorted(free_in(terms_of(claim.printed.statement), known), key=lambda each: str(each.name))
    behind = [each for each in free if not (each.free or each.indices or each.parameters or each.type.dual)]
    plain = [each for each in behind if each in shown]
    may = [each for each in behind if not each.constant and each.weight in (None, Linear(0))]
    rests = [each for each in may if each in shown and each not in moving]
    never = [each for each in may if each not in moving and each.name not in claim.moving]
    if any(free_in([rate], known) <= {*never} for rate in rates):  # what is a rate would be none
        never = []
    for still in (never, rests):
        if rates and still:
            yield from _constant([each for each in still if not each.rotation])
    if rates and rests:
        vectors = [symbol(each) for each in plain if each.type.kind == "vector"]
        for spin in vectors[:_MOST_TRIED]:
            yield from _turning([each for each in rests if each.name != spin.declaration.name], spin)


def _constant(rests: Sequence[Declaration]) -> Iterator[Supposing]:
    still = _still(rests)
    what = f"a constant {', '.join(map(str, still))}"
    yield what, still, []
    squares = [each for each in rests if each.type.is_square and each.type.rows > 1 and not each.symmetric]
    tensors = [replace(each, symmetric=True) for each in squares if each.type.kind == "tensor"]
    own = [still[each.name] for each in squares if each.type.kind != "tensor"]
    if squares:
        names = ", ".join(str(each.name) for each in squares)
        premises = [_same(each, apply("transpose", each)) for each in own]
        yield f"{what} and a symmetric {names}", still | _still(tensors), premises


def _still(several: Iterable[Declaration]) -> dict[Name, Term]:
    return {each.name: symbol(replace(each, constant=True)) for each in several}


def _turning(rests: Sequence[Declaration], spin: Symbol) -> Iterator[Supposing]:
    """A rotation turns with its own angular velocity, in its axes or in those that it turns from."""
    rotations = [symbol(each) for each in rests if each.rotation]
    turning = [symbol(each) for each in rests if each.type.kind in ("vector", "tensor") and not each.rotation]
    still = _still(each for each in rests if each.type.kind not in ("vector", "tensor"))
    if turning:
        premises = [said for each in turning for said in _turns(each, spin)]
        yield f"{', '.join(map(to_latex, turning))} turning with {to_latex(spin)}", still, premises
    for own in rotations:
        rate, back = derivative(own, 1), apply("transpose", own)
        for factors in ((rate, back), (back, rate)):
            turn = {spin.declaration.name: apply("vect", apply("mul", *factors))}
            yield f"{to_latex(own)} turning with {to_latex(spin)}", still | turn, []


def _turns(own: Symbol, spin: Symbol) -> list[Relation]:
    """The first two rates of what turns."""
    if own.type.kind == "vector":
        rate: Term = apply("cross", spin, own)
    else:
        turn = apply("skew", spin)
        rate = apply("add", apply("mul", turn, own), apply("neg", apply("mul", own, turn)))
    return [_same(derivative(own, 1), rate), _same(derivative(own, 2), derivative(rate, 1))]


def _same(left: Term, right: Term) -> Relation:
    return relation("=", left, right)

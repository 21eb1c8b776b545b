"""Angles in print: the angle between two vectors, and products after a sine without brackets."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from typing import Any

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.construct import apply, block, relation
from workbench.core.formula_errors import Fault
from workbench.core.operations import CIRCULAR, FUNCTIONS
from workbench.core.terms import (
    Apply,
    Conjunction,
    Derivative,
    Integer,
    Number,
    Relation,
    Statement,
    Symbol,
    Term,
)
from workbench.core.types import PI, SCALAR
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Bracket,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Sum,
    core,
    in_a_row,
    is_function,
)
from workbench.language.grammar.vocabulary import MODULO
from workbench.language.naming.patterns import parts_of
from workbench.language.naming.scope import Scope

#: Letters that are angles after a sine.
_ANGLES = frozenset(
    {
        "\\alpha",
        "\\beta",
        "\\nu",
        "\\gamma",
        "\\theta",
        "\\vartheta",
        "\\phi",
        "\\varphi",
        "\\psi",
        "\\Theta",
        "\\Phi",
    }
)


def of_angle_between(scope: Scope, head: str, argument: Node) -> Term | None:
    """Returns \\cos\\langle a, b\\rangle or \\sin\\langle a, b\\rangle of two vectors: a · b or |a × b| over
    their lengths.

    Returns None if ⟨a, b⟩ is a name or not an angle. Raises Fault for other functions of an angle: a · b is
    none.
    """
    if not isinstance(argument, Bracket) or argument.kind != "\\langle" or len(argument.parts) != 2:
        return None
    if head not in CIRCULAR or scope.spelt(argument) is not None:
        return None
    one, other = (scope.term(part) for part in argument.parts)
    if not (one.type == other.type and one.type.is_column):
        return None
    if head not in ("cos", "sin") or (head == "sin" and one.type.kind != "vector"):
        message = SyntaxCode.TRIPLE_PRODUCT_OR_PAIR()
        raise Fault(SyntaxCode.EXPRESSIONS_BETWEEN_BRACKETS(terms=2, message=message), argument.at)
    above = scope.apply(argument.at, "dot", one, other)
    if head == "sin":
        above = scope.apply(argument.at, "norm", scope.apply(argument.at, "cross", one, other))
    lengths = (scope.apply(argument.at, "norm", each) for each in (one, other))
    return scope.apply(argument.at, "div", above, scope.apply(argument.at, "mul", *lengths))


def is_angle(term: Term) -> bool:
    """True for a scalar symbol whose letter denotes an angle, and for the time."""
    letter = term.declaration.name.letter if isinstance(term, Symbol) else ""
    return term.type.kind == "scalar" and (letter in _ANGLES or _is_time(term))


def multiplies_an_angle(term: Term, is_first: bool = True) -> bool:
    r"""True for a number and for \pi, as 2 and \pi of \cos 2\pi n, not for an angle like \pi/4.

    is_first: whether nothing stands between the function and the term; an integer n counts only then."""
    is_pi = isinstance(term, Symbol) and term.declaration == PI
    return is_pi or isinstance(term, Number | Integer if is_first else Number)


def goes_on(argument: Term, following: Term) -> bool:
    """True if a factor after a sine belongs to its argument, as in \\tan l\\phi and \\sin\\omega t: the
    argument so far is a number or a length, and an angle follows."""
    parts = [argument, following]
    if any(isinstance(part, Derivative) or part.type.kind != "scalar" for part in parts):
        return False
    is_whole = any(is_angle(part) for part in argument.walk())
    return is_angle(following) and not is_whole


def ends_with_angle(argument: Term, following: Term) -> bool:
    r"""True if a factor after a sine multiplies it: an angle before another symbol, or a fraction that is no
    angle, as in \cos\theta x and \cos\theta \frac{x}{y}."""
    match following:
        case Apply(head="div", arguments=(Symbol() | Number() | Integer() as over, _)):
            is_beside = not (is_angle(over) or multiplies_an_angle(over))
        case Symbol() | Apply(head="div"):
            is_beside = not is_angle(following)
        case _:
            return False
    is_scalar = following.type.kind == "scalar"
    return is_beside and is_scalar and is_angle(argument) and not _is_time(argument)


def _is_time(term: Term) -> bool:
    return isinstance(term, Symbol) and term.declaration.clock


def angles_in(node: Any) -> Iterator[tuple[str, str]]:
    """Yields m and \\theta for each \\cos m\\theta of a formula, where \\theta denotes an angle."""
    items = node.items if isinstance(node, Product) else ()
    for place, item in enumerate(items):
        behind = items[place + 1 : place + 3]
        if (
            _is_circular(item)
            and len(behind) == 2
            and all(isinstance(each, Leaf | Scripted) for each in behind)
        ):
            factor, angle = map(written, behind)
            if angle in _ANGLES:
                yield factor, angle
    for part in parts_of(node):
        yield from angles_in(part)


def written(node: Node) -> str:
    """Returns a node as text without spaces."""
    return latex_of(node).replace(" ", "")


def end_of_angle(items: Sequence[Node], place: int, known: Collection[tuple[str, str]]) -> int | None:
    """Returns where the angle (m - n) \\theta ends that begins with the bracket at a place.

    The formula shows \\cos m\\theta, too. Returns None for other brackets.
    """
    addends = _addends(items[place])
    angles = {angle for factor, angle in known if factor in addends}
    for end in range(place + 1, len(items)):
        if not isinstance(items[end], Leaf | Scripted) or is_function(items[end]):
            return None
        if written(items[end]) in angles:
            return end + 1
    return None


def _addends(bracket: Node) -> set[str]:
    match bracket:
        case Bracket(kind="(", parts=(Sum(addends=addends),)):
            return {written(core(each)) for _, _, each in addends}
    return set()


def _is_circular(item: Node) -> bool:
    return isinstance(item, Leaf) and is_function(item) and FUNCTIONS.get(item.name) in CIRCULAR


def without_modulus(side: Node) -> tuple[Node, list[Node]]:
    """Returns a side without \\bmod 2\\pi behind its addends, and the moduli."""
    match side:
        case Product(items=items) if (place := _place_of_modulus(items)) is not None:
            before, after = items[:place], items[place + 1 :]
            return in_a_row(side.at, before), [in_a_row(side.at, after)]
        case Sum(addends=addends):
            parts = [(sign, at, *without_modulus(addend)) for sign, at, addend in addends]
            found = [each for *_, moduli in parts for each in moduli]
            return Sum(side.at, tuple((sign, at, body) for sign, at, body, _ in parts)), found
    return side, []


def _place_of_modulus(items: Sequence[Node]) -> int | None:
    """Returns the place of the sign between two parts of a product."""
    found = [n for n, item in enumerate(items) if isinstance(item, Infix) and item.operator == MODULO]
    return found[0] if len(found) == 1 and 0 < found[0] < len(items) - 1 else None


def is_full_turn(modulus: Node) -> bool:
    return written(modulus).strip("{}") == "2\\pi"


def modulo_turns(said: Statement, at: int) -> Statement:
    """Returns the equations of angles with the cosines and sines of their sides. Raises Fault for others."""
    if isinstance(said, Conjunction):
        return Conjunction(tuple(modulo_turns(part, at) for part in said.parts))
    if not isinstance(said, Relation) or said.operator != "=" or said.left.type != SCALAR:
        raise Fault(SyntaxCode.MODULUS(), at)
    sides = [[[apply(head, side)] for head in ("cos", "sin")] for side in (said.left, said.right)]
    return relation("=", *map(block, sides))

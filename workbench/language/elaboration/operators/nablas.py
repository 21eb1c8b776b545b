"""∇ of fields, by the derivative ∂/∂x with respect to the position, whose row i belongs to the component i:

∇f = (∂f/∂x)ᵀ     ∇·v = tr ∂v/∂x     ∇×v = 2 vect ∂v/∂x     (a·∇)v = (∂v/∂x) a     ∇²f = ∇·∇f
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import Block, IllFormed, Symbol, Term
from workbench.core.types import VECTOR
from workbench.language.elaboration.factors import Factor, Row
from workbench.language.grammar.syntax import (
    Bracket,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    core,
    in_a_row,
    unstyled,
)
from workbench.language.naming.scope import Scope

NABLA = "\\nabla"


@dataclass(frozen=True, slots=True)
class Del(Node):
    """A ∇ with its variable, its power, and the sign after it."""

    by: Node | None = None
    power: Node | None = None
    sign: str = ""


def as_del(node: Node) -> Del | None:
    """Returns the node as ∇, ∇_q or ∇²; None for other nodes."""
    if isinstance(node, Del):
        return node
    scripts = node if isinstance(node, Scripted) else Scripted(node.at, node)
    _, letter = unstyled(scripts.nucleus)
    if not (isinstance(letter, Leaf) and letter.text == NABLA):
        return None
    if scripts.primes or scripts.factorial:
        raise Fault(SyntaxCode.PRIME_NABLA(), node.at)
    return Del(node.at, scripts.sub, scripts.sup)


def with_sign(rows: Sequence[Sequence[Node]], signs: Sequence[Infix], sign: Infix) -> Del | None:
    """Returns ∇· or ∇×, if a ∇ ends the last row before the sign; else None."""
    found = as_del(rows[-1][-1]) if rows[-1] else None
    if found is None or found.sign or sign.operator not in ("·", "×"):
        return None
    if signs and len(rows[-1]) == 1:
        raise Fault(SyntaxCode.WHAT_DOES_NABLA_ACT(), found.at)
    return replace(found, sign=sign.operator)


def along(node: Node) -> tuple[Node, Del] | None:
    """Returns the a of (a · ∇), and the ∇; None for other nodes."""
    match node:
        case Bracket(kind="(" | "[", parts=(part,)):
            match core(part):
                case Product(items=(*left, Infix(operator="·"), last)) if left and (found := as_del(last)):
                    return in_a_row(node.at, left), found
    return None


def of_field(row: Row, place: int, sign: Del, direction: Node | None = None) -> Factor:
    """Returns the ∇ at this index of the row with its argument, as one factor."""
    scope = row.scope
    if place + 1 == len(row.items):
        raise Fault(SyntaxCode.NABLA_OF_WHAT(), sign.at)
    following = row.items[place + 1]
    nucleus = following.nucleus if isinstance(following, Scripted) else None
    if isinstance(nucleus, Bracket) and nucleus.kind in ("(", "[", "\\{"):
        raise Fault(SyntaxCode.POWER_DERIVATIVE_OR_ARGUMENT(), following.at)
    factor = row.factor(place + 1)
    if not isinstance(following, Bracket):
        is_gradient = not (sign.sign or sign.power or direction)
        row.open_head = "gradient" if is_gradient else "∇"
        if factor.end < len(row.items):
            raise Fault(SyntaxCode.HOW_FAR_DOES_NABLA(), sign.at)
    by = _place(scope, sign)
    if direction is not None:
        term = _along(scope, sign, factor.term, by, scope.term(direction))
    else:
        term = _derived(scope, sign, factor.term, by)
    return Factor(term, sign.at, factor.end, row.items[place])


def _place(scope: Scope, sign: Del) -> Term:
    if sign.by is not None:
        by = _several(scope, sign.by) or scope.term(sign.by)
        if not (by.type.is_column and isinstance(by, Symbol | Block)):
            raise Fault(SyntaxCode.NABLA_ANYTHING_BUT_COLUMN(), sign.by.at)
        return by
    places = {each for each in scope.table.symbols.values() if each.coordinate}
    if len(places) != 1:
        raise Fault(SyntaxCode.NABLA_PLACE_ONE_SYMBOL(places=len(places)), sign.at)
    return construct.symbol(places.pop())


def _several(scope: Scope, below: Node) -> Term | None:
    """Returns the column of the x, y and θ of ∇_{x,y,θ}, which are numbers; None for one variable."""
    inner = core(below)
    if not (isinstance(inner, Group) and len(inner.parts) > 1):
        return None
    letters = [scope.term(part) for part in inner.parts]
    if not all(isinstance(letter, Symbol) and letter.type.kind == "scalar" for letter in letters):
        raise Fault(SyntaxCode.NABLA_ANYTHING_BUT_COLUMN(), below.at)
    return construct.block([[letter] for letter in letters])


def _derived(scope: Scope, sign: Del, body: Term, by: Term) -> Term:
    at, kind = sign.at, body.type.kind
    power = core(sign.power)
    if power is not None:
        if not (isinstance(power, Leaf) and power.text == "2") or sign.sign or kind != "scalar":
            raise Fault(SyntaxCode.POWER_OF_NABLA(), at)
        return construct.apply("trace", _slopes(scope, at, _gradient(scope, at, body, by), by))
    if sign.sign:
        if body.type != by.type or (sign.sign == "×" and by.type != VECTOR):
            raise TypeMismatch(
                IllFormed(TypeCode.NABLA_OF_OTHER_PLACE(sign=sign.sign, type=body.type, type_2=by.type)), at
            )
        slopes = _slopes(scope, at, body, by)
        if sign.sign == "·":
            return construct.apply("trace", slopes)
        return construct.apply("mul", construct.number(2), construct.apply("vect", slopes))
    if kind != "scalar":
        raise Fault(SyntaxCode.NABLA_INDEX_NABLA_WRITE(type=body.type), at)
    return _gradient(scope, at, body, by)


def _along(scope: Scope, sign: Del, body: Term, by: Term, direction: Term) -> Term:
    if sign.power is not None or sign.sign or direction.type != by.type:
        raise Fault(SyntaxCode.EXPECTED_DIRECTION_CDOT_NABLA(), sign.at)
    return construct.apply("mul", _slopes(scope, sign.at, body, by), direction)


def _gradient(scope: Scope, at: int, body: Term, by: Term) -> Term:
    return construct.apply("transpose", _slopes(scope, at, body, by))


def _slopes(scope: Scope, at: int, body: Term, by: Term) -> Term:
    return scope.apply(at, "partial", body, by)

"""Fractions: numbers, quotients, and d/dt, ∂/∂x and d/dx printed as fractions."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction as Rational
from typing import Any, NamedTuple, cast

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.names import Name
from workbench.core.operations import HYPERBOLIC, QUOTIENTS, SIGNS_OF
from workbench.core.terms import Head, IllFormed, Number, Term, Unsupported, Zero
from workbench.core.types import Type
from workbench.language.grammar.syntax import (
    Fraction,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
    in_a_row,
)
from workbench.language.naming.reading_conventions import Relaxation
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import spell_label

_PARTIAL = "\\partial"


class Rate(NamedTuple):
    """The parts of \\frac{d^k x}{dt^k}.

    order_above, order_below: the orders, None if not written.
    behind: the nodes after the upper d.
    by: of \\frac{\\partial^3 x}{\\partial y^2 \\partial z} the variables with their orders.
    head: "partial", or "total" for \\frac{dx}{dy}.
    upright: True if the d is not an italic letter.
    """

    order_above: Node | None
    order_below: Node | None
    behind: tuple[Node, ...]
    frame: Node | None = None
    by: tuple[tuple[tuple[Node, ...], Node | None], ...] = ()
    head: Head = "partial"
    upright: bool = False


def rate(scope: Scope, fraction: Fraction) -> Rate | None:
    """Returns the parts of a d/dt; None for a quotient.

    If d or t is a symbol of the paper it is still the derivative. If both are, it may also be a quotient of
    products: raises Fault.
    """
    above, below = _factors(fraction.numerator), _factors(fraction.denominator)
    frame, above = _frame(above)
    if frame is None and len(below) == 2 and (label := _frame_of_time(scope, below[1])) is not None:
        labelled: Any = below[1]
        frame, below = label, (below[0], labelled.nucleus)
    upper, lower = _letter(above[0]), _letter(below[0])
    if _PARTIAL in (upper.text, lower.text):
        return _partial(fraction, upper, above, below, frame)
    if (upper.text, lower.text) == ("d", "d") and len(below) > 1 and _letter(below[1]).text != "t":
        if scope.knows(upper.name) or scope.knows(lower.name) or frame is not None:
            message = SyntaxCode.DERIVATIVE_BY_OTHER_THAN_TIME()
            raise Fault(SyntaxCode.D_AS_FACTOR(message=message), fraction.at)
        variable, order = _split_order(below[1:])
        return Rate(
            upper.order, order, above[1:], by=((variable, order),), head="total", upright=upper.name != "d"
        )
    if len(below) != 2:
        return None
    time = _letter(below[1])
    if (upper.text, lower.text, time.text, lower.order) != ("d", "d", "t", None):
        return None
    if all(scope.knows(part.name) for part in (upper, lower, time)):
        message = SyntaxCode.DERIVATIVE_OR_QUOTIENT()
        raise Fault(SyntaxCode.FOR_THE_DERIVATIVE(message=message), fraction.at)
    is_upright = frame is not None or upper.name != "d"
    return Rate(upper.order, time.order, above[1:], frame, upright=is_upright)


def _partial(
    fraction: Fraction, upper: _Letter, above: tuple[Node, ...], below: tuple[Node, ...], frame: Node | None
) -> Rate:
    """Returns the parts of \\frac{\\partial^k f}{\\partial x^i \\partial y^j}."""
    if frame is not None or _letter(below[0]).text != _PARTIAL or upper.text != _PARTIAL:
        raise Fault(SyntaxCode.EXPECTED_PARTIAL_DERIVATIVE_FRAC(), fraction.at)
    groups: list[list[Node]] = []
    for node in below:
        if _letter(node).text == _PARTIAL:
            groups.append([])
        else:
            groups[-1].append(node)
    if not all(groups):
        raise Fault(SyntaxCode.PARTIAL_DERIVATIVE_NOTHING(), fraction.denominator.at)
    return Rate(
        upper.order, None, above[1:], by=tuple(_split_order(tuple(group)) for group in groups), upright=True
    )


def _split_order(variable: tuple[Node, ...]) -> tuple[tuple[Node, ...], Node | None]:
    """Returns x and 2 for x^2, which is not a power below a ∂."""
    *before, last = variable
    if not isinstance(last, Scripted):
        return variable, None
    inner = core(last.sup)
    if isinstance(inner, Leaf) and inner.kind == "NUMBER":
        bare = replace(last, sup=None)
        unscripted = bare.sub is None and not bare.primes
        return (*before, bare.nucleus if unscripted else bare), inner
    if isinstance(inner, Group) and not inner.parts:
        return (*before, replace(last, sup=None)), None
    return variable, None


def _frame(above: tuple[Node, ...]) -> tuple[Node | None, tuple[Node, ...]]:
    """Returns the frame of {}^A d, and the nodes from d on; a superscript on d is its order."""
    match above:
        case (Scripted(nucleus=Group(parts=()), sub=None, sup=frame, primes=0), d, *rest) if (
            frame is not None and _letter(d).text == "d"
        ):
            return frame, (d, *rest)
    return None, above


def _frame_of_time(scope: Scope, time: Node) -> Node | None:
    """Returns the frame B of \\frac{dx}{dt_B}, if t_B is not a symbol; else None."""
    match time:
        case Scripted(nucleus=Leaf(text="t") as letter, sub=label, sup=None, primes=0, factorial=False):
            name = spell_label(label) if label is not None else None
            is_symbol = scope.table.symbols.get(Name(letter.text, sub=(name or "",))) is not None
            return label if name in scope.table.frames.velocities and not is_symbol else None
    return None


def quotient(scope: Scope, fraction: Fraction) -> Term:
    numerator, denominator = scope.term(fraction.numerator), scope.term(fraction.denominator)
    if isinstance(numerator, Number | Zero) and isinstance(denominator, Number) and _is_numeral(fraction):
        top = numerator.value if isinstance(numerator, Number) else 0
        return construct.number(Rational(top) / denominator.value) if top else construct.zero()
    return divided(scope, (fraction.at, fraction.denominator.at), numerator, denominator)


def divided(scope: Scope, places: tuple[int, int], numerator: Term, denominator: Term) -> Term:
    """Returns the quotient. places: the offsets of the fraction or of the /, and of the divisor."""
    at, below = places
    if isinstance(denominator, Zero):
        raise Fault(SyntaxCode.DIVISION_ZERO(), below)
    return scope.apply(at, "div", numerator, denominator)


def value_of(scope: Scope, head: str, argument: Term) -> Term:
    """Returns the function's value; tan, cot, sec and csc are quotients of sines and cosines, sinh, cosh and
    tanh are composed of exponentials."""
    if head == "tanh":
        return construct.apply("div", *(value_of(scope, x, argument) for x in ("sinh", "cosh")))
    if head in HYPERBOLIC:
        above, below = (construct.apply("exp", x) for x in (argument, construct.apply("neg", argument)))
        below = below if head == "cosh" else construct.apply("neg", below)
        return construct.apply("mul", construct.number(Rational(1, 2)), construct.apply("add", above, below))
    if head in SIGNS_OF:
        return construct.apply("div", argument, construct.apply("norm", argument))
    if head == "exp":
        argument = scope.quaternion_of_four(argument)
        if argument.type.kind == "vector":
            raise Unsupported(TypeCode.EXPONENTIAL_OF_VECTOR())
        if argument.type.kind == "matrix" and not argument.type.is_square:
            raise Unsupported(TypeCode.EXPONENTIAL(type=argument.type))
    if head == "log" and scope.allows(Relaxation.LOGARITHM_AS_COLUMN):
        return _coordinates(construct.apply("log", scope.quaternion_of_four(argument)))
    if head == "re" and argument.type.kind == "quaternion":
        if argument.type.dual:
            raise Unsupported(TypeCode.REAL_PART_OF_DUAL_QUATERNION())
        head = "scalar part"
    if head not in QUOTIENTS:
        return construct.apply(cast(Head, head), argument)
    top, bottom = QUOTIENTS[head]
    numerator = construct.number(1) if top is None else construct.apply(top, argument)
    return construct.apply("div", numerator, construct.apply(bottom, argument))


def _coordinates(logarithm: Term) -> Term:
    """Returns the column of the coordinates of a logarithm. Of a transform, whose order is open, it is 0."""
    if logarithm.type.kind == "matrix":
        return construct.zero(Type(6, 1))
    return construct.apply("vect" if logarithm.type.kind == "tensor" else "vector part", logarithm)


def slope(scope: Scope, at: int, found: Rate, body: Term) -> Term:
    """Returns ∂/∂x of the body, as often as the orders state."""

    def count(order: Node | None) -> int:
        if order is None:
            return 1
        number = scope.integer(order)
        if not number.is_number or int(number) < 1:
            raise Fault(SyntaxCode.PARTIAL_DERIVATIVE_ORDER(number=number), order.at)
        return int(number)

    orders, above = [count(order) for _, order in found.by], count(found.order_above)
    if above != sum(orders):
        raise TypeMismatch(IllFormed(TypeCode.UNEQUAL_ORDERS(above=above, sum=sum(orders))), at)
    for (variable, _), order in zip(reversed(found.by), reversed(orders), strict=True):
        by = scope.term(in_a_row(at, variable))
        for _ in range(order):
            body = scope.partial(at, found.head, body, by)
    return body


def _is_numeral(fraction: Fraction) -> bool:
    """True if both parts are numerals, so that the fraction is a number."""
    top, bottom = core(fraction.numerator), core(fraction.denominator)
    if isinstance(top, Sum) and len(top.addends) == 1:
        top = top.addends[0][2]
    return isinstance(top, Leaf) and isinstance(bottom, Leaf)


def _factors(node: Node) -> tuple[Node, ...]:
    node = core(node)
    return node.items if isinstance(node, Product) else (node,)


class _Letter(NamedTuple):
    """A letter, its name as a symbol (with its font), and its superscript; "" for other nodes."""

    text: str
    name: str
    order: Node | None


def _letter(node: Any) -> _Letter:
    order: Node | None = None
    styles: tuple[str, ...] = ()
    if isinstance(node, Scripted) and node.sub is None and not node.primes and not node.factorial:
        node, order = node.nucleus, node.sup
        if order == Group(getattr(order, "at", 0), ()):
            order = None  # d^{} of macros with an empty order
    if isinstance(node, Styled) and node.style == "\\mathrm":
        node, styles = node.body, (node.style,)
    node = core(node)
    text = node.text if isinstance(node, Leaf) else ""
    return _Letter(text, Name.styled(styles, text).base, order)

"""Application of operators in D to the terms that follow them. An unknown operator or map applied to a term
is a free function, the same one for the same term, once no sum is left that could bind a letter in it."""

from __future__ import annotations

from collections.abc import Sequence

from workbench.core.construct import apply, big_sum, derivative, number, power, symbol, with_children, zero
from workbench.core.integer_instances import free_integers
from workbench.core.names import Name
from workbench.core.terms import (
    Apply,
    BigSum,
    Counting,
    Identity,
    Integer,
    Power,
    Relation,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.core.types import SCALAR, Declaration
from workbench.language.definitions import Definitions
from workbench.language.printing.printer import to_latex


def with_operators_applied(equation: Relation, definitions: Definitions) -> Relation:
    """Returns the equation with D x as the derivative, (P Q) x as P (Q x), (P + Q) x as P x + Q x, and
    defined operators expanded."""
    left, right = (_applied(side, definitions) for side in (equation.left, equation.right))
    return Relation(equation.operator, left, right)


def with_free_values(equation: Relation, definitions: Definitions) -> Relation:
    """Returns the equation with a free function for each unknown P x and f(x), and a free number for each
    integer and C(n, k).

    The equation must have no sums, and its operators must be applied.
    """
    left, right = (_freed(side, definitions) for side in (equation.left, equation.right))
    return Relation(equation.operator, left, right)


def _freed(term: Term, definitions: Definitions) -> Term:
    match term:
        case Apply(head="mul", arguments=(operator, to)) if operator.type.kind == "operator" != to.type.kind:
            name = Name(rf"\left({to_latex(operator)} {to_latex(to)}\right)", of=(operator, to))
            return symbol(Declaration(name, to.type))
        case Integer(value=value) if not value.is_number:
            addends = [apply("mul", number(c), _free_number(n)) for n, c in value.coefficients]
            return apply("add", *addends, number(value.constant))
        case Counting(arguments=arguments) if not all(each.is_number for each in arguments):
            return _free_number(to_latex(term), term)
        case Symbol(arguments=arguments) if arguments and definitions.lookup(term) is None:
            return symbol(Declaration(Name(rf"\left({to_latex(term)}\right)", of=(term,)), term.type))
    return with_children(term, lambda child: _freed(child, definitions))


def _free_number(latex: str, *of: Term) -> Symbol:
    name = Name(rf"\left({latex}\right)", of=("number", *of))
    return symbol(Declaration(name, SCALAR).with_flags(constant=True))


def _applied(term: Term, definitions: Definitions) -> Term:
    term = with_children(term, lambda child: _applied(child, definitions))
    match term:
        case Apply(head="mul", arguments=(operator, to)) if operator.type.kind == "operator":
            if to.type.kind != "operator":
                return _value(operator, to, definitions)
    return term


def _value(operator: Term, to: Term, definitions: Definitions) -> Term:
    if operator.type.kind != "operator":
        return apply("mul", operator, to)
    match operator:
        case TimeOperator():
            return derivative(to, 1)
        case Power(base=TimeOperator(), exponent=order):
            return derivative(to, order)
        case Power(exponent=order) if order.is_number and order.constant == 0:
            return to
        case Power(base=base, exponent=order) if order.constant >= 1:
            return _value(base, _value(power(base, order - 1), to, definitions), definitions)
        case Identity():
            return to
        case Zero():
            return zero(to.type)
        case Apply(head="add", arguments=addends):
            return apply("add", *(_value(addend, to, definitions) for addend in addends))
        case Apply(head="neg", arguments=(inner,)):
            return apply("neg", _value(inner, to, definitions))
        case Apply(head="mul" | "compose", arguments=(left, right)):
            return _value(left, _value(right, to, definitions), definitions)
        case BigSum(variables=bound, lower=lower, upper=upper, body=body) if not _captures(bound, to):
            return big_sum(bound, lower, upper, _value(body, to, definitions))
        case Symbol() if (defined := definitions.lookup(operator)) is not None:
            return _value(_applied(defined, definitions), to, definitions)
    return apply("mul", operator, to)


def _captures(bound: Sequence[str], term: Term) -> bool:
    return not free_integers(term).isdisjoint(bound)

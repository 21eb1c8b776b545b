"""Integrals and limits: the body of each, up to its differential or to the end of the product."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.terms import IllFormed, Symbol, Term, Zero
from workbench.language.elaboration.operators.differentials import is_differential_sign, takes_differential
from workbench.language.grammar.latex_forms import latex_of, scripted
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Chain,
    Fraction,
    Group,
    Integration,
    Leaf,
    Node,
    Product,
    Sum,
    core,
    in_a_row,
)
from workbench.language.naming.patterns import Known
from workbench.language.naming.scope import Scope


def parts_of_integral(items: Sequence[Node]) -> tuple[list[Node], Node, list[Node]] | None:
    """Returns the body, the letter behind the d, and what follows; None without a differential."""
    match items:
        case [Group(parts=(Sum(addends=((sign, at, addend),)),))]:  # the sign of \\int -f dt
            inner = core(addend)
            found = parts_of_integral(inner.items if isinstance(inner, Product) else [inner])
            if found is None:
                return None
            body, letter, rest = found
            signed = Group(at, (Sum(at, ((sign, at, in_a_row(at, body)),)),)) if body else addend
            return [signed], letter, rest
    inside = 0
    for place, (item, behind) in enumerate(pairwise(items)):
        inside += isinstance(item, Integration) and item.sign != "lim"
        if is_differential_sign(item) and takes_differential(behind):
            if not inside:
                return list(items[:place]), behind, list(items[place + 2 :])
            inside -= 1
    return None if inside else _part_with_numerator(items)


def _part_with_numerator(items: Sequence[Node]) -> tuple[list[Node], Node, list[Node]] | None:
    """Returns the parts of \\int \\frac{x dt}{y}, whose differential stands in a numerator."""
    for place, item in enumerate(items):
        fraction = core(item)
        above = core(fraction.numerator) if isinstance(fraction, Fraction) else None
        if not isinstance(fraction, Fraction) or not isinstance(above, Product):
            continue
        below = core(fraction.denominator)
        if isinstance(below, Product) and is_differential_sign(below.items[0]):
            continue  # a derivative
        found = parts_of_integral(above.items)
        if found is not None:
            factors, letter, behind = found
            factors = [*factors, *behind] or [Leaf(fraction.at, "NUMBER", "1")]
            kept = replace(fraction, numerator=in_a_row(fraction.at, factors))
            return [*items[:place], kept], letter, list(items[place + 1 :])
    return None


def integration(
    scope: Scope, head: Integration, items: Sequence[Node], product: Callable[[Scope, Sequence[Node]], Term]
) -> Term:
    """Returns the integral, times what follows its differential; or the limit. Raises Fault."""
    if head.sign == "lim":
        place = core(head.lower)
        if not isinstance(place, Chain) or [sign for sign, _ in place.relations] != ["→"] or not items:
            raise Fault(SyntaxCode.LIMIT_WITHOUT_PLACE(), head.at)
        return _made(scope, head, product(scope, items), "", place.sides[0], place.sides[1])
    if (found := parts_of_integral(items)) is None:
        raise Fault(SyntaxCode.INTEGRAL_WITHOUT_DIFFERENTIAL(), head.at)
    inside, letter, rest = found
    body = product(scope, inside) if inside else construct.number(1)
    term = _made(scope, head, body, f"\\mathrm{{d}}{latex_of(letter)}", letter, head.lower, head.upper)
    return product(scope, (Known(head.at, term), *rest)) if rest else term


def _made(
    scope: Scope, head: Integration, body: Term, measure: str, letter: Node, *bounds: Node | None
) -> Term:
    lower, upper = (None if bound is None else latex_of(bound) for bound in (head.lower, head.upper))
    sign = scripted(f"\\{head.sign}", _unbraced(lower), _unbraced(upper))
    variable, place = latex_of(letter), _place(scope, letter, bounds)
    return scope.build(head.at, construct.integral, sign, measure, variable, body, place)


def _place(scope: Scope, letter: Node, bounds: Sequence[Node | None]) -> tuple[Term, ...]:
    """Returns the variable and the bounds; nothing if one of them is not read."""
    if any(bound is None for bound in bounds):
        return ()
    try:
        values = [scope.term(_outside_of_scripts(bound)) for bound in bounds if bound is not None]
        variable = scope.term(letter)
    except (Fault, TypeMismatch, IllFormed):
        return ()
    are_scalars = all(each.type.kind == "scalar" or isinstance(each, Zero) for each in (variable, *values))
    return (variable, *values) if are_scalars and isinstance(variable, Symbol) else ()


def _outside_of_scripts(bound: Node) -> Node:
    """Returns the bound, read as outside of scripts, where x/2 is a quotient. Raises Fault."""
    match parse(_unbraced(latex_of(bound)) or "").lines:
        case ((side,),) if not isinstance(side, Chain):
            return side
    return bound


def _unbraced(bound: str | None) -> str | None:
    return bound[1:-1] if bound and bound[0] == "{" and bound[-1] == "}" else bound

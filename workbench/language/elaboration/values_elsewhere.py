"""Values of a declared function at other places than its arguments: R(t + h), f(0), T(g h).

Each is a symbol of its own, of the same kind; equal arguments give the same symbol.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.names import Name
from workbench.core.operations import GRADIENTS, PARTIALS
from workbench.core.terms import Apply, Derivative, Integer, Number, Symbol, Term, Zero
from workbench.language.function_places import PLACE, arguments_of_function
from workbench.language.grammar.syntax import Bracket
from workbench.language.naming.scope import Scope
from workbench.language.printing.printer import to_latex


def value_elsewhere(scope: Scope, bracket: Bracket, term: Term) -> Term | None:
    """Returns the value of a function `of` symbols at other values of them; None for every other bracket.

    Raises Fault for a rate at a place whose own rate is not 1: it may be d/dt of the value."""
    function = term.body if isinstance(term, Derivative) else term
    own = arguments_of_function(function) if isinstance(function, Symbol) else ()
    if not isinstance(function, Symbol) or not own or function.arguments:
        return None
    if scope.table.defined.covers(function.declaration.name, function.index):
        return None
    if len(bracket.parts) != len(own) or all(scope.is_time(part) for part in bracket.parts):
        return None
    places = [scope.term(part) for part in bracket.parts]
    both = list(zip(places, own, strict=True))
    if tuple(places) == own or any(place.type.kind != its.type.kind for place, its in both):
        return None
    if not any(_may_be_place(place, its) for place, its in both):
        return None
    value = _value(function, places)
    if function is term:
        return value
    if not _is_shifted_time(own, places):
        raise Fault(SyntaxCode.FUNCTION_AT_ANOTHER_PLACE(), bracket.at)
    assert isinstance(term, Derivative), "else it is the function"
    return scope.build(bracket.at, construct.derivative, value, term.order)


def _may_be_place(place: Term, own: Term) -> bool:
    """True for another value of the argument: it contains the argument, or is one symbol or number."""
    if any(isinstance(part, Apply) and part.head in PARTIALS | GRADIENTS for part in place.walk()):
        return False  # u (∇·v)
    return isinstance(place, Symbol | Number | Integer | Zero) or own in place.walk()


def _is_shifted_time(own: tuple[Term, ...], places: Iterable[Term]) -> bool:
    """True for t + h with a constant h, the only place that moves as the time does."""
    (first, *more), (place, *_) = own, places
    is_time = isinstance(first, Symbol) and first.declaration.clock
    others = [each for each in place.symbols() if each != first]
    addends = place.children if isinstance(place, Apply) and place.head == "add" else ()
    return is_time and not more and first in addends and all(each.declaration.constant for each in others)


def _value(function: Symbol, places: Iterable[Term]) -> Term:
    at = tuple(places)
    shown = f"{to_latex(function)}({', '.join(map(to_latex, at))})"
    declared = function.declaration
    symbols = [each for place in at for each in place.symbols()]
    rests = all(each.declaration.constant for each in symbols)
    name = Name(shown, of=(PLACE, function, *at))
    flags = {"constant": True} if rests else {}
    return construct.symbol(replace(declared, name=name, of=(), indices=0).with_flags(timed=False, **flags))

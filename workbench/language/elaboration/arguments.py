"""What stands in a bracket behind a symbol and says only what it depends on."""

from __future__ import annotations

from workbench.language.declarations import key_spelling
from workbench.language.errors import Fault, SpecError
from workbench.language.scope import Scope
from workbench.language.syntax import Accented, Bracket, Leaf, Node, Scripted, Styled
from workbench.language.terms import Derivative, Symbol, Term, TimeOperator, is_accented_symbol


def is_own_variable(scope: Scope, bracket: Bracket, term: Term) -> bool:
    """Whether the bracket says only what the symbol depends on: x(t), and P(D) for an operator."""
    function = term
    while isinstance(function, Derivative):
        function = function.body
    if isinstance(function, Symbol) and function.declaration.of:
        if all(
            is_argument(scope, part) or scope.term(part) in function.declaration.of for part in bracket.parts
        ):
            return True
        raise Fault("a function at another place than its argument; a product needs no bracket", bracket.at)
    if len(bracket.parts) > 1:
        return all(scope.is_time(part) or is_argument(scope, part) for part in bracket.parts)
    if not bracket.parts:
        return False
    (part,) = bracket.parts
    if term.type.kind == "operator":
        return isinstance(part, Styled) and isinstance(scope.term(part), TimeOperator)
    if is_argument(scope, part):
        return term.type.kind != "scalar" or scope.term(part).type.kind != "scalar"
    if scope.is_time(part):
        return True
    lone = is_accented_symbol(term) and isinstance(part, Leaf | Styled | Accented | Scripted)
    if lone and "scalar" in (term.type.kind, scope.term(part).type.kind):
        raise Fault(
            "a function of what is in the bracket, or a product? a product needs no bracket", bracket.at
        )
    return False


def is_argument(scope: Scope, part: Node) -> bool:
    """Whether the paper says that f(x) is f, which depends on x."""
    if not scope.table.arguments:
        return False
    try:
        spelling = key_spelling(part, "")
    except SpecError:
        return False
    return not scope.table.arguments.isdisjoint({spelling.exact, spelling.declared()[0]})

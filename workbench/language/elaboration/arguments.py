"""Arguments in a bracket after a symbol that only state its dependence. They must be the same at every
occurrence, since f(x) and f(y) are two values."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, SpecError
from workbench.core.names import Name, is_prefix
from workbench.core.operations import CIRCULAR
from workbench.core.reasons import Reason
from workbench.core.terms import Apply, Derivative, Number, Power, Symbol, Term, TimeOperator
from workbench.core.types import Declaration
from workbench.language.accented_symbols import is_accented_symbol
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import Accented, Bracket, Leaf, Node, Product, Scripted, Styled, Sum
from workbench.language.naming.declarations import key_spelling
from workbench.language.naming.reading_conventions import Relaxation
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import Named, Spelling
from workbench.language.printing.printer import to_latex

#: Words for matrices: what stands in the bracket behind them is a factor.
_MATRICES = frozenset(("\\operatorname{Ad}", "\\operatorname{ad}"))


def question_of(own: str, inside: str, line: str | None, may_multiply: bool = True) -> Reason:
    """Returns the question with both readings and the lines of a model that decide between them.

    line: the line that makes `own` a function; None if only another symbol can.   may_multiply: whether
    brackets = 'factors' makes the bracket a factor."""
    one = f"{line} says {own} at {inside}" if line else f"a symbol of its own says {own} at {inside}"
    other = "[conventions] brackets = 'factors'" if may_multiply else "\\cdot"
    return SyntaxCode.AT_OR_TIMES(one=one, other=f"{other} says {own} \\cdot ({inside})")


def question_of_sum(taken: str, at: str) -> Reason:
    """Returns the question on (x + y)(t)."""
    one = f"{at} behind each symbol says {taken} at {at}"
    return SyntaxCode.AT_OR_TIMES(one=one, other=f"\\cdot says {taken} \\cdot {at}")


def line_of_arguments(names: Sequence[str]) -> str:
    """Returns the line of a model that makes a bracket with these names state a dependence only."""
    shown = ", ".join(f"'{name}'" for name in names)
    return f"[conventions] arguments = [{shown}]"


def _both_readings(scope: Scope, function: Term, bracket: Bracket) -> Reason:
    """Returns the question on a bracket after a symbol."""
    line = _line_of_a_function(scope, function, bracket)
    is_one = len(bracket.parts) == 1 or _is_column_of_numbers(scope, bracket, function)
    may_multiply = is_one and all(
        not scope.is_time(part) and _may_multiply(scope, part) for part in bracket.parts
    )
    return question_of(to_latex(function), ", ".join(map(latex_of, bracket.parts)), line, may_multiply)


def _is_column_of_numbers(scope: Scope, bracket: Bracket, factor: Term) -> bool:
    """True for numbers in a bracket behind a scalar."""
    return all(term.type.kind == "scalar" for term in (factor, *map(scope.term, bracket.parts)))


def _line_of_a_function(scope: Scope, function: Term, bracket: Bracket) -> str | None:
    """Returns the line of a model that makes the bracket contain arguments; None if no line can."""
    if all(_is_name(part) and _is_letter(part) for part in bracket.parts):
        return line_of_arguments([latex_of(part) for part in bracket.parts if not scope.is_time(part)])
    values = [scope.term(part) for part in bracket.parts]
    letters = [set(value.symbols()) for value in values]
    is_one = all(len(each) == 1 for each in letters) and len(set(map(frozenset, letters))) == len(letters)
    if not is_one or any(each.declaration.clock or each.index for own in letters for each in own):
        return None
    symbol = next(function.symbols())
    formals = ", ".join(to_latex(*own) for own in letters)
    return f"[definitions] '{to_latex(symbol)}({formals})' = …"


def is_own_variable(scope: Scope, bracket: Bracket, term: Term) -> bool:
    """True if the bracket only states the dependence of the symbol: x(t), and P(D) for an operator."""
    function = term
    while isinstance(function, Derivative):
        function = function.body
    if isinstance(function, Symbol) and function.declaration.of:
        return _has_declared_arguments(scope, bracket, function)
    if _is_matrix_of_words(function) and not any(is_argument(scope, part) for part in bracket.parts):
        return False
    if bracket.parts and _is_tried_as_function(scope, bracket, term):
        return True
    match bracket.parts:
        case ():
            return False
        case (part,):
            return _is_single_variable(scope, bracket, part, term, function)
    only_says = all(scope.is_time(part) or is_argument(scope, part) for part in bracket.parts)
    if only_says:
        _take_place(scope, bracket, term)
    elif _is_column_of_numbers(scope, bracket, term) and all(
        is_said_factor(scope, part) for part in bracket.parts
    ):
        return False
    elif is_accented_symbol(_without_sup(term)) and not _has_tensor(scope, bracket):
        raise Fault(_both_readings(scope, term, bracket), bracket.at)
    return only_says


def _is_matrix_of_words(function: Term) -> bool:
    """True for Ad_g and ad_x, but not for Ad, which may be a function."""
    own = _without_sup(function)
    name = own.declaration.name if isinstance(own, Symbol) else None
    return name is not None and name.base in _MATRICES and any(name.scripts)


def _has_declared_arguments(scope: Scope, bracket: Bracket, function: Symbol) -> bool:
    """Whether a symbol that is declared to be a function has its arguments in the bracket."""
    own = function.declaration.of
    if all(is_argument(scope, part) or scope.term(part) in own for part in bracket.parts):
        _require_all_once(scope, bracket, function)
        return True
    if _is_no_place(scope, bracket, function):
        return False  # u (∇·v)
    raise Fault(SyntaxCode.FUNCTION_AT_ANOTHER_PLACE(), bracket.at)


def _is_single_variable(scope: Scope, bracket: Bracket, part: Node, term: Term, function: Term) -> bool:
    """The same for a bracket with one part; function: the term without its derivatives."""
    if term.type.kind == "operator":
        return isinstance(part, Styled) and isinstance(scope.term(part), TimeOperator)
    if scope.is_time(part):
        _take_instant(scope, bracket, term)
        return True
    if is_argument(scope, part):
        own = _without_sup(function)
        is_product = not isinstance(own, Symbol) or own.declaration.constant
        only_says = not is_product or {term.type.kind, scope.term(part).type.kind} != {"scalar"}
        if only_says:
            _take_place(scope, bracket, term)
        return only_says
    if is_accented_symbol(own := _without_sup(term)):
        is_asked = not _is_coordinate(scope, own) and _may_be_argument(scope, part, term)
        if is_asked and not is_said_factor(scope, part):
            raise Fault(_both_readings(scope, term, bracket), bracket.at)
        if scope.term(part).type.kind == "scalar" and not _is_constant(function):
            _refuse_both(scope, bracket, function, is_factor=True)
    return False


def _is_tried_as_function(scope: Scope, bracket: Bracket, term: Term) -> bool:
    """True if the reader tries the symbol as a function of the bracket. Raises Fault with the question if
    that reading matches."""
    own = _without_sup(term)
    if not is_accented_symbol(own):
        return False
    name = to_latex(own)
    is_asked = scope.asks_about(name)
    if not (scope.tries_as_function(name) or is_asked) or not all(
        _is_name(part) or _is_symbol_or_quaternion(scope.term(part)) for part in bracket.parts
    ):
        return False
    if is_asked:
        raise Fault(_both_readings(scope, term, bracket), bracket.at)
    return True


def _is_symbol_or_quaternion(value: Term) -> bool:
    """True if the term can be a function argument, as in R(p q) and J(-x)."""
    match value:
        case Apply(head="neg" | "inverse" | "transpose", arguments=(inner,)):
            return _is_symbol_or_quaternion(inner)
        case Apply(head="mul", arguments=(Number(), inner)):
            return _is_symbol_or_quaternion(inner)
    return isinstance(value, Symbol) or value.type.kind == "quaternion"


def _is_coordinate(scope: Scope, function: Term) -> bool:
    """True if other symbols depend on it by [conventions], so that it depends on none of them."""
    names = {each.declaration.name for each in function.symbols()}
    return not names.isdisjoint(scope.table.arguments)


def _may_be_argument(scope: Scope, part: Node, function: Term) -> bool:
    """True if the part can be an argument of the function.

    It is a name or a number after a scalar, a scalar after a tensor, a time such as t - t_0, or another value
    of a declared argument of its kind, as k + 1 or \\Delta k.
    """
    value, is_symbol = scope.term(part), is_accented_symbol(function)
    if any(each.clock for each in _outside_of_functions(value)):
        return is_symbol and not _is_constant(function)
    kinds = (function.type.kind, value.type.kind)
    is_difference = isinstance(value, Symbol) and "scalar" in kinds and not _is_name(part)
    names = {each.name for each in _taken(value) if each.type == value.type}
    alike = {name for name in scope.table.arguments if _may_be_of(scope, name, value)}
    if is_difference or names.union(map(_without_prefix, names)) & alike:
        return not _is_constant(function)
    if _is_name(part):
        return "scalar" in kinds or (is_symbol and _are_matrices_of_one_size(function, value))
    is_tensor = function.type.is_square and function.type.kind != "scalar"
    return is_symbol and is_tensor and value.type.kind == "scalar"


def _are_matrices_of_one_size(function: Term, value: Term) -> bool:
    """True if no type distinguishes product and function: A(g) and A(g^{-1}) of two matrices."""
    inverted = value.arguments[0] if isinstance(value, Apply) and value.head == "inverse" else value
    if not isinstance(inverted, Symbol):
        return False
    same = function.type.with_dual(False) == value.type.with_dual(False)
    return same and function.type.is_square and not _is_constant(function)


def is_said_factor(scope: Scope, part: Node) -> bool:
    """True if the paper states that brackets multiply, and this bracket can."""
    return scope.allows(Relaxation.FACTORS_IN_BRACKETS) and _may_multiply(scope, part)


def _outside_of_functions(value: Term) -> Iterator[Declaration]:
    """Yields the symbols of t + h, but none of 1 + cos ω t, which is not an instant."""
    if isinstance(value, Symbol):
        yield value.declaration
    if not (isinstance(value, Apply) and value.head in CIRCULAR | {"exp"}):
        for child in value.children:
            yield from _outside_of_functions(child)


def _taken(value: Term) -> Iterator[Declaration]:
    """Yields the symbols whose value the term contains, and not only a rate."""
    if isinstance(value, Symbol):
        yield value.declaration
    if not isinstance(value, Derivative):
        for child in value.children:
            yield from _taken(child)


def _may_be_of(scope: Scope, argument: Name, value: Term) -> bool:
    declared = scope.table.symbols.get(argument)
    return declared is None or declared.type == value.type


def _without_prefix(name: Name) -> Name:
    """Returns the name without its prefix: t for \\Delta t_k."""
    return Name(name.letter, tuple(style for style in name.styles if not is_prefix(style)))


def _is_constant(function: Term) -> bool:
    """True for a symbol that is a function of nothing: a constant, or the time."""
    own = _without_sup(function)
    return isinstance(own, Symbol) and (own.declaration.constant or own.declaration.clock)


def _is_letter(part: Node) -> bool:
    """True if [conventions] arguments can name it: a letter with accents and scripts, but no number."""
    try:
        key_spelling(part, latex_of(part)).declared()
    except SpecError:
        return False
    return True


def _may_multiply(scope: Scope, part: Node) -> bool:
    """True if brackets = 'factors' makes it a factor; an instant, as (t - t_0), is none."""
    return not any(each.clock for each in _outside_of_functions(scope.term(part)))


def _is_name(part: Node) -> bool:
    return isinstance(part, Leaf | Styled | Accented | Scripted)


def _without_sup(term: Term) -> Term:
    """Returns the base of a superscript: R of R^T and f of f²."""
    is_raised = isinstance(term, Power) or (isinstance(term, Apply) and len(term.children) == 1)
    return term.children[0] if is_raised else term


def _has_tensor(scope: Scope, pair: Bracket) -> bool:
    """True for a row of blocks such as (a, T)."""
    return any(scope.term(part).type.kind == "tensor" for part in pair.parts)


def _is_no_place(scope: Scope, bracket: Bracket, function: Symbol) -> bool:
    """True if the bracket contains a ∇ and has another type than the arguments of the function."""
    (part, *more), places = bracket.parts, {each.type for each in function.declaration.of}
    return not more and "\\nabla" in latex_of(part) and scope.term(part).type not in places


def refuse_member(scope: Scope, bracket: Bracket, term: Term) -> None:
    """Raises Fault for x[2], which may be the second component of x, and x[k + 1], which may be the next
    member."""
    function = _without_sup(term)
    if len(bracket.parts) != 1 or not is_accented_symbol(function) or scope.table.notations.shapes(bracket):
        return
    (part,) = bracket.parts
    parts = [each for _, _, each in part.addends] if isinstance(part, Sum) else [part]
    leaves = [each for each in parts if isinstance(each, Leaf)]
    if len(leaves) < len(parts):
        return
    letters = "".join(sorted(each.text for each in leaves if each.kind == "LETTER"))
    (symbol,) = function.symbols()
    own, place = (symbol.declaration.name, symbol.index), latex_of(part)
    if not letters or scope.members.setdefault((own, letters), place) != place:
        raise Fault(SyntaxCode.COMPONENT_OR_MEMBER_OR(), bracket.at)


def _take_place(scope: Scope, bracket: Bracket, function: Term) -> None:
    """Raises Fault if a symbol has other arguments elsewhere in the formula, or in its definition."""
    _require_once(bracket)
    _take_instant(scope, bracket, function)
    parts = [_without_time(scope, part) for part in bracket.parts if not scope.is_time(part)]
    known = {latex_of(part) for part in parts}
    place = tuple(latex_of(part) for part in parts if not _is_rate_of(part, known))  # (q, \\dot{q}) as (q)
    inside = set().union(*map(_names, parts))
    inside = inside.union(*(scope.table.defined.arguments.get(name, ()) for name in inside))
    for name, index in _symbols(function):
        if scope.places.setdefault((name, index), place) != place:
            raise Fault(SyntaxCode.AT_TWO_PLACES_SAY(name=name), bracket.at)
        if missing := scope.table.defined.arguments.get(name, frozenset()) - inside:
            raise Fault(
                SyntaxCode.DEFINED_TAKEN_AT_ANOTHER(name=name, min=min(map(str, missing))), bracket.at
            )


def _require_once(bracket: Bracket) -> None:
    """Raises Fault for R(x, x): it may be a misprint, or mean R on a diagonal."""
    parts = [latex_of(part) for part in bracket.parts]
    if repeated := next((part for place, part in enumerate(parts) if part in parts[:place]), None):
        raise Fault(SyntaxCode.STANDS_TWICE_AMONG_ARGUMENTS(repeated=repeated), bracket.at)


def _require_all_once(scope: Scope, bracket: Bracket, function: Symbol) -> None:
    """Raises Fault if a function has other arguments than in its declaration."""
    _require_once(bracket)
    written = [scope.term(part) for part in bracket.parts if not scope.is_time(part)]
    missing = [each for each in function.declaration.of if not (each in written or each.declaration.clock)]
    if written and missing and all(each in function.declaration.of for each in written):
        names = ", ".join(str(each.declaration.name) for each in missing)
        own = function.declaration.name
        raise Fault(SyntaxCode.DECLARED_FUNCTION_TOO_THIS(own=own, names=names), bracket.at)


def _is_rate_of(part: Node, known: Collection[str]) -> bool:
    return isinstance(part, Accented) and part.accent != "~" and latex_of(part.body) in known


def _take_instant(scope: Scope, bracket: Bracket, function: Term) -> None:
    """Raises Fault for x(t_0) next to x(t), and for x(t) next to x times a number in a bracket."""
    instants = tuple(latex_of(part) for part in bracket.parts if _is_instant(part))
    for name, index in _symbols(function):
        if instants and scope.instants.setdefault((name, index), instants) != instants:
            raise Fault(SyntaxCode.AT_TWO_INSTANTS_SAY(name=name), bracket.at)
    _refuse_both(scope, bracket, function, is_factor=False)


def _refuse_both(scope: Scope, bracket: Bracket, function: Term, is_factor: bool) -> None:
    """Raises Fault if brackets after a symbol both state its dependence and multiply it."""
    for symbol in _symbols(function):
        places = scope.brackets.setdefault(symbol, {})
        places.setdefault(is_factor, bracket)
        if len(places) > 1:
            factor = places[True]
            raise Fault(_both_readings(scope, function, factor), factor.at)


def _symbols(function: Term) -> list[Named]:
    return [(each.declaration.name, each.index) for each in function.symbols()]


def _is_instant(part: Node) -> bool:
    letter = part.nucleus if isinstance(part, Scripted) else part
    return isinstance(letter, Leaf) and letter.text == "t"


def is_argument(scope: Scope, part: Node) -> bool:
    """True if the paper states that f(x) is f, which depends on x; f(\\dot{x}) is f then, too."""
    known = scope.table.arguments
    return bool(known) and not known.isdisjoint(_names(_without_time(scope, part)))


def _without_time(scope: Scope, part: Node) -> Node:
    """Returns q for q(t)."""
    match part:
        case Product(items=(argument, Bracket(kind="(", parts=(time,)))) if scope.is_time(time):
            return argument
    return part


def _names(part: Node) -> set[Name]:
    spelling = _spelled(part)
    return set() if spelling is None else {spelling.exact, spelling.declared()[0]}


def _spelled(part: Node) -> Spelling | None:
    while isinstance(part, Accented) and part.accent != "~":
        part = part.body
    try:
        return key_spelling(part, "")
    except SpecError:
        return None

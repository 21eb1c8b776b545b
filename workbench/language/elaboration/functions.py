"""Functions and derivatives in a row of factors, and the reach of each."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any, cast

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.integer_expressions import Linear
from workbench.core.operations import CIRCULAR, OF_ANGLES, OF_SCALARS, OF_TENSORS, word_of
from workbench.core.terms import Apply, Derivative, Head, IllFormed, Power, Term
from workbench.language.accented_symbols import is_rate
from workbench.language.elaboration.angles import (
    end_of_angle,
    ends_with_angle,
    goes_on,
    multiplies_an_angle,
    of_angle_between,
)
from workbench.language.elaboration.arguments import is_said_factor
from workbench.language.elaboration.factors import Factor, Row
from workbench.language.elaboration.operators.determinants import of_vectors
from workbench.language.elaboration.operators.differentials import INCREMENT
from workbench.language.elaboration.operators.quotients import Rate, slope, value_of
from workbench.language.elaboration.superscripts import is_inverse, is_transpose, raised, rooted
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Bracket,
    Fraction,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Sum,
    in_a_row,
    is_function,
    is_left_script,
    is_own_word,
)
from workbench.language.grammar.vocabulary import words_in_a_formula
from workbench.language.naming.linear_indices import linear
from workbench.language.naming.patterns import Known
from workbench.language.naming.reading_conventions import Relaxation
from workbench.language.naming.scope import Scope

_OR_A_FACTOR = ', or say [conventions] brackets = "factors": what is in one behind it multiplies it'


def function(row: Row, place: int) -> Factor:
    """Returns the factor of a function. det, sym, vect … take the following run of tensors, others take one
    factor."""
    item = row.items[place]
    leaf = item.nucleus if isinstance(item, Scripted) else item
    assert isinstance(leaf, Leaf), "a function"
    head = leaf.text
    if (own := _of_the_paper(row, item, leaf, place)) is not None:
        return own
    if (
        leaf.bare
        and leaf.name not in row.scope.table.conventions.functions
        and all(row.scope.knows(letter) for letter in leaf.name)
    ):
        message = SyntaxCode.FUNCTION_OF_LETTERS(name=leaf.name)
        raise Fault(SyntaxCode.FUNCTION_OF_THIS(name=leaf.name, message=message), leaf.at)
    if place + 1 == len(row.items):
        raise Fault(SyntaxCode.FUNCTION_OF_NOTHING(word_of=word_of(head)), leaf.at)
    if head in ("quaternion", "atan2"):
        return _of_two(row, leaf, place)
    if head == "root":
        return _root(row, leaf, place)
    if head == "det" and item is leaf and (found := of_vectors(row.scope, row.items[place + 1])):
        return Factor(found, leaf.at, place + 2, item)
    behind = row.items[place + 1]
    if item is leaf and (found := of_angle_between(row.scope, head, behind)) is not None:
        return Factor(found, leaf.at, place + 2, item)
    if item is leaf and isinstance(behind, Scripted) and _is_inverse_or_transpose(head, behind):
        inner = row.scope.term(behind.nucleus)
        if inner.type.is_square and inner.type.kind != "scalar":
            term = row.scope.build(leaf.at, value_of, row.scope, head, inner)
            assert behind.sup is not None, "an inverse or a transpose"
            return Factor(raised(row.scope, term, behind.sup), leaf.at, place + 2, item)
    if item is leaf and isinstance(behind, Scripted) and _is_power_of_value(row, head, behind):
        item, argument, end = replace(behind, nucleus=leaf), row.scope.term(behind.nucleus), place + 2
    else:
        argument, end = _argument(row, head, leaf, place + 1)
    if head == "skew" and argument.type.kind == "tensor":
        head = "antisymmetric"
    term = row.scope.build(leaf.at, value_of, row.scope, head, argument)
    if isinstance(item, Scripted):
        exponent = None if item.sup is None else linear(item.sup, row.scope.variables)
        if item.sub is not None or item.primes or item.factorial or exponent is None:
            raise Fault(SyntaxCode.ONLY_POWER_MAY_STAND(word_of=word_of(head)), item.at)
        if exponent.is_number and exponent.constant < 0:
            raise Fault(SyntaxCode.INVERSE_FUNCTION_OR_INVERSE(), item.at)
        term = row.scope.build(item.at, construct.power, term, exponent)
    return Factor(term, leaf.at, end, item)


def _is_power_of_value(row: Row, head: str, behind: Node) -> bool:
    """True for \\sin(x)^2 if the paper states that it is (\\sin x)^2."""
    is_power = isinstance(behind, Scripted) and isinstance(behind.nucleus, Bracket) and behind.sup is not None
    return is_power and head in OF_ANGLES and row.scope.allows(Relaxation.POWERS_OF_VALUES)


def _is_inverse_or_transpose(head: str, behind: Scripted) -> bool:
    """True for \\exp(A)^{-1}, the inverse of the exponential, and \\exp(A)^T, which is that of A^T, too."""
    is_plain = isinstance(behind.nucleus, Bracket) and behind.sub is None and not behind.primes
    return head == "exp" and is_plain and (is_transpose(behind.sup) or is_inverse(behind.sup))


def _of_the_paper(row: Row, item: Any, leaf: Leaf, place: int) -> Factor | None:
    """Returns \\operatorname{Exp}(x) and \\mathrm{Ad}_T by [notation], else None. A superscript applies to
    the value."""
    sup = item.sup if isinstance(item, Scripted) else None
    bare = leaf if item is leaf else replace(item, sup=None)
    if bare != leaf and bare.sub is None and not bare.primes:
        bare = leaf
    behind = row.items[place + 1 : place + 2]
    tried: list[tuple[Node, int]] = [(bare, place + 1)]
    above = None
    if behind and isinstance(bracket := behind[0], Scripted) and _is_transposed(bracket):
        above, behind = bracket.sup, [bracket.nucleus]  # \\mathrm{ad}(u)^T
    if behind and isinstance(behind[0], Bracket):
        tried.insert(0, (Product(leaf.at, (bare, behind[0])), place + 2))
    for node, end in tried:
        if (term := row.scope.spelt(node)) is not None:
            if above is not None and end == place + 2:
                term = raised(row.scope, term, above)
            _refuse_transposed_map(term, sup)
            return Factor(term if sup is None else raised(row.scope, term, sup), leaf.at, end, item)
    if behind and (found := _applied_in_a_row(row, bare, place)) is not None:
        return found if sup is None else replace(found, term=raised(row.scope, found.term, sup))
    if is_own_word(leaf):
        raise Fault(words_in_a_formula(f"\\operatorname{{{leaf.name}}}"), leaf.at)
    return None


def _refuse_transposed_map(value: Term, sup: Node | None) -> None:
    """Raises Fault for \\mathrm{Ad}_g^T(x) of a column: it may be the transposed map at x, which no value
    determines."""
    if sup is not None and is_transpose(sup) and value.type.columns == 1:
        raise Fault("the transpose of the map, or of its value? bracket the value", sup.at)


def _is_transposed(bracket: Scripted) -> bool:
    return is_transpose(bracket.sup) and bracket.sub is None and not bracket.primes


def _applied_in_a_row(row: Row, word: Node, place: int) -> Factor | None:
    """Returns \\mathrm{Ad}_g x at the end of a row, if the paper explains \\mathrm{Ad}_g(x); else None."""
    node = Product(word.at, (word, Bracket(word.at, "(", (Leaf(word.at, "LETTER", "x"),))))
    if (
        isinstance(row.items[place + 1], Bracket)
        or isinstance(word, Leaf)
        or not row.scope.table.notations.shapes(node)
    ):
        return None
    argument = row.factor(place + 1)
    if argument.end < len(row.items):
        return None
    bracket = Bracket(argument.at, "(", (Known(argument.at, argument.term),))
    term = row.scope.spelt(Product(word.at, (word, bracket)))
    return None if term is None else Factor(term, word.at, argument.end, row.items[place])


def _root(row: Row, leaf: Leaf, place: int) -> Factor:
    item: Any = row.items[place + 1]
    power: Node | None = None
    if isinstance(item, Scripted) and item == Scripted(item.at, item.nucleus, sup=item.sup):  # (√x)²
        item, power = item.nucleus, item.sup
    is_bare = isinstance(item, Leaf) and item.kind in ("NUMBER", "LETTER") and len(item.text.strip("\\")) == 1
    is_root = isinstance(item, Group) or is_bare  # \\sqrt2
    if not is_root or row.items[place] is not leaf:
        raise Fault(SyntaxCode.EXPECTED_SQUARE_ROOT_SQRT(), leaf.at)
    term = row.scope.term(item)
    if term.type.kind == "quaternion":
        if not _is_norm_squared(term):
            raise Fault(SyntaxCode.ROOT_QUATERNION_NO_NUMBER(), leaf.at)
        term = construct.apply("scalar part", term)
    root = rooted(row.scope, leaf.at, term)
    return Factor(root if power is None else raised(row.scope, root, power), leaf.at, place + 2, leaf)


def _is_norm_squared(term: Term) -> bool:
    """True for q q^* or q^* q, which is a number."""
    match term:
        case Apply(head="mul", arguments=(one, Apply(head="conjugate", arguments=(other,)))):
            return one == other
        case Apply(head="mul", arguments=(Apply(head="conjugate", arguments=(one,)), other)):
            return one == other
    return False


def _of_two(row: Row, leaf: Leaf, place: int) -> Factor:
    """Returns quat(s, x), with a scalar and a vector part, or atan2(y, x)."""
    item = row.items[place + 1]
    if not (isinstance(item, Bracket) and len(item.parts) == 2) or row.items[place] is not leaf:
        what = {"atan2": "two scalars, \\operatorname{atan2}(y, x)"}.get(
            leaf.text, "a scalar and a vector, \\operatorname{quat}(s, x)"
        )
        raise Fault(SyntaxCode.EXPECTED_WHAT(what=what), leaf.at)
    parts = [row.scope.term(part) for part in item.parts]
    return Factor(row.scope.apply(leaf.at, cast(Head, leaf.text), *parts), leaf.at, place + 2, leaf)


def _argument(row: Row, head: str, leaf: Leaf, place: int) -> tuple[Term, int]:
    item = row.items[place]
    if isinstance(item, Bracket):
        known = row.scope.reaches.known if head in CIRCULAR else ()
        if (last := end_of_angle(row.items, place, known)) is not None:
            return row.multiply([row.factor(each) for each in range(place, last)]), last
        _refuse_angle_behind(row, head, item, place)
        return row.scope.term(item), place + 1
    if isinstance(item, Scripted) and isinstance(item.nucleus, Bracket | Fraction):
        raise Fault(SyntaxCode.POWER_FUNCTION_OR_ARGUMENT(), item.at)
    first = row.factor(place)
    run, end = [first], first.end
    name = word_of(head)
    row.open_head = head
    if head in OF_TENSORS:
        while end < len(row.items) and first.term.type.kind == "tensor":
            following = row.factor(end)
            if following.term.type.kind != "tensor":
                break
            run.append(following)
            end = following.end
        if first.term.type.kind == "scalar" and end < len(row.items):
            raise Fault(SyntaxCode.HOW_FAR_DOES_REACH(name=name), leaf.at)
        return row.multiply(run), end
    of_numbers = head in OF_SCALARS
    while of_numbers and end < len(row.items) and multiplies_an_angle(run[-1].term, len(run) == 1):
        if _is_bracket(row.items[end]) or is_function(row.items[end]):
            break
        run.append(row.factor(end))
        end = run[-1].end
    if head in CIRCULAR and end < len(row.items) and not _is_bracket(row.items[end]):
        behind = row.factor(end)
        if goes_on(row.multiply(run), behind.term):
            run, end = [*run, behind], behind.end
    may_be_factor = end < len(row.items) and of_numbers and _is_bracket(row.items[end])
    if end < len(row.items) and not (may_be_factor and is_said_factor(row.scope, row.items[end])):
        following = row.factor(end)
        own = isinstance(following.node, Leaf | Scripted) and is_function(following.node)
        mixes = head not in OF_ANGLES or following.term.type.kind == "scalar"
        goes_beside = head in CIRCULAR and len(run) == 1 and ends_with_angle(run[0].term, following.term)
        if (
            mixes
            and not own
            and not goes_beside
            and not (head in OF_ANGLES and _is_rate_beside(following.term, run))
        ):
            said = _OR_A_FACTOR if may_be_factor else ""
            raise Fault(SyntaxCode.REACH_OF_FUNCTION(name=name, said=said), leaf.at)
    if head in CIRCULAR and len(run) == 2:
        row.scope.reaches.angles.add(frozenset(_letters(factor.node) for factor in run))
        _refuse_reach(row.scope)
    return row.multiply(run), end


def _refuse_angle_behind(row: Row, head: str, bracket: Bracket, place: int) -> None:
    """Notes \\cos (m - n) x; raises Fault if the formula has \\cos m x, too: the angle may contain x."""
    behind = row.items[place + 1] if place + 1 < len(row.items) else None
    match bracket.parts:
        case (Sum(addends=addends),) if head in CIRCULAR and isinstance(behind, Leaf | Scripted):
            for _, _, addend in addends:
                own = frozenset((_letters(addend), _letters(behind)))
                row.scope.reaches.behind.setdefault(own, (word_of(head), bracket.at))
            _refuse_reach(row.scope)


def _refuse_reach(scope: Scope) -> None:
    for pair in scope.reaches.angles & scope.reaches.behind.keys():
        name, at = scope.reaches.behind[pair]
        raise Fault(SyntaxCode.HOW_FAR_DOES_REACH(name=name), at)


def _letters(node: Node) -> str:
    return latex_of(node).replace(" ", "")


def _is_bracket(node: Node) -> bool:
    return isinstance(node.nucleus if isinstance(node, Scripted) else node, Bracket)


def _is_rate_beside(term: Term, angle: Sequence[Factor]) -> bool:
    """True for a rate, or a power of one, after an angle that is not a rate: \\sin\\theta \\dot{\\theta}, and
    for a differential."""
    if INCREMENT in (term, *term.children):
        return True
    rate = term.base if isinstance(term, Power) else term
    return isinstance(rate, Derivative) and not any(
        isinstance(part, Derivative) for factor in angle for part in factor.term.walk()
    )


def derivative(row: Row, place: int, found: Rate) -> Factor:
    scope, item = row.scope, row.items[place]
    if found.by:
        return _differentiated(row, place, found, lambda body: slope(scope, item.at, found, body))
    orders = [
        scope.integer(o) if o is not None else Linear(1) for o in (found.order_above, found.order_below)
    ]
    if orders[0] != orders[1]:
        intent = "one order above and below, \\frac{d^k}{dt^k}"
        fault = IllFormed(TypeCode.UNEQUAL_TIME_ORDERS(orders=orders[0], orders_2=orders[1]), intent)
        raise TypeMismatch(fault, item.at)
    if place + 1 == len(row.items) and not found.behind:
        if found.frame is not None:
            raise Fault(SyntaxCode.DERIVATIVE_FRAME_WHAT(), item.at)
        operator: Term = construct.time_operator()
        if orders[0] != Linear(1):
            operator = construct.power(operator, orders[0])
        return Factor(operator, item.at, place + 1, item)
    return _differentiated(row, place, found, lambda body: scope.rate(item.at, body, orders[0], found.frame))


def _differentiated(row: Row, place: int, found: Rate, rate: Callable[[Term], Term]) -> Factor:
    """Returns the derivative of everything after the upper d, or else of the factors after the fraction; a
    bracket is one factor."""
    scope, item = row.scope, row.items[place]
    if found.behind:
        body = scope.term(in_a_row(item.at, found.behind))
        lone = len(found.behind) == (2 if is_left_script(found.behind[0]) else 1) or (
            isinstance(found.behind[-1], Bracket) and is_rate(body)
        )
        if not lone and (not found.upright or isinstance(found.behind[0], Bracket)):
            raise Fault(SyntaxCode.REACH_OF_D_DT(), item.at)
        return Factor(rate(body), item.at, place + 1, item)
    if place + 1 == len(row.items):
        raise Fault(SyntaxCode.PARTIAL_DERIVATIVE_WHAT(), item.at)
    following = row.items[place + 1]
    nucleus = following.nucleus if isinstance(following, Scripted) else None
    if isinstance(nucleus, Bracket) and nucleus.kind in ("(", "[", "\\{"):
        raise Fault(SyntaxCode.POWER_DERIVATIVE_OR_ARGUMENT(), following.at)
    run = [row.factor(place + 1)]
    if not isinstance(following, Bracket):
        row.open_head = "d/dt"
        while run[-1].end < len(row.items) and not scope.allows(Relaxation.RATE_OF_NEXT_FACTOR):
            run.append(row.factor(run[-1].end))
    return Factor(rate(row.multiply(run)), item.at, run[-1].end, item)

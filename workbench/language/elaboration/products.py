"""Rows: factors, functions with their arguments, d/dt, and the signs · × ⊗ ∘ between them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import zip_longest
from typing import Any

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.operations import CIRCULAR, GRADIENTS, OF_TENSORS, word_of
from workbench.core.terms import Apply, Term
from workbench.core.types import VECTOR
from workbench.language.elaboration.arguments import (
    is_argument,
    is_own_variable,
    question_of_sum,
    refuse_member,
)
from workbench.language.elaboration.factors import Factor, Row
from workbench.language.elaboration.functions import derivative, function
from workbench.language.elaboration.infixes import explained, infix
from workbench.language.elaboration.letters import letter
from workbench.language.elaboration.operators.derivatives_of_maps import (
    derivative_of_map,
    ends_map_derivative,
    without_brackets,
)
from workbench.language.elaboration.operators.differentials import differential
from workbench.language.elaboration.operators.evaluations import is_evaluated, value_at, with_brackets
from workbench.language.elaboration.operators.integrals import integration
from workbench.language.elaboration.operators.nablas import along, as_del, of_field, with_sign
from workbench.language.elaboration.operators.quotients import divided, quotient, rate
from workbench.language.elaboration.operators.summations import summation
from workbench.language.elaboration.spelled import spelled_out
from workbench.language.elaboration.superscripts import raised
from workbench.language.elaboration.values_elsewhere import value_elsewhere
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Fraction,
    Group,
    Infix,
    Integration,
    Leaf,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    Summation,
    as_letter,
    core,
    in_a_row,
    is_function,
    is_left_script,
    is_numeral,
)
from workbench.language.naming.patterns import Known
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import Scripts, spell_label

_DIFFERENTIATE = GRADIENTS | {"d/dt", "∇", "the operator"}


def product(scope: Scope, items: Sequence[Node]) -> Term:
    """Returns the term of factors and infix signs. Juxtaposition binds tighter than signs; \\sum extends to
    the end."""
    rows: list[list[Node]] = [[]]
    signs: list[Infix] = []
    items = without_brackets(with_brackets(scope, spelled_out(scope, items)))
    for place, item in enumerate(items):
        if isinstance(item, Infix):
            if (sign := with_sign(rows, signs, item)) is not None:
                rows[-1][-1] = sign
                continue
            if item.operator == "·" and ends_map_derivative(scope, rows[-1]):
                continue
            if not rows[-1]:
                raise Fault(SyntaxCode.NOTHING_BEFORE(operator=item.operator), item.at)
            signs.append(item)
            rows.append([])
        elif isinstance(item, Summation):
            rows[-1].append(Product(item.at, tuple(items[place:])))
            break
        else:
            rows[-1].append(item)
    if not rows[-1]:
        *before, last = rows[-2]
        if before and is_left_script(before[-1]):
            left = before.pop()
            last = Group(left.at, (Product(left.at, (left, last)),))
        rows = [*rows[:-2], [*before, _with_sign_behind(scope, last, signs.pop())]]
    if any(sign.operator == "/" for sign in signs):
        return _solidus(scope, rows, signs)
    return _joined(scope, [_row(scope, row) for row in rows], signs)


def _with_sign_behind(scope: Scope, item: Node, sign: Infix) -> Node:
    """Returns x \\times without a right operand, as the paper defines it. Raises Fault."""
    node = Product(item.at, (item, sign))
    if scope.spelt(node) is None:
        raise Fault(SyntaxCode.NOTHING_AFTER(operator=sign.operator), sign.at)
    return node


def _joined(scope: Scope, rows: Sequence[Row], signs: list[Infix]) -> Term:
    if (of_dyad := _of_dyad(scope, rows, signs)) is not None:
        return of_dyad
    operands = [row.term() for row in rows]
    for row, sign, operand in zip(rows, signs, operands[1:], strict=False):
        _refuse_reach(row, sign, operand)
    while signs and _is_vect_of_product(rows[0].items, operands, signs[0]):
        inside = scope.apply(signs[0].at, "mul", *operands[0].children, operands.pop(1))
        operands[0] = scope.apply(signs.pop(0).at, "vect", inside)
    return infix(scope, operands, signs)


def _of_dyad(scope: Scope, rows: Sequence[Row], signs: Sequence[Infix]) -> Term | None:
    """Returns a b · c of three vectors as a (b · c), which is the dyad a b applied to c, too; and a · b c.
    Else None."""
    if [sign.operator for sign in signs] != ["·"] or scope.table.has_quaternions:
        return None
    (above, below), at = [row.factors() for row in rows], signs[0].at
    kinds = [[factor.term.type.kind for factor in factors] for factors in (above, below)]
    vectors = [[kind for kind in each if kind != "scalar"] for each in kinds]
    _refuse_reach(rows[0], signs[0], below[0].term)
    if vectors == [["vector"] * 2, ["vector"]] and kinds[0][-2:] == ["vector"] * 2:
        inner = scope.apply(at, "dot", above[-1].term, rows[1].term())
        return scope.apply(at, "mul", rows[0].multiply(above[:-1]), inner)
    if vectors == [["vector"], ["vector"] * 2] and kinds[1][:2] == ["vector"] * 2:
        inner = scope.apply(at, "dot", rows[0].term(), below[0].term)
        return scope.apply(at, "mul", inner, rows[1].multiply(below[1:]))
    return None


def _solidus(scope: Scope, rows: Sequence[Sequence[Node]], signs: Sequence[Infix]) -> Term:
    """Returns a b/c at the end of a row: the result does not depend on which factor is divided."""
    *others, solidus = signs
    if solidus.operator != "/" or any(sign.operator == "/" for sign in others):
        raise Fault(SyntaxCode.WHAT_DIVIDED_WHAT_WRITE(), solidus.at)
    *above, below = rows
    if not others:
        fraction = Fraction(above[0][0].at, in_a_row(above[0][0].at, above[0]), in_a_row(below[0].at, below))
        numerals = all(isinstance(part, Leaf) and is_numeral(part) for part in (*above[0], *below))
        if numerals or rate(scope, fraction) is not None:
            return _row(scope, [fraction]).term()
    if is_numeral(below[0]) and len(below) > 1 and is_function(below[1]):
        half = Product(above[0][0].at, (*(_with_signs(above, others)), solidus, below[0]))
        return product(scope, (Group(half.at, (half,)), *below[1:]))  # w/2 \\tan x
    dividend, divisor = [_row(scope, row) for row in above], _row(scope, below)
    numerator, denominator = _joined(scope, dividend, others), divisor.term()
    is_one = divisor.factor(0).end == len(below) and (len(below) < 3 or not divisor.open_head)
    heads = {dividend[-1].open_head, divisor.open_head}  # \\sin\\phi/\\cos\\theta is a quotient of values
    if (dividend[-1].open_head and not heads <= CIRCULAR) or not is_one:
        raise Fault(SyntaxCode.REACH_OF_SLASH(), solidus.at)
    if (own := explained(scope, solidus, numerator, denominator)) is not None:
        return own
    return divided(scope, (solidus.at, below[0].at), numerator, denominator)


def _with_signs(rows: Sequence[Sequence[Node]], signs: Sequence[Infix]) -> Iterator[Node]:
    """Yields the rows with the signs between them."""
    for row, sign in zip_longest(rows, signs):
        yield from row
        if sign is not None:
            yield sign


def _refuse_reach(row: Row, sign: Infix, operand: Term) -> None:
    """Raises TypeMismatch for d/dt a × b, curl a × b, det A · B: the head may apply to a × b unless a is
    bracketed."""
    head = row.open_head
    takes_tensors = head in OF_TENSORS - {"vect"} and sign.operator == "·" and operand.type.kind == "tensor"
    takes_parts = head in ("re", "du") and operand.type.dual
    takes_factor = head == "gradient" and operand.type.kind == "scalar"  # ∇f · v is not ∇(f v)
    if takes_tensors or takes_parts or takes_factor or head in _DIFFERENTIATE:
        raise Fault(SyntaxCode.HOW_FAR_DOES_REACH(name=word_of(head)), row.items[0].at)


def _is_vect_of_product(row: Sequence[Node], operands: Sequence[Term], sign: Infix) -> bool:
    """True if vect A · B means vect (A · B): with a tensor B it has no other meaning."""
    unbracketed = isinstance(row[0], Leaf) and row[0].text == "vect" and not isinstance(row[1], Bracket)
    is_vect = isinstance(operands[0], Apply) and operands[0].head == "vect"
    return unbracketed and is_vect and sign.operator == "·" and operands[1].type.kind == "tensor"


def _row(scope: Scope, items: Sequence[Node]) -> Row:
    return Row(scope, items, _factor)


def _factor(row: Row, place: int) -> Factor:
    item = row.items[place]
    if (term := row.scope.written(item)) is not None:
        return Factor(term, item.at, place + 1, item)
    if (sign := as_del(item)) is not None:
        return of_field(row, place, sign)
    if (directed := along(item)) is not None:
        return of_field(row, place, directed[1], directed[0])
    if (found := derivative_of_map(row, place) or differential(row, place)) is not None:
        return found
    if is_evaluated(item):
        return Factor(value_at(row.scope, item), item.at, place + 1, item)
    match item:
        case Product(items=(_, Infix())) if (spelt := row.scope.spelt(item)) is not None:
            return Factor(spelt, item.at, place + 1, item)
        case Product(items=(Summation() as head, *rest)):
            return Factor(_under_a_sign(row.scope, head, rest), item.at, place + 1, item)
        case Summation():
            raise Fault(SyntaxCode.SUM_HAS_NO_BODY(), item.at)
        case Leaf(kind="FUNCTION") | Scripted(nucleus=Leaf(kind="FUNCTION")):
            named = _as_name(row.scope, item)
            return function(row, place) if named is None else _name(row, place, named, Scripts())
        case Fraction():
            if (slope := rate(row.scope, item)) is not None:
                return derivative(row, place, slope)
            return Factor(quotient(row.scope, item), item.at, place + 1, item)
        case Bracket(kind="(", parts=(part,)) if place and _is_place(row.scope, row.items[place - 1], part):
            raise Fault(question_of_sum(latex_of(row.items[place - 1]), latex_of(part)), item.at)
        case Scripted(nucleus=Group(parts=())):
            return _with_left_scripts(row, place)
        case Leaf(kind="LETTER") | Styled() | Accented() | Scripted():
            return _name(row, place, item, Scripts())
    return Factor(row.scope.term(item), item.at, place + 1, item)


def _is_place(scope: Scope, value: Node, part: Node) -> bool:
    """True if the node before (t) or (q) may be evaluated there: (x + y)(t), but not 2(t)."""
    if scope.is_time(part):
        return not is_numeral(value)
    return isinstance(value, Bracket) and is_argument(scope, part)


def _as_name(scope: Scope, item: Node) -> Node | None:
    """Returns Ad_T as a name if that is a symbol, else None."""
    nucleus = item.nucleus if isinstance(item, Scripted) else item
    letter = as_letter(nucleus)
    if letter is nucleus or not isinstance(letter, Leaf) or not scope.table.has_letter(letter.text):
        return None
    return replace(item, nucleus=letter) if isinstance(item, Scripted) else letter


def _under_a_sign(scope: Scope, head: Summation, rest: Sequence[Node]) -> Term:
    """Returns the sum, the integral or the limit of what stands behind its sign."""
    if isinstance(head, Integration):
        return integration(scope, head, rest, product)
    return summation(scope, head, lambda: _body(scope, head, rest))


def _body(scope: Scope, head: Summation, rest: Sequence[Node]) -> Term:
    if not rest:
        raise Fault(SyntaxCode.SUM_HAS_NO_BODY(), head.at)
    return product(scope, rest)


def _with_left_scripts(row: Row, place: int) -> Factor:
    left: Any = row.items[place]
    following = core(row.items[place + 1]) if place + 1 < len(row.items) else None
    if isinstance(following, Fraction) and left.sup is not None and left.sub is None:
        found = rate(row.scope, following)
        if found is not None and found.frame is None:
            return derivative(row, place + 1, found._replace(frame=left.sup))
    if isinstance(following, Matrix) and left.sup is not None and left.sub is None:
        return Factor(_in_frame(row.scope, left.sup, following), left.at, place + 2, following)
    if not isinstance(following, Leaf | Styled | Accented | Scripted):
        raise Fault(SyntaxCode.LEFT_SCRIPTS_MUST_STAND(), left.at)
    return _name(row, place + 1, following, Scripts(left.sub, left.sup))


def _in_frame(scope: Scope, label: Node, column: Matrix) -> Term:
    """{}^B [1; 2; 3], the vector with these components in B."""
    term, turn = scope.term(column), scope.table.frames.orientations.get(spell_label(label) or "")
    if turn is None or term.type != VECTOR:
        raise Fault(SyntaxCode.COMPONENTS_FRAME_OR_VECTOR(), label.at)
    return construct.apply("mul", turn, term)


def _name(row: Row, place: int, item: Node, scripts: Scripts) -> Factor:
    """Returns a symbol; a function symbol with its arguments. x(t) is x, P(D) is P."""
    scope = row.scope
    following = row.items[place + 1] if place + 1 < len(row.items) else None
    bracket = core(following.nucleus if isinstance(following, Scripted) else following)
    behind = bracket
    if not (isinstance(bracket, Bracket) and bracket.kind == "("):
        bracket = None
    plain = not scripts.left_sub and not scripts.left_sup
    if plain and following is not None:
        if (term := _called_function(row, place, item)) is not None:
            return Factor(term, item.at, place + 3, item)
        if (called := _called(scope, item, following)) is not None:
            return Factor(called, item.at, place + 2, item)
    if plain and (value := scope.integer_expression(item)) is not None:
        return Factor(value, item.at, place + 1, item)
    term, sup, takes_bracket = letter(scope, item, scripts, bracket)
    if isinstance(behind, Bracket) and behind.kind == "[":
        refuse_member(scope, behind, term)
    end = place + 1
    is_labelled = isinstance(following, Scripted) and following.sub is not None  # R (x)_B
    may_say = bracket is not None and not is_labelled
    if not takes_bracket and bracket is not None and not is_labelled:
        if (elsewhere := value_elsewhere(scope, bracket, term)) is not None:
            term, takes_bracket, may_say = elsewhere, True, False
        else:
            takes_bracket = is_own_variable(scope, bracket, term)
    if following is not None and takes_bracket:
        if isinstance(following, Scripted) and sup is not None:
            raise Fault(SyntaxCode.SCRIPTS_ARGUMENT_FUNCTION_BRACKET(), following.at)
        term = _behind(scope, term, following)
        end += 1
        if following is bracket and may_say and _is_taken_then(row, end, term):
            end += 1  # x(q)(t)
    if sup is not None:
        term = raised(scope, term, sup)
    return Factor(term, item.at, end, item)


def _is_taken_then(row: Row, place: int, term: Term) -> bool:
    """True if a second bracket contains the time at which the function of the first is evaluated: x(q)(t)."""
    following = row.items[place] if place < len(row.items) else None
    if not (isinstance(following, Bracket) and following.kind == "(" and len(following.parts) == 1):
        return False
    return row.scope.is_time(following.parts[0]) and is_own_variable(row.scope, following, term)


def _called_function(row: Row, place: int, item: Node) -> Term | None:
    """Returns \\mathrm{d} A(g), as the paper defines it for A; None if the bracket is not an argument of
    A."""
    scope, (argument, *more) = row.scope, row.items[place + 1 : place + 3]
    is_name = isinstance(core(argument), Leaf | Styled | Accented | Scripted)
    bracket = core(more[0].nucleus if isinstance(more[0], Scripted) else more[0]) if more else None
    if not (is_name and isinstance(bracket, Bracket) and bracket.kind == "("):
        return None
    if not scope.table.notations.shapes(Product(item.at, (item, core(argument)))):
        return None
    factor = row.factor(place + 1)
    if factor.end != place + 3:
        return None
    return scope.spelt(Product(item.at, (item, Known(factor.at, factor.term))))


def _called(scope: Scope, item: Node, argument: Node) -> Term | None:
    """Returns S(x) and c \\theta, as the paper defines them; else None."""
    inner = argument.nucleus if isinstance(argument, Scripted) else argument
    bare = inner if isinstance(core(inner), Bracket) else argument
    plain = core(bare)
    if isinstance(plain, Leaf) and plain.kind != "LETTER":
        return None
    value = scope.spelt(Product(item.at, (item, plain)))
    if value is None and isinstance(item, Scripted) and (above := _sup_alone(item)) is not None:
        own = scope.spelt(Product(item.at, (item.nucleus, core(bare))))
        return own if own is None else _raised_function(scope, own, above, argument)
    if value is not None and isinstance(bare, Scripted) and bare.sup is not None:
        raise Fault(SyntaxCode.POWER_FUNCTION_OR_ARGUMENT(), bare.at)
    return value if value is None or bare is argument else _behind(scope, value, argument)


def _sup_alone(item: Scripted) -> Node | None:
    return item.sup if item.sub is None and not (item.primes or item.factorial) else None


def _raised_function(scope: Scope, value: Term, above: Node, argument: Node) -> Term:
    """Returns S^T(x), the transpose of S(x), and c^2 x, the square of c x. Raises Fault for f^{-1}(x), which
    may be the inverse function."""
    if isinstance(argument, Scripted) and isinstance(core(argument.nucleus), Bracket):
        raise Fault(SyntaxCode.SCRIPTS_ARGUMENT_FUNCTION_BRACKET(), argument.at)
    if value.type.kind == "scalar" and isinstance(core(above), Sum):
        raise Fault(SyntaxCode.INVERSE_FUNCTION_OR_RECIPROCAL(), above.at)
    return raised(scope, value, above)


def _behind(scope: Scope, value: Term, argument: Node) -> Term:
    """Returns R(\\theta)^T, the transpose of the value, and similar superscripts after the argument."""
    if not isinstance(argument, Scripted):
        return value
    if argument.sup is None or argument.sub is not None or argument.primes or argument.factorial:
        raise Fault(SyntaxCode.SCRIPTS_ARGUMENT_FUNCTION_BRACKET(), argument.at)
    return raised(scope, value, argument.sup)

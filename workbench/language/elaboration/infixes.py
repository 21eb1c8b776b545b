"""The infix signs · × ⊗ ∘ between rows, and those that a paper explains."""

from __future__ import annotations

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.operations import FUNCTIONS, OF_TENSORS, SIGNS
from workbench.core.shapes import scalar_and_vector
from workbench.core.terms import Apply, Head, Integer, Number, Power, Term
from workbench.language.grammar.syntax import Infix
from workbench.language.grammar.vocabulary import MODULO, OWN_SIGNS
from workbench.language.naming.reading_conventions import Relaxation
from workbench.language.naming.scope import Scope

_AMBIGUOUS = "several products without brackets are ambiguous"


def infix(scope: Scope, operands: list[Term], signs: list[Infix]) -> Term:
    """Returns a · b, a × b, a ⊗ b, P ∘ Q from left to right, if no other order has a meaning.

    ω × ω × r is ω × (ω × r), since ω × ω is 0.
    """
    if _turns_often(scope, operands, signs):
        return construct.apply("cross", operands[0], infix(scope, operands[1:], signs[1:]))
    if _is_triple(scope, operands, signs):
        turned = scope.apply(signs[0].at, "cross", *operands[:2])
        return scope.apply(signs[1].at, "dot", turned, operands[2])
    result = operands[0]
    heads = set()
    for sign, operand in zip(signs, operands[1:], strict=True):
        own = explained(scope, sign, result, operand)
        if own is None and sign.operator == MODULO:
            raise Fault(SyntaxCode.MODULUS(), sign.at)
        if own is None and sign.operator in OWN_SIGNS:
            what = f"{sign.operator} of a {result.type} and a {operand.type}"
            raise Fault(SyntaxCode.SIGN_OF_THE_TEXT(what=what, OWN_SIGNS=OWN_SIGNS[sign.operator]), sign.at)
        if own is not None:
            result = own
            if result.type.kind != "quaternion" and not _is_matrix_product(own):
                heads.add("cross")
            if "cross" in heads and len([o for o in operands if o.type.kind != "scalar"]) > 2:
                raise Fault(_AMBIGUOUS, signs[-1].at)
            continue
        if sign.operator in "∘⊗" and scope.table.has_quaternions:
            result, operand = (_from_column(scope, sign.at, each) for each in (result, operand))
        head = SIGNS[sign.operator]
        if head == "dot" and not (result.type.is_column and operand.type.is_column):
            head = "mul"
        head = _beside_quaternion(sign, result, operand) or head
        heads.add(head)
        factors = [o for o in operands if o.type.kind != "scalar"]
        is_row = scope.allows(Relaxation.DYADS) and all(o.type.kind == "tensor" for o in factors[1:-1])
        if heads & ({"cross", "outer"} if is_row else {"dot", "cross", "outer"}) and len(factors) > 2:
            raise Fault(_AMBIGUOUS, signs[-1].at)
        result = _of_tensors(scope, sign.at, head, result, operand)
    return result


def _is_matrix_product(term: Term) -> bool:
    """True if brackets change nothing in a row of such products."""
    if not isinstance(term, Apply) or term.head != "mul":
        return False
    return all(factor.type.is_square for factor in term.arguments)


def _turns_often(scope: Scope, operands: list[Term], signs: list[Infix]) -> bool:
    """True for × between vectors only, if all but the last are equal up to numeric factors, or if the paper
    reads them from the right."""
    if len(operands) < 3 or {sign.operator for sign in signs} != {"×"}:
        return False
    first, last = operands[0], operands[-1]
    if first.type.kind != "vector" or last.type.kind != "vector":
        return False
    if not scope.allows(Relaxation.CROSS_FROM_RIGHT) and len({*map(_moved, operands[:-1])}) > 1:
        return False
    return explained(scope, signs[0], first, last) is None


def _is_triple(scope: Scope, operands: list[Term], signs: list[Infix]) -> bool:
    """True for a × b · c of three vectors, which has one meaning: × cannot act on a number."""
    if [sign.operator for sign in signs] != ["×", "·"] or {o.type.kind for o in operands} != {"vector"}:
        return False
    return all(explained(scope, sign, *operands[:2]) is None for sign in signs)


def _moved(term: Term) -> Term:
    """Returns the vector without scalar factors before it."""
    if isinstance(term, Apply) and term.head == "mul" and term.arguments[0].type.kind == "scalar":
        return _moved(term.arguments[1])
    return term


def _of_tensors(scope: Scope, at: int, head: Head, left: Term, right: Term) -> Term:
    """Returns a sign between a vector and a tensor: a × T acts on each column; in a paper with dyads, T × a
    acts on each row, and a · T is Tᵀ a."""
    kinds = (left.type.kind, right.type.kind)
    has_dyads = scope.allows(Relaxation.DYADS)
    if head == "cross" and kinds == ("vector", "tensor"):
        return scope.apply(at, "mul", construct.apply("skew", left), right)
    if head == "cross" and kinds == ("tensor", "vector") and has_dyads:
        return scope.apply(at, "mul", left, construct.apply("skew", right))
    if head == "mul" and kinds == ("vector", "tensor") and has_dyads:
        return scope.apply(at, "mul", construct.apply("transpose", right), left)
    if head == "cross" and set(kinds) == {"scalar"} and (_is_number(left) or _is_number(right)):
        return scope.apply(at, "mul", left, right)
    if head == "cross" and set(kinds) == {"scalar"}:
        raise Fault(SyntaxCode.TWO_NUMBERS_IF_THEIR(), at)
    if head == "cross" and "quaternion" in kinds:
        raise Fault(SyntaxCode.QUATERNIONS_THEIR_PRODUCT_OR(), at)
    if (
        head == "cross"
        and scope.allows(Relaxation.CROSS_OF_LAST_FACTOR)
        and (last := _last(left)) is not None
    ):
        return scope.apply(at, "dot", last, scope.apply(at, "cross", last, right))
    if head == "outer" and scope.allows(Relaxation.OWN_SIGN) and set(kinds) == {"vector"}:
        is_pure = scope.table.has_quaternions
        return scope.apply(at, "mul", *map(construct.as_quaternion, (left, right))) if is_pure else left
    if head == "cross" and "vector" not in kinds:
        raise Fault(SyntaxCode.CROSS_OF(type=left.type, type_2=right.type), at)
    if head == "compose" and not {"operator", "tensor"} & set(kinds):
        raise Fault(SyntaxCode.COMPOSITION_OF(type=left.type, type_2=right.type), at)
    if head == "outer" and _is_kronecker(set(kinds)) and not scope.table.has_quaternions:
        head = "kronecker"
    if head == "outer" and (left.type.is_square or right.type.is_square) and "scalar" not in kinds:
        raise Fault(SyntaxCode.DYAD_OF(type=left.type, type_2=right.type), at)
    return scope.apply(at, head, left, right)


def _is_number(term: Term) -> bool:
    """True for a number and for a value of a function such as cos: no vector that is declared wrongly."""
    match term:
        case Number() | Integer():
            return True
        case Power() | Apply(head="neg" | "mul" | "div" | "add"):
            return all(map(_is_number, term.children))
    return isinstance(term, Apply) and term.head in FUNCTIONS.values() and term.head not in OF_TENSORS


def _is_kronecker(kinds: set[str]) -> bool:
    """True for ⊗ between matrices, or between a matrix and a row: a tensor and a vector may have order 3."""
    return kinds <= {"tensor", "matrix", "covector"} and kinds != {"covector"}


def _last(product: Term) -> Term | None:
    """Returns the b of the number c aᵀ b, else None."""
    if not isinstance(product, Apply) or product.type.kind != "scalar":
        return None
    last = product.arguments[-1]
    return last if last.type.kind == "vector" else _last(last)


def explained(scope: Scope, sign: Infix, left: Term, right: Term) -> Term | None:
    """Returns a ∧ b, or p · q of quaternions, as the paper's [notation] explains it; else None."""
    for entry in scope.table.notations.signs(sign.operator):
        assert entry.sign is not None, "of a sign"
        terms = dict(zip(entry.sign[1:], (left, right), strict=True))
        if entry.fits(terms):
            return scope.term(entry.filled(terms))
    return None


def _from_column(scope: Scope, at: int, term: Term) -> Term:
    """Returns the quaternion of a column of four, (s; x); other terms unchanged."""
    parts = scalar_and_vector(term) if (term.type.rows, term.type.columns) == (4, 1) else None
    return term if parts is None else scope.apply(at, "quaternion", *parts)


def _beside_quaternion(sign: Infix, left: Term, right: Term) -> Head | None:
    """Returns the head of a product of quaternions written ⊗ or ∘, else None. A dot is ambiguous: it may be
    the product of columns of four."""
    kinds = [left.type.kind, right.type.kind]
    if "quaternion" not in kinds or "scalar" in kinds:
        return None
    if sign.operator == "·":
        raise Fault(SyntaxCode.PRODUCT_QUATERNIONS_OR_SCALAR(), sign.at)
    return "mul" if sign.operator in "⊗∘" else None

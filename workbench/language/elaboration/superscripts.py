"""Superscripts: transpose, inverse, power, order of derivatives, and marks of the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction as Rational

from workbench.core import construct, integer_instances
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Apply, Derivative, Number, Symbol, Term
from workbench.core.types import SCALAR
from workbench.language.elaboration.meanings import EXPONENTIALS
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Fraction,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
)
from workbench.language.naming.linear_indices import LARGEST_INTEGER, linear
from workbench.language.naming.notations import Notation
from workbench.language.naming.scope import Scope
from workbench.language.naming.symbols import may_be_label


def refuse_other_order(term: Term, nucleus: Node, sup: Node) -> None:
    """Raises Fault for \\dot{T}^{-1}: the inverse of the derivative or the derivative of the inverse.

    For the conjugate of a quaternion both are the same.
    """
    inner = core(sup)
    inverts = isinstance(inner, Sum) and [sign for sign, _, _ in inner.addends] == ["-"]
    differs = inverts or (term.type.kind != "quaternion" and isinstance(inner, Leaf) and inner.text == "*")
    if differs and _is_dotted(nucleus):
        what = "inverse" if inverts else "adjugate"
        message = SyntaxCode.ORDER_OF_DERIVATIVE(what=what)
        raise Fault(SyntaxCode.REACH_OF_DOT(message=message), sup.at)


def _is_dotted(node: Node) -> bool:
    match node:
        case Accented(accent=accent, body=body):
            return accent != "~" or _is_dotted(body)
        case Styled(body=body) | Scripted(nucleus=body) | Group(parts=(body,)):
            return _is_dotted(body)
    return False


def refuse_label(term: Term, sup: Node) -> None:
    inner = core(sup)
    while isinstance(term, Derivative):
        term = term.body
    if not isinstance(inner, Leaf) or inner.kind != "NUMBER" or not inner.text.isdigit():
        return
    if isinstance(term, Symbol) and may_be_label(term, int(inner.text)):
        raise Fault(SyntaxCode.POWER_OR_LABEL_FRAME(text=inner.text), sup.at)


def is_transpose(sup: Node | None) -> bool:
    """True for the T of A^T or A^{\\mathrm{T}}."""
    inner = core(sup)
    if isinstance(inner, Styled) and inner.style in ("\\mathrm", "\\mathsf"):
        inner = core(inner.body)
    return isinstance(inner, Leaf) and inner.text == "T"


def is_inverse(sup: Node | None) -> bool:
    """True for the −1 of A^{-1}."""
    inner = core(sup)
    return isinstance(inner, Sum) and [(s, getattr(a, "text", "")) for s, _, a in inner.addends] == [
        ("-", "1")
    ]


def with_quotients(node: Node) -> Node:
    """Returns the exponent of e with / as a quotient, not as part of a label."""
    match node:
        case Group(parts=parts) | Bracket(parts=parts):
            return replace(node, parts=tuple(map(with_quotients, parts)))
        case Sum(addends=addends):
            return replace(node, addends=tuple((s, at, with_quotients(each)) for s, at, each in addends))
        case Product(items=items):
            return replace(node, items=tuple(map(with_quotients, items)))
        case Leaf(kind="MARK", text="/"):
            return Infix(node.at, "/")
    return node


def _halves(node: Node | None) -> int | None:
    """Returns k of x^{k/2} with an odd k; None for other superscripts."""
    match core(node):
        case Sum(addends=(("-", _, inner),)):
            found = _halves(inner)
            return None if found is None else -found
        case Fraction(numerator=above, denominator=below):
            parts = core(above), core(below)
        case Product(items=(above, Leaf(kind="MARK", text="/"), below)):
            parts = above, below
        case _:
            return None
    texts = [part.text for part in parts if isinstance(part, Leaf)]
    return int(texts[0]) if texts in (["1", "2"], ["3", "2"], ["5", "2"]) else None


def _power_of_scalars(scope: Scope, term: Term, sup: Node) -> Term | None:
    """Returns x^y of two scalars, where y is no integer; None for other superscripts, and for labels."""
    if term.type.kind != "scalar" or term.type.dual or _may_be_label(term, sup):
        return None
    try:
        exponent = scope.term(with_quotients(sup))
    except Fault:
        return None
    if isinstance(exponent, Number) and exponent.value.denominator <= 2:
        return _power_of_root(scope, sup.at, term, exponent.value)
    if exponent.type != SCALAR or (_is_exponential(term) and not isinstance(exponent, Number)):
        return None
    return scope.apply(sup.at, "pow", term, exponent)


def _power_of_root(scope: Scope, at: int, term: Term, exponent: Rational) -> Term | None:
    """Returns x^{k/2}; None for 02 and 2/1, which are labels, and for what is too large."""
    if exponent.denominator == 1 or abs(exponent.numerator) > LARGEST_INTEGER:
        return None
    return scope.build(at, integer_instances.raised, rooted(scope, at, term), Linear(exponent.numerator))


def _may_be_label(term: Term, sup: Node) -> bool:
    """True for x^{[n]}, and for x^{t+1}, which is x at a time or a power."""
    inner = core(sup)
    if isinstance(inner, Bracket) and inner.kind in ("[", "\\{"):
        return True
    instant = linear(inner, ("t",))
    at_time = instant is not None and (instant - Linear.variable("t")).is_number
    return at_time and isinstance(term, Symbol | Derivative)


def _is_exponential(term: Term) -> bool:
    """True for a symbol e: e^x is its power or the exponential."""
    return isinstance(term, Symbol) and term.declaration.name in EXPONENTIALS


def notated(scope: Scope, at: int, entries: Sequence[Notation], term: Term, spelled: str) -> Term:
    """Returns the entry that fits the term, applied to it. Raises Fault."""
    for entry in entries:
        (letter_of,) = entry.formals
        if entry.fits({letter_of: term}):
            return scope.term(entry.filled({letter_of: term}))
    known = ", ".join(kind for entry in entries for kind in entry.formals.values())
    raise Fault(SyntaxCode.OPERATION_OF_NOTATION(spelled=spelled, type=term.type, known=known), at)


def rooted(scope: Scope, at: int, term: Term) -> Term:
    """Returns the root; for a quotient the quotient of the roots, which are real where the judges take
    roots."""
    match term:
        case Apply(head="div", arguments=(above, below)):
            return scope.apply(at, "div", rooted(scope, at, above), rooted(scope, at, below))
    return scope.apply(at, "root", term)


def raised(scope: Scope, term: Term, sup: Node) -> Term:
    """Returns term^sup: transpose, adjugate, inverse, derivative of an order, or power."""
    if own := [e for e in scope.table.notations.marks(sup) if str(term.type) in e.formals.values()]:
        return notated(scope, sup.at, own, term, "the superscript")
    inner = core(sup)
    if inner == Leaf(inner.at, "MARK", "*"):
        term = scope.build(sup.at, scope.quaternion_of_four, term)
    match inner:
        case Leaf(kind="LETTER", text="T") if "T" in scope.variables:
            raise Fault(SyntaxCode.TRANSPOSE_OR_POWER_WITH(), sup.at)
        case _ if is_transpose(inner):
            return scope.apply(sup.at, "transpose", term)
        case Sum(addends=(("-", _, below),)) if is_transpose(below):
            return raised(scope, scope.apply(sup.at, "inverse", term), below)
        case Leaf(kind="MARK", text="*") if term.type.kind not in ("tensor", "quaternion"):
            raise Fault(SyntaxCode.STAR_OF(type=term.type), sup.at)
        case Leaf(kind="MARK", text="*"):
            return scope.apply(sup.at, "adjugate", term)
        case Bracket(kind="(", parts=(order,)):
            return scope.rate(sup.at, term, scope.integer(order), None)
    if (halves := _halves(inner)) is not None:
        root = rooted(scope, sup.at, term)
        return scope.build(sup.at, integer_instances.raised, root, Linear(halves))
    exponent = linear(inner, scope.variables)
    if exponent is None and (found := _power_of_scalars(scope, term, sup)) is not None:
        return found
    if exponent is None:
        known = "an integer, -1, T, -T, *, or an order in round brackets"
        raise Fault(
            SyntaxCode.EXPECTED_SUPERSCRIPT(known=known, known_variables=scope.known_variables()), sup.at
        )
    if exponent in (Linear(0), Linear(1)) and term.type.is_column:
        raise Fault(SyntaxCode.POWER_OR_LABEL_SYMBOL(exponent=exponent), sup.at)
    is_odd = exponent.is_number and exponent.constant % 2 and exponent.constant != 1
    if is_odd and term.type.kind == "vector" and scope.table.has_quaternions:
        raise Fault(SyntaxCode.ODD_POWER_VECTOR_QUATERNION(), sup.at)
    if exponent.is_number and exponent.constant < 0:
        term = scope.build(sup.at, scope.quaternion_of_four, term)
        base = term if exponent.constant == -1 else scope.build(sup.at, construct.power, term, -exponent)
        return scope.apply(sup.at, "inverse", base)
    return scope.build(sup.at, construct.power, term, exponent)

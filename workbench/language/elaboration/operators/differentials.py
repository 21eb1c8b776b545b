"""Differentials: d x and \\mathrm{d} x are \\dot{x} \\mathrm{d}t, along any motion.

An equation whose addends all hold one differential is one of rates: d(x y) = x dy + y dx is the product rule.
An italic d that is no symbol is a differential only in such an equation.
"""

from __future__ import annotations

from collections.abc import Sequence

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.operations import LINEAR, PRODUCTS
from workbench.core.terms import Apply, Block, Number, Power, Symbol, Term, Zero
from workbench.core.types import SCALAR, Declaration
from workbench.language.elaboration.factors import Factor, Row
from workbench.language.elaboration.superscripts import is_transpose
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    core,
    unstyled,
)
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import Scripts, spell

#: dt, an increment of the time.
INCREMENT = construct.symbol(Declaration(Name("\\mathrm{d}t"), SCALAR, Linear(-1)).with_flags(constant=True))


def is_differential_sign(node: Node) -> bool:
    """True for d and \\mathrm{d} without scripts."""
    styles, letter = unstyled(node)
    return styles in ((), ("\\mathrm",)) and isinstance(letter, Leaf) and letter.text == "d"


def takes_differential(node: Node) -> bool:
    """True if a d may stand before the node: a letter with its scripts and accents, or a bracket."""
    inner = node.nucleus if isinstance(node, Scripted) else core(node)
    if isinstance(inner, Bracket):
        return inner.kind in ("(", "[")
    return isinstance(inner, Styled | Accented) or (isinstance(inner, Leaf) and inner.kind == "LETTER")


def differential(row: Row, place: int) -> Factor | None:
    """Returns d x, the differential of the next factor; None if the item is not the sign of one. Raises
    Fault."""
    scope, item = row.scope, row.items[place]
    if not is_differential_sign(item) or place + 1 == len(row.items):
        return None
    behind = row.items[place + 1]
    if not takes_differential(behind) or _is_known(scope, item, behind):
        return None
    if unstyled(item)[0] == ():
        scope.italic_differentials.append(item.at)
    if scope.is_time(unstyled(behind)[1]):
        return Factor(INCREMENT, item.at, place + 2, item)
    if isinstance(behind, Scripted) and isinstance(behind.nucleus, Bracket) and not is_transpose(behind.sup):
        raise Fault(SyntaxCode.POWER_DERIVATIVE_OR_ARGUMENT(), behind.at)
    factor = row.factor(place + 1)
    is_power = isinstance(factor.term, Power) or (
        isinstance(factor.term, Apply) and factor.term.head == "inverse"
    )
    if is_power and not isinstance(core(behind), Bracket):
        raise Fault(SyntaxCode.POWER_DERIVATIVE_OR_ARGUMENT(), behind.at)
    rate = scope.rate(item.at, factor.term, Linear(1), None)
    return Factor(scope.apply(item.at, "mul", INCREMENT, rate), item.at, factor.end, item)


def _is_known(scope: Scope, item: Node, behind: Node) -> bool:
    """True if the letter d is a symbol, or if the paper's notation explains it before this node."""
    styles, _ = unstyled(item)
    spelling = spell(Name.styled(styles, "d"), Scripts(), ())
    is_symbol = spelling is not None and scope.table.find(spelling) is not None
    return is_symbol or bool(scope.table.notations.shapes(Product(item.at, (item, core(behind)))))


def as_rates(scope: Scope, terms: Sequence[Term]) -> list[Term]:
    """Returns the sides of an equation of differentials as rates; others unchanged.

    Raises Fault for an italic d in a formula that is not homogeneous in differentials: it is an unknown
    symbol.
    """
    degrees = frozenset().union(*map(_degrees, terms))
    if len(degrees) == 1 and degrees != {0}:
        scope.italic_differentials.clear()
        return [_without_increment(term) for term in terms]
    refuse_italic(scope)
    return list(terms)


def refuse_italic(scope: Scope) -> None:
    """Raises Fault for an italic d that was read as the sign of a differential: it is an unknown symbol."""
    if scope.italic_differentials:
        spelling = spell(Name("d"), Scripts(), ())
        assert spelling is not None, "a letter"
        raise Fault(scope.table.unknown(spelling), scope.italic_differentials[0])


def _degrees(term: Term) -> frozenset[int]:
    """Returns the degrees of the addends of a term in dt; {0, 1} where dt stands under a function."""
    match term:
        case Zero():
            return frozenset()
        case Symbol() if term == INCREMENT:
            return frozenset({1})
        case Apply(head="add") | Block():
            return frozenset().union(*map(_degrees, term.children))
        case Apply(head=head, arguments=(one, other)) if head in (*PRODUCTS, "compose", "div"):
            sign = -1 if head == "div" else 1
            return frozenset(i + sign * j for i in _degrees(one) for j in _degrees(other))
        case Apply(head=head, arguments=(one,)) if head in LINEAR:
            return _degrees(one)
        case Power() if term.exponent.is_number and term.base.type.kind == "scalar":
            return frozenset(int(term.exponent) * i for i in _degrees(term.base))
    return frozenset({0, 1} if INCREMENT in term.walk() else {0})


def _without_increment(term: Term) -> Term:
    """Returns the term with 1 for dt."""
    if term == INCREMENT:
        return construct.number(1)
    children = [_without_increment(child) for child in term.children]
    if children == list(term.children):
        return term
    match term:
        case Apply(head="mul", arguments=(left, right)) if left == INCREMENT or right == INCREMENT:
            return children[left == INCREMENT]
        case Apply(head="div") if isinstance(children[1], Number) and children[1].value == 1:
            return children[0]
    return construct.rebuild(term, children)

"""Facts from stated inequalities, chains of them, and intervals: x > 0, 0 < θ < π, θ ∈ (0, π)."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from fractions import Fraction
from functools import partial

from workbench.context.claims import Notation
from workbench.context.facts import Bound, Duration, Fact, Origin, Provider
from workbench.context.formula_subject import names_of
from workbench.context.free_symbols import terms_of
from workbench.context.property_statements import having
from workbench.context.unread_facts import is_turned
from workbench.core.brackets import outside
from workbench.core.construct import apply, number, relation, symbol, zero
from workbench.core.names import Name
from workbench.core.terms import Apply, IllFormed, Number, Relation, Statement, Symbol, Term, Zero, sides_of
from workbench.core.types import SCALAR, Declaration
from workbench.core.verdict import Strength
from workbench.language.definitions import expand
from workbench.language.printing.printer import to_latex
from workbench.source.documents import Token
from workbench.source.rows.display_vocabulary import ORDERS, UNEQUAL

_RELATIONS = ORDERS.keys() | UNEQUAL | {"=", ":=", "\\in"}
_OPENING, _CLOSING = ("(", "[", "{", "\\{"), (")", "]", "}", "\\}")
_SIZES = ("\\left", "\\right", "\\,", "\\;", "~", " ")
_TURNED = str.maketrans("<>≤≥", "><≥≤")
#: The greatest denominator of the fraction that stands for a multiple of π.
_DIGITS = 10**9
#: Rounding errors of the bounds of an angle.
_CLOSE = 1e-9


def links_of(tokens: Sequence[Token]) -> Iterator[list[Token]]:
    """Yields the relations of a chain: a < x and x < b of a < x < b, and the two bounds of x ∈ (a, b).

    Yields the tokens as they are if they hold no inequality and no interval.
    """
    texts = [token.text for token in tokens]
    signs = [at for at in outside(texts, _OPENING, _CLOSING) if texts[at] in _RELATIONS]
    ends = [*signs[1:], len(tokens)][: len(signs)]
    intervals = {at: _interval(tokens[at + 1 : end]) for at, end in zip(signs, ends, strict=True)}
    is_interval = any(texts[at] == "\\in" and intervals[at] for at in signs)
    if not is_interval and not (len(signs) > 1 and any(texts[at] in ORDERS for at in signs)):
        yield list(tokens)
        return
    first = 0
    for at, end in zip(signs, ends, strict=True):
        left, right = list(tokens[first:at]), list(tokens[at + 1 : end])
        if texts[at] == "\\in":
            for sign, bound in intervals[at] or ():
                yield [*left, tokens[at].standing_for(sign), *bound]
        else:
            yield [*left, tokens[at], *right]
        first = first if texts[at] == "=" else at + 1


def _interval(tokens: Sequence[Token]) -> list[tuple[str, list[Token]]]:
    """Returns the signs and bounds of (a, b), [a, b) and the like; none for other sets."""
    own = [token for token in tokens if token.text not in _SIZES]
    while own and own[-1].text in (",", "."):
        own.pop()
    if len(own) < 5 or own[0].text not in "([" or own[-1].text not in ")]":
        return []
    texts = [token.text for token in own[1:-1]]
    commas = [at for at in outside(texts, _OPENING, _CLOSING) if texts[at] == ","]
    if len(commas) != 1:
        return []
    lower, upper = own[1 : 1 + commas[0]], own[2 + commas[0] : -1]
    signs = ("\\gt" if own[0].text == "(" else "\\ge", "\\lt" if own[-1].text == ")" else "\\le")
    bounds = zip(signs, (lower, upper), strict=True)
    return [(sign, bound) for sign, bound in bounds if bound and not _is_infinite(bound)]


def _is_infinite(bound: Sequence[Token]) -> bool:
    return any(token.text == "\\infty" for token in bound)


def bounds_of(
    latex: str, line: int, said: Relation, order: str | None, pi: Declaration | None = None
) -> Iterator[Fact]:
    """Yields the facts of a bound such as x > 0: x ≠ 0, x is positive, and a bound for counterexamples.

    A bound for another term than a symbol is an assumption a ≥ b as well.

    order: the sign of the inequality; None for an equation.   pi: the declaration of π.
    """
    about = names_of({part.declaration for part in terms_of(said) if isinstance(part, Symbol)})
    about -= {pi.name} if pi is not None else set()
    origin = Origin(Provider.CONDITION, latex, f"line {line}")
    fact = partial(Fact, about=about, origin=origin, strength=Strength.STATED, duration=Duration.INSTANT)
    if order is None or not about:
        yield from [fact(said)] if about else []
        return
    left, right = said.left, said.right
    if order in "<>" and pi is None:
        is_of_zero = isinstance(right, Zero)
        bound = Bound(to_latex(left), "≠", Fraction(0)) if is_of_zero and _has_value(left) else None
        yield fact(Relation("≠", left, right), bound=bound)
    if isinstance(left, Apply) and left.head == "norm" and isinstance(right, Zero) and order in ">≥":
        return
    is_turned_round = isinstance(right, Symbol) and not isinstance(left, Symbol) and right.declaration != pi
    if _number(left, pi) is not None or is_turned_round:
        left, right, order = right, left, order.translate(_TURNED)
    value = _number(right, pi)
    if isinstance(left, Apply) and left.head == "norm" and value is not None and order in "<≤":
        inner = left.arguments[0]
        if inner.type == SCALAR:  # |x| < a is −a < x < a
            lower = Relation(said.operator, inner, apply("neg", right))
            yield from bounds_of(latex, line, Relation(said.operator, inner, right), order, pi)
            yield from bounds_of(latex, line, lower, order.translate(_TURNED), pi)
            return
    if left.type != SCALAR or (pi is not None and value is None):
        yield Fact(None, about, origin, Strength.STATED)
        return
    if _has_value(left) and value is not None:
        yield fact(None, bound=Bound(to_latex(left), order, value))
    is_positive = value is not None and ((order == ">" and value >= 0) or (order == "≥" and value > 0))
    if isinstance(left, Symbol) and is_positive:
        yield from [] if left.declaration.positive else [fact(having("positive", [left]))]
    else:
        end = right if pi is None or value is None else number(value.limit_denominator(_DIGITS))
        yield fact(_assumed(left, end, order))


def with_signs_of_functions(facts: Sequence[Fact], statement: Statement, notation: Notation) -> list[Fact]:
    """Returns the facts with the signs of the sine and cosine of an angle between stated bounds.

    They replace the bounds, and nothing replaces those of a full turn, where the statement contains the angle
    in such functions only.
    """
    limits: dict[Name, list[Fact]] = {}
    for fact in facts:
        if fact.bound is not None and len(fact.about) == 1:
            limits.setdefault(next(iter(fact.about)), []).append(fact)
    found = list(facts)
    stated = [fact for fact in facts if fact.origin.provider is Provider.CONDITION]
    for name, own in limits.items():
        declaration = notation.symbols.symbols.get(name)
        if declaration is None or declaration.type != SCALAR or name.indices:
            continue
        angle, (lower, upper) = symbol(declaration), _ends(own)
        signs = list(_signs_of_functions(own[0], angle, lower, upper))
        is_full_turn = math.isfinite(upper - lower) and upper - lower >= 2 * math.pi - _CLOSE
        if (signs or is_full_turn) and is_turned(angle, _expanded(statement, notation)):
            found = [each for each in found if each.about != {name} or each not in stated]
        found += signs
    return found


def _expanded(statement: Statement, notation: Notation) -> list[Term]:
    with suppress(IllFormed):
        return [expand(side, notation.definitions) for side in sides_of(statement)]
    return list(sides_of(statement))


def _ends(bounds: Sequence[Fact]) -> tuple[float, float]:
    """Returns the greatest lower bound and the least upper bound."""
    ends = [(fact.bound.sign, float(fact.bound.number)) for fact in bounds if fact.bound is not None]
    lower = max((end for sign, end in ends if sign in ">≥"), default=-math.inf)
    return lower, min((end for sign, end in ends if sign in "<≤"), default=math.inf)


def _signs_of_functions(bound: Fact, angle: Symbol, lower: float, upper: float) -> Iterator[Fact]:
    for value, least, most in (
        (apply("sin", angle), 0.0, math.pi),
        (apply("cos", angle), -math.pi / 2, math.pi / 2),
    ):
        if least - _CLOSE <= lower and upper <= most + _CLOSE:
            yield replace(bound, content=_assumed(value, zero(SCALAR), ">"), bound=None)


def _has_value(term: Term) -> bool:
    """True if a counterexample gives the value of the term: a symbol, or the sine or cosine of one."""
    is_turn = isinstance(term, Apply) and term.head in ("sin", "cos")
    return isinstance(term, Symbol) or (is_turn and isinstance(term.children[0], Symbol))


def _number(term: Term, pi: Declaration | None) -> Fraction | None:
    """Returns the value of a number, or of a multiple of π to 15 digits; None for other terms."""
    match term:
        case Zero():
            return Fraction(0)
        case Number(value=value):
            return Fraction(value)
        case Symbol(declaration=declaration) if declaration == pi:
            return Fraction(math.pi)
        case Apply(head="neg", arguments=(inner,)):
            inside = _number(inner, pi)
            return None if inside is None else -inside
        case Apply(head="mul" | "div" as head, arguments=(one, other)):
            left, right = _number(one, pi), _number(other, pi)
            if left is None or not right:
                return None
            return left * right if head == "mul" else left / right
    return None


def _assumed(left: Term, right: Term, order: str) -> Relation:
    return relation("≥", *((left, right) if order in ">≥" else (right, left)))

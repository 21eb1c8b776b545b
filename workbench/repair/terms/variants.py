"""Variants of a term after one change at its top, by the term's kind."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from functools import partial
from itertools import combinations

from workbench.core.construct import (
    apply,
    big_sum,
    block,
    counting,
    derivative,
    integer,
    number,
    power,
    symbol,
    zero,
)
from workbench.core.integer_expressions import Linear
from workbench.core.operations import OPERATORS, PRODUCTS
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Counting,
    Derivative,
    Head,
    Identity,
    Integer,
    Number,
    Power,
    Statement,
    Symbol,
    Term,
    Zero,
)
from workbench.core.types import SCALAR, Weight
from workbench.language.printing.printer import to_latex
from workbench.repair.terms.moved_operands import moved_operands
from workbench.repair.terms.subterm_positions import places
from workbench.repair.terms.term_arithmetic import (
    coefficient,
    factors_of,
    product_of,
    sum_of,
    times,
)

#: A sentence with {} for terms, integers and words, followed by these.
Said = tuple

#: (kind, the change in words, maker of the new term, which may raise IllFormed).
Variant = tuple[str, Said, Callable[[], Term]]

_FACTORS = tuple(Fraction(text) for text in ("2", "1/2", "3", "1/3", "3/2", "2/3", "4", "1/4"))
_MOST_ENTRIES = 9
_PRODUCT_SIGNS = {head: OPERATORS[head].sign or "juxtaposition" for head in PRODUCTS}
#: Operations that, like letters, may stand in brackets or bars with an exponent.
_SQUARED = frozenset(("skew", "dot", "outer", "triple", "det", "trace", "norm"))


def atoms_of(statement: Statement) -> Iterator[Term]:
    """Yields the symbols of the statement, with their index and derivatives."""
    for _, term in places(statement):
        bare = term.body if isinstance(term, Derivative) else term
        if isinstance(bare, Symbol) and not bare.arguments:
            yield term


def variants(term: Term, is_addend: bool, atoms: Sequence[Term] = ()) -> Iterator[Variant]:
    """Yields the variants of a term. is_addend: it is an addend or a whole side, so that it has its own
    sign."""
    if is_addend and not isinstance(term, Zero):
        yield from _sign_and_factor(term)
    match term:
        case Number():
            yield from _numbers(term)
        case Integer(value=value):
            for step in (1, -1):
                yield "coefficient", ("replace {} by {}", value, value + step), partial(integer, value + step)
        case Counting():
            yield from _countings(term)
        case Symbol():
            yield from _indices(term)
        case Power():
            yield from _exponents(term)
        case BigSum():
            yield from _bounds(term)
        case Block():
            yield from _entries_exchanged(term)
            yield from _zeros_and_ones(term)
        case Apply(head="add"):
            yield from _sums(term)
        case Apply():
            yield from _operations(term, is_addend)
    if isinstance(term, Apply):
        yield from moved_operands(term)
    if is_addend and isinstance(term, Number):
        yield from _letters_for_a_number(term, atoms)
    yield from _dots(term)
    yield from _squares(term)
    yield from _marks_added(term)
    yield from _other_symbols(term, atoms)


def _sign_and_factor(term: Term) -> Iterator[Variant]:
    """Yields changes of the sign and the factor of an addend or a whole side, except those of a sum's
    addends."""
    if isinstance(term, Apply) and term.head == "neg":
        yield "sign", ("remove the minus sign before {}", term.arguments[0]), lambda: term.arguments[0]
    elif not (isinstance(term, Apply) and term.head == "add"):
        yield "sign", ("insert a minus sign before {}", term), partial(apply, "neg", term)
    if abs(coefficient(term)) == 1:
        for factor in _FACTORS[:3]:
            yield "coefficient", ("{} gets the factor {}", term, factor), partial(times, factor, term)


def _numbers(term: Number) -> Iterator[Variant]:
    value = term.value
    for new in dict.fromkeys([*(value * factor for factor in _FACTORS), value + 1, value - 1, -value]):
        if new not in (0, value):
            yield "coefficient", ("replace the number {} by {}", value, new), partial(number, new)


def _letters_for_a_number(term: Number, atoms: Sequence[Term]) -> Iterator[Variant]:
    for atom in atoms:
        if atom.type == SCALAR:
            yield "symbol", ("replace the number {} by {}", term.value, atom), partial(_as_it_is, atom)


def _countings(term: Counting) -> Iterator[Variant]:
    for index, argument in enumerate(term.arguments):
        for step in (1, -1):
            changed = list(term.arguments)
            changed[index] = argument + step
            said = ("replace {} by {} in the {} {}", argument, argument + step, term.name, term)
            yield "coefficient", said, partial(counting, term.name, *changed)


def _sums(term: Apply) -> Iterator[Variant]:
    """Yields the sum without each addend."""
    for index, addend in enumerate(term.arguments):
        rest = term.arguments[:index] + term.arguments[index + 1 :]
        yield "addend dropped", ("remove the addend {}", addend), partial(sum_of, rest)
    if len(term.arguments) == 2 and SCALAR in (term.type, term.arguments[0].type):
        said = ("multiply {} by {} instead of adding them", *term.arguments)
        yield "product", said, partial(apply, "mul", *term.arguments)


def _bounds(term: BigSum) -> Iterator[Variant]:
    for step in (1, -1):
        upper = term.upper + step
        said = ("replace the upper bound {} of the sum by {}", term.upper, upper)
        yield "bound", said, partial(big_sum, term.variables, term.lower, upper, term.body)
        if term.lower is not None:
            lower = term.lower + step
            said = ("replace the lower bound {} of the sum by {}", term.lower, lower)
            yield "bound", said, partial(big_sum, term.variables, lower, term.upper, term.body)


def _entries_exchanged(matrix: Block) -> Iterator[Variant]:
    """Yields the matrix with two entries exchanged; none for a large matrix."""
    entries, width = matrix.children, len(matrix.entries[0])
    for one, other in combinations(range(len(entries)), 2) if len(entries) <= _MOST_ENTRIES else ():
        if entries[one] == entries[other]:
            continue
        changed = list(entries)
        changed[one], changed[other] = changed[other], changed[one]
        rows = _rows(changed, width)
        said = ("exchange {} and {}", entries[one], entries[other])
        yield "swap", said, partial(block, rows)


def _zeros_and_ones(matrix: Block) -> Iterator[Variant]:
    """Yields the matrix with 0 for an entry 1 or -1, and with 1 for a scalar entry 0."""
    entries, width = matrix.children, len(matrix.entries[0])
    for place, entry in enumerate(entries):
        if entry.type != SCALAR or not isinstance(entry, Zero | Number):
            continue
        if isinstance(entry, Number) and abs(entry.value) != 1:
            continue
        new = number(1) if isinstance(entry, Zero) else zero()
        rows = _rows([*entries[:place], new, *entries[place + 1 :]], width)
        yield "coefficient", ("replace the entry {} by {}", entry, new), partial(block, rows)


def _rows(entries: Sequence[Term], width: int) -> list[Sequence[Term]]:
    return [entries[start : start + width] for start in range(0, len(entries), width)]


def _indices(term: Symbol) -> Iterator[Variant]:
    for place, index in enumerate(term.index):
        for step in (1, -1):
            changed = list(term.index)
            changed[place] = index + step
            if not (changed[place].is_number and int(changed[place]) < 0):
                said = ("replace the index {} of {} by {}", index, term, changed[place])
                yield "index", said, partial(symbol, term.declaration, changed, term.arguments)


def _exponents(term: Power) -> Iterator[Variant]:
    steps = (2, -2) if term.base.type.kind == "vector" else (1, -1)
    is_length = isinstance(term.base, Apply) and term.base.head == "norm"
    for step in (*steps, 2, -2) if is_length else steps:
        exponent = term.exponent + step
        if exponent.is_number and int(exponent) < 1:
            continue
        said = ("replace the exponent {} of {} by {}", term.exponent, term.base, exponent)
        yield "exponent", said, partial(raised_to, term.base, exponent)


def _squares(term: Term) -> Iterator[Variant]:
    in_brackets = isinstance(term, Apply) and term.head in _SQUARED
    if (in_brackets or isinstance(term, Symbol | Derivative)) and term.type.kind in ("scalar", "tensor"):
        yield "exponent", ("{} gets the exponent 2", term), partial(power, term, 2)


def raised_to(base: Term, exponent: Linear) -> Term:
    return base if exponent == Linear(1) else power(base, exponent)


def _dots(term: Term) -> Iterator[Variant]:
    match term:
        case Derivative(body=body, order=order):
            for step in (1, -1):
                said = ("{} is differentiated {} instead of {} times", body, order + step, order)
                yield "dots", said, partial(differentiated, body, order + step)
        case Symbol(declaration=declaration) if declaration.constant:
            return
        case Symbol() | Apply(head="skew"):
            yield "dots", ("put a dot over {}", term), partial(derivative, term, 1)


def differentiated(body: Term, order: Linear) -> Term:
    return body if order == Linear(0) else derivative(body, order)


def _operations(term: Apply, is_addend: bool) -> Iterator[Variant]:
    head, arguments = term.head, term.arguments
    said: Said
    other: Head | None
    match head:
        case "skew":
            yield from _tilde_moved(arguments[0])
        case "neg" if not is_addend:
            yield "sign", ("remove the minus sign before {}", arguments[0]), lambda: arguments[0]
        case "transpose" | "inverse":
            other = "inverse" if head == "transpose" else "transpose"
            kind = "transpose" if head == "transpose" else "exponent"
            yield kind, (f"remove the {head} of {{}}", arguments[0]), lambda: arguments[0]
            said = (f"replace the {head} of {{}} by its {other}", arguments[0])
            yield "transpose", said, partial(apply, other, arguments[0])
        case "adjugate" | "conjugate":
            yield "mark", ("remove the star of {}", arguments[0]), lambda: arguments[0]
        case "triple":
            a, b, c = arguments
            said = ("swap the first two factors of {}", term)
            yield "swap", said, partial(apply, "triple", b, a, c)
        case "mul":
            yield from _factors(term)
        case "sin" | "cos" if coefficient(arguments[0]) == 1:
            for factor in _FACTORS[:2]:
                said = ("multiply the angle {} by {}", arguments[0], factor)
                yield "coefficient", said, partial(_of_multiple, head, factor, arguments[0])
        case "div":
            said = ("remove the denominator of {}", term)
            yield "coefficient", said, lambda: arguments[0]
    if partner := OPERATORS[head].partner:
        said = ("replace {} by {} in {}", head, partner, term)
        yield "operation", said, partial(apply, partner, arguments[0])
    if head in ("cross", "outer", "compose"):
        said = ("swap the factors of {}", term)
        yield "swap", said, partial(apply, head, *reversed(arguments))
    if head in _PRODUCT_SIGNS and all(a.type.kind == "vector" for a in arguments):
        yield from _other_products(term)


def _other_products(term: Apply) -> Iterator[Variant]:
    """Other products of the same two vectors."""
    for head, sign in _PRODUCT_SIGNS.items():
        if head != term.head:
            said = ("replace {} by {} in {}", _PRODUCT_SIGNS[term.head], sign, term)
            yield "product", said, partial(apply, head, *term.arguments)


def _of_multiple(head: Head, factor: Fraction, term: Term) -> Term:
    return apply(head, times(factor, term))


def _factors(term: Apply) -> Iterator[Variant]:
    """Yields the product without a numeric factor, and with the last two factors swapped."""
    *before, first, last = factors_of(term)
    if not before and isinstance(first, Number):
        yield "coefficient", ("remove the factor {} of {}", first.value, last), lambda: last
    factors = [*before, first, last]
    for place, factor in enumerate(factors):
        if factor.type.is_square and not isinstance(factor, Number):
            rest = factors[:place] + factors[place + 1 :]
            yield "product", ("remove the factor {} of {}", factor, term), partial(product_of, rest)
    if "scalar" not in (first.type.kind, last.type.kind):
        said = ("{} and {} change places", first, last)
        yield "swap", said, partial(product_of, [*before, last, first])


def _tilde_moved(body: Term) -> Iterator[Variant]:
    yield "tilde", ("remove the tilde of {}", body), lambda: body
    match body:
        case Apply(head="mul", arguments=(left, right)):
            said = ("move the tilde from {} to {}", body, right)
            yield "tilde", said, lambda: apply("mul", left, apply("skew", right))
            said = ("move the tilde from {} to {}", body, left)
            yield "tilde", said, lambda: apply("mul", apply("skew", left), right)


def _marks_added(term: Term) -> Iterator[Variant]:
    if isinstance(term, Zero | Identity):
        return
    if term.type.kind == "quaternion" and not (isinstance(term, Apply) and term.head == "conjugate"):
        yield "mark", ("put a star on {}", term), partial(apply, "conjugate", term)
    if term.type.kind == "vector":
        yield "tilde", ("put a tilde over {}", term), partial(apply, "skew", term)
    if term.type.kind not in ("tensor", "matrix"):
        return
    if not (isinstance(term, Apply) and term.head == "transpose"):
        yield "transpose", ("transpose {}", term), partial(apply, "transpose", term)
    if term.type.kind == "matrix":
        return
    match term:
        case Apply(head="mul", arguments=(left, Apply(head="skew", arguments=(x,)))):
            said = ("move the tilde from {} over the product {}", x, term)
            yield "tilde", said, lambda: apply("skew", apply("mul", left, x))
        case Symbol():
            yield "mark", ("replace {} by its adjugate", term), partial(apply, "adjugate", term)


def _other_symbols(term: Term, atoms: Sequence[Term]) -> Iterator[Variant]:
    """Yields other symbols of the same kind and weight; those of smaller weight with derivatives."""
    bare = term.body if isinstance(term, Derivative) else term
    if not isinstance(bare, Symbol) or bare.arguments:
        return
    for atom in atoms:
        other = differentiated_to(term.weight, atom) if atom.type.kind == term.type.kind else None
        if other is not None and other != term:
            underlined = other.type.dual != term.type.dual and _letter(other) == _letter(term)
            kind = "mark" if underlined else "symbol"
            yield kind, ("replace {} by {}", term, other), partial(_as_it_is, other)


def _as_it_is(term: Term) -> Term:
    return term


def differentiated_to(weight: Weight, atom: Term) -> Term | None:
    """Returns the atom, or its derivative, of this weight."""
    if atom.weight == weight:
        return atom
    if weight is None or atom.weight is None or not isinstance(atom, Symbol):
        return None
    order = weight - atom.weight
    is_positive = order.constant >= 0 if order.is_number else all(c > 0 for _, c in order.coefficients)
    is_moving = not atom.declaration.constant and atom.type.kind not in ("matrix", "operator")
    return derivative(atom, order) if is_positive and is_moving else None


def _letter(term: Term) -> str:
    """Returns the symbol without underline and font."""
    text = to_latex(term)
    for mark in ("\\underline", "\\mathbf", "\\boldsymbol", "{", "}"):
        text = text.replace(mark, "")
    return text

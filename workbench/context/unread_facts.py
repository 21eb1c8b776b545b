"""Facts from equations x = … that cannot be parsed, or that stand in a sentence."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path

from workbench.context.claims import Claim, Notation
from workbench.context.facts import Duration, Fact, Origin, Provider
from workbench.context.formula_acts import is_before_scope, is_by_definition
from workbench.context.free_symbols import terms_of
from workbench.context.introducing_words import is_denied, is_exception, is_let, place_of_case, reaches
from workbench.context.read_formulas import read_statement
from workbench.core.construct import apply, derivative, number, relation, zero
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.operations import CIRCULAR
from workbench.core.terms import Apply, Derivative, IllFormed, Relation, Symbol, Term, sides_of
from workbench.core.types import Declaration
from workbench.core.verdict import Strength
from workbench.language.definitions import expand
from workbench.language.grammar.latex_keys import Ignored, latex_key
from workbench.language.printing.printer import to_latex
from workbench.source.documents import Display
from workbench.source.documents.surrounding_words import is_of_next_sentence, sections_of
from workbench.source.rows.display_vocabulary import ORDER

_ARGUMENTS = re.compile(r"(?:\\left)?\((?:[^()]|\([^()]*\))*\)$")
_DOTS = re.compile(r"\\d+ot(?![A-Za-z])")
#: The indices of a component of a vector, a matrix or a quaternion.
COMPONENT = re.compile(r"[0-3]|[1-3][1-3]|[xyzw]|[xyz][xyz]|[ijk]|")
_CONSTANT = re.compile(r"(?:\\(?:text|mathrm|mbox|textrm|rm|operatorname))?\.?const(?:ant)?")
#: The sign of a bound behind an equation, as in x = y < 1: stated bounds are facts of their own.
_BOUND = re.compile(rf"\\in(?![A-Za-z])|{ORDER.pattern}")
_WHOLE = re.compile(r"[+-]?\d+")
_RIGHT_ANGLE = re.compile(r"([+-]|\\pm)?(?:(\d+)(?:\^\\circ|[°˚]|\\degree)|(\\pi)|\\[dt]?frac\\pi2|\\pi/2)")
_COSINES = (1, 0, -1, 0)


@dataclass(frozen=True)
class Unread:
    """An unparsed equation left = right on a line of the text.

    inline: the formula, if it stands in a sentence."""

    left: str
    right: str
    line: int
    file: Path | None = None
    inline: Display | None = None

    @cached_property
    def latex(self) -> str:
        return " ".join(f"{self.left}={self.right}".split())

    @property
    def shown(self) -> str:
        return self.latex if len(self.latex) <= 60 else f"{self.latex[:59]}…"

    def values(self, own: Symbol, terms: Sequence[Term]) -> list[Fact] | None:
        """Returns the facts that the symbol always has its value, if that is an integer, a right angle or
        any constant.

        Returns None otherwise, or if the terms cannot be evaluated at the angle.
        """
        top, is_turn = _top(own, terms), is_turned(own, terms)
        is_value = not _DOTS.search(self.left) and not _ARGUMENTS.search(self.left.rstrip(" :"))
        if top is None or own.type.kind != "scalar" or not is_value:
            return None
        right = re.sub(r"[\s{}]|\\[,;!]", "", self.right).rstrip(".,;")
        if (quarters := _quarters(right)) is not None and is_turn:
            premises = [relation("=", apply("cos", own), number(_COSINES[quarters % 4]))]
            if "\\pm" not in right or quarters % 2 == 0:
                premises.append(relation("=", apply("sin", own), number(_COSINES[(quarters - 1) % 4])))
        elif _WHOLE.fullmatch(right):
            premises = [relation("=", own, number(int(right)) if int(right) else zero())]
        elif _CONSTANT.fullmatch(right):
            premises = []
        else:
            return None
        premises += [relation("=", derivative(own, order + 1), zero()) for order in range(top)]
        about, origin = frozenset({own.declaration.name}), self.origin
        return [Fact(each, about, origin, Strength.STATED, Duration.INSTANT) for each in premises]

    @property
    def origin(self) -> Origin:
        return Origin(Provider.UNREAD, self.shown, f"line {self.line}")


def said_unread(claims: Sequence[Claim], inline: Sequence[Display]) -> Mapping[str, list[Unread]]:
    """Returns the unparsed equations and those in sentences, by their left side."""
    unread = [each for each in claims if each.printed.statement is None and not each.chain]
    said: list[tuple[str, int, Path | None, Display | None]]
    said = [(each.printed.latex, each.line, each.source.file, None) for each in unread]
    said += [(each.latex, each.line, each.source.path, each) for each in inline]
    found: dict[str, list[Unread]] = {}
    for latex, line, file, formula in said:
        left, equals, right = without_bound(latex).partition("=")
        if equals:
            name = _ARGUMENTS.sub("", _flat(left.rstrip(" :")))
            found.setdefault(name, []).append(Unread(left, right, line, file, formula))
    return found


def without_bound(latex: str) -> str:
    """Returns the equation x = y of x = y > 0 and of x = y ∈ (0, 1); a formula of another form as it is."""
    left, equals, right = latex.partition("=")
    return left + equals + _BOUND.split(right, maxsplit=1)[0]


def unread_facts(claim: Claim, said: Mapping[str, list[Unread]]) -> Iterator[Fact]:
    """Yields the facts that unparsed formulas state of a claim's free symbols: the value of a number or an
    angle, or an opaque fact.
    """
    assert claim.printed.statement is not None
    definitions = claim.notation.definitions
    defined = {definition.declaration.name for definition in definitions}
    written = {term.declaration for term in terms_of(claim.printed.statement) if isinstance(term, Symbol)}
    free = [each for each in written if each.name not in defined and not each.free]
    for declaration in sorted(free, key=lambda each: str(each.name)):
        if not definitions.is_pi(declaration):
            yield from _facts_about(declaration, claim, said)


def _facts_about(declaration: Declaration, claim: Claim, said: Mapping[str, list[Unread]]) -> Iterator[Fact]:
    notation = claim.notation
    stated = list(_said_of(declaration, notation, said))
    if declaration.indices:
        own_symbols = (term for term in terms_of(claim.printed.parsed) if isinstance(term, Symbol))
        members = {_flat(to_latex(each)) for each in own_symbols if each.declaration == declaration}
        stated += [each for name in sorted(members) for each in said.get(name, ())]
    for unread in stated:
        is_before = is_before_scope([declaration.name], unread.file, unread.line, notation)
        formula = unread.inline
        is_excluded = formula is not None and (
            is_exception(formula) or is_denied(formula) or _is_over(unread, claim)
        )
        if is_before or is_excluded or _is_by_definition(unread, notation):
            continue
        terms = _expanded(claim)
        own = _own(declaration, terms)
        values = unread.values(own, terms) if own else None
        if values is None:
            yield Fact(None, frozenset({declaration.name}), unread.origin, Strength.STATED)
        elif own is not None and _is_at_an_instant(unread, stated, values, own, claim):
            continue
        elif _is_another_case(unread, claim):
            yield from (replace(each, strength=Strength.GUESSED) for each in values)
        elif not _is_elsewhere(unread, claim):
            yield from values


def _is_at_an_instant(
    value: Unread, stated: Sequence[Unread], values: Sequence[Fact], own: Symbol, claim: Claim
) -> bool:
    """True if a symbol has a value at an instant only: it is said to be constant where the claim writes its
    rate, or sentences state several values of it and the text writes its rates.

    stated: all unparsed equations for the symbol.
    """
    rates = (part for part in terms_of(claim.printed.parsed) if isinstance(part, Derivative))
    if all(map(_is_of_rate, values)) and any(part == own for rate in rates for part in rate.walk()):
        return True
    formula = value.inline
    is_let_or_case = formula is not None and (is_let(formula) or place_of_case(formula) is not None)
    others = {each.latex for each in stated if each.inline is not None}
    return len(others) > 1 and own.declaration.name in claim.context.moving and not is_let_or_case


def _is_of_rate(value: Fact) -> bool:
    return isinstance(value.content, Relation) and isinstance(value.content.left, Derivative)


def _is_over(value: Unread, claim: Claim) -> bool:
    """True if a sentence supposes the value, and its case ends before the claim."""
    place = _place_beside(value, claim)
    return place is not None and value.inline is not None and not reaches(value.inline, place)


def _is_another_case(value: Unread, claim: Claim) -> bool:
    """True if another sentence of the section supposes the value for its own claim: one of another paragraph,
    or the one behind the display."""
    place = _place_beside(value, claim)
    if place is None or value.inline is None or _is_elsewhere(value, claim):
        return False
    case = place_of_case(value.inline)
    if case is None or place not in case:
        return case is not None
    return is_of_next_sentence(value.inline.source.prose, place, value.inline.start)


def _is_elsewhere(value: Unread, claim: Claim) -> bool:
    """True if a sentence of another section gives the symbol its value."""
    place = _place_beside(value, claim)
    if place is None or value.inline is None:
        return False
    return not sections_of(value.inline.source.prose).holds(value.inline.start, place)


def _place_beside(value: Unread, claim: Claim) -> int | None:
    """Returns the offset of the claim in the file of a value that a sentence gives; None if there is none."""
    span = claim.context.span
    if value.inline is None or span is None or value.file != claim.source.file:
        return None
    return value.inline.source.offset(span.line, span.column)


def _said_of(
    declaration: Declaration, notation: Notation, said: Mapping[str, list[Unread]]
) -> Iterator[Unread]:
    """Yields the unparsed equations for the symbol, or for a component of it that is not declared itself."""
    name = _flat(str(declaration.name))
    yield from said.get(name, ())
    if declaration.type.kind == "scalar":
        return
    declared = {_flat(str(each)) for each in notation.symbols.symbols}
    for other, unread in said.items():
        _, _, index = other.partition(f"{name}_")
        if other == f"{name}_{index}" and COMPONENT.fullmatch(index) and other not in declared and index:
            yield from unread


def _is_by_definition(unread: Unread, notation: Notation) -> bool:
    """True if the sides are equal by definition, so that the equation states nothing."""
    with suppress(ReadError, IllFormedAt, ValueError):
        return is_by_definition(read_statement(unread.latex, notation, None)[0], notation.definitions)
    return False


def _quarters(right: str) -> int | None:
    """Returns the number of right angles in a value; None if it is no multiple of one."""
    if right in ("0", "-0"):
        return 0
    match = _RIGHT_ANGLE.fullmatch(right)
    if match is None:
        return None
    degrees = int(match[2] or (180 if match[3] else 90))
    return None if degrees % 90 else degrees // 90 * (-1 if match[1] == "-" else 1)


def _flat(name: str) -> str:
    r"""Returns the name without dots of derivatives: an equation for \dot{x} is a fact about x."""
    ignored = Ignored.BRACES | Ignored.SIZES | Ignored.GAPS | Ignored.ALIGNMENT
    return latex_key(_DOTS.sub("", name), ignored)


def _expanded(claim: Claim) -> list[Term]:
    sides = list(sides_of(claim.printed.parsed))
    sides += [side for supposed in claim.supposed for side in sides_of(supposed)]
    with suppress(IllFormed):
        return [expand(side, claim.notation.definitions) for side in sides]
    return []


def _parts(terms: Sequence[Term]) -> Iterator[Term]:
    for term in terms:
        yield from term.walk()


def _own(declaration: Declaration, terms: Sequence[Term]) -> Symbol | None:
    """Returns the symbol in the terms; None if it is a family, occurs at several instants, or not at all."""
    parts = [part for part in _parts(terms) if isinstance(part, Symbol)]
    own = {part for part in parts if part.declaration == declaration}
    is_one = len(own) == 1 and not any(part.index or part.arguments for part in own)
    return own.pop() if is_one and not any(part.declaration.clock for part in parts) else None


def _top(own: Symbol, terms: Sequence[Term]) -> int | None:
    """Returns the highest order of a derivative that contains the symbol; None if an order is symbolic."""
    rates = [part for part in _parts(terms) if isinstance(part, Derivative)]
    orders = {rate.order for rate in rates if own in rate.body.walk()}
    return sum(each.constant for each in orders) if all(each.is_number for each in orders) else None


def is_turned(own: Symbol, terms: Sequence[Term]) -> bool:
    """True if the symbol occurs only in circular functions and derivatives."""

    def is_turn(term: Term) -> bool:
        if isinstance(term, Derivative) or (isinstance(term, Apply) and term.head in CIRCULAR):
            return term.children == (own,) or all(map(is_turn, term.children))
        return term != own and all(map(is_turn, term.children))

    return all(map(is_turn, terms))

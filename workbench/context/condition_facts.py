"""Facts from the formulas in sentences: “suppose that $f \\neq 0$”, “for $m > 0$”."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

from workbench.context.claims import Notation
from workbench.context.facts import Act, Duration, Fact, Origin, Provider
from workbench.context.formula_acts import is_before_scope, is_by_definition
from workbench.context.formula_subject import names_of
from workbench.context.free_symbols import names_in, terms_of
from workbench.context.introducing_words import (
    is_case_of_sentence,
    is_denied,
    is_exception,
    is_let,
    is_of_next,
    is_over,
    reaches,
)
from workbench.context.read_formulas import read_statement
from workbench.context.stated_bounds import bounds_of, links_of
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.names import Name
from workbench.core.terms import Relation, Statement, Symbol, Term, sides_of
from workbench.core.types import Declaration
from workbench.core.verdict import Strength
from workbench.language.printing.printer import to_latex
from workbench.source.documents import Display, Token, spelled
from workbench.source.documents.surrounding_words import (
    leads_of,
    sections_of,
    sentence_around,
    supposed_before,
)
from workbench.source.rows.chains import Step, steps_of
from workbench.source.rows.display_vocabulary import ORDERS, UNEQUAL

#: Macros that mark an equation as a law for the rest of the text.
_RATES = frozenset({"\\dot", "\\ddot", "\\dddot"})
_FORMULA = r"(?:\$[^$]+\$|\\\([^$]*?\\\)|`[^`]+`)"
#: A relation of two symbols that words state as a condition, or as the reason of a formula: "a and b are
#: orthogonal", "a is orthogonal to the vector b".
_REASON = (
    r"\b(?:since|because|as|if|when|where|for|that|suppose|assume|assuming|let|given)\b[^.,;:$`\\]{0,30}?"
)
_RELATED = r"(?P<adjective>orthogonal|perpendicular|parallel|equal)"
_ONE, _OTHER = rf"(?P<one>{_FORMULA})", rf"(?P<other>{_FORMULA})"
_BETWEEN = [
    re.compile(_REASON + words, re.IGNORECASE)
    for words in (
        rf"{_ONE} and {_OTHER} (?:(?:are|is|be) (?:both |mutually )?{_RELATED}|(?P<verb>commute))\b",
        rf"{_ONE} (?:(?:is|be) {_RELATED} to|(?P<verb>commute)s with) (?:the [a-z]+ )?{_OTHER}",
    )
]
#: Words before the reason that deny it: "without assuming that a and b are orthogonal".
_DENIED = re.compile(
    r"\b(?:without|not|never|nor)\s+(?:(?:assum|suppos|requir|need|us|only)[a-z]*\s+){0,2}$", re.IGNORECASE
)
_RELATIONS = {
    "orthogonal": r"{0} \perp {1}",
    "perpendicular": r"{0} \perp {1}",
    "parallel": r"{0} \parallel {1}",
    "equal": "{0} = {1}",
    "commute": "{0} {1} = {1} {0}",
}
#: Marks of conditions that stay in force after their sentence.
_FAR_REACHING = UNEQUAL | _RATES | ORDERS.keys() | {"\\in"}


class InlineFormulas:
    """The formulas in the sentences of a text, each cut and read once."""

    def __init__(self, inline: Iterable[Display]) -> None:
        self._formulas: dict[Path, list[Display]] = {}
        for each in inline:
            self._formulas.setdefault(each.source.path, []).append(each)
        for formulas in self._formulas.values():
            formulas.sort(key=lambda each: each.start)
        self._steps: dict[tuple[int, frozenset[str]], list[Step]] = {}
        self._conditions: dict[tuple[Path, frozenset[str]], list[tuple[Display, Step]]] = {}
        self._read: dict[tuple[int, int, bool], tuple[Notation, list[Fact]]] = {}

    def before(self, path: Path, end: int, start: int = 0) -> list[Display]:
        """Returns the formulas of a file that begin between `start` and `end`."""
        found = self._formulas.get(path, [])
        first, last = (bisect_left(found, at, key=lambda each: each.start) for at in (start, end))
        return found[first:last]

    def steps(self, formula: Display, notation: Notation) -> list[Step]:
        key = (id(formula), frozenset(notation.words))
        if key not in self._steps:
            self._steps[key] = [step for steps in steps_of(formula, notation.words) for step in steps]
        return self._steps[key]

    def conditions(self, path: Path, end: int, notation: Notation) -> Iterator[tuple[Display, Step]]:
        """Yields the steps before `end` that are conditions beyond their own sentence."""
        key = (path, frozenset(notation.words))
        if key not in self._conditions:
            self._conditions[key] = [
                (each, step)
                for each in self._formulas.get(path, [])
                if each.rows
                for step in self.steps(each, notation)
                if any(token.text in _FAR_REACHING for token in step.tokens)
            ]
        found = self._conditions[key]
        yield from found[: bisect_left(found, end, key=lambda each: each[0].start)]

    def said(self, formula: Display, step: Step, notation: Notation, with_equations: bool) -> list[Fact]:
        """Returns the facts that a step of a formula states in a notation."""
        key = (id(step), id(notation), with_equations)
        if key not in self._read:  # keeps the notation alive, so that its id stays unique
            line = formula.source.place(formula.start)[0]
            denied = is_denied(formula)
            made = [] if denied else list(_condition(step.tokens, line, notation, with_equations))
            if is_exception(formula):
                is_bound = any(token.text in ORDERS for token in step.tokens)
                made = [fact for each in made if (fact := _denied(each, is_bound)) is not None]
            elif with_equations and is_let(formula):
                made = list(map(_as_definition, made))
            self._read[key] = (notation, made)
        return self._read[key][1]


def _denied(fact: Fact, is_bound: bool) -> Fact | None:
    """Returns the fact that holds where the fact does not: f ≠ 0 of "unless f = 0"; None if none is known.

    is_bound: whether the fact is one of those of an inequality, of which only a ≥ b is denied, as b ≥ a.
    """
    said = fact.content
    if not isinstance(said, Relation) or said.operator == "≈" or fact.bound is not None:
        return None
    if is_bound != (said.operator == "≥"):
        return None
    if is_bound:
        other, sign = Relation("≥", said.right, said.left), "\\leq"
    else:
        other = Relation("≠" if said.operator == "=" else "=", said.left, said.right)
        sign = "\\neq" if other.operator == "≠" else "="
    words = f"{to_latex(said.left)} {sign} {to_latex(said.right)}"
    return replace(fact, content=other, origin=replace(fact.origin, text=words))


def _as_definition(fact: Fact) -> Fact:
    """Returns the fact as one for all times, if it gives a symbol by others."""
    said = fact.content
    if isinstance(said, Relation) and isinstance(said.left, Symbol) and said.operator == "=":
        given = _symbols(said.right.walk())
        if given and said.left.declaration not in given:
            return replace(fact, duration=Duration.ALWAYS, act=Act.DEFINE)
    return fact


def _is_value(fact: Fact) -> bool:
    """True if the fact gives a symbol, or its rate, a number."""
    said = fact.content
    return isinstance(said, Relation) and said.operator == "=" and not _symbols(said.right.walk())


def conditions_of(
    display: Display, statement: Statement, notation: Notation, spoken: InlineFormulas
) -> Iterator[Fact]:
    """Yields the facts that formulas in sentences state of a statement's symbols, after unfolding
    definitions, and the case of which its own sentence speaks.

    Sources are the formulas in the sentence of the display, and in the words that introduce its list; earlier
    inequalities in its section or an enclosing one, and earlier equations for rates.
    """
    reached = map(notation.definitions.reached, sides_of(statement))
    own = names_of(_symbols(part for parts in reached for part in parts))
    text, path = display.source.prose, display.source.path
    first, last = sentence_around(text, display.start, display.end)
    begins = first - len(supposed_before(text, first))
    line = display.source.place(display.start)[0]
    leads = list(leads_of(text, display.start))
    words = [text[slice(*lead)] for lead in leads]
    words.append(f"{text[begins : display.start]} . {text[display.end : last]}")
    found = [fact for each in words for fact in _between(each, line, notation)]
    sections = sections_of(text)
    for formula, step in spoken.conditions(path, first, notation):
        is_here = _holds_rate(step.tokens) or sections.holds(formula.start, display.start)
        if is_here and not is_over(formula, display.start):
            told = spoken.said(formula, step, notation, with_equations=False)
            is_near = not any(map(_is_value, told)) or reaches(formula, display.start)
            found += told if is_near else []
    of_sentence: list[Fact] = []
    spans = [*leads, (begins, last)]
    for formula in (each for start, end in spans for each in spoken.before(path, end, start)):
        if is_over(formula, display.start) or is_of_next(formula, display.start):
            continue
        if not sections.holds(formula.start, display.start):
            continue
        for step in spoken.steps(formula, notation) if formula.rows else ():
            told = spoken.said(formula, step, notation, with_equations=True)
            found += told
            of_sentence += told if formula.start >= begins and is_case_of_sentence(formula) else []
    for _ in found:  # what is said of the symbols by which the sentence defines others counts, too
        own = own.union(*(fact.about for fact in found if fact.act is Act.DEFINE and fact.about & own))
    yield from (fact for fact in found if fact.about & own or fact in of_sentence)


def _between(words: str, line: int, notation: Notation) -> Iterator[Fact]:
    """Yields the relations of two symbols that the words state."""
    said = " ".join(words.replace(":math:", "").split())
    for match in (each for pattern in _BETWEEN for each in pattern.finditer(said)):
        if _DENIED.search(said[: match.start()]):
            continue
        sides = (match[name].strip("$`").removeprefix("\\(").removesuffix("\\)") for name in ("one", "other"))
        latex = _RELATIONS[(match["adjective"] or match["verb"]).lower()].format(*map(str.strip, sides))
        with suppress(ReadError, IllFormedAt, ValueError):
            statement, ranges = read_statement(latex, notation, None)
            if isinstance(statement, Relation) and not ranges:
                yield from bounds_of(latex, line, statement, None)


def _symbols(parts: Iterable[Term]) -> set[Declaration]:
    return {part.declaration for part in parts if isinstance(part, Symbol)}


def _holds_rate(tokens: Sequence[Token]) -> bool:
    return any(token.text in _RATES for token in tokens)


def _condition(
    tokens: Sequence[Token], line: int, notation: Notation, with_equations: bool
) -> Iterator[Fact]:
    """Yields the facts of a condition: those of the links of a chain a < x = y < b, and of x ∈ (a, b)."""
    for link in links_of(tokens):
        for fact in _of_link(link, line, notation, with_equations):
            yield replace(fact, origin=replace(fact.origin, text=spelled(tokens)[0]))


def _of_link(tokens: Sequence[Token], line: int, notation: Notation, with_equations: bool) -> Iterator[Fact]:
    latex, _ = spelled(tokens)
    signs = [at for at, token in enumerate(tokens) if token.text in ORDERS]
    order = ORDERS[tokens[signs[0]].text] if len(signs) == 1 else None
    if order:
        at = signs[0]
        latex = spelled([*tokens[:at], tokens[at].standing_for("="), *tokens[at + 1 :]])[0]
    elif not (with_equations or any(token.text in UNEQUAL | _RATES for token in tokens)):
        return
    with suppress(ReadError, IllFormedAt, ValueError):
        statement, ranges = read_statement(latex, notation, None)
        symbols = _symbols(terms_of(statement))
        pi = next(filter(notation.definitions.is_pi, symbols), None)
        if not isinstance(statement, Relation) or statement.operator == "≈" or ranges:
            return
        if pi is not None and order is None:  # `unread_facts` handles such angles
            return
        is_known = order is None and is_by_definition(statement, notation.definitions)
        if not is_known and not is_before_scope(names_in(statement), tokens[0].source.path, line, notation):
            yield from bounds_of(spelled(tokens)[0], line, statement, order, pi)


def range_facts(step: Step, notation: Notation, about: frozenset[Name]) -> Iterator[Fact]:
    """Yields the ranges of symbols that a step states next to a formula, such as x > 0."""
    for piece in step.ranges:
        line = piece[0].source.place(piece[0].start)[0]
        stated = list(_condition(piece, line, notation, with_equations=False))
        words = spelled(piece)[0]
        named = frozenset(name for name in about if name.letter in words)
        own = [fact for fact in stated if fact.about & about]
        yield from own or ([opaque(words, line, named)] if named and not stated else [])


def opaque(words: str, line: int, about: frozenset[Name]) -> Fact:
    """Returns the fact that the text makes an unformalized statement about symbols."""
    return Fact(None, about, Origin(Provider.CONDITION, words, f"line {line}"), Strength.STATED)

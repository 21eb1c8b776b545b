"""The conditions that a text states in its sentences: “suppose that $f \\neq 0$”, “for $m > 0$”, “for
parallel axes”.

Nothing is proved by them. They keep a formula that is false without them from being said to be false.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path

from workbench.language.printing.printer import to_latex
from workbench.language.typed.errors import IllFormedAt, ReadError
from workbench.language.typed.terms import Apply, Relation, Statement, Symbol, Term, Zero, sides_of
from workbench.language.typed.types import Declaration
from workbench.papers.cutting.chains import Step, steps_of
from workbench.papers.formulas import read_statement
from workbench.papers.model import Aside, Notation
from workbench.papers.said import is_before_scope, is_by_definition, names_in, terms_of
from workbench.papers.texts import Display, Token, spelled
from workbench.papers.texts.prose import sections_of, sentence_around, supposed_before

_UNEQUAL = frozenset({"\\neq", "\\ne"})
#: What an equation that is a law for the rest of the text is told by.
_RATES = frozenset({"\\dot", "\\ddot", "\\dddot"})
_ORDERS = {
    **dict.fromkeys((">", "\\gt"), ">"),
    **dict.fromkeys(("<", "\\lt"), "<"),
    **dict.fromkeys(("\\geq", "\\ge", "\\geqslant"), "≥"),
    **dict.fromkeys(("\\leq", "\\le", "\\leqslant"), "≤"),
}
#: What is false but for a few, "supposing that it is not an identity", is false.
_NOT_A = r"(?![^.;]*\b(?:is|are) not an? )"
#: “If you want …” is no condition.
_WISH = r"(?! (?:you|we|one) (?:want|wish|need|like|prefer))"
#: A case that words set apart; what is supposed in a formula is looked at by itself.
_SPECIAL = re.compile(
    r"\b(?:special|particular|limiting|degenerate|this|that) case\b|\bin the limit\b"
    r"|\bif\b[^.;:$\\`]*\bthen\b|\bof the form\b|\bprovided that\b"
    r"|\bapproach(?:es|ing)?\b|\btends? to\b|\b(?:close|near) to\b"
    rf"|\b(?:suppos|assum|restrict)\w*\b(?! *(?:that |for |to )?[$\\:`]){_NOT_A}|"
    r"\b(?:approximat|lineari[sz]|neglect|ignor|negligib)\w*|\bfirst[- ]order\b|\bsmall[- ]angle|"
    r"\b(?:(?:for|at|since|because|as(?= (?:the|both|these|two|\$|\\\())"
    rf"|if{_WISH}|when{_WISH}|where|in the case)\b[^.,;:]*|(?:suppos|assum)\w*{_NOT_A}[^.;]*)"
    r"\b(?:degrees?|zero|parallel|perpendicular|orthogonal"
    r"|aligned|coincid\w+|pure|planar|small|constant|fixed|stationary|at rest|identity|the same|vanish\w*"
    r"|(?:un|not )chang(?:ed|ing)|(?:do|does) not \w+)\b",
    re.IGNORECASE,
)
_FORMULA = r"(?:\$[^$]+\$|\\\([^$]*?\\\)|`[^`]+`)"
#: A relation between two symbols that words state as a condition, or as the reason of a formula.
_BETWEEN = re.compile(
    r"\b(?:since|because|as|if|when|where|for|that|suppose|assume|assuming|let|given)\b[^.,;:$`\\]{0,30}?"
    rf"(?P<one>{_FORMULA}) and (?P<other>{_FORMULA}) "
    r"(?:(?:are|is|be) (?:both |mutually )?"
    r"(?P<adjective>orthogonal|perpendicular|parallel|equal)|(?P<verb>commute))\b",
    re.IGNORECASE,
)
_RELATIONS = {
    "orthogonal": r"{0} \perp {1}",
    "perpendicular": r"{0} \perp {1}",
    "parallel": r"{0} \parallel {1}",
    "equal": "{0} = {1}",
    "commute": "{0} {1} = {1} {0}",
}
_EXAMPLE = re.compile(r"\b(?:for|as an?) (?:instance|example)\b|\be\.g\.", re.IGNORECASE)
_LETTER = re.compile(r"\\[A-Za-z]+|[A-Za-z]")
#: What is in force behind its sentence, too.
_FAR_REACHING = _UNEQUAL | _RATES | _ORDERS.keys()
_TURNED = str.maketrans("<>≤≥", "><≥≤")


@dataclass(frozen=True)
class _Said:
    """A condition that a sentence states, and the symbols in it."""

    aside: Aside
    symbols: frozenset[Declaration]


class Spoken:
    """The formulas in the sentences of a text. Each is cut and read once, whatever asks for it."""

    def __init__(self, inline: Iterable[Display]) -> None:
        self._formulas: dict[Path, list[Display]] = {}
        for each in inline:
            self._formulas.setdefault(each.source.path, []).append(each)
        for formulas in self._formulas.values():
            formulas.sort(key=lambda each: each.start)
        self._steps: dict[tuple[int, frozenset[str]], list[Step]] = {}
        self._conditions: dict[tuple[Path, frozenset[str]], list[tuple[Display, Step]]] = {}
        self._read: dict[tuple[int, int, bool], tuple[Notation, list[_Said]]] = {}

    def before(self, path: Path, end: int, start: int = 0) -> list[Display]:
        """The formulas of a file that begin between `start` and `end`."""
        found = self._formulas.get(path, [])
        first, last = (bisect_left(found, at, key=lambda each: each.start) for at in (start, end))
        return found[first:last]

    def steps(self, formula: Display, notation: Notation) -> list[Step]:
        key = (id(formula), frozenset(notation.words))
        if key not in self._steps:
            self._steps[key] = [step for steps in steps_of(formula, notation.words) for step in steps]
        return self._steps[key]

    def conditions(self, path: Path, end: int, notation: Notation) -> Iterator[tuple[Display, Step]]:
        """The steps before `end` that are conditions outside of their sentences, too."""
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

    def said(self, formula: Display, step: Step, notation: Notation, with_equations: bool) -> list[_Said]:
        """What a step of a formula says, read in a notation."""
        key = (id(step), id(notation), with_equations)
        if key not in self._read:  # with the notation, whose id is thus in use
            line = formula.source.place(formula.start)[0]
            made = list(_condition(step.tokens, line, notation, with_equations))
            self._read[key] = (notation, made)
        return self._read[key][1]


def asides_of(
    display: Display, statement: Statement, notation: Notation, spoken: Spoken
) -> tuple[Aside, ...]:
    """What the sentence of the display says of the symbols in the statement and in what defines these, what
    any sentence before it in its section, or around that, says that they are not, or are more or less than,
    and what any says of their rates."""
    reached = map(notation.definitions.reached, sides_of(statement))
    own = _symbols(part for parts in reached for part in parts)
    text, path = display.source.prose, display.source.path
    first, last = sentence_around(text, display.start, display.end)
    begins = first - len(supposed_before(text, first))
    around = [text[begins : display.start]]
    around += [behind for behind in [text[display.end : last].lstrip("$] \n.,;")] if behind[:1].islower()]
    line = display.source.place(display.start)[0]
    between, around = _between(list(map(_flat, around)), line, notation)
    named = {
        _flat(each.source.text[each.start : each.end]): each for each in spoken.before(path, last, begins)
    }
    cases = [
        next((case for case in _SPECIAL.finditer(words) if _is_about(case.group(), own, named)), None)
        for words in around
    ]
    if any(isinstance(side, Symbol) for side in sides_of(statement)):
        cases += map(_EXAMPLE.search, around[:1])
    found = [Aside(case.group(), line, None, seen=False) for case in cases if case]
    found += _of(own, between)
    sections = sections_of(text)
    for formula, step in spoken.conditions(path, first, notation):
        if _holds_rate(step.tokens) or sections.holds(formula.start, display.start):
            found += _of(own, spoken.said(formula, step, notation, with_equations=False))
    for formula in spoken.before(path, last, first):
        for step in spoken.steps(formula, notation) if formula.rows else ():
            found += _of(own, spoken.said(formula, step, notation, with_equations=True))
    return tuple(dict.fromkeys(found))


def _of(own: set[Declaration], said: Iterable[_Said]) -> Iterator[Aside]:
    """Those that speak of the symbols."""
    return (each.aside for each in said if each.symbols & own)


def _between(around: Sequence[str], line: int, notation: Notation) -> tuple[list[_Said], list[str]]:
    """The relations of two symbols that the words state, and the words without those that can be read."""
    made: list[_Said] = []

    def read(match: re.Match[str]) -> str:
        sides = (match[name].strip("$`").removeprefix("\\(").removesuffix("\\)") for name in ("one", "other"))
        latex = _RELATIONS[(match["adjective"] or match["verb"]).lower()].format(*map(str.strip, sides))
        with suppress(ReadError, IllFormedAt, ValueError):
            statement, ranges = read_statement(latex, notation, None)
            if isinstance(statement, Relation) and not ranges:
                symbols = frozenset(_symbols(terms_of(statement)))
                made.append(_Said(Aside(latex, line, statement), symbols))
                return ""
        return match.group()

    return made, [_BETWEEN.sub(read, words) for words in around]


def _flat(words: str) -> str:
    return " ".join(words.replace(":math:", "").split())


def _is_about(words: str, own: set[Declaration], spoken: Mapping[str, Display]) -> bool:
    """Whether words with formulas name a symbol of the claim in one; without any they may mean all."""
    named = [formula.latex for raw, formula in spoken.items() if raw in words]
    letters = {part for latex in named for part in _LETTER.findall(latex)}
    return not named or any(
        each.name.letter in letters or (len(each.name.letter) > 1 and each.name.letter in "".join(named))
        for each in own
    )


def _symbols(parts: Iterable[Term]) -> set[Declaration]:
    return {part.declaration for part in parts if isinstance(part, Symbol)}


def _holds_rate(tokens: Sequence[Token]) -> bool:
    return any(token.text in _RATES for token in tokens)


def _condition(
    tokens: Sequence[Token], line: int, notation: Notation, with_equations: bool
) -> Iterator[_Said]:
    latex, _ = spelled(tokens)
    signs = [at for at, token in enumerate(tokens) if token.text in _ORDERS]
    order = _ORDERS[tokens[signs[0]].text] if len(signs) == 1 else None
    if order:
        at = signs[0]
        latex = spelled([*tokens[:at], tokens[at].standing_for("="), *tokens[at + 1 :]])[0]
    elif not (with_equations or any(token.text in _UNEQUAL | _RATES for token in tokens)):
        return
    with suppress(ReadError, IllFormedAt, ValueError):
        statement, ranges = read_statement(latex, notation, None)
        symbols = _symbols(terms_of(statement))
        of_pi = any(map(notation.definitions.is_pi, symbols))  # `unread` knows such angles
        is_equation = isinstance(statement, Relation) and statement.operator != "≈" and not of_pi
        is_new = is_equation and not (order is None and is_by_definition(statement, notation.definitions))
        is_new = is_new and not is_before_scope(names_in(statement), tokens[0].source.path, line, notation)
        if is_new and not ranges:
            yield _Said(_aside(spelled(tokens)[0], line, statement, order), frozenset(symbols))


def own_asides(step: Step, notation: Notation) -> Iterator[Aside]:
    """Where its symbols are, as beside a formula that cannot be read with it: x > 0, or x \\in [0, 1]."""
    for piece in step.ranges:
        line = piece[0].source.place(piece[0].start)[0]
        found = [each.aside for each in _condition(piece, line, notation, with_equations=False)]
        yield from found or [Aside(spelled(piece)[0], line, None, seen=False)]


def _aside(latex: str, line: int, said: Relation, order: str | None) -> Aside:
    """x > 0 supposes that x ≠ 0, and of a counterexample that its x is more."""
    if order is None:
        return Aside(latex, line, said)
    premise = Relation("≠", said.left, said.right) if order in "<>" else None
    left, right = said.left, said.right
    if isinstance(left, Apply) and left.head == "norm" and isinstance(right, Zero) and order in ">≥":
        return Aside(latex, line, premise)
    if isinstance(right, Symbol):
        left, right, order = right, left, order.translate(_TURNED)
    value = Fraction(0) if isinstance(right, Zero) else getattr(right, "value", None)
    bound = (
        (to_latex(left), order, value) if isinstance(left, Symbol) and isinstance(value, Fraction) else None
    )
    return Aside(latex, line, premise, bound, seen=bound is not None)

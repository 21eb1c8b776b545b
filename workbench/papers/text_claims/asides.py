"""The conditions that a text states in its sentences: “suppose that $f \\neq 0$”, “for $m > 0$”, “for
parallel axes”.

Nothing is proved by them. They keep a formula that is false without them from being said to be false.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction

from workbench.language.printing.printer import to_latex
from workbench.language.typed.errors import IllFormedAt, ReadError
from workbench.language.typed.terms import Apply, Relation, Statement, Symbol, Term, Zero, sides_of
from workbench.language.typed.types import Declaration
from workbench.papers.cutting.chains import Step, steps_of
from workbench.papers.formulas import read_statement
from workbench.papers.model import Aside, Notation
from workbench.papers.said import is_before_scope, is_by_definition, names_in, terms_of
from workbench.papers.texts import Display, Token, spelled
from workbench.papers.texts.prose import headings, is_in_section_of, sentence_around, supposed_before

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
_EXAMPLE = re.compile(r"\b(?:for|as an?) (?:instance|example)\b|\be\.g\.", re.IGNORECASE)
_LETTER = re.compile(r"\\[A-Za-z]+|[A-Za-z]")
_TURNED = str.maketrans("<>≤≥", "><≥≤")


def asides_of(
    display: Display, statement: Statement, notation: Notation, inline: Sequence[Display]
) -> tuple[Aside, ...]:
    """What the sentence of the display says of the symbols in the statement and in what defines these, what
    any sentence before it in its section, or around that, says that they are not, or are more or less than,
    and what any says of their rates."""
    reached = map(notation.definitions.reached, sides_of(statement))
    own = _symbols(part for parts in reached for part in parts)
    text = display.source.prose
    first, last = sentence_around(text, display.start, display.end)
    begins = first - len(supposed_before(text, first))
    around = [text[begins : display.start]]
    around += [behind for behind in [text[display.end : last].lstrip("$] \n.,;")] if behind[:1].islower()]
    around = list(map(_flat, around))
    before = [each for each in inline if each.source.path == display.source.path and each.start < last]
    near = [each for each in before if each.start >= begins]
    spoken = {_flat(each.source.text[each.start : each.end]): each for each in near}
    cases = [
        next((case for case in _SPECIAL.finditer(words) if _is_about(case.group(), own, spoken)), None)
        for words in around
    ]
    if any(isinstance(side, Symbol) for side in sides_of(statement)):
        cases += map(_EXAMPLE.search, around[:1])
    line = display.source.place(display.start)[0]
    found = [Aside(case.group(), line, None, seen=False) for case in cases if case]
    sections = headings(text)
    for formula in before:
        if formula.rows:
            is_near = formula.start >= first
            is_inside = is_near or is_in_section_of(display.start, formula.start, sections)
            found += _conditions(formula, notation, own, is_near, is_inside)
    return tuple(dict.fromkeys(found))


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


def _conditions(
    formula: Display, notation: Notation, own: set[Declaration], is_near: bool, is_inside: bool
) -> Iterator[Aside]:
    """is_near: whether it stands in the sentence, in which any equation is a condition.   is_inside: in its
    section; behind that only an equation for a rate is in force."""
    line = formula.source.place(formula.start)[0]
    for steps in steps_of(formula, notation.words):
        for step in steps:
            if is_inside or _holds_rate(step.tokens):
                yield from _condition(step.tokens, line, notation, own, is_near)


def _holds_rate(tokens: Sequence[Token]) -> bool:
    return any(token.text in _RATES for token in tokens)


def _condition(
    tokens: Sequence[Token], line: int, notation: Notation, own: set[Declaration] | None, with_equations: bool
) -> Iterator[Aside]:
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
        of_pi = any(
            map(notation.definitions.is_pi, _symbols(terms_of(statement)))
        )  # `unread` knows such angles
        is_equation = isinstance(statement, Relation) and statement.operator != "≈" and not of_pi
        is_new = is_equation and not (order is None and is_by_definition(statement, notation.definitions))
        is_new = is_new and not is_before_scope(names_in(statement), tokens[0].source.path, line, notation)
        if is_new and not ranges and (own is None or _symbols(terms_of(statement)) & own):
            yield _aside(spelled(tokens)[0], line, statement, order)


def own_asides(step: Step, notation: Notation) -> Iterator[Aside]:
    """Where its symbols are, as beside a formula that cannot be read with it: x > 0, or x \\in [0, 1]."""
    for piece in step.ranges:
        line = piece[0].source.place(piece[0].start)[0]
        found = list(_condition(piece, line, notation, None, with_equations=False))
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

"""Definitions that a text gives: a single letter on the left at its first occurrence, and sentences."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from graphlib import TopologicalSorter
from itertools import groupby

from workbench.context.formula_acts import stated
from workbench.context.free_symbols import terms_of
from workbench.context.introducing_words import is_denied, is_let, is_presented, is_supposed
from workbench.core.integer_expressions import Linear
from workbench.core.terms import Apply, Block, Derivative, Relation, Statement, Symbol, Term
from workbench.language.grammar.latex_keys import latex_key
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.inference.pieces import operations_of
from workbench.papers.drafting.inference.walker import Walker
from workbench.papers.drafting.trial_reading import Outcome
from workbench.papers.drafting.typefaces import Guess, flat, without_bold
from workbench.source.documents import Display

#: Words right before a display that say what a symbol of an earlier display is.
_WHERE = re.compile(r"\b(?:where|with|in which|let|denote)\b[^.;:]{0,40}$", re.IGNORECASE)
#: What a value of numbers and π may contain: no other letter.
_VALUE = re.compile(
    r"(?:\\(?:pi|[dt]?frac|circ|degree|cdot|sqrt|pm|mp|,|;|!|left|right)(?![A-Za-z])|[^A-Za-z\\])+"
)
#: A symbol alone in brackets behind a letter: ψ of R_z(ψ); without blanks and braces.
_ARGUMENT = re.compile(r"(?<=[A-Za-z0-9])\((\\?[A-Za-z]+(?:_\w)?)\)")
_DEFINES = re.compile(r"\b(?:defined?|denote[ds]?|where|let|set|introduce|is called)\b", re.IGNORECASE)

#: A side that is one symbol in square brackets.
_DIMENSION = re.compile(r"\s*(?:\\left\s*)?\[[^\[\]+\-]*\]\s*=")


@dataclass(frozen=True)
class Formula:
    """One step of a display, with the outcome of reading it."""

    display: Display
    latex: str
    outcome: Outcome


@dataclass(frozen=True)
class Proposed:
    """A proposed definition.

    Attributes:
        name: The symbol's LaTeX; of a function with its arguments.
        body: The definition's LaTeX.
        sure: Whether the model takes it without a question.
        function: The function's LaTeX without arguments; "" if it is no function.
        in_sentence: Whether a sentence says so.
    """

    name: str
    body: str
    line: int
    why: str
    sure: bool
    function: str = ""
    in_sentence: bool = False

    @property
    def symbol(self) -> str:
        """The symbol's LaTeX, of a function without arguments."""
        return self.function or self.name


def definitions_in(formulas: Sequence[Formula]) -> list[Proposed]:
    """Returns the definitions of symbols alone on the left.

    They are in the display where the symbol first occurs, before :=, or in a display behind "where".
    """
    found: dict[str, Proposed] = {}
    seen: set[str] = set()
    arguments: set[str] = set()
    for _, own in groupby(formulas, key=lambda formula: id(formula.display)):
        statements = [(formula, _relations(formula)) for formula in own]
        used = {name for _, each in statements for said in each for name in _names(said)}
        new = {name for name in used - seen if flat(name) not in arguments}
        seen |= used
        arguments |= {each for formula, _ in statements for each in _ARGUMENT.findall(flat(formula.latex))}
        for formula, each in statements:
            for said in each:
                for made in _defined(formula, said, new, is_only=len(each) == 1):
                    found.setdefault(made.name, made)
    return list(found.values())


def _relations(formula: Formula) -> list[Relation]:
    return [each for each in formula.outcome.statements or () if isinstance(each, Relation)]


def _names(said: Statement) -> set[str]:
    return {str(term.declaration.name) for term in terms_of(said) if isinstance(term, Symbol)}


def _defined(formula: Formula, said: Relation, new: set[str], is_only: bool) -> Iterator[Proposed]:
    if (spin := _spin(said)) is not None:
        yield Proposed(*spin, formula.display.line, "what the rate of a rotation says", True)
        return
    if (rate := _rate(said)) is not None and rate[0] in new:
        yield Proposed(*rate, formula.display.line, "the name of a rate where it comes first", True)
        return
    name, is_assigned = _lone_left(said), ":=" in formula.latex and is_only
    if name is None or stated(said) is None:
        return
    if not (is_assigned or name in new or _says_where(formula.display, said)):
        return
    if said.left.type.kind == "scalar" and gives_dimension(formula.latex):
        return
    _, sign, written = re.split("(:=|=|$)", formula.latex, maxsplit=1)
    body = written.strip() if sign and is_only else to_latex(said.right)
    words = _DEFINES.search(formula.display.before)
    why = f'the text says "{words[0]}" before it' if words else "alone on the left where it comes first"
    yield Proposed(name, body, formula.display.line, "written :=" if is_assigned else why, True)


def _says_where(display: Display, said: Relation) -> bool:
    """True if words before the display say that it gives an earlier symbol, and it gives no number."""
    return bool(_WHERE.search(display.before)) and any(isinstance(t, Symbol) for t in said.right.walk())


def gives_dimension(latex: str) -> bool:
    """True for a formula like [x] = L/T, which gives the dimension of x if x is a number."""
    return bool(_DIMENSION.match(latex))


def _lone_left(statement: Statement) -> str | None:
    match statement:
        case Relation(left=Symbol(declaration=declaration, index=(), arguments=())):
            return str(declaration.name)
    return None


def _rate(said: Relation) -> tuple[str, str] | None:
    r"""Returns v and \dot{p} for \dot{p} = v."""
    match said:
        case Relation(
            operator="=",
            left=Derivative(body=Symbol(declaration=moving)) as rate,
            right=Symbol(declaration=own, index=(), arguments=()),
        ) if own.type == rate.type and own != moving:
            return str(own.name), to_latex(rate)
    return None


def _spin(said: Relation) -> tuple[str, str] | None:
    """Returns ω and vect(Ṙ Rᵀ) or vect(Rᵀ Ṙ) for Ṙ = ω̃ R, Ṙ = R ω̃, ω̃ = Ṙ Rᵀ or ω̃ = Rᵀ Ṙ."""
    match said:
        case Relation(
            left=Apply(head="skew", arguments=(Symbol() as spin,)),
            right=Apply(head="mul", arguments=(one, other)),
        ):
            return _of_rate(str(spin.declaration.name), one, other)
        case Relation(
            left=Derivative(body=Symbol(declaration=turning), order=order),
            right=Apply(head="mul", arguments=(one, other)),
        ) if turning.rotation and order == Linear(1):
            name = str(turning.name)
        case _:
            return None
    match one, other:
        case Apply(head="skew", arguments=(Symbol() as spin,)), Symbol(declaration=turned) if (
            turned == turning
        ):
            return str(spin.declaration.name), rf"\operatorname{{vect}}(\dot{{{name}}} {name}^T)"
        case Symbol(declaration=turned), Apply(head="skew", arguments=(Symbol() as spin,)) if (
            turned == turning
        ):
            return str(spin.declaration.name), rf"\operatorname{{vect}}({name}^T \dot{{{name}}})"
    return None


def spins_of_tensors(formulas: Iterable[Formula], defined: Collection[str]) -> Iterator[Proposed]:
    """Yields ω as vect(Ω), or Ω as the skew tensor of ω if nothing defines Ω, for Ω x = ω × x.

    defined: symbols with another definition.
    """
    for formula in formulas:
        for said in _relations(formula):
            match said:
                case Relation(
                    left=Apply(head="mul", arguments=(Symbol() as tensor, one)),
                    right=Apply(head="cross", arguments=(Symbol() as spin, other)),
                ) if one == other and not (tensor.index or spin.index):
                    name, axis = str(tensor.declaration.name), str(spin.declaration.name)
                    made = (axis, rf"\operatorname{{vect}}({name})")
                    made = made if name in defined else (name, rf"\operatorname{{skew}}({axis})")
                    yield Proposed(*made, formula.display.line, "a skew tensor and its vector", True)


def _of_rate(name: str, one: Term, other: Term) -> tuple[str, str] | None:
    match one, other:
        case Derivative(body=Symbol() as turned), Apply(head="transpose", arguments=(Symbol() as turning,)):
            form = r"\operatorname{vect}(\dot{%s} %s^T)"
        case Apply(head="transpose", arguments=(Symbol() as turning,)), Derivative(body=Symbol() as turned):
            form = r"\operatorname{vect}(%s^T \dot{%s})"
        case _:
            return None
    turn = turning.declaration
    is_one = turned == turning and turn.rotation
    return (name, form % (turn.name, turn.name)) if is_one else None


def magnitudes(formulas: Sequence[Formula], guesses: Mapping[str, Guess]) -> Iterator[Proposed]:
    """Yields ω as ‖𝛚‖, if both occur."""
    for name, guess in guesses.items():
        vector = vector_of(name, guesses) if guess.kind == "scalar" else None
        users = [each.display.line for each in formulas if name in each.outcome.symbols]
        if vector is not None and users:
            yield Proposed(name, rf"\|{vector}\|", users[0], f"{vector} has the same letter", False)


def vector_of(name: str, guesses: Mapping[str, Guess]) -> str | None:
    """Returns the vector in bold or under an arrow that has the same letter."""
    vectors = (each.name for each in guesses.values() if each.kind == "vector" and each.name != name)
    return next((each for each in vectors if without_bold(each) == name), None)


def each_once(proposed: Iterable[Proposed]) -> list[Proposed]:
    """Returns the first proposal for each symbol."""
    first: dict[str, Proposed] = {}
    for each in proposed:
        first.setdefault(each.name, each)
    return list(first.values())


def in_order_of_use(proposed: Sequence[Proposed]) -> list[Proposed]:
    """Returns the proposals with each after those of the symbols in its body.

    The one that comes last in the text of several that define each other in a circle is left out.
    """
    walker = Walker()
    names = {each.symbol for each in proposed}
    uses = {
        each.symbol: {name for tree in operations_of(each.body, walker) for name in tree.names} & names
        for each in sorted(proposed, key=lambda each: each.line)
    }
    kept: dict[str, set[str]] = {}
    for name, own in uses.items():
        reached, waiting = set(own), list(own)
        while waiting:
            more = kept.get(waiting.pop(), set()) - reached
            reached |= more
            waiting += more
        if name not in reached:
            kept[name] = own
    order = TopologicalSorter({name: sorted(own & kept.keys()) for name, own in kept.items()}).static_order()
    by_name = {each.symbol: each for each in proposed}
    return [by_name[name] for name in order]


def in_sentences(
    formulas: Iterable[Formula], shown: Mapping[str, int], inline: Sequence[Display] = ()
) -> Iterator[tuple[Proposed, Formula]]:
    r"""Yields definitions that sentences give of display symbols: "where $L = J \omega$".

    A formula that is supposed or denied defines nothing, unless it presents a symbol: "for $V = x^T P x$".
    Behind the first display with the symbol, a formula defines it only behind "let" or "where". A value of
    numbers and π must stand behind these words, and before that display.

    shown: the line of the first display with each symbol.   inline: the formulas of all sentences.
    """
    for formula in formulas:
        if is_denied(formula.display):
            continue
        is_case = is_supposed(formula.display)
        for each in definitions_in([formula]):
            is_value = _VALUE.fullmatch(each.body) is not None
            is_late, is_said = formula.display.line > shown.get(each.name, 0), is_let(formula.display)
            defines = is_said and not is_late if is_value else is_said or not is_late
            if is_case:
                defines = not is_late and _presents(formula, each, inline)
            if each.name in shown and defines:
                yield replace(each, why="a sentence says so", in_sentence=True), formula


def _presents(formula: Formula, proposed: Proposed, inline: Sequence[Display]) -> bool:
    """True if a supposition is the first formula with its symbol, and gives it by an operation on others."""
    own = formula.display
    is_plain = _VALUE.fullmatch(proposed.body) or not any(
        isinstance(said.right, Apply | Block) for said in _relations(formula)
    )
    if is_plain or not is_presented(own):
        return False
    key = re.compile(re.escape(latex_key(proposed.name)) + "(?![A-Za-z])")
    before = (each for each in inline if each.source is own.source and each.start < own.start)
    return not any(key.search(latex_key(each.latex)) for each in before)

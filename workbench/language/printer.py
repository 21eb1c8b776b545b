"""Terms to canonical LaTeX; reading it gives the same term back."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from contextvars import ContextVar
from dataclasses import dataclass
from typing import TYPE_CHECKING

from workbench.language import latex
from workbench.language.construct import integer
from workbench.language.integers import Linear
from workbench.language.operators import GRADIENTS, OPERATORS, command_of
from workbench.language.shapes import multiple
from workbench.language.symbols import may_be_label
from workbench.language.terms import (
    Apply,
    BigSum,
    Block,
    Conjunction,
    Counting,
    Derivative,
    DualUnit,
    Equivalence,
    Extremum,
    Identity,
    Implication,
    Integer,
    Naming,
    Number,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
    is_accented_symbol,
)
from workbench.language.vocabulary import written

if TYPE_CHECKING:
    from workbench.language.hand import Hand
    from workbench.language.notations import Notation

# How tightly a text holds together.
_SUM, _INFIX, _PRODUCT, _FACTOR, _ATOM = range(5)

_ZEROS = {"scalar": "0", "vector": "\\mathbf{0}", "tensor": "\\mathbf{0}_{3 \\times 3}"}
_ZEROS["covector"] = "\\mathbf{0}_{1 \\times 3}"

_hand: ContextVar[Hand | None] = ContextVar("hand", default=None)


@contextmanager
def in_the_hand_of(author: Hand) -> Iterator[None]:
    """Within, terms are printed as the author of a paper writes them."""
    token = _hand.set(None if author.is_plain else author)
    try:
        yield
    finally:
        _hand.reset(token)


def to_latex(formula: Term | Statement) -> str:
    """The formula as LaTeX: what a person checks the reading against."""
    match formula:
        case Relation(operator=operator):
            sign = {"=": "=", "≠": "\\neq", "≈": "\\approx"}[operator]
            left, right = _beside((formula.left, formula.right))
            return f"{left.text} {sign} {right.text}"
        case Equivalence():
            return f"{to_latex(formula.left)} \\Leftrightarrow {to_latex(formula.right)}"
        case Implication():
            left = formula.left.parts if isinstance(formula.left, Conjunction) else (formula.left,)
            premises = latex.AND.join(map(to_latex, left))
            if isinstance(formula.right, Equivalence | Implication):
                return f"{to_latex(formula.right)}{latex.FOR}{premises}"
            return f"{premises} \\Rightarrow {to_latex(formula.right)}"
        case Conjunction(parts=parts):
            return _chain(parts)
        case Extremum():
            return _extremum(formula)
        case Naming():
            return formula.said
    return _print(formula).text


def _chain(parts: tuple[Statement, ...]) -> str:
    """a = b = c if each part goes on where the last one ended, else the parts side by side."""
    texts = [to_latex(part) for part in parts]
    if not all(isinstance(part, Relation) for part in parts):
        return latex.BESIDE.join(texts)
    text = texts[0]
    for before, part, alone in zip(parts, parts[1:], texts[1:], strict=False):
        right = _beside((before.left, before.right))[1].text
        goes_on = alone.startswith(right + " ") and _beside((part.left, part.right))[0].text == right
        joint = latex.BESIDE if before.operator == part.operator == "=" else latex.AND
        text += alone[len(right) :] if goes_on else joint + alone
    return text


def _extremum(said: Extremum) -> str:
    letters = ", ".join(f"{_symbol(x).text} \\in {_domain(x)}" for x in said.letters)
    body = _print(said.body).at_least(_INFIX)
    return f"{latex.extremal(said.least, letters)} {body} = {_print(said.value).text}"


def _domain(letter: Symbol) -> str:
    if letter.declaration.unit:
        return "\\mathbb{S}^{2}"
    return "\\mathbb{R}" if letter.type.kind == "scalar" else "\\mathbf{V}_{3}"


@dataclass(frozen=True, slots=True)
class _Text:
    """LaTeX, how tightly it holds, and what it would take in at its end: "function" (det A, which would take
    the next tensor), "sum" (Σ …, which takes all that follows), "symbol" (which may take a bracket as its
    arguments), or nothing."""

    text: str
    level: int
    end: str = ""

    def at_least(self, level: int) -> str:
        return self.text if self.level >= level else _bracket(self.text)


def _bracket(text: str) -> str:
    return f"\\left({text}\\right)"


def _square(text: str) -> str:
    """The text with the bracket that it begins with made square: after a symbol a round one may be its
    arguments."""
    if not text.startswith("\\left("):
        return text
    depth = 0
    for match in re.finditer(r"\\(left|right)(?![a-z])", text):
        depth += 1 if match[1] == "left" else -1
        if depth == 0:
            return f"\\left[{text[6 : match.end()]}]{text[match.end() + 1 :]}"
    raise ValueError(f"unbalanced brackets in {text}")


def _integer(value: Linear) -> str:
    """n−k+1 rather than −k+n+1."""
    rising = tuple((name, size) for name, size in value.coefficients if size > 0)
    falling = tuple((name, size) for name, size in value.coefficients if size < 0)
    return str(Linear(value.constant, rising + falling))


def _print(term: Term) -> _Text:
    return _declared(term) or _plain(term)


def _plain(term: Term) -> _Text:
    match term:
        case Number(value=value):
            return _number(value.numerator, value.denominator)
        case Integer(value=value):
            simple = value.constant == 0 and [c for _, c in value.coefficients] == [1]
            return _Text(_integer(value), _ATOM if simple else _SUM)
        case Counting():
            return _counting(term)
        case Zero():
            return _Text(_ZEROS.get(term.type.kind, "\\mathbf{0}"), _ATOM)
        case Identity():
            return _unit(term)
        case DualUnit():
            return _Text("\\varepsilon", _ATOM)
        case TimeOperator():
            return _Text("\\mathbf{D}", _ATOM)
        case Symbol():
            return _symbol(term)
        case Derivative():
            return _derivative(term)
        case Power():
            base = _print(term.base)
            if isinstance(term.base, Symbol) and may_be_label(term.base, term.exponent.constant):
                base = _Text(_bracket(base.text), _ATOM)
            return _raised(base, _integer(term.exponent))
        case BigSum():
            return _big_sum(term)
        case Block():
            return _Text(latex.matrix(_entries(term)), _ATOM)
        case Apply():
            return _apply(term)
    raise TypeError(f"no LaTeX for {type(term).__name__}")


def _unit(term: Identity) -> _Text:
    """The unit tensor, with its size where the sign for it is a symbol of the paper."""
    hand = _hand.get()
    size = f"{term.type.rows} \\times {term.type.columns}" if hand is not None and hand.owns_unit else None
    return _Text(latex.scripted("\\mathbf{I}", size), _ATOM)


def _number(numerator: int, denominator: int) -> _Text:
    if denominator == 1:
        return _Text(str(numerator), _ATOM if numerator >= 0 else _SUM)
    text = latex.fraction(str(abs(numerator)), str(denominator))
    return _Text(text, _FACTOR) if numerator >= 0 else _Text(f"-{text}", _SUM)


def _counting(term: Counting) -> _Text:
    top, *lower = map(_integer, term.arguments)
    if term.name == "factorial":
        simple = re.fullmatch(r"[0-9]+|[A-Za-z](_[0-9]|_\{[0-9]+\})?", top)
        return _Text(f"{top if simple else _bracket(top)}!", _FACTOR)
    return _Text(latex.binomial(top, ",".join(lower)), _FACTOR)


def _entries(term: Block) -> list[list[str]]:
    """A zero has its shape from its row and its column; where these have none, it is printed with it."""
    firm = [[multiple(entry) != "zero" for entry in row] for row in term.entries]
    in_row, in_column = [any(row) for row in firm], [any(column) for column in zip(*firm, strict=True)]
    return [
        [_entry(entry, in_row[i] and in_column[j]) for j, entry in enumerate(row)]
        for i, row in enumerate(term.entries)
    ]


def _entry(term: Term, has_shape: bool) -> str:
    if isinstance(term, Zero) and (has_shape or term.type.kind not in ("tensor", "covector")):
        return "0" if term.type.kind == "scalar" else "\\mathbf{0}"
    return _print(term).text


def _beside(terms: tuple[Term, ...]) -> list[_Text]:
    """Terms that must be of one kind: a zero beside another term needs no shape."""
    firm = any(not isinstance(t, Zero | Identity) for t in terms)
    plain = _Text("\\mathbf{0}", _ATOM)
    return [plain if firm and isinstance(t, Zero) and t.type.kind != "scalar" else _print(t) for t in terms]


# what the paper declares

#: How tightly a notation holds, by its form.
_FORMS = {"closed": _ATOM, "marked": _FACTOR, "infix": _INFIX, "open": _SUM}


def _declared(term: Term) -> _Text | None:
    """The term in the paper's own notation, if it has one that is read as this term."""
    hand = _hand.get()
    for entry, arguments in hand.spellings(term) if hand is not None else ():
        for text in _spelt(entry, arguments, term):
            if hand.reads(text.text, term):
                return text
    return None


def _spelt(entry: Notation, arguments: Mapping[str, Term], term: Term) -> Iterator[_Text]:
    """An accent over the letter alone; then with as few brackets as may do."""
    if entry.accent is not None and (text := _under_accents(term)) is not None:
        yield text
    printed = {letter: _print(argument) for letter, argument in arguments.items()}
    for level in (_PRODUCT, _FACTOR, _ATOM):
        levels = {"alone": _SUM, "beside": level, "marked": _ATOM}
        texts = {letter: text.at_least(levels[entry.places[letter]]) for letter, text in printed.items()}
        yield _Text(entry.spelt(texts), _FORMS[entry.form], "symbol" if entry.is_constant else "")


# symbols with their accents


def _symbol(term: Symbol) -> _Text:
    if term.arguments:
        arguments = ", ".join(_print(a).text for a in term.arguments)
        return _Text(f"{_accented(term)}{_bracket(arguments)}", _FACTOR)
    text = _accented(term)
    return _Text(text, _FACTOR if term.declaration.name.sup else _ATOM, "symbol")


def _accented(term: Symbol, accents: tuple[str, ...] = ()) -> str:
    """The symbol with accents (outermost first) over its letter alone."""
    return term.declaration.name.latex([_integer(place) for place in term.index], accents)


def _under_accents(term: Term, accents: tuple[str, ...] = ()) -> _Text | None:
    """Dots and tildes that stand directly over the letter of a symbol."""
    match term:
        case Symbol(arguments=()):
            level = _FACTOR if term.declaration.name.sup else _ATOM
            return _Text(_accented(term, accents), level, "symbol")
        case Apply() if (own := _accent_of(term)) is not None:
            accent, body = own
            return _under_accents(body, (*accents, accent))
        case Derivative(order=Linear(constant=order, coefficients=())) if 1 <= order <= 4:
            return _under_accents(term.body, (*accents, written("ACCENT", str(order))))
    return None


def _accent_of(term: Apply) -> tuple[str, Term] | None:
    """What stands over a letter for the operation, the paper's own accent or the tilde; and what is below."""
    hand = _hand.get()
    for entry, arguments in hand.spellings(term) if hand is not None else ():
        if entry.accent is not None:
            (body,) = arguments.values()
            text = _under_accents(body, (entry.accent,))
            if text is not None and hand.reads(text.text, term):
                return entry.accent, body
    is_tilde = term.head == "skew" and not _is_tilded(term.arguments[0])
    return ("\\tilde", term.arguments[0]) if is_tilde else None


def _is_tilded(term: Term) -> bool:
    """Whether a tilde over the term would make another symbol of it."""
    while isinstance(term, Derivative):
        term = term.body
    return isinstance(term, Symbol) and term.declaration.tilded


def _derivative(term: Derivative) -> _Text:
    return _under_accents(term) or _raised(_print(term.body), f"({_integer(term.order)})")


def _raised(base: _Text, sup: str) -> _Text:
    bare = base.level >= _ATOM
    return _Text(latex.scripted(base.at_least(_ATOM), sup=sup), _FACTOR, base.end if bare else "")


# operations


def _big_sum(term: BigSum) -> _Text:
    if term.lower is None:
        sign = latex.scripted("\\sum", f"{'+'.join(term.variables)}={_integer(term.upper)}")
    else:
        sign = latex.scripted("\\sum", f"{term.variables[0]}={_integer(term.lower)}", _integer(term.upper))
    return _Text(f"{sign} {_print(term.body).at_least(_INFIX)}", _INFIX, "sum")


def _apply(term: Apply) -> _Text:
    head, arguments = term.head, term.arguments
    operator = OPERATORS[head]
    if operator.superscript:
        base = _print(arguments[0])
        if head != "transpose" and _is_dotted(arguments[0]):
            base = _Text(_bracket(base.text), _ATOM)
        return _raised(base, operator.superscript)
    if operator.sign:
        left, right = map(_print, arguments)
        if left.end == "function" and (arguments[1].type.dual or _ends_in_gradient(arguments[0])):
            left = _Text(_bracket(left.text), _ATOM)
        return _infix(written("INFIX", operator.sign), left, right)
    match head:
        case "add":
            return _add(arguments)
        case "neg":
            return _Text(f"-{_negated(arguments[0])}", _SUM)
        case "mul":
            return _mul(*arguments)
        case "div":
            top, bottom = (_print(a).text for a in arguments)
            return _Text(latex.fraction(top, bottom), _FACTOR)
        case "partial" | "total":
            d = "\\partial" if head == "partial" else "\\mathrm{d}"
            body, by = (_print(a).at_least(_FACTOR) for a in arguments)
            return _Text(latex.fraction(f"{d} {body}", f"{d} {by}"), _FACTOR)
        case "norm":
            return _Text(f"\\left\\|{_print(arguments[0]).text}\\right\\|", _ATOM)
        case "triple":
            inner = ", ".join(_print(a).text for a in arguments)
            return _Text(f"\\left\\langle {inner}\\right\\rangle", _ATOM)
        case "root":
            return _Text(f"\\sqrt{{{_print(arguments[0]).text}}}", _FACTOR)
        case "quaternion" | "atan2":
            inner = ", ".join(_print(a).text for a in arguments)
            return _Text(f"{command_of(head)}{_bracket(inner)}", _FACTOR)
        case "skew" if not _is_tilded(arguments[0]):
            over = _under_accents(term)
            return over or _Text(f"\\widetilde{{{_print(arguments[0]).text}}}", _ATOM)
    return _function(head, arguments[0])


def _is_dotted(term: Term) -> bool:
    """Whether the term prints with dots over its letter; what is inverted has to be said there."""
    while isinstance(term, Apply) and term.head == "skew":
        (term,) = term.arguments
    return isinstance(term, Derivative)


def _function(head: str, argument: Term) -> _Text:
    simple = _under_accents(argument)
    if simple is not None:
        return _Text(f"{command_of(head)} {simple.text}", _PRODUCT, "function")
    return _Text(f"{command_of(head)}{_bracket(_print(argument).text)}", _FACTOR)


def _negated(argument: Term) -> str:
    """A bare number after a minus would be read as a negative number."""
    text = _print(argument)
    return _bracket(text.text) if isinstance(argument, Number | Integer) else text.at_least(_INFIX)


def _add(arguments: tuple[Term, ...]) -> _Text:
    text = ""
    for place, (argument, printed) in enumerate(zip(arguments, _beside(arguments), strict=True)):
        if isinstance(argument, Apply) and argument.head == "neg":
            inner = argument.arguments[0]
            negated = _print(inner).at_least(_INFIX) if place else _negated(inner)
            text += f" - {negated}" if place else f"-{negated}"
        elif place == 0:
            negative = isinstance(argument, Number) and argument.value < 0
            text = printed.text if negative else printed.at_least(_INFIX)
        elif isinstance(argument, Integer) and _integer(argument.value).startswith("-"):
            text += f" - {_print(integer(-argument.value)).at_least(_INFIX)}"
        else:
            text += f" + {printed.at_least(_INFIX)}"
    return _Text(text, _SUM)


def _infix(sign: str, left: _Text, right: _Text) -> _Text:
    before = _bracket(left.text) if left.end == "sum" else left.at_least(_PRODUCT)
    # what follows \sum is in the sum, so on the right it needs no bracket
    after = right.text if right.end == "sum" and right.level >= _INFIX else right.at_least(_PRODUCT)
    return _Text(f"{before} {sign} {after}", _INFIX, right.end if right.end == "sum" else "")


def _mul(left: Term, right: Term) -> _Text:
    first, second = _print(left), _print(right)
    is_open = first.end in ("function", "sum") or first.level < (_PRODUCT if _is_mul(left) else _FACTOR)
    if is_open or (isinstance(left, Number) and isinstance(right, Integer)):
        first = _Text(_bracket(first.text), _ATOM)
    may_end = second.end in ("function", "sum") and not _is_mul(right) and second.level >= _INFIX
    acts = left.type.kind == "operator" and right.type.kind not in ("operator", "scalar")
    mixed = isinstance(left, Number | Zero) and isinstance(right, Number)
    if acts or mixed or second.text[0].isdigit() or not (second.level >= _FACTOR or may_end):
        second = _Text(_bracket(second.text), _ATOM)
    if first.end == "symbol" or is_accented_symbol(left):
        second = _Text(_square(second.text), second.level, second.end)
    return _Text(f"{first.text} {second.text}", _PRODUCT, second.end)


def _ends_in_gradient(term: Term) -> bool:
    while _is_mul(term):
        term = term.arguments[1]
    return isinstance(term, Apply) and term.head in GRADIENTS


def _is_mul(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "mul"

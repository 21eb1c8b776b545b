"""The printer: terms to canonical LaTeX, which the reader reads back as the same term."""

from __future__ import annotations

import re

from workbench.core.construct import integer
from workbench.core.integer_expressions import Linear
from workbench.core.operations import OPERATORS, command_of
from workbench.core.shapes import multiple
from workbench.core.terms import (
    Apply,
    BigSum,
    Block,
    Conjunction,
    Counting,
    Derivative,
    DualUnit,
    Equivalence,
    Extremum,
    Head,
    Identity,
    Implication,
    Integer,
    Integral,
    Naming,
    Number,
    Power,
    Relation,
    Statement,
    Symbol,
    Term,
    TimeOperator,
    Zero,
)
from workbench.language.accented_symbols import is_accented_symbol
from workbench.language.grammar import latex_forms
from workbench.language.grammar.vocabulary import written
from workbench.language.naming.symbols import may_be_label
from workbench.language.printing import author_spelling
from workbench.language.printing.precedence_text import (
    ATOM,
    FACTOR,
    INFIX,
    PRODUCT,
    SUM,
    Text,
    bracket,
    square,
)
from workbench.language.printing.printed_shapes import ends_in_gradient, is_column, is_dotted, is_mul


def to_latex(formula: Term | Statement) -> str:
    """Returns the formula as canonical LaTeX, with which a person checks the reading."""
    match formula:
        case Relation(operator=operator):
            sign = {"=": "=", "≠": "\\neq", "≈": "\\approx"}[operator]
            left, right = _beside((formula.left, formula.right))
            return f"{left.text} {sign} {right.text}"
        case Equivalence():
            return f"{to_latex(formula.left)} \\Leftrightarrow {to_latex(formula.right)}"
        case Implication():
            before = formula.left.parts if isinstance(formula.left, Conjunction) else (formula.left,)
            premises = latex_forms.AND.join(to_latex(part) for part in before)
            if isinstance(formula.right, Equivalence | Implication):
                return f"{to_latex(formula.right)}{latex_forms.FOR}{premises}"
            return f"{premises} \\Rightarrow {to_latex(formula.right)}"
        case Conjunction(parts=parts):
            return _chain(parts)
        case Extremum():
            return _extremum(formula)
        case Naming():
            return formula.said
    return _print(formula).text


def _chain(parts: tuple[Statement, ...]) -> str:
    """Returns a = b = c if each part begins with the end of the last one, else the parts side by side."""
    texts = [to_latex(part) for part in parts]
    relations = [part for part in parts if isinstance(part, Relation)]
    if len(relations) < len(parts):
        return latex_forms.BESIDE.join(texts)
    text = texts[0]
    for before, part, alone in zip(relations, relations[1:], texts[1:], strict=False):
        right = _beside((before.left, before.right))[1].text
        goes_on = alone.startswith(right + " ") and _beside((part.left, part.right))[0].text == right
        joint = latex_forms.BESIDE if before.operator == part.operator == "=" else latex_forms.AND
        text += alone[len(right) :] if goes_on else joint + alone
    return text


def _extremum(said: Extremum) -> str:
    letters = ", ".join(f"{_symbol(x).text} \\in {_domain(x)}" for x in said.letters)
    body = _print(said.body).at_least(INFIX)
    return f"{latex_forms.extremal(said.least, letters)} {body} = {_print(said.value).text}"


def _domain(letter: Symbol) -> str:
    if letter.declaration.unit:
        return "\\mathbb{S}^{2}"
    return "\\mathbb{R}" if letter.type.kind == "scalar" else "\\mathbf{V}_{3}"


def _integer(value: Linear) -> str:
    """Returns n−k+1 rather than −k+n+1."""
    rising = tuple((name, size) for name, size in value.coefficients if size > 0)
    falling = tuple((name, size) for name, size in value.coefficients if size < 0)
    return str(Linear(value.constant, rising + falling))


def _print(term: Term) -> Text:
    return author_spelling.declared(term, _print, _under_accents) or _plain(term)


def _plain(term: Term) -> Text:
    match term:
        case Number(value=value):
            return _number(value.numerator, value.denominator)
        case Integer(value=value):
            simple = value.constant == 0 and [c for _, c in value.coefficients] == [1]
            return Text(_integer(value), ATOM if simple else SUM)
        case Counting():
            return _counting(term)
        case Zero():
            return Text(_zero(term), ATOM)
        case Identity():
            return _unit(term)
        case DualUnit():
            return Text("\\varepsilon", ATOM)
        case TimeOperator():
            return Text("\\mathbf{D}", ATOM)
        case Symbol():
            return _symbol(term)
        case Derivative():
            return _derivative(term)
        case Power():
            base = _print(term.base)
            if isinstance(term.base, Symbol) and may_be_label(term.base, term.exponent.constant):
                base = Text(bracket(base.text), ATOM)
            return _raised(base, _integer(term.exponent))
        case BigSum() | Integral():
            return _under_a_sign(term)
        case Block():
            return Text(latex_forms.matrix(_entries(term)), ATOM)
        case Apply():
            return _apply(term)
    raise TypeError(f"no LaTeX for {type(term).__name__}")


def _unit(term: Identity) -> Text:
    """Returns the unit tensor, with its size if that is printed, or if the paper uses the sign for a
    symbol."""
    author = author_spelling.author()
    is_taken = author is not None and author.owns_unit
    size = f"{term.type.rows} \\times {term.type.columns}" if is_taken else (term.printed or None)
    return Text(latex_forms.scripted("\\mathbf{I}", size), ATOM)


def _zero(term: Zero) -> str:
    """Returns the zero. A bare 𝟎 is a vector; next to operators and quaternions it is written so, too."""
    type_ = term.type
    if term.printed:
        return latex_forms.scripted("\\mathbf{0}", term.printed)
    if type_.kind == "scalar":
        return "0"
    has_size = type_.kind in ("covector", "tensor", "matrix")
    return latex_forms.scripted("\\mathbf{0}", f"{type_.rows} \\times {type_.columns}" if has_size else None)


def _number(numerator: int, denominator: int) -> Text:
    if denominator == 1:
        return Text(str(numerator), ATOM if numerator >= 0 else SUM)
    text = latex_forms.fraction(str(abs(numerator)), str(denominator))
    return Text(text, FACTOR) if numerator >= 0 else Text(f"-{text}", SUM)


def _counting(term: Counting) -> Text:
    top, *lower = map(_integer, term.arguments)
    if term.name == "factorial":
        simple = re.fullmatch(r"[0-9]+|[A-Za-z](_[0-9]|_\{[0-9]+\})?", top)
        return Text(f"{top if simple else bracket(top)}!", FACTOR)
    return Text(latex_forms.binomial(top, ",".join(lower)), FACTOR)


def _entries(term: Block) -> list[list[str]]:
    """Returns the printed entries. A zero whose row and column have no other entry is printed with its
    shape."""
    firm = [[multiple(entry) != "zero" for entry in row] for row in term.entries]
    in_row, in_column = [any(row) for row in firm], [any(column) for column in zip(*firm, strict=True)]
    return [
        [_entry(entry, in_row[i] and in_column[j]) for j, entry in enumerate(row)]
        for i, row in enumerate(term.entries)
    ]


def _entry(term: Term, has_shape: bool) -> str:
    if isinstance(term, Zero) and not term.printed and has_shape and term.type.kind != "scalar":
        return "\\mathbf{0}"
    return _print(term).text


def _beside(terms: tuple[Term, ...]) -> list[Text]:
    """Returns the texts of terms of one kind; a zero next to another term is printed without its shape."""
    firm = any(not isinstance(t, Zero | Identity) for t in terms)
    plain = Text("\\mathbf{0}", ATOM)
    return [plain if firm and _is_bare_zero(t) else _print(t) for t in terms]


def _is_bare_zero(term: Term) -> bool:
    return isinstance(term, Zero) and not term.printed and term.type.kind != "scalar"


# Symbols with their accents.


def _symbol(term: Symbol) -> Text:
    if term.arguments:
        arguments = ", ".join(_print(a).text for a in term.arguments)
        return Text(f"{_accented(term)}{bracket(arguments)}", FACTOR)
    text = _accented(term)
    return Text(text, FACTOR if term.declaration.name.sup else ATOM, "symbol")


def _accented(term: Symbol, accents: tuple[str, ...] = ()) -> str:
    """Returns the symbol with accents (outermost first) over its letter only."""
    return term.declaration.name.latex([_integer(place) for place in term.index], accents)


def _under_accents(term: Term, accents: tuple[str, ...] = ()) -> Text | None:
    """Returns a term of dots and tildes directly over the letter of a symbol; None for other terms."""
    match term:
        case Symbol(arguments=()):
            level = FACTOR if term.declaration.name.sup else ATOM
            return Text(_accented(term, accents), level, "symbol")
        case Apply() if (own := _accent_of(term)) is not None:
            accent, body = own
            return _under_accents(body, (*accents, accent))
        case Derivative(order=Linear(constant=order, coefficients=())) if 1 <= order <= 4:
            return _under_accents(term.body, (*accents, written("ACCENT", str(order))))
    return None


def _accent_of(term: Apply) -> tuple[str, Term] | None:
    """Returns the accent of the operation, the paper's own or the tilde, and its argument; else None."""
    is_tilde = term.head == "skew" and not _is_tilded(term.arguments[0])
    return author_spelling.accent_of(term, _under_accents) or (
        ("\\tilde", term.arguments[0]) if is_tilde else None
    )


def _is_tilded(term: Term) -> bool:
    """True if a tilde over the term would make another symbol of it."""
    while isinstance(term, Derivative):
        term = term.body
    return isinstance(term, Symbol) and term.declaration.tilded


def _derivative(term: Derivative) -> Text:
    return _under_accents(term) or _raised(_print(term.body), f"({_integer(term.order)})")


def _raised(base: Text, sup: str) -> Text:
    bare = base.level >= ATOM
    return Text(latex_forms.scripted(base.at_least(ATOM), sup=sup), FACTOR, base.end if bare else "")


# Operations.


def _under_a_sign(term: BigSum | Integral) -> Text:
    if isinstance(term, Integral):
        return _integral(term)
    if term.lower is None:
        sign = latex_forms.scripted("\\sum", f"{'+'.join(term.variables)}={_integer(term.upper)}")
    else:
        below = f"{term.variables[0]}={_integer(term.lower)}"
        sign = latex_forms.scripted("\\sum", below, _integer(term.upper))
    return Text(f"{sign} {_print(term.body).at_least(INFIX)}", PRODUCT, "sum")


def _integral(term: Integral) -> Text:
    body = _print(term.body).at_least(PRODUCT if term.measure else INFIX)
    behind = f" \\, {term.measure}" if term.measure else ""
    return Text(f"{term.sign} {body}{behind}", PRODUCT, "" if term.measure else "sum")


def _apply(term: Apply) -> Text:
    head, arguments = term.head, term.arguments
    if head == "transpose" and is_column(arguments[0]):
        return _plain(arguments[0])
    operator = OPERATORS[head]
    if operator.superscript:
        base = _print(arguments[0])
        if head != "transpose" and is_dotted(arguments[0]):
            base = Text(bracket(base.text), ATOM)
        return _raised(base, operator.superscript)
    if operator.sign:
        return _product_with(operator.sign, *arguments)
    match head:
        case "add":
            return _add(arguments)
        case "neg":
            return Text(f"-{_negated(arguments[0])}", SUM)
        case "mul":
            return _mul(*arguments)
        case "div":
            top, bottom = (_print(a).text for a in arguments)
            return Text(latex_forms.fraction(top, bottom), FACTOR)
        case "partial" | "total":
            d = "\\partial" if head == "partial" else "\\mathrm{d}"
            body, by = (_print(a).at_least(FACTOR) for a in arguments)
            return Text(latex_forms.fraction(f"{d} {body}", f"{d} {by}"), FACTOR)
        case "norm":
            return Text(f"\\left\\|{_print(arguments[0]).text}\\right\\|", ATOM)
        case "triple":
            inner = ", ".join(_print(a).text for a in arguments)
            return Text(f"\\left\\langle {inner}\\right\\rangle", ATOM)
        case "pow" | "root":
            return _power(*map(_print, arguments))
        case "quaternion" | "atan2":
            inner = ", ".join(_print(a).text for a in arguments)
            return Text(f"{command_of(head)}{bracket(inner)}", FACTOR)
        case "skew" if not _is_tilded(arguments[0]):
            over = _under_accents(term)
            return over or Text(f"\\widetilde{{{_print(arguments[0]).text}}}", ATOM)
    return _function(head, arguments[0])


def _power(base: Text, exponent: Text | None = None) -> Text:
    return Text(f"\\sqrt{{{base.text}}}", FACTOR) if exponent is None else _raised(base, exponent.text)


def _product_with(sign: str, left: Term, right: Term) -> Text:
    before = _print(left)
    if before.end == "function" and (right.type.dual or ends_in_gradient(left)):
        before = Text(bracket(before.text), ATOM)
    return _infix(written("INFIX", sign), before, _print(right))


def _function(head: Head, argument: Term) -> Text:
    simple = _under_accents(argument)
    if simple is not None:
        return Text(f"{command_of(head)} {simple.text}", PRODUCT, "function")
    return Text(f"{command_of(head)}{bracket(_print(argument).text)}", FACTOR)


def _negated(argument: Term) -> str:
    """Returns the argument of a minus; a bare number gets a bracket, since it would be read as a negative
    number."""
    text = _print(argument)
    return bracket(text.text) if isinstance(argument, Number | Integer) else text.at_least(INFIX)


def _add(arguments: tuple[Term, ...]) -> Text:
    text = ""
    for place, (argument, printed) in enumerate(zip(arguments, _beside(arguments), strict=True)):
        if isinstance(argument, Apply) and argument.head == "neg":
            inner = argument.arguments[0]
            negated = _print(inner).at_least(INFIX) if place else _negated(inner)
            text += f" - {negated}" if place else f"-{negated}"
        elif place == 0:
            negative = isinstance(argument, Number) and argument.value < 0
            text = printed.text if negative else printed.at_least(INFIX)
        elif isinstance(argument, Integer) and _integer(argument.value).startswith("-"):
            text += f" - {_print(integer(-argument.value)).at_least(INFIX)}"
        else:
            text += f" + {printed.at_least(INFIX)}"
    return Text(text, SUM)


def _infix(sign: str, left: Text, right: Text) -> Text:
    before = bracket(left.text) if left.end == "sum" else left.at_least(PRODUCT)
    return Text(f"{before} {sign} {right.at_least(PRODUCT)}", INFIX, right.end if right.end == "sum" else "")


def _mul(left: Term, right: Term) -> Text:
    first, second = _print(left), _print(right)
    is_open = first.end in ("function", "sum") or first.level < (PRODUCT if is_mul(left) else FACTOR)
    if is_open or (isinstance(left, Number) and isinstance(right, Integer)):
        first = Text(bracket(first.text), ATOM)
    may_end = second.end in ("function", "sum") and not is_mul(right) and second.level >= PRODUCT
    acts = left.type.kind == "operator" and right.type.kind not in ("operator", "scalar")
    mixed = isinstance(left, Number | Zero) and isinstance(right, Number)
    if acts or mixed or second.text[0].isdigit() or not (second.level >= FACTOR or may_end):
        second = Text(bracket(second.text), ATOM)
    if first.end == "symbol" or is_accented_symbol(left):
        second = Text(square(second.text), second.level, second.end)
    return Text(f"{first.text} {second.text}", PRODUCT, second.end)

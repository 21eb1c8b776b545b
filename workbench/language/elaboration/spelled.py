"""Names that authors write with several letters: \\Delta t is one symbol, \\mathbf{pq} two."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

from workbench.core import construct
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import Fault, TypeMismatch
from workbench.core.names import ACCENTS, Name
from workbench.core.terms import Term
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Group,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    core,
    is_function,
    is_left_script,
    unstyled,
)
from workbench.language.grammar.vocabulary import FONTS
from workbench.language.naming.scope import Scope
from workbench.language.naming.spelling import in_a_word, prefixed


def spelled_out(scope: Scope, items: Sequence[Node]) -> list[Node]:
    """Returns the items, each a factor or a sign."""
    after = [*items[1:], None]
    bare = [part for item, next_ in zip(items, after, strict=True) for part in _without_braces(item, next_)]
    letters = [part for item in bare for part in letters_in_one_font(item)]
    letters = [part for item in letters for part in _before_exponential(scope, item)]
    return _with_words(scope, _with_prefixes(scope, letters))


def _without_braces(item: Node, following: Node | None) -> Sequence[Node]:
    """Returns {\\mathbf{A}} and {{}^1 x} before a bracket as the symbols without braces."""
    match item:  # {a b}_1 prints a b_1, and {a (b)}^T a (b)^T
        case Scripted(nucleus=Group(parts=(Product(items=(*first, last)),)), primes=0):
            if isinstance(last, Bracket) if item.sub is None else item.sup is None and _is_bare_letter(last):
                return (*first, replace(item, nucleus=last))
    behind = following.nucleus if isinstance(following, Scripted) else following
    if isinstance(item, Group) and isinstance(behind, Bracket):
        match core(item):
            case Product(items=(left, body)) if is_left_script(left):
                return left, body
            case Leaf(kind="LETTER") | Styled() | Accented() | Scripted() as name:
                return (name,)
    return (item,)


def _before_exponential(scope: Scope, item: Node) -> Sequence[Node]:
    """Returns R e^x for Re^x, if R is a symbol: the real part takes no power."""
    match item:
        case Scripted(nucleus=Leaf(kind="FUNCTION", name="Re", bare=True, at=at), sub=None, sup=Node()):
            if scope.knows("R") and "Re" not in scope.table.conventions.functions:
                return Leaf(at, "LETTER", "R"), replace(item, nucleus=Leaf(at + 1, "LETTER", "e"))
    return (item,)


def _is_bare_letter(node: Node) -> bool:
    inner = unstyled(node)[1]
    return isinstance(inner, Leaf) and inner.kind == "LETTER"


def letters_in_one_font(item: Node) -> Iterator[Node]:
    """Yields \\mathbf{p} \\mathbf{q}^* for \\mathbf{pq}^*: no symbol has two letters in one font. The hat of
    \\hat{pq} stands over the product."""
    inner: Any = item.nucleus if isinstance(item, Scripted) else item
    body = core(inner.body) if isinstance(inner, Styled) and inner.style in FONTS else None
    if not isinstance(body, Product) or not all(_is_letter(part) for part in body.items):
        yield item
        return
    *first, last = (Styled(part.at, inner.style, part) for part in body.items)
    yield from first
    yield replace(item, nucleus=last) if isinstance(item, Scripted) else last


def _is_letter(node: Node) -> bool:
    inner = node.nucleus if isinstance(node, Scripted) else node
    return isinstance(inner, Leaf) and inner.kind == "LETTER"


def _with_prefixes(scope: Scope, items: Sequence[Node]) -> list[Node]:
    found: list[Node] = []
    for item in items:
        if found and (joined := _prefixed(scope, found[-1], item)) is not None:
            found[-1] = joined
        else:
            found.append(item)
    return found


def _prefixed(scope: Scope, before: Node, item: Node) -> Node | None:
    """Returns \\Delta and t as the symbol \\Delta t, if it is one; else None."""
    joined = prefixed(before, item)
    return joined if joined is not None and scope.table.has_prefixed(*_styled_letter(joined)) else None


def _with_words(scope: Scope, items: Sequence[Node]) -> list[Node]:
    """Returns the items with DV as a symbol of two letters, if it is declared."""
    found: list[Node] = []
    place = 0
    while place < len(items):
        ends = range(min(place + scope.table.longest_word, len(items)), place + 1, -1)
        words = ((word_of(scope, items[place:end]), end) for end in ends)
        known = ((word, end) for word, end in words if word is not None)
        word, end = next(known, (items[place], place + 1))
        found.append(word)
        place = end
    return found


def word_of(scope: Scope, items: Sequence[Node], styles: tuple[str, ...] = ()) -> Node | None:
    """Returns the letters, or a \\Delta before one, as one symbol, else None. Raises Fault if each letter is
    a symbol, too."""
    if not styles and len(items) == 2 and (joined := _prefixed(scope, *items)) is not None:
        return joined
    word = in_a_word(items) if scope.table.longest_word > 1 else None
    if word is None or not ACCENTS.isdisjoint(styles):  # \\vec{AB'} is a name with everything in it
        return None
    own, letters = _styled_letter(word)
    if not scope.table.has_letter(Name.styled((*styles, *own), letters).base):
        return None
    if not (styles or own) and all(map(scope.knows, letters)):
        which = f"one symbol, or the product of {' and '.join(letters)}"
        raise Fault(SyntaxCode.LETTERS_OR_NAME(letters=letters, which=which), word.at)
    return word


def _styled_letter(node: Node) -> tuple[tuple[str, ...], str]:
    styles: tuple[str, ...] = ()
    while not isinstance(node, Leaf):
        match node:
            case Styled(style=style, body=body):
                styles, node = (*styles, style), body
            case Accented(body=body) | Scripted(nucleus=body) | Group(parts=(body,)):
                node = body
            case _:
                return styles, ""
    return styles, node.text


def subscripted_norm(scope: Scope, node: Node, sub: Node) -> Term | None:
    """Returns \\|x\\|_2 of a column and \\|A\\|_F, which is \\sqrt{\\operatorname{tr} A^T A}; else None."""
    letter = core(sub)
    if not isinstance(node, Bracket) or node.kind not in ("|", "\\|") or len(node.parts) != 1:
        return None
    if not isinstance(letter, Leaf) or letter.text not in ("2", "F"):
        return None
    body = scope.term(node.parts[0])
    is_column = body.type.columns == 1
    if body.type.rows == 1 or is_column != (letter.text == "2"):
        return None
    if is_column:
        return construct.apply("norm", body)
    square = scope.apply(node.at, "mul", scope.apply(node.at, "transpose", body), body)
    return scope.apply(node.at, "root", scope.apply(node.at, "trace", square))


def refuse_row_of_vectors(scope: Scope, row: Product) -> None:
    """Raises Fault for [a \\, b \\, c], which contains no product."""
    if len(row.items) > 1 and all(_is_vector(scope, item) for item in row.items):
        message = SyntaxCode.COLUMNS_OR_TRIPLE_PRODUCT()
        raise Fault(message, row.at)


def _is_vector(scope: Scope, node: Node) -> bool:
    _, nucleus = unstyled(node.nucleus if isinstance(node, Scripted) else node)
    if not isinstance(nucleus.body if isinstance(nucleus, Accented) else nucleus, Leaf | Styled):
        return False
    try:
        return not is_function(node) and scope.term(node).type.kind == "vector"
    except (Fault, TypeMismatch):
        return False

"""How a symbol is spelled: canonical LaTeX with its integer indices taken out."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import dataclass, replace

from workbench.language.errors import Fault
from workbench.language.integers import Linear
from workbench.language.syntax import Bracket, Group, Infix, Leaf, Node, Product, Scripted, Styled, Sum
from workbench.language.vocabulary import SIGN_COMMANDS

#: Indices, orders and exponents beyond this are refused.
LARGEST_INTEGER = 1000

#: The letters that are index places in a declared name.
INDEX_LETTERS = frozenset("ijklmnp")

#: Superscripts that mean the transpose.
TRANSPOSES = frozenset({"T", "\\mathrm{T}", "\\mathsf{T}"})

_OUTERMOST_FIRST = (
    "\\underline",
    "\\overline",
    "\\bar",
    "\\vec",
    "\\hat",
    "\\check",
    "\\breve",
    "\\mathring",
)
_CLOSING = {"(": ")", "[": "]", "\\{": "\\}", "\\langle": "\\rangle", "|": "|", "\\|": "\\|"}

#: A piece of a spelling: text, or an integer that may be an index.
Piece = str | Linear


@dataclass(frozen=True, slots=True)
class Scripts:
    """What surrounds a letter."""

    left_sub: Node | None = None
    left_sup: Node | None = None
    sub: Node | None = None
    sup: Node | None = None
    primes: int = 0

    def without_sup(self) -> Scripts:
        return replace(self, sup=None)


def variable_name(node: Node) -> str | None:
    """k or k_1 as the name of an integer variable."""
    match node:
        case Leaf(kind="LETTER", text=text) if len(text) == 1:
            return text
        case Scripted(nucleus=Leaf(kind="LETTER", text=text), sub=sub, sup=None, primes=0, factorial=False):
            while isinstance(sub, Group) and len(sub.parts) == 1:
                sub = sub.parts[0]
            if len(text) == 1 and isinstance(sub, Leaf) and sub.kind == "NUMBER" and sub.text.isdigit():
                return f"{text}_{sub.text}" if len(sub.text) == 1 else f"{text}_{{{sub.text}}}"
    return None


def linear(node: Node, variables: Collection[str]) -> Linear | None:
    """The node as an integer expression in the variables; None if it is something else."""
    match node:
        case Leaf(kind="NUMBER", text=text) if text.isdigit() and (text == "0" or text[0] != "0"):
            if len(text) > 9 or int(text) > LARGEST_INTEGER:
                raise Fault(f"the integer {text[:20]} is too large here; at most {LARGEST_INTEGER}", node.at)
            return Linear(int(text))
        case Group(parts=(part,)) | Bracket(kind="(", parts=(part,)):
            return linear(part, variables)
        case Sum():
            total = Linear(0)
            for sign, _, addend in node.addends:
                value = linear(addend, variables)
                if value is None:
                    return None
                total = total - value if sign == "-" else total + value
            return total
        case Product(items=(Leaf(kind="NUMBER") as factor, other)):
            size, value = linear(factor, ()), linear(other, variables)
            return None if size is None or value is None or value.is_number else value * int(size)
    name = variable_name(node)
    return Linear.variable(name) if name in variables else None


def base_name(styles: Sequence[str], letter: str) -> str:
    """\\underline outermost, the font next to the letter, whatever the order in the source."""
    order = {style: place for place, style in enumerate(_OUTERMOST_FIRST)}
    text = letter
    for style in sorted(dict.fromkeys(styles), key=lambda s: order.get(s, len(order)), reverse=True):
        text = f"{style}{{{text}}}"
    return text


def spell(base: str, scripts: Scripts, variables: Collection[str]) -> list[Piece] | None:
    """The pieces of a name, in the order left scripts, letter, right scripts; None if it is no name."""
    pieces: list[Piece] = []
    if scripts.left_sub is not None or scripts.left_sup is not None:
        pieces.append("{}")
    parts = [("_{", scripts.left_sub), ("^{", scripts.left_sup), None]
    parts += [("_{", scripts.sub), ("^{", scripts.sup)]
    for part in parts:
        if part is None:
            pieces.append(base + "'" * scripts.primes)
        elif part[1] is not None:
            inner = _spell_script(part[1], variables)
            if inner is None:
                return None
            pieces += [part[0], *inner, "}"]
    return pieces


def _spell_script(node: Node, variables: Collection[str]) -> list[Piece] | None:
    while isinstance(node, Group) and len(node.parts) == 1:
        (node,) = node.parts
    value = None if isinstance(node, Bracket) else linear(node, variables)
    if value is not None:
        return [value]
    match node:
        case Leaf(kind="FUNCTION", name=name):
            return [" ".join(name if node.bare else (f"\\mathrm{{{letter}}}" for letter in name))]
        case Leaf():
            return [node.text]
        case Styled():
            inner = _spell_script(node.body, ())  # an upright n is a label
            return None if inner is None else [node.style, "{", *inner, "}"]
        case Group():
            return _spell_list(node.parts, ",", variables)
        case Bracket():
            inner = _spell_list(node.parts, ",", variables)
            return None if inner is None else [node.kind, *inner, _CLOSING[node.kind]]
        case Product():
            return _spell_list(node.items, " ", () if _is_word(node) else variables)
        case Scripted(sub=None, sup=None, primes=primes, factorial=False):
            inner = _spell_script(node.nucleus, ())
            return None if inner is None else [*inner, "'" * primes]
        case Scripted(sup=None, primes=0, factorial=False):
            inner = _spell_list((node.nucleus, node.sub), "_{", variables)
            return None if inner is None else [*inner, "}"]
        case Infix(operator=operator):
            return [SIGN_COMMANDS[operator]]
    return None


def _is_word(node: Product) -> bool:
    """Whether the letters are a word such as rel, not indices in a row such as i j."""
    letters = [item.text for item in node.items if isinstance(item, Leaf) and item.text.isalpha()]
    return len(letters) == len(node.items) and not INDEX_LETTERS.issuperset(letters)


def _spell_list(nodes: Sequence[Node], separator: str, variables: Collection[str]) -> list[Piece] | None:
    pieces: list[Piece] = []
    for place, node in enumerate(nodes):
        inner = _spell_script(node, variables)
        if inner is None:
            return None
        pieces += [separator, *inner] if place else inner
    return pieces


def literal(pieces: Sequence[Piece]) -> str:
    """The spelling as LaTeX, integers included."""
    return "".join(str(piece) for piece in pieces)


def candidates(pieces: Sequence[Piece]) -> list[tuple[str, tuple[Linear, ...]]]:
    """The declared names that the spelling may mean, each with the indices it then has: exact name first,
    then with more and more of its integers as indices (marked @)."""
    places = [i for i, piece in enumerate(pieces) if isinstance(piece, Linear)][:6]
    choices = sorted(range(2 ** len(places)), key=lambda choice: (choice.bit_count(), choice))
    found = []
    for choice in choices:
        as_index = {place for bit, place in enumerate(places) if choice >> bit & 1}
        text = "".join("@" if i in as_index else str(piece) for i, piece in enumerate(pieces))
        found.append((text, tuple(pieces[i] for i in sorted(as_index))))
    return found


def names_of_key(pieces: Sequence[Piece]) -> tuple[str, tuple[Linear, ...]]:
    """A declared name and the expressions in its index places: those that contain an index letter."""
    index = tuple(piece for piece in pieces if isinstance(piece, Linear) and not piece.is_number)
    text = "".join(
        "@" if isinstance(piece, Linear) and not piece.is_number else str(piece) for piece in pieces
    )
    return text, index

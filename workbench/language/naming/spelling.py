"""Spellings of symbols: the letter and scripts as in the source, and the names that they may mean."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.formula_errors import SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import ACCENTS, NABLA, PREFIXES, SCRIPTS, Name
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.syntax import (
    Accented,
    Bracket,
    Chain,
    Group,
    Infix,
    Leaf,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
    unstyled,
)
from workbench.language.grammar.vocabulary import CLOSING, FONTS, written
from workbench.language.naming.linear_indices import linear, linear_or_none

#: Letters that are index slots in a declared name.
INDEX_LETTERS = frozenset("ijklmnp")

#: Superscripts that mean the transpose.
TRANSPOSES = frozenset({"T", "\\mathrm{T}", "\\mathsf{T}"})

#: A part of a script: text, or an integer that may be an index.
Piece = str | Linear

#: A name with the contents of its index slots.
Named = tuple[Name, tuple[Linear, ...]]


@dataclass(frozen=True, slots=True)
class Scripts:
    """The scripts and primes of a letter."""

    left_sub: Node | None = None
    left_sup: Node | None = None
    sub: Node | None = None
    sup: Node | None = None
    primes: int = 0

    def without_sup(self) -> Scripts:
        return self if self.sup is None else replace(self, sup=None)


def prefix_of(node: Node) -> str | None:
    """Returns \\Delta, or \\nabla_{x,y}, which forms a symbol with the next letter; None for other nodes."""
    match node:
        case Leaf(text=text) if text in PREFIXES:
            return text
        case Scripted(nucleus=Leaf(text=text), sub=Node(), sup=None, primes=0) if text == NABLA:
            return latex_of(node)
    return None


def prefixed(prefix: Node, node: Node) -> Node | None:
    """Returns \\Delta and t as the one symbol \\Delta t; None if no letter follows."""
    text = prefix_of(prefix)
    if isinstance(node, Scripted):
        nucleus = prefixed(prefix, node.nucleus)
        return None if nucleus is None else replace(node, at=prefix.at, nucleus=nucleus)
    inner = core(node)
    is_letter = isinstance(inner, Styled | Accented) or (isinstance(inner, Leaf) and inner.kind == "LETTER")
    return Styled(prefix.at, text, node) if is_letter and text is not None else None


def in_a_word(items: Sequence[Node]) -> Node | None:
    """Returns D and V, or V_1, without space between them, as the one symbol DV; None for other items."""
    *first, last = items
    letters = [*first, last.nucleus if isinstance(last, Scripted) else last]
    styles, leaves = zip(*map(_in_fonts, letters), strict=True)
    is_word = len(leaves) > 1 and len({*styles}) == 1 and all(map(_is_plain_letter, leaves))
    if not is_word or any(one.at + 1 != other.at for one, other in pairwise(leaves)):
        return None
    word: Node = Leaf(items[0].at, "LETTER", "".join(leaf.text for leaf in leaves))
    for style in reversed(styles[0]):
        word = Styled(items[0].at, style, word)
    return replace(last, at=items[0].at, nucleus=word) if isinstance(last, Scripted) else word


def _in_fonts(node: Node) -> tuple[tuple[str, ...], Node]:
    styles, letter = unstyled(node)
    return (styles, letter) if FONTS.issuperset(styles) else ((), node)


def _is_plain_letter(node: Node) -> bool:
    return isinstance(node, Leaf) and node.kind == "LETTER" and node.text.isascii() and node.text.isalpha()


@dataclass(frozen=True, slots=True)
class Spelling:
    """A letter as written, with its scripts in pieces; it is open which of their integers are indices."""

    letter: Name
    scripts: tuple[tuple[str, tuple[Piece, ...]], ...]

    @property
    def places(self) -> list[Linear]:
        return [piece for _, pieces in self.scripts for piece in pieces if isinstance(piece, Linear)]

    def named(self, is_index: Sequence[bool]) -> Named:
        """Returns the name and its indices; `is_index` tells for each integer whether it is an index."""
        places, index = iter(is_index), list[Linear]()
        made: dict[str, Any] = {}
        for field, pieces in self.scripts:
            texts = [""]
            for piece in pieces:
                if isinstance(piece, Linear) and next(places):
                    index.append(piece)
                    texts.append("")
                else:
                    texts[-1] += str(piece)
            made[field] = tuple(texts)
        return replace(self.letter, **made) if made else self.letter, tuple(index)

    def exchanged(self, texts: Mapping[str, str]) -> Spelling:
        """Returns the spelling with other letters and labels: T_{0e} and T_{01} from T_{FG}."""
        scripts = (
            (field, _with_figures_together([texts.get(p, p) if isinstance(p, str) else p for p in pieces]))
            for field, pieces in self.scripts
        )
        letter = texts.get(self.letter.letter, self.letter.letter)
        return Spelling(replace(self.letter, letter=letter), tuple(scripts))

    @property
    def exact(self) -> Name:
        """The name in which no integer is an index."""
        return self.named([False] * len(self.places))[0]

    def declared(self) -> Named:
        """Returns the name of a declaration: letters are index slots, numbers belong to the name."""
        return self.named([not place.is_number for place in self.places])

    def candidates(self) -> list[Named]:
        """Returns the possible names with their indices, in order of preference.

        The exact name comes first, then names with more and more of the integers as indices. x_{12} is
        preferably a member of x_{ij}, then one of x_i, and x_{1 2} may be an exact x_{12}.
        """
        count = len(self.places)
        choices = sorted(range(2 ** min(count, 6)), key=lambda choice: (choice.bit_count(), choice))
        first, *others = [self.named([bool(choice >> bit & 1) for bit in range(count)]) for choice in choices]
        regrouped = [*self._regrouped()]
        return [first, *regrouped, *others] if count == 1 else [first, *others, *regrouped]

    def _regrouped(self) -> Iterator[Named]:
        """Yields names with other separators between the indices of a script: 12 for 1 2, and both for
        1,2."""
        for field, pieces in self.scripts:
            parts: Sequence[Linear] = [piece for piece in pieces[::2] if isinstance(piece, Linear)]
            between = {*pieces[1::2]}
            if not parts or len(parts) < len(pieces[::2]) or not between <= {" ", ","}:
                continue
            if not between:
                parts = _apart(parts[0])
            elif all(part.is_number and part.constant < 10 for part in parts):
                yield replace(self, scripts=self._with(field, ["".join(map(str, parts))])).exact, ()
            for sign in (" ", ",") if len(parts) > 1 else ():
                apart = [piece for part in parts for piece in (sign, part)][1:]
                other = replace(self, scripts=self._with(field, apart))
                yield other.named([True] * len(other.places))

    def _with(self, field: str, pieces: Sequence[Piece]) -> tuple[tuple[str, tuple[Piece, ...]], ...]:
        return tuple((own, tuple(pieces) if own == field else kept) for own, kept in self.scripts)

    def __str__(self) -> str:
        return str(self.exact)


def _apart(index: Linear) -> Sequence[Linear]:
    """Returns the single indices: 1 and 2 for 12, 2 and j for 2j."""
    match index.coefficients:
        case () if index.constant > 9:
            return [Linear(int(figure)) for figure in str(index)]
        case ((name, factor),) if 1 < factor < 10 and not index.constant:
            return [Linear(factor), Linear.variable(name)]
    return [index]


def _with_figures_together(pieces: Sequence[Piece]) -> tuple[Piece, ...]:
    """Returns the pieces with adjacent figures joined: 0 and 1 to 01."""
    figures = [isinstance(piece, str) and piece.isdigit() and len(piece) == 1 for piece in pieces]
    apart = (
        figures[max(place - 1, 0)] and figures[min(place + 1, len(pieces) - 1)]
        for place in range(len(pieces))
    )
    return tuple(piece for piece, between in zip(pieces, apart, strict=True) if piece != " " or not between)


def spell(letter: Name, scripts: Scripts, variables: Collection[str]) -> Spelling | None:
    """Returns the spelling of a letter with its scripts; None if it is not a name."""
    found = []
    for field in SCRIPTS:
        node = getattr(scripts, field)
        if node is not None:
            pieces = _spell_script(node, variables)
            if pieces is None:
                return None
            found.append((field, tuple(pieces)))
    primed = replace(letter, primes=scripts.primes) if scripts.primes != letter.primes else letter
    return Spelling(primed, tuple(found))


@dataclass(frozen=True, slots=True)
class Pair:
    """Labels that form one name: [BN], a matrix of two frames, \\vec{AB}, from A to B, and \\vec{abc}.

    styles: those over all labels; none for [BN].
    """

    labels: tuple[str, ...]
    styles: tuple[str, ...] = ()

    @property
    def name(self) -> Name:
        first = self.labels[0]
        ends_in_word = first.startswith("\\") and first[-1].isalpha()
        both = (" " if ends_in_word else "").join(self.labels)
        return Name.styled(self.styles, both) if self.styles else Name(f"[{both}]")

    def exchanged(self, texts: Mapping[str, str]) -> Pair:
        """Returns the pair with other labels."""
        return replace(self, labels=tuple(texts.get(label, label) for label in self.labels))


def in_bracket(node: Node) -> Pair | None:
    """Returns the pair of [BN] and [BN(t)]; None for other nodes."""
    match node:
        case Bracket(kind="[", parts=(part,)) if isinstance(inner := core(part), Product):
            *letters, last = inner.items
            is_of_time = isinstance(last, Bracket) and _spell_script(last, ()) == ["(", "t", ")"]
            return _pair(letters if is_of_time else inner.items)
    return None


def under_accent(node: Node, styles: tuple[str, ...] = ()) -> Pair | None:
    """Returns the pair of \\vec{AB}, or of AB under these styles; None for other nodes."""
    inner = core(node)
    if isinstance(inner, Styled):
        return under_accent(inner.body, (*styles, inner.style))
    return _pair(inner.items, styles) if isinstance(inner, Product) and ACCENTS & {*styles} else None


def _pair(nodes: Sequence[Node], styles: tuple[str, ...] = ()) -> Pair | None:
    scripts = [_spell_script(each, ()) for each in nodes]
    spelled = [pieces for pieces in scripts if pieces is not None]
    if (len(nodes) != 2 and not styles) or not all(map(_is_label, nodes)) or len(spelled) < len(nodes):
        return None
    return Pair(tuple("".join(map(str, pieces)) for pieces in spelled), styles)


def _is_label(node: Node) -> bool:
    inner = node.nucleus if isinstance(node, Scripted) and not node.sup else node
    while isinstance(inner, Styled):
        inner = core(inner.body)
    return isinstance(inner, Leaf) and inner.kind == "LETTER"


def refuse_operation(name: Name, key: str) -> None:
    """Raises SpecError for a superscript that is an operation; 0 and 1 are labels, since nobody prints these
    powers."""
    sup, meaning = "n".join(name.sup), None
    if sup in TRANSPOSES:
        meaning = "the transpose"
    elif name.sup == ("", "") or (sup.lstrip("-").isdigit() and sup not in ("0", "1")):
        meaning = "a power"
    elif sup.startswith("(") and sup.endswith(")"):
        meaning = "a derivative"
    if meaning is not None:
        raise SpecError(DeclarationCode.SUPERSCRIPT_WOULD_READ_TRY(sup=sup, meaning=meaning), key)


def spell_label(node: Node) -> str | None:
    """Returns a script as a label; None if it is not one."""
    pieces = _spell_script(node, ())
    return None if pieces is None else "".join(map(str, pieces))


def _spell_script(node: Node, variables: Collection[str]) -> list[Piece] | None:
    node = core(node)
    value = None if isinstance(node, Bracket) else linear(node, variables)
    is_label = isinstance(node, Sum) and len(node.addends) > 1 and value is not None and value.is_number
    if value is not None and not is_label:  # 3-2-1 is not 0
        return [value]
    match node:
        case Leaf(kind="FUNCTION", name=name):
            return [" ".join(name if node.bare else (f"\\mathrm{{{letter}}}" for letter in name))]
        case Leaf():
            return [node.text]
        case Styled():
            inner = _spell_script(node.body, ())  # an upright n is a label
            return None if inner is None else [node.style, "{", *inner, "}"]
        case Accented(accent=accent):
            inner = _spell_script(node.body, ())
            command = "\\tilde" if accent == "~" else written("ACCENT", accent)
            return None if inner is None else [command, "{", *inner, "}"]
        case Group():
            return _spell_list(node.parts, ",", variables)
        case Bracket():
            inner = _spell_list(node.parts, ",", variables)
            return None if inner is None else [node.kind, *inner, CLOSING[node.kind]]
        case Product():
            return _spell_list(node.items, " ", () if _is_word(node) else variables)
        case Sum(addends=addends):
            text = ""
            for sign, _, addend in addends:
                if (pieces := _spell_script(addend, ())) is None:
                    return None
                text += sign + "".join(map(str, pieces))
            return [text]
        case Scripted(factorial=False):
            return _spell_scripted(node, variables)
        case Infix(operator=operator):
            return [written("INFIX", operator)]
        case Chain(sides=sides, relations=(("→", _),)):  # from a frame to another
            return _spell_list(sides, "\\to ", ())
    return None


def _spell_scripted(node: Scripted, variables: Collection[str]) -> list[Piece] | None:
    """A script that has primes, or a script of its own."""
    match node:
        case Scripted(sub=None, sup=None, primes=primes):
            inner = _spell_script(node.nucleus, ())
            return None if inner is None else [*inner, "'" * primes]
        case Scripted(sup=None, sub=Node() as sub, primes=0):
            inner = _spell_list((node.nucleus, sub), "_{", variables)
            return None if inner is None else [*inner, "}"]
        case Scripted(sub=None, sup=Node() as sup, primes=0):  # the star of B^* next to B
            inner = _spell_list((node.nucleus, sup), "^{", ())
            return None if inner is None or linear_or_none(node.nucleus, variables) else [*inner, "}"]
    return None


def _is_word(node: Product) -> bool:
    """True if the letters are a word such as rel, not indices in a row such as i j."""
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

"""Notation of a paper: spellings with formal arguments, and their meaning in the claim language."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.construct import zero
from workbench.core.formula_errors import Fault, SpecError
from workbench.core.names import Name
from workbench.core.schema import key_names
from workbench.core.shapes import filling
from workbench.core.terms import Term
from workbench.core.types import KINDS, type_of_kind
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import (
    Bracket,
    Chain,
    Conditional,
    Infix,
    Leaf,
    Lines,
    Matrix,
    Node,
    Product,
    Scripted,
    Styled,
    core,
    is_own_word,
)
from workbench.language.naming.declarations import read_key
from workbench.language.naming.patterns import Known, agrees, fill, occurs, parts_of, same
from workbench.language.naming.spelling import refuse_operation, spell_label

#: alone in a bracket or under an accent, with its own mark, or next to others.
Place = Literal["alone", "marked", "beside"]

_ALLOWED = key_names("notation entry")
_FORMS = (
    "a bracket, an accent, a mark above or below an argument, a sign behind or between, a word before it,"
    " a letter that it stands below"
)


@dataclass(frozen=True)
class Notation:
    """An entry of [notation]: `key` in the author's spelling; `formals`: letter → kind ("dual vector")."""

    key: str
    formals: Mapping[str, str]
    pattern: Node
    means: Node

    @staticmethod
    def read(key: str, spec: Any) -> Notation:
        """Returns one entry of [notation]: '[x]_\\times' = { where = { x = "vector" }, means = '…' }.

        Raises SpecError.
        """
        if (
            not isinstance(spec, Mapping)
            or set(spec) - set(_ALLOWED)
            or not isinstance(spec.get("means"), str)
        ):
            raise SpecError(DeclarationCode.EXPECTED_WHERE_X_VECTOR(spec=repr(spec)), key)
        formals = spec.get("where", {})
        if not isinstance(formals, Mapping) or not all(isinstance(kind, str) for kind in formals.values()):
            raise SpecError(DeclarationCode.WHERE_EXPECTED_KINDS_LETTERS(), key)
        kinds = {letter: str(type_of_kind(kind) or kind) for letter, kind in formals.items()}
        notation = Notation(key, kinds, _one(key, key), _one(spec["means"], key))
        for letter in formals:
            if not occurs(letter, notation.pattern):
                raise SpecError(DeclarationCode.LETTER_NOT_IN_NOTATION(letter=letter), key)
            if not occurs(letter, notation.means):
                raise SpecError(DeclarationCode.LETTER_NOT_IN_MEANING(letter=letter), key)
            kind = formals[letter].removeprefix("dual ")
            if type_of_kind(kind) is None and kind not in map(str, KINDS.values()):
                raise SpecError(DeclarationCode.WHERE_EXPECTED_KIND_SUCH(letter=letter, kind=repr(kind)), key)
        if not formals and _letter(notation.pattern) is None and not notation.is_bracket:
            symbol = "a symbol: a letter or a number in its font, or what stands in a bracket"
            raise SpecError(DeclarationCode.NOTATION_WITHOUT_ARGUMENTS(symbol=symbol), key)
        if not formals and notation.is_bracket and isinstance(notation.pattern, Scripted):
            sup = notation.pattern.sup
            refuse_operation(Name("", sup=(spell_label(sup) or "",) if sup else ()), key)
        if not notation.is_looked_for:
            raise SpecError(DeclarationCode.NO_FORMULA_SEARCHED_THIS(FORMS=_FORMS), key)
        return notation

    def fits(self, terms: Mapping[str, Term]) -> bool:
        """True if the terms have the kinds of the formal arguments; a 0 without a size fits every kind."""
        kinds = self.formals.items()
        return all(filling(terms[x]) == "zero" or str(terms[x].type) == kind for x, kind in kinds)

    def filled(self, terms: Mapping[str, Term]) -> Node:
        """Returns the meaning, with these terms for the formal arguments."""
        typed = {
            letter: zero(type_of_kind(self.formals[letter]) or term.type) if filling(term) == "zero" else term
            for letter, term in terms.items()
        }
        return fill(self.means, {letter: Known(0, term) for letter, term in typed.items()})

    def spelt(self, texts: Mapping[str, str]) -> str:
        """Returns the notation as LaTeX, with these texts for the formal arguments."""
        return latex_of(
            fill(self.pattern, {letter: Leaf(0, "LETTER", text) for letter, text in texts.items()})
        )

    @cached_property
    def places(self) -> Mapping[str, Place]:
        """The place of each formal argument."""
        return dict(_places(self.pattern, self.formals, "alone"))

    @property
    def form(self) -> Literal["closed", "marked", "infix", "open"]:
        """The form of the notation in a row: closed like a bracket or a letter, with a superscript, an infix
        sign or a product, or open to its neighbours."""
        match core(self.pattern):
            case Leaf() | Styled() | Bracket() | Matrix() | Scripted(sup=None, primes=0):
                return "closed"
            case Scripted() | Product(items=(_, Bracket())):
                return "marked"
        return "open" if self.sign is None and not isinstance(self.pattern, Product) else "infix"

    def matched(self, node: Node) -> dict[str, Node] | None:
        """Returns the nodes of the formal arguments; None if the node does not match."""
        found: dict[str, Node] = {}
        return found if agrees(self.pattern, node, self.formals, found) else None

    @property
    def accent(self) -> str | None:
        """The style that it puts on its one argument, else None."""
        match self.pattern:
            case Styled(style=style, body=body) if self._is_formal(body):
                return style
        return None

    @property
    def is_looked_for(self) -> bool:
        """True if the reader tries it on every node."""
        pattern = core(self.pattern)
        match pattern:
            case Product(items=(_, Infix())):
                return True
            case Product(items=(one, _)):
                return not self._is_formal(_without_scripts(one))
        said = (self.accent, self.mark, self.below, self.letter, self.sign)
        return any(said) or self.is_prime or self.is_constant or is_shape(pattern)

    @property
    def below(self) -> Node | None:
        """The subscript that it puts on its one argument, else None."""
        match self.pattern:
            case Scripted(nucleus=nucleus, sub=Node() as sub, sup=None, primes=0) if self._is_formal(nucleus):
                return core(sub)
        return None

    @property
    def letter(self) -> Node | None:
        """The letter whose subscript is its one argument, as the angle of c_\\theta; else None."""
        match self.pattern:
            case Scripted(nucleus=nucleus, sub=Node() as sub, sup=None, primes=0) if self._is_formal(sub):
                is_letter = _letter(nucleus) is not None and not isinstance(nucleus, Scripted)
                return nucleus if is_letter and not self._is_formal(nucleus) else None
        return None

    @property
    def mark(self) -> Node | None:
        """The superscript that it puts on its one argument, else None."""
        match self.pattern:
            case Scripted(nucleus=nucleus, sub=None, sup=Node() as sup, primes=0) if self._is_formal(nucleus):
                return core(sup)
        return None

    @property
    def is_prime(self) -> bool:
        match self.pattern:
            case Scripted(nucleus=nucleus, sub=None, sup=None, primes=1):
                return self._is_formal(nucleus)
        return False

    @property
    def sign(self) -> tuple[str, str, str] | None:
        """The sign that it puts between two arguments, and their letters; else None."""
        match self.pattern:
            case Product(items=(Leaf(text=left), Infix(operator=sign), Leaf(text=right))):
                return sign, left, right
        return None

    @property
    def is_bracket(self) -> bool:
        """True for [Ad] and [Ad]^*, which are matched as brackets."""
        return isinstance(_without_scripts(self.pattern), Bracket)

    @property
    def is_constant(self) -> bool:
        return not self.formals and not self.is_bracket

    def _is_formal(self, node: Node) -> bool:
        return isinstance(leaf := core(node), Leaf) and leaf.text in self.formals


@dataclass(frozen=True)
class Notations:
    """All notation of a paper, by the way in which it is matched."""

    entries: tuple[Notation, ...] = ()

    @staticmethod
    def build(specs: Mapping[str, Any]) -> Notations:
        """Returns the notation of a paper. Raises SpecError, also if two entries can match one term."""
        entries = tuple(Notation.read(key, spec) for key, spec in specs.items())
        for place, one in enumerate(entries):
            for other in entries[:place]:
                if _collide(one, other):
                    raise SpecError(DeclarationCode.CAN_MATCH_SAME_TERM(key=other.key), one.key)
        return Notations(entries)

    def accents(self, style: str) -> list[Notation]:
        return [entry for entry in self.entries if entry.accent == style]

    def marks(self, sup: Node) -> list[Notation]:
        return [entry for entry in self.entries if entry.mark is not None and same(entry.mark, core(sup))]

    def below(self, sub: Node | None) -> list[Notation]:
        return [entry for entry in self.entries if entry.below is not None and same(entry.below, core(sub))]

    def letters(self, letter: Node) -> list[Notation]:
        return [entry for entry in self.entries if entry.letter is not None and same(entry.letter, letter)]

    def primes(self) -> list[Notation]:
        return [entry for entry in self.entries if entry.is_prime]

    def signs(self, sign: str) -> list[Notation]:
        return [entry for entry in self.entries if entry.sign is not None and entry.sign[0] == sign]

    @cached_property
    def constants(self) -> Mapping[Name, Notation]:
        """The entries without formal arguments, by the names that they spell."""
        return {read_key(entry.key)[0]: entry for entry in self.entries if entry.is_constant}

    def shapes(self, node: Node) -> list[tuple[Notation, dict[str, Node]]]:
        """Returns the entries that match the node: brackets, matrices and marks on them."""
        if not self.entries:
            return []
        named = sorted(self.entries, key=lambda entry: bool(entry.formals))  # [RN] before [x]
        alike = (entry for entry in named if not entry.is_constant and _is_alike(entry.pattern, node))
        found = ((entry, entry.matched(node)) for entry in alike)
        return [(entry, places) for entry, places in found if places is not None]


def _one(text: str, key: str) -> Node:
    try:
        lines = parse(text).lines
    except Fault as fault:
        raise SpecError(
            DeclarationCode.FAULT_IN_MEANING(text=text, value=fault.at + 1, fault=fault), key
        ) from None
    if len(lines) != 1 or len(lines[0]) != 1 or isinstance(lines[0][0], Chain | Conditional | Lines):
        raise SpecError(DeclarationCode.EXPECTED_ONE_MEANING(text=text), key)
    return lines[0][0]


def _letter(node: Node) -> Node | None:
    node = core(node)
    while isinstance(node, Styled | Scripted):
        node = core(node.body if isinstance(node, Styled) else node.nucleus)
    return node if isinstance(node, Leaf) else None


def _is_alike(pattern: Node, node: Node) -> bool:
    """True for brackets or matrices of one kind with equally many parts, so that a match is worth trying."""
    match pattern, node:
        case Bracket(), Bracket():
            return pattern.kind == node.kind and len(pattern.parts) == len(node.parts)
        case Matrix(), Matrix():
            return len(pattern.rows) == len(node.rows)
        case Scripted(), Scripted():
            return _is_alike(core(pattern.nucleus), core(node.nucleus))
        case Product(items=(_, Infix(operator=one))), Product(items=(_, Infix(operator=other))):
            return one == other
        case Product(items=(one, _)), Product(items=(other, _)):
            return _is_alike(_without_scripts(one), _without_scripts(other))
        case Leaf(), Leaf():
            return pattern.text == node.text
        case Styled(), Styled():
            return pattern.style == node.style
    return False


def _places(value: Any, formals: Mapping[str, str], place: Place) -> Iterator[tuple[str, Place]]:
    if isinstance(value, Leaf) and value.text in formals:
        yield value.text, place
    if isinstance(value, Bracket | Matrix | Styled):
        place = "alone"
    elif isinstance(value, Scripted):
        yield from _places(value.nucleus, formals, "marked")
        for script in (value.sub, value.sup):
            yield from _places(script, formals, "alone")
        return
    elif isinstance(value, Node) and core(value) is value:
        place = "beside"
    for part in parts_of(value):
        yield from _places(part, formals, place)


def _collide(one: Notation, other: Notation) -> bool:
    """True if one spelling can match both: the same pattern, with formals of the same kinds."""
    found: dict[str, Node] = {}
    if not agrees(one.pattern, other.pattern, one.formals, found):
        return False
    inner = {letter: core(node) for letter, node in found.items()}
    letters = {letter: node.text for letter, node in inner.items() if isinstance(node, Leaf)}
    return len(letters) == len(one.formals) and all(
        other.formals.get(letters[letter]) == kind for letter, kind in one.formals.items()
    )


def is_shape(node: Node) -> bool:
    """True for a node, other than a name, that the paper's notation may define."""
    nucleus = _without_scripts(node)
    return isinstance(nucleus, Bracket | Matrix) or is_own_word(nucleus)


def _without_scripts(node: Node) -> Node:
    return node.nucleus if isinstance(node, Scripted) else node

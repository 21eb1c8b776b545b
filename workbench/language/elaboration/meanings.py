"""Meanings of letters with scripts in a paper: a symbol, an integer, an entry of [notation], or a
built-in."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.types import CLOCK, PI, Declaration
from workbench.language.elaboration.printed_sizes import size_below
from workbench.language.grammar.syntax import Leaf, Node, Scripted
from workbench.language.naming.declarations import UNIT
from workbench.language.naming.linear_indices import variable_name
from workbench.language.naming.notations import Notation
from workbench.language.naming.spelling import Scripts, spell
from workbench.language.naming.symbols import SymbolTable

_UNITS = frozenset((UNIT, Name("I", ("\\underline", "\\mathbf"))))
_FONTS = ((), ("\\boldsymbol",), ("\\mathrm",), ("\\mathbb",), ("\\mathit",), ("\\mathsf",), ("\\mathcal",))
_ANY_FONT = frozenset(Name("I", styles) for styles in _FONTS)
_PLAIN = frozenset((Name("\\varepsilon"), Name("D", ("\\mathbf",)), CLOCK.name, PI.name))
#: The heads of e^x and C_n^k.
EXPONENTIALS = frozenset((Name("e"), Name("e", ("\\mathrm",))))
_COMBINATIONS = frozenset((Name("C"), Name("C", ("\\mathbf",)), Name("C", ("\\mathrm",))))


@dataclass(frozen=True, slots=True)
class Meaning:
    """The meaning of a letter.

    what: an integer variable, a symbol of the paper, an entry of [notation], or a built-in name.
    sup: the superscript, if it is not part of that.   takes_bracket: True for a function.
    primes: the number of primes that are marks of [notation] and not part of the name.
    below: the subscript, if it is such a mark.
    """

    what: str | Declaration | Notation | Name
    sup: Node | None
    index: tuple[Linear, ...] = ()
    takes_bracket: bool = False
    primes: int = 0
    below: Node | None = None

    @property
    def name(self) -> Name | str:
        """The identity of the meaning; members of one family share it."""
        match self.what:
            case Declaration(name=name) | Notation(key=name):
                return name
        return self.what


def meaning(
    table: SymbolTable,
    variables: Collection[str],
    leaf: Leaf,
    styles: tuple[str, ...],
    scripts: Scripts,
    has_bracket: bool = False,
) -> Meaning | None:
    """Returns the meaning of a letter, or None. The superscript belongs to the name if such a name exists."""
    if leaf.kind == "LETTER" and not (styles or scripts.primes or scripts.left_sub or scripts.left_sup):
        variable = variable_name(Scripted(leaf.at, leaf, scripts.sub) if scripts.sub else leaf)
        if variable is not None and variable in variables:
            return Meaning(variable, scripts.sup)
    letter = Name.styled(styles, leaf.text)
    for sup, tried in ((None, scripts), (scripts.sup, scripts.without_sup())):
        spelling = spell(letter, tried, variables)
        if spelling is None:
            continue
        if has_bracket and (found := table.find(spelling, function=True)) is not None:
            return Meaning(found[0], sup, found[1], takes_bracket=True)
        if (found := table.find(spelling)) is not None:
            return Meaning(found[0], sup, found[1])
        if (entry := table.notations.constants.get(spelling.exact)) is not None:
            return Meaning(entry, sup)
    if table.notations.below(scripts.sub):
        bare = meaning(table, variables, leaf, styles, replace(scripts, sub=None), has_bracket)
        if bare is not None and not bare.primes:
            return replace(bare, below=scripts.sub)
    if scripts.primes and table.notations.primes():
        fewer = replace(scripts, primes=scripts.primes - 1)
        if (inner := meaning(table, variables, leaf, styles, fewer, has_bracket)) is not None:
            return replace(inner, primes=inner.primes + 1)
    return _built_in(letter, scripts)


def constant(table: SymbolTable, letter: Name, scripts: Scripts) -> Meaning | None:
    """Returns the meaning of a name that stands for a term in the paper's notation, else None."""
    constants = table.notations.constants
    for sup, tried in ((None, scripts), (scripts.sup, scripts.without_sup())) if constants else ():
        spelling = spell(letter, tried, ())
        if spelling is not None and (entry := constants.get(spelling.exact)) is not None:
            return Meaning(entry, sup)
    return None


def _built_in(letter: Name, scripts: Scripts) -> Meaning | None:
    if scripts.left_sub is not None or scripts.left_sup is not None or scripts.primes:
        return None
    sub, sup = scripts.sub, scripts.sup
    size, is_single = size_below(sub)
    if letter in _ANY_FONT and size is not None and not is_single:
        return Meaning(UNIT, sup)  # I_{3 \times 3}
    is_unit = size is not None and size.rows > 1  # \mathbf{I}_1 belongs to a body 1
    if (sub is None and letter in _PLAIN | _UNITS) or (is_unit and letter in _UNITS):
        return Meaning(letter, sup)
    if sup is not None and letter in (EXPONENTIALS if sub is None else _COMBINATIONS):
        return Meaning(letter, None)
    return None

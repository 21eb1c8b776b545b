"""The symbols of a paper: what each LaTeX name is, and which name a spelling means."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cached_property
from typing import Any

from workbench.language.construct import symbol
from workbench.language.errors import Fault, SpecError
from workbench.language.integers import Linear
from workbench.language.names import (
    INDEX_LETTERS,
    TRANSPOSES,
    Piece,
    Scripts,
    base_name,
    candidates,
    linear,
    literal,
    names_of_key,
    spell,
)
from workbench.language.notations import Notation, Notations
from workbench.language.syntax import Chain, Group, Leaf, Node, Product, Scripted, Styled, parse
from workbench.language.terms import IllFormed, Symbol, Term
from workbench.language.types import CLOCK, KINDS, Declaration, Type, Weight, type_of_kind

_FLAGS = ("constant", "unit", "coordinate", "uniform", "independent", "symmetric", "diagonal")
_FLAGGED = {
    "unit": ("vector", "hamilton quaternion"),
    "coordinate": ("vector",),
    "symmetric": ("tensor",),
    "diagonal": ("tensor",),
}
_ALLOWED = ("kind", "weight", *_FLAGS, "of", "aliases", "note")

#: What these names mean in every formula.
_BUILTIN = {
    "\\varepsilon": "the dual unit",
    "\\mathbf{I}": "the unit tensor",
    "\\underline{\\mathbf{I}}": "the unit tensor",
    "\\mathbf{D}": "the operator d/dt",
    "\\partial": "the sign of a partial derivative",
}


@dataclass(frozen=True)
class SymbolTable:
    """Names (each index place marked @) to declarations; aliases included. Never changed: to add makes a new
    table."""

    symbols: Mapping[str, Declaration] = field(default_factory=dict)
    functions: Mapping[str, Declaration] = field(default_factory=dict)
    #: the formal arguments of each function symbol, by its name
    formals: Mapping[str, tuple[Declaration, ...]] = field(default_factory=dict)
    #: the indices (1, or n+1) at which each name is defined
    defined: Mapping[str, tuple[tuple[Linear, ...], ...]] = field(default_factory=dict)
    #: the names that definitions introduce as a bare 0 or I, and the types that they may have
    untyped: Mapping[str, tuple[Type, ...]] = field(default_factory=dict)
    #: what definitions use although nothing defines it: it must stay primitive
    primitive: frozenset[tuple[str, tuple[Linear, ...]]] = frozenset()
    #: what the paper spells in a way of its own
    notations: Notations = field(default_factory=Notations)
    #: the name of each constant of that notation → the key
    constants: Mapping[str, Notation] = field(default_factory=dict)
    #: frame → its angular velocity seen from where \\dot differentiates
    frames: Mapping[str, Term] = field(default_factory=dict)
    #: names in brackets that only say what a symbol depends on: f(q)
    arguments: frozenset[str] = frozenset()
    #: functions that the paper writes without a backslash, though it has their letters as symbols
    bare_functions: frozenset[str] = frozenset()
    #: whether ∂f/∂x of a scalar by a vector is a row or a column; None: it is not said
    gradient: str | None = None
    #: the frame in which \\dot differentiates vectors; None with frames: it is not said
    dot: str | None = None

    @staticmethod
    def build(specs: Mapping[str, Mapping[str, Any]]) -> SymbolTable:
        """The table of a paper's [symbols]: LaTeX key → {kind, weight, constant, unit, coordinate,
        uniform, of, aliases, note}. Raises SpecError."""
        symbols: dict[str, Declaration] = {}
        functions: dict[str, Sequence[str]] = {}
        for key, spec in specs.items():
            name, index = read_key(key)
            declaration = _declaration(key, name, index, spec)
            if "of" in spec:
                functions[name] = _of(key, declaration, spec["of"])
            for alias in (key, *_aliases(key, spec)):
                pattern, places = read_key(alias)
                if len(places) != len(index):
                    raise SpecError(f"{alias} has {len(places)} index places, not {len(index)}", key)
                if places != index:
                    raise SpecError(f"the indices of {alias} differ from those of {key}", key)
                if pattern in symbols:
                    raise SpecError(f"{alias} is declared twice", key)
                _refuse_operation(pattern, key)
                refuse_builtin(pattern, declaration.type, key)
                symbols[pattern] = declaration
        return SymbolTable(_with_arguments(symbols, functions))

    def with_notations(self, specs: Mapping[str, Any]) -> SymbolTable:
        """This table, and the notation of the paper. Raises SpecError."""
        notations = Notations.build(specs)
        constants = {}
        for entry in notations.constants():
            name, index = read_key(entry.key)
            if index or name in self.symbols:
                raise SpecError("it is a symbol too" if not index else "an index in a notation", entry.key)
            constants[name] = entry
        return replace(self, notations=notations, constants=constants)

    def with_specs(self, specs: Mapping[str, Mapping[str, Any]]) -> SymbolTable:
        """This table and more symbols, none of which it has yet. Raises SpecError."""
        more = SymbolTable.build(specs).symbols
        for pattern in more:
            if pattern in self.symbols or pattern in self.functions:
                raise SpecError("this symbol is known already", pattern)
        return replace(self, symbols={**self.symbols, **more})

    def with_symbol(self, declaration: Declaration, formals: tuple[Declaration, ...] = ()) -> SymbolTable:
        """This table and one more symbol; with formal arguments it is a function symbol."""
        place = {pattern_of(declaration): declaration}
        if not formals:
            return replace(self, symbols={**self.symbols, **place})
        known = {**self.formals, declaration.name: formals}
        return replace(self, functions={**self.functions, **place}, formals=known)

    def find(
        self, pieces: Sequence[Piece], function: bool = False
    ) -> tuple[Declaration, tuple[Linear, ...]] | None:
        """The symbol that a spelling means and its indices: an exact name before a member of a family."""
        known = self.functions if function else self.symbols
        for pattern, index in candidates(pieces):
            declaration = known.get(pattern)
            if declaration is not None and declaration.indices == len(index):
                is_known = not declaration.introduced or self.defines(declaration.name, index)
                return (declaration, index) if is_known else None
        return None

    @cached_property
    def has_quaternions(self) -> bool:
        """Whether any symbol is a quaternion, so that s + x of a scalar and a vector may be one."""
        return any(d.type.kind == "quaternion" for d in self.symbols.values())

    def has_letter(self, letter: str) -> bool:
        """Whether a symbol has this letter, with whatever scripts."""
        names = (*self.symbols, *self.functions)
        return any(name.startswith((f"{letter}_", f"{letter}^")) or name == letter for name in names)

    def defines(self, name: str, index: tuple[Linear, ...]) -> bool:
        """Whether a definition covers this member: its own, or one for n or n + c."""
        return any(
            all(
                place == wanted if place.is_number else not wanted.is_number or int(wanted) >= place.constant
                for place, wanted in zip(member, index, strict=True)
            )
            for member in self.defined.get(name, ())
        )

    def check_arguments(self, function: Declaration, arguments: Sequence[Term]) -> None:
        """Raises IllFormed where an argument is not what the formal one is."""
        for formal, argument in zip(self.formals[function.name], arguments, strict=False):
            if argument.type.with_dual(False) != formal.type.with_dual(False):
                raise IllFormed(f"{function.name} takes a {formal.type}, got a {argument.type}")
            if None not in (formal.weight, argument.weight) and formal.weight != argument.weight:
                raise IllFormed(
                    f"{function.name} takes an argument of weight {formal.weight}, got {argument.weight}"
                )

    def unknown(self, pieces: Sequence[Piece]) -> str:
        """A message for a spelling that means nothing here, with the closest names."""
        text = literal(pieces)
        for pattern, index in candidates(pieces):
            declaration = self.symbols.get(pattern) or self.functions.get(pattern)
            if declaration is not None and declaration.introduced and len(index) == declaration.indices:
                known = (spelled(declaration.name, member) for member in self.defined[declaration.name])
                return f"{text} is not defined; defined before it: {', '.join(known)}"
        names = sorted({d.name for d in (*self.symbols.values(), *self.functions.values())})
        bare = {name: _bare(name) for name in names}
        alike = [name for name in names if bare[name] == _bare(text)]
        alike += [name for name in get_close_matches(text, names, n=3, cutoff=0.6) if name not in alike]
        shown = [name.replace("@", "n") for name in alike[:3]]
        return f"unknown symbol {text}" + (f"; known and close: {', '.join(shown)}" if shown else "")


def pattern_of(declaration: Declaration) -> str:
    """The spelling of a symbol; that of a function symbol is its name without (·)."""
    return declaration.name.partition("(")[0] if declaration.parameters else declaration.name


def spelled(name: str, index: Sequence[Linear]) -> str:
    """A name with its indices put in."""
    first, *rest = name.split("@")
    return first + "".join(f"{value}{text}" for value, text in zip(index, rest, strict=True))


def may_be_label(symbol: Symbol, exponent: int) -> bool:
    """Whether R_1^0, without brackets, may be taken for R with the labels 1 and 0 of frames: a digit on a
    rotation with a number for index; on another one, or on a numbered tensor or vector, a power that nobody
    prints."""
    numbered = re.search(r"_\{[0-9,]+\}$", spelled(symbol.declaration.name, symbol.index)) is not None
    if symbol.declaration.rotation:
        return exponent in (0, 1) or (numbered and exponent > 1)
    return numbered and exponent in (0, 1) and symbol.type.kind in ("tensor", "vector")


def index_in(name: str, text: str) -> tuple[Linear, ...] | None:
    """The numbers at which the family `name` is spelled `text`: 1 for Φ_1 in Φ_n; None if it never is."""
    match = re.fullmatch(re.escape(name).replace("@", "([0-9]+)"), text)
    return None if match is None or "@" not in name else tuple(Linear(int(n)) for n in match.groups())


def _bare(name: str) -> str:
    """The letter of a name, whatever its font."""
    letters = name
    for style in ("\\underline", "\\mathbf", "\\boldsymbol", "\\mathrm", "\\mathcal", "\\overline", "{", "}"):
        letters = letters.replace(style, "")
    return letters.split("_")[0].split("^")[0].lstrip()


def _refuse_operation(pattern: str, key: str) -> None:
    """A superscript that means something else cannot be part of a name."""
    sup = pattern.rpartition("^{")[2].removesuffix("}") if pattern.endswith("}") else ""
    is_right = bool(pattern.rpartition("^{")[0].strip("{}"))
    meaning = None
    if sup in TRANSPOSES:
        meaning = "the transpose"
    elif sup == "@" or sup.lstrip("-").isdigit():
        meaning = "a power"
    elif sup.startswith("(") and sup.endswith(")"):
        meaning = "a derivative"
    if is_right and meaning is not None:
        raise SpecError(
            f"the superscript {sup.replace('@', 'n')} would be read as {meaning}; try ^{{[n]}}", key
        )


def refuse_builtin(pattern: str, type_: Type, key: str) -> None:
    """Raises SpecError for a name that has a meaning of its own, in which it is read and printed back."""
    meaning = _BUILTIN.get(pattern)
    if pattern == "t" and type_.kind == "scalar":
        meaning = "the time of x(t) and \\frac{d}{dt}"
    if meaning is not None:
        raise SpecError(f"{pattern} is {meaning}; a symbol of the paper needs another name", key)


def read_key(key: str) -> tuple[str, tuple[Linear, ...]]:
    """A declared LaTeX name: its pattern, and what stands in its index places. Raises SpecError."""
    try:
        lines = parse(key).lines
        if len(lines) != 1 or len(lines[0]) != 1 or isinstance(lines[0][0], Chain):
            raise SpecError("expected one symbol", key)
        return names_of_key(key_pieces(lines[0][0], key))
    except Fault as fault:
        raise SpecError(f"column {fault.at + 1}: {fault}", key) from None


def key_pieces(node: Node, key: str) -> list[Piece]:
    """The spelling of a declared name, where index letters count as integers. Raises SpecError."""
    left_sub = left_sup = None
    match node:
        case Product(items=(Scripted(nucleus=Group(parts=())) as left, right)):
            left_sub, left_sup, node = left.sub, left.sup, right
    scripted = node if isinstance(node, Scripted) else Scripted(node.at, node)
    styles, letter = [], scripted.nucleus
    while not isinstance(letter, Leaf):
        match letter:
            case Styled():
                styles.append(letter.style)
                letter = letter.body
            case Group(parts=(part,)):
                letter = part
            case _:
                raise SpecError("expected one symbol: a letter with its font and scripts", key)
    is_figure = letter.kind == "NUMBER" and letter.text != "0" and styles
    if not (letter.kind == "LETTER" or is_figure) or scripted.factorial:
        raise SpecError(f"expected a letter, got {letter.text}", key)
    scripts = Scripts(left_sub, left_sup, scripted.sub, scripted.sup, scripted.primes)
    pieces = spell(base_name(styles, letter.text), scripts, INDEX_LETTERS)
    if pieces is None:
        raise SpecError("its scripts are not part of a name", key)
    return pieces


def _declaration(key: str, name: str, index: Sequence[Linear], spec: Mapping[str, Any]) -> Declaration:
    if not isinstance(spec, Mapping):
        raise SpecError(f'expected a table such as {{ kind = "vector" }}, got {spec!r}', key)
    unknown = [entry for entry in spec if entry not in _ALLOWED]
    if unknown:
        raise SpecError(f"unknown key {unknown[0]!r}; allowed: {', '.join(_ALLOWED)}", key)
    kind = spec.get("kind")
    plain = kind.removeprefix("dual ") if isinstance(kind, str) else ""
    type_ = type_of_kind(plain)
    if type_ is None:
        allowed = f"{' | '.join(KINDS)} | matrix n×m, each perhaps with 'dual '"
        if plain == "quaternion":
            allowed = (
                "a convention: 'hamilton quaternion', or [conventions] quaternion = 'hamilton, scalar first'"
            )
        raise SpecError(f"kind is {kind!r}; expected {allowed}", key)
    dual = plain != kind
    for flag in _FLAGS:
        if not isinstance(spec.get(flag, False), bool):
            raise SpecError(f"{flag} is {spec[flag]!r}; expected true or false", key)
    for flag, kinds in _FLAGGED.items():
        if spec.get(flag) and plain not in kinds:
            raise SpecError(f"{flag} is for a {' or a '.join(kinds)}, not for a {plain}", key)
    if dual and plain == "transform":
        raise SpecError("a transform is real; a dual rotation stands for the same motions", key)
    return Declaration(
        name,
        type_.with_dual(dual),
        _weight(key, index, spec.get("weight")),
        constant=spec.get("constant", False),
        unit=spec.get("unit", False),
        rotation=plain == "rotation",
        transform=plain == "transform",
        symmetric=spec.get("symmetric", False),
        diagonal=spec.get("diagonal", False),
        coordinate=spec.get("coordinate", False),
        uniform=spec.get("uniform", False),
        independent=spec.get("independent", False),
        indices=len(index),
    )


def _of(key: str, declaration: Declaration, names: Any) -> Sequence[str]:
    """What a symbol is said to be a function of."""
    if not isinstance(names, list) or not all(isinstance(name, str) for name in names):
        raise SpecError(f"of is {names!r}; expected a list of symbols such as ['q', 't']", key)
    bound = [flag for flag in (*_FLAGS, "rotation", "transform") if getattr(declaration, flag)]
    if bound or declaration.type.dual or declaration.type.kind == "operator":
        what = bound[0] if bound else f"a {declaration.type}"
        raise SpecError(f"of is for real quantities whose values are free, not for {what}", key)
    return names


def _with_arguments(
    symbols: Mapping[str, Declaration], functions: Mapping[str, Sequence[str]]
) -> dict[str, Declaration]:
    """The declarations, where each function holds the symbols that it is `of`. Raises SpecError."""
    table, made = SymbolTable(symbols), dict(symbols)
    arguments = {
        name: [_argument(name, text, table, functions) for text in names] for name, names in functions.items()
    }
    named = {declaration.name for found in arguments.values() for declaration, _ in found}
    for pattern, declaration in symbols.items():
        if declaration.name in named and declaration.name not in functions:
            made[pattern] = replace(declaration, independent=True)
    known = {declaration.name: declaration for declaration in (CLOCK, *made.values())}

    def built(name: str, above: tuple[str, ...]) -> Declaration:
        if name in above:
            raise SpecError(f"of: {name} is a function of itself", name)
        if name in arguments and not known[name].of:
            found = tuple(symbol(built(d.name, (*above, name)), index) for d, index in arguments[name])
            known[name] = replace(known[name], of=found)
        return known[name]

    return {pattern: built(declaration.name, ()) for pattern, declaration in made.items()}


def _argument(
    name: str, text: str, table: SymbolTable, functions: Mapping[str, Sequence[str]]
) -> tuple[Declaration, tuple[Linear, ...]]:
    if text == CLOCK.name and text not in table.symbols:
        return CLOCK, ()
    pattern, _ = read_key(text)
    found = table.find([pattern]) if pattern in table.symbols else table.find(_pieces_of(text))
    if found is None:
        raise SpecError(f"of: {text} is no declared symbol", name)
    declaration, index = found
    is_column = declaration.type.kind == "scalar" or declaration.type.is_column
    if not is_column or declaration.type.dual or not all(place.is_number for place in index):
        raise SpecError(f"of: {text} is no scalar and no column of scalars", name)
    if declaration.unit or declaration.constant:
        raise SpecError(f"of: {text} is {'a unit vector' if declaration.unit else 'constant'}", name)
    return found


def _pieces_of(text: str) -> list[Piece]:
    return key_pieces(parse(text).lines[0][0], text)


def _aliases(key: str, spec: Mapping[str, Any]) -> Sequence[str]:
    aliases = spec.get("aliases", ())
    if not isinstance(aliases, list | tuple) or not all(isinstance(alias, str) for alias in aliases):
        raise SpecError(f"aliases is {aliases!r}; expected a list of LaTeX names", key)
    return aliases


def _weight(key: str, index: Sequence[Linear], weight: Any) -> Weight:
    """An integer, or a string such as "n+1" in the index letters of the key."""
    if weight is None or (isinstance(weight, int) and not isinstance(weight, bool)):
        return None if weight is None else Linear(weight)
    letters = sorted(set().union(*(place.variables for place in index)))
    value = None
    if isinstance(weight, str):
        try:
            lines = parse(weight).lines
            value = linear(lines[0][0], letters) if len(lines) == 1 and len(lines[0]) == 1 else None
        except Fault:
            value = None
    if value is None:
        of = f" or a string linear in {', '.join(letters)}" if letters else ""
        raise SpecError(f"weight is {weight!r}; expected an integer{of}", key)
    places = {}
    for at, place in sorted(enumerate(index), key=lambda entry: abs(entry[1].constant), reverse=True):
        for letter, coefficient in place.coefficients:
            if coefficient == 1 and len(place.coefficients) == 1:
                places[letter] = Linear.variable(f"@{at}") - place.constant
    return value.substitute(places)

"""The symbol table of a paper: the declaration of each name, and the name that a spelling means."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cached_property
from types import MappingProxyType
from typing import Any

from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.construct import symbol
from workbench.core.formula_errors import SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name, is_prefix
from workbench.core.reasons import Reason
from workbench.core.terms import IllFormed, Symbol, Term
from workbench.core.types import CLOCK, Declaration
from workbench.language.grammar.parser import parse
from workbench.language.naming.declarations import (
    DUAL_UNIT,
    TIME_OPERATOR,
    UNIT,
    aliases,
    arguments_of,
    key_spelling,
    read_declaration,
    read_key,
    refuse_builtin,
    speaks_of,
)
from workbench.language.naming.defined_names import DefinedNames
from workbench.language.naming.known_frames import KnownFrames
from workbench.language.naming.notations import Notations
from workbench.language.naming.reading_conventions import Conventions
from workbench.language.naming.spelling import INDEX_LETTERS, Spelling, refuse_operation

#: Letters for unit matrices.
UNIT_LETTERS = frozenset({"I", "E", "U"})


@dataclass(frozen=True)
class SymbolTable:
    """Names to declarations, including aliases; functions without their arguments. Immutable: adding makes a
    new table."""

    symbols: Mapping[Name, Declaration] = field(default_factory=dict)
    functions: Mapping[Name, Declaration] = field(default_factory=dict)
    #: the formal arguments of each function symbol, by its name
    formals: Mapping[Name, tuple[Declaration, ...]] = field(default_factory=dict)
    #: the names that the definitions read so far define
    defined: DefinedNames = field(default_factory=DefinedNames)
    #: the paper's notation
    notations: Notations = field(default_factory=Notations)
    frames: KnownFrames = field(default_factory=KnownFrames)
    #: names in brackets that only state the dependence of a symbol: f(q)
    arguments: frozenset[Name] = frozenset()
    conventions: Conventions = field(default_factory=Conventions)
    #: whether messages on an unknown symbol name close ones
    names_close: bool = True
    #: whether the table of which this is a part has a quaternion
    beside_quaternions: bool = False

    @staticmethod
    def build(
        specs: Mapping[str, Mapping[str, Any]],
        labels: Collection[str] = (),
        bodies: Mapping[str, str] = MappingProxyType({}),
    ) -> SymbolTable:
        """Returns the table of a paper's [symbols]: LaTeX key → {kind, weight, constant, unit, coordinate,
        uniform, of, aliases, note}.

        The letters in `labels`, such as those of frames, are not indices; neither are those of a key whose
        definition, in `bodies`, contains none of them. Raises SpecError.
        """
        symbols: dict[Name, Declaration] = {}
        functions: dict[Name, Sequence[str]] = {}
        own = {UNIT} if _has_duals(specs.values()) else {UNIT, DUAL_UNIT, TIME_OPERATOR}
        letters = INDEX_LETTERS.intersection((*specs, *labels))
        for key, spec in specs.items():
            name, index = read_key(key)
            declared = read_declaration(key, name, index, spec)
            if "of" in spec and not declared.timed:
                functions[name] = arguments_of(key, declared, spec["of"])
            for alias in (key, *aliases(key, spec)):
                try:
                    other, places = read_key(alias)
                except SpecError as error:
                    raise SpecError(DeclarationCode.FAULT_OF_ALIAS(alias=alias, error=error), key) from None
                if len(places) != len(index):
                    raise SpecError(
                        DeclarationCode.HAS_INDEX_PLACES_NOT(
                            alias=alias, places=len(places), index=len(index)
                        ),
                        key,
                    )
                if places != index:
                    raise SpecError(DeclarationCode.INDICES_DIFFER_FROM_THOSE(alias=alias, key=key), key)
                if other in symbols:
                    if read_key(alias, letters)[0] != other:
                        continue  # T_n next to T_m and symbols m and n
                    why = "; letters that are no indices are `labels` in [frames]" if len(index) > 1 else ""
                    raise SpecError(DeclarationCode.DECLARED_TWICE(alias=alias, why=why), key)
                is_matrix = declared.type.is_square and declared.type.rows > 1
                if not (is_matrix and _is_labelled(other, specs)):
                    refuse_operation(other, key)
                if other not in own:
                    refuse_builtin(other, declared.type, key)
                symbols[other] = declared
        for key, spec in specs.items():
            name, index = read_key(key, letters)
            variables = frozenset[str]().union(*(place.variables for place in index))
            if variables and key in bodies and not speaks_of(bodies[key], variables):
                name, index = read_key(key, {*letters, *variables})
            if name not in symbols:  # T_m next to a symbol m
                symbols[name] = read_declaration(key, name, index, _unindexed(spec))
        try:
            known = _tilded(_with_members(symbols, functions))
            return SymbolTable(_with_arguments(known, functions))
        except SpecError as error:
            keys = {str(read_key(key)[0]): key for key in specs}
            raise SpecError(error.message, keys.get(error.key, error.key)) from None

    def part(self, names: Set[Name]) -> SymbolTable:
        """Returns the table restricted to the declarations of these names; other settings stay.

        It must not be used for reading, since the letters of other names are free in it.
        """
        bare = frozenset(name.without_arguments() for name in names)
        return replace(
            self,
            symbols={name: own for name, own in self.symbols.items() if name in names or own.name in names},
            functions={name: own for name, own in self.functions.items() if name in bare},
            formals={name: own for name, own in self.formals.items() if name in names},
            defined=self.defined.part(names),
            frames=self.frames.part(names),
            arguments=frozenset(),
            beside_quaternions=self.has_quaternions,
        )

    def with_notations(self, specs: Mapping[str, Any]) -> SymbolTable:
        """Returns this table with the notation of the paper. Raises SpecError."""
        notations = Notations.build(specs)
        for entry in (each for each in notations.entries if each.is_constant):
            name, index = read_key(entry.key)
            if index or name in self.symbols:
                raise SpecError("it is a symbol too" if not index else "an index in a notation", entry.key)
            if name.sup:
                refuse_operation(name, entry.key)
        return replace(self, notations=notations)

    def with_specs(self, specs: Mapping[str, Mapping[str, Any]]) -> SymbolTable:
        """Returns this table with new symbols. Raises SpecError."""
        more = SymbolTable.build(specs).symbols
        families = [known for known in self.symbols if known.indices]
        for name in more:
            if name in self.symbols or name in self.functions:
                raise SpecError(DeclarationCode.SYMBOL_KNOWN(), str(name))
            self.refuse_tilde(name)
            if family := next((known for known in families if known.index_of(name) is not None), None):
                raise SpecError(DeclarationCode.SYMBOL_KNOWN_AS_MEMBER(family=family), str(name))
        return replace(self, symbols={**self.symbols, **more})

    def with_symbol(self, declaration: Declaration, formals: tuple[Declaration, ...] = ()) -> SymbolTable:
        """Returns this table with one more symbol; with formal arguments it is a function symbol."""
        place = {declaration.name.without_arguments(): declaration}
        self.refuse_tilde(declaration.name)
        if not formals:
            return replace(self, symbols={**self.symbols, **place})
        known = {**self.formals, declaration.name: formals}
        return replace(self, functions={**self.functions, **place}, formals=known)

    def find(
        self, spelling: Spelling, function: bool = False
    ) -> tuple[Declaration, tuple[Linear, ...]] | None:
        """Returns the symbol of a spelling and its indices, else None; an exact name precedes a member of a
        family."""
        known = self.functions if function else self.symbols
        for name, index in spelling.candidates():
            declaration = known.get(name)
            if declaration is not None:
                is_known = not declaration.introduced or self.defined.covers(declaration.name, index)
                return (declaration, index) if is_known else None
        return None

    def refuse_tilde(self, name: Name) -> None:
        """Raises SpecError for \\tilde{x} next to a vector x, whose skew tensor was written so before."""
        if "\\tilde" in name.styles and name not in self.symbols:
            plain = self.symbols.get(_without_tilde(name))
            if plain is not None and plain.type.kind == "vector":
                raise SpecError(DeclarationCode.READ_SKEW_TENSOR_DECLARE(), str(name))

    @cached_property
    def has_tildes(self) -> bool:
        """True if some symbol has a tilde in its name."""
        return any("\\tilde" in name.styles for name in self.symbols)

    @cached_property
    def has_quaternions(self) -> bool:
        """True if any symbol is a quaternion, so that s + x of a scalar and a vector may be one."""
        return self.beside_quaternions or any(d.type.kind == "quaternion" for d in self.symbols.values())

    def __contains__(self, letter: str) -> bool:
        """True if the letter without scripts is a symbol."""
        return Name(letter) in self.symbols

    def has_letter(self, letter: str) -> bool:
        """True if a symbol has this letter, with any scripts."""
        return any(name.base == letter for name in (*self.symbols, *self.functions))

    @cached_property
    def longest_word(self) -> int:
        """The number of letters of the longest name that consists of letters."""
        return max((len(name.letter) for name in self.symbols if name.letter.isalpha()), default=1)

    @cached_property
    def _prefixed(self) -> frozenset[tuple[str, tuple[str, ...]]]:
        return frozenset((n.letter, n.styles) for n in self.symbols if any(map(is_prefix, n.styles[:1])))

    def has_prefixed(self, styles: tuple[str, ...], letter: str) -> bool:
        """True if a symbol has this letter after this \\Delta, with any scripts."""
        return (letter, Name.styled(styles, letter).styles) in self._prefixed

    def check_arguments(self, function: Declaration, arguments: Sequence[Term]) -> None:
        """Raises IllFormed if an argument does not match the formal one."""
        for formal, argument in zip(self.formals[function.name], arguments, strict=False):
            if argument.type.with_dual(False) != formal.type.with_dual(False):
                raise IllFormed(
                    TypeCode.FUNCTION_ARGUMENT_TYPE(
                        name=function.name, type=formal.type, type_2=argument.type
                    )
                )
            if None not in (formal.weight, argument.weight) and formal.weight != argument.weight:
                raise IllFormed(
                    TypeCode.FUNCTION_ARGUMENT_WEIGHT(
                        name=function.name, weight=formal.weight, weight_2=argument.weight
                    )
                )

    def unknown(self, spelling: Spelling) -> Reason:
        """Returns the message for an unknown spelling, with the closest names."""
        text = str(spelling)
        for name, _ in spelling.candidates():
            declaration = self.symbols.get(name) or self.functions.get(name)
            if declaration is not None and declaration.introduced:
                known = (declaration.name.shown(member) for member in self.defined.members[declaration.name])
                return SyntaxCode.NOT_DEFINED(text=text, known=", ".join(known))
        if not self.names_close:
            return SyntaxCode.UNKNOWN_SYMBOL(text=text)
        if text in UNIT_LETTERS:
            meant = f"'{text}' = {{ means = '\\mathbf{{I}}' }}"
            return SyntaxCode.UNKNOWN_UNIT_TENSOR(text=text, meant=meant)
        letters = {str(d.name): d.name.letter for d in (*self.symbols.values(), *self.functions.values())}
        alike = sorted(name for name, letter in letters.items() if letter == spelling.letter.letter)
        alike += [
            name for name in get_close_matches(text, sorted(letters), n=3, cutoff=0.6) if name not in alike
        ]
        if alike:
            return SyntaxCode.UNKNOWN_SYMBOL_CLOSE(text=text, close=", ".join(alike[:3]))
        return SyntaxCode.UNKNOWN_SYMBOL(text=text)


def may_be_label(symbol: Symbol, exponent: int) -> bool:
    """True if the 0 of R_1^0, without brackets, may be a label of a frame like the 1.

    So may a digit on a rotation with a numeric index; on other rotations, and on numbered tensors and
    vectors, only a power that nobody prints.
    """
    name = symbol.declaration.name.at(symbol.index)
    numbered = not name.sup and re.fullmatch("[0-9,]+", "".join(name.sub)) is not None
    if symbol.declaration.rotation:
        return exponent in (0, 1) or (numbered and exponent > 1)
    return numbered and exponent in (0, 1) and symbol.type.kind in ("tensor", "vector")


def _with_members(
    symbols: Mapping[Name, Declaration], functions: Mapping[Name, Sequence[str]]
) -> dict[Name, Declaration]:
    """Returns the declarations in which b_1 next to b_n is the member 1 of that family.

    If b_1 is declared as something else, the family has no such member.
    """
    kept = dict(symbols)
    families = [(name, declaration) for name, declaration in symbols.items() if name.indices]
    for name, declaration in symbols.items():
        for pattern, family in families if not name.indices else ():
            index = pattern.index_of(name)
            if index is None:
                continue
            values = {f"@{place}": value for place, value in enumerate(index)}
            weight = None if family.weight is None else family.weight.substitute(values)
            member = replace(family, name=declaration.name, weight=weight, indices=0)
            if member == declaration and functions.get(pattern) == functions.get(name):
                kept.pop(name, None)
            else:
                kept[pattern] = replace(kept[pattern], apart=(*kept[pattern].apart, index))
    return kept


def _is_labelled(name: Name, keys: Iterable[str]) -> bool:
    """True if the 2 of T^2_3 is a label: there is no T_3 that could have this power."""
    if not (any(name.sub) and "".join(name.sup).isdigit()):
        return False
    base = replace(name, sup=())
    known = [read_key(key)[0] for key in keys]
    return not any(each == base or each.index_of(base) is not None for each in known)


def _has_duals(specs: Iterable[object]) -> bool:
    """True if a declared kind is dual, or an operator."""
    kinds = (str(spec.get("kind")) for spec in specs if isinstance(spec, Mapping))
    return any(kind.startswith(("dual", "operator")) for kind in kinds)


def _unindexed(spec: Mapping[str, Any]) -> dict[str, Any]:
    """Returns the properties of a declaration for a symbol that is not a member of its family."""
    return {key: value for key, value in spec.items() if key != "weight" or not isinstance(value, str)}


def _without_tilde(name: Name) -> Name:
    return replace(name, styles=tuple(style for style in name.styles if style != "\\tilde"))


def _tilded(symbols: dict[Name, Declaration]) -> dict[Name, Declaration]:
    """Returns the declarations with the flag `tilded` set. Raises SpecError for a tensor that would be the
    skew tensor of a vector."""
    tildes = [name for name in symbols if "\\tilde" in name.styles]
    plain = {_without_tilde(name) for name in tildes}
    for name in tildes:
        own = symbols.get(_without_tilde(name))
        if symbols[name].type.kind == "tensor" and own is not None and own.type.kind == "vector":
            raise SpecError(DeclarationCode.SKEW_TENSOR_VECTOR_SYMBOL(), str(name))
    owners = {declaration.name for name, declaration in symbols.items() if name in plain}
    return {n: d.with_flags(tilded=True) if d.name in owners else d for n, d in symbols.items()}


def _with_arguments(
    symbols: Mapping[Name, Declaration], functions: Mapping[Name, Sequence[str]]
) -> dict[Name, Declaration]:
    """Returns the declarations in which each function has the symbols that it is `of`. Raises SpecError."""
    table, made = SymbolTable(symbols), dict(symbols)
    arguments = {
        name: [_argument(name, text, table) for text in names]
        for name, names in functions.items()
        if name in symbols
    }
    named = {declaration.name for found in arguments.values() for declaration, _ in found}
    for pattern, declaration in symbols.items():
        if declaration.name in named and declaration.name not in functions:
            made[pattern] = declaration.with_flags(independent=True)
    known = {declaration.name: declaration for declaration in (CLOCK, *made.values())}

    def built(name: Name, above: tuple[Name, ...]) -> Declaration:
        if name in above:
            raise SpecError(DeclarationCode.FUNCTION_ITSELF(name=name), str(name))
        if name in arguments and not known[name].of:
            found = tuple(symbol(built(d.name, (*above, name)), index) for d, index in arguments[name])
            known[name] = replace(known[name], of=found)
        return known[name]

    return {pattern: built(declaration.name, ()) for pattern, declaration in made.items()}


def _argument(name: Name, text: str, table: SymbolTable) -> tuple[Declaration, tuple[Linear, ...]]:
    try:
        if read_key(text)[0] == CLOCK.name and CLOCK.name not in table.symbols:
            return CLOCK, ()
        found = table.find(key_spelling(parse(text).lines[0][0], text))
    except SpecError as error:
        raise SpecError(
            DeclarationCode.FAULT_OF_ARGUMENT(text=text, message=error.message), str(name)
        ) from None
    if found is None:
        raise SpecError(DeclarationCode.NO_DECLARED_SYMBOL(text=text), str(name))
    argument, index = found
    is_column = argument.type.kind == "scalar" or argument.type.is_column
    if not is_column or argument.type.dual or not all(place.is_number for place in index):
        raise SpecError(DeclarationCode.NO_SCALAR_NO_COLUMN(text=text), str(name))
    if argument.unit or argument.constant:
        raise SpecError(
            DeclarationCode.ARGUMENT_OF(text=text, value="a unit vector" if argument.unit else "constant"),
            str(name),
        )
    return argument, index

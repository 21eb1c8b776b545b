"""Definitions from the entries of [definitions]; names, types and weights are inferred from the bodies."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass, field, replace

from workbench.core import construct
from workbench.core.codes.declaration_codes import DeclarationCode
from workbench.core.codes.type_codes import TypeCode
from workbench.core.formula_errors import Fault, IllFormedAt, SpecError
from workbench.core.integer_expressions import Linear
from workbench.core.names import Name
from workbench.core.terms import Definition, Identity, IllFormed, Zero
from workbench.core.types import OPERATOR, SCALAR, TENSOR, VECTOR, Declaration, Type
from workbench.language.definition_cycles import entered
from workbench.language.definitions import Definitions
from workbench.language.grammar.parser import parse
from workbench.language.grammar.syntax import Bracket, Node, Product, Scripted, in_a_row
from workbench.language.naming.declarations import key_spelling, refuse_builtin, speaks_of
from workbench.language.naming.spelling import Named
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term

#: Growth of the weight of Φ_n with n, in the order in which the values are tried.
_SLOPES = (1, 0, 2, 3, -1, 4)


def read_definitions(entries: Mapping[str, str], table: SymbolTable) -> tuple[Definitions, SymbolTable]:
    """Returns all definitions of a paper, in order, and the table with their symbols added.

    Raises as `read_definition`.
    """
    definitions = []
    for key, body in entries.items():
        definition, table = read_definition(key, body, table)
        definitions.append(definition)
    return Definitions(definitions), table


def read_definition(key: str, body: str, table: SymbolTable) -> tuple[Definition, SymbolTable]:
    """Returns one definition, which uses only symbols of the table, and the table with its symbol added.

    The key is a symbol (α), a member of a family (Φ_1), a recurrence step (Φ_{n+1}, after its base), a whole
    family (Φ_n), or one of these with formal arguments, which are declared symbols: Φ_{n+1}(x). A symbol that
    is not in [symbols] gets the type and weight of its body; a family gets the linear weight that matches. A
    letter that does not occur in the body is a label: the l of J_l. Raises SpecError for the key, ReadError
    and IllFormedAt for the body.
    """
    head = _head(key, table)
    if letters := {
        letter for letter in head.variables if Name(letter) in table.symbols
    }:  # T_m next to a symbol m
        head = _head(key, table, letters)
    declaration = _known(head, table)
    if declaration is None and (labels := _labels(head, body, table)):
        head = _head(key, table, labels)
    if declaration is None:
        definition, table = _introduced(head, body, table)
    else:
        definition = _defined(head, declaration, _inside(head, table, declaration), body)
    return definition, entered(key, definition, table)


@dataclass(frozen=True)
class _Head:
    """The left side of a definition: its possible spellings, best first, and its formal arguments."""

    key: str
    spellings: tuple[Named, ...]
    formals: tuple[Declaration, ...]

    @property
    def own(self) -> Named:
        """The spelling in which letters are index slots and numbers are not."""
        return self.spellings[-1]

    @property
    def variables(self) -> frozenset[str]:
        return frozenset().union(*(place.variables for place in self.own[1]))

    @property
    def name(self) -> Name:
        return replace(self.own[0], parameters=len(self.formals))


def _head(key: str, table: SymbolTable, labels: Collection[str] = ()) -> _Head:
    try:
        lines = parse(key).lines
    except Fault as fault:
        raise SpecError(DeclarationCode.FAULT_AT_COLUMN(value=fault.at + 1, fault=fault), key) from None
    if len(lines) != 1 or len(lines[0]) != 1:
        raise SpecError(DeclarationCode.EXPECTED_ONE_SYMBOL(), key)
    node = lines[0][0]
    formals: tuple[Declaration, ...] = ()
    match node:
        case Product(items=(*name, Bracket(kind="(", parts=parts))):
            formals = tuple(_formal(part, table, key) for part in parts)
            node = in_a_row(node.at, name)
    if len(set(formals)) != len(formals):
        raise SpecError(DeclarationCode.FORMAL_ARGUMENTS_MUST_DIFFER(), key)
    spelling = key_spelling(node, key, labels)
    own = spelling.declared()
    for place in own[1]:
        if len(place.coefficients) != 1 or place.coefficients[0][1] != 1:
            raise SpecError(DeclarationCode.INDEX_EXPECTED_NUMBER_OR(place=place), key)
    letters = [name for place in own[1] for name in place.variables]
    if any(letters.count(name) > 1 for name in {*letters}.difference(table.frames.velocities)):
        raise SpecError(DeclarationCode.EACH_INDEX_PLACE_NEEDS(), key)
    return _Head(key, (*spelling.candidates(), own), formals)


def _formal(node: Node, table: SymbolTable, key: str) -> Declaration:
    try:
        found = table.find(key_spelling(node, key))
    except SpecError:
        found = None
    if found is None or found[1] or (isinstance(node, Scripted) and node.sup is not None):
        raise SpecError(DeclarationCode.FORMAL_ARGUMENT_MUST_SYMBOL(), key)
    return found[0]


def _labels(head: _Head, body: str, table: SymbolTable) -> frozenset[str]:
    """Returns the letters in index slots that are symbols or frames; or all letters, if the body contains
    none of them and no member is known."""
    if found := {
        letter
        for letter in head.variables
        if Name(letter) in table.symbols or letter in table.frames.velocities
    }:
        return frozenset(found)
    own, places = head.own
    is_spoken_of = speaks_of(body, head.variables)
    has_members = any(own.index_of(name) is not None for name in table.symbols)
    is_step = any(place.constant for place in places)
    return frozenset() if is_spoken_of or has_members or is_step or head.formals else head.variables


def _known(head: _Head, table: SymbolTable) -> tuple[Declaration, tuple[Linear, ...]] | None:
    """Returns the declaration of the left side in the table, and its index; None if there is none."""
    known = _names(head, table)
    for name, index in head.spellings:
        declaration = known.get(name)
        if declaration is not None:
            if index in table.defined.members.get(declaration.name, ()):
                raise SpecError(DeclarationCode.THIS_SYMBOL_DEFINED_ALREADY(), head.key)
            return declaration, index
    return None


def _inside(head: _Head, table: SymbolTable, known: tuple[Declaration, tuple[Linear, ...]]) -> SymbolTable:
    """Returns the table for the body, in which lower members of the family may be used."""
    declaration, index = known
    if not declaration.introduced or not head.variables:
        return table
    return _with_member(table, declaration, tuple(Linear.variable(n) for p in index for n in p.variables))


def _with_member(table: SymbolTable, declaration: Declaration, index: tuple[Linear, ...]) -> SymbolTable:
    return replace(table, defined=table.defined.with_member(declaration.name, index))


def _defined(
    head: _Head, known: tuple[Declaration, tuple[Linear, ...]], table: SymbolTable, body: str
) -> Definition:
    """Returns the definition of a symbol with known type and weight; the body must have the same."""
    declaration, index = known
    for flag in ("constant", "unit", "rotation", "transform", "symmetric", "diagonal", "coordinate", "free"):
        if flag in declaration.flags:
            raise SpecError(DeclarationCode.DECLARED_DEFINITION_NEED_NOT(flag=flag), head.key)
    term = read_term(body, table, head.variables)
    formals = [construct.symbol(formal) for formal in head.formals]
    try:
        relation = construct.relation("=", construct.symbol(declaration, index, formals), term)
        if relation.right.type.dual and not declaration.type.dual:
            raise IllFormed(TypeCode.DUAL_DEFINITION_OF_REAL(key=head.key))
        kind, defined = declaration.type.kind, relation.right.type.kind
        if defined != kind != "operator":
            raise IllFormed(TypeCode.DEFINITION_OF_ANOTHER_TYPE(key=head.key, kind=kind, defined=defined))
    except IllFormed as fault:
        raise IllFormedAt(fault, 1, 1) from None
    return Definition(declaration, index, head.formals, relation.right)


def _introduced(head: _Head, body: str, table: SymbolTable) -> tuple[Definition, SymbolTable]:
    """Returns the definition of a symbol that is not in [symbols]."""
    own, index = head.own
    bases = {name: place for name in _names(head, table) if (place := own.index_of(name)) is not None}
    if bases:
        return _recurrence(head, body, table, bases)
    term = read_term(body, table, head.variables)
    places = {
        name: Linear.variable(f"@{i}") - p.constant for i, p in enumerate(index) for name in p.variables
    }
    weight = None if term.weight is None else term.weight.substitute(places)
    refuse_builtin(own, term.type, head.key)
    declaration = _declaration(head, term.type, weight)
    table = table.with_symbol(declaration, head.formals)
    if isinstance(term, Zero | Identity) and not term.printed:
        types = (TENSOR, VECTOR, SCALAR) if isinstance(term, Zero) else (TENSOR, OPERATOR)
        untyped = {**table.defined.untyped, declaration.name: types}
        table = replace(table, defined=replace(table.defined, untyped=untyped))
    return Definition(declaration, index, head.formals, term), table


def _names(head: _Head, table: SymbolTable) -> Mapping[Name, Declaration]:
    return table.functions if head.formals else table.symbols


def _declaration(head: _Head, type_: Type, weight: Linear | None) -> Declaration:
    indices, parameters = len(head.own[1]), len(head.formals)
    made = Declaration(head.name, type_, weight, indices=indices, parameters=parameters)
    return made.with_flags(introduced=True)


def _recurrence(
    head: _Head, body: str, table: SymbolTable, bases: Mapping[Name, tuple[Linear, ...]]
) -> tuple[Definition, SymbolTable]:
    """Returns the step Φ_{n+1} after the base Φ_1: the numbered symbols become members of one family."""
    symbols = _names(head, table)
    declared = {name: symbols[name] for name in bases}
    free = [name for name, declaration in declared.items() if not declaration.introduced]
    if free or len(head.own[1]) != 1:
        raise SpecError(DeclarationCode.DECLARE_WHOLE_FAMILY_SYMBOLS(), head.key)
    rest = {name: d for name, d in symbols.items() if name not in bases}
    outer = replace(table, functions=rest) if head.formals else replace(table, symbols=rest)
    step = _Step(head, body, outer, {bases[name]: d for name, d in declared.items()})
    first = next(iter(declared.values()))
    untyped = table.defined.untyped.get(first.name)
    found = []
    for type_ in untyped or (first.type, OPERATOR):  # a tensor is an operator of degree 0
        fit = step.fit(type_)
        if fit is not None:
            found.append(fit)
            if untyped is None:
                break
    if not found:
        raise step.faults[0]
    if len(found) > 1:
        kinds = " or ".join(str(definition.declaration.type) for definition, _ in found)
        raise SpecError(DeclarationCode.FAMILY_MAY_DECLARE_SYMBOLS(kinds=kinds), head.key)
    return found[0]


@dataclass
class _Step:
    """A recurrence step whose family has no type and weight yet."""

    head: _Head
    body: str
    table: SymbolTable
    bases: Mapping[tuple[Linear, ...], Declaration]
    faults: list[IllFormedAt] = field(default_factory=list)

    def fit(self, type_: Type) -> tuple[Definition, SymbolTable] | None:
        """Returns the definition of a family of this type, real or else dual, with the matching weight; None
        if none does."""
        for dual in dict.fromkeys((type_.dual, True)):
            for weight in self.weights():
                try:
                    definition, table = self.attempt(type_.with_dual(dual), weight)
                except IllFormedAt as fault:
                    self.faults.append(fault)
                    continue
                if definition.body.type.with_dual(False) != type_.with_dual(False):
                    continue
                if definition.body.weight == definition.declaration.weight is None:
                    return definition, table
                return self.attempt(type_.with_dual(dual), self.of_members(definition.body.weight))
        return None

    def attempt(self, type_: Type, weight: Linear | None) -> tuple[Definition, SymbolTable]:
        family = _declaration(self.head, type_, weight)
        table = self.table.with_symbol(family, self.head.formals)
        for place in self.bases:
            table = _with_member(table, family, place)
        known = (family, self.head.own[1])
        return _defined(self.head, known, _inside(self.head, table, known), self.body), table

    def weights(self) -> Iterator[Linear | None]:
        """Yields weights linear in the index that match the bases; None if the bases have no weight."""
        (first, declaration), *_ = self.bases.items()
        if declaration.weight is None:
            yield None
            return
        for slope in _SLOPES:
            weight = Linear.variable("@0") * slope + (declaration.weight - first[0] * slope)
            if all(d.weight == weight.substitute({"@0": place[0]}) for place, d in self.bases.items()):
                yield weight

    def of_members(self, weight: Linear | None) -> Linear | None:
        """Returns the weight of Φ_n from that of Φ_{n+1}."""
        (place,) = self.head.own[1]
        ((letter, _),) = place.coefficients
        shift = {letter: Linear.variable("@0") - place.constant}
        return None if weight is None else weight.substitute(shift)

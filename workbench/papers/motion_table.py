"""The table [motion] of a paper file: quantities of Drake's motions for its symbols, and a robot."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from workbench.context.claims import Formula, Notation, OnMotions, Robot
from workbench.context.index_values import Orders
from workbench.context.read_formulas import read_statement
from workbench.core.codes.model_codes import ModelCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.integer_expressions import Linear
from workbench.core.paper_errors import KeyPath
from workbench.core.schema import key_names
from workbench.core.terms import Symbol
from workbench.core.types import Type
from workbench.drake.bindings import Bound, alternatives
from workbench.drake.special_motions import NAMES
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import read_term
from workbench.source.toml.toml_file import TomlTable, present_text

ROBOT, CLAIMS = "robot", "claims"
_ON_MOTIONS = key_names("motion claim")


def bindings(file: TomlTable, table: SymbolTable, keys: Sequence[str]) -> Iterator[tuple[Symbol, str]]:
    """Yields the symbols of the file's [motion] and the quantities they are bound to. Raises PaperError."""
    for key in keys:
        yield _binding(file, key, present_text(file, ("motion", key)), table)


def robot(file: TomlTable) -> Robot | None:
    """Returns the table [motion.robot]: a URDF file, relative to the paper's file, and a body of it."""
    path = ("motion", ROBOT)
    if ROBOT not in file.value(("motion",), dict, {}):
        return None
    for key in file.value(path, dict):
        if key not in key_names("motion robot"):
            raise file.error_at_key((*path, key), f"motion.robot: expected urdf and body, got {key}")
    urdf, body = (file.text((*path, key)) for key in ("urdf", "body"))
    if urdf is None or body is None:
        raise file.error_at_key(path, ModelCode.ROBOT_INCOMPLETE(urdf="urdf", body="body"))
    place = file.path.parent / urdf
    if not place.is_file():
        raise file.error_at_value((*path, "urdf"), f"motion.robot: no URDF file at {place}")
    return Robot(place, body)


def formulas(file: TomlTable, notation: Notation) -> Iterator[tuple[str, OnMotions]]:
    """Yields the entries of [motion.claims]: for a claim, a formula that holds and one that is false as
    printed, or why there is none.

    Raises:
        PaperError: An entry cannot be used.
    """
    for claim in file.value(("motion", CLAIMS), dict, {}):
        path = ("motion", CLAIMS, claim)
        for key in file.value(path, dict):
            if key not in _ON_MOTIONS:
                expected = ", ".join(_ON_MOTIONS)
                raise file.error_at_key((*path, key), f"motion: expected one of {expected}, got {key}")
        text, on, none = (file.text((*path, key)) for key in ("orders", "on", "none"))
        try:
            orders = None if text is None else Orders.parse(text)
        except ValueError as error:
            raise file.error_at_value((*path, "orders"), f"motion: {error}") from None
        if on is not None and on not in NAMES:
            raise file.error_at_value((*path, "on"), f"motion: expected one of {', '.join(NAMES)}, got {on}")
        holds, printed = (_formula(file, (*path, key), notation, orders) for key in ("holds", "printed"))
        if (holds is None) == (none is None):
            raise file.error_at_key(path, ModelCode.MOTION_INCOMPLETE(holds="holds", none="none"))
        yield claim, OnMotions(holds, printed, orders, on, none)


def _formula(file: TomlTable, path: KeyPath, notation: Notation, orders: Orders | None) -> Formula | None:
    text = file.text(path)
    if text is None:
        return None
    try:
        return Formula(text, read_statement(text, notation, orders)[0])
    except (ReadError, IllFormedAt) as error:
        raise file.error_in_string(path, error.line, error.column, f"motion: {error.message}") from None


def _binding(file: TomlTable, key: str, text: str, table: SymbolTable) -> tuple[Symbol, str]:
    path = ("motion", key)
    try:
        choices = alternatives(text)
    except ValueError as error:
        raise file.error_at_value(path, f"motion: {error}") from None
    try:
        symbol = read_term(key, table, {name for bound in choices for name in bound.variables})
    except (ReadError, IllFormedAt) as error:
        raise file.error_in_key(path, error.line, error.column, f"motion: {error.message}") from None
    if not isinstance(symbol, Symbol):
        raise file.error_at_key(path, "motion: expected one symbol on the left")
    for bound in choices:
        wrong = _misfit(key, symbol, bound)
        if wrong is not None:
            raise file.error_at_value(path, f"motion: {wrong}: {bound.binding.meaning}")
    return symbol, text


def _misfit(key: str, symbol: Symbol, bound: Bound) -> str | None:
    if bound.binding.shape != _shape(symbol.type):
        return f"{key} is a {symbol.type}, but {bound.text} has the shape {bound.binding.shape}"
    own = {name for index in symbol.index for name in index.variables}
    if not bound.variables <= own:
        return f"{bound.text} has an index that {key} has not"
    factor, constant = bound.weight
    weight = sum((Linear.variable(name) for name in bound.variables), Linear(0)) * factor + constant
    if symbol.weight is not None and symbol.weight != weight:
        return f"{key} has weight {symbol.weight}, but {bound.text} has weight {weight}"
    return None


def _shape(type_: Type) -> tuple[int, ...] | None:
    if type_.kind in ("covector", "operator"):
        return None
    shape = tuple(size for size in (type_.rows, type_.columns) if size > 1)
    return (2, *shape) if type_.dual else shape

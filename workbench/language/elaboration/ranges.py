"""Ranges of integers and set memberships in a formula.

∈ adds no hypothesis: a symbol whose declaration does not imply the membership is rejected.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.construct import apply, block, identity, number, relation, zero
from workbench.core.formula_errors import Fault
from workbench.core.integer_expressions import Linear, as_linear
from workbench.core.names import Name
from workbench.core.terms import Apply, Block, Relation, Symbol, Term
from workbench.core.types import TENSOR, VECTOR, Type
from workbench.language.grammar.syntax import (
    Bracket,
    Chain,
    Group,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Styled,
    Sum,
    core,
    in_a_row,
    unstyled,
)
from workbench.language.naming.linear_indices import linear, variable_name
from workbench.language.naming.spelling import INDEX_LETTERS, Scripts, spell
from workbench.language.naming.symbols import SymbolTable

NATURALS = {"\\mathbb{N}": 0, "\\mathbb{N}^{*}": 1}

#: Letter and dimension of a set → the kind of its members.
_SETS = {
    ("R", ""): "scalar",
    ("R", "3"): "vector",
    ("V", "3"): "vector",
    ("V", ""): "vector",
    ("E", "3"): "vector",
    ("SO", "3"): "rotation",
    ("SE", "3"): "transform",
    ("so", "3"): "skew tensor",
    ("se", "3"): "twist matrix",
    ("S", "2"): "unit vector",
}
_FOUR = Type(4, 4)
_LAST = block([[zero(VECTOR)], [number(1)]])


def _transposed(term: Term) -> Term:
    return apply("transpose", term)


def _upper_left(matrix: Term) -> Term:
    """Returns the upper left 3×3 block of a 4×4 matrix."""
    first = block([[identity(TENSOR)], [_transposed(zero(VECTOR))]])
    return apply("mul", apply("mul", _transposed(first), matrix), first)


#: Equations that characterize the members of a set, by the kind of the members and their type.
_EQUATIONS: dict[str | None, dict[Type, Callable[[Term], list[tuple[Term, Term]]]]] = {
    "skew tensor": {TENSOR: lambda x: [(apply("transpose", x), apply("neg", x))]},
    "rotation": {
        TENSOR: lambda x: [
            (apply("mul", apply("transpose", x), x), identity(TENSOR)),
            (apply("det", x), number(1)),
        ]
    },
    "unit vector": {VECTOR: lambda x: [(apply("dot", x, x), number(1))]},
    "transform": {
        _FOUR: lambda x: [
            (apply("mul", _transposed(_LAST), x), _transposed(_LAST)),
            *_EQUATIONS["rotation"][TENSOR](_upper_left(x)),
        ]
    },
    "twist matrix": {
        _FOUR: lambda x: [
            (apply("mul", _transposed(_LAST), x), zero(Type(1, 4))),
            *_EQUATIONS["skew tensor"][TENSOR](_upper_left(x)),
        ]
    },
}
_STYLE = re.compile(r"\\(mathbb|mathbf|mathrm|mathcal|mathfrak|mathsf|boldsymbol|underline)|[{}\s]")
_SIZE = "(?:[kmnpNM]|[1-9]n)"
_OF_TIME = re.compile(r"\^\{\\mathbb\{R\}\}$")


@dataclass(frozen=True, slots=True)
class Range:
    """The values of an integer variable in a formula: lower … upper, both included.

    None: no bound.   generic: no range is stated, and these values are examples.
    """

    variable: str
    lower: Linear
    upper: Linear | None = None
    generic: bool = False


@dataclass(frozen=True, slots=True)
class Membership:
    """The expressions that a formula states to be in a set."""

    members: tuple[Node, ...]
    where: Node


def is_range(clause: Chain, table: SymbolTable, integers: frozenset[str]) -> bool:
    """True if the clause states values of its letters, and is not a relation between terms."""
    signs = [sign for sign, _ in clause.relations]
    if clause.universal and set(signs) <= {"="}:
        names = {_index_name(side, table) for side in clause.sides[:1]}
        return all(name is not None and name not in table for name in names)
    if "∈" in signs or "≥" in signs or ">" in signs:
        return True
    if signs != ["="]:
        return False
    name, value = _index_name(clause.sides[0], table), clause.sides[1]
    is_value = isinstance(value, Leaf) and value.text.isdigit()
    is_variable = name in integers | INDEX_LETTERS and name not in table
    return _bar(value) is not None or (is_value and is_variable)


def qualifies(clause: Node, table: SymbolTable, integers: frozenset[str]) -> bool:
    """True if the clause is a condition of the equation next to it: f ≠ 0, or i = j for integers."""
    if not isinstance(clause, Chain):
        return False
    numbers = [side for side in clause.sides if isinstance(side, Leaf) and side.text.isdigit()]
    names = {_index_name(side, table) for side in clause.sides if side not in numbers}
    letters = {name for name in names if name is not None and name not in table}
    of_integers = letters == names and letters <= integers | INDEX_LETTERS
    return (bool(names) and of_integers) or all(sign == "≠" for sign, _ in clause.relations)


def _index_name(node: Node, table: SymbolTable) -> str | None:
    """Returns the integer variable of a range, else None. A bold letter counts as light if bold is not a
    symbol."""
    match node:
        case Styled(style="\\mathbf" | "\\boldsymbol" as style, body=body):
            name = variable_name(core(body))
            is_index = name in INDEX_LETTERS and Name(name, (style,)) not in table.symbols
            return name if is_index else None
    return variable_name(node)


def _bar(node: Node) -> tuple[Node, ...] | None:
    """Returns the a, b of \\overline{a, b}, else None."""
    match node:
        case Styled(style="\\overline", body=Group(parts=(_, _) as ends)):
            return ends
    return None


def ranges_of(
    clause: Chain, members: Sequence[Node], table: SymbolTable, integers: frozenset[str]
) -> list[Range | Membership]:
    """Returns the ranges or memberships of "n ≥ 1", or of "a, b ∈ S" with the members before the last. Raises
    Fault."""
    (sign, _), *more = clause.relations
    if more:
        raise Fault(SyntaxCode.EXPECTED_ONE_RANGE_SUCH(), more[0][1])
    left, right = clause.sides
    if sign == "∈":
        return _in_set((*members, left), right, table)
    refuse_alone(members)
    name = _index_name(left, table)
    if name is None:
        raise Fault(SyntaxCode.EXPECTED_INTEGER_VARIABLE_BEFORE(), left.at)
    if name in table:
        raise _no_variable(name, left.at)
    ends = _bar(right) or (right,)
    read = [linear(end, integers | {each for each in _letters(end) if each not in table}) for end in ends]
    bounds = [bound for bound in read if bound is not None]
    if len(bounds) < len(read):
        raise Fault(SyntaxCode.EXPECTED_INTEGER_BOUND(), right.at)
    lower = as_linear(bounds[0] + 1) if sign == ">" else bounds[0]
    return [Range(name, lower, bounds[-1] if sign == "=" else None)]


def _no_variable(name: str, at: int) -> Fault:
    return Fault(SyntaxCode.SYMBOL_WHAT_ASSUMED_SYMBOLS(name=name), at)


def _letters(node: Node) -> frozenset[str]:
    """Returns the integer variables in a bound such as m or n − 1."""
    if isinstance(node, Sum):
        return frozenset().union(*(_letters(addend) for _, _, addend in node.addends))
    name = variable_name(node)
    return frozenset() if name is None else frozenset({name})


def _in_set(members: tuple[Node, ...], where: Node, table: SymbolTable) -> list[Range | Membership]:
    """Returns the range of n ∈ ℕ, or the membership of a, b ∈ V₃."""
    lower = NATURALS.get(set_name(where))
    if lower is None:
        return [Membership(members, where)]
    names: list[str] = []
    for member in members:
        name = _index_name(member, table)
        if name is None:
            raise Fault(SyntaxCode.EXPECTED_INTEGER_VARIABLES_BEFORE(), member.at)
        names.append(name)
    for name, member in zip(names, members, strict=True):
        if name in table:
            raise _no_variable(name, member.at)
    return [Range(name, Linear(lower)) for name in names]


def refuse_alone(members: Sequence[Node]) -> None:
    """Raises Fault if there are expressions without a statement about them."""
    if members:
        raise Fault(SyntaxCode.ALONE(), members[0].at)


# Sets.


def require_member(term: Term, where: Node, at: int) -> None:
    """Raises Fault for an unknown set, and for a term that is not declared to be in it."""
    name, kind = set_name(where), kind_of_members(where)
    if kind is None:
        raise Fault(SyntaxCode.SET_WITHOUT_MEMBERS(name=name), where.at)
    dual = "dual " if "\\underline" in name else ""
    if not _is(term, kind) or (term.type.dual and not dual):
        got = "dual " * term.type.dual + (
            "rotation" if _is(term, "rotation") else str(term.type.with_dual(False))
        )
        raise Fault(SyntaxCode.MEMBER_HERE_DECLARED(name=name, dual=dual, kind=kind, got=got), at)


def member_claims(term: Term, where: Node, at: int, table: SymbolTable) -> list[Relation]:
    """Returns the equations that make the term a member of the set.

    Returns none if it is declared as a member, or if it is a matrix of free numbers, which the membership
    then defines. Raises Fault.
    """
    kind = kind_of_members(where)
    is_shaped = kind is not None and term.type in _EQUATIONS.get(kind, {})
    if kind is not None and is_shaped and not isinstance(term, Symbol) and not _is(term, kind):
        is_said = kind in ("rotation", "transform", "unit vector") and _is_of_free_numbers(term, table)
        return [] if is_said else [relation("=", *sides) for sides in _EQUATIONS[kind][term.type](term)]
    require_member(term, where, at)
    return []


def _is_of_free_numbers(term: Term, table: SymbolTable) -> bool:
    """True if a matrix has undefined scalars as entries."""
    entries = [entry for row in term.entries for entry in row] if isinstance(term, Block) else []
    return any(
        isinstance(entry, Symbol)
        and entry.type.kind == "scalar"
        and not table.defined.covers(entry.declaration.name, entry.index)
        for entry in entries
    )


def names_a_set(lines: Lines) -> bool:
    """True if a formula is a known set alone, such as SO(3)."""
    match lines.lines:
        case ((node,),):
            with suppress(Fault):
                return kind_of_members(node) is not None
    return False


def kind_of_members(where: Node) -> str | None:
    """Returns the kind of the members of a set, real or dual; None for an unknown set. Raises Fault."""
    name = _STYLE.sub("", _OF_TIME.sub("", set_name(where))).replace("^", "_")
    letter, _, dimension = name.partition("_")
    return _SETS.get((letter, dimension)) or (_columns(dimension) if letter == "R" else None)


def _is(term: Term, kind: str) -> bool:
    match kind:
        case "rotation":
            return isinstance(term, Symbol) and term.declaration.rotation
        case "unit vector":
            return isinstance(term, Symbol) and term.declaration.unit
        case "skew tensor":
            return isinstance(term, Apply) and term.head in ("skew", "antisymmetric")
        case "transform":
            return isinstance(term, Symbol) and term.declaration.transform
        case "column":
            return term.type.columns == 1 and term.type.kind != "quaternion"
        case "matrix":
            return term.type.kind not in ("operator", "quaternion")
    return kind in (term.type.kind, str(term.type.with_dual(False)))


def _columns(dimension: str) -> str | None:
    """Returns the kind of the members of ℝⁿ and ℝ^{n×m}; the size may be symbolic."""
    if re.fullmatch(_SIZE, dimension):
        return "column"
    if re.fullmatch(rf"{_SIZE}(?:×|\\times){_SIZE}", dimension):
        return "matrix"
    size = re.fullmatch(r"([1-9]\d?)(?:(?:×|\\times)([1-9]\d?))?", dimension)
    return str(Type(int(size[1]), int(size[2] or 1))) if size else None


def set_name(node: Node) -> str:
    """Returns the canonical name of a set; SO(3) is spelled SO_3. Raises Fault."""
    match node:
        case Product(items=(*letters, Bracket(kind="(", parts=(Leaf(kind="NUMBER") as size,)))):
            nucleus = in_a_row(node.at, letters)
            return set_name(Scripted(node.at, nucleus, size))
    scripted = node if isinstance(node, Scripted) else Scripted(node.at, node)
    letter: Any
    styles, letter = unstyled(scripted.nucleus)
    if isinstance(letter, Product) and all(isinstance(item, Styled) for item in letter.items):
        items: Any = letter.items
        styles = (*styles, items[0].style)
        letter = Product(letter.at, tuple(item.body for item in items))
    if isinstance(letter, Product) and all(isinstance(item, Leaf) for item in letter.items):
        leaves: Any = letter.items
        letter = Leaf(letter.at, "LETTER", "".join(leaf.text for leaf in leaves))  # SO
    scripts = Scripts(sub=scripted.sub, sup=scripted.sup)
    spelling = None
    if isinstance(letter, Leaf):
        spelling = spell(Name.styled(styles, letter.text), scripts, ())
    if spelling is None:
        raise Fault(SyntaxCode.EXPECTED_SET_SUCH_MATHBB(), node.at)
    return str(spelling)

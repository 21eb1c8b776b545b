"""Block matrices as matrices of scalars, so that products, sums and derivatives are those of any matrix."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import reduce
from itertools import product as pairs_of

from workbench.certificates.emission import emitted_nodes
from workbench.certificates.emission.collector import Collector
from workbench.certificates.emission.emitted_nodes import APPLICATION, ATOM, NotCertified
from workbench.core.construct import apply, block, identity, number, zero
from workbench.core.terms import Apply, Block, Derivative, Number, Symbol, Term, Zero
from workbench.core.types import TENSOR, Type
from workbench.engines.inventory import Lookup

_NOTHING = "(Num false (0 # 1))"


@dataclass(frozen=True)
class Matrix:
    """A matrix as text with its precedence level, and the deep copies of its entries."""

    text: str
    level: int
    entries: tuple[tuple[str, ...], ...]

    def at(self, level: int) -> str:
        return self.text if self.level <= level else f"({self.text})"

    @property
    def columns(self) -> int:
        return len(self.entries[0])


def is_column(term: Term) -> bool:
    """True if the term is a vector that is written as a column of three numbers."""
    return (
        isinstance(term, Block)
        and term.type.kind == "vector"
        and all(entry.type.kind == "scalar" for entry in term.children)
    )


def made_of_blocks(term: Term, definitions: Lookup) -> bool:
    """True if the term contains a matrix that is written entry by entry, other than a vector of size 3."""
    waiting, seen = [term], set()
    while waiting:
        part = waiting.pop()
        if (isinstance(part, Block) and not is_column(part)) or part.type.kind == "matrix":
            return True
        if part not in seen:
            seen.add(part)
            body = definitions.lookup(part) if isinstance(part, Symbol) else None
            waiting += part.children if body is None else (*part.children, body)
    return False


def matrix(emitter: Collector, term: Term) -> Matrix:
    if term.type.dual:
        raise NotCertified("a dual block matrix")
    if isinstance(term, Zero):
        return Matrix("void", ATOM, ((_NOTHING,) * term.type.columns,) * term.type.rows)
    if term.type.kind in emitted_nodes.KINDS and not made_of_blocks(term, emitter.definitions):
        return _cell(emitter, term)
    match term:
        case Symbol():
            return _defined(emitter, term)
        case Block():
            return _assembled(emitter, term)
        case Derivative():
            if not term.order.is_number:
                raise NotCertified("a derivative of symbolic order of a matrix")
            value = matrix(emitter, term.body)
            for _ in range(int(term.order)):
                entries = tuple(tuple(f"(DD {e})" for e in row) for row in value.entries)
                value = Matrix(f"mdot {value.at(ATOM)}", APPLICATION, entries)
            return value
        case Apply(head="add", arguments=arguments):
            return reduce(_plus, [matrix(emitter, a) for a in arguments])
        case Apply(head="neg", arguments=(a,)):
            value = matrix(emitter, a)
            entries = tuple(tuple(f"(Neg {e})" for e in row) for row in value.entries)
            return Matrix(f"mneg {value.at(ATOM)}", APPLICATION, entries)
        case Apply(head="mul", arguments=(left, right)):
            return _product(emitter, left, right)
        case Apply(head="inverse", arguments=(of,)):
            return _inverse(emitter, term, of)
    name = term.head if isinstance(term, Apply) else type(term).__name__
    raise NotCertified(f"{name} of block matrices")


def _cell(emitter: Collector, term: Term) -> Matrix:
    value = emitter.term(term)
    text = f"cell {value.at(ATOM)}"
    match value.kind:
        case "Scalar":
            entries: tuple[tuple[str, ...], ...] = ((value.deep,),)
        case "Vector":
            entries = tuple((f"(Comp {i} {value.deep})",) for i in range(3))
        case _:
            entries = tuple(tuple(f"(Comp {j} (Row {i} {value.deep}))" for j in range(3)) for i in range(3))
    return Matrix(text, APPLICATION, entries)


def _assembled(emitter: Collector, term: Block) -> Matrix:
    rows = []
    for line in term.entries:
        cells = [matrix(emitter, cell) for cell in line]
        widths = [cell.type.columns for cell in line]
        row = cells[-1]
        for cell, width in zip(reversed(cells[:-1]), reversed(widths[:-1]), strict=True):
            entries = tuple(a + b for a, b in zip(cell.entries, row.entries, strict=True))
            row = Matrix(f"beside {width} {cell.at(ATOM)} {row.at(ATOM)}", APPLICATION, entries)
        rows.append(row)
    total = rows[-1]
    for row in reversed(rows[:-1]):
        text = f"above {len(row.entries)} {row.at(ATOM)} {total.at(ATOM)}"
        total = Matrix(text, APPLICATION, row.entries + total.entries)
    return total


def _plus(left: Matrix, right: Matrix) -> Matrix:
    rows = zip(left.entries, right.entries, strict=True)
    entries = tuple(tuple(f"(Plus {a} {b})" for a, b in zip(r, s, strict=True)) for r, s in rows)
    return Matrix(f"mplus {left.at(ATOM)} {right.at(ATOM)}", APPLICATION, entries)


def _product(emitter: Collector, left: Term, right: Term) -> Matrix:
    if left.type.kind == "operator":
        raise NotCertified("an operator on a block matrix")
    if left.type.kind == "scalar":
        factor, value = emitter.term(left), matrix(emitter, right)
        entries = tuple(tuple(f"(Scale {factor.deep} {e})" for e in row) for row in value.entries)
        return Matrix(f"mscale {factor.at(ATOM)} {value.at(ATOM)}", APPLICATION, entries)
    return _rows_by_columns(matrix(emitter, left), matrix(emitter, right))


def _rows_by_columns(a: Matrix, b: Matrix) -> Matrix:
    if a.columns != len(b.entries):
        raise NotCertified("a matrix that acts on a column of vectors")
    columns = list(zip(*b.entries, strict=True))
    entries = tuple(tuple(_total(row, column) for column in columns) for row in a.entries)
    return Matrix(f"mprod {a.columns} {a.at(ATOM)} {b.at(ATOM)}", APPLICATION, entries)


def _total(row: Sequence[str], column: Sequence[str]) -> str:
    return reduce("(Plus {} {})".format, [f"(Scale {x} {y})" for x, y in zip(row, column, strict=True)])


def _inverse(emitter: Collector, term: Term, of: Term) -> Matrix:
    """Returns A⁻¹ as a matrix X with A X = X A = 1.

    It is any Y with A Y = 1, which a preceding theorem shows. For A = [P q; 0 1] that is [P⁻¹ −P⁻¹q; 0 1].
    """
    if term not in emitter.matrices:
        undone = _undone(of, emitter.definitions)
        value, solved = matrix(emitter, of), matrix(emitter, undone)
        lemma = emitter.shows([apply("mul", of, undone), apply("mul", undone, of)], _unit(of))
        name, n = emitter.fresh("inverse_of_it"), value.columns
        emitter.binders.append((name, "@matrix K"))
        own = [
            [emitter.slot(False, "Scalar", f"({name} {i}%nat {j}%nat)") for j in range(n)] for i in range(n)
        ]
        made = Matrix(name, ATOM, tuple(tuple(node.deep for node in row) for row in own))
        says = [pair for a, b in ((value, made), (made, value)) for pair in _is_unit(_rows_by_columns(a, b))]
        premise = f"inverse_matrix {n} {value.at(ATOM)} {name}"
        known = emitter.suppose(premise, f"{name}_is", says)
        emitter.solved[premise] = solved.text, lemma
        for i, j in pairs_of(range(n), repeat=2):
            shown = f"(same_inverse {known} (proj1 {lemma}) {i} {j} eq_refl)"
            emitter.stands_for(own[i][j], replace(own[i][j], deep=solved.entries[i][j]), shown)
        emitter.read_back[name] = term
        emitter.matrices[term] = made
    return emitter.matrices[term]


def _unit(of: Term) -> Term:
    n = of.type.rows - 1
    return block([[identity(), zero(Type(n, 1))], [zero(Type(1, n)), number(1)]])


def _is_unit(made: Matrix) -> list[tuple[str, str]]:
    return [
        (entry, emitted_nodes.number(int(i == j)).deep)
        for i, row in enumerate(made.entries)
        for j, entry in enumerate(row)
    ]


def _undone(term: Term, definitions: Lookup) -> Term:
    body = definitions.lookup(term) if isinstance(term, Symbol) else term
    match body:
        case Block(entries=((p, q), (Zero() as nothing, Number(value=1) as one))) if p.type == TENSOR:
            turned = isinstance(p, Symbol) and p.declaration.rotation
            back = apply("transpose" if turned else "inverse", p)
            return block([[back, apply("neg", apply("mul", back, q))], [nothing, one]])
    raise NotCertified("the inverse of a block matrix that is not [P q; 0 1]")


def _defined(emitter: Collector, symbol: Symbol) -> Matrix:
    if symbol not in emitter.matrices:
        body = emitter.definitions.lookup(symbol)
        if body is None:
            raise NotCertified("a block matrix that nothing defines")
        meaning = matrix(emitter, body)
        name = emitter.name(symbol)
        emitter.statement.append(f"let {name} : @matrix K := {meaning.text} in")
        emitter.introduced.append(name)
        emitter.read_back[name] = symbol
        emitter.matrices[symbol] = Matrix(name, ATOM, meaning.entries)
    return emitter.matrices[symbol]

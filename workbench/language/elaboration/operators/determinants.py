"""Determinants that spell a vector product: one row or column of vectors, the others of scalars."""

from __future__ import annotations

from functools import reduce

from workbench.core.terms import Term
from workbench.language.grammar.syntax import Bracket, Group, Matrix, Node
from workbench.language.naming.scope import Scope


def of_vectors(scope: Scope, node: Node) -> Term | None:
    """Returns the determinant of the 3×3 matrix, expanded by its vectors; None if all entries are scalars."""
    while isinstance(node, Group | Bracket) and len(node.parts) == 1:
        (node,) = node.parts
    if not isinstance(node, Matrix) or [len(row) for row in node.rows] != [3, 3, 3]:
        return None
    rows = [[scope.term(entry) for entry in row] for row in node.rows]
    for lines in (rows, [list(column) for column in zip(*rows, strict=True)]):
        kinds = [{entry.type.kind for entry in line} for line in lines]
        if sorted(map(sorted, kinds)) == [["scalar"], ["scalar"], ["vector"]]:
            place = kinds.index({"vector"})
            first, second = lines[(place + 1) % 3], lines[(place + 2) % 3]  # cyclic, so that no sign changes
            return _expanded(scope, node.at, lines[place], first, second)
    return None


def _expanded(scope: Scope, at: int, vectors: list[Term], first: list[Term], second: list[Term]) -> Term:
    def product(*factors: Term) -> Term:
        return reduce(lambda left, right: scope.apply(at, "mul", left, right), factors)

    def cofactor(place: int) -> Term:
        one, two = (place + 1) % 3, (place + 2) % 3
        minus = scope.apply(at, "neg", product(first[two], second[one]))
        return scope.apply(at, "add", product(first[one], second[two]), minus)

    terms = [product(cofactor(place), vector) for place, vector in enumerate(vectors)]
    return scope.apply(at, "add", *terms)

"""The notation of a text inferred from its formulas: marks, functions and letters before brackets."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from workbench.papers.drafting.inference.kind_operations import MARKED, SYMBOL, Operation
from workbench.papers.drafting.inference.kind_search import Search
from workbench.papers.drafting.inference.kind_signatures import TENSOR, VECTOR, combined
from workbench.papers.drafting.inference.tables import BRACKETS
from workbench.papers.drafting.inference.walker import Walker


def said_to_be_skew(trees: Iterable[Operation]) -> set[str]:
    """Returns the functions S for which the text states S(a) b = a × b."""
    found = set()
    for tree in trees:
        match tree:
            case Operation(op="equal", parts=(Operation(op="mul", parts=(applied, other)), cross)):
                pass
            case _:
                continue
        is_cross = cross.op == "cross" and applied.op == "apply" and applied.parts[0].op == SYMBOL
        if is_cross and cross.parts == (applied.parts[1], other):
            found.add(applied.parts[0].text)
    return found


def marks_of_exponents(trees: Iterable[Operation]) -> set[str]:
    r"""Returns \hat or \tilde if a marked letter is the exponent of e, perhaps times a number: it makes a
    skew tensor."""
    exponents = [each.parts[0] for tree in trees for each in tree.walk() if each.op == "exp"]
    factors = [part for each in exponents for part in (each, *(each.parts if each.op == "mul" else ()))]
    return {each.mark for each in factors if each.op == MARKED}


def skew_marks(search: Search) -> dict[str, bool]:
    r"""Returns, for \hat and \tilde, whether the mark makes skew tensors.

    That is so if most letters under it are vectors, and the marked letters tensors.
    """
    votes: dict[str, int] = defaultdict(int)
    seen: dict[str, set[str]] = defaultdict(set)
    for tree in search.operations():
        if tree.op != MARKED or tree.text in seen[tree.text]:
            continue
        mark = tree.mark
        if tree.text not in seen[mark]:
            seen[mark].add(tree.text)
            (inner,) = tree.parts
            is_skew = (
                search.kinds[tree.text] == TENSOR and search.costs.table(inner, search.kinds).get(VECTOR) == 0
            )
            votes[mark] += 1 if is_skew else -1
    return {mark: vote > 0 for mark, vote in votes.items()}


def applied_letters(search: Search) -> tuple[set[str], set[str]]:
    """Returns the letters that are functions before their brackets, and those that are factors."""
    better: dict[str, int] = defaultdict(int)
    for tree in search.operations():
        if tree.op == "apply" and (head := tree.head).op == SYMBOL:
            better[head.text] += _as_function(search, tree)
    functions = {name for name, vote in better.items() if vote > 0}
    return functions, {name for name, vote in better.items() if vote < 0}


def _as_function(search: Search, tree: Operation) -> int:
    """Returns how much less the bracket costs as arguments than as a factor."""
    as_product, as_value = BRACKETS.get(tree.text, (99, 0))
    parts = [search.costs.table(each, search.kinds) for each in tree.parts]
    product, value = combined("mul", parts), combined("value", parts)
    return min(product.values()) + as_product - min(value.values()) - as_value


@dataclass(frozen=True)
class Rewriter:
    """Rewrites operations by the notation that was inferred for a text.

    Attributes:
        skew_marks: Marks that make skew tensors.
        name_marks: Marks that are part of a name.
        skews: Functions S of skew tensors S(a).
        functions: Letters that are functions before brackets.
        products: Letters that are factors before brackets.
    """

    walker: Walker
    skew_marks: frozenset[str] | set[str] = frozenset()
    name_marks: frozenset[str] | set[str] = frozenset()
    skews: frozenset[str] | set[str] = frozenset()
    functions: frozenset[str] | set[str] = frozenset()
    products: frozenset[str] | set[str] = frozenset()

    def all(self, trees: Sequence[Operation]) -> tuple[Operation, ...]:
        return tuple(map(self.tree, trees))

    def tree(self, tree: Operation) -> Operation:
        if not tree.parts:
            return tree
        make = self.walker.make
        parts = tuple(map(self.tree, tree.parts))
        if tree.op == MARKED:
            mark = tree.mark
            if mark in self.skew_marks:
                return make("skew", *parts)
            if mark in self.name_marks:
                return make(SYMBOL, text=tree.text)
        if tree.op == "apply":
            head = tree.head
            if head is tree.parts[0] and head.text in self.skews:
                return make("skew", parts[1])
            if head.text in self.functions:
                return make("apply", *parts, text="sure")
            if head.text in self.products and tree.text != "sure":
                return make("mul", *parts)
        return make(tree.op, *parts, text=tree.text)

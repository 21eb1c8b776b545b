"""Beam search for the most likely joint kinds of the symbols of one formula, bottom up."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping, Sequence
from itertools import islice

from workbench.papers.drafting.inference.kind_operations import NAMED, Operation
from workbench.papers.drafting.inference.kind_signatures import Kind
from workbench.papers.drafting.inference.tables import Costs

#: Beam widths: kinds of a symbol, joint kinds of a formula, and joint kinds for each kind of a value.
_LEAF, _BEAM, _PER_KIND = 10, 30, 6

Kinds = dict[str, Kind]
#: (cost of the kinds for their symbols, cost of the tree with them, the kinds).
Option = tuple[int, int, Kinds]


class Beams:
    """Joint kinds of the symbols of a tree."""

    def __init__(self, costs: Costs) -> None:
        self._costs = costs

    def joint(self, trees: Sequence[Operation], own: Mapping[str, Mapping[Kind, int]]) -> list[Kinds]:
        """Returns joint kinds of the symbols of a formula, the most likely first.

        own: symbol → kind → cost.
        """
        self._own = own
        return [kinds for _, _, kinds in self._merged([self._beam(tree) for tree in trees])][:_BEAM]

    def _beam(self, tree: Operation) -> list[Option]:
        """Returns some joint kinds for each kind of the tree's value."""
        if tree.op in NAMED and not tree.parts:
            return self._leaf(tree.text)
        lists = [self._beam(part) for part in tree.parts]
        lists += [self._leaf(tree.text)] if tree.op in NAMED else []
        by_kind: dict[Kind | None, list[tuple[int, int]]] = defaultdict(list)
        made: list[Option] = []
        for place, (own, _, kinds) in enumerate(self._merged(lists)):
            table = self._costs.table(tree, kinds)
            made.append((own, min(table.values()), kinds))
            for value, cost in table.items():
                by_kind[value].append((cost + own, place))
        kept = {place for ranked in by_kind.values() for _, place in sorted(ranked)[:_PER_KIND]}
        return [made[place] for place in sorted(kept)]

    def _leaf(self, name: str) -> list[Option]:
        return [(cost, 0, {name: kind}) for kind, cost in islice(self._own[name].items(), _LEAF)]

    def _merged(self, lists: Sequence[list[Option]]) -> list[Option]:
        """Returns the joint kinds of several parts; each symbol has the same kind in all parts."""
        if len(lists) == 1:
            return lists[0]
        found: list[Option] = [(0, 0, {})]
        for each in lists:
            names = each[0][2] if each else {}
            shared = [name for name in found[0][2] if name in names] if found else []
            by_shared: dict[tuple[Kind, ...], list[Option]] = defaultdict(list)
            for its, more, other in each:  # all options of a list have the same symbols
                counted = sum([self._own[name][other[name]] for name in shared])
                by_shared[tuple([other[name] for name in shared])].append((its - counted, more, other))
            pairs = [
                (own + its, cost + more, one, other)
                for own, cost, one in found
                for its, more, other in by_shared.get(tuple([one[name] for name in shared]), ())
            ]
            pairs.sort(key=lambda pair: pair[0] + pair[1])
            found = [(own, cost, one | other) for own, cost, one, other in pairs[: 3 * _BEAM]]
        return found

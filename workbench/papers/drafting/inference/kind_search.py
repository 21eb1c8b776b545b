"""Local search for the kinds of all symbols of a text that minimize the total cost."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

from workbench.papers.drafting.inference.beams import Beams
from workbench.papers.drafting.inference.kind_operations import NAMED, Operation
from workbench.papers.drafting.inference.kind_signatures import MISFIT, SCALAR, Kind
from workbench.papers.drafting.inference.priors import Priors, face, likeness
from workbench.papers.drafting.inference.tables import Costs
from workbench.runtime import stop_if_asked

#: Costs in tenths: of different kinds for two symbols that are written alike; the weight of an inline formula
#: relative to a display.
_UNLIKE, _INLINE = 12, 4
#: A symbol with a kind that costs at least this much more than its cheapest one makes its formulas suspect.
_STRANGE = 12
#: The typefaces of vectors; formulas with several such letters fit only if all of them are vectors.
_OF_VECTORS = ("hat", "marked", "bold small")
#: The typefaces of one kind, for authors who have typefaces of kinds.
_OF_MARKS = (*_OF_VECTORS, "bold capital", "component")
#: The operations that relate values which other operations make.
_OF_SIDES = ("add", "equal")
_ROUNDS, _MOST_OPTIONS, _MOST_MENDED, _MOST_OTHERS = 12, 10, 3, 3
#: The limit of the number of readings of operations; the search stops there with the kinds found so far.
_MOST_READINGS = 400_000


@dataclass(frozen=True, eq=False)
class Formula:
    """A formula as operations, with its line, whether it stands in a sentence, and its section."""

    trees: tuple[Operation, ...]
    line: int = 0
    inline: bool = False
    section: str = ""

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(sorted({name for tree in self.trees for name in tree.names}))

    @property
    def is_spoken_equation(self) -> bool:
        return self.inline and any(tree.op == "equal" and len(tree.names) > 1 for tree in self.trees)


Change = Mapping[str, Kind]


class Search:
    """The kinds of the symbols, and their total cost."""

    def __init__(
        self,
        formulas: Sequence[Formula],
        priors: Priors,
        start: Mapping[str, Kind] | None = None,
        costs: Costs | None = None,
    ) -> None:
        self.formulas, self.costs = [each for each in formulas if each.trees], costs or Costs()
        self.names = [each.names for each in self.formulas]
        self.users: dict[str, list[int]] = defaultdict(list)
        for index, names in enumerate(self.names):
            for name in names:
                self.users[name].append(index)
        self.prior = {name: priors.of(name) for name in self.users}
        self.said = frozenset(filter(priors.is_said, self.users))
        self.kinds: dict[str, Kind] = {name: next(iter(own)) for name, own in self.prior.items()}
        self.kinds |= {name: kind for name, kind in (start or {}).items() if name in self.kinds}
        self.alike: dict[str, list[str]] = defaultdict(list)
        for name in self.users:
            if face(name) != "component":
                self.alike[likeness(name)].append(name)
        self._known: dict[tuple[int, tuple[Kind, ...]], int] = {}
        self._joint: dict[tuple[int, tuple[Kind, ...]], list[Change]] = {}
        self._hopeless: dict[int, tuple[Kind, ...]] = {}
        self._beams = Beams(self.costs)
        self._now = [self._cost(index, None) for index in range(len(self.formulas))]
        self._settled: set[str] = set()

    # --------------------------------------------------------------------------------------- the cost

    def cost(self, place: int, change: Change | None = None) -> int:
        """Returns the cost of a formula after a change of kinds."""
        return self._cost(place, change) if change else self._now[place]

    def _cost(self, place: int, change: Change | None) -> int:
        names, now = self.names[place], self.kinds
        own = tuple([change.get(n) or now[n] for n in names] if change else [now[n] for n in names])
        known = self._known.get(key := (place, own))
        if known is None:
            stop_if_asked()
            formula, kinds = self.formulas[place], dict(zip(names, own, strict=True))
            total = sum(self.costs.least(tree, kinds) for tree in formula.trees)
            known = self._known[key] = total * _INLINE // 10 if formula.inline else total
        return known

    def own(self, names: Collection[str], change: Change) -> int:
        """Returns the cost of the symbols by themselves, and relative to symbols that are written alike."""

        def at(name: str) -> Kind:
            return change.get(name) or self.kinds[name]

        total = sum(self.prior[name][at(name)] for name in names)
        for group in {likeness(name) for name in names}:
            if len(members := self.alike.get(group, ())) > 1:
                usual = Counter(map(at, members))
                total += _UNLIKE * (len(members) - max(usual.values()))
        return total

    def gain(self, change: Change, least: int = 0) -> int:
        """Returns the decrease of the total cost after the change; an upper bound if it is not above
        `least`."""
        change = {name: kind for name, kind in change.items() if self.kinds[name] != kind}
        places = {place for name in change for place in self.users[name]}
        best = self.own(change, {}) - self.own(change, change) + sum([self._now[p] for p in places])
        for place in places:
            if best <= least:
                return best
            best -= self._cost(place, change)
        return best

    def total(self) -> int:
        return self.own(self.users, {}) + sum(map(self.cost, range(len(self.formulas))))

    # ------------------------------------------------------------------------------------- the search

    def run(self) -> None:
        """Changes kinds until the total cost no longer decreases."""
        for _ in range(_ROUNDS):
            changed = self._singles(self.users)
            changed |= self._groups()
            changed |= self._repairs()
            if not changed or self._is_late():
                return

    def _is_late(self) -> bool:
        return self.costs.count > _MOST_READINGS

    def _take(self, changes: Iterable[Change]) -> bool:
        """Applies the best of the changes, and returns whether it gains anything."""
        best, chosen = 0, None
        for change in changes:
            if change and (gain := self.gain(change, best)) > best:
                best, chosen = gain, change
        if chosen is not None:
            self._change(chosen)
        return chosen is not None

    def _change(self, change: Change) -> None:
        changed = {name for name, kind in change.items() if self.kinds[name] != kind}
        self.kinds |= change
        for place in {place for name in changed for place in self.users[name]}:
            self._now[place] = self._cost(place, None)
            self._settled.difference_update(self.names[place])
        for name in changed:
            self._settled.difference_update(self.alike.get(likeness(name), ()))

    def _singles(self, names: Iterable[str]) -> bool:
        changed = False
        for name in names:
            if name not in self._settled:
                changed |= self._take({name: kind} for kind in self._options(name))
                self._settled.add(name)
        return changed

    def _options(self, name: str) -> list[Kind]:
        """Returns the kinds of a symbol that may cost less than its present kind."""
        most = sum(map(self.cost, self.users[name])) + _UNLIKE + self.prior[name][self.kinds[name]]
        return [kind for kind, own in self.prior[name].items() if own < most]

    def _groups(self) -> bool:
        changed = False
        hatted = [name for name in self.users if "\\hat{" in name]
        for names in [*self.alike.values(), hatted]:
            if len(names) > 1 and any(self.cost(place) for name in names for place in self.users[name]):
                kinds = self.prior[names[0]]
                changed |= self._take(
                    {name: kind for name in names if kind in self.prior[name]} for kind in kinds
                )
        marked = {name: next(iter(own)) for name, own in self.prior.items() if face(name) in _OF_VECTORS}
        return self._take([marked]) or changed

    def _repairs(self) -> bool:
        """Changes several symbols of a misfit formula at once, and then repairs the formulas that this
        breaks."""
        changed = False
        for place in sorted(range(len(self.formulas)), key=self.cost, reverse=True):
            names = self.names[place]
            strange = (self.prior[name][self.kinds[name]] - min(self.prior[name].values()) for name in names)
            is_wrong = self.cost(place) >= MISFIT * (_INLINE if self.formulas[place].inline else 10) // 20
            if not (is_wrong or max(strange, default=0) >= _STRANGE) or self._is_late():
                continue
            state = tuple(self.kinds[name] for name in names)
            if self._hopeless.get(place) == state:
                continue
            if self._take(self._together(place)) or self._chain(place):
                changed = True
            else:
                self._hopeless[place] = state
        return changed

    def _together(self, place: int) -> list[Change]:
        """Returns changes of any number of the formula's symbols that make it cheaper."""
        state = place, tuple([self.kinds[name] for name in self.names[place]])
        if (found := self._joint.get(state)) is None:
            found = self._joint[state] = list(self._cheaper_together(place))
        return found

    def _cheaper_together(self, place: int) -> Iterator[Change]:
        names = self.names[place]
        now = self.cost(place) + sum(self.prior[name][self.kinds[name]] for name in names)
        own = {name: self._own_of(name) for name in names}
        for kinds in self._beams.joint(self.formulas[place].trees, own):
            change = {name: kind for name, kind in kinds.items() if self.kinds[name] != kind}
            cost = sum(self.prior[name][kind] for name, kind in kinds.items())
            if change and self.cost(place, change) + cost < now:
                yield change

    def _own_of(self, name: str) -> Mapping[Kind, int]:
        """Returns the cost of each kind for the symbol alone, plus the cost of giving up its present kind."""
        given_up, now = 3 * min(len(self.users[name]), 5), self.kinds[name]
        costs = {kind: own + (given_up if kind != now else 0) for kind, own in self.prior[name].items()}
        return dict(sorted(costs.items(), key=lambda item: item[1]))

    def _chain(self, place: int) -> bool:
        """Makes a change that repairs the formula and breaks others, with changes that repair these."""
        before, total = dict(self.kinds), self.total()
        options = sorted(self._together(place), key=self.gain, reverse=True)[:_MOST_OPTIONS]
        for change in options:
            self._change(change)
            for _ in range(_MOST_MENDED):
                broken = {p for name in change for p in self.users[name] if self.cost(p) >= MISFIT // 2}
                names = {name for p in broken for name in self.names[p]} - change.keys()
                singles = (self._take({n: kind} for kind in self._options(n)) for n in sorted(names))
                if not (any(singles) or self._take(self._around(change, broken))):
                    break
            if self.total() < total:
                return True
            self._change(before)
        return False

    def _around(self, change: Change, places: Collection[int]) -> Iterator[Change]:
        """Yields joint changes of the symbols of these formulas that keep a change."""
        for place in sorted(places):
            yield from (each for each in self._together(place) if change.keys().isdisjoint(each))

    # ------------------------------------------------------------------------------------ the outcome

    def others(self, name: str) -> list[tuple[Kind, int]]:
        """Returns the next best kinds of a symbol and the increase of the total cost, the cheapest first."""
        now = self.kinds[name]
        bounds = sorted(
            (-self.gain({name: kind}), str(kind), kind) for kind in self.prior[name] if kind != now
        )
        found: list[tuple[int, str, Kind]] = []
        for least, text, kind in bounds:  # `gain` stops at the first loss
            if len(found) >= _MOST_OTHERS and sorted(found)[_MOST_OTHERS - 1][0] <= least:
                break
            found.append((self._dearer(name, kind), text, kind))
        return [(kind, more) for more, _, kind in sorted(found)[:_MOST_OTHERS]]

    def _dearer(self, name: str, kind: Kind) -> int:
        """Returns the increase of the cost with another kind."""
        change = {name: kind}
        more = sum(self._cost(place, change) - self._now[place] for place in self.users[name])
        return more + self.own(change, change) - self.own(change, {})

    def cured_by(self, place: int) -> list[str]:
        """Returns the symbols of a misfit formula that are likely meant with other kinds.

        These are symbols whose other kind would explain misfits on other lines as well, or those of a cure:
        other kinds that suit the formula, where no other evidence supports the present kind of one of the
        symbols.
        """
        if spoilt := self._spoilt(place):
            return sorted(spoilt)
        for change in self._cures(place):
            if not any(self._is_supported(name, place, change) for name in change):
                return sorted(change)
        return []

    def _cures(self, place: int) -> Iterator[Change]:
        """Yields other kinds of one symbol of a formula, or of several, that suit the formula."""
        names = self.names[place]
        singles = ({name: kind} for name in names for kind in self.prior[name])
        several = self._beams.joint(self.formulas[place].trees, {name: self._own_of(name) for name in names})
        for kinds in (*singles, *several):
            change = {name: kind for name, kind in kinds.items() if self.kinds[name] != kind}
            if self._cost(place, change) < MISFIT // 2:
                yield change

    def _spoilt(self, place: int) -> set[str]:
        """Returns the symbols whose other kind would explain misfits on other lines, too.

        One wrong kind, or one misread notation, explains several misfits better than several errors do."""
        line, own = self.formulas[place].line, _shape(self.formulas[place].trees)
        misfit = [
            other
            for other, cost in enumerate(self._now)
            if cost >= MISFIT // 2 and not self.formulas[other].inline
        ]
        has_twin = any(other != place and _shape(self.formulas[other].trees) == own for other in misfit)
        found: set[str] = {*self.names[place]} if has_twin else set()
        for other in misfit:
            if self.formulas[other].line == line:
                continue
            alike = {likeness(name) for name in self.names[other]}
            shared = {name for name in self.names[place] if likeness(name) in alike}
            found.update(name for name in shared if not (self.is_firm(name) or self._fits(name, place)))
            if self._is_same_misfit(place, other):
                found |= shared
            found |= {name for name in shared if self._may_be_wrong(name, (place, other), misfit)}
        return found

    def _fits(self, name: str, place: int) -> bool:
        """True if at least as many displays fit with a symbol as other displays do not."""
        costs = [self._now[p] for p in self.users[name] if p != place and not self.formulas[p].inline]
        return sum(cost < MISFIT // 2 for cost in costs) * 2 >= len(costs)

    def _is_same_misfit(self, place: int, other: int) -> bool:
        """True if the same operation on the same symbol fits in neither formula: a notation is misread."""
        one, two = (
            {
                (each.op, name)
                for tree in self.formulas[index].trees
                for each in self.costs.misfits(tree, self.kinds)
                if each.op not in _OF_SIDES
                for name in map(likeness, each.names)
            }
            for index in (place, other)
        )
        return not one.isdisjoint(two)

    def _may_be_wrong(self, name: str, pair: tuple[int, int], misfit: Sequence[int]) -> bool:
        """True if another kind of a symbol, and of those written like it, suits one of two misfit formulas
        and breaks no formula that fits."""
        group = self.alike.get(likeness(name), [name])
        fits = {other for each in group for other in self.users[each]}.difference(misfit)
        for kind in self.prior[name]:
            changes = ({name: kind}, {each: kind for each in group if kind in self.prior[each]})
            for change in changes:
                is_cure = any(self._cost(each, change) < MISFIT // 2 for each in pair)
                if is_cure and all(self._cost(each, change) < MISFIT // 2 for each in fits):
                    return True
        return False

    def _is_supported(self, name: str, place: int, change: Change) -> bool:
        """True if another formula of its section or a word supports the present kind of a symbol, and its
        letter does not suggest another one.

        A change of size only is supported by nothing, as a text uses a letter at several sizes."""
        now, prior = self.kinds[name], self.prior[name]
        if prior[now] > min(prior.values()) or _is_resized(now, change[name]):
            return False
        section = self.formulas[place].section
        others = (p for p in self.users[name] if p != place and self.formulas[p].section == section)
        breaks = any(self._cost(other, change) - self._now[other] >= MISFIT // 2 for other in others)
        return breaks or name in self.said

    def is_firm(self, name: str) -> bool:
        """True if words or a marked typeface state the present kind of a symbol, and not only formulas."""
        own = self.prior[name]
        return own[self.kinds[name]] == min(own.values()) and (face(name) in _OF_MARKS or name in self.said)

    def needed_once(self) -> Iterator[tuple[str, int, Kind]]:
        """Yields symbols whose kind rests on one display, and on no equation in a sentence: the name, index
        of the display, and the kind without it."""
        for name, places in self.users.items():
            for kind in list(self.prior[name])[:_MOST_OPTIONS]:
                change = {name: kind}
                dearer = {p: self._cost(p, change) - self._now[p] for p in places}
                more = self.own(change, change) - self.own(change, {}) + sum(dearer.values())
                spoken = sum(max(dearer[p], 0) for p in places if self.formulas[p].is_spoken_equation)
                more += spoken * 10 // _INLINE - spoken
                alone = (p for p, own in dearer.items() if own > more and not self.formulas[p].inline)
                if kind != self.kinds[name] and (place := next(alone, None)) is not None:
                    yield name, place, kind
                    break

    def operations(self) -> Iterator[Operation]:
        """Yields all operations of the formulas."""
        return (each for formula in self.formulas for tree in formula.trees for each in tree.walk())


def _shape(trees: Sequence[Operation]) -> list[str]:
    """Returns the operations of a formula in order, without its letters."""
    return ["" if each.op in NAMED else f"{each.op} {each.text}" for tree in trees for each in tree.walk()]


def _is_resized(kind: Kind, other: Kind) -> bool:
    """True if both are columns, rows or matrices, of different sizes."""
    if isinstance(kind, str) or isinstance(other, str):
        return False
    return SCALAR not in (kind, other) and [n == 1 for n in kind] == [n == 1 for n in other]

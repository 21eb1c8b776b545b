"""Random points modulo the prime at which supposed equations hold."""

from __future__ import annotations

from collections.abc import Sequence

from flint import nmod, nmod_mat

from workbench.core.terms import Relation, Symbol
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.parameters import SPHERES
from workbench.engines.jet.jets import JetEngine
from workbench.engines.jet.rings import PRIME, PointSource
from workbench.repair.screening.random_points import FlintResidueRing, RandomPoint

_Group = tuple[Symbol, str, int]
#: How often the other parameters of a quadratic equation are changed until it has a root.
_TRIES = 12


def satisfy(point: RandomPoint, equations: Sequence[Relation], definitions: Lookup) -> bool:
    """Changes the point so that the equations hold there, and returns whether a root was taken for that.

    Raises NotExact if this fails.
    """
    solved: set[_Group] = set()
    took_root = False
    for equation in equations:
        _differences(point, equation, definitions)  # adds all parameters of the equation to the point
        groups = dict.fromkeys((p.symbol, p.part, p.order) for p in point if p.part not in SPHERES)
        open_ = [group for group in reversed(groups) if group not in solved]
        found = next((group for group in open_ if _solve(point, equation, definitions, group)), None)
        if found is None:
            found, took_root = _by_a_root(point, equation, definitions, open_), True
        solved.add(found)
    if any(any(_differences(point, e, definitions)) for e in equations):
        raise NotExact("the supposed equations depend on one another")
    return took_root


def _by_a_root(
    point: RandomPoint, equation: Relation, definitions: Lookup, groups: Sequence[_Group]
) -> _Group:
    """Solves an equation that is quadratic in a number, as x² + y² = 1 is, and returns the number."""
    for _ in range(_TRIES):
        for group in groups:
            if _solve_square(point, equation, definitions, group):
                return group
        for parameter in point:
            if (parameter.symbol, parameter.part, parameter.order) in groups:
                point[parameter] += 1
    raise NotExact("no symbol in which the supposed equation is linear or quadratic")


def _solve(point: RandomPoint, equation: Relation, definitions: Lookup, group: _Group) -> bool:
    """Solves an equation for the components of one derivative of one symbol if it is linear in them, and
    returns whether that succeeded."""
    parameters = [p for p in point if (p.symbol, p.part, p.order) == group]
    before = dict(point)

    def at(values: Sequence[int]) -> list[nmod]:
        point.update({p: nmod(v, PRIME) for p, v in zip(parameters, values, strict=True)})
        return _differences(point, equation, definitions)

    size = len(parameters)
    start = at([0] * size)
    units = [[int(i == j) for j in range(size)] for i in range(size)]
    columns = [[x - y for x, y in zip(at(unit), start, strict=True)] for unit in units]
    matrix = nmod_mat(len(start), size, [int(c[i]) for i in range(len(start)) for c in columns], PRIME)
    if len(start) == size and matrix.rank() == size:
        target = nmod_mat(size, 1, [int(-x) for x in start], PRIME)
        if not any(at([int(x) for x in matrix.solve(target).entries()])):
            return True
    point.update(before)
    return False


def _solve_square(point: RandomPoint, equation: Relation, definitions: Lookup, group: _Group) -> bool:
    """Solves an equation for one number if it is quadratic in it with a root modulo the prime, and returns
    whether that succeeded."""
    parameters = [p for p in point if (p.symbol, p.part, p.order) == group]
    if len(parameters) != 1:
        return False
    (parameter,), before = parameters, point[parameters[0]]

    def at(value: nmod) -> list[nmod]:
        point[parameter] = value
        return _differences(point, equation, definitions)

    values = [at(nmod(number, PRIME)) for number in range(4)]
    if all(len(each) == 1 for each in values):
        start, one, two, three = (each[0] for each in values)
        square = (two - 2 * one + start) / nmod(2, PRIME)
        slope = one - start - square
        root = (slope * slope - 4 * square * start) ** ((PRIME + 1) // 4)
        is_quadratic = square and 9 * square + 3 * slope + start == three
        if is_quadratic and not any(at((root - slope) / (2 * square))):
            return True
    point[parameter] = before
    return False


def _differences(point: RandomPoint, equation: Relation, definitions: Lookup) -> list[nmod]:
    engine = JetEngine(PointSource(FlintResidueRing(), point), definitions)
    try:
        return engine.differences(equation.left, equation.right)
    except ZeroDivisionError:
        raise NotExact("a denominator vanishes in a supposed equation") from None

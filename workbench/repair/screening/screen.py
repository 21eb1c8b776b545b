"""Fast test of candidates: the residual modulo a 61-bit prime at random points.

A non-zero residual at a point where no denominator vanishes shows that the statement is false: the numerator
is then not the zero polynomial, so the statement fails at some rational point, also at one where all assumed
disequations hold. The argument fails where a root was taken, which has two values; assumed equations are
solved by Cramer's rule, so that the point stands for rational ones. A zero residual proves nothing; the judge
decides.

A candidate shares with the printed statement all subterms except those above the change. Their values are
cached, so that only the changed subterms are computed.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from workbench.core.integer_expressions import Linear
from workbench.core.integer_instances import Instantiation, instantiate
from workbench.core.statement_parts import conjuncts
from workbench.core.terms import IllFormed, Relation, Statement, Symbol, Term, sides_of
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.angle_combinations import with_parts_of_angles
from workbench.engines.inventory.assumptions import Assumptions
from workbench.engines.inventory.inventory import take_inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.engines.jet.rings import PointSource
from workbench.repair.screening.random_points import FlintResidueRing, RandomPoint
from workbench.repair.screening.sharing_engine import SharingEngine
from workbench.repair.screening.supposed_points import satisfy

#: The most points tried to find one where the roots of the printed statement exist.
_TRIED_POINTS = 64


class ScreenPoint:
    """One point, and one assignment of the integers. Instances of terms are shared between candidates."""

    def __init__(self, values: Mapping[str, int], engine: SharingEngine) -> None:
        self.engine = engine
        self._instances = Instantiation({name: Linear(value) for name, value in values.items()})
        self._has_integers = bool(values)
        self._kept = 0

    def instance(self, formula: Any) -> Any:
        return self._instances.formula(formula) if self._has_integers else formula

    def keep(self) -> None:
        """Keeps the values computed so far for all later candidates."""
        self._kept = len(self._instances.done)
        self.engine.keeps = False

    def forget_candidate(self) -> None:
        if self.engine.keeps:
            return
        self.engine.forget_candidate()
        done = self._instances.done
        while len(done) > self._kept:
            done.popitem()

    def residual(self, statement: Statement) -> tuple[int, ...] | None:
        """Returns left − right for all equations of the statement; None if there is no such number."""
        try:
            found: list[int] = []
            for relation in equations_of(self.instance(statement)):
                found += map(int, self.engine.differences(relation.left, relation.right))
            return tuple(found)
        except (ZeroDivisionError, NotExact, IllFormed, ValueError):
            return None
        finally:
            self.forget_candidate()

    def lacks_root(self, statement: Statement) -> bool:
        """True if a root or a quotient has no value at this point."""
        try:
            for relation in equations_of(self.instance(statement)):
                self.engine.differences(relation.left, relation.right)
        except ZeroDivisionError:
            return True
        except (NotExact, IllFormed, ValueError):
            return False
        return False

    def parts(self, term: Term) -> tuple[list[int], list[int]] | None:
        """Returns the components of the real and of the dual part; those of an operator by rising power of
        D."""
        try:
            instance = self.instance(term)
            is_operator = instance.type.kind == "operator"
            values = self.engine.operator(instance, 0) if is_operator else (self.engine.value(instance, 0),)
        except (ZeroDivisionError, NotExact, IllFormed, ValueError):
            return None
        real = [int(x) for value in values for x in value.re[0].ravel()]
        dual = [0] * len(real)
        if any(value.du is not None for value in values):
            dual = [
                0 if value.du is None else int(value.du[0].ravel()[i])
                for value in values
                for i in range(value.re[0].size)
            ]
        return real, dual

    def components(self, term: Term) -> tuple[int, ...] | None:
        """Returns the term's own components, and caches its values for products with it as a factor."""
        kept, self.engine.keeps = self.engine.keeps, True
        try:
            return tuple(map(int, self.engine.components(self.instance(term))))
        except (ZeroDivisionError, NotExact, IllFormed, ValueError):
            return None
        finally:
            self.engine.keeps = kept
            self._kept = len(self._instances.done)


class Screen:
    """The points at which candidates for one statement are tested.

    Assumed equations are satisfied by solving them for a free symbol in which they are linear, or else
    quadratic. Raises NotExact if there is none.

    instances: assignments of the integer variables.
    assume: the assumptions of the claim.
    """

    def __init__(
        self,
        definitions: Lookup,
        assume: Sequence[Statement] = (),
        instances: Sequence[Mapping[str, int]] = ({},),
        seed: int = 0,
        about: Statement | None = None,
    ) -> None:
        self.points: list[ScreenPoint] = []
        self._ring = FlintResidueRing()
        self._assume, self._about = assume, about
        for number, values in enumerate(instances):
            self.points.append(self._defined_point(definitions, values, seed + number))

    def _defined_point(self, definitions: Lookup, values: Mapping[str, int], seed: int) -> ScreenPoint:
        """Returns a point at which the printed statement has a value, if one of a few tried is such.

        A root modulo the prime exists at about every second point.
        """
        found = self._point(definitions, values, seed)
        for again in range(1, _TRIED_POINTS):
            if self._about is None or not found.lacks_root(self._about):
                break
            found = self._point(definitions, values, seed + 10_000 * again)
        return found

    def _point(self, definitions: Lookup, values: Mapping[str, int], seed: int) -> ScreenPoint:
        point = RandomPoint(seed)
        supposed = Assumptions([instantiate(a, values) if values else a for a in self._assume])
        about = instantiate(self._about, values) if self._about is not None and values else self._about
        known = _with_circles(point, (*supposed.relations, *([] if about is None else [about])), definitions)
        if satisfy(point, supposed.equations, known):
            self._ring.took_roots = True
        return ScreenPoint(values, SharingEngine(PointSource(self._ring, point), known))

    def keep(self, statement: Statement) -> tuple[int, ...] | None:
        """Returns the residual, and keeps the values of all subterms for later candidates."""
        residual = self.residual(statement)
        for point in self.points:
            point.keep()
        return residual

    def residual(self, statement: Statement) -> tuple[int, ...] | None:
        """Returns left − right for all equations of the statement at all points.

        Returns None if a denominator vanishes, an index leaves its family, or the statement does not consist
        of equations.
        """
        found: list[int] = []
        for point in self.points:
            residual = point.residual(statement)
            if residual is None:
                return None
            found += residual
        return tuple(found)

    def vanishes(self, statement: Statement) -> bool:
        """True if the residual is zero at all points with a value, and at one at least.

        A root of another square than the printed one has no value at about every second point.
        """
        has_value = False
        for point in self.points:
            residual = point.residual(statement)
            if residual is None:
                if not (self._ring.took_roots and point.lacks_root(statement)):
                    return False
            elif any(residual):
                return False
            else:
                has_value = True
        return has_value

    def components(self, term: Term, shape: Term) -> tuple[int, ...] | None:
        """Returns the components of the term at all points, each with as many components as the real part of
        `shape`.

        There is a real and a dual part. Missing coefficients of an operator and missing dual parts are 0.
        """
        found: list[int] = []
        for point in self.points:
            parts = point.parts(term)
            count = point.parts(shape)
            point.forget_candidate()
            if parts is None or count is None or len(parts[0]) > len(count[0]):
                return None
            for part in parts:
                found += part + [0] * (len(count[0]) - len(part))
        return tuple(found)


def _with_circles(point: RandomPoint, about: Sequence[Statement], definitions: Lookup) -> Lookup:
    """Returns the definitions with parts of angles, and adds the circles of compound angles to the point.

    Such angles are those that are no symbols, for example ‖x‖ and ω t.
    """
    sides = [side for statement in about for side in sides_of(statement)]
    try:
        known = with_parts_of_angles(sides, definitions)
        circles = take_inventory(sides, known).circles.values()
    except (NotExact, IllFormed, ZeroDivisionError):
        return definitions
    for angle in circles:
        if not isinstance(angle, Symbol):
            point[Parameter(angle, "circle", 0, 0)]
    return known


def equations_of(statement: Statement) -> Iterator[Relation]:
    """Yields the equations of the statement. Raises NotExact for other statements."""
    for part in conjuncts(statement):
        if not isinstance(part, Relation) or part.operator != "=":
            raise NotExact("not an equation")
        yield part

"""Cases: one claim prepared for the engines, with its inventory, its assumptions and its points."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from functools import cached_property
from itertools import chain, islice
from typing import TYPE_CHECKING, Any

from workbench.algebra.differential_ring import Polynomial
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import number
from workbench.core.construct import relation as equated
from workbench.core.names import Name
from workbench.core.terms import Relation, Statement, Symbol, Term
from workbench.core.verdict import Counterexample, Evidence, Outcome, Verdict
from workbench.engines.inventory import Lookup, NotExact
from workbench.engines.inventory.angle_combinations import with_parts_of_angles
from workbench.engines.inventory.assumptions import Assumptions, Unsatisfiable
from workbench.engines.inventory.inventory import Inventory, take_inventory
from workbench.engines.inventory.parameters import Parameter
from workbench.engines.jet.number_field import NumberFieldRing
from workbench.engines.polynomial.polynomial_engine import ExactEngine
from workbench.language.function_places import has_moved_place, places_apart
from workbench.language.printing.printer import to_latex
from workbench.prover.counterexamples.rational_points import (
    Trial,
    accepted,
    counterexample,
    first_trial,
    trial_at,
    trials,
    with_zeros,
)
from workbench.prover.counterexamples.real_angles import AT_REAL_POINT, is_pi, real_trials, surely_differ
from workbench.prover.counterexamples.solution_points import solved_points
from workbench.prover.decide.both_engines import Engines
from workbench.prover.decide.ideals import impossible, square_of
from workbench.prover.decide.zero_sets import Equations, solve

if TYPE_CHECKING:
    from workbench.engines.jet.sympy_engine import SympyEngine

#: Number of random points that are cheaper to try than solving for points.
_FEW = 40


@dataclass(frozen=True)
class Setting:
    """Settings that all claims of a paper share.

    second_engine: True if SymPy rechecks proofs. Without it the best outcome is `probable`, since one engine
    alone proves nothing.
    laws: True if an equation may be a law; each member of a family must follow from the definitions.
    bound: the names of the symbols that stand for quantities of a motion, and so are not free.
    """

    definitions: Lookup
    second_engine: bool = True
    bound: frozenset[Name] = frozenset()
    laws: bool = True
    engines: Engines = field(default_factory=Engines, compare=False, repr=False)


class Case:
    """The engines over the inventory of some relations and their assumptions."""

    def __init__(
        self,
        setting: Setting,
        relations: Sequence[Relation],
        assume: tuple[Statement, ...],
        definitions: Lookup | None = None,
    ) -> None:
        self.setting = setting
        self.assumptions = Assumptions(assume)
        supposed = (*self.assumptions.relations, *self.assumptions.bounds)
        self.sides = [side for r in (*relations, *supposed) for side in (r.left, r.right)]
        known = setting.definitions if definitions is None else definitions
        self.definitions = with_parts_of_angles(self.sides, known)
        self.inventory: Inventory = take_inventory(self.sides, self.definitions)

    @property
    def exact(self) -> ExactEngine:
        """The polynomial engine."""
        return self._supposing[0]

    @property
    def second(self) -> SympyEngine:
        """The jet engine over SymPy's polynomials."""
        from workbench.engines.jet.sympy_engine import SympyEngine

        make = SympyEngine if self.assumptions.equations else self.setting.engines.second
        return make(self.inventory, self.definitions)

    @cached_property
    def _supposing(self) -> tuple[ExactEngine, list[Polynomial]]:
        """The polynomial engine, and the polynomials assumed not to be 0, including all divisors in the
        assumptions."""
        supposed = self.assumptions.relations
        engine = (ExactEngine if supposed else self.setting.engines.first)(self.inventory, self.definitions)
        for relation in supposed:
            engine.residuals(relation)
        apart = [square_of(engine, relation) for relation in self.assumptions.nonzero]
        return engine, [*engine.ring.denominators, *apart]

    def require_satisfiable(self) -> None:
        """Raises Unsatisfiable if it is proved that no point satisfies the assumptions, since they would
        imply anything.

        Raises NotExact if no point is found and that is not proved.
        """
        admitted = self._admitted(lambda trial: True)
        points = trials(self.inventory, self.definitions, self._completed)
        first = islice(points, _FEW)
        if not (self.assumptions.relations or self.assumptions.bounds) or any(
            accepted(t, admitted) for t in chain(first, self._solved(), points)
        ):
            return
        if impossible(self.exact, self.assumptions):
            raise Unsatisfiable(VerdictCode.UNSATISFIABLE())
        if self.find_real(lambda trial: True):
            return
        if not self.measured_angles:
            raise NotExact("no point was found where the assumptions hold, and it is not proved that none is")
        if self.assumptions.equations:
            raise NotExact("an equation under which an angle stands beside its sine or cosine")

    def find(self, accept: Callable[[Trial], bool], positive_nowhere: Term | None = None) -> Trial | None:
        """Returns a small point that satisfies the assumptions and is accepted; see also `first_trial`."""
        admitted = self._admitted(accept)
        found = first_trial(self.inventory, self.definitions, admitted, self._completed, positive_nowhere)
        if found or (solved := next((t for t in self._solved() if accepted(t, admitted)), None)) is None:
            return found
        return with_zeros(solved, self.definitions, admitted, NumberFieldRing())

    def find_real(self, accept: Callable[[Trial], bool]) -> Trial | None:
        """Returns such a point among those with real angles and matching sines, in balls."""
        irrational = self.inventory.norms or self.inventory.circles or self.measured_angles or self.has_pi
        if self.assumptions.equations or not irrational:
            return None
        supposed, bounds = self.assumptions.nonzero, self.assumptions.bounds
        for trial in real_trials(self.inventory, self.definitions):
            try:
                is_admitted = all(surely_differ(trial, r) for r in supposed) and all(map(trial.meets, bounds))
                if is_admitted and accept(trial):
                    return trial
            except NotExact:
                continue
        return None

    def _solved(self) -> Iterator[Trial]:
        """Yields points at which the equations are solved for coordinates, rational or algebraic ones."""
        if not self.assumptions.equations:
            return
        for point in solved_points(self.exact, self.assumptions.equations, self.inventory):
            yield trial_at(point, self.definitions, NumberFieldRing())

    def _admitted(self, accept: Callable[[Trial], bool]) -> Callable[[Trial], bool]:
        supposed, bounds = self.assumptions.relations, self.assumptions.bounds
        return lambda t: (
            self._may_solve(t.point)
            and self._is_real(t)
            and accept(t)
            and all(map(t.holds, supposed))
            and all(map(t.meets, bounds))
        )

    def _may_solve(self, point: Mapping[Parameter, Any]) -> bool:
        """True unless an equation that is not solved fails at a rational point, by its polynomial alone."""
        if not self.assumptions.equations or not all(
            isinstance(each, Fraction | int) for each in point.values()
        ):
            return True
        rational = dict(point)
        with suppress(NotExact):
            return not any(self.exact.at(p, rational) for p in self.solved.rest)
        return True

    def _completed(self, point: dict[Parameter, Fraction]) -> dict[Parameter, Fraction]:
        """Returns the point with the parameters for which the equations are solved set to their values."""
        if not self.assumptions.equations:
            return point
        point = dict(point)
        with suppress(NotExact):  # the point is not on the equations then, and is not used
            for pivot in reversed(self.solved.solved):
                point[self.exact.parameter_of(pivot.generator)] = self.exact.at(pivot.value, point)
        return point

    @cached_property
    def measured_angles(self) -> list[Symbol]:
        """The angles that occur both in and outside sines, as in sin α = α: only α = 0 has a rational
        point."""
        return [a for a in self.inventory.angles if self._uses(a, "value", 1) and self._uses(a, "circle", 2)]

    @cached_property
    def has_pi(self) -> bool:
        """Whether π occurs outside of sines, where a rational value of it says nothing."""
        return any(is_pi(each) and self._uses(each, "value", 1) for each in self.inventory.orders)

    def _uses(self, angle: Symbol, part: str, count: int) -> bool:
        parameters = [Parameter(angle, part, 0, component) for component in range(count)]
        try:
            return any(self.exact.depends(self.sides, p) for p in parameters)
        except ZeroDivisionError:
            return True

    def _is_real(self, trial: Trial) -> bool:
        circles = self.inventory.circles.values()
        angles = self.inventory.angles if circles else self.measured_angles
        try:
            return all(
                not trial.engine.value(angle, 0).re[0][()] and trial.engine.circle(angle)[0] == 1
                for angle in (*angles, *circles)
            )
        except ZeroDivisionError:  # an angle that is a quotient, undefined at the point
            return False

    @cached_property
    def solved(self) -> Equations:
        engine, nonzero = self._supposing
        return solve(engine, self.assumptions.equations, nonzero)

    def counterexample(self, trial: Trial, relation: Relation) -> Counterexample:
        """Returns the trial's point; an angle is given by the part of it that occurs, its value or its cosine
        and sine."""
        angles = self.inventory.angles
        turned = [a for a in angles if not trial.real and not self._uses(a, "value", 1)]
        return counterexample(trial, relation, self.inventory, turned)

    def refuted(self, trial: Trial, relation: Relation) -> Verdict:
        """Returns the verdict that the relation, or the statement that it is part of, fails at the trial's
        point."""
        example = self.counterexample(trial, relation)
        method = AT_REAL_POINT if trial.real else "rational point, exact arithmetic"
        evidence = Evidence(method, "the two sides differ")
        return Verdict(Outcome.REFUTED, counterexample=example, evidence=(evidence,))


def at_places_apart(
    judge: Callable[[Statement, tuple[Statement, ...]], Verdict],
    statement: Statement,
    assume: tuple[Statement, ...],
) -> Verdict:
    """Returns the verdict; a refutation holds at a point where the places of each function differ.

    Raises NotExact for a function at another place where the place may move."""
    if has_moved_place((statement, *assume)):
        raise NotExact("a function at another place below a derivative, an integral or a limit")
    verdict = judge(statement, assume)
    apart = tuple(each for each in places_apart((statement, *assume)) if each not in assume)
    is_near = isinstance(statement, Relation) and statement.operator == "≈"  # its places are not apart
    if is_near or verdict.outcome is not Outcome.REFUTED or not apart or _keeps_apart(judge, verdict, apart):
        return verdict
    try:
        return judge(statement, (*assume, *apart))
    except Unsatisfiable:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.PLACES_MAY_BE_ONE())


def _keeps_apart(
    judge: Callable[[Statement, tuple[Statement, ...]], Verdict], verdict: Verdict, apart: Sequence[Relation]
) -> bool:
    """True if the places differ where the counterexample lies; symbols that it does not name are free."""
    values = verdict.counterexample.values if verdict.counterexample else {}
    for each in apart:
        symbols = dict.fromkeys(part for side in (each.left, each.right) for part in side.symbols())
        if not all(part.type.kind == "scalar" for part in symbols):
            return False
        known = [part for part in symbols if to_latex(part) in values]
        at_point = tuple(equated("=", part, number(Fraction(*values[to_latex(part)]))) for part in known)
        with suppress(NotExact, Unsatisfiable, ValueError):
            if judge(equated("=", each.left, each.right), at_point).outcome is Outcome.REFUTED:
                continue
        return False
    return True

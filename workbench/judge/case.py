"""One claim made ready for the engines: what it is about, what it supposes, where a point can be found."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from itertools import islice

from workbench.algebra.differential_ring import Polynomial
from workbench.judge.assumptions import Assumptions, Unsatisfiable
from workbench.judge.exact import ExactEngine
from workbench.judge.inventory import Inventory, Lookup, NotExact, take_inventory
from workbench.judge.parameters import Parameter
from workbench.judge.points import Trial, accepted, counterexample, first_trial, trial_at, trials
from workbench.judge.vanishing import Equations, points_on, solve
from workbench.judge.verdict import Counterexample, Evidence, Outcome, Verdict
from workbench.language.terms import Relation, Statement, Symbol


@dataclass(frozen=True)
class Setting:
    """What all claims of a paper share.

    motion: what symbols are on Drake's reference motions (symbol → binding).
    second_engine, motions: whether proofs are rechecked by SymPy and on Drake's motions. Without the second
    engine no outcome is `proved`, since one engine alone proves nothing here: it is `probable`.
    """

    definitions: Lookup
    motion: Mapping[Symbol, str] | None = None
    second_engine: bool = True
    motions: bool = True


class NoDefinitions:
    """Every symbol is free. What holds for any tensor at the place of Φ₄ holds for Φ₄."""

    def lookup(self, symbol: Symbol) -> None:
        return None


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
        self.definitions = setting.definitions if definitions is None else definitions
        self.assumptions = Assumptions(assume)
        self.sides = [side for r in (*relations, *self.assumptions.relations) for side in (r.left, r.right)]
        self.inventory: Inventory = take_inventory(self.sides, self.definitions)

    @cached_property
    def exact(self) -> ExactEngine:
        return ExactEngine(self.inventory, self.definitions)

    def require_satisfiable(self) -> None:
        """Raises Unsatisfiable if no point satisfies the assumptions: under them anything would be proved;
        NotExact where that cannot be told."""
        admitted = self._admitted(lambda trial: True)
        points = trials(self.inventory, self.definitions, self._completed)
        if not self.assumptions.relations or any(accepted(trial, admitted) for trial in points):
            return
        if not self.measured_angles:
            raise Unsatisfiable("no values of the symbols satisfy the assumptions")
        if self.assumptions.equations:
            raise NotExact("an equation under which an angle stands beside its sine or cosine")

    def find(self, accept: Callable[[Trial], bool]) -> Trial | None:
        """A small point that satisfies the assumptions and is accepted."""
        return first_trial(self.inventory, self.definitions, self._admitted(accept), self._completed)

    def find_on(self, p: Polynomial, accept: Callable[[Trial], bool], most: int = 150) -> Trial | None:
        """The same where p vanishes, on lines along one parameter through `most` small points."""
        admitted = self._admitted(accept)
        for start in islice(trials(self.inventory, self.definitions, self._completed), most):
            for point in points_on(self.exact, p, start.point):
                trial = trial_at(point, self.definitions)
                if accepted(trial, admitted):
                    return trial
        return None

    def _admitted(self, accept: Callable[[Trial], bool]) -> Callable[[Trial], bool]:
        supposed = self.assumptions.relations
        return lambda t: self._is_real(t) and all(t.holds(r) for r in supposed) and accept(t)

    def _completed(self, point: dict[Parameter, Fraction]) -> dict[Parameter, Fraction]:
        """The point with the parameters for which the equations are solved put to their values."""
        if not self.assumptions.equations:
            return point
        point = dict(point)
        for generator, value in reversed(self.solved.solved):
            point[self.exact.parameter_of(generator)] = self.exact.at(value, point)
        return point

    @cached_property
    def measured_angles(self) -> list[Symbol]:
        """The angles that stand beside their sines and cosines, as in sin α = α: no rational point but
        α = 0 is one of theirs."""
        return [a for a in self.inventory.angles if self._uses(a, "value", 1) and self._uses(a, "circle", 2)]

    def _uses(self, angle: Symbol, part: str, count: int) -> bool:
        parameters = [Parameter(angle, part, 0, component) for component in range(count)]
        try:
            return any(self.exact.depends(self.sides, p) for p in parameters)
        except ZeroDivisionError:
            return True

    def _is_real(self, trial: Trial) -> bool:
        return all(
            not trial.point[_angle(angle)] and trial.engine.circle(angle)[0] == 1
            for angle in self.measured_angles
        )

    @cached_property
    def solved(self) -> Equations:
        return solve(self.exact, self.assumptions.equations)

    def counterexample(self, trial: Trial, relation: Relation) -> Counterexample:
        """The trial's point, an angle told by what of it occurs: its value, or its cosine and sine."""
        angles = self.inventory.angles
        turned = [a for a in angles if not self._uses(a, "value", 1)]
        return counterexample(trial, relation, self.inventory, turned)

    def refuted(self, trial: Trial, relation: Relation) -> Verdict:
        """The verdict that the relation, or the statement it is part of, fails at the trial's point."""
        example = self.counterexample(trial, relation)
        evidence = Evidence("rational point, exact arithmetic", "the two sides differ")
        return Verdict(Outcome.REFUTED, counterexample=example, evidence=(evidence,))


def _angle(angle: Symbol) -> Parameter:
    return Parameter(angle, "value", 0, 0)

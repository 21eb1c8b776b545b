"""Decides extrema of f(x) = ‖p + L x‖, of f quadratic in x, over all numbers and vectors x, and of f linear
over unit vectors. Each case reduces to equations, which the judge of equations decides.

f = c + 2 b·y + y·A y in the unknown components y (of a norm, f²). A has no negative eigenvalue if it is LᵀL,
or if the sums cₖ of its principal minors are all ≥ 0. Let r be the greatest k with cₖ not identically 0, and
A y* = −b. The least value is c + b·y* where c_r ≠ 0, since f = c + b·y* + (y − y*)·A (y − y*). Where c_r is
0, A is 0 if c₁ vanishes there too, and f does not depend on y.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cached_property

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, block, number, power, relation, zero
from workbench.core.reasons import Reason
from workbench.core.terms import Apply, Extremum, Implication, Relation, Statement, Term, Zero
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.engines.inventory import NotExact
from workbench.engines.inventory.assumptions import Unsatisfiable
from workbench.engines.inventory.signs import is_seen_nonnegative
from workbench.language.definitions import expand
from workbench.prover.counterexamples.rational_points import Trial
from workbench.prover.decide.case import Case, Setting
from workbench.prover.decide.ideals import has_even_powers
from workbench.prover.decide.inference import conclusion
from workbench.prover.decide.objective import Objective, at_zero_part
from workbench.prover.decide.quadratic_forms import Quadratic, minus, solved, times, total

Judge = Callable[[Statement, tuple[Statement, ...]], Verdict]

_HOLDS = frozenset({Outcome.PROVED, Outcome.CONDITIONAL})
_MOST = 6  # unknown components


def judge_extremum(setting: Setting, said: Extremum, assume: tuple[Statement, ...], judge: Judge) -> Verdict:
    """Returns the verdict on an extremum. Raises NotExact if it is neither quadratic nor linear on a
    sphere."""
    value = expand(said.value, setting.definitions)
    varied = Objective.of(said, setting.definitions, assume)
    if any(letter in value.walk() for letter in said.letters):
        raise NotExact("the other side depends on what varies")
    case = _Question(setting, said, value, varied, assume, judge)
    if any(letter.declaration.unit for letter in said.letters):
        return case.on_sphere()
    return case.verdict()


@dataclass
class _Question:
    setting: Setting
    said: Extremum
    value: Term
    varied: Objective
    assume: tuple[Statement, ...]
    judge: Judge

    def verdict(self) -> Verdict:
        """Returns the verdict for an extremum over all values of the unknown numbers and vectors."""
        if self.varied.count > _MOST:
            raise NotExact(f"a minimum or maximum over more than {_MOST} numbers")
        form = self._shown(self.form, self.quadratic.written_out)
        if form is None:
            raise NotExact("a minimum or maximum of what is neither a norm of linear terms nor quadratic")
        beyond = self._beyond()
        if beyond is not None:
            return beyond
        if not self.has_norm and not all(map(self._is_nonnegative, self.quadratic.invariants[1:])):
            return _unchecked(VerdictCode.SIGN_OF_FORM_OPEN())
        if self.has_norm and not is_seen_nonnegative(self.value):
            return _unchecked(VerdictCode.SIGN_OF_NORM_OPEN())
        parts = [form, *self._where_regular()]
        if all(part.outcome in _HOLDS for part in parts) and self.rank:
            parts += self._where_singular()
        return self._together(parts)

    def on_sphere(self) -> Verdict:
        """Returns the verdict on p·u + c over all unit vectors u: the extremum is c ± ‖p‖ (Cauchy and
        Schwarz), at u = ± p/‖p‖, or at any u."""
        if len(self.said.letters) > 1:
            raise NotExact("a minimum or maximum over unit vectors and more")
        body, at = self.varied.body, self.varied.at
        constant = at({})
        slopes = [minus(at({i: 1}), constant) for i in range(3)]
        form = self._shown(body, lambda: total([constant, *map(times, slopes, self.varied.unknowns)]))
        if form is None:
            raise NotExact("over unit vectors a minimum or maximum of what is linear in them")
        length = apply("norm", block([[slope] for slope in slopes]))
        bound = minus(constant, length) if self.said.least else total([constant, length])
        return self._together([form, self.judge(relation("=", bound, self.value), self.assume)])

    def _shown(self, left: Term, right: Callable[[], Term]) -> Verdict | None:
        with suppress(NotExact):
            verdict = self.judge(relation("=", left, right()), self.assume)
            return verdict if verdict.outcome in _HOLDS else None
        return None

    # The form.

    @cached_property
    def quadratic(self) -> Quadratic:
        return Quadratic(self.varied, self.said.least)

    @cached_property
    def least(self) -> Term:
        return self.quadratic.value_at_rank(self.rank)

    def _said(self, form: Term) -> Relation:
        """Returns the equation of the form and the wanted value; for a greatest value with the signs as
        written."""
        if self.has_norm or self.said.least:
            return relation("=", form, self.wanted)
        return relation("=", apply("neg", form), self.value)

    @property
    def has_norm(self) -> bool:
        return self.varied.inside is not None

    @cached_property
    def form(self) -> Term:
        """The form: f, −f for a greatest value, or f² for a norm."""
        if self.varied.inside is not None:
            if not self.said.least:
                raise NotExact("a greatest norm")
            return power(self.varied.inside, 2)
        return self.varied.body if self.said.least else apply("neg", self.varied.body)

    @cached_property
    def wanted(self) -> Term:
        """The claimed least value of the form."""
        if self.has_norm:
            match self.value:
                case Apply(head="norm", arguments=(inner,)):
                    return power(inner, 2)
                case Apply(head="root", arguments=(square,)):
                    return square
            return power(self.value, 2)
        return self.value if self.said.least else apply("neg", self.value)

    @cached_property
    def rank(self) -> int:
        for k in range(self.varied.count, 0, -1):
            outcome = self.judge(relation("=", self.quadratic.invariants[k], zero()), self.assume).outcome
            if outcome == Outcome.REFUTED:
                return k
            if outcome != Outcome.PROVED:
                raise NotExact("a quadratic form of which it is not seen where it is singular")
        return 0

    def _is_nonnegative(self, term: Term) -> bool:
        """True if the term is a sum of squares of monomials."""
        case = Case(self.setting, [relation("=", term, zero())], self.assume)
        (p,) = case.exact.residuals(relation("=", term, zero()))
        if case.exact.ring.denominators:
            return False
        return has_even_powers(p, case.exact.norm_places) and all(factor > 0 for _, factor in p.terms())

    # The equations to be proved.

    def _beyond(self) -> Verdict | None:
        """Returns the refutation by a point where the form is less than its claimed minimum, or None."""
        squares = relation("=", self.form, self.wanted)
        plain = relation("=", self.varied.body, self.value)
        case = Case(self.setting, [squares, plain], self.assume)
        case.require_satisfiable()

        def is_less(trial: Trial) -> bool:
            form, wanted = _number(trial, self.form), _number(trial, self.wanted)
            return form is not None and wanted is not None and form < wanted

        def is_negative(trial: Trial) -> bool:
            value, body = _number(trial, self.value), _number(trial, self.varied.body)
            return value is not None and value < 0 and body is not None

        may_be_negative = self.has_norm and not is_seen_nonnegative(self.value)
        if may_be_negative and (trial := case.find(is_negative, self.value)):
            return replace(case.refuted(trial, plain), reason=VerdictCode.NEGATIVE_NORM())
        trial = case.find(is_less, minus(self.form, self.wanted))
        if trial is None:
            return None
        found = case.refuted(trial, squares if self.has_norm else plain)
        what = "less" if self.said.least else "more"
        return self._told(found, VerdictCode.BEYOND_THE_VALUE(what=what, word=self._word))

    def _told(self, verdict: Verdict, reason: Reason) -> Verdict:
        return replace(verdict, reason=VerdictCode.OF_SQUARES(reason=reason) if self.has_norm else reason)

    @property
    def _word(self) -> str:
        return "least" if self.said.least else "greatest"

    def _where_regular(self) -> Iterator[Verdict]:
        """Yields the verdicts on A y* = −b and on the value of the form there, where c_r ≠ 0."""
        matrix, slopes, _ = self.quadratic.coefficients
        factor, supposed = self.quadratic.invariants[self.rank], self._regular
        stationary = self.quadratic.stationary(self.rank) if self.rank else []
        for row, b in zip(matrix, slopes, strict=True):
            slope = total([times(factor, b), *map(times, row, stationary)]) if self.rank else b
            shown = self.judge(relation("=", slope, zero()), supposed)
            if shown.outcome == Outcome.REFUTED:
                shown = _unchecked(VerdictCode.NO_BOUND())
            yield shown
        shown = self._vanishing(supposed) or self.judge(self._said(self.least), supposed)
        if shown.outcome == Outcome.REFUTED:
            shown = self._told(shown, VerdictCode.ANOTHER_VALUE(word=self._word))
        yield shown

    def _vanishing(self, supposed: tuple[Statement, ...]) -> Verdict | None:
        """Returns the verdict on p + L y* = 0 for a least norm that is claimed to be 0: its residual is
        easier."""
        if not (self.has_norm and isinstance(self.value, Zero)):
            return None
        rest, columns = self.quadratic.columns
        if self.rank:
            moved = map(times, self.quadratic.stationary(self.rank), columns)
            rest = total([times(self.quadratic.invariants[self.rank], rest), *moved])
        shown = self.judge(relation("=", rest, zero(rest.type)), supposed)
        return shown if shown.outcome in _HOLDS else None

    @cached_property
    def _regular(self) -> tuple[Statement, ...]:
        if not self.rank or self._is_excluded(self.quadratic.invariants[self.rank]):
            return self.assume
        return (*self.assume, relation("≠", self.quadratic.invariants[self.rank], zero()))

    def _is_excluded(self, term: Term) -> bool:
        """True if the assumptions exclude that the term is 0."""
        unit = relation("=", apply("div", term, term), number(1))
        return self.judge(unit, self.assume).outcome == Outcome.PROVED

    def _where_singular(self) -> Iterator[Verdict]:
        if self._regular == self.assume:
            return
        with suppress(Unsatisfiable):
            yield from self._at_zeros()

    def _at_zeros(self) -> Iterator[Verdict]:
        factor, trace = self.quadratic.invariants[self.rank], self.quadratic.invariants[1]
        found = self._at_singular(factor)
        if found is not None:
            yield found
            return
        if self.rank > 1:
            vanish = Implication(relation("=", factor, zero()), relation("=", trace, zero()))
            if self.judge(vanish, self.assume).outcome != Outcome.PROVED:
                yield _unchecked(VerdictCode.SINGULAR_PART())
                return
        _, slopes, rest = self.quadratic.coefficients
        supposed = (*self.assume, *self.quadratic.vanishing)
        if not self.has_norm:
            for slope in slopes:
                yield self.judge(relation("=", slope, zero()), supposed)
        yield self.judge(relation("=", rest, self._wanted_under(supposed)), supposed)

    def _at_singular(self, factor: Term) -> Verdict | None:
        """Returns the refutation by a point with c_r = 0 where the claimed value is wrong.

        If the claimed value is undefined at all such points, returns the verdict with c_r ≠ 0 as a
        hypothesis.
        """
        matrix, _, rest = self.quadratic.coefficients
        rewritten = self._wanted_under((*self.assume, *self.quadratic.vanishing))
        case = Case(self.setting, [self._said(rest), self._said(self.least)], self.assume)
        defined: list[Trial] = []

        def wanted(trial: Trial) -> Fraction | None:
            found = _number(trial, self.wanted)
            if found is None and not any(_number(trial, a) != 0 for row in matrix for a in row):
                return _number(trial, rewritten)
            return found

        def fails(trial: Trial) -> bool:
            if _number(trial, factor) != 0 or (said := wanted(trial)) is None:
                return False
            defined.append(trial)
            return self._least_at(trial) != said

        trial = case.find(fails, factor)
        if trial is not None:
            found = case.refuted(trial, self._said(rest))
            least, sign = self._least_at(trial), 1 if self.said.least else -1
            left = "none" if least is None else str(sign * least)
            said = wanted(trial)
            assert found.counterexample is not None and said is not None
            example = replace(found.counterexample, left=(left,), right=(str(sign * said),))
            return self._told(
                replace(found, counterexample=example), VerdictCode.ANOTHER_VALUE(word=self._word)
            )
        return None if defined else self._elsewhere()

    def _least_at(self, trial: Trial) -> Fraction | None:
        """Returns the least value of the form at a point; None if it is unbounded or undefined there."""
        matrix, slopes, rest = self.quadratic.coefficients
        rows: list[list[Fraction]] = []
        for row, b in zip(matrix, slopes, strict=True):
            entries = [_number(trial, entry) for entry in (*row, b)]
            known = [entry for entry in entries if entry is not None]
            if len(known) < len(entries):
                return None
            rows.append(known)
        solution, constant = solved(rows), _number(trial, rest)
        if solution is None or constant is None:
            return None
        return constant - sum((row[-1] * x for row, x in zip(rows, solution, strict=True)), Fraction(0))

    def _wanted_under(self, supposed: tuple[Statement, ...]) -> Term:
        return at_zero_part(self.wanted, lambda t: self._is_zero(t, supposed))

    def _elsewhere(self) -> Verdict:
        """Returns the verdict for c_r ≠ 0 only, since the claimed value is undefined elsewhere."""
        nothing = relation("=", minus(self.wanted, self.wanted), zero(self.wanted.type))
        bare = self.judge(self._said(self.least), self.assume)
        conditional = all(
            said.outcome == Outcome.CONDITIONAL for said in (bare, self.judge(nothing, self.assume))
        )
        return bare if conditional else _unchecked(VerdictCode.SINGULAR_PART())

    def _is_zero(self, term: Term, supposed: tuple[Statement, ...]) -> bool:
        return self.judge(relation("=", term, zero(term.type)), supposed).outcome == Outcome.PROVED

    def _together(self, parts: Sequence[Verdict]) -> Verdict:
        for worst in (Outcome.REFUTED, Outcome.UNCHECKED, Outcome.PROBABLE, Outcome.CONDITIONAL):
            for part in parts:
                if part.outcome == worst:
                    return part
        if any(part.outcome != Outcome.PROVED for part in parts):
            return _unchecked(VerdictCode.NOT_SHOWN())
        evidence = tuple(dict.fromkeys(e.method for part in parts for e in part.evidence))
        outcome = f"the bound for all values, and where it is reached: {len(parts)} equations, residual is 0"
        shown = Evidence(f"{self._word} value", outcome, {"engines": list(evidence)})
        return conclusion("extremum", parts, [shown])


def _number(trial: Trial, term: Term) -> Fraction | None:
    """Returns the value of a scalar at a point; None if it is undefined. Raises NotExact if it is not
    rational."""
    found = trial.components(term)
    if found is None:
        return None
    if not isinstance(found[0], Fraction | int):
        raise NotExact("a number that is not rational")
    return Fraction(found[0])


def _unchecked(reason: Reason) -> Verdict:
    return Verdict(Outcome.UNCHECKED, reason=reason)

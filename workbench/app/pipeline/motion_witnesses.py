"""Drake as the witness of verdicts: evaluates the forms of claims on motions of their symbols."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import TYPE_CHECKING, TypeAlias

from workbench.context.claims import Claim, Formula, Notation, OnMotions
from workbench.core.codes.motion_codes import MotionCode
from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.paper_errors import PaperError
from workbench.core.reasons import Reason, code_of
from workbench.core.terms import Relation, Statement
from workbench.core.verdict import Outcome, Verdict
from workbench.language.goals.goals import Goal
from workbench.prover.explain.judged_parts import JudgedParts
from workbench.prover.results.motion_summary import METHOD

if TYPE_CHECKING:
    from workbench.app.pipeline.verdict_keys import Keys, Memory
    from workbench.drake.bound_jets import Motion
    from workbench.prover.motions.motion_check import Ranges, Witness
    from workbench.prover.motions.motion_source import Bindings

#: (statement, premises, ranges of its integers).
Saying: TypeAlias = "tuple[Statement, tuple[Statement, ...], Ranges | None]"

#: (bindings of symbols, motions).
References: TypeAlias = "tuple[tuple[Bindings, ...], tuple[Motion, ...]]"

#: Verdicts that a motion can contradict.
_TRUE = frozenset({Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION, Outcome.ARGUED})


class Witnesses:
    """Evaluates the forms of a paper's claims on Drake's motions, which are created once and shared.

    Before that, the motions are checked against their plants, and the bindings against the definitions. With
    a cache this is done once for all runs.
    """

    def __init__(self, memory: Memory | None = None, keys: Keys | None = None) -> None:
        self._memory, self._keys = memory, keys
        self._parts = keys.parts if keys else JudgedParts()
        self._of: dict[tuple[int, int], References] = {}

    def seen(self, verdict: Verdict, claim: Claim, form: Formula, under: Formula | None) -> Verdict:
        """Returns the verdict on a form with the motions' evidence.

        under: the hypothesis with which the form holds.

        Raises:
            PaperError: A binding contradicts a definition, a formula of [motion.claims] is useless, or Drake
                cannot load a robot.
        """
        if verdict.outcome not in _TRUE | {Outcome.REFUTED}:
            return verdict
        if not claim.notation.motion:
            return replace(verdict, no_motion=MotionCode.ALGEBRA())
        found = self._witness(claim, list(_sayings(claim, form, under)), claim.corrected is not None)
        on_motions = () if found.evidence is None else (found.evidence,)
        seen = (*verdict.evidence, *on_motions)
        if found.vetoed and verdict.outcome in _TRUE:
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.MOTIONS_CONTRADICT(), evidence=seen)
        if verdict.outcome == Outcome.REFUTED and _only_tied(form, claim, found):
            return Verdict(Outcome.UNCHECKED, reason=VerdictCode.TIED_ON_MOTIONS(), evidence=on_motions)
        ours = claim.notation.on_motions.get(claim.id)
        if ours is None or (form is not claim.printed and form is not claim.reading):
            return replace(verdict, evidence=seen, no_motion=found.reason)
        return self._ours(replace(verdict, evidence=seen), claim, ours)

    def _ours(self, verdict: Verdict, claim: Claim, ours: OnMotions) -> Verdict:
        """Returns the verdict with our formulas for the claim: one must hold, the other fails as printed."""
        if ours.none is not None:
            return replace(verdict, no_motion=_no_motion(ours.none))
        if ours.printed is not None:  # the false form and the right one, evaluated in the same way
            told = tuple(e for e in verdict.evidence if e.method != METHOD)
            verdict = replace(verdict, evidence=told)
        for form in (ours.printed, ours.holds):
            if form is None:
                continue
            saying = (form.parsed, (), ours.orders)
            found = self._witness(claim, [saying], ours.printed is not None, ours.on)
            if found.evidence is None:
                raise PaperError(None, None, None, str(found.reason), path=("motion", "claims"))
            shown = replace(found.evidence, figures={"formula": form.latex, **found.evidence.figures})
            verdict = replace(verdict, evidence=(*verdict.evidence, shown))
            if found.vetoed != (form is ours.printed):
                return Verdict(
                    Outcome.UNCHECKED, reason=VerdictCode.MOTIONS_CONTRADICT(), evidence=verdict.evidence
                )
        return verdict

    def _witness(
        self, claim: Claim, sayings: Sequence[Saying], course: bool, on: str | None = None
    ) -> Witness:
        """Returns the joint evidence of the motions. on: the name of a special motion to use instead."""
        from workbench.prover.motions.motion_check import Subject, Witness, witness

        if not sayings and claim.proof.goal is None:
            return Witness(None, MotionCode.WORDS())
        bindings, motions = self._known(claim)
        if on is not None:
            motions = (_special(on),)
        known = claim.notation.definitions
        found = witness(*(Subject(*saying, known, bindings, motions) for saying in sayings), course=course)
        is_algebra = code_of(found.reason) is MotionCode.ALGEBRA
        if is_algebra and claim.proof.goal is not None and _of_motion(claim.proof.goal.goal, claim.notation):
            return Witness(None, MotionCode.EXISTENCE())
        return found

    def prepare(self, claim: Claim) -> None:
        """Creates the references of the claim's notation, so that forked processes share them.

        Raises as `seen` does.
        """
        if claim.notation.motion:
            self._known(claim)

    def _known(self, claim: Claim) -> References:
        notation = claim.notation
        key = id(notation.motion), id(notation.definitions)
        if key not in self._of:
            bound = self._parts.bound(notation)  # all claims of a paper share it
            shared = id(bound.motion), id(bound.definitions)
            if shared not in self._of:
                self._of[shared] = self._checked(bound, claim)
            self._of[key] = self._of[shared]
        return self._of[key]

    def _checked(self, notation: Notation, claim: Claim) -> References:
        from workbench.drake.plants import PlantError
        from workbench.prover.motions.binding_check import BindingError, require_consistent
        from workbench.prover.motions.motion_source import bindings_of

        choices = bindings_of(notation.motion)
        try:
            motions = _motions(notation)
            key = self._keys.of_bindings(notation) if self._memory and self._keys else ""
            if not (self._memory and self._memory.knows(key)):
                for motion in motions:
                    _require_agreement(motion)
                require_consistent(notation.definitions, choices, motions)
                if self._memory:
                    self._memory.know(key)
        except (BindingError, PlantError) as error:
            raise PaperError(claim.source.file, None, None, str(error)) from None
        return choices, motions


def _sayings(claim: Claim, form: Formula, under: Formula | None) -> Iterator[Saying]:
    """Yields the equations of a form of the claim: its own, or those of its goal."""
    if form is claim.printed and claim.proof.goal is not None:
        from workbench.prover.goals.goal_equations import equations_of_goal

        for part in equations_of_goal(claim.proof.goal.goal):
            yield part.statement, (*claim.supposed, *part.premises), part
        return
    supposed = claim.supposed
    if under is not None and under.statement is not None:
        supposed = (*supposed, under.statement)
    if form.statement is not None:
        yield form.statement, supposed, claim.orders


def _of_motion(goal: Goal, notation: Notation) -> bool:
    """True if the goal contains bound symbols."""
    from workbench.language.goals.goals import atoms
    from workbench.prover.motions.motion_check import relations

    sides = [side for s in atoms(goal) for r in relations(s) for side in (r.left, r.right)]
    bound = {symbol.declaration.name for symbol in notation.motion}
    return any(part.declaration.name in bound for part in notation.definitions.symbols_in(*sides))


def _only_tied(form: Formula, claim: Claim, found: Witness) -> bool:
    """True if a refuted equation holds on the motions in every instance.

    Bound symbols are free for the exact engines, so the counterexample may be no motion.
    """
    equation = isinstance(form.statement, Relation) and form.statement.operator == "="
    return (
        equation
        and found.evidence is not None
        and not found.vetoed
        and len(found.evidence.figures.get("instances", [{}])) == len(claim.instances)
    )


def _motions(notation: Notation) -> tuple[Motion, ...]:
    if notation.robot is None:
        return _general()
    from workbench.drake.sampled_motions import urdf_motion

    return (*_general(), urdf_motion(notation.robot.urdf, notation.robot.body))


def load_motions() -> None:
    """Creates the general motions and checks them against their plants, once for all notations."""
    for motion in _general():
        _require_agreement(motion)


@lru_cache(maxsize=32)
def _special(name: str) -> Motion:
    from workbench.drake.special_motions import special_motion

    motion = special_motion(name)
    _require_agreement(motion)
    return motion


@lru_cache(maxsize=32)
def _require_agreement(motion: Motion) -> None:
    from workbench.drake.roots import require_agreement

    require_agreement(motion)


@lru_cache(maxsize=1)
def _general() -> tuple[Motion, ...]:
    from workbench.drake.motions import reference_motions
    from workbench.drake.sampled_motions import sampled_motions

    return (*reference_motions(), *sampled_motions())


def _no_motion(entry: str) -> Reason:
    """Returns why no motion shows a claim, by its entry in [motion.claims]."""
    return MotionCode.ALGEBRA() if entry == "algebra" else MotionCode.AS_STATED(why=entry)

"""Drake as the witness of verdicts: what the forms of a claim are on the motions that their symbols have."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache
from typing import Any

from workbench.judge.evidence.motion_source import Bindings, Motion, bindings_of
from workbench.judge.verdict import Outcome, Verdict
from workbench.language.terms import Relation
from workbench.papers.model import Claim, Formula, Notation, PaperError

VETO = "proved, but Drake's motions contradict it: a binding or the workbench is wrong"

TIED = "it holds on Drake's motions, where the bound symbols are tied as they are not here"

#: Verdicts that a motion can contradict.
_TRUE = frozenset({Outcome.PROVED, Outcome.CONDITIONAL, Outcome.DEFINITION})


class Witnesses:
    """Looks at the forms of a paper's claims on Drake's motions; references are made once and shared."""

    def __init__(self) -> None:
        self._of: dict[int, tuple[tuple[Bindings, ...], tuple[Motion, ...]]] = {}

    def seen(self, verdict: Verdict, claim: Claim, form: Formula | None, under: Formula | None) -> Verdict:
        """The verdict on a form of the claim, with what the motions say of it among its evidence.

        under: the hypothesis with which it holds. Raises PaperError for a binding that contradicts a
        definition, or a robot that Drake cannot load.
        """
        if verdict.outcome not in _TRUE | {Outcome.REFUTED}:
            return verdict
        if form is None or form.statement is None:
            return self._sentence(verdict, claim)
        if not claim.notation.motion:
            return replace(verdict, no_motion=_algebra())
        from workbench.judge.evidence.motion_check import Subject, witness

        bindings, motions = self._known(claim)
        premises = claim.supposed if under is None else (*claim.supposed, under.statement)
        subject = Subject(
            form.statement, premises, claim.orders, claim.notation.definitions, bindings, motions
        )
        found = witness(subject, course=claim.corrected is not None)
        if found.evidence is None:
            return replace(verdict, no_motion=found.reason)
        evidence = (*verdict.evidence, found.evidence)
        if found.vetoed and verdict.outcome in _TRUE:
            return Verdict(Outcome.UNCHECKED, reason=VETO, evidence=evidence)
        if verdict.outcome == Outcome.REFUTED and _only_tied(form, claim, found):
            return Verdict(Outcome.UNCHECKED, reason=TIED, evidence=(found.evidence,))
        return replace(verdict, evidence=evidence)

    def _sentence(self, verdict: Verdict, claim: Claim) -> Verdict:
        """With our formulas for the sentence: one that must hold, one that is false if what is printed is."""
        ours = claim.notation.on_motions.get(claim.id)
        if ours is None:
            return replace(verdict, no_motion="a sentence, with no formula to evaluate")
        from workbench.judge.evidence.motion_check import Subject, witness

        bindings, motions = self._known(claim)
        for form in (ours.printed, ours.holds):
            if form is None:
                continue
            subject = Subject(form.statement, (), ours.orders, claim.notation.definitions, bindings, motions)
            found = witness(subject, course=ours.printed is not None)
            if found.evidence is None:
                raise PaperError(claim.file, None, None, f"motion.claims: {claim.id}: {found.reason}")
            shown = replace(found.evidence, figures={"formula": form.latex, **found.evidence.figures})
            verdict = replace(verdict, evidence=(*verdict.evidence, shown))
            if found.vetoed != (form is ours.printed):
                return Verdict(Outcome.UNCHECKED, reason=VETO, evidence=verdict.evidence)
        return verdict

    def prepare(self, claim: Claim) -> None:
        """Makes the references of the claim's notation, so that processes forked later share them. Raises as
        `seen` does."""
        if claim.notation.motion:
            self._known(claim)

    def _known(self, claim: Claim) -> tuple[tuple[Bindings, ...], tuple[Motion, ...]]:
        notation = claim.notation
        if id(notation) not in self._of:
            self._of[id(notation)] = self._checked(notation, claim)
        return self._of[id(notation)]

    def _checked(self, notation: Notation, claim: Claim) -> tuple[tuple[Bindings, ...], tuple[Motion, ...]]:
        from workbench.drake.plants import PlantError
        from workbench.judge.evidence.binding_check import BindingError, require_consistent

        choices = bindings_of(notation.motion)
        try:
            motions = _motions(notation)
            require_consistent(notation.definitions, choices, motions)
        except (BindingError, PlantError) as error:
            raise PaperError(claim.file, None, None, str(error)) from None
        return choices, motions


def _only_tied(form: Formula, claim: Claim, found: Any) -> bool:
    """Whether a refuted equation holds on the motions in every instance: what is bound is free in the exact
    judge, and the counterexample may be no motion."""
    equation = isinstance(form.statement, Relation) and form.statement.operator == "="
    return (
        equation
        and not found.vetoed
        and len(found.evidence.figures.get("instances", [{}])) == len(claim.instances)
    )


def course_on(motion: Motion, claim: Claim, form: Formula) -> tuple[list[float], list[float | None]]:
    """Times in s, and how far the sides of a form of the claim are apart there, over their size, on a
    motion of one's own; None where it cannot be told. Raises ValueError where it says nothing of it."""
    from workbench.judge.evidence.motion_check import Subject, witness

    bindings = bindings_of(claim.notation.motion)
    subject = Subject(
        form.statement, claim.supposed, claim.orders, claim.notation.definitions, bindings, (motion,)
    )
    found = witness(subject, course=True)
    if found.evidence is None:
        raise ValueError(f"{claim.id} on {motion.name}: {found.reason}")
    course = found.evidence.figures["course"]
    return course["times"], course["residuals"]


def _motions(notation: Notation) -> tuple[Motion, ...]:
    if notation.robot is None:
        return _general()
    from workbench.drake.sampled_motions import urdf_motion

    return (*_general(), urdf_motion(notation.robot.urdf, notation.robot.body))


@lru_cache(maxsize=1)
def _general() -> tuple[Motion, ...]:
    from workbench.drake.motions import reference_motions
    from workbench.drake.sampled_motions import sampled_motions

    return (*reference_motions(), *sampled_motions())


def _algebra() -> str:
    from workbench.judge.evidence.motion_check import ALGEBRA

    return ALGEBRA

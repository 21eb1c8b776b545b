"""The verdict on a claim under more than is printed: what its text says, defines or states as a law."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from typing import TYPE_CHECKING

from workbench.core.reasons import Reason, reason_of
from workbench.core.verdict_codes import VerdictCode
from workbench.judge.subject.assumptions import Unsatisfiable
from workbench.judge.subject.inventory import NotExact
from workbench.judge.verdict import EngineDisagreement, Outcome, Strength, Verdict
from workbench.language.definitions import Definitions
from workbench.language.typed.terms import Definition
from workbench.papers.model import Aside, Claim, Formula, Notation, Said

if TYPE_CHECKING:
    from workbench.judge.kernel.judge import Judge


class Under:
    """judge_of: the judge of a notation.   options: those of a judge."""

    def __init__(self, judge_of: Callable[[Notation], Judge], options: Mapping[str, bool]) -> None:
        self._judge_of, self._options = judge_of, options
        self._known: dict[tuple[int, str, str], bool] = {}  # of what a text says: whether it holds anyway

    def verdict(
        self,
        claim: Claim,
        asides: Sequence[Aside] = (),
        definitions: Sequence[Definition] = (),
        by_both: bool = True,
    ) -> Verdict:
        """by_both: engines; by the first alone nothing is more than probable."""
        from workbench.judge.kernel.judge import Judge

        statement, notation = claim.printed.statement, claim.notation
        judge, supposed = self._judge_of(notation), with_asides(claim, asides).supposed
        if definitions:
            known = Definitions([*notation.definitions, *definitions])
            judge, supposed = Judge(known, **self._options), (*supposed, *known.known_of(statement))
        if not by_both:
            judge = replace(judge, second_engine=False)
        with suppress(Unsatisfiable):
            return undisturbed(lambda: judge.judge(statement, supposed, orders=claim.orders))
        return Verdict(Outcome.UNCHECKED)

    def given(
        self,
        claim: Claim,
        laws: Sequence[Said],
        definitions: Sequence[Definition] = (),
        by_both: bool = True,
    ) -> Verdict:
        """The verdict if the laws hold always."""
        given = tuple(Formula(law.name, law.statement) for law in laws)
        return self.verdict(replace(claim, given=(*claim.given, *given)), (), definitions, by_both)

    def is_impossible(self, claim: Claim) -> bool:
        """Returns whether no values of its symbols make the claim true, whatever its text says of them."""
        said = claim.printed.statement
        try:
            undisturbed(lambda: self._judge_of(claim.notation).judge(said, (*claim.supposed, said)))
        except Unsatisfiable:
            return claim.orders is None
        return False

    def is_known(self, said: Said, notation: Notation) -> bool:
        """Whether it holds of all motions, so that it leaves every symbol as free as it was."""
        if said.statement is None:
            return False
        key = id(notation.definitions), said.place, said.name
        if key not in self._known:
            verdict = Verdict(Outcome.UNCHECKED)
            with suppress(Unsatisfiable):
                judge = self._judge_of(notation)
                verdict = undisturbed(
                    lambda: judge.judge(said.statement, assume=said.supposed, orders=said.orders)
                )
            self._known[key] = verdict.outcome in (Outcome.PROVED, Outcome.DEFINITION) and verdict.is_for_all
        return self._known[key]


def with_asides(claim: Claim, asides: Sequence[Aside]) -> Claim:
    premises = (Formula(aside.latex, aside.premise) for aside in asides)
    return replace(claim, assume=(*claim.assume, *premises))


def conditional(under: Verdict, hypotheses: Sequence[str], reason: Reason, bare: Verdict) -> Verdict:
    """The verdict on what is proved under hypotheses and refuted without them."""
    return replace(
        under,
        outcome=Outcome.CONDITIONAL,
        hypothesis=", ".join(dict.fromkeys(hypotheses)),
        reason=reason,
        counterexample=bare.counterexample,
        basis=Strength.STATED,
    )


def undisturbed(judge: Callable[[], Verdict]) -> Verdict:
    """The verdict; where the engines disagree or find no end, a defect of the workbench that must not stop
    the other claims, it is `unchecked` and says so; and so it is where a theorem finds no second engine."""
    try:
        return judge()
    except NotExact as outside:
        return Verdict(Outcome.UNCHECKED, reason=reason_of(outside))
    except EngineDisagreement as error:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.ENGINES_DISAGREE(error=error))
    except RecursionError:
        return Verdict(Outcome.UNCHECKED, reason=VerdictCode.NESTS_TOO_DEEP())

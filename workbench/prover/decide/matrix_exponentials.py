"""Refutes exp A = B by a law of the exponential, A exp A = exp A A, where no engine has a value of exp A."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from workbench.core.codes.verdict_codes import VerdictCode
from workbench.core.construct import apply, relation
from workbench.core.terms import Apply, Relation, Statement, Symbol, Term
from workbench.core.verdict import Evidence, Outcome, Verdict
from workbench.language.printing.printer import to_latex


def refuted_by_commutator(said: Relation, judge: Callable[[Statement], Verdict]) -> Verdict | None:
    """Returns the refutation of exp A = B by a point where A B and B A differ; None if there is none."""
    for one, other in ((said.left, said.right), (said.right, said.left)):
        if not _is_matrix_exponential(one) or isinstance(other, Symbol):
            continue  # R = exp A may say what R is
        (exponent,) = one.children
        verdict = judge(relation("=", apply("mul", exponent, other), apply("mul", other, exponent)))
        if verdict.outcome is Outcome.REFUTED:
            evidence = Evidence("law of the exponential", "A exp A = exp A A; the sides are A B and B A")
            reason = VerdictCode.DOES_NOT_COMMUTE(exponent=to_latex(exponent))
            return replace(verdict, reason=reason, evidence=(*verdict.evidence, evidence))
    return None


def _is_matrix_exponential(term: Term) -> bool:
    return isinstance(term, Apply) and term.head == "exp" and term.type.kind in ("tensor", "matrix")

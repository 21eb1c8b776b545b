"""Guessed kinds as facts: a refutation that depends on them is conditional on the guesses."""

from __future__ import annotations

from dataclasses import replace
from itertools import groupby

from workbench.context.claims import Claim
from workbench.core.codes.context_codes import ContextCode
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.verdict import Outcome, Strength, Verdict
from workbench.prover.explain.field_alternatives import OF_GUESSES

_FALSE = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})
_NAMED = 5


def on_guessed_kinds(claim: Claim, verdict: Verdict) -> Verdict:
    """Returns the verdict with its basis, and a reason that names the kinds that a refutation depends on."""
    if not claim.context.guessed:
        return verdict
    if (
        "[[scope]]" in claim.context.guessed and verdict.outcome in _FALSE
    ):  # the meaning of its symbols is unknown
        unknown = ContextCode.SCOPE_UNKNOWN(outcome=verdict.outcome)
        return Verdict(Outcome.UNCHECKED, reason=unknown, read_back=verdict.read_back)
    reason, unless = verdict.reason, verdict.unless
    if verdict.outcome in _FALSE or verdict.outcome is Outcome.CONDITIONAL:
        code = ContextCode.FALSE_IF_KINDS if verdict.outcome in _FALSE else ContextCode.HOLDS_IF_KINDS
        reason = code(kinds=_kinds(claim), reason=f": {reason}" if reason else "")
    is_of_tables = all(name.startswith("[") for name in claim.context.guessed)
    is_named = is_of_tables and any(not OF_GUESSES.isdisjoint(doubt.codes) for doubt in unless)
    if verdict.outcome in _FALSE and not is_named:
        unless = (*unless, DoubtCode.GUESSED_KINDS())
    return replace(verdict, basis=Strength.GUESSED, reason=reason, unless=unless)


def _kinds(claim: Claim) -> str:
    """Returns "a, b are of kind vector and m of kind scalar" for the guessed symbols."""
    declared = {str(name): each for name, each in claim.notation.symbols.symbols.items()}
    kinds = [
        (f"of kind {declared[name].type}" if name in declared else "as guessed", name)
        for name in claim.context.guessed[:_NAMED]
    ]
    groups = groupby(sorted(kinds), key=lambda pair: pair[0])
    told = []
    for kind, pairs in groups:
        names = [name for _, name in pairs]
        told.append(f"{', '.join(names)} {'is' if len(names) == 1 else 'are'} {kind}")
    return " and ".join(told)

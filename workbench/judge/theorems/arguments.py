"""Arguments: theorems that one identity cannot state, cut into steps that a computation can check.

    def remark_7() -> Verdict:
        return argue(
            [
                Step(
                    "the dual product of ω̲₁ and ω̲₂ is orthogonal to both and to their sum",
                    Way(Engine.FLINT, vanishing(lambda: ...), but_not=vanishing(lambda: ...)),
                    Way(Engine.SYMPY, vanishing(lambda: ...), but_not=vanishing(lambda: ...)),
                ),
                ...
            ]
        )

A step is one statement, checked in at least two ways that share no arithmetic. A way is a check, and
beside it a control: the same check of a claim known to be false. A check that looked at nothing, or
whose control passes too, tests nothing, and its step fails. One step that fails leaves the whole
argument `unchecked`, with the step's name as the reason.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum
from itertools import chain
from typing import Any

from workbench.judge.verdict import Counterexample, Evidence, Outcome, Verdict

#: What a check yields: for each single thing it looked at, whether it holds.
Check = Callable[[], Iterable[bool]]


class Engine(StrEnum):
    """Where the arithmetic of a check is done. Two engines share no code below the formulas."""

    FLINT = "polynomials over ℚ (FLINT)"
    SYMPY = "polynomials on Python integers (SymPy)"
    WORDS = "noncommutative polynomials over ℤ (Python)"
    FRACTIONS = "rational examples (Python's Fraction)"
    DRAKE = "Drake's plants, in doubles"
    FLOATS = "doubles (NumPy)"


#: These compute with indeterminates: what they find zero is zero for all values.
GENERIC = frozenset({Engine.FLINT, Engine.SYMPY, Engine.WORDS})
#: These compute at examples, without rounding.
EXACT = GENERIC | {Engine.FRACTIONS}


@dataclass(frozen=True)
class Way:
    """A check and its control: `but_not` is the same check of something false, and must not pass."""

    engine: Engine
    check: Check
    but_not: Check


class Step:
    """One statement of an argument, and the ways in which it is checked.

    It needs two ways of different engines. A statement for all values needs two generic engines;
    with ``by_example`` (there is a case such that …) it needs one exact engine.
    Raises ValueError if the ways are too few for that.
    """

    def __init__(self, shown: str, *ways: Way, by_example: bool = False) -> None:
        engines = {way.engine for way in ways}
        needed, kind = (1, EXACT) if by_example else (2, GENERIC)
        if len(engines) < 2 or len(engines & kind) < needed:
            raise ValueError(
                f"step {shown!r}: expected two engines, {needed} of them among "
                f"{sorted(engine.name for engine in kind)}; got {sorted(e.name for e in engines)}"
            )
        self.shown = shown
        self.ways = ways


def argue(
    steps: Sequence[Step],
    *,
    hypothesis: str | None = None,
    counterexample: Counterexample | None = None,
    refutes: bool = False,
    reason: str | None = None,
    scope: str | None = None,
) -> Verdict:
    """The verdict that the steps support, each way of each step being a piece of its evidence.

    `proved`; with a ``hypothesis`` (LaTeX) that the text does not state, `conditional`; with
    ``refutes``, the steps show a claim false, and it is `refuted`. The last two need the
    ``counterexample``: where the bare claim fails. If a step fails, `unchecked`, naming the step.

    Raises ValueError for an argument without steps, a repeated step, or a counterexample too few
    or too many.
    """
    names = [step.shown for step in steps]
    if not steps:
        raise ValueError("an argument without steps proves nothing: expected at least one Step")
    if len(set(names)) < len(names):
        raise ValueError(f"a step stands twice in the argument: {names}")
    if hypothesis is not None and refutes:
        raise ValueError("expected a hypothesis or a refutation, got both")
    fails_somewhere = hypothesis is not None or refutes
    if (counterexample is not None) != fails_somewhere:
        expected = "a counterexample" if fails_somewhere else "no counterexample"
        raise ValueError(f"expected {expected} for this outcome, got {counterexample}")
    evidence = []
    for step in steps:
        for way in step.ways:
            count, fault = _examine(way)
            figures = {"checks": count}
            evidence.append(Evidence(str(way.engine), fault or step.shown, figures))
            if fault:
                why = f"step not shown: {step.shown} ({way.engine}: {fault})"
                return Verdict(Outcome.UNCHECKED, reason=why, evidence=tuple(evidence))
    outcome = Outcome.PROVED
    if fails_somewhere:
        outcome = Outcome.REFUTED if refutes else Outcome.CONDITIONAL
    return Verdict(
        outcome,
        scope=scope,
        reason=reason,
        hypothesis=hypothesis,
        counterexample=counterexample,
        evidence=tuple(evidence),
    )


def _examine(way: Way) -> tuple[int, str | None]:
    """How many things the check looked at, and what is wrong with it (None: nothing)."""
    try:
        found = _answers(way.check)
        control = _answers(way.but_not)
    except Exception as error:
        return 0, f"the check stopped with {type(error).__name__}: {error}"
    if not found:
        return 0, "the check looked at nothing"
    if not all(found):
        return len(found), f"{found.count(False)} of {len(found)} checks fail"
    if not control:
        return len(found), "the control looked at nothing"
    if all(control):
        return len(found), "the check passes what is false, so it tests nothing"
    return len(found), None


def _answers(check: Check) -> list[bool]:
    import numpy as np

    answers = list(check())
    for answer in answers:
        if not isinstance(answer, bool | np.bool_):
            raise TypeError(f"expected True or False, got {type(answer).__name__}")
    return [bool(answer) for answer in answers]


def vanishing(residuals: Callable[[], Iterable[Any]]) -> Check:
    """The check that exact residuals are 0: ring elements, arrays of them, `Dual`s of either.

    Every entry of an array is looked at by itself. A float is refused with TypeError, for it
    proves nothing: see `vanishing_to`.
    """

    def check() -> Iterable[bool]:
        import numpy as np

        from workbench.algebra.dual import is_zero

        for entry in chain.from_iterable(map(entries, residuals())):
            if isinstance(entry, float | np.floating):
                raise TypeError("expected exact residuals, got a float")
            yield is_zero(entry)

    return check


def vanishing_to(tolerance: float, residuals: Callable[[], Iterable[Any]]) -> Check:
    """The check that float residuals are at most ``tolerance`` in absolute value; NaN fails."""

    def check() -> Iterable[bool]:
        for entry in chain.from_iterable(map(entries, residuals())):
            yield bool(abs(entry) <= tolerance)

    return check


def entries(a: Any) -> list[Any]:
    """All scalars in a scalar, an array, or a `Dual` of either."""
    import numpy as np

    from workbench.algebra.dual import Dual

    if isinstance(a, Dual):
        return [*entries(a.re), *entries(a.du)]
    return list(a.flat) if isinstance(a, np.ndarray) else [a]

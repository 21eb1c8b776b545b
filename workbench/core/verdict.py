"""Verdicts: an outcome and the evidence for it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from enum import IntEnum, StrEnum
from typing import Any, NoReturn, final

from workbench.core.hypotheses import Hypothesis
from workbench.core.proof import Proof, Unproved, is_genuine
from workbench.core.reasons import Code, Reason, code_of


class Outcome(StrEnum):
    """Outcomes of the report. ARGUED: steps are checked and joined by prose; it never counts as proved."""

    PROVED = "proved"
    CONDITIONAL = "conditional"
    REFUTED = "refuted"
    ILL_FORMED = "ill-formed"
    DEFINITION = "definition"
    ARGUED = "argued"
    PROBABLE = "probable"
    UNCHECKED = "unchecked"


class Strength(IntEnum):
    """The reliability of a fact. The basis of a verdict is the weakest fact that it depends on."""

    GUESSED = 0  # one of several conventions about letters or typefaces, or a proposal
    HINTED = 1  # words near the symbol, or a convention that authors follow
    STATED = 2  # a formula or a sentence of the text
    DECLARED = 3  # the model declares it

    def __str__(self) -> str:
        return self.name.lower()


class Grade(StrEnum):
    """The way in which a verdict is shown."""

    ERROR = "error"
    WARNING = "warning"
    OK = "ok"
    NOTE = "note"
    NOT_JUDGED = "not judged"


def grade_of(outcome: Outcome, basis: Strength, unless: Sequence[Reason]) -> Grade:
    """Returns the grade of a verdict. unless: the doubts under which the verdict would be different; one
    doubt turns an error into a warning, two turn it into a note."""
    match outcome:
        case Outcome.REFUTED | Outcome.ILL_FORMED:
            doubts = max(len(unless), int(basis < Strength.STATED))
            return (Grade.ERROR, Grade.WARNING, Grade.NOTE)[min(doubts, 2)]
        case Outcome.PROVED:
            return Grade.OK
        case Outcome.CONDITIONAL:
            return Grade.OK if basis >= Strength.STATED else Grade.NOTE
        case Outcome.DEFINITION | Outcome.ARGUED:
            return Grade.NOTE
        case Outcome.PROBABLE | Outcome.UNCHECKED:
            return Grade.NOT_JUDGED


class EngineDisagreement(RuntimeError):
    """Two engines contradict each other: a defect of the workbench, never a verdict."""


@dataclass(frozen=True)
class Evidence:
    """One method, its outcome, and its figures (JSON values: numbers, strings, lists)."""

    method: str
    outcome: str
    figures: Mapping[str, Any] = field(default_factory=dict)

    def to_dict(self) -> dict[str, Any]:
        return {"method": self.method, "outcome": self.outcome, **self.figures}

    @staticmethod
    def from_dict(data: Mapping[str, Any]) -> Evidence:
        figures = {name: value for name, value in data.items() if name not in ("method", "outcome")}
        return Evidence(data["method"], data["outcome"], figures)


@dataclass(frozen=True)
class Counterexample:
    """Values of the symbols, and the resulting values of the two sides.

    values: LaTeX → rationals as strings, components in reading order. A derivative is a separate symbol,
    `\\dot{\\omega}`.
    defined: the values of the defined symbols in the formula.
    behind: the entries of `values` that do not occur in the formula.
    kinds: the type of each value, as `str(Type)`; kind: that of the two sides.
    """

    values: Mapping[str, tuple[str, ...]]
    left: tuple[str, ...]
    right: tuple[str, ...]
    defined: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    behind: tuple[str, ...] = ()
    kinds: Mapping[str, str] = field(default_factory=dict)
    kind: str = ""

    def to_dict(self) -> dict[str, Any]:
        values, defined = (
            {name: list(entries) for name, entries in given.items()} for given in (self.values, self.defined)
        )
        sides = {"lhs": list(self.left), "rhs": list(self.right)}
        kinds = {"kinds": dict(self.kinds), "kind": self.kind}
        return {"values": values, **sides, "defined": defined, "behind": list(self.behind), **kinds}

    @staticmethod
    def from_dict(data: Mapping[str, Any]) -> Counterexample:
        values, defined = (
            {name: tuple(entries) for name, entries in data[key].items()} for key in ("values", "defined")
        )
        sides = tuple(data["lhs"]), tuple(data["rhs"])
        return Counterexample(
            values, *sides, defined, tuple(data["behind"]), dict(data.get("kinds", {})), data.get("kind", "")
        )


@final
@dataclass(frozen=True)
class Verdict:
    """The verdict on one statement.

    scope: the n for which it is proved ("all n", "all n ≥ 1", "n = 1..8"); None if there is no n.
    read_back: canonical LaTeX of the judged term.
    reason: why, for ill-formed (with line and column), unchecked and conditional.
    hypothesis: the condition, for conditional.
    no_motion: why the evidence contains no motion; None if it contains one.
    basis: the strength of the weakest fact that the verdict depends on.
    unless: the unconfirmed facts under which the verdict would be different.
    proof: the token of the inference rule that made it, for `proved`; None for all other outcomes.

    Raises Unproved for `proved` without a token for this scope.
    """

    outcome: Outcome
    read_back: str | None = None
    scope: str | None = None
    reason: Reason | None = None
    hypothesis: Hypothesis | None = None
    counterexample: Counterexample | None = None
    evidence: tuple[Evidence, ...] = ()
    no_motion: Reason | None = None
    basis: Strength = Strength.DECLARED
    unless: tuple[Reason, ...] = ()
    proof: Proof | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        if self.outcome != Outcome.PROVED:
            object.__setattr__(self, "proof", None)
        elif not is_genuine(self.proof) or self.proof is None or self.proof.scope != self.scope:
            raise Unproved("a proved verdict is made by the rules of workbench.prover.decide.inference only")

    def __init_subclass__(cls) -> None:
        raise Unproved("a Verdict has no subclasses")

    def __setstate__(self, state: object) -> NoReturn:
        raise Unproved("a Verdict comes back through its constructor")

    @property
    def grade(self) -> Grade:
        return grade_of(self.outcome, self.basis, self.unless)

    @property
    def code(self) -> Code | None:
        """The code of the reason; None if there is no reason."""
        return code_of(self.reason)

    @property
    def is_for_all(self) -> bool:
        """True if the verdict holds for all values of the integers, or if there are no integers."""
        return self.scope is None or self.scope.startswith("all")

    def to_dict(self) -> dict[str, Any]:
        own = {field.name: getattr(self, field.name) for field in fields(self) if field.name != "proof"}
        for name in ("reason", "no_motion"):
            own[name] = own[name].to_dict() if own[name] is not None else None
        own["unless"] = [doubt.to_dict() for doubt in self.unless]
        against = self.counterexample.to_dict() if self.counterexample else None
        own["hypothesis"] = own["hypothesis"].to_list() if own["hypothesis"] is not None else None
        return own | {"counterexample": against, "evidence": [e.to_dict() for e in self.evidence]}

    @staticmethod
    def from_dict(data: Mapping[str, Any], proof: Proof | None = None) -> Verdict:
        """Inverts `to_dict`; `proved` needs its token. Raises KeyError, ValueError or TypeError otherwise."""
        against = data["counterexample"]
        reasons = {name: data[name] and Reason.from_dict(data[name]) for name in ("reason", "no_motion")}
        return Verdict(
            **{
                **data,
                "outcome": Outcome(data["outcome"]),
                **reasons,
                "hypothesis": data["hypothesis"] and Hypothesis.from_list(data["hypothesis"]),
                "counterexample": Counterexample.from_dict(against) if against else None,
                "evidence": tuple(Evidence.from_dict(entry) for entry in data["evidence"]),
                "basis": Strength(data["basis"]),
                "unless": tuple(map(Reason.from_dict, data["unless"])),
                "proof": proof,
            }
        )

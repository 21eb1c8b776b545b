"""Types of a paper's content: the paper, its notation and its claims."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench.context.claim_parts import ClaimForm, ClaimSource, Mend, Sentence
from workbench.context.facts import Act, Fact
from workbench.context.index_values import Orders
from workbench.core.paper_errors import PaperError
from workbench.core.reasons import Reason
from workbench.core.schema import key_names
from workbench.core.spans import Span
from workbench.core.verdict import Outcome
from workbench.runtime import Budget

if TYPE_CHECKING:
    from workbench.core.names import Name
    from workbench.core.terms import Statement, Symbol
    from workbench.language.author_notation import AuthorNotation
    from workbench.language.definitions import Definitions
    from workbench.language.goals.goals import Goal
    from workbench.language.goals.proofs import Proven
    from workbench.language.naming.symbols import SymbolTable


#: Keys of [citation]: the details of the paper and of the version that was read, for a note to its editor.
CITATION_KEYS = key_names("citation")


@dataclass(frozen=True)
class Formula:
    """A formula as written in a file, with the statement that was read from it.

    Attributes:
        ill_formed: Why the formula has no type.
        unread: Why the formula of a text cannot be parsed. Such a formula does not stop the others from being
            read.
        at: The position of the fault.
    """

    latex: str
    statement: Statement | None = None
    ill_formed: Reason | None = None
    unread: Reason | None = None
    at: Span | None = field(default=None, repr=False)

    def __str__(self) -> str:
        return self.latex

    @property
    def parsed(self) -> Statement:
        """The statement of a formula that is known to be read."""
        assert self.statement is not None, f"{self.latex} is not read"
        return self.statement


@dataclass(frozen=True)
class Robot:
    """A body of a URDF file; claims can be evaluated on its motion."""

    urdf: Path
    body: str


@dataclass(frozen=True)
class OnMotions:
    """How a claim is evaluated on motions.

    Attributes:
        holds: Our formula that holds.
        printed: Our formula that states the claim as printed.
        on: The special motion to use.
        none: Why no motion can show the claim; "algebra" if the claim is about no motion.
    """

    holds: Formula | None = None
    printed: Formula | None = None
    orders: Orders | None = None
    on: str | None = None
    none: str | None = None


@dataclass(frozen=True)
class Stated:
    """A goal as written in a file, with the goal that was read from it.

    Attributes:
        bare: The goal without the hypothesis that the text does not state.
    """

    latex: str
    goal: Goal
    bare: Goal


@dataclass(frozen=True)
class Notation:
    """The notation in which the formulas of one file are written.

    Attributes:
        motion: Symbol → its name on Drake's motions.
        on_motions: Claim → the formulas to evaluate there instead of the claim's own.
        words: Functions that a text writes without their backslash.
        framed: Symbols that [frames] and [points] define.
        since: For a symbol that a scope redeclares: the file and line where the scope begins.
    """

    symbols: SymbolTable
    definitions: Definitions
    motion: Mapping[Symbol, str]
    robot: Robot | None = None
    on_motions: Mapping[str, OnMotions] = field(default_factory=dict)
    words: frozenset[str] = frozenset()
    framed: frozenset[Name] = frozenset()
    since: Mapping[Name, tuple[Path, int]] = field(default_factory=dict)

    @cached_property
    def author_notation(self) -> AuthorNotation:
        """The spelling conventions of the author."""
        from workbench.language.author_notation import AuthorNotation

        return AuthorNotation(self.symbols)


@dataclass(frozen=True)
class Correction:
    """The right form of a printed formula.

    Attributes:
        reading: The intended formula, for an ill-formed one.
        corrected: The right formula, for a false one.
        hypothesis: The missing condition.
    """

    reading: Formula | None = None
    corrected: Formula | None = None
    hypothesis: Formula | None = None


@dataclass(frozen=True)
class ClaimProof:
    """The goal of a claim that is no single identity, and its proofs.

    Attributes:
        goal: A statement with quantifiers.
        theorem: The name of the goal's proof in the installed paper.
        argued: The argument that connects the goal with the sentence, where no rule does.
        every_n: The name of the proof that the right form, which is judged for some n, holds for all n.
    """

    goal: Stated | None = None
    theorem: str | None = None
    argued: str | None = None
    every_n: str | None = None


@dataclass(frozen=True)
class ClaimContext:
    """The context of a formula in a text.

    Attributes:
        span: The position of the formula in the text.
        given: The formulas from which it follows.
        beside: Those of them that stand beside it, as in "where f = g^2".
        repeats: Whether earlier formulas give the symbol that it says something of, so that it asserts.
        explains: Whether words introduce it as the definition of a symbol beside it, as in "where f = g^2".
        alone: Whether the model says that the claim follows from no other fact.
        act: What the formula does, and to which symbol.
        guessed: Symbols whose kinds are unconfirmed guesses.
        facts: The facts that the text states of the symbols.
        moving: Symbols whose rates the text writes.
        properties: Properties of the symbol alone on the left that the text states, each with its words.
    """

    span: Span | None = None
    given: tuple[Formula, ...] = ()
    beside: tuple[Formula, ...] = ()
    repeats: bool = False
    explains: bool = False
    alone: bool = False
    act: tuple[Act, Symbol | None] = (Act.ASSERT, None)
    guessed: tuple[str, ...] = ()
    facts: tuple[Fact, ...] = ()
    moving: frozenset[Name] = frozenset()
    properties: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class Ambiguity:
    """The readings of a display that has two.

    Attributes:
        perhaps: Equations next to the formula that may be its conditions.
        serves: The formulas whose condition this one may be.
        otherwise: The formulas that the display states if its rows are joined the other way.
        question: A question to the author that names both readings.
    """

    perhaps: tuple[Formula, ...] = ()
    serves: tuple[Formula, ...] = ()
    otherwise: tuple[Formula, ...] = ()
    question: str | None = None


@dataclass(frozen=True)
class Claim:
    """One `[[claim]]` of a paper file, one line of it, or one step of a display in a text.

    Attributes:
        printed: The judged formula as printed, or our formula for a statement printed in words.
        assume: The conditions of the formula.
        inherits: The claims whose faults this one shows, too.
        chain: The ids of the earlier steps in its chain.
        skip: Why the author of the model leaves the claim out.
        unread: Why the model expects no verdict.
    """

    id: str
    printed: Formula
    notation: Notation
    assume: tuple[Formula, ...] = ()
    orders: Orders | None = None
    correction: Correction = field(default_factory=Correction)
    mend: Mend = field(default_factory=Mend)
    source: ClaimSource = field(default_factory=ClaimSource)
    sentence: Sentence = field(default_factory=Sentence)
    proof: ClaimProof = field(default_factory=ClaimProof)
    context: ClaimContext = field(default_factory=ClaimContext)
    ambiguity: Ambiguity = field(default_factory=Ambiguity)
    inherits: tuple[str, ...] = ()
    chain: tuple[str, ...] = ()
    skip: str | None = None
    unread: str | None = None

    @property
    def equation(self) -> str | None:
        return self.source.equation

    @property
    def section(self) -> str | None:
        return self.source.section

    @property
    def line(self) -> int:
        return self.source.line

    @property
    def reading(self) -> Formula | None:
        return self.correction.reading

    @property
    def corrected(self) -> Formula | None:
        return self.correction.corrected

    @property
    def forms(self) -> dict[ClaimForm, Formula]:
        """The formulas by form; the printed form always, the others if the claim has them."""
        found = zip(ClaimForm, (self.printed, self.reading, self.corrected), strict=True)
        return {form: formula for form, formula in found if formula is not None}

    def with_context(self, **changes: Any) -> Claim:
        """Returns the claim with changed fields of its context."""
        return replace(self, context=replace(self.context, **changes))

    @property
    def expected(self) -> Outcome:
        """The outcome of the printed form that the claim's keys expect."""
        if self.skip is not None or self.unread is not None:
            return Outcome.UNCHECKED
        if self.proof.argued is not None:
            return Outcome.ARGUED
        if self.reading is not None:
            return Outcome.ILL_FORMED
        if self.corrected is not None:
            return Outcome.REFUTED
        return Outcome.PROVED if self.correction.hypothesis is None else Outcome.CONDITIONAL

    @property
    def shown(self) -> str | None:
        """The printed formula or sentence; None if only our formula states it."""
        return None if self.sentence.ours else self.printed.latex or self.sentence.quote

    @property
    def displayed(self) -> str | None:
        """The formula as the text shows it; None where the claim is a sentence."""
        return None if self.shown == self.sentence.quote else self.shown

    @property
    def right(self) -> Formula:
        """The corrected form, else the intended reading, else the printed form."""
        return self.corrected or self.reading or self.printed

    @property
    def our_formula(self) -> str | None:
        return self.printed.latex if self.sentence.ours else None

    @property
    def supposed(self) -> tuple[Statement, ...]:
        """All premises: assumed conditions, facts given for all times, and declared properties of symbols."""
        said, definitions = self.printed.statement, self.notation.definitions
        given = [formula.parsed for formula in self.context.given]
        if given and said is not None:
            from workbench.engines.inventory.assumptions import lasting

            given = lasting(given, said, definitions)
        premises = (*(formula.parsed for formula in self.assume), *given)
        spoken = premises if said is None else (said, *premises)
        declared = dict.fromkeys(each for part in spoken for each in definitions.known_of(part))
        return (*premises, *declared)

    @property
    def instances(self) -> list[dict[str, int]]:
        """All assignments of the claim's integers; [{}] for a claim without integers."""
        return list(self.orders.assignments()) if self.orders else [{}]


@dataclass(frozen=True)
class Paper:
    """A paper and its claims in reading order.

    Attributes:
        notation: The notation of its file; of several files, the first notation file that one of them names,
            else the notation of the first file. Each claim has its own.
        theorems: Name → the proof of the goal of the claim that names it, or an independent argument.
        budget: The limits of each judgement; None if the paper sets none.
        citation: Details of the paper and of the version that was read (CITATION_KEYS).
        faults: Entries of a model that do not fit its text.
        sections: Number → heading.
    """

    title: str
    doi: str | None
    paths: tuple[Path, ...]
    notation: Notation
    claims: tuple[Claim, ...]
    theorems: Mapping[str, Proven] = field(default_factory=dict)
    budget: Budget | None = None
    citation: Mapping[str, str] = field(default_factory=dict)
    faults: tuple[PaperError, ...] = ()
    sections: Mapping[str, str] = field(default_factory=dict)

    @property
    def symbols(self) -> SymbolTable:
        return self.notation.symbols

    @property
    def definitions(self) -> Definitions:
        return self.notation.definitions

    @property
    def motion(self) -> Mapping[Symbol, str]:
        return self.notation.motion


@dataclass(frozen=True)
class InstalledPaper:
    """A paper that an entry point of the group `workbench.papers` names: its claim files in reading order,
    and its theorems.
    """

    files: tuple[Path, ...]
    theorems: Mapping[str, Proven] = field(default_factory=dict)

"""What a paper file says: the paper, its notation and its claims."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING

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
    from workbench.language.author_notation import Hand
    from workbench.language.definitions import Definitions
    from workbench.language.goals.goals import Goal
    from workbench.language.goals.proofs import Proven
    from workbench.language.naming.symbols import SymbolTable


#: What a fault can be.
FAULTS = ("error", "misprint", "transcription", "wording", "hypothesis")

#: What a note to an editor says of the paper and of what was read.
CITATION_KEYS = key_names("citation")


@dataclass(frozen=True)
class Formula:
    """LaTeX as the file has it, and what was read: a statement, or why it is ill-formed, or why it is unread
    (in a text: one formula that the workbench cannot read hides no other). `at`: where the fault is."""

    latex: str
    statement: Statement | None = None
    ill_formed: Reason | None = None
    unread: Reason | None = None
    at: Span | None = field(default=None, repr=False)

    def __str__(self) -> str:
        return self.latex


@dataclass(frozen=True)
class Robot:
    """A body of a URDF file, whose motion is one of those that a paper's claims are looked at on."""

    urdf: Path
    body: str


@dataclass(frozen=True)
class OnMotions:
    """What motions say of a claim, in our formulas: one that holds, and one that says it as printed.

    on: the special motion on which they are looked at.   none: why no motion shows it; "algebra" if it is
    about no motion."""

    holds: Formula | None = None
    printed: Formula | None = None
    orders: Orders | None = None
    on: str | None = None
    none: str | None = None


@dataclass(frozen=True)
class Stated:
    """A goal as the file has it, and what was read; `bare`: without the hypothesis that the text does not
    state."""

    latex: str
    goal: Goal
    bare: Goal


@dataclass(frozen=True)
class Edit:
    """What an editor does at one place of the printed text: for `old` read `new`. Both are LaTeX where
    `is_math`, else prose with LaTeX between dollar signs; an empty `new` strikes out."""

    old: str
    new: str
    is_math: bool


@dataclass(frozen=True)
class Mend:
    """How a fault is mended. edits: in what is printed, or in `beside`, a sentence or formula next to it.
    place: where in the equation, in words.   cause: what several faults have in common, in words.
    by: the claim whose edits mend this one too.   add: a missing hypothesis in the author's own words.
    example: a counterexample in words, where values of symbols would not tell what is wrong."""

    edits: tuple[Edit, ...] = ()
    beside: str | None = None
    place: str | None = None
    cause: str | None = None
    add: str | None = None
    example: str | None = None
    by: str | None = None


@dataclass(frozen=True)
class Notation:
    """What the formulas of one file are written in. `motion`: symbol → its name on Drake's motions.
    `on_motions`: claim → what is looked at there, where that is not the claim's own formula. `words`:
    functions that a text writes without their backslash. `framed`: symbols that [frames] and [points]
    define. `since`: for a symbol that a scope declares anew, the file and line where that begins."""

    symbols: SymbolTable
    definitions: Definitions
    motion: Mapping[Symbol, str]
    robot: Robot | None = None
    on_motions: Mapping[str, OnMotions] = field(default_factory=dict)
    words: frozenset[str] = frozenset()
    framed: frozenset[Name] = frozenset()
    since: Mapping[Name, tuple[Path, int]] = field(default_factory=dict)

    @cached_property
    def hand(self) -> Hand:
        """How its author writes."""
        from workbench.language.author_notation import Hand

        return Hand(self.symbols)


@dataclass(frozen=True)
class Claim:
    """One `[[claim]]` of a paper file, or one line of it, or one step of a display in a text.

    printed: the formula that is judged, as printed, or, where `ours`, our formula for what is printed in
    words. quote: a printed sentence.   goal: what one identity cannot say.   theorem: the name of its proof
    in the installed paper.   argued: what joins the goal to the sentence, where no rule does.   every_n: the
    name of the proof that its right form, which is judged for some n, holds for every n.   fault: what kind
    of fault the claim shows.   Of a text: `span` is where the formula stands, `chain` the ids of the steps
    before it in its chain, `skip` why its author leaves it out, `unread` why its model expects no verdict,
    `act` what its formula does and to which symbol, `guessed` its symbols whose kinds nobody has confirmed,
    `facts` what the text says of its symbols, `moving` of what the text writes rates, `alone` that its model
    says that it follows from nothing else.
    Where a display has two readings: `perhaps` holds the equations beside the formula that may be its
    conditions, `serves` the formulas whose condition it may be, `otherwise` the formulas that the display
    states if its rows are joined the other way, and `question` names both readings.
    """

    id: str
    printed: Formula
    notation: Notation
    equation: str | None = None
    section: str | None = None
    reading: Formula | None = None
    corrected: Formula | None = None
    hypothesis: Formula | None = None
    assume: tuple[Formula, ...] = ()
    given: tuple[Formula, ...] = ()
    alone: bool = False
    orders: Orders | None = None
    note: str = ""
    inherits: tuple[str, ...] = ()
    statement: str | None = None
    ours: bool = False
    quote: str | None = None
    goal: Stated | None = None
    theorem: str | None = None
    argued: str | None = None
    every_n: str | None = None
    fault: str | None = None
    mend: Mend = Mend()
    file: Path | None = None
    line: int = 0
    span: Span | None = None
    chain: tuple[str, ...] = ()
    skip: str | None = None
    unread: str | None = None
    act: tuple[Act, Symbol | None] = (Act.ASSERT, None)
    guessed: tuple[str, ...] = ()
    facts: tuple[Fact, ...] = ()
    moving: frozenset[Name] = frozenset()
    perhaps: tuple[Formula, ...] = ()
    serves: tuple[Formula, ...] = ()
    otherwise: tuple[Formula, ...] = ()
    question: str | None = None

    @property
    def expected(self) -> Outcome:
        """What the keys of the claim say of its printed form."""
        if self.skip is not None or self.unread is not None:
            return Outcome.UNCHECKED
        if self.argued is not None:
            return Outcome.ARGUED
        if self.reading is not None:
            return Outcome.ILL_FORMED
        if self.corrected is not None:
            return Outcome.REFUTED
        return Outcome.PROVED if self.hypothesis is None else Outcome.CONDITIONAL

    @property
    def shown(self) -> str | None:
        """The formula or the sentence that is printed; None where only our formula says it."""
        return None if self.ours else self.printed.latex or self.quote

    @property
    def right(self) -> Formula:
        """What stands right for what is printed, if anything does, or what is printed."""
        return self.corrected or self.reading or self.printed

    @property
    def our_formula(self) -> str | None:
        return self.printed.latex if self.ours else None

    @property
    def supposed(self) -> tuple[Statement, ...]:
        """The conditions that the text states, what is given, always, and what is declared of its symbols."""
        said, definitions = self.printed.statement, self.notation.definitions
        given = [formula.statement for formula in self.given]
        if given and said is not None:
            from workbench.engines.inventory.assumptions import lasting

            given = lasting(given, said, definitions)
        premises = (*(formula.statement for formula in self.assume), *given)
        spoken = premises if said is None else (said, *premises)
        declared = dict.fromkeys(each for part in spoken for each in definitions.known_of(part))
        return (*premises, *declared)

    @property
    def instances(self) -> list[dict[str, int]]:
        """All values of the claim's integers; {} alone for a claim without any."""
        return list(self.orders.assignments()) if self.orders else [{}]


@dataclass(frozen=True)
class Paper:
    """A paper and its claims in reading order.

    notation: that of its one file; of several files, the first notation file that one of them names, or else
    that of the first. Each claim carries its own.   theorems: name → a proof for
    the goal of the claim that names it, or an argument of its own.
    budget: of each judgement; None where the paper says nothing of it.   faults: what of a model does not fit
    its text.   citation: what a note to its editor
    says of it and of what was read (CITATION_KEYS).   sections: number → heading.
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
    """What the entry points of the group `workbench.papers` name: the claim files of a paper in reading order
    and the theorems that they refer to."""

    files: tuple[Path, ...]
    theorems: Mapping[str, Proven] = field(default_factory=dict)

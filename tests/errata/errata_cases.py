"""Measures one case of a public misprint: read, found, place, correction, false alarms, seconds."""

from __future__ import annotations

import tempfile
import time
import tomllib
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

from tests.drafts import draft_of
from workbench.app.pipeline.judge_claims import judge_claims
from workbench.app.pipeline.result_proposals import asks_for_proposals
from workbench.context.claims import Claim
from workbench.context.read_formulas import read_statement
from workbench.core.construct import relation
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.paper_errors import PaperError
from workbench.core.terms import Conjunction, Relation, Statement, Term, Zero
from workbench.core.verdict import Grade, Outcome
from workbench.engines.inventory import NoDefinitions, NotExact
from workbench.engines.jet.rings import PRIME
from workbench.papers.drafting.judged_draft import on_drafted_kinds
from workbench.papers.load import load_paper
from workbench.prover.results.claim_results import ClaimResult
from workbench.repair.propose.chain_neighbours import ALONE, neighbours_of
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits
from workbench.repair.screening.real_values import RealValues
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.coefficients import factor_between

HERE = Path(__file__).resolve().parent

FALSE = frozenset({Outcome.REFUTED, Outcome.ILL_FORMED})

#: Of wall time, for the search of one false claim.
SECONDS = 10.0


@dataclass(frozen=True)
class Case:
    """One folder: the text before and after, the lines of the misprints, whether the text decides it."""

    folder: Path
    about: Mapping[str, Any]

    @property
    def name(self) -> str:
        return self.folder.name

    @property
    def is_decidable(self) -> bool:
        return str(self.about["decidable"]).startswith("yes")

    @property
    def lines(self) -> list[int]:
        return [int(each["line"]) for each in self.about["correction"]]


@dataclass(frozen=True)
class Row:
    """What the workbench said of one case.

    read: displays of `before` that are read as a whole, of all.   found: a display of `before` is shown as
    an error or a warning at a misprint.   place: each misprint lies in such a display, and nothing else is called false.
    correction: "first" if the first proposal is the author's formula, "among" if another one is, else "other" or
    "none".
    alarms: formulas of `after` that are called false."""

    name: str
    decidable: bool
    read: str
    found: bool
    place: bool
    correction: str
    alarms: int

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


def cases(folder: Path = HERE) -> list[Case]:
    """The cases of a folder, by name."""
    return [case_in(file.parent) for file in sorted(folder.glob("*/case.toml"))]


def case_in(folder: Path) -> Case:
    """The case of one folder. Raises TOMLDecodeError, OSError."""
    return Case(folder, tomllib.loads((folder / "case.toml").read_text(encoding="utf-8")))


def measured(case: Case, drafted: bool = False, seconds: float = SECONDS) -> tuple[Row, float]:
    """The row of a case, and the seconds that it took. drafted: without the models of the folder."""
    start = time.perf_counter()
    before, after = _judged(case, "before", drafted), _judged(case, "after", drafted)
    false = [result for result in before if _is_alarm(result)]
    at_place = [result for result in false if any(_covers(result.claim, line) for line in case.lines)]
    hit = {line for line in case.lines for result in false if _covers(result.claim, line)}
    read = [result for result in before if result.claim.printed.unread is None]
    row = Row(
        case.name,
        case.is_decidable,
        f"{len(read)}/{len(before)}",
        bool(at_place),
        bool(at_place) and len(at_place) == len(false) and hit == set(case.lines),
        _correction(at_place, before, [result.claim for result in after], seconds),
        sum(map(_is_alarm, after)),
    )
    return row, time.perf_counter() - start


def _judged(case: Case, name: str, drafted: bool) -> list[ClaimResult]:
    if not drafted:
        return judge_claims(load_paper(case.folder / f"{name}.toml").claims)
    (text,) = (path for path in case.folder.glob(f"{name}.*") if path.suffix != ".toml")
    with tempfile.TemporaryDirectory() as folder:
        copy = Path(folder, text.name)
        copy.write_text(text.read_text(encoding="utf-8"), encoding="utf-8")
        try:
            draft = draft_of(copy)
        except PaperError:
            return []
        return on_drafted_kinds(draft, judge_claims(draft.paper.claims))


def _is_alarm(result: ClaimResult) -> bool:
    """True if the formula is shown as an error or a warning, and not as a note."""
    return result.verdict.outcome in FALSE and result.verdict.grade in (Grade.ERROR, Grade.WARNING)


def _covers(claim: Claim, line: int) -> bool:
    """Whether the line prints a part of the formula; a step of a chain goes on from the row before."""
    first = claim.context.span.line if claim.context.span else claim.line
    last = claim.context.span.end_line if claim.context.span else claim.line
    return first - bool(claim.chain) <= line <= last


def _correction(
    false: Sequence[ClaimResult], before: Sequence[ClaimResult], after: Sequence[Claim], seconds: float
) -> str:
    """ "first" or "among" the proposals for a claim is the author's formula, or none of them is."""
    limits, beside = Limits(seconds=seconds), neighbours_of([result.claim for result in before])
    ranks, count = [], 0
    for claim in (result.claim for result in false if asks_for_proposals(result)):
        proposals = repair(claim, limits, beside=beside.get(claim.id, ALONE)).proposals
        count += len(proposals)
        ranks += [
            rank
            for rank, proposal in enumerate(proposals)
            if any(_is_formula_of(proposal.latex, claim, right) for right in after)
        ]
    if ranks:
        return "first" if min(ranks) == 0 else "among"
    return "other" if count else "none"


def _is_formula_of(latex: str, claim: Claim, right: Claim) -> bool:
    """Whether the proposal says what the author's formula says, with all defined symbols left free."""
    with suppress(ReadError, IllFormedAt, PaperError):
        proposed, _ = read_statement(latex, claim.notation, claim.orders)
        meant, _ = read_statement(right.printed.latex, claim.notation, claim.orders)
        return is_same_formula(proposed, meant)
    return False


def is_same_formula(one: Statement, other: Statement) -> bool:
    """Whether two statements are equal side by side for free symbols, or rearranged."""
    if one == other:
        return True
    match one, other:
        case Conjunction(), Conjunction():
            parts = zip(one.parts, other.parts, strict=False)
            return len(one.parts) == len(other.parts) and all(is_same_formula(a, b) for a, b in parts)
        case Relation(), Relation() if one.operator == other.operator:
            return _have_same_sides(one, other)
    return False


def _have_same_sides(one: Relation, other: Relation) -> bool:
    try:
        screen = Screen(NoDefinitions(), (), [{"i": 1, "j": 2, "k": 3, "n": 3}] * 2, seed=39)
    except NotExact:
        return False
    shape = one.left if not isinstance(one.left, Zero) else one.right
    left, right = _components(screen, one, shape), _components(screen, other, shape)
    if left is None or right is None:
        return _have_same_real_sides(one, other)
    return left in (right, right[::-1]) or factor_between(_minus(left), _minus(right)) is not None


def _have_same_real_sides(one: Relation, other: Relation) -> bool:
    """Whether the sides agree at real points, where lengths and roots have values."""
    reals = RealValues(NoDefinitions())
    pairs = ((one.left, other.left), (one.right, other.right))
    return all(a.type == b.type and reals.differ(relation("=", a, b)) is False for a, b in pairs)


def _components(
    screen: Screen, relation: Relation, shape: Term
) -> tuple[tuple[int, ...], tuple[int, ...]] | None:
    sides = [screen.components(side, shape) for side in (relation.left, relation.right)]
    first, second = sides
    if first is None or second is None or len(first) != len(second):
        return None
    return first, second


def _minus(sides: tuple[tuple[int, ...], tuple[int, ...]]) -> tuple[int, ...]:
    return tuple((x - y) % PRIME for x, y in zip(*sides, strict=True))

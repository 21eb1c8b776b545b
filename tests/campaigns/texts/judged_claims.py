"""What the product says of a document's formulas, matched with what is true of them."""

from __future__ import annotations

import re
import signal
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from itertools import groupby
from pathlib import Path

from one_fault import FALSE, TRUE, UNDER
from written_documents import Document, Shown, Step

#: Of processor time for one document.
SECONDS = 600

_NAME = re.compile(r"(d\d+x)([a-z])")
_ROWS = re.compile(r"\\(?:label|tag)\{")
_LAYOUT = re.compile(r"\\(?:begin|end)\{(?:split|aligned|gathered)\}|\\\\|&")
_SPACE = re.compile(
    r"\\(?:left|right|quad|qquad|nonumber|notag|displaystyle|big|Big|bigl|bigr|Bigl|Bigr)(?![A-Za-z])\.?"
    r"|\\[,;:!> ]|[\s{}~]"
)
_BESIDE = re.compile(r"[,;]?(?:\\text|\\forall|\\mbox|\()")

#: The claims that the reason of a conditional verdict names.
_PREMISE = re.compile(r"\((d\d+x\w[.\d]*)\)")
HOLDS = {"proved"}
DENIED = {"refuted", "ill-formed"}


@dataclass(frozen=True)
class Seen:
    """One claim of the product: its id, formula and verdict."""

    id: str
    latex: str
    outcome: str
    reason: str
    line: int

    @property
    def key(self) -> str:
        return key_of(self.latex)


@dataclass(frozen=True)
class Finding:
    """What the product made of one formula of a display. kind: one of KINDS."""

    kind: str
    display: Shown
    format: str
    free: bool
    step: Step | None
    seen: Seen | None

    @property
    def family(self) -> str:
        return self.step.family if self.step is not None else "none"


#: Right, silent, and wrong.
KINDS = (
    "proved", "conditional", "refuted", "definition", "silent", "excused",
    "false proof", "false alarm", "vanished", "invented", "mislabelled",
)  # fmt: skip
WRONG = ("false proof", "false alarm", "vanished", "invented", "mislabelled")


@dataclass
class Judged:
    """All findings on a document; `broken`: why there are none."""

    document: Document
    findings: list[Finding] = field(default_factory=list)
    broken: str | None = None


def key_of(latex: str) -> str:
    """A formula without spaces, braces, sizes of brackets and marks of alignment."""
    return _SPACE.sub("", _LAYOUT.sub("", latex)).strip(",.;")


@contextmanager
def _limited() -> Iterator[None]:
    def stop(*_: object) -> None:
        raise TimeoutError(f"more than {SECONDS} s")

    before = signal.signal(signal.SIGALRM, stop)
    signal.setitimer(signal.ITIMER_REAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)


def claims_of(text: str, model: str, format_name: str) -> list[Seen]:
    """The product's claims in a text, each with its verdict, judged in this process without memory."""
    from workbench.app.pipeline.judge_claims import judge_paper
    from workbench.papers.load import load_paper
    from workbench.runtime import workers

    methods = workers.get_all_start_methods
    workers.get_all_start_methods = list  # no process of its own for each judgement
    try:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            (folder / f"text.{format_name}").write_text(text)
            (folder / "text.toml").write_text(model)
            paper = load_paper(folder / "text.toml")
            if paper.faults:
                raise ValueError(str(paper.faults[0]))
            results = judge_paper(paper, jobs=1, motions=False)
    finally:
        workers.get_all_start_methods = methods
    return [
        Seen(
            each.claim.id,
            each.claim.printed.latex or "",
            each.verdict.outcome.value,
            str(each.verdict.reason or each.verdict.hypothesis or ""),
            each.claim.context.span.line if each.claim.context.span else 0,
        )
        for each in results
    ]


def judged(document: Document) -> Judged:
    """The findings on a document."""
    try:
        with _limited():
            seen = claims_of(document.text, document.model, document.format)
    except Exception as error:  # a campaign goes on, and tells it
        return Judged(document, broken=f"{type(error).__name__}: {error}")
    found = Judged(document)
    taken: set[str] = set()
    for display in document.shown:
        own = [each for each in seen if _stands_in(each, display)]
        taken |= {each.id for each in own}
        for kind, step, claim in compared(display, own):
            found.findings.append(Finding(kind, display, document.format, document.free, step, claim))
    for each in seen:
        if each.id not in taken:
            nowhere = Shown("nowhere", "none", "", [], [])
            found.findings.append(Finding("invented", nowhere, document.format, document.free, None, each))
    return found


def _stands_in(claim: Seen, display: Shown) -> bool:
    named = _NAME.match(claim.id)
    if named is not None:
        return named[1] == display.name
    return display.lines[0] <= claim.line <= display.lines[1] and claim.line > 0


def compared(display: Shown, claims: list[Seen]) -> Iterator[tuple[str, Step | None, Seen | None]]:
    """What the claims in a display are, each beside the step that it says; what is lost and what is new."""
    if not display.printed:
        yield from (("invented", None, each) for each in claims)
        return
    left = list(claims)
    lost: list[Step] = []
    for _, group in groupby(display.steps, lambda step: step.statement):
        steps = list(group)
        whole = _whole(steps)
        claim = next((each for each in left if _says(each, whole)), None)
        if claim is not None:  # one claim for all steps
            left.remove(claim)
            yield from ((kind_of(whole, claim), step, claim) for step in steps)
            continue
        for step in steps:
            claim = next((each for each in left if _says(each, step)), None)
            if claim is None:
                lost.append(step)
                continue
            left.remove(claim)
            yield kind_of(step, claim), step, claim
            if _is_mislabelled(display, step, claim):
                yield "mislabelled", None, claim
    asides = {key_of(each) for each in display.asides}
    for each in left:
        if each.key in asides:
            if each.outcome in HOLDS | DENIED:
                yield "false proof" if each.outcome in HOLDS else "false alarm", None, each
            continue
        yield "invented", None, each
        if each.outcome in HOLDS and any(step.truth != TRUE for step in lost):
            yield "false proof", None, each
        if each.outcome in DENIED and not any(step.truth == FALSE for step in lost):
            yield "false alarm", None, each
    yield from (("vanished", step, None) for step in lost)


def _is_mislabelled(display: Shown, step: Step, claim: Seen) -> bool:
    """Whether it has the label of another row; only where each statement, or each step, has a row of its own."""
    named = _NAME.match(claim.id)
    rows, statements = len(_ROWS.findall(display.source)), display.steps[-1].statement + 1
    if named is None or rows == 1:
        return False
    if rows == statements:
        return ord(named[2]) - ord("a") != step.statement
    if statements == 1 and rows == len(display.steps):
        return ord(named[2]) - ord("a") != display.steps.index(step)
    return False


def _whole(steps: list[Step]) -> Step:
    """A chain as one formula; true if all its steps are."""
    truths = {each.truth for each in steps}
    truth = next(each for each in (FALSE, UNDER, TRUE) if each in truths)
    first = steps[0]
    sides = " = ".join(each.right for each in steps)
    return Step(first.left, sides, truth, first.family, first.statement, first.beside)


def _says(claim: Seen, step: Step) -> bool:
    key, wanted = claim.key, key_of(f"{step.left} = {step.right}")
    if key.startswith(wanted):
        rest = key[len(wanted) :]
        return not rest or _BESIDE.match(rest) is not None
    return key.endswith(wanted) and key.startswith(r"\text")


def kind_of(step: Step, claim: Seen) -> str:
    """Returns what a verdict is, given the truth. A false formula with a condition beside it is false under
    the condition, unless the verdict names an equation of another display that the condition does not say.
    """
    if claim.outcome == "definition":
        return "definition"
    if claim.outcome in HOLDS:
        return "proved" if step.truth in (TRUE, UNDER) else "false proof"
    if claim.outcome in DENIED:
        return "refuted" if step.truth == FALSE else "false alarm"
    if claim.outcome == "conditional":
        if step.truth == FALSE:
            rests_on_another = bool(set(_PREMISE.findall(claim.reason)) - {claim.id})
            return "excused" if step.beside is None or rests_on_another else "false proof"
        return "conditional"
    return "silent"

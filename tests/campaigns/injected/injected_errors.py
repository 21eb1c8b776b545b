"""One misprint put into a formula that is proved: what kinds there are, and what the workbench says of each."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from random import Random
from typing import Any

TESTS = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(TESTS / "errata")]

from errata_cases import is_same_formula  # noqa: E402

from tests.screens import is_refuted_by  # noqa: E402
from workbench.app.pipeline.judge_claims import judge_claims, judge_paper  # noqa: E402
from workbench.context.claim_parts import Mend  # noqa: E402
from workbench.context.claims import Claim, Correction, Formula, Paper  # noqa: E402
from workbench.context.read_formulas import read_statement  # noqa: E402
from workbench.core.codes.verdict_codes import VerdictCode  # noqa: E402
from workbench.core.formula_errors import Fault, IllFormedAt, ReadError  # noqa: E402
from workbench.core.paper_errors import PaperError  # noqa: E402
from workbench.core.terms import Statement  # noqa: E402
from workbench.core.verdict import Outcome  # noqa: E402
from workbench.engines.inventory.inventory import NotExact  # noqa: E402
from workbench.language.elaboration.superscripts import is_transpose  # noqa: E402
from workbench.language.grammar.latex_forms import latex_of  # noqa: E402
from workbench.language.grammar.parser import parse  # noqa: E402
from workbench.language.grammar.syntax import (  # noqa: E402
    Accented,
    Chain,
    Infix,
    Leaf,
    Lines,
    Node,
    Product,
    Scripted,
    Sum,
    core,
    is_left_script,
)
from workbench.papers.installed_papers import installed_names  # noqa: E402
from workbench.papers.load import load_installed, load_paper  # noqa: E402
from workbench.repair.propose.repair import repair  # noqa: E402
from workbench.repair.propose.search_limits import Limits  # noqa: E402
from workbench.repair.screening.screen import Screen  # noqa: E402
from workbench.repair.trees.tree_nodes import below, exchanged  # noqa: E402

#: A node, and what stands there instead.
Swap = tuple[Node, Node]

#: Found: the formula is refuted or ill-formed. Silent: it is not judged. True: the change keeps it true.
FOUND, SILENT, STILL_TRUE, FALSE_PROOF = "found", "silent", "still true", "false proof"


@dataclass(frozen=True)
class Injected:
    """One line of the manifest."""

    source: str
    claim: str
    kind: str
    printed: str
    changed: str
    result: str
    outcome: str
    reason: str
    corrected: bool

    def to_dict(self) -> dict[str, Any]:
        return asdict(self)


# the kinds of misprints


def _in_scripts(lines: Lines) -> set[int]:
    scripts = [s for n in below(lines) if isinstance(n, Scripted) for s in (n.sub, n.sup) if s is not None]
    return {id(part) for script in scripts for part in below(script)}


def signs(lines: Lines) -> Iterator[Swap]:
    """Another sign before an addend, or × for · and · for ×."""
    inside = _in_scripts(lines)
    for node in below(lines):
        if isinstance(node, Sum) and id(node) not in inside:
            for at, (sign, where, addend) in enumerate(node.addends):
                other = "+" if sign == "-" else "-"
                changed = (*node.addends[:at], (other, where, addend), *node.addends[at + 1 :])
                yield node, Sum(node.at, changed)
        if isinstance(node, Infix) and node.operator in "·×":
            yield node, Infix(node.at, "×" if node.operator == "·" else "·")


def indices(lines: Lines) -> Iterator[Swap]:
    """A figure of a subscript that is one more."""
    for node in below(lines):
        for part in below(node.sub) if isinstance(node, Scripted) and node.sub is not None else ():
            if isinstance(part, Leaf) and part.kind == "NUMBER" and part.text.isdigit():
                yield part, Leaf(part.at, "NUMBER", str(int(part.text) + 1))


def numbers(lines: Lines) -> Iterator[Swap]:
    """A number or an exponent that is one more."""
    below_letters = {id(p) for n in below(lines) if isinstance(n, Scripted) and n.sub for p in below(n.sub)}
    for node in below(lines):
        is_number = isinstance(node, Leaf) and node.kind == "NUMBER" and id(node) not in below_letters
        if is_number and node.text.isdigit() and node.text != "0":
            yield node, Leaf(node.at, "NUMBER", str(int(node.text) + 1))


def symbols(lines: Lines) -> Iterator[Swap]:
    """A letter that is another one of the formula."""
    inside = _in_scripts(lines)
    letters = [n for n in below(lines) if isinstance(n, Leaf) and n.kind == "LETTER" and id(n) not in inside]
    names = sorted({letter.text for letter in letters if len(letter.text.strip("\\")) > 0})
    for letter in letters:
        for name in names:
            if name != letter.text and letter.text not in ("d", "e", "\\partial", "\\nabla", "t", "\\pi"):
                yield letter, Leaf(letter.at, "LETTER", name)


def transposes(lines: Lines) -> Iterator[Swap]:
    """A transpose that is lost, or one more."""
    for node in below(lines):
        if isinstance(node, Scripted) and is_transpose(node.sup):
            yield node, replace(node, sup=None) if node.sub else node.nucleus
        if isinstance(node, Product):
            for at, item in enumerate(node.items):
                if isinstance(item, Leaf) and item.kind == "LETTER":
                    turned = Scripted(item.at, item, None, Leaf(item.at, "LETTER", "T"))
                    yield node, Product(node.at, (*node.items[:at], turned, *node.items[at + 1 :]))


def inverses(lines: Lines) -> Iterator[Swap]:
    """An inverse that is lost."""
    for node in below(lines):
        if (
            isinstance(node, Scripted)
            and isinstance(sup := core(node.sup), Sum)
            and latex_of(sup).replace(" ", "") == "-1"
        ):
            yield node, replace(node, sup=None) if node.sub else node.nucleus


def orders(lines: Lines) -> Iterator[Swap]:
    """Two factors beside each other in the other order."""
    for node in below(lines):
        if not isinstance(node, Product):
            continue
        for at, (one, other) in enumerate(zip(node.items, node.items[1:], strict=False)):
            if any(isinstance(x, Infix) or is_left_script(x) for x in (one, other)):
                continue
            if isinstance(one, Leaf) and one.kind in ("NUMBER", "FUNCTION"):
                continue
            yield node, Product(node.at, (*node.items[:at], other, one, *node.items[at + 2 :]))


def dots(lines: Lines) -> Iterator[Swap]:
    """A dot that is lost, or one more."""
    for node in below(lines):
        if isinstance(node, Accented) and node.accent != "~":
            order = int(node.accent)
            yield node, node.body if order == 1 else Accented(node.at, str(order - 1), node.body)
            if order < 4:
                yield node, Accented(node.at, str(order + 1), node.body)


def labels(lines: Lines) -> Iterator[Swap]:
    """The label of a frame that is another one of the formula."""
    inside = _in_scripts(lines)
    leaves = [n for n in below(lines) if isinstance(n, Leaf) and n.kind == "LETTER" and id(n) in inside]
    capital = [n for n in leaves if n.text.isupper() and n.text != "T"]
    for leaf in capital:
        for name in sorted({other.text for other in capital} - {leaf.text}):
            yield leaf, Leaf(leaf.at, "LETTER", name)


def circular(lines: Lines) -> Iterator[Swap]:
    """sin for cos, and cos for sin."""
    for node in below(lines):
        if isinstance(node, Leaf) and node.kind == "FUNCTION" and node.text in ("sin", "cos"):
            other = "cos" if node.text == "sin" else "sin"
            yield node, replace(node, text=other, name=other)


KINDS: dict[str, Callable[[Lines], Iterator[Swap]]] = {
    "sign or operator": signs,
    "index": indices,
    "number": numbers,
    "symbol": symbols,
    "transpose": transposes,
    "inverse": inverses,
    "order of factors": orders,
    "dot": dots,
    "frame label": labels,
    "sin or cos": circular,
}


# the formulas


def proved_claims(sources: Sequence[str] = ()) -> Iterator[tuple[str, Claim]]:
    """The claims of the chapter, of the installed texts and of the corrected errata whose printed form is
    proved, with their source."""
    for name in sorted(installed_names()):
        if not sources or name in sources:
            yield from ((name, claim) for claim in _proved(load_installed(name)))
    for file in sorted((TESTS / "errata").glob("*/after.toml")) if not sources or "errata" in sources else ():
        try:
            paper = load_paper(file)
        except PaperError:
            continue
        yield from ((f"errata/{file.parent.name}", claim) for claim in _proved(paper))


def _proved(paper: Paper) -> list[Claim]:
    asked = [c.id for c in paper.claims if _is_judged_as_printed(c)]
    results = judge_paper(paper, asked, motions=False) if asked else []
    proved = [r.claim for r in results if r.verdict.outcome is Outcome.PROVED]
    return [claim for claim in proved if _is_judged_as_printed(claim)]


def _is_judged_as_printed(claim: Claim) -> bool:
    """False for a claim with a goal of its own, which another printed form would not change."""
    return claim.printed.statement is not None and claim.proof.theorem is None and claim.proof.goal is None


def changed_forms(claim: Claim, kind: str) -> list[str]:
    """The formula with one misprint of the kind, as LaTeX, each once; what reads the same is left out."""
    try:
        lines = parse(claim.printed.latex)
    except Fault:
        return []
    if not any(isinstance(clause, Chain) for line in lines.lines for clause in line):
        return []
    found: dict[str, None] = {}
    for old, new in KINDS[kind](lines):
        found[latex_of(exchanged(lines, {id(old): new}))] = None
    return [latex for latex in found if latex != latex_of(lines)]


def changed_claim(claim: Claim, latex: str) -> Claim | None:
    """The claim with another printed form; None where that cannot be read, or says the same term."""
    own = replace(claim.proof, every_n=None)  # a proof of the right form, which another form has not
    plain = replace(claim, correction=Correction(), mend=Mend(), proof=own)
    try:
        statement, _ = read_statement(latex, claim.notation, claim.orders)
    except IllFormedAt as error:
        return replace(plain, printed=Formula(latex, ill_formed=str(error)))
    except (ReadError, PaperError):
        return None
    if statement == claim.printed.statement:
        return None
    return replace(plain, printed=Formula(latex, statement))


def injected(source: str, claim: Claim, kind: str, latex: str, seconds: float) -> Injected | None:
    """What is said of the claim with the misprint. seconds: for the correction; 0 for none."""
    made = changed_claim(claim, latex)
    if made is None:
        return None
    (result,) = judge_claims([made], motions=False)
    outcome = result.verdict.outcome
    holds = outcome in (Outcome.PROVED, Outcome.DEFINITION, Outcome.CONDITIONAL)
    if outcome in (Outcome.REFUTED, Outcome.ILL_FORMED):
        said = FOUND
    elif result.verdict.code is VerdictCode.SAME_TERM:
        said = STILL_TRUE
    elif made.printed.statement is None or not holds:
        said = SILENT
    else:
        said = FALSE_PROOF if outcome is Outcome.PROVED and _is_false(made) else STILL_TRUE
    corrected = bool(seconds) and said == FOUND and _is_corrected(made, claim, seconds)
    reason = str(result.verdict.reason or "")
    printed = claim.printed.latex
    return Injected(source, claim.id, kind, printed, latex, said, str(outcome), reason, corrected)


def _is_false(claim: Claim) -> bool:
    """Whether the sides differ at random points, so that a proof would be wrong."""
    statement = claim.printed.statement
    try:
        screen = Screen(claim.notation.definitions, claim.supposed, claim.instances[-2:], about=statement)
    except NotExact:
        return False
    return statement is not None and is_refuted_by(screen, statement)


def _is_corrected(made: Claim, right: Claim, seconds: float) -> bool:
    wanted = right.printed.statement
    for proposal in repair(made, Limits(seconds=seconds)).proposals:
        try:
            proposed, _ = read_statement(proposal.latex, right.notation, right.orders)
        except (ReadError, IllFormedAt):
            continue
        if isinstance(wanted, Statement) and is_same_formula(proposed, wanted):
            return True
    return False


def sample(
    random: Random, claims: Sequence[tuple[str, Claim]], count: int
) -> list[tuple[str, Claim, str, str]]:
    """Misprints: of each claim one of each kind that it can have, shuffled; `count` of them, 0 for all."""
    found = []
    for source, claim in claims:
        for kind in KINDS:
            forms = [latex for latex in changed_forms(claim, kind) if changed_claim(claim, latex) is not None]
            if forms:
                found.append((source, claim, kind, random.choice(forms)))
    random.shuffle(found)
    return found[:count] if count else found

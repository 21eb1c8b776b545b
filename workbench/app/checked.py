"""`workbench.check`: a verdict that displays itself in Jupyter and on a terminal."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from workbench import papers
from workbench.app.pipeline.judge_claims import judge_claims
from workbench.app.pipeline.verdict_keys import Memory
from workbench.context.circular_conditions import IS_THE_CONCLUSION, is_conclusion, with_definitions_beside
from workbench.context.claims import Ambiguity, ClaimContext
from workbench.context.facts import Act, Fact, Origin, Provider
from workbench.context.formula_acts import introduced, introduces
from workbench.context.free_symbols import free_in, terms_of
from workbench.context.index_values import orders_within
from workbench.context.read_formulas import read_statement, why_ill_formed
from workbench.core.code_labels import suffix
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import IllFormedAt, ReadError, SpecError
from workbench.core.terms import Conjunction, Statement
from workbench.core.verdict import Outcome, Strength, Verdict
from workbench.language.definitions import Definitions
from workbench.language.naming.symbols import SymbolTable
from workbench.language.reader import Range
from workbench.papers import Claim, Formula, Notation, Orders, Paper
from workbench.papers.installed_papers import installed_names
from workbench.papers.notation_tables import extended, with_definitions
from workbench.papers.selection import select_claims
from workbench.prover.results.claim_results import HOLDS, ClaimResult
from workbench.repair.propose.search_limits import STANDARD, Limits
from workbench.report.counterexamples import told
from workbench.report.mixed_prose import one_line
from workbench.report.shown_kinds import VERDICTS
from workbench.runtime import Budget
from workbench.runtime.store import Store, standard
from workbench.source.rewriting.formulas_in_models import with_rows
from workbench.source.rows.formula_lines import Line, conditions_without_words, split_lines, whole_line

if TYPE_CHECKING:
    from workbench.repair.propose.proposal import Repair


@dataclass(frozen=True, repr=False)
class Checked:
    """A formula and the verdict on it. `holds`, its truth value, is True if it is proved or a definition."""

    result: ClaimResult

    @property
    def latex(self) -> str:
        return self.result.claim.printed.latex

    @property
    def verdict(self) -> Verdict:
        return self.result.verdict

    @property
    def outcome(self) -> Outcome:
        return self.verdict.outcome

    @property
    def holds(self) -> bool:
        return self.outcome in HOLDS

    def __bool__(self) -> bool:
        return self.holds

    def repair(self, limits: Limits = STANDARD) -> Repair:
        """Returns the proved right forms of a refuted or ill-formed formula."""
        from workbench.repair.propose.proposal import Repair
        from workbench.repair.propose.repair import repair

        if self.outcome not in (Outcome.REFUTED, Outcome.ILL_FORMED):
            return Repair(self.result.claim, complete=True)
        return repair(self.result.claim, limits)

    def __str__(self) -> str:
        from workbench.app.commands.terminal import claim_lines

        return "\n".join(str(line) for line in claim_lines(self.result, with_expectation=False))

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        verdict = self.verdict
        parts = [f"$$ {one_line(self.latex)} $$", f"{VERDICTS[self.outcome].sign} **{self.outcome}**"]
        if verdict.scope:
            parts[-1] += f" ({verdict.scope})"
        if verdict.reason:
            parts.append(_as_text(f"{verdict.reason}{suffix(verdict.reason)}"))
        if verdict.hypothesis:
            parts.append(f"if {verdict.hypothesis.prose}")
        if verdict.read_back and one_line(verdict.read_back) != one_line(self.latex):
            parts.append(f"read as $ {verdict.read_back} $")
        if counterexample := verdict.counterexample:
            runs = told(counterexample, self.latex).sentence
            told_as = (f"${run.content}$" if run.is_math else _as_text(run.content) for run in runs)
            parts.append("counterexample: " + "".join(told_as))
        evidence = [f"- {_as_text(e.method)}: {_as_text(e.outcome)}" for e in verdict.evidence]
        return "\n\n".join([*parts, "\n".join(evidence)]).rstrip()


class CheckedLines(tuple[Checked, ...]):
    """The verdicts on the lines of a formula."""

    @property
    def holds(self) -> bool:
        return all(line.holds for line in self)

    def __bool__(self) -> bool:
        return self.holds

    def __str__(self) -> str:
        return "\n\n".join(map(str, self))

    __repr__ = __str__

    def _repr_markdown_(self) -> str:
        return "\n\n---\n\n".join(line._repr_markdown_() for line in self)


def check(
    latex: str,
    symbols: Mapping[str, str | Mapping[str, Any]] | None,
    paper: Paper | Path | str | None,
    assume: Sequence[str],
    orders: str | None,
    definitions: Mapping[str, str] | Sequence[str],
    notation: Path | str | None,
    at: str | None,
    budget: Budget | None,
) -> Checked | CheckedLines:
    """Returns the verdict on a formula: see `workbench.check`."""
    with standard(Memory) as memory:
        known = _defined(_notation(symbols, paper, notation, at, memory), definitions)
        claims = _claims(_texts("latex", latex), known, _texts("assume", assume), orders)
        results = [
            _with_what_stands_beside(result, budget, memory)
            for result in judge_claims(claims, budget=budget, memory=memory)
        ]
    checked = [Checked(result) for result in results]
    return checked[0] if len(checked) == 1 else CheckedLines(checked)


def _claims(
    latex: Sequence[str], known: Notation, conditions: Sequence[str], orders: str | None
) -> list[Claim]:
    """Returns one claim for each line; a line that defines a symbol defines it for the lines after it.

    If a line with a definition sign states something else of a symbol, the later lines cannot be refuted.
    """
    given = None if orders is None else Orders.parse(orders)
    lines = [line for text in latex for line in split_lines(text, with_premises=True)]
    claims: list[Claim] = []
    said: list[Fact] = []
    for number, line in enumerate(lines, start=1):
        formula, values = _formula(line, known, given)
        terms = [] if formula.statement is None else terms_of(formula.statement)
        names = {each.name for each in free_in(terms, known.definitions)}
        before = tuple(fact for fact in said if fact.about & names)
        if (definition := introduced(formula, known)) is not None:
            known = replace(known, definitions=Definitions([*known.definitions, definition]))
        elif names := introduces(formula, known):
            origin = Origin(Provider.FORMULA, formula.latex, f"line {number}")
            said.append(Fact(formula.statement, frozenset(names), origin, Strength.STATED, act=Act.DEFINE))
        defined = tuple(_formula(each, known, values, "condition")[0] for each in line.definitions)
        beside = tuple(_formula(premise, known, values, "condition")[0] for premise in line.premises)
        for condition in (*beside, *defined):
            if condition.ill_formed:
                raise ValueError(f"condition: {condition.latex}: {condition.ill_formed}")
        name = "check" if len(lines) == 1 else f"check.{number}"
        premises, defined = with_definitions_beside(beside, defined, formula)
        context = ClaimContext(facts=before, given=defined)
        claim = Claim(name, formula, known, premises, values, context=context)
        claims.append(with_assumptions(claim, conditions))
    return claims


def with_assumptions(claim: Claim, conditions: Sequence[str]) -> Claim:
    """Returns the claim under formulas that are assumed.

    Raises:
        ValueError: A condition cannot be read, does not fit, or is the claim itself.
    """
    lines = map(whole_line, conditions)
    supposed = [_formula(line, claim.notation, claim.orders, "assume")[0] for line in lines]
    claimed = claim.printed.statement
    for condition in supposed:
        if condition.ill_formed:
            raise ValueError(f"assume: {condition.latex}: {condition.ill_formed}")
        if claimed is None or condition.statement is None:
            continue
        if is_conclusion(condition.statement, claimed, claim.notation.definitions):
            raise ValueError(f"assume: {condition.latex}: {IS_THE_CONCLUSION}")
    return replace(claim, assume=(*supposed, *claim.assume))


def _with_what_stands_beside(result: ClaimResult, budget: Budget | None, memory: Memory) -> ClaimResult:
    """Returns the result; of A, \\quad C the one on A if C may be its condition, as in a text."""
    claim = result.claim
    if result.verdict.outcome is not Outcome.REFUTED or not isinstance(claim.printed.statement, Conjunction):
        return result
    if (parts := conditions_without_words(claim.printed.latex)) is None:
        return result
    formula, *beside = (_formula(part, claim.notation, claim.orders)[0] for part in (parts[0], *parts[1]))
    apart = replace(claim, printed=formula, ambiguity=Ambiguity(perhaps=tuple(beside)))
    (found,) = judge_claims([apart], budget=budget, memory=memory)
    is_beside = found.verdict.outcome in (Outcome.CONDITIONAL, Outcome.UNCHECKED)
    return replace(result, verdict=found.verdict) if is_beside else result


def _texts(name: str, given: str | Sequence[str]) -> tuple[str, ...]:
    """Returns one text or several as a tuple."""
    texts = (given,) if isinstance(given, str) else given
    if not isinstance(texts, list | tuple) or not all(isinstance(text, str) for text in texts):
        raise ValueError(f"{name}: expected LaTeX, got {given!r}")
    return tuple(texts)


def _notation(
    symbols: Mapping[str, str | Mapping[str, Any]] | None,
    paper: Paper | Path | str | None,
    notation: Path | str | None,
    at: str | None,
    store: Store,
) -> Notation:
    """Returns the notation of the file, of the paper or a claim of it, or an empty one, plus the symbols.

    `at` alone is a place in the installed paper "chapter".
    """
    if not isinstance(symbols, Mapping | None):
        raise ValueError(f'symbols: expected LaTeX → kind, such as {{"u": "vector"}}, got {symbols!r}')
    if notation is not None and (paper is not None or at is not None):
        raise ValueError("notation: give a notation file, or a paper and a place in it, not both")
    specs = {
        name: {"kind": spec} if isinstance(spec, str) else spec for name, spec in (symbols or {}).items()
    }
    if notation is not None:
        return extended(papers.load_notation(notation), specs)
    if paper is None and at is None:
        return extended(Notation(SymbolTable(), Definitions(), {}), specs)
    if isinstance(paper, str) and at is None and paper in installed_names() and not Path(paper).is_file():
        return extended(papers.installed_notation(paper, store=store), specs)
    paper = paper if isinstance(paper, Paper) else papers.find_paper(paper, store)
    return extended(paper.notation if at is None else _notation_at(paper, at), specs)


def _notation_at(paper: Paper, at: str) -> Notation:
    claims = select_claims(paper.claims, [at])
    if len({id(claim.notation) for claim in claims}) > 1:
        files = ", ".join(
            sorted({claim.source.file.name for claim in claims if claim.source.file is not None})
        )
        raise ValueError(f"at: {at!r} is in {files}, each with a notation of its own; name one claim")
    return claims[0].notation


def _defined(notation: Notation, definitions: Mapping[str, str] | Sequence[str]) -> Notation:
    """Returns the notation with the definitions, each checked with the earlier ones."""
    if isinstance(definitions, Mapping):
        entries = list(definitions.items())
        _texts("definitions", [text for entry in entries for text in entry])
    else:
        entries = [_sides(text) for text in _texts("definitions", definitions)]
    for name, body in entries:
        try:
            notation = with_definitions(notation, {name: body})
        except SpecError as error:
            raise ValueError(SyntaxCode.FAULT_OF_KEY(key="definitions", message=error.reason)) from None
        except (ReadError, IllFormedAt) as error:
            key = f"definitions: {name}"
            raise ValueError(SyntaxCode.FAULT_OF_KEY(key=key, message=error.reason)) from None
    return notation


def _sides(definition: str) -> tuple[str, str]:
    left, sign, right = definition.partition("=")
    if not sign:
        raise ValueError(f"definitions: expected a symbol, = and what it is, got {definition!r}")
    return left.removesuffix(":").strip(), right.strip()


def _formula(
    line: Line, notation: Notation, orders: Orders | None, what: str = ""
) -> tuple[Formula, Orders | None]:
    try:
        statement, ranges = _read(line.latex, notation, orders, as_condition=bool(what))
    except IllFormedAt as error:
        return Formula(line.latex, ill_formed=why_ill_formed(error)), orders
    except ReadError as error:
        message = SyntaxCode.FAULT_OF_KEY(key=what, message=error.message) if what else error.message
        raise ReadError(message, *line.place(error.line, error.column)) from None
    return Formula(line.latex, statement), orders_within(orders, ranges)


def _read(
    latex: str, notation: Notation, orders: Orders | None, as_condition: bool
) -> tuple[Statement, tuple[Range, ...]]:
    """Returns the statement of the formula, with rows in brackets as matrices if that can be read."""
    if (as_rows := with_rows(latex)) != latex:
        with suppress(ReadError):
            return read_statement(as_rows, notation, orders, as_condition)
    return read_statement(latex, notation, orders, as_condition)


def _as_text(text: str) -> str:
    """Returns text with Markdown's markup characters escaped."""
    return "".join("\\" + c if c in "\\`*_{}[]<>#|$" else c for c in text)

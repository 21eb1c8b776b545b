"""The paper of a text: one claim for each step of each display, with faults at their positions."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from workbench.context.circular_conditions import with_definitions_beside
from workbench.context.claim_parts import ClaimSource
from workbench.context.claims import Ambiguity, Claim, ClaimContext, Correction, Formula, Notation, Paper
from workbench.context.condition_facts import InlineFormulas, conditions_of, opaque, range_facts
from workbench.context.facts import Act, Duration, Fact, Origin, Provider
from workbench.context.formula_acts import act_of, declared_anew
from workbench.context.formula_facts import with_acts, with_formula_facts, with_laws, with_moving
from workbench.context.free_symbols import names_in, terms_of
from workbench.context.index_values import Orders
from workbench.context.read_formulas import WORDS, FormulaReader, read_statement
from workbench.context.sentence_facts import TextSentences
from workbench.context.stated_bounds import with_signs_of_functions
from workbench.context.stated_rotations import is_plural, stated_rotation
from workbench.context.unread_facts import Unread, said_unread, unread_facts
from workbench.core.codes.syntax_codes import SyntaxCode
from workbench.core.formula_errors import IllFormedAt, ReadError
from workbench.core.names import Name
from workbench.core.paper_errors import NoDisplay, PaperError
from workbench.core.terms import Apply, Statement, Symbol
from workbench.core.verdict import Strength
from workbench.papers.corrections import mend_of
from workbench.papers.texts.functions_in_sentences import asked_if_function, functions_in
from workbench.papers.texts.model_assignments import Placed, assigned, means, unknown_ids
from workbench.papers.texts.step_formulas import (
    assumed_formulas,
    printed_formula,
    reasons_of,
    side_formula,
    span_of,
    unreadable,
)
from workbench.papers.texts.text_model import Entry, Table, TextModel, with_entries
from workbench.source.documents import Display, Text, Token
from workbench.source.rows.chains import Step, steps_of
from workbench.source.toml.toml_file import TomlFile

_ADJUGATE = re.compile(r"adjugate|classical adjoint|cofactor|\\\\adj", re.IGNORECASE)
_STAR = "^* as the adjugate, of which the text does not speak ([notation] can say what it is)"
_NO_ID = re.compile(r"[^\w.+*'-]+")


@dataclass(frozen=True)
class TextPaper(Paper):
    """A paper that was read from a text.

    Attributes:
        warnings: Parts that could not be read as TeX would read them.
        keyed: The ids of the claims of which the model says something.
        model_text: The content of the model, if it is a file.
    """

    text: Text | None = None
    warnings: tuple[PaperError, ...] = ()
    keyed: frozenset[str] = frozenset()
    model_text: str | None = None


def text_paper(
    text: Text,
    model: TextModel,
    title: str,
    doi: str | None,
    paths: tuple[Path, ...],
    citation: Mapping[str, str] | None = None,
) -> TextPaper:
    """Returns the paper of a text. Raises PaperError if the notation cannot be used; other faults are
    collected in `faults`."""
    notations, faults = model.notations(), model.faults
    spoilt = any(_spoils(fault, model.chain) for fault in faults)
    placed = list(placed_steps(text.displays, notations))
    if not placed:
        raise NoDisplay(text.path)
    entries = assigned(model, placed, text.displays)
    claims = [_usable_claim(each, entries.get(each.id, ()), model) for each in placed]
    claims = [
        model.faults.whole(
            with_entries(partial(_with_given, claim, placed[: at + 1]), entries.get(claim.id, ()))
        )
        or _unusable(claim)
        for at, claim in enumerate(claims)
    ]
    if any(fault.path[:1] == ("scope",) for fault in faults):  # the notation of any display is uncertain
        claims = [claim.with_context(guessed=(*claim.context.guessed, "[[scope]]")) for claim in claims]
    functions = functions_in(text)
    claims = [asked_if_function(claim, functions) for claim in claims]
    for fault in unknown_ids(entries, {claim.id for claim in claims}):
        faults.tell(fault)
    if spoilt:
        faults.stop()
    return TextPaper(
        title,
        doi,
        paths,
        notations[0][1],
        tuple(_with_facts(claims, placed, text)),
        citation=citation or {},
        text=text,
        faults=tuple(faults),
        warnings=tuple(text.warnings),
        keyed=frozenset(entries),
    )


def _with_given(claim: Claim, placed: Sequence[Placed], entries: Sequence[Entry]) -> Claim:
    """Returns the claim with the earlier formulas that it should follow from, read in its notation.

    placed: ends with the claim's own step. Raises PaperError.
    """
    given: list[Formula] = []
    tables = [entry.table for entry in entries]
    for table in tables:
        for at in table.texts(("given",)):
            found = [each for each in placed[:-1] if means(at, each)]
            if not found:
                raise table.error_at_value(("given",), f"given: no formula {at!r} before {claim.id}")
            for latex in (each.step.spelled()[0] for each in found):
                try:
                    statement, _ = read_statement(latex, claim.notation, claim.orders, as_condition=True)
                    _refuse_other_meaning(table, at, statement, found[0].notation, claim.notation)
                    given.append(Formula(latex, statement))
                except (ReadError, IllFormedAt) as error:
                    raise table.error_at_value(("given",), f"given: {at}: {error.message}") from None
    says_none = any(table.value(("given",), list, None) == [] for table in tables)
    return claim.with_context(given=(*claim.context.given, *given), alone=says_none and not given)


def _refuse_other_meaning(
    table: Table, at: str, statement: Statement, there: Notation, here: Notation
) -> None:
    """Raises PaperError for a formula with a symbol that a later scope redeclares."""
    if (name := declared_anew(names_in(statement), there, here)) is not None:
        message = f"given: {at!r} speaks of another {name}: a [[scope]] behind it declares {name} anew"
        raise table.error_at_value(("given",), f"{message}; expected a formula of this scope")


def _with_facts(claims: Sequence[Claim], placed: Sequence[Placed], text: Text) -> Iterator[Claim]:
    """Yields the claims with the facts of the text; none for a claim with a closed context."""
    claims = with_own_facts(with_moving(claims), placed, text)
    for claim in with_facts_of_formulas(claims, [each.display for each in placed]):
        yield claim.with_context(act=(Act.ASSERT, None), facts=()) if claim.context.alone else claim


def with_own_facts(claims: Sequence[Claim], placed: Sequence[Placed], text: Text) -> list[Claim]:
    """Returns the claims with what sentences and conditions say of them; `with_moving` comes before."""
    unread = said_unread(claims, text.inline)
    spoken = InlineFormulas(text.inline)
    sentences = TextSentences(text.inline, spoken, placed[0].notation)
    return [
        claim.with_context(
            facts=tuple(dict.fromkeys((*claim.context.facts, *own))),
            properties=_properties(claim, each),
        )
        for claim, each in zip(claims, placed, strict=True)
        for own in [_own_facts(claim, each, text, unread, sentences, spoken)]
    ]


def with_facts_of_formulas(claims: Sequence[Claim], displays: Sequence[Display]) -> list[Claim]:
    """Returns the claims of a text in its order with what its other formulas say of them. displays: where
    each claim stands."""
    return with_laws(with_formula_facts(with_acts(claims), displays))


def _own_facts(
    claim: Claim,
    placed: Placed,
    text: Text,
    unread: Mapping[str, list[Unread]],
    sentences: TextSentences,
    spoken: InlineFormulas,
) -> Iterator[Fact]:
    """Yields facts from conditions next to the formula, its sentence, earlier sentences, and unread
    formulas."""
    statement, names = claim.printed.statement, _names_of(claim.printed)
    if statement is None or not names:
        return
    for words in placed.step.limits:
        yield opaque(words, claim.line, names)
    conditions = list(conditions_of(placed.display, statement, placed.notation, spoken))
    if placed.step.ranges and claim.printed.latex != placed.step.spelled()[0]:
        conditions = [*range_facts(placed.step, placed.notation, names), *conditions]
    conditions = with_signs_of_functions(conditions, statement, placed.notation)
    yield from conditions
    yield from sentences.facts(placed.display, statement, placed.notation)
    read = {_words(fact) for fact in conditions if fact.content and fact.duration is Duration.ALWAYS}
    yield from (fact for fact in unread_facts(claim, unread) if _words(fact) not in read)
    has_adjugate = any(isinstance(term, Apply) and term.head == "adjugate" for term in terms_of(statement))
    if has_adjugate and not any(_ADJUGATE.search(source.text) for source in text.sources):
        yield Fact(None, names, Origin(Provider.CONVENTION, _STAR), Strength.HINTED)


def _words(fact: Fact) -> tuple[str, str]:
    return "".join(fact.origin.text.split()), fact.origin.place


def _properties(claim: Claim, placed: Placed) -> tuple[tuple[str, str], ...]:
    """Returns the properties that the sentence before a display states of the symbol alone on its left.

    A sentence says what the first formula of its display gives, or in the plural what each one gives.
    """
    statement = claim.printed.statement
    words = None if statement is None else stated_rotation(placed.display, statement)
    is_told = words is not None and (placed.is_first or is_plural(words))
    return (("rotation", words),) if words is not None and is_told else ()


def _names_of(formula: Formula) -> frozenset[Name]:
    return frozenset() if formula.statement is None else frozenset(names_in(formula.statement))


def placed_steps(
    displays: Sequence[Display], notations: Sequence[tuple[int, Notation]], taken: Collection[str] = ()
) -> Iterator[Placed]:
    """Yields the steps of the displays. notations: each with the index of the display from which on it holds.
    taken: ids of other claims."""
    taken = {*taken}
    for index, display in enumerate(displays):
        notation = [known for start, known in notations if start <= index][-1]
        lines = steps_of(display, notation.words)
        bases = [_base(display, step) for line in lines for step in line]
        numbering: dict[str, int] = {}
        for line in lines:
            before: list[str] = []
            for step in line:
                base = _base(display, step)
                numbering[base] = numbering.get(base, 0) + 1
                name = f"{base}.{numbering[base]}" if bases.count(base) > 1 else base
                while name in taken:
                    name += "'"
                taken.add(name)
                yield Placed(name, display, step, notation, tuple(before), line is lines[0])
                before.append(name)


def _own_label(display: Display, step: Step) -> str | None:
    """Returns the label of the row in which the step ends; that of the display, if it has no numbers and so
    is one equation."""
    return next(iter(step.labels if display.numbers else display.labels), None)


def _base(display: Display, step: Step) -> str:
    """Returns the label, the number or the line."""
    name = next(iter(step.labels), None) or step.number or next(iter(display.labels), None)
    cleaned = _NO_ID.sub("-", name or "").strip("-")[:60]
    return cleaned or f"L{display.line}"


def _spoils(fault: PaperError, chain: Sequence[TomlFile]) -> bool:
    """True if no formula may be judged, because the notation is not what the author meant."""
    return fault.toml in chain and fault.path[:1] != ("claim",) and fault.path[2:] != ("from",)


def _usable_claim(placed: Placed, entries: Sequence[Entry], model: TextModel) -> Claim:
    claim = model.faults.whole(with_entries(partial(claim_of, placed, guessed=model.guessed), entries))
    if claim is not None:
        return claim
    return _unusable(claim_of(placed, (), model.guessed))


def _unusable(claim: Claim) -> Claim:
    why = SyntaxCode.MODEL_UNUSABLE()
    return replace(claim, printed=replace(claim.printed, statement=None, ill_formed=None, unread=why))


def claim_of(placed: Placed, entries: Sequence[Entry], guessed: Sequence[str]) -> Claim:
    """Returns the claim. Raises PaperError for a key of the model that cannot be used."""
    tables = [entry.table for entry in entries]
    display, step = placed.display, placed.step
    orders = _orders(tables)
    has_reading = any(table.text(("reading",)) for table in tables)
    printed, within = printed_formula(placed, orders, has_reading)
    assume, printed = assumed_formulas(placed, printed)
    reasons, unread_reasons = reasons_of(placed, _names_of(printed))
    assume, defined = with_definitions_beside([*assume, *reasons], _definitions_beside(placed), printed)
    span = span_of(step.own, display)
    claim = Claim(
        placed.id,
        printed,
        placed.notation,
        assume=assume,
        orders=within,
        source=ClaimSource(
            equation=step.number,
            section=f"{display.section} {display.heading}".strip() or None,
            file=display.source.path,
            line=span.line,
            label=_own_label(display, step),
        ),
        context=ClaimContext(
            span=span,
            given=defined,
            beside=defined,
            explains=step.explains,
            act=act_of(printed, placed.notation),
            guessed=_used(printed, step.tokens, guessed),
            facts=unread_reasons,
        ),
        ambiguity=Ambiguity(
            perhaps=tuple(side_formula(tokens, placed) for tokens in step.perhaps),
            serves=tuple(side_formula(tokens, placed) for tokens in step.serves),
            otherwise=tuple(side_formula(tokens, placed) for tokens in step.otherwise),
            question=step.question,
        ),
        chain=placed.chain,
    )
    for table in tables:
        claim = _with_keys(claim, table)
    return claim


def _definitions_beside(placed: Placed) -> list[Formula]:
    """Returns the equations by which words beside the formula define its symbols."""
    formulas = (side_formula(tokens, placed) for tokens in placed.step.defined)
    return [formula for formula in formulas if formula.statement is not None]


def _with_keys(claim: Claim, table: Table) -> Claim:
    """The claim with what the keys of one table of the model say of it."""
    reader = FormulaReader(table, (), claim.notation, claim.orders)
    printed, before = claim.printed, claim.correction
    reading, corrected = reader.intended("reading"), reader.intended("corrected")
    hypothesis = _hypothesis(table, reader, printed)
    assume = reader.conditions(printed)
    notes = {key: table.text((key,)) for key in ("skip", "unread", "note")}
    mend = mend_of(table, (), printed.latex)
    inherits = table.texts(("inherits",))
    if reading is not None and printed.unread is not None:
        printed = replace(printed, unread=None, ill_formed=unreadable(printed.unread))
    return replace(
        claim,
        printed=printed,
        correction=Correction(
            reading or before.reading, corrected or before.corrected, hypothesis or before.hypothesis
        ),
        assume=(*claim.assume, *assume),
        skip=notes["skip"] or claim.skip,
        unread=notes["unread"] or claim.unread,
        source=replace(claim.source, note=notes["note"] or claim.source.note),
        mend=claim.mend if mend.fault is None else mend,
        inherits=inherits or claim.inherits,
    )


def _hypothesis(table: Table, reader: FormulaReader, printed: Formula) -> Formula | None:
    """What the model supposes that the text does not: a formula, or words."""
    text = table.text(("hypothesis",))
    if text is not None and WORDS.fullmatch(text):
        return Formula(text)
    return reader.hypothesis(printed)


def _used(printed: Formula, tokens: Sequence[Token], guessed: Sequence[str]) -> tuple[str, ...]:
    """Returns the guessed names that the formula uses, and guessed tables such as [notation].

    Returns all if the formula is ill-formed.
    """
    if printed.statement is None or not guessed:
        return tuple(guessed)
    used = {str(term.declaration.name) for term in terms_of(printed.statement) if isinstance(term, Symbol)}
    used |= {f"\\{call.name}" for token in tokens if token.call for call in token.call.chain()}
    return tuple(name for name in guessed if name in used or name.startswith("["))


def _orders(tables: Sequence) -> Orders | None:
    for table in tables:
        if (text := table.text(("orders",))) is not None:
            try:
                return Orders.parse(text)
            except ValueError as error:
                raise table.error_at_value(("orders",), str(error)) from None
    return None

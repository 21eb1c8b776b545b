"""Doubts about refuted equations of a text without a model: they may say what their symbols are, or use
them for other values."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace

from workbench.context.claims import Claim, Notation
from workbench.context.facts import Provider
from workbench.context.formula_acts import subject_of
from workbench.context.formula_subject import derived
from workbench.context.free_symbols import free_in, names_in, terms_of
from workbench.context.repeated_laws import definitions_in, laws_in, rate_in
from workbench.core.codes.doubt_codes import DoubtCode
from workbench.core.codes.type_codes import Compared, TypeCode
from workbench.core.construct import relation
from workbench.core.reasons import Reason
from workbench.core.terms import Derivative, IllFormed, Number, Power, Relation, Symbol, Term, sides_of
from workbench.core.types import PI, Declaration
from workbench.core.verdict import Outcome, Verdict
from workbench.language.definitions import Definitions, expand
from workbench.language.printing.printer import to_latex
from workbench.papers.drafting.drafted_definitions import gives_dimension
from workbench.papers.drafting.drafted_texts import Draft
from workbench.papers.drafting.inference.infer import TypeMismatch
from workbench.papers.drafting.inference.priors import MAP_OF_TWISTS
from workbench.papers.drafting.meanings.informing_equations import doubled
from workbench.papers.drafting.typefaces import Guess
from workbench.prover.decide.decide import Judge
from workbench.prover.explain.decide_under_facts import Decider

#: Numbers from here on, and decimal fractions, are values of examples.
_FIGURE = 10
#: The letters of the imaginary unit.
_IMAGINARY = re.compile(
    r"(?:\\(?:mathrm|mathsf|mathit|operatorname|text)\s*\{\s*[ij]\s*\}|[ij]|\\[ij]math|\\iota)"
)
#: The letters of instants, beside numbers.
_TIMES = frozenset({"t", "T", r"\tau"})
#: Letters that together are those of axes, or of the units of quaternions.
_AXES = {"i", "j", "k"}
#: The marks of vectors, matrices and their operations.
_MARKS = re.compile(r"\\(?:mathbf|boldsymbol|bm|vec|hat|times|cdot|nabla|begin)(?![a-zA-Z])")
#: A bold 1 before a bracket: the unit step rather than the unit tensor.
_STEP = re.compile(r"\\math(?:bf|bb|rm)\s*\{?\s*1\s*\}?\s*\(")
#: The name of a function in plain letters, as RMS(x) and Var[x].
_NAMES = re.compile(r"(?<![\\a-zA-Z])(?:[A-Z]{3,}|[A-Z][a-z]{2,})(?=\s*(?:\\left\s*)?[(\[])")
_NO_POWER = re.compile(r"\^\s*(?:0|\{\s*0\s*\})")
#: A matrix of zeros, each of which may be a block.
_ZEROS = re.compile(r"\\begin\{([bp]?matrix)\}[\s0\\&]*\\end\{\1\}")
#: The most displays of a text whose misfits are errors rather than a notation that the draft misreads.
_MOST_MISFITS = 3


#: Faults → the operations of which they tell; no entry: of any.
_OPERATIONS: Mapping[object, frozenset[str]] = {
    **dict.fromkeys((TypeCode.FUNCTION_ARGUMENT_TYPE, TypeCode.FUNCTION_ARGUMENT_COUNT), frozenset()),
    TypeCode.TRANSPOSE: frozenset(("transpose",)),
    Compared.SIDES: frozenset(("equal",)),
    Compared.ADDENDS: frozenset(("add",)),
}


def may_say_what_symbols_are(claim: Claim) -> bool:
    """True if an equation gives a sequence, or has no free symbol on both sides and is true for some values.

    An identity relates what stands on both sides; F + G = 0 and AᵀP + PA = -1 rather state a law or a
    condition of the text, and x_n = x_{n-1} + v_n Δt says how x proceeds. F/m = 200/1500 is an example. If no
    value of a single symbol without properties suits, as in i² = -1, the symbol is of another kind than the
    drafted one. [x] = L/T gives the dimension of a number x.
    """
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or statement.operator != "=":
        return False
    if _is_recurrence(statement) or (
        statement.left.type.kind == "scalar" and gives_dimension(claim.printed.latex)
    ):
        return True
    said = definitions_in(claim.context.facts, claim.notation.definitions)
    subject = replace(subject_of(claim, said), laws=laws_in(claim.context.facts))
    left, right = (subject.free_in(side) - {PI} for side in (statement.left, statement.right))
    if not (left or right) or not left.isdisjoint(right):
        return False
    if (_is_figure(statement.left) or _is_figure(statement.right)) and not _is_impossible(claim):
        return True
    if _is_ruled(claim, statement):
        return False
    written = {term.declaration for term in terms_of(statement) if isinstance(term, Symbol)}
    return _is_about_one((left | right) & written) or not _is_impossible(claim)


def _is_impossible(claim: Claim) -> bool:
    return Decider(claim, judge_of, True).is_impossible(())


def _is_figure(term: Term) -> bool:
    """True if the term consists of numbers, and one of them is none that an identity has."""
    parts = list(term.walk())
    numbers = [part.value for part in parts if isinstance(part, Number)]
    has_symbol = any(isinstance(part, Symbol) for part in parts)
    return not has_symbol and any(abs(n) >= _FIGURE or n.denominator >= _FIGURE for n in numbers)


def _is_ruled(claim: Claim, statement: Relation) -> bool:
    """True if the text says what the symbols are: a condition of the claim, or a lower rate of a side."""
    facts = claim.context.facts
    laws = [(each.origin.provider, each.content) for each in facts if isinstance(each.content, Relation)]
    names = set(names_in(statement))
    if any(provider is Provider.CONDITION and names & set(names_in(law)) for provider, law in laws):
        return True
    for own, order in map(derived, (statement.left, statement.right)):
        rates = (rate_in(law, own) for _, law in laws if own is not None)
        if any(rate is not None and 0 < rate[0] < order for rate in rates):
            return True
    return False


def _is_about_one(symbols: Collection[Declaration]) -> bool:
    """True for one symbol that may have any value of its kind."""
    return len(symbols) == 1 and not any(
        each.rotation or each.transform or each.unit or each.symmetric for each in symbols
    )


def _is_recurrence(statement: Relation) -> bool:
    """True if the left side is a member of a family, or its rate, and the right side has another member."""
    left = statement.left.body if isinstance(statement.left, Derivative) else statement.left
    if not isinstance(left, Symbol) or not left.index:
        return False
    members = {part for part in statement.right.symbols() if part.index}
    return any(each.declaration == left.declaration and each.index != left.index for each in members)


def subject_alone(claim: Claim) -> Symbol | None:
    """Returns the symbol of which an equation gives the value or a power: it is alone on the left."""
    match claim.printed.statement:
        case (
            Relation(operator="=", left=Symbol() as own)
            | Relation(operator="=", left=Power(base=Symbol() as own))
        ):
            return own
    return None


def other_meanings(claim: Claim, known: Definitions, guesses: Mapping[str, Guess]) -> Iterator[Reason]:
    """Yields the doubts.

    The imaginary unit is no number that a symbol of a draft can be. A dot over f in f(0) is rather the rate
    of f at 0 than that of a number. y = v²/2g may be the greatest y of y = v t - g t²/2, as it lacks t, and
    y = 12 may be that of an example.
    """
    statement, own = claim.printed.statement, subject_alone(claim)
    sides = sides_of(statement) if isinstance(statement, Relation) else ()
    for each in sorted(free_in(sides, known), key=lambda each: str(each.name)):
        guess = guesses.get(str(each.name))
        if guess is not None and _is_imaginary(guess, guesses):
            yield DoubtCode.IMAGINARY_UNIT(name=guess.name)
    for term in terms_of(statement) if isinstance(statement, Relation) else ():
        if isinstance(term, Derivative) and isinstance(term.body, Symbol) and term.body.arguments:
            inside = [part.declaration for each in term.body.arguments for part in each.symbols()]
            if all(each.name.letter in _TIMES and not each.clock for each in inside):
                yield DoubtCode.RATE_AT_PLACE(term=to_latex(term.body))
    if own is None or own.arguments or not isinstance(statement, Relation):
        return
    given = free_in([statement.right], known)
    if not given - {PI}:
        yield DoubtCode.VALUE_IN_EXAMPLE(symbol=to_latex(own))
        return
    lost = free_in([own], known) - given if own.type.kind == "scalar" else set()
    for each in sorted(lost, key=lambda each: str(each.name)):
        if _varies(claim, own, each, known):
            yield DoubtCode.VALUE_AT_ONE(symbol=to_latex(own), name=each.name)
            return


def _is_imaginary(guess: Guess, guesses: Collection[str]) -> bool:
    """True for the letter of the imaginary unit, unless it is an index elsewhere, or an axis."""
    if guess.is_said or not _IMAGINARY.fullmatch(guess.name) or {*guesses} >= _AXES:
        return False
    return not any(
        re.search(rf"_(?:\{{[^{{}}]*)?{re.escape(guess.name)}(?![a-zA-Z])", each) for each in guesses
    )


def _varies(claim: Claim, own: Symbol, lost: Declaration, known: Definitions) -> bool:
    """True unless it is proved that the value of a symbol does not depend on another number."""
    if lost.type.kind != "scalar" or lost.indices or lost.parameters:
        return False
    with suppress(IllFormed):
        body = expand(own, known)
        same = relation("=", body, doubled(body, lost))
        return Decider(claim, judge_of, True).decide((), same).outcome is not Outcome.PROVED
    return True


def judge_of(notation: Notation) -> Judge:
    return Judge(notation.definitions, bound=frozenset(each.declaration.name for each in notation.motion))


def is_told(verdict: Verdict, misfit: TypeMismatch) -> bool:
    """True if the fault of a verdict may be that operation, and not one that guessed signatures add."""
    if verdict.code is None or verdict.reason is None:
        return True
    arguments = getattr(verdict.reason, "arguments", {})
    told = arguments.get("what", "") if "what" in arguments else verdict.code
    return misfit.operation in _OPERATIONS.get(told, frozenset((misfit.operation,)))


def is_open_misfit(misfit: TypeMismatch) -> bool:
    """True if the operation may fit: it gives a letter entries, as those of another case, or has a word whose
    values the draft can only guess, as vech(A)."""
    if misfit.gives_entries:
        return True
    words = [name for name in misfit.names if name.startswith(r"\operatorname")]
    return not all(map(MAP_OF_TWISTS.match, words))


def misread(draft: Draft, latex: str) -> Iterator[Reason]:
    """Yields why a formula that does not fit the drafted kinds may be misread."""
    if _STEP.search(latex):
        yield DoubtCode.UNIT_STEP()
    if (word := _NAMES.search(latex)) is not None:
        yield DoubtCode.NAME_OF_FUNCTION(word=word[0])
    if _NO_POWER.search(latex):
        yield DoubtCode.LABEL_OF_FRAME()
    if _ZEROS.search(latex):
        yield DoubtCode.BLOCK_OF_ZEROS()
    own = [each for each in draft.ingested.inference.misfits if each.latex == latex]
    if any(each.has_blocks for each in own):
        yield DoubtCode.SIZES_OF_BLOCKS()
    if _are_magnitudes(draft, own, latex):
        yield DoubtCode.MAGNITUDES()
    if (count := _misfit_displays(draft)) > _MOST_MISFITS:
        yield DoubtCode.NOTATION_MISREAD(count=count)


def _are_magnitudes(draft: Draft, own: Sequence[TypeMismatch], latex: str) -> bool:
    """True if plain letters without an operation of vectors are why the sides of a formula differ."""
    kinds = {each.kind for name, each in draft.ingested.guesses.items() if any(name in m.names for m in own)}
    is_sum = all(each.operation in ("equal", "add") for each in own)
    return is_sum and kinds == {"scalar", "vector"} and not _MARKS.search(latex)


def _misfit_displays(draft: Draft) -> int:
    misfits = (each for each in draft.ingested.inference.misfits if not is_open_misfit(each))
    return len({each.latex for each in misfits} & {each.latex for each in draft.ingested.formulas})

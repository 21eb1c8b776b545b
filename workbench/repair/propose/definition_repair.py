"""Repair of definitions: one change of a shared definition may correct several false claims at once.

Coefficients: a claim that is linear in the symbols is an equation for the coefficients of their bodies. Each
addend of a body contributes the value of the claim's side with the body reduced to that addend.
Edits: one edit of a body, also of a recurrence, is tried at random points modulo the prime on all claims that
depend on it.
A claim counts as corrected only if it is proved under the change. Other claims are repaired under it too,
because the definition may have hidden a misprint of their own.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache
from time import monotonic

from workbench.context.claims import Claim
from workbench.core.construct import relation, symbol, zero
from workbench.core.names import Name
from workbench.core.terms import Apply, Definition, IllFormed, Relation, Statement, Symbol, Term, sides_of
from workbench.core.verdict import Outcome
from workbench.engines.inventory import NotExact
from workbench.engines.jet.rings import PRIME
from workbench.language.definitions import Definitions
from workbench.language.printing.author_spelling import printed_for
from workbench.language.printing.printer import to_latex
from workbench.prover.decide.decide import Judge
from workbench.repair.propose.candidate_judge import judging
from workbench.repair.propose.repair import repair
from workbench.repair.propose.search_limits import Limits
from workbench.repair.screening.screen import Screen
from workbench.repair.terms.coefficients import Vector, fewest_changes
from workbench.repair.terms.edit_search import cost
from workbench.repair.terms.subterm_positions import places, subterm
from workbench.repair.terms.term_arithmetic import sum_of, times
from workbench.repair.terms.term_edits import Refused, edits
from workbench.runtime import OutOfBudget

_POINTS = 6

#: Limits for the repair of one claim under changed definitions.
_SECOND = Limits(seconds=10.0, candidates=20_000, proposals=1)


@dataclass(frozen=True)
class Redefinition:
    """A change of definitions: other bodies for symbols without arguments."""

    bodies: Mapping[Symbol, Term]

    def of(self, definitions: Definitions) -> Definitions:
        """Returns the changed definitions; a member of a family defined for all n gets a definition of its
        own."""
        bodies = {(s.declaration.name, s.index): (s, body) for s, body in self.bodies.items()}
        changed = []
        for definition in definitions:
            key = definition.declaration.name, definition.index
            changed.append(replace(definition, body=bodies.pop(key)[1]) if key in bodies else definition)
        added = [Definition(s.declaration, s.index, (), body) for s, body in bodies.values()]
        return Definitions((*changed, *added))

    def concerns(self, claim: Claim) -> bool:
        names = _names_below(claim)
        return any(s.declaration.name in names for s in self.bodies)


@dataclass(frozen=True)
class DefinitionRepair:
    """A change of definitions that corrects claims.

    Attributes:
        changed: (symbol, printed body, proposed body) as LaTeX.
        mended: Ids of the false claims that are proved under the change.
        with_edits: (id, edit, LaTeX) of the claims that one more change corrects.
    """

    changed: tuple[tuple[str, str, str], ...]
    mended: tuple[str, ...]
    with_edits: tuple[tuple[str, str, str], ...] = ()

    @property
    def edit(self) -> str:
        parts = [f"${name} = {new}$ instead of ${old}$" for name, old, new in self.changed]
        said = f"{' and '.join(parts)} mends {', '.join(self.mended)}"
        more = [f"{name} if {edit}" for name, edit, _ in self.with_edits]
        return said + "".join(f"; and {text}" for text in more)


def repair_definitions(
    claims: Sequence[Claim], least: int = 2, seconds: float = 60.0
) -> list[DefinitionRepair]:
    """Returns changes of definitions that correct at least `least` false claims, the most effective first.

    At least one claim is corrected without a further change in the claim itself. A claim that can be
    corrected by itself counts only if the change corrects at least `least` claims without further changes.

    seconds: the time limit of the search.
    """
    end = monotonic() + seconds
    claims = [claim for claim in claims if not _holds(claim, claim.notation.definitions)]
    mended_alone = cache(lambda place: bool(repair(claims[place], _SECOND).proposals))
    found: dict[tuple, DefinitionRepair] = {}
    for change, changed in (*_other_coefficients(claims), *_edited(claims, least, end)):
        if changed in found:
            continue
        concerned = [place for place, claim in enumerate(claims) if change.concerns(claim)]
        mended = [p for p in concerned if _holds(claims[p], change.of(claims[p].notation.definitions))]
        if not mended or (len(mended) < least and any(map(mended_alone, mended))):
            continue
        others = [place for place in concerned if place not in mended and not mended_alone(place)]
        with_edits = [entry for p in others if (entry := _with_edit(claims[p], change)) is not None]
        if len(mended) + len(with_edits) >= least:
            ids = tuple(claims[place].id for place in mended)
            found[changed] = DefinitionRepair(changed, ids, tuple(with_edits))
    return sorted(found.values(), key=lambda repair: (-len(repair.mended), -len(repair.with_edits)))


def _with_edit(claim: Claim, change: Redefinition) -> tuple[str, str, str] | None:
    """Returns the claim with one change that makes it true under the changed definitions; None if there is
    none."""
    judge = Judge(change.of(claim.notation.definitions))
    for proposal in repair(claim, _SECOND, judge=judge).proposals:
        if len(proposal.changes) == 1:
            return claim.id, proposal.edit, proposal.latex
    return None


def _edited(claims: Sequence[Claim], least: int, end: float) -> Iterator[tuple[Redefinition, tuple]]:
    """Yields edits of one definition under which at least `least` claims hold at random points."""
    resting = {claim.id: _names_below(claim) for claim in claims}
    counts = Counter(name for names in resting.values() for name in names)
    definitions = {(d.declaration.name, d.index): d for claim in claims for d in claim.notation.definitions}
    for key, definition in definitions.items():
        dependents = [claim for claim in claims if key[0] in resting[claim.id]]
        if counts[key[0]] < least or definition.parameters:
            continue
        name = symbol(definition.declaration, definition.index)
        for body in _near_bodies(name, definition):
            if monotonic() > end:
                return
            change = Redefinition({name: body})
            if sum(_holds_at_points(claim, change) for claim in dependents) >= least:
                yield change, (_in_words(dependents[0], name, definition.body, body),)


def _in_words(claim: Claim, *terms: Term) -> tuple[str, ...]:
    with printed_for(claim.notation.author_notation):
        return tuple(map(to_latex, terms))


def _near_bodies(name: Symbol, definition: Definition) -> Iterator[Term]:
    """Yields bodies with one edit that depend on no further symbols."""
    try:
        printed = relation("=", name, definition.body)
    except IllFormed:
        return
    before = _rests_on(definition.body, name)
    for edit in sorted(edits(printed, within=(1,)), key=cost):
        right = None if isinstance(edit, Refused) else subterm(edit.statement, (1,))
        if right is not None and _rests_on(right, name) <= before:
            yield right


def _rests_on(body: Term, name: Symbol) -> set[tuple]:
    """Returns the names in a body; those of its own family with their indices."""
    family = name.declaration.name
    symbols = list(body.symbols())
    return {(s.declaration.name, s.index if s.declaration.name == family else ()) for s in symbols}


def _names_below(claim: Claim) -> set[Name]:
    """Returns the names of the symbols that the claim depends on, through all definitions."""
    statement = claim.printed.statement
    below = () if statement is None else claim.notation.definitions.symbols_in(*sides_of(statement))
    return {symbol.declaration.name for symbol in below}


def _holds_at_points(claim: Claim, change: Redefinition) -> bool:
    statement = claim.printed.statement
    if statement is None:
        return False
    try:
        definitions = change.of(claim.notation.definitions)
        screen = Screen(definitions, claim.supposed, claim.instances[-2:])
        residual = screen.residual(statement)
    except (NotExact, IllFormed):
        return False
    return residual is not None and not any(residual)


def _holds(claim: Claim, definitions: Definitions) -> bool:
    if claim.printed.statement is None:
        return False
    judge = Judge(definitions)
    with judging(claim, judge) as aside, suppress(OutOfBudget):
        verdict = aside.call(claim.printed.statement)
        return verdict is not None and verdict.outcome == Outcome.PROVED
    return False


def _other_coefficients(claims: Sequence[Claim]) -> Iterator[tuple[Redefinition, tuple]]:
    for claim in claims:
        for bodies in _solutions(claim):
            changed = []
            for s, body in bodies.items():
                before = claim.notation.definitions.lookup(s)
                assert before is not None, f"{s} has no definition"
                changed.append(_in_words(claim, s, before, body))
            yield Redefinition(bodies), tuple(changed)


def _solutions(claim: Claim) -> Iterator[dict[Symbol, Term]]:
    """Yields bodies of the claim's defined symbols with other coefficients, under which it holds at random
    points."""
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or claim.orders or statement.operator != "=":
        return
    definitions = claim.notation.definitions
    symbols = list(dict.fromkeys(t for _, t in places(statement) if isinstance(t, Symbol)))
    sums: dict[Symbol, tuple[Term, ...]] = {}
    for s in symbols:
        match None if s.arguments else definitions.lookup(s):
            case Apply(head="add", arguments=addends):
                sums[s] = addends
    if not sums:
        return
    nothing = {s: zero(s.type) for s in sums}
    start = _residual(claim, statement, Redefinition(nothing))
    if start is None:
        return
    parts = [(s, addend) for s, addends in sums.items() for addend in addends]
    columns = []
    for s, addend in parts:
        residual = _residual(claim, statement, Redefinition({**nothing, s: addend}))
        if residual is None:
            return
        columns.append(tuple((x - y) % PRIME for x, y in zip(residual, start, strict=True)))
    for factors in fewest_changes(columns, tuple(-x % PRIME for x in start)):
        yield _bodies(sums, dict(zip(parts, factors, strict=True)))


def _residual(claim: Claim, statement: Statement, change: Redefinition) -> Vector | None:
    try:
        definitions = change.of(claim.notation.definitions)
        screen = Screen(definitions, claim.supposed, [{}] * _POINTS)
        return screen.residual(statement)
    except NotExact:
        return None


def _bodies(
    sums: dict[Symbol, tuple[Term, ...]], factors: dict[tuple[Symbol, Term], Fraction]
) -> dict[Symbol, Term]:
    """Returns the bodies that change."""
    bodies = {}
    for s, addends in sums.items():
        kept = [times(f, a) for a in addends if (f := factors[s, a]) != 0]
        if any(factors[s, a] != 1 for a in addends):
            bodies[s] = sum_of(kept) if kept else zero(s.type)
    return bodies

"""Definitions under repair: where several false claims share defined symbols, other coefficients in the
definitions may mend them all at once.

A claim that is linear in the symbols is an equation for the coefficients of their bodies: each addend of a
body contributes what the claim's side becomes with the body cut down to that addend. What solves it for one
claim is tried on the others, and a claim counts as mended only if the judge proves it under the change.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from fractions import Fraction

from workbench.judge.assumptions import Unsatisfiable
from workbench.judge.inventory import Lookup, NotExact
from workbench.judge.judge import Judge
from workbench.judge.rings import PRIME
from workbench.judge.verdict import Outcome
from workbench.language.construct import zero
from workbench.language.printer import to_latex
from workbench.language.terms import Apply, IllFormed, Relation, Symbol, Term
from workbench.papers.model import Claim
from workbench.repair.coefficients import Vector, fewest_changes
from workbench.repair.places import places
from workbench.repair.screen import Screen
from workbench.repair.variants import sum_of, times

_POINTS = 6


@dataclass(frozen=True)
class Redefined:
    """Definitions in which some symbols have other bodies."""

    definitions: Lookup
    bodies: dict[Symbol, Term]

    def lookup(self, symbol: Symbol) -> Term | None:
        return self.bodies[symbol] if symbol in self.bodies else self.definitions.lookup(symbol)


@dataclass(frozen=True)
class DefinitionRepair:
    """Changed definitions, as LaTeX (symbol, body as it was, body as proposed), and the ids of the claims
    that are proved under them and were false before."""

    changed: tuple[tuple[str, str, str], ...]
    mended: tuple[str, ...]

    @property
    def edit(self) -> str:
        parts = [f"${name} = {new}$ instead of ${old}$" for name, old, new in self.changed]
        return f"{' and '.join(parts)} mends {', '.join(self.mended)}"


def repair_definitions(claims: Sequence[Claim], least: int = 2) -> list[DefinitionRepair]:
    """Changes of definitions that mend at least `least` of the false ones among the claims, the most mending
    first."""
    claims = [claim for claim in claims if not _holds(claim, claim.notation.definitions)]
    found: dict[tuple, DefinitionRepair] = {}
    for claim in claims:
        for bodies in _solutions(claim):
            mended = tuple(
                other.id for other in claims if _holds(other, Redefined(other.notation.definitions, bodies))
            )
            if len(mended) >= least:
                changed = tuple(
                    (to_latex(s), to_latex(claim.notation.definitions.lookup(s)), to_latex(body))
                    for s, body in bodies.items()
                )
                found.setdefault(changed, DefinitionRepair(changed, mended))
    return sorted(found.values(), key=lambda repair: -len(repair.mended))


def _holds(claim: Claim, lookup: Lookup) -> bool:
    assume = tuple(a.statement for a in claim.assume)
    if claim.printed.statement is None:
        return False
    judge = Judge(lookup, motions=False)
    try:
        verdict = judge.judge(claim.printed.statement, assume=assume, orders=claim.orders)
    except (Unsatisfiable, IllFormed, NotExact):
        return False
    return verdict.outcome == Outcome.PROVED


def _solutions(claim: Claim) -> Iterator[dict[Symbol, Term]]:
    """Bodies of the claim's defined symbols, with other coefficients, that make it hold at random points."""
    statement = claim.printed.statement
    if not isinstance(statement, Relation) or claim.orders or statement.operator != "=":
        return
    definitions = claim.notation.definitions
    symbols = list(dict.fromkeys(t for _, t in places(statement) if isinstance(t, Symbol)))
    sums = {s: body.arguments for s in symbols if _is_sum(body := definitions.lookup(s))}
    if not sums:
        return
    nothing = {s: zero(s.type) for s in sums}
    start = _residual(claim, Redefined(definitions, nothing))
    parts = [(s, addend) for s, addends in sums.items() for addend in addends]
    columns = []
    for s, addend in parts:
        residual = _residual(claim, Redefined(definitions, {**nothing, s: addend}))
        if residual is None or start is None:
            return
        columns.append(tuple((x - y) % PRIME for x, y in zip(residual, start, strict=True)))
    for factors in fewest_changes(columns, tuple(-x % PRIME for x in start)):
        yield _bodies(sums, dict(zip(parts, factors, strict=True)))


def _is_sum(body: Term | None) -> bool:
    return isinstance(body, Apply) and body.head == "add"


def _residual(claim: Claim, lookup: Lookup) -> Vector | None:
    try:
        screen = Screen(lookup, tuple(a.statement for a in claim.assume), [{}] * _POINTS)
        return screen.residual(claim.printed.statement)
    except NotExact:
        return None


def _bodies(
    sums: dict[Symbol, tuple[Term, ...]], factors: dict[tuple[Symbol, Term], Fraction]
) -> dict[Symbol, Term]:
    """The bodies that change."""
    bodies = {}
    for s, addends in sums.items():
        kept = [times(f, a) for a in addends if (f := factors[s, a]) != 0]
        if any(factors[s, a] != 1 for a in addends):
            bodies[s] = sum_of(kept) if kept else zero(s.type)
    return bodies

"""Headings and anchors of claims and equations in a report."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import TypeAlias

from workbench.context.claims import Claim
from workbench.prover.results.claim_results import ClaimResult

#: (heading, anchor) of an entry.
Place: TypeAlias = tuple[str, str]

_CLAIM_ID = re.compile(r"\b[\w+*'-]+(?:\.[\w+*'-]+)+|\b\w+_\w+(?:\.\w+)+")


def is_number(equation: str | None) -> bool:
    return bool(equation and re.fullmatch(r"(?:[A-Z]\.?)?\d+(?:\.\d+)*[a-z]?", equation))


def heading(claim: Claim) -> str:
    """Returns the name of a claim's equation: its number or name; in a text without a number the label of its
    own row, else its line."""
    span = claim.context.span
    if claim.equation:
        return f"Eq. ({claim.equation})" if span or is_number(claim.equation) else claim.equation
    return claim.id if span is None else claim.source.label or f"Line {span.line}"


def label(claim: Claim) -> str:
    """Returns the heading in a table: (70), Theorem 2, eq:turn, Line 12."""
    return heading(claim).removeprefix("Eq. ")


def display_name(claim: Claim) -> str:
    """Returns the name for the author of a text: the number with the label of the row, the label, or the
    line."""
    own = claim.source.label if claim.equation else None
    name = label(claim)
    return f"{name} {own}" if own else name[:1].lower() + name[1:] if name.startswith("Line ") else name


def is_counted(claim: Claim) -> bool:
    """True if the claim is of a numbered equation or a text, not of a named theorem or remark."""
    return not claim.equation or claim.context.span is not None or is_number(claim.equation)


def joined(headings: Sequence[str]) -> str:
    """Returns Eqs. (37), (107), (108) for Eq. (37), Eq. (107), Eq. (108)."""
    numbers = sorted((heading.removeprefix("Eq. ") for heading in headings), key=lambda n: (len(n), n))
    is_plain = len(headings) == 1 or not all(heading.startswith("Eq. ") for heading in headings)
    return ", ".join(headings) if is_plain else f"Eqs. {', '.join(numbers)}"


class Places:
    """Unique readable anchors.

    Attributes:
        claims: Claim id → (heading, anchor).
        equations: Claim id → anchor of its equation.
        anywhere: Claim id or equation → (heading, anchor).
    """

    def __init__(self, equations: Sequence[Sequence[Claim]]) -> None:
        self._taken: set[str] = set()
        self.equations: dict[str, str] = {}
        # Numbers first: #eq-61 must be equation (61), whatever else is called "eq 61".
        for own in sorted(equations, key=lambda own: not is_number(own[0].equation)):
            prefix = "eq-" if is_number(own[0].equation) else "at-"
            anchor = self._fresh(prefix + _slug(own[0].equation or own[0].id))
            self.equations.update(dict.fromkeys((claim.id for claim in own), anchor))
        claims = [claim for own in equations for claim in own]
        self.claims = {
            claim.id: (heading(claim), self._fresh("claim-" + _slug(claim.id))) for claim in claims
        }
        by_equation = {c.equation: (heading(c), self.equations[c.id]) for c in claims if c.equation}
        self.anywhere = by_equation | self.claims

    def _fresh(self, wanted: str) -> str:
        anchor, copy = wanted, 2
        while anchor in self._taken:
            anchor, copy = f"{wanted}--{copy}", copy + 1
        self._taken.add(anchor)
        return anchor


def _slug(name: str) -> str:
    return re.sub(r"[^a-z0-9.]+", "-", name.lower()).strip("-") or "x"


def with_headings(prose: str, places: Mapping[str, Place]) -> str:
    """Returns the sentence with names of claims, such as 61.det, replaced by their headings: Eq. (61)."""
    return _CLAIM_ID.sub(lambda name: places[name[0]][0] if name[0] in places else name[0], prose)


class Heirs:
    """Dependences between claims, in both directions and transitively."""

    def __init__(self, results: Sequence[ClaimResult], places: Mapping[str, Place]) -> None:
        self._places = places
        self._later: dict[str, set[str]] = {}
        for claim in (result.claim for result in results):
            self._later.setdefault(claim.id, set()).update(claim.inherits)
            if claim.mend.by:
                self._later.setdefault(claim.mend.by, set()).add(claim.id)
        self._order = {result.claim.id: index for index, result in enumerate(results)}
        self._before: dict[str, list[str]] = {}
        for name, heirs in self._later.items():
            for heir in sorted(heirs):
                self._before.setdefault(heir, []).append(name)

    def of(self, ids: Iterable[str], own: Collection[str]) -> tuple[Place, ...]:
        """Returns the equations that depend on these claims, without the claims' own equations."""
        waiting, reached = list(ids), set()
        while waiting:
            for heir in self._later.get(waiting.pop(), ()):
                if heir not in reached:
                    reached.add(heir)
                    waiting.append(heir)
        found: dict[str, str] = {}
        for heir in sorted(reached & self._places.keys(), key=self._order.__getitem__):
            found.setdefault(*self._places[heir])
        return tuple((name, anchor) for name, anchor in found.items() if name not in own)

    def before(self, claim: Claim) -> list[Place]:
        """Returns the claims from which the claim inherits a fault directly."""
        return [self._places[name] for name in self._before.get(claim.id, ()) if name in self._places]

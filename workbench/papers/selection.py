"""Selection of claims by the SELECT argument of the command line."""

from __future__ import annotations

import re
from collections.abc import Sequence
from fnmatch import fnmatchcase

from workbench.context.claims import Claim
from workbench.core.close_names import did_you_mean
from workbench.core.codes.input_codes import InputCode

_RANGE = re.compile(r"(\d{1,6})\s*[-–]\s*(\d{1,6})")
_LEADING_NUMBER = re.compile(r"\d+")


class SelectError(ValueError):
    """A selection that matches no claim."""


def select_claims(claims: Sequence[Claim], select: Sequence[str]) -> list[Claim]:
    """Returns the claims that match at least one item, in reading order; all of them if there is no item.

    An item is an equation ("58", "Theorem 4"), a range of equations ("45-70"), an id ("58.det"), a section
    ("4.1"), or a pattern of ids ("58.*"). Raises SelectError for an item that matches none.
    """
    if not select:
        return list(claims)
    chosen: set[str] = set()
    for item in select:
        found = {claim.id for claim in claims if _means(item.strip(), claim)}
        if not found:
            hint = did_you_mean(
                item, {name for claim in claims for name in (claim.id, claim.equation) if name}
            )
            raise SelectError(InputCode.NO_CLAIM_SELECTED(item=repr(item), hint=hint and f" {hint}"))
        chosen |= found
    return [claim for claim in claims if claim.id in chosen]


def _means(item: str, claim: Claim) -> bool:
    if claim.equation is not None:
        if item.casefold() == claim.equation.casefold():
            return True
        bounds = _RANGE.fullmatch(item)
        number = _LEADING_NUMBER.match(claim.equation)
        if bounds and number and int(bounds[1]) <= int(number[0]) <= int(bounds[2]):
            return True
    return item in (claim.id, claim.section) or fnmatchcase(claim.id, item)

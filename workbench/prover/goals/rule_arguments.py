"""What a proof gives to a rule: the number of a premise, and a value of an integer."""

from __future__ import annotations

from workbench.core.integer_expressions import Linear
from workbench.language.goals.goals import (
    AllBelow,
    Goal,
    Scope,
)
from workbench.language.grammar.parser import parse
from workbench.language.naming.linear_indices import linear
from workbench.prover.goals.sequents import (
    NotShown,
    Premise,
    Sequent,
)


def says_the_same(known: Goal, wanted: Goal, scope: Scope) -> bool:
    """True if the known goal is the wanted one, or covers more integers."""
    if not (isinstance(known, AllBelow) and isinstance(wanted, AllBelow)):
        return known == wanted
    same = (known.integer, known.body) == (wanted.integer, wanted.body) and known.least <= wanted.least
    return same and is_at_least(known.bound - wanted.bound, 0, scope)


def premise_at(sequent: Sequent, place: int) -> Premise:
    if not -len(sequent.premises) <= place < len(sequent.premises):
        raise NotShown(f"there is no premise {place}; there are {len(sequent.premises)}")
    return sequent.premises[place]


def integer_given(text: str | None, name: str, least: int, scope: Scope) -> Linear:
    """Returns an integer that the bounds of its letters keep at `least` or above. Raises NotShown."""
    if text is None:
        raise NotShown(f"no value is given for {name}")
    value = linear(parse(text).lines[0][0], list(scope.integers))
    if value is None:
        raise NotShown(f"expected an integer for {name}, got {text}")
    if not is_at_least(value, least, scope):
        raise NotShown(f"{name} = {text} is not seen to be {least} or more")
    return value


def is_at_least(value: Linear, least: int, scope: Scope) -> bool:
    """True if the value is at least that large for all integers in scope."""
    lowest = value.substitute(scope.integers)
    return all(c > 0 for _, c in value.coefficients) and lowest.is_number and int(lowest) >= least

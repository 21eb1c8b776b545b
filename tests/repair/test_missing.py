"""Addends that are dropped are found again, in sides and in brackets; what says nothing is known as such."""

from random import Random

import pytest
from repair.damage import read_or_fault, right_claims

from workbench.core.construct import apply, identity, relation, symbol
from workbench.core.names import Name
from workbench.core.terms import Apply, IllFormed
from workbench.core.types import TENSOR, VECTOR, Declaration
from workbench.engines.inventory import NotExact
from workbench.papers import find_paper
from workbench.repair.propose.symbols_like import symbols_like
from workbench.repair.screening.screen import Screen
from workbench.repair.screening.vacuous import is_idle, is_vacuous, says_less
from workbench.repair.terms.addend_products import Supply
from workbench.repair.terms.missing_addend import MissingAddends, is_linear
from workbench.repair.terms.subterm_positions import places, replaced
from workbench.repair.terms.term_arithmetic import sum_of


@pytest.fixture(scope="module")
def paper():
    return find_paper()


def screen_of(claim):
    return Screen(claim.notation.definitions, claim.supposed, (claim.instances[-3:] * 3)[:3])


def finder(claim, statement):
    screen = screen_of(claim)
    if screen.keep(statement) is None:
        return None
    near, _ = symbols_like(statement, claim.notation.symbols, claim.orders.variables if claim.orders else ())
    return MissingAddends(statement, screen, Supply(statement, near, screen.points[-1].components)), screen


def without_an_addend(claim, formula, random):
    """The statement with one addend dropped where it is linear."""
    sums = [
        (place, term)
        for place, term in places(formula.statement)
        if isinstance(term, Apply) and term.head == "add" and is_linear(formula.statement, place)
    ]
    if not sums:
        return None
    place, term = random.choice(sums)
    kept = list(term.arguments)
    kept.pop(random.randrange(len(kept)))
    try:
        return replaced(formula.statement, place, sum_of(kept))
    except IllFormed:
        return None


@pytest.mark.parametrize("every", [52, pytest.param(13, marks=pytest.mark.slow)])
def test_a_dropped_addend_is_found_again(paper, every):
    random = Random(7)
    tried = found = 0
    for claim, formula in right_claims(paper)[::every]:
        damaged = without_an_addend(claim, formula, random)
        try:
            found_by = None if damaged is None else finder(claim, damaged)
        except NotExact:
            continue
        if found_by is None or found_by[1].vanishes(damaged):
            continue
        search, screen = found_by
        tried += 1
        if any(screen.vanishes(edit.statement) for edit in (*search.outer(), *search.inner())):
            found += 1
    assert tried > 2
    assert found >= 0.7 * tried


VACUOUS = [
    r"\ddot{\omega} + \omega \times \dot{\omega} = \omega \times \dot{\omega} + \ddot{\omega}",
    r"\ddot{\omega} = \ddot{\omega} + \omega \times \dot{\omega} - \omega \times \dot{\omega}",
    r"(\omega \cdot \dot{\omega}) \omega^2 \omega = \omega^2 \omega (\omega \cdot \dot{\omega})",
]
IDLE = [
    r"\omega \times \omega = \tilde{\omega} \omega",
    r"\dot{\omega} = \dot{\omega} + \omega \times \omega",
]
TELLING = [
    r"\omega \times \omega = 0",
    r"\tilde{\omega} \dot{\omega} = \omega \times \dot{\omega}",
    r"\ddot{\omega} = \ddot{\omega} + \omega \times \dot{\omega}",
]


def test_vacuous_statements_are_recognized(paper):
    claim = next(claim for claim in paper.claims if claim.id == "58.det")
    screen = screen_of(claim)
    for text in (*VACUOUS, *IDLE, *TELLING):
        statement = read_or_fault(text, claim).statement
        assert is_vacuous(statement) == (text in VACUOUS), text
        if text not in VACUOUS:
            assert is_idle(statement, screen) == (text in IDLE), text


def test_turns_back_and_forth_say_nothing() -> None:
    turn = symbol(Declaration(Name("R"), TENSOR).with_flags(rotation=True))
    back, vector = apply("transpose", turn), symbol(Declaration(Name("m"), VECTOR))
    there_and_back = relation("=", vector, apply("mul", apply("mul", turn, back), vector))
    stiff = apply("mul", symbol(Declaration(Name("K"), TENSOR)), back)
    assert says_less(there_and_back, relation("=", vector, apply("mul", turn, vector)))
    assert says_less(there_and_back, relation("=", vector, apply("mul", stiff, vector)))
    assert not says_less(
        there_and_back, relation("=", vector, apply("mul", apply("mul", turn, turn), vector))
    )
    assert not says_less(relation("=", apply("mul", turn, back), identity()), relation("=", turn, identity()))

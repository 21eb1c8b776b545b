"""Places, edits and LaTeX of trees by their laws, on every formula of the chapter."""

from fractions import Fraction
from random import Random

import pytest
from repair.damage import read_or_fault, right_claims

from workbench.engines.jet.rings import PRIME
from workbench.language.grammar.latex_forms import latex_of
from workbench.language.grammar.parser import parse
from workbench.papers import find_paper
from workbench.repair.terms.coefficients import LARGEST, fewest_changes, rational
from workbench.repair.terms.subterm_positions import places, replaced, subterm
from workbench.repair.terms.term_arithmetic import coefficient, times
from workbench.repair.terms.term_edits import KINDS, Edit, Refused, edits


@pytest.fixture(scope="module")
def right():
    return right_claims(find_paper())


def test_replacing_a_subterm_by_itself_changes_nothing(right):
    for _, formula in right:
        for place, term in places(formula.statement):
            assert subterm(formula.statement, place) == term
            assert replaced(formula.statement, place, term) == formula.statement


def test_an_edit_changes_the_statement_at_one_position_only(right):
    checked = 0
    for claim, formula in right[::3]:
        for edit in edits(formula.statement):
            assert edit.kind in KINDS
            if isinstance(edit, Refused):
                assert edit.ill_formed
                continue
            assert edit.statement != formula.statement, (claim.id, edit.description)
            assert subterm(formula.statement, edit.place) == edit.old
            assert replaced(edit.statement, edit.place, edit.old) == formula.statement
            checked += 1
    assert checked > 500


def test_no_edit_comes_twice(right):
    for _, formula in right[::3]:
        found = [edit.statement for edit in edits(formula.statement) if isinstance(edit, Edit)]
        assert len(found) == len(set(found))


def test_a_tree_printed_reads_as_it_was(right):
    for claim, formula in right:
        again = read_or_fault(latex_of(parse(formula.latex)), claim)
        assert again is not None, claim.id
        assert again.statement == formula.statement, claim.id


def test_a_fraction_is_found_from_its_residue():
    random = Random(4)
    for _ in range(500):
        value = Fraction(random.randint(-LARGEST, LARGEST), random.randint(1, LARGEST))
        assert rational(value.numerator * pow(value.denominator, -1, PRIME) % PRIME) == value
        assert rational(random.randrange(PRIME)) is None


def test_the_fewest_coefficients_are_changed():
    random = Random(5)
    for trial in range(60):
        size, changed = 2 + trial % 5, 1 + trial % 2
        columns = [tuple(random.randrange(PRIME) for _ in range(size + 4)) for _ in range(size)]
        wrong = random.sample(range(size), changed)
        factors = [
            Fraction(random.choice((-2, -1, 0, 2, 3))) if i in wrong else Fraction(1) for i in range(size)
        ]
        target = tuple(
            sum(int(f) * c[row] for f, c in zip(factors, columns, strict=True)) % PRIME
            for row in range(size + 4)
        )
        assert list(fewest_changes(columns, target)) == [tuple(factors)]


def test_factors_multiply(right):
    random = Random(6)
    for _, formula in right[::2]:
        for _, term in places(formula.statement):
            if term.type.kind in ("vector", "tensor") and coefficient(term) != 0:
                factor = Fraction(random.choice((2, 3, 5)), random.choice((1, 2)))
                once = times(factor, term)
                assert once.type == term.type and once.weight == term.weight
                assert coefficient(times(1 / factor, once)) == coefficient(term)

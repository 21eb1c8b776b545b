"""Arguments of steps: what is proved, and everything that must not be."""

from fractions import Fraction

import flint
import numpy as np
import pytest

from workbench.algebra.dual import Dual
from workbench.judge.theorems.arguments import Engine, Step, Way, argue, vanishing, vanishing_to
from workbench.judge.verdict import Counterexample, Outcome

X, Y = flint.fmpq_mpoly_ctx.get(("x", "y"), "lex").gens()
FALSE = vanishing(lambda: [Fraction(1)])
EXAMPLE = Counterexample({"x": ("1",)}, ("1",), ("2",))


def way(engine, check, but_not=FALSE):
    return Way(engine, check, but_not)


def truth(engine=Engine.FLINT):
    return way(
        engine,
        vanishing(lambda: [(X + Y) ** 2 - X**2 - 2 * X * Y - Y**2]),
        vanishing(lambda: [(X + Y) ** 2 - X**2 - X * Y - Y**2]),
    )


def step(name="a binomial", first=None):
    return Step(name, first or truth(), truth(Engine.SYMPY))


def test_steps_that_hold_prove():
    verdict = argue([step(), step("again")], scope="all n")
    assert verdict.outcome == Outcome.PROVED
    assert verdict.scope == "all n"
    assert [e.outcome for e in verdict.evidence] == ["a binomial"] * 2 + ["again"] * 2
    assert all(e.figures["checks"] == 1 for e in verdict.evidence)


@pytest.mark.parametrize(
    ("bad", "says"),
    [
        (way(Engine.FLINT, vanishing(lambda: [X - Y])), "1 of 1 checks fail"),
        (way(Engine.FLINT, vanishing(lambda: [])), "looked at nothing"),
        (way(Engine.FLINT, vanishing(lambda: [np.array([])])), "looked at nothing"),
        (way(Engine.FLINT, vanishing(lambda: [X - X]), vanishing(lambda: [])), "control looked at"),
        (way(Engine.FLINT, vanishing(lambda: [X - X]), vanishing(lambda: [Y - Y])), "tests nothing"),
        (way(Engine.FLINT, vanishing(lambda: [0.0])), "got a float"),
        (way(Engine.FLINT, vanishing(lambda: [Dual(X - X, X)])), "1 of 2"),
        (way(Engine.FLINT, lambda: [1 / 0]), "ZeroDivisionError"),
        (way(Engine.FLINT, lambda: [0]), "expected True or False"),
    ],
)
def test_a_step_that_fails_leaves_the_argument_unchecked(bad, says):
    verdict = argue([step(), step("the bad one", bad), step("the rest")])
    assert verdict.outcome == Outcome.UNCHECKED
    assert "the bad one" in verdict.reason
    assert says in verdict.reason
    assert "the rest" not in [e.outcome for e in verdict.evidence]


@pytest.mark.parametrize("options", [{"hypothesis": "x = 0"}, {"refutes": True}])
def test_a_failing_step_is_unchecked_whatever_was_meant(options):
    bad = step(first=way(Engine.FLINT, vanishing(lambda: [X])))
    assert argue([bad], counterexample=EXAMPLE, **options).outcome == Outcome.UNCHECKED


def test_a_hypothesis_makes_it_conditional_and_a_refutation_refuted():
    verdict = argue([step()], hypothesis=r"x \neq 0", counterexample=EXAMPLE)
    assert (verdict.outcome, verdict.hypothesis) == (Outcome.CONDITIONAL, r"x \neq 0")
    assert argue([step()], refutes=True, counterexample=EXAMPLE).outcome == Outcome.REFUTED


@pytest.mark.parametrize(
    ("arguments", "options", "says"),
    [
        ([], {}, "without steps"),
        ([step(), step()], {}, "twice"),
        ([step()], {"hypothesis": "x"}, "expected a counterexample"),
        ([step()], {"refutes": True}, "expected a counterexample"),
        ([step()], {"counterexample": EXAMPLE}, "expected no counterexample"),
        ([step()], {"hypothesis": "x", "refutes": True, "counterexample": EXAMPLE}, "got both"),
    ],
)
def test_an_argument_that_makes_no_sense_is_refused(arguments, options, says):
    with pytest.raises(ValueError, match=says):
        argue(arguments, **options)


@pytest.mark.parametrize(
    "engines",
    [
        (Engine.FLINT,),
        (Engine.FLINT, Engine.FLINT),
        (Engine.FLINT, Engine.DRAKE),
        (Engine.FRACTIONS, Engine.SYMPY),
    ],
)
def test_a_statement_for_all_values_needs_two_generic_engines(engines):
    with pytest.raises(ValueError, match="expected two engines"):
        Step("for all x", *map(truth, engines))


def test_a_statement_of_existence_needs_an_exact_example_and_a_second_engine():
    Step("there is", truth(Engine.FRACTIONS), truth(Engine.DRAKE), by_example=True)
    with pytest.raises(ValueError, match="expected two engines"):
        Step("there is", truth(Engine.FLOATS), truth(Engine.DRAKE), by_example=True)


def test_floats_vanish_within_a_tolerance_and_nan_never():
    assert list(vanishing_to(1e-9, lambda: [np.array([1e-10, -1e-10]), 0.0])()) == [True] * 3
    assert list(vanishing_to(1e-9, lambda: [1e-8, float("nan")])()) == [False, False]

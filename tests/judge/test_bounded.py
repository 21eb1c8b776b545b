r"""\forall k < n, and induction from all that is below: proofs of true goals, and of false ones of their form."""

import pytest

from tests.judge.goals.test_goals import scope
from workbench.core.integer_expressions import Linear
from workbench.language.goals.goal_reader import read_goal
from workbench.language.goals.goals import AllBelow, GoalError


def below(bound: str) -> str:
    return rf"\Big( \forall k < {bound} : a^{{(k)}} = b^{{(k)}} \Big)"


def test_bounded_quantifiers_are_read():
    goal = read_goal(rf"\forall n \geq 1 : {below('n-1')} \Rightarrow a = b", scope()).body.premise
    assert isinstance(goal, AllBelow)
    assert (goal.integer, goal.least, goal.bound) == ("k", 0, Linear(-1, (("n", 1),)))
    for wrong in (r"\exists k < 3", r"\forall k < q", r"\forall k < a", r"\forall n \geq 1 : \forall n < n"):
        with pytest.raises(GoalError):
            read_goal(f"{wrong} : a = b", scope())

"""A table (rows, coordinates) of states that is given where derivatives of one state are expected."""

import warnings

import numpy as np
import pytest
from kinematics.random_robots import tree

from workbench.kinematics.chain import Joint, SerialChain
from workbench.kinematics.robot import Robot

ARM = tree(0, ["revolute", "prismatic", "revolute"])
CHAIN = SerialChain([Joint.revolute([0, 0, 1]), Joint.prismatic([1, 0, 0]), Joint.revolute([0, 1, 0])])
DOORS = {
    "motion": lambda q, **order: Robot("arm", ARM.joints).motion(q, **order),
    "on_objects": lambda q, **order: ARM.on_objects("b2", q, **order),
    "chain": lambda q, **order: SerialChain(CHAIN.joints).twist_derivatives(
        q, **{name: n - 1 for name, n in order.items()}
    ),
}


@pytest.mark.parametrize("rows", [2, 3, 8, 30])
@pytest.mark.parametrize("door", DOORS)
def test_a_told_order_is_taken_at_its_word(door, rows):
    q = np.random.default_rng(rows).normal(size=(rows, 3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        DOORS[door](q, order=rows - 1)
        for _ in range(2):  # the second time the shape is known
            ARM.motion(q, order=rows - 1)
    for wrong in (rows, rows - 2):
        with pytest.raises(
            ValueError, match=r"order: expected \d+ for the shape .* a table of states is given"
        ):
            DOORS[door](q, order=wrong)


@pytest.mark.parametrize("door", ["motion", "on_objects"])
def test_more_rows_than_any_state_has_are_refused(door):
    with pytest.raises(
        ValueError, match="at most 21 rows, one an order of one state, got 22; a table of states"
    ):
        DOORS[door](np.random.default_rng(0).normal(size=(22, 3)))
    with pytest.warns(UserWarning, match="21 rows, taken for one state"):
        DOORS[door](np.random.default_rng(0).normal(size=(21, 3)))


@pytest.mark.parametrize("door", DOORS)
@pytest.mark.parametrize("rows", [2, 3, 4, 5, 6, 21])
def test_a_table_without_order_is_said(door, rows):
    """Coarse and fine samples of a path, and a state at rest: their shapes tell nothing."""
    coarse = np.random.default_rng(rows).uniform(-2, 2, size=(rows, 3))
    for table in (coarse, np.linspace(0.2, 0.3, rows)[:, None] * [1.0, -2.0, 0.5], np.zeros((rows, 3))):
        with pytest.warns(
            UserWarning, match=rf"{rows} rows, taken for one state .*; if it is, say order=\d+; a"
        ):
            DOORS[door](table)


@pytest.mark.parametrize(
    "make", [lambda: Robot("arm", ARM.joints).motion, lambda: SerialChain(CHAIN.joints).twist_derivatives]
)
def test_a_shape_is_warned_of_once(make):
    """Also where the same shape was given with its order before: that call says nothing about this one."""
    taken, q = make(), np.random.default_rng(0).normal(size=(3, 3))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        taken(q, order=2 if taken.__name__ == "motion" else 1)
    with pytest.warns(UserWarning, match="3 rows, taken for one state"):
        taken(q)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        taken(q)


def test_batches_are_taken_without_a_word():
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for states in (1, 4):
            ARM.motion(np.zeros((3, states, 3)))
            CHAIN.twist_derivatives(np.zeros((3, states, 3)))


def test_velocities_have_the_told_order():
    q, v = np.zeros(3), np.zeros((2, 3))
    assert ARM.motion(q, v, order=2).order == 2
    with pytest.raises(ValueError, match="order: expected that of v_derivatives, 2, got 3"):
        ARM.motion(q, v, order=3)

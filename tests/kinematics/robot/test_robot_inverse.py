"""From a prescribed twist back to the joints."""

import numpy as np
import pytest
from kinematics.random_robots import motion, tree

from workbench.kinematics.robot import Robot, SingularJacobian, TreeJoint


@pytest.mark.parametrize("expressed", ["world", "mixed", "body"])
@pytest.mark.parametrize(
    "kinds", [["floating"], ["revolute"] * 6, ["ball", "prismatic", "planar", "helical"]]
)
def test_inverse_gives_back_the_twist_to_every_order(kinds, expressed):
    robot = tree(6, kinds)
    robot = Robot(
        "chain",
        [
            TreeJoint(**{**vars(j), "parent": f"b{i - 1}" if i else "world"})
            for i, j in enumerate(robot.joints)
        ],
    )
    tip = robot.bodies[-1]
    given = motion(robot, 5, (2,), 6)
    options = {"expressed": expressed, "point": (0.1, 0.2, -0.1)}
    V = np.stack([given.frame(tip).velocity(k, **options) for k in range(5)])
    v = robot.inverse(tip, given.q, V, **options)
    again = robot.motion(given.q, v).frame(tip)
    for k in range(5):
        size = np.abs(given.rates).max() ** (k + 1) * 1e-8
        np.testing.assert_allclose(again.velocity(k, **options), V[k], rtol=0, atol=max(1e-8, size))
    if len(robot.velocities) == 6:
        np.testing.assert_allclose(v[:3], given.rates[:3], rtol=1e-6, atol=1e-6)


def test_a_redundant_inverse_has_least_norm_in_the_weight_stated():
    robot = tree(7, ["floating", "revolute", "prismatic"])
    tip, rng = "b2", np.random.default_rng(7)
    given = motion(robot, 3)
    V = np.stack([given.frame(tip).velocity(k) for k in range(3)])
    weight = rng.uniform(0.5, 4, len(robot.velocities))
    v = robot.inverse(tip, given.q, V, weight=weight)
    J = given.frame(tip).jacobian()
    null = np.linalg.svd(J)[2][6:]
    np.testing.assert_allclose(null @ (weight * v[0]), 0, atol=1e-10)  # stationary along each null direction
    preferred = rng.normal(size=v.shape)
    near = robot.inverse(tip, given.q, V, weight=weight, null_space=preferred)
    np.testing.assert_allclose(J @ near[0], V[0], atol=1e-10)
    np.testing.assert_allclose(null @ (weight * (near[0] - preferred[0])), 0, atol=1e-10)


def test_a_singular_jacobian_is_refused_with_its_singular_values():
    robot = tree(8, ["revolute"] * 3)
    with pytest.raises(SingularJacobian, match=r"6 independent rows of 3 .* singular values") as caught:
        robot.inverse("b2", np.zeros(3), np.zeros((2, 6)))
    assert caught.value.singular_values.shape == (3,)
    straight = Robot(
        "arm",
        [
            TreeJoint(f"j{i}", "revolute", f"b{i - 1}" if i else "world", f"b{i}", axis=[0, 0, 1])
            for i in range(2)
        ],
    )
    with pytest.raises(SingularJacobian, match="singular values"):
        straight.inverse("b1", np.zeros(2), np.zeros((1, 2)), rows=(2, 3))


@pytest.mark.parametrize(
    ("options", "message"),
    [
        ({"rtol": np.nan}, "rtol: expected 0 <= rtol < 1"),
        ({"weight": [1, -1]}, "weight: expected 2 numbers > 0"),
        ({"null_space": np.full((1, 2), np.inf)}, "null_space: expected finite"),
        ({"rows": [0, 1.0]}, "rows: expected different numbers from 0 to 5"),
        ({"rows": 6}, "rows: expected different numbers from 0 to 5"),
        ({"expressed": "tool"}, "expressed: expected one of"),
        ({"twist_derivatives": np.ones((1, 1)) * 1j}, "twist_derivatives: expected real numbers"),
    ],
)
def test_bad_prescriptions(options, message):
    robot = tree(0, ["revolute", "prismatic"])
    asked = {"twist_derivatives": np.ones((1, 1)), "rows": [0]} | options
    with pytest.raises(ValueError, match=message):
        robot.inverse("b1", np.zeros(2), **asked)

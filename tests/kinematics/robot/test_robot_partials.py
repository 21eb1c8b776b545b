"""Partial derivatives of twists, and the same motion on other scalars."""

import ctypes
import shutil
import subprocess
import sys
from math import factorial
from pathlib import Path

import numpy as np
import pytest
from kinematics.random_chains import close
from kinematics.random_robots import motion, tree

from workbench.kinematics.robot import Mimic, Robot, TreeJoint
from workbench.kinematics.robot.scalars import object_motion
from workbench.kinematics.trees.tree_engine import compute

KINDS = ("revolute", "prismatic", "helical", "universal", "cylindrical", "planar", "revolute")


def follower(seed=0):
    """A tree of joints of one-coordinate moves, one of which follows another."""
    joints = list(tree(seed, KINDS).joints)
    joints[4] = TreeJoint(**{**vars(joints[4]), "kind": "revolute", "mimic": Mimic("j0", -0.7, 0.2)})
    return Robot("follower", joints)


# -- closed form ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("seed", range(2))
def test_partials_are_those_of_drake_s_autodiff(seed):
    """AutoDiffXd goes through the recursion itself here; the closed form uses the Jacobian's derivatives."""
    from pydrake.autodiffutils import ExtractGradient, InitializeAutoDiff

    robot, order = follower(seed), 4
    q = np.random.default_rng(seed).normal(size=(order + 1, len(robot.positions)))
    frame = robot.motion(q).frame("b6")
    pose, twists = object_motion(robot, "b6", InitializeAutoDiff(q.ravel()).reshape(q.shape))
    close(np.array([[x.value() if hasattr(x, "value") else x for x in row] for row in pose]), frame.pose, 13)
    for k in range(order):
        close([x.value() for x in twists[k]], frame.twist(k).array, 12)
        gradient = ExtractGradient(twists[k][:, None]).reshape(6, order + 1, -1)
        scale, partials = np.abs(gradient).max(), frame.twist_partials(k)
        for j in range(order + 1):
            partial = frame.twist_partial(k, j)
            np.testing.assert_allclose(
                partial, gradient[:, j], rtol=0, atol=1e-12 * scale, err_msg=f"{k} {j}"
            )
            assert j > k + 1 or (partials[j] == partial).all()


def test_autodiff_of_a_robot_has_the_gradients_of_the_recursion():
    """q depends on five variables, some of it on none; pose and twists by the closed form and the recursion."""
    from pydrake.autodiffutils import AutoDiffXd

    robot, order = follower(4), 3
    rng = np.random.default_rng(4)
    q = np.array(
        [AutoDiffXd(x, rng.normal(size=5)) for x in rng.normal(size=(order + 1) * len(robot.positions))]
    )
    q[3] = AutoDiffXd(0.7)
    q = q.reshape(order + 1, -1)
    (pose, twists), (right_pose, right) = robot.on_objects("b6", q), object_motion(robot, "b6", q)
    for found, wanted in ((pose[:3], right_pose[:3]), (twists, right)):
        for at in np.ndindex(found.shape):
            scale = 1e-11 * max(1, np.abs([x.derivatives() for x in wanted.flat]).max())
            assert abs(found[at].value() - wanted[at].value()) < scale
            np.testing.assert_allclose(found[at].derivatives(), wanted[at].derivatives(), rtol=0, atol=scale)
    q[0, 0] = AutoDiffXd(1.0, np.ones(2))
    with pytest.raises(ValueError, match=r"expected gradients of one size, got \[2, 5\]"):
        robot.on_objects("b6", q)


def test_all_partials_cost_a_few_times_the_twists():
    """Of 1,024 states at order 5 in one pass, at most 10 times the twists alone."""
    import time

    robot, order = Robot("arm", tree(0, ["revolute"] * 7).joints), 5
    q = np.random.default_rng(0).normal(size=(order + 1, 1024, 7))
    least = {}
    for wanted in ((0, 0), (order + 1, order)):
        plan = robot.engine.plan("b6", order, *wanted)
        out, spent = np.empty((1, 1024, 1, plan.rows)), []
        for _ in range(30):
            start = time.perf_counter()
            compute(q, plan, out)
            spent.append(time.perf_counter() - start)
        least[wanted] = min(spent)
    assert least[order + 1, order] < 10 * least[0, 0]


def test_partials_of_a_point_and_of_a_batch_are_differences():
    robot, h, point = follower(3), 1e-6, (0.2, -0.1, 0.4)
    q = np.random.default_rng(3).normal(size=(4, 5, len(robot.positions)))
    frame = robot.motion(q).frame("b5")
    for k in range(3):
        for j in range(4):
            partial = frame.twist_partial(k, j, point=point)
            assert partial.shape == (5, 6, len(robot.positions))
            for i in range(len(robot.positions)):
                ends = []
                for sign in (1, -1):
                    moved = q.copy()
                    moved[j, :, i] += sign * h
                    ends.append(robot.motion(moved).frame("b5").velocity(k, point=point))
                slope = (ends[0] - ends[1]) / (2 * h)
                np.testing.assert_allclose(partial[..., i], slope, atol=1e-7 * max(1, np.abs(slope).max()))


def test_partials_known_in_advance():
    """∂V/∂q̇ is the Jacobian, and so is ∂V⁽ᵏ⁾/∂q⁽ᵏ⁺¹⁾; of higher derivatives nothing depends."""
    found = motion(follower(1), 5, (3,))
    for frame in found.frames:
        for k in range(5):
            np.testing.assert_allclose(frame.twist_partial(k, k + 1), frame.jacobian(0), atol=1e-13)
            assert not frame.twist_partial(k, k + 2).any()


def test_partials_of_balls_and_of_unknown_orders_are_refused():
    frame = motion(tree(0, ["revolute", "ball"]), 3).frame("b1")
    with pytest.raises(ValueError, match="partial derivatives: expected a robot without ball or floating"):
        frame.twist_partial(0, 0)
    frame = motion(tree(0, ["revolute"]), 3).frame("b0")
    with pytest.raises(ValueError, match="order: expected one from 0 to 2"):
        frame.twist_partial(3, 0)
    with pytest.raises(ValueError, match="j: expected an integer >= 0, got -1"):
        frame.twist_partial(0, -1)


# -- other scalars ---------------------------------------------------------------------------------------


def test_expressions_of_drake_are_the_motion_in_symbols():
    from pydrake.symbolic import Evaluate, MakeVectorVariable

    robot = Robot("arm", tree(2, ["revolute", "helical"]).joints)
    names = MakeVectorVariable(6, "q")
    pose, twists = robot.on_objects("b1", names.reshape(3, 2))
    q = np.random.default_rng(2).normal(size=(3, 2))
    env = dict(zip(names, q.ravel(), strict=True))
    frame = robot.motion(q).frame("b1")
    close(Evaluate(twists, env), frame.twists, 13)
    close(Evaluate(pose[:3], env), frame.pose[:3], 13)


def test_symbols_of_sympy_and_numbers_are_the_motion_too():
    import sympy

    robot = Robot("arm", tree(2, ["revolute", "helical"]).joints)
    names = np.array(sympy.symbols("q:6")).reshape(3, 2)
    q = np.random.default_rng(2).normal(size=(3, 2))
    frame = robot.motion(q).frame("b1")
    values = dict(zip(names.flat, q.flat, strict=True))
    of_symbols = [
        np.array([float(sympy.sympify(x).subs(values)) for x in part.flat]).reshape(part.shape)
        for part in robot.on_objects("b1", names)
    ]
    mixed = names.copy()
    mixed[0], mixed[1:] = q[0], q[1:]
    for pose, twists in (of_symbols, robot.on_objects("b1", mixed)):
        close(pose.astype(float), frame.pose, 13)
        close(twists.astype(float), frame.twists, 13)


def test_objects_of_another_shape_are_refused():
    robot = tree(2, ["revolute", "helical"])
    with pytest.raises(ValueError, match=r"expected shape \(N \+ 1, 2\) with N >= 1, got \(1, 2\)"):
        robot.on_objects("b1", np.zeros((1, 2)))
    with pytest.raises(ValueError, match="no body 'hand'"):
        robot.on_objects("hand", np.zeros((2, 2)))


@pytest.mark.parametrize("order", [1, 4])
def test_casadi_and_its_c_code_compute_the_same(order, tmp_path):
    pytest.importorskip("casadi")
    robot = follower(1)
    q = np.random.default_rng(1).normal(size=(order + 1, len(robot.positions)))
    frame = robot.motion(q).frame("b6")
    pose, twists = robot.casadi("b6", order)(q.T)
    close(np.array(pose), frame.pose, 13)
    close(np.array(twists).T, frame.twists, 12)
    if shutil.which("cc") is None:
        pytest.skip("no C compiler")
    source, library = tmp_path / "frame.c", tmp_path / "frame.so"
    source.write_text(robot.to_c("b6", order))
    subprocess.run(["cc", "-O1", "-shared", "-fPIC", source, "-lm", "-o", library], check=True)
    function = ctypes.CDLL(str(library)).frame_motion
    arrays = [np.ascontiguousarray(q), np.zeros((4, 4)), np.zeros((order, 6))]
    doubles = [a.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for a in arrays]
    pointer = ctypes.POINTER(ctypes.c_double)
    work = (ctypes.c_double * 10_000)()
    assert function((pointer * 1)(doubles[0]), (pointer * 2)(*doubles[1:]), None, work, 0) == 0
    close(arrays[1].T, frame.pose, 13)
    close(arrays[2], frame.twists, 12)


def test_jax_computes_the_same_and_its_jacobian():
    """In a process of its own: JAX starts threads, which other tests' processes must not be forked from."""
    pytest.importorskip("jax")
    program = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parents[2])!r})
import jax
import numpy as np
from kinematics.random_chains import close
from kinematics.random_robots import tree
from workbench.kinematics.robot import Robot
jax.config.update("jax_enable_x64", True)
robot, order = Robot("arm", tree(2, ["revolute", "prismatic", "revolute"]).joints), 2
q = np.random.default_rng(2).normal(size=(4, order + 1, 3))
function = robot.jax("b2", order)
pose, twists = jax.jit(jax.vmap(function))(q)
frame = robot.motion(q.swapaxes(0, 1)).frame("b2")
close(np.array(pose), frame.pose, 13)
close(np.array(twists).swapaxes(0, 1), frame.twists, 13)
partials = np.array(jax.jacfwd(lambda x: function(x)[1])(q[0]))
for k in range(order):
    for j in range(order + 1):
        close(partials[k, :, j], frame.twist_partial(k, j)[0], 11)
"""
    subprocess.run([sys.executable, "-c", program], check=True)


def test_derivatives_of_a_symbolic_pose_are_those_of_its_origin():
    """The derivatives of the pose along q(t), by Drake's symbols, are what the twists say."""
    from pydrake.symbolic import Expression, Variable

    robot = Robot("arm", tree(4, ["revolute", "prismatic"]).joints)
    t, rates = Variable("t"), np.array([[0.3, 0.5, -0.2, 0.1], [0.1, -0.4, 0.3, 0.2]])
    path = [sum(Expression(c) * t**k / factorial(k) for k, c in enumerate(row)) for row in rates]
    pose, _ = robot.on_objects("b1", [path, [Expression(0.0)] * 2])
    frame = robot.motion(rates.T).frame("b1")
    for axis, x in enumerate(pose[:3, 3]):
        for n in range(4):
            right = frame.point().derivatives[n, axis]
            np.testing.assert_allclose(x.Evaluate({t: 0.0}), right, atol=1e-12)
            x = x.Differentiate(t)

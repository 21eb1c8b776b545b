"""The compiled pass over a tree: of any size, memory and processor, against plain NumPy."""

import copy
import gc
import os
import pickle
import subprocess
import sys
from itertools import permutations
from math import factorial

import llvmlite.binding as llvm
import numpy as np
import pytest
from kinematics.plain_tree import plain_motion
from kinematics.random_chains import close, random_joint, random_joints
from kinematics.random_robots import motion, tree

from workbench.kinematics.chain import SerialChain
from workbench.kinematics.robot import Robot, TreeJoint
from workbench.kinematics.robot.structure import LARGE
from workbench.kinematics.trees.tree_memory import finite_copy

SCREWS = ["revolute", "prismatic", "cylindrical", "helical"]

# -- large batches -----------------------------------------------------------------------------------


def test_a_copy_past_the_caches_is_a_copy_or_none():
    """Of any size; a number that is not finite is found wherever it is."""
    rng = np.random.default_rng(0)
    for size in (0, 1, 15, 16, 17, 64, 333):
        numbers = rng.normal(size=(1, size))
        copied = finite_copy(numbers)
        assert copied.shape == (1, size) and (copied == numbers).all()
        for at in range(size):
            for bad in (np.nan, np.inf, -np.inf):
                numbers[0, at], kept = bad, numbers[0, at]
                assert finite_copy(numbers) is None
                numbers[0, at] = kept


def test_a_large_batch_is_that_of_its_parts_and_a_copy():
    robot = Robot("r", tree(1, ["revolute"] * 5).joints)
    q = np.random.default_rng(0).normal(size=(3, 40_001, 5))
    assert q.size >= LARGE
    found = robot.motion(q)
    first, last = (robot.motion(q[:, part]).frame("b4") for part in (slice(0, 9), slice(-9, None)))
    q[...] = 0
    frame = found.frame("b4")
    for part, right in ((slice(0, 9), first), (slice(-9, None), last)):
        close(frame.pose[part], right.pose, 14)
        close(frame.twists[:, part], right.twists, 13)
    assert not frame.pose.flags.writeable
    q[2, -1, -1] = np.nan
    with pytest.raises(ValueError, match="expected finite numbers"):
        robot.motion(q)


# -- values ------------------------------------------------------------------------------------------


@pytest.mark.parametrize("order", [1, 2, 3, 4, 7, 10])
@pytest.mark.parametrize("seed", range(2))
def test_every_body_moves_as_in_plain_numpy(seed, order):
    """A tree of joints of all kinds; the states of one block, of several, and of a block's rest."""
    robot = tree(seed)
    for states in (1, 9, 70):
        found = motion(robot, order, (states,), seed)
        frames = dict(zip(robot.bodies, found.frames, strict=True))
        for state in {0, states // 2, states - 1}:
            channels = found._input()[:, state]
            for body, frame in frames.items():
                X, V = plain_motion(robot.steps, robot.body(body), channels)
                close(frame.pose[state], X, 14)
                for k in range(order):
                    close(frame.twist(k).array[state], V[k], 12)


@pytest.mark.parametrize("states", [(), (3,), (16,), (4, 5)])
def test_a_body_moves_alone_as_with_all_others(states):
    """To the last bit: bodies that are welded to each other, too."""
    joints = [*tree(3).joints, TreeJoint("glue", "fixed", "b4", "tool")]
    robot = Robot("welded", joints)
    alone, together = motion(robot, 4, states), motion(robot, 4, states)
    assert together.frames
    for body in robot.bodies:
        ours, theirs = alone.frame(body), together.frame(body)
        np.testing.assert_array_equal(ours.twists, theirs.twists)
        np.testing.assert_array_equal(ours.pose, theirs.pose)
    np.testing.assert_array_equal(alone.frame("b4").twists, alone.frame("tool").twists)


@pytest.mark.parametrize("order", [1, 2, 3, 4, 5, 8, 11])
@pytest.mark.parametrize("states", [1, 7, 8, 9, 33, 200])
def test_a_chain_moves_as_the_tree_it_is_part_of(states, order):
    """The pass from the tip to the base and that from the base to the tip, of all memory layouts."""
    robot = tree(order, np.random.default_rng(order).permutation(SCREWS * 2))
    body = robot.bodies[-1]
    chain, coordinates = robot.chain(body)
    q = np.random.default_rng(states).normal(size=(order + 1, states, len(robot.positions)))
    expected = robot.motion(q).frame(body).origin_twist
    for layout in permutations(range(3)):
        same = np.transpose(np.transpose(q[..., coordinates], layout).copy(), np.argsort(layout))
        close(chain.twist_derivatives(same), expected, 12)
    factors = np.array([factorial(k) for k in range(order + 1)], dtype=float)[:, None, None]
    close(chain.twist_taylor(q[..., coordinates] / factors) * factors[:-1], expected, 12)
    with_large = q[:, :1, coordinates] + 2.0**60 * (np.arange(order + 1) == 0)[:, None, None]
    large = np.zeros((order + 1, 1, len(robot.positions)))
    large[..., coordinates] = with_large
    close(chain.twist_derivatives(with_large), robot.motion(large).frame(body).origin_twist, 12)
    again = pickle.loads(pickle.dumps(chain))
    np.testing.assert_array_equal(
        again.twist_derivatives(q[..., coordinates]), chain.twist_derivatives(q[..., coordinates])
    )


def test_a_base_far_away_changes_no_twist():
    """4 000 km from the world's origin, as in a map's coordinates: not by one bit."""
    joints = list(tree(5, ["revolute", "prismatic", "helical", "ball", "universal"]).joints)
    X = np.eye(4)
    X[:3, 3] = 4e6, 5e5, 300.0
    near = Robot("near", [TreeJoint("base", "fixed", "world", "root"), *_on(joints, "root")])
    far = Robot("far", [TreeJoint("base", "fixed", "world", "root", X), *_on(joints, "root")])
    ours, theirs = motion(near, 5, (9,)), motion(far, 5, (9,))
    point = (0.1, 0.2, -0.3)
    for body in near.bodies:
        a, b = ours.frame(body), theirs.frame(body)
        np.testing.assert_array_equal(a.twists, b.twists)
        for order in range(4):
            for expressed in ("mixed", "body"):
                J = [frame.jacobian(order, point=point, expressed=expressed) for frame in (a, b)]
                np.testing.assert_array_equal(*J)
        np.testing.assert_array_equal(a.point(point).derivatives[1:], b.point(point).derivatives[1:])
    relative = [m.frame("b4").relative_to(m.frame("b1")) for m in (ours, theirs)]
    close(relative[0].pose, relative[1].pose, 14)  # where each of both points is known to 1e-9 m
    for k in range(5):
        close(relative[0].twist(k).array, relative[1].twist(k).array, 13)
        close(relative[0].jacobian(k), relative[1].jacobian(k), 13)


def _on(joints, root):
    return [TreeJoint(**{**vars(j), "parent": root if j.parent == "world" else j.parent}) for j in joints]


# -- memory -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("states", [2, 8, 9, 21, 70])
@pytest.mark.parametrize("joints", [1, 2, 5])
def test_arrays_may_lie_in_memory_in_any_way(states, joints):
    """The axes in any order, with gaps or backwards, on either side; what is not the result is not touched."""
    rng = np.random.default_rng(states)
    kinds = ("cylindrical", "revolute", "helical", "prismatic", "revolute")[:joints]
    chain = SerialChain([random_joint(rng, kind) for kind in kinds])
    for n in (0, 1, 2, 3, 6):
        q = rng.normal(size=(n + 2, states, chain.dof))
        expected = chain.twist_derivatives(q)
        for axes in permutations(range(3)):
            back = np.argsort(axes)
            ours = q.transpose(axes).copy().transpose(back)
            close(chain.twist_derivatives(ours), expected, 13)
            for step in (1, 2, -1):
                whole = np.full([abs(step) * size for size in np.array(expected.shape)[list(axes)]], 0.5)
                out = whole[::step, ::step, ::step].transpose(back)
                assert chain.twist_derivatives(ours, out) is out
                close(out, expected, 13)
                assert (whole == 0.5).sum() == whole.size - out.size


@pytest.mark.parametrize("states", [(), (5,), (20,), (3, 7), (30_000,)])
def test_records_go_where_they_are_wanted(states):
    """The last size is written past the caches, in whole lines of memory."""
    robot = tree(1, ["revolute", "prismatic", "revolute"])
    found = motion(robot, 3, states)
    records = found.records()
    assert records.shape == (3, *states, 34) and not records.flags.writeable
    for record, frame in zip(records, found.frames, strict=True):
        np.testing.assert_array_equal(record[..., :16].reshape(*states, 4, 4), frame.pose)
        np.testing.assert_array_equal(record[..., 16:22], frame.twist(0))
    order = np.argsort(np.arange(records.ndim)[::-1])
    for out in (np.full(records.shape, np.nan), np.full(records.T.shape, np.nan).transpose(order)):
        assert found.records(out=out) is out
        np.testing.assert_array_equal(out, records)
    with pytest.raises(ValueError, match=r"out: expected a writable array of doubles of shape"):
        found.records(out=records)
    with pytest.raises(ValueError, match=r"out: expected a writable array of doubles of shape"):
        found.records(out=np.empty(3))


def test_any_array_of_numbers_will_do():
    rng = np.random.default_rng(6)
    chain = SerialChain(random_joints(rng, 3))
    q = rng.integers(-3, 4, size=(5, 4, chain.dof))
    V = chain.twist_derivatives(q.astype(float))
    read_only = q.astype(float)
    read_only.flags.writeable = False
    for same in (q, q.tolist(), q.astype(np.float32), read_only, np.asfortranarray(q * 1.0)):
        np.testing.assert_array_equal(chain.twist_derivatives(same), V)
    for state, expected in zip(read_only.swapaxes(0, 1), V.swapaxes(0, 1), strict=True):
        close(chain.twist_derivatives(state), expected, 13)
        close(chain.twist_derivatives(state.tolist()), expected, 13)
        other_end_first = state.astype(state.dtype.newbyteorder())
        for same in (other_end_first, state.astype(np.float32), state.astype(int), state[:, ::-1][:, ::-1]):
            close(chain.twist_derivatives(same), expected, 13)
    every_other = np.repeat(q * 1.0, 2, axis=1)[:, ::2]
    np.testing.assert_array_equal(chain.twist_derivatives(every_other), V)
    out = np.empty_like(V)
    assert chain.twist_derivatives(q, out) is out
    np.testing.assert_array_equal(out, V)


@pytest.mark.parametrize("kinds", [["revolute", "ball", "prismatic"], ["revolute"] * 3])
def test_arrays_of_a_motion_are_read_only_copies(kinds):
    robot = tree(2, kinds)
    q = np.random.default_rng(0).normal(size=(4, 9, len(robot.positions)))
    robot.motion(q[:, 0]).frame("b0")  # so that its shape is known
    for given in (q, q[:, 0].copy(), q[1:].copy()):
        found = robot.motion(given)
        frame = found.frame("b2")
        before = frame.twists.copy()
        arrays = [found.q, found.rates, frame.pose, frame.twists, frame.twist(1).array, frame.Phi, frame.a]
        arrays += [frame.origin_twist, frame.point((1, 2, 3)).derivatives, frame.point().position]
        arrays += [frame.jacobian(1), frame.relative_to(found.frame("b0")).twists]
        for array in arrays:
            with pytest.raises(ValueError, match="read-only"):
                array[...] = 0.0
        again = found.frame("b1").twists.copy()
        given *= 2.0
        np.testing.assert_array_equal(frame.twists, before)
        np.testing.assert_array_equal(robot.motion(found.q, found.rates).frame("b1").twists, again)


# -- bound calls -------------------------------------------------------------------------------------


def test_a_bound_call_follows_what_is_in_its_arrays():
    rng = np.random.default_rng(8)
    chain = SerialChain(random_joints(rng, 3))
    for states in ((), (11,)):
        q, out = chain.workspace(4, states)
        update = chain.bind(q, out)
        for _ in range(3):
            q[...] = rng.normal(size=q.shape)
            assert update()
            close(out, chain.twist_derivatives(q), 13)
    q[0] = 1e17
    if any(joint.kind not in ("prismatic", "fixed") for joint in chain.joints):
        assert not update()
    with pytest.raises(ValueError, match="q: expected an array of doubles"):
        chain.bind(q.tolist(), out)
    apart = np.zeros((6, 3, 4, chain.dof)).transpose(0, 2, 1, 3)  # states whose axes are not one in memory
    with pytest.raises(ValueError, match="axes of states are one in memory"):
        chain.bind(apart, np.zeros((5, 4, 3, 6)))
    with pytest.raises(ValueError, match="out: expected a writable array"):
        chain.bind(q, out[:4])


def test_a_bound_call_outlives_its_chain():
    joints = random_joints(np.random.default_rng(9), 3)
    chain = SerialChain(joints)
    q, out = chain.workspace(38)
    q[...] = 1
    expected = chain.twist_taylor(q / [[1.0 * factorial(k)] for k in range(40)])
    update = chain.bind(q, out)
    del chain
    assert update()
    close(out, expected * [[1.0 * factorial(k)] for k in range(39)], 11)


@pytest.mark.parametrize("kinds", [["revolute", "prismatic", "helical"], ["fixed"], ["planar", "universal"]])
def test_an_evaluator_follows_what_is_in_its_arrays(kinds):
    robot = tree(7, kinds)
    body = robot.bodies[-1]
    evaluate = robot.evaluator(body, 3, jacobians=2)
    assert evaluate.q.shape == (4, len(robot.positions)) and evaluate.twists.shape == (3, 6)
    for seed in range(3):
        q = np.random.default_rng(seed).normal(size=evaluate.q.shape)
        evaluate.q[...] = q
        assert evaluate()
        frame = robot.motion(q).frame(body)
        np.testing.assert_array_equal(evaluate.pose, frame.pose)
        np.testing.assert_array_equal(evaluate.twists, frame.twists)
        for k in range(2):
            np.testing.assert_array_equal(evaluate.jacobians[k], frame.jacobian(k))


def test_an_evaluator_of_a_ball_is_refused():
    with pytest.raises(ValueError, match="a robot without ball or floating joints"):
        tree(0, ["revolute", "ball"]).evaluator("b1", 2)
    robot = tree(0, ["revolute"])
    with pytest.raises(ValueError, match="no body 'hand'"):
        robot.evaluator("hand", 2)
    with pytest.raises(ValueError, match=r"jacobians: expected an integer from 0 to 3, got 4"):
        robot.evaluator("b0", 2, jacobians=4)
    with pytest.raises(ValueError, match=r"order: expected an integer from 1 to 170, got 0"):
        robot.evaluator("b0", 0)


# -- bad input ---------------------------------------------------------------------------------------


@pytest.mark.parametrize("states", [(), (10,)])
@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_numbers_that_are_not_finite_are_rejected_at_every_order(states, bad):
    chain = SerialChain(random_joints(np.random.default_rng(7), 3))
    for k in range(4):
        q = np.ones((4, *states, chain.dof))
        chain.twist_derivatives(q)
        q[k, ..., 0] = bad
        with pytest.raises(ValueError, match="finite"):
            chain.twist_derivatives(q)


# -- the kernel itself -------------------------------------------------------------------------------


def test_a_robot_can_be_copied_and_sent_to_another_process():
    robot = tree(1, ["revolute", "universal"])
    q = np.ones((3, 3))
    expected = robot.motion(q).frame("b1").twists
    for other in (copy.deepcopy(robot), pickle.loads(pickle.dumps(robot))):
        assert not other.engine._plans  # they hold addresses of what was copied
        np.testing.assert_array_equal(other.motion(q).frame("b1").twists, expected)


def test_numba_is_loaded_when_something_is_computed():
    program = """
import sys
import numpy as np
from workbench.kinematics import Robot, TreeJoint
robot = Robot("one", [TreeJoint("j", "revolute", "world", "b")])
motion = robot.motion(np.ones((3, 1)))
assert "numba" not in sys.modules and "pydrake" not in sys.modules
motion.frame("b").pose
assert "numba" in sys.modules and "pydrake" not in sys.modules
"""
    subprocess.run([sys.executable, "-c", program], check=True)


@pytest.mark.slow  # compiles a kernel for each processor
@pytest.mark.parametrize(
    "features, width",
    [("", 2), ("+avx,+avx2,+fma", 4), ("+avx,+avx2,+fma,+avx512vl", 4), ("+avx,+avx512f", 8)],
)
def test_the_kernel_is_the_same_for_registers_of_any_size(features, width, tmp_path):
    """LLVM splits registers that this machine does not have, so each runs where the instructions are."""
    there = {feature for feature, has in llvm.get_host_cpu_features().items() if has}
    if not {f[1:] for f in features.split(",") if f} <= there:
        pytest.skip("not on this processor")
    program = f"""
import sys
sys.path.insert(0, {os.path.dirname(__file__)!r})
import numpy as np
from kinematics.plain_tree import plain_motion
from kinematics.random_robots import tree
from workbench.kinematics import simd_lanes as lanes
assert lanes.WIDTH == {width}
rng = np.random.default_rng(1)
screws = ["revolute", "prismatic", "cylindrical", "helical"]
for kinds in (["helical"], ["helical"] * 7, screws * 2, None):
    robot = tree(1, kinds)
    body = robot.bodies[-1]
    for order in (1, 2, 3, 5, 8, 11):
        for states in (1, 3, 8, 17):
            q = rng.normal(size=(order + 1, states, len(robot.positions)))
            side_by_side = np.moveaxis(np.moveaxis(q, 1, -1).copy(), -1, 1)
            for given in (q, side_by_side):
                motion = robot.motion(given)
                frames = motion.frame(body), motion.frames[-1]
                X, V = plain_motion(robot.steps, robot.body(body), motion._input()[:, states - 1])
                for frame in (motion.frame(body), robot.motion(given).frames[-1]):
                    assert np.abs(frame.pose[states - 1] - X).max() < 1e-13
                    error = np.abs(frame.twists[:, states - 1] - V).max()
                    assert error <= 1e-12 * np.abs(V).max(), (kinds, order, states)
                if kinds is not None:
                    chain, coordinates = robot.chain(body)
                    at_origin = chain.twist_derivatives(given[..., coordinates])
                    frame = motion.frame(body)
                    error = np.abs(at_origin - frame.origin_twist).max()
                    assert error <= 1e-12 * np.abs(frame.twists).max(), (kinds, order, states)
"""
    chosen = {"NUMBA_CPU_NAME": "x86-64", "NUMBA_CPU_FEATURES": features, "NUMBA_CACHE_DIR": str(tmp_path)}
    subprocess.run([sys.executable, "-c", program], check=True, env=os.environ | chosen)


def test_a_bound_call_keeps_what_it_reads():
    """Neither the robot nor the plan nor the arguments are named any more when it is called."""
    q = np.random.default_rng(0).normal(size=(3, 4))
    robot = Robot("r", tree(2, ["revolute"] * 4).joints)
    right, step = robot.motion(q).frame("b3").twists.copy(), robot.evaluator("b3", 2)
    chain, out = SerialChain(random_joints(np.random.default_rng(3), 4)), np.empty((2, 6))
    wanted = np.random.default_rng(1).normal(size=(3, chain.dof))
    of_chain, bound = chain.twist_derivatives(wanted), chain.bind(wanted, out)
    step.q[:] = q
    del robot, chain, wanted
    gc.collect()
    spoilt = [np.full(size, np.nan) for size in (17, 500, 900, 1500) for _ in range(200)]
    assert step() and bound() and len(spoilt) == 800
    close(step.twists, right, 14)
    close(out, of_chain, 14)

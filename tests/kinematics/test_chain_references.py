"""The engine of serial chains against forward kinematics to fifty digits, and against Drake."""

import re
from math import factorial
from pathlib import Path

import numpy as np
import pytest
from kinematics.random_chains import MOVING, random_joint
from kinematics.taylor_kinematics import exact, joint, pose, product, twist
from numpy.polynomial import Chebyshev

from workbench.kinematics.chain import Joint, SerialChain
from workbench.kinematics.robot import Robot

# -- fifty digits -----------------------------------------------------------------------------------


def random_chain(seed, count, terms):
    """A chain of so many moving joints, and Taylor coefficients (terms + 1, dof)."""
    rng = np.random.default_rng(seed)
    chain = SerialChain([random_joint(rng, kind) for kind in rng.choice(MOVING, count)])
    return chain, rng.uniform(-1, 1, size=(terms + 1, chain.dof))


def exact_twists(chain, q):
    X, q = pose(terms=len(q)), exact(q)
    for j in chain.joints:
        own, q = q[:, : j.dof], q[:, j.dof :]
        there, back = (pose(place=exact(sign * j.point))[0] for sign in (1, -1))
        X = product(X @ there, joint(j.kind, own, j.axis, j.pitch)) @ back
    return twist(X)


def digits_lost(actual, exact):
    """log₁₀ of the error in units of 2⁻⁵², each order relative to its greatest component."""
    expected = exact.astype(float)
    scale = np.maximum(np.abs(expected).max(axis=1), 1e-3)
    error = np.abs(actual - expected).max(axis=1) / scale
    return np.log10(np.maximum(error / 2.0**-52, 1)).max()


@pytest.mark.parametrize("seed", range(2))
@pytest.mark.parametrize("count, order", [(1, 3), (2, 10), (7, 10), (7, 20), (20, 10)])
def test_the_rates_of_the_pose_to_fifty_digits_agree(seed, count, order):
    chain, q = random_chain(seed, count, order + 1)
    assert digits_lost(chain.twist_taylor(q), exact_twists(chain, q)) < 2


@pytest.mark.slow
def test_a_hundred_joints_to_order_twenty_lose_two_digits():
    chain, q = random_chain(0, 100, 21)
    assert digits_lost(chain.twist_taylor(q), exact_twists(chain, q)) < 2


def test_factorials_do_not_overflow():
    """Order 170 by derivatives, whose factorials are the largest, equals that by coefficients."""
    chain, q = random_chain(1, 3, 171)
    q *= 0.5 ** np.arange(172)[:, None]
    factorials = np.array([float(factorial(k)) for k in range(171)])
    derivatives = q.copy()
    derivatives[1:] *= factorials[:, None]
    derivatives[1:] *= np.arange(1, 172)[:, None]
    expected = chain.twist_taylor(q) * factorials[:, None]
    assert np.isfinite(expected).all()
    deviation = np.abs(chain.twist_derivatives(derivatives) - expected).max(axis=-1)
    assert (deviation <= 1e-12 * np.abs(expected).max(axis=-1)).all()


@pytest.mark.parametrize("turns", [1, -3, 10**3, 10**6, 10**9, 10**15, 10**17])
def test_large_angles_are_reduced_exactly(turns):
    """Beyond 2⁵⁰ rad the C library computes sines; below, the kernel reduces angles as exactly."""
    chain = SerialChain([Joint.revolute([0, 0, 1]), Joint.prismatic([1, 0, 0])])
    angle = 2 * np.pi * turns + 0.3
    V = chain.twist_derivatives(np.array([[[angle, 0.0]] * 9, [[0.0, 1.0]] * 9]))
    expected = [0, 0, 0, np.cos(angle), np.sin(angle), 0]
    np.testing.assert_allclose(V[0], [expected] * 9, rtol=0, atol=4e-16)


# -- Drake ----------------------------------------------------------------------------------------


def add_body(plant, name):
    from pydrake.multibody.tree import SpatialInertia

    return plant.AddRigidBody(name, SpatialInertia.SolidSphereWithDensity(1000, 0.1))


def offset_frame(plant, body, rng):
    from pydrake.math import RigidTransform, RollPitchYaw
    from pydrake.multibody.tree import FixedOffsetFrame

    X = RigidTransform(RollPitchYaw(*rng.normal(size=3)), rng.normal(size=3))
    return plant.AddFrame(FixedOffsetFrame(f"{body.name()}_{rng.integers(10**9)}", body, X))


def plant_of_all_joints(rng):
    """World, seven joints of the six kinds, tip; every second joint points towards the world
    (which Drake allows for prismatic and revolute joints and welds)."""
    from pydrake.math import RigidTransform
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    makers = [
        lambda name, F, M: tree.RevoluteJoint(name, F, M, [1, 2, 3]),
        lambda name, F, M: tree.PrismaticJoint(name, F, M, [3, -1, 2]),
        lambda name, F, M: tree.UniversalJoint(name, F, M),
        lambda name, F, M: tree.RevoluteJoint(name, F, M, [2, 0, -1]),
        lambda name, F, M: tree.ScrewJoint(name, F, M, [1, 0, 2], 0.7, 0.0),
        lambda name, F, M: tree.WeldJoint(name, F, M, RigidTransform([0.1, 0.2, 0.3])),
        lambda name, F, M: tree.PlanarJoint(name, F, M),
    ]
    inner = plant.world_body()
    for i, maker in enumerate(makers):
        outer = add_body(plant, f"body_{i}")
        ends = [offset_frame(plant, inner, rng), offset_frame(plant, outer, rng)]
        plant.AddJoint(maker(f"joint_{i}", *(ends if i % 2 == 0 else reversed(ends))))
        inner = outer
    plant.Finalize()
    return plant, inner


@pytest.mark.parametrize("seed", range(3))
def test_drake_agrees_on_pose_velocity_and_acceleration(seed):
    rng = np.random.default_rng(seed)
    plant, body = plant_of_all_joints(rng)
    chain, positions = Robot.from_plant(plant).chain(body.name())
    q, v, vdot = rng.normal(size=(3, plant.num_positions()))
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, q)
    plant.SetVelocities(context, v)
    X_WB = plant.EvalBodyPoseInWorld(context, body)
    V_WB = plant.EvalBodySpatialVelocityInWorld(context, body)
    A_WB = plant.CalcSpatialAccelerationsFromVdot(context, vdot)[int(body.index())]
    twist, twist_dot = chain.twist_derivatives(np.stack([q, v, vdot])[:, positions])
    p_WB = X_WB.translation()
    velocity = twist[3:] + np.cross(twist[:3], p_WB)
    acceleration = twist_dot[3:] + np.cross(twist_dot[:3], p_WB) + np.cross(twist[:3], velocity)
    near = {"rtol": 0, "atol": 1e-12}
    np.testing.assert_allclose(chain.pose(q[positions]), X_WB.GetAsMatrix4(), **near)
    np.testing.assert_allclose(twist[:3], V_WB.rotational(), **near)
    np.testing.assert_allclose(velocity, V_WB.translational(), **near)
    np.testing.assert_allclose(twist_dot[:3], A_WB.rotational(), **near)
    np.testing.assert_allclose(acceleration, A_WB.translational(), **near)


ROBOTS = Path(np.__file__).parents[1] / "cmeel.prefix/share/example-robot-data/robots"


@pytest.mark.parametrize(
    "urdf, root, tip",
    [
        ("panda_description/urdf/panda.urdf", "panda_link0", "panda_link8"),
        ("ur_description/urdf/ur5_robot.urdf", "", "tool0"),
    ],
)
def test_robots_agree_with_drake_on_a_path_to_order_six(urdf, root, tip):
    """Drake's V_WB at Chebyshev nodes in time, interpolated and differentiated six times."""
    from pydrake.multibody.parsing import Parser
    from pydrake.multibody.plant import MultibodyPlant

    if not (ROBOTS / urdf).exists():
        pytest.skip("example-robot-data is not installed")
    plant = MultibodyPlant(0.0)
    without_meshes = re.sub(r"<(visual|collision)\b.*?</\1>", "", (ROBOTS / urdf).read_text(), flags=re.S)
    Parser(plant).AddModelsFromString(without_meshes, "urdf")
    if root:
        plant.WeldFrames(plant.world_frame(), plant.GetFrameByName(root))
    plant.Finalize()
    body = plant.GetBodyByName(tip)
    chain, positions = Robot.from_plant(plant).chain(body.name())
    rng = np.random.default_rng(0)
    q = rng.uniform(-1, 1, size=(8, plant.num_positions()))
    context = plant.CreateDefaultContext()

    def twist_at(t):
        powers = np.array([t**k / factorial(k) for k in range(8)])
        plant.SetPositions(context, powers @ q)
        plant.SetVelocities(context, powers[:-1] @ q[1:])
        V_WB = plant.EvalBodySpatialVelocityInWorld(context, body)
        p_WB = plant.EvalBodyPoseInWorld(context, body).translation()
        at_origin = V_WB.translational() - np.cross(V_WB.rotational(), p_WB)
        return np.concatenate([V_WB.rotational(), at_origin])

    half = 0.6
    nodes = half * np.cos(np.pi * (np.arange(25) + 0.5) / 25)
    samples = np.array([twist_at(t) for t in nodes])
    V = chain.twist_derivatives(q[:, positions])
    for component in range(6):
        fit = Chebyshev.fit(nodes, samples[:, component], 24, domain=[-half, half])
        for k in range(7):
            scale = np.abs(V[k]).max()
            assert abs(fit.deriv(k)(0.0) - V[k, component]) < scale * 10.0 ** (k - 12), k


def test_every_joint_of_drake_s_moves_as_drake_says():
    """Ball, quaternion and rpy floating joints: position, velocity and acceleration, natively by Drake."""
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    rng = np.random.default_rng(3)
    plant = MultibodyPlant(0.0)
    inner = add_body(plant, "first")
    plant.AddJoint(tree.QuaternionFloatingJoint("free", plant.world_frame(), inner.body_frame()))
    for name, maker in (
        ("ball", lambda F, M: tree.BallRpyJoint("ball", F, M)),
        ("rpy", lambda F, M: tree.RpyFloatingJoint("rpy", F, M)),
        ("turn", lambda F, M: tree.RevoluteJoint("turn", F, M, [1, 2, 3])),
    ):
        outer = add_body(plant, name)
        plant.AddJoint(maker(offset_frame(plant, inner, rng), offset_frame(plant, outer, rng)))
        inner = outer
    plant.Finalize()
    robot = Robot.from_plant(plant)
    assert (len(robot.positions), len(robot.velocities)) == (plant.num_positions(), plant.num_velocities())
    q = rng.normal(size=plant.num_positions())
    q[:4] /= np.linalg.norm(q[:4])
    v, vdot = rng.normal(size=(2, plant.num_velocities()))
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, q)
    plant.SetVelocities(context, v)
    A = plant.CalcSpatialAccelerationsFromVdot(context, vdot)
    motion = robot.motion(q, np.stack([v, vdot]))
    for name in ("first", "ball", "rpy", "turn"):
        body = plant.GetBodyByName(name)
        frame = motion.frame(name)
        near = {"rtol": 0, "atol": 1e-11}
        np.testing.assert_allclose(
            frame.pose, plant.EvalBodyPoseInWorld(context, body).GetAsMatrix4(), **near
        )
        V = plant.EvalBodySpatialVelocityInWorld(context, body).get_coeffs()
        np.testing.assert_allclose(frame.twist(0), V, **near)
        np.testing.assert_allclose(frame.twist(1), A[int(body.index())].get_coeffs(), **near)
        J = plant.CalcJacobianSpatialVelocity(
            context,
            tree.JacobianWrtVariable.kV,
            body.body_frame(),
            [0.1, 0.2, 0.3],
            *[plant.world_frame()] * 2,
        )
        np.testing.assert_allclose(frame.jacobian(point=(0.1, 0.2, 0.3)), J, **near)
    qdot = plant.MapVelocityToQDot(context, v)
    by_rates = robot.motion(np.stack([q, qdot]))
    np.testing.assert_allclose(by_rates.rates[0], v, atol=1e-12)


def test_bodies_of_one_name_are_asked_by_their_model():
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    inertia = tree.SpatialInertia.SolidSphereWithDensity(1000, 0.1)
    for model in ("left", "right"):
        instance = plant.AddModelInstance(model)
        hand = plant.AddRigidBody("hand", instance, inertia)
        plant.AddJoint(tree.RevoluteJoint("wrist", plant.world_frame(), hand.body_frame(), [0, 0, 1]))
    plant.Finalize()
    robot = Robot.from_plant(plant)
    assert robot.bodies == ("left::hand", "right::hand")
    motion = robot.motion(np.array([[0.0, 0.0], [1.0, 2.0]]))
    np.testing.assert_allclose(motion.frame("right::hand").twist().angular, [0, 0, 2])
    with pytest.raises(
        ValueError, match="more than one body 'hand': expected one of left::hand, right::hand"
    ):
        motion.frame("hand")


def test_unsupported_plants_are_rejected_with_the_reason():
    from pydrake.multibody import tree
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    arm, leg = (add_body(plant, name) for name in ("arm", "leg"))
    with pytest.raises(ValueError, match="expected a finalized plant"):
        Robot.from_plant(plant)
    plant.AddJoint(tree.BallRpyJoint("socket", plant.world_frame(), arm.body_frame()))
    plant.AddJoint(tree.BallRpyJoint("hip", leg.body_frame(), arm.body_frame()))
    try:
        plant.Finalize()
    except RuntimeError:
        pytest.skip("this Drake builds no such tree")
    with pytest.raises(
        ValueError, match=r"joint 'hip': expected one from the world outwards .* got ball_rpy"
    ):
        Robot.from_plant(plant)

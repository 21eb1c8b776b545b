"""Inverse dynamics and its time derivatives, against Drake."""

import numpy as np
import pytest
from drake_arms import arm_plant
from kinematics.points_of_mass import torque_derivatives
from kinematics.random_robots import motion, tree

from workbench.kinematics.robot import Robot


def drakes_torques(plant, q, v, vdot):
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, q)
    plant.SetVelocities(context, v)
    from pydrake.multibody.tree import MultibodyForces

    forces = MultibodyForces(plant)
    plant.CalcForceElementsContribution(context, forces)  # gravity
    return plant.CalcInverseDynamics(context, vdot, forces)


def floating_plant():
    """An arm on a floating base."""
    from pydrake.multibody import tree as parts
    from pydrake.multibody.plant import MultibodyPlant

    plant = MultibodyPlant(0.0)
    inertia = parts.SpatialInertia.SolidBoxWithMass(3.0, 0.2, 0.3, 0.5)
    base, link = plant.AddRigidBody("base", inertia), plant.AddRigidBody("link", inertia)
    plant.AddJoint(parts.QuaternionFloatingJoint("free", plant.world_frame(), base.body_frame()))
    plant.AddJoint(parts.RevoluteJoint("turn", base.body_frame(), link.body_frame(), [1, 2, 3]))
    plant.Finalize()
    return plant


def test_torques_are_drake_s_inverse_dynamics():
    plant = arm_plant()
    robot = Robot.from_plant(plant)
    q = np.random.default_rng(0).normal(size=(3, 4, 6))
    found = robot.motion(q).torques()
    assert found.shape == (1, 4, 6)
    for state in range(4):
        right = drakes_torques(plant, *q[:, state])
        np.testing.assert_allclose(found[0, state], right, rtol=0, atol=1e-11 * np.abs(right).max())


def test_forces_on_a_floating_base_are_drake_s():
    plant = floating_plant()
    robot = Robot.from_plant(plant)
    rng = np.random.default_rng(0)
    q, v = rng.normal(size=plant.num_positions()), rng.normal(size=(2, plant.num_velocities()))
    q[:4] /= np.linalg.norm(q[:4])
    found = robot.motion(q, v).torques()
    right = drakes_torques(plant, q, *v)
    np.testing.assert_allclose(found[0], right, rtol=0, atol=1e-12 * np.abs(right).max())


def test_torque_rates_are_derivatives_of_drake_s_torques():
    """By a fit of Chebyshev polynomials to Drake's torques along the path."""
    plant = arm_plant(seed=2)
    robot, order = Robot.from_plant(plant), 3
    q = np.random.default_rng(2).uniform(-1, 1, size=(order + 6, 6))
    found = robot.motion(q).torques(order)

    def torques_at(t):
        rows = []
        for k in range(3):
            factor = np.cumprod([1, *(t / i for i in range(1, len(q) - k))])
            rows.append(np.tensordot(factor, q[k:], axes=1))
        return drakes_torques(plant, *rows)

    half = 0.25
    times = half * np.cos(np.pi * (np.arange(40) + 0.5) / 40)
    fit = np.polynomial.chebyshev.Chebyshev
    values = np.array([torques_at(t) for t in times])
    for joint in range(6):
        series = fit.fit(times, values[:, joint], 24, domain=[-half, half])
        for k in range(order + 1):
            right = series.deriv(k)(0.0) if k else series(0.0)
            scale = np.abs(values).max() * (10 / half) ** k
            np.testing.assert_allclose(found[k, joint], right, rtol=0, atol=1e-11 * scale)


def test_the_power_of_all_forces_is_the_rate_of_the_energy():
    """τ · q̇ = d/dt (T + U): d'Alembert's principle against energies from points' velocities."""
    robot, h = Robot.from_plant(arm_plant(seed=3)), 1e-4
    q = np.random.default_rng(3).normal(size=(6, 6))

    def energy(t):
        rows = []
        for k in range(2):
            factor = np.cumprod([1, *(t / i for i in range(1, len(q) - k))])
            rows.append(np.tensordot(factor, q[k:], axes=1))
        total = 0.0
        now = robot.motion(np.array(rows))
        for name, body in robot.inertias.items():
            frame = now.frame(name)
            com, R = frame.point(body.com), frame.pose[:3, :3]
            omega = R.T @ frame.twist(0).angular
            total += 0.5 * body.mass * com.velocity @ com.velocity + 0.5 * omega @ body.inertia @ omega
            total += body.mass * 9.81 * com.position[2]
        return total

    power = (energy(h) - energy(-h)) / (2 * h)
    np.testing.assert_allclose(robot.motion(q).torques()[0] @ q[1], power, rtol=1e-6)


def test_torques_need_inertias_and_accelerations():
    found = motion(tree(0, ["revolute"]), 3)
    with pytest.raises(ValueError, match=r"expected a robot with inertias \(`from_urdf`, "):
        found.torques()
    robot = Robot.from_plant(arm_plant(1))
    with pytest.raises(ValueError, match="expected a motion of order 2"):
        robot.motion(np.zeros((2, 1))).torques()
    with pytest.raises(ValueError, match="order: expected an integer from 0 to 1, got 2"):
        robot.motion(np.zeros((4, 1))).torques(2)
    with pytest.raises(ValueError, match="gravity: expected three numbers"):
        robot.motion(np.zeros((4, 1))).torques(0, gravity=-9.81)
    assert not robot.motion(np.zeros((4, 1))).torques(1, gravity=(0, 0, 0)).any()


def test_torques_and_their_rates_are_those_of_mass_points():
    """τ, τ̇, τ̈ by differences of positions that are right to 40 digits, and Drake's τ beside them."""
    plant = arm_plant(4, seed=5)
    robot = Robot.from_plant(plant)
    q = np.random.default_rng(5).uniform(-1, 1, size=(5, 4))
    right = torque_derivatives(robot, q)
    found = robot.motion(q).torques(2)
    for k in range(3):
        np.testing.assert_allclose(found[k], right[k], rtol=0, atol=1e-13 * np.abs(right[k]).max())
    np.testing.assert_allclose(
        right[0], drakes_torques(plant, *q[:3]), rtol=0, atol=1e-13 * np.abs(right[0]).max()
    )


INERTIAL = """<inertial><origin xyz="0.1 -0.2 0.3" rpy="0.4 0.5 0.6"/><mass value="2"/>
  <inertia ixx="0.03" ixy="0.001" ixz="0.002" iyy="0.04" iyz="0.003" izz="0.05"/></inertial>"""
HAND = f"""<robot name="hand"><link name="palm">{INERTIAL}</link><link name="upper">{INERTIAL}</link>
<link name="lower">{INERTIAL}</link><link name="tip"><inertial><mass value="0.5"/><inertia ixx="0.01" iyy="0.01" izz="0.01"/>
</inertial></link><joint name="j" type="continuous"><parent link="palm"/><child link="upper"/><origin xyz="0.3 0.1 0" rpy="0.1 0.2 0.3"/>
<axis xyz="1 2 -3"/></joint><joint name="k" type="prismatic"><parent link="upper"/><child link="lower"/><origin xyz="0 0.2 0"/>
<axis xyz="0 -1 0"/>MIMIC</joint><joint name="w" type="fixed"><parent link="lower"/><child link="tip"/><origin rpy="1 0 0"/></joint></robot>"""


def hand(tmp_path, mimic):
    path = tmp_path / "hand.urdf"
    path.write_text(HAND.replace("MIMIC", mimic))
    return path


@pytest.mark.parametrize("base", ["fixed", "floating"])
def test_inertias_of_a_urdf_are_those_of_drake_s_parser(tmp_path, base):
    path = hand(tmp_path, "")
    ours, drakes = Robot.from_urdf(path, base), Robot.from_file(path, base)
    assert ours.inertias.keys() == drakes.inertias.keys()
    for name, body in ours.inertias.items():
        for mine, right in zip(body, drakes.inertias[name], strict=True):
            np.testing.assert_allclose(mine, right, rtol=0, atol=1e-14)
    q, v = np.zeros(len(ours.positions)), np.random.default_rng(0).normal(size=(3, len(ours.velocities)))
    q[:] = np.random.default_rng(1).normal(size=len(q))
    found, right = (robot.motion(q, v).torques(1) for robot in (ours, drakes))
    np.testing.assert_allclose(found, right, rtol=0, atol=1e-12 * np.abs(right).max())


def test_torques_of_mimic_joints_act_on_what_they_follow(tmp_path):
    """Virtual work: τ · δq is that of the same motion with all joints free."""
    free = Robot.from_urdf(hand(tmp_path, ""))
    robot = Robot.from_urdf(hand(tmp_path, '<mimic joint="j" multiplier="-0.7" offset="0.2"/>'))
    q = np.random.default_rng(0).normal(size=(4, 1))
    M, c = robot.follow(free.positions)
    followed = q @ M.T
    followed[0] += c
    right = free.motion(followed).torques(1) @ M
    np.testing.assert_allclose(robot.motion(q).torques(1), right, rtol=0, atol=1e-12)


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        ('<mass value="2"/>', "", "link 'palm': inertial: expected a <mass>, got none"),
        ('<mass value="2"/>', "<mass/>", "link 'palm': inertial: mass: expected an attribute 'value'"),
        (
            '<mass value="2"/>',
            '<mass value="-2"/>',
            "link 'palm': inertial: expected a mass >= 0 in kg, got -2.0",
        ),
        ('ixx="0.03"', 'ixx="a"', "link 'palm': inertial: expected a finite number for ixx, got 'a'"),
        (
            'rpy="0.4 0.5 0.6"',
            'rpy="0.4"',
            "link 'palm': inertial: origin: expected 3 finite numbers for rpy",
        ),
    ],
)
def test_a_wrong_inertia_is_said_where_torques_are_asked_for(tmp_path, right, wrong, message):
    path = hand(tmp_path, "")
    path.write_text(path.read_text().replace(right, wrong, 1))
    motion = Robot.from_urdf(path).motion(np.zeros((3, 2)))
    assert motion.frame("tip").pose.shape == (4, 4)
    with pytest.raises(ValueError, match=message):
        motion.torques()

"""Inverse dynamics and its time derivatives, against Drake."""

import numpy as np
import pytest
from drake_arms import arm_plant
from points_of_mass import torque_derivatives
from random_robots import motion, tree

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
    with pytest.raises(ValueError, match=r"expected a robot with inertias \(`from_plant`, `from_file`\)"):
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

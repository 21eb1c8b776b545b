"""Inverse dynamics at 40 digits of mass points alone: nothing but positions, and differences of them.

A rigid body is six equal mass points on its principal axes of second moments; d'Alembert's principle gives τᵢ =
Σ m (p̈ − g) · ∂p/∂qᵢ. Time derivatives of p and τ and the slopes ∂p/∂q are central differences.
"""

import mpmath
from mpmath import mp, mpf

STEP = mpf(10) ** -20  # the error of a central difference is its square
DIGITS = 140  # of which second differences of second differences lose 80


def exact(array):
    return mpmath.matrix([[mpf(float(x)) for x in row] for row in array])


class MassPoints:
    """A serial arm of revolute and prismatic joints whose bodies are mass points."""

    def __init__(self, robot, gravity=(0.0, 0.0, -9.81)):
        with mp.workdps(DIGITS):
            self.joints = [joint for joint in robot.joints if joint.kind != "fixed"]
            self.constant = [(exact(j.X_PF), exact(j.X_MC)) for j in self.joints]
            self.gravity = [mpf(x) for x in gravity]
            self.points = [self._of_body(robot.inertias[j.child]) for j in self.joints]

    @staticmethod
    def _of_body(body):
        """(mass, position in the body's frame) of six points."""
        tensor, mass = exact(body.inertia), mpf(float(body.mass))
        half = sum(tensor[i, i] for i in range(3)) / 2
        second, axes = mpmath.eigsy(half * mpmath.eye(3) - (tensor + tensor.T) / 2)
        com = [mpf(float(x)) for x in body.com]
        found = []
        for k in range(3):
            arm = mpmath.sqrt(3 * second[k] / mass)
            for sign in (1, -1):
                found.append(
                    (mass / 6, mpmath.matrix([*(com[i] + sign * arm * axes[i, k] for i in range(3)), 1]))
                )
        return found

    def positions(self, q):
        """(mass, position) of all points."""
        X, found = mpmath.eye(4), []
        for joint, (before, after), points, angle in zip(
            self.joints, self.constant, self.points, q, strict=True
        ):
            X = X * before * _motion(joint, angle) * after
            found += [(mass, X * p) for mass, p in points]
        return found

    def torques(self, path, t):
        """τ at the time t on a path, t → coordinates."""
        now, h = path(t), STEP
        before, at, after = (self.positions(path(t + k * h)) for k in (-1, 0, 1))
        forces = [
            [mass * ((c[i] - 2 * b[i] + a[i]) / h**2 - self.gravity[i]) for i in range(3)]
            for (mass, a), (_, b), (_, c) in zip(before, at, after, strict=True)
        ]
        found = []
        for i in range(len(now)):
            ends = [self.positions([x + sign * h * (k == i) for k, x in enumerate(now)]) for sign in (1, -1)]
            pairs = zip(*ends, forces, strict=True)
            found.append(sum(f[k] * (a[k] - b[k]) / (2 * h) for (_, a), (_, b), f in pairs for k in range(3)))
        return found


def _motion(joint, q):
    length = mpmath.sqrt(sum(mpf(float(x)) ** 2 for x in joint.axis))
    axis = [mpf(float(x)) / length for x in joint.axis]
    X = mpmath.eye(4)
    if joint.kind == "prismatic":
        for i in range(3):
            X[i, 3] = q * axis[i]
        return X
    x, y, z = axis
    K = mpmath.matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    X[:3, :3] = mpmath.eye(3) + mpmath.sin(q) * K + (1 - mpmath.cos(q)) * K * K
    return X


def torque_derivatives(robot, q_derivatives):
    """τ, τ̇, τ̈ at the time 0 on the polynomial with these derivatives, lists of floats."""
    points = MassPoints(robot)
    with mp.workdps(DIGITS):
        rows = [
            [mpf(float(x)) / mpmath.factorial(k) for k, x in enumerate(column)] for column in q_derivatives.T
        ]

        def path(t):
            return [mpmath.polyval(row[::-1], t) for row in rows]

        h = STEP
        before, now, after = (points.torques(path, k * h) for k in (-1, 0, 1))
        slopes = [(c - a) / (2 * h) for a, c in zip(before, after, strict=True)]
        bends = [(c - 2 * b + a) / h**2 for a, b, c in zip(before, now, after, strict=True)]
        return [[float(x) for x in values] for values in (now, slopes, bends)]

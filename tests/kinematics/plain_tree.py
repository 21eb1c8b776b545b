"""Poses, twists and Jacobian columns of a tree of steps in plain NumPy, about the world's origin.

It shares the steps with the kernel and nothing else: V = V_P + Σ C q̇, Ċ = [V_P, C], one state at a time.
"""

from math import factorial

import numpy as np

from workbench.kinematics.trees.tree_steps import WORLD


def bracket(V, C):
    return np.concatenate([np.cross(V[:3], C[:3]), np.cross(V[:3], C[3:]) + np.cross(V[3:], C[:3])])


def rotation(axis, angle):
    K = np.cross(np.eye(3), axis)
    return np.eye(3) + np.sin(angle) * K + 2 * np.sin(angle / 2) ** 2 * K @ K


def homogeneous(R, p):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = R, p
    return X


def drive(series, d):
    """Taylor coefficients of an angle or shift from those of the channels (N + 1, channels)."""
    values = d.factor * series[:, d.channel]
    values[0] += d.offset
    return values


def screws(step, X, series):
    """Of a step whose frame is at X: its screws (6,) about the world's origin, each with its coefficients."""
    joint, R, p = step.joint, X[:3, :3], X[:3, 3]
    if joint is None:
        channels = series[:, step.turn.channel + 1 : step.turn.channel + 4]
        return [(np.concatenate([R[:, i], np.cross(p, R[:, i])]), channels[:, i]) for i in range(3)]
    axis, found = R @ joint.axis, []
    if step.turn is not None:
        point = R @ joint.point + p
        found.append((np.concatenate([axis, np.cross(point, axis)]), drive(series, step.turn)))
    if step.slide is not None:
        found.append((np.concatenate([np.zeros(3), axis]), drive(series, step.slide)))
    return found


def moved(step, series):
    """X_FM of a step."""
    if step.joint is None:
        w, x, y, z = series[0, step.turn.channel : step.turn.channel + 4]
        u = np.cross(np.eye(3), [x, y, z])
        return homogeneous(np.eye(3) + 2 * (w * u + u @ u), np.zeros(3))
    R, p = np.eye(3), np.zeros(3)
    if step.turn is not None:
        R = rotation(step.joint.axis, drive(series, step.turn)[0])
        p = step.joint.point - R @ step.joint.point
    if step.slide is not None:
        p = p + drive(series, step.slide)[0] * step.joint.axis
    return homogeneous(R, p)


def plain_motion(steps, frame, channels):
    """Of one frame (after, X_MB): its pose (4, 4) and its twist derivatives (N, 6), Drake's, from the derivatives
    of the channels (N + 1, channels)."""
    N = len(channels) - 1
    scale = np.array([float(factorial(k)) for k in range(N + 1)])
    series = channels / scale[:, None]
    way, at = [], frame.after
    while at != WORLD:
        way.insert(0, at)
        at = steps[at].parent
    X, V = np.eye(4), np.zeros((N, 6))
    for at in way:
        X = X @ steps[at].before
        own = np.zeros((N, 6))
        for screw, q in screws(steps[at], X, series):
            C = [screw]
            for k in range(N - 1):
                C.append(sum(bracket(V[j], C[k - j]) for j in range(k + 1)) / (k + 1))
            for k in range(N):
                own[k] += sum(C[j] * (k - j + 1) * q[k - j + 1] for j in range(k + 1))
        V, X = V + own, X @ moved(steps[at], series)
    X = X @ frame.X_MB
    p, twists = [X[:3, 3]], []
    for k in range(N):
        moving = V[k, 3:] + sum(np.cross(V[k - j, :3], p[j]) for j in range(k + 1))
        p.append(moving / (k + 1))
        twists.append(scale[k] * np.concatenate([V[k, :3], moving]))
    return X, np.array(twists).reshape(N, 6)

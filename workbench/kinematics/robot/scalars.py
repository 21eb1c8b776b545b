"""A frame's motion on any scalars: Drake's Expression and AutoDiffXd, CasADi's SX, JAX arrays.

This is the recursion of `tree_kernel`, one state at a time, on any scalars with addition, multiplication and
sine.
"""

from __future__ import annotations

import math
import sys
from collections.abc import Callable
from math import factorial
from typing import Any, NamedTuple

import numpy as np

from workbench.kinematics.robot.states import States
from workbench.kinematics.robot.structure import Structure
from workbench.kinematics.trees.tree_steps import WORLD, Drive, Step


class Arithmetic(NamedTuple):
    """Functions of scalars and of vectors of three: sin, cos, cross, and a vector of three constants."""

    sin: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    cross: Callable[[Any, Any], Any]
    vector: Callable[[list[float]], Any]


class ScalarMotion(NamedTuple):
    """columns: the three of the rotation R_WF, vectors; origin: p_WFo; twists: N pairs of vectors, ω and the
    velocity of Fo and their derivatives."""

    columns: tuple[Any, Any, Any]
    origin: Any
    twists: list[tuple[Any, Any]]


class _Frame(NamedTuple):
    """R, and Taylor coefficients of the origin and the angular velocity."""

    R: tuple[Any, Any, Any]
    p: list[Any]
    w: list[Any]


def frame_motion(
    robot: Structure, body: str, q: Callable[[int, int], Any], order: int, arithmetic: Arithmetic
) -> ScalarMotion:
    """Returns the motion of a body's frame; q(k, i) is the k-th derivative of coordinate i, k <= order.

    Raises ValueError for an unknown body and for a robot with ball or floating joints.
    """
    robot.require_rates("this arithmetic")
    frame = robot.body(body)
    way: list[Step] = []
    at = frame.after
    while at != WORLD:
        way.insert(0, robot.steps[at])
        at = robot.steps[at].parent
    zero = arithmetic.vector([0.0, 0.0, 0.0])
    axes = tuple(arithmetic.vector(list(row)) for row in np.eye(3))
    now = _Frame(axes, [zero] * (order + 1), [zero] * order)
    for step in way:
        now = _after(step, now, q, order, arithmetic)
    offset = _carried(_turned(now.R, frame.X_MB[:3, 3]), now.w, order, arithmetic)
    p = [a + b for a, b in zip(now.p, offset, strict=True)]
    columns = tuple(_turned(now.R, column) for column in frame.X_MB[:3, :3].T)
    twists = [(factorial(k) * now.w[k], factorial(k + 1) * p[k + 1]) for k in range(order)]
    return ScalarMotion(columns, p[0], twists)


def _after(step: Step, now: _Frame, q: Callable[[int, int], Any], order: int, do: Arithmetic) -> _Frame:
    assert step.joint is not None, "no ball is left"
    point = step.joint.point if step.turn is not None else np.zeros(3)
    X = step.before
    offset = _carried(_turned(now.R, X[:3, 3] + X[:3, :3] @ point), now.w, order, do)
    axis = _carried(_turned(now.R, X[:3, :3] @ step.joint.axis), now.w, order, do)
    R = tuple(_turned(now.R, column) for column in X[:3, :3].T)
    p, w = [a + b for a, b in zip(now.p, offset, strict=True)], now.w
    if step.slide is not None:
        d = _coefficients(step.slide, q, order)
        p = [p[k] + sum(d[k - j] * axis[j] for j in range(k + 1)) for k in range(order + 1)]
    if step.turn is not None:
        a = _coefficients(step.turn, q, order)
        w = [w[k] + sum(((k - j + 1) * a[k - j + 1]) * axis[j] for j in range(k + 1)) for k in range(order)]
        c, s = do.cos(a[0]), do.sin(a[0])
        R = tuple(_rotated(c, s, axis[0], column, do) for column in R)
    if step.turn is not None and point.any():
        back = _carried(_turned(R, -point), w, order, do)
        p = [a + b for a, b in zip(p, back, strict=True)]
    return _Frame(R, p, w)


def _coefficients(drive: Drive, q: Callable[[int, int], Any], order: int) -> list[Any]:
    values = [(drive.factor / factorial(k)) * q(k, drive.channel) for k in range(order + 1)]
    return [values[0] + drive.offset, *values[1:]]


def _turned(R: tuple[Any, Any, Any], v: np.ndarray) -> Any:
    """Returns R v of constant numbers v, without the zeros."""
    terms = [float(x) * column for x, column in zip(v, R, strict=True) if x != 0]
    return sum(terms[1:], start=terms[0]) if terms else 0.0 * R[0]


def _carried(u: Any, w: list[Any], order: int, do: Arithmetic) -> list[Any]:
    """Returns the coefficients of a vector u that turns with w: u' = w × u."""
    found = [u]
    for k in range(order):
        total = do.cross(w[0], found[k])
        for j in range(1, k + 1):
            total = total + do.cross(w[j], found[k - j])
        found.append((1.0 / (k + 1)) * total)
    return found


def _rotated(c: Any, s: Any, axis: Any, v: Any, do: Arithmetic) -> Any:
    """Returns v turned about a unit axis (Rodrigues): v + sin axis × v + (1 − cos) axis × (axis × v)."""
    across = do.cross(axis, v)
    return v + s * across + (1.0 - c) * do.cross(axis, across)


# -- exports ------------------------------------------------------------------------------------------


def object_motion(robot: Structure, body: str, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the pose (4, 4) and the twists (N, 6) of a body, of objects q (N + 1, positions) that NumPy
    can add and multiply: Drake's Expression and AutoDiffXd, SymPy's, and numbers."""
    with np.errstate(invalid="ignore"):  # Expressions turn the processor's flags up
        found = frame_motion(robot, body, lambda k, i: q[k, i], len(q) - 1, _OBJECTS)
    pose = np.eye(4).astype(object)
    pose[:3, :3], pose[:3, 3] = np.stack(found.columns, axis=-1), found.origin
    return pose, np.array([np.concatenate(pair) for pair in found.twists], dtype=object)


def autodiff_motion(robot: Structure, body: str, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Returns the same of Drake's AutoDiffXd q (N + 1, positions), whose gradients are not taken through the
    recursion: they are the partial derivatives in closed form (`partials`) times the gradients of q."""
    from workbench.drake.gate import AutoDiffXd

    sizes = {x.derivatives().size for x in q.flat} - {0}
    if len(sizes) > 1:
        raise ValueError(f"q_derivatives: expected gradients of one size, got {sorted(sizes)}")
    size = sizes.pop() if sizes else 0
    slopes = np.zeros((*q.shape, size))
    for at, x in np.ndenumerate(q):
        if x.derivatives().size:
            slopes[at] = x.derivatives()
    values = robot.derivatives([[x.value() for x in row] for row in q], len(q) - 1)
    frame = States(robot, values).frame(body)
    J = frame.jacobian_derivatives(0)[0] @ slopes[0]  # of the frame's turning and of its origin
    of_pose = np.zeros((4, 4, size))
    of_pose[:3, :3] = np.cross(J[:3].T[:, None], frame.pose[:3, :3].T[None]).transpose(2, 1, 0)
    of_pose[:3, 3] = J[3:]
    of_twists = [
        sum(partial @ slope for partial, slope in zip(frame.twist_partials(k), slopes, strict=False))
        for k in range(len(q) - 1)
    ]

    def joined(values: np.ndarray, gradients: np.ndarray) -> np.ndarray:
        found = np.empty(values.shape, dtype=object)
        for at in np.ndindex(values.shape):
            found[at] = AutoDiffXd(values[at], gradients[at])
        return found

    return joined(frame.pose, of_pose), joined(frame.twists, np.stack(of_twists))


def _object_cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def _object_function(name: str) -> Callable[[Any], Any]:
    """Returns sin or cos of numbers, of objects that have this method, and of SymPy's."""

    def function(x: Any) -> Any:
        if isinstance(x, float | int):
            return getattr(math, name)(x)
        if hasattr(x, name):
            return getattr(x, name)()
        return getattr(sys.modules["sympy"], name)(x)  # the caller's, which made x

    return function


_OBJECTS = Arithmetic(
    _object_function("sin"),
    _object_function("cos"),
    _object_cross,
    lambda v: np.array(v, dtype=object),
)


def casadi_function(robot: Structure, body: str, order: int) -> Any:
    """Returns a casadi.Function q (positions, N + 1) → pose (4, 4), twists (6, N) of a body, N = order.

    Columns are orders. Raises ImportError where CasADi is not installed.
    """
    try:
        import casadi
    except ImportError:
        raise ImportError("this function needs CasADi: pip install casadi") from None
    q = casadi.SX.sym("q", len(robot.positions), order + 1)
    arithmetic = Arithmetic(casadi.sin, casadi.cos, casadi.cross, casadi.SX)
    found = frame_motion(robot, body, lambda k, i: q[i, k], order, arithmetic)
    top = casadi.horzcat(*found.columns, found.origin)
    pose = casadi.vertcat(top, casadi.SX([[0.0, 0.0, 0.0, 1.0]]))
    twists = casadi.horzcat(*(casadi.vertcat(*pair) for pair in found.twists))
    return casadi.Function("frame_motion", [q], [pose, twists], ["q"], ["pose", "twists"])


def jax_function(robot: Structure, body: str, order: int) -> Callable[[Any], tuple[Any, Any]]:
    """Returns a function of JAX arrays q (N + 1, positions) → pose (4, 4), twists (N, 6) of a body, N =
    order, for jax.jit, jax.vmap and jax.jacfwd. Raises ImportError where JAX is not installed."""
    try:
        import jax.numpy as jnp
    except ImportError:
        raise ImportError("this function needs JAX: pip install jax") from None
    arithmetic = Arithmetic(jnp.sin, jnp.cos, jnp.cross, jnp.array)

    def motion(q: Any) -> tuple[Any, Any]:
        found = frame_motion(robot, body, lambda k, i: q[k, i], order, arithmetic)
        top = jnp.stack([*found.columns, found.origin], axis=-1)
        pose = jnp.concatenate([top, jnp.array([[0.0, 0.0, 0.0, 1.0]])])
        return pose, jnp.stack([jnp.concatenate(pair) for pair in found.twists])

    return motion

"""Twist derivatives of a serial chain, to any order, for one state or a batch of them.

The chain is a product of joint motions, Eq. (117) of *Higher-Order Kinematics in Dual Lie Algebra*,

    X(q) = J₁(q₁) · J₂(q₂) ⋯ J_m(q_m),

and what comes out is the dual twist ₀ω̲_m of the last body relative to the base, Eq. (119), with its time
derivatives to order n, in O(m n²) operations (`chain_kernel`). The closed form (133) is a reference to
compare with, not the way to compute.

Conventions: radian, metre, second. A twist is (ω; v), six numbers in base coordinates, v being the velocity
of the body point that is at the base origin at that instant (the chapter's dual part)."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from math import inf
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy import empty, ndarray
from numpy.typing import ArrayLike

from workbench.kinematics.bound_calls import BoundCall
from workbench.kinematics.chain_joints import Joint
from workbench.kinematics.one_state import require_order
from workbench.kinematics.trees.tree_engine import TreeEngine, compute
from workbench.kinematics.trees.tree_steps import HIGHEST_DERIVATIVE_ORDER, WORLD, Drive, Frame, Step

if TYPE_CHECKING:
    from workbench.kinematics.trees.tree_plan import Plan

__all__ = ["Joint", "SerialChain"]

TIP = "tip"
DOUBLE = np.dtype(np.float64)


class SerialChain:
    """A serial chain of revolute, prismatic, cylindrical, helical and fixed joints.

    `dof` is the number of joint coordinates: one a joint, two (angle, then slide) a cylindrical
    joint, none a fixed one; they are ordered from the base to the tip. `home` is the pose (4, 4) of
    the last body in the base frame at q = 0.
    """

    def __init__(self, joints: Iterable[Joint]):
        self.joints = tuple(joints)
        for position, joint in enumerate(self.joints):
            if not isinstance(joint, Joint):
                raise TypeError(f"joint {position}: expected a Joint, got {type(joint).__name__}")
        steps: list[Step] = []
        self.home, X, self.dof = np.eye(4), np.eye(4), 0
        for joint in self.joints:
            if joint.kind == "fixed":
                self.home, X = self.home @ joint.transform, X @ joint.transform
                continue
            steps.append(_step(len(steps) - 1 if steps else WORLD, X, joint, self.dof))
            X, self.dof = np.eye(4), self.dof + joint.dof
        if self.dof == 0:
            raise ValueError("expected a chain with at least one moving joint, got none")
        self._of_poses = TreeEngine(steps, {TIP: Frame(len(steps) - 1, X)}, self.dof, self.dof)
        # by the shape of a state; of Taylor coefficients, or None for derivatives that were warned of
        self._plans: dict[tuple[tuple[int, int], bool | None], Plan] = {}

    def twist_derivatives(
        self, q: ArrayLike, out: np.ndarray | None = None, order: int | None = None
    ) -> np.ndarray:
        """Returns the twist of the last body and its time derivatives, Eq. (119) differentiated.

        q: (n + 2, ..., dof), where q[k, ..., i] is the k-th time derivative of coordinate i, from
           the coordinate itself (k = 0) to order n + 1. The axes between are states.
        out: if given, the result is written there (spares large batches the fresh memory).
        order: n; where it is given another number of rows is refused. Without it a table (rows, dof)
           is taken for the derivatives of one state, with a warning the first time.
        Returns (n + 1, ..., 6): entry k is d^k/dt^k (ω; v) in rad/s^{k+1} and m/s^{k+1}.

        Raises ValueError for a wrong shape, a complex array, a NaN or an infinity, or n > 170 (whose
        factorials exceed the doubles: use `twist_taylor`).
        """
        if out is None and order is None and type(q) is ndarray and q.dtype is DOUBLE and q.ndim == 2:
            plan, numbers = self._plans.get((q.shape, None)), q.ravel()
            if plan is not None and numbers.dot(numbers) < inf:  # a state as before: only its numbers are new
                twists = empty((len(q) - 1, 6))
                if plan.kernel(q[:, None], plan.address, twists[None, None], False):
                    return twists
        q = self._checked(q)
        require_order(q, order, "(n + 2, states, dof)", extra=2)
        if len(q) - 2 > HIGHEST_DERIVATIVE_ORDER:
            raise ValueError(
                f"expected derivatives to order at most {HIGHEST_DERIVATIVE_ORDER}, got {len(q) - 2}; "
                "use twist_taylor for Taylor coefficients of higher order"
            )
        if order is None and q.ndim == 2:
            self._plans[(len(q), self.dof), None] = self._plan(len(q) - 1, False)
        return self._twists(q, out, False)

    def twist_taylor(self, q: ArrayLike, out: np.ndarray | None = None) -> np.ndarray:
        """Returns the same from and to Taylor coefficients: q[k, ..., i] is q_i^{(k)} / k!.

        q: (n + 2, ..., dof). Returns (n + 1, ..., 6): entry k is (1/k!) d^k/dt^k (ω; v).
        """
        return self._twists(self._checked(q), out, True)

    def workspace(self, order: int, states: tuple[int, ...] = ()) -> tuple[np.ndarray, np.ndarray]:
        """Returns zeros (q, out) for `bind`, (order + 2, *states, dof) and (order + 1, *states, 6): in
        memory the states' numbers lie side by side, which suits the compiled kernel best."""
        q, out = np.zeros((order + 2, self.dof, *states)), np.zeros((order + 1, 6, *states))
        return np.moveaxis(q, 1, -1), np.moveaxis(out, 1, -1)

    def bind(self, q: np.ndarray, out: np.ndarray) -> Callable[[], bool]:
        """Returns `twist_derivatives` for a control loop: a call without arguments that reads the arrays q
        (n + 2, ..., dof) and writes out (n + 1, ..., 6) anew each time, in place.

        It returns False, with `out` unusable, if an angle exceeds 2⁵⁰ rad. Raises ValueError unless
        both are arrays of doubles of the right shapes, whose axes of states are one in memory.
        """
        if type(q) is not np.ndarray or q.dtype != np.float64:
            raise ValueError("q: expected an array of doubles")
        arrays = self._checked(q), _checked_result(q, out)
        rows = [_states_in_a_row(array) for array in arrays]
        if q.size and not all(np.may_share_memory(*pair) for pair in zip(arrays, rows, strict=True)):
            raise ValueError("q and out: expected arrays whose axes of states are one in memory")
        plan = self._plan(len(q) - 1, False)
        return BoundCall(plan.bound_kernel(), plan, rows[0], _as_of_one_frame(rows[1]))

    def pose(self, q: ArrayLike) -> np.ndarray:
        """Returns the pose of the last body in the base frame, Eq. (117).

        q: (..., dof) coordinates. Returns (..., 4, 4) homogeneous matrices.
        """
        q = np.asarray(q, dtype=float)
        if q.ndim == 0 or q.shape[-1] != self.dof:
            raise ValueError(f"expected coordinates of shape (..., {self.dof}), got {q.shape}")
        if not np.isfinite(q).all():
            raise ValueError("expected finite coordinates, got a NaN or an infinity")
        rows = _states_in_a_row(q[None])
        pose = np.empty((rows.shape[1], 1, 16))
        compute(rows, self._of_poses.plan(TIP, 0), pose[None])
        return pose.reshape(*q.shape[:-1], 4, 4)

    def _plan(self, order: int, taylor: bool) -> Plan:
        key = (order + 1, self.dof), taylor
        if key not in self._plans:
            from workbench.kinematics.chain_plan import plan_of_chain

            self._plans[key] = plan_of_chain(self.joints, self.dof, order, taylor)
        return self._plans[key]

    def _twists(self, q: np.ndarray, out: np.ndarray | None, taylor: bool) -> np.ndarray:
        out = _checked_result(q, out)
        rows = _states_in_a_row(out)
        result = rows if np.may_share_memory(rows, out) else np.empty(rows.shape)
        compute(_states_in_a_row(q), self._plan(len(q) - 1, taylor), _as_of_one_frame(result))
        if result is not rows:
            out[...] = result.reshape(out.shape)
        return out

    def __getstate__(self) -> dict[str, Any]:
        return vars(self) | {"_plans": {}}  # plans hold addresses of this process

    def _checked(self, q: ArrayLike) -> np.ndarray:
        q = np.asarray(q)
        if q.dtype != np.float64 or not q.dtype.isnative:
            if q.dtype.kind not in "fiu":
                raise ValueError(f"expected real joint derivatives, got an array of {q.dtype}")
            q = q.astype(float)
        if q.ndim < 2 or q.shape[-1] != self.dof or q.shape[0] < 2:
            raise ValueError(
                f"expected joint derivatives of shape (n + 2, ..., {self.dof}) with n ≥ 0, the order first "
                f"(coordinates, velocities, …) and the {self.dof} coordinates last, got {q.shape}"
            )
        if not np.isfinite(q).all():
            raise ValueError("expected finite joint derivatives, got a NaN or an infinity")
        return q

    def __repr__(self) -> str:
        kinds = [joint.kind for joint in self.joints]
        return f"SerialChain({', '.join(kinds)}; dof={self.dof})"


def _step(parent: int, before: np.ndarray, joint: Joint, first: int) -> Step:
    """Returns the step of a moving joint whose coordinates start at `first`."""
    first_drive = Drive(first, first)
    turn, slide = {
        "revolute": (first_drive, None),
        "prismatic": (None, first_drive),
        "cylindrical": (first_drive, Drive(first + 1, first + 1)),
        "helical": (first_drive, Drive(first, first, joint.pitch)),
    }[joint.kind]
    return Step(parent, before, joint, turn, slide)


def _checked_result(q: np.ndarray, out: np.ndarray | None) -> np.ndarray:
    shape = (len(q) - 1, *q.shape[1:-1], 6)
    if out is None:
        if q.ndim > 2 and q.strides[-2] == q.itemsize:  # side by side in memory, as those of q
            return np.moveaxis(np.empty((shape[0], 6, *shape[1:-1])), 1, -1)
        return np.empty(shape)
    if out.shape != shape or out.dtype != np.float64 or not out.flags.writeable:
        raise ValueError(
            f"out: expected a writable array of doubles of shape {shape}, "
            f"got {out.dtype} of shape {out.shape}"
        )
    return out


def _states_in_a_row(array: np.ndarray) -> np.ndarray:
    """Returns (orders, ..., parts) as (orders, states, parts), a view where the axes of states are one in
    memory."""
    return array.reshape(len(array), -1, array.shape[-1])


def _as_of_one_frame(twists: np.ndarray) -> np.ndarray:
    """Returns (orders, states, 6) as the (1, states, orders, 6) of the kernel."""
    return twists.swapaxes(0, 1)[None]

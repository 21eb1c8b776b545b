"""Twist derivatives of a serial chain, to any order, for one state or a batch of them.

The chain is a product of joint motions, Eq. (117) of *Higher-Order Kinematics in Dual Lie Algebra*,

    X(q) = J₁(q₁) · J₂(q₂) ⋯ J_m(q_m),

and what comes out is the dual twist ₀ω̲_m of the last body relative to the base, Eq. (119), with its
time derivatives to order n. The engine carries truncated Taylor series from the tip to the base,

    V ← Ad(Cᵢ) [ z α̲̇ᵢ + e^{α̲ᵢ z̃} V ],        α̲ᵢ = angle + ε slide of joint i,

each step in a frame whose z axis is the joint axis: O(m n²) operations and no forward kinematics.
The closed form (133) is a reference to compare with, not the way to compute.

Conventions: radian, metre, second. A twist is (ω; v), six numbers in base coordinates, v being the
velocity of the body point that is at the base origin at that instant (the chapter's dual part).
"""

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import ArrayLike

from workbench.kinematics.chain_engine import Engine
from workbench.kinematics.chain_geometry import Joint, links_of, motion

__all__ = ["Joint", "SerialChain"]


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
        links = links_of(self.joints)
        if links.dof == 0:
            raise ValueError("expected a chain with at least one moving joint, got none")
        self.dof = links.dof
        self.home = links.home
        self._of_derivatives = Engine(links, taylor=False)
        self._of_taylor = Engine(links, taylor=True)

    def twist_derivatives(self, q: ArrayLike, out: np.ndarray | None = None) -> np.ndarray:
        """The twist of the last body and its time derivatives, Eq. (119) differentiated.

        q: (n + 2, ..., dof), where q[k, ..., i] is the k-th time derivative of coordinate i, from
           the coordinate itself (k = 0) to order n + 1. The axes between are states.
        out: if given, the result is written there (spares large batches the fresh memory).
        Returns (n + 1, ..., 6): entry k is d^k/dt^k (ω; v) in rad/s^{k+1} and m/s^{k+1}.

        Raises ValueError for a wrong shape, a complex array, a NaN or an infinity, or n > 170 (whose
        factorials exceed the doubles: use `twist_taylor`).
        """
        return self._of_derivatives.twist(q, out)

    def twist_derivatives_of_finite(self, q: np.ndarray) -> np.ndarray:
        """The same of doubles that are known to be finite."""
        return self._of_derivatives.twist_of_finite(q)

    def twist_taylor(self, q: ArrayLike, out: np.ndarray | None = None) -> np.ndarray:
        """The same from and to Taylor coefficients: q[k, ..., i] is q_i^{(k)} / k!.

        q: (n + 2, ..., dof). Returns (n + 1, ..., 6): entry k is (1/k!) d^k/dt^k (ω; v).
        """
        return self._of_taylor.twist(q, out)

    def workspace(self, order: int, states: tuple[int, ...] = ()) -> tuple[np.ndarray, np.ndarray]:
        """Zeros (q, out) for `bind`, (order + 2, *states, dof) and (order + 1, *states, 6): in memory the
        states' numbers lie side by side, which suits the compiled kernel best."""
        q, out = np.zeros((order + 2, self.dof, *states)), np.zeros((order + 1, 6, *states))
        return np.moveaxis(q, 1, -1), np.moveaxis(out, 1, -1)

    def bind(self, q: np.ndarray, out: np.ndarray) -> Callable[[], bool]:
        """`twist_derivatives` for a control loop: a call without arguments that reads the arrays q
        (n + 2, ..., dof) and writes out (n + 1, ..., 6) anew each time, in place.

        It returns False, with `out` unusable, if an angle exceeds 2⁵⁰ rad. Raises ValueError unless
        both are arrays of doubles of the right shapes, whose axes of states are one in memory.
        """
        return self._of_derivatives.bind(q, out)

    def pose(self, q: ArrayLike) -> np.ndarray:
        """The pose of the last body in the base frame, Eq. (117).

        q: (..., dof) coordinates. Returns (..., 4, 4) homogeneous matrices.
        """
        q = np.asarray(q, dtype=float)
        if q.ndim == 0 or q.shape[-1] != self.dof:
            raise ValueError(f"expected coordinates of shape (..., {self.dof}), got {q.shape}")
        if not np.isfinite(q).all():
            raise ValueError("expected finite coordinates, got a NaN or an infinity")
        pose = np.broadcast_to(np.eye(4), (*q.shape[:-1], 4, 4))
        first = 0
        for joint in self.joints:
            pose = pose @ motion(joint, q[..., first : first + joint.dof])
            first += joint.dof
        return pose

    def __repr__(self) -> str:
        kinds = [joint.kind for joint in self.joints]
        return f"SerialChain({', '.join(kinds)}; dof={self.dof})"

"""A frame's motion for a control loop: a call reads and writes fixed arrays, without checks and new
memory."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from workbench.kinematics.bound_calls import BoundCall

if TYPE_CHECKING:
    from workbench.kinematics.trees.tree_plan import Plan


class Evaluator(BoundCall):
    """What `Robot.evaluator` returns: a call without arguments that computes anew from what is in `q`.

    q (N + 1, positions): the coordinates and their derivatives, to be filled in place before each call.
    pose (4, 4): X_WF. twists (N, 6): V_WF = (ω; velocity of Fo) and its derivatives, in W's axes. jacobians
    (orders, 6, velocities): J of these twists and its derivatives. They are overwritten by each call. It
    returns False, with them unusable, if an angle is beyond 2⁵⁰ rad.
    """

    q: np.ndarray
    pose: np.ndarray
    twists: np.ndarray
    jacobians: np.ndarray


def evaluator_of(plan: Plan, order: int, coordinates: int, jacobians: int) -> Evaluator:
    """Returns the evaluator of a plan for one frame."""
    q, record = np.zeros((order + 1, coordinates)), np.zeros(plan.rows)
    call = Evaluator(plan.bound_kernel(), plan, q[:, None], record[None, None, None])
    call.q, call.pose = q, record[:16].reshape(4, 4)
    call.twists = record[16 : 16 + 6 * order].reshape(order, 6)
    call.jacobians = record[16 + 6 * order :].reshape(jacobians, 6, coordinates)
    return call

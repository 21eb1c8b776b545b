"""The bound quantities at one instant, composed of Drake's poses, velocities and accelerations.

One set of functions serves Drake's doubles and Expressions. No formula of rigid body kinematics is used here,
since an error in one could also be in the engines. Points are changed by Drake's Shift. The exceptions are
definitions: a dual quantity is composed of a real and a dual part.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np

from workbench.drake.gate import AngleAxis_, AutoDiffXd, Expression, JacobianWrtVariable, RollPitchYaw_
from workbench.drake.plants import CylindricalAxis, Numbers

P_BO_P_B = np.array([0.5, -0.25, 1.0])
P_BO_Q_B = np.array([-0.75, 0.5, 0.25])

Quantities = dict[str, Any]


def body_quantities(X_WB: Any, V_WB: Any, A_WB: Any) -> Quantities:
    """Returns the quantities of B in W, from its RigidTransform, SpatialVelocity and SpatialAcceleration in
    W."""
    R_WB, p_WBo, w_WB = X_WB.rotation().matrix(), X_WB.translation(), V_WB.rotational()
    R_BW = X_WB.rotation().inverse()
    V_WB0, A_WB0 = V_WB.Shift(-p_WBo), A_WB.Shift(-p_WBo, w_WB)
    p_WP, p_WQ = X_WB @ P_BO_P_B, X_WB @ P_BO_Q_B
    V_WP, V_WQ = V_WB.Shift(p_WP - p_WBo), V_WB.Shift(p_WQ - p_WBo)
    A_WP, A_WQ = A_WB.Shift(p_WP - p_WBo, w_WB), A_WB.Shift(p_WQ - p_WBo, w_WB)
    return {
        "R_WB": R_WB,
        "X_WB": X_WB.GetAsMatrix4(),
        "p_WBo": p_WBo,
        "p_WP": p_WP,
        "p_WQ": p_WQ,
        "p_BoP_B": P_BO_P_B,
        "p_BoQ_B": P_BO_Q_B,
        "p_QP_B": P_BO_P_B - P_BO_Q_B,
        "p_PQ_W": p_WQ - p_WP,
        "w_WB": w_WB,
        "w_WB_B": R_BW @ w_WB,
        "alpha_WB": A_WB.rotational(),
        "V_WB": V_WB.get_coeffs(),
        "V_WB_B": np.concatenate([R_BW @ V_WB.rotational(), R_BW @ V_WB.translational()]),
        "A_WB": A_WB.get_coeffs(),
        "v_WBo": V_WB.translational(),
        "v_WP": V_WP.translational(),
        "v_WQ": V_WQ.translational(),
        "v_WB0": V_WB0.translational(),
        "a_WBo": A_WB.translational(),
        "a_WP": A_WP.translational(),
        "a_WQ": A_WQ.translational(),
        "a_WB0": A_WB0.translational(),
        "dual_R_WB": dual_rotation(X_WB),
        "dual_w_WB": dual_twist(V_WB0),
        "dual_v_WBo": dual_twist(V_WB),
        "dual_v_WP": dual_twist(V_WP),
        "dual_v_WQ": dual_twist(V_WQ),
    }


def relative_quantities(X_WA: Any, V_WA: Any, X_AB: Any, V_AB_A: Any, X_WB: Any, V_AB_W: Any) -> Quantities:
    """Returns the quantities of A in W and of B in A.

    V_AB_A and V_AB_W: the velocity of B in A, expressed in A and in W.
    """
    V_WA0 = V_WA.Shift(-X_WA.translation())
    V_AB0_W = V_AB_W.Shift(-X_WB.translation())
    V_AB0_A = V_AB_A.Shift(-X_AB.translation())
    return {
        "R_WA": X_WA.rotation().matrix(),
        "R_AB": X_AB.rotation().matrix(),
        "X_WA": X_WA.GetAsMatrix4(),
        "X_AB": X_AB.GetAsMatrix4(),
        "p_WAo": X_WA.translation(),
        "p_ABo_A": X_AB.translation(),
        "w_WA": V_WA.rotational(),
        "w_AB_W": V_AB_W.rotational(),
        "w_AB_A": V_AB_A.rotational(),
        "v_WAo": V_WA.translational(),
        "v_WA0": V_WA0.translational(),
        "v_AB0_W": V_AB0_W.translational(),
        "v_AB0_A": V_AB0_A.translational(),
        "dual_R_WA": dual_rotation(X_WA),
        "dual_R_AB": dual_rotation(X_AB),
        "dual_w_WA": dual_twist(V_WA0),
        "dual_w_AB_W": dual_twist(V_AB0_W),
        "dual_w_AB_A": dual_twist(V_AB0_A),
    }


def cylinder_quantities(q: Numbers, axes: Sequence[CylindricalAxis], X_WA: Any, point2_W: Any) -> Quantities:
    """Returns the quantities of the first two joints of a chain of cylindrical joints, q = (d₁, θ₁, d₂, θ₂,
    …)."""
    d1, theta1, d2, theta2 = q[:4]
    u1_W, u2_A = (np.array(axis.direction, dtype=float) for axis in axes[:2])
    point1_W, point2_A = (np.array(axis.point, dtype=float) for axis in axes[:2])
    u2_W = X_WA.rotation() @ u2_A
    q_WA, q_AB = _turn(theta1, u1_W), _turn(theta2, u2_A)
    return {
        "q_WA": q_WA.wxyz(),
        "q_AB": q_AB.wxyz(),
        "q_WB": q_WA.multiply(q_AB).wxyz(),
        "theta1": theta1,
        "theta2": theta2,
        "d1": d1,
        "d2": d2,
        "dual_theta1": np.array([theta1, d1]),
        "dual_theta2": np.array([theta2, d2]),
        "u1_W": u1_W,
        "u2_A": u2_A,
        "u2_W": u2_W,
        "dual_u1_W": line(u1_W, point1_W),
        "dual_u2_A": line(u2_A, point2_A),
        "dual_u2_W": line(u2_W, point2_W),
    }


def _turn(angle: Any, axis: np.ndarray) -> Any:
    """Returns Drake's quaternion of a rotation; bodies of a chain are aligned with their parents at angle
    0."""
    scalar = next(kind for kind in (Expression, AutoDiffXd, float) if isinstance(angle, kind))
    return AngleAxis_[scalar](angle=angle, axis=axis / np.linalg.norm(axis)).quaternion()


def six_coordinates(plant: Any, context: Any, body: Any, rates: np.ndarray) -> Quantities:
    """Returns the quantities of a plant with six coordinates: their rates, and the Jacobian of the body's
    velocity."""
    W = plant.world_frame()
    J = plant.CalcJacobianSpatialVelocity(context, JacobianWrtVariable.kQDot, body, np.zeros(3), W, W)
    return {"qDot": rates, "J_WB": J}


def angle_quantities(angles: np.ndarray, w_WB: np.ndarray) -> Quantities:
    """Returns the quantities of a free body with these angles."""
    rpy = RollPitchYaw_[Expression](angles)
    return {
        **dict(zip(("roll_WB", "pitch_WB", "yaw_WB"), angles, strict=True)),
        "R_rpy": rpy.ToRotationMatrix().matrix(),
        "rpyDt_WB": rpy.CalcRpyDtFromAngularVelocityInParent(w_WB),
    }


def turn_quantities(X_WB: Any) -> Quantities:
    """Returns the rotation vector, from Drake's angle between 0 and π and its axis."""
    turn = X_WB.rotation().ToAngleAxis()
    return {"rotvec_WB": turn.angle() * turn.axis()}


def third_body_quantities(
    q: Sequence[Any], X_WC: Any, X_BC: Any, V_WC: Any, V_BC_B: Any, V_BC_W: Any, u3_W: Any, point3_W: Any
) -> Quantities:
    """Returns the quantities of C in W and in B, on a chain of three cylindrical joints.

    u3_W, point3_W: the third axis.
    """
    d3, theta3 = q[4:6]
    return {
        "X_WC": X_WC.GetAsMatrix4(),
        "dual_R_WC": dual_rotation(X_WC),
        "dual_R_BC": dual_rotation(X_BC),
        "dual_w_WC": dual_twist(V_WC.Shift(-X_WC.translation())),
        "dual_w_BC_W": dual_twist(V_BC_W.Shift(-X_WC.translation())),
        "dual_w_BC_B": dual_twist(V_BC_B.Shift(-X_BC.translation())),
        "theta3": theta3,
        "d3": d3,
        "dual_theta3": np.array([theta3, d3]),
        "dual_u3_W": line(u3_W, point3_W),
    }


def cross(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Returns a × b, for the columns of a matrix b, too. Much faster than NumPy's for single vectors."""
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def line(direction: np.ndarray, point: np.ndarray) -> np.ndarray:
    """Returns a line's dual vector: direction, and moment about the origin."""
    return np.array([direction, cross(point, direction)])


def dual_rotation(X: Any) -> np.ndarray:
    """Returns R + ε p̃ R: the columns of the dual part are p × the columns of R."""
    R = X.rotation().matrix()
    return np.array([R, cross(X.translation(), R)])


def dual_twist(V_WBp: Any) -> np.ndarray:
    """Returns ω + ε v_P."""
    return np.array([V_WBp.rotational(), V_WBp.translational()])

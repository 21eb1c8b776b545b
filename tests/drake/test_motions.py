"""Reference motions: the laws that any rigid motion keeps, in every derivative."""

from math import comb, factorial

import numpy as np
import pytest
from pydrake.common.eigen_geometry import AngleAxis
from pydrake.math import RotationMatrix

from workbench.drake.bindings import ALIASES, ANGLE_BINDINGS, BODY_BINDINGS, CHAIN_BINDINGS, SIX_BINDINGS
from workbench.drake.joint_paths import JointPath
from workbench.drake.motions import P_BO_P_B, chain_motion, free_body_motion, reference_motions
from workbench.drake.plants import CylindricalAxis, body_motion, cylindrical_chain, free_body
from workbench.drake.special_motions import NAMES, special_motion

ORDER = 5
GENERAL = reference_motions()
CHAINS = GENERAL[:2]
SPECIAL = {name: special_motion(name) for name in NAMES}
EVERY = (*GENERAL, *(motion for name, motion in SPECIAL.items() if "joint" not in name))
AXES = (
    CylindricalAxis((1 / 3, 2 / 3, -2 / 3), (0.5, 0.25, -0.5)),
    CylindricalAxis((6 / 7, -2 / 7, 3 / 7), (-0.25, 1.0, 0.5)),
)
PATH_4 = JointPath([[0.5, -0.25, 0.75, 1.0], [1.0, 0.5, -0.75, 0.5], [0.25, -0.5, 0.25, 0.5]])
PATH_6 = JointPath(np.hstack([PATH_4.coefficients, PATH_4.coefficients[:, 1:3]]))

every_motion = pytest.mark.parametrize("motion", EVERY, ids=lambda motion: motion.name)
general_motion = pytest.mark.parametrize("motion", GENERAL, ids=lambda motion: motion.name)
chain = pytest.mark.parametrize("motion", CHAINS, ids=lambda motion: motion.name)


def leibniz(multiply, a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """The jet of a product, from the jets of its factors."""
    orders = range(min(len(a), len(b)))
    return np.array([sum(comb(n, k) * multiply(a[k], b[n - k]) for k in range(n + 1)) for n in orders])


def matmul_transposed(a, b):
    return a @ b.T


def terms(a: np.ndarray, b: np.ndarray) -> float:
    """The size of the terms that the Leibniz rule adds up, whatever remains of them."""
    a_sizes, b_sizes = (np.max(np.abs(x.reshape(len(x), -1)), axis=1) for x in (a, b))
    return float(np.max(leibniz(np.multiply, a_sizes, b_sizes)))


def close(actual, expected, of=1.0):
    """Equal but for the rounding of the numbers themselves, or of terms as large as ``of``."""
    scale = max(of, float(np.max(np.abs(expected))))
    np.testing.assert_allclose(actual, expected, rtol=0, atol=2e-13 * scale)


def jets(motion, *bindings, order=ORDER):
    for sample in motion.samples:
        yield tuple(motion.jet(binding, order, sample) for binding in bindings)


def dual_cross(a, b):
    return np.array([np.cross(a[0], b[0]), np.cross(a[0], b[1]) + np.cross(a[1], b[0])])


def dual_apply(T, a):
    return np.array([T[0] @ a[0], T[0] @ a[1] + T[1] @ a[0]])


def dual_matmul(S, T):
    return np.array([S[0] @ T[0], S[0] @ T[1] + S[1] @ T[0]])


# --- a rotation and its angular velocity -----------------------------------------------------


@every_motion
def test_rotation_is_orthogonal_in_every_derivative(motion):
    for (R,) in jets(motion, "R_WB"):
        identity = np.zeros_like(R)
        identity[0] = np.eye(3)
        close(leibniz(matmul_transposed, R, R), identity, of=terms(R, R))
        assert np.linalg.det(R[0]) == pytest.approx(1.0)


@every_motion
def test_angular_velocity_is_that_of_the_differentiated_rotation(motion):
    for R, w in jets(motion, "R_WB", "w_WB", order=ORDER + 1):
        spin = leibniz(matmul_transposed, R[1:], R)
        sizes = terms(R[1:], R)
        close(np.stack([spin[:, 2, 1], spin[:, 0, 2], spin[:, 1, 0]], axis=1), w[:-1], of=sizes)
        close(spin + spin.transpose(0, 2, 1), np.zeros_like(spin), of=sizes)


@every_motion
def test_rotation_rate_is_w_cross_R(motion):
    for R, w in jets(motion, "R_WB", "w_WB", order=ORDER + 1):
        close(leibniz(lambda a, b: np.cross(a, b.T).T, w, R)[:-1], R[1:])


# --- bindings between each other -------------------------------------------------------------


@pytest.mark.parametrize(
    "quantity, its_rate",
    [
        ("p_WBo", "v_WBo"),
        ("v_WBo", "a_WBo"),
        ("w_WB", "alpha_WB"),
        ("p_WP", "v_WP"),
        ("v_WP", "a_WP"),
        ("p_WQ", "v_WQ"),
        ("v_WQ", "a_WQ"),
    ],
)
@every_motion
def test_rates(motion, quantity, its_rate):
    for whole, rate in jets(motion, quantity, its_rate):
        close(whole[1:], rate[:-1])


@every_motion
def test_velocity_field(motion):
    """Eq. (5), and (92) for the point at the origin."""
    for w, v_Bo, v_P, v_0, p_Bo, p_P in jets(motion, "w_WB", "v_WBo", "v_WP", "v_WB0", "p_WBo", "p_WP"):
        close(v_P - v_Bo, leibniz(np.cross, w, p_P - p_Bo))
        close(v_0, v_Bo - leibniz(np.cross, w, p_Bo))


@every_motion
def test_acceleration_of_the_point_at_the_origin(motion):
    """a₂ = v̇ + ω × v, Eq. (42)."""
    for a_0, v_0, w in jets(motion, "a_WB0", "v_WB0", "w_WB", order=ORDER):
        close(a_0[:-1], v_0[1:] + leibniz(np.cross, w, v_0)[:-1])


@every_motion
def test_points_of_the_body(motion):
    for R, p_Bo, p_P, p_Q, r_P, r_Q, r_QP, PQ in jets(
        motion, "R_WB", "p_WBo", "p_WP", "p_WQ", "p_BoP_B", "p_BoQ_B", "p_QP_B", "p_PQ_W"
    ):
        close(p_P, p_Bo + R @ P_BO_P_B)
        close(p_P, p_Bo + leibniz(np.matmul, R, r_P))
        close(p_P, p_Q + leibniz(np.matmul, R, r_QP))
        close(r_QP, r_P - r_Q)
        close(PQ, p_Q - p_P)
        distance = leibniz(np.dot, PQ, PQ)
        close(distance[1:], np.zeros(ORDER), of=terms(PQ, PQ))


@every_motion
def test_pose(motion):
    for X, R, p in jets(motion, "X_WB", "R_WB", "p_WBo"):
        close(X[:, :3, :3], R)
        close(X[:, :3, 3], p)
        close(X[0, 3], [0, 0, 0, 1])
        close(X[1:, 3], np.zeros((ORDER, 4)))


@every_motion
def test_dual_rotation_and_dual_twist(motion):
    """Eqs. (87), (90) and (95): dual R is carried along by the dual twist."""
    for R, w, v_P, p_P, w_real, v_0 in jets(
        motion, "dual_R_WB", "dual_w_WB", "dual_v_WP", "p_WP", "w_WB", "v_WB0", order=ORDER + 1
    ):
        close(w[:, 0], w_real)
        close(w[:, 1], v_0)
        close(v_P[:, 1] + leibniz(np.cross, p_P, w_real), v_0, of=terms(p_P, w_real))
        columns = np.moveaxis(R, -1, 0)
        for column in columns:
            close(leibniz(dual_cross, w, column)[:-1], column[1:], of=terms(w, column))


@chain
def test_composition_along_the_chain(motion):
    """Eqs. (117), (119), (121), (122) for two bodies."""
    for R, R_1, R_2, w, w_1, w_2, Omega_2 in jets(
        motion,
        "dual_R_WB",
        "dual_R_WA",
        "dual_R_AB",
        "dual_w_WB",
        "dual_w_WA",
        "dual_w_AB_W",
        "dual_w_AB_A",
    ):
        close(R, leibniz(dual_matmul, R_1, R_2))
        close(w, w_1 + w_2)
        close(w_2, leibniz(dual_apply, R_1, Omega_2))


@chain
def test_joints_turn_and_slide_along_their_axes(motion):
    """The dual twist of a joint is the rate of its dual angle times its axis, Eq. (143)."""
    for theta, u, w in (
        ("dual_theta1", "dual_u1_W", "dual_w_WA"),
        ("dual_theta2", "dual_u2_A", "dual_w_AB_A"),
        ("dual_theta2", "dual_u2_W", "dual_w_AB_W"),
    ):
        for angle, axis, twist in jets(motion, theta, u, w, order=ORDER + 1):
            expected = leibniz(
                lambda a, line: np.array([a[0] * line[0], a[0] * line[1] + a[1] * line[0]]),
                angle[1:],
                axis,
            )
            close(twist[:-1], expected)


@chain
def test_axes(motion):
    for u_2, u_2A, R_1, u_1, w_1 in jets(motion, "dual_u2_W", "dual_u2_A", "dual_R_WA", "u1_W", "w_WA"):
        close(u_2, leibniz(dual_apply, R_1, u_2A))
        close(np.cross(u_1[0], w_1), np.zeros_like(w_1))
        assert np.dot(u_1[0], u_1[0]) == pytest.approx(1.0)
        assert np.dot(u_2[0, 0], u_2[0, 1]) == pytest.approx(0.0, abs=1e-14)


@chain
def test_relative_rotation_is_the_turn_about_the_second_axis(motion):
    for R_AB, theta, u in jets(motion, "R_AB", "theta2", "u2_A"):
        close(R_AB[0], RotationMatrix(AngleAxis(theta[0], u[0])).matrix())


@chain
def test_parts_of_the_chains_dual_bindings(motion):
    for dual, real, part in (
        ("dual_theta1", "theta1", "d1"),
        ("dual_theta2", "theta2", "d2"),
        ("dual_w_WA", "w_WA", "v_WA0"),
        ("dual_w_AB_W", "w_AB_W", "v_AB0_W"),
        ("dual_w_AB_A", "w_AB_A", "v_AB0_A"),
    ):
        for together, first, second in jets(motion, dual, real, part):
            close(together[:, 0], first)
            close(together[:, 1], second)


@chain
def test_intermediate_body(motion):
    for p, v, X, R, w, v_0, p_AB, X_AB, R_AB in jets(
        motion, "p_WAo", "v_WAo", "X_WA", "R_WA", "w_WA", "v_WA0", "p_ABo_A", "X_AB", "R_AB"
    ):
        close(p[1:], v[:-1])
        close(v_0, v - leibniz(np.cross, w, p))
        close(X[:, :3, 3], p)
        close(X[:, :3, :3], R)
        close(X_AB[:, :3, 3], p_AB)
        close(X_AB[:, :3, :3], R_AB)


# --- against Drake in doubles, and against no derivative at all ------------------------------


@pytest.mark.parametrize(
    "motion, plant, path",
    [
        (chain_motion("chain", AXES, PATH_4), cylindrical_chain(AXES, ("A", "B")), PATH_4),
        (free_body_motion("free", PATH_6), free_body(), PATH_6),
    ],
    ids=["chain", "free"],
)
def test_expressions_agree_with_the_plant_in_doubles(motion, plant, path):
    for t in motion.samples:
        context = plant.CreateDefaultContext()
        plant.SetPositions(context, path(t))
        v = plant.MapQDotToVelocity(context, path(t, 1))
        h = 1e-4
        near = []
        for s in (t - h, t + h):
            plant.SetPositions(context, path(s))
            near.append(plant.MapQDotToVelocity(context, path(s, 1)))
        vdot = (near[1] - near[0]) / (2 * h)
        double = body_motion(plant, "B", path(t), v, vdot, P_BO_P_B)
        close(motion.jet("R_WB", 0, t)[0], double.R_WB)
        close(motion.jet("p_WP", 0, t)[0], double.p_WBp)
        close(motion.jet("w_WB", 0, t)[0], double.V_WBp[:3])
        close(motion.jet("v_WP", 0, t)[0], double.V_WBp[3:])
        np.testing.assert_allclose(motion.jet("alpha_WB", 0, t)[0], double.A_WBp[:3], atol=1e-6)
        np.testing.assert_allclose(motion.jet("a_WP", 0, t)[0], double.A_WBp[3:], atol=1e-6)


@general_motion
@pytest.mark.parametrize("name", ["R_WB", "w_WB", "p_WP", "v_WB0"])
def test_jets_are_taylor_coefficients(motion, name):
    """The jet at one time foretells the value a little later: halving the step shows the order."""
    sample = 0.5
    jet = motion.jet(name, ORDER, sample)
    errors = []
    for h in (0.04, 0.02):
        foretold = sum(jet[k] * h**k / factorial(k) for k in range(ORDER + 1))
        errors.append(np.max(np.abs(foretold - motion.jet(name, 0, sample + h)[0])))
    assert errors[0] / errors[1] == pytest.approx(2 ** (ORDER + 1), rel=0.25)


# --- the table of bindings -------------------------------------------------------------------


@general_motion
def test_every_binding_is_in_the_table_with_its_shape(motion):
    more = CHAIN_BINDINGS if motion in CHAINS else (*SIX_BINDINGS, *ANGLE_BINDINGS)
    table = (*BODY_BINDINGS, *more)
    assert set(motion.available_bindings()) == {binding.name for binding in table}
    for binding in table:
        assert motion.jet(binding.name, 1, 0.5).shape == (2, *binding.shape)
        assert motion.binding(binding.name) is binding


@pytest.mark.parametrize("make", ["chain", "free body"])
def test_weights(make):
    """A motion run twice as fast multiplies a quantity of weight w by 2^w."""
    path = PATH_4 if make == "chain" else PATH_6
    fast_path = JointPath(path.coefficients * np.array([[1.0], [2.0], [4.0]]))
    slow, fast = (
        chain_motion("c", AXES, p) if make == "chain" else free_body_motion("f", p) for p in (path, fast_path)
    )
    for name in slow.available_bindings():
        weight = slow.binding(name).weight
        close(fast.jet(name, 0, 0.25)[0], 2.0**weight * slow.jet(name, 0, 0.5)[0])


@pytest.mark.parametrize("motion", CHAINS, ids=lambda motion: motion.name)
def test_general_motions_are_general(motion):
    """What vanishes on a reference motion would be tested by nothing."""
    constant = {"p_BoP_B", "p_BoQ_B", "p_QP_B", "u1_W", "u2_A", "dual_u1_W", "dual_u2_A"}
    for name in motion.available_bindings():
        if name in constant:
            continue
        for sample in motion.samples:
            for k, derivative in enumerate(motion.jet(name, ORDER, sample)):
                assert np.max(np.abs(derivative)) > 1e-3, (name, k, sample)


def test_general_motions_differ():
    assert len({motion.jet("w_WB", 0, 0.5).tobytes() for motion in GENERAL}) == len(GENERAL)
    assert len({motion.name for motion in EVERY}) == len(EVERY)
    assert all(len(set(motion.samples)) >= 5 for motion in EVERY)


def test_special_motions_are_special():
    rest, translation, spin, screw, plane = (
        SPECIAL[name]
        for name in (
            "rest",
            "translation",
            "spin about a fixed axis",
            "steady screw motion",
            "plane motion",
        )
    )
    for t in rest.samples:
        assert not np.any(rest.jet("p_WP", ORDER, t)[1:])
        assert not np.any(translation.jet("w_WB", ORDER, t))
        assert np.any(translation.jet("v_WP", 0, t))
        assert not np.any(spin.jet("v_WB0", ORDER, t))
        assert np.any(spin.jet("w_WB", 0, t))
        w, v = (screw.jet(name, ORDER, t) for name in ("w_WB", "v_WB0"))
        close(np.cross(w[0], v[0]), np.zeros(3))
        assert np.dot(w[0], v[0]) != 0 and not np.any(w[1:]) and not np.any(v[1:])
        w, v = (plane.jet(name, ORDER, t) for name in ("w_WB", "v_WB0"))
        close(np.einsum("ki,ki->k", w, v), np.zeros(ORDER + 1))
        assert np.any(v[0])


def test_special_chains_are_special():
    """Of the two axes: parallel, one line, a third motion without a turn; joints that only turn or slide."""
    for t in (-0.5, 0.75):
        axis1, axis2, twist1, twist2 = (
            {
                name: motion.jet(binding, 0, t)[0]
                for name, motion in SPECIAL.items()
                if "joint" in name and binding in motion.available_bindings()
            }
            for binding in ("dual_u1_W", "dual_u2_W", "dual_w_WA", "dual_w_AB_W")
        )
        parallel, one = "two parallel cylindrical joints", "two cylindrical joints on one axis"
        opposite = "two parallel cylindrical joints, turning against each other"
        close(np.cross(axis1[parallel][0], axis2[parallel][0]), np.zeros(3))
        assert np.linalg.norm(axis1[parallel][1] - axis2[parallel][1]) > 0.1
        close(axis1[one], axis2[one])
        close(twist1[opposite][0] + twist2[opposite][0], np.zeros(3))
        assert np.linalg.norm((twist1[opposite] + twist2[opposite])[1]) > 0.1
        for joint in (twist1, twist2):
            turning = joint["two revolute joints"]
            close(np.dot(turning[0], turning[1]), 0.0)
            assert np.linalg.norm(turning[0]) > 0.1
            assert not np.any(joint["two prismatic joints"][0])
        one_slides = "a cylindrical and a prismatic joint"
        assert np.any(twist1[one_slides][0]) and not np.any(twist2[one_slides][0])
        assert np.any(twist2[one_slides][1])


def test_reference_motions_are_built_once():
    assert reference_motions() is GENERAL


# --- bad input -------------------------------------------------------------------------------


def test_an_unknown_binding_names_those_that_exist():
    motion = GENERAL[-1]
    with pytest.raises(ValueError, match=r"no binding 'w_BW' on the motion .* it has R_WB, X_WB"):
        motion.jet("w_BW", 1, 0.5)
    with pytest.raises(ValueError, match="no binding 'w_WA'"):
        motion.jet("w_WA", 1, 0.5)


def test_a_negative_order_is_refused():
    with pytest.raises(ValueError, match="order of a jet"):
        GENERAL[0].jet("w_WB", -1, 0.5)


@pytest.mark.parametrize("alias, name", ALIASES.items())
def test_aliases(alias, name):
    close(CHAINS[0].jet(alias, 1, 0.5), CHAINS[0].jet(name, 1, 0.5))

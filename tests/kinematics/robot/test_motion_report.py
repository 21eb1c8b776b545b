"""Bodies of robots: laws, agreement with Drake, symmetric edge cases, and clear errors."""

import json
from dataclasses import replace
from functools import cache
from math import factorial

import numpy as np
import pytest
from pydrake.math import RollPitchYaw, RotationMatrix

from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import PlantError, body_motion, load_urdf, robot_urdf
from workbench.drake.references import twist_derivatives
from workbench.kinematics.fields import acceleration_tensors, invariant_vectors
from workbench.kinematics.frames import chapter_twist
from workbench.kinematics.robot import Robot
from workbench.kinematics.robot.report import DrakeCheck, motion_report

# Drake keeps Expressions as NaNs with a payload, which NumPy takes for invalid operations.
pytestmark = pytest.mark.filterwarnings("ignore:invalid value:RuntimeWarning")

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>'
JOINTS = (
    ("turn", "revolute", "base", "column", "0.1 -0.2 0.3", "0.2 0.1 -0.4", "0 0 1"),
    ("slide", "prismatic", "column", "carriage", "0 0.3 0.1", "0.5 0 0.3", "0.6 0 0.8"),
    ("wrist", "revolute", "carriage", "hand", "0.2 0 0.1", "0 1.2 0.3", "0 0.6 -0.8"),
    ("grip", "fixed", "hand", "tool", "0.05 0.02 0.1", "0.3 0.3 0.3", "1 0 0"),
)


def joint_xml(name, kind, parent, child, xyz, rpy, axis) -> str:
    limit = '<limit effort="1" velocity="1" lower="-9" upper="9"/>'
    return (
        f'<joint name="{name}" type="{kind}"><parent link="{parent}"/><child link="{child}"/>'
        f'<origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="{axis}"/>{limit}</joint>'
    )


@pytest.fixture(scope="module")
def arm(tmp_path_factory):
    """A turning, sliding, turning arm with a tool, on a free base."""
    links = ("base", "column", "carriage", "hand", "tool")
    body = "".join(f'<link name="{name}">{INERTIAL}</link>' for name in links)
    body += "".join(joint_xml(*joint) for joint in JOINTS)
    path = tmp_path_factory.mktemp("robot") / "arm.urdf"
    path.write_text(f'<robot name="arm">{body}</robot>')
    return path


@cache
def robot(name: str):
    try:
        return load_urdf(robot_urdf(name))
    except PlantError as error:
        pytest.skip(str(error))


ROBOTS = {"panda": "panda_hand", "ur5_robot": "tool0"}


def moved(plant, body: str, q_derivatives):
    """The frame of a body of the plant, moved by the derivatives of its positions, (N + 1, positions)."""
    return Robot.from_plant(plant).motion(q_derivatives).frame(body)


def kinds(frame) -> list[str]:
    return [frame.centre(n).kind for n in range(1, frame.order + 1)]


def random_path(plant, seed: int, degree: int = 6) -> JointPath:
    """Joint derivatives of the size of 1/sᵏ."""
    rng = np.random.default_rng(seed)
    scale = np.array([[1 / factorial(k)] for k in range(degree + 1)])
    return JointPath(rng.uniform(-1, 1, size=(degree + 1, plant.num_positions())) * scale)


def assert_within_error(plant, body: str, path: JointPath, at: float, order: int) -> None:
    """Ours and Drake's twist derivatives differ by no more than Drake's printed error."""
    motion = moved(plant, body, path.jet(at, order))
    references = twist_derivatives(plant, body, path, at, order)
    assert len(references) == order
    for n, reference in enumerate(references):
        ours = motion.twists[n]
        residual = np.abs(ours - reference.value).max()
        assert residual <= reference.error, f"order {n + 1}: {residual} > {reference.error}"
        assert reference.error < 1e-3 * np.abs(reference.value).max(), f"order {n + 1}"


@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("seed", range(3))
def test_robots_against_drake(name, seed):
    plant = robot(name)
    assert_within_error(plant, ROBOTS[name], random_path(plant, seed), 0.0, 6)


@pytest.mark.slow
@pytest.mark.parametrize("name", ROBOTS)
@pytest.mark.parametrize("seed", range(100))
def test_robots_against_drake_on_many_states(name, seed):
    plant = robot(name)
    assert_within_error(plant, ROBOTS[name], random_path(plant, 1000 + seed), 0.3, 6)


@pytest.mark.parametrize("body", ["column", "carriage", "hand", "tool"])
def test_arm_against_drake(arm, body):
    plant = load_urdf(arm)
    assert_within_error(plant, body, random_path(plant, 5), -0.2, 6)


@pytest.mark.parametrize("seed", range(5))
def test_point_velocity_and_acceleration_are_drakes_own(arm, seed):
    plant, at = load_urdf(arm), 0.4
    path, point = random_path(plant, seed), np.random.default_rng(seed).normal(size=3)
    q, qd, qdd = path.jet(at, 2)
    drakes = body_motion(plant, "tool", q, qd, qdd, point)
    motion = moved(plant, "tool", path.jet(at, 2))
    np.testing.assert_allclose(motion.pose[:3, :3], drakes.R_WB, atol=1e-13)
    np.testing.assert_allclose(motion.point(point).position, drakes.p_WBp, atol=1e-13)
    np.testing.assert_allclose(motion.point(point).velocity, drakes.V_WBp[3:], atol=1e-13)
    np.testing.assert_allclose(motion.point(point).acceleration, drakes.A_WBp[3:], atol=1e-12)


def test_parts_of_a_motion_belong_together(arm):
    plant = load_urdf(arm)
    motion = moved(plant, "tool", random_path(plant, 1).jet(0.1, 5))
    assert motion.order == 5
    omega, v = chapter_twist(motion.twists[:, :3], motion.twists[:, 3:], motion.pose[:3, 3])
    np.testing.assert_allclose(v, motion.origin_twist[:, 3:], atol=1e-10)
    np.testing.assert_allclose(acceleration_tensors(omega), motion.Phi, atol=1e-12)
    np.testing.assert_allclose(invariant_vectors(omega, v), motion.a, atol=1e-10)
    for n in range(1, 6):
        centre, (Phi, a) = motion.centre(n), motion.field(n)
        np.testing.assert_allclose(
            motion.field(n).at(motion.point().position), motion.acceleration(n), atol=1e-10
        )
        if centre.kind != "none":
            np.testing.assert_allclose(a + Phi @ centre.point, 0, atol=1e-9 * np.abs(a).max())


def joint_jet(plant, joint: str, derivatives) -> np.ndarray:
    """The default state with `derivatives` q̇, q̈, ... on one joint."""
    q = np.zeros((len(derivatives) + 1, plant.num_positions()))
    q[0] = np.linspace(-0.7, 0.9, q.shape[1])
    q[1:, plant.GetJointByName(joint).position_start()] = derivatives
    return q


def test_rest(arm):
    plant = load_urdf(arm)
    motion = moved(plant, "tool", joint_jet(plant, "turn", [0, 0, 0, 0]))
    assert not motion.twists.any() and not motion.Phi[1:].any() and not motion.point().derivatives[1:].any()
    assert kinds(motion) == ["space"] * 4


def test_pure_spin(arm):
    """One revolute joint turns: the centres of every order are its axis."""
    plant = load_urdf(arm)
    motion = moved(plant, "tool", joint_jet(plant, "wrist", [2, -1, 0.5, 3]))
    assert kinds(motion) == ["line"] * 4
    axis = motion.screw_axis()
    for n in range(1, 5):
        centre = motion.centre(n)
        np.testing.assert_allclose(np.cross(centre.directions[0], axis.direction), 0, atol=1e-9)
        np.testing.assert_allclose(centre.point, axis.point, atol=1e-9)


def test_pure_translation(arm):
    """One prismatic joint slides: every point moves alike, and rests where the derivative is 0."""
    plant = load_urdf(arm)
    motion = moved(plant, "tool", joint_jet(plant, "slide", [2, 0, 0.5]))
    np.testing.assert_allclose(motion.Phi[1:], 0, atol=1e-15)
    accelerations = motion.point((1, 2, 3)).derivatives[1:]
    np.testing.assert_allclose(np.linalg.norm(accelerations, axis=1), [2, 0, 0.5])
    assert kinds(motion) == ["none", "space", "none"]


def test_translation_on_a_circle(tmp_path):
    """Two parallel axes turn against each other: only rounding is left of Φₙ, and no point rests."""
    axis, R = np.array([0.6, 0.48, 0.64]), RotationMatrix(RollPitchYaw(0.3, 0.2, 0.1)).matrix()
    first, second = (" ".join(map(repr, x.tolist())) for x in (axis, R.T @ axis))
    links = "".join(f'<link name="{name}">{INERTIAL}</link>' for name in ("base", "crank", "coupler"))
    joints = joint_xml("out", "revolute", "base", "crank", "0.1 0.2 0.3", "0 0 0", first)
    joints += joint_xml("back", "revolute", "crank", "coupler", "0.7 -0.4 0.2", "0.3 0.2 0.1", second)
    path = tmp_path / "parallel.urdf"
    path.write_text(f'<robot name="parallel">{links}{joints}</robot>')
    for angle in np.linspace(-2, 2, 9):
        q = np.array([[angle, 1.3, 0.4, -2.0, 1.0], [0.3, -1.3, -0.4, 2.0, -1.0]]).T
        motion = Robot.from_urdf(path).motion(q).frame("coupler")
        np.testing.assert_allclose(motion.Phi[1:], 0, atol=1e-14)
        assert kinds(motion) == ["none"] * 4 and not any(motion.centre(n).rank for n in range(1, 5))


@pytest.mark.parametrize("name", ROBOTS)
def test_edge_cases_of_robots(name):
    plant = robot(name)
    joint = plant.GetPositionNames(False, False)[2]
    rest = moved(plant, ROBOTS[name], joint_jet(plant, joint, [0] * 6))
    spin = moved(plant, ROBOTS[name], joint_jet(plant, joint, [1, 0, 0, 0, 0, 0]))
    assert kinds(rest) == ["space"] * 6 and kinds(spin) == ["line"] * 6


def test_report(arm):
    report = motion_report(arm, "tool", (0, 0, 0.1), 3, 0.5, {"turn": [0.1, 1.0], "wrist": [0.0, 0.5, 0.2]})
    assert report.robot.positions == ("turn", "slide", "wrist")
    data = json.loads(json.dumps(report.to_dict(), allow_nan=False))
    assert data["joint_coefficients"] == {
        "turn": [0.1, 1.0, 0.0],
        "slide": [0.0, 0.0, 0.0],
        "wrist": [0.0, 0.5, 0.2],
    }
    assert [order["order"] for order in data["orders"]] == [1, 2, 3]
    assert all(order["drake"]["agrees"] for order in data["orders"])
    assert all(check.agrees and check.error > 0 for check in report.checks)
    drakes = [order["drake"]["V_WP_derivative"][3:] for order in data["orders"]]
    np.testing.assert_allclose(drakes, report.motion.point((0, 0, 0.1)).derivatives[1:], atol=1e-10)
    np.testing.assert_allclose(data["orders"][1]["Phi"], report.motion.Phi[2])
    units = data["orders"][1]["units"]
    assert (units["w_WB"], units["v_WBo"], units["Phi"]) == ("rad/s^2", "m/s^2", "1/s^2")


@pytest.mark.parametrize("at", [0.0, 2.5])
def test_without_a_path_every_joint_follows_a_sine(arm, at):
    """Values away from t = 0 do not depend on the order asked for."""
    reports = [motion_report(arm, "hand", order=order, at=at) for order in (2, 5)]
    for report in reports:
        assert report.agrees
        np.testing.assert_allclose(report.path.jet(at, 2)[0], np.sin(at + np.array([1, 2, 3])) / 2)
        np.testing.assert_allclose(report.path.jet(at, 2)[2], -np.sin(at + np.array([1, 2, 3])) / 2)
    np.testing.assert_array_equal(reports[0].motion.twists, reports[1].motion.twists[:2])
    assert reports[0].joints == {"turn": "sin(t + 1)/2", "slide": "sin(t + 2)/2", "wrist": "sin(t + 3)/2"}


QUINTIC = (0.0, 0.0, 0.0, 10.0, -15.0, 6.0)


@pytest.mark.parametrize("duration", [0.37, 1.0, 2.9])
@pytest.mark.parametrize("shift", [0.0, 1.7])
def test_the_end_of_a_motion_agrees_and_its_rest_is_no_line(arm, duration, shift):
    """Velocity and acceleration cancel to rounding noise there: what bounds it is the size of what was summed."""
    path = JointPath(np.array([[c / duration**k] for k, c in enumerate(QUINTIC)])).taylor(-shift)
    coefficients = path.coefficients[:, 0].tolist()
    for names in (("turn",), ("turn", "wrist"), ("turn", "slide", "wrist")):
        joints = dict.fromkeys(names, coefficients)
        report = motion_report(arm, "tool", (0, 0, 0.1), 5, duration + shift, joints)
        assert report.agrees, [(c.order, c.residual, c.error) for c in report.checks]
        assert kinds(report.motion)[:2] == ["space", "space"]
        assert "space" not in kinds(report.motion)[2:]


def test_relative_motion_beside_drake_s(arm):
    report = motion_report(arm, "tool", (0.1, 0, 0.1), 5, 0.4, relative_to="carriage")
    assert report.agrees and [c.method for c in report.checks][:3] == ["double", "AutoDiffXd", "Chebyshev"]
    wrist = motion_report(arm, "hand", (0, 0, 0), 3, 0.4, relative_to="carriage").motion
    np.testing.assert_allclose(np.linalg.norm(wrist.twists[0, :3]), abs(np.cos(0.4 + 3)) / 2, atol=1e-14)


@pytest.mark.parametrize("body", ["base", "tool"])
def test_a_floating_base_beside_drake_s(arm, body):
    report = motion_report(arm, body, (0, 0, 0.1), 5, 0.4, base="floating")
    assert report.agrees and len(report.joints) == 9


def test_a_mimic_joint_moves_and_agrees():
    try:
        path = robot_urdf("panda")
    except PlantError as error:
        pytest.skip(str(error))
    report = motion_report(path, "panda_rightfinger", order=4)
    left = motion_report(path, "panda_leftfinger", order=4)
    assert report.agrees and left.agrees
    hand = report.robot.along(report.path, 0.0).frame("panda_hand")
    fingers = [r.robot.along(r.path, 0.0).frame(r.body).relative_to(hand) for r in (report, left)]
    speeds = [np.linalg.norm(finger.twists[:, 3:], axis=1) for finger in fingers]
    np.testing.assert_allclose(speeds[0], speeds[1], atol=1e-12)
    assert (speeds[0] > 0.01).all()


def test_the_world_and_a_welded_base_are_at_rest(arm):
    for body in ("base", "world"):
        report = motion_report(arm, body, (1, 2, 3), 4, 0.3)
        assert report.agrees and not report.motion.twists.any() and kinds(report.motion) == ["space"] * 4


def test_a_bound_that_is_no_number_bounds_nothing():
    for error, residual in ((np.inf, 0.0), (np.nan, 0.0), (1.0, np.nan), (np.inf, np.inf)):
        assert not DrakeCheck(1, np.zeros(6), "double", error, residual).agrees


def test_numbers_beyond_doubles(arm):
    with np.errstate(all="ignore"), pytest.raises(ValueError, match="finite"):
        motion_report(arm, "tool", order=3, joints={"turn": [0.0, 1e200]})
    report = motion_report(arm, "tool", order=1)
    report = replace(report, checks=(DrakeCheck(1, np.full(6, np.inf), "double", np.inf, np.nan),))
    drake = json.loads(json.dumps(report.to_dict(), allow_nan=False))["orders"][0]["drake"]
    assert drake == {
        "V_WP_derivative": [None] * 6,
        "method": "double",
        "error": None,
        "residual": None,
        "agrees": False,
    }


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"body": "arm"}, "'arm'.*column, carriage, hand, tool"),
        ({"order": 0}, "order: expected an integer >= 1, got 0"),
        ({"order": 2.0}, "order"),
        ({"at": float("nan")}, "time"),
        ({"point": (1, 2)}, "point"),
        ({"point": (1, 2, np.inf)}, "finite"),
        ({"joints": {"slide": []}}, "'slide'"),
        ({"joints": {"slide": [np.nan]}}, "finite"),
        ({"relative_to": "arm"}, "'arm'.*column, carriage, hand, tool"),
        ({"base": "free"}, "fixed or floating"),
        ({"joints": {"elbow": [1.0]}}, "unknown joint 'elbow'.*turn, slide, wrist"),
    ],
)
def test_bad_input(arm, arguments, message):
    with pytest.raises(ValueError, match=message):
        motion_report(**{"urdf": arm, "body": "tool", "order": 2, **arguments})


def test_bad_files(tmp_path):
    with pytest.raises(ValueError, match="no URDF file"):
        motion_report(tmp_path / "none.urdf", "tool")
    (tmp_path / "bad.urdf").write_text("<robot")
    with pytest.raises(ValueError, match="not XML"):
        motion_report(tmp_path / "bad.urdf", "tool")


def test_an_order_of_numpy_s_is_an_order(arm):
    assert motion_report(arm, "tool", order=np.int64(2)).motion.order == 2

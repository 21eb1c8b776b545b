"""Bodies of robots: laws, agreement with Drake, symmetric edge cases, and clear errors."""

import json
from functools import cache
from math import factorial

import numpy as np
import pytest
from pydrake.math import RollPitchYaw, RotationMatrix

from workbench.drake.joint_paths import JointPath
from workbench.drake.plants import PlantError, body_motion, load_robot, load_urdf
from workbench.drake.references import twist_derivatives
from workbench.kinematics.fields import acceleration_tensors, invariant_vectors
from workbench.kinematics.frames import chapter_twist
from workbench.kinematics.robot import motion_report, robot_motion

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
        return load_robot(name)
    except PlantError as error:
        pytest.skip(str(error))


ROBOTS = {"panda": "panda_hand", "ur5_robot": "tool0"}


def random_path(plant, seed: int, degree: int = 6) -> JointPath:
    """Joint derivatives of the size of 1/sᵏ."""
    rng = np.random.default_rng(seed)
    scale = np.array([[1 / factorial(k)] for k in range(degree + 1)])
    return JointPath(rng.uniform(-1, 1, size=(degree + 1, plant.num_positions())) * scale)


def assert_within_error(plant, body: str, path: JointPath, at: float, order: int) -> None:
    """Ours and Drake's twist derivatives differ by no more than Drake's printed error."""
    motion = robot_motion(plant, body, path.jet(at, order).T)
    references = twist_derivatives(plant, body, path, at, order)
    assert len(references) == order
    for n, reference in enumerate(references):
        ours = np.concatenate([motion.w_WB[n], motion.v_WBo[n]])
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
    motion = robot_motion(plant, "tool", path.jet(at, 2).T, point)
    np.testing.assert_allclose(motion.p_WP, drakes.p_WBp, atol=1e-13)
    np.testing.assert_allclose(motion.X_WB[:3, :3], drakes.R_WB, atol=1e-13)
    np.testing.assert_allclose(motion.accelerations[0], drakes.p_WBp, atol=1e-13)
    np.testing.assert_allclose(motion.accelerations[1], drakes.V_WBp[3:], atol=1e-13)
    np.testing.assert_allclose(motion.accelerations[2], drakes.A_WBp[3:], atol=1e-12)


def test_parts_of_a_motion_belong_together(arm):
    plant = load_urdf(arm)
    motion = robot_motion(plant, "tool", random_path(plant, 1).jet(0.1, 5).T, (0.1, 0, 0))
    assert motion.order == 5 and len(motion.centres) == 5
    omega, v = chapter_twist(motion.w_WB, motion.v_WBo, motion.X_WB[:3, 3])
    np.testing.assert_allclose(v, motion.v, atol=1e-10)
    np.testing.assert_allclose(acceleration_tensors(omega), motion.Phi, atol=1e-12)
    np.testing.assert_allclose(invariant_vectors(omega, v), motion.a, atol=1e-10)
    for n, centre in enumerate(motion.centres, start=1):
        if centre.kind != "none":
            at_centre = motion.a[n] + motion.Phi[n] @ centre.point
            np.testing.assert_allclose(at_centre, 0, atol=1e-9 * np.abs(motion.a[n]).max())


def joint_jet(plant, joint: str, derivatives) -> np.ndarray:
    """The default state with `derivatives` q̇, q̈, ... on one joint."""
    q = np.zeros((plant.num_positions(), len(derivatives) + 1))
    q[:, 0] = np.linspace(-0.7, 0.9, len(q))
    q[plant.GetJointByName(joint).position_start(), 1:] = derivatives
    return q


def test_rest(arm):
    plant = load_urdf(arm)
    motion = robot_motion(plant, "tool", joint_jet(plant, "turn", [0, 0, 0, 0]))
    assert not motion.v.any() and not motion.Phi[1:].any() and not motion.accelerations[1:].any()
    assert [centre.kind for centre in motion.centres] == ["space"] * 4


def test_pure_spin(arm):
    """One revolute joint turns: the centres of every order are its axis."""
    plant = load_urdf(arm)
    motion = robot_motion(plant, "tool", joint_jet(plant, "wrist", [2, -1, 0.5, 3]))
    assert [centre.kind for centre in motion.centres] == ["line"] * 4
    axis = motion.w_WB[0] / np.linalg.norm(motion.w_WB[0])
    for centre in motion.centres:
        np.testing.assert_allclose(np.cross(centre.directions[0], axis), 0, atol=1e-9)
        np.testing.assert_allclose(centre.point, motion.centres[0].point, atol=1e-9)


def test_pure_translation(arm):
    """One prismatic joint slides: every point moves alike, and rests where the derivative is 0."""
    plant = load_urdf(arm)
    motion = robot_motion(plant, "tool", joint_jet(plant, "slide", [2, 0, 0.5]), (1, 2, 3))
    np.testing.assert_allclose(motion.Phi[1:], 0, atol=1e-15)
    np.testing.assert_allclose(np.linalg.norm(motion.accelerations[1:], axis=1), [2, 0, 0.5])
    assert [centre.kind for centre in motion.centres] == ["none", "space", "none"]


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
        q = np.array([[angle, 1.3, 0.4, -2.0, 1.0], [0.3, -1.3, -0.4, 2.0, -1.0]])
        motion = robot_motion(load_urdf(path), "coupler", q)
        np.testing.assert_allclose(motion.Phi[1:], 0, atol=1e-14)
        assert {(centre.kind, int(centre.rank)) for centre in motion.centres} == {("none", 0)}


@pytest.mark.parametrize("name", ROBOTS)
def test_edge_cases_of_robots(name):
    plant = robot(name)
    joint = plant.GetPositionNames(False, False)[2]
    rest = robot_motion(plant, ROBOTS[name], joint_jet(plant, joint, [0] * 6))
    spin = robot_motion(plant, ROBOTS[name], joint_jet(plant, joint, [1, 0, 0, 0, 0, 0]))
    assert {centre.kind for centre in rest.centres} == {"space"}
    assert {centre.kind for centre in spin.centres} == {"line"}


def test_report(arm):
    report = motion_report(arm, "tool", (0, 0, 0.1), 3, 0.5, {"turn": [0.1, 1.0], "wrist": [0.0, 0.5, 0.2]})
    assert report.joints == ("turn", "slide", "wrist")
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
    np.testing.assert_allclose(drakes, report.motion.accelerations[1:], atol=1e-10)
    np.testing.assert_allclose(data["orders"][1]["Phi"], report.motion.Phi[2])
    by_row = motion_report(arm, "tool", (0, 0, 0.1), 3, 0.5, [[0.1, 1.0], [0.0], [0.0, 0.5, 0.2]])
    np.testing.assert_array_equal(by_row.motion.a, report.motion.a)


def test_report_without_a_path_moves_every_joint(arm):
    report = motion_report(arm, "hand", order=2)
    assert (report.path.jet(0.0, 2) != 0).all()
    np.testing.assert_allclose(report.path(0.0), np.sin([1, 2, 3]) / 2)
    np.testing.assert_allclose(report.path(0.0, 2), -np.sin([1, 2, 3]) / 2)


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ({"body": "arm"}, "'arm'.*column, carriage, hand, tool"),
        ({"order": 0}, "order: expected an integer >= 1, got 0"),
        ({"order": 2.0}, "order"),
        ({"at": float("nan")}, "time"),
        ({"point": (1, 2)}, "point"),
        ({"point": (1, 2, np.inf)}, "finite"),
        ({"joints": [[0.0, 1.0]]}, r"3 joints \(turn, slide, wrist\), got 1"),
        ({"joints": [[0.0], [], [1.0]]}, "'slide'"),
        ({"joints": [[0.0], [np.nan], [1.0]]}, "finite"),
        ({"joints": {"elbow": [1.0]}}, "unknown joint 'elbow'.*turn, slide, wrist"),
        ({"body": "base"}, "no moving joint"),
    ],
)
def test_bad_input(arm, arguments, message):
    with pytest.raises(ValueError, match=message):
        motion_report(**{"urdf": arm, "body": "tool", "order": 2, **arguments})


def test_bad_files(tmp_path):
    with pytest.raises(ValueError, match="no URDF file"):
        motion_report(tmp_path / "none.urdf", "tool")
    (tmp_path / "bad.urdf").write_text("<robot")
    with pytest.raises(ValueError, match="Drake cannot read"):
        motion_report(tmp_path / "bad.urdf", "tool")


def test_wrong_state_shape(arm):
    with pytest.raises(ValueError, match=r"shape \(3, N\+1\)"):
        robot_motion(load_urdf(arm), "tool", np.zeros((4, 3)))

"""URDF files: what they mean, held against yourdfpy (which shares nothing with us or Drake) and Drake's parser."""

import numpy as np
import pytest

from workbench.drake.plants import PlantError, load_urdf, robot_data_directory
from workbench.kinematics.robot import Robot, UrdfError

FILE = """<robot name="r"><link name="base"/><link name="arm"/><link name="ship"/><link name="hand"/><link name="finger"/>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/><axis xyz="0 3 4"/></joint>
<joint name="sail" type="floating"><parent link="arm"/><child link="ship"/><origin xyz="0 0 1" rpy="0.4 0 0"/></joint>
<joint name="k" type="revolute"><parent link="ship"/><child link="hand"/><origin xyz="0 1 0"/><axis xyz="1 0 0"/><limit lower="-1" upper="2" velocity="3" effort="1"/></joint>
<joint name="m" type="prismatic"><parent link="hand"/><child link="finger"/><axis xyz="0 0 1"/><mimic joint="k" multiplier="0.5" offset="0.2"/></joint>
</robot>"""


def urdfs():
    try:
        return sorted(robot_data_directory().rglob("*.urdf"))
    except PlantError:
        return []


def motions(robot, seed):
    q = np.random.default_rng(seed).uniform(-1, 1, size=(3, len(robot.positions)))
    return q, robot.motion(q)


needs_robots = pytest.mark.skipif(not urdfs(), reason="the extra 'robots' is not installed")


def assert_poses_are_those_of_an_independent_reader(path, seed):
    yourdfpy = pytest.importorskip("yourdfpy")
    robot = Robot.from_urdf(path)
    q, motion = motions(robot, seed)
    theirs = yourdfpy.URDF.load(str(path), load_meshes=False, build_collision_scene_graph=False)
    theirs.update_cfg(
        {joint.name: q[0, robot.positions.index(joint.name)] for joint in theirs.actuated_joints}
    )
    assert set(theirs.link_map) == set(robot.bodies) | {"world"} & set(theirs.link_map)
    for link in theirs.link_map:
        X = theirs.get_transform(link, theirs.base_link)
        np.testing.assert_allclose(motion.frame(link).pose, X, rtol=0, atol=1e-9, err_msg=link)


REFUSED = {
    "ur3": "at least one <link>, got none",
    "alex_psyonic_hands": "mimics 'index_q1', which does not exist",
}


@needs_robots
@pytest.mark.parametrize("name", ["panda", "ur5_robot", "baxter", "solo12"])
def test_poses_are_those_of_an_independent_reader(name):
    assert_poses_are_those_of_an_independent_reader({path.stem: path for path in urdfs()}[name], 0)


@pytest.mark.slow
@needs_robots
@pytest.mark.parametrize("path", urdfs(), ids=lambda path: path.stem)
def test_every_robot_s_poses_are_those_of_an_independent_reader(path):
    if path.stem not in REFUSED:
        assert_poses_are_those_of_an_independent_reader(path, 1)


@pytest.mark.slow
@needs_robots
def test_every_robot_loads_or_one_sentence_says_why_not():
    refused = {}
    for path in urdfs():
        try:
            robot = Robot.from_urdf(path)
            assert robot.bodies and repr(robot)
        except UrdfError as error:
            refused[path.stem] = str(error)
    assert refused.keys() == REFUSED.keys()
    for name, message in refused.items():
        assert REFUSED[name] in message and "\n" not in message


@pytest.mark.slow
@needs_robots
@pytest.mark.parametrize("path", urdfs(), ids=lambda path: path.stem)
@pytest.mark.parametrize("base", ["fixed", "floating"])
def test_every_robot_moves_as_its_plant_does(path, base):
    """Two parsers, two libraries: velocity and acceleration of each body."""
    try:
        Robot.from_urdf(path, base)
    except ValueError as error:
        assert path.stem in REFUSED or "its root is the world itself" in str(error)
    else:
        assert_moves_as_its_plant(path, base)


@needs_robots
@pytest.mark.parametrize("name", ["panda", "anymal", "talos_reduced", "icub_reduced", "romeo", "pr2"])
def test_whole_robots_move_as_their_plants_do(name):
    assert_moves_as_its_plant({path.stem: path for path in urdfs()}[name], "floating")


def assert_moves_as_its_plant(path, base):
    robot = Robot.from_urdf(path, base, "rpy")
    plant = load_urdf(path, base)
    q, _ = motions(robot, 1)
    motion = robot.motion(q)
    matrix, offset = robot.follow(plant.GetPositionNames(False, False))
    context = plant.CreateDefaultContext()
    plant.SetPositions(context, matrix @ q[0] + offset)
    plant.SetVelocities(context, matrix @ q[1])
    A = plant.CalcSpatialAccelerationsFromVdot(context, matrix @ q[2])
    for name in robot.bodies:
        body, frame = plant.GetBodyByName(name), motion.frame(name)
        near = {"rtol": 0, "atol": 1e-9, "err_msg": f"{path.stem} {name}"}
        np.testing.assert_allclose(
            frame.pose, plant.EvalBodyPoseInWorld(context, body).GetAsMatrix4(), **near
        )
        V = plant.EvalBodySpatialVelocityInWorld(context, body).get_coeffs()
        np.testing.assert_allclose(frame.twist(0), V, **near)
        np.testing.assert_allclose(frame.twist(1), A[int(body.index())].get_coeffs(), **near)


@pytest.fixture
def file(tmp_path):
    def written(text):
        path = tmp_path / "robot.urdf"
        path.write_text(text)
        return path

    return written


def rotation(axis, angle):
    axis = np.asarray(axis) / np.linalg.norm(axis)
    skew = np.cross(np.eye(3), axis)
    return np.eye(3) + np.sin(angle) * skew + (1 - np.cos(angle)) * skew @ skew


def transform(R=None, p=(0, 0, 0)):
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = np.eye(3) if R is None else R, p
    return X


def test_a_floating_joint_inside_the_tree_moves_its_descendants(file):
    """By hand: base – turn – floating – turn – mimic."""
    robot = Robot.from_urdf(file(FILE), rotations="rpy")
    assert robot.positions == ("j", "sail_qx", "sail_qy", "sail_qz", "sail_x", "sail_y", "sail_z", "k")
    q = np.array([0.3, 0.1, -0.2, 0.5, 0.7, 0.8, 0.9, 0.4])
    x, y, z = np.eye(3)
    rpy = lambda r, p, w: rotation(z, w) @ rotation(y, p) @ rotation(x, r)  # noqa: E731
    X = transform(rpy(0.1, 0.2, 0.3), (1, 2, 3)) @ transform(rotation((0, 3, 4), 0.3))
    X = X @ transform(rpy(0.4, 0, 0), (0, 0, 1)) @ transform(rpy(0.1, -0.2, 0.5), (0.7, 0.8, 0.9))
    X = X @ transform(p=(0, 1, 0)) @ transform(rotation(x, 0.4)) @ transform(p=(0, 0, 0.5 * 0.4 + 0.2))
    motion = robot.motion(np.stack([q, q]))
    np.testing.assert_allclose(motion.frame("finger").pose, X, atol=1e-14)
    assert_moves_as_its_plant(file(FILE), "fixed")
    assert_moves_as_its_plant(file(FILE), "floating")


def test_limits_are_the_file_s(file):
    limits = Robot.from_urdf(file(FILE)).limits
    assert limits["k"][:3] == (-1, 2, 3) and np.isnan(limits["k"].jerk) and np.isnan(limits["j"].upper)
    text = FILE.replace('velocity="3"', 'velocity="3" acceleration="4" deceleration="5" jerk="inf"')
    k = Robot.from_urdf(file(text)).limits["k"]
    assert (k.acceleration, k.deceleration) == (4, 5) and np.isnan(k.jerk)


DRAKE_JOINTS = """<robot name="r" xmlns:drake="http://drake.mit.edu"><link name="a"/><link name="b"/><link name="c"/><link name="d"/><link name="e"/>
<drake:joint name="ball" type="ball"><parent link="a"/><child link="b"/><origin xyz="1 2 3" rpy="0.1 0.2 0.3"/></drake:joint>
<drake:joint name="screw" type="screw"><parent link="b"/><child link="c"/><origin xyz="0 0 1"/><axis xyz="0 0.6 0.8"/><drake:screw_thread_pitch value="0.7"/></drake:joint>
<drake:joint name="cross" type="universal"><parent link="c"/><child link="d"/><origin xyz="0 1 1"/></drake:joint>
<drake:joint name="ice" type="planar"><parent link="d"/><child link="e"/><origin xyz="1 1 1" rpy="1 0 0"/></drake:joint></robot>"""


def test_drake_s_own_joints_are_read_as_drake_reads_them(file):
    assert_moves_as_its_plant(file(DRAKE_JOINTS), "fixed")
    assert_moves_as_its_plant(
        file(DRAKE_JOINTS.replace(' xmlns:drake="http://drake.mit.edu"', "")), "floating"
    )


def test_a_floating_base_moves_by_a_quaternion(file):
    robot = Robot.from_urdf(file(FILE), "floating")
    assert robot.positions[:4] == ("base_qw", "base_qx", "base_qy", "base_qz")
    assert len(robot.velocities) == len(robot.positions) - 2
    q = robot.default_positions
    v = np.zeros((1, len(robot.velocities)))
    v[0, :6] = 1, 2, 3, 4, 5, 6
    np.testing.assert_allclose(robot.motion(q, v).frame("base").twist(), [1, 2, 3, 4, 5, 6])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "not XML"),
        ("<robot", "not XML"),
        ("<html></html>", "outermost tag is <robot>, got <html>"),
        ('<robot name="r"/>', "at least one <link>, got none"),
        ('<robot><link name="a"/><link name="a"/></robot>', "link 'a' is there 2 times"),
        ('<robot><link name="a"/><link name="b"/></robot>', "one root link, got 2 .*: a, b"),
        (
            '<robot xmlns:xacro="http://ros.org/wiki/xacro"><xacro:property name="x" value="1"/></robot>',
            "xacro .* not expanded.*run `xacro",
        ),
        ('<robot><xacro:macro name="m"/></robot>', "xacro .* not expanded"),
        ('<robot xmlns:xacro="x"><xacro:macro name="m"/></robot>', "xacro .* not expanded"),
        (FILE.replace('type="continuous"', 'type="spin"'), "joint 'j': expected a type among .* got 'spin'"),
        (FILE.replace('xyz="0 3 4"', 'xyz="0 0 0"'), "joint 'j': .*non-zero length"),
        (
            FILE.replace('xyz="0 3 4"', 'xyz="0 3"'),
            "joint 'j': axis: expected 3 finite numbers for xyz, got '0 3'",
        ),
        (FILE.replace('xyz="1 2 3"', 'xyz="1 2 nan"'), "joint 'j': origin: expected 3 finite"),
        (FILE.replace('<child link="arm"/>', '<child link="leg"/>'), "joint 'j': no link 'leg'"),
        (FILE.replace('<child link="arm"/>', ""), "joint 'j': expected a <child>"),
        (FILE.replace('<mimic joint="k"', '<mimic joint="x"'), "mimics 'x', which does not exist"),
        (FILE.replace('<mimic joint="k"', '<mimic joint="sail"'), "mimics 'sail', a floating joint"),
        (FILE.replace('<parent link="base"/>', '<parent link="hand"/>'), "root|circle"),
    ],
)
def test_files_that_no_robot_can_be_made_of(file, text, message):
    path = file(text)
    with pytest.raises(UrdfError, match=message) as caught:
        Robot.from_urdf(path)
    assert str(path) in str(caught.value) and "\n" not in str(caught.value)


def test_an_expanded_xacro_may_keep_commands_as_comments(file):
    kept = file(FILE.replace("</robot>", "<!-- <xacro:if value='1'>\n<xacro:m/> --></robot>"))
    assert Robot.from_urdf(kept).bodies == Robot.from_urdf(file(FILE)).bodies


def test_a_missing_file_and_an_unknown_base(tmp_path, file):
    with pytest.raises(UrdfError, match="no URDF file at"):
        Robot.from_urdf(tmp_path / "none.urdf")
    with pytest.raises(ValueError, match="expected fixed or floating"):
        Robot.from_urdf(file(FILE), "free")


PLAIN = '<robot name="r"><link name="base"/><link name="arm"/><joint name="j" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/><limit effort="1" velocity="1"/></joint></robot>'


@pytest.mark.parametrize(
    "text",
    [
        PLAIN.replace("<robot", '<robot xmlns="http://www.ros.org"'),
        PLAIN.replace(
            "<robot",
            '<robot xmlns="http://drake.mit.edu" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance"',
        ),
        PLAIN.replace("</robot>", '<gazebo><sensor:camera name="rgb"/></gazebo></robot>'),
        PLAIN.replace("</robot>", "<!-- forked --\n<!-- - -- ------ --></robot>"),
        PLAIN.replace("</robot>", "<xacro:left_over/></robot>"),
        PLAIN.replace("</robot>", '<xacro:property name="x" value="${1}"/></robot>'),
        PLAIN.replace("</robot>", '<xacro:include filename="$(find x)/y.xacro"/></robot>'),
        '<?xml vertsion="1.0"?>' + PLAIN,
        "\n\n" + PLAIN,
    ],
)
def test_unknown_names_and_declarations_do_not_matter(file, text):
    assert Robot.from_urdf(file(text)).positions == ("j",)
    assert_moves_as_its_plant(file(text), "floating")


@pytest.mark.parametrize(
    "text",
    [
        PLAIN.replace("</robot>", '<xacro:macro name="m"><link name="x"/></xacro:macro></robot>'),
        PLAIN.replace("</robot>", '<xacro:if value="1"><joint name="x"/></xacro:if></robot>'),
        PLAIN.replace("</robot>", '<xacro:include filename="y"/><xacro:leg side="l"/></robot>'),
        PLAIN.replace('"0 0 1"', '"${x} 0 1"'),
        '<robot><link name="a"/><xacro:include filename="y"/></robot>',
    ],
)
def test_a_xacro_whose_links_or_joints_are_to_come_is_refused(file, text):
    with pytest.raises(UrdfError, match="xacro that is not expanded"):
        Robot.from_urdf(file(text))


def test_a_joint_named_base_is_no_clash(file):
    path = file(PLAIN.replace('name="j"', 'name="base"'))
    assert Robot.from_urdf(path).positions == ("base",)
    assert Robot.from_urdf(path, "floating", "rpy").positions[0] == "floating_base_qx"
    for base in ("fixed", "floating"):
        assert_moves_as_its_plant(path, base)


def test_the_world_needs_no_link(file):
    path = file(PLAIN.replace('<link name="base"/>', "").replace('link="base"', 'link="world"'))
    assert Robot.from_urdf(path).bodies == ("arm",)
    assert_moves_as_its_plant(path, "fixed")
    with pytest.raises(ValueError, match="its root is the world itself"):
        Robot.from_urdf(path, "floating")


def test_a_chain_may_have_a_thousand_joints(file):
    links = "".join(f'<link name="l{i}"/>' for i in range(991))
    joint = '<joint name="j{}" type="revolute"><parent link="l{}"/><child link="l{}"/><axis xyz="0 0 1"/><origin xyz="1 0 0"/></joint>'
    joints = "".join(joint.format(i, i, i + 1) for i in range(990))
    robot = Robot.from_urdf(file(f'<robot name="r">{links}{joints}</robot>'))
    q = np.zeros((2, 990))
    q[1, 0] = 1
    tip = robot.motion(q).frame("l990")
    np.testing.assert_allclose(tip.pose[:3, 3], [990, 0, 0])
    np.testing.assert_allclose(tip.twist(0), [0, 0, 1, 0, 989, 0])


def test_a_path_that_cannot_be_read_is_a_urdf_error(tmp_path):
    for path in (tmp_path, tmp_path / ("x" * 300), tmp_path / "none.urdf"):
        with pytest.raises(UrdfError, match=r"no URDF file at|cannot be read"):
            Robot.from_urdf(path)

"""Robots from SDF, MJCF and model directives, by Drake's parser."""

import logging

import numpy as np
import pytest
from kinematics.random_robots import NEAR

from workbench.drake.plants import load_urdf
from workbench.kinematics.robot import Robot

SDF = """<sdf version="1.9"><model name="arm">
  <link name="base"/>
  <link name="upper"><pose>0 0 0.5 0 0 0</pose></link>
  <link name="lower"><pose>0 0 1.2 0 0 0</pose></link>
  <joint name="shoulder" type="revolute"><parent>base</parent><child>upper</child>
    <axis><xyz>0 1 0</xyz><limit><lower>-1</lower><upper>2</upper></limit></axis></joint>
  <joint name="elbow" type="prismatic"><parent>upper</parent><child>lower</child>
    <axis><xyz>0 0 1</xyz></axis></joint>
</model></sdf>"""

MJCF = """<mujoco model="arm"><worldbody>
  <body name="upper" pos="0 0 0.5"><joint name="shoulder" type="hinge" axis="0 1 0"/>
    <geom type="sphere" size="0.1" mass="2"/>
    <body name="lower" pos="0 0 0.7"><joint name="elbow" type="slide" axis="0 0 1"/>
      <geom type="sphere" size="0.1" mass="1"/></body></body>
</worldbody></mujoco>"""

URDF = """<robot name="arm"><link name="base"/><link name="upper"/><link name="lower"/>
  <joint name="shoulder" type="continuous"><parent link="base"/><child link="upper"/>
    <origin xyz="0 0 0.5"/><axis xyz="0 1 0"/></joint>
  <joint name="elbow" type="prismatic"><parent link="upper"/><child link="lower"/>
    <origin xyz="0 0 0.7"/><axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
</robot>"""


@pytest.fixture
def files(tmp_path):
    paths = {}
    for name, text in (("sdf", SDF), ("xml", MJCF), ("urdf", URDF)):
        paths[name] = tmp_path / f"arm.{name}"
        paths[name].write_text(text)
    return paths


@pytest.mark.parametrize("kind", ["sdf", "xml", "urdf"])
def test_one_arm_in_three_formats_moves_alike(files, kind):
    robot, expected = Robot.from_file(files[kind]), Robot.from_urdf(files["urdf"])
    assert robot.name == "arm" and robot.positions == ("shoulder", "elbow")
    q = np.random.default_rng(0).normal(size=(5, 3, 2))
    ours, theirs = robot.motion(q).frame("lower"), expected.motion(q).frame("lower")
    np.testing.assert_allclose(ours.pose, theirs.pose, **NEAR)
    np.testing.assert_allclose(ours.twists, theirs.twists, **NEAR)


def test_an_mjcf_file_needs_no_name_of_its_model(files):
    named = Robot.from_file(files["xml"])
    files["xml"].write_text(MJCF.replace(' model="arm"', ""))
    nameless, q = Robot.from_file(files["xml"]), np.random.default_rng(0).normal(size=(3, 2, 2))
    assert (nameless.name, nameless.positions) == (named.name, named.positions)
    np.testing.assert_array_equal(nameless.motion(q).torques(), named.motion(q).torques())


def test_a_file_s_limits_and_inertias_are_kept(files):
    assert Robot.from_file(files["sdf"]).limits["shoulder"][:2] == (-1.0, 2.0)
    robot = Robot.from_file(files["xml"])
    assert robot.inertias["upper"].mass == pytest.approx(2.0)
    torque = robot.motion(np.array([[np.pi / 2, 0.0], [0, 0], [0, 0]])).torques()
    np.testing.assert_allclose(torque[0], [-9.81 * 0.7, 0.0], atol=1e-9)


def test_a_base_that_nothing_holds_is_welded_or_floats(files):
    assert Robot.from_file(files["sdf"]).positions == ("shoulder", "elbow")
    floating = Robot.from_file(files["sdf"], base="floating")
    assert len(floating.positions) == 9 and len(floating.velocities) == 8


def test_several_models_and_packages_in_one_file(files, tmp_path):
    directives = tmp_path / "two.dmd.yaml"
    directives.write_text(
        "directives:\n"
        + "".join(
            f"- add_model:\n    name: {name}\n    file: package://arms/arm.sdf\n"
            for name in ("left", "right")
        )
    )
    robot = Robot.from_file(directives, packages={"arms": tmp_path})
    assert robot.positions == ("left::shoulder", "left::elbow", "right::shoulder", "right::elbow")
    assert "right::lower" in robot.bodies


def test_files_that_cannot_be_read_are_named_in_one_line(files, tmp_path):
    bad = tmp_path / "bad.sdf"
    bad.write_text("<sdf><model>")
    for path, message in (
        (tmp_path / "none.sdf", "no file at"),
        (bad, "Drake cannot read .*bad.sdf"),
    ):
        with pytest.raises(ValueError, match=message) as error:
            Robot.from_file(path)
        assert "\n" not in str(error.value)
    with pytest.raises(ValueError, match="base: expected fixed or floating, got 'free'"):
        Robot.from_file(files["sdf"], base="free")


@pytest.mark.parametrize("reader", [Robot.from_file, load_urdf])
@pytest.mark.parametrize("limit", ['lower="1" upper="-1"', 'lower="-1" upper="1" velocity="-1"'])
def test_a_condition_that_drake_demands_ends_no_program(tmp_path, reader, limit):
    path = tmp_path / "reversed.urdf"
    path.write_text(URDF.replace('lower="-1" upper="1" effort="1" velocity="1"', limit))
    with pytest.raises(ValueError, match=r"Drake cannot read .*reversed.urdf: .*condition") as caught:
        reader(path)
    assert "\n" not in str(caught.value)


IMPOSSIBLE = {
    "sdf": "<inertia><ixx>5</ixx><iyy>15</iyy><izz>25</izz></inertia>",
    "urdf": '<inertia ixx="5" iyy="15" izz="25" ixy="0" ixz="0" iyz="0"/>',
}


@pytest.mark.parametrize("silent", [False, True])
@pytest.mark.parametrize("kind", IMPOSSIBLE)
def test_no_torques_of_inertias_that_drake_replaces(files, kind, silent):
    mass = "<mass>2</mass>" if kind == "sdf" else '<mass value="2"/>'
    inertial = f'<link name="lower"><inertial>{mass}{IMPOSSIBLE[kind]}</inertial>'
    old, new = (
        ('<link name="lower">', inertial) if kind == "sdf" else ('<link name="lower"/>', inertial + "</link>")
    )
    files[kind].write_text(files[kind].read_text().replace(old, new))
    logger = logging.getLogger("drake")
    logger.disabled = silent
    try:
        robot = Robot.from_file(files[kind])
        assert logger.disabled is silent
    finally:
        logger.disabled = False
    with pytest.raises(ValueError, match=rf"arm.{kind}:\d+: an inertia that no body can have, which Drake"):
        robot.motion(np.zeros((3, 2))).torques()
    with pytest.raises(ValueError, match="which Drake replaces"):
        robot.with_frame("tool", "lower", np.eye(4)).motion(np.zeros((3, 2))).torques()

"""Torques with the inertia of rotors, and MJCF files of which Drake's parser reads a part."""

from itertools import pairwise

import numpy as np
import pytest
from kinematics.random_robots import motion, tree
from test_robot_torques import drakes_torques, floating_plant, hand

from workbench.drake.plants import load_models
from workbench.kinematics.robot import Mimic, Robot, TreeJoint


def with_armatures(robot, seed=0):
    """The same robot with a rotor at each joint, and one inertia to start from."""
    rng, joints = np.random.default_rng(seed), []
    for j in robot.joints:
        own = {name: getattr(j, name) for name in ("X_PF", "X_MC", "axis", "pitch", "limits", "mimic")}
        joints.append(TreeJoint(j.name, j.kind, j.parent, j.child, **own, armature=rng.uniform(0, 1)))
    found = Robot(robot.name, joints)
    found.inertias = robot.inertias
    return found


@pytest.mark.parametrize("gear", [1.0, 7.5])
@pytest.mark.parametrize("floating", [False, True])
def test_torques_with_rotors_are_drake_s(gear, floating):
    from drake_arms import arm_plant
    from pydrake.multibody.plant import MultibodyPlant

    finalize = MultibodyPlant.Finalize

    def with_actuators(plant):
        for index in plant.GetJointIndices():
            joint = plant.get_joint(index)
            if joint.num_velocities() == 1:
                actuator = plant.AddJointActuator(f"of {joint.name()}", joint)
                actuator.set_default_rotor_inertia(0.01 * (1 + int(index)))
                actuator.set_default_gear_ratio(gear)
        finalize(plant)

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(MultibodyPlant, "Finalize", with_actuators)
        plant = floating_plant() if floating else arm_plant(5, seed=4)
    robot, rng = Robot.from_plant(plant), np.random.default_rng(1)
    q, v = rng.normal(size=plant.num_positions()), rng.normal(size=(2, plant.num_velocities()))
    if floating:
        q[:4] /= np.linalg.norm(q[:4])
    right = drakes_torques(plant, q, *v)
    np.testing.assert_allclose(robot.motion(q, v).torques()[0], right, rtol=0, atol=1e-12 * abs(right).max())
    assert robot.armatures.max() > 0


def test_rotors_take_the_power_that_their_energy_gains():
    """τ · v = d/dt Σ A v²/2, and the same of its rates: (τ − τ without rotors)⁽ᵏ⁾ = A v⁽ᵏ⁺¹⁾, all joint kinds."""
    bare = tree(3)
    from workbench.kinematics.robot.dynamics import Inertia

    bare.inertias = {name: Inertia(1.0, np.zeros(3), np.eye(3)) for name in bare.bodies}
    robot = with_armatures(bare)
    now, without = motion(robot, 4, (3,)), motion(bare, 4, (3,))
    power = ((now.torques()[0] - without.torques()[0]) * now.rates[0]).sum(axis=-1)
    np.testing.assert_allclose(power, (robot.armatures * now.rates[0] * now.rates[1]).sum(axis=-1), atol=1e-9)
    for rotors, rate in zip(now.torques(2) - without.torques(2), now.rates[1:], strict=False):
        np.testing.assert_allclose(
            rotors, robot.armatures * rate, atol=1e-9 * max(1, abs(now.torques(2)).max())
        )


def test_actuators_that_differ_on_one_joint_give_no_torques():
    """Drake takes the last one's rotor."""
    from pydrake.multibody.plant import MultibodyPlant
    from pydrake.multibody.tree import RevoluteJoint, SpatialInertia

    plant = MultibodyPlant(0.0)
    body = plant.AddRigidBody("a", SpatialInertia.SolidSphereWithMass(1.0, 0.1))
    joint = plant.AddJoint(RevoluteJoint("j", plant.world_frame(), body.body_frame(), [0, 0, 1]))
    for number, inertia in enumerate((0.1, 0.2)):
        plant.AddJointActuator(f"m{number}", joint).set_default_rotor_inertia(inertia)
    plant.Finalize()
    with pytest.raises(ValueError, match=r"joint 'j': expected actuators of one inertia, got 0\.1 and 0\.2"):
        Robot.from_plant(plant).motion(np.zeros((3, 1))).torques()


def test_a_rotor_of_a_joint_that_follows_counts_by_its_factor():
    joints = [
        TreeJoint("j", "revolute", "world", "a", armature=0.5),
        TreeJoint("k", "revolute", "a", "b", mimic=Mimic("j", -3.0), armature=0.25),
    ]
    np.testing.assert_allclose(Robot("two", joints).armatures, [0.5 + 9 * 0.25])
    with pytest.raises(ValueError, match="joint 'j': expected an armature >= 0, got -1"):
        TreeJoint("j", "revolute", "world", "a", armature=-1)


TRANSMISSION = """<transmission name="t"><type>KIND</type><joint name="j"/><actuator name="m">
<drake:rotor_inertia value="0.02"/><drake:gear_ratio value="9"/></actuator></transmission></robot>"""


def test_rotors_of_a_urdf_are_those_of_drake_s_parser(tmp_path):
    path = hand(tmp_path, "")
    path.write_text(
        path.read_text().replace("</robot>", TRANSMISSION.replace("KIND", "a/SimpleTransmission"))
    )
    ours, drakes = Robot.from_urdf(path), Robot.from_file(path)
    np.testing.assert_allclose(ours.armatures, [0.02 * 81, 0.0])
    q = np.random.default_rng(0).normal(size=(4, 2))
    np.testing.assert_allclose(ours.motion(q).torques(1), drakes.motion(q).torques(1), atol=1e-11)
    tool = ours.with_frame("tool", "tip", np.eye(4))
    np.testing.assert_array_equal(tool.armatures, ours.armatures)


def test_a_rotor_that_is_not_understood_gives_no_torques(tmp_path):
    path = hand(tmp_path, "")
    path.write_text(path.read_text().replace("</robot>", TRANSMISSION.replace("KIND", "Differential")))
    for reader, message in (
        (Robot.from_urdf, "transmission 't' with a rotor: expected a SimpleTransmission"),
        (Robot.from_file, r"hand.urdf:\d+: a rotor on a transmission that Drake does not read"),
    ):
        found = reader(path).motion(np.zeros((3, 2)))
        with pytest.raises(ValueError, match=message):
            found.torques()


INERTIAL = '<inertial pos="0.1 0 0" mass="1" diaginertia="0.01 0.01 0.01"/>'
MJCF = f"""<mujoco model="m">
<default><joint armature="0.3"/><default class="x"><joint damping="1"/>
  <default class="y"><joint armature="0.9"/></default></default></default>
<worldbody><body name="a" childclass="x">{INERTIAL}<joint name="j" axis="0 0 1"/><joint type="slide" class="y"/>
  <body name="b" pos="0.2 0 0" childclass="y">{INERTIAL}<joint name="k" axis="0 1 0" armature="0"/>
    <body name="c" pos="0.1 0 0">{INERTIAL}<joint name="l" type="ball"/></body></body>
  <body name="d" pos="0.1 0 0">{INERTIAL}<joint name="m" class="main"/></body></body>
  <body name="f">{INERTIAL}<joint name="free" type="free"/></body><body name="g">{INERTIAL}<freejoint/></body></worldbody>
<actuator><motor joint="j" gear="3"/><motor joint="m"/></actuator></mujoco>"""


def test_armatures_of_mjcf_are_read_with_and_without_actuators(tmp_path):
    """Drake reads those of joints with an actuator; MuJoCo has them for all joints, but for <freejoint>."""
    path = tmp_path / "m.xml"
    path.write_text(MJCF)
    robot = Robot.from_file(path, base="floating")
    by_joint = {j.name: j.armature for j in robot.joints}
    assert by_joint == {"j": 0.3, "a0-a": 0.9, "k": 0, "l": 0.9, "m": 0.3, "f": 0.3, "g": 0}
    q = robot.default_positions
    acceleration = np.stack([np.zeros(len(robot.velocities)), np.ones(len(robot.velocities))])
    plant = load_models(path, "floating").plant
    driven = {"j", "m"}
    left_out = [
        0.0 if name in driven else a for name, a in zip(robot.velocities, robot.armatures, strict=True)
    ]
    right = drakes_torques(plant, plant.GetPositions(plant.CreateDefaultContext()), *acceleration) + left_out
    np.testing.assert_allclose(robot.motion(q, acceleration).torques()[0], right, atol=1e-12)


def test_armatures_of_included_mjcf_files_are_read(tmp_path):
    (tmp_path / "arm.xml").write_text(MJCF)
    scene = tmp_path / "scene.xml"
    scene.write_text('<mujoco model="scene"><include file="arm.xml"/></mujoco>')
    np.testing.assert_array_equal(
        Robot.from_file(scene).armatures, Robot.from_file(tmp_path / "arm.xml").armatures
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (('armature="0"', 'armature="-1"'), "joint 'k' of the body 'b': expected an armature >= 0, got '-1'"),
        (
            (INERTIAL, '<geom type="box" fromto="0 0 0 1 0 0" size="0.1"/>'),
            "the mass of body 'a' is that of its geoms",
        ),
        ((INERTIAL, '<geom type="mesh" mesh="gone"/>'), "the mass of body 'a' is that of its geoms"),
    ],
)
def test_mjcf_that_drake_reads_in_part_gives_no_torques(tmp_path, change, message):
    path = tmp_path / "m.xml"
    path.write_text(MJCF.replace(*change))
    found = motion(Robot.from_file(path), 2)
    assert np.isfinite(found.frame("c").pose).all()
    with pytest.raises(ValueError, match=message):
        found.torques()


def test_directives_with_mjcf_files_give_no_torques(tmp_path):
    (tmp_path / "m.xml").write_text(MJCF)
    path = tmp_path / "m.dmd.yaml"
    path.write_text("directives:\n- add_model:\n    name: one\n    file: package://here/m.xml\n")
    found = motion(Robot.from_file(path, packages={"here": tmp_path}), 2)
    with pytest.raises(ValueError, match=r"m\.dmd\.yaml: armatures of an MJCF file in it are not read"):
        found.torques()


def test_meshes_of_mjcf_files_are_not_needed(tmp_path):
    asset = '<asset><mesh name="x" file="gone.stl"/></asset><worldbody>'
    path, plain = tmp_path / "m.xml", tmp_path / "plain.xml"
    plain.write_text(MJCF)
    path.write_text(
        MJCF.replace("<worldbody>", asset).replace(
            INERTIAL, INERTIAL + '<geom class="x" type="mesh" mesh="x"/>'
        )
    )
    right, found = (motion(Robot.from_file(file), 3) for file in (plain, path))
    for one, other in pairwise([right.torques(1), found.torques(1)]):
        np.testing.assert_allclose(one, other, atol=1e-12)

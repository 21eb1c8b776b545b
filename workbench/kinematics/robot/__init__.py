"""A robot's motion to any order: `Robot`.

What is this? `robot` is the entry; `structure` and `joints` describe the mechanism, `trajectories` and
`recording` its motion in time, `states` and `motion` the result, `peaks` the extremes on a trajectory. When
do I come here? To add a kind of joint, a source of trajectories or a question to a robot. What may it import?
algebra, drake, kinematics. What checks it? tests/kinematics/robot.
"""

from workbench.kinematics.robot.closed_loops import BallConstraint, ClosedLoops, WeldConstraint
from workbench.kinematics.robot.inverse import SingularJacobian
from workbench.kinematics.robot.joints import Mimic, TreeJoint
from workbench.kinematics.robot.robot import Robot
from workbench.kinematics.robot.robot_urdf import UrdfError
from workbench.kinematics.robot.trajectories.spline_paths import waypoints
from workbench.kinematics.robot.trajectories.time_scaling import slowed

__all__ = [
    "BallConstraint",
    "ClosedLoops",
    "Mimic",
    "Robot",
    "SingularJacobian",
    "TreeJoint",
    "UrdfError",
    "WeldConstraint",
    "slowed",
    "waypoints",
]

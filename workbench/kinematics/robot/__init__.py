"""A robot's motion to any order: see `Robot`."""

from workbench.kinematics.robot.closed_loops import BallConstraint, ClosedLoops, WeldConstraint
from workbench.kinematics.robot.inverse import SingularJacobian
from workbench.kinematics.robot.joints import Mimic, TreeJoint
from workbench.kinematics.robot.robot import Robot
from workbench.kinematics.robot.robot_urdf import UrdfError

__all__ = [
    "BallConstraint",
    "ClosedLoops",
    "Mimic",
    "Robot",
    "SingularJacobian",
    "TreeJoint",
    "UrdfError",
    "WeldConstraint",
]

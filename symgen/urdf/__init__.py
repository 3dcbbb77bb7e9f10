"""Robots from URDF files: `read` gives a `Scene`, which also says what the file has and a scene has not."""

from symgen.urdf.robot import Assumed, Dropped, JointLimit, RobotWarning
from symgen.urdf.scene import RobotBuilder, read
from symgen.urdf.tree_kinematics import RobotKinematics

__all__ = ["Assumed", "Dropped", "JointLimit", "RobotBuilder", "RobotKinematics", "RobotWarning", "read"]

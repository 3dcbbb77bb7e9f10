"""Robots from URDF files: `read` gives a `Scene`, which also says what the file has and a scene has not."""

from symgen.urdf.robot import Dropped
from symgen.urdf.scene import RobotBuilder, read

__all__ = ["Dropped", "RobotBuilder", "read"]

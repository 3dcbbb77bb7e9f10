"""The joint types: each file of this folder is one, and says all that is known of it (`joint.py` says what that is)."""

from symgen.joints.joint import Joint
from symgen.schema.fields import types_of

JOINTS = types_of(__name__, __file__, Joint)

__all__ = ["JOINTS", "Joint"]

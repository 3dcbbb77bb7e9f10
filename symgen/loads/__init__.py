"""The load types: each file of this folder is one, and says all that is known of it (`load.py` says what that is)."""

from symgen.loads.load import Load
from symgen.schema.fields import types_of

LOADS = types_of(__name__, __file__, Load)  # type: ignore[type-abstract]

__all__ = ["LOADS", "Load"]

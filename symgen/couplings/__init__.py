"""Couplings, rows between coordinates of joints: each file is a type (`coupling.py` says what that is)."""

from symgen.couplings.coupling import Coupling
from symgen.schema.fields import types_of

COUPLINGS = types_of(__name__, __file__, Coupling)  # type: ignore[type-abstract]

__all__ = ["COUPLINGS", "Coupling"]

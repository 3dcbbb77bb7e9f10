"""Dimensionless modal data of a uniform beam: shapes, stiffness, foreshortening and inertia shape integrals.

Everything here is numbers for a beam of unit length, mass and stiffness (EI = EA = L = rho A = 1); the
docstrings of the classes say how each quantity is scaled by a real beam's length, mass and stiffness.
Eqs. 15-20 of the paper use these numbers as Phi_k, M_ff, K_ff and inertia shape integrals.
"""

from warnings import warn

from symgen.modes.axial import AXIAL_ENDS, BarModes, axial_modes
from symgen.modes.cleaning import clean
from symgen.modes.integrals import BeamIntegrals, BeamPoint, beam_integrals
from symgen.modes.lateral import LATERAL_ENDS, BeamModes, LateralPoint, lateral_modes

__all__ = [
    "AXIAL_ENDS",
    "LATERAL_ENDS",
    "BarModes",
    "BeamIntegrals",
    "BeamPoint",
    "BeamModes",
    "LateralPoint",
    "axial_modes",
    "beam_integrals",
    "clean",
    "lateral_modes",
]

_RENAMED: dict[str, type[BarModes] | type[BeamModes]] = {"AxialModes": BarModes, "LateralModes": BeamModes}


def __getattr__(name: str) -> type[BarModes] | type[BeamModes]:
    if name in _RENAMED:
        new = _RENAMED[name]
        warn(f"symgen.modes.{name} is {new.__name__} since 0.4; the old name goes with 0.5", DeprecationWarning, 2)
        return new
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")

"""Dimensionless modal data of a uniform beam: shapes, stiffness, foreshortening and inertia shape integrals.

Everything here is numbers for a beam of unit length, mass and stiffness (EI = EA = L = rho A = 1); the
docstrings of the classes say how each quantity is scaled by a real beam's length, mass and stiffness.
Eqs. 15-20 of the paper use these numbers as Phi_k, M_ff, K_ff and inertia shape integrals.
"""

from symgen.modes.axial import AXIAL_ENDS, AxialModes, axial_modes
from symgen.modes.cleaning import clean
from symgen.modes.integrals import BeamIntegrals, BeamPoint, beam_integrals
from symgen.modes.lateral import LATERAL_ENDS, LateralModes, LateralPoint, lateral_modes

__all__ = [
    "AXIAL_ENDS",
    "LATERAL_ENDS",
    "AxialModes",
    "BeamIntegrals",
    "BeamPoint",
    "LateralModes",
    "LateralPoint",
    "axial_modes",
    "beam_integrals",
    "clean",
    "lateral_modes",
]

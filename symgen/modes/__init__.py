"""Dimensionless modal data of a uniform beam: shapes, stiffness, foreshortening and inertia shape integrals.

Everything here is numbers for a beam of unit length, mass and stiffness (EI = EA = L = rho A = 1); the
docstrings of the classes say how each quantity is scaled by a real beam's length, mass and stiffness.
Eqs. 15-20 of the paper use these numbers as Phi_k, M_ff, K_ff and inertia shape integrals.

Two ways to them: shapes in closed form with exact integrals (`exact_bending`, `exact_stretching`), and the paper's
mesh with lumped nodal masses (`lateral_modes`, `axial_modes`).
"""

from runtime.contract.flexible import BENDING, STRETCHING, panels_for
from symgen.modes.cleaning import clean
from symgen.modes.exact import (
    AXIAL_ENDS,
    LATERAL_ENDS,
    BarModes,
    BeamModes,
    ExactBarModes,
    ExactBeamModes,
    LateralPoint,
    axial_modes,
    exact_bending,
    exact_stretching,
    lateral_modes,
)
from symgen.modes.integrals import BeamIntegrals, BeamPoint, ModeSets, beam_integrals

__all__ = [
    "AXIAL_ENDS",
    "BENDING",
    "LATERAL_ENDS",
    "STRETCHING",
    "BarModes",
    "BeamIntegrals",
    "BeamPoint",
    "BeamModes",
    "ExactBarModes",
    "ExactBeamModes",
    "LateralPoint",
    "ModeSets",
    "axial_modes",
    "beam_integrals",
    "clean",
    "exact_bending",
    "exact_stretching",
    "lateral_modes",
    "panels_for",
]

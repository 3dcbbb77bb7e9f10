"""Units of files: lengths, masses and forces of other programs in SI, and values that cannot be meant."""

from __future__ import annotations

import warnings

import numpy as np
import scipy.sparse as sp
from numpy.typing import NDArray

from symgen.fe.structure import FiniteElementError, FiniteElementWarning, Material
from symgen.modes.cleaning import Array

LENGTHS = {"SI": 1.0, "mm-t-s": 1e-3, "mm-kg-s": 1e-3}  # of a unit of length [m]
MASSES = {"SI": 1.0, "mm-t-s": 1e3, "mm-kg-s": 1.0}  # [kg]
STRESSES = {name: MASSES[name] / LENGTHS[name] for name in LENGTHS}  # [Pa]: mass / (length time^2)
DENSITIES = (1.0, 3e4)  # of solids [kg/m^3]
MODULI = (1e5, 2e12)  # of Young [Pa]
SIZES = (1e-6, 1e3)  # of bodies [m]
MASS_IN_CUBE = (1e-7, 3e4)  # of bodies over the cube of their size [kg/m^3]


def known_units(units: str) -> str:
    """The units. Raises FiniteElementError for others."""
    if units not in LENGTHS:
        raise FiniteElementError("units", f"{units!r} are not known", f"take one of {', '.join(LENGTHS)}")
    return units


def in_si(matrix: Array, rotations: NDArray[np.bool_], units: str) -> Array:
    """A stiffness or mass matrix (n, n) in SI: its energy is that of units of mass length^2 / time^2.

    rotations (n,): rows of angles; the others are lengths or modal coordinates, whose unit is that of lengths.
    """
    known_units(units)
    energy = MASSES[units] * LENGTHS[units] ** 2
    scale = np.where(rotations, 1.0, LENGTHS[units])
    return np.asarray(energy * matrix / scale[:, None] / scale)


def sparse_in_si(matrix: sp.csr_matrix, rotations: NDArray[np.bool_], units: str) -> sp.csr_matrix:
    """As `in_si`, of a sparse matrix; one of another size, which is refused later, as it is."""
    if matrix.shape != (len(rotations),) * 2:
        return matrix
    scale = sp.diags(1.0 / np.where(rotations, 1.0, LENGTHS[known_units(units)]))
    return sp.csr_matrix(MASSES[units] * LENGTHS[units] ** 2 * (scale @ matrix @ scale))


def check_plausible(mass: float, size: float) -> None:
    """Warns of a mass [kg] and a size [m] that no machine part has, with what they are in millimetres and tonnes."""
    doubts = []
    if not SIZES[0] <= size <= SIZES[1]:
        doubts.append(f"a body {size:.3g} m long (read in mm: {1e-3 * size:.3g} m)")
    elif not MASS_IN_CUBE[0] <= mass / size**3 <= MASS_IN_CUBE[1]:
        read = f"{1e3 * mass:.3g} kg and {1e-3 * size:.3g} m"
        doubts.append(f"a body of {mass:.3g} kg that is {size:.3g} m long (read in mm, t, s: {read})")
    _warn(doubts, "units='mm-t-s' converts what is in mm, t, s")


def check_material(material: Material) -> None:
    """Warns of a density and a modulus that no material has, with what they are in millimetres and tonnes."""
    doubts = []
    if not DENSITIES[0] <= material.rho <= DENSITIES[1]:
        doubts.append(f"rho = {material.rho:.3g} kg/m^3 (read in t/mm^3: {1e12 * material.rho:.3g} kg/m^3)")
    if not MODULI[0] <= material.E / 10 <= MODULI[1]:
        doubts.append(f"E = {material.E:.3g} Pa (read in MPa: {1e6 * material.E:.3g} Pa)")
    _warn(doubts, "a Material is in SI, steel has E = 2.1e11 and rho = 7850")


def _warn(doubts: list[str], remedy: str) -> None:
    if doubts:
        warnings.warn(f"{'; '.join(doubts)} can hardly be meant: {remedy}", FiniteElementWarning, stacklevel=4)

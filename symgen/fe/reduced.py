"""A flexible body from the reduced matrices of another program: Craig-Bampton, or any that keeps interface nodes.

The reduced coordinates are six motions of each interface node, then modal ones; K and M are all that is given. A rigid
motion moves the interface nodes and no modal coordinate, so that mass, first moment and inertia are R^T M R. The free
modes of K and M move no mass as a whole (Eq. 20: int phi dm = int rho x phi dm = 0). How mass lies inside, which
centrifugal and gyroscopic forces on the modes need, K and M do not say.
"""

from __future__ import annotations

import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
from numpy.typing import ArrayLike

from symgen.fe.inertia import InertiaIntegrals, Marker, dusted, modal_fields
from symgen.fe.structure import AXES, RIGID_MOTIONS, FiniteElementError, FiniteElementWarning, Flags
from symgen.fe.units import LENGTHS, MASSES, STRESSES, check_plausible, in_si, known_units
from symgen.modes.cleaning import Array, fixed, symmetric

RIGID_RESIDUAL = 1e-6  # of the stiffness forces: what rigid motions of the interfaces may leave
MATRIX_ASYMMETRY = 1e-6
GIVEN_TRACE = 1e-3  # of M: how nearly psi_psi must add up to it
UNKNOWN = (
    "reduced matrices do not say how mass lies inside: centrifugal and gyroscopic forces on the modes are left out, "
    "which counts where the body turns nearly as fast as it vibrates; give rho_psi and psi_psi where they are known"
)


@dataclass(frozen=True, eq=False)
class ReducedBody:
    """A body from reduced matrices: markers by name, free modes of K and M.

    eigenvalues (nf,) [rad^2/s^2]; shapes (n, nf): modes in the reduced coordinates, mass-orthonormal; integrals about
    `origin` (3,) [m]; recovery: name -> (place (3,) [m], stress (6, n) [Pa] per reduced coordinate).
    """

    markers: Mapping[str, Marker]
    eigenvalues: Array
    shapes: Array
    integrals: InertiaIntegrals
    origin: Array
    recovery: Mapping[str, tuple[Array, Array]]

    @property
    def nf(self) -> int:
        """Number of modes."""
        return len(self.eigenvalues)

    @property
    def frequencies(self) -> Array:
        """Frequencies of the free modes [Hz], (nf,)."""
        return np.sqrt(self.eigenvalues) / (2.0 * np.pi)

    def fields(self, damping_ratio: float | Sequence[float] = 0.0) -> dict[str, Any]:
        """Plain numbers and lists for a flexible body of a scene, as `FlexibleBody.fields`.

        Parameters
        ----------
        damping_ratio : float or sequence of float, shape (nf,)
            Of all modes or of each [1].

        Returns
        -------
        dict
            Fields of `Scene.flexible`; a gauge for each recovery matrix, whose stress is that of the modes:
            `run.stresses(body, way="modes")`.

        Raises
        ------
        FiniteElementError
            For a ratio that is negative, or a wrong number of ratios.
        """
        found = modal_fields(self.integrals, self.eigenvalues, self.markers, None, damping_ratio, {})
        if self.recovery:
            found["gauges"] = {
                name: {"position": (place - self.origin).tolist(), "shapes": (stress @ self.shapes).tolist()}
                for name, (place, stress) in self.recovery.items()
            }
        return found


def reduced_body(
    K: Any,
    M: Any,
    *,
    interface: Mapping[str, ArrayLike],
    modes: int | None = None,
    recovery: Mapping[str, Any] | None = None,
    origin: str | ArrayLike = (0.0, 0.0, 0.0),
    rho_psi: ArrayLike | None = None,
    psi_psi: ArrayLike | None = None,
    units: str = "SI",
) -> ReducedBody:
    """See `FlexibleBody.from_reduced`."""
    known_units(units)
    n_b = RIGID_MOTIONS * len(interface)
    stiffness, mass = (_dense(item, one, n_b) for item, one in (("K", K), ("M", M)))
    if stiffness.shape != mass.shape:
        raise FiniteElementError("M", f"is {mass.shape}, K is {stiffness.shape}", "give the two of one reduction")
    rotations = _angles(len(mass), len(interface))
    stiffness, mass = in_si(stiffness, rotations, units), in_si(mass, rotations, units)
    places = {name: _point(f"interface['{name}']", at, units) for name, at in interface.items()}
    at = _origin(origin, places, units)
    rigid = _rigid(places, at, len(mass))
    _check_rigid(stiffness, rigid)
    values, shapes = la.eigh(stiffness, mass)
    if len(values) - RIGID_MOTIONS < (modes or 1):
        raise FiniteElementError(
            "modes", f"{modes or 1} asked for, the matrices have {len(values) - RIGID_MOTIONS}", "ask for fewer"
        )
    _check_count(values)
    last = len(values) if modes is None else RIGID_MOTIONS + modes
    kept, shapes = values[RIGID_MOTIONS:last], _signed(shapes[:, RIGID_MOTIONS:last])
    integrals = _integrals(mass, rigid, shapes, *_second_order(rho_psi, psi_psi, mass, rotations, units))
    if len(places) > 1:
        check_plausible(integrals.mass, float(np.ptp(np.array(list(places.values())), axis=0).max()))
    markers = {
        name: Marker(
            fixed(dusted(place - at, 1.0)),
            fixed(shapes[RIGID_MOTIONS * k : RIGID_MOTIONS * k + AXES]),
            fixed(shapes[RIGID_MOTIONS * k + AXES : RIGID_MOTIONS * (k + 1)]),
        )
        for k, (name, place) in enumerate(places.items())
    }
    found = _recovery(recovery or {}, len(mass), places, units)
    return ReducedBody(markers, fixed(kept), fixed(shapes), integrals, fixed(at), found)


def _angles(n: int, interfaces: int) -> Flags:
    """Which of n reduced coordinates are rotations of an interface."""
    rows = np.arange(n)
    return (rows < RIGID_MOTIONS * interfaces) & (rows % RIGID_MOTIONS >= AXES)


def _dense(item: str, matrix: Any, n_b: int) -> Array:
    """A symmetric matrix (n, n) with the interface first."""
    values = np.asarray(matrix.todense() if sp.issparse(matrix) else matrix, dtype=np.float64)
    if values.ndim != 2 or values.shape[0] != values.shape[1] or len(values) < n_b or not n_b:
        problem = f"has shape {values.shape}, the {n_b // RIGID_MOTIONS} interface nodes alone have {n_b} rows"
        remedy = "give rows of six motions for each interface node in their order, then the modal coordinates"
        raise FiniteElementError(item, problem, remedy)
    if not np.isfinite(values).all():
        raise FiniteElementError(item, "an entry is not a finite number", "export the matrix again")
    if np.abs(values - values.T).max() > MATRIX_ASYMMETRY * np.abs(values).max():
        raise FiniteElementError(item, "is not symmetric", "give both triangles: K + K.T - diag(diag(K))")
    return symmetric(values)


def _point(item: str, at: ArrayLike, units: str) -> Array:
    place = np.asarray(at, dtype=float)
    if place.shape != (AXES,) or not np.isfinite(place).all():
        raise FiniteElementError(item, f"{at!r} is not a place", "give x, y, z of the interface node")
    return place * LENGTHS[units]


def _origin(origin: str | ArrayLike, places: Mapping[str, Array], units: str) -> Array:
    if isinstance(origin, str):
        if origin not in places:
            raise FiniteElementError("origin", f"{origin!r} is not an interface", f"choose one of {list(places)}")
        return places[origin]
    return _point("origin", origin, units)


def _rigid(places: Mapping[str, Array], origin: Array, n: int) -> Array:
    """(n, 6): rigid motions of the interface nodes; modal coordinates rest."""
    found = np.zeros((n, RIGID_MOTIONS))
    for k, place in enumerate(places.values()):
        x, y, z = place - origin
        first = RIGID_MOTIONS * k
        found[first : first + RIGID_MOTIONS] = np.eye(RIGID_MOTIONS)
        found[first : first + AXES, AXES:] = [[0.0, z, -y], [-z, 0.0, x], [y, -x, 0.0]]
    return found


def _check_rigid(K: Array, rigid: Array) -> None:
    left = np.abs(K @ rigid).max(axis=0) / np.maximum((np.abs(K) @ np.abs(rigid)).max(axis=0), np.finfo(float).tiny)
    if left.max() > RIGID_RESIDUAL:
        raise FiniteElementError(
            "interface",
            f"rigid motions of the interface nodes leave {left.max():.2g} of the stiffness forces",
            "check places, units, local axes and the order of the rows, and export the matrices without supports",
        )


def _check_count(values: Array) -> None:
    zero = int(np.sum(np.abs(values) < 1e-6 * abs(values[RIGID_MOTIONS])))
    if zero != RIGID_MOTIONS or values[RIGID_MOTIONS] <= 0.0:
        raise FiniteElementError(
            "K", f"has {zero} motions without strain, a free body has six", "export the body without supports"
        )


def _signed(shapes: Array) -> Array:
    largest = np.argmax(np.abs(shapes), axis=0)
    return shapes * np.sign(shapes[largest, range(shapes.shape[1])])


def _integrals(M: Array, rigid: Array, shapes: Array, rho_psi: Array, psi_psi: Array) -> InertiaIntegrals:
    nf = shapes.shape[1]
    tensor = rigid.T @ M @ rigid
    mass = float(np.trace(tensor[:AXES, :AXES])) / AXES
    if mass <= 0.0 or np.linalg.eigvalsh(symmetric(tensor[AXES:, AXES:]))[0] < -1e-9 * np.trace(tensor):
        raise FiniteElementError("M", "gives no positive mass and inertia", "check the export of the mass matrix")
    coupling = tensor[:AXES, AXES:]
    first = np.array(
        [coupling[1, 2] - coupling[2, 1], coupling[2, 0] - coupling[0, 2], coupling[0, 1] - coupling[1, 0]]
    )
    inertia = symmetric(tensor[AXES:, AXES:])
    moments = 0.5 * np.trace(inertia) * np.eye(AXES) - inertia
    rho = np.einsum("aij,ab->bij", rho_psi, shapes)
    psi = np.einsum("abij,ac,bd->cdij", psi_psi, shapes, shapes, optimize=True)
    reach = float(np.sqrt(max(np.trace(moments), 0.0)))
    return InertiaIntegrals(
        mass=mass,
        first_moment=fixed(dusted(first / 2, np.sqrt(mass) * reach)),
        moments=fixed(dusted(moments, reach**2)),
        M_ff=fixed(np.eye(nf)),
        phi_integral=fixed(np.zeros((AXES, nf))),
        rho_phi=fixed(dusted(rho, reach)),
        phi_phi=fixed(dusted(psi, 1.0)),
    )


def _second_order(
    rho_psi: ArrayLike | None, psi_psi: ArrayLike | None, M: Array, rotations: Flags, units: str
) -> tuple[Array, Array]:
    """int rho_i psi_a,j dm (n, 3, 3) and int psi_a,i psi_b,j dm (n, n, 3, 3) in SI; zeros and a warning for none."""
    n = len(M)
    if rho_psi is None or psi_psi is None:
        warnings.warn(UNKNOWN, FiniteElementWarning, stacklevel=5)
        return np.zeros((n, AXES, AXES)), np.zeros((n, n, AXES, AXES))
    rho, psi = np.array(rho_psi, dtype=float), np.array(psi_psi, dtype=float)
    if rho.shape != (n, AXES, AXES) or psi.shape != (n, n, AXES, AXES):
        problem = f"have shapes {rho.shape} and {psi.shape}"
        raise FiniteElementError("rho_psi, psi_psi", problem, f"give ({n}, 3, 3) and ({n}, {n}, 3, 3)")
    scale = np.where(rotations, 1.0, LENGTHS[units])
    rho *= MASSES[units] * LENGTHS[units] ** 2 / scale[:, None, None]
    psi = np.stack([[in_si(psi[:, :, i, j], rotations, units) for j in range(AXES)] for i in range(AXES)])
    psi = np.moveaxis(psi, (0, 1), (2, 3))
    if np.abs(np.einsum("abii->ab", psi) - M).max() > GIVEN_TRACE * np.abs(M).max():
        raise FiniteElementError("psi_psi", "its trace is not M", "give int psi_a,i psi_b,j dm of M's coordinates")
    return rho, psi


def _recovery(
    given: Mapping[str, Any], n: int, places: Mapping[str, Array], units: str
) -> dict[str, tuple[Array, Array]]:
    found = {}
    for name, one in given.items():
        place, rows = (one["position"], one["stress"]) if isinstance(one, Mapping) else (None, one)
        stress = np.asarray(rows, dtype=float)
        if stress.shape != (RIGID_MOTIONS, n) or not np.isfinite(stress).all():
            remedy = f"give xx yy zz yz xz xy for each of the {n} reduced coordinates, 6 x {n}"
            raise FiniteElementError(f"recovery['{name}']", f"has shape {stress.shape}", remedy)
        where = next(iter(places.values())) if place is None else _point(f"recovery['{name}']", place, units)
        scaled = stress * STRESSES[units]
        scaled[:, ~_angles(n, len(places))] /= LENGTHS[units]
        found[name] = (where, scaled)
    return found

"""Shape integrals and markers of the bodies of a spatial scene, as SX over the parameters p (Eqs. 18-20).

The constant axes of a spatial marker in its body: rotation matrix and quaternion as numbers.
"""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np

from runtime.contract.records import Bound
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import add, entries, mul, neg
from symgen.algebra.vectors import Matrix, Vector, scaled, zeros
from symgen.bodies.spatial_beam_body import beam_spatial_point, spatial_beam_integrals, square
from symgen.bodies.spatial_moments import SpatialIntegrals, SpatialPoint
from symgen.scene import (
    BeamBody,
    BeamMarker,
    FlexibleMarker,
    MarkerDirections,
    RigidBody,
    SceneRecord,
    SpatialModalBody,
)

ALONG = 1.0 - 1e-9  # an axis this much along the body's x-axis takes the body's z-axis for its x-axis


def marker_rotation(marker: MarkerDirections) -> np.ndarray:
    """Columns: the marker's x-, y- and z-axis in the body frame (3 x 3, a rotation)."""
    z = _unit(np.array(marker.axis))
    if marker.x_axis is not None:
        x = np.array(marker.x_axis)
    else:
        x = np.array([1.0, 0.0, 0.0]) if abs(z[0]) < ALONG else np.array([0.0, 0.0, 1.0])
    x = _unit(x - (x @ z) * z)
    rotation = np.column_stack([x, np.cross(z, x), z])
    rotation[np.abs(rotation) < 1e-15] = 0.0
    return rotation


def quaternion_of(rotation: np.ndarray) -> np.ndarray:
    """Unit quaternion (scalar first, not negative) of a rotation matrix."""
    trace = float(np.trace(rotation))
    squares = np.array([1 + trace, *(1 - trace + 2 * rotation[k, k] for k in range(3))]) / 4
    largest = int(np.argmax(squares))
    r = rotation
    numerators = np.array(
        [
            [4 * squares[0], r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]],
            [r[2, 1] - r[1, 2], 4 * squares[1], r[0, 1] + r[1, 0], r[0, 2] + r[2, 0]],
            [r[0, 2] - r[2, 0], r[0, 1] + r[1, 0], 4 * squares[2], r[1, 2] + r[2, 1]],
            [r[1, 0] - r[0, 1], r[0, 2] + r[2, 0], r[1, 2] + r[2, 1], 4 * squares[3]],
        ]
    )
    quaternion = numerators[largest] / (4 * np.sqrt(squares[largest]))
    quaternion[np.abs(quaternion) < 1e-15] = 0.0
    return np.asarray(quaternion if quaternion[0] >= 0 else -quaternion)


def _unit(vector: np.ndarray) -> np.ndarray:
    scaled = vector / np.abs(vector).max()
    return np.asarray(scaled / np.linalg.norm(scaled))


def spatial_integrals(scene: SceneRecord, name: str, table: ParameterTable) -> SpatialIntegrals:
    """Integrals of the named body."""
    body = scene.body(name)
    if isinstance(body, RigidBody):
        return _rigid(body, table)
    if isinstance(body, SpatialModalBody):
        return _flexible(body, table)
    assert isinstance(body, BeamBody)
    return spatial_beam_integrals(body, table)


def three(
    values: Sequence[float | str], name: str, unit: str, table: ParameterTable, what: str, bound: Bound = "any"
) -> Vector:
    """Three components of a quantity; a z left out is zero."""
    padded = [*values, 0.0][:3]
    return [
        table.quantity(value, f"{name}.{axis}", unit, what, bound) for value, axis in zip(padded, "xyz", strict=True)
    ]


def _rigid(body: RigidBody, table: ParameterTable) -> SpatialIntegrals:
    """J0 = tr(I)/2 - I of the inertia tensor, plus the centre of mass's share."""
    mass = table.of(body, "mass")
    center = three(body.center_of_mass, f"{body.name}.center_of_mass", "m", table, "centre of mass")
    assert isinstance(body.inertia, tuple)
    about = [
        table.quantity(
            value, f"{body.name}.inertia.{axis}", "kg m^2", f"moment of inertia about {axis}", "not negative"
        )
        for value, axis in zip(body.inertia, ("xx", "yy", "zz"), strict=True)
    ]
    xy, xz, yz = (
        table.quantity(value, f"{body.name}.products.{axis}", "kg m^2", f"entry {axis} of the inertia tensor")
        for value, axis in zip(body.products, ("xy", "xz", "yz"), strict=True)
    )
    half = (about[0] + about[1] + about[2]) / 2
    J0 = [[half - about[0], neg(xy), neg(xz)], [neg(xy), half - about[1], neg(yz)], [neg(xz), neg(yz), half - about[2]]]
    for i in range(3):
        for j in range(3):
            J0[i][j] = add(J0[i][j], mul(mass, mul(center[i], center[j])))
    return SpatialIntegrals(mass, scaled(mass, center), J0, [], [], [], [], [], [], [], [])


def _flexible(body: SpatialModalBody, table: ParameterTable) -> SpatialIntegrals:
    """The body's own numbers; symmetric matrices share their entries."""
    name, nf = body.name, body.nf

    def symmetric(values: Sequence[Sequence[float | str]] | None, label: str, unit: str) -> Matrix:
        rows = square(nf if values is None else len(values))
        for a in range(0 if values is None else len(values)):
            assert values is not None
            for b in range(a, len(values)):
                entry = f"{name}.{label}[{a},{b}]"
                rows[a][b] = rows[b][a] = table.quantity(
                    values[a][b], entry, unit, "modal data", array=f"{name}.{label}"
                )
        return rows

    def block(values: np.ndarray, label: str, unit: str) -> Matrix:
        return entries(table.data(values, f"{name}.{label}", unit, "shape integral"))

    rho_phi = np.array(body.rho_phi or np.zeros((nf, 3, 3)), dtype=float)
    phi_phi = np.array(body.phi_phi, dtype=float)
    bent = body.stiffening
    S_H = [block(np.array(bent.H[i]), f"H[{i}]", "kg/m") for i in range(3)] if bent and bent.H else []
    G_H = (
        [[block(np.array(bent.xH[i][j]), f"xH[{i},{j}]", "kg") for j in range(3)] for i in range(3)]
        if bent and bent.xH
        else []
    )
    phi = body.phi_integral or ((0.0,) * nf,) * 3
    P = (
        [
            [block(phi_phi[a, b] if a <= b else phi_phi[b, a].T, f"phi_phi[{a},{b}]", "kg") for b in range(nf)]
            for a in range(nf)
        ]
        if len(body.phi_phi)
        else []
    )
    return SpatialIntegrals(
        mass=table.of(body, "mass"),
        S1=three(body.first_moment, f"{name}.first_moment", "kg m", table, "int rho0 dm"),
        J0=symmetric(body.inertia_moments, "inertia_moments", "kg m^2"),
        Sb=[
            [
                table.quantity(
                    phi[i][a], f"{name}.phi_integral[{i},{a}]", "kg", "int Phi dm", array=f"{name}.phi_integral"
                )
                for i in range(3)
            ]
            for a in range(nf)
        ],
        N=[block(rho_phi[a], f"rho_phi[{a}]", "kg m") for a in range(nf)],
        P=P,
        M_ff=symmetric(body.M_ff, "M_ff", "kg"),
        K_ff=symmetric(body.K_ff, "K_ff", "N/m"),
        D_ff=symmetric(body.D_ff, "D_ff", "N s/m"),
        S_H=S_H,
        G_H=G_H,
    )


def spatial_point(scene: SceneRecord, reference: str, table: ParameterTable) -> tuple[str, SpatialPoint]:
    """(body name, point) of the marker "body.marker"."""
    body, marker = scene.marker(reference)
    assert isinstance(marker, MarkerDirections)
    axes, quaternion = _turned(marker, reference, table)
    if isinstance(marker, BeamMarker):
        assert isinstance(body, BeamBody)
        point = beam_spatial_point(body, float(marker.at), table)
        return body.name, SpatialPoint(point.position, point.shapes, point.turns, point.H, axes, quaternion)
    position = three(getattr(marker, "position", ()), reference, "m", table, "marker position")
    shapes, turns = ([zeros() for _ in range(body.nf)] for _ in range(2))
    H: list[Matrix] = []
    if isinstance(marker, FlexibleMarker):
        for i, bent in enumerate(marker.foreshortening):
            data = table.data(np.array(bent), f"{reference}.H[{i}]", "1/m", "foreshortening at a marker")
            H.append(entries(data))
        for target, rows, label in ((shapes, marker.shape, "shape"), (turns, marker.rotation, "rotation")):
            for i, row in enumerate(rows):
                for a, value in enumerate(row):
                    entry, array = f"{reference}.{label}[{i},{a}]", f"{reference}.{label}"
                    target[a][i] = table.quantity(value, entry, "1", "modal data at a marker", array=array)
    return body.name, SpatialPoint(position, shapes, turns, H, axes, quaternion)


def _turned(marker: MarkerDirections, reference: str, table: ParameterTable) -> tuple[Matrix, Vector]:
    """The marker's axes and quaternion: zeros and ones stay numbers, the rest are entries of p."""
    rotation = marker_rotation(marker)

    def entry(value: float, label: str) -> ca.SX:
        if value in (0.0, 1.0, -1.0):
            return ca.SX(value)
        return table.data(np.array([[value]]), f"{reference}.{label}", "1", "direction of a marker")

    axes = [[entry(float(rotation[i, j]), f"axes[{i},{j}]") for j in range(3)] for i in range(3)]
    return axes, [entry(float(value), f"quaternion[{k}]") for k, value in enumerate(quaternion_of(rotation))]

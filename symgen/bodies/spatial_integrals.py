"""Shape integrals and markers of the bodies of a spatial scene, as SX over the parameters p (Eqs. 18-20).

Shape integrals and points of a uniform beam in space, as SX over the parameters p (Eqs. 18-20).

A section at x is turned by the torsion angle tau = u q about x: its point (y, z) is at (y - z tau - y tau^2/2,
z + y tau - z tau^2/2). Integrals over the section need int y^2 dA (`second_moment`) and int z^2 dA
(`second_moment_z`) alone, I_p is their sum. Sections stay plane (no warping) and turn about the undeformed line.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from runtime.contract.records import Bound
from symgen.algebra.parameters import ParameterTable
from symgen.algebra.scalar import ZERO, add, entries, mul, neg
from symgen.algebra.vectors import Matrix, Vector, plus, scaled, zeros
from symgen.bodies.beam_sets import beam_integrals_of, set_choices
from symgen.bodies.shape_integrals import modal_impedance
from symgen.bodies.spatial_moments import SpatialIntegrals, SpatialPoint
from symgen.modes.beam import TORSION, BeamIntegrals, BeamPoint
from symgen.scene import BeamBody, BeamMarker, FlexibleMarker, MarkerDirections, RigidBody, SpatialModalBody
from symgen.scene.bodies import quaternion_of

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


@dataclass(frozen=True)
class _Beam:
    """Numbers of the mode sets, and a beam's length [m], mass [kg], int y^2 dm and int z^2 dm [kg m^2] as SX."""

    data: BeamIntegrals
    key: str
    table: ParameterTable
    length: ca.SX
    mass: ca.SX
    yy: ca.SX
    zz: ca.SX
    stiffening: bool

    def numbers(self, values: np.ndarray, label: str) -> Matrix:
        """Entries of p."""
        return entries(self.table.data(values, f"{self.key}.{label}", "1", "shape integral of the mesh"))


def spatial_beam_integrals(body: BeamBody, table: ParameterTable) -> SpatialIntegrals:
    """Of a beam along x: bending in both planes, stretching and torsion.

    The cross-section's rotary inertia counts in J0, so that the beam has one about its own axis.
    """
    data, nf = beam_integrals_of(body), body.nf
    length, density, area = (table.of(body, field) for field in ("length", "density", "area"))
    modulus, section = (
        table.of(body, "youngs_modulus"),
        [table.of(body, "second_moment"), table.of(body, "second_moment_z")],
    )
    zeta = table.of(body, "damping_ratio")
    mass = density * area * length
    yy, zz = density * length * section[0], density * length * section[1]
    beam = _Beam(data, spatial_mesh_key(body), table, length, mass, yy, zz, body.stiffening)
    J0 = [zeros() for _ in range(3)]
    J0[0][0] = mass * length**2 * beam.numbers(np.array([[data.i0]]), "i0")[0][0]
    J0[1][1], J0[2][2] = yy, zz
    stiffness = [modulus * area / length, modulus * section[0] / length**3, modulus * section[1] / length**3]
    if data.twist is not None:
        stiffness.append(table.of(body, "shear_modulus") * table.of(body, "torsion_constant") / length)
    numbers = beam.numbers(np.diag(data.mass), "mass")
    M_ff, K_ff, D_ff = _by(mass, numbers), beam.numbers(np.diag(data.kappa), "kappa"), square(nf)
    for a, axis in enumerate(data.axes):
        if axis == TORSION:
            M_ff[a][a] = mul(yy + zz, numbers[a][a])
        K_ff[a][a] = mul(stiffness[axis], K_ff[a][a])
        D_ff[a][a] = mul(mul(ca.SX(2), zeta), modal_impedance(body, table, K_ff[a][a], M_ff[a][a]))
    N, P = _first_order(beam)
    S_H, G_H = _second_order(beam)
    Sb = _by(mass, beam.numbers(data.phi.T, "phi"))
    return SpatialIntegrals(mass, [mass * length / 2, ZERO, ZERO], J0, Sb, N, P, M_ff, K_ff, D_ff, S_H, G_H)


def _first_order(beam: _Beam) -> tuple[list[Matrix], list[list[Matrix]]]:
    """int rho0 phi_a^T dm and int phi_a phi_b^T dm; of torsion phi = u (0, -z, y)."""
    data, nf = beam.data, len(beam.data.axes)
    moved = beam.mass * beam.length
    N = [[scaled(moved, beam.numbers(data.x_phi[a : a + 1], f"x_phi[{a}]")[0]), zeros(), zeros()] for a in range(nf)]
    P = [[_by(beam.mass, beam.numbers(data.pairs[a, b], f"pairs[{a},{b}]")) for b in range(nf)] for a in range(nf)]
    if data.twist is not None:
        first, pairs = beam.numbers(data.twist.first[None, :], "twist")[0], beam.numbers(data.twist.pairs, "twists")
        for a in range(nf):
            N[a][1][2], N[a][2][1] = mul(beam.yy, first[a]), neg(mul(beam.zz, first[a]))
            for b in range(nf):
                P[a][b][1][1] = add(P[a][b][1][1], mul(beam.zz, pairs[a][b]))
                P[a][b][2][2] = add(P[a][b][2][2], mul(beam.yy, pairs[a][b]))
    return N, P


def _second_order(beam: _Beam) -> tuple[list[Matrix], list[list[Matrix]]]:
    """int H_i dm and int rho0_i H_j dm: of torsion H_y = y u_a u_b and H_z = z u_a u_b, and with stiffening along x."""
    data, nf = beam.data, len(beam.data.axes)
    twist, none = data.twist, square(len(beam.data.axes))
    S_H, G_H = [], [[none] * 3 for _ in range(3)]
    if beam.stiffening:
        H = _by(beam.mass / beam.length, beam.numbers(data.H, "H"))
        xH = _by(beam.mass, beam.numbers(data.xH, "xH"))
        if twist is not None:
            polar = beam.yy + beam.zz
            H = _sum(H, _by(polar / beam.length, beam.numbers(twist.H, "H_twist")))
            xH = _sum(xH, _by(polar, beam.numbers(twist.xH, "xH_twist")))
        S_H, G_H[0][0] = [H, square(nf), square(nf)], xH
    if twist is not None:
        pairs = beam.numbers(twist.pairs, "twists")
        G_H[1][1], G_H[2][2] = _by(beam.yy, pairs), _by(beam.zz, pairs)
    return S_H, G_H if beam.stiffening or twist is not None else []


def _by(factor: ca.SX, matrix: Matrix) -> Matrix:
    return [scaled(factor, row) for row in matrix]


def _sum(first: Matrix, second: Matrix) -> Matrix:
    return [plus(a, b) for a, b in zip(first, second, strict=True)]


def square(n: int) -> Matrix:
    """n x n zeros."""
    return [zeros(n) for _ in range(n)]


def spatial_mesh_key(body: BeamBody) -> str:
    """Name of a beam's mode sets: beams that share them share their data in p."""
    names = ("axial", "y", "z", "torsion")
    return "/".join(["beam", *(f"{names[axis]}-{ends}{n}" for axis, ends, n in set_choices(body))])


def beam_spatial_point(body: BeamBody, at: float, table: ParameterTable) -> SpatialPoint:
    """A point of a beam at the fraction `at` of its length, with the frame's axes."""
    return spatial_point_of(body, beam_integrals_of(body).point(at), at, f"{spatial_mesh_key(body)}@{at!r}", table)


def spatial_point_of(body: BeamBody, data: BeamPoint, at: float, key: str, table: ParameterTable) -> SpatialPoint:
    """A point with these shapes, or a mean of points; key: of its numbers in p."""
    nf, length = body.nf, table.of(body, "length")

    def columns(values: np.ndarray, label: str) -> list[Vector]:
        return entries(table.data(values.T, f"{key}.{label}", "1", "mode shapes at a marker"))

    turns = [scaled(1 / length, turn) for turn in columns(data.turn, "turn")]
    for a, angle in enumerate(columns(data.twist[:, None], "twist")[0]):
        turns[a][0] = add(turns[a][0], angle)
    H: list[Matrix] = []
    if body.stiffening:
        along = entries(table.data(data.H, f"{key}.H", "1", "foreshortening at a marker") / length)
        if body.torsion is not None:
            polar = (table.of(body, "second_moment") + table.of(body, "second_moment_z")) / table.of(body, "area")
            twisted = entries(table.data(data.H_twist, f"{key}.H_twist", "1", "foreshortening at a marker"))
            along = _sum(along, _by(polar / length, twisted))
        H = [along, square(nf), square(nf)]
    fraction = table.data(np.array([[at if at != 1.0 else 0.0]]), f"{key}.at", "1", "marker position")
    position = [length if at == 1.0 else length * fraction, ZERO, ZERO]
    axes = [[ca.SX(float(i == j)) for j in range(3)] for i in range(3)]
    return SpatialPoint(position, columns(data.shape, "shape"), turns, H, axes, [ca.SX(1), ZERO, ZERO, ZERO])


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
    rotation = marker.own_axes()

    def entry(value: float, label: str) -> ca.SX:
        if value in (0.0, 1.0, -1.0):
            return ca.SX(value)
        return table.data(np.array([[value]]), f"{reference}.{label}", "1", "direction of a marker")

    axes = [[entry(float(rotation[i, j]), f"axes[{i},{j}]") for j in range(3)] for i in range(3)]
    return axes, [entry(float(value), f"quaternion[{k}]") for k, value in enumerate(quaternion_of(rotation))]

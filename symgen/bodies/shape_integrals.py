"""Inertia shape integrals of a planar body in its own frame, from each body type of the scene (Eqs. 15-20).

Markers of the scene as point shapes, implicit ones included.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.bodies.beam_sets import beam_integrals_of, set_choices
from symgen.modes.beam import BeamIntegrals, BeamPoint
from symgen.scene import BeamBody, BeamMarker, ModalBody, ModalMarker, RigidBody

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

Table = Sequence[Sequence[float | str]]


@dataclass(frozen=True)
class PointShape:
    """A marker of a body: position (2), shapes Phi (2 x nf), slopes (nf), foreshortening H (nf x nf, 1/m)."""

    position: ca.SX
    angle: ca.SX
    Phi: ca.SX
    slope: ca.SX
    H: ca.SX


@dataclass(frozen=True)
class ShapeIntegrals:
    """Integrals over the mass, about the frame origin, in the body frame; nf modes.

    mass [kg]; S1 = int rho0 (2, kg m); I0 = int |rho0|^2 (kg m^2); Sb = int Phi (2 x nf); i1 = int rho0.Phi (nf);
    B = int rho0 x Phi (nf); M_ff (nf x nf); G = int Phi x Phi (nf x nf, skew); K_ff, D_ff (nf x nf);
    S_H = int H, G_H = int x H (nf x nf): foreshortening, zero when the body has no geometric stiffening.
    """

    mass: ca.SX
    S1: ca.SX
    I0: ca.SX
    Sb: ca.SX
    i1: ca.SX
    B: ca.SX
    M_ff: ca.SX
    G: ca.SX
    K_ff: ca.SX
    D_ff: ca.SX
    S_H: ca.SX
    G_H: ca.SX

    @property
    def nf(self) -> int:
        """Number of modes."""
        return int(self.M_ff.shape[0])


def rigid_integrals(body: RigidBody, table: ParameterTable) -> ShapeIntegrals:
    """Integrals of a rigid body: no modes."""
    mass = table.of(body, "mass")
    assert not isinstance(body.inertia, tuple)
    inertia = table.of(body, "inertia")
    center = _position(body.center_of_mass, f"{body.name}.center_of_mass", table)
    none, square = ca.SX(2, 0), ca.SX(0, 0)
    column = ca.SX(0, 1)
    return ShapeIntegrals(
        mass,
        mass * center,
        inertia + mass * ca.sumsqr(center),
        none,
        column,
        column,
        square,
        square,
        square,
        square,
        square,
        square,
    )


def modal_integrals(body: ModalBody, table: ParameterTable) -> ShapeIntegrals:
    """Integrals of a body given by its modal matrices: taken as they are (case F1 needs that)."""
    name = body.name
    nf = len(body.M_ff)

    def vector(values: Sequence[float | str], label: str, unit: str) -> ca.SX:
        return _matrix([[value] for value in values], f"{name}.{label}", unit, table, (nf, 1))

    def square(values: Table | None, label: str, unit: str) -> ca.SX:
        return _matrix(values, f"{name}.{label}", unit, table, (nf, nf))

    def symmetric(values: Table | None, label: str, unit: str) -> ca.SX:
        upper = (
            None
            if values is None
            else [[0.0 if b < a else value for b, value in enumerate(row)] for a, row in enumerate(values)]
        )
        return ca.triu2symm(ca.triu(square(upper, label, unit)))

    stiffening = body.foreshortening
    return ShapeIntegrals(
        mass=table.of(body, "mass"),
        S1=_position(body.first_moment, f"{name}.first_moment", table, "kg m"),
        I0=table.of(body, "inertia"),
        Sb=_matrix(body.phi_integral, f"{name}.phi_integral", "kg", table, (2, nf)),
        i1=vector(body.rho_dot_phi or [0.0] * nf, "rho_dot_phi", "kg m"),
        B=vector(body.rho_cross_phi or [0.0] * nf, "rho_cross_phi", "kg m"),
        M_ff=symmetric(body.M_ff, "M_ff", "kg"),
        G=square(body.phi_cross_phi, "phi_cross_phi", "kg"),
        K_ff=symmetric(body.K_ff, "K_ff", "N/m"),
        D_ff=symmetric(body.D_ff, "D_ff", "N s/m"),
        S_H=square(stiffening.H if stiffening else None, "H", "kg/m"),
        G_H=square(stiffening.xH if stiffening else None, "xH", "kg"),
    )


@lru_cache(maxsize=4096)
def _mesh_point(data: BeamIntegrals, at: float) -> BeamPoint:
    return data.point(at)


def mesh_key(body: BeamBody) -> str:
    """Name of a beam's mode sets: beams that share them share their data in p."""
    return "/".join(["beam", *(f"{'' if axis else 'axial-'}{ends}{n}" for axis, ends, n in set_choices(body))])


def beam_shape_integrals(body: BeamBody, data: BeamIntegrals, table: ParameterTable) -> ShapeIntegrals:
    """Integrals of a uniform beam: physical scale times the mesh's dimensionless data."""
    key = mesh_key(body)
    length, density, area = (table.of(body, field) for field in ("length", "density", "area"))
    modulus, second = table.of(body, "youngs_modulus"), table.of(body, "second_moment")
    mass = density * area * length

    def column(values: np.ndarray, label: str) -> ca.SX:
        return table.data(np.reshape(values, (-1, 1)), f"{key}.{label}", "1", "shape integral of the mesh")

    def matrix(values: np.ndarray, label: str) -> ca.SX:
        return table.data(values, f"{key}.{label}", "1", "shape integral of the mesh")

    nf, split = len(data.axes), data.axes.count(1)
    K_ff = ca.diagcat(
        modulus * second / length**3 * matrix(np.diag(data.kappa[:split]), "kappa_lateral"),
        modulus * area / length * matrix(np.diag(data.kappa[split:]), "kappa_axial"),
    )
    M_ff = mass * matrix(np.diag(data.mass), "mass")
    across = data.pairs[:, :, 0, 1]
    zeta = table.of(body, "damping_ratio")
    D_ff = ca.SX(nf, nf)
    if not zeta.is_zero():
        for a in range(nf):
            D_ff[a, a] = 2 * zeta * modal_impedance(body, table, K_ff[a, a], M_ff[a, a])
    on = 1.0 if body.stiffening else 0.0
    return ShapeIntegrals(
        mass=mass,
        S1=ca.vertcat(mass * length * matrix(np.array([[0.5]]), "s1"), 0),
        I0=mass * length**2 * matrix(np.array([[data.i0]]), "i0"),
        Sb=mass * ca.horzcat(column(data.phi[0], "phi_x"), column(data.phi[1], "phi_y")).T,
        i1=mass * length * column(data.x_phi[:, 0], "xi_phi_x"),
        B=mass * length * column(data.x_phi[:, 1], "xi_phi_y"),
        M_ff=M_ff,
        G=mass * matrix(across - across.T, "phi_cross_phi"),
        K_ff=K_ff,
        D_ff=D_ff,
        S_H=mass / length * matrix(on * data.H, "H"),
        G_H=mass * matrix(on * data.xH, "xH"),
    )


def modal_impedance(body: BeamBody, table: ParameterTable, k: ca.SX, m: ca.SX) -> ca.SX:
    """D / (2 zeta) of a mode: sqrt(k m) where each mode has the ratio, k / w with the ratio at one frequency w."""
    if body.damping_frequency is None:
        return ca.sqrt(k * m)
    return k / table.of(body, "damping_frequency")


def beam_point(body: BeamBody, data: BeamIntegrals, at: float, table: ParameterTable) -> PointShape:
    """Shapes of a beam at the fraction `at` of its length."""
    return shape_of(body, _mesh_point(data, at), at, f"{mesh_key(body)}@{at!r}", table)


def shape_of(body: BeamBody, point: BeamPoint, at: float, key: str, table: ParameterTable) -> PointShape:
    """Of a point with these shapes at the fraction `at`, or of a mean of points; key: of its numbers in p."""
    length = table.of(body, "length")
    on = 1.0 if body.stiffening else 0.0
    rows = point.shape[:2]
    fraction = table.data(np.array([[at if at != 1.0 else 0.0]]), f"{key}.at", "1", "marker position")
    return PointShape(
        position=ca.vertcat(length if at == 1.0 else length * fraction, 0),
        angle=ca.SX(0),
        Phi=table.data(rows, f"{key}.shape", "1", "mode shapes at a marker"),
        slope=table.data(np.reshape(point.turn[2], (-1, 1)), f"{key}.slope", "1", "mode slopes at a marker") / length,
        H=table.data(on * point.H, f"{key}.H", "1", "foreshortening at a marker") / length,
    )


def beam_section(body: BeamBody, table: ParameterTable) -> tuple[ca.SX, ca.SX, ca.SX]:
    """Area [m^2] and second moments [m^4] of a beam's section for bending in the xy- and the xz-plane."""
    area = table.quantity(body.area, f"{body.name}.area", "m^2", "cross-section area")
    second = [
        table.quantity(value, f"{body.name}.{label}", "m^4", "second moment of area")
        for label, value in (("second_moment", body.second_moment), ("second_moment_z", body.second_moment_z))
    ]
    return area, second[0], second[1]


def body_integrals(scene: SceneRecord, name: str, table: ParameterTable) -> ShapeIntegrals:
    """Shape integrals of the named body of the scene."""
    body = scene.body(name)
    if isinstance(body, RigidBody):
        return rigid_integrals(body, table)
    if isinstance(body, ModalBody):
        return modal_integrals(body, table)
    if isinstance(body, BeamBody):
        return beam_shape_integrals(body, beam_integrals_of(body), table)
    raise TypeError(f"body {name} has no inertia")


def _position(values: Sequence[float | str], name: str, table: ParameterTable, unit: str = "m") -> ca.SX:
    return ca.vertcat(
        *(
            table.quantity(value, f"{name}.{axis}", unit, f"component {axis}")
            for axis, value in zip("xy", values, strict=True)
        )
    )


def _matrix(values: Table | None, name: str, unit: str, table: ParameterTable, shape: tuple[int, int]) -> ca.SX:
    result = ca.SX(*shape)
    if values is None:
        return result
    for row, entries in enumerate(values):
        for column, value in enumerate(entries):
            quantity = table.quantity(value, f"{name}[{row},{column}]", unit, "modal data", array=name)
            if not quantity.is_zero():
                result[row, column] = quantity
    return result


def marker_shape(scene: SceneRecord, reference: str, table: ParameterTable) -> tuple[str, PointShape]:
    """(body name, shape) of the marker "body.marker"."""
    body, marker = scene.marker(reference)
    angle = table.quantity(marker.angle, f"{reference}.angle", "rad", "marker angle")
    if isinstance(marker, BeamMarker):
        assert isinstance(body, BeamBody)
        point = beam_point(body, beam_integrals_of(body), float(marker.at), table)
        return body.name, PointShape(point.position, angle, point.Phi, point.slope, point.H)
    position = ca.vertcat(
        *(
            table.quantity(value, f"{reference}.{axis}", "m", "marker position")
            for axis, value in zip("xy", marker.position, strict=True)
        )
    )
    nf = body.nf
    Phi, slope, H = ca.SX(2, nf), ca.SX(nf, 1), ca.SX(nf, nf)
    if isinstance(marker, ModalMarker):
        _fill(Phi, [marker.shape_x or (), marker.shape_y or ()], f"{reference}.shape", table)
        _fill(slope, [[value] for value in marker.slope or ()], f"{reference}.slope", table)
        _fill(H, marker.foreshortening or (), f"{reference}.foreshortening", table)
    return body.name, PointShape(position, angle, Phi, slope, H)


def _fill(target: ca.SX, rows: Sequence[Sequence[float | str]], name: str, table: ParameterTable) -> None:
    for row, entries in enumerate(rows):
        for column, value in enumerate(entries):
            quantity = table.quantity(value, f"{name}[{row},{column}]", "1", "modal data at a marker", array=name)
            if not quantity.is_zero():
                target[row, column] = quantity

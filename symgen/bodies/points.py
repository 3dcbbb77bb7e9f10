"""Markers of the scene as point shapes, implicit ones included."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from symgen.algebra.parameters import ParameterTable
from symgen.bodies.shape_integrals import PointShape, beam_integrals_of, beam_point
from symgen.scene import BeamBody, BeamMarker, ModalMarker, Scene


def marker_shape(scene: Scene, reference: str, table: ParameterTable) -> tuple[str, PointShape]:
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

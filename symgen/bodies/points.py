"""Markers of the scene as point shapes, implicit ones included."""

from __future__ import annotations

import casadi as ca

from symgen.bodies.shape_integrals import PointShape, beam_integrals_of, beam_point
from symgen.parameters import ParameterTable
from symgen.scene import BeamBody, ModalBody, Scene


def marker_shape(scene: Scene, reference: str, table: ParameterTable) -> tuple[str, PointShape]:
    """(body name, shape) of the marker "body.marker"."""
    body, marker = scene.marker(reference)
    name = f"{reference}"
    angle = table.quantity(getattr(marker, "angle", 0), f"{name}.angle", "rad", "marker angle")
    if isinstance(body, BeamBody):
        point = beam_point(body, beam_integrals_of(body), float(marker.at), table)
        return body.name, PointShape(point.position, angle, point.Phi, point.slope, point.H)
    position = ca.vertcat(*(table.quantity(value, f"{name}.{axis}", "m", "marker position")
                            for axis, value in zip("xy", marker.position, strict=True)))
    nf = len(body.M_ff) if isinstance(body, ModalBody) else 0
    Phi, slope, H = ca.SX(2, nf), ca.SX(nf, 1), ca.SX(nf, nf)
    if isinstance(body, ModalBody):
        _fill(Phi, [marker.shape_x or [], marker.shape_y or []], f"{name}.shape", table)
        _fill(slope, [[value] for value in marker.slope or []], f"{name}.slope", table)
        _fill(H, marker.foreshortening or [], f"{name}.foreshortening", table)
    return body.name, PointShape(position, angle, Phi, slope, H)


def _fill(target: ca.SX, rows: object, name: str, table: ParameterTable) -> None:
    for row, entries in enumerate(rows):  # type: ignore[arg-type, var-annotated]
        for column, value in enumerate(entries):
            quantity = table.quantity(value, f"{name}[{row},{column}]", "1", "modal data at a marker")
            if not quantity.is_zero():
                target[row, column] = quantity

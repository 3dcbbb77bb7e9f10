"""Flexible bodies of a planar scene that are described otherwise: with a lumped mesh, or by what `symgen.fe` gives.

Both become modal bodies, before anything is checked across the scene.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symgen.scene.bodies import BeamBody
from symgen.scene.flexible import FlexibleMarker, Foreshortening, ModalBody, ModalMarker, SpatialModalBody
from symgen.scene.lumped_mesh import lumped_beam, lumped_mesh_faults
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, raise_all
from symgen.schema.fields import Fault

Array = NDArray[np.float64]
OUT_OF_PLANE = 1e-6  # of what it could be: a motion across the plane this small is rounding
REST = 1e-12  # of a mode's mean square motion: markers that move less are at rest


def planar_bodies(bodies: tuple[Any, ...], space: str, scene: Any) -> tuple[Any, ...]:
    """The bodies of a scene, meshed beams and finite-element bodies in the plane as modal ones. Raises SceneError."""
    return tuple(_resolved(body, item_path("bodies", k, body.name), space, scene) for k, body in enumerate(bodies))


def _resolved(body: Any, path: str, space: str, scene: Any) -> Any:
    if isinstance(body, BeamBody) and body.mesh == "lumped":
        raise_all(_at(path, fault) for fault in (*lumped_mesh_faults(body, space), *body.faults(scene)))
        return lumped_beam(body)
    if isinstance(body, SpatialModalBody) and space == "planar" and body.nf:
        part = PlanarPart(body)
        raise_all(_at(path, fault) for fault in (*body.size_faults(), *part.faults()))
        return part.modal()
    return body


def _at(path: str, fault: Fault) -> SceneError:
    return SceneError(f"{path}.{fault.key}" if fault.key else path, fault.problem, fault.remedy)


class PlanarPart:
    """What a spatial flexible body is in the plane z = 0: modes that move across it only are left out."""

    def __init__(self, body: SpatialModalBody) -> None:
        self.body, nf = body, body.nf
        self.rho_phi = np.array(body.rho_phi, dtype=float) if body.rho_phi else np.zeros((nf, 3, 3))
        self.phi_phi = np.array(body.phi_phi, dtype=float) if body.phi_phi else np.zeros((nf, nf, 3, 3))

    @cached_property
    def shares(self) -> Array:
        """(nf,): part of a mode's motion that is in the plane, 0 to 1: of its markers, or of its mass where they rest.

        A mode that bends the body across the plane also tilts its sections, which moves their parts to and fro in it:
        markers lie in the middle and do not see that.
        """
        body = self.body
        places = [abs(x) for one in body.markers.values() for x in one.position if not isinstance(x, str)]
        size = max(places, default=0.0) or 1.0
        inside, across = np.zeros(body.nf), np.zeros(body.nf)
        for one in body.markers.values():
            shape, turn = (_array(rows, (3, body.nf)) for rows in (one.shape, one.rotation))
            inside += np.sum(shape[:2] ** 2, axis=0) + (size * turn[2]) ** 2
            across += shape[2] ** 2 + np.sum((size * turn[:2]) ** 2, axis=0)
        parts = np.einsum("aaii->ai", self.phi_phi)
        rest = inside + across <= REST * np.sum(parts, axis=1) / (1.0 if isinstance(body.mass, str) else body.mass)
        whole = np.where(rest, 1.0, inside + across)
        return np.where(rest, parts[:, 0] + parts[:, 1] > 2 * parts[:, 2], inside / whole)

    @cached_property
    def kept(self) -> list[int]:
        """Modes that move the body in the plane."""
        return [a for a in range(self.body.nf) if self.shares[a] > 0.5]

    def faults(self) -> Iterator[Fault]:
        """What the plane has no place for."""
        body, kept = self.body, self.kept
        spatial = 'take space = "spatial"'
        for key in ("gauges", "surface"):
            if getattr(body, key):
                yield Fault(key, "belongs to a body in space", f"leave {key} out of fields(), or {spatial}")
        if not kept:
            yield Fault("M_ff", "no mode moves in the plane", f"turn the mesh into the xy-plane, or {spatial}")
        for a, share in enumerate(self.shares):
            if OUT_OF_PLANE < share < 1 - OUT_OF_PLANE:
                problem = f"mode {a + 1} moves in the plane and across it"
                yield Fault(
                    "markers", problem, f"give the body sides of different lengths along x, y and z, or {spatial}"
                )
        for name, marker in body.markers.items():
            yield from self._marker_faults(name, marker)
        if body.stiffening is not None and self._second_order_across():
            yield Fault("stiffening", "acts along other axes than x", f"leave stiffening out, or {spatial}")

    def _marker_faults(self, name: str, marker: FlexibleMarker) -> Iterator[Fault]:
        x, y, z = marker.position
        reach = max((abs(one) for one in (x, y) if not isinstance(one, str)), default=0.0)
        if isinstance(z, str) or abs(z) > OUT_OF_PLANE * reach:
            yield Fault(f"markers.{name}.position", f"z = {z} is not in the plane", 'take space = "spatial"')
        if marker.axis != (0.0, 0.0, 1.0) or marker.x_axis is not None:
            yield Fault(f"markers.{name}.axis", "a planar marker is not turned", "leave its axes out")

    def _second_order_across(self) -> bool:
        assert self.body.stiffening is not None
        nf, kept = self.body.nf, self.kept
        H = _array(self.body.stiffening.H, (3, nf, nf))[:, kept][:, :, kept]
        xH = _array(self.body.stiffening.xH, (3, 3, nf, nf))[:, :, kept][:, :, :, kept]
        others = [H[1:], xH[0, 1:], xH[1:]]
        size = max(float(np.abs(H).max(initial=0.0)), float(np.abs(xH).max(initial=0.0)))
        return any(float(np.abs(one).max(initial=0.0)) > OUT_OF_PLANE * size for one in others)

    def modal(self) -> ModalBody:
        """The planar body (Eq. 20); moments of the mass in the plane, int x^2 + y^2 dm."""
        body, kept = self.body, self.kept
        pair = np.ix_(kept, kept)
        moments = np.array(body.inertia_moments, dtype=object)
        if any(isinstance(value, str) for value in (moments[0, 0], moments[1, 1])):
            inertia: Any = f"({moments[0, 0]}) + ({moments[1, 1]})"
        else:
            inertia = float(moments[0, 0]) + float(moments[1, 1])
        rho, phi = self.rho_phi[kept], self.phi_phi[pair]
        second = None
        if body.stiffening is not None:
            H, xH = (
                _array(body.stiffening.H, (3, body.nf, body.nf)),
                _array(body.stiffening.xH, (3, 3, body.nf, body.nf)),
            )
            second = Foreshortening(H=_rows(H[0][pair]), xH=_rows(xH[0, 0][pair]))
        return ModalBody(
            name=body.name,
            mass=body.mass,
            first_moment=body.first_moment[:2],
            inertia=inertia,
            M_ff=_picked(body.M_ff, kept),
            K_ff=_picked(body.K_ff, kept),
            D_ff=None if body.D_ff is None else _picked(body.D_ff, kept),
            phi_integral=tuple(tuple(row[a] for a in kept) for row in body.phi_integral[:2])
            or _rows(np.zeros((2, len(kept)))),
            rho_dot_phi=_row(rho[:, 0, 0] + rho[:, 1, 1]),
            rho_cross_phi=_row(rho[:, 0, 1] - rho[:, 1, 0]),
            phi_cross_phi=_rows(phi[:, :, 0, 1] - phi[:, :, 1, 0]),
            foreshortening=second,
            free=body.free,
            markers={name: self._marker(marker, kept) for name, marker in body.markers.items()},
        )

    def _marker(self, marker: FlexibleMarker, kept: list[int]) -> ModalMarker:
        nf = self.body.nf
        shape, rotation = (_array(rows, (3, nf))[:, kept] for rows in (marker.shape, marker.rotation))
        H = _array(marker.foreshortening, (3, nf, nf))[0][np.ix_(kept, kept)] if marker.foreshortening else None
        return ModalMarker(
            position=marker.position[:2],
            angle=marker.angle,
            shape_x=_row(shape[0]),
            shape_y=_row(shape[1]),
            slope=_row(rotation[2]),
            foreshortening=None if H is None else _rows(H),
        )


def _picked(matrix: Any, kept: list[int]) -> tuple[tuple[Any, ...], ...]:
    """Rows and columns of a matrix of numbers or expressions."""
    return tuple(tuple(matrix[a][b] for b in kept) for a in kept)


def _array(rows: Any, shape: tuple[int, ...]) -> Array:
    return np.array(rows, dtype=float) if len(rows) else np.zeros(shape)


def _row(values: Array) -> tuple[float, ...]:
    return tuple(float(value) for value in values)


def _rows(values: Array) -> tuple[tuple[float, ...], ...]:
    return tuple(_row(row) for row in values)

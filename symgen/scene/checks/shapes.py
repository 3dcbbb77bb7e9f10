"""Sizes: matrices and vectors of modal bodies and structures, modes and marker positions of beams."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from symgen.scene.bodies import BeamBody
from symgen.scene.flexible import SpatialModalBody, Structure
from symgen.scene.modal import ModalBody
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean, show

# n elements leave n + this many modes: the nodes that can move, less the rigid motions.
_MODES_LESS_ELEMENTS = {
    "lateral": {
        "pinned-pinned": -1,
        "clamped-free": 0,
        "free-free": -1,
        "clamped-pinned": -1,
        "clamped-clamped": -1,
    },
    "axial": {"fixed-free": 0, "free-free": 0, "fixed-fixed": -1},
}


def shape_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Everything whose size does not fit its neighbours."""
    for index, body in enumerate(scene.bodies):
        path = item_path("bodies", index, body.name)
        if isinstance(body, BeamBody):
            yield from _beam(body, path)
        elif isinstance(body, ModalBody):
            yield from _modal(body, path)
        elif isinstance(body, SpatialModalBody):
            yield from _flexible(body, path)
    if scene.structure is not None:
        yield from _structure(scene.structure)


def _beam(beam: BeamBody, path: str) -> Iterator[SceneError]:
    if beam.nf == 0:
        yield SceneError(path, "the beam has no modes", "give lateral or axial modes, or describe it as a rigid body")
    if beam.stiffening and beam.lateral is None and beam.lateral_z is None:
        yield SceneError(f"{path}.stiffening", "only bending shortens a beam", "give lateral modes, or remove it")
    if beam.elements is not None and beam.mesh == "exact":
        yield SceneError(f"{path}.elements", "exact shapes have no elements", 'remove it, or take mesh = "lumped"')
    if beam.lumped_elements is not None:
        yield from _lumped(beam, beam.lumped_elements, path)
    for name, marker in beam.markers.items():
        if not 0 <= marker.at <= 1:
            yield SceneError(
                f"{path}.markers.{name}.at",
                f"{marker.at} lies outside the beam",
                "give a fraction from 0 to 1",
            )


def _lumped(beam: BeamBody, elements: int, path: str) -> Iterator[SceneError]:
    """A lumped mesh has the modes of free vibration that its nodes allow, and no end shapes."""
    for kind in ("lateral", "lateral_z", "axial", "torsion"):
        chosen, known = getattr(beam, kind), _MODES_LESS_ELEMENTS["lateral" if "lateral" in kind else "axial"]
        if chosen is None:
            continue
        if chosen.ends not in known:
            yield SceneError(
                f"{path}.{kind}.ends",
                f"a lumped mesh has no shapes for {chosen.ends or 'ends that are left out'}",
                f"name one of {', '.join(known)}, or take exact shapes: leave mesh and elements out",
            )
        elif chosen.modes > elements + known[chosen.ends]:
            yield SceneError(
                f"{path}.{kind}.modes",
                f"{elements} elements with {chosen.ends} ends have {elements + known[chosen.ends]} modes, not "
                f"{chosen.modes}",
                "ask for fewer modes, give more elements, or leave elements out",
            )


def _modal(body: ModalBody, path: str) -> Iterator[SceneError]:
    nf = body.nf
    if nf == 0:
        yield SceneError(f"{path}.M_ff", "the body has no modes", "give M_ff and K_ff, or describe a rigid body")
    for key in ("M_ff", "K_ff", "D_ff", "phi_cross_phi"):
        yield from _size(f"{path}.{key}", getattr(body, key), nf, nf)
    yield from _size(f"{path}.phi_integral", body.phi_integral, 2, nf)
    for key in ("rho_dot_phi", "rho_cross_phi"):
        yield from _size(f"{path}.{key}", getattr(body, key), nf)
    if body.foreshortening is not None:
        yield from _size(f"{path}.foreshortening.H", body.foreshortening.H, nf, nf)
        yield from _size(f"{path}.foreshortening.xH", body.foreshortening.xH, nf, nf)
    for name, marker in body.markers.items():
        for key in ("shape_x", "shape_y", "slope"):
            yield from _size(f"{path}.markers.{name}.{key}", getattr(marker, key), nf)
        yield from _size(f"{path}.markers.{name}.foreshortening", marker.foreshortening, nf, nf)


def _flexible(body: SpatialModalBody, path: str) -> Iterator[SceneError]:
    nf = body.nf
    if nf == 0:
        yield SceneError(f"{path}.M_ff", "the body has no modes", "give M_ff and K_ff, or describe a rigid body")
    for key in ("M_ff", "K_ff", "D_ff"):
        yield from _size(f"{path}.{key}", getattr(body, key), nf, nf)
    yield from _size(f"{path}.inertia_moments", body.inertia_moments, 3, 3)
    yield from _size(f"{path}.phi_integral", body.phi_integral or None, 3, nf)
    yield from _size(f"{path}.rho_phi", body.rho_phi or None, nf)
    yield from _size(f"{path}.phi_phi", body.phi_phi or None, nf, nf)
    if body.stiffening is not None:
        for axis, block in enumerate(body.stiffening.H):
            yield from _size(f"{path}.stiffening.H[{axis}]", block, nf, nf)
        yield from _size(f"{path}.stiffening.H", body.stiffening.H or None, 3)
        yield from _size(f"{path}.stiffening.xH", body.stiffening.xH or None, 3, 3)
        for axis, blocks in enumerate(body.stiffening.xH):
            for other, block in enumerate(blocks):
                yield from _size(f"{path}.stiffening.xH[{axis}][{other}]", block, nf, nf)
    if body.surface is not None and (fault := body.surface.fault(nf)):
        yield SceneError(f"{path}.surface", fault, "take what FlexibleBody.surface gives for these modes")
    for index, strut in enumerate(body.struts):
        for marker_name in strut.markers:
            if marker_name not in body.markers:
                remedy = did_you_mean(marker_name, list(body.markers))
                yield SceneError(f"{path}.struts[{index}].markers", f"there is no marker '{marker_name}'", remedy)
    for name, marker in body.markers.items():
        for key in ("shape", "rotation"):
            yield from _size(f"{path}.markers.{name}.{key}", getattr(marker, key) or None, 3, nf)
        yield from _size(f"{path}.markers.{name}.foreshortening", marker.foreshortening or None, 3)
        for axis, block in enumerate(marker.foreshortening):
            yield from _size(f"{path}.markers.{name}.foreshortening[{axis}]", block, nf, nf)


def _structure(structure: Structure) -> Iterator[SceneError]:
    names = structure.coordinates
    if not names:
        yield SceneError("structure.coordinates", "is empty", "name at least one coordinate")
    for index, name in enumerate(names):
        if name in names[:index]:
            yield SceneError(f"structure.coordinates[{index}]", f"'{name}' is there twice", "rename one of them")
    for key in ("mass", "damping", "stiffness"):
        yield from _size(f"structure.{key}", getattr(structure, key), len(names), len(names))
    yield from _size("structure.force", structure.force, len(names))


def _size(path: str, value: tuple[Any, ...] | None, rows: int, columns: int | None = None) -> Iterator[SceneError]:
    """A vector of ``rows`` entries, or a matrix of ``rows`` x ``columns``; None is no matrix at all."""
    if value is None:
        return
    if len(value) != rows:
        kind = "rows" if columns is not None else "entries"
        yield SceneError(path, f"has {show(len(value))} {kind} instead of {rows}", f"give {rows} {kind}")
        return
    for index, row in enumerate(value if columns is not None else ()):
        if len(row) != columns:
            yield SceneError(
                f"{path}[{index}]",
                f"has {len(row)} entries instead of {columns}",
                f"give {columns} entries a row",
            )

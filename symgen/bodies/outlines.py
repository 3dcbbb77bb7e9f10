"""The points of each body that a picture needs: stations along a beam, and the markers that something refers to."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from symgen.algebra.vectors import Matrix, Vector
from symgen.scene import BeamBody

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord

BEAM_FRACTIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 17))


@dataclass(frozen=True)
class DrawnPoint:
    """A point of a body, in the body's axes, also of a planar one: rho = position + shapes q_f - 1/2 q_f^T H q_f e_x.

    name: the marker's, or "" for a station of a beam. position (3) [m]; axes (3 x 3): columns are the marker's axes;
    shapes[a], turns[a] (3): displacement and rotation by mode a; H (nf x nf) [1/m], or empty without foreshortening.
    """

    body: str
    name: str
    position: Vector
    axes: Matrix
    shapes: list[Vector]
    turns: list[Vector]
    H: Matrix


@dataclass(frozen=True)
class Picture:
    """All drawn points, the pose (origin and rotation matrix) of each body that moves, and the sections of beams.

    sections[beam]: height along y and width along z [m] of a rectangle with the beam's area and second moments;
    rigidities[beam]: E I of bending along y and along z [N m^2].
    """

    points: list[DrawnPoint]
    poses: dict[str, tuple[Vector, Matrix]]
    sections: dict[str, tuple[ca.SX, ca.SX]]
    rigidities: dict[str, list[ca.SX]] = field(default_factory=dict)


def drawn_references(scene: SceneRecord) -> Iterator[str]:
    """References "body.marker": what joints, loads and measures use, and what the scene declares; origins first."""
    used = [reference for joint in scene.joints for reference in joint.markers.values()]
    used += [reference for load in scene.loads for reference in load.markers.values()]
    used += [reference for measure in scene.measures for reference in measure.markers.values()]
    named: dict[str, list[str]] = {}
    for reference in used:
        named.setdefault(reference.partition(".")[0], []).append(reference)
    for body in (scene.ground, *scene.moving_bodies):
        lone = [f"{body.name}.origin"] if len(body.markers) < 2 and not isinstance(body, BeamBody) else []
        declared = [f"{body.name}.{marker}" for marker in body.markers]
        yield from dict.fromkeys([*lone, *declared, *named.get(body.name, [])])


def rectangle(area: ca.SX, second_moment: ca.SX, second_moment_z: ca.SX) -> tuple[ca.SX, ca.SX]:
    """Height along y and width along z of a rectangular section; without a second moment about y, area / height."""
    height = ca.sqrt(12 * second_moment / area)
    return height, area / height if second_moment_z.is_zero() else ca.sqrt(12 * second_moment_z / area)

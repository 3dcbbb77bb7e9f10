"""Which points of each body an animation draws."""

from __future__ import annotations

import numpy as np

from symgen.algebra.parameters import ParameterTable
from symgen.bodies.points import marker_shape
from symgen.bodies.shape_integrals import PointShape, beam_integrals_of, beam_point
from symgen.scene import BeamBody, Scene

BEAM_FRACTIONS = tuple(float(at) for at in np.linspace(0.0, 1.0, 17))


def outline_references(scene: Scene, table: ParameterTable) -> list[tuple[str, list[PointShape]]]:
    """(body, points): a beam at equal fractions, any other body through its markers, the ground one by one."""
    result: list[tuple[str, list[PointShape]]] = []
    for body in scene.bodies:
        if isinstance(body, BeamBody):
            data = beam_integrals_of(body)
            result.append((body.name, [beam_point(body, data, at, table) for at in BEAM_FRACTIONS]))
            continue
        references = drawn_references(scene, body.name, list(body.markers))
        points = [marker_shape(scene, reference, table)[1] for reference in references]
        if body.type == "ground":
            result += [(body.name, [point]) for point in points]
        else:
            result.append((body.name, points))
    return result


def drawn_references(scene: Scene, body: str, declared: list[str]) -> list[str]:
    """The body's markers that joints and loads use or the scene declares; its origin first."""
    used = [ref for joint in scene.joints for ref in (joint.marker_a, joint.marker_b)]
    names = ["origin"] if f"{body}.origin" in used or len(declared) < 2 else []
    return [f"{body}.{name}" for name in dict.fromkeys(names + declared)]

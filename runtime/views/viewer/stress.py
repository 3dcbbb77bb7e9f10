"""Von Mises stresses that colour a page: of finite-element surfaces, and at the rims of the sections of beams."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.records import packed
from runtime.results.section_forces import section_forces
from runtime.views.mechanism.points import Body
from runtime.views.mechanism.scenery import Scenery
from runtime.views.viewer.meshes import SurfaceMesh
from runtime.views.viewer.section_stress import RIM, rim_stress

if TYPE_CHECKING:
    from runtime.results.solution import Solution

MOST_SAMPLES = 300
PER_SIDE = ("t", "q", "q_dot", "q_ddot", "lam")


def stress_records(
    solution: Solution, shown: Scenery, meshes: Mapping[str, SurfaceMesh | None]
) -> tuple[dict[str, dict[str, str]], float]:
    """({body: what the page needs of its stress}, the largest stress [Pa]); bodies of unknown stress are left out.

    `modes` (n, 6, nf): xx yy zz yz xz xy of each vertex per unit of q_f; or `vertices` (frames, vertices), those of
    a beam eight a station.
    """
    found: dict[str, dict[str, str]] = {}
    largest = 0.0
    for body in shown.bodies:
        mesh = meshes[body.name]
        if mesh is None or not body.elastic:
            continue
        if mesh.von_mises is not None:
            values = _between(solution, body, mesh.von_mises, shown.t)
            found[body.name] = {"vertices": packed(values)}
            largest = max(largest, float(values.max(initial=0.0)))
        elif mesh.stresses is not None:
            found[body.name] = {"modes": packed(mesh.stresses)}
            largest = max(largest, _von_mises(mesh.stresses, shown.q_f(body)))
        elif body.section is not None and (rims := _rims(solution, body, shown.t)) is not None:
            found[body.name] = {"vertices": packed(rims)}
            largest = max(largest, float(rims.max()))
    return found, largest


def _von_mises(stresses: np.ndarray, q_f: np.ndarray) -> float:
    """The largest of all vertices and frames."""
    most = 0.0
    for row in q_f:
        xx, yy, zz, yz, xz, xy = (stresses @ row).T
        square = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2)
        most = max(most, float(square.max()))
    return float(np.sqrt(most))


def _between(solution: Solution, body: Body, values: np.ndarray, t: np.ndarray) -> np.ndarray:
    """(frames, n) of values (samples, n). Raises ModelError for other samples than those of the run."""
    if len(values) != len(solution.t):
        raise ModelError(f"von_mises of {body.name} has {len(values)} samples; the run has {len(solution.t)}")
    return np.stack([np.interp(t, solution.t, column) for column in values.T], axis=1)


def _rims(solution: Solution, body: Body, t: np.ndarray) -> np.ndarray | None:
    """(frames, stations, 8), vertices as `beam_mesh` has them; None for a beam whose section forces are not known."""
    assert body.section is not None
    height, width = body.section
    x = body.stations.position[:, 0]
    kept = np.unique(np.linspace(0, len(solution.t) - 1, min(len(solution.t), MOST_SAMPLES)).round().astype(int))
    few: Any = replace(solution, **{key: getattr(solution, key)[kept] for key in PER_SIDE})
    try:
        forces = section_forces(few, body.name, list((x - x[0]) / (x[-1] - x[0])))
    except ModelError:
        return None
    rims = rim_stress(forces, height, width).reshape(len(kept), -1)
    at = np.stack([np.interp(t, few.t, column) for column in rims.T], axis=1)
    return at.reshape(len(t), len(x), len(RIM))

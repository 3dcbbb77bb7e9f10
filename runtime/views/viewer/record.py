"""What the page is given: everything that it draws, as plain lists, texts and base64 of float32."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.records import packed
from runtime.views import curves
from runtime.views.curves import Curves
from runtime.views.mechanism.points import GROUND, Body, Points
from runtime.views.mechanism.scenery import Scenery, scenery
from runtime.views.mechanism.tree import shortest_tree
from runtime.views.projection import is_spatial, up_axis
from runtime.views.style import COLOURS
from runtime.views.viewer.meshes import SurfaceMesh, beam_mesh, solid_mesh, surface_mesh
from runtime.views.viewer.parts import parts
from runtime.views.viewer.stress import stress_records

if TYPE_CHECKING:
    from runtime.results.solution import Solution

MOST_FRAMES, MOST_SAMPLES, MOST_CURVES = 500, 800, 8


def view_record(
    solution: Solution, surfaces: Mapping[str, Mapping[str, Any]], beside: Solution | None = None
) -> dict[str, Any]:
    """Poses and modes at up to 500 times, joints, loads, curves; the bodies and curves of a second run, pale.

    Raises ModelError (nothing to draw, bad surface).
    """
    few = np.linspace(solution.t[0], solution.t[-1], min(MOST_FRAMES, max(200, len(solution.t))))
    shown = scenery(solution, few if len(solution.t) > 1 else solution.t)
    unknown = [name for name in surfaces if name not in [body.name for body in shown.bodies]]
    if unknown:
        raise ModelError(f"there is no body {unknown[0]!r}; there are {', '.join(body.name for body in shown.bodies)}")
    meshes = {body.name: _mesh(body, surfaces) for body in shown.bodies}
    second = _second(beside, shown, surfaces) if beside is not None else None
    points = np.concatenate([_everything(*scene) for scene in ((shown, meshes), second) if scene is not None], axis=1)
    low, high = points.min(axis=(0, 1)), points.max(axis=(0, 1))
    size = max(float((high - low).max()), 1e-9)
    deformation = _deformation(shown, meshes)
    stresses, stress = stress_records(solution, shown, meshes)
    model, status, up = solution.model, solution.status, up_axis(solution.model)
    kept = np.unique(np.linspace(0, len(solution.t) - 1, min(len(solution.t), MOST_SAMPLES)).round().astype(int))
    return {
        "name": model.name,
        "title": model.title or model.name,
        "about": f"{solution.scheme}, dt {solution.dt:g} s · {status if status.whole else f'STOPPED: {status}'} · "
        f"{len(shown.bodies) - 1} bodies, {len(shown.joints)} joints"
        + (f" · pale: {beside.scheme}, dt {beside.dt:g} s" if beside is not None else ""),
        "ok": status.ok,
        "planar": not is_spatial(model),
        "up": up,
        "size": size,
        "centre": ((low + high) / 2).tolist(),
        "box": [low.tolist(), high.tolist()],
        "lowest": float(low[up]),
        "factor": _factor(size, deformation),
        "deformation": max(deformation, 1e-300),
        "stress": stress,
        "colours": COLOURS,
        "t": packed(shown.t, "<f8"),
        "bodies": [
            *({**body, "pale": False, "stress": stresses.get(body["name"])} for body in _bodies(shown, meshes)),
            *(
                {**body, "pale": True}
                for body in (_bodies(*second) if second is not None else [])
                if not body["ground"]
            ),
        ],
        **parts(solution, shown),
        "curve_t": packed(solution.t[kept], "<f8"),
        "curves": [_group(group, solution.t[kept], solution, beside) for group in _curves(solution)],
    }


def _second(
    beside: Solution, shown: Scenery, surfaces: Mapping[str, Mapping[str, Any]]
) -> tuple[Scenery, Mapping[str, SurfaceMesh | None]]:
    """The second run at the first one's times; before its start and after its end it stands still."""
    scene = scenery(beside, np.clip(shown.t, beside.t[0], beside.t[-1]))
    return scene, {body.name: _mesh(body, surfaces) for body in scene.bodies}


def _group(group: Curves, t: np.ndarray, solution: Solution, beside: Solution | None) -> dict[str, Any]:
    """One chart at the times t; `pale`: which curve each curve of the second run belongs to."""
    factor = 180 / np.pi if group.unit == "rad" else 1.0
    curves_of = [np.interp(t, solution.t, values) for values in group.values]
    pale: list[int] = []
    if beside is not None:
        for other in (one for one in _curves(beside) if (one.heading, one.unit) == (group.heading, group.unit)):
            for k, name in enumerate(group.names):
                if name in other.names:
                    values = other.values[other.names.index(name)]
                    curves_of.append(np.interp(t, beside.t, values, left=np.nan, right=np.nan))
                    pale.append(k)
    return {
        "title": group.heading,
        "unit": "deg" if group.unit == "rad" else group.unit,
        "names": [*group.names, *(f"{group.names[k]} (pale run)" for k in pale)],
        "pale": pale,
        "values": [packed(values * factor) for values in curves_of],
    }


def _curves(solution: Solution) -> list[Curves]:
    """What is shown beside the picture, at most eight curves in a group."""
    groups = [
        curves.energy(solution),
        *curves.motion(solution),
        *curves.deformation(solution),
        *curves.forces(solution),
    ]
    return [group.largest(MOST_CURVES) for group in groups]


def _mesh(body: Body, surfaces: Mapping[str, Mapping[str, Any]]) -> SurfaceMesh | None:
    if body.name in surfaces:
        return surface_mesh(body, surfaces[body.name])
    if body.surface is not None:
        return surface_mesh(body, body.surface)
    if body.solid is not None:
        return solid_mesh(body.solid)
    return beam_mesh(body) if body.section else None


def _everything(shown: Scenery, meshes: Mapping[str, SurfaceMesh | None]) -> np.ndarray:
    """(frames, n, 3) every marker, and every vertex undeformed at some frames."""
    still = shown.everything(0.0)
    extra = [still]
    for body in shown.bodies:
        mesh = meshes[body.name]
        if mesh is not None:
            corners = np.array([mesh.points.position.min(axis=0), mesh.points.position.max(axis=0)])
            box = np.array(
                [[corners[i, 0], corners[j, 1], corners[k, 2]] for i in (0, 1) for j in (0, 1) for k in (0, 1)]
            )
            extra.append(shown.placed(body, np.repeat(box[None], len(shown.t), axis=0)))
    return np.concatenate(extra, axis=1)


def _deformation(shown: Scenery, meshes: Mapping[str, SurfaceMesh | None]) -> float:
    """The largest displacement that exaggeration multiplies, at the vertices too [m]."""
    found = shown.deformation()
    for body, follow in zip(shown.bodies, shown.follow, strict=True):
        mesh = meshes[body.name]
        if mesh is None or not body.elastic:
            continue
        few = slice(None, None, max(1, len(mesh.points.position) // 500))
        part = Points(
            [], mesh.points.position[few], mesh.points.axes, mesh.points.shapes[few], mesh.points.turns, mesh.points.H
        )
        q_f = shown.q_f(body)
        own = part.linear(q_f) - follow.displacement(part.position, q_f)
        found = max(found, float(np.linalg.norm(own, axis=2).max()))
    return found


def _factor(size: float, deformation: float) -> float:
    """The exaggeration that shows the largest deformation as 5 % of the size, with two digits; at least 1."""
    if deformation <= 1e-12 * size:
        return 1.0
    factor = max(1.0, 0.05 * size / deformation)
    digits = 10.0 ** (np.floor(np.log10(factor)) - 1)
    return float(max(1.0, np.floor(factor / digits) * digits))


def _bodies(shown: Scenery, meshes: Mapping[str, SurfaceMesh | None]) -> list[dict[str, Any]]:
    found, colour = [], 0
    for body, follow in zip(shown.bodies, shown.follow, strict=True):
        mesh, ground = meshes[body.name], body.name == GROUND
        edges = [] if mesh is not None or ground else shortest_tree(body.markers.position)
        found.append(
            {
                "name": body.name,
                "ground": ground,
                "colour": "#9aa1ad" if ground else COLOURS[colour % len(COLOURS)],
                "nf": len(body.elastic),
                "pose": None if body.pose is None else packed(_seven(shown, body.pose)),
                "q": packed(shown.q_f(body)),
                "follow_rigid": follow.rigid.ravel().tolist(),
                "follow_at": follow.at.ravel().tolist(),
                "follow_rest": follow.rest.ravel().tolist(),
                "points": {"names": body.markers.names, **_set(body.markers)},
                "mesh": None if mesh is None else {**_set(mesh.points), "triangles": packed(mesh.triangles, "<u4")},
                "rods": edges,
                "faces": _faces(edges),
            }
        )
        colour += not ground
    return found


def _set(points: Points) -> dict[str, str]:
    """Positions, modes and foreshortening of points; without any of the last nothing is sent for it."""
    H = points.H if np.any(points.H) else points.H[:0]
    return {"x": packed(points.position), "phi": packed(points.shapes), "H": packed(H)}


def _faces(edges: list[tuple[int, int]]) -> list[tuple[int, int, int]]:
    """Pale triangles between two rods that meet."""
    found = []
    for k in sorted({node for edge in edges for node in edge}):
        others = [b if a == k else a for a, b in edges if k in (a, b)]
        found += [(k, one, two) for one, two in zip(others, others[1:], strict=False)]
    return found


def _seven(shown: Scenery, pose: int) -> np.ndarray:
    """(frames, 7) origin [m] and unit quaternion, scalar first, of one hemisphere over time."""
    A = shown.turn[:, pose]
    trace = np.trace(A, axis1=1, axis2=2)
    squares = np.stack([1 + trace, *(1 - trace + 2 * A[:, k, k] for k in range(3))], axis=1) / 4
    rows = np.empty((len(A), 4, 4))
    d = [A[:, 2, 1] - A[:, 1, 2], A[:, 0, 2] - A[:, 2, 0], A[:, 1, 0] - A[:, 0, 1]]
    e = {(0, 1): A[:, 1, 0] + A[:, 0, 1], (0, 2): A[:, 0, 2] + A[:, 2, 0], (1, 2): A[:, 2, 1] + A[:, 1, 2]}
    for k in range(4):
        rows[:, k, k] = 4 * squares[:, k]
    for k in range(3):
        rows[:, 0, k + 1] = rows[:, k + 1, 0] = d[k]
    for (i, j), value in e.items():
        rows[:, i + 1, j + 1] = rows[:, j + 1, i + 1] = value
    best = np.argmax(squares, axis=1)
    q = rows[np.arange(len(A)), best]
    q /= np.linalg.norm(q, axis=1, keepdims=True)
    flips = np.cumprod(np.where(np.einsum("fi,fi->f", q[1:], q[:-1]) < 0, -1.0, 1.0))
    q[1:] *= flips[:, None]
    return np.concatenate([shown.origin[:, pose], q], axis=1)

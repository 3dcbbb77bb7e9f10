"""What the page is given: everything that it draws, as plain lists, texts and base64 of float32."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.records import packed
from runtime.results.section_forces import SectionForces, section_forces
from runtime.views import curves
from runtime.views.curves import COLOURS, Curves, force_vectors, moment_vectors
from runtime.views.film import is_spatial, shortest_tree, up_axis
from runtime.views.mechanism import GROUND, Body, Points, Scenery, Solid, scenery
from runtime.views.viewer.marks import ends_of, held, time_marks, wheels, with_wheels

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution


# ---- Von Mises stress at the rim of a beam's section, which is drawn as the rectangle of its area and second
# moments.
#
# sigma = N / A - M y / I_z + M_y z / I_y;  tau of shear forces by Zhuravskii, 3 Q / (2 A) at the middles of the
# sides along Q and none at the others, tau of torsion by Saint-Venant's series for a rectangle; sqrt(sigma^2 + 3
# tau^2). Corners carry no shear stress.

# corners and middles of the sides of a section, around it, in halves of its height (along y) and width (along z)
RIM = ((-1, -1), (0, -1), (1, -1), (1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0))
TERMS = np.arange(1, 60, 2)


def rim_stress(forces: SectionForces, height: float, width: float) -> np.ndarray:
    """(N, sections, 8) [Pa] at the places of RIM; height, width [m] of the rectangle. NaN forces count as none."""
    N, Q, Q_z, T, M_y, M = (
        np.nan_to_num(values)
        for values in (forces.normal, forces.shear, forces.shear_z, forces.torsion, forces.moment_y, forces.moment)
    )
    area = height * width
    bending, aside = 6 * M / (width * height**2), 6 * M_y / (height * width**2)
    at_y, at_z = torsion_factors(height, width)
    found = []
    for y, z in RIM:
        # torsion about x: along z where y > 0, against y where z > 0
        along_y = z * z * (1 - y * y) * (1.5 * Q / area - z * T * at_z)
        along_z = y * y * (1 - z * z) * (1.5 * Q_z / area + y * T * at_y)
        found.append(np.sqrt((N / area - y * bending + z * aside) ** 2 + 3 * (along_y**2 + along_z**2)))
    return np.stack(found, axis=2)


def torsion_factors(height: float, width: float) -> tuple[float, float]:
    """Shear stress over torque [1/m^3] in the middle of the sides y = +-height / 2, then of z = +-width / 2."""
    long, short = max(height, width), min(height, width)
    ratio = long / short
    thin = np.tanh(TERMS * np.pi * ratio / 2)
    constant = long * short**3 * (1 / 3 - 64 / (np.pi**5 * ratio) * float(np.sum(thin / TERMS**5)))
    middle = 1 - 8 / np.pi**2 * float(np.sum(1 / (TERMS**2 * np.cosh(np.minimum(TERMS * np.pi * ratio / 2, 300.0)))))
    end = 8 / np.pi**2 * float(np.sum((-1.0) ** ((TERMS - 1) // 2) * thin / TERMS**2))
    of_long, of_short = middle * short / constant, end * short / constant
    return (of_short, of_long) if height >= width else (of_long, of_short)


# ---- Surfaces that move with a body's modes: prisms along beams, and triangles.


@dataclass(frozen=True, eq=False)
class SurfaceMesh:
    """points: the vertices; triangles (m, 3): three vertices each; H of every `per` vertices in turn is the same.

    stresses (n, 6, nf): xx yy zz yz xz xy [Pa] of each vertex per unit of q_f, where they are known.
    """

    points: Points
    triangles: np.ndarray
    per: int = 1
    stresses: np.ndarray | None = None


def beam_mesh(body: Body) -> SurfaceMesh:
    """A prism with the beam's own section: eight vertices a station, turned with it by the deformation."""
    assert body.section is not None
    stations, (height, width) = body.stations, body.section
    n, nf, rim = len(stations.names), stations.shapes.shape[2], len(RIM)
    places = np.array([[0.0, y * height, z * width] for y, z in RIM]) / 2.0
    position = (stations.position[:, None] + places[None]).reshape(-1, 3)
    arm = np.broadcast_to(places[None, :, :, None], (n, rim, 3, nf))
    turned = np.cross(np.broadcast_to(stations.turns[:, None], (n, rim, 3, nf)), arm, axis=2)
    shapes = (stations.shapes[:, None] + turned).reshape(-1, 3, nf)
    sides = [
        (first + i, first + (i + 1) % rim, first + rim + i, first + rim + (i + 1) % rim)
        for first in range(0, rim * (n - 1), rim)
        for i in range(rim)
    ]
    triangles = [part for a, b, c, d in sides for part in ((a, b, d), (a, d, c))]
    last = rim * (n - 1)
    fan = [(i, (i + 1) % rim) for i in range(2, rim)]  # about the middle of a side
    triangles += [part for i, j in fan for part in ((1, j, i), (last + 1, last + i, last + j))]
    return SurfaceMesh(_points(position, shapes, stations.H), np.array(triangles), per=rim)


def solid_mesh(solid: Solid) -> SurfaceMesh:
    """The shapes of a rigid body, which has no modes."""
    return SurfaceMesh(
        _points(solid.vertices, np.zeros((len(solid.vertices), 3, 0)), np.zeros((0, 0, 0))), solid.triangles
    )


def surface_mesh(body: Body) -> SurfaceMesh:
    """The triangles that its scene gives a finite-element body, with the stresses of its modes where they are known."""
    assert body.surface is not None
    position, shapes = (np.asarray(body.surface[key], dtype=float) for key in ("vertices", "shapes"))
    points = _points(position, shapes, np.zeros((0, shapes.shape[2], shapes.shape[2])))
    return SurfaceMesh(points, body.surface["triangles"], stresses=body.surface.get("stresses"))


def _points(position: np.ndarray, shapes: np.ndarray, H: np.ndarray) -> Points:
    n, nf = len(position), shapes.shape[2]
    return Points([""] * n, position, np.zeros((0, 3, 3)), shapes, np.zeros((0, 3, nf)), H)


# ---- Von Mises stresses that colour a page: of finite-element surfaces, and at the rims of the sections of
# beams.

STRESS_SAMPLES = 300
LEVELS = 255  # of a byte
PER_SIDE = ("t", "q", "q_dot", "q_ddot", "lam")


def stress_records(
    solution: Solution, shown: Scenery, meshes: Mapping[str, SurfaceMesh | None]
) -> tuple[dict[str, dict[str, str]], float]:
    """({body: what the page needs of its stress}, the largest stress [Pa]); bodies of unknown stress are left out.

    `modes` (n, 6, nf): xx yy zz yz xz xy of each vertex per unit of q_f; or `vertices` (frames, vertices), those of
    a beam eight a station, as bytes of which `LEVELS` is the largest stress: they are colours.
    """
    found: dict[str, dict[str, str]] = {}
    rims: dict[str, np.ndarray] = {}
    largest = 0.0
    for body in shown.bodies:
        mesh = meshes[body.name]
        if mesh is None or not body.elastic:
            continue
        if mesh.stresses is not None:
            found[body.name] = {"modes": packed(mesh.stresses)}
            largest = max(largest, _von_mises(mesh.stresses, shown.q_f(body)))
        elif body.section is not None and (rim := _rims(solution, body, shown.t)) is not None:
            rims[body.name] = rim
            largest = max(largest, float(rim.max()))
    for name, rim in rims.items():
        found[name] = {"vertices": packed(np.round(rim * (LEVELS / max(largest, 1e-300))), "u1")}
    return found, largest


def _von_mises(stresses: np.ndarray, q_f: np.ndarray) -> float:
    """The largest of all vertices and frames."""
    most = 0.0
    for row in q_f:
        xx, yy, zz, yz, xz, xy = (stresses @ row).T
        square = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * (yz**2 + xz**2 + xy**2)
        most = max(most, float(square.max()))
    return float(np.sqrt(most))


def _rims(solution: Solution, body: Body, t: np.ndarray) -> np.ndarray | None:
    """(frames, stations, 8), vertices as `beam_mesh` has them; None for a beam whose section forces are not known."""
    assert body.section is not None
    height, width = body.section
    x = body.stations.position[:, 0]
    kept = np.unique(np.linspace(0, len(solution.t) - 1, min(len(solution.t), STRESS_SAMPLES)).round().astype(int))
    few: Any = replace(solution, **{key: getattr(solution, key)[kept] for key in PER_SIDE})
    try:
        forces = section_forces(few, body.name, list((x - x[0]) / (x[-1] - x[0])))
    except ModelError:
        return None
    rims = rim_stress(forces, height, width).reshape(len(kept), -1)
    at = np.stack([np.interp(t, few.t, column) for column in rims.T], axis=1)
    return at.reshape(len(t), len(x), len(RIM))


# ---- Joints, springs and loads of the page: their markers, and forces over time.

TURNING = ("torque", "rotational_spring_damper")


def parts(solution: Solution, shown: Scenery) -> dict[str, Any]:
    """Joints and loads at their markers; forces of the joints on their body b."""
    place = {body.name: k for k, body in enumerate(shown.bodies)}

    def at(reference: str) -> list[int]:
        body, k = shown.marker(reference)
        return [place[body.name], k]

    def axes(reference: str) -> list[float]:
        body, k = shown.marker(reference)
        return list(map(float, body.markers.axes[k].ravel()))

    forces = force_vectors(solution.joint_forces) if solution.joint_forces.size else None
    largest = 0.0 if forces is None else float(np.linalg.norm(forces, axis=2).max())
    joints = []
    for joint in shown.joints:
        force = None
        if forces is not None and joint["name"] in solution.model.joints and largest > 0.0:
            column = forces[:, solution.model.joints.index(joint["name"])]
            force = packed(np.stack([np.interp(shown.t, solution.t, part) for part in column.T], axis=1))
        ends, discs = ends_of(solution, shown, joint), wheels(solution, shown, joint)
        joints.append(
            {
                "name": joint["name"],
                "type": joint["type"],
                "a": at(joint["marker_a"]),
                "b": at(joint["marker_b"]),
                "axes": axes(joint["marker_a"]),
                "rail": _rail(shown, joint, ends) if joint["drawing"] == "slide" else None,
                "ends": ends,
                "held": held(solution, joint["name"], shown.t),
                "wheels": discs,
                "axes_b": axes(joint["marker_b"]),
                "force": force,
                "line": joint["drawing"] == "rod" or (joint["drawing"] == "coupling" and not discs),
                "shown": joint["drawing"] != "drive",
            }
        )
    vectors = force_vectors(solution.load_forces) + moment_vectors(solution.load_forces)  # a load has one of them
    kinds = {load["name"]: load["type"] for load in shown.loads}
    loads = []
    for k, record in enumerate(solution.model.description.loads):
        load = next(one for one in shown.loads if one["name"] == record.name)
        first = load.get("marker_a") or load.get("marker")
        if first is None:  # along a beam, at no marker
            continue
        vector = np.stack([np.interp(shown.t, solution.t, part) for part in vectors[:, k].T], axis=1)
        part = {
            "name": load["name"],
            "type": load["type"],
            "a": at(first),
            "axes": axes(first),
            "vector": packed(vector),
        }
        loads.append({**part, "b": at(load["marker_b"])} if load.get("marker_b") else part)
    sizes = np.linalg.norm(vectors, axis=2).max(axis=0, initial=0.0)
    pulling = [size for name, size in zip(kinds, sizes, strict=True) if kinds[name] == "force"]
    turning = [size for name, size in zip(kinds, sizes, strict=True) if kinds[name] in TURNING]
    return {
        "joints": joints,
        "loads": loads,
        "largest_force": largest,
        "largest_load": float(max(pulling, default=0.0)),
        "largest_torque": float(max(turning, default=0.0)),
    }


def _rail(shown: Scenery, joint: Mapping[str, Any], ends: list[float | None]) -> list[float]:
    """Where the rail of a slide begins and ends along marker a's axis [m]: the travel, its stops, a little more."""
    axis = shown.axes(joint["marker_a"])[:, :, 2 if is_spatial(shown.model) else 0]
    way = shown.place(joint["marker_b"], 1.0) - shown.place(joint["marker_a"], 1.0)
    travel = np.append(np.einsum("fi,fi->f", way, axis), [end for end in ends if end is not None])
    more = 0.08 * shown.size()
    return [float(travel.min()) - more, float(travel.max()) + more]


MOST_FRAMES, FEWEST_FRAMES, MOST_SAMPLES, MOST_CURVES = 400, 200, 800, 8


def view_record(
    solution: Solution, beside: Solution | None = None, frames: int = MOST_FRAMES, with_curves: bool = True
) -> dict[str, Any]:
    """Poses and modes at up to `frames` times, joints, loads, curves; the bodies and curves of a second run, pale.

    Raises ModelError if there is nothing to draw.
    """
    few = np.linspace(solution.t[0], solution.t[-1], min(frames, max(FEWEST_FRAMES, len(solution.t))))
    shown = scenery(solution, few if len(solution.t) > 1 else solution.t)
    meshes = {body.name: _mesh(body) for body in shown.bodies}
    second = _second(beside, shown) if beside is not None else None
    points = np.concatenate([_everything(*scene) for scene in ((shown, meshes), second) if scene is not None], axis=1)
    drawn = parts(solution, shown)
    low, high = with_wheels(shown, drawn["joints"], points.min(axis=(0, 1)), points.max(axis=(0, 1)))
    size = max(float((high - low).max()), 1e-9)
    stresses, stress = stress_records(solution, shown, meshes)
    model, status, up = solution.model, solution.status, up_axis(solution.model)
    kept = np.unique(np.linspace(0, len(solution.t) - 1, min(len(solution.t), MOST_SAMPLES)).round().astype(int))
    return {
        "name": model.name,
        "title": model.title or model.name,
        "about": f"{solution.scheme}, {solution.pace} · {status if status.whole else f'STOPPED: {status}'} · "
        f"{len(shown.bodies) - 1} bodies, {len(shown.joints)} joints"
        + (f" · pale: {beside.scheme}, {beside.pace}" if beside is not None else ""),
        "ok": status.ok,
        "planar": not is_spatial(model),
        "up": up,
        "size": size,
        "centre": ((low + high) / 2).tolist(),
        "box": [low.tolist(), high.tolist()],
        "lowest": float(low[up]),
        "factor": shown.automatic(size),
        "deformation": max(shown.deformation(), 1e-300),
        "stress": stress,
        "colours": COLOURS,
        "t": packed(np.round(shown.t, 15), "<f8"),
        "bodies": [
            *({**body, "pale": False, "stress": stresses.get(body["name"])} for body in _bodies(shown, meshes)),
            *(
                {**body, "pale": True}
                for body in (_bodies(*second) if second is not None else [])
                if not body["ground"]
            ),
        ],
        **drawn,
        "marks": time_marks(solution),
        "curve_t": packed(np.round(solution.t[kept], 15), "<f8"),
        "curves": [
            _group(group, solution.t[kept], solution, beside) for group in (_curves(solution) if with_curves else [])
        ],
    }


def _second(beside: Solution, shown: Scenery) -> tuple[Scenery, Mapping[str, SurfaceMesh | None]]:
    """The second run at the first one's times; before its start and after its end it stands still."""
    scene = scenery(beside, np.clip(shown.t, beside.t[0], beside.t[-1]))
    return scene, {body.name: _mesh(body) for body in scene.bodies}


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


def _mesh(body: Body) -> SurfaceMesh | None:
    if body.surface is not None:
        return surface_mesh(body)
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

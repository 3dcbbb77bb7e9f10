"""The mechanism over time as lines in the picture's plane: bodies, undeformed bodies, springs, rods, joints."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal

import numpy as np

from runtime.contract.cards import Html
from runtime.contract.errors import ArgumentError
from runtime.contract.model import EmittedModel
from runtime.views.curves import COLOURS
from runtime.views.mechanism import GROUND, Body, Scenery, scenery, sharp_edges, still

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution


# ---- From which side a spatial mechanism is looked at: the direction against gravity is up, seen a little from
# above.

AZIMUTH, ELEVATION = np.radians(-60.0), np.radians(22.0)


def is_spatial(model: EmittedModel) -> bool:
    """Does the mechanism move in three dimensions?"""
    return bool(model.drawing.get("space") == "spatial")


def projected(model: EmittedModel, points: np.ndarray) -> np.ndarray:
    """Picture coordinates (2, ...) of world points (3, ...)."""
    if not is_spatial(model):
        return points[:2]
    return np.tensordot(view_axes(up_axis(model)), points, axes=1)


def axis_labels(model: EmittedModel) -> tuple[str, str]:
    """Labels of the picture's axes."""
    return ("across [m]", f"{'xyz'[up_axis(model)]}, seen from above [m]") if is_spatial(model) else ("x [m]", "y [m]")


def up_axis(model: EmittedModel) -> int:
    """The world axis that gravity is along; without gravity z, y in a planar mechanism."""
    if not is_spatial(model):
        return 1
    weights = np.abs(model.description.gravity)
    return int(np.argmax(weights)) if weights.any() else 2


def view_axes(up: int) -> np.ndarray:
    """Rows: the picture's horizontal and vertical direction in world axes (2 x 3)."""
    first, second = (up + 1) % 3, (up + 2) % 3
    axes = np.zeros((2, 3))
    axes[0, first], axes[0, second] = -np.sin(AZIMUTH), np.cos(AZIMUTH)
    axes[1, first], axes[1, second] = -np.sin(ELEVATION) * np.cos(AZIMUTH), -np.sin(ELEVATION) * np.sin(AZIMUTH)
    axes[1, up] = np.cos(ELEVATION)
    return axes


# ---- Which markers of a body are joined by rods: the shortest tree through them, whatever their order in the
# scene.


def shortest_tree(points: np.ndarray) -> list[tuple[int, int]]:
    """Edges (from, to) of the shortest tree through points (n, 3), those at the same place left out (Prim)."""
    size = float(np.ptp(points, axis=0).max()) if len(points) else 0.0
    distance = np.linalg.norm(points[:, None] - points[None], axis=2)
    inside, edges = [0], []
    while len(inside) < len(points):
        outside = [k for k in range(len(points)) if k not in inside]
        near = distance[np.ix_(inside, outside)]
        a, b = np.unravel_index(int(near.argmin()), near.shape)
        if near[a, b] > 1e-9 * size:
            edges.append((inside[a], outside[b]))
        inside.append(outside[b])
    return edges


Kind = Literal["beam", "body", "outline", "ghost", "spring", "rod", "joint", "slide", "ground"]
COILS = 6
MAX_FRAMES = 2000
KINDS: dict[str, Kind] = {
    "pivot": "joint",
    "slide": "slide",
    "rod": "rod",
    "coupling": "rod",
}  # welds and drives are not drawn


@dataclass(frozen=True, eq=False)
class Line:
    """xy (frames, 2, n) [m] of one thing; NaN where the pen is lifted. colour: number of its body, -1 for none."""

    kind: Kind
    name: str
    colour: int
    xy: np.ndarray


@dataclass(frozen=True, eq=False)
class Film:
    """Lines at the times t (frames,) [s], the exaggeration used, labels of the picture's axes.

    A spatial mechanism is shown from a fixed direction, see `projected`; axes are the world's in a planar one.
    """

    t: np.ndarray
    lines: list[Line]
    exaggeration: float
    axes: tuple[str, str]

    def line(self, name: str, kind: Kind) -> Line:
        """The line of that name and kind. Raises KeyError."""
        found = [line for line in self.lines if (line.name, line.kind) == (name, kind)]
        if not found:
            raise KeyError(f"the film shows no {kind} {name!r}")
        return found[0]

    @property
    def limits(self) -> tuple[np.ndarray, np.ndarray]:
        """Lower and upper corner, each (2,), of everything drawn, ghosts included [m]."""
        points = np.concatenate([line.xy for line in self.lines], axis=2)
        return np.nanmin(points, axis=(0, 2)), np.nanmax(points, axis=(0, 2))


def film(solution: Solution, frames: int = 60, exaggeration: float | None = None) -> Film:
    """Where everything drawn is at `frames` equally spaced times.

    exaggeration multiplies the deformation; None chooses it so that the largest one drawn becomes 5 % of the
    mechanism's size (at least 1). Raises ModelError if the model has nothing to draw.
    """
    if not 1 <= frames <= MAX_FRAMES:
        raise ArgumentError(f"frames must be 1 to {MAX_FRAMES}, not {frames}")
    return film_at(solution, np.linspace(solution.t[0], solution.t[-1], frames), exaggeration)


def film_at(solution: Solution, times: np.ndarray, exaggeration: float | None = None) -> Film:
    """The same at times (N,) [s]."""
    if exaggeration is not None and not np.isfinite(exaggeration):
        raise ArgumentError(f"exaggeration must be finite, not {exaggeration}")
    scene = scenery(solution, times)
    factor = scene.automatic(scene.size()) if exaggeration is None else float(exaggeration)
    return Film(scene.t, lines_of(scene, factor), factor, axis_labels(solution.model))


def lines_of(scene: Scenery, factor: float) -> list[Line]:
    """All lines of a mechanism, its deformation multiplied by `factor`."""
    return [*_bodies(scene, factor), *_between(scene, factor)]


def _bodies(scene: Scenery, factor: float) -> list[Line]:
    found, colour = [], 0
    for body in scene.bodies:
        if body.name == GROUND:
            continue
        outlined = body.solid is not None or body.surface is not None
        kind: Kind = "beam" if body.section else "outline" if outlined else "body"
        if body.elastic and factor != 0.0:
            found.append(Line("ghost", body.name, colour, _body(scene, body, 0.0)))
        found.append(Line(kind, body.name, colour, _body(scene, body, factor)))
        colour += 1
    used = {part.get(key) for part in (*scene.joints, *scene.loads) for key in ("marker_a", "marker_b")}
    for body in scene.bodies:
        fixed = [k for k, name in enumerate(body.markers.names) if f"{body.name}.{name}" in used]
        if body.name == GROUND and body.solid is not None:
            found.append(Line("outline", GROUND, -1, _outline(scene, body)))
        if body.name == GROUND and fixed:
            found.append(Line("ground", GROUND, -1, _flat(scene, scene.world(body, body.markers, 1.0)[:, fixed])))
    return found


def _body(scene: Scenery, body: Body, factor: float) -> np.ndarray:
    """A beam's stations, or the rods between a body's markers with the pen lifted between them."""
    if body.section:
        return _flat(scene, scene.world(body, body.stations, factor))
    if body.surface is not None:
        return _surface(scene, body, factor)
    if body.solid is not None:
        return _outline(scene, body)
    points = scene.world(body, body.markers, factor)
    edges = shortest_tree(body.markers.position)
    if not edges:
        return _flat(scene, points[:, :1])
    lifted = np.full_like(points[:, :1], np.nan)
    strokes = [part for a, b in edges for part in (points[:, a : a + 1], points[:, b : b + 1], lifted)]
    return _flat(scene, np.concatenate(strokes[:-1], axis=1))


def _outline(scene: Scenery, body: Body) -> np.ndarray:
    """The edges of a body's shapes, with the pen lifted after each."""
    assert body.solid is not None
    edges = body.solid.edges()
    lifted = np.full((len(edges), 1, 3), np.nan)
    strokes = np.concatenate([edges, lifted], axis=1).reshape(-1, 3)
    return _flat(scene, scene.placed(body, np.repeat(strokes[None], len(scene.t), axis=0)))


def _surface(scene: Scenery, body: Body, factor: float) -> np.ndarray:
    """The sharp edges of a finite-element surface, deformed, with the pen lifted after each."""
    assert body.surface is not None
    edges = sharp_edges(body.surface["vertices"], body.surface["triangles"])
    ends, at = np.unique(edges, return_inverse=True)
    drawn = _flat(scene, scene.world(body, body.skin(ends), factor))[:, :, at.reshape(-1, 2)]  # (frames, 2, edges, 2)
    lifted = np.full((*drawn.shape[:3], 1), np.nan)
    return np.concatenate([drawn, lifted], axis=3).reshape(len(scene.t), 2, -1)


def _between(scene: Scenery, factor: float) -> list[Line]:
    found = []
    for joint in scene.joints:
        kind = KINDS.get(joint["drawing"])
        if kind is None:
            continue
        a, b = (_flat(scene, scene.place(joint[key], factor)[:, None]) for key in ("marker_a", "marker_b"))
        found.append(Line(kind, joint["name"], -1, np.concatenate([a, b], axis=2) if kind == "rod" else b))
    for load in scene.loads:
        if load["type"] == "spring_damper":
            a, b = (_flat(scene, scene.place(load[key], factor)[:, None]) for key in ("marker_a", "marker_b"))
            found.append(Line("spring", load["name"], -1, _coil(a, b, 0.02 * scene.size())))
    return found


def _coil(a: np.ndarray, b: np.ndarray, width: float) -> np.ndarray:
    """(frames, 2, n) a zigzag between the points a and b (frames, 2, 1)."""
    along = b - a
    length = np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-12)
    across = np.concatenate([-along[:, 1:], along[:, :1]], axis=1) / length
    share = np.concatenate([[0.0, 0.2], np.linspace(0.2, 0.8, 2 * COILS + 1), [0.8, 1.0]])
    side = np.concatenate([[0.0, 0.0], [0.0, *(1.0 if k % 2 else -1.0 for k in range(2 * COILS - 1)), 0.0], [0.0, 0.0]])
    return np.asarray(a + along * share + across * (width * side))


def _flat(scene: Scenery, points: np.ndarray) -> np.ndarray:
    """(frames, 2, n) picture coordinates of world points (frames, n, 3)."""
    return projected(scene.model, np.moveaxis(points, 2, 0)).transpose(1, 0, 2)


# ---- A model as it stands at the start, as a small SVG: the lines of a film at one instant.

WIDTH, HIGHEST, MARGIN = 300.0, 200.0, 14.0  # pixels
WIDTHS = {"beam": 3.0, "body": 4.0, "outline": 1.2, "spring": 1.2, "rod": 1.5}


def model_sketch(model: EmittedModel) -> Html:
    """SVG of the initial position with the default parameters; "" if there is nothing to draw."""
    if not model.has("geometry"):
        return Html()
    lines = lines_of(still(model), 1.0)
    points = np.concatenate([line.xy[0] for line in lines], axis=1)
    low, high = np.nanmin(points, axis=1), np.nanmax(points, axis=1)
    size = np.maximum(high - low, 1e-3 * max(float((high - low).max()), 1e-9))
    scale = min((WIDTH - 2 * MARGIN) / size[0], (HIGHEST - 2 * MARGIN) / size[1])
    height = 2 * MARGIN + scale * size[1]
    drawn = "".join(
        _drawn(line, np.array([MARGIN, height - MARGIN])[:, None] + scale * (line.xy[0] - low[:, None]) * [[1], [-1]])
        for line in sorted(lines, key=lambda line: line.kind in ("joint", "slide", "ground"))
        if line.kind != "ghost"
    )
    return Html(f'<svg width="{WIDTH:.0f}" height="{height:.0f}" style="display:block;margin:4px 0">{drawn}</svg>')


def _drawn(line: Line, xy: np.ndarray) -> str:
    """One line in pixels (2, n), NaN where the pen is lifted; joints and the ground as marks."""
    if line.kind in ("joint", "slide", "ground") or xy.shape[1] == 1:
        kind = "slide" if line.kind == "body" else line.kind
        return "".join(_mark(kind, x, y) for x, y in xy.T)
    path, command = [], "M"
    for x, y in xy.T:
        if not np.isnan(x):
            path.append(f"{command}{x:.1f} {y:.1f}")
        command = "M" if np.isnan(x) else "L"
    colour = COLOURS[line.colour % len(COLOURS)] if line.colour >= 0 else "#555"
    style = f'fill="none" stroke="{colour}" stroke-width="{WIDTHS[line.kind]}" stroke-linecap="round"'
    return f'<path d="{"".join(path)}" {style}/>'


def _mark(kind: str, x: float, y: float) -> str:
    if kind == "ground":
        return f'<path d="M{x:.1f} {y - 7:.1f}l7 12h-14z" fill="#ccc" stroke="#555"/>'
    if kind == "slide":
        return f'<rect x="{x - 4:.1f}" y="{y - 4:.1f}" width="8" height="8" fill="#fff" stroke="#333"/>'
    return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.2" fill="#fff" stroke="#333"/>'

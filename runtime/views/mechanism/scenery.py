"""All that moves in a picture: bodies with poses over time, joints and loads at their points."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.model import Model
from runtime.views.mechanism.exaggeration import Following, exaggerated, following
from runtime.views.mechanism.points import Body, Points, bodies

if TYPE_CHECKING:
    from runtime.results.solution import Solution

VISIBLE = 0.05  # the largest deformation becomes this part of the mechanism's size


@dataclass(frozen=True, eq=False)
class Scenery:
    """A mechanism at the times t (frames,) [s].

    q (frames, n); origin (frames, bodies, 3) [m] and turn (frames, bodies, 3, 3): the poses in the order of
    model.drawing["poses"]; follow: of each body, what its joints show of its deformation.
    """

    model: Model
    t: np.ndarray
    q: np.ndarray
    origin: np.ndarray
    turn: np.ndarray
    bodies: list[Body]
    follow: list[Following]

    @property
    def joints(self) -> Sequence[Mapping[str, Any]]:
        """Name, type, marker_a and marker_b of each joint."""
        return list(self.model.drawing["joints"])

    @property
    def loads(self) -> Sequence[Mapping[str, Any]]:
        """Name, type and markers of each load."""
        return list(self.model.drawing["loads"])

    def q_f(self, body: Body) -> np.ndarray:
        """(frames, nf) elastic coordinates of a body."""
        return self.q[:, body.elastic]

    def world(self, body: Body, points: Points, factor: float) -> np.ndarray:
        """(frames, n, 3) points of a body in the world, its deformation multiplied by `factor` [m]."""
        return self.placed(body, exaggerated(points, self.follow[self.bodies.index(body)], self.q_f(body), factor))

    def placed(self, body: Body, local: np.ndarray) -> np.ndarray:
        """(frames, n, 3) places in the world of points (frames, n, 3) in a body's axes [m]."""
        if body.pose is None:
            return local
        return np.asarray(
            self.origin[:, body.pose, None, :] + np.einsum("fij,fnj->fni", self.turn[:, body.pose], local)
        )

    def marker(self, reference: str) -> tuple[Body, int]:
        """The body and the place among its markers of "body.marker"."""
        return next(
            (body, place)
            for body in self.bodies
            for place, name in enumerate(body.markers.names)
            if f"{body.name}.{name}" == reference
        )

    def place(self, reference: str, factor: float) -> np.ndarray:
        """(frames, 3) world position of "body.marker" [m]."""
        body, k = self.marker(reference)
        return self.world(body, body.markers, factor)[:, k]

    def axes(self, reference: str) -> np.ndarray:
        """(frames, 3, 3) axes of "body.marker" in the world, without its turning by deformation."""
        body, k = self.marker(reference)
        local = body.markers.axes[k]
        if body.pose is None:
            return np.repeat(local[None], len(self.t), axis=0)
        return np.asarray(self.turn[:, body.pose] @ local)

    def everything(self, factor: float) -> np.ndarray:
        """(frames, n, 3) all stations and markers [m]."""
        return np.concatenate(
            [
                self.world(body, points, factor)
                for body in self.bodies
                for points in (body.stations, body.markers, body.skin())
            ],
            axis=1,
        )

    def size(self) -> float:
        """The longest side of the box around all that is seen [m], at least 1e-9."""
        points = self.everything(0.0)
        return max(float(np.ptp(points, axis=(0, 1)).max(initial=0.0)), 1e-9)

    def deformation(self) -> float:
        """The largest displacement that exaggeration multiplies [m]."""
        found = 0.0
        for body, follow in zip(self.bodies, self.follow, strict=True):
            some = max(1, 0 if body.surface is None else len(body.surface["vertices"]) // 500)
            for points in (body.stations, body.markers, body.skin(slice(None, None, some))):
                if body.elastic and len(points.names):
                    left = points.linear(self.q_f(body)) - follow.displacement(points.position, self.q_f(body))
                    found = max(found, float(np.linalg.norm(left, axis=2).max()))
        return found

    def automatic(self) -> float:
        """The factor, with two digits, that makes the largest deformation 5 % of the mechanism's size; at least 1."""
        size, deformation = self.size(), self.deformation()
        if deformation <= 1e-12 * size:
            return 1.0
        factor = max(1.0, VISIBLE * size / deformation)
        digits = 10.0 ** (np.floor(np.log10(factor)) - 1)
        return float(max(1.0, np.floor(factor / digits) * digits))


def scenery(solution: Solution, t: np.ndarray) -> Scenery:
    """The mechanism of a solution at the times t (N,) [s]. Raises ModelError if the model has nothing to draw."""
    return _at(solution.model, solution.parameters, t, np.asarray(solution.interpolate(t, "q")))


def still(model: Model) -> Scenery:
    """The mechanism as the scene starts it, with its own parameters. Raises ModelError if there is nothing to draw."""
    return _at(model, model.parameter_vector(), np.zeros(1), model.initial_q[None, :])


def _at(model: Model, p: np.ndarray, t: np.ndarray, q: np.ndarray) -> Scenery:
    """With parameters p (n_p,) at coordinates q (frames, n)."""
    found = bodies(model, p)
    origin, turn = _poses(model, q)
    at_joints = {joint[key] for joint in model.drawing["joints"] for key in ("marker_a", "marker_b")}
    follow = [
        following(body.markers, [k for k, name in enumerate(body.markers.names) if f"{body.name}.{name}" in at_joints])
        for body in found
    ]
    return Scenery(model, t, q, origin, turn, found, follow)


def _poses(model: Model, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(frames, bodies, 3) and (frames, bodies, 3, 3): one call of the function for all frames, side by side."""
    count, kernel = len(model.drawing["poses"]), model.kernel("poses")
    flat = np.asarray(kernel(q=q.T)["poses"]).reshape(12, len(q), count)
    values = np.moveaxis(flat, 0, -1)  # (frames, bodies, 12)
    return values[..., :3], np.swapaxes(values[..., 3:].reshape(len(q), count, 3, 3), 2, 3)

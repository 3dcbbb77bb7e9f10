"""A link as a beam or a finite-element body: the body of a scene file, whose frame stands somewhere in the link's."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from symgen.scene import toml_io
from symgen.schema.errors import SceneError
from symgen.urdf.robot import Pose, pose

NEAR = 1e-6  # m: how far a joint of the URDF may be from the point of the body that takes it


@dataclass
class FlexibleLink:
    """entry: the body as a scene holds it, to which markers are added; at: the pose of its frame in the link's."""

    link: str
    entry: dict[str, Any]
    at: Pose

    def marker(self, name: str, place: Pose) -> None:
        """Add a marker at a pose in the link's frame. Raises SceneError where the body has no point there."""
        own = self.at.inverse().then(place)
        markers = self.entry.setdefault("markers", {})
        turned = {"axis": own.R[:, 2].tolist(), "x_axis": own.R[:, 0].tolist()}
        markers[name] = {**(self._on_beam if self.entry["type"] == "beam" else self._on_mesh)(name, own.p), **turned}

    def _on_beam(self, name: str, p: np.ndarray) -> dict[str, Any]:
        given = self.entry.get("length")
        length = float(given) if isinstance(given, int | float) else 0.0
        if not length > 0:
            self._refuse("its length is no positive number", "give it in m")
        if abs(p[1]) > NEAR or abs(p[2]) > NEAR or not -NEAR <= p[0] <= length + NEAR:
            self._refuse(
                f"joint '{name}' is at {_shown(p)} of it, off its line of {length:g} m",
                "set xyz and rpy of [frame], or the length",
            )
        return {"at": min(max(float(p[0]) / length, 0.0), 1.0)}

    def _on_mesh(self, name: str, p: np.ndarray) -> dict[str, Any]:
        markers: dict[str, Any] = {**self.entry["markers"], "origin": {}}  # which the body has by itself
        known = {key: place for key, one in markers.items() if (place := _place(one)) is not None}
        away = {key: float(np.linalg.norm(place - p)) for key, place in known.items()}
        near = min(away, key=lambda key: away[key])
        if not away[near] <= NEAR:
            nearest = f"the nearest marker, '{near}', is {away[near]:.3g} m away"
            self._refuse(f"it has no marker at {_shown(p)}, where joint '{name}' is; {nearest}", "attach a point there")
        return dict(markers[near])

    def _refuse(self, problem: str, remedy: str) -> None:
        raise SceneError(f"flexible link '{self.link}'", problem, remedy)


def _place(marker: Any) -> np.ndarray | None:
    """Of a marker whose position is numbers; what else is wrong with others the scene will say."""
    try:
        return np.array(marker.get("position", (0, 0, 0)), dtype=float).reshape(3)
    except (ValueError, TypeError, AttributeError):
        return None


def _shown(p: np.ndarray) -> str:
    return f"({', '.join(f'{value:.6g}' for value in p)})"


def flexible_link(link: str, name: str, path: str | Path) -> FlexibleLink:
    """From a file with one beam or flexible body in `[[bodies]]` and, if need be, `[frame]` with xyz [m] and rpy [rad].

    name: of the body in the scene. Raises SceneError.
    """
    data = toml_io.read(path)
    bodies, frame = data.get("bodies"), data.get("frame", {})
    body = bodies[0] if isinstance(bodies, list) and len(bodies) == 1 else None
    if not isinstance(body, dict) or body.get("type") not in ("beam", "flexible"):
        raise SceneError(f"file '{path}'", "does not hold one beam or flexible body", "give one entry [[bodies]]")
    try:
        xyz, rpy = (np.array(frame.get(key, (0.0, 0.0, 0.0)), dtype=float).reshape(3) for key in ("xyz", "rpy"))
    except (ValueError, TypeError, AttributeError):
        raise SceneError(f"file '{path}'", "[frame] has no three numbers", "give xyz = [...] and rpy = [...]") from None
    if not np.all(np.isfinite([xyz, rpy])) or not isinstance(body.get("markers", {}), dict):
        raise SceneError(f"file '{path}'", "has numbers that are not finite, or markers that are no table", "mend it")
    return FlexibleLink(link, {**body, "name": name, "markers": dict(body.get("markers", {}))}, pose(xyz, rpy))

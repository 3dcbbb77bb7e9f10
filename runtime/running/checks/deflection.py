"""Deflections of flexible bodies stay small: their modes are linear, and stiffening is of second order."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import whole
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.running.checks.check import Check, Subject

MOST_TURN = 1.0  # rad, of a drawn point of a body against the body's axes
MOST_DEFLECTION = 0.4  # of the body's length; second-order stiffening is off by a tenth before half of that


class Deflection(Check):
    """`deflection_too_large`: the modal model of a body is left behind.

    p (n_p,): parameters. A body's drawn points move by shapes q and turn by turns q, q its modal coordinates.
    """

    def __init__(self, subject: Subject, p: np.ndarray) -> None:
        super().__init__(subject)
        self._bodies = flexible_bodies(subject.model, p)

    def after(self, z: np.ndarray) -> Status | None:
        """Compare deflections with the body's length, and turns with a radian."""
        if not self._bodies:
            return None
        seen = self.subject.scheme.observer(z=z, c=self.subject.c)
        q = whole(self.subject.model, *(np.asarray(seen[name]).ravel() for name in ("q_i", "q_d")))
        for name, columns, length, shapes, turns in self._bodies:
            moved = float(np.linalg.norm(shapes @ q[columns], axis=1).max()) / length
            turned = float(np.linalg.norm(turns @ q[columns], axis=1).max())
            if moved > MOST_DEFLECTION or turned > MOST_TURN:
                return self.subject.stop(
                    "deflection_too_large",
                    f"{name} is bent by {moved:.2g} of its length and {turned:.2g} rad, beyond its linear modes",
                    "Divide the body, or make it stiffer. A strut beyond its buckling load and a spinning beam without "
                    "geometric stiffening have no small answer.",
                )
        return None


def flexible_bodies(model: Model, p: np.ndarray) -> list[tuple[str, list[int], float, np.ndarray, np.ndarray]]:
    """(name, columns in q, length [m], shapes and turns of its points (points, 3, modes)) of each flexible body."""
    if not model.elastic or not model.has("geometry"):
        return []
    values = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    found: dict[str, list[tuple[np.ndarray, np.ndarray, np.ndarray]]] = {}
    first = 0
    for k, point in enumerate(model.description.drawing.points):
        if point.modes:
            own = slice(first, first + point.modes)
            part = values["positions"][:, k], values["shapes"][:, own], values["turns"][:, own]
            found.setdefault(point.body, []).append(part)
            first += point.modes
    bodies = []
    for name, parts in found.items():
        columns = [k for k, one in enumerate(model.description.coordinates) if one.elastic and one.owner == name]
        positions, shapes, turns = (np.array(part) for part in zip(*parts, strict=True))
        length = float(np.linalg.norm(np.ptp(positions, axis=0)))
        if length > 0:
            bodies.append((name, columns, length, shapes, turns))
    return bodies

"""Deformation shown larger than it is, without a gap at any joint.

Multiplying q_f alone moves a body's pins off their partners. Of the deformation u = Phi q_f, the part that the body's
joint markers make is therefore shown as it is, and only the rest is multiplied:

    shown = follow + s (u - follow),   follow(x) = a + b x x + sum_k w_k(x) r_k

a and b are the small rigid motion that fits the joint markers best (one marker: its own displacement and rotation),
r_k what remains at marker k, and w_k weights that are 1 at marker k, 0 at the others and sum up to 1 between them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.views.mechanism.points import Points

SAME = 1e-9  # of the body's size: points this close are one


@dataclass(frozen=True, eq=False)
class Following:
    """What the joint markers of a body make of its deformation, linear in q_f (nf).

    rigid (6, nf): a, then b; at (K, 3): the markers' positions [m]; rest (K, 3, nf): r_k.
    """

    rigid: np.ndarray
    at: np.ndarray
    rest: np.ndarray

    def weights(self, position: np.ndarray) -> np.ndarray:
        """(n, K) weights of the markers at the positions (n, 3): by inverse squares of the distance."""
        if not len(self.at):
            return np.zeros((len(position), 0))
        squares = ((position[:, None, :] - self.at[None]) ** 2).sum(axis=2)
        near = (SAME * max(float(np.ptp(self.at, axis=0).max()), 1e-6)) ** 2
        inverse = 1.0 / np.maximum(squares, near)
        return np.asarray(inverse / inverse.sum(axis=1, keepdims=True))

    def displacement(self, position: np.ndarray, q_f: np.ndarray) -> np.ndarray:
        """(frames, n, 3) follow at the positions (n, 3) for q_f (frames, nf)."""
        a, b = self.rigid[:3] @ q_f.T, self.rigid[3:] @ q_f.T  # (3, frames)
        moved = a.T[:, None, :] + np.cross(b.T[:, None, :], position[None])
        left = np.einsum("kia,fa->fki", self.rest, q_f)
        return np.asarray(moved + np.einsum("nk,fki->fni", self.weights(position), left))


def following(markers: Points, joints: list[int]) -> Following:
    """The motion that the markers at the places `joints` make; nothing without any."""
    nf = markers.shapes.shape[2]
    at, shapes = markers.position[joints], markers.shapes[joints]
    if not joints or not nf:
        return Following(np.zeros((6, nf)), np.zeros((0, 3)), np.zeros((0, 3, nf)))
    if len(joints) == 1:
        b = markers.turns[joints[0]]
        rigid = np.vstack([shapes[0] - np.cross(b.T, at[0]).T, b])
    else:
        rows = np.vstack([np.hstack([np.eye(3), -_tilde(x)]) for x in at])
        rigid = np.linalg.lstsq(rows, shapes.reshape(-1, nf), rcond=1e-9)[0]
    fitted = np.einsum("kij,ja->kia", np.stack([np.hstack([np.eye(3), -_tilde(x)]) for x in at]), rigid)
    return Following(rigid, at, shapes - fitted)


def exaggerated(points: Points, follow: Following, q_f: np.ndarray, factor: float) -> np.ndarray:
    """(frames, n, 3) where the points are in the body's axes, its deformation multiplied by `factor` [m].

    The foreshortening, which is of second order, is shown as it is; a factor of 0 gives the undeformed body.
    """
    if factor == 0.0:
        return np.repeat(points.position[None], len(q_f), axis=0)
    followed = follow.displacement(points.position, q_f)
    return np.asarray(points.position + followed + factor * (points.linear(q_f) - followed) + points.shortening(q_f))


def _tilde(x: np.ndarray) -> np.ndarray:
    """The matrix of the cross product x x ."""
    return np.array([[0.0, -x[2], x[1]], [x[2], 0.0, -x[0]], [-x[1], x[0], 0.0]])

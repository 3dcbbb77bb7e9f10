"""Which markers of a body are joined by rods: the shortest tree through them, whatever their order in the scene."""

from __future__ import annotations

import numpy as np


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

"""Loads at which a body buckles between two of its interfaces, by itself, as Euler's for a strut.

Two opposite forces P at the interfaces, along the line between them, stress the body; K + P K_s is singular at the
critical P. The displacements are static ones of forces and moments at all interfaces, the body's modes and rigid
motions (Rayleigh-Ritz: the load is a little too large), with both interfaces held in place, or one clamped and the
other free.
"""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations
from typing import Any

import numpy as np
import scipy.linalg as la

from symgen.fe.interfaces import Interface
from symgen.fe.static import inertia_relief
from symgen.fe.structure import AXES, FEStructure
from symgen.modes.cleaning import Array

APART = 1e-6  # of the size of the body: interfaces that are nearer to each other make no strut
SAME = 1e-10  # of the largest stiffness: displacements that the others hold already


def struts(body: FEStructure, shapes: Array, parts: Sequence[Interface]) -> list[dict[str, Any]]:
    """[{markers: two names, held, first, second: critical loads [N]}] of all pairs of interfaces.

    held: both are held in place; first, second: that one is clamped, the other free. Left out where the body does not
    buckle or its stresses are not known.
    """
    if body.stress is None or len(parts) < 2:
        return []
    relief = inertia_relief(body.K, body.M, body.rigid(body.positions.mean(axis=0)))
    ends = [np.asarray(part.average.todense()) for part in parts]
    static = relief(np.vstack(ends).T)
    basis = _scaled(body, np.hstack([static, shapes]))
    rigid = body.rigid(body.positions.mean(axis=0))
    basis = np.hstack([rigid / np.linalg.norm(rigid, axis=0), basis])
    K = basis.T @ (body.K @ basis)
    moved = [average @ basis for average in ends]
    size, found = float(np.ptp(body.positions, axis=0).max()), []
    for a, b in combinations(range(len(parts)), 2):
        apart = parts[b].position - parts[a].position
        if np.linalg.norm(apart) <= APART * size:
            continue
        e = apart / np.linalg.norm(apart)
        pressed = relief((ends[a][:AXES].T - ends[b][:AXES].T) @ e)
        K_s = body.stress(pressed[:, None], basis)[0]
        across = la.null_space(e[None, :]).T
        held = np.vstack([moved[a][:AXES], across @ moved[b][:AXES], e[None, :] @ moved[a][AXES:]])
        loads = {
            "held": _critical(K, K_s, held),
            "first": _critical(K, K_s, moved[a]),
            "second": _critical(K, K_s, moved[b]),
        }
        known = {key: load for key, load in loads.items() if load is not None}
        if known:
            found.append({"markers": [parts[a].name, parts[b].name], **known})
    return found


def _scaled(body: FEStructure, displacements: Array) -> Array:
    """Of unit strain energy, and independent of each other."""
    energies = np.sum(displacements * (body.K @ displacements), axis=0)
    unit = displacements[:, energies > 0.0] / np.sqrt(energies[energies > 0.0])
    value, vectors = la.eigh(unit.T @ (body.K @ unit))
    kept = value > SAME * value[-1]
    return np.asarray(unit @ (vectors[:, kept] / np.sqrt(value[kept])))


def _critical(K: Array, K_s: Array, constraints: Array) -> float | None:
    """The smallest P > 0 with K + P K_s singular where `constraints` (c, n) q = 0."""
    free = la.null_space(constraints / np.linalg.norm(constraints, axis=1).max())
    stiffness, softening = free.T @ K @ free, free.T @ K_s @ free
    try:
        share = la.eigh(-0.5 * (softening + softening.T), 0.5 * (stiffness + stiffness.T), eigvals_only=True)
    except la.LinAlgError:  # the constraints leave a rigid motion, as of parts that lie on one axis
        return None
    return float(1.0 / share[-1]) if share[-1] > 0.0 else None

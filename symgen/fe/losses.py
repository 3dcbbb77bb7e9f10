"""What a mode set leaves out: static flexibility at the interfaces, and mass with held interfaces."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy.sparse as sp

from symgen.fe.interfaces import Interface
from symgen.fe.mode_sets import ModeSet
from symgen.fe.structure import AXES, FEStructure
from symgen.modes.cleaning import Array

RIGID_DIRECTION = 1e-9  # flexibilities below this share of the largest count as none


@dataclass(frozen=True, eq=False)
class FlexibilityLoss:
    """Flexibilities at one interface for unit loads there, (6,): Fx, Fy, Fz [m/N], Mx, My, Mz [rad/(N m)].

    full: of the finite-element model.  modal: of the modes.  loss: 1 - modal / full, 0 where full is 0.
    """

    name: str
    full: Array
    modal: Array
    loss: Array


def flexibility_losses(
    body: FEStructure, modes: ModeSet, interfaces: Sequence[Interface], clamp: Interface | None
) -> list[FlexibilityLoss]:
    """Per interface: the static elastic displacement at the load, in the full model and in the modes.

    The loads are spread over the nodes as the marker averages them. Without a `clamp` the body accelerates
    under them (or is held as its modes are); with it, the average of that interface does not move, and the
    frame of the body follows. Interfaces that modes take as rigid count as a loss.
    """
    losses = []
    for one in interfaces:
        average, name = one.average, one.name
        if clamp is not None:
            if clamp is one:
                continue
            rigid = body.rigid(clamp.position)  # the identity at the clamp itself
            average, name = average - sp.csr_matrix(average @ rigid) @ clamp.average, f"{name}, {clamp.name} held"
        spread = average.T.toarray()
        full = np.einsum("ij,ij->j", spread, modes.elastic(spread))
        modal = np.sum((average @ modes.shapes) ** 2 / modes.eigenvalues, axis=1)
        losses.append(FlexibilityLoss(name, full, modal, _loss(full, modal)))
    return losses


def _loss(full: Array, modal: Array) -> Array:
    seen = np.zeros(len(full), dtype=bool)
    for part in (slice(0, AXES), slice(AXES, None)):  # translations and rotations have different units
        seen[part] = full[part] > RIGID_DIRECTION * np.max(np.abs(full[part]))
    return np.where(seen, 1.0 - modal / np.where(seen, full, 1.0), 0.0)


def effective_masses(body: FEStructure, shapes: Array) -> Array:
    """Effective modal mass over total mass, (nf, 3): (phi^T M r)^2 / mass for mass-orthonormal phi, r along x, y, z."""
    moved = body.rigid(np.zeros(AXES))[:, :AXES]
    massed = body.M @ moved
    total = float(np.sum(moved * massed)) / AXES
    return np.asarray((shapes.T @ massed) ** 2 / total)

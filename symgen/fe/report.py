"""The report of a flexible body: frequencies, effective masses, what truncation loses, the check of rigid modes.

Effective masses (modal participation) are shares of the body's mass.

Is the structure one free body: six motions without strain, and the six that the node table says?

What a mode set leaves out: static flexibility at the interfaces, and mass with held interfaces.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp

from symgen.fe.mode_sets import ModeSet
from symgen.fe.static import FreeStatics, factorised, lowest_modes
from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure, FiniteElementError, Interface
from symgen.modes.cleaning import Array

ROUND_OFF = 1e4 * np.finfo(np.float64).eps  # strain energy below this share of its terms is none
RIGID_RESIDUAL = 1e-6  # largest share of the stiffness forces that a rigid motion may leave
SHIFT = 1e-8  # of a typical diagonal K / M: well below elastic modes, well above round-off
SURE_PIVOT = 1e-11  # of the diagonal: a pivot above it is not the round-off of none
EXTRA_MODES = 3  # modes looked at beyond the six


@dataclass(frozen=True)
class RigidCheck:
    """What was found: zero modes, forces left by rigid motions (share), lowest elastic and highest zero [Hz]."""

    zero_modes: int
    residual: float
    highest_zero: float
    lowest_elastic: float


def check_free_body(statics: FreeStatics) -> None:
    """Check that the body has exactly the six zero modes that its node table says.

    Held at six rows it has none left: that its stiffness is then positive definite by far says so. Where it is not by
    far, the lowest modes of the free body are counted.

    Raises FiniteElementError: a mass that is singular, supports in the matrices (fewer than six zero modes),
    a mechanism (more), or rigid motions of the node table that strain the structure.
    """
    body = statics.body
    _check_mass(statics)
    residual, energy = left_by(body.K, statics.rigid)
    try:
        sound = residual <= RIGID_RESIDUAL and statics.held[0].smallest_pivot > SURE_PIVOT
    except FiniteElementError as error:
        if error.item != "stiffness":
            raise
        sound = False
    if not sound:
        _count_zero_modes(statics, max(ROUND_OFF, 3.0 * energy) if residual < RIGID_RESIDUAL else ROUND_OFF)
    if residual > RIGID_RESIDUAL:
        raise FiniteElementError(
            "nodes",
            f"rigid motions built from the node table leave {residual:.2g} of the stiffness forces",
            "the dof map or the coordinates do not belong to these matrices (order of rows, units, local axes)",
        )


def _count_zero_modes(statics: FreeStatics, tolerance: float) -> None:
    """Raises FiniteElementError where they are not six."""
    shapes = _lowest_shifted(statics.body)
    zero = _share(statics.body.K, shapes) <= tolerance
    found, looked_at = int(zero.sum()), shapes.shape[1]
    if found != RIGID_MOTIONS:
        raise FiniteElementError(
            "stiffness",
            f"{'at least ' if found == looked_at else ''}{found} motions without strain were found "
            f"among the lowest {looked_at} modes, a free body has {RIGID_MOTIONS}",
            "export the matrices without supports"
            if found < RIGID_MOTIONS
            else "there is a mechanism, or parts are not connected; look near node "
            f"{_loose_node(statics.body, statics.rigid, shapes[:, zero])}",
        )


def rigid_check(statics: FreeStatics, lowest: float | None) -> RigidCheck:
    """What the check of a body that passed it says; lowest: its lowest elastic frequency [Hz], found if None."""
    body, rigid = statics.body, statics.rigid
    value = la.eigh(rigid.T @ (body.K @ rigid), rigid.T @ (body.M @ rigid), eigvals_only=True)
    if lowest is None:
        mu, _ = lowest_modes(statics.relief(), body.M, 1)
        lowest = float(mu[0] ** -0.5 / (2.0 * np.pi))
    highest = float(np.sqrt(np.abs(value).max()) / (2.0 * np.pi))
    return RigidCheck(RIGID_MOTIONS, left_by(body.K, rigid)[0], highest, lowest)


def _check_mass(statics: FreeStatics) -> None:
    body, rigid = statics.body, statics.rigid
    size = float(np.max(np.abs(body.M.diagonal()), initial=0.0))
    inertia = rigid.T @ (body.M @ rigid)
    scale = np.sqrt(np.maximum(np.diag(inertia), np.finfo(np.float64).tiny))
    if size == 0.0 or np.linalg.eigvalsh(inertia / np.outer(scale, scale))[0] < 1e-12:
        raise FiniteElementError(
            "mass",
            "the mass of the rigid body is singular (no mass, or all mass on one line)",
            "give every part a density; a straight beam needs the inertia of its section",
        )
    if body.stress is not None:
        return  # assembled here, from a positive density
    massive = np.flatnonzero(body.M.diagonal() > 0.0)
    part = sp.csr_matrix(body.M[massive][:, massive] + sp.diags(1e-12 * body.M.diagonal()[massive]))
    remedy = "inertia is never negative or lost: check the export of the mass matrix"
    factorised(part, body, massive, "mass", remedy)


def _lowest_shifted(body: FEStructure) -> Array:
    """Shapes of the lowest modes of a free structure, by a small negative shift."""
    massive = body.M.diagonal() > 0.0
    shift = SHIFT * float(np.median(body.K.diagonal()[massive] / body.M.diagonal()[massive]))
    factor = factorised(
        sp.csr_matrix(body.K + shift * body.M),
        body,
        np.arange(body.n_dof),
        "stiffness",
        "a part without mass moves freely, or the stiffness is not one of a stable structure",
    )
    return lowest_modes(factor.solve, body.M, min(RIGID_MOTIONS + EXTRA_MODES, int(massive.sum())))[1]


def _share(K: sp.csr_matrix, vectors: Array) -> Array:
    """phi^T K phi as a share of the sizes of its terms, per column."""
    energy = np.sum(vectors * (K @ vectors), axis=0)
    return np.asarray(np.abs(energy) / np.sum(np.abs(vectors) * (abs(K) @ np.abs(vectors)), axis=0))


def left_by(K: sp.csr_matrix, rigid: Array) -> tuple[float, float]:
    """Largest force and energy that the rigid motions leave, as shares of the sizes of their terms."""
    force, terms = np.abs(K @ rigid), abs(K) @ np.abs(rigid)
    return float(np.max(force.max(axis=0) / terms.max(axis=0))), float(np.max(_share(K, rigid)))


def _loose_node(body: FEStructure, rigid: Array, shapes: Array) -> int:
    """Id of the node that moves most in what strain-free motion is left beyond the six rigid ones."""
    basis = la.qr(rigid, mode="economic")[0]
    rest = shapes - basis @ (basis.T @ shapes)
    return int(body.ids[body.node[np.argmax(np.abs(rest).max(axis=1))]])


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


NO_MASS = 1e-9  # share of the mass that counts as none
CLOSE = 1e-3  # relative distance of frequencies below which shapes are badly determined
DIRECTIONS = ("x", "y", "z")
LOADS = ("Fx", "Fy", "Fz", "Mx", "My", "Mz")


def body_report(
    title: str,
    hertz: Array,
    shares: Array,
    held: tuple[Array, Array] | None,
    losses: Sequence[FlexibilityLoss],
    check: RigidCheck,
    origin: Array | None = None,
    markers: Mapping[str, Array] | None = None,
) -> str:
    """Markdown.

    origin (3,) [m]: where in the mesh places are measured from; markers: from there, (3,) [m] by name.

    hertz (nf,); shares (nf, 3): effective modal masses over total mass; held: the same two of the normal modes
    with held interfaces (Craig-Bampton), or None.
    """
    rigid = (
        f"Rigid-body check: {check.zero_modes} zero modes (up to {check.highest_zero:.2g} Hz, lowest elastic "
        f"{check.lowest_elastic:.5g} Hz); rigid motions leave {check.residual:.1g} of the stiffness forces."
    )
    parts = [f"# {title}", "", rigid, "", *_places(origin, markers or {}), "## Modes", "", *_mode_table(hertz, shares)]
    if np.max(shares, initial=0.0) < NO_MASS:
        parts += ["", "The modes are free of rigid motion: the frame carries all the mass, the modes none."]
    for a in np.flatnonzero(np.diff(hertz) < CLOSE * hertz[:-1]):
        parts += ["", f"Modes {a + 1} and {a + 2} have nearly the same frequency: their shapes depend on round-off."]
    if held is not None and len(held[0]):
        parts += ["", "## Normal modes with held interfaces", "", *_mode_table(*held)]
    parts += [
        "",
        "## Static flexibility at the interfaces: share lost",
        "",
        _row("interface", *LOADS),
        _row(*["---"] * (1 + len(LOADS))),
    ]
    parts += [_row(loss.name, *(_percent(value) for value in loss.loss)) for loss in losses]
    return "\n".join(parts) + "\n"


def _places(origin: Array | None, markers: Mapping[str, Array]) -> list[str]:
    """Where places are measured from: a gauge that is meant in the mesh's own coordinates is somewhere else."""
    if origin is None:
        return []
    at = {name: ", ".join(f"{value + 0.0:.6g}" for value in place) for name, place in markers.items()}
    listed = "; ".join(f"{name} at ({place})" for name, place in at.items())
    mesh = ", ".join(f"{value + 0.0:.6g}" for value in origin)
    return [f"Places of gauges and markers are measured from ({mesh}) m of the mesh: {listed}.", ""]


def _mode_table(hertz: Array, shares: Array) -> list[str]:
    lines = [_row("mode", "frequency [Hz]", *(f"effective mass {axis}" for axis in DIRECTIONS)), _row(*["---"] * 5)]
    lines += [_row(a + 1, f"{value:.6g}", *(_percent(share) for share in shares[a])) for a, value in enumerate(hertz)]
    total = np.sum(shares, axis=0)
    if np.max(total, initial=0.0) < NO_MASS:
        return lines
    return [
        *lines,
        _row("sum", "", *(_percent(share) for share in total)),
        _row("not represented", "", *(_percent(1.0 - share) for share in total)),
    ]


def _percent(value: float) -> str:
    return f"{100.0 * value:.3g} %" if abs(value) >= 1e-9 else "0 %"


def _row(*cells: object) -> str:
    return "| " + " | ".join(str(cell) for cell in cells) + " |"

"""Section forces of a frame by the forces that act on it: mode acceleration with inertia relief.

As of solids (mode_acceleration.py): the free frame is solved statically for each unit cause
(runtime/contract/flexible.py), and what its beams carry is known from K u and their own inertia M a. Accelerations
vary along a beam as its shape functions do, so that weight, linear fields and modes are held exactly.

Loads at which a body buckles between two of its interfaces, by itself, as Euler's for a strut.

Two opposite forces P at the interfaces, along the line between them, stress the body; K + P K_s is singular at the
critical P. The displacements are static ones of forces and moments at all interfaces, the body's modes and rigid
motions (Rayleigh-Ritz: the load is a little too large), with both interfaces held in place, or one clamped and the
other free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import Any, Literal, NamedTuple

import numpy as np
import scipy.linalg as la
from numpy.typing import ArrayLike

from runtime.contract.flexible import BodyMotion
from symgen.fe.frame import FrameElements, frame_elements
from symgen.fe.interfaces import Interface
from symgen.fe.static import acting, inertia_relief
from symgen.fe.structure import AXES, FEStructure, FiniteElementError
from symgen.modes.cleaning import Array, fixed

Which = Literal["normal", "shear", "shear_z", "torsion", "moment_y", "moment"]
PARTS: tuple[Which, ...] = ("normal", "shear", "shear_z", "torsion", "moment_y", "moment")


class LargestInFrame(NamedTuple):
    """The largest magnitude over time and place: value with its sign, t [s], line, end (0: its start, 1)."""

    value: float
    t: float
    line: int
    end: int


@dataclass(frozen=True, eq=False)
class FrameForces:
    """Forces and moments in the lines of a frame at both of their ends, along the axes of each line.

    t (N,) [s]; values (N, lines, 2, 6): normal, shear, shear_z [N], torsion, moment_y, moment [N m]; what the part
    beyond the section does to the part before it, as in `Solution.section_forces`.
    """

    t: Array
    values: Array

    def part(self, which: Which) -> Array:
        """(N, lines, 2) of one of them. Raises FiniteElementError for an unknown name."""
        if which not in PARTS:
            raise FiniteElementError("which", f"{which!r} is not known", f"take one of {', '.join(PARTS)}")
        return np.asarray(self.values[..., PARTS.index(which)])

    def largest(self, which: Which) -> LargestInFrame:
        """The largest magnitude over all samples, lines and ends. Raises as `part`."""
        values = self.part(which)
        sample, line, end = np.unravel_index(int(np.nanargmax(np.abs(values))), values.shape)
        return LargestInFrame(float(values[sample, line, end]), float(self.t[sample]), int(line), int(end))


@dataclass(frozen=True, eq=False)
class EquilibriumForces:
    """Section forces of a frame per unit cause, `causes` (k, lines, 2, 6), and per unit of q_f, `modes` (nf, ...).

    interfaces: name -> position (3,) [m] of the marker; size [m]: of the frame.
    """

    causes: Array
    modes: Array
    interfaces: dict[str, Array]
    size: float

    def of(self, motion: BodyMotion) -> FrameForces:
        """Of a motion, `solution.body_motion(name)`, by equilibrium.

        Raises FiniteElementError for a motion of a body with other modes, and for forces at a marker that is no
        interface.
        """
        amounts = acting(motion, len(self.modes), self.interfaces, self.size)
        return FrameForces(fixed(motion.t), fixed(np.tensordot(amounts, self.causes, axes=1)))

    def of_modes(self, q_f: ArrayLike, t: ArrayLike = ()) -> FrameForces:
        """The sum of modal forces for modal coordinates (N, nf) at times t (N,) [s]."""
        rows = np.atleast_2d(np.asarray(q_f, dtype=float))
        times = np.resize(np.asarray(t, dtype=float), len(rows)) if np.size(t) else np.zeros(len(rows))
        return FrameForces(fixed(times), fixed(np.tensordot(rows, self.modes, axes=1)))


def equilibrium_forces(
    body: FEStructure, shapes: Array, origin: Array, interfaces: Mapping[str, Interface]
) -> EquilibriumForces:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; errors: see `FlexibleBody.section_forces`."""
    beams = frame_elements(body)
    mass = beams.assembled(beams.mass, body.n_dof)  # consistent, whatever the modes were made with
    rigid = body.rigid(body.positions.mean(axis=0))
    fields = np.concatenate([_linear_fields(body, beams, origin), _modal_fields(beams, shapes)], axis=2)
    loads = np.zeros((body.n_dof, fields.shape[2]))
    np.add.at(loads, beams.dofs, np.einsum("eab,ebk->eak", beams.mass, fields))
    forces = [np.asarray(part.average.todense()).T for part in interfaces.values()]
    loads = np.hstack([loads, *forces])
    moved = inertia_relief(body.K, mass, rigid)(loads)
    carried = rigid @ la.solve(rigid.T @ mass @ rigid, rigid.T @ loads, assume_a="pos")
    accelerations = carried[beams.dofs]
    accelerations[:, :, : fields.shape[2]] -= fields  # a unit cause is an inertia force: minus its acceleration
    nothing = np.zeros((*beams.dofs.shape, shapes.shape[1]))
    return EquilibriumForces(
        fixed(beams.ends(moved, accelerations)),
        fixed(beams.ends(shapes, nothing)),
        {name: np.asarray(part.position - origin) for name, part in interfaces.items()},
        float(np.ptp(body.positions, axis=0).max()),
    )


def _linear_fields(body: FEStructure, beams: FrameElements, origin: Array) -> Array:
    """(m, 12, 9) accelerations x_i e_j at the ends of the beams, i slowest."""
    places = (body.positions - origin)[body.node[beams.dofs[:, [0, 6]]]]  # (m, 2, 3)
    d = beams.directions
    found = _fields(beams, places[..., None], np.broadcast_to(d[:, None, :, None], (*places.shape, 1)))
    curls = 0.5 * np.cross(np.eye(AXES)[:, None, :], np.eye(AXES)[None, :, :])  # (i, j, .) of x_i e_j
    spun = np.einsum("ijn,en,ek->ekij", curls, d, d).reshape(len(d), 1, AXES, -1)
    found.reshape(len(d), 2, 6, -1)[:, :, 3:] += spun
    return found


def _modal_fields(beams: FrameElements, shapes: Array) -> Array:
    """(m, 12, 9 nf) accelerations phi_a,i e_j at the ends of the beams, a slowest, then i; with the modes' twist."""
    ends = shapes[beams.dofs].reshape(len(beams.dofs), 2, 6, -1)
    along, turn = beams.directions[:, None, :, None], ends[:, :, 3:]
    stretch = (
        np.sum((ends[:, 1:, :3] - ends[:, :1, :3]) * along, axis=2, keepdims=True) / beams.lengths[:, None, None, None]
    )
    slopes = stretch * along + np.cross(turn, along, axis=2)
    found = _fields(beams, ends[:, :, :3], slopes)
    twist = np.einsum("epia,ei->epa", turn, beams.directions)
    axes = beams.directions[:, :, None] * beams.directions[:, None, :]
    # a mode that turns sections about the beam does so for the sum of i = j
    spun = np.einsum("epa,eij,ek->epkaij", twist, axes, beams.directions)
    found.reshape(len(beams.dofs), 2, 6, -1)[:, :, 3:] += spun.reshape(len(beams.dofs), 2, AXES, -1)
    return found


def _fields(beams: FrameElements, values: Array, slopes: Array) -> Array:
    """(m, 12, 9 k) of vectors (m, 2, 3, k) at the ends and their slopes along the beams: component i along e_j.

    The slope of a deflection turns a section; half the curl of x_i e_j turns it about the beam.
    """
    m, _, _, k = values.shape
    eye, d = np.eye(AXES), beams.directions
    found = np.zeros((m, 2, 6, k, AXES, AXES))
    found[:, :, :3] = np.einsum("epia,jn->epnaij", values, eye)
    across = np.cross(d[:, None, :], eye[None, :, :])  # (m, j, .): d x e_j
    found[:, :, 3:] = np.einsum("epia,ejn->epnaij", slopes, across)
    return found.reshape(m, 12, -1)


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

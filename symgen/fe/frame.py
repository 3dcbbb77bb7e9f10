"""Frames of straight beams in space: the Euler-Bernoulli element with 12 degrees of freedom.

The beams of a frame one by one: their matrices, the forces at their ends, and their geometric stiffness.

Section forces of a frame by the forces that act on it: mode acceleration with inertia relief.

As of solids (stresses.py): the free frame is solved statically for each unit cause
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
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Any, Literal, NamedTuple

import numpy as np
import scipy.linalg as la
import scipy.sparse as sp
from numpy.typing import ArrayLike

from runtime.contract.flexible import BodyMotion
from symgen.fe.static import FreeStatics, acting
from symgen.fe.structure import (
    AXES,
    RIGID_MOTIONS,
    FEStructure,
    FiniteElementError,
    Integers,
    Interface,
    Material,
    structure,
)
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
    statics: FreeStatics, shapes: Array, origin: Array, interfaces: Mapping[str, Interface]
) -> EquilibriumForces:
    """For shapes (n_dof, nf) about `origin` (3,) [m]; errors: see `FlexibleBody.section_forces`."""
    body, rigid = statics.body, statics.rigid
    beams = frame_elements(body)
    mass = beams.assembled(beams.mass, body.n_dof)  # consistent, whatever the modes were made with
    fields = np.concatenate([_linear_fields(body, beams, origin), _modal_fields(beams, shapes)], axis=2)
    loads = np.zeros((body.n_dof, fields.shape[2]))
    np.add.at(loads, beams.dofs, np.einsum("eab,ebk->eak", beams.mass, fields))
    forces = [np.asarray(part.average.todense()).T for part in interfaces.values()]
    loads = np.hstack([loads, *forces])
    moved = statics.relief(mass)(loads)
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
SAME_DISPLACEMENT = 1e-10  # of the largest stiffness: displacements that the others hold already


def struts(statics: FreeStatics, shapes: Array, parts: Sequence[Interface]) -> list[dict[str, Any]]:
    """[{markers: two names, held, first, second: critical loads [N]}] of all pairs of interfaces.

    held: both are held in place; first, second: that one is clamped, the other free. Left out where the body does not
    buckle or its stresses are not known.
    """
    body, rigid = statics.body, statics.rigid
    if body.stress is None or len(parts) < 2:
        return []
    relief = statics.relief()
    ends = [np.asarray(part.average.todense()) for part in parts]
    static = relief(np.vstack(ends).T)
    basis = _scaled(body, np.hstack([static, shapes]))
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
    kept = value > SAME_DISPLACEMENT * value[-1]
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


ROWS = 12  # of a beam: three displacements and three rotations at each end


@dataclass(frozen=True, eq=False)
class FrameElements:
    """m beams: rows dofs (m, 12), axes turns (m, 12, 12), lengths [m], E A [N], I_p / A [m^2] (m,).

    stiffness [N/m], mass [kg]: (m, 12, 12) in the axes of the mesh. Called, it gives the geometric stiffness by the
    axial forces N int (v'^2 + w'^2 + (I_p / A) twist'^2) dx; shear forces and moments of the stress state are left out.
    """

    dofs: Integers
    turns: Array
    lengths: Array
    stretching: Array
    polar: Array
    stiffness: Array
    mass: Array

    @property
    def directions(self) -> Array:
        """(m, 3) unit vectors along the beams."""
        return np.asarray(self.turns[:, 0, :AXES])

    def assembled(self, blocks: Array, size: int) -> sp.csr_matrix:
        """Sum of matrices (m, 12, 12) of the beams at their rows."""
        rows = np.repeat(self.dofs, ROWS, axis=1).ravel()
        columns = np.tile(self.dofs, (1, ROWS)).ravel()
        return sp.csr_matrix((blocks.ravel(), (rows, columns)), shape=(size, size))

    def ends(self, displacements: Array, accelerations: Array) -> Array:
        """(k, m, 2, 6) forces and moments in each beam at both ends, in its axes: of what is beyond on what is before.

        displacements (n_dof, k); accelerations (m, 12, k) of the beams, M a + K u = forces at the ends: exact where a
        cubic holds the acceleration along a beam.
        """
        forces = np.einsum("eab,ebk->eak", self.stiffness, displacements[self.dofs])
        forces += np.einsum("eab,ebk->eak", self.mass, accelerations)
        found = np.einsum("eab,ebk->kea", self.turns, forces).reshape(-1, len(self.dofs), 2, 6)
        found[:, :, 0] *= -1.0  # at its start the part before acts on the beam
        return np.asarray(found)

    def __call__(self, displacements: Array, shapes: Array) -> Array:
        """Geometric stiffness (k, nf, nf) of shapes (n_dof, nf) under the axial forces of displacements (n_dof, k)."""
        nf = shapes.shape[1]
        found = np.zeros((displacements.shape[1], nf, nf))
        several = zip(self.dofs, self.turns, self.lengths, self.stretching, self.polar, strict=True)
        for rows, turn, length, tension, square in several:
            moved, local = turn @ displacements[rows], turn @ shapes[rows]
            force = tension / length * (moved[6] - moved[0])
            found += force[:, None, None] * (local.T @ _unit_tension(float(length), float(square)) @ local)
        return found


def frame_elements(body: FEStructure) -> FrameElements:
    """The beams of a body. Raises FiniteElementError for one that is not made from a LineMesh."""
    if isinstance(body.stress, FrameElements):
        return body.stress
    raise FiniteElementError("section forces", "the body is not a frame", "make it with from_mesh from a LineMesh")


def _unit_tension(length: float, square: float) -> Array:
    """Geometric stiffness (12, 12) of a cubic element under N = 1, in its own axes."""
    h, result = length, np.zeros((ROWS, ROWS))
    bending = np.array(
        [
            [36.0, 3.0 * h, -36.0, 3.0 * h],
            [3.0 * h, 4.0 * h * h, -3.0 * h, -h * h],
            [-36.0, -3.0 * h, 36.0, -3.0 * h],
            [3.0 * h, -h * h, -3.0 * h, 4.0 * h * h],
        ]
    ) / (30.0 * h)
    for rows, sign in (([1, 5, 7, 11], 1.0), ([2, 4, 8, 10], -1.0)):
        signs = np.array([1.0, sign, 1.0, sign])
        result[np.ix_(rows, rows)] += np.outer(signs, signs) * bending
    result[np.ix_([3, 9], [3, 9])] += square / h * np.array([[1.0, -1.0], [-1.0, 1.0]])
    return result


PARALLEL = 1e-6


@dataclass(frozen=True)
class Section:
    """A beam's section: area [m^2]; I_y, I_z [m^4]: int z^2 dA and int y^2 dA; torsion [m^4].

    The y axis of the section is the part of `y_axis` at right angles to the beam.
    """

    area: float
    I_y: float
    I_z: float
    torsion: float
    y_axis: tuple[float, float, float] = (0.0, 1.0, 0.0)

    @classmethod
    def rectangle(cls, y: float, z: float, y_axis: tuple[float, float, float] = (0.0, 1.0, 0.0)) -> Section:
        """A solid rectangle, y by z [m]; torsion by the usual closed approximation (0.5 % at most)."""
        long, short = max(y, z), min(y, z)
        ratio = short / long
        torsion = long * short**3 * (1.0 / 3.0 - 0.21 * ratio * (1.0 - ratio**4 / 12.0))
        return cls(y * z, y * z**3 / 12.0, z * y**3 / 12.0, torsion, y_axis)


@dataclass(frozen=True, eq=False)
class LineMesh:
    """Beams between nodes: nodes (n, 3) [m], lines (m, 2) of places in `nodes`, one section or one per line."""

    nodes: ArrayLike
    lines: ArrayLike
    section: Section | Sequence[Section]


def frame_structure(mesh: LineMesh, material: Material) -> FEStructure:
    """Stiffness and consistent mass of a frame; node ids are the places 0, 1, ... in the mesh.

    Raises FiniteElementError for lines without length, wrong numbers of sections, and a section axis along its beam.
    """
    positions = np.asarray(mesh.nodes, dtype=np.float64)
    lines = np.asarray(mesh.lines, dtype=np.int64)
    if lines.ndim != 2 or lines.shape[1] != 2 or lines.min(initial=0) < 0 or lines.max(initial=-1) >= len(positions):
        raise FiniteElementError("mesh.lines", "not pairs of places in the table of nodes", "count nodes from 0")
    sections = [mesh.section] * len(lines) if isinstance(mesh.section, Section) else list(mesh.section)
    if len(sections) != len(lines):
        raise FiniteElementError(
            "mesh.section", f"{len(sections)} sections for {len(lines)} lines", "give one for all or one for each"
        )
    blocks = [_element(positions[line], section, material) for line, section in zip(lines, sections, strict=True)]
    beams = _elements(positions, lines, sections, material, blocks)
    n = len(positions)
    K, M = (beams.assembled(matrices, RIGID_MOTIONS * n) for matrices in (beams.stiffness, beams.mass))
    body = structure(
        K, M, np.arange(n), positions, np.repeat(np.arange(n), RIGID_MOTIONS), np.tile(np.arange(RIGID_MOTIONS), n)
    )
    return replace(body, stress=beams)


def _elements(
    positions: Array,
    lines: Integers,
    sections: Sequence[Section],
    material: Material,
    blocks: Sequence[tuple[Array, Array]],
) -> FrameElements:
    along = positions[lines[:, 1]] - positions[lines[:, 0]]
    lengths = np.linalg.norm(along, axis=1)
    turns = [_turn(direction, section) for direction, section in zip(along / lengths[:, None], sections, strict=True)]
    return FrameElements(
        (RIGID_MOTIONS * lines[:, :, None] + np.arange(RIGID_MOTIONS)).reshape(len(lines), 2 * RIGID_MOTIONS),
        np.array(turns).reshape(-1, 12, 12),
        lengths,
        np.array([material.E * section.area for section in sections]),
        np.array([(section.I_y + section.I_z) / section.area for section in sections]),
        np.array([block[0] for block in blocks]).reshape(-1, 12, 12),
        np.array([block[1] for block in blocks]).reshape(-1, 12, 12),
    )


def _turn(direction: Array, section: Section) -> Array:
    """Axes of a beam for its 12 rows."""
    return np.asarray(np.kron(np.eye(4), _triad(direction, np.array(section.y_axis, dtype=np.float64))), dtype=float)


def _element(ends: Array, section: Section, material: Material) -> tuple[Array, Array]:
    """Stiffness and consistent mass (12, 12) of one beam, in the axes of the mesh."""
    along = ends[1] - ends[0]
    length = float(np.linalg.norm(along))
    if length == 0.0:
        raise FiniteElementError("mesh.lines", "a line has no length", "join nodes that are at different places")
    turn = _turn(along / length, section)
    K, M = np.zeros((12, 12)), np.zeros((12, 12))
    line_mass = material.rho * section.area
    polar = material.rho * (section.I_y + section.I_z)
    for first, last, stiff, heavy in (
        (0, 6, material.E * section.area, line_mass),
        (3, 9, material.G * section.torsion, polar),
    ):
        place = np.ix_([first, last], [first, last])
        K[place] += stiff / length * np.array([[1.0, -1.0], [-1.0, 1.0]])
        M[place] += heavy * length / 6.0 * np.array([[2.0, 1.0], [1.0, 2.0]])
    # Bending in x-y: slope is +theta_z; in x-z: slope is -theta_y.
    stiffness, mass = _bending(length)
    for rows, sign, second in (([1, 5, 7, 11], 1.0, section.I_z), ([2, 4, 8, 10], -1.0, section.I_y)):
        signs = np.array([1.0, sign, 1.0, sign])
        place = np.ix_(rows, rows)
        K[place] += material.E * second * np.outer(signs, signs) * stiffness
        M[place] += line_mass * np.outer(signs, signs) * mass
    return turn.T @ K @ turn, turn.T @ M @ turn


def _bending(length: float) -> tuple[Array, Array]:
    """Stiffness for EI = 1 and consistent mass for rho A = 1 of a cubic element, dofs (w_0, w_0', w_1, w_1')."""
    h = length
    stiffness = (
        np.array(
            [
                [12.0, 6.0 * h, -12.0, 6.0 * h],
                [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
                [-12.0, -6.0 * h, 12.0, -6.0 * h],
                [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
            ]
        )
        / h**3
    )
    mass = np.array(
        [
            [156.0, 22.0 * h, 54.0, -13.0 * h],
            [22.0 * h, 4.0 * h * h, 13.0 * h, -3.0 * h * h],
            [54.0, 13.0 * h, 156.0, -22.0 * h],
            [-13.0 * h, -3.0 * h * h, -22.0 * h, 4.0 * h * h],
        ]
    )
    return stiffness, mass * (h / 420.0)


def _triad(x: Array, wish: Array) -> Array:
    """Rows: the beam's axes in those of the mesh; y is the part of `wish` at right angles to x."""
    y = wish - (wish @ x) * x
    size = float(np.linalg.norm(y))
    if size <= PARALLEL * float(np.linalg.norm(wish)) or size == 0.0:
        raise FiniteElementError("section.y_axis", f"{wish.tolist()} is along a beam", "give another y axis")
    y = y / size
    return np.stack([x, y, np.cross(x, y)]).reshape(AXES, AXES)

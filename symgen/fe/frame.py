"""Frames of straight beams in space: the Euler-Bernoulli element with 12 degrees of freedom.

The beams of a frame one by one: their matrices, the forces at their ends, and their geometric stiffness.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy.sparse as sp
from numpy.typing import ArrayLike

from symgen.fe.structure import AXES, RIGID_MOTIONS, FEStructure, FiniteElementError, Integers, Material, structure
from symgen.modes.cleaning import Array

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

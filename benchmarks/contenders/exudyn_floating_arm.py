"""The hanging arm in Exudyn, its last link in a floating frame: the beam modes of ours, in ObjectFFRFreducedOrder.

That body is made for solid meshes. Here its nodes are Gauss points of the beam with their masses, so that the matrices
which Exudyn computes from nodes and shapes are the integrals over the beam; its spatial frame is held in the plane.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np
from scipy.sparse import csr_matrix, diags

from benchmarks.contenders.exudyn_arm import AREA, DENSITY, GRAVITY, MODULUS, SECOND_MOMENT, ExudynArm
from benchmarks.scenes.arm import LENGTH
from symgen.modes.beam import exact_bending

OUT_OF_PLANE = (2, 3, 4)  # z and the first two angles of a frame at Rx Ry Rz
NODE = "NodeType.RotationRxyz"


@dataclass(frozen=True)
class Mesh:
    """What Exudyn asks of a mesh: shapes at points along the beam, the first of them its start."""

    modes: int
    modulus: float

    @cached_property
    def _shapes(self) -> Any:
        return exact_bending("clamped-free", self.modes)

    @property
    def modeBasis(self) -> dict[str, Any]:
        """Displacements (3 points, modes), across the beam only."""
        basis = np.zeros((3 * (len(self._shapes.xi) + 1), self.modes))
        basis[4::3] = self._shapes.phi
        return {"matrix": basis, "type": "NormalModes"}

    @property
    def postProcessingModes(self) -> dict[str, Any]:
        """None."""
        return {}

    @property
    def stiffness(self) -> np.ndarray:
        """(modes, modes) of the modal coordinates [N/m]."""
        return np.asarray(self.modulus * SECOND_MOMENT / LENGTH**3 * self._shapes.kappa)

    def GetNodePositionsAsArray(self) -> np.ndarray:
        """(points, 3) [m]."""
        positions = np.zeros((len(self._shapes.xi) + 1, 3))
        positions[1:, 0] = LENGTH * self._shapes.xi
        return positions

    def GetMassMatrix(self, sparse: bool = True) -> csr_matrix:
        """Of the points, the start without mass [kg]."""
        masses = DENSITY * AREA * LENGTH * np.concatenate([[0.0], self._shapes.mu])
        return csr_matrix(diags(np.repeat(masses, 3)))

    def GetStiffnessMatrix(self, sparse: bool = True) -> csr_matrix:
        """Empty: the modal one is known."""
        return csr_matrix((3 * (len(self._shapes.xi) + 1),) * 2)

    def GetSurfaceTriangles(self) -> list[Any]:
        """None."""
        return []

    GetSurfaceTriangles6 = GetSurfaceTriangles


@dataclass(frozen=True)
class FloatingArm(ExudynArm):
    """`elements` is the number of modes."""

    @property
    def _body(self) -> str:
        return f"floating frame with {self.elements} modes"

    def _last_link(self, mbs: Any, items: Any, place: np.ndarray) -> int:
        """The last link from a place on; the node of its frame."""
        from exudyn.FEM import ObjectFFRFreducedOrderInterface

        mesh = Mesh(self.elements, MODULUS * self.stiffening)
        body = ObjectFFRFreducedOrderInterface(mesh, rigidBodyNodeType=NODE)
        body.stiffnessMatrixReduced = mesh.stiffness
        c, s = np.cos(self.angles[-1]), np.sin(self.angles[-1])
        made = body.AddObjectFFRFreducedOrder(
            mbs,
            positionRef=[*place, 0],
            rotationMatrixRef=np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]),
            gravity=[0, -GRAVITY, 0],
        )
        node = int(made["nRigidBody"])
        ground = mbs.AddMarker(
            items.MarkerNodeCoordinate(nodeNumber=mbs.AddNode(items.NodePointGround()), coordinate=0)
        )
        for k in OUT_OF_PLANE:
            held = mbs.AddMarker(items.MarkerNodeCoordinate(nodeNumber=node, coordinate=k))
            mbs.AddObject(items.CoordinateConstraint(markerNumbers=[ground, held]))
        return node

"""Bodies from finite elements: numbers for a spatial modal body of a scene (Eqs. 15-20).

`FlexibleBody` reads matrices of other programs or assembles a mesh, finds modes, and integrates. The steps, one
module each: reading or assembling a `FEStructure`, checking that it is one free body, interfaces, mode set, integrals.
"""

from symgen.fe.body import FlexibleBody
from symgen.fe.frame import LineMesh, Section
from symgen.fe.inertia import Marker
from symgen.fe.matrix_files import read_dof_map, read_matrix
from symgen.fe.reduced import ReducedBody
from symgen.fe.structure import STEEL, FEStructure, FiniteElementError, FiniteElementWarning, Material

__all__ = [
    "STEEL",
    "FEStructure",
    "FiniteElementError",
    "FiniteElementWarning",
    "FlexibleBody",
    "LineMesh",
    "Marker",
    "Material",
    "ReducedBody",
    "Section",
    "read_dof_map",
    "read_matrix",
]

"""Bodies from finite elements: numbers for a spatial modal body of a scene (Eqs. 15-20).

`FlexibleBody` reads matrices of other programs or assembles a mesh, finds modes, and integrates. The steps, one
module each: reading or assembling a `Structure`, checking that it is one free body, interfaces, mode set, integrals.
"""

from .body import FlexibleBody, Marker
from .errors import FiniteElementError
from .frame import LineMesh, Section
from .material import STEEL, Material
from .structure import Structure

__all__ = ["STEEL", "FiniteElementError", "FlexibleBody", "LineMesh", "Marker", "Material", "Section", "Structure"]

"""Linear finite-element structures, M x'' + D x' + K x = F(t), stepped by regions (Section 2 of the paper, Eqs.
3-14, 72).

A structure is data: sparse matrices, never written out as equations. Its groups of nodes have steps of their own; see
`StructureModel`.
"""

from runtime.structures.model import StructureModel
from runtime.structures.structure import LinearStructure, StructureError

__all__ = ["LinearStructure", "StructureError", "StructureModel"]

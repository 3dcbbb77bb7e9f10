"""An archive of Ansys (`.cdb`: NBLOCK, EBLOCK, CMBLOCK) by mapdl-archive: solids and components, as meshio has them."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from symgen.fe.structure import FiniteElementError, Integers

HEADER = 10  # numbers of an element before its nodes: material, type, real constants, ..., the element's own
TYPE, NUMBER = 1, 8  # of them: row of the table of element types, number of the element
SOLIDS = {185: "hexahedron", 45: "hexahedron", 186: "hexahedron20", 95: "hexahedron20", 187: "tetra10", 92: "tetra10",
          285: "tetra"}  # fmt: skip
NODES = {"hexahedron": 8, "hexahedron20": 20, "tetra10": 10, "tetra": 4}
CORNERS = 8


def read_archive(file: Path) -> Any:
    """Nodes, cells and components in the fields of a meshio Mesh. Raises FiniteElementError."""
    try:
        from mapdl_archive import Archive
    except ImportError as error:
        raise FiniteElementError("mapdl-archive", "it is not installed", "pip install 'symgen[files]'") from error
    remedy = "write it by CDWRITE,DB with blocked formats (NBLOCK, EBLOCK)"
    try:
        found = Archive(str(file), parse_vtk=False)
        numbers, points = np.asarray(found.nnum), np.asarray(found.nodes, dtype=float)
        elements, types = list(found.elem), {int(row[0]): int(row[1]) for row in found.ekey}
    except Exception as error:  # whatever its parser meets in a file that is none
        said = " ".join(str(error).split()) or type(error).__name__
        raise FiniteElementError(file.name, f"mapdl-archive cannot read it: {said[:200]}", remedy) from error
    if not len(points) or not elements:
        raise FiniteElementError(file.name, "has no nodes or no elements", remedy)
    place = {int(number): k for k, number in enumerate(numbers)}
    rows: dict[str, list[list[int]]] = {}
    owners: dict[str, list[int]] = {}
    for one in elements:
        kind = _kind(types, one)
        rows.setdefault(kind, []).append([_at(file, place, int(one[NUMBER]), int(node)) for node in one[HEADER:]])
        owners.setdefault(kind, []).append(int(one[NUMBER]))
    cells = [SimpleNamespace(type=kind, data=_rows(kind, data)) for kind, data in rows.items()]
    sets = {name: [place[int(n)] for n in nodes if int(n) in place] for name, nodes in found.node_components.items()}
    cell_sets = {
        name: [np.flatnonzero(np.isin(owners[kind], members)) for kind in rows]
        for name, members in found.element_components.items()
    }
    return SimpleNamespace(
        points=points, cells=cells, point_sets=sets, cell_sets=cell_sets, field_data={}, cell_data={}
    )


def _kind(types: dict[int, int], element: Integers) -> str:
    """As meshio calls it; what is no solid, or one with corners that coincide, by its name in Ansys."""
    number = types.get(int(element[TYPE]), 0)
    kind, nodes = SOLIDS.get(number), element[HEADER:]
    if kind is None:
        return f"elements of type {number}" if number else "elements without a type (ET)"
    if len(nodes) != NODES[kind] or len(set(nodes[:CORNERS].tolist())) < min(CORNERS, NODES[kind]) or 0 in nodes:
        return f"SOLID{number} with corners that coincide or nodes left out (wedges, pyramids)"
    return kind


def _at(file: Path, place: dict[int, int], element: int, node: int) -> int:
    if node and node not in place:
        problem = f"element {element} has the node {node}, which its NBLOCK has not"
        raise FiniteElementError(file.name, problem, "write the archive with all nodes")
    return place.get(node, -1)


def _rows(kind: str, data: list[list[int]]) -> Integers:
    if kind in NODES:
        return np.array(data, dtype=np.int64)
    return np.zeros((len(data), 1), dtype=np.int64)  # which is refused, and only counted

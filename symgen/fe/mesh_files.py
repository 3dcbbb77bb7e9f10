"""Meshes of other programs by meshio and mapdl-archive: tetrahedra and hexahedra, with their named sets."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import redirect_stderr, redirect_stdout
from functools import cached_property
from io import StringIO
from itertools import product
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from symgen.fe.ansys_archive import read_archive
from symgen.fe.input_deck import plain_deck
from symgen.fe.structure import AXES, FiniteElementError, Flags, Integers, NodeSet
from symgen.fe.units import LENGTHS, known_units
from symgen.modes.cleaning import Array

# Corners of the reference cube and tetrahedron in the order of the files (that of VTK), then the middles of edges.
HEXAHEDRON = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))
HEX_EDGES = ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7))
TETRAHEDRON = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
TET_EDGES = ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3))
SOLIDS = {"tetra": 4, "tetra10": 4, "hexahedron": 8, "hexahedron20": 8, "hexahedron27": 8}
FACES = ("vertex", "line", "line3", "triangle", "triangle6", "quad", "quad8", "quad9")
WITH_FACES = (".msh",)  # files whose faces name surfaces and are no elements
QUOTES = "'\"*, "
ONE_NODE = 1e-7  # of the size of the body: nodes at one place


class FileMesh:
    """A mesh from a file: `mesh` of scikit-fem in metres, and its sets of nodes as places (k, 3) [m] by name."""

    def __init__(self, path: str | Path, units: str) -> None:
        file = Path(path)
        found = _read(file)
        scale = LENGTHS[known_units(units)]
        if not found.cells or np.ndim(found.points) != 2:
            raise FiniteElementError(file.name, "has no nodes or no elements", "write the mesh, not only its steps")
        self.points: Array = np.asarray(found.points, dtype=float)[:, :AXES] * scale
        self.name, cells = file.name, [(one.type, np.asarray(one.data, dtype=np.int64)) for one in found.cells]
        kinds = sorted({kind for kind, data in cells if kind in SOLIDS and len(data)})
        self._check(file, kinds, cells)
        self.kind = kinds[0]
        self.cells: Integers = np.concatenate([data for kind, data in cells if kind == self.kind])
        self.quadratic = self.kind not in ("tetra", "hexahedron")
        self.sets = self._sets(found, cells)

    def _check(self, file: Path, kinds: list[str], cells: list[tuple[str, Integers]]) -> None:
        faces = FACES if file.suffix.lower() in WITH_FACES else ("vertex",)
        others = [f"{len(data)} {kind}" for kind, data in cells if kind not in SOLIDS and kind not in faces]
        if others:
            problem = f"has elements that are no tetrahedra or hexahedra: {', '.join(others)}"
            raise FiniteElementError(file.name, problem, "leave them out of the export, or take from_matrices")
        if len(kinds) != 1:
            output = f"has {' and '.join(kinds)} elements" if kinds else "has no tetrahedra or hexahedra"
            raise FiniteElementError(file.name, output, "mesh the body with one kind of solid element")

    def _sets(self, found: Any, cells: list[tuple[str, Integers]]) -> dict[str, Array]:
        """Places of the nodes of node sets, and of element sets: those of their elements."""
        sets = {name: self.points[np.asarray(nodes, dtype=np.int64)] for name, nodes in found.point_sets.items()}
        for name, blocks in found.cell_sets.items():
            if name.startswith("gmsh:") or name in sets:
                continue
            pairs = ((data, block) for block, (_, data) in zip(blocks, cells, strict=True))
            own = [np.unique(data[np.asarray(block, dtype=np.int64)]) for data, block in pairs if _any(block)]
            if own:
                sets[name] = self.points[np.unique(np.concatenate(own))]
        return sets | self._groups(found, cells)

    def _groups(self, found: Any, cells: list[tuple[str, Integers]]) -> dict[str, Array]:
        """Places of the nodes of Gmsh's physical groups, by their names."""
        sets = {}
        for name, (tag, dimension) in found.field_data.items():
            marks = found.cell_data.get("gmsh:physical", [])
            blocks = zip(cells, marks, strict=False)
            own = [data[np.asarray(mark) == tag] for (kind, data), mark in blocks if _dimension(kind) == dimension]
            nodes = [np.unique(one) for one in own if one.size]
            if nodes:
                sets[name] = self.points[np.unique(np.concatenate(nodes))]
        return sets

    def nodes_of(self, places: Array, positions: Array) -> Flags:
        """Which nodes (n,) at `positions` (n, 3) [m] belong to a set at `places` (k, 3) [m].

        Those at its places; and where the body has nodes that the file has not, on an edge or a face all of whose nodes
        are in the set.
        """
        from scipy.spatial import KDTree  # when it is needed: importing it takes long

        size = float(np.ptp(positions, axis=0).max())
        chosen: Flags = KDTree(places).query(positions)[0] <= ONE_NODE * size
        mesh = self.mesh
        n, edges = mesh.nvertices, mesh.nedges
        if len(positions) == n:
            return chosen
        if not self.quadratic:  # vertices, then edges, then faces of hexahedra, then cells
            chosen[n : n + edges] = chosen[mesh.edges].all(axis=0)
        if SOLIDS[self.kind] == 8:
            chosen[n + edges : n + edges + mesh.nfacets] |= chosen[mesh.facets].all(axis=0)
        return chosen

    @cached_property
    def mesh(self) -> Any:
        """MeshTet or MeshHex; with curved edges, MeshTet2 or MeshHex2, where the file's elements are quadratic."""
        try:
            import skfem
        except ImportError as error:
            raise FiniteElementError("scikit-fem", "it is not installed", "pip install 'symgen[fe]'") from error
        corners = SOLIDS[self.kind]
        used, local = np.unique(self.cells[:, :corners], return_inverse=True)
        local = local.reshape(-1, corners)
        if corners == 4:
            mesh = skfem.MeshTet(self.points[used].T.copy(), local.T.copy())
        else:
            reference = skfem.ElementHex1.doflocs
            order = [HEXAHEDRON.index(tuple(int(round(x)) for x in one)) for one in reference]
            mesh = skfem.MeshHex(self.points[used].T.copy(), local[:, order].T.copy())
        return self._curved(skfem, mesh, used) if self.quadratic else mesh

    def _curved(self, skfem: Any, mesh: Any, used: Integers) -> Any:
        """The mesh with the nodes inside of edges, faces and cells where the file's elements have them."""
        tet = SOLIDS[self.kind] == 4
        curved = (skfem.MeshTet2 if tet else skfem.MeshHex2).from_mesh(mesh)
        element = skfem.ElementTetP2 if tet else skfem.ElementHex2
        basis = skfem.Basis(mesh, element(), intorder=1)
        places = np.array(curved.doflocs)
        corners = np.array(TETRAHEDRON if tet else HEXAHEDRON, dtype=float)
        reference = np.asarray((skfem.ElementTetP1 if tet else skfem.ElementHex1).doflocs, dtype=float)
        for e, cell in enumerate(self.cells):
            numbers = {int(node): k for k, node in enumerate(cell[: len(corners)])}
            own = corners[[numbers[int(used[v])] for v in mesh.t[:, e]]]  # the file's coordinates of the corners here
            at = _affine(reference, own, np.asarray(element.doflocs, dtype=float))
            places[:, basis.element_dofs[:, e]] = (_quadratic(at, self.kind) @ self.points[cell]).T
        return type(curved)(places, curved.t)


def _dimension(kind: str) -> int:
    """Of an element: 0 of a vertex to 3 of a solid."""
    starts = (("vertex",), ("line",), ("triangle", "quad"))
    return next((k for k, names in enumerate(starts) if kind.startswith(names)), 3)


def interface_of(mesh: FileMesh, interface: Mapping[str, str | NodeSet]) -> dict[str, NodeSet]:
    """Interfaces with the names of sets of the file as functions of places. Raises FiniteElementError."""
    return {name: _in_set(mesh, name, one) if isinstance(one, str) else one for name, one in interface.items()}


def _in_set(mesh: FileMesh, name: str, wanted: str) -> NodeSet:
    known = {key.lower(): key for key in mesh.sets}
    if wanted.lower() not in known:
        problem = f"{mesh.name} has no set {wanted!r}; it has {', '.join(map(repr, mesh.sets)) or 'none'}"
        remedy = "write the set with the mesh (*NSET, a physical group), or give a function of positions"
        raise FiniteElementError(f"interface '{name}'", problem, remedy)
    places = mesh.sets[known[wanted.lower()]]
    if not len(places):
        raise FiniteElementError(f"interface '{name}'", f"set {wanted!r} of {mesh.name} is empty", "name its nodes")

    def chosen(positions: Array) -> Any:
        return mesh.nodes_of(places, positions)

    return chosen


def _any(block: Any) -> bool:
    return block is not None and len(block) > 0


def _read(file: Path) -> Any:
    if file.suffix.lower() == ".cdb":
        if not file.is_file():
            raise FiniteElementError(str(file), "there is no such file", "check the path")
        return read_archive(file)
    try:
        import meshio
    except ImportError as error:
        raise FiniteElementError("meshio", "it is not installed", "pip install 'symgen[files]'") from error
    if not file.is_file():
        raise FiniteElementError(str(file), "there is no such file", "check the path")
    output = StringIO()
    try:
        with redirect_stdout(output), redirect_stderr(output), TemporaryDirectory() as folder:
            plain = file
            if file.suffix.lower() == ".inp":
                plain = Path(folder) / file.name
                plain.write_text(plain_deck(file), encoding="utf-8")
            return meshio.read(plain)
    except FiniteElementError:
        raise
    except (Exception, SystemExit) as error:  # meshio leaves the program where none of its readers takes a file
        said = " ".join((output.getvalue() if isinstance(error, SystemExit) else f"{error}").split())
        said = said.partition(" Error: ")[0]  # the rest is the place of the plain copy
        problem = f"meshio cannot read it: {_keyword(file, said)}"
        remedy = "write tetrahedra or hexahedra as .inp (Abaqus, CalculiX), .bdf, .msh, .cdb (Ansys), .vtu or .med"
        raise FiniteElementError(file.name, problem, remedy) from error


def _keyword(file: Path, output: str) -> str:
    """What the reader said, and the line where the word that it names stands."""
    for number, line in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        for word in (part.strip(QUOTES) for part in output.split()):
            if len(word) > 2 and word.upper() in line.upper():
                return f"{output} (line {number}: {line.strip()[:60]})"
    return output


def _affine(reference: Array, own: Array, at: Array) -> Array:
    """Coordinates `at` (n, 3) in those where the corners `reference` (c, 3) are `own` (c, 3)."""
    system = np.hstack([np.ones((len(reference), 1)), reference])
    return np.asarray(np.hstack([np.ones((len(at), 1)), at]) @ np.linalg.lstsq(system, own, rcond=None)[0])


def _quadratic(at: Array, kind: str) -> Array:
    """Shape functions of the file's quadratic element at its coordinates (n, 3), (n, nodes)."""
    if kind == "tetra10":
        shares = np.column_stack([1 - at.sum(axis=1), at])
        edges = [4 * shares[:, a] * shares[:, b] for a, b in TET_EDGES]
        return np.column_stack([shares * (2 * shares - 1), *edges])
    corners = np.array(HEXAHEDRON, dtype=float)
    if kind == "hexahedron27":
        nodes = [*corners, *(corners[[a, b]].mean(axis=0) for a, b in HEX_EDGES), *HEX_FACES, (0.5, 0.5, 0.5)]
        return _through(at, np.array(nodes, dtype=float), [p for p in product(range(3), repeat=AXES)])
    nodes = [*corners, *(corners[[a, b]].mean(axis=0) for a, b in HEX_EDGES)]
    serendipity = [p for p in product(range(3), repeat=AXES) if sum(1 for k in p if k == 2) <= 1]
    return _through(at, np.array(nodes), serendipity)


HEX_FACES = ((0.0, 0.5, 0.5), (1.0, 0.5, 0.5), (0.5, 0.0, 0.5), (0.5, 1.0, 0.5), (0.5, 0.5, 0.0), (0.5, 0.5, 1.0))


def _through(at: Array, nodes: Array, powers: list[tuple[int, ...]]) -> Array:
    """Values at `at` of the polynomials that are one at one of the nodes each."""
    terms = [np.stack([X[:, 0] ** i * X[:, 1] ** j * X[:, 2] ** k for i, j, k in powers], axis=1) for X in (at, nodes)]
    return np.asarray(terms[0] @ np.linalg.inv(terms[1]))

"""Matrices and meshes of other programs, written by the rules of their formats."""

from __future__ import annotations

import re
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
import scipy.sparse as sp
from numpy.testing import assert_allclose

from symgen.fe import STEEL, FiniteElementError, FlexibleBody, read_dof_map, read_matrix

MATRIX = np.array([[4.0, -1.5, 0.0], [-1.5, 5.0, -2.25e-3], [0.0, -2.25e-3, 6.0e9]])
needs_meshio = pytest.mark.skipif(
    find_spec("meshio") is None or find_spec("skfem") is None, reason="meshio, scikit-fem"
)


def written(folder: Path, name: str, *lines: str) -> Path:
    path = folder / name
    path.write_text("\n".join(lines) + "\n")
    return path


def triangle(style: str = "{} {} {:.15e}", upper: bool = True) -> list[str]:
    pairs = [(i, j) for i in range(3) for j in range(3) if (i <= j if upper else i >= j) and MATRIX[i, j]]
    return [style.format(i + 1, j + 1, MATRIX[i, j]) for i, j in pairs]


def test_coordinates_without_a_banner(tmp_path: Path) -> None:
    """Abaqus FORMAT=COORDINATE and CalculiX .sti: row, column, value; one triangle or both, D as exponent."""
    full = [f"{i + 1} {j + 1} {MATRIX[i, j]:.15e}" for i in range(3) for j in range(3) if MATRIX[i, j]]
    for name, lines in (
        ("STIF1.mtx", triangle("{} {}  {:.15e}")),
        ("STIF2.mtx", triangle("{:>8},{:>8}, {:.15e}", upper=False)),
        ("job.sti", triangle("{:>10d} {:>10d} {:>20.13e}")),
        ("full.mtx", full),
        ("fortran.mtx", [line.replace("e", "D") for line in full]),
    ):
        assert_allclose(read_matrix(written(tmp_path, name, *lines)).toarray(), MATRIX, rtol=1e-12)


def test_matrix_market(tmp_path: Path) -> None:
    """As Ansys *EXPORT,,MMF writes it."""
    scipy.io.mmwrite(tmp_path / "K.mmf.mtx", sp.coo_matrix(MATRIX), symmetry="symmetric")
    path = written(tmp_path, "bad.mtx", "%%MatrixMarket matrix coordinate real general", "3 3 1", "7 7 1.0")
    assert_allclose(read_matrix(tmp_path / "K.mmf.mtx").toarray(), MATRIX)
    with pytest.raises(FiniteElementError, match="bad.mtx: is not a valid MatrixMarket file"):
        read_matrix(path)


def test_nodes_and_dofs(tmp_path: Path) -> None:
    """Abaqus FORMAT=MATRIX INPUT: node, dof, node, dof, value; the mass without the rotation that the stiffness has."""
    rows = ((7, 1), (7, 2), (12, 6))
    lines = ["** MATRIX INPUT", "*MATRIX INPUT, NAME=K"]
    lines += [
        f"{rows[i][0]},{rows[i][1]}, {rows[j][0]},{rows[j][1]}, {MATRIX[i, j]:.15e}"
        for i in range(3)
        for j in range(i + 1)
        if MATRIX[i, j]
    ]
    stiffness = written(tmp_path, "K.mtx", *lines)
    mass = written(tmp_path, "M.mtx", "7,1, 7,1, 2.5", "7,2, 7,2, 2.5")
    dofs = read_dof_map(stiffness)
    assert dofs.tolist() == [list(row) for row in rows]
    assert_allclose(read_matrix(stiffness).toarray(), MATRIX)
    assert_allclose(read_matrix(mass, dofs).toarray(), np.diag([2.5, 2.5, 0.0]))
    with pytest.raises(FiniteElementError, match="K.mtx: line 6: dof 6 of node 12 is not in the dof map"):
        read_matrix(stiffness, [(7, 1), (7, 2)])


def test_maps(tmp_path: Path) -> None:
    """CalculiX .dof, Ansys .mapping with its head and out of order, and rows of two numbers."""
    wanted = [[7, 1], [7, 2], [12, 6]]
    for name, lines in (
        ("job.dof", ["7.1", "7.2", "12.6"]),
        ("K.mapping", ["  Matrix Eqn      Node   DOF", "  3  12  ROTZ", "  1  7  UX", "  2  7  UY"]),
        ("map.txt", ["# node component", "7 1", "7, 2", "12 6"]),
    ):
        assert read_dof_map(written(tmp_path, name, *lines)).tolist() == wanted
    with pytest.raises(FiniteElementError, match="job.dof: line 2, 'seven', is no node and component"):
        read_dof_map(written(tmp_path, "job.dof", "7.1", "seven"))


@pytest.mark.parametrize(
    "lines, problem",
    [
        (["1 1 2.0", "1 x 3.0"], "line 2, '1 x 3.0', is not numbers"),
        (["1 1 2.0", "1 2"], "line 2 has 2 numbers, those before have 3"),
        (["1 1 2.0", "0 1 2.0"], "line 2: rows and columns count from 1"),
        (["1 1.5 2.0"], "line 1: a row is not a whole number"),
        (["** nothing"], "holds no entries"),
        (["1 2 3 4"], "line 1 has 4 numbers"),
    ],
)
def test_lines_that_are_none(tmp_path: Path, lines: list[str], problem: str) -> None:
    with pytest.raises(FiniteElementError, match=problem):
        read_matrix(written(tmp_path, "K.mtx", *lines))


@pytest.mark.skipif(find_spec("pyyeti") is None, reason="pyYeti is not installed")
def test_op4(tmp_path: Path) -> None:
    """Nastran OUTPUT4, as text and binary, with one matrix or several."""
    from pyyeti.nastran import op4

    for binary in (True, False):
        path = str(tmp_path / "model.op4")
        op4.write(path, {"kaa": MATRIX, "maa": np.eye(3)}, binary=binary)
        assert_allclose(read_matrix(path, name="KAA").toarray(), MATRIX)
        for name, problem in ((None, "holds kaa, maa: which is wanted"), ("mgg", "there is no 'mgg'")):
            with pytest.raises(FiniteElementError, match=problem):
                read_matrix(path, name=name)
    op4.write(str(tmp_path / "one.op4"), {"kaa": MATRIX})
    assert_allclose(read_matrix(tmp_path / "one.op4").toarray(), MATRIX)


def test_a_file_that_is_not_there(tmp_path: Path) -> None:
    for read in (read_matrix, read_dof_map):
        with pytest.raises(FiniteElementError, match="cannot be read: No such file"):
            read(tmp_path / "none.mtx")


# ---- meshes

SIZE = (200.0, 20.0, 10.0)  # mm
EDGES = {
    "hexahedron20": ((0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)),
    "tetra10": ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
}
CORNERS = np.array(
    [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)], dtype=float
)
SIX = ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6))  # a cube of tetrahedra


def bent(p: np.ndarray) -> np.ndarray:
    """A bar along x, or a part of a ring of mean radius 100 mm: x is the angle."""
    turn, radius = p[0] / SIZE[0], 100.0 + p[1]
    return np.array([radius * np.cos(turn), radius * np.sin(turn), p[2]])


def mesh_of(kind: str, cells: int = 4, ring: bool = False) -> tuple[np.ndarray, np.ndarray, dict[str, np.ndarray]]:
    """Points (n, 3) [mm], cells in the order of Abaqus and VTK, and sets of its two ends."""
    places: dict[tuple[float, ...], int] = {}
    rows = []

    def number(p: np.ndarray) -> int:
        return places.setdefault(tuple(np.round(p, 9)), len(places))

    for k in range(cells):
        cube = (CORNERS + [k, 0, 0]) / [cells, 1, 1] * SIZE
        blocks = [cube] if kind.startswith("hexa") else [cube[list(one)] for one in SIX]
        rows += [
            [number(p) for p in [*one, *((one[a] + one[b]) / 2 for a, b in EDGES.get(kind, ()))]] for one in blocks
        ]
    points = np.array(list(places))
    ends = {"ROOT": np.flatnonzero(points[:, 0] < 1e-6), "TIP": np.flatnonzero(points[:, 0] > SIZE[0] - 1e-6)}
    return np.array([bent(p) for p in points]) if ring else points, np.array(rows), ends


CHOICES: dict[str, Any] = {"material": STEEL, "units": "mm-t-s", "modes": 2, "mode_set": "mixed", "fixed": ["root"]}
SETS = {"root": "root", "tip": "TIP"}


@needs_meshio
@pytest.mark.parametrize("kind", ["hexahedron", "hexahedron20", "tetra", "tetra10"])
@pytest.mark.parametrize("suffix", ["inp", "vtu"])
def test_meshes(tmp_path: Path, kind: str, suffix: str) -> None:
    """Volume by mass, and the first frequency of a cantilever: 1.8751^2 / (2 pi L^2) sqrt(E I / rho A)."""
    import meshio

    points, cells, ends = mesh_of(kind, cells=8)
    sets = {"point_sets": ends} if suffix == "inp" else {}
    meshio.write(tmp_path / f"bar.{suffix}", meshio.Mesh(points, {kind: cells}, **sets))
    interface = (
        SETS if suffix == "inp" else {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > 0.2 - 1e-9}
    )
    body = FlexibleBody.from_file(tmp_path / f"bar.{suffix}", interface=interface, **CHOICES)
    assert body.integrals.mass == pytest.approx(7850 * 0.2 * 0.02 * 0.01, rel=1e-9)
    beam = 1.8751**2 / (2 * np.pi * 0.2**2) * 0.010 / 12**0.5 * (STEEL.E / STEEL.rho) ** 0.5
    assert body.frequencies[0] == pytest.approx(beam, rel=0.025)


@needs_meshio
@pytest.mark.parametrize("kind", ["hexahedron20", "tetra10"])
def test_curved_edges(tmp_path: Path, kind: str) -> None:
    """A part of a ring, one radian of four elements: its volume is that of the ring within 3e-4."""
    import meshio

    points, cells, ends = mesh_of(kind, ring=True)
    meshio.write(tmp_path / "ring.inp", meshio.Mesh(points, {kind: cells}, point_sets=ends))
    body = FlexibleBody.from_file(tmp_path / "ring.inp", interface=SETS, **CHOICES)
    area = (0.12**2 - 0.10**2) / 2
    assert body.integrals.mass == pytest.approx(7850 * area * 0.01, rel=3e-4)
    straight = np.sinc(0.25 / np.pi)  # of chords
    assert abs(straight - 1) > 1e-2


@needs_meshio
def test_surfaces_by_name(tmp_path: Path) -> None:
    """Gmsh: faces of physical groups name the interfaces and are no elements."""
    import meshio

    points, cells, _ = mesh_of("hexahedron")
    ends = [np.flatnonzero(np.abs(points[:, 0] - x) < 1e-6)[[0, 1, 3, 2]] for x in (0.0, SIZE[0])]
    mesh = meshio.Mesh(
        points,
        [("hexahedron", cells), ("quad", np.array(ends))],
        cell_data={
            "gmsh:physical": [np.full(len(cells), 1), np.array([2, 3])],
            "gmsh:geometrical": [np.ones(len(cells), int), np.array([2, 3])],
        },
        field_data={"body": np.array([1, 3]), "root": np.array([2, 2]), "tip": np.array([3, 2])},
    )
    meshio.write(tmp_path / "bar.msh", mesh, file_format="gmsh22", binary=False)
    body = FlexibleBody.from_file(tmp_path / "bar.msh", interface=SETS, **CHOICES)
    assert_allclose(body.interfaces["tip"].position, [0.2, 0.01, 0.005], atol=1e-12)
    assert_allclose(body.interfaces["root"].position, [0.0, 0.01, 0.005], atol=1e-12)


@needs_meshio
def test_decks_as_programs_write_them(tmp_path: Path) -> None:
    """Nodes in two blocks, one after the elements, with a set; GENERATE with two numbers and two rows; sets in sets."""
    points, cells, ends = mesh_of("hexahedron20")
    rows = [f"{k + 1}, {x!r}, {y!r}, {z!r}" for k, (x, y, z) in enumerate(points.tolist())]
    named = {name: (nodes + 1).tolist() for name, nodes in ends.items()}
    tip = named["TIP"]
    lines = ["*HEADING", "bar", "** nodes", "*Node, NSET=first", *rows[:30], "*Element, type=C3D20, elset=ALL"]
    for k, cell in enumerate((cells + 1).tolist()):
        lines += [f"{k + 1}, {', '.join(map(str, cell[:10]))},", ", ".join(map(str, cell[10:]))]
    lines += ["*NODE", *rows[30:], "*NSET, NSET=PART1, GENERATE", *(f"{n}, {n}" for n in tip[:3])]
    lines += ["*NSET, NSET=PART2", ", ".join(map(str, tip[3:])) + ",", "*NSET, NSET=TIP", "part1, PART2"]
    lines += ["*NSET, NSET=ROOT", *map(str, named["ROOT"]), "*STEP", "*NSET, NSET=TIP", "1"]
    deck = written(tmp_path, "deck.inp", *lines)
    body = FlexibleBody.from_file(deck, interface=SETS, **CHOICES)
    assert_allclose(body.interfaces["tip"].position, [0.2, 0.01, 0.005], atol=1e-9)
    assert_allclose(body.interfaces["root"].position, [0.0, 0.01, 0.005], atol=1e-9)
    for extra, problem in (
        (["*NSET, NSET=ODD", "nobody"], "deck.inp: the block of line .*'nobody' is neither a number nor a set"),
        (["*INCLUDE, INPUT=/etc/passwd"], "line .*INCLUDE.*insert the included file there"),
        (["*PART, NAME=second"], "a second PART"),
    ):
        with pytest.raises(FiniteElementError, match=problem):
            FlexibleBody.from_file(written(tmp_path, "deck.inp", *lines[:-3], *extra), interface=SETS, **CHOICES)
    empty = written(tmp_path, "deck.inp", *lines[:-3], "*NSET, NSET=NONE")
    with pytest.raises(FiniteElementError, match="set 'none' of deck.inp is empty"):
        FlexibleBody.from_file(empty, **{**CHOICES, "interface": {"root": "none"}})


@needs_meshio
def test_what_does_not_get_in_is_named(tmp_path: Path) -> None:
    import meshio

    points, cells, ends = mesh_of("hexahedron")
    path = tmp_path / "part.inp"

    def refused(problem: str, blocks: list[tuple[str, np.ndarray]], **choices: Any) -> None:
        meshio.write(path, meshio.Mesh(points, blocks, point_sets=ends))
        with pytest.raises(FiniteElementError, match=problem):
            FlexibleBody.from_file(path, **{"interface": SETS, **CHOICES, **choices})

    shell = cells[:2, :4]
    refused("no tetrahedra or hexahedra: 2 quad", [("hexahedron", cells), ("quad", shell)])
    refused("1 wedge", [("wedge", cells[:1, :6])])
    refused("has hexahedron and tetra elements", [("hexahedron", cells), ("tetra", cells[:1, :4])])
    refused("part.inp has no set 'pin'; it has 'ROOT', 'TIP'", [("hexahedron", cells)], interface={"root": "pin"})
    refused("material.*is (none|not a material)", [("hexahedron", cells)], material=7850.0)
    refused("units.*'inch' are not known", [("hexahedron", cells)], units="inch")
    with pytest.raises(FiniteElementError, match="there is no such file"):
        FlexibleBody.from_file(tmp_path / "none.inp", interface=SETS, **CHOICES)
    written(tmp_path, "odd.inp", "*HEADING", "*NODE", "1, 0, 0, 0", "*ELEMENT, TYPE=C3D99", "1, 1")
    with pytest.raises(FiniteElementError, match="meshio cannot read it.*C3D99.*line 4"):
        FlexibleBody.from_file(tmp_path / "odd.inp", interface=SETS, **CHOICES)


# ---- archives of Ansys

ANSYS = {"hexahedron": 185, "hexahedron20": 186, "tetra10": 187, "tetra": 285}


def archive(folder: Path, kind: str, number: int, drop: int = 0) -> Path:
    """As CDWRITE writes it: NBLOCK in fixed columns, EBLOCK with 11 numbers and 8 nodes a line, ranges by -last."""
    points, cells, ends = mesh_of(kind)
    lines = ["/COM,ANSYS RELEASE 19.2", "/PREP7", f"ET,        1,{number}",
             f"NBLOCK,6,SOLID,{len(points):9d},{len(points):9d}", "(3i9,6e21.13e3)"]  # fmt: skip
    for k, p in enumerate(points[: len(points) - drop], 1):
        values = "".join(re.sub(r"E([+-])(\d\d)$", r"E\g<1>0\2", f"{x:20.13E}") for x in p)
        lines.append(f"{k:9d}{0:9d}{0:9d}{values}")
    lines += ["N,R5.3,LOC,       -1,", f"EBLOCK,19,SOLID,{len(cells):10d},{len(cells):10d}", "(19i9)"]
    for e, cell in enumerate(cells, 1):
        words = [1, 1, 1, 1, 0, 0, 0, 0, len(cell), 0, e, *(cell + 1).tolist()]
        lines += ["".join(f"{word:9d}" for word in words[:19]), *["".join(f"{word:9d}" for word in words[19:])][:1]]
    lines.append("       -1")
    for name, nodes in ends.items():
        words = (nodes + 1).tolist()
        lines += [f"CMBLOCK,{name:8s},NODE,{len(words):8d}", "(8i10)"]
        lines += ["".join(f"{w:10d}" for w in words[k : k + 8]) for k in range(0, len(words), 8)]
    return written(folder, "part.cdb", *[line for line in lines if line], "FINISH")


@pytest.mark.parametrize("kind", ANSYS)
def test_archives_of_ansys(tmp_path: Path, kind: str) -> None:
    """The body of the same mesh in Abaqus's deck, which `test_meshes` holds against scikit-fem's."""
    pytest.importorskip("mapdl_archive")
    meshio = pytest.importorskip("meshio")
    points, cells, ends = mesh_of(kind)
    meshio.write(tmp_path / "part.inp", meshio.Mesh(points, [(kind, cells)], point_sets=ends))
    bodies = [FlexibleBody.from_file(path, interface=SETS, **CHOICES)
              for path in (archive(tmp_path, kind, ANSYS[kind]), tmp_path / "part.inp")]  # fmt: skip
    assert bodies[0].fields()["mass"] == pytest.approx(7850 * 0.2 * 0.02 * 0.01, rel=1e-9)
    assert bodies[0].frequencies == pytest.approx(bodies[1].frequencies, rel=1e-9)


def test_what_an_archive_of_ansys_lacks_is_named(tmp_path: Path) -> None:
    pytest.importorskip("mapdl_archive")

    def refused(problem: str) -> None:
        with pytest.raises(FiniteElementError, match=problem):
            FlexibleBody.from_file(tmp_path / "part.cdb", interface=SETS, **CHOICES)

    refused("there is no such file")
    archive(tmp_path, "hexahedron", 181)
    refused("no tetrahedra or hexahedra: 4 elements of type 181")
    archive(tmp_path, "hexahedron", 185, drop=1)
    refused("element 4 has the node 20, which its NBLOCK has not")
    written(tmp_path, "part.cdb", "/PREP7")
    refused("part.cdb: .*(CDWRITE|no nodes)")

"""Finite-element data from files: Matrix Market, plain rows, node tables, dof maps, Nastran OP4 and OP2."""

from __future__ import annotations

import struct
import sys
from importlib import import_module
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import scipy.io
import scipy.sparse as sp
from numpy.testing import assert_allclose

from symgen.fe import STEEL, FiniteElementError, FlexibleBody, LineMesh, Section
from symgen.fe.frame import frame_structure
from symgen.fe.structure import FEStructure

N = 8
MESH = LineMesh(
    [(0.1 * k, 0.0, 0.01 * k) for k in range(N)], [(k, k + 1) for k in range(N - 1)], Section.rectangle(0.02, 0.01)
)
IDS = np.array([10, 11, 12, 13, 14, 15, 16, 40])
ENDS = {"pin": [10], "slot": [40]}


def op4() -> ModuleType:
    """What writes such files; its import takes two seconds, in each process that collects tests."""
    return import_module("pyyeti.nastran.op4")


@pytest.fixture
def model() -> FEStructure:
    return frame_structure(MESH, STEEL)


@pytest.fixture
def expected() -> dict[str, Any]:
    return FlexibleBody.from_mesh(MESH, STEEL, interface={"pin": [0], "slot": [N - 1]}, modes=4).fields()


def same(found: FlexibleBody, expected: dict[str, Any]) -> None:
    fields = found.fields()
    for key in ("mass", "first_moment", "inertia_moments", "K_ff", "rho_phi", "phi_phi"):
        one, two = np.array(expected[key]), np.array(fields[key])
        assert_allclose(two, one, rtol=1e-7, atol=1e-8 * np.abs(one).max(), err_msg=key)
    assert_allclose(fields["markers"]["slot"]["shape"], expected["markers"]["slot"]["shape"], atol=1e-7)


def node_file(folder: Path, separator: str = " ") -> Path:
    path = folder / "nodes.txt"
    rows = [
        separator.join([str(name), *map(repr, map(float, place))]) for name, place in zip(IDS, MESH.nodes, strict=True)
    ]
    path.write_text("# id x y z\n" + "\n".join(rows) + "\n")
    return path


@pytest.mark.parametrize("symmetry", ["symmetric", "general"])
def test_matrix_market(tmp_path: Path, model: FEStructure, expected: dict[str, Any], symmetry: str) -> None:
    for name, matrix in (("K", model.K), ("M", model.M)):
        scipy.io.mmwrite(tmp_path / f"{name}.mtx", matrix, symmetry=symmetry, precision=17)
    same(
        FlexibleBody.from_matrices(
            tmp_path / "K.mtx", str(tmp_path / "M.mtx"), node_file(tmp_path, ","), dofs=6, interface=ENDS, modes=4
        ),
        expected,
    )


def test_rows_of_one_triangle_and_a_dof_file(tmp_path: Path, model: FEStructure, expected: dict[str, Any]) -> None:
    """As CalculiX writes: `row column value` of one triangle, `node.component`, here in another order of rows."""
    order = np.random.default_rng(2).permutation(model.n_dof)
    for name, matrix in (("job.sti", model.K), ("job.mas", model.M)):
        upper = sp.triu(matrix[order][:, order]).tocoo()
        rows = zip(upper.row + 1, upper.col + 1, upper.data, strict=True)
        (tmp_path / name).write_text(
            "".join(f"{i} {j} {value!r}\n" for i, j, value in ((int(i), int(j), float(value)) for i, j, value in rows))
        )
    (tmp_path / "job.dof").write_text("".join(f"{IDS[model.node[row]]}.{model.component[row] + 1}\n" for row in order))
    same(
        FlexibleBody.from_matrices(
            tmp_path / "job.sti",
            tmp_path / "job.mas",
            node_file(tmp_path),
            dofs=tmp_path / "job.dof",
            interface=ENDS,
            modes=4,
        ),
        expected,
    )


def test_arrays(model: FEStructure, expected: dict[str, Any]) -> None:
    table = np.column_stack([IDS, np.array(MESH.nodes)])
    dofs = np.column_stack([IDS[model.node], model.component + 1])
    same(FlexibleBody.from_matrices(model.K.toarray(), model.M, table, dofs=dofs, interface=ENDS, modes=4), expected)
    counted = FlexibleBody.from_matrices(
        model.K, model.M, MESH.nodes, dofs=6, modes=4, interface={"pin": [1], "slot": [N]}
    )  # without ids they count from 1
    same(counted, expected)


@pytest.mark.parametrize("choices", [{"binary": True}, {"binary": False, "digits": 17}])
def test_nastran_op4(tmp_path: Path, model: FEStructure, expected: dict[str, Any], choices: dict[str, Any]) -> None:
    path = str(tmp_path / "model.op4")
    op4().write(path, ["KGG", "MGG"], [model.K.toarray(), model.M.toarray()], **choices)
    grids = "".join(
        f"GRID,{name},,{place[0]!r},{place[1]!r},{place[2]!r}\n" for name, place in zip(IDS, MESH.nodes, strict=True)
    )
    (tmp_path / "model.bdf").write_text("BEGIN BULK\n" + grids + "ENDDATA\n")
    for nodes in (tmp_path / "model.bdf", node_file(tmp_path)):
        same(FlexibleBody.from_nastran(path, nodes, stiffness="kgg", mass="mgg", interface=ENDS, modes=4), expected)
    with pytest.raises(FiniteElementError, match=r"no matrix \['kaa', 'maa'\].*kgg"):
        FlexibleBody.from_nastran(path, node_file(tmp_path), interface=ENDS, modes=4)


def op2_text(matrices: dict[str, np.ndarray]) -> bytes:
    """An OUTPUT2 file without header: Fortran records between keys, each column as one string of doubles."""

    def record(content: bytes) -> bytes:
        return struct.pack("i", len(content)) + content + struct.pack("i", len(content))

    def keys(*values: int) -> bytes:
        return b"".join(record(struct.pack("i", value)) for value in values)

    content = b""
    for name, matrix in matrices.items():
        rows, columns = matrix.shape
        label = record(name.ljust(8).encode())
        trailer = record(struct.pack("7i", 101, columns, rows, 6, 2, 2 * rows, 10000))
        content += keys(2) + label + keys(-1, 7) + trailer + keys(-2, 1, 0, 2) + label + keys(-3, 1, 1)
        for k, column in enumerate(matrix.T):
            strings = record(struct.pack("i", 1) + np.ascontiguousarray(column).tobytes())
            content += keys(1 + 2 * rows) + strings + keys(-4 - k, 1, int(k + 1 < columns))
        content += keys(0)
    return content + keys(0)


def test_nastran_op2(tmp_path: Path, model: FEStructure, expected: dict[str, Any]) -> None:
    (tmp_path / "model.op2").write_bytes(op2_text({"KAA": model.K.toarray(), "MAA": model.M.toarray()}))
    same(FlexibleBody.from_nastran(tmp_path / "model.op2", node_file(tmp_path), interface=ENDS, modes=4), expected)


def test_nastran_files_that_cannot_be_read(tmp_path: Path) -> None:
    with pytest.raises(FiniteElementError, match="no file"):
        FlexibleBody.from_nastran(tmp_path / "none.op4", [(0, 0, 0)], interface={}, modes=1)
    (tmp_path / "bad.op2").write_bytes(b"not a file of Nastran's" * 4)
    with pytest.raises(FiniteElementError, match="cannot be read"):
        FlexibleBody.from_nastran(tmp_path / "bad.op2", [(0, 0, 0)], interface={}, modes=1)
    (tmp_path / "own.bdf").write_text("BEGIN BULK\nGRID,1,5,0.,0.,0.\nENDDATA\n")
    op4().write(str(tmp_path / "a.op4"), ["kaa", "maa"], [np.eye(6), np.eye(6)])
    with pytest.raises(FiniteElementError, match="coordinate system"):
        FlexibleBody.from_nastran(tmp_path / "a.op4", tmp_path / "own.bdf", interface={}, modes=1)


def test_missing_packages_are_named(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setitem(sys.modules, "pyyeti", None)
    with pytest.raises(FiniteElementError, match=r"symgen\[nastran\]"):
        FlexibleBody.from_nastran(tmp_path / "a.op4", [(0, 0, 0)], interface={}, modes=1)
    monkeypatch.setitem(sys.modules, "skfem", None)
    with pytest.raises(FiniteElementError, match=r"symgen\[fe\]"):
        FlexibleBody.from_mesh(object(), STEEL, interface={}, modes=1)

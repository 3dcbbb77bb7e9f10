"""Finite-element data from files: Matrix Market, plain rows, node tables, dof maps."""

from __future__ import annotations

import sys
from pathlib import Path
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


def test_missing_packages_are_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "skfem", None)
    with pytest.raises(FiniteElementError, match=r"symgen\[fe\]"):
        FlexibleBody.from_mesh(object(), STEEL, interface={}, modes=1)

"""Finite-element data of other programs: matrices, node tables, dof maps."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import scipy.io
import scipy.sparse
from numpy.testing import assert_allclose

from symgen.fe import STEEL, FiniteElementError, FlexibleBody, LineMesh, Section
from symgen.fe.frame import frame_structure
from symgen.fe.structure import FEStructure

GUIDE = Path(__file__).resolve().parents[2] / "docs" / "guide" / "finite-elements.md"
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


def test_matrix_market(tmp_path: Path, model: FEStructure, expected: dict[str, Any]) -> None:
    """Matrices by `scipy.io.mmread`, nodes and dofs by `numpy.loadtxt`, rows in another order."""
    order = np.random.default_rng(2).permutation(model.n_dof)
    for name, matrix in (("K", model.K), ("M", model.M)):
        scipy.io.mmwrite(tmp_path / f"{name}.mtx", matrix[order][:, order], symmetry="symmetric", precision=17)
    np.savetxt(tmp_path / "nodes.txt", np.column_stack([IDS, np.array(MESH.nodes)]), header="id x y z")
    np.savetxt(tmp_path / "dofs.txt", np.column_stack([IDS[model.node], model.component + 1])[order])
    K, M = (scipy.io.mmread(tmp_path / f"{name}.mtx") for name in "KM")
    nodes, dofs = (np.loadtxt(tmp_path / f"{name}.txt") for name in ("nodes", "dofs"))
    same(FlexibleBody.from_matrices(K, M, nodes, dofs=dofs, interface=ENDS, modes=4), expected)


@pytest.mark.parametrize("kept", ["both", "lower", "upper"])
def test_matrices_of_abaqus(kept: str, tmp_path: Path, model: FEStructure, expected: dict[str, Any]) -> None:
    """Rows without a head, which `mmread` refuses, by the lines that the guide shows; whole, or one triangle."""
    (block,) = [code for code in re.findall(r"```python\n(.*?)```", GUIDE.read_text(), re.DOTALL) if "abaqus" in code]
    page: dict[str, Any] = {"np": np}
    exec(block, page)
    read = []
    for name, matrix in (("STIF1", model.K), ("MASS1", model.M)):
        part = {"both": matrix, "lower": scipy.sparse.tril(matrix), "upper": scipy.sparse.triu(matrix)}[kept].tocoo()
        rows = [f"{i + 1} {j + 1}  {v:.15e}" for i, j, v in zip(part.row, part.col, part.data, strict=True)]
        (tmp_path / f"{name}.mtx").write_text("\n".join(rows) + "\n")
        with pytest.raises(ValueError, match="Matrix Market"):
            scipy.io.mmread(tmp_path / f"{name}.mtx")
        read.append(page["read_abaqus"](tmp_path / f"{name}.mtx"))
    table = np.column_stack([IDS, np.array(MESH.nodes)])
    same(FlexibleBody.from_matrices(*read, table, dofs=6, interface=ENDS, modes=4), expected)


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

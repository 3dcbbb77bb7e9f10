"""Matrices, node tables and dof maps from text files (Matrix Market, `id x y z`, `node component`).

Matrices and nodes from Nastran files (OP4, OP2, bulk data), read by pyYeti.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any, TypeAlias

import numpy as np
import scipy.io
import scipy.sparse as sp
from numpy.typing import ArrayLike

from symgen.fe.structure import AXES, RIGID_MOTIONS, FiniteElementError, Integers
from symgen.modes.cleaning import Array

MatrixSource: TypeAlias = sp.spmatrix | sp.sparray | ArrayLike | str | Path
TableSource: TypeAlias = ArrayLike | str | Path
COMMENTS = ("#", "%", "*", "$")


def read_matrix(item: str, source: MatrixSource) -> sp.csr_matrix:
    """A sparse matrix: given as one, as an array, or as the path of a file.

    The file is Matrix Market, or plain rows `i j value` counted from 1, where one triangle stands for both
    (CalculiX writes so). Raises FiniteElementError if it cannot be read.
    """
    if not isinstance(source, str | Path):
        return sp.csr_matrix(source)
    path = Path(source)
    try:
        with path.open(encoding="ascii", errors="replace") as file:
            has_header = file.readline().lower().startswith("%%matrixmarket")
        return sp.csr_matrix(scipy.io.mmread(path)) if has_header else _triplets(item, path)
    except (OSError, ValueError) as error:
        if isinstance(error, FiniteElementError):
            raise
        raise FiniteElementError(
            item,
            f"{path.name} cannot be read as a matrix ({error})",
            "give a Matrix Market file, or rows of 'row column value'",
        ) from error


def read_nodes(source: TableSource) -> tuple[Integers, Array]:
    """Ids (n,) and positions (n, 3) [m] of a node table: rows `x y z` (ids count from 1) or `id x y z`, or a path.

    Raises FiniteElementError if it cannot be read.
    """
    table = _table("nodes", source)
    if table.ndim != 2 or table.shape[1] not in (AXES, AXES + 1) or not len(table):
        raise FiniteElementError("nodes", f"the table has shape {table.shape}", "give rows of x y z or of id x y z")
    if table.shape[1] == AXES:
        return np.arange(1, len(table) + 1), table
    return _whole("nodes", table[:, 0]), table[:, 1:]


def read_dofs(source: int | TableSource, ids: Integers) -> tuple[Integers, Integers]:
    """Place of the node and component 0 ... 5 of each row of the matrices.

    `source` is 3 or 6 for so many per node, node by node; or rows `node component`, components counted from 1
    (4, 5, 6 are rotations); or the path of such a file, where `node.component` is understood too.
    Raises FiniteElementError for anything else and for nodes that are not in the table.
    """
    if isinstance(source, int):
        if source not in (AXES, RIGID_MOTIONS):
            raise FiniteElementError("dofs", f"{source} per node", "give 3, 6, or a dof map")
        return np.repeat(np.arange(len(ids)), source), np.tile(np.arange(source), len(ids))
    table = _table("dofs", source)
    if table.ndim == 2 and table.shape[1] == 1:  # node.component, as CalculiX writes
        node = np.floor(table[:, 0])
        table = np.stack([node, np.round(10.0 * (table[:, 0] - node))], axis=1)
    if table.ndim != 2 or table.shape[1] != 2:
        raise FiniteElementError("dofs", f"the dof map has shape {table.shape}", "give rows of node, component")
    node, component = _whole("dofs", table[:, 0]), _whole("dofs", table[:, 1])
    place = {int(name): k for k, name in enumerate(ids)}
    unknown = sorted({int(name) for name in node if int(name) not in place})
    if unknown or component.min(initial=1) < 1 or component.max(initial=1) > RIGID_MOTIONS:
        problem = f"nodes {unknown[:5]} are not in the node table" if unknown else "a component is not 1 ... 6"
        raise FiniteElementError("dofs", problem, "give the map that belongs to the matrices and to this node table")
    return np.array([place[int(name)] for name in node], dtype=np.int64), component - 1


def _triplets(item: str, path: Path) -> sp.csr_matrix:
    rows = _table(item, path)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise FiniteElementError(
            item,
            f"{path.name} is not Matrix Market and not rows of 'row column value'",
            "export the matrix in one of these forms",
        )
    i, j = _whole(item, rows[:, 0]) - 1, _whole(item, rows[:, 1]) - 1
    size = int(max(i.max(), j.max())) + 1
    if min(i.min(), j.min()) < 0:
        raise FiniteElementError(item, f"{path.name} counts rows from 0", "count from 1")
    matrix = sp.csr_matrix((rows[:, 2], (i, j)), shape=(size, size))
    if np.all(i <= j) or np.all(i >= j):
        matrix = matrix + matrix.T - sp.diags(matrix.diagonal())
    return sp.csr_matrix(matrix)


def _table(item: str, source: TableSource) -> Array:
    """Numbers in rows; separated by blanks or commas in a file, lines beginning with # % * $ left out."""
    if not isinstance(source, str | Path):
        try:
            return np.asarray(source, dtype=np.float64)
        except (TypeError, ValueError) as error:
            raise FiniteElementError(item, "not a table of numbers", "give an array or the path of a file") from error
    path = Path(source)
    try:
        lines = [line.replace(",", " ").split() for line in path.read_text(encoding="utf-8").splitlines()]
        numbers = [[float(word) for word in words] for words in lines if words and not words[0].startswith(COMMENTS)]
        return np.array(numbers, dtype=np.float64)
    except (OSError, ValueError) as error:
        raise FiniteElementError(
            item,
            f"{path.name} cannot be read as a table of numbers ({error})",
            "give rows of equal length, with blanks or commas between the numbers",
        ) from error


def _whole(item: str, values: Sequence[float] | Array) -> Integers:
    numbers = np.asarray(values, dtype=np.float64)
    if not np.all(np.isfinite(numbers)) or np.any(numbers != np.round(numbers)):
        raise FiniteElementError(item, "an id or a count is not a whole number", "check the columns of the table")
    return numbers.astype(np.int64)


BULK = (".bdf", ".dat", ".nas", ".blk")


def nastran_matrices(path: str | Path, stiffness: str, mass: str) -> tuple[sp.csr_matrix, sp.csr_matrix]:
    """The two named matrices of an OP4 or OP2 file (told by its suffix); names in any case.

    Raises FiniteElementError without pyYeti, for a file that cannot be read, and for missing names.
    """
    file = Path(path)
    nastran = _pyyeti()
    if not file.is_file():
        raise FiniteElementError("nastran", f"there is no file {file.name}", "check the path")
    try:
        if file.suffix.lower() == ".op2":
            with nastran.op2.OP2(str(file)) as open_file:
                found = open_file.rdop2mats(lower=True)
        else:
            found = nastran.op4.load(str(file), into="dct", justmatrix=True)
    except Exception as error:  # a damaged file ends in any of many ways there
        raise FiniteElementError(
            "nastran", f"{file.name} cannot be read ({error})", "write it with OUTPUT4 or OUTPUT2 in double precision"
        ) from error
    missing = [name for name in (stiffness, mass) if name.lower() not in found]
    if missing:
        raise FiniteElementError("nastran", f"{file.name} has no matrix {missing}", f"it has {sorted(found)}")
    return sp.csr_matrix(found[stiffness.lower()]), sp.csr_matrix(found[mass.lower()])


def nastran_nodes(path: str | Path) -> Array:
    """Rows `id x y z` of the GRID cards of a bulk data file.

    Raises FiniteElementError without cards, and for cards in other than the basic coordinate system.
    """
    file = Path(path)
    grids = _pyyeti().bulk.rdgrids(str(file)) if file.is_file() else None
    if grids is None:
        raise FiniteElementError("nodes", f"{file.name} has no GRID cards", "give the bulk data file of the model")
    if grids[:, [1, 5]].any():
        raise FiniteElementError(
            "nodes",
            "a GRID card has a coordinate system of its own",
            "give the node table in basic coordinates, as rows of id x y z",
        )
    found: Array = grids[:, [0, *range(2, 2 + AXES)]]
    return found


def _pyyeti() -> Any:
    try:
        from pyyeti import nastran
    except ImportError as error:
        raise FiniteElementError("pyyeti", "it is not installed", "pip install 'symgen[nastran]'") from error
    return nastran

"""Matrices of other programs: MatrixMarket, Abaqus, CalculiX, Ansys as text, and OP4 of Nastran by pyYeti."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import scipy.io
import scipy.sparse as sp
from numpy.typing import ArrayLike, NDArray

from symgen.fe.structure import FiniteElementError, Integers
from symgen.modes.cleaning import Array

COMPONENTS = {"UX": 1, "UY": 2, "UZ": 3, "ROTX": 4, "ROTY": 5, "ROTZ": 6}
COMMENTS = ("*", "%", "#", "!", "$")
FILE_ASYMMETRY = 1e-9


def read_matrix(path: str | Path, dofs: ArrayLike | None = None, name: str | None = None) -> sp.csr_matrix:
    """Read a stiffness or mass matrix that a finite-element program has written.

    Parameters
    ----------
    path : str or Path
        MatrixMarket (a banner `%%MatrixMarket`, as Ansys `*EXPORT,,MMF` writes); Abaqus `*MATRIX GENERATE` (`.mtx`), as
        `row, column, value` or as `node, dof, node, dof, value`; CalculiX (`.sti`, `.mas`): `row column value`;
        Nastran OUTPUT4 (`.op4`), by pyYeti (extra `files`).
    dofs : array_like, shape (n, 2), optional
        Rows `node, component` (1 ... 6) in the order of the matrix that is wanted, where the file names nodes; left
        out, as in `read_dof_map`. Stiffness and mass of one model need the same.
    name : str, optional
        Which matrix of an OP4 file, such as "kaa"; needed where it holds several.

    Returns
    -------
    scipy.sparse.csr_matrix, shape (n, n)
        In the units of the file. A file with one triangle gives both.

    Raises
    ------
    FiniteElementError
        With the line, for what is not a number, an entry outside or a node that `dofs` does not have.
    """
    file = Path(path)
    if file.suffix.lower() == ".op4":
        return _op4(file, name)
    text = _text(file)
    if text.startswith("%%MatrixMarket"):
        try:
            return sp.csr_matrix(scipy.io.mmread(file))
        except ValueError as error:
            raise FiniteElementError(
                str(file.name), f"is not a valid MatrixMarket file: {error}", "export it again"
            ) from error
    lines, entries = _numbers(file, text)
    if entries.shape[1] == 5:
        return _by_nodes(file, lines, entries, dofs)
    if entries.shape[1] != 3:
        problem = f"line {lines[0]} has {entries.shape[1]} numbers"
        remedy = "rows are `row column value`, or `node dof node dof value` (Abaqus FORMAT=MATRIX INPUT)"
        raise FiniteElementError(file.name, problem, remedy)
    places = _whole(file, lines, entries[:, :2]) - 1
    if places.min() < 0:
        line = lines[int(np.argmin(places.min(axis=1)))]
        raise FiniteElementError(file.name, f"line {line}: rows and columns count from 1", "export the matrix again")
    return _both_triangles(file, places, entries[:, 2], int(places.max()) + 1)


def read_dof_map(path: str | Path) -> Integers:
    """Read which row of a matrix is which motion of which node.

    Parameters
    ----------
    path : str or Path
        CalculiX `.dof` (rows `node.component`), Ansys `.mapping` (rows `equation node UX`), an Abaqus matrix as `node,
        dof, node, dof, value`, or rows `node component`.

    Returns
    -------
    ndarray of int, shape (n, 2)
        `node, component`, component 1 ... 6: `dofs` of `FlexibleBody.from_matrices`. Of an Abaqus matrix ascending.

    Raises
    ------
    FiniteElementError
        With the line, for what is none of these.
    """
    file = Path(path)
    rows: list[tuple[int, int]] = []
    equations: list[int] = []
    for number, line in _lines(_text(file)):
        words = line.replace(",", " ").split()
        if words[0].lower() in ("matrix", "equation", "eqn", "node"):
            continue  # the head of an Ansys mapping
        try:
            if len(words) == 5:
                rows += [(int(words[0]), int(words[1])), (int(words[2]), int(words[3]))]
            elif len(words) == 3:
                equations.append(int(words[0]))
                rows.append((int(words[1]), COMPONENTS[words[2].upper()]))
            elif len(words) == 2:
                rows.append((int(words[0]), int(words[1])))
            else:
                node, component = words[0].split(".")
                rows.append((int(node), int(component)))
        except (ValueError, KeyError) as error:
            problem = f"line {number}, {line[:40]!r}, is no node and component"
            raise FiniteElementError(file.name, problem, "rows are `node.component`, or `equation node UX`") from error
    found = np.array(rows, dtype=np.int64).reshape(-1, 2)
    if equations:
        return found[np.argsort(equations, kind="stable")]
    five = bool(rows) and len(next(_lines(_text(file)))[1].replace(",", " ").split()) == 5
    return np.unique(found, axis=0) if five else found


def _text(file: Path) -> str:
    try:
        return file.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        raise FiniteElementError(str(file), f"cannot be read: {error.strerror}", "check the path") from error


def _lines(text: str) -> Iterator[tuple[int, str]]:
    """Lines that are no comments and not empty, with their numbers."""
    for number, line in enumerate(text.splitlines(), 1):
        stripped = line.strip()
        if stripped and not stripped.startswith(COMMENTS):
            yield number, stripped


def _numbers(file: Path, text: str) -> tuple[list[int], Array]:
    """Numbers of the lines, and their entries (k, columns)."""
    lines, rows = [], []
    for number, line in _lines(text):
        words = line.replace(",", " ").replace("D+", "E+").replace("D-", "E-").split()
        try:
            rows.append([float(word) for word in words])
        except ValueError as error:
            problem = f"line {number}, {line[:40]!r}, is not numbers"
            remedy = "Abaqus: *MATRIX OUTPUT, FORMAT=COORDINATE; CalculiX: .sti, .mas; Ansys: *EXPORT,,MMF"
            raise FiniteElementError(file.name, problem, remedy) from error
        lines.append(number)
        if len(rows[-1]) != len(rows[0]):
            problem = f"line {number} has {len(rows[-1])} numbers, those before have {len(rows[0])}"
            raise FiniteElementError(file.name, problem, "the file is truncated or mixed: export it again")
    if not rows:
        raise FiniteElementError(file.name, "holds no entries", "export the matrix again")
    return lines, np.array(rows)


def _whole(file: Path, lines: list[int], values: Array) -> Integers:
    wrong = np.flatnonzero(np.any(values != np.round(values), axis=1))
    if wrong.size:
        raise FiniteElementError(
            file.name, f"line {lines[int(wrong[0])]}: a row is not a whole number", "export it again"
        )
    return values.astype(np.int64)


def _by_nodes(file: Path, lines: list[int], entries: Array, dofs: ArrayLike | None) -> sp.csr_matrix:
    named = _whole(file, lines, entries[:, :4]).reshape(-1, 2, 2)
    order = np.unique(named.reshape(-1, 2), axis=0) if dofs is None else np.asarray(dofs, dtype=np.int64)
    place = {(int(node), int(component)): k for k, (node, component) in enumerate(order)}
    places = np.array([[place.get((int(n), int(c)), -1) for n, c in pair] for pair in named])
    missing = np.flatnonzero(places.min(axis=1) < 0)
    if missing.size:
        pair = named[missing[0]][int(np.argmin(places[missing[0]]))]
        problem = f"line {lines[int(missing[0])]}: dof {pair[1]} of node {pair[0]} is not in the dof map"
        raise FiniteElementError(file.name, problem, "take read_dof_map of the stiffness for both matrices")
    return _both_triangles(file, places, entries[:, 4], len(order))


def _both_triangles(file: Path, places: Integers, values: Array, n: int) -> sp.csr_matrix:
    """The matrix (n, n), of one triangle mirrored."""
    rows, columns = places.T
    matrix = sp.csr_matrix((values, (rows, columns)), shape=(n, n))
    if not (np.all(rows <= columns) or np.all(rows >= columns)):
        return matrix
    return sp.csr_matrix(matrix + matrix.T - sp.diags(matrix.diagonal()))


def _op4(file: Path, name: str | None) -> sp.csr_matrix:
    try:
        from pyyeti.nastran import op4
    except ImportError as error:
        raise FiniteElementError("pyYeti", "it is not installed", "pip install 'symgen[files]'") from error
    try:
        found = op4.load(str(file), into="dct", justmatrix=True)
    except (OSError, ValueError, IndexError) as error:
        raise FiniteElementError(file.name, f"is not a valid OP4 file: {error}", "export it again") from error
    if name is None and len(found) != 1 or name is not None and name.lower() not in found:
        wanted = "which is wanted is not said" if name is None else f"there is no {name!r}"
        raise FiniteElementError(file.name, f"holds {', '.join(found)}: {wanted}", "give name=... of one of them")
    matrix: NDArray[np.float64] = found[name.lower() if name else next(iter(found))]
    return sp.csr_matrix(matrix)

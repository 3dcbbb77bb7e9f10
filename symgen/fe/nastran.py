"""Matrices and nodes from Nastran files (OP4, OP2, bulk data), read by pyYeti."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import scipy.sparse as sp

from symgen.fe.errors import FiniteElementError
from symgen.fe.structure import AXES
from symgen.modes.cleaning import Array

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

"""Loop closures as a sequence of small systems: a block-lower-triangular (BLT) order of loop rows (Eqs. 31-37).

A block holds the rows and unknowns that can only be solved together; it may use the unknowns of earlier blocks.
The order follows from where C_qd has entries at all, so it holds at every position.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, mul, sub
from symgen.algebra.small_systems import solve_small

Entries = Mapping[int, Row]  # constraint row -> its entries by column


@dataclass(frozen=True)
class LoopBlock:
    """Constraint rows and the columns of q that they determine together; as many rows as columns."""

    rows: list[int]
    columns: list[int]


@dataclass(frozen=True)
class ReducedRow:
    """A loop row of C_q, nu and gamma in the coordinates that are not structurally eliminated."""

    entries: Row
    nu: ca.SX
    gamma: ca.SX


@dataclass(frozen=True)
class Loops:
    """The blocks in their order of evaluation, and the reduced rows by constraint row."""

    blocks: list[LoopBlock]
    rows: dict[int, ReducedRow]

    def entries(self) -> dict[int, Row]:
        """Entries of the reduced rows by constraint row."""
        return {row: reduced.entries for row, reduced in self.rows.items()}


def order_blocks(rows: Sequence[int], columns: Sequence[int], entries: Entries) -> list[LoopBlock]:
    """The block-lower-triangular (BLT) order of a structurally regular square system, in the finest blocks.

    A matching gives each column its row; the strong components of who needs whom are the blocks.
    """
    if not rows:
        return []
    from scipy.sparse import csr_matrix  # where a mechanism has loops: the import takes a quarter of a second
    from scipy.sparse.csgraph import connected_components, maximum_bipartite_matching

    pattern = np.array([[column in entries[row] for column in columns] for row in rows])
    row_of = maximum_bipartite_matching(csr_matrix(pattern), perm_type="row")
    needs = pattern[row_of]  # line k: the row matched to column k, and the columns it needs
    count, label = connected_components(csr_matrix(needs), directed=True, connection="strong")
    members = [np.flatnonzero(label == k) for k in range(count)]
    waiting = sorted(range(count), key=lambda k: int(members[k][0]))
    done: set[int] = set()
    blocks = []
    while waiting:
        ready = next(k for k in waiting if set(label[needs[members[k]].any(axis=0)]) <= done | {k})
        waiting.remove(ready)
        done.add(ready)
        blocks.append(
            LoopBlock(sorted(rows[int(row_of[j])] for j in members[ready]), [columns[int(j)] for j in members[ready]])
        )
    return blocks


def _matrix(block: LoopBlock, entries: Entries) -> list[list[ca.SX]]:
    return [[entries[row].get(column, ZERO) for column in block.columns] for row in block.rows]


def solve_forward(
    blocks: list[LoopBlock], entries: Entries, sides: Sequence[Mapping[int, ca.SX]]
) -> tuple[list[Row], list[ca.SX]]:
    """(x of U x = side by column for each side, determinant of each block); sides by constraint row."""
    x: list[Row] = [{} for _ in sides]
    determinants = []
    for block in blocks:
        rests = [
            [_rest(side[row], entries[row], known) for row in block.rows] for side, known in zip(sides, x, strict=True)
        ]
        solved, determinant = solve_small(_matrix(block, entries), rests)
        for known, values in zip(x, solved, strict=True):
            known |= dict(zip(block.columns, values, strict=True))
        determinants.append(determinant)
    return x, determinants


def _rest(value: ca.SX, row: Row, known: Row) -> ca.SX:
    for column, solved in known.items():
        if column in row:
            value = sub(value, mul(row[column], solved))
    return value


def solve_transposed(blocks: list[LoopBlock], entries: Entries, side: Mapping[int, ca.SX]) -> dict[int, ca.SX]:
    """y of U^T y = side by constraint row, last block first; side by column."""
    y: dict[int, ca.SX] = {}
    for block in reversed(blocks):
        rest = []
        for column in block.columns:
            value = side[column]
            for row, known in y.items():
                if column in entries[row]:
                    value = sub(value, mul(entries[row][column], known))
            rest.append(value)
        transposed = [list(line) for line in zip(*_matrix(block, entries), strict=True)]
        solved, _ = solve_small(transposed, [rest])
        y |= dict(zip(block.rows, solved[0], strict=True))
    return y


def solve_block(block: LoopBlock, loops: Loops) -> tuple[dict[int, Row], list[ca.SX], list[ca.SX]]:
    """(e by loop unknown, c_velocity, c_acceleration) of x'' = sum e_j x_j'' + c for the unknowns of one block."""
    rows = [loops.rows[row] for row in block.rows]
    others = sorted({c for row in rows for c in row.entries if c not in block.columns})
    sides = [[-row.entries.get(column, ZERO) for row in rows] for column in others]
    sides += [[row.nu for row in rows], [row.gamma for row in rows]]
    solved, _ = solve_small(_matrix(block, loops.entries()), sides)
    e = {
        column: {
            other: solved[position][k] for position, other in enumerate(others) if not solved[position][k].is_zero()
        }
        for k, column in enumerate(block.columns)
    }
    return e, solved[-2], solved[-1]

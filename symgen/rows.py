"""Sparse rows: a dict from a column of q to an SX scalar. Absent means structurally zero."""

from __future__ import annotations

import casadi as ca

Row = dict[int, ca.SX]


def add_to(row: Row, column: int, value: ca.SX) -> None:
    """row[column] += value, dropping structural zeros."""
    if value.is_zero():
        return
    row[column] = row[column] + value if column in row else value


def add_scaled(target: Row, factor: ca.SX, source: Row) -> None:
    """target += factor * source."""
    for column, value in source.items():
        add_to(target, column, factor * value)


def scalars(column: ca.SX) -> list[ca.SX]:
    """Entries of an SX column as SX scalars."""
    return [column[row] + 0 for row in range(column.shape[0])]

"""Sparse rows: a dict from a column of q to an SX scalar. Absent means structurally zero."""

from __future__ import annotations

import casadi as ca

from symgen.algebra.scalar import add, mul

Row = dict[int, ca.SX]


def add_to(row: Row, column: int, value: ca.SX) -> None:
    """row[column] += value, dropping structural zeros."""
    if value.is_zero():
        return
    row[column] = add(row[column], value) if column in row else value


def add_scaled(target: Row, factor: ca.SX, source: Row) -> None:
    """target += factor * source."""
    for column, value in source.items():
        add_to(target, column, mul(factor, value))


def to_matrix(rows: list[Row], columns: list[int] | range) -> ca.SX:
    """SX matrix of sparse rows that have entries in these columns only."""
    matrix, place = ca.SX(len(rows), len(columns)), {column: k for k, column in enumerate(columns)}
    for k, row in enumerate(rows):
        for column, value in row.items():
            matrix[k, place[column]] = value
    return matrix


def nonzero(row: Row) -> Row:
    """The row without entries that are zero."""
    return {column: value for column, value in row.items() if not value.is_zero()}

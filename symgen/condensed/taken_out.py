"""Derivatives of forces in the coordinates that are left, as dependent ones are taken out one after another."""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ZERO, neg
from symgen.condensed.condensation import congruence
from symgen.condensed.row_changes import Variation


@dataclass
class TakenOut:
    """Rows of M (symmetric), K and D by column, in the coordinates that are left."""

    M: list[Row]
    K: dict[int, Row]
    D: dict[int, Row]

    def take_out(self, one: Variation) -> None:
        """A dependent coordinate: its columns, then its rows."""
        d = one.column
        for row, value in self.M[d].items():
            if row in self.K:
                add_scaled(self.K[row], neg(value), one.h)
                add_scaled(self.D[row], neg(value), one.k)
        for row, rates in self.D.items():
            value = rates.pop(d, ZERO)
            if not value.is_zero():
                add_scaled(self.K[row], value, one.g)
                add_scaled(rates, value, one.e)
        for places in self.K.values():
            value = places.pop(d, ZERO)
            if not value.is_zero():
                add_scaled(places, value, one.e)
        for rows in (self.K, self.D):
            own = rows.pop(d)
            for column, factor in one.e.items():
                if column in rows:
                    add_scaled(rows[column], factor, own)
        congruence(self.M, d, one.e)

    def matrix(self, rows: dict[int, Row], columns: list[int]) -> ca.SX:
        """Those of some columns."""
        place = {column: k for k, column in enumerate(columns)}
        found = ca.SX(len(columns), len(columns))
        for row, entries in rows.items():
            for column, value in entries.items():
                found[place[row], place[column]] = value
        return found

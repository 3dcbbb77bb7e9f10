"""Gauges: places of a finite-element body whose stress is known."""

from __future__ import annotations

from pydantic import Field

from symgen.schema.fields import Name, Number, StrictModel

Rows = tuple[tuple[Number, ...], ...]
COMPONENTS = ("xx", "yy", "zz", "yz", "xz", "xy")  # rows of all arrays


class StressGauge(StrictModel):
    """Stress at a place of a flexible body, in its axes, as FlexibleBody.fields(gauges=...) gives it.

    position [m]; shapes (6 x nf): xx yy zz yz xz xy [Pa] per unit of q_f; fields (6 x (9 + 9 nf)) and forces (6 x 6 for
    each interface, by its marker): per unit of each cause of runtime.contract.flexible, or left out.
    """

    position: tuple[Number, Number, Number] = (0.0, 0.0, 0.0)
    shapes: Rows
    fields: Rows = ()
    forces: dict[Name, Rows] = Field(default_factory=dict)

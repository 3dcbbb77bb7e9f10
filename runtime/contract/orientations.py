"""Orientations with velocities of their own: where they stand in q_i and q, and their charts.

The turns of such a body are a rotation vector theta from a chart, a unit quaternion, and their velocities are the
angular velocity omega in body axes; its Euler parameters e are dependent coordinates. Of a body in a closed loop some
or all turns may be loop unknowns: they stand in q_d, which then is not of coordinates alone. What the runtime calls
takes [c, charts] instead of c, so whatever evaluates a model has the charts as well. Outside time steps, which have one
chart a step, charts are 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

IDENTITY = (1.0, 0.0, 0.0, 0.0)


@dataclass(frozen=True)
class OrientationRecord:
    """An orientation with velocities of its own: names of its turns in q_i or q_d, of its Euler parameters in q_d."""

    body: str
    turns: list[str]
    parameters: list[str]


@dataclass(frozen=True)
class Places:
    """Where things stand: entries of q_i that are coordinates, their columns of q; the same of q_d.

    turns (k, 3): positions of each orientation in q_i followed by q_d; parameters (k, 4): columns of q of its Euler
    parameters. loops: positions in q_d of the loop unknowns.
    """

    plain: np.ndarray
    columns: np.ndarray
    dependent_plain: np.ndarray
    dependent: np.ndarray
    turns: np.ndarray
    parameters: np.ndarray
    loops: np.ndarray
    n_i: int

    @property
    def split(self) -> bool:
        """Is there an orientation of which some turns are independent and some not?"""
        return bool(len(self.turns)) and bool(((self.turns < self.n_i).sum(axis=1) % 3).any())

    @property
    def all_independent(self) -> bool:
        """Are all turns in q_i?"""
        return bool((self.turns < self.n_i).all())


def places_of(
    coordinates: list[str], q_i: list[str], q_d: list[str], loops: list[str], records: list[OrientationRecord]
) -> Places:
    """Of a model's names."""
    at = {name: column for column, name in enumerate(coordinates)}
    turning = {name for record in records for name in record.turns}
    plain, dependent = ([k for k, name in enumerate(names) if name not in turning] for names in (q_i, q_d))
    turns = [[[*q_i, *q_d].index(name) for name in record.turns] for record in records]
    parameters = [[at[name] for name in record.parameters] for record in records]

    def array(values: Any, *shape: int) -> np.ndarray:
        return np.array(values, dtype=int).reshape(*shape)

    return Places(
        array(plain, -1),
        array([at[q_i[k]] for k in plain], -1),
        array(dependent, -1),
        array([at[q_d[k]] for k in dependent], -1),
        array(turns, len(records), 3),
        array(parameters, len(records), 4),
        array([q_d.index(name) for name in loops], -1),
        len(q_i),
    )


def with_charts(kernel: ca.Function, count: int, c_size: int) -> ca.Function:
    """A kernel of the emitted code that takes charts, as one that takes [c, charts]; c_size: length of its c."""
    names = kernel.name_in()
    if kernel.name() == "constants":
        p = ca.SX.sym("p", kernel.size1_in(0)) if names else ca.SX(0, 1)
        found = ca.vertcat(kernel.call([p] if names else [])[0], ca.DM(IDENTITY * count))
        return ca.Function("constants", [p], [ca.densify(found)], ["p"], kernel.name_out())
    if "c" not in names and "chart" not in names:
        return kernel
    given = {name: ca.SX.sym(name, *kernel.size_in(name)) for name in names if name not in ("chart", "c")}
    both = ca.SX.sym("c", c_size + 4 * count)
    call: dict[str, Any] = dict(given)
    if "c" in names:
        call["c"] = both[:c_size]
    if "chart" in names:
        call["chart"] = both[c_size:]
    values = kernel.call(call)
    outputs = [ca.densify(values[name]) for name in kernel.name_out()]
    return ca.Function(kernel.name(), [*given.values(), both], outputs, [*given, "c"], kernel.name_out())

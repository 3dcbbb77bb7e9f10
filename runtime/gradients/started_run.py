"""Where a run begins, with its derivatives: z and the prepared constants from parameters and initial values.

x = (p, q_i, q_i_dot, loop unknowns) -> (z, constants): constants(p), the start of the scheme (68)-(71), and what is
prepared for the run.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.tape import shared
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.run_checks import RunChecks


@dataclass(frozen=True)
class StartedRun:
    """A run at its start: z, the prepared constants, x (n_x,), slopes of x by the values (n_x, n), the values (n,).

    state: all coordinates and rates (n,).
    """

    z: np.ndarray
    ready: np.ndarray
    x: np.ndarray
    slopes: np.ndarray
    values: np.ndarray
    checks: RunChecks
    state: tuple[np.ndarray, np.ndarray]


class Beginning:
    """The derivative of the beginning of a run by x (n_x,), for what is active in the program.

    place: the time t0 and the steps of the groups, [t0, h_1, ...] [s].
    """

    def __init__(self, program: ObservedProgram) -> None:
        scheme, model, active = program.scheme, program.scheme.model, program.active
        n = len(model.q_i)
        sizes = (len(model.parameters), n, n, len(model.loop_unknowns))
        self.ends = np.cumsum(sizes)
        x = ca.SX.sym("x", sum(sizes))
        p, q_i, q_i_dot, loop = ca.vertsplit(x, [0, *map(int, self.ends)])
        place = ca.SX.sym("place", 1 + len(scheme.grid.h))
        constants = ca.vertcat(model.kernel("constants")(p), place[1:])
        z = scheme.starter(place[0], q_i, q_i_dot, loop, constants)
        rows = [k for k in active.z if k < scheme.layout.size]
        self._rows = [n for n, k in enumerate(active.z) if k < scheme.layout.size]
        self._rows += [len(active.z) + n for n in range(len(active.c))]
        self._size = active.size
        found = ca.densify(ca.vertcat(z[rows], program.prepared.constants(constants)[list(active.c)]))
        along, back = ca.SX.sym("along", x.numel()), ca.SX.sym("back", found.numel())
        pushed = ca.densify(ca.jtimes(found, x, along))
        pulled = ca.densify(ca.jtimes(found, x, back, True))
        self._tangent = ca.Function("beginning_tangent", [x, place, along], shared([pushed]))
        self._adjoint = ca.Function("beginning_adjoint", [x, place, back], shared([pulled]))

    def tangents(self, place: Sequence[float], x: np.ndarray, slopes: np.ndarray) -> np.ndarray:
        """(active entries of z and constants, k) along dx = slopes (n_x, k)."""
        found = np.zeros((self._size, slopes.shape[1]))
        for k in range(slopes.shape[1]):
            found[self._rows, k] = np.asarray(self._tangent(x, place, slopes[:, k])).ravel()
        return found

    def pulled_back(self, place: Sequence[float], x: np.ndarray, adjoint: np.ndarray) -> np.ndarray:
        """(n_x,) from the adjoint of the active entries of z and constants."""
        return np.asarray(self._adjoint(x, place, adjoint[self._rows])).ravel()

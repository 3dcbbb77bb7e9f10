"""Dormand and Prince's steps of order 8 on any CasADi function (q, q') -> q'', compiled into one loop as ours are."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from benchmarks.contenders.by_c_compiler import CompiledProgram
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import Fields, Layout, make_stage
from runtime.schemes.runge_kutta import DormandPrince8


class ExplicitStepper:
    """Steps of z = (q, q'); accelerations: (q, q', c) -> q''."""

    def __init__(self, n: int, c: np.ndarray, accelerations: Callable[[ca.SX, ca.SX, ca.SX], ca.SX]) -> None:
        A, b, _ = DormandPrince8.tableau()

        def body(z: Fields, constants: ca.SX) -> dict[str, ca.SX]:
            h, given = constants[0], constants[1:]
            rates: list[tuple[ca.SX, ca.SX]] = []
            for row in (*A, b):
                q, v = z["q"], z["v"]
                for weight, (rate, acceleration) in zip(row, rates, strict=False):
                    if weight:
                        q, v = q + h * float(weight) * rate, v + h * float(weight) * acceleration
                if len(rates) == len(b):
                    break
                rates.append((v, accelerations(q, v, given)))
            return {"q": q, "v": v}

        layout = Layout({"q": n, "v": n})
        self.prepared: Prepared = prepare(make_stage("dop853", layout, 1 + len(c), body), 2 * n, 1 + len(c))
        self.n, self._c, self._program = n, c, CompiledProgram(self.prepared.program)

    def runner(self, q: np.ndarray, v: np.ndarray, t_end: float, steps: int) -> Callable[[], np.ndarray]:
        """What makes a whole run from (q, q') and gives q at its end."""
        ready = self.prepared.ready(np.concatenate([[t_end / steps], self._c]))
        z = self.prepared.widened(np.concatenate([q, v]))
        start = z.copy()

        def run() -> np.ndarray:
            z[:] = start
            self._program.run(z, ready, steps)
            return z[: self.n]

        return run

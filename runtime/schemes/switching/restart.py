"""A restart: the state of a scheme that remembers earlier steps as the start of further ones, behind a stop.

Positions and rates go on; what is remembered is that of a start (Eqs. 68-71) with the forces behind the stop.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.engine.choose import choose_engine
from runtime.engine.program import Call, Fields, Layout, make_stage
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.started_anew import started_anew


def remembers(scheme: Scheme) -> bool:
    """Does a scheme act, or steer its iterations, through more than positions and rates?"""
    return set(scheme.memory) != {"x", "v", "loop"} or scheme.starts_from_last


def with_steps(scheme: Scheme, state: ca.SX, c: ca.SX, dt: ca.SX) -> ca.SX:
    """c (c_size,) as stages read it with major steps dt [s], and the inputs that a state (n_z,) holds."""
    end = scheme.model.c_size
    return scheme.constants_at(scheme.layout.unpack(state), ca.vertcat(c[:end], c[end:] * (dt / c[end])))


def restarted(scheme: Scheme, state: ca.SX, c: ca.SX, dt_before: ca.SX, dt: ca.SX, clock: ca.SX) -> ca.SX:
    """(n_z,) a state shown by steps dt_before as the start of steps dt at a clock [s]; where nothing is remembered it
    goes on as it is.
    """
    found, own = ca.SX(state), scheme.layout.slice
    if remembers(scheme):
        before, after = (with_steps(scheme, state, c, one) for one in (dt_before, dt))
        found = started_anew(scheme, state, clock, before, after)
    found[own("t0")], found[own("n")] = clock, 0.0
    return ca.densify(found)


class Restart:
    """The same of one state as native code, to the last bit as in a run."""

    def __init__(self, scheme: Scheme, engine: str = "auto") -> None:
        self.scheme = scheme
        self._layout = Layout({"state": scheme.layout.size, "dt_before": 1, "dt": 1, "clock": 1})
        call: Call = make_stage("restart", self._layout, scheme.c_size, self._body)
        self._engine = choose_engine(engine, call, self._layout.size, scheme.c_size)

    def __call__(self, state: np.ndarray, c: np.ndarray, dt_before: float, dt: float, clock: float) -> np.ndarray:
        """(n_z,) of a state (n_z,) and the model's constants (c_size,)."""
        z = np.concatenate([state, [dt_before, dt, clock]])
        self._engine.run(z, self.scheme.constants(c), 1)
        return z[: len(state)]

    def _body(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        return {"state": restarted(self.scheme, z["state"], c, z["dt_before"], z["dt"], z["clock"])}

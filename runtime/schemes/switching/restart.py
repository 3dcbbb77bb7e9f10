"""A restart: the state of a scheme as the start of further steps, behind a stop or where inputs change.

Positions go on, rates by what an impulse adds to them. What a scheme remembers of earlier steps is that of a start
(Eqs. 68-71) with the forces from there on. Central differences, for one, go on by h a, where a is of the time between
two steps: with what acts from there on alone a change of a by da would be felt half a step too early, an error of
h da / 2 in the velocities.
"""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.coordinates import charts_in, joined
from runtime.engine.choose import choose_engine
from runtime.engine.program import Call, Fields, Layout, make_stage
from runtime.schemes.scheme import Lasting, Scheme


def with_steps(scheme: Scheme, state: ca.SX, c: ca.SX, dt: ca.SX) -> ca.SX:
    """c (c_size,) as stages read it with major steps dt [s], and the inputs that a state (n_z,) holds."""
    end = scheme.model.c_size
    return scheme.constants_at(scheme.layout.unpack(state), ca.vertcat(c[:end], c[end:] * (dt / c[end])))


def restarted(
    scheme: Scheme,
    state: ca.SX,
    c: ca.SX,
    dt_before: ca.SX,
    dt: ca.SX,
    clock: ca.SX,
    push: ca.SX | None = None,
    inputs: ca.SX | None = None,
    shift: ca.SX | float = 0,
) -> ca.SX:
    """(n_z,) a state shown by steps dt_before as the start of steps dt at a clock [s]; where nothing is remembered it
    goes on as it is. push (n_i,): what an impulse adds to the rates; inputs (n_w,): from there on; shift (n_i,): what
    is added to positions, whose value is zero where its derivative is not.
    """
    found, own, end = ca.SX(state), scheme.layout.slice, scheme.model.c_size
    if scheme.remembers:
        before, after = (with_steps(scheme, state, c, one) for one in (dt_before, dt))
        if inputs is not None:
            after = ca.vertcat(after[: end - inputs.numel()], inputs, after[end:])
        found = started_anew(scheme, state, clock, before, after, 0.0 if push is None else push, shift)
    else:
        if push is not None:
            found[own("v")], found[own("x")] = found[own("v")] + push, found[own("x")] + shift
        if inputs is not None:
            found[own("inputs")] = inputs
    found[own("t0")], found[own("n")] = clock, 0.0
    return ca.densify(found)


def started_anew(
    scheme: Scheme,
    z: ca.SX,
    t: ca.SX,
    before: ca.SX,
    after: ca.SX,
    push: ca.SX | float = 0.0,
    shift: ca.SX | float = 0.0,
) -> ca.SX:
    """(n_z,) a start at t [s] with the positions and rates that z (n_z,) shows, and its accounts.

    before, after (c_size,): constants as the stages read them, with inputs: z is shown by those before, steps go on
    with those after. push (n_i,): what is added to the rates [1/s].
    """
    seen, fields, model = scheme.observer(z=z, c=before), scheme.layout.unpack(z), scheme.model
    q_i, q_d = seen["q_i"], seen["q_d"]
    if scheme.charts.size:  # turns count from where their bodies are
        q = joined(model, q_i, q_d)
        (q_i, q_d), charts = scheme.charts.seen_in(model, q), charts_in(model)
        parameters = q[model.places.parameters.ravel().tolist()]
        after = ca.vertcat(after[: charts.start], parameters, after[charts.stop :])
    found = ca.SX(scheme.starter(t, q_i + shift, seen["q_i_dot"] + push, loop_guess(scheme, q_d), after))
    for name in scheme.lasting(Lasting.ACCOUNT):
        found[scheme.layout.slice(name)] = fields[name]
    return found


def loop_guess(scheme: Scheme, q_d: ca.SX) -> ca.SX:
    """(n_loop,) the loop unknowns among the dependent coordinates."""
    loop = [q_d[scheme.model.q_d.index(name)] for name in scheme.model.loop_unknowns]
    return ca.vertcat(*loop) if loop else ca.SX(0, 1)


class Restart:
    """The same of one state as native code, to the last bit as in a run."""

    def __init__(self, scheme: Scheme, engine: str = "auto") -> None:
        self.scheme = scheme
        n_w = scheme.model.signals.size
        sizes = {"state": scheme.layout.size, "dt_before": 1, "dt": 1, "clock": 1, "push": len(scheme.model.q_i)}
        self._layout = Layout({**sizes, "inputs": n_w})
        call: Call = make_stage("restart", self._layout, scheme.c_size, self._body)
        self._engine = choose_engine(engine, call, self._layout.size, scheme.c_size)

    def __call__(
        self,
        state: np.ndarray,
        c: np.ndarray,
        dt_before: float,
        dt: float,
        clock: float,
        push: np.ndarray | float = 0.0,
        inputs: np.ndarray | None = None,
    ) -> np.ndarray:
        """(n_z,) of a state (n_z,) and constants as stages read them; inputs (n_w,): None for those it holds."""
        z, own = np.zeros(self._layout.size), self._layout.slice
        z[: own("push").start] = *state, dt_before, dt, clock
        z[own("push")] = push
        if self._layout.sizes["inputs"]:
            z[own("inputs")] = state[self.scheme.layout.slice("inputs")] if inputs is None else inputs
        self._engine.run(z, c, 1)
        return z[own("state")]

    def _body(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        inputs = z["inputs"] if z["inputs"].numel() else None
        return {"state": restarted(self.scheme, z["state"], c, z["dt_before"], z["dt"], z["clock"], z["push"], inputs)}

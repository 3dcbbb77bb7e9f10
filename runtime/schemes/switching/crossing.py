"""What is done between the parts of a broken step, as a program: starts anew behind a jump, and a look for events.

Its z holds a state of the scheme and numbers beside it; which of its stages are applied is among them. So one program
serves all steps, and a list of calls (call_list.py) can cross jumps without Python.
"""

from __future__ import annotations

from collections.abc import Callable
from threading import Lock
from weakref import WeakKeyDictionary

import casadi as ca
import numpy as np

from runtime.engine.choose import choose_engine
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import Fields, Layout, Sequence, Until, make_stage
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.started_anew import started_anew
from runtime.schemes.switching.watched import NEVER, flagged, values_at, watches

ACTS = ("restart", "look")  # in this order
_LOCK = Lock()
_KEPT: WeakKeyDictionary[Prepared, ListedCrossing] = WeakKeyDictionary()  # by programs, shared by steppers


class ListedCrossing:
    """Of a scheme. Fields of its z: state, the scheme's z; dt, dt_before, clock [s], and what the stages speak of.

    restart: the state, shown by steps dt_before, as the start of steps dt at the clock. look: events
    are looked for from the state on; `flagged` is the first step in which one was seen before.
    """

    def __init__(self, scheme: Scheme, engine: str = "auto", wait: bool = False) -> None:
        self.scheme = scheme
        sizes = {"state": scheme.layout.size, "dt": 1, "dt_before": 1, "clock": 1}
        sizes |= {"flagged": 1, **dict.fromkeys(ACTS, 1)}
        self.layout = Layout(sizes)
        bodies: dict[str, Callable[[Fields, ca.SX], dict[str, ca.SX]]] = {}
        if remembers(scheme):
            bodies["restart"] = self._restart
        if watches(scheme):
            bodies["look"] = self._look
        parts = [
            Until(make_stage(name, self.layout, scheme.c_size, body), self.layout.slice(name).start, 1, usual=1)
            for name, body in bodies.items()
        ]
        self.prepared = prepare(Sequence(tuple(parts)), self.layout.size, scheme.c_size)
        self.n_c = int(self.prepared.constants.size1_out(0))  # numbers that it reads
        self.engine = choose_engine(
            engine, self.prepared.program, self.prepared.z_size, self.n_c, wait, self.prepared.tapes
        )

    def restarted(self, state: np.ndarray, c: np.ndarray, dt_before: float, dt: float, clock: float) -> np.ndarray:
        """`restart` of a state (n_z,) alone; c (c_size,): the model's constants."""
        z = np.zeros(self.prepared.z_size)
        z[self.layout.slice("state")] = state
        for name, value in {"dt_before": dt_before, "dt": dt, "clock": clock, ACTS[0]: 1.0}.items():
            z[self.layout.slice(name)] = value
        self.engine.run(z, self.prepared.ready(self.scheme.constants(c)), 1)
        return z[self.layout.slice("state")]

    def _constants(self, z: Fields, c: ca.SX, dt: ca.SX) -> ca.SX:
        """c as the stages of the scheme read it with steps dt, and the inputs that the state holds."""
        end, fields = self.scheme.model.c_size, self.scheme.layout.unpack(z["state"])
        return self.scheme.constants_at(fields, ca.vertcat(c[:end], c[end:] * (dt / c[end])))

    def _restart(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        before, after = (self._constants(z, c, z[name]) for name in ("dt_before", "dt"))
        found, own = started_anew(self.scheme, z["state"], z["clock"], before, after), self.scheme.layout.slice
        found[own("t0")], found[own("n")] = z["clock"], 0.0
        return {"state": found}

    def _look(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        fields = self.scheme.layout.unpack(z["state"])
        equations = self.scheme.equations(self._constants(z, c, z["dt"]), fields)
        seen = values_at(self.scheme, z["state"], equations)
        new = {"event_values": seen["events"], "event_change": ca.SX.ones(seen["events"].numel()) * NEVER}
        by_jump = flagged(self.scheme, fields, fields["event_values"], seen["events"], seen["t"])
        sooner = ca.logic_or(fields["event_step"] < NEVER, by_jump)
        new["event_step"] = ca.if_else(sooner, ca.fmin(z["flagged"], fields["n"]), z["flagged"])
        return {"state": self.scheme.layout.pack({**fields, **new, "event_slopes": seen["slopes"]})}


def remembers(scheme: Scheme) -> bool:
    """Does a scheme act, or steer its iterations, through more than positions and rates?"""
    return set(scheme.memory) != {"x", "v", "loop"} or scheme.starts_from_last


def needs_crossing(scheme: Scheme) -> bool:
    """Is there something to do between two parts of a step?"""
    return remembers(scheme) or watches(scheme)


def crossing(stepper: Stepper) -> ListedCrossing:
    """Made once for a stepper and those of the same programs with other steps, which are data."""
    with _LOCK:
        if stepper.prepared not in _KEPT:
            _KEPT[stepper.prepared] = ListedCrossing(stepper.scheme, stepper.requested, stepper.waits)
        return _KEPT[stepper.prepared]

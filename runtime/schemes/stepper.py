"""A scheme prepared and compiled once, ready to be run with any constants and step size."""

from __future__ import annotations

from copy import copy
from functools import cached_property
from threading import Lock
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.coordinates import charts_in, independent, loop_part
from runtime.engine.kept_programs import are_short, read_prepared, write_prepared
from runtime.engine.native import choose_engine
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import operations_per_step
from runtime.schemes.scheme import Scheme, direct
from runtime.schemes.switching.watched import with_events


def start_vector(
    scheme: Scheme, t: float, q: np.ndarray, q_dot: np.ndarray, c: np.ndarray, dt: float | None = None
) -> np.ndarray:
    """The scheme's own z at a consistent state of all coordinates (Eqs. 68-71); dt: another step than its grid's."""
    model = scheme.model
    if not model.places.all_independent:
        return direct(scheme, "start_there", lambda: start_there(scheme))(t, q, q_dot, scheme.constants(c, dt))
    start = direct(scheme, "starter", scheme.start)
    return start(t, *independent(model, q, q_dot), loop_part(model, q), scheme.constants(c, dt))


def start_there(scheme: Scheme) -> ca.Function:
    """(t0, q, q_dot, c) -> z at a consistent state: turns that follow from loops count from where their bodies are."""
    model, charts = scheme.model, charts_in(scheme.model)
    t0, c = ca.SX.sym("t0"), ca.SX.sym("c", scheme.c_size)
    q, q_dot = (ca.SX.sym(name, len(model.coordinates)) for name in ("q", "q_dot"))
    (q_i, q_d), rates = scheme.charts.in_charts(model, q), scheme.charts.in_charts(model, q, q_dot)[0]
    there = ca.vertcat(c[: charts.start], q[model.places.parameters.ravel().tolist()], c[charts.stop :])
    loop = ca.vertcat(*(q_d[int(k)] for k in model.places.loops))
    return ca.Function("start_there", [t0, q, q_dot, c], [scheme.starter(t0, q_i, rates, loop, there)])


def prepared_step(scheme: Scheme) -> Prepared:
    """The program of a major step, from the disk where one of a like scheme on this very model was kept."""
    key = scheme.key("step")
    found = read_prepared(key) if key else None
    if found is None:
        found = prepare(with_events(scheme, scheme.program()), scheme.layout.size, scheme.c_size)
        if key and are_short([*found.program.stages(), found.constants]):
            write_prepared(key, found)
    return found


class Stepper:
    """Runs major steps of a scheme on vectors z; c are the model's constants, dt the major step [s].

    z is longer than the scheme's own (`state` shows that part): a program keeps values of its own behind it. wait: for
    the best code, as who measures time does.
    """

    def __init__(self, scheme: Scheme, engine: str = "auto", wait: bool = False) -> None:
        self.scheme, self.requested, self.waits = scheme, engine, wait
        self.prepared = prepared_step(scheme)
        self.program, c_size = self.prepared.program, int(self.prepared.constants.size1_out(0))
        self.engine = choose_engine(engine, self.program, self.prepared.z_size, c_size, wait)
        self.across: dict[Any, Any] = {}  # programs that are made of the step's, of steppers with other steps, too

    @cached_property
    def operations(self) -> int:
        """Of a major step."""
        return operations_per_step(self.program)

    def ready(self, c: np.ndarray, dt: float) -> np.ndarray:
        """What the program reads, for constants and a step."""
        return self.prepared.ready(self.scheme.constants(c, dt))

    def start(self, t: float, q: np.ndarray, q_dot: np.ndarray, c: np.ndarray, dt: float) -> np.ndarray:
        """z at a consistent state of all coordinates (Eqs. 68-71)."""
        return self.prepared.widened(start_vector(self.scheme, t, q, q_dot, c, dt))

    def state(self, z: np.ndarray) -> np.ndarray:
        """The scheme's part of z, as a view."""
        return z[: self.scheme.layout.size]

    def run(self, z: np.ndarray, ready: np.ndarray, steps: int) -> None:
        """Advance z by so many major steps, in place."""
        self.engine.run(z, ready, steps)

    def finish(self) -> None:
        """Change to the best code now, as who measures time does."""
        tiers = getattr(self.engine, "tiers", None)  # of native code only
        if tiers is not None:
            tiers.finish()


# Steppers that a model keeps: who runs it again need not prepare its steps again.

MOST_KEPT_OPERATIONS = 3_000_000  # of a step, of all that a model keeps: some 100 bytes each stay in memory
_LOCK = Lock()  # of what models keep: threads may run one model at once


def kept_stepper(scheme: Scheme, engine: str = "auto", wait: bool = False) -> Stepper:
    """A stepper with what was prepared and compiled for a like scheme on the same model before, else a new one.

    Steps are data of a program. The oldest goes first.
    """
    known: dict[tuple[Any, ...], Stepper] = scheme.model.steppers
    key = (*scheme.alike, engine, wait)
    with _LOCK:
        kept = known.pop(key, None)
        if kept is not None:
            known[key] = kept  # the youngest now
            found = copy(kept)
            found.scheme = scheme
            return found
    stepper = Stepper(scheme, engine, wait)
    if stepper.operations <= MOST_KEPT_OPERATIONS:
        with _LOCK:
            known[key] = stepper
            while sum(one.operations for one in known.values()) > MOST_KEPT_OPERATIONS:
                del known[next(iter(known))]
    return stepper

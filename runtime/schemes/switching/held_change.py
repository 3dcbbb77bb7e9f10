"""Inputs that change between two steps: schemes that remember earlier steps are started anew, forces jump there.

Central differences go on by h a, where a is of the time between two steps: with what acts from there on alone, a change
of a by da would be felt half a step too early, an error of h da / 2 in the velocities. Positions and rates are those
that the state shows with the inputs until then.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np

from runtime.engine.choose import choose_engine
from runtime.engine.prepare import prepare
from runtime.engine.program import Call
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.legs import Leg, Legs
from runtime.schemes.switching.started_anew import started_anew


class HeldChange:
    """Of a stepper with major steps dt [s], as native code where no chart moves. c (c_size,): the model's constants."""

    def __init__(self, stepper: Stepper, dt: float) -> None:
        self._scheme, self._dt, self._legs = stepper.scheme, dt, Legs(stepper)
        self._own = stepper.scheme.layout.slice("inputs")
        self._size = stepper.scheme.layout.size
        self._native = not stepper.scheme.charts.size
        self._go: Callable[[int], None] | None = None
        if self._native:
            z_size = self._size + stepper.scheme.model.signals.size
            self._prepared = prepare(Call(started_with_inputs(stepper.scheme)), z_size, stepper.scheme.c_size)
            c_size = int(self._prepared.constants.size1_out(0))
            self._engine = choose_engine(stepper.requested, self._prepared.program, self._prepared.z_size, c_size)
            self._z = np.zeros(self._prepared.z_size)
            self._state, self._w = self._z[: self._size], self._z[self._size : z_size]

    def forget(self) -> None:
        """The constants have changed."""
        self._go = None

    def make(self, z: np.ndarray, w: np.ndarray, c: np.ndarray) -> None:
        """Give z (n_z,) the numbers w (n_w,) of the inputs, in place."""
        if not self._native:
            self._by_legs(z, w, c)
            return
        if self._go is None:
            self._ready = self._prepared.ready(self._scheme.constants(c, self._dt))  # code that is bound reads it
            self._go = self._engine.bound(self._z, self._ready)
        own = z[: self._size]
        self._state[:], self._w[:] = own, w
        self._go(1)
        own[:] = self._state

    def _by_legs(self, z: np.ndarray, w: np.ndarray, c: np.ndarray) -> None:
        legs, clock = self._legs, z[:2].copy()
        seen = legs.seen(z, legs.constants(legs.with_inputs(z, c), self._dt))
        changed = z.copy()
        changed[self._own] = w
        leg = Leg(changed, self._dt, seen)
        z[:] = legs.set_out(leg, legs.with_inputs(changed, c), float(clock[0] + clock[1] * self._dt), self._dt)
        z[:2] = clock


def started_with_inputs(scheme: Scheme) -> ca.Function:
    """([z, w], c) -> [z, w] with the inputs w."""
    model, size, n_w = scheme.model, scheme.layout.size, scheme.model.signals.size
    both, c = ca.SX.sym("z", size + n_w), ca.SX.sym("c", scheme.c_size)
    z, w, end = both[:size], both[size:], model.c_size
    fields = scheme.layout.unpack(z)
    t = fields["t0"] + fields["n"] * c[end]
    found = started_anew(scheme, z, t, c, ca.vertcat(c[: end - n_w], w, c[end:]))
    return ca.Function("started_anew", [both, c], [ca.densify(ca.vertcat(found, w))], ["z", "c"], ["z_next"])

"""Parts of a major step, from one clock to another."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.coordinates import independent_rates, joined
from runtime.contract.model import Model
from runtime.schemes.direct import direct
from runtime.schemes.scheme import Scheme
from runtime.schemes.state_fields import Lasting
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.breaks import within
from runtime.schemes.switching.restart import remembers

MOST_KEPT = 64  # lengths


@dataclass(frozen=True)
class Leg:
    """Where a part of a step has led: z (whole), its dt [s]; seen: q and q_dot where rates have jumped.

    reached: its clock [s]; ends: has an event ended the run there?
    """

    z: np.ndarray
    dt: float
    seen: tuple[np.ndarray, np.ndarray] | None = None
    reached: float = 0.0
    ends: bool = False


Acts = Callable[[Leg, list[int]], Leg]  # what events (positions) do at a leg's end: inputs in its z, the end of the run


class Legs:
    """Makes them with a stepper. c (c_size,) are always the model's constants, with the inputs that hold."""

    def __init__(self, stepper: Stepper) -> None:
        self.stepper = stepper
        self._kept: dict[float, np.ndarray] = {}

    @cached_property
    def remembers(self) -> bool:
        """Does the scheme act through more than positions and rates?"""
        return remembers(self.scheme)

    @property
    def scheme(self) -> Scheme:
        """Of the stepper."""
        return self.stepper.scheme

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.stepper.scheme.model

    def part(self, leg: Leg, c: np.ndarray, start: float, length: float) -> Leg:
        """A part so long [s] from a clock on [s]; c (c_size,)."""
        if self.remembers and leg.seen is None:  # all that set out from here need it
            leg = replace(leg, seen=self.seen(leg.z, self.constants(c, leg.dt)))
        z, dt = self.flown(leg, c, start, length)
        return Leg(z, dt, reached=start + length)

    def flown(self, leg: Leg, c: np.ndarray, start: float, length: float) -> tuple[np.ndarray, float]:
        """(z, its step) after a part so long [s]."""
        dt = within(length, self.scheme.grid.m)
        z = self.set_out(leg, c, start, dt)
        self.stepper.run(z, self.ready(c, dt), 1)
        return z, dt

    def set_out(self, leg: Leg, c: np.ndarray, t: float, dt: float) -> np.ndarray:
        """z (n_z,) from which steps dt [s] go on at a clock, with the accounts and inputs of the leg before."""
        scheme = self.scheme
        if self.remembers:
            q, q_dot = leg.seen or self.seen(leg.z, self.constants(c, leg.dt))
            z = self.stepper.start(t, q, q_dot, c, dt)
            z[self._stays] = leg.z[self._stays]
        else:
            z = leg.z.copy()
            if leg.seen is not None:
                z[scheme.layout.slice("v")] = independent_rates(self.model, *leg.seen)
        z[0], z[1] = t, 0.0
        return z

    @cached_property
    def _stays(self) -> np.ndarray:
        """Where accounts and inputs are in z."""
        names, size = self.scheme.lasting(Lasting.ACCOUNT, Lasting.GIVEN), np.arange(self.scheme.layout.size)
        return np.concatenate([size[self.scheme.layout.slice(name)] for name in names])

    def seen(self, z: np.ndarray, constants: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All coordinates and rates (n,) of a state."""

        def build() -> ca.Function:
            symbols = ca.SX.sym("z", self.scheme.layout.size), ca.SX.sym("c", self.scheme.c_size)
            found = self.scheme.observer(z=symbols[0], c=symbols[1])
            whole = [joined(self.model, found[f"q_i{rate}"], found[f"q_d{rate}"]) for rate in ("", "_dot")]
            return ca.Function("seen", list(symbols), whole)

        found = direct(self.scheme, "seen", build)(self.stepper.state(z), constants)
        return found[: len(found) // 2], found[len(found) // 2 :]

    def constants(self, c: np.ndarray, dt: float) -> np.ndarray:
        """c (c_size,) as the stages read them, for a step of dt [s]."""
        return self.scheme.constants(c, dt)

    def ready(self, c: np.ndarray, dt: float) -> np.ndarray:
        """What the program reads for c (c_size,) and a length [s], kept while there are few of them."""
        if dt not in self._kept:
            if len(self._kept) >= MOST_KEPT:
                self._kept.clear()
            self._kept[dt] = self.stepper.ready(c, dt)
        return self._kept[dt]

    def with_inputs(self, z: np.ndarray, c: np.ndarray) -> np.ndarray:
        """c (c_size,) with the inputs that z holds."""
        layout = self.scheme.layout
        if "inputs" not in layout.sizes:
            return c
        held = z[layout.slice("inputs")]
        return np.concatenate([c[: len(c) - len(held)], held])

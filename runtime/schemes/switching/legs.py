"""Parts of a major step, from one clock to another, with the work that is done in them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from math import prod

import numpy as np

from runtime.contract.coordinates import independent_rates, whole
from runtime.contract.model import Model
from runtime.schemes.scheme import Scheme
from runtime.schemes.state_fields import Lasting
from runtime.schemes.stepper import Stepper
from runtime.schemes.work import accounted, power_of

MOST_KEPT = 64  # lengths


@dataclass(frozen=True)
class Leg:
    """Where a part of a step has led: z (whole), its dt [s], work [J]; seen: q and q_dot where rates have jumped.

    reached: its clock [s]; ends: has an event ended the run there?
    """

    z: np.ndarray
    dt: float
    work: float
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
        return set(self.scheme.memory) != {"x", "v", "loop"}

    @property
    def scheme(self) -> Scheme:
        """Of the stepper."""
        return self.stepper.scheme

    @property
    def model(self) -> Model:
        """Of the scheme."""
        return self.stepper.scheme.model

    def part(self, leg: Leg, c: np.ndarray, start: float, end: float) -> Leg:
        """A step between two clocks [s], with the work that is done in it; c (c_size,)."""
        scheme, work = self.scheme, leg.work
        z, length = self.flown(leg, c, start, end)
        if accounted(scheme):
            half = self.flown(leg, c, start, start + length / 2)
            seen = [(self.set_out(leg, c, start, length), length), half, (z, length)]
            powers = [power_of(scheme, self.stepper.state(one), self.constants(c, dt)) for one, dt in seen]
            work += length * (powers[0] + 4 * powers[1] + powers[2]) / 6
        return Leg(z, length, work, reached=end)

    def flown(self, leg: Leg, c: np.ndarray, start: float, end: float) -> tuple[np.ndarray, float]:
        """(z, its step) after a step between two clocks, nothing counted."""
        length = self.length(start, end)
        z = self.set_out(leg, c, start, length)
        self.stepper.run(z, self.ready(c, length), 1)
        return z, length

    def length(self, start: float, end: float) -> float:
        """The step [s] between two clocks."""
        return (end - start) * (1 - 2 * np.finfo(float).eps * prod(self.scheme.grid.m))  # sub-steps add up by rounding

    def set_out(self, leg: Leg, c: np.ndarray, t: float, dt: float) -> np.ndarray:
        """z (n_z,) from which steps dt [s] go on at a clock, with the accounts and inputs of the leg before."""
        scheme = self.scheme
        if self.remembers:
            q, q_dot = leg.seen or self.seen(leg.z, self.constants(c, leg.dt))
            z = self.stepper.start(t, q, q_dot, c, dt)
            for name in scheme.lasting(Lasting.ACCOUNT, Lasting.GIVEN):
                z[scheme.layout.slice(name)] = leg.z[scheme.layout.slice(name)]
        else:
            z = leg.z.copy()
            if leg.seen is not None:
                z[scheme.layout.slice("v")] = independent_rates(self.model, *leg.seen)
        z[0], z[1] = t, 0.0
        return z

    def seen(self, z: np.ndarray, constants: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """All coordinates and rates (n,) of a state."""
        model, seen = self.model, self.scheme.observer(z=self.stepper.state(z), c=constants)
        parts = {name: np.asarray(value).ravel() for name, value in seen.items()}
        q, q_dot = (whole(model, parts[f"q_i{rate}"], parts[f"q_d{rate}"]) for rate in ("", "_dot"))
        return q, q_dot

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

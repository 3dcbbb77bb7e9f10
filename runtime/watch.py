"""What is checked between native calls: finiteness, growth, energy, closure, sweeps. A failure gets a named status."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.coupled_frequencies import fastest_frequency
from runtime.model import Model
from runtime.schemes.central_difference import CentralDifference
from runtime.status import Status, StatusName

GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call
CLOSURE_LIMIT = 1e-2  # C before the last Newton step [m, rad]; quadratic convergence leaves its square
ENERGY_LIMIT = 0.5  # spurious energy as a share of the largest kinetic and elastic energy seen


class Watch:
    """Looks at z after each native call; `after` returns a Status to stop with, or None to go on."""

    def __init__(self, model: Model, scheme: CentralDifference, c: np.ndarray) -> None:
        self.model, self.scheme, self.c = model, scheme, c
        self._good: np.ndarray | None = None
        self._scale = 1.0
        self._energy = _EnergyCheck(model, scheme, c)

    def first(self, z: np.ndarray) -> Status | None:
        """Check the start and remember its scale."""
        if not np.all(np.isfinite(z)):
            return Status("not_finite", float(z[0]), None, "the accelerations at the start are not finite",
                          "M_hat may be singular: check masses, inertias and the initial position.")
        layout = self.scheme.layout
        x, d = z[layout.slice("x")], z[layout.slice("d")]
        self._scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        self._good = z.copy()
        self._energy.grows(z)
        return None

    def after(self, z: np.ndarray) -> Status | None:
        """Status that ends the run, or None to go on. z is put back to the last good state when it ends."""
        status = self._problem(z)
        if status is None:
            self._good = z.copy()
        elif self._good is not None:
            z[:] = self._good
        return status

    def _problem(self, z: np.ndarray) -> Status | None:
        layout = self.scheme.layout
        x, d = z[layout.slice("x")], z[layout.slice("d")]
        if not np.all(np.isfinite(z)):
            bad = ~np.isfinite(x) | ~np.isfinite(d)
            return self._stop("not_finite", int(np.argmax(bad)), "a coordinate became infinite or NaN")
        # angles may turn for ever, so growth is judged on increments
        if np.abs(d).max(initial=0.0) > GROWTH_LIMIT * self._scale:
            return self._stop("diverged", int(np.abs(d).argmax()), "the coordinate grows without bound")
        if z[layout.slice("closure_error")][0] > CLOSURE_LIMIT:
            return self._stop("constraints_lost", None, "the loop closure moves too far in one step for Newton")
        if z[layout.slice("failures")][0] > 0:
            limit = self.scheme.options.max_iterations
            return self._stop("iteration_failed", None, f"the sweep (52)-(57) did not converge in {limit} iterations")
        if self._energy.grows(z):
            return self._stop("diverged", int(np.abs(d / self.scheme.step_sizes).argmax()),
                              "energy grows although nothing feeds the mechanism")
        return None

    def _stop(self, name: StatusName, k: int | None, cause: str) -> Status:
        assert self._good is not None
        layout, grid = self.scheme.layout, self.scheme.grid
        time = float(self._good[0] + self._good[layout.slice("n")][0] * grid.dt_L)
        coordinate = None if k is None else self.model.q_i[k]
        return Status(name, time, coordinate, cause, self._advice(name))

    def _advice(self, name: str) -> str:
        if name == "iteration_failed":
            return "Use common_update = direct, a larger eps, or a smaller step."
        if name == "constraints_lost":
            return ("The mechanism may be at a dead centre, where the chosen independent coordinates do not determine "
                    "it: choose others (partition.independent), or reduce the step.")
        assert self._good is not None
        observed = self.scheme.observe()(z=self._good, c=self.c)
        frequency = fastest_frequency(self.model, observed, self.c)
        h = self.scheme.grid.h[-1]
        if not frequency:
            return "Reduce the step."
        limit = 2 / frequency
        text = (f"The fastest coupled frequency at the last good state is {frequency:.4g} rad/s: central difference "
                f"needs a step below {limit:.3g} s there, and the fastest group's step is {h:.3g} s.")
        if h > limit:
            return text
        if len(self.scheme.grid.groups) > 1:
            return text + (" So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
                           "reduce m or dt, add damping, or use single_rate.")
        return text + (" So the growth may be physical: a spinning beam without geometric stiffening diverges, "
                       "for instance.")


class _EnergyCheck:
    """Energy of a mechanism that no load and no prescribed motion feeds can only stay or fall."""

    def __init__(self, model: Model, scheme: CentralDifference, c: np.ndarray) -> None:
        self.c = c
        needed = ("energy", "constraints") if model.constraints else ("energy",)
        active = all(model.has(name) for name in needed) and _is_closed(model)
        self._energies = _energies(model, scheme) if active else None
        self._start: float | None = None
        self._largest = 0.0

    def grows(self, z: np.ndarray) -> bool:
        """Has spurious energy reached ENERGY_LIMIT of the largest kinetic and elastic energy seen?"""
        if self._energies is None:
            return False
        moving, potential = (float(value) for value in self._energies(z, self.c))
        self._largest = max(self._largest, moving)
        if self._start is None:
            self._start = moving + potential
        return moving + potential - self._start > ENERGY_LIMIT * self._largest


def _energies(model: Model, scheme: CentralDifference) -> ca.Function:
    """(z, c) -> kinetic plus elastic energy, potential energy."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    seen = scheme.observe()(z=z, c=c)
    q, q_dot = ca.SX(len(model.coordinates), 1), ca.SX(len(model.coordinates), 1)
    for columns, suffix in ((model.independent_columns, "i"), (model.dependent_columns, "d")):
        for position, column in enumerate(columns):
            q[int(column)] = seen[f"q_{suffix}"][position]
            q_dot[int(column)] = seen[f"q_{suffix}_dot"][position]
    kernel = model.kernel("energy")
    values = {"q": q, "q_dot": q_dot, "t": seen["t"], "c": c}
    energy = kernel.call({name: values[name] for name in kernel.name_in()})
    return ca.Function("energies", [z, c], [energy["kinetic"] + energy["elastic"], energy["potential"]])


def _is_closed(model: Model) -> bool:
    """Do neither loads nor prescribed motions do work on the mechanism?"""
    outputs = [("energy", "power_applied")] + ([("constraints", "C_t")] if model.constraints else [])
    return all(model.structurally_zero(function, output) for function, output in outputs)

"""What is checked between native calls: finiteness, growth, closure, sweeps, constraints, mass, energy."""

from __future__ import annotations

import math

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.status import Status, StatusName
from runtime.contract.units import length_rows, mechanism_length
from runtime.modes.modes import ModeSolver, State
from runtime.running.singular.euler_angles import singular_angles
from runtime.schemes.scheme import Scheme
from runtime.schemes.step_limit import StepLimit

GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call
CLOSURE_LIMIT = 1e-2  # C before the last Newton step, in mechanism lengths; quadratic convergence leaves its square
CONSTRAINT_LIMIT = 1e-6  # C of the observed state, in mechanism lengths (m) or rad
FULL_CHECKS = 16  # calls; constraints, mass and energy cost more than a short call
ENERGY_LIMIT = 0.5  # spurious energy as a share of the largest kinetic and elastic energy seen


class Watch:
    """Looks at z after each native call; `after` returns a Status to stop with, or None to go on.

    step_limit is the stability limit of the fastest group's step at the start [s], None if there or not known.
    """

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray, force: bool = False) -> None:
        self.model, self.scheme, self.c, self.force = model, scheme, scheme.constants(c), force
        self._good: np.ndarray | None = None
        self._scale = 1.0
        self._energy = _EnergyCheck(model, scheme, c)
        self._constraints = _ConstraintCheck(model, scheme, c)
        self.step_limit: float | None = None
        self._calls = 0

    def steps_done(self, z: np.ndarray) -> float:
        """Major steps of a state."""
        return float(z[self.scheme.layout.slice("n")][0])

    def first(self, z: np.ndarray) -> Status | None:
        """Check the start and remember its scale."""
        if not np.all(np.isfinite(z)):
            return Status(
                "not_finite",
                float(z[0]),
                None,
                "the accelerations at the start are not finite",
                self._angles(z) or "M_hat may be singular: check masses, inertias and the initial position.",
            )
        layout = self.scheme.layout
        x, d = z[layout.slice("x")], self._increments(z)
        self._scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        self._good = z.copy()
        self._energy.grows(z)
        self._constraints.start(z)
        if not self._constraints.positive_mass(z):
            return self._stop("mass_not_positive", None, "M_hat is not positive definite at the start")
        limit = self._limit()
        self.step_limit = limit.h if limit else None
        h = self.scheme.grid.h[-1]
        if self.step_limit is not None and h > self.step_limit and not self.force:
            return self._stop("step_too_long", None, f"the step {h:.3g} s of the fastest group is above its limit")
        return None

    def after(self, z: np.ndarray, last: bool = False) -> Status | None:
        """Status that ends the run, or None to go on. z is put back to the last good state when it ends.

        Cheap checks follow every call; the others the first FULL_CHECKS calls, then every FULL_CHECKS-th and the last.
        """
        self._calls += 1
        full = last or self._calls <= FULL_CHECKS or self._calls % FULL_CHECKS == 0
        status = self._cheap_problem(z) or (self._problem(z) if full else None)
        if status is not None and self._good is not None:
            z[:] = self._good
        elif full:
            self._good = z.copy()
        return status

    def memory(self) -> list[float]:
        """What later checks compare with: scale, size, energy at the start and the largest one seen."""
        return [self._scale, self._constraints.length, self._energy.at_start, self._energy.largest]

    def resume(self, z: np.ndarray, memory: list[float]) -> None:
        """Go on from a good state with the memory of an earlier watch."""
        self._good = z.copy()
        self._scale, self._constraints.length, self._energy.at_start, self._energy.largest = memory

    def _increments(self, z: np.ndarray) -> np.ndarray:
        """About what each coordinate moves in a step."""
        return np.asarray(self.scheme.rates(z) * self.scheme.step_sizes)

    def _cheap_problem(self, z: np.ndarray) -> Status | None:
        layout = self.scheme.layout
        x, d = z[layout.slice("x")], self._increments(z)
        failed = z[layout.slice("failures")][0] > 0
        if not np.all(np.isfinite(z)) and not failed:
            bad = ~np.isfinite(x) | ~np.isfinite(d)
            return self._stop("not_finite", int(np.argmax(bad)), "a coordinate became infinite or NaN")
        # angles may turn for ever, so growth is judged on increments
        if np.abs(d).max(initial=0.0) > GROWTH_LIMIT * self._scale:
            return self._stop("diverged", int(np.abs(d).argmax()), "the coordinate grows without bound")
        if z[layout.slice("closure_error")][0] > CLOSURE_LIMIT * self._constraints.length:
            return self._stop("constraints_lost", None, "the loop closure moves too far in one step for Newton")
        if failed:
            limit = self.scheme.options.max_iterations
            return self._stop("iteration_failed", None, f"the update of a step did not converge in {limit} iterations")
        return None

    def _problem(self, z: np.ndarray) -> Status | None:
        if self._constraints.violated(z):
            return self._stop("constraints_lost", None, "a constraint no longer holds")
        if not self._constraints.positive_mass(z):
            return self._stop("mass_not_positive", None, "M_hat is no longer positive definite")
        if self._energy.grows(z):
            return self._stop(
                "diverged",
                int(np.abs(self.scheme.rates(z)).argmax()),
                "energy grows although nothing feeds the mechanism",
            )
        return None

    def _stop(self, name: StatusName, k: int | None, cause: str) -> Status:
        assert self._good is not None
        time = float(self._good[0] + self.steps_done(self._good) * self.scheme.grid.dt_L)
        coordinate = None if k is None else self.model.q_i[k]
        return Status(name, time, coordinate, cause, self._advice(name))

    def _limit(self) -> StepLimit | None:
        """What limits the step at the last good state. None if nothing does, or if its modes are not known."""
        if self._good is None or self.scheme.reach is None or not ModeSolver.possible(self.model):
            return None
        seen = self.scheme.observer(z=self._good, c=self.c)
        loop = [self.model.q_d.index(name) for name in self.model.loop_unknowns]
        q_i, rates, q_d = (np.asarray(seen[name]).ravel() for name in ("q_i", "q_i_dot", "q_d"))
        try:
            solver = ModeSolver(self.model, self.c[: self.model.c_size])
            return self.scheme.step_limit(*solver.slopes(State(float(seen["t"]), q_i, rates, q_d[loop])))
        except np.linalg.LinAlgError:  # not finite, or M_hat is singular
            return None

    def _angles(self, z: np.ndarray) -> str | None:
        """What is to be said if Euler angles are near their singular orientation."""
        seen = self.scheme.observer(z=z, c=self.c)
        values = {
            name: float(value)
            for names, key in ((self.model.q_i, "q_i"), (self.model.q_d, "q_d"))
            for name, value in zip(names, np.asarray(seen[key]).ravel(), strict=True)
        }
        return singular_angles(self.model.scene_toml, values)

    def _advice(self, name: str) -> str:
        if self._good is not None and (turned := self._angles(self._good)) is not None:
            return turned
        if name == "mass_not_positive":
            return (
                "A deflection is too large for second-order geometric stiffening, or a mass is not positive: "
                "use more or stiffer bodies, smaller loads, or a shorter step if it grew by instability."
            )
        if name == "iteration_failed":
            return "Use a smaller step, a larger eps, or (printed) common_update = direct."
        limit, h = self._limit(), self.scheme.grid.h[-1]
        if limit is None:
            return "Reduce the step."
        text = (
            f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
            f"fastest group's step is {h:.3g} s."
        )
        if h > limit.h:
            return text
        if name == "constraints_lost":
            return text + (
                " So the mechanism may be at a dead centre, where the chosen independent coordinates do not "
                "determine it: choose others (partition.independent), or reduce the step."
            )
        if len(self.scheme.grid.groups) > 1:
            return text + (
                " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
                "reduce m or dt, add damping, or use single_rate."
            )
        return text + (
            " So the growth may be physical: a spinning beam without geometric stiffening diverges, for instance."
        )


class _ConstraintCheck:
    """C and M_hat of the observed state; C in units of the mechanism: metres of its size, or radians."""

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray) -> None:
        self.c, self.length = scheme.constants(c), 1.0
        self._model, self._lengths = model, length_rows(model)
        active = bool(model.constraints) and model.has("constraints")
        self._function = _constraints(model, scheme) if active else None
        self._mass = _mass(model, scheme)

    def start(self, z: np.ndarray) -> None:
        """Take the mechanism's size from the lever arms in C_q."""
        if self._function is not None:
            self.length = mechanism_length(self._model, np.asarray(self._function(z, self.c)[1]))

    def violated(self, z: np.ndarray) -> bool:
        """Is a constraint off by more than CONSTRAINT_LIMIT?"""
        if self._function is None:
            return False
        C = np.abs(np.asarray(self._function(z, self.c)[0]).ravel())
        return not bool((C <= CONSTRAINT_LIMIT * np.where(self._lengths, self.length, 1.0)).all())  # NaN is off too

    def positive_mass(self, z: np.ndarray) -> bool:
        """Is M_hat finite and positive definite?"""
        M_hat = np.asarray(self._mass(z, self.c))
        return bool(np.isfinite(M_hat).all()) and bool(np.linalg.eigvalsh(M_hat)[0] > 0)


def _mass(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c) -> M_hat."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    seen = {**scheme.observer(z=z, c=c), "c": c[: model.c_size]}
    kernel = model.kernel("condensed")
    result = kernel.call({key: seen[key] for key in kernel.name_in()})
    return ca.Function("mass", [z, c], [result["M_hat"]])


def _observed(model: Model, scheme: Scheme, name: str) -> tuple[list[ca.SX], dict[str, ca.SX]]:
    """([z, c], outputs of a kernel of (q, q_dot, t) at the state that z shows)."""
    z, c = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
    seen = scheme.observer(z=z, c=c)
    q, q_dot = ca.SX(len(model.coordinates), 1), ca.SX(len(model.coordinates), 1)
    for columns, suffix in ((model.independent_columns, "i"), (model.dependent_columns, "d")):
        for position, column in enumerate(columns):
            q[int(column)] = seen[f"q_{suffix}"][position]
            q_dot[int(column)] = seen[f"q_{suffix}_dot"][position]
    kernel = model.kernel(name)
    values = {"q": q, "q_dot": q_dot, "t": seen["t"], "c": c[: model.c_size]}
    return [z, c], dict(kernel.call({key: values[key] for key in kernel.name_in()}))


def _constraints(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c) -> C, C_q."""
    arguments, outputs = _observed(model, scheme, "constraints")
    return ca.Function("constraints", arguments, [outputs["C"], outputs["C_q"]])


class _EnergyCheck:
    """Energy of a mechanism that no load and no prescribed motion feeds can only stay or fall."""

    def __init__(self, model: Model, scheme: Scheme, c: np.ndarray) -> None:
        self.c = scheme.constants(c)
        needed = ("energy", "constraints") if model.constraints else ("energy",)
        active = all(model.has(name) for name in needed) and _is_closed(model)
        self._energies = _energies(model, scheme) if active else None
        self.at_start, self.largest = math.nan, 0.0

    def grows(self, z: np.ndarray) -> bool:
        """Has spurious energy reached ENERGY_LIMIT of the largest kinetic and elastic energy seen?"""
        if self._energies is None:
            return False
        moving, potential = (float(value) for value in self._energies(z, self.c))
        self.largest = max(self.largest, moving)
        if math.isnan(self.at_start):
            self.at_start = moving + potential
        return not moving + potential - self.at_start <= ENERGY_LIMIT * self.largest  # NaN has grown too


def _energies(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c) -> kinetic plus elastic energy, potential energy."""
    arguments, energy = _observed(model, scheme, "energy")
    return ca.Function("energies", arguments, [energy["kinetic"] + energy["elastic"], energy["potential"]])


def _is_closed(model: Model) -> bool:
    """Do neither loads nor prescribed motions do work on the mechanism?"""
    outputs = [("energy", "power_applied")] + ([("constraints", "C_t")] if model.constraints else [])
    return all(model.structurally_zero(function, output) for function, output in outputs)

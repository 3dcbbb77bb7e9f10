"""What is checked between native calls: finiteness, growth, closure and sweeps. A failure gets a named status."""

from __future__ import annotations

import numpy as np
import scipy.linalg

from runtime.model import Model
from runtime.schemes.central_difference import CentralDifference
from runtime.status import Status

GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call
CLOSURE_LIMIT = 1e-2  # C before the last Newton step [m, rad]; quadratic convergence leaves its square


class Watch:
    """Looks at z after each native call; `after` returns a Status to stop with, or None."""

    def __init__(self, model: Model, scheme: CentralDifference, c: np.ndarray) -> None:
        self.model, self.scheme, self.c = model, scheme, c
        self._good: np.ndarray | None = None
        self._scale = 1.0

    def first(self, z: np.ndarray) -> Status | None:
        """Check the start and remember its scale."""
        x = z[self.scheme.layout.slice("x")]
        d = z[self.scheme.layout.slice("d")]
        if not np.all(np.isfinite(z)):
            return Status("not_finite", float(z[0]), None, "the accelerations at the start are not finite",
                          "M_hat may be singular: check masses, inertias and the initial position.")
        self._scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        self._good = z.copy()
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
        return None

    def _stop(self, name, k: int | None, cause: str) -> Status:  # type: ignore[no-untyped-def]
        assert self._good is not None
        layout, grid = self.scheme.layout, self.scheme.grid
        time = float(self._good[0] + self._good[layout.slice("n")][0] * grid.dt_L)
        coordinate = None if k is None else self.model.q_i[k]
        return Status(name, time, coordinate, cause, self._advice(name))

    def _advice(self, name: str) -> str:
        if name == "iteration_failed":
            return "Use common_update = direct, a larger eps, or a smaller step."
        frequency = self._fastest_frequency()
        h = self.scheme.grid.h[-1]
        if frequency is None or frequency == 0:
            return "Reduce the step."
        limit = 2 / frequency
        text = f"The fastest coupled frequency at the last good state is {frequency:.4g} rad/s: central difference " \
               f"needs a step below {limit:.3g} s there, and the fastest group's step is {h:.3g} s."
        if h < limit:
            text += " The sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): reduce m or dt, " \
                    "add damping, or use single_rate."
        return text

    def _fastest_frequency(self) -> float | None:
        """Square root of the largest generalised eigenvalue of -dQ_hat/dq_i against M_hat at the last good state."""
        if self._good is None or not self.model.has("dQ_hat_dq_i"):
            return None
        observed = self.scheme.observe()(z=self._good, c=self.c)
        values = {name: observed[name] for name in ("q_i", "q_d", "q_i_dot", "q_d_dot", "t")}
        values["c"] = self.c

        def call(name: str, output: str) -> np.ndarray:
            kernel = self.model.kernel(name)
            return np.asarray(kernel(**{key: values[key] for key in kernel.name_in()})[output])

        M_hat, stiffness = call("condensed", "M_hat"), -call("dQ_hat_dq_i", "dQ_hat_dq_i")
        if not (np.all(np.isfinite(M_hat)) and np.all(np.isfinite(stiffness))):
            return None
        eigenvalues = scipy.linalg.eigvals(stiffness, M_hat)
        return float(np.sqrt(np.abs(eigenvalues).max(initial=0.0)))

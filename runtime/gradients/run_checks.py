"""A run that is differentiated must be one that a simulation would complete: the same checks, by name."""

from __future__ import annotations

import numpy as np

from runtime.contract.errors import NoResult
from runtime.running.monitor import Monitor
from runtime.running.problem import Plan
from runtime.running.singular.singularity_monitor import SingularityMonitor
from runtime.running.stepped_model import NO_HIGHEST, NO_LOWEST


class RunChecks:
    """Checks of a run with constants c (c_size,) and parameters p (n_p,)."""

    def __init__(self, plan: Plan, c: np.ndarray, p: np.ndarray) -> None:
        self._scheme = plan.scheme
        self._monitor = Monitor(plan.scheme.model, plan.scheme, c, force=plan.force, p=p)

    def begin(self, z: np.ndarray) -> None:
        """Judge the start, and let the determinants of the loops begin. Raises NoResult."""
        layout = self._scheme.layout
        self._refuse(self._monitor.first(z[: layout.size].copy()))
        z[layout.slice("det_low")], z[layout.slice("det_high")] = NO_LOWEST, NO_HIGHEST

    def end(self, z: np.ndarray) -> None:
        """Judge the run by its last state. Raises NoResult."""
        layout = self._scheme.layout
        low, high = z[layout.slice("det_low")], z[layout.slice("det_high")]
        with np.errstate(all="ignore"):  # a run that has passed there may be lost
            passed = SingularityMonitor.of(len(low)).near_singular(low, high)
        if passed:
            raise NoResult(
                f"model {self._scheme.model.name}",
                "the run comes to where its loops are nearly singular, and a simulation would change coordinates there",
                "differentiate a shorter run, or choose other independent coordinates in the scene",
            )
        self._refuse(self._monitor.after(z[: layout.size].copy(), last=True))

    def _refuse(self, status: object) -> None:
        if status is not None:
            raise NoResult(f"model {self._scheme.model.name}", f"the run has no derivative, it ends: {status}")

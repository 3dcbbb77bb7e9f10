"""Ensembles of falling pendula, small and fast, for tests of studies."""

from __future__ import annotations

from typing import Any

import numpy as np

from runtime import ensemble
from runtime.model import Model

SHORT: dict[str, Any] = {"t_end": 0.02, "dt": 1e-3, "scheme": "single_rate"}


def pendula(model: Model, count: int, **settings: Any) -> Any:
    """Pendula that begin to fall with several speeds."""
    speeds = np.linspace(0.0, 1.0, count)
    outputs = ["rod.theta", "tip_y"]
    return ensemble(model, initial={"rod.theta_dot": speeds}, **{**SHORT, "outputs": outputs, **settings})

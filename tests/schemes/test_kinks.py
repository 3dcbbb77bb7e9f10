"""Loads with a kink in the motion, such as max(0, ...): what a start upon it costs schemes that linearise there."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.contract.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.prepared_runs import PreparedRuns

Build = Callable[[SceneRecord], Model]
T_END, DT = 0.16, 0.01


def against_a_stop(angle: float) -> SceneRecord:
    """A rod that turns with 2 rad/s against a stop that pushes back beyond its horizontal position."""
    builder = Scene("against_a_stop").gravity(0, -9.81)
    builder.rigid(
        "rod", mass=1.0, inertia=0.1, markers={"hinge": {"position": (-0.5, 0)}, "tip": {"position": (0.5, 0)}}
    )
    builder.revolute("hinge", "ground.origin", "rod.hinge").measure("height", "y", of="rod.tip")
    builder.force("stop", "rod.tip", 0, "max(0, -60 * height)")
    builder.initial({"rod.theta": angle}).rates({"rod.theta": -2.0})
    return builder.simulation(t_end=T_END, dt=DT, scheme="rk4").build()


@pytest.mark.parametrize(
    "scheme, angle, order, most",
    [("exponential", -0.02, 4, 2.5e-11), ("exponential", 0.0, 2, 6e-6), ("radau", 0.0, 5, 3e-12)],
)
def test_a_start_on_a_kink(model_of: Build, scheme: str, angle: float, order: float, most: float) -> None:
    """The first step is linearised without the stop that it goes into: h^2 once, where others keep their order."""
    model = model_of(against_a_stop(angle))
    wanted = PreparedRuns(model, "dop853", engine="interpreted").end(T_END, DT / 8)
    runs = PreparedRuns(model, scheme, [1] if scheme == "exponential" else None, engine="interpreted")
    errors = [float(np.abs(runs.end(T_END, h) - wanted).max()) for h in (DT / 2, DT / 4)]
    assert errors[1] < most, errors
    assert np.log2(errors[0] / errors[1]) == pytest.approx(order, abs=0.1), errors

"""Model exchange of joints that stick and of rigid stops: modes are decided in event mode, jumps are time events."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime.engine.c_source import find_compiler
from runtime.export.c_bundle import exported
from runtime.export.fmu import write_fmu
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.export.test_c_friction import block
from tests.export.test_c_friction import links as rubbing
from tests.export.test_c_rigid_stops import links, pressed, slider_crank, stacked
from tests.export.test_c_stops import jumping
from tests.export.test_fmu import EXCHANGE, OK, Master
from tests.running.test_rigid_stops import ball

Build = Callable[[SceneRecord], Model]
pytestmark = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")
CASES: list[Any] = [  # scene, version, end [s], step of the run, events at least
    (block, 3, 4.0, 1e-3, 3),
    (lambda: rubbing(2), 2, 3.0, 2e-4, 20),
    (lambda: ball(0.8), 2, 5.0, 1e-2, 50),
    (links, 3, 1.5, 1e-3, 200),
    (slider_crank, 2, 1.4, 1e-3, 4),
    (pressed, 3, 3.0, 1e-3, 7),
    (stacked, 2, 3.0, 1e-2, 50),
    (jumping, 3, 0.6, 1e-3, 0),
]


@pytest.mark.every_push("jumping-3-0.6-0.001-0")
@pytest.mark.parametrize(("scene", "fmi", "t_end", "dt", "events"), CASES)
def test_a_master_with_cvode_finds_the_motion_of_a_run(
    model_of: Build, tmp_path: Path, scene: Callable[[], Scene], fmi: int, t_end: float, dt: float, events: int
) -> None:
    """To 1e-8 of the largest value: sticking, impacts, sums of bounces, rests, jumps in time."""
    fmpy = pytest.importorskip("fmpy")
    from fmpy.validation import validate_fmu

    model = model_of(scene().simulation(t_end=t_end, dt=dt, scheme="rk4").build())
    path, names = str(tmp_path / "unit.fmu"), [*model.q_i, *(f"{name}_dot" for name in model.q_i)]
    write_fmu(exported(model), path, fmi)
    assert not validate_fmu(path)
    how: dict[str, Any] = {
        "solver": "CVode",
        "relative_tolerance": 1e-12,
        "output_interval": t_end / 10,
        "record_events": False,
    }
    found = fmpy.simulate_fmu(path, fmi_type="ModelExchange", stop_time=t_end, output=names, **how)
    stepper, rows = model.stepper(), []
    for _ in range(10):
        stepper.step(round(t_end / dt / 10))
        rows.append(stepper.reader(names)().copy())
    seen = np.array([list(row)[1:] for row in found][1:])
    np.testing.assert_allclose(seen, rows, rtol=0, atol=1e-8 * np.abs(rows).max())
    assert len(stepper.events) >= events


def test_the_next_jump_is_told_beforehand(model_of: Build, tmp_path: Path) -> None:
    """fmi2NewDiscreteStates: 12.3 ms, then 30 ms, which an input moves to 40 ms, then nothing near."""
    scene = Scene("cart").input("late", 0.03, "s").rigid("cart", mass=1.0, inertia=0.1)
    scene.prismatic("rail", "ground.origin", "cart.origin")
    scene.force("drive", "cart.origin", "where(t < 0.0123, 1, -2) + step(t - late)", 0.0)
    model = model_of(scene.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build())
    master, info = Master(model, tmp_path, EXCHANGE), (ctypes.c_int * 8)()
    master.begin()

    def told(t: float) -> float:
        assert master.call("SetTime", ctypes.c_double(t)) == OK and master.call("NewDiscreteStates", info) == OK
        assert info[4]
        return ctypes.c_double.from_buffer(info, 24).value

    def force(t: float) -> float:
        assert master.call("SetTime", ctypes.c_double(t)) == OK
        return float(master.derivatives(np.zeros(2))[1])

    assert told(0.0) == pytest.approx(0.0123, abs=1e-15) and force(0.0123) == 1.0  # until it is told
    assert told(0.0123) == pytest.approx(0.03, abs=1e-15) and force(0.0123) == -2.0
    assert master.set("late", 0.04) == OK
    assert told(0.02) == pytest.approx(0.04, abs=1e-15)
    assert told(0.04) > 10.0 and force(0.04) == -1.0

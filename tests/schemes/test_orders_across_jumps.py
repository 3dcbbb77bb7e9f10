"""Cases of the hard suite in which a load jumps: steps end there, and order 4 is kept."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.scenes.hard_suite import HARD_SUITE
from runtime import Model, simulate
from runtime.schemes.switching.times import switching_times
from symgen.scene import Scene, SceneRecord

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]


@pytest.mark.parametrize(
    "name, t_end, steps, caps",
    [
        ("f2_heavy_hub", 2.5, 260, (5e-11, 8e-11)),
        ("f2_light_hub", 2.5, 500, (3e-10, 5e-11)),
        ("slider_crank_torque", 0.2, 1800, (1.2e-9, 1e-7)),
    ],
)
def test_order_4_across_a_jump(model_of: Build, name: str, t_end: float, steps: int, caps: tuple[float, float]) -> None:
    """Slope of two halvings and cap at the end, of the coordinates that the suite grades; a jump lies before it."""
    case = HARD_SUITE[name]
    model = model_of(case.make())

    def ends(scheme: str, count: int) -> np.ndarray:
        settings = {"parameters": dict(case.parameters), "initial": dict(case.initial), "start": case.start}
        run = simulate(model, scheme=scheme, dt=t_end / count, t_end=t_end, force=True, samples=1, **settings)  # type: ignore[arg-type]
        return np.array([run[one][-1] for one in case.graded])

    exact = ends("dop853", 30 * steps)
    for scheme, cap in zip(("exponential_rk4", "exponential"), caps, strict=True):
        coarse, fine = (float(np.abs(ends(scheme, count) - exact).max()) for count in (steps, 2 * steps))
        assert np.log2(coarse / fine) > 3.7 and fine < cap, (scheme, coarse, fine)


@pytest.mark.parametrize("t_end, jumps", [(0.4, 53), (1.0, 131)])
def test_stages_behind_jumps_converge(model_of: Build, t_end: float, jumps: int) -> None:
    """`radau` against steps without iterations: by Python and by lists. Parts just before a jump may be tiny."""
    builder = Scene("wave_on_pendulum").gravity(0, -9.81)
    builder.rigid("bob", mass=1.3, inertia=0.2, center_of_mass=(0.7, 0)).revolute("pin", "ground.origin", "bob.origin")
    builder.torque("kick", "bob.origin", "where(sin(411 * t + 0.2) > 0.3, 8 * cos(9 * t), -3 * t)")
    model = model_of(builder.simulation(t_end=1.0, dt=0.005, scheme="rk4").build())
    wanted, found = (simulate(model, scheme=scheme, t_end=t_end, seen_every=0.05) for scheme in ("dop853", "radau"))
    assert len(switching_times(model, model.constants(model.parameter_vector(None)), 0.0, t_end)) == jumps
    assert np.abs(found.q - wanted.q).max() < 1e-11 and np.abs(found.q_dot - wanted.q_dot).max() < 1e-11

"""A tolerance holds behind singular positions and exchanges of coordinates, too: all rungs pass them as runs do."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np
import pytest

from runtime import simulate
from runtime.contract.model import Model
from runtime.running.singular.exchange import use_generator
from symgen.scene import SceneRecord
from symgen.variants import generate_variant
from tests.support.slider_cranks import driven_slider_crank, loop

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


@pytest.fixture(autouse=True)
def generator() -> Iterator[None]:
    use_generator(generate_variant)
    yield
    use_generator(None)


@pytest.mark.parametrize(
    ("name", "scheme", "tolerance", "t_end"),
    [
        ("n_four_bar", "dopri5", 1e-6, 3.0),
        ("driven", "exponential_rk4", 1e-6, 3.0),
        ("exchange", "exponential_rk4", 1e-5, 2.0),
    ],
)
def test_a_tolerance_is_delivered_behind_singular_positions(
    built_in: Load, model_of: Build, name: str, scheme: str, tolerance: float, t_end: float
) -> None:
    """RMS over the motion relative to the RMS amplitude: twice what is asked at most, and told."""
    scenes = {"driven": driven_slider_crank(), "exchange": loop(0.2, 0.5, "slider.x")}
    model = built_in(name) if name == "n_four_bar" else model_of(scenes[name].build())
    run = simulate(model, scheme=scheme, tolerance=tolerance, dt=0.01, t_end=t_end)
    exact = simulate(model, scheme="dop853", dt=1e-3, t_end=t_end, save_every=10)
    assert run.status.ok and len(run.events) == len(exact.events) > 0
    off = np.sqrt(np.mean((run.q_i - exact.q_i) ** 2)) / exact.q_i.std()
    assert off < 2 * tolerance and off / 10 < run.error.largest < 10 * off


@pytest.mark.parametrize("scheme", ["dopri5", "exponential_rk4"])
def test_steps_of_a_tolerance_are_counted_across_passages(built_in: Load, scheme: str) -> None:
    """None is longer than the largest: so many of that length are at least as long as the motion outside passages."""
    options = {"error_of": "step"}
    run = simulate(built_in("n_four_bar"), scheme=scheme, tolerance=1e-6, dt=0.05, t_end=3.0, options=options)
    assert run.status.ok and [event.kind for event in run.events] == ["singular_position"] * 3
    assert int(run.stats["steps"]) * float(run.stats["largest_step"]) > 2.0

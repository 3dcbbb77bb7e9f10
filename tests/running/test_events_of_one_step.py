"""Events of which several happen in one step, or just where a load jumps: none is lost."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from runtime import Model, simulate
from symgen.scene import Scene, SceneRecord
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]


@pytest.mark.every_push("single_rate", "rk4")
@pytest.mark.parametrize("scheme", ["rk4", "exponential", "single_rate"])
def test_all_passages_of_one_step_are_told_in_order(model_of: Build, scheme: str) -> None:
    """Values with three and four zeros in a step of 50 mm, at 1 m/s: also where its ends tell of one, or none."""
    zeros = {"cube": (0.51, 0.51 - 3e-5, 0.51 + 3e-5), "bands": (0.603, 0.605, 0.615, 0.617)}
    builder = Scene("gliding").rigid("mass", mass=1.0, inertia=0.1).rates({"mass.x": 1.0})
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    for name, places in zeros.items():
        builder.event(name, " * ".join(f"(x - {place!r})" for place in places))
    run = simulate(model_of(builder.simulation(t_end=1.0, dt=0.05, scheme="rk4").build()), scheme=scheme)
    told = [event.name for event in run.events]
    assert told == ["cube"] * 3 + ["bands"] * 4
    exact = sorted(zeros["cube"] + zeros["bands"])
    assert [event.time for event in run.events] == pytest.approx(exact, rel=0, abs=1e-9)


@pytest.mark.every_push("places0-rk4")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
@pytest.mark.parametrize("places", [(0.65, 1.22), (0.35, -0.22)])
def test_a_short_dip_of_a_cubic_is_told(model_of: Build, scheme: str, places: tuple[float, float]) -> None:
    """A cubic that dips below zero for 0.2 % of a step, with its third zero in the next step or the one before.

    Value and slope at one end of the step say that it may; by a quarter of the step, not a third, that line would
    not reach zero.
    """
    zeros = sorted(0.05 * (10 + place) for place in (places[0] - 1e-3, places[0] + 1e-3, places[1]))
    builder = Scene("gliding").rigid("mass", mass=1.0, inertia=0.1).rates({"mass.x": 1.0})
    builder.prismatic("rail", "ground.origin", "mass.origin").measure("x", "x", "mass.origin")
    builder.event("dip", " * ".join(f"(x - {place!r})" for place in zeros))
    run = simulate(model_of(builder.simulation(t_end=1.0, dt=0.05, scheme="rk4").build()), scheme=scheme)
    assert [event.time for event in run.events] == pytest.approx(zeros, rel=0, abs=1e-9)


@pytest.mark.every_push("0.5-rk4", "0.512-single_rate")
@pytest.mark.parametrize("scheme", ["rk4", "single_rate"])
@pytest.mark.parametrize("at", [0.512, 0.5])
def test_an_event_just_where_a_load_jumps(model_of: Build, at: float, scheme: str) -> None:
    """The force of 2 N that ends at a time is 3 N from there on, by an event at that time."""
    builder = on_rail("relieved", "mass", "rail", mass=1.0, inertia=0.1).input("own", 0.0, "N")
    builder.force("push", "mass.origin", f"where(t < {at}, 2, own)", 0.0)
    builder.event("takes", f"t - {at}", direction="rising", action={"own": "3"})
    run = simulate(model_of(builder.simulation(t_end=1.0, dt=0.05, scheme="rk4").build()), scheme=scheme)
    assert [event.time for event in run.events] == pytest.approx([at], rel=0, abs=1e-12)
    assert run.rate("mass.x")[-1] == pytest.approx(2 * at + 3 * (1 - at), rel=1e-9)

"""Native steps through events against the plain reading in Python (interpreted runs): equal states, events, words."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

import runtime.schemes.switching.native_events as native_events
from runtime import Solution
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.export.test_c_rigid_stops import links, pressed, rows_of_balls, slider_crank, stacked
from tests.export.test_c_stops import (
    before_a_kink,
    between,
    by_place,
    chattering,
    humming,
    jumping,
    kicked,
    kinks,
    relay,
    travelling,
)

Build = Callable[[SceneRecord], Model]
SCENES = (
    *(jumping, relay, kinks, by_place, between, before_a_kink, chattering, humming, travelling, kicked),
    *(rows_of_balls, stacked, links, slider_crank, pressed),
)


def short_pulses() -> Scene:
    """A stiff stop that long steps pass within less than two of them."""
    builder = Scene("short_pulses").rigid("cart", mass=1.0, inertia=0.1)
    builder.prismatic("rail", "ground.origin", "cart.origin").measure("way", "x", "cart.origin")
    builder.force("wall", "cart.origin", "max(0, -way) * 1e7 - 3", 0.0)
    return builder.initial({"cart.x": 0.05})


def _told(run: Solution) -> list[object]:
    return [run.status, [repr(event) for event in run.events], run.stats.get("unresolved_loads")]


def same(native: Solution, plain: Solution) -> None:
    """To the last bit, and in every word."""
    np.testing.assert_array_equal(native.t, plain.t)
    np.testing.assert_array_equal(native.q, plain.q)
    np.testing.assert_array_equal(native.q_dot, plain.q_dot)
    assert _told(native) == _told(plain)


@pytest.mark.every_push("rows_of_balls-rk4", "relay-rk4", "stacked-rk4")
@pytest.mark.parametrize(
    "scheme",
    [
        "rk4",
        pytest.param("single_rate", marks=pytest.mark.long),
        pytest.param("exponential", marks=pytest.mark.long),
        pytest.param("radau", marks=pytest.mark.long),
    ],
)
@pytest.mark.parametrize("scene", [*SCENES, short_pulses], ids=lambda one: one.__name__)
def test_the_plain_reading_decides_alike(model_of: Build, scene: Callable[[], Scene], scheme: str) -> None:
    model, asked = model_of(scene().build()), {"scheme": scheme, "dt": 1e-3, "t_end": 1.0, "error": "off"}
    if scheme == "single_rate":
        asked["force"] = True
    native, plain = (model.simulate(engine=engine, **asked) for engine in ("compiled-library", "interpreted"))
    same(native, plain)


def test_long_steps_tell_what_short_loads_err(model_of: Build) -> None:
    model, asked = model_of(short_pulses().build()), {"scheme": "rk4", "dt": 5e-3, "t_end": 1.0, "error": "off"}
    native, plain = (model.simulate(engine=engine, **asked) for engine in ("compiled-library", "interpreted"))
    same(native, plain)
    assert plain.stats["unresolved_loads"] > 0


@pytest.mark.long
@pytest.mark.parametrize("scene", [stacked, relay, links, humming], ids=lambda one: one.__name__)
def test_nothing_depends_on_how_many_steps_a_call_makes(
    model_of: Build, scene: Callable[[], Scene], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Samples at every step, or few; little room for records; the steps of a stepper, one by one and at once."""
    model, asked = model_of(scene().build()), {"scheme": "rk4", "dt": 1e-3, "t_end": 1.0, "error": "off"}
    few, all_steps = (model.simulate(seen_every=every, **asked) for every in (0.1, 0.0))
    np.testing.assert_array_equal(few.q, all_steps.q[:: (len(all_steps.t) - 1) // (len(few.t) - 1)])
    assert _told(few) == _told(all_steps)
    monkeypatch.setattr(native_events, "RECORDS", 201)
    same(model_of(scene().build()).simulate(seen_every=0.1, **asked), few)
    one, many = (model.stepper(scheme="rk4", dt=1e-3) for _ in range(2))
    many.step(1000)
    for _ in range(1000):
        one.step()
    np.testing.assert_array_equal(one.save().z, many.save().z)
    assert list(map(repr, one.events)) == list(map(repr, many.events))


@pytest.mark.long
@pytest.mark.parametrize("scene", [stacked, relay, links, pressed], ids=lambda one: one.__name__)
def test_balance_and_error_are_those_of_the_plain_reading(model_of: Build, scene: Callable[[], Scene]) -> None:
    model, asked = model_of(scene().build()), {"scheme": "rk4", "dt": 1e-3, "t_end": 0.5}
    native, plain = (model.simulate(engine=engine, **asked) for engine in ("compiled-library", "interpreted"))
    same(native, plain)
    assert native.error.largest == plain.error.largest
    assert repr(native.balance) == repr(plain.balance)


@pytest.mark.long
def test_a_run_goes_on_from_a_checkpoint_between_impacts(model_of: Build, tmp_path) -> None:  # type: ignore[no-untyped-def]
    from runtime import resume

    model = model_of(stacked().build())
    asked = {"scheme": "rk4", "dt": 1e-3, "t_end": 1.0, "error": "off", "seen_every": 0.01}
    whole = model.simulate(**asked)
    model.simulate(checkpoint=tmp_path / "here.ckpt", checkpoint_every=170, **asked)
    same(resume(model, tmp_path / "here.ckpt"), whole)

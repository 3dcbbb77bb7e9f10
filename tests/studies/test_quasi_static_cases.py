"""Ensembles that start in elastic equilibrium: found in lanes, each the start of the run by itself."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import ensemble, simulate
from runtime.model import Model
from runtime.operating.newton import balanced
from runtime.start import quasi_static
from runtime.start.start_state import start_state
from runtime.studies.ensemble import rows, starts

Load = Callable[[str], Model]


def alone(model: Model, name: str, value: float, initial: dict[str, float], **settings: Any) -> Any:
    """The run of a case by itself."""
    return simulate(model, parameters={name: value}, initial=initial, **settings, seen_every=0.0)


@pytest.mark.every_push("near_singular_slider_crank-quasi_static")
@pytest.mark.parametrize(
    "name, start",
    [
        ("near_singular_slider_crank", "quasi_static"),
        ("flexible_four_bar", "quasi_static"),
        ("flexible_slider_crank_free", "quasi_static_unstable"),
    ],
)
def test_lanes_settle_to_the_bits_of_a_run(
    built_in: Load, name: str, start: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without a start by Python, and without a case that is run by itself."""
    model = built_in(name)
    mass = next(
        entry for entry in model.parameters if entry.kind != "data" and entry.name.endswith(("mass", "inertia"))
    )
    given, turned = mass.default * np.array([1.0, 1.2, 1.5]), model.q_i[0]
    speed = 0.5 * float(model.initial_q_dot[model.coordinates.index(turned)])
    settings: dict[str, Any] = {"t_end": 3 * model.simulation["dt"], "start": start}
    settings["outputs"] = [*model.elastic[:2], f"{model.elastic[0]}_dot", turned]
    expected = alone(model, mass.name, float(given[2]), {f"{turned}_dot": speed}, **settings)
    monkeypatch.setattr(rows, "run_alone", None)
    monkeypatch.setattr(starts, "start_state", None)
    found = ensemble(model, {mass.name: given}, {f"{turned}_dot": speed}, **settings, seen_every=0.0)
    for output in settings["outputs"]:
        np.testing.assert_array_equal(found[output][2], expected.outputs[output])
    assert np.abs(found[f"{model.elastic[0]}_dot"][:, 0]).max() > 0


@pytest.mark.parametrize("name", ["flexible_four_bar", "physical_slider_crank"])
def test_it_is_the_equilibrium_of_the_general_method(
    built_in: Load, name: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Which never has to be asked here, and finds the same."""
    model = built_in(name)
    p = model.parameter_vector()
    asked: list[int] = []
    monkeypatch.setattr(quasi_static, "balanced", lambda *given: asked.append(1) or balanced(*given))
    quick = start_state(model, p, model.constants(p), 0.0, None, "quasi_static")
    assert not asked
    monkeypatch.setattr(quasi_static, "settled", lambda *given: None)
    general = start_state(model, p, model.constants(p), 0.0, None, "quasi_static")
    assert len(asked) == 9  # at the start, before and behind it, three times
    elastic = [model.coordinates.index(name) for name in model.elastic]
    assert np.abs(general.q[elastic]).max() > 1e-5
    np.testing.assert_allclose(quick.q, general.q, rtol=0, atol=1e-15)
    np.testing.assert_allclose(quick.q_dot, general.q_dot, rtol=0, atol=1e-12 * np.abs(general.q_dot).max())


@pytest.mark.long
def test_a_case_without_an_equilibrium_disturbs_nobody(built_in: Load) -> None:
    """A mode without stiffness at rest: that case is `not_assembled`, as its run by itself is refused."""
    model = built_in("flexible_slider_crank_free")
    name = "rod.K_ff[0,0]"
    stiffness = model.parameter_vector()[[entry.name for entry in model.parameters].index(name)]
    initial = {"crank.theta_dot": 0.0}
    settings: dict[str, Any] = {"t_end": 6e-5, "dt": 2e-5, "outputs": ["rod.q1"], "start": "quasi_static"}
    found = ensemble(model, {name: [stiffness, 0.0, 2 * stiffness]}, initial, **settings, seen_every=0.0)
    assert found["status"].values.tolist() == ["completed", "not_assembled", "completed"]
    assert np.isnan(found["rod.q1"][1]).all()
    expected = alone(model, name, 2 * stiffness, initial, **settings)
    np.testing.assert_array_equal(found["rod.q1"][2], expected.outputs["rod.q1"])

"""Drift: constraints hold at position and velocity level throughout, with every scheme that closes loops."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime import SCHEMES, simulate
from runtime.model import Model
from runtime.solutions import observe
from runtime.solutions.observe import assemble_solution

Load = Callable[[str], Model]
STEPS = {"four_bar": 5e-3, "slider_crank": 2e-4, "flexible_slider_crank": 4e-5, "near_singular_slider_crank": 1e-4}

# where the run says that at this step its error passes a tenth of an amplitude
COARSE = {("coupled", "four_bar")}


@pytest.mark.every_push("rk4-four_bar", "printed-flexible_slider_crank", "coupled-four_bar", "exponential-slider_crank")
@pytest.mark.parametrize("name", STEPS)
@pytest.mark.parametrize("scheme", SCHEMES)
def test_constraints_hold_at_both_levels(built_in: Load, name: str, scheme: str) -> None:
    """At coarse steps, prescribed motion included: C to 1e-10 m, its rate to 1e-10 of the fastest coordinate."""
    run = simulate(
        built_in(name), scheme=scheme, dt=STEPS[name], t_end=200 * STEPS[name], seen_every=3 * STEPS[name], force=True
    )
    assert run.status.name == ("inaccurate" if (scheme, name) in COARSE else "completed")
    assert run.constraint_error.max() < 1e-10
    assert run.constraint_rate_error.max() < 1e-10 * max(1.0, np.abs(run.q_dot).max())


def test_observation_closes_what_a_step_leaves_open(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    settings = {
        "scheme": "single_rate",
        "dt": 2e-2,
        "t_end": 2.0,
        "seen_every": 0.0,
        "options": {"closure_iterations": 1},
    }
    model = built_in("four_bar")
    assert simulate(model, **settings).constraint_error.max() < 1e-11  # type: ignore[arg-type]
    monkeypatch.setattr(observe, "MOST_OBSERVED_CLOSURES", 0)
    assert simulate(model, **settings).constraint_error.max() > 1e-11  # type: ignore[arg-type]


def test_the_rate_error_is_the_time_derivative_of_the_constraints(built_in: Load) -> None:
    """At rates that do not satisfy them, and with a prescribed motion: C_q q_dot + C_t by differences of C."""
    model = built_in("flexible_slider_crank")
    p = model.parameter_vector()
    c, h, t = model.constants(p), 1e-6, 0.3
    rng = np.random.default_rng(1)
    q, v = rng.normal(0, 0.1, (2, len(model.coordinates)))
    kernel = model.kernel("constraints")

    def C(time: float) -> np.ndarray:
        values = {"q": q + (time - t) * v, "q_dot": v, "t": time, "c": c}
        return np.asarray(kernel(**{name: ca.DM(values[name]) for name in kernel.name_in()})["C"]).ravel()

    found = assemble_solution(
        model, np.array([t]), q[None], v[None], 0 * v[None], p, c, "", 0.0, [], {}, simulate(model, t_end=1e-4).status
    )
    assert found.constraint_rate_error[0] == pytest.approx(np.abs(C(t + h) - C(t - h)).max() / (2 * h), rel=1e-7)

"""Velocities predicted with the last acceleration: second order too, and the path of large trees."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import reference_solution, simulate
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from symgen.scene import SceneRecord
from symgen.scenes.pendulums import chain


def errors(model: Model, steps: np.ndarray, t_end: float, **options: object) -> np.ndarray:
    exact = reference_solution(model, t_end=t_end, rtol=1e-12, atol=1e-13).q_i[-1]
    return np.array(
        [
            np.abs(
                simulate(model, t_end=t_end, dt=float(dt), scheme="single_rate", samples=1, options=options).q_i[-1]
                - exact
            ).max()
            for dt in steps
        ]
    )


@pytest.mark.parametrize(("choice", "cap"), [("newton", 3e-7), ("predictor", 2e-6)])
def test_both_velocities_are_second_order(built_in: Callable[[str], Model], choice: str, cap: float) -> None:
    steps = np.array([1e-3, 5e-4, 2.5e-4])
    found = errors(built_in("double_pendulum"), steps, 1.0, common_velocity=choice)
    assert abs(np.polyfit(np.log(steps), np.log(found), 1)[0] - 2.0) < 0.1
    assert found[-1] < cap


@pytest.mark.long
def test_large_trees_take_the_linear_path(model_of: Callable[[SceneRecord], Model]) -> None:
    """14 links: no Jacobian and no M_hat in the step, an order of magnitude fewer operations, second order."""
    model = model_of(chain(14))
    plan = make_plan(model, 0.1, 1e-3, None, "single_rate", 1, None, 0.0)
    newton = make_plan(model, 0.1, 1e-3, None, "single_rate", 1, {"common_velocity": "newton"}, 0.0)
    by_tree, by_mass = (int(p.scheme.program().stage.n_instructions()) for p in (plan, newton))  # type: ignore[union-attr]
    assert by_tree < 0.4 * by_mass
    steps = np.array([1e-3, 5e-4, 2.5e-4])
    found = errors(model, steps, 0.5)
    assert abs(np.polyfit(np.log(steps), np.log(found), 1)[0] - 2.0) < 0.1
    assert found[-1] < 1e-3


Load = Callable[[str], Model]


ORDERS = {"single_rate": 3, "printed": 3, "rk4": 2, "exponential": 3, "exponential_rk4": 3, "dop853": 2}


@pytest.mark.parametrize("scheme, order", ORDERS.items())
def test_closure_is_predicted(built_in: Load, scheme: str, order: int) -> None:
    """C before the only Newton step of an update falls with the order of the guess: leapfrog, tangent, parabola."""
    model = built_in("slider_crank")
    found = []
    for dt in (1e-3, 5e-4):
        settings = {"scheme": scheme, "dt": dt, "t_end": 0.05, "options": {"closure_iterations": 1}, "force": True}
        run = simulate(model, engine="interpreted", **settings)  # type: ignore[arg-type]
        found.append(float(run.stats["closure_error"]))
    assert np.log2(found[0] / found[1]) == pytest.approx(order, abs=0.1), found


def test_closure_ahead_is_predicted(built_in: Load) -> None:
    """Leapfrog over major steps H = m h is exact but for the first two, which begin at the start: their guess is that
    of H where the state is held at (H + h) / 2. C there is the same rate times (m - 1) h / 2."""
    model, h = built_in("flexible_slider_crank_free"), 1e-5
    found = []
    for scheme, m, halves in (("coupled", 2, 1), ("coupled", 8, 7)):
        settings = {"m": [m], "dt": m * h, "t_end": 64 * h, "options": {"closure_iterations": 1}, "force": True}
        run = simulate(model, scheme=scheme, engine="interpreted", **settings)  # type: ignore[arg-type]
        found.append(float(run.stats["closure_error"]) / halves)
    assert found == pytest.approx([found[0]] * 2, rel=5e-3), found


def test_a_held_slow_coordinate_starts_where_the_motion_came_from(built_in: Load) -> None:
    """One slow step H before the start, as the motion without dampers played backwards: to third and second order."""
    model, off = built_in("two_oscillators"), []
    undamped, k, v = {"zeta": 0.0}, built_in("two_oscillators").q_i.index("x_L"), np.array([0.7, -0.4])
    for H in (2e-3, 1e-3):
        stepper = Stepper(scheme_kind("coupled").build("coupled", model, H, [4], {}))
        z = stepper.start(0.0, model.initial_q, v, model.constants(model.parameter_vector(undamped)), H)
        back = {f"{name}_dot": -rate for name, rate in zip(model.coordinates, v, strict=True)}
        exact = reference_solution(model, t_end=H, parameters=undamped, initial=back)
        past = [float(z[stepper.scheme.layout.slice(name)][k]) for name in ("x_last", "v_last")]
        off.append(np.abs(np.array(past) - [exact.q[-1, k], -exact.q_dot[-1, k]]))
    assert np.all(np.log2(off[0] / off[1]) > [2.8, 1.8]), off

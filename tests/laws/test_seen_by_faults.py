"""What faults put into the code at random were not seen by: one sharp figure each."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, reference_solution, simulate
from runtime.contract.coordinates import independent
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.step_limit import central_difference_limit
from runtime.schemes.stepper import Stepper
from runtime.studies.stability.limits import usual_steps
from symgen.scene import Scene, SceneRecord

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


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


def test_the_limit_of_a_slow_mechanism() -> None:
    """Frequency 0.1 rad/s without dampers: 20 s, and it is the frequency that sets it."""
    for predicted in (False, True):
        limit = central_difference_limit(np.array([[-0.01]]), np.zeros((1, 1)), predicted=predicted)
        assert limit is not None and limit.h == pytest.approx(20.0, rel=1e-12)
        assert limit.rate == pytest.approx(0.1) and not limit.by_decay


def test_stability_is_looked_at_about_the_fastest_mode(built_in: Load) -> None:
    """Up to four times, and from a fiftieth of, two over the fastest frequency, times the sub-steps."""

    class Modes:
        frequencies = np.array([1.0, 50.0])

    class Exact:
        def modes(self, state: object) -> Modes:
            return Modes()

    steps = usual_steps(built_in("two_oscillators"), [None], Exact(), 1000.0, 3, 5)  # type: ignore[list-item, arg-type]
    assert steps[0] == pytest.approx(0.02 * 0.04 * 3) and steps[-1] == pytest.approx(4 * 0.04 * 3)


def test_sections_of_a_beam_in_space_turn_with_it(model_of: Build) -> None:
    """Inertia about the ends of a thick beam: rho A L^3 / 3 + rho I L, about z with I_z and about y with I_y."""
    rho, A, L, section = 1000.0, 0.04, 0.5, (3e-4, 7e-4)
    for axis, own in (((0.0, 0.0, 1.0), section[0]), ((0.0, 1.0, 0.0), section[1])):
        place = {"axis": axis}
        builder = Scene("thick", space="spatial").ground(markers={"pin": place})
        builder.beam(
            "beam",
            length=L,
            density=rho,
            area=A,
            second_moment=section[0],
            second_moment_z=section[1],
            youngs_modulus=1e9,
            lateral={"ends": "clamped-free", "modes": 1},
            markers={"pin": {"at": 0.0, **place}},
        )
        model = model_of(builder.revolute("pin", "ground.pin", "beam.pin").build())
        k, c = model.q_i.index("pin.angle"), model.constants(model.parameter_vector())
        q, still = model.initial_q, np.zeros(len(model.coordinates))
        d, (q_i, q_i_dot) = model.dependent_columns, independent(model, q, still)
        at = {"q_i": q_i, "q_d": q[d], "q_i_dot": q_i_dot, "q_d_dot": still[d]}
        found = float(np.asarray(model.evaluate("condensed", **at, t=0.0, c=c)["M_hat"])[k, k])
        assert found == pytest.approx(rho * A * L**3 / 3 + rho * own * L, rel=3e-3), axis

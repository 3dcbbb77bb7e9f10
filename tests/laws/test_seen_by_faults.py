"""What faults put into the code at random were not seen by: one sharp figure each."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime import Model, reference_solution, simulate
from runtime.schemes.step_limit import central_difference_limit
from runtime.studies.stability.limits import usual_steps
from symgen.scene import Scene, SceneBuilder

Load = Callable[[str], Model]
Build = Callable[[Scene], Model]


@pytest.mark.parametrize("scheme, order", [("single_rate", 2), ("printed", 2), ("rk4", 2)])
def test_closure_is_predicted(built_in: Load, scheme: str, order: int) -> None:
    """C before the only Newton step of an update falls with the order of the guess: without one, by halves."""
    model = built_in("slider_crank")
    found = []
    for dt in (2e-3, 1e-3):
        run = simulate(model, scheme=scheme, dt=dt, t_end=0.1, options={"closure_iterations": 1}, force=True)
        found.append(float(run.stats["closure_error"]))
    assert np.log2(found[0] / found[1]) > order - 0.4, found


def test_a_held_slow_coordinate_starts_with_second_order(model_of: Build) -> None:
    """One major step of `coupled` where the slow mass is damped: rates of the held state ahead begin with v + a t."""
    builder = SceneBuilder("damped")
    builder.structure(
        coordinates=["x", "y"],
        mass=[[1.0, 0.0], [0.0, 1.0]],
        stiffness=[[4.0, -1.0], [-1.0, 9.0]],
        damping=[[3.0, -1.0], [-1.0, 1.0]],
    )
    builder.groups(L=["x"], S=["y"]).initial({"x": 1.0, "y": 0.5})
    model = model_of(builder.simulation(t_end=0.1, dt=0.01, m=[4]).build())
    off = []
    for dt in (0.04, 0.02, 0.01):
        run = simulate(model, scheme="coupled", m=[4], dt=dt, t_end=dt)
        exact = reference_solution(model, t_end=dt)
        off.append(np.abs(run.q_dot[-1] - exact.q_dot[-1]).max())
    assert (np.log2(np.array(off[:-1]) / off[1:]) > 2.6).all(), off


def test_the_limit_of_a_slow_mechanism() -> None:
    """Frequency 0.1 rad/s: 20 s."""
    limit = central_difference_limit(np.array([[-0.01]]), np.zeros((1, 1)), predicted=False)
    assert limit is not None and limit.h == pytest.approx(20.0, rel=1e-12)


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
        builder = SceneBuilder("thick", space="spatial").ground(markers={"pin": place})
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
        i, d = model.independent_columns, model.dependent_columns
        at = {"q_i": q[i], "q_d": q[d], "q_i_dot": still[i], "q_d_dot": still[d]}
        found = float(np.asarray(model.evaluate("condensed", **at, t=0.0, c=c)["M_hat"])[k, k])
        assert found == pytest.approx(rho * A * L**3 / 3 + rho * own * L, rel=3e-3), axis

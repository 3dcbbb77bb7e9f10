"""Single-rate central difference: second order with velocity-dependent forces, energy, reversal, momentum."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest

from runtime import simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.support.model_values import Array, evaluate, make_state

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]

# scene -> (t_end [s], coarsest step [s], cap on the error at the finest of three steps [m, rad]; measured: two thirds)
ORDERS: dict[str, tuple[float, float, float]] = {
    "double_pendulum": (2.0, 4e-3, 9e-6),  # centrifugal forces
    "slider_crank": (0.02, 4e-5, 1.5e-6),  # the same through a loop closure
    "elastic_pendulum": (2.0, 4e-3, 9e-6),  # a damper
    "flexible_slider_crank_free": (0.004, 4e-6, 9e-8),  # centrifugal forces on stiff modes
    "flexible_slider_crank_torque": (0.02, 4e-5, 3e-8),  # modal damping
    "hub_beam": (0.8, 4e-3, 1.3e-6),  # strong inertia coupling
}


def run(model: Model, dt: float, t_end: float, samples: int = 10, **given: object) -> Array:
    """q at `samples` equal times."""
    every = round(t_end / dt / samples)
    solution = simulate(model, t_end=t_end, dt=dt, scheme="single_rate", seen_every=every * dt, **given)  # type: ignore[arg-type]
    assert solution.status.ok, solution.status
    return solution.q


@pytest.mark.every_push("hub_beam", "elastic_pendulum", "flexible_slider_crank_free")
@pytest.mark.parametrize("name", ORDERS)
def test_second_order(built_in: Load, name: str) -> None:
    t_end, dt, cap = ORDERS[name]
    model = built_in(name)
    reference = run(model, dt / 64, t_end)
    errors = [np.max(np.abs(run(model, dt / k, t_end) - reference)) for k in (1, 2, 4)]
    slope = np.polyfit(np.log([1.0, 0.5, 0.25]), np.log(errors), 1)[0]
    assert slope == pytest.approx(2.0, abs=0.1), errors
    assert errors[-1] < cap, errors


def leapfrog(model: Model, dt: float, t_end: float, centred: bool) -> Array:
    """q_i(t_end) by hand: forces at v(n - 1/2), or at v(n) with the acceleration iterated (a tree model)."""
    n, steps = len(model.q_i), round(t_end / dt)
    q, d = ca.SX.sym("q", n), ca.SX.sym("d", n)
    kernel = model.function("condensed")

    def acceleration(v: ca.SX) -> ca.SX:
        values = {"q_i": q, "q_i_dot": v, "p": model.parameter_vector()}
        closed = {"q_d": model.function("closure"), "q_d_dot": model.function("velocities")}
        for key, function in closed.items():
            values[key] = function.call({name: values[name] for name in function.name_in()})[
                f"{key}_next" if key == "q_d" else key
            ]
        result = kernel.call({name: values[name] for name in kernel.name_in()})
        return ca.solve(result["M_hat"], result["Q_hat"])

    a = acceleration(d / dt)
    for _ in range(6 if centred else 0):
        a = acceleration(d / dt + dt / 2 * a)
    d_next = d + dt**2 * a
    step = ca.Function("step", [ca.vertcat(q, d)], [ca.vertcat(q + d_next, d_next)])
    start, rate = (x[model.independent_columns] for x in (model.initial_q, model.initial_q_dot))
    state = make_state(model, start, rate)
    condensed = evaluate(model, "condensed", **state.values())
    first = np.linalg.solve(condensed["M_hat"].reshape(n, n), condensed["Q_hat"])
    before = dt * rate - dt**2 / 2 * first
    end = step.mapaccum("steps", steps)(np.concatenate([start, before]))[:, -1]
    return np.asarray(end).ravel()[:n]


def test_forces_at_the_half_step_would_be_first_order(built_in: Load) -> None:
    """The trap the schemes avoid: the same loop with v(n - 1/2) in the forces loses an order, and more than 10 x."""
    model = built_in("double_pendulum")
    columns = model.independent_columns
    reference = run(model, 4e-3 / 64, 2.0)[-1, columns]
    lagging = [np.max(np.abs(leapfrog(model, dt, 2.0, False) - reference)) for dt in (4e-3, 2e-3, 1e-3)]
    slope = np.polyfit(np.log([4.0, 2.0, 1.0]), np.log(lagging), 1)[0]
    assert slope == pytest.approx(1.0, abs=0.15), lagging
    ours = run(model, 1e-3, 2.0)[-1, columns]
    assert lagging[-1] > 10 * np.max(np.abs(ours - reference))
    np.testing.assert_allclose(leapfrog(model, 1e-3, 2.0, True), ours, rtol=0, atol=1e-7)  # by hand, v(n)


# t_end, dt, cap on |energy error| / largest kinetic energy
ENERGIES = {
    "pendulum": (100.0, 1e-2, 4e-4),
    "double_pendulum": (50.0, 2e-3, 1e-3),
    "slider_crank": (1.0, 5e-5, 5e-5),
    "flexible_slider_crank_free": (0.1, 1e-5, 1e-5),
}

COARSE = (
    "double_pendulum",
    "flexible_slider_crank_free",
)  # their motion is off by more than a tenth: chaos, and rod.q3


@pytest.mark.parametrize("name", ENERGIES)
def test_energy_stays_bounded(built_in: Load, name: str) -> None:
    """No drift: the second half of a long undamped run has no larger an error than the first."""
    t_end, dt, cap = ENERGIES[name]
    solution = simulate(built_in(name), t_end=t_end, dt=dt, scheme="single_rate", seen_every=10 * dt)
    assert solution.status.name == ("inaccurate" if name in COARSE else "completed"), solution.status
    error = np.abs(solution.total_energy - solution.total_energy[0]) / np.max(solution.energy["kinetic"])
    half = len(error) // 2
    assert np.max(error[half:]) < 1.5 * np.max(error[:half])
    assert np.max(error) < cap
    assert np.max(solution.constraint_error) < 1e-10


REVERSALS = {
    "pendulum": (2.0, 1e-2),
    "double_pendulum": (1.0, 1e-3),
    "slider_crank": (0.05, 2e-5),
    "flexible_slider_crank_free": (0.005, 1e-5),
}


@pytest.mark.parametrize("name", REVERSALS)
@pytest.mark.parametrize("newton, tolerance", [(4, 1e-12), (1, 1e-10)])
def test_time_reversal(built_in: Load, name: str, newton: int, tolerance: float) -> None:
    """Forward, velocities negated, back: exact with Newton converged, nearly so with the one iteration of default."""
    model, (t_end, dt) = built_in(name), REVERSALS[name]
    given = {
        "t_end": t_end,
        "dt": dt,
        "scheme": "single_rate",
        "samples": 1,
        "options": {"newton_iterations": newton},
    }
    there = simulate(model, **given)  # type: ignore[arg-type]
    end = {model.coordinates[k]: there.q[-1, k] for k in model.independent_columns}
    end |= {f"{model.coordinates[k]}_dot": -there.q_dot[-1, k] for k in model.independent_columns}
    back = simulate(model, initial=end, **given)  # type: ignore[arg-type]
    moved = np.max(np.abs(there.q[-1] - there.q[0]))
    speed = np.max(np.abs(there.q_dot))
    assert moved > 0.1
    assert np.max(np.abs(back.q[-1] - there.q[0])) < tolerance * max(1.0, moved)
    assert np.max(np.abs(back.q_dot[-1] + there.q_dot[0])) < tolerance * speed


def test_angular_momentum_of_a_central_force(built_in: Load) -> None:
    """Constant mass matrix, central force: kept to rounding."""
    s = simulate(
        built_in("elastic_pendulum"),
        t_end=20.0,
        dt=1e-3,
        parameters={"gravity.y": 0.0, "spring.damping": 0.0},
        initial={"bob.x_dot": 1.0, "bob.y_dot": 0.5, "bob.theta_dot": 2.0},
    )
    momentum = s["bob.x"] * s.rate("bob.y") - s["bob.y"] * s.rate("bob.x")
    assert momentum[0] == pytest.approx(1.1, rel=1e-12)
    np.testing.assert_allclose(momentum, momentum[0], rtol=1e-12)


def test_momenta_of_two_bodies_on_a_spring(model_of: Build) -> None:
    builder = Scene("pair")
    builder.rigid("a", mass=1.0, inertia=0.1, free=True, markers={"p": {"position": (0.3, 0.1)}})
    builder.rigid("b", mass=2.0, inertia=0.3, free=True, markers={"p": {"position": (-0.2, 0)}})
    builder.spring_damper("s", "a.p", "b.p", stiffness=200.0, damping=1.0, free_length=0.5)
    builder.initial({"b.x": 1.2}).rates({"a.x": 1.0, "b.y": 2.0, "a.theta": 3.0})
    s = simulate(model_of(builder.build()), t_end=5.0, dt=1e-3, scheme="single_rate", seen_every=0.01)
    linear = [s.rate(f"a.{axis}") + 2 * s.rate(f"b.{axis}") for axis in "xy"]
    spin = 0.1 * s.rate("a.theta") + 0.3 * s.rate("b.theta")
    for mass, body in ((1.0, "a"), (2.0, "b")):
        spin = spin + mass * (s[f"{body}.x"] * s.rate(f"{body}.y") - s[f"{body}.y"] * s.rate(f"{body}.x"))
    for momentum in (*linear, spin):
        np.testing.assert_allclose(momentum, momentum[0], rtol=1e-11)
    assert np.ptp(s.total_energy) > 0.1  # the damper works


def flying_beam_errors(model: Model, dt: float) -> Array:
    """Largest change of (P_x, P_y, angular momentum about the world origin)."""
    solution = simulate(model, t_end=0.1, dt=dt, scheme="single_rate", seen_every=1e-3)
    momenta = []
    for q, q_dot in zip(solution.q, solution.q_dot, strict=True):
        p = evaluate(model, "augmented", q=q, q_dot=q_dot, t=0.0)["M"].reshape(6, 6) @ q_dot
        momenta.append([p[0], p[1], p[2] + q[0] * p[1] - q[1] * p[0]])
    return np.max(np.abs(np.array(momenta) - momenta[0]), axis=0)


def test_momenta_of_a_flying_beam(model_of: Build) -> None:
    """A deforming body in free flight: momenta are kept to the scheme's second order (P = 0.27, L = 0.2)."""
    builder = Scene("flying_beam").beam(
        "beam",
        length=1.0,
        density=2700.0,
        area=1e-4,
        second_moment=1e-9,
        youngs_modulus=7e10,
        free=True,
        lateral={"ends": "free-free", "modes": 2},
        axial={"ends": "free-free", "modes": 1},
    )
    builder.initial({"beam.q1": 0.01, "beam.q2": 0.002, "beam.q3": 1e-5})
    builder.rates({"beam.theta": 3.0, "beam.x": 1.0, "beam.y": -0.5})
    model = model_of(builder.build())
    coarse, fine = (flying_beam_errors(model, dt) for dt in (2e-5, 1e-5))
    np.testing.assert_allclose(coarse / fine, 4.0, rtol=0.15)
    assert np.all(fine < [2e-10, 3e-11, 6e-8])

"""A model as x' = f(x, u, p, t): in SciPy, in CasADi's integrators and optimiser, against runs and a motion by hand."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca
import numpy as np
import pytest
from scipy.integrate import solve_ivp

from runtime import ModelError, simulate
from runtime.model import Model
from symgen.scene import Scene, SceneRecord

Load = Callable[[str], Model]
Build = Callable[[SceneRecord], Model]


@pytest.mark.parametrize("name", ["four_bar", "tumbling_body"])
def test_scipy_goes_the_way_of_a_run(built_in: Load, name: str) -> None:
    model, end = built_in(name), 0.2
    ode = model.ode()
    assert not [entry for entry in ode.x if "turn_" in entry] and len(ode.x) == ode.f.size1_in("x")

    def slope(t: float, x: np.ndarray) -> np.ndarray:
        return np.asarray(ode.f(x, ode.u0, ode.p0, t)).ravel()

    found = solve_ivp(slope, (0.0, end), ode.x0, method="DOP853", rtol=1e-11, atol=1e-12)
    run = simulate(model, t_end=end, dt=1e-4, scheme="rk4", seen_every=0.2)
    for k, entry in enumerate(ode.x):
        assert found.y[k, -1] == pytest.approx(run[entry][-1], rel=1e-7, abs=1e-7), entry


def test_algebraic_loops_move_as_states_do(built_in: Load) -> None:
    """Collocation of CasADi on f and C_loop = 0, and the same with loop unknowns that are integrated."""
    model, end = built_in("bricard"), 0.05
    states, loops = model.ode("states"), model.ode("algebraic")
    assert loops.x + loops.z == states.x and not loops.u
    assert np.abs(np.asarray(loops.g(loops.x0, loops.z0, loops.u0, loops.p0, 0.0))).max() < 1e-9
    x, z = ca.SX.sym("x", len(loops.x)), ca.SX.sym("z", len(loops.z))
    at = (loops.u0, loops.p0, 0.0)
    problem = {"x": x, "z": z, "ode": loops.f(x, z, *at), "alg": loops.g(x, z, *at)}
    options = {"number_of_finite_elements": 40, "interpolation_order": 4}
    found = ca.integrator("loops", "collocation", problem, 0.0, end, options)(x0=loops.x0, z0=loops.z0)
    y = ca.SX.sym("y", len(states.x))
    plain = ca.integrator("states", "collocation", {"x": y, "ode": states.f(y, *at)}, 0.0, end, options)(x0=states.x0)
    both = np.concatenate([np.asarray(found["xf"]).ravel(), np.asarray(found["zf"]).ravel()])
    assert both == pytest.approx(np.asarray(plain["xf"]).ravel(), rel=1e-7, abs=1e-8)


def test_jacobians_are_slopes(built_in: Load) -> None:
    ode = built_in("flexible_slider_crank_free").ode("algebraic")
    at = [ode.x0, ode.z0, ode.u0, ode.p0, 0.0]
    found = ode.jacobian.call(dict(zip(ode.jacobian.name_in(), at, strict=True)))
    step = 1e-6
    for name, place in (("x", 0), ("z", 1)):
        for function in (ode.f, ode.g):
            columns = []
            for unit in np.eye(len(at[place])):
                ahead, behind = (
                    function(*(value + side * step * unit if k == place else value for k, value in enumerate(at)))
                    for side in (1, -1)
                )
                columns.append(np.asarray(ahead - behind).ravel() / (2 * step))
            slope, expected = np.asarray(found[f"d{function.name()}_d{name}"]), np.array(columns).T
            assert slope == pytest.approx(expected, rel=1e-4, abs=1e-6 * max(1.0, np.abs(expected).max()))


def test_the_cheapest_push_from_rest_to_rest(model_of: Build) -> None:
    """A mass of 2 kg over 0.6 m in 1.5 s by Opti: u = 6 m L (T - 2 t) / T^3 has the least integral of u^2, 12 m^2 L^2
    / T^3; Hermite-Simpson collocation is exact for its cubic motion."""
    mass, way, end, steps = 2.0, 0.6, 1.5, 10
    scene = Scene("slider").rigid("cart", mass=mass, inertia=1.0)
    scene.prismatic("rail", "ground.origin", "cart.origin").input("push", unit="N").effort("m", "rail.travel", "push")
    ode = model_of(scene.build()).ode()
    assert (ode.x, ode.u) == (["cart.x", "cart.x_dot"], ["push"])
    opti, h = ca.Opti(), end / steps
    X, U = opti.variable(2, 2 * steps + 1), opti.variable(1, 2 * steps + 1)
    F = [ode.f(X[:, k], U[:, k], ode.p0, 0.0) for k in range(2 * steps + 1)]
    cost = 0
    for k in range(0, 2 * steps, 2):
        opti.subject_to(X[:, k + 2] == X[:, k] + h / 6 * (F[k] + 4 * F[k + 1] + F[k + 2]))
        opti.subject_to(X[:, k + 1] == (X[:, k] + X[:, k + 2]) / 2 + h / 8 * (F[k] - F[k + 2]))
        cost += h / 6 * (U[k] ** 2 + 4 * U[k + 1] ** 2 + U[k + 2] ** 2)
    opti.subject_to(X[:, 0] == 0)
    opti.subject_to(X[:, -1] == ca.vertcat(way, 0))
    opti.minimize(cost)
    opti.solver("ipopt", {"print_time": False}, {"print_level": 0, "sb": "yes"})
    solution = opti.solve()
    t = np.linspace(0, end, 2 * steps + 1)
    assert solution.value(U) == pytest.approx(6 * mass * way * (end - 2 * t) / end**3, abs=1e-6)
    assert solution.value(cost) == pytest.approx(12 * mass**2 * way**2 / end**3, rel=1e-8)


def test_what_is_no_such_system_is_refused(built_in: Load, model_of: Build) -> None:
    with pytest.raises(ModelError, match="states.*algebraic"):
        built_in("bricard").ode("open")
    ball = Scene("ball").rigid("b", mass=1.0, inertia=1.0, free=True).measure("y", "y", "b.origin")
    with pytest.raises(ModelError, match="event"):
        model_of(ball.event("floor", "y + 1", terminal=True).build()).ode()


def test_integrators_of_casadi_need_more_steps_for_vibrations(built_in: Load) -> None:
    """As the guide says: 10,000 internal steps do not last for 0.05 s of a vibrating rod; with more it is the run."""
    model = built_in("flexible_slider_crank_free")
    ode, end = model.ode(), 0.05
    x = ca.SX.sym("x", len(ode.x))
    problem, exact = {"x": x, "ode": ode.f(x, ode.u0, ode.p0, 0)}, {"reltol": 1e-8, "abstol": 1e-10}
    with pytest.raises(RuntimeError, match="CV_TOO_MUCH_WORK"):
        ca.integrator("few", "cvodes", problem, 0, end, exact)(x0=ode.x0)
    more = {**exact, "max_num_steps": 100_000}
    found = np.asarray(ca.integrator("end", "cvodes", problem, 0, end, more)(x0=ode.x0)["xf"]).ravel()
    run = simulate(model, t_end=end, dt=1e-6, scheme="rk4", seen_every=end, error="off")
    for entry in ("crank.theta", "crank.theta_dot", "rod.q1"):
        assert found[ode.x.index(entry)] == pytest.approx(run[entry][-1], rel=1e-4), entry

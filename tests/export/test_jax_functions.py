"""Emitted functions in JAX: the values of CasADi, derivatives by laws and by CasADi, batches, refusals by name."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import Any

import casadi as ca
import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, ModelError, simulate
from runtime.gradients import Formula
from symgen.scene import Scene, SceneRecord
from tests.support.input_scenes import cart
from tests.support.model_values import random_states

jax = pytest.importorskip("jax", reason="needs the extra jax: pip install 'symgen[jax]'")
import jax.numpy as jnp  # noqa: E402

Build = Callable[[SceneRecord], Model]
Load = Callable[[str], Model]

SCENES = [
    "pendulum",
    "double_pendulum",
    "elastic_pendulum",
    "flexible_joint_arm",
    "four_bar",
    "flexible_slider_crank",
    "hub_beam",
    "heavy_top",
    "flyball_governor",
    "spatial_slider_crank",
]
LONGEST_COMPILED = 400  # operations: XLA takes some 3 ms for each


@pytest.fixture(autouse=True)
def bits() -> Iterator[None]:
    """JAX computes with 64 bits meanwhile."""
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


def some_arguments(model: Model, function: ca.Function, seed: int = 4) -> dict[str, np.ndarray]:
    """Near a state of the mechanism, but off its constraints, so that no result is a rounding error alone."""
    rng, state = np.random.default_rng(seed), random_states(model, 1)[0].values()
    found = {}
    for name in function.name_in():
        size = function.numel_in(name)
        near = np.ravel(state[name]) if np.size(state.get(name, [])) == size else np.zeros(size)
        found[name] = near + 0.01 * rng.uniform(-1, 1, size)
    found["p"] = model.parameter_vector()[: function.numel_in("p")] * rng.uniform(0.99, 1.01, function.numel_in("p"))
    return found


def apart(found: Any, expected: Any) -> float:
    """Largest difference, over the largest number."""
    found, expected = np.asarray(found), np.asarray(ca.densify(expected))
    if not expected.size:
        return 0.0
    assert np.isfinite(expected).all()
    return float(np.abs(found.reshape(expected.shape) - expected).max() / max(np.abs(expected).max(), 1e-300))


@pytest.mark.every_push("pendulum")
@pytest.mark.parametrize("name", SCENES)
def test_all_functions_have_the_values_of_casadi(built_in: Load, name: str) -> None:
    """Operation by operation; what XLA makes of them is the next test's."""
    model = built_in(name)
    for key in model.builders:
        function = model.function(key)
        given = some_arguments(model, function)
        expected = function.call(given)
        traced = model.to_jax(key)
        assert list(traced.inputs) == function.name_in() and list(traced.outputs) == function.name_out()
        with jax.disable_jit():
            found = traced(**given)
        for output in function.name_out():
            assert found[output].shape == traced.outputs[output]
            assert apart(found[output], expected[output]) < 1e-13, (key, output)


@pytest.mark.every_push("pendulum")
@pytest.mark.parametrize("name", SCENES)
def test_compiled_functions_have_the_values_of_casadi(built_in: Load, name: str) -> None:
    """One by one, and many of them by vmap."""
    model = built_in(name)
    for key in ("condensed", "forward_dynamics", "dQ_hat_dq_i", "measures", "energy"):
        if not model.has(key) or model.to_jax(key).operations > LONGEST_COMPILED:
            continue
        function, traced = model.function(key), model.to_jax(key)
        cases = [some_arguments(model, function, seed) for seed in (5, 6, 7)]
        batch = {argument: np.array([case[argument] for case in cases]) for argument in function.name_in()}
        many, one = jax.vmap(lambda given, call=traced: call(**given))(batch), traced(**cases[1])
        for k, case in enumerate(cases):
            expected = function.call(case)
            for output in function.name_out():
                assert apart(many[output][k], expected[output]) < 1e-13, (key, output)
                assert k != 1 or apart(one[output], expected[output]) < 1e-13, (key, output)


@pytest.mark.long
def test_momentum_is_the_derivative_of_the_kinetic_energy(built_in: Load) -> None:
    """dT/dq_dot = M q_dot, a law between two functions; M is symmetric."""
    model = built_in("elastic_pendulum")
    energy, augmented = model.to_jax("energy"), model.to_jax("augmented")
    state = random_states(model, 1)[0]

    def kinetic(q_dot: Any) -> Any:
        return energy(q=state.q, q_dot=q_dot)["kinetic"]

    M = augmented(q=state.q, q_dot=state.q_dot)["M"]
    momentum = M @ state.q_dot
    np.testing.assert_allclose(jax.grad(kinetic)(state.q_dot), momentum, rtol=0, atol=1e-13 * np.abs(momentum).max())
    np.testing.assert_allclose(jax.hessian(kinetic)(state.q_dot), M, rtol=0, atol=1e-13 * np.abs(M).max())


@pytest.mark.long
def test_derivatives_by_parameters_are_those_of_casadi(built_in: Load) -> None:
    model = built_in("double_pendulum")
    function, traced = model.function("condensed"), model.to_jax("condensed")
    given = some_arguments(model, function)
    symbols = {name: ca.SX.sym(name, function.numel_in(name)) for name in function.name_in()}
    slopes = ca.Function("slopes", list(symbols.values()), [ca.jacobian(function(*symbols.values())[1], symbols["p"])])
    found = jax.jacrev(lambda p: traced(**{**given, "p": p})["Q_hat"])(given["p"])
    assert apart(found, slopes(*given.values())) < 1e-13


OPERATIONS: dict[str, Callable[[Any, Any], Any]] = {
    name: lambda a, b, name=name: getattr(ca, name)(a)  # type: ignore[misc]
    for name in "sin cos tan exp asin acos atan sinh cosh tanh asinh atanh floor ceil sign fabs erf expm1 log1p".split()
}
OPERATIONS |= {name: lambda a, b, name=name: getattr(ca, name)(a * a + 1.1) for name in ("sqrt", "log", "acosh")}  # type: ignore[misc]
OPERATIONS |= {name: lambda a, b, name=name: getattr(ca, name)(a, b) for name in "fmin fmax atan2 fmod hypot".split()}  # type: ignore[misc]
OPERATIONS |= {
    "copysign": lambda a, b: ca.copysign(a, b),
    "arithmetic": lambda a, b: (a + b) * (a - b) / (a * a + 2 * b * b) - 1 / a,
    "powers": lambda a, b: a**2 + a**3 + (a * a) ** 1.5 + a ** (-2) + (a * a) ** b,
    "comparisons": lambda a, b: ca.vertcat(a < b, a <= b, ca.eq(a, b), ca.ne(a, b)),
    "logic": lambda a, b: ca.vertcat(ca.logic_and(a > 0, b > 0), ca.logic_or(a > 0, b > 0), ca.logic_not(a > 0)),
    "choice": lambda a, b: ca.if_else(a > b, a * b, ca.sin(a)),
}
POINTS = [(0.3, 0.7), (-0.3, 0.7), (0.6, -0.2), (-0.6, -0.25)]


@pytest.mark.every_push("sin", "powers", "choice")
@pytest.mark.parametrize("name", OPERATIONS)
def test_every_operation(built_in: Load, name: str) -> None:
    """Values and slopes of CasADi, in all four quadrants; of copysign the slope by hand: CasADi's lacks a sign."""
    a, b = ca.SX.sym("a"), ca.SX.sym("b")
    value = ca.densify(ca.vertcat(OPERATIONS[name](a, b)))
    function = ca.Function("operation", [a, b], [value], ["a", "b"], ["y"])
    slopes = ca.Function("slopes", [a, b], [ca.densify(ca.jacobian(value, a)), ca.densify(ca.jacobian(value, b))])
    traced = built_in("pendulum").to_jax(function)
    derivative = jax.jacfwd(lambda a, b: traced(a, b)["y"], (0, 1))
    for point in POINTS:
        assert apart(traced(*point)["y"], function(*point)) < 1e-14
        expected = slopes(*point) if name != "copysign" else (np.sign(point[0] * point[1]), 0.0)
        for found, slope in zip(derivative(*point), expected, strict=True):
            np.testing.assert_allclose(np.ravel(found), np.asarray(slope).ravel(), rtol=1e-13, atol=1e-14)


@pytest.mark.every_push("cubic")
@pytest.mark.parametrize("interpolation", ["linear", "cubic", "monotone"])
def test_tables(model_of: Build, interpolation: Any) -> None:
    """Before, at, between and behind the points: values and slopes of CasADi, and the slope by differences."""
    x = [-1.3, -0.2, 0.1, 0.9, 1.4, 2.2]
    scene = (
        Scene("pushed")
        .table("curve", x=x, y=[0.5, -0.7, 0.0, 1.1, 1.2, -0.4], interpolation=interpolation)
        .rigid("cart", mass=1.0, inertia=0.1)
        .prismatic("rail", "ground.origin", "cart.origin")
        .measure("way", "x", "cart.origin")
        .force("push", "cart.origin", 'table("curve", way)', 0.0)
        .build()
    )
    model = model_of(scene)
    function, traced = model.function("condensed"), model.to_jax("condensed")
    given = some_arguments(model, function)

    def force(q: Any) -> Any:
        return traced(**{**given, "q_i": jnp.reshape(q, 1)})["Q_hat"][0]

    place = np.array([-3.0, *x, 0.5, 1.0, 3.0])
    values, slopes = jax.vmap(force)(place), jax.vmap(jax.grad(force))(place)
    q = ca.SX.sym("q")
    by_casadi = ca.Function("slope", [q], [ca.jacobian(function.call({**given, "q_i": q})["Q_hat"], q)])
    for k, at in enumerate(place):
        expected = float(function.call({**given, "q_i": at})["Q_hat"])
        assert values[k] == pytest.approx(expected, abs=1e-13)
        assert slopes[k] == pytest.approx(float(by_casadi(at)), abs=1e-13)
        if at not in x:
            difference = (force(at + 1e-6) - force(at - 1e-6)) / 2e-6
            assert slopes[k] == pytest.approx(float(difference), abs=1e-8)


@pytest.mark.long
def test_a_loop_of_ones_own_is_the_run(built_in: Load) -> None:
    """rk4 by scan on `ode().f` is `simulate`, and its gradient that of `DifferentiableRun`: two ways to each."""
    model, dt, steps = built_in("double_pendulum"), 1e-3, 50
    system = model.ode()
    f = model.to_jax(system.f)
    p = jnp.asarray(system.p0)

    def step(x: Any, t: Any, p: Any) -> Any:
        k1 = f(x, system.u0, p, t)["x_dot"]
        k2 = f(x + dt / 2 * k1, system.u0, p, t + dt / 2)["x_dot"]
        k3 = f(x + dt / 2 * k2, system.u0, p, t + dt / 2)["x_dot"]
        k4 = f(x + dt * k3, system.u0, p, t + dt)["x_dot"]
        return x + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)

    @jax.jit
    def end(p: Any) -> Any:
        times = dt * jnp.arange(steps)
        return jax.lax.scan(lambda x, t: (step(x, t, p), None), jnp.asarray(system.x0), times)[0]

    run = simulate(model, t_end=steps * dt, dt=dt, scheme="rk4")
    names = [name for name in system.x]
    np.testing.assert_allclose(end(p), [run[name][-1] for name in names], rtol=1e-12)
    by = [
        model.parameters[k].name
        for k in np.flatnonzero(np.asarray(model.kernel("constants").jac_sparsity(0, 0)).any(0))
    ]
    own = DifferentiableRun(model, [names[0]], by, t_end=steps * dt, dt=dt, scheme="rk4", seen_every=dt * steps)
    exact = own.gradient(Formula((names[0],), lambda t, y: y[names[0]][-1]), own.x0)
    found = jax.grad(lambda p: end(p)[0])(p)
    for name, slope in zip(by, exact.derivatives, strict=True):
        assert found[system.p.index(name)] == pytest.approx(slope, rel=1e-9, abs=1e-12)


def test_inputs_and_parameters_that_are_left_out_are_the_models(model_of: Build) -> None:
    """The force on a cart: as a default, a constant, a function of time, and given; constants computed before."""
    model = model_of(cart())

    def force(model: Model, **given: Any) -> float:
        return float(model.to_jax("condensed")(**given)["Q_hat"][0])

    default = force(model)
    assert force(model, u=[default + 2.0]) == default + 2.0
    assert force(model.with_inputs({"force": 1.5})) == 1.5
    moving = model.with_inputs({"force": lambda t: np.sin(2 * t)})
    assert force(moving, t=0.3) == pytest.approx(np.sin(0.6), abs=1e-15)
    assert force(moving, u=[4.0]) == 4.0
    with pytest.raises(ArgumentError, match="'t' of function condensed: is missing"):
        force(moving)
    c = model.to_jax("constants")()["c"]
    assert force(model, c=c) == default
    with pytest.raises(ArgumentError, match="'p' of function condensed: is given beside c"):
        force(model, c=c, p=model.to_jax("condensed").defaults["p"])


@pytest.mark.parametrize(
    "changed, message",
    [
        ({"q_i": [0.1]}, r"'q_i' of function condensed: has shape \(1,\); give 2 numbers"),
        ({"q_i": None}, "'q_i' of function condensed: is missing; it takes q_i, "),
        ({"speed": 1.0}, "'speed' of function condensed: is not taken"),
        ({"q_i": [1j, 0.0]}, "is complex128; give real numbers"),
        ({"q_i": ["a", "b"]}, "give real numbers"),
    ],
)
def test_wrong_arguments_are_named(built_in: Load, changed: dict[str, Any], message: str) -> None:
    function = built_in("double_pendulum").to_jax("condensed")
    given = {name: np.zeros(size) for name, size in function.inputs.items()} | changed
    with pytest.raises(ArgumentError, match=message):
        function(**{name: value for name, value in given.items() if value is not None})


def test_what_is_not_translated_is_refused_by_name(built_in: Load) -> None:
    model, a, b = built_in("pendulum"), ca.SX.sym("a"), ca.SX.sym("b")
    with pytest.raises(ModelError, match="function beyond: has the operation 'remainder', which is not translated"):
        model.to_jax(ca.Function("beyond", [a, b], [ca.remainder(a, b)]))
    x = ca.MX.sym("x", 2)
    with pytest.raises(ModelError, match="function matrix: is not straight-line code"):
        model.to_jax(ca.Function("matrix", [x], [ca.norm_2(x)]))
    with pytest.raises(ModelError, match="has no function 'condense'"):
        model.to_jax("condense")
    with pytest.raises(ArgumentError, match="function: is a int; give a name"):
        model.to_jax(3)  # type: ignore[arg-type]


def test_32_bits_are_refused(built_in: Load) -> None:
    """Where the function is made, and where it is called."""
    model = built_in("pendulum")
    function = model.to_jax("condensed")
    jax.config.update("jax_enable_x64", False)
    for call in (lambda: model.to_jax("condensed"), lambda: function(**dict.fromkeys(function.inputs, 0.0))):
        with pytest.raises(ArgumentError, match=r"needs 64 bits.*jax_enable_x64"):
            call()


def test_a_missing_library_is_named_with_its_extra(built_in: Load, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "jax", None)
    with pytest.raises(ImportError, match=r"pip install 'symgen\[jax\]'"):
        built_in("pendulum").to_jax("condensed")


def test_functions_of_parameters_are_functions_themselves(built_in: Load) -> None:
    """`model.function` of what takes p: it raised CasADi's own error."""
    model = built_in("pendulum")
    p = model.parameter_vector()
    assert np.array_equal(np.asarray(model.function("constants")(p)).ravel(), model.constants(p))

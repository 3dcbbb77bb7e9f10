"""A run as one operation of JAX: values, gradients against the run itself and against differences, batches, errors."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import Any

import casadi as ca
import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, as_jax
from runtime.gradients import Formula, run_in_jax

jax = pytest.importorskip("jax", reason="needs the extra jax: pip install 'symgen[jax]'")
import jax.numpy as jnp  # noqa: E402

Load = Callable[[str], Model]
BY = ["slider.mass", "crank.theta_dot", "rod.mass"]


@pytest.fixture(autouse=True)
def bits() -> Iterator[None]:
    """JAX computes with 64 bits meanwhile."""
    before = jax.config.jax_enable_x64
    jax.config.update("jax_enable_x64", True)
    yield
    jax.config.update("jax_enable_x64", before)


@pytest.fixture
def run(built_in: Load) -> DifferentiableRun:
    model = built_in("flexible_slider_crank_free")
    return DifferentiableRun(
        model, ["slider.x", "rod.q1"], BY, t_end=2e-3, dt=2e-5, scheme="exponential_rk4", samples=10
    )


def loss(y: Any) -> Any:
    return jnp.sum(y[:, 0] ** 2) + 100 * jnp.sum(jnp.sin(y[:, 1]))


SAME = Formula(("slider.x", "rod.q1"), lambda t, y: ca.sumsqr(y["slider.x"]) + 100 * ca.sum1(ca.sin(y["rod.q1"])))


@pytest.mark.every_push("forward")
@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_values_and_gradients_are_those_of_the_run(run: DifferentiableRun, mode: str) -> None:
    """By itself and compiled; against differences of the run, too."""
    f, x = as_jax(run, mode), jnp.asarray(run.x0)
    assert np.array_equal(f(x), run.values(run.x0)) and np.array_equal(jax.jit(f)(x), run.values(run.x0))
    own = run.gradient(SAME, run.x0, mode)
    for both in (jax.value_and_grad(lambda x: loss(f(x))), jax.jit(jax.value_and_grad(lambda x: loss(f(x))))):
        value, slope = both(x)
        assert value == pytest.approx(own.value, rel=1e-13)
        np.testing.assert_allclose(slope, own.derivatives, rtol=1e-12)
    for k in range(len(BY)):
        step = 1e-5 * float(x[k])
        sides = [float(loss(jnp.asarray(run.values(np.asarray(x.at[k].add(sign * step)))))) for sign in (1, -1)]
        assert slope[k] == pytest.approx((sides[0] - sides[1]) / (2 * step), rel=1e-5)


@pytest.mark.long
@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_batches(run: DifferentiableRun, mode: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """vmap of values and gradients; the Jacobian by `jacrev`; fewer runs kept than there are cases."""
    monkeypatch.setattr(run_in_jax, "RUNS_KEPT", 1)
    f = as_jax(run, mode)
    points = jnp.asarray(run.x0) * jnp.linspace(0.99, 1.01, 3)[:, None]
    values, slopes = jax.vmap(f)(points), jax.vmap(jax.grad(lambda x: loss(f(x))))(points)
    for k, x in enumerate(points):
        assert np.array_equal(values[k], run.values(np.asarray(x)))
        np.testing.assert_allclose(slopes[k], run.gradient(SAME, np.asarray(x), mode).derivatives, rtol=1e-12)
    exact = run.jacobian(run.x0).derivatives
    np.testing.assert_allclose(jax.jacrev(f)(points[1]), exact, rtol=0, atol=1e-12 * np.abs(exact).max())


def test_a_way_back_does_not_run_forward_again(run: DifferentiableRun, monkeypatch: pytest.MonkeyPatch) -> None:
    """One recorded run for a value and its gradient, as of the run itself."""
    made: list[str] = []
    record = DifferentiableRun.record
    monkeypatch.setattr(DifferentiableRun, "record", lambda self, *given: made.append("run") or record(self, *given))
    monkeypatch.setattr(DifferentiableRun, "values", lambda self, x: made.append("values"))
    f = as_jax(run, "reverse")
    jax.block_until_ready(jax.value_and_grad(lambda x: loss(f(x)))(jnp.asarray(run.x0)))
    assert made == ["run"]


def test_numbers_of_32_bits_are_taken_where_jax_has_64(run: DifferentiableRun) -> None:
    f, x = as_jax(run), jnp.asarray(run.x0, dtype=jnp.float32)
    assert np.array_equal(f(x), run.values(np.asarray(x, dtype=float)))
    assert jax.grad(lambda x: loss(f(x)))(x).dtype == jnp.float32


def test_what_cannot_be_used_is_named(run: DifferentiableRun, monkeypatch: pytest.MonkeyPatch) -> None:
    f = as_jax(run)
    with pytest.raises(
        ArgumentError, match=r"x: has shape \(2,\); give 3 values: slider.mass, crank.theta_dot, rod.mass"
    ):
        f(jnp.zeros(2))
    with pytest.raises(Exception, match="x: the value of slider.mass is nan"):  # JAX's own error, its text ours
        jax.block_until_ready(f(jnp.array([jnp.nan, 1.0, 1.0])))
    with pytest.raises(ArgumentError, match="run: cannot be"):
        as_jax(run.model)  # type: ignore[arg-type]
    with pytest.raises(ArgumentError, match="mode: is 'back'"):
        as_jax(run, "back")
    jax.config.update("jax_enable_x64", False)
    for call in (lambda: as_jax(run), lambda: f(jnp.zeros(3))):
        with pytest.raises(ArgumentError, match=r"needs 64 bits.*jax_enable_x64"):
            call()
    monkeypatch.setitem(sys.modules, "jax", None)
    with pytest.raises(ImportError, match=r"pip install 'symgen\[jax\]'"):
        as_jax(run)

"""A run as one operation of PyTorch: values, gradients against the run itself and by gradcheck, batches, errors."""

from __future__ import annotations

import sys
from collections.abc import Callable

import numpy as np
import pytest

from runtime import ArgumentError, DifferentiableRun, Model, NoResult, as_torch

Load = Callable[[str], Model]
BY = ["slider.mass", "crank.theta_dot", "rod.mass"]


@pytest.fixture
def run(built_in: Load) -> DifferentiableRun:
    model = built_in("flexible_slider_crank_free")
    return DifferentiableRun(
        model, ["slider.x", "rod.q1"], BY, t_end=2e-3, dt=2e-5, scheme="exponential_rk4", samples=10
    )


@pytest.mark.parametrize("mode", ["forward", "reverse"])
def test_values_and_gradients_are_those_of_the_run(run: DifferentiableRun, mode: str) -> None:
    """Of one case and of several; PyTorch's own check by differences."""
    torch = pytest.importorskip("torch", reason="needs the extra torch: pip install 'symgen[torch]'")
    f = as_torch(run, mode)
    points = run.x0 * np.linspace(0.99, 1.01, 6).reshape(2, 3, 1)
    x = torch.tensor(points, requires_grad=True)
    y = f(x)
    bars = np.random.default_rng(0).normal(size=y.shape)
    y.backward(torch.from_numpy(bars))
    for k in np.ndindex(2, 3):
        assert np.array_equal(y.detach()[k], run.values(points[k]))
        np.testing.assert_allclose(x.grad[k], run.pull_back(points[k], bars[k], mode), rtol=1e-13)
    assert not f(x.detach()).requires_grad
    scale, weights = torch.tensor(run.x0), torch.tensor([1.0, 1e4])
    assert torch.autograd.gradcheck(
        lambda s: f(s * scale) * weights, torch.ones(3, dtype=torch.float64, requires_grad=True), rtol=1e-4
    )


def test_what_cannot_be_used_is_named(run: DifferentiableRun) -> None:
    torch = pytest.importorskip("torch", reason="needs the extra torch: pip install 'symgen[torch]'")
    f = as_torch(run)
    with pytest.raises(ArgumentError, match=r"x: is of torch.float32, and a run needs 64 bits; give x.double\(\)"):
        f(torch.zeros(3))
    with pytest.raises(ArgumentError, match=r"x: has shape \(2,\); give 3 values last: slider.mass"):
        f(torch.zeros(2, dtype=torch.float64))
    with pytest.raises(ArgumentError, match="x: is a list; give a tensor"):
        f([1.0, 1.0, 1.0])
    with pytest.raises(ArgumentError, match="the value of slider.mass is nan"):
        f(torch.tensor([np.nan, 1.0, 1.0], dtype=torch.float64))
    with pytest.raises((ArgumentError, NoResult)):
        f(torch.tensor([1.0, np.inf, 1.0], dtype=torch.float64))


def test_a_missing_library_is_named_with_its_extra(run: DifferentiableRun, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(ImportError, match=r"pip install 'symgen\[torch\]'"):
        as_torch(run)
    with pytest.raises(ArgumentError, match="run: cannot be"):
        as_torch(run.model)  # type: ignore[arg-type]

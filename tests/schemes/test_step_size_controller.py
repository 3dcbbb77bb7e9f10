"""The step size controller against the formula of Hairer, Norsett & Wanner (II.4), by hand."""

from __future__ import annotations

import casadi as ca
import pytest

from runtime.schemes.step_size_controller import Closure, StepSizeController


def proposed(controller: StepSizeController, error: float, peak: float, closure: Closure | None = None) -> float:
    """h_next / h."""
    return float(ca.evalf(controller.propose(ca.SX(error**2), ca.SX(peak**2), closure)))


@pytest.mark.parametrize(("order", "error", "factor"), [
    (1, 2.0, 0.25),  # 0.5 / 2
    (5, 16.0, 0.5),  # (0.5 / 16)^(1/5) = 2^-1
    (2, 1e3, 0.1),  # at most so much shorter
    (2, float("inf"), 0.1), (2, float("nan"), 0.1),
])  # fmt: skip
def test_too_large_an_error_shortens_the_next_step(order: int, error: float, factor: float) -> None:
    assert proposed(StepSizeController(order), error, error) == pytest.approx(factor, rel=1e-12)


def test_longer_steps_wait_for_the_peak_and_are_bounded() -> None:
    """An error that passes through zero asks for nothing while its peak was in the band just now."""
    controller = StepSizeController(2)
    assert proposed(controller, 1e-9, 0.5) == pytest.approx(1.0, rel=1e-12)
    assert proposed(controller, 1e-9, 0.125) == pytest.approx(2.0, rel=1e-12)  # (0.5 / 0.125)^(1/2)
    assert proposed(controller, 0.0, 0.0) == 5.0


@pytest.mark.parametrize(("error", "accepted"), [(0.0, True), (1.5, True), (2.5, False), (float("nan"), False)])
def test_what_is_accepted(error: float, accepted: bool) -> None:
    assert bool(ca.evalf(StepSizeController(5).judge(ca.SX(error**2), None))) is accepted


def test_loops_that_do_not_close_reject_a_step_and_shorten_the_next() -> None:
    """C goes as h^3: four times what is allowed, and half of that aimed at, needs half of the step."""
    controller, closure = StepSizeController(5), Closure(ca.SX(4e-3), ca.SX(1e-3))
    assert not bool(ca.evalf(controller.judge(ca.SX(0.25), closure)))
    assert proposed(controller, 0.5, 0.5, closure) == pytest.approx(0.5, rel=1e-12)
    assert bool(ca.evalf(controller.judge(ca.SX(0.25), Closure(ca.SX(1e-3), ca.SX(1e-3)))))

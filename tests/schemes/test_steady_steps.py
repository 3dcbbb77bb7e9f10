"""Steps of one length within a tolerance: those of the method without one, found by trials that cost little."""

from __future__ import annotations

from collections.abc import Callable
from types import SimpleNamespace

import numpy as np
import pytest

from runtime.contract.model import Model
from runtime.engine.tiers import written_out
from runtime.running.steady_trials import SteadyTrials
from runtime.running.tried_motion import LEAST_STEPS
from runtime.schemes.adaptive.adaptive_steps import AdaptiveSteps
from tests.support.prepared_runs import PreparedRuns

Load = Callable[[str], Model]


def _seen(runs: PreparedRuns, h: float, dt: float, states: int, stops: list[float] | None = None) -> np.ndarray:
    """(states, n_i) of x, dt apart, with steps of h; stops: times that none crosses."""
    scheme, layout = runs.scheme, runs.scheme.layout
    z = runs.stepper.start(0.0, runs.state.q, runs.state.q_dot, runs.c, dt)
    assert isinstance(scheme, AdaptiveSteps)
    scheme.look_ahead(z, [])
    z[layout.slice("steady")], z[layout.slice("ranging")] = h, 0.0
    ends = layout.slice("stops")
    z[ends] = [*(stops or []), *[1e300] * (4 - len(stops or []))]
    ready, found = runs.stepper.ready_for(scheme.constants(runs.c, dt)), []
    for _ in range(states):
        runs.stepper.run(z, ready, 1)
        found.append(z[layout.slice("x")].copy())
    assert z[layout.slice("rejected")][0] == 0
    return np.array(found)


@pytest.mark.parametrize(
    ("scheme", "name", "m"),
    [
        ("dopri5", "slider_crank", None),
        ("exponential", "flexible_joint_arm", [2]),
        ("dopri5", "pendulum", None),
        ("exponential_adams", "flexible_joint_arm", None),
    ],
)
def test_they_are_those_of_the_method_itself(built_in: Load, scheme: str, name: str, m: list[int] | None) -> None:
    """Seen once at the end or on the way, at ends of steps or between them: the same motion up to rounding."""
    model, h, steps = built_in(name), 0.004, 50
    options = {"linearisation": "stiffness"} if scheme == "exponential_adams" else {}
    own = PreparedRuns(model, scheme, m, options=options).samples(h, steps, 10)["x"][1:]
    runs = PreparedRuns(model, scheme, options={"tolerance": 1e-4})
    scale = np.abs(own).max()
    assert _seen(runs, h, steps * h, 1)[-1] == pytest.approx(own[-1], abs=1e-11 * scale)
    assert _seen(runs, h, 10 * h, 5) == pytest.approx(own, abs=1e-11 * scale)
    assert _seen(runs, h, 0.8 * h, 50)[-1] == pytest.approx(own[3], abs=1e-11 * scale)


@pytest.mark.parametrize("scheme", ["exponential_rk4", "exponential_adams"])
def test_none_crosses_a_stop(built_in: Load, scheme: str) -> None:
    """A stop in the middle of a step: steps end there, no error but that of the method is made, and all goes on."""
    runs = PreparedRuns(built_in("flexible_joint_arm"), scheme, options={"tolerance": 1e-4})
    h, stops = 0.004, [0.0305, 0.103]
    free, held = (_seen(runs, h, 0.2, 1, stops=one)[-1] for one in ([], stops))
    finer = _seen(runs, h / 4, 0.2, 1)[-1]
    assert 0 < np.abs(held - free).max() < 3 * np.abs(free - finer).max()


class _Law:
    """In place of trials: errors of a method by a law of the number of steps."""

    def __init__(self, law: Callable[[float], float], order: int = 4) -> None:
        self.law, self.span, self.made, self.alarmed, self.least = law, 1.0, [], False, LEAST_STEPS
        self.scheme = SimpleNamespace(order=order, error_order=order, price_of_varied=lambda program: 1.0)
        self.stepper = SimpleNamespace(program=None)

    def of_length(self, h: float, known: object, keep: bool = False) -> SimpleNamespace:
        self.made.append(1 / h)
        return SimpleNamespace(steady=h, operations=1 / h, value=self.law(1 / h))

    @staticmethod
    def error(one: SimpleNamespace, finer: SimpleNamespace) -> float:
        return float(abs(one.value - finer.value))


def _searched(law: Callable[[float], float], error: float, first: int = 40) -> tuple[float, _Law]:
    runs = _Law(law)
    found = SteadyTrials(runs, SimpleNamespace(steps=first)).searched(error)  # type: ignore[arg-type]
    assert found is not None
    return 1 / found.steady, runs


@pytest.mark.parametrize("error", [1e-2, 1e-4, 1e-6, 1e-9])
def test_the_number_of_steps_is_found(error: float) -> None:
    """With errors c / N^4, to 20 %; the trials before that of the run itself take about as many steps as the run."""
    right = (3e4 / error) ** 0.25
    count, runs = _searched(lambda N: 3e4 / N**4, error)
    assert 0.83 * right < count < 1.35 * right
    assert sum(runs.made) - count < (1.5 if error > 1e-6 else 0.6) * count


def test_steps_are_no_longer_than_what_was_tried() -> None:
    """Beyond a limit of stability all is lost, although the error would allow ten times longer steps."""
    count, runs = _searched(lambda N: 1.0 / N**4 if N > 333 else 1e16 / N, 1e-6)
    assert 333 < count < 1.5 * 333 and count in runs.made


def test_a_window_of_unstable_steps_is_left() -> None:
    """Steps that are wanted by the order, and unstable there only."""
    count, _ = _searched(lambda N: 1e3 if 200 < N < 240 else 3e4 / N**4, 1.4e-5)
    assert not 200 < count < 240 and 3e4 / count**4 < 3e-5


def test_longer_steps_than_those_of_the_first_trial() -> None:
    """Where estimates are far too large a few steps will do; never less than two."""
    count, _ = _searched(lambda N: 1e-3 / N**4, 1e-6, first=1000)
    assert count == pytest.approx(5.6, rel=0.2)
    assert _searched(lambda N: 1e-12 / N**4, 1e-6, first=1000)[0] == LEAST_STEPS


def test_errors_that_follow_no_order_are_measured_near_what_is_asked() -> None:
    """Errors fall slowly until modes are resolved at 500 steps: extrapolation from below would be 100 times off."""
    count, _ = _searched(lambda N: 0.02 * (50 / N) / (1 + (N / 500) ** 3), 1e-6)
    found = 0.02 * (50 / count) / (1 + (count / 500) ** 3)
    assert 0.1e-6 < found < 5e-6


def test_what_varied_steps_would_gain() -> None:
    """Half of the steps err by one, half by nothing: (1/2)^(1/p) (1/2)^((p-1)/p) / ... as Hoelder's inequality says."""
    steady = SteadyTrials(_Law(lambda N: 1 / N), SimpleNamespace(steps=4))  # type: ignore[arg-type]
    for sizes, gain in (([1.0, 1.0], 1.0), ([1.0, 0.0], 0.5)):
        steady.made = [SimpleNamespace(sizes=np.array(sizes))]  # type: ignore[list-item]
        assert steady.gain_of_varied() == pytest.approx(gain, rel=1e-12)


def test_the_stage_of_such_steps_does_not_keep_others_from_being_inlined(built_in: Load) -> None:
    """Both are in the program of a run, which takes one of them."""
    program = PreparedRuns(built_in("pendulum"), "exponential", options={"tolerance": 1e-4}).stepper.program
    sizes = {stage.name(): stage.n_instructions() for stage in program.stages()}
    assert sizes["plain"] > 0 and written_out(program) <= sum(sizes.values()) - sizes["plain"]

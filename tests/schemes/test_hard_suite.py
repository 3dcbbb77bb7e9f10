"""The hard suite: every case derives, starts and runs; two unlike schemes agree; the claimed frequencies hold."""

from __future__ import annotations

from collections.abc import Callable
from math import ceil

import numpy as np
import pytest

from benchmarks.scenes.hard_suite import HARD_SUITE, HardCase
from runtime import Solution, simulate
from runtime.contract.coordinates import followed
from runtime.model import Model
from symgen.generate import model_of as on_demand
from symgen.scene import SceneRecord
from tests.support.modes import Modes, modes_at
from tests.support.prepared_runs import PreparedRuns

pytestmark = pytest.mark.long

Build = Callable[[SceneRecord], Model]
PART = 0.02  # of t_end that is run
EXPLICIT = 0.05  # step times the fastest rate
LARGE = 0.5  # the same for the other scheme, but no more steps than MOST
MOST = 200
UNLIKE = {"chain": "dop853", "bricard": "rk4"}  # exponential steps of these would double the time of the test


def run(model: Model, case: HardCase, steps: int = 1, scheme: str = "single_rate") -> Solution:
    return simulate(
        model,
        t_end=case.t_end * PART,
        dt=case.t_end * PART / steps,
        scheme=scheme,
        samples=1,
        parameters=case.parameters,
        initial=case.initial,
        start=case.start,
    )


def fastest(model: Model, case: HardCase) -> float:
    at_start = modes_at(run(model, case), [0])[0]
    return max(float(at_start.undamped[-1]), at_start.fastest_decay)


def values(solution: Solution, names: list[str]) -> np.ndarray:
    """Rows: coordinates and rates at the end."""
    return np.array([[solution[name][-1] for name in names], [solution.rate(name)[-1] for name in names]])


@pytest.mark.parametrize("name", [name for name, case in HARD_SUITE.items() if not case.large])
def test_hard_suite_schemes_agree(model_of: Build, name: str) -> None:
    """Small central-difference steps against larger steps of another kind: angles, elastic coordinates, their rates."""
    case = HARD_SUITE[name]
    model = model_of(case.make())
    assert name == case.name and set(case.graded) <= set(followed(model)[0])
    assert len(set(case.graded)) == len(case.graded)
    rate = fastest(model, case)
    small = ceil(case.t_end * PART * rate / EXPLICIT)
    large = min(MOST, ceil(case.t_end * PART * rate / LARGE))
    first, second = run(model, case, small), run(model, case, large, UNLIKE.get(name, "exponential"))
    for solution in (first, second):
        assert solution.status.name == "completed", solution.status
    for kind in (True, False):
        names = [graded for graded in case.graded if (graded in model.elastic) is kind]
        if names:
            expected, found = values(first, names), values(second, names)
            assert np.all(np.abs(found - expected).max(axis=1) < 1e-3 * np.abs(expected).max(axis=1)), (names, found)


@pytest.mark.parametrize("name", [name for name, case in HARD_SUITE.items() if case.large])
def test_large_cases_start(name: str) -> None:
    """They derive, their graded coordinates are there, and steps of `rk4` and of half their size agree and move."""
    case = HARD_SUITE[name]
    model = on_demand(case.make())
    assert set(case.graded) <= set(followed(model)[0])
    start = None if case.start == "given" else case.start
    ends, runs = [], PreparedRuns(model, "rk4", start=start, engine="interpreted")
    for steps in (4, 8):
        seen = runs.samples(case.t_end * 1e-4 / steps, steps, steps)["x"]
        ends.append(seen[-1])
    moved = np.abs(ends[1] - seen[0]).max()
    assert np.abs(ends[1] - ends[0]).max() < 1e-3 * moved, (ends, moved)


def start(model_of: Build, name: str) -> Modes:
    case = HARD_SUITE[name]
    return modes_at(run(model_of(case.make()), case), [0])[0]


@pytest.mark.parametrize("ratio", [10, 100, 1000, 10_000])
def test_ratio_of_the_oscillators(model_of: Build, ratio: int) -> None:
    slow, fast = start(model_of, f"oscillators_{ratio}").undamped
    assert ratio <= fast / slow < 1.2 * ratio


def test_stiff_slider_crank_is_200_times_as_fast_as_what_is_graded(model_of: Build) -> None:
    """The two axial frequencies are above; the lateral ones are those of the twin it comes from."""
    found = start(model_of, "stiff_200").undamped
    twin = start(model_of, "slider_crank_free").undamped
    assert 200 <= found[4] / found[2] < 200.1
    np.testing.assert_allclose(found[1:3], twin[1:3], rtol=0.01)
    assert found[3] / found[2] > 50


def test_springs_of_the_arm_are_200_times_as_fast_as_its_swing(model_of: Build) -> None:
    found = start(model_of, "joint_arm").undamped
    assert found[2] / found[1] > 200


def test_the_damper_not_the_spring_limits_the_step(model_of: Build) -> None:
    modes = start(model_of, "overdamped")
    assert modes.fastest_decay > 50 * modes.undamped[-1]


def test_physical_axial_modes_are_faster_than_the_published_ones(model_of: Build) -> None:
    published, physical = (start(model_of, name).undamped for name in ("f1_smooth", "f1_physical"))
    assert physical[3] / physical[1] > 12 > 4.5 > published[3] / published[1]

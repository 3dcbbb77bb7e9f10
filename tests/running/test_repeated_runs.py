"""Runs of one model again and again: prepared once, and each the run that a new model makes, bit for bit."""

from __future__ import annotations

import sys
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.model import Model
from runtime.schemes import stepper
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import kept_stepper
from symgen.scenes import generated_folder

pytestmark = pytest.mark.long

NAME = "flexible_slider_crank"
SHORT: dict[str, Any] = {"t_end": 0.02, "dt": 1e-4}


@pytest.fixture
def model() -> Model:
    return load_model(generated_folder(NAME))


@pytest.fixture
def prepared(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[str]:
    """The schemes that were prepared, in order, where the cache is empty."""
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    seen: list[str] = []
    prepare: Callable[..., Any] = stepper.prepare

    def watched(program: Any, z_size: int, c_size: int) -> Any:
        seen.append(program.stages()[0].name())
        return prepare(program, z_size, c_size)

    monkeypatch.setattr(stepper, "prepare", watched)
    return seen


@pytest.mark.parametrize(
    "settings",
    [
        {"scheme": "coupled"},
        {"scheme": "dopri5", "tolerance": 1e-4, "dt": None},
        {"scheme": "rk4", "engine": "interpreted"},
    ],
)
def test_a_second_run_prepares_nothing_and_is_the_run_of_a_new_model(
    model: Model, prepared: list[str], settings: dict[str, Any]
) -> None:
    changed = {"parameters": {model.parameters[0].name: 1.1 * model.parameters[0].default}}
    settings = {**SHORT, **settings}
    first = simulate(model, **settings)
    count = len(prepared)
    second, again = simulate(model, **settings, **changed), simulate(model, **settings)
    assert count and len(prepared) == count
    assert np.array_equal(again.q, first.q) and np.array_equal(again.t, first.t)
    new = simulate(load_model(generated_folder(NAME)), **settings, **changed)
    assert np.array_equal(second.q, new.q) and not np.array_equal(second.q, first.q)
    assert second.error == new.error


@pytest.mark.parametrize("scheme", ["coupled", "exponential"])
def test_a_run_with_other_steps_prepares_nothing_and_is_the_run_of_a_new_model(
    model: Model, prepared: list[str], scheme: str
) -> None:
    """Work, error estimate and samples included; nor do the runs before it change by it."""
    first = simulate(model, **SHORT, scheme=scheme)
    count = len(prepared)
    half, again = (simulate(model, t_end=0.02, dt=dt, scheme=scheme) for dt in (5e-5, 1e-4))
    assert count and len(prepared) == count
    new = simulate(load_model(generated_folder(NAME)), t_end=0.02, dt=5e-5, scheme=scheme)
    for found, wanted in ((half, new), (again, first)):
        for field in ("t", "q", "q_dot", "q_ddot", "lam"):
            assert np.array_equal(getattr(found, field), getattr(wanted, field)), field
        assert np.array_equal(found.energy_balance(), wanted.energy_balance())
        for told in ("steps", "sub_steps", "error"):
            assert found.stats.get(told) == wanted.stats.get(told), told
    assert not np.array_equal(half.q[-1], first.q[-1])


def test_other_options_and_ratios_are_other_programs(model: Model) -> None:
    def of(name: str, dt: float = 1e-4, m: list[int] | None = None, **options: Any) -> stepper.Stepper:
        return kept_stepper(scheme_kind(name).build(name, model, dt, m, options))

    made = [of("single_rate"), of("coupled", m=[2]), of("coupled", m=[3]), of("rk4")]
    made += [of("rk4", closure_iterations=3), of("dop853")]
    assert len({id(one.engine) for one in made}) == len(made)
    assert of("coupled", m=[3]).engine is made[2].engine
    longer = of("coupled", 2e-4, m=[3])
    assert longer.engine is made[2].engine and longer.scheme.grid.h == [2e-4, 2e-4 / 3]
    assert made[2].scheme.grid.dt_L == 1e-4


def test_what_is_kept_is_bounded_and_the_oldest_goes(model: Model, monkeypatch: pytest.MonkeyPatch) -> None:
    def of(scheme: str) -> stepper.Stepper:
        return kept_stepper(scheme_kind(scheme).build(scheme, model, 1e-4, None, {}))

    first, second = of("rk4"), of("single_rate")
    third = of("dopri5").operations
    model.steppers.popitem()
    assert of("rk4").engine is first.engine  # now the younger one
    monkeypatch.setattr(stepper, "MOST_KEPT_OPERATIONS", first.operations + third)
    of("dopri5")
    assert list(model.steppers.values())[0] is first and second not in model.steppers.values()
    monkeypatch.setattr(stepper, "MOST_KEPT_OPERATIONS", first.operations - 1)
    assert of("radau") not in model.steppers.values()


def test_threads_begin_where_they_are_told_to(model: Model) -> None:
    """Runs of one model at once share what is called between steps: none may get the numbers of another."""
    one, c = (
        kept_stepper(scheme_kind("rk4").build("rk4", model, 1e-4, None, {})),
        model.constants(model.parameter_vector()),
    )
    q, q_dot = model.initial_q, model.initial_q_dot

    def begins(t: float) -> list[np.ndarray]:
        return [one.start(t, q, (1 + t) * q_dot, c, 1e-4) for _ in range(10_000)]

    alone, interval = [begins(t)[0] for t in (0.0, 1.0)], sys.getswitchinterval()
    try:
        sys.setswitchinterval(1e-6)
        with ThreadPoolExecutor(2) as threads:
            found = list(threads.map(begins, (0.0, 1.0)))
    finally:
        sys.setswitchinterval(interval)
    for own, others in zip(alone, found, strict=True):
        assert all(np.array_equal(own, other) for other in others)


def test_threads_share_an_interpreted_program(model: Model) -> None:
    """Its functions, not the arrays that they read and write."""
    one = kept_stepper(scheme_kind("rk4").build("rk4", model, 1e-4, None, {}), "interpreted")
    c = model.constants(model.parameter_vector())
    ready, start = one.ready(c, 1e-4), one.start(0.0, model.initial_q, model.initial_q_dot, c, 1e-4)

    def after(turn: float) -> np.ndarray:
        z = start.copy()
        z[one.scheme.layout.slice("t0")] = turn
        for _ in range(500):
            one.run(z, ready, 1)
        return z

    alone, interval = [after(turn) for turn in (0.0, 1.0)], sys.getswitchinterval()
    try:
        sys.setswitchinterval(1e-6)
        with ThreadPoolExecutor(2) as threads:
            found = list(threads.map(after, (0.0, 1.0)))
    finally:
        sys.setswitchinterval(interval)
    for own, others in zip(alone, found, strict=True):
        assert np.array_equal(own, others)

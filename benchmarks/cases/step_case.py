"""A slider-crank ready to be stepped."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.cases.scenes import MAJOR_STEP, RATIO, slider_crank
from benchmarks.harness.models import model_of
from runtime.engine.native import Engine
from runtime.engine.prepare import prepare
from runtime.engine.program import Program, operations_per_step
from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import start_vector

AGREEMENT = 1e-9


@dataclass(frozen=True)
class Case:
    """A model with its scheme, step program, constants (c and the prepared ones the program reads) and start."""

    model: Model
    scheme: Scheme
    program: Program
    c: np.ndarray
    ready: np.ndarray
    start: np.ndarray


def make_case(rod: dict, folder: Path) -> Case:
    """A slider-crank with this rod, at its start."""
    model = model_of(slider_crank(rod), folder)
    scheme = scheme_kind("printed").build("printed", model, MAJOR_STEP, [RATIO], {"common_update": "direct"})
    c = model.constants(model.parameter_vector())
    start = start_vector(scheme, 0.0, model.initial_q, model.initial_q_dot, c)
    prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
    ready = prepared.ready(scheme.constants(c))
    return Case(model, scheme, prepared.program, c, ready, prepared.widened(start))


def counts(case: Case) -> dict:
    """Operations of a step, for the JSON file."""
    return {
        "operations per major step": operations_per_step(case.program),
        "stages": {stage.name(): stage.n_instructions() for stage in case.program.stages()},
    }


def worker(case: Case, runner: Engine) -> Callable[[int], None]:
    """n major steps from the start."""
    z = case.start.copy()

    def work(n: int) -> None:
        z[:] = case.start
        runner.run(z, case.ready, n)

    return work


def difference(value: np.ndarray, reference: np.ndarray, what: str) -> float:
    """Largest relative difference. Raises AssertionError if two implementations disagree."""
    error = float(np.max(np.abs(value - reference) / np.abs(reference)))
    if not error < AGREEMENT:
        raise AssertionError(f"{what} differ by {error:.1e}")
    return error

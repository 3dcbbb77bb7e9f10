"""Prepared step programs of built-in models with a start, run by code of a given form."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.engine.llvm_code import Effort, Processor, ProgramCompiler
from runtime.engine.prepare import prepare
from runtime.engine.program import Form, Program
from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import start_vector
from tests.support.model_values import Array


@dataclass(frozen=True)
class StepProgram:
    """A program with the constants that it reads and its z at the start."""

    program: Program
    ready: Array
    start: Array

    def run(
        self, steps: int, form: Form, effort: Effort, processor: Processor | None = None, scatter: float = 0.0
    ) -> Array:
        """z (width, size) after so many steps; lane k starts from z with scatter k of its independent part added."""
        code = ProgramCompiler(self.program).build(form, effort, processor)
        z = aligned(np.array([self.lane(k, scatter) for k in range(form.width)]).T)
        c = aligned(np.repeat(self.ready[:, None], form.width, axis=1))
        work = aligned(np.zeros((code.work + 1, form.width)))
        code.run(z.ctypes.data, c.ctypes.data, work.ctypes.data, steps)
        return z.T.copy()

    def lane(self, k: int, scatter: float) -> Array:
        """Start of lane k."""
        return self.start * (1.0 + k * scatter)


def aligned(values: Array) -> Array:
    """A copy that begins at a multiple of 128 bytes, as vectors of 16 lanes need it."""
    raw = np.zeros(values.size + 16)
    first = (-raw.ctypes.data // 8) % 16
    found = raw[first : first + values.size].reshape(values.shape)
    found[:] = values
    return found


def step_program(model: Model, scheme: str, m: list[int] | None, dt: float | None = None) -> StepProgram:
    """The prepared program of a scheme on a model at its own start and step."""
    on = scheme_kind(scheme).build(scheme, model, dt or float(model.simulation["dt"]), m, {})
    c = model.constants(model.parameter_vector())
    z = start_vector(on, 0.0, model.initial_q, model.initial_q_dot, c)
    prepared = prepare(on.program(), on.layout.size, on.c_size)
    return StepProgram(prepared.program, prepared.ready(on.constants(c)), prepared.widened(z))

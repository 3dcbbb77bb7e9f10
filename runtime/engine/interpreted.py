"""Run a step program in CasADi's virtual machine: no compiler needed, same operations in the same order."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial
from typing import Any

import casadi as ca
import numpy as np

from runtime.engine.program import Program, Repeat, Until


def program_function(program: Program, z_size: int, c_size: int) -> ca.Function:
    """The whole program as one Function (z, c) -> z, differentiable as far as its stages are."""
    return _Composer(z_size, c_size).function(program)


class _Composer:
    def __init__(self, z_size: int, c_size: int) -> None:
        self.z, self.c = ca.MX.sym("z", z_size), ca.MX.sym("c", c_size)

    def function(self, program: Program) -> ca.Function:
        return program.fold(lambda stage: stage, self._sequence, self._again)

    def _sequence(self, parts: list[ca.Function]) -> ca.Function:
        z = self.z
        for part in parts:
            z = part(z, self.c)
        return ca.Function("sequence", [self.z, self.c], [z])

    def _again(self, body: ca.Function, node: Repeat | Until) -> ca.Function:
        if isinstance(node, Repeat):
            return self.power(body, node.count)
        return self.power(body, node.limit, node.flag)

    def power(self, function: ca.Function, n: int, flag: int | None = None) -> ca.Function:
        """function applied n times, by repeated squaring; with a flag, only while z[flag] > 0.

        Every square is guarded by the flag too, so that what is left after convergence costs log n tests.
        """
        result, square, left = None, self._guarded(function, flag), n
        while left:
            if left & 1:
                result = square if result is None else self._chain(result, square)
            left >>= 1
            if left:
                square = self._guarded(self._chain(square, square), flag)
        return result if result is not None else ca.Function("none", [self.z, self.c], [self.z])

    def _chain(self, first: ca.Function, second: ca.Function) -> ca.Function:
        return ca.Function("chain", [self.z, self.c], [second(first(self.z, self.c), self.c)])

    def _guarded(self, body: ca.Function, flag: int | None) -> ca.Function:
        if flag is None:
            return body
        keep = ca.Function("keep", [self.z, self.c], [self.z])
        switch = ca.Function.if_else("until", body, keep)
        return ca.Function("once", [self.z, self.c], [switch(self.z[flag] > 0, self.z, self.c)])


class InterpretedProgram:
    """A program evaluated by CasADi."""

    name = "interpreted"

    def __init__(self, program: Program, z_size: int, c_size: int) -> None:
        self.note = ""
        self._composer = _Composer(z_size, c_size)
        self._step = self._composer.function(program)
        self._own = threading.local()

    def _batch(self, n: int) -> tuple[Any, ...]:
        """(function of n steps, its buffer, what evaluates it), this thread's."""
        batches: dict[int, tuple[Any, ...]] | None = getattr(self._own, "batches", None)
        if batches is None:
            batches = self._own.batches = {}
        if n not in batches:
            function = self._composer.power(self._step, n)
            buffer, evaluate = function.buffer()
            batches[n] = (function, buffer, evaluate)
        return batches[n]

    def run_rows(self, z: np.ndarray, c: np.ndarray, counts: np.ndarray, rows: np.ndarray) -> None:
        """Apply the program counts (N,) times, each count followed by a copy of z to the next of rows (N, z_size)."""
        for count, row in zip(counts, rows, strict=True):
            self.run(z, c, int(count))
            row[:] = z

    def bound(self, z: np.ndarray, c: np.ndarray) -> Callable[[int], None]:
        """`run` with z and c fixed: only the number of steps is left to give."""
        return partial(self.run, z, c)

    def run(self, z: np.ndarray, c: np.ndarray, n: int) -> None:
        """Apply the program n times to z, in place."""
        _, buffer, evaluate = self._batch(n)
        result = np.empty_like(z)
        buffer.set_arg(0, z.data)
        buffer.set_arg(1, c.data)
        buffer.set_res(0, result.data)
        evaluate()
        z[:] = result

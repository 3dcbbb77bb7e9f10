"""One case of the native-code benchmark in this process: prints JSON; the argument is JSON too."""

from __future__ import annotations

import json
import os
import resource
import sys
import tempfile
import time
from collections.abc import Callable

import numpy as np

from benchmarks.contenders.by_c_compiler import CompiledProgram
from benchmarks.harness.timing import interleave, ratio
from runtime.engine.llvm_code import host
from runtime.engine.native import Engine, NativeProgram
from runtime.engine.prepare import prepare
from runtime.model import load_model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import start_vector
from symgen.generate import generate
from symgen.scenes import SCENES

ROUNDS = 60


def main(scene: str, made_with: dict[str, int], scheme: str, m: list[int], with_gcc: bool) -> dict[str, float]:
    """Times [s] and memory [MB] of one program."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["SYMGEN_CACHE"] = folder
        model = load_model(generate(SCENES[scene](**made_with), f"{folder}/model"))
        on = scheme_kind(scheme).build(scheme, model, float(model.simulation["dt"]), m or None, {})
        c = model.constants(model.parameter_vector())
        prepared = prepare(on.program(), on.layout.size, on.c_size)
        start = prepared.widened(start_vector(on, 0.0, model.initial_q, model.initial_q_dot, c))
        ready = prepared.ready(on.constants(c))
        host()  # llvmlite is imported once a process: 0.03 s
        before, began = _memory(), time.process_time()
        first = NativeProgram(prepared.program)
        first.run(start.copy(), ready, 1)
        found: dict[str, float] = {
            "first_step": time.process_time() - began,
            "first_mb": _memory() - before,
            "operations": sum(stage.n_instructions() for stage in prepared.program.stages()),
        }
        first.tiers.final = True  # as it is: it shall not be improved while it is timed
        engines: dict[str, Engine] = {"first": first}
        engines["best"], found["best_build"] = _built(lambda: NativeProgram(prepared.program, wait=True))
        if with_gcc:
            engines["gcc"], found["gcc_build"] = _built(lambda: CompiledProgram(prepared.program))
        timings = interleave({name: _steps(engine, start, ready) for name, engine in engines.items()}, ROUNDS)
        found |= {name: timing.best for name, timing in timings.items()}
        if with_gcc:
            found["ratio"] = ratio(timings["best"], timings["gcc"])[0]
        return found


def _built(make: Callable[[], Engine]) -> tuple[Engine, float]:
    began = _seconds()
    engine = make()
    return engine, _seconds() - began


def _seconds() -> float:
    """CPU seconds of this process and of those that it called."""
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def _memory() -> float:
    """Most memory so far [MB]."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def _steps(engine: Engine, start: np.ndarray, ready: np.ndarray) -> Callable[[int], None]:
    z = start.copy()

    def work(n: int) -> None:
        z[:] = start
        engine.run(z, ready, n)

    return work


if __name__ == "__main__":
    print(json.dumps(main(*json.loads(sys.argv[1]))))

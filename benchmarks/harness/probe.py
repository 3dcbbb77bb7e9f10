"""Measures one scene in a process of its own: `python -m benchmarks.harness.probe CASE`, CPU seconds, memory, JSON."""

from __future__ import annotations

import time

STARTED = time.process_time()

import cProfile  # noqa: E402
import json  # noqa: E402
import pstats  # noqa: E402
import resource  # noqa: E402
import sys  # noqa: E402
from collections.abc import Callable  # noqa: E402
from pathlib import Path  # noqa: E402

from benchmarks.cases.scenes import MAJOR_STEP, RATIO, pinned_rod, slider_crank  # noqa: E402
from benchmarks.contenders.by_c_compiler import CompiledProgram  # noqa: E402
from benchmarks.harness.models import condensed_program, workplace  # noqa: E402
from runtime.model import Model, load_model  # noqa: E402
from runtime.schemes.catalogue import scheme_kind  # noqa: E402
from symgen.emission.files import emit  # noqa: E402
from symgen.emission.write import write_model  # noqa: E402
from symgen.pipeline import derive  # noqa: E402
from symgen.scene import SceneRecord  # noqa: E402
from symgen.scenes.pendulums import chain  # noqa: E402

IMPORTS = time.process_time() - STARTED
STEPPING = frozenset({"condensed", "closure", "velocities", "accelerations", "energy", "constraints"})
HOTTEST = 15


def _step(model: Model) -> None:
    scheme = scheme_kind("printed").build("printed", model, MAJOR_STEP, [RATIO], {"common_update": "direct"})
    CompiledProgram(scheme.program())


def _condensed(model: Model) -> None:
    model.kernel("condensed")
    CompiledProgram(condensed_program(model)[0])


# case: scene, functions (None: all), what is compiled
CASES: dict[str, tuple[Callable[[], SceneRecord], frozenset[str] | None, Callable[[Model], None] | None]] = {
    "slider_crank": (lambda: slider_crank(pinned_rod()), None, _step),
    "chain_20_stepping": (lambda: chain(20, 2), STEPPING, None),
    "chain_20": (lambda: chain(20, 2), None, None),
    "chain_50": (lambda: chain(50, 2), frozenset({"condensed"}), _condensed),
}


def main(case: str, profiled: bool) -> dict:
    """Times of deriving, emitting, loading and compiling one case; with a profile, of deriving and emitting only."""
    make, functions, compiled = CASES[case]
    found: dict = {"imports": IMPORTS}
    with workplace() as folder:
        if profiled:
            scene = make()
            return {"hottest": _profile(lambda: write_model(emit(derive(scene, functions)), folder / "model"))}
        scene = _timed(found, "scene", make)
        derived = _timed(found, "derive", lambda: derive(scene, functions))
        files = _timed(found, "emit", lambda: emit(derived))
        _timed(found, "write", lambda: write_model(files, folder / "model"))
        model = _timed(found, "load", lambda: _loaded(folder / "model"))
        found["operations"] = dict(model.operations)
        if compiled is not None:
            _timed(found, "compile", lambda: compiled(model))
            found["compiler_mb"] = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        found["process_mb"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    return found


def _loaded(folder: Path) -> Model:
    model = load_model(folder)
    model.kernel("condensed")
    return model


def _cpu() -> float:
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def _timed(found: dict, name: str, work: Callable):  # type: ignore[no-untyped-def]
    started = _cpu()
    value = work()
    found[name] = _cpu() - started
    return value


def _profile(work: Callable[[], object]) -> list[dict]:
    profile = cProfile.Profile()
    profile.runcall(work)
    rows = sorted(pstats.Stats(profile).stats.items(), key=lambda item: -item[1][2])[:HOTTEST]  # type: ignore[attr-defined]
    return [
        {
            "function": f"{Path(file).name}:{line}:{name}",
            "calls": calls,
            "own_seconds": round(own, 3),
            "seconds": round(total, 3),
        }
        for (file, line, name), (_, calls, own, total, _) in rows
    ]


if __name__ == "__main__":
    print(json.dumps(main(sys.argv[1], "--profile" in sys.argv)))

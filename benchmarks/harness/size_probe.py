"""One large scene in this process, from scene to the end of its first step: prints JSON; the argument is JSON too."""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time

from benchmarks.harness.memory import peak_memory
from benchmarks.scenes.arm import arm
from runtime import simulate
from symgen.generate import model_of
from symgen.scenes.pendulums import chain

SCENES = {"chain": chain, "arm": arm}


def main(scene: str, made_with: dict[str, int], scheme: str) -> dict[str, float]:
    """CPU time [s] of the whole process, imports and first native code included, and its memory [MB]."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["SYMGEN_CACHE"] = folder
        made = SCENES[scene](**made_with)
        model, dt = model_of(made), made.simulation.dt
        run = simulate(model, scheme=scheme, dt=dt, t_end=dt, seen_every=0.0)
        if not run.status.ok:
            raise RuntimeError(str(run.status))
        return {
            "seconds": time.process_time(),
            "mb": peak_memory(),
            "operations": sum(model.operations.values()),
        }


if __name__ == "__main__":
    print(json.dumps(main(*json.loads(sys.argv[1]))))

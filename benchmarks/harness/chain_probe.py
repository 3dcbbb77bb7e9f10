"""One long chain in one program and in this process, from nothing to its first step, then more: prints JSON."""

from __future__ import annotations

import json
import os
import sys
import tempfile
import time

from benchmarks.harness.memory import peak_memory

ENOUGH, LEAST_BURSTS = 0.3, 3  # s of CPU of a burst of steps; bursts, of which the fastest counts


def main(family: str, program: str, links: int) -> dict[str, float]:
    """CPU time [s] of the whole process until the first step is done, its memory then [MB], CPU time of a step [s]."""
    with tempfile.TemporaryDirectory() as folder:
        os.environ["SYMGEN_CACHE"] = folder
        from benchmarks.contenders.long_chains import FAMILIES  # what is imported is part of the time

        _, make = FAMILIES[family][program]
        chain = make(links)
        first, memory = time.process_time(), peak_memory()
        steps, seconds = 1, _burst(chain.advance, 1)
        while seconds < ENOUGH:
            steps *= 2 if seconds > ENOUGH / 8 else 4
            seconds = _burst(chain.advance, steps)
        least = min(seconds, *(_burst(chain.advance, steps) for _ in range(LEAST_BURSTS - 1)))
    return {"first": first, "mb": memory, "step": least / steps}


def _burst(advance: object, steps: int) -> float:
    began = time.thread_time()
    advance(steps)  # type: ignore[operator]
    return time.thread_time() - began


if __name__ == "__main__":
    print(json.dumps(main(*json.loads(sys.argv[1]))))

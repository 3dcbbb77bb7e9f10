"""Bad input and how it ended: `python -m benchmarks.pages.bad_input [--count 400] [--seed 1]`.

Good scenes get one to three random edits (those of tests/scene/test_random_edits.py). What is still a scene is
generated, loaded and run for twenty steps. Right is an error of the project's own, by name, or a run with a status.
"""

from __future__ import annotations

import argparse
import copy
import sys
import tempfile
import traceback
import warnings
from collections import Counter
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed, settings
from hypothesis import strategies as st

from runtime import SymgenError, load_model, simulate
from symgen.generate import generate
from symgen.scene import SceneRecord
from tests.scene.test_random_edits import GOOD, edit

STEPS = 20


def damaged(count: int, number: int) -> list[Any]:
    """So many edited scenes, the same for the same number."""
    found: list[Any] = []

    @seed(number)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given(st.data())
    def collect(data: st.DataObject) -> None:
        raw = copy.deepcopy(data.draw(st.sampled_from(GOOD)))
        for _ in range(data.draw(st.integers(1, 3))):
            if raw:
                edit(raw, data.draw)
        found.append(raw)

    collect()
    return found[:count]


def ended(raw: Any) -> str:
    """How a scene ended, in words."""
    place = "scene"
    try:
        scene = SceneRecord.from_dict(raw)
        place = "derivation"
        with tempfile.TemporaryDirectory() as folder:
            model = load_model(generate(scene, Path(folder) / "model"))
            place = "run"
            dt = float(model.simulation["dt"])
            run = simulate(model, dt=dt, t_end=STEPS * dt, engine="interpreted")
    except SymgenError:
        return f"refused by name: {place}"
    if run.status.ok and not (np.isfinite(run.q).all() and np.isfinite(run.q_dot).all()):
        return "completed with numbers that are not finite"
    return f"run: {run.status.name}"


def main(arguments: list[str] | None = None) -> int:
    """Try all, print how they ended; what was neither refused nor run is shown with its traceback."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.bad_input", description=__doc__)
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    warnings.simplefilter("ignore")
    counts: Counter[str] = Counter()
    for number, raw in enumerate(damaged(options.count, options.seed)):
        try:
            counts[ended(raw)] += 1
        except Exception as error:  # what no user should see
            counts[f"exception: {type(error).__name__}"] += 1
            print(f"edit {number}: {traceback.format_exc(limit=-3)}", file=sys.stderr, flush=True)
    print("| how it ended | of the edits |\n|---|---:|")
    for name, count in sorted(counts.items(), key=lambda item: -item[1]):
        print(f"| {name} | {count} |")
    return 0


if __name__ == "__main__":
    sys.exit(main())

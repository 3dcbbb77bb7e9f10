"""What a tolerance gives, in docs/guide/tolerance.md."""

from __future__ import annotations

import numpy as np

from benchmarks.harness.figures import table
from benchmarks.harness.result import Result


def given(result: Result) -> str:
    """Asked and measured, of all runs together."""
    cells = [cell for case in result.details.values() for cell in case["cells"]]
    delivered, times, rejected, steps, trials = (
        np.array([cell[key] for cell in cells], dtype=float)
        for key in ("delivered", "time", "rejected", "steps_over_fixed", "trials")
    )
    compared = times[np.isfinite(times)]
    within = (delivered >= 0.1) & (delivered <= 3)
    rows = [
        ("delivered over asked between 0.1 and 3", "90 % of runs", _percent(within.mean())),
        (
            "less than 0.1; more than 3",
            "",
            f"{_percent((delivered < 0.1).mean())}; {_percent((delivered > 3).mean())} (at most {delivered.max():.2g})",
        ),
        ("steps over those of one length, median", "1.0", f"{np.nanmedian(steps):.2f}"),
        ("time over that of steps of one length, median", "1.0", f"{np.median(compared):.2f}"),
        ("runs that take more than 1.15 times the time", "none", _percent((compared > 1.15).mean())),
        ("rejected steps of a run, at most", "10 %", _percent(rejected.max())),
        ("operations of trials over those of the run, median", "", f"{np.nanmedian(trials):.2g}"),
        (
            "cases; runs; of these with a best step to compare with",
            "",
            f"{len(result.details)}; {len(cells)}; {len(compared)}",
        ),
    ]
    return table(("", "asked", "measured"), rows)


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %"


FIGURES = {"tolerance": given}

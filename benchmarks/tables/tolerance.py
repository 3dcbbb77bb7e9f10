"""What a tolerance gives, in docs/evidence/speed.md."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from benchmarks.harness.figures import table
from benchmarks.harness.result import Result


def given(result: Result) -> str:
    """Measured, of all runs together."""
    cells = [cell for case in result.details.values() for cell in case["cells"]]
    delivered, prices = (np.array([cell[key] for cell in cells], dtype=float) for key in ("delivered", "price"))
    quiet = np.array([not cell["said"] for cell in cells], dtype=bool)
    met = prices[np.isfinite(prices)]
    rows = [
        ("delivered within what was asked", _percent((delivered <= 1).mean())),
        ("delivered over asked, at most, where the run says nothing", f"{delivered[quiet].max(initial=0.0):.2g}"),
        ("operations of all levels over those of the best single run, median", f"{np.median(met):.1f}"),
        ("the same, nine tenths of the runs below", f"{np.percentile(met, 90):.1f}"),
        ("cases; runs; of these with a best run to compare with", f"{len(result.details)}; {len(cells)}; {len(met)}"),
    ]
    return table(("", "measured"), rows)


def _percent(share: float) -> str:
    return f"{100 * share:.3g} %"


FIGURES: dict[str, Callable[[Result], str]] = {"tolerance": given}

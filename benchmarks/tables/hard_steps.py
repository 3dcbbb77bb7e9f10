"""Schemes with steps of one length on the hard suite, in docs/theory/schemes.md."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from benchmarks.harness.figures import method, milliseconds, table
from benchmarks.harness.result import Result

STIFF = ("exponential_adams", "exponential_rk4")
TIMED = (*STIFF, "exponential m=1", "exponential m=2", "exponential m=1 order=5", "radau eps=1e-06", "dop853", "rk4")
Found = Mapping[str, Sequence[float]]  # label: (steps, seconds, error)


def over_the_best(result: Result) -> str:
    """Time of each of STIFF over that of the best scheme, of the cases where one of them applies."""
    rows = []
    for name, found in result.details.items():
        best = _quickest(found, "")
        if best and any(_quickest(found, scheme) for scheme in STIFF):
            told = f"{method(best)}, {found[best][0]} steps: {milliseconds(found[best][1])} ms"
            rows.append((name, *(_over(found, scheme, best) for scheme in STIFF), told))
    return table(("", *map(method, STIFF), "the best"), rows)


def _quickest(found: Found, scheme: str) -> str:
    """Label of the quickest with any options, "" if there is none."""
    labels = [label for label in found if label.startswith(scheme)]
    return min(labels, key=lambda label: found[label][1], default="")


def _over(found: Found, scheme: str, best: str) -> str:
    label = _quickest(found, scheme)
    if not label:
        return "-"
    steps, seconds, _ = found[label]
    return f"{seconds / found[best][1]:.2f}: {steps}{label.removeprefix(scheme)}"


FIGURES: dict[str, Callable[[Result], str]] = {"hard_steps": over_the_best}

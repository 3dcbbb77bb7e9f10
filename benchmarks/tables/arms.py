"""Schemes on arms with a stiff flexible link, in docs/theory/schemes.md."""

from __future__ import annotations

from collections.abc import Callable

from benchmarks.harness.figures import method, milliseconds, table
from benchmarks.harness.result import Result

STIFFENING = 100
SHOWN = ("exponential_adams", "exponential_rk4", "exponential m=1", "radau eps=1e-06")


def on_arms(result: Result) -> str:
    """Steps, operations a step and time to the tolerance, by number of links."""
    links = sorted({int(name.split()[0]) for name in result.details if f"E x {STIFFENING}," in name})

    def cell(count: int, label: str) -> str:
        found = result.details.get(f"{count} links, E x {STIFFENING}, {label}")
        if found is None:
            return "-"
        return f"{found['steps']} steps of {found['operations']:,}: {milliseconds(found['seconds'])} ms"

    rows = [(str(count), *(cell(count, label) for label in SHOWN)) for count in links]
    return table(("links", *map(method, SHOWN)), rows)


FIGURES: dict[str, Callable[[Result], str]] = {"arms": on_arms}

"""Other programs on the hard suite and on arms, in docs/evidence/speed.md."""

from __future__ import annotations

from collections.abc import Callable
from math import inf, isfinite

from benchmarks.harness.figures import method, milliseconds, short, table
from benchmarks.harness.result import Result

INTEGRATORS = ("cvodes", "idas")


def on_the_suite(result: Result) -> str:
    """Our time on every case, and that of SUNDIALS over it; in brackets if it did nothing but evaluate equations."""
    rows = []
    for name, found in result.details["suite"].items():
        theirs = (f"{short(over)} ({short(alone)})" for over, alone in (found[one] for one in INTEGRATORS))
        told = f"{method(found['label'])}, {found['steps']}"
        rows.append((name, told, f"{found['ms_a_second']:.3g}", *(one.replace(" (-)", "") for one in theirs)))
    head = ("case", "this project: method, steps", "ms a second of motion", "CVODES over it", "IDAS over it")
    return table(head, rows, 3)


def programs(result: Result) -> str:
    """Exudyn on the long arm, the best of each kind of model, and Pinocchio on rigid ones."""
    rows = []
    arm = result.details["exudyn"]
    ours = f"{method(arm['label'])}, {arm['steps']} steps: {milliseconds(arm['seconds'])} ms"
    for found in arm["kinds"].values():
        label, ratio, told = min(found, key=lambda one: one[1] if isfinite(one[1]) else inf)
        rows.append((f"`{arm['case']}` to 1e-3", ours, label, f"{short(ratio)} ({told})"))
    for links, found in result.details["rigid"].items():
        ours = f"`dop853`, {found['steps']} steps: {milliseconds(found['seconds'])} ms"
        rows += [
            (f"{links} rigid links, 1 s to 1e-6", ours, name, f"{ratio:.3g} ({told})")
            for name, (ratio, told) in found["theirs"].items()
        ]
    return table(("problem", "this project", "the other", "its time over ours"), rows)


FIGURES: dict[str, Callable[[Result], str]] = {"others": on_the_suite, "others.programs": programs}

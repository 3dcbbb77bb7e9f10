"""Growth with the length of a chain, in docs/evidence/speed.md: a table of each family, and the picture."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path

from benchmarks.harness.figures import short, table
from benchmarks.harness.growth import growth
from benchmarks.harness.result import Result

SHOWN = {"first": ("to first step", "s", 1.0), "mb": ("memory", "MB", 1.0), "step": ("a step", "us", 1e6)}
COLOURS = {
    "this project": "C0", "MuJoCo": "C1", "Pinocchio": "C2", "Exudyn": "C3", "NumPy and SciPy": "C7",
}  # fmt: skip


def of_family(family: str, result: Result) -> str:
    """Time to the first step, memory and time of a step by N; how they grow."""
    found = result.details.get(family, {})
    sizes = sorted({int(links) for by_size in found.values() for links in by_size})
    rows = []
    for key, (what, unit, factor) in SHOWN.items():
        for name, by_size in found.items():
            known = [links for links in sizes if str(links) in by_size]
            values = {links: factor * by_size[str(links)][key] for links in known}
            cells = [short(values[links]) if links in values else "-" for links in sizes]
            law = str(growth(known, list(values.values()))) if len(known) > 1 else "-"
            rows.append((f"{what}, {unit}", name, *cells, law))
    return table(("", "", *(f"N = {links}" for links in sizes), "grows with N to the"), rows)


def picture(result: Result, path: Path) -> None:
    """Log-log, a row of panels for each family."""
    from runtime.views.figure import grid

    families = list(result.details)
    figure, axes = grid(3 * len(families), "", columns=3, shared=False)
    figure.set_size_inches(10.5, 3.1 * len(families))
    for place, family in enumerate(families):
        for ax, (key, (what, unit, factor)) in zip(axes[3 * place : 3 * place + 3], SHOWN.items(), strict=True):
            for name, by_size in result.details[family].items():
                sizes = sorted(map(int, by_size))
                values = [factor * by_size[str(links)][key] for links in sizes]
                width = 2.0 if name == "this project" else 1.2
                ax.loglog(sizes, values, "o-", ms=3, lw=width, color=COLOURS.get(name, "k"), label=name)
            ax.set_title(f"{family}: {what} [{unit.replace('us', 'µs')}]", fontsize=9, loc="left")
            ax.set_xlabel("links", fontsize=8)
        axes[3 * place].legend(fontsize=7, frameon=False)
    path.parent.mkdir(parents=True, exist_ok=True)
    figure.savefig(path)


FIGURES: dict[str, Callable[[Result], str]] = {
    "scaling": partial(of_family, "chain in a plane"),
    "scaling.space": partial(of_family, "chain in space"),
}

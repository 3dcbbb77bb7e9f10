"""A branch of motions that repeat as one page: its picture, and a slider that chooses the motion whose curves show."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.records import packed
from runtime.results.export import column_units
from runtime.views.curves import COLOURS, SPECIALS
from runtime.views.viewer.page import View, page, shown, text_of

if TYPE_CHECKING:
    from runtime.orbits.branch import PeriodicBranch

SCRIPTS = ("numbers", "branch")
SAMPLES = 160  # of a motion, about


def branch_view(branch: PeriodicBranch, outputs: Sequence[str]) -> View:
    """The page of a branch and what leaves it. outputs: coordinates, rates or measures. Raises ModelError."""
    units, model = column_units(branch.model), branch.model
    branches = [_record(one, outputs) for one in branch.all]
    entry = next(one for one in model.parameters if one.name == branch.over)
    record = {
        "title": model.title or model.name,
        "about": f"motions that repeat over {branch.over}; solid: stable, dashed: unstable; in the circle: multipliers",
        "over": f"{branch.over} [{entry.unit or '-'}]",
        "outputs": [f"{name} [{units.get(name) or '-'}]" for name in outputs],
        "colours": COLOURS,
        "branches": branches,
        "specials": [
            special for one, made in zip(branch.all, branches, strict=True) for special in _specials(one, made)
        ],
    }
    return page("branch.html", record, text_of("branch.css"), SCRIPTS)


def show_branch(branch: PeriodicBranch, path: str | Path | None, outputs: Sequence[str]) -> View:
    """Written where a path is given; without one a notebook shows it, and elsewhere the browser opens it."""
    return shown(branch_view(branch, outputs), path)


def _record(branch: PeriodicBranch, outputs: Sequence[str]) -> dict[str, Any]:
    motions = []
    for k, point in enumerate(branch.points):
        run = branch.period_of(k, outputs=list(outputs), samples=SAMPLES)
        values = [run.outputs[name] for name in outputs]
        counted = point.floquet.counted.astype(complex)
        motions.append(
            {
                "value": point.value,
                "period": point.period,
                "stability": point.floquet.stability,
                "kind": point.floquet.kind,
                "multipliers": [[float(one.real), float(one.imag)] for one in counted],
                "largest": [float(np.abs(one).max()) for one in values],
                "t": packed(run.t - run.t[0]),
                "curves": [packed(one) for one in values],
            }
        )
    return {"doublings": branch.first.doublings, "motions": motions}


def _specials(branch: PeriodicBranch, made: dict[str, Any]) -> list[dict[str, Any]]:
    """Each at the height of the motion that is nearest on the curve."""
    found = []
    for one in branch.specials:
        near = int(np.abs(branch.values - one.value).argmin())
        largest = made["motions"][near]["largest"]
        found.append(
            {"kind": one.kind, "value": one.value, "largest": largest, "colour": SPECIALS.get(one.kind, "#111")}
        )
    return found

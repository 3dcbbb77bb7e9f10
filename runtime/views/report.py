"""The report of one run: a section is a function from a solution to plain values; `SECTIONS` lists them in order."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from runtime.results.solution import Solution


Section = Callable[["Solution"], dict[str, Any]]


def run_report(solution: Solution) -> dict[str, Any]:
    """All sections by name: plain numbers, texts, lists and dictionaries, SI units."""
    return {name: section(solution) for name, section in SECTIONS.items()}


def _model(solution: Solution) -> dict[str, Any]:
    model = solution.model
    return {
        "name": model.name,
        "title": model.title,
        "coordinates": len(model.coordinates),
        "independent": list(model.q_i),
        "elastic": len(model.elastic),
        "constraints": len(model.constraints),
        "loop_unknowns": list(model.loop_unknowns),
        "groups": {group.name: [model.q_i[k] for k in group.positions] for group in model.groups},
    }


def _scheme(solution: Solution) -> dict[str, Any]:
    steps = [float(solution.dt)]
    for ratio in solution.m:
        steps.append(steps[-1] / ratio)
    return {
        "name": solution.scheme,
        "dt": float(solution.dt),
        "m": [int(ratio) for ratio in solution.m],
        "step_of_each_group": steps,
    }


def _status(solution: Solution) -> dict[str, Any]:
    status = solution.status
    return {
        "ok": status.ok,
        "name": status.name,
        "time": float(status.time),
        "coordinate": status.coordinate,
        "cause": status.cause,
        "advice": status.advice,
    }


def _time(solution: Solution) -> dict[str, Any]:
    return {"start": float(solution.t[0]), "end": float(solution.t[-1]), "saved_samples": len(solution.t)}


def _energy(solution: Solution) -> dict[str, Any]:
    """Energies [J] at both ends; the balance also relative to the largest energy or work that occurred."""
    total, balance = solution.total_energy, solution.balance
    size = max(
        float(np.ptp(total)),
        float(np.abs(balance.work).max()),
        *(float(np.abs(solution.energy[key]).max()) for key in ("kinetic", "elastic", "potential")),
    )
    return {
        "initial": float(total[0]),
        "final": float(total[-1]),
        **{f"final_{key}": float(solution.energy[key][-1]) for key in ("kinetic", "elastic", "potential")},
        "work_done_on_the_system": float(balance.work[-1]),
        "largest_balance_error": balance.largest,
        "largest_balance_error_relative": balance.largest / size if size else 0.0,
        "balance_uncertainty": float(balance.uncertainty[-1]),
        "balance_resolved_by_the_samples": balance.resolved,
    }


def _constraints(solution: Solution) -> dict[str, Any]:
    error = solution.constraint_error
    return {"largest_error": float(error.max(initial=0.0)), "final_error": float(error[-1])}


def _statistics(solution: Solution) -> dict[str, Any]:
    return {key: value.item() if isinstance(value, np.generic) else value for key, value in solution.stats.items()}


def _final_state(solution: Solution) -> dict[str, Any]:
    model, q, q_dot = solution.model, solution.q[-1], solution.q_dot[-1]
    return {
        name: {"value": float(q[k]), "rate": float(q_dot[k]), "unit": model.coordinate(name).unit}
        for k, name in enumerate(model.coordinates)
    }


def _measures(solution: Solution) -> dict[str, Any]:
    """Last, smallest and largest value of each measure."""
    columns = solution.measures
    return {
        name: {
            "final": float(columns[-1, k]),
            "smallest": float(columns[:, k].min()),
            "largest": float(columns[:, k].max()),
        }
        for k, name in enumerate(solution.model.measures)
    }


def _extremes(solution: Solution) -> dict[str, Any]:
    """Smallest and largest value of each elastic coordinate."""
    return {
        name: {
            "smallest": float(solution[name].min()),
            "largest": float(solution[name].max()),
            "unit": solution.model.coordinate(name).unit,
        }
        for name in solution.model.elastic
    }


def _parameters(solution: Solution) -> dict[str, Any]:
    """What a person declared or wrote in the scene; precomputed data (mode integrals) stay out."""
    return {
        entry.name: {"value": float(value), "default": float(entry.default), "unit": entry.unit}
        for entry, value in zip(solution.model.parameters, solution.parameters, strict=True)
        if entry.kind != "data"
    }


def _operations(solution: Solution) -> dict[str, Any]:
    return dict(solution.model.operations)


SECTIONS: dict[str, Section] = {
    "model": _model,
    "scheme": _scheme,
    "time": _time,
    "status": _status,
    "energy": _energy,
    "constraints": _constraints,
    "statistics": _statistics,
    "final_state": _final_state,
    "measures": _measures,
    "elastic_extremes": _extremes,
    "parameters": _parameters,
    "operations": _operations,
}

"""The report of one run: plain numbers, texts, lists and dictionaries by section, SI units."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution


def run_report(solution: Solution) -> dict[str, Any]:
    """Report what was run, how it ended, and what came of it.

    Parameters
    ----------
    solution : Solution
        N samples.

    Returns
    -------
    dict
        The sections by name.
    """
    return {**_run(solution), "energy": _energy(solution), **_outcome(solution)}


def _run(solution: Solution) -> dict[str, Any]:
    """Model, scheme, time, status. Of parameters what a person declared; precomputed data (mode integrals) stay out."""
    model, status, steps = solution.model, solution.status, [float(solution.dt)]
    for ratio in solution.m:
        steps.append(steps[-1] / ratio)
    fields = {key: getattr(status, key) for key in ("ok", "name", "coordinate", "cause", "advice")}
    values = zip(model.parameters, solution.parameters, strict=True)
    return {
        "model": {
            "name": model.name,
            "title": model.title,
            "coordinates": len(model.coordinates),
            "independent": list(model.q_i),
            "elastic": len(model.elastic),
            "constraints": len(model.constraints),
            "loop_unknowns": list(model.loop_unknowns),
            "groups": {group.name: [model.q_i[k] for k in group.positions] for group in model.groups},
        },
        "scheme": {
            "name": solution.scheme,
            "dt": float(solution.dt),
            "m": [int(ratio) for ratio in solution.m],
            "step_of_each_group": steps,
        },
        "time": {"start": float(solution.t[0]), "end": float(solution.t[-1]), "saved_samples": len(solution.t)},
        "status": {**fields, "time": float(status.time)},
        "statistics": {k: v.item() if isinstance(v, np.generic) else v for k, v in solution.stats.items()},
        "parameters": {
            entry.name: {"value": float(value), "default": float(entry.default), "unit": entry.unit}
            for entry, value in values
            if entry.kind != "data"
        },
        "operations": dict(model.operations),
    }


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


def _outcome(solution: Solution) -> dict[str, Any]:
    """Constraint errors, the last state, and how far measures and elastic coordinates went."""
    model, error = solution.model, solution.constraint_error
    return {
        "constraints": {"largest_error": float(error.max(initial=0.0)), "final_error": float(error[-1])},
        "final_state": {
            name: {"value": float(q), "rate": float(rate), "unit": model.coordinate(name).unit}
            for name, q, rate in zip(model.coordinates, solution.q[-1], solution.q_dot[-1], strict=True)
        },
        "measures": {
            entry.name: {"final": float(values[-1]), **_span(values), **({"about": entry.about} if entry.about else {})}
            for entry, values in zip(model.description.measures, solution.measures.T, strict=True)
        },
        "elastic_extremes": {
            name: {**_span(solution[name]), "unit": model.coordinate(name).unit} for name in model.elastic
        },
    }


def _span(values: np.ndarray) -> dict[str, float]:
    return {"smallest": float(values.min()), "largest": float(values.max())}

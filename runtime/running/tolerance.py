"""A tolerance instead of a step: which settings it replaces, and how often the motion is then seen."""

from __future__ import annotations

from collections.abc import Mapping
from math import ceil
from typing import Any

from runtime.contract.model import Model
from runtime.schemes.catalogue import SCHEMES, scheme_kind
from runtime.schemes.options import LARGEST_TOLERANCE, SchemeError

MOST_SEEN = 1000  # states of a motion, where neither dt nor save_every says otherwise
LEAST_TOLERANCE = 1e-13
ROUNDING = 1e-6  # of a step: a motion is a whole number of them up to this


def takes_tolerance(scheme: str) -> bool:
    """Can the steps of this scheme follow from a tolerance?"""
    return scheme in SCHEMES and SCHEMES[scheme].adaptive is not None


def tolerance_of(model: Model, scheme: str | None, tolerance: float | None) -> float | None:
    """The tolerance of a run: what was given, or that of the scene where its own scheme runs.

    Raises SchemeError for a scheme whose steps are all of one length, and for a tolerance out of range.
    """
    name = scheme or str(model.simulation["scheme"])
    if tolerance is None and scheme is not None and not takes_tolerance(name):
        return None
    tolerance = model.simulation.get("tolerance") if tolerance is None else tolerance
    if tolerance is None:
        return None
    if scheme_kind(name).adaptive is None:
        able = ", ".join(one for one in SCHEMES if takes_tolerance(one))
        raise SchemeError(
            f"{name} takes steps of one length dt; a tolerance goes with {able}, or auto, which chooses among them"
        )
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance <= LARGEST_TOLERANCE:
        raise SchemeError(f"tolerance must be between 0 and {LARGEST_TOLERANCE:g}, not {tolerance!r}")
    if tolerance < LEAST_TOLERANCE:
        raise SchemeError(f"tolerance = {tolerance:g} is below what rounding leaves; give at least {LEAST_TOLERANCE:g}")
    return float(tolerance)


def whole_span(model: Model, t_end: float | None, t0: float) -> float:
    """Length of a motion [s]. Raises TypeError or ValueError for what is no time."""
    return float(model.simulation["t_end"] if t_end is None else t_end) - float(t0)


def with_tolerance(
    model: Model,
    scheme: str | None,
    tolerance: float | None,
    options: Mapping[str, Any] | None,
    t_end: float | None,
    dt: float | None,
    save_every: int | None,
    t0: float,
) -> tuple[Mapping[str, Any] | None, float | None, int | None]:
    """(options, dt, save_every) of a run: as they are without a tolerance, else with it, dt [s] from state to state."""
    asked = tolerance_of(model, scheme, tolerance)
    if asked is None:
        return options, dt, save_every
    try:
        span = whole_span(model, t_end, t0)
        seen = float(model.simulation["dt"]) * int(model.simulation["save_every"]) if dt is None else float(dt)
        steps = ceil(span / seen - ROUNDING) if dt is not None else min(MOST_SEEN, ceil(span / seen - ROUNDING))
        seen = span / max(1, steps)
    except (TypeError, ValueError, ArithmeticError):  # not numbers, or not a motion: make_plan says so
        return options, dt, save_every
    return (
        {**(options or {}), "tolerance": asked},
        seen if span > 0 and (dt is None or float(dt) > 0) else dt,
        save_every or 1,
    )

"""A tolerance instead of a step: which runs have one, and which values it may take."""

from __future__ import annotations

from runtime.contract.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import LARGEST_TOLERANCE, SchemeError

AUTO = "auto"
DEFAULT = 1e-3  # of `auto`
LEAST_TOLERANCE = 1e-13


def tolerance_of(model: Model, scheme: str | None, tolerance: float | None, dt: float | None = None) -> float | None:
    """The tolerance of a run: what was given, that of the scene where its own scheme runs without a step dt, or that of
    `auto`; None for a run with steps of its own. Raises SchemeError for one out of range, and for an unknown scheme.
    """
    name = scheme or (AUTO if tolerance is not None else str(model.simulation["scheme"]))
    if name != AUTO:
        scheme_kind(name)
    if tolerance is None and scheme in (None, AUTO):
        tolerance = model.simulation.get("tolerance") or (DEFAULT if name == AUTO else None)
    if tolerance is None:
        return None
    if isinstance(tolerance, bool) or not isinstance(tolerance, int | float) or not 0 < tolerance <= LARGEST_TOLERANCE:
        raise SchemeError(f"tolerance must be between 0 and {LARGEST_TOLERANCE:g}, not {tolerance!r}")
    if tolerance < LEAST_TOLERANCE:
        raise SchemeError(f"tolerance = {tolerance:g} is below what rounding leaves; give at least {LEAST_TOLERANCE:g}")
    return float(tolerance)

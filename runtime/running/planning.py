"""From what a user asks to a plan of steps of one length: defaults of the scene, and those that `auto` finds."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from runtime.contract.model import EmittedModel
from runtime.running.problem import AUTO, Plan, checked_plan
from runtime.schemes.options import SchemeError


def make_plan(
    model: EmittedModel,
    t_end: float | None,
    dt: float | None,
    m: list[int] | None,
    scheme: str | None,
    seen_every: float | None,
    options: Mapping[str, Any] | None,
    t0: float,
    bounded: bool = False,
) -> Plan:
    """Resolve defaults and check every number of a run. seen_every [s]: time from sample to sample, 0: every step.

    bounded: samples do not stay in memory. Raises SchemeError.
    """
    name, step = steps_asked(model, scheme, dt, m, options, t0, t_end)
    return checked_plan(model, t_end, step, m, name, seen_every, options, t0, bounded)


def steps_asked(
    model: EmittedModel,
    scheme: str | None,
    dt: float | None,
    m: list[int] | None,
    options: Mapping[str, Any] | None,
    t0: float = 0.0,
    t_end: float | None = None,
) -> tuple[str, float]:
    """(scheme, dt [s]) of steps of one length: what was given, else the scene's own; where neither names a scheme,
    what `auto` finds for the motion up to t_end as the scene has it. Raises SchemeError.
    """
    name = scheme or str(model.simulation["scheme"])
    if name != AUTO:
        return name, float(model.simulation["dt"]) if dt is None else dt
    if m is not None or options:
        raise SchemeError("auto chooses m and options itself; leave them out, or name a scheme")
    from runtime.running.step_refinement import usual_steps

    name, step = usual_steps(model, t0, t_end)
    return name, step if dt is None else dt

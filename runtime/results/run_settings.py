"""What `simulate` was asked for, as a run shows it: the arguments that make the run again."""

from __future__ import annotations

import json
import re
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.coordinates import named_values
from runtime.schemes.catalogue import SCHEMES, scheme_kind

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

SAME = 1e-12  # of a coordinate: two starts that are one
OPTION = re.compile(r"(\w+) = (\([^)]*\)|[^,]+)")


def settings_of(solution: Solution) -> dict[str, Any]:
    """Give the arguments of `simulate` that make the run again: its method and steps are those that it took."""
    found: dict[str, Any] = {}
    if solution.status.whole and solution.status.name != "event":  # else the end that was asked for is not known
        found["t_end"] = float(solution.t[-1])
    if solution.scheme in SCHEMES:  # prescribed motions alone need none
        options = _changed_options(solution)
        by_step = options.get("error_of") == "step"
        tolerance = options.pop("tolerance", None)
        found |= {"scheme": solution.scheme, **({"tolerance": tolerance} if by_step else {"dt": float(solution.dt)})}
        found |= {"m": list(solution.m)} if solution.m else {}
        found |= {"options": options} if options else {}
    if len(solution.t) > 2:
        found["seen_every"] = float(f"{np.median(np.diff(solution.t)):.12g}")
    decided = {*solution.driven, *set_by_events(solution), *_modes(solution)}  # in the run, not before it
    for what, inputs in (("parameters", False), ("inputs", True)):
        values = zip(solution.model.parameters, solution.parameters, strict=True)
        changed = {
            entry.name: float(value)
            for entry, value in values
            if (entry.kind == "input") is inputs and value != entry.default and entry.name not in decided
        }
        found |= {what: changed} if changed else {}
    return found | _start(solution)


def _modes(solution: Solution) -> set[str]:
    """Inputs that the run sets by itself: what sticks, which stops are closed."""
    return {entry.name for entry in solution.model.description.inputs if entry.hidden}


def set_by_events(solution: Solution) -> set[str]:
    """Name inputs and parameters that actions of events set, whose values at the end are not those of the start."""
    return {name for event in solution.model.description.events for name in event.sets} - _modes(solution)


def _changed_options(solution: Solution) -> dict[str, Any]:
    """Options of the scheme that are not its defaults, as the statistics have them."""
    usual = scheme_kind(solution.scheme).options().checked(len(solution.m) + 1)
    given = dict(OPTION.findall(str(solution.stats.get("options", ""))))
    return {
        name: _value(given[name])
        for name in usual.names()
        if name in given and given[name] != str(getattr(usual, name))
    }


def _value(text: str) -> Any:
    """A word, a number, or a list of numbers."""
    try:
        return json.loads(text.replace("(", "[").replace(",)", "]").replace(")", "]"))
    except ValueError:
        return text


def _start(solution: Solution) -> dict[str, Any]:
    """t0 and the initial state, where they are not those of the scene."""
    model, found = solution.model, dict[str, Any]()
    if solution.t[0] != 0.0:
        found["t0"] = float(solution.t[0])
    first = solution.initial_values(at=float(solution.t[0]))
    given = named_values(model, model.initial_q, model.initial_q_dot)
    told = {*model.q_i, *model.loop_unknowns}  # the rest follows from these
    entries = [entry for entry in model.description.coordinates if entry.name in told]
    own = [name for one in entries for name in ((one.owner,) if one.kind == "state" else (one.name, f"{one.name}_dot"))]
    if any(abs(first[name] - given[name]) > SAME * max(1.0, abs(given[name])) for name in own):
        found |= {"start": "given", "initial": {name: first[name] for name in own}}
    return found

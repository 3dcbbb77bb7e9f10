"""Outputs of a run by name, as expressions of the state of its scheme, so that they can be differentiated."""

from __future__ import annotations

from collections.abc import Sequence
from difflib import get_close_matches

import casadi as ca

from runtime.contract.coordinates import joined
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.results.samples import FORCE_PARTS
from runtime.schemes.scheme import Scheme

SHOWN = 25  # names that an error lists
ENERGIES = ("kinetic", "elastic", "potential", "power_applied", "power_dissipated")
Place = tuple[str, int, int]  # what it is a row and a column of: q, measures, ... or the name of an energy


def check_outputs(model: Model, names: Sequence[str]) -> tuple[str, ...]:
    """The names as they are kept. Raises ModelError for one that is not an output, and where there is none."""
    known = _places(model)
    if isinstance(names, str) or not names:
        raise ModelError(f"outputs must be a list of names such as [{next(iter(known))!r}], not {names!r}")
    for name in names:
        if name not in known:
            near = get_close_matches(str(name), known, 1)
            listed = ", ".join(list(known)[:SHOWN]) + (", ..." if len(known) > SHOWN else "")
            raise ModelError(
                f"model {model.name} has no output {name!r} that can be differentiated"
                + (f" (did you mean {near[0]!r}?)" if near else "")
                + f"; it has {listed}"
            )
    return tuple(names)


def _places(model: Model) -> dict[str, Place]:
    """Where each output is found, by name."""
    found: dict[str, Place] = {name: ("measures", k, 0) for k, name in enumerate(model.measures)}
    for k, name in enumerate(model.coordinates):
        found |= {name: ("q", k, 0), f"{name}_dot": ("q_dot", k, 0), f"{name}_ddot": ("q_ddot", k, 0)}
    if model.has("energy"):
        found |= {f"{prefix}{name}": (name, 0, 0) for name in ENERGIES for prefix in ("", "energy.")}
    found |= {f"measure.{name}": ("measures", k, 0) for k, name in enumerate(model.measures)}
    if model.has("reactions") and not model.redundant:
        found |= {f"lam.{row}": ("lam", k, 0) for k, row in enumerate(model.constraints)}
        parts = FORCE_PARTS[int(model.kernel("reactions").size1_out("joint_forces"))]
        found |= {
            f"{joint}.{part}": ("joint_forces", row, column)
            for column, joint in enumerate(model.joints)
            for row, part in enumerate(parts)
        }
    return found


def output_values(scheme: Scheme, names: Sequence[str], z: ca.SX, c: ca.SX) -> ca.SX:
    """The named outputs (n_y,) of the scheme's state z with the constants c that its stages read."""
    model, places = scheme.model, _places(scheme.model)
    equations = scheme.equations(c, scheme.layout.unpack(z))
    seen = scheme.observer(z=z, c=c)
    at: dict[str, ca.SX] = {"t": seen["t"]}
    for name, end in (("q", ""), ("q_dot", "_dot"), ("q_ddot", "_ddot")):
        at[name] = joined(model, seen[f"q_i{end}"], seen[f"q_d{end}"])
    wanted = [places[name] for name in names]
    values = dict(at)
    for function, provided in (
        ("measures", ("measures",)),
        ("energy", ENERGIES),
        ("reactions", ("lam", "joint_forces")),
    ):
        if any(kind in provided for kind, _, _ in wanted):  # a kernel is called where it is needed
            values |= equations.call(function, **at, lam_R=ca.SX(0, 1))
    return ca.vertcat(*(values[kind][row, column] for kind, row, column in wanted))

"""Coordinates, rates and measures of a scheme's state by name, as one Function."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.schemes.scheme import Scheme


def reading(model: Model, scheme: Scheme, z_size: int, names: Sequence[str]) -> ca.Function:
    """(z, c) -> the named values (k,); z may be longer than the scheme's part. Raises ModelError for another name."""
    z, c = ca.SX.sym("z", z_size), ca.SX.sym("c", scheme.c_size)
    own = z[: scheme.layout.size]
    seen = scheme.observer(z=own, c=c)
    where = {name: (kind, k) for kind, names in (("i", model.q_i), ("d", model.q_d)) for k, name in enumerate(names)}
    q, q_dot = (
        ca.vertcat(*(seen[f"q_{where[name][0]}{suffix}"][where[name][1]] for name in model.coordinates))
        for suffix in ("", "_dot")
    )
    known = {name: q[k] for k, name in enumerate(model.coordinates)}
    known |= {f"{name}_dot": q_dot[k] for k, name in enumerate(model.coordinates)}
    if model.measures:
        constants = scheme.constants_at(scheme.layout.unpack(own), c[: model.c_size])
        measured = model.evaluate("measures", q=q, q_dot=q_dot, t=seen["t"], c=constants)["measures"]
        known |= {name: measured[k] for k, name in enumerate(model.measures)}
    for name in names:
        if name not in known:
            raise ModelError(f"model {model.name} has no coordinate, rate or measure {name!r}")
    values = ca.vertcat(*(known[name] for name in names)) if names else ca.SX(0, 1)
    return ca.Function("reading", [z, c], [ca.densify(values)])

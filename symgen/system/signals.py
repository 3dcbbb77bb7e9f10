"""Inputs u as symbols, and time derivatives along them: what a prescribed motion does is f(t, u(t))."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

import casadi as ca

from runtime.contract.records import RATES, InputRecord
from symgen.joints import Joint
from symgen.system.constraint import DerivationError

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


def input_records(scene: SceneRecord) -> list[InputRecord]:
    """The inputs that a scene declares, and behind them those that a run itself sets."""
    found = [
        InputRecord(name, entry.unit, entry.description, entry.default, entry.has_rates, entry.filter or 0.0)
        for name, entry in scene.all_inputs().items()
    ]
    sliding, open_ = ("0 stuck, 1 or -1 sliding", 0.0), ("0 closed, 1 open, -1 left at rest", 1.0)
    return found + [
        InputRecord(mode, "", *(sliding if end == "friction" else open_), hidden=True)
        for joint in scene.joints
        for end, mode in modes_of(joint).items()
    ]


def modes_of(joint: Joint) -> dict[str, str]:
    """The inputs that say whether a joint sticks or to which side it slides, and whether its rigid stops are closed.

    By `friction`, `lower`, `upper`.
    """
    friction = ["friction"] if joint.rubs() is not None else []
    return {end: f"{joint.name}.{end}_mode" for end in (*friction, *joint.rigid_ends())}


def modes(scene: SceneRecord) -> list[str]:
    """Of the joints with friction and rigid stops."""
    return [mode for joint in scene.joints for mode in modes_of(joint).values()]


def input_units(scene: SceneRecord) -> dict[str, str]:
    """SI unit of each entry of u: inputs are measures, so that a solution holds them."""
    units = {
        part: (entry.unit or "1") + rate if rate else entry.unit
        for name, entry in scene.all_inputs().items()
        for part, rate in zip(entry.names(name), RATES, strict=False)
    }
    return units | dict.fromkeys(modes(scene), "")


def input_symbols(scene: SceneRecord) -> dict[str, ca.SX]:
    """A symbol for each entry of u, by name."""
    return {name: ca.SX.sym(name) for name in (*scene.input_defaults(), *modes(scene))}


def motion_derivatives(
    scene: SceneRecord, f: ca.SX, t: ca.SX, u: Mapping[str, ca.SX], item: str
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """(f, f', f'') of a prescribed motion f(t, u(t)). Raises DerivationError for an input without rates in it."""
    for name, symbol in u.items():
        if not ca.depends_on(f, symbol):
            continue
        if name not in scene.all_inputs():
            raise DerivationError(
                item,
                f"uses '{name}', whose own rate and acceleration are not known",
                "use the input itself: its rate and acceleration follow",
            )
        if not scene.all_inputs()[name].has_rates:
            raise DerivationError(
                item,
                f"uses the input '{name}', which may jump, and a motion needs a rate and an acceleration",
                f"give inputs.{name} rates = true, or a filter = ... [rad/s]",
            )
    rated = [name for name, entry in scene.all_inputs().items() if entry.has_rates]
    values = ca.vertcat(t, *(u[name] for name in rated), *(u[f"{name}_dot"] for name in rated))
    rates = ca.vertcat(1, *(u[f"{name}_dot"] for name in rated), *(u[f"{name}_ddot"] for name in rated))
    if not rated:
        f_t = ca.jacobian(f, t)
        return f, f_t, ca.jacobian(f_t, t)
    f_t = ca.jtimes(f, values, rates)
    return f, f_t, ca.jtimes(f_t, values, rates)

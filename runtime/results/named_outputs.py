"""What outputs are called and where each is found, as expressions of the state of a scheme."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from difflib import get_close_matches

import casadi as ca

from runtime.contract.coordinates import euler_angles, joined, parameter_columns
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angle_names, angles_of
from runtime.results.samples import FORCE_PARTS
from runtime.schemes.scheme import Scheme

ENERGIES = ("kinetic", "elastic", "potential", "power_dissipated", "power_applied")
ORDERS = ("", "_dot", "_ddot")
AXES = "xyz"
SHOWN_NAMES = 24  # names that an error lists


@dataclass(frozen=True)
class Column:
    """An output: entry `position` of the output `part` of a kernel; "state": of q, q_dot or q_ddot (part: suffix);
    "spin": angular velocity about an axis (part: x, y or z) of the body whose Euler parameters begin at `position`;
    "angle": one of its Euler angles, from -pi to pi (part: sequence and place of the angle).
    """

    kernel: str
    part: str
    position: int = 0

    @property
    def suffixes(self) -> set[str]:
        """Which of q, q_dot, q_ddot it reads, if it is one of these or made of them."""
        return {"state": {self.part}, "spin": {"", "_dot"}, "angle": {""}}.get(self.kernel, set())

    def of_state(self, whole: Callable[[str], ca.SX]) -> ca.SX:
        """Its expression, if it reads states only; whole(suffix): q, q_dot or q_ddot (n,)."""
        if self.kernel == "state":
            return ca.SX(whole(self.part)[self.position])
        own = slice(self.position, self.position + 4)
        e = ca.vertsplit(whole("")[own])
        if self.kernel == "angle":
            return ca.SX(angles_of(self.part[:3], e, ca.atan2, ca.cos, ca.sin)[int(self.part[3])])
        return _spin(e, ca.vertsplit(whole("_dot")[own]), AXES.index(self.part))


def column(model: EmittedModel, name: str) -> Column:
    """What an output is called by, as in `simulate`. Raises ModelError for an unknown name."""
    known = {**_reactions(model), **_quantities(model)}
    if name not in known:
        near = get_close_matches(str(name), known, 1)
        meant = f" (did you mean {near[0]!r}?)" if near else ""
        listed = [*model.coordinates, *model.measures, *ENERGIES]
        more = ", ..." if len(listed) > SHOWN_NAMES else ""
        raise ModelError(
            f"output {name!r}",
            f"model {model.name} has no output of this name{meant}",
            f"take one of {', '.join(listed[:SHOWN_NAMES])}{more}, rates `_dot`, accelerations `_ddot`, `lam.row`, or "
            "a joint's force",
        )
    found = known[name]
    if found.kernel in ("reactions", "acceleration_measures") and model.redundant:
        raise ModelError(
            f"output {name!r}",
            f"model {model.name} has redundant constraints, whose reactions need a choice that single runs make",
            "leave it out, or simulate",
        )
    return found


def _quantities(model: EmittedModel) -> dict[str, Column]:
    """Energies, measures and coordinates by name; of two that share a name, the last counts."""
    found: dict[str, Column] = {}
    if model.has("energy"):
        found |= {f"{prefix}{name}": Column("energy", name) for name in ENERGIES for prefix in ("", "energy.")}
    for kernel, names in (("measures", model.state_measures), ("acceleration_measures", model.acceleration_measures)):
        for k, name in enumerate(names):
            found |= {f"{prefix}{name}": Column(kernel, kernel, k) for prefix in ("", "measure.")}
    for k, name in enumerate(model.coordinates):
        found |= {f"{name}{suffix}": Column("state", suffix, k) for suffix in ORDERS}
    kinds = euler_angles(model)
    for body, e in parameter_columns(model).items():
        if body in kinds:
            found |= {name: Column("angle", f"{kinds[body]}{k}", e[0]) for k, name in enumerate(angle_names(body))}
        found |= {f"{body}.omega_{axis}": Column("spin", axis, e[0]) for axis in AXES}
    return found


def _reactions(model: EmittedModel) -> dict[str, Column]:
    """Multipliers and joint forces by name."""
    if not model.constraints or not model.has("reactions"):
        return {}
    found = {f"lam.{row}": Column("reactions", "lam", k) for k, row in enumerate(model.constraints)}
    parts = FORCE_PARTS[int(model.kernel("reactions").size1_out("joint_forces"))]
    for k, joint in enumerate(model.joints):
        found |= {
            f"{joint}.{part}": Column("reactions", "joint_forces", k * len(parts) + axis)
            for axis, part in enumerate(parts)
        }
    return found


def _spin(e: Sequence[ca.SX], e_dot: Sequence[ca.SX], axis: int) -> ca.SX:
    """Component of 2 conj(e) o e', added up as runtime/contract/orientations.py does."""
    i, j = 1 + (axis + 1) % 3, 1 + (axis + 2) % 3
    a = [e[0], *(-part for part in e[1:])]
    return 2 * ((a[0] * e_dot[1 + axis] + e_dot[0] * a[1 + axis]) + (a[i] * e_dot[j] - a[j] * e_dot[i]))


def output_values(scheme: Scheme, names: Sequence[str], z: ca.SX, c: ca.SX) -> ca.SX:
    """The named outputs (n_y,) of the scheme's state z with the constants c that its stages read.

    Raises ModelError for an unknown name.
    """
    model, columns = scheme.model, [column(scheme.model, name) for name in names]
    equations = scheme.equations(c, scheme.layout.unpack(z))
    observed = scheme.observer(z=z, c=c)
    at = {f"q{end}": joined(model, observed[f"q_i{end}"], observed[f"q_d{end}"]) for end in ORDERS} | {
        "t": observed["t"]
    }
    kernels = {one.kernel for one in columns if not one.suffixes}
    found = {kernel: equations.call(kernel, **at, lam_R=ca.SX(0, 1)) for kernel in kernels}

    def value(one: Column) -> ca.SX:
        if one.suffixes:
            return one.of_state(lambda end: at[f"q{end}"])
        return ca.SX(ca.vec(found[one.kernel][one.part])[one.position])

    return ca.SX(ca.vertcat(*map(value, columns)))

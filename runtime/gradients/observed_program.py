"""A step of a scheme, and the named outputs of its state, as programs on one vector z = [scheme's z, outputs, ...]."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from difflib import get_close_matches

import casadi as ca

from runtime.contract.coordinates import joined
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.contract.tape import shared
from runtime.engine.derivatives import Active
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import Call, Program
from runtime.engine.program import Sequence as InTurn
from runtime.results.samples import FORCE_PARTS
from runtime.schemes.scheme import Scheme


@dataclass(frozen=True)
class ObservedProgram:
    """step: one major step; observe: puts the outputs into z[outputs]; both on prepared constants.

    active: what of z and of the constants the parameters and initial values act through.
    """

    scheme: Scheme
    prepared: Prepared
    step: Program
    observe: Program
    outputs: slice
    active: Active

    @property
    def output_rows(self) -> range:
        """Where the outputs lie among the active entries of z."""
        first = self.active.z.index(self.outputs.start)
        return range(first, first + self.outputs.stop - self.outputs.start)


def observed_program(scheme: Scheme, names: Sequence[str], parameters: Sequence[int]) -> ObservedProgram:
    """For outputs by name, differentiated by these entries of p and by initial values."""
    scheme.of_one_length("a derivative of a run")
    first = scheme.layout.size
    outputs = slice(first, first + len(names))
    z, c = ca.SX.sym("z", outputs.stop), ca.SX.sym("c", scheme.c_size)
    seen = ca.vertcat(z[:first], ca.densify(output_values(scheme, names, z[:first], c)))
    observe = ca.Function("observe_outputs", [z, c], shared([seen]), ["z", "c"], ["z_next"])
    step = scheme.program().map(lambda stage: _widened(stage, outputs.stop))
    prepared = prepare(InTurn((step, Call(observe))), outputs.stop, scheme.c_size)
    assert isinstance(prepared.program, InTurn)
    stepping, observing = prepared.program.parts
    z_size, c_size = prepared.z_size, int(prepared.constants.size1_out(0))
    kept = [name for name in scheme.bookkeeping if name != "inputs"]  # through which what is held acts on the motion
    fixed = {k for name in kept for k in range(*scheme.layout.slice(name).indices(first))}
    moving = tuple(k for k in range(z_size) if k not in fixed)
    active = Active(moving, _acting(scheme, prepared, parameters), z_size, c_size)
    return ObservedProgram(scheme, prepared, stepping, observing, outputs, active)


def _widened(stage: ca.Function, size: int) -> ca.Function:
    """The stage on z with room for outputs, which it leaves alone."""
    z, c = ca.SX.sym("z", size), ca.SX.sym("c", stage.size1_in(1))
    result = stage(z[: stage.size1_in(0)], c)
    return ca.Function(stage.name(), [z, c], [ca.vertcat(result, z[result.numel() :])], ["z", "c"], ["z_next"])


def _acting(scheme: Scheme, prepared: Prepared, parameters: Sequence[int]) -> tuple[int, ...]:
    """Entries of the prepared constants that depend on these entries of p."""
    p = ca.SX.sym("p", len(scheme.model.parameters))
    ready = prepared.constants(ca.vertcat(scheme.model.kernel("constants")(p), *scheme.grid.h))
    pattern = ca.Function("ready", [p], [ca.densify(ready)]).jac_sparsity(0, 0)
    wanted = set(parameters)
    return tuple(sorted({int(row) for row, column in zip(*pattern.get_triplet(), strict=True) if column in wanted}))


# Outputs of a run by name, as expressions of the state of its scheme, so that they can be differentiated.

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

"""A step of a scheme, and the named outputs of its state, as programs on one vector z = [scheme's z, outputs, ...]."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca

from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared
from runtime.engine.derivatives import Active
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import Call, Program
from runtime.engine.program import Sequence as InTurn
from runtime.results.named_outputs import column, output_values
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
    observed = ca.vertcat(z[:first], ca.densify(output_values(scheme, names, z[:first], c)))
    observe = ca.Function("observe_outputs", [z, c], shared([observed]), ["z", "c"], ["z_next"])
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


def check_outputs(model: EmittedModel, names: Sequence[str]) -> tuple[str, ...]:
    """The names as they are kept. Raises ModelError for one that is not an output, and where there is none."""
    if isinstance(names, str) or not names:
        raise ModelError(f"outputs must be a list of names such as {model.q_i[:1]}, not {names!r}")
    for name in names:
        column(model, name)
    return tuple(names)

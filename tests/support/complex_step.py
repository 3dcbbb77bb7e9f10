"""A run evaluated in complex numbers: with p + i h its outputs' imaginary parts over h are derivatives to rounding.

Only the step program itself is used, node by node; nothing that differentiates. Comparisons look at real parts.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np

from runtime import DifferentiableRun
from runtime.contract.tape import UNUSED, Tape, marked, read_tape
from runtime.engine.program import Call, Program, Repeat, Until

H = 1e-40


def _by_real(test: Callable[[float, float], bool]) -> Callable[[complex, complex], complex]:
    return lambda a, b: complex(test(a.real, b.real))


UNARY: dict[int, Callable[[complex], complex]] = {
    ca.OP_ASSIGN: lambda a: a,
    ca.OP_NEG: lambda a: -a,
    ca.OP_SQ: lambda a: a * a,
    ca.OP_TWICE: lambda a: a + a,
    ca.OP_INV: lambda a: 1 / a,
    ca.OP_SQRT: np.sqrt,
    ca.OP_SIN: np.sin,
    ca.OP_COS: np.cos,
    ca.OP_FABS: lambda a: -a if a.real < 0 else a,
    ca.OP_NOT: lambda a: complex(a.real == 0),
    ca.OP_SIGN: lambda a: complex(np.sign(a.real)),
}
BINARY: dict[int, Callable[[complex, complex], complex]] = {
    ca.OP_ADD: lambda a, b: a + b,
    ca.OP_SUB: lambda a, b: a - b,
    ca.OP_MUL: lambda a, b: a * b,
    ca.OP_DIV: lambda a, b: a / b,
    ca.OP_CONSTPOW: lambda a, b: a**b.real,
    ca.OP_POW: lambda a, b: a**b,
    ca.OP_LT: _by_real(lambda a, b: a < b),
    ca.OP_LE: _by_real(lambda a, b: a <= b),
    ca.OP_AND: _by_real(lambda a, b: bool(a and b)),
    ca.OP_OR: _by_real(lambda a, b: bool(a or b)),
    ca.OP_FMAX: lambda a, b: a if a.real > b.real else b,
    ca.OP_FMIN: lambda a, b: a if a.real < b.real else b,
    ca.OP_IF_ELSE_ZERO: lambda a, b: b if a.real else 0j,
}


def evaluated(tape: Tape, *inputs: np.ndarray) -> np.ndarray:
    """The first output at complex inputs."""
    values: list[complex] = []
    for op, a, b, value in tape.nodes:
        if op == ca.OP_CONST:
            values.append(complex(value))
        elif op == ca.OP_INPUT:
            values.append(complex(inputs[a][b]))
        elif op == ca.OP_CALL:
            table, order = marked(value)
            values.append(complex(table(values[a], order)))
        else:
            values.append(UNARY[op](values[a]) if b == UNUSED else BINARY[op](values[a], values[b]))
    return np.array([values[k] for k in tape.outputs[0]])


def derivatives(run: DifferentiableRun, name: str, initial: Mapping[str, float] | None = None) -> np.ndarray:
    """(N, n_y) derivatives of the outputs by a parameter, or by an initial value of q_i, at the run's start.

    initial: values and rates of q_i that the run starts from instead of the model's.
    """
    model, scheme, program = run.model, run.plan.scheme, run.program
    p, q, v = model.parameter_vector().astype(complex), model.initial_q.astype(complex), model.initial_q_dot + 0j
    for key, value in (initial or {}).items():
        part = v if key.endswith("_dot") else q
        part[model.coordinates.index(key.removesuffix("_dot"))] = value
    names = [parameter.name for parameter in model.parameters]
    if name in names:
        p[names.index(name)] += 1j * H
    elif name in model.coordinates:
        q[model.coordinates.index(name)] += 1j * H
    else:
        v[model.coordinates.index(name.removesuffix("_dot"))] += 1j * H
    tapes = {stage.name(): read_tape(stage) for part in (program.step, program.observe) for stage in part.stages()}
    c = np.concatenate([evaluated(read_tape(model.kernel("constants")), p), scheme.grid.h])
    i = model.independent_columns
    z = evaluated(
        read_tape(scheme.starter),
        np.array([run.plan.t0]),
        q[i],
        v[i],
        q[[model.coordinates.index(name) for name in model.loop_unknowns]],
        c,
    )
    z = np.concatenate([z, np.zeros(program.prepared.z_size - len(z))])
    ready = evaluated(read_tape(program.prepared.constants), c)

    def apply(part: Program) -> None:
        nonlocal z
        if isinstance(part, Call):
            z = evaluated(tapes[part.stage.name()], z, ready)
        elif isinstance(part, Repeat):
            for _ in range(part.count):
                apply(part.body)
        elif isinstance(part, Until):
            for _ in range(part.limit):
                if not z[part.flag].real > 0:
                    break
                apply(part.body)
        else:
            for inner in part.parts:  # type: ignore[attr-defined]
                apply(inner)

    found = []
    for stop in run.course.stops:
        for _ in range(stop.steps):
            apply(program.step)
        apply(program.observe)
        found.append(z[program.outputs].imag / H)
    return np.array(found)

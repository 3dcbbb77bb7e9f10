"""Forces that jump at a time which depends on what is differentiated by: found, and refused by name.

Where a force switches (`where`, `sign`, `step`) at a fixed time, the derivative of the run is that of its branches.
Where the time of a jump moves with a parameter or with the motion, the motion's derivative has a further part that no
branch shows (saltation). Steps that end at the jump have it, see turns.py; other jumps are refused. So the conditions
in Q_hat that depend on either are watched along the run; where one changes, the step is halved down to that place, and
the two branches are compared there. Branches that meet (a spring that goes slack) are right.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.coordinates import independent_part, loop_part, whole
from runtime.contract.errors import NoResult
from runtime.contract.tape import UNUSED, Tape, node_value, read_tape
from runtime.engine.native import NativeProgram
from runtime.gradients.course import Course, Stop
from runtime.gradients.observed_program import ObservedProgram
from runtime.gradients.started_run import StartedRun
from runtime.running.problem import Plan
from runtime.schemes.stage_equations import StageEquations
from runtime.schemes.switching.times import has_switching_times
from runtime.schemes.switching.watched import held_kinks

SWITCHING = (ca.OP_LT, ca.OP_LE, ca.OP_EQ, ca.OP_NE, ca.OP_SIGN, ca.OP_FLOOR, ca.OP_CEIL, ca.OP_FMOD)
SWITCH_HALVINGS = 60
SAME_JUMP = 1e-6  # of a step: a jump so near to one whose time counts is that one
MEETING = 1e-6  # of the force: branches that differ by less meet


@dataclass(frozen=True)
class _SwitchConditions:
    """conditions: (t, q_i, q_i_dot, loop, c) -> their values; forces: (the same, values) -> Q_hat with these values."""

    conditions: ca.Function
    forces: ca.Function


class Switches:
    """The conditions in the forces of a run that may change at a time which depends on these entries of p."""

    def __init__(self, plan: Plan, program: ObservedProgram, parameters: Sequence[int]) -> None:
        self._plan, self._program = plan, program
        self._switch_conditions = _switch_conditions(plan, parameters)

    def check(
        self, started: StartedRun, course: Course, turned: Callable[[Stop, np.ndarray, StartedRun], np.ndarray]
    ) -> None:
        """Look along a run. Raises NoResult for a force that jumps there. turned: see RunCode."""
        if self._switch_conditions is None:
            return
        stepping, z = NativeProgram(self._program.step), started.z.copy()
        kinks = held_kinks(self._plan.scheme)
        crossings = (stop.turn.crossing for stop in course.stops if stop.turn is not None)
        known = np.array([one.clock for one in crossings if one is not None and one.event in kinks])
        for stop in course.stops:
            ready = turned(stop, z, started)
            c, constants = self._constants(z, ready), ready[: self._plan.scheme.c_size]
            before = self._at(z, constants)
            for _ in range(stop.steps):
                held = self._conditions(before, c)
                stepping.run(z, ready, 1)
                after = self._at(z, constants)
                for k in np.flatnonzero(held != self._conditions(after, c)):
                    self._compare(int(k), before, after, held, c, known)
                before = after

    def _constants(self, z: np.ndarray, ready: np.ndarray) -> np.ndarray:
        """The model's c with the inputs that z holds."""
        scheme, c = self._plan.scheme, ready[: self._plan.scheme.model.c_size].copy()
        if "inputs" in scheme.layout.sizes:
            held = z[scheme.layout.slice("inputs")]
            c[len(c) - len(held) :] = held
        return c

    def _at(self, z: np.ndarray, constants: np.ndarray) -> np.ndarray:
        """(t, q_i, q_i_dot, loop unknowns) that a state shows."""
        scheme, model = self._plan.scheme, self._plan.scheme.model
        observed = scheme.observer(z=z[: scheme.layout.size], c=constants)
        t, q_i, rates, q_d = (np.asarray(observed[key]).ravel() for key in ("t", "q_i", "q_i_dot", "q_d"))
        q = whole(model, q_i, q_d)
        return np.concatenate([t, independent_part(model, q), rates, loop_part(model, q)])

    def _conditions(self, at: np.ndarray, c: np.ndarray) -> np.ndarray:
        assert self._switch_conditions is not None
        return np.asarray(self._switch_conditions.conditions(at, c)).ravel()

    def _compare(
        self, k: int, before: np.ndarray, after: np.ndarray, held: np.ndarray, c: np.ndarray, known: np.ndarray
    ) -> None:
        """The forces of both branches where condition k changes between two states; known: of which times the
        derivatives are in that of the run [s].
        """
        assert self._switch_conditions is not None
        low, high = 0.0, 1.0
        for _ in range(SWITCH_HALVINGS):
            middle = (low + high) / 2
            at = before + middle * (after - before)
            low, high = (middle, high) if self._conditions(at, c)[k] == held[k] else (low, middle)
        dt = self._plan.grid.dt_L
        if len(known) and np.abs(known - (before[0] + high * (after[0] - before[0]))).min() <= SAME_JUMP * dt:
            return
        at, until = (before + share * (after - before) for share in (high, low))
        values = (self._conditions(at, c), self._conditions(until, c))
        Q = [np.asarray(self._switch_conditions.forces(at, c, one)).ravel() for one in values]
        gap = np.abs(Q[0] - Q[1])
        scale = max(np.abs(Q[0]).max(), np.abs(Q[1]).max(), 1e-300)
        if gap.max() > MEETING * scale:
            worst = self._plan.scheme.model.q_i[int(gap.argmax())]
            raise NoResult(
                f"model {self._plan.scheme.model.name}",
                f"the force on {worst} jumps by {gap.max():.4g} at t = {at[0]:.6g} s, a time that depends on what is "
                "differentiated by; the derivative of that time is not in the derivative of the run",
                "let the force change in a finite time (a ramp of some steps), switch at a fixed time, or leave out "
                "of `by` what moves the switch",
            )


def _switch_conditions(plan: Plan, parameters: Sequence[int]) -> _SwitchConditions | None:
    """None where no condition depends on the motion or on these entries of p."""
    model, n = plan.scheme.model, len(plan.scheme.model.q_i)
    at, c = ca.SX.sym("at", 1 + 2 * n + len(model.loop_unknowns)), ca.SX.sym("c", model.c_size)
    equations = StageEquations(model, c)
    motion = equations.close(at[1 : 1 + n], at[1 + 2 * n :], at[0], 2)
    Q_hat = equations.condensed(motion, at[1 + n : 1 + 2 * n])[1]
    tape = read_tape(ca.Function("forces", [at, c], [ca.densify(Q_hat)], ["at", "c"], ["Q_hat"]))
    in_time = has_switching_times(model)  # then steps end where conditions in time change, and what moves them is known
    moved = set() if in_time else set(_columns(model.kernel("constants"), parameters))
    chosen = _moving(tape, moved)
    if not chosen:
        return None
    symbols = ca.SX.sym("conditions", len(chosen))
    values: list[ca.SX] = []
    conditions: list[ca.SX] = []
    entries = {"at": ca.vertsplit(at), "c": ca.vertsplit(c)}
    plain: list[ca.SX] = []
    for k, node in enumerate(tape.nodes):
        given = entries[tape.input_names[node.a]] if node.op == ca.OP_INPUT else []
        plain.append(_discrete(node.op, plain, node.a, node.b) if k in chosen else node_value(node, plain, given))
        if k in chosen:
            conditions.append(plain[k])
            value = symbols[len(conditions) - 1]
            values.append(values[node.a] - values[node.b] * value if node.op == ca.OP_FMOD else value)
        else:
            values.append(node_value(node, values, given))
    forces = ca.vertcat(*(values[k] for k in tape.outputs[0]))
    return _SwitchConditions(
        ca.Function("conditions", [at, c], [ca.densify(ca.vertcat(*conditions))]),
        ca.Function("forces", [at, c, symbols], [ca.densify(forces)]),
    )


def _discrete(op: int, values: list[ca.SX], a: int, b: int) -> ca.SX:
    """What changes by jumps only."""
    if op == ca.OP_FMOD:
        return ca.floor(ca.fabs(values[a] / values[b])) * ca.sign(values[a] / values[b])
    return ca.SX.unary(op, values[a]) if b == UNUSED else ca.SX.binary(op, values[a], values[b])


def _columns(constants: ca.Function, parameters: Sequence[int]) -> list[int]:
    """Entries of c that depend on these entries of p."""
    rows, columns = constants.jac_sparsity(0, 0).get_triplet()
    return [row for row, column in zip(rows, columns, strict=True) if column in set(parameters)]


def _moving(tape: Tape, moved: set[int]) -> set[int]:
    """Switching nodes whose condition depends on the motion, or on a moved entry of c."""
    depends: list[bool] = []
    found = set()
    for k, node in enumerate(tape.nodes):
        if node.op == ca.OP_INPUT:
            depends.append(node.b > 0 if tape.input_names[node.a] == "at" else node.b in moved)
        elif node.op == ca.OP_CONST:
            depends.append(False)
        else:
            depends.append(depends[node.a] or (node.b != UNUSED and depends[node.b]))
            if depends[k] and node.op in SWITCHING:
                found.add(k)
    return found

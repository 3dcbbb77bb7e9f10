"""Cases in which a load or a prescribed motion jumps in time: their steps end there, each at its own times."""

from __future__ import annotations

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.contract.tape import read_tape
from runtime.running.plan import Plan
from runtime.running.stepping import may_jump
from runtime.schemes.switching.times import switching_times
from runtime.studies.ensemble.starts import Starts


def jumping(plan: Plan, starts: Starts) -> np.ndarray:
    """(cases,) does something jump in time during the run, or are there events? Raises ModelError for too many."""
    model, cases = plan.scheme.model, len(starts.close)
    found = np.full(cases, bool(model.description.events))
    if found.all() or not may_jump(model):
        return found
    used, known = _constants_of(model), dict[bytes, bool]()
    for case in range(cases):
        p = starts.p.copy()
        for position, values in starts.varied.items():
            p[position] = values[case]
        c = model.constants(p)
        key = c[used].tobytes()
        if key not in known:
            known[key] = bool(switching_times(model, c, plan.t0, plan.t_end))
        found[case] = known[key]
    return found


def _constants_of(model: Model) -> list[int]:
    """Entries of c that the conditions are made of."""
    if not model.has("switching"):
        return []
    tape = read_tape(model.kernel("switching"))
    inputs = (node for node in tape.nodes if node.op == ca.OP_INPUT)
    return sorted({node.b for node in inputs if tape.input_names[node.a] == "c"})

"""The start of runs in lanes as one program: parameters to constants, assembly, preparation, the scheme's own start.

A lane's row begins with what it is given (p, t, h, q_i, q_i_dot, a guess of q_d, whether that is to be closed, and
whether elastic coordinates are to be brought into equilibrium;
where turns follow from loops, whether it was to be closed, and all coordinates and rates);
c, what the step program reads and its z follow. Functions are called on entries of the row only, each a stage of its
own, so that a lane has the bits of a run by itself.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca

from runtime.contract.consistent_state import MAX_ITERATIONS
from runtime.contract.model import Model
from runtime.engine.prepare import Prepared
from runtime.engine.program import Call, Fields, Layout, Program, Repeat, Sequence, Until, make_stage
from runtime.operating.given_state import closable, closing, fitting
from runtime.running.stepped_model import HIGHEST, LOWEST
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import start_there
from runtime.studies.ensemble.settle import settle_fields, settle_program

NO_CONSTANTS = 1  # the begin reads none: its c is whatever stands first in the row
Stage = Callable[[Fields], Mapping[str, ca.SX]]


def row_layout(
    model: Model, scheme: Scheme, ready: int, constants: int, lane: Layout, looks: int, settle: bool
) -> Layout:
    """Fields of a lane's row; constants: of the scheme that steps with stops read behind `ready`, if there are any.

    settle: may lanes be brought into elastic equilibrium?
    """
    n_i = len(model.q_i)
    given = {"p": len(model.parameters), "t": 1, "h": len(scheme.grid.h), "q_i": n_i, "q_i_dot": n_i}
    given |= {"q_d": len(model.q_d), "close": 1, "settle": 1, "clock": 1}
    if not model.places.all_independent:
        given |= {"asked": 1, "q": len(model.coordinates), "q_dot": len(model.coordinates)}
    found = {
        "c": model.c_size,
        "fits": 1,
        **(settle_fields(model) if settle else {}),
        "ready": ready,
        "constants": constants,
        "lane": lane.size,
    }
    return Layout({**given, **found, "look": looks})


def begin_program(
    model: Model, scheme: Scheme, prepared: Prepared, row: Layout, lane: Layout, outputs: Program, begin: Stage
) -> Program:
    """From what is given to z at step 0, outputs included; outputs, begin: on the fields of `lane`."""

    def stage(name: str, body: Stage) -> Call:
        return make_stage(name, row, NO_CONSTANTS, lambda z, c: body(z))

    parts: list[Program] = [stage("begin_constants", lambda z: {"c": model.kernel("constants")(z["p"])})]
    if closable(model):
        flag = row.slice("close").start

        def close(z: Fields) -> Mapping[str, ca.SX]:
            q_d, open_ = closing(model)(z["q_i"], z["q_d"], z["t"], z["c"])
            return {"q_d": q_d, "close": open_}

        def fit(z: Fields) -> Mapping[str, ca.SX]:
            q, q_dot, fits = fitting(model)(z["q_i"], z["q_i_dot"], z["q_d"], z["t"], z["c"])
            found = {"fits": ca.logic_and(fits, z["close"] <= 0)}
            if "asked" not in z:
                return found
            told = (("q", q), ("q_dot", q_dot))
            return found | {name: ca.if_else(z["asked"] > 0, value, z[name]) for name, value in told}

        parts += [Until(stage("begin_close", close), flag, MAX_ITERATIONS, 4), stage("begin_fit", fit)]
    if "settled" in row.sizes:
        parts.append(settle_program(model, row, stage))
    parts.append(stage("begin_ready", lambda z: {"ready": prepared.constants(ca.vertcat(z["c"], z["h"]))}))
    if row.sizes["constants"]:
        parts.append(stage("begin_constants_of_stops", lambda z: {"constants": ca.vertcat(z["c"], z["h"])}))
    parts.append(stage("begin_state", lambda z: {"lane": _started(model, scheme, lane, z)}))
    parts.append(moved(outputs, row, "begin_"))

    def account(z: Fields) -> Mapping[str, ca.SX]:
        fields = lane.unpack(z["lane"])
        return {"lane": lane.pack({**fields, **begin(fields)})}

    return Sequence((*parts, stage("begin_account", account)))


def moved(program: Program, row: Layout, prefix: str) -> Program:
    """A program on (lane, ready) as one on whole rows."""
    first = row.slice("lane").start
    done: dict[str, Call] = {}

    def call(stage: ca.Function) -> Program:
        def body(z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
            return {"lane": stage(z["lane"], z["ready"])}

        if stage.name() not in done:
            done[stage.name()] = make_stage(prefix + stage.name(), row, NO_CONSTANTS, body)
        return done[stage.name()]

    def again(body: Program, node: Repeat | Until) -> Program:
        if isinstance(node, Repeat):
            return Repeat(body, node.count)
        return Until(body, first + node.flag, node.limit, node.usual)

    return program.fold(call, lambda parts: Sequence(tuple(parts)), again)


def _started(model: Model, scheme: Scheme, lane: Layout, z: Fields) -> ca.SX:
    """The lane's z at step 0 (Eqs. 68-71); the account of a run begins."""
    loops = [model.q_d.index(name) for name in model.loop_unknowns]
    loop = z["q_d"][loops] if loops else ca.SX(0, 1)
    c = ca.vertcat(z["c"], z["h"])
    if "asked" in z:
        state = start_there(scheme)(z["clock"], z["q"], z["q_dot"], c)
    else:
        state = scheme.starter(z["clock"], z["q_i"], z["q_i_dot"], loop, c)
    fields = scheme.layout.unpack(state)
    blocks = scheme.layout.sizes["det_low"]
    fields |= {"t0": z["t"] + (z["clock"] - z["t"]), "n": ca.SX(0)}
    fields |= {"det_low": LOWEST * ca.SX.ones(blocks), "det_high": HIGHEST * ca.SX.ones(blocks)}
    empty = {name: ca.SX.zeros(size) for name, size in lane.sizes.items()}
    if "stop_t0" in lane.sizes:
        empty |= {"stop_t0": z["t"], "stop_inputs": fields.get("inputs", ca.SX(0, 1))}
    return lane.pack({**empty, "scheme": scheme.layout.pack(fields)})

"""An ensemble as programs on lanes and their code: the start, the steps, samples and looks."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Callable, Mapping
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import MAX_ASSEMBLY_ITERATIONS
from runtime.contract.coordinates import mechanism_length
from runtime.contract.model import EmittedModel
from runtime.engine.gpu import GpuCode, the_gpu
from runtime.engine.native import LaneCode, lane_form, lane_width, once_form, program_size
from runtime.engine.prepare import Prepared, prepare
from runtime.engine.program import Call, Fields, Layout, Program, Repeat, Sequence, Until, make_stage
from runtime.operating.given_state import closable, closing, fitting
from runtime.running.stepped_model import NO_HIGHEST, NO_LOWEST
from runtime.schemes.scheme import LARGEST_NUMBER, Scheme
from runtime.schemes.stepper import start_there
from runtime.schemes.switching.impulse import moves_in_time
from runtime.schemes.switching.stop_program import StopProgram
from runtime.schemes.switching.times import may_jump
from runtime.schemes.switching.watched import looking, with_events
from runtime.start.quasi_static import (
    MAX_SETTLING_STEPS,
    SETTLING_PASSES,
    elastic_residual,
    leading,
    positions,
    settles,
    settling,
    smooth_sides,
)
from runtime.studies.ensemble.account import FIELDS, LaneAccount, looked
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.observation import Observation


class LanePrograms:
    """width: how many runs go side by side (None: as this machine has it); row, lane: what a run keeps.

    Each of `steps`, `begin`, `observe` and `look` is code; steps works on a lane's z and constants, the others on
    rows.
    """

    def __init__(self, spec: EnsembleSpec, width: int | None = None) -> None:
        model = self.model = spec.model
        self.spec, scheme = spec, spec.plan.scheme
        self.scheme = scheme
        scheme.of_one_length("an ensemble")
        self._prepared = prepare(with_events(scheme, scheme.program()), scheme.layout.size, scheme.c_size)
        reduced = [(spec.outputs.index(name), reduction) for name, reduction in spec.reduced]
        self._length = _length(model)
        self._observation = Observation(model, scheme, spec.outputs)
        self._account = LaneAccount(scheme, reduced, self._length)
        extra = self._prepared.z_size - scheme.layout.size
        impulses = bool(moves_in_time(model) and model.q_d and model.has("energy"))
        broken = may_jump(model) or spec.plan.end is not None
        self.stops = StopProgram(scheme, self._prepared, impulses) if broken else None
        sizes = {} if self.stops is None else {f"stop_{name}": n for name, n in self.stops.layout.sizes.items()}
        sizes.pop("stop_state", 0)
        fields = {"scheme": scheme.layout.size, "more": extra, **sizes}
        self.lane = Layout({**fields, **self._observation.fields, **self._account.fields})
        self._ready = int(self._prepared.constants.size1_out(0))
        self._read = self._ready if self.stops is None else self.stops.c_size
        settle = quasi_static(model, spec.start)
        self.row = row_layout(model, scheme, self._ready, self._read - self._ready, self.lane, len(FIELDS), settle)
        self.program = self._program()
        self.width = 1 if spec.device == "gpu" else width or lane_width(self.program)
        self.operations = program_size(self.program)

    def _program(self) -> Program:
        """A major step with its account; outputs at every step only where they are reduced."""
        after = make_stage("lane_account", self.lane, self._ready, self._account.step)
        outputs = (self._observing,) if self.spec.reduced else ()
        step = self._prepared.program if self.stops is None else self.stops.program()
        return Sequence((step.map(self._widened), *outputs, after))

    @cached_property
    def _observing(self) -> Program:
        return self._observation.program(self.lane, self._ready)

    def _widened(self, stage: ca.Function) -> ca.Function:
        """A stage on the scheme's z and what the program keeps, on all of a lane's."""
        z, c = ca.SX.sym("z", self.lane.size), ca.SX.sym("c", self._read)
        size = stage.size1_in(0)
        z_next = ca.vertcat(stage(z[:size], c), z[size:])
        return ca.Function(stage.name(), [z, c], [z_next], ["z", "c"], ["z_next"])

    @cached_property
    def steps(self) -> LaneCode | GpuCode:
        """A major step, with own mathematics."""
        if self.spec.device == "gpu":
            return GpuCode(self.program, the_gpu())
        return LaneCode(self.program, *lane_form(self.program, self.width))

    @cached_property
    def begin(self) -> LaneCode:
        """From what a row is given to step 0."""
        account = self._account.begin
        return self._once(
            begin_program(self.model, self.scheme, self._prepared, self.row, self.lane, self._observing, account)
        )

    @cached_property
    def observe(self) -> LaneCode:
        """The outputs of the present state, with the library's mathematics."""
        return self._once(moved(self._observing, self.row, "sample_"))

    @cached_property
    def look(self) -> LaneCode:
        """What looks.py judges by."""

        def body(z: Fields, c: ca.SX) -> Mapping[str, ca.SX]:
            state = self.lane.unpack(z["lane"])["scheme"]
            constants = ca.vertcat(z["c"], z["h"])
            found = looked(self.model, self.scheme, self._length, z["p"], state, constants)
            return {"look": ca.vertcat(*(found[name] for name in FIELDS))}

        return self._once(make_stage("look", self.row, NO_CONSTANTS, body))

    def _once(self, program: Program) -> LaneCode:
        return LaneCode(program, *once_form(program, self.width))

    def compile(self) -> None:
        """Make all code now."""
        for code in (self.steps, self.begin, self.look, self.observe):
            assert code.width == self.width

    def rows_of(self, name: str) -> slice:
        """Where a field of a row, or of its lane, lies in the row."""
        if name in self.row.sizes:
            return self.row.slice(name)
        inside, first = self.lane.slice(name), self.row.slice("lane").start
        return slice(first + inside.start, first + inside.stop)


def programs_of(spec: EnsembleSpec) -> LanePrograms:
    """The programs of an ensemble: those of an earlier one that differs in its samples only, if they are still
    there.
    """
    with _LOCK:
        for kept in _KEPT:
            if kept.spec.alike(spec):
                return kept
    made = LanePrograms(spec)
    with _LOCK:
        _KEPT.append(made)
    return made


_LOCK = threading.Lock()
_KEPT: deque[LanePrograms] = deque(maxlen=4)  # a loop that asks again and again makes programs once


def _length(model: EmittedModel) -> float:
    """Size of the mechanism at the model's own parameters [m]."""
    if not model.constraints or not model.has("constraints"):
        return 1.0
    c = model.constants(model.parameter_vector())
    at = {"q": model.initial_q, "q_dot": model.initial_q_dot, "t": 0.0, "c": c}
    shape = (len(model.constraints), len(model.coordinates))
    return mechanism_length(model, np.asarray(model.evaluate("constraints", **at)["C_q"]).reshape(shape))


# The start of runs in lanes as one program: parameters to constants, assembly, preparation, the scheme's own start.
#
# A lane's row begins with what it is given (p, t, h, q_i, q_i_dot, a guess of q_d, whether that is to be closed, and
# whether elastic coordinates are to be brought into equilibrium;
# where turns follow from loops, whether it was to be closed, and all coordinates and rates);
# c, what the step program reads and its z follow. Functions are called on entries of the row only, each a stage of
# its own, so that a lane has the bits of a run by itself.

NO_CONSTANTS = 1  # the begin reads none: its c is whatever stands first in the row
Stage = Callable[[Fields], Mapping[str, ca.SX]]


def row_layout(
    model: EmittedModel, scheme: Scheme, ready: int, constants: int, lane: Layout, looks: int, settle: bool
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
    model: EmittedModel, scheme: Scheme, prepared: Prepared, row: Layout, lane: Layout, outputs: Program, begin: Stage
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
            observed = (("q", q), ("q_dot", q_dot))
            return found | {name: ca.if_else(z["asked"] > 0, value, z[name]) for name, value in observed}

        parts += [Until(stage("begin_close", close), flag, MAX_ASSEMBLY_ITERATIONS, 4), stage("begin_fit", fit)]
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


def _started(model: EmittedModel, scheme: Scheme, lane: Layout, z: Fields) -> ca.SX:
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
    fields |= {"det_low": NO_LOWEST * ca.SX.ones(blocks), "det_high": NO_HIGHEST * ca.SX.ones(blocks)}
    fields = looking(scheme, fields, c)
    empty = {name: ca.SX.zeros(size) for name, size in lane.sizes.items()}
    if "stop_t0" in lane.sizes:
        empty |= {"stop_t0": z["t"], "stop_inputs": fields.get("inputs", ca.SX(0, 1))}
    return lane.pack({**empty, "scheme": scheme.layout.pack(fields)})


# Quasi-static starts of lanes: the steps of runtime/start/quasi_static.py, on the fields of a row.
#
# settle       is the lane to be settled?                                   given
# settled      did it stay in its valley until now?                         else the case is run by itself
# settle_q, settle_t    the state that is being settled: at the start, and a little before and behind it
# settle_open, settle_work    is it open, and the work of its last step
# settle_lead, settle_ahead    the time between these, and q_e at the later one

USUAL_STEPS = 4
StageMaker = Callable[[str, Callable[[Fields], Mapping[str, ca.SX]]], Call]


def quasi_static(model: EmittedModel, start: str) -> bool:
    """Do runs with this start ("" for the scene's own) begin in elastic equilibrium, and can lanes find it?"""
    chosen = start or str(model.simulation.get("start", "given"))
    return chosen in ("quasi_static", "quasi_static_unstable") and settles(model)


def settle_fields(model: EmittedModel) -> dict[str, int]:
    """What of a row this works on, `settle` left out."""
    single = ("settled", "settle_t", "settle_open", "settle_work", "settle_lead")
    return {**dict.fromkeys(single, 1), "settle_q": len(model.q_i), "settle_ahead": len(positions(model))}


def settle_program(model: EmittedModel, row: Layout, stage: StageMaker) -> Program:
    """From a state that fits to one in elastic equilibrium; stage(name, body): on the fields of the row."""
    elastic = positions(model)
    rigid = [k for k in range(len(model.q_i)) if k not in elastic]
    loops = [model.q_d.index(name) for name in model.loop_unknowns]

    def loop(z: Fields) -> ca.SX:
        return z["q_d"][loops] if loops else ca.SX(0, 1)

    def placed(z: Fields, q_i: ca.SX, at: int) -> dict[str, ca.SX]:
        """To be settled: the state a lead later (at 1) or before (-1), or where something jumps in between, here."""
        later, before = sides(z)
        q, lead = ca.SX(q_i), (later if at > 0 else -before if at else 0) * z["settle_lead"]
        if at and rigid:
            q[rigid] = q[rigid] + lead * z["q_i_dot"][rigid]
        open_ = z["settle"] * (z["settle_lead"] > 0 if at else 1)
        return {"settle_q": q, "settle_t": z["t"] + lead, "settle_open": open_, "settle_work": ca.SX(LARGEST_NUMBER)}

    def sides(z: Fields) -> tuple[ca.SX, ca.SX]:
        later, before = smooth_sides(model)(z["t"], z["settle_lead"], z["c"])
        return later, before

    def begin(z: Fields) -> Mapping[str, ca.SX]:
        return {"settled": ca.SX(1), "settle_lead": leading(model)(z["q_i"], z["q_i_dot"], z["q_d"], z["t"], z["c"])}

    def step(z: Fields) -> Mapping[str, ca.SX]:
        given = (z["settle_t"], z["settle_q"], z["q_i_dot"], loop(z), z["c"], z["settle_work"])
        q, open_, valley, work = settling(model)(*given)
        settled = ca.logic_and(z["settled"], valley)
        return {"settle_q": q, "settle_open": ca.logic_and(open_, valley), "settle_work": work, "settled": settled}

    def kept(z: Fields) -> dict[str, ca.SX]:
        """Still settled? Not where steps ran out."""
        return {"settled": ca.logic_and(z["settled"], z["settle_open"] <= 0)}

    def ahead(z: Fields) -> Mapping[str, ca.SX]:
        q_i = ca.if_else(z["settle"] > 0, z["settle_q"], z["q_i"])
        return {**kept(z), "q_i": q_i, **placed(z, q_i, 1)}

    def behind(z: Fields) -> Mapping[str, ca.SX]:
        return {**kept(z), "settle_ahead": z["settle_q"][elastic], **placed(z, z["q_i"], -1)}

    def rate(z: Fields) -> Mapping[str, ca.SX]:
        v, (later, before) = ca.SX(z["q_i_dot"]), sides(z)
        span = (later + before) * z["settle_lead"]
        moving = ca.logic_and(z["settle"] > 0, span > 0)
        found = (z["settle_ahead"] - z["settle_q"][elastic]) / span
        v[elastic] = ca.if_else(moving, found, v[elastic])
        return {**kept(z), "q_i_dot": v}

    def end(z: Fields) -> Mapping[str, ca.SX]:
        q_d = elastic_residual(model)(z["t"], z["q_i"], z["q_i_dot"], loop(z), z["c"])[3]
        return {"q_d": ca.if_else(z["settle"] > 0, q_d, z["q_d"])}

    solve = Until(stage("settle_step", step), row.slice("settle_open").start, MAX_SETTLING_STEPS, USUAL_STEPS)
    parts = [stage("settle_here", lambda z: placed(z, z["q_i"], 0)), solve, stage("settle_ahead", ahead), solve]
    parts += [stage("settle_behind", behind), solve, stage("settle_rate", rate)]
    return Sequence(
        (stage("settle_begin", begin), Repeat(Sequence(tuple(parts)), SETTLING_PASSES), stage("settle_end", end))
    )

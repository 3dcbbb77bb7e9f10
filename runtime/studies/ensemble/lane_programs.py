"""A question as programs on lanes and their code: the start, the steps, samples and looks."""

from __future__ import annotations

import threading
from collections import deque
from collections.abc import Mapping
from functools import cached_property
from typing import NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.coordinates import mechanism_length
from runtime.contract.model import Model
from runtime.engine.ensemble_code import LaneCode, lane_form, lane_width, once_form, program_size
from runtime.engine.prepare import prepare
from runtime.engine.program import Fields, Layout, Program, Sequence, make_stage
from runtime.running.stepping import may_jump
from runtime.schemes.switching.impulse import moves_in_time
from runtime.schemes.switching.stop_program import StopProgram
from runtime.studies.ensemble.account import LaneAccount
from runtime.studies.ensemble.begin import NO_CONSTANTS, begin_program, moved, row_layout
from runtime.studies.ensemble.looks import FIELDS, looked
from runtime.studies.ensemble.observation import Observation
from runtime.studies.ensemble.question import Question
from runtime.studies.ensemble.settle import quasi_static


class LanePrograms:
    """width: how many runs go side by side (None: as this machine has it); row, lane: what a run keeps.

    Each of `steps`, `begin`, `observe` and `look` is code; steps works on a lane's z and constants, the others on rows.
    """

    def __init__(self, model: Model, question: Question, width: int | None = None) -> None:
        self.model, self.question = model, question
        self.plan = question.plan(model)
        scheme = self.scheme = self.plan.scheme
        scheme.of_one_length("an ensemble")
        self._prepared = prepare(scheme.program(), scheme.layout.size, scheme.c_size)
        reduced = [(question.outputs.index(name), reduction) for name, reduction in question.reduced]
        self._length = _length(model)
        self._observation = Observation(model, scheme, question.outputs)
        self._account = LaneAccount(scheme, reduced, self._length)
        extra = self._prepared.z_size - scheme.layout.size
        stops = may_jump(model) and not model.description.events  # whose cases are run by themselves
        impulses = bool(moves_in_time(model) and model.q_d and model.has("energy"))
        self.stops = StopProgram(scheme, self._prepared, impulses) if stops else None
        sizes = {} if self.stops is None else {f"stop_{name}": n for name, n in self.stops.layout.sizes.items()}
        sizes.pop("stop_state", 0)
        fields = {"scheme": scheme.layout.size, "more": extra, **sizes}
        self.lane = Layout({**fields, **self._observation.fields, **self._account.fields})
        self._ready = int(self._prepared.constants.size1_out(0))
        self._read = self._ready if self.stops is None else self.stops.c_size
        settle = quasi_static(model, question.start)
        self.row = row_layout(model, scheme, self._ready, self._read - self._ready, self.lane, len(FIELDS), settle)
        self.program = self._program()
        self.width = width or lane_width(self.program)
        self.operations = program_size(self.program)

    def _program(self) -> Program:
        """A major step with its account; outputs at every step only where they are reduced."""
        after = make_stage("lane_account", self.lane, self._ready, self._account.step)
        outputs = (self._observing,) if self.question.reduced else ()
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
    def steps(self) -> LaneCode:
        """A major step, with own mathematics."""
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


def programs_of(model: Model, question: Question, width: int | None = None) -> LanePrograms:
    """The programs of a question: those of an earlier one that differs in its samples only, if they are still there."""
    key = f"{width} {question.programs_key}"
    with _LOCK:
        for kept in _KEPT:
            if kept.model is model and kept.key == key:
                return kept.programs
    made = LanePrograms(model, question, width)
    with _LOCK:
        _KEPT.append(_Kept(model, key, made))
    return made


class _Kept(NamedTuple):
    model: Model
    key: str
    programs: LanePrograms


_LOCK = threading.Lock()
_KEPT: deque[_Kept] = deque(maxlen=4)  # a loop that asks again and again makes programs once


def _length(model: Model) -> float:
    """Size of the mechanism at the model's own parameters [m]."""
    if not model.constraints or not model.has("constraints"):
        return 1.0
    c = model.constants(model.parameter_vector())
    at = {"q": model.initial_q, "q_dot": model.initial_q_dot, "t": 0.0, "c": c}
    shape = (len(model.constraints), len(model.coordinates))
    return mechanism_length(model, np.asarray(model.evaluate("constraints", **at)["C_q"]).reshape(shape))

"""Steps of one length through the events in them by one native call: the C of stops.c, compiled for this machine.

Where an event lies in a step, what hits and what sticks is decided by the C that exported models have too (stops.c,
settle.c); its LLVM IR is checked in, so nobody needs a compiler (engine/native_text.py). It calls the step program and
functions of the model by address. The plain reading of the same is in steps_with_stops.py, event_search.py and
settle.py: that of interpreted runs, and of what is said at the end of `native_events`.
"""

from __future__ import annotations

import ctypes
import re
from collections.abc import Callable
from functools import cache
from importlib.resources import files
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from runtime.contract.signals import SINCE
from runtime.engine.llvm_code import Effort
from runtime.engine.native import NativeProgram
from runtime.engine.native_functions import NativeFunction, native_functions
from runtime.engine.native_text import load
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.event_model import (
    KEPT_OF_A_KINK,
    PARTS,
    WAYS,
    decision_functions,
    restart_function,
    sizes,
    tables,
)
from runtime.schemes.switching.settle import weights
from runtime.schemes.switching.times import Breaks, switches_by_inputs
from runtime.schemes.switching.watched import NEVER, watched_events, watches

TEXT = Path(__file__).with_name("stops.ll")
QUICK = Effort(passes=False, level=1)  # the text is optimised as it stands
RECORDS = 1000  # of events that a call has room for
_INT, _REAL, _AT = ctypes.c_int64, ctypes.c_double, ctypes.c_void_p


class _Event(ctypes.Structure):
    """`Event` of model.h."""

    _fields_ = [("way", ctypes.c_int), ("terminal", ctypes.c_int), ("first", ctypes.c_int), ("last", ctypes.c_int),
                ("cool_down", _REAL)]  # fmt: skip


class _Grid(ctypes.Structure):
    """`Grid` of model.h."""

    _fields_ = [("n", _INT), ("step", _AT), ("broken", _AT), ("first", _AT), ("part", _AT), ("clock", _AT),
                ("origin", _AT)]  # fmt: skip


class _Log(ctypes.Structure):
    """`Log` of model.h."""

    _fields_ = [("records", _AT), ("n", _INT), ("room", _INT), ("lost", _INT), ("unresolved", _REAL), ("opened", _AT)]


@cache
def _model_structure() -> type[ctypes.Structure]:
    """`Model` of model.h, whose text says which fields there are."""
    text = files("runtime.schemes.switching").joinpath("model.h").read_text(encoding="utf-8")
    text = text[: text.index("} Model;")].rsplit("typedef struct {", 1)[1]
    numbers = re.findall(r"\w+", re.findall(r"int64_t ([^;]*);", text)[0])
    pointers = [one for group in re.findall(r"const (?:Event|int) ([^;]*);", text) for one in re.findall(r"\w+", group)]
    functions = re.findall(r"void \(\*(\w+)\)", text)
    fields = [*((name, _INT) for name in numbers), *((name, _AT) for name in [*pointers, *functions])]
    return type("_Model", (ctypes.Structure,), {"_fields_": fields})


class EventRecord(NamedTuple):
    """What happened at t [s] in a step: which events (positions), their values (n_e,), and the state (n_z,) that steps
    dt_seen [s] show, before they acted; inputs (n_w,) behind them; push (n_i,): added to the rates.

    Of stops and friction, where there are any: hits, the stops (positions) that were hit, one after another; rates
    before and after, impulses, and how much later [s] bounces are over that are at once (n_m,); passing (n_v,): the
    mean rate of each row; the states (q_i, q_d, q_i_dot, q_d_dot, t) before and after.
    """

    t: float
    step: int
    dt_seen: float
    happened: list[int]
    values: np.ndarray
    z: np.ndarray
    inputs: np.ndarray
    push: np.ndarray
    hits: list[int]
    before: np.ndarray
    after: np.ndarray
    impulse: np.ndarray
    rests: np.ndarray
    passing: np.ndarray
    at: np.ndarray
    at_after: np.ndarray


class KinkMemory(NamedTuple):
    """How often a kink was slept over, and the last steps at whose end it was."""

    sleeps: float
    steps: tuple[float, ...]


class NativeEvents:
    """The compiled decisions of a stepper's scheme; many runs may use one at a time, with memory of their own."""

    def __init__(self, stepper: Stepper) -> None:
        scheme, engine = stepper.scheme, stepper.engine
        assert isinstance(engine, NativeProgram)
        self.scheme, self._engine = scheme, engine
        self.sizes = sizes(scheme, stepper.prepared, timed=False)
        own = {"again": NativeFunction(restart_function(scheme), True)}
        asked = dict[str, NativeFunction]()
        for name, one in decision_functions(scheme, stepper.prepared).items():
            (asked if one.output else own)[name] = NativeFunction(one.function, not one.output)
        mathematics = "library" if stepper.requested == "compiled-library" else "own"
        self._codes = native_functions(own, mathematics), native_functions(asked, "library")
        self._keep: list[Any] = []
        self._model = self._described()
        kinds = [_AT, _AT, _AT, _AT, _AT, _AT, _AT, _AT, _INT, _AT]
        self._text = load(TEXT, QUICK)
        call: Callable[..., int] = ctypes.CFUNCTYPE(_INT, *kinds)(self._text.get_function_address("run_rows"))
        self._run_rows = call
        settle: Callable[..., int] = ctypes.CFUNCTYPE(ctypes.c_int, *[_AT] * 6)(
            self._text.get_function_address("settle_at")
        )
        self._settle_at = settle
        seen: Callable[..., None] = ctypes.CFUNCTYPE(None, *[_AT] * 4)(self._codes[1].addresses["seen"])
        self._seen = seen
        n = self.sizes
        told = [5 * n["NM"], n["NV"], 2 * n["NAT"]] if n["NM"] else []
        self.record = 3 + 2 * n["NE"] + n["NOWN"] + n["NU"] + n["NI"] + sum(told)
        self.opened = 1 + n["NE"] + n["NS"]

    def _at(self, array: np.ndarray) -> int:
        self._keep.append(array)
        return int(array.ctypes.data)

    def _described(self) -> ctypes.Structure:
        """The `Model` of the C."""
        scheme, first = self.scheme, 0
        events = (_Event * (len(watched_events(scheme)) + 1))()
        for place, event in zip(events, watched_events(scheme), strict=False):
            last = first + len(event.sets)
            place.way, place.terminal, place.first, place.last = WAYS[event.direction], event.terminal, first, last
            place.cool_down, first = event.cool_down, last
        self._keep.append(events)
        found = {"events_of": ctypes.addressof(events)}
        found |= {name: self._at(np.array([*table, 0], dtype=np.intc)) for name, table in tables(scheme).items()}
        for code in self._codes:
            found |= code.addresses
        return _model_structure()(**self.sizes, **found)

    def work(self) -> int:
        """Entries of w."""
        return self.sizes["KEPT_IN_W"] + max(self._engine.tiers.code.work, *(code.work for code in self._codes)) + 1

    def run(
        self,
        z: np.ndarray,
        ready: np.ndarray,
        c: np.ndarray,
        ends: np.ndarray,
        rows: np.ndarray,
        grid: ctypes.Structure,
        log: ctypes.Structure,
    ) -> int:
        """Advance z (NZ + KEPT) to these steps, with copies (NZ) in the rows; how many of them were reached."""
        reached = 0

        def call(code: Any) -> None:
            nonlocal reached
            self._model.steps = ctypes.cast(code.run, _AT).value
            w = np.zeros(self.work())
            at = [one.ctypes.data for one in (z, ready, c, w, ends)]
            here = ctypes.addressof(self._model), ctypes.addressof(grid), ctypes.addressof(log)
            reached = self._run_rows(*here, *at, len(ends), rows.ctypes.data)

        self._engine.tiers.use(call)
        return reached

    def decided(self, z: np.ndarray, shown: np.ndarray, c: np.ndarray, u: np.ndarray) -> tuple[np.ndarray, bool] | None:
        """What sticks or holds at a state z (n_z,) that constants `shown` show: the inputs (n_w,) with other modes than
        u, and do rates stay as they are? None: no modes are consistent. c (c_size,): the model's constants.
        """
        n, w = self.sizes, np.zeros(self.work())
        at, found = np.zeros(n["NAT"]), u.copy()
        self._seen(at.ctypes.data, z.ctypes.data, shown.ctypes.data, w.ctypes.data)
        rates, none = at.copy(), np.zeros(n["NM"] + 1, dtype=np.intc)
        own = [one.ctypes.data for one in (at, found, c, none, w)]
        if not self._settle_at(ctypes.addressof(self._model), *own):
            return None
        return found, bool((at == rates).all())

    def records(self, numbers: np.ndarray) -> list[EventRecord]:
        """Of numbers (N, record)."""
        n, n_m = self.sizes, self.sizes["NM"]
        widths = [1, 1, 1, n["NE"], n["NE"], n["NOWN"], n["NU"], n["NI"]]
        widths += [n_m] * 5 + ([n["NV"], n["NAT"], n["NAT"]] if n_m else [0, 0, 0])
        places = list(pairwise(np.cumsum([0, *widths]).tolist()))
        found = []
        for row in numbers:
            t, step, dt, happened, *others = (row[a:b] for a, b in places)
            values, z, inputs, push, order, *struck = others
            which = [k for k, one in enumerate(happened.tolist()) if one]
            first = order.tolist()
            hits = sorted((k for k, one in enumerate(first) if one), key=first.__getitem__)
            found.append(
                EventRecord(float(t[0]), int(step[0]), float(dt[0]), which, values, z, inputs, push, hits, *struck)
            )
        return found

    def put_kinks(self, z: np.ndarray, kinks: list[KinkMemory]) -> None:
        """What is remembered of kinks into the end of z (NZ + KEPT)."""
        own = z[self.sizes["NZ"] + 2 :].reshape(len(kinks), KEPT_OF_A_KINK)
        for place, kink in zip(own, kinks, strict=True):
            place[:2] = kink.sleeps, len(kink.steps)
            place[2 : 2 + len(kink.steps)] = kink.steps


class StepTable:
    """The steps of a grid that are not plain, as the C reads them."""

    def __init__(self, grid: Breaks) -> None:
        steps = np.array(sorted({*grid.broken, *grid.on}), dtype=np.int64)
        broken = np.isin(steps, grid.broken).astype(np.int64)
        self.fits = True
        first, part = np.zeros(1, dtype=np.int64), np.zeros((0, 4))
        clock, origin = np.zeros(0), np.zeros(0)
        if len(steps):
            found = grid.parts(steps)
            self.fits = int(found.counts.max()) <= PARTS
            before = np.where(np.isfinite(found.before), found.before, NEVER)
            after = np.where(np.isfinite(found.after), found.after, -NEVER)
            part = np.column_stack([found.start, found.length, before, after])
            first = np.concatenate([[0], np.cumsum(found.counts)]).astype(np.int64)
            clock, origin = found.clocks.copy(), grid.origins(steps + 1, found.clocks)
        self._keep = steps, broken, first, np.ascontiguousarray(part), clock, origin
        self.structure = _Grid(len(steps), *(one.ctypes.data for one in self._keep))


class EventLog:
    """Room for records of a call, and what is remembered of loads that act for a short time."""

    def __init__(self, code: NativeEvents) -> None:
        self._code = code
        self._numbers, self.opened = np.empty((RECORDS, code.record)), np.zeros(code.opened)
        self.structure = _Log(self._numbers.ctypes.data, 0, RECORDS, 0, 0.0, self.opened.ctypes.data)

    def take(self, told: bool = True) -> list[EventRecord]:
        """What has happened since the last look, which makes room again; not told: none of it."""
        found = self._code.records(self._numbers[: self.structure.n].copy()) if told else []
        self.structure.n, self.structure.room = 0, RECORDS
        return found


def native_events(stepper: Stepper) -> NativeEvents | None:
    """Made once for a stepper. None where the plain reading decides: interpreted runs, steps of a tolerance, friction
    by reactions, inputs with rates or times of jumps that events change.
    """
    scheme, model = stepper.scheme, stepper.scheme.model
    if "native events" not in stepper.across:
        sets = any(event.sets for event in model.description.events)
        plain = not isinstance(stepper.engine, NativeProgram) or scheme.adaptive or not watches(scheme)
        plain = plain or (sets and (SINCE in model.signals.names or switches_by_inputs(model)))
        plain = plain or (model.element_modes.size > 0 and "margin" in weights(model).name_out())
        stepper.across["native events"] = None if plain else NativeEvents(stepper)
    found: NativeEvents | None = stepper.across["native events"]
    return found

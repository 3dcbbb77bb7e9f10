"""Steps with stops on the way, as one program: whole steps, and steps that are made in parts, which are data of z.

An application is one major step. One without stops is the scheme's own step. One with stops is made of parts, each from
its clock by a step of its own length: a restart, what the step program reads for that length, the step, and what a
prescribed motion whose velocity jumps at its end does. Behind the last part the state is restarted on the grid, where
events are looked for. z knows the next KNOWN_PARTS parts; where they run out within a step, an application ends
there, and goes on when whoever runs it has given more.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca
import numpy as np

from runtime.contract.coordinates import charts_in, joined, sides_in
from runtime.engine.native import choose_engine
from runtime.engine.prepare import Prepared
from runtime.engine.program import Call, Fields, Layout, Program, Sequence, Until, make_stage
from runtime.schemes.scheme import SIDES, Lasting, Scheme
from runtime.schemes.switching.impulse import impulse_of
from runtime.schemes.switching.watched import NEVER, awake_sides, flagged, holds_sides, values_at, watches

KNOWN_PARTS = 16  # parts
# of a part: the step that it is in, its clock [s] and length [s], the same over a major step, is it the last one of the
# step?, and of that one the clock from which steps go on [s], and t0 for it
PART = ("step", "start", "length", "share", "last", "clock", "origin")
IMPULSE = ("jolts", "before", "after")  # may the velocity of a motion jump at its end?, and clocks on both sides [s]


class StopProgram:
    """Of a scheme whose step was prepared. Fields of z besides `state`, that of the step, and the parts
    (KNOWN_PARTS each):

    waiting: how many are known; t0: of the grid [s]; whole, parts, back: what is to be done; inside: are parts of the
    step made already?; number: of the step; dt_seen: steps that show the state; ready: what the step program reads for
    a part; inputs: what they are from the next restart on; event_before: in which step an event was seen until now;
    push: what is added to the rates at the next restart; energy, jumps: see Impulse, of the last one.
    """

    def __init__(self, scheme: Scheme, prepared: Prepared, impulses: bool = False) -> None:
        self.scheme, self._prepared = scheme, prepared
        self.n_ready = int(prepared.constants.size1_out(0))
        self.part = PART + IMPULSE if impulses else PART
        flags = ("waiting", "t0", "whole", "parts", "back", "inside", "number", "dt_seen", "event_before")
        sizes = {"state": prepared.z_size, **dict.fromkeys(flags, 1), **dict.fromkeys(self.part, KNOWN_PARTS)}
        sizes |= {"inputs": scheme.layout.sizes.get("inputs", 0)}
        if impulses or watches(scheme):
            sizes["push"] = len(scheme.model.q_i)
        if impulses:
            sizes |= {"energy": 1, "jumps": len(scheme.model.coordinates)}
        self.layout = Layout({**sizes, "ready": self.n_ready})
        self.c_size = self.n_ready + scheme.c_size

    def program(self) -> Program:
        """One application; reads what whole steps read, and behind it the constants of the scheme."""
        flag = {name: self.layout.slice(name).start for name in (*self.part, "whole", "parts", "back")}
        step = self._prepared.program
        whole = Sequence((self._applied("whole_", step, None), self._stage("counted", self._counted)))
        part: tuple[Program, ...] = (self._stage("set_out", self._set_out), self._applied("part_", step, "ready"))
        if "jolts" in self.part:
            part = (*part, Until(self._stage("impulse", self._impulse), flag["jolts"], 1, usual=0))
        return Sequence(
            (
                self._stage("plan", self._plan),
                Until(whole, flag["whole"], 1, usual=1),
                Until(Sequence((*part, self._stage("next", self._next))), flag["parts"], KNOWN_PARTS, usual=1),
                Until(self._stage("to_grid", self._to_grid), flag["back"], 1, usual=1),
            )
        )

    def _stage(self, name: str, body: Callable[[Fields, ca.SX], Mapping[str, ca.SX]]) -> Call:
        return make_stage(name, self.layout, self.c_size, body)

    def _applied(self, prefix: str, program: Program, ready: str | None) -> Program:
        """A program of the stepper on `state`, with what it reads in a field, or among the constants."""

        def changed(stage: ca.Function) -> ca.Function:
            def body(z: Fields, c: ca.SX) -> dict[str, ca.SX]:
                return {"state": stage(z["state"], c[: self.n_ready] if ready is None else z[ready])}

            return self._stage(prefix + stage.name(), body).stage

        return program.map(changed)  # `state` comes first, so flags are where they were

    def _own(self, z: Fields) -> tuple[ca.SX, Fields]:
        """The scheme's part of the state, whole and by fields."""
        state = z["state"][: self.scheme.layout.size]
        return state, self.scheme.layout.unpack(state)

    def _changed(self, z: Fields, state: ca.SX) -> ca.SX:
        return ca.vertcat(state, z["state"][state.numel() :])

    def _plan(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """Is there a stop in this step?"""
        state, fields = self._own(z)
        inside = z["inside"] > 0
        known = ca.logic_and(z["waiting"] > 0, ca.logic_or(inside, z["step"][0] <= fields["n"]))
        begins = ca.logic_and(known, ca.logic_not(inside))
        found = {
            "parts": known,
            "whole": ca.logic_not(ca.logic_or(known, inside)),
            "number": ca.if_else(inside, z["number"], fields["n"]),
            "dt_seen": ca.if_else(inside, z["dt_seen"], self._dt(c)),
        }
        if watches(self.scheme):
            found["event_before"] = ca.if_else(begins, fields["event_step"], z["event_before"])
            event_step = ca.if_else(begins, NEVER, fields["event_step"])
            found["state"] = self._changed(z, self.scheme.layout.pack({**fields, "event_step": event_step}))
        return found

    def _dt(self, c: ca.SX) -> ca.SX:
        return c[self.n_ready + self.scheme.model.c_size]

    def _counted(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """Behind a stop the first step runs on the clock that it was given; the next ones on the grid."""
        state, fields = self._own(z)
        return {"whole": ca.SX(0), "state": self._changed(z, self.scheme.layout.pack({**fields, "t0": z["t0"]}))}

    def _set_out(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        c, end = c[self.n_ready :], self.scheme.model.c_size
        ready = self._prepared.constants(ca.vertcat(c[:end], c[end:] * z["share"][0]))
        return {**self._restarted(z, c, z["length"][0], z["start"][0]), "ready": ready}

    def _restarted(self, z: Fields, c: ca.SX, dt: ca.SX, clock: ca.SX) -> dict[str, ca.SX]:
        """Fields behind a restart to steps dt at a clock [s]."""
        state, inputs = self._own(z)[0], z["inputs"] if z["inputs"].numel() else None
        found = restarted(self.scheme, state, c, z["dt_seen"], dt, clock, z.get("push"), inputs)
        pushed = {"push": ca.SX.zeros(z["push"].numel())} if "push" in z else {}
        return {"state": self._changed(z, found), **pushed}

    def _impulse(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        state, c, dt = self._own(z)[0], c[self.n_ready :], z["length"][0]
        push, energy, jumps = impulse_there(self.scheme, state, c, dt, z["before"][0], z["after"][0])
        return {"push": push, "energy": energy, "jumps": jumps, "jolts": ca.vertcat(0, z["jolts"][1:])}

    def _next(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """A part is made: the next ones move up, and it comes last."""
        closed, waiting = z["last"][0], z["waiting"] - 1
        return {
            **{name: ca.vertcat(z[name][1:], z[name][0]) for name in self.part},
            "dt_seen": z["length"][0],
            "waiting": waiting,
            "back": closed,
            "inside": 1 - closed,
            "parts": ca.logic_and(waiting > 0, closed <= 0),
        }

    def _to_grid(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        """The state on the grid; the part behind it is gone from z, its clock and t0 are in the last places."""
        dt, c = self._dt(c), c[self.n_ready :]
        found = self._restarted(z, c, dt, z["clock"][KNOWN_PARTS - 1])
        fields = self.scheme.layout.unpack(found["state"][: self.scheme.layout.size])
        fields |= {"t0": z["origin"][KNOWN_PARTS - 1], "n": z["number"] + 1}
        if watches(self.scheme):
            fields = self._looked(fields, z["event_before"], c, dt)
        return {**found, "state": self._changed(z, self.scheme.layout.pack(fields)), "back": ca.SX(0)}

    def _looked(self, fields: Fields, event_before: ca.SX, c: ca.SX, dt: ca.SX) -> Fields:
        """Events are looked for from here on; event_step is the first step in which one was seen."""
        state = self.scheme.layout.pack(fields)
        observed = values_at(self.scheme, state, self.scheme.equations(with_steps(self.scheme, state, c, dt), fields))
        by_jump = flagged(self.scheme, fields, fields["event_values"], observed["events"], observed["t"])
        sooner = ca.logic_or(fields["event_step"] < NEVER, by_jump)
        slopes = fields["event_slopes"]
        return {
            **fields,
            "event_values": observed["events"],
            "event_change": ca.SX.ones(observed["events"].numel()) * NEVER,
            "event_slopes": observed["slopes"][: slopes.numel()] if slopes.numel() else slopes,
            "event_step": ca.if_else(sooner, ca.fmin(event_before, fields["n"]), event_before),
            **(
                {"side": awake_sides(self.scheme, fields, observed["sides"], observed["t"])} if "side" in fields else {}
            ),
        }


def impulse_there(
    scheme: Scheme, state: ca.SX, c: ca.SX, dt: ca.SX, before: ca.SX, after: ca.SX
) -> tuple[ca.SX, ca.SX, ca.SX]:
    """(push, energy, jumps), see Impulse, at a state (n_z,) that steps dt show; before, after: clocks [s]."""
    model, constants = scheme.model, with_steps(scheme, state, c, dt)
    observed = scheme.observer(z=state, c=constants)
    q_i, q_d = observed["q_i"], observed["q_d"]
    if scheme.charts.size:
        q, charts = joined(model, q_i, q_d), charts_in(model)
        q_i, q_d = scheme.charts.in_charts(model, q)
        parameters = q[model.places.parameters.ravel().tolist()]
        constants = ca.vertcat(constants[: charts.start], parameters, constants[charts.stop :])
    found = impulse_of(model)(q_i, q_d, observed["q_i_dot"], constants[: model.c_size], before, after)
    push, energy, jumps = found
    return push, energy, jumps


# A restart: the state of a scheme as the start of further steps, behind a stop or where inputs change.
#
# Positions go on, rates by what an impulse adds to them. What a scheme remembers of earlier steps is that of a start
# (Eqs. 68-71) with the forces from there on. Central differences, for one, go on by h a, where a is of the time between
# two steps: with what acts from there on alone a change of a by da would be felt half a step too early, an error of
# h da / 2 in the velocities.


def with_steps(scheme: Scheme, state: ca.SX, c: ca.SX, dt: ca.SX) -> ca.SX:
    """c (c_size,) as stages read it with major steps dt [s], and the inputs that a state (n_z,) holds."""
    end = scheme.model.c_size
    return scheme.constants_at(scheme.layout.unpack(state), ca.vertcat(c[:end], c[end:] * (dt / c[end])))


def restarted(
    scheme: Scheme,
    state: ca.SX,
    c: ca.SX,
    dt_before: ca.SX,
    dt: ca.SX,
    clock: ca.SX,
    push: ca.SX | None = None,
    inputs: ca.SX | None = None,
    shift: ca.SX | float = 0,
) -> ca.SX:
    """(n_z,) a state shown by steps dt_before as the start of steps dt at a clock [s]; where nothing is remembered it
    goes on as it is. push (n_i,): what an impulse adds to the rates; inputs (n_w,): from there on; shift (n_i,): what
    is added to positions, whose value is zero where its derivative is not.
    """
    found, own, end = ca.SX(state), scheme.layout.slice, scheme.model.c_size
    side, fields = None, scheme.layout.unpack(state)
    if holds_sides(scheme):
        side = awake_sides(scheme, fields, fields["side"], clock)
    if scheme.multistep:
        before, after = (with_steps(scheme, state, c, one) for one in (dt_before, dt))
        if side is not None:
            after = ca.vertcat(after[: sides_in(scheme.model).start], side, after[sides_in(scheme.model).stop :])
        if inputs is not None:
            after = ca.vertcat(after[: end - inputs.numel()], inputs, after[end:])
        found = started_anew(scheme, state, clock, before, after, 0.0 if push is None else push, shift)
    else:
        if push is not None:
            found[own("v")], found[own("x")] = found[own("v")] + push, found[own("x")] + shift
        if inputs is not None:
            found[own("inputs")] = inputs
        if side is not None:
            for name in SIDES:
                found[own(name)] = side
    found[own("t0")], found[own("n")] = clock, 0.0
    return ca.densify(found)


def started_anew(
    scheme: Scheme,
    z: ca.SX,
    t: ca.SX,
    before: ca.SX,
    after: ca.SX,
    push: ca.SX | float = 0.0,
    shift: ca.SX | float = 0.0,
) -> ca.SX:
    """(n_z,) a start at t [s] with the positions and rates that z (n_z,) shows, and its accounts.

    before, after (c_size,): constants as the stages read them, with inputs: z is shown by those before, steps go on
    with those after. push (n_i,): what is added to the rates [1/s].
    """
    observed, fields, model = scheme.observer(z=z, c=before), scheme.layout.unpack(z), scheme.model
    q_i, q_d = observed["q_i"], observed["q_d"]
    if scheme.charts.size:  # turns count from where their bodies are
        q = joined(model, q_i, q_d)
        (q_i, q_d), charts = scheme.charts.in_charts(model, q), charts_in(model)
        parameters = q[model.places.parameters.ravel().tolist()]
        after = ca.vertcat(after[: charts.start], parameters, after[charts.stop :])
    found = ca.SX(scheme.starter(t, q_i + shift, observed["q_i_dot"] + push, loop_guess(scheme, q_d), after))
    for name in scheme.lasting(Lasting.ACCOUNT):
        found[scheme.layout.slice(name)] = fields[name]
    return found


def loop_guess(scheme: Scheme, q_d: ca.SX) -> ca.SX:
    """(n_loop,) the loop unknowns among the dependent coordinates."""
    loop = [q_d[scheme.model.q_d.index(name)] for name in scheme.model.loop_unknowns]
    return ca.vertcat(*loop) if loop else ca.SX(0, 1)


class Restart:
    """The same of one state as native code, to the last bit as in a run."""

    def __init__(self, scheme: Scheme, engine: str = "auto") -> None:
        self.scheme = scheme
        sizes = {"state": scheme.layout.size, "dt_before": 1, "dt": 1, "clock": 1, "push": len(scheme.model.q_i)}
        layout = Layout({**sizes, "inputs": scheme.model.signals.size})
        call: Call = make_stage("restart", layout, scheme.c_size, self._body)
        self._engine = choose_engine(engine, call, layout.size, scheme.c_size)

    def __call__(
        self,
        state: np.ndarray,
        c: np.ndarray,
        dt_before: float,
        dt: float,
        clock: float,
        push: np.ndarray,
        inputs: np.ndarray,
    ) -> np.ndarray:
        """(n_z,) of a state (n_z,) and constants as stages read them; push (n_i,), inputs (n_w,)."""
        z = np.hstack([state, dt_before, dt, clock, push, inputs])
        self._engine.run(z, c, 1)
        return z[: len(state)]

    def _body(self, z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        inputs = z["inputs"] if z["inputs"].numel() else None
        return {"state": restarted(self.scheme, z["state"], c, z["dt_before"], z["dt"], z["clock"], z["push"], inputs)}

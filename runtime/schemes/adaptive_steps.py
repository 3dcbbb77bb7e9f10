"""A step of the run as many steps as a tolerance asks for: the loop, the controller and the output are one program.

What `dt` is elsewhere is here the time between two states that can be seen: t0 + n dt. The method's own steps do not
end there; a state in between is had from the method's own interpolant. An application of the program is

    aim             the time that is to be reached
    until reached:  from an accepted step on: move to its end, evaluate there what does not depend on h
                    attempt a step as long as the last one
                    where its error or the time asks for it: judge the step, refuse it or not, choose the next length
    show            the interpolant at the time that was to be reached

The tolerance stands among the constants, behind the step, and h is a field of z: one program serves all of both.
No step crosses a time of `stops`; the controller begins anew there.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from runtime.contract.coordinates import SMALLEST_ARM, length_rows, turning_columns, whole
from runtime.contract.model import EmittedModel
from runtime.engine.program import Fields, Program, Until
from runtime.engine.program import Sequence as InTurn
from runtime.schemes.one_step import Attempt, Method
from runtime.schemes.options import LARGEST_TOLERANCE
from runtime.schemes.scheme import LARGEST, Scheme, StateField, Step, account, given, state
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, loop_blocks
from runtime.schemes.stepper import Stepper
from runtime.schemes.switching.event_search import NODES, ValuesInStep, first_bracket, first_passage, looked_at
from runtime.schemes.switching.impulse import Impulse, impulse_at, moves_in_time
from runtime.schemes.switching.times import ON_THE_GRID, SwitchTime
from runtime.schemes.switching.watched import (
    NEVER,
    are_kinks,
    event_outputs,
    flagged,
    next_values,
    passed,
    quiet_until,
)

# The length of the next step: kept while the estimated error stays in a band, set anew where it leaves it.
#
# With the size e of the estimated error over the tolerance of a step and an estimate of h^p,
#
#     e > REFUSED             the step is thrown away, and tried again with h (AIM / e)^(1/p)
#     e > 1                   the step is kept, the next one takes h (AIM / e)^(1/p)
#     peak of e below LOW     the next one takes h (AIM / peak)^(1/p)
#
# where the peak forgets by the factor FORGET a step, so that an estimate that passes through zero, as that of a
# vibration does twice a period, does not ask for longer steps. In between h stays as it is. Then nothing of the next
# step waits for the estimate: processors begin it while e is still being computed, and a test that comes out the same
# nearly every time costs nothing. A controller that follows every e makes the next step wait for all of it, 50 to 100
# ns.

REFUSED, AIM, LOW = 2.0, 0.5, 0.2  # of e
FORGET, RESUMED = 0.8, 0.3  # what is left of the peak after a step, and where it begins after longer steps
SHRINK, GROW = 0.1, 5.0  # at most, from one step to the next
TINY = 1e-300
SMALLEST = 1e-5  # e is taken for at least this: an error of zero says nothing about longer steps


def in_band(square: ca.SX, peak: ca.SX) -> ca.SX:
    """May h stay as it is? From e^2 and the square of its peak; not where the error is no number."""
    return ca.logic_and(square <= 1, peak >= LOW**2)


def step_factor(square: ca.SX, peak: ca.SX, order: int) -> ca.SX:
    """h_next / h, from e^2 and the square of its peak; SHRINK where e is not finite."""
    worst = ca.if_else(square <= 1, ca.if_else(peak < LOW**2, peak, AIM**2), ca.fmin(square, 1 / SMALLEST**2))
    factor = ca.exp((2 * ca.log(AIM) - ca.log(ca.fmax(worst, SMALLEST**2))) / (2 * order))
    known = ca.if_else(square >= 0, factor, SHRINK)
    return ca.fmin(GROW, ca.fmax(SHRINK, known))


def closing_factor(missed: ca.SX, closes: ca.SX) -> ca.SX:
    """h_next / h, at most, with which loops that missed by C close as well as is asked; SHRINK where C is no number."""
    factor = (CLOSER * closes / ca.fmax(missed, TINY)) ** (1 / CLOSURE_ORDER)
    return ca.if_else(missed >= 0, ca.fmax(factor, SHRINK), SHRINK)


def peak_after(square: ca.SX, peak: ca.SX, factor: ca.SX, order: int) -> ca.SX:
    """The square of the peak, after h was changed by a factor: what e would have been with the new length.

    Where it was remembered rather than seen, from e and RESUMED: so steps grow on until e is large again.
    """
    change = factor ** (2 * order)
    expected = ca.fmin(square * change, 1.0)
    return ca.if_else(
        ca.logic_and(peak > square, factor > 1), ca.fmax(expected, RESUMED**2), ca.fmin(peak * change, 1.0)
    )


def not_across(h: ca.SX, left: ca.SX) -> ca.SX:
    """The step to make where h is wanted and nothing may cross what is `left` away [s]: no tiny step is left over."""
    halved = ca.if_else(left < 2 * h, left / 2, h)
    return ca.if_else(left <= 1.1 * h, left, halved)


# The size of an estimated error: root mean square of (dq, h dv) relative to the amplitudes of the coordinates.
#
# Velocities are weighted by h: without them what is delivered is many times what was asked. The amplitude of a
# coordinate is half the range that it has been seen in, the end of the step in question included, so that the first
# steps of a motion from rest are measured by how far they go; at least FLOOR of the largest of its kind and unit, and
# LEAST; of an angle of a body at most TURN.

FLOOR = 1e-3  # so that small vibrations, far below what moves, need not be resolved
TURN = np.pi  # rad: what turns on and on is not measured by how far it has come
LEAST = 1e-10  # m or rad: a motion that begins as a power of time is as large as its error for ever


def weights(model: EmittedModel, low: ca.SX, high: ca.SX) -> ca.SX:
    """(n_i) what squares of errors are multiplied by, of coordinates seen between low and high."""
    scale = amplitudes(model, (high - low) / 2)
    return 1 / (2 * len(model.q_i) * scale * scale)


def mean_square(weight: ca.SX, dq: ca.SX, h_dv: ca.SX) -> ca.SX:
    """The square of the size of errors dq and h dv (n_i each)."""
    return ca.dot(weight, dq * dq + h_dv * h_dv)


def amplitudes(model: EmittedModel, half_ranges: ca.SX) -> ca.SX:
    """(n_i) what errors are measured by."""
    entries = {entry.name: entry for entry in model.description.coordinates}
    of_bodies = {name: ("angle", "rad") for record in model.description.orientations for name in record.turns}
    kinds = [of_bodies.get(name) or (entries[name].kind, entries[name].unit) for name in model.q_i]
    turns = [kind[1] == "rad" and kind[0] != "modal" for kind in kinds]
    seen = [ca.fmin(half_ranges[k], TURN) if turns[k] else half_ranges[k] for k in range(len(kinds))]
    for own in model.places.turns:  # an orientation as a whole
        widest = ca.SX(0)
        for k in own:
            widest = ca.fmax(widest, seen[k]) if k < len(seen) else widest
        seen = [widest if k in own else one for k, one in enumerate(seen)]
    largest = {kind: ca.SX(LEAST) for kind in kinds}
    for kind, one in zip(kinds, seen, strict=True):
        largest[kind] = ca.fmax(largest[kind], one)
    return ca.vertcat(
        *(ca.fmax(ca.fmax(one, LEAST), FLOOR * largest[kind]) for kind, one in zip(kinds, seen, strict=True))
    )


# What z and the constants hold of steps whose length follows from a tolerance, and what a run asks of it.

STOPS = 4  # times ahead that z knows; whoever runs the scheme fills in the next ones
FIRST = 0.1  # of dt: the first step that is tried
WIDER = 1.5  # ranges whose squares, weighted, add up to so much more than before make the weights be formed anew
SHORTEST, SHORTEST_OF_TIME = 1e-12, 1e-14  # of dt and of t: shorter steps are not made
NOTHING = 1e-12  # of a step: an interpolant is not asked for less
ATTEMPTS = 1 << 13  # in one application of the program; the next one goes on
# C of a loop before the last Newton step of an evaluation, in mechanism lengths, up to which a step is taken at the
# largest tolerance; of smaller ones as C goes with steps, so that a run is compared with one of other steps
CLOSES = 1e-3
CLOSER, CLOSURE_ORDER = 0.5, 3  # of it, what the next step is made for; C goes at least as h^3
# what an attempt changes although it may be refused: `before` keeps it
RESTORED = ("closure_error", "det_now", "det_low", "det_high")


class AdaptiveSteps(Scheme):
    """Steps of a method as long as its estimate asks for, and its state: see `fields`."""

    adaptive = True

    def __init__(self, method: Method) -> None:
        self.method, self.order, self.damps = method, method.order, method.damps
        super().__init__(method.model, method.grid, method.options)
        self.c_size += 1

    @property
    def tolerance(self) -> float:
        """Of a step's estimated error."""
        return float(self.options.tolerance)  # type: ignore[attr-defined]

    def constants(self, c: np.ndarray, dt: float | None = None, tolerance: float | None = None) -> np.ndarray:
        """The model's c, the time between states that are seen [s], and the tolerance."""
        return np.append(super().constants(c, dt), self.tolerance if tolerance is None else tolerance)

    def fields(self) -> dict[str, StateField]:
        """Start and end of the running step, its method's fields, the controller's, and what is counted."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {
            **super().fields(),
            **dict.fromkeys(("q_from", "v_from", "q_to", "v_to"), state(n)),
            **dict.fromkeys(("loop_from", "loop_to"), state(loops)),
            **dict.fromkeys(("t_from", "t_to"), state(1)),
            "a_from": state(n),
            **self.method.method_fields(),
            "q_seen": state(n if self.model.description.orientations else 0),
            **dict.fromkeys(("q_error", "v_error", "q_low", "q_high", "weight"), state(n)),
            **dict.fromkeys(("width", "wider", "h_next", "h_try", "t_try", "end", "peak"), state(1)),
            **dict.fromkeys(("odd", "fresh", "cold"), state(1)),
            "det_now": account(loop_blocks(self.model)),
            "before": account(1 + 3 * loop_blocks(self.model)),
            "stops": given(STOPS),
            **dict.fromkeys(("beside", "lands"), given(1)),
            **dict.fromkeys(("closes", "missed"), state(min(1, loops))),
            **dict.fromkeys(("going", "stuck", "accepted", "counted", "rejected", "h_least", "h_largest"), account(1)),
        }

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """Fields of z at the start: the end of no step."""
        fields = dict(super().started(t0, q_i, q_i_dot, loop, equations))
        start = equations.close_well(q_i, loop, t0)
        for end in ("from", "to"):
            fields |= {f"q_{end}": q_i, f"v_{end}": q_i_dot, f"loop_{end}": fields["loop"], f"t_{end}": t0}
        seen = self.ranged(q_i, start)
        return {
            **fields,
            "q_seen": seen if self.model.description.orientations else ca.SX(0, 1),
            "q_low": seen,
            "q_high": seen,
            "closes": self._closes(start, equations),
            "h_next": FIRST * equations.h[0],
            "fresh": ca.SX(1),
            "cold": ca.SX(1),
            "det_now": start.det_loop,
            "stops": ca.SX.ones(STOPS) * LARGEST,
            "h_least": ca.SX(LARGEST),
        }

    def _closes(self, start: ClosedConfiguration, equations: StageEquations) -> ca.SX:
        """Up to which C [m or rad] loops close within a step: by the longest lever arm at the start."""
        if not self.model.loop_unknowns:
            return ca.SX(0, 1)
        q = equations.joined(start.q_i, start.q_d)
        C_q = equations.call("constraints", q=q, q_dot=ca.SX.zeros(q.numel()), t=start.t)["C_q"]
        rows, columns = np.flatnonzero(length_rows(self.model)), np.flatnonzero(turning_columns(self.model))
        longest = ca.SX(0)
        for arm in ca.vertsplit(ca.vec(ca.densify(C_q[rows.tolist(), columns.tolist()]))):
            longest = ca.fmax(longest, ca.fabs(arm))
        share = CLOSES * (equations.h[-1] / LARGEST_TOLERANCE) ** (CLOSURE_ORDER / self.method.error_order)
        return share * ca.if_else(longest > SMALLEST_ARM, longest, 1.0)

    def ranged(self, q: ca.SX, motion: ClosedConfiguration) -> ca.SX:
        """q_i of which ranges are told: twice the vector of Euler parameters for turns, which a step counts anew."""
        found = ca.SX(q)
        for record, own in zip(self.model.description.orientations, self.charts.turns, strict=True):
            for name, k in zip(record.parameters[1:], own, strict=True):
                if k >= q.numel():
                    continue
                found[k] = 2 * motion.q_d[self.model.q_d.index(name)]
        return found

    def evaluations(self) -> tuple[int, int]:
        """Not to be told from the number of states that are seen; see `taken`."""
        return 0, 0

    def taken(self, z: np.ndarray) -> dict[str, float | int | str]:
        """For the statistics of a run that has come to z (flat): accepted and rejected steps, least and largest [s]."""
        seen = {name: z[self.layout.slice(name)][0] for name in ("accepted", "rejected", "h_least", "h_largest")}
        accepted, rejected = int(seen["accepted"]), int(seen["rejected"])
        start, attempt = self.method.counted_evaluations
        return {
            "steps": accepted,
            "rejected_steps": rejected,
            "least_step": float(seen["h_least"]) if accepted else 0.0,
            "largest_step": float(seen["h_largest"]),
            "evaluations": accepted * start + (accepted + rejected) * attempt,
            "reached": self.reached(z),
        }

    def look_ahead(self, z: np.ndarray, jumps: Sequence[SwitchTime], halts: bool = False) -> None:
        """Write the next of all times, rising, that no step may cross to z (flat), and how near they are looked at.

        halts: nothing goes on from the next of them by itself, see `has_halted`.
        """
        stops, beside = self.layout.slice("stops"), self.layout.slice("beside")
        cool_downs = "event_quiet" in self.layout.sizes
        if not jumps and not cool_downs:
            z[stops], z[beside] = LARGEST, 0.0
            return
        reached = float(z[self.layout.slice("t_to")][0])
        first = bisect_right(jumps, reached, key=lambda one: one.time)
        ahead = [one.time for one in jumps[first : first + STOPS]]
        if cool_downs:  # where a cool-down is over, events are looked for again
            over = {one for one in z[self.layout.slice("event_quiet")].tolist() if one > reached}
            ahead = sorted({*ahead, *over})[:STOPS]
        near = jumps[max(0, first - 1) : first + STOPS]
        z[stops] = ahead[0] if halts and ahead else [*ahead, *[LARGEST] * (STOPS - len(ahead))]
        z[beside] = max((max(one.after - one.time, one.time - one.before) for one in near), default=0)

    def has_halted(self, z: np.ndarray) -> bool:
        """Is z (n_z,) at the last time that it knows of?"""
        return bool(z[self.layout.slice("stops")][-1] <= z[self.layout.slice("t_to")][0])

    def end_at_event(self, z: np.ndarray, constants: np.ndarray, run: Step) -> list[int]:
        """End the last step of z (whole, flat) in place where an event has just happened; which ones do.

        None may: then the step has only come near to one, and z goes on from its end. constants: as stages read them.
        """
        return ended_at_event(self, z, constants, run)

    def show_end(self, z: np.ndarray, dt: float, run: Step) -> None:
        """Let z (whole, flat) be seen at the end of its last step: one state of dt [s] more."""
        shown_at_end(self, z, dt, run)

    def land(self, z: np.ndarray) -> None:
        """From z (flat) on, end a step at every state that is seen."""
        z[self.layout.slice("lands")] = 1.0

    def next_step(self, z: np.ndarray) -> float:
        """The one to be tried, or from one state that is seen to the next [s]."""
        return max(float(z[self.layout.slice("h_try")][0]), super().next_step(z))

    def at_end(self, z: np.ndarray) -> np.ndarray:
        """A copy of z (n_z,) that is seen at the end of its last step."""
        found = z.copy()
        self.begin_anew(found)
        return found

    def begin_anew(self, z: np.ndarray) -> float:
        """Let z (flat) be seen at the end of its last step, time counted from there; the step wanted next [s]."""
        for name, end in (("t0", "t_to"), ("x", "q_to"), ("v", "v_to"), ("loop", "loop_to")):
            z[self.layout.slice(name)] = z[self.layout.slice(end)]
        z[self.layout.slice("n")] = 0
        return float(z[self.layout.slice("h_next")][0])

    def is_stuck(self, z: np.ndarray) -> bool:
        """Did the least step not meet the tolerance?"""
        return bool(z[self.layout.slice("stuck")][0] > 0)

    @property
    def remembers(self) -> bool:
        """Behind a stop they begin with nothing but positions and rates."""
        return False

    def reached(self, z: np.ndarray) -> float:
        """Time at the end of the last accepted step [s]."""
        return float(z[self.layout.slice("t_to")][0])

    # ---- which step is tried next ---------------------------------------------------------------------------
    #
    # `aim` begins every application of the program. `judge` comes where an attempt was not as usual: its error left
    # the band, its end is near a time that no step crosses, or ranges have grown.

    def _goal(self, z: Fields, equations: StageEquations) -> ca.SX:
        return z["t0"] + (z["n"] + 1) * equations.h[0]

    def _aim(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        low, high = ca.fmin(z["det_low"], z["det_now"]), ca.fmax(z["det_high"], z["det_now"])
        way = self._left(z, self._goal(z, equations) - z["t_to"], z["t_to"])
        if "event_step" in z:  # nothing goes on from an event that nobody has taken
            way = ca.if_else(z["event_step"] < NEVER, 0, way)
        now = self._seen(z)
        low_now, high_now = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        weight = self._weight(low_now, high_now, equations)
        width = WIDER * ca.dot(weight, (high_now - low_now) ** 2)
        plan = self.planned(z, equations, z["t_to"], z["h_next"])
        counted = self._lengths(z, z["accepted"])
        return {**counted, "going": way, "det_low": low, "det_high": high, "weight": weight, "width": width, **plan}

    @staticmethod
    def _seen(z: Fields) -> ca.SX:
        """What ranges are told of at the end of the last step."""
        return z["q_seen"] if z["q_seen"].numel() else z["q_to"]

    @staticmethod
    def _before(z: Fields) -> dict[str, ca.SX]:
        """What the fields of RESTORED were before the last attempt."""
        names, ends = [name for name in RESTORED], [0]
        for name in names:
            ends.append(ends[-1] + z[name].numel())
        return dict(zip(names, ca.vertsplit(z["before"], ends), strict=True))

    def _weight(self, low: ca.SX, high: ca.SX, equations: StageEquations) -> ca.SX:
        """(n_i) what makes e^2 of squares of estimated errors, of coordinates seen between low and high."""
        asked = equations.h[-1] / self.method.strictness
        return weights(self.model, low, high) / (asked * asked)

    @staticmethod
    def _left(z: Fields, way: ca.SX, t: ca.SX) -> ca.SX:
        """What is left to go [s], not positive where nothing can be done: stuck, or no further stop is known."""
        blind = z["stops"][STOPS - 1] <= t
        return ca.if_else(ca.logic_or(z["stuck"] > 0, blind), 0.0, way)

    def planned(self, z: Fields, equations: StageEquations, t: ca.SX, wanted: ca.SX) -> dict[str, ca.SX]:
        """The step to try from t on, where one of `wanted` [s] would be right: its length, its end, what limits it.

        The one place where the end of a step is chosen. Nothing crosses the next of `stops`, nor, where z `lands`, the
        time that is to be reached.
        """
        end, goal = ca.SX(LARGEST), self._goal(z, equations)
        for stop in [*ca.vertsplit(z["stops"]), ca.if_else(z["lands"] > 0, goal, LARGEST)]:
            end = ca.fmin(end, ca.if_else(stop > t, stop, LARGEST))
        h = not_across(wanted, end - t)
        return {"h_try": h, "t_try": ca.if_else(h >= end - t, end, t + h), "end": end, "h_next": wanted}

    def _judge(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Of a step that was not as usual: is it accepted, and what comes next?"""
        h, now = z["h_try"], self._seen(z)
        low, high = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        weight = self._weight(low, high, equations)
        square = mean_square(weight, z["q_error"], h * z["v_error"])
        # the errors before were measured as this one was
        peak = z["peak"] * square / ca.fmax(mean_square(z["weight"], z["q_error"], h * z["v_error"]), SMALLEST**2)
        accepted = square <= REFUSED**2
        factor = step_factor(square, peak, self.method.error_order)
        if self.model.loop_unknowns:
            accepted = ca.logic_and(accepted, z["missed"] <= z["closes"])
            factor = ca.fmin(factor, closing_factor(z["missed"], z["closes"]))
        wanted = h * factor
        wanted = ca.if_else(accepted, ca.fmax(wanted, ca.if_else(h < z["h_next"], z["h_next"], 0.0)), wanted)
        t = ca.if_else(accepted, z["t_to"], z["t_from"])
        plan = self.planned(z, equations, t, wanted)
        stuck = ca.logic_or(z["stuck"] > 0, wanted < SHORTEST * equations.h[0] + SHORTEST_OF_TIME * ca.fabs(t))
        landed = ca.logic_and(accepted, z["t_to"] >= z["end"])
        restored = {name: ca.if_else(accepted, z[name], old) for name, old in self._before(z).items()}
        return {
            **restored,
            **plan,
            **{"weight": weight, "width": WIDER * ca.dot(weight, (high - low) ** 2), "wider": ca.SX(0)},
            "peak": peak_after(square, peak, factor, self.method.error_order),
            "t_to": t,
            **self._lengths(z, z["accepted"] - ca.if_else(accepted, 0.0, 1.0)),
            "rejected": z["rejected"] + ca.if_else(accepted, 0.0, 1.0),
            "fresh": ca.if_else(accepted, 1.0, 0.0),
            "cold": landed,
            "stuck": stuck,
            "going": self._left({**z, "stuck": stuck}, self._goal(z, equations) - t, t),
        }

    @staticmethod
    def _lengths(z: Fields, accepted: ca.SX) -> dict[str, ca.SX]:
        """So many steps are accepted; the least and the largest of them, where any were made since the last time."""
        made = accepted > z["counted"]
        least, largest = ca.fmin(z["h_least"], z["h_try"]), ca.fmax(z["h_largest"], z["h_try"])
        return {
            "h_least": ca.if_else(made, least, z["h_least"]),
            "h_largest": ca.if_else(made, largest, z["h_largest"]),
            **{"accepted": accepted, "counted": accepted},
        }

    # ---- the program ----------------------------------------------------------------------------------------

    def program(self) -> Program:
        """To the next time that is to be seen."""
        flag = {name: self.layout.slice(name).start for name in ("fresh", "cold", "odd", "going")}
        begin = Until(self.stage("begin", self._begin), flag["cold"], 1, usual=int(not self.method.first_same_as_last))
        moved: tuple[Program, ...] = (self.stage("range", self._range), self.stage("move", self._move))
        start = InTurn((Until(InTurn(moved), flag["fresh"], 1, usual=1), begin))
        judge = Until(self.stage("judge", self._judge), flag["odd"], 1, usual=0)
        step: tuple[Program, ...] = (start, self.stage("attempt", self._attempt), judge)
        if "event_step" in self.layout.sizes:
            look: tuple[Program, ...] = (self.stage("look", self._look),)
            if self.model.description.events:
                near = self.layout.slice("event_near").start
                look = (*look, Until(self.stage("look_inside", self._look_inside), near, 1, usual=0))
            step = (*step, Until(InTurn(look), flag["fresh"], 1, usual=1))
        reach = Until(InTurn(step), flag["going"], ATTEMPTS, usual=1)
        return InTurn((self.stage("aim", self._aim), reach, self.stage("show", self._show)))

    def _move(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The end of a step becomes a start, that of turns their charts."""
        out = {f"{name}_from": z[f"{name}_to"] for name in ("q", "v", "loop", "t")}
        out["before"] = ca.vertcat(*(z[name] for name in RESTORED))
        if self.charts.size:
            moved = self.rebased(z, self.arrived(equations, z["q_to"], z["loop_to"], z["t_to"]), z["loop_to"])
            out |= {"chart": moved["chart"], "q_from": moved["x"], "q_to": moved["x"]}
            out |= {"loop_from": moved["loop"], "loop_to": moved["loop"]}
        cold = z["cold"] if self.method.first_same_as_last else ca.SX(1)
        return {**out, **self.method.moved(z), "fresh": ca.SX(0), "cold": cold}

    def _range(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Ranges widen by what was reached."""
        now = self._seen(z)
        low, high = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        return {"q_low": low, "q_high": high, "wider": ca.dot(z["weight"], (high - low) ** 2) - z["width"]}

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """What is evaluated at a start."""
        motion, a, fields = self.method.begun(z, equations)
        out = {"cold": ca.SX(0), "a_from": a, "loop_from": equations.loop_part(motion.q_d), **fields}
        return {**out, **self.closed(z, motion), "det_now": motion.det_loop}

    def _attempt(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """As if it were accepted and the next one as long; `_judge` says otherwise where the estimate asks for it."""
        h, t = z["h_try"], z["t_try"]
        tried = self.method.attempted(z, equations, h)
        square = mean_square(z["weight"], tried.dq, h * tried.dv)
        peak = ca.fmax(square, FORGET**2 * z["peak"])
        # so far from an end another step and a half would not reach it
        usual = ca.logic_and(ca.logic_and(in_band(square, peak), t + 2 * h < z["end"]), z["wider"] <= 0)
        ended = self._ended(z, equations, tried)
        if self.model.loop_unknowns:
            usual = ca.logic_and(usual, ended["missed"] <= z["closes"])
        return {
            **ended,
            **{"q_error": tried.dq, "v_error": tried.dv, "odd": ca.if_else(usual, 0.0, 1.0)},
            "peak": peak,
            "going": self._goal(z, equations) - t,
        }

    def _ended(self, z: Fields, equations: StageEquations, tried: Attempt) -> dict[str, ca.SX]:
        """Fields at the end of a step of h_try to t_try; the next one as long."""
        h, t = z["h_try"], z["t_try"]
        on_the_way = tried.seen if tried.end is None else (*tried.seen, tried.end)
        loop = tried.loop if tried.end is None else equations.loop_part(tried.end.q_d)
        v = (
            self.method.velocities_at({**z, **tried.kept}, equations, h, tried.q, tried.v)
            if self.method.by_rates
            else tried.v
        )
        seen = {"q_seen": self.ranged(tried.q, on_the_way[-1])} if z["q_seen"].numel() else {}
        missed = ca.SX(0)
        for motion in on_the_way:
            missed = ca.fmax(missed, motion.C_loop)
        return {
            **tried.kept,
            **seen,
            **({"missed": missed} if self.model.loop_unknowns else {}),
            **{"q_to": tried.q, "v_to": v, "loop_to": loop, "t_to": t, "t_try": t + h},
            **self.closed(z, *on_the_way),
            "det_now": on_the_way[-1].det_loop,
            "accepted": z["accepted"] + 1,
            "fresh": ca.SX(1),
            "cold": ca.SX(0),
        }

    def _look(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Where z watches for events: their values after an accepted step; one that happens ends the loop."""
        motion = equations.close_well(z["q_to"], z["loop_to"], z["t_to"])
        found = self._events_at(z, equations, motion, z["v_to"])
        flag = flagged(self, z, z["event_values"], found, z["t_to"])
        return {"event_before": z["event_values"], **next_values(self, z, found), **self._stopped(z, flag, NEVER)}

    def _look_inside(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The same where one may have happened and ended within the step; the next one is not too long to tell."""
        new, h = z["event_values"], z["t_to"] - z["t_from"]
        values = [z["event_before"], *(self._events_inside(z, equations, share) for share in NODES), new]
        inside = ValuesInStep([one[: len(self.model.description.events)] for one in values])
        flag, longest = flagged(self, z, new, new, z["t_to"], inside.room_for_zero()), inside.longest(h, equations.h[0])
        shorter = self.planned(z, equations, z["t_to"], longest)
        next_one = {name: ca.if_else(longest < z["h_next"], one, z[name]) for name, one in shorter.items()}
        # ends alone tell nothing of values that turn within steps: the next one is looked at, too
        change = ca.if_else(inside.resolved(), z["event_change"], NEVER)
        return {**self._stopped(z, flag, z["event_step"]), **next_one, "event_near": ca.SX(0), "event_change": change}

    @staticmethod
    def _stopped(z: Fields, flag: ca.SX, otherwise: ca.SX | float) -> dict[str, ca.SX]:
        step, going = ca.if_else(flag, z["n"], otherwise), ca.if_else(flag, 0.0, z["going"])
        return {"event_step": step, "going": going}

    def _events_at(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        return event_outputs(self, equations, motion, v, equations.rates(motion, v))["events"]

    def _events_inside(self, z: Fields, equations: StageEquations, share: float | ca.SX) -> ca.SX:
        """(n_e,) by the interpolant at a share of the last step."""
        tau = share * (z["t_to"] - z["t_from"])
        q, v = self.method.between(z, equations, tau)
        guess = z["loop_from"] + share * (z["loop_to"] - z["loop_from"])
        motion = equations.close_well(q, guess, z["t_from"] + tau)
        return self._events_at(z, equations, motion, v)

    @property
    def events_between(self) -> ca.Function:
        """(z, c, share of the last step) -> values of events (n_e,)."""

        def build() -> ca.Function:
            z, c, share = ca.SX.sym("z", self.layout.size), ca.SX.sym("c", self.c_size), ca.SX.sym("share")
            fields = self.layout.unpack(z)
            found = self._events_inside(fields, self.equations(c, fields), share)
            return ca.Function("events_between", [z, c, share], [ca.densify(found)])

        return self.derived("events_between", build)

    def _show(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        goal = self._goal(z, equations)
        arrived = z["t_to"] >= goal
        if "event_step" in z:  # what lies beyond it is made again
            arrived = ca.logic_and(arrived, z["event_step"] >= NEVER)
        h = z["t_to"] - z["t_from"]
        tau = ca.fmax(ca.fmin(goal, z["t_to"]) - z["t_from"], NOTHING * h)
        q, v = self.method.between(z, equations, tau)
        loop = z["loop_from"] + tau * (z["loop_to"] - z["loop_from"]) / h
        out = {"x": q, "v": v, "loop": loop, "n": z["n"] + 1}
        shown = {name: ca.if_else(arrived, new, z[name]) for name, new in out.items()}
        return {**shown, **self._lengths(z, z["accepted"])}


# ---- Across jumps: where steps may go next, and impulses of motions whose velocity jumps.


def run_across(
    stepper: Stepper,
    z: np.ndarray,
    steps: int,
    ready: np.ndarray,
    c: np.ndarray,
    dt: float,
    jumps: Sequence[SwitchTime],
    given: dict[float, Impulse],
) -> None:
    """Advance z (whole, flat) in place by so many states dt [s] apart; fewer up to an event or the least step.

    ready: what the program reads; c (c_size,): the model's constants with the inputs that hold. given: impulses of
    prescribed motions are entered here by their time.
    """
    scheme = stepper.scheme
    assert isinstance(scheme, AdaptiveSteps)
    end, moves = z[1] + steps, bool(jumps) and moves_in_time(scheme.model)
    event = scheme.layout.slice("event_step") if "event_step" in scheme.layout.sizes else slice(0, 0)

    def look_ahead() -> None:
        """Where no step crosses next; it halts there for impulses."""
        if moves and scheme.has_halted(z):
            if scheme.next_seen(z, dt) <= scheme.reached(z):
                return  # what lies before it is seen first
            given.update(give_impulse(scheme, z, c, jumps, dt))
        scheme.look_ahead(z, jumps, halts=moves)

    while z[1] < end and not scheme.is_stuck(z) and not (z[event] < NEVER).any():
        look_ahead()
        stepper.run(z, ready, int(end - z[1]))
    if moves:
        look_ahead()


def give_impulse(
    scheme: AdaptiveSteps, z: np.ndarray, c: np.ndarray, jumps: Sequence[SwitchTime], dt: float
) -> dict[float, Impulse]:
    """Of the jump at the end of the last step of z (n_z,), in place: rates just after it; {} where none jumps.

    c (c_size,): the model's constants; dt [s]: from one state that is seen to the next.
    """
    own, model, reached = scheme.layout.slice, scheme.model, scheme.reached(z)
    there = next((one for one in jumps if one.time == reached), None)
    if there is None:
        return {}
    constants = scheme.constants(c)
    shown = scheme.observer(z=scheme.at_end(z)[: scheme.layout.size], c=constants)
    parts = {name: np.asarray(value).ravel() for name, value in shown.items()}
    q = whole(model, parts["q_i"], parts["q_d"])
    found = impulse_at(model, c, q, parts["q_i_dot"], there.before, there.after)
    if found is None:
        return {}
    z[own("v_to")] += found[0]
    seen_at = float(z[own("t0")][0] + z[own("n")][0] * dt)
    if abs(seen_at - reached) <= ON_THE_GRID * dt:  # what is seen there is after the jump
        z[own("t0")] += max(0.0, there.after - seen_at)
        z[own("v")] = z[own("v_to")]
    return {there.time: found[1]}


# ---- Steps that end at an event: the step in which one is flagged is made again, as long as it takes.
#
# The step that runs across an event has seen what is beyond it: a force that kinks there, an input that changes. So it
# is not cut, but made anew from its start to the event, which is located on such steps: see event_search.py. The next
# step begins there anew, as behind a jump in time.

FAR = 1e15  # steps
MOST_PARTS = 100  # steps that one step becomes when its end is rejected


def ended_at_event(scheme: AdaptiveSteps, z: np.ndarray, constants: np.ndarray, run: Step) -> list[int]:
    """End the last step of z (whole, flat) in place where an event has just happened; which ones do.

    None may: then the step has only come near to one, and z goes on from its end. constants: as stages read them.
    """
    own = scheme.layout.slice
    start, end = float(z[own("t_from")][0]), float(z[own("t_to")][0])
    asleep = quiet_until(scheme, z) > start
    found: dict[float, np.ndarray] = {end - start: z.copy()}
    values = {0.0: z[own("event_before")].copy(), end - start: z[own("event_values")].copy()}

    def ask(old: np.ndarray, new: np.ndarray) -> list[int]:
        return passed(scheme, old, new, asleep)

    def at(s: float) -> np.ndarray:
        if s not in values:
            found[s] = _made_again(scheme, z, start + s, run)
            values[s] = found[s][own("event_values")]
        return values[s]

    reached = 0.0
    for _ in range(MOST_PARTS):
        bracket = _bracket(scheme, z, constants, asleep, reached)
        if bracket is None:
            break
        low, high = ((s, at(s)) for s in bracket)
        if ask(low[1], high[1]):  # on steps that end there, too
            s, before = first_passage(ask, at, low, high, end - start)
            z[:] = found[s]
            z[own("event_step")], z[own("cold")] = NEVER, 1.0
            return ask(before, z[own("event_values")])
        reached = bracket[1]
    z[own("event_step")] = NEVER
    return []


def _bracket(
    scheme: AdaptiveSteps, z: np.ndarray, constants: np.ndarray, asleep: np.ndarray, reached: float
) -> tuple[float, float] | None:
    """Where on the last step of z, from `reached` [s] on, an event happens first."""
    own = scheme.layout.slice
    before, after = z[own("event_before")], z[own("event_values")]
    length = float(z[own("t_to")][0] - z[own("t_from")][0])
    between = looked_at(scheme.events_between, z[: scheme.layout.size], constants)
    kinks = are_kinks(scheme)

    def values(s: np.ndarray) -> np.ndarray:
        e = between(s / length)
        e[s == 0], e[s == length] = before, after  # as they were seen while stepping
        return e

    found = None
    if not kinks.all():
        found = first_bracket(lambda a, b: bool(passed(scheme, a, b, asleep | kinks)), values, reached, length)
    first = length if found is None else found[0]
    low, high = values(np.array([reached, first]))
    return (reached, first) if passed(scheme, low, high, asleep | ~kinks) else found


def _made_again(scheme: AdaptiveSteps, z: np.ndarray, end: float, run: Step) -> np.ndarray:
    """A copy of z with its last step ended there [s]."""
    own, z = scheme.layout.slice, z.copy()
    z[own("h_next")] = z[own("t_to")] - z[own("t_from")]
    z[own("fresh")] = z[own("cold")] = 0.0
    for name in ("t", "q", "v", "loop"):
        z[own(f"{name}_to")] = z[own(f"{name}_from")]
    z[own("accepted")] -= 1
    z[own("stops")], z[own("event_values")] = end, z[own("event_before")]
    kept = {name: z[own(name)].copy() for name in ("beside", "n")}
    z[own("beside")], z[own("n")] = 0.0, FAR  # no state on the way is seen
    for _ in range(MOST_PARTS):
        z[own("event_step")] = NEVER
        run(z)
        if z[own("t_to")][0] >= end or scheme.is_stuck(z):
            break
    for name, value in kept.items():
        z[own(name)] = value
    return z


def shown_at_end(scheme: AdaptiveSteps, z: np.ndarray, dt: float, run: Step) -> None:
    """Let z (whole, flat) be seen at the end of its last step: one state of dt [s] more."""
    own = scheme.layout.slice
    t, n = float(z[own("t_to")][0]), float(z[own("n")][0]) + 1
    z[own("t0")] = t - n * dt
    while float(z[own("t0")][0]) + n * dt > t:
        z[own("t0")] = np.nextafter(z[own("t0")], -np.inf)
    run(z)

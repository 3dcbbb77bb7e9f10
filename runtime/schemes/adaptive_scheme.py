"""Adaptive steps: a step of the run is as many steps of a one-step method as a tolerance asks for.

The loop, the step size controller (step_size_controller.py) and the dense output are one program; the error is
measured as error_norm.py says. The estimate is that of an embedded pair (the local truncation error), and where the
method has it, the last evaluation of a step is the first of the next one (FSAL).

What `dt` is elsewhere is here the time between two states that can be seen: t0 + n dt. The method's own
steps do not end there; a state in between is had from the method's own interpolant. An application of the program
is

    aim             the time that is to be reached
    until reached:  from an accepted step on: move to its end, evaluate there what does not depend on h
                    attempt a step as long as the last one
                    where its error or the time asks for it: judge the step, reject it or not, propose the next length
    show            the interpolant at the time that was to be reached

The tolerance stands among the constants, behind the step, and h is a field of z: one program serves all of both.
No step crosses a time of `breakpoints`; the controller begins anew there.

References
----------
E. Hairer, S. P. Norsett, G. Wanner: Solving Ordinary Differential Equations I, 2nd ed., Springer 1993, sections II.4
(automatic step size control, embedded formulas), II.5 (FSAL) and II.6 (dense output).
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from runtime.contract.coordinates import SMALLEST_ARM, length_rows, turning_columns
from runtime.engine.program import Fields, Program, Until
from runtime.engine.program import Sequence as InTurn
from runtime.schemes.adaptive_event_steps import (
    events_between,
    first_event_in_step,
    look,
    look_inside,
)
from runtime.schemes.error_norm import error_weights, squared_error_norm
from runtime.schemes.one_step import Attempt, Method
from runtime.schemes.options import LARGEST_TOLERANCE
from runtime.schemes.scheme import LARGEST_NUMBER, Scheme, StateField, Step, account, given, state
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, loop_blocks
from runtime.schemes.step_size_controller import CLOSURE_ORDER, SMALLEST_ERROR, Closure, StepSizeController, not_across
from runtime.schemes.switching.times import JUMP_AT_STEP, SwitchTime
from runtime.schemes.switching.watched import NEVER

# What z and the constants hold of steps whose length follows from a tolerance, and what a run asks of it.

BREAKPOINTS = 4  # times ahead that z knows; whoever runs the scheme fills in the next ones
FIRST_STEP = 0.1  # of dt: the starting step size, the first step that is tried
RANGE_GROWTH = 1.5  # ranges whose squares, weighted, add up to so much more than before make the weights be formed anew
MIN_STEP, MIN_STEP_OF_TIME = 1e-12, 1e-14  # of dt and of t: shorter steps are not made
LEAST_TIME_IN_STEP = 1e-12  # of a step: an interpolant is not asked for less
MAX_ATTEMPTS = 1 << 13  # in one application of the program; the next one goes on
# C of a loop before the last Newton step of an evaluation, in mechanism lengths, up to which a step is taken at the
# largest tolerance; of smaller ones as C goes with steps, so that a run is compared with one of other steps
STEP_CLOSURE_LIMIT = 1e-3
NEVER_SAMPLED = 1e15  # steps
MOST_PARTS = 100  # steps that one step becomes when its end is rejected
STEPS_MADE = ("accepted_steps", "counted_steps", "rejected_steps", "h_least", "h_largest")
# what an attempt changes although it may be rejected: `before_attempt` keeps it
RESTORED = ("closure_error", "det_now", "det_low", "det_high")


class AdaptiveScheme(Scheme):
    """Steps of a method as long as its estimate asks for, and its state: see `fields`."""

    adaptive = True

    # with other q_i a state goes on with these, and with the ranges of the coordinates that both have
    carried = (
        *Scheme.carried,
        *STEPS_MADE,
        *("h_next", "on_output", "closure_limit"),
    )
    carried_by_coordinate = ("q_low", "q_high")

    def __init__(self, method: Method) -> None:
        self.method, self.order, self.damps = method, method.order, method.damps
        self.controller = StepSizeController(method.error_order)
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
            **dict.fromkeys(
                ("range_limit", "range_grew", "h_next", "h_try", "t_try", "t_bound", "error_peak"), state(1)
            ),
            **dict.fromkeys(("needs_judgement", "accepted", "restart"), state(1)),
            "det_now": account(loop_blocks(self.model)),
            "before_attempt": account(1 + 3 * loop_blocks(self.model)),
            "breakpoints": given(BREAKPOINTS),
            **dict.fromkeys(("side_offset", "on_output"), given(1)),
            **dict.fromkeys(("closure_limit", "closure_missed"), state(min(1, loops))),
            **dict.fromkeys(("remaining", "min_step_hit", *STEPS_MADE), account(1)),
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
            "closure_limit": self._closure_limit(start, equations),
            "h_next": FIRST_STEP * equations.h[0],
            "accepted": ca.SX(1),
            "restart": ca.SX(1),
            "det_now": start.det_loop,
            "breakpoints": ca.SX.ones(BREAKPOINTS) * LARGEST_NUMBER,
            "h_least": ca.SX(LARGEST_NUMBER),
        }

    def _closure_limit(self, start: ClosedConfiguration, equations: StageEquations) -> ca.SX:
        """Up to which C [m or rad] loops close within a step: by the longest lever arm at the start."""
        if not self.model.loop_unknowns:
            return ca.SX(0, 1)
        q = equations.joined(start.q_i, start.q_d)
        C_q = equations.call("constraints", q=q, q_dot=ca.SX.zeros(q.numel()), t=start.t)["C_q"]
        rows, columns = np.flatnonzero(length_rows(self.model)), np.flatnonzero(turning_columns(self.model))
        longest = ca.SX(0)
        for arm in ca.vertsplit(ca.vec(ca.densify(C_q[rows.tolist(), columns.tolist()]))):
            longest = ca.fmax(longest, ca.fabs(arm))
        share = STEP_CLOSURE_LIMIT * (equations.h[-1] / LARGEST_TOLERANCE) ** (CLOSURE_ORDER / self.method.error_order)
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
        seen = {
            name: z[self.layout.slice(name)][0] for name in ("accepted_steps", "rejected_steps", "h_least", "h_largest")
        }
        accepted, rejected = int(seen["accepted_steps"]), int(seen["rejected_steps"])
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
        breakpoints, offset = self.layout.slice("breakpoints"), self.layout.slice("side_offset")
        cool_downs = "event_quiet" in self.layout.sizes
        if not jumps and not cool_downs:
            z[breakpoints], z[offset] = LARGEST_NUMBER, 0.0
            return
        reached = float(z[self.layout.slice("t_to")][0])
        first = bisect_right(jumps, reached, key=lambda one: one.time)
        ahead = [one.time for one in jumps[first : first + BREAKPOINTS]]
        if cool_downs:  # where a cool-down is over, events are looked for again
            over = {one for one in z[self.layout.slice("event_quiet")].tolist() if one > reached}
            ahead = sorted({*ahead, *over})[:BREAKPOINTS]
        near = jumps[max(0, first - 1) : first + BREAKPOINTS]
        z[breakpoints] = ahead[0] if halts and ahead else [*ahead, *[LARGEST_NUMBER] * (BREAKPOINTS - len(ahead))]
        z[offset] = max((max(one.after - one.time, one.time - one.before) for one in near), default=0)

    def has_halted(self, z: np.ndarray) -> bool:
        """Is z (n_z,) at the last time that it knows of?"""
        return bool(z[self.layout.slice("breakpoints")][-1] <= z[self.layout.slice("t_to")][0])

    def end_at_event(self, z: np.ndarray, constants: np.ndarray, run: Step) -> list[int]:
        """End the last step of z (whole, flat) in place where an event has just happened; which ones do.

        None may: then the step has only come near to one, and z goes on from its end. constants: as stages read them.
        """
        own = self.layout.slice
        found = first_event_in_step(self, z, constants, lambda end: self.ended_sooner(z, end, run))
        if found is not None:
            z[:] = found.z
            z[own("restart")] = 1.0
        z[own("event_step")] = NEVER
        return [] if found is None else found.events

    def ended_sooner(self, z: np.ndarray, end: float, run: Step) -> np.ndarray:
        """A copy of z (whole, flat) whose last step is made again, from its start to `end` [s]; no state is shown."""
        own, z = self.layout.slice, z.copy()
        z[own("h_next")] = z[own("t_to")] - z[own("t_from")]
        z[own("accepted")] = z[own("restart")] = 0.0
        for name in ("t", "q", "v", "loop"):
            z[own(f"{name}_to")] = z[own(f"{name}_from")]
        z[own("accepted_steps")] -= 1
        z[own("breakpoints")], z[own("event_values")] = end, z[own("event_before")]
        if "side" in self.layout.sizes:
            z[own("side")] = z[own("side_before")]
        kept = {name: z[own(name)].copy() for name in ("side_offset", "n")}
        z[own("side_offset")], z[own("n")] = 0.0, NEVER_SAMPLED  # no state on the way is seen
        for _ in range(MOST_PARTS):
            z[own("event_step")] = NEVER
            run(z)
            if z[own("t_to")][0] >= end or self.hit_min_step(z):
                break
        for name, value in kept.items():
            z[own(name)] = value
        return z

    def show_end(self, z: np.ndarray, dt: float, run: Step) -> None:
        """Let z (whole, flat) be seen at the end of its last step: one state of dt [s] more."""
        own = self.layout.slice
        t, n = float(z[own("t_to")][0]), float(z[own("n")][0]) + 1
        z[own("t0")] = t - n * dt
        while float(z[own("t0")][0]) + n * dt > t:
            z[own("t0")] = np.nextafter(z[own("t0")], -np.inf)
        run(z)

    def add_to_rates(self, z: np.ndarray, change: np.ndarray) -> None:
        """Add to q_i_dot (n_i,) of z (n_z,), of what is seen and at the end of the last step."""
        super().add_to_rates(z, change)
        self.add_to_rates_at_end(z, change)

    def add_to_rates_at_end(self, z: np.ndarray, change: np.ndarray) -> None:
        """Add to q_i_dot (n_i,) at the end of the last step of z (n_z,); what is seen before it stays."""
        z[self.layout.slice("v_to")] += change

    def jump_at_end(self, z: np.ndarray, change: np.ndarray, dt: float, after: float) -> None:
        """The rates (n_i,) jump at the end of the last step of z (n_z,): what is seen there, each dt [s], is after it.

        after [s]: a time just behind the jump.
        """
        own, reached = self.layout.slice, self.reached(z)
        self.add_to_rates_at_end(z, change)
        sampled_at = float(z[own("t0")][0] + z[own("n")][0] * dt)
        if abs(sampled_at - reached) <= JUMP_AT_STEP * dt:
            z[own("t0")] += max(0.0, after - sampled_at)
            z[own("v")] = z[own("v_to")]

    def land(self, z: np.ndarray) -> None:
        """From z (flat) on, end a step at every state that is seen."""
        z[self.layout.slice("on_output")] = 1.0

    def next_step(self, z: np.ndarray) -> float:
        """The one to be tried, or from one state that is seen to the next [s]."""
        return max(float(z[self.layout.slice("h_try")][0]), super().next_step(z))

    def at_end(self, z: np.ndarray) -> np.ndarray:
        """A copy of z (n_z,) that is seen at the end of its last step."""
        own, found = self.layout.slice, z.copy()
        for name, end in (("t0", "t_to"), ("x", "q_to"), ("v", "v_to"), ("loop", "loop_to")):
            found[own(name)] = z[own(end)]
        found[own("n")] = 0
        return found

    def hit_min_step(self, z: np.ndarray) -> bool:
        """Did the least step not meet the tolerance?"""
        return bool(z[self.layout.slice("min_step_hit")][0] > 0)

    def steps_made(self, z: np.ndarray) -> int:
        """Accepted steps that led to z (n_z,)."""
        return int(z[self.layout.slice("accepted_steps")][0])

    @property
    def multistep(self) -> bool:
        """No: behind a breakpoint steps begin with nothing but positions and rates."""
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
        now = self._ranged_state(z)
        low_now, high_now = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        weight = self._weight(low_now, high_now, equations)
        width = RANGE_GROWTH * ca.dot(weight, (high_now - low_now) ** 2)
        plan = self.planned(z, equations, z["t_to"], z["h_next"])
        counted = self._lengths(z, z["accepted_steps"])
        return {
            **counted,
            "remaining": way,
            "det_low": low,
            "det_high": high,
            "weight": weight,
            "range_limit": width,
            **plan,
        }

    @staticmethod
    def _ranged_state(z: Fields) -> ca.SX:
        """What ranges are told of at the end of the last step."""
        return z["q_seen"] if z["q_seen"].numel() else z["q_to"]

    @staticmethod
    def _before(z: Fields) -> dict[str, ca.SX]:
        """What the fields of RESTORED were before the last attempt."""
        names, ends = [name for name in RESTORED], [0]
        for name in names:
            ends.append(ends[-1] + z[name].numel())
        return dict(zip(names, ca.vertsplit(z["before_attempt"], ends), strict=True))

    def _weight(self, low: ca.SX, high: ca.SX, equations: StageEquations) -> ca.SX:
        """(n_i) what makes e^2 of squares of estimated errors, of coordinates seen between low and high."""
        asked = equations.h[-1] / self.method.strictness
        return error_weights(self.model, low, high) / (asked * asked)

    @staticmethod
    def _left(z: Fields, way: ca.SX, t: ca.SX) -> ca.SX:
        """What is left to go [s], not positive at the least step, or where no later breakpoint is known."""
        blind = z["breakpoints"][BREAKPOINTS - 1] <= t
        return ca.if_else(ca.logic_or(z["min_step_hit"] > 0, blind), 0.0, way)

    def planned(self, z: Fields, equations: StageEquations, t: ca.SX, wanted: ca.SX) -> dict[str, ca.SX]:
        """The step to try from t on, where one of `wanted` [s] would be right: its length, its end, what limits it.

        The one place where the end of a step is chosen. Nothing crosses the next of `breakpoints`, nor, where steps end
        `on_output`, the time that is to be reached.
        """
        end, goal = ca.SX(LARGEST_NUMBER), self._goal(z, equations)
        for one in [*ca.vertsplit(z["breakpoints"]), ca.if_else(z["on_output"] > 0, goal, LARGEST_NUMBER)]:
            end = ca.fmin(end, ca.if_else(one > t, one, LARGEST_NUMBER))
        h = not_across(wanted, end - t)
        return {"h_try": h, "t_try": ca.if_else(h >= end - t, end, t + h), "t_bound": end, "h_next": wanted}

    def _judge(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Of a step that was not as usual: is it accepted, and what comes next?"""
        h, now = z["h_try"], self._ranged_state(z)
        low, high = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        weight = self._weight(low, high, equations)
        square = squared_error_norm(weight, z["q_error"], h * z["v_error"])
        # the errors before were measured as this one was
        before = squared_error_norm(z["weight"], z["q_error"], h * z["v_error"])
        peak = z["error_peak"] * square / ca.fmax(before, SMALLEST_ERROR**2)
        accepted = self.controller.judge(square, self._closure(z))
        factor = self.controller.propose(square, peak, self._closure(z))
        wanted = h * factor
        wanted = ca.if_else(accepted, ca.fmax(wanted, ca.if_else(h < z["h_next"], z["h_next"], 0.0)), wanted)
        t = ca.if_else(accepted, z["t_to"], z["t_from"])
        plan = self.planned(z, equations, t, wanted)
        min_step_hit = ca.logic_or(
            z["min_step_hit"] > 0, wanted < MIN_STEP * equations.h[0] + MIN_STEP_OF_TIME * ca.fabs(t)
        )
        landed = ca.logic_and(accepted, z["t_to"] >= z["t_bound"])
        restored = {name: ca.if_else(accepted, z[name], old) for name, old in self._before(z).items()}
        return {
            **restored,
            **plan,
            **{
                "weight": weight,
                "range_limit": RANGE_GROWTH * ca.dot(weight, (high - low) ** 2),
                "range_grew": ca.SX(0),
            },
            "error_peak": self.controller.peak_after_change(square, peak, factor),
            "t_to": t,
            **self._lengths(z, z["accepted_steps"] - ca.if_else(accepted, 0.0, 1.0)),
            "rejected_steps": z["rejected_steps"] + ca.if_else(accepted, 0.0, 1.0),
            "accepted": ca.if_else(accepted, 1.0, 0.0),
            "restart": landed,
            "min_step_hit": min_step_hit,
            "remaining": self._left({**z, "min_step_hit": min_step_hit}, self._goal(z, equations) - t, t),
        }

    def _closure(self, z: Fields) -> Closure | None:
        """How well loops closed in the step that was tried."""
        return Closure(z["closure_missed"], z["closure_limit"]) if self.model.loop_unknowns else None

    @staticmethod
    def _lengths(z: Fields, accepted: ca.SX) -> dict[str, ca.SX]:
        """So many steps are accepted; the least and the largest of them, where any were made since the last time."""
        made = accepted > z["counted_steps"]
        least, largest = ca.fmin(z["h_least"], z["h_try"]), ca.fmax(z["h_largest"], z["h_try"])
        return {
            "h_least": ca.if_else(made, least, z["h_least"]),
            "h_largest": ca.if_else(made, largest, z["h_largest"]),
            **{"accepted_steps": accepted, "counted_steps": accepted},
        }

    # ---- the program ----------------------------------------------------------------------------------------

    def program(self) -> Program:
        """To the next time that is to be seen."""
        flag = {name: self.layout.slice(name).start for name in ("accepted", "restart", "needs_judgement", "remaining")}
        begin = Until(
            self.stage("begin", self._begin), flag["restart"], 1, usual=int(not self.method.first_same_as_last)
        )
        moved: tuple[Program, ...] = (self.stage("range", self._range), self.stage("move", self._move))
        start = InTurn((Until(InTurn(moved), flag["accepted"], 1, usual=1), begin))
        judge = Until(self.stage("judge", self._judge), flag["needs_judgement"], 1, usual=0)
        step: tuple[Program, ...] = (start, self.stage("attempt", self._attempt), judge)
        if "event_step" in self.layout.sizes:
            looks: tuple[Program, ...] = (self.stage("look", lambda z, equations: look(self, z, equations)),)
            if self.model.description.events:
                near = self.layout.slice("event_near").start
                inside = self.stage("look_inside", lambda z, equations: look_inside(self, z, equations))
                looks = (*looks, Until(inside, near, 1, usual=0))
            step = (*step, Until(InTurn(looks), flag["accepted"], 1, usual=1))
        reach = Until(InTurn(step), flag["remaining"], MAX_ATTEMPTS, usual=1)
        return InTurn((self.stage("aim", self._aim), reach, self.stage("show", self._show)))

    def _move(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The end of a step becomes a start, that of turns their charts."""
        out = {f"{name}_from": z[f"{name}_to"] for name in ("q", "v", "loop", "t")}
        out["before_attempt"] = ca.vertcat(*(z[name] for name in RESTORED))
        if self.charts.size:
            moved = self.rebased(z, self.arrived(equations, z["q_to"], z["loop_to"], z["t_to"]), z["loop_to"])
            out |= {"chart": moved["chart"], "q_from": moved["x"], "q_to": moved["x"]}
            out |= {"loop_from": moved["loop"], "loop_to": moved["loop"]}
        restart = z["restart"] if self.method.first_same_as_last else ca.SX(1)
        return {**out, **self.method.moved(z), "accepted": ca.SX(0), "restart": restart}

    def _range(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Ranges widen by what was reached."""
        now = self._ranged_state(z)
        low, high = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        return {"q_low": low, "q_high": high, "range_grew": ca.dot(z["weight"], (high - low) ** 2) - z["range_limit"]}

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """What is evaluated at a start."""
        motion, a, fields = self.method.step_start(z, equations)
        out = {"restart": ca.SX(0), "a_from": a, "loop_from": equations.loop_part(motion.q_d), **fields}
        return {**out, **self.closed(z, motion), "det_now": motion.det_loop}

    def _attempt(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """As if it were accepted and the next one as long; `_judge` says otherwise where the estimate asks for it."""
        h, t = z["h_try"], z["t_try"]
        tried = self.method.attempted(z, equations, h)
        square = squared_error_norm(z["weight"], tried.dq, h * tried.dv)
        peak = self.controller.peak_after_step(square, z["error_peak"])
        # so far from an end another step and a half would not reach it
        kept = self.controller.keeps_step(square, peak)
        usual = ca.logic_and(ca.logic_and(kept, t + 2 * h < z["t_bound"]), z["range_grew"] <= 0)
        ended = self._ended(z, equations, tried)
        closure = self._closure({**z, **ended})
        if closure is not None:
            usual = ca.logic_and(usual, closure.is_met)
        return {
            **ended,
            **{"q_error": tried.dq, "v_error": tried.dv, "needs_judgement": ca.if_else(usual, 0.0, 1.0)},
            "error_peak": peak,
            "remaining": self._goal(z, equations) - t,
        }

    def _ended(self, z: Fields, equations: StageEquations, tried: Attempt) -> dict[str, ca.SX]:
        """Fields at the end of a step of h_try to t_try; the next one as long."""
        h, t = z["h_try"], z["t_try"]
        on_the_way = tried.configurations if tried.end is None else (*tried.configurations, tried.end)
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
            **({"closure_missed": missed} if self.model.loop_unknowns else {}),
            **{"q_to": tried.q, "v_to": v, "loop_to": loop, "t_to": t, "t_try": t + h},
            **self.closed(z, *on_the_way),
            "det_now": on_the_way[-1].det_loop,
            "accepted_steps": z["accepted_steps"] + 1,
            "accepted": ca.SX(1),
            "restart": ca.SX(0),
        }

    @property
    def events_between(self) -> ca.Function:
        """(z, c, share of the last step) -> values of events (n_e,)."""
        return self.derived("events_between", lambda: events_between(self))

    def _show(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        goal = self._goal(z, equations)
        arrived = z["t_to"] >= goal
        if "event_step" in z:  # what lies beyond it is made again
            arrived = ca.logic_and(arrived, z["event_step"] >= NEVER)
        h = z["t_to"] - z["t_from"]
        tau = ca.fmax(ca.fmin(goal, z["t_to"]) - z["t_from"], LEAST_TIME_IN_STEP * h)
        q, v = self.method.between(z, equations, tau)
        loop = z["loop_from"] + tau * (z["loop_to"] - z["loop_from"]) / h
        out = {"x": q, "v": v, "loop": loop, "n": z["n"] + 1}
        shown = {name: ca.if_else(arrived, new, z[name]) for name, new in out.items()}
        return {**shown, **self._lengths(z, z["accepted_steps"])}

"""A step of the run as many steps as a tolerance asks for: the loop, the controller and the output are one program.

What `dt` is elsewhere is here the time between two states that can be seen: t0 + n dt. The method's own steps do not
end there; a state in between is had from the method's own interpolant. An application of the program is

    aim             the time that is to be reached
    until reached:  where all steps are of one length: as many as need no look, each in one stage
                    from an accepted step on: move to its end, evaluate there what does not depend on h
                    attempt a step as long as the last one
                    where its error or the time asks for it: judge the step, refuse it or not, choose the next length
    show            the interpolant at the time that was to be reached

The tolerance stands among the constants, behind the step, and h is a field of z: one program serves all of both.
No step crosses a time of `stops`; the controller begins anew there.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.engine.program import Fields, Program, Sequence, Until
from runtime.schemes.adaptive.adaptive_state import RESTORED
from runtime.schemes.adaptive.controller import FORGET, in_band
from runtime.schemes.adaptive.error_norm import mean_square
from runtime.schemes.adaptive.step_control import StepControl
from runtime.schemes.method import Attempt
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.switching.dips import NODES, ValuesInStep
from runtime.schemes.switching.watched import NEVER, event_outputs, flagged, next_values

NOTHING = 1e-12  # of a step: an interpolant is not asked for less
STARTS = ("q_from", "v_from", "loop_from", "t_from", "a_from", "before")  # what a step sets anew that is looked at
ATTEMPTS = 1 << 13  # in one application of the program; the next one goes on


class AdaptiveSteps(StepControl):
    """The loop, around what a Method says of a step."""

    # ---- the program ----------------------------------------------------------------------------------------

    def program(self) -> Program:
        """To the next time that is to be seen."""
        flag = {name: self.layout.slice(name).start for name in ("fresh", "cold", "odd", "going", "ranging")}
        begin = Until(self.stage("begin", self._begin), flag["cold"], 1, usual=int(not self.first_same_as_last))
        widen = Until(self.stage("range", self._range), flag["ranging"], 1, usual=1)
        moved: tuple[Program, ...] = (widen, self.stage("move", self._move))
        start = Sequence((Until(Sequence(moved), flag["fresh"], 1, usual=1), begin, *self.after_begin()))
        judge = Until(self.stage("judge", self._judge), flag["odd"], 1, usual=0)
        step: tuple[Program, ...] = (start, self.stage("attempt", self._attempt), judge)
        if self.may_be_steady:
            step = (
                Until(self.stage("plain", self._plain), self.layout.slice("straight").start, ATTEMPTS, usual=0),
                *step,
            )
        if "event_step" in self.layout.sizes:
            inside = Until(
                self.stage("look_inside", self._look_inside), self.layout.slice("event_near").start, 1, usual=0
            )
            look = Sequence((self.stage("look", self._look), inside))
            step = (*step, Until(look, flag["fresh"], 1, usual=1))
        reach = Until(Sequence(step), flag["going"], ATTEMPTS, usual=1)
        return Sequence((self.stage("aim", self._aim), reach, self.stage("show", self._show)))

    def _move(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The end of a step becomes a start, that of turns their charts."""
        out = {f"{name}_from": z[f"{name}_to"] for name in ("q", "v", "loop", "t")}
        out["before"] = ca.vertcat(*(z[name] for name in RESTORED))
        if self.charts.size:
            moved = self.rebased(z, self.arrived(equations, z["q_to"], z["loop_to"], z["t_to"]), z["loop_to"])
            out |= {"chart": moved["chart"], "q_from": moved["x"], "q_to": moved["x"]}
            out |= {"loop_from": moved["loop"], "loop_to": moved["loop"]}
        cold = z["cold"] if self.first_same_as_last else ca.SX(1)
        return {**out, **self.moved(z), "fresh": ca.SX(0), "cold": cold}

    def _range(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Ranges widen by what was reached."""
        now = self._seen(z)
        low, high = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        return {"q_low": low, "q_high": high, "wider": ca.dot(z["weight"], (high - low) ** 2) - z["width"]}

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """What is evaluated at a start."""
        motion, a, fields = self.begun(z, equations)
        out = {"cold": ca.SX(0), "a_from": a, "loop_from": equations.loop_part(motion.q_d), **fields}
        return {**out, **self.closed(z, motion), "det_now": motion.det_loop}

    def _attempt(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """As if it were accepted and the next one as long; `_judge` says otherwise where the estimate asks for it."""
        h, t = z["h_try"], z["t_try"]
        tried = self.attempted(z, equations, h)
        square = mean_square(z["weight"], tried.dq, h * tried.dv)
        peak = ca.fmax(square, FORGET**2 * z["peak"])
        # so far from an end another step and a half would not reach it
        usual = ca.logic_and(ca.logic_and(in_band(square, peak), t + 2 * h < z["end"]), z["wider"] <= 0)
        usual = ca.logic_and(usual, z["steady"] <= 0)
        return {
            **self._ended(z, equations, tried),
            **{"q_error": tried.dq, "v_error": tried.dv, "odd": ca.if_else(usual, 0.0, 1.0)},
            "peak": peak,
            "going": self._goal(z, equations) - t,
        }

    def _ended(self, z: Fields, equations: StageEquations, tried: Attempt) -> dict[str, ca.SX]:
        """Fields at the end of a step of h_try to t_try; the next one as long."""
        h, t = z["h_try"], z["t_try"]
        on_the_way = tried.seen if tried.end is None else (*tried.seen, tried.end)
        loop = tried.loop if tried.end is None else equations.loop_part(tried.end.q_d)
        v = self.velocities_at({**z, **tried.kept}, equations, h, tried.q, tried.v) if self.by_rates else tried.v
        seen = {"q_seen": self.ranged(tried.q, on_the_way[-1])} if z["q_seen"].numel() else {}
        return {
            **tried.kept,
            **seen,
            **{"q_to": tried.q, "v_to": v, "loop_to": loop, "t_to": t, "t_try": t + h},
            **self.closed(z, *on_the_way),
            "det_now": on_the_way[-1].det_loop,
            "accepted": z["accepted"] + 1,
            "fresh": ca.SX(1),
            "cold": ca.SX(0),
        }

    def _plain(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """A step of one length among others, at once and without an estimate: what it begins with is not kept."""
        found = dict(self._move(z, equations))
        if self.charts.size:  # all that follows counts from the new charts
            equations = self.equations(ca.vertcat(equations.c, equations.h), {**z, **found})
        if not self.first_same_as_last:
            found |= self._begin({**z, **found}, equations)
        at = {**z, **found}
        found |= self._ended(at, equations, self.attempted(at, equations, z["h_try"]))
        gone = {*STARTS, *(() if self.first_same_as_last else self.method_fields())} - {*self.carried}
        return {**{name: one for name, one in found.items() if name not in gone}, "straight": z["straight"] - 1}

    def _look(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """Where z watches for events: their values after an accepted step; one that happens ends the loop."""
        motion = equations.close_well(z["q_to"], z["loop_to"], z["t_to"])
        found = self._events_at(z, equations, motion, z["v_to"])
        flag = flagged(self, z, z["event_values"], found, z["t_to"])
        return {"event_before": z["event_values"], **next_values(z, found), **self._stopped(z, flag, NEVER)}

    def _look_inside(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """The same where one may have happened and ended within the step; the next one is not too long to tell."""
        new, h = z["event_values"], z["t_to"] - z["t_from"]
        between = [self._events_inside(z, equations, share) for share in NODES]
        inside = ValuesInStep([z["event_before"], *between, new])
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
        q = equations.joined(self.charts.zeroed(motion.q_i), motion.q_d)
        return event_outputs(equations, motion.t, q, equations.joined(v, equations.rates(motion, v)))["events"]

    def _events_inside(self, z: Fields, equations: StageEquations, share: float | ca.SX) -> ca.SX:
        """(n_e,) by the interpolant at a share of the last step."""
        tau = share * (z["t_to"] - z["t_from"])
        q, v = self.between(z, equations, tau)
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
        q, v = self.between(z, equations, tau)
        loop = z["loop_from"] + tau * (z["loop_to"] - z["loop_from"]) / h
        out = {"x": q, "v": v, "loop": loop, "n": z["n"] + 1}
        shown = {name: ca.if_else(arrived, new, z[name]) for name, new in out.items()}
        return {**shown, **self._lengths(z, z["accepted"])}

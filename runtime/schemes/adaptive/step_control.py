"""Which step is tried next: the stages of a step of a tolerance that are needed once in a while.

`aim` begins every application of the program. `judge` comes where an attempt was not as usual: its error left the band
of controller.py, its end is near a time that no step crosses, or ranges have grown.
"""

from __future__ import annotations

from collections.abc import Mapping

import casadi as ca

from runtime.engine.program import Fields
from runtime.schemes.adaptive.adaptive_state import RESTORED, STOPS, AdaptiveState
from runtime.schemes.adaptive.controller import REFUSED, SMALLEST, not_across, peak_after, step_factor
from runtime.schemes.adaptive.error_norm import mean_square, weights
from runtime.schemes.scheme import LARGEST
from runtime.schemes.stage_equations import StageEquations

WIDER = 1.5  # ranges whose squares, weighted, add up to so much more than before make the weights be formed anew
LEAST, LEAST_OF_TIME = 1e-12, 1e-14  # of dt and of t: shorter steps are not made


class StepControl(AdaptiveState):
    """The controller, as stages."""

    def _goal(self, z: Fields, equations: StageEquations) -> ca.SX:
        return z["t0"] + (z["n"] + 1) * equations.h[0]

    def _aim(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        low, high = ca.fmin(z["det_low"], z["det_now"]), ca.fmax(z["det_high"], z["det_now"])
        way = self._left(z, self._goal(z, equations) - z["t_to"], z["t_to"])
        now = self._seen(z)
        low_now, high_now = ca.fmin(z["q_low"], now), ca.fmax(z["q_high"], now)
        weight = self._weight(z, low_now, high_now, equations)
        width = WIDER * ca.dot(weight, (high_now - low_now) ** 2)
        wanted = ca.if_else(z["steady"] > 0, z["steady"], z["h_next"])
        plan = {**self.planned(z, equations, z["t_to"], wanted), "straight": ca.SX(0)}
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

    def _weight(self, z: Fields, low: ca.SX, high: ca.SX, equations: StageEquations) -> ca.SX:
        """(n_i) what makes e^2 of squares of estimated errors, of coordinates seen between low and high."""
        asked = equations.h[-1] * z["per_step"] / self.strictness
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
        weight = self._weight(z, low, high, equations)
        square = mean_square(weight, z["q_error"], h * z["v_error"])
        # the errors before were measured as this one was
        peak = z["peak"] * square / ca.fmax(mean_square(z["weight"], z["q_error"], h * z["v_error"]), SMALLEST**2)
        steady = z["steady"] > 0
        accepted = ca.logic_or(square <= REFUSED**2, steady)
        factor = step_factor(square, peak, self.error_order)
        wanted = h * factor
        wanted = ca.if_else(accepted, ca.fmax(wanted, ca.if_else(h < z["h_next"], z["h_next"], 0.0)), wanted)
        wanted = ca.if_else(steady, z["steady"], wanted)
        t = ca.if_else(accepted, z["t_to"], z["t_from"])
        plan = self.planned(z, equations, t, wanted)
        stuck = ca.logic_or(z["stuck"] > 0, wanted < LEAST * equations.h[0] + LEAST_OF_TIME * ca.fabs(t))
        landed = ca.logic_and(accepted, z["t_to"] >= z["end"])
        restored = {name: ca.if_else(accepted, z[name], old) for name, old in self._before(z).items()}
        return {
            **restored,
            **plan,
            "straight": ca.if_else(ca.logic_and(steady, ca.logic_not(landed)), self._alike(z, equations, plan, t), 0.0),
            **{"weight": weight, "width": WIDER * ca.dot(weight, (high - low) ** 2), "wider": ca.SX(0)},
            "peak": peak_after(square, peak, factor, self.error_order),
            "t_to": t,
            **self._lengths(z, z["accepted"] - ca.if_else(accepted, 0.0, 1.0)),
            "rejected": z["rejected"] + ca.if_else(accepted, 0.0, 1.0),
            "fresh": ca.if_else(accepted, 1.0, 0.0),
            "cold": ca.logic_or(landed, ca.logic_not(accepted)) if self.begins_after_rejection else landed,
            "stuck": stuck,
            **({"restart": ca.logic_or(landed, z["restart"])} if "restart" in z else {}),
            "going": self._left({**z, "stuck": stuck}, self._goal(z, equations) - t, t),
        }

    def _alike(self, z: Fields, equations: StageEquations, plan: Mapping[str, ca.SX], t: ca.SX) -> ca.SX:
        """How many steps from t on need no look: all to the last before what is to be seen, or two before an end."""
        h = plan["h_next"]
        to_goal = ca.ceil((self._goal(z, equations) - t) / h) - 1
        return ca.fmax(0, ca.fmin(to_goal, ca.floor((plan["end"] - t) / h) - 2))

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

"""What z and the constants hold of steps whose length follows from a tolerance, and what a run asks of it."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Mapping, Sequence

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.schemes.grid import Grid
from runtime.schemes.method import Method
from runtime.schemes.options import Options
from runtime.schemes.scheme import LARGEST
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, loop_blocks
from runtime.schemes.state_fields import StateField, account, given, state
from runtime.schemes.step_limit import StepLimit
from runtime.schemes.switching.times import SwitchTime

STOPS = 4  # times ahead that z knows; whoever runs the scheme fills in the next ones
FIRST = 0.1  # of dt: the first step that is tried
# what an attempt changes although it may be refused: `before` keeps it
RESTORED = ("closure_error", "det_now", "det_low", "det_high")


class AdaptiveState(Method):
    """Start and end of the running step, the controller's memory, and what is counted."""

    adaptive = True
    begins_after_rejection = False  # does a refused attempt leave nothing to go on from?
    varies = True  # may steps follow their estimates?
    carried: tuple[str, ...] = ()  # fields by which a step among those of one length acts on the next

    def __init__(self, model: Model, grid: Grid, options: Options) -> None:
        self.refuse_varying(grid, options)
        super().__init__(model, grid, options)
        self.c_size += 1
        self._operations: dict[str, int] = {}

    @classmethod
    def limited(cls, options: Options) -> bool:
        """No: where a step is too long its estimate tells."""
        return False

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """None."""
        return None

    @property
    def tolerance(self) -> float:
        """Of a step's estimated error."""
        return float(self.options.tolerance)  # type: ignore[attr-defined]

    @property
    def may_be_steady(self) -> bool:
        """May a run be told to take steps of one length?"""
        return self.error_of == "motion" and "event_step" not in self.layout.sizes

    @property
    def error_of(self) -> str:
        """Is the tolerance that of the motion or of its steps?"""
        return str(self.options.error_of)  # type: ignore[attr-defined]

    def constants(self, c: np.ndarray, dt: float | None = None, tolerance: float | None = None) -> np.ndarray:
        """The model's c, the time between states that are seen [s], and the tolerance."""
        return np.append(super().constants(c, dt), self.tolerance if tolerance is None else tolerance)

    def further_fields(self) -> dict[str, StateField]:
        """Start and end of the running step, its method's fields, the controller's, and what is counted."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        return {
            "q_from": state(n),
            "v_from": state(n),
            "loop_from": state(loops),
            "t_from": state(1),
            "q_to": state(n),
            "v_to": state(n),
            "loop_to": state(loops),
            "t_to": state(1),
            "a_from": state(n),
            **self.method_fields(),
            "q_seen": state(n if self.model.description.orientations else 0),
            "q_error": state(n),
            "v_error": state(n),
            "q_low": state(n),
            "q_high": state(n),
            "weight": state(n),
            "ranging": given(1),
            "per_step": given(1),
            "steady": given(1),
            "straight": account(1),
            "width": state(1),
            "wider": state(1),
            "h_next": state(1),
            "h_try": state(1),
            "t_try": state(1),
            "end": state(1),
            "peak": state(1),
            "odd": state(1),
            "fresh": state(1),
            "cold": state(1),
            "det_now": account(loop_blocks(self.model)),
            "before": account(1 + 3 * loop_blocks(self.model)),
            "going": account(1),
            "stops": given(STOPS),
            "beside": given(1),
            "lands": given(1),
            "stuck": account(1),
            "accepted": account(1),
            "counted": account(1),
            "rejected": account(1),
            "h_least": account(1),
            "h_largest": account(1),
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
            "h_next": FIRST * equations.h[0],
            "fresh": ca.SX(1),
            "cold": ca.SX(1),
            "ranging": ca.SX(1),
            "per_step": ca.SX(1),
            "det_now": start.det_loop,
            "stops": ca.SX.ones(STOPS) * LARGEST,
            "h_least": ca.SX(LARGEST),
        }

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
        steady = float(z[self.layout.slice("steady")][0])
        start, attempt = self.counted_evaluations
        return {
            "steps": accepted,
            "rejected_steps": rejected,
            "least_step": float(seen["h_least"]) if accepted else 0.0,
            "largest_step": float(seen["h_largest"]),
            "step_tolerance": 0.0 if steady else self.tolerance * float(z[self.layout.slice("per_step")][0]),
            "steady_step": steady,
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

    def land(self, z: np.ndarray) -> None:
        """From z (flat) on, end a step at every state that is seen."""
        z[self.layout.slice("lands")] = 1.0

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

    def next_seen(self, z: np.ndarray, dt: float) -> float:
        """Time of the next state after z (n_z,) that is seen [s], dt apart."""
        return float(z[self.layout.slice("t0")][0] + (z[self.layout.slice("n")][0] + 1) * dt)

    def reached(self, z: np.ndarray) -> float:
        """Time at the end of the last accepted step [s]."""
        return float(z[self.layout.slice("t_to")][0])

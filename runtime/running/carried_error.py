"""The error of a run as its motion carries it on: what is wrong early may grow, in a motion that is unstable in itself.

Errors of windows (accuracy.py) move a state beside that of the run, and this neighbour is stepped as the run is. Their
difference, kept so small that the motion is linear in it, is the error of the run over a factor: it grows, turns and
dies out by the tangent of the motion at every step. The neighbour costs as much as the run. So it is followed only from
where the linearised equations let something grow: Re lambda T > GROWS for an eigenvalue lambda and the length T of the
run, or for the rate at which coefficients that change with time may drive a mode (parametric.py). Where coefficients
vary the first need not mean growth, and then nothing but time is lost; that coordinates on their way drive others with
no eigenvalue to the right is not seen.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from runtime.contract.coordinates import independent, loop_part
from runtime.contract.model import Model
from runtime.contract.one_thread import dense_eigenvalues
from runtime.contract.status import Event
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.followed_steps import follow_steps, follows_steps
from runtime.running.made_error import error_made, may_be_judged, may_be_longer
from runtime.running.neighbour import placed_beside, seen_state, small_change, stepped_to, take_given
from runtime.running.parametric import first_order, pumped
from runtime.running.segment import Segment
from runtime.schemes.switching.broken_steps import BrokenSteps

MARKS = 25  # at most: where growth is looked for, and the neighbour is looked at
SHORTEST = 4  # steps of a window
SHARE = 0.05  # of the run's steps lie in windows; stepping them three times costs 15 %
EVERY = 5  # of the marks: where it is asked what changes with time may do
GROWS = 2.0  # Re lambda T from which the neighbour is followed
OFFSET = 1e-5  # of the neighbour, of a radian or the size of the mechanism; more than rounding, less than what bends
TOLERANCES = 10.0  # at least, where the neighbour's steps are others
ROUNDING = 2.0**-52
FLAGS = ("following", "ended", "arrived", "longer", "missed", "held", "lost")
LOST = 1e6  # times the size of the mechanism: such an error is followed no further


class CarriedError:
    """The error di, dv (n_i,) of q_i and its rates where it was looked at last, see `neighbour.small_change`.

    steps: of the run. z: the neighbour, scale times the error away from the run; None where there is none. made
    (3, n_i): sums of |di|, |dv| and |dv| t of what was added. course: rows of the time, the magnitudes of the error of
    all coordinates, and what they would be if every part went on with its own velocity and none grew [m, rad].
    ended: it is followed no further; arrived: it was until the end of the run, and all of its errors are in it; lost:
    it became so large that it tells nothing more but that; missed: of some steps they could not be told. longer: steps
    are judged by longer ones, see `made_error`.
    """

    def __init__(self, steps: int) -> None:
        parts = max(1, min(MARKS, steps // SHORTEST))
        self.marks = [steps * k // parts for k in range(parts + 1)]
        self.z: np.ndarray | None = None
        self.start: np.ndarray | None = None  # of the run: from where the steps are judged that come next
        self.di, self.dv, self.scale = np.zeros(0), np.zeros(0), 0.0
        self.made = np.zeros((3, 0))
        self.following, self.ended, self.arrived, self.longer, self.missed, self.held, self.lost = (False,) * 7
        self.course: list[list[float]] = []
        self._held: tuple[np.ndarray, ...] = ()  # state and error of all coordinates and rates
        self._broken: tuple[BrokenSteps, BrokenSteps] | None = None  # of the run, and of the neighbour

    def until_next(self, step: int) -> int | None:
        """Steps to where it looks next."""
        mark = next((mark for mark in self.marks if mark > step), None)
        if mark is None or self.ended:
            return None
        return self._begin(mark) - step if self.following and self._begin(mark) > step else mark - step

    def _begin(self, mark: int) -> int:
        """The step from which the steps until a mark are judged, for all since the mark before."""
        before = self.marks[self.marks.index(mark) - 1]
        return before if self.longer else mark - min(mark - before, max(SHORTEST, round(SHARE * (mark - before))))

    def add(self, di: np.ndarray, dv: np.ndarray) -> None:
        """Errors (n_i,) of a window before anything was seen to grow: their magnitudes add up."""
        if not self.following and not self.ended:
            known = np.array([self.di, self.dv]) if len(self.di) else np.zeros((2, len(di)))
            self.di, self.dv = np.copysign(np.abs(known) + np.abs([di, dv]), [di, dv])

    def look(self, segment: Segment, z: np.ndarray) -> None:
        """At a state of the run (whole, flat)."""
        step = segment.step_of(z)
        marked = step in self.marks
        if self.ended or not (marked or self.following):
            return
        if self.start is not None and segment.step_of(self.start) == step:
            return  # the run went back to where a batch of steps began
        if not self.following:
            self.following = _grows(segment, z, closely=self.marks.index(step) % EVERY == 0)
            if not self.following:
                self.start = z.copy() if step == 0 else self.start
                return
            self.longer = may_be_longer(segment)
            if self.start is not None and self.longer:
                self.di = self.dv = np.zeros(0)  # all steps until now are judged at once
            else:
                self.start = None
        if marked and self.start is not None and step < self.marks[-1]:
            marked = may_be_judged(segment, self.start, z)  # else at a later mark
        if marked:
            self._arrive(segment, z)
        if marked or self.held:
            self._place(segment, z)
        if self.z is not None and self.start is None and (self.longer or self._begins(step)):
            self.start = z.copy()

    def _begins(self, step: int) -> bool:
        return any(self._begin(mark) == step for mark in self.marks[1:] if mark > step)

    def _arrive(self, segment: Segment, z: np.ndarray) -> None:
        """At a mark: see what has become of the error, and add what was made since the mark before."""
        state, step = seen_state(segment, stepped_to(segment, z)), segment.step_of(z)
        t, dq = segment.plan.time(step), np.zeros(len(state[0]))
        if self.z is not None:
            dq = self._measure(segment, state, seen_state(segment, stepped_to(segment, self.z)))[0]
        made = None if self.start is None else error_made(segment, self.start, z, state, self.longer)
        new = np.zeros((2, len(segment.model.q_i)))
        if made is not None and self.start is not None:
            before = self.marks[self.marks.index(step) - 1]
            more = 1.0 if self.longer else (step - before) / (step - segment.step_of(self.start))
            dq, new = dq + more * made[0], more * np.array(small_change(segment.model, *state, *made))
        self._add(t, np.array(independent(segment.model, *state)), new)
        self.missed |= made is None and (self.z is not None or self.start is not None or len(self.course) > 0)
        self.start = None
        if step > 0:
            self.arrived = step == self.marks[-1] and not self.missed
            self.course.append([t, *np.abs(dq).tolist(), *self._unamplified(segment.model, t).tolist()])

    def _place(self, segment: Segment, z: np.ndarray) -> None:
        """Put the neighbour where the error says, over the scale."""
        size = self._size(segment)
        self.lost = not size < LOST
        self.ended, self.z, self.held = self.lost, None, False
        if self.ended or size == 0:
            return
        offset = OFFSET
        if not follows_steps(segment, z):
            offset = max(OFFSET, TOLERANCES * segment.plan.scheme.tolerance)  # type: ignore[attr-defined]
        self.scale = offset / size
        self.z = placed_beside(segment, z, self.scale * self.di, self.scale * self.dv)
        self.ended = self.z is None

    def follow(self, segment: Segment, before: np.ndarray, z: np.ndarray) -> None:
        """The run went by plain steps from one state (whole, flat) to another: so does the neighbour."""
        steps = segment.step_of(z) - segment.step_of(before)
        if steps < 0:  # back to where a position was singular
            self.drop()
        if self.z is None:
            return
        take_given(segment, before, self.z)
        if segment.plan.scheme.adaptive and follows_steps(segment, z):
            self.z = follow_steps(segment, before, z, self.z)
            if self.z is None:
                self.drop()
                return
        elif segment.broken is None:
            told = dict(segment.given)
            segment.run(self.z, steps)
            segment.given = told  # impulses that the run tells are its own
        else:
            self._own_broken(segment, segment.broken).run(self.z, segment.ready, segment.c, steps)
        if segment.step_of(self.z) != segment.step_of(z) or not np.isfinite(self.z).all():
            self.drop()

    def drop(self) -> None:
        """Without a neighbour until the next mark, where the error is what it was at the last one."""
        self.z, self.start = None, None

    def hold(self, segment: Segment, z: np.ndarray) -> None:
        """From this state on (whole, flat) the run goes another way than by plain steps: a neighbour is placed anew."""
        if self.z is None:
            self.start = None
            return
        state = seen_state(segment, z)
        assert self.z is not None
        dq, dq_dot = self._measure(segment, state, seen_state(segment, self.z))
        if self.start is not None and self.longer and segment.step_of(z) > segment.step_of(self.start) + 1:
            made = error_made(segment, self.start, z, state, self.longer)
            if made is not None:
                dq, dq_dot = dq + made[0], dq_dot + made[1]
                new = np.array(small_change(segment.model, *state, *made))
                self._add(segment.plan.time(segment.step_of(z)), np.array(independent(segment.model, *state)), new)
        self._held, self.z, self.start, self.held = (*state, dq, dq_dot), None, None, True

    def pass_on(self, segment: Segment, event: Event | None) -> None:
        """The run goes on with this segment, after what has happened since it was held."""
        if event is not None and event.kind == "singular_position":
            self.ended = True  # what the passage makes of errors is not known
        if len(self._held) and self.held:
            self.di, self.dv = small_change(segment.model, *self._held)
            self.made = np.array([np.abs(self.di), 0.0 * self.di, 0.0 * self.di])

    def _own_broken(self, segment: Segment, of_run: BrokenSteps) -> BrokenSteps:
        """What breaks the neighbour's steps: impulses that the run tells are its own."""
        if self._broken is None or self._broken[0] is not of_run:
            own = BrokenSteps(segment.stepper, segment.plan.t0, segment.plan.grid.dt_L, segment.switches)
            self._broken = of_run, own
        return self._broken[1]

    def _measure(
        self, segment: Segment, here: tuple[np.ndarray, np.ndarray], there: tuple[np.ndarray, np.ndarray]
    ) -> tuple[np.ndarray, np.ndarray]:
        """The error (n,) of all coordinates and rates, of which di and dv are taken; here, there: the run's and the
        neighbour's.
        """
        dq, dq_dot = ((b - a) / self.scale for a, b in zip(here, there, strict=True))
        if np.isfinite([*dq, *dq_dot]).all():
            self.di, self.dv = small_change(segment.model, *here, dq, dq_dot)
        else:
            self.z = None
        return dq, dq_dot

    def _add(self, t: float, state: np.ndarray, new: np.ndarray) -> None:
        """New errors (2, n_i) at a state (2, n_i), rounding at least."""
        least = ROUNDING * np.abs(state)
        new = np.where(np.abs(new) < least, least, new)
        if len(self.di):
            self.di, self.dv = self.di + new[0], self.dv + new[1]
        else:
            self.di, self.dv = new
        made = np.abs([new[0], new[1], new[1] * t])
        self.made = self.made + made if self.made.size else made + np.abs([self.di, self.dv, self.dv * t])

    def _unamplified(self, model: Model, t: float) -> np.ndarray:
        """(n,) of all coordinates, by `made`; zero for dependent ones."""
        at, found, sums = model.places, np.zeros(len(model.coordinates)), self.made
        gone = sums[0] + sums[1] * t - sums[2]
        found[at.columns] = gone[at.plain]
        for turns, e in zip(at.turns, at.parameters, strict=True):
            found[e] = np.linalg.norm(gone[turns[turns < at.n_i]]) / 2
        return found

    def _size(self, segment: Segment) -> float:
        """Of the error, in radians and sizes of the mechanism; rates by what they come to until the next mark."""
        if not len(self.di):
            return 0.0
        units = {entry.name: entry.unit for entry in segment.model.description.coordinates}
        unit = [segment.monitor.subject.length if units.get(name) == "m" else 1.0 for name in segment.model.q_i]
        until = segment.plan.grid.dt_L * segment.plan.steps / MARKS
        return float((np.maximum(np.abs(self.di), np.abs(self.dv) * until) / unit).max())

    @property
    def states(self) -> dict[str, np.ndarray]:
        """The arrays that a checkpoint keeps of it."""
        found = {"neighbour": self.z, "judged": self.start}
        return {name: z for name, z in found.items() if z is not None}

    def memory(self) -> dict[str, list[float]]:
        """In plain numbers."""
        flags = [float(getattr(self, name)) for name in FLAGS]
        numbers = {"di": self.di, "dv": self.dv, "made": self.made, "course": np.array(self.course)}
        width = [float(len(self.course[0]) if self.course else 0)]
        return {
            "flags": [self.scale, *flags],
            "width": width,
            **{name: one.ravel().tolist() for name, one in numbers.items()},
        }

    def resume(self, memory: Mapping[str, Sequence[float]], states: Mapping[str, np.ndarray]) -> None:
        """From `memory` and `states`."""
        self.scale, *flags = memory["flags"]
        for name, flag in zip(FLAGS, flags, strict=False):  # checkpoints of before lack the last
            setattr(self, name, bool(flag))
        self.z, self.start = states.get("neighbour"), states.get("judged")
        self.di, self.dv = np.array(memory["di"]), np.array(memory["dv"])
        self.made, row = np.array(memory["made"]).reshape(3, -1), int(memory["width"][0])
        self.course = np.array(memory["course"]).reshape(-1, row).tolist() if row else []


def _grows(segment: Segment, z: np.ndarray, closely: bool) -> bool:
    """Does something grow in the equations linearised here, or can that not be told? closely: by what changes, too."""
    model, plan = segment.model, segment.plan
    if not ModeSolver.possible(model):
        return True
    q, q_dot = seen_state(segment, z)
    state = State(plan.time(segment.step_of(z)), *independent(model, q, q_dot), loop_part(model, q))
    solver, span = ModeSolver(model, segment.with_inputs(z)), plan.t_end - plan.t0
    try:
        here = first_order(*solver.slopes(state, moving=True))
        rate = float(dense_eigenvalues(here).real.max(initial=0.0))
        if closely and rate * span <= GROWS:
            rate += pumped(solver, state, here, plan.t0, span)
        return rate * span > GROWS
    except np.linalg.LinAlgError:
        return False

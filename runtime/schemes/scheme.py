"""What every time-stepping scheme offers: a step as a program of pure stages z -> z, a start, an observation.

The constants that stages read are the model's c followed by the steps h of the groups [s]. So the step size is data:
a program is built and compiled once, and serves every step size.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from copy import copy
from dataclasses import dataclass
from enum import Enum
from functools import cached_property
from typing import Self

import casadi as ca
import numpy as np

from runtime.contract.coordinates import charts_in, sides_in
from runtime.contract.model import EmittedModel
from runtime.contract.status import StatusName
from runtime.contract.tape import arithmetic, shared
from runtime.engine.kept_programs import kept_function, key_of
from runtime.engine.program import LONG_STAGE_NODES, Call, Fields, Layout, Program, make_stage
from runtime.engine.rows import Direct
from runtime.schemes.charts import Charts
from runtime.schemes.options import ClosureOptions, Grid, Options, SchemeError
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations, loop_blocks
from runtime.schemes.step_limit import StepLimit

LARGEST_NUMBER = 1e300  # more than any number of a motion
SIDES = ("side", "side_before")  # of jumps by the motion: of the step that begins here, and of the one that led here
OBSERVED = ("t", "q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot")
Step = Callable[[np.ndarray], None]  # one application of the program to z (whole, flat), in place
Body = Callable[[Fields, StageEquations], Mapping[str, ca.SX]]


class Scheme(ABC):
    """A scheme on one model and grid. Subclasses name the fields of z that they add to the common ones.

    Common fields: t0, n (major steps done), x (q_i reached), loop (guess of the loop unknowns), closure_error (largest
    C before the last Newton step), iterations and failures of iterative updates; det_low and det_high, the smallest
    and the largest determinant of each loop block since whoever runs the scheme reset them; inputs, the numbers that
    they are made of, where there are any; chart, the unit quaternions from which turns in x count.
    """

    order: int = 2
    damps: bool = False  # do its steps damp vibrations that they do not resolve?
    passes_transients: bool = False  # do they pass by what dies out, or lets go, within the first of them?
    adaptive: bool = False  # are its steps as long as a tolerance asks for, and dt the time between states to be seen?
    if_not_converged: str = "Give a larger eps, or (printed) common_update = direct."
    # what a state of other q_i goes on with: these fields, and of those the entries of the q_i that both have
    carried: tuple[str, ...] = ("closure_error", "iterations", "failures")
    carried_by_coordinate: tuple[str, ...] = ()
    starts_from_last: bool = False  # do iterations begin with the last step's values, and its rate of convergence?

    def __init__(self, model: EmittedModel, grid: Grid, options: Options) -> None:
        self.model = model
        self._take_steps(grid)
        self._derived: dict[str, ca.Function] = {}
        self.called: dict[str, Direct] = {}  # by `direct`
        self.options = options.checked(len(grid.groups))
        blocks = loop_blocks(model)
        common = {
            "t0": account(1),
            "n": account(1),
            "x": state(len(model.q_i)),
            "loop": state(len(model.loop_unknowns)),
            "closure_error": account(1),
            "iterations": account(1),
            "failures": account(1),
            "det_low": account(blocks),
            "det_high": account(blocks),
        }
        if model.signals.size:
            common["inputs"] = given(model.signals.size)
        self.charts = Charts(model)
        if self.charts.size:
            common["chart"] = state(self.charts.size)
        self._fields = {**common, **self.fields()}
        self.layout = Layout({name: one.size for name, one in self._fields.items()})
        self.c_size = model.c_size + len(grid.h)

    # ---- what a scheme says ---------------------------------------------------------------------------------

    @abstractmethod
    def program(self) -> Program:
        """One major step."""

    @abstractmethod
    def evaluations(self) -> tuple[int, int]:
        """(full evaluations of M_hat and Q_hat, partial ones) in a major step, sweeps not counted."""

    # What a one-step scheme on z = (q_i, q_i_dot, loop unknowns) need not say. The loop unknowns are integrated like
    # coordinates; that only gives the guess from which each evaluation closes them.

    def fields(self) -> dict[str, StateField]:
        """The fields of z beyond the common ones: v, q_i_dot."""
        return {"v": state(len(self.model.q_i))}

    def rates(self, z: np.ndarray) -> np.ndarray:
        """q_i_dot as z holds it, without evaluating anything."""
        return np.asarray(z[self.layout.slice("v")])

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """Fields of z at the start; the others are zero."""
        motion = equations.close_well(q_i, loop, t0)
        return {"v": q_i_dot, "loop": equations.loop_part(motion.q_d)}

    def observed(self, z: Fields, equations: StageEquations) -> tuple[ClosedConfiguration, ca.SX, ca.SX]:
        """(configuration, q_i_dot, q_i_ddot) between two major steps."""
        motion = equations.close_well(z["x"], z["loop"], self.now(z, equations))
        return motion, z["v"], equations.accelerations(motion, z["v"])

    # ---- what they share ------------------------------------------------------------------------------------

    @classmethod
    def limited(cls) -> bool:
        """Is the step limited by how fast the mechanism oscillates or decays?"""
        return cls.step_limit is not Scheme.step_limit

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """What limits the step of the fastest group for w'' = A_q w + A_v w'; None: nothing. See step_limit.py."""
        return None

    @property
    def iteration_limit(self) -> int | None:
        """The most iterations of a step; None where nothing is iterated until it converges."""
        return None

    def of_one_length(self, what: str) -> None:
        """Refuse steps that a tolerance makes, for `what` needs them all alike. Raises SchemeError."""
        if self.adaptive:
            raise SchemeError("tolerance", f"{what} needs a fixed step", "leave the tolerance out and give dt")

    def hit_min_step(self, z: np.ndarray) -> bool:
        """Was a step rejected that is as short as steps may be? Never one of a given length."""
        return False

    def steps_made(self, z: np.ndarray) -> int:
        """Steps that led to z (at least the scheme's part, flat)."""
        return int(z[1])

    def add_to_rates(self, z: np.ndarray, change: np.ndarray) -> None:
        """Add to q_i_dot (n_i,) of z (flat) in place, of a scheme that is no multistep method."""
        z[self.layout.slice("v")] += change

    def add_to_rates_at_end(self, z: np.ndarray, change: np.ndarray) -> None:
        """The same at the end of its last step, which is what is seen of steps of a given length."""
        self.add_to_rates(z, change)

    def taken(self, z: np.ndarray) -> dict[str, float | int | str]:
        """What the steps that led to z say of themselves, where their lengths follow from their errors."""
        return {}

    def land(self, z: np.ndarray) -> None:
        """From z on every state that is seen is the end of a step, as it always is of steps of a given length."""
        return None

    def reached(self, z: np.ndarray) -> float:
        """Time at the end of the last step of z (at least the scheme's part, flat) [s]."""
        return float(z[0] + z[1] * self.grid.dt_L)

    def next_sample(self, z: np.ndarray, dt: float) -> float:
        """Time of the next state after z (at least the scheme's part, flat) that is seen [s], dt apart."""
        return float(z[0] + (z[1] + 1) * dt)

    def end_at_event(self, z: np.ndarray, constants: np.ndarray, run: Step) -> list[int]:
        """End the last step of z (whole, flat) in place where an event that is flagged there happens; which ones do.

        Steps of a given length end where they end: none. constants: as stages read them.
        """
        return []

    def show_end(self, z: np.ndarray, dt: float, run: Step) -> None:
        """Let z (whole, flat) be seen at the end of its last step, as it always is of steps of a given length."""
        return None

    def next_step(self, z: np.ndarray) -> float:
        """How far a step from z (at least the scheme's part, flat) goes at most [s]."""
        return float(self.grid.dt_L)

    def at_end(self, z: np.ndarray) -> np.ndarray:
        """A copy of z (n_z,) that is seen at the end of its last step."""
        return z.copy()

    @property
    def multistep(self) -> bool:
        """A multistep method: do steps read, or steer iterations by, more than positions, rates and charts?"""
        return not set(self.memory) <= {"x", "v", "loop", "chart"} or self.starts_from_last

    @property
    def memory(self) -> list[str]:
        """The fields of z through which one major step acts on the next, in the order of z."""
        return self.lasting(Lasting.STATE, Lasting.HISTORY)

    @property
    def history(self) -> list[str]:
        """Of these, what each coordinate of q_i remembers of earlier steps."""
        return self.lasting(Lasting.HISTORY)

    def keep_account(self, sizes: Mapping[str, int], read: Mapping[str, int] | None = None) -> None:
        """Further fields of z that no step reads; read: that steps read, and leave. Before anything of it is built."""
        self._fields = {**self._fields, **{name: account(size) for name, size in sizes.items()}}
        self._fields |= {name: given(size) for name, size in (read or {}).items()}
        self.layout = Layout({name: one.size for name, one in self._fields.items()})

    @property
    def bookkeeping(self) -> list[str]:
        """The fields of z that do not act on any value of the motion."""
        return self.lasting(Lasting.CONTROL, Lasting.ACCOUNT)

    @cached_property
    def alike(self) -> tuple[str, ...]:
        """Kind, groups, ratios, options and fields of z: what its programs depend on, whatever its steps."""
        parts = self.grid.groups, self.grid.m, self.options, self.layout.sizes
        return (type(self).__qualname__, *map(repr, parts))

    def lasting(self, *kinds: Lasting) -> list[str]:
        """The fields of z that matter so long, in the order of z."""
        return [name for name, one in self._fields.items() if one.lasting in kinds]

    def on(self, grid: Grid) -> Self:
        """With the steps of a grid with the same groups and ratios; what is built of either serves both."""
        found = copy(self)
        found._take_steps(grid)
        return found

    def with_step(self, dt: float) -> Self:
        """The same scheme with a major step of dt [s]."""
        return self.on(self.grid.scaled(dt))

    def _take_steps(self, grid: Grid) -> None:
        self.grid, self._steps = grid, np.array(grid.h)
        self.step_sizes = np.empty(len(self.model.q_i))
        for own, h in zip(grid.groups, grid.h if len(grid.groups) > 1 else grid.h[:1], strict=True):
            self.step_sizes[own] = h

    def constants(self, c: np.ndarray, dt: float | None = None) -> np.ndarray:
        """The model's c and the steps, as the stages read them; dt: another major step than the grid's [s]."""
        steps = self._steps
        return np.concatenate([c, steps if dt is None else steps * (dt / steps[0])])

    def derived(self, name: str, build: Callable[[], ca.Function]) -> ca.Function:
        """A Function made of the scheme's, built once."""
        if name not in self._derived:
            self._derived[name] = kept_function(self.key(name), build)
        return self._derived[name]

    def key(self, name: str) -> str:
        """Of what is kept on disk of it, "" where nothing is."""
        return key_of(self.model, *self.alike, name)

    @property
    def starter(self) -> ca.Function:
        """start(), built once."""
        return self.derived("starter", self.start)

    @property
    def observer(self) -> ca.Function:
        """observe(), built once."""
        return self.derived("observer", self.observe)

    def closed(self, z: Fields, *motions: ClosedConfiguration) -> dict[str, ca.SX]:
        """The fields that keep account of closures."""
        error, low, high = z["closure_error"], z["det_low"], z["det_high"]
        for motion in motions:
            error = ca.fmax(error, motion.C_loop)
            if low.numel():
                low, high = ca.fmin(low, motion.det_loop), ca.fmax(high, motion.det_loop)
        return {"closure_error": error, "det_low": low, "det_high": high}

    def constants_at(self, z: Fields, c: ca.SX) -> ca.SX:
        """c (of the model or of the stages) with the sides of jumps, the charts and the inputs as z holds them."""
        if "inputs" not in z and "chart" not in z and "side" not in z:
            return c
        sides, charts, end = sides_in(self.model), charts_in(self.model), self.model.c_size
        side, chart, inputs = z.get("side", c[sides]), z.get("chart", c[charts]), z.get("inputs", c[charts.stop : end])
        return ca.vertcat(c[: sides.start], side, chart, inputs, c[end:])

    def arrived(self, equations: StageEquations, x: ca.SX, loop: ca.SX, t: ca.SX) -> ClosedConfiguration:
        """Where a step has led: closed where charts take turns from the loop unknowns as they are."""
        if self.charts.all_independent:
            return ClosedConfiguration(x, ca.SX(0, 1), t, ca.SX(0), ca.SX(0, 1))
        assert isinstance(self.options, ClosureOptions)
        return equations.close(x, loop, t, self.options.closure_iterations)

    def rebased(
        self,
        z: Fields,
        at: ClosedConfiguration,
        loop: ca.SX,
        members: list[int] | None = None,
        since: tuple[str, ...] = (),
        loops_since: tuple[str, ...] = (),
        x: ca.SX | None = None,
    ) -> dict[str, ca.SX]:
        """x and loop, and the fields that put the turns (of the members) into their charts, from where they count on.

        at: the configuration; loop: what is known of the loop unknowns there, or elsewhere from the same charts.
        since, loops_since: fields of earlier positions and loop unknowns, which move with them. x: q_i reached, where
        coordinates other than the members are not at the configuration.
        """
        x, charts = at.q_i if x is None else x, self.charts
        if not charts.size:
            return {"x": x, "loop": loop}
        zeroed = charts.zeroed(x, members)
        out = {"x": zeroed, "loop": charts.loops_from(loop, at.q_d, members)}
        out["chart"] = charts.turned(z["chart"], at.q_i, at.q_d, members)
        out |= {name: z[name] + zeroed - x for name in since}
        return out | {name: charts.loops_from(z[name], at.q_d, members) for name in loops_since}

    def equations(self, c: ca.SX, z: Fields | None = None) -> StageEquations:
        """The model's equations on a symbolic vector of constants, with the inputs that z holds."""
        return StageEquations(self.model, c if z is None else self.constants_at(z, c))

    def stage(self, name: str, body: Body) -> Call:
        """A stage from a function of the fields of z to those it changes."""
        return make_stage(name, self.layout, self.c_size, lambda z, c: body(z, self.equations(c, z)))

    def group_of(self, k: int) -> int:
        """Group of the independent coordinate k."""
        return next(g for g, group in enumerate(self.grid.groups) if k in group)

    def now(self, z: Fields, equations: StageEquations) -> ca.SX:
        """Time at the end of the last major step."""
        return z["t0"] + z["n"] * equations.h[0]

    def alive(self, z: Fields) -> ca.SX:
        """1 where all of x is finite: whose x is lost has nothing to iterate for. Tested once a step."""
        return ca.sum1(ca.fabs(z["x"])) < LARGEST_NUMBER

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z."""
        t0, c = ca.SX.sym("t0"), ca.SX.sym("c", self.c_size)
        q_i, q_i_dot = ca.SX.sym("q_i", len(self.model.q_i)), ca.SX.sym("q_i_dot", len(self.model.q_i))
        loop = ca.SX.sym("loop", len(self.model.loop_unknowns))
        equations = self.equations(c)
        if self.charts.size:  # begin at theta = 0 of charts where the bodies are
            q_d = equations.close_well(q_i, loop, t0).q_d if not self.charts.all_independent else ca.SX(0, 1)
            chart, guess = self.charts.turned(c[charts_in(self.model)], q_i, q_d), self.charts.loops_from(loop, q_d)
            c_there = ca.vertcat(c[: charts_in(self.model).start], chart, c[charts_in(self.model).stop :])
            q_i_there, equations = self.charts.zeroed(q_i), self.equations(c_there)
        else:
            q_i_there, guess = q_i, loop
        fields = self.started(t0, q_i_there, q_i_dot, guess, equations)
        if self.model.signals.size:
            fields = {**fields, "inputs": equations.c[self.model.c_size - self.model.signals.size :]}
        if "chart" in self.layout.sizes:
            fields = {**fields, "chart": equations.c[charts_in(self.model)]}
        fields = {**fields, **{n: equations.c[sides_in(self.model)] for n in SIDES if n in self.layout.sizes}}
        zeros = {name: ca.SX.zeros(size) for name, size in self.layout.sizes.items()}
        z = self.layout.pack({**zeros, "t0": t0, "x": q_i_there, **fields})
        return ca.Function("start", [t0, q_i, q_i_dot, loop, c], [z])

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""
        z, c = ca.SX.sym("z", self.layout.size), ca.SX.sym("c", self.c_size)
        fields = self.layout.unpack(z)
        if "side" in fields:  # what a step led to is seen with what it held
            fields["side"] = fields["side_before"]
        equations = self.equations(c, fields)
        motion, v, a = self.observed(fields, equations)
        v_d = equations.rates(motion, v)
        a_d = ca.SX(0, 1)
        if self.model.q_d:
            a_d = equations.dependent_accelerations(motion, v, a)
        q_i, q_d = self.charts.zeroed(motion.q_i), self.charts.zeroed_dependent(motion.q_d)
        outputs = [motion.t, q_i, q_d, v, v_d, a, a_d]
        if (
            ca.n_nodes(ca.vertcat(*outputs)) <= LONG_STAGE_NODES
        ):  # sharing takes a time that grows faster than the length
            outputs = shared(outputs)
        return ca.Function("observe", [z, c], [ca.densify(output) for output in outputs], ["z", "c"], list(OBSERVED))


# The fields of z, the state of a scheme as one vector, by how long they matter; symgen/notation/fields.py has each.


class Lasting(Enum):
    """How long a field of z matters; called with a size it is such a field."""

    STEP = "within a major step: it passes values between its stages"
    STATE = "one major step acts on the next through it"
    HISTORY = "state, too: what each coordinate of q_i remembers of earlier steps"
    CONTROL = "steers an iteration; what it converges to does not depend on it"
    GIVEN = "from outside: steps read it and leave it as it is"
    ACCOUNT = "for whoever runs the scheme; no step reads it"

    def __call__(self, size: int) -> StateField:
        return StateField(size, self)


work, state, history, control, given, account = Lasting


@dataclass(frozen=True)
class StateField:
    """A field of z: how many numbers, and how long they matter."""

    size: int
    lasting: Lasting


# What a state z says by itself about how its steps went: one answer for runs, studies and references.


def verdict(scheme: Scheme, z: np.ndarray) -> StatusName | None:
    """Why steps that led to z (at least the scheme's part, flat) are worth nothing; None if z does not say so.

    `iteration_failed` where an update did not converge, whatever it left behind; `not_finite` for NaN or infinity.
    """
    if z[scheme.layout.slice("failures")][0] > 0:
        return "iteration_failed"
    return None if np.isfinite(z).all() else "not_finite"


# What an iteration can reach in double precision.

SUM_ROUNDING = 4e-16  # relative, of the sums of a step


# Functions of a scheme's states, called on arrays between steps.


def direct(scheme: Scheme, name: str, build: Callable[[], ca.Function]) -> Direct:
    """A Function made of the scheme's, built once; all its outputs as one vector."""
    if name not in scheme.called:
        scheme.called[name] = Direct(scheme.derived(name, build))
    return scheme.called[name]


# The price of one evaluation of a scheme's equations.


def evaluation_operations(scheme: Scheme) -> int:
    """Arithmetic operations of a full evaluation: closure, velocities, M_hat, Q_hat and the solution for q_i_ddot."""
    return arithmetic(scheme.derived("evaluation", lambda: _evaluation(scheme)))


def _evaluation(scheme: Scheme) -> ca.Function:
    model = scheme.model
    q_i, v, t = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("v", len(model.q_i)), ca.SX.sym("t")
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", scheme.c_size)
    equations = scheme.equations(c)
    assert isinstance(scheme.options, ClosureOptions)  # who takes sub-steps closes in each of them
    a = equations.accelerations(equations.close(q_i, loop, t, scheme.options.closure_iterations), v)
    return ca.Function("evaluation", [q_i, v, t, loop, c], shared([a]))

"""What every time-stepping scheme offers: a step as a program of pure stages z -> z, a start, an observation.

The constants that stages read are the model's c followed by the steps h of the groups [s]. So the step size is data:
a program is built and compiled once, and serves every step size.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.choose import arithmetic
from runtime.engine.program import Call, Fields, Layout, Program, make_stage
from runtime.schemes.grid import Grid
from runtime.schemes.kernels import Motion, StepKernels, loop_blocks
from runtime.schemes.options import Options
from runtime.schemes.step_limit import StepLimit, limit_between_the_axes

OBSERVED = ("t", "q_i", "q_d", "q_i_dot", "q_d_dot", "q_i_ddot", "q_d_ddot")
Body = Callable[[Fields, StepKernels], Mapping[str, ca.SX]]


class Scheme(ABC):
    """A scheme on one model and grid. Subclasses name the fields of z that they add to COMMON.

    Common fields: t0, n (major steps done), x (q_i reached), loop (guess of the loop unknowns), closure_error (largest
    C before the last Newton step), iterations and failures of iterative updates; det_low and det_high, the smallest
    and the largest determinant of each loop block since whoever runs the scheme reset them.
    """

    reach: float | None = None  # the largest stable h w of an undamped mode w on the finest step; None: no limit
    decay_reach: float | None = None  # the largest stable h d of a pure decay d on the finest step; None: no limit
    order: int = 2
    memory: tuple[str, ...] = ()  # the fields of z through which one major step acts on the next, bookkeeping aside
    history: tuple[str, ...] = ()  # of these, what each coordinate of q_i remembers of earlier steps
    closes: bool = True  # are all coordinates found from q_i by the closure, in every evaluation?

    def __init__(self, model: Model, grid: Grid, options: Options) -> None:
        self.model, self.grid = model, grid
        self.options = options.checked(len(grid.groups))
        blocks = loop_blocks(model) if self.closes else 0
        common = {
            "t0": 1,
            "n": 1,
            "x": len(model.q_i),
            "loop": len(model.loop_unknowns),
            "closure_error": 1,
            "iterations": 1,
            "failures": 1,
            "det_low": blocks,
            "det_high": blocks,
        }
        self.layout = Layout({**common, **self.fields()})
        self.c_size = model.c_size + len(grid.h)
        self.step_sizes = np.array([grid.h[self.group_of(k)] for k in range(len(model.q_i))])

    # ---- what a scheme says ---------------------------------------------------------------------------------

    @abstractmethod
    def fields(self) -> dict[str, int]:
        """Sizes of the fields of z beyond the common ones."""

    @abstractmethod
    def program(self) -> Program:
        """One major step."""

    @abstractmethod
    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z."""

    @abstractmethod
    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps."""

    @abstractmethod
    def rates(self, z: np.ndarray) -> np.ndarray:
        """q_i_dot as z holds it, without evaluating anything."""

    @abstractmethod
    def evaluations(self) -> tuple[int, int]:
        """(full evaluations of M_hat and Q_hat, partial ones) in a major step, sweeps not counted."""

    # ---- what they share ------------------------------------------------------------------------------------

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """What limits the step of the fastest group for w'' = A_q w + A_v w'; None: nothing. See step_limit.py."""
        if self.reach is None or self.decay_reach is None:
            return None
        return limit_between_the_axes(A_q, A_v, self.reach, self.decay_reach)

    def constants(self, c: np.ndarray, dt: float | None = None) -> np.ndarray:
        """The model's c and the steps, as the stages read them; dt: another major step than the grid's [s]."""
        steps = np.array(self.grid.h)
        return np.concatenate([c, steps if dt is None else steps * (dt / steps[0])])

    @cached_property
    def starter(self) -> ca.Function:
        """start(), built once."""
        return self.start()

    @cached_property
    def observer(self) -> ca.Function:
        """observe(), built once."""
        return self.observe()

    def closed(self, z: Fields, *motions: Motion) -> dict[str, ca.SX]:
        """The fields that keep account of closures."""
        error, low, high = z["closure_error"], z["det_low"], z["det_high"]
        for motion in motions:
            error = ca.fmax(error, motion.C_loop)
            if low.numel():
                low, high = ca.fmin(low, motion.det_loop), ca.fmax(high, motion.det_loop)
        return {"closure_error": error, "det_low": low, "det_high": high}

    def kernels(self, c: ca.SX) -> StepKernels:
        """The model's kernels on a symbolic vector of constants."""
        return StepKernels(self.model, c)

    def stage(self, name: str, body: Body) -> Call:
        """A stage from a function of the fields of z to those it changes."""
        return make_stage(name, self.layout, self.c_size, lambda z, c: body(z, self.kernels(c)))

    def group_of(self, k: int) -> int:
        """Group of the independent coordinate k."""
        return next(g for g, group in enumerate(self.grid.groups) if k in group)

    def now(self, z: Fields, kernels: StepKernels) -> ca.SX:
        """Time at the end of the last major step."""
        return z["t0"] + z["n"] * kernels.h[0]

    def zeros(self) -> dict[str, ca.SX]:
        """All fields of z, zero."""
        return {name: ca.SX.zeros(size) for name, size in self.layout.sizes.items()}

    def start_function(self, body: Callable[..., Mapping[str, ca.SX]]) -> ca.Function:
        """start() from a body (t0, q_i, q_i_dot, loop, kernels) -> fields of z; the others are zero."""
        t0, c = ca.SX.sym("t0"), ca.SX.sym("c", self.c_size)
        q_i, q_i_dot = ca.SX.sym("q_i", len(self.model.q_i)), ca.SX.sym("q_i_dot", len(self.model.q_i))
        loop = ca.SX.sym("loop", len(self.model.loop_unknowns))
        fields = body(t0, q_i, q_i_dot, loop, self.kernels(c))
        z = self.layout.pack({**self.zeros(), "t0": t0, "x": q_i, **fields})
        return ca.Function("start", [t0, q_i, q_i_dot, loop, c], [z])

    def observe_function(self, body: Callable[..., tuple[Motion, ca.SX, ca.SX]]) -> ca.Function:
        """observe() from a body (fields, kernels) -> (motion, q_i_dot, q_i_ddot)."""
        z, c = ca.SX.sym("z", self.layout.size), ca.SX.sym("c", self.c_size)
        kernels = self.kernels(c)
        motion, v, a = body(self.layout.unpack(z), kernels)
        v_d = kernels.rates(motion, v)
        a_d = ca.SX(0, 1)
        if self.model.q_d:
            a_d = kernels.call(
                "accelerations", q_i=motion.q_i, q_d=motion.q_d, q_i_dot=v, q_d_dot=v_d, q_i_ddot=a, t=motion.t
            )["q_d_ddot"]
        outputs = ca.cse([motion.t, motion.q_i, motion.q_d, v, v_d, a, a_d])
        return ca.Function("observe", [z, c], [ca.densify(output) for output in outputs], ["z", "c"], list(OBSERVED))


def evaluation_operations(scheme: Scheme) -> int:
    """Arithmetic operations of a full evaluation: closure, velocities, M_hat, Q_hat and the solution for q_i_ddot."""
    model = scheme.model
    q_i, v, t = ca.SX.sym("q_i", len(model.q_i)), ca.SX.sym("v", len(model.q_i)), ca.SX.sym("t")
    loop, c = ca.SX.sym("loop", len(model.loop_unknowns)), ca.SX.sym("c", scheme.c_size)
    kernels = scheme.kernels(c)
    a = kernels.accelerations(kernels.close(q_i, loop, t, scheme.options.closure_iterations), v)
    return arithmetic(ca.Function("evaluation", [q_i, v, t, loop, c], ca.cse([a])))

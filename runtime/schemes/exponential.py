"""An exponential integrator, exponential Rosenbrock steps: one Jacobian a major step, two or three evaluations.

For y' = F(y) linearised at the start of the step, N(y) = F(y) - A y and D_i = N(Y_i) - N(y_n), at nodes c_i:

    Y_i     = y_n + c_i h phi_1(c_i h A) F(y_n) + what D_1 ... D_(i-1) add
    y_{n+1} = y_n +     h phi_1(    h A) F(y_n) + what all D_i add

D is 0 at the start with its first derivative; with the polynomial of least degree through the D_i, 0 and 0 it adds

    order 4 (exprb42, Luan and Ostermann 2014), c = 3/4:          (32/9) h phi_3(h A) D_1
    order 5 (exprb53s3, the same), c = 1/2 and 9/10:              h (18 phi_3 - 60 phi_4) D_1
                                                                + h (-250/81 phi_3 + 500/27 phi_4) D_2,
      in the second stage   h (729/125 phi_3(9/10 h A) + 27/25 phi_3(1/2 h A)) D_1,

the last term, the echo, being there for stiff modes. Every line is the motion of the linear system of
linear_propagation.py with a force G2 tau^2 / 2 + G3 tau^3 / 6, run by m sub-steps. Forces that depend on time enter by
G1 = d(Q_hat - M_hat a)/dt. So the linear part of the motion, stiff modes included, is free of the major step's error,
and what limits the major step is the nonlinearity of the mechanism. The order conditions, stiff ones too, are Luan and
Ostermann's.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from math import ceil, factorial

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.engine.program import Fields, Program, Repeat, Sequence
from runtime.schemes.linear_propagation import StoredSystem, factors_of, polynomial, propagate
from runtime.schemes.options import MOST_UNROLLED, ClosureOptions, Grid, SchemeError, one_of, whole_number
from runtime.schemes.partial_fractions import poles
from runtime.schemes.scheme import Scheme, StateField, work
from runtime.schemes.stage_equations import LONG_TREE, StageEquations

NODES = {4: (0.75,), 5: (0.5, 0.9)}
ECHO = 1.08  # the echo is the motion from rest, up to the first node, under this many times G2
SUB_STEPS_OF_ONE_STAGE = 2  # sub-steps up to which a step is one stage
Body = Callable[[Fields, StageEquations], Mapping[str, ca.SX]]


@dataclass(frozen=True)
class ExponentialOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation, from a guess that is right to h^3.

    propagation: the sub-steps of the linear system: `rational` (of order 6, stable for any stiffness) or `decaying` (of
        order 5; decays that are much faster than a sub-step die out in it).
    order: 4 by two evaluations, or 5 by three, with one or two sub-steps.
    """

    propagation: str = one_of("rational", "decaying")

    closure_iterations: int = whole_number(1, most=MOST_UNROLLED)

    order: int = whole_number(4, least=4, most=5)

    @property
    def most_sub_steps(self) -> int:
        """Two for order 5."""
        return SUB_STEPS_OF_ONE_STAGE if self.order == 5 else super().most_sub_steps


class Exponential(Scheme):
    """exprb42 or exprb53s3 with m sub-steps; inner stages end inside of sub-steps, on the same factors.

    grid.h is (major step, sub-step). Fields: w = q_i - x and u = q_i_dot since the start of the major step, tau the
    time since then, G0, G1, ... the forces, and the linear system.

    References
    ----------
    V. T. Luan and A. Ostermann, Exponential Rosenbrock methods of order five - construction, analysis and numerical
    comparisons, Journal of Computational and Applied Mathematics 255, 2014, 417-431: exprb42, exprb53s3.
    """

    options: ExponentialOptions
    passes_transients = True

    def __init__(self, model: EmittedModel, grid: Grid, options: ExponentialOptions) -> None:
        options, m = options.checked(len(grid.groups)), grid.m[0]
        self.order, self.nodes = options.order, NODES[options.order]
        self.forces = ("G0", "G1", "G2", "G3")[: self.order - 1]
        if m > options.most_sub_steps:
            raise SchemeError(f"order 5 takes one or two sub-steps, not m = [{m}]; take m = 1 or 2, or order 4")
        self.decaying = options.propagation == "decaying"
        self.shifts = tuple(one.r for one in poles(decaying=self.decaying))
        self.stored = StoredSystem(model, self.shifts)
        self.at_once = m <= SUB_STEPS_OF_ONE_STAGE and len(model.q_i) <= LONG_TREE
        super().__init__(model, grid, options)

    def fields(self) -> dict[str, StateField]:
        """What stages pass on, with how the loop unknowns move: rates, and second rates (loop_bend)."""
        if self.at_once:
            return super().fields()
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        sizes = {"w": n, "u": n, "tau": 1, **dict.fromkeys(self.forces, n), **self.stored.sizes()}
        own = {name: work(size) for name, size in {**sizes, "loop_dot": loops, "loop_bend": loops}.items()}
        return {**super().fields(), **own}

    def program(self) -> Program:
        """Linearise; run to each node and evaluate there; run to the end. Short steps of few coordinates at once."""
        if self.at_once:
            return self.stage("exponential", self._at_once)
        stages = ((self.stage(name, body), count) for name, body, count in self._bodies())
        return Sequence(tuple(stage if count == 1 else Repeat(stage, count) for stage, count in stages))

    def _bodies(self) -> list[tuple[str, Body, int]]:
        """(name, body, how often) of what makes a step."""
        m, bodies = self.grid.m[0], [("linearise", self._linearise, 1)]
        for k, node in enumerate(self.nodes):
            whole, name = int(node * m), "part_of_sub_step"
            if whole:
                bodies.append(("sub_step", self._sub_step, whole))
            if node * m > whole:
                bodies.append((f"{name}_{k + 1}", partial(self._sub_step, part=node * m - whole, echoing=k > 0), 1))
            bodies.append((f"correct_{k + 1}", partial(self._correct, k=k), 1))
        return [*bodies, ("sub_step", self._sub_step, m), ("finish", self._finish, 1)]

    def _at_once(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """All of it: what is zero at the start of the step costs nothing, and nothing is passed on through z."""
        found: dict[str, ca.SX] = {}
        for _, body, count in self._bodies():
            for _ in range(count):
                found |= body({**z, **found}, equations)
        return {name: value for name, value in found.items() if name in z}

    def evaluations(self) -> tuple[int, int]:
        """Two or three, and the sub-steps."""
        m = self.grid.m[0]
        return 1 + len(self.nodes), sum(ceil(node * m) for node in self.nodes) + m

    def _sub_step(
        self, z: Fields, equations: StageEquations, part: float = 1.0, echoing: bool = False
    ) -> Mapping[str, ca.SX]:
        """A part of a sub-step of w and u on the linear system."""
        echo = (self.nodes[0] * self.grid.m[0], ECHO * z["G2"]) if echoing else None
        system, factors, h = self.stored.unpack(z), self.stored.unpack_factors(z), equations.h[1]
        G = [z[name] for name in self.forces]
        w, u = propagate(
            system, factors, z["w"], z["u"], G, z["tau"], h, part, self.decaying, echo, self.charts.independent
        )
        return {"w": w, "u": u, "tau": z["tau"] + part * h}

    def _linearise(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        v, zero = z["v"], ca.SX.zeros(len(self.model.q_i))
        motion = equations.close(z["x"], z["loop"], self.now(z, equations), self.options.closure_iterations)
        found = equations.linearised(motion, v)
        return {
            **self.stored.pack(found),
            **self.stored.pack_factors(factors_of(found, equations.h[1], self.shifts)),
            **{"w": zero, "u": v, "tau": ca.SX(0), **dict.fromkeys(self.forces, zero)},
            "G0": found.Q_hat - ca.mtimes(found.J_v, v),
            "G1": equations.force_rate(motion, v, found.a),
            "loop": equations.loop_part(motion.q_d),
            "loop_dot": equations.loop_part(equations.rates(motion, v)),
            "loop_bend": equations.loop_accelerations(motion, v, found.a),
            **self.closed(z, motion),
        }

    def _correct(self, z: Fields, equations: StageEquations, k: int) -> Mapping[str, ca.SX]:
        """D at node k, and forces and loop unknowns on their way through it; the motion begins anew."""
        h, system, tau = equations.h[0], self.stored.unpack(z), self.nodes[k] * equations.h[0]
        ahead, guess = (polynomial([z["loop"], z["loop_dot"], *bend], tau) for bend in ([], [z["loop_bend"]]))
        t = self.now(z, equations) + tau
        motion = equations.close(z["x"] + z["w"], guess, t, self.options.closure_iterations)
        a = equations.chart_accelerations(motion, z["u"])
        linear = z["G0"] + tau * z["G1"] + ca.mtimes(system.J_q, z["w"]) + ca.mtimes(system.J_v, z["u"])
        forces = self._through(z["G2"], ca.mtimes(system.M_hat, a) - linear, h, k)
        bends = self._through(z["loop_bend"], equations.loop_part(motion.q_d) - ahead, h, k)
        out = {
            **dict(zip(self.forces[2:], forces, strict=False)),
            "loop_bend": bends[0],
            "w": ca.SX.zeros(len(self.model.q_i)),
            "u": z["v"],
            "tau": ca.SX(0),
            **self.closed(z, motion),
        }
        if k == len(self.nodes) - 1:
            out["loop"] = polynomial([z["loop"], z["loop_dot"], *bends], h)
        return out

    def _through(self, before: ca.SX, value: ca.SX, h: ca.SX, k: int) -> list[ca.SX]:
        """G2, G3 of the polynomial that takes a value at node k, and its earlier one where `before` tau^2 / 2 did."""
        nodes, first = self.nodes[: k + 1], self.nodes[0] * h
        values = [first * first / 2 * before, value][-len(nodes) :]
        powers = range(2, 2 + len(nodes))
        weights = np.linalg.inv([[node**power / factorial(power) for power in powers] for node in nodes])
        return [
            sum((float(w) * one for w, one in zip(row, values, strict=True)), ca.SX(0)) / h**power
            for row, power in zip(weights, powers, strict=True)
        ]

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        t = self.now(z, equations) + equations.h[0]
        end = self.arrived(equations, z["x"] + z["w"], z["loop"], t)
        return {**self.rebased(z, end, z["loop"]), "v": equations.velocities(end, z["u"]), "n": z["n"] + 1}

"""Radau IIA with three stages: order 5, L-stable, one Jacobian a step. A baseline, compiled like the rest.

Stiffly accurate: its last stage is the end of the step.
A collocation method: Hairer and Wanner's RADAU5 with a fixed step, on the second-order
equations q'' = M_hat^-1 Q_hat = a(q, q', t).
Unknown are the accelerations K_i of the stages,

    q_i = q + c_i h v + h^2 sum_j (A^2)_ij K_j,    v_i = v + h sum_j A_ij K_j,    R_i = M (a_i - K_i) = 0.

The iteration is simplified Newton: its matrix and M are those at the start of the step. (Residuals Q_hat_i -
M_hat_i K_i would save a factorisation a stage, but Newton would converge more slowly by an order of h.) The
eigenvalues r of A^-1, one real and a complex pair, split the matrix: with A^-1 = T diag(r) T^-1, each iteration is
one real and one complex solve of

    (r^2 M - r h J_v - h^2 J_q) k = r^2 (T^-1 R),    K <- K + T k.

The first guess is the last step's polynomial of K, extrapolated. Iterations stop, as in RADAU5, when
eta = theta / (1 - theta) times the last correction is small enough, theta being the ratio of the last two corrections;
after the first correction of a step, eta is that of the step before to the power 0.8. Behind a jump of the forces both
begin as at the start of a run: the rate of a short step before it would let the first correction pass for the last.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.engine.program import Fields, Program, Sequence, Until
from runtime.schemes.linear_propagation import StoredSystem, factors_of, solve_shifted
from runtime.schemes.options import MOST_ITERATIONS, Grid, SingleClosureOptions, tolerances, whole_number
from runtime.schemes.scheme import SUM_ROUNDING, Scheme, StateField, control, work
from runtime.schemes.stage_equations import StageEquations

S = np.sqrt(6.0)
NODES = np.array([(4 - S) / 10, (4 + S) / 10, 1.0])
A = np.array(
    [
        [(88 - 7 * S) / 360, (296 - 169 * S) / 1800, (-2 + 3 * S) / 225],
        [(296 + 169 * S) / 1800, (88 + 7 * S) / 360, (-2 - 3 * S) / 225],
        [(16 - S) / 36, (16 + S) / 36, 1 / 9],
    ]
)
STAGES = 3
USUAL_ITERATIONS = 3
SLOWEST = 0.99  # theta at most
TINY = 1e-300


def lagrange(nodes: np.ndarray, at: np.ndarray) -> np.ndarray:
    """Weights (len(at), len(nodes)) that take values at nodes to those of their polynomial elsewhere."""
    return np.array(
        [
            [
                np.prod([(x - other) / (node - other) for j, other in enumerate(nodes) if j != k])
                for k, node in enumerate(nodes)
            ]
            for x in at
        ]
    )


def split() -> tuple[tuple[complex, ...], np.ndarray, np.ndarray]:
    """(r, T, T^-1) of A^-1, with one of the complex pair: column k of T and row k of T^-1 belong to r[k]."""
    values, vectors = np.linalg.eig(np.linalg.inv(A))
    inverse = np.linalg.inv(vectors)
    kept = sorted((k for k in range(STAGES) if values[k].imag > -1e-9), key=lambda k: abs(values[k].imag))
    r = tuple(complex(values[k]) if abs(values[k].imag) > 1e-9 else complex(values[k].real) for k in kept)
    return r, vectors[:, kept], inverse[kept]


SHIFTS, T, T_INVERSE = split()
AHEAD = lagrange(NODES, 1 + NODES)  # from the stages of a step to those of the next
LOOP_AHEAD = lagrange(np.array([0.0, *NODES]), 1 + NODES)  # loop unknowns: also from the start of the step


@dataclass(frozen=True)
class RadauOptions(SingleClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    eps: relative error of the stage accelerations at which the iteration stops. max_iterations: the most in a step.
    """

    eps: tuple[float, ...] = tolerances(1e-10)
    max_iterations: int = whole_number(50, most=MOST_ITERATIONS)


class Radau(Scheme):
    """Field K: the stage accelerations; loop_stages: the stages' loop unknowns; loop_last: those at the last start.

    References
    ----------
    E. Hairer and G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., Springer, 1996, IV.8.
    """

    order = 5
    damps = True
    starts_from_last = True
    if_not_converged = (
        "Newton's matrix is that of the start of a step, and a load bends within it, as friction that reverses does: "
        "give the joint `friction`, which sticks exactly, or take exponential with propagation = decaying, which "
        "iterates nothing. A tolerance finds how short its steps have to be; ten times shorter may not do."
    )

    options: RadauOptions

    def __init__(self, model: EmittedModel, grid: Grid, options: RadauOptions) -> None:
        self.stored = StoredSystem(model, SHIFTS, ("M",))
        super().__init__(model, grid, options)

    def fields(self) -> dict[str, StateField]:
        """See above, and the factors. What the iteration starts from does not act on the step it converges to."""
        n, loops = len(self.model.q_i), len(self.model.loop_unknowns)
        values = {"K": STAGES * n, "loop_stages": STAGES * loops, "loop_last": loops, **self.stored.sizes()}
        steering = ("unconverged", "stage_error", "eta", "correction")
        own = {name: work(size) for name, size in values.items()} | {name: control(1) for name in steering}
        return {**super().fields(), **own}

    @property
    def iteration_limit(self) -> int:
        """The option max_iterations."""
        return self.options.max_iterations

    def program(self) -> Program:
        """Linearise and extrapolate, iterate, finish."""
        iteration = self.stage("radau_iterate", self._iterate)
        return Sequence(
            (
                self.stage("radau_begin", self._begin),
                Until(iteration, self.layout.slice("unconverged").start, self.options.max_iterations, USUAL_ITERATIONS),
                self.stage("radau_finish", self._finish),
            )
        )

    def evaluations(self) -> tuple[int, int]:
        """Of the usual number of iterations; a run counts its own."""
        return 1 + STAGES * USUAL_ITERATIONS, 0

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """As if the last step had had constant acceleration."""
        fields = dict(super().started(t0, q_i, q_i_dot, loop, equations))
        motion = equations.close(q_i, fields["loop"], t0, 1)
        a, rate = equations.accelerations(motion, q_i_dot), equations.loop_part(equations.rates(motion, q_i_dot))
        at = [fields["loop"] + (float(node) - 1) * equations.h[0] * rate for node in NODES]
        return {
            **fields,
            "eta": ca.SX(1),
            "K": ca.repmat(a, STAGES, 1),
            "loop_stages": ca.vertcat(*at),
            "loop_last": fields["loop"] - equations.h[0] * rate,
        }

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, K, loops = equations.h[0], self._columns(z["K"]), self._columns(z["loop_stages"])
        motion = equations.close(z["x"], z["loop"], self.now(z, equations), 1)
        found = equations.linearised(motion, z["v"])
        return {
            **self.stored.pack(found),
            **self.stored.pack_factors(factors_of(found, h, SHIFTS)),
            "K": _stacked(AHEAD, K),
            "loop_stages": _stacked(LOOP_AHEAD, [z["loop_last"], *loops]),
            "loop_last": equations.loop_part(motion.q_d),
            "unconverged": self.alive(z),
            "correction": ca.SX(0),
            "iterations": z["iterations"] + 1,
        }

    def _columns(self, stacked: ca.SX) -> list[ca.SX]:
        return ca.vertsplit(stacked, stacked.numel() // STAGES) if stacked.numel() else [stacked] * STAGES

    def _iterate(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, t = equations.h[0], self.now(z, equations)
        K, loops = self._columns(z["K"]), self._columns(z["loop_stages"])
        M = self.stored.unpack_matrices(z)["M"]
        residuals, motions = [], []
        for k, (q, v) in enumerate(zip(self._positions(z, K, h), self._velocities(z, K, h), strict=True)):
            motion = equations.close(q, loops[k], t + float(NODES[k]) * h, self.options.closure_iterations)
            residuals.append(ca.mtimes(M, equations.chart_accelerations(motion, v) - K[k]))
            motions.append(motion)
        change = self._solved(self.stored.unpack_factors(z), residuals)
        new = [old + delta for old, delta in zip(K, change, strict=True)]
        loops = [equations.loop_part(motion.q_d) for motion in motions]
        account = self.closed(z, *motions)  # the error counts when the iteration has converged
        stage_error = ca.fmax(ca.fmax(motions[0].C_loop, motions[1].C_loop), motions[2].C_loop)
        return {
            **account,
            "closure_error": z["closure_error"],
            "K": ca.vertcat(*new),
            "loop_stages": ca.vertcat(*loops),
            "stage_error": stage_error,
            **self._progress(z, new, change, h),
            "iterations": z["iterations"] + STAGES,
        }

    def _positions(self, z: Fields, K: list[ca.SX], h: ca.SX) -> list[ca.SX]:
        return [z["x"] + h * (float(c) * z["v"] + h * _combined(row, K)) for c, row in zip(NODES, A @ A, strict=True)]

    def _velocities(self, z: Fields, K: list[ca.SX], h: ca.SX) -> list[ca.SX]:
        return [z["v"] + h * _combined(row, K) for row in A]

    def _solved(self, factors: tuple[Any, ...], residuals: list[ca.SX]) -> list[ca.SX]:
        """T k with (r^2 M - r h J_v - h^2 J_q) k = r^2 T^-1 R."""
        change = [ca.SX(0)] * STAGES
        for k, r in enumerate(SHIFTS):
            weights = r * r * T_INVERSE[k]
            side = _combined(weights.real, residuals)
            re, im = solve_shifted(factors[k], r, side, _combined(weights.imag, residuals) if r.imag else None)
            for i in range(STAGES):
                back = T[i, k] * (2 if r.imag else 1)  # the conjugate adds the same real part
                change[i] = change[i] + float(back.real) * re - (float(back.imag) * im if r.imag else 0)
        return change

    def _progress(self, z: Fields, new: list[ca.SX], change: list[ca.SX], h: ca.SX) -> dict[str, ca.SX]:
        """unconverged: by how much K may be wrong more than eps allows, and more than positions can show."""
        size = ca.norm_inf(ca.vertcat(*change))
        theta = ca.fmin(size / ca.fmax(z["correction"], TINY), SLOWEST)
        eta = ca.if_else(z["correction"] > 0, theta / (1 - theta), z["eta"] ** 0.8)
        allowed = self.options.eps[0] * ca.norm_inf(ca.vertcat(*new))
        allowed = (
            allowed + SUM_ROUNDING * (ca.norm_inf(z["x"]) / h + ca.norm_inf(z["v"])) / h
        )  # what rounding hides of K
        return {"unconverged": eta * size - allowed, "eta": ca.fmax(eta, SUM_ROUNDING), "correction": size}

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        K, h = self._columns(z["K"]), equations.h[0]
        x, loop = self._positions(z, K, h)[-1], self._columns(z["loop_stages"])[-1]
        end = self.arrived(equations, x, loop, self.now(z, equations) + h)
        return {
            **self.rebased(z, end, loop),
            "v": equations.velocities(end, self._velocities(z, K, h)[-1]),
            "n": z["n"] + 1,
            "failures": z["failures"] + (z["unconverged"] > 0),
            "closure_error": ca.fmax(z["closure_error"], z["stage_error"]),
        }


def _combined(weights: np.ndarray, values: list[ca.SX]) -> ca.SX:
    return sum((float(weight) * value for weight, value in zip(weights, values, strict=True)), ca.SX(0))


def _stacked(matrix: np.ndarray, values: list[ca.SX]) -> ca.SX:
    return ca.vertcat(*(_combined(row, values) for row in matrix))

"""Generalized-alpha and HHT on the index-3 equations in all coordinates: baselines that do not condense. Order 2.

    M q'' + C_q^T lam = Q*(q, q', t),    C(q, t) = 0    at the end of every step, with Newmark's formulas

    q = q_n + h v_n + h^2 ((1/2 - beta) a_n + beta a),    v = v_n + h ((1 - gamma) a_n + gamma a),
    (1 - alpha_m) a + alpha_m a_n = (1 - alpha_f) q'' + alpha_f q''_n,

the form of Arnold and Bruls (2007), in which a is an algorithmic acceleration. Unknown are q'' and lam; Newton uses
the exact tangent of both equations, C being scaled by d q''/ dq = (1 - alpha_m) / (h^2 beta (1 - alpha_f)), so that
the matrix is [M + O(h), C_q^T; C_q, 0]. The coordinates are eliminated first, the last one first, then the
multipliers: no pivoting is needed as long as M is positive definite. Where it is not, as for a body whose inertia is
all about a joint, C_q^T C = 0 is added to the first line.
"""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.coordinates import independent_rates
from runtime.contract.model import Model, refuse_elements
from runtime.engine.program import Fields, Program, Sequence, Until
from runtime.schemes.options import MOST_ITERATIONS, Grid, Options, share, tolerances, whole_number
from runtime.schemes.scheme import OBSERVED, Scheme, StateField, account, control, state, unseen_acceleration, work
from runtime.schemes.sparse_lu import Number, factor, solve
from runtime.schemes.stage_equations import StageEquations

USUAL_ITERATIONS = 2
SINGULAR = 1e-10  # smallest over largest pivot of M beyond which M counts as singular


class AlphaMethod(Scheme):
    """Fields: q, q_dot, q_ddot, a_alpha (algorithmic), lam, all at the end of the last step; q_ddot_old during a step.

    In the code below v, w and a are q_dot, q_ddot and a_alpha.
    """

    options: AlphaMethodOptions
    closes = False
    damps = True

    def __init__(self, model: Model, grid: Grid, options: AlphaMethodOptions) -> None:
        refuse_elements(model, "needs q_i: this scheme steps all coordinates", "take rk4, radau or dopri5")
        self.penalised = _singular_mass(model)
        self.rows = [int(row) for row in model.kept_rows]
        super().__init__(model, grid, options)

    @abstractmethod
    def weights(self) -> Weights:
        """What the options say."""

    def fields(self) -> dict[str, StateField]:
        """See above; x is kept for whoever runs the scheme."""
        n = len(self.model.coordinates)
        return {
            "x": account(len(self.model.q_i)),
            "loop": account(len(self.model.loop_unknowns)),
            "q": state(n),
            "q_dot": state(n),
            "q_ddot": state(n),
            "q_ddot_old": work(n),
            "a_alpha": state(n),
            "lam": work(len(self.rows)),
            "unconverged": control(1),
        }

    @property
    def iteration_limit(self) -> int:
        """The option max_iterations."""
        return self.options.max_iterations

    def program(self) -> Program:
        """Guess the last accelerations and multipliers, iterate, move."""
        iteration = self.stage("alpha_iterate", self._iterate)
        flag = self.layout.slice("unconverged").start
        return Sequence(
            (
                self.stage("alpha_begin", self._begin),
                Until(iteration, flag, self.options.max_iterations, USUAL_ITERATIONS),
                self.stage("alpha_finish", self._finish),
            )
        )

    def evaluations(self) -> tuple[int, int]:
        """Of the usual number of iterations; a run counts its own."""
        return USUAL_ITERATIONS, 0

    def rates(self, z: np.ndarray) -> np.ndarray:
        """The velocities of q_i."""
        q, q_dot = (z[self.layout.slice(name)] for name in ("q", "q_dot"))
        return independent_rates(self.model, q, q_dot)

    # ---- a step ---------------------------------------------------------------------------------------------

    def _begin(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        return {"q_ddot_old": z["q_ddot"], "unconverged": self.alive(z)}

    def _moved(self, z: Fields, w: ca.SX, h: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
        """(q, v, a) at the end of the step for q'' = w there."""
        k = self.weights()
        a = ((1 - k.alpha_f) * w + k.alpha_f * z["q_ddot_old"] - k.alpha_m * z["a_alpha"]) / (1 - k.alpha_m)
        q = z["q"] + h * (z["q_dot"] + h * ((0.5 - k.beta) * z["a_alpha"] + k.beta * a))
        return q, z["q_dot"] + h * ((1 - k.gamma) * z["a_alpha"] + k.gamma * a), a

    def _iterate(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        h, n, k = equations.h[0], len(self.model.coordinates), self.weights()
        moved_q, moved_v, _ = self._moved(z, z["q_ddot"], h)
        t = self.now(z, equations) + h
        per_w = k.beta * (1 - k.alpha_f) / (1 - k.alpha_m) * h**2  # dq / dw
        v_per_w = k.gamma * (1 - k.alpha_f) / (1 - k.alpha_m) * h
        q, v = ca.SX.sym("q_end", n), ca.SX.sym("v_end", n)
        M, C_q, residual, C = self._equations(equations, q, v, t, z["q_ddot"], z["lam"])
        S = M + per_w * ca.jacobian(residual, q) + v_per_w * ca.jacobian(residual, v)
        S, C_q, residual, C = ca.substitute([S, C_q, residual, C], [q, v], [moved_q, moved_v])
        delta, lam = self._saddle(M=S, C_q=C_q, force=-residual, gamma=-C / per_w)
        w = z["q_ddot"] + delta
        allowed = self.options.eps[0] * ca.norm_inf(w)
        allowed = allowed + unseen_acceleration(z["q"], z["q_dot"], h)
        return {
            "q_ddot": w,
            "lam": z["lam"] + lam,
            "unconverged": ca.norm_inf(delta) - allowed,
            "iterations": z["iterations"] + 1,
        }

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        q, v, a = self._moved(z, z["q_ddot"], equations.h[0])
        return {
            "q": q,
            "q_dot": v,
            "a_alpha": a,
            "x": self.charts.seen_in(self.model, q)[0],
            "n": z["n"] + 1,
            "failures": z["failures"] + (z["unconverged"] > 0),
        }

    # ---- the equations --------------------------------------------------------------------------------------

    def _equations(
        self, equations: StageEquations, q: ca.SX, v: ca.SX, t: ca.SX, w: ca.SX, lam: ca.SX
    ) -> tuple[ca.SX, ca.SX, ca.SX, ca.SX]:
        """(M, C_q, M w + C_q^T lam - Q*, C)."""
        found = equations.call("augmented", q=q, q_dot=v, t=t)
        residual = ca.mtimes(found["M"], w) - found["Q_star"]
        if not self.model.constraints:
            return found["M"], ca.SX(0, q.numel()), residual, ca.SX(0, 1)
        C_q, C = found["C_q"][self.rows, :], equations.call("constraints", q=q, q_dot=v, t=t)["C"][self.rows]
        return found["M"], C_q, residual + ca.mtimes(C_q.T, lam), C

    def _saddle(self, M: ca.SX, C_q: ca.SX, force: ca.SX, gamma: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(x, y) of M x + C_q^T y = force, C_q x = gamma; unknowns in the order (y, x), the last eliminated first."""
        rows, n = C_q.shape
        if self.penalised:
            scale = ca.trace(M) / n
            M, force = M + scale * ca.mtimes(C_q.T, C_q), force + scale * ca.mtimes(C_q.T, gamma)
        C_q = ca.sparsify(C_q)
        matrix = ca.blockcat([[ca.SX(rows, rows), C_q], [C_q.T, ca.sparsify(M)]])
        found = solve(factor(Number(matrix)), Number(ca.densify(ca.vertcat(gamma, force)))).re
        return found[rows:], found[:rows, :]

    # ---- start-up and observation ---------------------------------------------------------------------------

    def start(self) -> ca.Function:
        """(t0, q_i, q_i_dot, loop unknowns, c) -> z."""
        return self.start_function(self._started)

    def _started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> dict[str, ca.SX]:
        motion = equations.close_well(q_i, loop, t0)
        q = equations.joined(q_i, motion.q_d)
        v = equations.joined(q_i_dot, equations.rates(motion, q_i_dot))
        found = equations.call("augmented", q=q, q_dot=v, t=t0)
        C_q, gamma = ca.SX(0, q.numel()), ca.SX(0, 1)
        if self.model.constraints:
            C_q = found["C_q"][self.rows, :]
            gamma = equations.call("constraints", q=q, q_dot=v, t=t0)["gamma"][self.rows]
        w, lam = self._saddle(M=found["M"], C_q=C_q, force=found["Q_star"], gamma=gamma)
        return {"q": q, "q_dot": v, "q_ddot": w, "a_alpha": w, "lam": lam}

    def observe(self) -> ca.Function:
        """(z, c) -> OBSERVED between two major steps, as the state holds it: q' satisfies C_q q' + C_t = 0 to h^2."""
        z, c = ca.SX.sym("z", self.layout.size), ca.SX.sym("c", self.c_size)
        fields = self.layout.unpack(z)
        equations = self.equations(c, fields)
        q = fields["q"]
        parts: list[ca.SX] = []
        for name in ("q", "q_dot", "q_ddot"):
            parts += self.charts.seen_in(self.model, q, None if name == "q" else fields[name])
        return ca.Function("observe", [z, c], [self.now(fields, equations), *parts], ["z", "c"], list(OBSERVED))


class GeneralizedAlpha(AlphaMethod):
    """Chung and Hulbert's weights for the option rho_inf."""

    options: GeneralizedAlphaOptions

    def weights(self) -> Weights:
        """For the option rho_inf."""
        rho = self.options.rho_inf
        return Weights((2 * rho - 1) / (rho + 1), rho / (rho + 1))


class HilberHughesTaylor(AlphaMethod):
    """The case alpha_m = 0, alpha_f = alpha."""

    options: HilberHughesTaylorOptions

    def weights(self) -> Weights:
        """For the option alpha."""
        return Weights(0.0, self.options.alpha)


def _singular_mass(model: Model) -> bool:
    """Is M of the augmented form singular at the model's own start?"""
    c = model.constants(model.parameter_vector())
    M = np.asarray(model.evaluate("augmented", q=model.initial_q, q_dot=model.initial_q_dot, t=0.0, c=c)["M"])
    scale = 1 / np.sqrt(np.maximum(np.diag(M), 1e-300))
    return bool(np.diag(M).min() <= 0 or np.linalg.eigvalsh(M * np.outer(scale, scale))[0] < SINGULAR)


# Options of generalized-alpha and of the method of Hilber, Hughes and Taylor, and the weights that they lead to.


@dataclass(frozen=True)
class Weights:
    """alpha_m and alpha_f; the others make the method of order 2 with the strongest damping of fast modes."""

    alpha_m: float
    alpha_f: float

    @property
    def gamma(self) -> float:
        """Newmark's gamma."""
        return 0.5 + self.alpha_f - self.alpha_m

    @property
    def beta(self) -> float:
        """Newmark's beta."""
        return (self.gamma + 0.5) ** 2 / 4


@dataclass(frozen=True)
class AlphaMethodOptions(Options):
    """eps: relative correction after which the iteration stops. max_iterations: the most iterations of a step."""

    eps: tuple[float, ...] = tolerances(1e-7)
    max_iterations: int = whole_number(15, most=MOST_ITERATIONS)


@dataclass(frozen=True)
class GeneralizedAlphaOptions(AlphaMethodOptions):
    """eps, max_iterations: see AlphaMethodOptions.

    rho_inf: the amplitude that a step leaves of an infinitely fast mode; 1 is without dissipation.
    """

    rho_inf: float = share(0.9, most=1.0)


@dataclass(frozen=True)
class HilberHughesTaylorOptions(AlphaMethodOptions):
    """eps, max_iterations: see AlphaMethodOptions. alpha: the dissipation; 0 is the trapezoidal rule."""

    alpha: float = share(0.05, most=1 / 3)

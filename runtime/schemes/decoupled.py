"""Inertially decoupled sub-steps: y = q_L + M_LL^-1 M_LS q_S moves with M_LL^-1 Q_L, renewed each major step.

Over a major step H the sub-steps see q_L and q_L' where they will be at the middle, and evaluate the rows of q_S only:

    (M_SS - M_SL N) q_S'' = Q_S - M_SL y'',   N = M_LL^-1 M_LS,   y'' = M_LL^-1 Q_L.

With N and y'' held, q_L'' = y'' - N q_S'' has an integral, so q_L is moved once, exactly:

    q_L' <- q_L' + H y'' - N (change of q_S'),
    q_L  <- q_L + H q_L' + H^2/2 y'' - N (change of q_S - H q_S').

The same motion over half a step, with N and y'' of the last one, predicts the middle; q_S goes there along the secant
of its last step, which is second order for what the step resolves and bounded for what it does not. Q_L must not change
much with q_S inside a major step.

With `slow_accelerations="cubic"` y'' follows its values in the middles of the last four major steps instead, and the
middle is predicted by those of the last three: order 4 in what the slow forces do.

On large trees N and y'' come from one O(N) elimination, and the rows of q_S see the few accelerations that cross to
them and q_L' of the middle: the price of a sub-step does not grow with the mechanism. Elsewhere they see q_L' as it is.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cache

import casadi as ca
import numpy as np
from numpy.polynomial import Polynomial

from runtime.contract.model import Model
from runtime.engine.program import Fields
from runtime.schemes.central_difference import replaced
from runtime.schemes.held_slow import HeldSlow
from runtime.schemes.linear_propagation import polynomial
from runtime.schemes.options import ClosureOptions, Grid, SchemeError, one_of
from runtime.schemes.scheme import StateField, state, work
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.stage_equations import ClosedConfiguration, StageEquations
from runtime.schemes.step_limit import StepLimit, restarted_limit


@dataclass(frozen=True)
class DecoupledOptions(ClosureOptions):
    """closure_iterations: Newton steps on the loop unknowns in each evaluation.

    slow_accelerations: how y'' moves over a major step: `held` at the middle, or `cubic` through its last four values.
    """

    slow_accelerations: str = one_of("cubic", "held")


class Decoupled(HeldSlow):
    """Two groups."""

    options: DecoupledOptions

    def __init__(self, model: Model, grid: Grid, options: DecoupledOptions) -> None:
        if len(grid.groups) > 2:
            raise SchemeError(f"decoupled works on two groups, not {len(grid.groups)}; use coupled")
        super().__init__(model, grid, options)

    def step_limit(self, A_q: np.ndarray, A_v: np.ndarray) -> StepLimit | None:
        """Of sub-steps with predicted velocities that begin anew every major step."""
        return restarted_limit(A_q, A_v, self.grid.m[0]) if self.slow else super().step_limit(A_q, A_v)

    @property
    def past(self) -> tuple[str, ...]:
        """Fields of y_ddot in the middles of the steps before the last, newest first; none where it is held."""
        return ("y_last", "y_before") if self.options.slow_accelerations == "cubic" else ()

    @property
    def by_tree(self) -> bool:
        """Are there kernels for the response of the slow coordinates along a tree? They are of the model's groups."""
        return bool(self.slow) and self.model.has("slow_response")

    def further_fields(self) -> dict[str, StateField]:
        """N column by column, y_ddot, N times what q_S did in the last step: its way beyond H q_S', the change of q_S'.
        What is held and, along a tree, what of it crosses to the rows of q_S.
        """
        if not self.slow:
            return super().further_fields()
        n, loops, slow, fast = len(self.model.q_i), len(self.model.loop_unknowns), len(self.slow), len(self.fast)
        found = {"s": work(1), "a": work(n), "hold_q": work(n), "hold_v": work(n)}
        found |= {"x_last": state(n), "v_last": state(n), "N": work(slow * fast), "y_ddot": state(slow)}
        found |= {"N_moved": state(slow), "N_sped": state(slow)}
        found |= {"loop_old": state(loops), "loop_dot": state(loops)}
        if self.past:
            found |= {**dict.fromkeys(self.past, state(slow)), "y_third": work(slow)}
        if self.by_tree:
            found["crossing"] = work(self.model.kernel("slow_response").numel_out("crossing"))
        return found

    def started(
        self, t0: ca.SX, q_i: ca.SX, q_i_dot: ca.SX, loop: ca.SX, equations: StageEquations
    ) -> Mapping[str, ca.SX]:
        """N and y_ddot at the start."""
        fields = super().started(t0, q_i, q_i_dot, loop, equations)
        if not self.slow:
            return fields
        response = self._response(equations, equations.close(q_i, fields["loop"], t0, 1), q_i_dot)
        L, S, y_ddot = self.slow, self.fast, response["y_ddot"]
        N = ca.reshape(response["N"], len(L), len(S))
        sped = ca.mtimes(N, q_i_dot[S] - fields["v_last"][S])
        found = {"y_ddot": y_ddot, "N_sped": sped, "N_moved": equations.h[0] / 2 * sped}
        if not self.past:
            return {**fields, **found}
        rate = q_i_dot[L] + ca.mtimes(N, q_i_dot[S])  # of y, q_S at rest

        def at(tau: ca.SX, bend: ca.SX) -> ca.SX:
            x = q_i[L] + polynomial([ca.SX.zeros(len(L)), rate, y_ddot, bend], tau)
            v = q_i_dot[L] + polynomial([ca.SX.zeros(len(L)), y_ddot, bend], tau)
            motion = equations.close_well(replaced(q_i, L, x), fields["loop"], t0 + tau)
            return self._response(equations, motion, replaced(q_i_dot, L, v))["y_ddot"]

        before = values_before(at, y_ddot, equations.h[0], 1 + len(self.past))
        return {**fields, **found, **dict(zip(("y_ddot", *self.past), before, strict=True))}

    def _hold(self, z: Fields, equations: StageEquations, level: int) -> Mapping[str, ca.SX]:
        """The state at the middle, N and y_ddot there, and the acceleration that the first sub-step begins with."""
        if not self.slow:
            return super()._hold(z, equations, level)
        L, S, H = self.slow, self.fast, equations.h[0]
        x_rise, v_rise = (z["x"] - z["x_last"])[S] / 2, (z["v"] - z["v_last"])[S] / 2
        known = [z[name] for name in ("y_ddot", *self.past)]  # of the steps before
        x_y, v_y = moved(known, -1, 0.0, H)
        x_L = z["x"][L] + H / 2 * z["v"][L] + x_y - (z["N_moved"] - H * z["N_sped"]) / 2
        v_L = z["v"][L] + v_y - z["N_sped"] / 2
        x, v = (
            replaced(replaced(z[name], L, one), S, z[name][S] + rise)
            for name, one, rise in (("x", x_L, x_rise), ("v", v_L, v_rise))
        )
        past = dict(zip((*self.past, "y_third"), known, strict=True)) if self.past else {}
        guess = z["loop_old"] + 3 / 2 * H * z["loop_dot"]
        motion = equations.close(x, guess, self.now(z, equations) + H / 2, self.options.closure_iterations)
        out = {
            **self._response(equations, motion, v),
            "hold_q": x,
            "hold_v": v,
            "x_last": z["x"],
            "v_last": z["v"],
        } | past
        if equations.loops:
            out |= {"loop_old": z["loop"], "loop": equations.loop_part(motion.q_d), **self.closed(z, motion)}
            out["loop_dot"] = equations.loop_part(equations.rates(motion, v))
        first, _ = self._fast_accelerations({**z, **out}, equations, z["x"][S], z["v"][S], ca.SX(0))
        return {**out, "a": replaced(z["a"], S, first)}

    def _response(self, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> dict[str, ca.SX]:
        """N, y_ddot and, along a tree, crossing."""
        if self.by_tree:
            return {name: ca.vec(value) for name, value in equations.slow_response(motion, v).items()}
        L, S = self.slow, self.fast
        M_hat, Q_hat = equations.condensed(motion, v)
        columns = [solve_symmetric(M_hat[L, L], M_hat[L, k]) for k in S]
        return {"N": ca.vertcat(*columns), "y_ddot": solve_symmetric(M_hat[L, L], Q_hat[L])}

    def _sub_step(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        if not self.slow:
            return super()._sub_step(z, equations)
        S, h, s = self.fast, equations.h[-1], z["s"] + equations.h[-1]
        half = z["v"][S] + h / 2 * z["a"][S]
        whole = replaced(z["v"], S, half)
        x, v = z["x"][S] + h * self.turning(z, equations, whole)[S], half + h / 2 * z["a"][S]
        a, motion = self._fast_accelerations(z, equations, x, v, s)
        out = {"x": x, "v": half + h / 2 * a, "a": a}
        out = {name: replaced(z[name], S, value) for name, value in out.items()} | {"s": s}
        if equations.loops:
            out |= {"loop": equations.loop_part(motion.q_d), **self.closed(z, motion)}
        return out

    def _fast_accelerations(
        self, z: Fields, equations: StageEquations, x: ca.SX, v: ca.SX, s: ca.SX
    ) -> tuple[ca.SX, ClosedConfiguration]:
        """q_S'' at q_S = x and q_S' = v, s after the start of the major step, and the configuration there."""
        S, t, iterations = self.fast, self.now(z, equations) + s, self.options.closure_iterations
        motion = equations.close(replaced(z["hold_q"], S, x), z["loop"], t, iterations)
        return solve_symmetric(*self._rows(z, equations, motion, self._rates(z, v, s))), motion

    def _rates(self, z: Fields, v: ca.SX, s: ca.SX) -> ca.SX:
        """q_i_dot as the rows of q_S see it."""
        L, S = self.slow, self.fast
        if self.by_tree:
            return replaced(z["hold_v"], S, v)
        N = ca.reshape(z["N"], len(L), len(S))
        v_L = z["v_last"][L] + s * z["y_ddot"] - ca.mtimes(N, v - z["v_last"][S])
        return replaced(replaced(z["v_last"], L, v_L), S, v)

    def _rows(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> tuple[ca.SX, ca.SX]:
        """M_SS - M_SL N and Q_S - M_SL y''."""
        L, S = self.slow, self.fast
        if self.by_tree:
            return equations.fast_rows(motion, v, z["crossing"])
        M_hat, Q_hat = equations.condensed(motion, v)
        M_SL = M_hat[S, L]
        N = ca.reshape(z["N"], len(L), len(S))
        return M_hat[S, S] - ca.mtimes(M_SL, N), Q_hat[S] - ca.mtimes(M_SL, z["y_ddot"])

    def accelerations(self, z: Fields, equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
        """Without slow coordinates: of all."""
        return equations.accelerations(motion, v)

    def _finish(self, z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        """q_L at the end of the major step; x_last and v_last hold what q_S began with."""
        L, S, H = self.slow, self.fast, equations.h[0]
        if not L:
            return super()._finish(z, equations)
        N = ca.reshape(z["N"], len(L), len(S))
        names = ("y_ddot", *self.past, "y_third") if self.past else ("y_ddot",)
        x_y, v_y = moved([z[name] for name in names], 0, 0.5, H)
        rise = z["x"][S] - z["x_last"][S] - H * z["v_last"][S]
        moved_by, sped_by = ca.mtimes(N, rise), ca.mtimes(N, z["v"][S] - z["v_last"][S])
        x, v = z["x"][L] + H * z["v"][L] + x_y - moved_by, z["v"][L] + v_y - sped_by
        ends = {"x": replaced(z["x"], L, x), "v": replaced(z["v"], L, v), "N_moved": moved_by, "N_sped": sped_by}
        return {**ends, **super()._finish({**z, **ends}, equations)}


# Slow accelerations y'' over a major step H as the polynomial through their values in the middles of major steps.
#
# In units of H from the middle of a step: the values of this step and of those before it stand at 0, -1, -2, ..., the
# step lasts from -1/2 to 1/2. From its start to a time e
#
#     y' <- y' + H sum_k v_k y''_k,   y <- y + (e + 1/2) H y' + H^2 sum_k x_k y''_k,
#
# v_k and x_k the integrals of the Lagrange polynomials L_k and of (e - s) L_k. With one value y'' is held. With four,
# and three to predict the middle, the order is 4: for q'' = -w^2 q a step decays by (w H)^6 / 700, its phase is off by
# (w H)^5 / 51, and it is stable up to w H = 1.22; with y'' held it decays by (w H)^4 / 16.

START = -0.5  # of the step, from its middle
FROM = (0.0, 0.5, 1.0)  # steps after the start from which values before it are extrapolated


def lagrange(nodes: Sequence[float]) -> list[Polynomial]:
    """Polynomials that are 1 at one node and 0 at the others."""
    found = []
    for node in nodes:
        one = Polynomial([1.0])
        for other in nodes:
            if other != node:
                one = one * Polynomial([-other, 1.0]) / (node - other)
        found.append(one)
    return found


@cache
def weights(first: int, count: int, end: float) -> tuple[tuple[float, ...], tuple[float, ...]]:
    """(x_k, v_k) up to `end` for values at first, first - 1, ..."""
    polynomials = lagrange([float(first - k) for k in range(count)])
    rates = [one.integ() for one in polynomials]
    moved = [(Polynomial([end, -1.0]) * one).integ() for one in polynomials]
    return tuple(float(one(end) - one(START)) for one in moved), tuple(float(one(end) - one(START)) for one in rates)


def moved(values: Sequence[ca.SX], first: int, end: float, H: ca.SX) -> tuple[ca.SX, ca.SX]:
    """What values at first, first - 1, ... add to y beside (e + 1/2) H y', and to y', up to e = `end`."""
    by_position, by_rate = weights(first, len(values), end)
    scaled = ((by_position, H * H), (by_rate, H))  # products of H alone are made once a run
    x, v = (sum((w * by * y for w, y in zip(ones, values, strict=True)), ca.SX(0)) for ones, by in scaled)
    return x, v


def values_before(at: Callable[[ca.SX, ca.SX], ca.SX], y_ddot: ca.SX, H: ca.SX, count: int) -> list[ca.SX]:
    """y'' in the middles of `count` steps before the start of a run, by its parabola through the first step.

    at: (tau, third rate of y) -> y'' when y has moved so long. Nothing before the start is asked for: loads may have
    jumped there.
    """
    bend = (at(H / 2, ca.SX.zeros(y_ddot.numel())) - y_ddot) / (H / 2)
    seen = [y_ddot, *(at(share * H, bend) for share in FROM[1:])]
    polynomials = lagrange(FROM)
    return [
        sum((float(one(START - k)) * y for one, y in zip(polynomials, seen, strict=True)), ca.SX(0))
        for k in range(count)
    ]

"""The model's equations inside a stage: its emitted functions called on SX, the closure and velocities around them.

The closure brings each stage to the constraint manifold by Newton's method on the loop unknowns, so that constraints do
not drift and need no stabilisation (Baumgarte).
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined
from runtime.contract.model import EmittedModel
from runtime.schemes.charts import Charts, chart_rate
from runtime.schemes.sparse_lu import Number, factor, solve, solve_general, solve_symmetric

START_CLOSURE_ITERATIONS = 4  # Newton steps on the loop unknowns where a scheme starts or is observed
LONG_TREE = 12  # independent coordinates beyond which M_hat and the Jacobians of a tree are left alone


@dataclass(frozen=True)
class ClosedConfiguration:
    """A configuration with consistent q_d; C_loop is the largest error before the last Newton step, det_loop the
    determinants of the loop blocks there.
    """

    q_i: ca.SX
    q_d: ca.SX
    t: ca.SX
    C_loop: ca.SX
    det_loop: ca.SX


@dataclass(frozen=True)
class LinearSystem:
    """M_hat w'' = forces + J_q w + J_v w'."""

    M_hat: ca.SX
    J_q: ca.SX
    J_v: ca.SX


@dataclass(frozen=True)
class LinearisedEquations(LinearSystem):
    """M_hat dv' = Q_hat - M_hat a + J_q dq + J_v dv about a state with q_i_ddot = a; J_q is d(Q_hat - M_hat a)/dq_i.

    Turns are at theta = 0 of their charts, and dq, dv of them rotation vectors there and their rates.
    """

    Q_hat: ca.SX
    a: ca.SX


class StageEquations:
    """SX evaluations of a model's kernels for the stages of a scheme; h holds the steps of the groups [s]."""

    def __init__(self, model: EmittedModel, c: ca.SX) -> None:
        self.model, self.c, self.h = model, c[: model.c_size], c[model.c_size :]
        self.loops = [model.q_d.index(name) for name in model.loop_unknowns]
        self.charts = Charts(model)

    def call(self, name: str, **arguments: ca.SX) -> dict[str, ca.SX]:
        """Kernel outputs by name; arguments that the kernel does not take are ignored."""
        return self.model.evaluate(name, **arguments, c=self.c)

    def close(self, q_i: ca.SX, loop: ca.SX, t: ca.SX, iterations: int) -> ClosedConfiguration:
        """q_d = f(q_i, t) from a guess of the loop unknowns, by a fixed number of Newton steps."""
        if not self.model.q_d:
            return ClosedConfiguration(q_i, ca.SX(0, 1), t, ca.SX(0), ca.SX(0, 1))
        q_d = ca.SX.zeros(len(self.model.q_d))
        for position, k in enumerate(self.loops):
            q_d[k] = loop[position]
        error, determinants = ca.SX(0), ca.SX(0, 1)
        for _ in range(iterations if self.loops else 1):
            result = self.call("closure", q_i=q_i, q_d=q_d, t=t)
            q_d = result["q_d_next"]
            if self.loops:
                error, determinants = _largest(result["C_loop"]), result["det_loop"]
        return ClosedConfiguration(q_i, q_d, t, error, determinants)

    def close_well(self, q_i: ca.SX, loop: ca.SX, t: ca.SX) -> ClosedConfiguration:
        """The closure to rounding from a rough guess, for starts and observations."""
        return self.close(q_i, loop, t, START_CLOSURE_ITERATIONS)

    def rates(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """q_d_dot (Eq. 36)."""
        if not self.model.q_d:
            return ca.SX(0, 1)
        return self.call("velocities", q_i=motion.q_i, q_d=motion.q_d, q_i_dot=q_i_dot, t=motion.t)["q_d_dot"]

    def loop_accelerations(self, motion: ClosedConfiguration, q_i_dot: ca.SX, q_i_ddot: ca.SX) -> ca.SX:
        """Second rates of the loop unknowns."""
        if not self.loops:
            return ca.SX(0, 1)
        return self.loop_part(
            self.call("accelerations", **self._arguments(motion, q_i_dot), q_i_ddot=q_i_ddot)["q_d_ddot"]
        )

    def _arguments(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> dict[str, ca.SX]:
        return {
            "q_i": motion.q_i,
            "q_d": motion.q_d,
            "q_i_dot": q_i_dot,
            "q_d_dot": self.rates(motion, q_i_dot),
            "t": motion.t,
        }

    def condensed(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(M_hat, Q_hat) of Eq. (38)."""
        result = self.call("condensed", **self._arguments(motion, q_i_dot))
        return result["M_hat"], result["Q_hat"]

    def accelerations(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """q_i_ddot by the shorter of two routes: O(N) elimination along a tree, or a factorisation of M_hat."""
        if self.tree_is_shorter:
            return self.tree_accelerations(motion, q_i_dot)
        return solve_symmetric(*self.condensed(motion, q_i_dot))

    @property
    def tree_is_shorter(self) -> bool:
        """Is there an elimination along a tree, and is it shorter than a factorisation of M_hat?"""
        return tree_is_shorter(self.model)

    def tree_accelerations(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """q_i_ddot of a tree by topology-ordered elimination: O(N) operations, M_hat is not formed."""
        return self.call("forward_dynamics", **self._arguments(motion, q_i_dot))["q_i_ddot"]

    def dependent_accelerations(self, motion: ClosedConfiguration, q_i_dot: ca.SX, q_i_ddot: ca.SX) -> ca.SX:
        """q_d_ddot (Eq. 35)."""
        if not self.model.q_d:
            return ca.SX(0, 1)
        at = self._arguments(motion, q_i_dot)
        return self.call("accelerations", **at, q_i_ddot=q_i_ddot)["q_d_ddot"]

    # ---- turns: rotation vectors in charts, whose rates go with angular velocities ----------------------------
    #
    # Where a closed loop splits an orientation some turns are independent, the others follow: omega_d = B q_i' + b. In
    # a chart theta_i' = (T^-1(theta) omega)_i takes all of omega, so that velocities follow from rates by a small
    # linear system.

    def _at_turns(self, motion: ClosedConfiguration, v: ca.SX, a: ca.SX | None = None) -> tuple[ca.SX, ca.SX, ca.SX]:
        """Positions, velocities and accelerations: of q_i, and of q_d where an orientation is split."""
        if not self.charts.split:
            return motion.q_i, v, ca.SX(0, 1) if a is None else a
        b = ca.SX(0, 1) if a is None else ca.vertcat(a, self.dependent_accelerations(motion, v, a))
        return ca.vertcat(motion.q_i, motion.q_d), ca.vertcat(v, self.rates(motion, v)), b

    def turning(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """Rates of q_i (with those of rotation vectors) of the velocities q_i_dot (with angular velocities)."""
        x, w, _ = self._at_turns(motion, q_i_dot)
        return self.charts.rates(x, w)[: self.charts.n]

    def velocities(self, motion: ClosedConfiguration, rate: ca.SX) -> ca.SX:
        """Velocities (with angular velocities) of rates of q_i (with those of rotation vectors)."""
        found, parts = self.charts.velocities(motion.q_i, rate), self.charts.parts
        if not parts:
            return found
        v, known = ca.SX.sym("v", rate.numel()), ca.SX(found)
        turning = self.turning(motion, v)[parts]
        for k in parts:
            known[k] = 0
        P, turned = ca.substitute([ca.jacobian(turning, v)[:, parts], turning], [v], [known])
        solved = solve_general(P, rate[parts] - turned)
        for position, k in enumerate(parts):
            found[k] = solved[position]
        return found

    def coordinate_accelerations(self, motion: ClosedConfiguration, rate: ca.SX, v: ca.SX, a: ca.SX) -> ca.SX:
        """Second rates of q_i of its rates, its velocities v and accelerations a."""
        x, w, b = self._at_turns(motion, v, a)
        rates = self.charts.rates(x, w) if self.charts.split else rate
        return self.charts.accelerations(x, rates, w, b)[: self.charts.n]

    def chart_accelerations(self, motion: ClosedConfiguration, rate: ca.SX) -> ca.SX:
        """Second rates of q_i at rates of q_i: with rotation vectors and not angular velocities for the turns."""
        if not self.charts.turns:
            return self.accelerations(motion, rate)
        v = self.velocities(motion, rate)
        return self.coordinate_accelerations(motion, rate, v, self.accelerations(motion, v))

    def accelerations_from(self, end: ClosedConfiguration, motion: ClosedConfiguration, v: ca.SX, a: ca.SX) -> ca.SX:
        """Second rates of q_i of the velocities v and accelerations a of a motion, in the charts at an end."""
        there, (x, w, b) = ca.vertcat(end.q_i, end.q_d), self._at_turns(motion, v, a)
        return self.charts.accelerations_from(there[: x.numel()], x, w, b)[: self.charts.n]

    def deflections(self) -> StiffDeflections:
        """The stiff deflections; n_s is zero where the model has none."""
        if not self.model.has("deflections"):
            return StiffDeflections(ca.SX(len(self.model.q_i), 0), ca.SX(0, 0), ca.SX(0, 0))
        found = self.call("deflections")
        return StiffDeflections(*(ca.sparsify(found[name]) for name in ("B", "K_s", "D_s")))

    def stiff_response(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> StiffResponse:
        """Accelerations, and what forces along the stiff deflections do, from one elimination or factorisation."""
        stiff = self.deflections()
        if self.model.has("deflection_response") and self.tree_is_shorter:
            found = self.call("deflection_response", **self._arguments(motion, q_i_dot))
            return StiffResponse(stiff.B, stiff.K, stiff.D, found["q_i_ddot"], found["X"])
        if not stiff.B.shape[1]:
            return StiffResponse(stiff.B, stiff.K, stiff.D, self.accelerations(motion, q_i_dot), stiff.B)
        M_hat, Q_hat = self.condensed(motion, q_i_dot)
        factors = factor(Number(ca.sparsify(M_hat)), symmetric=True)
        sides = [Q_hat, *ca.horzsplit(ca.densify(stiff.B))]
        a, *columns = (solve(factors, Number(ca.densify(side))).re for side in sides)
        return StiffResponse(stiff.B, stiff.K, stiff.D, a, ca.horzcat(*columns))

    def shifted_solution(self, motion: ClosedConfiguration, kappa: Number, delta: Number, force: Number) -> Number:
        """(M_hat + B (kappa K + delta D) B^T)^-1 B force along a tree: n_s -> n_i."""

        def parts(number: Number) -> list[ca.SX]:
            return [ca.densify(number.re), ca.SX.zeros(number.re.numel()) if number.im is None else number.im]

        shift, push = ca.vertcat(*parts(kappa), *parts(delta)), ca.vertcat(*parts(force))
        found = self.call("shifted_solution", q_i=motion.q_i, q_d=motion.q_d, t=motion.t, shift=shift, push=push)
        return Number(found["x_re"], None if force.im is None else found["x_im"])

    def joined(self, independent: ca.SX, dependent: ca.SX) -> ca.SX:
        """A vector in the order of the model's coordinates, from its parts."""
        return joined(self.model, independent, dependent)

    def linearised(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> LinearisedEquations:
        """The equations to first order about a state: M_hat a + (Q_hat, and its total derivatives less M_hat's)."""
        found = self.along_rotations(motion, q_i_dot)
        return replace(found, J_q=in_chart(self, motion, q_i_dot, found))

    def along_rotations(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> LinearisedEquations:
        """The same with derivatives along rotations and by angular velocities for turns, at any theta."""
        M_hat, Q_hat = self.condensed(motion, q_i_dot)
        a = solve_symmetric(M_hat, Q_hat)
        arguments = {**self._arguments(motion, q_i_dot), "q_i_ddot": a}
        found = self.call("residual_jacobian", **arguments)
        return LinearisedEquations(M_hat, found["J_q"], found["J_v"], Q_hat, a)

    def force_rate(self, motion: ClosedConfiguration, q_i_dot: ca.SX, q_i_ddot: ca.SX) -> ca.SX:
        """d(Q_hat - M_hat q_i_ddot)/dt at fixed q_i and q_i_dot, q_d = f(q_i, t) included."""
        names = ("condensed", "closure", "velocities")
        if not any(self.model.has(name) and "t" in self.model.kernel(name).name_in() for name in names):
            return ca.SX.zeros(len(self.model.q_i))
        t = ca.SX.sym("time")
        M_hat, Q_hat = self.condensed(self.close(motion.q_i, self.loop_part(motion.q_d), t, 1), q_i_dot)
        rate = ca.jacobian(Q_hat - ca.mtimes(M_hat, q_i_ddot), t)
        return ca.densify(ca.substitute(rate, t, motion.t))

    def substep(self, level: int, motion: ClosedConfiguration, q_i_dot: ca.SX, q_L_ddot: ca.SX) -> tuple[ca.SX, ca.SX]:
        """(M_hat_SS, right-hand side) of the groups from `level` on (0 = slowest), slower ones given (64).

        M_hat_SS, M_hat_SL and Q_hat_S are taken where (65)-(67) say: at the time of the motion, with its q_d.
        """
        arguments = self._arguments(motion, q_i_dot)
        result = self.call(f"substep_{level + 1}", **arguments, q_L_ddot=q_L_ddot)
        return result["M_hat_SS"], result["rhs_S"]

    def damping(self, motion: ClosedConfiguration, q_i_dot: ca.SX) -> ca.SX:
        """dQ_hat/dq_i_dot, total; all zero where no force depends on velocity."""
        if not velocity_dependent(self.model):
            return ca.SX.zeros(len(self.model.q_i), len(self.model.q_i))
        return self.call("dQ_hat_dq_i_dot", **self._arguments(motion, q_i_dot))["dQ_hat_dq_i_dot"]

    def loop_part(self, q_d: ca.SX) -> ca.SX:
        """Entries of a dependent vector that belong to loop unknowns."""
        return ca.vertcat(*(q_d[k] for k in self.loops)) if self.loops else ca.SX(0, 1)


def loop_blocks(model: EmittedModel) -> int:
    """How many determinants the closure gives; none where every dependent coordinate has a closed form."""
    return 0 if not model.loop_unknowns else int(model.kernel("closure").size1_out("det_loop"))


def tree_is_shorter(model: EmittedModel) -> bool:
    """Is there an elimination along a tree, and is it shorter than a factorisation of M_hat?

    M_hat of a long tree is not even looked at: it has n_i^2 entries. Masked pivots hold what sticks to the last bit.
    """
    if not model.has("forward_dynamics") or not model.has("condensed") or model.mode_events:
        return model.has("forward_dynamics")
    n, tree = len(model.q_i), model.operations_of("forward_dynamics")
    factorisation = n**3 / 6 + n**2
    return tree < factorisation or tree < model.operations_of("condensed") + factorisation


def is_long_tree(model: EmittedModel) -> bool:
    """Is the model a tree for which M_hat and the Jacobians are too long to be derived without need?"""
    return len(model.q_i) > LONG_TREE and tree_is_shorter(model)


def velocity_dependent(model: EmittedModel) -> bool:
    """Does Q_hat depend on velocity at all? Where it does not, there is nothing to iterate."""
    arguments = model.kernel("forward_dynamics" if tree_is_shorter(model) else "condensed").name_in()
    return any(name in arguments for name in ("q_i_dot", "q_d_dot"))


def _largest(vector: ca.SX) -> ca.SX:
    total = ca.fabs(vector[0])
    for k in range(1, vector.numel()):
        total = ca.fmax(total, ca.fabs(vector[k]))
    return total


# Stiff deflections s = B^T q_i of a model, and what it does at a state when forces act along them.


@dataclass(frozen=True)
class StiffDeflections:
    """s = B^T q_i (B n_i x n_s, constant) with stiffness K and damping D, n_s x n_s [SI]."""

    B: ca.SX
    K: ca.SX
    D: ca.SX

    def force(self, q_i: ca.SX, q_i_dot: ca.SX) -> ca.SX:
        """K s + D s' of positions and rates, or of changes of them (n_i)."""
        return ca.mtimes(self.K, ca.mtimes(self.B.T, q_i)) + ca.mtimes(self.D, ca.mtimes(self.B.T, q_i_dot))


@dataclass(frozen=True)
class StiffResponse(StiffDeflections):
    """And q_i_ddot = a (n_i) at a state, and X = M_hat^-1 B (n_i x n_s) there."""

    a: ca.SX
    X: ca.SX


def stiff_directions(model: EmittedModel) -> np.ndarray:
    """B (n_i, n_s), along which stiff deflections act; found once for a model."""

    def found() -> np.ndarray:
        return np.array(ca.DM(StageEquations(model, ca.SX.zeros(model.c_size + 1)).deflections().B))

    return model.derived("stiff_directions", found)


# Derivatives by turns: along rotations in the axes of their bodies, in a chart, and in axes that move.
#
# With dphi = S dq_i the rotation of a body in its axes (S: rows of dq/dq_i along angular velocities; unit rows for
# turns that are independent), to first order about theta = 0
#
#     omega = theta' - theta x theta'/2,   theta'' = omega' + theta x omega'/2 - w x (theta x w)/6,   w = omega there,
#
# and in axes that move with the body d omega = dphi' + omega x dphi: the rates of q_i change by W dq_i, where the rows
# of W are those of omega~ S that belong to independent turns.


@dataclass(frozen=True)
class Turned:
    """An orientation with independent turns: axes among x, y, z, their positions in q_i, all positions, and S."""

    axes: list[int]
    positions: list[int]
    own: list[int]
    S: ca.SX


def turned_bodies(equations: StageEquations, motion: ClosedConfiguration) -> list[Turned]:
    """The orientations of a model that have independent turns."""
    charts, n = equations.charts, equations.charts.n
    S = ca.SX.eye(n)
    if not charts.all_independent:
        v = ca.SX.sym("v", n)
        S = ca.vertcat(S, ca.jacobian(equations.rates(motion, v), v))
    found = []
    for own in charts.turns:
        axes = [axis for axis, k in enumerate(own) if k < n]
        if axes:
            found.append(Turned(axes, [own[axis] for axis in axes], own, S[own, :]))
    return found


def _all(equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """q_i_dot, and q_d_dot where turns stand there."""
    return v if equations.charts.all_independent else ca.vertcat(v, equations.rates(motion, v))


def turning(equations: StageEquations, motion: ClosedConfiguration, v: ca.SX) -> ca.SX:
    """W (n_i x n_i)."""
    W, rates = ca.SX(equations.charts.n, equations.charts.n), _all(equations, motion, v)
    for body in turned_bodies(equations, motion):
        W[body.positions, :] = ca.mtimes(ca.skew(rates[body.own]), body.S)[body.axes, :]
    return W


def turning_and_rate(equations: StageEquations, motion: ClosedConfiguration, v: ca.SX, a: ca.SX) -> tuple[ca.SX, ca.SX]:
    """(W, W') at the accelerations q_i_ddot = a."""
    v_d = equations.rates(motion, v)
    q_i, q_d, t = ca.SX.sym("q_i", motion.q_i.numel()), ca.SX.sym("q_d", motion.q_d.numel()), ca.SX.sym("t")
    at = ClosedConfiguration(q_i, q_d, t, motion.C_loop, motion.det_loop)
    W, rate = turning(equations, at, v), ca.SX(equations.charts.n, equations.charts.n)
    rates, accelerations = ca.vertcat(v, v_d), ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    old, new = ca.vertcat(q_i, q_d, t), ca.vertcat(motion.q_i, motion.q_d, motion.t)
    for body in turned_bodies(equations, at):
        S_dot = ca.jtimes(body.S, ca.vertcat(q_i, q_d), rates) + ca.jtimes(body.S, t, ca.SX(1))
        spin_slopes = ca.mtimes(ca.skew(accelerations[body.own]), body.S) + ca.mtimes(ca.skew(rates[body.own]), S_dot)
        rate[body.positions, :] = spin_slopes[body.axes, :]
    W, rate = ca.substitute([W, rate], [old], [new])
    return W, rate


def in_chart(
    equations: StageEquations,
    motion: ClosedConfiguration,
    v: ca.SX,
    found: LinearisedEquations,
) -> ca.SX:
    """J_q of M x'' = ... + J_q dx + J_v dx' at theta = 0, of matrices along rotations."""
    M_hat, J_q, J_v, a = found.M_hat, found.J_q, found.J_v, found.a
    bodies = turned_bodies(equations, motion)
    if not bodies:
        return J_q
    rates, accelerations = _all(equations, motion, v), a
    if not equations.charts.all_independent:
        accelerations = ca.vertcat(a, equations.dependent_accelerations(motion, v, a))
    changed = ca.SX(J_q)
    for body in bodies:
        w = rates[body.own]
        bend = -ca.skew(accelerations[body.own]) / 2 - (ca.dot(w, w) * ca.SX.eye(3) - ca.mtimes(w, w.T)) / 6
        change = ca.mtimes(J_v[:, body.positions], (ca.skew(w) / 2)[body.axes, :])
        change = change + ca.mtimes(M_hat[:, body.positions], bend[body.axes, :])
        changed = changed + ca.mtimes(change, body.S)
    return ca.densify(changed)


def along_rotations(equations: StageEquations, motion: ClosedConfiguration, slope: ca.SX) -> ca.SX:
    """Derivatives by q_i (any x n_i), those by turns along rotations in the axes of their bodies."""
    bodies = turned_bodies(equations, motion)
    if not bodies:
        return slope
    theta = motion.q_i if equations.charts.all_independent else ca.vertcat(motion.q_i, motion.q_d)
    P = ca.SX.eye(equations.charts.n)
    for body in bodies:
        rates = ca.horzcat(*(chart_rate(theta[body.own], column) for column in ca.horzsplit(ca.densify(body.S))))
        P[body.positions, :] = rates[body.axes, :]
    return ca.mtimes(slope, P)

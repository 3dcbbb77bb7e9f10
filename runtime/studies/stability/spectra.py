"""What steps do to small disturbances at a state: the exact Jacobian of a step of a scheme, its radius and growth.

Of a Runge-Kutta method on a linear system its eigenvalues are the values R(h lambda) of the stability function
(E. Hairer, G. Wanner: Solving Ordinary Differential Equations II, 2nd ed., Springer 1996, section IV.2); here it is
that of any scheme, sub-steps included, on the equations of the mechanism.
"""

from __future__ import annotations

from bisect import bisect
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np
from scipy.sparse import csc_array

from runtime.contract.consistent_state import dense_eigenvalues
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import angular_velocity, chart_rates, parameter_rates, rotation
from runtime.engine.program import Repeat, Until
from runtime.operating.mode_solver import ModeSolver, State
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.scheme import Scheme

# The exact Jacobian of a major step, stage by stage: the amplification matrix of the scheme at a state.
#
# Every stage is a CasADi Function, so its Jacobian comes from automatic differentiation; a step is their product
# along the states that the step passes. An iteration y <- F(y, z) is differentiated at its fixed point by the
# implicit-function theorem, dy = (1 - F_y)^-1 F_z dz: the sweeps that reach it are as many as the value needs (one,
# at rest), and their product need not be the derivative of what they reach. Where F is no contraction the iteration
# fails in a run, and the matrix is not finite.

# (z, dz, c) -> (z after it, dz after it), of a part of the program
Advance = Callable[[np.ndarray, np.ndarray, np.ndarray], tuple[np.ndarray, np.ndarray]]


class TangentStep:
    """One major step of a scheme with its derivative by the fields of z that act on the next step."""

    def __init__(self, scheme: Scheme) -> None:
        self.scheme, self.program = scheme, scheme.program()
        slices = [scheme.layout.slice(name) for name in scheme.memory if name != "chart"]
        self.columns = np.concatenate([np.arange(part.start, part.stop) for part in slices]).astype(int)
        kept = [scheme.layout.slice(name) for name in scheme.bookkeeping]
        self._bookkeeping = np.concatenate([np.arange(part.start, part.stop) for part in kept]).astype(int)
        self._step = self.program.fold(_tangent_of_stage, _in_sequence, self._again)

    def __call__(self, z: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(z after a major step, amplification matrix on `columns`)."""
        tangent = np.zeros((len(z), len(self.columns)))
        tangent[self.columns, np.arange(len(self.columns))] = 1.0
        self._set_out(z, tangent)
        z, tangent = self._step(z, tangent, c)
        self._arrive(z, tangent)
        return z, tangent[self.columns]

    def _orientations(self) -> Iterator[tuple[np.ndarray, slice]]:
        """(places of the turns in z, of the chart) of each orientation; changes are rotations in its axes."""
        layout = self.scheme.layout
        if "chart" in layout.sizes:
            first, at = layout.slice("chart").start, self.scheme.model.places
            where = np.zeros(at.n_i + len(self.scheme.model.q_d), dtype=int)
            where[: at.n_i] = layout.slice("x").start + np.arange(at.n_i)
            where[at.n_i + at.loops] = layout.slice("loop").start + np.arange(len(at.loops))
            for k, turns in enumerate(at.turns):
                yield where[turns], slice(first + 4 * k, first + 4 * k + 4)

    def _set_out(self, z: np.ndarray, tangent: np.ndarray) -> None:
        """Changes of turns put into their charts, from which everything else counts, in place."""
        for turns, chart in self._orientations():
            change = rotation(z[turns]) @ tangent[turns]
            tangent[chart], tangent[turns] = parameter_rates(z[chart], change.T).T, 0.0

    def _arrive(self, z: np.ndarray, tangent: np.ndarray) -> None:
        """Changes of turns and charts together as those of turns, in place; infinite behind a whole turn."""
        for turns, chart in self._orientations():
            if not np.linalg.norm(z[turns]) < 2 * np.pi:
                tangent[turns] = np.inf
                continue
            own = np.linalg.solve(chart_rates(z[turns]), tangent[turns])
            tangent[turns] = own + rotation(z[turns]).T @ angular_velocity(z[chart], tangent[chart].T).T

    def _again(self, body: Advance, node: Repeat | Until) -> Advance:
        if isinstance(node, Repeat):
            return _in_sequence([body] * node.count)

        def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
            for _ in range(node.limit):
                if z[node.flag] <= 0:
                    break
                z, _ = body(z, np.zeros((len(z), 0)), c)
            return z, self._at_fixed_point(body(z, np.eye(len(z)), c)[1], tangent)

        return advance

    def _at_fixed_point(self, jacobian: np.ndarray, tangent: np.ndarray) -> np.ndarray:
        """dz after an iteration with this Jacobian of one pass; rows that a pass leaves alone are not iterated."""
        iterated = np.any(jacobian != np.eye(len(jacobian)), axis=1)
        iterated[self._bookkeeping] = False
        F_y, F_z = jacobian[np.ix_(iterated, iterated)], jacobian[np.ix_(iterated, ~iterated)]
        after = tangent.copy()
        if not np.isfinite(jacobian[iterated]).all() or np.abs(np.linalg.eigvals(F_y)).max(initial=0.0) >= 1:
            after[iterated] = np.inf
        else:
            after[iterated] = np.linalg.solve(np.eye(len(F_y)) - F_y, F_z @ tangent[~iterated])
        return after


def _tangent_of_stage(stage: ca.Function) -> Advance:
    z, c = ca.SX.sym("z", stage.size1_in(0)), ca.SX.sym("c", stage.size1_in(1))
    result = stage(z, c)
    jacobian = ca.jacobian(result, z)
    function = ca.Function("tangent", [z, c], [ca.densify(result), jacobian.nz[:]])
    places = (jacobian.sparsity().row(), jacobian.sparsity().colind())
    given, found = [np.zeros(z.numel()), np.zeros(c.numel())], [np.zeros(z.numel()), np.zeros(jacobian.nnz())]
    matrix = csc_array((found[1].copy(), *places), shape=jacobian.shape)
    buffers: Any = function.buffer()  # as matrices of CasADi, values would cost more than the stage itself
    buffer, evaluate = buffers
    for k in range(2):
        buffer.set_arg(k, given[k].data)
        buffer.set_res(k, found[k].data)
    kept = (function, buffer)  # which the buffer itself does not hold

    def advance(
        z: np.ndarray, tangent: np.ndarray, c: np.ndarray, keep: object = kept
    ) -> tuple[np.ndarray, np.ndarray]:
        if not tangent.shape[1]:
            return np.asarray(stage(z, c)).ravel(), tangent
        given[0][:], given[1][:] = z, c
        evaluate()
        matrix.data[:] = found[1]
        return found[0].copy(), matrix @ tangent

    return advance


def _in_sequence(parts: list[Advance]) -> Advance:
    def advance(z: np.ndarray, tangent: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        for part in parts:
            z, tangent = part(z, tangent, c)
        return z, tangent

    return advance


# What the amplification matrix at a state says: spectral radius, and growth that the equations do not have.
#
# Over a step the equations themselves change, and may make a motion grow (a falling pendulum does). So multipliers of
# the step are compared with those of the exact motion over the same time, which a much finer exponential step gives.

VANISHED = 0.5  # multipliers below this have no counterpart in the motion that could grow
EXACT_STEPS = 4  # exact motion: this many exponential steps
MULTIPLIER_ROUNDING = 1e-9


@dataclass(frozen=True)
class Spectrum:
    """Spectral radius of a major step, and of each mode (ascending) the growth rate [1/s] that the exact motion lacks.

    A negative rate is damping that the equations do not have.
    """

    radius: float
    growth: np.ndarray


class StepSpectrum:
    """Spectra of a scheme at states of a model; the step may be changed without building anything anew."""

    def __init__(self, model: EmittedModel, scheme: Scheme, c: np.ndarray, exact: ExactMotion | None = None) -> None:
        self.scheme, self.c = scheme, c
        self._step = _TangentFrom(scheme, c)
        self.exact = exact or ExactMotion(model, c)

    def matrix(self, state: State, dt: float) -> np.ndarray:
        """Amplification matrix (2 n_i, 2 n_i) of (q_i, q_i_dot) over a major step dt [s] started at a state."""
        return self._step(state, dt)

    def __call__(self, state: State, dt: float) -> Spectrum:
        """Radius and growth at a state."""
        exact, matrix = self.exact(state, dt), self.matrix(state, dt)
        if not np.isfinite(matrix).all():
            return Spectrum(np.inf, np.full(len(exact) // 2, np.inf))
        multipliers = dense_eigenvalues(matrix)
        size = np.abs(multipliers)
        # which mode a multiplier belongs to is told by the nearest exact one; aliases fall together
        nearest = np.abs(multipliers[:, None] - exact[None, :]).argmin(axis=1)
        growth = np.full(len(exact), -np.inf)
        for k in np.flatnonzero(size > VANISHED):
            j = nearest[k]
            with np.errstate(divide="ignore"):  # an exact multiplier of zero: growth without bound
                growth[j] = max(growth[j], float(np.log(size[k] / abs(exact[j]))))
        modes = growth.reshape(-1, 2).max(axis=1)
        return Spectrum(float(size.max()), np.where(np.isfinite(modes), modes, 0.0) / dt)


class ExactMotion:
    """Multipliers of the exact motion over a time, pairs of a mode together, slow modes first; kept for reuse.

    A motion over dt goes on from the longest shorter one that is known, by steps of at most dt / EXACT_STEPS.
    """

    def __init__(self, model: EmittedModel, c: np.ndarray) -> None:
        self._step = _TangentFrom(scheme_kind("exponential").build("exponential", model, 1.0, [4], {}), c)
        self.modes = ModeSolver(model, c)
        self._found: dict[tuple[float, float], np.ndarray] = {}
        self._eigenvalues: dict[float, np.ndarray] = {}
        self._reached: dict[float, list[Reached]] = {}

    def __call__(self, state: State, dt: float) -> np.ndarray:
        """Multipliers over dt from a state."""
        key = (state.t, dt)
        if key not in self._found:
            matrix = self._matrix(state, dt)
            values = dense_eigenvalues(matrix) if np.isfinite(matrix).all() else np.ones(len(matrix))
            values = values[np.argsort(-np.abs(values))][: 2 * self.modes.n]  # memory beyond the motion vanishes
            frozen = self._frozen(state)
            self._found[key] = values[_matched(np.exp(frozen * dt), values)]
        return self._found[key]

    def _frozen(self, state: State) -> np.ndarray:
        if state.t not in self._eigenvalues:
            values = self.modes.eigenvalues(state)
            self._eigenvalues[state.t] = values[np.argsort(np.abs(values), kind="stable")]
        return self._eigenvalues[state.t]

    def _matrix(self, state: State, dt: float) -> np.ndarray:
        known = self._reached.setdefault(state.t, [self._step.start(state)])
        place = bisect(known, dt, key=lambda one: one.t)
        before = known[place - 1]
        steps = int(np.ceil(EXACT_STEPS * (dt - before.t) / dt - MULTIPLIER_ROUNDING))
        reached = self._step.on(before, dt, steps)
        if np.isfinite(reached.matrix).all():
            known.insert(place, reached)
        return reached.matrix


def _matched(wanted: np.ndarray, found: np.ndarray) -> list[int]:
    """For each wanted value the nearest found one that is not taken yet."""
    left, order = list(range(len(found))), []
    for value in wanted:
        best = min(left, key=lambda k: abs(found[k] - value))
        left.remove(best)
        order.append(best)
    return order


@dataclass(frozen=True)
class Reached:
    """z and the amplification matrix a time t [s] after a state."""

    t: float
    z: np.ndarray
    matrix: np.ndarray


class _TangentFrom:
    """Amplification matrix of several major steps from a state."""

    def __init__(self, scheme: Scheme, c: np.ndarray) -> None:
        self.c, self.scheme, self._tangent = c, scheme, TangentStep(scheme)

    def start(self, state: State) -> Reached:
        """At the state itself."""
        c = self.scheme.constants(self.c, 1.0)
        z = np.asarray(self.scheme.starter(state.t, state.q_i, state.q_i_dot, state.loop, c)).ravel()
        return Reached(0.0, z, np.eye(len(self._tangent.columns)))

    def on(self, reached: Reached, t: float, steps: int) -> Reached:
        """Further on, up to t, by equal steps."""
        z, matrix = reached.z, reached.matrix
        c = self.scheme.constants(self.c, (t - reached.t) / max(steps, 1))
        for _ in range(steps):
            z, step = self._tangent(z, c)
            matrix = step @ matrix
        return Reached(t, z, matrix)

    def __call__(self, state: State, dt: float) -> np.ndarray:
        """Over one major step."""
        c = self.scheme.constants(self.c, dt)
        z = np.asarray(self.scheme.starter(state.t, state.q_i, state.q_i_dot, state.loop, c)).ravel()
        return self._tangent(z, c)[1]

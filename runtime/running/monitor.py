"""What ends a run: checks of its state between native calls.

Cheap checks read z itself: numbers that are not finite, growth, closures that moved too far, iterations that failed,
steps that shrink without end. Close ones evaluate the equations: constraints hold, M_hat is positive definite,
deflections stay within what linear modes tell. What a failed check means is said by `diagnose`.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import casadi as ca
import numpy as np

from runtime.contract.coordinates import (
    independent_part,
    joined,
    length_rows,
    longest_arm,
    loop_part,
    turning_columns,
    whole,
)
from runtime.contract.model import EmittedModel
from runtime.contract.status import Status
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.mass_matrix import positive_definite
from runtime.schemes.scheme import Scheme, direct, verdict
from runtime.schemes.stage_equations import StageEquations, is_long_tree
from runtime.schemes.switching.watched import watched_events

FULL_CHECKS = 16  # saved states that are looked at closely, the first ones and then one in so many
GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call
CLOSURE_LIMIT = 1e-2  # C before the last Newton step, in mechanism lengths; quadratic convergence leaves its square
CONSTRAINT_LIMIT = 1e-6  # C of the observed state, in mechanism lengths (m) or rad
MOST_TURN_OF_BODY = 1.0  # rad, of a drawn point of a body against the body's axes
MOST_DEFLECTION = 0.4  # of the body's length; second-order stiffening is off by a tenth before half of that
Body = tuple[str, list[int], float, np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Failure:
    """A check that failed, by its name in `diagnose`; k: place in q_i of what is to blame; found: for its words."""

    check: str
    k: int | None = None
    found: tuple[Any, ...] = ()


class Monitor:
    """Of a run of a scheme on a model with constants c (c_size,) and parameters p (n_p,; None: the model's own).

    force: run although the step is above its limit. refined: the name of the scheme where a tolerance chose its steps.
    good: the last z that passed a close look, latest: a cheap one; length [m]: size of the mechanism, from the lever
    arms in C_q at the start, 1 without constraints.
    """

    scheme: Scheme

    def __init__(
        self,
        model: EmittedModel,
        scheme: Scheme,
        c: np.ndarray,
        force: bool = False,
        p: np.ndarray | None = None,
        refined: str = "",
    ) -> None:
        self.model, self.scheme, self.c, self.force = model, scheme, scheme.constants(c), force
        self.refined = refined
        self.good: np.ndarray | None = None
        self.latest: np.ndarray | None = None
        self.length, self.scale = 1.0, 1.0
        self._samples = 0
        self._at_start: np.ndarray | None = None
        self.look, self._p = CloseLook(model, scheme), p

    def first(self, z: np.ndarray, like: Monitor | None = None) -> Status | None:
        """Look at the start (the scheme's part of z, flat), and remember what later states are compared with.

        like: who has looked at the same start of other steps, and found nothing.
        """
        if not np.isfinite(z).all():
            return self._ends(self._of_events(z) or Failure("finite at the start"), z)
        self.good = self._at_start = z.copy()
        x, d = z[self.scheme.layout.slice("x")], self._increments(z)
        self.scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        if like is not None:
            self.length, self._bodies = like.length, like._bodies
            return None
        if self.look.constrained:
            self.length = self.look.mechanism_length(z, self.c)
        if not positive_definite(self.look(z, self.c).M_hat):
            return self._ends(Failure("mass at the start"), z)
        h = self.scheme.grid.h[-1]
        if self.force or self.step_limit is None or h <= self.step_limit:
            return None
        return self._ends(Failure("step length", found=(h,)), z)

    def after(self, z: np.ndarray, last: bool = False, samples: int = 1) -> Status | None:
        """Status that ends the run, or None to go on. z is put back to the last good state when it ends.

        samples: saved states since the last call. Cheap looks follow every call; close ones for the first FULL_CHECKS
        samples, then once in FULL_CHECKS of them, and at the last.
        """
        before, self._samples = self._samples, self._samples + samples
        close = last or self._samples <= FULL_CHECKS or self._samples // FULL_CHECKS > before // FULL_CHECKS
        with np.errstate(all="ignore"):
            failure = self._cheaply(z) or (self._closely(z) if close else None)
        if failure is None:
            self.latest = z.copy()
            self.good = self.latest if close else self.good
            return None
        assert self.good is not None
        z[:] = self.good
        return self._ends(failure, self.good)

    def _ends(self, failure: Failure, z: np.ndarray) -> Status:
        """The status that ends a run at its last good state z."""
        own = self.scheme.layout.slice
        time = float(z[own("t0")][0] + z[own("n")][0] * self.scheme.grid.dt_L)
        with np.errstate(all="ignore"):
            from runtime.running.diagnose import diagnose

            return diagnose(failure, time, self)

    def memory(self) -> dict[str, list[float]]:
        """What later looks compare with."""
        return {"length": [self.length], "scale": [self.scale], "samples": [float(self._samples)]}

    def resume(self, z: np.ndarray, memory: Mapping[str, list[float]]) -> None:
        """Go on from a good state with the memory of an earlier monitor."""
        self.good, self.latest = z.copy(), z.copy()
        self.recall(memory)

    def recall(self, memory: Mapping[str, list[float]]) -> None:
        """Compare with what `memory` holds again; the last good state stays."""
        (self.length,), (self.scale,), (samples,) = memory["length"], memory["scale"], memory["samples"]
        self._samples = int(samples)

    # ---- checks ---------------------------------------------------------------------------------------------

    def _cheaply(self, z: np.ndarray) -> Failure | None:
        """By z itself. Angles may turn for ever, so growth is judged by the size of a step."""
        scheme, own, found = self.scheme, self.scheme.layout.slice, verdict(self.scheme, z)
        d = np.abs(self._increments(z))
        if found == "not_finite":
            bad = int(np.argmax(~np.isfinite(z[own("x")]) | ~np.isfinite(d)))
            return self._of_events(z) or Failure("finite", bad)
        if d.max(initial=0.0) > GROWTH_LIMIT * self.scale:
            return Failure("growth", int(d.argmax()))
        if z[own("closure_error")][0] > CLOSURE_LIMIT * self.length:
            return Failure("closure")
        if found is not None:
            return Failure("iterations", found=(scheme.iteration_limit,))
        if scheme.hit_min_step(z):
            return Failure("least step", found=(scheme.reached(z),))
        return self._of_modes(z)

    def _of_modes(self, z: np.ndarray) -> Failure | None:
        """Where a stop pulls or friction holds too much, and no event has told."""
        model, layout, n = self.model, self.scheme.layout, len(self.model.element_modes)
        if not n or "event_values" not in layout.sizes:
            return None
        declared = len(model.description.events)
        left = z[layout.slice("event_values")][declared - n : declared]
        if (left >= 0).all():
            return None
        from runtime.schemes.switching.consistency import broken_on_the_way, elements_of, no_limit

        shown, c = self.scheme.observer(z=z[: layout.size], c=self.c), self.c[: model.c_size].copy()
        at = {name: np.asarray(shown[name]).ravel() for name in ("q_i", "q_d", "q_i_dot", "q_d_dot", "t")}
        c[len(c) - model.signals.size :] = z[layout.slice("inputs")]
        if (none := no_limit(model, elements_of(model, at, c)["holds"])) is not None:
            return Failure("limit", found=(none.cause,))
        broken = broken_on_the_way(model, at, c, left, self.length)
        return None if broken is None else Failure("mode", found=(broken,))

    def _of_events(self, z: np.ndarray) -> Failure | None:
        """Where nothing but the value of an event is not finite."""
        layout = self.scheme.layout
        if "event_values" not in layout.sizes or not np.isfinite(z[layout.slice("x")]).all():
            return None
        bad = ~np.isfinite(z[layout.slice("event_values")])
        return Failure("event", found=(watched_events(self.scheme)[int(np.argmax(bad))].name,)) if bad.any() else None

    def _closely(self, z: np.ndarray) -> Failure | None:
        observation = self.look(z, self.c)
        if self.look.constrained:
            allowed = CONSTRAINT_LIMIT * np.where(self.look.lengths, self.length, 1.0)
            if not (np.abs(observation.C) <= allowed).all():  # NaN is off too
                return Failure("constraints")
        return self._beyond_linear_modes(observation.q) if positive_definite(observation.M_hat) else Failure("mass")

    def _beyond_linear_modes(self, q: np.ndarray) -> Failure | None:
        """Deflections against the body's length, and turns against a radian: modes are linear."""
        for name, columns, length, shapes, turns in self._bodies:
            moved = float(np.sqrt(np.square(shapes @ q[columns]).sum(axis=1).max())) / length
            turned = float(np.sqrt(np.square(turns @ q[columns]).sum(axis=1).max()))
            if moved > MOST_DEFLECTION or turned > MOST_TURN_OF_BODY:
                return Failure("deflection", found=(name, moved, turned))
        return None

    @cached_property
    def _bodies(self) -> list[Body]:
        return flexible_bodies(self.model, self.model.parameter_vector() if self._p is None else self._p)

    @cached_property
    def step_limit(self) -> float | None:
        """Of the fastest group's step at the start [s]; None where nothing limits it, or its modes are not known."""
        slopes = self.slopes(self._at_start) if self.scheme.limited() else None
        limit = None if slopes is None else self.scheme.step_limit(*slopes)
        return None if limit is None else limit.h

    def _increments(self, z: np.ndarray) -> np.ndarray:
        """About what each coordinate of q_i (n_i,) moves in a step."""
        return np.asarray(self.scheme.rates(z) * self.scheme.step_sizes)

    def slopes(self, z: np.ndarray | None = None, moving: bool = True) -> tuple[np.ndarray, np.ndarray] | None:
        """A_q, A_v (n_i x n_i) of w'' = A_q w + A_v w' at z (None: the last good state), or at rest there; None if they
        are not known.
        """
        model, z = self.model, self.good if z is None else z
        if z is None or not ModeSolver.possible(model):
            return None
        observation = self.scheme.observer(z=z, c=self.c)
        q_i, rates, q_d = (np.asarray(observation[name]).ravel() for name in ("q_i", "q_i_dot", "q_d"))
        q = whole(model, q_i, q_d)
        state = State(float(observation["t"]), independent_part(model, q), rates * moving, loop_part(model, q))
        return known_slopes(model, self.c[: model.c_size], state)


def known_slopes(model: EmittedModel, c: np.ndarray, state: State) -> tuple[np.ndarray, np.ndarray] | None:
    """A_q, A_v (n_i x n_i) of w'' = A_q w + A_v w' at a state; None where M_hat is singular or they are not finite."""

    def found() -> tuple[np.ndarray, np.ndarray] | None:
        try:
            A_q, A_v = ModeSolver(model, c).slopes(state)
        except np.linalg.LinAlgError:
            return None
        return (A_q, A_v) if np.isfinite(A_q).all() and np.isfinite(A_v).all() else None

    numbers = (c.tobytes(), state.t, state.q_i.tobytes(), state.q_i_dot.tobytes(), state.loop.tobytes())
    return model.of_numbers("slopes", numbers, found)


class Looked(NamedTuple):
    """C (n_c,), M_hat (n_i, n_i) and q (n,) at a state."""

    C: np.ndarray
    M_hat: np.ndarray
    q: np.ndarray


class CloseLook:
    """What the equations say at a state z (at least the scheme's part), by functions that a scheme keeps."""

    def __init__(self, model: EmittedModel, scheme: Scheme) -> None:
        self.model, self.scheme = model, scheme
        self.constrained = bool(model.constraints) and model.has("constraints")
        self.lengths = length_rows(model)
        self._long = is_long_tree(model) and model.has("energy")  # M_hat is not derived for this

    def __call__(self, z: np.ndarray, c: np.ndarray) -> Looked:
        n, rows = len(self.model.q_i), len(self.model.constraints) * self.constrained
        values = direct(self.scheme, "close look", self._build)(z, c)
        if not self._long:
            end = rows + n * n
            return Looked(values[:rows], values[rows:end].reshape(n, n).T, values[end:])
        momenta = self.scheme.derived("momenta", lambda: _momenta(self.model, self.scheme))
        columns = np.asarray(momenta(z, c, np.hstack([np.zeros((n, 1)), np.eye(n)])))
        return Looked(values[:rows], columns[:, 1:] - columns[:, :1], values[rows:])

    def _build(self) -> ca.Function:
        model, scheme = self.model, self.scheme
        z, c = _symbols(scheme)
        observation = {**scheme.observer(z=z, c=c), "c": observed_constants(scheme, z, c)}
        q = joined(model, observation["q_i"], observation["q_d"])
        C = observed(model, scheme, "constraints", ("C",))(z, c) if self.constrained else ca.SX(0, 1)
        M_hat = ca.SX(0, 1) if self._long else ca.vec(model.evaluate("condensed", **observation)["M_hat"])
        return ca.Function("close_look", [z, c], [ca.densify(ca.vertcat(C, M_hat, q))])

    def mechanism_length(self, z: np.ndarray, c: np.ndarray) -> float:
        """The largest lever arm in C_q [m], 1 if there is none."""
        return longest_arm(direct(self.scheme, "lever arms", self._lever_arms)(z, c))

    def _lever_arms(self) -> ca.Function:
        """(z, c) -> what is not zero of the rows of C_q that are lengths, by angles."""
        (z, c), found = _observed(self.model, self.scheme, "constraints")
        rows, columns = (np.flatnonzero(one(self.model)).tolist() for one in (length_rows, turning_columns))
        arms = ca.sparsify(found["C_q"][rows, columns])
        return ca.Function("lever_arms", [z, c], [ca.densify(ca.vec(arms.nz[:])) if arms.nnz() else ca.SX.zeros(1)])


def _symbols(scheme: Scheme) -> tuple[ca.SX, ca.SX]:
    return ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)


def _momenta(model: EmittedModel, scheme: Scheme) -> ca.Function:
    """(z, c, q_i_dot) -> dT/dq_i_dot at the configuration that z shows, (n_i,): M_hat q_i_dot, and a constant part."""
    (z, c), rates = _symbols(scheme), ca.SX.sym("v", len(model.q_i))
    observation, constants = scheme.observer(z=z, c=c), observed_constants(scheme, z, c)
    equations = StageEquations(model, constants)
    at = {"q_i": observation["q_i"], "q_d": observation["q_d"], "q_i_dot": rates, "t": observation["t"]}
    q_d_dot = equations.call("velocities", **at)["q_d_dot"] if model.q_d else ca.SX(0, 1)
    q, q_dot = equations.joined(observation["q_i"], observation["q_d"]), equations.joined(rates, q_d_dot)
    kinetic = equations.call("energy", q=q, q_dot=q_dot, t=observation["t"])["kinetic"]
    return ca.Function("momenta", [z, c, rates], [ca.densify(ca.gradient(kinetic, rates))])


def observed(model: EmittedModel, scheme: Scheme, name: str, outputs: Sequence[str]) -> ca.Function:
    """(z, c) -> outputs of a kernel of (q, q_dot, t) at the state that z shows; built once for a scheme."""

    def build() -> ca.Function:
        symbols, found = _observed(model, scheme, name)
        return ca.Function(f"observed_{name}", [*symbols], [ca.densify(found[output]) for output in outputs])

    return scheme.derived(f"observed {name} {outputs}", build)


def _observed(model: EmittedModel, scheme: Scheme, name: str) -> tuple[tuple[ca.SX, ca.SX], dict[str, ca.SX]]:
    """((z, c), outputs of a kernel of (q, q_dot, t) at the state that z shows)."""
    z, c = _symbols(scheme)
    observation = scheme.observer(z=z, c=c)
    q = joined(model, observation["q_i"], observation["q_d"])
    q_dot = joined(model, observation["q_i_dot"], observation["q_d_dot"])
    return (z, c), model.evaluate(name, q=q, q_dot=q_dot, t=observation["t"], c=observed_constants(scheme, z, c))


def observed_constants(scheme: Scheme, z: ca.SX, c: ca.SX) -> ca.SX:
    """The model's constants at a state, with the inputs that it holds."""
    return scheme.constants_at(scheme.layout.unpack(z[: scheme.layout.size]), c[: scheme.model.c_size])


def flexible_bodies(model: EmittedModel, p: np.ndarray) -> list[Body]:
    """(name, columns in q, length [m], shapes and turns of its points (points, 3, modes)) of each flexible body."""

    def found() -> list[Body]:
        points, bodies = [one for one in model.drawn_points(p) if one.shapes.size], list[Body]()
        for name in dict.fromkeys(one.body for one in points):
            parts = zip(*(one[2:] for one in points if one.body == name), strict=True)
            places, shapes, turns = (np.array(part) for part in parts)
            length = float(np.linalg.norm(np.ptp(places, axis=0)))
            if length > 0:
                bodies.append((name, model.columns_of(name)[1], length, shapes, turns))
        return bodies

    return model.of_numbers("flexible bodies", (p.tobytes(),), found) if model.elastic and model.has("geometry") else []

"""What ends a run: looks at its state between native calls.

Cheap looks read z itself: numbers that are not finite, growth, closures that moved too far, iterations that failed,
steps that shrink without end. A close look evaluates the equations: constraints hold, M_hat is positive definite,
deflections stay within what linear modes tell. One function, `diagnosis`, says which finding ends the run.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import one_thread
from runtime.contract.coordinates import independent_part, joined, length_rows, loop_part, mechanism_length, whole
from runtime.contract.model import Model
from runtime.contract.status import Status, StatusName
from runtime.operating.mode_solver import ModeSolver, State
from runtime.schemes.scheme import Scheme, direct, verdict
from runtime.schemes.stage_equations import StageEquations, is_long_tree
from runtime.schemes.step_limit import StepLimit, eigenvalues
from runtime.schemes.switching.watched import watched_events

FULL_CHECKS = 16  # saved states that are looked at closely, the first ones and then one in so many
GROWTH_LIMIT = 1e6  # times the scale of the mechanism: far beyond anything a bounded motion reaches in a call
CLOSURE_LIMIT = 1e-2  # C before the last Newton step, in mechanism lengths; quadratic convergence leaves its square
CONSTRAINT_LIMIT = 1e-6  # C of the observed state, in mechanism lengths (m) or rad
MOST_TURN = 1.0  # rad, of a drawn point of a body against the body's axes
MOST_DEFLECTION = 0.4  # of the body's length; second-order stiffening is off by a tenth before half of that
NEARLY_LOST = 0.1  # of M_hat at the start: below this a breakdown of the numbers is laid to it
NEARLY_SINGULAR = 0.05  # smallest of the largest singular value of C_q, angles counted times the mechanism's length
STRONG = 5.0  # times that a motion decays by e in a step, from which advice names the damper

BREAKDOWNS = ("not_finite", "diverged", "constraints_lost", "iteration_failed")  # that M_hat may be the cause of
OUT_OF_REACH = "A drive may ask for a position that the lengths do not allow: look at the motion until then."
DEAD_CENTRE = (
    "So the mechanism may be at a dead centre, where the chosen independent coordinates do not determine it: choose "
    "others (partition.independent), or reduce the step."
)
OF_MASS = (
    "A deflection is too large for second-order geometric stiffening, or a mass is not positive: use more or stiffer "
    "bodies, smaller loads, or a shorter step if it grew by instability."
)
OF_EVENTS = "Write it so that it has one wherever the motion may go: a root or logarithm of max(..., 0), no division."
Body = tuple[str, list[int], float, np.ndarray, np.ndarray]


@dataclass(frozen=True)
class Finding:
    """Why a run ends: name, cause and advice of its status; k: position in q_i of what is to blame."""

    name: StatusName
    cause: str
    advice: str
    k: int | None = None


class Monitor:
    """Of a run of a scheme on a model with constants c (c_size,) and parameters p (n_p,; None: the model's own).

    force: run although the step is above its limit. good: the last z that passed a close look; length [m]: size of the
    mechanism, from the lever arms in C_q at the start, 1 without constraints.
    """

    def __init__(
        self, model: Model, scheme: Scheme, c: np.ndarray, force: bool = False, p: np.ndarray | None = None
    ) -> None:
        self.model, self.scheme, self.c, self.force = model, scheme, scheme.constants(c), force
        self.good: np.ndarray | None = None
        self.length, self.scale = 1.0, 1.0
        self._samples = 0
        self._begun: np.ndarray | None = None
        self._latest: np.ndarray | None = None  # the last state that passed the cheap looks
        self._at_start: np.ndarray | None = None  # M_hat
        self._bodies = flexible_bodies(model, model.parameter_vector() if p is None else p)
        self._look = CloseLook(model, scheme)

    def first(self, z: np.ndarray) -> Status | None:
        """Look at the start (the scheme's part of z, flat), and remember what later states are compared with."""
        if not np.isfinite(z).all():
            found = self._of_events(z) or Finding(
                "not_finite",
                "the accelerations at the start are not finite",
                "M_hat may be singular, or a load infinite: check masses, inertias, loads and the initial position.",
            )
            return self._status(found, z)
        self.good = self._begun = z.copy()
        x, d = z[self.scheme.layout.slice("x")], self._increments(z)
        self.scale = max(1.0, float(np.abs(x).max(initial=0.0)), float(np.abs(d).max(initial=0.0)))
        if self._look.constrained:
            self.length = mechanism_length(self.model, self._look.constraints(z, self.c)[1])
        M_hat = self._look.mass(z, self.c)
        if not positive_definite(M_hat):
            return self._status(Finding("mass_not_positive", "M_hat is not positive definite at the start", OF_MASS))
        self._at_start = M_hat
        return self._status(self._step_length())

    def after(self, z: np.ndarray, last: bool = False, samples: int = 1) -> Status | None:
        """Status that ends the run, or None to go on. z is put back to the last good state when it ends.

        samples: saved states since the last call. Cheap looks follow every call; close ones for the first FULL_CHECKS
        samples, then once in FULL_CHECKS of them, and at the last.
        """
        before, self._samples = self._samples, self._samples + samples
        close = last or self._samples <= FULL_CHECKS or self._samples // FULL_CHECKS > before // FULL_CHECKS
        found = self._diagnosis(z, close)
        if found is None:
            self._latest = z.copy()
        elif self._latest is not None and found.name in BREAKDOWNS:
            found = self._lost_mass(self._latest) or found
        status = self._status(found)
        if status is not None and self.good is not None:
            z[:] = self.good
        elif close:
            self.good = z.copy()
        return status

    def memory(self) -> dict[str, list[float]]:
        """What later looks compare with."""
        return {"length": [self.length], "scale": [self.scale], "samples": [float(self._samples)]}

    def resume(self, z: np.ndarray, memory: Mapping[str, list[float]]) -> None:
        """Go on from a good state with the memory of an earlier monitor."""
        self.good, self._latest = z.copy(), z.copy()
        self.recall(memory)

    def recall(self, memory: Mapping[str, list[float]]) -> None:
        """Compare with what `memory` holds again; the last good state stays."""
        (self.length,), (self.scale,), (samples,) = memory["length"], memory["scale"], memory["samples"]
        self._samples = int(samples)

    # ---- findings -------------------------------------------------------------------------------------------

    def _diagnosis(self, z: np.ndarray, close: bool) -> Finding | None:
        """The first finding, the cheap ones before the others."""
        with np.errstate(all="ignore"):
            return self._cheaply(z) or (self._closely(z) if close else None)

    def _cheaply(self, z: np.ndarray) -> Finding | None:
        """By z itself. Angles may turn for ever, so growth is judged by the size of a step."""
        scheme, own, found = self.scheme, self.scheme.layout.slice, verdict(self.scheme, z)
        d = np.abs(self._increments(z))
        if found == "not_finite":
            bad = int(np.argmax(~np.isfinite(z[own("x")]) | ~np.isfinite(d)))
            cause = "a coordinate became infinite or NaN"
            return self._of_events(z) or Finding("not_finite", cause, self.step_advice(), bad)
        if d.max(initial=0.0) > GROWTH_LIMIT * self.scale:
            return Finding("diverged", "the coordinate grows without bound", self.step_advice(), int(d.argmax()))
        if z[own("closure_error")][0] > CLOSURE_LIMIT * self.length:
            cause = "the loop closure moves too far in one step for Newton"
            return Finding("constraints_lost", cause, self.step_advice(DEAD_CENTRE))
        if found is not None:
            cause = f"the update of a step did not converge in {scheme.iteration_limit} iterations"
            return Finding("iteration_failed", cause, self._singular() or scheme.if_not_converged)
        if scheme.is_stuck(z):
            return Finding(
                "step_too_short",
                f"the least step does not meet the tolerance behind t = {scheme.reached(z):.9g} s",
                "A force or a rate may grow without bound there, or jump at a time that depends on the motion: look at "
                "the motion until then, raise the tolerance, or take a scheme with steps of one length.",
            )
        return None

    def _of_events(self, z: np.ndarray) -> Finding | None:
        """Where nothing but the value of an event is not finite."""
        layout = self.scheme.layout
        if "event_values" not in layout.sizes or not np.isfinite(z[layout.slice("x")]).all():
            return None
        bad = ~np.isfinite(z[layout.slice("event_values")])
        if not bad.any():
            return None
        name = watched_events(self.scheme)[int(np.argmax(bad))].name
        return Finding("not_finite", f"the condition of event {name} has no finite value", OF_EVENTS)

    def _closely(self, z: np.ndarray) -> Finding | None:
        if self._look.constrained:
            C = np.abs(self._look.constraints(z, self.c)[0])
            allowed = CONSTRAINT_LIMIT * np.where(self._look.lengths, self.length, 1.0)
            if not (C <= allowed).all():  # NaN is off too
                advice = self.step_advice(DEAD_CENTRE)
                return Finding("constraints_lost", "a constraint no longer holds", advice)
        if not positive_definite(self._look.mass(z, self.c)):
            return Finding("mass_not_positive", "M_hat is no longer positive definite", OF_MASS)
        return self._bent(z)

    def _bent(self, z: np.ndarray) -> Finding | None:
        """Deflections against the body's length, and turns against a radian: modes are linear."""
        if not self._bodies:
            return None
        q = self._look.coordinates(z, self.c)
        for name, columns, length, shapes, turns in self._bodies:
            moved = float(np.sqrt(np.square(shapes @ q[columns]).sum(axis=1).max())) / length
            turned = float(np.sqrt(np.square(turns @ q[columns]).sum(axis=1).max()))
            if moved > MOST_DEFLECTION or turned > MOST_TURN:
                return Finding(
                    "deflection_too_large",
                    f"{name} is bent by {moved:.2g} of its length and {turned:.2g} rad, beyond its linear modes",
                    f"{self._too_long()}Divide the body, or make it stiffer. A strut beyond its buckling load and a "
                    "spinning beam without geometric stiffening have no small answer.",
                )
        return None

    def _too_long(self) -> str:
        """What of the step is above what the last good state allows, first: a load whose own slope lets a motion
        decay within it, moving or at rest, where friction is steepest; and the scheme's limit.
        """
        if self.scheme.adaptive:
            return ""
        h, known = self.scheme.grid.h[-1], [one for one in (self._slopes(), self._slopes(moving=False)) if one]
        said = [text for slopes in known[::-1] if (text := _damper(*slopes, h))][:1]
        limits = [self.scheme.step_limit(*slopes) for slopes in known if self.scheme.limited(self.scheme.options)]
        said += [f"The {one}: the scheme needs a step below {one.h:.3g} s." for one in limits[:1] if one and h > one.h]
        return f"The step of {h:.3g} s is too long here. {' '.join(said)} " if said else ""

    def _lost_mass(self, z: np.ndarray) -> Finding | None:
        """Of a run that stopped behind z: is M_hat about to lose its sign there, seen from M_hat at the start?"""
        M_hat = self._look.mass(z, self.c)
        if self._at_start is None or not np.isfinite(M_hat).all():
            return None
        inverse = np.linalg.inv(np.linalg.cholesky(self._at_start))
        left = float(np.linalg.eigvalsh(inverse @ M_hat @ inverse.T)[0])
        if left > NEARLY_LOST:
            return None
        cause = f"M_hat has lost all but {max(left, 0.0):.2g} of what it was at the start, in one direction"
        return Finding("mass_not_positive", cause, OF_MASS)

    @cached_property
    def step_limit(self) -> float | None:
        """Of the fastest group's step at the start [s]; None where nothing limits it, or its modes are not known."""
        slopes = self._slopes(self._begun) if self.scheme.limited(self.scheme.options) else None
        limit = None if slopes is None else self.scheme.step_limit(*slopes)
        return None if limit is None else limit.h

    def _step_length(self) -> Finding | None:
        """Is the fastest group's step above the limit that the modes at the start set?"""
        scheme = self.scheme
        h = scheme.grid.h[-1]
        if self.force or self.step_limit is None or h <= self.step_limit:
            return None
        cause = f"the step {h:.3g} s of the fastest group is above its limit"
        return Finding("step_too_long", cause, self.step_advice())

    # ---- words ----------------------------------------------------------------------------------------------

    def _status(self, found: Finding | None, z: np.ndarray | None = None) -> Status | None:
        """The status that ends a run at its last good state, or at z."""
        if found is None:
            return None
        state = self.good if z is None else z
        assert state is not None
        layout = self.scheme.layout
        time = float(state[layout.slice("t0")][0] + state[layout.slice("n")][0] * self.scheme.grid.dt_L)
        return Status(found.name, time, None if found.k is None else self.model.q_i[found.k], found.cause, found.advice)

    def _increments(self, z: np.ndarray) -> np.ndarray:
        """About what each coordinate of q_i (n_i,) moves in a step."""
        return np.asarray(self.scheme.rates(z) * self.scheme.step_sizes)

    def _slopes(self, z: np.ndarray | None = None, moving: bool = True) -> tuple[np.ndarray, np.ndarray] | None:
        """A_q, A_v (n_i x n_i) of w'' = A_q w + A_v w' at z (None: the last good state), or at rest there; None if they
        are not known.
        """
        model, z = self.model, self.good if z is None else z
        if z is None or not ModeSolver.possible(model):
            return None
        seen = self.scheme.observer(z=z, c=self.c)
        q_i, rates, q_d = (np.asarray(seen[name]).ravel() for name in ("q_i", "q_i_dot", "q_d"))
        q = whole(model, q_i, q_d)
        state = State(float(seen["t"]), independent_part(model, q), rates * moving, loop_part(model, q))
        try:
            found = ModeSolver(model, self.c[: model.c_size]).slopes(state)
        except np.linalg.LinAlgError:  # M_hat is singular
            return None
        return found if all(np.isfinite(slope).all() for slope in found) else None

    def step_advice(self, below: str = "") -> str:
        """The limit at the last good state against the step, and what to do about a strong damper; below: what to say
        where the step is below the limit.
        """
        scheme = self.scheme
        if scheme.adaptive:
            return "Give a smaller tolerance."
        slopes, h = self._slopes(), scheme.grid.h[-1]
        damper = "" if slopes is None else _damper(*slopes, h)
        limited = slopes is not None and scheme.limited(scheme.options)
        limit: StepLimit | None = scheme.step_limit(*slopes) if slopes is not None and limited else None
        if limit is None:
            return damper or (f"{OUT_OF_REACH} {below}" if below else "Reduce the step.")
        text = (
            f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
            f"fastest group's step is {h:.3g} s."
        )
        if h > limit.h:
            return f"{text} {damper}".rstrip()
        if below:
            return f"{text} {below}"
        if len(scheme.grid.groups) > 1:
            return text + (
                " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
                "reduce m or dt, add damping, or use single_rate."
            )
        physical = (
            " So the growth may be physical: a spinning beam without geometric stiffening diverges, for instance."
        )
        return text + physical

    def _singular(self) -> str:
        """Advice for a scheme on all coordinates whose last good state is near a position where C_q loses rank."""
        if self.scheme.closes or not self._look.constrained or self.good is None:
            return ""
        C_q = self._look.constraints(self.good, self.c)[1][self.model.kept_rows]
        scale = np.where([entry.unit == "m" for entry in self.model.description.coordinates], 1.0, self.length)
        values = np.linalg.svd(C_q / scale, compute_uv=False)
        if not values[-1] < NEARLY_SINGULAR * values[0]:
            return ""
        return (
            "The mechanism is near a singular position, where C_q loses rank and the multipliers are not determined: "
            "take a scheme that steps over it (single_rate, rk4, dop853), or stop before it."
        )


def _damper(A_q: np.ndarray, A_v: np.ndarray, h: float) -> str:
    """Advice where a motion decays much faster than a step; else nothing."""
    decay = float((-eigenvalues(A_q, A_v).real).max(initial=0.0))
    if not decay * h > STRONG:
        return ""
    return (
        f"A damper lets a motion decay at {decay:.3g} 1/s, {decay * h:.3g} times in a step of {h:.3g} s: take radau or "
        "exponential with propagation = decaying, whose steps let such a decay die out."
    )


def positive_definite(M_hat: np.ndarray) -> bool:
    """Is M_hat (n_i x n_i) finite, and are its eigenvalues positive?"""
    with one_thread(len(M_hat)):
        return bool(np.isfinite(M_hat).all() and np.linalg.eigvalsh(M_hat)[0] > 0)


class CloseLook:
    """What the equations say at a state z (at least the scheme's part), by functions that a scheme keeps."""

    def __init__(self, model: Model, scheme: Scheme) -> None:
        self.model, self.scheme = model, scheme
        self.constrained = bool(model.constraints) and model.has("constraints")
        self.lengths = length_rows(model)

    def constraints(self, z: np.ndarray, c: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """C (n_c,) and C_q (n_c, n)."""
        model, scheme, rows = self.model, self.scheme, len(self.model.constraints)
        values = direct(scheme, "look at constraints", lambda: observed(model, scheme, "constraints", ("C", "C_q")))(
            z, c
        )
        return values[:rows], values[rows:].reshape(-1, rows).T

    def mass(self, z: np.ndarray, c: np.ndarray) -> np.ndarray:
        """M_hat (n_i, n_i); of a long tree from the kinetic energy, so that M_hat is not derived for this."""
        n, model, scheme = len(self.model.q_i), self.model, self.scheme
        if is_long_tree(model) and model.has("energy"):
            momenta = scheme.derived("momenta", lambda: _momenta(model, scheme))
            columns = np.asarray(momenta(z, c, np.hstack([np.zeros((n, 1)), np.eye(n)])))
            return np.asarray(columns[:, 1:] - columns[:, :1])

        def build() -> ca.Function:
            z, c = _symbols(scheme)
            seen = {**scheme.observer(z=z, c=c), "c": observed_constants(scheme, z, c)}
            return ca.Function("mass", [z, c], [ca.densify(model.evaluate("condensed", **seen)["M_hat"])])

        return direct(scheme, "look at mass", build)(z, c).reshape(n, n).T

    def coordinates(self, z: np.ndarray, c: np.ndarray) -> np.ndarray:
        """q (n,)."""

        def build() -> ca.Function:
            z, c = _symbols(self.scheme)
            seen = self.scheme.observer(z=z, c=c)
            return ca.Function("coordinates", [z, c], [ca.densify(joined(self.model, seen["q_i"], seen["q_d"]))])

        return direct(self.scheme, "look at coordinates", build)(z, c)


def _symbols(scheme: Scheme) -> tuple[ca.SX, ca.SX]:
    return ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)


def _momenta(model: Model, scheme: Scheme) -> ca.Function:
    """(z, c, q_i_dot) -> dT/dq_i_dot at the configuration that z shows, (n_i,): M_hat q_i_dot, and a constant part."""
    (z, c), rates = _symbols(scheme), ca.SX.sym("v", len(model.q_i))
    seen, constants = scheme.observer(z=z, c=c), observed_constants(scheme, z, c)
    equations = StageEquations(model, constants)
    at = {"q_i": seen["q_i"], "q_d": seen["q_d"], "q_i_dot": rates, "t": seen["t"]}
    q_d_dot = equations.call("velocities", **at)["q_d_dot"] if model.q_d else ca.SX(0, 1)
    q, q_dot = equations.joined(seen["q_i"], seen["q_d"]), equations.joined(rates, q_d_dot)
    kinetic = equations.call("energy", q=q, q_dot=q_dot, t=seen["t"])["kinetic"]
    return ca.Function("momenta", [z, c, rates], [ca.densify(ca.gradient(kinetic, rates))])


def observed(model: Model, scheme: Scheme, name: str, outputs: Sequence[str]) -> ca.Function:
    """(z, c) -> outputs of a kernel of (q, q_dot, t) at the state that z shows; built once for a scheme."""

    def build() -> ca.Function:
        z, c = _symbols(scheme)
        seen = scheme.observer(z=z, c=c)
        q, q_dot = joined(model, seen["q_i"], seen["q_d"]), joined(model, seen["q_i_dot"], seen["q_d_dot"])
        found = model.evaluate(name, q=q, q_dot=q_dot, t=seen["t"], c=observed_constants(scheme, z, c))
        return ca.Function(f"observed_{name}", [z, c], [ca.densify(found[output]) for output in outputs])

    return scheme.derived(f"observed {name}", build)


def observed_constants(scheme: Scheme, z: ca.SX, c: ca.SX) -> ca.SX:
    """The model's constants at a state, with the inputs that it holds."""
    return scheme.constants_at(scheme.layout.unpack(z[: scheme.layout.size]), c[: scheme.model.c_size])


def flexible_bodies(model: Model, p: np.ndarray) -> list[Body]:
    """(name, columns in q, length [m], shapes and turns of its points (points, 3, modes)) of each flexible body."""
    if not model.elastic or not model.has("geometry"):
        return []
    values = {key: np.asarray(value) for key, value in model.kernel("geometry")(p=p).items()}
    found: dict[str, list[tuple[np.ndarray, np.ndarray, np.ndarray]]] = {}
    first = 0
    for k, point in enumerate(model.description.drawing.points):
        if point.modes:
            own = slice(first, first + point.modes)
            part = values["positions"][:, k], values["shapes"][:, own], values["turns"][:, own]
            found.setdefault(point.body, []).append(part)
            first += point.modes
    bodies = []
    for name, parts in found.items():
        columns = [k for k, one in enumerate(model.description.coordinates) if one.elastic and one.owner == name]
        positions, shapes, turns = (np.array(part) for part in zip(*parts, strict=True))
        length = float(np.linalg.norm(np.ptp(positions, axis=0)))
        if length > 0:
            bodies.append((name, columns, length, shapes, turns))
    return bodies

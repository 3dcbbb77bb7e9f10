"""The equations of motion at a state, by the names of robotics: M(q) a + C(q, v) v + g(q) = tau.

Inverse dynamics gives tau of the accelerations, forward dynamics the accelerations of tau.

tau stands for generalised forces on q_i beside all loads of the scene, so M is M_hat, and C v + g is -Q_hat of Eq. (38)
with inputs as they are given (or their defaults): springs, dampers and elastic forces are in it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import at_home, dependent_part, whole
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel, refuse_reactions
from runtime.operating.given_state import closed

POSSIBLE = 1e-9  # of the largest force: what motors may leave over
PROBES = (1.0, 1e-2, 1e-4)  # N, N m: values of inputs by which their effect is seen


@dataclass(frozen=True)
class Place:
    """Arguments of the kernels at a state: q_i, q_d, c (with charts where the bodies are) and t."""

    q_i: np.ndarray
    q_d: np.ndarray
    c: np.ndarray
    t: float


class Dynamics:
    """Terms of a model's equations. q, v, a (n_i,) in the order of `model.q_i`; SI units.

    Turns in q are rotation vectors from the axes of the world, in v and a angular velocities and accelerations in axes
    of their body. near (n,): all coordinates from which loop unknowns are found, by default those of the scene's start.
    parameters: changes of parameters and inputs by name. Friction that sticks acts in joints that move, by the sign of
    their rate; joints at rest have none, but in `forward_dynamics`, where it holds what it can. Rigid stops are open,
    but in `forward_dynamics` those push that q rests on. Raises ModelError for arrays of another length, unknown names,
    and forces asked for beyond a stop; InitialStateError for q at which the loops do not close.
    """

    def __init__(self, model: EmittedModel) -> None:
        self.model = model

    @arguments()
    def place(
        self, q: Any, t: float = 0.0, parameters: Mapping[str, float] | None = None, near: np.ndarray | None = None
    ) -> Place:
        """The configuration with these q."""
        model, q_i = self.model, self._vector("q", q)
        if near is not None:
            near = self._vector("near", near, model.coordinates)
        c = model.constants(model.parameter_vector(parameters))
        q_d = dependent_part(model, model.initial_q if near is None else np.asarray(near, dtype=float))
        if model.q_d:
            q_d, closes = closed(model, c, t, q_i, q_d)
            if not closes:
                raise InitialStateError(f"the loops of model {model.name} do not close at this q: give another `near`")
        c, q_d = at_home(model, c, q_d)
        turns = [k for k in model.places.turns.ravel() if k < len(q_i)]
        return Place(np.where(np.isin(np.arange(len(q_i)), turns), 0.0, q_i), q_d, c, t)

    def _vector(self, name: str, values: Any, names: Sequence[str] | None = None) -> np.ndarray:
        names = self.model.q_i if names is None else names
        try:
            found = np.array(values, dtype=float)
        except (TypeError, ValueError, OverflowError, RecursionError):
            found = np.zeros(0)
        if found.shape != (len(names),) or not np.all(np.isfinite(found)):
            raise ModelError(f"{name} must be {len(names)} finite numbers, for {', '.join(names[:12])}")
        return found

    def _call(self, name: str, at: Place, v: np.ndarray, **more: Any) -> dict[str, np.ndarray]:
        """A kernel at a place and velocities."""
        given = {"q_i": at.q_i, "q_d": at.q_d, "q_i_dot": v, "t": at.t, "c": at.c, **more}
        if "q_d_dot" in self.model.kernel(name).name_in():
            given["q_d_dot"] = self.model.evaluate("velocities", **given)["q_d_dot"]
        return {key: np.asarray(value) for key, value in self.model.evaluate(name, **given).items()}

    def _condensed(self, at: Place, v: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        if self.model.element_modes.size:
            found_ = self._unlocked(at, v)
            return found_.M, found_.Q
        found = self._call("condensed", at, v)
        return found["M_hat"], found["Q_hat"].ravel()

    def _unlocked(self, at: Place, v: np.ndarray) -> Any:
        from runtime.operating.resting import unlocked

        q_d_dot = np.zeros(0)
        if self.model.q_d:
            q_d_dot = self._call("velocities", at, v)["q_d_dot"].ravel()
        state = {"q_i": at.q_i, "q_d": at.q_d, "q_i_dot": v, "q_d_dot": q_d_dot, "t": np.array(at.t)}
        return unlocked(self.model, state, at.c)

    def _held(self, at: Place, v: np.ndarray, tau: np.ndarray | None) -> np.ndarray:
        """Accelerations with what rests held by friction and stops. Raises ModelError where no choice is consistent."""
        a = self._unlocked(at, v).accelerations(tau)
        if a is None:
            raise ModelError(
                f"friction of model {self.model.name}", "no choice of what sticks is consistent at this state",
                "look at joints that share a loop",
            )  # fmt: skip
        return np.asarray(a)

    def _needed(self, at: Place, v: np.ndarray, a: np.ndarray) -> np.ndarray:
        """M a - Q_hat. Raises ModelError beyond a rigid stop."""
        if self.model.element_modes.size:
            found = self._unlocked(at, v)
            return np.asarray(found.M @ a - found.force_at(a))
        M, Q = self._condensed(at, v)
        return np.asarray(M @ a - Q)

    def mass_matrix(self, q: Any, **where: Any) -> np.ndarray:
        """M(q) (n_i, n_i)."""
        return self._condensed(self.place(q, **where), np.zeros(len(self.model.q_i)))[0]

    def gravity(self, q: Any, **where: Any) -> np.ndarray:
        """g(q) (n_i,): tau that holds the mechanism still, against weight, springs and all other loads at rest."""
        return np.asarray(-self._condensed(self.place(q, **where), np.zeros(len(self.model.q_i)))[1])

    def coriolis(self, q: Any, v: Any, **where: Any) -> np.ndarray:
        """C(q, v) v (n_i,): what tau has more because of the velocities, damping included."""
        at, v = self.place(q, **where), self._vector("v", v)
        refuse_reactions(self.model, "depends on accelerations, too", "take inverse_dynamics, or give coulomb")
        return np.asarray(self._condensed(at, 0 * v)[1] - self._condensed(at, v)[1])

    def forward_dynamics(self, q: Any, v: Any, tau: Any = None, **where: Any) -> np.ndarray:
        """a (n_i,) under the loads of the scene, and tau (n_i,) if it is given."""
        at, v = self.place(q, **where), self._vector("v", v)
        if self.model.element_modes.size:
            return self._held(at, v, None if tau is None else self._vector("tau", tau))
        if tau is None and self.model.has("forward_dynamics"):
            return self._call("forward_dynamics", at, v)["q_i_ddot"].ravel()
        M, Q = self._condensed(at, v)
        return np.asarray(np.linalg.solve(M, Q if tau is None else Q + self._vector("tau", tau)))

    def inverse_dynamics(self, q: Any, v: Any, a: Any, motors: Sequence[str] = (), **where: Any) -> np.ndarray:
        """tau (n_i,) = M a - Q_hat for the motion a; with motors, names of inputs: their values (k,), of least norm.

        Raises ModelError where these motors alone cannot make the motion, or act on it other than in proportion.
        """
        at, v, a = self.place(q, **where), self._vector("v", v), self._vector("a", a)
        if not motors:
            return self._needed(at, v, a)
        if unknown := [name for name in motors if name not in self.model.inputs]:
            raise ModelError(f"model {self.model.name} has no input {unknown[0]!r}; it has {self.model.inputs}")

        def missing(values: Any) -> np.ndarray:
            given = {**(where.get("parameters") or {}), **dict(zip(motors, values, strict=True))}
            return self._needed(self.place(q, **{**where, "parameters": given}), v, a)

        idle = missing([0.0] * len(motors))
        for size in PROBES:  # a motor at its limit gives no more: a smaller value tells what it does below
            acting = np.array([(idle - missing(size * unit)) / size for unit in np.eye(len(motors))]).T
            values = np.linalg.lstsq(acting, idle, rcond=1e-12)[0]
            largest = max(np.abs(idle).max(), np.abs(acting @ values).max(), 1e-300)
            if np.abs(missing(values)).max() <= POSSIBLE * largest:
                return np.asarray(values)
        raise ModelError(
            f"the motors {', '.join(motors)} of model {self.model.name} cannot make this motion: they are too few or "
            "at their limits, or a load is not proportional to one of them"
        )

    def jacobian(self, marker: str, q: Any, **where: Any) -> np.ndarray:
        """J (6, n_i): velocity of "body.marker" and angular velocity there are J v, both in axes of the world."""
        at, model = self.place(q, **where), self.model
        n, all_q = len(model.q_i), whole(model, at.q_i, at.q_d)
        S = np.array([self._rates(at, unit) - self._rates(at, 0 * unit) for unit in np.eye(n)]).T
        body, rho, shapes, turns, H = self._point(marker, where.get("parameters"))
        columns = [k for k, one in enumerate(model.description.coordinates) if one.elastic and one.owner == body]
        q_f, poses = all_q[columns], model.description.drawing.poses
        if body not in poses:
            return np.zeros((6, n))
        pose, slope = (np.asarray(part) for part in self._pose(poses.index(body))(all_q))
        A, moved = pose.ravel()[3:].reshape(3, 3).T, slope @ S
        rho = rho + shapes @ q_f - np.array([q_f @ H @ q_f / 2, 0.0, 0.0])
        deformed = shapes - np.outer([1.0, 0.0, 0.0], H @ q_f)
        J = np.zeros((6, n))
        for k in range(n):
            dA = moved[3:, k].reshape(3, 3).T
            spin = dA @ A.T
            J[:3, k] = moved[:3, k] + dA @ rho + A @ deformed @ S[columns, k]
            J[3:, k] = np.array([spin[2, 1], spin[0, 2], spin[1, 0]]) + A @ turns @ S[columns, k]
        return J

    def _rates(self, at: Place, v: np.ndarray) -> np.ndarray:
        """(n,) rates of all coordinates."""
        model = self.model
        q_d_dot = np.asarray(self._call("velocities", at, v)["q_d_dot"]).ravel() if model.q_d else np.zeros(0)
        return whole(model, v, q_d_dot)

    def _pose(self, column: int) -> ca.Function:
        """q -> (12) origin and rotation matrix of a body, and their derivatives by q."""

        def build() -> ca.Function:
            q = ca.SX.sym("q", len(self.model.coordinates))
            pose = self.model.evaluate("poses", q=q)["poses"][:, column]
            return ca.Function("pose", [q], [ca.densify(pose), ca.densify(ca.jacobian(pose, q))])

        return self.model.derived(f"pose_{column}", build)

    def _point(self, marker: str, parameters: Mapping[str, float] | None) -> tuple[str, Any, Any, Any, Any]:
        """Body, position (3,), shapes and turns (3, nf) and H (nf, nf) of a marker, in axes of its body."""
        points = self.model.description.drawing.points
        known = [f"{point.body}.{point.name}" if point.name else "" for point in points]
        if marker not in known or not marker:
            used = ", ".join(filter(None, known))
            raise ModelError(f"model {self.model.name} has no marker {marker!r} in use; it has {used}")
        p = self.model.parameter_vector(parameters)
        values = self.model.geometry(p)
        k = known.index(marker)
        nf, first = points[k].modes, sum(point.modes for point in points[:k])
        before = sum(point.modes**2 for point in points[:k] if point.stiffened)
        none, H = np.zeros((3, 0)), np.zeros((nf, nf))
        if points[k].stiffened:
            H = values["H"].ravel()[before : before + nf * nf].reshape(nf, nf)
        shapes, turns = (values[key][:, first : first + nf] if nf else none for key in ("shapes", "turns"))
        return points[k].body, values["positions"][:, k], shapes, turns, H

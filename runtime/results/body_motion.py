"""Motion of a flexible body in space with the forces at its markers, for the recovery of its stresses."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple, TypeVar

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.errors import ModelError
from runtime.contract.flexible import BodyMotion, MarkerForce, cross_matrix
from runtime.contract.model import EmittedModel
from runtime.engine.rows import evaluate
from runtime.results.samples import Samples

# ---- Motion of a body's frame from its saved coordinates: rotation, angular velocity and acceleration (Eq. 17).
#
# The one place of the results that knows what the coordinates of an orientation are: the angle theta in the plane,
# or Euler parameters. omega = W theta', in the body's axes.


class FrameMotion(NamedTuple):
    """N samples: A (N, 3, 3) turns body axes into the world's; omega, alpha (N, 3) in body axes; W (N, 3, n)."""

    A: np.ndarray
    omega: np.ndarray
    alpha: np.ndarray
    W: np.ndarray

    def moment(self, generalised: np.ndarray) -> np.ndarray:
        """(N, 3) moment in body axes whose virtual work is that of the forces (N, n) on theta."""
        if self.W.shape[2] == 1:
            return np.asarray(self.W[:, :, 0] * generalised)
        square = self.W @ self.W.transpose(0, 2, 1)
        return np.asarray(np.linalg.solve(square, self.W @ generalised[:, :, None])[:, :, 0])


def frame_motion(theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    """Of the angle (N, 1) of a planar body or Euler parameters (N, 4), their rates and accelerations."""
    return (_planar if theta.shape[1] == 1 else _of_parameters)(theta, theta_dot, theta_ddot)


def _planar(theta: np.ndarray, theta_dot: np.ndarray, theta_ddot: np.ndarray) -> FrameMotion:
    W = np.tile(np.eye(3)[:, 2:], (len(theta), 1, 1))
    return FrameMotion(_turn(2, theta[:, 0]), W[:, :, 0] * theta_dot, W[:, :, 0] * theta_ddot, W)


def _of_parameters(e: np.ndarray, e_dot: np.ndarray, e_ddot: np.ndarray) -> FrameMotion:
    """W = 2 [-e_v, e_0 - e_v~]; W' e' = 0. Lengths other than 1 are rounding and left out."""
    tilde = cross_matrix(e[:, 1:])
    A = np.eye(3) + 2 * (e[:, :1, None] * tilde + tilde @ tilde)
    W = 2 * np.concatenate([-e[:, 1:, None], e[:, :1, None] * np.eye(3) - tilde], axis=2)
    omega, alpha = (np.einsum("sij,sj->si", W, rate) for rate in (e_dot, e_ddot))
    return FrameMotion(A, omega, alpha, W)


def _turn(axis: int, angle: np.ndarray) -> np.ndarray:
    j, k = (axis + 1) % 3, (axis + 2) % 3
    A = np.tile(np.eye(3), (len(angle), 1, 1))
    A[:, j, j] = A[:, k, k] = np.cos(angle)
    A[:, k, j] = np.sin(angle)
    A[:, j, k] = -A[:, k, j]
    return A


# ---- What the joints and loads of a body do to it, as forces on the coordinates of its frame and as wrenches.

MAX_SAMPLES_AT_ONCE = 256  # samples at once
T = TypeVar("T")


def attached_markers(model: EmittedModel, body: str) -> dict[str, list[str]]:
    """Joints and loads on a body -> the names of their markers on it."""
    described, found = model.description, {}
    markers = {f"{body}.{marker}": marker for one in described.bodies if one.name == body for marker in one.markers}
    pairs = [(joint.name, [joint.marker_a, joint.marker_b]) for joint in described.joints]
    acting = {name for owner, name in described.load_columns if owner == body}
    pairs += [(load.name, list(load.markers.values())) for load in described.loads if load.name in acting]
    for name, references in pairs:
        own = [markers[one] for one in references if one in markers]
        if own:
            found[name] = own
    return found


def attached_forces(
    solution: Samples, body: str, frame: Sequence[int], names: Sequence[str]
) -> list[tuple[str, np.ndarray]]:
    """(name, force on the frame's coordinates (N, .)) of each joint and load; frame: columns in q.

    A name comes twice where a joint has viscous damping. Raises ModelError for a joint that sticks by friction or has
    rigid stops: what holds it then is no force of a law, and a sample does not know its mode.
    """
    model, N = solution.model, len(solution.t)
    own = {f"{name}.{what}" for name in names for what in ("friction", "limits.lower", "limits.upper")}
    held = [event for event in model.mode_events if event.name in own]
    if held:
        does = " and ".join(("sticks and slides", "opens and closes")[k] for k in sorted({bool(e.side) for e in held}))
        raise ModelError(
            f"{', '.join(sorted(event.name for event in held))} at {body}",
            f"{does}, and what holds it is not known to forces inside of the body",
            'take way="modes"',
        )
    values = {"q": solution.q, "q_dot": solution.q_dot, "t": solution.t[:, None]}
    c = model.constants(solution.parameters)
    rows = {name: [k for k, row in enumerate(model.description.constraints) if row.joint == name] for name in names}
    acting = {name: np.zeros((N, len(frame))) for name, own in rows.items() if own}
    n_c, n = len(model.constraints), len(model.coordinates)
    for first in range(0, N if acting else 0, MAX_SAMPLES_AT_ONCE):
        some = {key: value[first : first + MAX_SAMPLES_AT_ONCE] for key, value in values.items()}
        C_q = evaluate(model.kernel("constraints"), some, c)["C_q"].reshape(-1, n, n_c)
        lam = solution.lam[first : first + MAX_SAMPLES_AT_ONCE]
        for name, force in acting.items():
            part = np.einsum("sir,sr->si", C_q[:, list(frame)][:, :, rows[name]], lam[:, rows[name]])
            force[first : first + MAX_SAMPLES_AT_ONCE] = -part
    found = list(acting.items())
    columns = model.description.load_columns
    if any(owner == body for owner, _ in columns):
        forces = evaluate(model.kernel("load_forces"), values, c)["load_forces"].reshape(N, len(columns), -1)
        found += [(name, forces[:, k]) for k, (owner, name) in enumerate(columns) if owner == body]
    return found


def wrench(generalised: np.ndarray, dimension: int, frame: FrameMotion) -> np.ndarray:
    """(N, 6) force and moment about the frame origin, in body axes, of forces on its frame's coordinates (N, .)."""
    world = vectors(generalised[:, :dimension])
    turning = generalised[:, dimension : dimension + frame.W.shape[2]]
    return np.hstack([into_body(frame, world), frame.moment(turning)])


def vectors(values: np.ndarray) -> np.ndarray:
    """(N, 3) from x and y, or x, y and z."""
    return np.pad(values, ((0, 0), (0, 3 - values.shape[1])))


def into_body(frame: FrameMotion, world: np.ndarray) -> np.ndarray:
    """(N, 3) components in body axes."""
    return np.asarray(np.einsum("sji,sj->si", frame.A, world))


def poses_of(model: EmittedModel, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(N, bodies, 3) [m] and (N, bodies, 3, 3) of the drawn bodies, by one call for all q side by side."""
    count, kernel = len(model.description.drawing.poses), model.kernel("poses")
    flat = np.asarray(kernel(q=q.T)["poses"]).reshape(12, len(q), count)
    values = np.moveaxis(flat, 0, -1)  # (N, bodies, 12)
    return values[..., :3], np.swapaxes(values[..., 3:].reshape(len(q), count, 3, 3), 2, 3)


@arguments()
def body_motion(solution: Samples, body: str) -> BodyMotion:
    """Collect the motion of a flexible body in space and the forces at its markers.

    Parameters
    ----------
    solution : Solution
        N samples.
    body : str
        The body.

    Returns
    -------
    BodyMotion
        What `FlexibleBody.equilibrium_stresses()` and `section_forces()` take, at each sample.

    Raises
    ------
    ModelError
        For a body without modes or in the plane, and where one joint or load acts on it at two places.
    """
    model = solution.model
    frame, elastic = model.columns_of(body)
    if not elastic or model.description.drawing.space == "planar" or not model.has("geometry"):
        raise ModelError(f"model {model.name} has no flexible body {body!r} in space whose forces are known")
    moved = solution.q, solution.q_dot, solution.q_ddot
    motion = frame_motion(*(values[:, frame[3:]] for values in moved))
    q_f, q_f_dot, q_f_ddot = (values[:, elastic] for values in moved)
    points = {one.name: one for one in model.drawn_points(solution.parameters) if one.body == body}
    names = attached_markers(model, body)
    forces = []
    for name, generalised in attached_forces(solution, body, frame, list(names)):
        point, acting = points[one_place(name, names[name], body)], wrench(generalised, 3, motion)
        acting[:, 3:] -= np.cross(point.place + q_f @ point.shapes.T, acting[:, :3])
        forces.append(MarkerForce(point.name, point.place, acting))
    acceleration = into_body(motion, solution.q_ddot[:, frame[:3]] - np.resize(model.description.gravity or [0.0], 3))
    return BodyMotion(body, solution.t, q_f, q_f_dot, q_f_ddot, acceleration, motion.omega, motion.alpha, forces)


def one_place(name: str, places: Sequence[T], body: str) -> T:
    """Where a joint or load acts on a body. Raises ModelError where that is at two places."""
    if len(places) > 1:
        raise ModelError(
            f"{name} acts on {body} at two places, whose parts cannot be separated; divide the body or the load"
        )
    return places[0]

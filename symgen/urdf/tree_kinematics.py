"""Where the links of a robot stand, and how they move: positions, Jacobians and the mass matrix of its tree.

The joint from a link to the next one adds columns S of a twist (v of the point at the origin of the world, w), in axes
of the world; a body moves by the columns of the joints on its way from the root: J = [S_1 ... S_n]. A joint that mimics
adds its column, times the multiplier, to that of the joint it follows. M = sum J^T I J over the bodies, as Featherstone
(2008) has it.

References
----------
Featherstone, R. (2008). Rigid Body Dynamics Algorithms. Springer. Chapters 2 and 4.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NoReturn

import numpy as np

from symgen.schema.errors import SceneError, did_you_mean
from symgen.urdf.robot import TURNS_OR_SLIDES, Groups, Inertia, Pose, Robot, RobotJoint

DEGENERATE = 1e-13  # of the largest: eigenvalues of the scaled mass matrix below are zero


def skew(p: np.ndarray) -> np.ndarray:
    """The matrix (3, 3) with skew(p) @ u = p x u."""
    x, y, z = p
    return np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])


def twist(pose: Pose, axis: np.ndarray, turns: bool) -> np.ndarray:
    """(6,) of a unit rate about or along an axis of a frame: v of the point at the world's origin, w."""
    u = pose.R @ axis
    return np.concatenate([np.cross(pose.p, u), u]) if turns else np.concatenate([u, np.zeros(3)])


@dataclass(frozen=True)
class Placed:
    """A group of links at a position: its pose in the world, and J (6, n) of its twist."""

    pose: Pose
    J: np.ndarray


class RobotTree:
    """The tree of a robot; q (n,) holds coordinates of joints that turn or slide and mimic no other one [rad, m]."""

    def __init__(self, robot: Robot, groups: Groups, free: bool) -> None:
        """free: the root moves, too, by six rates that have no coordinate in q."""
        self.robot, self.groups, self._free = robot, groups, free
        self.columns: dict[str, int] = {}  # joint -> its first column of J
        self.names: list[str] = []  # what each column belongs to, as messages say it
        self.positions: list[str] = []  # joints that q holds
        if free:
            self._columns_of(f"link '{robot.root}'", 6)
        for joint in groups.joints:
            if joint.mimic is None:
                self.columns[joint.name] = len(self.names)
                self._columns_of(f"joint '{joint.name}'", {"floating": 6, "planar": 3}.get(joint.type, 1))
                self.positions += [joint.name] * (joint.type in TURNS_OR_SLIDES)

    def _columns_of(self, name: str, count: int) -> None:
        self.names += [name] * count

    def placed(self, q: np.ndarray) -> dict[str, Placed]:
        """All groups at q, where joints of other types are at zero."""
        n, values = len(self.names), dict(zip(self.positions, q, strict=True))
        root = Placed(Pose(), np.zeros((6, n)))
        if self._free:
            root.J[:, :6] = np.eye(6)
        found = {self.robot.root: root}
        for joint in self.groups.joints:  # parents first
            seat = self.groups.seats[joint.parent]
            parent = found[seat.group]
            place = parent.pose.then(seat.pose)
            J, value = parent.J.copy(), 0.0
            name, factor = joint.name, 1.0
            if joint.mimic is not None:
                name, factor, value = self._leader(joint)
                value += factor * values[name]
            elif joint.name in values:
                value = values[joint.name]
            zero = place.then(joint.pose)
            for k, column in enumerate(_twists(joint, zero)):
                J[:, self.columns[name] + k] += factor * column
            found[joint.child] = Placed(place.then(joint.at(value)) if joint.type in TURNS_OR_SLIDES else zero, J)
        return found

    def _leader(self, joint: RobotJoint) -> tuple[str, float, float]:
        """(the joint that is followed at last, multiplier, offset) of a joint that mimics, also over several."""
        joints, factor, offset = {one.name: one for one in self.groups.joints}, 1.0, 0.0
        for _ in joints:
            if joint.mimic is None:
                return joint.name, factor, offset
            offset += factor * joint.mimic.offset
            factor *= joint.mimic.multiplier
            joint = joints[joint.mimic.joint]
        raise SceneError(f"joint '{joint.name}'", "mimics itself over others", "let one of them move by itself")

    def mass_matrix(self, q: np.ndarray, inertias: Mapping[str, Inertia]) -> np.ndarray:
        """M (n, n) of bodies with these inertias, by group."""
        M = np.zeros((len(self.names), len(self.names)))
        for group, one in self.placed(q).items():
            if group in inertias:
                M += one.J.T @ spatial_inertia(inertias[group].in_frame(one.pose)) @ one.J
        return M

    def undetermined(self, inertias: Mapping[str, Inertia]) -> list[str]:
        """What no inertia determines the acceleration of, at a position without symmetries; [] where M is regular.

        M is scaled to a diagonal of one, so that units and sizes are the same for all.
        """
        if not self.names:
            return []
        q = np.array([0.4 + 0.7 * ((0.618 * k) % 1.0) for k in range(len(self.positions))])
        M = self.mass_matrix(q, inertias)
        size = np.sqrt(np.abs(np.diag(M)))
        if none := [name for name, one in zip(self.names, size, strict=True) if one == 0]:
            return list(dict.fromkeys(none))
        values, vectors = np.linalg.eigh(M / np.outer(size, size))
        if abs(values[0]) > DEGENERATE * values[-1]:
            return []
        share = np.abs(vectors[:, 0])
        return list(dict.fromkeys(name for name, one in zip(self.names, share, strict=True) if one > 0.1 * share.max()))


def _twists(joint: RobotJoint, zero: Pose) -> list[np.ndarray]:
    """The columns of a joint, whose child stands at `zero` where the joint is at zero."""
    if joint.type in TURNS_OR_SLIDES:
        return [twist(zero, joint.axis, joint.type != "prismatic")]
    if joint.type == "planar":
        sides = np.linalg.svd(joint.axis[None, :])[2][1:]
        return [*(twist(zero, side, False) for side in sides), twist(zero, joint.axis, True)]
    return list(np.eye(6))


def spatial_inertia(inertia: Inertia) -> np.ndarray:
    """(6, 6) about the origin of the axes in which the inertia is seen, by (v, w)."""
    m, c = inertia.mass, skew(inertia.center)
    I_o = inertia.tensor - m * c @ c
    return np.block([[m * np.eye(3), -m * c], [m * c, I_o]])


class RobotKinematics:
    """Positions and Jacobians of a robot's links, without inertia and without a derivation.

    coordinates: "joint" by joint, the order of q (n,) [rad, m]; joints that mimic follow. limits: joint -> its ends
    (lower, upper), infinite where the file has none. Positions and axes are those of the root link's frame. Joints that
    were added to the scene, as those that close loops, are not in it.
    """

    def __init__(self, robot: Robot, groups: Groups, file: str) -> None:
        self._tree = RobotTree(robot, groups, free=False)
        self._file = file
        if others := [joint.name for joint in groups.joints if joint.type not in TURNS_OR_SLIDES]:
            item, problem = f"{file}: joint '{others[0]}'", "neither turns nor slides about one axis"
            raise SceneError(item, f"{problem}, which kinematics alone do not have", "derive the model of the robot")
        self.coordinates = self._tree.positions
        limits = {joint.name: joint.limit for joint in groups.joints if joint.mimic is None}
        self.limits = {
            name: (
                -np.inf if limits[name].lower is None else limits[name].lower,
                np.inf if limits[name].upper is None else limits[name].upper,
            )
            for name in self.coordinates
        }

    def pose(self, link: str, q: Any) -> tuple[np.ndarray, np.ndarray]:
        """Where a link stands.

        Parameters
        ----------
        link : name of a link of the file
        q : (n,) [rad, m]
            In the order of `coordinates`.

        Returns
        -------
        R : (3, 3)
            The axes of the link's frame, by columns.
        p : (3,) [m]
            Its origin.

        Raises
        ------
        SceneError
            For a link that is not there, and for other than n finite numbers.
        """
        found = self._placed(link, q)[1]
        return found.R, found.p

    def position(self, link: str, q: Any, point: Any = (0.0, 0.0, 0.0)) -> np.ndarray:
        """(3,) [m] of a point (3,) [m] of a link's frame. Raises SceneError as `pose`."""
        found = self._placed(link, q)[1]
        return np.asarray(found.p + found.R @ np.asarray(point, dtype=float))

    def jacobian(self, link: str, q: Any, point: Any = (0.0, 0.0, 0.0)) -> np.ndarray:
        """J (6, n): velocity [m/s] of a point (3,) [m] of a link's frame, and angular velocity [rad/s], are J q_dot.

        Both in axes of the root link. Raises SceneError as `pose`.
        """
        J, pose = self._placed(link, q)
        p = pose.p + pose.R @ np.asarray(point, dtype=float)
        return np.vstack([J[:3] - skew(p) @ J[3:], J[3:]])

    def _placed(self, link: str, q: Any) -> tuple[np.ndarray, Pose]:
        """(J of the twist, the pose of the link's frame)."""
        if link not in self._tree.groups.seats:
            self._refuse(f"link '{link}'", "does not exist", did_you_mean(link, self._tree.groups.seats))
        try:
            values = np.array(q, dtype=float)
        except (TypeError, ValueError):
            values = np.zeros((0, 0))
        if values.shape != (len(self.coordinates),) or not np.all(np.isfinite(values)):
            self._refuse(
                "q", f"is not {len(self.coordinates)} finite numbers", f"for {', '.join(self.coordinates[:12])}"
            )
        seat = self._tree.groups.seats[link]
        found = self._tree.placed(values)[seat.group]
        return found.J, found.pose.then(seat.pose)

    def _refuse(self, item: str, problem: str, remedy: str) -> NoReturn:
        raise SceneError(f"{self._file}: {item}", problem, remedy)

"""The scene of a robot: a body for each group of links, a joint for each that moves, an input for each motor."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any, Literal

import numpy as np

from symgen.joints import JOINTS
from symgen.joints.joint import Turn
from symgen.scene.builder import SceneBuilder
from symgen.schema.errors import did_you_mean
from symgen.urdf.document import read_document
from symgen.urdf.flexible_links import FlexibleLink, flexible_link
from symgen.urdf.groups import groups_of, inertia_of
from symgen.urdf.robot import Dropped, Inertia, Pose, Robot, RobotJoint, refuse, robot_of
from symgen.urdf.shapes import shapes_of

TYPES = {"continuous": "revolute", "fixed": "weld"}  # of a scene, where they are called otherwise
# of bodies, joints and markers that are there without being named
OWN_NAMES = {"ground", "origin", "center", "start", "end", "root", "root_weld"}
LONGEST = 48


class RobotBuilder(SceneBuilder):
    """The scene of a robot, to which more can be added.

    dropped: what the URDF has and the scene has not. frames: link -> the marker "body.marker" that stands for its
    frame. coordinates: joint -> names of its coordinates. efforts: joint -> names of the inputs [N m, N] that act on
    these. renamed: names of the URDF that a scene cannot have -> those in the scene.
    """

    dropped: list[Dropped]
    frames: dict[str, str]
    coordinates: dict[str, list[str]]
    efforts: dict[str, list[str]]
    renamed: dict[str, str]


def read(
    path: str | Path,
    base: Literal["fixed", "free"] = "fixed",
    flexible: Mapping[str, str | Path] | None = None,
    meshes: bool = True,
) -> RobotBuilder:
    """The scene of a URDF file under gravity of 9.81 m/s^2 against z.

    base: the root link stands on the ground or floats. flexible: link -> file of the beam or finite-element body in its
    place. meshes: draw mesh files, too (package:// is looked for above the file). Raises SceneError naming file,
    element and reason for what no scene can be made of.
    """
    if base not in ("fixed", "free"):
        refuse("base", f"is {base!r}", 'give "fixed" or "free"')
    robot = robot_of(read_document(path), Path(path).name)
    return _RobotScene(robot, Path(path), base == "free", flexible or {}, meshes).builder


class _RobotScene:
    def __init__(self, robot: Robot, path: Path, free: bool, flexible: Mapping[str, str | Path], meshes: bool) -> None:
        self.robot, self.file, self.folder, self.meshes, self.free = robot, path.name, path.parent, meshes, free
        for link in flexible.keys() - robot.links.keys():
            refuse(f"{self.file}: link '{link}'", "is not there", did_you_mean(link, robot.links))
        self.groups = groups_of(robot, flexible)
        self.floating = self._floating()
        if not (free or self.groups.joints or flexible):
            refuse(self.file, "nothing moves on a fixed base", "take a free base")
        self.names = _names([*robot.links, *(joint.name for joint in robot.joints)])
        self.links, self.joints = _split(self.names, robot)
        self.flexible = {link: flexible_link(link, self.links[link], flexible[link]) for link in flexible}
        self.builder = RobotBuilder(_plain_name(robot.name), title=robot.name[:100], space="spatial")
        self.builder.dropped, self.builder.frames = list(robot.dropped), {}
        self.builder.coordinates, self.builder.efforts = {}, {}
        given = {**self.links, **self.joints}
        self.builder.renamed = {name: own for name, own in given.items() if name != own}
        self.builder.gravity(0.0, 0.0, -9.81)
        self.on_ground = None if free or robot.root in flexible else robot.root
        self._add_bodies()
        self._add_joints()

    def _floating(self) -> dict[str, RobotJoint]:
        """Links that float by a joint of that type, which must be the root's."""
        found = {joint.child: joint for joint in self.groups.joints if joint.type == "floating"}
        for joint in found.values():
            if self.free or self.groups.seats[joint.parent].group != self.robot.root:
                refuse(
                    f"{self.file}: joint '{joint.name}'",
                    "floats, but hangs on no fixed root",
                    "only a joint of a fixed root link may float",
                )
        return found

    # ---- bodies ----------------------------------------------------------------------------------------------

    def _add_bodies(self) -> None:
        markers = self._markers()
        for group, members in self.groups.members.items():
            for link in members:
                seat = self.groups.seats[link]
                if link != group and group not in self.flexible:
                    markers[group][self.links[link]] = _marker(seat.pose)
                body = "ground" if group == self.on_ground else self.links[group]
                self.builder.frames[link] = f"{body}.{'origin' if link == group else self.links[link]}"
            if group in self.flexible:
                self._add_flexible(self.flexible[group])
            else:
                self._add_rigid(group, markers[group])

    def _markers(self) -> dict[str, dict[str, Any]]:
        """Markers of the joints on both of their bodies, by group; those on flexible links are added to these."""
        found: dict[str, dict[str, Any]] = {group: {} for group in self.groups.members}
        for joint in self.groups.joints:
            turned = Pose(_axes_with_z(joint.axis))
            seat = self.groups.seats[joint.parent]
            for group, at in ((seat.group, seat.pose.then(joint.pose)), (joint.child, Pose())):
                name, place = self.joints[joint.name], at.then(turned)
                if group in self.flexible:
                    self.flexible[group].marker(name, place)
                else:
                    found[group][name] = _marker(place)
        return found

    def _add_rigid(self, group: str, markers: dict[str, Any]) -> None:
        shapes = []
        for link in self.groups.members[group]:
            own, pose = self.robot.links[link], self.groups.seats[link].pose
            shapes += shapes_of(own, pose, self.folder, self.meshes, self.builder.dropped)
        look = {"shape": shapes} if shapes else {}
        if group == self.on_ground:
            self.builder.ground(markers=markers, **look)
            return
        inertia = inertia_of(self.robot, self.groups, group)
        self._check(group, inertia)
        I = inertia.tensor  # noqa: E741
        self.builder.rigid(
            self.links[group],
            mass=inertia.mass,
            inertia=[I[0, 0], I[1, 1], I[2, 2]],
            products=[I[0, 1], I[0, 2], I[1, 2]],
            center_of_mass=inertia.center,
            free=self._is_free(group),
            markers=markers,
            **look,
        )

    def _check(self, group: str, inertia: Inertia) -> None:
        """That the body could be: it has a mass, and moments of inertia that a mass distribution can have."""
        item, members = f"{self.file}: link '{group}'", self.groups.members[group]
        of_all = f" with {', '.join(members[1:4])} fixed to it" if len(members) > 1 else ""
        if not inertia.mass > 0:
            refuse(item, f"moves and has no mass{of_all}", "give it an inertial, or fix its joint")
        principal = np.linalg.eigvalsh(inertia.tensor)
        slack = 1e-9 * abs(principal).max()
        if principal[0] < -slack or principal[2] > principal[0] + principal[1] + slack:
            shown = ", ".join(f"{value:.4g}" for value in principal)
            refuse(item, f"no body has its moments of inertia {shown}{of_all}", "mend its inertia: none may exceed the "
                   "sum of the two others")  # fmt: skip

    def _add_flexible(self, link: FlexibleLink) -> None:
        own, builder = self.robot.links[link.link], self.builder
        lost = {"inertial": own.inertia.mass > 0, "visual": own.visuals, "collision": own.collisions}
        builder.dropped += [Dropped(what, own.name, "a flexible body is in its place") for what in lost if lost[what]]
        kind = builder.beam if link.entry["type"] == "beam" else builder.flexible
        standing = self.robot.root == link.link and not self.free
        if standing:
            link.marker("root", Pose())
        entry = {**link.entry, **({"free": True} if self._is_free(link.link) else {})}
        kind(**{key: value for key, value in entry.items() if key != "type"})
        if standing:
            builder.weld("root_weld", "ground.origin", f"{self.links[link.link]}.root")

    def _is_free(self, group: str) -> bool:
        return group in self.floating or (self.free and group == self.robot.root)

    # ---- joints ----------------------------------------------------------------------------------------------

    def _add_joints(self) -> None:
        for joint in self.groups.joints:
            name, child = self.joints[joint.name], self.links[joint.child]
            if joint.type == "floating":
                start = self.groups.seats[joint.parent].pose.then(joint.pose)
                self._float(child, start)
                continue
            parent = self.groups.seats[joint.parent].group
            a = f"{'ground' if parent == self.on_ground else self.links[parent]}.{name}"
            kind = TYPES.get(joint.type, joint.type)
            damping = {"damping": joint.damping} if joint.damping else {}
            self.builder.joint(kind, name, a, f"{child}.{name}", **damping)
            self._add_efforts(joint, name, kind)

    def _add_efforts(self, joint: RobotJoint, name: str, kind: str) -> None:
        motions = JOINTS[kind].motions or ()
        self.builder.coordinates[joint.name] = [f"{name}.{motion.name}" for motion in motions]
        self.builder.efforts[joint.name] = []
        for motion in motions:
            suffix = name if len(motions) == 1 else f"{name}_{motion.name}"
            self.builder.input(f"tau_{suffix}", unit="N m" if isinstance(motion, Turn) else "N")
            self.builder.effort(f"motor_{suffix}", f"{name}.{motion.name}", f"tau_{suffix}")
            self.builder.efforts[joint.name].append(f"tau_{suffix}")

    def _float(self, body: str, start: Pose) -> None:
        """Where a floating body starts."""
        values = {f"{body}.{axis}": float(value) for axis, value in zip("xyz", start.p, strict=True)}
        values |= {f"{body}.e{k}": float(value) for k, value in enumerate(_quaternion(start.R))}
        self.builder.initial(values)


def _split(names: list[str], robot: Robot) -> tuple[dict[str, str], dict[str, str]]:
    links = dict(zip(robot.links, names, strict=False))
    return links, {joint.name: own for joint, own in zip(robot.joints, names[len(links) :], strict=True)}


def _plain_name(name: str) -> str:
    """The nearest name that a scene takes."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)[:LONGEST]
    if not re.match(r"[A-Za-z]", plain) or keyword.iskeyword(plain) or plain in OWN_NAMES:
        plain = f"n_{plain}"
    return plain


def _names(given: list[str]) -> list[str]:
    """Names that a scene takes, each once: links and joints share their names in a spatial scene."""
    taken: set[str] = set()
    found = []
    for name in given:
        plain, k = _plain_name(name), 2
        own = plain
        while own in taken:
            own, k = f"{plain}_{k}", k + 1
        taken.add(own)
        found.append(own)
    return found


def _marker(place: Pose) -> dict[str, Any]:
    return {"position": place.p.tolist(), "axis": place.R[:, 2].tolist(), "x_axis": place.R[:, 0].tolist()}


def _axes_with_z(z: np.ndarray) -> np.ndarray:
    """Axes by columns with the third along z; for a z along the frame's own these are the frame's."""
    x = np.eye(3)[int(np.argmin(np.abs(z)))]
    x = x - z * (z @ x)
    x = x / np.linalg.norm(x)
    return np.column_stack([x, np.cross(z, x), z])


def _quaternion(R: np.ndarray) -> np.ndarray:
    """Euler parameters e0 ... e3 of a rotation matrix: the column of largest norm of 4 e e^T."""
    t, a = np.trace(R), [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]
    whole = np.zeros((4, 4))
    whole[0, 0], whole[0, 1:], whole[1:, 0] = 1 + t, a, a
    whole[1:, 1:] = R + R.T + (1 - t) * np.eye(3)
    column = whole[:, int(np.argmax(np.diag(whole)))]
    return np.asarray(column / np.linalg.norm(column) * (1.0 if column[0] >= 0 else -1.0))

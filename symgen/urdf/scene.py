"""The scene of a robot: a body for each group of links, a joint for each that moves, an input for each motor.

A link as a beam or a finite-element body: the body of a scene file, whose frame stands somewhere in the link's.

How the links look: boxes, cylinders, balls, and meshes of files that the URDF names.
"""

from __future__ import annotations

import keyword
import re
import warnings
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal, Self
from xml.etree.ElementTree import Element

import numpy as np

from runtime.contract.errors import printable
from symgen.joints import JOINTS
from symgen.joints.joint import Turn
from symgen.mechanism.builder import Scene
from symgen.scene import toml_io
from symgen.scene.appearance import MOST_TRIANGLES
from symgen.scene.bodies import quaternion_of
from symgen.scene.toml_io import read_mesh, within
from symgen.schema.errors import SceneError, did_you_mean, show
from symgen.urdf.given_inertia import impossible, inertia_faults, taken_as_given
from symgen.urdf.joint_laws import JointLaws
from symgen.urdf.robot import (
    TURNS_OR_SLIDES,
    Assumed,
    Dropped,
    Groups,
    Inertia,
    JointLimit,
    Link,
    Mimic,
    Pose,
    Robot,
    RobotJoint,
    RobotWarning,
    groups_of,
    inertia_of,
    numbers,
    pose,
    pose_of,
    raise_together,
    read_document,
    refuse,
    robot_of,
)
from symgen.urdf.shape_inertia import inertia_of_shapes
from symgen.urdf.tree_kinematics import RobotKinematics

NEAR_ORIGIN = 1e-6  # m: how far a joint of the URDF may be from the point of the body that takes it


@dataclass
class FlexibleLink:
    """entry: the body as a scene holds it, to which markers are added; at: the pose of its frame in the link's."""

    link: str
    entry: dict[str, Any]
    at: Pose

    def marker(self, name: str, place: Pose) -> None:
        """Add a marker at a pose in the link's frame. Raises SceneError where the body has no point there."""
        own = self.at.inverse().then(place)
        markers = self.entry.setdefault("markers", {})
        turned = {"axis": own.R[:, 2].tolist(), "x_axis": own.R[:, 0].tolist()}
        markers[name] = {**(self._on_beam if self.entry["type"] == "beam" else self._on_mesh)(name, own.p), **turned}

    def _on_beam(self, name: str, p: np.ndarray) -> dict[str, Any]:
        given = self.entry.get("length")
        length = float(given) if isinstance(given, int | float) else 0.0
        if not length > 0:
            self._refuse("its length is not a positive number", "give it in m")
        if abs(p[1]) > NEAR_ORIGIN or abs(p[2]) > NEAR_ORIGIN or not -NEAR_ORIGIN <= p[0] <= length + NEAR_ORIGIN:
            self._refuse(
                f"joint '{name}' is at {_shown(p)} of it, off its line of {length:g} m",
                "set xyz and rpy of [frame], or the length",
            )
        return {"at": min(max(float(p[0]) / length, 0.0), 1.0)}

    def _on_mesh(self, name: str, p: np.ndarray) -> dict[str, Any]:
        markers: dict[str, Any] = {**self.entry["markers"], "origin": {}}  # which the body has by itself
        known = {key: place for key, one in markers.items() if (place := _place(one)) is not None}
        away = {key: float(np.linalg.norm(place - p)) for key, place in known.items()}
        near = min(away, key=lambda key: away[key])
        if not away[near] <= NEAR_ORIGIN:
            nearest = f"the nearest marker, '{near}', is {away[near]:.3g} m away"
            self._refuse(f"it has no marker at {_shown(p)}, where joint '{name}' is; {nearest}", "attach a point there")
        return dict(markers[near])

    def _refuse(self, problem: str, remedy: str) -> None:
        raise SceneError(f"flexible link '{self.link}'", problem, remedy)


def _place(marker: Any) -> np.ndarray | None:
    """Of a marker whose position is numbers; what else is wrong with others the scene will say."""
    try:
        return np.array(marker.get("position", (0, 0, 0)), dtype=float).reshape(3)
    except (ValueError, TypeError, AttributeError):
        return None


def _shown(p: np.ndarray) -> str:
    return f"({', '.join(f'{value:.6g}' for value in p)})"


def flexible_link(link: str, name: str, path: str | Path) -> FlexibleLink:
    """From a file with one beam or flexible body in `[[bodies]]` and, if need be, `[frame]` with xyz [m] and rpy [rad].

    name: of the body in the scene. Raises SceneError.
    """
    data = toml_io.read(path)
    bodies, frame = data.get("bodies"), data.get("frame", {})
    body = bodies[0] if isinstance(bodies, list) and len(bodies) == 1 else None
    if not isinstance(body, dict) or body.get("type") not in ("beam", "flexible"):
        raise SceneError(f"file '{path}'", "does not hold one beam or flexible body", "give one entry [[bodies]]")
    try:
        xyz, rpy = (np.array(frame.get(key, (0.0, 0.0, 0.0)), dtype=float).reshape(3) for key in ("xyz", "rpy"))
    except (ValueError, TypeError, AttributeError):
        raise SceneError(f"file '{path}'", "[frame] has no three numbers", "give xyz = [...] and rpy = [...]") from None
    if not np.all(np.isfinite([xyz, rpy])) or not isinstance(body.get("markers", {}), dict):
        raise SceneError(
            f"file '{path}'", "has numbers that are not finite, or markers that are no table", "correct it"
        )
    return FlexibleLink(link, {**body, "name": name, "markers": dict(body.get("markers", {}))}, pose(xyz, rpy))


def shapes_of(
    link: Link, seat: Pose, folders: MeshFolders, meshes: bool, dropped: list[Dropped]
) -> list[dict[str, Any]]:
    """Entries of a body's `shape`; seat: the link's pose in the body.

    Where a visual cannot be had the collision geometry stands for all visuals of the link, if it can be had.
    """
    shapes, lost = _shapes(link.name, link.visuals, seat, folders, meshes)
    dropped += lost
    solid, missing = _shapes(link.name, link.collisions, seat, folders, meshes) if lost else ([], [])
    if solid and not missing:
        return solid
    if link.collisions:
        dropped.append(Dropped("collision", link.name))
    return shapes


def _shapes(
    name: str, elements: list[Element], seat: Pose, folders: MeshFolders, meshes: bool
) -> tuple[list[dict[str, Any]], list[Dropped]]:
    found, lost = [], []
    for element in elements:
        geometry = element.find("geometry")
        kind = geometry[0] if geometry is not None and len(geometry) else None
        try:
            if kind is None:
                raise SceneError(f"link '{name}'", "its geometry is empty", "give a shape")
            if kind.tag == "mesh" and not meshes:
                raise SceneError(f"link '{name}'", "meshes were not asked for", "ask for them")
            own = seat.then(pose_of(element, f"link '{name}'"))
            place = {"position": own.p.tolist(), "axis": own.R[:, 2].tolist(), "x_axis": own.R[:, 0].tolist()}
            found.append({**_geometry(kind, f"link '{name}'", folders), **place})
        except SceneError as error:
            lost.append(Dropped(element.tag, name, f"{kind.get('filename', '') if kind is not None else ''} "
                                f"{error.problem}".strip()))  # fmt: skip
    return found, lost


def _geometry(kind: Element, item: str, folders: MeshFolders) -> dict[str, Any]:
    if kind.tag == "box":
        return {"type": "box", "size": _lengths(kind, "size", item, 3)}
    if kind.tag == "sphere":
        return {"type": "sphere", "radius": _lengths(kind, "radius", item)[0]}
    if kind.tag == "cylinder":
        return {
            "type": "cylinder",
            "radius": _lengths(kind, "radius", item)[0],
            "length": _lengths(kind, "length", item)[0],
        }
    if kind.tag != "mesh":
        raise SceneError(item, f"a {kind.tag} is not drawn", "give a box, a sphere, a cylinder or a mesh")
    mesh = read_mesh(folders.file(kind.get("filename", ""), item), item)
    if len(mesh["triangles"]) > MOST_TRIANGLES:
        problem = f"{len(mesh['triangles'])} triangles are more than {MOST_TRIANGLES}"
        raise SceneError(item, problem, "coarsen the mesh")
    vertices = np.array(mesh["vertices"]) * numbers(kind, "scale", item, "1 1 1")
    return {**mesh, "vertices": vertices.tolist()}


def _lengths(kind: Element, key: str, item: str, count: int = 1) -> list[float]:
    found = numbers(kind, key, item, "", count)
    if np.any(found <= 0):
        raise SceneError(item, f"{key} of a {kind.tag} is not positive", "give lengths above 0")
    return [float(value) for value in found]


class MeshFolders:
    """Where meshes of a URDF may lie: its folder, the package that it is in, and folders that the user names."""

    def __init__(self, folder: Path, given: Sequence[str | Path] = ()) -> None:
        own = folder.resolve()
        package = next((above for above in (own, *own.parents) if (above / "package.xml").is_file()), own)
        self.folder, self.known = folder, [*dict.fromkeys([own, package, *(Path(one).resolve() for one in given)])]

    def file(self, name: str, item: str) -> Path:
        """The file behind `package://package/rest`, `file:///...` or a path beside the URDF, its links resolved.

        A package is looked for in each folder, by its name or, where the folder is the package, without. Raises
        SceneError for a file that is in none of them.
        """
        for place in self._places(name):
            found = within(place, *self.known)
            if found is not None and found.is_file():
                return found
        problem = "is neither in the folder of the URDF nor in its package (packages=[...] names further folders)"
        raise SceneError(item, problem, "name the folder of the meshes")

    def _places(self, name: str) -> list[Path]:
        scheme, colon, rest = name.partition("://")
        if not colon:
            return [self.folder / name]
        if scheme == "file":
            return [Path(rest)]
        if scheme != "package":
            return []
        package, _, inner = rest.lstrip("/").partition("/")
        own = [known / inner for known in self.known if known.name == package]
        return [*(known / package / inner for known in self.known), *own]


TYPES = {"continuous": "revolute", "fixed": "weld"}  # of a scene, where they are called otherwise
# of bodies, joints and markers that are there without being named
OWN_NAMES = {"ground", "origin", "center", "start", "end", "root", "root_weld"}
LONGEST_NAME = 48


class RobotBuilder(Scene):
    """The scene of a robot, to which more can be added.

    dropped: what the URDF has and the scene has not. assumed: what the file lacks or contradicts, and what was taken.
    frames: link -> the marker "body.marker" that stands for its frame. coordinates: joint -> names of its coordinates.
    efforts: joint -> names of the inputs [N m, N] that act on these. limits: joint -> what the file limits. drives:
    joint -> the input [rad, m] that its coordinate follows, where the robot was read for its kinematics. renamed: names
    of the URDF that a scene cannot have -> those in the scene.
    """

    dropped: list[Dropped]
    assumed: list[Assumed]
    frames: dict[str, str]
    coordinates: dict[str, list[str]]
    efforts: dict[str, list[str]]
    limits: dict[str, JointLimit]
    drives: dict[str, str]
    renamed: dict[str, str]
    _tree: tuple[Robot, Groups, str]

    def kinematics(self) -> RobotKinematics:
        """Positions and Jacobians of the links, at once and without inertia. Raises SceneError.

        Only for robots whose joints turn or slide.
        """
        return RobotKinematics(*self._tree)

    def change_joint(self, joint: str, **fields: Any) -> Self:
        """Set fields of a joint that was read, as `scene.joint` has them; None removes one.

        Parameters
        ----------
        joint : its name in the file
        fields : such as ``damping=0.2``, ``friction={"mu": 0.1, "radius": 0.02}``, ``limits=None``

        Raises
        ------
        SceneError
            For a joint that is not there; what a field may be is checked in `build`.
        """
        if joint not in self.coordinates:
            raise SceneError(f"joint '{joint}'", "does not exist", did_you_mean(joint, self.coordinates))
        return self._change("joints", self.renamed.get(joint, joint), fields)


@dataclass(frozen=True)
class ReadOptions:
    """What of a file becomes part of the scene; the fields are those of `read`."""

    free: bool
    flexible: Mapping[str, str | Path]
    meshes: bool
    packages: Sequence[str | Path]
    as_given: bool
    kinematics: bool
    density: float | None
    laws: JointLaws


def read(
    path: str | Path,
    base: Literal["fixed", "free"] = "fixed",
    flexible: Mapping[str, str | Path] | None = None,
    meshes: bool = True,
    packages: Sequence[str | Path] = (),
    *,
    inertia: Literal["possible", "as_given"] = "possible",
    kinematics: bool = False,
    default_inertia: Literal["meshes"] | None = None,
    density: float | None = None,
    damping: bool = True,
    friction: bool = True,
    limits: bool | Mapping[str, float] = True,
    effort: bool = True,
) -> RobotBuilder:
    """Read a URDF file into a scene under gravity of 9.81 m/s^2 against z.

    Parameters
    ----------
    path : str or Path
        The file.
    base : {"fixed", "free"}
        Whether the root link stands on the ground or floats.
    flexible : mapping of str to path, optional
        Link to the file of the beam or finite-element body in its place.
    meshes : bool
        Whether to draw mesh files, too: those below the folder of the URDF or of its package, the nearest folder
        above with a package.xml.
    packages : sequence of str or Path
        Further folders whose meshes may be read.
    inertia : {"possible", "as_given"}
        "possible" refuses a body that no mass distribution has, by name; "as_given" takes it with a warning, and
        links without mass whose motion no inertia determines, for loops that are closed later.
    kinematics : bool
        Whether joints follow inputs `q_JOINT` [rad, m]; then no link needs inertia, and nothing acts.
    default_inertia : {"meshes"}, optional
        Gives links that have no inertia that of their shapes.
    density : float, optional
        Density [kg/m^3] of these shapes.
    damping, friction : bool
        Whether those of the file act; else they are in `dropped`.
    limits : bool or mapping
        Whether ends of the file are rigid stops without rebound; a mapping, such as ``{"stiffness": 1e5}``, is their
        law. A start beyond an end is moved to it.
    effort : bool
        Whether motors give no more than the effort of the file.

    Returns
    -------
    RobotBuilder
        A `Scene`, to which more can be added; `dropped` says what the URDF has and the scene has not.

    Raises
    ------
    SceneError
        Names file, element and reason for what no scene can be made of; all faults of the file at once.

    Warns
    -----
    RobotWarning
        Lists what was assumed.
    """
    if base not in ("fixed", "free"):
        refuse("base", f"is {base!r}", 'give "fixed" or "free"')
    if inertia not in ("possible", "as_given"):
        refuse("inertia", f"is {inertia!r}", 'give "possible" or "as_given"')
    if kinematics and (base == "free" or flexible):
        given = 'base="free"' if base == "free" else "flexible"
        refuse("kinematics", f"does not go with {given}", "leave one of them out")
    document, assumed = read_document(path)
    robot = robot_of(document, Path(path).name)
    robot.assumed[:0] = assumed
    laws = JointLaws(damping, friction, limits, effort) if not kinematics else JointLaws(False, False, False, False)
    of_shapes = _density(default_inertia, density)
    options = ReadOptions(
        base == "free", flexible or {}, meshes, packages, inertia == "as_given", kinematics, of_shapes, laws
    )
    found = _RobotScene(robot, Path(path), options).builder
    if found.assumed:
        lines = "".join(f"\n  {one}" for one in found.assumed)
        warnings.warn(printable(f"{Path(path).name} was taken with assumptions:{lines}"), RobotWarning, stacklevel=2)
    return found


def _density(default_inertia: str | None, density: float | None) -> float | None:
    if default_inertia not in (None, "meshes"):
        refuse("default_inertia", f"is {default_inertia!r}", 'give "meshes" and a density, or leave it out')
    if default_inertia is None:
        if density is not None:
            refuse("density", "has no effect", 'give default_inertia="meshes", too')
        return None
    if not isinstance(density, int | float) or not 0 < density < np.inf:
        refuse("density", f"is {show(density)}", "give the density of the shapes [kg/m^3], above 0")
    return float(density)


class _RobotScene:
    def __init__(self, robot: Robot, path: Path, options: ReadOptions) -> None:
        self.robot, self.file, self.options, self.free = robot, path.name, options, options.free
        flexible = options.flexible
        self.folders = MeshFolders(path.parent, options.packages)
        for link in flexible.keys() - robot.links.keys():
            refuse(f"{self.file}: link '{link}'", "does not exist", did_you_mean(link, robot.links))
        self.groups = groups_of(robot, flexible)
        self.floating = self._floating()
        if not (self.free or self.groups.joints or flexible):
            raise_together(self.file, robot.faults)
            refuse(self.file, "nothing moves on a fixed base", "take a free base")
        self.names = _names([*robot.links, *(joint.name for joint in robot.joints)])
        self.links, self.joints = _split(self.names, robot)
        self.flexible = {link: flexible_link(link, self.links[link], flexible[link]) for link in flexible}
        self.builder = RobotBuilder(_plain_name(robot.name), title=robot.name[:100], space="spatial")
        self.builder.dropped, self.builder.frames, self.builder.assumed = list(robot.dropped), {}, list(robot.assumed)
        self.builder.coordinates, self.builder.efforts, self.builder.drives = {}, {}, {}
        self.builder.limits = {joint.name: joint.limit for joint in self.groups.joints}
        self.builder._tree = robot, self.groups, self.file
        given = {**self.links, **self.joints}
        self.builder.renamed = {name: own for name, own in given.items() if name != own}
        if not options.kinematics:
            self.builder.gravity(0.0, 0.0, -9.81)
        self.on_ground = None if self.free or robot.root in flexible else robot.root
        self._check_mimics()
        self.inertias = self._inertias()
        self._add_bodies()
        self._add_joints()

    def _inertias(self) -> dict[str, Inertia]:
        """Of all groups that move as rigid bodies. Raises SceneError with all of them that cannot be."""
        moving = [group for group in self.groups.members if group != self.on_ground and group not in self.flexible]
        if self.options.density is not None:
            self._fill(moving, self.options.density)
        found = {group: inertia_of(self.robot, self.groups, group) for group in moving}
        if self.options.kinematics:
            return dict.fromkeys(found, Inertia())
        if self.options.as_given:
            self.builder.assumed += taken_as_given(found, self.groups)
            raise_together(self.file, self.robot.faults)
            return found
        complete = not self.flexible
        faults = inertia_faults(self.robot, self.groups, found, self.free, complete, self.file)
        raise_together(self.file, [*self.robot.faults, *faults])
        return found

    def _fill(self, moving: list[str], density: float) -> None:
        """Give the links of groups without inertia that of their shapes."""
        for group in moving:
            if inertia_of(self.robot, self.groups, group).mass == 0:
                for name in self.groups.members[group]:
                    link = self.robot.links[name]
                    own = inertia_of_shapes(
                        link, density, lambda kind, item: _geometry(kind, item, self.folders), self.builder.assumed
                    )
                    self.robot.links[name] = replace(link, inertia=own)

    def _check_mimics(self) -> None:
        """That joints mimic others that turn or slide, and no circle of them."""
        joints = {one.name: one for one in self.groups.joints if one.type in TURNS_OR_SLIDES}
        for joint in self.groups.joints:
            followed, one = {joint.name}, joint
            while one.mimic is not None:
                other = joints.get(one.mimic.joint)
                if other is None or other.name in followed:
                    item = f"{self.file}: joint '{joint.name}'"
                    refuse(
                        item, f"mimics '{one.mimic.joint}', which is no other joint that turns or slides", "name one"
                    )
                followed.add(other.name)
                one = other

    def _floating(self) -> dict[str, RobotJoint]:
        """Links that float by a joint of that type, which must be the root's."""
        found = {joint.child: joint for joint in self.groups.joints if joint.type == "floating"}
        for joint in found.values():
            if self.free or self.groups.seats[joint.parent].group != self.robot.root:
                refuse(
                    f"{self.file}: joint '{joint.name}'",
                    "floats, but is not attached to a fixed root",
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
            shapes += shapes_of(own, pose, self.folders, self.options.meshes, self.builder.dropped)
        look: dict[str, Any] = {"shape": shapes} if shapes else {}
        if group == self.on_ground:
            self.builder.ground(markers=markers, **look)
            return
        inertia = self.inertias[group]
        if impossible(inertia):
            look["as_given"] = True
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

    def _add_flexible(self, link: FlexibleLink) -> None:
        own, builder = self.robot.links[link.link], self.builder
        lost = {
            "inertial": own.inertia is not None and own.inertia.mass > 0,
            "visual": own.visuals,
            "collision": own.collisions,
        }
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
                if self.options.kinematics:
                    refuse(f"{self.file}: joint '{joint.name}'", "floats, which no input drives", "read the dynamics")
                start = self.groups.seats[joint.parent].pose.then(joint.pose)
                self._float(child, start)
                continue
            parent = self.groups.seats[joint.parent].group
            a = f"{'ground' if parent == self.on_ground else self.links[parent]}.{name}"
            kind, laws = TYPES.get(joint.type, joint.type), self.options.laws
            b = f"{child}.{name}"
            self.builder.joint(kind, name, a, b, **laws.fields(joint, self.builder.dropped))
            self._name_coordinates(joint, name, kind)
            if self.options.kinematics:
                self._add_drive(joint, name, a, b)
            elif joint.mimic is None:  # what drives the others is the motor of the one that they follow
                self._add_efforts(joint, name, kind)
        for joint in self.groups.joints:
            if joint.mimic is not None:
                self._add_mimic(joint, joint.mimic)

    def _add_mimic(self, joint: RobotJoint, mimic: Mimic) -> None:
        own, other = (self.builder.coordinates[name][0] for name in (joint.name, mimic.joint))
        if mimic.offset:
            self.builder.initial({own: mimic.offset})
        name = f"mimic_{self.joints[joint.name]}"
        self.builder.mimic(name, own, other, multiplier=mimic.multiplier, offset=mimic.offset)

    def _name_coordinates(self, joint: RobotJoint, name: str, kind: str) -> None:
        self.builder.coordinates[joint.name] = [f"{name}.{motion.name}" for motion in JOINTS[kind].motions or ()]
        self.builder.efforts[joint.name] = []

    def _add_drive(self, joint: RobotJoint, name: str, a: str, b: str) -> None:
        """The coordinate follows an input."""
        if joint.type not in TURNS_OR_SLIDES:
            refuse(f"{self.file}: joint '{joint.name}'", f"is {joint.type}, which no input drives", "read the dynamics")
        if joint.mimic is not None:
            return
        slides = joint.type == "prismatic"
        self.builder.input(f"q_{name}", unit="m" if slides else "rad", rates=True)
        self.builder.joint(
            f"prescribed_{'displacement' if slides else 'angle'}", f"drive_{name}", a, b, motion=f"q_{name}"
        )
        self.builder.drives[joint.name] = f"q_{name}"

    def _add_efforts(self, joint: RobotJoint, name: str, kind: str) -> None:
        motions = JOINTS[kind].motions or ()
        for motion in motions:
            suffix = name if len(motions) == 1 else f"{name}_{motion.name}"
            self.builder.input(f"tau_{suffix}", unit="N m" if isinstance(motion, Turn) else "N")
            value = self.options.laws.effort_of(joint, f"tau_{suffix}", self.builder.dropped)
            self.builder.effort(f"motor_{suffix}", f"{name}.{motion.name}", value)
            self.builder.efforts[joint.name].append(f"tau_{suffix}")

    def _float(self, body: str, start: Pose) -> None:
        """Where a floating body starts."""
        values = {f"{body}.{axis}": float(value) for axis, value in zip("xyz", start.p, strict=True)}
        values |= {f"{body}.e{k}": float(value) for k, value in enumerate(quaternion_of(start.R))}
        self.builder.initial(values)


def _split(names: list[str], robot: Robot) -> tuple[dict[str, str], dict[str, str]]:
    links = dict(zip(robot.links, names, strict=False))
    return links, {joint.name: own for joint, own in zip(robot.joints, names[len(links) :], strict=True)}


def _plain_name(name: str) -> str:
    """The nearest name that a scene takes."""
    plain = re.sub(r"\W", "_", name, flags=re.ASCII)[:LONGEST_NAME]
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

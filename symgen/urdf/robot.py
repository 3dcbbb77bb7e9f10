"""What a URDF file says of links and joints, as records; what a scene cannot hold is kept by name.

The elements of an XML file of unknown origin: no entities, no DOCTYPE, bounded size and depth.

Links that fixed joints hold together are one rigid body, in the frame of the link that comes first.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import NamedTuple, NoReturn
from xml.etree.ElementTree import Element, TreeBuilder
from xml.parsers import expat

import numpy as np

from symgen.scene.toml_io import content_of
from symgen.schema.errors import SceneError, did_you_mean, show

TURNS_OR_SLIDES = ("revolute", "continuous", "prismatic")
JOINTS = ("revolute", "continuous", "prismatic", "fixed", "floating", "planar")
MOMENT_NOISE = 1e-18  # m^2: moments of inertia a mass that come of a radius below 1 nm are a writer's rounding
SMALLEST_GYRATION = 1e-6  # radius [m]: moments of a smaller one are rounding, of either sign
MOMENTS = ("ixx", "ixy", "ixz", "iyy", "iyz", "izz")
PRODUCTS = ("ixy", "ixz", "iyz")


class RobotWarning(UserWarning):
    """Something of a robot's file was assumed, or taken although no body is like that."""


@dataclass(frozen=True)
class Dropped:
    """What the scene does not hold: `what` of the element `name`, with its values or the reason."""

    what: str
    name: str
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.what} of {self.name}" + (f": {self.detail}" if self.detail else "")


@dataclass(frozen=True)
class Assumed:
    """What the file does not say, or says in two ways, and what was taken for it."""

    item: str
    detail: str

    def __str__(self) -> str:
        return f"{self.item}: {self.detail}"


@dataclass(frozen=True)
class Pose:
    """Where a frame stands in another: axes R (3, 3) by columns, origin p (3,) [m]."""

    R: np.ndarray = field(default_factory=lambda: np.eye(3))
    p: np.ndarray = field(default_factory=lambda: np.zeros(3))

    def then(self, inner: Pose) -> Pose:
        """The pose of a frame that stands in this one."""
        return Pose(self.R @ inner.R, self.p + self.R @ inner.p)

    def inverse(self) -> Pose:
        """The outer frame seen from the inner one."""
        return Pose(self.R.T, -self.R.T @ self.p)


@dataclass(frozen=True)
class Inertia:
    """mass [kg], centre (3,) [m] and tensor (3, 3) [kg m^2] about the centre, in the axes of a frame."""

    mass: float = 0.0
    center: np.ndarray = field(default_factory=lambda: np.zeros(3))
    tensor: np.ndarray = field(default_factory=lambda: np.zeros((3, 3)))

    def in_frame(self, pose: Pose) -> Inertia:
        """The same in the frame in which its own stands at `pose`."""
        return Inertia(self.mass, pose.p + pose.R @ self.center, pose.R @ self.tensor @ pose.R.T)


def together(parts: Sequence[Inertia]) -> Inertia:
    """Of several bodies that are one, all seen in one frame, by Steiner's theorem."""
    if len(parts) == 1:
        return parts[0]
    mass = sum(part.mass for part in parts)
    center = sum((part.mass * part.center for part in parts), np.zeros(3)) / (mass or 1.0)
    tensor = np.zeros((3, 3))
    for part in parts:
        d = part.center - center
        tensor += part.tensor + part.mass * (d @ d * np.eye(3) - np.outer(d, d))
    return Inertia(mass, center, tensor)


@dataclass(frozen=True)
class Link:
    """A link: its inertia, None where the file's is faulty, and its visual and collision elements."""

    name: str
    inertia: Inertia | None
    visuals: list[Element]
    collisions: list[Element]


class JointLimit(NamedTuple):
    """Ends of the way [rad, m], the largest effort [N m, N] and rate [rad/s, m/s]; None where the file has none."""

    lower: float | None = None
    upper: float | None = None
    effort: float | None = None
    velocity: float | None = None

    @property
    def ends(self) -> dict[str, float]:
        """lower and upper, as far as they are there."""
        return {key: value for key, value in (("lower", self.lower), ("upper", self.upper)) if value is not None}


class Mimic(NamedTuple):
    """A joint follows another one: multiplier times it, plus offset [rad, m]."""

    joint: str
    multiplier: float
    offset: float


@dataclass(frozen=True)
class RobotJoint:
    """A joint of a type of JOINTS: the child's frame stands at `pose` in the parent's where the joint is at zero.

    damping [N m s/rad, N s/m]; friction: what holds it at rest and rubs as it moves [N m, N].
    """

    name: str
    type: str
    parent: str
    child: str
    pose: Pose
    axis: np.ndarray
    damping: float = 0.0
    friction: float = 0.0
    limit: JointLimit = JointLimit()
    mimic: Mimic | None = None

    def at(self, value: float) -> Pose:
        """The child's frame in the parent's where a joint that turns or slides is at `value` [rad, m]."""
        if self.type == "prismatic":
            return self.pose.then(Pose(p=value * self.axis))
        return self.pose.then(Pose(turn_about(self.axis, value)))


@dataclass
class Robot:
    """Links and joints by name in the file's order, the root link, what is not kept, and what was assumed.

    faults: of links whose inertia is None.
    """

    name: str
    links: dict[str, Link]
    joints: list[RobotJoint]
    root: str
    dropped: list[Dropped]
    assumed: list[Assumed]
    faults: list[SceneError]


def robot_of(document: Element, file: str) -> Robot:
    """The records of a `robot` element. Raises SceneError naming file and elements for what is not a tree of links."""
    if document.tag != "robot":
        refuse(file, f"has the root element {show(document.tag)}", "give a URDF file, whose root element is 'robot'")
    notes = Notes([], [], [])
    links: dict[str, Link] = {}
    joints: dict[str, RobotJoint] = {}
    faults: list[SceneError] = []  # without which there is no tree
    for element in document:
        name = element.get("name", element.get("reference", ""))
        try:
            if element.tag == "link":
                _once(file, "link", name, links)
                links[name] = _link(element, f"{file}: link '{name}'", notes)
            elif element.tag == "joint":
                _once(file, "joint", name, joints)
                joints[name] = _joint(element, f"{file}: joint '{name}'", notes)
            else:
                notes.dropped.append(Dropped(element.tag, name or "the robot"))
        except SceneError as fault:
            faults.append(fault)
    if faults:
        raise_together(file, [*faults, *notes.faults])
    try:
        root = _root(file, links, joints.values())
    except SceneError as fault:
        raise_together(file, [fault, *notes.faults])
        raise
    name = document.get("name") or "robot"
    return Robot(name, links, list(joints.values()), root, notes.dropped, notes.assumed, notes.faults)


class Notes(NamedTuple):
    """What reading leaves beside the records."""

    dropped: list[Dropped]
    assumed: list[Assumed]
    faults: list[SceneError]


def raise_together(file: str, faults: Sequence[SceneError]) -> None:
    """Raise one error that says all faults of a file; return if there are none. A single one is raised as it is."""
    if not faults:
        return
    if len(faults) == 1:
        raise faults[0]
    lines = [f"  {str(fault).removeprefix(f'{file}: ')}" for fault in faults]
    problem, rest = f"has {len(faults)} faults:", tuple(faults)
    raise SceneError(file, "\n".join([problem, *lines]), "", rest)


def _once(file: str, kind: str, name: str, known: Iterable[str]) -> None:
    if not name:
        refuse(file, f"a {kind} has no name", "give it one")
    if name in known:
        refuse(f"{file}: {kind} '{name}'", "appears twice", "rename one of them")


def refuse(item: str, problem: str, remedy: str) -> NoReturn:
    """Raise SceneError."""
    raise SceneError(item, problem, remedy)


def _root(file: str, links: dict[str, Link], joints: Iterable[RobotJoint]) -> str:
    """The link that is not a joint's child; all others hang on it."""
    parents: dict[str, RobotJoint] = {}
    for joint in joints:
        item = f"{file}: joint '{joint.name}'"
        for end in (joint.parent, joint.child):
            if end not in links:
                refuse(item, f"there is no link '{end}'", did_you_mean(end, links))
        if joint.child in parents:
            refuse(item, f"link '{joint.child}' is already the child of joint '{parents[joint.child].name}'",
                   "a URDF is a tree: close the loop by a [[joints]] entry of the scene")  # fmt: skip
        parents[joint.child] = joint
    if not links:
        refuse(file, "has no links", "expand it with xacro, if it is made of parts")
    roots = [name for name in links if name not in parents]
    if len(roots) != 1:
        problem = f"links {', '.join(roots[:6])} are no joint's child" if roots else "no link is without a parent"
        refuse(file, problem, "give one root link")
    reached = {roots[0]}
    children: dict[str, list[str]] = {}
    for joint in parents.values():
        children.setdefault(joint.parent, []).append(joint.child)
    waiting = [roots[0]]
    while waiting:
        found = children.get(waiting.pop(), [])
        reached.update(found)
        waiting += found
    if loose := [name for name in links if name not in reached]:
        refuse(f"{file}: link '{loose[0]}'", "is its own descendant", "give a tree of links")
    return roots[0]


def _link(element: Element, item: str, notes: Notes) -> Link:
    name = element.get("name", "")
    parts = _parts(element, name, ("inertial", "visual", "collision"), notes.dropped)
    inertia: Inertia | None = Inertia()
    if parts["inertial"]:
        if len(parts["inertial"]) > 1:
            notes.assumed.append(Assumed(f"link '{name}'", f"the first of its {len(parts['inertial'])} inertials"))
        try:
            inertia = _inertia(parts["inertial"][0], item, name, notes.assumed)
        except SceneError as fault:
            notes.faults.append(fault)
            inertia = None
    return Link(name, inertia, parts["visual"], parts["collision"])


def _parts(element: Element, name: str, kept: tuple[str, ...], dropped: list[Dropped]) -> dict[str, list[Element]]:
    """The children of the kinds that are kept; the others are dropped."""
    found: dict[str, list[Element]] = {tag: [] for tag in kept}
    for part in element:
        if part.tag in found:
            found[part.tag].append(part)
        else:
            given = ", ".join(f"{key} {value}" for key, value in part.attrib.items())
            dropped.append(Dropped(part.tag, name, given[:200]))
    return found


def _inertia(element: Element, item: str, name: str, assumed: list[Assumed]) -> Inertia:
    """What an `inertial` says; a mass or a tensor that is not there, and products of inertia, are zero."""
    mass, tensor = element.find("mass"), element.find("inertia")
    value = 0.0 if mass is None else _number(mass, "value", item)
    if value < 0:
        refuse(item, f"has the mass {value:g}", "give a mass that is not negative")
    if mass is None:
        assumed.append(Assumed(f"link '{name}'", "the mass 0: its inertial has none"))
    own = np.zeros((3, 3))
    if tensor is None:
        a_point = " (its mass is a point)" if value else ""
        assumed.append(Assumed(f"link '{name}'", f"no moments of inertia: its inertial has none{a_point}"))
    else:
        if absent := [key for key in PRODUCTS if key not in tensor.attrib]:
            assumed.append(Assumed(f"link '{name}'", f"{', '.join(absent)} = 0: its inertia has none"))
        xx, xy, xz, yy, yz, zz = (_number(tensor, key, item, 0.0 if key in PRODUCTS else None) for key in MOMENTS)
        own = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        own[abs(own) < MOMENT_NOISE * value] = 0.0
        if 0.0 < abs(own).max() < SMALLEST_GYRATION**2 * value:
            largest = f"{abs(own).max():.3g} kg m^2 is rounding"
            assumed.append(Assumed(f"link '{name}'", f"no moments of inertia: {largest} (its mass is a point)"))
            own = np.zeros((3, 3))
    return Inertia(value, tensor=own).in_frame(pose_of(element, item))


def _joint(element: Element, item: str, notes: Notes) -> RobotJoint:
    name, kind = element.get("name", ""), element.get("type", "")
    if kind not in JOINTS:
        refuse(item, f"is of the type {show(kind)}", did_you_mean(kind, JOINTS))
    known = ("origin", "parent", "child", "axis", "dynamics", "limit", "mimic")
    parts = _parts(element, name, known, notes.dropped)
    ends = [parts[tag][0].get("link", "") if parts[tag] else "" for tag in ("parent", "child")]
    axis = np.array([1.0, 0.0, 0.0])
    if kind not in ("fixed", "floating"):
        if parts["axis"]:
            axis = numbers(parts["axis"][0], "xyz", item, "1 0 0")
        if not (size := math.sqrt(axis @ axis)) > 1e-6:
            refuse(item, "its axis has no direction", "give a vector that is not zero")
        axis = axis / size
    damping, friction = _dynamics(parts["dynamics"], kind, name, item, notes.dropped)
    limit = _limit(parts["limit"], kind, name, item, notes.dropped)
    mimic = _mimic(parts["mimic"][0], item) if parts["mimic"] else None
    if mimic is not None and kind == "fixed":  # nothing moves there
        notes.dropped.append(Dropped("mimic", name, f"of '{mimic.joint}', by a fixed joint"))
        mimic = None
    if mimic is not None and kind not in TURNS_OR_SLIDES:
        refuse(item, f"mimics '{mimic.joint}', which a {kind} joint cannot", "remove mimic")
    own = RobotJoint(name, kind, ends[0], ends[1], pose_of(element, item), axis, damping, friction, limit, mimic)
    if mimic is None or mimic.multiplier != 0:
        return own
    notes.assumed.append(Assumed(f"joint '{name}'", f"fixed at {mimic.offset:g}: it mimics by the multiplier 0"))
    return replace(
        own, type="fixed", pose=own.at(mimic.offset), mimic=None, limit=JointLimit(), damping=0.0, friction=0.0
    )


def _dynamics(elements: list[Element], kind: str, name: str, item: str, dropped: list[Dropped]) -> tuple[float, float]:
    """Damping and friction, of joints that turn or slide."""
    if not elements:
        return 0.0, 0.0
    values = {key: _number(elements[0], key, item, 0.0) for key in ("damping", "friction")}
    for key, value in values.items():
        if value and kind not in TURNS_OR_SLIDES:
            dropped.append(Dropped(key, name, f"{value:g}, of a {kind} joint"))
            values[key] = 0.0
        elif value < 0:
            refuse(item, f"has the {key} {value:g}", "give one that is not negative")
    return values["damping"], values["friction"]


def _limit(elements: list[Element], kind: str, name: str, item: str, dropped: list[Dropped]) -> JointLimit:
    """Limits of joints that turn or slide; what is no limit, such as ends that are crossed, is dropped by name."""
    if not elements:
        return JointLimit()
    keys: tuple[str, ...] = ("lower", "upper", "effort", "velocity")
    given = {key: _number(elements[0], key, item) for key in keys if key in elements[0].attrib}
    if kind not in TURNS_OR_SLIDES:
        _drop_limit(given, name, f"of a {kind} joint", dropped)
        return JointLimit()
    ends: dict[str, float] = {key: given.pop(key) for key in keys[:2] if key in given}
    if kind == "continuous" or (len(ends) == 2 and ends["lower"] >= ends["upper"]):
        why = "a continuous joint has no ends" if kind == "continuous" else "lower is not below upper"
        _drop_limit(ends, name, why, dropped)
        ends = {}
    for key in [key for key, value in given.items() if value <= 0]:
        _drop_limit({key: given.pop(key)}, name, "no limit above 0", dropped)
    return JointLimit(**ends, **given)


def _drop_limit(given: Mapping[str, float], name: str, why: str, dropped: list[Dropped]) -> None:
    if given:
        shown = ", ".join(f"{key} {value:g}" for key, value in given.items())
        dropped.append(Dropped("limit", name, f"{shown}: {why}"))


def _mimic(element: Element, item: str) -> Mimic:
    multiplier, offset = _number(element, "multiplier", item, 1.0), _number(element, "offset", item, 0.0)
    return Mimic(element.get("joint", ""), multiplier, offset)


def turn_about(axis: np.ndarray, angle: float) -> np.ndarray:
    """R (3, 3) of a turn by an angle [rad] about a unit vector (Rodrigues)."""
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    return np.asarray(np.eye(3) + math.sin(angle) * K + (1.0 - math.cos(angle)) * K @ K)


def pose_of(element: Element, item: str) -> Pose:
    """The pose of an element's `origin`: xyz [m], and rpy [rad] about the fixed axes x, y, z in this order."""
    origin = element.find("origin")
    if origin is None:
        return Pose()
    return pose(numbers(origin, "xyz", item, "0 0 0"), numbers(origin, "rpy", item, "0 0 0"))


def pose(xyz: np.ndarray, rpy: np.ndarray) -> Pose:
    """A frame at xyz [m], turned by rpy [rad] about the fixed axes x, y, z in this order."""
    (cx, cy, cz), (sx, sy, sz) = np.cos(rpy), np.sin(rpy)
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return Pose(about_z @ about_y @ about_x, xyz)


def numbers(element: Element, key: str, item: str, default: str, count: int = 3) -> np.ndarray:
    """So many finite numbers of an attribute."""
    text = element.get(key, default)
    try:
        values = np.array([float(part) for part in text.split()])
    except ValueError:
        values = np.array([math.nan])
    if len(values) != count or not np.all(np.isfinite(values)):
        refuse(item, f"{key} of its {element.tag} is {show(text)}", f"give {count} finite numbers; expand xacro first")
    return values


def _number(element: Element, key: str, item: str, default: float | None = None) -> float:
    if default is None and key not in element.attrib:
        refuse(item, f"its {element.tag} has no {key}", "give the number")
    return float(numbers(element, key, item, str(default), 1)[0])


MAX_DEPTH = 100


def read_document(path: str | Path) -> tuple[Element, list[Assumed]]:
    """The root element of a file, and what was assumed to read it.

    Raises SceneError for what is not a regular file, no XML, too large or hostile.
    """
    item = f"file '{path}'"
    content = content_of(path, item, "a URDF file")
    begins = content.lstrip()
    assumed = []
    if len(begins) < len(content) and begins.startswith(b"<?xml"):
        assumed.append(Assumed(Path(path).name, "the white space before its XML declaration does not exist"))
        content = begins
    return parse_document(content, item), assumed


def parse_document(content: bytes, item: str) -> Element:
    """The root element of XML text."""
    builder, depth = TreeBuilder(), 0

    def begin(tag: str, attributes: dict[str, str]) -> None:
        nonlocal depth
        depth += 1
        if depth > MAX_DEPTH:
            raise SceneError(item, f"nests elements more than {MAX_DEPTH} deep", "give a URDF file")
        builder.start(tag, attributes)

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(tag)

    def refuse(*_: object) -> NoReturn:
        raise SceneError(item, "declares a document type or an entity, which URDF does not need", "remove it")

    parser = expat.ParserCreate()
    parser.StartElementHandler, parser.EndElementHandler = begin, end
    parser.StartDoctypeDeclHandler = parser.EntityDeclHandler = parser.ExternalEntityRefHandler = refuse
    try:
        parser.Parse(content, True)
    except (expat.ExpatError, ValueError, LookupError) as error:
        raise SceneError(item, f"is not XML ({error})", "give a URDF file; a xacro file is expanded first") from None
    return builder.close()


@dataclass(frozen=True)
class Seat:
    """Where a link is: in the group of which link, and at which pose in its frame."""

    group: str
    pose: Pose


@dataclass(frozen=True)
class Groups:
    """members: links of each group, its first link first; seats of all links; joints between groups, parents first."""

    members: Mapping[str, list[str]]
    seats: Mapping[str, Seat]
    joints: list[RobotJoint]


def groups_of(robot: Robot, alone: Collection[str]) -> Groups:
    """The groups of a robot; links in `alone` are groups of their own."""
    children: dict[str, list[RobotJoint]] = {}
    for joint in robot.joints:
        children.setdefault(joint.parent, []).append(joint)
    seats, members = {robot.root: Seat(robot.root, Pose())}, {robot.root: [robot.root]}
    between, waiting = [], [robot.root]
    for link in waiting:  # it grows
        for joint in children.get(link, []):
            waiting.append(joint.child)
            if joint.type == "fixed" and not {joint.parent, joint.child} & set(alone):
                seat = seats[link]
                seats[joint.child] = Seat(seat.group, seat.pose.then(joint.pose))
                members[seat.group].append(joint.child)
            else:
                between.append(joint)
                seats[joint.child], members[joint.child] = Seat(joint.child, Pose()), [joint.child]
    return Groups(members, seats, between)


def inertia_of(robot: Robot, groups: Groups, group: str) -> Inertia:
    """Of all links of a group together."""
    members = groups.members[group]
    return together([(robot.links[link].inertia or Inertia()).in_frame(groups.seats[link].pose) for link in members])

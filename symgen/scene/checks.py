"""What is wrong with a scene, in the order in which a person would mend it.

What a record can see of itself in its scene it says itself (`faults`, `Size`); here is what is seen across the parts. A
stage runs only when the stages before it found nothing, because it relies on them.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import partial
from itertools import chain
from typing import Any

import numpy as np
from numpy.typing import NDArray

from symgen.scene.attachments import with_ends
from symgen.scene.bodies import BeamBody, GroundBody, RigidBody
from symgen.scene.flexible import ModalBody, SpatialModalBody
from symgen.scene.joint_pairs import joint_pair_errors
from symgen.scene.measures import accelerated, known_late
from symgen.scene.parts import SceneParts
from symgen.scene.translate import SECTIONS, item_path
from symgen.schema.errors import SceneError, did_you_mean, raise_all
from symgen.schema.expressions import RESERVED, parse_expression
from symgen.schema.fields import Bound, Fault, Meaning, Scope, StrictModel, components_fault, quantities, sized


def check_scene(scene: SceneParts) -> None:
    """Raise SceneError with everything the first failing stage finds; return if the scene is sound."""
    for stage, sections in zip(STAGES, SECTIONS_OF_STAGES, strict=True):
        across = (error for check in stage for error in check(scene))
        raise_all(chain(across, *(_own_faults(section, scene) for section in sections)))


def _records(scene: SceneParts, section: str) -> Iterator[tuple[str, StrictModel]]:
    """The records of a section with their paths; of bodies their markers too."""
    own = getattr(scene, section)
    if isinstance(own, StrictModel):
        yield section, own
    elif isinstance(own, dict):
        yield from ((f"{section}.{name}", entry) for name, entry in own.items())
    for index, entry in enumerate(own if isinstance(own, tuple) else ()):
        path = item_path(section, index, entry.name)
        yield path, entry
        if section == "bodies":
            yield from ((f"{path}.markers.{name}", marker) for name, marker in entry.markers.items())


def _own_faults(section: str, scene: SceneParts) -> Iterator[SceneError]:
    """What the records of a section find wrong with themselves."""
    for path, record in _records(scene, section):
        yield from (_at(path, fault) for fault in record.faults(scene))


def _at(path: str, fault: Fault) -> SceneError:
    dot = "." if path and fault.key and not fault.key.startswith(".") else ""
    return SceneError(f"{path}{dot}{fault.key}", fault.problem, fault.remedy)


def gravity_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Components of the other space."""
    yield from (_at("", fault) for fault in components_fault("gravity", scene.gravity, scene))


# ---- sizes -----------------------------------------------------------------------------------------------------

MAX_COORDINATES = 6000  # a chain of 1,000 bodies in a plane has half as many, and takes 1 GB
COST = "some minutes and gigabytes to assemble: its constraints, as a full matrix, alone {:.0f} MB"
MAX_BODY_MODES = 150  # 100 take 6 s, the square of the modes in memory


def size_errors(scene: SceneParts) -> Iterator[SceneError]:
    """More coordinates, or more modes of a body, than a derivation is made for."""
    for index, body in enumerate(scene.bodies):
        if body.nf > MAX_BODY_MODES:
            yield SceneError(
                item_path("bodies", index, body.name),
                f"it has {body.nf} modes, more than {MAX_BODY_MODES}",
                "keep the modes that the motion excites; `symgen modes` lists their frequencies",
            )
    count = 0 if scene.structure is None else len(scene.structure.coordinates)
    count += sum(len(scene.frame_coordinates(body)) + body.nf for body in scene.moving_bodies)
    if count > MAX_COORDINATES:
        yield SceneError(
            "bodies",
            f"the scene has {count} coordinates, more than {MAX_COORDINATES}: it would take "
            + COST.format(8e-6 * count**2 * 2 / 3),
            "divide it, or give bodies fewer modes",
        )


# ---- names -----------------------------------------------------------------------------------------------------


def name_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Names that clash, and a scene with nothing in it or with two kinds of content."""
    for section in SECTIONS:
        yield from _duplicates(section, (entry.name for entry in getattr(scene, section)))
    yield from _duplicates("partition.groups", (group.name for group in scene.partition.groups or ()))
    for index, body in enumerate(scene.bodies):
        path = item_path("bodies", index, body.name)
        if body.name == "ground" and not isinstance(body, GroundBody):
            yield SceneError(path, "only the ground may have this name", 'rename the body, or give it type = "ground"')
        for marker in body.implicit_markers().keys() & body.markers.keys():
            yield SceneError(
                f"{path}.markers.{marker}",
                f"every {body.type} body has its own marker '{marker}'",
                "rename yours",
            )
    yield from _expression_names(scene)
    yield from _contents(scene)


def _duplicates(section: str, names: Iterable[str]) -> Iterator[SceneError]:
    seen: dict[str, int] = {}
    for index, name in enumerate(names):
        if name in seen:
            yield SceneError(
                item_path(section, index, name),
                f"the name is taken by {section}[{seen[name]}]",
                "rename one of them",
            )
        seen.setdefault(name, index)


def _expression_names(scene: SceneParts) -> Iterator[SceneError]:
    taken = {name: "the expression language" for name in RESERVED}
    entries = [(f"parameters.{name}", name) for name in scene.parameters]
    entries += [(f"inputs.{name}", part) for name, entry in scene.inputs.items() for part in entry.names(name)]
    entries += [(f"states.{name}", part) for name in scene.states for part in (name, f"{name}_dot")]
    for index, measure in enumerate(scene.measures):
        path = item_path("measures", index, measure.name)
        entries += [(path, measure.name), (path, f"{measure.name}_dot")]
    for path, name in entries:
        if name in taken and taken[name] != path:
            yield SceneError(path, f"'{name}' is already used by {taken[name]}", "choose another name")
        taken.setdefault(name, path)


def _contents(scene: SceneParts) -> Iterator[SceneError]:
    if scene.structure is None:
        if not scene.moving_bodies:
            yield SceneError("bodies", "nothing in this scene can move", "add a body, or a structure")
        return
    for section in SECTIONS:
        if getattr(scene, section):
            yield SceneError(
                section,
                "a scene with a structure has no bodies, joints, loads or measures",
                f"remove {section}",
            )
    if any(component != 0 for component in scene.gravity):
        yield SceneError("gravity", "has no effect on a structure", "remove it; give forces in structure.force")
    if scene.events:
        yield SceneError("events", "a structure has no measures to look at", "remove them, or build it from bodies")
    if scene.states:
        yield SceneError("states", "a structure has no controllers", "remove them, or build the scene from bodies")


# ---- references ------------------------------------------------------------------------------------------------


def reference_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Unknown markers, and connections from something to itself."""
    known = _known_markers(scene)
    rigid = {body.name for body in scene.bodies if isinstance(body, RigidBody)}
    for section in ("joints", "loads", "measures"):
        for index, entry in enumerate(getattr(scene, section)):
            path = item_path(section, index, entry.name)
            unknown = list(_unknown(path, entry, known))
            yield from unknown or _pair(section, path, entry, rigid)


def _known_markers(scene: SceneParts) -> dict[str, list[str]]:
    bodies = (scene.ground, *scene.moving_bodies)
    return {body.name: [*body.implicit_markers(), *body.markers] for body in bodies}


def _unknown(path: str, entry: Any, known: dict[str, list[str]]) -> Iterator[SceneError]:
    for key, reference in entry.markers.items():
        body, _, marker = reference.partition(".")
        if body not in known:
            yield SceneError(f"{path}.{key}", f"there is no body '{body}'", did_you_mean(body, known))
        elif marker not in known[body]:
            remedy = did_you_mean(marker, known[body])
            yield SceneError(f"{path}.{key}", f"body '{body}' has no marker '{marker}'", remedy)


def _pair(section: str, path: str, entry: Any, rigid: set[str]) -> Iterator[SceneError]:
    """What is wrong with the one or two ends that an entry has, whatever its type; rigid: names of bodies."""
    ends = [reference for key, reference in entry.markers.items() if key != "axes"]
    if len(ends) == 1 and section == "loads" and body_of(ends[0]) == "ground":
        yield SceneError(f"{path}.marker", "a load on the ground has no effect", "name a marker of a moving body")
    if len(ends) != 2:
        return
    first, second = ends
    if first == second:
        yield SceneError(path, f"both ends are the marker '{first}'", "name two different markers")
    elif body_of(first) == body_of(second) == "ground":
        yield SceneError(path, "both markers are on the ground", "name a marker of a moving body")
    elif section == "joints" and body_of(first) == body_of(second):
        yield SceneError(path, f"joins the body '{body_of(first)}' to itself", "name markers of two bodies")
    elif section == "loads" and {"marker_a", "marker_b"} == entry.markers.keys() and rigid >= {*map(body_of, ends)}:
        if body_of(first) == body_of(second):
            problem = f"both ends are on the rigid body '{body_of(first)}', so that nothing can move between them"
            yield SceneError(path, problem, "name markers of two bodies")


def body_of(reference: str) -> str:
    """The body of "body.marker"."""
    return reference.partition(".")[0]


# ---- connections -----------------------------------------------------------------------------------------------


class _Clusters:
    """Union-find: which names are connected."""

    def __init__(self) -> None:
        self._parent: dict[str, str] = {}

    def root(self, name: str) -> str:
        path = []
        while (parent := self._parent.get(name, name)) != name:
            path.append(name)
            name = parent
        self._parent.update(dict.fromkeys(path, name))
        return name

    def join(self, a: str, b: str) -> None:
        """Connect two names."""
        self._parent[self.root(a)] = self.root(b)


def topology_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Bodies that hang on nothing, unless free."""
    joined, touched = _Clusters(), set()
    for joint in scene.joints:
        a, b = joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0]
        joined.join(a, b)
        touched |= {a, b}
    free = {joined.root(body.name) for body in scene.moving_bodies if body.free}
    for index, body in enumerate(scene.bodies):
        held = joined.root(body.name) == joined.root("ground") or joined.root(body.name) in free
        if not held and body.name != "ground":
            problem = "has no connection to the ground" if body.name in touched else "is joined to nothing"
            yield SceneError(
                item_path("bodies", index, body.name),
                problem,
                "add a joint, or set free = true if that is meant",
            )
            free.add(joined.root(body.name))  # one error for each loose group of bodies


def loop_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Joints that need coordinates of their own, such as the turns of a screw, and so must place a body."""
    placing = {placement.joint for placement in scene.placements()}
    for index, joint in enumerate(scene.joints):
        if scene.space == "spatial" and not joint.closes_loops() and joint.name not in placing:
            yield SceneError(
                item_path("joints", index, joint.name),
                f"a {joint.type} joint needs coordinates of its own, and closes a loop of such joints alone",
                "put a joint of another type into the loop: only that can be an equation between two bodies",
            )


# ---- values ----------------------------------------------------------------------------------------------------


def value_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Expressions that do not parse, have no finite value at t = 0, or a value of the wrong sign."""
    reader = _QuantityCheck(scene)
    for path, value, meaning in scene_quantities(scene):
        try:
            reader.check(path, value, meaning)
        except SceneError as error:
            yield error


def scene_quantities(scene: SceneParts) -> Iterator[tuple[str, float | str, Meaning]]:
    """Every quantity of the scene: (item path, value, meaning)."""
    for path, value, meaning in quantities(scene, "scene"):
        yield path.removeprefix("scene."), value, meaning
    for section in SECTIONS:
        for index, entry in enumerate(getattr(scene, section)):
            yield from quantities(entry, item_path(section, index, entry.name))


WORD = re.compile(r"[A-Za-z]\w*")


class _QuantityCheck:
    def __init__(self, scene: SceneParts) -> None:
        self.switched = scene.switched_parameters()
        self.defaults, inputs = scene.parameter_defaults(), scene.input_defaults()
        tables = {name: table.symbol for name, table in scene.table_names().items()}
        self.known: dict[str, Any] = {**self.defaults, **inputs, **tables, "t": 0.0}
        states = [name for state in scene.states for name in (state, f"{state}_dot")]
        self.states = frozenset(states)
        measured = [name for measure in scene.measures for name in (measure.name, f"{measure.name}_dot")]
        self.last = {name: "" for name in accelerated(scene)}
        self.last |= {f"{name}_dot": "the rate of " for name in self.last}
        late = known_late(scene.measures) - self.last.keys()
        self.late = frozenset((*late, *(f"{name}_dot" for name in late)))
        events = [name for name in measured if name not in self.last]
        early = [name for name in events if name not in self.late]
        moving = [] if scene.structure else [part for name in scene.coordinates() for part in (name, f"{name}_dot")]
        self.names = {
            Scope.PARAMETERS: frozenset((*self.defaults, *tables)),
            Scope.TIME: frozenset((*self.defaults, *inputs, *tables, "t")),
            Scope.MEASURES: frozenset((*self.defaults, *inputs, *tables, "t", *early, *states)),
            Scope.LINE: frozenset((*self.defaults, *inputs, *tables, "t", *early, *states, "length", "rate")),
            Scope.PLACE: frozenset((*self.defaults, *inputs, *tables, "t", *early, *states, "s")),
            Scope.STATES: frozenset((*self.defaults, *inputs, *tables, "t", *early, *scene.states)),
            Scope.EVENTS: frozenset((*self.defaults, *inputs, *tables, "t", *events, *states)),
            Scope.MOTION: frozenset(
                (*self.defaults, *inputs, *tables, "t", *measured, *scene.states, *moving, *scene.angles())
            ),
        }

    def check(self, path: str, value: float | str, meaning: Meaning) -> None:
        if meaning.scope is Scope.TIME and isinstance(value, str) and self.states & set(WORD.findall(value)):
            raise SceneError(
                path, "uses a state, which would have to be driven by the mechanism's own motor",
                "let an input with rates or a filter give the motion, or a load in place of the motion",
            )  # fmt: skip
        if isinstance(value, str):
            self._refuse_accelerated(path, value, meaning.scope)
        if isinstance(value, str) and meaning.scope not in (Scope.EVENTS, Scope.MOTION):
            for name in sorted(self.late & set(WORD.findall(value))):
                raise SceneError(
                    path, f"uses '{name}', a force of a load, which is known only after all loads",
                    "write the law of that force here; events and expressions of measures may use it",
                )  # fmt: skip
        if meaning.scope is Scope.PARAMETERS and isinstance(value, str):
            for name in sorted(self.switched & set(WORD.findall(value))):
                raise SceneError(
                    path, f"uses '{name}', which an event sets during the run, and must stay as it is",
                    "let the expression of a load use it, or name another parameter here",
                )  # fmt: skip
        self._check_value(path, value, meaning)

    def _refuse_accelerated(self, path: str, value: str, scope: Scope) -> None:
        """Stresses with a normal force by equilibrium, where the motion would depend on its own accelerations."""
        for name in sorted(self.last.keys() & set(WORD.findall(value))):
            if scope is Scope.MOTION and not self.last[name]:
                continue
            what = f"uses {self.last[name]}'{name.removesuffix('_dot') if self.last[name] else name}'"
            raise SceneError(
                path, f"{what}, a stress whose normal force follows from accelerations, which are not known here",
                "give the beam axial modes, whose stretch is its normal force, or use its bending_moment",
            )  # fmt: skip

    def _check_value(self, path: str, value: float | str, meaning: Meaning) -> None:
        expression = parse_expression(value, self.names[meaning.scope], path)
        if not expression.names <= self.known.keys():
            return  # it uses measures, whose values are not known before the motion is
        number = expression.evaluate(self.known)
        wrong = {Bound.ANY: False, Bound.POSITIVE: number <= 0, Bound.NON_NEGATIVE: number < 0}[meaning.bound]
        if wrong:
            shown = f"{number!r}" if not isinstance(value, str) else f"'{value[:60]}' = {number!r}"
            raise SceneError(
                path, f"the {meaning.description} {shown} must be {meaning.bound.value}",
                meaning.remedy or f"give a value in {meaning.unit} that is {meaning.bound.value}",
            )  # fmt: skip


def damping_errors(scene: SceneParts) -> Iterator[SceneError]:
    """A damping ratio above 1, which is critical, for all modes: 2 is taken for 2 % by some."""
    for index, body in enumerate(scene.bodies):
        ratio = getattr(body, "damping_ratio", 0.0)
        if isinstance(ratio, str):
            ratio = scene.parameter_defaults().get(ratio.strip(), 0.0)
        if ratio > 1 and getattr(body, "damping_frequency", None) is None:
            yield SceneError(
                f"{item_path('bodies', index, body.name)}.damping_ratio",
                f"is {ratio:g} of critical: no mode would vibrate",
                "give a fraction, 0.02 for 2 %, or damping_frequency where it holds",
            )


# ---- matrices --------------------------------------------------------------------------------------------------

Array = NDArray[np.float64]
TOLERANCE = 1e-9


def matrix_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Matrices of modal bodies and of a structure that no mechanical system can have, at the parameters' defaults."""
    if scene.structure is not None:
        yield from _forms(scene, scene.structure, "structure")
    for index, body in enumerate(scene.bodies):
        path = item_path("bodies", index, body.name)
        if isinstance(body, ModalBody | SpatialModalBody):
            yield from (bad := list(_forms(scene, body, path)))
            if not bad and not _is_definite(body.mass_matrix(partial(_array, scene)), -TOLERANCE):
                own = "inertia" if isinstance(body, ModalBody) else "inertia_moments"
                yield SceneError(
                    path,
                    f"its mass matrix (mass, first_moment, {own}, phi_integral, ...) is not positive definite",
                    "check the integrals: they must belong to one mass distribution, taken about the frame origin",
                )
        elif isinstance(body, RigidBody) and isinstance(body.inertia, tuple) and not body.as_given:
            yield from _inertia(scene, body, path)


def _forms(scene: SceneParts, record: StrictModel, path: str) -> Iterator[SceneError]:
    """Matrices that are not what their fields say."""
    for key, given, wanted in sized(record):
        if wanted.form and (fault := _misform(wanted.form, _array(scene, given))):
            yield SceneError(f"{path}.{key}", *fault)


def _inertia(scene: SceneParts, body: RigidBody, path: str) -> Iterator[SceneError]:
    """An inertia tensor is positive semi-definite, and no principal moment exceeds the sum of the two others."""
    assert isinstance(body.inertia, tuple)
    (xx, yy, zz), (xy, xz, yz) = _array(scene, body.inertia), _array(scene, body.products)
    principal = np.linalg.eigvalsh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    slack = TOLERANCE * max(float(np.abs(principal).max()), 1e-300)
    if principal[0] < -slack or principal[2] > principal[0] + principal[1] + slack:
        yield SceneError(
            f"{path}.inertia",
            f"no body has these moments of inertia (principal ones {', '.join(f'{value:.4g}' for value in principal)})",
            "check units and signs; each must be at most the sum of the other two (as_given = true takes them)",
        )


def _array(scene: SceneParts, given: Any) -> Array:
    defaults = scene.parameter_defaults()

    def number(entry: object) -> object:
        if isinstance(entry, tuple):
            return [number(part) for part in entry]
        return entry if isinstance(entry, float) else scene.expression(str(entry), "matrix").evaluate(defaults)

    return np.array(number(given), dtype=float)


def _differs(a: Array, b: Array) -> bool:
    largest = max(float(np.abs(a).max(initial=0.0)), 1e-300)
    return bool(np.abs(a / largest - b / largest).max(initial=0.0) > TOLERANCE)


def _is_definite(value: Array, least: float) -> bool:
    """Whether all eigenvalues of the matrix, scaled to a unit diagonal, exceed ``least``.

    Scaling makes the answer independent of the units of the coordinates. A zero on the diagonal
    needs a zero row.
    """
    diagonal = value.diagonal().copy()
    empty = (diagonal == 0) & ~value.any(axis=1)
    if least >= 0 and empty.any():
        return False
    diagonal[empty] = 1.0
    if (diagonal <= 0).any():
        return False
    root = np.sqrt(diagonal)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = value / root[:, None] / root[None, :]
    if not np.isfinite(scaled).all() or np.abs(scaled).max(initial=0.0) > 1e6:
        return False
    symmetric = (scaled + scaled.T) / 2
    return bool(np.linalg.eigvalsh(symmetric).min(initial=np.inf) > least)


def _misform(form: str, value: Array) -> tuple[str, str] | None:
    """What is wrong with a matrix of this form, and what to do."""
    if form == "skew":
        fault = "is not skew-symmetric", "entry [a][b] must be minus entry [b][a]"
        return fault if _differs(value, -value.T) else None
    if _differs(value, value.T):
        row, column = np.unravel_index(np.argmax(np.abs(value / 2 - value.T / 2)), value.shape)
        entries = f"[{row}][{column}] = {value[row, column]!r}, [{column}][{row}] = {value[column, row]!r}"
        return f"is not symmetric ({entries})", "make the matrix symmetric"
    if form == "positive" and not _is_definite(value, TOLERANCE):
        return "is not positive definite", "check signs and units; every mode needs a positive mass"
    if form == "semidefinite" and not _is_definite(value, -TOLERANCE):
        return "has a negative eigenvalue", "check signs; the matrix must be positive semi-definite"
    return None


# ---- mode sets -------------------------------------------------------------------------------------------------

STATIC_SHAPES = {"welded-welded": 2, "welded-heavy": 2}  # two are more than the one that every set has


def end_shape_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Fewer modes than the ends have static shapes."""
    for index, body in enumerate(with_ends(scene).bodies):
        if not isinstance(body, BeamBody):
            continue
        for key in ("lateral", "lateral_z"):
            modes = getattr(body, key)
            least = STATIC_SHAPES.get(modes.ends, 1) if modes else 0
            if modes and modes.modes < least:
                yield SceneError(
                    f"{item_path('bodies', index, body.name)}.{key}.modes",
                    f"both ends carry moments, which takes {least} shapes, not {modes.modes}",
                    f"ask for at least {least}, or name other ends",
                )


SECTIONS_OF_STAGES = (
    ("bodies", "structure", "joints"),
    ("loads", "couplings", "initial", "partition", "simulation", "events"),
    ("measures",),
)
STAGES = (
    (size_errors, name_errors, gravity_errors),
    (reference_errors, topology_errors, value_errors, damping_errors, joint_pair_errors),
    (matrix_errors, loop_errors, end_shape_errors),
)

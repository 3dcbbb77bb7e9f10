"""Partition into groups, initial state, and how the scene is stepped.

Events: what happens when a value of the motion passes zero.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from fnmatch import fnmatchcase
from typing import Annotated, Any, Literal

from pydantic import BeforeValidator, Field, Strict, model_validator

from runtime.contract.orientations import angle_names
from runtime.contract.records import GROUPED_SCHEMES, SchemeName
from symgen.scene.translate import item_path
from symgen.schema.errors import did_you_mean
from symgen.schema.fields import (
    Coordinate,
    Fault,
    Flag,
    Meaning,
    Name,
    Number,
    Quantity,
    Scope,
    StrictModel,
)
from symgen.schema.texts import Text

MAX_STEPS = 10**9


class CoordinateGroup(StrictModel):
    """Coordinates that share a step size; names, or patterns with * and ? such as ``rod.q*``."""

    name: Name
    coordinates: tuple[Coordinate, ...]


class Partition(StrictModel):
    """Which coordinates are independent (Eq. 29) and how they are grouped, from slow to fast (Eq. 39, 72).

    stiff: which elastic coordinates and rotational springs the exponential schemes take for stiff; all by default.
    """

    independent: tuple[Coordinate, ...] | None = None
    groups: tuple[CoordinateGroup, ...] | None = None
    stiff: tuple[Coordinate, ...] | None = None

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Coordinates that are unknown, there twice or not independent, and lists without any."""
        turning = [body.name for body in scene.moving_bodies] if scene.space == "spatial" else []
        angles = [*scene.angles(), *(f"{body}.e{k}" for body in turning for k in range(4))]
        names = [*scene.coordinates(), *(f"{body}.turn_{axis}" for body in turning for axis in "xyz")]
        names = [name for name in names if name not in angles]
        for index, name in enumerate(self.independent or ()):
            key = f"independent[{index}]"
            if name in angles:
                yield _angle_fault(key, name)
            elif name not in names:
                yield unknown_coordinate(key, name, names)
            elif self.independent and name in self.independent[:index]:
                yield Fault(key, f"'{name}' appears twice", "remove one of them")
        if self.independent is not None and not self.independent:
            yield Fault("independent", "is empty", "name coordinates, or leave it out to have them chosen")
        if self.groups is not None and not self.groups:
            yield Fault("groups", "is empty", "give groups, or leave it out")
        yield from self._group_faults(names, angles)

    def _group_faults(self, names: list[str], angles: list[str]) -> Iterator[Fault]:
        owner: dict[str, str] = {}
        for index, group in enumerate(self.groups or ()):
            key = item_path("groups", index, group.name)
            if not group.coordinates:
                yield Fault(f"{key}.coordinates", "is empty", "name at least one coordinate, or remove the group")
            for position, pattern in enumerate(group.coordinates):
                item = f"{key}.coordinates[{position}]"
                found = matching(pattern, names)
                if not found and matching(pattern, angles):
                    yield _angle_fault(item, matching(pattern, angles)[0])
                elif not found:
                    yield unknown_coordinate(item, pattern, names)
                elif self.independent is not None and not set(found) & set(self.independent):
                    yield Fault(item, f"'{pattern}' is not independent", "add it to partition.independent")
                if taken := next((name for name in found if name in owner), None):
                    where = f"in group '{owner[taken]}' already"
                    yield Fault(item, f"'{taken}' is {where}", "let each coordinate belong to one group")
                owner.update(dict.fromkeys(found, group.name))


def matching(pattern: str, names: Sequence[str]) -> list[str]:
    """The names that a coordinate name or a pattern with * and ? stands for, in the order of ``names``."""
    return [name for name in names if fnmatchcase(name, pattern)]


def _angle_fault(key: str, name: str) -> Fault:
    body = name.partition(".")[0]
    problem = f"'{name}' tells an orientation at the start and in results only"
    remedy = f"the coordinates are {body}.turn_x, _y, _z, or those of the joint that places the body"
    return Fault(key, problem, remedy)


def unknown_coordinate(key: str, name: str, names: list[str], joints: Sequence[Any] = ()) -> Fault:
    """A name or a pattern that stands for no coordinate; joints: of which it may name one without coordinates."""
    problem = f"there is no coordinate '{name}'"
    if "*" in name or "?" in name:
        problem = f"the pattern '{name}' matches no coordinate"
    if name.endswith("_dot") and name.removesuffix("_dot") in names:
        own = name.removesuffix("_dot")
        return Fault(
            key,
            problem,
            f"a rate stands by its coordinate: .rates({{'{own}': ...}}), in a file [initial.rates] '{own}' = ...",
        )
    of, _, motion = name.partition(".")
    joint = next((one for one in joints if one.name == of), None)
    if joint is None or any(one.startswith(f"{of}.") for one in names):
        return Fault(key, problem, did_you_mean(name, names))
    body = joint.marker_b.partition(".")[0]
    own = ", ".join(one for one in names if one.startswith(f"{body}.")) or "those of its bodies"
    kind = "angle" if motion.startswith("angle") else "distance"
    seen = f'measure(name, "{kind}", of="{joint.marker_b}", relative_to="{joint.marker_a}")'
    return Fault(key, f"{problem}: joint '{of}' has none here", f"the coordinates are {own}; to see it write {seen}")


class InitialValue(StrictModel):
    """A starting value; ``fixed`` keeps it as it is when the initial state is made consistent."""

    value: Number
    fixed: Flag = False


def _as_initial_value(value: Any) -> Any:
    return value if isinstance(value, dict | InitialValue) else {"value": value}


InitialEntry = Annotated[InitialValue, BeforeValidator(_as_initial_value, json_schema_input_type=float | InitialValue)]


class Initial(StrictModel):
    """Starting values by coordinate name: coordinates [m, rad] and rates [m/s, rad/s]; may be partial.

    A number ``v`` is short for ``{value = v, fixed = false}`` and is stored in that form.
    """

    coordinates: dict[Coordinate, InitialEntry] = Field(default_factory=dict)
    rates: dict[Coordinate, InitialEntry] = Field(default_factory=dict)

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Unknown coordinates, and orientations that are given in two ways."""
        turning = [body.name for body in scene.moving_bodies] if scene.space == "spatial" else []
        known = {"coordinates": [*scene.coordinates(), *scene.angles()]}
        known["rates"] = [*known["coordinates"], *(f"{body}.omega_{axis}" for body in turning for axis in "xyz")]
        for section, names in known.items():
            for name in getattr(self, section):
                if name not in names:
                    yield unknown_coordinate(f"{section}['{name}']", name, names, scene.joints)
        for body in scene.euler_angles():
            yield from self._turned_twice(body)

    def _turned_twice(self, body: str) -> Iterator[Fault]:
        """An orientation, and how it turns, is given by angles, Euler parameters or angular velocities."""
        parameters = {f"{body}.e{k}" for k in range(4)}
        others = {"coordinates": parameters, "rates": parameters | {f"{body}.omega_{axis}" for axis in "xyz"}}
        for section, other in others.items():
            given = getattr(self, section).keys()
            angle, parameter = (
                next((name for name in names if name in given), "") for names in (angle_names(body), sorted(other))
            )
            if angle and parameter:
                what = "how the body is turned" if section == "coordinates" else "how the body turns"
                yield Fault(f"{section}['{angle}']", f"'{parameter}' says {what} too", "give one or the other")


class Simulation(StrictModel):
    """t_end [s]; dt [s]: the step of a scheme that is named (of its slowest group); m: ratio of each next group's.

    scheme: a stepper's name; left out it is `auto`, which chooses a method and its steps for a tolerance.
    tolerance: of the error of the motion, relative to its amplitudes, in place of dt; of `auto` 1e-3 where left out.
    seen_every [s]: time from sample to sample; left out, every step is one, or of many about a thousand.
    start: `given` takes the initial state as it is, `quasi_static` puts elastic coordinates into stable equilibrium
    with it, `quasi_static_unstable` into any; `equilibrium`: every coordinate settles but those that turn.
    """

    t_end: Number = 1.0
    dt: Number = 1e-3
    m: tuple[Annotated[int, Strict(), Field(ge=1, le=10_000)], ...] = ()
    scheme: SchemeName = "auto"
    tolerance: Annotated[float, Strict(), Field(gt=0, le=0.1)] | None = None
    seen_every: Annotated[Number, Field(ge=0)] | None = None
    start: Literal["given", "quasi_static", "quasi_static_unstable", "equilibrium"] = "given"

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Times that are none, steps that are too many, ratios that do not fit the groups of the scene."""
        for key in ("t_end", "dt"):
            if getattr(self, key) <= 0:
                yield Fault(key, f"{getattr(self, key)!r} is not positive", "give a time in s")
        steps = "dt" in self.model_fields_set or (self.scheme != "auto" and self.tolerance is None)
        if steps and self.t_end > 0 and self.dt > 0:
            if self.dt > self.t_end:
                yield Fault("dt", "is longer than the simulation", "give a step below t_end")
            elif self.t_end / MAX_STEPS > self.dt:
                yield Fault("dt", f"needs more than {MAX_STEPS:.0e} steps", "raise dt or lower t_end")
        groups = scene.partition.groups
        if groups is None:
            return  # the derivation chooses the groups and checks m then
        wanted = max(len(groups) - 1, 0)
        one_step = self.scheme not in GROUPED_SCHEMES or self.tolerance is not None
        if len(self.m) != wanted and (self.m or not one_step):
            problem = f"has {len(self.m)} step ratios for {len(groups)} groups"
            yield Fault("m", problem, f"give {wanted}: one for each group after the first, slow to fast")

    @model_validator(mode="after")
    def _ratios_of_a_scheme(self) -> Simulation:
        if self.m and self.scheme == "auto":
            raise ValueError('ratios m belong to a scheme: name it, such as scheme = "printed", or leave m out')
        return self


class DeclaredEvent(StrictModel):
    """A time at which ``when`` passes zero, rising, falling or either way; a step ends there.

    ``terminal`` ends the run. ``action`` gives inputs and parameters other values from then on, by name. For
    ``cool_down`` seconds after it has happened it is not looked for.
    """

    when: Annotated[Quantity, Meaning("value that passes zero", "any", scope=Scope.EVENTS)]
    direction: Literal["rising", "falling", "either"] = "either"
    terminal: Flag = False
    action: Annotated[dict[Name, Quantity], Meaning("value of an input", "its unit", scope=Scope.EVENTS)] = Field(
        default_factory=dict
    )
    cool_down: Annotated[Number, Field(ge=0)] = 0.0
    description: Text = ""

    def faults(self, scene: Any) -> Iterator[Fault]:
        """Actions on what is neither an input nor a parameter."""
        known = [*scene.inputs, *scene.parameters]
        for target in self.action:
            if target not in known:
                yield Fault("action", f"'{target}' is neither an input nor a parameter", did_you_mean(target, known))

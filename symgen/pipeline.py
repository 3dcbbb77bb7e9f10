"""The compiler, stage by stage. Read this file first: its stages are the folders beside it.

scene       what is there                                             checked, immutable
system      M, Q*, C, C_q, gamma in all coordinates          (20)-(28)   and the topology: the scene ends here
choice      which rows are redundant, which q dependent      (29)-(31)   along the structure, then by pivoting
            the slow-to-fast groups of q_i                   (39), (72)   and its stiff deflections
condensed   substitutions for the dependent coordinates      (32)-(38)   and accelerations of trees
kernels     named functions of (q_i, q_d, q_i_dot, q_d_dot, t, p)
tapes       straight-line code of the kernels, with all that depends on p only in `constants`
emission    the files of the model: text, manifest, page

The system is put together on CasADi SX from what these state:

algebra     templates, sparse rows, small systems, the parameter vector p
bodies      points, moments and inertia of a body            (15)-(20)
joints      all that is known of a joint type, a file each   (21)
couplings   gears, belts, racks: rows between coordinates   (21), a file each
loads       all that is known of a load type, a file each    Q_F of (20)

Names and symbols of all of them, and of the state of a time stepping scheme:

notation    the tables of names                               docs/theory/names.md

Scenes are written in, and come from, elsewhere:

schema      names, quantities, expressions, errors

modes       shapes of beams and their integrals             (15)-(20)
fe          bodies from finite elements                      (15)-(20)
urdf        robots from URDF files
scenes      the built-in scenes
cli         the command line
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import TYPE_CHECKING

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.records import BoundedQuantity, FunctionSpec, Group, Parameter
from runtime.contract.tape import Tape, no_collection
from symgen.choice.assembly import ConstraintNumbers, assembled
from symgen.choice.deflections import choose_groups, deflections_of
from symgen.choice.elimination import (
    Elimination,
    choose_loops,
    dependent_rows,
    require_redundant,
    row_scales,
    structural_pivots,
)
from symgen.condensed.condensation import Condensed, condense
from symgen.kernels.all_coordinates import geometry
from symgen.kernels.catalogue import kernel_builders, known_kernels
from symgen.kernels.kernel import Kernel, arguments_of
from symgen.kernels.specification import specification
from symgen.scene import SceneError
from symgen.system.build import System, build_system
from symgen.system.constraint import DerivationError
from symgen.system.equations import Equations, NoInertia
from symgen.system.topology import Topology
from symgen.tapes.hoisting import TapesOnDemand, hoist, unhoisted

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


@dataclass(frozen=True)
class Derived:
    """Everything the generator knows about a scene: input of the emission.

    left_out: names of functions that the scene has beside those of the tapes.
    """

    scene: SceneRecord
    topology: Topology
    system: Condensed
    dependent: list[int]
    groups: list[Group]
    initial: ConsistentState
    parameters: list[Parameter]
    bounded: list[BoundedQuantity]
    tapes: Mapping[str, Tape]
    left_out: tuple[str, ...] = ()

    @property
    def redundant(self) -> list[int]:
        """Constraint rows that the others imply, in scene order."""
        return self.system.choice.redundant

    @cached_property
    def functions(self) -> dict[str, FunctionSpec]:
        """What each function is, by name."""
        redundant = bool(self.redundant)
        return {name: specification(name, tape, self.groups, redundant) for name, tape in self.tapes.items()}


@dataclass(frozen=True)
class Configuration:
    """Where a partition is wanted: all coordinates by name, taken as they are, and the redundant rows by label."""

    coordinates: Mapping[str, float]
    redundant: frozenset[str] = frozenset()


@dataclass(frozen=True)
class _Condensation:
    """A scene with its dependent coordinates substituted: all of it but the functions."""

    scene: SceneRecord
    built: System
    system: Condensed
    groups: list[Group]
    initial: ConsistentState

    def kernels(self, functions: frozenset[str] | None) -> dict[str, Kernel]:
        """The kernels, or those of these names. Raises DerivationError."""
        builders = self.builders()
        wanted = known_kernels(self.system, builders, functions)
        return {name: build() for name, build in builders.items() if name in wanted}

    def builders(self) -> dict[str, Callable[[], Kernel]]:
        """What builds each kernel, by name; it may raise DerivationError."""
        found = kernel_builders(self.system, self.built.topology, self.groups)
        return {name: partial(self._built, build) for name, build in found.items()}

    def _built(self, build: Callable[[], Kernel]) -> Kernel:
        try:
            return build()
        except NoInertia as error:
            raise DerivationError(
                self.system.reduced.names[error.args[0]],
                "has no inertia, so its acceleration is not determined",
                "give the body an inertia, or join it so that it cannot move that way",
            ) from error

    def of_parameters(self) -> dict[str, Callable[[], Tape]]:
        """What makes the functions of p alone, by name."""
        equations, table = self.system.equations, self.built.parameters
        found: dict[str, Callable[[], Tape]] = {}
        if equations.picture.points:
            found["geometry"] = lambda: geometry(equations, table.vector()).tape()
        if table.bounded:
            values = ca.vertcat(*(value for _, value in table.bounded))
            found["bounded"] = lambda: Kernel({"p": table.vector()}, {"bounded": values}).tape()
        return found

    def derived(self, tapes: Mapping[str, Tape]) -> Derived:
        """With the tapes of the functions."""
        system, table = self.system, self.built.parameters
        dependent, bounded = arguments_of(system).dependent, [quantity for quantity, _ in table.bounded]
        return Derived(
            self.scene, self.built.topology, system, dependent, self.groups, self.initial, table.entries, bounded, tapes
        )


def derive(scene: SceneRecord, functions: frozenset[str] | None = None, at: Configuration | None = None) -> Derived:
    """Scene to kernels. `functions` limits the kernels by name (all by default).

    at: the configuration at which coordinates are chosen, the scene's assembled initial state by default.
    Raises SceneError for constraints in conflict, singular or impossible initial states and impossible partitions.
    """
    with _scene_errors(), no_collection():
        found = _condensation(scene, at)
        tapes = hoist(found.kernels(functions), found.built.parameters.vector())
        more = found.of_parameters()
        if functions is not None and "geometry" not in functions:
            more.pop("geometry", None)
        return found.derived({**tapes, **{name: make() for name, make in more.items()}})


def derive_on_demand(scene: SceneRecord) -> Derived:
    """Scene to functions that are derived one by one, each when its tape is first looked at, with c = p.

    Raises SceneError as `derive` does; what only a function shows is found when that is derived.
    """
    with _scene_errors(), no_collection():
        found = _condensation(scene, None)
    p = found.built.parameters.vector()

    def tape(build: Callable[[], Kernel]) -> Tape:
        with _scene_errors(), no_collection():
            return unhoisted(build(), p)

    constants = {"constants": Kernel({"p": p}, {"c": p}).tape}
    kernels = {name: partial(tape, build) for name, build in found.builders().items()}
    return found.derived(TapesOnDemand({**constants, **kernels, **found.of_parameters()}))


def looked_at(derived: Derived, more: Collection[str] = ()) -> Derived:
    """What `derive_on_demand` gave, with the tapes that were looked at until now, and more by name.

    Among them is always what a run with other parameters asks for first.
    """
    if not isinstance(derived.tapes, TapesOnDemand):
        return derived
    made = derived.tapes.made({"constants", "bounded", *more})
    return replace(derived, tapes=made, left_out=tuple(name for name in derived.tapes if name not in made))


@contextmanager
def _scene_errors() -> Iterator[None]:
    """What cannot be derived, as an error of the scene."""
    try:
        yield
    except DerivationError as error:
        raise SceneError(error.item, error.problem, error.remedy) from error


def _condensation(scene: SceneRecord, at: Configuration | None) -> _Condensation:
    system = build_system(scene)
    equations = system.equations
    numbers = ConstraintNumbers(equations, system.parameters)
    initial = assembled(system, numbers) if at is None else _state_at(at, equations)
    choice = _choice(system, numbers, initial.q, at)
    deflections = deflections_of(system.reduced, choice, system.requested.stiff)
    condensed = condense(equations, system.reduced, choice, deflections)
    return _Condensation(scene, system, condensed, choose_groups(system, choice.independent), initial)


def _state_at(configuration: Configuration, equations: Equations) -> ConsistentState:
    q = np.array([configuration.coordinates[name] for name in equations.names])
    return ConsistentState(q, np.zeros(len(q)), {})


def _choice(system: System, numbers: ConstraintNumbers, q: np.ndarray, at: Configuration | None) -> Elimination:
    """Redundant rows first (known for a given configuration, found otherwise), then the dependent coordinates."""
    equations = system.equations
    _, jacobian = numbers.position(q)
    scales = row_scales(jacobian)
    if system.reduced is not equations:
        _, jacobian = ConstraintNumbers(system.reduced, system.parameters).position(q)
    if at is not None:
        redundant = [k for k, row in enumerate(equations.constraints) if row.label in at.redundant]
        structural, loop_rows = structural_pivots(system, frozenset(redundant))
        return choose_loops(system, structural, loop_rows, jacobian, scales, redundant)
    structural, loop_rows = structural_pivots(system)
    redundant = dependent_rows(system.reduced, structural, loop_rows, jacobian, scales)
    if redundant:
        require_redundant(equations, numbers.position, q, redundant)
    kept = [row for row in loop_rows if row not in redundant]
    return choose_loops(system, structural, kept, jacobian, scales, redundant)

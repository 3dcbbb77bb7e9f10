"""The compiler, stage by stage. Read this file first.

scene        what is there                                     (symgen.scene)
equations    M, Q*, C, C_q, gamma in all coordinates           (20)-(28)   SymPy templates evaluated on CasADi SX
choice       which rows are redundant, which q dependent       (29)-(31)   along the structure, then by pivoting
condensed    substitutions for the dependent coordinates       (32)-(38)
groups       the slow-to-fast groups of q_i                    (39), (72)
kernels      named functions of (q_i, q_d, q_i_dot, q_d_dot, t, p)
tapes        straight-line code of the kernels, with all that depends on p only in `constants`
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.tape import Tape
from symgen.algebra.parameters import ParameterEntry, ParameterTable
from symgen.choice.assembly import ConstraintNumbers, assembled
from symgen.choice.elimination import Choice, choose_loops, dependent_rows, structural_pivots
from symgen.choice.partition import Group, choose_groups
from symgen.choice.redundancy import require_redundant
from symgen.condensed.condensation import Condensed, condense
from symgen.condensed.forward_dynamics import NoInertia
from symgen.kernels.arguments import arguments_of
from symgen.kernels.catalogue import build_kernels
from symgen.scene import Scene, SceneError
from symgen.system.build import build_equations
from symgen.system.equations import Equations
from symgen.tapes.hoisting import hoist


@dataclass(frozen=True)
class Derived:
    """Everything the generator knows about a scene: input of the emission."""

    scene: Scene
    system: Condensed
    dependent: list[int]
    groups: list[Group]
    initial: ConsistentState
    parameters: list[ParameterEntry]
    tapes: dict[str, Tape]

    @property
    def redundant(self) -> list[int]:
        """Constraint rows that the others imply, in scene order."""
        return self.system.choice.redundant


@dataclass(frozen=True)
class Position:
    """Where a partition is wanted: all coordinates by name, taken as they are, and the redundant rows by label."""

    coordinates: Mapping[str, float]
    redundant: frozenset[str] = frozenset()


def derive(scene: Scene, functions: frozenset[str] | None = None, place: Position | None = None) -> Derived:
    """Scene to kernels. `functions` limits the kernels by name (all by default).

    place: the position at which coordinates are chosen, the scene's assembled initial state by default.
    Raises SceneError for constraints in conflict, singular or impossible initial states and impossible partitions.
    """
    table = ParameterTable(scene)
    equations = build_equations(scene, table)
    numbers = ConstraintNumbers(equations, table)
    initial = assembled(scene, equations, numbers) if place is None else _at(place, equations)
    choice = _choice(scene, equations, numbers, initial.q, place)
    if not choice.independent:
        raise SceneError(
            "joints",
            "the mechanism has no degree of freedom left: every coordinate is determined",
            "remove a joint or a prescribed motion, or give a body modes",
        )
    system = condense(equations, choice)
    groups = choose_groups(scene, equations, choice.independent)
    try:
        kernels = build_kernels(system, scene, groups, functions)
    except NoInertia as error:
        raise SceneError(
            equations.names[error.args[0]],
            "has no inertia, so its acceleration is not determined",
            "give the body an inertia, or join it so that it cannot move that way",
        ) from error
    tapes = hoist(kernels, table.vector())
    return Derived(scene, system, arguments_of(system).dependent, groups, initial, table.entries, tapes)


def _at(place: Position, equations: Equations) -> ConsistentState:
    q = np.array([place.coordinates[name] for name in equations.names])
    return ConsistentState(q, np.zeros(len(q)), {})


def _choice(
    scene: Scene, equations: Equations, numbers: ConstraintNumbers, q: np.ndarray, place: Position | None
) -> Choice:
    """Redundant rows first (known for a place, found otherwise), then the dependent coordinates."""
    _, jacobian = numbers.position(q)
    if place is not None:
        redundant = [k for k, row in enumerate(equations.constraints) if row.label in place.redundant]
        structural, loop_rows = structural_pivots(equations, scene, frozenset(redundant))
        return choose_loops(equations, scene, structural, loop_rows, jacobian, redundant)
    structural, loop_rows = structural_pivots(equations, scene)
    redundant = dependent_rows(equations, structural, loop_rows, jacobian)
    if redundant:
        require_redundant(equations, numbers.position, q, redundant)
    kept = [row for row in loop_rows if row not in redundant]
    return choose_loops(equations, scene, structural, kept, jacobian, redundant)

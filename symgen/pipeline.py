"""The compiler, stage by stage. Read this file first.

    scene        what is there                                     (symgen.scene)
    equations    M, Q*, C, C_q, gamma in all coordinates           (20)-(28)   SymPy templates evaluated on CasADi SX
    choice       which coordinates are dependent                   (29)-(31)   along the structure, then by pivoting
    condensed    substitutions for the dependent coordinates       (32)-(38)
    groups       the slow-to-fast groups of q_i                    (39), (72)
    kernels      named functions of (q_i, q_d, q_i_dot, q_d_dot, t, p)
    tapes        straight-line code of the kernels, with all that depends on p only in `constants`
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.engine.tape import Tape
from runtime.initial import ConsistentState, GivenValues, InitialStateError, consistent_state
from symgen.assembly.build import build_equations
from symgen.condensation import Condensed, condense
from symgen.elimination import choose_loops, constraint_jacobian, structural_pivots
from symgen.equations import Equations
from symgen.forward_dynamics import NoInertia
from symgen.hoisting import hoist
from symgen.kernels import arguments_of, build_kernels
from symgen.parameters import ParameterEntry, ParameterTable
from symgen.partition import Group, choose_groups
from symgen.scene import Scene, SceneError


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


def derive(scene: Scene, functions: frozenset[str] | None = None) -> Derived:
    """Scene to kernels. `functions` limits the kernels by name (all by default).

    Raises SceneError for over- and under-constrained scenes, impossible initial states and impossible partitions.
    """
    table = ParameterTable(scene)
    equations = build_equations(scene, table)
    structural, loop_rows = structural_pivots(equations, scene)
    initial, jacobian = _initial(scene, equations, table)
    choice = choose_loops(equations, scene, structural, loop_rows, jacobian)
    if not choice.independent:
        raise SceneError("joints", "the mechanism has no degree of freedom left: every coordinate is determined",
                         "remove a joint or a prescribed motion, or give a body modes")
    system = condense(equations, choice)
    groups = choose_groups(scene, equations, choice.independent)
    try:
        kernels = build_kernels(system, scene, groups, functions)
    except NoInertia as error:
        raise SceneError(equations.names[error.args[0]], "has no inertia, so its acceleration is not determined",
                         "give the body an inertia, or join it so that it cannot move that way") from error
    tapes = hoist(kernels, table.vector())
    return Derived(scene, system, arguments_of(system).dependent, groups, initial, table.entries, tapes)


def _initial(scene: Scene, equations: Equations, table: ParameterTable) -> tuple[ConsistentState, np.ndarray]:
    """Consistent state with default parameters, and C_q there."""
    rows = equations.constraints
    q, p = ca.vertcat(*equations.q), table.vector()
    outputs = [ca.densify(ca.vertcat(*(row.C for row in rows))), ca.densify(constraint_jacobian(equations)),
               ca.densify(ca.vertcat(*(row.C_t for row in rows)))]
    function = ca.Function("constraints", [q, equations.t, p], outputs)
    defaults = np.array([entry.default for entry in table.entries])

    def evaluate(state: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        C, jacobian, C_t = function(state, 0.0, defaults)
        return (np.asarray(C).ravel(), np.asarray(jacobian).reshape(len(rows), len(equations.names)),
                np.asarray(C_t).ravel())

    def velocity(state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        _, jacobian, C_t = evaluate(state)
        return jacobian, -C_t

    try:
        state = consistent_state(
            equations.names, equations.elastic_columns, [row.label for row in rows],
            lambda state: evaluate(state)[:2], velocity, _given(scene.initial.coordinates), _given(scene.initial.rates),
            np.array([equations.at_rest.get(k, 0.0) for k in range(len(equations.names))]), equations.joint_columns)
    except InitialStateError as error:
        raise SceneError("initial", str(error), "see above") from error
    return state, evaluate(state.q)[1]


def _given(entries: dict) -> GivenValues:
    values = {name: float(getattr(entry, "value", entry)) for name, entry in entries.items()}
    fixed = frozenset(name for name, entry in entries.items() if getattr(entry, "fixed", False))
    return GivenValues(values, fixed)

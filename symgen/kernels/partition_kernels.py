"""Kernels of the partition of large trees (Eqs. 39, 64): what crosses between slow and fast coordinates, in O(N).

M_hat_LL^-1 costs the cube of the slow coordinates, and along a tree it is not needed: one elimination with the fast
accelerations given has q_L'' = y'' - N q_S'' as its solution, y'' for the forces and a column of -N for each unit
acceleration of q_S. The rows of q_S then see a few accelerations only, those of the bodies that q_S belongs to.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, ZERO, neg, sub
from symgen.choice.deflections import Deflections
from symgen.condensed.condensation import Condensed
from symgen.condensed.forward_dynamics import (
    LONGEST_ELIMINATION,
    force_side,
    forces_side,
    free_joints,
    given_side,
    tree_solutions,
)
from symgen.kernels.kernel import Arguments, Kernel, shortest
from symgen.system.equations import matrix_times
from symgen.system.topology import Topology

LARGE_TREE = 8  # independent coordinates from which these are shorter than a factorisation of M_hat


def partition_kernels(
    system: Condensed, topology: Topology, arguments: Arguments, slow: list[int], fast: list[int]
) -> dict[str, Callable[[], Kernel]]:
    """Builders by name for two groups of a large tree, positions in q_i; none for a small one."""
    if len(system.choice.independent) <= LARGE_TREE:
        return {}
    if system.reduced.carried is not None and free_joints(system) is not None:
        frames = _FramesOfFast(system, topology, arguments, slow, fast)
        return {"slow_response": frames.slow_response, "fast_rows": frames.fast_rows}
    return {
        "slow_response": lambda: _slow_response(system, topology, arguments, slow, fast),
        "fast_rows": lambda: _fast_rows(system, arguments, fast),
    }


class _FramesOfFast:
    """The same along the frames of a spatial tree: those of q_S see the motion of what carries them."""

    def __init__(
        self, system: Condensed, topology: Topology, arguments: Arguments, slow: list[int], fast: list[int]
    ) -> None:
        assert system.reduced.carried is not None
        columns = system.choice.independent
        self.system, self.topology, self.arguments = system, topology, arguments
        self.slow, self.fast = [columns[k] for k in slow], [columns[k] for k in fast]
        self.frames = system.reduced.carried(frozenset(self.fast))

    @cached_property
    def _force(self) -> Row:
        return self.system.projected(dict(enumerate(self.system.reduced.outer_forces)))

    @cached_property
    def _imposed(self) -> Row:
        return {one.column: one.c_acceleration for one in self.system.inner}

    def slow_response(self) -> Kernel:
        """By recursions that share their inertia or, where that is shorter, by an elimination of M."""
        forms = [self._response(self._by_recursion())]
        if len(self.slow) + len(self.fast) <= LONGEST_ELIMINATION:
            sides = [forces_side(self.system), *(given_side(column) for column in self.fast)]
            forms.append(self._response(tree_solutions(self.system, self.topology, sides, frozenset(self.fast))))
        return shortest(self.arguments.select("q_i", "q_d", "q_i_dot", "q_d_dot"), forms)

    def _by_recursion(self) -> list[Row]:
        """y'' and -N: accelerations by column."""
        solve, M, free = free_joints(self.system), self.system.reduced.M, frozenset(self.slow)
        assert solve is not None
        forced = {**self._imposed, **solve({c: self._force[c] for c in self.slow}, free, self._imposed)}
        return [forced, *(solve({c: neg(M[c].get(j, ZERO)) for c in self.slow}, free) for j in self.fast)]

    def _response(self, solutions: list[Row]) -> dict[str, ca.SX]:
        forced, *responses = solutions
        crossing = self.frames.crossing({c: value for c, value in forced.items() if c not in self.fast})
        for one in responses:
            crossing += self.frames.crossing({c: one[c] for c in self.slow}, still=True)
        outputs = {
            "y_ddot": ca.vertcat(*(forced[c] for c in self.slow)),
            "N": ca.horzcat(*(ca.vertcat(*(neg(one[c]) for c in self.slow)) for one in responses)),
            "crossing": ca.vertcat(*crossing),
        }
        return {name: ca.densify(value) for name, value in outputs.items()}

    def fast_rows(self) -> Kernel:
        """Forces at the rest of q_S, and what each unit acceleration of it adds, the others following."""
        size = self.frames.size
        symbols = ca.SX.sym("crossing", size * (1 + len(self.fast)))
        seen = [[symbols[size * j + k] for k in range(size)] for j in range(1 + len(self.fast))]
        inertia = self.frames.forces(seen[0], {})
        rhs = ca.vertcat(*(sub(self._force[c], inertia.get(c, ZERO)) for c in self.fast))
        rows = [self.frames.forces(one, {j: ONE}, still=True) for j, one in zip(self.fast, seen[1:], strict=True)]
        M = ca.horzcat(*(ca.vertcat(*(row.get(c, ZERO) for c in self.fast)) for row in rows))
        inputs = self.arguments.select("q_i", "q_d", "q_i_dot", "q_d_dot", crossing=symbols)
        return Kernel(inputs, {"M_bar_SS": ca.densify(M), "rhs_S": ca.densify(rhs)})


def _slow_response(system: Condensed, topology: Topology, a: Arguments, slow: list[int], fast: list[int]) -> Kernel:
    """y'' = M_hat_LL^-1 Q_hat_L, N = M_hat_LL^-1 M_hat_LS, and the accelerations that cross to the rows of q_S."""
    columns = system.choice.independent
    given = frozenset(columns[k] for k in fast)
    sides = [forces_side(system), *(given_side(columns[k]) for k in fast)]
    forced, *responses = solutions = tree_solutions(system, topology, sides, given)
    seen = _columns_seen(system, fast)
    outputs = {
        "y_ddot": ca.vertcat(*(forced[columns[k]] for k in slow)),
        "N": ca.horzcat(*(ca.vertcat(*(neg(found[columns[k]]) for k in slow)) for found in responses)),
        "crossing": ca.vertcat(*(found.get(c, ZERO) for found in solutions for c in seen)),
    }
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    return Kernel(inputs, {name: ca.densify(value) for name, value in outputs.items()})


def _fast_rows(system: Condensed, a: Arguments, fast: list[int]) -> Kernel:
    """M_hat_SS - M_hat_SL N and Q_hat_S - M_hat_SL y'': the rows of q_S with q_L'' = y'' - N q_S''."""
    seen = _columns_seen(system, fast)
    crossing = ca.SX.sym("crossing", len(seen) * (1 + len(fast)))
    forces = system.project(dict(enumerate(system.reduced.Q_star)))[fast]
    sides = []
    for j in range(1 + len(fast)):
        moving = {column: crossing[j * len(seen) + k] for k, column in enumerate(seen)}
        sides.append(system.project(matrix_times(system.reduced.M, moving))[fast])
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", crossing=crossing)
    return Kernel(inputs, {"M_bar_SS": ca.densify(ca.horzcat(*sides[1:])), "rhs_S": ca.densify(forces - sides[0])})


def _columns_seen(system: Condensed, fast: list[int]) -> list[int]:
    """Coordinates whose accelerations stand in the rows of q_S of S^T M q''."""
    columns = range(len(system.reduced.names))
    accelerations = ca.SX.sym("q_ddot", len(columns))
    inertia = matrix_times(system.reduced.M, {column: accelerations[column] for column in columns})
    pattern = ca.jacobian_sparsity(system.project(inertia)[fast], accelerations)
    return sorted(set(pattern.get_triplet()[1]))


def deflection_kernels(
    system: Condensed, topology: Topology, arguments: Arguments, deflections: Deflections, tree: bool
) -> dict[str, Callable[[], Kernel]]:
    """Builders by name of what the stiff deflections are and, on a large tree, of what a force along them does."""
    builders = {"deflections": lambda: _deflections(system, arguments, deflections)}
    if tree and len(system.choice.independent) > LARGE_TREE:
        builders["deflection_response"] = lambda: _deflection_response(system, topology, arguments, deflections)
    return builders


def _deflections(system: Condensed, a: Arguments, deflections: Deflections) -> Kernel:
    """B, K_s and D_s."""
    B = ca.SX.zeros(len(system.choice.independent), len(deflections.rows))
    for j, row in enumerate(deflections.rows):
        for column, value in row.items():
            B[system.choice.independent.index(column), j] = value
    return Kernel(a.select(), {"B": B, "K_s": deflections.K, "D_s": deflections.D})


def _deflection_response(system: Condensed, topology: Topology, a: Arguments, deflections: Deflections) -> Kernel:
    """q_i'' and M_hat^-1 B."""
    sides = [forces_side(system), *(force_side(row) for row in deflections.rows)]
    forced, *responses = tree_solutions(system, topology, sides)
    columns = system.choice.independent
    X = ca.horzcat(*(ca.vertcat(*(found[c] for c in columns)) for found in responses))
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    return Kernel(inputs, {"q_i_ddot": ca.densify(ca.vertcat(*(forced[c] for c in columns))), "X": ca.densify(X)})

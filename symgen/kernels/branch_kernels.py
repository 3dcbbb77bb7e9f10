"""Kernels of large trees whose fast coordinates are in branches: a sub-step sees the branches only (Eqs. 39, 64).

Branches are the bodies with fast coordinates and all beyond them, the trunk is the rest. The frame of a branch's first
body follows the trunk, x_d'' = u_d + (own coordinates), u = E q_T''; what it does to the trunk is phi - M_uu u along u,
M_uu the inertia of the branches that is carried along. So

    q_T'' = a_T + X phi,   u = b + A phi,   X = (M_TT + E^T M_uu E)^-1 E^T,   b = E a_T,   A = E X.

a_T, X, b and A depend on slow coordinates only and cost one elimination along the trunk; then the branches alone give
phi, q_S'' and the accelerations of their slow coordinates, q_B''. This is (39) for all coordinates, nothing left out.

What forces along the stiff deflections of a tree do beside a shift: one elimination, O(N) for any number of them.

    (M_hat + B (kappa K + delta D) B^T) x = B f,    kappa, delta and f complex

is the elimination of the tree with entries added to the rows of the deflections. Rational approximations of
exponentials ask for such solutions; without a shift it is M_hat^-1 B f.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cached_property

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ONE, ZERO, ComplexScalar, add, complex_number, dot, entries, mul, neg, vector
from symgen.algebra.small_systems import collected, solve_small
from symgen.choice.deflections import Deflections
from symgen.condensed.condensation import Condensed, Substitution
from symgen.condensed.forward_dynamics import RowsLeft, Side, eliminate, force_side, forces_side
from symgen.kernels.kernel import Arguments, Kernel
from symgen.kernels.partition_kernels import LARGE_TREE
from symgen.system.topology import Topology

MOST_LEFT = 6  # interface forces and slow coordinates of branches together


@dataclass(frozen=True)
class Branches:
    """A tree divided into trunk and branches; slow, fast: columns of q in their order in q_i."""

    system: Condensed
    topology: Topology
    slow: list[int]
    fast: list[int]

    @cached_property
    def bodies(self) -> list[str]:
        """Bodies with fast coordinates, and those beyond them."""
        columns = self.system.reduced.body_columns
        found = {body for body, own in columns.items() if set(own) & set(self.fast)}
        for body in sorted(columns, key=self.topology.distance_of):
            link = self.topology.tree.get(body)
            if link is not None and link.other(body) in found:
                found.add(body)
        return [body for body in columns if body in found]

    @cached_property
    def trunk(self) -> list[str]:
        """The other bodies."""
        return [body for body in self.system.reduced.body_columns if body not in self.bodies]

    @cached_property
    def columns(self) -> frozenset[int]:
        """Columns of the branches."""
        return frozenset(c for body in self.bodies for c in self.system.reduced.body_columns[body])

    @cached_property
    def roots(self) -> list[Substitution]:
        """Substitutions of the branches that refer to the trunk."""
        own = [one for one in self.system.substitutions if one.column in self.columns]
        return [one for one in own if not set(one.e) <= self.columns]

    @cached_property
    def axes(self) -> list[dict[int, ca.SX]]:
        """By root, what of x_d'' is along each u: the axes of a body in a plane, where rows of u are sparse."""
        eq, place = self.system.reduced, {one.column: k for k, one in enumerate(self.roots)}
        found = [{k: ONE} for k in range(len(self.roots))]
        for body in self.bodies:
            x, y, theta = (*eq.body_columns[body], -1, -1, -1)[:3]
            if x in place and y in place and theta in self.own_slow and eq.coordinates[theta].kind == "angle":
                cosine, sine = ca.cos(eq.q[theta]), ca.sin(eq.q[theta])
                found[place[x]] = {place[x]: cosine, place[y]: neg(sine)}
                found[place[y]] = {place[x]: sine, place[y]: cosine}
        return found

    @cached_property
    def rows(self) -> list[Row]:
        """E: what u is in accelerations of the trunk; the axes being orthogonal, E = axes^T e."""
        found: list[Row] = [{} for _ in self.roots]
        for one, along in zip(self.roots, self.axes, strict=True):
            for k, factor in along.items():
                add_scaled(found[k], factor, {c: e for c, e in one.e.items() if c not in self.columns})
        return found

    @cached_property
    def own_slow(self) -> list[int]:
        """Slow coordinates of the branches."""
        return [column for column in self.slow if column in self.columns]

    @property
    def u(self) -> list[int]:
        """Columns that stand for u, beyond those of q."""
        return [len(self.system.reduced.M) + k for k in range(len(self.roots))]

    def side(self, bodies: list[str]) -> Side:
        """Of the motion itself, as it acts on some bodies."""
        whole = forces_side(self.system)
        own = {c for body in bodies for c in self.system.reduced.body_columns[body]}
        return replace(whole, force={c: value for c, value in whole.force.items() if c in own})

    @cached_property
    def eliminated(self) -> RowsLeft:
        """The branches alone, their frames following u; the rows of u and of their slow coordinates are left."""
        followed = {}
        for one, along in zip(self.roots, self.axes, strict=True):
            e = {c: value for c, value in one.e.items() if c in self.columns}
            followed[one.column] = replace(one, e={**e, **{self.u[k]: factor for k, factor in along.items()}})
        given = frozenset((*self.u, *self.own_slow))
        return eliminate(self.system, self.topology, [self.side(self.bodies)], given, self.bodies, followed)

    @property
    def carried(self) -> list[tuple[int, int, ca.SX]]:
        """E^T M_uu E: the inertia that the branches add to the trunk."""
        found = []
        for i, row in zip(self.u, self.rows, strict=True):
            for j, column in zip(self.u, self.rows, strict=True):
                M = self.eliminated.M[i].get(j, ZERO)
                found += [(c, d, mul(mul(e, M), f)) for c, e in row.items() for d, f in column.items()]
        return found

    def apart(self) -> bool:
        """Do trunk and branches see each other through u and phi alone, and the trunk nothing fast?"""
        eq = self.system.reduced
        if not self.trunk or not self.roots or len(self.roots) + len(self.own_slow) > MOST_LEFT:
            return False
        if any((c in self.columns) != (other in self.columns) for c, row in enumerate(eq.M) for other in row):
            return False
        trunk = [c for body in self.trunk for c in eq.body_columns[body]]
        if any(set(one.e) & self.columns for one in self.system.substitutions if one.column in trunk):
            return False
        seen = [eq.Q_star[c] for c in trunk] + [value for c in trunk for value in eq.M[c].values()]
        seen += [value for row in self.rows for value in row.values()]
        seen += [self.eliminated.M[i].get(j, ZERO) for i in self.u for j in self.u]
        for one in self.system.substitutions:
            if one.column in trunk:
                seen += [one.c_acceleration, *one.e.values()]
        fast = ca.vertcat(*(v[c] for v in (eq.q, eq.q_dot) for c in self._moving))
        return not ca.depends_on(ca.vertcat(*seen), fast)

    @property
    def _moving(self) -> list[int]:
        """Fast columns and the dependent ones of the branches: what changes in a sub-step."""
        return sorted(self.columns - set(self.slow))


def branch_kernels(
    system: Condensed, topology: Topology, arguments: Arguments, slow: list[int], fast: list[int]
) -> dict[str, Callable[[], Kernel]]:
    """Builders by name for two groups of a large tree, positions in q_i; none where they are not apart."""
    columns = system.choice.independent
    if len(columns) <= LARGE_TREE or system.reduced.turnings:  # forces across a ball are not of this form
        return {}
    branches = Branches(system, topology, [columns[k] for k in slow], [columns[k] for k in fast])
    if not branches.apart():
        return {}
    return {
        "trunk_response": lambda: _trunk_response(branches, arguments),
        "branch_motion": lambda: _branch_motion(branches, arguments),
    }


def _trunk_response(branches: Branches, a: Arguments) -> Kernel:
    """a_T and X in the rows of q_L (zero in those of the branches), b and A."""
    system = branches.system
    sides = [branches.side(branches.trunk), *(force_side(row) for row in branches.rows)]
    left = eliminate(system, branches.topology, sides, bodies=branches.trunk, attached=branches.carried)
    forced, *responses = found = [left.solution(k, {}) for k in range(len(sides))]
    outputs = {
        "trunk_ddot": ca.vertcat(*(forced.get(c, ZERO) for c in branches.slow)),
        "X_trunk": ca.horzcat(*(ca.vertcat(*(one.get(c, ZERO) for c in branches.slow)) for one in responses)),
        "interface": ca.vertcat(*(_along(row, one) for one in found for row in branches.rows)),
    }
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot")
    return Kernel(inputs, {name: ca.densify(value) for name, value in outputs.items()})


def _along(row: Row, accelerations: Row) -> ca.SX:
    return dot(list(row.values()), [accelerations.get(c, ZERO) for c in row])


def _branch_motion(branches: Branches, a: Arguments) -> Kernel:
    """phi, q_S'' and q_B'': the rows of u and q_B that are left of the branches, with u = b + A phi."""
    system, u, own, left = branches.system, branches.u, branches.own_slow, branches.eliminated
    n = len(u)
    interface = ca.SX.sym("interface", n * (1 + n))
    b, A = interface[:n], ca.reshape(interface[n:], n, n)
    moving = ca.vertcat(*(v[c] for v in (system.reduced.q, system.reduced.q_dot) for c in branches.fast))
    phi, f_B = (ca.vertcat(*collected([left.forces[0].get(c, ZERO) for c in part], moving)) for part in (u, own))
    q_B = ca.SX(0, 1)
    if own:  # phi = f_u - M_uB q_B''
        M_uB, M_BB = (_matrix(collected(_block(left, rows, own), moving), len(rows)) for rows in (u, own))
        yields = ca.mtimes(A, M_uB)
        force = f_B - ca.mtimes(M_uB.T, b) - ca.mtimes(yields.T, phi)
        q_B = _solved(M_BB - ca.mtimes(M_uB.T, yields), force)
        phi = phi - ca.mtimes(M_uB, q_B)
    pushed, turned = ca.SX.sym("phi", n), ca.SX.sym("q_B", len(own))
    u_ddot = b + ca.mtimes(A, pushed)
    start = {c: u_ddot[k] for k, c in enumerate(u)} | {c: turned[k] for k, c in enumerate(own)}
    found = left.solution(0, start)
    q_S = ca.vertcat(*collected([found[c] for c in branches.fast], ca.vertcat(moving, pushed, turned)))
    outputs = {
        "q_S_ddot": ca.substitute(q_S, ca.vertcat(pushed, turned), ca.vertcat(phi, q_B)),
        "branch_ddot": ca.vertcat(*(q_B[own.index(c)] if c in own else ZERO for c in branches.slow)),
        "phi": phi,
    }
    inputs = a.select("q_i", "q_d", "q_i_dot", "q_d_dot", interface=interface)
    return Kernel(inputs, {name: ca.densify(value) for name, value in outputs.items()})


def _solved(matrix: ca.SX, side: ca.SX) -> ca.SX:
    (column,), _ = solve_small(entries(matrix), [vector(side)])
    return ca.vertcat(*column)


def _block(left: RowsLeft, rows: list[int], columns: list[int]) -> list[ca.SX]:
    return [left.M[row].get(column, ZERO) for column in columns for row in rows]


def _matrix(by_column: list[ca.SX], rows: int) -> ca.SX:
    return ca.reshape(ca.vertcat(*by_column), rows, len(by_column) // rows)


FOR_A_COORDINATE, IN_SPACE = (
    1_100,
    4_000,
)  # operations of a step of `exponential_rk4` by such solutions, for each of q_i


def shorter_than_dense(n: int, n_s: int, in_space: bool) -> bool:
    """Are such solutions shorter than a dense block of n_s deflections of n coordinates? By counts of built steps."""
    return (IN_SPACE if in_space else FOR_A_COORDINATE) * n < 10 * n_s**3 + 100 * n_s**2


def shifted_kernels(
    system: Condensed, topology: Topology, arguments: Arguments, deflections: Deflections
) -> dict[str, Callable[[], Kernel]]:
    """Builders by name on a large tree with many deflections, none on others."""
    n, in_space = len(system.choice.independent), system.reduced.free_joints is not None
    if n <= LARGE_TREE or not shorter_than_dense(n, len(deflections.rows), in_space):
        return {}
    return {"shifted_solution": lambda: _shifted_solution(system, topology, arguments, deflections)}


def _shifted_solution(system: Condensed, topology: Topology, a: Arguments, deflections: Deflections) -> Kernel:
    """x_re and x_im; shift: kappa, then delta, push: f, real parts first in each."""
    n_s = len(deflections.rows)
    shift, push = ca.SX.sym("shift", 4), ca.SX.sym("push", 2 * n_s)
    kappa, delta = complex_number(shift[0], shift[1]), complex_number(shift[2], shift[3])
    force: Row = {}
    for k, row in enumerate(deflections.rows):
        add_scaled(force, complex_number(push[k], push[n_s + k]), row)
    attached = [
        (row, column, mul(mul(e, value), f))
        for i, j, value in _shifts(deflections, kappa, delta)
        for row, e in deflections.rows[i].items()
        for column, f in deflections.rows[j].items()
    ]
    left = eliminate(system, topology, [force_side(force)], attached=attached)
    found = left.solution(0, {})
    x = [ComplexScalar.of(found.get(column, ZERO)) for column in system.choice.independent]
    outputs = {"x_re": ca.vertcat(*(one.re for one in x)), "x_im": ca.vertcat(*(one.im for one in x))}
    inputs = a.select("q_i", "q_d", shift=shift, push=push)
    return Kernel(inputs, {name: ca.densify(value) for name, value in outputs.items()})


def _shifts(deflections: Deflections, kappa: ca.SX, delta: ca.SX) -> list[tuple[int, int, ca.SX]]:
    """(i, j, kappa K_ij + delta D_ij) where it is not zero."""
    K, D, found = ca.sparsify(deflections.K), ca.sparsify(deflections.D), []
    for i, j in zip(*(K + D).sparsity().get_triplet(), strict=True):
        value = add(mul(kappa, ca.SX(K[i, j])), mul(delta, ca.SX(D[i, j])))
        found.append((i, j, value))
    return found

"""What stiff deflections are, and what a force along them does (Eq. 38).

On a large tree forces along the deflections, beside a shift too,

    (M_hat + B (kappa K + delta D) B^T) x = B f,    kappa, delta and f complex,

are one elimination of the tree with entries added to the rows of the deflections, O(N) for any number of them.
Rational approximations of exponentials ask for such solutions; without a shift it is M_hat^-1 B f.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ZERO, ComplexScalar, add, complex_number, mul
from symgen.choice.deflections import Deflections
from symgen.condensed.condensation import Condensed
from symgen.condensed.forward_dynamics import force_side, forces_side, tree_solutions
from symgen.kernels.kernel import Arguments, Kernel
from symgen.system.topology import Topology

LARGE_TREE = 8  # independent coordinates from which these are shorter than a factorisation of M_hat
# operations of a step of `exponential_rk4` by shifted solutions, for each of q_i, in a plane and in space
FOR_A_COORDINATE, IN_SPACE = 1_100, 4_000


def deflection_kernels(
    system: Condensed, topology: Topology, arguments: Arguments, deflections: Deflections, tree: bool
) -> dict[str, Callable[[], Kernel]]:
    """Builders by name of what the stiff deflections are and, on a large tree, of what a force along them does."""
    builders = {"deflections": lambda: _deflections(system, arguments, deflections)}
    n, in_space = len(system.choice.independent), system.reduced.free_joints is not None
    if tree and n > LARGE_TREE:
        builders["deflection_response"] = lambda: _deflection_response(system, topology, arguments, deflections)
        if shorter_than_dense(n, len(deflections.rows), in_space):
            builders["shifted_solution"] = lambda: _shifted_solution(system, topology, arguments, deflections)
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


def shorter_than_dense(n: int, n_s: int, in_space: bool) -> bool:
    """Are such solutions shorter than a dense block of n_s deflections of n coordinates? By counts of built steps."""
    return (IN_SPACE if in_space else FOR_A_COORDINATE) * n < 10 * n_s**3 + 100 * n_s**2


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
    (found,) = tree_solutions(system, topology, [force_side(force)], attached)
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

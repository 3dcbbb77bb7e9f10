"""What forces along the stiff deflections of a tree do beside a shift: one elimination, O(N) for any number of them.

    (M_hat + B (kappa K + delta D) B^T) x = B f,    kappa, delta and f complex

is the elimination of the tree with entries added to the rows of the deflections. Rational approximations of
exponentials ask for such solutions; without a shift it is M_hat^-1 B f.
"""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from symgen.algebra.rows import Row, add_scaled
from symgen.algebra.scalar import ZERO, ComplexScalar, add, complex_number, mul
from symgen.choice.deflections import Deflections
from symgen.condensed.condensation import Condensed
from symgen.condensed.forward_dynamics import eliminate, force_side
from symgen.kernels.kernel import Arguments, Kernel
from symgen.kernels.partition_kernels import LARGE_TREE
from symgen.system.topology import Topology

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

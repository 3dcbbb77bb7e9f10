"""Functions of a system with elements that are held and let go: what holds them, when that ends, what decides then.

Whoever solves for accelerations finds M_hat and Q_hat with what sticks locked, and on a tree its elimination by masked
pivots. The functions of stiff deflections are left out: runs do without them.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

import casadi as ca

from runtime.contract.records import Group
from symgen.algebra.rows import Row
from symgen.algebra.scalar import ONE, add, div, mul, neg, sub
from symgen.condensed.condensation import Condensed
from symgen.condensed.forward_dynamics import Lock, is_tree, tree_accelerations
from symgen.condensed.locks import Locks, locks
from symgen.condensed.variations import directions
from symgen.kernels.jacobians import jacobian_kernels
from symgen.kernels.kernel import Arguments, Kernel, blocks, dynamics
from symgen.kernels.reaction_friction import Grips
from symgen.kernels.specification import substep_name
from symgen.system.equations import Element
from symgen.system.topology import Topology

TOUCH = 1e-9  # m or rad: so far beyond a stop is on it, for what was left at rest and is pressed again
LEAST_SLIDING = 1e-12  # m/s or rad/s: what has just begun to slide at rest has not come to rest
NO_LIMIT_BELOW = -1e-12  # N, N m or 1: a limit of friction that changes is negative below it, less is rounding
STATE = ("q_i", "q_d", "q_i_dot", "q_d_dot")
WITHOUT = ("deflections", "deflection_response", "shifted_solution", "forward_dynamics")
Builders = Mapping[str, Callable[[], Kernel]]


def with_elements(
    builders: Builders, system: Condensed, topology: Topology, a: Arguments, groups: list[Group]
) -> dict[str, Callable[[], Kernel]]:
    """The builders of a system, by name, with those of its elements and of what they lock."""
    locked = locks(system)
    grips = Grips(locked)
    found = {name: build for name, build in builders.items() if name not in WITHOUT}
    found["elements"] = partial(_elements, locked, a, grips)
    found["element_forces"] = partial(_forces, locked, a, grips)
    found["condensed"] = lambda: Kernel(a.select(*STATE), dict(zip(("M_hat", "Q_hat"), locked.locked(), strict=True)))
    for name in jacobian_kernels(system, a):
        found[name] = partial(_rates_left, name, locked, a, grips)
    if (pivots := _pivots(locked, topology)) is not None:
        found["forward_dynamics"] = lambda: dynamics(system, a, tree_accelerations(system, topology, pivots))
    if len(groups) > 1:
        found["blocks"] = lambda: blocks(a, *locked.locked(), groups)
    for level in range(1, len(groups)):
        found[substep_name(level + 1)] = partial(_substep, locked, a, [one.positions for one in groups], level)
    return grips.in_kernels(found) if grips.own else found


def _pivots(locks: Locks, topology: Topology) -> dict[int, Lock] | None:
    """By column, of the elements of a tree; None where two of them would have the same."""
    system = locks.system
    if locks.right_inverse is None or not is_tree(system, topology):
        return None
    body_of = {column: body for body, columns in system.reduced.body_columns.items() for column in columns}
    found: dict[int, Lock] = {}
    for row, bias, one in zip(locks.rows, locks.bias, locks.elements, strict=True):
        entries = {column: value for column, value in row.items() if not value.is_zero()}
        far = max(entries, key=lambda column: (topology.distance_of(body_of[column]), column))
        if far in found:
            return None
        factor = entries.pop(far)
        e = {column: neg(div(value, factor)) for column, value in entries.items()}
        found[far] = Lock(one.moves, e, neg(div(bias, factor)))
    return found


def _elements(locked: Locks, a: Arguments, grips: Grips) -> Kernel:
    """M_hat and Q_hat with nothing locked, and v = G q_i', v' = G q_i'' + bias with the bounds at rest.

    Of friction by reactions R: Q_hat and holds without R, what they gain with R, and
    R_k = |F_0 + F_a q_i'' + F_R R + F_f f|_k with forces f on the elements; shares: by which they share what is held.
    holds is negative or no number where a limit of friction has become that: by so much. slides: forces of friction
    that has let go, where some are less than what holds.
    """
    system, own = locked.system, locked.elements
    outputs = {
        "M_hat": system.M_hat(),
        "Q_hat": system.generalised_force({}),
        "G": ca.densify(locked.G),
        "G_bias": ca.densify(ca.vertcat(*locked.bias)),
        "v_rel": ca.densify(ca.vertcat(*(one.rate for one in own))),
        "holds": ca.densify(ca.vertcat(*(_where_it_is_a_limit(one, one.holds) for one in own))),
    }
    if any(one.friction is not None and one.friction.slides is not None for one in own):
        outputs["slides"] = ca.densify(ca.vertcat(*(one.slides for one in own)))
    if stops := [stop for one in own for stop in one.stops]:
        outputs["gap"] = ca.densify(ca.vertcat(*(one.gap for one in stops)))
        outputs["restitution"] = ca.densify(ca.vertcat(*(one.restitution for one in stops)))
    if grips.own:
        for name in ("Q_hat", "holds"):
            outputs[name], outputs[f"{name}_R"] = grips.split(outputs[name])
        outputs |= dict(zip(("F_0", "F_a", "F_R", "F_f"), map(ca.densify, grips.F_given), strict=True))
        outputs["shares"] = ca.densify(ca.vertcat(*(one.share for one in own)))
        outputs["margin"] = ca.densify(grips.margins)
    return Kernel(a.select(*STATE), outputs)


def _forces(locked: Locks, a: Arguments, grips: Grips) -> Kernel:
    """The force on each element, its rate, and what is left of each mode.

    Of friction holds - |f| stuck, s v sliding, either way up to the bound of its contraction where it has one; of a
    stop the gap while it is open, and what presses while it is closed.
    """
    system, own = locked.system, locked.elements
    residual = system.generalised_force({c: a.q_i_ddot[k] for k, c in enumerate(system.choice.independent)})
    holding = locked.forces(residual)
    forces = [add(holding[k], one.law) for k, one in enumerate(own)]
    margins = dict(zip((one.joint for one in grips.own), ca.vertsplit(grips.margins) if grips.own else (), strict=True))
    left = [value for k, one in enumerate(own) for value in _left(one, holding[k], margins.get(one.joint))]
    inputs = a.select(*STATE, q_i_ddot=a.q_i_ddot)
    columns = {"f_rel": forces, "v_rel": [one.rate for one in own], "mode_left": left}
    return Kernel(inputs, {name: ca.densify(ca.vertcat(*values)) for name, values in columns.items()})


def _left(one: Element, force: ca.SX, margin: ca.SX | None) -> list[ca.SX]:
    """By mode. Friction lets nothing go that rests on a stop: the stop does, where that and friction hold no longer."""
    found = []
    if one.friction is not None:
        s, stuck = one.friction.mode, sub(ONE, mul(one.friction.mode, one.friction.mode))
        slack = add(mul(one.open, one.holds - ca.fabs(force)), sub(ONE, one.open))
        left = stuck * slack + mul(s, one.rate) + LEAST_SLIDING * s * s
        left = left if margin is None else ca.fmin(left, margin)
        found.append(
            left if one.friction.margin is None else ca.if_else(one.friction.margin >= NO_LIMIT_BELOW, left, -1)
        )
    for stop in one.stops:
        away = mul(stop.mode, stop.mode)
        found.append(away * (stop.gap + TOUCH * (1 - stop.mode) / 2) + (1 - away) * (stop.side * force + one.holds))
    return found


def _where_it_is_a_limit(one: Element, holds: ca.SX) -> ca.SX:
    """What friction holds; where a limit of it has become negative or no number, that one."""
    if one.friction is None or one.friction.margin is None:
        return holds
    return ca.if_else(one.friction.margin >= NO_LIMIT_BELOW, holds, one.friction.margin)


def _rates_left(name: str, locked: Locks, a: Arguments, grips: Grips) -> Kernel:
    """Derivatives of Q_hat - M_hat q_i'' in the directions that do not stick."""
    kernel = jacobian_kernels(locked.system, a)[name]()
    if locked.right_inverse is not None and not grips.own:
        return Kernel(kernel.inputs, {key: locked.rates_left(value) for key, value in kernel.outputs.items()})
    a_given = a.q_i_ddot if name == "residual_jacobian" else ca.SX.zeros(a.q_i_ddot.numel())
    both = _along_motions(locked, a_given, grips)
    return Kernel(
        kernel.inputs, dict(zip(kernel.outputs, both[1:] if name == "dQ_hat_dq_i_dot" else both, strict=False))
    )


def _along_motions(locked: Locks, q_i_ddot: ca.SX, grips: Grips) -> tuple[ca.SX, ca.SX]:
    """Total derivatives of the locked Q_hat - M_hat q_i'' by q_i and by q_i', whose G moves with the mechanism."""
    system, eq = locked.system, locked.system.reduced
    M_hat, Q_hat = locked.locked()
    if grips.own:
        (Q_hat,) = grips.known([Q_hat])
    given = dict(zip(system.choice.independent, ca.vertsplit(q_i_ddot), strict=True))
    found = directions(system, system.accelerations(given))
    q, rates = ca.vertcat(*eq.q), ca.vertcat(*eq.q_dot)

    def moved(row: Row) -> ca.SX:
        return ca.vertcat(*(row.get(c, ca.SX(0)) for c in range(q.numel())))

    residual = Q_hat - M_hat @ q_i_ddot
    J_q = [ca.jtimes(residual, ca.vertcat(q, rates), ca.vertcat(moved(one.S), moved(one.S_dot))) for one in found]
    J_v = [ca.jtimes(residual, rates, moved(one.S)) for one in found]
    return ca.densify(ca.horzcat(*J_q)), ca.densify(ca.horzcat(*J_v))


def _substep(locked: Locks, a: Arguments, groups: list[list[int]], level: int) -> Kernel:
    """M_hat of the groups from `level` on, and their right-hand side with slower accelerations given (Eq. 64)."""
    slow, fast = ([k for group in part for k in group] for part in (groups[:level], groups[level:]))
    q_L_ddot = ca.SX.sym("q_L_ddot", len(slow))
    M_hat, Q_hat = locked.locked()
    outputs = {"M_hat_SS": M_hat[fast, fast], "rhs_S": Q_hat[fast] - M_hat[fast, slow] @ q_L_ddot}
    return Kernel(a.select(*STATE, q_L_ddot=q_L_ddot), outputs)

"""A prescribed motion whose velocity jumps gives an impulse: the rates of a mechanism just after it.

Positions stay, q_d' = B q_i' + b changes by the jump of b, and momentum changes along the constraint forces only, so
that S^T M (q'+ - q'-) = 0 with S = [1; B] in the order (q_i, q_d): M_hat (q_i'+ - q_i'-) = -S^T M [0; b+ - b-].
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.coordinates import joined, parts
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel, refuse_elements
from runtime.contract.tape import shared
from runtime.schemes.sparse_lu import solve_symmetric
from runtime.schemes.switching.times import SwitchTime

RATE_ROUNDING = 1e-12  # of the largest rate: less is rounding of a rate that does not jump


@dataclass(frozen=True)
class Impulse:
    """energy [J]: what the motion's impulse did; jumps (n,): by what each rate changed."""

    energy: float
    jumps: np.ndarray


def impulse_text(model: EmittedModel, impulse: Impulse) -> str:
    """What it did, in plain words."""
    k = int(np.abs(impulse.jumps).argmax())
    return (
        f"the velocity of a prescribed motion jumps: its impulse changes the rate of "
        f"{model.coordinates[k]} by {impulse.jumps[k]:.6g}, the energy by {impulse.energy:.6g} J"
    )


def moves_in_time(model: EmittedModel) -> bool:
    """Are there prescribed motions?"""
    return bool(model.constraints) and (not model.has("constraints") or "t" in model.kernel("constraints").name_in())


def may_give_impulses(model: EmittedModel, c: np.ndarray, switches: Sequence[SwitchTime]) -> list[SwitchTime]:
    """Those of the times at which the velocity of a prescribed motion may jump; c (c_size,): the model's constants.

    All of them where that depends on coordinates or inputs too, or where no function tells. Raises ModelError where
    joints stick by friction, whose locked equations give another impulse.
    """
    found = _may_jump(model, c, switches) if switches and moves_in_time(model) else []
    if found:
        remedy = "smooth the motion, or take a scene without it"
        refuse_elements(model, "the impulse of a prescribed velocity that jumps does not know", remedy)
    return found


def _may_jump(model: EmittedModel, c: np.ndarray, switches: Sequence[SwitchTime]) -> list[SwitchTime]:
    if not model.has("constraints"):
        return list(switches)
    q, q_dot = (ca.SX.sym(name, len(model.coordinates)) for name in ("q", "q_dot"))
    t, inputs = ca.SX.sym("t"), ca.SX.sym("w", model.signals.size)
    held = ca.vertcat(ca.SX(ca.DM(c[: len(c) - model.signals.size])), inputs)
    C_t = ca.densify(model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=held)["C_t"])
    if ca.depends_on(C_t, ca.vertcat(q, q_dot, inputs)):
        return list(switches)
    sides = np.array([[one.before, one.after] for one in switches])
    found = ca.Function("velocities", [t], [C_t, _steepness(C_t, t)])(sides.reshape(1, -1))
    values, steepness = (np.asarray(one) for one in found)
    jumps, steep = np.abs(values[:, 1::2] - values[:, 0::2]), np.maximum(steepness[:, 0::2], steepness[:, 1::2])
    smooth = RATE_ROUNDING * np.abs(values).max(axis=1, initial=0.0)[:, None] + steep * (sides[:, 1] - sides[:, 0])
    may = (jumps > smooth).any(axis=0)
    return [one for one, jumping in zip(switches, may.tolist(), strict=True) if jumping]


def _steepness(rates: ca.SX, t: ca.SX) -> ca.SX:
    """Times the clocks' distance: what rates (n,) that do not jump differ by at most, by the mean value theorem.

    The clocks are some tens of roundings of t apart: the last term is what polynomials in time round by.
    """
    slope = ca.jacobian(rates, t)
    return ca.densify(2 * ca.fabs(slope) + ca.fabs(t) * ca.fabs(ca.jacobian(slope, t)))


def impulse_at(
    model: EmittedModel, c: np.ndarray, q: np.ndarray, q_i_dot: np.ndarray, before: float, after: float
) -> tuple[np.ndarray, Impulse] | None:
    """(what is added to q_i_dot (n_i,), the impulse) at a time with a clock on each side [s], by the rates before it.

    q (n,): all coordinates. None if none jumps there. Raises ModelError for a model without the function `energy`.
    """
    q_i, q_d = parts(model, q)
    if not len(q_d):
        return None
    found = impulse_of(model)(q_i, q_d, q_i_dot, c, before, after)
    push, energy, jumps = (np.asarray(one).ravel() for one in found)
    return (push, Impulse(float(energy[0]), jumps)) if jumps.any() else None


def impulse_of(model: EmittedModel) -> ca.Function:
    """(q_i, q_d, q_i_dot, c, clock before, clock after) -> what is added to q_i_dot (n_i,), energy, jumps (n,), see
    Impulse; zero where no velocity jumps. Raises ModelError for a model without the function `energy`.
    """
    return model.derived("impulse", lambda: _impulse(model))


def _impulse(model: EmittedModel) -> ca.Function:
    if not model.has("energy"):
        raise ModelError(
            f"model {model.name}",
            "the velocity of a prescribed motion may jump, which takes the function energy",
            "regenerate the scene with that function",
        )
    n_i, n_d = len(model.q_i), len(model.q_d)
    q_i, q_d, q_i_dot = ca.SX.sym("q_i", n_i), ca.SX.sym("q_d", n_d), ca.SX.sym("q_i_dot", n_i)
    c, before, after = ca.SX.sym("c", model.c_size), ca.SX.sym("before"), ca.SX.sym("after")
    at, q = {"q_i": q_i, "q_d": q_d, "c": c}, joined(model, q_i, q_d)

    def dependent(rates: ca.SX, t: ca.SX) -> ca.SX:
        found: ca.SX = model.evaluate("velocities", **at, q_i_dot=rates, t=t)["q_d_dot"]
        return found

    rates = [dependent(q_i_dot, t) for t in (before, after)]
    q_dot, jump = joined(model, q_i_dot, rates[0]), joined(model, ca.SX.zeros(n_i), rates[1] - rates[0])
    largest = ca.fmax(ca.fmax(ca.norm_inf(q_dot), ca.norm_inf(rates[1])), 1e-300)
    steep = ca.fmax(*(ca.norm_inf(_steepness(one, t)) for one, t in zip(rates, (before, after), strict=True)))
    jumps = ca.norm_inf(jump) > RATE_ROUNDING * largest + steep * (after - before)
    push = ca.SX(0, 1)
    if n_i:
        M_hat = model.evaluate("condensed", **at, q_i_dot=q_i_dot, q_d_dot=rates[0], t=before)["M_hat"]
        push = ca.if_else(jumps, -solve_symmetric(M_hat, _momentum(model, q, jump, at, q_i_dot, after)), 0)
    found = joined(model, q_i_dot + push, dependent(q_i_dot + push, after))
    kinetic = [model.evaluate("energy", q=q, q_dot=v, t=after, c=c)["kinetic"] for v in (q_dot, found)]
    outputs = [push, ca.if_else(jumps, kinetic[1] - kinetic[0], 0), ca.if_else(jumps, found - q_dot, 0)]
    return ca.Function("impulse", [q_i, q_d, q_i_dot, c, before, after], shared([ca.densify(one) for one in outputs]))


def _momentum(model: EmittedModel, q: ca.SX, v: ca.SX, at: Mapping[str, ca.SX], q_i_dot: ca.SX, t: ca.SX) -> ca.SX:
    """(n_i,) S^T M v; the kinetic energy is v^T M v / 2."""
    rates = ca.SX.sym("rates", v.numel())
    kinetic = model.evaluate("energy", q=q, q_dot=rates, t=t, c=at["c"])["kinetic"]
    momentum = ca.substitute(ca.gradient(kinetic, rates), rates, v)
    own = ca.SX.sym("own", q_i_dot.numel())
    B = ca.jacobian(model.evaluate("velocities", **at, q_i_dot=own, t=t)["q_d_dot"], own)
    B, places = ca.substitute(B, own, q_i_dot), model.places
    projected = ca.densify(ca.mtimes(B[places.dependent_plain.tolist(), :].T, momentum[places.dependent.tolist()]))
    for k, column in zip(places.plain, places.columns, strict=True):
        projected[int(k)] = projected[int(k)] + momentum[int(column)]
    return projected

"""A prescribed motion whose velocity jumps gives an impulse: the rates of a mechanism just after it.

Positions stay, q_d' = B q_i' + b changes by the jump of b, and momentum changes along the constraint forces only, so
that S^T M (q'+ - q'-) = 0 with S = [1; B] in the order (q_i, q_d): M_hat (q_i'+ - q_i'-) = -S^T M [0; b+ - b-].
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.coordinates import parts, rate_parts, whole
from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.schemes.switching.times import SwitchTime

DUST = 1e-12  # of the largest rate: less is rounding of a rate that does not jump


@dataclass(frozen=True)
class Impulse:
    """q_dot (n,) just after; energy [J]: what the motion's impulse did; jumps (n,): by what each rate changed."""

    q_dot: np.ndarray
    energy: float
    jumps: np.ndarray


def impulse_text(model: Model, impulse: Impulse) -> str:
    """What it did, in plain words."""
    k = int(np.abs(impulse.jumps).argmax())
    return (
        f"the velocity of a prescribed motion jumps: its impulse changes the rate of "
        f"{model.coordinates[k]} by {impulse.jumps[k]:.6g}, the energy by {impulse.energy:.6g} J"
    )


def moves_in_time(model: Model) -> bool:
    """Are there prescribed motions?"""
    return bool(model.constraints) and (not model.has("constraints") or "t" in model.kernel("constraints").name_in())


def may_give_impulses(model: Model, c: np.ndarray, switches: Sequence[SwitchTime]) -> list[SwitchTime]:
    """Those of the times at which the velocity of a prescribed motion may jump; c (c_size,): the model's constants.

    All of them where that depends on coordinates or inputs too, or where no function tells.
    """
    if not switches or not moves_in_time(model):
        return []
    if not model.has("constraints"):
        return list(switches)
    q, q_dot = (ca.SX.sym(name, len(model.coordinates)) for name in ("q", "q_dot"))
    t, inputs = ca.SX.sym("t"), ca.SX.sym("w", model.signals.size)
    held = ca.vertcat(ca.SX(ca.DM(c[: len(c) - model.signals.size])), inputs)
    C_t = ca.densify(model.evaluate("constraints", q=q, q_dot=q_dot, t=t, c=held)["C_t"])
    if ca.depends_on(C_t, ca.vertcat(q, q_dot, inputs)):
        return list(switches)
    sides = np.array([[one.before, one.after] for one in switches])
    values = np.asarray(ca.Function("velocities", [t], [C_t])(sides.reshape(1, -1)))
    jumps = np.abs(values[:, 1::2] - values[:, 0::2])
    may = (jumps > DUST * np.abs(values).max(axis=1, initial=0.0)[:, None]).any(axis=0)
    return [one for one, jumping in zip(switches, may.tolist(), strict=True) if jumping]


def impulse_at(
    model: Model, c: np.ndarray, q: np.ndarray, q_dot: np.ndarray, before: float, after: float
) -> Impulse | None:
    """What the prescribed motions do at a time with a clock on each side [s]; None if no velocity jumps there.

    q, q_dot (n,): all coordinates and rates before. Raises ModelError for a model without the function `energy`.
    """
    (q_i, q_d), (q_i_dot, _) = parts(model, q), rate_parts(model, q, q_dot)
    if not len(q_d):
        return None
    at = {"q_i": q_i, "q_d": q_d, "c": c}
    rates = [
        np.asarray(model.evaluate("velocities", **at, q_i_dot=q_i_dot, t=t)["q_d_dot"]).ravel() for t in (before, after)
    ]
    jump = whole(model, np.zeros(len(q_i)), rates[1] - rates[0])
    if np.abs(jump).max() <= DUST * max(1e-300, float(np.abs(q_dot).max()), float(np.abs(rates).max())):
        return None
    if not model.has("energy"):
        raise ModelError(
            f"model {model.name}",
            f"the velocity of a prescribed motion jumps at t = {after:.6g} s, which takes the function energy",
            "regenerate the scene with that function",
        )
    q_i_dot = q_i_dot - _pushed(model, c, (q, q_i, q_d), jump, (q_i_dot, rates[0]), before, after)
    q_d_dot = np.asarray(model.evaluate("velocities", **at, q_i_dot=q_i_dot, t=after)["q_d_dot"]).ravel()
    found = whole(model, q_i_dot, q_d_dot)
    kinetic = [float(model.evaluate("energy", q=q, q_dot=v, t=after, c=c)["kinetic"]) for v in (q_dot, found)]
    return Impulse(found, kinetic[1] - kinetic[0], found - q_dot)


def _pushed(
    model: Model,
    c: np.ndarray,
    place: tuple[np.ndarray, np.ndarray, np.ndarray],
    jump: np.ndarray,
    rates: tuple[np.ndarray, np.ndarray],
    before: float,
    after: float,
) -> np.ndarray:
    """(n_i,) by how much q_i_dot is less after; place: q, q_i, q_d; rates: q_i_dot and q_d_dot before."""
    if not model.q_i:
        return np.zeros(0)
    q, q_i, q_d = place
    momentum = model.derived("momentum", lambda: _momentum(model))
    projected = np.asarray(momentum(q, jump, q_i, q_d, after, c)).ravel()
    at = {"q_i": q_i, "q_d": q_d, "c": c, "q_i_dot": rates[0], "q_d_dot": rates[1], "t": before}
    return np.linalg.solve(np.asarray(model.evaluate("condensed", **at)["M_hat"]), projected)


def _momentum(model: Model) -> ca.Function:
    """(q, v, q_i, q_d, t, c) -> S^T M v; the kinetic energy is v^T M v / 2."""
    n, n_i, n_d = len(model.coordinates), len(model.q_i), len(model.q_d)
    q, v, c, t = ca.SX.sym("q", n), ca.SX.sym("v", n), ca.SX.sym("c", model.c_size), ca.SX.sym("t")
    q_i, q_d, q_i_dot = ca.SX.sym("q_i", n_i), ca.SX.sym("q_d", n_d), ca.SX.sym("q_i_dot", n_i)
    momentum = ca.gradient(model.evaluate("energy", q=q, q_dot=v, t=t, c=c)["kinetic"], v)
    q_d_dot = model.evaluate("velocities", q_i=q_i, q_d=q_d, q_i_dot=q_i_dot, t=t, c=c)["q_d_dot"]
    B = ca.jacobian(q_d_dot, q_i_dot)
    at = model.places
    projected = ca.mtimes(B[at.dependent_plain.tolist(), :].T, momentum[at.dependent.tolist()])
    for k, column in zip(model.places.plain, model.places.columns, strict=True):
        projected[int(k)] = projected[int(k)] + momentum[int(column)]
    return ca.Function("momentum", [q, v, q_i, q_d, t, c], [ca.densify(projected)])

"""What was decided is looked at once more, by the equations that go on with it: signs of forces and of accelerations.

With modes given, the locked M_hat and Q_hat give accelerations, and these the forces that hold. Signorini's and
Coulomb's laws at what rests (Acary and Brogliato, Numerical Methods for Nonsmooth Dynamical Systems, 2008, 3.1, 3.9):

    a closed stop           v = 0, and its force presses
    a stop with no force    v' is not into it
    friction that sticks    v = 0, and its force is within its bound
    friction that slides    v' is not against the way that its force says it slides
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared
from runtime.schemes.sparse_lu import Number, factor, solve

# of the forces and accelerations that what acts there makes, and of the rates: more is no rounding
BROKEN_LAW = 1e-6
NO_LIMIT_BELOW = -1e-12  # a limit of friction below it is negative, see symgen/kernels/element_kernels.py
ABOVE_ZERO = "Keep it at zero or above, as by max(0, ...), and what holds at least at what slides."
REMEDY = "Take smaller steps or a smaller tolerance; where it comes again, tell the authors: the choice is wrong."


@dataclass(frozen=True)
class NoMode:
    """No choice of what is held and what moves is good: why, and what to do."""

    cause: str
    remedy: str


def broken_law(
    model: EmittedModel,
    at: Mapping[str, np.ndarray],
    c: np.ndarray,
    modes: np.ndarray,
    rest: np.ndarray,
    force: np.ndarray,
    own: Mapping[str, np.ndarray],
) -> NoMode | None:
    """The law that modes (n_m,) break at a state at rest where they were decided; None: they keep all of them.

    rest, force (n_e,): which rows are at rest, and the forces that were found; own: what `weights` says there.
    """
    c = c.copy()
    c[len(c) - model.signals.size + model.element_modes] = modes
    found = with_modes(model)(**at, c=c)
    left, v, a = (np.asarray(found[name]).ravel() for name in ("left", "v", "a"))
    diagonal = np.maximum(np.diag(own["A"]), 1e-300)
    # by the measure of what accelerates: forces and accelerations of slides and of hinges are one kind there
    acts = (np.abs(own["b"]) + np.abs(own["A"]) @ np.abs(force)) / np.sqrt(diagonal)
    most = BROKEN_LAW * acts.max(initial=0.0)
    slow = BROKEN_LAW * (1.0 + np.abs(at["q_i_dot"]).max(initial=0.0))
    for event, mode, margin in zip(model.mode_events, modes.tolist(), left.tolist(), strict=True):
        row, side = event.row, event.side
        if not rest[row]:
            continue
        least = most / np.sqrt(diagonal[row]) + BROKEN_LAW * abs(own["holds"][row])
        if mode == 0:
            if abs(v[row]) > slow:
                return _no_mode(f"{event.name} holds what moves at {v[row]:.4g}")
            if margin < -least:
                return _no_mode(
                    f"{event.name} would pull with {-margin:.4g}" if side else
                    f"{event.name} would hold {-margin:.4g} more than it can"
                )  # fmt: skip
        elif (not side or mode < 0) and (side or mode) * a[row] < -most * np.sqrt(diagonal[row]):
            what = "lets go of what comes back" if side else "pushes on what it should hold back"
            return _no_mode(f"{event.name} {what}: {a[row]:.4g}")
    return None


def no_limit(model: EmittedModel, holds: np.ndarray) -> NoMode | None:
    """Where a limit of friction that changes during the run is none any more; holds (n_e,): see `elements`."""
    wrong = ~(holds >= NO_LIMIT_BELOW)
    for event in model.mode_events:
        if wrong[event.row] and not event.side:
            what = "no number" if np.isnan(holds[event.row]) else "negative, or what holds less than what slides"
            return NoMode(f"{event.name}: a limit of it becomes {what}", ABOVE_ZERO)
    return None


def broken_on_the_way(
    model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray, left: np.ndarray, length: float
) -> str | None:
    """What of the modes among c is over without an event; left (n_m,): see `element_forces`; length [m]: of it all."""
    over = np.flatnonzero(~(left >= 0))
    if not len(over):
        return None
    own, modes = elements_of(model, at, c), c[len(c) - model.signals.size + model.element_modes]
    inverse = np.linalg.inv(own["M_hat"])
    A, free = own["G"] @ inverse @ own["G"].T, own["G"] @ (inverse @ own["Q_hat"]) + own["G_bias"]
    roots = np.sqrt(np.maximum(np.diag(A), 1e-300))
    most = BROKEN_LAW * (np.abs(free) / roots).max(initial=0.0) / roots + BROKEN_LAW * np.abs(own["holds"])
    slow = BROKEN_LAW * (1.0 + np.abs(at["q_i_dot"]).max(initial=0.0))
    for k in over:
        event, mode = model.mode_events[k], modes[k]
        allowed = most[event.row] if mode == 0 else BROKEN_LAW * length if event.side else slow
        if not left[k] >= -allowed:
            what = ("pulls with", "is passed by") if event.side else ("holds too much, by", "pushes what slides, at")
            return f"{event.name} {what[int(mode != 0)]} {-left[k]:.4g}"
    return None


def elements_of(model: EmittedModel, at: Mapping[str, np.ndarray], c: np.ndarray) -> dict[str, np.ndarray]:
    """The function `elements` at a state with constants c; what is one column is flat."""
    found = {name: np.asarray(one, dtype=float) for name, one in model.evaluate("elements", **at, c=c).items()}
    return {name: one if name in ("M_hat", "G") else one.ravel() for name, one in found.items()}


def _no_mode(broken: str) -> NoMode:
    return NoMode(f"{broken}: what was decided breaks a law of friction or stops", REMEDY)


def with_modes(model: EmittedModel) -> ca.Function:
    """(q_i, q_d, q_i_dot, q_d_dot, t, c) -> left (n_m,), v and v' (n_e,) with the modes among c: see `element_forces`.

    Exported C has this function, too.
    """

    def build() -> ca.Function:
        n_i, n_d = len(model.q_i), len(model.q_d)
        sizes = {"q_i": n_i, "q_d": n_d, "q_i_dot": n_i, "q_d_dot": n_d, "t": 1, "c": model.c_size}
        at = {name: ca.SX.sym(name, size) for name, size in sizes.items()}
        locked, own = model.evaluate("condensed", **at), model.evaluate("elements", **at)
        factors = factor(Number(ca.sparsify(locked["M_hat"])), symmetric=True)
        q_i_ddot = solve(factors, Number(locked["Q_hat"])).re
        found = model.evaluate("element_forces", **at, q_i_ddot=q_i_ddot)
        outputs = [found["mode_left"], found["v_rel"], own["G"] @ q_i_ddot + own["G_bias"]]
        return ca.Function(
            "with_modes", list(at.values()), shared([ca.densify(one) for one in outputs]), list(at), ["left", "v", "a"]
        )

    return model.derived("with_modes", build)

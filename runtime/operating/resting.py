"""Equilibria that rest on rigid stops: what would lie beyond a stop is put on it, none pulls."""

from __future__ import annotations

import numpy as np

from runtime.contract.errors import ModelError
from runtime.contract.model import Model
from runtime.operating.at_stops import MOST, ON_IT, gaps
from runtime.operating.balance import HALVINGS, LARGEST_STEP, MOST_PLACINGS, Clamped, Found
from runtime.operating.functions import PointValues
from runtime.operating.held_by_friction import held, state_of, with_modes

CLOSED = 1e-12  # m or rad
# With the gaps g >= 0 of stops and their forces f >= 0, g f = 0: an active set. Each round closes the stops that the
# last equilibrium is beyond and opens those that would pull; a closed stop locks its row in M_hat and Q_hat.


def on_stops(clamped: Clamped, found: Found, p: np.ndarray) -> tuple[Found, np.ndarray]:
    """From an equilibrium with all stops open the one that rests on those it is beyond, and p with their modes.

    `clamped` is left with the constants of that p. Where no choice comes out, the last is what is found.
    """
    model, iterations = clamped.model, found.iterations
    stops = np.array([bool(one.side) for one in model.mode_events])
    names = np.array([one.name for one in model.mode_events])
    for _ in range(MOST):
        at = clamped.values(found.x)
        if not found.converged or at is None:
            break
        now = p[len(p) - model.signals.size + model.element_modes]
        closed, gap = stops & (now == 0), _rows(clamped, at)[0]
        pulls = stops & np.isin(names, list(held(model, *state_of(clamped, at, found.x))[1]))
        off = (gap < -ON_IT) | closed & (gap > ON_IT)
        if not (off | pulls).any():
            break
        closed = (closed | off) & ~pulls
        placed = _placed(clamped, found.x, closed)
        if placed is None:
            clamped.loop = at.loop
            break
        p = with_modes(model, p, np.where(stops, np.where(closed, 0.0, 1.0), now))
        clamped.functions.c = model.constants(p)
        found = clamped.solve(placed)
        iterations += found.iterations
    return Found(found.x, found.converged, found.residual, iterations), p


def _rows(clamped: Clamped, at: PointValues) -> tuple[np.ndarray, np.ndarray]:
    """Gaps (n_m,), infinite for friction, and their slopes by q_i (n_m, n_i)."""
    events = clamped.model.mode_events
    side, gap = np.array([one.side for one in events]), np.full(len(events), np.inf)
    gap[side != 0], G = gaps(clamped.model, clamped.functions.c, clamped.t, at.q, at.q_dot)
    return gap, side[:, None] * G[[one.row for one in events]]


def _placed(clamped: Clamped, q_i: np.ndarray, closed: np.ndarray) -> np.ndarray | None:
    """The nearest q_i on the closed stops (n_m,) with clamped coordinates as they are; None if none is in reach."""
    for _ in range(MOST_PLACINGS):
        at = clamped.values(q_i)
        if at is None:
            return None
        gap, slopes = _rows(clamped, at)
        if np.abs(gap[closed]).max(initial=0.0) <= CLOSED:
            return q_i
        step = np.linalg.lstsq(slopes[closed] @ clamped.free(at), -gap[closed], rcond=1e-12)[0]
        step *= min(1.0, LARGEST_STEP / max(float(np.abs(step).max(initial=0.0)), 1e-300))
        for _ in range(HALVINGS):  # until the loops close from where they were
            there = clamped.advance(q_i, step)
            if there is not None and clamped.values(there) is not None:
                break
            step = 0.5 * step
        else:
            return None
        q_i = there
    return None


def refuse_beyond(model: Model, c: np.ndarray, t: float, q: np.ndarray, q_dot: np.ndarray) -> None:
    """Raises ModelError where an equilibrium is beyond a rigid stop all the same: what is held or turns is."""
    stops, (gap, _) = [one for one in model.mode_events if one.side], gaps(model, c, t, q, q_dot)
    beyond = {stops[k].name: -float(gap[k]) for k in np.flatnonzero(gap < -ON_IT)}
    if beyond:
        found = ", ".join(f"{by:.4g} beyond {name}" for name, by in beyond.items())
        remedy = "hold or turn other coordinates, begin elsewhere, or simulate with damping until it rests"
        raise ModelError(f"the equilibrium of model {model.name}", f"lies {found}", remedy)

"""What impacts on stops did: speeds, impulses, energies, by the records of native code or by one state."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from runtime.contract.coordinates import whole
from runtime.contract.model import EmittedModel
from runtime.engine.rows import evaluate
from runtime.schemes.switching.impulse import Impulse
from runtime.schemes.switching.native_events import EventRecord
from runtime.schemes.switching.stops import Impact


def impacts_of(record: EventRecord) -> list[Impact]:
    """In order; their restitution is not told."""
    found = []
    for k in record.hits:
        rests = float(record.rests[k])
        before, after, impulse = (float(one[k]) for one in (record.before, record.after, record.impulse))
        found.append(Impact(k, before, after, np.nan, impulse, rests if rests > 0 else None))
    return found


def impulse_given(
    model: EmittedModel, c: np.ndarray, t: float, at: Mapping[str, np.ndarray], v: np.ndarray, v_d: np.ndarray
) -> Impulse | None:
    """What the kinetic energy [J] and rates (n,) changed by at t [s] from a state to rates v (n_i,), v_d (n_d,)."""
    if not model.has("energy"):
        return None
    before = np.concatenate([*(at[name] for name in ("q_i", "q_d", "q_i_dot", "q_d_dot")), [t]])
    after = np.concatenate([at["q_i"], at["q_d"], v, v_d, [t]])
    return next(_impulses(model, c, before[None], after[None]))


def impacts_given(model: EmittedModel, c: np.ndarray, records: Sequence[EventRecord]) -> Iterator[Impulse | None]:
    """The same of each record, in order."""
    if not records or not model.has("energy"):
        return iter([None] * len(records))
    return _impulses(model, c, *(np.array([getattr(one, name) for one in records]) for name in ("at", "at_after")))


def _impulses(model: EmittedModel, c: np.ndarray, before: np.ndarray, after: np.ndarray) -> Iterator[Impulse]:
    """By states (N, 2 n + 1): q_i, q_d, q_i_dot, q_d_dot, t."""
    n_i, n = len(model.q_i), len(model.coordinates)
    q = whole(model, before[:, :n_i], before[:, n_i:n])
    rates = [whole(model, one[:, n : n + n_i], one[:, n + n_i : 2 * n]) for one in (before, after)]
    kinetic = [
        evaluate(model.kernel("energy"), {"q": q, "q_dot": v, "t": before[:, -1]}, c)["kinetic"].ravel() for v in rates
    ]
    gained, jumps = kinetic[1] - kinetic[0], rates[1] - rates[0]
    return (Impulse(float(energy), jump) for energy, jump in zip(gained, jumps, strict=True))

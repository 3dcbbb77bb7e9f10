"""A better q_i at a position: one coordinate of q_i changes places with a dependent one.

With dq_d = W dq_i, W = -C_qd^-1 C_qi, exchanging q_i[k] and q_d[j] multiplies |det C_qd| by |W_jk|. Coordinates are
compared as lengths: angles count times the mechanism's length.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from runtime.contract.coordinates import mechanism_length, turning_columns
from runtime.contract.model import Model
from runtime.contract.orientations import parameter_rates

CLEARLY = 3.0  # times larger determinant that is worth an exchange
LIKELY = 0.5  # of the largest gain: a loop unknown with that much is preferred, as closed forms stay closed forms


@dataclass(frozen=True)
class Exchange:
    """The coordinate of q_i that becomes dependent, the one that takes its place, and the gain in |det C_qd|."""

    out: str
    into: str
    gain: float

    def apply(self, names: list[str]) -> list[str]:
        """Names with the one in the other's place."""
        return [self.into if name == self.out else name for name in names]


def best_exchange(model: Model, q: np.ndarray, C_q: np.ndarray, length: float = 0.0) -> Exchange | None:
    """The exchange of a rigid coordinate that gains most at q (n,) and C_q (rows x n); None if C_qd is singular.

    length [m] of the mechanism elsewhere: the lever arms of C_q alone shrink to nothing where a single rod and the arm
    that it turns lie in one line, just where an angle is about to determine nothing. Turns whose velocities are angular
    velocities exchange with each other and with coordinates; all of an orientation may be independent, or none.
    """
    length = max(length, mechanism_length(model, C_q))
    names, slopes, scale = by_velocities(model, q, C_q, length)
    turning = {f"{record.body}.norm" for record in model.description.orientations}
    rows = [row for row in model.kept_rows if model.constraints[row] not in turning]
    given = set(model.places.parameters.ravel().tolist())  # Euler parameters follow from their turns
    own = {model.coordinates[column] for column in given}
    q_i, q_d = ([name for name in part if name not in own] for part in (model.q_i, model.q_d))
    i, d = ([names.index(name) for name in part] for part in (q_i, q_d))
    try:
        W = -np.linalg.solve(slopes[np.ix_(rows, d)], slopes[np.ix_(rows, i)])
    except np.linalg.LinAlgError:
        return None
    gains = np.abs(W) * scale[d][:, None] / scale[i][None, :]
    gains[[name in model.elastic for name in q_d]] = 0.0
    gains[:, [name in model.elastic for name in q_i]] = 0.0
    if not gains.size or not np.isfinite(gains).all():
        return None
    in_loop = np.array([name in model.loop_unknowns for name in q_d])
    preferred = np.where(in_loop[:, None], gains, 0.0)
    chosen = preferred if preferred.max() >= LIKELY * gains.max() else gains
    j, k = np.unravel_index(int(chosen.argmax()), chosen.shape)
    return Exchange(q_i[int(k)], q_d[int(j)], float(chosen[j, k]))


def by_velocities(
    model: Model, q: np.ndarray, C_q: np.ndarray, length: float
) -> tuple[list[str], np.ndarray, np.ndarray]:
    """(names, C_q by velocities, scales) of all coordinates, followed by the turns: along their angular velocities."""
    names, columns, scales = list(model.coordinates), [C_q], [np.where(turning_columns(model), length, 1.0)]
    for record, e in zip(model.description.orientations, model.places.parameters, strict=True):
        names += record.turns
        columns.append(C_q[:, e] @ parameter_rates(np.tile(q[e], (3, 1)), np.eye(3)).T)
        scales.append(np.full(3, length))
    return names, np.hstack(columns), np.concatenate(scales)

"""Consistent starts that are given by Euler angles: `consistent_state` with these in place of Euler parameters.

What was given or fixed of the angles stays as any other coordinate does, one by one; what comes back has Euler
parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from runtime.contract.angular import angular_velocity
from runtime.contract.consistent_state import ConsistentState, GivenValues, Residual, consistent_state
from runtime.contract.euler_angles import angle_names, angle_rates, angles, parameter_slopes, quaternion


@dataclass(frozen=True)
class AngleForm:
    """names: all coordinates; sequences: by body, of those whose angles stand for e0 ... e3."""

    names: list[str]
    sequences: Mapping[str, str]

    @cached_property
    def parameters(self) -> dict[str, list[int]]:
        """Columns of the Euler parameters, by body."""
        return {body: [self.names.index(f"{body}.e{k}") for k in range(4)] for body in self.sequences}

    @cached_property
    def plain(self) -> list[int]:
        """Columns that are the same in both."""
        turning = {column for columns in self.parameters.values() for column in columns}
        return [column for column in range(len(self.names)) if column not in turning]

    @cached_property
    def own(self) -> list[str]:
        """Names here: what is the same, then the angles."""
        turning = [name for body in self.sequences for name in angle_names(body)]
        return [*(self.names[column] for column in self.plain), *turning]

    def columns(self, body: str) -> list[int]:
        """Of a body's angles here."""
        return [self.own.index(name) for name in angle_names(body)]

    def chosen(self, columns: frozenset[int]) -> frozenset[int]:
        """Columns here of those of all coordinates; of a body's angles if its parameters are among them."""
        found = {k for k, column in enumerate(self.plain) if column in columns}
        for body, own in self.parameters.items():
            found |= set(self.columns(body)) if columns & set(own) else set()
        return frozenset(found)

    def seen(self, q: np.ndarray) -> np.ndarray:
        """Coordinates here of all coordinates (n,)."""
        turning = [angles(kind, q[self.parameters[body]]) for body, kind in self.sequences.items()]
        return np.concatenate([q[self.plain], *turning])

    def seen_rates(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """Rates here of all coordinates and rates (n,)."""
        turning = []
        for body, kind in self.sequences.items():
            e = q[self.parameters[body]]
            turning.append(angle_rates(kind, angles(kind, e), angular_velocity(e, q_dot[self.parameters[body]])))
        return np.concatenate([q_dot[self.plain], *turning])

    def whole(self, x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(all coordinates (n,), their slopes (n x n')) at x (n',)."""
        q, slope = np.zeros(len(self.names)), np.zeros((len(self.names), len(x)))
        q[self.plain] = x[: len(self.plain)]
        slope[self.plain, range(len(self.plain))] = 1.0
        for body, kind in self.sequences.items():
            own, columns = self.parameters[body], self.columns(body)
            q[own] = quaternion(kind, x[columns])
            slope[np.ix_(own, columns)] = parameter_slopes(kind, x[columns])
        return q, slope

    def fitting(self, x: np.ndarray, position: Residual) -> tuple[np.ndarray, np.ndarray]:
        """`whole`; of e and -e, which are one orientation, what fits better to the joints that place the body."""
        q, slope = self.whole(x)
        off = float(np.abs(position(q)[0]).max(initial=0.0))
        for own in self.parameters.values():
            other = q.copy()
            other[own] *= -1.0
            found = float(np.abs(position(other)[0]).max(initial=0.0))
            if found < off:
                q, off = other, found
                slope[own] *= -1.0
        return q, slope


def consistent_state_by_angles(
    sequences: Mapping[str, str],
    names: list[str],
    elastic: frozenset[int],
    owners: list[str],
    position: Residual,
    velocity: Callable[[np.ndarray], tuple[np.ndarray, np.ndarray]],
    coordinates: GivenValues,
    rates: GivenValues,
    guess: np.ndarray,
    reluctant: frozenset[int] = frozenset(),
    first: Sequence[int] = (),
    following: frozenset[int] = frozenset(),
    origins: frozenset[int] = frozenset(),
) -> ConsistentState:
    """`consistent_state` where angles of the bodies of `sequences` are given; columns are those of `names`.

    Raises InitialStateError.
    """
    if not sequences:
        return consistent_state(
            names, elastic, owners, position, velocity, coordinates, rates, guess, reluctant, first, following, origins
        )
    form = AngleForm(names, sequences)

    def position_by(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, slope = form.fitting(x, position)
        C, C_q = position(q)
        return C, C_q @ slope

    def velocity_by(x: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        q, slope = form.fitting(x, position)
        C_q, nu = velocity(q)
        return C_q @ slope, nu

    found = consistent_state(
        form.own,
        form.chosen(elastic),
        owners,
        position_by,
        velocity_by,
        coordinates,
        rates,
        form.seen(guess),
        form.chosen(reluctant),
        first,
        form.chosen(following),
        form.chosen(origins),
    )
    q, slope = form.fitting(found.q, position)
    placed, other = (None if x is None else form.whole(x)[0] for x in (found.placed, found.other))
    return replace(found, q=q, q_dot=slope @ found.q_dot, placed=placed, other=other)


def angle_bodies(names: Mapping[str, object], sequences: Mapping[str, str]) -> dict[str, str]:
    """Those of the sequences (by body) whose angles are among the names."""
    return {body: kind for body, kind in sequences.items() if not names.keys().isdisjoint(angle_names(body))}

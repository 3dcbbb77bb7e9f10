"""The global error of a motion, by coordinate: the difference of two ways to make the same motion, over its
amplitudes.

Everything that speaks of an error of a motion (runs, refinements, advice, comparisons) means the norms of this file.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import EmittedModel

# ---- What errors of coordinates are measured by.

SHARE = 1e-6  # of the largest amplitude of the same kind and unit: below this a coordinate does not move


def floored(model: EmittedModel, amplitudes: np.ndarray, share: float = SHARE) -> np.ndarray:
    """Amplitudes (N,) of what tells the motion (`followed`), none below a share of the largest of its kind and unit.

    1 where none of them moves.

    A mode that symmetry leaves at rounding is then measured by the modes that do move.
    """
    found = np.maximum(amplitudes, share * _largest_of_kind(model, amplitudes))
    return np.where(found > 0, found, 1.0)


def _kinds(model: EmittedModel) -> tuple[np.ndarray, np.ndarray]:
    """Of `followed` (N): which are of the kind and unit of which (N, N); which are angles of bodies (N,)."""

    def found() -> tuple[np.ndarray, np.ndarray]:
        known = {entry.name: entry for entry in model.description.coordinates}
        entries = [known[name] for name in followed(model)[0]]
        alike = [[(a.kind, a.unit) == (b.kind, b.unit) for b in entries] for a in entries]
        angles = [entry.unit == "rad" and not entry.elastic for entry in entries]
        return np.array(alike, dtype=bool), np.array(angles, dtype=bool)

    return model.derived("kinds of what tells a motion", found)


def _largest_of_kind(model: EmittedModel, values: np.ndarray) -> np.ndarray:
    """(N,) of each of `followed` the largest value (N,) of its kind and unit."""
    return np.asarray(np.where(_kinds(model)[0], values, -np.inf).max(axis=1, initial=-np.inf))


TURN_AMPLITUDE = np.pi / np.sqrt(3.0)  # rad: RMS about its mean of an angle that turns on and on, modulo a turn
ROUND = 2 * np.pi  # rad: what has turned further turns on and on
LOST_ERROR = 0.03  # of an amplitude: the time at which a motion that is lost in the end can be relied on no more
INTEGRAL = ".integral"  # the coordinate whose rate is a state
LEAST_AMPLITUDE = 1e-10  # m or rad, or of a coordinate's size: an amplitude counts as that at least
RESTS = 1e-6  # m/s or rad/s, or of a coordinate's size a second: a rate counts as that at least
STATIONARY = 0.1  # of the largest amplitude of its kind and unit: what moves less is not judged by its own


@dataclass(frozen=True)
class MotionError:
    """Errors of the coordinates that tell a motion (q_i, with Euler parameters in place of turns), by name.

    over_motion, at_end: RMS over the motion and size at its end [m, rad or 1]; amplitude: RMS of the coordinate about
    its mean, of an angle that turns on and on that of one turn. relative: over_motion over amplitude, none of which
    counts as less than a millionth of the largest of its kind. Those of `<state>.integral` are those of the
    state of a controller itself. reliable_until [s]: where the error grows beyond an
    amplitude, the time at which it passed 3 % of it, or where the motion breaks down with any other steps, the time
    of that. reason: why nothing was measured, "" where it was.
    """

    over_motion: dict[str, float] = field(default_factory=dict)
    at_end: dict[str, float] = field(default_factory=dict)
    amplitude: dict[str, float] = field(default_factory=dict)
    relative: dict[str, float] = field(default_factory=dict)
    judged: dict[str, float] = field(default_factory=dict, repr=False)  # relative, what hardly moves by what does
    reliable_until: float | None = None
    reason: str = ""

    def __str__(self) -> str:
        return f"{self.largest:.2g} of the amplitude of {self.of}" if self.measured else f"not measured: {self.reason}"

    def at_least(self, relative: float) -> MotionError:
        """The same where something else says that each coordinate is off by so much of its amplitude."""
        if not self.measured or relative <= 0.0:
            return self
        own = {name: max(value, relative) for name, value in self.relative.items()}
        over = {name: max(value, relative * self.amplitude.get(name, 0.0)) for name, value in self.over_motion.items()}
        return replace(
            self, relative=own, over_motion=over, judged={name: max(v, relative) for name, v in self.judged.items()}
        )

    @property
    def measured(self) -> bool:
        """Is there anything to tell?"""
        return not self.reason

    @property
    def of(self) -> str:
        """The coordinate with the largest relative error."""
        return self._worst.removesuffix(INTEGRAL)

    @property
    def _worst(self) -> str:
        return max(self.relative, key=lambda name: self.relative[name], default="")

    @property
    def largest(self) -> float:
        """The largest relative error; NaN where nothing was measured."""
        return self.relative[self._worst] if self.relative else np.nan

    def with_larger(self, other: MotionError) -> MotionError:
        """With what is larger of another one of the same motion, of each coordinate."""

        def larger(one: dict[str, float], another: dict[str, float]) -> dict[str, float]:
            return {name: max(value, another[name]) for name, value in one.items()}

        times = [one.reliable_until for one in (self, other) if one.reliable_until is not None]
        return replace(
            self,
            over_motion=larger(self.over_motion, other.over_motion),
            relative=larger(self.relative, other.relative),
            judged=larger(self.judged, other.judged),
            reliable_until=min(times, default=None),
        )

    def scaled(self, factor: float) -> MotionError:
        """With all errors multiplied."""

        def by(values: dict[str, float]) -> dict[str, float]:
            return {name: factor * value for name, value in values.items()}

        return replace(
            self,
            over_motion=by(self.over_motion),
            at_end=by(self.at_end),
            relative=by(self.relative),
            judged=by(self.judged),
        )


def amplitudes(model: EmittedModel, q: np.ndarray) -> np.ndarray:
    """(n_told,) RMS about the mean of what tells a motion, from samples q (N, n_told); a turn's of what turns on."""
    found = np.sqrt(np.mean((q - q.mean(axis=0)) ** 2, axis=0))
    return np.asarray(
        np.where(_kinds(model)[1] & (np.ptp(q, axis=0) > ROUND), np.minimum(found, TURN_AMPLITUDE), found)
    )


def _states(model: EmittedModel) -> np.ndarray:
    """(N,) which of `followed` are integrals of states: the states are judged, for their integrals hide chatter."""
    kinds = {entry.name: entry.kind for entry in model.description.coordinates}
    return np.array([kinds[name] == "state" for name in followed(model)[0]], dtype=bool)


def motion_error(
    model: EmittedModel,
    t: np.ndarray,
    q: np.ndarray,
    other: np.ndarray,
    sizes: np.ndarray,
    rates: tuple[np.ndarray, np.ndarray] | None = None,
    sampled_rates: np.ndarray | None = None,
) -> MotionError:
    """The difference of two motions at times t (N,) [s]: q, other (N, n_told); sizes: amplitudes (n_told,).

    rates, of both (N, n_told): it is judged by these, too, by their RMS, as `<coordinate>_dot`. seen_rates (M,
    n_told): those of the motion at other times, which tell their sizes, too.
    """
    names = followed(model)[0]
    off = np.abs(q - other)
    if rates is not None:
        off = np.where(_states(model), np.abs(rates[0] - rates[1]), off)
        known = np.concatenate(rates if sampled_rates is None else [*rates, sampled_rates])
        sizes = np.where(_states(model), np.std(known, axis=0), sizes)
    dust = LEAST_AMPLITUDE * np.maximum(
        1.0, np.abs(q).max(axis=0)
    )  # what stays where it is has an amplitude of rounding
    rms, least = np.sqrt(np.mean(off**2, axis=0)), np.maximum(floored(model, sizes), dust)
    judged = rms / np.maximum(floored(model, sizes, STATIONARY), dust)
    until = None
    if len(t) and (off / least > 1.0).any():
        until = float(t[int(np.argmax((off / least > LOST_ERROR).any(axis=1)))])

    def by_name(values: np.ndarray, end: str = "") -> dict[str, float]:
        return {name + end: value for name, value in zip(names, values.tolist(), strict=True)}

    by = by_name(judged) | ({} if rates is None else by_name(_of_rates(model, *rates, sampled_rates), "_dot"))
    return MotionError(by_name(rms), by_name(off[-1]), by_name(sizes), by_name(rms / least), by, reliable_until=until)


def _of_rates(model: EmittedModel, v: np.ndarray, other: np.ndarray, sampled: np.ndarray | None = None) -> np.ndarray:
    """(n_told,) what moves less than others of its kind is not judged by its own size."""
    known = [v, other] if sampled is None else [v, other, sampled]
    sizes = np.sqrt(np.mean(np.concatenate(known) ** 2, axis=0))
    rms = np.sqrt(np.mean((v - other) ** 2, axis=0))
    return np.asarray(rms / np.maximum(np.maximum(sizes, STATIONARY * _largest_of_kind(model, sizes)), RESTS))


def errors_of_many(model: EmittedModel, y: np.ndarray, other: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """(relative (cases, n_told), of rates (cases, n_told)) of many motions: `motion_error` of each.

    y, other (cases, 2 n_told, N): what tells the motions and its rates, at common times.
    """
    n, sizes_of_rates = y.shape[1] // 2, np.sqrt(np.mean(np.concatenate([y, other], axis=2) ** 2, axis=2))
    rms = np.sqrt(np.mean((y - other) ** 2, axis=2))
    both = np.concatenate([y, other], axis=2)
    sizes = np.std(both, axis=2)
    turns = _kinds(model)[1] & (np.ptp(both[:, :n], axis=2) > ROUND)
    amplitude = np.where(turns, np.minimum(sizes[:, :n], TURN_AMPLITUDE), sizes[:, :n])
    off = np.where(_states(model), rms[:, n:], rms[:, :n])
    amplitude = np.where(_states(model), sizes[:, n:], amplitude)
    alike = _kinds(model)[0][None]

    def largest(values: np.ndarray) -> np.ndarray:
        return np.asarray(np.where(alike, values[:, None, :], -np.inf).max(axis=2, initial=-np.inf))

    least = np.maximum(amplitude, SHARE * largest(amplitude))
    least = np.where(least > 0, least, 1.0)
    dust = LEAST_AMPLITUDE * np.maximum(1.0, np.abs(y[:, :n]).max(axis=2))
    v = sizes_of_rates[:, n:]
    rates = rms[:, n:] / np.maximum(np.maximum(v, STATIONARY * largest(v)), RESTS)
    return off / np.maximum(least, dust), rates

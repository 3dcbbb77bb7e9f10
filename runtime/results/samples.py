"""The saved states, forces, energies and measures of a motion, by name, and how it ended."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from threading import Lock
from typing import Any, Self

import numpy as np

from runtime.contract.arguments import arguments
from runtime.contract.coordinates import (
    independent_rates,
    named_values,
)
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.status import Event, Status
from runtime.results.motion_error import MotionError

# ---- Fields of a record that are computed when somebody asks for them.


class Later:
    """A value that is computed once, at the first call."""

    def __init__(self, compute: Callable[[], Any]) -> None:
        self._compute: Callable[[], Any] | None = compute
        self._value: Any = None
        self._lock = Lock()

    def __call__(self) -> Any:
        with self._lock:
            if self._compute is not None:
                self._value, self._compute = self._compute(), None
        return self._value

    def part(self, key: Any) -> Later:
        """An entry of the value."""
        return Later(lambda: self()[key])


class WithLater:
    """A dataclass some of whose fields may be given as `Later`: they are computed when they are read."""

    def __post_init__(self) -> None:
        own = vars(self)
        own["_later"] = {name: value for name, value in own.items() if isinstance(value, Later)}
        for name in own["_later"]:
            del own[name]

    def __getattr__(self, name: str) -> Any:
        later = vars(self).get("_later", {})
        if name not in later:
            raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")
        value = later[name]()
        vars(self)[name] = value
        return value

    def __getstate__(self) -> dict[str, Any]:
        for name in vars(self).get("_later", {}):
            getattr(self, name)
        return {**vars(self), "_later": {}}

    def but(self, **changes: Any) -> Self:
        """Copy it with other values of some fields.

        Parameters
        ----------
        **changes
            Fields by name with their new values.

        Returns
        -------
        Self
            The copy; what is not changed is shared.
        """
        found = object.__new__(type(self))
        vars(found).update(vars(self))
        vars(found)["_later"] = {name: one for name, one in vars(self)["_later"].items() if name not in changes}
        vars(found).update(changes)
        return found


# ---- The balance of energy and work of a motion, from its saved samples: energy - energy at the start - work.
#
# The work is the integral of P = power_applied + power_driven - power_dissipated: cubics through four samples next
# to one another, none of them across a stop, where power may jump; there those of both sides are continued to it.
# It is of order 4 where power is smooth. By how much it may be wrong is told by the work over every other sample.

STORED = ("kinetic", "elastic", "potential")
ONE_TIME_SHARE = 1e-12  # of a motion: times that are one
WINDOW = 4  # samples that a polynomial passes through
GAUSS = (1 - 3**-0.5) / 2, (1 + 3**-0.5) / 2  # of an interval: two points take cubics exactly


@dataclass(frozen=True)
class EnergyBalance:
    """Of N samples [J]: work (N,) since the first one, error (N,), and uncertainty (N,) of the work, which rises."""

    work: np.ndarray
    error: np.ndarray
    uncertainty: np.ndarray

    @property
    def largest(self) -> float:
        """Largest error [J]."""
        return float(np.abs(self.error).max(initial=0.0))

    @property
    def resolved(self) -> bool:
        """Do the samples tell the error, or is it within what they leave open?"""
        return len(self.work) > 2 and bool(self.uncertainty[-1] <= self.largest)

    def __str__(self) -> str:
        known = f"{self.largest:.3g} J"
        if self.resolved:
            return known
        return f"{known}, too few samples to check below {self.uncertainty[-1]:.2g} J"


def energy_balance(
    t: np.ndarray, energy: Mapping[str, np.ndarray], stops: np.ndarray, powers: np.ndarray | None = None
) -> EnergyBalance:
    """Of samples at t (N,) [s]; stops (S, 2): times [s], and the energy that an impulse put in there [J].

    powers (S, 4): power [W] and its rate [W/s] before each stop and behind it, NaN where they are not known. A sample
    at the very time of a stop shows what is before it.
    """
    total = np.sum([energy[name] for name in STORED], axis=0)
    P = energy["power_applied"] + energy["power_driven"] - energy["power_dissipated"]
    within = (stops[:, 0] >= t[0]) & (stops[:, 0] < t[-1])
    order = np.flatnonzero(within)[np.argsort(stops[within, 0], kind="stable")]
    times, put_in = stops[order].T
    sides = None if powers is None or len(powers) != len(stops) else powers[order]
    with np.errstate(all="ignore"):  # of samples that are not finite
        work, open_ = _integrals(t, P, times, sides)
        off = _difference_to_half(t, P, times, work, sides) + open_
        work = work + np.append(0.0, np.cumsum(put_in))[np.searchsorted(times, t, side="left")]
        return EnergyBalance(work, total - total[0] - work, off)


def _difference_to_half(
    t: np.ndarray, P: np.ndarray, stops: np.ndarray, work: np.ndarray, sides: np.ndarray | None
) -> np.ndarray:
    """(N,) largest difference until each sample to the integral over every other one."""
    n = len(t)
    if n < 3:
        return np.append(0.0, np.abs(np.diff(t) * np.diff(P) / 2))
    half = np.array([*range(0, n - 1, 2), n - 1])
    off = np.maximum.accumulate(np.abs(_integrals(t[half], P[half], stops, sides)[0] - work[half]))
    return np.asarray(off[np.searchsorted(half, np.arange(n))])


def integrals(t: np.ndarray, P: np.ndarray, stops: np.ndarray) -> np.ndarray:
    """(N,) integrals of P (N,) from the first sample on; stops (S,), rising, lie among the samples."""
    return _integrals(t, P, stops, None)[0]


def _integrals(
    t: np.ndarray, P: np.ndarray, stops: np.ndarray, sides: np.ndarray | None
) -> tuple[np.ndarray, np.ndarray]:
    """(integrals (N,), what is open (N,)) of P (N,); sides (S, 4): see `energy_balance`.

    Between two stops without a sample inside, of which power and rate are known, it is the cubic of these. Where few
    samples lie between them, what either rate adds to a trapezoid is open, as no others tell.
    """
    if len(t) < 2:
        return np.zeros(len(t)), np.zeros(len(t))
    piece = np.searchsorted(stops, t, side="left")  # of each sample: how many stops are before it
    at, values, own_piece = (t, P, piece) if sides is None else _with_sides(t, P, piece, stops, sides)
    ends = np.sort(np.concatenate([t, stops]))
    start, length = ends[:-1], np.diff(ends)
    own = np.searchsorted(stops, start, side="right")  # piece of each interval
    own = np.where(length > 0, own, piece[-1])
    sample = np.clip(np.searchsorted(t, start, side="right") - 1, 0, len(t) - 2)
    point = np.clip(np.searchsorted(at, start, side="right") - 1, 0, len(at) - 2)
    first, last = np.searchsorted(own_piece, own, side="left"), np.searchsorted(own_piece, own, side="right")
    alone = first == last  # no sample between two stops: a line through those beside them
    first, last = np.where(alone, point, first), np.where(alone, point + 2, last)
    count = np.minimum(last - first, WINDOW)
    begin = np.clip(point - 1, first, last - count)
    done, open_ = np.zeros(len(start)), np.zeros(len(start))
    for n in range(1, WINDOW + 1):
        of = np.flatnonzero(count == n)
        window = begin[of, None] + np.arange(n)
        for share in GAUSS:
            done[of] += length[of] / 2 * _interpolated(at[window], values[window], start[of] + share * length[of])
    if sides is not None and len(stops):
        before, behind = sides[np.clip(own, 0, len(stops) - 1), :2], sides[np.clip(own - 1, 0, len(stops) - 1), 2:]
        known = (own > 0) & (own < len(stops)) & np.isfinite(before).all(axis=1) & np.isfinite(behind).all(axis=1)
        few, width = known & (length > 0) & (last - first <= WINDOW), _widths(stops, own)
        cubic = length / 2 * (behind[:, 0] + before[:, 0]) + length**2 / 12 * (behind[:, 1] - before[:, 1])
        done = np.where(few & (last - first == 2), cubic, done)
        open_ = np.where(few, length * width / 12 * (np.abs(behind[:, 1]) + np.abs(before[:, 1])), 0.0)
    found = (np.append(0.0, np.cumsum(np.bincount(sample, one, minlength=len(t) - 1))) for one in (done, open_))
    return next(found), next(found)


def _widths(stops: np.ndarray, piece: np.ndarray) -> np.ndarray:
    """(K,) lengths of pieces between two stops [s]; infinite at the ends."""
    wide = np.concatenate([[np.inf], np.diff(stops), [np.inf]])
    return np.asarray(wide[piece])


def _with_sides(
    t: np.ndarray, P: np.ndarray, piece: np.ndarray, stops: np.ndarray, sides: np.ndarray
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Times, powers and pieces of samples and of what is known beside stops, in order; no time twice in a piece."""
    k = np.arange(len(stops))
    at, values = np.concatenate([t, stops, stops]), np.concatenate([P, sides[:, 0], sides[:, 2]])
    pieces, rank = np.concatenate([piece, k, k + 1]), np.repeat([0, 1, 1], [len(t), len(k), len(k)])
    known = np.isfinite(values) | (rank == 0)
    order = np.lexsort((rank[known], at[known], pieces[known]))
    at, values, pieces, rank = (one[known][order] for one in (at, values, pieces, rank))
    close = np.append(False, (np.diff(at) <= ONE_TIME_SHARE * (at[-1] - at[0])) & (np.diff(pieces) == 0))
    before = np.append(close[1:], False) & (rank == 1)  # a sample that follows at once is kept in its place
    keep = ~(close & (rank == 1)) & ~(before & np.append(rank[1:] == 0, False))
    return at[keep], values[keep], pieces[keep]


def _interpolated(t: np.ndarray, P: np.ndarray, at: np.ndarray) -> np.ndarray:
    """(K,) values at times (K,) of the polynomials through P (K, n) at t (K, n)."""
    found = np.zeros(len(at))
    for a in range(t.shape[1]):
        factor = P[:, a].copy()
        for b in range(t.shape[1]):
            if b != a:
                factor *= (at - t[:, b]) / (t[:, a] - t[:, b])
        found += factor
    return found


FORCE_PARTS = {
    3: ("force_x", "force_y", "moment"),
    6: ("force_x", "force_y", "force_z", "moment_x", "moment_y", "moment_z"),
}  # planar, spatial
SERIES = (
    "q",
    "q_dot",
    "q_ddot",
    "q_i",
    "lam",
    "joint_forces",
    "load_forces",
    "measures",
    "constraint_error",
    "constraint_rate_error",
)


@dataclass(repr=False)
class Samples(WithLater):
    """N saved samples of a model with n coordinates, n_i of them independent. SI units throughout.

    t (N,) [s]; q, q_dot, q_ddot (N, n) in the order of model.coordinates; q_i (N, n_i) in the order of model.q_i;
    lam (N, n_constraints), the multipliers of Eq. (37); energy: kinetic, elastic, potential (N,) [J] and
    power_dissipated (>= 0), power_applied, power_driven (N,) [W]; constraint_error (N,) = max |C| and
    constraint_rate_error (N,) = max |C_q q_dot + C_t|; stops (S, 2): times at which power may jump [s], and the energy
    that the impulse of a prescribed motion put in there [J]; powers (S, 4): power [W] and its rate before and behind
    each of them, NaN where they are not known;
    measures (N, len(model.measures)); joint_forces (N, joints, 3), in space (N, joints, 6): world force [N] and moment
    [N m] of each joint on its body b, at marker b; load_forces (N, loads, 3 or 6): those of each load on its marker or
    its marker b; frictions (N, joints with friction or rigid stops, 2): force along the joint's coordinate on body b
    [N or N m], and velocity; parameters: the vector p that was used; m: ratio of each next group's step; events: what
    happened on the way; outputs: the columns that a run with `outputs` kept at every saved
    sample, "t" first (all other arrays then hold the first and the last sample only); error: see MotionError;
    driven: inputs that functions, samples or controllers drove, with what their controllers remember at the end.
    """

    model: EmittedModel
    scheme: str
    dt: float
    m: list[int]
    parameters: np.ndarray
    t: np.ndarray
    q_i: np.ndarray
    q: np.ndarray
    q_dot: np.ndarray
    q_ddot: np.ndarray
    lam: np.ndarray
    energy: dict[str, np.ndarray]
    constraint_error: np.ndarray
    constraint_rate_error: np.ndarray
    measures: np.ndarray
    joint_forces: np.ndarray
    load_forces: np.ndarray
    stats: dict[str, float | int | str] = field(default_factory=dict)
    status: Status = field(default_factory=lambda: Status("completed", 0.0))
    events: list[Event] = field(default_factory=list)
    outputs: dict[str, np.ndarray] = field(default_factory=dict)
    stops: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))
    powers: np.ndarray = field(default_factory=lambda: np.zeros((0, 4)))
    frictions: np.ndarray = field(default_factory=lambda: np.zeros((0, 0, 2)))
    error: MotionError = field(default_factory=lambda: MotionError(reason="it was not requested"))
    driven: Mapping[str, list[float] | None] = field(default_factory=dict)

    def __repr__(self) -> str:
        return (
            f"<{type(self).__name__} of {self.model.name}: {self.scheme}, {len(self.t)} samples from "
            f"{self.t[0]:g} to {self.t[-1]:g} s, {self.status.name}>"
        )

    @arguments()
    def __getitem__(self, name: str) -> np.ndarray:
        """Column (N,) by name: a coordinate, its rate or acceleration (`_dot`, `_ddot`), or a measure.

        Raises ModelError for an unknown name.
        """
        for suffix, values in self._motion():
            names = [f"{coordinate}{suffix}" for coordinate in self.model.coordinates]
            if name in names:
                return values[:, names.index(name)]
        return self.measures[:, self.column_of(name, self.model.measures, "coordinate or measure")]

    def _motion(self) -> tuple[tuple[str, np.ndarray], ...]:
        return ("", self.q), ("_dot", self.q_dot), ("_ddot", self.q_ddot)

    def is_sampled(self, name: str) -> bool:
        """Say whether a name is a coordinate, a rate, an acceleration or a measure.

        Parameters
        ----------
        name : str
            Such as `rod.theta`, `rod.theta_dot` or the name of a measure.

        Returns
        -------
        bool
            False for what other columns hold, or for no name at all.
        """
        moving = (f"{coordinate}{suffix}" for suffix, _ in self._motion() for coordinate in self.model.coordinates)
        return name in self.model.measures or name in moving

    @arguments()
    def rate(self, name: str) -> np.ndarray:
        """Return the velocity of a coordinate.

        Parameters
        ----------
        name : str
            The coordinate.

        Returns
        -------
        np.ndarray, shape (N,)
            Its rate [m/s, rad/s] at the saved times.

        Raises
        ------
        ModelError
            For an unknown name.
        """
        return self.q_dot[:, self.column_of(name, self.model.coordinates, "coordinate")]

    @arguments()
    def acceleration(self, name: str) -> np.ndarray:
        """Return the acceleration of a coordinate.

        Parameters
        ----------
        name : str
            The coordinate.

        Returns
        -------
        np.ndarray, shape (N,)
            [m/s^2, rad/s^2] at the saved times.

        Raises
        ------
        ModelError
            For an unknown name.

        Notes
        -----
        Dependent coordinates follow from the independent ones by Eq. 35.
        """
        return self.q_ddot[:, self.column_of(name, self.model.coordinates, "coordinate")]

    @arguments()
    def multiplier(self, row: str) -> np.ndarray:
        """Return the multiplier of a constraint row.

        Parameters
        ----------
        row : str
            `joint.row`, one of `model.constraints`.

        Returns
        -------
        np.ndarray, shape (N,)
            lam [N, N m] at the saved times.

        Raises
        ------
        ModelError
            For an unknown name.

        Notes
        -----
        Multipliers are those of Eq. 37; the force of a row on q is -C_q^T lam (Eq. 22).
        """
        return self.lam[:, self.column_of(row, self.model.constraints, "constraint")]

    @arguments()
    def joint_force(self, joint: str) -> np.ndarray:
        """Return the reaction force and moment of a joint on its body b, at marker b, in world axes.

        Parameters
        ----------
        joint : str
            Name of the joint.

        Returns
        -------
        np.ndarray, shape (N, 3), in space (N, 6)
            Force x, y (z) [N], then moment [N m].

        Raises
        ------
        ModelError
            For an unknown joint.

        Notes
        -----
        They follow from the multipliers (Eqs. 22, 37).
        """
        return self.joint_forces[:, self.column_of(joint, self.model.joints, "joint")]

    @arguments()
    def load_force(self, load: str) -> np.ndarray:
        """Return force and moment of a load on its marker, or on its marker b, in world axes.

        Parameters
        ----------
        load : str
            Name of the load.

        Returns
        -------
        np.ndarray, shape (N, 3), in space (N, 6)
            Force x, y (z) [N], then moment [N m].

        Raises
        ------
        ModelError
            For an unknown load.
        """
        names = [record.name for record in self.model.description.loads]
        return self.load_forces[:, self.column_of(load, names, "load")]

    @arguments()
    def motor(self, name: str) -> np.ndarray:
        """Return what the drive of a prescribed motion puts on body b along the motion.

        Parameters
        ----------
        name : str
            The joint that prescribes an angle or a displacement.

        Returns
        -------
        np.ndarray, shape (N,)
            Torque [N m] or force [N].

        Raises
        ------
        ModelError
            For a joint that is not a prescribed motion.

        Notes
        -----
        It is -lam of the joint's row (Eq. 22), so that motor times prescribed rate is the power of the drive.
        """
        drives = [joint.name for joint in self.model.description.joints if joint.drawing == "drive"]
        if name not in drives:
            raise ModelError(
                f"model {self.model.name} has no prescribed motion {name!r}; it has {', '.join(drives) or 'none'}"
            )
        rows = [k for k, row in enumerate(self.model.description.constraints) if row.joint == name]
        return -self.lam[:, rows[0]]

    def column_of(self, name: str, names: Sequence[str], kind: str) -> int:
        """Find the place of a name among names.

        Parameters
        ----------
        name : str
            What is looked for.
        names : sequence of str
            Where.
        kind : str
            What the names are, for the message.

        Returns
        -------
        int
            The place.

        Raises
        ------
        ModelError
            For an unknown name.
        """
        if name not in names:
            known = [*self.model.coordinates, *self.model.measures] if "measure" in kind else list(names)
            listed = ", ".join(known[:20]) + (", ..." if len(known) > 20 else "")
            near = "".join(f"; did you mean {one!r}?" for one in get_close_matches(str(name)[:80], known, 1))
            raise ModelError(f"model {self.model.name} has no {kind} {name!r}; it has {listed or 'none'}{near}")
        return list(names).index(name)

    @property
    def step(self) -> str:
        """The step, for headers: `dt 0.001 s`, or `steps of 0.0046 s in the mean` where their lengths vary."""
        steps, span = self.stats.get("steps"), float(self.t[-1] - self.t[0]) if len(self.t) else 0.0
        if (
            "error_of = step" in str(self.stats.get("options", ""))
            and isinstance(steps, int)
            and steps > 0
            and span > 0
        ):
            return f"steps of {span / steps:.3g} s in the mean"
        return f"dt {self.dt:g} s"

    @property
    def pace(self) -> str:
        """The step, and the time between samples where that is another: `dt 0.001 s, seen every 0.01 s`."""
        seen = float(np.median(np.diff(self.t))) if len(self.t) > 1 else self.dt
        own = self.step
        alike = own == f"dt {self.dt:g} s" and abs(seen - self.dt) <= 0.01 * self.dt
        return own if alike else f"{own}, seen every {seen:.3g} s"

    @property
    def total_energy(self) -> np.ndarray:
        """Kinetic + elastic + potential energy (N,) [J]."""
        return np.asarray(np.sum([self.energy[key] for key in STORED], axis=0))

    @property
    def balance(self) -> EnergyBalance:
        """Of energy and work, with the uncertainty that the samples leave; split at `stops`."""
        return energy_balance(self.t, self.energy, self.stops, self.powers)

    def work(self) -> np.ndarray:
        """Sum the work of loads, drives and dampers over the samples.

        Returns
        -------
        np.ndarray, shape (N,)
            Work since the first sample [J].
        """
        return self.balance.work

    def energy_balance(self) -> np.ndarray:
        """Compare the total energy with the initial energy and the work.

        Returns
        -------
        np.ndarray, shape (N,)
            Total energy - initial energy - work [J]: zero for an exact solution that is sampled finely enough.

        Notes
        -----
        `balance` says how much of it the samples leave open.
        """
        return self.balance.error

    @arguments()
    def initial_values(self, at: float | None = None) -> dict[str, float]:
        """Return all coordinates and rates by name, as another run takes them for `initial`.

        Parameters
        ----------
        at : float, optional
            Time [s] whose nearest sample is taken; the last sample if left out.

        Returns
        -------
        dict of str to float
            Coordinates [m, rad] and, with `_dot`, rates [m/s, rad/s].

        Notes
        -----
        To go on from the last sample, give the solution itself as `initial`.
        """
        k = -1 if at is None else int(np.abs(self.t - at).argmin())
        return named_values(self.model, self.q[k], self.q_dot[k])

    @arguments()
    def interpolate(self, t: float | np.ndarray, what: str = "q") -> np.ndarray:
        """Interpolate between the saved samples.

        Parameters
        ----------
        t : float or array_like
            Times [s] within the saved ones.
        what : str
            "q", "q_i" or a coordinate (cubic Hermite polynomials through values and rates), "q_dot" (through
            rates and accelerations); "q_ddot", "lam", "measures", "constraint_error", or a measure or an energy
            (linearly).

        Returns
        -------
        np.ndarray
            Of the shape of t, then that of one sample.

        Raises
        ------
        ModelError
            For an unknown name.
        ValueError
            For a time outside the saved ones.

        Notes
        -----
        Cubic Hermite polynomials have an error of fourth order in the time between samples.

        References
        ----------
        E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed., Springer, 1993,
        section II.6.
        """
        times = np.asarray(t, dtype=float)
        dust = 64 * np.finfo(float).eps * max(abs(self.t[0]), abs(self.t[-1]))  # a sample at a jump is behind it
        times = np.where((times < self.t[0]) & (times >= self.t[0] - dust), self.t[0], times)
        if times.size and not (times.min() >= self.t[0] and times.max() <= self.t[-1]):
            raise ArgumentError(f"interpolation time outside the saved ones, {self.t[0]:.9g} ... {self.t[-1]:.9g} s")
        values, slopes = self._samples(what)
        flat = (
            _linear(self.t, values, times.ravel())
            if slopes is None or len(self.t) < 2
            else _hermite(self.t, values, slopes, times.ravel())
        )
        return flat.reshape(times.shape + values.shape[1:])

    def _samples(self, what: str) -> tuple[np.ndarray, np.ndarray | None]:
        """(values, slopes or None) of a series or a single quantity."""
        if what in self.model.coordinates:
            return self[what], self.rate(what)
        if what in self.energy:
            return self.energy[what], None
        if what not in SERIES:
            return self[what], None
        rates = independent_rates(self.model, self.q, self.q_dot)
        slopes = {"q": self.q_dot, "q_dot": self.q_ddot, "q_i": rates}
        return getattr(self, what), slopes.get(what)


def _linear(t: np.ndarray, values: np.ndarray, times: np.ndarray) -> np.ndarray:
    if len(t) < 2:
        return np.repeat(values[:1], len(times), axis=0)
    k = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    s = ((times - t[k]) / (t[k + 1] - t[k])).reshape(-1, *([1] * (values.ndim - 1)))
    return np.asarray((1.0 - s) * values[k] + s * values[k + 1])


def _hermite(t: np.ndarray, values: np.ndarray, slopes: np.ndarray, times: np.ndarray) -> np.ndarray:
    """Cubic polynomials with the samples' values and slopes."""
    k = np.clip(np.searchsorted(t, times, side="right") - 1, 0, len(t) - 2)
    shape = (-1, *([1] * (values.ndim - 1)))
    h = (t[k + 1] - t[k]).reshape(shape)
    s = (times - t[k]).reshape(shape) / h
    left = (1.0 + 2.0 * s) * (1.0 - s) ** 2 * values[k] + s * (1.0 - s) ** 2 * h * slopes[k]
    right = s**2 * (3.0 - 2.0 * s) * values[k + 1] - s**2 * (1.0 - s) * h * slopes[k + 1]
    return np.asarray(left + right)

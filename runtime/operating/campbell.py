"""Frequencies along a speed or a parameter, each mode followed through crossings."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, NUMBERS, arguments
from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.files import write_text
from runtime.contract.model import EmittedModel
from runtime.operating.equilibrium import Equilibrium, equilibrium, turning_name
from runtime.operating.linearisation import Linearisation
from runtime.operating.linearise import linearise
from runtime.results.samples import Samples

# ---- Which mode is which after a parameter has changed: by the likeness of shapes, not by order.

SURE = 0.7  # modal assurance from which two shapes are the same mode
MOST_INTERVAL_HALVINGS = 6  # of an interval in which shapes change too much to tell
DISTANCE = 0.1  # weight of the eigenvalues' distance beside the assurance: decides between equal shapes


@dataclass(frozen=True)
class ModeState:
    """Eigenvalues (n,) [1/s], frequencies (n,) [rad/s], damping ratios, shapes (n_x, n), and the mass matrix.

    A column that is NaN is a mode that is gone: two real eigenvalues have become a pair, or the other way round.
    """

    eigenvalues: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    shapes: np.ndarray
    M: np.ndarray
    names: list[str]

    @staticmethod
    def of(system: Linearisation) -> ModeState:
        """The modes of a linear system."""
        return ModeState(
            system.eigenvalues,
            system.frequencies,
            system.damping_ratios,
            system.shapes,
            system.M,
            system.mode_names,
        )

    def ordered(self, order: np.ndarray) -> ModeState:
        """The same modes in another order, -1: none."""
        none = order < 0
        return ModeState(
            np.where(none, np.nan, self.eigenvalues[order]),
            np.where(none, np.nan, self.frequencies[order]),
            np.where(none, np.nan, self.damping_ratios[order]),
            np.where(none, np.nan, self.shapes[:, order]),
            self.M,
            ["" if k < 0 else self.names[k] for k in order],
        )


@dataclass(frozen=True, eq=False, repr=False)
class Followed:
    """Modes at N values, a column a mode, followed by modal assurance: frequencies (N, n) [rad/s], damping_ratios
    (N, n), eigenvalues (N, n) [1/s], shapes (N, n_x, n); names: of each mode where it is met first.

    Real modes of controllers come and go, two of them for an oscillating one: NaN where a mode is not there.
    """

    frequencies: np.ndarray
    damping_ratios: np.ndarray
    eigenvalues: np.ndarray
    shapes: np.ndarray
    names: list[str]


def followed_modes(found: list[ModeState]) -> dict[str, Any]:
    """Fields of `Followed`, of what `tracked` gives at one value after the other: columns may have come on the way."""
    n = len(found[-1].eigenvalues)
    whole = [modes.ordered(np.r_[: len(modes.names), np.full(n - len(modes.names), -1)]) for modes in found]
    names = [next(modes.names[k] for modes in whole if modes.names[k]) for k in range(n)]
    arrays = ("frequencies", "damping_ratios", "eigenvalues", "shapes")
    return {name: np.array([getattr(modes, name) for modes in whole]) for name in arrays} | {"names": names}


def modal_assurance(left: np.ndarray, right: np.ndarray, M: np.ndarray) -> np.ndarray:
    """(n_left, n_right) |a^H M b|^2 / (a^H M a  b^H M b) of complex shapes, columns: 1 for equal, 0 for orthogonal."""
    cross = np.abs(left.conj().T @ M @ right) ** 2
    sizes = [np.real(np.einsum("ik,ij,jk->k", shapes.conj(), M, shapes)) for shapes in (left, right)]
    return np.asarray(cross / np.maximum(np.outer(*sizes), 1e-300))


def tracked(
    before: ModeState,
    after: ModeState,
    first: float,
    last: float,
    at: Callable[[float], ModeState],
    left: int = MOST_INTERVAL_HALVINGS,
) -> ModeState:
    """The modes `after` (at value `last`) in the order of those `before` (at `first`).

    at(value) gives the modes in between, which are asked for where shapes change too much to be told, and where two
    modes change places: frequencies that veer apart look like a crossing from afar.
    """
    order, sure = _matched(before, after)
    met = order[np.argsort(before.frequencies, kind="stable")]
    crossed = bool(np.any(np.diff(met[met >= 0]) < 0))
    if not left or (sure and not crossed):
        return after.ordered(order)
    middle = 0.5 * (first + last)
    between = tracked(before, at(middle), first, middle, at, left - 1)
    return tracked(between, after, middle, last, at, left - 1)


def _matched(before: ModeState, after: ModeState) -> tuple[np.ndarray, bool]:
    """(for each column before, the mode of `after`, -1: none, and behind them those that are new; are pairs alike?).

    A new mode takes a column that was empty.
    """
    there = np.flatnonzero(np.isfinite(before.frequencies))
    likeness = modal_assurance(before.shapes[:, there], after.shapes, 0.5 * (before.M + after.M))
    apart = np.abs(before.eigenvalues[there, None] - after.eigenvalues[None, :])
    scale = np.abs(before.eigenvalues)[there, None] + np.abs(after.eigenvalues)[None, :]
    from scipy.optimize import linear_sum_assignment  # when it is needed: importing it takes long

    rows, columns = linear_sum_assignment(-likeness + DISTANCE * apart / np.maximum(scale, 1e-300))
    order = np.full(len(before.frequencies), -1)
    order[there[rows]] = columns
    new = [k for k in range(len(after.names)) if k not in columns]
    empty = np.flatnonzero(~np.isfinite(before.frequencies))[: len(new)]
    order[empty] = new[: len(empty)]
    return np.r_[order, new[len(empty) :]].astype(int), bool(likeness[rows, columns].min(initial=1.0) >= SURE)


CAMPBELL_POINTS = 25


@dataclass(frozen=True, eq=False, repr=False)
class Campbell(Followed):
    """Modes at N values (N,) of a speed or parameter.

    over: what changes, is_speed: is it a rate; coordinates (n_x): of the shapes; remarked: what `remarks()` gives.
    """

    model: EmittedModel
    over: str
    values: np.ndarray
    coordinates: list[str]
    remarked: list[str]
    is_speed: bool

    def crossings(self, order: float = 1.0) -> list[tuple[int, float]]:
        """(mode, value) where a frequency meets `order` times the value: critical speeds, linear between values."""
        found = []
        for mode in range(self.frequencies.shape[1]):
            gap = self.frequencies[:, mode] - order * self.values
            for k in np.flatnonzero(gap[:-1] * gap[1:] < 0):
                share = gap[k] / (gap[k] - gap[k + 1])
                found.append((mode, float(self.values[k] + share * (self.values[k + 1] - self.values[k]))))
        return found

    def remarks(self) -> list[str]:
        """What to know about these modes, each with the first value that it was made at; see `Linearisation`."""
        return list(self.remarked)

    def write_csv(self, path: str | Path) -> None:
        """One row a value: the value, all frequencies [rad/s], all damping ratios. Raises OutputError."""
        n = self.frequencies.shape[1]
        header = [self.over, *(f"w{k + 1} [rad/s]" for k in range(n)), *(f"zeta{k + 1}" for k in range(n))]
        rows = np.hstack([self.values[:, None], self.frequencies, self.damping_ratios])
        write_text(
            Path(path), "\n".join([",".join(header), *(",".join(map(repr, row.tolist())) for row in rows)]) + "\n"
        )

    def __repr__(self) -> str:
        return (
            f"<Campbell of {self.model.name}: {self.frequencies.shape[1]} modes at {len(self.values)} values of "
            f"{self.over} from {self.values[0]:g} to {self.values[-1]:g}>"
        )


@arguments(held=BY_NAME, rates=BY_NAME, parameters=BY_NAME, locked=NAMES, t=NUMBER)
def campbell(
    model: EmittedModel,
    over: str,
    values: Sequence[float] | np.ndarray,
    *,
    held: Mapping[str, float] | None = None,
    rates: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
    t: float = 0.0,
) -> Campbell:
    """Follow the modes over a speed or a parameter.

    Parameters
    ----------
    model : Model
        The mechanism.
    over : str
        A parameter, a rate (`hub.theta_dot` [rad/s]), or `hub.omega` of a body that turns in space [rad/s].
    values : array_like (k,)
        Its values, in its SI unit.
    held, rates, parameters : mapping of str to float, optional
        As of `equilibrium`.
    locked : sequence of str, optional
        As of `linearise`.
    t : float, optional
        `at_time` of `equilibrium` [s], so that prescribed motions move.

    Returns
    -------
    Campbell
        Frequencies (k, n) [rad/s], damping ratios (k, n) and names (n,) of the followed modes.

    Raises
    ------
    ModelError, NoEquilibrium, ArgumentError
        For what cannot be used (no values, for instance), and where no equilibrium is reached.

    Notes
    -----
    Each equilibrium starts from the one before; modes are followed by their shapes, with values put in between where
    they turn too far.

    References
    ----------
    G. Genta, Dynamics of Rotating Systems, Springer, 2005.
    """
    wanted = np.asarray(values, dtype=float)
    if wanted.ndim != 1 or not len(wanted) or not np.isfinite(wanted).all():
        raise ArgumentError("campbell needs at least one finite value")
    sweep = Sweep(model, over, held or {}, rates or {}, parameters or {}, locked, t)
    found: list[ModeState] = []
    remarks: dict[str, float] = {}
    for k, value in enumerate(wanted):
        system = sweep.system(float(value))
        modes = ModeState.of(system)
        if k:
            modes = tracked(
                found[-1], modes, float(wanted[k - 1]), float(value), lambda at: ModeState.of(sweep.system(at))
            )
        found.append(modes)
        remarks |= {remark: float(value) for remark in system.remarks() if remark not in remarks}
    return Campbell(
        **followed_modes(found),
        model=model,
        over=over,
        values=wanted,
        coordinates=system.names,
        remarked=[f"from {over} = {value:g} on: {remark}" for remark, value in remarks.items()],
        is_speed=not sweep.is_parameter,
    )


class Sweep:
    """Linear systems of a model at values of a parameter or rate."""

    def __init__(
        self,
        model: EmittedModel,
        over: str,
        held: Mapping[str, float],
        rates: Mapping[str, float],
        parameters: Mapping[str, float],
        locked: Sequence[str] | None = None,
        t: float = 0.0,
        inputs: Sequence[str] = (),
        outputs: Sequence[str] = (),
    ) -> None:
        self.model, self.held, self.rates, self.parameters = model, held, rates, parameters
        self.locked, self.t, self.inputs, self.outputs = locked, t, inputs, outputs
        self.is_parameter = over in [parameter.name for parameter in model.parameters]
        self.over = over if self.is_parameter else _rate_of(model, over)
        self._last: Equilibrium | None = None

    def system(self, value: float) -> Linearisation:
        """The linear system at one value, about the equilibrium that is reached from the one before."""
        rates, parameters = dict(self.rates), dict(self.parameters)
        (parameters if self.is_parameter else rates)[self.over] = value
        last = self._last
        initial = (
            {} if last is None else {name: last[name] for name in followed(self.model)[0] if name not in self.held}
        )
        self._last = equilibrium(self.model, self.held, rates, parameters=parameters, initial=initial, at_time=self.t)
        return linearise(self.model, self._last, inputs=self.inputs, outputs=self.outputs, locked=self.locked)


def _rate_of(model: EmittedModel, over: str) -> str:
    """The coordinate or turn whose rate is meant: by the rate's name, its own, or `hub.omega`. Raises ModelError."""
    return next((name for name in model.coordinates if over == f"{name}_dot"), None) or turning_name(model, over)


# ---- The steady response of a rotor to an unbalance: a force that turns with it.


@dataclass(frozen=True)
class UnbalanceResponse:
    """Complex amplitudes (N, n_y) of the outputs at N speeds [rad/s]: y(t) = Re(amplitude exp(i speed t))."""

    speeds: np.ndarray
    outputs: list[str]
    amplitudes: np.ndarray


@arguments(speeds=NUMBERS, at=NAMES, unbalance=NUMBER, outputs=NAMES, held=BY_NAME, parameters=BY_NAME, locked=NAMES)
def unbalance_response(
    model: EmittedModel,
    over: str,
    speeds: Sequence[float] | np.ndarray,
    *,
    at: tuple[str, str],
    unbalance: float,
    outputs: Sequence[str] | None = None,
    held: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
) -> UnbalanceResponse:
    """Find the steady whirl of a rotor with an unbalance at each speed, to first order.

    Parameters
    ----------
    model : Model
        The mechanism.
    over : str
        The rate that is the speed, such as `disk.omega`.
    speeds : array_like (k,)
        Speeds [rad/s].
    at : (str, str)
        The two coordinates [m] across the axle at which the force acts, for a rotor that turns from the first to the
        second.
    unbalance : float
        Mass times eccentricity U [kg m].
    outputs : sequence of str, optional
        What is told; these two coordinates by default.
    held, parameters : mapping of str to float, optional
        As of `equilibrium`.
    locked : sequence of str, optional
        As of `linearise`.

    Returns
    -------
    UnbalanceResponse
        Complex amplitudes of the outputs at each speed.

    Raises
    ------
    ModelError, NoEquilibrium
        For what cannot be used, and where no equilibrium is reached.
    NoResult
        At a speed where the whirl grows without bound.

    Notes
    -----
    The force is U speed^2 (cos, sin)(speed t) on the linear system of each speed, gyroscopic terms included.
    """
    names = list(outputs if outputs is not None else at)
    for name in at:
        if name not in model.coordinates:
            raise ModelError(f"model {model.name} has no coordinate {name!r} for the unbalance to act on")
    rows = [model.coordinates.index(name) for name in at]
    sweep = Sweep(model, over, held or {}, {}, parameters or {}, locked, outputs=names)
    wanted = np.asarray(speeds, dtype=float)
    result = np.zeros((len(wanted), len(names)), dtype=complex)
    for k, speed in enumerate(wanted):
        system = sweep.system(float(speed))
        force = unbalance * speed**2 * (system.S[rows[0]] - 1j * system.S[rows[1]])
        result[k] = system.response(float(speed), force)
    return UnbalanceResponse(wanted, names, result)


# ---- Frequencies of the equations linearised along a motion: how stiff the mechanism is on its way.


@dataclass(frozen=True, eq=False, repr=False)
class FrequenciesAlong(Followed):
    """Modes at N moments t (N,) [s] of a run; frequencies are |lambda|, damping ratios negative where a mode grows."""

    t: np.ndarray


def frequencies_along(solution: Samples, samples: int = 60) -> FrequenciesAlong:
    """Eigenvalues of M x'' + D x' + K x = 0 about at most `samples` saved states of a run, equally spaced.

    The states are no equilibria: K holds what the accelerations there add, d(M_hat a - Q_hat)/dq at fixed a.
    Raises ModelError where the model lacks its Jacobians, ArgumentError for fewer than two samples.
    """
    if samples < 2:
        raise ArgumentError(f"samples must be at least 2, not {samples}")
    last = len(solution.t) - 1
    chosen = np.unique(np.linspace(0, last, min(samples, last + 1)).round().astype(int))

    def modes_at(sample: float) -> ModeState:
        return ModeState.of(linearise(solution.model, (solution, int(round(sample))), inputs=[], outputs=[]))

    found = [modes_at(chosen[0])]
    for before, here in zip(chosen[:-1], chosen[1:], strict=True):
        halvings = int(np.log2(here - before))  # no more than there are samples in between
        found.append(tracked(found[-1], modes_at(here), float(before), float(here), modes_at, halvings))
    return FrequenciesAlong(**followed_modes(found), t=solution.t[chosen])

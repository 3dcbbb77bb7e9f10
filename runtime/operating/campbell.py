"""Frequencies along a speed or a parameter, each mode followed through crossings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError
from runtime.contract.files import write_text
from runtime.contract.model import Model
from runtime.operating.equilibrium import Equilibrium, equilibrium, turning_name
from runtime.operating.linearisation import Linearisation
from runtime.operating.linearise import linearise
from runtime.operating.tracking import Followed, ModeState, tracked

POINTS = 25


@dataclass(frozen=True, repr=False)
class Campbell:
    """N values of a speed or parameter and the n modes there, a column a mode, followed by modal assurance.

    over: what changes, is_speed: is it a rate; values (N,); frequencies (N, n) [rad/s]; damping_ratios (N, n);
    eigenvalues (N, n) [1/s]; shapes (N, n_x, n): [value, coordinate, mode]; names: the modes' where they are met
    first; coordinates (n_x); remarked: what `remarks()` gives. Real modes of controllers come
    and go, two of them for an oscillating one: NaN where a mode is not there.
    """

    model: Model
    over: str
    values: np.ndarray
    frequencies: np.ndarray
    damping_ratios: np.ndarray
    eigenvalues: np.ndarray
    shapes: np.ndarray
    names: list[str]
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


def campbell(
    model: Model,
    over: str,
    values: Sequence[float] | np.ndarray,
    *,
    held: Mapping[str, float] | None = None,
    rates: Mapping[str, float] | None = None,
    parameters: Mapping[str, float] | None = None,
    locked: Sequence[str] | None = None,
    t: float = 0.0,
) -> Campbell:
    """Modes at equilibria along `values` of `over`: a parameter, a rate (`hub.theta_dot`), or `hub.omega`.

    Each equilibrium starts from the one before. held, rates, parameters: see `equilibrium`;
    t: its `at_time` [s], so that prescribed motions move; locked: see `linearise`.
    Raises ModelError, NoEquilibrium and ArgumentError (no values).
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
    followed = Followed.of(found)
    return Campbell(
        model,
        over,
        wanted,
        followed.frequencies,
        followed.damping_ratios,
        followed.eigenvalues,
        followed.shapes,
        followed.names,
        system.names,
        [f"from {over} = {value:g} on: {remark}" for remark, value in remarks.items()],
        not sweep.is_parameter,
    )


class Sweep:
    """Linear systems of a model at values of a parameter or rate."""

    def __init__(
        self,
        model: Model,
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


def _rate_of(model: Model, over: str) -> str:
    """The coordinate or turn whose rate is meant: by the rate's name, its own, or `hub.omega`. Raises ModelError."""
    return next((name for name in model.coordinates if over == f"{name}_dot"), None) or turning_name(model, over)

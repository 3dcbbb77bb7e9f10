"""Frequencies along a speed or a parameter, each mode followed through crossings."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, NUMBER, arguments
from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError
from runtime.contract.files import write_text
from runtime.contract.model import EmittedModel
from runtime.operating.equilibrium import Equilibrium, equilibrium, turning_name
from runtime.operating.linearisation import Linearisation
from runtime.operating.linearise import linearise
from runtime.operating.mode_tracking import Followed, ModeState, followed_modes, tracked

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

"""The numbers x = (q_i, q_i_dot) of a state: their names, and what a run is given and shows for them.

Of a body that turns freely they are its rotation vector theta from the axes of the ground and its angular velocity in
its own axes. theta and theta (1 - 2 pi / |theta|) are one orientation (Euler parameters e and -e): whatever is compared
with another state takes the one that is nearer. Of a controller's state only the value counts, which is a rate; its
integral, on which nothing depends, need not repeat and is left out.
"""

from __future__ import annotations

from functools import cached_property

import numpy as np

from runtime.contract.coordinates import OMEGA, independent_slopes, parts, rate_parts
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import chart_rates, exponential, rotation_vector
from runtime.gradients.variables import independent_turns


class States:
    """Of a model. Raises ModelError where loops hold some, but not all, turns of a body."""

    def __init__(self, model: EmittedModel) -> None:
        at = model.places
        if at.split:
            raise ModelError(
                f"model {model.name} has bodies whose rotation is partly constrained by loops: periodic motions "
                "are found where all turns of a body are in q_i or none; put hinges or universal joints there"
            )
        self.model = model
        self._own = independent_turns(model)
        self._turns, self._e = at.turns[self._own], at.parameters[self._own]
        self._columns = np.concatenate([at.columns, self._e.ravel()])
        self._places = [k for k in range(at.n_i) if k not in model.states]

    @cached_property
    def places(self) -> list[str]:
        """Names of the coordinates and turns in x."""
        return [self.model.q_i[k] for k in self._places]

    @property
    def own(self) -> int:
        """Numbers of the motion itself in x: q_i and their rates."""
        return len(self._places) + len(self.model.q_i)

    @cached_property
    def names(self) -> list[str]:
        """(n) of x, as a run is differentiated by them."""
        rates = [f"{name}_dot" for name in self.model.q_i]
        for turns, body in zip(self._turns, self._bodies, strict=True):
            for k, axis in zip(turns, OMEGA, strict=True):
                rates[k] = f"{body}.{axis}"
        return [*self.places, *rates]

    @cached_property
    def outputs(self) -> list[str]:
        """Of a run that shows x and its rates."""
        own = [self.model.coordinates[k] for k in self._columns]
        return [f"{name}{end}" for end in ("", "_dot", "_ddot") for name in own]

    @cached_property
    def upright(self) -> dict[str, float]:
        """Initial values by name: the orientations that theta counts from."""
        return {name: float(k == 0) for e in self._named_parameters for k, name in enumerate(e)}

    @property
    def _bodies(self) -> list[str]:
        records = self.model.description.orientations
        return [records[k].body for k in self._own]

    @property
    def _named_parameters(self) -> list[list[str]]:
        return [[self.model.coordinates[k] for k in e] for e in self._e]

    # ---- x from what is known of a motion, and back --------------------------------------------------------------

    def of(self, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
        """(n,) of all coordinates and rates (n_q,); rotation vectors of at most half a turn."""
        q_i, v = parts(self.model, q)[0], rate_parts(self.model, q, q_dot)[0]
        x = np.concatenate([q_i[self._places], v])
        return self.near(x, np.zeros(len(x)))

    def by_name(self, x: np.ndarray) -> dict[str, float]:
        """Initial values: coordinates and rates, Euler parameters and angular velocities of bodies that turn freely."""
        found = dict(zip(self.names, x.tolist(), strict=True))
        for rows, e in zip(self._rows, self._named_parameters, strict=True):
            for row in rows:
                del found[self.names[row]]
            found |= dict(zip(e, exponential(x[rows]).tolist(), strict=True))
        return found

    def near(self, x: np.ndarray, other: np.ndarray) -> np.ndarray:
        """x (n,) with those rotation vectors that are nearer to another's."""
        found = x.copy()
        for rows in self._rows:
            size = np.linalg.norm(x[rows])
            again = x[rows] * (1 - 2 * np.pi / size) if size > 0 else x[rows]
            if np.linalg.norm(again - other[rows]) < np.linalg.norm(x[rows] - other[rows]):
                found[rows] = again
        return found

    @cached_property
    def _rows(self) -> list[list[int]]:
        """Where rotation vectors stand in x."""
        return [[self._places.index(k) for k in turns] for turns in self._turns]

    def sizes(self, x: np.ndarray, period: float) -> np.ndarray:
        """(n,) by which a state x (n,) is judged: a coordinate's size, or what its rate makes of it; rates alike."""
        v = np.abs(x[len(self.places) :])
        q = np.zeros_like(v)
        q[self._places] = np.abs(x[: len(self.places)])
        own = np.maximum(q, v * period / (2 * np.pi))
        own = np.maximum(own, 1e-6 * own.max(initial=1e-12))  # what hardly moves is judged by what does
        return np.concatenate([own[self._places], own * 2 * np.pi / period])

    def whole_turns(self, moved: np.ndarray) -> np.ndarray:
        """(n,) 2 pi k of the angles in a change of state (n,), zero elsewhere."""
        angles = {one.name for one in self.model.description.coordinates if one.unit == "rad" and not one.elastic}
        found = np.zeros(len(moved))
        for k, name in enumerate(self.places):
            if name in angles:
                found[k] = 2 * np.pi * np.rint(moved[k] / (2 * np.pi))
        return found

    # ---- x from what a run shows --------------------------------------------------------------------------------

    def state_of_outputs(self, shown: np.ndarray, beside: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(x, its rates) (n,) of the outputs of a run (n_y,), near to the state `beside`."""
        q, v, a = self._whole(shown)
        x = self.near(self.of(q, v), beside)
        v_i, a_i = rate_parts(self.model, q, v)[0], rate_parts(self.model, q, a)[0]
        rates = v_i.copy()
        for turns, rows in zip(self._turns, self._rows, strict=True):
            rates[turns] = chart_rates(x[rows]) @ v_i[turns]
        return x, np.concatenate([rates[self._places], a_i])

    def slopes(self, shown: np.ndarray, by: np.ndarray, x: np.ndarray) -> np.ndarray:
        """(n, k) of x of the outputs of a run (n_y,), by whatever those are differentiated by (n_y, k)."""
        q, v, _ = self._whole(shown)
        dq, dv, _ = self._whole(by)
        for e, rows in zip(self._e, self._rows, strict=True):  # e or -e, as x has it
            if np.linalg.norm(rotation_vector(q[e]) - x[rows]) > 1.0:
                for values in (q, v, dq, dv):
                    values[e] *= -1
        di, dv_i, _ = independent_slopes(self.model, q, v, dq, dv)
        return np.concatenate([di[self._places], dv_i])

    def _whole(self, shown: np.ndarray) -> list[np.ndarray]:
        """q, q_dot, q_ddot (n_q, ...) of outputs (n_y, ...); zero for what they do not hold."""
        found = []
        for values in np.split(shown, 3):
            whole = np.zeros((len(self.model.coordinates), *shown.shape[1:]))
            whole[self._columns] = values
            found.append(whole)
        return found

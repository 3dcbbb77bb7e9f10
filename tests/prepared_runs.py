"""A scheme built and compiled once and run with several steps: the step is data of the program."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from model_values import Array

from runtime.engine.choose import choose_engine
from runtime.engine.prepare import prepare
from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.start_state import start_state

USUAL_STEPS = 3000


class PreparedRuns:
    """Runs of one scheme on one model from one start, without the checks of `simulate`."""

    def __init__(self, model: Model, scheme: str, m: list[int] | None = None, options: Mapping[str, Any] | None = None,
                 start: str | None = None, parameters: Mapping[str, float] | None = None) -> None:
        self.model, self.scheme = model, scheme_kind(scheme).build(scheme, model, 1.0, m, options or {})
        self.prepared = prepare(self.scheme.program(), self.scheme.layout.size, self.scheme.c_size)
        p = model.parameter_vector(parameters)
        self.c = model.constants(p)
        self.state = start_state(model, p, self.c, 0.0, None, start)
        self.shares = np.array(self.scheme.grid.h)
        self.engine = choose_engine("auto", self.prepared.program, self.prepared.z_size,
                                    len(self._constants(1.0)), USUAL_STEPS)

    def _constants(self, dt: float) -> Array:
        return self.prepared.ready(np.concatenate([self.c, self.shares * dt]))

    def samples(self, dt: float, steps: int, every: int) -> dict[str, Array]:
        """Fields of z after every so many major steps, the start first; ends early where z is not finite."""
        state, loops = self.state, [self.model.coordinates.index(name) for name in self.model.loop_unknowns]
        columns = self.model.independent_columns
        z = np.asarray(self.scheme.start()(0.0, state.q[columns], state.q_dot[columns], state.q[loops],
                                           np.concatenate([self.c, self.shares * dt]))).ravel()
        z, c = self.prepared.widened(z), self._constants(dt)
        found = [z.copy()]
        for _ in range(steps // every):
            self.engine.run(z, c, every)
            if not np.isfinite(z).all():
                break
            found.append(z.copy())
        layout = self.scheme.layout
        return {name: np.array(found)[:, layout.slice(name)] for name in layout.sizes}

    def end(self, t_end: float, dt: float) -> Array:
        """q_i at t_end."""
        steps = round(t_end / dt)
        return np.asarray(self.samples(t_end / steps, steps, steps)["x"][-1])

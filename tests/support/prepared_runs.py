"""A scheme built and compiled once and run with several steps: the step is data of the program."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.start.start_state import start_state
from tests.support.model_values import Array


class PreparedRuns:
    """Runs of one scheme on one model from one start, without the checks of `simulate`."""

    def __init__(
        self,
        model: Model,
        scheme: str,
        m: list[int] | None = None,
        options: Mapping[str, Any] | None = None,
        start: str | None = None,
        parameters: Mapping[str, float] | None = None,
        engine: str = "auto",
    ) -> None:
        self.model, self.scheme = model, scheme_kind(scheme).build(scheme, model, 1.0, m, options or {})
        self.stepper = Stepper(self.scheme, engine)
        p = model.parameter_vector(parameters)
        self.c = model.constants(p)
        self.state = start_state(model, p, self.c, 0.0, None, start)

    def samples(self, dt: float, steps: int, every: int) -> dict[str, Array]:
        """Fields of z after every so many major steps, the start first; ends early where z is not finite."""
        z, ready = (self.stepper.start(0.0, self.state.q, self.state.q_dot, self.c, dt), self.stepper.ready(self.c, dt))
        found = [z.copy()]
        for _ in range(steps // every):
            self.stepper.run(z, ready, every)
            if not np.isfinite(z).all():
                break
            found.append(z.copy())
        layout = self.scheme.layout
        return {name: np.array(found)[:, layout.slice(name)] for name in layout.sizes}

    def end(self, t_end: float, dt: float) -> Array:
        """q_i at t_end."""
        steps = round(t_end / dt)
        return np.asarray(self.samples(t_end / steps, steps, steps)["x"][-1])

    def seen(self, t_end: float, dt: float) -> dict[str, float]:
        """All coordinates at t_end by name, Euler parameters as the scheme shows them."""
        steps = round(t_end / dt)
        found = self.samples(t_end / steps, steps, steps)
        z, c = np.concatenate([value[-1] for value in found.values()]), self.scheme.constants(self.c, t_end / steps)
        seen = self.scheme.observer(z=z, c=c)
        values = np.concatenate([np.array(seen[part]).ravel() for part in ("q_i", "q_d")])
        return dict(zip([*self.model.q_i, *self.model.q_d], values, strict=True))

"""A whole run of a scheme as compiled steps only, to be repeated for its time."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from runtime.model import Model
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.start.start_state import start_state


def native_run(
    model: Model,
    name: str,
    m: list[int] | None,
    t_end: float,
    steps: int,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
    options: Mapping[str, Any] | None = None,
) -> Callable[[int], None]:
    """What repeats a run to t_end [s] n times; arguments otherwise as for `simulate`."""
    dt = t_end / steps
    scheme = scheme_kind(name).build(name, model, dt, m, options or {})
    p = model.parameter_vector()
    c = model.constants(p)
    stepper, state = Stepper(scheme, "compiled", wait=True), start_state(model, p, c, 0.0, initial, start)
    ready, first = stepper.ready(c, dt), stepper.start(0.0, state.q, state.q_dot, c, dt)
    z = first.copy()

    def work(n: int) -> None:
        for _ in range(n):
            z[:] = first
            stepper.run(z, ready, steps)

    return work

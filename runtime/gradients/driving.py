"""What drives a differentiated run from outside: inputs that are constants or functions of time."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.running.inputs import InputValue, Sampled, Schedule, bound, started


def driven_by(model: Model, inputs: Mapping[str, InputValue] | None) -> Model:
    """The model with these inputs. Raises ArgumentError for samples and controllers, ModelError as `simulate` does."""
    for name, value in (inputs or {}).items():
        if isinstance(value, tuple | list | Sampled):
            raise ArgumentError(
                f"input {name!r}",
                "changes at sampled times, which is not differentiated",
                "give a constant, or a function of time",
            )
    return bound(model, inputs)


def parameters_at(model: Model, values: Mapping[str, float], t0: float) -> np.ndarray:
    """p (n_p,) of a run that begins at t0 [s], the numbers of its inputs included. Raises ModelError."""
    return started(model, model.parameter_vector(values), Schedule(model.signals), t0)

"""A run that came to its end, and whose error is estimated to be too large for its result to be one."""

from __future__ import annotations

import numpy as np

from runtime.contract.coordinates import followed
from runtime.contract.model import Model
from runtime.contract.status import Status
from runtime.results.amplitudes import floored
from runtime.running.accuracy import Accuracy

LARGEST = 0.1  # error relative to an amplitude
SEEN = 0.1  # of the largest amplitude of its kind and unit: what moves less is measured by this
ADVICE = "Take a smaller step, or another scheme (symgen advise)"


def judged(status: Status, accuracy: Accuracy, model: Model) -> Status:
    """`inaccurate` in place of `completed` where an error is estimated above LARGEST of what moves."""
    names = [name for name in followed(model)[0] if name in accuracy.errors]
    if status.name != "completed" or len(names) < len(followed(model)[0]):
        return status
    amplitudes = np.array([accuracy.errors[name].amplitude for name in names])
    errors = np.array([accuracy.error(model, name) for name in names]) / floored(model, amplitudes, SEEN)
    worst = int(errors.argmax())
    if errors[worst] <= LARGEST:
        return status
    cause = f"its error is estimated at {errors[worst]:.2g} of its amplitude"
    return Status("inaccurate", status.time, names[worst], cause, ADVICE)

"""Steppers that a model keeps: who runs it again with other parameters or starts need not prepare its steps again."""

from __future__ import annotations

from threading import Lock
from typing import Any

from runtime.engine.native import NativeProgram
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper

MOST_OPERATIONS = 300_000  # of a step, of all that a model keeps: what they take stays in memory
_LOCK = Lock()  # of what models keep: threads may run one model at once


def kept_stepper(scheme: Scheme, engine: str = "auto", wait: bool = False) -> Stepper:
    """The stepper of an equal scheme on the same model that was asked for before, else a new one.

    Its `scheme` is to be used in place of the one given: what was built of that is there already. Equal are schemes of
    a kind with the same groups, steps, options and fields of z. Only native code is kept; the oldest goes first.
    """
    known: dict[tuple[Any, ...], Stepper] = scheme.model.steppers
    key = (type(scheme), repr(scheme.grid), repr(scheme.options), repr(scheme.layout.sizes), engine, wait)
    with _LOCK:
        found = known.pop(key, None)
        if found is not None:
            known[key] = found  # the youngest now
            return found
    stepper = Stepper(scheme, engine, wait)
    if isinstance(stepper.engine, NativeProgram) and stepper.operations <= MOST_OPERATIONS:
        with _LOCK:
            known[key] = stepper
            while sum(one.operations for one in known.values()) > MOST_OPERATIONS:
                del known[next(iter(known))]
    return stepper

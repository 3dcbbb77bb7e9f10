"""Steppers that a model keeps: who runs it again need not prepare its steps again."""

from __future__ import annotations

from copy import copy
from threading import Lock
from typing import Any

from runtime.schemes.grid import Grid
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import Stepper

MOST_OPERATIONS = 300_000  # of a step, of all that a model keeps: what they take stays in memory
_LOCK = Lock()  # of what models keep: threads may run one model at once


def kept_stepper(scheme: Scheme, engine: str = "auto", wait: bool = False) -> Stepper:
    """A stepper with what was prepared and compiled for a like scheme on the same model before, else a new one.

    Its `scheme` is to be used in place of the one given: what was built of that is there already. Alike are schemes of
    a kind with the same groups, ratios, options and fields of z, whatever their steps: these are data of a program.
    What a C compiler made is not kept; the oldest goes first.
    """
    known: dict[tuple[Any, ...], Stepper] = scheme.model.steppers
    alike = (repr(scheme.grid.groups), repr(scheme.grid.m), repr(scheme.options), repr(scheme.layout.sizes))
    key = (type(scheme), *alike, engine, wait)
    with _LOCK:
        found = known.pop(key, None)
        if found is not None:
            known[key] = found  # the youngest now
            return found if found.scheme.grid == scheme.grid else _with_steps(found, scheme.grid)
    stepper = Stepper(scheme, engine, wait)
    _ = stepper.sub_step_cost  # counted once: copies with other steps take it along
    if stepper.engine.name != "c" and stepper.operations <= MOST_OPERATIONS:
        with _LOCK:
            known[key] = stepper
            while sum(one.operations for one in known.values()) > MOST_OPERATIONS:
                del known[next(iter(known))]
    return stepper


def _with_steps(kept: Stepper, grid: Grid) -> Stepper:
    """The same programs with other steps; what is built of either scheme later is that of both."""
    other = copy(kept)
    other.scheme = copy(kept.scheme)
    other.scheme.take_steps(grid)
    return other

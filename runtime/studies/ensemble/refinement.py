"""Ensembles to a tolerance: the levels of steps that cases share, and where they begin.

All levels are multiples of one unit, so that any two of them end steps at common times. One case in the middle of all
is refined by itself; it chooses the method and tells how many steps the first level has, and what a case may cost.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from math import ceil
from typing import Any

import numpy as np

from runtime.contract.consistent_state import InitialStateError
from runtime.contract.coordinates import followed
from runtime.contract.errors import ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.running.comparison_times import comparison_steps
from runtime.running.method_choice import Method, chosen_method
from runtime.running.planning import make_plan
from runtime.running.problem import AUTO, SPAN_ROUNDING, Plan, Problem, span_of, tolerance_of
from runtime.running.step_refinement import RefinementLevel, StepRefinement
from runtime.schemes.options import SchemeError

FIRST_SHARE = 4  # the first level has this part of the steps that the middle case needs
UNITS = 8  # of the first level: so finely levels are graded
AIMED_SHARE = 0.3  # of the tolerance: a middle case that went below it did more than it had to
GRADE = 1.1  # from level to level: a level near what a case needs is a level whose error is told closely
BUDGET = 60  # times the steps that all levels of the middle case took: what a case may take
MOST_LEVEL = 10**6  # steps a unit


@dataclass(frozen=True)
class Refinement:
    """What is asked of every case, in plain numbers.

    tolerance [1]; units: parts of the motion, of `length` [s], at whose ends all levels end a step; first: steps of
    the first level in each; budget: steps that a case may take in all; asked: how many of the outputs are the
    user's; every: units from sample to sample of a history.
    """

    tolerance: float
    units: int
    length: float
    first: int
    budget: int
    asked: int
    every: int

    @cached_property
    def levels(self) -> np.ndarray:
        """Steps a unit of all levels, rising."""
        found = [self.first]
        while found[-1] < MOST_LEVEL:
            found.append(max(found[-1] + 1, round(found[-1] * GRADE)))
        return np.array(found)

    def places(self, plan: Plan) -> np.ndarray:
        """(N,) steps of a level after which it is compared with others: the start, and times in phase with nothing."""
        steps = round(self.length / plan.grid.dt_L)
        return np.concatenate([[0], steps * comparison_steps(plan.whole_steps // steps)])

    def plan(self, plan: Plan, steps: int) -> Plan:
        """Of the level with so many steps in each unit; plan: of any other level."""
        finer = plan.with_steps(plan.scheme.model, self.length / steps, self.units * steps)
        return replace(finer, seen_steps=self.every * steps).until(plan.t_end)


def refinement_of(
    model: EmittedModel,
    names: tuple[Sequence[str], Sequence[str]],
    table: np.ndarray,
    tolerance: float,
    *,
    scheme: str | None,
    m: list[int] | None,
    options: Mapping[str, Any] | None,
    t0: float,
    t_end: float | None,
    start: str | None,
    spacing: float | None,
    asked: int,
) -> tuple[Refinement, Plan]:
    """The levels of an ensemble, and the plan of the first. spacing [s]: between samples of histories.

    Raises SchemeError, ArgumentError for what cannot be used.
    """
    wanted = tolerance_of(model, scheme, tolerance)
    assert wanted is not None
    begin, end = span_of(model, t0, t_end)
    apart = end - begin if spacing is None else min(spacing, end - begin)
    base = ceil((end - begin) / apart - SPAN_ROUNDING)
    method, levels, first = _middle(model, names, table, wanted, scheme, m, options, (begin, end), start)
    steps = first
    if levels:
        answer, order = levels[-1], levels[-1].run.plan.scheme.order
        shorter = (
            np.clip((answer.error / (AIMED_SHARE * wanted)) ** (1 / order), AIMED_SHARE, 1.0)
            if answer.error > 0
            else 1.0
        )
        steps = max(first, ceil(answer.steps * float(shorter) / FIRST_SHARE))
    every = max(1, steps // (UNITS * base))
    units, length = base * every, apart / every
    in_unit = max(1, ceil(steps / units))
    budget = BUDGET * max(sum(one.steps for one in levels), in_unit * units)
    found = Refinement(wanted, units, length, in_unit, budget, asked, every)
    chosen = None if method.m is None else list(method.m)
    plan = make_plan(model, end, length / in_unit, chosen, method.scheme, 0.0, method.options, begin, bounded=True)
    return found, found.plan(replace(plan, force=True), in_unit)


def _middle(
    model: EmittedModel,
    names: tuple[Sequence[str], Sequence[str]],
    table: np.ndarray,
    tolerance: float,
    scheme: str | None,
    m: list[int] | None,
    options: Mapping[str, Any] | None,
    span: tuple[float, float],
    start: str | None,
) -> tuple[Method, list[RefinementLevel], int]:
    """The method, levels of a case in the middle that came to its end ([] if none does), and steps to begin with."""
    chosen = scheme or AUTO
    method, first, last = None, 1, None
    for sample in (table.mean(axis=0), *table[[0, len(table) // 2, -1]]):
        parameters, initial = sample[: len(names[0])].tolist(), sample[len(names[0]) :].tolist()
        try:
            problem = Problem.of(
                model, span[1], dict(zip(names[0], parameters, strict=True)),
                dict(zip(names[1], initial, strict=True)) or None, start, span[0],
            )  # fmt: skip
        except (InitialStateError, ModelError) as error:
            last = error
            continue
        if chosen == AUTO:
            method = chosen_method(problem)[0]
        else:
            method = Method(chosen, None if m is None else tuple(m), dict(options or {}))
        refinement = StepRefinement(problem, tolerance)
        first = method.first or refinement.first(method)
        levels = [one for one in refinement.refine(method) if not one.lost]
        if levels and np.isfinite(levels[-1].error):
            return method, levels, first
    if method is None:
        assert last is not None
        raise ArgumentError("parameters, initial", f"no case has a consistent start: {last}", "give others")
    return method, [], first


def compared_names(model: EmittedModel) -> list[str]:
    """Outputs that levels are compared by: what tells the motion, and its rates."""
    names = followed(model)[0]
    return [*names, *(f"{name}_dot" for name in names)]


def refuse_steps(scheme: str | None, dt: float | None, m: list[int] | None, options: Mapping[str, Any] | None) -> None:
    """What does not go with a tolerance. Raises SchemeError."""
    if dt is not None:
        raise SchemeError("dt", "cannot be given with a tolerance, which chooses the step", "leave one of them out")
    if scheme in (None, AUTO) and (m is not None or options):
        raise SchemeError("auto chooses m and options itself; leave them out, or name a scheme")
    for name in {"error_of", "tolerance"} & set(options or {}):
        raise SchemeError(f"options[{name!r}]", "belongs to single runs", "leave it out")

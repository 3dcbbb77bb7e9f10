"""Choose a method and its step for a model: several methods are refined, and the cheapest answer is named.

What is advised was made: a whole motion with that step, whose error is told as that of any run.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from math import floor, isfinite, log10
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, START, arguments
from runtime.contract.cards import card, line, table
from runtime.contract.coordinates import Initial
from runtime.contract.errors import NoResult, SymgenError
from runtime.contract.model import EmittedModel
from runtime.running.method_choice import Method, chosen_method
from runtime.running.problem import AUTO, Problem, tolerance_of
from runtime.running.step_refinement import RefinementLevel, StepRefinement
from runtime.studies.advice.methods import always_reported, candidates, checked_grades, multirate
from runtime.studies.advice.spectrum import step_ratios

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from runtime.studies.advice.reference import Reference
    from runtime.studies.advice.trial import Trial


HOPELESS_OPERATIONS = 2.0  # times the operations of the best answer so far: a refinement that needs more is given up
SHOWN_HOPELESS_OPERATIONS, SHOWN_LEVELS = (
    100.0,
    3,
)  # the same of what a report always shows, unless so many levels came to the end
STEP_DIGITS = 3  # of an advised step, which is rounded down
Note = Callable[[str], None]


@dataclass(frozen=True)
class Candidate:
    """What the refinement of a method came to: the coarsest level that meets the tolerance, by the next finer one.

    answer: None where none met it in useful time; error: of it, as compared with the tolerance; operations: of its
    steps. levels (N, 2): operations and error of each level whose error is known. trials: all levels by the
    independent reference, of a report. finest: the last level that came to its end.
    """

    method: Method
    answer: RefinementLevel | None = None
    error: float = np.nan
    operations: float = np.inf
    failure: str = ""
    levels: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))
    trials: list[Trial] = field(default_factory=list)
    finest: RefinementLevel | None = None

    @property
    def label(self) -> str:
        """What reports call the method."""
        return self.method.label

    @property
    def dt(self) -> float:
        """Step of the answer [s], in few digits and not longer; NaN where there is none."""
        if self.answer is None:
            return float("nan")
        exact = self.answer.run.segment.plan.grid.dt_L
        unit = 10.0 ** (floor(log10(exact)) + 1 - STEP_DIGITS)
        return float(f"{floor(exact / unit * (1 + 1e-9)) * unit:.{STEP_DIGITS}g}")


@dataclass(frozen=True)
class Advice:
    """What to use, and why.

    best: the refinement whose answer takes the fewest operations; candidates: all of them, the cheapest first;
    gain: how many times the operations of the best method with one step for all coordinates are those of the best
    (1 where it is such a one, inf where none got there); automatic: the scheme that `auto` would take, and why.
    reference: what a report measures errors by.
    """

    model: EmittedModel
    tolerance: float
    graded: list[str]
    t_end: float
    candidates: list[Candidate]
    gain: float
    automatic: tuple[str, str]
    reference: Reference | None = None

    @property
    def best(self) -> Candidate:
        """The cheapest."""
        return self.candidates[0]

    @property
    def method(self) -> Method:
        """The one that is advised."""
        return self.best.method

    @property
    def dt(self) -> float:
        """Its step [s]."""
        return self.best.dt

    @property
    def reason(self) -> str:
        """Why it is advised, in a sentence."""
        step = f"step {self.dt:.3g} s, error {self.best.error:.2g}"
        if not multirate(self.method):
            return f"use one step for all coordinates: {self.best.label} takes the fewest operations here ({step})"
        if not isfinite(self.gain):
            return f"{self.best.label}: {step}; no method with one step for all coordinates got there in useful time"
        few = f"{self.gain:.2g} times fewer operations than" if self.gain >= 1.05 else "as many operations as"
        return f"{self.best.label} takes {few} the best method with one step for all coordinates ({step})"

    def picture(self, path: str | Path | None = None) -> Figure:
        """Error of every level of every method against operations, of a report against time. Raises OutputError."""
        from runtime.views.plots import work_precision

        title = f"{self.model.title or self.model.name}, {self.t_end:g} s"
        curves = [
            (
                one.method,
                np.array([(1e3 * trial.seconds, trial.error) for trial in one.trials]).reshape(-1, 2)
                if self.reference
                else one.levels,
            )
            for one in self.candidates
        ]
        unit = "processor time of the steps [ms]" if self.reference else "operations"
        found: Figure = work_precision(title, curves, self.tolerance, unit, path)
        return found

    def _repr_html_(self) -> str:
        rows = [
            (one.label, f"{one.dt:.4g} s", f"{one.operations:.3g}", f"{one.error:.2g}")
            if one.answer
            else (one.label, one.failure)
            for one in self.candidates
        ]
        about = f"an error of {self.tolerance:g} in {', '.join(self.graded)} over {self.t_end:g} s"
        wanted = f"{self.best.label}, dt = {self.dt:g} s"
        return card(wanted, about, line(self.reason), table(rows, ("method", "step", "operations", "error")))


class NoAdvice(NoResult):
    """No method met the tolerance; the message says what was tried."""


@arguments(graded=NAMES, parameters=BY_NAME, initial=START)
def advise(
    model: EmittedModel,
    *,
    tolerance: float = 1e-3,
    graded: Sequence[str] | None = None,
    t_end: float | None = None,
    parameters: Mapping[str, float] | None = None,
    initial: Initial = None,
    start: str | None = None,
    note: Note = lambda text: None,
    reference: Reference | None = None,
) -> Advice:
    """Find the method and step that compute a motion to a tolerance with the fewest operations.

    Parameters
    ----------
    model : Model
        The mechanism.
    tolerance : float, optional
        RMS error over the motion of every graded coordinate, relative to its amplitude [1].
    graded : sequence of str, optional
        Names in q_i, all by default; of the others the motion is accurate to a tenth of an amplitude.
    t_end : float, optional
        Length of the motion [s].
    parameters, initial, start : optional
        As of `simulate`.
    note : callable, optional
        Told what is being done.
    reference : Reference, optional
        Of a `report`.

    Returns
    -------
    Advice
        The method with its step, and what every other method needs.

    Raises
    ------
    SchemeError, ModelError, InitialStateError, NoAdvice
        For what cannot be used, and where no method meets the tolerance.

    Notes
    -----
    Every method is refined until two levels agree (Richardson extrapolation of the error); operations are those of
    M_hat q_i'' = Q_hat (Eq. 38) and of the method.
    """
    tolerance_of(model, AUTO, tolerance)
    names = checked_grades(model, graded)
    problem = Problem.of(model, t_end, parameters, initial, start) if reference is None else reference.problem
    refinement = StepRefinement(problem, tolerance, graded=tuple(graded or ()))
    chosen, reason = chosen_method(problem)
    note(f"trying {chosen.label}")
    compared = [_refined(refinement, chosen, np.inf, reference)]
    motion = compared[0].finest
    ratios = step_ratios(problem, None if motion is None else motion.run.sampled_solution())
    shown = always_reported(model, ratios) if reference is not None else []
    tried = {method.label: method for method in (*candidates(model, ratios), *shown)}
    tried.pop(chosen.label, None)
    for method in tried.values():
        note(f"trying {method.label}")
        least = min((one.operations for one in compared), default=np.inf)
        compared.append(_refined(refinement, method, least, reference, always=method in shown))
    compared.sort(key=lambda one: one.operations)
    best = compared[0]
    if best.answer is None:
        raise NoAdvice(
            f"none of {', '.join(one.label for one in compared)} reached {tolerance:g} on {model.name}; "
            "loosen the tolerance or grade fewer coordinates"
        )
    single = min((one.operations for one in compared if not multirate(one.method)), default=np.inf)
    return Advice(
        model,
        tolerance,
        names,
        problem.t_end,
        compared,
        single / best.operations,
        (chosen.scheme, reason),
        reference,
    )


def _refined(
    refinement: StepRefinement, method: Method, best: float, reference: Reference | None, always: bool = False
) -> Candidate:
    """The refinement of a method, given up where a level is far dearer than the best answer so far; always: is it
    shown whatever it costs?
    """
    levels: list[RefinementLevel] = []
    try:
        for level in refinement.refine(method):
            levels.append(level)
            if level.status.name == "interrupted":
                raise KeyboardInterrupt
            few = always and sum(not one.lost for one in levels) < SHOWN_LEVELS
            if _operations(level) > (SHOWN_HOPELESS_OPERATIONS if few else HOPELESS_OPERATIONS) * best:
                break
    except SymgenError as error:  # a scheme that this model does not allow
        return Candidate(method, failure=str(error).splitlines()[0])
    pairs = list(zip(levels, levels[1:], strict=False))
    curve = np.array([(_operations(level), finer.differs) for level, finer in pairs]).reshape(-1, 2)
    trials: list[Trial] = []
    if reference is not None:
        from runtime.studies.advice.trial import trial_of

        trials = [trial_of(method.label, level, reference) for level in levels]
    whole = next((one for one in reversed(levels) if not one.lost), None)
    found = Candidate(method, failure="not reached in useful time", levels=curve, trials=trials, finest=whole)
    for level, finer in reversed(pairs):
        if not finer.differs <= refinement.tolerance:
            break
        found = Candidate(method, level, finer.differs, _operations(level), levels=curve, trials=trials, finest=whole)
    return found


def _operations(level: RefinementLevel) -> float:
    return float(level.steps) * level.run.segment.stepper.operations

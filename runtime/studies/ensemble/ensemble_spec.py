"""What an ensemble is asked of each of its cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import EmittedModel
from runtime.results.named_outputs import column
from runtime.running.problem import Plan
from runtime.studies.ensemble.account import REDUCTIONS
from runtime.studies.ensemble.refinement import Refinement, compared_names, refinement_of

LANE_DATA = ("steps", "dt", "seen_steps", "end")  # of a plan's numbers: what lanes are given, not compiled for
DEVICES = ("cpu", "gpu")
LOOK_STEPS, MOST_LOOKS_OF_RUN = 250, 16  # a run is looked at about every so many steps, at most so often


@dataclass(frozen=True, eq=False)
class EnsembleSpec:
    """Names and settings; the samples themselves are an array (cases, parameters and initial values) beside it.

    start: "" for the scene's own. reduced: (output, reduction) of each value kept of a case; () where each output is
    at every `plan.seen_steps`-th step. refinement: where each case has a tolerance; the plan is then of one level.
    device: what makes the steps, one of DEVICES.
    """

    model: EmittedModel
    parameters: list[str]
    initial: list[str]
    plan: Plan
    start: str
    outputs: list[str]
    reduced: list[tuple[str, str]]
    refinement: Refinement | None = None
    device: str = "cpu"

    @classmethod
    def ask(
        cls,
        model: EmittedModel,
        names: tuple[list[str], list[str]],
        plan: Plan,
        start: str | None,
        outputs: Sequence[str] | None,
        reduce: Mapping[str, str | Sequence[str]] | None,
    ) -> EnsembleSpec:
        """Check the names of outputs and reductions. Raises ModelError or ArgumentError."""
        kept = _outputs(model, outputs, reduce)
        return cls(model, *names, plan, start or "", kept, [] if reduce is None else _reduced(kept, reduce))

    @classmethod
    def to_tolerance(
        cls,
        model: EmittedModel,
        names: tuple[list[str], list[str]],
        table: np.ndarray,
        tolerance: float,
        start: str | None,
        outputs: Sequence[str] | None,
        reduce: Mapping[str, str | Sequence[str]] | None,
        **settings: Any,
    ) -> EnsembleSpec:
        """The same for cases with a tolerance; table: samples. settings: of `refinement_of`. Raises what that does."""
        kept = _outputs(model, outputs, reduce)
        reduced = [] if reduce is None else _reduced(kept, reduce)
        found, plan = refinement_of(model, names, table, tolerance, start=start, asked=len(kept), **settings)
        beside = [name for name in compared_names(model) if name not in kept]
        return cls(model, *names, plan, start or "", [*kept, *beside], reduced, found)

    def alike(self, other: EnsembleSpec) -> bool:
        """Do the two differ in their samples and the number of steps only? Both are data of lanes."""

        def of(one: EnsembleSpec) -> tuple[object, ...]:
            numbers = {name: value for name, value in one.plan.numbers.items() if name not in LANE_DATA}
            return numbers, one.plan.end is None, one.start, one.outputs, one.reduced, one.device

        return self.model is other.model and of(self) == of(other)

    def level(self, steps: int) -> EnsembleSpec:
        """The same with so many steps in each unit of the refinement."""
        assert self.refinement is not None
        return replace(self, plan=self.refinement.plan(self.plan, steps))

    @property
    def marks(self) -> list[int]:
        """Steps of all samples: those of histories, and those at which levels are compared."""
        compared = [] if self.refinement is None else self.refinement.places(self.plan).tolist()
        return sorted({*self.sampled, *compared})

    @property
    def sampled(self) -> list[int]:
        """Steps of histories, the first and the last among them; none where values of whole runs are kept."""
        steps = self.plan.steps
        return [] if self.reduced else sorted({*range(0, steps, self.plan.seen_steps), steps})

    @property
    def asked(self) -> list[str]:
        """The outputs that the user wants."""
        return self.outputs if self.refinement is None else self.outputs[: self.refinement.asked]

    @property
    def compared(self) -> list[int]:
        """Positions among the outputs of what levels are compared by."""
        return [self.outputs.index(name) for name in compared_names(self.model)]

    @property
    def looks(self) -> list[int]:
        """Steps after which all lanes are looked at."""
        steps = self.plan.steps
        count = min(MOST_LOOKS_OF_RUN, max(1, steps // LOOK_STEPS))
        return sorted({max(1, steps * k // count) for k in range(1, count + 1)})

    @property
    def width(self) -> int:
        """Values kept of a run: what is reduced, then the samples."""
        return len(self.reduced) + len(self.outputs) * len(self.marks)

    @property
    def reported(self) -> int:
        """Values reported of a case."""
        return len(self.reduced) or len(self.asked) * len(self.sampled)


def _outputs(
    model: EmittedModel, outputs: Sequence[str] | None, reduce: Mapping[str, str | Sequence[str]] | None
) -> list[str]:
    """Checked names of outputs."""
    if isinstance(outputs, str):
        raise ArgumentError("outputs", f"must be a list of names, not the text {outputs!r}", f"give [{outputs!r}]")
    kept = list(dict.fromkeys(list(reduce or {}) if outputs is None else outputs))
    if not kept:
        raise ArgumentError("outputs", "no outputs were requested", "name coordinates, rates, measures or energies")
    for name in kept:
        column(model, name)
    for name in reduce or {}:
        if name not in kept:
            raise ArgumentError(f"reduce[{name!r}]", "is none of the outputs", f"add it to outputs = {kept}")
    return kept


def _reduced(outputs: list[str], reduce: Mapping[str, str | Sequence[str]]) -> list[tuple[str, str]]:
    """(output, reduction) in order; an output that no reduction is named for is kept at its end."""
    found = []
    for name in outputs:
        asked = reduce.get(name, "end")
        for one in [asked] if isinstance(asked, str) else list(asked):
            if one not in REDUCTIONS:
                raise ArgumentError(
                    f"reduce[{name!r}]", f"there is no reduction {one!r}", f"choose from {', '.join(REDUCTIONS)}"
                )
            if (name, one) not in found:
                found.append((name, one))
    return found

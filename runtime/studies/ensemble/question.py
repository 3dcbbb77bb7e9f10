"""What an ensemble is asked of each of its cases."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from runtime.contract.errors import ArgumentError
from runtime.contract.model import EmittedModel
from runtime.results.named_outputs import column
from runtime.running.problem import Plan
from runtime.studies.ensemble.account import REDUCTIONS

LOOK_STEPS, MOST_LOOKS = 250, 16  # a run is looked at about every so many steps, at most so often


@dataclass(frozen=True, eq=False)
class Question:
    """Names and settings; the samples themselves are an array (cases, parameters and initial values) beside it.

    start: "" for the scene's own. reduced: (output, reduction) of each value kept of a case; () where each output is
    at every `plan.seen_steps`-th step.
    """

    model: EmittedModel
    parameters: list[str]
    initial: list[str]
    plan: Plan
    start: str
    outputs: list[str]
    reduced: list[tuple[str, str]]

    @classmethod
    def ask(
        cls,
        model: EmittedModel,
        names: tuple[list[str], list[str]],
        plan: Plan,
        start: str | None,
        outputs: Sequence[str] | None,
        reduce: Mapping[str, str | Sequence[str]] | None,
    ) -> Question:
        """Check the names of outputs and reductions. Raises ModelError or ArgumentError."""
        kept = _outputs(model, outputs, reduce)
        return cls(model, *names, plan, start or "", kept, [] if reduce is None else _reduced(kept, reduce))

    def alike(self, other: Question) -> bool:
        """Do the two differ in their samples only?"""
        mine, others = ((one.plan.numbers, one.start, one.outputs, one.reduced) for one in (self, other))
        return self.model is other.model and mine == others

    @property
    def marks(self) -> list[int]:
        """Steps of the samples, the first and the last among them; none where values of whole runs are kept."""
        steps = self.plan.steps
        return [] if self.reduced else sorted({*range(0, steps, self.plan.seen_steps), steps})

    @property
    def looks(self) -> list[int]:
        """Steps after which all lanes are looked at."""
        steps = self.plan.steps
        count = min(MOST_LOOKS, max(1, steps // LOOK_STEPS))
        return sorted({max(1, steps * k // count) for k in range(1, count + 1)})

    @property
    def width(self) -> int:
        """Values kept of a case."""
        return len(self.reduced) if self.reduced else len(self.outputs) * len(self.marks)


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
                    f"reduce[{name!r}]", f"there is no reduction {one!r}", f"take of {', '.join(REDUCTIONS)}"
                )
            if (name, one) not in found:
                found.append((name, one))
    return found

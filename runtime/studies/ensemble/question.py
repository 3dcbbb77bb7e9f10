"""What an ensemble is asked, in plain values: two equal questions with equal samples have equal answers."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from math import ceil
from typing import Any, get_args

from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from runtime.contract.status import StatusName
from runtime.running.plan import Plan, make_plan
from runtime.studies.ensemble.account import REDUCTIONS
from runtime.studies.ensemble.observation import column

NAMES: tuple[str, ...] = get_args(StatusName)
CODES = {name: code for code, name in enumerate(NAMES)}  # completed is 0
FORMAT = "symgen ensemble 1"
LOOK_STEPS, MOST_LOOKS = 250, 16  # a run is looked at about every so many steps, at most so often
PART_STEPS = 1 << 20  # scenario-steps of a part, about
LARGEST_PART, SMALLEST_PART = 4096, 128


@dataclass(frozen=True)
class Question:
    """Names and settings; the samples themselves are an array (cases, parameters and initial values) beside it.

    reduced: (output, reduction) of each value kept of a case; () where every `every`-th step of each output is.
    """

    model: str
    digest: str
    parameters: list[str]
    initial: list[str]
    cases: int
    scheme: str
    dt: float
    m: list[int]
    options: dict[str, Any]
    t0: float
    t_end: float
    start: str
    outputs: list[str]
    reduced: list[list[str]]
    every: int
    samples: str = ""  # SHA-256 of the array

    @classmethod
    def ask(
        cls,
        model: Model,
        names: tuple[list[str], list[str]],
        cases: int,
        scheme: str | None,
        dt: float | None,
        m: list[int] | None,
        options: Mapping[str, Any] | None,
        t0: float,
        t_end: float | None,
        start: str | None,
        outputs: Sequence[str] | None,
        reduce: Mapping[str, str | Sequence[str]] | None,
        seen_every: float | None,
    ) -> Question:
        """Check all but the samples. Raises SchemeError, ModelError or ArgumentError."""
        plan = make_plan(model, t_end, dt, m, scheme, seen_every, options, t0, bounded=True)
        kept = _outputs(model, outputs, reduce)
        if reduce is not None and seen_every is not None:
            remedy = "give reduce for values of whole runs, or seen_every (or samples)"
            raise ArgumentError("reduce and seen_every", "are two answers", remedy)
        reduced = [] if reduce is None else _reduced(kept, reduce)
        return cls(
            model.name,
            model.digest,
            *names,
            cases,
            plan.name,
            plan.grid.dt_L,
            list(plan.grid.m),
            json.loads(json.dumps(dict(plan.options))),
            plan.t0,
            plan.t_end,
            start or "",
            kept,
            reduced,
            0 if reduced else plan.seen_steps,
        )

    def plan(self, model: Model) -> Plan:
        """The run of a case."""
        m = list(self.m) or None
        options = {key: tuple(one) if isinstance(one, list) else one for key, one in self.options.items()}
        return make_plan(model, self.t_end, self.dt, m, self.scheme, None, options, self.t0, bounded=True)

    def marks(self, steps: int) -> list[int]:
        """Steps of the samples, the first and the last among them."""
        return sorted({*range(0, steps, self.every or steps), steps})

    def looks(self, steps: int) -> list[int]:
        """Steps after which all lanes are looked at."""
        count = min(MOST_LOOKS, max(1, steps // LOOK_STEPS))
        return sorted({max(1, steps * k // count) for k in range(1, count + 1)})

    def width(self, steps: int) -> int:
        """Values kept of a case."""
        return len(self.reduced) if self.reduced else len(self.outputs) * len(self.marks(steps))

    def part_size(self, steps: int) -> int:
        """Cases of a part: what is kept and handed out as a whole."""
        return min(LARGEST_PART, max(SMALLEST_PART, 1 << (PART_STEPS // steps).bit_length()))

    def parts(self, steps: int) -> list[tuple[int, int]]:
        """(first case, behind the last one) of each part."""
        size = self.part_size(steps)
        return [(k * size, min((k + 1) * size, self.cases)) for k in range(ceil(self.cases / size))]

    def as_text(self) -> str:
        """JSON."""
        return json.dumps({"format": FORMAT, **asdict(self)}, indent=1, sort_keys=True)

    @property
    def programs_key(self) -> str:
        """What programs depend on: all but the cases and what of them is varied."""
        return replace(self, parameters=[], initial=[], cases=0, samples="").as_text()

    @property
    def key(self) -> str:
        """SHA-256 of it."""
        return hashlib.sha256(self.as_text().encode()).hexdigest()


def _outputs(
    model: Model, outputs: Sequence[str] | None, reduce: Mapping[str, str | Sequence[str]] | None
) -> list[str]:
    """Checked names of outputs."""
    if isinstance(outputs, str):
        raise ArgumentError("outputs", f"must be a list of names, not the text {outputs!r}", f"give [{outputs!r}]")
    kept = list(dict.fromkeys(list(reduce or {}) if outputs is None else outputs))
    if not kept:
        raise ArgumentError("outputs", "nothing is asked for", "name coordinates, rates, measures or energies")
    for name in kept:
        column(model, name)
    for name in reduce or {}:
        if name not in kept:
            raise ArgumentError(f"reduce[{name!r}]", "is none of the outputs", f"add it to outputs = {kept}")
    return kept


def _reduced(outputs: list[str], reduce: Mapping[str, str | Sequence[str]]) -> list[list[str]]:
    """[output, reduction] in order; an output that no reduction is named for is kept at its end."""
    found = []
    for name in outputs:
        asked = reduce.get(name, "end")
        for one in [asked] if isinstance(asked, str) else list(asked):
            if one not in REDUCTIONS:
                raise ArgumentError(
                    f"reduce[{name!r}]", f"there is no reduction {one!r}", f"take of {', '.join(REDUCTIONS)}"
                )
            if [name, one] not in found:
                found.append([name, one])
    return found

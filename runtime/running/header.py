"""What a checkpoint says in words: which run it is of, and how far that has come."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from runtime.contract.model import Model, ModelError
from runtime.contract.status import Event
from runtime.running.plan import Plan
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.options import SchemeError

FORMAT = "symgen checkpoint 7"


@dataclass(frozen=True)
class CheckpointHeader:
    """The run: model (manifest, inputs, scene), plan. How far: steps done, rows streamed, what was kept.

    segments: q_i of each segment so far, in the order of the record; segment: the one under way. position: all
    coordinates there, which tell a generator of variants where it is. monitor, guard: what checks
    compare with. schedule: what drives it remembers. impulses: those of the segment, which may be
    told later: time, energy, rates after them and their jumps. happened: latest times of each event [s].
    """

    model: str
    digest: str
    driven_by: str
    scene_toml: str
    scheme: str
    dt: float
    m: list[int]
    options: dict[str, Any]
    t0: float
    steps: int
    save_every: int
    force: bool
    outputs: list[str]
    initial_changes: str
    step: int
    last_step: int
    rows: int
    stream: str | None
    events: list[Event]
    segments: list[list[str]]
    segment: int
    position: list[float]
    monitor: dict[str, list[float]]
    guard: list[list[float]]
    schedule: dict[str, list[float]]
    impulses: list[list[float]]
    happened: dict[str, list[float]]

    def to_json(self) -> str:
        """One JSON object with its format."""
        return json.dumps({"format": FORMAT, **asdict(self)})

    @classmethod
    def from_json(cls, text: str) -> CheckpointHeader:
        """From `to_json`. Raises KeyError, TypeError, AttributeError or ValueError for another text."""
        values = json.loads(text)
        del values["format"]
        if set(values) != {entry.name for entry in fields(cls)}:
            raise ValueError("its header has other entries than a checkpoint's")
        events = [Event(**event) for event in values.pop("events")]
        options = {
            name: tuple(value) if isinstance(value, list) else value for name, value in values.pop("options").items()
        }
        return cls(**values, events=events, options=options)

    def plan(self, model: Model) -> Plan:
        """The run's plan on its model. Raises SchemeError."""
        scheme = scheme_kind(self.scheme).build(self.scheme, model, self.dt, self.m or None, self.options)
        return Plan(
            self.scheme,
            scheme,
            self.options,
            self.steps,
            self.save_every,
            self.t0,
            self.force,
            tuple(self.outputs),
        )

    def check_model(self, model: Model, path: str | Path) -> None:
        """Raises ModelError if the checkpoint belongs to another model."""
        if self.digest != model.digest:
            same = " (the same scene, generated anew with other content)" if self.model == model.name else ""
            raise ModelError(
                f"checkpoint {path}",
                f"it belongs to model {self.model} with manifest {self.digest[:12]}, not to {model.name} with "
                f"{model.digest[:12]}{same}",
                "give the model that it was made with",
            )
        if self.driven_by != model.driven_by:
            raise ModelError(
                f"checkpoint {path}", "its run was driven by other inputs", "give the inputs that it was made with"
            )

    def check_settings(self, wanted: Mapping[str, Any], path: str | Path) -> None:
        """Raises SchemeError if a setting that was said again is another one. None was not said."""
        for name, value in wanted.items():
            kept = json.loads(json.dumps(getattr(self, name)))
            if value is not None and json.loads(json.dumps(value)) != kept:
                raise SchemeError(
                    f"checkpoint {path}",
                    f"it was made with {name} = {kept!r}, not {value!r}",
                    "a run goes on with its own settings: leave this one out, or start a new run",
                )

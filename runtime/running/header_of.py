"""The header of a checkpoint, from a run under way."""

from __future__ import annotations

import numpy as np

from runtime.contract.status import Event
from runtime.results.stream import StreamFile
from runtime.running.happenings import Happenings
from runtime.running.header import CheckpointHeader
from runtime.running.record import Record
from runtime.running.schedule import Schedule
from runtime.running.segment import Segment
from runtime.running.singular.guard import Guard


def header_of(
    segment: Segment,
    z: np.ndarray,
    record: Record,
    events: list[Event],
    guard: Guard,
    schedule: Schedule | None,
    happenings: Happenings,
    initial_changes: str,
) -> CheckpointHeader:
    """What a checkpoint says of a run whose `segment` is at z (n_z,). initial_changes: of the start, in words."""
    first = record.segments[0]
    model, plan, table = first.model, first.plan, record.table
    return CheckpointHeader(
        model=model.name,
        digest=model.digest,
        driven_by=model.driven_by,
        scene_toml=model.scene_toml,
        scheme=plan.name,
        dt=plan.grid.dt_L,
        m=list(plan.grid.m),
        options=dict(plan.options),
        t0=plan.t0,
        steps=plan.steps,
        save_every=plan.save_every,
        force=plan.force,
        outputs=list(plan.outputs),
        initial_changes=initial_changes,
        step=segment.step_of(z),
        last_step=record.last_step,
        rows=0 if table is None else table.rows,
        stream=str(table.folder) if isinstance(table, StreamFile) else None,
        events=events,
        segments=[list(segment.model.q_i) for segment in record.segments],
        segment=record.segments.index(segment),
        position=segment.observed([segment.state(z)]).q[0].tolist(),
        monitor=segment.monitor.memory(),
        guard=guard.memory(),
        schedule={} if schedule is None else schedule.memory(),
        impulses=[one for each in record.segments for one in each.impulse_memory()],
        happened=happenings.memory(),
    )

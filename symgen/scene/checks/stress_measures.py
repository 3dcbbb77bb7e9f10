"""Stresses are measured at gauges of finite-element bodies, whose arrays fit the modes."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.flexible import COMPONENTS, Rows, SpatialModalBody
from symgen.scene.measures import ALL_GAUGES, StressMeasure
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError, did_you_mean

REMEDY = "take what FlexibleBody.fields(gauges=...) gives for these modes"


def stress_measure_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Gauges that do not fit their body, and measures at gauges that are not there."""
    gauges: dict[str, list[str]] = {}
    for index, body in enumerate(scene.bodies):
        if isinstance(body, SpatialModalBody):
            gauges[body.name] = list(body.gauges)
            yield from _misfits(body, item_path("bodies", index, body.name))
    for index, measure in enumerate(scene.measures):
        if not isinstance(measure, StressMeasure):
            continue
        path = f"{item_path('measures', index, measure.name)}"
        body_name, _, gauge = measure.of.partition(".")
        if not gauges.get(body_name):
            known = [name for name, own in gauges.items() if own]
            remedy = did_you_mean(body_name, known) if known else "give FlexibleBody.fields(gauges=...) to its body"
            yield SceneError(f"{path}.of", f"there is no body '{body_name}' with gauges", remedy)
        elif gauge not in (*gauges[body_name], ALL_GAUGES):
            remedy = did_you_mean(gauge, [*gauges[body_name], ALL_GAUGES])
            yield SceneError(f"{path}.of", f"body '{body_name}' has no gauge '{gauge}'", remedy)
        elif gauge == ALL_GAUGES and measure.component != "von_mises":
            yield SceneError(
                f"{path}.component", "the largest of all gauges has no sign", 'take "von_mises", or name one gauge'
            )


def _misfits(body: SpatialModalBody, path: str) -> Iterator[SceneError]:
    for name, gauge in body.gauges.items():
        where = f"{path}.gauges.{name}"
        if name == ALL_GAUGES:
            yield SceneError(where, f"'{name}' stands for all gauges", "give it another name")
        if not _fits(gauge.shapes, body.nf):
            yield SceneError(f"{where}.shapes", f"is not 6 x {body.nf}, for {body.nf} modes", REMEDY)
        if gauge.fields and not _fits(gauge.fields, 9 + 9 * body.nf):
            yield SceneError(f"{where}.fields", f"is not 6 x {9 + 9 * body.nf}, for {body.nf} modes", REMEDY)
        for marker, rows in gauge.forces.items():
            if marker not in body.markers:
                remedy = did_you_mean(marker, list(body.markers))
                yield SceneError(f"{where}.forces", f"body '{body.name}' has no marker '{marker}'", remedy)
            if not _fits(rows, len(COMPONENTS)):
                yield SceneError(f"{where}.forces.{marker}", "is not 6 x 6", REMEDY)


def _fits(rows: Rows, columns: int) -> bool:
    return len(rows) == len(COMPONENTS) and all(len(row) == columns for row in rows)

"""The scene: everything that is there, before any equation.

A scene in a notebook: what joins what as a drawing; bodies, joints, loads and parameters as tables.

A scene as a graph: bodies as boxes by their distance from the ground, joints as lines with their types.
"""

from __future__ import annotations

from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import ValidationError

from runtime.contract.doors import opened
from runtime.contract.status import card, fold, table
from symgen.scene import toml_io
from symgen.scene.checks import check_scene
from symgen.scene.parts import SceneParts
from symgen.scene.tables import with_tables
from symgen.scene.toml_io import with_files
from symgen.scene.translate import scene_errors
from symgen.schema.errors import SceneError, raise_all, show

if TYPE_CHECKING:
    from runtime.contract.model import Model

MOST_BODIES = 16  # of a picture that is still read
WIDE, HIGH, ACROSS, DOWN = 104, 24, 270, 52  # of a box, and from one to the next [pixels]
INK, PALE, GROUND, RED = "#1f2937", "#e0ecf8", "#d1d5db", "#b3261e"


def scene_sketch(scene: SceneParts) -> str:
    """SVG of the bodies and what joins them; "" for a structure and for too many bodies."""
    names = ["ground", *(body.name for body in scene.moving_bodies)]
    if not 2 <= len(names) <= MOST_BODIES:
        return ""
    at = _places(names, [(_body(joint.marker_a), _body(joint.marker_b)) for joint in scene.joints])
    width = max(x for x, _ in at.values()) + WIDE + 2
    height = max(y for _, y in at.values()) + HIGH + 16
    joined = [(joint.marker_a, joint.marker_b, f"{joint.name}: {joint.type}", INK, "") for joint in scene.joints]
    for load in scene.loads:
        if {"marker_a", "marker_b"} <= load.markers.keys():
            joined.append((load.markers["marker_a"], load.markers["marker_b"], load.name, RED, "4 3"))
    ended: dict[str, int] = {}  # lines that end at a body so far
    lines = []
    for first, second, text, colour, dash in joined:
        a, b = sorted((_body(first), _body(second)), key=lambda name: at[name])
        ended[b] = ended.get(b, -1) + 1
        lines.append(_line(at[a], at[b], text, ended[b], colour, dash))
    boxes = [_box(at[name], name, GROUND if name == "ground" else PALE) for name in names]
    return (
        f'<svg width="{width}" height="{height}" style="display:block;margin:4px 0;max-width:100%" '
        f'font-family="system-ui,sans-serif" font-size="11">{"".join([*lines, *boxes])}</svg>'
    )


def _body(reference: str) -> str:
    return reference.partition(".")[0]


def _places(names: list[str], pairs: list[tuple[str, str]]) -> dict[str, tuple[int, int]]:
    """Upper left corners: a column for each number of joints from the ground; what it does not reach stands last."""
    level, reached = {"ground": 0}, ["ground"]
    for here in reached:
        for there in [b if a == here else a for a, b in pairs if here in (a, b)]:
            if there not in level:
                level[there] = level[here] + 1
                reached.append(there)
    alone = max(level.values()) + 1
    rows: dict[int, int] = {}
    found = {}
    for name in [*reached, *(name for name in names if name not in level)]:
        column = level.get(name, alone)
        row = rows[column] = rows.get(column, -1) + 1
        found[name] = (1 + column * ACROSS, 15 + row * DOWN)
    return found


def _box(at: tuple[int, int], name: str, colour: str) -> str:
    x, y = at
    return (
        f'<g><rect x="{x}" y="{y}" width="{WIDE}" height="{HIGH}" rx="4" fill="{colour}" stroke="{INK}"/>'
        f'<text x="{x + WIDE / 2}" y="{y + 16}" text-anchor="middle">{escape(name[:16])}</text></g>'
    )


def _line(a: tuple[int, int], b: tuple[int, int], text: str, place: int, colour: str, dash: str) -> str:
    """From box to box, bent where the boxes stand in one column; place: how many end at b above it."""
    shift = 6.0 * place
    if a[0] == b[0]:
        ends = (a[0] + WIDE / 2 + shift, a[1] + HIGH + 0.0), (a[0] + WIDE / 2 + shift, b[1] + 0.0)
        label, anchor = (ends[0][0] + 4, (ends[0][1] + ends[1][1]) / 2 + 4 + 10 * place), "start"
    else:
        ends = (a[0] + WIDE + 0.0, a[1] + HIGH / 2 + shift), (b[0] + 0.0, b[1] + HIGH / 2 + shift)
        label, anchor = (b[0] - 6.0, b[1] + HIGH / 2 - 4 + 12 * place), "end"
    (x1, y1), (x2, y2) = ends
    return (
        f'<path d="M{x1} {y1}L{x2} {y2}" fill="none" stroke="{colour}" stroke-width="1.4" stroke-dasharray="{dash}"/>'
        f'<text x="{label[0]}" y="{label[1]}" text-anchor="{anchor}" fill="{colour}" font-size="9">'
        f"{escape(text[:30])}</text>"
    )


def scene_card(scene: SceneParts) -> str:
    """HTML of a scene."""
    about = f"{scene.name}: {scene.space}, {len(scene.moving_bodies)} bodies, {len(scene.joints)} joints"
    bodies = [
        (body.name, body.type, f"{body.nf} modes" if body.nf else "", ", ".join(body.markers))
        for body in (scene.ground, *scene.moving_bodies)
    ]
    joints = [(joint.name, joint.type, f"{joint.marker_a} - {joint.marker_b}") for joint in scene.joints]
    joints += [(coupling.name, coupling.type, " - ".join(coupling.named)) for coupling in scene.couplings]
    loads = [(load.name, load.type, " - ".join(load.acts_at)) for load in scene.loads]
    measures = [(measure.name, measure.type) for measure in scene.measures]
    parameters = [
        (name, f"{entry.default:.6g}", entry.unit, entry.description) for name, entry in scene.parameters.items()
    ]
    parts = [
        fold(f"{len(rows)} {title}", table(rows)) if title in ("measures", "parameters") else table(rows, (title,))
        for title, rows in (
            ("bodies", bodies),
            ("joints", joints),
            ("loads", loads),
            ("measures", measures),
            ("parameters", parameters),
        )
        if rows
    ]
    return card(scene.title or scene.name, about, scene_sketch(scene), *parts)


class SceneRecord(SceneParts):
    """A planar or spatial mechanism, or a linear structure, with its parameters, initial state and simulation.

    gravity [m/s^2] in world axes. In a spatial scene a third component left out is zero. Lists keep their
    order; system coordinates follow the bodies' order.
    Raises SceneError when anything in it is wrong.
    """

    def __init__(self, /, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise_all(scene_errors(error, data))
        check_scene(self)

    @classmethod
    def from_dict(cls, data: Any) -> SceneRecord:
        """The scene described by a dictionary of plain values; raises SceneError."""
        if not isinstance(data, dict):
            raise SceneError("scene", f"{show(data)} is not a table of entries", "give a dictionary or a TOML file")
        wrong = [key for key in data if not isinstance(key, str)]
        if wrong:
            raise SceneError("scene", f"the key {show(wrong[0])} is not text", "use the names of the schema")
        return cls(**data)

    @classmethod
    def from_toml(cls, path: str | Path) -> SceneRecord:
        """The scene in a TOML file; raises SceneError, also when the file cannot be read."""
        folder = Path(path).parent
        return cls.from_dict(with_tables(with_files(toml_io.read(path), folder), folder))

    @classmethod
    def from_toml_text(cls, text: str) -> SceneRecord:
        """The scene in a TOML text; raises SceneError."""
        return cls.from_dict(toml_io.parse(text, "scene"))

    def model(self) -> Model:
        """The equations, ready to run: generated once, then kept in the cache. Raises SceneError."""
        found: Model = opened("symgen.scene.kept:kept_model")(self)
        return found

    def _repr_html_(self) -> str:
        return scene_card(self)

    def to_dict(self) -> dict[str, Any]:
        """Plain values in the schema's order, without entries that equal their default."""
        return toml_io.plain(self)

    def to_toml(self) -> str:
        """TOML text from which `from_toml` gives an equal scene; floats are written with repr."""
        return toml_io.write(self.to_dict())

    @staticmethod
    def json_schema() -> dict[str, Any]:
        """The JSON Schema of a scene."""
        return SceneRecord.model_json_schema()

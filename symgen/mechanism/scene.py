"""The scene: everything that is there, before any equation.

A scene in a notebook: bodies, joints, loads and parameters as tables.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from pydantic import PrivateAttr, ValidationError

from runtime.contract.cards import card, fold, table
from symgen.scene import toml_io
from symgen.scene.bodies import BeamBody
from symgen.scene.checks import check_scene
from symgen.scene.in_plane import planar_bodies
from symgen.scene.parts import SceneParts
from symgen.scene.tables import with_tables
from symgen.scene.toml_io import with_files
from symgen.scene.translate import scene_errors
from symgen.schema.errors import SceneError, raise_all, show

if TYPE_CHECKING:
    from runtime.model import Model


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
    return card(scene.title or scene.name, about, *parts)


class SceneRecord(SceneParts):
    """A planar or spatial mechanism, or a linear structure, with its parameters, initial state and simulation.

    gravity [m/s^2] in world axes. In a spatial scene a third component left out is zero. Lists keep their
    order; system coordinates follow the bodies' order.
    Raises SceneError when anything in it is wrong.
    """

    _meshed: dict[str, BeamBody] = PrivateAttr(default_factory=dict)  # as they were declared: text keeps their words

    def __init__(self, /, **data: Any) -> None:
        try:
            super().__init__(**data)
        except ValidationError as error:
            raise_all(scene_errors(error, data))
        meshed = (one for one in self.bodies if isinstance(one, BeamBody) and one.mesh == "lumped")
        self._meshed = {one.name: one for one in meshed}
        object.__setattr__(self, "bodies", planar_bodies(self.bodies, self.space, self))
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
        from symgen.mechanism.kept import kept_model

        return kept_model(self)

    def _repr_html_(self) -> str:
        return scene_card(self)

    def to_dict(self) -> dict[str, Any]:
        """Plain values in the schema's order, without entries that equal their default."""
        found = toml_io.plain(self)
        for k, body in enumerate(found.get("bodies", [])):
            if body["name"] in self._meshed:
                found["bodies"][k] = toml_io.plain(self._meshed[body["name"]])
        return found

    def to_toml(self) -> str:
        """TOML text from which `from_toml` gives an equal scene; floats are written with repr."""
        return toml_io.write(self.to_dict())

    @staticmethod
    def json_schema() -> dict[str, Any]:
        """The JSON Schema of a scene."""
        return SceneRecord.model_json_schema()

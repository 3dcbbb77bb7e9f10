"""The scene: everything that is there, before any equation."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pydantic import ValidationError

from symgen.scene import toml_io
from symgen.scene.checks import check_scene
from symgen.scene.parts import SceneParts
from symgen.scene.scene_card import scene_card
from symgen.scene.scene_files import with_files
from symgen.scene.tables import with_tables
from symgen.scene.translate import scene_errors
from symgen.schema.errors import SceneError, raise_all, show


class Scene(SceneParts):
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
    def from_dict(cls, data: Any) -> Scene:
        """The scene described by a dictionary of plain values; raises SceneError."""
        if not isinstance(data, dict):
            raise SceneError("scene", f"{show(data)} is not a table of entries", "give a dictionary or a TOML file")
        wrong = [key for key in data if not isinstance(key, str)]
        if wrong:
            raise SceneError("scene", f"the key {show(wrong[0])} is not text", "use the names of the schema")
        return cls(**data)

    @classmethod
    def from_toml(cls, path: str | Path) -> Scene:
        """The scene in a TOML file; raises SceneError, also when the file cannot be read."""
        folder = Path(path).parent
        return cls.from_dict(with_tables(with_files(toml_io.read(path), folder), folder))

    @classmethod
    def from_toml_text(cls, text: str) -> Scene:
        """The scene in a TOML text; raises SceneError."""
        return cls.from_dict(toml_io.parse(text, "scene"))

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
        return Scene.model_json_schema()

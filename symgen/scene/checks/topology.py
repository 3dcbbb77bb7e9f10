"""How the joints connect the bodies: loose bodies."""

from __future__ import annotations

from collections.abc import Iterator

from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError


class _Clusters:
    """Union-find: which names are connected."""

    def __init__(self) -> None:
        self._parent: dict[str, str] = {}

    def root(self, name: str) -> str:
        path = []
        while (parent := self._parent.get(name, name)) != name:
            path.append(name)
            name = parent
        self._parent.update(dict.fromkeys(path, name))
        return name

    def join(self, a: str, b: str) -> None:
        """Connect two names."""
        self._parent[self.root(a)] = self.root(b)


def topology_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Bodies that hang on nothing, unless free."""
    joined, touched = _Clusters(), set()
    for joint in scene.joints:
        a, b = joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0]
        joined.join(a, b)
        touched |= {a, b}
    free = {joined.root(body.name) for body in scene.moving_bodies if body.free}
    for index, body in enumerate(scene.bodies):
        held = joined.root(body.name) == joined.root("ground") or joined.root(body.name) in free
        if not held and body.name != "ground":
            problem = "has no connection to the ground" if body.name in touched else "is joined to nothing"
            yield SceneError(
                item_path("bodies", index, body.name),
                problem,
                "add a joint, or set free = true if that is meant",
            )
            free.add(joined.root(body.name))  # one error for each loose group of bodies

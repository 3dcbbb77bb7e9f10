"""How the joints connect the bodies: spanning tree, distances from the ground, placements, rings.

Made once from the scene. Elimination, assembly and forward dynamics read it and never ask the scene again.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING

from symgen.scene import Placement

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


@dataclass(frozen=True)
class Link:
    """A joint and the bodies of its markers a and b."""

    joint: str
    a: str
    b: str

    def other(self, body: str) -> str:
        """The body at the other end."""
        return self.b if body == self.a else self.a


@dataclass(frozen=True)
class Ring:
    """A closed path over joints: the joint that closes the spanning tree to it, and the joints of the tree in it."""

    closing: str
    along: tuple[str, ...]


@dataclass(frozen=True)
class Topology:
    """The graph of bodies (nodes, the ground among them) and joints (edges) of a mechanism.

    links: all joints, in scene order. tree: the joint by which a body is reached from the ground, or from the first
    body of a part that floats, on a shortest way. distance: joints on that way; parts that float start at 1.
    placements: joints that place a body by coordinates of their own, by name. rings: one for each two bodies that a
    joint connects beside the tree; joints between the same two bodies (a motor on a hinge) make no ring.
    """

    links: tuple[Link, ...]
    tree: Mapping[str, Link]
    distance: Mapping[str, int]
    placements: Mapping[str, Placement]
    rings: tuple[Ring, ...]

    @property
    def closing(self) -> list[str]:
        """Names of the joints that close rings."""
        return [ring.closing for ring in self.rings]

    @property
    def placed(self) -> frozenset[str]:
        """Names of the bodies that joints place."""
        return frozenset(placement.child for placement in self.placements.values())

    def distance_of(self, body: str) -> int:
        """Joints between a body and the ground."""
        return self.distance.get(body, 0)

    def depth(self) -> dict[str, int]:
        """Distance of each joint from the ground: that of the nearer of its bodies."""
        return {link.joint: min(self.distance_of(link.a), self.distance_of(link.b)) for link in self.links}


def topology_of(scene: SceneRecord) -> Topology:
    """The topology of a scene; that of a linear structure is empty."""
    links = tuple(
        Link(joint.name, joint.marker_a.partition(".")[0], joint.marker_b.partition(".")[0]) for joint in scene.joints
    )
    tree, distance = _spanning_tree(["ground", *(body.name for body in scene.bodies)], links)
    placements = {placement.joint: placement for placement in scene.placements()}
    return Topology(links, tree, distance, placements, _rings(links, tree))


def _spanning_tree(roots: list[str], links: tuple[Link, ...]) -> tuple[dict[str, Link], dict[str, int]]:
    """(joint that reaches each body, distance of each body), breadth first."""
    at: dict[str, list[Link]] = {}
    for link in links:
        at.setdefault(link.a, []).append(link)
        at.setdefault(link.b, []).append(link)
    tree: dict[str, Link] = {}
    distance = {roots[0]: 0}
    for root in roots:
        distance.setdefault(root, 1)
        queue = deque([root])
        while queue:
            body = queue.popleft()
            for link in at.get(body, ()):
                other = link.other(body)
                if other not in distance:
                    tree[other], distance[other] = link, distance[body] + 1
                    queue.append(other)
    return tree, distance


def _rings(links: tuple[Link, ...], tree: Mapping[str, Link]) -> tuple[Ring, ...]:
    """The fundamental cycles: a joint beside the tree and the ways of its bodies to their common root."""
    seen = {frozenset((link.a, link.b)) for link in tree.values()}
    rings = []
    for link in links:
        ends = frozenset((link.a, link.b))
        if len(ends) == 2 and ends not in seen:
            seen.add(ends)
            paths = [_path_to_root(body, tree) for body in (link.a, link.b)]
            along = [name for path, other in (paths, paths[::-1]) for name in path if name not in other]
            rings.append(Ring(link.joint, tuple(along)))
    return tuple(rings)


def _path_to_root(body: str, tree: Mapping[str, Link]) -> list[str]:
    path = []
    while body in tree:
        link = tree[body]
        path.append(link.joint)
        body = link.other(body)
    return path

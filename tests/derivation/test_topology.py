"""The topology record: by hand on built-in scenes, and as a graph on random ones."""

from __future__ import annotations

from collections import Counter

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from symgen.scene import SceneRecord
from symgen.scenes import SCENES
from symgen.system.topology import Ring, Topology, topology_of

# scene: (distance of each body from the ground, rings, joints that place a body)
BY_HAND: dict[str, tuple[dict[str, int], list[Ring], dict[str, str]]] = {
    "double_pendulum": ({"upper": 1, "lower": 2}, [], {}),
    "four_bar": ({"crank": 1, "coupler": 2, "rocker": 1}, [Ring("C", ("B", "A", "D"))], {}),
    "n_four_bar": (
        {"upright0": 1, "top1": 2, "upright1": 1, "top2": 2, "upright2": 1},
        [Ring("C1", ("B0", "A0", "A1")), Ring("C2", ("B1", "A1", "A2"))],
        {},
    ),
    "bricard": (
        {"bar1": 1, "bar2": 2, "bar3": 3, "bar4": 2, "bar5": 1},
        [Ring("hinge3", ("hinge2", "hinge1", "hinge0", "hinge4", "hinge5"))],
        {"hinge0": "bar1", "hinge1": "bar2", "hinge2": "bar3", "hinge4": "bar4", "hinge5": "bar5"},
    ),
    "tumbling_body": ({"body": 1}, [], {}),
    "two_oscillators": ({}, [], {}),
}


@pytest.mark.parametrize("name", BY_HAND)
def test_built_in_scenes(name: str) -> None:
    distance, rings, placed = BY_HAND[name]
    found = topology_of(SCENES[name]())
    assert dict(found.distance) == {"ground": 0, **distance}
    assert list(found.rings) == rings
    assert found.closing == [ring.closing for ring in rings]
    assert {joint: placement.child for joint, placement in found.placements.items()} == placed


def scene_of(bodies: int, pairs: list[tuple[int, int]]) -> SceneRecord:
    """Free bodies (0 is the ground) and a hinge for each pair."""
    names = ["ground", *(f"b{k}" for k in range(1, bodies + 1))]
    return SceneRecord.from_dict(
        {
            "name": "graph",
            "bodies": [{"type": "rigid", "name": n, "mass": 1.0, "inertia": 1.0, "free": True} for n in names[1:]],
            "joints": [
                {
                    "type": "revolute",
                    "name": f"j{k}",
                    "marker_a": f"{names[a]}.origin",
                    "marker_b": f"{names[b]}.origin",
                }
                for k, (a, b) in enumerate(pairs)
            ],
        }
    )


def components(nodes: set[str], edges: list[tuple[str, str]]) -> int:
    """Number of connected parts, by contracting edges."""
    part = {node: node for node in nodes}
    for a, b in edges:
        old, new = part[a], part[b]
        part = {node: new if label == old else label for node, label in part.items()}
    return len(set(part.values()))


@st.composite
def graphs(draw: st.DrawFn) -> Topology:
    bodies = draw(st.integers(1, 7))
    node = st.integers(0, bodies)
    pairs = draw(st.lists(st.tuples(node, node).filter(lambda pair: pair[0] != pair[1]), max_size=12))
    return topology_of(scene_of(bodies, pairs))


@settings(max_examples=60, deadline=None)
@given(graphs())
def test_rings_are_closed_ways_and_as_many_as_the_graph_has(found: Topology) -> None:
    """Edges - nodes + parts rings (Euler), each a closed way: every body in it has two of its joints."""
    ends = {link.joint: (link.a, link.b) for link in found.links}
    edges = {frozenset(pair): pair for pair in ends.values()}
    parts = components(set(found.distance), list(edges.values()))
    assert len(found.rings) == len(edges) - len(found.distance) + parts
    for ring in found.rings:
        met = Counter(body for joint in (ring.closing, *ring.along) for body in ends[joint])
        assert set(met.values()) == {2}
    assert len(found.tree) == len(found.distance) - parts


@settings(max_examples=60, deadline=None)
@given(graphs())
def test_distances_are_shortest_ways(found: Topology) -> None:
    """Neighbours differ by one at most, and a body's joint of the tree leads one nearer to the root."""
    for link in found.links:
        assert abs(found.distance[link.a] - found.distance[link.b]) <= 1
    for body, link in found.tree.items():
        assert found.distance[link.other(body)] == found.distance[body] - 1

"""What is written by mistake and would run: refused by the item, with what may be meant; what is near it is not."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from symgen.scene import Scene, SceneError

I3 = [0.1, 0.1, 0.1]
TIP = {"tip": {"position": (1.0, 0.0)}}


def planar(**fields: Any) -> Scene:
    return Scene("s").gravity(0, -9.81).rigid("b", mass=1.0, inertia=0.1, markers=TIP, **fields)


def spatial() -> Scene:
    return Scene("s", space="spatial").rigid("b", mass=1.0, inertia=I3)


def beam(ratio: Any, **fields: Any) -> Scene:
    section = {"length": 1.0, "density": 2700.0, "area": 1e-4, "second_moment": 1e-9, "youngs_modulus": 7e10}
    scene = Scene("s").parameter("zeta", 2.0).beam("b", **section, lateral={"modes": 1}, damping_ratio=ratio, **fields)
    return scene.revolute("h", "ground.origin", "b.start")


def touching(**other: Any) -> Scene:
    return planar(free=True).contact("c", "b.origin", radius=0.3, stiffness=1e3, **other)


G, B = "ground.origin", "b.origin"
REFUSED: dict[str, tuple[Callable[[], Scene], str, str]] = {
    "ball on itself": (lambda: touching(other="b.tip", other_radius=0.3), "loads[0] 'c'.other", "touch itself"),
    "plane of its own": (lambda: touching(plane="b.tip"), "loads[0] 'c'.plane", "touch itself"),
    "spring in a rigid body": (
        lambda: planar(free=True).spring_damper("k", B, "b.tip", stiffness=1.0), "loads[0] 'k'", "rigid body 'b'"
    ),
    "damping in per cent": (lambda: beam(2), "bodies[0] 'b'.damping_ratio", "0.02 for 2 %"),
    "the same by a parameter": (lambda: beam("zeta"), "bodies[0] 'b'.damping_ratio", "0.02 for 2 %"),
    "lead of zero": (lambda: spatial().screw("h", G, B, lead=0.0), "joints[0] 'h'.lead", "revolute"),
    "nothing free": (lambda: planar().revolute("h", G, B).prismatic("p", G, B), "joints[1] 'p'", "nothing free"),
    "nothing free in space": (
        lambda: spatial().screw("h", G, B, lead=0.1).revolute("p", G, B), "joints[1] 'p'", "nothing free"
    ),
    "a weld besides": (lambda: planar().revolute("h", G, B).weld("w", G, B), "joints[1] 'w'", "nothing free"),
}  # fmt: skip
TAKEN: dict[str, Callable[[], Scene]] = {
    "ball on the ground": lambda: touching(plane=G),
    "damping that holds at a frequency": lambda: beam(2, damping_frequency=1e4),
    "a drive of a hinge": lambda: planar().revolute("h", G, B).prescribed_angle("d", G, B, motion="t"),
    "two bearings": lambda: planar().revolute("h", G, B).revolute("i", G, "b.tip"),
    "a hinge in a sleeve": lambda: spatial().cylindrical("h", G, B).revolute("i", G, B),
}


@pytest.mark.parametrize("name", REFUSED)
def test_mistakes_are_refused(name: str) -> None:
    make, item, phrase = REFUSED[name]
    with pytest.raises(SceneError) as refused:
        make().build()
    assert refused.value.item == item and phrase in str(refused.value) and refused.value.remedy


@pytest.mark.parametrize("name", TAKEN)
def test_what_may_be_meant_is_taken(name: str) -> None:
    assert TAKEN[name]().build()

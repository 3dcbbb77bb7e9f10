"""Mechanisms that many tests are about: a body on a hinge or on a rail, a bob on a driven crank."""

from __future__ import annotations

from typing import Any

from symgen.scene import Scene


def on_hinge(name: str, body: str, joint: str, **fields: Any) -> Scene:
    """A rigid body (mass [kg], inertia [kg m^2] and what else `rigid` takes) on a hinge of the ground."""
    return Scene(name).rigid(body, **fields).revolute(joint, "ground.origin", f"{body}.origin")


def on_rail(name: str, body: str, joint: str, **fields: Any) -> Scene:
    """A rigid body that slides along the x-axis of the ground."""
    return Scene(name).rigid(body, **fields).prismatic(joint, "ground.origin", f"{body}.origin")


def driven_bob(name: str, motion: str) -> Scene:
    """A bob (1 kg, centre at 0.5 m, 0.35 kg m^2 about its hinge) on the tip of a crank of 0.5 m that turns as given."""
    scene = Scene(name).rigid("crank", mass=1.0, inertia=0.01, markers={"tip": {"position": (0.5, 0)}})
    scene.rigid("bob", mass=1.0, inertia=0.1, center_of_mass=(0.5, 0))
    scene.revolute("pin", "ground.origin", "crank.origin").revolute("hinge", "crank.tip", "bob.origin")
    return scene.prescribed_angle("drive", "ground.origin", "crank.origin", motion=motion)

"""Scenes of turning parts whose frequencies are known in closed form."""

from __future__ import annotations

import math

from symgen.scene import Scene, SceneRecord

UNIT = math.sqrt(2.8e10 * 5e-7 / (1200.0 * 1e-3 * 10.0**4))  # rad/s, sqrt(EI / (rho A L^4)) of the beam of case F3


def gimbal(stiffness: float, spin: float) -> SceneRecord:
    """A rotor on two massless rings with equal torsional springs, turning about its axis."""
    x, y = {"axis": (1.0, 0.0, 0.0)}, {"axis": (0.0, 1.0, 0.0)}
    return (
        Scene("gimbal", space="spatial")
        .ground(markers={"x": x})
        .rigid("outer", mass=1.0, inertia=(0.0, 0.0, 0.0), markers={"x": x, "y": y})
        .rigid("inner", mass=1.0, inertia=(0.0, 0.0, 0.0), markers={"y": y})
        .rigid("rotor", mass=3.0, inertia=(0.02, 0.02, 0.03))
        .revolute("tilt", "ground.x", "outer.x")
        .revolute("lean", "outer.y", "inner.y")
        .revolute("spin", "inner.origin", "rotor.origin")
        .rotational_spring_damper("k1", "ground.x", "outer.x", stiffness=stiffness)
        .rotational_spring_damper("k2", "outer.y", "inner.y", stiffness=stiffness)
        .rates({"spin.angle": spin})
        .build()
    )


def jeffcott(damping: float) -> SceneRecord:
    """A disk of 2 kg on a soft isotropic shaft, 800 N/m, turning in its plane."""
    return (
        Scene("jeffcott")
        .rigid("disk", mass=2.0, inertia=0.05, free=True)
        .measure("x", "x", of="disk.origin")
        .measure("y", "y", of="disk.origin")
        .force("shaft", "disk.origin", f"-800 * x - {damping} * x_dot", f"-800 * y - {damping} * y_dot")
        .build()
    )

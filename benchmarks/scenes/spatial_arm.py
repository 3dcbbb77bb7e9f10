"""Arm in space: rigid links on hinges that turn about two axes by turns, the last link flexible."""

from __future__ import annotations

from math import sin
from typing import Any

from symgen.scene import Scene, SceneRecord

LENGTH, MASS = 0.5, 0.3  # m, kg


def spatial_arm(links: int = 10, modes: int = 2, stiffening: float = 1.0) -> SceneRecord:
    """`links` links of 0.5 m that hang bent; the last one is a beam with `modes` bending modes in each plane.

    stiffening: factor on its modulus.
    """
    title = f"Arm of {links} links in space, the last one flexible"
    builder = Scene("spatial_arm", space="spatial", title=title).gravity(0.0, 0.0, -9.81)
    turned: list[dict[str, Any]] = [{"axis": [0, 1, 0], "x_axis": [1, 0, 0]}, {"axis": [0, 0, 1], "x_axis": [1, 0, 0]}]
    builder.ground(markers={"hinge": turned[0]})
    previous = "ground.hinge"
    across = MASS * LENGTH**2 / 12
    for k in range(1, links):
        here, there = turned[(k - 1) % 2], turned[k % 2]
        builder.rigid(
            f"link{k}",
            mass=MASS,
            inertia=[1e-3, across, across],
            center_of_mass=[LENGTH / 2, 0, 0],
            markers={"start": here, "end": {"position": [LENGTH, 0, 0], **there}},
        )
        builder.joint("revolute", f"hinge{k}", previous, f"link{k}.start")
        previous = f"link{k}.end"
    builder.beam(
        "tip",
        length=LENGTH,
        density=7800.0,
        area=2e-5,
        second_moment=1e-11,
        second_moment_z=2e-11,
        youngs_modulus=2e11 * stiffening,
        lateral={"ends": "clamped-free", "modes": modes},
        lateral_z={"ends": "clamped-free", "modes": modes},
        markers={"root": {"at": 0.0, **turned[(links - 1) % 2]}},
    )
    builder.joint("revolute", f"hinge{links}", previous, "tip.root")
    builder.initial({f"hinge{k}.angle": {"value": 0.4 * sin(k), "fixed": True} for k in range(1, links + 1)})
    builder.groups(L=["hinge*.angle"], S=["tip.q*"])
    return builder.simulation(t_end=0.3, dt=1e-4, m=[8], scheme="single_rate").build()

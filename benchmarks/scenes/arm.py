"""Hanging arm of rigid links whose last link is flexible: stiffness in one place, many slow bodies."""

from __future__ import annotations

from math import sin

from symgen.scene import Scene, SceneRecord

LENGTH, MASS = 0.5, 0.3  # m, kg


def arm(links: int = 10, modes: int = 3, stiffening: float = 1.0, lively: float = 0.0) -> SceneRecord:
    """`links` links of 0.5 m, the last one a beam with `modes` bending modes; stiffening: factor on its modulus.

    Angles of the links are slow, modes are fast. The arm starts straight; lively [rad] bends it, so that the links far
    from the ground move as much as the others.
    """
    builder = Scene("arm", title=f"Arm of {links} links, the last one flexible").gravity(0, -9.81)
    previous = "ground.origin"
    for k in range(1, links):
        name = f"link{k}"
        builder.rigid(
            name,
            mass=MASS,
            inertia=MASS * LENGTH**2 / 12,
            center_of_mass=(LENGTH / 2, 0),
            markers={"end": {"position": (LENGTH, 0)}},
        )
        builder.revolute(f"hinge{k}", previous, f"{name}.origin")
        previous = f"{name}.end"
    last = f"link{links}"
    builder.beam(
        last,
        length=LENGTH,
        density=7800.0,
        area=2e-5,
        second_moment=1e-11,
        youngs_modulus=2e11 * stiffening,
        lateral={"ends": "clamped-free", "modes": modes},
    ).revolute(f"hinge{links}", previous, f"{last}.start")
    return (
        builder.groups(L=["link*.theta"], S=[f"{last}.q*"])
        .initial({f"link{k}.theta": -1.2 + lively * sin(k) for k in range(1, links + 1)})
        .simulation(t_end=0.5, dt=1e-4, m=[8], scheme="single_rate")
        .build()
    )

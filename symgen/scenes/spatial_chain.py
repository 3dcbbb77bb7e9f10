"""Hanging chain in space: N links on spherical joints, rigid or with `modes` (2: one bending mode in each plane)."""

from __future__ import annotations

from symgen.scene import Scene, SceneRecord

LENGTH, SIDE = 0.2, 0.008


def spatial_chain(links: int = 3, modes: int = 0, orientation: str = "zyx") -> SceneRecord:
    """Links along their own x-axis, the first one starting level along x; Euler angles zyx by default."""
    builder = Scene("spatial_chain", space="spatial", title=f"Chain of {links} links in space")
    builder.gravity(0.0, 0.0, -9.81)
    mass, across = 2700 * SIDE**2 * LENGTH, SIDE**2 / 12
    slender = LENGTH**2 / 12 + across
    for k in range(links):
        link = f"link{k + 1}"
        if modes:
            builder.beam(
                link,
                length=LENGTH,
                density=2700.0,
                area=SIDE**2,
                second_moment=SIDE**4 / 12,
                second_moment_z=SIDE**4 / 12,
                youngs_modulus=7e10,
                orientation=orientation,
                lateral={"ends": "clamped-free", "modes": modes - modes // 2},
                lateral_z={"ends": "clamped-free", "modes": modes // 2} if modes > 1 else None,
            )
        else:
            builder.rigid(
                link,
                mass=mass,
                inertia=[mass * 2 * across, mass * slender, mass * slender],
                center_of_mass=[LENGTH / 2, 0, 0],
                orientation=orientation,
                markers={"start": {}, "end": {"position": [LENGTH, 0, 0]}},
            )
        builder.joint("spherical", f"joint{k + 1}", f"link{k}.end" if k else "ground.origin", f"{link}.start")
    builder.rates({"link1.theta1": 1.0} if orientation == "zyx" else {})
    return builder.simulation(t_end=1.0, dt=1e-4, scheme="single_rate").build()

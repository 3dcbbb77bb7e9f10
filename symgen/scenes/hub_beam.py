"""Torque-driven hub with a flexible beam (case F2, Wu and Haug)."""

from symgen.scene import Scene, SceneRecord


def hub_beam(hub_inertia: float = 10.0, modes: int = 3) -> SceneRecord:
    """A beam clamped to a hub that a torque 10 sin(pi t) turns for 2 s: strong inertia coupling (case F2)."""
    return (
        Scene("hub_beam", title="Hub with a flexible beam (F2)")
        .parameter("torque", 10.0, "N m", "amplitude of the torque")
        .rigid("hub", mass=1.0, inertia=hub_inertia)
        .beam(
            "beam",
            length=8.0,
            density=2766.7,
            area=7.2968e-5,
            second_moment=8.2189e-9,
            youngs_modulus=6.8952e10,
            lateral={"ends": "clamped-free", "modes": modes},
            stiffening=True,
        )
        .revolute("pivot", "ground.origin", "hub.origin")
        .weld("clamp", "hub.origin", "beam.start")
        .torque("motor", "hub.origin", "where(t < 2, torque * sin(pi * t), 0)")
        .measure("tip_x", "x", of="beam.end")
        .measure("tip_y", "y", of="beam.end")
        .simulation(t_end=5.0, dt=1e-3, m=[1], scheme="single_rate", seen_every=0.01)
        .build()
    )

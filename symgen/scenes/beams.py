"""Beams that turn: driven by a torque, or brought to a speed."""

from symgen.mechanism.builder import Scene
from symgen.mechanism.scene import SceneRecord


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


RAMP = "omega / ramp * (t**2 / 2 + (ramp / (2 * pi))**2 * (cos(2 * pi * t / ramp) - 1))"


def spin_up_beam(stiffening: bool = True, modes: int = 5) -> SceneRecord:
    """A beam brought to 6 rad/s in 15 s: without geometric stiffening the model diverges physically (case F3)."""
    return (
        Scene("spin_up_beam", title="Spin-up of a rotating beam (F3)")
        .parameter("omega", 6.0, "rad/s", "final speed")
        .parameter("ramp", 15.0, "s", "duration of the spin-up")
        .beam(
            "beam",
            length=10.0,
            density=1200.0,
            area=1e-3,
            second_moment=5e-7,
            youngs_modulus=2.8e10,
            lateral={"ends": "clamped-free", "modes": modes},
            stiffening=stiffening,
        )
        .revolute("pivot", "ground.origin", "beam.start")
        .prescribed_angle(
            "spin", "ground.origin", "beam.start", motion=f"where(t < ramp, {RAMP}, omega * (t - ramp / 2))"
        )
        .measure("tip_x", "x", of="beam.end")
        .measure("tip_y", "y", of="beam.end")
        .simulation(t_end=20.0, dt=1e-3, scheme="single_rate", seen_every=0.02)
        .build()
    )

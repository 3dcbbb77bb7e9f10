"""Spin-up of a rotating beam (case F3: Simo and Vu-Quoc; Kane, Ryan and Banerjee)."""

from symgen.scene import Scene, SceneRecord

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

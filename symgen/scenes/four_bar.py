"""Four-bar linkage with a loop closure of two unknowns."""

from symgen.scene import Scene, SceneRecord


def four_bar() -> SceneRecord:
    """A crank-rocker four-bar linkage under gravity and a constant torque."""
    builder = Scene("four_bar", title="Four-bar linkage").gravity(0, -9.81)
    builder.ground(markers={"right": {"position": (0.30, 0)}})
    for name, length, mass in (("crank", 0.10, 0.5), ("coupler", 0.30, 1.0), ("rocker", 0.25, 0.8)):
        builder.rigid(
            name,
            mass=mass,
            inertia=mass * length**2 / 12,
            center_of_mass=(length / 2, 0),
            markers={"tip": {"position": (length, 0)}},
        )
    return (
        builder.revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "coupler.origin")
        .revolute("C", "coupler.tip", "rocker.tip")
        .revolute("D", "ground.right", "rocker.origin")
        .torque("motor", "crank.origin", 0.5)
        .independent("crank.theta")
        .initial({"crank.theta": 1.0, "coupler.theta": 0.4, "rocker.theta": 1.6})
        .simulation(t_end=2.0, dt=2e-4, scheme="single_rate", seen_every=0.004)
        .build()
    )

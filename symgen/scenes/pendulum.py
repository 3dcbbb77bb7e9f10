"""Simple pendulum of IFToMM benchmark A01 (case P1)."""

from symgen.scene import Scene, SceneRecord


def pendulum() -> SceneRecord:
    """A point mass on a massless rod, released horizontally (case P1)."""
    return (
        Scene(
            "pendulum",
            title="Simple pendulum",
            description="1 kg at 1 m on a massless rod, released at rest. Period 2.36784194757624 s.",
        )
        .parameter("length", 1.0, "m", "length of the rod")
        .gravity(0, -9.81)
        .rigid("rod", mass=1.0, inertia=0.0, center_of_mass=("length", 0), markers={"tip": {"position": ("length", 0)}})
        .revolute("hinge", "ground.origin", "rod.origin")
        .measure("tip_x", "x", of="rod.tip")
        .measure("tip_y", "y", of="rod.tip")
        .initial({"rod.theta": 3.141592653589793})
        .simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01)
        .build()
    )

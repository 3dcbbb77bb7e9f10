"""Double pendulum of two uniform rods."""

from symgen.scene import Scene, SceneRecord


def double_pendulum() -> SceneRecord:
    """Two uniform rods of 1 m and 1 kg, released from the horizontal."""
    return (
        Scene("double_pendulum", title="Double pendulum")
        .gravity(0, -9.81)
        .rigid("upper", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
        .rigid("lower", mass=1.0, inertia=1 / 12, center_of_mass=(0.5, 0), markers={"tip": {"position": (1.0, 0)}})
        .revolute("shoulder", "ground.origin", "upper.origin")
        .revolute("elbow", "upper.tip", "lower.origin")
        .initial({"upper.theta": 0.0, "lower.theta": 0.0})
        .simulation(t_end=5.0, dt=5e-4, scheme="single_rate", seen_every=0.01)
        .build()
    )

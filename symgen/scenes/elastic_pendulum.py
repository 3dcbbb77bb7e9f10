"""Elastic pendulum: a heavy point on a spring."""

from symgen.scene import Scene, SceneRecord


def elastic_pendulum() -> SceneRecord:
    """A body hung on a stiff spring: a slow swing and a fast stretch without joints."""
    return (
        Scene(
            "elastic_pendulum",
            title="Elastic pendulum",
            description="A body on a spring: slow swinging, fast stretching, no joint at all.",
        )
        .gravity(0, -9.81)
        .rigid("bob", mass=1.0, inertia=0.01, free=True)
        .spring_damper("spring", "ground.origin", "bob.origin", stiffness=1000.0, damping=0.5, free_length=1.0)
        .measure("stretch", "distance", of="bob.origin")
        .initial({"bob.x": 0.6, "bob.y": -0.8})
        .simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01)
        .build()
    )

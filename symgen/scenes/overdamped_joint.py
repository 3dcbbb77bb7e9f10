"""Pendulum with a light finger behind an overdamped joint."""

from symgen.scene import Scene, SceneRecord


def overdamped_joint() -> SceneRecord:
    """A pendulum carries a 20 g finger on a joint spring with a damper some 30 times the critical one.

    The finger's fast rate is damping / inertia = 2e4 1/s, its slow one stiffness / damping, about 4 1/s, as slow as the
    pendulum. So the damper, not the spring, limits the step of a scheme that takes velocities explicitly.
    """
    finger = {"mass": 0.02, "length": 0.1}
    inertia = finger["mass"] * finger["length"] ** 2 / 3  # about the joint
    return (
        Scene("overdamped_joint", title="Pendulum with an overdamped joint")
        .gravity(0, -9.81)
        .rigid(
            "rod", mass=0.5, inertia=0.5 * 0.4**2 / 12, center_of_mass=(0.2, 0), markers={"tip": {"position": (0.4, 0)}}
        )
        .rigid("finger", mass=finger["mass"], inertia=inertia / 4, center_of_mass=(finger["length"] / 2, 0))
        .revolute("hinge", "ground.origin", "rod.origin")
        .revolute("knuckle", "rod.tip", "finger.origin")
        .rotational_spring_damper("spring", "rod.origin", "finger.origin", stiffness=5.0, damping=2e4 * inertia)
        .groups(L=["rod.theta"], S=["finger.theta"])
        .initial({"rod.theta": 0.0, "finger.theta": 0.0})
        .simulation(t_end=3.0, dt=5e-5, m=[1], scheme="single_rate", seen_every=0.005)
        .build()
    )

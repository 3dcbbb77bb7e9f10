"""Rigid slider-crank."""

from symgen.scene import Scene, SceneRecord


def slider_crank() -> SceneRecord:
    """A rigid slider-crank running freely from 150 rad/s under gravity."""
    return (
        Scene("slider_crank", title="Rigid slider-crank")
        .gravity(0, -9.81)
        .rigid("crank", mass=0.36, inertia=7.02e-4, center_of_mass=(0.075, 0), markers={"tip": {"position": (0.15, 0)}})
        .rigid(
            "rod",
            mass=0.151104,
            inertia=1.1340854e-3,
            center_of_mass=(0.15, 0),
            markers={"tip": {"position": (0.30, 0)}},
        )
        .rigid("slider", mass=0.075552, inertia=1e-5)
        .revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "rod.origin")
        .prismatic("slide", "ground.origin", "slider.origin")
        .revolute("C", "rod.tip", "slider.origin")
        .independent("crank.theta")
        .initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .rates({"crank.theta": 150.0})
        .simulation(t_end=0.1, dt=2e-5, scheme="single_rate", seen_every=0.0005)
        .build()
    )

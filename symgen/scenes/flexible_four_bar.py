"""Four-bar linkage with a flexible coupler and a flexible rocker."""

from symgen.scene import Scene, SceneRecord

CRANK, COUPLER, ROCKER, BASE = 0.10, 0.30, 0.25, 0.30  # m
WIDTH, DEPTH = 0.012, 0.004  # m, the cross-section of the two beams


def flexible_four_bar() -> SceneRecord:
    """A heavy crank runs freely and drives two thin steel beams through a loop closure of two unknowns.

    With geometric stiffening the bending of both beams shortens them, so all elastic coordinates enter the closure.
    """
    builder = Scene("flexible_four_bar", title="Four-bar linkage with two flexible links").gravity(0, -9.81)
    builder.ground(markers={"right": {"position": (BASE, 0)}})
    builder.rigid("crank", mass=0.8, inertia=4e-3, center_of_mass=(0.0, 0), markers={"tip": {"position": (CRANK, 0)}})
    for name, length in (("coupler", COUPLER), ("rocker", ROCKER)):
        builder.beam(
            name,
            length=length,
            density=7850.0,
            area=WIDTH * DEPTH,
            second_moment=WIDTH * DEPTH**3 / 12,
            youngs_modulus=2.1e11,
            lateral={"ends": "pinned-pinned", "modes": 2},
            stiffening=True,
        )
    return (
        builder.revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "coupler.start")
        .revolute("C", "coupler.end", "rocker.end")
        .revolute("D", "ground.right", "rocker.start")
        .independent("crank.theta", "coupler.q1", "coupler.q2", "rocker.q1", "rocker.q2")
        .initial({"crank.theta": 1.0, "coupler.theta": 0.4, "rocker.theta": 1.6})
        .rates({"crank.theta": 80.0})
        .simulation(t_end=0.5, dt=1e-4, m=[1], scheme="single_rate", seen_every=0.001, start="quasi_static")
        .build()
    )

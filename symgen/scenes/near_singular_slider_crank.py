"""Slider-crank whose crank is nearly as long as its rod."""

from symgen.scene import Scene, SceneRecord

CRANK, ROD, DEPTH = 0.294, 0.30, 0.008  # m; the crank is 0.98 of the rod


def near_singular_slider_crank() -> SceneRecord:
    """A flexible rod 2 % longer than the crank: the mechanism runs freely and passes close to a change point.

    With equal lengths the slider would reach the crank's axis at 90 degrees and could stay there: a singular
    position. Here the rate of the rod reverses within some 20 degrees of the crank, and the slider stops nearly as
    fast, so inertia and accelerations change sharply twice a revolution.
    """
    return (
        Scene("near_singular_slider_crank", title="Flexible slider-crank close to a change point")
        .rigid("crank", mass=0.7, inertia=0.02, center_of_mass=(0.0, 0), markers={"tip": {"position": (CRANK, 0)}})
        .beam(
            "rod",
            length=ROD,
            density=7870.0,
            area=DEPTH**2,
            second_moment=DEPTH**4 / 12,
            youngs_modulus=2e11,
            lateral={"ends": "pinned-pinned", "modes": 2},
            stiffening=True,
        )
        .rigid("slider", mass=0.075, inertia=1e-5)
        .revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "rod.start")
        .prismatic("slide", "ground.origin", "slider.origin")
        .revolute("C", "rod.end", "slider.origin")
        .independent("crank.theta", "rod.q1", "rod.q2")
        .initial({"crank.theta": 0.0, "rod.theta": 0.0})
        .rates({"crank.theta": 50.0})
        .simulation(t_end=0.5, dt=5e-5, m=[1], scheme="single_rate", seen_every=0.001, start="quasi_static")
        .build()
    )

"""Planar linkages whose loops close: four bars and slider-cranks, rigid and flexible."""

import math

from symgen.mechanism.builder import Scene
from symgen.mechanism.scene import SceneRecord
from symgen.scene import SceneError


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


def n_four_bar(windows: int = 2) -> SceneRecord:
    """2 N + 1 bars of 1 m and 1 kg, uprights vertical at the start, their tips moving at 1 m/s along x.

    Each time all bars lie in one line the mechanism has more than one freedom: a singular position.
    """
    if windows < 1:
        raise SceneError("windows", f"{windows} windows do not make a mechanism", "give at least 1")
    builder = Scene("n_four_bar", title=f"{windows} four-bar windows side by side").gravity(0, -9.81)
    builder.ground(markers={f"foot{k}": {"position": (k, 0)} for k in range(1, windows + 1)})
    _bar(builder, "upright0")
    builder.revolute("A0", "ground.origin", "upright0.origin")
    for k in range(1, windows + 1):
        _bar(builder, f"top{k}")
        _bar(builder, f"upright{k}")
        builder.revolute(f"B{k - 1}", f"upright{k - 1}.tip", f"top{k}.origin")
        builder.revolute(f"C{k}", f"top{k}.tip", f"upright{k}.tip")
        builder.revolute(f"A{k}", f"ground.foot{k}", f"upright{k}.origin")
    uprights = [f"upright{k}.theta" for k in range(windows + 1)]
    builder.initial(dict.fromkeys(uprights, math.pi / 2)).rates(dict.fromkeys(uprights, -1.0))
    return builder.simulation(t_end=10.0, dt=1e-3, scheme="single_rate", seen_every=0.01).build()


def _bar(builder: Scene, name: str) -> None:
    builder.rigid(name, mass=1.0, inertia="1 / 12", center_of_mass=(0.5, 0), markers={"tip": {"position": (1, 0)}})


def flexible_four_bar() -> SceneRecord:
    """A heavy crank runs freely and drives two thin steel beams through a loop closure of two unknowns.

    With geometric stiffening the bending of both beams shortens them, so all elastic coordinates enter the closure.
    """
    crank, coupler, rocker, base = 0.10, 0.30, 0.25, 0.30  # m
    width, depth = 0.012, 0.004  # m, the cross-section of the two beams
    builder = Scene("flexible_four_bar", title="Four-bar linkage with two flexible links").gravity(0, -9.81)
    builder.ground(markers={"right": {"position": (base, 0)}})
    builder.rigid("crank", mass=0.8, inertia=4e-3, center_of_mass=(0.0, 0), markers={"tip": {"position": (crank, 0)}})
    for name, length in (("coupler", coupler), ("rocker", rocker)):
        builder.beam(
            name,
            length=length,
            density=7850.0,
            area=width * depth,
            second_moment=width * depth**3 / 12,
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


def near_singular_slider_crank() -> SceneRecord:
    """A flexible rod 2 % longer than the crank: the mechanism runs freely and passes close to a change point.

    With equal lengths the slider would reach the crank's axis at 90 degrees and could stay there: a singular
    position. Here the rate of the rod reverses within some 20 degrees of the crank, and the slider stops nearly as
    fast, so inertia and accelerations change sharply twice a revolution.
    """
    crank, rod, depth = 0.294, 0.30, 0.008  # m; the crank is 0.98 of the rod
    return (
        Scene("near_singular_slider_crank", title="Flexible slider-crank close to a change point")
        .rigid("crank", mass=0.7, inertia=0.02, center_of_mass=(0.0, 0), markers={"tip": {"position": (crank, 0)}})
        .beam(
            "rod",
            length=rod,
            density=7870.0,
            area=depth**2,
            second_moment=depth**4 / 12,
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

"""Balls fall on each other and come to rest; a block strikes a wall and sticks: rigid stops, friction, no stiffness."""

import sys
from math import pi, sqrt
from pathlib import Path

from matplotlib.figure import Figure

from runtime import simulate
from symgen.scene import Scene

GRAVITY, HEIGHT, GAP = 9.81, 1.0, 0.01  # m/s^2, m
HEAVY, LIGHT, RESTITUTION = 3.0, 1.0, 0.8  # kg
SPEED, WAY, RUB = 3.0, 1.0, 2.0  # m/s, m, N on 1 kg


def build():
    """A ball above the floor, another above the ball, each held away by a stop of the rail between them."""
    stop = {"lower": 0.0, "restitution": RESTITUTION}
    wall = {"upper": WAY, "restitution": RESTITUTION}
    return (
        Scene("stacked_balls", title="Balls that fall on each other")
        .gravity(0, -GRAVITY)
        .ground(markers={"up": {"position": (0, 0), "angle": pi / 2}})
        .rigid("heavy", mass=HEAVY, inertia=0.01)
        .rigid("light", mass=LIGHT, inertia=0.01)
        .rigid("block", mass=1.0, inertia=0.01)
        .prismatic("floor", "ground.up", "heavy.origin", limits=stop)
        .prismatic("between", "heavy.origin", "light.origin", limits=stop)
        .prismatic("table", "ground.origin", "block.origin", limits=wall, friction={"coulomb": RUB})
        .initial({"heavy.y": HEIGHT, "light.y": HEIGHT + GAP})
        .rates({"block.x": SPEED})
        .simulation(t_end=8.0, dt=0.01, scheme="rk4")
        .build()
    )


def closed_form() -> float:
    """How high the light ball is thrown: both fall, the heavy one turns back, they meet, and exchange momentum."""
    fall = sqrt(2 * GRAVITY * HEIGHT)
    later = GAP / (fall * (1 + RESTITUTION))  # s, at a rate that gravity leaves as it is
    up, down = RESTITUTION * fall - GRAVITY * later, fall + GRAVITY * later
    centre = (HEAVY * up - LIGHT * down) / (HEAVY + LIGHT)
    speed = centre + RESTITUTION * HEAVY / (HEAVY + LIGHT) * (up + down)
    met = GAP + HEIGHT - GRAVITY * (fall / GRAVITY + later) ** 2 / 2
    return met + speed**2 / (2 * GRAVITY)


def main(picture: Path | None = None) -> None:
    """How high the light ball is thrown and where the block sticks have closed forms; in the end all rest."""
    run = simulate(build().model())
    print(run.status)
    summit = run["light.y"][run.t > 0.5].max()
    print(f"thrown to {summit:.4f} m, closed form {closed_form():.4f} m")
    back = RESTITUTION**2 * (SPEED**2 - 2 * RUB * WAY) / (2 * RUB)
    print(f"the block sticks at {run['block.x'][-1]:.9f} m, closed form {WAY - back:.9f} m")
    rates = [abs(run[f"{name}_dot"][-1]) for name in ("heavy.y", "light.y", "block.x")]
    print(f"fastest in the end {max(rates):.1g} m/s, {sum(e.kind == 'impact' for e in run.events)} impacts")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        for name, label in (("light.y", "light ball"), ("heavy.y", "heavy ball"), ("block.x", "block, along its rail")):
            ax.plot(run.t, run[name], label=label)
        ax.legend(title="position [m] over time [s]")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

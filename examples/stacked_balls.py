"""Balls fall on each other and come to rest: rigid stops with a restitution, no stiffness."""

import sys
from math import pi, sqrt
from pathlib import Path

from matplotlib.figure import Figure

from runtime import simulate
from symgen.scene import Scene

GRAVITY, HEIGHT, GAP = 9.81, 1.0, 0.01  # m/s^2, m
HEAVY, LIGHT, RESTITUTION = 3.0, 1.0, 0.8  # kg


def build():
    """A ball above the floor, another above the ball, each held away by a stop of the rail between them."""
    stop = {"lower": 0.0, "restitution": RESTITUTION}
    return (
        Scene("stacked_balls", title="Balls that fall on each other")
        .gravity(0, -GRAVITY)
        .ground(markers={"up": {"position": (0, 0), "angle": pi / 2}})
        .rigid("heavy", mass=HEAVY, inertia=0.01)
        .rigid("light", mass=LIGHT, inertia=0.01)
        .prismatic("floor", "ground.up", "heavy.origin", limits=stop)
        .prismatic("between", "heavy.origin", "light.origin", limits=stop)
        .initial({"heavy.y": HEIGHT, "light.y": HEIGHT + GAP})
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
    """Compare how high the light ball is thrown with its closed form; in the end all rest."""
    run = simulate(build().model())
    print(run.status)
    summit = run["light.y"][run.t > 0.5].max()
    print(f"thrown to {summit:.4f} m, closed form {closed_form():.4f} m")
    rates = [abs(run[f"{name}_dot"][-1]) for name in ("heavy.y", "light.y")]
    print(f"fastest in the end {max(rates):.1g} m/s, {sum(e.kind == 'impact' for e in run.events)} impacts")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        for name, label in (("light.y", "light ball"), ("heavy.y", "heavy ball")):
            ax.plot(run.t, run[name], label=label)
        ax.legend(title="position [m] over time [s]")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

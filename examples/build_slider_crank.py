"""A flexible slider-crank in Python: build the scene, derive its model, simulate, look."""

import sys
from pathlib import Path

from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene


def build():
    """A crank driven by a torque, a rod with two bending modes, and a slider."""
    return (
        Scene("my_slider_crank", title="My flexible slider-crank")
        .gravity(0, -9.81)
        .parameter("torque", 5.0, "N m", "drive torque")
        .rigid("crank", mass=0.36, inertia=7e-4, center_of_mass=(0.075, 0), markers={"tip": {"position": (0.15, 0)}})
        .beam("rod", length=0.3, density=7870.0, area=6.4e-5, second_moment=3.4e-10, youngs_modulus=2e11,
              lateral={"ends": "pinned-pinned", "modes": 2}, stiffening=True, damping_ratio=0.01)
        .rigid("slider", mass=0.076, inertia=1e-5)
        .revolute("A", "ground.origin", "crank.origin")
        .revolute("B", "crank.tip", "rod.start")
        .prismatic("slide", "ground.origin", "slider.origin")
        .revolute("C", "rod.end", "slider.origin")
        .torque("motor", "crank.origin", "where(t < 0.1, torque, 0)")
        .measure("stroke", "x", of="slider.origin")
        .independent("crank.theta", "rod.q1", "rod.q2")
        .initial({"crank.theta": 0.5})
        .simulation(t_end=0.2, dt=2e-5, m=[1], scheme="single_rate", seen_every=0.0001)
        .build()
    )


def main(picture: Path | None = None) -> None:
    """The method and its steps are those of the scene."""
    model = build().model()
    solution = model.simulate()
    print(solution.status)
    for name in (*model.q_i, "stroke"):
        print(f"{name:12} {solution[name][-1]: .6e}")
    print(f"largest energy balance error {abs(solution.energy_balance()).max():.2e} J")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(solution, ax=left, instants=[0.03, 0.035, 0.04, 0.045, 0.05], traces=["crank.tip"])
        plots.coordinates(solution, ax=right, names=["rod.q1", "rod.q2"])
        right.set_title("modal coordinates of the rod")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

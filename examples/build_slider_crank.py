"""A flexible slider-crank in Python: build the scene, generate its code, load it, simulate, look.

    python examples/build_slider_crank.py [FOLDER]      with FOLDER: keep the code and leave pictures there
"""

import sys
import tempfile
from pathlib import Path

from runtime import load_model, plots, simulate
from symgen.generate import generate
from symgen.scene import SceneBuilder


def build():
    """A crank driven by a torque, a rod with two bending modes, and a slider."""
    return (
        SceneBuilder("my_slider_crank", title="My flexible slider-crank")
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
        .measure("stroke", "x", marker_b="slider.origin")
        .independent("crank.theta", "rod.q1", "rod.q2")
        .initial({"crank.theta": 0.5})
        .simulation(t_end=0.2, dt=2e-5, m=[1], scheme="single_rate", save_every=5)
        .build()
    )


def main(folder: Path) -> None:
    """Generate into the folder, simulate with the scene's own settings, print the end."""
    model = load_model(generate(build(), folder / "model"))
    solution = simulate(model)
    print(solution.status)
    for name in (*model.q_i, "stroke"):
        print(f"{name:12} {solution[name][-1]: .6e}")
    print(f"largest energy balance error {abs(solution.energy_balance()).max():.2e} J")
    plots.coordinates(solution, folder / "coordinates.png")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        main(Path(sys.argv[1]))
    else:
        with tempfile.TemporaryDirectory() as temporary:
            main(Path(temporary))

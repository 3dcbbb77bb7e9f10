"""The heights of a rod in three parts for the least peak deflection of a fast slider-crank at the same mass."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.optimize import minimize

from runtime import DifferentiableRun
from symgen import Scene

PARTS, HEIGHT, SPEED = ("heel", "middle", "toe"), 8.0, 150.0  # mm, rad/s
FROM_CHORD = 1e3 * np.array([[1, 0, -1 / 3], [0, 1, -2 / 3]])  # mm, of the welds from the line between the hinges


def build():
    """The published mechanism (case F1), its rod in three parts of 100 mm x 8 mm x height, its crank driven."""
    builder = Scene("fast_slider_crank").rigid("slider", mass=0.0756, inertia=1e-5).rigid(
        "crank", mass=0.36, inertia=7e-4, center_of_mass=(0.075, 0), markers={"tip": {"position": (0.15, 0)}})
    for k in PARTS:
        builder.parameter(f"{k}_height", HEIGHT * 1e-3, "m")
        builder.beam(k, length=0.1, density=7870.0, area=f"0.008 * {k}_height", damping_ratio=0.02, youngs_modulus=2e11,
                     second_moment=f"0.008 * {k}_height**3 / 12", lateral={"ends": "clamped-free", "modes": 1})
        builder.measure(f"{k}_y", "y", relative_to="heel.start", of=f"{k}.end")  # across the rod at the crank
    builder.revolute("A", "ground.origin", "crank.origin").prismatic("slide", "ground.origin", "slider.origin")
    builder.revolute("B", "crank.tip", "heel.start").weld("D", "heel.end", "middle.start")
    builder.weld("E", "middle.end", "toe.start").revolute("C", "toe.end", "slider.origin")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion=f"{SPEED} * t")
    builder.initial({f"{k}.theta": 0.0 for k in ("crank", *PARTS)}).rates({"crank.theta": SPEED})
    return builder.simulation(t_end=0.084, dt=4e-5, scheme="single_rate", seen_every=0.0004).build()


def main(picture: Path | None = None) -> None:
    """Minimises s with |deflection| <= s at every saved time, by SciPy and the derivatives of the run."""
    model = build().model()
    run = DifferentiableRun(model, [f"{k}_y" for k in PARTS], [f"{k}_height" for k in PARTS])

    def bend(x, outputs=run.values):
        """[mm] of both welds at all times, or with outputs = slopes its slopes; x: three heights and s [mm]."""
        return np.concatenate(np.einsum("ij,nj...->in...", FROM_CHORD, outputs(x[:3] * 1e-3)))

    def slopes(heights):
        return 1e-3 * run.jacobian(heights).derivatives  # per mm

    one = np.ones(4 * len(run.t))
    peak = {"type": "ineq", "fun": lambda x: x[3] - np.kron([1, -1], bend(x)),
            "jac": lambda x: np.column_stack([np.kron([[-1], [1]], bend(x, slopes)), one])}
    mass = {"type": "ineq", "fun": lambda x: [3 * HEIGHT - sum(x[:3])], "jac": lambda x: [[-1, -1, -1, 0]]}
    start = np.append(run.x0 * 1e3, 1.0)
    best = minimize(lambda x: x[3], start, jac=lambda x: np.eye(4)[3], bounds=[(4, 16)] * 3 + [(0, 9)], method="SLSQP",
                    constraints=[peak, mass])
    print(f"{best.message}\nuniform {HEIGHT} mm: peak {abs(bend(start)).max():.4f} mm")
    print(f"best {' '.join(f'{h:.2f}' for h in best.x[:3])} mm of the same mass: peak {best.x[3]:.4f} mm")
    if picture:
        figure = Figure(figsize=(10, 3.6), layout="constrained", dpi=120)
        for ax, name, x in zip(figure.subplots(1, 2, sharey=True), ("uniform", "best"), (start, best.x), strict=True):
            ax.plot(run.t, bend(x).reshape(2, -1).T, label=["heel and middle", "middle and toe"])
            ax.set(title=f"{name}: {abs(bend(x)).max():.3f} mm", xlabel="t [s]", ylabel="welds from the chord [mm]")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

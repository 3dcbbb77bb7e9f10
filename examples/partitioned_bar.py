"""Fig. 1 of the paper, Eqs. (3)-(14): a bar takes small steps where its mesh is fine and large ones elsewhere."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen import Scene

SIZES = np.array([0.05] * 12 + [0.0125] * 32)  # m: lengths of the elements from the wall on; together 1 m
PULSE, STEP, RATIO = 1.0, 0.04, 4  # s, s; stiffness and mass per length are 1, so waves travel at 1 m/s


def build():
    """Elements with lumped masses, held at the wall, pulled at the end by a force that comes and goes smoothly."""
    n, K = len(SIZES), np.zeros((len(SIZES) + 1,) * 2)
    for k, size in enumerate(SIZES):
        K[k:k + 2, k:k + 2] += np.array([[1, -1], [-1, 1]]) / size
    names = [f"u{k + 1}" for k in range(n)]
    return (
        Scene("partitioned_bar", title="Bar with coarse and fine elements")
        .structure(coordinates=names, mass=np.diag(np.convolve(SIZES, [0.5, 0.5])[1:]), stiffness=K[1:, 1:],
                   force=[0.0] * (n - 1) + [f"where(t < {PULSE}, sin(pi * t / {PULSE})**2, 0)"])
        .groups(coarse=names[:12], fine=names[12:])
        .simulation(t_end=1.6, dt=STEP, m=[RATIO], scheme="printed", seen_every=0.0)
        .build()
    )


def main(picture: Path | None = None) -> None:
    """The motion is d'Alembert's f(t - 1 + x) - f(t - 1 - x), f the impulse of the force, with its echo."""
    model = build().model()
    x, run = np.cumsum(SIZES), model.simulate()
    better, single = model.simulate(scheme="exponential"), model.simulate(scheme="single_rate")

    def f(s):
        s = np.clip(s, 0.0, PULSE)
        return s / 2 - PULSE * np.sin(2 * np.pi * s / PULSE) / (4 * np.pi)

    exact = f(run.t[:, None] - 1 + x) - f(run.t[:, None] - 1 - x)
    print(run.status)
    for name, found in (("printed", run), ("exponential", better)):
        print(f"{name}: off d'Alembert's solution by {np.abs(found.q - exact).max() / exact.max():.4f} of the largest")
    print(f"one step of {STEP} s for all: {single.status.name}")
    if picture:
        ax = (figure := Figure(figsize=(8, 4), layout="constrained", dpi=120)).subplots()
        for k in (12, 20, 25, 30, 35, 40):
            ax.plot(np.append(0, x), np.append(0, exact[k]), color="0.8", lw=4)
            ax.plot(np.append(0, x), np.append(0, better.q[k]), ".-", lw=0.8, ms=4, label=f"t = {run.t[k]:.2f} s")
        ax.set(xlabel="x [m]", ylabel="displacement [m]", title="steps of 0.04 s and 0.01 s; grey: d'Alembert")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""Figs. 2 to 4 of the paper: the frame that a beam deforms in, and how its slow and fast coordinates are coupled."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen.scenes import SCENES

ROOTS = np.array([1.875104, 4.694091, 7.854757])  # of a clamped beam: cos(b) cosh(b) = -1


def mass_matrix(model, run, sample: int) -> np.ndarray:
    """M_hat of Eq. (38) at a sample: first the group L (the hub's angle), then the group S (the beam's modes)."""
    values = {"t": run.t[sample], "c": model.evaluate("constants", p=run.parameters)["c"]}
    for key, names in (("q_i", model.q_i), ("q_d", model.q_d)):
        values[key] = [run[name][sample] for name in names]
        values[f"{key}_dot"] = [run.rate(name)[sample] for name in names]
    return np.asarray(model.evaluate("condensed", **values)["M_hat"])


def main(picture: Path | None = None) -> None:
    """The coupling M_LS = rho A L^2 / b^2 and the modal masses rho A L / 4 are those of the exact beam."""
    model = SCENES["hub_beam"]().model()
    run = model.simulate(t_end=2.0, parameters={"torque": 30.0})
    M, line, length = mass_matrix(model, run, 0), 2766.7 * 7.2968e-5, 8.0
    print(run.status)
    print(f"coupling M_LS {np.round(M[0, 1:], 4)}, exact {np.round(line * length**2 / ROOTS**2, 4)} kg m")
    print(f"modal masses M_SS {np.round(np.diag(M)[1:], 5)}, exact {line * length / 4:.5f} kg")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=[1.6])
        angle, frame = np.interp(1.6, run.t, run["beam.theta"]), {"arrowstyle": "<|-", "color": "0.2"}
        for axis, turn in (("x", 0.0), ("y", np.pi / 2)):
            end = 2.0 * np.array([np.cos(angle + turn), np.sin(angle + turn)])
            left.annotate(axis, xy=(0, 0), xytext=end, arrowprops=frame, fontsize=8)
        left.set_xlim(-1.5, 8.0)
        left.set_title("dashed: undeformed in the floating frame (R_o, theta)", loc="left", fontsize=9)
        scaled = M / np.sqrt(np.outer(np.diag(M), np.diag(M)))
        right.imshow(scaled, cmap="Blues", vmin=0, vmax=1)
        for row, column in np.ndindex(M.shape):
            right.text(column, row, f"{scaled[row, column]:.2f}", ha="center", va="center",
                       color="white" if scaled[row, column] > 0.5 else "black")
        right.axhline(0.5, color="#d55e00")
        right.axvline(0.5, color="#d55e00")
        right.set(xticks=range(4), yticks=range(4), xticklabels=model.q_i, yticklabels=model.q_i,
                  title="M_hat, scaled: groups L and S, coupled by inertia")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

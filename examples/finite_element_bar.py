"""From a mesh to a motion: a bar of solid finite elements is turned quickly, stops, and rings at its own frequency."""

import sys
from math import pi, sqrt
from pathlib import Path

import numpy as np
import skfem
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene
from symgen.fe import STEEL, FlexibleBody

LENGTH, WIDTH, HEIGHT, TURN = 0.5, 0.02, 0.006, 0.1  # m, m, m, s: duration of the turn


def bar() -> FlexibleBody:
    """Quadratic hexahedra, reduced to two modes with the root held."""
    mesh = skfem.MeshHex.init_tensor(np.linspace(0, LENGTH, 13), np.linspace(0, WIDTH, 2), np.linspace(0, HEIGHT, 2))
    ends = {"root": lambda places: places[:, 0] < 1e-9, "tip": lambda places: places[:, 0] > LENGTH - 1e-9}
    return FlexibleBody.from_mesh(mesh, STEEL, order=2, modes=2, mode_set="mixed", fixed=["root"], origin="root",
                                  interface=ends)


def build(body: FlexibleBody):
    """The bar on a motor about y, turned by a quarter of a turn; at its root a marker with the motor's axis."""
    fields, axis = body.fields(damping_ratio=0.002), {"axis": [0.0, 1.0, 0.0]}
    fields["markers"]["root"] |= axis
    builder = Scene("bar", space="spatial", title="Bar of finite elements")
    builder.ground(markers={"motor": axis}).flexible("bar", **fields).revolute("hinge", "ground.motor", "bar.root")
    builder.prescribed_angle("motor", "ground.motor", "bar.root", motion=(
        f"where(t < {TURN}, pi / 2 * (t / {TURN} - sin(2 * pi * t / {TURN}) / (2 * pi)), pi / 2)"))
    return builder.simulation(t_end=0.5, dt=2e-4, scheme="rk4").build()


def main(picture: Path | None = None) -> None:
    """It rings at the frequency of a clamped beam, 1.875^2 sqrt(E I / rho A L^4)."""
    body = bar()
    run = build(body).model().simulate()
    late, q = run.t > TURN, run["bar.q1"]
    up = np.flatnonzero(np.diff(np.sign(q[late])) > 0)
    measured = (len(up) - 1) / (run.t[late][up[-1]] - run.t[late][up[0]])
    beam = 1.8751**2 / (2 * pi) * sqrt(STEEL.E / STEEL.rho / 12) * HEIGHT / LENGTH**2
    print(run.status)
    print(f"{len(up)} periods at {measured:.2f} Hz, mesh {body.frequencies[0]:.2f} Hz, beam {beam:.2f} Hz")
    print(f"largest torque of the motor {np.abs(run.motor('motor')).max():.3f} N m")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=[0.0, 0.03, 0.05, 0.07, 0.1], traces=["bar.tip"])
        plots.coordinates(run, ax=right, names=["bar.q1"])
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""Modes that stresses of a finite-element body need, each way: `python -m benchmarks.pages.stress_modes`.

An arm of quadratic hexahedra on an axle, started from rest in 5 ms: von Mises stress at all points but those near the
two ends, from equilibrium (mode acceleration) and as the sum of modal stresses, against equilibrium with ten modes.
"""

from __future__ import annotations

import sys
import tempfile

import numpy as np
import skfem

from runtime import load_model, simulate
from runtime.contract.body_motion import BodyMotion
from symgen.fe import FlexibleBody, Material
from symgen.generate import generate
from symgen.scene import SceneBuilder

LENGTH, Y, Z, CELLS = 0.3, 0.010, 0.012, 16
ALUMINIUM = Material(E=7e10, nu=0.3, rho=2700.0)
COUNTS, REFERENCE = (1, 2, 3, 4, 6, 8), 10
ENDS = 0.1  # of the length, left out on either side
START = "40.0 * t ** 3 / 5e-3"  # rad, t in s


def main(arguments: list[str] | None = None) -> int:
    """Print the table in Markdown."""
    body, motion = arm(REFERENCE)
    inside = np.abs(body.stresses().points[:, 0] - LENGTH / 2) < (0.5 - ENDS) * LENGTH
    exact = body.equilibrium_stresses().von_mises(motion)[:, inside]
    print(
        f"Largest stress {exact.max():.3g} Pa.\n\n| modes | from equilibrium | sum of modal stresses |\n|---|---|---|"
    )
    for count in COUNTS:
        body, motion = arm(count)
        ways = body.equilibrium_stresses().von_mises(motion), body.stresses().von_mises(motion.q_f)
        off = [100 * np.abs(found[:, inside] - exact).max() / exact.max() for found in ways]
        print(f"| {count} | {off[0]:.2g} % | {off[1]:.2g} % |")
    return 0


def arm(count: int) -> tuple[FlexibleBody, BodyMotion]:
    """The body with so many modes, its root held, and its motion in 5 ms."""
    sides = [np.linspace(0.0, LENGTH, CELLS + 1), np.array([-Y / 2, Y / 2]), np.array([-Z / 2, Z / 2])]
    ends = {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > LENGTH - 1e-9}
    body = FlexibleBody.from_mesh(
        skfem.MeshHex.init_tensor(*sides), ALUMINIUM, interface=ends, modes=count, mode_set="mixed", fixed=["root"],
        origin="root",
    )  # fmt: skip
    builder = SceneBuilder("arm", space="spatial").flexible("arm", **body.fields())
    builder.revolute("axle", "ground.origin", "arm.root")
    builder.prescribed_angle("drive", "ground.origin", "arm.root", motion=START)
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(builder.build(), folder))
        run = simulate(model, scheme="radau", dt=1e-5, t_end=5e-3, save_every=25, start="quasi_static")
        return body, run.body_motion("arm")


if __name__ == "__main__":
    sys.exit(main())

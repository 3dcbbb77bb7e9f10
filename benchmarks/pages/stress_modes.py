"""Modes that stresses of a finite-element body need, each way: `python -m benchmarks.pages.stress_modes`.

An arm of quadratic hexahedra on an axle, started from rest in 5 ms: von Mises stress at all points but those near the
two ends, from equilibrium (mode acceleration) and as the sum of modal stresses, against equilibrium with ten modes.
Then the bending moment of an L-shaped crank of beam elements, started from rest in 10 ms, by the same two ways.
"""

from __future__ import annotations

import sys
import tempfile

import numpy as np
import skfem

from runtime import load_model, simulate
from runtime.contract.flexible import BodyMotion
from symgen.fe import STEEL, FlexibleBody, LineMesh, Material, Section
from symgen.generate import generate
from symgen.scene import Scene

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
    moments = {count: crank(count) for count in (*COUNTS, REFERENCE)}
    exact = moments[REFERENCE][0]
    print(f"\nLargest moment {np.abs(exact).max():.3g} N m.\n\n| modes | from equilibrium | sum |\n|---|---|---|")
    for count in COUNTS:
        off = [100 * np.abs(found - exact).max() / np.abs(exact).max() for found in moments[count]]
        print(f"| {count} | {off[0]:.2g} % | {off[1]:.2g} % |")
    return 0


def crank(count: int) -> tuple[np.ndarray, np.ndarray]:
    """Bending moments of the crank with so many modes, each way."""
    eighths = np.arange(9) / 8
    nodes = [*((0.4 * s, 0.0, 0.0) for s in eighths), *((0.4, 0.3 * s, 0.0) for s in eighths[1:])]
    section = Section.rectangle(0.02, 0.01, y_axis=(1.0, -1.0, 0.0))
    body = FlexibleBody.from_mesh(
        LineMesh(nodes, [(k, k + 1) for k in range(16)], section), STEEL, interface={"root": [0]}, modes=count,
        mode_set="mixed", fixed=["root"], origin="root",
    )  # fmt: skip
    motion, forces = started(body, "20.0 * t ** 3 / 1e-2", 1e-2), body.section_forces()
    return forces.of(motion).part("moment"), forces.of_modes(motion.q_f).part("moment")


def arm(count: int) -> tuple[FlexibleBody, BodyMotion]:
    """The body with so many modes, its root held, and its motion in 5 ms."""
    sides = [np.linspace(0.0, LENGTH, CELLS + 1), np.array([-Y / 2, Y / 2]), np.array([-Z / 2, Z / 2])]
    ends = {"root": lambda at: at[:, 0] < 1e-9, "tip": lambda at: at[:, 0] > LENGTH - 1e-9}
    body = FlexibleBody.from_mesh(
        skfem.MeshHex.init_tensor(*sides), ALUMINIUM, interface=ends, modes=count, mode_set="mixed", fixed=["root"],
        origin="root",
    )  # fmt: skip
    return body, started(body, START, 5e-3)


def started(body: FlexibleBody, angle: str, t_end: float) -> BodyMotion:
    """The motion of a body on an axle at its root, from rest."""
    builder = Scene("arm", space="spatial").flexible("arm", **body.fields())
    builder.revolute("axle", "ground.origin", "arm.root")
    builder.prescribed_angle("drive", "ground.origin", "arm.root", motion=angle)
    with tempfile.TemporaryDirectory() as folder:
        model = load_model(generate(builder.build(), folder))
        run = simulate(model, scheme="radau", dt=1e-5, t_end=t_end, seen_every=0.00025, start="quasi_static")
        return run.body_motion("arm")


if __name__ == "__main__":
    sys.exit(main())

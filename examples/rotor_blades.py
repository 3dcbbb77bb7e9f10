"""A rotor with two flexible blades: its Campbell diagram against the published frequencies of a turning beam."""

import sys
from math import sqrt
from pathlib import Path

import numpy as np

from runtime.views.plots import campbell_picture
from symgen import Scene

BLADE = {"length": 10.0, "density": 1200.0, "area": 1e-3, "second_moment": 5e-7, "youngs_modulus": 2.8e10}
UNIT = sqrt(2.8e10 * 5e-7 / (1200.0 * 1e-3 * 10.0**4))  # rad/s, sqrt(EI / (rho A L^4))
FLAP = {0.0: 3.5160, 2.0: 4.1373, 4.0: 5.5850, 6.0: 7.3604}  # Wright et al. 1982: speed, first frequency, both / UNIT


def build():
    """Two blades at a light hub, bending in the plane of rotation, with geometric stiffening."""
    builder = Scene("rotor", title="Rotor with two blades")
    builder.rigid("hub", mass=10.0, inertia=1.0, markers={"a": {"angle": 0.0}, "b": {"angle": "pi"}})
    for side in ("a", "b"):
        builder.beam(f"{side}", **BLADE, lateral={"ends": "clamped-free", "modes": 4}, stiffening=True)
        builder.weld(f"root_{side}", f"hub.{side}", f"{side}.start")
    return builder.revolute("axle", "ground.origin", "hub.origin").build()


def main(picture: Path | None = None) -> None:
    """Lead-lag and flap of a beam on an axle differ by the square of the speed: lag^2 = flap^2 - speed^2."""
    model = build().model()
    found = model.campbell("hub.omega", UNIT * np.linspace(0.0, 12.0, 13))
    print("speed    first lag frequency    published    (all over sqrt(EI / rho A L^4))")
    for speed, flap in FLAP.items():
        row = found.frequencies[round(speed)] / UNIT
        print(f"{speed:5.1f}    {np.min(row[row > 0.5]):19.4f}    {sqrt(flap**2 - speed**2):9.4f}")
    print(f"blades stretched straight: {model.equilibrium(rates={'hub.omega': 6 * UNIT})['a.q1']:.1e} m")
    if picture:
        campbell_picture(found, picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""A double-wishbone suspension with a damper by a table meets a bump: travel, camber, force of the tyre."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import plots
from symgen import Scene

MASSES = {"chassis": 350.0, "lower": 6.0, "upper": 4.0, "upright": 25.0}  # kg on this corner; the wheel on the upright
ARMS = {"lower": (0.3, 0.20, 0.70, 0.18), "upper": (0.35, 0.50, 0.66, 0.52)}  # m: y, z inside and outside
HUB, BUMP = (0.74, 0.30), "where(1.5 <= t < 1.7, 0.05 * sin(5 * pi * (t - 1.5))**2, 0)"  # m


def at(y, z, x=0.0):
    """A marker with its axis along the car."""
    return {"position": (x, y, z), "axis": (1, 0, 0)}


def build():
    """One corner of a car: two arms hinged to the body, an upright on two balls, a tie rod, a strut, a tyre."""
    builder = Scene("double_wishbone", space="spatial", title="Double wishbone").gravity(0, 0, -9.81)
    rail = {"rail": {"position": (0, 0.2, 0.35)}}
    wheel = {"type": "cylinder", "radius": 0.3, "length": 0.16, "axis": (0, 1, 0), "position": (0, 0.13, 0)}
    post = {"type": "box", "size": (0.04, 0.03, 0.35), "position": (0, -0.06, 0.05)}
    balls = {name: at(y - HUB[0], z - HUB[1]) for name, (_, _, y, z) in ARMS.items()}
    builder.ground(markers=rail).rigid("chassis", mass=MASSES["chassis"], inertia=[20, 20, 20], markers={
        **{name: at(*ends[:2]) for name, ends in ARMS.items()}, **rail,
        "strut": at(0.42, 0.68), "rack": at(0.32, 0.27, -0.12)})
    builder.rigid("upright", mass=MASSES["upright"], inertia=[0.5, 0.8, 0.5],
                  markers={**balls, "arm": at(-0.06, -0.04, -0.12)}, shape=[wheel, post])
    builder.prismatic("body", "ground.rail", "chassis.rail").initial({"upright.y": HUB[0], "upright.z": HUB[1]})
    for name, (y, z, out, up) in ARMS.items():
        builder.rigid(name, mass=MASSES[name], inertia=[0.1, 0.02, 0.1], center_of_mass=(0, 0.2, 0), markers={
            "hinge": at(0, 0), "front": at(0, 0, 0.15), "rear": at(0, 0, -0.15), "strut": at(0.25, 0),
            "ball": at(out - y, up - z)})
        builder.revolute(f"{name}_hinge", f"chassis.{name}", f"{name}.hinge")
        builder.spherical(f"{name}_ball", f"{name}.ball", f"upright.{name}")
    builder.distance("tie_rod", "chassis.rack", "upright.arm", length=0.36)
    builder.table("damper", x=[-0.6, -0.1, 0.0, 0.1, 0.6], y=[-4e3, -1e3, 0.0, 1.6e3, 7e3], outside="extend")
    builder.line("strut", "chassis.strut", "lower.strut", "60e3 * (length - 0.58) + table('damper', rate)")
    tyre = f"max(0, 2e5 * ({BUMP} + {HUB[1]} - hub) - 500 * hub_dot)"
    builder.measure("hub", "z", of="upright.origin").force("tyre", "upright.origin", 0, 0, tyre)
    return builder.simulation(t_end=2.5, dt=1e-3, scheme="rk4", seen_every=0.005).build()


def main(picture: Path | None = None) -> None:
    """At rest the force of the tyre is the weight; on the bump the wheel leans by its camber."""
    run = build().model().simulate()
    camber = -np.degrees(2 * (run["upright.e0"] * run["upright.e1"] + run["upright.e2"] * run["upright.e3"]))
    print(f"{run.status}, energy and work agree to {np.abs(run.energy_balance()).max():.1e} J")
    print(f"tyre at rest {2e5*(HUB[1] - run['hub'][run.t<1.5][-1]):.1f} N, weight {9.81 * sum(MASSES.values()):.1f} N")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4.5), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=[1.5, 1.6])
        right.plot(run.t, 1e3 * (run["hub"] - HUB[1]), label="wheel [mm]")
        right.plot(run.t, 1e3 * run["body.travel"], label="body [mm]")
        right.plot(run.t, camber, label="camber [deg]")
        right.set(xlabel="time [s]", title="a bump of 50 mm after settling")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""A two-link arm in space: a turning base, an elbow, and a flexible forearm that bends in both planes."""

import sys
from pathlib import Path

import numpy as np

from runtime import plots
from symgen.scene import Scene, SceneRecord


def arm() -> SceneRecord:
    """The base turns about the vertical, the elbow about a level axis; both motors are torques over time."""
    return (
        Scene("spatial_arm", space="spatial", title="Arm in space").gravity(0, 0, -9.81)
        .rigid("base", mass=8.0, inertia=[0.1, 0.1, 0.05], markers={
            "elbow": {"position": [0.2, 0, 0.5], "axis": [0, -1, 0]}})
        .beam("forearm", length=0.8, density=2700.0, area=6e-4, second_moment=2e-8, second_moment_z=3e-8,
              youngs_modulus=7e10, lateral={"ends": "clamped-free", "modes": 1},
              lateral_z={"ends": "clamped-free", "modes": 1}, stiffening=True, damping_ratio=0.005,
              markers={"elbow": {"at": 0.0, "axis": [0, -1, 0]}})
        .rigid("load", mass=0.5, inertia=[1e-3, 1e-3, 1e-3])
        .joint("revolute", "swivel", "ground.origin", "base.origin", damping=0.5)
        .joint("revolute", "elbow", "base.elbow", "forearm.elbow", damping=0.2)
        .joint("weld", "grip", "forearm.end", "load.origin")
        .torque("turn", "base.origin", "6 * sin(2 * pi * t)")
        .rotational_spring_damper("lift", "base.elbow", "forearm.elbow", stiffness=200.0, free_angle=0.4)
        .measure("height", "z", of="load.origin")
        .simulation(t_end=1.0, dt=1e-4, scheme="rk4", seen_every=0.0002)
        .build()
    )


def main(picture: Path | None = None) -> None:
    """It prints where the load ends and the error of the energy balance."""
    solution = arm().model().simulate()
    print(solution.status)
    print(f"base turned {solution['swivel.angle'][-1]:.4f} rad, elbow {solution['elbow.angle'][-1]:.4f} rad, "
          f"load at z = {solution['height'][-1]:.4f} m")
    print(f"largest deflections {np.abs(solution['forearm.q1']).max():.2e} m, "
          f"{np.abs(solution['forearm.q2']).max():.2e} m")
    print(f"energy balance within {np.abs(solution.energy_balance()).max():.1e} J")
    force, moment = np.split(solution.joint_force("elbow")[-1], 2)
    print(f"force in the elbow {np.round(force, 2)} N, moment {np.round(moment, 2)} N m")
    if picture:
        plots.snapshots(solution, picture, instants=[0.0, 0.15, 0.3, 0.45, 0.6], traces=["load.origin"])


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

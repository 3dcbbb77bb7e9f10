"""A pan-tilt head from a URDF file with seven faults: what is refused, what is assumed, and the robot made right."""

import sys
import tempfile
import warnings
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen.scene import SceneError
from symgen.urdf import read

MASS, REACH, MOMENTS = 1.2, 0.15, (0.004, 0.004, 0.02)  # kg, m, kg m^2: no body has 0.02 > 0.004 + 0.004
URDF = f"""

<?xml version="1.0"?>
<robot name="head"><link name="base"/><link name="cross"/>
<link name="camera">
  <inertial><origin xyz="0 0 {REACH}"/><mass value="{MASS}"/>
    <inertia ixx="{MOMENTS[0]}" iyy="{MOMENTS[1]}" izz="{MOMENTS[2]}" ixz="0" iyz="0"/></inertial>
  <inertial><mass value="99"/></inertial></link>
<link name="lens"><inertial><origin xyz="0 0 0.05"/><mass value="0.3"/></inertial></link>
<joint name="pan" type="revolute"><parent link="base"/><child link="cross"/><axis xyz="1 0 0"/>
  <limit lower="-2" upper="2" effort="8" velocity="3"/><dynamics damping="0.05" friction="0.02"/></joint>
<joint name="tilt" type="revolute"><parent link="cross"/><child link="camera"/><axis xyz="0 1 0"/>
  <limit lower="-1.2" upper="1.2" effort="8" velocity="3"/><dynamics damping="0.05"/></joint>
<joint name="focus" type="prismatic"><parent link="camera"/><child link="lens"/><origin xyz="0 0 {REACH}"/>
  <axis xyz="0 0 1"/><limit lower="0" upper="0.1" effort="5" velocity="1"/><mimic joint="tilt" multiplier="0"/></joint>
</robot>"""


def by_hand(x, y):
    """M at the angles x, y: diag((A + m l^2) cos^2 y + C sin^2 y, A + m l^2), m l^2 of camera and lens."""
    A, C = MOMENTS[0] + MASS * REACH**2 + 0.3 * (REACH + 0.05) ** 2, MOMENTS[2]
    return np.diag([A * np.cos(y) ** 2 + C * np.sin(y) ** 2, A])


def main(picture: Path | None = None) -> None:
    """Compare the mass matrix with that by hand, and what friction holds with what the file says."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "head.urdf"
        path.write_text(URDF)
        try:
            read(path)
        except SceneError as error:
            print(f"refused: {error}")
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            robot = read(path, inertia="as_given")
    print("taken, with", *robot.assumed, sep="\n  ")
    print("limits:", {name: (one.lower, one.upper, one.effort, one.velocity) for name, one in robot.limits.items()})
    model = robot.gravity(0.0, 0.0, 0.0).model()
    at = 0.3, 0.4
    print(f"mass matrix off by hand by {np.abs(model.mass_matrix(at) - by_hand(*at)).max():.1e} kg m^2")
    torque = {"tau_pan": lambda t: 0.3 * np.sin(4 * t), "tau_tilt": lambda t: 0.1 * np.cos(3 * t)}
    run = model.simulate(t_end=3.0, inputs=torque)
    print(f"{run.status}; pan turns back {sum('slides' in event.text for event in run.events)} times")
    if picture:
        figure = Figure(figsize=(7, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        for name in ("pan", "tilt"):
            ax.plot(run.t, np.degrees(run[f"{name}.angle"]), label=name)
        ax.set(xlabel="time [s]", ylabel="angle [deg]", title="seven faults later")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

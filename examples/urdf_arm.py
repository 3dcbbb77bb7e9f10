"""A robot arm from a URDF file: computed torque along a path, and what is left of it without the feed-forward."""

import sys
import tempfile
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from runtime import Sampled
from runtime.views import plots
from symgen.urdf import read

LINK = """<link name="{name}"><inertial><origin xyz="0 0 {c}"/><mass value="{m}"/>
  <inertia ixx="{J}" iyy="{J}" izz="0.01" ixy="0" ixz="0" iyz="0"/></inertial></link>"""
URDF = f"""<robot name="arm"><link name="base"/>{LINK.format(name="upper", c=0.2, m=3, J=0.05)}
{LINK.format(name="fore", c=0.15, m=2, J=0.02)}<link name="tool"/>
<joint name="shoulder" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 1 0"/>
  <limit lower="-3" upper="3" effort="90" velocity="5"/></joint>
<joint name="elbow" type="revolute"><parent link="upper"/><child link="fore"/><origin xyz="0 0 0.4"/>
  <axis xyz="0 1 0"/><limit lower="-3" upper="3" effort="40" velocity="5"/></joint>
<joint name="flange" type="fixed"><parent link="fore"/><child link="tool"/><origin xyz="0 0 0.3"/></joint></robot>"""
EVERY, TIME = 1e-3, 2.0  # s


def path(t):
    """Angles, rates and accelerations from (0.3, 0.4) to (1.5, 1.6) in TIME: a polynomial of order 5."""
    s, first, way = t / TIME, np.array([0.3, 0.4]), 1.2
    return (first + way * (10 * s**3 - 15 * s**4 + 6 * s**5), way * np.ones(2) * (30 * s**2 - 60 * s**3 + 30 * s**4)
            / TIME, way * np.ones(2) * (60 * s - 180 * s**2 + 120 * s**3) / TIME**2)


def controller(model, motor, forward):
    """Feedback of both joints for one motor every EVERY seconds, with or without inverse dynamics of the path."""
    def torque(t, x):
        q, v, a = path(min(t, TIME))
        ahead = model.inverse_dynamics(q, v, a)[motor] if forward else 0.0
        return float(ahead + 100 * (q[motor] - x[motor]) + 10 * (v[motor] - x[2 + motor]))

    return Sampled(torque, EVERY, ["shoulder.angle", "elbow.angle", "shoulder.angle_dot", "elbow.angle_dot"], memory=())


def main(picture: Path | None = None) -> None:
    """At rest the torques are those by hand: g (m1 c1 sin a + m2 (l sin a + c2 sin(a + b))) and g m2 c2 sin(a + b)."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "arm.urdf").write_text(URDF)
        model = read(Path(folder) / "arm.urdf", limits=False, effort=False).gravity(0, 0, -9.81).model()
    a, b = 0.3, 0.4
    elbow = -9.81 * 2 * 0.15 * np.sin(a + b)
    hand = [elbow - 9.81 * (3 * 0.2 + 2 * 0.4) * np.sin(a), elbow]
    print(f"held at rest off by hand by {np.abs(model.gravity([a, b]) - hand).max():.1e} N m")
    runs, how = {}, {"scheme": "rk4", "dt": EVERY, "t_end": TIME, "initial": {"shoulder.angle": a, "elbow.angle": b}}
    for name, forward in (("computed torque", True), ("feedback alone", False)):
        inputs = {f"tau_{joint}": controller(model, k, forward) for k, joint in enumerate(("shoulder", "elbow"))}
        runs[name] = run = model.simulate(inputs=inputs, **how)
        off = np.abs(run["shoulder.angle"] - np.array([path(t)[0][0] for t in run.t])).max()
        print(f"{name}: {run.status.name}, shoulder off its path by {np.degrees(off):.3f} deg")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(runs["computed torque"], ax=left, instants=np.linspace(0, TIME, 7))
        for name, run in runs.items():
            right.plot(run.t, np.degrees(run["shoulder.angle"]), label=name)
        right.set(xlabel="time [s]", ylabel="shoulder [deg]")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""Coupler and rocker of a fast four-bar, as thin as the peak stress over a range of speeds allows."""

import sys
from functools import cache
from pathlib import Path

import numpy as np
from scipy.optimize import minimize

from runtime.gradients import Largest
from symgen import Scene

WIDTH, BOUND, SPEEDS = 0.012, 40.0, (20.0, 30.0, 40.0, 50.0)  # m, MPa, rad/s
LINKS = {"coupler": 0.30, "rocker": 0.25}  # m
PER_MM = 7850.0 * WIDTH * np.array(list(LINKS.values())) * 1e-3  # kg per mm of height


def build():
    """A crank turns steadily; two steel links of 12 mm x height follow, with two modes each."""
    builder = Scene("fast_four_bar").parameter("omega", 30.0, "rad/s").ground(markers={"D": {"position": (0.30, 0)}})
    builder.rigid("crank", mass=0.8, inertia=4e-3, markers={"tip": {"position": (0.10, 0)}}).gravity(0, -9.81)
    for link, length in LINKS.items():
        builder.parameter(f"{link}_height", 0.006, "m").beam(
            link, length=length, density=7850.0, area=f"{WIDTH} * {link}_height", youngs_modulus=2.1e11,
            second_moment=f"{WIDTH} / 12 * {link}_height**3", damping_ratio=0.02, markers={"middle": {"at": 0.5}},
            lateral={"ends": "pinned-pinned", "modes": 2}).measure(f"{link}_M", "bending_moment", f"{link}.middle")
    builder.revolute("A", "ground.origin", "crank.origin").revolute("B", "crank.tip", "coupler.start")
    builder.revolute("C", "coupler.end", "rocker.end").revolute("D", "ground.D", "rocker.start")
    builder.prescribed_angle("drive", "ground.origin", "crank.origin", motion="omega * t")
    return builder.initial({"coupler.theta": 0.9, "rocker.theta": 1.9}).simulation(t_end=0.2, dt=1e-4).build()


def main(picture: Path | None = None) -> None:
    """Least mass by SciPy's SLSQP: stresses and their derivatives are those of the motions that repeat."""
    model = build().model()
    names = [f"{link}_height" for link in LINKS]

    def motion(heights, speed):
        given = dict(zip(names, 1e-3 * np.array(heights), strict=True))
        return model.periodic(speed="omega", parameters={"omega": speed, **given}, steps=200)

    @cache
    def peaks(*heights):
        """(links, speeds) [MPa], and (heights, links, speeds) their derivatives per mm; heights [mm]."""
        turns = [motion(heights, speed) for speed in SPEEDS]
        moments = [[turn.gradient(Largest(f"{link}_M"), names) for turn in turns] for link in LINKS]
        values = 6 / WIDTH / (h := np.array(heights)[:, None]) ** 2 * [[one.value for one in row] for row in moments]
        slopes = np.array([[1e-3 * one.derivatives for one in row] for row in moments]).transpose(2, 0, 1)
        return values, 6 / WIDTH / h**2 * slopes - 2 * np.eye(2)[:, :, None] * values / h

    rule = {"fun": lambda x: BOUND - peaks(*x)[0].ravel(), "jac": lambda x: -peaks(*x)[1].reshape(2, -1).T}
    best = minimize(lambda x: PER_MM @ x, [6, 6], jac=lambda x: PER_MM, constraints=[{"type": "ineq", **rule}])
    for name, x in (("start", np.array([6, 6])), ("best", best.x)):
        print(f"{name} {x.round(3)} mm, {PER_MM @ x:.4f} kg, peaks {peaks(*x)[0].max(axis=1).round(2)} MPa")
    turn = motion(best.x, SPEEDS[-1])
    run = model.simulate(**{**turn.setting, "t_end": 30 * turn.period}, seen_every=0.0)
    off = np.abs(run["coupler_M"][-200:]).max() / np.abs(turn.simulate(1, seen_every=0.0)["coupler_M"]).max() - 1
    print(f"{best.message}; the coupler's peak after 30 turns is off by {abs(off):.1e}")
    if picture:
        branch = model.periodic_over("omega", (20.0, 50.0), speed="omega", steps=200, parameters=turn.parameters)
        branch.picture("coupler_M", picture)



if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""A connecting rod with fillets, reduced from a mesh of solids: the stress in a fillet over the speed."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen import Scene
from symgen.fe import STEEL, FlexibleBody

LENGTH, WIDTH, SHANK, THICK, RADIUS = 0.3, 0.011, 0.007, 0.008, 0.012  # m; half widths
FLAT = 0.03  # m, of the wide ends
ARC = np.sqrt(RADIUS**2 - (RADIUS - WIDTH + SHANK) ** 2)  # m, along the rod
CRANK, SLIDER = 0.05, 0.4  # m, kg


def half_width(x):
    """Wide ends, a shank, and arcs between them that meet it smoothly [m]."""
    end = np.minimum(x, LENGTH - x) - FLAT
    arc = RADIUS - np.sqrt(np.maximum(RADIUS**2 - np.clip(ARC - end, 0.0, ARC) ** 2, 0.0))
    return np.where(end < 0, WIDTH, np.where(end > ARC, SHANK, SHANK + arc))


def rod():
    """Quadratic hexahedra with curved edges, fine along the arcs; four modes of the free body, gauges in a fillet."""
    import skfem

    end = np.concatenate([np.linspace(0, FLAT, 4), FLAT + ARC * np.linspace(0, 1, 7)[1:]])
    along = np.concatenate([end, np.linspace(end[-1], LENGTH - end[-1], 13)[1:-1], LENGTH - end[::-1]])
    cube = skfem.MeshHex2.from_mesh(skfem.MeshHex.init_tensor(along, np.linspace(-1, 1, 5), np.linspace(0, THICK, 3)))
    places = cube.doflocs.copy()
    places[1] *= half_width(places[0])
    return FlexibleBody.from_mesh(
        skfem.MeshHex2(places, cube.t), STEEL, modes=4, mode_set="free", origin="big_end",
        interface={"big_end": lambda at: at[:, 0] < 1e-9, "small_end": lambda at: at[:, 0] > LENGTH - 1e-9})


def build(body):
    """A slider-crank, driven at the speed omega."""
    fillet = {name: (FLAT + ARC, side * SHANK, THICK / 2) for name, side in (("upper", 1), ("lower", -1))}
    scene = Scene("rod_over_speed", space="spatial").parameter("omega", 100.0, "rad/s")
    scene.rigid("crank", mass=0.6, inertia=[6e-4, 6e-4, 6e-4], markers={"pin": {"position": [CRANK, 0, 0]}})
    scene.flexible("rod", **body.fields(damping_ratio=0.01, gauges=fillet))
    along = {"axis": [1, 0, 0], "x_axis": [0, 1, 0]}
    scene.rigid("slider", mass=SLIDER, inertia=[2e-4, 2e-4, 2e-4], markers={"guide": along})
    scene.ground(markers={"guide": along}).revolute("axle", "ground.origin", "crank.origin")
    scene.prescribed_angle("drive", "ground.origin", "crank.origin", "omega*t")
    scene.prismatic("guide", "ground.guide", "slider.guide").spherical("wrist", "slider.origin", "rod.small_end")
    scene.revolute("pin", "crank.pin", "rod.big_end").initial({"guide.travel": CRANK + LENGTH})
    return scene.simulation(t_end=0.1, dt=1e-4, scheme="exponential").build()


def peak(model, speed):
    """Largest stress along the rod in the fillet over a turn of the motion that repeats [MPa], and the motion."""
    motion = model.periodic(speed="omega", parameters={"omega": speed}, steps=max(200, round(6e4 / speed)))
    return np.abs(motion.solution.stresses("rod").at("upper")[:, 0]).max() / 1e6, motion


def main(picture: Path | None = None, speeds: int = 9) -> None:
    """Slow, the stress grows by the square of the speed; fast, the rod's vibration adds to it."""
    body = rod()
    print(f"{3 * body.structure.positions.shape[0]} degrees of freedom become {body.nf}: "
          f"{', '.join(f'{one:.0f}' for one in body.frequencies)} Hz")
    model = build(body).model()
    (first, _), (second, _) = peak(model, 20.0), peak(model, 40.0)
    print(f"slow: {first:.4f} MPa at 20 rad/s, {second:.4f} at 40: {second / first:.4f} times")
    over = np.linspace(100, 500, speeds)
    found = [peak(model, speed) for speed in over]
    law = first * (over / 20.0) ** 2
    for speed, (value, _), slow in zip(over, found, law, strict=True):
        print(f"{speed:.0f} rad/s: {value:.1f} MPa, {value / slow:.3f} of the square law")
    if picture:
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        left, right = figure.subplots(1, 2)
        run = found[-1][1].solution
        left.plot(360 * (run.t - run.t[0]) / (run.t[-1] - run.t[0]), run.stresses("rod").at("upper")[:, 0] / 1e6)
        left.set(xlabel="crank [deg]", ylabel=f"stress in the fillet at {over[-1]:.0f} rad/s [MPa]")
        right.plot(over, [value for value, _ in found], "o-", label="motion that repeats")
        right.plot(over, law, "--", label="square of the speed")
        right.set(xlabel="speed [rad/s]", ylabel="largest stress in the fillet [MPa]")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

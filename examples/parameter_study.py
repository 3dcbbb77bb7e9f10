"""Young's modulus swept at run time: the code of the built-in torque-driven slider-crank is loaded once.

Every physical number of a scene is an entry of p. Only its zeros are baked into the code.
"""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen.scenes import SCENES


def main(picture: Path | None = None, t_end: float = 0.15) -> None:
    """Largest first-mode deflection of the rod for five values of E."""
    model = SCENES["flexible_slider_crank_torque"]().model()
    names = [entry.name for entry in model.parameters if entry.kind != "data"]
    print(f"{len(model.parameters)} parameters, among them {', '.join(names[:6])}, ...")
    print("E [GPa]    largest |q1| [mm]    status")
    ax = (figure := Figure(figsize=(8, 3.5), layout="constrained", dpi=120)).subplots()
    for modulus in (70e9, 110e9, 150e9, 200e9, 400e9):
        run = model.simulate(t_end=t_end, dt=5e-5, scheme="single_rate", seen_every=0.0,
                       parameters={"rod.youngs_modulus": modulus, "motor_torque": 2.0})
        print(f"{modulus / 1e9:7.0f}    {1e3 * np.abs(run['rod.q1']).max():17.4f}    {run.status.name}")
        ax.plot(run.t, 1e3 * run["rod.q1"], label=f"{modulus / 1e9:.0f} GPa")
    if picture:
        ax.set(xlabel="time [s]", ylabel="deflection of the rod [mm]", title="one model, five values of E")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

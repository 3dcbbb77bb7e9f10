"""A pole balanced on a cart: linearise the model where it stands, design a controller, close the loop in time."""

import sys
from math import sqrt
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.linalg import solve_continuous_are

from runtime import plots
from symgen import Scene

CART, POLE, LENGTH, GRAVITY = 1.0, 0.1, 0.5, 9.81  # kg, kg at the tip, m, m/s^2
LAW = "push - k1 * x - k2 * angle - k3 * x_dot - k4 * angle_dot"


def build():
    """A cart on a rail, a massless pole with a weight, and a force on the cart that is linear in the state."""
    builder = Scene("cart_pole", title="Pole on a cart").gravity(0, -GRAVITY).parameter("push", 0.0, "N")
    for name in ("k1", "k2", "k3", "k4"):
        builder.parameter(name, 0.0)
    builder.rigid("cart", mass=CART, inertia=1.0).prismatic("rail", "ground.origin", "cart.origin")
    builder.rigid("pole", mass=POLE, inertia=0.0, center_of_mass=(0, LENGTH),
                  markers={"tip": {"position": (0, LENGTH)}})
    builder.revolute("hinge", "cart.origin", "pole.origin").force("motor", "cart.origin", LAW, 0)
    builder.measure("x", "x", of="cart.origin").measure("angle", "angle", of="pole.origin")
    return builder.independent("cart.x", "pole.theta").simulation(t_end=5.0, dt=2e-3, scheme="rk4").build()


def main(picture: Path | None = None) -> None:
    """The unstable root is that of the closed form; after five seconds the pole stands."""
    model = build().model()
    system = model.linearise({"pole.theta": 0.0}, inputs=["push"])
    A, B = system.A_state, system.B_state
    gains = (B.T @ solve_continuous_are(A, B, np.diag([10.0, 10.0, 1.0, 1.0]), np.eye(1))).ravel()
    law = {f"k{k + 1}": gain for k, gain in enumerate(gains)}
    run = model.simulate(parameters=law, initial={"pole.theta": 0.3})
    print(run.status)
    print(f"unstable root {np.linalg.eigvals(A).real.max():.6f} per second, closed form "
          f"{sqrt((CART + POLE) * GRAVITY / CART / LENGTH):.6f}")
    print(f"closed loop {np.sort(np.linalg.eigvals(A - B @ gains[None]).real).round(3)} 1/s")
    print(f"after 5 s: cart at {run['cart.x'][-1]:.1e} m, pole at {run['pole.theta'][-1]:.1e} rad")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        plots.snapshots(run, ax=left, instants=[0.0, 0.2, 0.4, 0.8, 5.0], traces=["pole.tip"])
        right.plot(run.t, run["cart.x"], label="cart [m]")
        right.plot(run.t, run["pole.theta"], label="pole [rad]")
        right.set(xlabel="time [s]", title="let go at 0.3 rad")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""A crane carries its load by 2 m and lets it rest: do-mpc predicts by `model.ode()`. Needs the extra `mpc`."""

import sys
from pathlib import Path

import casadi as ca
import numpy as np
from do_mpc.controller import MPC
from do_mpc.model import Model
from matplotlib.figure import Figure

from symgen import Scene
from symgen.generate import model_of

GOAL, STEP, AHEAD, MOST, STEPS = 2.0, 0.1, 20, 8.0, 70  # m, s, steps that are predicted, N, steps


def build():
    """A trolley of 2 kg on a rail, pushed by the input, and a load of 1 kg on a rope of 1 m."""
    builder = Scene("crane").input("push", 0.0, "N", "on the trolley").gravity(0, -9.81)
    builder.rigid("trolley", mass=2.0, inertia=0.1).rigid("load", mass=1.0, inertia=0.0, center_of_mass=(0, -1.0))
    builder.prismatic("rail", "ground.origin", "trolley.origin", damping=0.5)
    builder.revolute("hook", "trolley.origin", "load.origin").force("motor", "trolley.origin", "push", 0.0)
    return builder.simulation(t_end=5.0, dt=1e-3, scheme="rk4").build()


def controller(ode):
    """do-mpc on x' = f(x, u, p, t): orthogonal collocation, IPOPT, the way to the goal and the swing as cost."""
    model = Model("continuous", "SX")
    x = ca.vertcat(*(model.set_variable("_x", name.replace(".", "_")) for name in ode.x))
    u = model.set_variable("_u", "push")
    for k, name in enumerate(ode.x):
        model.set_rhs(name.replace(".", "_"), ode.f(x, u, ode.p0, 0.0)[k])
    model.setup()
    cost = sum((model.x[name.replace(".", "_")] - GOAL * (name == "trolley.x")) ** 2 for name in ode.x)
    mpc = MPC(model)
    quiet = {"ipopt.print_level": 0, "ipopt.sb": "yes", "print_time": 0}
    mpc.set_param(n_horizon=AHEAD, t_step=STEP, store_full_solution=False, nlpsol_opts=quiet)
    mpc.set_objective(mterm=10 * cost, lterm=cost)
    mpc.set_rterm(push=1e-3)
    mpc.bounds["lower", "_u", "push"], mpc.bounds["upper", "_u", "push"] = -MOST, MOST
    mpc.setup()
    return mpc


def main(picture: Path | None = None) -> None:
    """Every 0.1 s the controller sees the state of the plant, and the plant gets the force."""
    model = model_of(build())
    ode, plant = model.ode(), model.stepper()
    mpc, state, seen, pushes = controller(ode), plant.reader(ode.x), [], []
    mpc.x0 = state()
    mpc.set_initial_guess()
    for _ in range(STEPS):
        seen.append(state().copy())
        pushes.append(float(mpc.make_step(state()[:, None])[0, 0]))
        plant.step({"push": pushes[-1]}, round(STEP / plant.dt))
    end = dict(zip(ode.x, state(), strict=True))
    print(f"after {STEPS * STEP:g} s: trolley at {end['trolley.x']:.4f} m, load at {end['load.theta']:.4f} rad, "
          f"largest force {max(map(abs, pushes)):.4f} N")
    if picture:
        figure = Figure(figsize=(8, 4), layout="constrained", dpi=120)
        ax = figure.subplots()
        ax.plot(STEP * np.arange(STEPS), np.array(seen)[:, :2], label=["trolley [m]", "load [rad]"])
        ax.step(STEP * np.arange(STEPS), np.array(pushes) / MOST, where="post", label=f"push [{MOST:g} N]")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

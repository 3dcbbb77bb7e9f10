"""A motor holds a speed: a PI controller inside the scene, as equations, and outside it, as a function of Python."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure
from scipy.linalg import expm

from runtime import Sampled
from symgen import Scene

J, FRICTION, WANTED, PERIOD = 0.02, 0.01, 30.0, 0.1  # kg m^2, N m s, rad/s, s between two samples
W, Z = 5.0, 0.6  # the frequency [rad/s] and damping ratio that the loop shall have
KP, KI = 2 * Z * W * J - FRICTION, J * W**2


def build(torque):
    """A rotor with friction, the speed that is wanted as an input, the integral of the error as a state."""
    builder = Scene("speed_loop").input("wanted", WANTED, "rad/s").input("command", 0.0, "N m")
    builder.rigid("rotor", mass=1.0, inertia=J).revolute("axle", "ground.origin", "rotor.origin", damping=FRICTION)
    builder.measure("angle", "angle", "rotor.origin").state("total", "wanted - angle_dot", unit="rad")
    return builder.torque("motor", "rotor.origin", torque).simulation(t_end=2.0, dt=1e-3, scheme="rk4").build()


def sampled_law():
    """The same law for a computer that looks every PERIOD and sums up what it saw."""

    def control(t, seen, total):
        total[0] += PERIOD * (WANTED - seen[0])
        return KP * (WANTED - seen[0]) + KI * total[0]

    return Sampled(control, every=PERIOD, reads=["rotor.theta_dot"], memory=[0.0])


def main(picture: Path | None = None) -> None:
    """The loop is as designed, and the sampled one follows its difference equation."""
    inside = build(f"{KP} * (wanted - angle_dot) + {KI} * total").model()
    outside = build("command").model()
    loop, run = inside.modes({"total": 0.0}), inside.simulate()
    held = outside.simulate(inputs={"command": sampled_law()})
    A = np.array([[-(FRICTION + KP) / J, KI / J], [-1.0, 0.0]])
    rest = np.array([WANTED, FRICTION * WANTED / KI])
    exact = [(rest - expm(A * t) @ rest)[0] for t in run.t[::100]]
    speed, total, steps, decay = 0.0, 0.0, [], np.exp(-FRICTION / J * PERIOD)
    for _ in range(21):
        steps.append(speed)
        total += PERIOD * (WANTED - speed)
        speed = decay * speed + (1 - decay) / FRICTION * (KP * (WANTED - speed) + KI * total)
    print(f"{run.status}\nloop {loop.frequencies[-1]:.9f} rad/s, damped {loop.damping_ratios[-1]:.9f}; wanted {W}, {Z}")
    print(f"inside off the closed form by {np.abs(run['rotor.theta_dot'][::100] - exact).max():.1e} rad/s")
    print(f"outside off the difference equation by {np.abs(held['rotor.theta_dot'][::100] - steps).max():.1e} rad/s")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        left.plot(run.t, run["rotor.theta_dot"], label="in the scene")
        left.plot(held.t, held["rotor.theta_dot"], label=f"sampled every {PERIOD} s")
        left.set(xlabel="time [s]", ylabel="speed [rad/s]")
        left.legend(frameon=False)
        right.plot(held.t, held["command"], color="C1")
        right.set(xlabel="time [s]", ylabel="torque, sampled [N m]")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

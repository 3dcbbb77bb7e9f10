"""What a robot carries, and the friction in its joints, from a log of commanded torques and noisy encoders."""

import sys
from pathlib import Path

import numpy as np
from matplotlib.figure import Figure

from symgen import Scene

TRUTH = {"payload": 1.7, "reach": 0.06, "F1": 2.5, "F2": 0.8, "viscous1": 0.9, "viscous2": 0.3}
GUESS = {"payload": 1.0, "reach": 0.0, "F1": 1.0, "F2": 0.4, "viscous1": 0.5, "viscous2": 0.5}
EVERY, TIME = 0.02, 2.0  # s
NOISE = {"shoulder_angle": 2e-4, "elbow_angle": 2e-4}  # rad


def build():
    """Two links in a level plane with a payload; motors told a torque every EVERY seconds, friction in both joints."""
    scene = Scene("carrying_arm")
    for name, value in GUESS.items():
        scene.parameter(name, value)
    for k, (length, mass) in enumerate(((0.5, 4.0), (0.4, 2.5)), start=1):
        scene.rigid(f"link{k}", mass=mass, inertia=mass * length**2 / 12, center_of_mass=(length / 2, 0.0),
                    markers={"tip": {"position": [length, 0.0]}}).input(f"tau{k}", 0.0, "N m")
    scene.rigid("load", mass="payload", inertia="0.01*payload", center_of_mass=("reach", 0.0))
    for k, (name, marker) in enumerate((("shoulder", "ground.origin"), ("elbow", "link1.tip")), start=1):
        scene.revolute(name, marker, f"link{k}.origin", friction={"coulomb": f"F{k}", "viscous": f"viscous{k}"})
        scene.effort(f"motor{k}", f"{name}.angle", f"tau{k}")
    scene.weld("grip", "link2.tip", "load.origin")
    scene.measure("shoulder_angle", "expression", "link1.theta", unit="rad")
    scene.measure("elbow_angle", "expression", "link2.theta - link1.theta", unit="rad")
    scene.initial({"link2.theta": 0.8})
    return scene.simulation(t_end=TIME, dt=EVERY / 2, scheme="rk4", seen_every=EVERY).build()


def commanded():
    """Torques by samples (times, values) that shake both joints."""
    t = EVERY * np.arange(round(TIME / EVERY))
    return {"tau1": (t, 9 * np.sin(5 * t) + 3 * np.sin(13 * t)), "tau2": (t, 3 * np.sin(7 * t + 1))}


def main(picture: Path | None = None) -> None:
    """Compare with the truth, which the 95 % region holds; joints turn back and stick on the way."""
    model = build().model()
    torques = commanded()
    log = model.simulate(inputs=torques, parameters=TRUTH)
    modes = [event.text for event in log.events if event.kind == "mode"]
    print(f"the log: {len(log.t)} samples, friction changes its mode {len(modes)} times, "
          f"{sum('sticks' in text for text in modes)} of these stick")
    noise = np.random.default_rng(1)
    data = {"t": log.t} | {name: log[name] + noise.normal(0.0, NOISE[name], len(log.t)) for name in NOISE}
    found = model.fit(data, list(TRUTH), guess=GUESS, deviation=NOISE, inputs=torques,
                      bounds={name: (-0.3 if name == "reach" else 0.0, 10.0) for name in TRUTH})
    for name, value in TRUTH.items():
        low, high = found.interval(name)
        print(f"{name}: 95 % from {low:.5g} to {high:.5g}, truth {value:g}")
    inside = found.contains(TRUTH)
    print(f"{found.evaluations} runs; the truth lies {'in' if inside else 'outside of'} the 95 % region of all")
    if picture:
        guessed = model.simulate(inputs=torques)
        figure = Figure(figsize=(10, 4), layout="constrained", dpi=120)
        for ax, name in zip(figure.subplots(1, 2), NOISE, strict=True):
            ax.plot(log.t, data[name], ".", ms=2, color="0.6", label="log")
            ax.plot(guessed.t, guessed[name], "--", label="before")
            ax.plot(found.t, found.fitted[name], label="identified")
            ax.set(xlabel="time [s]", ylabel=f"{name.replace('_', ' ')} [rad]")
        ax.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

"""A pendulum that its motor cannot lift learns to swing up: Gymnasium environments on a stepper and on lanes.

Needs the extra `gym`.
"""

import sys
from pathlib import Path

import gymnasium as gym
import numpy as np
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode, VectorEnv
from matplotlib.figure import Figure

from symgen import Scene

LIMIT, HELD, END = 2.0, 10, 6.0  # N m; steps of an action; s of an episode (the weight asks for 4.9 N m)
ACTIONS = gym.spaces.Box(-1.0, 1.0, (1,), np.float64)  # of LIMIT
MOST = np.array([1.0, 1.0, 50.0])
SEEN = gym.spaces.Box(-MOST, MOST, (3,), np.float64)  # cos, sin of the angle, rate [rad/s]


def build():
    """A weight of 1 kg on a rod of 0.5 m, and a motor in its hinge."""
    scene = Scene("swing_up", title="Pendulum to be swung up").input("torque", 0.0, "N m", "of the motor")
    scene.gravity(0, -9.81).rigid("rod", mass=1.0, inertia=0.0, center_of_mass=(0.5, 0.0))
    scene.revolute("hinge", "ground.origin", "rod.origin").torque("motor", "rod.origin", "torque")
    return scene.simulation(dt=2e-3, scheme="rk4").build()


def seen(state):
    """What an agent sees of (..., 2) angle and rate."""
    return np.stack([np.cos(state[..., 0]), np.sin(state[..., 0]), state[..., 1]], axis=-1)


class SwingUp(gym.Env):
    """One pendulum, on a stepper; its reward is its height less the effort."""

    action_space, observation_space = ACTIONS, SEEN

    def __init__(self, model):
        self.stepper = model.stepper()
        self.read = self.stepper.reader(["rod.theta", "rod.theta_dot"])

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        self.stepper.reset({"rod.theta": -np.pi / 2 + self.np_random.uniform(-0.1, 0.1)})
        return seen(self.read()), {}

    def step(self, action):
        effort = float(np.clip(action[0], -1.0, 1.0))
        self.stepper.step({"torque": LIMIT * effort}, HELD)
        state = seen(self.read())
        return state, float(state[1]) - 0.04 * effort**2, False, self.stepper.time >= END - 1e-9, {}


class SwingUps(VectorEnv):
    """Many of them, side by side on lanes; one that is over begins anew at the next step."""

    metadata = {"autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(self, model, cases):
        self.num_envs, self.single_action_space, self.single_observation_space = cases, ACTIONS, SEEN
        self.action_space = gym.vector.utils.batch_space(ACTIONS, cases)
        self.observation_space = gym.vector.utils.batch_space(SEEN, cases)
        self.lanes = model.lanes(cases, outputs=["rod.theta", "rod.theta_dot"])

    def begin(self, which):
        shifts = self.np_random.uniform(-0.1, 0.1, np.count_nonzero(which))
        return self.lanes.reset({"rod.theta": -np.pi / 2 + shifts}, which)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        return seen(self.begin(np.ones(self.num_envs, dtype=bool))), {}

    def step(self, actions):
        over = self.lanes.time >= END - 1e-9
        effort = np.clip(np.asarray(actions)[:, 0], -1.0, 1.0)
        state = seen(self.lanes.step({"torque": LIMIT * effort}, HELD))
        rewards = state[:, 1] - 0.04 * effort**2
        if over.any():
            state, rewards = seen(self.begin(over)), np.where(over, 0.0, rewards)
        never = np.zeros(self.num_envs, dtype=bool)
        return state, rewards, never, self.lanes.time >= END - 1e-9, {}


def policy(weights, state):
    """Pump energy while there is too little; hold the rod near the top. weights (..., 3), state (..., 3)."""
    across, height, rate = np.moveaxis(state, -1, 0)
    pump, spring, damper = np.moveaxis(weights, -1, 0)
    lack = 1 - (rate**2 / 8 / 9.81 + height / 2 + 0.5)  # of the energy at rest at the top, over its range
    top = 1 / (1 + np.exp(-30 * (height - 0.9)))
    return np.tanh((1 - top) * pump * rate * lack + top * (spring * across - damper * rate))[..., None]


def main(picture: Path | None = None, cases: int = 256, rounds: int = 12) -> None:
    """The cross-entropy method: all policies of a round swing at once. The best one stands at the end of an episode."""
    model = build().model()
    check_env(SwingUp(model), skip_render_check=True)
    worlds, rng = SwingUps(model, cases), np.random.default_rng(1)
    middle, spread = np.zeros(3), np.array([2.0, 5.0, 2.0])
    for k in range(rounds):
        weights, total = middle + spread * rng.normal(size=(cases, 3)), np.zeros(cases)
        state, _ = worlds.reset(seed=k)
        for _ in range(round(END / HELD / 2e-3)):
            state, rewards, *_ = worlds.step(policy(weights, state))
            total += rewards
        best = weights[np.argsort(total)[-cases // 8 :]]
        middle, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    world, states = SwingUp(model), []
    state, over = world.reset(seed=0)[0], False
    while not over:
        state, _, _, over, _ = world.step(policy(middle, state))
        states.append(state)
    heights = np.array(states)[:, 1]
    print(f"{rounds} rounds of {cases} policies; weights {middle.round(2)}")
    least = heights[-50:].min()
    print(f"height of the best at the end {heights[-1]:.4f} of 1, in the last second never below {least:.4f}")
    if picture:
        figure = Figure(figsize=(7, 3.2), layout="constrained", dpi=120)
        axes = figure.subplots()
        axes.plot(np.arange(1, len(heights) + 1) * HELD * 2e-3, heights)
        axes.set(xlabel="time [s]", ylabel="height over length [1]", title="2 N m, where 4.9 N m would lift it")
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

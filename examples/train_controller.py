"""A small network learns to balance a pole on a cart: JAX differentiates through the run. Needs the extra `jax`."""

import sys
from pathlib import Path

import jax
import jax.numpy as jnp
import numpy as np
from matplotlib.figure import Figure
from scipy.linalg import solve_continuous_are

from runtime import DifferentiableRun, as_jax
from symgen import Scene

UNITS, STATES = 3, ("x", "angle", "x_dot", "angle_dot")  # hidden units; what the network sees
WEIGHTS = jnp.array([10.0, 10.0, 1.0, 1.0])  # of the states in the cost, whose weight of the force is 1
STARTS = [{"pole.theta": 0.1}, {"cart.x": 0.2}, {"pole.theta": 0.05, "cart.x": -0.1}]  # rad, m


def build():
    """A cart of 1 kg with a pole of 0.1 kg and 0.5 m; a force that is a network of the measured state."""
    names = [[f"w{k}_{state}" for state in STATES] for k in range(UNITS)]
    units = [" + ".join(f"{w} * {state}" for w, state in zip(row, STATES, strict=True)) for row in names]
    law = [f"v{k} * tanh({unit})" for k, unit in enumerate(units)]
    builder = Scene("balanced", title="Network that balances a pole").gravity(0, -9.81).parameter("push", 0.0, "N")
    for name in [*sum(names, []), *(f"v{k}" for k in range(UNITS))]:
        builder.parameter(name, 0.1)
    builder.rigid("cart", mass=1.0, inertia=1.0).prismatic("rail", "ground.origin", "cart.origin")
    builder.rigid("pole", mass=0.1, inertia=0.0, center_of_mass=(0, 0.5), markers={"tip": {"position": (0, 0.5)}})
    builder.revolute("hinge", "cart.origin", "pole.origin")
    builder.force("motor", "cart.origin", " + ".join(["push", *law]), 0)
    builder.measure("x", "x", of="cart.origin").measure("angle", "angle", of="pole.origin")
    return builder.independent("cart.x", "pole.theta").simulation(t_end=5.0, dt=0.02, scheme="rk4").build()


def network(weights, state):
    """The same force in JAX, for the cost: states (..., 4) -> (...)."""
    hidden, out = weights[:-UNITS].reshape(UNITS, 4), weights[-UNITS:]
    return jnp.tanh(state @ hidden.T) @ out


def main(picture: Path | None = None, rounds: int = 160) -> None:
    """No controller costs less than x P x with P of the Riccati equation: the network comes within 3 % of it."""
    jax.config.update("jax_enable_x64", True)
    model = build().model()
    by = [p.name for p in model.parameters if p.name[0] in "wv"] + ["cart.x", "pole.theta"]
    run = DifferentiableRun(model, STATES, by, samples=250)
    f, dt = as_jax(run), run.t[1] - run.t[0]
    starts = jnp.array([[start.get("cart.x", 0.0), start.get("pole.theta", 0.0)] for start in STARTS])

    def motion(weights, start):
        return f(jnp.concatenate([weights, start]))

    def cost(weights, start):
        states = motion(weights, start)
        rates = states**2 @ WEIGHTS + network(weights, states) ** 2
        return dt * (jnp.sum(rates) - (rates[0] + rates[-1]) / 2)

    value = jax.jit(jax.value_and_grad(lambda weights: jnp.mean(jax.vmap(cost, (None, 0))(weights, starts))))
    hidden = np.random.default_rng(0).normal(0.0, 0.1, (UNITS, 4))
    hidden[0] = [0.0, -2.0, 0.0, -0.4]  # holds the pole, and lets the cart go
    first = weights = jnp.append(hidden.ravel(), jnp.array([20.0, 1.0, 1.0]))
    history, mean, square = [], jnp.zeros_like(weights), jnp.zeros_like(weights)
    for k in range(1, rounds + 1):  # Adam
        now, slope = value(weights)
        history.append(float(now))
        mean, square = 0.9 * mean + 0.1 * slope, 0.99 * square + 0.01 * slope**2
        weights = weights - 0.05 * (mean / (1 - 0.9**k)) / (jnp.sqrt(square / (1 - 0.99**k)) + 1e-8)
    upright = {f"v{k}": 0.0 for k in range(UNITS)}
    system = model.linearise({"pole.theta": 0.0}, inputs=["push"], parameters=upright)
    P = solve_continuous_are(system.A_state, system.B_state, np.diag(WEIGHTS), np.eye(1))
    least = np.mean([start @ P[:2, :2] @ start for start in np.asarray(starts)])
    print(f"cost {history[0]:.3f} at first, {history[-1]:.4f} after {rounds} rounds, {least:.4f} at least")
    if picture:
        left, right = (figure := Figure(figsize=(10, 4), layout="constrained", dpi=120)).subplots(1, 2)
        left.semilogy(history, label="cost of the network")
        left.axhline(least, color="gray", linestyle="--", label="Riccati equation")
        left.set(xlabel="round")
        left.legend(frameon=False)
        for learnt, style, word in ((first, ":", "before"), (weights, "-", "after")):
            for column, name in enumerate(("cart [m]", "pole [rad]")):
                states = motion(learnt, starts[0])[:, column]
                right.plot(run.t, states, style, color=f"C{column}", label=f"{name}, {word}")
        right.set(xlabel="time [s]", ylim=(-0.2, 0.3), title="let go at 0.1 rad")
        right.legend(frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

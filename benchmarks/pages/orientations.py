"""Energy and momentum from 10,000 random orientations and spins: `python -m benchmarks.pages.orientations`."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np

from runtime import ensemble, load_model
from symgen.scenes import generated_folder

CASES, STEPS = 10_000, 10
ENDS = ("e0", "e1", "e2", "e3", "omega_x", "omega_y", "omega_z")


@dataclass(frozen=True)
class Body:
    """A scene of one body: inertia about the point that stays [kg m^2], m g l of its y-axis [N m], step [s]."""

    scene: str
    name: str
    inertia: tuple[float, float, float]
    weight: float
    dt: float


BODIES = (
    Body("tumbling_body", "body", (1.0, 2.0, 3.0), 0.0, 0.01),
    Body("heavy_top", "top", (15.234375, 0.46875, 15.234375), 15 * 9.81, 1e-3),
)


def axes(e: np.ndarray) -> np.ndarray:
    """Rotation matrices (k, 3, 3) of unit quaternions (k, 4): rows of 1 + 2 e0 e~ + 2 e~^2."""
    tilde = np.zeros((len(e), 3, 3))
    for i, j, part, sign in ((0, 1, 3, -1), (0, 2, 2, 1), (1, 2, 1, -1)):
        tilde[:, i, j], tilde[:, j, i] = sign * e[:, part], -sign * e[:, part]
    return np.asarray(np.eye(3) + 2 * e[:, :1, None] * tilde + 2 * tilde @ tilde)


def changes(body: Body) -> tuple[float, float, float]:
    """(energy, angular momentum, length of the quaternion): largest changes, of the largest of all cases."""
    rng, J = np.random.default_rng(1), np.array(body.inertia)
    e = np.vstack([np.eye(4), rng.normal(size=(CASES - 4, 4))])
    e /= np.linalg.norm(e, axis=1, keepdims=True)
    start = np.hstack([e, 3 * rng.normal(size=(CASES, 3))])
    names = [f"{body.name}.{end}" for end in ENDS]
    found = ensemble(
        load_model(generated_folder(body.scene)), initial=dict(zip(names, start.T, strict=True)), scheme="rk4",
        dt=body.dt, t_end=STEPS * body.dt, outputs=names, reduce={name: ["end"] for name in names},
    )  # fmt: skip
    after = np.array([np.asarray(found[f"{name}_end"]) for name in names]).T

    def invariants(state: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        A, omega = axes(state[:, :4]), state[:, 4:]
        L = np.einsum("kij,kj->ki", A, J * omega)
        return (omega**2 @ J) / 2 + body.weight * A[:, 2, 1], L[:, 2:] if body.weight else L

    energy, momentum = (
        float(np.abs(now - before).max() / np.abs(before).max())
        for before, now in zip(invariants(start), invariants(after), strict=True)
    )
    return energy, momentum, float(np.abs(np.linalg.norm(after[:, :4], axis=1) - 1).max())


def main(arguments: list[str] | None = None) -> int:
    """Print a line a body; there are no arguments."""
    for body in BODIES:
        started = time.process_time()
        energy, momentum, length = changes(body)
        print(
            f"{body.scene}: {CASES} cases, {STEPS} steps of rk4: energy {energy:.1e}, momentum {momentum:.1e}, "
            f"length of e {length:.0e}; {time.process_time() - started:.0f} s CPU"
        )
    return 0


if __name__ == "__main__":
    raise SystemExit(main())

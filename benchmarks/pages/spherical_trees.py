"""Accelerations of rigid trees of hinges and balls against Pinocchio: `python -m benchmarks.pages.spherical_trees`.

Pinocchio (extra `benchmark`) has relative quaternions and relative angular velocities at its spherical joints, and its
own recursion; here orientations and angular velocities are those in the world and in the axes of the bodies.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.harness.models import workplace
from runtime import load_model
from runtime.contract.orientations import exponential, product, rotation
from symgen.generate import generate
from symgen.scene import Scene, SceneRecord

TREES, BODIES, GRAVITY = 50, 5, 9.81
CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])
FUNCTIONS = frozenset({"condensed", "closure", "velocities"})


@dataclass(frozen=True)
class Part:
    """A body: its parent (0: the ground), is its joint a ball?, where (in the parent's axes), inertia."""

    parent: int
    ball: bool
    place: np.ndarray
    axes: np.ndarray
    mass: float
    centre: np.ndarray
    inertia: np.ndarray


def random_tree(rng: np.random.Generator) -> list[Part]:
    """Two balls at least, everything else at random."""
    balls = rng.permutation([True, True, *rng.integers(0, 2, BODIES - 2).astype(bool)])
    parts = []
    for k, ball in enumerate(balls):
        sides = rng.uniform(0.1, 1.0, 3)
        axes = rotation(rng.normal(size=3)) if not ball else np.eye(3)
        place, centre = rng.uniform(-0.5, 0.5, 3), 0.2 * rng.uniform(-1, 1, 3)
        mass = float(rng.uniform(0.5, 3.0))
        inertia = mass / 12 * (sides @ sides - sides**2)
        parts.append(Part(int(rng.integers(0, k + 1)), bool(ball), place, axes, mass, centre, inertia))
    return parts


def scene_of(parts: list[Part]) -> SceneRecord:
    """The tree; a body's frame is that of its joint."""
    names = ["ground", *(f"body{k + 1}" for k in range(len(parts)))]
    markers: dict[str, dict] = {name: {"own": {}} for name in names}
    for k, part in enumerate(parts):
        axis, x_axis = part.axes[:, 2].tolist(), part.axes[:, 0].tolist()
        markers[names[part.parent]][f"m{k}"] = {"position": part.place.tolist(), "axis": axis, "x_axis": x_axis}
    builder = Scene("spherical_tree", space="spatial").gravity(0, 0, -GRAVITY).ground(markers=markers["ground"])
    for name, part in zip(names[1:], parts, strict=True):
        data = {"mass": part.mass, "inertia": part.inertia.tolist(), "center_of_mass": part.centre.tolist()}
        builder.rigid(name, **data, markers=markers[name])
    for k, part in enumerate(parts):
        kind = "spherical" if part.ball else "revolute"
        builder.joint(kind, f"j{k}", f"{names[part.parent]}.m{k}", f"{names[k + 1]}.own")
    return builder.build()


def pinocchio_of(parts: list[Part]) -> Any:
    """The same tree there."""
    import pinocchio as pin  # extra `benchmark`

    model = pin.Model()
    model.gravity.linear = np.array([0, 0, -GRAVITY])
    for k, part in enumerate(parts):
        joint = pin.JointModelSpherical() if part.ball else pin.JointModelRZ()
        added = model.addJoint(part.parent, joint, pin.SE3(part.axes, part.place), f"j{k}")
        model.appendBodyToJoint(added, pin.Inertia(part.mass, part.centre, np.diag(part.inertia)), pin.SE3.Identity())
    return model


def difference(parts: list[Part], rng: np.random.Generator, folder: Path) -> float:
    """Largest difference of the accelerations at a random state, of the largest of them."""
    import pinocchio as pin

    model = load_model(generate(scene_of(parts), folder, FUNCTIONS))
    e, omega = [np.array([1.0, 0, 0, 0])], [np.zeros(3)]
    q, v, position, rate = [], [], dict[str, float](), dict[str, float]()
    for k, part in enumerate(parts):
        turned = product(e[part.parent], exponential(pin.log3(part.axes)))
        if part.ball:
            theta, spin = rng.normal(size=3), rng.normal(size=3)
            e.append(exponential(theta))
            relative = product(turned * CONJUGATE, e[-1])
            q.append(np.r_[relative[1:], relative[0]])
            v.append(spin - _matrix(e[-1]).T @ _matrix(e[part.parent]) @ omega[part.parent])
            omega.append(spin)
            position |= {f"body{k + 1}.turn_{axis}": theta[i] for i, axis in enumerate("xyz")}
            rate |= {f"body{k + 1}.turn_{axis}": spin[i] for i, axis in enumerate("xyz")}
        else:
            angle, speed = rng.uniform(-2, 2), rng.normal()
            e.append(product(turned, exponential(np.array([0, 0, angle]))))
            omega.append(_matrix(e[-1]).T @ _matrix(e[part.parent]) @ omega[part.parent] + [0, 0, speed])
            q.append(np.array([angle]))
            v.append(np.array([speed]))
            position[f"j{k}.angle"], rate[f"j{k}.angle"] = angle, speed
    own = {"q_i": np.array([position[name] for name in model.q_i]), "t": 0.0}
    own |= {"q_i_dot": np.array([rate[name] for name in model.q_i]), "c": model.constants(model.parameter_vector())}
    own["q_d"] = model.evaluate("closure", **own, q_d=np.zeros(len(model.q_d)))["q_d_next"]
    own["q_d_dot"] = model.evaluate("velocities", **own)["q_d_dot"]
    out = {name: np.asarray(value) for name, value in model.evaluate("condensed", **own).items()}
    found = dict(zip(model.q_i, np.linalg.solve(out["M_hat"], out["Q_hat"]).ravel(), strict=True))
    theirs = pinocchio_of(parts)
    data, at, rates = theirs.createData(), np.concatenate(q), np.concatenate(v)
    a = pin.aba(theirs, data, at, rates, np.zeros(theirs.nv))
    pin.forwardKinematics(theirs, data, at, rates, a)
    wanted: dict[str, float] = {}
    for k, part in enumerate(parts):
        if part.ball:
            alpha = data.a[k + 1].angular
            wanted |= {f"body{k + 1}.turn_{axis}": float(alpha[i]) for i, axis in enumerate("xyz")}
        else:
            wanted[f"j{k}.angle"] = float(a[theirs.joints[k + 1].idx_v])
    largest = max(abs(value) for value in wanted.values())
    return max(abs(found[name] - value) for name, value in wanted.items()) / largest


def _matrix(e: np.ndarray) -> np.ndarray:
    """Rotation matrix of a unit quaternion."""
    return np.array([product(product(e, np.r_[0, unit]), e * CONJUGATE)[1:] for unit in np.eye(3)]).T


def main(arguments: list[str] | None = None) -> int:
    """Print the largest difference of all trees; there are no arguments."""
    rng = np.random.default_rng(7)
    with workplace() as folder:
        found = [difference(random_tree(rng), rng, folder / f"tree{k}") for k in range(TREES)]
    print(f"{TREES} random trees of {BODIES} bodies on hinges and balls: accelerations agree to {max(found):.0e}")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())

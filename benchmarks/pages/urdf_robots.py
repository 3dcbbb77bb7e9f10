"""Robots of example-robot-data against Pinocchio: `python -m benchmarks --only urdf_robots`.

Both packages are of the extra `benchmark`. Every URDF file, with a fixed and with a free base: accelerations of random
states and efforts, Pinocchio's joint damping (which its algorithm leaves out) off here too; what is refused, with the
reason. Then the torques of a Panda along a trajectory against Pinocchio's RNEA.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from importlib.metadata import distribution
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import numpy as np

from runtime.contract.orientations import rotation
from runtime.model import Model
from symgen.generate import model_of
from symgen.scene import SceneError
from symgen.urdf import RobotBuilder, read

STATES, SEED = 3, 7
LIMIT = 1e-12


def robots() -> list[Path]:
    """All URDF files of the package."""
    package = distribution("example-robot-data")  # extra `benchmark`
    return sorted(Path(str(package.locate_file(one))) for one in package.files or () if one.suffix == ".urdf")


@dataclass(frozen=True)
class Twin:
    """A robot here and in Pinocchio, and where each joint stands in both."""

    builder: RobotBuilder
    model: Model
    pin: Any
    free: str
    mimics: dict[str, tuple[str, float, float]]

    def follows(self, joint: str) -> tuple[int, float, float]:
        """(position k in q_i, f, b): the joint stands at f q_k + b."""
        names = self.model.q_i
        (own,) = self.builder.coordinates[joint]
        if own in names:
            return names.index(own), 1.0, 0.0
        if joint in self.mimics:
            master, factor, offset = self.mimics[joint]
            k, f, b = self.follows(master)
            return k, factor * f, factor * b + offset
        slave, (_, factor, offset) = next((name, one) for name, one in self.mimics.items() if one[0] == joint)
        k, f, b = self.follows(slave)
        return k, f / factor, (b - offset) / factor

    def state(self, rng: np.random.Generator) -> tuple[np.ndarray, ...]:
        """q, v, efforts, and q, v, tau of Pinocchio: random, the base too."""
        model, there = self.model, self.pin
        q, v, tau = rng.uniform(-1, 1, (3, len(model.q_i)))
        q_pin, v_pin, tau_pin = np.zeros(there.nq), np.zeros(there.nv), np.zeros(there.nv)
        for joint, (coordinate,) in self.builder.coordinates.items():
            k, f, b = self.follows(joint)
            to, at = there.joints[there.getJointId(joint)], f * q[k] + b
            q_pin[to.idx_q : to.idx_q + to.nq] = at if to.nq == 1 else (np.cos(at), np.sin(at))
            v_pin[to.idx_v] = f * v[k]
            if coordinate in model.q_i:
                tau_pin[to.idx_v] = tau[k]
        if self.free:
            place, turn = self._base()
            R = rotation(q[turn])
            q_pin[:3], q_pin[3:7] = q[place], _quaternion(q[turn])
            v_pin[:3], v_pin[3:6] = R.T @ v[place], v[turn]
        return q, v, tau, q_pin, v_pin, tau_pin

    def _base(self) -> tuple[list[int], list[int]]:
        names = self.model.q_i
        return (
            [names.index(f"{self.free}.{axis}") for axis in "xyz"],
            [names.index(f"{self.free}.turn_{axis}") for axis in "xyz"],
        )

    def accelerations(self, q: np.ndarray, v: np.ndarray, a_pin: np.ndarray) -> np.ndarray:
        """Those of Pinocchio in the order of q_i."""
        a = np.zeros(len(self.model.q_i))
        for joint, (coordinate,) in self.builder.coordinates.items():
            if coordinate in self.model.q_i:
                a[self.model.q_i.index(coordinate)] = a_pin[self.pin.joints[self.pin.getJointId(joint)].idx_v]
        if self.free:
            place, turn = self._base()
            R = rotation(q[turn])
            a[place] = R @ (a_pin[:3] + np.cross(v[turn], R.T @ v[place]))
            a[turn] = a_pin[3:6]
        return a

    def spread(self) -> np.ndarray:
        """G (n_v, n_i): rates of Pinocchio by ours, the base first; constant, as mimics are."""
        n_base = 6 if self.free else 0
        names = {name for (name,) in self.builder.coordinates.values()}
        own = [k for k, name in enumerate(self.model.q_i) if name in names]
        G = np.zeros((self.pin.nv, n_base + len(own)))
        G[:n_base, :n_base] = np.eye(n_base)
        for joint in self.builder.coordinates:
            k, f, _ = self.follows(joint)
            G[self.pin.joints[self.pin.getJointId(joint)].idx_v, n_base + own.index(k)] = f
        return G

    def expected(self, q_pin: np.ndarray, v_pin: np.ndarray, tau_pin: np.ndarray) -> np.ndarray:
        """Accelerations of Pinocchio (n_v,): by its ABA; with mimics G (G^T M G)^-1 G^T (tau - h), v = G v_i."""
        import pinocchio as pin

        data = self.pin.createData()
        if not self.mimics:
            return np.asarray(pin.aba(self.pin, data, q_pin, v_pin, tau_pin))
        G = self.spread()
        M = pin.crba(self.pin, data, q_pin)
        M = np.triu(M) + np.triu(M, 1).T
        h = pin.nonLinearEffects(self.pin, self.pin.createData(), q_pin, v_pin)
        return np.asarray(G @ np.linalg.solve(G.T @ M @ G, G.T @ (tau_pin - h)))

    def inputs(self, tau: np.ndarray) -> dict[str, float]:
        """The efforts as inputs, and no damping."""
        found = {}
        for joint, (coordinate,) in self.builder.coordinates.items():
            if coordinate not in self.model.q_i:
                continue
            (name,) = self.builder.efforts[joint]
            found[name] = float(tau[self.model.q_i.index(coordinate)])
        return found | {one.name: 0.0 for one in self.model.parameters if one.name.endswith(".damping")}


def _quaternion(turn: np.ndarray) -> np.ndarray:
    """x, y, z, w."""
    angle = float(np.linalg.norm(turn))
    return np.append(np.sinc(angle / (2 * np.pi)) / 2 * turn, np.cos(angle / 2))


def twin(path: Path, base: Any) -> Twin:
    """Raises SceneError where the robot is refused."""
    import pinocchio as pin  # extra `benchmark`

    # friction, ends and limits of motors are none of what is compared
    builder = read(path, base=base, meshes=False, friction=False, limits=False, effort=False)
    model = model_of(builder.build())
    free = "" if base == "fixed" else next(iter(builder.frames.values())).partition(".")[0]
    there = pin.buildModelFromUrdf(str(path), pin.JointModelFreeFlyer()) if free else pin.buildModelFromUrdf(str(path))
    return Twin(builder, model, there, free, mimics_of(path))


def mimics_of(path: Path) -> dict[str, tuple[str, float, float]]:
    """{joint: (joint that it follows, multiplier, offset)}, as the file says."""
    found = {}
    for joint in ElementTree.parse(path).getroot().iter("joint"):
        one = joint.find("mimic")
        if one is not None and joint.get("type") != "fixed":
            factor, offset = float(one.get("multiplier", 1.0)), float(one.get("offset", 0.0))
            found[str(joint.get("name"))] = str(one.get("joint")), factor, offset
    return found


def forward_difference(both: Twin) -> float:
    """Largest relative difference of accelerations over some states."""
    rng, worst = np.random.default_rng(SEED), 0.0
    for _ in range(STATES):
        q, v, tau, q_pin, v_pin, tau_pin = both.state(rng)
        expected = both.accelerations(q, v, both.expected(q_pin, v_pin, tau_pin))
        found = both.model.forward_dynamics(q, v, parameters=both.inputs(tau))
        worst = max(worst, float(np.abs(found - expected).max() / np.abs(expected).max()))
    return worst


def panda_torques(path: Path, samples: int = 200) -> float:
    """Largest relative difference of inverse dynamics along a trajectory of all joints."""
    import pinocchio as pin

    both = twin(path, "fixed")
    rng, data = np.random.default_rng(SEED), both.pin.createData()
    n = len(both.model.q_i)
    middle, size, rate, phase = (
        rng.uniform(-1, 1, n),
        rng.uniform(0.2, 1, n),
        rng.uniform(1, 4, n),
        rng.uniform(0, 6, n),
    )
    G = both.spread()
    middle_pin = np.array([both.follows(joint)[2] for joint in both.pin.names[1:]])
    worst, largest = 0.0, 0.0
    for t in np.linspace(0.0, 5.0, samples):
        wave = np.sin(rate * t + phase), rate * np.cos(rate * t + phase), -(rate**2) * np.sin(rate * t + phase)
        q, v, a = (size * part for part in wave)
        at, rates, bends = middle_pin + G @ (middle + q), G @ v, G @ a
        expected = G.T @ pin.rnea(both.pin, data, at, rates, bends)
        found = both.model.inverse_dynamics(middle + q, v, a, parameters=both.inputs(np.zeros(n)))
        worst, largest = max(worst, np.abs(found - expected).max()), max(largest, np.abs(expected).max())
    return float(worst / largest)


def main(arguments: list[str] | None = None) -> int:
    """Print a line a robot; arguments: names of files, all by default. 0 where none is different."""
    chosen = arguments or []
    paths = [path for path in robots() if not chosen or path.stem in chosen]
    different = refused = equal = 0
    print("| robot | base | joints | difference or why not |\n|---|---|---|---|")
    for path in paths:
        for base in ("fixed", "free"):
            try:
                both = twin(path, base)
                error, count = forward_difference(both), len(both.builder.coordinates)
                equal, different = equal + (error <= LIMIT), different + (not error <= LIMIT)
                print(f"| {path.stem} | {base} | {count} | {error:.1e} |", flush=True)
            except SceneError as reason:
                refused += 1
                print(f"| {path.stem} | {base} | | {reason.item}: {reason.problem} |", flush=True)
    print(f"\n{equal} within {LIMIT:g}, {refused} refused, {different} different")
    for path in paths:
        if path.stem == "panda":
            print(f"inverse dynamics of the Panda: {panda_torques(path):.1e}")
    return int(different > 0)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Generated trees equal the twin in the joints' rates, with axes anywhere, parallel, square or almost parallel."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial.spatial_scenes import inertia, marker
from tests.hand_derived.spatial.twin_tree import Limb, M_and_Q
from tests.hand_derived.twin_common import Array
from tests.support.model_values import evaluate, make_state, relative_error

pytestmark = pytest.mark.long

FUNCTIONS = frozenset({"condensed", "forward_dynamics", "closure", "velocities"})
GRAVITY = np.array([1.0, -2.0, -9.0])
KINDS = {"revolute": ("angle",), "prismatic": ("travel",), "cylindrical": ("angle", "travel")}
PARENTS = (-1, 0, 0, 2, 3, -1)


def rotation(rng: np.random.Generator, kind: str) -> Array:
    """Axes of a marker: any, along those of the body, or turned by 1e-4 rad from them."""
    if kind == "any":
        Q, _ = np.linalg.qr(rng.normal(size=(3, 3)))
        return Q * np.sign(np.linalg.det(Q))
    square = np.roll(np.eye(3), int(rng.integers(3)), axis=1)
    if kind == "square":
        return square
    x, y, z = 1e-4 * rng.normal(size=3)
    Q, R = np.linalg.qr(square @ np.array([[1, -z, y], [z, 1, -x], [-y, x, 1]]))
    return Q * np.sign(np.diag(R))


def mechanism(seed: int, kind: str) -> tuple[SceneRecord, list[Limb]]:
    rng = np.random.default_rng(seed)
    builder = Scene("tree", space="spatial").gravity(*GRAVITY)
    limbs, types, column = [], [], 0
    markers: dict[int, dict[str, dict]] = {k: {} for k in range(-1, len(PARENTS))}
    for k, parent in enumerate(PARENTS):
        joint = str(rng.choice(list(KINDS)))
        places = {key: column + position for position, key in enumerate(KINDS[joint])}
        column += len(places)
        half = rng.normal(size=(3, 3))
        u, c = (rng.uniform(-1, 1, 3) * rng.integers(0, 2, 3) for _ in range(2))
        B, C = rotation(rng, kind), rotation(rng, kind)
        tensor = np.trace(half @ half.T) * np.eye(3) - half @ half.T
        center = rng.uniform(-0.3, 0.3, 3)
        places = {key: places.get(key) for key in ("angle", "travel")}
        limbs.append(Limb(parent, u, B, c, C, places["angle"], places["travel"], rng.uniform(1, 2), center, tensor))
        types.append(joint)
        markers[parent][f"to{k}"], markers[k]["foot"] = marker(u, B), marker(c, C)
    builder.ground(markers=markers[-1])
    for k, limb in enumerate(limbs):
        builder.rigid(
            f"body{k}", mass=limb.mass, center_of_mass=limb.center, **inertia(limb.inertia), markers=markers[k]
        )
    for k, limb in enumerate(limbs):
        parent = f"body{limb.parent}" if limb.parent >= 0 else "ground"
        builder.joint(types[k], f"joint{k}", f"{parent}.to{k}", f"body{k}.foot")
    return builder.build(), limbs


@pytest.mark.parametrize(("seed", "kind"), [(1, "any"), (2, "square"), (3, "almost")])
def test_trees_in_the_rates_of_their_joints(
    seed: int, kind: str, build: Callable[[SceneRecord, frozenset[str] | None], Model]
) -> None:
    scene, limbs = mechanism(seed, kind)
    model = build(scene, FUNCTIONS)
    rng = np.random.default_rng(seed)
    n = len(model.q_i)
    for _ in range(3):
        state = make_state(model, rng.uniform(-3, 3, n), rng.uniform(-3, 3, n))
        out = evaluate(model, "condensed", **state.values())
        M, Q = M_and_Q(limbs, GRAVITY, state.q_i, state.q_i_dot)
        assert relative_error(out["M_hat"].reshape(n, n), M) < 1e-12
        assert relative_error(out["Q_hat"], Q) < 1e-12
        found = evaluate(model, "forward_dynamics", **state.values())["q_i_ddot"]
        assert relative_error(found, np.linalg.solve(M, Q)) < 1e-11

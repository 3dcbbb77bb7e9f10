"""A free flexible body that carries one body on every type of joint: the joints' laws at one go.

The body bends where the joints sit, so their markers move and turn with it. The same mechanism can be derived with
joints that place bodies by coordinates of their own or with joints that are all equations between bodies (see
`no_placements`), and written with the two markers of a joint exchanged.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import numpy as np
import pytest

from runtime.contract.coordinates import independent
from runtime.model import Model
from symgen.scene import Scene, SceneRecord
from tests.hand_derived.spatial.spatial_scenes import flexible, inertia
from tests.hand_derived.spatial.twin_flexible_nodes import Nodes, scattered
from tests.support.model_values import Array

PLACING = ("revolute", "prismatic", "cylindrical", "screw", "universal", "planar", "weld")
OTHERS = ("spherical", "point_on_line", "distance", "prescribed_angle", "prescribed_displacement")
ONE_WAY = ("point_on_line", "prescribed_angle", "prescribed_displacement")  # marker a has the axis
MORE: dict[str, dict[str, Any]] = {
    "screw": {"lead": 0.3},
    "distance": {"length": 0.8},
    "prescribed_angle": {"motion": "0.4 + 0.7*t + sin(3*t)/5"},
    "prescribed_displacement": {"motion": "0.3 + 0.2*sin(2*t)"},
}
GRAVITY = (1.0, -2.0, -9.0)


@dataclass(frozen=True)
class Variant:
    """How the comb is written: do joints place bodies, are the joints' markers exchanged, is the base given last?"""

    placing: bool = True
    exchanged: bool = False
    base_last: bool = False


@contextmanager
def no_placements(none: bool) -> Iterator[None]:
    """Derive with all joints as equations between bodies, each of which is free by itself."""
    with pytest.MonkeyPatch.context() as patch:
        if none:
            patch.setattr("symgen.scene.parts.placements_of", lambda bodies, joints, coupled: [])
        yield


def lumps(types: tuple[str, ...]) -> dict[str, Nodes]:
    """The lumped masses of every body; the base has three modes, the body on the universal joint two."""
    found = {"base": scattered(9, 3, seed=2)}
    for k, kind in enumerate(types):
        found[kind] = scattered(5, 2 if kind == "universal" else 0, seed=20 + k)
    return found


def rigid(nodes: Nodes) -> dict[str, Any]:
    """Mass, centre and inertia of masses that do not move against each other."""
    m, x = nodes.masses, nodes.positions
    centre = m @ x / m.sum()
    arms = x - centre
    moments = np.einsum("k,ki,kj->ij", m, arms, arms)
    tensor = np.trace(moments) * np.eye(3) - moments
    return {"mass": float(m.sum()), "center_of_mass": centre, **inertia(tensor)}


def comb(types: tuple[str, ...], variant: Variant = Variant(), psi: float = 1.0) -> SceneRecord:
    """The scene. psi: size of the rotation of the markers by deformation."""
    rng, nodes = np.random.default_rng(3), lumps(types)
    builder = Scene("comb", space="spatial").gravity(*GRAVITY)
    on_base, children = {}, []
    for kind in types:
        a, b = rng.normal(size=(2, 3)), rng.normal(size=(2, 3))
        near = {
            "position": 0.5 * rng.normal(size=3),
            "shape": 0.3 * rng.normal(size=(3, 3)),
            "rotation": psi * rng.normal(size=(3, 3)),
        }
        far: dict[str, Any] = {"position": 0.4 * rng.normal(size=3)}
        if kind == "universal":
            far |= {"shape": 0.3 * rng.normal(size=(3, 2)), "rotation": psi * rng.normal(size=(3, 2))}
        directions = _exchanged_universal(a, b) if kind == "universal" and variant.exchanged else (a, b)
        on_base[f"at_{kind}"], far = {**near, **_axes(directions[0])}, {**far, **_axes(directions[1])}
        fields = {"markers": {"at": far}}
        children.append((kind, fields))
    base = {**flexible(nodes["base"]), "free": True, "markers": on_base}
    order = [*children, ("base", base)] if variant.base_last else [("base", base), *children]
    for name, fields in order:
        if nodes[name].shapes.shape[2] and name != "base":
            fields = {**flexible(nodes[name]), **fields}
        if nodes[name].shapes.shape[2]:
            builder.flexible(name, **fields)
        else:
            builder.rigid(name, **rigid(nodes[name]), **fields)
    for kind in types:
        ends = (f"base.at_{kind}", f"{kind}.at")
        ends = ends[::-1] if variant.exchanged and kind not in ONE_WAY else ends
        builder.joint(kind, f"j_{kind}", *ends, **MORE.get(kind, {}))
    return builder.build()


def _axes(pair: Array) -> dict[str, Any]:
    """z along the first vector, x on the side of the second."""
    return {"axis": pair[0], "x_axis": pair[1]}


def _exchanged_universal(a: Array, b: Array) -> tuple[Array, Array]:
    """Directions that give the same joint when the markers change places: z_a' = x_b, x_b' = z_a."""
    z_a, z_b = (pair[0] / np.linalg.norm(pair[0]) for pair in (a, b))
    x_a, x_b = (pair[1] - (pair[1] @ z) * z for pair, z in ((a, z_a), (b, z_b)))
    return np.array([np.cross(z_a, x_a), z_a]), np.array([x_b, np.cross(z_b, x_b)])


def exchanged_coordinates(model: Model, q: dict[str, float], q_dot: dict[str, float]) -> tuple[Array, Array]:
    """q_i and q_i_dot of the comb with exchanged markers, from coordinates and rates by name of the comb as it was."""
    values, rates = dict(q), dict(q_dot)
    for name in q:
        if name.startswith("j_"):
            values[name], rates[name] = -q[name], -q_dot[name]
    if "j_universal.angle1" in q:
        for new, old in (("angle1", "angle2"), ("angle2", "angle1")):
            values[f"j_universal.{new}"] = np.pi / 2 - q[f"j_universal.{old}"]
            rates[f"j_universal.{new}"] = -q_dot[f"j_universal.{old}"]
    if "j_planar.x" in q:
        c, s, spin = np.cos(q["j_planar.angle"]), np.sin(q["j_planar.angle"]), q_dot["j_planar.angle"]
        back, slope = -np.array([[c, s], [-s, c]]), -np.array([[-s, c], [-c, -s]])
        travel, speed = (np.array([of[f"j_planar.{axis}"] for axis in "xy"]) for of in (q, q_dot))
        new, rate = back @ travel, back @ speed + spin * slope @ travel
        values |= {f"j_planar.{axis}": new[k] for k, axis in enumerate("xy")}
        rates |= {f"j_planar.{axis}": rate[k] for k, axis in enumerate("xy")}
    return independent(model, *(np.array([of[name] for name in model.coordinates]) for of in (values, rates)))

"""Hypothesis strategies for spatial mechanisms of rigid bodies and beams: trees, closed loops, doubled joints."""

from __future__ import annotations

from typing import Any

import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from symgen.scene import Scene, SceneRecord
from tests.support.model_values import Array

Draw = Any
TREE_JOINTS = (
    "revolute",
    "prismatic",
    "cylindrical",
    "screw",
    "universal",
    "planar",
    "spherical",
    "point_on_line",
    "distance",
)
MORE: dict[str, dict[str, float]] = {"screw": {"lead": 0.2}, "distance": {"length": 0.7}}
FREEDOM = {"revolute": 1, "universal": 2, "cylindrical": 2, "spherical": 3}  # of the joints along a loop
HELD = {"distance": 1, "point_on_line": 2, "spherical": 3, "revolute": 5}  # by the joint that closes it
GRAVITY = st.tuples(st.floats(-3, 3), st.floats(-9.81, 9.81), st.floats(-9.81, 9.81))
ANGLES = ("xyz", "zyx", "yzx")
LENGTH = 0.6


class Assembly:
    """A scene under construction in which every joint fits: bodies are at known places, markers are made to match.

    The first joint of a body fits at zero coordinates of its own, so a body's frame is where its first marker says.
    """

    def __init__(self, draw: Draw) -> None:
        self.draw, self.rng = draw, np.random.default_rng(draw(st.integers(0, 10**6)))
        self.bodies: dict[str, dict[str, Any]] = {"ground": {"markers": {}}}
        self.frames: dict[str, tuple[Array, Array]] = {"ground": (np.zeros(3), np.eye(3))}
        self.joints: list[tuple[str, str, str, str, dict[str, Any]]] = []

    def add_body(self, name: str, angles: bool, rigid: bool = False) -> None:
        """A rigid body or a beam of bending modes, anywhere."""
        flexible = not rigid and self.draw(st.booleans())
        A = Rotation.from_rotvec(0.5 * self.rng.uniform(-1, 1, 3))
        self.frames[name] = self.rng.uniform(-1, 1, 3), A.as_matrix()
        orientation = self.draw(st.sampled_from(ANGLES)) if angles else "euler_parameters"
        fields: dict[str, Any] = {"orientation": orientation, "markers": {}, "type": "beam" if flexible else "rigid"}
        if flexible:
            side = self.rng.uniform(0.01, 0.03, 2)
            fields |= {
                "length": LENGTH,
                "density": 3000.0,
                "area": side[0] * side[1],
                "youngs_modulus": 1e10,
                "second_moment": side[0] * side[1] ** 3 / 12,
                "second_moment_z": side[1] * side[0] ** 3 / 12,
                "lateral": {"ends": "clamped-free", "modes": 1},
                "stiffening": self.draw(st.booleans()),
                "lateral_z": {"ends": "clamped-free", "modes": 1} if self.draw(st.booleans()) else None,
            }
            if self.draw(st.booleans()):
                twist = {"ends": "fixed-free", "modes": 1}
                fields |= {"torsion": twist, "shear_modulus": 4e9, "torsion_constant": 0.2 * side.min() ** 4}
        else:
            mass, sides = self.rng.uniform(0.5, 3), self.rng.uniform(0.1, 1, 3)
            fields |= {"mass": mass, "inertia": mass / 12 * (sides @ sides - sides**2), "center_of_mass": 0.2 * sides}
        self.bodies[name] = fields

    def marker(self, body: str, place: Array | None, axes: Array) -> str:
        """A marker of a body at a world place (free to choose on a beam: None) with the given world axes."""
        fields, (R, A) = self.bodies[body], self.frames[body]
        local = A.T @ axes
        directions = {"axis": local[:, 2], "x_axis": local[:, 0]}
        if fields.get("type") == "beam":
            assert place is None
            position: dict[str, Any] = {"at": float(self.rng.choice([0.0, 0.5, 1.0]))}
        else:
            position = {"position": A.T @ (place - R) if place is not None else self.rng.uniform(-0.5, 0.5, 3)}
        label = f"m{len(fields['markers'])}"
        fields["markers"][label] = {**position, **directions}
        return f"{body}.{label}"

    def place_of(self, reference: str) -> Array:
        """World place of a marker while nothing is bent."""
        body, _, label = reference.partition(".")
        (R, A), marker = self.frames[body], self.bodies[body]["markers"][label]
        local = np.array([LENGTH * marker["at"], 0, 0]) if "at" in marker else marker["position"]
        return np.asarray(R + A @ local)

    def axes(self) -> Array:
        """Any three axes."""
        return Rotation.random(random_state=int(self.rng.integers(10**6))).as_matrix()

    def join(self, kind: str, name: str, a: str, b: str) -> None:
        """A joint to a new body, which is moved to where the joint holds."""
        axes = self.axes()
        near, far = self.marker(a, None, axes), self.marker(b, None, axes)
        gap, more = self.place_of(near) - self.place_of(far), dict(MORE.get(kind, {}))
        if kind == "distance":
            gap = gap + MORE[kind]["length"] * axes[:, 0]
        R, A = self.frames[b]
        self.frames[b] = R + gap, A
        self.joints.append((kind, name, near, far, more))

    def close(self, kind: str, name: str, a: str, b: str) -> None:
        """Close a loop: a marker of rigid body b is put where the joint holds."""
        axes = self.axes()
        near = self.marker(a, None, axes)
        place = self.place_of(near) + (MORE[kind]["length"] * axes[:, 0] if kind == "distance" else 0)
        self.joints.append((kind, name, near, self.marker(b, place, axes), dict(MORE.get(kind, {}))))

    def scene(self, double: str | None = None) -> SceneRecord:
        """The scene; double: a joint to have twice."""
        builder = Scene("random_spatial", space="spatial").gravity(*self.draw(GRAVITY))
        builder.ground(markers=self.bodies["ground"]["markers"])
        start: dict[str, float] = {}
        for name, fields in self.bodies.items():
            if name != "ground":
                kind = fields["type"]
                getattr(builder, kind)(name, **{key: value for key, value in fields.items() if key != "type"})
                start |= self._start(name, fields["orientation"])
        for kind, name, a, b, more in self.joints:
            builder.joint(kind, name, a, b, **more)
            if name == double:
                builder.joint(kind, "again", a, b, **more)
        return builder.initial(start).build()

    def _start(self, name: str, orientation: str) -> dict[str, float]:
        R, A = self.frames[name]
        if orientation == "euler_parameters":
            e = np.roll(Rotation.from_matrix(A).as_quat(), 1)
            rotation = {f"{name}.e{k}": float(value) for k, value in enumerate(e if e[0] >= 0 else -e)}
        else:
            angles = Rotation.from_matrix(A).as_euler(orientation.upper())
            rotation = {f"{name}.theta{k + 1}": float(value) for k, value in enumerate(angles)}
        return {**{f"{name}.{axis}": float(value) for axis, value in zip("xyz", R, strict=True)}, **rotation}


@st.composite
def spatial_trees(draw: Draw, doubled: bool = False, most: int = 3) -> SceneRecord:
    """1 to `most` bodies on joints of any type, all given by Euler angles or by Euler parameters; a joint twice."""
    made, angles = Assembly(draw), draw(st.booleans())
    names = ["ground"]
    types = [kind for kind in TREE_JOINTS if not (doubled and kind == "screw")]
    for k in range(draw(st.integers(1, most))):
        made.add_body(f"body{k}", angles)
        made.join(draw(st.sampled_from(types)), f"joint{k}", draw(st.sampled_from(names)), f"body{k}")
        names.append(f"body{k}")
    return made.scene("joint0" if doubled else None)


@st.composite
def spatial_loops(draw: Draw) -> SceneRecord:
    """Three bodies in a chain from the ground, the last a rigid one that another joint holds to the ground."""
    made, angles = Assembly(draw), draw(st.booleans())
    types = [draw(st.sampled_from(list(FREEDOM))) for _ in range(3)]
    closing = draw(st.sampled_from(list(HELD)))
    assume(sum(FREEDOM[kind] for kind in types) > HELD[closing])
    before = "ground"
    for k, kind in enumerate(types):
        made.add_body(f"body{k}", angles, rigid=k == 2)
        made.join(kind, f"joint{k}", before, f"body{k}")
        before = f"body{k}"
    made.close(closing, "closing", "ground", before)
    return made.scene()

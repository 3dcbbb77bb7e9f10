"""A planar scene posed in the xy-plane of space, and states carried over."""

from __future__ import annotations

import math
from typing import Any

import numpy as np

from runtime.model import Model
from symgen.scene import SceneRecord
from tests.support.model_values import Array, State, evaluate
from tests.support.spatial_motion import full_state

ALONG = ("prismatic", "point_on_line", "prescribed_displacement")  # act along x in a plane, along z in space
SLIM = 1e-20  # m^4: bending across the plane is not modelled


def posed(scene: SceneRecord, planar: Model) -> SceneRecord:
    """Hinges turn about z and start as in the planar model; slides get markers whose z-axis lies in the plane."""
    data = scene.to_dict()
    data["space"], data["gravity"] = "spatial", [*data.get("gravity", [0, 0]), 0.0]
    data.pop("partition", None)
    data.pop("initial", None)
    ground = next((body for body in data["bodies"] if body["type"] == "ground"), None)
    if ground is None:
        data["bodies"].insert(0, {"type": "ground", "name": "ground"})
    sliding = {joint[key] for joint in data["joints"] if joint["type"] in ALONG for key in ("marker_a", "marker_b")}
    for body in data["bodies"]:
        own = body["name"] + "."
        _pose_body(scene, body, {reference.removeprefix(own) for reference in sliding if reference.startswith(own)})
    for joint in data["joints"]:
        if joint["type"] in ALONG:
            joint |= {key: f"{joint[key]}_slide" for key in ("marker_a", "marker_b")}
    for load in data.get("loads", []):
        if load["type"] == "force":
            load["components"] = [*load["components"], 0.0]
    types = {joint["name"]: joint["type"] for joint in data["joints"]}
    hinges = [place.joint for place in SceneRecord.from_dict(data).placements() if types[place.joint] == "revolute"]
    start = {f"{hinge}.angle": _angle(scene, planar, planar.initial_q, hinge) for hinge in hinges}
    return SceneRecord.from_dict({**data, "initial": {"coordinates": start}})


def _pose_body(scene: SceneRecord, body: dict[str, Any], sliding: set[str]) -> None:
    name = body["name"]
    implicit = scene.body(name).implicit_markers()
    markers = {}
    for label, marker in body.get("markers", {}).items():
        markers[label] = _turned(marker, slide=False)
    for label in sliding:
        given = body.get("markers", {}).get(label) or implicit[label].model_dump(include={"position", "at"})
        markers[f"{label}_slide"] = _turned(given, slide=True)
    if markers:
        body["markers"] = markers
    if body["type"] == "rigid":
        body["inertia"] = [body["inertia"]] * 3
    if body["type"] == "beam":
        body["second_moment_z"] = SLIM


def _turned(marker: dict[str, Any], slide: bool) -> dict[str, Any]:
    angle = float(marker.get("angle", 0.0))
    along = [math.cos(angle), math.sin(angle), 0.0]
    directions = {"axis": along, "x_axis": [0.0, 0.0, 1.0]} if slide else {"axis": [0.0, 0.0, 1.0], "x_axis": along}
    return {key: value for key, value in marker.items() if key in ("position", "at")} | directions


def posed_state(scene: SceneRecord, planar: Model, in_space: SceneRecord, spatial: Model, state: State) -> State:
    """The spatial state of a planar one: angles of joints are differences of absolute angles."""
    q, q_dot = (dict(zip(planar.coordinates, values, strict=True)) for values in (state.q, state.q_dot))
    x, v = np.zeros(len(spatial.coordinates)), np.zeros(len(spatial.coordinates))
    at = {name: k for k, name in enumerate(spatial.coordinates)}
    for name, value in q.items():
        body, _, part = name.partition(".")
        if part == "theta":
            half, rate = value / 2, q_dot[name] / 2
            x[at[f"{body}.e0"]], x[at[f"{body}.e3"]] = math.cos(half), math.sin(half)
            v[at[f"{body}.e0"]], v[at[f"{body}.e3"]] = -math.sin(half) * rate, math.cos(half) * rate
        else:
            x[at[name]], v[at[name]] = value, q_dot[name]
    first = len(x) - sum(len(place.coordinates) for place in in_space.placements())
    for place in in_space.placements():
        for name in place.coordinates:
            x[at[name]] = _angle(scene, planar, state.q, place.joint) if name.endswith(".angle") else 0.0
    _give_signs(in_space, spatial, x, v, state.t)
    for _ in range(3):  # travels and the angles at bent markers follow from the rows that hold them
        out = evaluate(spatial, "constraints", q=x, q_dot=v, t=state.t)
        C_q = out["C_q"].reshape(-1, len(x))
        x[first:] -= np.linalg.lstsq(C_q[:, first:], out["C"], rcond=None)[0]
    v[first:] = np.linalg.lstsq(C_q[:, first:], -out["C_t"] - C_q[:, :first] @ v[:first], rcond=None)[0]
    return full_state(spatial, x, v, state.t)


def _give_signs(in_space: SceneRecord, spatial: Model, x: Array, v: Array, t: float) -> None:
    """Euler parameters e and -e are one orientation: take the sign that the placing joints give, from the ground on."""
    for _ in in_space.placements():
        for place in in_space.placements():
            C = evaluate(spatial, "constraints", q=x, q_dot=v, t=t)["C"]
            gap = C[[spatial.constraints.index(f"{place.joint}.e{k}") for k in range(4)]]
            if np.linalg.norm(gap) > 1.0:
                first = spatial.coordinates.index(f"{place.child}.e0")
                x[first : first + 4], v[first : first + 4] = -x[first : first + 4], -v[first : first + 4]


def _angle(scene: SceneRecord, planar: Model, q: Array, joint: str) -> float:
    """phi_b - phi_a of a hinge, deflection of beams at their markers left to the constraints."""
    found = next(item for item in scene.joints if item.name == joint)
    angle = 0.0
    for reference, sign in ((found.marker_b, 1.0), (found.marker_a, -1.0)):
        body, marker = scene.marker(reference)
        theta = q[planar.coordinates.index(f"{body.name}.theta")] if body.name != "ground" else 0.0
        angle += sign * (theta + float(getattr(marker, "angle", 0.0)))
    return angle

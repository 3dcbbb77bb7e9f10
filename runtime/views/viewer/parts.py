"""Joints, springs and loads of the page: their markers, and forces over time."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.records import packed
from runtime.views.curves import force_vectors, moment_vectors
from runtime.views.mechanism.scenery import Scenery
from runtime.views.projection import is_spatial

if TYPE_CHECKING:
    from runtime.results.solution import Solution

TURNING = ("torque", "rotational_spring_damper")


def parts(solution: Solution, shown: Scenery) -> dict[str, Any]:
    """Joints and loads at their markers; forces of the joints on their body b."""
    place = {body.name: k for k, body in enumerate(shown.bodies)}

    def at(reference: str) -> list[int]:
        body, k = shown.marker(reference)
        return [place[body.name], k]

    def axes(reference: str) -> list[float]:
        body, k = shown.marker(reference)
        return list(map(float, body.markers.axes[k].ravel()))

    forces = force_vectors(solution.joint_forces) if solution.joint_forces.size else None
    largest = 0.0 if forces is None else float(np.linalg.norm(forces, axis=2).max())
    joints = []
    for joint in shown.joints:
        force = None
        if forces is not None and joint["name"] in solution.model.joints and largest > 0.0:
            column = forces[:, solution.model.joints.index(joint["name"])]
            force = packed(np.stack([np.interp(shown.t, solution.t, part) for part in column.T], axis=1))
        joints.append(
            {
                "name": joint["name"],
                "type": joint["type"],
                "a": at(joint["marker_a"]),
                "b": at(joint["marker_b"]),
                "axes": axes(joint["marker_a"]),
                "rail": _rail(shown, joint) if joint["drawing"] == "slide" else None,
                "force": force,
                "shown": joint["drawing"] != "drive",
            }
        )
    vectors = force_vectors(solution.load_forces) + moment_vectors(solution.load_forces)  # a load has one of them
    kinds = {load["name"]: load["type"] for load in shown.loads}
    loads = []
    for k, record in enumerate(solution.model.description.loads):
        load = next(one for one in shown.loads if one["name"] == record.name)
        first = load.get("marker_a") or load["marker"]
        vector = np.stack([np.interp(shown.t, solution.t, part) for part in vectors[:, k].T], axis=1)
        part = {
            "name": load["name"],
            "type": load["type"],
            "a": at(first),
            "axes": axes(first),
            "vector": packed(vector),
        }
        loads.append({**part, "b": at(load["marker_b"])} if load.get("marker_b") else part)
    sizes = np.linalg.norm(vectors, axis=2).max(axis=0, initial=0.0)
    pulling = [size for name, size in zip(kinds, sizes, strict=True) if kinds[name] == "force"]
    turning = [size for name, size in zip(kinds, sizes, strict=True) if kinds[name] in TURNING]
    return {
        "joints": joints,
        "loads": loads,
        "largest_force": largest,
        "largest_load": float(max(pulling, default=0.0)),
        "largest_torque": float(max(turning, default=0.0)),
    }


def _rail(shown: Scenery, joint: Mapping[str, Any]) -> list[float]:
    """Where the rail of a slide begins and ends along marker a's axis [m]: the travel, and a little more."""
    axis = shown.axes(joint["marker_a"])[:, :, 2 if is_spatial(shown.model) else 0]
    way = shown.place(joint["marker_b"], 1.0) - shown.place(joint["marker_a"], 1.0)
    travel = np.einsum("fi,fi->f", way, axis)
    more = 0.08 * shown.size()
    return [float(travel.min()) - more, float(travel.max()) + more]

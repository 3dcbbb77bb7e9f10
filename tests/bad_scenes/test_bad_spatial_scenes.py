"""Bad scenes in space, each the good one with one edit, and scenes that fail only when they are derived."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest

from symgen.pipeline import derive
from symgen.scene import Scene, SceneError, SceneRecord
from tests.bad_scenes.test_bad_scenes import DELETE, GOOD, edited, joint

A, S = "spatial", "slider_crank"
ARM, ROD, PLATE = "bodies[1] 'arm'", "bodies[2] 'rod'", "bodies[3] 'plate'"
ZEROS = [[0.0] * 3] * 3
# name of the case, base scene, path to edit, new value, item, phrase of the problem
BAD: list[tuple[str, str, str, Any, str, str]] = [
    # components
    ("gravity of four", A, "gravity", [0, 0, 0, 1], "gravity", "has 4 components"),
    ("position of one", A, "bodies/1/markers/tip/position", [1], f"{ARM}.markers.tip.position", "has 1 components"),
    ("centre of four", A, "bodies/1/center_of_mass", [1, 0, 0, 0], f"{ARM}.center_of_mass", "has 4 components"),
    ("force of one", A, "loads/0/components", [1], "loads[0] 'push'.components", "has 1 components"),
    ("flexible position of two", A, "bodies/3/markers/edge/position", [1, 0], f"{PLATE}.markers.edge.position[2]",
     "missing"),
    ("one moment of inertia", A, "bodies/1/inertia", 0.1, f"{ARM}.inertia", "three moments"),
    ("two moments of inertia", A, "bodies/1/inertia", [0.1, 0.2], f"{ARM}.inertia", "has 2 entries"),
    ("two products", A, "bodies/1/products", [0.1, 0.2], f"{ARM}.products", "has 2 entries"),
    ("stiffness of two", A, "loads/1/stiffness", [1, 2], "loads[1] 'rubber'.stiffness", "has 2 entries"),
    # directions
    ("axis zero", A, "bodies/1/markers/tip/axis", [0, 0, 0], f"{ARM}.markers.tip.axis", "has no direction"),
    ("axis of two", A, "bodies/1/markers/tip/axis", [0, 1], f"{ARM}.markers.tip.axis[2]", "is missing"),
    ("axis NaN", A, "bodies/1/markers/tip/axis", [0, 0, float("nan")], f"{ARM}.markers.tip.axis[2]", "not a finite"),
    ("x_axis along axis", A, "bodies/0/markers/axle/x_axis", [0, -2, 0], "bodies[0] 'ground'.markers.axle.x_axis",
     "along"),
    ("x_axis zero", A, "bodies/0/markers/axle/x_axis", [0, 0, 0], "bodies[0] 'ground'.markers.axle.x_axis", "zero"),
    ("angle in space", A, "bodies/1/markers/tip/angle", 0.3, f"{ARM}.markers.tip.angle", "by its axes"),
    # values
    ("impossible moments", A, "bodies/1/inertia", [0.1, 0.2, 0.4], f"{ARM}.inertia", "no body has these"),
    ("impossible products", A, "bodies/1/products", [0.3, 0, 0], f"{ARM}.inertia", "no body has these"),
    ("negative moment", A, "bodies/1/inertia", [-0.1, 0.2, 0.2], f"{ARM}.inertia[0]", "not negative"),
    ("negative stiffness", A, "loads/1/stiffness", [1, -2, 3], "loads[1] 'rubber'.stiffness[1]", "not negative"),
    ("no second moment", A, "bodies/2/second_moment_z", DELETE, f"{ROD}.second_moment_z", "is missing"),
    ("unknown sequence", A, "bodies/2/orientation", "xxy", f"{ROD}.orientation", "not a possible"),
    ("length in a screw", A, "joints/2/length", 1, "joints[2] 'thread'.length", "unknown key"),
    ("screw without lead", A, "joints/2/lead", DELETE, "joints[2] 'thread'.lead", "is missing"),
    # flexible bodies
    ("shape of two rows", A, "bodies/3/markers/edge/shape", [[1, 0], [0, 1]], f"{PLATE}.markers.edge.shape", "rows"),
    ("shape too narrow", A, "bodies/3/markers/edge/shape/1", [1], f"{PLATE}.markers.edge.shape[1]", "entries"),
    ("rotation too wide", A, "bodies/3/markers/edge/rotation/0", [1, 0, 0], f"{PLATE}.markers.edge.rotation[0]",
     "entries"),
    ("K_ff too large", A, "bodies/3/K_ff", [[1, 0, 0], [0, 1, 0], [0, 0, 1]], f"{PLATE}.K_ff", "rows"),
    ("phi_integral of two rows", A, "bodies/3/phi_integral", [[0, 0], [0, 0]], f"{PLATE}.phi_integral", "rows"),
    ("rho_phi of one mode", A, "bodies/3/rho_phi", [ZEROS], f"{PLATE}.rho_phi", "1"),
    ("phi_phi of one mode", A, "bodies/3/phi_phi", [[ZEROS, ZEROS]], f"{PLATE}.phi_phi", "1"),
    ("inertia_moments of two", A, "bodies/3/inertia_moments", [[1, 0], [0, 1]], f"{PLATE}.inertia_moments", "rows"),
    ("stiffening of one axis", A, "bodies/3/stiffening", {"H": [[[0, 0], [0, 0]]]}, f"{PLATE}.stiffening.H", "1"),
    ("M_ff indefinite", A, "bodies/3/M_ff", [[1, 2], [2, 1]], f"{PLATE}.M_ff", "not positive definite"),
    ("M_ff not symmetric", A, "bodies/3/M_ff/0/1", 0.2, f"{PLATE}.M_ff", "not symmetric"),
    ("K_ff negative", A, "bodies/3/K_ff/0/0", -1, f"{PLATE}.K_ff", "negative eigenvalue"),
    ("inconsistent integrals", A, "bodies/3/first_moment", [9, 0, 0], PLATE, "not positive definite"),
    # the other space
    ("joint named like a body", A, "joints/0/name", "arm", "joints[0] 'arm'", "has the name of a body"),
    ("modal in space", A, "bodies/1", {"type": "modal", "name": "arm", "mass": 1, "inertia": 1, "M_ff": [[1]],
                                       "K_ff": [[1]]}, f"{ARM}.type", "is planar"),
    ("spherical in a plane", S, "joints/+", joint("spherical", "crank.tip", "rod.end"), "joints[4] 'extra'.type",
     "three"),
    ("screw in a plane", S, "joints/+", joint("screw", "crank.tip", "rod.end", lead=1), "joints[4] 'extra'.type",
     "three"),
    ("bushing in a plane", S, "loads/+", {"type": "bushing", "name": "b", "marker_a": "ground.origin",
                                          "marker_b": "crank.tip"}, "loads[2] 'b'.type", "three dimensions"),
    ("z in a plane", S, "measures/+", {"type": "z", "name": "z", "of": "crank.tip"}, "measures[1] 'z'.type",
     "no z"),
    ("angles in a plane", S, "bodies/0/orientation", "zyx", "bodies[0] 'crank'.orientation", "angle theta"),
    ("axis in a plane", S, "bodies/0/markers/tip/axis", [0, 1, 0], "bodies[0] 'crank'.markers.tip.axis",
     "by its angle"),
    ("three moments in a plane", S, "bodies/0/inertia", [1, 1, 1], "bodies[0] 'crank'.inertia", "has one moment"),
    ("space is a number", A, "space", 3, "space", "not a possible"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("base", "path", "value", "item", "phrase"), [case[1:] for case in BAD], ids=[case[0] for case in BAD]
)
def test_bad_scene(base: str, path: str, value: Any, item: str, phrase: str) -> None:
    with pytest.raises(SceneError) as caught:
        SceneRecord.from_dict(edited(base, path, value))
    error = caught.value
    assert (error.item, error.remedy != "") == (item, True), str(error)
    assert phrase in error.problem


def test_the_good_scene_can_be_derived() -> None:
    derive(SceneRecord.from_dict(GOOD[A]), frozenset({"condensed"}))


def screw_in_a_loop() -> Scene:
    builder = Scene("loop", space="spatial").rigid("nut", mass=1.0, inertia=[1, 1, 1])
    builder.joint("screw", "slot", "ground.origin", "nut.origin", lead=0.2)
    return builder.joint("screw", "thread", "ground.origin", "nut.origin", lead=0.1)


def twice_held() -> Scene:
    builder = Scene("twice", space="spatial").rigid("door", mass=1.0, inertia=[1, 1, 1])
    builder.ground(markers={"off": {"position": [0, 0, 1], "axis": [0, 1, 1]}})
    return builder.revolute("low", "ground.origin", "door.origin").revolute("high", "ground.off", "door.origin")


DERIVED: list[tuple[Callable[[], Scene], str, str]] = [
    (screw_in_a_loop, "joints[1] 'thread'", "screw"),
    (twice_held, "initial", "cannot all be satisfied"),
]


@pytest.mark.parametrize(("scene", "item", "phrase"), DERIVED, ids=[scene.__name__ for scene, _, _ in DERIVED])
def test_bad_derivation_is_refused_by_name(scene: Callable[[], Scene], item: str, phrase: str) -> None:
    with pytest.raises(SceneError) as caught:
        derive(scene().build())
    assert (caught.value.item, caught.value.remedy != "") == (item, True), str(caught.value)
    assert phrase in str(caught.value)

"""Flexible bodies of the plane that are described otherwise: the paper's lumped mesh, and bodies of `symgen.fe`."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from runtime import simulate
from symgen.fe import STEEL, FlexibleBody, LineMesh, Section
from symgen.generate import model_of
from symgen.scene import Scene, SceneError, SceneRecord

ROD = {
    "length": 0.3,
    "density": 7850.0,
    "area": 0.008 * 0.007,
    "second_moment": 0.007 * 0.008**3 / 12,
    "youngs_modulus": 2.1e11,
}


def frequencies(ends: str, elements: int, modes: int = 2, **fields: Any) -> np.ndarray:
    """Of a beam with a lumped mesh [Hz]."""
    scene = Scene("beam").beam(
        "rod", **ROD, mesh="lumped", elements=elements, lateral={"modes": modes, "ends": ends}, **fields
    )
    body: Any = scene.weld("wall", "ground.origin", "rod.start").build().body("rod")
    return np.sqrt(np.diag(np.array(body.K_ff)) / np.diag(np.array(body.M_ff))) / (2 * np.pi)


def exact(root: float) -> float:
    """beta^2 / (2 pi L^2) sqrt(E I / (rho A)) [Hz]."""
    stiffness = np.sqrt(ROD["youngs_modulus"] * ROD["second_moment"] / (ROD["density"] * ROD["area"]))
    return float(root**2 / (2 * np.pi * ROD["length"] ** 2) * stiffness)


def test_a_cantilever_by_masses_at_nodes() -> None:
    """72.199, 73.929, 74.183, 74.247 Hz by 4, 10, 20, 40 elements, exact 74.268: the square of the elements."""
    found = [frequencies("clamped-free", n)[0] for n in (4, 10, 20, 40)]
    assert found == pytest.approx([72.199, 73.929, 74.183, 74.247], abs=6e-4)
    assert exact(1.8751040687) == pytest.approx(74.268, abs=6e-4)
    errors = exact(1.8751040687) - np.array(found)
    assert errors[1] / errors[2] == pytest.approx(4, rel=0.02) and errors[2] / errors[3] == pytest.approx(4, rel=0.02)


@pytest.mark.parametrize(
    "ends, root",
    [
        ("pinned-pinned", np.pi),
        ("clamped-clamped", 4.7300407449),
        ("free-free", 4.7300407449),
        ("clamped-pinned", 3.9266023120),
        ("pinned-free", 3.9266023120),
        ("free-clamped", 1.8751040687),
    ],
)
def test_other_ends(ends: str, root: float) -> None:
    assert frequencies(ends, 80)[0] == pytest.approx(exact(root), rel=2e-3)


def test_stretching() -> None:
    """A bar that is held at its start: (2 k - 1) / (4 L) sqrt(E / rho)."""
    scene = Scene("bar").beam("rod", **ROD, mesh="lumped", elements=100, axial={"modes": 2}, free=True)
    body: Any = scene.build().body("rod")
    found = np.sqrt(np.diag(np.array(body.K_ff))) / (2 * np.pi)
    wave = np.sqrt(ROD["youngs_modulus"] / ROD["density"]) / (4 * ROD["length"])
    assert found == pytest.approx([wave, 3 * wave], rel=1e-3)


def crank(**mesh: Any) -> SceneRecord:
    """A slider-crank with a flexible rod that turns at 150 rad/s."""
    scene = Scene("crank").gravity(0, -9.81)
    scene.rigid("crank", mass=0.2, inertia=1e-3, center_of_mass=(0.05, 0), markers={"pin": {"position": (0.1, 0)}})
    scene.beam("rod", **ROD, lateral={"modes": 2}, damping_ratio=0.01, markers={"middle": {"at": 0.5}}, **mesh)
    scene.rigid("slider", mass=0.5, inertia=1e-3).revolute("a", "ground.origin", "crank.origin")
    scene.revolute("b", "crank.pin", "rod.start").revolute("c", "rod.end", "slider.origin")
    scene.prismatic("rail", "ground.origin", "slider.origin").measure("bent", "y", of="rod.middle")
    return scene.rates({"crank.theta": 150.0}).build()


@pytest.mark.long
def test_a_slider_crank_with_a_mesh() -> None:
    """Its motion goes to that of shapes in closed form with the square of the elements."""
    scenes = [crank(), *(crank(mesh="lumped", elements=n) for n in (10, 20))]
    runs = [simulate(model_of(one), t_end=0.02, tolerance=1e-6, samples=40) for one in scenes]
    first, second = (np.abs(run["bent"] - runs[0]["bent"]).max() for run in runs[1:])
    assert second < 1e-3 * np.abs(runs[0]["bent"]).max() and first / second == pytest.approx(4, rel=0.1)


@pytest.mark.long
def test_a_turning_beam_is_stiffened() -> None:
    """A blade at 500 rad/s under a force at its tip: the mesh bends as shapes in closed form do, some fifth less than
    at rest: w^2 grows by 0.19 W^2 (Southwell)."""
    found = {}
    for name, mesh in {"closed": {}, "mesh": {"mesh": "lumped", "elements": 40}}.items():
        for speed in (0, 500):
            scene = Scene("blade").gravity(0, 0)
            scene.beam("rod", **ROD, stiffening=True, lateral={"modes": 2, "ends": "clamped-free"}, **mesh)
            scene.revolute("hub", "ground.origin", "rod.start").force("push", "rod.end", 0, 1.0, frame="body")
            scene.prescribed_angle("drive", "ground.origin", "rod.start", motion=f"{speed} * t")
            scene.measure("slope", "angle", of="rod.end", relative_to="rod.start")
            found[name, speed] = simulate(model_of(scene.build()), scheme="rk4", dt=1e-5, t_end=0.01)["slope"]
    size = np.abs(found["closed", 500]).max()
    assert np.abs(found["mesh", 500] - found["closed", 500]).max() < 5e-3 * size
    assert size < 0.82 * np.abs(found["closed", 0]).max()


NODES = [(0.3 * k / 20, 0.0, 0.0) for k in range(21)]


def frame(section: Section, **choices: Any) -> FlexibleBody:
    mesh = LineMesh(NODES, [(k, k + 1) for k in range(20)], section)
    ends = {"pin": [0], "slot": [20]}
    given = {"modes": 4, "mode_set": "mixed", "fixed": ["pin"], "origin": "pin", "interface": ends} | choices
    return FlexibleBody.from_mesh(mesh, STEEL, **given)


@pytest.mark.parametrize("choices", [{"mass": "lumped"}, {"stiffening": True}])
def test_a_finite_element_body_in_the_plane(choices: dict[str, Any]) -> None:
    """A pendulum of a frame in a planar scene moves as the same one in space; modes across the plane are left out."""
    fields = frame(Section.rectangle(0.008, 0.007), **choices).fields(damping_ratio=0.01)
    runs = []
    for space, gravity in (("planar", (0, -9.81)), ("spatial", (0, -9.81, 0))):
        scene = Scene("pendulum", space=space).gravity(*gravity).flexible("rod", **fields)
        scene.revolute("hinge", "ground.origin", "rod.pin").measure("tip", "y", of="rod.slot")
        model = model_of(scene.build())
        runs.append(simulate(model, scheme="rk4", dt=1e-5, t_end=2e-3))
        assert sum(name.startswith("rod.q") for name in model.coordinates) == (2 if space == "planar" else 4)
    assert np.abs(runs[0]["tip"] - runs[1]["tip"]).max() < 1e-12


def refused(**fields: Any) -> str:
    scene = Scene("pendulum", space=fields.pop("space", "planar"))
    kind = fields.pop("kind", "beam")
    with pytest.raises(SceneError) as told:
        getattr(scene, kind)("rod", **fields).revolute("hinge", "ground.origin", "rod.origin").build()
    return str(told.value)


def test_what_does_not_fit_is_named() -> None:
    beam = ROD | {"lateral": {"modes": 2}, "mesh": "lumped", "elements": 10}
    for change, problem in (
        ({"elements": None}, "elements: is missing"),
        ({"mesh": "exact"}, "elements: belongs to a mesh"),
        ({"length": "2 * L"}, "length: is not a number"),
        ({"lateral": {"modes": 2, "ends": "welded-welded"}}, "'welded-welded' has static shapes"),
        ({"lateral": {"modes": 10}}, "10 are more than the 9 of the mesh"),
        ({"axial": {"modes": 2, "ends": "fixed-loaded"}, "lateral": None}, "'fixed-loaded' has static shapes"),
        ({"space": "spatial"}, "a lumped mesh of a beam is planar"),
        ({"mesh": "fine"}, "'fine' is not a possible value"),
    ):
        fields = {key: value for key, value in (beam | change).items() if value is not None}
        assert problem in refused(**fields)
    square = frame(Section.rectangle(0.008, 0.007), origin=(0.0, 0.0, 0.001)).fields()
    assert "z = -0.001 is not in the plane" in refused(kind="flexible", **square)
    turned = Section.rectangle(0.008, 0.004, y_axis=(0.0, 1.0, 1.0))
    assert "mode 1 moves in the plane and across it" in refused(kind="flexible", **frame(turned).fields())
    across = frame(Section.rectangle(0.008, 0.004), modes=1).fields()
    assert "no mode moves in the plane" in refused(kind="flexible", **across)
    gauge = {"shapes": [[0.0] * 4] * 6}
    plain = frame(Section.rectangle(0.008, 0.007)).fields()
    assert "gauges: belongs to a body in space" in refused(kind="flexible", **plain, gauges={"skin": gauge})

"""Shapes of rigid bodies: closed surfaces of the right volume, drawn where the body is, refused by name."""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.contract.records import ShapeRecord
from runtime.views.film import film
from runtime.views.mechanism import AROUND, RINGS, Solid, solid
from runtime.views.viewer.record import view_record
from symgen.generate import generate
from symgen.scene import Scene, SceneError, SceneRecord, read_mesh
from symgen.scene.flexible import FlexibleSurface

UPRIGHT = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]
LYING = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]
TETRAHEDRON = {
    "vertices": [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    "triangles": [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]],
}


def volume_and_middle(found: Solid) -> tuple[float, np.ndarray]:
    """By the divergence theorem: sums over tetrahedra from the origin. Positive if all triangles face outward."""
    a, b, c = np.moveaxis(found.vertices[found.triangles], 1, 0)
    parts = np.einsum("ij,ij->i", a, np.cross(b, c)) / 6
    return float(parts.sum()), np.asarray((parts[:, None] * (a + b + c) / 4).sum(axis=0) / parts.sum())


@pytest.mark.parametrize("axes", [UPRIGHT, LYING])
@pytest.mark.parametrize(
    ("shape", "size", "volume"),
    [
        ("box", [0.2, 0.3, 0.5], 0.03),
        ("cylinder", [0.2, 0.5], 0.5 * AROUND / 2 * 0.04 * np.sin(2 * np.pi / AROUND)),  # a prism over a polygon
        ("mesh", [], 1 / 6),
    ],
)
def test_volumes_and_places(shape: str, size: list[float], volume: float, axes: list[list[float]]) -> None:
    more = TETRAHEDRON if shape == "mesh" else {}
    found, middle = volume_and_middle(solid([ShapeRecord("b", shape, [1.0, -2.0, 3.0], axes, size, **more)]))
    assert found == pytest.approx(volume, rel=1e-12)
    offset = np.array(axes) @ ([0.25] * 3 if shape == "mesh" else [0.0] * 3)
    np.testing.assert_allclose(middle, np.array([1.0, -2.0, 3.0]) + offset, atol=1e-12)


def test_a_ball_is_nearly_a_ball_and_closed() -> None:
    ball = solid([ShapeRecord("b", "sphere", [0.0, 0.0, 1.0], UPRIGHT, [0.5])])
    found, middle = volume_and_middle(ball)
    assert 0.97 < found / (4 / 3 * np.pi * 0.125) < 1.0 and len(ball.triangles) == 2 * AROUND * (RINGS - 1)
    np.testing.assert_allclose(middle, [0, 0, 1], atol=1e-12)
    assert np.allclose(np.linalg.norm(ball.edges() - [0, 0, 1], axis=2), 0.5)  # its great circles only


def test_edges_of_a_box_are_twelve() -> None:
    edges = solid([ShapeRecord("b", "box", [0.0] * 3, UPRIGHT, [1.0, 2.0, 3.0])]).edges()
    assert sorted(np.linalg.norm(edges[:, 1] - edges[:, 0], axis=1)) == pytest.approx([1.0] * 4 + [2.0] * 4 + [3.0] * 4)


def disk(**shape: object) -> SceneRecord:
    builder = Scene("disk").ground(shape={"type": "box", "size": [0.4, 0.05, 0.1], "position": [0, -0.5, 0]})
    builder.rigid("wheel", mass=1.0, inertia=0.01, shape=shape)
    return builder.revolute("axle", "ground.origin", "wheel.origin").torque("drive", "wheel.origin", 0.1).build()


def test_a_scene_keeps_its_shapes_and_pictures_show_them(tmp_path: Path) -> None:
    scene = disk(type="cylinder", radius=0.1, length=0.02, position=[0.3, 0, 0])
    assert SceneRecord.from_toml_text(scene.to_toml()) == scene
    run = simulate(load_model(generate(scene, tmp_path)), t_end=1.0, dt=1e-2, scheme="rk4")
    wheel = film(run, frames=3).line("wheel", "outline").xy
    theta = run.interpolate(np.linspace(0.0, 1.0, 3), "q")[
        :, [one.name for one in run.model.description.coordinates].index("wheel.theta")
    ]
    expected = 0.3 * np.column_stack([np.cos(theta), np.sin(theta)])
    np.testing.assert_allclose((np.nanmax(wheel, axis=2) + np.nanmin(wheel, axis=2)) / 2, expected, atol=1e-3)
    record = view_record(run)
    assert [body["mesh"] is not None for body in record["bodies"]] == [True, True] and record["size"] > 0.79


def test_a_mesh_file_beside_the_scene(tmp_path: Path) -> None:
    (tmp_path / "part.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")
    text = (
        disk(type="sphere", radius=0.1)
        .to_toml()
        .replace('type = "sphere", radius = 0.1', 'type = "mesh", file = "part.obj"')
    )
    (tmp_path / "scene.toml").write_text(text)
    scene = SceneRecord.from_toml(tmp_path / "scene.toml")
    assert scene == disk(**read_mesh(tmp_path / "part.obj"))
    outside = text.replace("part.obj", "../part.obj")
    (tmp_path / "scene.toml").write_text(outside)
    with pytest.raises(SceneError, match="not below the scene's folder"):
        SceneRecord.from_toml(tmp_path / "scene.toml")
    (tmp_path / "inner").mkdir()
    (tmp_path / "inner" / "link.obj").symlink_to(tmp_path / "part.obj")
    (tmp_path / "inner" / "scene.toml").write_text(text.replace("part.obj", "link.obj"))
    with pytest.raises(SceneError, match="not below the scene's folder"):
        SceneRecord.from_toml(tmp_path / "inner" / "scene.toml")
    os.mkfifo(tmp_path / "pipe.stl")
    with pytest.raises(SceneError, match="not a regular file"):
        read_mesh(tmp_path / "pipe.stl")
    with pytest.raises(SceneError, match="no known format"):
        read_mesh(tmp_path / "scene.toml")
    (tmp_path / "part.obj").write_text("nothing")
    with pytest.raises(SceneError, match="holds no triangles"):
        read_mesh(tmp_path / "part.obj")


@pytest.mark.parametrize(
    ("shape", "problem"),
    [
        ({"type": "box", "size": [0.1, 0.0, 0.1]}, "greater than 0"),
        ({"type": "sphere"}, "radius"),
        ({"type": "cylinder", "radius": 1.0, "length": 1.0, "axis": [0, 0, 0]}, "axis is zero"),
        ({"type": "box", "size": [1, 1, 1], "x_axis": [0, 0, 2]}, "along it"),
        ({"type": "mesh", "vertices": [[0, 0, 0]], "triangles": [[0, 0, 1]]}, "of 1"),
        ({"type": "mesh", "vertices": [[0, 0, 0]], "triangles": []}, "0 triangles"),
        ({"type": "cone"}, "cone"),
    ],
)
def test_wrong_shapes_are_named(shape: dict[str, object], problem: str) -> None:
    with pytest.raises(SceneError, match=problem) as caught:
        disk(**shape)
    assert "wheel" in caught.value.item and "shape" in caught.value.item


@pytest.mark.parametrize(
    ("vertices", "triangles", "shapes", "fault"),
    [
        (np.zeros((3, 3)), [[0, 1, 2]], np.zeros((3, 3, 2)), ""),
        (np.zeros((3, 3)), [[0, 1, 2]], np.zeros((3, 3, 1)), "hold [9, 9, 0] numbers, for 2 modes"),
        (np.zeros((3, 3)), [[0, 1]], np.zeros((3, 3, 2)), "triangles hold 2 places"),
        (np.zeros((3, 3)), [[0, 1, 3]], np.zeros((3, 3, 2)), "triangles name vertices from 0 to 3 of 3"),
        (np.zeros((60_001, 3)), [[0, 1, 2]], np.zeros((60_001, 3, 2)), "vertices are 60001, more than the corners"),
    ],
)
def test_a_surface_that_does_not_fit_its_body_says_what(
    vertices: np.ndarray, triangles: list[list[int]], shapes: np.ndarray, fault: str
) -> None:
    surface = FlexibleSurface(vertices=vertices, triangles=triangles, shapes=shapes)  # type: ignore[arg-type]
    found = surface.fault(2)
    assert fault in found and bool(fault) == bool(found)

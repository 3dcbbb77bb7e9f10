"""Two or three dimensions: everything in a scene fits its `space`."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from symgen.scene.bodies import BeamBody, MarkerDirections, RigidBody
from symgen.scene.flexible import SpatialModalBody
from symgen.scene.modal import ModalBody
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError


def space_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Vectors with the wrong number of components, and bodies, joints or loads that the other space has."""
    yield from _components("gravity", scene.gravity, scene)
    for index, body in enumerate(scene.bodies):
        path = item_path("bodies", index, body.name)
        yield from _body(body, path, scene)
        for name, marker in body.markers.items():
            yield from _marker(marker, f"{path}.markers.{name}", scene)
    for index, joint in enumerate(scene.joints):
        if scene.space == "planar" and not joint.planar():
            yield SceneError(
                f"{item_path('joints', index, joint.name)}.type",
                f"a {joint.type} joint needs three dimensions",
                _SPATIAL,
            )
    for index, measure in enumerate(scene.measures):
        if measure.type == "z" and scene.space == "planar":
            yield SceneError(f"{item_path('measures', index, measure.name)}.type", "a planar scene has no z", _SPATIAL)
    yield from _joint_names(scene)


def loop_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Joints that need coordinates of their own, such as the turns of a screw, and so must place a body."""
    placing = {placement.joint for placement in scene.placements()}
    for index, joint in enumerate(scene.joints):
        if scene.space == "spatial" and not joint.closes_loops() and joint.name not in placing:
            yield SceneError(
                item_path("joints", index, joint.name),
                f"a {joint.type} joint needs coordinates of its own, and closes a loop of such joints alone",
                "put a joint of another type into the loop: only that can be an equation between two bodies",
            )


_SPATIAL = 'set space = "spatial", or use what a planar scene has'


def _components(path: str, values: tuple[Any, ...], scene: SceneParts) -> Iterator[SceneError]:
    if scene.space == "planar" and len(values) != 2:
        remedy = "give (x, y)" + ("" if len(values) < 2 else ', or set space = "spatial"')
        yield SceneError(path, f"has {len(values)} components in a planar scene", remedy)
    elif scene.space == "spatial" and len(values) not in (2, 3):
        yield SceneError(path, f"has {len(values)} components", "give (x, y, z); a z left out is zero")


def _body(body: Any, path: str, scene: SceneParts) -> Iterator[SceneError]:
    spatial = scene.space == "spatial"
    if isinstance(body, SpatialModalBody) and not spatial:
        yield SceneError(f"{path}.type", "a flexible body needs three dimensions", 'use type = "modal" or "beam"')
    if isinstance(body, ModalBody) and spatial:
        yield SceneError(f"{path}.type", "a modal body is planar", 'use type = "flexible" in a spatial scene')
    if not spatial and getattr(body, "orientation", "euler_parameters") != "euler_parameters":
        yield SceneError(f"{path}.orientation", "a planar body is oriented by its angle theta", "remove it")
    if isinstance(body, RigidBody):
        yield from _rigid(body, path, scene)
    if isinstance(body, BeamBody):
        given = body.lateral_z is not None or body.second_moment_z != 0
        if given and not spatial:
            yield SceneError(f"{path}.lateral_z", "a planar beam bends in its plane only", _SPATIAL)
        if spatial and body.second_moment_z == 0:
            yield SceneError(f"{path}.second_moment_z", "is missing", "give the second moment of area for the xz-plane")
        yield from _torsion(body, path, spatial)


def _torsion(body: BeamBody, path: str, spatial: bool) -> Iterator[SceneError]:
    quantities = {
        "shear_modulus": "give the shear modulus, E / (2 (1 + nu)) of an isotropic material",
        "torsion_constant": "give the torsion constant of the section",
    }
    if body.torsion is not None and not spatial:
        yield SceneError(f"{path}.torsion", "a planar beam does not twist", _SPATIAL)
    for key, remedy in quantities.items():
        if body.torsion is not None and spatial and getattr(body, key) == 0:
            yield SceneError(f"{path}.{key}", "is missing, which torsion needs", remedy)


def _rigid(body: RigidBody, path: str, scene: SceneParts) -> Iterator[SceneError]:
    three = isinstance(body.inertia, tuple)
    if three != (scene.space == "spatial"):
        yield SceneError(
            f"{path}.inertia",
            f"a {scene.space} body has {'one moment' if three else 'three moments'} of inertia",
            "give one number" if three else "give the moments about x, y, z: [xx, yy, zz]",
        )
    if len(body.products) != 3:
        yield SceneError(f"{path}.products", f"has {len(body.products)} entries", "give the entries xy, xz, yz")
    elif scene.space == "planar" and any(value != 0 for value in body.products):
        yield SceneError(f"{path}.products", "a planar body has no products of inertia", "remove it")
    yield from _components(f"{path}.center_of_mass", body.center_of_mass, scene)


def _marker(marker: Any, path: str, scene: SceneParts) -> Iterator[SceneError]:
    position = getattr(marker, "position", None)
    if position is not None:
        yield from _components(f"{path}.position", position, scene)
    if not isinstance(marker, MarkerDirections):
        return
    turned = marker.axis != (0.0, 0.0, 1.0) or marker.x_axis is not None
    if scene.space == "planar" and turned:
        yield SceneError(
            f"{path}.axis", "a planar marker is turned by its angle", 'give angle, or set space = "spatial"'
        )
    if scene.space == "spatial":
        if marker.angle != 0:
            yield SceneError(f"{path}.angle", "a spatial marker is turned by its axes", "give axis and x_axis")
        yield from _directions(marker, path)


def _directions(marker: MarkerDirections, path: str) -> Iterator[SceneError]:
    z, x = marker.axis, marker.x_axis
    if all(entry == 0 for entry in z):
        yield SceneError(f"{path}.axis", "has no direction", "give a vector that is not zero")
    elif x is not None:
        cross = (z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0])
        size = max(abs(entry) for entry in z) * max(abs(entry) for entry in x)
        if max(abs(entry) for entry in cross) <= 1e-9 * size:
            yield SceneError(f"{path}.x_axis", "is along the axis, or zero", "give a direction across it")


def _joint_names(scene: SceneParts) -> Iterator[SceneError]:
    """Coordinates of joints and of bodies share their names."""
    if scene.space == "planar" or scene.structure is not None:
        return
    bodies = {body.name for body in scene.bodies}
    for index, joint in enumerate(scene.joints):
        if joint.name in bodies:
            yield SceneError(
                item_path("joints", index, joint.name),
                "has the name of a body",
                "rename one of them: joints of a spatial scene have coordinates too",
            )

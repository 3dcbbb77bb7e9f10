"""Matrices: symmetric, positive definite, skew, as mechanics demands; at the parameters' defaults."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from symgen.scene.bodies import RigidBody
from symgen.scene.flexible import SpatialModalBody
from symgen.scene.modal import ModalBody
from symgen.scene.parts import SceneParts
from symgen.scene.translate import item_path
from symgen.schema.errors import SceneError
from symgen.schema.fields import Matrix, Vector

Array = NDArray[np.float64]
TOLERANCE = 1e-9


def matrix_errors(scene: SceneParts) -> Iterator[SceneError]:
    """Matrices of modal bodies and of a structure that no mechanical system can have."""
    if scene.structure is not None:
        mass = _array(scene, scene.structure.mass)
        yield from _symmetric("structure.mass", mass) or _definite("structure.mass", mass)
        yield from _symmetric("structure.stiffness", _array(scene, scene.structure.stiffness))
    for index, body in enumerate(scene.bodies):
        if isinstance(body, ModalBody):
            yield from _modal(scene, body, item_path("bodies", index, body.name))
        elif isinstance(body, SpatialModalBody):
            yield from _flexible(scene, body, item_path("bodies", index, body.name))
        elif isinstance(body, RigidBody) and isinstance(body.inertia, tuple):
            yield from _inertia(scene, body, item_path("bodies", index, body.name))


def _modal_matrices(scene: SceneParts, body: ModalBody | SpatialModalBody, path: str) -> Iterator[SceneError]:
    """M_ff, K_ff and D_ff as mechanics demands."""
    mass = _array(scene, body.M_ff)
    yield from _symmetric(f"{path}.M_ff", mass) or _definite(f"{path}.M_ff", mass)
    for key in ("K_ff", "D_ff"):
        if (given := getattr(body, key)) is not None:
            value = _array(scene, given)
            yield from _symmetric(f"{path}.{key}", value) or _semidefinite(f"{path}.{key}", value)


def _modal(scene: SceneParts, body: ModalBody, path: str) -> Iterator[SceneError]:
    yield from (bad := list(_modal_matrices(scene, body, path)))
    cross = _array(scene, body.phi_cross_phi)
    if _differs(cross, -cross.T):
        yield SceneError(f"{path}.phi_cross_phi", "is not skew-symmetric", "entry [a][b] must be minus entry [b][a]")
    if not bad and not _is_definite(_body_mass_matrix(scene, body), -TOLERANCE):
        yield SceneError(
            path,
            "its mass matrix (mass, first_moment, inertia, phi_integral, ...) is not positive definite",
            "check the integrals: they must belong to one mass distribution, taken about the frame origin",
        )
    named = {f"markers.{name}.foreshortening": marker.foreshortening for name, marker in body.markers.items()}
    if body.foreshortening is not None:
        named |= {"foreshortening.H": body.foreshortening.H, "foreshortening.xH": body.foreshortening.xH}
    for key, given in named.items():
        if given is not None:
            yield from _symmetric(f"{path}.{key}", _array(scene, given))


def _flexible(scene: SceneParts, body: SpatialModalBody, path: str) -> Iterator[SceneError]:
    yield from (bad := list(_modal_matrices(scene, body, path)))
    moments = _array(scene, body.inertia_moments)
    bad_moments = _symmetric(f"{path}.inertia_moments", moments)
    yield from bad_moments
    if not bad and not bad_moments and not _is_definite(_spatial_mass_matrix(scene, body, moments), -TOLERANCE):
        yield SceneError(
            path,
            "its mass matrix (mass, first_moment, inertia_moments, phi_integral, ...) is not positive definite",
            "check the integrals: they must belong to one mass distribution, taken about the frame origin",
        )


def _spatial_mass_matrix(scene: SceneParts, body: SpatialModalBody, moments: Array) -> Array:
    """The (6 + nf) x (6 + nf) mass matrix of Eq. 20 at q_f = 0, in body axes."""
    matrix = np.zeros((6 + body.nf, 6 + body.nf))
    x, y, z = _array(scene, body.first_moment)
    matrix[:3, :3] = _array(scene, (body.mass,))[0] * np.eye(3)
    matrix[:3, 3:6] = -np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    matrix[3:6, 3:6] = np.trace(moments) * np.eye(3) - moments
    if body.phi_integral:
        matrix[:3, 6:] = _array(scene, body.phi_integral)
    for a, block in enumerate(np.array(body.rho_phi, dtype=float)):
        matrix[3:6, 6 + a] = [block[1, 2] - block[2, 1], block[2, 0] - block[0, 2], block[0, 1] - block[1, 0]]
    matrix[3:, :3], matrix[6:, 3:6] = matrix[:3, 3:].T, matrix[3:6, 6:].T
    matrix[6:, 6:] = _array(scene, body.M_ff)
    return matrix


def _inertia(scene: SceneParts, body: RigidBody, path: str) -> Iterator[SceneError]:
    """An inertia tensor is positive semi-definite, and no principal moment exceeds the sum of the two others."""
    assert isinstance(body.inertia, tuple)
    (xx, yy, zz), (xy, xz, yz) = _array(scene, body.inertia), _array(scene, body.products)
    principal = np.linalg.eigvalsh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
    slack = TOLERANCE * max(float(np.abs(principal).max()), 1e-300)
    if principal[0] < -slack or principal[2] > principal[0] + principal[1] + slack:
        yield SceneError(
            f"{path}.inertia",
            f"no body has these moments of inertia (principal ones {', '.join(f'{value:.4g}' for value in principal)})",
            "check units and signs; each must be at most the sum of the other two",
        )


def _body_mass_matrix(scene: SceneParts, body: ModalBody) -> Array:
    """The (3 + nf) x (3 + nf) mass matrix of Eq. 20 at theta = 0, q_f = 0."""
    mass, inertia, moment_x, moment_y = _array(scene, (body.mass, body.inertia, *body.first_moment))
    matrix = np.zeros((3 + body.nf, 3 + body.nf))
    matrix[:3, :3] = [[mass, 0, -moment_y], [0, mass, moment_x], [-moment_y, moment_x, inertia]]
    matrix[:2, 3:] = _array(scene, body.phi_integral)
    matrix[2, 3:] = _array(scene, body.rho_cross_phi)
    matrix[3:, :3] = matrix[:3, 3:].T
    matrix[3:, 3:] = _array(scene, body.M_ff)
    return matrix


def _array(scene: SceneParts, given: Matrix | Vector) -> Array:
    defaults = scene.parameter_defaults()

    def number(entry: object) -> object:
        if isinstance(entry, tuple):
            return [number(part) for part in entry]
        return entry if isinstance(entry, float) else scene.expression(str(entry), "matrix").evaluate(defaults)

    return np.array(number(given), dtype=float)


def _differs(a: Array, b: Array) -> bool:
    largest = max(float(np.abs(a).max(initial=0.0)), 1e-300)
    return bool(np.abs(a / largest - b / largest).max(initial=0.0) > TOLERANCE)


def _symmetric(path: str, value: Array) -> list[SceneError]:
    if _differs(value, value.T):
        row, column = np.unravel_index(np.argmax(np.abs(value / 2 - value.T / 2)), value.shape)
        entries = f"[{row}][{column}] = {value[row, column]!r}, [{column}][{row}] = {value[column, row]!r}"
        return [SceneError(path, f"is not symmetric ({entries})", "make the matrix symmetric")]
    return []


def _definite(path: str, value: Array) -> list[SceneError]:
    if _is_definite(value, TOLERANCE):
        return []
    return [SceneError(path, "is not positive definite", "check signs and units; every mode needs a positive mass")]


def _semidefinite(path: str, value: Array) -> list[SceneError]:
    if _is_definite(value, -TOLERANCE):
        return []
    return [SceneError(path, "has a negative eigenvalue", "check signs; the matrix must be positive semi-definite")]


def _is_definite(value: Array, least: float) -> bool:
    """Whether all eigenvalues of the matrix, scaled to a unit diagonal, exceed ``least``.

    Scaling makes the answer independent of the units of the coordinates. A zero on the diagonal
    needs a zero row.
    """
    diagonal = value.diagonal().copy()
    empty = (diagonal == 0) & ~value.any(axis=1)
    if least >= 0 and empty.any():
        return False
    diagonal[empty] = 1.0
    if (diagonal <= 0).any():
        return False
    root = np.sqrt(diagonal)
    with np.errstate(over="ignore", invalid="ignore"):
        scaled = value / root[:, None] / root[None, :]
    if not np.isfinite(scaled).all() or np.abs(scaled).max(initial=0.0) > 1e6:
        return False
    symmetric = (scaled + scaled.T) / 2
    return bool(np.linalg.eigvalsh(symmetric).min(initial=np.inf) > least)

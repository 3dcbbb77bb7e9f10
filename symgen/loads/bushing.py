"""Bushing: springs and dampers along and about the axes of a marker (space)."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Annotated, Any, Literal

from symgen.joints.joint import Surroundings
from symgen.loads.load import Acting, Load, LoadEffect
from symgen.schema.fields import Bound, Fault, MarkerRef, Meaning, Quantity, about

TRIPLES = ("stiffness", "damping", "rotational_stiffness", "rotational_damping")


class Bushing(Load):
    """Springs and dampers along and about marker a's axes on the displacement and small rotation of b (spatial).

    stiffness [N/m], damping [N s/m], rotational_stiffness [N m/rad], rotational_damping [N m s/rad]: three each.
    """

    type: Literal["bushing"] = "bushing"
    marker_a: Annotated[MarkerRef, about('marker a, `"body.marker"`; its axes are those of the bushing')]
    marker_b: Annotated[MarkerRef, about('marker b, `"body.marker"`')]
    stiffness: Annotated[
        tuple[Quantity, ...], Meaning("stiffness along x, y, z", "N/m", Bound.NON_NEGATIVE)
    ] = (0.0, 0.0, 0.0)  # fmt: skip
    damping: Annotated[
        tuple[Quantity, ...], Meaning("damping along x, y, z", "N s/m", Bound.NON_NEGATIVE)
    ] = (0.0, 0.0, 0.0)  # fmt: skip
    rotational_stiffness: Annotated[
        tuple[Quantity, ...], Meaning("stiffness about x, y, z", "N m/rad", Bound.NON_NEGATIVE)
    ] = (0.0, 0.0, 0.0)  # fmt: skip
    rotational_damping: Annotated[
        tuple[Quantity, ...], Meaning("damping about x, y, z", "N m s/rad", Bound.NON_NEGATIVE)
    ] = (0.0, 0.0, 0.0)  # fmt: skip

    def effect(self, m: Acting) -> LoadEffect:
        """The rotation is the axial vector of the relative rotation matrix, sin(angle) times its axis; force and moment
        are the gradient of the stored energy, so nothing is gained or lost at large rotations."""
        a, b = m.pair(self.marker_a, self.marker_b)
        d = [of_b - of_a for of_b, of_a in zip(b.r, a.r, strict=True)]
        travel = [m.dot(axis, d) for axis in a.axes]
        cosines = [[m.dot(mine, other) for other in b.axes] for mine in a.axes]
        turn = [(cosines[k][j] - cosines[j][k]) / 2 for j, k in ((1, 2), (2, 0), (0, 1))]
        values = [*travel, *turn]
        rates = [m.rate(value) for value in values]
        k = [*m.constant("stiffness"), *m.constant("rotational_stiffness")]
        c = [*m.constant("damping"), *m.constant("rotational_damping")]
        potential = sum(one * value**2 / 2 for one, value in zip(k, values, strict=True))
        dissipated = sum(one * rate**2 for one, rate in zip(c, rates, strict=True))
        row = {column: -slope for column, slope in m.by_q(potential).items()}
        for column, slope in m.by_rates(dissipated).items():
            row[column] = row.get(column, 0) - 0.5 * slope
        pulls = [-(s * value + d * rate) for s, d, value, rate in zip(k, c, values, rates, strict=True)]
        force = m.along(a, pulls[:3])
        axes = _rotation_axes(a, b)
        moment = [sum(pull * axis[i] for pull, axis in zip(pulls[3:], axes, strict=True)) for i in range(3)]
        return LoadEffect(row, potential=potential, dissipated=dissipated, action=m.action(force, moment))

    def faults(self, scene: Surroundings) -> Iterator[Fault]:
        """Planar scenes, and triples that are none."""
        if scene.space == "planar":
            remedy = "use a spring_damper and a rotational_spring_damper"
            yield Fault("type", "a bushing needs three dimensions", remedy)
        for key in TRIPLES:
            if len(getattr(self, key)) != 3:
                yield Fault(key, f"has {len(getattr(self, key))} entries", "give three, for x, y and z")


def _rotation_axes(a: Any, b: Any) -> list[list[Any]]:
    """d(turn_i) = axis_i . d(phi) for a small rotation d(phi) of marker b: (b_j x a_k - b_k x a_j) / 2."""

    def cross(u: Sequence[Any], v: Sequence[Any]) -> list[Any]:
        return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]

    return [
        [(p - q) / 2 for p, q in zip(cross(b.axes[j], a.axes[k]), cross(b.axes[k], a.axes[j]), strict=True)]
        for j, k in ((1, 2), (2, 0), (0, 1))
    ]

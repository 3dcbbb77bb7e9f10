"""What a scene is told of a finite-element body: numbers and lists."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from runtime.contract.records import packed
from symgen.fe.errors import FiniteElementError
from symgen.fe.inertia import InertiaIntegrals
from symgen.fe.stress_stiffness import StressStiffening
from symgen.modes.cleaning import Array


@dataclass(frozen=True, eq=False)
class Marker:
    """An interface on the body: position (3,) [m] from the origin; shape, rotation (3, nf): per unit of q_f."""

    position: Array
    shape: Array
    rotation: Array


def modal_fields(
    these: InertiaIntegrals,
    eigenvalues: Array,
    markers: Mapping[str, Marker],
    stiffening: StressStiffening | None,
    damping_ratio: float | Sequence[float],
    surface: Mapping[str, Array],
) -> dict[str, Any]:
    """See `FlexibleBody.fields`; surface: its arrays, none for no surface. Raises FiniteElementError."""
    ratios = np.asarray(damping_ratio, dtype=np.float64)
    if ratios.shape not in ((), eigenvalues.shape) or not np.all(np.isfinite(ratios)) or np.any(ratios < 0.0):
        raise FiniteElementError(
            "damping_ratio",
            f"{damping_ratio!r} is not a ratio of 0 or more, or one per mode",
            f"give one number or {len(eigenvalues)}",
        )
    arrays = {
        "first_moment": these.first_moment,
        "inertia_moments": these.moments,
        "M_ff": these.M_ff,
        "K_ff": np.diag(eigenvalues),
        "D_ff": np.diag(2.0 * ratios * np.sqrt(eigenvalues)),
        "phi_integral": these.phi_integral,
        "rho_phi": these.rho_phi,
        "phi_phi": these.phi_phi,
    }
    places: dict[str, dict[str, Any]] = {
        name: {"position": one.position.tolist(), "shape": one.shape.tolist(), "rotation": one.rotation.tolist()}
        for name, one in markers.items()
    }
    fields = {"mass": these.mass, **{key: array.tolist() for key, array in arrays.items()}, "markers": places}
    if stiffening is not None:
        fields["stiffening"] = {"H": stiffening.H.tolist(), "xH": stiffening.xH.tolist()}
        for name, marker in places.items():
            marker["foreshortening"] = stiffening.at[name].tolist()
    if surface:
        kinds = {key: "<i4" if key == "triangles" else "<f4" for key in surface}
        fields["surface"] = {key: packed(array, kinds[key]) for key, array in surface.items()}
    return fields

"""The surface of a flexible body for pictures: triangles that move with the modes, and their stresses."""

from __future__ import annotations

from typing import Annotated, Any

import numpy as np
from pydantic import BeforeValidator

from runtime.contract.records import packed, unpacked
from symgen.scene.appearance import MOST_TRIANGLES
from symgen.schema.fields import StrictModel, refuse

REMEDY = "take what FlexibleBody.surface gives"


def _as_text(kind: str) -> Any:
    """Arrays and lists of numbers as packed text, as a scene file holds them; text is seen to hold numbers."""

    def text(value: object) -> str:
        try:
            numbers = unpacked(value, kind) if isinstance(value, str) else np.asarray(value, dtype=kind)
        except (TypeError, ValueError, OverflowError):
            raise refuse("is neither numbers nor their packed text", REMEDY) from None
        if not np.isfinite(numbers).all():
            raise refuse("holds numbers that are not finite", REMEDY)
        return packed(numbers, kind)

    return BeforeValidator(text)


Numbers = Annotated[str, _as_text("<f4")]
Places = Annotated[str, _as_text("<i4")]


class FlexibleSurface(StrictModel):
    """Arrays, kept as text (base64 of float32 and int32): vertices (n, 3) [m] in the body frame; triangles (m, 3),
    places of vertices; shapes (n, 3, nf) per unit of q_f; stresses (n, 6, nf), xx yy zz yz xz xy [Pa] per unit of
    q_f, or left out where they are not known.
    """

    vertices: Numbers
    triangles: Places
    shapes: Numbers
    stresses: Numbers = ""

    def fault(self, nf: int) -> str:
        """What does not fit a body with nf modes; "" if all does."""
        sizes = {key: len(unpacked(getattr(self, key))) for key in ("vertices", "shapes", "stresses")}
        places, n = unpacked(self.triangles, "<i4"), sizes["vertices"] // 3
        if sizes["vertices"] != 3 * n or sizes["shapes"] != 3 * n * nf or sizes["stresses"] not in (0, 6 * n * nf):
            return f"vertices, shapes and stresses hold {list(sizes.values())} numbers, for {nf} modes"
        if n > 3 * MOST_TRIANGLES:
            return f"vertices are {n}, more than the corners of {MOST_TRIANGLES} triangles"
        if len(places) % 3 or not 3 <= len(places) <= 3 * MOST_TRIANGLES:
            return f"triangles hold {len(places)} places: three for each, of 1 to {MOST_TRIANGLES} triangles"
        if places.min() < 0 or places.max() >= n:
            return f"triangles name vertices from {places.min()} to {places.max()} of {n}"
        return ""

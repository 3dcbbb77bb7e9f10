"""Points to draw: a polyline per body, with the deformation scaled by an exaggeration factor."""

from __future__ import annotations

import casadi as ca

from symgen.kernels.kernel import Kernel
from symgen.system.equations import Equations


def drawing(equations: Equations) -> Kernel:
    """xy (2 x points) or xyz (3 x points) of all polylines in turn; the manifest's `outlines` say how many each has."""
    exaggeration = ca.SX.sym("exaggeration")
    scaled = ca.vertcat(
        *(
            value * exaggeration if column in equations.elastic_columns else value
            for column, value in enumerate(equations.q)
        )
    )
    columns = [ca.vertcat(*point) for outline in equations.outlines for point in outline.points]
    points = ca.horzcat(*columns) if columns else ca.SX(2, 0)
    q = ca.vertcat(*equations.q)
    drawn = ca.substitute(points, q, scaled)
    return Kernel({"q": q, "exaggeration": exaggeration, "t": equations.t}, {"xyz"[: points.shape[0]]: drawn})

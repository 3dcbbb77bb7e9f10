"""What pictures are made of: the pose of each body as a function of q, and its points as functions of p."""

from __future__ import annotations

import casadi as ca

from symgen.kernels.kernel import Kernel
from symgen.system.equations import Equations


def poses(equations: Equations) -> Kernel:
    """(12 x bodies): origin r [m], then the columns of A, of each body that moves; a planar one in the xy-plane."""
    columns = [
        ca.vertcat(*r, *(A[i][j] for j in range(3) for i in range(3))) for r, A in equations.picture.poses.values()
    ]
    return Kernel({"q": ca.vertcat(*equations.q)}, {"poses": ca.horzcat(*columns) if columns else ca.SX(12, 0)})


def geometry(equations: Equations, p: ca.SX) -> Kernel:
    """The points of the manifest's `drawing` in turn, in body axes, as functions of the parameters.

    positions (3 x points) [m]; axes (9 x points): columns of the marker's rotation; shapes, turns (3 x modes of each
    point's body): displacement and rotation by each mode; H: nf x nf of each point that has it [1/m]; sections
    (2 x beams): height and width [m]; rigidities (2 x beams): E I [N m^2].
    """
    points, sections = equations.picture.points, equations.picture.sections.values()

    def columns(rows: int, vectors: list[list[ca.SX]]) -> ca.SX:
        return ca.horzcat(*(ca.vertcat(*vector) for vector in vectors)) if vectors else ca.SX(rows, 0)

    outputs = {
        "positions": columns(3, [point.position for point in points]),
        "axes": columns(9, [[point.axes[i][j] for j in range(3) for i in range(3)] for point in points]),
        "shapes": columns(3, [shape for point in points for shape in point.shapes]),
        "turns": columns(3, [turn for point in points for turn in point.turns]),
        "H": columns(1, [[value] for point in points for row in point.H for value in row]),
        "sections": columns(2, [list(section) for section in sections]),
        "rigidities": columns(2, list(equations.picture.rigidities.values())),
    }
    return Kernel({"p": p}, {name: value for name, value in outputs.items() if value.numel()})

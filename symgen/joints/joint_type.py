"""What planar and spatial joint types share: labelled rows with a template, and the prescribed motion f(t)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from runtime.contract.records import ConstraintKind
from symgen.algebra.template import Template

# What the rows of joints and bodies measure, by the label that the joint gives them.
ROW_KINDS: dict[str, ConstraintKind] = {
    **dict.fromkeys(("x", "y", "z", "normal", "across_x", "across_y", "travel", "length"), "distance"),
    **dict.fromkeys(("parallel_x", "parallel_y", "twist", "cross"), "direction"),
    **dict.fromkeys(("e0", "e1", "e2", "e3"), "quaternion"),
    "angle": "angle",
    "norm": "norm",
}
f, f_t, f_tt = sp.symbols("f f_t f_tt")


@dataclass(frozen=True)
class JointType:
    """A joint type: the labels of its rows and its template.

    Outputs of row k: C_k; C_k_<slot> for the slots of the markers; C_t_k; drift_k, the second time derivative of C_k
    with all marker accelerations zero, so that gamma_k = -drift_k - C_slot . bias of the markers.
    """

    labels: tuple[str, ...]
    template: Template

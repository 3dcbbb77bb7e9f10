"""What planar and spatial joint types share: labelled rows with a template, and the prescribed motion f(t)."""

from __future__ import annotations

from dataclasses import dataclass

import sympy as sp

from symgen.algebra.template import Template

f, f_t, f_tt = sp.symbols("f f_t f_tt")


@dataclass(frozen=True)
class JointType:
    """A joint type: the labels of its rows and its template.

    Outputs of row k: C_k; C_k_<slot> for the slots of the markers; C_t_k; drift_k, the second time derivative of C_k
    with all marker accelerations zero, so that gamma_k = -drift_k - C_slot . bias of the markers.
    """

    labels: tuple[str, ...]
    template: Template

"""Multipliers and joint forces of saved states; with redundant constraints those of least norm.

Redundant rows leave the multipliers open by C_q^T N = 0: each choice gives the same motion. The one taken here has
the least sum of squares, and the joint forces are those that go with it.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from runtime.contract.model import Model
from runtime.results.sampling import evaluate


def joint_reactions(
    model: Model, values: Mapping[str, np.ndarray], C_q: np.ndarray, c: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """(lam (N, n_c), world forces and moments of the joints (N, joints, 3)) at N states.

    values: q, q_dot, q_ddot and t, samples by rows; C_q (N, n_c n), flattened column by column.
    """
    kernel, n = model.kernel("reactions"), len(values["q"])
    given = {**values, "lam_R": np.zeros((n, len(model.redundant)))}
    found = evaluate(kernel, given, c)
    if model.redundant:
        jacobians = C_q.reshape(n, len(model.coordinates), len(model.constraints)).transpose(0, 2, 1)
        least = least_norm(found["lam"], jacobians, len(model.kept_rows))
        found = evaluate(kernel, {**given, "lam_R": least[:, model.redundant_rows]}, c)
    return found["lam"], found["joint_forces"].reshape(n, len(model.joints), kernel.size1_out("joint_forces"))


def least_norm(lam: np.ndarray, C_q: np.ndarray, rank: int) -> np.ndarray:
    """lam (N, n_c) without what C_q^T (C_q: N, n_c, n) maps to zero; rank: number of independent rows."""
    kept = np.linalg.svd(C_q, full_matrices=False)[0][:, :, :rank]
    return np.asarray(np.einsum("sik,sjk,sj->si", kept, kept, lam))

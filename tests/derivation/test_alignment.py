"""Frames that stand where a tree costs fewer operations: a rewrite that changes no value and pays."""

from __future__ import annotations

import casadi as ca
import numpy as np
import pytest

from benchmarks.cases.rhs_pinocchio import skew_tree
from runtime.contract.tape import as_function
from symgen.pipeline import Derived, derive
from symgen.system.frames import alignment

ONLY = frozenset({"condensed"})


def condensed(derived: Derived, q: np.ndarray, q_dot: np.ndarray) -> np.ndarray:
    """M_hat and Q_hat at default parameters, one below the other."""
    p = np.array([entry.default for entry in derived.parameters])
    c = as_function("constants", derived.tapes["constants"])(p)
    kernel = as_function("condensed", derived.tapes["condensed"])
    found = kernel.call({"q_i": q, "q_i_dot": q_dot, "c": c})
    return np.asarray(ca.vertcat(found["M_hat"], found["Q_hat"].T))


def test_alignment_changes_no_value(monkeypatch: pytest.MonkeyPatch) -> None:
    """M_hat and Q_hat of eight bodies on skew hinges, with frames where the joints are: 55 % more operations."""
    scene, rng = skew_tree().scene, np.random.default_rng(7)
    aligned = derive(scene, ONLY)
    monkeypatch.setattr(alignment, "give_to_parent", lambda frame, frames: None)
    monkeypatch.setattr(alignment, "between_hinges", None)
    monkeypatch.setattr(alignment._Alignment, "_straight", lambda self, link: True)
    plain = derive(scene, ONLY)
    for _ in range(3):
        q, q_dot = rng.normal(size=(2, 8))
        expected = condensed(plain, q, q_dot)
        assert np.allclose(condensed(aligned, q, q_dot), expected, rtol=0, atol=1e-12 * np.abs(expected).max())
    assert plain.tapes["condensed"].operations > 1.5 * aligned.tapes["condensed"].operations

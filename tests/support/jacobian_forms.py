"""The forms of residual Jacobians that a scene has, before the shortest one is kept."""

from __future__ import annotations

from collections.abc import Sequence

import casadi as ca
import numpy as np
import pytest

from symgen.condensed.condensation import Condensed
from symgen.kernels import jacobians
from symgen.pipeline import derive
from symgen.scene import SceneRecord
from symgen.system.build import build_system


def values_of_forms(
    scene: SceneRecord, monkeypatch: pytest.MonkeyPatch, at_start: bool = False
) -> list[list[np.ndarray]]:
    """[J_q, J_v] of each form at the scene's parameters and random values, or at its start and random accelerations."""
    forms: list[tuple[ca.SX, ca.SX]] = []
    whole = jacobians.held_jacobians

    def kept(system: Condensed, q_i_ddot: Sequence[ca.SX]) -> list[tuple[ca.SX, ca.SX]]:
        forms.extend(whole(system, q_i_ddot))
        return forms

    monkeypatch.setattr(jacobians, "held_jacobians", kept)
    derived = derive(scene, frozenset({"residual_jacobian"}))
    parts = [part for form in forms for part in form]
    symbols = ca.symvar(ca.horzcat(*parts))
    function = ca.Function("forms", [ca.vertcat(*symbols)], parts)
    table, rng = build_system(scene).parameters, np.random.default_rng(0)
    given = {str(own): entry.default for own, entry in zip(ca.vertsplit(table.vector()), table.entries, strict=True)}
    eq, start = derived.system.reduced, derived.initial
    for symbols_of, values in ((eq.q, start.q), (eq.q_dot, start.q_dot)) if at_start else ():
        given |= {str(own): value for own, value in zip(symbols_of, values, strict=False)}
    drawn = {name: 0.4 * rng.normal() for name in sorted(map(str, symbols))}
    found = [np.asarray(value) for value in function([given.get(str(one), drawn[str(one)]) for one in symbols])]
    return [found[k : k + 2] for k in range(0, len(found), 2)]


def assert_equal_forms(forms: list[list[np.ndarray]]) -> None:
    """Two forms with the same values to rounding."""
    eliminated, other = forms
    for expected, found in zip(eliminated, other, strict=True):
        assert np.max(np.abs(found - expected)) <= 1e-13 * np.max(np.abs(expected)) > 0

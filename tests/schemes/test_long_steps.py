"""A long explicit step calls one stage for all its evaluations: the same motion as with each of them written out."""

from __future__ import annotations

import numpy as np
import pytest

from runtime import load_model
from runtime.engine.program import Sequence
from runtime.schemes import runge_kutta
from runtime.schemes.catalogue import scheme_kind
from symgen.scenes import generated_folder

SAME = 1e-13  # relative: reciprocals are shared within a stage


@pytest.mark.every_push("chain-dop853")
@pytest.mark.parametrize("scheme", ["rk4", "dop853"])
@pytest.mark.parametrize("name", ["slider_crank", "double_pendulum", "spatial_chain", "chain"])
def test_one_stage_for_all_evaluations_moves_as_copies_of_it(
    name: str, scheme: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    runs, parts = [], []
    for limit in (runge_kutta.LONG_STEP, 0):
        monkeypatch.setattr(runge_kutta, "LONG_STEP", limit)
        model = load_model(generated_folder(name))
        program = scheme_kind(scheme).build(scheme, model, 1e-4, None, {}).program()
        parts.append(len(program.parts) if isinstance(program, Sequence) else 1)
        runs.append(model.simulate(t_end=0.00205, dt=1e-4, scheme=scheme, engine="interpreted"))
    written_out, called = runs
    stages = {"rk4": 4, "dop853": 12}[scheme]
    assert parts == [1, 2 * stages + 1]
    assert called.status.name == written_out.status.name == "completed"
    for found, wanted in ((called.q, written_out.q), (called.q_dot, written_out.q_dot)):
        assert np.abs(found - wanted).max() <= SAME * max(1.0, np.abs(wanted).max())

"""Long stages: shared by the preparation with the same bits, and refused where they cannot be written out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from runtime import SchemeError, Solution, load_model, simulate
from runtime.engine import prepare, program
from runtime.engine.llvm_code import program_length
from runtime.schemes import linear_propagation
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from symgen.scenes import generated_folder


@pytest.mark.parametrize("scheme", ["rk4", "exponential"])
def test_what_stands_twice_is_shared_with_the_same_bits(
    scheme: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    model = load_model(generated_folder("hub_beam"))

    def run() -> tuple[Solution, int]:
        monkeypatch.setenv(
            "SYMGEN_CACHE", str(tmp_path / f"{program.LONG_STAGE_NODES}-{prepare.LONG_STAGE_NODES}")
        )  # a step that is kept is read
        stepper = Stepper(scheme_kind(scheme).build(scheme, model, 1e-3, None, {}), "interpreted")
        return simulate(model, t_end=0.02, scheme=scheme, engine="interpreted"), program_length(stepper.program)

    wanted, usual = run()
    monkeypatch.setattr(program, "LONG_STAGE_NODES", 0)
    _, unshared = run()
    monkeypatch.setattr(prepare, "LONG_STAGE_NODES", 0)
    found, shared = run()
    assert np.array_equal(found.q, wanted.q) and np.array_equal(found.q_dot, wanted.q_dot)
    assert shared <= usual < unshared


@pytest.mark.parametrize("scheme", ["exponential", "radau"])
def test_factors_too_long_to_be_written_out_are_refused(
    scheme: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))  # where no pattern is kept
    monkeypatch.setattr(linear_propagation, "MOST_FACTOR_OPERATIONS", 20)
    with pytest.raises(SchemeError, match="4 independent coordinates.*operations a step.*take .*single_rate"):
        simulate(load_model(generated_folder("hub_beam")), t_end=0.01, dt=1e-3, scheme=scheme, m=None)

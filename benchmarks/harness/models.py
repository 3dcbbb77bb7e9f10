"""Scenes as loaded models and compiled programs, in temporary folders that are removed at the end."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import casadi as ca

from runtime.engine.program import Call, Fields, Layout, make_stage
from runtime.model import Model, load_model
from runtime.schemes.stage_equations import StageEquations
from symgen.generate import generate
from symgen.scene import SceneRecord


@contextmanager
def workplace() -> Iterator[Path]:
    """A folder for models, with an empty cache of compiled programs in it."""
    before = os.environ.get("SYMGEN_CACHE")
    with tempfile.TemporaryDirectory() as folder:
        os.environ["SYMGEN_CACHE"] = str(Path(folder) / "cache")
        try:
            yield Path(folder)
        finally:
            if before is None:
                del os.environ["SYMGEN_CACHE"]
            else:
                os.environ["SYMGEN_CACHE"] = before


def model_of(scene: SceneRecord, folder: Path, functions: frozenset[str] | None = None) -> Model:
    """Generate and load."""
    return load_model(generate(scene, Path(tempfile.mkdtemp(dir=folder)), functions))


def condensed_program(model: Model) -> tuple[Call, Layout]:
    """M_hat and Q_hat of a chain as a one-stage program; z holds q_i, q_i_dot, M_hat and Q_hat."""
    n = len(model.q_i)
    layout = Layout({"q_i": n, "q_i_dot": n, "M_hat": n * n, "Q_hat": n})

    def body(z: Fields, c: ca.SX) -> dict[str, ca.SX]:
        result = StageEquations(model, c).call("condensed", q_i=z["q_i"], q_i_dot=z["q_i_dot"])
        return {"M_hat": ca.vec(result["M_hat"]), "Q_hat": result["Q_hat"]}

    return make_stage("condensed", layout, constants_size(model), body), layout


def constants_size(model: Model) -> int:
    """Length of c."""
    return int(model.kernel("constants").size_out(0)[0])

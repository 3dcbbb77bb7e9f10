"""Engines agree bit for bit where mathematics is the library's; splitting a run into calls changes nothing."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.contenders.by_c_compiler import CompiledProgram
from runtime import simulate
from runtime.engine.c_source import find_compiler
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.program import Layout, Program, Sequence, make_stage
from runtime.model import Model
from runtime.running.planning import make_plan
from runtime.schemes.stepper import start_vector
from symgen.scenes import SCENES

pytestmark = pytest.mark.long

Load = Callable[[str], Model]
needs_compiler = pytest.mark.skipif(find_compiler() is None, reason="no C compiler")


@pytest.mark.parametrize("scheme", ["single_rate", "printed"])
@pytest.mark.parametrize("name", [name for name in SCENES if name != "chain"])
def test_engines_agree_bit_for_bit(built_in: Load, name: str, scheme: str) -> None:
    model = built_in(name)
    ratios = [3] * (len(model.groups) - 1) if scheme == "printed" else None
    results = [
        simulate(
            model, t_end=20 * float(model.simulation["dt"]), scheme=scheme, m=ratios, seen_every=0.0, engine=engine
        )
        for engine in ("interpreted", "compiled-library")
    ]
    assert [result.stats["engine"] for result in results] == ["interpreted", "compiled"]
    for field in ("t", "q", "q_dot", "q_ddot", "lam"):
        np.testing.assert_array_equal(*(getattr(result, field) for result in results), err_msg=field)


@pytest.mark.parametrize("name", ["four_bar", "flexible_slider_crank", "heavy_top"])
def test_own_mathematics_changes_rounding_only(built_in: Load, name: str) -> None:
    model = built_in(name)
    own, library = (
        simulate(model, t_end=20 * float(model.simulation["dt"]), scheme="single_rate", engine=engine)
        for engine in ("compiled", "compiled-library")
    )
    np.testing.assert_allclose(own.q, library.q, rtol=0, atol=1e-13 * np.max(np.abs(library.q)))


@needs_compiler
@pytest.mark.parametrize("name", [name for name in SCENES if name != "chain"])
def test_state_vectors_agree_bit_for_bit(built_in: Load, name: str) -> None:
    """The whole state of the scheme by the C compiler, over 500 steps in one call and in several."""
    model = built_in(name)
    scheme = "single_rate" if name == "spatial_slider_crank" else "printed"
    plan = make_plan(model, 1.0, float(model.simulation["dt"]), None, scheme, 1, None, 0.0)
    constants = model.constants(model.parameter_vector())
    c = plan.scheme.constants(constants)
    z = [start_vector(plan.scheme, 0.0, model.initial_q, model.initial_q_dot, constants) for _ in range(2)]
    CompiledProgram(plan.scheme.program()).run(z[0], c, 500)
    interpreted = InterpretedProgram(plan.scheme.program(), plan.scheme.layout.size, plan.scheme.c_size)
    for n in (1, 2, 4, 493):
        interpreted.run(z[1], c, n)
    np.testing.assert_array_equal(z[0], z[1])


def test_samples_do_not_change_the_run(built_in: Load) -> None:
    model = built_in("slider_crank")
    often, seldom = (
        simulate(model, t_end=4e-3, dt=2e-5, seen_every=every * 2e-5, engine="interpreted") for every in (1, 50)
    )
    np.testing.assert_array_equal(often.q[::50], seldom.q)


@needs_compiler
def test_stages_without_constants_run_in_c() -> None:
    """Alone, and beside one that has some: z <- 2 (z + c) in two stages."""
    layout = Layout({"x": 1})
    double = make_stage("double", layout, 0, lambda z, c: {"x": 2 * z["x"]})
    add = make_stage("add", layout, 1, lambda z, c: {"x": z["x"] + c[0]})
    cases: list[tuple[Program, list[float], float]] = [(double, [], 8.0), (Sequence((add, double)), [5.0], 78.0)]
    for program, c, end in cases:
        z = np.array([1.0])
        CompiledProgram(program).run(z, np.array(c), 3)
        assert z[0] == end

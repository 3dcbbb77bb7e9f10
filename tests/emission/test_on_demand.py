"""Functions that are derived when a run asks for them: the same as the emitted ones, and only those."""

from __future__ import annotations

import json

import numpy as np
import pytest

from runtime import load_model, simulate
from runtime.model import Model
from runtime.operating.mode_solver import ModeSolver, State
from runtime.running.monitor import CloseLook
from runtime.running.planning import make_plan
from runtime.schemes.stage_equations import LONG_TREE
from symgen.choice.assembly import ConstraintNumbers
from symgen.generate import generate, model_of
from symgen.scene import SceneRecord
from symgen.scenes import SCENES, generated_folder
from symgen.scenes.pendulums import chain

QUADRATIC = ("condensed", "blocks", "augmented", "residual_jacobian", "dQ_hat_dq_i", "dQ_hat_dq_i_dot", "substep_2")
LINKS = 20  # rigid ones: a long tree, quickly derived
ROUNDING = 1e-11


@pytest.fixture(scope="module")
def long_chain() -> SceneRecord:
    assert LINKS > LONG_TREE
    return chain(LINKS)


@pytest.fixture(scope="module")
def emitted(long_chain: SceneRecord, tmp_path_factory: pytest.TempPathFactory) -> Model:
    return load_model(generate(long_chain, tmp_path_factory.mktemp("model") / "chain"))


@pytest.fixture(scope="module")
def on_demand(long_chain: SceneRecord) -> Model:
    return model_of(long_chain)


@pytest.mark.parametrize(
    "name", ["pendulum", "two_oscillators", "hub_beam", "four_bar", "slider_crank", "tumbling_body"]
)
def test_names_are_those_of_the_emitted_functions(name: str) -> None:
    manifest = json.loads((generated_folder(name) / "manifest.json").read_text(encoding="utf-8"))
    assert list(model_of(SCENES[name]()).builders) == [entry["name"] for entry in manifest["functions"]]


@pytest.mark.parametrize("name", ["hub_beam", "flexible_slider_crank_free"])
def test_values_are_those_of_the_emitted_functions(name: str) -> None:
    model, wanted = model_of(SCENES[name]()), load_model(generated_folder(name))
    rng, p = np.random.default_rng(3), wanted.parameter_vector()
    for key in wanted.builders:
        found, kept = model.kernel(key), wanted.kernel(key)
        assert found.name_out() == kept.name_out() or key == "constants"
        if {"c", "p"} & {*kept.name_in()} != {"c"}:
            continue
        values = {argument: 0.3 * rng.standard_normal(kept.size_in(argument)) for argument in kept.name_in()}
        for output in kept.name_out():
            exact = np.asarray(wanted.evaluate(key, **{**values, "c": wanted.constants(p)})[output])
            near = np.asarray(model.evaluate(key, **{**values, "c": model.constants(p)})[output])
            assert np.abs(near - exact).max(initial=0.0) <= ROUNDING * np.abs(exact).max(initial=1e-300), (key, output)


@pytest.mark.long
def test_a_run_along_a_long_tree_derives_nothing_quadratic(emitted: Model, on_demand: Model) -> None:
    settings = {"t_end": 0.02, "dt": 5e-4, "scheme": "single_rate", "seen_every": 0.02}
    found, wanted = simulate(on_demand, **settings), simulate(emitted, **settings)
    assert found.status.ok and "forward_dynamics" in on_demand.operations
    assert not on_demand.operations.keys() & {*QUADRATIC}
    assert np.abs(found.q - wanted.q).max() < 1e-10
    assert found.stats["step_limit_at_start"] == pytest.approx(wanted.stats["step_limit_at_start"], rel=1e-9)


def test_mass_and_slopes_of_a_long_tree_are_those_of_the_matrices(emitted: Model) -> None:
    """M_hat from dT/dq_i_dot, and q_i_ddot by q_i and by q_i_dot from the recursion, against M_hat, J_q and J_v."""
    c = emitted.constants(emitted.parameter_vector())
    state = State(0.0, np.sin(np.arange(LINKS)), np.linspace(-1.0, 1.0, LINKS), np.zeros(0))
    solver = ModeSolver(emitted, c)
    M_hat, *slopes = solver.matrices(state)
    for found, J in zip(solver.slopes(state), slopes, strict=True):
        wanted = np.linalg.solve(M_hat, J)
        assert np.abs(found - wanted).max() < 1e-8 * np.abs(wanted).max()
    scheme = make_plan(emitted, 1.0, 1e-4, None, "single_rate", 1, None, 0.0).scheme
    z = np.asarray(scheme.start()(0.0, state.q_i, np.zeros(LINKS), [], scheme.constants(c))).ravel()
    assert np.abs(CloseLook(emitted, scheme)(z, scheme.constants(c)).M_hat - M_hat).max() < 1e-12 * np.abs(M_hat).max()


def test_a_chain_is_assembled_in_as_many_iterations_whatever_its_length(monkeypatch: pytest.MonkeyPatch) -> None:
    calls: list[int] = []
    position = ConstraintNumbers.position
    monkeypatch.setattr(ConstraintNumbers, "position", lambda *given: calls.append(1) or position(*given))
    counts = []
    for links in (3, 24):
        calls.clear()
        model_of(chain(links))
        counts.append(len(calls))
    assert counts[1] <= counts[0] + 2

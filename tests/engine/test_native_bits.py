"""Native code gives the same bits whatever its form: width, effort, chunks, level of the processor, mathematics."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
import pytest

from runtime import ensemble, gradient, simulate
from runtime.engine.interpreted import InterpretedProgram
from runtime.engine.llvm_code import BEST, FIRST_EFFORT, Effort, Processor, host
from runtime.engine.native import NativeProgram
from runtime.engine.program import Form
from runtime.gradients import End
from runtime.model import Model
from tests.support.step_programs import StepProgram, step_program

Load = Callable[[str], Model]
STEPS = 40
CASES = [
    ("slider_crank", "single_rate", None),
    ("flexible_slider_crank_free", "exponential", [2]),
    ("flexible_slider_crank_free", "printed", [4]),  # an Until
    ("flexible_slider_crank_torque", "coupled", [3]),  # where() in the load
    ("slider_crank", "radau", None),
    ("heavy_top", "single_rate", None),
]
LEVELLED = [CASES[0], ("hub_beam", "exponential", [2]), CASES[2]]
SCATTER = 1e-3  # between the lanes: iterations of an Until end at different counts


def program(built_in: Load, case: tuple[str, str, list[int] | None]) -> StepProgram:
    return step_program(built_in(case[0]), *case[1:])


def scalar(given: StepProgram, lane: int, form: Form, effort: Effort) -> np.ndarray:
    moved = StepProgram(given.program, given.ready, given.lane(lane, SCATTER))
    return moved.run(STEPS, form._replace(width=1), effort)[0]


@pytest.mark.every_push(
    "slider_crank-single_rate", "best-flexible_slider_crank_free-printed", "best-flexible_slider_crank_torque-coupled"
)
@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case[0]}-{case[1]}")
@pytest.mark.parametrize(
    "form, effort", [(Form(), BEST), (Form(chunk=25, inline=False), FIRST_EFFORT)], ids=["best", "first"]
)
def test_library_mathematics_equals_the_virtual_machine(built_in: Load, case, form: Form, effort: Effort) -> None:
    given = program(built_in, case)
    expected = given.start.copy()
    InterpretedProgram(given.program, len(given.start), len(given.ready)).run(expected, given.ready, STEPS)
    found = given.run(STEPS, form._replace(mathematics="library"), effort)[0]
    np.testing.assert_array_equal(found, expected)
    assert not np.array_equal(found, given.start)


@pytest.mark.every_push("slider_crank-radau", "flexible_slider_crank_torque-coupled")
@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case[0]}-{case[1]}")
def test_effort_and_chunks_change_no_bit(built_in: Load, case) -> None:
    given = program(built_in, case)
    expected = given.run(STEPS, Form(), BEST)
    for chunk, effort in ((7, FIRST_EFFORT), (100, FIRST_EFFORT), (300, BEST), (300, Effort(passes=False, level=2))):
        found = given.run(STEPS, Form(chunk=chunk, inline=False), effort)
        np.testing.assert_array_equal(found, expected, err_msg=f"{chunk} {effort}")


@pytest.mark.every_push("4-slider_crank-single_rate", "8-flexible_slider_crank_free-printed")
@pytest.mark.parametrize("case", CASES, ids=lambda case: f"{case[0]}-{case[1]}")
@pytest.mark.parametrize("width", [2, 4, 8])
def test_every_lane_is_the_run_of_its_own(built_in: Load, case, width: int) -> None:
    """Lanes that start apart, in both forms of code: each equals the scalar run bit for bit."""
    given = program(built_in, case)
    expected = [scalar(given, lane, Form(), BEST) for lane in range(width)]
    assert not np.array_equal(expected[0], expected[-1])
    for form, effort in ((Form(width), BEST), (Form(width, chunk=50, inline=False), FIRST_EFFORT)):
        np.testing.assert_array_equal(given.run(STEPS, form, effort, scatter=SCATTER), expected, err_msg=f"{form}")


def levels() -> list[Processor]:
    """Levels of x86-64 that this machine has; this machine alone where it is of another kind."""
    features = set(host().features.split(","))
    if "+sse2" not in features:
        return [host()]
    needed = {"x86-64": "+sse2", "x86-64-v2": "+sse4.2", "x86-64-v3": "+fma", "x86-64-v4": "+avx512vl"}
    return [Processor(name, "") for name, feature in needed.items() if feature in features]


@pytest.mark.every_push("slider_crank-single_rate", "x86-64-v3-hub_beam-exponential")
@pytest.mark.parametrize("case", LEVELLED, ids=lambda case: f"{case[0]}-{case[1]}")
@pytest.mark.parametrize("processor", levels(), ids=lambda processor: processor.name)
def test_levels_of_the_processor_change_no_bit(built_in: Load, case, processor: Processor) -> None:
    """Without the instruction, a fused multiply-add is the library's, which is exact too."""
    given = program(built_in, case)
    expected = given.run(STEPS, Form(), BEST)
    for form in (Form(), Form(4)):
        found = given.run(STEPS, form, BEST, processor)
        for lane in found:
            np.testing.assert_array_equal(lane, expected[0])


def test_a_run_may_change_over_between_calls(built_in: Load, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Calls before, while and after better code is made: the same bits as one call of the best code."""
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    given = program(built_in, CASES[1])
    changing = NativeProgram(given.program)
    assert not changing.tiers.final
    z = given.start.copy()
    changing.run(z, given.ready, 13)
    changing.tiers.finish()
    assert changing.tiers.final
    changing.run(z, given.ready, 27)
    best = NativeProgram(given.program, wait=True)
    expected = given.start.copy()
    best.run(expected, given.ready, 40)
    np.testing.assert_array_equal(z, expected)
    assert NativeProgram(given.program).tiers.final  # it is kept


def test_threads_do_not_disturb_each_other(built_in: Load) -> None:
    given = program(built_in, CASES[1])
    engine = NativeProgram(given.program)
    states = [given.start.copy() for _ in range(4)]
    threads = [threading.Thread(target=engine.run, args=(state, given.ready, 200)) for state in states]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    expected = given.run(200, Form(), BEST)[0]
    for state in states:
        np.testing.assert_array_equal(state, expected)


def test_no_run_calls_another_program(built_in: Load, tmp_path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Runs, ensembles and gradients with an empty cache: neither a C compiler nor anything else is started."""

    def refused(*arguments: object, **further: object) -> None:
        raise AssertionError(f"started: {arguments}")

    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    monkeypatch.setattr("subprocess.Popen", refused)
    monkeypatch.setattr("os.system", refused)
    model = built_in("pendulum")
    assert simulate(model, t_end=0.01).stats["engine"] == "compiled"
    answer = ensemble(model, {"rod.mass": [1.0, 2.0]}, reduce={"rod.theta": ["end"]}, t_end=0.01)
    assert list(answer["status"]) == ["completed", "completed"]
    assert gradient(model, End(model.q_i[0]), [f"{model.q_i[0]}_dot"], t_end=0.01).derivatives.all()

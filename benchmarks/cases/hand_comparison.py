"""Native code against gcc's and hand-written C: `python -m benchmarks.cases.hand_comparison` prints JSON."""

from __future__ import annotations

import json

from benchmarks.cases.scenes import MAJOR_STEP, RATIO, pinned_rod
from benchmarks.cases.step_case import Case, counts, difference, make_case, worker
from benchmarks.contenders.by_c_compiler import CompiledProgram
from benchmarks.contenders.hand_stepper import HandStepper
from benchmarks.harness.models import workplace
from benchmarks.harness.timing import interleave, ratio
from runtime.engine.native import Engine, NativeProgram

AGREEMENT_STEPS = 300
ROUNDS = 100


def main() -> dict:
    """Seconds a major step, their ratio with quartiles, and how far the two states are apart."""
    with workplace() as folder:
        case = make_case(pinned_rod(), folder)
        native, by_c = NativeProgram(case.program, wait=True), CompiledProgram(case.program)
        hand = HandStepper(case.scheme.layout, MAJOR_STEP, RATIO)
        error = max(_difference(case, engine, hand) for engine in (native, by_c))
        state, start = hand.state(case.start), hand.state(case.start)

        def by_hand(n: int) -> None:
            state[:] = start
            hand.run(state, n)

        timings = interleave({"generated": worker(case, native), "by gcc": worker(case, by_c), "hand": by_hand}, ROUNDS)
        quotient, lower, upper = ratio(timings["generated"], timings["hand"])
        return {
            **{name: timing.best for name, timing in timings.items()},
            "ratio to gcc": ratio(timings["generated"], timings["by gcc"])[0],
            "ratio": quotient,
            "quartiles": [lower, upper],
            "difference": error,
            **counts(case),
        }


def _difference(case: Case, compiled: Engine, hand: HandStepper) -> float:
    z, state = case.start.copy(), hand.state(case.start)
    compiled.run(z, case.ready, AGREEMENT_STEPS)
    hand.run(state, AGREEMENT_STEPS)
    return difference(state[:9], hand.state(z)[:9], "hand-written and generated code")  # x, d and a


if __name__ == "__main__":
    print(json.dumps(main()))

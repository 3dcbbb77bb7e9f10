"""Generated against hand-written C, in turn: `python -m benchmarks.cases.hand_comparison` prints JSON."""

from __future__ import annotations

import json

from benchmarks.cases.scenes import MAJOR_STEP, RATIO, pinned_rod
from benchmarks.cases.step_case import Case, counts, difference, make_case, worker
from benchmarks.contenders.hand_stepper import HandStepper
from benchmarks.harness.models import workplace
from benchmarks.harness.timing import interleave, ratio
from runtime.engine.compiled import CompiledProgram

AGREEMENT_STEPS = 300
ROUNDS = 100


def main() -> dict:
    """Seconds a major step, their ratio with quartiles, and how far the two states are apart."""
    with workplace() as folder:
        case = make_case(pinned_rod(), folder)
        compiled, hand = CompiledProgram(case.program), HandStepper(case.scheme.layout, MAJOR_STEP, RATIO)
        error = _difference(case, compiled, hand)
        state, start = hand.state(case.start), hand.state(case.start)

        def by_hand(n: int) -> None:
            state[:] = start
            hand.run(state, n)

        timings = interleave({"generated": worker(case, compiled), "hand": by_hand}, ROUNDS)
        quotient, lower, upper = ratio(timings["generated"], timings["hand"])
        return {
            "generated": timings["generated"].best,
            "hand": timings["hand"].best,
            "ratio": quotient,
            "quartiles": [lower, upper],
            "difference": error,
            **counts(case),
        }


def _difference(case: Case, compiled: CompiledProgram, hand: HandStepper) -> float:
    z, state = case.start.copy(), hand.state(case.start)
    compiled.run(z, case.ready, AGREEMENT_STEPS)
    hand.run(state, AGREEMENT_STEPS)
    return difference(state[:9], hand.state(z)[:9], "hand-written and generated C")  # x, d and a


if __name__ == "__main__":
    print(json.dumps(main()))

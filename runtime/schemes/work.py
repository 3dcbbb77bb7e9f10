"""The work done on a mechanism, by the powers that the steps of any scheme come by: dW/dt = P.

P = power_applied + lam^T C_t - power_dissipated. Every step sums it up at a state that the scheme evaluates anyway;
what is missing at both ends is added when W is read, by Gregory's formula with second differences:

    W = h (P_0 + ... + P_n - (P_0 + P_n) / 2 - (grad P_n - grad P_0) / 12 - (grad^2 P_n + grad^2 P_0) / 24)

of order 4 for schemes that evaluate at the start of a step. Where only one whole step follows before something jumps,
the differences are those of its start, middle and end, which makes W Simpson's rule. Where a scheme sees the middle of
its steps (`linearised`), W = h sum P, and where it sees the ends of its sub-steps with slow coordinates held, the
trapezoidal rule: order 2, as the schemes. A scheme whose steps vary integrates them by Simpson's rule.
W does not depend on which samples are kept. A mechanism that nothing feeds or damps has no such fields.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.model import Model
from runtime.engine.program import Fields, Program, Sequence
from runtime.schemes.direct import direct
from runtime.schemes.scheme import Scheme
from runtime.schemes.stage_equations import StageEquations

# sum of the powers [W] so far, begun with what W and Gregory's formula have at the start; the last one, its difference
# to the one before, and the sum of the magnitudes of second differences
FIELDS = {"power_sum": 1, "power": 1, "power_change": 1, "power_bends": 1}
# of a scheme that integrates: W [J] at the state that is seen and at the start of the running step, the power there, in
# its middle and at its end, the step that is not in W yet [s], did it end where something may jump?, the sum of
# Simpson's rule less the trapezoidal one
INTEGRATED = {
    "work": 1,
    "work_from": 1,
    "power": 1,
    "power_mid": 1,
    "power_to": 1,
    "pending": 1,
    "landed": 1,
    "bends": 1,
}
# of the second differences, as work: where a power P dies within the first step of an account, W = 3/8 h P is off by as
# much (three differences of P); where it dies within a later one (two of P), by up to twice as much
IN_DOUBT = 1 / 8
AHEAD = 2  # powers that an account looks at in advance
END_OF_STEP, MIDDLE = 1.0, 0.5


def works(model: Model) -> bool:
    """Do loads, dampers or prescribed motions do work on the mechanism? False where no function tells."""
    if not model.has("energy") or (model.constraints and not (model.has("constraints") and model.has("reactions"))):
        return False
    outputs = [("energy", "power_applied"), ("energy", "power_dissipated")]
    outputs += [("constraints", "C_t")] if model.constraints else []
    return not all(model.structurally_zero(function, output) for function, output in outputs)


def account_for_work(scheme: Scheme) -> None:
    """Give z the fields of the work, where there is any. Before anything of the scheme is built."""
    if works(scheme.model) and not accounted(scheme):
        scheme.keep_account(INTEGRATED if scheme.integrates_work else FIELDS)


def accounted(scheme: Scheme) -> bool:
    """Has z the fields of the work?"""
    return "power" in scheme.layout.sizes


@dataclass(frozen=True)
class Ahead:
    """How the first powers are looked at, for Gregory's formula: from a state z on, which `step` advances.

    c: as the stages read it then. spacing: of the powers, in major steps.
    """

    z: np.ndarray
    c: np.ndarray
    step: Callable[[np.ndarray], None]
    spacing: float = 1.0


def begin_account(scheme: Scheme, z: np.ndarray, c: np.ndarray, work: float, ahead: Ahead | None) -> None:
    """Count anew from a state z (at least the scheme's part, flat) with this work [J]; c as the stages read it.

    ahead: None where no whole step is made from there.
    """
    if not accounted(scheme):
        return
    layout, n = scheme.layout, scheme.layout.size
    if scheme.integrates_work:
        z[layout.slice("work")] = z[layout.slice("work_from")] = work
        z[layout.slice("pending")] = 0.0
        return
    P_0 = power_of(scheme, z[:n], c)
    P_1 = P_2 = P_0
    spacing = 1.0
    if looks_ahead(scheme) and ahead is not None:
        P_1, P_2 = _next_powers(scheme, ahead)
        spacing = ahead.spacing
        if not np.isfinite([P_1, P_2]).all():
            P_1 = P_2 = P_0
    for name, value in zip(FIELDS, begun(scheme, scheme.grid.h, work, P_0, P_1, P_2, spacing), strict=False):
        z[layout.slice(name)] = value


def looks_ahead(scheme: Scheme) -> bool:
    """Does an account begin with the powers that come next?"""
    return scheme.power_at not in (END_OF_STEP, MIDDLE)


def begun(
    scheme: Scheme, steps: Any, work: Any, P_0: Any, P_1: Any, P_2: Any, spacing: Any = 1.0
) -> tuple[Any, Any, Any]:
    """power_sum, power and power_change of an account that begins with this work [J] and these powers [W].

    steps (groups,): of a major step [s]. spacing: of the powers, in major steps. Where only one whole step follows it
    is 1/2, and W behind that step is by Simpson's rule.
    """
    h = counting_step(scheme, steps)
    if not looks_ahead(scheme):
        return work / h + (P_0 / 2 if scheme.power_at == END_OF_STEP else 0.0), P_0, 0.0
    bend = (P_0 - 2 * P_1 + P_2) / spacing**2  # of the parabola through the three
    change = (P_1 - P_0) / spacing + bend / 2 * (1 - spacing)
    start = -P_0 / 2 + change / 12 - bend / 24
    return work / h + start, P_0 - change + bend, change - 2 * bend


def counting_step(scheme: Scheme, steps: Any) -> Any:
    """Time between two powers of the account [s], of the steps (groups,)."""
    return steps[-1] if scheme.power_at == END_OF_STEP else steps[0]


def work_and_doubt(scheme: Scheme, z: np.ndarray, P: Any) -> tuple[Any, Any]:
    """W [J] of states, and by how much it may be wrong where power changes within a step: a stiff damper, a pulse.

    z (N, n_z) or (n_z,): states, at least the scheme's part; P (N,) or a number: their powers [W].
    """
    layout = scheme.layout
    if scheme.integrates_work:
        return z[..., layout.slice("work")][..., 0], IN_DOUBT * z[..., layout.slice("bends")][..., 0]
    return counted_work(scheme, scheme.grid.h, P, *(z[..., layout.slice(name)][..., 0] for name in FIELDS))


def counted_work(scheme: Scheme, steps: Any, P: Any, total: Any, last: Any, change: Any, bends: Any) -> tuple[Any, Any]:
    """The same of the fields (arrays, or SX) of a scheme whose steps (groups,) [s] sum powers up."""
    h = counting_step(scheme, steps)
    if scheme.power_at == END_OF_STEP:
        return h * (total - P / 2), h * IN_DOUBT * bends
    if scheme.power_at == MIDDLE:
        return h * total, h * IN_DOUBT * bends
    slope = P - last
    bend = slope - change
    return h * (total + P / 2 - slope / 12 - bend / 24), h * IN_DOUBT * (bends + abs(bend))


def account_at(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> tuple[float, float]:
    """(W, its doubt) [J] of a state z (at least the scheme's part, flat); zero without account. c as stages read it."""
    if not accounted(scheme):
        return 0.0, 0.0
    state = z[: scheme.layout.size]
    with np.errstate(all="ignore"):  # other checks say what is not finite
        work, doubt = work_and_doubt(scheme, state, power_of(scheme, state, c))
    return float(work), float(doubt)


def power_of(scheme: Scheme, z: np.ndarray, c: np.ndarray) -> float:
    """P at the state that z (the scheme's part, flat) shows [W]."""

    def build() -> ca.Function:
        symbols = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("c", scheme.c_size)
        equations = scheme.equations(symbols[1], scheme.layout.unpack(symbols[0]))
        return ca.Function("power", list(symbols), [observed_power(scheme, *symbols, equations)])

    return float(direct(scheme, "power", build)(z[: scheme.layout.size], c)[0])


def by_simpson(h: Any, start: Any, middle: Any, end: Any) -> tuple[Any, Any]:
    """Work [J] in h [s] of a power [W] by Simpson's rule, and the magnitude of what that is off the trapezoidal one."""
    done = h / 6 * (start + 4 * middle + end)
    return done, abs(done - h / 2 * (start + end))


def observed_power(scheme: Scheme, z: ca.SX, c: ca.SX, equations: StageEquations) -> ca.SX:
    """P [W] at the state that z (the scheme's part) shows; c as the stages read it."""
    seen = scheme.observer(z=z, c=c)
    parts = {end: (seen[f"q_i{end}"], seen[f"q_d{end}"]) for end in ("", "_dot", "_ddot")}
    return equations.power(seen["t"], *(equations.joined(*both) for both in parts.values()))


def with_account(scheme: Scheme, program: Program) -> Program:
    """A major step; of a scheme that does not count powers itself, with a stage before it that observes and counts."""
    if not accounted(scheme) or scheme.counts_powers:
        return program

    def counted(z: Fields, equations: StageEquations) -> Mapping[str, ca.SX]:
        constants = ca.vertcat(equations.c, equations.h)
        return scheme.counted(z, observed_power(scheme, scheme.layout.pack(z), constants, equations))

    return Sequence((scheme.stage("work", counted), program))


def _next_powers(scheme: Scheme, ahead: Ahead) -> list[float]:
    """P after one and after two steps."""
    powers, z = list[float](), ahead.z.copy()
    for _ in range(AHEAD):
        ahead.step(z)
        powers.append(power_of(scheme, z[: scheme.layout.size], ahead.c))
    return powers

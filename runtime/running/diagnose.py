"""Why a run ends: from a check that failed to its named status, with time, coordinate, likely cause and advice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from runtime.contract.status import Event, Status, StatusName
from runtime.running.mass_matrix import positive_definite
from runtime.running.turns import MOST_TURN_OF_STEP, frequency_at_states
from runtime.schemes.step_limit import eigenvalues

if TYPE_CHECKING:
    from runtime.running.monitor import Failure, Monitor
    from runtime.solutions.solution import Solution

NEARLY_LOST = 0.1  # of M_hat without deflections: below this a breakdown of the numbers is laid to it
NEARLY_TOO_FAR = 0.5  # of what a step may turn a loop
SAFE_LIMIT = 0.9  # of a limit
STRONG = 5.0  # times that a motion decays by e in a step, from which advice names the damper

BREAKDOWNS = ("not_finite", "diverged", "constraints_lost", "iteration_failed")  # that M_hat may be the cause of
OF_LOADS = ("not_finite", "diverged", "step_too_short")  # that a load may be the cause of
OUT_OF_REACH = "A drive may ask for a position that the lengths do not allow: look at the motion until then."
OF_MASS = "Check masses, inertias and mass matrices, as the parameters make them."
OF_STIFFENING = (
    "A deflection is too large for second-order geometric stiffening: use more or stiffer bodies, or smaller loads. "
    "Where it grew by instability, take shorter steps."
)
SHORTER_STEPS, FAR_SHORTER = 3.0, 10.0  # times


def shorter_steps(monitor: Monitor, dt: float | None = None) -> str:
    """How the same call is made with shorter steps, of dt [s] where that is known."""
    scheme = monitor.scheme
    if scheme.adaptive:
        return "Give a smaller tolerance."
    given = f"dt={scheme.grid.dt_L / SHORTER_STEPS if dt is None else dt:.2g}"
    if monitor.refined:
        return f'Name a scheme and its step in place of the tolerance, such as scheme="{monitor.refined}", {given}.'
    return f"Reduce the step, such as {given}, or give a tolerance in place of it."


def step_advice(monitor: Monitor, below: str = "") -> str:
    """The limit at the last good state against the step, and what to do about a strong damper; below: what to say
    where the step is below the limit.
    """
    scheme = monitor.scheme
    if scheme.adaptive:
        return below or shorter_steps(monitor)
    slopes, h = monitor.slopes(), scheme.grid.h[-1]
    damper = "" if slopes is None else _damper(*slopes, h)
    limit = scheme.step_limit(*slopes) if slopes is not None and scheme.limited() else None
    if limit is None:
        return damper or below or shorter_steps(monitor)
    text = (
        f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
        f"fastest group's step is {h:.3g} s."
    )
    if h > limit.h:
        short = shorter_steps(monitor, SAFE_LIMIT * scheme.grid.dt_L * limit.h / h)
        return f"{text} {damper or short}"
    if below:
        return f"{text} {below}"
    if len(scheme.grid.groups) > 1:
        return text + (
            " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
            f"reduce {'m' if monitor.refined else 'm or dt'}, add damping, or use single_rate."
        )
    return text + (
        " So the growth may be physical: a spinning beam without geometric stiffening diverges, for instance."
    )


def _damper(A_q: np.ndarray, A_v: np.ndarray, h: float) -> str:
    """Advice where a motion decays much faster than a step; else nothing."""
    decay = float((-eigenvalues(A_q, A_v).real).max(initial=0.0))
    if not decay * h > STRONG:
        return ""
    return (
        f"A damper makes a motion decay at {decay:.3g} 1/s, {decay * h:.3g} times in a step of {h:.3g} s: take radau "
        "or exponential with propagation = decaying, whose steps damp it out."
    )


def _of_deflections(monitor: Monitor) -> str:
    """What of the step is above what the last good state allows, first: a load whose own slope lets a motion
    decay within it, moving or at rest, where friction is steepest; and the scheme's limit.
    """
    scheme, said = monitor.scheme, list[str]()
    if not scheme.adaptive:
        h, known = scheme.grid.h[-1], [one for one in (monitor.slopes(), monitor.slopes(moving=False)) if one]
        said = [text for slopes in known[::-1] if (text := _damper(*slopes, h))][:1]
        limits = [scheme.step_limit(*slopes) for slopes in known if scheme.limited()]
        said += [f"The {one}: the scheme needs a step below {one.h:.3g} s." for one in limits[:1] if one and h > one.h]
        said = [f"The step of {h:.3g} s is too long here. {' '.join(said)} "] if said else []
    return "".join(said) + (
        "Divide the body, or make it stiffer. A strut beyond its buckling load and a spinning beam without geometric "
        "stiffening have no small answer."
    )


def _of_loops(monitor: Monitor) -> str:
    """Of loops that do not close: steps turn them too far, or there is no place where they close."""
    z, scheme = monitor.latest if monitor.latest is not None else monitor.good, monitor.scheme
    assert z is not None
    least = frequency_at_states(monitor.model, scheme, monitor.c[: monitor.model.c_size], z[None], by_change=True)
    dt = scheme.grid.dt_L
    if not scheme.adaptive and dt * least > NEARLY_TOO_FAR:
        turned = f"A step of {dt:.3g} s turns a loop too far there, by {MOST_TURN_OF_STEP * dt * least:.2g} rad."
        return f"{turned} {shorter_steps(monitor, 1 / (SHORTER_STEPS * least))}"
    return step_advice(monitor, below=f"{OUT_OF_REACH} {shorter_steps(monitor)}")


def _of_mass_at_start(monitor: Monitor) -> str:
    assert monitor.good is not None
    return OF_MASS if _mass_left(monitor, monitor.good) is None else OF_STIFFENING


def _of_iterations(monitor: Monitor) -> str:
    short = shorter_steps(monitor, monitor.scheme.grid.dt_L / FAR_SHORTER)
    return f"{monitor.scheme.if_not_converged} {short}"


def _of_limits(monitor: Monitor) -> str:
    from runtime.schemes.switching.consistency import ABOVE_ZERO

    return ABOVE_ZERO


CHECKS: dict[str, tuple[StatusName, str, str | Callable[[Monitor], str]]] = {  # status, cause, advice
    "finite at the start": (
        "not_finite",
        "the accelerations at the start are not finite",
        "M_hat may be singular, or a load infinite: check masses, inertias, loads and the initial position.",
    ),
    "mass at the start": ("mass_not_positive", "M_hat is not positive definite at the start", _of_mass_at_start),
    "step length": ("step_too_long", "the step {:.3g} s of the fastest group is above its limit", step_advice),
    "finite": ("not_finite", "a coordinate became infinite or NaN", step_advice),
    "event": (
        "not_finite",
        "the condition of event {} has no finite value",
        "Write it so that it has one wherever the motion may go: a root or logarithm of max(..., 0), no division.",
    ),
    "growth": ("diverged", "the coordinate grows without bound", step_advice),
    "closure": ("constraints_lost", "the loop closure moves too far in one step for Newton", _of_loops),
    "constraints": ("constraints_lost", "a constraint no longer holds", _of_loops),
    "iterations": (
        "iteration_failed",
        "the update of a step did not converge in {} iterations",
        _of_iterations,
    ),
    "least step": (
        "step_too_short",
        "the least step does not meet the tolerance behind t = {:.9g} s",
        "A force or a rate may grow without bound there, or jump at a time that depends on the motion: look at "
        "the motion until then, give a larger tolerance, or name a scheme with a step dt and no tolerance.",
    ),
    "limit": ("no_mode", "{}", _of_limits),
    "mode": (
        "no_mode",
        "{}, and no event was found: what sticks and what moves is no longer consistent",
        "Take smaller steps, or a tolerance instead of steps.",
    ),
    "mass": ("mass_not_positive", "M_hat is no longer positive definite", OF_STIFFENING),
    "deflection": (
        "deflection_too_large",
        "{} is deformed by {:.2g} of its length and {:.2g} rad, beyond its linear modes",
        _of_deflections,
    ),
    "branch": (
        "branch_lost",
        "the loop closure is singular within the next step",
        lambda monitor: f"{shorter_steps(monitor)} Or start elsewhere, or change a length a little.",
    ),
    "user": ("interrupted", "stopped by the user", "Results up to here are kept."),
    "output": ("output_failed", "{}", "Go on from the last checkpoint, or stream elsewhere."),
}


def diagnose(failure: Failure, time: float, monitor: Monitor) -> Status:
    """The status that ends a run at its last good state, whose time [s] is given."""
    name, cause, advice = CHECKS[failure.check]
    latest = monitor.latest
    if name in BREAKDOWNS and latest is not None and (share := _mass_left(monitor, latest)) is not None:
        cause = f"M_hat has lost all but {max(share, 0.0):.2g} of what it is without deflections, in one direction"
        return Status("mass_not_positive", time, None, cause, OF_STIFFENING)
    coordinate = None if failure.k is None else monitor.model.q_i[failure.k]
    text = advice if isinstance(advice, str) else advice(monitor)
    return Status(name, time, coordinate, cause.format(*failure.found), text)


def _mass_left(monitor: Monitor, z: np.ndarray) -> float | None:
    """What is left of M_hat at a state z, if deflections have nearly taken it its sign there.

    It is compared with M_hat of the same pose without deflections: how rigid bodies stand changes it, too, as much as
    one likes, and never takes its sign.
    """
    model, own = monitor.model, monitor.scheme.layout.slice("x")
    elastic = [k for k, name in enumerate(model.q_i) if name in model.elastic]
    if not elastic:
        return None
    straight = z.copy()
    straight[own][elastic] = 0.0
    M_hat, whole = (monitor.look(one, monitor.c).M_hat for one in (z, straight))
    if not np.isfinite(M_hat).all() or not positive_definite(whole):
        return None
    inverse = np.linalg.inv(np.linalg.cholesky(whole))
    left = float(np.linalg.eigvalsh(inverse @ M_hat @ inverse.T)[0])
    return None if left > NEARLY_LOST else left


def laid_to_loads(status: Status, solution: Solution, events: Sequence[Event], near: float) -> Status:
    """The same status, but a breakdown where a load has no finite value, or acts between the steps, is its doing.

    near [s]: how far from it. Where the ends of a spring or line meet, its force has no direction.
    """
    if status.name in (*OF_LOADS, "step_too_long"):
        names, last = solution.model.description.loads, solution.load_forces[-1]
        if lost := [load.name for load, force in zip(names, last, strict=True) if not np.isfinite(force).all()]:
            cause = f"load {lost[0]!r} has no finite force here: its ends meet, or its law has no value"
            return Status("not_finite", status.time, None, cause, "Keep them apart, or write a law that has one there.")
    endless = [one for one in events if one.kind == "load_not_finite" and one.time <= status.time + near]
    missed = [one for one in events if one.kind == "load_missed" and abs(one.time - status.time) <= near]
    if status.name not in OF_LOADS or not endless + missed:
        return status
    advice = (
        "Make it finite, or end the run earlier."
        if endless
        else "Declare an event there, or name a scheme and a dt that resolves it."
    )
    return replace(status, cause=(endless + missed)[0].text, advice=advice)

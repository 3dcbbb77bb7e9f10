"""Why a run ends: from a check that failed to its named status, with time, coordinate, likely cause and advice."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from runtime.contract.status import Event, Status, StatusName
from runtime.results.solution import Solution
from runtime.running.monitor import Failure, Monitor
from runtime.schemes.step_limit import eigenvalues

NEARLY_LOST = 0.1  # of M_hat at the start: below this a breakdown of the numbers is laid to it
STRONG = 5.0  # times that a motion decays by e in a step, from which advice names the damper

BREAKDOWNS = ("not_finite", "diverged", "constraints_lost", "iteration_failed")  # that M_hat may be the cause of
OF_LOADS = ("not_finite", "diverged", "step_too_short")  # that a load may be the cause of
OUT_OF_REACH = "A drive may ask for a position that the lengths do not allow: look at the motion until then."
DEAD_CENTRE = (
    "So the mechanism may be at a dead centre, where the chosen independent coordinates do not determine it: choose "
    "others (partition.independent), or reduce the step."
)
OF_MASS = (
    "A deflection is too large for second-order geometric stiffening, or a mass is not positive: use more or stiffer "
    "bodies, smaller loads, or a shorter step if it grew by instability."
)


def step_advice(monitor: Monitor, below: str = "") -> str:
    """The limit at the last good state against the step, and what to do about a strong damper; below: what to say
    where the step is below the limit.
    """
    scheme = monitor.scheme
    if scheme.adaptive:
        return "Give a smaller tolerance."
    slopes, h = monitor.slopes(), scheme.grid.h[-1]
    damper = "" if slopes is None else _damper(*slopes, h)
    limit = scheme.step_limit(*slopes) if slopes is not None and scheme.limited() else None
    if limit is None:
        return damper or (f"{OUT_OF_REACH} {below}" if below else "Reduce the step.")
    text = (
        f"The {limit} at the last good state: the scheme needs a step below {limit.h:.3g} s there, and the "
        f"fastest group's step is {h:.3g} s."
    )
    if h > limit.h:
        return f"{text} {damper}".rstrip()
    if below:
        return f"{text} {below}"
    if len(scheme.grid.groups) > 1:
        return text + (
            " So the sub-cycling itself is unstable (a frozen q_L_ddot acts as negative damping): "
            "reduce m or dt, add damping, or use single_rate."
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
        f"A damper lets a motion decay at {decay:.3g} 1/s, {decay * h:.3g} times in a step of {h:.3g} s: take radau or "
        "exponential with propagation = decaying, whose steps let such a decay die out."
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


at_dead_centre = partial(step_advice, below=DEAD_CENTRE)
CHECKS: dict[str, tuple[StatusName, str, str | Callable[[Monitor], str]]] = {  # status, cause, advice
    "finite at the start": (
        "not_finite",
        "the accelerations at the start are not finite",
        "M_hat may be singular, or a load infinite: check masses, inertias, loads and the initial position.",
    ),
    "mass at the start": ("mass_not_positive", "M_hat is not positive definite at the start", OF_MASS),
    "step length": ("step_too_long", "the step {:.3g} s of the fastest group is above its limit", step_advice),
    "finite": ("not_finite", "a coordinate became infinite or NaN", step_advice),
    "event": (
        "not_finite",
        "the condition of event {} has no finite value",
        "Write it so that it has one wherever the motion may go: a root or logarithm of max(..., 0), no division.",
    ),
    "growth": ("diverged", "the coordinate grows without bound", step_advice),
    "closure": ("constraints_lost", "the loop closure moves too far in one step for Newton", at_dead_centre),
    "constraints": ("constraints_lost", "a constraint no longer holds", at_dead_centre),
    "iterations": (
        "iteration_failed",
        "the update of a step did not converge in {} iterations",
        lambda monitor: monitor.scheme.if_not_converged,
    ),
    "least step": (
        "step_too_short",
        "the least step does not meet the tolerance behind t = {:.9g} s",
        "A force or a rate may grow without bound there, or jump at a time that depends on the motion: look at "
        "the motion until then, raise the tolerance, or take a scheme with steps of one length.",
    ),
    "mass": ("mass_not_positive", "M_hat is no longer positive definite", OF_MASS),
    "deflection": (
        "deflection_too_large",
        "{} is bent by {:.2g} of its length and {:.2g} rad, beyond its linear modes",
        _of_deflections,
    ),
    "branch": (
        "branch_lost",
        "the loop closure is singular within the next step",
        "Reduce the step, start elsewhere, or change a length a little.",
    ),
    "user": ("interrupted", "stopped by the user", "What was computed is kept."),
    "output": ("output_failed", "{}", "Go on from the last checkpoint, or stream elsewhere."),
}


def diagnose(failure: Failure, time: float, monitor: Monitor) -> Status:
    """The status that ends a run at its last good state, whose time [s] is given."""
    name, cause, advice = CHECKS[failure.check]
    if name in BREAKDOWNS and monitor.latest is not None and (share := _mass_left(monitor)) is not None:
        cause = f"M_hat has lost all but {max(share, 0.0):.2g} of what it was at the start, in one direction"
        return Status("mass_not_positive", time, None, cause, OF_MASS)
    coordinate = None if failure.k is None else monitor.model.q_i[failure.k]
    text = advice if isinstance(advice, str) else advice(monitor)
    return Status(name, time, coordinate, cause.format(*failure.found), text)


def _mass_left(monitor: Monitor) -> float | None:
    """Of a run that stopped behind its latest state: is M_hat about to lose its sign there, seen from the start?"""
    assert monitor.latest is not None
    M_hat = monitor.look(monitor.latest, monitor.c).M_hat
    if monitor.mass is None or not np.isfinite(M_hat).all():
        return None
    inverse = np.linalg.inv(np.linalg.cholesky(monitor.mass))
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
    advice = "Let it be finite, or end the run before." if endless else "Give it a smaller step there."
    return replace(status, cause=(endless + missed)[0].text, advice=advice)

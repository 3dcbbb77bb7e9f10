"""What the page draws beside a joint: the ends of its way, whether something holds it, and the wheels of gears."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.coordinates import at_home, parts, rate_parts
from runtime.contract.records import packed
from runtime.results.friction import rubbing, stopping
from runtime.results.impacts import impacts
from runtime.views.film import is_spatial
from runtime.views.mechanism import Scenery

if TYPE_CHECKING:
    from runtime.solutions.solution import Solution

KINDS = ("impact", "mode", "event")
MOST_MARKS = 500
WHEELS = 0.8  # of the distance between wheels that turn alike: both radii together


def ends_of(solution: Solution, shown: Scenery, joint: Mapping[str, Any]) -> list[float | None]:
    """[lower, upper] rigid stops, None where there is none: along marker a's axis [m], or about it from its x-axis."""
    own = {event.side: k for k, event in enumerate(_stops(solution)) if event.name in _limits(joint["name"])}
    if not own or not solution.model.has("elements"):
        return []
    gaps, axes = _gaps(solution), shown.axes(joint["marker_a"])[0]
    if joint["drawing"] == "slide":
        way = shown.place(joint["marker_b"], 1.0)[0] - shown.place(joint["marker_a"], 1.0)[0]
        at = float(way @ axes[:, 2 if is_spatial(solution.model) else 0])
    else:
        x = shown.axes(joint["marker_b"])[0][:, 0]
        at = float(np.arctan2(x @ axes[:, 1], x @ axes[:, 0]))
    return [at - side * float(gaps[own[side]]) if side in own else None for side in (1, -1)]


def time_marks(solution: Solution) -> list[list[float]]:
    """[time, kind] of impacts (0), changes of mode (1) and events (2), for the time axes; evenly fewer of very many."""
    found = [(one.time, 0.0) for one in impacts(solution)]
    found += [(one.time, float(KINDS.index(one.kind))) for one in solution.events if one.kind in KINDS[1:]]
    kept = sorted(found)[:: 1 + len(found) // MOST_MARKS]
    return [[round(float(t), 9), kind] for t, kind in kept if np.isfinite(t)]


def _stops(solution: Solution) -> list[Any]:
    return [event for event in solution.model.mode_events if event.side]


def _gaps(solution: Solution) -> np.ndarray:
    """(n_stop,) at the first sample."""
    model, q, v = solution.model, solution.q[0], solution.q_dot[0]
    at = dict(zip(("q_i", "q_d"), parts(model, q), strict=True))
    at |= dict(zip(("q_i_dot", "q_d_dot"), rate_parts(model, q, v), strict=True))
    c, at["q_d"] = at_home(model, model.constants(solution.parameters), at["q_d"])
    return np.asarray(model.evaluate("elements", **at, t=float(solution.t[0]), c=c)["gap"]).ravel()


def held(solution: Solution, joint: str, t: np.ndarray) -> str | None:
    """1 at the frames t (N,) at which friction or a stop holds the joint, else 0; None where nothing can."""
    if joint not in rubbing(solution.model) and joint not in stopping(solution.model):
        return None
    names = [f"{joint}.{end}_mode" for end in ("friction", "lower", "upper")]
    modes = [
        solution.measures[:, solution.model.measures.index(name)] for name in names if name in solution.model.measures
    ]
    before = np.clip(np.searchsorted(solution.t, t, side="right") - 1, 0, None)
    return packed((np.array(modes) == 0).any(axis=0)[before].astype(float))


def wheels(solution: Solution, shown: Scenery, joint: Mapping[str, Any]) -> list[float]:
    """Radii [m] of the wheels at markers a and b of a gear or belt, in its ratio; none where both are in one place."""
    if joint["type"] not in ("gear", "belt") or not solution.model.has("constraints"):
        return []
    row = next(k for k, one in enumerate(solution.model.description.constraints) if one.joint == joint["name"])
    c = solution.model.constants(solution.parameters)
    at = {"q": solution.q[0], "q_dot": solution.q_dot[0], "t": float(solution.t[0]), "c": c}
    C_q = np.asarray(solution.model.evaluate("constraints", **at)["C_q"])[row]
    factors = [C_q[_turn(solution, joint[key])] for key in ("marker_a", "marker_b")]
    apart = float(np.linalg.norm(np.subtract(*(shown.place(joint[key], 1.0)[0] for key in ("marker_a", "marker_b")))))
    if apart < 1e-9 * shown.size() or not all(factors):
        return []
    together = apart if factors[0] * factors[1] > 0 else WHEELS * apart
    return [together * abs(factor) / sum(map(abs, factors)) for factor in factors]


def with_wheels(
    shown: Scenery, joints: Sequence[Mapping[str, Any]], low: np.ndarray, high: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """A box (3,), (3,) that holds the wheels, too."""
    for joint in joints:
        for (body, k), radius in zip((joint["a"], joint["b"]), joint["wheels"], strict=False):
            own = shown.bodies[body]
            hub = shown.world(own, own.markers, 1.0)[:, k]
            out = radius * np.array([1.0, 1.0, float(is_spatial(shown.model))])
            low, high = np.minimum(low, hub.min(axis=0) - out), np.maximum(high, hub.max(axis=0) + out)
    return low, high


def _turn(solution: Solution, marker: str) -> int:
    """The coordinate by which the body of a marker turns: its own angle, or that of the joint that carries it there."""
    model = solution.model
    body = next(one.body for one in model.description.drawing.points if f"{one.body}.{one.name}" == marker)
    of_joints = [f"{one.name}.angle" for one in model.description.joints if one.marker_b == marker]
    return next(model.coordinates.index(name) for name in (f"{body}.theta", *of_joints) if name in model.coordinates)


def _limits(joint: str) -> tuple[str, str]:
    """What the stops of a joint are called."""
    return f"{joint}.limits.lower", f"{joint}.limits.upper"

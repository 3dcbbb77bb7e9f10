"""A better q_i at a position: one coordinate of q_i changes places with a dependent one.

With dq_d = W dq_i, W = -C_qd^-1 C_qi, exchanging q_i[k] and q_d[j] multiplies |det C_qd| by |W_jk|. Coordinates are
compared as lengths: angles count times the mechanism's length.
"""

from __future__ import annotations

import hashlib
import inspect
import json
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib.metadata import entry_points
from pathlib import Path
from typing import Any, TypeVar

import numpy as np

from runtime.contract.coordinates import (
    charts_in,
    dependent_part,
    independent,
    independent_rates,
    mechanism_length,
    rate_parts,
    turning_columns,
)
from runtime.contract.errors import ModelError, SymgenError
from runtime.contract.kept_models import KeptModels, generated_aside
from runtime.contract.model import EmittedModel
from runtime.contract.orientations import parameter_rates, product, rotation_vector
from runtime.running.stepped_model import SteppedModel
from runtime.solutions.solution import Solution

M = TypeVar("M", bound=EmittedModel)
CLEARLY = 3.0  # times larger determinant that is worth an exchange
LIKELY = 0.5  # of the largest gain: a loop unknown with that much is preferred, as closed forms stay closed forms


@dataclass(frozen=True)
class Exchange:
    """The coordinate of q_i that becomes dependent, the one that takes its place, and the gain in |det C_qd|."""

    out: str
    into: str
    gain: float

    def apply(self, names: list[str]) -> list[str]:
        """Names with the one in the other's place."""
        return [self.into if name == self.out else name for name in names]


def best_exchange(model: EmittedModel, q: np.ndarray, C_q: np.ndarray, length: float = 0.0) -> Exchange | None:
    """The exchange of a rigid coordinate that gains most at q (n,) and C_q (rows x n); None if C_qd is singular.

    length [m] of the mechanism elsewhere: the lever arms of C_q alone shrink to nothing where a single rod and the arm
    that it turns lie in one line, just where an angle is about to determine nothing. Turns whose velocities are angular
    velocities exchange with each other and with coordinates; all of an orientation may be independent, or none.
    """
    length = max(length, mechanism_length(model, C_q))
    names, slopes, scale = by_velocities(model, q, C_q, length)
    turning = {f"{record.body}.norm" for record in model.description.orientations}
    rows = [row for row in model.kept_rows if model.constraints[row] not in turning]
    given = set(model.places.parameters.ravel().tolist())  # Euler parameters follow from their turns
    own = {model.coordinates[column] for column in given}
    q_i, q_d = ([name for name in part if name not in own] for part in (model.q_i, model.q_d))
    i, d = ([names.index(name) for name in part] for part in (q_i, q_d))
    try:
        W = -np.linalg.solve(slopes[np.ix_(rows, d)], slopes[np.ix_(rows, i)])
    except np.linalg.LinAlgError:
        return None
    gains = np.abs(W) * scale[d][:, None] / scale[i][None, :]
    gains[[name in model.elastic for name in q_d]] = 0.0
    gains[:, [name in model.elastic for name in q_i]] = 0.0
    if not gains.size or not np.isfinite(gains).all():
        return None
    in_loop = np.array([name in model.loop_unknowns for name in q_d])
    preferred = np.where(in_loop[:, None], gains, 0.0)
    chosen = preferred if preferred.max() >= LIKELY * gains.max() else gains
    j, k = np.unravel_index(int(chosen.argmax()), chosen.shape)
    return Exchange(q_i[int(k)], q_d[int(j)], float(chosen[j, k]))


def by_velocities(
    model: EmittedModel, q: np.ndarray, C_q: np.ndarray, length: float
) -> tuple[list[str], np.ndarray, np.ndarray]:
    """(names, C_q by velocities, scales) of all coordinates, followed by the turns: along their angular velocities."""
    names, columns, scales = list(model.coordinates), [C_q], [np.where(turning_columns(model), length, 1.0)]
    for record, e in zip(model.description.orientations, model.places.parameters, strict=True):
        names += record.turns
        columns.append(C_q[:, e] @ parameter_rates(np.tile(q[e], (3, 1)), np.eye(3)).T)
        scales.append(np.full(3, length))
    return names, np.hstack(columns), np.concatenate(scales)


# A scheme's state from one q_i to another: positions and rates exactly, and what the scheme remembers of the past.
#
# Central difference remembers q(t - h) by its increments d = q(t) - q(t - h). A coordinate that takes another's place
# gets the increment that the closure gives for the old increments: exactly the same two positions of the mechanism.

EXCHANGE_CLOSURES = 6
CONJUGATE = np.array([1.0, -1.0, -1.0, -1.0])


def carried(old: SteppedModel, z: np.ndarray, new: SteppedModel, observed: Solution) -> np.ndarray:
    """z of the new segment at the state of the old one; observed: that state observed, one sample."""
    result = new.start(observed.q[0], observed.q_dot[0], int(z[1]))
    before, after = old.plan.scheme.layout, new.plan.scheme.layout
    for name in new.plan.scheme.carried:
        result[after.slice(name)] = z[before.slice(name)]
    stays = np.array([a == b for a, b in zip(old.model.q_i, new.model.q_i, strict=True)])
    for name in new.plan.scheme.history:
        values = result[after.slice(name)]
        result[after.slice(name)] = np.where(stays, z[before.slice(name)], values)
    for name in new.plan.scheme.carried_by_coordinate:
        result[after.slice(name)] = np.where(stays, z[before.slice(name)], result[after.slice(name)])
    if {"d", "a"} <= set(new.plan.scheme.history):  # it remembers the last step by increments
        for k in np.flatnonzero(~stays):
            d, a = _increment(old, z, observed, new.model.q_i[k], float(new.plan.scheme.step_sizes[k]))
            result[after.slice("d")][k], result[after.slice("a")][k] = d, a
    return result


def _increment(old: SteppedModel, z: np.ndarray, observed: Solution, name: str, h: float) -> tuple[float, float]:
    """(q(t) - q(t - h), q_ddot(t - h)) of a dependent coordinate of the old segment.

    Coordinates with another step than h are not remembered at t - h; they are taken along their acceleration.
    """
    model, layout, scheme = old.model, old.plan.scheme.layout, old.plan.scheme
    d, a = z[layout.slice("d")], z[layout.slice("a")]
    same = np.isclose(scheme.step_sizes, h, rtol=1e-12)
    now = observed.q_ddot[0]
    q_i, v_i = independent(model, observed.q[0], observed.q_dot[0])
    a_i = independent_rates(model, observed.q[0], now)
    x, c = z[layout.slice("x")], old.c
    guess = dependent_part(model, observed.q[0] - h * observed.q_dot[0] + h**2 / 2 * now)
    turns, omega = model.places.turns, np.concatenate(rate_parts(model, observed.q[0], observed.q_dot[0]))
    if len(turns):  # all from the charts of z
        c = c.copy()
        c[charts_in(model)] = z[layout.slice("chart")]
        for own, theta in zip(turns, _thetas(model, observed.q[0], c), strict=True):
            turned = np.concatenate([q_i, guess])
            turned[own] = theta
            turned[own[own >= len(q_i)]] -= h * omega[own[own >= len(q_i)]]
            q_i, guess = turned[: len(q_i)], turned[len(q_i) :]
    earlier = np.where(same, x - d, q_i - h * v_i + h**2 / 2 * a_i)
    earlier_v = np.where(same, d / h - h / 2 * a, v_i - h * a_i)
    t = float(observed.t[0]) - h
    q_d = closed(model, c, t, earlier, guess)
    values: dict[str, Any] = {"q_i": earlier, "q_d": q_d, "q_i_dot": earlier_v, "t": t, "c": c, "q_i_ddot": a}
    values["q_d_dot"] = model.evaluate("velocities", **values)["q_d_dot"]
    q_d_ddot = np.asarray(model.evaluate("accelerations", **values)["q_d_ddot"]).ravel()
    position = model.q_d.index(name)
    return _turned(model, observed.q[0], q_d, name), float(q_d_ddot[position])


def _thetas(model: EmittedModel, q: np.ndarray, c: np.ndarray) -> list[np.ndarray]:
    """Rotation vectors from the charts in c to where the bodies are."""
    charts = c[charts_in(model)].reshape(-1, 4)
    return [
        rotation_vector(product(chart * CONJUGATE, q[e]))
        for chart, e in zip(charts, model.places.parameters, strict=True)
    ]


def _turned(model: EmittedModel, q: np.ndarray, before: np.ndarray, name: str) -> float:
    """By how much a dependent coordinate changed to q (n,) from q_d before; of a turn, in the axes of its body."""
    if name in model.coordinates:
        return float(q[model.coordinates.index(name)] - before[model.q_d.index(name)])
    record, e = next(
        (record, e)
        for record, e in zip(model.description.orientations, model.places.parameters, strict=True)
        if name in record.turns
    )
    earlier = before[[model.q_d.index(one) for one in record.parameters]]
    return float(rotation_vector(product(earlier * CONJUGATE, q[e]))[record.turns.index(name)])


def closed(model: EmittedModel, c: np.ndarray, t: float, q_i: np.ndarray, q_d: np.ndarray) -> np.ndarray:
    """q_d at q_i from a near guess, by Newton until it no longer moves."""
    for _ in range(EXCHANGE_CLOSURES):
        q_d = np.asarray(model.evaluate("closure", q_i=q_i, q_d=q_d, t=t, c=c)["q_d_next"]).ravel()
    return q_d


# ---- variants of a model, by the entry point `symgen.variants` ----------------------------------------------------
#
# generate(scene_toml_text, independent, groups, folder, state=..., redundant=...) writes a model into the folder.

ENTRY_POINTS = "symgen.variants"
Generate = Callable[..., Path]


class NoVariant(ModelError):
    """A variant that cannot be had; the message says why and what to do."""


def variant_of(model: M, q_i: Sequence[str], q: np.ndarray) -> M:
    """The model of the same scene with other q_i, group by group in the same places; q: coordinates where it is needed.

    Raises NoVariant.
    """
    groups = [(group.name, [q_i[k] for k in group.positions]) for group in model.groups]
    generate: Generate | None = next((entry.load() for entry in entry_points(group=ENTRY_POINTS)), None)
    if generate is None or not model.scene_toml:
        raise NoVariant(
            f"no generator of variants is installed; set partition.independent = {list(q_i)} in the scene, "
            "or install symgen beside the runtime, and run again"
        )
    key = json.dumps([model.digest, list(q_i), groups, made_by(generate)])
    state: Mapping[str, float] = dict(zip(model.coordinates, map(float, q), strict=True))
    redundant = list(model.redundant)

    def generated(folder: Path) -> Path:
        return generate(model.scene_toml, list(q_i), groups, folder, state=state, redundant=redundant)

    name, kind = hashlib.sha256(key.encode()).hexdigest()[:32], type(model)
    try:
        found = KeptModels("variants").model(name, kind, generated)
        if found is None:
            found = generated_aside(kind, generated)
    except (OSError, SymgenError) as error:
        raise NoVariant(f"a variant with q_i = {', '.join(q_i)} cannot be generated: {error}") from error
    same = ("coordinates", "constraints", "elastic", "measures", "joints")
    if (
        any(getattr(found, name) != getattr(model, name) for name in same)
        or list(found.q_i) != list(q_i)
        or [entry.name for entry in found.parameters] != [entry.name for entry in model.parameters]
    ):
        raise NoVariant(
            f"the variant of {model.name} with q_i = {', '.join(q_i)} does not match the model; "
            "regenerate the model with the installed version"
        )
    return replace(found, input_values=model.input_values, sources=model.sources)


def made_by(generate: Generate) -> str:
    """SHA-256 of the sources beside a generator: what another version made is not taken for its own."""
    found = hashlib.sha256()
    try:
        root = Path(inspect.getfile(generate)).parent
        for path in sorted(root.rglob("*.py")):
            found.update(f"{path.relative_to(root).as_posix()} ".encode() + path.read_bytes())
    except (OSError, TypeError):  # no sources to be had: by its name alone
        found.update(repr(getattr(generate, "__qualname__", "")).encode())
    return found.hexdigest()

"""Random mixtures of friction and rigid stops, three to six of them, against time stepping that knows no modes."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, sin
from typing import Any

import numpy as np
import pytest

from runtime import Model, Solution, simulate
from symgen.scene import Scene, SceneRecord
from tests.support.time_stepping import Law, Links, Mechanism, Rails, Stop, moreau

Build = Callable[[SceneRecord], Model]
Mixture = tuple[Scene, Mechanism, Callable[[Solution], np.ndarray]]  # and what reads its coordinates (N, n) off a run
GRAVITY = 9.81


def law(random: np.random.Generator, most: float) -> Law:
    """Half of them with a breakaway."""
    coulomb = float(random.uniform(0.1, 1.0) * most)
    more = 1.5 if random.random() < 0.5 else 1.0
    return {"coulomb": coulomb, "breakaway": more * coulomb, "stribeck_velocity": 0.3, "viscous": 0.01 * most}


def as_field(one: Law | None) -> dict[str, Any]:
    """Of a joint; what does not fall takes no velocity over which it falls."""
    if one is None:
        return {}
    left = {"coulomb", "viscous"} if one["breakaway"] == one["coulomb"] else one.keys()
    return {"friction": {key: one[key] for key in left}}


def rails(random: np.random.Generator) -> Mixture:
    """Blocks on two rails of any angle, side by side or one on the other, pushed to and fro."""
    n, angles = int(random.integers(3, 5)), random.uniform(-0.5, 1.6, 2)
    scene, laws, stops, start = Scene("rails").gravity(0.0, -GRAVITY), [], [], np.zeros(n)
    scene.ground(markers={f"rail{k}": {"position": (0, 0), "angle": float(a)} for k, a in enumerate(angles)})
    masses, pushes, rates, G = random.uniform(0.5, 3, n), random.uniform(0, 25, n), random.uniform(2, 8, n), np.eye(n)
    of = random.integers(0, 2, n)
    for k in range(n):
        angle, below = float(angles[of[k]]), [j for j in range(k) if of[j] == of[k]][-1:]
        seat = f"ground.rail{of[k]}"
        start[k] = random.uniform(0.05, 0.3)
        if below and random.random() < 0.8:
            G[k, below[0]], seat, start[k] = -1.0, f"b{below[0]}.origin", start[k] + start[below[0]]
        rubs, ends = random.random() < 0.5, {"lower": 0.0, "restitution": float(random.choice([0.0, 0.3, 0.7]))}
        ends |= {"upper": 0.5} if random.random() < 0.5 else {}
        stops += [Stop(k, side, ends[key], ends["restitution"]) for key, side in SIDES.items() if key in ends]
        laws.append(law(random, 8.0) if rubs else None)
        scene.rigid(f"b{k}", mass=float(masses[k]), inertia=0.1)
        scene.prismatic(f"j{k}", seat, f"b{k}.origin", limits=ends, **as_field(laws[k]))
        scene.force(
            f"push{k}", f"b{k}.origin", *(f"{pushes[k] * a} * sin({rates[k]} * t)" for a in (cos(angle), sin(angle)))
        )
        scene.initial({f"b{k}.x": start[k] * cos(angle), f"b{k}.y": start[k] * sin(angle), f"b{k}.theta": angle})
    along = angles[of]

    def read(run: Solution) -> np.ndarray:
        return np.stack([run[f"b{k}.x"] * cos(a) + run[f"b{k}.y"] * sin(a) for k, a in enumerate(along)], axis=1)

    def loads(t: float) -> np.ndarray:
        return np.asarray(-masses * GRAVITY * np.sin(along) + pushes * np.sin(rates * t))

    return scene, Rails(laws, stops, G, masses, loads), read


SIDES = {"lower": 1, "upper": -1}


def links(random: np.random.Generator) -> Mixture:
    """A chain that swings, each hinge with friction, stops, or both."""
    n = int(random.integers(2, 4))
    scene, last = Scene("links").gravity(0.0, -GRAVITY), "ground.origin"
    laws, stops, lengths = [], [], random.uniform(0.5, 1.0, n)
    for k, length in enumerate(lengths.tolist()):
        kind = random.integers(0, 3)
        laws.append(law(random, 3.0) if kind != 1 else None)
        more = as_field(laws[k])
        if kind != 0:
            e = float(random.choice([0.0, 0.3, 0.6]))
            low, high = float(random.uniform(-1.5, -0.2)), float(random.uniform(0.2, 1.0))
            more["limits"] = {"lower": low, "upper": high, "restitution": e}
            stops += [Stop(k, 1, low, e), Stop(k, -1, high, e)]
        scene.rigid(f"l{k}", mass=1.0, inertia=0.08, center_of_mass=(length / 2, 0.0),
                    markers={"tip": {"position": (length, 0.0)}})  # fmt: skip
        scene.revolute(f"j{k}", last, f"l{k}.origin", **more)
        last = f"l{k}.tip"
    push = float(random.uniform(0, 6))
    scene.effort("drive", coordinate="j0.angle", value=f"{push} * sin(5 * t)")
    own = Links(laws, stops, lengths, [0.08] * n, (lambda t: push * sin(5 * t),), GRAVITY)
    return scene, own, lambda run: np.stack([run[f"l{k}.theta"] for k in range(n)], axis=1)


def loop(random: np.random.Generator) -> Mixture:
    """A four-bar between stops of its crank, its rocker, or both."""
    lengths, span = (0.4, 1.0, 0.8), 1.2
    scene = Scene("loop").gravity(0.0, -GRAVITY).ground(markers={"right": {"position": [span, 0.0]}})
    for k, length in enumerate(lengths):
        scene.rigid(f"l{k}", mass=1.0, inertia=length**2 / 12, center_of_mass=(length / 2, 0.0),
                    markers={"tip": {"position": (length, 0.0)}})  # fmt: skip
    seats = ("ground.origin", "l0.tip", "l1.tip", "ground.right")
    laws = [law(random, 0.5) if random.random() < 0.7 else None for _ in seats]
    stops, fields = [], [as_field(one) for one in laws]
    for k, low, high in ((0, 0.1, 1.1), (3, 1.3, 1.9)):
        if random.random() < 0.8:
            e = float(random.choice([0.0, 0.4]))
            ends = [low + float(random.uniform(0, 0.1)), high - float(random.uniform(0, 0.1))]
            fields[k] |= {"limits": dict(zip(SIDES, ends, strict=True), restitution=e)}
            stops += [Stop(k, side, end, e) for side, end in zip((1, -1), ends, strict=True)]
    for k, seat in enumerate(seats):
        scene.revolute(f"j{k}", seat, f"l{min(k, 2)}.{'tip' if k == 2 else 'origin'}", **fields[k])
    push = float(random.uniform(3, 8))
    scene.effort("drive", coordinate="j0.angle", value=f"{push} * sin(4 * t)")
    scene.initial({"l0.theta": {"value": 0.6, "fixed": True}, "l1.theta": 0.5, "l2.theta": 1.5})
    own = Links(laws, stops, lengths, [one**2 / 12 for one in lengths], (lambda t: push * sin(4 * t),), GRAVITY, span)
    return scene, own, lambda run: np.stack([run[f"l{k}.theta"] for k in range(3)], axis=1)


def pressed_loop(random: np.random.Generator) -> Mixture:
    """The four-bar of `loop` with bearings that rub by what presses on them, between stops of crank and rocker."""
    lengths, span, radius = (0.4, 1.0, 0.8), 1.2, 0.05
    scene = Scene("loop").gravity(0.0, -GRAVITY).ground(markers={"right": {"position": [span, 0.0]}})
    for k, length in enumerate(lengths):
        scene.rigid(f"l{k}", mass=1.0, inertia=length**2 / 12, center_of_mass=(length / 2, 0.0),
                    markers={"tip": {"position": (length, 0.0)}})  # fmt: skip
    laws: list[Law | None] = []
    for k in range(4):
        mu = float(random.uniform(0.1, 0.5)) if k in (0, 3) or random.random() < 0.5 else 0.0
        more = 1.3 if random.random() < 0.5 else 1.0
        laws.append({"coulomb": mu, "breakaway": more * mu, "stribeck_velocity": 0.2, "viscous": 0.0} if mu else None)
    fields: list[dict[str, Any]] = []
    for one in laws:
        law_ = {} if one is None else {"mu": one["coulomb"], "radius": radius}
        if one is not None and one["breakaway"] > one["coulomb"]:
            law_ |= {"mu_static": one["breakaway"], "stribeck_velocity": one["stribeck_velocity"]}
        fields.append({"friction": law_} if law_ else {})
    stops = []
    for k, low, high in ((0, 0.1, 1.1), (3, 1.3, 1.9)):
        ends = [low + float(random.uniform(0, 0.1)), high - float(random.uniform(0, 0.1))]
        fields[k] |= {"limits": dict(zip(SIDES, ends, strict=True), restitution=0.0)}
        stops += [Stop(k, side, end, 0.0) for side, end in zip((1, -1), ends, strict=True)]
    for k, seat in enumerate(("ground.origin", "l0.tip", "l1.tip", "ground.right")):
        scene.revolute(f"j{k}", seat, f"l{min(k, 2)}.{'tip' if k == 2 else 'origin'}", **fields[k])
    push = float(random.uniform(4, 9))
    scene.effort("drive", coordinate="j0.angle", value=f"{push} * sin(6 * t)")
    scene.initial({"l0.theta": {"value": 0.6, "fixed": True}, "l1.theta": 0.5, "l2.theta": 1.5})
    inertia, drives = [one**2 / 12 for one in lengths], (lambda t: push * sin(6 * t),)
    own = Links(laws, stops, lengths, inertia, drives, GRAVITY, span, [radius] * 4)
    return scene, own, lambda run: np.stack([run[f"l{k}.theta"] for k in range(3)], axis=1)


MIXTURES = {"rails": rails, "links": links, "loop": loop, "pressed_loop": pressed_loop}


LEAST_ORDER = 3.0  # of rk4, as steps of 10, 5 and 2.5 ms show it: 3.3 to 4.2 by case
LARGEST = 2e-6  # rad or m: what steps of 5 and 2.5 ms differ by at most


@pytest.mark.every_push("links-1")
@pytest.mark.parametrize("case", [f"{name}-{seed}" for name in MIXTURES for seed in range(4)])
def test_mixtures_are_the_limit_of_time_stepping(model_of: Build, case: str) -> None:
    """Its error falls with its step; runs with half the step tell the same events and differ by far less, by the order
    of the method across all events: one that is located, or passed on, less well takes it away."""
    name, seed = case.split("-")
    scene, own, read = MIXTURES[name](np.random.default_rng(int(seed)))
    model, t_end = model_of(scene.simulation(t_end=1.0, dt=0.01, scheme="rk4").build()), 1.0
    runs = [simulate(model, dt=dt, seen_every=0.02, error="off") for dt in (0.01, 0.005, 0.0025)]
    told = [[(one.kind, one.name) for one in run.events] for run in runs]
    assert all(run.status.ok for run in runs) and len(told[0]) > 1 and told[0] == told[1] == told[2]
    coarse, middle, fine = (read(run)[: round(t_end / 0.02) + 1] for run in runs)
    first, second = np.abs(coarse - middle).max(), np.abs(middle - fine).max()
    assert second < LARGEST and second < first / 2**LEAST_ORDER
    off = [np.abs(moreau(own, fine[0], h, t_end)[0][:: round(0.02 / h)] - fine).max() for h in (2e-3, 5e-4)]
    assert off[1] < 0.005 and off[1] < 0.6 * off[0]

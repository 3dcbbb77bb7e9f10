"""Told against true errors: `python -m benchmarks.pages.estimates [--of stops] [--count 100] [--first 0]`.

Random chains of rods with stops, kinks and jumps, whose equations are written out here; random trees and closed loops
(tests/support/random_mechanisms.py); or the cases of the hard suite, the first part of their motion. Each is run by
several schemes with several numbers of steps, against DOP853 at 1e-11: the true RMS error of the worst coordinate over
its RMS amplitude, and what the run itself says, `solution.error`.
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import HealthCheck, Phase, given, seed, settings
from scipy.integrate import solve_ivp

from benchmarks.scenes.hard_suite import HARD_SUITE
from runtime import Solution, SymgenError, reference_solution, simulate
from runtime.contract.coordinates import followed
from runtime.model import Model
from runtime.results.motion_error import amplitudes, motion_error
from symgen.generate import model_of
from symgen.scene import Scene, SceneRecord
from tests.support.modes import modes_at
from tests.support.random_mechanisms import four_bars, trees

SCHEMES = ("single_rate", "rk4", "dopri5", "exponential", "exponential_rk4")
RADIANS = (0.2, 0.8)  # of the fastest motion a step
STEPS = 200
FEW_OR_MANY = (30, 100, 400)  # steps of a chain with stops
SEEN = 1200  # samples of the reference of such a chain, among them all ends of steps
SMALLEST = 1e-16  # absolute tolerance of references: deflections of stiff rods are that small
ROUNDING = 1e-11  # relative errors below this are not told
WITHIN, FAR, LARGE = 10.0, 100.0, 0.1
GRAVITY = 9.81


@dataclass(frozen=True)
class Judged:
    """A run: mechanism, settings, status; its true error and the one that it tells (NaN: none)."""

    mechanism: str
    scheme: str
    steps: int
    status: str
    said: bool
    true: float
    told: float

    @property
    def whole(self) -> bool:
        """Did it come to its end?"""
        return self.status in ("completed", "inaccurate")

    @property
    def compared(self) -> bool:
        """Are both errors above rounding, and told?"""
        return self.whole and self.true > ROUNDING and np.isfinite(self.told)

    @property
    def silent(self) -> bool:
        """Off by more than LARGE of an amplitude, completed, and no word of it?"""
        return self.status == "completed" and self.true > LARGE and not self.said

    @property
    def condemned(self) -> bool:
        """Within a hundredth of an amplitude, and yet `inaccurate`?"""
        return self.status == "inaccurate" and self.true < LARGE / 10


# ---- chains of rods with stops, by their own equations ---------------------------------------------------------------


@dataclass(frozen=True)
class Chain:
    """Slender rods on hinges, one after the other: lengths [m], masses [kg].

    torques from the ground: the expression of a scene, and the same as a function of t, the rod's angle and its rate.
    """

    name: str
    lengths: tuple[float, ...]
    masses: tuple[float, ...]
    torques: tuple[tuple[str, Any], ...]
    start: tuple[float, ...]
    t_end: float

    def scene(self) -> SceneRecord:
        """The chain as a scene."""
        builder, parent = Scene("chain").gravity(0, -GRAVITY), "ground.origin"
        for k, (length, mass) in enumerate(zip(self.lengths, self.masses, strict=True)):
            builder.rigid(
                f"rod{k}",
                mass=mass,
                inertia=mass * length**2 / 12,
                center_of_mass=(length / 2, 0),
                markers={"tip": {"position": (length, 0)}},
            )
            builder.revolute(f"hinge{k}", parent, f"rod{k}.origin").measure(f"a{k}", "coordinate", f"rod{k}.theta")
            torque = self.torques[k][0].format(a=f"a{k}", v=f"a{k}_dot")
            builder.torque(f"drive{k}", f"rod{k}.origin", torque)
            parent = f"rod{k}.tip"
        builder.initial({f"rod{k}.theta": value for k, value in enumerate(self.start)})
        return builder.simulation(t_end=self.t_end, dt=self.t_end / 100, scheme="rk4").build()

    def exact(self, times: np.ndarray) -> np.ndarray:
        """(N, n) angles of the rods against the ground, by Lagrange's equations in absolute angles."""
        length, m = np.array(self.lengths), np.array(self.masses)
        n = len(m)
        beyond = np.array([m[k + 1 :].sum() for k in range(n)])
        first = length * (m / 2 + beyond)
        A = np.array([[length[min(i, j)] * first[max(i, j)] for j in range(n)] for i in range(n)])
        A[np.diag_indices(n)] = length**2 * (m / 3 + beyond)

        def slope(t: float, y: np.ndarray) -> np.ndarray:
            a, v = y[:n], y[n:]
            off = a[:, None] - a[None, :]
            drive = np.array([self.torques[k][1](t, a[k], v[k]) for k in range(n)])
            forces = drive - (A * np.sin(off)) @ v**2 - GRAVITY * first * np.cos(a)
            return np.concatenate([v, np.linalg.solve(A * np.cos(off), forces)])

        found = solve_ivp(
            slope,
            (0.0, times[-1]),
            [*self.start, *np.zeros(n)],
            method="DOP853",
            t_eval=times,
            rtol=1e-10,
            atol=1e-12,
            max_step=times[-1] / 2000,
        )
        return np.asarray(found.y[:n].T)


def random_chain(rng: np.random.Generator, k: int) -> Chain:
    """One to three rods that fall, with a stop, a kinked damper, a one-sided spring, a jump or dry friction at each."""
    n = int(rng.integers(1, 4))
    lengths = tuple(rng.uniform(0.3, 1.0, n).tolist())
    masses = tuple(rng.uniform(0.5, 2.0, n).tolist())
    torques = tuple(random_torque(rng) for _ in range(n))
    start = tuple(rng.uniform(-1.0, 1.0, n).tolist())
    return Chain(f"chain {k}", lengths, masses, torques, start, float(rng.uniform(1.0, 4.0)))


def random_torque(rng: np.random.Generator) -> tuple[str, Any]:
    """What acts on a rod from the ground: the expression, and the function of (t, a, rate)."""
    stiff, at, damp = float(10 ** rng.uniform(1.5, 4)), float(rng.uniform(0.2, 1.4)), float(10 ** rng.uniform(-2, 0.5))
    when, size = float(rng.uniform(0.1, 0.9)), float(rng.uniform(1, 20))
    kinds = [
        (
            f"where({{a}} < -{at!r}, {stiff!r}*(-{at!r} - {{a}}), 0) - {damp!r}*{{v}}",
            lambda t, a, v: (stiff * (-at - a) if a < -at else 0.0) - damp * v,
        ),
        (f"-{stiff!r}*max(0, {{a}} - {at!r})", lambda t, a, v: -stiff * max(0.0, a - at)),
        (f"{stiff!r}*max(0, -{at!r} - {{a}})", lambda t, a, v: stiff * max(0.0, -at - a)),
        (f"-{10 * damp!r}*abs({{a}})*{{v}}", lambda t, a, v: -10 * damp * abs(a) * v),
        (
            f"where(t < {when!r}, {size!r}, -{size!r}) - {damp!r}*{{v}}",
            lambda t, a, v: (size if t < when else -size) - damp * v,
        ),
        (f"-{size!r}*tanh({{v}}/0.05)", lambda t, a, v: -size * np.tanh(v / 0.05)),
        (f"-{stiff!r}*sin({{a}})", lambda t, a, v: -stiff * np.sin(a)),
    ]
    return kinds[int(rng.integers(len(kinds)))]


def judged_chain(chain: Chain) -> Iterator[Judged]:
    """All runs of a chain with stops."""
    model = model_of(chain.scene())
    times = np.linspace(0.0, chain.t_end, SEEN + 1)
    exact = chain.exact(times)
    assert len(exact) == len(times)
    for scheme in SCHEMES:
        for steps in FEW_OR_MANY:
            run = _tried(model, scheme, chain.t_end / steps, chain.t_end, 1, {})
            if run is not None:
                yield _judged(chain.name, scheme, steps, run, exact[:: SEEN // steps][: len(run.t)])


# ---- random trees and loops, and the hard suite ---------------------------------------------------------------------


@dataclass(frozen=True)
class Mechanism:
    """A scene, and how it starts: arguments of `simulate`."""

    name: str
    scene: SceneRecord
    start: dict[str, Any]


def mechanisms(of: str, count: int, number: int) -> list[Mechanism]:
    """So many random scenes, the same for the same number; or the hard suite."""
    if of == "hard":
        return [
            Mechanism(name, case.make(), {"parameters": case.parameters, "initial": case.initial, "start": case.start})
            for name, case in list(HARD_SUITE.items())[:count]
        ]
    found: list[SceneRecord] = []

    @seed(number)
    @settings(
        max_examples=count,
        database=None,
        deadline=None,
        phases=[Phase.generate],
        suppress_health_check=list(HealthCheck),
    )
    @given({"trees": trees, "loops": four_bars}[of]())
    def collect(scene: SceneRecord) -> None:
        found.append(scene)

    collect()
    return [Mechanism(f"{of} {k}", scene, {}) for k, scene in enumerate(found[:count])]


def judged(one: Mechanism) -> Iterator[Judged]:
    """All runs of a mechanism."""
    model = model_of(one.scene)
    first = simulate(model, scheme="rk4", dt=1e-9, t_end=1e-9, force=True, error="off", **one.start)
    modes = modes_at(first, [0])[0]
    rate = max(5.0, float(modes.undamped[-1]), modes.fastest_decay, float(np.abs(first.q_dot[0]).max()))
    for radians in RADIANS:
        dt = radians / rate
        times = np.arange(0, STEPS + 1, 5) * dt
        if model.loop_unknowns and not _regular(model, one, 0.2 / rate, float(times[-1])):
            print(f"{one.name}: through a singular position in {times[-1]:.3g} s: left out", file=sys.stderr)
            continue
        try:
            exact = reference_solution(model, t_end=float(times[-1]), times=times, atol=SMALLEST, **one.start)
        except SymgenError as error:
            print(f"{one.name}: no reference at {radians} rad a step: {error}", file=sys.stderr)
            continue
        if not exact.status.ok:
            print(f"{one.name}: no reference at {radians} rad a step: {exact.status}", file=sys.stderr)
            continue
        for scheme in SCHEMES:
            run = _tried(model, scheme, dt, STEPS * dt, 5, one.start)
            if run is not None:
                yield _judged(one.name, scheme, STEPS, run, exact.q[: len(run.t), followed(model)[1]])


def _regular(model: Model, one: Mechanism, dt: float, t_end: float) -> bool:
    """Does a loop keep away from singular positions? There the reference shrinks its steps for ever."""
    trial = simulate(model, scheme="rk4", dt=dt, t_end=t_end, error="off", **one.start)
    return trial.status.ok and not trial.events


def _tried(model: Model, scheme: str, dt: float, t_end: float, every: int, start: dict[str, Any]) -> Solution | None:
    try:
        return simulate(model, scheme=scheme, dt=dt, t_end=t_end, seen_every=every * dt, force=True, **start)
    except SymgenError:  # a scheme that cannot step this model
        return None


def _judged(name: str, scheme: str, steps: int, run: Solution, exact: np.ndarray) -> Judged:
    said = "remark" in run.stats or bool(run.events)
    seen = run.q[:, followed(run.model)[1]]
    true = motion_error(run.model, run.t, seen, exact, amplitudes(run.model, exact)).largest
    return Judged(name, scheme, steps, run.status.name, said, true, run.error.largest)


def table(found: list[Judged]) -> list[str]:
    """Rows of the page, by scheme, and all together."""
    rows = [
        "| scheme | runs | to their end | told within 10 | too small by 100 | off above a tenth | of these silent "
        "| right but condemned |",
        "|---|---:|---:|---:|---:|---:|---:|---:|",
    ]
    for scheme in (*SCHEMES, "all"):
        part = [one for one in found if scheme in (one.scheme, "all")]
        done = [one for one in part if one.whole]
        ratios = np.array([one.told / one.true for one in done if one.compared])
        near = int(((ratios < WITHIN) & (ratios > 1 / WITHIN)).sum())
        large, silent = sum(one.true > LARGE for one in done), sum(one.silent for one in done)
        condemned = sum(one.condemned for one in done)
        rows.append(
            f"| {scheme} | {len(part)} | {len(done)} | {100 * near / max(1, len(ratios)):.1f} % of {len(ratios)} "
            f"| {int((ratios < 1 / FAR).sum())} | {large} | {silent} | {condemned} |"
        )
    return rows


def main(arguments: list[str] | None = None) -> int:
    """Judge, print the table and the silent runs."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.estimates", description=__doc__)
    parser.add_argument("--of", choices=("stops", "trees", "loops", "hard"), default="stops")
    parser.add_argument("--first", type=int, default=0, help="how many to leave out")
    parser.add_argument("--count", type=int, default=40)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path, default=None, help="every run")
    options = parser.parse_args(arguments)
    found: list[Judged] = []
    for runs in _all_runs(options.of, options.first, options.first + options.count, options.seed):
        for one in runs:
            found.append(one)
            if one.silent or one.condemned or (one.compared and one.told < one.true / FAR):
                print(f"{one.mechanism}, {one.scheme}, {one.steps} steps: {one.status}, off {one.true:.2g}, ", end="")
                print(f"told {one.told:.2g}", flush=True)
    print("\n".join(table(found)))
    if options.json is not None:
        options.json.write_text(json.dumps([asdict(one) for one in found], indent=1) + "\n", encoding="utf-8")
    return 0


def _all_runs(of: str, first: int, last: int, number: int) -> Iterator[Iterator[Judged]]:
    if of == "stops":
        rng = np.random.default_rng(number)
        chains = [random_chain(rng, k) for k in range(last)]
        yield from (judged_chain(chain) for chain in chains[first:])
    else:
        yield from (judged(one) for one in mechanisms(of, last, number)[first:])


if __name__ == "__main__":
    sys.exit(main())

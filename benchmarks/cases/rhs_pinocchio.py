"""Right-hand side of rigid trees against Pinocchio (extra `benchmark`): accelerations from angles and their rates."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks.cases.right_hand_side import FUNCTIONS, evaluated, expression, routes, worker
from benchmarks.contenders.by_c_compiler import CompiledProgram
from benchmarks.contenders.pinocchio_tree import Hinge, PinocchioTree, library, version
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from benchmarks.harness.timing import interleave, ratio
from symgen.scene import Scene, SceneRecord
from symgen.scenes.pendulums import chain

LINKS, LENGTH, MASS = 10, 0.5, 0.078
LONG = (20, 50)  # bodies of the chains in space
TREES = 50
GRAVITY = 9.81
PARENTS = (0, 1, 2, 2, 4, 4, 1, 7)  # of the tree in space: body k + 1 hangs on body PARENTS[k], 0 is the ground
AGREEMENT = 1e-10
GOAL = 0.45  # us
ROUNDS = 60
NO_CONSTANTS = np.zeros(0)
SMALLEST = {"LONG": (), "TREES": 1, "ROUNDS": 2}
REMARK = """\
Pinocchio {version} compiled from its headers with -O3 -march=native: `aba` in the LOCAL convention, in a loop of C++
without Python. Its `CasADi code` is `aba` on CasADi's SX, with common subexpressions removed, emitted and compiled as
ours is. Angles of the planar chain are absolute here and relative there. The tree in space has {bodies} bodies on skew
hinges, its coordinates are the hinge angles on both sides. Angles and rates drift by 1e-15 s times their slopes between
calls, so that no work can be kept from one call to the next."""


@dataclass(frozen=True)
class Case:
    """A mechanism on both sides. relative (n x n): their angles from ours."""

    name: str
    scene: SceneRecord
    hinges: list[Hinge]
    gravity: tuple[float, float, float]
    relative: np.ndarray
    goal: float | None = None


def planar_chain(links: int = LINKS) -> Case:
    """The built-in chain of rigid links."""
    relative = np.eye(links) - np.eye(links, k=-1)
    hinges = [
        Hinge(
            k,
            (LENGTH if k else 0.0, 0.0, 0.0),
            np.eye(3),
            MASS,
            (LENGTH / 2, 0.0, 0.0),
            (1.0, 1.0, MASS * LENGTH**2 / 12),
        )
        for k in range(links)
    ]
    return Case(f"planar chain, N = {links}", chain(links), hinges, (0.0, -GRAVITY, 0.0), relative, GOAL)


def skew_tree() -> Case:
    """Bodies on hinges in random directions at random places."""
    rng = np.random.default_rng(3)
    hinges = [_random_hinge(rng, parent) for parent in PARENTS]
    scene = tree_scene(hinges)
    return Case(f"tree in space, {len(hinges)} bodies", scene, hinges, (0.0, 0.0, -GRAVITY), np.eye(len(hinges)))


def skew_chain(bodies: int) -> Case:
    """The same one behind the other."""
    rng = np.random.default_rng(3)
    hinges = [_random_hinge(rng, parent) for parent in range(bodies)]
    return Case(f"chain in space, N = {bodies}", tree_scene(hinges), hinges, (0.0, 0.0, -GRAVITY), np.eye(bodies))


def random_tree(seed: int) -> Case:
    """One to seven bodies, each on any of those before it."""
    rng = np.random.default_rng(seed)
    hinges = [_random_hinge(rng, int(rng.integers(0, k + 1))) for k in range(int(rng.integers(1, 8)))]
    return Case(f"random tree {seed}", tree_scene(hinges), hinges, (0.0, 0.0, -GRAVITY), np.eye(len(hinges)))


def tree_scene(hinges: list[Hinge]) -> SceneRecord:
    """Rigid bodies on hinges."""
    builder = Scene("skew_tree", space="spatial").gravity(0.0, 0.0, -GRAVITY)
    for k in range(len(hinges) + 1):
        markers = {
            f"hinge{j + 1}": {"position": one.place, "axis": one.turn[:, 2], "x_axis": one.turn[:, 0]}
            for j, one in enumerate(hinges)
            if one.parent == k
        }
        if k == 0:
            builder.ground(markers=markers)
        else:
            own = hinges[k - 1]
            builder.rigid(f"body{k}", mass=own.mass, inertia=own.inertia, center_of_mass=own.center, markers=markers)
    for k, own in enumerate(hinges):
        parent = f"body{own.parent}" if own.parent else "ground"
        builder.joint("revolute", f"hinge{k + 1}", f"{parent}.hinge{k + 1}", f"body{k + 1}.origin")
    return builder.simulation(t_end=1.0, dt=1e-3, scheme="rk4").build()


def _random_hinge(rng: np.random.Generator, parent: int) -> Hinge:
    z, x = rng.normal(size=(2, 3))
    z /= np.linalg.norm(z)
    x -= (x @ z) * z
    x /= np.linalg.norm(x)
    place, center = (tuple(float(value) for value in rng.uniform(-0.5, 0.5, 3)) for _ in range(2))
    a, b, c = rng.uniform(0.01, 0.05, 3)
    return Hinge(
        parent,
        place,
        np.column_stack([x, np.cross(z, x), z]),
        float(rng.uniform(0.5, 2.0)),
        center,
        (float(b + c), float(a + c), float(a + b)),
    )


def run() -> Result:
    """Compile Pinocchio, check that all accelerations agree, time. Raises Skipped without it."""
    found = version()
    lines: list[Line] = []
    details: dict = {"version": found}
    theirs = library()
    with workplace() as folder:
        for case in (planar_chain(), skew_tree(), *(skew_chain(bodies) for bodies in LONG)):
            case_lines, details[case.name] = _case(case, PinocchioTree(theirs, case.hinges, case.gravity), folder)
            lines += case_lines
        error = max(_difference(random_tree(seed), theirs, folder) for seed in range(TREES))
        lines.append(Line(f"{TREES} random trees: largest relative difference of accelerations", error, "", AGREEMENT))
    return Result(
        "rhs_pinocchio",
        "Right-hand side of rigid trees, against Pinocchio",
        lines,
        details,
        REMARK.format(version=found, bodies=len(PARENTS)),
    )


def _difference(case: Case, theirs: ctypes.CDLL, folder: Path) -> float:
    """Of the accelerations by `forward_dynamics` and by Pinocchio's aba at one state, relative to the largest."""
    model, rng = model_of(case.scene, folder, FUNCTIONS), np.random.default_rng(1)
    n = len(case.hinges)
    q, v = rng.uniform(-3, 3, n), rng.uniform(-3, 3, n)
    state = np.concatenate([q, v, np.zeros(n)])
    PinocchioTree(theirs, case.hinges, case.gravity).worker(state)(1)
    c = model.constants(model.parameter_vector())
    found = model.evaluate("forward_dynamics", q_i=q, q_i_dot=v, c=c, q_d=0, q_d_dot=0, t=0)["q_i_ddot"]
    expected = state[2 * n :]
    return float(np.abs(np.asarray(found).ravel() - expected).max() / np.abs(expected).max())


def _case(case: Case, tree: PinocchioTree, folder: Path) -> tuple[list[Line], dict]:
    model = model_of(case.scene, folder, FUNCTIONS)
    c, n = model.constants(model.parameter_vector()), tree.n
    rng = np.random.default_rng(1)
    q, v = rng.uniform(-1, 1, n), rng.uniform(-2, 2, n)
    ours = np.concatenate([q, v, np.zeros(n)])
    other = np.concatenate([case.relative @ q, case.relative @ v, np.zeros(n)])
    stages = {f"ours, {route}": stage for route, stage in routes(model).items()}
    stages["Pinocchio, CasADi code"] = expression(tree.expression(folder))
    programs = {name: CompiledProgram(stage) for name, stage in stages.items()}
    workers: dict[str, Callable[[int], None]] = {}
    values: dict[str, np.ndarray] = {}
    for name, program in programs.items():
        state, constants = (ours, c) if name.startswith("ours") else (other, NO_CONSTANTS)
        workers[name] = worker(program, state, constants)
        found = evaluated(program, state, constants)
        values[name] = case.relative @ found if name.startswith("ours") else found
    workers["Pinocchio, aba"] = tree.worker(other)
    workers["Pinocchio, aba"](1)
    values["Pinocchio, aba"] = other[2 * n :].copy()
    reference = values["Pinocchio, aba"]
    error = max(float(np.abs(value - reference).max() / np.abs(reference).max()) for value in values.values())
    if not error < AGREEMENT:
        raise AssertionError(f"{case.name}: the accelerations differ by {error:.1e}")
    return _timed(case, workers, {name: stage.stage.n_instructions() for name, stage in stages.items()}, error)


def _timed(
    case: Case, workers: dict[str, Callable[[int], None]], operations: dict[str, int], error: float
) -> tuple[list[Line], dict]:
    timings = interleave(workers, ROUNDS)
    best = min((name for name in timings if name.startswith("ours")), key=lambda name: timings[name].best)
    lines = []
    for name, timing in timings.items():
        note = f"{operations[name]} operations, " if name in operations else ""
        lines.append(
            Line(
                f"{case.name}: {name}",
                timing.best * 1e6,
                "us",
                case.goal if name == best else None,
                f"{note}median +{timing.spread:.0%}",
            )
        )
    for name in ("Pinocchio, CasADi code", "Pinocchio, aba"):
        value, lower, upper = ratio(timings[best], timings[name])
        lines.append(Line(f"{case.name}: {best} / {name}", value, "", note=f"quartiles {lower:.2f} to {upper:.2f}"))
    lines.append(Line(f"{case.name}: largest relative difference of accelerations", error, "", AGREEMENT))
    return lines, {"operations": operations, "difference": error}

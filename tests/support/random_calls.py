"""Calls of the public functions with arguments of wrong kinds, values and shapes, drawn by a seed.

Each call is one that is right, with one or two of its arguments replaced by what nobody should give. What it may do is
give a result, or raise an error of the project's own (or TypeError for a call that Python's signature refuses).
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import skfem

from runtime import DifferentiableRun, Model, Solution, SymgenError, load_model, resume
from runtime.gradients import End, Formula, Integral, Largest, SquaredError
from symgen.fe import STEEL, FlexibleBody, LineMesh, Section
from symgen.scene import Scene, SceneRecord

LONGEST = 20  # s of a call: what takes longer hangs


def deep(depth: int) -> list[Any]:
    """A list in a list in a list ..."""
    found: list[Any] = []
    for _ in range(depth):
        found = [found]
    return found


def fails(*_: Any, **__: Any) -> Any:
    """A function that fails, which is its user's fault."""
    return 1.0


class Strange:
    """An object of no use."""

    def __repr__(self) -> str:
        return "<strange>"


def nonsense(rng: np.random.Generator, names: list[str]) -> Any:
    """One value that fits nowhere, or hardly anywhere; names: some that fit somewhere."""
    name = str(rng.choice(names))
    number = [0, 1, -1, 2, 7, 1.5, -0.5, 1e-300, 1e308, -1e308, 10**400, -(10**30), np.nan, np.inf, -np.inf, 1 + 2j]
    number += [True, False, np.float32(2.0), np.int64(-3), np.bool_(True)]
    text = [
        "",
        "x",
        "nonsense",
        "auto",
        name,
        f"{name}_dot",
        "a.b.c",
        "\u0000",
        "é" * 30,
        "x" * 10_000,
        b"bytes",
        "../x",
    ]
    lists = [[], [1], [1.0, 2.0], [1, 2, 3, 4, 5, 6, 7], [name], [name, name], [None], ["x"], [[1.0, 2.0], [3.0]]]
    lists += [[np.nan], deep(3000), (), (1.0,), (np.inf, 1.0), (2.0, 1.0), range(3), [1e308] * 2, [name, 1.0]]
    tables = [{}, {"x": 1.0}, {name: 1.0}, {name: "x"}, {name: np.nan}, {name: None}, {name: [1.0, 2.0]}, {1: 2}]
    tables += [
        {name: deep(3000)},
        {"x": {}},
        {name: 1e308},
        {name: 10**400},
        {name: -1.0},
        {name: fails},
        {name: ([0.0], [1.0])},
    ]
    arrays = [np.array([]), np.zeros((2, 3)), np.array("x"), np.array([np.nan, 1.0]), np.arange(3), np.zeros(1000)]
    arrays += [np.array(["a"]), np.array([None]), np.array(3.0), np.zeros((2, 2, 2)), np.ones(2, dtype=complex)]
    others = [
        None,
        Strange(),
        Strange,
        set(),
        {name},
        fails,
        lambda: 0,
        iter([1.0]),
        Path("x"),
        slice(None),
        ...,
        print,
    ]
    family: list[Any] = [number, text, lists, tables, arrays, others][int(rng.integers(6))]
    return family[int(rng.integers(len(family)))]


@dataclass(frozen=True)
class Target:
    """A public function with arguments that are right; weight: how often it is drawn."""

    name: str
    call: Callable[..., Any]
    right: Mapping[str, Any]
    weight: float = 1.0


def machine() -> Scene:
    """A hub with a beam under a torque from outside: inputs, parameters, measures, a flexible body."""
    section = {"area": 7e-4, "second_moment": 8e-9, "youngs_modulus": 7e10}
    scene = Scene("machine").gravity(0.0, -9.81).parameter("grip", 2.0).input("torque", 0.0, "N m")
    scene.rigid("hub", mass=1.0, inertia=2.0)
    scene.beam("beam", length=1.0, density=2700.0, lateral={"ends": "clamped-free", "modes": 1}, **section)
    scene.revolute("pivot", "ground.origin", "hub.origin", damping="grip").weld("clamp", "hub.origin", "beam.start")
    scene.torque("motor", "hub.origin", "torque").measure("tip_y", "y", of="beam.end")
    scene.measure("tip_d", "distance", of="beam.end")
    return scene.simulation(t_end=0.02, dt=1e-3, scheme="rk4")


def targets(folder: Path) -> list[Target]:
    """All of them; folder: where files may go."""
    model = machine().model()
    short = {"t_end": 0.02, "dt": 1e-3, "scheme": "rk4"}
    return [*_of_model(model, short, folder), *_of_results(model, short, folder), *_of_scene(folder), *_of_bodies()]


def _of_model(model: Model, short: Mapping[str, Any], folder: Path) -> Iterator[Target]:
    times = np.linspace(0.0, 0.02, 21)
    data = {"t": times, "hub.theta": -0.01 * times}
    run = {**short, "seen_every": 1e-3}
    more = {"m": None, "options": None, "parameters": None, "initial": None, "start": None, "t0": 0.0, "inputs": None}
    seen = {"seen_every": None, "samples": None, "outputs": None, "progress": None}
    files = {"stream": None, "checkpoint": None, "checkpoint_every": None}
    yield Target("simulate", model.simulate, {**short, **more, **seen, **files, "engine": "auto", "error": "off"}, 5)
    rough = {"tolerance": 1e-2, "t_end": 0.02, "parameters": None, "initial": None, "inputs": None, "options": None}
    yield Target("simulate to a tolerance", model.simulate, {**rough, **files, "samples": 5, "start": None}, 2)
    many = {"parameters": {"grip": [1.0, 2.0]}, "initial": None, "inputs": None, "reduce": None, "workers": 1}
    yield Target("ensemble", model.ensemble, {**many, **short, "samples": 3, "outputs": ["tip_y"], "t0": 0.0}, 3)
    yield Target(
        "equilibrium", model.equilibrium, {"held": {"hub.theta": 0.1}, "rates": None, "inputs": None, "t": 0.0}
    )
    at = {"at": {"hub.theta": 0.3}, "parameters": None, "locked": None, "t": 0.0}
    yield Target("modes", model.modes, at)
    yield Target("linearise", model.linearise, {**at, "inputs": ["torque"], "outputs": ["tip_y"]}, 2)
    spun = {"over": "hub.theta_dot", "values": [0.0, 1.0], "held": None, "rates": None, "locked": None, "t": 0.0}
    yield Target("campbell", model.campbell, {**spun, "parameters": None})
    bad = {"over": "hub.theta_dot", "speeds": [1.0, 2.0], "at": ("hub.theta", "hub.theta"), "unbalance": 0.1}
    yield Target("unbalance_response", model.unbalance_response, {**bad, "outputs": None, "held": None})
    yield Target("quasi_static_motion", model.quasi_static_motion, {"t_end": 0.1, "samples": 5, "t0": 0.0})
    yield Target("gradient", model.gradient, {"of": End("tip_y"), "by": ["grip"], "mode": "auto", **run}, 2)
    yield Target("output_jacobian", model.output_jacobian, {"outputs": ["tip_y"], "by": ["grip"], **run, "t0": 0.0}, 2)
    fit = {"data": data, "parameters": ["grip"], "bounds": None, "guess": None, "fixed": None, "deviation": None}
    yield Target("fit", model.fit, {**fit, **run}, 2)
    chart = {"scheme": "rk4", "points": 2, "states": 2, "t_end": 0.02, "dt_range": None, "m": None, "options": None}
    yield Target("stability", model.stability, {**chart, "parameters": None, "start": None, "progress": None}, 2)
    orbit = {"period": 0.1, "settle": 0, "tolerance": 1e-3, "steps": 20, "guess": None, "start": None, "turns": 1.0}
    held = {"parameters": None, "inputs": None, "speed": None, "scheme": "rk4", "options": None, "parts": 1, "t0": 0.0}
    yield Target("periodic", model.periodic, {**orbit, **held}, 0.6)
    yield Target(
        "periodic_over", model.periodic_over, {"over": "grip", "span": (1.0, 1.1), "period": 0.1, "points": 2}, 0.3
    )
    yield Target("ode", model.ode, {"loops": "states", "parameters": None, "initial": None, "start": None})
    yield Target(
        "stepper", model.stepper, {"scheme": "rk4", "dt": 1e-3, "m": None, "options": None, "engine": "auto"}, 2
    )
    yield Target("export_c", model.export_c, {"folder": folder / "c", "scheme": "rk4", "dt": 1e-3, "name": "m"}, 0.5)
    yield Target(
        "advise", model.advise, {"tolerance": 1e-2, "t_end": 0.02, "graded": ["hub.theta"], "start": None}, 0.1
    )
    turned = {"outputs": ["tip_y"], "of": "motion", "knobs": ["stiffening"], "levels": 1, "coarser": None}
    yield Target(
        "convergence", model.convergence, {**turned, "t_end": 0.02, "tolerance": 1e-3, "samples": 5, "start": None}, 0.5
    )
    yield Target("with_inputs", model.with_inputs, {"values": {"torque": 1.0}})
    yield Target("parameter_vector", model.parameter_vector, {"changes": {"grip": 1.0}})
    q, v = np.zeros(2), np.zeros(2)
    yield Target("mass_matrix", model.mass_matrix, {"q": q, "t": 0.0})
    yield Target("coriolis", model.coriolis, {"q": q, "v": v})
    yield Target("gravity", model.gravity, {"q": q, "parameters": None})
    yield Target("inverse_dynamics", model.inverse_dynamics, {"q": q, "v": v, "a": v, "motors": ()})
    yield Target("forward_dynamics", model.forward_dynamics, {"q": q, "v": v, "tau": v})
    yield Target("jacobian", model.jacobian, {"marker": "beam.end", "q": q})
    yield Target("load_model", load_model, {"folder": model.folder})


def _of_results(model: Model, short: Mapping[str, Any], folder: Path) -> Iterator[Target]:
    run = model.simulate(**short, checkpoint=folder / "kept.npz", checkpoint_every=10)
    run.save(folder / "run.npz")
    one = {
        "acceleration": {"name": "hub.theta"}, "body_motion": {"body": "hub"}, "joint_force": {"joint": "pivot"},
        "deflections": {"body": "beam", "at": 0.5, "way": "equilibrium"}, "friction": {"joint": "pivot"},
        "initial_values": {"at": 0.01}, "interpolate": {"t": 0.01, "what": "q"}, "load_force": {"load": "motor"},
        "motor": {"name": "pivot"}, "multiplier": {"row": model.constraints[0]}, "rate": {"name": "hub.theta"},
        "section_forces": {"body": "beam", "at": 0.5, "way": "equilibrium"}, "stop": {"joint": "pivot"},
        "stresses": {"body": "beam", "way": "equilibrium"}, "export": {"path": folder / "run.csv"},
        "save": {"path": folder / "again.npz"}, "__getitem__": {"name": "tip_y"},
    }  # fmt: skip
    yield from (Target(f"run.{name}", getattr(run, name), right) for name, right in one.items())
    yield Target("run.plot", run.plot, {"path": folder / "plot.png", "names": ["tip_y"]}, 0.3)
    yield Target("run.view", run.view, {"path": folder / "view.html", "beside": run}, 0.3)
    yield Target(
        "run.animate", run.animate, {"path": folder / "film.gif", "frames": 2, "fps": 5.0, "exaggeration": 1.0}, 0.3
    )
    yield Target("Solution.load", Solution.load, {"path": folder / "run.npz", "model": model})
    again = {"path": folder / "kept.npz", "engine": "auto", "progress": None, "stream": None, "inputs": None}
    yield Target("resume", lambda **given: resume(model, **given), again)
    yield Target("model.resume", model.resume, again)
    stepper = model.stepper(scheme="rk4", dt=1e-3)
    yield Target("stepper.step", stepper.step, {"u": {"torque": 1.0}, "n": 1}, 2)
    yield Target("stepper.reset", stepper.reset, {"state": {"hub.theta": 0.1}, "t": 0.0, "start": None})
    yield Target("stepper.change", stepper.change, {"parameters": {"grip": 1.0}})
    yield Target("stepper.reader", stepper.reader, {"names": ["tip_y"]})
    yield Target("stepper.restore", stepper.restore, {"kept": stepper.save()})
    prepared = DifferentiableRun(model, ["tip_y"], ["grip", "hub.theta"], **short)
    yield Target("values", prepared.values, {"x": prepared.x0})
    yield Target("jacobian of a run", prepared.jacobian, {"x": prepared.x0})
    yield Target("gradient of a run", prepared.gradient, {"objective": End("tip_y"), "x": prepared.x0, "mode": "auto"})
    yield Target("over", prepared.over, {"t0": 0.0, "length": 0.02, "steps": None, "every": None, "parameters": None})
    makes: list[tuple[Any, dict[str, Any]]] = [
        (End, {"output": "tip_y"}), (Integral, {"output": "tip_y", "squared": True}), (Largest, {"output": "tip_y"}),
        (SquaredError, {"output": "tip_y", "data": np.zeros(21), "deviation": 1.0}),
        (Formula, {"outputs": ("tip_y",), "build": lambda t, y: y["tip_y"][0]}),
    ]  # fmt: skip
    for kind, right in makes:
        yield Target(
            kind.__name__, lambda kind=kind, **given: prepared.gradient(kind(**given), prepared.x0), right, 0.5
        )


def _of_scene(folder: Path) -> Iterator[Target]:
    """Each method of a builder, and then `build`."""
    beam = {"length": 1.0, "density": 2700.0, "area": 1e-4, "second_moment": 1e-9, "youngs_modulus": 7e10}
    pair = {"marker_a": "hub.origin", "marker_b": "ground.origin"}
    methods: dict[str, dict[str, Any]] = {
        "rigid": {"name": "b", "mass": 1.0, "inertia": 1.0, "free": True, "markers": None, "shape": ()},
        "beam": {"name": "c", **beam, "lateral": {"modes": 1}, "free": True, "damping_ratio": 0.01, "markers": None},
        "modal": {"name": "c", "mass": 1.0, "inertia": 1.0, "M_ff": [[1.0]], "K_ff": [[1.0]], "free": True},
        "revolute": {"name": "j", **pair, "damping": 0.0, "friction": None, "limits": None, "motor": None},
        "prismatic": {"name": "j", **pair, "limits": None}, "weld": {"name": "j", **pair},
        "distance": {"name": "j", **pair, "length": 1.0}, "prescribed_angle": {"name": "j", **pair, "motion": "t"},
        "gear": {"name": "g", "coordinate_a": "pivot.angle", "coordinate_b": "x.angle", "ratio": 2.0},
        "spring_damper": {"name": "k", **pair, "stiffness": 1.0, "damping": 0.1, "free_length": 0.1},
        "contact": {"name": "k", "marker": "hub.origin", "radius": 0.1, "stiffness": 1.0, "plane": "ground.origin"},
        "torque": {"name": "k", "marker": "hub.origin", "value": "t"},
        "effort": {"name": "k", "coordinate": "pivot.angle", "value": 1.0},
        "distributed": {"name": "k", "beam": "beam", "components": [0.0, 1.0], "start": 0.0, "end": 1.0},
        "measure": {"name": "z", "type": "x", "of": "hub.origin", "relative_to": "ground.origin"},
        "parameter": {"name": "p", "default": 1.0, "unit": "", "description": ""},
        "input": {"name": "u", "default": 1.0, "unit": "", "rates": False},
        "state": {"name": "s", "rate": "0", "initial": 0.0},
        "event": {"name": "e", "when": "tip_y", "direction": "rising", "terminal": True},
        "table": {"name": "w", "x": [0.0, 1.0], "y": [0.0, 1.0], "interpolation": "linear", "outside": "hold"},
        "ground": {"markers": {"m": {"position": [0.0, 0.0]}}}, "initial": {"coordinates": {"hub.theta": 0.1}},
        "rates": {"rates": {"hub.theta": 0.1}}, "simulation": {"t_end": 1.0, "scheme": "rk4", "dt": 1e-3, "m": None},
        "joint": {"type": "revolute", "name": "j", **pair}, "load": {"type": "line", "name": "k", **pair, "value": 1.0},
        "structure": {"coordinates": ["a"], "mass": [[1.0]], "stiffness": [[1.0]]}, "groups": {"L": ["hub.theta"]},
    }  # fmt: skip
    for name, right in methods.items():
        yield Target(f"Scene.{name}", lambda _of=name, **given: getattr(machine(), _of)(**given).build(), right)
    listed: dict[str, list[Any]] = {
        "gravity": [0.0, -9.81], "independent": ["hub.theta", "beam.q1"], "stiff": ["beam.q1"],
        "force": ["f", "hub.origin", 0.0, 1.0],
    }  # fmt: skip
    for name, values in listed.items():
        right = {str(k): value for k, value in enumerate(values)}
        yield Target(f"Scene.{name}", lambda _of=name, **given: getattr(machine(), _of)(*given.values()).build(), right)
    yield Target(
        "Scene",
        lambda **given: Scene(**given).build(),
        {"name": "s", "title": "t", "description": "", "space": "planar"},
    )
    yield Target("Scene.to_toml", machine().to_toml, {"path": folder / "scene.toml"})
    machine().to_toml(folder / "scene.toml")
    yield Target("Scene.from_toml", Scene.from_toml, {"path": folder / "scene.toml"})
    plain = machine().build().to_dict()
    yield Target("SceneRecord.from_dict", lambda **data: SceneRecord.from_dict(data), plain, 6)
    yield Target("of one thing", SceneRecord.from_dict, {"data": plain})


def _of_bodies() -> Iterator[Target]:
    nodes = [(0.1 * k, 0.0, 0.0) for k in range(4)]
    lines, section = [(k, k + 1) for k in range(3)], Section.rectangle(0.02, 0.01)
    mesh, ends = LineMesh(nodes, lines, section), {"a": [0], "b": [3]}
    choices = {"interface": ends, "modes": 2, "mode_set": "free", "fixed": (), "mass": "consistent", "static": ()}
    right = {"mesh": mesh, "material": STEEL, "order": 2, **choices, "origin": (0.0, 0.0, 0.0), "stiffening": False}
    body = FlexibleBody.from_mesh(**right)
    yield Target("FlexibleBody.from_mesh", FlexibleBody.from_mesh, right, 2)
    K, M = body.structure.K, body.structure.M
    table = {"K": K, "M": M, "nodes": nodes, "dofs": 6, "interface": {"a": [1], "b": [4]}, "modes": 2}
    yield Target("FlexibleBody.from_matrices", FlexibleBody.from_matrices, table, 2)
    yield Target("fields", body.fields, {"damping_ratio": 0.01, "surface": 0, "gauges": None})
    yield Target("LineMesh", LineMesh, {"nodes": nodes, "lines": lines, "section": section})
    yield Target("Section.rectangle", Section.rectangle, {"width": 0.02, "height": 0.01})
    solid = skfem.MeshTet.init_tensor(*[np.linspace(0, 1, 2)] * 3)
    yield Target("of a solid", FlexibleBody.from_mesh, {**right, "mesh": solid, "interface": {"a": [0, 1, 2]}}, 0.3)


@contextmanager
def patience(seconds: int) -> Iterator[None]:
    """Raises TimeoutError in a call that takes longer."""

    def over(*_: Any) -> None:
        raise TimeoutError(f"no answer within {seconds} s")

    before = signal.signal(signal.SIGALRM, over)
    signal.alarm(seconds)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, before)


def faults(every: list[Target], seed: int, count: int, names: list[str]) -> Iterator[tuple[str, BaseException]]:
    """(the call in words, what it raised) of calls that were answered by what is no error of the project's own."""
    rng = np.random.default_rng(seed)
    weights = np.array([one.weight for one in every])
    for _ in range(count):
        target = every[int(rng.choice(len(every), p=weights / weights.sum()))]
        given, keys = dict(target.right), list(target.right)
        for key in rng.choice(keys, size=min(len(keys), int(rng.integers(1, 3))), replace=False):
            given[str(key)] = nonsense(rng, names)
        if rng.random() < 0.05:
            given[str(rng.choice(["bogus", "tend", "dtt", "x1", ""]))] = nonsense(rng, names)
        try:
            with patience(LONGEST):
                target.call(**given)
        except SymgenError as refused:
            try:
                assert str(refused)
            except Exception as raw:
                yield in_words(target, given), raw
        except TypeError as raw:
            if "unexpected keyword" not in str(raw) and "argument" not in str(raw).split("()")[-1]:
                yield in_words(target, given), raw
        except Exception as raw:
            yield in_words(target, given), raw


def in_words(target: Target, given: Mapping[str, Any]) -> str:
    """The arguments that are not right."""
    changed = {key: value for key, value in given.items() if value is not target.right.get(key, value)}
    changed |= {key: given[key] for key in given.keys() - target.right.keys()}

    def short(value: Any) -> str:
        try:
            return repr(value)[:60]
        except Exception:
            return f"<{type(value).__name__}>"

    return f"{target.name}({', '.join(f'{key}={short(value)}' for key, value in changed.items())})"

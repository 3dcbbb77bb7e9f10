"""A step that was prepared once is read by the next process, with the same bits; what cannot be read is derived."""

from __future__ import annotations

import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from runtime import Solution, load_model, simulate
from runtime.engine import kept_programs
from runtime.engine.object_cache import ObjectCache
from runtime.model import Model
from runtime.schemes import scheme as schemes
from runtime.schemes import stepper
from symgen.generate import generate
from symgen.scenes import generated_folder
from tests.support.input_scenes import cart

RUNS = [
    ("flexible_slider_crank_free", "exponential", 1e-4),
    ("two_oscillators", "printed", 1e-3),  # with a repetition that ends by itself
    ("two_oscillators", "coupled", 1e-3),
    ("four_bar", "rk4", 1e-3),
]


@pytest.fixture(autouse=True)
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ObjectCache:
    monkeypatch.setenv("SYMGEN_CACHE", str(tmp_path))
    return ObjectCache()


@pytest.fixture
def prepared(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """A name for each step that is derived and prepared."""
    seen: list[str] = []
    original = stepper.prepare

    def counted(program: Any, *sizes: int) -> Any:
        seen.append(program.stages()[0].name())
        return original(program, *sizes)

    monkeypatch.setattr(stepper, "prepare", counted)
    return seen


def fresh(scene: str) -> Model:
    """A model as a new process loads it, which keeps no stepper yet."""
    return load_model(generated_folder(scene))


def run(model: Model, scheme: str, dt: float, **how: Any) -> Solution:
    return simulate(model, scheme=scheme, dt=dt, t_end=20 * dt, error="off", **how)


def same(one: Solution, other: Solution) -> bool:
    return all(np.array_equal(getattr(one, key), getattr(other, key)) for key in ("t", "q", "q_dot", "q_ddot", "lam"))


@pytest.mark.every_push("four_bar-rk4-0.001", "two_oscillators-printed-0.001")
@pytest.mark.parametrize("scene, scheme, dt", RUNS)
def test_a_kept_step_has_the_bits_of_a_derived_one(scene: str, scheme: str, dt: float, prepared: list[str]) -> None:
    first = run(fresh(scene), scheme, dt)
    assert len(prepared) == 1
    again = run(fresh(scene), scheme, dt)
    assert len(prepared) == 1 and same(first, again)
    assert first.stats["operations_per_step"] == again.stats["operations_per_step"]
    interpreted = run(fresh(scene), scheme, dt, engine="interpreted")
    assert len(prepared) == 1 and same(interpreted, run(fresh(scene), scheme, dt, engine="compiled-library"))


def test_what_a_step_follows_from_is_in_its_key(prepared: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    """Options, ratios, another scheme and other code give other steps; its length and parameters do not."""
    run(fresh("two_oscillators"), "printed", 1e-3)
    run(fresh("two_oscillators"), "printed", 5e-4, parameters={"k_L": 2.0})
    assert len(prepared) == 1
    run(fresh("two_oscillators"), "printed", 1e-3, m=[3])
    run(fresh("two_oscillators"), "printed", 1e-3, options={"common_update": "direct"})
    run(fresh("two_oscillators"), "coupled", 1e-3)
    assert len(prepared) == 4
    monkeypatch.setattr(kept_programs, "_code", lambda: "other code")
    run(fresh("two_oscillators"), "printed", 1e-3)
    assert len(prepared) == 5


@pytest.mark.parametrize(
    "content", [b"", b"no program", zlib.compress(b"{}"), zlib.compress(b'{"stages": {"a": "b"}}')]
)
def test_what_cannot_be_read_is_derived_again(
    content: bytes, cache: ObjectCache, prepared: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Cut off, or written by another program."""
    keys: list[str] = []
    monkeypatch.setattr(schemes, "key_of", lambda *facts: keys.append(kept_programs.key_of(*facts)) or keys[-1])
    first = run(fresh("four_bar"), "rk4", 1e-3)
    assert len(set(keys)) > 2  # the step, its start, what is seen of it
    for key in keys:
        path = cache.folder / f"{key}.o"
        if content:
            cache.write(key, content, 0)
        else:
            path.write_bytes(path.read_bytes()[:-7])
    assert same(first, run(fresh("four_bar"), "rk4", 1e-3))
    assert len(prepared) == 2


@pytest.mark.long
def test_functions_among_the_inputs_are_part_of_the_step(tmp_path: Path, prepared: list[str]) -> None:
    """They are not in the folder whose digest the key tells: such a step is derived each time."""
    folder = generate(cart(), tmp_path / "model")
    for factor in (1.0, 2.0):
        for _ in range(2):
            run(load_model(folder), "rk4", 1e-3, inputs={"force": lambda t, factor=factor: factor * t})
    assert len(prepared) == 4
    run(load_model(folder), "rk4", 1e-3)
    run(load_model(folder), "rk4", 1e-3, inputs={"force": 2.0})
    assert len(prepared) == 5

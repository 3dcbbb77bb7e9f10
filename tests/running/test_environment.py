"""The environment for learning: Gymnasium's interface on a stepper."""

from __future__ import annotations

import warnings
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

from runtime import Environment
from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model
from symgen.scene import SceneRecord
from tests.support.scenes import on_rail

Build = Callable[[SceneRecord], Model]


def cart() -> SceneRecord:
    return (
        on_rail("cart", "cart", "rail", mass=2.0, inertia=0.1)
        .input("force", 0.0, "N")
        .force("push", "cart.origin", "force", 0.0)
        .simulation(dt=1e-3, scheme="rk4")
        .build()
    )


def environment(model: Model, **changes: Any) -> Environment:
    settings: dict[str, Any] = {
        "actions": {"force": (-4.0, 4.0)},
        "observe": ["cart.x", "cart.x_dot"],
        "reward": lambda seen, action: -(seen[0] ** 2) - 0.1 * action[0] ** 2,
        "ends": lambda seen: abs(seen[0]) > 1.0,
        "begin": lambda generator: {"cart.x": float(generator.uniform(-0.5, 0.5))},
        "every": 100,
        "t_end": 0.5,
    }
    return Environment(model, **{**settings, **changes})


def test_actions_are_held_and_clipped(model_of: Build) -> None:
    """From rest 4 N on 2 kg for 0.1 s, however much was asked for: 0.01 m, 0.2 m/s."""
    world = environment(model_of(cart()))
    seen, _ = world.reset(options={"cart.x": 0.2})
    assert list(seen) == [0.2, 0.0]
    seen, reward, over, cut, info = world.step([10.0])
    np.testing.assert_allclose(seen, [0.21, 0.2], atol=1e-14)
    assert reward == pytest.approx(-(0.21**2) - 1.6) and (over, cut, info) == (False, False, {})
    rest = [world.step([4.0])[2:4] for _ in range(4)]
    assert rest == [(False, False)] * 3 + [(False, True)]


def test_a_seed_repeats_and_the_end_is_told(model_of: Build) -> None:
    world = environment(model_of(cart()), t_end=None)
    first, second, third = (world.reset(seed=seed)[0] for seed in (7, 7, 8))
    assert list(first) == list(second) != list(third)
    world.reset(options={"cart.x": 0.99, "cart.x_dot": 1.0})
    assert world.step([0.0])[2:4] == (True, False)


def test_gymnasium_takes_it_for_its_own(model_of: Build) -> None:
    checker = pytest.importorskip("gymnasium.utils.env_checker")
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        checker.check_env(environment(model_of(cart())).gymnasium(), skip_render_check=True)


@pytest.mark.parametrize(
    "change, words",
    [({"actions": {"push": (0, 1)}}, "push"), ({"actions": {"force": (1, 0)}}, "lowest"), ({"every": 0}, "at least 1")],
)
def test_wrong_words(model_of: Build, change: dict[str, Any], words: str) -> None:
    with pytest.raises(ArgumentError, match=words):
        environment(model_of(cart()), **change)

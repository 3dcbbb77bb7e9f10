"""A mechanism as an environment for learning: observe, act, be rewarded, in the form of Gymnasium's interface."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from runtime.contract.errors import ArgumentError
from runtime.contract.model import Model

Observed = tuple[np.ndarray, dict[str, Any]]


class Environment:
    """Actions are inputs of the model, held for `every` major steps; observations are what is read in between.

    actions: {input: (lowest, highest)}, each action an array (k,) in this order; observe: names of coordinates, rates
    and measures; reward(observation, action) -> a number; ends(observation) -> is the episode over?; begin(generator)
    -> the state to start from, for `ModelStepper.reset`; t_end [s]: when an episode is cut off (None: never); settings:
    those of `model.stepper`. `gymnasium()` is the same as a gymnasium.Env.
    """

    def __init__(
        self,
        model: Model,
        *,
        actions: Mapping[str, tuple[float, float]],
        observe: Sequence[str],
        reward: Callable[[np.ndarray, np.ndarray], float],
        ends: Callable[[np.ndarray], bool] = lambda observation: False,
        begin: Callable[[np.random.Generator], Mapping[str, float] | None] = lambda generator: None,
        every: int = 1,
        t_end: float | None = None,
        **settings: Any,
    ) -> None:
        unknown = [name for name in actions if name not in model.inputs]
        if unknown or not actions:
            known = ", ".join(model.inputs) or "none"
            raise ArgumentError("actions", f"{', '.join(unknown) or 'nothing'} is no input", f"model has {known}")
        bounds = np.array(list(actions.values()), dtype=float)
        if bounds.shape != (len(actions), 2) or not np.all(bounds[:, 0] < bounds[:, 1]):
            raise ArgumentError("actions", "need a lowest and a highest value each", "give {input: (-1.0, 1.0)}")
        if every < 1:
            raise ArgumentError("every", f"must be at least 1, not {every}", "count major steps")
        self.names, self.low, self.high = list(actions), bounds[:, 0], bounds[:, 1]
        self.observe, self.reward, self.ends, self.begin = list(observe), reward, ends, begin
        self.every, self.t_end = every, np.inf if t_end is None else float(t_end)
        self.stepper = model.stepper(**settings)
        self._read = self.stepper.reader(self.observe)
        self._generator = np.random.default_rng()

    def reset(self, *, seed: int | None = None, options: Mapping[str, float] | None = None) -> Observed:
        """(observation (n,), {}) at the start of an episode; options: the state, in place of what `begin` gives."""
        if seed is not None:
            self._generator = np.random.default_rng(seed)
        state = self.begin(self._generator) if options is None else options
        self.stepper.reset(state)
        return self._read().copy(), {}

    def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
        """(observation (n,), reward, is it over, was it cut off, {}) after an action (k,), clipped to its bounds.

        A state that is not finite ends the episode with reward 0 and the info `not_finite`; so does a terminal event of
        the model, with the reward of its state and the info `event`.
        """
        taken = np.clip(np.asarray(action, dtype=float).reshape(len(self.names)), self.low, self.high)
        self.stepper.step(dict(zip(self.names, taken.tolist(), strict=True)), self.every)
        observation = self._read().copy()
        late = self.stepper.time >= self.t_end * (1 - 1e-12)
        if not np.isfinite(observation).all():
            return observation, 0.0, True, late, {"status": "not_finite"}
        ended = self.stepper.ended
        info = {} if ended is None else {"status": ended.name}
        over = ended is not None or bool(self.ends(observation))
        return observation, float(self.reward(observation, taken)), over, late, info

    def gymnasium(self) -> Any:
        """The environment as a gymnasium.Env. Raises ImportError naming the extra `gym` if gymnasium is missing."""
        try:
            import gymnasium
        except ImportError as error:
            raise ImportError("gymnasium() needs Gymnasium: pip install 'symgen[gym]'") from error
        inner = self

        class MechanismEnv(gymnasium.Env):  # type: ignore[misc]
            """Passes everything on."""

            metadata: dict[str, Any] = {"render_modes": []}  # noqa: RUF012
            action_space = gymnasium.spaces.Box(inner.low, inner.high, dtype=np.float64)
            observation_space = gymnasium.spaces.Box(-np.inf, np.inf, (len(inner.observe),), dtype=np.float64)

            def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Observed:
                """See Environment.reset."""
                super().reset(seed=seed)
                return inner.reset(seed=seed, options=options or None)

            def step(self, action: Any) -> tuple[np.ndarray, float, bool, bool, dict[str, Any]]:
                """See Environment.step."""
                return inner.step(action)

        return MechanismEnv()

"""Expressions of a scene as the equations take them: their values, and where in time they jump or kink."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import casadi as ca

from symgen.scene import Scene
from symgen.scene.switching import switching_values
from symgen.system.equations import Equations

SAME_DEPTH = 20  # down to which two expressions are compared


@dataclass(frozen=True)
class ExpressionReader:
    """Reads expressions of a scene; equations.switching gets what changes its sign where they jump or kink in time."""

    scene: Scene
    equations: Equations

    def read(self, text: float | str, item: str, owner: str, environment: Mapping[str, Any], *names: str) -> ca.SX:
        """The value of an expression of t, the inputs and these names; owner: the load, joint or state that it is of.

        Raises SceneError with the item.
        """
        eq = self.equations
        expression = self.scene.expression(text, item, ("t", *eq.u, *names))
        value = expression.to_casadi(environment)
        time, motion = ca.vertcat(eq.t, *eq.u.values()), ca.vertcat(*eq.q, *eq.q_dot)
        for found in switching_values(expression.node, environment, self.scene.tables):
            if ca.depends_on(found, time) and not ca.depends_on(found, motion) and not self._known(found):
                eq.switching.append((owner, found))
        return value

    def _known(self, value: ca.SX) -> bool:
        return any(ca.is_equal(value, other, SAME_DEPTH) for _, other in self.equations.switching)

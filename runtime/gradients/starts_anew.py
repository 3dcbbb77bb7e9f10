"""A state of a differentiated run behind a jump, for schemes that start anew there, with its derivatives."""

from __future__ import annotations

from functools import cached_property

import casadi as ca
import numpy as np

from runtime.contract.tape import shared
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.restart import loop_guess, started_anew


class StartsAnew:
    """Of a scheme; remembers: does it act through more than positions and rates?"""

    def __init__(self, scheme: Scheme, remembers: bool) -> None:
        self._scheme, self._remembers = scheme, remembers
        self._n_s, self._groups = scheme.layout.size, len(scheme.grid.h)
        self._w = scheme.layout.slice("inputs") if scheme.model.inputs else slice(0, 0)

    @cached_property
    def _symbols(self) -> tuple[ca.SX, ca.SX, ca.SX]:
        """z, p, and c with the inputs that z holds."""
        model = self._scheme.model
        z, p = ca.SX.sym("z", self._n_s), ca.SX.sym("p", len(model.parameters))
        c, fields = ca.SX(model.kernel("constants")(p)), self._scheme.layout.unpack(z)
        if "inputs" in fields:
            c = ca.vertcat(c[: model.c_size - model.signals.size], fields["inputs"])
        return z, p, c

    def _seen(self, steps: ca.SX) -> tuple[ca.SX, ca.SX, ca.SX]:
        """q_i, q_i_dot and the loop unknowns of z."""
        z, _, c = self._symbols
        fields = self._scheme.layout.unpack(z)
        if not self._remembers:
            return fields["x"], fields["v"], fields["loop"]
        seen = self._scheme.observer(z=z, c=ca.vertcat(c, steps))
        return seen["q_i"], seen["q_i_dot"], loop_guess(self._scheme, seen["q_d"])

    @cached_property
    def gap(self) -> ca.Function:
        """(z, p, steps, before, after) -> accelerations before less those after."""
        z, p, c = self._symbols
        steps, before, after = ca.SX.sym("h", self._groups), ca.SX.sym("before"), ca.SX.sym("after")
        q_i, v, loop = self._seen(steps)
        equations = self._scheme.equations(ca.vertcat(c, steps), self._scheme.layout.unpack(z))
        a = [equations.accelerations(equations.close_well(q_i, loop, t), v) for t in (before, after)]
        return ca.Function("gap", [z, p, steps, before, after], shared([ca.densify(a[0] - a[1])]))

    @cached_property
    def _restarts(self) -> tuple[ca.Function, ca.Function, ca.Function]:
        """(z, p, t, steps before, after, push, w) -> z; push: what is added to q_i_dot; its tangent and adjoint."""
        z, p, c = self._symbols
        scheme, t = self._scheme, ca.SX.sym("t")
        before, after = (ca.SX.sym(name, self._groups) for name in ("before", "after"))
        push = ca.SX.sym("push", len(scheme.model.q_i))
        w = ca.SX.sym("w", self._w.stop - self._w.start)
        there = ca.vertcat(c[: c.numel() - w.numel()], w, after)
        found = started_anew(scheme, z, t, ca.vertcat(c, before), there, push)
        given = [z, p, t, before, after, push, w]
        along = [ca.SX.sym(f"along_{k}", one.numel()) for k, one in enumerate((z, p, push, w))]
        bar = ca.SX.sym("bar", found.numel())
        inputs = ca.vertcat(z, p, push, w)
        forward = ca.densify(ca.jtimes(found, inputs, ca.vertcat(*along)))
        back = ca.densify(ca.jtimes(found, inputs, bar, True))
        ends = np.cumsum([0, z.numel(), p.numel(), push.numel(), w.numel()]).tolist()
        return (
            ca.Function("restart", given, shared([ca.densify(found)])),
            ca.Function("restart_tangent", [*given, *along], shared([forward])),
            ca.Function("restart_adjoint", [*given, bar], shared(ca.vertsplit(back, ends))),
        )

    @property
    def restart(self) -> ca.Function:
        """(z, p, t, steps before, after, push, w) -> z."""
        return self._restarts[0]

    @property
    def tangent(self) -> ca.Function:
        """The same, and directions of z, p, push and w -> direction of z."""
        return self._restarts[1]

    @property
    def adjoint(self) -> ca.Function:
        """The same, and an adjoint of z -> those of z, p, push and w."""
        return self._restarts[2]

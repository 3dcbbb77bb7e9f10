"""What an event does to the derivatives of a run: its time follows the motion, and so does what it sets.

An event happens where g(q, q', t, p) = 0. With dz, the derivative of the state at that time, and g' along the motion,

    dT = -(g_z dz + g_p dp) / g',    dv+ = dv- + (a- - a+) dT,    dw+ = A_z dz + A_p dp + A' dT

for an action w = A(z, p) on inputs; positions and velocities are continuous. It is the saltation matrix of the event.
"""

from __future__ import annotations

from dataclasses import dataclass

import casadi as ca
import numpy as np

from runtime.contract.errors import NoResult
from runtime.contract.tape import shared
from runtime.gradients.course import EventPassage
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.watched import values_at


@dataclass(frozen=True)
class Acted:
    """At a state (n_s,): the event, its value and rate, accelerations before less those after (n_i,), inputs (n_w,)."""

    event: int
    value: float
    rate: float
    gap: np.ndarray
    w: np.ndarray

    @property
    def numbers(self) -> tuple[np.ndarray | float, ...]:
        """As the derivatives take them."""
        return self.value, self.rate, self.gap


class ActingEvents:
    """Of a scheme without fields of events. z (n_s,), p (n_p,) and steps (groups,) [s] are those before an event."""

    def __init__(self, scheme: Scheme) -> None:
        self._scheme, self._made = scheme, dict[int, tuple[ca.Function, ...]]()

    def act(self, passage: EventPassage, z: np.ndarray, p: np.ndarray, steps: np.ndarray) -> Acted:
        """What happens. Raises NoResult for an event that only grazes zero."""
        value, rate, gap, w = (np.asarray(one).ravel() for one in self._of(passage.event)[0](z, p, steps))
        if abs(float(rate[0])) <= passage.least:
            event = self._scheme.model.description.events[passage.event]
            raise NoResult(
                f"event {event.name} of model {self._scheme.model.name}",
                f"grazes zero at t = {passage.clock:.6g} s (rate {float(rate[0]):.3g} 1/s): its time has no derivative",
                "let it pass zero faster, or leave out of `by` what moves it",
            )
        return Acted(passage.event, float(value[0]), float(rate[0]), gap, w)

    def moved(
        self, acted: Acted, z: np.ndarray, p: np.ndarray, steps: np.ndarray, dz: np.ndarray, dp: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(what is added to the derivative of q_i_dot (n_i,), the derivative of the inputs behind the event (n_w,))."""
        found = np.asarray(self._of(acted.event)[1](z, p, steps, *acted.numbers, dz, dp)).ravel()
        return found[: len(acted.gap)], found[len(acted.gap) :]

    def pulled_back(
        self, acted: Acted, z: np.ndarray, p: np.ndarray, steps: np.ndarray, pushed: np.ndarray, w: np.ndarray
    ) -> tuple[np.ndarray, np.ndarray]:
        """(adjoint of z (n_s,), of p (n_p,)) from those of what `moved` gives."""
        back = self._of(acted.event)[2](z, p, steps, *acted.numbers, np.concatenate([pushed, w]))
        return np.asarray(back[0]).ravel(), np.asarray(back[1]).ravel()

    def _of(self, k: int) -> tuple[ca.Function, ...]:
        """Of event k: what happens, and the tangent and the adjoint of it."""
        if k not in self._made:
            self._made[k] = self._functions(k)
        return self._made[k]

    def _functions(self, k: int) -> tuple[ca.Function, ...]:
        scheme, model = self._scheme, self._scheme.model
        z, p = ca.SX.sym("z", scheme.layout.size), ca.SX.sym("p", len(model.parameters))
        steps, fields = ca.SX.sym("h", len(scheme.grid.h)), scheme.layout.unpack(z)
        first = model.c_size - model.signals.size
        w, known = fields["inputs"], ca.SX(model.kernel("constants")(p))[:first]
        equations = scheme.equations(ca.vertcat(known, w, steps), fields)
        seen = values_at(scheme, z, equations)
        value, rate, gap = ca.SX.sym("value"), ca.SX.sym("rate"), ca.SX.sym("gap", len(model.q_i))
        moves = -(seen["events"][k] - value) / rate  # zero, with the derivative of the time
        behind, at = ca.SX(w), sum(len(event.sets) for event in model.description.events[:k])
        plain = ca.SX(w)
        for j, name in enumerate(model.description.events[k].sets, at):
            place = model.signals.names.index(name)
            plain[place] = seen["actions"][j]
            behind[place] = seen["actions"][j] + seen["drifts"][j] * moves
        state = scheme.observer(z=z, c=ca.vertcat(known, w, steps))
        loop = [state["q_d"][model.q_d.index(name)] for name in model.loop_unknowns]
        guess = ca.vertcat(*loop) if loop else ca.SX(0, 1)
        sides = []
        for inputs in (w, plain):
            own = scheme.equations(ca.vertcat(known, inputs, steps))
            motion = own.close_well(state["q_i"], guess, state["t"])
            sides.append(own.accelerations(motion, state["q_i_dot"]))
        happens = [seen["events"][k], seen["slopes"][k], sides[0] - sides[1], plain]
        given, found = [z, p, steps, value, rate, gap], ca.vertcat(gap * moves, behind)
        both, along, bar = (
            ca.vertcat(z, p),
            [ca.SX.sym("dz", z.numel()), ca.SX.sym("dp", p.numel())],
            ca.SX.sym("bar", found.numel()),
        )
        forward = ca.densify(ca.jtimes(found, both, ca.vertcat(*along)))
        back = ca.vertsplit(ca.densify(ca.jtimes(found, both, bar, True)), [0, z.numel(), both.numel()])
        return (
            ca.Function("event", [z, p, steps], shared([ca.densify(one) for one in happens])),
            ca.Function("event_tangent", [*given, *along], shared([forward])),
            ca.Function("event_adjoint", [*given, bar], shared(back)),
        )

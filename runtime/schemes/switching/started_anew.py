"""A state as the start of further steps: what schemes that remember earlier steps are given where forces jump."""

from __future__ import annotations

import casadi as ca

from runtime.schemes.scheme import Scheme
from runtime.schemes.state_fields import Lasting


def started_anew(scheme: Scheme, z: ca.SX, t: ca.SX, before: ca.SX, after: ca.SX, push: ca.SX | float = 0.0) -> ca.SX:
    """(n_z,) a start at t [s] with the positions and rates that z (n_z,) shows, and its accounts.

    before, after (c_size,): constants as the stages read them, with inputs: z is shown by those before, steps go on
    with those after. push (n_i,): what is added to the rates [1/s].
    """
    seen, fields = scheme.observer(z=z, c=before), scheme.layout.unpack(z)
    found = ca.SX(scheme.starter(t, seen["q_i"], seen["q_i_dot"] + push, loop_guess(scheme, seen["q_d"]), after))
    for name in scheme.lasting(Lasting.ACCOUNT):
        found[scheme.layout.slice(name)] = fields[name]
    return found


def loop_guess(scheme: Scheme, q_d: ca.SX) -> ca.SX:
    """(n_loop,) the loop unknowns among the dependent coordinates."""
    loop = [q_d[scheme.model.q_d.index(name)] for name in scheme.model.loop_unknowns]
    return ca.vertcat(*loop) if loop else ca.SX(0, 1)

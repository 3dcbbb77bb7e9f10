"""A model as x' = f(x, u, p, t), or with algebraic unknowns z of its loops, for solvers and optimisers elsewhere."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Literal

import casadi as ca
import numpy as np

from runtime.baselines.condensed_ode import CondensedOde, start_of
from runtime.contract.arguments import BY_NAME, arguments
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.tape import shared

CLOSING_STEPS = 1  # Newton steps of the closure: x and z are as good as a solver's own solution


@dataclass(frozen=True)
class Ode:
    """A first-order system by CasADi functions, whose names say what the entries of their arguments are.

    x: independent coordinates q_i and their rates (angular velocities of bodies that turn freely, whose Euler
    parameters follow), then loop unknowns; u: inputs; p: parameters; z: loop unknowns where they are algebraic; SI
    units. f: (x, u, p, t) -> x', or (x, z, u, p, t); g: (x, z, u, p, t) -> C_loop, zero where the loops are closed, or
    None. x0, z0: the start; u0, p0: inputs and parameters as they are given.
    """

    f: ca.Function
    g: ca.Function | None
    x: list[str]
    z: list[str]
    u: list[str]
    p: list[str]
    x0: np.ndarray
    z0: np.ndarray
    u0: np.ndarray
    p0: np.ndarray

    @cached_property
    def jacobian(self) -> ca.Function:
        """Arguments of f -> (df/dx, df/du), and where there is z (df/dx, df/du, df/dz, dg/dx, dg/du, dg/dz)."""
        given = {name: ca.SX.sym(name, self.f.size1_in(name)) for name in self.f.name_in()}
        by = ("x", "u") if self.g is None else ("x", "u", "z")
        functions = [self.f] if self.g is None else [self.f, self.g]
        found = {
            f"d{function.name()}_d{name}": ca.densify(ca.jacobian(function(*given.values()), given[name]))
            for function in functions
            for name in by
        }
        return ca.Function("jacobian", list(given.values()), shared(list(found.values())), list(given), list(found))


@arguments(parameters=BY_NAME, initial=BY_NAME)
def ode(
    model: EmittedModel,
    loops: Literal["states", "algebraic"] = "states",
    parameters: Mapping[str, float] | None = None,
    initial: Mapping[str, float] | None = None,
    start: str | None = None,
) -> Ode:
    """Give x' = f(x, u, p, t) as CasADi functions, for other integrators and for optimal control.

    Parameters
    ----------
    model : Model
        The mechanism.
    loops : {"states", "algebraic"}, optional
        Loop unknowns as states, each evaluation closing the loops by a Newton step from them; or as algebraic unknowns.
    parameters, initial, start : optional
        As of `simulate`, for p0, u0, x0, z0.

    Returns
    -------
    Ode
        The functions, names and units of their arguments, and consistent starting values.

    Raises
    ------
    ModelError
        For models with events, and for turns in loops that are to be algebraic.
    """
    if loops not in ("states", "algebraic"):
        raise ModelError(f'loops is {loops!r}; give "states" or "algebraic"')
    system = CondensedOde(model, CLOSING_STEPS)
    begin = start_of(model, parameters, initial, start)
    names, n, n_loops = _names(model), system.n, len(model.loop_unknowns)
    resting = [*system.charts.independent, *(2 * n + k for own in system.charts.loop_turns for k in own)]
    algebraic = list(range(2 * n, 2 * n + n_loops)) if loops == "algebraic" else []
    if set(resting) & set(algebraic):
        raise ModelError(f'model {model.name}: a body that turns freely is in a loop; take loops="states"')
    moving = [k for k in range(len(names)) if k not in resting and k not in algebraic]
    inputs = len(model.signals.parameters)
    x, z, t = ca.SX.sym("x", len(moving)), ca.SX.sym("z", len(algebraic)), ca.SX.sym("t")
    p, u = ca.SX.sym("p", len(model.parameters) - inputs), ca.SX.sym("u", inputs)
    y = ca.SX(len(names), 1)
    y[moving] = x
    if algebraic:
        y[algebraic] = z
    c = model.kernel("constants")(ca.vertcat(p, u))
    slope = shared([ca.densify(system.right_hand_side()(t, y, c)[moving])])
    given = {"x": x, **({"z": z} if algebraic else {}), "u": u, "p": p, "t": t}
    f = ca.Function("f", list(given.values()), slope, list(given), ["x_dot"])
    g = None
    if algebraic:
        q_d = ca.SX(len(model.q_d), 1)
        q_d[system.equations.loops] = z
        open_by = model.evaluate("closure", q_i=y[:n], q_d=q_d, t=t, c=c)["C_loop"]
        g = ca.Function("g", list(given.values()), shared([ca.densify(open_by)]), list(given), ["C_loop"])
    entries = [entry.name for entry in model.parameters]
    return Ode(
        f,
        g,
        [names[k] for k in moving],
        [names[k] for k in algebraic],
        entries[len(entries) - inputs :],
        entries[: len(entries) - inputs],
        begin.y[moving],
        begin.y[algebraic],
        begin.p[len(entries) - inputs :],
        begin.p[: len(entries) - inputs],
    )


def _names(model: EmittedModel) -> list[str]:
    """Of the entries of y."""
    rates = [f"{name}_dot" for name in model.q_i]
    for k in model.places.turns.ravel():
        if k < len(rates):
            rates[k] = model.q_i[k].replace("turn_", "omega_")
    return [*model.q_i, *rates, *model.loop_unknowns, *(model.coordinates[k] for k in model.places.parameters.ravel())]

"""Quasi-static starts of lanes: the steps of runtime/start/quasi_static.py, on the fields of a row.

settle       is the lane to be settled?                                   given
settled      did it stay in its valley until now?                         else the case is run by itself
settle_q, settle_t    the state that is being settled: at the start, and a little before and behind it
settle_open, settle_work    is it open, and the work of its last step
settle_lead, settle_ahead    the time between these, and q_e at the later one
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

import casadi as ca

from runtime.contract.model import Model
from runtime.engine.program import Call, Fields, Layout, Program, Repeat, Sequence, Until
from runtime.schemes.scheme import LARGEST
from runtime.start.quasi_static import MAX_STEPS, PASSES, elastic_residual, leading, positions, settles, settling

USUAL_STEPS = 4
Stage = Callable[[str, Callable[[Fields], Mapping[str, ca.SX]]], Call]


def quasi_static(model: Model, start: str) -> bool:
    """Do runs with this start ("" for the scene's own) begin in elastic equilibrium, and can lanes find it?"""
    chosen = start or str(model.simulation.get("start", "given"))
    return chosen in ("quasi_static", "quasi_static_unstable") and settles(model)


def settle_fields(model: Model) -> dict[str, int]:
    """What of a row this works on, `settle` left out."""
    single = ("settled", "settle_t", "settle_open", "settle_work", "settle_lead")
    return {**dict.fromkeys(single, 1), "settle_q": len(model.q_i), "settle_ahead": len(positions(model))}


def settle_program(model: Model, row: Layout, stage: Stage) -> Program:
    """From a state that fits to one in elastic equilibrium; stage(name, body): on the fields of the row."""
    elastic = positions(model)
    rigid = [k for k in range(len(model.q_i)) if k not in elastic]
    loops = [model.q_d.index(name) for name in model.loop_unknowns]

    def loop(z: Fields) -> ca.SX:
        return z["q_d"][loops] if loops else ca.SX(0, 1)

    def placed(z: Fields, q_i: ca.SX, at: int) -> dict[str, ca.SX]:
        """To be settled: the state `at` leads away from its time."""
        q, lead = ca.SX(q_i), at * z["settle_lead"]
        if at and rigid:
            q[rigid] = q[rigid] + lead * z["q_i_dot"][rigid]
        open_ = z["settle"] * (z["settle_lead"] > 0 if at else 1)
        return {"settle_q": q, "settle_t": z["t"] + lead, "settle_open": open_, "settle_work": ca.SX(LARGEST)}

    def begin(z: Fields) -> Mapping[str, ca.SX]:
        return {"settled": ca.SX(1), "settle_lead": leading(model)(z["q_i"], z["q_i_dot"], z["q_d"], z["t"], z["c"])}

    def step(z: Fields) -> Mapping[str, ca.SX]:
        given = (z["settle_t"], z["settle_q"], z["q_i_dot"], loop(z), z["c"], z["settle_work"])
        q, open_, valley, work = settling(model)(*given)
        settled = ca.logic_and(z["settled"], valley)
        return {"settle_q": q, "settle_open": ca.logic_and(open_, valley), "settle_work": work, "settled": settled}

    def kept(z: Fields) -> dict[str, ca.SX]:
        """Still settled? Not where steps ran out."""
        return {"settled": ca.logic_and(z["settled"], z["settle_open"] <= 0)}

    def ahead(z: Fields) -> Mapping[str, ca.SX]:
        q_i = ca.if_else(z["settle"] > 0, z["settle_q"], z["q_i"])
        return {**kept(z), "q_i": q_i, **placed(z, q_i, 1)}

    def behind(z: Fields) -> Mapping[str, ca.SX]:
        return {**kept(z), "settle_ahead": z["settle_q"][elastic], **placed(z, z["q_i"], -1)}

    def rate(z: Fields) -> Mapping[str, ca.SX]:
        v, moving = ca.SX(z["q_i_dot"]), ca.logic_and(z["settle"] > 0, z["settle_lead"] > 0)
        found = (z["settle_ahead"] - z["settle_q"][elastic]) / (2 * z["settle_lead"])
        v[elastic] = ca.if_else(moving, found, v[elastic])
        return {**kept(z), "q_i_dot": v}

    def end(z: Fields) -> Mapping[str, ca.SX]:
        q_d = elastic_residual(model)(z["t"], z["q_i"], z["q_i_dot"], loop(z), z["c"])[3]
        return {"q_d": ca.if_else(z["settle"] > 0, q_d, z["q_d"])}

    solve = Until(stage("settle_step", step), row.slice("settle_open").start, MAX_STEPS, USUAL_STEPS)
    parts = [stage("settle_here", lambda z: placed(z, z["q_i"], 0)), solve, stage("settle_ahead", ahead), solve]
    parts += [stage("settle_behind", behind), solve, stage("settle_rate", rate)]
    return Sequence((stage("settle_begin", begin), Repeat(Sequence(tuple(parts)), PASSES), stage("settle_end", end)))

"""Steps that end at jumps in time, at events and at kinks, in exported C: what `stops.c` has to know of a model."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence
from importlib.resources import files

import casadi as ca
import numpy as np

from runtime.contract.consistent_state import ConsistentState
from runtime.contract.errors import ModelError
from runtime.contract.model import EmittedModel, refuse_reactions
from runtime.contract.signals import SINCE
from runtime.contract.tape import UNUSED, Node, Tape, read_tape, shared
from runtime.engine.c_source import Code, Style, named, number, stage_code, tape_code
from runtime.engine.prepare import Prepared
from runtime.running.time_functions import refuse_position_jumps
from runtime.schemes.scheme import Scheme
from runtime.schemes.switching.enclosure import EXACT_OPERATIONS
from runtime.schemes.switching.event_model import FUNCTIONS, WAYS, decision_functions, sizes, tables
from runtime.schemes.switching.impulse import may_give_impulses
from runtime.schemes.switching.times import may_jump, switching_times
from runtime.schemes.switching.watched import watched_events

ENDS = {"BY_EVENT": 1, "CHATTERING": 2, "NO_MODE": 3, "NOT_FINITE": 4, "TOO_MANY": 5, "BEYOND_A_STOP": 6}
ANY_EVENT = "struct { int way, terminal, from, to; double cool_down; }"
_BOUNDS = {
    ca.OP_ADD: "I_add({a}, {b})",
    ca.OP_SUB: "I_sub({a}, {b})",
    ca.OP_MUL: "I_times({a}, {b})",
    ca.OP_DIV: "I_times({a}, I_inv({b}))",
    ca.OP_FMIN: "I_min({a}, {b})",
    ca.OP_FMAX: "I_max({a}, {b})",
    ca.OP_LT: "I_lt({a}, {b})",
    ca.OP_LE: "I_le({a}, {b})",
    ca.OP_AND: "I_of({a}.low * {b}.low, {a}.high * {b}.high)",
    ca.OP_OR: "I_max({a}, {b})",
    ca.OP_IF_ELSE_ZERO: "I_where({a}, {b})",
    ca.OP_NEG: "I_neg({a})",
    ca.OP_TWICE: "I_of(2 * {a}.low, 2 * {a}.high)",
    ca.OP_NOT: "I_of(1 - {a}.high, 1 - {a}.low)",
    ca.OP_SQ: "I_sq({a})",
    ca.OP_FABS: "I_abs({a})",
    ca.OP_INV: "I_inv({a})",
    ca.OP_SIN: "I_sin({a})",
    ca.OP_COS: "I_cos({a})",
    ca.OP_SQRT: "I_mono(sqrt, {a})",
    ca.OP_EXP: "I_mono(exp, {a})",
    ca.OP_LOG: "I_mono(log, {a})",
    ca.OP_ATAN: "I_mono(atan, {a})",
    ca.OP_TANH: "I_mono(tanh, {a})",
    ca.OP_FLOOR: "I_step(floor, {a})",
    ca.OP_CEIL: "I_step(ceil, {a})",
    ca.OP_SIGN: "I_step(sign_of, {a})",
}


def refuse_stops(model: EmittedModel, p: np.ndarray) -> None:
    """Raises ModelError for jumps and events that exported code does not know, by name."""
    c, name = model.constants(p), f"of model {model.name}"
    if model.sources:
        raise ModelError(f"inputs {', '.join(model.sources)} {name}", "are functions of time", "give them as inputs")
    refuse_reactions(model, "exported code does not know", "give coulomb, or simulate it")
    moving = [event.name for event in model.description.events if event.sets and SINCE in model.signals.names]
    if moving:
        raise ModelError(
            f"the action of {', '.join(moving)} {name}", "is beside inputs with rates", "hold these inputs"
        )
    if not may_jump(model):
        return
    owners = model.description.switching
    for owner, nodes in zip(owners, _nodes_of(_conditions(model)), strict=True):
        if any(node.op not in _BOUNDS and node.op not in (ca.OP_INPUT, ca.OP_CONST) for node in nodes):
            raise ModelError(
                f"{owner} {name}",
                "jumps where a function says that exported code has no bounds for",
                "write the condition by sums, products, roots, sin, cos, exp, log, atan, tanh",
            )
    t_end = float(model.simulation["t_end"])
    times = switching_times(model, c, 0.0, t_end)
    refuse_position_jumps(model, c, ConsistentState(model.initial_q, model.initial_q_dot, {}), times, 0.0, t_end)
    if jolts := may_give_impulses(model, c, times):
        raise ModelError(
            f"the motion of {', '.join(jolts[0].owners)} {name}",
            f"has a velocity that jumps at {jolts[0].time:.6g} s, whose impulse is not in exported code",
            "let its velocity change in a finite time",
        )


def _conditions(model: EmittedModel) -> ca.Function:
    """(t, c) -> the conditions and their slopes, one after the other."""
    t, c = ca.SX.sym("t"), ca.SX.sym("c", model.c_size)
    g = ca.densify(ca.SX(model.evaluate("switching", t=t, c=c)["switching"]))
    both = [ca.vertcat(one, ca.jacobian(one, t)) for one in ca.vertsplit(g)]
    return ca.Function("conditions", [t, c], [ca.densify(ca.vertcat(*both))])


def _nodes_of(conditions: ca.Function) -> Iterator[list[Node]]:
    """The operations that each condition and its slope take."""
    t, c = conditions.sx_in()
    both = ca.SX(conditions(t, c))
    for k in range(0, both.numel(), 2):
        yield read_tape(ca.Function("one", [t, c], [ca.densify(both[k : k + 2])])).nodes


def stop_functions(scheme: Scheme, prepared: Prepared, prefix: str, library: Style, own: Style) -> dict[str, Code]:
    """The functions that `stops.c` calls, beside those of every export."""
    found = dict[str, Code]()
    for name, one in decision_functions(scheme, prepared).items():
        if name == "seen" and not scheme.model.element_modes.size:
            continue
        tape = named(one.function, *one.inputs)
        in_place = not one.output
        found[name] = (
            stage_code(f"{prefix}{name}", tape, own)
            if in_place
            else tape_code(f"{prefix}{name}", tape, [one.output], library)
        )
    if may_jump(scheme.model):
        both = _conditions(scheme.model)
        t, c = both.sx_in()
        g = ca.densify(ca.SX(both(t, c))[::2])
        found["conditions"] = tape_code(
            f"{prefix}conditions", named(ca.Function("g", [t, c], shared([g])), "t", "c"), ["g"], library
        )
    return found


def stop_text(scheme: Scheme, prepared: Prepared, prefix: str, functions: Collection[str]) -> tuple[str, int]:
    """(the model as `stops.c` knows it, with `stops.c` behind it, how many entries of w that takes).

    functions: which of FUNCTIONS the bundle has.
    """
    numbers, model = sizes(scheme, prepared), scheme.model
    modes, jumps = model.mode_events, numbers["NT"]
    entries_of = tables(scheme)
    given = {key: str(value) for key, value in numbers.items()} | {name: name for name in ("events_of", *entries_of)}
    given |= {name: f"{prefix}{name}" for name in FUNCTIONS if name in functions}
    given |= {"bounds": f"{prefix}bounds"} if jumps else {}
    fields = "\n".join(f"  .{key} = {value}," for key, value in given.items())
    text = _c("stops.c")
    for part in ("settle.c", "times.c"):
        text = text.replace(f'#include "{part}"\n', _c(part))
    parts = [
        "",
        "#define DOOR MAY static",
        _c("model.h"),
        *([_c("intervals.c"), _bounds(model, prefix)] if jumps else []),
    ]
    parts += [
        *event_table(scheme, "Event"),
        *(whole_numbers(name, entries) for name, entries in entries_of.items()),
        "",
    ]
    parts += [f"static const Model {prefix}model = {{\n{fields}\n}};", "", text.replace('#include "model.h"\n\n', "")]
    parts += [
        door.format(p=prefix)
        for door, there in ((_STEP, True), (_SETTLE, bool(modes)), (_NEXT_JUMP, jumps > 0))
        if there
    ]
    return "\n".join(parts), numbers["KEPT_IN_W"]


def _c(name: str) -> str:
    return files("runtime.schemes.switching").joinpath(name).read_text(encoding="utf-8")


_STEP = """
int {p}step(double *z, const double *c, double *w, long n) {{ return step(&{p}model, z, c, w, n); }}
"""
_SETTLE = """int {p}settle(double *at, double *u, const double *c, const int *happened, double *w) {{
  return settle_at(&{p}model, at, u, c, happened, w);
}}
"""
_NEXT_JUMP = """int {p}next_jump(double *found, const double *c, double t, double until, double *w) {{
  return next_jump(&{p}model, found, c, t, until, w);
}}
"""


def event_table(scheme: Scheme, kind: str = ANY_EVENT) -> list[str]:
    """`events_of`: direction, end and actions of each, as C; one entry longer."""
    lines, at = [f"static const {kind} events_of[] = {{"], 0
    for event in watched_events(scheme):
        way, end = WAYS[event.direction], at + len(event.sets)
        lines.append(f"  {{{way}, {int(event.terminal)}, {at}, {end}, {event.cool_down!r}}},")
        at = end
    return [*lines, "  {0, 0, 0, 0, 0.0},", "};"]


def whole_numbers(name: str, values: Sequence[int]) -> str:
    """A static table, one entry longer."""
    return f"static const int {name}[] = {{{', '.join(map(str, [*values, 0]))}}};"


def _bounds(model: EmittedModel, prefix: str) -> str:
    """`bounds`: of each condition and of its slope over an interval of time; may it jump there?"""
    tape: Tape = read_tape(_conditions(model))
    lines = [f"static void {prefix}bounds(I *found, int *jumps, double low, double high, const double *c) {{"]
    lines.append("  const I t = I_of(low, high);\n  (void)c, (void)jumps, (void)t;")
    for k, node in enumerate(tape.nodes):
        if node.op == ca.OP_INPUT:
            text = "t" if node.a == 0 else f"I_of(c[{node.b}], c[{node.b}])"
        elif node.op == ca.OP_CONST:
            text = f"I_of({number(node.value)}, {number(node.value)})"
        else:
            text = _BOUNDS[node.op].format(a=f"v{node.a}", b=f"v{node.b}" if node.b != UNUSED else "")
            text = text if node.op in EXACT_OPERATIONS else f"I_wide({text})"
        lines.append(f"  const I v{k} = {text};")
    lines += [f"  found[{k}] = v{node};" for k, node in enumerate(tape.outputs[0])]
    return "\n".join([*lines, "}", ""])

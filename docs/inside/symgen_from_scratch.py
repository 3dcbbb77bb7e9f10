"""symgen from scratch: the whole idea on a pendulum, in one program that uses nothing of symgen.

Each part is what a folder of `symgen` or `runtime` does for every body, joint and scheme. A test runs it
(`test_the_program_from_scratch_runs`) and compares it with closed forms and with equations derived by hand.

    template                    one bar, one hinge                          symgen/algebra, symgen/bodies, symgen/joints
    substitution, condensation  20 lines                                    symgen/condensed
    kernel                      one CasADi function                         symgen/kernels
    tape                        a list of nodes, split by what is known     symgen/tapes, runtime/engine
    step                        central difference                          runtime/schemes
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import casadi as ca
import sympy as sp

# --- Template: SymPy, once for each type ---
# A bar is a line of mass points. The point at the distance xi from the bar's origin (x, y) is at
#
#     r = (x + xi cos(theta), y + xi sin(theta)).
#
# The virtual work of its inertia force is delta_r . r'' dm, with r'' = J q'' + bias. Summed over the bar, every power
# of xi becomes a moment of the bar: its mass m, its first moment s, its second moment I. That is Eq. (20) of the
# paper, without modes.

x, y, theta, x_dot, y_dot, theta_dot = q_and_q_dot = sp.symbols("x y theta x_dot y_dot theta_dot")
q, q_dot = sp.Matrix(q_and_q_dot[:3]), sp.Matrix(q_and_q_dot[3:])
xi, m, s, I, g = sp.symbols("xi m s I g")  # noqa: E741
MOMENTS = {0: m, 1: s, 2: I}


def over_the_bar(expression: sp.Expr) -> sp.Expr:
    """int(expression dm): powers of xi become moments."""
    terms = sp.Poly(sp.trigsimp(sp.expand(expression)), xi).terms()
    return sp.Add(*(coefficient * MOMENTS[power] for (power,), coefficient in terms))


r = sp.Matrix([x + xi * sp.cos(theta), y + xi * sp.sin(theta)])
J = r.jacobian(q)
bias = (J * q_dot).jacobian(q) * q_dot
M_template = (J.T * J).applyfunc(over_the_bar)
Q_template = (J.T * (sp.Matrix([0, -g]) - bias)).applyfunc(over_the_bar)


# A hinge holds the origin of a bar at the tip of the bar before it. It states only its rows C = 0. The rest follows:
# C_q, and gamma of C_q q'' = gamma (Eqs. 24-27).

l, x_p, y_p, theta_p, theta_p_dot = sp.symbols("l x_p y_p theta_p theta_p_dot")  # noqa: E741
TIP = {"x": x_p + l * sp.cos(theta_p), "y": y_p + l * sp.sin(theta_p)}  # C = x - TIP["x"], y - TIP["y"]
E_template = {name: sp.diff(row, theta_p) for name, row in TIP.items()}  # x'' = x_p'' + e theta_p'' + c
C_template = {name: sp.diff(row, theta_p, 2) * theta_p_dot**2 for name, row in TIP.items()}


# --- From SymPy to CasADi ---
# A template is evaluated with each body's own values. SymPy is slow and knows much; CasADi's SX is fast and knows how
# to fold 0 x and x + 0. So what is zero in a scene never reaches its code. Only the operations that occur are
# translated, and no text is evaluated.

SX = ca.SX


def evaluated(expression: sp.Expr, values: dict[sp.Symbol, SX]) -> SX:
    """The SX of a template."""
    if isinstance(expression, sp.Symbol):
        return values[expression]
    if expression.is_Number:
        return SX(float(expression))
    arguments = [evaluated(argument, values) for argument in expression.args]
    if isinstance(expression, sp.Pow) and expression.exp == 2:
        return arguments[0] * arguments[0]
    two = {sp.Add: lambda a, b: a + b, sp.Mul: lambda a, b: a * b}.get(expression.func)
    if two:
        result = arguments[0]
        for argument in arguments[1:]:
            result = two(result, argument)
        return result
    return {sp.sin: ca.sin, sp.cos: ca.cos}[expression.func](*arguments)


# --- The system ---
# The scene is a chain of bars, one hung to the tip of the other, in the parameters p = (g, then m, s, I, l of each
# bar). Angles are independent, the origins of the bars dependent: q_i and q_d of Eq. (29). The rows are linear in x
# and y with the coefficient 1, so q_d is known in closed form (Eq. 31), and each dependent acceleration is one
# *substitution*
#
#     x_d'' = sum of e_j x_j'' + c.


@dataclass
class Substitution:
    """The acceleration number `target` by others: sum of terms[j] a_j, plus rest."""

    target: int
    terms: dict[int, SX]
    rest: SX


def chain(bars: int, q_i: SX, q_i_dot: SX, p: SX) -> tuple[SX, SX, list[Substitution]]:
    """M and Q of all coordinates (x, y, theta of each bar), and the substitutions, from the tip to the root."""
    M, Q = SX(3 * bars, 3 * bars), SX(3 * bars, 1)
    substitutions, origin = [], {"x": SX(0), "y": SX(0)}
    for k in range(bars):
        values = {theta: q_i[k], theta_dot: q_i_dot[k], g: p[0]}
        values |= dict(zip((m, s, I), p[4 * k + 1 :].elements(), strict=False))
        for i in range(3):
            Q[3 * k + i] = evaluated(Q_template[i], values)
            for j in range(3):
                M[3 * k + i, 3 * k + j] = evaluated(M_template[i, j], values)
        if k == 0:  # the first bar hangs on the ground, at rest
            substitutions += [Substitution(axis, {}, SX(0)) for axis in (0, 1)]
        else:
            before = {theta_p: q_i[k - 1], theta_p_dot: q_i_dot[k - 1], l: p[4 * k]}
            before |= {x_p: origin["x"], y_p: origin["y"]}
            for axis, name in enumerate("xy"):
                e, rest = (evaluated(part[name], before) for part in (E_template, C_template))
                terms = {3 * (k - 1) + axis: SX(1), 3 * (k - 1) + 2: e}
                substitutions.append(Substitution(3 * k + axis, terms, rest))
            origin = {name: evaluated(row, before) for name, row in TIP.items()}
    return M, Q, substitutions[::-1]


# --- Condensation: one congruence for each substitution ---
# Put x_d'' into M q'' = Q, and let virtual displacements follow the same rule. Column d and row d go to the others.
# Done from the tip to the root, nothing is ever inverted, and S of M_hat = S^T M S is never formed (Eqs. 32-38).


def substituted(M: SX, Q: SX, rule: Substitution) -> tuple[SX, SX]:
    """M q'' = Q without the target of the rule: its row and column are zero afterwards."""
    M, Q, d = SX(M), SX(Q), rule.target
    Q = Q - M[:, d] * rule.rest
    for j, e in rule.terms.items():
        M[:, j] += M[:, d] * e
    for j, e in rule.terms.items():
        M[j, :] += e * M[d, :]
        Q[j] += e * Q[d]
    M[:, d], M[d, :], Q[d] = SX(M.size1(), 1), SX(1, M.size2()), SX(0)
    return ca.sparsify(M), Q


def condensed(bars: int, q_i: SX, q_i_dot: SX, p: SX) -> tuple[SX, SX]:
    """M_hat and Q_hat of Eq. (38)."""
    M, Q, substitutions = chain(bars, q_i, q_i_dot, p)
    for rule in substitutions:
        M, Q = substituted(M, Q, rule)
    angles = [3 * k + 2 for k in range(bars)]
    return ca.densify(M[angles, angles]), Q[angles]


# The solution of M_hat q_i'' = Q_hat is the same idea again. The last equation is a substitution for its own
# acceleration.


def solved(M: SX, Q: SX) -> SX:
    """q_i'': each equation gives its own acceleration by those before it; the last ones go first."""
    rules = []
    for k in reversed(range(Q.numel())):
        rule = Substitution(k, {j: -M[k, j] / M[k, k] for j in range(k)}, Q[k] / M[k, k])
        rules.append(rule)
        M, Q = substituted(M, Q, rule)
    accelerations: dict[int, SX] = {}
    for rule in reversed(rules):
        terms = (e * accelerations[j] for j, e in rule.terms.items())
        accelerations[rule.target] = sum(terms, rule.rest)
    return ca.vertcat(*(accelerations[k] for k in range(len(rules))))


# --- Kernel ---
# A kernel is a CasADi function: inputs and outputs with names, and a graph without anything that is zero. Of the
# pendulum's nine mass terms and four constraint terms one equation is left: I theta'' = -g s cos(theta).


def kernel(bars: int) -> ca.Function:
    """(q_i, q_i_dot, p) -> M_hat, Q_hat."""
    q_i, q_i_dot, p = SX.sym("q_i", bars), SX.sym("q_i_dot", bars), SX.sym("p", 1 + 4 * bars)
    names = ["q_i", "q_i_dot", "p"], ["M_hat", "Q_hat"]
    return ca.Function("condensed", [q_i, q_i_dot, p], [*condensed(bars, q_i, q_i_dot, p)], *names)


print(kernel(1)(*kernel(1).sx_in()))


# --- Step ---
# One step is a pure function z -> z. For the central difference z holds the positions q, the increment d = q(t) - q(t
# - h) and the last acceleration a (Eqs. 40-43); the velocity at t is d/h + h a/2, with a from the step before. The
# start makes d of the initial velocity (Eqs. 68-71).


def step(bars: int) -> ca.Function:
    """(z, c) -> z with z = (q, d, a) and c = (h, p)."""
    z, c = SX.sym("z", 3 * bars), SX.sym("c", 2 + 4 * bars)
    q_i, d, a = ca.vertsplit(z, bars)
    h, p = c[0], c[1:]
    a = solved(*condensed(bars, q_i, d / h + h * a / 2, p))
    d = d + h * h * a
    return ca.Function("step", [z, c], [ca.vertcat(q_i + d, d, a)], ["z", "c"], ["z_next"])


def start(bars: int, q_i: Sequence[float], h: float, p: Sequence[float]) -> list[float]:
    """z of a motion from rest."""
    M_hat, Q_hat = kernel(bars)(q_i, [0.0] * bars, p)
    a = ca.solve(M_hat, Q_hat).full().ravel()
    return [*q_i, *(-0.5 * h * h * a), *a]


# --- Tape ---
# CasADi gives a function as a list of instructions. We take it over as our own straight-line code: a *tape* of nodes,
# each an operation on nodes before it. From here on nothing of CasADi is needed, and everything is an interpreter
# over the tape.


@dataclass(frozen=True)
class Node:
    """An operation on earlier nodes, an input ("z", "c" or "once", element) or a number."""

    op: str
    arguments: tuple[int, ...] = ()
    value: float = 0.0
    element: int = 0


@dataclass(frozen=True)
class Tape:
    """Nodes in an order in which they can be computed, and which of them are results."""

    nodes: list[Node]
    results: list[int]


Operation = Callable[..., float]
OPERATIONS: dict[int, tuple[str, str, Operation]] = {  # name, C text, value
    ca.OP_ADD: ("add", "{} + {}", lambda a, b: a + b),
    ca.OP_SUB: ("sub", "{} - {}", lambda a, b: a - b),
    ca.OP_MUL: ("mul", "{} * {}", lambda a, b: a * b),
    ca.OP_DIV: ("div", "{} / {}", lambda a, b: a / b),
    ca.OP_NEG: ("neg", "-{}", lambda a: -a),
    ca.OP_SQ: ("sq", "{0} * {0}", lambda a: a * a),
    ca.OP_TWICE: ("twice", "2.0 * {}", lambda a: 2.0 * a),
    ca.OP_INV: ("inv", "1.0 / {}", lambda a: 1.0 / a),
    ca.OP_SIN: ("sin", "sin({})", math.sin),
    ca.OP_COS: ("cos", "cos({})", math.cos),
}
TEXT = {name: text for name, text, _ in OPERATIONS.values()}
VALUE = {name: value for name, _, value in OPERATIONS.values()}


def recorded(function: ca.Function) -> Tape:
    """The tape of a CasADi SX function; CasADi's registers are used again and again, our nodes only once."""
    nodes: list[Node] = []
    register: dict[int, int] = {}
    results = [0] * function.nnz_out(0)
    for k in range(function.n_instructions()):
        op, inputs, outputs = function.instruction_id(k), function.instruction_input(k), function.instruction_output(k)
        if op == ca.OP_OUTPUT:
            results[outputs[1]] = register[inputs[0]]
            continue
        if op == ca.OP_INPUT:
            node = Node(function.name_in(inputs[0]), element=inputs[1])
        elif op == ca.OP_CONST:
            node = Node("number", value=function.instruction_constant(k))
        else:
            node = Node(OPERATIONS[op][0], tuple(register[i] for i in inputs))
        register[outputs[0]] = len(nodes)
        nodes.append(node)
    return Tape(nodes, results)


def run(tape: Tape, **inputs: Sequence[float]) -> list[float]:
    """The results, one node after another."""
    values: list[float] = []
    for node in tape.nodes:
        if node.op == "number":
            values.append(node.value)
        elif node.op in inputs:
            values.append(inputs[node.op][node.element])
        else:
            values.append(VALUE[node.op](*(values[i] for i in node.arguments)))
    return [values[i] for i in tape.results]


# --- Splitting by what is known ---
# During a run c = (h, p) does not change. What depends on c only is computed once: the tape is split into one for
# before the run, and one for each step that reads the values of the first. This is partial evaluation with known and
# unknown inputs. Physical numbers so stay inputs at no cost per step.


def split(tape: Tape) -> tuple[Tape, Tape]:
    """What depends on c only, with the largest such values as results, and the rest that reads them as "once"."""
    known: set[int] = set()
    for k, node in enumerate(tape.nodes):
        if node.op in ("c", "number") or (node.arguments and known.issuperset(node.arguments)):
            known.add(k)
    used = {i for k, node in enumerate(tape.nodes) if k not in known for i in node.arguments} | set(tape.results)
    once = [k for k in sorted(known & used) if tape.nodes[k].op != "number"]
    place = {k: element for element, k in enumerate(once)}
    rest = [Node("once", element=place[k]) if k in place else node for k, node in enumerate(tape.nodes)]
    return needed(Tape(tape.nodes, once)), needed(Tape(rest, tape.results))


def needed(tape: Tape) -> Tape:
    """Without the nodes that no result depends on."""
    kept = set(tape.results)
    for k in reversed(range(len(tape.nodes))):
        if k in kept:
            kept |= set(tape.nodes[k].arguments)
    number = {k: new for new, k in enumerate(sorted(kept))}
    old = (tape.nodes[k] for k in number)
    nodes = [Node(node.op, tuple(number[i] for i in node.arguments), node.value, node.element) for node in old]
    return Tape(nodes, [number[k] for k in tape.results])


def operations(tape: Tape) -> int:
    """How many operations one evaluation takes."""
    return sum(bool(node.arguments) for node in tape.nodes)


# The second interpreter writes C instead of computing. The compiler must not contract a product and a sum (-ffp-
# contract=off); then both engines give the same bits.


def c_source(tape: Tape) -> str:
    """The tape as a C function of (z, once) that writes z."""
    lines = []
    for k, node in enumerate(tape.nodes):
        if node.op == "number":
            text = float(node.value).hex()
        elif node.op in TEXT:
            text = TEXT[node.op].format(*(f"v{i}" for i in node.arguments))
        else:
            text = f"{node.op}[{node.element}]"
        lines.append(f"  const double v{k} = {text};")
    lines += [f"  z[{element}] = v{k};" for element, k in enumerate(tape.results)]
    body = "\n".join(lines)
    return f"#include <math.h>\nvoid step(double *z, const double *once) {{\n{body}\n}}\n"


# --- A run ---
# A pendulum of 1 kg at 1 m, released from the horizontal. Its period is 2 pi sqrt(l/g) over the arithmetic-geometric
# mean of 1 and cos(45 degrees). It passes the lowest point after one and after three quarters; there the acceleration
# vanishes, so a straight line between two samples finds the time. The period's error is of second order, and two step
# sizes take it out.


def motion(bars: int, q_i: Sequence[float], h: float, p: Sequence[float], steps: int) -> list[list[float]]:
    """z at 0, h, 2 h, ..."""
    before, each = split(recorded(step(bars)))
    once = run(before, c=[h, *p])
    path = [start(bars, q_i, h, p)]
    for _ in range(steps):
        path.append(run(each, z=path[-1], once=once))
    return path


def period(h: float) -> float:
    """Twice the time between two passages of the lowest point [s]."""
    angles = [z[0] + math.pi / 2 for z in motion(1, [0.0], h, PENDULUM, round(2.0 / h))]
    signs = [(k, a, b) for k, (a, b) in enumerate(zip(angles, angles[1:], strict=False)) if (a > 0) != (b > 0)]
    first, second = (h * (k + a / (a - b)) for k, a, b in signs[:2])
    return 2.0 * (second - first)


def exact_period(length: float, gravity: float, amplitude: float) -> float:
    """Of a simple pendulum, by the arithmetic-geometric mean [s]."""
    a, b = 1.0, math.cos(amplitude / 2)
    while abs(a - b) > 1e-15:
        a, b = (a + b) / 2, math.sqrt(a * b)
    return 2 * math.pi * math.sqrt(length / gravity) / a


PENDULUM = (9.81, 1.0, 1.0, 1.0, 1.0)  # g, m, s, I, l
coarse, fine = period(2e-3), period(1e-3)
extrapolated = (4 * fine - coarse) / 3
whole = recorded(step(1))
print(f"operations a step: {operations(whole)}, of which once a run: {operations(split(whole)[0])}")
print(f"period {fine:.9f} s, extrapolated {extrapolated:.12f} s, exact {exact_period(1.0, 9.81, math.pi / 2):.12f} s")


# A second bar hung on the first is chain(2, ...): nothing else changes. What the project adds is more types of
# bodies, joints and loads, flexible bodies, loops whose dependent coordinates need Newton steps, reactions and
# Jacobians, steps of different size for slow and fast coordinates, and the checks that tell whether a run can be
# believed. Architecture says where each is.

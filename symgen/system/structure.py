"""The equations of a linear structure, M x'' + D x' + K x = F(t) (Eqs. 3-14): already in independent coordinates.

Expressions of a scene as the equations take them: their values, and where in time they jump or kink.

Where an expression jumps or kinks: the values that change their sign there, read off its tree.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import reduce
from itertools import count
from typing import TYPE_CHECKING, Any

import casadi as ca

from symgen.algebra.parameters import ParameterTable
from symgen.algebra.rows import Row
from symgen.algebra.scalar import ZERO, mul, total
from symgen.scene.parts import AnyTable
from symgen.schema.expressions import Node
from symgen.system.equations import Equations, blank_equations

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


def switching_values(node: Node, env: Mapping[str, Any]) -> Iterator[ca.SX]:
    """What changes sign where the expression jumps or kinks, inner conditions first, tables left out.

    Of `where` the two sides of each comparison, of `step`, `sign` and `abs` the argument, of `min` and `max` the
    distance to the least and largest of those before. Raises KeyError for a name that env does not hold.
    """
    for part in node.parts:
        yield from switching_values(part, env)
    if node.kind == "where":
        for comparison in node.parts[0].parts:
            left, right = (side.casadi(env) for side in comparison.parts)
            yield left - right
    elif node.kind in ("step", "sign", "abs"):
        yield node.parts[0].casadi(env)
    elif node.kind in ("min", "max"):
        values = [part.casadi(env) for part in node.parts]
        extreme = ca.fmin if node.kind == "min" else ca.fmax
        yield from (values[k] - reduce(extreme, values[:k]) for k in range(1, len(values)))


def knot_values(node: Node, env: Mapping[str, Any], tables: Mapping[str, AnyTable]) -> Iterator[ca.SX]:
    """What changes sign where the tables of the expression kink: their arguments, from their points."""
    for part in node.parts:
        yield from knot_values(part, env, tables)
    if node.kind == "table":
        for argument, places in zip(node.parts, tables[str(node.value)].kinks(), strict=True):
            x = argument.casadi(env)
            yield from (x - place for place in places)


ORDERED = ("<", "<=", ">", ">=")


def held_value(node: Node, env: Mapping[str, Any], side: Callable[[ca.SX], ca.SX]) -> ca.SX:
    """The value of an expression whose jumps stay on the sides that are held.

    side(x): what is added to x where the expression jumps as x passes zero; see Equations.sides. What is continuous
    there (`abs`, `min`, `max`) is left as it is: it may have no value beyond. Raises KeyError as switching_values does.
    """
    if not node.parts:
        return node.casadi(env)
    given = [held_value(part, env, side) for part in node.parts]
    if node.kind in ORDERED:
        left, right = (part.casadi(env) for part in node.parts)
        given[0] = given[0] + side(left - right)
    elif node.kind in ("step", "sign"):
        given[0] = given[0] + side(node.parts[0].casadi(env))
    return node.applied(given, env)


Read = Callable[[float | str, str, Mapping[str, ca.SX]], ca.SX]  # an expression, its item, its local names


SAME_DEPTH = 20  # down to which two expressions are compared
UNHELD = 1e300  # what is larger, or no number, is no value of an expression


@dataclass(frozen=True)
class ExpressionReader:
    """Reads expressions of a scene; equations.switching gets what changes its sign where they jump or kink in time,
    equations.kinks what does where the motion decides. definitions: what measures by expression stand for.
    """

    scene: SceneRecord
    equations: Equations
    definitions: dict[str, Node] = field(default_factory=dict)

    def read(self, text: float | str, item: str, owner: str, environment: Mapping[str, Any], *names: str) -> ca.SX:
        """The value of an expression of t, the inputs and these names; owner: the load, joint or state that it is of.

        Raises SceneError with the item.
        """
        eq = self.equations
        expression = self.scene.expression(text, item, ("t", *eq.u, *names))
        value, node = expression.to_casadi(environment), expression.node.with_definitions(self.definitions)
        for found in switching_values(node, environment):
            self.switch(owner, found)
        for found in knot_values(node, environment, self.scene.tables):
            if not self._in_motion(found):  # there steps pass the points of a table
                self.switch(owner, found)
        return self._held(expression.node, item, owner, environment, value)

    def _held(self, node: Node, item: str, owner: str, environment: Mapping[str, Any], value: ca.SX) -> ca.SX:
        """An expression with its jumps by the motion held, and as it is where it has no value beyond one of them."""
        eq, places = self.equations, count()

        def side(found: ca.SX) -> ca.SX:
            place = item, next(places)
            if place not in eq.held and self._in_motion(found):
                eq.held[place] = self.switch(owner, found)
            name = eq.held.get(place)
            return ca.SX(0) if not name else eq.sides.setdefault(name, ca.SX.sym(f"{name}.side"))

        held, known = held_value(node, environment, side), len(eq.held)
        if not known or not ca.depends_on(held, ca.vertcat(*eq.sides.values())):
            return value
        return ca.if_else(ca.fabs(held) < UNHELD, held, value)

    def switch(self, owner: str, value: ca.SX) -> str:
        """A step may end where this passes zero: by time alone, or by the motion. The name of the kink, if any."""
        eq = self.equations
        if self._in_motion(value):
            known = (name for name, (_, other) in eq.kinks.items() if ca.is_equal(value, other, SAME_DEPTH))
            if name := next(known, ""):
                return name
            number = sum(one == owner for one, _ in eq.kinks.values()) + 1
            eq.kinks[f"{owner}.kink{number}"] = owner, value
            return f"{owner}.kink{number}"
        if ca.depends_on(value, ca.vertcat(eq.t, *eq.u.values())) and not _known(value, eq.switching):
            eq.switching.append((owner, value))
        return ""

    def _in_motion(self, value: ca.SX) -> bool:
        return bool(ca.depends_on(value, ca.vertcat(*self.equations.q, *self.equations.q_dot)))


def _known(value: ca.SX, among: Iterable[tuple[str, ca.SX]]) -> bool:
    return any(ca.is_equal(value, other, SAME_DEPTH) for _, other in among)


def structure_equations(scene: SceneRecord, table: ParameterTable) -> Equations:
    """(3), and (9) with its blocks in the order of the partition; the damping of (3), dropped there, stays."""
    structure = scene.structure
    assert structure is not None
    eq = blank_equations(scene)
    env, reader = {**table.environment(), "t": eq.t, **eq.u}, ExpressionReader(scene, eq)

    def matrix(rows: Sequence[Sequence[float | str]] | None, label: str, unit: str) -> list[Row]:
        return [
            {}
            if rows is None
            else {
                column: table.quantity(value, f"{label}[{row},{column}]", unit, array=label)
                for column, value in enumerate(rows[row])
                if value != 0
            }
            for row in range(len(eq.names))
        ]

    M = matrix(structure.mass, "M", "kg")
    K = matrix(structure.stiffness, "K", "N/m")
    D = matrix(structure.damping, "D", "N s/m")
    Q_F, elastic, dissipated, applied = list[ca.SX](), eq.elastic, eq.dissipated, eq.applied
    for row in range(len(eq.names)):
        spring = total(mul(value, eq.q[column]) for column, value in K[row].items())
        damper = total(mul(value, eq.q_dot[column]) for column, value in D[row].items())
        load = ca.SX(0)
        if structure.force is not None:
            load = reader.read(structure.force[row], f"force[{row}]", f"force[{row}]", env)
        Q_F.append(load - damper)
        elastic = elastic + eq.q[row] * spring / 2
        dissipated = dissipated + eq.q_dot[row] * damper
        applied = applied + eq.q_dot[row] * load
    return replace(
        eq,
        K=K,
        Q_F=Q_F,
        elastic=elastic,
        dissipated=dissipated,
        applied=applied,
        masses=lambda: M,
        velocity_forces=lambda: [ZERO] * len(eq.q),
    )

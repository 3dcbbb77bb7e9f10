"""The equations of the whole system in all coordinates q: M, Q*, C, C_q, C_t, gamma, energies (Eqs. 20-28).

q are generalised coordinates with the holonomic constraints C(q, t) = 0: Lagrange's equations of the first kind.

Sparse rows of CasADi SX, put together from the scene's bodies, joints and loads. Nothing is condensed here.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, reduce
from typing import TYPE_CHECKING, Protocol

import casadi as ca

from runtime.contract.records import Coordinate, EventRecord, InputRecord, ModeSetRecord
from symgen.algebra.rows import Row, add_scaled, add_to, to_matrix
from symgen.algebra.scalar import ONE, ZERO, add, dot, mul, sub, total
from symgen.algebra.vectors import Vector
from symgen.bodies.outlines import Picture
from symgen.loads.load import LinearSpring
from symgen.scene.attachments import StaticResidual
from symgen.system.constraint import ConstraintRow
from symgen.system.orientations import RotationVector
from symgen.system.signals import input_records, input_symbols

if TYPE_CHECKING:
    from symgen.mechanism.scene import SceneRecord


@dataclass(frozen=True)
class Direction:
    """dx_c/dx_i of each coordinate, and its first two derivatives in time, by column; column: of x_i.

    by_rate: dx_c''/dx_i', which is twice the first where velocities are rates of coordinates.
    """

    column: int
    S: Row
    S_dot: Row
    S_ddot: Row
    by_rate: Row


@dataclass(frozen=True)
class Rotor:
    """A rotor that turns with a joint: inertia J, its turning rate s = row . q', what the row leaves of s', and the
    generalised force of the gyroscopic moment of its carrier."""

    inertia: ca.SX
    row: Row
    bias: ca.SX
    gyroscopic: Row

    def force(self, accelerations: Row) -> Row:
        """J row s' and the gyroscopic moment."""
        rotation = add(self.bias, total(mul(self.row[c], x) for c, x in accelerations.items() if c in self.row))
        found = dict(self.gyroscopic)
        add_scaled(found, mul(self.inertia, rotation), self.row)
        return found

    def add_to(self, M: list[Row]) -> None:
        """J row row^T."""
        for column, value in self.row.items():
            add_scaled(M[column], mul(self.inertia, value), self.row)


@dataclass(frozen=True)
class Rubbing:
    """What rubs on an element. mode: 0 while it is stuck, else the sign of v, an input that a run sets.

    holds: the force on v that keeps it stuck lies between -holds and holds. Where it moves, its law is a force.
    reaction: the size of the joint's force as a symbol in both, where they are a share of it. margin: where its limits
    change as the run goes on, how far the least of what must not be negative is from that. slides: the force against a
    slow sliding, where it may be less than what holds.
    """

    name: str
    mode: ca.SX
    law: ca.SX
    holds: ca.SX
    reaction: ca.SX | None
    margin: ca.SX | None = None
    slides: ca.SX | None = None

    def record(self, row: int) -> EventRecord:
        """Of the event that ends a mode; row: of the element."""
        return EventRecord(self.name, "falling", mode=self.mode.name(), row=row)


@dataclass(frozen=True)
class Stop:
    """An end of the way of an element: gap' = side v. mode: 0 while it is closed, then side times the force on v is
    positive; 1 while it is open, -1 where it was left at rest. moves: is a start beyond it moved to it?
    """

    name: str
    mode: ca.SX
    side: int
    gap: ca.SX
    restitution: ca.SX
    moves: bool

    def record(self, row: int) -> EventRecord:
        """Of the event that ends a mode; row: of the element."""
        return EventRecord(self.name, "falling", mode=self.mode.name(), row=row, side=self.side, moves=self.moves)


@dataclass(frozen=True)
class Element:
    """A direction that may be held: v = row . q', v' = row . q'' - gamma; by friction that sticks, by a closed stop."""

    joint: str
    row: Row
    rate: ca.SX
    gamma: ca.SX
    friction: Rubbing | None
    stops: Sequence[Stop]

    @property
    def parts(self) -> list[Rubbing | Stop]:
        """What has a mode, in the order of the modes."""
        return [*([] if self.friction is None else [self.friction]), *self.stops]

    @property
    def moves(self) -> ca.SX:
        """One, or zero where it is held."""
        return product([mul(part.mode, part.mode) for part in self.parts])

    @property
    def open(self) -> ca.SX:
        """One, or zero where a stop is closed."""
        return product([mul(part.mode, part.mode) for part in self.stops])

    @property
    def stuck(self) -> ca.SX:
        """One where it is held, or zero."""
        return sub(ONE, self.moves)

    @property
    def law(self) -> ca.SX:
        """Force of friction that slides."""
        return ZERO if self.friction is None else self.friction.law

    @property
    def holds(self) -> ca.SX:
        """Force up to which friction holds."""
        return ZERO if self.friction is None else self.friction.holds

    @property
    def slides(self) -> ca.SX:
        """Force of friction once it slides."""
        return self.holds if self.friction is None or self.friction.slides is None else self.friction.slides

    @property
    def share(self) -> ca.SX:
        """The same, for a reaction of one: what it takes of what is held more than once."""
        one = self.friction
        return self.holds if one is None or one.reaction is None else ca.substitute(one.holds, one.reaction, 1)


def product(factors: Sequence[ca.SX]) -> ca.SX:
    """Of all; one of none."""
    return reduce(mul, factors, ONE)


InertiaForces = Callable[[Row], Row]  # of a tree of frames: accelerations -> by column
ForceChanges = Callable[[Row], tuple[list[Row], list[Row]]]  # accelerations, held -> rows by q and by q_dot
# accelerations, multipliers of loops, directions -> F_q and F_v of (inertia forces + C_q^T lambda), None: no way
LoopChanges = Callable[[Row, Mapping[str, Vector], Sequence[Direction]], tuple[ca.SX, ca.SX] | None]
RowRates = Callable[[Row, Row], tuple[list[Row], list[Row]]]  # rates, accelerations -> dC_q/dt, d^2 C_q/dt^2 by row


class NoInertia(Exception):
    """A coordinate that accelerates (its column) has no inertia, by itself or beside the others."""


class FreeJointAccelerations(Protocol):
    """Accelerations of a tree of frames in O(N)."""

    def __call__(self, force: Row, free: frozenset[int], masks: Row, imposed: Row | None = None) -> Row:
        """M_hat^-1 force by column; free: the columns that accelerate; masks: one, or zero where a column is held.

        imposed: accelerations of the others; then also by rates and weight, which `force` does not have.
        """


@dataclass
class Equations:
    """What stands in M q_ddot + K q + C_q^T lam = Q_F + Q_v, C = 0: (1)-(2), which are (22)-(23), of a whole scene.

    Columns follow `coordinates`; M is symmetric with both triangles stored. masses, velocity_forces: what M and Q_v are
    derived by when they are first asked for.

    Q_F holds loads, gravity and damping; Q_star = Q_v - K q + Q_F. inertia_forces, where the bodies are a tree of
    frames: accelerations -> M q_ddot - Q_v; Q_v holds the weight too there, not Q_F.
    force_changes: derivatives of these, where they are known by composites; loop_rates: so, by joint;
    loop_changes: along directions.
    free_joints: accelerations for a force on such a tree, if joints place all its bodies.
    placed_columns: coordinates of the frames of placed bodies, which no mass and no other constraint knows of;
    felt_columns: those of them that forces depend on, by measures of coordinates, with those that they follow from.
    Energies [J] and powers [W] are scalars.
    rotors: of motors, which M and Q_v hold. elements: of friction, whose laws Q_F holds, and rigid stops.
    one_sided: by `joint.stop_force`, ... the force [N or N m] and the velocity of what pushes and never pulls, with SI
    units.
    springs: loads that are linear springs, by name. joint_columns: coordinates of joints; gravity: its components
    [m/s^2]; measure_units: SI unit of each measure. u: the entries of the inputs by name, each a symbol.
    load_forces: generalised force of each load and each joint's friction, by its name. beams: their mode sets;
    flexible: bodies in space with modes of their own; static_residuals: beams whose shapes do not carry what is
    attached to them.
    q_ddot, lam: symbols of the accelerations and the multipliers; accelerated: measures that follow from them, by name.
    load_actions: what each load does at its marker or marker b, see LoadEffect; load_spans: its `along`;
    loads_beyond: its `beyond`; load_sizes: its `size`.
    events: by name what passes zero, and the values that inputs get then.
    switching: (load, joint or state, value) of what changes sign where an expression jumps or kinks in time; kinks: by
    name (load, joint or state, value) of what does where it depends on the motion. sides: by the name of a kink a
    symbol that is added to what jumps there: zero, or so large that it stays on one side; held: the names by the places
    of comparisons in expressions (item, number).
    rotation_vectors: orientations with velocities of their own, whose columns follow those of all coordinates.
    """

    coordinates: list[Coordinate]
    q: list[ca.SX]
    q_dot: list[ca.SX]
    t: ca.SX
    K: list[Row]
    Q_F: list[ca.SX]
    constraints: list[ConstraintRow]
    elastic: ca.SX = field(default_factory=lambda: ca.SX(0))
    potential: ca.SX = field(default_factory=lambda: ca.SX(0))
    dissipated: ca.SX = field(default_factory=lambda: ca.SX(0))
    applied: ca.SX = field(default_factory=lambda: ca.SX(0))
    springs: dict[str, LinearSpring] = field(default_factory=dict)
    rotors: list[Rotor] = field(default_factory=list)
    elements: list[Element] = field(default_factory=list)
    one_sided: dict[str, tuple[ca.SX, str]] = field(default_factory=dict)
    measures: dict[str, ca.SX] = field(default_factory=dict)
    q_ddot: list[ca.SX] = field(default_factory=list)
    lam: list[ca.SX] = field(default_factory=list)
    accelerated: dict[str, ca.SX] = field(default_factory=dict)
    body_columns: dict[str, list[int]] = field(default_factory=dict)
    joint_columns: frozenset[int] = frozenset()
    gravity: list[ca.SX] = field(default_factory=list)
    measure_units: dict[str, str] = field(default_factory=dict)
    load_forces: dict[str, Row] = field(default_factory=dict)
    beams: dict[str, list[ModeSetRecord]] = field(default_factory=dict)
    flexible: list[str] = field(default_factory=list)
    static_residuals: list[StaticResidual] = field(default_factory=list)
    load_actions: dict[str, Sequence[ca.SX]] = field(default_factory=dict)
    load_spans: dict[str, list[float]] = field(default_factory=dict)
    loads_beyond: dict[str, Callable[[float], Sequence[ca.SX]]] = field(default_factory=dict)
    load_sizes: dict[str, ca.SX] = field(default_factory=dict)
    events: dict[str, tuple[ca.SX, dict[str, ca.SX]]] = field(default_factory=dict)
    switching: list[tuple[str, ca.SX]] = field(default_factory=list)
    kinks: dict[str, tuple[str, ca.SX]] = field(default_factory=dict)
    sides: dict[str, ca.SX] = field(default_factory=dict)
    held: dict[tuple[str, int], str] = field(default_factory=dict)
    picture: Picture = field(default_factory=lambda: Picture([], {}, {}))
    u: dict[str, ca.SX] = field(default_factory=dict)
    inputs: list[InputRecord] = field(default_factory=list)
    inertia_forces: InertiaForces | None = None
    force_changes: ForceChanges | None = None
    loop_rates: Mapping[str, RowRates] = field(default_factory=dict)
    loop_changes: LoopChanges | None = None
    free_joints: FreeJointAccelerations | None = None
    placed_columns: frozenset[int] = frozenset()
    felt_columns: frozenset[int] = frozenset()
    rotation_vectors: list[RotationVector] = field(default_factory=list)
    masses: Callable[[], list[Row]] = list
    velocity_forces: Callable[[], list[ca.SX]] = list

    @cached_property
    def M(self) -> list[Row]:
        """The mass matrix [kg, kg m, kg m^2], rows by column."""
        return self.masses()

    @cached_property
    def Q_v(self) -> list[ca.SX]:
        """Forces quadratic in velocities, by column."""
        return self.velocity_forces()

    @property
    def C_q(self) -> ca.SX:
        """Constraint Jacobian, rows x coordinates."""
        return to_matrix([row.C_q for row in self.constraints], range(len(self.names)))

    @cached_property
    def names(self) -> list[str]:
        """Names of the coordinates."""
        return [coordinate.name for coordinate in self.coordinates]

    @cached_property
    def elastic_columns(self) -> frozenset[int]:
        """Columns of modal coordinates."""
        return frozenset(column for column, coordinate in enumerate(self.coordinates) if coordinate.elastic)

    @cached_property
    def states(self) -> dict[str, int]:
        """Column of each controller state, by its name: the state is the rate of that coordinate."""
        return {entry.owner: k for k, entry in enumerate(self.coordinates) if entry.kind == "state"}

    @cached_property
    def Q_star(self) -> list[ca.SX]:
        """Q* = Q_F + Q_v - K q of (28), (32) and (33), per coordinate."""
        springs = matrix_times(self.K, dict(enumerate(self.q)))
        return [
            add(sub(Q_v, springs.get(row, ZERO)), Q_F)
            for row, (Q_v, Q_F) in enumerate(zip(self.Q_v, self.Q_F, strict=True))
        ]

    def force(self, accelerations: Row) -> list[ca.SX]:
        """Q* - M x'' for accelerations x'' by column."""
        if self.inertia_forces is None:
            inertia = matrix_times(self.M, accelerations)
            return [sub(value, inertia.get(column, ZERO)) for column, value in enumerate(self.Q_star)]
        inertia = self.inertia_forces(accelerations)
        return [sub(value, inertia.get(column, ZERO)) for column, value in enumerate(self.outer_forces)]

    @cached_property
    def outer_forces(self) -> list[ca.SX]:
        """Q_F - K q: what a tree of frames moves by but for its inertia and weight."""
        springs = matrix_times(self.K, dict(enumerate(self.q)))
        return [sub(value, springs.get(column, ZERO)) for column, value in enumerate(self.Q_F)]

    def loads_on(self, body: str) -> list[str]:
        """Names of the loads and frictions that act on a body."""
        own = {column for column in self.body_columns[body] if self.coordinates[column].owner == body}
        return [name for name, row in self.load_forces.items() if own & row.keys()]

    def frame_columns(self, body: str) -> list[int]:
        """Columns of R_o and the orientation of a body's frame."""
        own = [(column, self.coordinates[column]) for column in self.body_columns[body]]
        return [column for column, entry in own if entry.owner == body and not entry.elastic]

    @property
    def signals(self) -> dict[str, ca.SX]:
        """Arguments that come from outside: t, u where there are inputs, sides of jumps, the charts of orientations."""
        given = {"t": self.t, "u": ca.vertcat(*self.u.values())} if self.u else {"t": self.t}
        charts = [entry for rotation in self.rotation_vectors for entry in rotation.chart]
        given |= {"side": ca.vertcat(*self.sides.values())} if self.sides else {}
        return {**given, "chart": ca.vertcat(*charts)} if charts else given

    @property
    def state(self) -> dict[str, ca.SX]:
        """Arguments of what depends on all coordinates and their rates."""
        return {"q": ca.vertcat(*self.q), "q_dot": ca.vertcat(*self.q_dot), **self.signals}

    @cached_property
    def turn_columns(self) -> frozenset[int]:
        """Columns of the rotation vectors of `rotation_vectors`."""
        return frozenset(column for rotation in self.rotation_vectors for column in rotation.columns)

    @property
    def input_defaults(self) -> list[float]:
        """u where nothing else is given: defaults, rates zero."""
        at = {entry.name: entry.default for entry in self.inputs}
        return [at.get(name, 0.0) for name in self.u]

    @property
    def joints(self) -> list[str]:
        """Names of the joints, in the order of their first constraint row."""
        return list(dict.fromkeys(row.joint for row in self.constraints if row.joint))

    def kinetic(self) -> ca.SX:
        """1/2 q_dot^T M q_dot, states left out."""
        moving = [k for k in range(len(self.q)) if k not in self.states.values()]
        momenta = [total(mul(value, self.q_dot[column]) for column, value in self.M[row].items()) for row in moving]
        return dot([self.q_dot[row] for row in moving], momenta) / 2


def blank_equations(scene: SceneRecord) -> Equations:
    """Equations of a scene's coordinates and inputs with nothing in them yet."""
    coordinates = scene.coordinate_records()
    q = [ca.SX.sym(coordinate.name) for coordinate in coordinates]
    q_dot = [ca.SX.sym(f"{coordinate.name}_dot") for coordinate in coordinates]
    n = len(coordinates)
    return Equations(
        coordinates,
        q,
        q_dot,
        ca.SX.sym("t"),
        [{} for _ in q],
        [ZERO] * n,
        [],
        u=input_symbols(scene),
        inputs=input_records(scene),
    )


def matrix_times(rows: list[Row], vector: Mapping[int, ca.SX]) -> Row:
    """rows @ vector for a sparse vector, as a sparse vector."""
    result: Row = {}
    for row, entries in enumerate(rows):
        for column, value in entries.items():
            if column in vector:
                add_to(result, row, mul(value, vector[column]))
    return result

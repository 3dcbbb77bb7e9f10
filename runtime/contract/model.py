"""A model in memory: names, partition, parameters, inputs as functions of time, and its CasADi Functions (built on
demand).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from functools import cached_property
from threading import Lock
from typing import Any, NamedTuple, Self, TypeVar

import casadi as ca
import numpy as np

from runtime.contract.arguments import BY_NAME, arguments
from runtime.contract.cards import Html, card, fold, table
from runtime.contract.errors import ModelError, is_finite_number, shown_value
from runtime.contract.orientations import Places, places_of
from runtime.contract.records import (
    Bound,
    BoundedQuantity,
    Coordinate,
    Description,
    EventRecord,
    Group,
    InputRecord,
    Parameter,
)
from runtime.contract.signals import Signals, as_called, traced
from runtime.contract.tape import arithmetic

# Values of parameters and inputs given by name, checked.

WORDS = {"positive": "positive", "not negative": "at least zero"}


def changed_vector(model: str, parameters: Sequence[Parameter], changes: Mapping[str, float]) -> np.ndarray:
    """(n_p,) defaults of the parameters, some changed by name. Raises ModelError for a name or value that cannot be."""
    p = np.array([parameter.default for parameter in parameters])
    index = {parameter.name: k for k, parameter in enumerate(parameters)}
    for name, value in changes.items():
        if name not in index:
            known = ", ".join(q.name for q in parameters if q.kind != "data")
            zero = (
                "; a number that is zero in the scene is left out of the code: to keep it, declare it in "
                "[parameters] with default 0 and write its name there"
                if "." in name
                else ""
            )
            raise ModelError(f"model {model} has no parameter {name!r}; it has {known}{zero}")
        p[index[name]] = checked_value(parameters[index[name]], value)
    return p


def require_bounds(quantities: Sequence[BoundedQuantity], values: np.ndarray) -> None:
    """Raises ModelError if an expression of the scene has lost the sign that its use asks for; values (k,)."""
    for quantity, value in zip(quantities, values, strict=True):
        if not _within(quantity.bound, value):
            raise ModelError(
                f"{quantity.item} = {quantity.expression!r} would be {value:.6g} but must be "
                f"{WORDS[quantity.bound]}: choose other values of its parameters"
            )


def checked_value(parameter: Parameter, value: float) -> float:
    """The value as a float. Raises ModelError if it is not finite or has the wrong sign."""
    what = "input" if parameter.kind == "input" else "parameter"
    if not is_finite_number(value):
        raise ModelError(f"{what} {parameter.name!r} must be a finite number, not {shown_value(value)}")
    if not _within(parameter.bound, float(value)):
        raise ModelError(f"{what} {parameter.name!r} must be {WORDS[parameter.bound]}, not {value}")
    return float(value)


def checked_inputs(
    model: str,
    inputs: Sequence[InputRecord],
    held: Sequence[Parameter],
    values: Mapping[str, float | Callable[..., Any]],
) -> tuple[dict[str, float], dict[str, ca.Function]]:
    """(numbers, functions of time) by name. Raises ModelError or ArgumentError for what cannot be an input."""
    numbers: dict[str, float] = {}
    functions: dict[str, ca.Function] = {}
    records = {entry.name: entry for entry in inputs if not entry.hidden}
    hidden = {entry.name for entry in inputs if entry.hidden}
    slots = {parameter.name: parameter for parameter in held if parameter.name not in hidden}
    for name, value in values.items():
        if name not in slots or (callable(value) and name not in records):
            raise ModelError(f"model {model} has no input {name!r}; it has {', '.join(records) or 'none'}")
        if not callable(value):
            numbers[name] = checked_value(slots[name], value)
        elif records[name].filter:
            raise ModelError(
                f"input {name!r} has a filter, which takes constants and held values: declare it with rates = true, "
                "the rate and acceleration of a function are exact"
            )
        else:
            functions[name] = traced(value, name)
    return numbers, functions


def _within(bound: Bound, value: float) -> bool:
    """Has a value the sign that a bound asks for?"""
    return bool({"any": True, "positive": value > 0, "not negative": value >= 0}[bound])


# The parameters of a model as a list that prints those which somebody would change.


class ParameterList(list[Parameter]):
    """In the order of p; printed without the numbers of shapes, tables and meshes."""

    def __repr__(self) -> str:
        own = [one for one in self if one.kind != "data" and not one.array]
        width = max((len(one.name) for one in own), default=0)
        lines = [f"{one.name:<{width}}  {one.default:<12.9g} {one.unit:<8} {one.meaning}".rstrip() for one in own]
        hidden = len(self) - len(own)
        return "\n".join(
            [*lines, *([f"and {hidden} numbers of shapes, tables and meshes (kind data)"] if hidden else [])]
        )


def of_parameters(kernel: ca.Function, constants: ca.Function) -> ca.Function:
    """A Function of the parameters p instead of c; one that takes p is itself."""
    if "p" in kernel.name_in():
        return kernel
    names = [argument for argument in kernel.name_in() if argument != "c"]
    inputs = {argument: ca.SX.sym(argument, *kernel.size_in(argument)) for argument in names}
    p = ca.SX.sym("p", constants.numel_in(0))
    call: dict[str, Any] = dict(inputs)
    if "c" in kernel.name_in():
        call["c"] = constants(p)
    outputs = kernel(**call)
    values = [outputs[key] for key in kernel.name_out()]
    return ca.Function(kernel.name(), [*inputs.values(), p], values, [*names, "p"], kernel.name_out())


# A model in a notebook: coordinates, partition, joints, measures, constraints, operations, parameters.


def model_card(described: Description, sketch: str = "") -> Html:
    """HTML of a model's description; sketch: a drawing of it, as SVG."""
    elastic = sum(entry.elastic for entry in described.coordinates)
    about = (
        f"{described.name}: {len(described.coordinates)} coordinates, {elastic} elastic, "
        f"{len(described.q_i)} independent, {len(described.constraints)} constraints"
    )
    rows = [("bodies", ", ".join(f"{body.name} ({body.type})" for body in described.bodies))]
    rows += [("joints", ", ".join(f"{joint.name} ({joint.type})" for joint in described.joints))]
    rows += [("loads", ", ".join(f"{load.name} ({load.type})" for load in described.loads))]
    rows += [("measures", ", ".join(f"{entry.name} [{entry.unit}]" for entry in described.measures))]
    rows += [
        (f"group {group.name}", ", ".join(described.q_i[k] for k in group.positions)) for group in described.groups
    ]
    rows += [("solved by Newton", ", ".join(described.loop_unknowns))]
    operations = [(f.name, str(f.operations), f.meaning) for f in described.functions]
    shown = [entry for entry in described.parameters if entry.kind != "data"]
    parameters = [(entry.name, f"{entry.default:.6g}", entry.unit, entry.meaning) for entry in shown]
    return card(
        described.title or described.name,
        about,
        sketch,
        table([row for row in rows if row[1]]),
        fold(f"{len(parameters)} parameters", table(parameters, ("name", "default", "unit", "meaning"))),
        fold(f"{len(operations)} functions", table(operations, ("function", "operations", "what it gives"))),
    )


T = TypeVar("T")


class DrawnPoint(NamedTuple):
    """A point of a body: marker or station of a beam (name ""), place (3,) [m] in the axes of the body while unbent.

    shapes, turns (3, modes): its displacement and rotation per unit of the body's modal coordinates.
    """

    body: str
    name: str
    place: np.ndarray
    shapes: np.ndarray
    turns: np.ndarray


LATELY = 8  # numbers of which a model keeps what was made of them
_LOCK = Lock()  # threads may run one model at once


@dataclass(frozen=True, repr=False)
class EmittedModel:
    """What a generator emits: records, and CasADi functions built on demand. Users have `runtime.model.Model`.

    description: all records; builders: function name -> what builds it. initial_q, initial_q_dot (n,) [m, rad, 1; per
    s]: the consistent initial state; initial_changes: {name: (given, used)} where the scene's start was corrected;
    assembly: remarks of closing its loops. digest: SHA-256 of the manifest; scene_toml: the scene, for the generator;
    folder: where it was loaded from, by which it is pickled. input_values, sources: see `with_inputs`; driven_by: hash
    of what else drives a run. steppers, schemes: see runtime.schemes.stepper and catalogue.
    """

    description: Description
    initial_q: np.ndarray
    initial_q_dot: np.ndarray
    builders: Mapping[str, Callable[[], ca.Function]]
    initial_changes: Mapping[str, tuple[float, float]] = field(default_factory=dict)
    assembly: tuple[str, ...] = ()
    digest: str = ""
    scene_toml: str = ""
    folder: str = ""
    input_values: Mapping[str, float] = field(default_factory=dict)
    sources: Mapping[str, ca.Function] = field(default_factory=dict)
    driven_by: str = ""
    _kernels: dict[str, ca.Function] = field(default_factory=dict, repr=False)
    _derived: dict[str, Any] = field(default_factory=dict, repr=False)
    _operations: dict[str, int] = field(default_factory=dict, repr=False)
    _zero_outputs: dict[str, frozenset[str]] = field(default_factory=dict, repr=False)
    steppers: dict[tuple[Any, ...], Any] = field(default_factory=dict, repr=False, compare=False)
    schemes: dict[tuple[Any, ...], Any] = field(default_factory=dict, repr=False, compare=False)

    def __post_init__(self) -> None:
        for name in ("initial_q", "initial_q_dot"):
            own = np.array(getattr(self, name))
            own.flags.writeable = False  # a run that starts elsewhere says so by `initial=`
            object.__setattr__(self, name, own)

    @property
    def name(self) -> str:
        """Name of the scene."""
        return self.description.name

    @property
    def title(self) -> str:
        """Title of the scene, for pictures."""
        return self.description.title

    @cached_property
    def coordinates(self) -> list[str]:
        """Names of all coordinates q, in order; `description.coordinates` has kinds and units."""
        return [coordinate.name for coordinate in self.description.coordinates]

    @cached_property
    def elastic(self) -> list[str]:
        """Names of the modal coordinates."""
        return [coordinate.name for coordinate in self.description.coordinates if coordinate.elastic]

    @cached_property
    def states(self) -> list[int]:
        """Positions in q_i of the coordinates whose rates are states of controllers."""
        states = {entry.name for entry in self.description.coordinates if entry.kind == "state"}
        return [k for k, name in enumerate(self.q_i) if name in states]

    @property
    def q_i(self) -> list[str]:
        """Names of the independent coordinates."""
        return self.description.q_i

    @property
    def q_d(self) -> list[str]:
        """Names of the dependent coordinates."""
        return self.description.q_d

    @property
    def loop_unknowns(self) -> list[str]:
        """Names of the dependent coordinates that Newton's method finds to close loops."""
        return self.description.loop_unknowns

    @property
    def groups(self) -> list[Group]:
        """Groups of the partition, slow to fast."""
        return self.description.groups

    @cached_property
    def constraints(self) -> list[str]:
        """Labels of the constraint rows."""
        return [row.label for row in self.description.constraints]

    @cached_property
    def joints(self) -> list[str]:
        """Names of the joints that have constraint rows."""
        return list(dict.fromkeys(row.joint for row in self.description.constraints if row.joint))

    @cached_property
    def measures(self) -> list[str]:
        """Names of the measures and of their rates."""
        return [measure.name for measure in self.description.measures]

    @property
    def state_measures(self) -> list[str]:
        """The first of these: those that follow from coordinates and rates, and no accelerations."""
        return [measure.name for measure in self.description.measures if not measure.accelerated]

    @property
    def acceleration_measures(self) -> list[str]:
        """The others, which follow from accelerations and joint forces: stresses with normal forces by equilibrium."""
        return [measure.name for measure in self.description.measures if measure.accelerated]

    @cached_property
    def drawing(self) -> dict[str, Any]:
        """What views draw, as plain values: the record `drawing` with the joints and loads and their markers."""
        described = self.description
        return {
            **asdict(described.drawing),
            "joints": [
                {key: getattr(joint, key) for key in ("name", "type", "marker_a", "marker_b", "drawing")}
                for joint in described.joints
            ],
            "loads": [{"name": load.name, "type": load.type, **load.markers} for load in described.loads],
        }

    @cached_property
    def parameters(self) -> list[Parameter]:
        """Parameters with default, unit and meaning, in the order of p; behind them numbers of inputs (kind `input`).

        Its print counts numbers of shapes, tables and meshes (kind `data`).
        """
        return ParameterList([*self.description.parameters, *self.signals.parameters])

    @cached_property
    def inputs(self) -> list[str]:
        """Names of the inputs: values that come from outside during a run."""
        return [entry.name for entry in self.description.inputs if not entry.hidden]

    @cached_property
    def input_entries(self) -> list[str]:
        """Names of the entries of u: the inputs, rates behind those that have them, modes of friction at the end."""
        return self.signals.entries

    @cached_property
    def element_modes(self) -> np.ndarray:
        """(n_m,) positions of the modes of elements among the numbers of inputs."""
        names = self.signals.names
        return np.array([names.index(one.mode) for one in self.mode_events], dtype=int)

    @cached_property
    def mode_events(self) -> list[EventRecord]:
        """Of friction and rigid stops, in the order of `element_modes`: the last of all events."""
        return [one for one in self.description.events if one.mode]

    @cached_property
    def signals(self) -> Signals:
        """The inputs as functions of time; see runtime.contract.signals."""
        return Signals(self.description.inputs, self.sources)

    @arguments(values=BY_NAME)
    def with_inputs(self, values: Mapping[str, float | Callable[[Any], Any]]) -> Self:
        """Make a copy whose inputs have other values.

        Parameters
        ----------
        values : mapping of str to float or callable
            By name: constants [SI units], or functions of time, which are called with a symbolic t.

        Returns
        -------
        Model
            The copy; this one stays as it is.

        Raises
        ------
        ModelError, ArgumentError
            For an unknown input or a value that cannot be used.
        """
        numbers, functions = checked_inputs(self.name, self.description.inputs, self.signals.parameters, values)
        kept = {name: source for name, source in self.sources.items() if name not in numbers}
        return replace(
            self,
            input_values={**self.input_values, **numbers},
            sources={**kept, **functions},
            _kernels={},
            _derived={},
            _operations={},
            _zero_outputs={},
            steppers={},
            schemes={},
        )

    @property
    def redundant(self) -> list[str]:
        """Labels of the redundant constraint rows, which the others imply."""
        return self.description.redundant

    @property
    def simulation(self) -> Mapping[str, Any]:
        """Default arguments of runs, from the scene."""
        return self.description.simulation

    @property
    def operations(self) -> dict[str, int]:
        """{function: arithmetic operations}; of functions derived on demand only those asked for until now."""
        emitted = {spec.name: spec.operations for spec in self.description.functions}
        return {name: self.operations_of(name) for name in self._kernels} | emitted

    def operations_of(self, name: str) -> int:
        """Count the arithmetic operations of a function, which is built where the description does not say.

        Parameters
        ----------
        name : str
            Name of the function, one of `builders`.

        Returns
        -------
        int
            Operations of an evaluation.

        Raises
        ------
        ModelError
            For a function that the model does not have.
        """
        if name not in self._operations:
            emitted = (spec.operations for spec in self.description.functions if spec.name == name)
            counted = next(emitted, None)
            self._operations[name] = arithmetic(self.kernel(name)) if counted is None else counted
        return self._operations[name]

    def coordinate(self, name: str) -> Coordinate:
        """Look up the record of a coordinate.

        Parameters
        ----------
        name : str
            One of `coordinates`.

        Returns
        -------
        Coordinate
            Kind, unit, owner.

        Raises
        ------
        ModelError
            For an unknown name.
        """
        if name not in self.coordinates:
            raise ModelError(f"model {self.name} has no coordinate {name!r}; it has {', '.join(self.coordinates)}")
        return self.description.coordinates[self.coordinates.index(name)]

    def __repr__(self) -> str:
        return (
            f"<Model {self.name}: {len(self.coordinates)} coordinates, {len(self.q_i)} independent, "
            f"{len(self.constraints)} constraints>"
        )

    def kernel(self, name: str) -> ca.Function:
        """Build the Function `name` as runs call it, with c as its last argument.

        Parameters
        ----------
        name : str
            Name of the function, one of `builders`.

        Returns
        -------
        casadi.Function
            The same at each call.

        Raises
        ------
        ModelError
            For a function that the model does not have.
        """
        if name not in self._kernels:
            if name not in self.builders:
                driven = "Every coordinate is driven: there are no equations of motion"
                raise ModelError(
                    f"model {self.name} has no function {name!r}; it has {', '.join(self.builders)}. "
                    + ("Regenerate the scene with that function" if self.q_i else driven)
                )
            counts = len(self.description.held), len(self.description.orientations)
            self._kernels[name] = as_called(self.builders[name](), *counts, self.signals, self.emitted_c_size)
        return self._kernels[name]

    def derived(self, name: str, build: Callable[[], T]) -> T:
        """Make something of the emitted functions by `build`, once for a model.

        Parameters
        ----------
        name : str
            What it is kept by.
        build : callable
            Without arguments.

        Returns
        -------
        object
            What `build` gave.
        """
        if name not in self._derived:
            self._derived[name] = build()
        found: T = self._derived[name]
        return found

    def of_numbers(self, name: str, numbers: tuple[Any, ...], build: Callable[[], T]) -> T:
        """Make something of numbers (parameters, a state) by `build`; kept, and not to be changed, for the latest.

        Parameters
        ----------
        name : str
            What it is kept by.
        numbers : tuple
            What it depends on.
        build : callable
            Without arguments.

        Returns
        -------
        object
            What `build` gave.
        """
        known: dict[tuple[Any, ...], T] = self.derived(f"of numbers: {name}", dict)
        if numbers not in known:
            found = build()
            with _LOCK:
                known[numbers] = found
                while len(known) > LATELY:
                    del known[next(iter(known))]
            return found
        return known[numbers]

    def has(self, name: str) -> bool:
        """Say whether a function was generated.

        Parameters
        ----------
        name : str
            Its name.

        Returns
        -------
        bool
            A tree has no closure iterations, a scene without measures no measures.
        """
        return name in self.builders

    def function(self, name: str) -> ca.Function:
        """Build the Function `name` of the parameters p, for other CasADi expressions and derivatives.

        Parameters
        ----------
        name : str
            Name of the function, one of `builders`.

        Returns
        -------
        casadi.Function
            Its last argument is p (n_p,), as of `description.parameters`; before it comes u, in the order of
            `input_entries`, where there are inputs that it uses.

        Raises
        ------
        ModelError
            For a function that the model does not have.
        """
        self.kernel(name)  # refuses a function that was not generated
        counts, size = (len(self.description.held), len(self.description.orientations)), self.emitted_c_size
        own, constants = (as_called(self.builders[key](), *counts, Signals([]), size) for key in (name, "constants"))
        return of_parameters(own, constants)

    def evaluate(self, name: str, **values: Any) -> dict[str, Any]:
        """Evaluate the Function `name` at numbers or CasADi expressions.

        Parameters
        ----------
        name : str
            Name of the function, one of `builders`.
        **values
            Arguments by name, `c` among them; those that it does not take are ignored.

        Returns
        -------
        dict
            Its outputs by name.

        Raises
        ------
        ModelError
            For a function that the model does not have, and for an argument that is missing.
        """
        kernel = self.kernel(name)
        missing = [argument for argument in kernel.name_in() if argument not in values]
        if missing:
            raise ModelError(f"function {name} of model {self.name} needs {', '.join(missing)}: give it by name")
        return dict(kernel.call({argument: values[argument] for argument in kernel.name_in()}))

    @cached_property
    def conservative(self) -> bool:
        """Do neither loads nor prescribed motions do work on the mechanism? False where that is not known."""
        outputs = [("energy", "power_applied")] + ([("constraints", "C_t")] if self.constraints else [])
        return all(self.has(function) and self.structurally_zero(function, output) for function, output in outputs)

    def structurally_zero(self, name: str, output: str) -> bool:
        """Say whether an output of a kernel is zero whatever its arguments are.

        Parameters
        ----------
        name : str
            Name of the function, one of `builders`.
        output : str
            Name of the output.

        Returns
        -------
        bool
            By its sparsity.

        Raises
        ------
        ModelError
            For a function that the model does not have.
        """
        if name not in self._zero_outputs:
            kernel = self.kernel(name)
            values = kernel.call([ca.SX.sym(argument, *kernel.size_in(argument)) for argument in kernel.name_in()])
            found = zip(kernel.name_out(), values, strict=True)
            self._zero_outputs[name] = frozenset(own for own, value in found if value.is_zero())
        return output in self._zero_outputs[name]

    @cached_property
    def emitted_c_size(self) -> int:
        """Length of the c of the emitted code."""
        return int(self.builders["constants"]().size1_out(0))

    @cached_property
    def c_size(self) -> int:
        """Length of c, the numbers of inputs at its end included."""
        return int(self.kernel("constants").size1_out(0))

    @cached_property
    def places(self) -> Places:
        """Where q_i and q_d stand in q; see runtime.contract.coordinates."""
        described = self.description
        return places_of(self.coordinates, self.q_i, self.q_d, self.loop_unknowns, described.orientations)

    @cached_property
    def independent_columns(self) -> np.ndarray:
        """Columns of q_i in q, (n_i,). Raises ValueError for turns, which have none: see `places`."""
        return np.array([self.coordinates.index(name) for name in self.q_i], dtype=int)

    @cached_property
    def dependent_columns(self) -> np.ndarray:
        """Columns in q of those of q_d that are coordinates: all but turns."""
        return self.places.dependent

    @cached_property
    def redundant_rows(self) -> np.ndarray:
        """Positions of the redundant rows in the constraints, (n_R,)."""
        return np.array([self.constraints.index(label) for label in self.redundant], dtype=int)

    @cached_property
    def kept_rows(self) -> np.ndarray:
        """Positions of the constraint rows that are not redundant, (n_c - n_R,)."""
        return np.setdiff1d(np.arange(len(self.constraints)), self.redundant_rows)

    @arguments()
    def parameter_vector(self, changes: Mapping[str, float] | None = None) -> np.ndarray:
        """Write the parameters as a vector, with some of them changed.

        Parameters
        ----------
        changes : mapping of str to float, optional
            New values by name [SI units].

        Returns
        -------
        (n_p,) array
            In the order of `parameters`.

        Raises
        ------
        ModelError
            For an unknown name, and a value out of its bounds.
        """
        p = changed_vector(self.name, self.parameters, {**self.input_values, **(changes or {})})
        if changes and self.description.bounded:
            require_bounds(self.description.bounded, np.asarray(self.kernel("bounded")(p)).ravel())
        return p

    def constants(self, p: np.ndarray) -> np.ndarray:
        """Compute what depends on the parameters alone.

        Parameters
        ----------
        p : (n_p,) array
            Parameters, as `parameter_vector` gives them.

        Returns
        -------
        (c_size,) array
            The argument c of kernels.

        Raises
        ------
        ModelError
            If one of them is infinite or NaN.
        """
        c = self.of_numbers("constants", (p.tobytes(),), lambda: np.asarray(self.kernel("constants")(p)).ravel())
        if not np.all(np.isfinite(c)):
            raise ModelError(f"model {self.name}: a parameter makes the constants infinite (division by zero?)")
        return c.copy()

    def geometry(self, p: np.ndarray) -> dict[str, np.ndarray]:
        """Find the places and shapes of the drawn points in their bodies.

        Parameters
        ----------
        p : (n_p,) array
            Parameters, as `parameter_vector` gives them.

        Returns
        -------
        dict of str to array
            positions (3, N) [m], shapes and turns (3, modes of all points), in the axes of the body.
        """
        return self.of_numbers(
            "geometry",
            (p.tobytes(),),
            lambda: {name: np.asarray(value) for name, value in self.kernel("geometry")(p=p).items()},
        )

    def drawn_points(self, p: np.ndarray) -> list[DrawnPoint]:
        """List the drawn points with their places and shapes, in the order of the drawing.

        Parameters
        ----------
        p : (n_p,) array
            Parameters, as `parameter_vector` gives them.

        Returns
        -------
        list of DrawnPoint
            See there.
        """
        values, points = self.geometry(p), self.description.drawing.points
        ends = np.cumsum([point.modes for point in points])
        own = [slice(end - point.modes, end) for end, point in zip(ends, points, strict=True)]
        return [
            DrawnPoint(one.body, one.name, place, values["shapes"][:, modes], values["turns"][:, modes])
            for one, place, modes in zip(points, values["positions"].T, own, strict=True)
        ]

    def columns_of(self, body: str) -> tuple[list[int], list[int]]:
        """Find where the coordinates of a body stand in q.

        Parameters
        ----------
        body : str
            Its name.

        Returns
        -------
        tuple of list of int
            Columns of its frame, and of its modal coordinates.
        """
        own = [(k, one.elastic) for k, one in enumerate(self.description.coordinates) if one.owner == body]
        return [k for k, bent in own if not bent], [k for k, bent in own if bent]


# Who does not look for events refuses models that have them.


def refuse_events(model: EmittedModel, who: str) -> None:
    """Raises ModelError for a model with events."""
    names = [event.name for event in model.description.events]
    if names:
        raise ModelError(
            f"events {', '.join(names)} of model {model.name}",
            f"are not located by {who}",
            "use simulate with a fixed step, or remove the events",
        )


def refuse_elements(model: EmittedModel, who: str, remedy: str) -> None:
    """Raises ModelError for a model with friction that sticks or rigid stops, of which `who` does not know."""
    kinds = sorted({bool(event.side) for event in model.mode_events})
    if kinds:
        names = ", ".join(event.name for event in model.mode_events)
        does = " and ".join(("sticks and slides", "opens and closes")[stop] for stop in kinds)
        more = "; limits with a stiffness in place of a restitution are forces like others" if kinds[-1] else ""
        raise ModelError(f"{names} of model {model.name}", f"{does}, which {who}", remedy + more)


def refuse_reactions(model: EmittedModel, who: str, remedy: str) -> None:
    """Raises ModelError for a model with friction by reactions (`mu`), of which `who` does not know."""
    if model.has("elements") and "margin" in model.kernel("elements").name_out():
        names = ", ".join(event.name for event in model.mode_events if not event.side)
        raise ModelError(f"{names} of model {model.name}", f"follows from reactions by mu, which {who}", remedy)

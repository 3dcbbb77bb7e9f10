"""Many cases of a model stepped side by side from outside: for learning, sampling controllers, particle filters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from typing import Any

import numpy as np

from runtime.contract.arguments import BY_NAME, NAMES, arguments
from runtime.contract.consistent_state import InitialStateError
from runtime.contract.errors import LARGEST_NUMBER, ArgumentError, ModelError
from runtime.contract.model import EmittedModel
from runtime.contract.signals import SINCE
from runtime.running.planning import make_plan, steps_asked
from runtime.running.problem import whole_number
from runtime.running.stepping import HORIZON
from runtime.schemes.options import SchemeError
from runtime.schemes.switching.watched import may_break
from runtime.start.start_state import start_state
from runtime.studies.ensemble.account import ALONE, cause_of
from runtime.studies.ensemble.ensemble_spec import EnsembleSpec
from runtime.studies.ensemble.lane_runs import LaneRuns
from runtime.studies.ensemble.starts import CaseStarts, Starts, columns_by_name, table_of, vectors

LEAST_BLOCKS = 8  # of a thread: for fewer, threads cost more than they save


class LaneStepper:
    """Step many cases of a model side by side: inputs go in, outputs come out, as arrays over the cases.

    Parameters
    ----------
    model : Model
        The mechanism.
    cases : int
        How many.
    scheme, dt, m, options : optional
        As of `simulate`, with steps of one length dt [s]; of models with inputs a one-step scheme, such as rk4.
    parameters : mapping of str to array_like (cases,), optional
        By name an array, or one number for all cases, in SI units.
    outputs : sequence of str, optional
        What `reset` and `step` return: coordinates, rates, accelerations, measures, energies, `lam.row`, joint forces.
        None: the coordinates and rates of q_i.
    workers : int, optional
        Threads.

    Raises
    ------
    ModelError
        Where every coordinate is driven, and for models with events, stops, friction or loads that jump, whose cases
        do not go side by side: use `model.stepper` for each.
    SchemeError, ArgumentError, CompilerError
        For what cannot be used.

    Notes
    -----
    A case has the bits of `model.stepper`, whoever goes beside it. Nothing is checked on the way but what `lost` says.
    """

    @arguments(options=BY_NAME, outputs=NAMES)
    def __init__(
        self,
        model: EmittedModel,
        cases: int,
        *,
        scheme: str | None = None,
        dt: float | None = None,
        m: list[int] | None = None,
        options: Mapping[str, Any] | None = None,
        parameters: Any = None,
        outputs: Sequence[str] | None = None,
        workers: int = 1,
    ) -> None:
        if not model.q_i:
            raise ModelError(f"every coordinate of model {model.name} is driven: there is nothing to step")
        self.cases, self._workers = _at_least_one("cases", cases), _at_least_one("workers", workers)
        name, length = steps_asked(model, scheme, dt, m, options)
        end = HORIZON * length if isinstance(length, int | float) and length > 0 else None
        plan = make_plan(model, end, length, m, name, None, options, 0.0, bounded=True)
        plan.scheme.of_one_length("lanes")
        if plan.scheme.multistep and model.inputs:
            problem = f"{plan.name} remembers earlier steps, which inputs that change spoil"
            raise SchemeError("scheme", problem, "take a one-step scheme, such as rk4")
        if may_break(plan.scheme) or SINCE in model.signals.names or model.sources:
            problem = "has events, stops, friction, or loads and inputs that change by themselves"
            raise ModelError(f"model {model.name} {problem}: its cases go one by one, each by model.stepper()")
        own = columns_by_name("parameters", parameters)
        names, table = _table(model, own, {}, self.cases)
        asked = [*model.q_i, *(f"{one}_dot" for one in model.q_i)] if outputs is None else outputs
        self.model, self.dt, self.scheme = model, plan.grid.dt_L, plan.scheme
        self._spec = EnsembleSpec.ask(model, (names[0], []), plan, None, asked, None)
        self._parameters = table
        self.outputs: list[str] = list(self._spec.outputs)
        self._lanes = LaneRuns(self._spec)
        self._inputs = {one: model.signals.names.index(one) for one in model.inputs}
        self._blocks = self._begun(table, [], None)

    @arguments()
    def reset(
        self, initial: Any = None, which: Any = None, *, parameters: Any = None, start: str | None = None
    ) -> np.ndarray:
        """Begin cases anew, at t = 0 and with inputs as the parameters say.

        Parameters
        ----------
        initial : mapping of str to array_like (n,), optional
            Coordinates [m, rad] and rates (`<coordinate>_dot`) by name, an array or one number for all n cases.
        which : array_like of bool (cases,) or of int (n,), optional
            The cases; None: all.
        parameters : mapping of str to array_like (n,), optional
            Other values of the parameters that were given to the stepper.
        start : str, optional
            As of `simulate`.

        Returns
        -------
        ndarray (cases, outputs)
            Of all cases.

        Raises
        ------
        InitialStateError
            For states that do not close the loops; nothing is changed then.
        ArgumentError, ModelError
            For unknown names and wrong shapes.
        """
        chosen = self._chosen(which)
        varied = self._varied(parameters, chosen)
        if not len(chosen):
            return self.values
        names, table = _table(self.model, {}, columns_by_name("initial", initial), len(chosen))
        fresh = self._begun(np.hstack([varied, table]), names[1], start)
        self._parameters[chosen] = varied
        width, places = self._lanes.programs.width, np.arange(len(chosen))
        self._blocks[chosen // width, :, chosen % width] = fresh[places // width, :, places % width]
        return self.values

    @arguments()
    def step(self, u: Any = None, n: int = 1) -> np.ndarray:
        """Make n major steps with inputs held.

        Parameters
        ----------
        u : mapping of str to array_like (cases,), or array_like (cases, inputs), optional
            Inputs by name, an array or one number for all cases; or columns in the order of `model.inputs`. None: as
            they are.
        n : int
            How many steps.

        Returns
        -------
        ndarray (cases, outputs)
            `outputs` after the steps.

        Raises
        ------
        ArgumentError
            For wrong inputs or numbers; nothing is stepped then.
        """
        steps = whole_number(n)
        if steps is None or steps < 0:
            raise ArgumentError("n", f"is {n!r}", "give a whole number of steps")
        if u is not None:
            self._hold(u)
        self._in_threads(steps)
        return self.values

    @property
    def values(self) -> np.ndarray:
        """(cases, outputs) of the present states."""
        lanes = self._lanes
        lanes.programs.observe.run(self._blocks, 0, 0, 1)
        return lanes.values(self._blocks, self.cases, "outputs")

    @property
    def time(self) -> np.ndarray:
        """(cases,) since each was begun [s]."""
        return self._lanes.values(self._blocks, self.cases, "scheme")[:, 1] * self.dt

    @property
    def status(self) -> np.ndarray:
        """(cases,) "completed" while all is well; else the first that went wrong, by the names of statuses.

        Where a case came near a singular position: `branch_lost`.
        """
        found = cause_of(self._lanes.values(self._blocks, self.cases, "causes")[:, 0])
        found[found == ALONE] = "branch_lost"
        return found

    @property
    def lost(self) -> np.ndarray:
        """(cases,) bool: those whose numbers can be relied on no more; `reset` them."""
        return self._lanes.values(self._blocks, self.cases, "causes")[:, 0] > 0

    def _in_threads(self, steps: int) -> None:
        parts = min(self._workers, max(1, len(self._blocks) // LEAST_BLOCKS))
        if parts == 1:
            self._lanes.advance(self._blocks, steps)
            return
        with ThreadPoolExecutor(parts, thread_name_prefix="symgen lanes") as pool:
            list(pool.map(lambda piece: self._lanes.advance(piece, steps), np.array_split(self._blocks, parts)))

    def _hold(self, u: Any) -> None:
        """From now on these inputs."""
        columns = self._input_columns(u)
        rows = self._lanes.programs.rows_of("scheme").start + self.scheme.layout.slice("inputs").start
        width = self._lanes.programs.width
        for name, values in columns.items():
            lanes = values[np.minimum(np.arange(len(self._blocks) * width), self.cases - 1)]
            self._blocks[:, rows + self._inputs[name], :] = lanes.reshape(-1, width)

    def _input_columns(self, u: Any) -> dict[str, np.ndarray]:
        """{input: (cases,)}. Raises ArgumentError, ModelError."""
        known = list(self._inputs)
        if not hasattr(u, "items"):
            table = np.asarray(u, dtype=float)
            if table.shape != (self.cases, len(known)):
                wanted = f"({self.cases}, {len(known)}), a column each of {', '.join(known) or 'no inputs'}"
                raise ArgumentError("u", f"has shape {table.shape}", f"give {wanted}, or a mapping")
            u = dict(zip(known, table.T, strict=True))
        found = columns_by_name("u", u)
        for name, values in found.items():
            if name not in self._inputs:
                raise ModelError(f"model {self.model.name} has no input {name!r}; it has {', '.join(known) or 'none'}")
            if values.shape not in ((), (self.cases,)):
                raise ArgumentError(name, f"has shape {values.shape}", f"give one value a case, ({self.cases},)")
            if not (np.abs(values) <= LARGEST_NUMBER).all():
                raise ArgumentError(name, "has values that are not finite", "give finite numbers")
            found[name] = np.broadcast_to(values, self.cases)
        return found

    def _chosen(self, which: Any) -> np.ndarray:
        """(n,) positions of cases. Raises ArgumentError."""
        if which is None:
            return np.arange(self.cases)
        chosen = np.asarray(which)
        if chosen.dtype == bool and chosen.shape == (self.cases,):
            return np.flatnonzero(chosen)
        if chosen.ndim == 1 and chosen.dtype.kind in "iu" and (chosen < self.cases).all() and (chosen >= 0).all():
            if len(set(chosen.tolist())) == len(chosen):
                return chosen.astype(int)
        remedy = f"give a bool for each of the {self.cases} cases, or different positions of cases"
        raise ArgumentError("which", "names no cases", remedy)

    def _varied(self, parameters: Any, chosen: np.ndarray) -> np.ndarray:
        """(n, parameters) of these cases. Raises ArgumentError."""
        varied: np.ndarray = self._parameters[chosen].copy()
        for name, values in columns_by_name("parameters", parameters).items():
            if name not in self._spec.parameters:
                given = ", ".join(self._spec.parameters) or "none"
                problem = f"is none of those that vary: {given}"
                raise ArgumentError(name, problem, "name it when the lanes are made")
            if values.shape not in ((), (len(chosen),)):
                raise ArgumentError(name, f"has shape {values.shape}", f"give one value a case, ({len(chosen)},)")
            varied[:, self._spec.parameters.index(name)] = values
        if parameters:
            _table(self.model, dict(zip(self._spec.parameters, varied.T, strict=True)), {}, len(chosen))
        return varied

    def _begun(self, table: np.ndarray, initial: list[str], start: str | None) -> np.ndarray:
        """Blocks of cases at their starts; table (n, parameters and initial values). Raises InitialStateError."""
        spec = replace(self._spec, initial=initial, start=start or "")
        lanes = self._lanes if not start else LaneRuns(spec)
        starts = CaseStarts(spec).of(table)
        if starts.impossible.any():
            self._say_why(spec, table, int(np.argmax(starts.impossible)))
        blocks = lanes.started(starts)
        alone = starts.close & ~(lanes.values(blocks, len(table), "fits")[:, 0] > 0)
        if "settled" in lanes.programs.row.sizes:
            alone |= starts.settle & ~(lanes.values(blocks, len(table), "settled")[:, 0] > 0)
        if alone.any():
            blocks = lanes.started(self._by_themselves(spec, starts, table, alone))
        return blocks

    def _by_themselves(self, spec: EnsembleSpec, starts: Starts, table: np.ndarray, alone: np.ndarray) -> Starts:
        """Starts that lanes do not find, as a stepper by itself finds them. Raises InitialStateError."""
        model, count = self.model, len(spec.parameters)
        found = replace(starts, close=starts.close & ~alone, settle=starts.settle & ~alone)
        for case in np.flatnonzero(alone):
            p = vectors(model, spec.parameters, table[case : case + 1])[0]
            given = dict(zip(spec.initial, table[case, count:].tolist(), strict=True)) or None
            state = start_state(model, p, model.constants(p), 0.0, given, spec.start or None)
            found.q[case], found.q_dot[case] = state.q, state.q_dot
            places = [model.coordinates.index(name) for name in model.q_i]
            found.q_i[case], found.q_i_dot[case] = state.q[places], state.q_dot[places]
            found.q_d[case] = state.q[[model.coordinates.index(name) for name in model.q_d]]
        return found

    def _say_why(self, spec: EnsembleSpec, table: np.ndarray, case: int) -> None:
        """Raise what a stepper by itself would raise for this case."""
        p = vectors(self.model, spec.parameters, table[case : case + 1])[0]
        given = dict(zip(spec.initial, table[case, len(spec.parameters) :].tolist(), strict=True)) or None
        start_state(self.model, p, self.model.constants(p), 0.0, given, spec.start or None)
        raise InitialStateError(f"case {case} has no consistent start")


def _table(
    model: EmittedModel, parameters: dict[str, np.ndarray], initial: dict[str, np.ndarray], cases: int
) -> tuple[tuple[list[str], list[str]], np.ndarray]:
    """((parameters, initial values), samples (cases, names)) of so many cases. Raises ArgumentError, ModelError."""
    for group in (parameters, initial):
        for name, values in group.items():
            if values.shape not in ((), (cases,)):
                raise ArgumentError(name, f"has shape {values.shape}", f"give one value a case, ({cases},)")
            group[name] = np.broadcast_to(values, cases)
    if not (parameters or initial):
        return ([], []), np.zeros((cases, 0))
    coordinates = {f"{name}{end}" for name in model.coordinates for end in ("", "_dot")}
    for name in initial:
        if name not in coordinates:
            p = model.parameter_vector()
            start_state(model, p, model.constants(p), 0.0, {name: 0.0}, None)  # says why
    return table_of(model, parameters, initial)


def _at_least_one(name: str, value: Any) -> int:
    found = whole_number(value)
    if found is None or found < 1:
        raise ArgumentError(name, f"must be a whole number of at least 1, not {value!r}")
    return found


def lanes(
    model: EmittedModel,
    cases: int,
    *,
    scheme: str | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    parameters: Any = None,
    outputs: Sequence[str] | None = None,
    workers: int = 1,
) -> LaneStepper:
    """Make many cases of the model that are stepped side by side from outside.

    Parameters
    ----------
    model : Model
        The mechanism.
    cases : int
        How many.
    scheme, dt, m, options, parameters, outputs, workers : optional
        As of `LaneStepper`.

    Returns
    -------
    LaneStepper
        With `reset`, `step`, `values`, `time`, `lost`.

    Raises
    ------
    ModelError, SchemeError, ArgumentError, CompilerError
        For what cannot be used.
    """
    return LaneStepper(
        model, cases, scheme=scheme, dt=dt, m=m, options=options, parameters=parameters, outputs=outputs,
        workers=workers,
    )  # fmt: skip

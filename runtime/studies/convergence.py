"""The error of the model itself, beside that of its steps: the same scene with one thing of its modelling turned.

Of shapes the next level, max(2 n, n + 2) of them, tells 3/4 of the error; pieces and meshes, whose error falls with the
square of their size, tell it by a run with half of them (Richardson). Scenes are made by the generator, which is found
by its entry point `symgen.refinements`.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, field, replace
from importlib.metadata import entry_points
from math import inf, isfinite, isnan, nan
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from runtime.contract.arguments import BY_NAME, CALLED, START, Kind, arguments
from runtime.contract.coordinates import Initial
from runtime.contract.errors import ArgumentError, ModelError, NoResult, SymgenError, is_finite_number
from runtime.contract.files import write_text
from runtime.contract.status import Status
from runtime.operating.equilibrium import equilibrium
from runtime.results.export import column_units
from runtime.results.run_settings import settings_of
from runtime.running.simulate import simulate
from runtime.solutions.observe import assemble_solution
from runtime.start.start_state import start_state

if TYPE_CHECKING:
    from runtime.contract.model import EmittedModel
    from runtime.running.inputs import InputValue
    from runtime.solutions.solution import Solution

ENTRY_POINTS, DERIVING = "symgen.refinements", "symgen.functions"
USUAL = ("modes", "elements", "pieces", "stiffening")  # kinds of knobs that are turned where nothing is said
HALF = "half"  # the word for pieces and meshes by half of them, which costs less than the model itself
MOST_COORDINATES = 8  # of a model without measures, of whose motion the error is told
BETWEEN_SAMPLES, MOST_SAMPLES = 10, 20_000  # samples of other runs beside one that is given, for each of its own
TOLERANCES_BESIDE = 1e-6, 1e-3  # of other runs beside one that is given, whose error is theirs within these
ONE_START = 1e-9  # of a coordinate: two starts that are one
NOISE_OF_STEPS = 10.0  # times the error of the steps: a smaller difference says nothing of the model
OUTPUT_ROUNDING = 1e-9  # of an output's size: a smaller difference is none
ERROR_FROM_DOUBLE_SIZE, ERROR_FROM_HALF_SIZE = (
    1 / 3,
    4 / 3,
)  # of errors that fall with the square of the size, by a model of half or double size
MOTION, EQUILIBRIUM = "motion", "equilibrium"
STUDY_SAMPLES = 400
READINGS: dict[str, Callable[[np.ndarray], float]] = {
    "max": lambda y: float(y.max()),
    "min": lambda y: float(y.min()),
    "peak": lambda y: float(np.abs(y).max()),
    "mean": lambda y: float(y.mean()),
    "rms": lambda y: float(np.sqrt(np.mean(y**2))),
    "end": lambda y: float(y[-1]),
}
HOWS = (MOTION, *READINGS)
Outputs = Sequence[str] | Mapping[str, str | Sequence[str]] | Callable[..., Mapping[str, float]]
OUTPUTS = Kind(
    lambda value: callable(value) or (isinstance(value, Sequence | Mapping) and not isinstance(value, str)),
    'give a list of names, such as ["tip"], readings by name, such as {"tip": "peak"}, or a function of a model',
)
MODELS = Kind(
    lambda value: BY_NAME.holds(value) and all(hasattr(one, "kernel") for one in value.values()),
    'give models by the knob that they stand for, such as {"rod.mesh": coarse_model}',
)


@dataclass(frozen=True)
class Change:
    """What a knob makes of an output.

    knob: such as `rod.modes`; difference: of the first level and the model as it is; error: of the model, as the
    difference tells it; order: observed, of three levels, else NaN. says: `error`; `nothing`, where the knob changes
    nothing, which does not say that nothing is wrong; `noise`, where it changes less than ten times what the steps
    leave open; `no limit`, where further levels do not come closer; `not compared`, where the output means something
    else there or could not be had, as `why` says.
    """

    output: str
    knob: str
    says: str
    difference: float = nan
    error: float = nan
    order: float = nan
    why: str = ""


@dataclass(frozen=True)
class ModellingError:
    """The error of an output [unit]: of the model by all knobs together, and of the steps.

    output: with its reading, such as `tip peak`; value: of the model as it is, of a motion its RMS about the mean, by
    which errors are told in per cent; error: the sum over the bodies, of each what its pieces tell or
    what its other knobs do together, whichever is larger; NaN where no knob says anything; knob: with the largest
    part; stepping: NaN where not known.
    """

    output: str
    unit: str
    value: float
    error: float
    knob: str
    stepping: float

    @property
    def relative(self) -> float:
        """The error of the model over the value; NaN where the value is zero or the error not known."""
        return self.error / abs(self.value) if self.value else nan


@dataclass(frozen=True)
class Turned:
    """A knob that was turned: from what, to what, and the time of its runs over that of the model as it is."""

    knob: str
    now: str
    to: tuple[str, ...]
    cost: float


@dataclass(frozen=True)
class Convergence:
    """The error of a model beside that of its steps, by output and by knob.

    errors: by output; changes: of each output by each knob; turned: what was turned; blind: knobs that the scene has,
    but that cannot be turned, and why; left: those that can be, but were not.
    """

    model: str
    of: str
    errors: dict[str, ModellingError]
    changes: tuple[Change, ...] = ()
    turned: tuple[Turned, ...] = ()
    blind: dict[str, str] = field(default_factory=dict)
    left: tuple[str, ...] = ()

    def __getitem__(self, output: str) -> ModellingError:
        """The error of an output by its name, with the reading where it has one. Raises ModelError."""
        if output not in self.errors:
            raise ModelError(f"convergence has no output {output!r}; it has {', '.join(self.errors)}")
        return self.errors[output]

    def __str__(self) -> str:
        return "\n".join(self.lines())

    def lines(self) -> list[str]:
        """A table of the outputs, and what was turned, says nothing, and cannot be turned."""
        wide = max([6, *(len(name) for name in self.errors)])
        found = [f"{self.model}: error of the model beside that of its steps, of the {self.of}"]
        found.append(f"{'output':<{wide}}  {'value':>11}  {'of the model':>19}  {'of the steps':>12}  most by")
        for name, one in self.errors.items():
            share = f" ({100 * one.relative:.2g} %)" if isfinite(one.relative) else ""
            known = "not told" if isnan(one.error) else f"{one.error:.2g}{share}"
            steps = "not known" if isnan(one.stepping) else f"{one.stepping:.2g}"
            found.append(
                f"{name:<{wide}}  {one.value:>11.6g}  {known:>19}  {steps:>12}  {one.knob or '-'}  [{one.unit}]"
            )
        if not self.turned:
            found.append(f"nothing was turned: {self.why_nothing()}")
        return found + self.remarks()

    def why_nothing(self) -> str:
        """Say why no knob was turned, and that nothing follows from it."""
        if self.left:
            return f"this says nothing of the model; {', '.join(self.left)} can be"
        if self.blind:
            return f"this says nothing of the model; {', '.join(self.blind)} cannot be"
        return "this says nothing of the model, which has no beams and no flexible bodies"

    def remarks(self) -> list[str]:
        """List what was turned and what it says, what cannot be turned and why, what could be."""
        found = []
        for knob in self.turned:
            said = ", ".join(self._said(change) for change in self.changes if change.knob == knob.knob)
            steps = " -> ".join([knob.now, *knob.to])
            cost = f" ({knob.cost:.2g} of the time)" if isfinite(knob.cost) else ""
            found.append(f"turned {knob.knob} {steps}{cost}: {said}")
        found += [f"cannot be turned: {name}: {why}" for name, why in self.blind.items()]
        if self.left:
            found.append(f"not turned: {', '.join(self.left)} (name them in knobs)")
        return found

    @staticmethod
    def _said(change: Change) -> str:
        known = {"error": f"{change.error:.2g}", "nothing": "says nothing", "noise": "below the noise of the steps"}
        text = known.get(change.says, change.says + (f" ({change.why})" if change.why else ""))
        order = f", order {change.order:.2g}" if isfinite(change.order) else ""
        return f"{change.output} {text}{order}"

    def write_csv(self, path: str | Path) -> None:
        """A row for each output and knob. Raises OutputError."""
        rows = ["output,unit,value,error,stepping_error,knob,says,difference,error_by_knob,order"]
        for one in self.changes:
            of = self.errors[one.output]
            numbers = (of.value, of.error, of.stepping)
            shown = [f'"{one.output}"', of.unit, *(_cell(value) for value in numbers), f'"{one.knob}"', one.says]
            rows.append(",".join([*shown, *(_cell(value) for value in (one.difference, one.error, one.order))]))
        write_text(Path(path), "\n".join(rows) + "\n")

    def to_dict(self) -> dict[str, Any]:
        """Plain values, SI units; None for what is not known."""

        def plain(value: Any) -> Any:
            if isinstance(value, dict):
                return {key: plain(one) for key, one in value.items()}
            if isinstance(value, list | tuple):
                return [plain(one) for one in value]
            return None if isinstance(value, float) and not isfinite(value) else value

        found: dict[str, Any] = plain(asdict(self))
        for name, one in self.errors.items():
            found["errors"][name]["relative"] = plain(one.relative)
        return found


def _cell(value: float) -> str:
    return repr(value) if isfinite(value) else ""


@arguments(
    outputs=OUTPUTS, coarser=MODELS, finer=MODELS, parameters=BY_NAME, initial=START, inputs=BY_NAME, progress=CALLED
)
def convergence(
    model: EmittedModel,
    outputs: Outputs | None = None,
    *,
    of: str = MOTION,
    knobs: Sequence[str] | None = None,
    levels: int = 1,
    coarser: Mapping[str, EmittedModel] | None = None,
    finer: Mapping[str, EmittedModel] | None = None,
    t_end: float | None = None,
    tolerance: float = 1e-5,
    parameters: Mapping[str, float] | None = None,
    initial: Initial = None,
    start: str | None = None,
    inputs: Mapping[str, InputValue] | None = None,
    samples: int = STUDY_SAMPLES,
    run: Solution | None = None,
    progress: Callable[[float, float], None] | bool | None = None,
) -> Convergence:
    """Estimate the error of the model itself: of its shapes, pieces and meshes, beside the error of its steps.

    Parameters
    ----------
    model : Model
        The mechanism, with its scene.
    outputs : sequence of str, mapping of str to str or sequence of str, or callable, optional
        Measures, and coordinates that are not elastic; all measures by default, and of a run without any up to eight
        coordinates that move. By name a reading or several:
        `motion`, the RMS of the difference over the motion (the default), or `max`, `min`, `peak` (largest magnitude),
        `mean`, `rms`, `end`. Or a function of a model that returns numbers by name, for what is neither a motion nor
        an equilibrium: `lambda m: {"first": m.modes().frequencies[0]}`.
    of : {"motion", "equilibrium"}, optional
        Of which outputs are taken: the motion from 0 to t_end, or the equilibrium that the model reaches.
    knobs : sequence of str, optional
        What is turned, by kind or by name, such as `modes` or `rod.pieces`: `modes` of beams, `elements` of lumped
        meshes, `pieces` (half of welded ones, two of a single one), `stiffening`, and sets of shapes that a beam does
        not have: `axial`, `lateral`, `lateral_z`, `torsion`. By default all but the last four. `half`: elements and
        welded pieces, by half of them, for less than the time of the model itself. An empty list: only coarser and
        finer.
    levels : {1, 2}, optional
        How often each knob is turned; 2 tells the observed order, and takes it for the error.
    coarser, finer : mapping of str to Model, optional
        Models with half the size, or double, by the knob that they stand for: `{"rod.mesh": coarse}` of a body from
        finite elements, whose mesh the scene does not hold. Errors are taken to fall with its square.
    t_end : float, optional
        Length of the motion [s].
    tolerance : float, optional
        Relative error of the steps of all runs [1].
    parameters, initial, start, inputs : optional
        As of `simulate`; of an equilibrium parameters, initial and inputs.
    samples : int, optional
        Times at which motions are compared.
    run : Solution, optional
        The motion of the model, which is not computed again then; span, parameters, inputs and start are its own.
    progress : bool or callable, optional
        A function is called with (runs done, runs).

    Returns
    -------
    Convergence
        The error by output, what each knob says, which knobs are blind.

    Raises
    ------
    ModelError
        Without a scene or a generator, and for unknown names.
    ArgumentError
        For other arguments that cannot be used.
    NoResult
        Where the model as it is has no motion or equilibrium, and of a run that ended early, or whose error is not
        known.

    Notes
    -----
    Of shapes the error is 4/3 of the difference to max(2 n, n + 2) of them; one more tells nothing where shapes are
    alternately even. Of pieces and meshes it is a third of the difference to half of them. What is left out
    (stiffening, stretching) is told by putting it in. What no knob turns is not seen: shear, plasticity, play.

    References
    ----------
    L. F. Richardson, The approximate arithmetical solution by finite differences of physical problems, Philosophical
    Transactions of the Royal Society A 210, 307-357, 1911.
    """
    if of not in (MOTION, EQUILIBRIUM):
        raise ArgumentError("of", f"cannot be {of!r}", f"give {MOTION!r} or {EQUILIBRIUM!r}, or outputs as a function")
    if levels not in (1, 2):
        raise ArgumentError("levels", f"cannot be {levels}", "give 1 or 2")
    if of == EQUILIBRIUM and (t_end is not None or start is not None):
        raise ArgumentError("t_end" if t_end is not None else "start", "applies to motions only", "leave it out, or of")
    if samples < 2:
        raise ArgumentError("samples", f"cannot be {samples}", "give a number from 2 on")
    if run is not None:
        given = {"t_end": t_end, "parameters": parameters, "initial": initial, "start": start}
        _check_run(model, run, outputs, of, [name for name, value in given.items() if value is not None], inputs)
    wanted = None if callable(outputs) else _readings(model, outputs, of, run)
    known = {} if knobs is not None and not knobs else _knobs_of(model, levels)
    chosen, left = _chosen(known, knobs, [*(coarser or {}), *(finer or {})])
    blind = {name: str(one["blind"]) for name, one in known.items() if "blind" in one}
    blind = {name: why for name, why in blind.items() if name not in {**(coarser or {}), **(finer or {})}}
    study = _Study(wanted, outputs, of, t_end, tolerance, parameters, initial, start, inputs, samples)
    study = study if run is None else study.beside(run)
    jobs = [
        *_derived(chosen),
        *_given(coarser or {}, ERROR_FROM_DOUBLE_SIZE, "half"),
        *_given(finer or {}, ERROR_FROM_HALF_SIZE, "double"),
    ]
    runs, done = 1 + sum(len(job.levels) for job in jobs), 1
    note = progress if callable(progress) else lambda done, runs: None
    base = study.sampled(model) if run is None else study.observed(run)
    note(done, runs)
    changes, turned = [], []
    for job in jobs:
        found: list[_Outputs | str] = []
        for level in job.levels:
            found.append(study.tried(level, job.unlike, base.assembled))
            done += 1
            note(done, runs)
        changes += [_change(name, job, base, found) for name in base.values]
        spent = sum(one.seconds for one in found if isinstance(one, _Outputs))
        turned.append(Turned(job.name, job.now, tuple(level.to for level in job.levels), spent / base.seconds))
    errors = {name: _summed(name, base, [one for one in changes if one.output == name]) for name in base.values}
    about = "given outputs" if callable(outputs) else of
    return Convergence(model.name, about, errors, tuple(changes), tuple(turned), blind, tuple(left))


# ---- What is asked ------------------------------------------------------------------------------------------------


def _check_run(
    model: EmittedModel, run: Solution, outputs: Any, of: str, given: Sequence[str], inputs: Mapping[str, Any] | None
) -> None:
    """Raises ArgumentError for what does not go with a run, NoResult for one that cannot be compared with."""
    if of == EQUILIBRIUM or callable(outputs):
        raise ArgumentError("run", "is a motion, and outputs are of another kind", "leave run out")
    if given:
        raise ArgumentError(given[0], "is that of the run", "leave it out, or run")
    if run.model.scene_toml != model.scene_toml:
        raise ArgumentError("run", f"is of another model than {model.name}", "give a run of this one")
    if not run.status.ok:
        raise NoResult(f"the run of {model.name} ended with {run.status}")
    if not run.error.measured:
        raise NoResult(f"the error of the steps of {model.name} is not known ({run.error.reason})")
    if missing := sorted(set(run.driven) - set(inputs or {})):
        raise NoResult(
            f"the run of {model.name} followed inputs that it does not hold, {', '.join(missing)}: give inputs"
        )


def _readings(model: EmittedModel, outputs: Any, of: str, run: Solution | None) -> list[tuple[str, str]]:
    """(output, reading) of all that is asked. Raises ModelError and ArgumentError."""
    measures = {entry.name for entry in model.description.measures}
    if outputs is None:
        outputs = [name for name in model.measures if name in measures and not name.endswith("_dot")]
        if run is not None:
            outputs = [name for name in outputs if not run.outputs or name in run.outputs] or _moving(run)
        if not outputs:
            raise ArgumentError("outputs", f"are missing, and {model.name} has no measures", "name some")
    asked = outputs if isinstance(outputs, Mapping) else dict.fromkeys(outputs, MOTION)
    if not asked:
        raise ArgumentError("outputs", "are none", "name some, or leave them out for all measures")
    units, found = column_units(model), []
    elastic = {entry.name for entry in model.description.coordinates if entry.elastic}
    for name, hows in asked.items():
        if not isinstance(name, str) or name not in units:
            raise ModelError(
                f"outputs {name!r}",
                f"model {model.name} has no output of this name",
                f"it has {', '.join([*model.measures, *model.coordinates])}",
            )
        if any(name in (one, f"{one}_dot", f"{one}_ddot") for one in elastic):
            raise ArgumentError(
                f"outputs {name!r}",
                "is the amplitude of one shape, which does not converge",
                "name a measure of a place",
            )
        for how in [hows] if isinstance(hows, str) else hows:
            if how not in HOWS:
                raise ArgumentError(
                    f"outputs {name!r}", f"there is no reading {how!r}", f"choose from {', '.join(HOWS)}"
                )
            found.append((name, how if of == MOTION else "end"))
    return list(dict.fromkeys(found))


def _moving(run: Solution) -> list[str]:
    """Some coordinates that a run moves, those of rigid bodies first; none that is elastic or an Euler parameter."""
    flexible = {entry.owner for entry in run.model.description.coordinates if entry.elastic}
    entries = [one for one in run.model.description.coordinates if not one.elastic and one.unit in ("m", "rad")]
    if run.outputs:
        entries = [one for one in entries if one.name in run.outputs]
    found = [one for one in entries if np.ptp(_series(run, one.name)[1]) > 0.0]
    return [one.name for one in sorted(found, key=lambda one: one.owner in flexible)][:MOST_COORDINATES]


def _series(run: Solution, name: str) -> tuple[np.ndarray, np.ndarray]:
    """(t (N,), values (N,)) of an output, which a run with `outputs` keeps beside its samples."""
    if run.outputs and name in run.outputs:
        return np.asarray(run.outputs["t"], dtype=float), np.asarray(run.outputs[name], dtype=float)
    return run.t, np.asarray(run[name], dtype=float)


def _at_times(t: np.ndarray, y: np.ndarray, wanted: np.ndarray, unit: str) -> np.ndarray:
    """A series by splines at the times that it reaches; NaN at others and where it has no value."""
    from scipy.interpolate import CubicSpline  # when it is needed: importing it takes long

    kept = np.isfinite(y) & (np.diff(t, prepend=-inf) > 0)
    at = wanted[wanted <= t[-1] + 1e-9 * (t[-1] - t[0])]
    if kept.sum() < 2:
        return np.full(len(at), nan)
    known = np.unwrap(y[kept]) if unit == "rad" else y[kept]
    return np.asarray(CubicSpline(t[kept], known)(at))


def _knobs_of(model: EmittedModel, levels: int) -> dict[str, dict[str, Any]]:
    """The knobs of the model's scene by name. Raises ModelError without a scene, and without a generator."""
    if not model.scene_toml:
        raise ModelError(
            f"model {model.name}",
            "comes without its scene, from which models with other shapes are derived",
            "generate it from its scene, or give coarser= and finer= with knobs=[]",
        )
    found = next(iter(entry_points(group=ENTRY_POINTS)), None)
    if found is None:
        older = "; the installed symgen is older: install it again" if list(entry_points(group=DERIVING)) else ""
        raise ModelError(
            f"model {model.name}",
            f"no generator of other scenes is installed{older}",
            "install symgen beside the runtime, or give coarser= and finer= with knobs=[]",
        )
    return {one["name"]: one for one in found.load()(model.scene_toml, levels)}


def _chosen(
    known: Mapping[str, dict[str, Any]], knobs: Sequence[str] | None, given: Sequence[str]
) -> tuple[list[dict[str, Any]], list[str]]:
    """(knobs that are turned, names of those that could be). Raises ArgumentError for unknown ones."""
    asked = list(USUAL if knobs is None else knobs)
    for name in asked if knobs is not None else ():
        if name != HALF and not any(name in (one["name"], one["kind"]) for one in known.values()):
            raise ArgumentError(
                f"knobs {name!r}", "is not a knob of this scene", f"it has {', '.join(known) or 'none'}"
            )
    can = [one for one in known.values() if "blind" not in one and one["name"] not in given]
    halved = [one for one in can if HALF in asked and one["factor"] < 1.0]
    chosen = [one for one in can if one["kind"] in asked or one["name"] in asked or one in halved]
    return chosen, [str(one["name"]) for one in can if one not in chosen]


@dataclass(frozen=True)
class _Level:
    """A model further away, made when it is wanted; renamed: its elastic coordinates by the model's names."""

    to: str
    make: Callable[[], EmittedModel]
    renamed: Mapping[str, str] = field(default_factory=dict)


@dataclass(frozen=True)
class _Job:
    name: str
    now: str
    levels: list[_Level]
    factor: float
    order: float
    unlike: tuple[str, ...] = ()


def _derived(chosen: Sequence[Mapping[str, Any]]) -> Iterator[_Job]:
    for one in chosen:
        levels = [_Level(each["to"], _maker(each["scene"]), each["renamed"]) for each in one["levels"]]
        yield _Job(one["name"], one["now"], levels, one["factor"], one["order"], tuple(one["unlike"]))


def _maker(scene_toml: str) -> Callable[[], EmittedModel]:
    def make() -> EmittedModel:
        found = next(iter(entry_points(group=DERIVING)), None)
        if found is None:
            raise ModelError("convergence", "no generator is installed", "install symgen beside the runtime")
        derived: EmittedModel = found.load()(scene_toml)
        return derived

    return make


def _given(models: Mapping[str, EmittedModel], factor: float, to: str) -> Iterator[_Job]:
    for name, model in models.items():
        yield _Job(name, "as it is", [_Level(to, lambda model=model: model)], factor, 2)  # type: ignore[misc]


# ---- Runs ---------------------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class _Outputs:
    """values: of each output a number or a series; sizes and stepping errors of each; time that it took [s].

    assembled: the start contradicted itself, and the motion began where the loops allow it.
    """

    values: dict[str, np.ndarray]
    sizes: dict[str, float]
    stepping: dict[str, float]
    units: dict[str, str]
    shown: dict[str, float]
    seconds: float
    assembled: bool = False


@dataclass(frozen=True)
class _Study:
    """What is asked of each model."""

    wanted: list[tuple[str, str]] | None
    outputs: Any
    of: str
    t_end: float | None
    tolerance: float
    parameters: Mapping[str, float] | None
    initial: Initial
    start: str | None
    inputs: Mapping[str, InputValue] | None
    samples: int
    times: np.ndarray | None = None
    t0: float = 0.0

    def beside(self, run: Solution) -> _Study:
        """What is asked of models that are compared with a run: its span, parameters and inputs, and its start."""
        model, asked = run.model, settings_of(run)
        t = _series(run, self.wanted[0][0])[0] if self.wanted else run.t
        kept = np.unique(np.linspace(0, len(t) - 1, min(len(t), self.samples)).round().astype(int))
        c = model.constants(run.parameters)
        scene = start_state(model, run.parameters, c, float(run.t[0]), None)
        away = np.abs(np.concatenate([scene.q - run.q[0], scene.q_dot - run.q_dot[0]]))
        as_declared = bool(np.all(away <= ONE_START * (1.0 + np.abs(np.concatenate([run.q[0], run.q_dot[0]])))))
        return replace(
            self,
            t_end=float(run.t[-1]),
            tolerance=float(np.clip(run.error.largest, *TOLERANCES_BESIDE)),
            parameters=asked.get("parameters"),
            inputs={**asked.get("inputs", {}), **(self.inputs or {})} or None,
            initial=None if as_declared else asked.get("initial"),
            start=None if as_declared else asked.get("start"),
            samples=int(min(BETWEEN_SAMPLES * max(len(t), self.samples), MOST_SAMPLES)),
            times=t[kept],
            t0=float(run.t[0]),
        )

    def tried(self, level: _Level, unlike: Sequence[str], assembled: bool) -> _Outputs | str:
        """What a turned model shows, or why it shows nothing; assembled: did the model begin where loops allow it?"""
        if unlike and assembled:
            return "the start contradicts itself, so cut beams begin elsewhere: give one that closes the loops"
        if named := [name for name in self.parameters or {} if name.partition(".")[0] in unlike]:
            return f"the parameter {named[0]} is that of a piece"
        try:
            return self.sampled(level.make(), level.renamed, unlike)
        except SymgenError as error:
            return str(error).splitlines()[0]

    def sampled(
        self, model: EmittedModel, renamed: Mapping[str, str] | None = None, unlike: Sequence[str] = ()
    ) -> _Outputs:
        """Values of the outputs. Raises what the run raises, and NoResult for one that did not get to its end."""
        began = time.process_time()
        if self.wanted is None:
            return self._asked(model, began)
        initial = self.initial
        if isinstance(initial, Mapping) and renamed:
            initial = {_other(name, renamed): value for name, value in initial.items()}
        if self.of == EQUILIBRIUM:
            return self.observed(self._at_rest(model, initial), unlike, began)
        return self.observed(self._moved(model, initial), unlike, began)

    def observed(self, run: Solution, unlike: Sequence[str] = (), began: float | None = None) -> _Outputs:
        """Values of the outputs of a run; began: its process time, which counts where no run is given [s]."""
        values, sizes, stepping, shown = {}, {}, {}, {}
        units = column_units(run.model)
        error = 0.0 if self.of == EQUILIBRIUM else run.error.largest
        for name, how in self.wanted or ():
            if name.partition(".")[0] in unlike:
                continue
            t, y = _series(run, name)
            if self.times is not None:
                y = _at_times(t, y, self.times, units.get(name, ""))
            key = name if how == MOTION or self.of != MOTION else f"{name} {how}"
            amplitude = float(np.std(y)) if how == MOTION else float(np.sqrt(np.mean(y**2)))
            values[key] = y if how == MOTION else np.array([READINGS[how](y)])
            sizes[key] = float(np.abs(y).max())
            stepping[key] = error * (amplitude if len(y) > 1 else sizes[key])
            shown[key] = float(np.std(y)) if how == MOTION else float(values[key][0])
        named = {key: units.get(name, "") for key, name in zip(values, self._names(unlike), strict=True)}
        own = began is None or self.times is not None  # beside a run that is given: what making the model takes is out
        spent = float(run.stats.get("wall_seconds", nan)) if own else time.process_time() - (began or 0.0)
        assembled = any(event.kind == "start_changed" for event in run.events)
        return _Outputs(values, sizes, stepping, named, shown, max(spent, 1e-6), assembled)

    def _names(self, unlike: Sequence[str]) -> list[str]:
        return [name for name, _ in self.wanted or () if name.partition(".")[0] not in unlike]

    def _asked(self, model: EmittedModel, began: float) -> _Outputs:
        """Numbers of the user's function."""
        found = self.outputs(model)
        if not (BY_NAME.holds(found) and all(is_finite_number(value) for value in found.values())):
            raise ArgumentError("outputs", "did not return finite numbers by name", 'return {"first": 1.0}')
        values = {name: np.array([float(value)]) for name, value in found.items()}
        shown = {name: float(value) for name, value in found.items()}
        sizes = {name: abs(value) for name, value in shown.items()}
        blank = dict.fromkeys(found, "")
        return _Outputs(values, sizes, dict.fromkeys(found, nan), blank, shown, max(time.process_time() - began, 1e-6))

    def _moved(self, model: EmittedModel, initial: Initial) -> Solution:
        run = simulate(
            model, scheme="auto", tolerance=self.tolerance, t_end=self.t_end, parameters=self.parameters,
            initial=initial, start=self.start, inputs=self.inputs, samples=self.samples, t0=self.t0,
        )  # fmt: skip
        if not run.status.ok:
            raise NoResult(f"the run of {model.name} ended with {run.status}")
        return run

    def _at_rest(self, model: EmittedModel, initial: Initial) -> Solution:
        """The equilibrium as a motion of one sample."""
        found = equilibrium(model, parameters=self.parameters, initial=initial, inputs=self.inputs)  # type: ignore[arg-type]
        c, t = model.constants(found.parameters), found.state.t
        q, q_dot = found.q[None, :], found.q_dot[None, :]
        p, ended = found.parameters, Status("completed", t)
        at = np.array([t])
        return assemble_solution(model, at, q, q_dot, np.zeros_like(q), p, c, EQUILIBRIUM, 0.0, [], {}, ended)


def _other(name: str, renamed: Mapping[str, str]) -> str:
    """A coordinate or rate by its name in another model."""
    base = name.removesuffix("_dot")
    return renamed.get(base, base) + name[len(base) :]


# ---- What differences tell ----------------------------------------------------------------------------------------


def _change(name: str, job: _Job, base: _Outputs, found: Sequence[_Outputs | str]) -> Change:
    """What a knob says of an output; a second level that is lost in the noise of the steps leaves it to the first."""
    shown = [base]
    for one in found:
        if isinstance(one, str):
            return Change(name, job.name, "not compared", why=one)
        if name not in one.values:
            return Change(name, job.name, "not compared", why="it is another thing of a piece")
        shown.append(one)
    common = min(len(one.values[name]) for one in shown)
    values = [one.values[name][:common] for one in shown]
    off = [_difference(b, a, base.units[name]) for a, b in zip(values, values[1:], strict=False)]
    left_open = [
        NOISE_OF_STEPS * max(_known(a.stepping[name]), _known(b.stepping[name]))
        for a, b in zip(shown, shown[1:], strict=False)
    ]
    size = _rms(off[0])
    if not isfinite(size):
        return Change(name, job.name, "not compared", why="it has no value at some times")
    if size <= OUTPUT_ROUNDING * base.sizes[name]:
        return Change(name, job.name, "nothing", size)
    if size <= left_open[0]:
        return Change(name, job.name, "noise", size)
    if len(off) == 1 or job.order == 0 or _rms(off[1]) <= left_open[1]:
        return Change(name, job.name, "error", size, job.factor * size)
    return _by_order(name, job, off)


def _known(value: float) -> float:
    return value if isfinite(value) else 0.0


def _by_order(name: str, job: _Job, differences: Sequence[np.ndarray]) -> Change:
    """Richardson's extrapolation by the observed order, of two further levels.

    Levels that are coarser and coarser fall towards the model, finer ones away from it.
    """
    near, far = differences[0], differences[1]
    falls = job.factor >= 1.0
    small, large = (_rms(far), _rms(near)) if falls else (_rms(near), _rms(far))
    order = float(np.log2(large / small)) if small > 0 else inf
    if not order > 0.0:
        return Change(name, job.name, "no limit", _rms(near), order=order)
    reach = 1.0 / (2.0 ** max(order, 1.0) - 1.0)
    if float(near @ far) <= 0.0:  # levels come from both sides: no order is seen
        return Change(name, job.name, "error", _rms(near), _rms(near) * (1.0 if falls else job.factor))
    error = _rms(near + far * (1.0 + reach)) if falls else _rms(near) * reach
    return Change(name, job.name, "error", _rms(near), error, order)


def _difference(a: np.ndarray, b: np.ndarray, unit: str) -> np.ndarray:
    """Of two series; of angles, which may be told modulo a turn, the smaller one."""
    off = a - b
    return np.asarray(off - 2 * np.pi * np.round(off / (2 * np.pi)) if unit == "rad" else off)


def _rms(y: np.ndarray) -> float:
    return float(np.sqrt(np.mean(y**2)))


def _summed(name: str, base: _Outputs, changes: Sequence[Change]) -> ModellingError:
    """The sum over the bodies. Pieces stand for what shapes and stiffening do, too: of a body the larger one counts."""
    known = [one for one in changes if one.says == "error"]
    by_body: dict[str, tuple[float, float]] = {}
    for one in known:
        body, _, kind = one.knob.rpartition(".")
        pieces, others = by_body.get(body, (0.0, 0.0))
        by_body[body] = (pieces + one.error, others) if kind == "pieces" else (pieces, others + one.error)
    error = sum(max(both) for both in by_body.values()) if known else nan
    if any(one.says == "no limit" for one in changes):
        error = nan
    largest = max(known, key=lambda one: one.error, default=None)
    return ModellingError(
        name, base.units[name], base.shown[name], error, largest.knob if largest else "", base.stepping[name]
    )

"""The texts of an FMU: what `fmi/core.c` and `fmi/fmiN.c` need to know of a model, and modelDescription.xml."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from importlib.resources import files

import casadi as ca

from runtime.baselines.condensed_ode import CondensedOde
from runtime.contract.coordinates import joined
from runtime.contract.escapes import c_string, xml_attribute
from runtime.contract.model import EmittedModel
from runtime.contract.tape import Tape, shared
from runtime.engine.c_source import Style, named, source, tape_code
from runtime.export.c_bundle import Exported, constant_array
from runtime.export.c_stops import event_table, whole_numbers
from runtime.schemes.switching.event_model import sets_of
from runtime.schemes.switching.times import may_jump, switches_by_inputs
from runtime.schemes.switching.watched import event_outputs, watched_events

_BOUNDS = {"any": 0, "not negative": 1, "positive": 2}
SINCE = "inputs.since"
_HEAD = """
#include "{stem}.h"

#if defined(__GNUC__) /* the standard has arguments that this unit has no use for */
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif

#define M(name) {p}##name
#define N(name) {p}##name
#define TOKEN {token}
#define NX {nx} /* states of model exchange; 0: it is not offered */
#define NE {events} /* events that the scene declares */
#define NG {indicators} /* event indicators of model exchange */
#define NM {modes} /* elements that stick, stops that close: the last of them */
#define NI {free}
#define V_AT {rates}
#define NAT {places}
#define NJ {jumps} /* loads that jump in time */
#define JUMPS_BY_INPUTS {by_inputs}
#define NSETS {sets}
#define WORK ({p}W > {work} ? {p}W : {work})
#define INPUTS_IN_C {inputs}
#define SINCE {since} /* which input is the time that inputs with rates count from */
#if defined(_WIN32)
#define DOOR __declspec(dllexport)
#elif defined(__GNUC__)
#define DOOR __attribute__((visibility("default")))
#else
#define DOOR
#endif
int {p}settle(double *at, double *u, const double *c, const int *happened, double *w);
int {p}next_jump(double *found, const double *c, double t, double until, double *w);
"""


def state_names(model: EmittedModel) -> list[str]:
    """Coordinates, rates and loop unknowns that are the states of model exchange.

    None where bodies turn freely: masters do not know rotations.
    """
    if model.places.turns.size:
        return []
    return [*model.q_i, *(f"{name}_dot" for name in model.q_i), *model.loop_unknowns]


def indicator_names(one: Exported) -> list[str]:
    """What passes zero in model exchange: at events, where loads kink; where they jump in time is known beforehand."""
    return [event.name for event in watched_events(one.scheme)] if state_names(one.model) else []


def fmu_source(one: Exported, fmi: int, token: str) -> str:
    """The file beside NAME.c that makes it an FMU; fmi: 2 or 3."""
    model, p = one.model, one.prefix
    states, shown = state_names(model), [quantity.name for quantity in one.outputs]
    rates = [name.removesuffix("_dot") + ("_ddot" if name.endswith("_dot") else "_dot") for name in states]
    inputs = [quantity.name for quantity in one.inputs]
    style, code = Style(p), []
    if states:
        ode, along = equations(one)
        code = [
            tape_code(f"{p}ode", named(ode, "x", "t", "c"), ["y"], style),
            tape_code(f"{p}ode_along", _with_all_arguments(named(along, "x", "t", "c", "dx", "du")), ["dy"], style),
        ]
    indicators, sets = indicator_names(one), sets_of(one.scheme) if states else []
    if indicators:
        found = event_equations(one)
        code += [tape_code(f"{p}{name}", named(made, "x", "t", "c"), ["y"], style) for name, made in found.items()]
    head = _HEAD.format(
        stem=p[:-1],
        work=max([1, *(part.work for part in code)]),
        p=p,
        token=c_string(token),
        nx=len(states),
        events=len(model.description.events) if states else 0,
        modes=len(model.element_modes) if states else 0,
        free=len(model.q_i),
        rates=len(model.coordinates),
        places=2 * len(model.coordinates) + 1,
        jumps=len(model.description.switching) if states and may_jump(model) else 0,
        by_inputs=int(switches_by_inputs(model)),
        indicators=len(indicators),
        sets=len(sets),
        inputs=model.c_size - model.signals.size,
        since=inputs.index(SINCE) if SINCE in inputs else -1,
    )
    places = {name: k for k, name in enumerate(shown)}
    modal = {entry.name for entry in model.description.coordinates if entry.elastic}
    tables = [
        whole_numbers("state_of", [places[name] for name in states]),
        whole_numbers("derivative_of", [places[name] for name in rates]),
        whole_numbers("start_of", [places.get(quantity.name, -1) for quantity in one.x]),
        whole_numbers("bound_of", [_BOUNDS[parameter.bound] for parameter in model.parameters]),
        constant_array("nominal_of", [nominal(name, modal) for name in states] or [1.0]),
    ]
    if states and model.description.events:
        tables += [*event_table(one.scheme), whole_numbers("sets_of", sets)]
    body = [
        files("runtime.export.fmi").joinpath(name).read_text(encoding="utf-8") for name in ("core.c", f"fmi{fmi}.c")
    ]
    return "\n".join([source(code, style, head), *tables, *body])


def nominal(name: str, modal: set[str]) -> float:
    """Of what size a state is, for the tolerances of integrators: deflections are small."""
    return 1e-3 if name in modal else 1.0


def equations(one: Exported) -> tuple[ca.Function, ca.Function]:
    """((x, t, c) -> y, (x, t, c, dx, du) -> dy along directions of the states and of the inputs)."""
    model, system = one.model, CondensedOde(one.model, 1)
    a, a_d = system.accelerations(), ca.SX(0, 1)
    if model.q_d:
        a_d = system.equations.dependent_accelerations(system.motion, system.v, a)
    q = joined(model, system.q_i, system.motion.q_d)
    q_dot, q_ddot = joined(model, system.v, system.v_d), joined(model, a, a_d)
    shown = [q, q_dot, ca.vertcat(*(q_ddot[model.coordinates.index(name)] for name in model.q_i))]
    if model.state_measures:
        shown.append(model.evaluate("measures", q=q, q_dot=q_dot, t=system.t, c=system.c)["measures"])
    if model.acceleration_measures:
        at = {"q": q, "q_dot": q_dot, "q_ddot": q_ddot, "lam_R": ca.SX(0, 1), "t": system.t}
        shown.append(model.evaluate("acceleration_measures", **at, c=system.c)["acceleration_measures"])
    (y,) = shared([ca.densify(ca.vertcat(*shown))])
    first = model.c_size - model.signals.size
    u = system.c[first:]
    dx, du = ca.SX.sym("dx", system.y.numel()), ca.SX.sym("du", u.numel())
    dy = ca.jtimes(y, system.y, dx) + (ca.jtimes(y, u, du) if u.numel() else 0)
    arguments = [system.y, system.t, system.c]
    along = shared([ca.densify(dy)])
    return ca.Function("ode", arguments, [y]), ca.Function("along", [*arguments, dx, du], along)


def event_equations(one: Exported) -> dict[str, ca.Function]:
    """(x, t, c) -> `indicators` by indicator_names, what inputs become by `acts`, and the `place` (q_i, q_d, rates of
    both, t) where elements are held and let go; those that there are.
    """
    model, system = one.model, CondensedOde(one.model, 1)
    shown = event_outputs(one.scheme, system.equations, system.motion, system.v, system.v_d)
    found = {"indicators": shown["events"], "acts": shown.get("actions", ca.SX(0, 1))}
    if model.element_modes.size:
        found["place"] = ca.vertcat(system.q_i, system.motion.q_d, system.v, system.v_d, system.t)
    arguments = [system.y, system.t, system.c]
    return {
        name: ca.Function(name, arguments, shared([ca.densify(value)]))
        for name, value in found.items()
        if value.numel()
    }


def _with_all_arguments(tape: Tape) -> Tape:
    """C declares those without entries, too."""
    return replace(tape, input_sizes=[max(1, size) for size in tape.input_sizes])


# modelDescription.xml, for version 2 and 3 of the standard.

_BASE = {
    "m": {"m": 1},
    "kg": {"kg": 1},
    "s": {"s": 1},
    "rad": {"rad": 1},
    "N": {"kg": 1, "m": 1, "s": -2},
    "Pa": {"kg": 1, "m": -1, "s": -2},
    "J": {"kg": 1, "m": 2, "s": -2},
    "W": {"kg": 1, "m": 2, "s": -3},
    "Hz": {"s": -1},
    "1": {},
}


@dataclass(frozen=True)
class Variable:
    """A variable with its value reference; start None: it is calculated. derivative: of which variable, by position."""

    name: str
    reference: int
    causality: str
    variability: str
    unit: str = ""
    meaning: str = ""
    initial: str = ""
    start: float | None = None
    least: float | None = None
    nominal: float = 1.0
    derivative: int | None = None


def variables(one: Exported) -> list[Variable]:
    """All that an FMU of the model shows, time first. Numbers of shapes, tables and arrays stay inside."""
    found = [Variable("time", 0, "independent", "continuous", "s")]
    hidden = {each.name for each in one.model.description.inputs if each.hidden}
    for k, (entry, own) in enumerate(zip(one.model.parameters, [*one.parameters, *one.inputs], strict=True)):
        least = 0.0 if entry.bound != "any" else None
        about = (entry.unit, entry.meaning)
        if k >= len(one.parameters):
            if entry.name in hidden:  # what events set beside inputs
                found.append(Variable(entry.name, 1 + k, "local", "discrete", *about, "calculated"))
            elif entry.name != SINCE:
                found.append(Variable(entry.name, 1 + k, "input", "continuous", *about, start=own.start))
        elif entry.kind != "data" and not entry.array:
            found.append(Variable(entry.name, 1 + k, "parameter", "tunable", *about, "exact", own.start, least))
    starts, first = {quantity.name: quantity for quantity in one.x}, 1 + len(one.p)
    states, modal = state_names(one.model), {e.name for e in one.model.description.coordinates if e.elastic}
    place = {quantity.name: len(found) + k for k, quantity in enumerate(one.outputs)}
    inputs = {quantity.name for quantity in one.inputs}
    for k, shown in enumerate(one.outputs):
        if shown.name in inputs:  # a measure of what is given
            continue
        given = starts.get(shown.name)
        initial = "calculated" if given is None else "approx" if given.meaning.startswith("about") else "exact"
        of = (
            shown.name.removesuffix("_ddot") + "_dot"
            if shown.name.endswith("_ddot")
            else shown.name.removesuffix("_dot")
        )
        found.append(
            Variable(
                shown.name,
                first + k,
                "output",
                "continuous",
                shown.unit,
                shown.meaning,
                initial,
                given.start if given else None,
                nominal=nominal(shown.name, modal) if shown.name in states else 1.0,
                derivative=place[of] if of != shown.name and of in states else None,
            )
        )
    first += len(one.outputs)
    for k, name in enumerate(indicator_names(one)):
        found.append(Variable(f"passes zero: {name}", first + k, "local", "continuous", meaning="event indicator"))
    return found


def description(one: Exported, fmi: int, token: str) -> str:
    """The text of modelDescription.xml; fmi: 2 or 3."""
    known, states = variables(one), state_names(one.model)
    return "\n".join(
        ['<?xml version="1.0" encoding="UTF-8"?>', *(_second if fmi == 2 else _third)(one, token, known, states)]
    )


def _second(one: Exported, token: str, known: list[Variable], states: list[str]) -> list[str]:
    stem, title = one.prefix[:-1], xml_attribute(one.model.title or one.name)
    sources = f'<SourceFiles><File name="fmu.c"/><File name="{stem}.c"/></SourceFiles>'
    kept = 'canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative='
    kept += f'"{str(bool(states)).lower()}"'
    lines = [
        f'<fmiModelDescription fmiVersion="2.0" modelName={xml_attribute(one.name)} guid="{token}" description={title}',
        '  generationTool="symgen" variableNamingConvention="flat" '
        f'numberOfEventIndicators="{len(indicator_names(one))}">',
    ]
    if states:
        lines.append(f'<ModelExchange modelIdentifier="{stem}" {kept}>{sources}</ModelExchange>')
    lines += [
        f'<CoSimulation modelIdentifier="{stem}" canHandleVariableCommunicationStepSize="true" '
        f'canInterpolateInputs="true" {kept}>{sources}</CoSimulation>',
        *_units(known),
        _categories(),
        _experiment(one),
        "<ModelVariables>",
    ]
    for v in known:
        real = _attributes(v, derivative=None if v.derivative is None else v.derivative + 1)
        initial = f' initial="{v.initial}"' if v.initial else ""
        lines.append(
            f'<ScalarVariable name={xml_attribute(v.name)} valueReference="{v.reference}" causality="{v.causality}" '
            f'variability="{v.variability}"{initial} description={xml_attribute(v.meaning)}>'
            f"<Real{real}/></ScalarVariable>"
        )
    lines += ["</ModelVariables>", "<ModelStructure>"]
    for kind, members in _structure(known, states).items():
        if members:
            entries = "".join(f'<Unknown index="{k + 1}"/>' for k in members)
            lines.append(f"<{kind}>{entries}</{kind}>")
    return [*lines, "</ModelStructure>", "</fmiModelDescription>", ""]


def _third(one: Exported, token: str, known: list[Variable], states: list[str]) -> list[str]:
    stem, title = one.prefix[:-1], xml_attribute(one.model.title or one.name)
    kept = f'modelIdentifier="{stem}" canGetAndSetFMUState="true" canSerializeFMUState="true" '
    kept += f'providesDirectionalDerivatives="{str(bool(states)).lower()}"'
    lines = [
        f'<fmiModelDescription fmiVersion="3.0" modelName={xml_attribute(one.name)} instantiationToken="{token}"',
        f'  description={title} generationTool="symgen" variableNamingConvention="flat">',
        *([f'<ModelExchange {kept} needsCompletedIntegratorStep="true"/>'] if states else []),
        f'<CoSimulation {kept} canHandleVariableCommunicationStepSize="true"/>',
        *_units(known),
        _categories(),
        _experiment(one),
        "<ModelVariables>",
    ]
    for v in known:
        of = None if v.derivative is None else known[v.derivative].reference
        initial = f' initial="{v.initial}"' if v.initial else ""
        lines.append(
            f'<Float64 name={xml_attribute(v.name)} valueReference="{v.reference}" causality="{v.causality}" '
            f'variability="{v.variability}"{initial} description={xml_attribute(v.meaning)}{_attributes(v, of)}/>'
        )
    lines += ["</ModelVariables>", "<ModelStructure>"]
    names = {"Outputs": "Output", "Derivatives": "ContinuousStateDerivative", "InitialUnknowns": "InitialUnknown"}
    for kind, members in _structure(known, states).items():
        lines += [f'<{names[kind]} valueReference="{known[k].reference}"/>' for k in members]
    indicators = [v.reference for v in known if v.meaning == "event indicator"]
    lines += [f'<EventIndicator valueReference="{reference}"/>' for reference in indicators]
    return [*lines, "</ModelStructure>", "</fmiModelDescription>", ""]


def _structure(known: list[Variable], states: list[str]) -> dict[str, list[int]]:
    """Positions of outputs, derivatives in the order of their states, and what the initialisation finds."""
    outputs = [k for k, v in enumerate(known) if v.causality == "output"]
    rates = {known[v.derivative].name: k for k, v in enumerate(known) if v.derivative is not None}
    derivatives = [rates[name] for name in states]
    unknowns = [k for k in outputs if known[k].initial != "exact"]
    return {"Outputs": outputs, "Derivatives": derivatives, "InitialUnknowns": unknowns}


def _attributes(v: Variable, derivative: int | None) -> str:
    found = f" unit={xml_attribute(v.unit)}" if v.unit else ""
    found += f' min="{v.least!r}"' if v.least is not None else ""
    found += f' nominal="{v.nominal!r}"' if v.nominal != 1.0 else ""
    found += f' start="{v.start!r}"' if v.start is not None else ""
    return found + (f' derivative="{derivative}"' if derivative is not None else "")


def _categories() -> str:
    names = ("logStatusError", "logStatusDiscard")
    return "<LogCategories>" + "".join(f'<Category name="{name}"/>' for name in names) + "</LogCategories>"


def _experiment(one: Exported) -> str:
    end, step = float(one.model.simulation["t_end"]), one.scheme.grid.dt_L
    return f'<DefaultExperiment startTime="0.0" stopTime="{end!r}" stepSize="{step!r}"/>'


def _units(known: list[Variable]) -> list[str]:
    units = dict.fromkeys(v.unit for v in known if v.unit)
    return ["<UnitDefinitions>", *(_unit(unit) for unit in units), "</UnitDefinitions>"]


def _unit(text: str) -> str:
    """A unit with its exponents of the base units, where all parts of it are known."""
    powers: dict[str, int] = {}
    for sign, name, power in re.findall(r"(/?)\s*([A-Za-z1]+)(?:\^(-?\d+))?", text):
        if name not in _BASE:
            return f"<Unit name={xml_attribute(text)}/>"
        for base, exponent in _BASE[name].items():
            powers[base] = powers.get(base, 0) + exponent * int(power or 1) * (-1 if sign else 1)
    given = "".join(f' {base}="{exponent}"' for base, exponent in powers.items() if exponent)
    return f"<Unit name={xml_attribute(text)}><BaseUnit{given}/></Unit>"

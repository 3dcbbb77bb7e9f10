"""modelDescription.xml of an FMU, for version 2 and 3 of the standard."""

from __future__ import annotations

import re
from dataclasses import dataclass
from xml.sax.saxutils import quoteattr

from runtime.export.c_bundle import Exported
from runtime.export.fmu_source import SINCE, indicator_names, nominal, state_names

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
    for k, seen in enumerate(one.outputs):
        if seen.name in inputs:  # a measure of what is given
            continue
        given = starts.get(seen.name)
        initial = "calculated" if given is None else "approx" if given.meaning.startswith("about") else "exact"
        of = seen.name.removesuffix("_ddot") + "_dot" if seen.name.endswith("_ddot") else seen.name.removesuffix("_dot")
        found.append(
            Variable(
                seen.name,
                first + k,
                "output",
                "continuous",
                seen.unit,
                seen.meaning,
                initial,
                given.start if given else None,
                nominal=nominal(seen.name, modal) if seen.name in states else 1.0,
                derivative=place[of] if of != seen.name and of in states else None,
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
    stem, title = one.prefix[:-1], quoteattr(one.model.title or one.name)
    sources = f'<SourceFiles><File name="fmu.c"/><File name="{stem}.c"/></SourceFiles>'
    kept = 'canGetAndSetFMUstate="true" canSerializeFMUstate="true" providesDirectionalDerivative='
    kept += f'"{str(bool(states)).lower()}"'
    lines = [
        f'<fmiModelDescription fmiVersion="2.0" modelName={quoteattr(one.name)} guid="{token}" description={title}',
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
            f'<ScalarVariable name={quoteattr(v.name)} valueReference="{v.reference}" causality="{v.causality}" '
            f'variability="{v.variability}"{initial} description={quoteattr(v.meaning)}><Real{real}/></ScalarVariable>'
        )
    lines += ["</ModelVariables>", "<ModelStructure>"]
    for kind, members in _structure(known, states).items():
        if members:
            entries = "".join(f'<Unknown index="{k + 1}"/>' for k in members)
            lines.append(f"<{kind}>{entries}</{kind}>")
    return [*lines, "</ModelStructure>", "</fmiModelDescription>", ""]


def _third(one: Exported, token: str, known: list[Variable], states: list[str]) -> list[str]:
    stem, title = one.prefix[:-1], quoteattr(one.model.title or one.name)
    kept = f'modelIdentifier="{stem}" canGetAndSetFMUState="true" canSerializeFMUState="true" '
    kept += f'providesDirectionalDerivatives="{str(bool(states)).lower()}"'
    lines = [
        f'<fmiModelDescription fmiVersion="3.0" modelName={quoteattr(one.name)} instantiationToken="{token}"',
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
            f'<Float64 name={quoteattr(v.name)} valueReference="{v.reference}" causality="{v.causality}" '
            f'variability="{v.variability}"{initial} description={quoteattr(v.meaning)}{_attributes(v, of)}/>'
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
    found = f" unit={quoteattr(v.unit)}" if v.unit else ""
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
            return f"<Unit name={quoteattr(text)}/>"
        for base, exponent in _BASE[name].items():
            powers[base] = powers.get(base, 0) + exponent * int(power or 1) * (-1 if sign else 1)
    given = "".join(f' {base}="{exponent}"' for base, exponent in powers.items() if exponent)
    return f"<Unit name={quoteattr(text)}><BaseUnit{given}/></Unit>"

"""A scheme on a model as C99 that needs nothing but the C library: NAME.h, NAME.c, an example and a CMake file.

A step is the step program that the runtime compiles, with the same mathematics, so its bits are the runtime's. What the
runtime evaluates once (constants, a start, what states show) takes sin, cos and exp of the C library there and here.
Nothing is allocated, nothing is global: all memory is the caller's, so any number of instances run side by side.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import prod
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

from runtime.contract.arguments import BY_NAME, NUMBER, PLACE, arguments
from runtime.contract.coordinates import independent, loop_part
from runtime.contract.errors import ModelError
from runtime.contract.escapes import c_comment, c_string
from runtime.contract.files import write_text
from runtime.contract.model import EmittedModel
from runtime.engine.c_source import Code, Style, named, program_code, source, stage_code, tape_code
from runtime.engine.prepare import Prepared
from runtime.export.c_mathematics import own_c
from runtime.export.c_stops import ENDS, refuse_stops, stop_functions, stop_text
from runtime.running.inputs import reading
from runtime.running.planning import make_plan, steps_asked
from runtime.running.problem import steps_until
from runtime.running.stepping import ModelStepper
from runtime.schemes.scheme import Scheme
from runtime.schemes.stepper import prepared_step, start_there
from runtime.schemes.switching.event_model import kept, restart_function
from runtime.schemes.switching.watched import watches
from runtime.start.start_state import start_state

NAME = "[A-Za-z][A-Za-z0-9_. -]{0,63}"


@dataclass(frozen=True)
class Quantity:
    """A number that is given or seen, as C's tables name it."""

    name: str
    unit: str
    meaning: str
    start: float = 0.0


@dataclass(frozen=True, eq=False)
class Exported:
    """A scheme on a model as it is handed on; p (n_p,), z (z_size,): its parameters and start."""

    model: EmittedModel
    name: str
    scheme: Scheme
    prepared: Prepared
    p: np.ndarray
    z: np.ndarray
    x: list[Quantity]

    @property
    def prefix(self) -> str:
        """Of every name in the code."""
        return re.sub(r"\W", "_", self.name, flags=re.ASCII) + "_"

    @property
    def ready(self) -> int:
        """Length of what the step program reads."""
        return int(self.prepared.constants.size1_out(0))

    @property
    def inputs(self) -> list[Quantity]:
        """The numbers that inputs are made of, the last entries of p."""
        return _parameters(self.model, self.p)[len(self.p) - self.model.signals.size :]

    @property
    def parameters(self) -> list[Quantity]:
        """The other entries of p."""
        return _parameters(self.model, self.p)[: len(self.p) - self.model.signals.size]

    @property
    def outputs(self) -> list[Quantity]:
        """Coordinates, rates, accelerations of q_i, measures."""
        entries = self.model.description.coordinates
        found = [Quantity(one.name, one.unit, one.kind) for one in entries]
        found += [Quantity(f"{one.name}_dot", one.unit_of(1), f"rate, {one.kind}") for one in entries]
        moving = [one for one in entries if one.name in self.model.q_i]
        found += [Quantity(f"{one.name}_ddot", one.unit_of(2), f"acceleration, {one.kind}") for one in moving]
        return found + [Quantity(one.name, one.unit, "measure") for one in self.model.description.measures]


@arguments(options=BY_NAME, parameters=BY_NAME, dt=NUMBER)
def exported(
    model: EmittedModel,
    scheme: str | None = None,
    dt: float | None = None,
    m: list[int] | None = None,
    options: Mapping[str, Any] | None = None,
    parameters: Mapping[str, float] | None = None,
    name: str | None = None,
) -> Exported:
    """Prepare a model and a scheme, by default the scene's. Raises ModelError or SchemeError for what cannot leave."""
    if not model.q_i:
        raise ModelError(f"model {model.name}", "has no step: every coordinate is driven", "simulate it")
    if name is not None and not re.fullmatch(NAME, name):
        problem = "is no name for files and for what stands in them"
        raise ModelError(f"name {name!r}", problem, "give a letter and up to 63 letters, digits, blanks, _, . or -")
    if model.redundant and (open_ := model.acceleration_measures):
        problem = (
            "follows from joint forces, which redundant constraints leave open; single runs choose those of least norm"
        )
        remedy = "give its beam axial modes, or leave the measure out"
        raise ModelError(f"measure {', '.join(open_)} of model {model.name}", problem, remedy)
    p = model.parameter_vector(parameters)
    refuse_stops(model, p)
    name_of_scheme, length = steps_asked(model, scheme, dt, m, options)
    plan = make_plan(model, 1e9 * length, length, m, name_of_scheme, None, options, 0.0, bounded=True)
    plan.scheme.of_one_length("exported code")
    built = plan.scheme
    state = start_state(model, p, model.constants(p), 0.0, None)
    own = ModelStepper(model, scheme=scheme, dt=dt, m=m, options=options, parameters=parameters, engine="interpreted")
    z, x = np.append(own.save().z, np.zeros(kept(built))), _start_values(model, state.q, state.q_dot)
    return Exported(model, name or model.name, built, prepared_step(built), p, z, x)


def write_c(one: Exported, folder: str | Path) -> list[Path]:
    """NAME.h, NAME.c, main.c and CMakeLists.txt in a folder. Raises OutputError."""
    if one.prefix == "main_":
        raise ModelError(f"model {one.name}", "has the name of the example, main.c", "give exported(..., name=...)")
    files = {**c_files(one), "main.c": _main(one), "CMakeLists.txt": _cmake(one.prefix[:-1])}
    for name, text in files.items():
        write_text(Path(folder) / name, text)
    return [Path(folder) / name for name in files]


@arguments(folder=PLACE)
def export_c(model: EmittedModel, folder: str | Path, **steps: Any) -> list[Path]:
    """Write the model with a scheme as plain C into a folder.

    Parameters
    ----------
    model : Model
        The mechanism.
    folder : path
        Where the files go.
    **steps
        scheme, dt [s], m, options, parameters, name: the step that is written.

    Returns
    -------
    list of Path
        The files.

    Raises
    ------
    ModelError, SchemeError
        For what cannot leave.
    OutputError
        For a folder that takes nothing.
    """
    return write_c(exported(model, **steps), folder)


def c_files(one: Exported) -> dict[str, str]:
    """NAME.h and NAME.c."""
    stem, style = one.prefix[:-1], Style(one.prefix, own=True)
    code = _functions(one)
    head = f'#include "{stem}.h"\n\n'
    own = own_c("".join(part.text for part in code.values()), one.prefix)
    body = source(list(code.values()), style, own + _constant_tables(one))
    stops, kept_work = (
        stop_text(one.scheme, one.prepared, one.prefix, code)
        if kept(one.scheme)
        else (_WITHOUT_STOPS.format(p=one.prefix), 0)
    )
    return {
        f"{stem}.h": _header(one, kept_work + _work(one, code)),
        f"{stem}.c": f"{head}{body}\n{stops}\n{_doors(one)}",
    }


# ---- functions ------------------------------------------------------------------------------------------------


def _functions(one: Exported) -> dict[str, Code]:
    """What stands behind the doors by name, static functions but for `step`."""
    p, scheme = one.prefix, one.scheme
    own = Style(p, own=True)
    library = replace(own, own=False)
    starter, arguments = _starter(scheme)
    names = [quantity.name for quantity in one.outputs]
    observer = reading(scheme, len(one.z), names)
    found = {
        "model_constants": tape_code(f"{p}model_constants", named(one.model.kernel("constants"), "p"), ["c"], library),
        "prepare": stage_code(f"{p}prepare", named(one.prepared.constants, "c"), library),
        "begin": tape_code(f"{p}begin", named(starter, *arguments), ["z"], library),
        "observe": tape_code(f"{p}observe", named(observer, "z", "c"), ["y"], library, kept=""),
        "steps": program_code(f"{p}steps", one.prepared.program, own, "static "),
        "again": stage_code(f"{p}again", named(restart_function(scheme), "z", "c"), own),
    }
    return found | (stop_functions(scheme, one.prepared, p, library, own) if kept(scheme) else {})


def _starter(scheme: Scheme) -> tuple[ca.Function, list[str]]:
    """(the start of a scheme, names of its arguments)."""
    if scheme.model.places.all_independent:
        return scheme.starter, ["t", "q_i", "q_i_dot", "loop", "c"]
    return start_there(scheme), ["t", "q", "q_dot", "c"]


def _inputs(scheme: Scheme) -> int:
    """How many numbers z has for inputs."""
    return scheme.layout.sizes.get("inputs", 0)


def _work(one: Exported, code: Mapping[str, Code]) -> int:
    """Entries of w: of the longest function, and what stands before its own."""
    before = {"again": one.scheme.layout.size + 3 + _inputs(one.scheme) + len(one.model.q_i)}
    return max([1, *(part.work + before.get(name, 0) for name, part in code.items())])


# ---- text -----------------------------------------------------------------------------------------------------


def _constant_tables(one: Exported) -> str:
    """Names, units, meanings and start values; the first state."""
    p, lines = one.prefix, list[str]()
    tables = {"parameters": one.parameters, "inputs": one.inputs, "starts": one.x, "outputs": one.outputs}
    for name, entries in tables.items():
        rows = [f"  {{{', '.join(map(c_string, (e.name, e.unit, e.meaning)))}, {e.start!r}}}," for e in entries]
        lines += [f"const {p}quantity {p}{name}[] = {{", *rows, "  {NULL, NULL, NULL, 0.0}};", ""]
    return "\n".join([*lines, constant_array(f"{p}z0", one.z), ""])


def constant_array(name: str, values: Sequence[float] | np.ndarray) -> str:
    """A static table of doubles, read back as they are."""
    flat = [repr(float(value)) for value in values]
    rows = ["  " + ", ".join(flat[k : k + 6]) for k in range(0, len(flat), 6)]
    return f"static const double {name}[{len(flat)}] = {{\n" + ",\n".join(rows) + "};"


def _header(one: Exported, work: int) -> str:
    p, sizes = one.prefix, [len(entries) for entries in (one.parameters, one.inputs, one.x, one.outputs)]
    numbers = dict(zip(("PARAMETERS", "INPUTS", "STARTS", "OUTPUTS"), sizes, strict=True))
    numbers |= {"P": len(one.p), "Z": len(one.z), "C": one.ready, "W": work}
    defined = "\n".join(f"#define {p}{name} {value}" for name, value in numbers.items())
    return _HEADER.format(
        p=p,
        guard=f"{p}H",
        title=c_comment(one.model.title or one.name),
        defined=defined,
        dt=one.scheme.grid.dt_L,
        ends=", ".join(f"{p}{name} = {number}" for name, number in ENDS.items()),
    )


_HEADER = """/* {title}: steps of a mechanism. All numbers in SI units.

   Memory is the caller's: p[{p}P] parameters and behind them inputs, c[{p}C] what follows
   from p, z[{p}Z] the state, y[{p}OUTPUTS] what it shows, w[{p}W] for work (nothing in it
   lasts from call to call; one for each thread). For the bits of the runtime compile without
   contraction (-ffp-contract=off); fma must round once. */
#ifndef {guard}
#define {guard}

{defined}
#define {p}DT {dt!r} /* the step that it was made for */

typedef struct {{
  const char *name, *unit, *meaning;
  double start;
}} {p}quantity;

/* each ends with an entry whose name is NULL */
extern const {p}quantity {p}parameters[], {p}inputs[], {p}starts[], {p}outputs[];

#ifdef __cplusplus
extern "C" {{
#endif

/* place of a name in one of these tables, -1 where it is not */
int {p}find(const {p}quantity *table, const char *name);

/* parameters and inputs as they were when this was written */
void {p}defaults(double *p);

/* what steps of dt seconds read; again after p or dt has changed */
void {p}constants(double *c, const double *p, double dt, double *w);

/* the state at t = 0 for p of `defaults` and dt of {p}DT */
void {p}first(double *z);

/* the state at t from values in the order of `starts`; loops are closed near those given */
void {p}start(double *z, const double *c, double t, const double *x, double *w);

/* n steps; 0, or why the motion has ended before: z is there, and does not go on */
enum {{ {ends} }};
int {p}step(double *z, const double *c, double *w, long n);

/* other inputs u[{p}INPUTS] from here on; c stays as it is. Also after `constants` with other p */
void {p}hold(double *z, const double *c, const double *u, double *w);

/* go on from z, which steps of dt_before led to, with steps of dt; then `constants` for dt */
void {p}restart(double *z, const double *c, double dt_before, double dt, double *w);

/* a last step that ends at t, before a whole step of c would; c and p as in `constants`; result as of `step` */
int {p}finish(double *z, double *c, const double *p, double t, double *w);

/* the inputs u[{p}INPUTS] that z holds: as given, or as events have set them */
void {p}held(double *u, const double *z);

double {p}time(const double *z, const double *c);
void {p}observe(double *y, const double *z, const double *c, double *w);

/* are all numbers of the state finite? */
int {p}finite(const double *z);

#ifdef __cplusplus
}}
#endif
#endif
"""


def _doors(one: Exported) -> str:
    scheme, model, p = one.scheme, one.model, one.prefix
    starter, names = _starter(scheme)
    given, at = list[str](), 0
    for k, name in enumerate(names):
        size = starter.numel_in(k)
        if name not in ("t", "c") and size:
            given.append(f"x + {at}")
            at += size
        elif size:
            given.append({"t": "&t", "c": "c"}[name])
    n_w = _inputs(scheme)
    first = scheme.layout.slice("inputs").start if n_w else 0
    return _DOORS.format(
        p=p,
        steps=constant_array("steps", np.array(scheme.grid.h)),
        count=len(scheme.grid.h),
        end=model.c_size,
        sub_steps=prod(scheme.grid.m),
        given=", ".join(given),
        used="" if at else "  (void)x;\n",
        size=scheme.layout.size,
        inputs=n_w,
        first=first,
        anew=int(scheme.multistep),
        pushed=len(model.q_i) if watches(scheme) else 0,
        **_stop_doors(scheme, p),
    )


def _stop_doors(scheme: Scheme, p: str) -> dict[str, str]:
    """What starts, inputs and restarts do where steps may be broken."""
    if not kept(scheme):
        return {"set_out": "", "looked": "", "on_grid": ""}
    looked = f"\n  look_again(&{p}model, z, c, w);" if watches(scheme) else ""
    on_grid = f"\n  z[{p}model.NZ] = z[0];{looked}"
    return {"set_out": f"\n  set_out_at(&{p}model, z, c, t, w);", "looked": looked, "on_grid": on_grid}


_WITHOUT_STOPS = """
int {p}step(double *z, const double *c, double *w, long n) {{
  {p}steps(z, c, w, n);
  return 0;
}}
"""

_DOORS = """
int {p}find(const {p}quantity *table, const char *name) {{
  int k;
  for (k = 0; table[k].name != NULL; ++k) {{
    if (strcmp(table[k].name, name) == 0) return k;
  }}
  return -1;
}}

void {p}defaults(double *p) {{
  long k;
  for (k = 0; {p}parameters[k].name != NULL; ++k) p[k] = {p}parameters[k].start;
  for (p += k, k = 0; {p}inputs[k].name != NULL; ++k) p[k] = {p}inputs[k].start;
}}

void {p}constants(double *c, const double *p, double dt, double *w) {{
  {steps}
  long k;
  {p}model_constants(c, p, w);
  for (k = 0; k < {count}; ++k) c[{end} + k] = steps[k] * (dt / steps[0]);
  {p}prepare(c, w);
}}

void {p}first(double *z) {{ memcpy(z, {p}z0, sizeof {p}z0); }}

void {p}start(double *z, const double *c, double t, const double *x, double *w) {{
{used}  memset(z, 0, sizeof {p}z0);
  {p}begin(z, {given}, w);{set_out}
}}

static void {p}go_on(double *z, const double *c, double dt_before, double dt, double t, const double *u, double *w) {{
  memcpy(w, z, {size} * sizeof(double));
  w[{size}] = dt_before, w[{size} + 1] = dt, w[{size} + 2] = t;
  memcpy(w + {size} + 3, u, {inputs} * sizeof(double));
  memset(w + {size} + 3 + {inputs}, 0, {pushed} * sizeof(double));
  {p}again(w, c, w + {size} + 3 + {inputs} + {pushed});
  memcpy(z, w, {size} * sizeof(double));
}}

void {p}hold(double *z, const double *c, const double *u, double *w) {{
  const double t0 = z[0], n = z[1];
  if ({anew}) {{ /* a multistep scheme remembers earlier steps */
    long k = 0;
    while (k < {inputs} && z[{first} + k] == u[k]) ++k;
    if (k < {inputs}) {p}go_on(z, c, c[{end}], c[{end}], {p}time(z, c), u, w);
    z[0] = t0, z[1] = n;
  }}
  memcpy(z + {first}, u, {inputs} * sizeof(double));{looked}
}}

void {p}held(double *u, const double *z) {{ memcpy(u, z + {first}, {inputs} * sizeof(double)); }}

double {p}time(const double *z, const double *c) {{ return z[0] + z[1] * c[{end}]; }}

void {p}restart(double *z, const double *c, double dt_before, double dt, double *w) {{
  {p}go_on(z, c, dt_before, dt, z[0] + z[1] * dt_before, z + {first}, w);{on_grid}
}}

int {p}finish(double *z, double *c, const double *p, double t, double *w) {{
  const double dt = c[{end}], rest = (t - {p}time(z, c)) * (1 - 2 * 2.220446049250313e-16 * {sub_steps});
  int ended;
  {p}restart(z, c, dt, rest, w);
  {p}constants(c, p, rest, w);
  ended = {p}step(z, c, w, 1);
  {p}constants(c, p, dt, w);
  {p}go_on(z, c, rest, dt, ended ? z[0] + z[1] * rest : t, z + {first}, w);{on_grid}
  return ended;
}}

int {p}finite(const double *z) {{
  long k;
  for (k = 0; k < {size}; ++k) {{
    if (!(z[k] - z[k] == 0.0)) return 0;
  }}
  return 1;
}}
"""


def _start_values(model: EmittedModel, q: np.ndarray, q_dot: np.ndarray) -> list[Quantity]:
    """What `start` takes, at a consistent state of all coordinates (n,)."""
    records = {record.name: record for record in model.description.coordinates}
    names, values, rates = list(model.coordinates), q, q_dot
    if model.places.all_independent:
        names, (values, rates) = list(model.q_i), independent(model, q, q_dot)
    units = [records[name].unit if name in records else "" for name in names]
    per_second = [records[name].unit_of(1) if name in records else "1/s" for name in names]
    found = [Quantity(*one) for one in zip(names, units, ["start"] * len(names), map(float, values), strict=True)]
    slow = zip((f"{name}_dot" for name in names), per_second, ["start"] * len(names), map(float, rates), strict=True)
    found += [Quantity(*one) for one in slow]
    if model.places.all_independent:
        guess = zip(model.loop_unknowns, map(float, loop_part(model, q)), strict=True)
        found += [Quantity(name, records[name].unit, "about, closes a loop", value) for name, value in guess]
    return found


def _parameters(model: EmittedModel, p: np.ndarray) -> list[Quantity]:
    return [Quantity(e.name, e.unit, e.meaning, float(v)) for e, v in zip(model.parameters, p, strict=True)]


def _main(one: Exported) -> str:
    t_end = float(one.model.simulation["t_end"])
    found = steps_until(0.0, t_end, one.scheme.grid.dt_L)
    shorter = found["end"] is not None
    whole = found["steps"] - shorter
    return _MAIN.format(
        p=one.prefix,
        stem=one.prefix[:-1],
        seconds=t_end,
        t_end=repr(t_end),
        steps=whole,
        rows=max(1, min(100, whole)),
        shorter=int(shorter),
    )


_MAIN = """/* Runs {stem} for {seconds:g} s (simulation.t_end of the scene) and writes what it shows as CSV. */
#include <stdio.h>

#include "{stem}.h"

int main(void) {{
  double p[{p}P + 1], c[{p}C], z[{p}Z], y[{p}OUTPUTS];
  static double w[{p}W];
  const long steps = {steps}, rows = {rows};
  long row = 0, last = rows + {shorter}; /* the last step is shorter where no whole number of them fits */
  int k;
  {p}defaults(p);
  {p}constants(c, p, {p}DT, w);
  {p}first(z);
  printf("t");
  for (k = 0; k < {p}OUTPUTS; ++k) printf(",%s", {p}outputs[k].name);
  for (;; ++row) {{
    {p}observe(y, z, c, w);
    printf("\\n%.17g", {p}time(z, c));
    for (k = 0; k < {p}OUTPUTS; ++k) printf(",%.17g", y[k]);
    if (row >= last || !{p}finite(z)) break;
    if (row < rows ? {p}step(z, c, w, steps * (row + 1) / rows - steps * row / rows)
                   : {p}finish(z, c, p, {t_end}, w)) {{
      last = row + 1; /* the motion has ended before */
    }}
  }}
  printf("\\n");
  return {p}finite(z) ? 0 : 1;
}}
"""


def _cmake(stem: str) -> str:
    return f"""cmake_minimum_required(VERSION 3.10)
project({stem} C)
set(CMAKE_C_STANDARD 99)
set(CMAKE_C_STANDARD_REQUIRED ON)
set(CMAKE_C_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
if(NOT MSVC)
  add_compile_options(-ffp-contract=off)
  set(MATHEMATICS m)
endif()
add_library({stem} STATIC {stem}.c)
target_include_directories({stem} PUBLIC ${{CMAKE_CURRENT_SOURCE_DIR}})
target_link_libraries({stem} PUBLIC ${{MATHEMATICS}})
add_executable({stem}_example main.c)
target_link_libraries({stem}_example {stem})
"""

"""Long undamped runs, m from 1 to 200, and steps on a resonance: `python -m benchmarks.pages.long_runs [--publish]`."""

from __future__ import annotations

import argparse
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from runtime import load_model, simulate
from runtime.model import Model
from runtime.operating.mode_solver import State
from runtime.schemes.catalogue import scheme_kind
from runtime.schemes.stepper import Stepper
from runtime.studies.stability.spectra import StepSpectrum
from symgen.scenes import generated_folder

PAGE = Path(__file__).resolve().parents[2] / "docs" / "evidence" / "long-runs.md"
SUB_STEPS = 10_000_000
BLOCKS = 4
RATIOS = (1, 2, 5, 10, 20, 50, 100, 200)
FREE = {"c": 0.5, "w": 20.0, "k_L": 0.0, "zeta": 0.0}
BOUND = {**FREE, "k_L": 1.0}
FAST = 20.0 / np.sqrt(1 - 0.5**2)  # coupled frequency of the oscillators, rad/s
FOLDINGS = 12.0  # powers of e that a mode is left to grow
REST = State(0.0, np.zeros(2), np.zeros(2), np.zeros(0))


@dataclass(frozen=True)
class LongRun:
    """A scheme with its step [s] and sub-steps in a major step."""

    scheme: str
    dt: float
    m: list[int] | None
    options: dict
    sub_steps: int


LONG_RUNS = (
    LongRun("single_rate", 2.8e-5, None, {}, 1),
    LongRun("coupled", 1e-4, [4], {}, 4),
    LongRun("exponential", 1e-4, [2], {}, 4),
    LongRun("exponential", 5e-5, [2], {}, 4),
)


def long_table() -> list[list[str]]:
    """Energy error of the freely running slider-crank, relative to the largest kinetic energy, in blocks of the run."""
    model = load_model(generated_folder("flexible_slider_crank_free"))
    rows = [
        [
            "scheme",
            "step [s]",
            "motion [s]",
            "ended",
            "largest energy error",
            f"mean energy error in {BLOCKS} parts of the run",
        ]
    ]
    for run in LONG_RUNS:
        steps = SUB_STEPS // run.sub_steps
        found = simulate(
            model,
            t_end=steps * run.dt,
            dt=run.dt,
            m=run.m,
            scheme=run.scheme,
            options=run.options,
            start="quasi_static",
            samples=4000,
        )
        error = (found.total_energy - found.total_energy[0]) / found.energy["kinetic"].max()
        parts = ", ".join(f"{part.mean():.1e}" for part in np.array_split(error, BLOCKS))
        label = run.scheme + "".join(f" {name}={value}" for name, value in run.options.items())
        rows.append(
            [
                label + (f" m={run.m[0]}" if run.m else ""),
                f"{run.dt:.3g}",
                f"{found.t[-1]:.4g}",
                found.status.name,
                f"{np.abs(error).max():.1e}",
                parts,
            ]
        )
    return rows


def spectrum(model: Model, scheme: str, m: int, parameters: dict) -> StepSpectrum:
    """Of a scheme on the oscillators."""
    c = model.constants(model.parameter_vector(parameters))
    options = {"common_update": "direct"} if scheme == "printed" else {}
    return StepSpectrum(model, scheme_kind(scheme).build(scheme, model, 1.0, [m], options), c)


def ratio_table() -> list[list[str]]:
    """Spectral radius less 1 on two free oscillators at w_c dt_S = 0.2, m from 1 to 200."""
    model = load_model(generated_folder("two_oscillators"))
    schemes = ("printed", "coupled")
    rows = [["m", *schemes]]
    for m in RATIOS:
        radii = (spectrum(model, scheme, m, FREE)(REST, 0.2 * m / FAST).radius - 1 for scheme in schemes)
        rows.append([str(m), *(f"{radius:.1e}" for radius in radii)])
    return rows


def resonance_table() -> list[list[str]]:
    """Growth rates of `coupled` m=20 with a slow spring, major steps at and between multiples of pi / w_c."""
    model, m = load_model(generated_folder("two_oscillators")), 20
    steps = spectrum(model, "coupled", m, BOUND)
    rows = [["w_c dt_L / pi", "predicted growth [1/s]", "measured in a run [1/s]"]]
    for part in (0.25, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0):
        dt = part * np.pi / FAST
        predicted = float(np.max(steps(REST, dt).growth))
        rows.append([f"{part:g}", f"{predicted:.3g}", f"{_measured(model, m, dt, FOLDINGS / predicted):.3g}"])
    return rows


def _measured(model: Model, m: int, dt: float, t_end: float) -> float:
    """Growth rate in a run without the checks of `simulate`, which would end it once its energy has grown by half."""
    stepper = Stepper(scheme_kind("coupled").build("coupled", model, dt, [m], {}))
    c, x = model.constants(model.parameter_vector(BOUND)), stepper.scheme.layout.slice("x")
    z, ready = stepper.start(0.0, np.array([0.1, 0.1]), np.zeros(2), c, dt), stepper.ready(c, dt)
    every = max(1, round(t_end / dt / 8000))
    samples = []
    for _ in range(int(t_end / dt / every)):
        stepper.run(z, ready, every)
        samples.append(z[x].copy())
    return _growth(np.arange(len(samples)) * every * dt, np.array(samples))


def _growth(t: np.ndarray, q: np.ndarray) -> float:
    """Slope of the logarithm of the largest amplitude in windows of the last third."""
    half = 2 * len(t) // 3
    size, time = np.abs(q[half:]).max(axis=1), t[half:]
    parts = [
        (np.log(chunk.max()), place.mean())
        for chunk, place in zip(np.array_split(size, 8), np.array_split(time, 8), strict=True)
    ]
    logs, places = np.array(parts).T
    return float(np.polyfit(places, logs, 1)[0])


def page() -> str:
    """The tables with what they say."""
    return (
        "\n\n".join(
            [
                "# Long runs, large m, resonances",
                "`python -m benchmarks.pages.long_runs --publish` writes this page.",
                "## Ten million sub-steps of an undamped mechanism",
                str(long_table.__doc__),
                _markdown(long_table()),
                "## m from 1 to 200",
                str(ratio_table.__doc__),
                _markdown(ratio_table()),
                "## Steps on a resonance",
                str(resonance_table.__doc__),
                _markdown(resonance_table()),
            ]
        )
        + "\n"
    )


def _markdown(rows: list[list[str]]) -> str:
    lines = [rows[0], ["---"] * len(rows[0]), *rows[1:]]
    return "\n".join(f"| {' | '.join(row)} |" for row in lines)


def main(arguments: list[str] | None = None) -> int:
    """Print the page, or write it."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.pages.long_runs", description=__doc__)
    parser.add_argument("--publish", action="store_true", help="write docs/evidence/long-runs.md")
    text = page()
    if parser.parse_args(arguments).publish:
        PAGE.write_text(text, encoding="utf-8")
    print(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())

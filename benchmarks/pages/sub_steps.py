"""Where sub-steps pay, as a figure: `python -m benchmarks.pages.sub_steps` writes docs/images/sub_steps.png.

Arms of N links, the last one flexible, 0.5 s to 1e-3 in every link angle: time of central difference over that of a
scheme, over N and over the frequency of the fastest mode. Both starts: straight at -1.2 rad, where links far from the
ground hardly move, and bent by 0.5 rad, where all of them do.
"""

from __future__ import annotations

import sys
from math import ceil
from pathlib import Path

import matplotlib.pyplot as plt

from benchmarks.cases.arms import EXPLICIT_REACH, FASTEST, T_END, TOLERANCE, arm_reference
from benchmarks.harness.fewest import Timed, fewest
from benchmarks.harness.models import model_of, workplace
from runtime.running.ladder import Method
from runtime.studies.work_precision.reference import Reference
from symgen.scenes.arm import arm

PICTURE = Path(__file__).resolve().parents[2] / "docs" / "images" / "sub_steps.png"
LINKS, STIFFENINGS = (10, 20, 40), (1.0, 10.0, 100.0, 1000.0)
STARTS = {"straight": 0.0, "bent": 0.5}  # rad
HOLDS = (90, 125, 180, 250, 500, 1000)  # numbers of major steps from which ratios are taken
STYLES = {"straight": "-", "bent": "--"}
HELD = {"slow_accelerations": "held"}
SCHEMES = {"decoupled": "C3", "decoupled, held": "C0", "coupled": "C1", "exponential_rk4": "C2"}
Gains = dict[str, float]


def gains(links: int, stiffening: float, lively: float) -> Gains:
    """Time of `single_rate` over that of each scheme, at its best ratio."""
    fastest = FASTEST * stiffening**0.5
    with workplace() as folder:
        reference = arm_reference(model_of(arm(links, stiffening=stiffening, lively=lively), folder), fastest)
        single = _milliseconds(Method("single_rate", None, {"common_velocity": "predictor"}), reference)
        ratios = sorted({max(2, ceil(T_END * fastest / EXPLICIT_REACH / steps)) for steps in HOLDS})
        methods = {name: [Method(name, (m,)) for m in ratios] for name in ("decoupled", "coupled")}
        methods["decoupled, held"] = [Method("decoupled", (m,), HELD) for m in ratios]
        methods["exponential_rk4"] = [Method("exponential_rk4")]
        best = {name: min(_milliseconds(one, reference) for one in ones) for name, ones in methods.items()}
    found = {name: single / time for name, time in best.items()}
    print(
        links, stiffening, lively, f"single_rate {single:.3g} ms", {name: round(one, 2) for name, one in found.items()}
    )
    return found


def _milliseconds(method: Method, reference: Reference) -> float:
    best = fewest(Timed(method, reference), TOLERANCE, most=40_000)
    return best.seconds * 1e3 if best else float("inf")


def draw(over_links: dict[str, list[Gains]], over_stiffness: dict[str, list[Gains]]) -> None:
    """Both panels, each of gains by start."""
    figure, axes = plt.subplots(1, 2, figsize=(9.0, 3.8), sharey=True, layout="constrained")
    frequencies = [FASTEST * one**0.5 for one in STIFFENINGS]
    panels = ((LINKS, over_links, "links, E x 100"), (frequencies, over_stiffness, "fastest mode [rad/s], 10 links"))
    for ax, (places, found, label) in zip(axes, panels, strict=True):
        for start, ones in found.items():
            for name, color in SCHEMES.items():
                style, gain = STYLES[start], [one[name] for one in ones]
                ax.plot(places, gain, style, color=color, marker="o", markersize=4, label=f"{name}, {start}")
        ax.axhline(1.0, color="0.6", linewidth=0.8)
        ax.set(xscale="log", yscale="log", xlabel=label)
        ax.set_xticks(places, [f"{place:,.0f}" for place in places])
        ax.minorticks_off()
    axes[0].set_ylabel("time of single_rate / time")
    axes[0].legend(fontsize="xx-small", ncols=2, handlelength=4)
    figure.savefig(PICTURE, dpi=110)


def main(arguments: list[str] | None = None) -> int:
    """Measure and draw."""
    over_links = {start: [gains(n, 100.0, lively) for n in LINKS] for start, lively in STARTS.items()}
    known = dict(zip((100.0,), over_links["straight"][:1], strict=True))
    over_stiffness = {"straight": [known.get(one) or gains(10, one, 0.0) for one in STIFFENINGS]}
    draw(over_links, over_stiffness)
    return 0


if __name__ == "__main__":
    sys.exit(main())

"""Single-rate central difference, the paper's sub-cycling and other sub-stepping on two coupled oscillators (case L1).

The oscillators are coupled by inertia and not damped. Errors are taken against DOP853 at 1e-11.
"""

import math
import sys
from pathlib import Path

from matplotlib.figure import Figure

from runtime import reference_solution
from symgen.scenes import SCENES

PARAMETERS = {"c": 0.5, "k_L": 1.0, "w": 20.0, "zeta": 0.0}
T_END = 1.0
STEPS = (0.005, 0.0025, 0.00125)
RUNS = {"single_rate": None, "printed m=2": [2], "printed m=4": [4], "printed m=8": [8],
        "coupled m=4": [4], "exponential m=1": [1], "rk4": None}


def main(picture: Path | None = None) -> None:
    """Errors of x_S at the end, the observed order, and the growth of the fast amplitude."""
    model = SCENES["two_oscillators"]().model()
    exact = reference_solution(model, t_end=T_END, parameters=PARAMETERS)["x_S"][-1]
    print("error of x_S for dt_L =      " + "".join(f"{dt:<11g}" for dt in STEPS) + "order")
    curves = {}
    for label, m in RUNS.items():
        errors = curves[label] = []
        for dt in STEPS:
            run = model.simulate(t_end=T_END, dt=dt, m=m, scheme=label.split()[0], parameters=PARAMETERS)
            errors.append(abs(run["x_S"][-1] - exact))
        order = math.log2(errors[-2] / errors[-1])
        print(f"{label:29}" + "".join(f"{error:<11.2e}" for error in errors) + f"{order:.2f}")

    # without the slow spring the fast oscillation is alone: its amplitude grows as exp(sigma t)
    print("\ngrowth of the fast amplitude [1/s], dt_L = 0.005 s: measured, law 1/4 c^2 (1 - 1/m) w_c^2 dt_L")
    c, w_c, dt, m = 0.5, 20.0 / math.sqrt(1 - 0.5**2), 0.005, 4
    run = model.simulate(t_end=2.0, dt=dt, m=[m], scheme="printed", initial={"x_L": 0.0},
                         parameters={**PARAMETERS, "k_L": 0.0})
    envelope = [math.hypot(x, v / w_c) for x, v in zip(run["x_S"], run.rate("x_S"), strict=True)]
    print(f"{math.log(envelope[-1] / envelope[0]) / run.t[-1]:.4f}, {c**2 / 4 * (1 - 1 / m) * w_c**2 * dt:.4f}")
    print(run.status)
    if picture:
        ax = (figure := Figure(figsize=(8, 4), layout="constrained", dpi=120)).subplots()
        for label, errors in curves.items():
            ax.loglog(STEPS, errors, "o-", label=label)
        ax.set(xlabel="large step [s]", ylabel="error of x_S", title="two oscillators coupled by inertia")
        figure.legend(loc="outside right center", frameon=False)
        figure.savefig(picture)


if __name__ == "__main__":
    main(*map(Path, sys.argv[1:]))

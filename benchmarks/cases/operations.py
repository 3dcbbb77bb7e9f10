"""Operations of M_hat and Q_hat together, as functions of (q_i, q_d, q_i_dot, q_d_dot, c)."""

from __future__ import annotations

from benchmarks.cases.scenes import general_rod, pinned_rod, slider_crank
from benchmarks.harness.models import model_of, workplace
from benchmarks.harness.result import Line, Result
from symgen.scenes.pendulums import chain

ONLY = frozenset({"condensed"})


def run() -> Result:
    """Count them; nothing is timed."""
    cases = [
        ("slider-crank, two pinned lateral modes", slider_crank(pinned_rod()), 112, ""),
        ("slider-crank, four general modes", slider_crank(general_rod()), 498, "every integral non-zero, M_ff full"),
        ("slider-crank, four orthogonal modes", slider_crank(general_rod(orthogonal=True)), 498, "M_ff, K_ff diagonal"),
        ("slider-crank, four general modes, full damping matrix", slider_crank(general_rod(damped=True)), None, ""),
        ("chain, 10 rigid links", chain(10), 428, ""),
        ("chain, 10 links with 2 modes", chain(10, 2), 2426, ""),
    ]
    lines, details = [], {}
    with workplace() as folder:
        for name, scene, goal, note in cases:
            model = model_of(scene, folder, ONLY)
            lines.append(Line(name, model.operations["condensed"], "operations", goal, note))
            details[name] = dict(model.operations)
    return Result("operations", "Operations of M_hat and Q_hat", lines, details)

"""The names of the time stepping schemes: a scene may ask for one, the runtime has them."""

from typing import Literal, get_args

SchemeName = Literal[
    "auto",
    "single_rate",
    "printed",
    "coupled",
    "decoupled",
    "linearised",
    "exponential",
    "exponential_rk4",
    "exponential_adams",
    "exponential_midpoint",
    "rk4",
    "dopri5",
    "dop853",
    "radau",
    "generalized_alpha",
    "hht",
]
SCHEME_NAMES: tuple[str, ...] = get_args(SchemeName)
# schemes with a step of its own for each group: only they need the ratios m between groups
GROUPED_SCHEMES: tuple[SchemeName, ...] = ("printed", "coupled", "decoupled")

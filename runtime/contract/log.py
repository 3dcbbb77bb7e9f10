"""What happens behind a call, by the standard `logging`: loggers below `symgen`, silent until a program asks for them.

`symgen.cache`: models and compiled programs, read, made or refused; `symgen.compile`: how long a program took;
`symgen.refinement`: each level of a tolerance; `symgen.events`: what happened in a run; `symgen.run`: how it ended.
"""

from __future__ import annotations

import logging

ROOT = "symgen"
CACHE, COMPILE, REFINEMENT, EVENTS, RUN = (
    logging.getLogger(f"{ROOT}.{part}") for part in ("cache", "compile", "refinement", "events", "run")
)
logging.getLogger(ROOT).addHandler(logging.NullHandler())

"""Functions of a scheme's states, called on arrays between steps."""

from __future__ import annotations

from collections.abc import Callable

import casadi as ca

from runtime.engine.rows import Direct
from runtime.schemes.scheme import Scheme


def direct(scheme: Scheme, name: str, build: Callable[[], ca.Function]) -> Direct:
    """A Function made of the scheme's, built once; all its outputs as one vector."""
    if name not in scheme.called:
        scheme.called[name] = Direct(scheme.derived(name, build))
    return scheme.called[name]

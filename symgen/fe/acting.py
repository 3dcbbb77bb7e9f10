"""What loads a finite-element body in a motion, with errors that name what does not fit the body."""

from __future__ import annotations

from collections.abc import Mapping

from runtime.contract.flexible import BodyMotion, UnknownInterface, causes
from symgen.fe.errors import FiniteElementError
from symgen.modes.cleaning import Array


def acting(motion: BodyMotion, nf: int, interfaces: Mapping[str, Array], size: float) -> Array:
    """(N, 9 + 9 nf + 6 interfaces) amounts of the unit causes; interfaces: name -> position (3,) [m]; size [m].

    Raises FiniteElementError for a motion of a body with other modes, and for forces at a marker that is no interface.
    """
    given = motion.q_f.shape[1]
    if given != nf:
        raise FiniteElementError("motion", f"{motion.body} has {given} modes, not {nf}", "give that body's motion")
    try:
        return causes(motion, interfaces, size)
    except UnknownInterface as error:
        raise FiniteElementError(
            f"marker '{error}'", "forces act there, but it is no interface", "name an interface at that place"
        ) from None

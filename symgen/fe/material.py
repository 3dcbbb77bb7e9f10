"""An isotropic linear elastic material."""

from __future__ import annotations

import math
from dataclasses import dataclass

from symgen.fe.errors import FiniteElementError


@dataclass(frozen=True)
class Material:
    """Young's modulus E [Pa], Poisson's ratio nu, density rho [kg/m^3].

    Raises FiniteElementError for values that no material has.
    """

    E: float
    nu: float
    rho: float

    def __post_init__(self) -> None:
        for name in ("E", "rho"):
            value = getattr(self, name)
            if not (math.isfinite(value) and value > 0.0):
                raise FiniteElementError(f"material.{name}", f"{value!r} is not a positive number", "use SI units")
        if not -1.0 < self.nu < 0.5:
            raise FiniteElementError("material.nu", f"{self.nu!r} is not between -1 and 0.5", "steel has 0.3")

    @property
    def G(self) -> float:
        """Shear modulus [Pa]."""
        return self.E / (2.0 * (1.0 + self.nu))

    @property
    def lame(self) -> float:
        """Lame's first constant [Pa]."""
        return self.E * self.nu / ((1.0 + self.nu) * (1.0 - 2.0 * self.nu))


STEEL = Material(E=2.1e11, nu=0.3, rho=7850.0)

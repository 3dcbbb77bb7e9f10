"""The integrals of a beam that bends in its plane, by the names of Eq. 20."""

from __future__ import annotations

from types import SimpleNamespace

import numpy as np

from symgen.modes.beam import BeamModes, beam_integrals


def planar_beam(lateral: BeamModes, axial: BeamModes | None) -> SimpleNamespace:
    """phi_x, ... (nf,), mass, H, ... (nf, nf), and `point`, of lateral modes and axial ones behind them."""
    data = beam_integrals(((1, lateral),) if axial is None else ((1, lateral), (0, axial)))
    across = data.pairs[:, :, 0, 1]

    def point(at: float) -> SimpleNamespace:
        one = data.point(at)
        return SimpleNamespace(shape_x=one.shape[0], shape_y=one.shape[1], slope=one.turn[2], H=one.H)

    return SimpleNamespace(
        point=point,
        nf=len(data.axes),
        i0=data.i0,
        phi_x=data.phi[0],
        phi_y=data.phi[1],
        xi_phi_x=data.x_phi[:, 0],
        xi_phi_y=data.x_phi[:, 1],
        mass=np.diag(data.mass),
        phi_cross_phi=across - across.T,
        kappa_lateral=np.diag(data.kappa[: lateral.modes]),
        kappa_axial=np.diag(data.kappa[lateral.modes :]),
        H=data.H,
        xH=data.xH,
    )
